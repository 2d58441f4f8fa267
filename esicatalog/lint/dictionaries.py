"""Objects as the rules see them: resolved only where a rule has to look at their entries."""

from collections.abc import Sequence
from functools import cached_property

from esicatalog.esi.records.dictionary import DeclaredValues, Object, SubItem
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject
from esicatalog.model.dictionary_views import Resolver, TypeSet


class ObjectSubject:
    """An object of a dictionary and the data types around it."""

    def __init__(self, declared: Object, types: TypeSet, resolver: Resolver) -> None:
        self.declared = declared
        self.types = types
        self._resolver = resolver

    @cached_property
    def resolved(self) -> ResolvedObject:
        """The object with its entries."""
        return self._resolver.resolve(self.declared, self.types)

    @cached_property
    def with_values(self) -> Sequence[ObjectEntry]:
        """The entries that have a default, but none where nothing about the values can be wrong.

        Most objects have no values, a number without limits, or in every SubItem a default of its length: they need
        not be resolved.
        """
        if self.values_fit or self._values_are_harmless:
            return ()
        return [entry for entry in self.resolved.entries if entry.default_raw is not None]

    @cached_property
    def _sub_items(self) -> Sequence[SubItem]:
        data_type = self.types.by_name.get(self.declared.type or "")
        return data_type.sub_items if data_type is not None else ()

    @cached_property
    def values_fit(self) -> bool:
        """Whether Info names every SubItem in order, each with nothing but a default of its length."""
        return self._names_all and all(
            sub_item.bit_size is not None and info.default_value is None and _is_harmless(info, sub_item.bit_size)
            for info, sub_item in zip(self.declared.info_sub_items, self._sub_items, strict=True)
        )

    @cached_property
    def is_paired(self) -> bool:
        """Whether Info names every SubItem in order, and none of these stands for the elements of an array."""
        return self._names_all and not any(self._is_array(sub_item.type) for sub_item in self._sub_items)

    @cached_property
    def _names_all(self) -> bool:
        infos, sub_items = self.declared.info_sub_items, self._sub_items
        return len(infos) == len(sub_items) > 0 and all(
            info.name == sub_item.name for info, sub_item in zip(infos, sub_items, strict=True)
        )

    def _is_array(self, type_name: str | None) -> bool:
        data_type = self.types.by_name.get(type_name or "")
        return data_type is not None and bool(data_type.array_infos)

    @property
    def _values_are_harmless(self) -> bool:
        declared, sub_items = self.declared, self._sub_items
        infos = declared.info_sub_items
        if not sub_items:
            return not infos and _is_harmless(declared, declared.bit_size)
        if not all(_is_harmless(sub_item) for sub_item in sub_items):
            return False
        if self.is_paired:
            return all(map(_is_harmless, infos, (sub_item.bit_size for sub_item in sub_items)))
        return all(map(_is_harmless, infos))


def _is_harmless(values: DeclaredValues | SubItem, bit_size: int | None = None) -> bool:
    """Whether there are neither limits nor a text, and bytes only as many as a known size asks for."""
    data = values.default_data
    return (
        (not data or (bit_size is not None and len(data) == 2 * ((bit_size + 7) // 8)))
        and values.default_string is None
        and values.min_value is None
        and values.max_value is None
        and (isinstance(values, SubItem) or not (values.min_data or values.max_data))
    )
