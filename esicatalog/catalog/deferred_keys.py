"""Foreign keys on a server: a load into an empty catalog drops them, and whoever ends next puts them back.

PostgreSQL looks up the parent of every row by itself, which takes it twice as long as all else that it does in a load;
to check a whole table takes a twentieth of that. The transaction that drops the keys says so in the catalog: whatever
becomes of the load, the next one that ends puts them back. Until then other loads go without them, too.
"""

from collections.abc import Iterator

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.state import read_state, write_state
from esicatalog.catalog.turns import take_turn
from esicatalog.errors import CatalogError

_KEYS_PENDING = "keys_pending"
_LOCK_MS = 500
"""For those who read a catalog that is empty; less than a server takes to see a deadlock (1 s)."""


def drop_keys(connection: sa.Connection) -> None:
    """Drop all foreign keys if the catalog is empty, and if nobody who reads it or owns its tables is in the way."""
    take_turn(connection)
    if is_empty(connection) and not are_keys_pending(connection):
        try:
            connection.exec_driver_sql(f"SET LOCAL lock_timeout = {_LOCK_MS}")
            for key in _foreign_keys():
                connection.exec_driver_sql(f"ALTER TABLE {key.table.name} DROP CONSTRAINT IF EXISTS {key.name}")
            write_state(connection, _KEYS_PENDING, "1")
        except (sa.exc.OperationalError, sa.exc.ProgrammingError):
            connection.rollback()
    connection.commit()


def restore_keys(connection: sa.Connection) -> None:
    """Put back the foreign keys that are dropped.

    Only the owner of the tables can: a load of somebody else leaves that to the next one of the owner. Raises
    :class:`CatalogError` when rows refer to rows that are missing.
    """
    if not are_keys_pending(connection):
        return
    connection.commit()
    take_turn(connection)
    if are_keys_pending(connection):
        try:
            for key in _foreign_keys():
                _add(connection, key)
            write_state(connection, _KEYS_PENDING, None)
        except sa.exc.ProgrammingError:
            connection.rollback()
    connection.commit()


def _add(connection: sa.Connection, key: sa.ForeignKeyConstraint) -> None:
    table, parent = key.table.name, key.referred_table.name
    columns, targets = ", ".join(key.column_keys), ", ".join(element.column.name for element in key.elements)
    try:
        connection.exec_driver_sql(
            f"ALTER TABLE {table} ADD CONSTRAINT {key.name} FOREIGN KEY ({columns}) REFERENCES {parent} ({targets})"
        )
    except sa.exc.IntegrityError as error:
        raise broken_reference(table, parent) from error


def are_keys_pending(connection: sa.Connection) -> bool:
    """Whether foreign keys are dropped."""
    return read_state(connection, _KEYS_PENDING) is not None


def is_empty(connection: sa.Connection) -> bool:
    """Whether no document was ever given to the catalog."""
    return connection.execute(sa.select(schema.sources.c.id).limit(1)).first() is None


def broken_reference(table: str, parent: str) -> CatalogError:
    """What to say of rows that refer to rows that are missing."""
    return CatalogError(f"rows of {table} refer to rows of {parent} that are missing; ingest into a new catalog")


def _foreign_keys() -> Iterator[sa.ForeignKeyConstraint]:
    for table in schema.metadata.sorted_tables:
        yield from sorted(table.foreign_key_constraints, key=lambda key: str(key.name))
