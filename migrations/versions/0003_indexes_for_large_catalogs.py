"""indexes for large catalogs"""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"

INTEGER = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
BOOLEAN = sa.Boolean().with_variant(sa.Integer(), "sqlite")
TEXT = sa.Text().with_variant(sa.Text(collation="C"), "postgresql")
REAL = sa.Double().with_variant(sa.REAL(), "sqlite")
BLOB = sa.LargeBinary().with_variant(sa.BLOB(), "sqlite")


def upgrade() -> None:
    with op.batch_alter_table("devices", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_devices_vendor_type"))
        batch_op.create_index(
            "ix_devices_listed", ["vendor_id", "product_code", "revision_no", "type", "variant", "hidden"], unique=False
        )

    with op.batch_alter_table("drive_modes", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_drive_modes_mode_verdict"))
        batch_op.create_index("ix_drive_modes_kind_mode", ["kind", "mode", "verdict"], unique=False)

    with op.batch_alter_table("object_entries", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_object_entries_object_id"))
        batch_op.create_index("ix_object_entries_subindex", ["object_id", "subindex"], unique=False)

    with op.batch_alter_table("pdo_entries", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_pdo_entries_mapped"))
        batch_op.create_index(
            "ix_pdo_entries_mapping", ["entry_index", "subindex", "bit_length", "pdo_id"], unique=False
        )

    with op.batch_alter_table("profiles", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_profiles_dictionary_id"))
        batch_op.create_index("ix_profiles_dictionary", ["dictionary_id", "device_id", "module_id"], unique=False)


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
