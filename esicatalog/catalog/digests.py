"""Content digests of everything the catalog stores once per distinct content.

The content of a device description is the Device, its dictionaries and the modules its slots can reach, without
vendor name, group, file version and line.
"""

from collections.abc import Iterable
from typing import Any

import msgspec

from esicatalog.esi.content import digest
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import Diagnostics
from esicatalog.esi.records.dictionary import DataType, Dictionary, Object
from esicatalog.esi.records.module import Module
from esicatalog.model.memo import IdentityMemo, identities
from esicatalog.model.resolver import Resolver, TypeSet

_encode = msgspec.msgpack.Encoder().encode
_MEMO_LIMIT = 200_000
_MAX_DICTIONARIES = 2_000


class Digests:
    """Computes digests; records that were seen before (the reader reuses them) cost nothing."""

    def __init__(self, resolver: Resolver | None = None) -> None:
        self._resolver = resolver or Resolver()
        self._plain: IdentityMemo[bytes] = IdentityMemo(_MEMO_LIMIT)
        self._objects: IdentityMemo[bytes] = IdentityMemo(_MEMO_LIMIT)
        self._type_sets: IdentityMemo[TypeSetDigests] = IdentityMemo(_MAX_DICTIONARIES)
        self._object_lists: IdentityMemo[list[bytes]] = IdentityMemo(_MAX_DICTIONARIES)
        self._dictionaries: IdentityMemo[bytes] = IdentityMemo(_MAX_DICTIONARIES)

    def data_type(self, data_type: DataType) -> bytes:
        """Digest of a data type as declared."""
        return self._plain.of(data_type, _digest_record)

    def objects(self, dictionary: Dictionary) -> list[bytes]:
        """Digests of the objects of a dictionary, with the data types they use, in document order.

        Equal digests resolve to equal entries.
        """
        types = self.types(dictionary)
        key = (id(types), identities(dictionary.objects))
        return self._object_lists.get(key, (types, dictionary), self._object_list, dictionary, types)

    def _object_list(self, dictionary: Dictionary, types: "TypeSetDigests") -> list[bytes]:
        closures, digest_of = types.closures, self._objects.get
        return [
            digest_of((id(declared), closure := closures[declared.type]), declared, _digest_object, declared, closure)
            for declared in dictionary.objects
        ]

    def types(self, dictionary: Dictionary) -> "TypeSetDigests":
        """Digests of the data types of a dictionary."""
        return self._type_sets.of(self._resolver.types(dictionary), self._digest_types)

    def _digest_types(self, types: TypeSet) -> "TypeSetDigests":
        return TypeSetDigests(self, types)

    def dictionary(self, dictionary: Dictionary) -> bytes:
        """Digest of a dictionary: units, data types, objects."""
        return self._dictionaries.of(dictionary, self._dictionary)

    def _dictionary(self, dictionary: Dictionary) -> bytes:
        rest = _encode(msgspec.structs.replace(dictionary, data_types=(), objects=()))
        types = self.types(dictionary).digest
        return digest(rest + b"types" + types + b"objects" + b"".join(self.objects(dictionary)))

    def diagnostics(self, diagnostics: Diagnostics) -> bytes:
        """Digest of diagnosis texts."""
        return self._plain.of(diagnostics, _digest_record)

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


class TypeSetDigests:
    """The data types of a dictionary with their digests."""

    def __init__(self, digests: Digests, types: TypeSet) -> None:
        self.types = types
        self.digests = [digests.data_type(data_type) for data_type in types.data_types]
        self.digest = digest(b"".join(self.digests))
        self.closures = _Closures(digests, types)
        """By the name of a type: digest of the type and everything it leads to; empty when it is not declared."""


class _Closures(dict[str | None, bytes]):
    def __init__(self, digests: Digests, types: TypeSet) -> None:
        super().__init__()
        self._digest_of = digests.data_type
        self._used = types.used

    def __missing__(self, name: str | None) -> bytes:
        used = b"".join(map(self._digest_of, self._used(name)))
        known = self[name] = digest(used) if used else b""
        return known


def _digest_object(declared: Object, closure: bytes) -> bytes:
    return digest(_digest_record(declared) + closure)


def _digest_record(record: Any) -> bytes:
    return digest(_encode(record))
