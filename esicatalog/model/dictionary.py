"""Resolved object dictionary: every object with its subindices, types, access and values.

Rules of ESI-FACTS sections 6 and 7: subindices come from the data type; arrays are written in two idioms; declared
values are paired by position in arrays and by name in records; six flags are inherited as ETG.2000 figure 37 says.
"""

import re
from collections.abc import Iterable, Mapping
from typing import Annotated, NamedTuple

import msgspec

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.records.common import Name, display_text
from esicatalog.esi.records.dictionary import DataType, DeclaredValues, Flags, InfoSubItem, Object, SubItem
from esicatalog.model.access import access_word, normalised_pdo_mapping
from esicatalog.model.base_types import BaseType, base_type
from esicatalog.model.values import Value, decode_data, decode_string, decode_value

MAX_ELEMENTS = 4096
"""Longer arrays stay one entry: no CoE array has more than 255 elements, the longest SoE list seen has 761."""

OBJECT_CODES = {"VAR": 7, "ARRAY": 8, "RECORD": 9}
_NUMBERED = re.compile(r"sub\s*index\s*0*(\d+)", re.IGNORECASE)


class ObjectEntry(Record):
    """One index:subindex with everything that type, object and declared values say about it."""

    subindex: Annotated[int, Doc("Subindex")] = 0
    name: Annotated[str | None, Doc("Name of the sub-item; of the object for single values")] = None
    data_type: Annotated[str | None, Doc("Data type name as declared")] = None
    base_type: Annotated[str | None, Doc("Base type it comes down to, e.g. UDINT; NULL when unknown")] = None
    bit_size: Annotated[int | None, Doc("Size in bits")] = None
    bit_offset: Annotated[int | None, Doc("Offset in bits in the complete-access image")] = None
    access: Annotated[str, Doc("Access after inheritance: ro, rw or wo")] = "ro"
    access_word: Annotated[
        int,
        Doc("CoE access word: bits 0-2 read, 3-5 write in PreOP, SafeOP, OP; 6 RxPDO, 7 TxPDO, 8 backup, 9 setting"),
    ] = 0
    category: Annotated[str | None, Doc("m mandatory, o optional, c conditional")] = None
    pdo_mapping: Annotated[str | None, Doc("R mappable in an RxPDO, T in a TxPDO, RT in both; NULL not mappable")] = (
        None
    )
    safety_mapping: Annotated[str | None, Doc("si, so, sio or sp")] = None
    default_raw: Annotated[str | None, Doc("Default as written")] = None
    default_kind: Annotated[str | None, Doc("How it is written: data (hex bytes), value (number) or string")] = None
    default_int: Annotated[int | None, Doc("Default as integer")] = None
    default_real: Annotated[float | None, Doc("Default as floating point number")] = None
    default_text: Annotated[str | None, Doc("Default as text")] = None
    min_int: Annotated[int | None, Doc("Minimum as integer")] = None
    min_real: Annotated[float | None, Doc("Minimum as floating point number")] = None
    max_int: Annotated[int | None, Doc("Maximum as integer")] = None
    max_real: Annotated[float | None, Doc("Maximum as floating point number")] = None
    unit: Annotated[int | None, Doc("Unit, packed 32-bit notation of ETG.1004")] = None
    display_name: Annotated[str | None, Doc("Display name")] = None


class ResolvedObject(NamedTuple):
    """An object with its entries; ``remarks`` are lint rule id and words."""

    object: Object
    object_code: int
    entries: tuple[ObjectEntry, ...]
    remarks: tuple[tuple[str, str], ...]


class _Member(NamedTuple):
    """A subindex before values are paired with it."""

    subindex: int
    name: str | None
    display_names: tuple[Name, ...]
    type: str | None
    bit_size: int | None
    bit_offset: int | None
    flags: Flags | None
    sub_item: SubItem | None


