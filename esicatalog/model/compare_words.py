"""Values in words, for comparisons: values with equal words are equal.

A value that could not be read is what the vendor wrote: two such texts are two values, and neither is an absent one.
"""

import json
from collections.abc import Callable, Iterable
from typing import Any

import msgspec

from esicatalog.esi.binding import Record
from esicatalog.esi.records.common import Name, display_text
from esicatalog.words import counted, one_line

Show = Callable[[Any], str | None]
"""A value in words, None where it is not there. So ``#x10`` and ``16`` are equal, and an absent flag and ``0``."""


def value_of(record: Any, field: str | Callable[[Any], Any]) -> Any:
    """The value of a field, by its name or computed; the vendor's text where it could not be read."""
    if not isinstance(field, str):
        return field(record)
    value, spelling = getattr(record, field), getattr(record, "spelling", None)
    if not spelling:
        return value
    if isinstance(value, tuple) and None in value:
        return tuple(spelling.get(f"{field}.{at}") if item is None else item for at, item in enumerate(value))
    return spelling.get(field) if value is None else value


def unread_words(record: Record, fields: Iterable[str] | None = None) -> str | None:
    """What the vendor wrote in fields (all by default) that could not be read; None where all were."""
    if not record.spelling:
        return None
    names = record.__struct_fields__ if fields is None else fields
    return (
        ", ".join(
            f"{name} {words}"
            for name in names
            if getattr(record, name) is None and (words := text(record.spelling.get(name))) is not None
        )
        or None
    )


def text(value: Any) -> str | None:
    """The value in one line, blanks as one; an empty text is none."""
    return None if value is None else one_line(str(value)) or None


def literal(value: str | None) -> str | None:
    """A text whose blanks count, in quotation marks."""
    return json.dumps(value, ensure_ascii=False) if value else None


def hexadecimal(digits: int) -> Show:
    """Numbers as ``0x`` and at least so many digits, in upper case up to four and in lower case above."""
    pattern = f"0x{{:0{digits}{'X' if digits <= 4 else 'x'}}}"
    return lambda value: pattern.format(value) if isinstance(value, int) else text(value)


def unit(name: str) -> Show:
    """Numbers with their unit."""
    return lambda value: f"{value} {name}" if isinstance(value, int) else text(value)


def byte_count(value: Any) -> str | None:
    """A length in bytes."""
    return counted(value, "byte") if isinstance(value, int) else text(value)


def yes_no(value: Any) -> str | None:
    """A flag; an absent one is off."""
    return text(value) if isinstance(value, str) and value else "yes" if value else "no"


def supported(value: Any) -> str | None:
    """An element whose presence says that something is supported."""
    return "supported" if value else None


def sync_manager(value: Any) -> str | None:
    """The SyncManager that a PDO is assigned to by default."""
    return f"SM{value}" if value is not None else "not assigned"


def shown_text(names: tuple[Name, ...]) -> str | None:
    """Names, comments and links in the language in which they are shown."""
    return text(display_text(names))


def hex_data(value: str | None) -> str | None:
    """Bytes in hex, in any case of letters."""
    return text(value.upper()) if value else None


def listed(show: Show) -> Show:
    """Several values, one behind the other; records with what could not be read of them."""
    return lambda values: ", ".join(filter(None, (_item_words(value, show) for value in values))) or None


def _item_words(value: Any, show: Show) -> str | None:
    words = show(value)
    unread = unread_words(value) if isinstance(value, Record) else None
    return words if unread is None else " ".join(filter(None, (words, f"({unread})")))


def record_words(record: Any) -> str:
    """A record in full, by the names of its fields."""
    if isinstance(record, tuple):
        return "; ".join(map(record_words, record))
    if not isinstance(record, msgspec.Struct):
        return str(record)
    said = [(name, value_of(record, name)) for name in record.__struct_fields__ if name != "spelling"]
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
