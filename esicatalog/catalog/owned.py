"""Rows of everything that hangs on a device or module. Nothing in here knows a database."""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import msgspec

from esicatalog.catalog.derived import PdoPlace, PdoPlaces
from esicatalog.catalog.mapping import CHILDREN, codec, extension_rows, image_key
from esicatalog.catalog.shared import NO_NUMBERS, Numbers, Row, Sharing
from esicatalog.esi.binding import Record
from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.memo import IdentityMemo, identities

_MAX_PDOS = 10_000
_MAX_LISTS = 1_000

Image = tuple[str, bytes | None, str | None]
"""Key, bytes, and the text of one that is not hexBinary."""


class OwnedRows(msgspec.Struct):
    """Rows below a device or module."""

    tables: dict[str, list[Row]] = {}
    """Rows that hang on the device or module itself."""
    parts: dict[str, list[tuple[int, Numbers]]] = {}
    """Rows that hang on those: the number of the row within its table above, and shared rows."""
    extensions: list[tuple[str, int, str, str]] = []
    images: list[Image] = []


class _PdoRows(msgspec.Struct):
    """What a PDO has in common with itself in other devices."""

    row: Row
    exclusions: Numbers


class _PdoLists(NamedTuple):
    """Rows of all PDOs, and what hangs on each by its number among them."""

    rows: list[Row]
    entries: list[tuple[int, Numbers]]
    exclusions: list[tuple[int, Numbers]]


_PDO_FIELDS = {
    owner: [(*child.constant, child.field) for child in CHILDREN[owner] if child.table == "pdos"]
    for owner in (Device, Module)
}
"""Direction and field of each list of PDOs."""


class OwnedRowMaker:
    """Makes rows of devices and modules; of PDOs that many have, and of the lists of them, once."""

    def __init__(self, sharing: Sharing) -> None:
        self._sharing = sharing
        self._pdos: IdentityMemo[_PdoRows] = IdentityMemo(_MAX_PDOS)
        self._pdo_lists: IdentityMemo[_PdoLists] = IdentityMemo(_MAX_LISTS)
        self._entries: IdentityMemo[Numbers] = IdentityMemo(_MAX_PDOS)

    def rows(self, owner: Device | Module, places: PdoPlaces) -> OwnedRows:
        """Everything below a device or module, whose PDOs have these places in its process image."""
        found = OwnedRows()
        self._add(found, owner, "", 0)
        lists = [(direction, getattr(owner, field)) for direction, field in _PDO_FIELDS[type(owner)]]
        key = (id(places), *[identities(pdos) for _, pdos in lists])
        made = self._pdo_lists.get(key, (lists, places), self._rows_of_pdos, lists, places)
        if made.rows:
            found.tables["pdos"] = made.rows
            found.parts |= {"pdo_entries": made.entries, "pdo_exclusions": made.exclusions}
        return found

    def _add(self, found: OwnedRows, record: Any, table: str, number: int) -> None:
        """Add what is below ``record``, which is row ``number`` of ``table`` ("" for the owner itself)."""
        record_codec = codec(type(record))
        if record_codec.extensions:
            found.extensions.extend(extension_rows(record, table, number))
        found.images.extend(_images([record]))
        for child in CHILDREN.get(type(record), ()):
            held = getattr(record, child.field)
            if not held or child.table == "pdos":
                continue
            if child.under_parent:
                numbers = self._sharing.rows(child.table, _rows(held))
                found.images.extend(_images(held))
                found.parts.setdefault(child.table, []).append((number, numbers))
            else:
                items = (held,) if child.single else held
                rows = found.tables.setdefault(child.table, [])
                first = len(rows)
                rows += [(position, *child.constant, *row) for position, row in enumerate(_rows(items))]
                if not codec(type(items[0])).is_leaf:
                    for item_number, item in enumerate(items, first):
                        self._add(found, item, child.table, item_number)

    def _rows_of_pdos(self, lists: Sequence[tuple[str, Sequence[Pdo]]], places: PdoPlaces) -> _PdoLists:
        made = _PdoLists([], [], [])
        for direction, pdos in lists:
            for position, pdo in enumerate(pdos):
                number = len(made.rows)
                own = self._pdos.of(pdo, self._pdo_rows)
                place = places.get((direction, position))
                made.rows.append((position, direction, *own.row, place[0] if place else None))
                if pdo.entries:
                    made.entries.append((number, self._entries_of(pdo, place)))
                if own.exclusions != NO_NUMBERS:
                    made.exclusions.append((number, own.exclusions))
        return made

    def _pdo_rows(self, pdo: Pdo) -> _PdoRows:
        return _PdoRows(codec(Pdo).encode(pdo), self._sharing.rows("pdo_exclusions", _rows(pdo.excludes)))

    def _entries_of(self, pdo: Pdo, place: PdoPlace | None) -> Numbers:
        """Entries with the offset of each in the process image; the first tells those of the others."""
        offsets = place[1] if place and place[1] else [None] * len(pdo.entries)
        return self._entries.get((id(pdo), offsets[0]), pdo, self._entry_numbers, pdo, offsets)

    def _entry_numbers(self, pdo: Pdo, offsets: Sequence[int | None]) -> Numbers:
        rows = [(*row, offset) for row, offset in zip(_rows(pdo.entries), offsets, strict=True)]
        return self._sharing.rows("pdo_entries", rows)


def _rows(records: Sequence[Record]) -> Iterable[Row]:
    """Rows of records of one type."""
    return map(codec(type(records[0])).encode, records) if records else ()


def _images(records: Sequence[Any]) -> list[Image]:
    """Rows of the images of records of one type."""
    if codec(type(records[0])).image_column is None:
        return []
    return [image_row(record.image_data) for record in records if record.image_data is not None]


def image_row(hex_text: str) -> Image:
    """The row of an image."""
    data = decode_hex_binary(hex_text)
    key = image_key(hex_text)
    assert key is not None
    return key, data, hex_text if data is None else None
