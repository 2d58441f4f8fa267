"""Comparison of object dictionaries: objects by index, their entries by subindex."""

from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from esicatalog.esi.records.dictionary import DataType, Dictionary, EnumInfo, Flags, Object
from esicatalog.esi.records.profile import Profile, dictionaries_of
from esicatalog.esi.unreadable import unreadable_values
from esicatalog.model.access import BACKUP, READ, SETTING, STATE_WORDS, WRITE, access_text, rights
from esicatalog.model.cia402 import AXIS_STEP, SUPPORTED_DRIVE_MODES
from esicatalog.model.compare_facts import (
    OBJECTS,
    Difference,
    Fact,
    always,
    compare_facts,
    contradicted,
    difference,
    either,
    lost,
    lost_items,
    lowered,
    matched,
    never,
    raised,
)
from esicatalog.model.compare_words import (
    h4,
    h8,
    listed,
    literal,
    records,
    shown_text,
    text,
    unit,
    value_of,
    yes_no,
)
from esicatalog.model.dictionary import (
    OBJECT_CODES,
    ObjectEntry,
    ResolvedObject,
    data_beside_entries,
    resolve_object,
    type_table,
    used_types,
)
from esicatalog.model.values import number_words
from esicatalog.words import counted

_ACCESS_WORDS = {READ: "ro", WRITE: "wo", READ | WRITE: "rw"}
_MAPPING_WORDS = {"R": "RxPDO", "T": "TxPDO", "RT": "RxPDO and TxPDO"}
_CODE_WORDS = {code: words for words, code in OBJECT_CODES.items()}


def _number(value: int | float | None) -> str | None:
    return number_words(value) if isinstance(value, int) else text(value)


def _default(entry: ObjectEntry) -> str | None:
    """The default by its value, however it is written; as bytes where the type does not tell the value."""
    number = entry.default_int if entry.default_int is not None else entry.default_real
    if number is not None:
        return _number(number)
    if entry.default_text is not None:
        return literal(entry.default_text)
    return entry.default_raw.upper() if entry.default_raw else None


def _minimum(entry: ObjectEntry) -> int | float | None:
    return entry.min_int if entry.min_int is not None else entry.min_real


def _maximum(entry: ObjectEntry) -> int | float | None:
    return entry.max_int if entry.max_int is not None else entry.max_real


def _access(entry: ObjectEntry) -> int:
    return rights(entry.access_word)


def _access_words(word: int) -> str:
    """``ro``, ``rw``, ``wo``; ``rwrwr-`` where it depends on the state: read and write in PREOP, SAFEOP, OP."""
    return _ACCESS_WORDS.get(word) or f"{access_text(word)} ({STATE_WORDS})"


def _fewer_rights(left: int, right: int) -> bool:
    return bool(left & ~right)


def _category(entry: ObjectEntry) -> str:
    """Optional unless it says something else (ESI-FACTS section 7.3)."""
    return entry.category or "o"


def _type(entry: ObjectEntry) -> str | None:
    return entry.base_type or entry.data_type


_ENTRY = (
    Fact(_type, "type", always),
    Fact("bit_size", "size", always, unit("bit")),
    Fact(_access, "access", _fewer_rights, _access_words),
    Fact("pdo_mapping", "PDO mapping", lost_items, lambda letters: _MAPPING_WORDS.get(letters)),
    Fact("safety_mapping", "safety mapping", always),
    Fact("unit", "unit", lost, h8),
    Fact(_category, "category", never),
    Fact(lambda entry: bool(entry.access_word & BACKUP), "Backup", never, yes_no),
    Fact(lambda entry: bool(entry.access_word & SETTING), "Setting", never, yes_no),
    Fact("display_name", "display name", never),
)
_NAME = (Fact("name", "name", never),)
_PARAMETER_VALUES = (
    Fact(_default, "default", contradicted, lambda words: words),
    Fact(_minimum, "minimum", raised, _number),
    Fact(_maximum, "maximum", lowered, _number),
)
"""Of what a master can write: a configuration may leave the default, and its values have to be within the limits.

0x6502 is read-only, and yet its default says what the drive can do.
"""
_OTHER_VALUES = tuple(fact._replace(counts=never) for fact in _PARAMETER_VALUES)
_OBJECT = (
    Fact("names", "name", never, shown_text),
    Fact("depend_on_slot", "DependOnSlot", always, yes_no),
    Fact("depend_on_slot_group", "DependOnSlotGroup", always, yes_no),
    Fact("overwritten_by_module", "OverwrittenByModule", always, yes_no),
    Fact("scaling", "scaling", always),
)
_WHOLE_VALUES = (
    Fact("default_value", "default value", contradicted),
    Fact("default_string", "default text", contradicted, literal),
    Fact("min_data", "minimum data", always),
    Fact("min_value", "minimum", raised, _number),
    Fact("max_data", "maximum data", always),
    Fact("max_value", "maximum", lowered, _number),
    Fact("unit", "unit", lost, h8),
)
"""Of an object with subindices, which as a whole has values of its own in real files (ESI-FACTS section 7.1)."""
_WHOLE_SIZE = (Fact("bit_size", "size", never, unit("bit")),)
"""Of an object with subindices: told where its entries do not explain it, and nothing follows from it."""
_OBJECT_FLAGS = (
    Fact("sdo_access", "SdoAccess", lambda left, right: right != "CompleteAccess"),
    Fact("transition", "Transition", always),
    Fact("attribute", "attribute", always, h8),
)


