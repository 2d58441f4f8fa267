"""Bulk load through COPY, as PostgreSQL and what is compatible with it take it."""

from collections.abc import Iterable
from typing import Any

import sqlalchemy as sa


def copy_rows(connection: sa.Connection, table: sa.Table, rows: Iterable[tuple[Any, ...]]) -> None:
    """Add complete rows (all columns in the order of the table) within the transaction of the connection.

    Raises :class:`sqlalchemy.exc.DBAPIError`, as any other statement does.
    """
    statement = f"COPY {table.name} ({', '.join(column.name for column in table.columns)}) FROM STDIN"
    driver: Any = connection.connection.driver_connection
    dbapi: Any = connection.dialect.loaded_dbapi
    try:
        with driver.cursor() as cursor, cursor.copy(statement) as copy:
            for row in rows:
                copy.write_row(row)
    except dbapi.Error as error:
        raise sa.exc.DBAPIError(statement, None, error) from error
