"""what required modules add is not known

Views and what is derived are made anew after every migration, and this changed: sizes of devices whose required slots
are empty or whose OpModes list PDOs that are not described, layouts of process images, the view of OpModes. Of the
tables only comments change, which SQLite has none of.
"""

import sqlalchemy as sa
from alembic import op

revision = "0008"
down_revision = "0007"

_MODES = "OpModes of the distributed clocks with the SYNC signals that AssignActivate {}."
_SIZE = (
    "Bytes that the master {} in the default process image; 0 = none, NULL = not known: PDOs without SyncManagers, too "
    "long for them or of a length that is not described, "
)
_BEFORE = _SIZE + "or a SyncManager with DefaultSize and no PDO"
_AFTER = _SIZE + (
    "a SyncManager with DefaultSize and no PDO, or a required slot for which several modules with PDOs are described, "
    "or none"
)
_SYNC0, _SYNC1 = "SYNC0{}: 0x0100 and 0x0200", "SYNC1{}: 0x0100 and 0x0400"
_ASKED, _GENERATED = "AssignActivate asks for ", " is generated"
COMMENTS: tuple[tuple[str, str, sa.types.TypeEngine[object], str, str], ...] = (
    ("device_facts", "output_bytes", sa.BigInteger(), _BEFORE.format("writes"), _AFTER.format("writes")),
    ("device_facts", "input_bytes", sa.BigInteger(), _BEFORE.format("reads"), _AFTER.format("reads")),
    ("dc_modes", "sync0", sa.Boolean(), _SYNC0.format(_GENERATED), _ASKED + _SYNC0.format("")),
    ("dc_modes", "sync1", sa.Boolean(), _SYNC1.format(_GENERATED), _ASKED + _SYNC1.format("")),
)


def upgrade() -> None:
    if op.get_context().dialect.name == "sqlite":
        return
    op.create_table_comment("dc_modes", _MODES.format("asks for"), existing_comment=_MODES.format("means"))
    for table, name, column_type, before, after in COMMENTS:
        op.alter_column(
            table, name, existing_type=column_type, existing_nullable=True, existing_comment=before, comment=after
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
