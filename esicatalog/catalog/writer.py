"""Writing documents into the catalog: one writer, whole documents, each distinct content once.

Everything between two calls of :meth:`Writer.commit` is one transaction; what is committed is always consistent.
"""

from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.bulk import RowBuffer
from esicatalog.catalog.garbage import collect_garbage
from esicatalog.catalog.key_map import KeyMap
from esicatalog.catalog.mapping import PARENTS, codec, to_json
from esicatalog.catalog.rows import (
    DeviceRows,
    DiagnosticsRows,
    DictionaryRows,
    DocumentRows,
    ObjectRows,
    OwnerRows,
    Section,
    TypeRows,
    TypeSetRows,
)
from esicatalog.catalog.settle import Affected, settle
from esicatalog.catalog.shared import NewlyShared, Row
from esicatalog.catalog.state import forget_hashes
from esicatalog.catalog.turns import take_turn
from esicatalog.esi.content import digest
from esicatalog.esi.records.document import Vendor
from esicatalog.esi.stages import Stages

_NO_VENDOR = (None,) * len(codec(Vendor).columns)


class SourceRow(NamedTuple):
    """Where a document came from and what became of it."""

    location: str
    member: str
    status: str
    message: str | None = None
    sha256: str | None = None
    byte_count: int | None = None
    archive: str | None = None
    """Location of the archive it lies in."""


