"""what descriptions imply, once more

Views and what is derived are made anew after every migration, and this changed: recipes of drive modes, evidence on
0x6060, the smallest cycle, the layout of images without bits, default modules of schema 1.17, mandatory PDOs beside the
list of an OpMode. No table changes.
"""

revision = "0006"
down_revision = "0005"


def upgrade() -> None:
    pass


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
