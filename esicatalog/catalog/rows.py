"""Documents as rows: what a worker hands to the writer, each distinct content once.

Rows are lists of column values in the order of the table's codec; those that hang on other rows are shared
(:mod:`esicatalog.catalog.shared`). Nothing in here knows a database.
"""

from collections.abc import Iterable
from typing import Any

import msgspec

from esicatalog.catalog.derived import NOWHERE, DerivedRows, PdoPlaces, derived_rows, pdo_places
from esicatalog.catalog.digests import Digests
from esicatalog.catalog.mapping import codec, to_json
from esicatalog.catalog.owned import Image, OwnedRowMaker, OwnedRows, image_row
from esicatalog.catalog.shared import NewlyShared, Numbers, Row, Sharing
from esicatalog.errors import BrokenDocument
from esicatalog.esi.content import MAX_KEY_BYTES
from esicatalog.esi.notes import Finding
from esicatalog.esi.reader import ReadDocument
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import DiagMessage, Diagnostics
from esicatalog.esi.records.dictionary import DataType, Dictionary, EnumInfo, Object, SubItem
from esicatalog.esi.records.document import EsiInfo, Group, Vendor
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.profile import Profile
from esicatalog.model.derivation import Deriver
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.memo import IdentityMemo
from esicatalog.model.module_offer import ModuleOffer, module_offers
from esicatalog.model.resolver import TypeSet

_MAX_PLACES = 1_000


class TypeRows(msgspec.Struct):
    """A data type with its sub-items and enumeration values."""

    key: bytes
    row: Row
    sub_items: Numbers
    enum_values: Numbers


class ObjectRows(msgspec.Struct):
    """An object with its resolved entries."""

    key: bytes
    row: Row
    object_code: int
    entries: Numbers


class DiagnosticsRows(msgspec.Struct):
    """Diagnosis texts."""

    key: bytes
    row: Row
    messages: Numbers


class TypeSetRows(msgspec.Struct):
    """All data types of a dictionary: the numbers of their keys in document order."""

    key: bytes
    data_types: list[int]


class DictionaryRows(msgspec.Struct):
    """A dictionary: its own row, the key of its type set and the numbers of its objects' in document order."""

    key: bytes
    row: Row
    type_set: bytes
    objects: list[int]


class OwnerRows(msgspec.Struct):
    """A device or module with everything that hangs on it."""

    key: bytes
    vendor_id: int | None
    row: Row
    owned: OwnedRows
    profile_parts: list[tuple[bytes | None, bytes | None]]
    """Keys of dictionary and diagnosis texts of each profile."""
    unmapped: list[tuple[str, str]]
    texts: list[tuple[str, int, int | None, str]]
    """(kind, position, LcId, text) of names, comments and links."""
    element_count: int
    """Objects plus PDO entries: what decides which variant is the richest."""


class DeviceRows(OwnerRows):
    """A device description; its ``element_count`` includes the reachable modules."""

    modules: list[bytes]
    default_op_mode: int | None
    derived: DerivedRows


class Placement(msgspec.Struct):
    """That a device or module stands in this document."""

    section: int
    position: int
    line: int
    key: bytes
    group_type: str | None = None


class Section(msgspec.Struct):
    """One vendor section of a document."""

    vendor_id: int | None
    schema_version: str | None
    info_references: list[str]
    vendor: Row | None
    groups: list[Row]
    shared_pdos: str | None
    images: list[Image]


class DocumentRows(msgspec.Struct):
    """Everything a document adds to the catalog."""

    root: str
    encoding: str
    recovered: str | None
    is_whole: bool
    """See :attr:`Document.is_all_whole`."""
    sections: list[Section]
    devices: list[Placement]
    modules: list[Placement]
    dictionary: bytes | None
    diagnostics: bytes | None
    references: list[tuple[str, str, str | None, str | None]]
    findings: list[tuple[str, str, str, int, str]]
    unmapped: list[tuple[str, str]]
    shared: NewlyShared
    new_types: list[TypeRows] = []
    new_type_sets: list[TypeSetRows] = []
    new_objects: list[ObjectRows] = []
    new_dictionaries: list[DictionaryRows] = []
    new_diagnostics: list[DiagnosticsRows] = []
    new_modules: list[OwnerRows] = []
    new_devices: list[DeviceRows] = []


