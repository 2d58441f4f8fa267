"""what descriptions imply"""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"

INTEGER = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
BOOLEAN = sa.Boolean().with_variant(sa.Integer(), "sqlite")
TEXT = sa.Text().with_variant(sa.Text(collation="C"), "postgresql")
REAL = sa.Double().with_variant(sa.REAL(), "sqlite")
BLOB = sa.LargeBinary().with_variant(sa.BLOB(), "sqlite")


def upgrade() -> None:
    op.create_table(
        "device_facts",
        sa.Column("device_id", INTEGER, autoincrement=False, nullable=False, comment="Device description"),
        sa.Column("output_bytes", INTEGER, comment="Bytes that the master writes in the default process image"),
        sa.Column("input_bytes", INTEGER, comment="Bytes that the master reads in the default process image"),
        sa.Column("dc_supported", BOOLEAN, comment="Has an OpMode with active sync unit, or TimeLoopControlOnly"),
        sa.Column("dc_needed", BOOLEAN, comment="Has OpModes, and every valid one uses distributed clocks"),
        sa.Column(
            "runs_without_dc", BOOLEAN, comment="Has an OpMode without sync unit (free run or SM synchronous), or no Dc"
        ),
        sa.Column("supports_sync0", BOOLEAN, comment="Some OpMode generates SYNC0"),
        sa.Column("supports_sync1", BOOLEAN, comment="Some OpMode generates SYNC1"),
        sa.Column(
            "uses_latch", BOOLEAN, comment="Some OpMode gives a latch unit to the slave, or uses DC time without pulses"
        ),
        sa.Column(
            "output_sync_types",
            INTEGER,
            comment="Default of 0x1C32:04, supported sync types: weak evidence, kept apart from AssignActivate",
        ),
        sa.Column("input_sync_types", INTEGER, comment="Default of 0x1C33:04, supported sync types: weak evidence"),
        sa.Column(
            "min_cycle_ns",
            INTEGER,
            comment="Smallest cycle: default of 0x1C32:05 or 0x1C33:05, or TwinCAT MinCycleTime",
        ),
        sa.Column(
            "axis_count", INTEGER, comment="Axes with CiA 402 evidence, those of modules for further slots included"
        ),
        sa.Column("has_bootstrap", BOOLEAN, comment="The EEPROM description has a bootstrap mailbox"),
        sa.Column("image_signature", TEXT, comment="Digest of the default process image: equal = same layout"),
        sa.Column("pdo_signature", TEXT, comment="Digest of all PDOs with their entries: equal = same PDO set"),
        sa.Column("fsoe", TEXT, comment="Evidence of FSoE: high or medium; not a safety statement"),
        sa.Column("fsoe_evidence", TEXT, comment="That evidence in words"),
        sa.ForeignKeyConstraint(["device_id"], ["devices.id"], name=op.f("fk_device_facts_device_id")),
        sa.PrimaryKeyConstraint("device_id", name=op.f("pk_device_facts")),
        comment="What devices imply and no single element says: sizes, SYNC support, cycle, layout, safety evidence.",
        sqlite_strict=True,
    )
    with op.batch_alter_table("device_facts", schema=None) as batch_op:
        batch_op.create_index("ix_device_facts_image_signature", ["image_signature"], unique=False)

    op.create_table(
        "drive_modes",
        sa.Column("device_id", INTEGER, nullable=False, comment="Device description"),
        sa.Column("position", INTEGER, nullable=False, comment="Order: by axis and mode, from 0"),
        sa.Column("axis", INTEGER, comment="Axis, from 0"),
        sa.Column("mode", TEXT, comment="PP VL PV TQ HM IP CSP CSV CST CSTCA, or another drive system's name for it"),
        sa.Column("kind", TEXT, comment="CiA 402; MDP 742 (motion terminals with modes of their own); SoE"),
        sa.Column("verdict", TEXT, comment="yes, likely, possible, no or unknown"),
        sa.Column("score", REAL, comment="Weight of the best evidence, 0 to 1"),
        sa.Column("conflict", BOOLEAN, comment="The description contradicts itself about this mode"),
        sa.Column("evidence", TEXT, comment="The best evidence in words"),
        sa.Column("module_ident", INTEGER, comment="Module to plug; NULL when none is needed"),
        sa.Column("module_is_default", BOOLEAN, comment="Whether that module is the default one"),
        sa.Column("rx_pdo_index", INTEGER, comment="RxPDO that maps the setpoint"),
        sa.Column("rx_pdo_is_default", BOOLEAN, comment="Whether that RxPDO is assigned by default"),
        sa.Column("op_mode", TEXT, comment="OpMode of the distributed clocks to choose"),
        sa.Column("recipe", TEXT, comment="What to plug, assign, choose and write, in words"),
        sa.ForeignKeyConstraint(["device_id"], ["devices.id"], name=op.f("fk_drive_modes_device_id")),
        sa.PrimaryKeyConstraint("device_id", "position", name=op.f("pk_drive_modes")),
        comment="Which drive modes a device can run, as far as its description tells: verdict and recipe per axis and mode.",
        sqlite_strict=True,
        sqlite_with_rowid=False,
    )
    with op.batch_alter_table("drive_modes", schema=None) as batch_op:
        batch_op.create_index("ix_drive_modes_mode_verdict", ["mode", "verdict"], unique=False)

    op.create_table(
        "mode_evidence",
        sa.Column("device_id", INTEGER, nullable=False, comment="Device description"),
        sa.Column("position", INTEGER, nullable=False, comment="Order of finding, from 0"),
        sa.Column("axis", INTEGER, comment="Axis, from 0: its objects lie at axis * 0x800 above the first one's"),
        sa.Column("module_ident", INTEGER, comment="Module that it rests on; NULL for the device itself"),
        sa.Column("mode", TEXT, comment="PP VL PV TQ HM IP CSP CSV CST CSTCA; NULL where no single mode is meant"),
        sa.Column("rank", TEXT, comment="Kind of evidence, A+ to F; see docs/drive-modes.md"),
        sa.Column("wording", TEXT, comment="What it is: declared in ESI, configured by InitCmd, named, inferred …"),
        sa.Column("score", REAL, comment="Weight of the evidence, 0 to 1"),
        sa.Column("polarity", TEXT, comment="yes: speaks for the mode, no: against it"),
        sa.Column("conflict", BOOLEAN, comment="Contradicts something else in the description"),
        sa.Column("object_index", INTEGER, comment="Object that it rests on"),
        sa.Column("pdo_index", INTEGER, comment="PDO that it rests on"),
        sa.Column("evidence", TEXT, comment="The finding in words"),
        sa.ForeignKeyConstraint(["device_id"], ["devices.id"], name=op.f("fk_mode_evidence_device_id")),
        sa.PrimaryKeyConstraint("device_id", "position", name=op.f("pk_mode_evidence")),
        comment="Every single finding about a drive mode, for and against; docs/drive-modes.md explains the ranks.",
        sqlite_strict=True,
        sqlite_with_rowid=False,
    )
    with op.batch_alter_table("devices", schema=None) as batch_op:
        batch_op.add_column(
            sa.Column(
                "hidden",
                BOOLEAN,
                server_default="0",
                nullable=False,
                comment="1 when another description of the vendor supersedes it (HideType)",
            )
        )

    with op.batch_alter_table("pdo_entries", schema=None) as batch_op:
        batch_op.add_column(
            sa.Column(
                "image_bit_offset",
                INTEGER,
                comment="Bits before it in its SyncManager's default process image; NULL = not in it",
            )
        )

    with op.batch_alter_table("pdos", schema=None) as batch_op:
        batch_op.add_column(
            sa.Column(
                "image_sm",
                INTEGER,
                comment="SyncManager of the PDO in the device's default process image; NULL = not in it",
            )
        )


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
