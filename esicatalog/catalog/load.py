"""Loading many documents: indexes are built late in a load into a new catalog; a killed load is repaired.

A server keeps its indexes, which cost it less than they spare several that load at once, and checks foreign keys last.

While documents are added SQLite keeps a write-ahead log (readers go on reading). A finished ingest leaves a single
file that can be copied; where others have it open, the log stays beside it until an ingest ends that finds nobody else
there. Everything is in the file even then, unless somebody is reading at that moment: what they read must stay in it,
so that what is newer is in the log alone.
"""

import sqlite3
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


def prepare_load(connection: sa.Connection) -> None:
    """Get ready to write: repair what a killed load left, put off what a load into a new catalog does late."""
    fills_empty = is_empty(connection)
    was_filled = read_state(connection, CONTENT_HASH) is not None
    connection.commit()
    if connection.dialect.name == "sqlite":
        # Who has a catalog open that was emptied goes on reading it; of a new one there is nothing to read.
        _prepare_file(connection, fills_empty and not was_filled)
    elif fills_empty:
        drop_keys(connection)


def _prepare_file(connection: sa.Connection, is_new: bool) -> None:
    if is_new:
        _end_log(connection)
    else:
        connection.exec_driver_sql("PRAGMA journal_mode = WAL")
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
    try:
        connection.exec_driver_sql("PRAGMA journal_mode = DELETE")
    except sa.exc.OperationalError as error:
        if getattr(error.orig, "sqlite_errorcode", None) != sqlite3.SQLITE_BUSY:
            raise
        connection.rollback()
    connection.commit()


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
