"""Rules that hold PDO entries against the dictionary they map from; one finding a PDO."""

from collections.abc import Iterator
from functools import lru_cache

from esicatalog.esi.records.pdo import Pdo
from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Found, listed, rule
from esicatalog.lint.subjects import MappedEntry, PdoMapping
from esicatalog.model.base_types import BASE_TYPES, BaseType, base_type
from esicatalog.model.resolver import TypeSet

_LETTERS = {"RxPdo": "R", "TxPdo": "T"}
_KINDS_OF_BITS = frozenset({"bool", "uint", "bits"})
"""Kinds that differ in name only: the same bits without sign."""
_BOOL_SIZES = frozenset({1, 8})
"""A BOOL is mapped as one bit and often declared as the byte that an SDO carries."""
_SYNC_ERRORS = frozenset({(0x1C32, 0x20), (0x1C33, 0x20)})
"""Mappable by the standard (ETG.1020), and mapped by many devices whose dictionary does not say so."""
_OTHER_NAMES = frozenset({"BOOLEAN", "BIT"})
"""Names that tables of the base types list beside BOOL."""
_OWN_TYPE = "DT"
"""How data types of a dictionary are named."""


def _maps(mapping: PdoMapping) -> str:
    return f"{mapping.direction} 0x{mapping.pdo.pdo_index or 0:04X} maps"


def _entries(items: list[MappedEntry]) -> str:
    return listed([f"0x{item.object_index:04X}:{item.subindex:02X}" for item in items])


@rule("L36", WARNING, "ETG.1000.6: a PDO maps objects of the dictionary")
def object_unknown(mapping: PdoMapping) -> Iterator[Found]:
    """A PDO maps objects or subindices that are not in the dictionary."""
    unknown = [item for item in mapping.mapped if item.declared is None]
    if unknown:
        yield Found(
            f"{_maps(mapping)} {_entries(unknown)}: not in the dictionary; describe them or correct the entries",
            unknown[0].place,
        )


@rule("L37", WARNING, "ETG.1000.6: an entry is mapped with its length; the process image follows BitLen")
def length_differs(mapping: PdoMapping) -> Iterator[Found]:
    """BitLen of entries differs from the size of the objects they map."""
    found = [item for item in mapping.mapped if item.declared is not None and _length_differs(item)]
    if found:
        first = found[0]
        size = first.declared.bit_size if first.declared is not None else None
        yield Found(
            f"{_maps(mapping)} {_entries(found)} with another BitLen than the dictionary has "
            f"(0x{first.object_index:04X}:{first.subindex:02X}: {first.entry.bit_length} instead of {size} bits)",
            (*first.place, "bit_length"),
        )


def _length_differs(item: MappedEntry) -> bool:
    declared, length = item.declared, item.entry.bit_length
    if declared is None or declared.bit_size is None or length is None or length == declared.bit_size:
        return False
    return not (declared.base_type == "BOOL" and {length, declared.bit_size} == _BOOL_SIZES)


@rule("L38", INFORMATION, "ETG.2000 Entry/DataType repeats the type of the mapped object")
def type_differs(mapping: PdoMapping) -> Iterator[Found]:
    """DataType of entries means something else than the type of the objects they map."""
    found = [item for item in mapping.mapped if item.declared is not None and _type_differs(item)]
    if found:
        first = found[0]
        declared = first.declared.data_type if first.declared is not None else None
        yield Found(
            f"{_maps(mapping)} {_entries(found)} with another DataType than the dictionary has "
            f"(0x{first.object_index:04X}:{first.subindex:02X}: {first.entry.data_type} instead of {declared})",
            (*first.place, "data_type"),
        )


def _type_differs(item: MappedEntry) -> bool:
    if item.declared is None or item.declared.base_type is None:
        return False
    mapped = base_type(item.entry.data_type)
    return mapped is not None and _kind(mapped) != _kind(BASE_TYPES[item.declared.base_type])


def _kind(base: BaseType) -> str:
    return "unsigned" if base.kind in _KINDS_OF_BITS else base.kind


@rule("L39", WARNING, "ETG.2000 Flags/PdoMapping: T for TxPdo, R for RxPdo; absent = not mappable")
def not_mappable(mapping: PdoMapping) -> Iterator[Found]:
    """A PDO maps objects without PdoMapping (with that of the other direction only: E)."""
    letter = _LETTERS[mapping.direction]
    refused = [
        item
        for item in mapping.mapped
        if item.declared is not None
        and letter not in (item.declared.pdo_mapping or "")
        and (item.object_index, item.subindex) not in _SYNC_ERRORS
    ]
    without = [item for item in refused if item.declared is not None and item.declared.pdo_mapping is None]
    if without:
        yield Found(
            f"{_maps(mapping)} {_entries(without)} without PdoMapping in the dictionary: give PdoMapping {letter}",
            without[0].place,
        )
    other_way = [item for item in refused if item not in without]
    if other_way:
        yield Found(
            f"{_maps(mapping)} {_entries(other_way)}, which the dictionary allows the other way only: "
            f"PdoMapping must have {letter}",
            other_way[0].place,
            ERROR,
        )


@rule("L48", WARNING, "ETG.2000 table of base data types, ETG.1020")
def type_name(record: Pdo | TypeSet) -> Iterator[Found]:
    """Types have names that are no base types of ESI (UINT16 instead of UINT)."""
    if isinstance(record, TypeSet):
        names = [data_type.name for data_type in record.data_types if _standard_name(data_type.name)]
        if names:
            renamed = [f"{name} is {_standard_name(name)}" for name in names]
            number = next(n for n, data_type in enumerate(record.data_types) if data_type.name == names[0])
            yield Found(f"base types with names of other tools: {listed(renamed)}", ("data_types", number, "name"))
        return
    seen = set()
    for number, entry in enumerate(record.entries):
        name = entry.data_type
        if not name or name in seen:
            continue
        seen.add(name)
        standard = _standard_name(name)
        if standard is not None or (base_type(name) is None and not name.startswith(_OWN_TYPE)):
            words = f"is {standard} in ESI" if standard is not None else "is no base type of ESI"
            yield Found(
                f"entry {number + 1} of PDO 0x{record.pdo_index or 0:04X} has the DataType {name}, which {words}",
                ("entries", number, "data_type"),
            )


@lru_cache(10_000)
def _standard_name(name: str | None) -> str | None:
    """The name that ESI has for a base type that other tools name otherwise; None for all other names."""
    text = (name or "").strip().upper()
    base = base_type(text)
    if base is None or text in BASE_TYPES or text in _OTHER_NAMES or not text.isalnum():
        return None
    return base.name
