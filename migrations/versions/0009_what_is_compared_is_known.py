"""what is compared is known

Views and what is derived are made anew after every migration, and this changed: axes, drive modes and clocks of some
descriptions, sizes where a preset ident is that of several modules, layouts that are only partly known (NULL in the
view of revisions), the type that counts for a PDO entry. Of the tables only comments change, which SQLite has none of.
"""

import sqlalchemy as sa
from alembic import op

revision = "0009"
down_revision = "0008"

_SIZE = (
    "Bytes that the master {} in the default process image; 0 = none, NULL = not known: PDOs without SyncManagers, too "
    "long for them or of a length that is not described, a SyncManager with DefaultSize and no PDO, or a required slot "
)
_BEFORE = _SIZE + "for which several modules with PDOs are described, or none"
_AFTER = _SIZE + (
    "without a preset and with several ModuleIdents or a ModuleClass for modules with PDOs, with an ident of several "
    "that differ, or of none that is described"
)
_LATCH = "Some OpMode gives a latch unit to the slave, or uses DC time without pulses"
COMMENTS: tuple[tuple[str, sa.types.TypeEngine[object], str, str], ...] = (
    ("output_bytes", sa.BigInteger(), _BEFORE.format("writes"), _AFTER.format("writes")),
    ("input_bytes", sa.BigInteger(), _BEFORE.format("reads"), _AFTER.format("reads")),
    (
        "pdo_signature",
        sa.Text(),
        "Digest of all PDOs with their entries: equal = same PDO set",
        "Digest of all PDOs of the device itself with their entries, those of modules left out; NULL without any",
    ),
    ("uses_latch", sa.Boolean(), _LATCH, f"{_LATCH}; not with TimeLoopControlOnly"),
)
"""Of ``device_facts``: column, type, comment before and after."""


def upgrade() -> None:
    if op.get_context().dialect.name == "sqlite":
        return
    for name, column_type, before, after in COMMENTS:
        op.alter_column(
            "device_facts",
            name,
            existing_type=column_type,
            existing_nullable=True,
            existing_comment=before,
            comment=after,
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
