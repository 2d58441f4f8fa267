"""what denies a mode

No table changes; what is derived is made anew after every migration, and this changed: a value of 0x6060 whose text
denies its mode is evidence against it; encoder modules (CiA 406) say nothing of a drive's modes; recipes list
the PDOs to choose, tell a mapped subindex that nobody describes, and that a read-only 0x6060 cannot be written.
"""

revision = "0015"
down_revision = "0014"


def upgrade() -> None:
    """Derived rows are made anew without it."""


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
