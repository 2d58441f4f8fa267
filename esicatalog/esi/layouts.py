"""Parts that are laid out like others: read from their words, without the parser.

What is new in a document differs from what is known in its texts far more often than in what stands around them. The
tags of a part, from text to text, are its layout. A layout that is met again is learned from a specimen: numbers stand
in place of the texts, it is parsed and read like any element, and where a number comes out a text belongs. So elements
have their meaning from one place, :mod:`esicatalog.esi.binding`, and their structure from one parser.

Texts are taken that mean the same to every parser in every encoding: printable ASCII without markup and references.
A part with any other text, or one that brings a finding, is left to the parser.
"""

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from operator import itemgetter
from typing import Any, ClassVar

from lxml import etree

from esicatalog.esi.binding import Field, Record, Target, fields_of, is_record, read_record, shared, store
from esicatalog.esi.documents import make_parser
from esicatalog.esi.notes import Notes
from esicatalog.esi.numbers import TEXT, Remark
from esicatalog.esi.repeats import MARK

_TAGS = re.compile(r"(<[^!][^>]*+>(?:[ \t\r\n]*+<[^!][^>]*+>)*+)")
_COMMENTS = re.compile(r">(?:[ \t\r\n]*<!--(?:[\t\n\r -,.-~]|-[\t\n\r -,.-~])*-->)+")
_WORTH_LEARNING = 4
"""How often a layout has to be met: learning it takes as long as parsing some parts."""
_LONGEST_WORDS = 50_000
_CAPACITY = 2_000_000
"""Characters of the layouts that are kept; what is learned of them takes up to a hundred times as much."""
_MAX_KNOWN = 10_000
"""Records that are kept for parts of parts which are alike."""
_LONGEST_KNOWN = 200
"""Characters of the texts of such a record."""
_NUMBER = "0100000"
"""Begins the numbers of a specimen: read by all scalars but booleans, and no canonical spelling of a number."""
_NUMBERS = re.compile(rf"(?<!\d)0?{int(_NUMBER)}(\d{{3}})(?!\d)")
_MAX_TEXTS = 1_000
_NESTS_DEEP = etree.XPath(f"boolean(/*{'/*' * 50})")
"""The parser allows 256 elements within each other, among them those around a part."""


class Layouts:
    """The layouts that one process has met; ``record_types`` are those that runs of parts may stand for."""

    def __init__(self, record_types: Iterable[type]) -> None:
        self._specimen = _Specimen(record_types)
        self._layouts: dict[tuple[type, tuple[str, ...]], _Layout | None] = {}
        self._met: Counter[tuple[type, tuple[str, ...]]] = Counter()
        self._held = 0
        self._known: _Known = defaultdict(dict)

    def read(self, record_type: Any, words: bytes, runs: Sequence[tuple[Record, ...]] = ()) -> Record | None:
        """The record of an element; None when the parser has to look at it.

        ``runs`` are the records of the elements in it that bear the mark: its value is the name of their type.
        """
        if len(words) > _LONGEST_WORDS or not words.isascii():
            return None
        text = words.decode()
        pieces = _TAGS.split(_COMMENTS.sub(">", text) if "!" in text else text)
        texts = _meanings(pieces[2:-1:2])
        if texts is None or pieces[0] or pieces[-1].strip():
            return None
        layout = self._layout(record_type, tuple(pieces[1::2]))
        if layout is None:
            return None
        for place, records in zip(layout.runs, runs, strict=True):
            texts[place] = records
        try:
            return layout.record(texts)
        except _Unfit:
            return None

    def _layout(self, record_type: type, tags: tuple[str, ...]) -> "_Layout | None":
        key = (record_type, tags)
        try:
            return self._layouts[key]  # Tuples do not keep their hash: looking twice takes twice as long.
        except KeyError:
            self._met[key] += 1
        if self._met[key] >= _WORTH_LEARNING:
            layout = self._layouts[key] = self._learn(record_type, tags)
            return layout
        if self._met[key] == 1:
            self._held += sum(map(len, tags))
        if self._held > _CAPACITY:
            self._layouts.clear()
            self._met.clear()
            self._known.clear()
            self._held = 0
        return None

    def _learn(self, record_type: Any, tags: tuple[str, ...]) -> "_Layout | None":
        together = "".join(tags)
        if len(tags) > _MAX_TEXTS or str(int(_NUMBER)) in together or ":" in together or "xmlns" in together:
            return None
        numbers = [f"{_NUMBER}{place:03}" for place in range(len(tags) - 1)]
        places: dict[Any, int] = {int(number): place for place, number in enumerate(numbers)}
        places |= {number: place for place, number in enumerate(numbers)}
        notes = _SpecimenNotes(self._specimen)
        try:
            words = "".join([tag + number for tag, number in zip(tags, [*numbers, ""], strict=True)])
            element = etree.fromstring(words.encode(), make_parser())
            if _NESTS_DEEP(element):
                return None
            record = read_record(record_type, element, notes)
            layout = _Layout(record, places, self._known)
        except (etree.XMLSyntaxError, _Unfit):
            return None
        return layout if notes.are_sound and layout.places == list(range(len(numbers))) else None


