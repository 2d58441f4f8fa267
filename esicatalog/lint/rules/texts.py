"""Rules about names and images."""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from operator import attrgetter

from esicatalog.esi.binding import Record, fields_of
from esicatalog.esi.records.common import ENGLISH, Name
from esicatalog.esi.records.dictionary import DataType, EnumInfo, SubItem
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.lint.registry import INFORMATION, WARNING, Found, Place, rule
from esicatalog.lint.subjects import InfoSubject

_NESTED: dict[type[Record], tuple[tuple[str, type[Record]], ...]] = {
    Pdo: (("entries", Entry),),
    DataType: (("enum_infos", EnumInfo), ("sub_items", SubItem)),
}
"""Lists of records with names that are looked at with the record that holds them."""
_IMAGE_SIZE = (16, 14)
_HEADER_BYTES = 26


@cache
def _name_fields(record_type: type[Record]) -> tuple[tuple[str, str, Callable[[Record], Sequence[Name]]], ...]:
    """Field, element and access to the value of each list of names."""
    fields = [f for f in fields_of(record_type) if f.many and f.item is Name]
    return tuple((f.name, f.xml.path, attrgetter(f.name)) for f in fields)


@rule("L17", WARNING, "ETG.2000 NameType: one element a language, LcId 1033 when absent")
def language_twice(record: Record) -> Iterator[Found]:
    """A name, comment or text is given twice in one language."""
    yield from _languages_twice((record,), type(record))
    for nested, record_type in _NESTED.get(type(record), ()):
        yield from _languages_twice(getattr(record, nested), record_type, nested)


def _languages_twice(records: Sequence[Record], record_type: type[Record], nested: str = "") -> Iterator[Found]:
    for field, element, get in _name_fields(record_type):
        if max(map(len, map(get, records)), default=0) < 2:
            continue  # nearly always
        for position, record in enumerate(records):
            place: Place = (nested, position) if nested else ()
            yield from _second_ones(get(record), element, (*place, field))


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
    if header[:2] != b"BM" or len(header) < _HEADER_BYTES:
        return "is no Windows BMP file (it does not begin with 424D): tools show nothing"
    size = tuple(abs(int.from_bytes(header[at : at + 4], "little", signed=True)) for at in (18, 22))
    return None if size == _IMAGE_SIZE else f"is {size[0]} x {size[1]} pixels; 16 x 14 are expected"
