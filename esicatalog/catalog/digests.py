"""Content digests of everything the catalog stores once per distinct content.

The content of a device description is the Device, its dictionaries and the modules its slots can reach, without
vendor name, group, file version and line.
"""

from collections.abc import Callable, Iterable
from functools import cache
from typing import Any

import msgspec

from esicatalog.esi.content import digest
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import Diagnostics
from esicatalog.esi.records.dictionary import DataType, Dictionary, Object
from esicatalog.esi.records.module import Module
from esicatalog.model.memo import IdentityMemo, identities
from esicatalog.model.resolver import Resolver, TypeSet

_encode = msgspec.msgpack.Encoder(order="deterministic").encode
"""Whatever the order of attributes, which spellings have too: it means nothing in XML."""
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

    def data_types(self, data_types: Iterable[DataType]) -> list[bytes]:
        """Digests of data types as declared."""
        return self._plain.of_all(data_types, _digest_record)

    def objects(self, dictionary: Dictionary) -> list[bytes]:
        """Digests of the objects of a dictionary, with the data types they use, in document order.

        Equal digests resolve to equal entries.
        """
        types = self.types(dictionary)
        key = (id(types), identities(dictionary.objects))
        return self._object_lists.get(key, (types, dictionary), self._object_list, dictionary, types)

    def _object_list(self, dictionary: Dictionary, types: "TypeSetDigests") -> list[bytes]:
        objects = dictionary.objects
        closures = [types.closure(declared.type) for declared in objects]
        return self._objects.get_all(zip(map(id, objects), closures, strict=True), objects, _digest_object)

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
        self.digests = digests.data_types(types.data_types)
        self.digest = digest(b"".join(self.digests))
        known, used = dict(zip(map(id, types.data_types), self.digests, strict=True)), types.closure
        self.closure: Callable[[str | None], bytes] = cache(
            lambda name: digest(b"".join([known[place] for place in places])) if (places := used(name)) else b""
        )
        """Digest of a type, by name, and everything it leads to; empty for a name that is not declared."""


def _digest_object(declared: Object, key: tuple[int, bytes]) -> bytes:
    _, closure = key
    return digest(_digest_record(declared) + closure)


def _digest_record(record: Any) -> bytes:
    return digest(_encode(record))