def _meanings(texts: list[Any]) -> list[Any] | None:
    """What texts mean to any parser; None when that is not as plain as can be."""
    together = "".join(texts)
    if "<" in together:
        texts = [_without_section(text) if text.startswith("<") else text for text in texts]
        together = "".join(texts)
    if "\r" in together:
        texts = [text.replace("\r\n", "\n").replace("\r", "\n") for text in texts]
        together = "".join(texts)
    if not together.isprintable() and not together.replace("\n", "").replace("\t", "").isprintable():
        return None
    return None if "<" in together or ">" in together or "&" in together else texts


def _without_section(text: str) -> str:
    """The text of a CDATA section."""
    is_section = text.startswith("<![CDATA[") and text.endswith("]]>")
    return text[9:-3] if is_section else text


class _Unfit(Exception):
    """The parser has to look at a layout, or at a text in it."""


class _Specimen:
    """Tells of a specimen which of its elements stand for runs."""

    def __init__(self, record_types: Iterable[type]) -> None:
        self.record_types = frozenset(record_types)

    def taken(self, record_type: type, element: etree._Element) -> tuple[str | None, ...] | None:
        """The number that stands for records, instead of records."""
        return (element.text,) if element.get(MARK) == record_type.__name__ else None

    def learn(self, part: Any, record: Any) -> None:
        """Nothing is learned from numbers."""

    def count(self, element: etree._Element) -> int:
        """Positions of elements do not matter."""
        return 1


class _SpecimenNotes(Notes):
    """Notes on a specimen: what is remarked on its numbers says nothing about the texts that they stand for.

    They are too large for most fields; each text is looked at itself when it is met.
    """

    def __init__(self, specimen: _Specimen) -> None:
        super().__init__(cut=specimen)
        self._on_numbers = 0

    def remark(self, element: etree._Element, remark: Remark, attribute: str | None = None) -> None:
        """A scalar that breaks the format: a number, or what every part of the layout has."""
        super().remark(element, remark, attribute)
        self._on_numbers += attribute is None and _NUMBERS.fullmatch(element.text or "") is not None

    @property
    def are_sound(self) -> bool:
        """Whether nothing was found but what is remarked on numbers."""
        return len(self.findings) == self._on_numbers


_Known = defaultdict[str, dict[Any, tuple[Record]]]
"""Records of parts of records by their texts, by what layouts of such parts have in common."""


