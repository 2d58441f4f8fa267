"""numbers that views compute

Views and what is derived are made anew after every migration; this one changes nothing else. What a view computes has a
type now, so that Datasette, which compares with texts, finds it; a coupler has 0 bytes of process data, not NULL.
"""

revision = "0004"
down_revision = "0003"


def upgrade() -> None:
    pass


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
