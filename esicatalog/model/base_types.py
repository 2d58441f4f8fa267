"""Base data types of CoE (ETG.1020, ETG.2000 table 12): code, width, kind; and the names vendors use for them."""

import functools
import re
from typing import NamedTuple


class BaseType(NamedTuple):
    """A base type. ``kind`` is bool, int, uint, bits, real, string, octets, unicode, time, guid or domain."""

    name: str
    code: int
    bit_size: int | None
    """Width, None where the declaration gives it."""
    kind: str

    @property
    def signed(self) -> bool:
        """Whether integers are two's complement."""
        return self.kind == "int"

    @property
    def of_any_width(self) -> bool:
        """Whether a declaration gives the width, as of texts: values may be shorter, what is left is filled up."""
        return self.kind in ("string", "octets", "unicode", "domain")

    @property
    def integral(self) -> bool:
        """Whether values are whole numbers."""
        return self.kind in ("bool", "int", "uint", "bits")


_FIXED = [
    BaseType("BOOL", 0x01, 1, "bool"),
    *(BaseType(n, c, b, "int") for n, c, b in (("SINT", 2, 8), ("INT", 3, 16), ("DINT", 4, 32), ("LINT", 0x15, 64))),
    *(BaseType(f"INT{b}", c, b, "int") for c, b in ((0x10, 24), (0x12, 40), (0x13, 48), (0x14, 56))),
    *(
        BaseType(n, c, b, "uint")
        for n, c, b in (("USINT", 5, 8), ("UINT", 6, 16), ("UDINT", 7, 32), ("ULINT", 0x1B, 64))
    ),
    *(BaseType(f"UINT{b}", c, b, "uint") for c, b in ((0x16, 24), (0x18, 40), (0x19, 48), (0x1A, 56))),
    *(BaseType(n, c, b, "bits") for n, c, b in (("BYTE", 0x1E, 8), ("WORD", 0x1F, 16), ("DWORD", 0x20, 32))),
    *(BaseType(f"BIT{b}", 0x2F + b, b, "bits") for b in range(1, 17)),
    *(BaseType(f"BITARR{b}", c, b, "bits") for c, b in ((0x2D, 8), (0x2E, 16), (0x2F, 32))),
    BaseType("REAL", 0x08, 32, "real"),
    BaseType("LREAL", 0x11, 64, "real"),
    BaseType("TIME_OF_DAY", 0x0C, 48, "time"),
    BaseType("TIME_DIFFERENCE", 0x0D, 48, "time"),
    BaseType("DOMAIN", 0x0F, None, "domain"),
    BaseType("GUID", 0x1D, 128, "guid"),
    BaseType("STRING", 0x09, None, "string"),
    BaseType("VISIBLE_STRING", 0x09, None, "string"),
    BaseType("OCTET_STRING", 0x0A, None, "octets"),
    BaseType("UNICODE_STRING", 0x0B, None, "unicode"),
]
BASE_TYPES: dict[str, BaseType] = {base.name: base for base in _FIXED}

_ALIASES = {
    "BOOLEAN": "BOOL",
    "BIT": "BOOL",
    "UINT8": "USINT",
    "UINT16": "UINT",
    "UINT32": "UDINT",
    "UINT64": "ULINT",
    "INT8": "SINT",
    "INT16": "INT",
    "INT32": "DINT",
    "INT64": "LINT",
    "UNSIGNED8": "USINT",
    "UNSIGNED16": "UINT",
    "UNSIGNED32": "UDINT",
    "UNSIGNED64": "ULINT",
    "INTEGER8": "SINT",
    "INTEGER16": "INT",
    "INTEGER32": "DINT",
    "INTEGER64": "LINT",
    "REAL32": "REAL",
    "REAL64": "LREAL",
    "FLOAT": "REAL",
    "DOUBLE": "LREAL",
}
TYPE_NAMES: dict[str, BaseType] = {
    **BASE_TYPES,
    **{alias: BASE_TYPES[name] for alias, name in _ALIASES.items()},
}
"""What a name in capitals means; texts, whose names have a length, apart."""
_SIZED = re.compile(r"(STRING|VISIBLE_STRING|OCTET_STRING|UNICODE_STRING)\s*\(\s*(\d+)\s*\)")
_ARRAY = re.compile(r"ARRAY\s*\[\s*(\d+)\s*\.\.\s*(\d+)\s*\]\s*OF\s+(\w+)")
_ARRAY_KINDS = {"BYTE": "OCTET_STRING", "USINT": "OCTET_STRING", "UINT": "UNICODE_STRING"}


@functools.lru_cache(4096)
def base_type(name: str | None) -> BaseType | None:
    """The base type that a type name means by itself (``UDINT``, ``STRING(16)``, ``ARRAY [0..7] OF BYTE``)."""
    if not name:
        return None
    text = name.strip().upper()
    found = TYPE_NAMES.get(text)
    if found is not None:
        return found
    sized = _SIZED.fullmatch(text)
    if sized is not None:
        unit_bits = 16 if sized[1] == "UNICODE_STRING" else 8
        return BASE_TYPES[sized[1]]._replace(bit_size=int(sized[2]) * unit_bits)
    array = _ARRAY.fullmatch(text)
    if array is not None and array[3] in _ARRAY_KINDS:
        element = BASE_TYPES[array[3]]
        count = int(array[2]) - int(array[1]) + 1
        return BASE_TYPES[_ARRAY_KINDS[array[3]]]._replace(bit_size=count * (element.bit_size or 8))
    return None
