"""Reading records back from the catalog: what comes out equals what the document reader produced."""

from collections import defaultdict
from collections.abc import Container, Iterable, Iterator, Sequence
from itertools import chain
from typing import Any

import msgspec

from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.mapping import CHILDREN, TABLE_RECORDS, Child, Codec, codec
from esicatalog.catalog.pictures import picture_texts
from esicatalog.catalog.query import Query, rows_of
from esicatalog.catalog.table_kinds import parent_column
from esicatalog.errors import NotFound
from esicatalog.esi.binding import Record
from esicatalog.esi.notes import Unmapped
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import Diagnostics
from esicatalog.esi.records.dictionary import DataType, Dictionary, Object
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.profile import Profile

_TABLES = {record: table for table, record in TABLE_RECORDS.items()}

_MOST_NUMBERS = 2_000
"""Row numbers in one query: more than most devices have objects or modules, fewer than make SQLite read all rows."""


class RecordReader:
    """Reads devices, modules and dictionaries; what is shared is read once per reader."""

    def __init__(self, query: Query, with_dictionaries: bool = True) -> None:
        """Without dictionaries, and diagnosis texts, devices and modules take less than half the time to read."""
        self._query = query
        self._shared = ("dictionary_id", "diagnostics_id") if with_dictionaries else ("NULL", "NULL")
        self._dictionaries: dict[int, Dictionary] = {}
        self._diagnostics: dict[int, Diagnostics] = {}
        self._objects: dict[int, Object] = {}
        self._types: dict[int, DataType] = {}
        self._type_sets: dict[int, list[int]] = {}

    def device(self, device_id: int) -> Device:
        """One description. Raises :class:`NotFound`."""
        return self.devices([device_id])[0]

    def devices(self, device_ids: Sequence[int]) -> list[Device]:
        """Descriptions in the order asked for. Raises :class:`NotFound`."""
        devices: list[Device] = self._owners(Device, device_ids)
        groups: dict[int, str | None] = {}
        for part in chunks(device_ids):
            groups.update(rows_of(self._query, "id, group_type", "devices", "id", part))
        return [
            msgspec.structs.replace(device, group_type=groups[number])
            for number, device in zip(device_ids, devices, strict=True)
        ]

    def modules(self, module_ids: Sequence[int]) -> list[Module]:
        """Modules in the order asked for. Raises :class:`NotFound`."""
        return self._owners(Module, module_ids)

    def modules_of(self, device_id: int) -> list[Module]:
        """The modules that the slots of a device can reach, in document order."""
        return self.modules_of_each([device_id])[device_id]

    def modules_of_each(self, device_ids: Sequence[int]) -> dict[int, list[Module]]:
        """The same of many devices; what several of them can reach is one record."""
        reached = self._linked("module_id", "device_modules", "device_id", device_ids)
        numbers = list(dict.fromkeys(chain.from_iterable(reached.values())))
        modules = dict(zip(numbers, self.modules(numbers), strict=True))
        return {device: [modules[number] for number in own] for device, own in reached.items()}

    def dictionary(self, dictionary_id: int) -> Dictionary:
        """A dictionary as declared, with its data types and objects."""
        self.load_dictionaries([dictionary_id])
        return self._dictionaries[dictionary_id]

    def load_dictionaries(self, dictionary_ids: Iterable[int]) -> None:
        """Read many dictionaries at once: what :meth:`dictionary` then gives costs no query."""
        for part in chunks(_missing(dictionary_ids, self._dictionaries), _MOST_NUMBERS):
            self._dictionaries.update(self._read_dictionaries(part))

    def diagnostics(self, diagnostics_id: int) -> Diagnostics:
        """Diagnosis texts."""
        self.load_diagnostics([diagnostics_id])
        return self._diagnostics[diagnostics_id]

    def load_diagnostics(self, diagnostics_ids: Iterable[int]) -> None:
        """Read many sets of diagnosis texts at once."""
        self._load(Diagnostics, diagnostics_ids, self._diagnostics)

    def _owners(self, record_type: Any, owner_ids: Sequence[int]) -> list[Any]:
        found: dict[int, Any] = {}
        for part in chunks(dict.fromkeys(owner_ids), _MOST_NUMBERS):
            found.update(_OwnerBatch(self, self._query, record_type, part, self._shared).read())
        missing = [number for number in owner_ids if number not in found]
        if missing:
            raise NotFound(f"no {record_type.__name__.lower()} with row number {missing[0]}")
        return [found[number] for number in owner_ids]

    def _read_dictionaries(self, dictionary_ids: list[int]) -> Iterator[tuple[int, Dictionary]]:
        own = codec(Dictionary)
        rows = rows_of(self._query, f"id, type_set_id, {_stored(own)}", "dictionaries", "id", dictionary_ids)
        type_set_ids = _missing((row[1] for row in rows), self._type_sets)
        objects = self._linked("object_id", "dictionary_objects", "dictionary_id", dictionary_ids)
        self._type_sets |= self._linked("data_type_id", "type_set_data_types", "type_set_id", type_set_ids)
        self._load(Object, chain.from_iterable(objects.values()), self._objects)
        type_ids = chain.from_iterable(self._type_sets[row[1]] for row in rows)
        self._load(DataType, type_ids, self._types)
        for number, type_set_id, *values in rows:
            yield (
                number,
                own.decode(
                    tuple(values),
                    data_types=tuple(self._types[part] for part in self._type_sets[type_set_id]),
                    objects=tuple(self._objects[part] for part in objects[number]),
                ),
            )

    def _linked(self, target: str, table: str, parent: str, numbers: Sequence[int]) -> dict[int, list[int]]:
        """Row numbers of the parts of each parent, in their order."""
        found: dict[int, list[int]] = {number: [] for number in numbers}
        for number, part in rows_of(self._query, f"{parent}, {target}", table, parent, numbers, f"{parent}, position"):
            found[number].append(part)
        return found

    def _load(self, record_type: type[Record], numbers: Iterable[int], known: dict[int, Any]) -> None:
        missing = _missing(numbers, known)
        if missing:
            known.update(self._plain(record_type, missing))

    def _plain(self, record_type: type[Record], numbers: Sequence[int]) -> dict[int, Any]:
        """Records of a table that is not owned by devices, with the rows that hang on them."""
        own, table = codec(record_type), _TABLES[record_type]
        found = {}
        for part in chunks(numbers, _MOST_NUMBERS):
            children: dict[str, dict[int, list[Any]]] = {}
            for child in CHILDREN.get(record_type, ()):
                children[child.field] = self._child_records(child, table, part)
            for number, *values in rows_of(self._query, f"id, {_stored(own)}", table, "id", part):
                elsewhere = {field: tuple(rows.get(number, ())) for field, rows in children.items()}
                found[number] = own.decode(tuple(values), **elsewhere)
        return found

    def _child_records(self, child: Child, parent: str, numbers: list[int]) -> dict[int, list[Any]]:
        own, owner = codec(TABLE_RECORDS[child.table]), parent_column(parent)
        found: dict[int, list[Any]] = defaultdict(list)
        rows = rows_of(self._query, f"{owner}, {_stored(own)}", child.table, owner, numbers, f"{owner}, position")
        for number, *values in rows:
            found[number].append(own.decode(tuple(values)))
        return found