class _Declared(NamedTuple):
    """An object with the data types of its dictionary."""

    object: Object
    types: dict[str, DataType]


def compare_objects(left: Iterable[Profile], right: Iterable[Profile]) -> Iterator[Difference]:
    """The objects of all dictionaries, by index and occurrence.

    One difference tells that a side has no dictionary. Objects that are equal with equal types cost nothing more.
    """
    dictionaries, others = dictionaries_of(left), dictionaries_of(right)
    if dictionaries == others:
        return
    objects, other_objects = _objects(dictionaries), _objects(others)
    if not objects or not other_objects:
        said, also = (counted(len(known), "object") if known else None for known in (objects, other_objects))
        if said != also:
            yield difference(OBJECTS, "object dictionary", said, also, lost(said, also))
        return
    units, other_units = (records(tuple(item.unit_types for item in known)) for known in (dictionaries, others))
    if units != other_units:
        yield difference(OBJECTS, "unit types", units, other_units, False)
    same_types = _type_comparison()
    pairs = matched(objects, other_objects, lambda item: value_of(item.object, "object_index"))
    for ours, theirs in sorted(pairs, key=lambda pair: either(*pair).object.object_index or 0):
        if ours is None or theirs is None:
            yield from _one_sided(ours, theirs)
        elif ours.object != theirs.object or not same_types(ours, theirs):
            yield from _compare_object(ours, theirs)


def _objects(dictionaries: Iterable[Dictionary]) -> list[_Declared]:
    tables = [(dictionary, type_table(dictionary.data_types)) for dictionary in dictionaries]
    return [_Declared(declared, types) for dictionary, types in tables for declared in dictionary.objects]


def _type_comparison() -> Callable[[_Declared, _Declared], bool]:
    """Whether the type of an object, with all types that it leads to, is the same on both sides."""
    known: dict[tuple[str | None, int, int], bool] = {}

    def same_types(left: _Declared, right: _Declared) -> bool:
        name = left.object.type
        key = (name, id(left.types), id(right.types))
        if key not in known:
            known[key] = used_types(name, left.types) == used_types(name, right.types)
        return known[key]

    return same_types


def _resolved(declared: _Declared) -> ResolvedObject:
    return resolve_object(declared.object, declared.types)


def _place(declared: _Declared) -> str:
    return h4(value_of(declared.object, "object_index")) or "without index"


def _one_sided(left: _Declared | None, right: _Declared | None) -> Iterator[Difference]:
    place = _place(either(left, right))
    said, also = (_object_words(_resolved(item)) if item is not None else None for item in (left, right))
    yield difference(OBJECTS, place, said, also, lost(left, right))


def _object_words(resolved: ResolvedObject) -> str:
    name = shown_text(resolved.object.names)
    if resolved.object_code != OBJECT_CODES["VAR"]:
        kind = f"{_CODE_WORDS[resolved.object_code]} with {counted(len(resolved.entries), 'subindex', 'subindices')}"
        return ", ".join(filter(None, (name, kind)))
    return ", ".join(filter(None, (name, *map(_entry_words, resolved.entries))))


def _entry_words(entry: ObjectEntry) -> str:
    size = f"{entry.bit_size} bit" if entry.bit_size is not None else None
    return ", ".join(filter(None, (_type(entry), size, _access_words(_access(entry)))))


