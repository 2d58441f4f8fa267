"""what the search knows

No table changes; what is derived is made anew after every migration, and this changed: the search knows all names of a
vendor, in every language, whichever version of 0011 made it; makers who use one vendor id have a row each in
drive_modes_by_vendor; drive modes of a number in 0x6502 whose bytes are swapped; sync signals of an AssignActivate that
its registers cannot hold are not known.
"""

revision = "0012"
down_revision = "0011"


def upgrade() -> None:
    """Views, search and derived rows are made anew without it."""


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
