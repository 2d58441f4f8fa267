"""Objects as the rules see them: resolved only where a rule has to look at their entries."""

from collections.abc import Sequence
from functools import cached_property
from itertools import starmap
from operator import attrgetter
from typing import NamedTuple

from esicatalog.esi.records.dictionary import DataType, DeclaredValues, InfoSubItem, Object, SubItem
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject
from esicatalog.model.resolver import Resolver, TypeSet
from esicatalog.model.values import byte_length

_Pairs = Sequence[tuple[InfoSubItem, int | None]]

_name = attrgetter("name")
_values_of_sub_item = attrgetter("default_data", "default_value", "default_string", "min_value", "max_value")
_BIT_0 = ("00", "01")
_NO_VALUES = frozenset({(None, None, None, None, None), ("", None, None, None, None)})


class ObjectSubject(NamedTuple):
    """An object that is not as its type says: this is not declared or has another size."""

    declared: Object
    data_type: DataType | None


class DataTypeSubject(NamedTuple):
    """A data type with those of its SubItems; None stands for one that the dictionary does not declare."""

    data_type: DataType
    of_sub_items: tuple[DataType | None, ...]


class ValuesOfType:
    """What the values of all objects of a data type with SubItems are held against."""

    def __init__(self, sub_items: Sequence[SubItem], types: TypeSet) -> None:
        self.names = list(map(_name, sub_items))
        self.sizes = [sub_item.bit_size for sub_item in sub_items]
        self.are_silent = _NO_VALUES.issuperset(map(_values_of_sub_item, sub_items))
        """Whether the SubItems have no values of their own, as it should be."""
        used = [types.by_name.get(sub_item.type or "") for sub_item in sub_items]
        self.may_be_expanded = any(data_type is not None and data_type.array_infos for data_type in used)
        """Whether a SubItem may stand for all elements of an array."""


class ObjectValues:
    """What an object of a dictionary declares about its values; ``of_type`` is None where its type has no SubItems."""

    def __init__(self, declared: Object, of_type: ValuesOfType | None, types: TypeSet, resolver: Resolver) -> None:
        self.declared = declared
        self._types = types
        self._resolver = resolver
        infos = declared.info_sub_items
        self._pairs: _Pairs | None = () if not infos else _paired(infos, of_type) if of_type is not None else None
        self._are_harmless = (
            not infos and _is_harmless(declared, declared.bit_size)
            if of_type is None
            else of_type.are_silent and not declared.default_data and self._infos_are_harmless()
        )

    @property
    def is_paired(self) -> bool:
        """Whether every SubItem of Info has the name of one SubItem of the type, each another one."""
        return self._pairs is not None

    @property
    def is_sound(self) -> bool:
        """Whether nothing about the values can be wrong, so that no rule needs to look at them.

        Most objects have no values, small numbers without limits, or defaults as long as their SubItems: they need not
        be resolved.
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

    def _infos_are_harmless(self) -> bool:
        if self._pairs is None:
            return all(_is_harmless(info, None) for info in self.declared.info_sub_items)
        return all(starmap(_is_harmless, self._pairs))


def _paired(infos: Sequence[InfoSubItem], of_type: ValuesOfType) -> _Pairs | None:
    """Values with the sizes of the SubItems that they belong to, where names alone tell it."""
    in_order = list(map(_name, infos)) == of_type.names
    if in_order:
        pairs = list(zip(infos, of_type.sizes, strict=True))
    else:
        by_name = dict(zip(of_type.names, of_type.sizes, strict=True))
        named = [info for info in infos if info.name in by_name]
        if len({info.name for info in named}) < len(infos) or len(by_name) < len(of_type.names):
            return None
        pairs = [(info, by_name[info.name]) for info in named]
    return None if of_type.may_be_expanded and not (in_order and _fit(pairs)) else pairs


def _fit(pairs: _Pairs) -> bool:
    """Whether nothing but bytes is given, as many as each SubItem has: then one stands for one."""
    return all(
        info.default_value is None and bit_size is not None and _is_harmless(info, bit_size) for info, bit_size in pairs
    )


def _is_harmless(values: DeclaredValues, bit_size: int | None) -> bool:
    """Whether there is no default, or one without limits that fits a known size: a number that is positive and needs
    not the highest bit, or as many bytes, of which all bits count or no more than the lowest is set.
    """
    data, number = values.default_data, values.default_value
    if not data:
        if number is None:
            if values.spelling and "default_value" in values.spelling:
                return False
            if values.default_string is None:
                return True
        elif bit_size is None or number < 0 or number.bit_length() >= bit_size:
            return False
    elif bit_size is None or len(data) != 2 * byte_length(bit_size) or (bit_size % 8 and data not in _BIT_0):
        return False
    return (
        values.default_string is None
        and values.min_value is None
        and values.max_value is None
        and not (values.min_data or values.max_data)
    )
