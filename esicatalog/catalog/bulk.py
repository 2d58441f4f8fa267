"""Bulk inserts: rows of many documents are gathered per table and written parents first."""

from collections.abc import Iterable, Sequence
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog.derived import DerivedRows
from esicatalog.catalog.schema import metadata

_CHUNK_ROWS = 10_000
_MAX_QUEUED_ROWS = 50_000


class RowBuffer:
    """Gathers rows per table, hands out row numbers, writes everything with driver-level inserts."""

    def __init__(self, connection: sa.Connection) -> None:
        self._connection = connection
        self._next: dict[str, int] = {}
        self._rows: dict[str, list[tuple[Any, ...]]] = {}

    def take_ids(self, table: str, count: int = 1) -> int:
        """Reserve ``count`` consecutive row numbers of a table; returns the first."""
        first = self._next.get(table)
        if first is None:
            highest = self._connection.execute(sa.select(sa.func.max(metadata.tables[table].c.id))).scalar()
            first = (highest or 0) + 1
        self._next[table] = first + count
        return first

    def add(self, table: str, rows: Iterable[tuple[Any, ...]]) -> None:
        """Queue complete rows (all columns in the order of the table)."""
        self._rows.setdefault(table, []).extend(rows)

    def add_numbered(self, table: str, rows: Sequence[Sequence[Any]], *owner: Any) -> int:
        """Queue rows that lack their number and owner columns; returns the number of the first."""
        first = self.take_ids(table, len(rows))
        self._rows.setdefault(table, []).extend([(number, *owner, *row) for number, row in enumerate(rows, first)])
        return first

    def add_derived(self, device_id: int, rows: DerivedRows) -> None:
        """Queue what a device implies."""
        self.add("device_facts", [(device_id, *rows.facts)])
        self.add("drive_modes", [(device_id, *row) for row in rows.drive_modes])
        self.add("mode_evidence", [(device_id, *row) for row in rows.mode_evidence])

    def flush_if_full(self) -> None:
        """Write the queued rows when there are many: memory stays bounded whatever a document holds."""
        if sum(map(len, self._rows.values())) > _MAX_QUEUED_ROWS:
            self.flush()

    def flush(self) -> None:
        """Write all queued rows in an order that foreign keys allow."""
        for table in metadata.sorted_tables:
            rows = self._rows.pop(table.name, None)
            if rows:
                insert = self._statement(table)
                for start in range(0, len(rows), _CHUNK_ROWS):
                    self._connection.exec_driver_sql(insert, rows[start : start + _CHUNK_ROWS])

    def _statement(self, table: sa.Table) -> str:
        mark = "?" if self._connection.dialect.paramstyle == "qmark" else "%s"
        marks = ", ".join([mark] * len(table.columns))
        return f"INSERT INTO {table.name} ({', '.join(c.name for c in table.columns)}) VALUES ({marks})"


def chunks(values: Iterable[Any], size: int = 500) -> Iterable[list[Any]]:
    """Values in lists of at most ``size``: IN conditions stay below the limits of the databases."""
    held = list(values)
    for start in range(0, len(held), size):
        yield held[start : start + size]