class _OwnerBatch:
    """Reads a batch of devices or modules with one query a table."""

    def __init__(
        self, reader: RecordReader, query: Query, record_type: Any, owner_ids: list[int], shared: tuple[str, ...]
    ) -> None:
        self._reader = reader
        self._query = query
        self._record_type = record_type
        self._ids = owner_ids
        self._shared = shared
        self._owner = f"{record_type.__name__.lower()}_id"
        self._rows: dict[str, dict[Any, list[tuple[int, tuple[Any, ...]]]]] = {}
        self._extensions: dict[tuple[int, str, int, str], str] = {}
        self._images: dict[str, str] = {}

    def read(self) -> dict[int, Any]:
        self._load_owned(self._record_type)
        self._load_shared()
        self._load_extensions()
        unmapped = self._unmapped()
        own = codec(self._record_type)
        rows = rows_of(self._query, f"id, {_stored(own)}", _TABLES[self._record_type], "id", self._ids)
        self._load_images(own, [row[1:] for row in rows])
        found = {}
        for number, *values in rows:
            extra = {"unmapped": tuple(unmapped.get(number, ()))}
            found[number] = self._build(own, tuple(values), number, "", 0, number, extra)
        return found

    def _load_owned(self, record_type: Any) -> None:
        """Fetch the rows of all tables below a record type."""
        for child in CHILDREN.get(record_type, ()):
            if child.table in self._rows:
                continue
            self._rows[child.table] = self._fetch(child, _TABLES[record_type])
            self._load_owned(TABLE_RECORDS[child.table])

    def _fetch(self, child: Child, parent: str) -> dict[Any, list[tuple[int, tuple[Any, ...]]]]:
        own, source = codec(TABLE_RECORDS[child.table]), f"{child.table} t"
        key = owner = f"t.{self._owner}"
        if child.under_parent:
            key, owner = f"t.{parent_column(parent)}", f"p.{self._owner}"
            source += f" JOIN {parent} p ON p.id = {key}"
        discriminator = f"t.{child.discriminator[0]}" if child.discriminator is not None else "NULL"
        columns = ", ".join(["t.id", key, discriminator, _stored(own, "t."), *self._shared_of(child)])
        rows = rows_of(self._query, columns, source, owner, self._ids, f"{key}, t.position")
        found: dict[Any, list[tuple[int, tuple[Any, ...]]]] = defaultdict(list)
        for number, parent_id, kind, *values in rows:
            found[(parent_id, kind)].append((number, tuple(values)))
        self._load_images(own, [row[3:] for row in rows])
        return found

    def _build(
        self,
        own: Codec,
        values: tuple[Any, ...],
        number: int,
        table: str,
        position: int,
        owner: int,
        extra: dict[str, Any],
    ) -> Any:
        fields = dict(extra)
        for child in CHILDREN.get(own.record_type, ()):
            kind = child.discriminator[1] if child.discriminator is not None else None
            rows = self._rows[child.table].get((number if child.under_parent else owner, kind), [])
            inner = codec(TABLE_RECORDS[child.table])
            built = tuple(
                self._build(inner, row, row_number, child.table, at, owner, {})
                for at, (row_number, row) in enumerate(rows)
            )
            fields[child.field] = (built[0] if built else None) if child.single else built
        if own.record_type is Profile:
            dictionary_id, diagnostics_id = values[len(own.stored_columns) :]
            if dictionary_id is not None:
                fields["dictionary"] = self._reader.dictionary(dictionary_id)
            if diagnostics_id is not None:
                fields["diag_messages"] = self._reader.diagnostics(diagnostics_id)
        for field in own.extensions:
            fields[field.name] = self._extensions.get((owner, table, position, field.name))
        if own.image_column is not None and values[own.image_column] is not None:
            fields["image_data"] = self._images[values[own.image_column]]
        return own.decode(values, **fields)

    def _shared_of(self, child: Child) -> tuple[str, ...]:
        """Columns that come last: what refers to shared parts."""
        return self._shared if child.table == "profiles" else ()

    def _load_shared(self) -> None:
        """Fetch the dictionaries and diagnosis texts that the profiles point to: the last two of their columns."""
        parts = [values[-2:] for rows in self._rows["profiles"].values() for _, values in rows]
        self._reader.load_dictionaries(number for number, _ in parts if number is not None)
        self._reader.load_diagnostics(number for _, number in parts if number is not None)

    def _load_extensions(self) -> None:
        columns = f"{self._owner}, owner_table, owner_position, field, xml"
        rows = rows_of(self._query, columns, "vendor_extensions", self._owner, self._ids)
        self._extensions = {(a, b, c, d): xml for a, b, c, d, xml in rows}

    def _unmapped(self) -> dict[int, list[Unmapped]]:
        found: dict[int, list[Unmapped]] = defaultdict(list)
        order = f"{self._owner}, position"
        rows = rows_of(self._query, f"{self._owner}, path, value", "unmapped", self._owner, self._ids, order)
        for number, path, value in rows:
            found[number].append(Unmapped(path, value))
        return found

    def _load_images(self, own: Codec, rows: Iterable[Any]) -> None:
        if own.image_column is None:
            return
        at = own.image_column
        wanted = {row[at] for row in rows if row[at] is not None} - self._images.keys()
        self._images |= picture_texts(self._query, wanted)


def _missing(numbers: Iterable[int], known: Container[int]) -> list[int]:
    return [number for number in dict.fromkeys(numbers) if number not in known]


def _stored(own: Codec, prefix: str = "") -> str:
    """The columns that :meth:`Codec.decode` takes."""
    return ", ".join([prefix + column.name for column in own.stored_columns])
