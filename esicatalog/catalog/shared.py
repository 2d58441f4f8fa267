"""Rows that many parents have in common are handed over once, and named by number from then on.

Four of five entries of objects and PDOs repeat. Who makes rows numbers the distinct ones as they come, and so the
digests of what is stored once; who stores them learns what is new with each document. The tables are those whose rows
hang on another row (``under_parent`` in :mod:`esicatalog.catalog.mapping`); a shared row lacks its own number, that of
its parent and its position.
"""

import os
from collections.abc import Hashable, Iterable
from typing import Any, TypeVar

import msgspec

from esicatalog.catalog.mapping import codec, to_json
from esicatalog.esi.binding import Record
from esicatalog.model.memo import IdentityMemo

Row = tuple[Any, ...]

Numbers = str
"""Numbers of shared rows in the order of their positions: a JSON list, which the database takes as it is."""

NO_NUMBERS: Numbers = "[]"

_MOST_HELD = 100_000
"""Rows and digests with a number: both sides remember them, so numbering starts anew some time."""

_MOST_LISTS = 5_000

Item = TypeVar("Item", bound=Hashable)


class NewlyShared(msgspec.Struct):
    """What a document adds to what its maker of rows has numbered; numbers go on where they stood."""

    maker: int
    starts_anew: bool
    """Whether the numbers given before are void, as with the first document."""
    rows: dict[str, list[Row]]
    """Rows by table."""
    digests: list[bytes]


class Sharing:
    """Numbers what one maker of rows hands over."""

    def __init__(self) -> None:
        self._maker = int.from_bytes(os.urandom(7))
        self.start_anew()

    def start_anew(self) -> None:
        """Forget all numbers."""
        self._starts_anew = True
        self._rows: dict[str, _Numbering[Row]] = {}
        self._digests: _Numbering[bytes] = _Numbering()
        self._of_lists: IdentityMemo[Numbers] = IdentityMemo(_MOST_LISTS)

    @property
    def is_full(self) -> bool:
        """Whether it is time to start anew."""
        return len(self._digests) + sum(map(len, self._rows.values())) >= _MOST_HELD

    def begin(self) -> NewlyShared:
        """A document begins: what it adds fills with everything that is numbered from now on."""
        new = NewlyShared(self._maker, self._starts_anew, {}, self._digests.begin())
        new.rows.update((table, rows.begin()) for table, rows in self._rows.items())
        self._new, self._starts_anew = new, False
        return new

    def rows(self, table: str, rows: Iterable[Row]) -> Numbers:
        """Numbers of rows."""
        return to_json(self._table(table).numbers(rows))

    def records(self, table: str, records: tuple[Record, ...], record_type: type[Record]) -> Numbers:
        """Numbers of the rows of records that often are all together the same as before."""
        return self._of_lists.get(id(records), records, self._record_numbers, table, records, record_type)

    def _record_numbers(self, table: str, records: tuple[Record, ...], record_type: type[Record]) -> Numbers:
        return self.rows(table, map(codec(record_type).encode, records))

    def digests(self, digests: Iterable[bytes]) -> list[int]:
        """Numbers of digests."""
        return self._digests.numbers(digests)

    def _table(self, name: str) -> "_Numbering[Row]":
        known = self._rows.get(name)
        if known is None:
            known = self._rows[name] = _Numbering()
            self._new.rows[name] = known.begin()
        return known


class _Numbering(dict[Item, int]):
    """Distinct items with their numbers; one that is new gets the next."""

    def __init__(self) -> None:
        super().__init__()
        self._new: list[Item] = []

    def begin(self) -> list[Item]:
        """The list to which new items are added from now on."""
        self._new = []
        return self._new

    def numbers(self, items: Iterable[Item]) -> list[int]:
        """The number of each item."""
        return [self[item] for item in items]

    def __missing__(self, item: Item) -> int:
        number = self[item] = len(self)
        self._new.append(item)
        return number
