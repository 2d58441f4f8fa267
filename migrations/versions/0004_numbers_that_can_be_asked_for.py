"""numbers that can be asked for

Views and what is derived are made anew after every migration: what a view computes has a type now, so that Datasette,
which compares with texts, finds it; and a coupler has 0 bytes of process data, not NULL. Here only comments change,
which SQLite has none of.
"""

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0003"

SIZES = {
    "output_bytes": "Bytes that the master writes in the default process image",
    "input_bytes": "Bytes that the master reads in the default process image",
}


def upgrade() -> None:
    if op.get_context().dialect.name == "sqlite":
        return
    for name, comment in SIZES.items():
        op.alter_column(
            "device_facts",
            name,
            existing_type=sa.BigInteger(),
            existing_nullable=True,
            existing_comment=comment,
            comment=f"{comment}; 0 = none, NULL = PDOs without SyncManagers or too long for them",
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
