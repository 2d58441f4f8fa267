"""Proof of values: every description is read back; its digest and all that follows from it must be what is stored.

It is read as every answer reads it, and made into rows as an ingest makes them.
"""

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from typing import Any

import msgspec
import sqlalchemy as sa

from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.derived import NOWHERE, PdoPlaces, derived_rows, pdo_places, positioned
from esicatalog.catalog.digests import Digests
from esicatalog.catalog.mapping import CHILDREN, PARENTS
from esicatalog.catalog.owned import OwnedRowMaker, OwnedRows
from esicatalog.catalog.query import ConnectionQuery
from esicatalog.catalog.reader import RecordReader
from esicatalog.catalog.schema import (
    device_facts,
    device_modules,
    devices,
    dictionaries,
    dictionary_objects,
    drive_modes,
    metadata,
    mode_evidence,
    modules,
    object_entries,
    objects,
)
from esicatalog.catalog.shared import Row, Sharing
from esicatalog.catalog.table_kinds import parent_column
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.derivation import Deriver
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.resolver import Resolver

_BATCH = 500
"""Descriptions read at once: what they share is read, and made into rows, once for all of them."""
_OWNED = [
    metadata.tables[name]
    for name in dict.fromkeys(child.table for of in CHILDREN.values() for child in of if not child.under_parent)
]
"""Tables whose rows hang on a device or module."""
_PARTS = {name: parent for name, parent in PARENTS.items() if metadata.tables[parent] in _OWNED}
"""Tables whose rows hang on such a row, and where that is."""

Rows = Mapping[int, Sequence[Row]]
"""Rows by the number of what they hang on, in order."""


def value_problems(connection: sa.Connection) -> Iterator[str]:
    """Descriptions whose values are not those that a document brought, and rows that do not follow from them.

    All else must be sound (:func:`~esicatalog.catalog.check_rows.rules`): only what hangs together can be read.
    """
    found = _Found()
    for table, compare in ((modules, _compare_modules), (devices, _compare_devices), (dictionaries, _compare_entries)):
        for part in chunks(connection.execute(sa.select(table.c.id).order_by(table.c.id)).scalars(), _BATCH):
            compare(connection, part, found)
    yield from found.words()


class _Found:
    """How many descriptions have other values than they had, and how many have rows that do not follow from them."""

    def __init__(self) -> None:
        self._changed: Counter[str] = Counter()
        self._not_following: Counter[tuple[str, str]] = Counter()

    def digest(self, kind: str, is_as_stored: bool) -> None:
        self._changed[kind] += not is_as_stored

    def rows(self, kind: str, table: str, stored: Rows, expected: Rows) -> None:
        owners = stored.keys() | expected.keys()
        wrong = sum(list(stored.get(owner, ())) != list(expected.get(owner, ())) for owner in owners)
        self._not_following[kind, table] += wrong

    def words(self) -> Iterator[str]:
        for kind, count in self._changed.items():
            if count:
                yield f"{count} {kind} have other values than their documents brought"
        for (kind, table), count in self._not_following.items():
            if count:
                yield f"{count} {kind} have rows in {table} that do not follow from their description"


def _compare_modules(connection: sa.Connection, numbers: Sequence[int], found: _Found) -> None:
    digests, owners = Digests(), _Owners("module")
    identities = _rows_of(connection, [modules.c.vendor_id, modules.c.content_hash], modules.c.id, numbers)
    for number, module in zip(numbers, RecordReader(ConnectionQuery(connection)).modules(numbers), strict=True):
        ((vendor_id, content_hash),) = identities[number]
        found.digest("modules", digests.module(module, vendor_id).hex() == content_hash)
        owners.add(number, module, NOWHERE)
    owners.compare(connection, found)


def _compare_devices(connection: sa.Connection, numbers: Sequence[int], found: _Found) -> None:
    digests, owners, deriver = Digests(), _Owners("device"), Deriver()
    reader = RecordReader(ConnectionQuery(connection))
    identities = _rows_of(connection, [devices.c.vendor_id, devices.c.content_hash], devices.c.id, numbers)
    reachable, keys = reader.modules_of_each(numbers), _module_keys(connection, numbers)
    expected: dict[sa.Column[Any], dict[int, list[Row]]] = defaultdict(dict)
    for number, device in zip(numbers, reader.devices(numbers), strict=True):
        ((vendor_id, content_hash),) = identities[number]
        found.digest("devices", digests.device(device, vendor_id, keys[number]).hex() == content_hash)
        derived = deriver.derive(device, reachable[number])
        owners.add(number, device, pdo_places(derived.images))
        rows = derived_rows(derived)
        expected[devices.c.id][number] = [(derived.process_data.default_position,)]
        expected[device_facts.c.device_id][number] = [rows.facts]
        expected[drive_modes.c.device_id][number] = rows.drive_modes
        expected[mode_evidence.c.device_id][number] = rows.mode_evidence
    for owner, made in expected.items():
        columns = [devices.c.default_op_mode] if owner is devices.c.id else _values(owner.table)
        found.rows("devices", owner.table.name, _rows_of(connection, columns, owner, numbers), made)
    owners.compare(connection, found)


