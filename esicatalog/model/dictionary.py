"""Resolved object dictionary: every object with its subindices, types, access and values.

Rules of ESI-FACTS sections 6 and 7: subindices come from the data type; arrays are written in two idioms; declared
values are paired by position in arrays and by name in records, or cut out of the data of the whole object; six flags
are inherited as ETG.2000 figure 37 says.
"""

from collections.abc import Iterable, Mapping
from operator import attrgetter
from typing import Annotated, NamedTuple

import msgspec

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.dictionary import DataType, DeclaredValues, EnumInfo, Flags, InfoSubItem, Object, SubItem
from esicatalog.model.access import access_word, normalised_pdo_mapping
from esicatalog.model.base_types import BASE_TYPES, BaseType, base_type
from esicatalog.model.members import Member, MemberMemo, Members
from esicatalog.model.memo import IdentityMemo, identities
from esicatalog.model.values import Value, byte_length, decode_data, decode_string, decode_value
from esicatalog.remarks import Remarking, remarked

_MAX_MADE = 50_000
_MAX_OBJECTS = 10_000

OBJECT_CODES = {"VAR": 7, "ARRAY": 8, "RECORD": 9}


class ObjectEntry(Record, kw_only=False):
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
    default_raw: Annotated[str | None, Doc("Default as written; else its part of the data of the whole object")] = None
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
    """An object with its entries; ``remarks`` tell which values of Info found no entry, or not by its name."""

    object: Object
    object_code: int
    entries: tuple[ObjectEntry, ...]
    remarks: tuple[str, ...]


def type_table(data_types: Iterable[DataType]) -> dict[str, DataType]:
    """Data types by name; of two with the same name the first counts."""
    table: dict[str, DataType] = {}
    for data_type in data_types:
        if data_type.name is not None:
            table.setdefault(data_type.name, data_type)
    return table


def used_types(object_type: str | None, types: Mapping[str, DataType]) -> tuple[DataType, ...]:
    """The declared types that a type name leads to, itself first, each once."""
    found: dict[str, DataType] = {}
    pending = [object_type]
    while pending:
        name = pending.pop()
        data_type = types.get(name) if name else None
        if data_type is None or name is None or name in found:
            continue
        found[name] = data_type
        if data_type.base_type:
            pending.append(data_type.base_type)
        if data_type.sub_items:
            pending.extend(reversed(dict.fromkeys([sub_item.type for sub_item in data_type.sub_items])))
    return tuple(found.values())


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


def enum_values(name: str | None, types: Mapping[str, DataType]) -> tuple[EnumInfo, ...]:
    """The values that a type lists: its own, else those of the nearest type that it is based on."""
    seen = set()
    while name and name not in seen and (declared := types.get(name)) is not None:
        if declared.enum_infos:
            return declared.enum_infos
        seen.add(name)
        name = declared.base_type
    return ()


def resolve_object(declared: Object, types: Mapping[str, DataType]) -> ResolvedObject:
    """Resolve an object into its entries against the data types of its dictionary."""
    return ObjectType(declared.type, types, EntryMemo()).resolve(declared)


class EntryMemo:
    """What was made of records before: where the reader gives the same records again, it is the same."""

    def __init__(self) -> None:
        self.members: MemberMemo = IdentityMemo(_MAX_MADE)
        self.entries: IdentityMemo[ObjectEntry] = IdentityMemo(_MAX_MADE)
        self.objects: IdentityMemo[_Composite] = IdentityMemo(_MAX_OBJECTS)
        self.traits: IdentityMemo[_Traits] = IdentityMemo(_MAX_OBJECTS)


class _Composite(NamedTuple):
    """What objects of the same type, values and flags share."""

    entries: tuple[ObjectEntry, ...]
    remarks: tuple[str, ...]


