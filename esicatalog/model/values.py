"""Decoding of declared values: bytes, numbers and texts of object entries (ESI-FACTS section 7.1)."""

import functools
import struct
from typing import NamedTuple

from esicatalog.esi.numbers import MAX_STORED, decode_hex_binary, parse_hex_dec, parse_real, parse_value
from esicatalog.model.base_types import BaseType

_HEX_PREFIXES = ("#x", "0x")


class Value(NamedTuple):
    """A declared value: text as in the file, kind (data, value or string) and what it decodes to."""

    raw: str | None
    kind: str | None
    number: int | None = None
    real: float | None = None
    text: str | None = None


def byte_length(bits: int) -> int:
    """Bytes that so many bits take, the last one perhaps in part."""
    return (bits + 7) // 8


def number_words(number: int) -> str:
    """``123 (0x7B)``; up to 9, and below zero, the decimal number says all."""
    return f"{number} (0x{number:X})" if number > 9 else str(number)


def decode_data(raw: str, base: BaseType | None, bit_size: int | None) -> Value:
    """A value given as bytes: little-endian, two's complement, IEEE 754; texts without trailing NUL.

    Of more bytes than a number has, the first ones in the order on the wire are the value; fewer are the low ones of an
    integer, whose others are zero.
    """
    return _decode_short(raw, base, bit_size) if len(raw) <= _SHORT else _decode_data(raw, base, bit_size)


def number_size(given: int, base: BaseType, bit_size: int | None) -> int:
    """Bytes of a number of which so many are given.

    The declared width decides, not the name of the type (ESI-FACTS section 6.3); where the two differ, bytes that fill
    the type are a whole number, too.
    """
    own = byte_length(base.bit_size or 0)
    return own if given == own or bit_size is None or bit_size <= 0 else byte_length(bit_size)


def fills(given: int, base: BaseType | None, bit_size: int) -> bool:
    """Whether so many bytes are a value of a type (None: not known): as many as it has.

    Texts and domains may be shorter; those of no bits, as STRING(0), are of any length.
    """
    wanted = byte_length(bit_size)
    return given == wanted or (base is not None and base.of_any_width and (given < wanted or not bit_size))


def _decode_data(raw: str, base: BaseType | None, bit_size: int | None) -> Value:
    data = decode_hex_binary(raw)
    if data is None or base is None:
        return Value(raw, "data")
    size = number_size(len(data), base, bit_size)
    if base.integral:
        number = int.from_bytes(data[:size], "little", signed=base.signed and len(data) >= size)
        return Value(raw, "data", number=number if -MAX_STORED <= number <= MAX_STORED else None)
    if base.kind == "real" and (layout := _REALS.get(len(data[:size]))) is not None:
        (real,) = struct.unpack(layout, data[:size])
        return Value(raw, "data", real=real if real == real and abs(real) != float("inf") else None)
    if base.kind == "string":
        return Value(raw, "data", text=_readable(data.rstrip(b"\0").decode("latin-1")))
    if base.kind == "unicode":
        return Value(raw, "data", text=_readable(data.decode("utf-16-le", "replace").rstrip("\0")))
    return Value(raw, "data")


_REALS = {4: "<f", 8: "<d"}
"""Layout of floating point numbers by their bytes."""
_SHORT = 16
"""Digits of the widest number: few such texts, written in many places."""
_decode_short = functools.lru_cache(16_384)(_decode_data)


def decode_value(number: int | None, raw: str, base: BaseType | None) -> Value:
    """A value given as HexDecValue; on a REAL it is the number itself, in hex on a signed type its bits.

    ``number`` is None for a text of 64 bits that no database keeps as number; of a signed type it may be one that does.
    """
    if base is not None and base.kind == "real" and number is not None:
        return Value(raw, "value", real=float(number))
    meant = spelled_number(raw, base) if number is None else _signed(number, raw, base)
    return Value(raw, "value", number=meant if meant is not None and abs(meant) <= MAX_STORED else None)


def spelled_number(raw: str, base: BaseType | None) -> int | None:
    """The number that a HexDecValue of up to 64 bits spells, stored or not; None where it spells none."""
    return _signed(parse_value(raw), raw, base)


def decode_string(raw: str, base: BaseType | None) -> Value:
    """A value given as text; on a number type it is read as the number that it spells where possible."""
    if base is not None and base.integral:
        number = parse_hex_dec(raw)
        if number is not None and abs(number) <= MAX_STORED:
            return Value(raw, "string", number=_signed(number, raw, base))
    if base is not None and base.kind == "real" and (real := parse_real(raw)) is not None:
        return Value(raw, "string", real=real)
    return Value(raw, "string", text=_readable(raw))


def _signed(number: int | None, raw: str, base: BaseType | None) -> int | None:
    """``#xFFF80000`` of a DINT is -524288: vendors write negative numbers as the bits that they are."""
    if number is None or base is None or not base.signed or base.bit_size is None:
        return number
    is_hex = raw.strip().lower().startswith(_HEX_PREFIXES)
    return number - (1 << base.bit_size) if is_hex and number >> (base.bit_size - 1) == 1 else number


def _readable(text: str) -> str:
    return text.replace("\0", "\N{REPLACEMENT CHARACTER}")