def _module_keys(connection: sa.Connection, device_ids: Sequence[int]) -> dict[int, list[bytes]]:
    """The digests of the modules that each device reaches, in document order."""
    device_id = device_modules.c.device_id
    query = sa.select(device_id, modules.c.content_hash).join(modules).where(device_id.in_(device_ids))
    found: dict[int, list[bytes]] = defaultdict(list)
    for number, key in connection.execute(query.order_by(*device_modules.primary_key)):
        found[number].append(bytes.fromhex(key))
    return found


def _compare_entries(connection: sa.Connection, numbers: Sequence[int], found: _Found) -> None:
    """The entries of objects, which follow from these and the data types of their dictionary."""
    resolver, digests, reader = Resolver(), Digests(), RecordReader(ConnectionQuery(connection))
    reader.load_dictionaries(numbers)
    links = _rows_of(connection, [dictionary_objects.c.object_id], dictionary_objects.c.dictionary_id, numbers)
    made: dict[int, list[Row]] = {}
    codes: dict[int, list[Row]] = {}
    for number in numbers:
        dictionary = reader.dictionary(number)
        types = resolver.types(dictionary)
        keys = digests.objects(dictionary)
        for (linked,), declared, key in zip(links[number], dictionary.objects, keys, strict=True):
            if linked not in made:
                resolved = resolver.resolve(declared, types)
                made[linked] = positioned(ObjectEntry, resolved.entries)
                codes[linked] = [(key, resolved.object_code)]
    held = list(made)
    found.rows(
        "objects",
        "objects",
        _rows_of(connection, [objects.c.content_hash, objects.c.object_code], objects.c.id, held),
        codes,
    )
    found.rows(
        "objects",
        "object_entries",
        _rows_of(connection, _values(object_entries), object_entries.c.object_id, held),
        made,
    )


class _Owners:
    """Devices or modules, and the rows that hang on them, made anew."""

    def __init__(self, kind: str) -> None:
        self._kind = kind
        sharing = Sharing()
        self._shared = sharing.begin().rows
        self._maker = OwnedRowMaker(sharing)
        self._made: dict[int, OwnedRows] = {}

    def add(self, number: int, owner: Device | Module, places: PdoPlaces) -> None:
        self._made[number] = self._maker.rows(owner, places)

    def compare(self, connection: sa.Connection, found: _Found) -> None:
        numbers = {table.name: self._compare_owned(connection, table, found) for table in _OWNED}
        for name, parent in _PARTS.items():
            made: dict[int, list[Row]] = {}
            for owner, rows in self._made.items():
                for place, listed in rows.parts.get(name, ()):
                    shared = [self._shared[name][number] for number in msgspec.json.decode(listed)]
                    made[numbers[parent][owner][place]] = [(position, *row) for position, row in enumerate(shared)]
            table = metadata.tables[name]
            held = list(chain(*numbers[parent].values()))
            stored = _rows_of(connection, _values(table), table.c[parent_column(parent)], held)
            found.rows(parent, name, stored, {number: rows for number, rows in made.items() if rows})

    def _compare_owned(self, connection: sa.Connection, table: sa.Table, found: _Found) -> dict[int, list[int]]:
        """The numbers of the rows of each owner, in their order."""
        numbered = _rows_of(connection, [table.c.id, *_values(table)], table.c[f"{self._kind}_id"], list(self._made))
        stored = {owner: [row[1:] for row in rows] for owner, rows in numbered.items()}
        made = {owner: rows.tables[table.name] for owner, rows in self._made.items() if table.name in rows.tables}
        found.rows(f"{self._kind}s", table.name, stored, made)
        return {owner: [row[0] for row in rows] for owner, rows in numbered.items()}


def _values(table: sa.Table) -> list[sa.Column[Any]]:
    """Columns that say something of what a row hangs on."""
    above = {column.name for column in table.c if column.foreign_keys}
    return [column for column in table.c if column.name not in above | {"id"}]


def _rows_of(
    connection: sa.Connection, columns: Sequence[sa.Column[Any]], owner: sa.Column[Any], owners: Sequence[int]
) -> dict[int, list[Row]]:
    found: dict[int, list[Row]] = defaultdict(list)
    for part in chunks(owners):
        query = sa.select(owner, *columns).where(owner.in_(part)).order_by(*owner.table.primary_key)
        for number, *row in connection.execute(query):
            found[number].append(tuple(row))
    return found