def type_table(data_types: Iterable[DataType]) -> dict[str, DataType]:
    """Data types by name; of two with the same name the first counts."""
    table: dict[str, DataType] = {}
    for data_type in data_types:
        if data_type.name is not None:
            table.setdefault(data_type.name, data_type)
    return table


def used_types(object_type: str | None, types: Mapping[str, DataType]) -> list[DataType]:
    """The declared types that a type name leads to, itself first, each once."""
    found: dict[str, DataType] = {}
    pending = [object_type]
    while pending:
        name = pending.pop()
        data_type = types.get(name) if name else None
        if data_type is None or data_type.name is None or data_type.name in found:
            continue
        found[data_type.name] = data_type
        pending.append(data_type.base_type)
        pending.extend(sub_item.type for sub_item in reversed(data_type.sub_items))
    return list(found.values())


def resolve_base(name: str | None, types: Mapping[str, DataType]) -> BaseType | None:
    """The base type behind a type name: through BaseType chains, else by the name itself."""
    seen = set()
    while name and name not in seen:
        known = base_type(name)
        if known is not None:
            return known
        seen.add(name)
        declared = types.get(name)
        if declared is None or declared.array_infos or declared.sub_items:
            return None
        name = declared.base_type
    return None


def resolve_object(declared: Object, types: Mapping[str, DataType]) -> ResolvedObject:
    """Resolve an object into its entries against the data types of its dictionary."""
    data_type = types.get(declared.type) if declared.type else None
    remarks: list[tuple[str, str]] = []
    if data_type is None and declared.type and base_type(declared.type) is None:
        remarks.append(("L41", f"type {declared.type!r} is not declared in the dictionary"))
    values: Mapping[int, DeclaredValues]
    if data_type is not None and data_type.sub_items:
        members, is_array = _composite_members(data_type, types)
        values = _pair(members, declared.info_sub_items, is_array, remarks)
        code = OBJECT_CODES["ARRAY" if is_array else "RECORD"]
    else:
        members = [
            _Member(
                0, display_text(declared.names), (), declared.type, _simple_size(declared, data_type), 0, None, None
            )
        ]
        values = {0: _single_values(declared, remarks)}
        code = OBJECT_CODES["VAR"]
    entries: list[ObjectEntry] = []
    shared: dict[tuple[int, str | None], _Traits] = {}
    pattern: tuple[SubItem | None, ObjectEntry] | None = None
    for position, member in enumerate(members):
        own_values = values.get(position)
        if own_values is None and pattern is not None and member.sub_item is pattern[0]:
            # Elements of an array without values of their own differ in their place only.
            entries.append(
                msgspec.structs.replace(
                    pattern[1], subindex=member.subindex, name=member.name, bit_offset=member.bit_offset
                )
            )
            continue
        flags = member.flags or declared.flags
        traits = shared.get((id(flags), member.type))
        if traits is None:
            traits = shared[(id(flags), member.type)] = _traits(flags, member.type, types)
        entries.append(_entry(member, own_values, traits))
        if own_values is None and member.sub_item is not None:
            pattern = (member.sub_item, entries[-1])
    return ResolvedObject(declared, code, tuple(entries), tuple(remarks))


def _single_values(declared: Object, remarks: list[tuple[str, str]]) -> DeclaredValues:
    """Values of an object without sub-items: those of Info itself, else of the one sub-item that some files give."""
    has_own = any(
        value is not None
        for value in (declared.default_data, declared.default_value, declared.default_string, declared.min_value)
    )
    if has_own or not declared.info_sub_items:
        return declared
    if len(declared.info_sub_items) > 1:
        remarks.append(("L46", "Info has sub-items, but the data type has none; left unpaired"))
        return declared
    remarks.append(("L46", "Info has a sub-item, but the data type has none; its values are taken for the object"))
    return declared.info_sub_items[0]


def _simple_size(declared: Object, data_type: DataType | None) -> int | None:
    if declared.bit_size is not None:
        return declared.bit_size
    return data_type.bit_size if data_type is not None else None


