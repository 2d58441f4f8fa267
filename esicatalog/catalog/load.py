"""Loading many documents: indexes are built late in a load into a new catalog; a killed load is repaired.

A server keeps its indexes, which cost it less than they spare several that load at once, and checks foreign keys last.

While documents are added SQLite keeps a write-ahead log (readers go on reading). A finished ingest leaves a single
file that can be copied; where others have it open, the log stays beside it until an ingest ends that finds nobody else
there. Everything is in the file even then, unless somebody is reading at that moment: what they read must stay in it,
so that what is newer is in the log alone.
"""

import sqlite3
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.deferred_keys import broken_reference, drop_keys, is_empty, restore_keys
from esicatalog.catalog.state import CONTENT_HASH, read_state, store_hashes, write_state
from esicatalog.catalog.turns import take_turn

_INDEXES_PENDING = "indexes_pending"
_CACHE_KB = 32_768
_READERS_SECONDS = 60.0
"""How long readers are waited for that began before there was a log: a snapshot of a large catalog takes that long."""
_ATTEMPT_SECONDS = 1.0
_PAUSE_SECONDS = 0.3
_KEPT_WHILE_LOADING = frozenset(
    {
        # Every commit looks things up by these.
        ("device_sources", "device_id"),
        ("device_names", "device_id"),
        ("hidden_revisions", "device_id"),
        ("source_vendors", "vendor_id"),
        ("vendor_names", "vendor_id"),
        # These grow at their end, whatever comes: building them is no faster, and would be done by one core alone.
        ("object_entries", "object_id"),
        ("pdo_entries", "pdo_id"),
        ("pdos", "device_id"),
        ("sub_items", "data_type_id"),
    }
)
"""Indexes of a new catalog that are not put off while it is filled: table and first column."""


def prepare_load(connection: sa.Connection, changes: bool = True) -> None:
    """Get ready to write: repair what a killed load left, put off what a load into a new catalog does late.

    Without ``changes`` a complete catalog is left as it is, whoever is reading it.
    """
    fills_empty = is_empty(connection)
    was_filled = read_state(connection, CONTENT_HASH) is not None
    connection.commit()
    if was_filled and not changes:
        return
    if connection.dialect.name == "sqlite":
        # Who has a catalog open that was emptied goes on reading it; of a new one there is nothing to read.
        _prepare_file(connection, fills_empty and not was_filled)
    elif fills_empty:
        drop_keys(connection)


def _prepare_file(connection: sa.Connection, is_new: bool) -> None:
    if is_new:
        _end_log(connection)
    else:
        begin_log(connection)
    connection.exec_driver_sql(f"PRAGMA cache_size = -{_CACHE_KB}")
    connection.commit()
    finish_indexes(connection)
    # A catalog that is being made has nothing to lose yet; it is written through with its indexes.
    connection.exec_driver_sql(f"PRAGMA synchronous = {'OFF' if is_new else 'NORMAL'}")
    connection.commit()
    if is_new:
        write_state(connection, _INDEXES_PENDING, "1")
        for index in secondary_indexes():
            if (index.table.name, index.columns[0].name) not in _KEPT_WHILE_LOADING:  # type: ignore[union-attr]
                connection.execute(sa.schema.DropIndex(index, if_exists=True))
    connection.commit()
    if is_new:
        _enforce_foreign_keys(connection, False)


def are_indexes_pending(connection: sa.Connection) -> bool:
    """Whether a load into an empty SQLite file was cut short before its end, or has not come there yet."""
    return read_state(connection, _INDEXES_PENDING) is not None


def finish_indexes(connection: sa.Connection) -> None:
    """Build the indexes that a load into a new SQLite file has put off, if it has; nothing may be left to commit.

    Foreign keys are checked meanwhile, and enforced from then on. Raises :class:`~esicatalog.errors.CatalogError`.
    """
    is_pending = are_indexes_pending(connection)
    connection.commit()
    if not is_pending:
        return
    # Workers go on reading while the disk takes most of the catalog; at the end everybody would wait for that.
    connection.exec_driver_sql("PRAGMA synchronous = FULL")
    connection.commit()
    with _foreign_keys_checked(connection.engine):
        # Changing a row begins a transaction, which making an index does not; Python's driver commits each by itself.
        write_state(connection, _INDEXES_PENDING, None)
        for index in secondary_indexes():
            connection.execute(sa.schema.CreateIndex(index, if_not_exists=True))
    connection.commit()
    _enforce_foreign_keys(connection, True)


