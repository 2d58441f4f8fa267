"""Digests of what a catalog holds beside the descriptions, which catalogs of the same schema version have to share.

Views, derived rows and search rows are stored, and made anew only when the version of the schema changes: with them
that version has to change, too.
"""

import hashlib
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import sqlalchemy as sa

from esicatalog import Catalog
from esicatalog.catalog import database, word_search
from esicatalog.catalog.full_text import search_table
from esicatalog.catalog.schema import (
    SCHEMA_VERSION,
    device_facts,
    devices,
    drive_modes,
    mode_evidence,
    pdo_entries,
    pdos,
)
from esicatalog.catalog.views import FULL_TEXT, views

ROOT = Path(__file__).parent.parent
DERIVED = "tests/catalogs/derived.txt"
_DOCUMENTS = ("data", "tests/derived")
_GIVEN = ("schema", "documents")
"""Lines that say of what the others are the digests."""
_KEYS = ("id", "device_id")
_IDENTITY = (devices.c.vendor_id, devices.c.product_code, devices.c.revision_no, devices.c.variant, devices.c.type)
_QUERIES: dict[str, sa.Select[Any]] = {
    "devices": sa.select(*_IDENTITY, devices.c.hidden, devices.c.own_vendor_name),
    **{
        table.name: sa.select(*_IDENTITY, *[column for column in table.c if column.name not in _KEYS]).join_from(
            devices, table
        )
        for table in (device_facts, drive_modes, mode_evidence)
    },
    "pdos": sa.select(*_IDENTITY, pdos.c.direction, pdos.c.position, pdos.c.image_sm).join_from(devices, pdos),
    "pdo_entries": sa.select(
        *_IDENTITY, pdos.c.direction, pdos.c.position, pdo_entries.c.position, pdo_entries.c.image_bit_offset
    )
    .join_from(devices, pdos)
    .join(pdo_entries),
}


def derived() -> str:
    """The text of tests/catalogs/derived.txt: the version of the schema, and a line for each thing that is digested."""
    return "".join(f"{name} {value}\n" for name, value in _lines())


def forgotten_version(before: str, now: str) -> str | None:
    """What to do where other things than the version and the documents differ in this text; None where none do."""
    old, new = (dict(line.rsplit(" ", 1) for line in text.splitlines()) for text in (before, now))
    changed = sorted(name for name in old.keys() | new.keys() if old.get(name) != new.get(name))
    if not changed or not set(_GIVEN).isdisjoint(changed):
        return None
    return (
        f"{DERIVED}: changed under schema {new['schema']}: {', '.join(changed)}. Catalogs of that schema keep what "
        "they hold: make a new one (CONTRIBUTING.md, 'Change a view or what is derived'). If no release has this "
        "schema yet, delete the file and run: python docs/generate.py"
    )


def _lines() -> Iterator[tuple[str, str]]:
    documents = sorted(path for folder in _DOCUMENTS for path in (ROOT / folder).glob("*.xml"))
    yield "schema", SCHEMA_VERSION
    yield "documents", _digest(path.read_bytes() for path in documents)
    for sqlite, postgresql in zip(views("sqlite"), views("postgresql"), strict=True):
        yield f"view {sqlite.name}", _digest([sqlite.select.encode(), postgresql.select.encode()])
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "catalog.db"
        engine = database.make_engine(database.catalog_url(file))
        database.upgrade(engine)  # What new catalogs are made of is written beside this, and may be that of before.
        with Catalog.open(file) as catalog:
            catalog.ingest(documents, jobs=1)
        with engine.connect() as connection:
            for name, query in _QUERIES.items():
                yield f"rows of {name}", _rows_digest(connection.execute(query))
            words = [tuple(row) for row in connection.execute(sa.select(search_table(connection)))]
            for kind, found in (("FTS5", words), ("other", word_search.table_rows(words))):
                yield f"rows of {FULL_TEXT}, {kind}", _rows_digest(row[1:] for row in found)
        engine.dispose()


def _rows_digest(rows: Iterable[Iterable[Any]]) -> str:
    return _digest(sorted(repr(tuple(row)).encode() for row in rows))


def _digest(parts: Iterable[bytes]) -> str:
    hashed = hashlib.sha256()
    for part in parts:
        hashed.update(hashlib.sha256(part).digest())
    return hashed.hexdigest()[:16]