class RowMaker:
    """Turns documents into rows; content that was handed over before is referred to by key only.

    ``deriver`` may know already what follows from the descriptions and their objects.
    """

    def __init__(self, deriver: Deriver | None = None) -> None:
        self._deriver = deriver or Deriver()
        self._resolver = self._deriver.resolver
        self._digests = Digests(self._resolver)
        self._places: IdentityMemo[PdoPlaces] = IdentityMemo(_MAX_PLACES)
        self._sharing = Sharing()
        self._owned = OwnedRowMaker(self._sharing)
        self._sent: set[bytes] = set()
        self._module_counts: dict[bytes, int] = {}

    def document(self, read: ReadDocument, findings: Iterable[Finding]) -> DocumentRows:
        """The rows of one document and what was found in it."""
        if self._sharing.is_full:
            self._share_anew()
        try:
            return self._document(read, findings)
        except BaseException:
            # What this document would have handed over never is.
            self._share_anew()
            self._sent.clear()
            raise

    def _share_anew(self) -> None:
        self._sharing.start_anew()
        self._owned = OwnedRowMaker(self._sharing)

    def _document(self, read: ReadDocument, findings: Iterable[Finding]) -> DocumentRows:
        document = read.document
        self._out = out = DocumentRows(
            root=document.root,
            encoding=document.encoding,
            recovered=document.recovered,
            is_whole=document.is_all_whole,
            sections=[_section(info) for info in document.infos],
            devices=[],
            modules=[],
            dictionary=None,
            diagnostics=None,
            references=[(ref.kind, ref.text, ref.location, ref.sha256) for ref in document.references],
            findings=[(f.rule, f.severity, f.message, f.line, f.path) for f in findings],
            unmapped=[(item.path, item.value) for item in document.unmapped],
            shared=self._sharing.begin(),
        )
        if document.dictionary is not None:
            out.dictionary = self._dictionary(document.dictionary)
        if document.diag_messages is not None:
            out.diagnostics = self._diagnostics(document.diag_messages)
        for section, (info, offer) in enumerate(zip(document.infos, module_offers(document), strict=True)):
            self._info(section, info, offer, read)
        return out

    def _info(self, section: int, info: EsiInfo, offer: ModuleOffer, read: ReadDocument) -> None:
        document = read.document
        vendor_id = info.vendor_id
        keys = {id(module): self._module(module, vendor_id) for module in info.modules}
        vendor_ids = dict(zip(map(id, offer.modules), [vendor.of_module for vendor in offer.vendors], strict=True))
        for position, module in enumerate(info.modules):
            line = document.module_lines[section][position]
            self._out.modules.append(Placement(section, position, line, keys[id(module)]))
        for position, device in enumerate(info.devices):
            line = document.device_lines[section][position]
            _check_type(device, line)
            reachable = offer.reachable(device)
            for module in reachable:
                if id(module) not in keys:  # Of referenced modules only those are stored that a device carries.
                    keys[id(module)] = self._module(module, vendor_ids[id(module)])
            key = self._device(device, vendor_id, reachable, [keys[id(module)] for module in reachable])
            self._out.devices.append(Placement(section, position, line, key, device.group_type))

    def _new(self, key: bytes) -> bool:
        if key in self._sent:
            return False
        self._sent.add(key)
        return True

    def _device(self, device: Device, vendor_id: int | None, modules: list[Module], module_keys: list[bytes]) -> bytes:
        key = self._digests.device(device, vendor_id, module_keys)
        if self._new(key):
            derived = self._deriver.derive(device, modules)
            places = self._places.of(derived.process_data, lambda data: pdo_places(data.images))
            rows = DeviceRows(
                **self._owner(device, key, vendor_id, places),
                modules=module_keys,
                default_op_mode=derived.process_data.default_position,
                derived=derived_rows(derived),
            )
            rows.element_count += sum(self._module_counts[module] for module in module_keys)
            self._out.new_devices.append(rows)
        return key

    def _module(self, module: Module, vendor_id: int | None) -> bytes:
        key = self._digests.module(module, vendor_id)
        if self._new(key):
            rows = OwnerRows(**self._owner(module, key, vendor_id, NOWHERE))
            self._module_counts[key] = rows.element_count
            self._out.new_modules.append(rows)
        return key

    def _owner(self, owner: Device | Module, key: bytes, vendor_id: int | None, places: PdoPlaces) -> dict[str, Any]:
        dictionaries = [profile.dictionary for profile in owner.profiles]
        entries = sum(len(pdo.entries) for pdo in (*owner.rx_pdos, *owner.tx_pdos))
        objects = sum(len(dictionary.objects) for dictionary in dictionaries if dictionary is not None)
        return {
            "key": key,
            "vendor_id": vendor_id,
            "row": codec(type(owner)).encode(owner),
            "owned": self._owned.rows(owner, places),
            "profile_parts": [self._profile_parts(profile) for profile in owner.profiles],
            "unmapped": [(item.path, item.value) for item in owner.unmapped],
            "texts": _texts(owner),
            "element_count": objects + entries,
        }

    def _profile_parts(self, profile: Profile) -> tuple[bytes | None, bytes | None]:
        return (
            self._dictionary(profile.dictionary) if profile.dictionary is not None else None,
            self._diagnostics(profile.diag_messages) if profile.diag_messages is not None else None,
        )

    def _diagnostics(self, diagnostics: Diagnostics) -> bytes:
        key = self._digests.diagnostics(diagnostics)
        if self._new(key):
            messages = self._sharing.rows("diag_messages", map(codec(DiagMessage).encode, diagnostics.diag_messages))
            row = codec(Diagnostics).encode(diagnostics)
            self._out.new_diagnostics.append(DiagnosticsRows(key, row, messages))
        return key

    def _dictionary(self, dictionary: Dictionary) -> bytes:
        key = self._digests.dictionary(dictionary)
        if self._new(key):
            types = self._digests.types(dictionary).types
            object_keys = self._digests.objects(dictionary)
            sent = self._sent
            for declared, object_key in zip(dictionary.objects, object_keys, strict=True):
                if object_key not in sent:
                    sent.add(object_key)
                    self._out.new_objects.append(self._object(declared, types, object_key))
            type_set = self._type_set(dictionary)
            row = codec(Dictionary).encode(dictionary)
            self._out.new_dictionaries.append(DictionaryRows(key, row, type_set, self._sharing.digests(object_keys)))
        return key

    def _object(self, declared: Object, types: TypeSet, key: bytes) -> ObjectRows:
        resolved = self._resolver.resolve(declared, types)
        entries = self._sharing.records("object_entries", resolved.entries, ObjectEntry)
        return ObjectRows(key, codec(Object).encode(declared), resolved.object_code, entries)

    def _type_set(self, dictionary: Dictionary) -> bytes:
        types = self._digests.types(dictionary)
        if self._new(types.digest):
            for data_type, key in zip(dictionary.data_types, types.digests, strict=True):
                if self._new(key):
                    self._out.new_types.append(self._data_type(data_type, key))
            self._out.new_type_sets.append(TypeSetRows(types.digest, self._sharing.digests(types.digests)))
        return types.digest

    def _data_type(self, data_type: DataType, key: bytes) -> TypeRows:
        sub_items = self._sharing.records("sub_items", data_type.sub_items, SubItem)
        enum_values = self._sharing.records("enum_values", data_type.enum_infos, EnumInfo)
        return TypeRows(key, codec(DataType).encode(data_type), sub_items, enum_values)


