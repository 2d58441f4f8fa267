"""Rules about declared values: defaults, limits, their pairing with the data type."""

from collections.abc import Iterator

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.lint.objects import ObjectValues
from esicatalog.lint.registry import WARNING, Found, Place, listed, rule
from esicatalog.model.base_types import BASE_TYPES, BaseType
from esicatalog.model.dictionary import OBJECT_CODES, ObjectEntry
from esicatalog.model.values import byte_length, fills, number_size, spelled_number
from esicatalog.words import counted, index_words

_REAL_BYTES = 4
_TRUE_BYTE = ("bool", 0xFF)
"""How a BOOL is true in all bits of its byte."""
_CHARACTER_BITS = {"string": 8, "octets": 8, "unicode": 16}


def _words(subject: ObjectValues, entry: ObjectEntry) -> str:
    return f"{index_words(subject.declared.object_index)}:{entry.subindex:02X}"


@rule("L45", WARNING, "ETG.2000 DefaultData: the bytes of the value, little-endian; MinValue, MaxValue")
def default_value(subject: ObjectValues) -> Iterator[Found]:
    """A default has another length than the type, does not fit into it, or lies outside of minimum and maximum."""
    found = []
    for entry in subject.with_values:
        problem = _length_problem(entry) or _fit_problem(entry) or _range_problem(entry)
        if problem is not None:
            found.append((entry, f"{_words(subject, entry)} {problem}"))
    if found:
        yield Found(f"{listed([words for _, words in found])}: correct it", _place(subject, found[0][0]))
    if (problem := _whole_problem(subject)) is not None:
        yield Found(f"object {index_words(subject.declared.object_index)} {problem}")


def _whole_problem(subject: ObjectValues) -> str | None:
    """Data of an object with subindices, which are its complete-access image, in another length than that has."""
    data, size = decode_hex_binary(subject.declared.default_data), subject.declared.bit_size
    if data is None or size is None or len(data) == byte_length(size):
        return None
    if subject.resolved.object_code == OBJECT_CODES["VAR"]:
        return None
    return (
        f"has DefaultData of {counted(len(data), 'byte')} for all subindices together, its BitSize is "
        f"{byte_length(size)}: correct it, or give each subindex its own"
    )


def _place(subject: ObjectValues, entry: ObjectEntry) -> Place:
    """The SubItem of Info that gives the value of an entry, the object where its name does not tell which."""
    names = [(info.name or "").strip() for info in subject.declared.info_sub_items]
    name = (entry.name or "").strip()
    return ("info_sub_items", names.index(name)) if name in names else ()


def _length_problem(entry: ObjectEntry) -> str | None:
    if entry.default_kind != "data" or entry.bit_size is None or entry.base_type is None:
        return None
    data = decode_hex_binary(entry.default_raw)
    base = BASE_TYPES[entry.base_type]
    if data is None or fills(len(data), base, entry.bit_size):
        return None
    wanted = byte_length(entry.bit_size)
    given, reading = counted(len(data), "byte"), _reading(len(data), entry, base)
    return f"has DefaultData of {given}; {entry.data_type} has {wanted}{reading}"


def _fit_problem(entry: ObjectEntry) -> str | None:
    """A number or a text that its type has no room for."""
    if entry.bit_size is None or entry.base_type is None:
        return None
    base, number = BASE_TYPES[entry.base_type], entry.default_int
    if number is None and entry.default_kind == "value":
        number = spelled_number(entry.default_raw or "", base)
    if entry.default_kind == "string" and base.kind in _CHARACTER_BITS:
        room = entry.bit_size // _CHARACTER_BITS[base.kind]
        length = len(entry.default_raw or "")
        if not 0 < room < length:  # STRING(0) is of any length
            return None
        return f"has a DefaultString of {length} characters, {entry.data_type} has {room}"
    if number is None or not base.integral:
        return None
    if entry.default_kind == "data" and (base.signed or (base.kind, number) == _TRUE_BYTE):
        return None
    needed = (number if number >= 0 else ~number).bit_length() + base.signed
    if needed <= entry.bit_size and (base.signed or number >= 0):
        return None
    return (
        f"has the default {number}, which does not fit into the {counted(entry.bit_size, 'bit')} of {entry.data_type}"
    )


def _reading(given: int, entry: ObjectEntry, base: BaseType) -> str:
    """What is made of a number with too many or too few bytes."""
    if not base.integral and base.kind != "real":
        return ""
    size = number_size(given, base, entry.bit_size)
    if given > size:
        return f", and the first {size} are read"
    if given == size:
        return ""
    if base.integral:
        return ", and the missing ones are read as 0"
    return ", and these are read as a REAL" if given == _REAL_BYTES else ", and no number is read"


def _range_problem(entry: ObjectEntry) -> str | None:
    if entry.min_int is None and entry.max_int is None and entry.min_real is None and entry.max_real is None:
        return None
    if entry.default_int is not None:
        return _beyond(entry, entry.default_int, entry.min_int, entry.max_int)
    return _beyond(entry, entry.default_real, entry.min_real, entry.max_real)


def _beyond(entry: ObjectEntry, value: float | None, lowest: float | None, highest: float | None) -> str | None:
    if value is None or lowest == highest == 0:  # two zeros are no limits
        return None
    if lowest is not None and highest is not None and lowest > highest:
        return f"has the minimum {lowest} above the maximum {highest}, if {entry.data_type} is the right type"
    if lowest is not None and value < lowest:
        return f"has the default {value}, less than its minimum {lowest}"
    if highest is not None and value > highest:
        return f"has the default {value}, more than its maximum {highest}"
    return None


@rule("L46", WARNING, "ETG.2000 Info/SubItem has no subindex: paired with the type by name, in arrays by position")
def info_unpaired(subject: ObjectValues) -> Iterator[Found]:
    """A SubItem of Info matches no SubItem of the type, or an array has another number of them than elements."""
    infos = subject.declared.info_sub_items
    if not infos or subject.is_paired:
        return
    index = index_words(subject.declared.object_index)
    for words in subject.resolved.remarks:
        yield Found(f"object {index}: {words}: correct Info", ("info_sub_items", 0))
    members = len(subject.resolved.entries)
    names = {entry.name for entry in subject.resolved.entries}
    if (
        subject.resolved.object_code == OBJECT_CODES["ARRAY"]
        and len(infos) not in (members, members - 1)
        and not all((info.name or "").strip() in names for info in infos)
    ):
        yield Found(
            f"object {index}: Info has {len(infos)} SubItems, the array {members - 1} elements and SubIndex 0: "
            "give one for each",
            ("info_sub_items", 0),
        )


@rule("L47", WARNING, "ETG.2000 Info/DefaultString is for texts; numbers have DefaultData or DefaultValue")
def text_for_number(subject: ObjectValues) -> Iterator[Found]:
    """A number has a DefaultString."""
    found: list[tuple[ObjectEntry, str]] = []
    for entry in subject.with_values:
        if entry.default_kind != "string" or entry.base_type is None:
            continue
        base = BASE_TYPES[entry.base_type]
        if base.integral or base.kind == "real":
            is_number = entry.default_int is not None or entry.default_real is not None
            words = "read as a number" if is_number else "no number"
            said = f"{_words(subject, entry)} of type {entry.data_type}: {entry.default_raw!r}, {words}"
            found.append((entry, said))
    if found:
        numbers = listed([words for _, words in found])
        yield Found(f"DefaultString of a number ({numbers}): use DefaultData", _place(subject, found[0][0]))
