"""Rules about names and images."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import chain
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


class _NameFields:
    """The fields of a record type that are lists of names."""

    def __init__(self, record_type: type[Record]) -> None:
        self._fields = [f for f in fields_of(record_type) if f.many and f.item is Name]
        names = [f.name for f in self._fields]
        # The first one twice: of a single attribute attrgetter makes no tuple.
        self._lists: Callable[[Record], Iterable[Sequence[Name]]] = (
            attrgetter(names[0], *names) if names else lambda _: ()
        )

    def have_several(self, records: Iterable[Record]) -> bool:
        """Whether a list has more than one name, which is seldom and seen at once."""
        return max(map(len, chain.from_iterable(map(self._lists, records))), default=0) > 1

    def second_ones(self, record: Record, place: Place) -> Iterator[Found]:
        """Names in a language that one before them in their list has."""
        for field in self._fields:
            yield from _second_ones(getattr(record, field.name), field.xml.path, (*place, field.name))


_name_fields = cache(_NameFields)


@rule("L17", WARNING, "ETG.2000 NameType: one element a language, LcId 1033 when absent")
def language_twice(record: Record) -> Iterator[Found]:
    """A name, comment or text is given twice in one language."""
    own = _name_fields(type(record))
    if own.have_several((record,)):
        yield from own.second_ones(record, ())
    for field, record_type in _NESTED.get(type(record), ()):
        fields, items = _name_fields(record_type), getattr(record, field)
        if fields.have_several(items):
            for number, item in enumerate(items):
                yield from fields.second_ones(item, (field, number))


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
