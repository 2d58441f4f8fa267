"""Bulk inserts: rows of many documents are gathered per table and written parents first."""

from collections.abc import Iterable, Iterator, Sequence
from operator import itemgetter
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog.copy_rows import copy_rows
from esicatalog.catalog.derived import DerivedRows
from esicatalog.catalog.schema import metadata

_CHUNK_ROWS = 10_000
_MAX_QUEUED_ROWS = 50_000
_SAMPLE_ROWS = 1_000
_TABLES = metadata.sorted_tables


class RowBuffer:
    """Gathers rows per table, hands out row numbers, writes everything with driver-level inserts."""

    def __init__(self, connection: sa.Connection) -> None:
        self._connection = connection
        self._next: dict[str, int] = {}
        self._rows: dict[str, list[tuple[Any, ...]]] = {}
        self._shapes: dict[str, _Shape] = {}

    def take_ids(self, table: str, count: int = 1) -> int:
        """Reserve ``count`` consecutive row numbers of a table; returns the first."""
        first = self._next.get(table)
        if first is None:
            highest = self._connection.execute(sa.select(sa.func.max(metadata.tables[table].c.id))).scalar()
            first = (highest or 0) + 1
        self._next[table] = first + count
        return first

    def forget_ids(self) -> None:
        """After others wrote: the next row numbers are looked up again. Nothing may be queued."""
        self._next.clear()

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
        for table in _TABLES:
            rows = self._rows.pop(table.name, None)
            if rows and self._connection.dialect.name != "sqlite":
                copy_rows(self._connection, table, rows)
            elif rows:
                self._write(table, rows)

    def _write(self, table: sa.Table, rows: list[tuple[Any, ...]]) -> None:
        shape = self._shapes.get(table.name)
        if shape is None:
            shape = self._shapes[table.name] = _Shape(rows)
        names = table.columns.keys()
        for start in range(0, len(rows), _CHUNK_ROWS):
            for columns, part in shape.parts(rows[start : start + _CHUNK_ROWS]):
                marks = ", ".join("?" * len(columns))
                insert = f"INSERT INTO {table.name} ({', '.join(names[at] for at in columns)}) VALUES ({marks})"
                self._connection.exec_driver_sql(insert, part)


class _Shape:
    """Which columns of a table are seldom filled: handing over a NULL costs as much as a value, leaving it out nothing.

    Learned from the first rows; rows that need more columns are inserted with all of them.
    """

    def __init__(self, rows: Sequence[tuple[Any, ...]]) -> None:
        sample = rows[:_SAMPLE_ROWS]
        self._all = range(len(rows[0]))
        missing = [sum(value is None for value in column) for column in zip(*sample, strict=True)]
        order = sorted(self._all, key=missing.__getitem__)
        needed = sorted(
            max((at for at, column in enumerate(order) if row[column] is not None), default=0) for row in sample
        )
        # As many leading columns as nine of ten rows need.
        self._taken = order[: needed[len(needed) * 9 // 10] + 1]
        self._take = itemgetter(*self._taken) if len(self._taken) > 1 else None
        self._rest = order[len(self._taken) :]
        self._leave = itemgetter(*self._rest) if len(self._rest) > 1 else None
        self._nothing = (None,) * len(self._rest)

    def parts(self, rows: list[tuple[Any, ...]]) -> Iterator[tuple[Sequence[int], list[tuple[Any, ...]]]]:
        """Rows with the positions of the columns that they hold."""
        if self._take is None or self._leave is None:
            yield self._all, rows
            return
        leave, nothing = self._leave, self._nothing
        full = [row for row in rows if leave(row) != nothing]
        if full:
            yield self._all, full
            rows = [row for row in rows if leave(row) == nothing]
        if rows:
            yield self._taken, list(map(self._take, rows))


def chunks(values: Iterable[Any], size: int = 500) -> Iterable[list[Any]]:
    """Values in lists of at most ``size``: IN conditions stay below the limits of the databases."""
    held = list(values)
    for start in range(0, len(held), size):
        yield held[start : start + size]
