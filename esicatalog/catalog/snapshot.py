"""Snapshots: one read-only SQLite file with all that a catalog on any engine holds, whatever the engine."""

import json
import os
import re
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.bulk import RowBuffer
from esicatalog.catalog.database import open_catalog, shown_target, shown_url, sqlite_path
from esicatalog.catalog.driver_errors import database_error
from esicatalog.catalog.full_text import index_devices
from esicatalog.catalog.inspect_data import inspect_data, inspect_path, read_inspect_data
from esicatalog.catalog.load import end_load, finish_load, prepare_load
from esicatalog.catalog.lock import is_read_only
from esicatalog.catalog.state import CONTENT_HASH, read_state, state_hash
from esicatalog.catalog.views import FULL_TEXT
from esicatalog.errors import CatalogError, InputError

HASH_PLACE = "<hash>"
"""Stands for the content hash in the name of a snapshot."""
STATE_PLACE = "<state>"
"""Stands for the first digits of the digest of what the content hash leaves out."""
_STATE_DIGITS = 16
_PLACE = re.compile("<[^<>/]*>")
_BATCH_ROWS = 10_000
_READ_ONLY = 0o444


class Snapshot(NamedTuple):
    """A snapshot: its file, the content hash, and whether it was there before."""

    path: Path
    content_hash: str
    was_there: bool


def write_snapshot(source: sa.Connection, name: str) -> Snapshot:
    """Write a snapshot of what a transaction sees; a snapshot that is there stays if it holds the same.

    The file appears under its name only when it is complete and its content hash was verified. Raises
    :class:`CatalogError` and :class:`InputError`.
    """
    if source.dialect.name == "sqlite":
        # Without it every SELECT would see what is committed by then.
        source.exec_driver_sql("BEGIN")
    expected = read_state(source, CONTENT_HASH)
    if expected is None:
        raise CatalogError(
            "nothing was ingested yet, or an ingest is under way or was cut short: wait for it or repeat it, then take "
            "the snapshot"
        )
    if "://" in name:
        raise InputError(f"{shown_target(name)}: a snapshot is a file; name one, for example catalog-{HASH_PLACE}.db")
    state = state_hash(source)
    named = name.replace(HASH_PLACE, expected).replace(STATE_PLACE, state[:_STATE_DIGITS])
    unknown = _PLACE.search(named)
    if unknown is not None:
        raise InputError(f"{name}: nothing stands for {unknown[0]}; there are {HASH_PLACE} and {STATE_PLACE}")
    path = Path(named)
    if path.is_dir():
        raise InputError(f"{path}: is a folder; name a file in it, for example {path / f'catalog-{HASH_PLACE}.db'}")
    if path.exists():
        _check_is_other_file(path, source)
        _check_same(path, expected, state)
        _check_is_snapshot(path)
        return Snapshot(path, expected, was_there=True)
    if not path.parent.is_dir():
        raise InputError(f"{path.parent}: no such folder for the snapshot")
    try:
        with tempfile.TemporaryDirectory(prefix=".snapshot-", dir=path.parent) as folder:
            unfinished = Path(folder, path.name)
            _copy(source, unfinished, expected)
            _publish(unfinished, path)
    except sa.exc.DBAPIError as error:
        raise database_error(str(path), error) from error
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}; no snapshot was made") from error
    return Snapshot(path, expected, was_there=False)


def _check_is_other_file(path: Path, source: sa.Connection) -> None:
    copied = sqlite_path(source.engine.url)
    if copied is not None and path.samefile(copied):
        raise InputError(f"{path}: is the catalog that is to be copied; name another file for the snapshot")


def _check_is_snapshot(path: Path) -> None:
    """Raise :class:`CatalogError` for a file of the same content that is a plain catalog, which may change."""
    if not is_read_only(path) or read_inspect_data(path) is None:
        lacking = f"no {inspect_path(path).name} is beside it" if is_read_only(path) else "it can be written"
        raise CatalogError(f"{path}: holds the same, but is no snapshot: {lacking}; name another file")


def _check_same(path: Path, expected: str, state: str) -> None:
    engine = open_catalog(path, read_only=True)
    try:
        with engine.connect() as connection:
            found, has_same_state = read_state(connection, CONTENT_HASH), state_hash(connection) == state
    finally:
        engine.dispose()
    if found == expected and has_same_state:
        return
    what = "the same descriptions, but other documents or what another version read"
    if found != expected:
        what = f"another catalog (content hash {found})"
    example = path.with_name(f"catalog-{HASH_PLACE}-{STATE_PLACE}.db")
    raise CatalogError(f"{path}: holds {what}; name another file, for example {example}")


def _copy(source: sa.Connection, file: Path, expected: str) -> None:
    engine = open_catalog(file, create=True)
    try:
        with engine.connect() as target:
            try:
                prepare_load(target)
                _copy_rows(source, target)
                index_devices(target, target.execute(sa.select(schema.devices.c.id)).scalars().all())
                target.exec_driver_sql(f"INSERT INTO {FULL_TEXT} ({FULL_TEXT}) VALUES ('optimize')")
                target.commit()
                finish_load(target, changed=True)
                found = read_state(target, CONTENT_HASH)
            finally:
                end_load(target)
    finally:
        engine.dispose()
    if found != expected:
        raise CatalogError(
            f"the rows have the content hash {found}, the catalog says {expected}; look at: esicatalog check"
        )


def _copy_rows(source: sa.Connection, target: sa.Connection) -> None:
    buffer = RowBuffer(target)
    for name, rows in _batches(source):
        buffer.add(name, map(tuple, rows))
        buffer.flush()


def _batches(source: sa.Connection) -> Iterator[tuple[str, Sequence[sa.Row[Any]]]]:
    """All rows by table; an error in reading them is the source's, whatever becomes of the file."""
    try:
        for table in schema.metadata.sorted_tables:
            if table is schema.catalog_state:
                continue
            query = sa.select(table).order_by(*table.primary_key.columns).execution_options(yield_per=_BATCH_ROWS)
            for rows in source.execute(query).partitions():
                yield table.name, rows
    except sa.exc.DBAPIError as error:
        raise database_error(shown_url(source.engine.url), error) from error


def _publish(unfinished: Path, path: Path) -> None:
    """Write everything through, then give the files their names: the counts first, the file last."""
    written = inspect_path(unfinished)
    written.write_text(json.dumps(inspect_data(unfinished), indent=2) + "\n", encoding="utf-8")
    for file in (written, unfinished):
        with file.open("rb") as stream:
            os.fsync(stream.fileno())
        file.chmod(_READ_ONLY)
    written.replace(inspect_path(path))
    unfinished.replace(path)
