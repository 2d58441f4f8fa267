"""Decoding of declared values: bytes, numbers and texts of object entries (ESI-FACTS section 7.1)."""

import functools
import struct
from typing import NamedTuple

from esicatalog.esi.numbers import MAX_STORED, decode_hex_binary, parse_hex_dec
from esicatalog.model.base_types import BaseType

_HEX_PREFIXES = ("#x", "0x")


class Value(NamedTuple):
    """A declared value: text as in the file, kind (data, value or string) and what it decodes to."""

    raw: str | None
    kind: str | None
    number: int | None = None
    real: float | None = None
    text: str | None = None


def decode_data(raw: str, base: BaseType | None) -> Value:
    """A value given as bytes: little-endian, two's complement, IEEE 754; texts without trailing NUL."""
    return _decode_short(raw, base) if len(raw) <= _SHORT else _decode_data(raw, base)


def _decode_data(raw: str, base: BaseType | None) -> Value:
    data = decode_hex_binary(raw)
    if data is None or base is None:
        return Value(raw, "data")
    if base.integral:
        number = int.from_bytes(data, "little", signed=base.signed)
        return Value(raw, "data", number=number if -MAX_STORED <= number <= MAX_STORED else None)
    if base.kind == "real" and len(data) in (4, 8):
        (real,) = struct.unpack("<f" if len(data) == 4 else "<d", data)
        return Value(raw, "data", real=real if real == real and abs(real) != float("inf") else None)
    if base.kind == "string":
        return Value(raw, "data", text=_readable(data.rstrip(b"\0").decode("latin-1")))
    if base.kind == "unicode":
        return Value(raw, "data", text=_readable(data.decode("utf-16-le", "replace").rstrip("\0")))
    return Value(raw, "data")


_SHORT = 16
"""Digits of the widest number: few such texts, written in many places."""
_decode_short = functools.lru_cache(16_384)(_decode_data)


def decode_value(number: int | None, raw: str, base: BaseType | None) -> Value:
    """A value given as HexDecValue; on a REAL it is the number itself, in hex on a signed type its bits."""
    if base is not None and base.kind == "real" and number is not None:
        return Value(raw, "value", real=float(number))
    return Value(raw, "value", number=_signed(number, raw, base))


def decode_string(raw: str, base: BaseType | None) -> Value:
    """A value given as text; on a number type it is read as HexDecValue where possible."""
    if base is not None and base.integral:
        number = parse_hex_dec(raw)
        if number is not None and abs(number) <= MAX_STORED:
            return Value(raw, "string", number=_signed(number, raw, base))
    return Value(raw, "string", text=_readable(raw))


def _signed(number: int | None, raw: str, base: BaseType | None) -> int | None:
    """``#xFFF80000`` of a DINT is -524288: vendors write negative numbers as the bits that they are."""
    if number is None or base is None or not base.signed or base.bit_size is None:
        return number
    is_hex = raw.strip().lower().startswith(_HEX_PREFIXES)
    return number - (1 << base.bit_size) if is_hex and number >> (base.bit_size - 1) == 1 else number


def _readable(text: str) -> str:
    return text.replace("\0", "\N{REPLACEMENT CHARACTER}")
