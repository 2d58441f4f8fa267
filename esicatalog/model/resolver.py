"""Resolving the objects of many dictionaries: what they have in common is worked out once.

The reader gives the same record for the same words, so identity tells what was seen before.
"""

from collections.abc import Callable, Mapping
from functools import cache

from esicatalog.esi.records.dictionary import DataType, Dictionary, Object
from esicatalog.model.dictionary import EntryMemo, ObjectType, ResolvedObject, type_table, used_types
from esicatalog.model.memo import IdentityMemo, identities

_MAX_TYPE_SETS = 2_000
_MAX_RESOLVED = 10_000
_MAX_OBJECT_TYPES = 5_000


class TypeSet:
    """The data types of one or several equal dictionaries."""

    def __init__(self, data_types: tuple[DataType, ...]) -> None:
        self.data_types = data_types
        self.by_name: Mapping[str, DataType] = type_table(data_types)
        by_name = self.by_name
        self.used: Callable[[str | None], tuple[DataType, ...]] = cache(lambda name: used_types(name, by_name))
        """The declared types that a type name leads to, itself first."""
        used = self.used
        self.closure: Callable[[str | None], tuple[int, ...]] = cache(lambda name: identities(used(name)))
        """Identities of the declared types that a type name leads to: equal closures mean the same."""


class Resolver:
    """Resolves objects; equal members with equal values share their entry, also between objects."""

    def __init__(self) -> None:
        self._memo = EntryMemo()
        self._of_dictionary: IdentityMemo[TypeSet] = IdentityMemo(_MAX_TYPE_SETS)
        self._type_sets: IdentityMemo[TypeSet] = IdentityMemo(_MAX_TYPE_SETS)
        self._object_types: IdentityMemo[ObjectType] = IdentityMemo(_MAX_OBJECT_TYPES)
        self._resolved: IdentityMemo[ResolvedObject] = IdentityMemo(_MAX_RESOLVED)

    def types(self, dictionary: Dictionary) -> TypeSet:
        """The data types of a dictionary; dictionaries that declare the same ones share them."""
        return self._of_dictionary.of(dictionary, self._types)

    def _types(self, dictionary: Dictionary) -> TypeSet:
        data_types = dictionary.data_types
        return self._type_sets.get(identities(data_types), data_types, TypeSet, data_types)

    def resolve(self, declared: Object, types: TypeSet) -> ResolvedObject:
        """The object with its entries."""
        key = (id(declared), types.closure(declared.type))
        return self._resolved.get(key, (declared, types), self._resolve, declared, types)

    def _resolve(self, declared: Object, types: TypeSet) -> ResolvedObject:
        name = declared.type
        key = (name, types.closure(name))
        object_type = self._object_types.get(key, types, ObjectType, name, types.by_name, self._memo)
        return object_type.resolve(declared)
