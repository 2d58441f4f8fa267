"""what descriptions imply, once more

Views and what is derived are made anew after every migration, and this changed: recipes of drive modes, evidence on
0x6060, the smallest cycle, the layout of images without bits, default modules of schema 1.17, mandatory PDOs beside the
list of an OpMode, PDOs in a mailbox. Of the tables only comments change, which SQLite has none of.
"""

import sqlalchemy as sa
from alembic import op

revision = "0006"
down_revision = "0005"

COMMENTS = (
    (
        "device_facts",
        "min_cycle_ns",
        "Smallest cycle: default of 0x1C32:05 or 0x1C33:05, or TwinCAT MinCycleTime",
        "Smallest bus cycle: default of 0x1C32:05 or 0x1C33:05, the larger one; else that with the preset "
        "oversampling, TwinCAT DefaultFactor times MinCycleTime",
    ),
    ("slots", "default_ident", "Default (schema 1.17)", "ModuleIdent that is preselected (schema 1.17)"),
    (
        "slots",
        "fallback_ident",
        "Fallback (schema 1.17)",
        "ModuleIdent that is plugged when no other one is (schema 1.17)",
    ),
)


def upgrade() -> None:
    if op.get_context().dialect.name == "sqlite":
        return
    for table, name, before, after in COMMENTS:
        op.alter_column(
            table,
            name,
            existing_type=sa.BigInteger(),
            existing_nullable=True,
            existing_comment=before,
            comment=after,
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
