"""Dictionaries as the rules see them: objects by index, resolved when asked for; equal ones are looked at once.

The reader gives the same record for the same subtree, so identity tells what was seen before.
"""

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from typing import Any, Generic, TypeVar

from esicatalog.esi.records.dictionary import DataType, DeclaredValues, Dictionary, InfoSubItem, Object, SubItem
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject, resolve_object, type_table, used_types

EntriesBySubindex = Mapping[int, ObjectEntry]
Result = TypeVar("Result")

_MAX_VIEWS = 128
_MAX_RESOLVED = 2_000


class IdentityMemo(Generic[Result]):
    """Results by the identity of records, which are held so that their identities stay valid; starts anew when full."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._known: dict[Hashable, tuple[Any, Result]] = {}

    def get(self, key: Hashable, records: Any, compute: Callable[..., Result], *arguments: Any) -> Result:
        """The result for a key made of identities of ``records``."""
        known = self._known.get(key)
        if known is None:
            known = (records, compute(*arguments))
            if len(self._known) >= self._limit:
                self._known.clear()
            self._known[key] = known
        return known[1]


def identities(records: Iterable[Any]) -> tuple[int, ...]:
    """What tells records apart."""
    return tuple(map(id, records))


class TypeSet:
    """The data types of one or several equal dictionaries."""

    def __init__(self, data_types: tuple[DataType, ...]) -> None:
        self.data_types = data_types
        self.by_name: Mapping[str, DataType] = type_table(data_types)
        self._closures: dict[str | None, tuple[int, ...]] = {}

    def closure(self, name: str | None) -> tuple[int, ...]:
        """Identities of the declared types that a type name leads to."""
        found = self._closures.get(name)
        if found is None:
            found = self._closures[name] = identities(used_types(name, self.by_name))
        return found


class Resolver:
    """Resolves objects; what was asked for lately is not resolved again."""

    def __init__(self) -> None:
        self._resolved: IdentityMemo[ResolvedObject] = IdentityMemo(_MAX_RESOLVED)

    def resolve(self, declared: Object, types: TypeSet) -> ResolvedObject:
        """The object with its entries."""
        key = (id(declared), types.closure(declared.type))
        return self._resolved.get(key, (declared, types), resolve_object, declared, types.by_name)


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


class DictionaryView:
    """A dictionary with its objects by index; of several with one index the first counts."""

    def __init__(self, dictionary: Dictionary, types: TypeSet, resolver: Resolver) -> None:
        self.dictionary = dictionary
        self.types = types
        self.by_index: dict[int, Object] = {}
        for declared in dictionary.objects:
            if declared.object_index is not None:
                self.by_index.setdefault(declared.object_index, declared)
        self._resolver = resolver
        self._entries: dict[int, EntriesBySubindex] = {}

    def entries(self, index: int) -> EntriesBySubindex | None:
        """Entries of an object by subindex, None when the dictionary has no such object."""
        found = self._entries.get(index)
        if found is None and (declared := self.by_index.get(index)) is not None:
            resolved = self._resolver.resolve(declared, self.types)
            found = self._entries[index] = {entry.subindex: entry for entry in reversed(resolved.entries)}
        return found


class DictionaryViews:
    """Makes views; dictionaries of the same data types and objects share one."""

    def __init__(self) -> None:
        self._types: IdentityMemo[TypeSet] = IdentityMemo(_MAX_VIEWS)
        self._views: IdentityMemo[DictionaryView] = IdentityMemo(_MAX_VIEWS)
        self.resolver = Resolver()

    def view(self, dictionary: Dictionary) -> DictionaryView:
        """The view of a dictionary."""
        data_types = dictionary.data_types
        types = self._types.get(identities(data_types), data_types, TypeSet, data_types)
        key = (id(types), identities(dictionary.objects))
        return self._views.get(key, (types, dictionary), DictionaryView, dictionary, types, self.resolver)
