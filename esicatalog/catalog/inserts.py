"""What is put into a database in bulk, besides plain rows: rows that are shared, and links."""

from collections.abc import Sequence
from typing import ClassVar, NamedTuple, Protocol

import sqlalchemy as sa

from esicatalog.catalog.shared import Numbers, Row


class Part(NamedTuple):
    """Rows that hang on the row ``parent``: shared rows of a maker of rows, by number."""

    parent: int
    maker: int
    numbers: Numbers


class Links(NamedTuple):
    """Rows (owner, position, target) of an owner."""

    owner: int
    targets: list[int]


class Inserts(Protocol):
    """Inserts within the transaction of a connection, as one kind of database takes them."""

    batch_rows: ClassVar[int]
    """How many rows, links and parts together are worth a round of statements."""

    def rows(self, table: sa.Table, rows: Sequence[Row]) -> None:
        """Add complete rows (all columns in the order of the table)."""

    def links(self, table: sa.Table, links: Sequence[Links]) -> None:
        """Add links."""

    def hold(self, table: sa.Table, maker: int, rows: Sequence[Row]) -> None:
        """Keep shared rows of a table; their numbers go on from those that are kept."""

    def forget(self, maker: int) -> None:
        """Drop the shared rows of a maker."""

    def parts(self, table: sa.Table, parts: Sequence[Part]) -> None:
        """Add what shared rows stand for."""


SHARED_FROM = 3
"""Columns that a shared row lacks: its own number, that of its parent, its position."""
