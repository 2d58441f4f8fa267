"""Bulk inserts into SQLite, arranged so that Python touches little.

Python's driver spends most of its time on values. So shared rows are kept in temporary tables and put in place by
SQLite itself, and lists travel as JSON.
"""

import sqlite3
from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import Any, ClassVar

import sqlalchemy as sa

from esicatalog.catalog.inserts import SHARED_FROM, Links, Part
from esicatalog.catalog.mapping import to_json
from esicatalog.catalog.shared import Row

_MAKER_BITS = 32
"""A shared row's key: the ordinal of its maker above these bits, its number below."""

# What the driver would bind anyway: without these it looks for adapters in vain, which takes longer than binding, with
# None several times as long.
sqlite3.register_adapter(bool, int)
sqlite3.register_adapter(bytes, bytes)
sqlite3.register_adapter(type(None), dict[None, None]().get)


class SqliteInserts:
    """Inserts on one connection."""

    batch_rows: ClassVar[int] = 5_000

    def __init__(self, connection: sa.Connection) -> None:
        self._connection = connection
        self._bases: dict[int, int] = {}
        self._held: dict[tuple[str, int], int] = defaultdict(int)
        self._kept_tables: set[str] = set()

    def rows(self, table: sa.Table, rows: Sequence[Row]) -> None:
        """Add complete rows (all columns in the order of the table)."""
        self._insert(table.name, list(table.columns), rows)

    def links(self, table: sa.Table, links: Sequence[Links]) -> None:
        """Add links."""
        self._execute(
            f"INSERT INTO {table.name} SELECT ?, key, value FROM json_each(?)",
            [(owner, to_json(targets)) for owner, targets in links],
        )

    def hold(self, table: sa.Table, maker: int, rows: Sequence[Row]) -> None:
        """Keep shared rows of a table; their numbers go on from those that are kept."""
        kept = _kept(table)
        columns = list(table.columns)[SHARED_FROM:]
        if kept not in self._kept_tables:
            self._kept_tables.add(kept)
            names = ", ".join(column.name for column in columns)
            self._connection.exec_driver_sql(f"CREATE TEMPORARY TABLE {kept[5:]} (id INTEGER PRIMARY KEY, {names})")
        first = self._base(maker) + self._held[kept, maker]
        self._held[kept, maker] += len(rows)
        self._insert(kept, [table.columns["id"], *columns], [(key, *row) for key, row in enumerate(rows, first)])

    def _base(self, maker: int) -> int:
        return self._bases.setdefault(maker, len(self._bases) << _MAKER_BITS)

    def forget(self, maker: int) -> None:
        """Drop the shared rows of a maker."""
        base = self._base(maker)
        for kept in self._kept_tables:
            if self._held.pop((kept, maker), 0):
                self._connection.exec_driver_sql(
                    f"DELETE FROM {kept} WHERE id BETWEEN ? AND ?", (base, base + (1 << _MAKER_BITS) - 1)
                )

    def parts(self, table: sa.Table, parts: Sequence[Part]) -> None:
        """Add what shared rows stand for."""
        values = ", ".join(f"kept.{column.name}" for column in list(table.columns)[SHARED_FROM:])
        self._execute(
            f"INSERT INTO {table.name} SELECT NULL, ?, list.key, {values} "
            f"FROM json_each(?) AS list CROSS JOIN {_kept(table)} AS kept ON kept.id = list.value + ?",
            [(parent, numbers, self._base(maker)) for parent, maker, numbers in parts],
        )

    def _insert(self, name: str, columns: Iterable[sa.Column[Any]], rows: Sequence[Row]) -> None:
        names = [column.name for column in columns]
        marks = ", ".join("?" * len(names))
        self._execute(f"INSERT INTO {name} ({', '.join(names)}) VALUES ({marks})", rows)

    def _execute(self, statement: str, values: Sequence[Any]) -> None:
        if values:
            self._connection.exec_driver_sql(statement, values)


def _kept(table: sa.Table) -> str:
    return f"temp.shared_{table.name}"
