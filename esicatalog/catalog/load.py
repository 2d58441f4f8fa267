"""Loading many documents: indexes are built after a load into an empty catalog; a killed load is repaired.

While documents are added SQLite keeps a write-ahead log (readers go on reading); a finished ingest leaves a single
file that can be copied.
"""

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.settle import CONTENT_HASH, content_hash, read_state, write_state
from esicatalog.catalog.turns import take_turn
from esicatalog.errors import CatalogError

_INDEXES_PENDING = "indexes_pending"
_CACHE_KB = 32_768
_USED_WHILE_LOADING = frozenset(
    {
        ("device_sources", "device_id"),
        ("device_names", "device_id"),
        ("hidden_revisions", "device_id"),
        ("source_vendors", "vendor_id"),
        ("vendor_names", "vendor_id"),
    }
)
"""Every commit looks things up by these."""


def prepare_load(connection: sa.Connection) -> None:
    """Get ready to write: repair what a killed load left, drop indexes when the catalog is empty."""
    is_empty = connection.execute(sa.select(schema.sources.c.id).limit(1)).first() is None
    connection.commit()
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql(f"PRAGMA journal_mode = {'DELETE' if is_empty else 'WAL'}")
        # A catalog that is being made has nothing to lose yet; it is written through at the end.
        connection.exec_driver_sql(f"PRAGMA synchronous = {'OFF' if is_empty else 'NORMAL'}")
        connection.exec_driver_sql(f"PRAGMA cache_size = -{_CACHE_KB}")
        connection.commit()
    if read_state(connection, _INDEXES_PENDING):
        _check_foreign_keys(connection)
        _create_indexes(connection)
    # A server's catalog may have others loading into it: it keeps its indexes and checks every key.
    if is_empty and connection.dialect.name == "sqlite":
        write_state(connection, _INDEXES_PENDING, "1")
        for index in secondary_indexes():
            if (index.table.name, index.columns[0].name) not in _USED_WHILE_LOADING:  # type: ignore[union-attr]
                connection.execute(sa.schema.DropIndex(index, if_exists=True))
    connection.commit()
    if is_empty:
        _enforce_foreign_keys(connection, False)


def is_unfinished(connection: sa.Connection) -> bool:
    """Whether a load into an empty catalog was cut short before its indexes were built."""
    return read_state(connection, _INDEXES_PENDING) is not None


def finish_load(connection: sa.Connection, changed: bool) -> None:
    """Build what is missing, store the content hash."""
    if read_state(connection, _INDEXES_PENDING):
        _check_foreign_keys(connection)
        _create_indexes(connection)
    connection.commit()
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql("PRAGMA synchronous = FULL")
    if changed or read_state(connection, CONTENT_HASH) is None:
        take_turn(connection)
        write_state(connection, CONTENT_HASH, content_hash(connection))
        connection.commit()
        if connection.dialect.name == "sqlite":
            connection.exec_driver_sql("PRAGMA optimize")
    connection.commit()


def end_load(connection: sa.Connection) -> None:
    """Whatever became of the load: roll back what was not committed, enforce foreign keys again, leave one file."""
    connection.rollback()
    _enforce_foreign_keys(connection, True)
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.exec_driver_sql("PRAGMA journal_mode = DELETE")
        connection.commit()


def _enforce_foreign_keys(connection: sa.Connection, enforce: bool) -> None:
    """A load into an empty catalog checks all keys once at its end, in a tenth of the time."""
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql(f"PRAGMA foreign_keys = {'ON' if enforce else 'OFF'}")
        connection.commit()


def _check_foreign_keys(connection: sa.Connection) -> None:
    if connection.dialect.name != "sqlite":
        return
    broken = connection.exec_driver_sql("PRAGMA foreign_key_check").first()
    if broken is not None:
        table, _, missing, _ = broken
        raise CatalogError(f"rows of {table} refer to rows of {missing} that are missing; ingest into a new catalog")


def secondary_indexes() -> list[sa.Index]:
    """Indexes that storing documents can do without."""
    return [index for table in schema.metadata.sorted_tables for index in table.indexes]


def _create_indexes(connection: sa.Connection) -> None:
    for index in secondary_indexes():
        connection.execute(sa.schema.CreateIndex(index, if_not_exists=True))
    write_state(connection, _INDEXES_PENDING, None)
    connection.commit()