class _Layout:
    """How a record is made from texts; ``places`` are those of the numbers that its specimen has instead of them."""

    __slots__ = (
        "_collected", "_constants", "_lists", "_parts", "_record_type", "_spelling", "_targets", "_texts",
        "places", "runs",
    )  # fmt: skip

    def __init__(self, record: Record, places: dict[Any, int], known: _Known) -> None:
        self._record_type = type(record)
        self._spelling = {name: text for name, text in (record.spelling or {}).items() if text not in places}
        """Spellings of attributes."""
        if list(self._spelling) != list(record.spelling or ())[: len(self._spelling)]:
            raise _Unfit  # They would have to stand between those of texts.
        self._constants: dict[str, Any] = {}
        self._texts: list[tuple[str, int]] = []
        self._targets: list[tuple[Target, int]] = []
        self._collected: list[str] = []
        """Fields of several texts each."""
        self._parts: list[tuple[str, _Part]] = []
        self._lists: list[tuple[str, _Part]] = []
        for field in fields_of(type(record)):
            value: Any = getattr(record, field.name)
            if isinstance(value, tuple) and value and is_record(field.item):
                parts = [_part(item, places, known) for item in value]
                self._lists.append((field.name, parts[0] if len(parts) == 1 else _Several(parts)))
            elif isinstance(value, Record):
                self._parts.append((field.name, _part(value, places, known)))
            elif value is not None and value != ():
                self._take(field, value, places)
        self._targets.sort(key=itemgetter(1))
        parts = [part for _, part in self._parts + self._lists]
        self.runs: list[int] = sorted(place for part in parts for place in part.runs)
        """Places of records instead of texts."""
        found = [place for _, place in [*self._texts, *self._targets]]
        self.places: list[int] = sorted([*found, *(place for part in parts for place in part.places)])
        """Of everything that goes into the record."""

    def _take(self, field: Field, value: Any, places: dict[Any, int]) -> None:
        if field.many:
            if not places.keys() >= set(value):
                raise _Unfit
            self._collected.append(field.name)
            self._targets += [(Target(field.name, field.xml.kind, True), places[item]) for item in value]
        elif value not in places:
            self._constants[field.name] = value
        elif field.xml.kind is TEXT:
            self._texts.append((field.name, places[value]))
        else:
            self._targets.append((Target(field.name, field.xml.kind, False), places[value]))

    def record(self, texts: Sequence[Any]) -> Record:
        """The record; raises :class:`_Unfit` for texts that bring a finding."""
        values = self._constants.copy()
        if self._spelling:
            values["spelling"] = self._spelling.copy()
        for name, place in self._texts:
            values[name] = texts[place].strip()
        for target, place in self._targets:
            if store(target, texts[place], values) is not None:
                raise _Unfit
        for name in self._collected:
            values[name] = tuple(values[name])
        for name, part in self._parts:
            values[name] = part.records(texts)[0]
        for name, part in self._lists:
            values[name] = part.records(texts)
        return self._record_type(**values)


class _Constant:
    """A part of a record that has no texts."""

    __slots__ = ("_records",)
    places: ClassVar[Sequence[int]] = ()
    runs: ClassVar[Sequence[int]] = ()

    def __init__(self, record: Record) -> None:
        self._records = (record,)

    def records(self, texts: Sequence[Any]) -> tuple[Record, ...]:
        return self._records


class _Run:
    """Parts of a record that were known before."""

    __slots__ = ("_place", "places", "runs")

    def __init__(self, place: int) -> None:
        self._place = place
        self.places: Sequence[int] = (place,)
        self.runs: Sequence[int] = (place,)

    def records(self, texts: Sequence[Any]) -> tuple[Record, ...]:
        found: tuple[Record, ...] = texts[self._place]
        return found


class _Repeating:
    """A part of a record that is made from texts; those of different records are often the same."""

    __slots__ = ("_key", "_known", "_layout", "places")
    runs: ClassVar[Sequence[int]] = ()

    def __init__(self, layout: _Layout, known: dict[Any, tuple[Record]]) -> None:
        self.places: Sequence[int] = layout.places
        self._layout = layout
        self._key = itemgetter(*self.places)
        self._known = known
        if layout.runs:
            raise _Unfit

    def records(self, texts: Sequence[Any]) -> tuple[Record, ...]:
        key = self._key(texts)
        known = self._known.get(key)
        if known is None:
            known = (shared(self._layout.record(texts)),)
            if len(self._known) < _MAX_KNOWN and sum(map(len, key)) < _LONGEST_KNOWN:
                self._known[key] = known
        return known


class _Several:
    """Parts of a record behind each other."""

    __slots__ = ("_parts", "places", "runs")

    def __init__(self, parts: "Sequence[_Part]") -> None:
        self._parts = parts
        self.places: Sequence[int] = [place for part in parts for place in part.places]
        self.runs: Sequence[int] = [place for part in parts for place in part.runs]

    def records(self, texts: Sequence[Any]) -> tuple[Record, ...]:
        return tuple([record for part in self._parts for record in part.records(texts)])


_Part = _Constant | _Run | _Repeating | _Several


def _part(value: Any, places: dict[Any, int], known: _Known) -> _Part:
    if not isinstance(value, Record):
        return _Run(places[value])
    layout = _Layout(value, places, known)
    if not layout.places:
        return _Constant(value)
    # Numbers are counted anew: then parts that differ only in where they stand are the same.
    alike = _NUMBERS.sub(lambda found: str(int(found[1]) - layout.places[0]), repr(value))
    return _Repeating(layout, known[alike])
