"""which axes there are

No table changes; what is derived is made anew after every migration, and this changed: a controlword alone, outside of
RxPDOs, is no axis (encoders have their acceleration there); modes that a required module denies are denied; start-up
commands of a device and its modules are one start; of PDOs that exclude each other those of an OpMode's list stay.
"""

revision = "0013"
down_revision = "0012"


def upgrade() -> None:
    """Derived rows are made anew without it."""


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
