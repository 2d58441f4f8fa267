"""Dictionaries looked at as a whole: objects by index, resolved when asked for; equal ones are looked at once."""

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from esicatalog.esi.records.dictionary import DataType, Dictionary, Object
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject, resolve_object, type_table, used_types
from esicatalog.model.memo import IdentityMemo, identities

EntriesBySubindex = Mapping[int, ObjectEntry]
Result = TypeVar("Result")

_MAX_VIEWS = 500
_MAX_RESOLVED = 4_000


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
        self._results: dict[Any, Any] = {}

    def once(self, function: Callable[["DictionaryView"], Result]) -> Result:
        """What a function gives for this view; it is called once."""
        if function not in self._results:
            self._results[function] = function(self)
        result: Result = self._results[function]
        return result

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
        self._of_dictionary: IdentityMemo[DictionaryView] = IdentityMemo(_MAX_VIEWS)
        self._types: IdentityMemo[TypeSet] = IdentityMemo(_MAX_VIEWS)
        self._views: IdentityMemo[DictionaryView] = IdentityMemo(_MAX_VIEWS)
        self.resolver = Resolver()

    def view(self, dictionary: Dictionary) -> DictionaryView:
        """The view of a dictionary."""
        return self._of_dictionary.get(id(dictionary), dictionary, self._view, dictionary)

    def _view(self, dictionary: Dictionary) -> DictionaryView:
        data_types = dictionary.data_types
        types = self._types.get(identities(data_types), data_types, TypeSet, data_types)
        key = (id(types), identities(dictionary.objects))
        return self._views.get(key, (types, dictionary), DictionaryView, dictionary, types, self.resolver)
