"""C that takes a value out of the process image or puts it in, by type and place."""

from typing import NamedTuple

from esicatalog.export.c_text import comment_text
from esicatalog.export.sm_configuration import MappedEntry
from esicatalog.model.values import byte_length


class Place(NamedTuple):
    """Where a value lies, as C expressions: the byte it begins in, and the bit there (``0`` for the lowest)."""

    pointer: str
    bit: str


class Function(NamedTuple):
    """An inline function: its comment, its head and the lines of its body."""

    comment: str
    head: str
    body: tuple[str, ...]


def writer(entry: MappedEntry, name: str, arguments: str, body: tuple[str, ...]) -> Function:
    """The function of this name that stores ``value``; that of a value without a type is bytes."""
    value = "const uint8_t *value" if entry.value.kind == "bytes" else f"{c_type(entry)} value"
    return Function(comment_text(entry.words), f"static inline void {name}({arguments}, {value})", body)


def reader(entry: MappedEntry, name: str, arguments: str, body: tuple[str, ...]) -> Function:
    """The function of this name that returns the value; one without a type it copies to the bytes at ``value``."""
    head = f"static inline {c_type(entry)} {name}({arguments})"
    if entry.value.kind == "bytes":
        head = f"static inline void {name}({arguments}, uint8_t *value)"
    return Function(comment_text(entry.words), head, body)


def c_type(entry: MappedEntry) -> str:
    """The type of a variable that takes the value."""
    value = entry.value
    if value.kind == "real":
        return "float" if value.bit_length == 32 else "double"
    return f"{'int' if value.kind == 'int' else 'uint'}{value.container_bits}_t"


def byte_count(entry: MappedEntry) -> int:
    """Bytes that the value takes, the last one perhaps in part."""
    return byte_length(entry.bit_length)


def on_byte(entry: MappedEntry) -> bool:
    """Whether the value is known to begin with the lowest bit of a byte."""
    return entry.is_placed and entry.bit_offset % 8 == 0


def whole_bytes(entry: MappedEntry) -> bool:
    """Whether the value begins on a byte and fills bytes."""
    return on_byte(entry) and entry.bit_length % 8 == 0


def read_value(entry: MappedEntry, place: Place) -> tuple[str, ...]:
    """Body of a :func:`reader`, wherever the value lies."""
    if entry.value.kind == "bytes":
        return _read_long(entry, place)
    bits = f"esicatalog_read_bits({place.pointer}, {place.bit}, {entry.bit_length})"
    if entry.value.kind == "real":
        return real_from(entry, bits)
    if entry.value.kind == "int" and not entry.value.fills_container:
        bits = f"esicatalog_sign_extend({bits}, {entry.bit_length})"
    return (f"return ({c_type(entry)}) {bits};",)


def write_value(entry: MappedEntry, place: Place) -> tuple[str, ...]:
    """Body of a :func:`writer`, wherever the value lies."""
    if entry.value.kind == "bytes":
        return _write_long(entry, place)
    if entry.value.kind == "real":
        store = f"esicatalog_write_bits({place.pointer}, {place.bit}, {entry.bit_length}, raw);"
        return real_to(entry, store)
    # A negative value keeps its lower bits: two's complement.
    return (f"esicatalog_write_bits({place.pointer}, {place.bit}, {entry.bit_length}, (uint64_t) value);",)


def real_from(entry: MappedEntry, raw: str) -> tuple[str, ...]:
    """Body that returns the floating-point number whose IEEE 754 bits are ``raw``."""
    bits = f"uint{entry.bit_length}_t"
    return (
        f"const {bits} raw = ({bits}) {raw};",
        f"{c_type(entry)} value;",
        "memcpy(&value, &raw, sizeof(value));",
        "return value;",
    )


def real_to(entry: MappedEntry, store: str) -> tuple[str, ...]:
    """Body that stores the IEEE 754 bits ``raw`` of ``value``."""
    return (f"uint{entry.bit_length}_t raw;", "memcpy(&raw, &value, sizeof(raw));", store)


def _read_long(entry: MappedEntry, place: Place) -> tuple[str, ...]:
    """Body that copies a value of more than 64 bits that does not lie on whole bytes into ``value``."""
    count, last = byte_count(entry), entry.bit_length - 8 * (byte_count(entry) - 1)
    return (
        f"for (unsigned int i = 0; i < {count}; i++)",
        f"    value[i] = (uint8_t) esicatalog_read_bits({place.pointer}, {place.bit} + 8 * i, "
        f"i + 1 < {count} ? 8 : {last});",
    )


def _write_long(entry: MappedEntry, place: Place) -> tuple[str, ...]:
    """Body that copies ``value`` into a place of more than 64 bits that does not lie on whole bytes."""
    count, last = byte_count(entry), entry.bit_length - 8 * (byte_count(entry) - 1)
    return (
        f"for (unsigned int i = 0; i < {count}; i++)",
        f"    esicatalog_write_bits({place.pointer}, {place.bit} + 8 * i, i + 1 < {count} ? 8 : {last}, value[i]);",
    )
