"""Objects as the rules see them: resolved only where a rule has to look at their entries."""

from collections.abc import Iterable, Sequence

from esicatalog.esi.records.dictionary import DeclaredValues, InfoSubItem, Object, SubItem
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject
from esicatalog.model.resolver import Resolver, TypeSet

_Pairs = Sequence[tuple[InfoSubItem, SubItem]]


class ObjectSubject:
    """An object of a dictionary and the data types around it."""

    def __init__(self, declared: Object, types: TypeSet, resolver: Resolver) -> None:
        self.declared = declared
        self.types = types
        self._resolver = resolver
        data_type = types.by_name.get(declared.type or "")
        self._sub_items: Sequence[SubItem] = data_type.sub_items if data_type is not None else ()
        self._pairs = self._paired() if declared.info_sub_items and self._sub_items else None
        self._resolved: ResolvedObject | None = None
        self._with_values: Sequence[ObjectEntry] | None = None

    @property
    def resolved(self) -> ResolvedObject:
        """The object with its entries."""
        if self._resolved is None:
            self._resolved = self._resolver.resolve(self.declared, self.types)
        return self._resolved

    @property
    def is_paired(self) -> bool:
        """Whether every SubItem of Info has the name of one SubItem of the type, each another one."""
        return self._pairs is not None

    @property
    def with_values(self) -> Sequence[ObjectEntry]:
        """The entries that have a default, but none where nothing about the values can be wrong.

        Most objects have no values, numbers without limits, or defaults as long as their SubItems: they need not be
        resolved.
        """
        if self._with_values is None:
            entries = () if self._values_are_harmless() else self.resolved.entries
            self._with_values = [entry for entry in entries if entry.default_raw is not None]
        return self._with_values

    def _paired(self) -> _Pairs | None:
        """Values with the SubItems that they belong to, where names alone tell it."""
        infos, sub_items = self.declared.info_sub_items, self._sub_items
        pairs = list(zip(infos, sub_items, strict=False))
        in_order = len(infos) == len(sub_items) and all(info.name == sub_item.name for info, sub_item in pairs)
        if not in_order:
            by_name = {sub_item.name: sub_item for sub_item in sub_items}
            pairs = [(info, by_name[info.name]) for info in infos if info.name in by_name]
            if len({info.name for info, _ in pairs}) < len(infos) or len(by_name) < len(sub_items):
                return None
        if any(map(self._is_expanded, sub_items)) and not (in_order and _fit(pairs)):
            return None
        return pairs

    def _is_expanded(self, sub_item: SubItem) -> bool:
        """Whether a SubItem may stand for all elements of an array."""
        data_type = self.types.by_name.get(sub_item.type or "")
        return data_type is not None and bool(data_type.array_infos)

    def _values_are_harmless(self) -> bool:
        declared = self.declared
        if not self._sub_items:
            return not declared.info_sub_items and _is_harmless(declared, declared.bit_size)
        if not all(map(_says_nothing, self._sub_items)):
            return False
        if self._pairs is not None:
            return all(_is_harmless(info, sub_item.bit_size) for info, sub_item in self._pairs)
        return all(_is_harmless(info, None) for info in declared.info_sub_items)


def _fit(pairs: Iterable[tuple[InfoSubItem, SubItem]]) -> bool:
    """Whether nothing but bytes is given, as many as each SubItem has: then one stands for one."""
    return all(
        info.default_value is None and sub_item.bit_size is not None and _is_harmless(info, sub_item.bit_size)
        for info, sub_item in pairs
    )


def _says_nothing(sub_item: SubItem) -> bool:
    """Whether a SubItem of a type has no values of its own, as it should."""
    return not _has_default(sub_item) and sub_item.min_value is None and sub_item.max_value is None


def _has_default(values: DeclaredValues | SubItem) -> bool:
    return bool(values.default_data) or values.default_value is not None or values.default_string is not None


def _is_harmless(values: DeclaredValues, bit_size: int | None) -> bool:
    """Whether there is no default, or one without limits: a number, or as many bytes as a known size asks for."""
    data = values.default_data
    return not _has_default(values) or (
        (not data or (bit_size is not None and len(data) == 2 * ((bit_size + 7) // 8)))
        and values.default_string is None
        and values.min_value is None
        and values.max_value is None
        and not (values.min_data or values.max_data)
    )
