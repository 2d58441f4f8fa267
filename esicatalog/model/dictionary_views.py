"""Dictionaries looked at as a whole: objects by index, resolved when asked for; equal ones are looked at once."""

from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Any, TypeVar

from esicatalog.esi.records.dictionary import Dictionary, Object
from esicatalog.esi.records.profile import Profile, dictionaries_of
from esicatalog.model.dictionary import ObjectEntry, ResolvedObject
from esicatalog.model.memo import IdentityMemo, identities
from esicatalog.model.resolver import Resolver, TypeSet

EntriesBySubindex = Mapping[int, ObjectEntry]
Result = TypeVar("Result")

_MAX_VIEWS = 500


class DictionaryView:
    """A dictionary with its objects by index; of several with one index the first counts."""

    def __init__(self, dictionary: Dictionary, types: TypeSet, resolver: Resolver) -> None:
        self.dictionary = dictionary
        self.types = types
        self.by_index: dict[int, Object] = {
            declared.object_index: declared
            for declared in reversed(dictionary.objects)
            if declared.object_index is not None
        }
        self._resolver = resolver
        self._entries: dict[int, EntriesBySubindex] = {}
        self._results: dict[Any, Any] = {}

    def once(self, function: Callable[["DictionaryView"], Result]) -> Result:
        """What a function gives for this view; it is called once."""
        if function not in self._results:
            self._results[function] = function(self)
        result: Result = self._results[function]
        return result

    def resolved(self, index: int) -> ResolvedObject | None:
        """An object with its entries, None when the dictionary has no such object."""
        declared = self.by_index.get(index)
        return self._resolver.resolve(declared, self.types) if declared is not None else None

    def single(self, index: int) -> ObjectEntry | None:
        """The value of an object that is a single one; subindex 0 of an array or a record is the number of its entries.

        None for these, and when the dictionary has no such object.
        """
        found = self.resolved(index)
        return found.entries[0] if found is not None and len(found.entries) == 1 else None

    def entries(self, index: int) -> EntriesBySubindex | None:
        """Entries of an object by subindex, None when the dictionary has no such object."""
        found = self._entries.get(index)
        if found is None and (resolved := self.resolved(index)) is not None:
            found = self._entries[index] = {entry.subindex: entry for entry in reversed(resolved.entries)}
        return found


def object_yields(declared: Object, of_modules: Collection[int | None]) -> bool:
    """Whether an object of the device gives way to one of modules, whose indices are given (ESI-FACTS section 12)."""
    return bool(declared.overwritten_by_module) and declared.object_index in of_modules


def counting_view(views: Iterable[DictionaryView], index: int) -> DictionaryView | None:
    """The dictionary of an owner whose object of this index counts: the first that does not yield to those of modules.

    An object that is marked OverwrittenByModule (ESI-FACTS section 12) counts where no other is. None without any.
    """
    return next(iter(counting_views(views, index)), None)


def counting_views(views: Iterable[DictionaryView], index: int) -> list[DictionaryView]:
    """All dictionaries of an owner with an object of this index, in the order in which their objects count."""
    found = [view for view in views if index in view.by_index]
    return sorted(found, key=lambda view: bool(view.by_index[index].overwritten_by_module))


class DictionaryViews:
    """Makes views; dictionaries of the same data types and objects share one."""

    def __init__(self, resolver: Resolver | None = None) -> None:
        self.resolver = resolver or Resolver()
        self._of_dictionary: IdentityMemo[DictionaryView] = IdentityMemo(_MAX_VIEWS)
        self._views: IdentityMemo[DictionaryView] = IdentityMemo(_MAX_VIEWS)

    def view(self, dictionary: Dictionary) -> DictionaryView:
        """The view of a dictionary."""
        return self._of_dictionary.of(dictionary, self._view)

    def of(self, profiles: Iterable[Profile]) -> tuple[DictionaryView, ...]:
        """The views of the dictionaries that profiles have."""
        return tuple(map(self.view, dictionaries_of(profiles)))

    def _view(self, dictionary: Dictionary) -> DictionaryView:
        types = self.resolver.types(dictionary)
        key = (id(types), identities(dictionary.objects))
        return self._views.get(key, (types, dictionary), DictionaryView, dictionary, types, self.resolver)
