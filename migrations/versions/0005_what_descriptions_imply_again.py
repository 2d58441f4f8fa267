"""what descriptions imply, again

Views and what is derived are made anew after every migration, and both changed: SYNC signals of devices that use the DC
time only, PDOs in a SyncManager of the other direction, the OpMode that plugged modules ask for, drive modes. No table
changes.
"""

revision = "0005"
down_revision = "0004"


def upgrade() -> None:
    pass


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
