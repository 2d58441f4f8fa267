"""places that are not known

Views and what is derived are made anew after every migration, and this changed: sizes and places behind PDOs of unknown
length, layouts of process images, recipes of drive modes, hidden revisions, the smallest cycle, bootstrap mailboxes.
Of the tables only comments change, which SQLite has none of.
"""

import sqlalchemy as sa
from alembic import op

revision = "0007"
down_revision = "0006"

_SIZE = "Bytes that the master {} in the default process image; 0 = none, NULL = "
_BEFORE = _SIZE + "PDOs without SyncManagers or too long for them"
_AFTER = _SIZE + (
    "not known: PDOs without SyncManagers, too long for them or of a length that is not described, or a SyncManager "
    "with DefaultSize and no PDO"
)
_SIGNATURE = "Digest of the default process image: equal = same layout"
_OFFSET = "Bits before it in its SyncManager's default process image; NULL = not in it"
COMMENTS: tuple[tuple[str, str, sa.types.TypeEngine[object], str, str], ...] = (
    ("device_facts", "output_bytes", sa.BigInteger(), _BEFORE.format("writes"), _AFTER.format("writes")),
    ("device_facts", "input_bytes", sa.BigInteger(), _BEFORE.format("reads"), _AFTER.format("reads")),
    ("device_facts", "image_signature", sa.Text(), _SIGNATURE, _SIGNATURE + ", as far as it is described"),
    ("pdo_entries", "image_bit_offset", sa.BigInteger(), _OFFSET, _OFFSET + " or not known"),
)


def upgrade() -> None:
    if op.get_context().dialect.name == "sqlite":
        return
    for table, name, column_type, before, after in COMMENTS:
        op.alter_column(
            table, name, existing_type=column_type, existing_nullable=True, existing_comment=before, comment=after
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
