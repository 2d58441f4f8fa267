"""Values in words, for comparisons: values with equal words are equal."""

from collections.abc import Callable
from typing import Any

import msgspec

from esicatalog.esi.records.common import Name, display_text

Show = Callable[[Any], str | None]
"""A value in words, None where it is not there. So ``#x10`` and ``16`` are equal, and an absent flag and ``0``."""


def text(value: Any) -> str | None:
    """The value as it is; an empty text is none."""
    return None if value is None else str(value) or None


def hexadecimal(digits: int) -> Show:
    """Numbers as ``0x`` and at least so many digits, in upper case up to four and in lower case above."""
    pattern = f"0x{{:0{digits}{'X' if digits <= 4 else 'x'}}}"
    return lambda value: pattern.format(value) if isinstance(value, int) else text(value)


def unit(name: str) -> Show:
    """Numbers with their unit."""
    return lambda value: f"{value} {name}" if isinstance(value, int) else text(value)


def counted(number: int, one: str, many: str | None = None) -> str:
    """A number of things."""
    return f"{number} {one if number == 1 else many or one + 's'}"


def byte_count(value: Any) -> str | None:
    """A length in bytes."""
    return counted(value, "byte") if isinstance(value, int) else text(value)


def yes_no(value: Any) -> str | None:
    """A flag; an absent one is off."""
    return value if isinstance(value, str) else "yes" if value else "no"


def supported(value: Any) -> str | None:
    """An element whose presence says that something is supported."""
    return "supported" if value else None


def sync_manager(value: Any) -> str | None:
    """The SyncManager that a PDO is assigned to by default."""
    return f"SM{value}" if value is not None else "not assigned"


def shown_text(names: tuple[Name, ...]) -> str | None:
    """Names, comments and links in the language in which they are shown."""
    return text(" ".join((display_text(names) or "").split()))


def hex_data(value: str | None) -> str | None:
    """Bytes in hex, in any case of letters."""
    return value.upper() if value else None


def listed(show: Show) -> Show:
    """Several values, one behind the other."""
    return lambda values: ", ".join(word for value in values if (word := show(value)) is not None) or None


def record_words(record: Any) -> str:
    """A record in full, by the names of its fields."""
    if isinstance(record, tuple):
        return "; ".join(map(record_words, record))
    if not isinstance(record, msgspec.Struct):
        return str(record)
    said = [(name, getattr(record, name)) for name in record.__struct_fields__ if name != "spelling"]
    return ", ".join(
        f"{name} ({record_words(value)})" if isinstance(value, tuple | msgspec.Struct) else f"{name} {value}"
        for name, value in said
        if value is not False and value not in (None, "", ())
    )


def records(value: Any) -> str | None:
    """A record, or a list of records, in full."""
    return text(record_words(value)) if value is not None else None


h2, h4, h8 = hexadecimal(2), hexadecimal(4), hexadecimal(8)
ns, ms = unit("ns"), unit("ms")
