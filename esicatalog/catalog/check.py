"""Verifying a catalog: integrity, references, counts, variants, indexes, search, content hash."""

from collections.abc import Iterator
from typing import NamedTuple

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.check_rows import rules
from esicatalog.catalog.full_text import searched
from esicatalog.catalog.load import is_unfinished, secondary_indexes
from esicatalog.catalog.schema import devices, vendors
from esicatalog.catalog.state import CONTENT_HASH, STATE_HASH, content_hash, read_state, state_hash
from esicatalog.catalog.views import FULL_TEXT, views

CUT_SHORT = "an ingest was cut short: run it again"
"""All that there is to say of a catalog whose ingest was killed."""


class CheckResult(NamedTuple):
    """What was counted, what is wrong (empty = sound), and the recomputed content hash."""

    counts: dict[str, int]
    problems: list[str]
    content_hash: str


_COUNTED = (
    "sources",
    "vendors",
    "devices",
    "modules",
    "objects",
    "object_entries",
    "pdo_entries",
    "initcmds",
    "dc_modes",
)


def check_catalog(connection: sa.Connection) -> CheckResult:
    """Look at everything that can be verified from the rows alone."""
    problems: list[str] = []
    if connection.dialect.name == "sqlite":
        # Other databases enforce what these find.
        problems += [row[0] for row in connection.exec_driver_sql("PRAGMA integrity_check") if row[0] != "ok"]
        problems += [
            f"{table}: row {row} refers to a missing row of {parent}"
            for table, row, parent, _ in connection.exec_driver_sql("PRAGMA foreign_key_check")
        ]
        problems += _full_text_problems(connection)
    problems += _missing_parts(connection)
    for rule in rules():
        count = connection.execute(sa.select(sa.func.count()).select_from(rule.breaking.subquery())).scalar_one()
        problems += [f"{count} {rule.words}"] if count else []
    recomputed = content_hash(connection)
    problems += _load_problems(connection, recomputed)
    counts = {
        name: connection.execute(sa.select(sa.func.count()).select_from(schema.metadata.tables[name])).scalar_one()
        for name in _COUNTED
    }
    return CheckResult(counts, problems, recomputed)


def _load_problems(connection: sa.Connection, recomputed: str) -> Iterator[str]:
    stored = read_state(connection, CONTENT_HASH)
    if stored is None or is_unfinished(connection):
        yield CUT_SHORT
    elif stored != recomputed:
        yield f"the stored content hash {stored} is not that of the rows: delete the catalog and ingest again"
    elif (state := read_state(connection, STATE_HASH)) not in (None, state_hash(connection)):
        yield f"the stored state hash {state} is not that of the sources: delete the catalog and ingest again"


def _missing_parts(connection: sa.Connection) -> Iterator[str]:
    """Indexes and views; an unfinished load has dropped its indexes and builds them at its end."""
    inspector = sa.inspect(connection)
    found = set(inspector.get_view_names())
    for view in views(connection.dialect.name):
        if view.name not in found:
            yield f"the view {view.name} is missing"
    if is_unfinished(connection):
        return
    for index in secondary_indexes():
        assert index.table is not None
        if index.name not in {item["name"] for item in inspector.get_indexes(index.table.name)}:
            yield f"the index {index.name} is missing"


def _full_text_problems(connection: sa.Connection) -> Iterator[str]:
    indexed = sa.table(FULL_TEXT, sa.column("rowid"), sa.column("type"), sa.column("vendor"))
    differing = (
        sa.select(devices.c.id)
        .outerjoin(vendors, vendors.c.vendor_id == devices.c.vendor_id)
        .outerjoin(indexed, indexed.c.rowid == devices.c.id)
        .where(
            sa.or_(
                indexed.c.rowid.is_(None),
                indexed.c.type.is_distinct_from(searched(devices.c.type)),
                indexed.c.vendor.is_distinct_from(searched(vendors.c.name)),
            )
        )
    )
    missing = len(connection.execute(differing).all())
    if missing:
        yield f"{missing} devices that the full-text search does not know, or not as they are"
    left = connection.execute(
        sa.select(sa.func.count()).select_from(indexed).where(indexed.c.rowid.not_in(sa.select(devices.c.id)))
    ).scalar_one()
    if left:
        yield f"{left} devices in the full-text search that are not there"
