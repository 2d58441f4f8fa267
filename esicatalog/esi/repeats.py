"""Parts of documents that repeat word for word: recognised before the document is parsed, and read once.

Data types and objects are nine tenths of the bytes of ESI documents, and four fifths of those bytes stood in an
earlier dictionary of the same vendor in the very same words. A run of such parts is cut out of the document and a
single marked element left in its place; reading it gives the records that the same words gave before.

Cutting is a guess about the layout of the text, made without parsing; three things keep it honest. Only words are
recognised that were parsed before as a whole element of a well-formed document in the same encoding. The marks carry
a number drawn when the process started, so no document can hold one. And every mark must be met once where such a
part belongs: a document in which one is not (it lay in a CDATA section, say) is read again as it stands.
"""

import codecs
import re
import secrets
from collections import defaultdict
from collections.abc import Iterator
from typing import Any, NamedTuple

from lxml import etree

from esicatalog.esi.containers import MAX_DOCUMENT_BYTES
from esicatalog.esi.documents import make_parser

_MARK = f"repeated-{secrets.token_hex(8)}"
_MARK_BYTES = _MARK.encode()

_ASCII = b"us-ascii"
_ASCII_BASED = re.compile(rb"(us-ascii|utf-?8|iso-?8859-\d+|windows-125\d)?")
_DECLARED_ENCODING = re.compile(rb"""\s*<\?xml[^>]*?encoding\s*=\s*["']([\w.-]+)["']""")
_LONGEST_HEAD = 10_000
_SECTIONS = ((b"<!--", b"-->"), (b"<![CDATA[", b"]]>"))
_LEADING = re.compile(rb"(?:\s+|<!--.*?-->)*", re.DOTALL)


class _Kind(NamedTuple):
    """A list of parts: the tags around it and around each part."""

    opening: re.Pattern[bytes]
    closing: bytes
    part_opening: bytes
    part_closing: bytes


_TYPES = _Kind(re.compile(rb"<DataTypes>"), b"</DataTypes>", b"<DataType", b"</DataType>")
_OBJECTS = _Kind(re.compile(rb"\s*<Objects>"), b"</Objects>", b"<Object", b"</Object>")


LISTS = ("DataTypes", "Objects")
"""Elements whose children may be cut out."""


class _Known(NamedTuple):
    words: bytes
    record: Any
    line_count: int


_Parts = dict[_Kind, dict[bytes, _Known]]


class _New:
    """A part met for the first time: its record is there once it has been read without a finding."""

    __slots__ = ("record", "words")

    def __init__(self, words: bytes) -> None:
        self.words = words
        self.record: Any = None


class Cut:
    """A document whose repeated parts are cut out, while it is being read."""

    def __init__(self, ascii_parts: _Parts, parts: _Parts, record_types: dict[type, _Kind]) -> None:
        self.content = b""
        self.encoding: str | None = None
        self.learned_bytes = 0
        self._ascii = ascii_parts
        self._known = parts
        self._record_types = record_types
        self._marks: list[tuple[_Kind, _New | list[_Known]]] = []
        self._new: _Parts = {_TYPES: {}, _OBJECTS: {}}
        self._met = 0

    @property
    def is_complete(self) -> bool:
        """Whether every mark was met where such a part belongs, and what it stands for is known."""
        return self._met == len(self._marks)

    def find(self, kind: _Kind, words: bytes) -> _Known | None:
        """What the words of a part mean; its record may be a new part of this document, yet to be read."""
        return self._ascii[kind].get(words) or self._known[kind].get(words) or self._new[kind].get(words)

    def mark_new(self, kind: _Kind, words: bytes) -> bytes:
        """The attribute that marks a new part."""
        new = _New(words)
        self._new[kind][words] = _Known(words, new, words.count(b"\n"))
        return self._mark(kind, new)

    def placeholder(self, kind: _Kind, run: list[_Known]) -> bytes:
        """An element for a run of known parts, as many lines long as they are: lines of findings stay right.

        It holds a text, because that is where libxml2 keeps lines above 65535.
        """
        blank_lines = b"\n" * sum(known.line_count for known in run)
        return kind.part_opening + self._mark(kind, run) + b">." + kind.part_closing + blank_lines

    def _mark(self, kind: _Kind, part: _New | list[_Known]) -> bytes:
        self._marks.append((kind, part))
        return b' %s="%d"' % (_MARK_BYTES, len(self._marks) - 1)

    def taken(self, record_type: type, element: etree._Element) -> _New | tuple[Any, ...] | None:
        """What a marked element stands for: records, or a new part that has to be read; else None."""
        kind = self._record_types.get(record_type)
        number = element.get(_MARK) if kind is not None else None
        if number is None:
            return None
        expected, part = self._marks[int(number)]
        if isinstance(part, _New):
            del element.attrib[_MARK]
            self._met += expected is kind
            return part
        records = tuple(item.record.record if type(item.record) is _New else item.record for item in part)
        self._met += expected is kind and None not in records
        return records

    def count(self, element: etree._Element) -> int:
        """How many elements of the document an element of the cut one stands for."""
        return len(self._run(element)) or 1

    def unfold(self, around: etree._Element) -> None:
        """Put the elements that were cut out back into a list of parts."""
        for element in list(around):
            at, run = around.index(element), self._run(element)
            if run:
                around[at : at + 1] = [self._parsed(element, number) for number in range(len(run))]

    def part(self, around: etree._Element, number: int) -> etree._Element | None:
        """Element ``number`` of a list of parts, with its lines; one that was cut out stands alone."""
        for element in around:
            run = self._run(element)
            if number < self.count(element):
                return self._parsed(element, number) if run else element
            number -= self.count(element)
        return None

    def _run(self, element: etree._Element) -> list[_Known]:
        """The parts that an element stands for; empty for an element that was not cut out."""
        number = element.get(_MARK)
        part = self._marks[int(number)][1] if number is not None else None
        return part if isinstance(part, list) else []

    def _parsed(self, element: etree._Element, number: int) -> etree._Element:
        run = self._run(element)
        kind = self._marks[int(element.get(_MARK) or 0)][0]
        lines_before = (element.sourceline or 1) - 1 + sum(known.line_count for known in run[:number])
        text = run[number].words.lstrip()
        blank_lines = run[number].words[: -len(text)].count(b"\n")
        # Lines are counted by the parser, which knows more of them than an element can be given.
        return etree.fromstring(
            b"\n" * (lines_before + blank_lines) + text + kind.part_closing, make_parser(encoding=self.encoding)
        )

    def learn(self, record_type: type, new: _New, record: Any, element: etree._Element) -> None:
        """Remember what a new part means, unless names in it depend on where it stands."""
        words = new.words
        if any(prefix is not None and f"{prefix}:".encode() in words for prefix in element.nsmap):
            return
        new.record = record
        parts = self._ascii if words.isascii() else self._known
        kind = self._record_types[record_type]
        parts[kind][words] = self._new[kind][words]._replace(record=record)
        self.learned_bytes += len(words)


