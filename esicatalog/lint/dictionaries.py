"""Objects as the rules see them: resolved only where a rule has to look at their entries."""

from collections.abc import Sequence

from esicatalog.esi.records.dictionary import DeclaredValues, InfoSubItem, Object, SubItem
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject
from esicatalog.model.dictionary_views import Resolver, TypeSet


class ObjectSubject:
    """An object of a dictionary and the data types around it."""

    def __init__(self, declared: Object, types: TypeSet, resolver: "Resolver") -> None:
        self.declared = declared
        self.types = types
        self._resolver = resolver
        self._with_values: Sequence[ObjectEntry] | None = None

    @property
    def resolved(self) -> ResolvedObject:
        """The object with its entries."""
        return self._resolver.resolve(self.declared, self.types)

    @property
    def with_values(self) -> Sequence[ObjectEntry]:
        """The entries that have a default, but none where nothing about the values can be wrong.

        Most objects have no values, or name every SubItem in order with a default of its length: they need not be
        resolved.
        """
        if self._with_values is None:
            entries = () if self._has_no_values or self.values_fit else self.resolved.entries
            self._with_values = [entry for entry in entries if entry.default_raw is not None]
        return self._with_values

    @property
    def _sub_items(self) -> Sequence[SubItem]:
        data_type = self.types.by_name.get(self.declared.type or "")
        return data_type.sub_items if data_type is not None else ()

    @property
    def _has_no_values(self) -> bool:
        declared = self.declared
        return not (declared.info_sub_items or _has_default(declared) or any(map(_has_default, self._sub_items)))

    @property
    def values_fit(self) -> bool:
        """Whether Info names every SubItem in order, each with a default of its length and without limits."""
        infos, sub_items = self.declared.info_sub_items, self._sub_items
        return len(infos) == len(sub_items) > 0 and all(map(_fits, infos, sub_items))


def _fits(info: InfoSubItem, sub_item: SubItem) -> bool:
    data, bits = info.default_data, sub_item.bit_size
    return (
        info.name == sub_item.name
        and bits is not None
        and (not data or len(data) == 2 * ((bits + 7) // 8))
        and info.default_string is None
        and info.default_value is None
        and info.min_value is None
        and info.max_value is None
        and not info.min_data
        and not info.max_data
    )


def _has_default(values: DeclaredValues | SubItem) -> bool:
    return bool(values.default_data) or values.default_value is not None or values.default_string is not None
