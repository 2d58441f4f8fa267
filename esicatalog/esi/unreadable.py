"""Values that stand in a document and could not be read: their record has None and keeps the text in its spelling.

Of bytes in hex the record has the text itself, readable or not.
Whoever uses the record takes them as absent, and has to say so. An empty text says nothing: it is absent.
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

from esicatalog.esi.binding import Field, Record, fields_of, is_record
from esicatalog.esi.numbers import HEX_BINARY, KEPT_AS_TEXT


class Unreadable(NamedTuple):
    """A value that could not be read."""

    place: str
    """Its path below the element that was asked about, as findings have it: ``Sm[2]/@Enable``."""
    problem: str
    """What stands there, and why it is no value: ``'1800h' is not a HexDecValue``."""


def unreadable_values(
    record: Record,
    is_wanted: Callable[[Record], bool],
    counts: Callable[[Record, str], bool] = lambda record, name: True,
) -> Iterator[Unreadable]:
    """The unreadable values of a record and of those records in it, at any depth, that are wanted.

    Of these the values that count: ``counts`` is given a record and the name of its field.
    """
    for field in fields_of(type(record)):
        held = getattr(record, field.name)
        if is_record(field.item):
            parts = held if field.many else [part for part in (held,) if part is not None]
            for number, part in enumerate(parts):
                if is_wanted(part):
                    step = f"{field.xml.path}[{number}]" if len(parts) > 1 else field.xml.path
                    for item in unreadable_values(part, is_wanted, counts):
                        yield Unreadable(f"{step}/{item.place}".removesuffix("/"), item.problem)
            continue
        if not counts(record, field.name):
            continue
        for position in range(len(held)) if field.many else (None,):
            problem = _problem(record, field, position)
            if problem is not None:
                yield Unreadable(_place(field), problem)


def unreadable(record: Record, name: str) -> str | None:
    """What stands where a field has its value, and why it is none; None for one that was read or is absent.

    Not for bytes in hex, which a record without any spelling can have.
    """
    if not record.spelling:
        return None
    return next((_problem(record, field, None) for field in fields_of(type(record)) if field.name == name), None)


def reason_words(record: Record, name: str) -> str:
    """What :func:`unreadable` says, in brackets behind the name of the value; empty where it says nothing."""
    problem = unreadable(record, name)
    return f" ({problem})" if problem is not None else ""


def _place(field: Field) -> str:
    attribute = field.xml.attribute
    return "/".join(filter(None, (field.xml.element, f"@{attribute}" if attribute else "")))


def _problem(record: Record, field: Field, position: int | None) -> str | None:
    """``position`` is that of a repeated value."""
    value, name = getattr(record, field.name), field.name
    if position is not None:
        value, name = value[position], f"{name}.{position}"
    text = value if field.xml.kind is HEX_BINARY else (record.spelling or {}).get(name)
    if not text or (value is not None and value is not text):
        return None
    remark = field.xml.kind.read(text).remark
    return remark.message.removesuffix(KEPT_AS_TEXT) if remark is not None else None
