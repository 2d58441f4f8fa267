"""Values of entries: which type they have, by the entry and by the object dictionary, and what generators call it."""

from collections.abc import Iterable
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.pdo import Entry
from esicatalog.model.base_types import BaseType
from esicatalog.model.dictionary import ObjectEntry, resolve_base
from esicatalog.model.dictionary_views import (
    DictionaryView,
    DictionaryViews,
    EntriesBySubindex,
    counting_view,
    object_yields,
)
from esicatalog.model.resolver import TypeSet
from esicatalog.model.slots import ExpandedModule

CONTAINER_BITS = (8, 16, 32, 64)
_REAL_BITS = (32, 64)
_BYTE_KINDS = ("string", "octets", "unicode", "time", "guid", "domain")

_NO_TYPES = TypeSet(())


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
        views = DictionaryViews()
        self._own = views.of(device.profiles)
        self._brought: list[DictionaryView] = []
        self._types: dict[int | None, list[TypeSet]] = {None: [view.types for view in self._own]}
        for item in expanded:
            found = views.of(item.module.profiles)
            self._brought += found
            self._types.setdefault(item.slot_number, []).extend(view.types for view in found)

    def entry(self, index: int, subindex: int) -> ObjectEntry | None:
        """The resolved entry of an object, None when no dictionary declares it."""
        return self.entries(index).get(subindex)

    def highest_subindex(self, index: int) -> int | None:
        """The last subindex of an object, None when no dictionary declares it."""
        return max(self.entries(index), default=None)

    def entries(self, index: int) -> EntriesBySubindex:
        """The resolved entries of an object by subindex, none when no dictionary declares it."""
        own, brought = (counting_view(views, index) for views in (self._own, self._brought))
        if own is None or (brought is not None and object_yields(own.by_index[index], brought.by_index)):
            own = brought
        return (own.entries(index) if own is not None else None) or {}

    def base_type(self, entry: Entry, slot_number: int | None) -> BaseType | None:
        """Base type of an entry of the module in a slot, None for the device: by its DataType, else by its object."""
        for types in self._types.get(slot_number) or [_NO_TYPES]:
            base = resolve_base(entry.data_type, types.by_name)
            if base is not None:
                return base
        declared = self.entry(entry.entry_index, entry.subindex or 0) if entry.entry_index else None
        return resolve_base(declared.base_type, {}) if declared is not None else None
