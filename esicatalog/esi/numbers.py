"""Scalar values of ESI documents: text in, value out, and the spelling that would otherwise be lost.

A :class:`Scalar` parses the text of an element or attribute. Besides the value it returns the text itself when
that differs from the canonical spelling (so that a writer can repeat what the vendor wrote) and a remark when the
text breaks the format. Rules: ETG.2000 EtherCATBase.xsd ``HexDecValue``, ``xs:int``, ``xs:boolean``,
``xs:float``, ``xs:hexBinary``; tolerated spellings (``0x``, ``#x0x``) are those found in real files,
those with capitals (``#X``, ``True``), and a boolean as the number of a switch.
"""

import math
import re
from collections.abc import Callable
from typing import Any, NamedTuple

from esicatalog.identity import UINT32_MAX

MAX_STORED = (1 << 63) - 1
"""Largest integer that every supported database keeps; anything above is kept as text only."""

_INT32 = range(-(1 << 31), 1 << 31)

_HEX_DEC = re.compile(r"(?P<dec>[+-]?[0-9]+)|(?P<prefix>#x|#x0x|0x)(?P<hex>[0-9a-f]+)", re.IGNORECASE)
_REAL = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)(e[+-]?[0-9]+)?", re.IGNORECASE)
_NOT_FINITE = ("INF", "-INF", "NaN")
"""What xs:float knows besides numbers."""
_BOOLEANS = {"1": True, "true": True, "0": False, "false": False}


KEPT_AS_TEXT = "; kept as text"
"""Ends the words of a remark about a text that has no value."""
_SAYS_NOTHING = "; an empty text counts as absent"


class Remark(NamedTuple):
    """What is wrong with a text: lint rule id (ESI-FACTS section 20), severity (E, W or I) and words."""

    rule: str
    severity: str
    message: str


class Parsed(NamedTuple):
    """A parsed text. ``raw`` is None when the text is the canonical spelling of ``value``."""

    value: Any
    raw: str | None
    remark: Remark | None


class Scalar:
    """One kind of scalar: ``read(text)`` gives a :class:`Parsed`, ``spell(value)`` the canonical text.

    Texts are read as they stand in the document (surrounding blanks allowed).
    """

    __slots__ = ("_keep_raw", "_parse", "_strip", "name", "read", "spell")

    def __init__(
        self,
        name: str,
        parse: Callable[[str], tuple[Any, Remark | None]],
        spell: Callable[[Any], str],
        keep_raw: bool = True,
        strip: Callable[[str], str] = str.strip,
    ) -> None:
        self.name = name
        self._strip = strip
        self._keep_raw = keep_raw
        self.spell = spell
        self._parse = parse
        self.read: Callable[[str], Parsed] = _ReadTexts(self.read_anew).__getitem__

    def read_anew(self, text: str) -> Parsed:
        """What ``read`` gives, without looking whether the text was read before."""
        stripped = self._strip(text)
        value, remark = self._parse(stripped)
        differs = value is None or self.spell(value) != stripped
        return Parsed(value, stripped if differs and self._keep_raw else None, remark)


class _ReadTexts(dict[str, Parsed]):
    """The texts that were read before: the same few come thousands of times."""

    def __init__(self, read: Callable[[str], Parsed]) -> None:
        self._read = read

    def __missing__(self, text: str) -> Parsed:
        parsed = self._read(text)
        if len(text) < 64 and len(self) < 100_000:
            self[text] = parsed
        return parsed


def _quoted(text: str) -> str:
    return repr(text if len(text) <= 80 else text[:80] + "…")


def _no_value(rule: str, severity: str, text: str, problem: str) -> tuple[None, Remark]:
    """What comes of a text that has no value; an empty one says nothing, as if it were not there."""
    return None, Remark(rule, severity, f"{_quoted(text)} {problem}{KEPT_AS_TEXT if text else _SAYS_NOTHING}")


