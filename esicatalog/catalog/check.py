"""Verifying a catalog: integrity, references, counts, variants, vendors, images, search, content hash, values."""

from collections.abc import Iterator
from typing import NamedTuple

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.check_rows import rules
from esicatalog.catalog.check_values import value_problems
from esicatalog.catalog.deferred_keys import are_keys_pending
from esicatalog.catalog.full_text import outdated_devices, search_table
from esicatalog.catalog.load import are_indexes_pending, secondary_indexes
from esicatalog.catalog.pictures import damaged_pictures
from esicatalog.catalog.schema import devices
from esicatalog.catalog.spelled_vendors import vendor_problems
from esicatalog.catalog.state import CONTENT_HASH, STATE_HASH, content_hash, read_state, state_hash
from esicatalog.catalog.unfinished import CUT_SHORT, is_unfinished
from esicatalog.catalog.views import FULL_TEXT, views

KEYS_MISSING = "foreign keys are missing: the next ingest of who owns the tables puts them back"
"""Of a complete catalog: whoever loads it need not be the owner, and running again does not help then."""
_INGEST_AGAIN = "delete the catalog and ingest again"
"""What the next ingest does not put right: it leaves documents alone that are unchanged."""


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
    """Look at everything that can be verified from the rows alone; where that is sound, read all descriptions back."""
    problems: list[str] = []
    if connection.dialect.name == "sqlite":
        # Other databases enforce what these find.
        problems += [row[0] for row in connection.exec_driver_sql("PRAGMA integrity_check") if row[0] != "ok"]
        problems += [
            f"{table}: row {row} refers to a missing row of {parent}"
            for table, row, parent, _ in connection.exec_driver_sql("PRAGMA foreign_key_check")
        ]
    problems += _missing_parts(connection)
    problems += _search_problems(connection)
    for rule in rules():
        count = connection.execute(sa.select(sa.func.count()).select_from(rule.breaking.subquery())).scalar_one()
        problems += [f"{count} {rule.words}"] if count else []
    problems += vendor_problems(connection)
    damaged = damaged_pictures(connection)
    problems += [f"{damaged} images that are not what their sha256 says: {_INGEST_AGAIN}"] if damaged else []
    recomputed = content_hash(connection)
    problems += _load_problems(connection, recomputed)
    if not problems:  # Only what hangs together can be read.
        problems += [f"{words}: {_INGEST_AGAIN}" for words in value_problems(connection)]
    counts = {
        name: connection.execute(sa.select(sa.func.count()).select_from(schema.metadata.tables[name])).scalar_one()
        for name in _COUNTED
    }
    return CheckResult(counts, problems, recomputed)


def _load_problems(connection: sa.Connection, recomputed: str) -> Iterator[str]:
    if is_unfinished(connection):
        yield CUT_SHORT
        return
    if are_keys_pending(connection):
        yield KEYS_MISSING
    stored = read_state(connection, CONTENT_HASH)
    if stored is None:  # nothing was ingested yet
        return
    if stored != recomputed:
        yield f"the stored content hash {stored} is not that of the descriptions: {_INGEST_AGAIN}"
    elif (state := read_state(connection, STATE_HASH)) not in (None, state_hash(connection)):
        yield f"the stored state hash {state} is not that of the sources: {_INGEST_AGAIN}"


def _missing_parts(connection: sa.Connection) -> Iterator[str]:
    """Indexes and views; a load that was cut short has dropped its indexes; the next one builds them."""
    inspector = sa.inspect(connection)
    found = set(inspector.get_view_names())
    for view in views(connection.dialect.name):
        if view.name not in found:
            yield f"the view {view.name} is missing"
    if are_indexes_pending(connection):
        return
    indexes = {index["name"] for held in inspector.get_multi_indexes().values() for index in held}
    for index in secondary_indexes():
        if index.name not in indexes:
            yield f"the index {index.name} is missing"


def _search_problems(connection: sa.Connection) -> Iterator[str]:
    if not sa.inspect(connection).has_table(FULL_TEXT):
        yield f"the table {FULL_TEXT} is missing, by which texts are searched"
        return
    outdated = len(outdated_devices(connection))
    if outdated:
        yield f"{outdated} devices that the full-text search does not know, or not as they are: {_INGEST_AGAIN}"
    table = search_table(connection)
    number = next(iter(table.columns))
    gone = sa.select(sa.func.count()).select_from(table).where(number.not_in(sa.select(devices.c.id)))
    left = connection.execute(gone).scalar_one()
    if left:
        yield f"{left} devices in the full-text search that are not there: {_INGEST_AGAIN}"