class Repeats:
    """Knows the parts of the documents that one process has read."""

    def __init__(self, data_type: type, object_type: type, capacity_bytes: int = 48_000_000) -> None:
        self._record_types = {data_type: _TYPES, object_type: _OBJECTS}
        self._known: defaultdict[bytes, _Parts] = defaultdict(lambda: {_TYPES: {}, _OBJECTS: {}})
        """Parts by encoding; those of ASCII alone are the same in all that :func:`_encoding` lets through."""
        self._capacity_bytes = capacity_bytes
        self._held_bytes = 0
        self._last: Cut | None = None

    def cut(self, content: bytes) -> Cut | None:
        """``content`` with repeated parts cut out and new ones marked; None when it has no lists of parts."""
        if len(content) > MAX_DOCUMENT_BYTES:
            return None
        if self._last is not None:
            self._held_bytes += self._last.learned_bytes
            self._last = None
        if self._held_bytes > self._capacity_bytes:
            self._known.clear()
            self._held_bytes = 0
        encoding = _encoding(content)
        if encoding is None:
            return None
        self._last = cut = Cut(self._known[_ASCII], self._known[encoding], self._record_types)
        cut.encoding = encoding.decode() or None
        pieces: list[bytes] = []
        copied = 0
        for kind, start, end in _lists(content):
            pieces.append(content[copied:start])
            pieces.extend(_cut_list(kind, content[start:end], cut))
            copied = end
        if not copied:
            return None
        pieces.append(content[copied:])
        cut.content = b"".join(pieces)
        return cut


def _encoding(content: bytes) -> bytes | None:
    """The declared encoding, in which ASCII is ASCII; None for documents that are better left alone."""
    begins = content.find(b"<EtherCAT", 0, _LONGEST_HEAD)
    if begins < 0:
        return None
    head = content[:begins].removeprefix(codecs.BOM_UTF8)
    declared = _DECLARED_ENCODING.match(head)
    encoding = declared[1].lower() if declared else b""
    return encoding if b"<!DOCTYPE" not in head and _ASCII_BASED.fullmatch(encoding) else None


def _lists(content: bytes) -> Iterator[tuple[_Kind, int, int]]:
    """Where lists of parts lie. Objects are looked for right behind data types, as dictionaries have them."""
    opened = _TYPES.opening.search(content)
    while opened is not None:
        end = opened.end()
        for kind in (_TYPES, _OBJECTS):
            opened = kind.opening.match(content, opened.start() if kind is _TYPES else end + len(_TYPES.closing))
            if opened is None:
                break
            start, end = opened.end(), content.find(kind.closing, opened.end())
            if end < 0:
                return
            yield kind, start, end
        opened = _TYPES.opening.search(content, end)


def _cut_list(kind: _Kind, text: bytes, cut: Cut) -> Iterator[bytes]:
    *parts, rest = text.split(kind.part_closing)
    run: list[_Known] = []
    for words in parts:
        found = cut.find(kind, words)
        if found is not None:
            run.append(found)
            continue
        if run:
            yield cut.placeholder(kind, run)
            run = []
        if _is_whole(kind, words):
            at = _LEADING.match(words).end() + len(kind.part_opening)  # type: ignore[union-attr]
            yield words[:at] + cut.mark_new(kind, words) + words[at:]
        else:
            yield words
        yield kind.part_closing
    if run:
        yield cut.placeholder(kind, run)
    yield rest


def _is_whole(kind: _Kind, words: bytes) -> bool:
    """Whether a part is one element, but for its end tag, whose words mean the same wherever they stand."""
    plain = _without_sections(words).lstrip()
    opening = kind.part_opening
    return (
        plain.startswith((opening + b">", opening + b" "))
        and plain.count(opening + b">") + plain.count(opening + b" ") == 1
        and b"<!" not in plain
        and b"<?" not in plain
    )


def _without_sections(words: bytes) -> bytes:
    """Words without comments and CDATA sections; one that is not closed stays."""
    kept: list[bytes] = []
    at = 0
    while (start := words.find(b"<!", at)) >= 0:
        section = next((section for section in _SECTIONS if words.startswith(section[0], start)), None)
        end = words.find(section[1], start + len(section[0])) if section is not None else -1
        if section is None or end < 0:
            break
        kept.append(words[at:start])
        at = end + len(section[1])
    kept.append(words[at:])
    return b"".join(kept)