def parse_hex_dec(text: str) -> int | None:
    """The value of a HexDecValue (``402``, ``#x1A00``; tolerated: ``0x1a00``, ``#x0x1a00``, ``#X1A00``), or None."""
    match = _HEX_DEC.fullmatch(text.strip())
    if match is None or len(match[0]) > 64:
        return None
    return int(match["dec"]) if match["dec"] else int(match["hex"], 16)


def _hex_dec(limit: int, bits: int | None = None) -> Callable[[str], tuple[int | None, Remark | None]]:
    """Reads a HexDecValue up to ``limit``; one of ``bits`` bits has to fit these without sign."""
    fitting = range(1 << bits) if bits is not None else None

    def parse(text: str) -> tuple[int | None, Remark | None]:
        value = parse_hex_dec(text)
        if value is None:
            return _no_value("L06", "E", text, "is not a HexDecValue")
        if value > limit or (value < 0 and limit == UINT32_MAX) or value < -limit:
            return _no_value("L06", "E", text, "is out of range")
        if fitting is not None and value not in fitting:
            return value, Remark("L06", "E", f"{_quoted(text)} does not fit into {bits} bits; read as {value}")
        if text[:1] == "#" and text[2:4].lower() == "0x":
            return value, Remark("L06", "E", f"{_quoted(text)} carries two prefixes; read as {value}")
        if text[:2].lower() == "0x":
            return value, Remark("L06", "E", f"{_quoted(text)} has a C prefix instead of #x; read as {value}")
        if text[:2] == "#X":
            return value, Remark("L06", "E", f"{_quoted(text)} has the prefix #X instead of #x; read as {value}")
        return value, None

    return parse


_byte = _hex_dec(MAX_STORED, 8)
_number = _hex_dec(MAX_STORED)
_INT64_MIN, _UINT64_MAX = -(1 << 63), (1 << 64) - 1


def parse_value(text: str) -> int | None:
    """The number of a HexDecValue that 64 bits hold with or without sign, stored or not; None for other texts."""
    value = parse_hex_dec(text)
    return value if value is not None and _INT64_MIN <= value <= _UINT64_MAX else None


def _value(text: str) -> tuple[int | None, Remark | None]:
    """A number of 64 bits; one that no database keeps stays a text, which is no fault of it."""
    value, remark = _number(text)
    is_right = value is None and parse_value(text) is not None and not text.upper().startswith(("0X", "#X0X"))
    return (None, None) if is_right else (value, remark)


_SWITCHED = {"true": 1, "false": 0}


def _switch(
    parse: Callable[[str], tuple[int | None, Remark | None]],
) -> Callable[[str], tuple[int | None, Remark | None]]:
    """Reads a number that switches something on, its bit 0 or 1 alone; what a boolean says of it is clear."""

    def parse_switch(text: str) -> tuple[int | None, Remark | None]:
        value = _SWITCHED.get(text.lower())
        if value is None:
            return parse(text)
        return value, Remark("L06", "E", f"{_quoted(text)} is a boolean instead of a number; read as {value}")

    return parse_switch


def parse_real(text: str) -> float | None:
    """The value of an xs:float that is a finite number (``1.5``, ``-2E3``), or None."""
    value = float(text) if _REAL.fullmatch(text := text.strip()) else float("nan")
    return value if math.isfinite(value) else None


def _integer(text: str) -> tuple[int | None, Remark | None]:
    value = parse_hex_dec(text)
    if value is None or abs(value) > MAX_STORED:
        return _no_value("L06", "E", text, "is not an integer")
    if text[:1] in "#0" and text[1:2].lower() == "x":
        return value, Remark(
            "L06", "W", f"{_quoted(text)} is hexadecimal where the schema asks for decimal; read as {value}"
        )
    return value, None


def _int(text: str) -> tuple[int | None, Remark | None]:
    value, remark = _integer(text)
    if remark is None and value not in _INT32:
        remark = Remark("L06", "E", f"{_quoted(text)} is out of the range of xs:int (32 bits); read as {value}")
    return value, remark


