"""Values of entries: which type they have, by the entry and by the object dictionary, and what generators call it."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import DataType, Object
from esicatalog.esi.records.pdo import Entry
from esicatalog.esi.records.profile import Profile
from esicatalog.model.base_types import BaseType
from esicatalog.model.dictionary import ObjectEntry, resolve_base, resolve_object, type_table
from esicatalog.model.slots import ExpandedModule

CONTAINER_BITS = (8, 16, 32, 64)
_REAL_BITS = (32, 64)
_BYTE_KINDS = ("string", "octets", "unicode", "time", "guid", "domain")

_Declared = tuple[Object, Mapping[str, DataType]]
"""An object with the types of its dictionary."""


class ValueType(NamedTuple):
    """How a value is kept in a program. ``kind`` is int, uint, real or bytes.

    ``container_bits`` is the width of the variable that takes it, 0 for bytes.
    """

    kind: str
    bit_length: int
    container_bits: int

    @property
    def fills_container(self) -> bool:
        """Whether the value is exactly as wide as its variable."""
        return self.bit_length == self.container_bits


def value_type(base: BaseType | None, bit_length: int) -> ValueType:
    """The type of a value of ``bit_length`` bits; the length of the entry counts, not that of its type."""
    if base is not None and base.kind == "real" and bit_length in _REAL_BITS:
        return ValueType("real", bit_length, bit_length)
    if bit_length > CONTAINER_BITS[-1] or (base is not None and base.kind in _BYTE_KINDS and bit_length % 8 == 0):
        return ValueType("bytes", bit_length, 0)
    container_bits = next(bits for bits in CONTAINER_BITS if bits >= bit_length)
    return ValueType("int" if base is not None and base.signed else "uint", bit_length, container_bits)


class ObjectTable:
    """Objects of a device and its plugged modules by index, and the types that their entries name.

    Of several objects with the same index the device's counts before those of modules, unless the device marks it
    OverwrittenByModule (ESI-FACTS section 12). A type name means what the dictionary of its owner declares (section 6).
    """

    def __init__(self, device: Device, expanded: Iterable[ExpandedModule]) -> None:
        profiles: list[tuple[int | None, Profile]] = [(None, profile) for profile in device.profiles]
        profiles += [(item.slot_number, profile) for item in expanded for profile in item.module.profiles]
        self._types: dict[int | None, list[Mapping[str, DataType]]] = {}
        counting: list[_Declared] = []
        yielding: list[_Declared] = []
        for slot_number, profile in profiles:
            if (dictionary := profile.dictionary) is not None:
                types = type_table(dictionary.data_types)
                self._types.setdefault(slot_number, []).append(types)
                for declared in dictionary.objects:
                    yields = slot_number is None and declared.overwritten_by_module
                    (yielding if yields else counting).append((declared, types))
        self._objects: dict[int, _Declared] = {}
        for found in (*counting, *yielding):
            if found[0].object_index is not None:
                self._objects.setdefault(found[0].object_index, found)
        self._resolved: dict[int, dict[int, ObjectEntry]] = {}

    def entry(self, index: int, subindex: int) -> ObjectEntry | None:
        """The resolved entry of an object, None when no dictionary declares it."""
        return self._entries(index).get(subindex)

    def highest_subindex(self, index: int) -> int | None:
        """The last subindex of an object, None when no dictionary declares it."""
        return max(self._entries(index), default=None)

    def _entries(self, index: int) -> Mapping[int, ObjectEntry]:
        if index not in self._resolved:
            found = self._objects.get(index)
            resolved = resolve_object(*found).entries if found is not None else ()
            self._resolved[index] = {item.subindex: item for item in resolved}
        return self._resolved[index]

    def base_type(self, entry: Entry, slot_number: int | None) -> BaseType | None:
        """Base type of an entry of the module in a slot, None for the device: by its DataType, else by its object."""
        for types in self._types.get(slot_number, [{}]):
            base = resolve_base(entry.data_type, types)
            if base is not None:
                return base
        declared = self.entry(entry.entry_index, entry.subindex or 0) if entry.entry_index else None
        return resolve_base(declared.base_type, {}) if declared is not None else None
