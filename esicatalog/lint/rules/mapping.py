"""Rules that hold PDO entries against the dictionary they map from; one finding a PDO."""

from collections.abc import Iterator, Sequence
from functools import lru_cache

from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Found, Place, listed, rule
from esicatalog.lint.subjects import NumberedEntry, PdoMapping, PdoTypes
from esicatalog.model.base_types import BASE_TYPES, BaseType, base_type
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.pdo_facts import entry_facts
from esicatalog.model.pdo_mapping import MAPPABLE_IN
from esicatalog.model.resolver import TypeSet
from esicatalog.model.sync_parameters import SYNC_PARAMETERS
from esicatalog.words import index_words

_KINDS_OF_BITS = frozenset({"bool", "uint", "bits"})
"""Kinds that differ in name only: the same bits without sign."""
_BOOL_SIZES = frozenset({1, 8})
"""A BOOL is mapped as one bit and often declared as the byte that an SDO carries."""
_SYNC_ERRORS = frozenset((index, 0x20) for index in SYNC_PARAMETERS)
"""Mappable by the standard (ETG.1020), and mapped by many devices whose dictionary does not say so."""
_OTHER_NAMES = frozenset({"BOOLEAN", "BIT"})
"""Names that tables of the base types list beside BOOL."""
_SIGN_UNKNOWN = frozenset({"UINT8", "UINT16", "UINT32", "UINT64"})
"""What ``ethercat xml`` (IgH EtherLab) makes of the length of an entry: a slave does not tell it more of its PDOs."""
_OWN_TYPE = "DT"
"""How data types of a dictionary are named."""


def _maps(mapping: PdoMapping) -> str:
    return f"{mapping.direction} {index_words(mapping.pdo.pdo_index)} maps"


def _entries(items: Sequence[NumberedEntry]) -> str:
    return listed([_words(entry) for _, entry in items])


def _words(entry: Entry) -> str:
    return f"0x{entry.entry_index:04X}:{entry.subindex or 0:02X}"


def _place(items: Sequence[NumberedEntry]) -> Place:
    return ("entries", items[0][0])


@rule("L36", WARNING, "ETG.1000.6: a PDO maps objects of the dictionary")
def object_unknown(mapping: PdoMapping) -> Iterator[Found]:
    """A PDO maps objects or subindices that are not in the dictionary."""
    if mapping.unknown:
        yield Found(
            f"{_maps(mapping)} {_entries(mapping.unknown)}: "
            "not in the dictionary; describe them or correct the entries",
            _place(mapping.unknown),
        )


@rule("L37", WARNING, "ETG.1000.6: an entry is mapped with its length; the process image follows BitLen")
def length_differs(mapping: PdoMapping) -> Iterator[Found]:
    """BitLen of entries differs from the size of the objects they map."""
    found = [
        ((position, entry), declared.bit_size)
        for position, entry, declared in mapping.described
        if entry.bit_length != declared.bit_size and _length_differs(entry.bit_length, declared)
    ]
    if found:
        items, sizes = zip(*found, strict=True)
        first = items[0][1]
        yield Found(
            f"{_maps(mapping)} {_entries(items)} with another BitLen than the dictionary has "
            f"({_words(first)}: {first.bit_length} instead of {sizes[0]} bits)",
            (*_place(items), "bit_length"),
        )


def _length_differs(length: int | None, declared: ObjectEntry) -> bool:
    if declared.bit_size is None or length is None:
        return False
    return not (declared.base_type == "BOOL" and {length, declared.bit_size} == _BOOL_SIZES)


@rule("L38", INFORMATION, "ETG.2000 Entry/DataType repeats the type of the mapped object")
def type_differs(mapping: PdoMapping) -> Iterator[Found]:
    """DataType of entries means something else than the type of the objects they map."""
    found = [
        ((position, entry), declared.data_type)
        for position, entry, declared in mapping.described
        if entry.data_type != declared.base_type and _type_differs(entry.data_type, declared.base_type)
    ]
    if found:
        items, types = zip(*found, strict=True)
        first = items[0][1]
        yield Found(
            f"{_maps(mapping)} {_entries(items)} with another DataType than the dictionary has "
            f"({_words(first)}: {first.data_type} instead of {types[0]})",
            (*_place(items), "data_type"),
        )