def _check_type(device: Device, line: int) -> None:
    """Raise :class:`BrokenDocument` for a type that no index takes; real ones have up to 50 characters."""
    size = len((device.type or "").encode())
    if size > MAX_KEY_BYTES:
        raise BrokenDocument(f"Type of {size:,} bytes; a catalog takes {MAX_KEY_BYTES:,}", line)


def _texts(owner: Device | Module) -> list[tuple[str, int, int | None, str]]:
    kinds: dict[str, tuple[Name, ...]] = {"name": owner.names}
    if isinstance(owner, Device):
        kinds |= {"comment": owner.comments, "url": owner.urls}
    return [
        (kind, position, text.lcid, text.text) for kind, texts in kinds.items() for position, text in enumerate(texts)
    ]


def _section(info: EsiInfo) -> Section:
    images = [
        image_row(item.image_data) for item in (info.vendor, *info.groups) if item is not None and item.image_data
    ]
    return Section(
        vendor_id=info.vendor_id,
        schema_version=info.schema_version,
        info_references=list(info.info_references),
        vendor=codec(Vendor).encode(info.vendor) if info.vendor is not None else None,
        groups=[codec(Group).encode(group) for group in info.groups],
        shared_pdos=to_json(info.shared_pdos) if info.shared_pdos else None,
        images=images,
    )
