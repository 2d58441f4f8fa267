"""Bulk load through COPY, as PostgreSQL and what is compatible with it take it."""

from collections.abc import Callable, Iterable, Sequence
from itertools import count
from typing import Any, ClassVar

import msgspec
import sqlalchemy as sa

from esicatalog.catalog.inserts import Links, Part
from esicatalog.catalog.shared import Row

_numbers = msgspec.json.Decoder(list[int]).decode


class CopyInserts:
    """Inserts on one connection; ``take_ids`` reserves so many row numbers of a table and gives the first."""

    batch_rows: ClassVar[int] = 50_000

    def __init__(self, connection: sa.Connection, take_ids: Callable[[str, int], int]) -> None:
        self._connection = connection
        self._take_ids = take_ids
        self._held: dict[int, dict[str, list[Row]]] = {}

    def rows(self, table: sa.Table, rows: Iterable[Row]) -> None:
        """Add complete rows (all columns in the order of the table).

        Raises :class:`sqlalchemy.exc.DBAPIError`, as any other statement does.
        """
        statement = f"COPY {table.name} ({', '.join(column.name for column in table.columns)}) FROM STDIN"
        driver: Any = self._connection.connection.dbapi_connection
        dbapi: Any = self._connection.dialect.loaded_dbapi
        try:
            with driver.cursor() as cursor, cursor.copy(statement) as copy:
                for row in rows:
                    copy.write_row(row)
        except dbapi.Error as error:
            raise sa.exc.DBAPIError(statement, None, error) from error

    def links(self, table: sa.Table, links: Sequence[Links]) -> None:
        """Add links."""
        self.rows(table, ((owner, *link) for owner, targets in links for link in enumerate(targets)))

    def hold(self, table: sa.Table, maker: int, rows: Sequence[Row]) -> None:
        """Keep shared rows of a table; their numbers go on from those that are kept."""
        self._held.setdefault(maker, {}).setdefault(table.name, []).extend(rows)

    def forget(self, maker: int) -> None:
        """Drop the shared rows of a maker."""
        self._held.pop(maker, None)

    def parts(self, table: sa.Table, parts: Sequence[Part]) -> None:
        """Add what shared rows stand for."""
        named = [(parent, self._held[maker][table.name], _numbers(numbers)) for parent, maker, numbers in parts]
        # Nothing can be asked while rows are being copied.
        ids = count(self._take_ids(table.name, sum(len(numbers) for _, _, numbers in named)))
        self.rows(
            table,
            (
                (next(ids), parent, position, *held[number])
                for parent, held, numbers in named
                for position, number in enumerate(numbers)
            ),
        )