class Writer:
    """Stores documents on one connection; ``reader_version`` marks what was read by which version.

    ``stages`` learns how long writing takes.
    """

    def __init__(self, connection: sa.Connection, reader_version: str, stages: Stages | None = None) -> None:
        self._connection = connection
        self._stages = stages or Stages()
        self._reader_version = reader_version
        self._buffer = RowBuffer(connection)
        self._keys = {
            table: KeyMap(connection, schema.metadata.tables[table])
            for table in (
                "data_types",
                "type_sets",
                "objects",
                "dictionaries",
                "diagnostics",
                "modules",
                "devices",
                "groups",
            )
        }
        self._sources = KeyMap(connection, schema.sources, "location")
        self._vendors: set[int] = set()
        self._images: set[str] = set()
        self._archives: dict[str, int] = {}
        self._digests: dict[int, list[bytes]] = {}
        self._affected = Affected()
        self._dropped = False
        self._turn: int | None = None
        self._is_writing = False

    def store(self, source: SourceRow, document: DocumentRows | None) -> None:
        """Store a document in place of what its location held before; None for skipped and failed ones."""
        self.forget(source.location)
        if document is None:
            self._add_source(source, None)
            return
        maker = self._learn(document.shared)
        for types in document.new_types:
            self._add_type(types, maker)
        for type_set in document.new_type_sets:
            self._add_type_set(type_set, maker)
        for objects in document.new_objects:
            self._add_object(objects, maker)
        for dictionary in document.new_dictionaries:
            self._add_dictionary(dictionary, maker)
        for diagnostics in document.new_diagnostics:
            self._add_diagnostics(diagnostics, maker)
        vendor_ids = [section.vendor_id for section in document.sections]
        for vendor_id in vendor_ids:
            self._add_vendor(vendor_id)
        for module in document.new_modules:
            self._add_module(module, maker)
        for device in document.new_devices:
            self._add_device(device, maker)
        source_id = self._add_source(source, document)
        for position, section in enumerate(document.sections):
            self._add_section(source_id, position, section)
        for placed in document.devices:
            device_id = self._keys["devices"].require(placed.key.hex())
            row = (device_id, source_id, placed.section, placed.position, placed.line, placed.group_type)
            self._buffer.add_numbered("device_sources", [row])
            self._affected.devices.add(device_id)
        for placed in document.modules:
            module_id = self._keys["modules"].require(placed.key.hex())
            module_row = (module_id, source_id, placed.section, placed.position, placed.line)
            self._buffer.add_numbered("module_sources", [module_row])
        self._add_notes(source_id, document)
        self._buffer.flush_if_full()

    def _learn(self, shared: NewlyShared) -> int:
        """Take over what a document's maker has numbered; gives the maker."""
        if shared.starts_anew:
            self._digests[shared.maker] = []
        self._digests[shared.maker] += shared.digests
        self._buffer.share(shared)
        return shared.maker

    def _begin(self) -> None:
        """Take a turn, if this is not one yet: what others wrote before is looked up again."""
        if self._is_writing:
            return
        turn = take_turn(self._connection)
        if self._turn is None or turn != self._turn + 1:
            self._look_up()
        self._turn = turn
        self._is_writing = True
        forget_hashes(self._connection)

    def _look_up(self) -> None:
        """Forget what was known of the rows in the database. Nothing may be queued."""
        self._buffer.forget_ids()
        self._archives.clear()
        for keys in (self._sources, *self._keys.values()):
            keys.forget()
        self._vendors = set(self._connection.execute(sa.select(schema.vendors.c.vendor_id)).scalars())
        self._images = set(self._connection.execute(sa.select(schema.images.c.sha256)).scalars())

    def forget(self, location: str) -> None:
        """Drop what a location brought; descriptions that nobody else carries go with the next commit."""
        self._begin()
        found = self._sources.take(location)
        if found is None:
            return
        self._buffer.flush()
        carried = sa.select(schema.device_sources.c.device_id).where(schema.device_sources.c.source_id == found)
        self._affected.devices.update(self._connection.execute(carried).scalars())
        named = sa.select(schema.source_vendors.c.vendor_id).where(schema.source_vendors.c.source_id == found)
        self._affected.vendors.update(v for v in self._connection.execute(named).scalars() if v is not None)
        for table in (
            schema.device_sources,
            schema.module_sources,
            schema.source_groups,
            schema.source_vendors,
            schema.source_references,
            schema.findings,
            schema.unmapped,
        ):
            self._connection.execute(sa.delete(table).where(table.c.source_id == found))
        self._connection.execute(sa.delete(schema.sources).where(schema.sources.c.id == found))
        self._dropped = True

    def archive_begun(self, location: str) -> None:
        """An archive is being read; its sha256 follows with :meth:`archive_done`."""
        self._begin()
        archives = schema.archives.c
        self._connection.execute(
            sa.update(schema.archives).where(archives.id == self._archive_id(location)).values(sha256="")
        )

    def archive_done(self, location: str, sha256: str) -> None:
        """Every member of the archive is stored: from now on it can be skipped by its sha256."""
        self._begin()
        archives = schema.archives.c
        self._connection.execute(
            sa.update(schema.archives)
            .where(archives.id == self._archive_id(location))
            .values(sha256=sha256, reader_version=self._reader_version)
        )

    def _archive_id(self, location: str) -> int:
        number = self._archives.get(location)
        if number is None:
            archives = schema.archives.c
            number = self._connection.execute(sa.select(archives.id).where(archives.location == location)).scalar()
            if number is None:
                number = self._buffer.add_numbered("archives", [(location, "", self._reader_version)])
                self._buffer.flush()
            self._archives[location] = number
        return number

    def commit(self) -> None:
        """Write what is queued, put variants and vendors in order, commit: the turn, if there is one, ends."""
        if not self._is_writing:
            return
        with self._stages("write"):
            self._buffer.flush()
        with self._stages("order"):
            if self._dropped and collect_garbage(self._connection, self._affected):
                self._look_up()
            self._dropped = False
            settle(self._connection, self._affected)
            self._affected = Affected()
        with self._stages("write"):
            self._connection.commit()
        self._is_writing = False

    def _add_vendor(self, vendor_id: int | None) -> None:
        if vendor_id is None:
            return
        self._affected.vendors.add(vendor_id)
        if vendor_id not in self._vendors:
            self._vendors.add(vendor_id)
            self._buffer.add("vendors", [(vendor_id, None, None)])

    def _add_images(self, images: list[Any]) -> None:
        for sha256, data, malformed in images:
            if sha256 not in self._images:
                self._images.add(sha256)
                self._buffer.add("images", [(sha256, data, malformed)])

    def _add_source(self, source: SourceRow, document: DocumentRows | None) -> int:
        number = self._buffer.take_ids("sources")
        row = (
            number,
            source.location,
            source.member,
            self._archive_id(source.archive) if source.archive is not None else None,
            source.status,
            source.message,
            source.sha256,
            source.byte_count,
            self._reader_version,
            document.root if document else None,
            document.encoding if document else None,
            len(document.devices) if document else 0,
            len(document.modules) if document else 0,
            self._part_id("dictionaries", document.dictionary if document else None),
            self._part_id("diagnostics", document.diagnostics if document else None),
            document.is_whole if document else None,
        )
        self._buffer.add("sources", [row])
        self._sources.put(source.location, number)
        return number

    def _add_section(self, source_id: int, position: int, section: Section) -> None:
        self._add_images(section.images)
        vendor = section.vendor or _NO_VENDOR
        row = (
            position,
            section.schema_version,
            to_json(section.info_references) if section.info_references else None,
            section.shared_pdos,
            section.vendor is not None,
            *vendor,
        )
        self._buffer.add_numbered("source_vendors", [row], source_id)
        groups = self._keys["groups"]
        for number, group in enumerate(section.groups):
            key = digest(to_json([section.vendor_id, *group]).encode()).hex()
            known = groups.get(key)
            if known is None:
                known = self._buffer.add_numbered("groups", [(section.vendor_id, key, *group)])
                groups.put(key, known)
            self._buffer.add_numbered("source_groups", [(source_id, known, position, number)])

    def _add_notes(self, source_id: int, document: DocumentRows) -> None:
        references = [(position, *reference) for position, reference in enumerate(document.references)]
        self._buffer.add_numbered("source_references", references, source_id)
        self._buffer.add_numbered("findings", document.findings, source_id)
        unmapped = [(position, *item) for position, item in enumerate(document.unmapped)]
        self._buffer.add_numbered("unmapped", unmapped, None, None, source_id)

    def _add_type(self, types: TypeRows, maker: int) -> None:
        keys = self._keys["data_types"]
        if keys.get(types.key) is not None:
            return
        number = self._buffer.add_numbered("data_types", [(types.key, *types.row)])
        keys.put(types.key, number)
        self._buffer.add_part("sub_items", number, maker, types.sub_items)
        self._buffer.add_part("enum_values", number, maker, types.enum_values)

    def _add_object(self, rows: ObjectRows, maker: int) -> None:
        keys = self._keys["objects"]
        if keys.get(rows.key) is not None:
            return
        number = self._buffer.add_numbered("objects", [(rows.key, *rows.row, rows.object_code)])
        keys.put(rows.key, number)
        self._buffer.add_part("object_entries", number, maker, rows.entries)

    def _add_type_set(self, rows: TypeSetRows, maker: int) -> None:
        keys = self._keys["type_sets"]
        if keys.get(rows.key) is None:
            number = self._buffer.add_numbered("type_sets", [(rows.key,)])
            keys.put(rows.key, number)
            self._add_links("type_set_data_types", number, "data_types", maker, rows.data_types)

    def _add_dictionary(self, rows: DictionaryRows, maker: int) -> None:
        keys = self._keys["dictionaries"]
        if keys.get(rows.key) is not None:
            return
        type_set = self._keys["type_sets"].require(rows.type_set)
        row = (rows.key, type_set, *rows.row, len(rows.objects))
        number = self._buffer.add_numbered("dictionaries", [row])
        keys.put(rows.key, number)
        self._add_links("dictionary_objects", number, "objects", maker, rows.objects)

    def _add_links(self, table: str, owner: int, target: str, maker: int, parts: list[int]) -> None:
        """Rows (owner, position, number of the part)."""
        digests = self._digests[maker]
        self._buffer.add_links(table, owner, self._keys[target].require_all([digests[part] for part in parts]))

    def _add_diagnostics(self, rows: DiagnosticsRows, maker: int) -> None:
        keys = self._keys["diagnostics"]
        if keys.get(rows.key) is not None:
            return
        number = self._buffer.add_numbered("diagnostics", [(rows.key, *rows.row)])
        keys.put(rows.key, number)
        self._buffer.add_part("diag_messages", number, maker, rows.messages)

    def _part_id(self, table: str, key: bytes | None) -> int | None:
        return self._keys[table].require(key) if key is not None else None

    def _add_module(self, rows: OwnerRows, maker: int) -> None:
        keys = self._keys["modules"]
        if keys.get(rows.key.hex()) is not None:
            return
        self._add_vendor(rows.vendor_id)
        row = (rows.vendor_id, rows.key.hex(), *rows.row, rows.element_count)
        number = self._buffer.add_numbered("modules", [row])
        keys.put(rows.key.hex(), number)
        self._add_owned(rows, maker, None, number)

    def _add_device(self, rows: DeviceRows, maker: int) -> None:
        keys = self._keys["devices"]
        if keys.get(rows.key.hex()) is not None:
            return
        number = self._buffer.take_ids("devices")
        keys.put(rows.key.hex(), number)
        modules = self._keys["modules"].require_all([module.hex() for module in rows.modules])
        not_settled = (False, False, None, None, None)
        row = (number, rows.vendor_id, -number, rows.key.hex(), *rows.row, rows.default_op_mode, rows.element_count)
        self._buffer.add("devices", [(*row, *not_settled)])
        self._add_owned(rows, maker, number, None)
        self._buffer.add_derived(number, rows.derived)
        self._buffer.add_links("device_modules", number, modules)

    def _add_owned(self, rows: OwnerRows, maker: int, device_id: int | None, module_id: int | None) -> None:
        first: dict[str, int] = {}
        for table, table_rows in rows.owned.tables.items():
            if table == "profiles":
                table_rows = self._profiles(rows, table_rows)
            first[table] = self._buffer.add_numbered(table, table_rows, device_id, module_id)
        for table, parts in rows.owned.parts.items():
            base = first[PARENTS[table]]
            for number, numbers in parts:
                self._buffer.add_part(table, base + number, maker, numbers)
        self._add_images(rows.owned.images)
        self._buffer.add_numbered("device_names", rows.texts, device_id, module_id)
        self._buffer.add_numbered("vendor_extensions", rows.owned.extensions, device_id, module_id)
        unmapped = [(position, *item) for position, item in enumerate(rows.unmapped)]
        self._buffer.add_numbered("unmapped", [(None, *row) for row in unmapped], device_id, module_id)

    def _profiles(self, rows: OwnerRows, profiles: list[Row]) -> list[Row]:
        return [
            (row[0], self._part_id("dictionaries", dictionary), self._part_id("diagnostics", diagnostics), *row[1:])
            for row, (dictionary, diagnostics) in zip(profiles, rows.profile_parts, strict=True)
        ]
