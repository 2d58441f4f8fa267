"""names of their own

Several makers use one vendor id: a device whose documents give quite another name than the id has is shown under its
own. What is derived is made anew after every migration, and this changed: sizes are not known where PDOs are uploaded
from the device, or all that name a SyncManager with DefaultSize are virtual; nor where things lie behind missing
modules. The search knows all names of a vendor. Of other columns only comments change, which SQLite has none of.
"""

import sqlalchemy as sa
from alembic import op

revision = "0011"
down_revision = "0010"

_OWN_VENDOR_NAME = (
    "Name of its vendor in its own documents, where these give quite another one than vendors has for the id: several "
    "makers use it; else NULL"
)
_SIZE = (
    "Bytes that the master {} in the default process image; 0 = none, NULL = not known: PDOs without SyncManagers, too "
    "long for them or of a length that is not described, a SyncManager "
)
_SLOT = (
    ", or a required slot without a preset and with several ModuleIdents or a ModuleClass for modules with PDOs, with "
    "an ident of several that differ, or naming a module that is not described"
)
_BEFORE = f"{_SIZE}with DefaultSize and no PDO{_SLOT}"
_AFTER = f"{_SIZE}without PDO that has a DefaultSize or whose device uploads its PDOs (PdoUpload){_SLOT}"
_SM_BEFORE = "SyncManager of the default assignment; NULL = not assigned"
_SM_AFTER = "Sm attribute: its SyncManager; what is in the default process image is pdos.image_sm"
_PATH = "Element path"
COMMENTS: tuple[tuple[str, str, sa.types.TypeEngine[object], bool, str, str], ...] = (
    ("device_facts", "output_bytes", sa.BigInteger(), True, _BEFORE.format("writes"), _AFTER.format("writes")),
    ("device_facts", "input_bytes", sa.BigInteger(), True, _BEFORE.format("reads"), _AFTER.format("reads")),
    ("pdos", "sm", sa.BigInteger(), True, _SM_BEFORE, _SM_AFTER),
    (
        "findings",
        "path",
        sa.Text(),
        False,
        _PATH,
        f"{_PATH}; positions of repeated tags count from 0 (in XPath from 1)",
    ),
)
"""Table, column, type, whether it may be NULL, comment before and after."""


def upgrade() -> None:
    op.add_column("devices", sa.Column("own_vendor_name", sa.Text(), comment=_OWN_VENDOR_NAME))
    if op.get_context().dialect.name == "sqlite":
        return
    for table, name, column_type, is_nullable, before, after in COMMENTS:
        op.alter_column(
            table,
            name,
            existing_type=column_type,
            existing_nullable=is_nullable,
            existing_comment=before,
            comment=after,
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
