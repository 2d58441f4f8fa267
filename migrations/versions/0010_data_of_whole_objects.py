"""data of whole objects

Views and what is derived are made anew after every migration, and this changed: documents that carry a description
twice count once in views, sizes are not known where a required slot names a module that is not described, axes of SoE
drives. Entries of objects with data of the whole object get their parts when the documents are read again. Of the
tables only comments change, which SQLite has none of.
"""

import sqlalchemy as sa
from alembic import op

revision = "0010"
down_revision = "0009"

_SIZE = (
    "Bytes that the master {} in the default process image; 0 = none, NULL = not known: PDOs without SyncManagers, too "
    "long for them or of a length that is not described, a SyncManager with DefaultSize and no PDO, or a required slot "
    "without a preset and with several ModuleIdents or a ModuleClass for modules with PDOs, with an ident of several "
    "that differ, or "
)
_BEFORE = _SIZE + "of none that is described"
_AFTER = _SIZE + "naming a module that is not described"
_RAW = "Default as written"
COMMENTS: tuple[tuple[str, str, sa.types.TypeEngine[object], str, str], ...] = (
    ("device_facts", "output_bytes", sa.BigInteger(), _BEFORE.format("writes"), _AFTER.format("writes")),
    ("device_facts", "input_bytes", sa.BigInteger(), _BEFORE.format("reads"), _AFTER.format("reads")),
    ("object_entries", "default_raw", sa.Text(), _RAW, f"{_RAW}; else its part of the data of the whole object"),
)
"""Table, column, type, comment before and after."""


def upgrade() -> None:
    if op.get_context().dialect.name == "sqlite":
        return
    for table, name, column_type, before, after in COMMENTS:
        op.alter_column(
            table,
            name,
            existing_type=column_type,
            existing_nullable=True,
            existing_comment=before,
            comment=after,
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