def _boolean(text: str) -> tuple[bool | None, Remark | None]:
    value = _BOOLEANS.get(text.lower())
    if value is None:
        return _no_value("L03", "W", text, "is not a boolean")
    if text not in _BOOLEANS:  # xs:boolean knows small letters only
        return value, Remark("L03", "W", f"{_quoted(text)} is not spelled as a boolean; read as {text.lower()}")
    return value, None


def _float(text: str) -> tuple[float | None, Remark | None]:
    value = parse_real(text)
    if value is not None:
        return value, None
    is_real = text in _NOT_FINITE or _REAL.fullmatch(text) is not None  # the latter where it is too large
    return _no_value("L03", "W", text, f"is not a {'finite ' if is_real else ''}number")


def _hex_binary(text: str) -> tuple[str, Remark | None]:
    if text and decode_hex_binary(text) is None:
        return text, Remark("L07", "E", f"{text[:40]!r} is not hexBinary (pairs of hex digits)")
    return text, None


def _image(text: str) -> tuple[str, Remark | None]:
    digits = "".join(text.split()).upper()
    value, remark = _hex_binary(digits)
    return (text, remark) if remark else (value, None)


def _plain(text: str) -> tuple[str, Remark | None]:
    return text, None


def _spell_float(value: float) -> str:
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


def _spell_hex(value: int) -> str:
    return f"#x{value:04X}" if value >= 0 else str(value)  # a sign stands before decimal digits only


HEX = Scalar("HexDecValue", _hex_dec(MAX_STORED), _spell_hex)
"""HexDecValue usually written in hex: masks, notations."""
HEX16 = Scalar("HexDecValue (16 bits)", _hex_dec(MAX_STORED, 16), _spell_hex)
"""The same of 16 bits: indices of objects and PDOs, addresses and registers of the slave controller."""
HEX8 = Scalar("HexDecValue (8 bits)", _byte, _spell_hex)
"""The same of 8 bits: ControlByte."""
DEC = Scalar("HexDecValue", _hex_dec(MAX_STORED), str)
"""HexDecValue usually written in decimal: values, counts."""
DEC64 = Scalar("HexDecValue (64 bits)", _value, str)
"""The same of 64 bits: values of objects."""
DEC16 = Scalar("HexDecValue (16 bits)", _hex_dec(MAX_STORED, 16), str)
"""The same of 16 bits: lengths of SyncManagers."""
DEC8 = Scalar("HexDecValue (8 bits)", _byte, str)
"""The same of 8 bits: subindices."""
SWITCH = Scalar("HexDecValue", _switch(_number), str)
"""A number that is a switch, of which a boolean says as much: Default of a ModuleIdent."""
SWITCH8 = Scalar("HexDecValue (8 bits)", _switch(_byte), str)
"""The same of 8 bits, of which bit 0 is the switch: Enable of a SyncManager."""
IDENTITY = Scalar("HexDecValue (uint32)", _hex_dec(UINT32_MAX), lambda value: f"#x{value:08X}")
"""uint32 identity number: vendor, product, revision, serial, module ident."""
INT = Scalar("xs:int", _int, str)
INTEGER = Scalar("xs:integer", _integer, str)
"""An integer that the schema does not limit to 32 bits."""
BOOL = Scalar("xs:boolean", _boolean, lambda value: "1" if value else "0")
FLOAT = Scalar("xs:float", _float, _spell_float)
HEX_BINARY = Scalar("xs:hexBinary", _hex_binary, str)
IMAGE = Scalar("xs:hexBinary", _image, str, keep_raw=False)
"""Bytes of an image file; upper-case digits without blanks, or the text as it stands when that is not hexBinary."""
PHYSICS = Scalar("PhysicsType", _plain, str, strip=str.rstrip)
"""One character a port; a blank before others is an unused port, trailing ones mean nothing."""
TEXT = Scalar("xs:string", _plain, str)


def decode_hex_binary(text: str | None) -> bytes | None:
    """The bytes of a hexBinary text in wire order; None when it is absent, empty or malformed."""
    if not text:
        return None
    try:
        data = bytes.fromhex(text)
    except ValueError:
        return None
    return data if 2 * len(data) == len(text) else None  # fromhex() allows blanks