def _composite_members(data_type: DataType, types: Mapping[str, DataType]) -> tuple[list[_Member], bool]:
    members: list[_Member] = []
    expanded = 0
    for sub_item in data_type.sub_items:
        following = members[-1].subindex + 1 if members else 0
        elements = _array_elements(sub_item, types, following, len(data_type.sub_items) == 2) if members else None
        if elements is not None:
            members.extend(elements)
            expanded += 1
            continue
        members.append(
            _Member(
                sub_item.subindex if sub_item.subindex is not None else following,
                sub_item.name,
                sub_item.display_names,
                sub_item.type,
                sub_item.bit_size,
                sub_item.bit_offset,
                sub_item.flags,
                sub_item,
            )
        )
    return members, expanded == 1 and len(data_type.sub_items) == 2


def _array_elements(
    sub_item: SubItem, types: Mapping[str, DataType], following: int, whole_object: bool
) -> list[_Member] | None:
    """Elements of an array written with one sub-item for all of them (idiom A), or None for a single member.

    Elements count from LBound; with LBound 0 (lists of SoE dictionaries) they follow the member before them and may
    run beyond 255.
    """
    array = types.get(sub_item.type) if sub_item.type else None
    if array is None or not array.array_infos:
        return None
    lbound = array.array_infos[0].lbound if array.array_infos[0].lbound is not None else 1
    suffixed = lbound == 1 and (array.name or "").upper().endswith("ARR")
    if sub_item.subindex is not None and not suffixed:
        return None
    count = 1
    for info in array.array_infos:
        count *= max(info.elements or 0, 0)
    first = lbound if lbound > 0 else following
    if first + count > MAX_ELEMENTS:
        return None
    size = array.bit_size // count if array.bit_size and count else None
    offset = sub_item.bit_offset
    return [
        _Member(
            first + k,
            f"SubIndex {first + k:03d}" if whole_object else f"{sub_item.name}[{lbound + k}]",
            (),
            array.base_type,
            size,
            offset + k * size if offset is not None and size is not None else None,
            sub_item.flags,
            sub_item,
        )
        for k in range(count)
    ]


def _pair(
    members: list[_Member], infos: tuple[InfoSubItem, ...], is_array: bool, remarks: list[tuple[str, str]]
) -> dict[int, InfoSubItem]:
    """Declared values by position of the member they belong to; never shifted to a neighbour."""
    if not infos:
        return {}
    if is_array and len(infos) == len(members):
        return dict(enumerate(infos))
    by_name: dict[str, list[int]] = {}
    for position, member in enumerate(members):
        by_name.setdefault((member.name or "").strip(), []).append(position)
    paired: dict[int, InfoSubItem] = {}
    unmatched: list[InfoSubItem] = []
    for info in infos:
        places = by_name.get((info.name or "").strip())
        if places:
            paired[places.pop(0)] = info
        else:
            unmatched.append(info)
    if not unmatched:
        return paired
    if is_array:
        _pair_array_leftovers(members, unmatched, paired)
        return paired
    if len(infos) == len(members):
        remarks.append(("L46", "sub-item names of Info differ from those of the data type; paired by position"))
        return dict(enumerate(infos))
    names = ", ".join(repr(info.name) for info in unmatched[:3])
    remarks.append(("L46", f"Info sub-items {names} match no sub-item of the data type; left unpaired"))
    return paired


def _pair_array_leftovers(members: list[_Member], unmatched: list[InfoSubItem], paired: dict[int, InfoSubItem]) -> None:
    """Values of an array whose names do not match: by the number in the name, else in order from the first element."""
    positions = {member.subindex: position for position, member in enumerate(members)}
    in_order = []
    for info in unmatched:
        numbered = _NUMBERED.fullmatch((info.name or "").strip())
        position = positions.get(int(numbered[1])) if numbered else None
        if position is not None and position not in paired:
            paired[position] = info
        elif numbered is None:
            in_order.append(info)
    if in_order and len(in_order) == len(members) - 1 and not paired.keys() - {0}:
        paired.update((position, info) for position, info in enumerate(in_order, start=1))


