"""Objects as the rules see them: resolved only where a rule has to look at their entries."""

from collections.abc import Iterable, Sequence
from functools import cached_property
from operator import attrgetter
from typing import NamedTuple

from esicatalog.esi.records.dictionary import DeclaredValues, InfoSubItem, Object, SubItem
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject
from esicatalog.model.resolver import Resolver, TypeSet

_Pairs = Sequence[tuple[InfoSubItem, SubItem]]

_name = attrgetter("name")
_type = attrgetter("type")
_values_of_sub_item = attrgetter("default_data", "default_value", "default_string", "min_value", "max_value")
_NO_VALUES = frozenset({(None, None, None, None, None), ("", None, None, None, None)})


class ObjectSubject(NamedTuple):
    """An object of a dictionary as it is declared, and the data types around it."""

    declared: Object
    types: TypeSet


class ObjectValues:
    """What an object of a dictionary declares about its values."""

    def __init__(self, declared: Object, types: TypeSet, resolver: Resolver) -> None:
        self.declared = declared
        self._types = types
        self._resolver = resolver
        data_type = types.by_name.get(declared.type or "")
        self._sub_items: Sequence[SubItem] = data_type.sub_items if data_type is not None else ()
        infos = declared.info_sub_items
        self._pairs: _Pairs | None = (self._paired() if self._sub_items else None) if infos else ()
        self._are_harmless = self._sub_items_are_harmless() if self._sub_items else self._own_are_harmless()

    @property
    def is_paired(self) -> bool:
        """Whether every SubItem of Info has the name of one SubItem of the type, each another one."""
        return self._pairs is not None

    @property
    def is_sound(self) -> bool:
        """Whether nothing about the values can be wrong, so that no rule needs to look at them.

        Most objects have no values, numbers without limits, or defaults as long as their SubItems: they need not be
        resolved.
        """
        return self._are_harmless and self.is_paired

    @cached_property
    def resolved(self) -> ResolvedObject:
        """The object with its entries."""
        return self._resolver.resolve(self.declared, self._types)

    @cached_property
    def with_values(self) -> Sequence[ObjectEntry]:
        """The entries that have a default, but none where nothing about the values can be wrong."""
        entries = () if self._are_harmless else self.resolved.entries
        return [entry for entry in entries if entry.default_raw is not None]

    def _paired(self) -> _Pairs | None:
        """Values with the SubItems that they belong to, where names alone tell it."""
        infos, sub_items = self.declared.info_sub_items, self._sub_items
        in_order = list(map(_name, infos)) == list(map(_name, sub_items))
        if in_order:
            pairs = list(zip(infos, sub_items, strict=True))
        else:
            by_name = {sub_item.name: sub_item for sub_item in sub_items}
            pairs = [(info, by_name[info.name]) for info in infos if info.name in by_name]
            if len({info.name for info, _ in pairs}) < len(infos) or len(by_name) < len(sub_items):
                return None
        may_be_expanded = not self._types.arrays.isdisjoint(map(_type, sub_items))
        return None if may_be_expanded and not (in_order and _fit(pairs)) else pairs

    def _own_are_harmless(self) -> bool:
        declared = self.declared
        return not declared.info_sub_items and _is_harmless(declared, declared.bit_size)

    def _sub_items_are_harmless(self) -> bool:
        """A SubItem of a type should have no values of its own."""
        if not _NO_VALUES.issuperset(map(_values_of_sub_item, self._sub_items)):
            return False
        if self._pairs is not None:
            return all(_is_harmless(info, sub_item.bit_size) for info, sub_item in self._pairs)
        return all(_is_harmless(info, None) for info in self.declared.info_sub_items)


def _fit(pairs: Iterable[tuple[InfoSubItem, SubItem]]) -> bool:
    """Whether nothing but bytes is given, as many as each SubItem has: then one stands for one."""
    return all(
        info.default_value is None and sub_item.bit_size is not None and _is_harmless(info, sub_item.bit_size)
        for info, sub_item in pairs
    )


def _is_harmless(values: DeclaredValues, bit_size: int | None) -> bool:
    """Whether there is no default, or one without limits: a number, or as many bytes as a known size asks for."""
    data = values.default_data
    if not data and values.default_value is None and values.default_string is None:
        return True
    return (
        (not data or (bit_size is not None and len(data) == 2 * ((bit_size + 7) // 8)))
        and values.default_string is None
        and values.min_value is None
        and values.max_value is None
        and not (values.min_data or values.max_data)
    )