class ObjectType:
    """What a type name means to the objects that name it."""

    def __init__(self, name: str | None, types: Mapping[str, DataType], memo: EntryMemo) -> None:
        self._name = name
        self._memo = memo
        data_type = types.get(name) if name else None
        bases: dict[str | None, BaseType | None] = {}

        def base(name: str | None) -> BaseType | None:
            if name not in bases:
                bases[name] = resolve_base(name, types)
            return bases[name]

        is_composite = data_type is not None and bool(data_type.sub_items)
        self._members = Members(data_type, types, base, memo.members) if data_type and is_composite else None
        self._base = base(name)
        self._bit_size = data_type.bit_size if data_type is not None else None

    def resolve(self, declared: Object) -> ResolvedObject:
        """The object, which names this type, with its entries."""
        members = self._members
        if members is None:
            return self._resolve_single(declared)
        infos, flags = declared.info_sub_items, declared.flags
        key = (id(self), identities(infos), id(flags))
        made = self._memo.objects.get(key, (self, infos, flags), self._composite, members, infos, flags)
        if declared.default_data:
            made = made._replace(entries=_with_parts(made.entries, declared))
        return ResolvedObject(declared, OBJECT_CODES["ARRAY" if members.is_array else "RECORD"], *made)

    def _resolve_single(self, declared: Object) -> ResolvedObject:
        values, remarks = remarked(_single_values(declared)) if declared.info_sub_items else (declared, ())
        size = declared.bit_size if declared.bit_size is not None else self._bit_size
        member = Member(0, display_text(declared.names), (), self._name, self._base, size, 0, None, None)
        entry = self._entry(member, values, declared.flags)
        return ResolvedObject(declared, OBJECT_CODES["VAR"], (entry,), remarks)

    def _composite(self, members: Members, infos: tuple[InfoSubItem, ...], inherited: Flags | None) -> _Composite:
        paired, remarks = members.pair(infos)
        known, make = self._memo.entries.get, self._entry
        entries = []
        for member, values in zip(members, paired, strict=True):
            flags = member.flags or inherited
            key = (id(member), id(values), id(flags))
            entries.append(known(key, (member, values, flags), make, member, values, flags))
        return _Composite(tuple(entries), remarks)

    def _entry(self, member: Member, values: DeclaredValues | None, flags: Flags | None) -> ObjectEntry:
        return _entry(member, values, self._memo.traits.of(flags, _traits))


_own_values = attrgetter("default_data", "default_value", "default_string", "min_value")
_NO_OWN_VALUES = _own_values(DeclaredValues())


def _single_values(declared: Object) -> Remarking[DeclaredValues]:
    """Values of an object that is no composite, with sub-items in Info as some files have them.

    Those of Info itself, else of its sub-item where there is one.
    """
    if _own_values(declared) != _NO_OWN_VALUES:
        return declared
    if len(declared.info_sub_items) > 1:
        yield "Info has sub-items, but the data type has none; left unpaired"
        return declared
    yield "Info has a sub-item, but the data type has none; its values are taken for the object"
    return declared.info_sub_items[0]


def _with_parts(entries: tuple[ObjectEntry, ...], declared: Object) -> tuple[ObjectEntry, ...]:
    """The entries with their part of DefaultData of the whole object, where they have no default of their own."""
    data = _image(entries, declared)
    if data is None:
        return entries
    return tuple(_with_part(entry, data) if entry.default_raw is None else entry for entry in entries)


def data_beside_entries(resolved: ResolvedObject) -> str | None:
    """DefaultData of a whole object as far as they are not the defaults of its entries, None where nothing is left.

    All of them where they say nothing of the entries; else bits that no entry has, or has another default for.
    """
    declared, entries = resolved.object, resolved.entries
    data = _image(entries, declared)
    if data is None:
        return (declared.default_data or "").upper() or None
    left = int.from_bytes(data, "little")
    for entry in entries:
        place, part = _place(entry), _part(entry, data)
        if place is not None and part is not None and part == (entry.default_raw or "").upper():
            start, end = place
            left &= ~((1 << end) - (1 << start))
    return left.to_bytes(len(data), "little").hex().upper() if left else None


def _image(entries: tuple[ObjectEntry, ...], declared: Object) -> bytes | None:
    """DefaultData of a whole object: its complete-access image (ESI-FACTS section 6.1).

    They say nothing of the entries (None) where they have another length than the object, or where the places of
    entries overlap or leave them.
    """
    data = decode_hex_binary(declared.default_data)
    if data is None or declared.bit_size is None or len(data) != byte_length(declared.bit_size):
        return None
    places = sorted(place for place in map(_place, entries) if place is not None)
    ends = [0, *(end for _, end in places)]
    if any(start < end for (start, _), end in zip(places, ends, strict=False)) or ends[-1] > 8 * len(data):
        return None
    return data


def _place(entry: ObjectEntry) -> tuple[int, int] | None:
    """The bits of an entry in the complete-access image: the first one, and the one behind the last."""
    if entry.bit_offset is None or entry.bit_size is None or entry.bit_size <= 0:
        return None
    return entry.bit_offset, entry.bit_offset + entry.bit_size


