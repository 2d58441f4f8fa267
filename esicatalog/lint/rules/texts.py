"""Rules about names and images."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from typing import Any

from esicatalog.esi.binding import Record, fields_of
from esicatalog.esi.records.common import ENGLISH, Name
from esicatalog.esi.records.dictionary import DataType, Object
from esicatalog.esi.records.pdo import Pdo
from esicatalog.lint.registry import INFORMATION, WARNING, Found, Place, rule
from esicatalog.lint.subjects import InfoSubject

_NESTED: dict[type[Record], tuple[str, ...]] = {
    Pdo: ("entries",),
    DataType: ("enum_infos", "sub_items"),
}
"""Lists of records with names that are looked at with the record that holds them."""
_IMAGE_SIZE = (16, 14)
_HEADER_BYTES = 26


_HAS_SEVERAL: dict[type[Record], Callable[[Any], bool]] = {
    Object: lambda held: len(held.names) > 1 or len(held.comments) > 1 or len(held.display_names) > 1,
    Pdo: lambda held: (
        len(held.names) > 1 or any(len(entry.names) > 1 or len(entry.comments) > 1 for entry in held.entries)
    ),
    DataType: lambda held: (
        len(held.comments) > 1
        or any(len(item.display_names) > 1 or len(item.comments) > 1 for item in held.sub_items)
        or any(len(item.texts) > 1 or len(item.comments) > 1 for item in held.enum_infos)
    ),
}
"""Whether a list of names has several in a record or in those that it holds. Most records are of these types, and
seldom it has: so the fields are named here, which makes the look a short one."""


@rule("L17", WARNING, "ETG.2000 NameType: one element a language, LcId 1033 when absent")
def language_twice(record: Record) -> Iterable[Found]:
    """A name, comment or text is given twice in one language."""
    has_several = _HAS_SEVERAL.get(type(record))
    return _languages_twice(record) if has_several is None or has_several(record) else ()


def _languages_twice(record: Record) -> Iterator[Found]:
    yield from _in_lists((record,))
    for nested in _NESTED.get(type(record), ()):
        yield from _in_lists(getattr(record, nested), nested)


def _in_lists(records: Sequence[Record], nested: str = "") -> Iterator[Found]:
    for field, element in _name_fields(type(records[0])) if records else ():
        for position, record in enumerate(records):
            names: Sequence[Name] = getattr(record, field)
            if len(names) > 1:
                place: Place = (nested, position) if nested else ()
                yield from _second_ones(names, element, (*place, field))


@cache
def _name_fields(record_type: type[Record]) -> tuple[tuple[str, str], ...]:
    """Field and element of each list of names."""
    return tuple((f.name, f.xml.path) for f in fields_of(record_type) if f.many and f.item is Name)


def _second_ones(names: Sequence[Name], element: str, place: Place) -> Iterator[Found]:
    seen: set[int] = set()
    for number, name in enumerate(names):
        lcid = ENGLISH if name.lcid is None else name.lcid
        if lcid in seen:
            yield Found(
                f"{element} {name.text!r} is a second one with LcId {lcid}: only one of them is shown", (*place, number)
            )
        seen.add(lcid)


@rule("L64", INFORMATION, "ETG.2000 ImageData16x14: a Windows BMP file of 16 x 14 pixels")
def image(section: InfoSubject) -> Iterator[Found]:
    """An image is no Windows BMP of 16 x 14 pixels."""
    for place, record in section.with_images():
        if record.image_data:
            problem = _image_problem(record.image_data)
            if problem is not None:
                yield Found(f"ImageData16x14 {problem}", (*place, "image_data"))


def _image_problem(digits: str) -> str | None:
    try:
        header = bytes.fromhex(digits[: 2 * _HEADER_BYTES])
    except ValueError:
        return None  # not hexBinary: the reader says so
    if header[:2] != b"BM":
        return "is no Windows BMP file (it does not begin with 424D): tools show nothing"
    if len(header) < _HEADER_BYTES:
        return "ends within the header of a Windows BMP file: tools show nothing"
    size = tuple(abs(int.from_bytes(header[at : at + 4], "little", signed=True)) for at in (18, 22))
    return None if size == _IMAGE_SIZE else f"is {size[0]} x {size[1]} pixels; 16 x 14 are expected"
