"""Bulk inserts: rows of many documents are gathered per table and written parents first."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog.copy_inserts import CopyInserts
from esicatalog.catalog.derived import DerivedRows
from esicatalog.catalog.inserts import Inserts, Links, Part
from esicatalog.catalog.schema import metadata
from esicatalog.catalog.shared import NO_NUMBERS, NewlyShared, Numbers, Row
from esicatalog.catalog.sqlite_inserts import SqliteInserts

_TABLES = metadata.sorted_tables


class RowBuffer:
    """Gathers rows per table, hands out row numbers, writes everything with driver-level inserts."""

    def __init__(self, connection: sa.Connection) -> None:
        self._connection = connection
        self._inserts: Inserts = (
            SqliteInserts(connection) if connection.dialect.name == "sqlite" else CopyInserts(connection, self.take_ids)
        )
        self._next: dict[str, int] = {}
        self._rows: dict[str, list[Row]] = defaultdict(list)
        self._links: dict[str, list[Links]] = defaultdict(list)
        self._parts: dict[str, list[Part]] = defaultdict(list)
        self._shared: dict[tuple[str, int], list[Row]] = defaultdict(list)

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

    def add(self, table: str, rows: Iterable[Row]) -> None:
        """Queue complete rows (all columns in the order of the table)."""
        self._rows[table].extend(rows)

    def add_numbered(self, table: str, rows: Sequence[Sequence[Any]], *owner: Any) -> int:
        """Queue rows that lack their number and owner columns; returns the number of the first."""
        first = self.take_ids(table, len(rows))
        self._rows[table].extend([(number, *owner, *row) for number, row in enumerate(rows, first)])
        return first

    def add_links(self, table: str, owner: int, targets: list[int]) -> None:
        """Queue rows (owner, position, target)."""
        if targets:
            self._links[table].append(Links(owner, targets))

    def add_part(self, table: str, parent: int, maker: int, numbers: Numbers) -> None:
        """Queue the rows that hang on the row ``parent``, named by numbers that :meth:`share` told of."""
        if numbers != NO_NUMBERS:
            self._parts[table].append(Part(parent, maker, numbers))

    def share(self, told: NewlyShared) -> None:
        """Learn the shared rows that parts refer to from now on."""
        if told.starts_anew:
            self.flush()
            self._inserts.forget(told.maker)
        for table, rows in told.rows.items():
            self._shared[table, told.maker].extend(rows)

    def add_derived(self, device_id: int, rows: DerivedRows) -> None:
        """Queue what a device implies."""
        self.add("device_facts", [(device_id, *rows.facts)])
        self.add("drive_modes", [(device_id, *row) for row in rows.drive_modes])
        self.add("mode_evidence", [(device_id, *row) for row in rows.mode_evidence])

    def flush_if_full(self) -> None:
        """Write what is queued when it is much: memory stays bounded whatever a document holds, and little is left for
        the end, when nobody else is busy.
        """
        queues = (self._rows, self._links, self._parts, self._shared)
        if sum(len(queued) for queue in queues for queued in queue.values()) > self._inserts.batch_rows:
            self.flush()

    def flush(self) -> None:
        """Write all that is queued in an order that foreign keys allow."""
        for (name, maker), shared in self._shared.items():
            self._inserts.hold(metadata.tables[name], maker, shared)
        self._shared.clear()
        for table in _TABLES:
            if rows := self._rows.pop(table.name, None):
                self._inserts.rows(table, rows)
            if links := self._links.pop(table.name, None):
                self._inserts.links(table, links)
            if parts := self._parts.pop(table.name, None):
                self._inserts.parts(table, parts)


def chunks(values: Iterable[Any], size: int = 500) -> Iterable[list[Any]]:
    """Values in lists of at most ``size``: IN conditions stay below the limits of the databases."""
    held = list(values)
    for start in range(0, len(held), size):
        yield held[start : start + size]
