"""Statements as text, for what is asked by the thousand: building one from expressions takes longer than running it."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import sqlalchemy as sa

Query = Callable[[str, tuple[Any, ...]], Iterable[tuple[Any, ...]]]
"""Runs a statement with ``?`` marks and gives its rows."""


class ConnectionQuery:
    """Runs ``?`` statements within the transaction of a connection."""

    def __init__(self, connection: sa.Connection) -> None:
        self._connection = connection
        self._mark = "?" if connection.dialect.paramstyle == "qmark" else "%s"

    def __call__(self, sql: str, values: tuple[Any, ...]) -> list[tuple[Any, ...]]:
        """All rows of a statement."""
        return [tuple(row) for row in self._connection.exec_driver_sql(sql.replace("?", self._mark), values)]


def rows_of(
    query: Query, columns: str, source: str, key: str, values: Sequence[Any], order: str | None = None
) -> list[tuple[Any, ...]]:
    """The rows of a table or join whose ``key`` is one of these values."""
    if not values:
        return []
    sql = f"SELECT {columns} FROM {source} WHERE {key} IN ({', '.join('?' * len(values))})"
    return list(query(f"{sql} ORDER BY {order}" if order is not None else sql, tuple(values)))
