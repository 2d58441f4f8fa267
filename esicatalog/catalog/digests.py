"""Content digests of everything the catalog stores once per distinct content.

The content of a device description is the Device, its dictionaries and the modules its slots can reach, without
vendor name, group, file version and line.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import msgspec

from esicatalog.esi.content import digest
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import Diagnostics
from esicatalog.esi.records.dictionary import DataType, Dictionary, Object
from esicatalog.esi.records.module import Module
from esicatalog.model.dictionary import type_table, used_types

_encode = msgspec.msgpack.Encoder().encode
_MEMO_LIMIT = 200_000
_MAX_DICTIONARIES = 2_000


class _Memo:
    """Digests by object identity; holds the objects so that identities stay valid."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[Any, bytes]] = {}

    def get(self, record: Any, compute: Callable[[Any], bytes]) -> bytes:
        known = self._known.get(id(record))
        if known is None:
            if len(self._known) >= _MEMO_LIMIT:
                self._known.clear()
            known = self._known[id(record)] = (record, compute(record))
        return known[1]


class Digests:
    """Computes digests; records that were seen before (the reader reuses them) cost nothing."""

    def __init__(self) -> None:
        self._plain = _Memo()
        self._dictionaries = _Memo()
        self._objects: dict[tuple[int, bytes], tuple[Object, bytes]] = {}
        self._keys: dict[int, tuple[Dictionary, list[bytes]]] = {}
        self._types: dict[tuple[int, ...], DeclaredTypes] = {}
        self._types_of: dict[int, tuple[Dictionary, DeclaredTypes]] = {}

    def data_type(self, data_type: DataType) -> bytes:
        """Digest of a data type as declared."""
        return self._plain.get(data_type, _digest_record)

    def object(self, declared: Object, type_closure: bytes) -> bytes:
        """Digest of an object with the data types it uses: equal digests resolve to equal entries."""
        key = (id(declared), type_closure)
        known = self._objects.get(key)
        if known is None:
            if len(self._objects) >= _MEMO_LIMIT:
                self._objects.clear()
            known = self._objects[key] = (declared, digest(_digest_record(declared) + type_closure))
        return known[1]

    def objects(self, dictionary: Dictionary) -> list[bytes]:
        """Digests of the objects of a dictionary in document order."""
        known = self._keys.get(id(dictionary))
        if known is None:
            closure = self.types(dictionary).closure
            if len(self._keys) >= _MAX_DICTIONARIES:
                self._keys.clear()
            known = (dictionary, [self.object(declared, closure(declared.type)) for declared in dictionary.objects])
            self._keys[id(dictionary)] = known
        return known[1]

    def types(self, dictionary: Dictionary) -> "DeclaredTypes":
        """The data types of a dictionary; dictionaries that declare the same ones share them."""
        found = self._types_of.get(id(dictionary))
        if found is not None:
            return found[1]
        if len(self._types_of) >= _MAX_DICTIONARIES:
            self._types_of.clear()
            self._types.clear()
        key = tuple(map(id, dictionary.data_types))
        known = self._types.get(key)
        if known is None:
            known = self._types[key] = DeclaredTypes(self, dictionary.data_types)
        self._types_of[id(dictionary)] = (dictionary, known)
        return known

    def dictionary(self, dictionary: Dictionary) -> bytes:
        """Digest of a dictionary: units, data types, objects."""
        return self._dictionaries.get(dictionary, self._dictionary)

    def _dictionary(self, dictionary: Dictionary) -> bytes:
        rest = _encode(msgspec.structs.replace(dictionary, data_types=(), objects=()))
        types = self.types(dictionary).digest
        return digest(rest + b"types" + types + b"objects" + b"".join(self.objects(dictionary)))

    def diagnostics(self, diagnostics: Diagnostics) -> bytes:
        """Digest of diagnosis texts."""
        return self._plain.get(diagnostics, _digest_record)

    def module(self, module: Module, vendor_id: int | None) -> bytes:
        """Digest of a module of a vendor."""
        return digest(_encode(vendor_id) + self._owner(module))

    def device(self, device: Device, vendor_id: int | None, modules: Iterable[bytes]) -> bytes:
        """Digest of a vendor's description: device and the digests of its reachable modules, without the group."""
        own = self._owner(msgspec.structs.replace(device, group_type=None))
        return digest(_encode(vendor_id) + own + b"".join(modules))

    def _owner(self, owner: Any) -> bytes:
        profiles = tuple(
            msgspec.structs.replace(profile, dictionary=None, diag_messages=None) for profile in owner.profiles
        )
        parts = [_encode(msgspec.structs.replace(owner, profiles=profiles))]
        for profile in owner.profiles:
            parts.append(self.dictionary(profile.dictionary) if profile.dictionary is not None else b"-")
            parts.append(self.diagnostics(profile.diag_messages) if profile.diag_messages is not None else b"-")
        return b"".join(parts)


class DeclaredTypes:
    """The data types of a dictionary with their digests."""

    def __init__(self, digests: Digests, data_types: tuple[DataType, ...]) -> None:
        self.by_name: Mapping[str, DataType] = type_table(data_types)
        self.digests = [digests.data_type(data_type) for data_type in data_types]
        self.digest = digest(b"".join(self.digests))
        self._digest_of = digests.data_type
        self._declared = data_types  # keeps the identities valid that this was found by
        self._closures: dict[str | None, bytes] = {None: b""}

    def closure(self, name: str | None) -> bytes:
        """Digest of the type ``name`` and everything it leads to; empty for a name that is not declared."""
        known = self._closures.get(name)
        if known is None:
            used = b"".join(map(self._digest_of, used_types(name, self.by_name)))
            known = self._closures[name] = digest(used) if used else b""
        return known


def _digest_record(record: Any) -> bytes:
    return digest(_encode(record))