def _type_differs(mapped: str | None, declared: str | None) -> bool:
    base = base_type(mapped)
    return declared is not None and base is not None and _kind(base) != _kind(BASE_TYPES[declared])


def _kind(base: BaseType) -> str:
    return "unsigned" if base.kind in _KINDS_OF_BITS else base.kind


@rule("L39", WARNING, "ETG.2000 Flags/PdoMapping: T for TxPdo, R for RxPdo; absent = not mappable")
def not_mappable(mapping: PdoMapping) -> Iterator[Found]:
    """A PDO maps objects without PdoMapping (with that of the other direction only: E)."""
    letter = MAPPABLE_IN[mapping.direction]
    refused = [
        (position, entry, declared.pdo_mapping)
        for position, entry, declared in mapping.described
        if letter not in (declared.pdo_mapping or "") and (entry.entry_index, entry.subindex) not in _SYNC_ERRORS
    ]
    without = [(position, entry) for position, entry, declared in refused if declared is None]
    if without:
        yield Found(
            f"{_maps(mapping)} {_entries(without)} without PdoMapping in the dictionary: give PdoMapping {letter}",
            _place(without),
        )
    other_way = [(position, entry) for position, entry, declared in refused if declared is not None]
    if other_way:
        yield Found(
            f"{_maps(mapping)} {_entries(other_way)}, which the dictionary allows the other way only: "
            f"PdoMapping must have {letter}",
            _place(other_way),
            ERROR,
        )


@rule("L48", WARNING, "ETG.2000 table of base data types, ETG.1020")
def type_name(record: PdoTypes | TypeSet) -> Iterator[Found]:
    """Types have names that are neither base types of ESI (UINT16 instead of UINT) nor declared."""
    if isinstance(record, TypeSet):
        names = [data_type.name for data_type in record.data_types if _standard_name(data_type.name)]
        if names:
            renamed = [f"{name} is {_standard_name(name)}" for name in names]
            number = next(n for n, data_type in enumerate(record.data_types) if data_type.name == names[0])
            yield Found(f"base types with names of other tools: {listed(renamed)}", ("data_types", number, "name"))
        return
    for number, name in record.foreign:
        standard = _standard_name(name)
        if standard is not None or (record.are_all_types and not any(name in types.by_name for types in record.types)):
            if standard is None:
                words = "is no base type of ESI"
            elif name in _SIGN_UNKNOWN and not record.types:
                words = (
                    f"ethercat xml writes with and without sign: give {standard} or {standard[1:]}, as the object is"
                )
            else:
                words = f"is {standard} in ESI"
            yield Found(
                f"entry {number + 1} of PDO {index_words(record.pdo.pdo_index)} has the DataType {name}, which {words}",
                ("entries", number, "data_type"),
            )


def foreign_types(pdo: Pdo) -> Sequence[tuple[int, str]]:
    """The names in entries that are no base types of ESI, each with the position of the first entry that has it.

    Padding has a length only (ESI-FACTS section 9).
    """
    first: dict[str, int] = {}
    for number, entry in enumerate(pdo.entries):
        if entry.data_type and not entry_facts(entry).is_padding:
            first.setdefault(entry.data_type, number)
    return [(number, name) for name, number in first.items() if _is_foreign(name)]


def _is_foreign(name: str) -> bool:
    return _standard_name(name) is not None or (base_type(name) is None and not name.startswith(_OWN_TYPE))


@lru_cache(10_000)
def _standard_name(name: str | None) -> str | None:
    """The name that ESI has for a base type that other tools name otherwise; None for all other names."""
    text = (name or "").strip().upper()
    base = base_type(text)
    if base is None or text in BASE_TYPES or text in _OTHER_NAMES or not text.isalnum():
        return None
    return base.name