_FLAG_DEFAULTS = Flags()


class _Traits(NamedTuple):
    """What members with the same flags and type share."""

    base: BaseType | None
    base_name: str | None
    access: str
    access_word: int
    category: str | None
    pdo_mapping: str | None
    safety_mapping: str | None


def _traits(member_flags: Flags | None, type_name: str | None, types: Mapping[str, DataType]) -> _Traits:
    base = resolve_base(type_name, types)
    flags = member_flags or _FLAG_DEFAULTS
    mapping = normalised_pdo_mapping(flags.pdo_mapping)
    return _Traits(
        base,
        base.name if base is not None else None,
        flags.access or "ro",
        access_word(flags, mapping),
        flags.category,
        mapping,
        flags.safety_mapping.lower() if flags.safety_mapping else None,
    )


def _entry(member: _Member, values: DeclaredValues | None, traits: _Traits) -> ObjectEntry:
    default, minimum, maximum = _values(values, member.sub_item, traits.base)
    display = (values.display_names if values is not None else ()) or member.display_names
    entry = ObjectEntry(
        subindex=member.subindex,
        name=member.name,
        data_type=member.type,
        base_type=traits.base_name,
        bit_size=member.bit_size,
        bit_offset=member.bit_offset,
        access=traits.access,
        access_word=traits.access_word,
        category=traits.category,
        pdo_mapping=traits.pdo_mapping,
        safety_mapping=traits.safety_mapping,
        unit=values.unit if values is not None else None,
        display_name=display_text(display),
    )
    if default is minimum is maximum:
        return entry
    return msgspec.structs.replace(
        entry,
        default_raw=default.raw,
        default_kind=default.kind,
        default_int=default.number,
        default_real=default.real,
        default_text=default.text,
        min_int=minimum.number,
        min_real=minimum.real,
        max_int=maximum.number,
        max_real=maximum.real,
    )


_NO_VALUE = Value(None, None)


def _values(
    values: DeclaredValues | None, sub_item: SubItem | None, base: BaseType | None
) -> tuple[Value, Value, Value]:
    """Default, minimum and maximum: those of Info, else the obsolete ones of the data type's sub-item."""
    default = minimum = maximum = _NO_VALUE
    if values is not None:
        default = _default(values, base)
        if values.min_data or values.min_value is not None:
            minimum = _bound(values, values.min_data, "min_value", base)
        if values.max_data or values.max_value is not None:
            maximum = _bound(values, values.max_data, "max_value", base)
    if sub_item is not None:
        if default is _NO_VALUE:
            default = _default(sub_item, base)
        if minimum is _NO_VALUE and sub_item.min_value is not None:
            minimum = _bound(sub_item, None, "min_value", base)
        if maximum is _NO_VALUE and sub_item.max_value is not None:
            maximum = _bound(sub_item, None, "max_value", base)
    return default, minimum, maximum


def _default(source: DeclaredValues | SubItem, base: BaseType | None) -> Value:
    if source.default_data:
        return decode_data(source.default_data, base)
    if source.default_value is not None or (source.spelling and "default_value" in source.spelling):
        return decode_value(source.default_value, _raw(source, "default_value"), base)
    if source.default_string is not None:
        return decode_string(source.default_string, base)
    return _NO_VALUE


def _bound(source: DeclaredValues | SubItem, data: str | None, value_field: str, base: BaseType | None) -> Value:
    if data:
        return decode_data(data, base)
    return decode_value(getattr(source, value_field), _raw(source, value_field), base)


def _raw(source: Record, field: str) -> str:
    spelling = source.spelling or {}
    return spelling.get(field) or str(getattr(source, field))