def _part(entry: ObjectEntry, data: bytes) -> str | None:
    """The bytes of the image that are an entry's own, as hex; its bits where it is a bit field of a whole number."""
    place = _place(entry)
    if place is None:
        return None
    start, end = place
    part = data[start // 8 : byte_length(end)]
    if start % 8 or end % 8:
        base = BASE_TYPES.get(entry.base_type or "")
        if base is None or not base.integral or base.signed:
            return None
        size = end - start
        bits = int.from_bytes(part, "little") >> start % 8 & (1 << size) - 1
        part = bits.to_bytes(byte_length(size), "little")
    return part.hex().upper()


def _with_part(entry: ObjectEntry, data: bytes) -> ObjectEntry:
    """An entry with its part of the image as its default."""
    part = _part(entry, data)
    if part is None:
        return entry
    value = decode_data(part, BASE_TYPES.get(entry.base_type or ""), entry.bit_size)
    return msgspec.structs.replace(
        entry,
        default_raw=value.raw,
        default_kind=value.kind,
        default_int=value.number,
        default_real=value.real,
        default_text=value.text,
    )


class _Traits(NamedTuple):
    """What members with the same flags share, as an entry has it."""

    access: str
    access_word: int
    category: str | None
    pdo_mapping: str | None
    safety_mapping: str | None


_FLAG_DEFAULTS = Flags()


def _traits(declared: Flags | None) -> _Traits:
    flags = declared or _FLAG_DEFAULTS
    mapping = normalised_pdo_mapping(flags.pdo_mapping)
    return _Traits(
        (flags.access or "ro").lower(),
        access_word(flags, mapping),
        flags.category,
        mapping,
        flags.safety_mapping.lower() if flags.safety_mapping else None,
    )


def _entry(member: Member, values: DeclaredValues | None, traits: _Traits) -> ObjectEntry:
    subindex, name, display_names, data_type, base, bit_size, bit_offset, _, fallback = member
    declared, unit = _NO_VALUES, None
    if values is not None:
        declared, unit = _declared(values, base, bit_size), values.unit
        display_names = values.display_names or display_names
    default, minimum, maximum = declared if fallback is None else _with_obsolete(declared, fallback, base, bit_size)
    return ObjectEntry(  # in the order of its fields: names would cost more than all the rest
        subindex,
        name,
        data_type,
        base.name if base is not None else None,
        bit_size,
        bit_offset,
        *traits,
        *default,
        minimum.number,
        minimum.real,
        maximum.number,
        maximum.real,
        unit,
        display_text(display_names),
    )


_NO_VALUE = Value(None, None)


_Values = tuple[Value, Value, Value]
"""Default, minimum and maximum."""
_NO_VALUES: _Values = (_NO_VALUE, _NO_VALUE, _NO_VALUE)


def _declared(values: DeclaredValues, base: BaseType | None, bit_size: int | None) -> _Values:
    """Those of Info."""
    minimum = maximum = _NO_VALUE
    if values.min_data or values.min_value is not None:
        minimum = _bound(values, values.min_data, "min_value", base, bit_size)
    if values.max_data or values.max_value is not None:
        maximum = _bound(values, values.max_data, "max_value", base, bit_size)
    return _default(values, base, bit_size), minimum, maximum


def _with_obsolete(declared: _Values, sub_item: SubItem, base: BaseType | None, bit_size: int | None) -> _Values:
    """Where Info has none, the obsolete ones of the data type's sub-item."""
    default, minimum, maximum = declared
    if default is _NO_VALUE:
        default = _default(sub_item, base, bit_size)
    if minimum is _NO_VALUE and sub_item.min_value is not None:
        minimum = _bound(sub_item, None, "min_value", base, bit_size)
    if maximum is _NO_VALUE and sub_item.max_value is not None:
        maximum = _bound(sub_item, None, "max_value", base, bit_size)
    return default, minimum, maximum


def _default(source: DeclaredValues | SubItem, base: BaseType | None, bit_size: int | None) -> Value:
    if source.default_data:
        return decode_data(source.default_data, base, bit_size)
    if source.default_value is not None or (source.spelling and source.spelling.get("default_value", "").strip()):
        return decode_value(source.default_value, _raw(source, "default_value"), base)
    if source.default_string is not None:
        return decode_string(source.default_string, base)
    return _NO_VALUE


def _bound(
    source: DeclaredValues | SubItem, data: str | None, value_field: str, base: BaseType | None, bit_size: int | None
) -> Value:
    if data:
        return decode_data(data, base, bit_size)
    return decode_value(getattr(source, value_field), _raw(source, value_field), base)


def _raw(source: Record, field: str) -> str:
    spelling = source.spelling or {}
    return spelling.get(field) or str(getattr(source, field))