def finish_load(connection: sa.Connection, changed: bool) -> None:
    """Do what was put off, store the hashes."""
    finish_indexes(connection)
    restore_keys(connection)
    connection.commit()
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql("PRAGMA synchronous = FULL")
    if changed or read_state(connection, CONTENT_HASH) is None:
        take_turn(connection)
        store_hashes(connection)
        connection.commit()
        if connection.dialect.name == "sqlite":
            # By itself each table that it looks at would be written through one by one.
            connection.exec_driver_sql("BEGIN")
            connection.exec_driver_sql("PRAGMA optimize")
    connection.commit()


def end_load(connection: sa.Connection) -> bool:
    """Whatever became of the load: roll back what was not committed, enforce foreign keys again, leave one file.

    Returns whether all is in that file, for what others were reading was not in the way.
    """
    connection.rollback()
    _enforce_foreign_keys(connection, True)
    if connection.dialect.name != "sqlite":
        return True
    is_busy, *_ = connection.exec_driver_sql("PRAGMA wal_checkpoint(TRUNCATE)").one()
    _end_log(connection)
    return not is_busy


def _end_log(connection: sa.Connection) -> None:
    """Go back from the write-ahead log to a single file, unless others have it open.

    Whoever has read while there is a log holds the file until it closes it, a server for as long as it runs. Nothing
    is lost by leaving the log to them, and no reason to say that the load had failed.
    """
    _has_mode(connection, "DELETE")


def begin_log(connection: sa.Connection) -> None:
    """Go over to the write-ahead log, waiting for those who have begun to read without it.

    While SQLite waits for them it lets nobody else begin, so it is asked again and again for a short time.
    """
    (timeout_ms,) = connection.exec_driver_sql("PRAGMA busy_timeout").one()
    connection.exec_driver_sql(f"PRAGMA busy_timeout = {_ATTEMPT_SECONDS * 1000:.0f}")
    until = time.monotonic() + _READERS_SECONDS
    while not _has_mode(connection, "WAL", must_be=time.monotonic() > until):
        time.sleep(_PAUSE_SECONDS)
    connection.exec_driver_sql(f"PRAGMA busy_timeout = {timeout_ms}")
    connection.commit()


def _has_mode(connection: sa.Connection, mode: str, must_be: bool = False) -> bool:
    """Change the journal's mode; whether others did not keep it from that, which is an error if it ``must_be``."""
    try:
        connection.exec_driver_sql(f"PRAGMA journal_mode = {mode}")
    except sa.exc.OperationalError as error:
        if must_be or getattr(error.orig, "sqlite_errorcode", None) != sqlite3.SQLITE_BUSY:
            raise
        connection.rollback()
        return False
    connection.commit()
    return True


def _enforce_foreign_keys(connection: sa.Connection, enforce: bool) -> None:
    """A load into a new catalog checks all keys at once, in a tenth of the time."""
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql(f"PRAGMA foreign_keys = {'ON' if enforce else 'OFF'}")
        connection.commit()


@contextmanager
def _foreign_keys_checked(engine: sa.Engine) -> Iterator[None]:
    """Check what is committed beside what is done meanwhile.

    Raises :class:`~esicatalog.errors.CatalogError` at its end; nothing may be committed before.
    """
    with ThreadPoolExecutor(1) as executor:
        checking = executor.submit(_check_foreign_keys, engine)
        yield
        checking.result()


def _check_foreign_keys(engine: sa.Engine) -> None:
    with engine.connect() as connection:
        connection.detach()  # In the pool it would keep others from changing the journal's mode.
        broken = connection.exec_driver_sql("PRAGMA foreign_key_check").first()
    if broken is not None:
        table, _, missing, _ = broken
        raise broken_reference(table, missing)


def secondary_indexes() -> list[sa.Index]:
    """Indexes that storing documents can do without."""
    return [index for table in schema.metadata.sorted_tables for index in table.indexes]