def _compare_object(left: _Declared, right: _Declared) -> Iterator[Difference]:
    place = _place(left)
    yield from compare_facts(OBJECTS, place, left.object, right.object, _OBJECT)
    yield from compare_facts(OBJECTS, place, left.object.flags or Flags(), right.object.flags or Flags(), _OBJECT_FLAGS)
    ours, theirs = _resolved(left), _resolved(right)
    if ours.object_code != theirs.object_code:
        yield difference(OBJECTS, f"{place} kind", _CODE_WORDS[ours.object_code], _CODE_WORDS[theirs.object_code], True)
    composite = OBJECT_CODES["VAR"] not in (ours.object_code, theirs.object_code)
    pairs = matched(ours.entries, theirs.entries, lambda entry: entry.subindex)
    inside = [
        item
        for entry, other in sorted(pairs, key=lambda pair: either(*pair).subindex)
        for item in _compare_entry(f"{place}:{either(entry, other).subindex:02X}", left, entry, right, other, composite)
    ]
    if composite and not inside:
        yield from compare_facts(OBJECTS, place, left.object, right.object, _WHOLE_SIZE)
    if composite:
        yield from _compare_whole_data(place, ours, theirs)
        yield from compare_facts(OBJECTS, place, left.object, right.object, _WHOLE_VALUES)
    yield from inside
    yield from _compare_places(place, pairs)
    yield from _compare_unreadable(place, left, right)


def _compare_whole_data(place: str, left: ResolvedObject, right: ResolvedObject) -> Iterator[Difference]:
    """DefaultData of an object with subindices, where the defaults of its entries do not tell how they differ."""
    said, also = (item.object.default_data or None for item in (left, right))
    if said != also and data_beside_entries(left) != data_beside_entries(right):
        yield difference(OBJECTS, f"{place} default data", said, also, contradicted(said, also))


def _compare_unreadable(place: str, left: _Declared, right: _Declared) -> Iterator[Difference]:
    """Values of an object and of its types that could not be read: what is resolved does not have them."""
    said, also = (listed(text)(_unreadable(item)) for item in (left, right))
    if said != also:
        yield difference(OBJECTS, f"{place} values that cannot be read", said, also, True)


def _unreadable(declared: _Declared) -> Iterator[str]:
    for record in (declared.object, *used_types(declared.object.type, declared.types)):
        of_type = f"DataType {record.name} " if isinstance(record, DataType) else ""
        for value in unreadable_values(record, lambda part: True):
            yield f"{of_type}{value.place}: {value.problem}"


def _compare_entry(
    place: str,
    left: _Declared,
    entry: ObjectEntry | None,
    right: _Declared,
    other: ObjectEntry | None,
    composite: bool,
) -> Iterator[Difference]:
    if entry is None or other is None:
        said, also = (_member_words(item) for item in (entry, other))
        yield difference(OBJECTS, place, said, also, lost(entry, other))
        return
    declares_modes = ((left.object.object_index or 0) - SUPPORTED_DRIVE_MODES) % AXIS_STEP == 0
    values = _PARAMETER_VALUES if _access(entry) & WRITE or declares_modes else _OTHER_VALUES
    yield from compare_facts(OBJECTS, place, entry, other, (_NAME if composite else ()) + _ENTRY + values)
    yield from _compare_enumerations(place, left.types, entry, right.types, other)


def _member_words(entry: ObjectEntry | None) -> str | None:
    return ", ".join(filter(None, (entry.name, _entry_words(entry)))) if entry is not None else None


def _compare_places(place: str, pairs: Iterable[tuple[ObjectEntry | None, ObjectEntry | None]]) -> Iterator[Difference]:
    """Where a complete access finds the entries that both have: the first one that lies elsewhere."""
    for entry, other in pairs:
        if entry is None or other is None or None in (entry.bit_offset, other.bit_offset):
            continue
        if entry.bit_offset == other.bit_offset:
            continue
        said, also = (f"{item.subindex:02X} at bit {item.bit_offset}" for item in (entry, other))
        yield difference(OBJECTS, f"{place} complete-access image", said, also, True)
        return


def _compare_enumerations(
    place: str, types: dict[str, DataType], entry: ObjectEntry, other_types: dict[str, DataType], other: ObjectEntry
) -> Iterator[Difference]:
    """Values that the type of an entry names, as far as they differ; one less counts, another text does not."""
    values, others = _enumeration(entry.data_type, types), _enumeration(other.data_type, other_types)
    if values != others:
        said, also = _only(values, others), _only(others, values)
        yield difference(OBJECTS, f"{place} enumeration", said, also, lost_items(values, others))


def _only(values: dict[int | None, str | None], others: dict[int | None, str | None]) -> str | None:
    return listed(text)(
        f"{number} {words or ''}" for number, words in values.items() if (number, words) not in others.items()
    )


def _enumeration(name: str | None, types: dict[str, DataType]) -> dict[int | None, str | None]:
    infos: list[EnumInfo] = [info for known in used_types(name, types) for info in known.enum_infos]
    return {info.value: shown_text(info.texts) for info in infos}
