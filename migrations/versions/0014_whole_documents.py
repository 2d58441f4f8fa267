"""which documents were read whole

Documents of before keep NULL, for not known: then those that needed recovery count as damaged. Names of vendors are
counted again, by documents and not by vendor sections. Comments on virtual PDOs and SyncManagers say what holds.
"""

import sqlalchemy as sa
from alembic import op

revision = "0014"
down_revision = "0013"

BOOLEAN = sa.Boolean().with_variant(sa.Integer(), "sqlite")
COMMENTS = (
    ("pdos", "virtual", "Not transported by mapping objects", "No mapping object transports it; an FMMU may"),
    ("sync_managers", "virtual", "Not a real SyncManager", "No SyncManager register is programmed for it"),
)
"""Table, column, comment before and after."""


def upgrade() -> None:
    op.add_column(
        "sources",
        sa.Column(
            "is_whole",
            BOOLEAN,
            comment="1 when it and all that it pulls in were read whole, 0 when elements may be lost (broken markup); "
            "NULL when it was not stored, or by a version that did not tell",
        ),
    )
    if op.get_context().dialect.name == "sqlite":
        return
    for table, name, before, after in COMMENTS:
        op.alter_column(
            table, name, existing_type=sa.Boolean(), existing_nullable=True, existing_comment=before, comment=after
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
