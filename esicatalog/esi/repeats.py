"""Parts of documents that repeat word for word: recognised before the document is parsed, and read once.

Data types, objects and PDOs are most of the bytes of ESI documents, and four fifths of those bytes stood in an earlier
device of the same vendor in the very same words. A run of such parts is cut out of the document and a single marked
element left in its place; reading it gives the records that the same words gave before. A part that is new is looked
through for parts of its own, sub-items and entries, and read at once if it is laid out like others.

Cutting is a guess about the layout of the text, made without parsing; three things keep it honest. Only words are
recognised that were parsed before as a whole element of a well-formed document in the same encoding, or that
:mod:`esicatalog.esi.layouts` can read. The marks carry a number drawn when the process started, so no document can hold
one. And every mark must be met once where such a part belongs: a document in which one is not (it lay in a CDATA
section, say) is read again as it stands.
"""

import codecs
import re
import secrets
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from typing import Any

import msgspec
from lxml import etree

from esicatalog.esi.containers import MAX_DOCUMENT_BYTES
from esicatalog.esi.documents import NAMESPACE_PREFIX, declared_encoding, make_parser
from esicatalog.esi.lines import Lines, Located, has_bare_returns

MARK = f"repeated-{secrets.token_hex(8)}"
"""Attribute that tells what an element stands for; of those that stand for themselves too."""
_MARK_BYTES = MARK.encode()

_ASCII = b"us-ascii"
_UTF_8 = (b"", b"utf-8", b"utf8")
_ASCII_BASED = re.compile(rb"(us-ascii|utf-?8|iso-?8859-\d+|windows-125\d)?")
_LONGEST_HEAD = 10_000
_CAPACITY_BYTES = 64_000_000
"""Of the words that are remembered."""
_SECTIONS = ((b"<!--", b"-->"), (b"<![CDATA[", b"]]>"))
_LEADING = re.compile(rb"(?:[ \t\r\n]+|<!--.{0,1000}?-->)*", re.DOTALL)
"""Comments have a bounded length: none is sought for to the end of the document again and again."""


class _Kind:
    """What may be cut out: elements of one tag that stand one behind the other, and the parts that they may have."""

    def __init__(self, tag: str, record_name: str, inner: "_Kind | None" = None) -> None:
        self.record_name = record_name
        """Name of the type of record that it is read into."""
        self.start = f"<{tag}".encode()
        self.openings = (self.start + b">", self.start + b" ")
        self.closing = f"</{tag}>".encode()
        self.end = re.compile(self.closing + rb"[ \t\r\n]*")
        self.inner = inner
        self.run = f'<{tag} {MARK}="{record_name}">.</{tag}>'.encode()
        """Stands for a run where numbers do not matter."""


_ENTRIES = _Kind("Entry", "Entry")
_LISTS = {
    b"DataTypes": _Kind("DataType", "DataType", _Kind("SubItem", "SubItem")),
    b"Objects": _Kind("Object", "Object", _Kind("SubItem", "InfoSubItem")),
    b"Dc": _Kind("OpMode", "OpMode"),
}
"""What may be cut out at the beginning of an element, by its tag."""
_OTHERS = {
    b"RxPdo": _Kind("RxPdo", "Pdo", _ENTRIES),
    b"TxPdo": _Kind("TxPdo", "Pdo", _ENTRIES),
    b"SafetyParaMapping": _Kind("SafetyParaMapping", "Pdo", _ENTRIES),
    b"DiagMessage": _Kind("DiagMessage", "DiagMessage"),
}
"""What may be cut out anywhere, by its own tag."""
_STARTS = re.compile(rb"<(?:(%b)>|(%b)[ >])" % (b"|".join(_LISTS), b"|".join(_OTHERS)))

_Read = Callable[[type, bytes, Sequence[tuple[Any, ...]]], Any]


class Part(msgspec.Struct, gc=False, eq=False):
    """Words that may stand in documents again and, once they have been read without a finding, their record."""

    words: bytes
    """From the start tag to the blanks behind the end tag."""
    encoding: bytes
    line_count: int
    document: int
    """Number of the document in which it was met first: there it may be met again before it has been read."""
    record: Any = None
    follower: "Part | None" = None
    """What stood behind it last time: comparing words is faster than looking them up."""


_Marked = tuple[_Kind, Part | list[Part]]
"""A run of known parts, or a new part at its start."""
_Piece = bytes | _Marked


class Cut:
    """A document whose repeated parts are cut out, while it is being read."""

    def __init__(self, content: bytes, encoding: bytes, number: int, memory: "_Memory") -> None:
        self._encoding = encoding
        self._number = number
        self._memory = memory
        self._marks: list[_Marked] = []
        self._met = 0
        self._learned: list[Part] = []
        self._alone: dict[bytes, tuple[etree._Element, Lines]] = {}
        self._unclosed: set[_Kind] = set()
        """Kinds of which a start tag without an end tag was met: looking for more might take forever."""
        pieces: list[_Piece] = []
        pieces.append(content[self._cut_document(content, pieces) :])
        self.content = b"".join([piece if isinstance(piece, bytes) else self._mark(piece) for piece in pieces])
        self._prefixes = {prefix + b":" for prefix in NAMESPACE_PREFIX.findall(self.content)}

    @property
    def is_empty(self) -> bool:
        """Whether nothing was cut out or marked."""
        return not self._marks

    @property
    def is_complete(self) -> bool:
        """Whether every mark was met where such a part belongs, and what it stands for is known."""
        return self._met == len(self._marks)

    @property
    def record_types(self) -> frozenset[type]:
        """What :meth:`taken` has to be asked for."""
        return self._memory.record_types

    def _cut_document(self, content: bytes, pieces: list[_Piece]) -> int:
        """Append the document up to the last part; returns where that ends."""
        at = searched = 0
        while found := _STARTS.search(content, searched):
            kind, begin = (_LISTS[found[1]], found.end()) if found[1] else (_OTHERS[found[2]], found.start())
            pieces.append(content[at:begin])
            at = self._cut_parts(kind, content, begin, pieces)
            searched = max(at, found.end())
        return at

    def _cut_parts(self, kind: _Kind, text: bytes, at: int, pieces: list[_Piece]) -> int:
        """Append the parts that stand one behind the other from ``at`` on; returns where they end."""
        parts, number, encodings = self._memory.parts[kind], self._number, (_ASCII, self._encoding)
        previous: Part | None = None
        run: list[Part] = []
        while True:
            part = previous.follower if previous is not None else None
            if part is not None and text.startswith(part.words, at):
                begin, words = at, part.words
                end = at + len(words)
                if part.record is not None and part.encoding in encodings:
                    run.append(part)
                    previous = part
                    at = end
                    continue
            else:
                begin = at
                if not text.startswith(kind.openings, at):
                    if text.startswith(b"</", at):
                        break
                    begin = _LEADING.match(text, at).end()  # type: ignore[union-attr]
                    if not text.startswith(kind.openings, begin):
                        break
                if kind in self._unclosed:
                    break
                closed = kind.end.search(text, begin)
                if closed is None:
                    self._unclosed.add(kind)
                    break
                end = closed.end()
                words = text[begin:end]
                part = parts.get(words)
            left: list[_Piece] | None = None
            if part is None or part.encoding not in encodings or (part.record is None and part.document != number):
                part, left = self._look_at(kind, words)
            if run and (left or begin > at):
                pieces.append((kind, run))
                run = []
            if begin > at:
                pieces.append(text[at:begin])
            if part is not None and not left:
                run.append(part)
            elif left:
                pieces += left
            if previous is not None:
                previous.follower = part
            previous = part
            at = end
        if run:
            pieces.append((kind, run))
        return at

    def _look_at(self, kind: _Kind, words: bytes) -> tuple[Part | None, list[_Piece]]:
        """The part that new words are, and what of it is left to the parser: nothing if they could be read."""
        left = self._cut_inner(kind, kind.inner, words) if kind.inner is not None else []
        record = self._read(kind, words, left)
        if record is None and (words.find(kind.start, 1) >= 0 or not _is_whole(words)):
            return None, [words]
        part = self._memory.add(kind, words, self._encoding, self._number)
        if record is not None:
            part.record = record
            return part, []
        return part, [(kind, part), *(left or [words[len(kind.start) :]])]

    def _cut_inner(self, kind: _Kind, inner: _Kind, words: bytes) -> list[_Piece]:
        """A part behind the start of its tag, its inner parts cut out; nothing if it has none."""
        start = len(kind.start)
        first = words.find(inner.start, start)
        if first < 0:
            return []
        pieces: list[_Piece] = [words[start:first]]
        at = self._cut_parts(inner, words, first, pieces)
        pieces.append(words[at:])
        return pieces

    def _read(self, kind: _Kind, words: bytes, left: list[_Piece]) -> Any:
        """The record of a new part, given its words and what they are without inner parts."""
        memory = self._memory
        if not left:
            return memory.read(memory.record_types_by_kind[kind], words, ())
        pieces: list[bytes] = [kind.start]
        runs: list[tuple[Any, ...]] = []
        for piece in left:
            if isinstance(piece, bytes):
                pieces.append(piece)
                continue
            inner, parts = piece
            records = tuple([part.record for part in parts]) if isinstance(parts, list) else (None,)
            if None in records:
                return None
            pieces.append(inner.run)
            runs.append(records)
        return memory.read(memory.record_types_by_kind[kind], b"".join(pieces), runs)

    def _mark(self, marked: _Marked) -> bytes:
        """An element for a run of known parts, or the start of the tag of a new part.

        The element is as many lines long as the parts are: lines of findings stay right. It holds a text, because that
        is where libxml2 keeps lines above 65535.
        """
        kind, part = marked
        start = b'%b %b="%d"' % (kind.start, _MARK_BYTES, len(self._marks))
        self._marks.append(marked)
        if isinstance(part, Part):
            return start
        return start + b">." + kind.closing + b"\n" * sum([part.line_count for part in part])

    def taken(self, record_type: type, element: etree._Element) -> Part | tuple[Any, ...] | None:
        """What a marked element stands for: records, or a new part that has to be read; else None."""
        number = element.get(MARK)
        if number is None:
            return None
        kind, part = self._marks[int(number)]
        is_expected = self._memory.record_types_by_kind[kind] is record_type
        if isinstance(part, Part):
            self._met += is_expected
            return part
        records = tuple([item.record for item in part])
        self._met += is_expected and None not in records
        return records

    def learn(self, part: Part, record: Any) -> None:
        """Remember what a new part means, unless names in it depend on where it stands."""
        for prefix in self._prefixes:
            if prefix in part.words:
                return
        part.record = record
        self._learned.append(part)

    def settle(self) -> None:
        """The document was read: unless it is complete, forget what it taught.

        What stands in a comment or a CDATA section was taken for parts; then a record may hold a mark, or lack what a
        part of it stands for.
        """
        if not self.is_complete:
            for part in self._learned:
                part.record = None

    def count(self, element: etree._Element) -> int:
        """How many elements of the document an element of the cut one stands for."""
        return len(self._run(element)) or 1

    def standing_alone(self, element: etree._Element, number: int) -> Located | None:
        """One of the elements that an element stands for, in a tree of its own; None for one that was not cut out."""
        run = self._run(element)
        if not run:
            return None
        words = run[number].words
        alone = self._alone.get(words)
        if alone is None:
            alone = self._alone[words] = (self._parsed(words), Lines(words))
        return Located(*alone, self._lines_before(element, number))

    def _parsed(self, words: bytes) -> etree._Element:
        return etree.fromstring(words, self._parser)

    @cached_property
    def _parser(self) -> etree.XMLParser:
        return make_parser(encoding=self._encoding.decode() or None)

    def _lines_before(self, element: etree._Element, number: int) -> int:
        return (element.sourceline or 1) - 1 + sum([part.line_count for part in self._run(element)[:number]])

    def _run(self, element: etree._Element) -> Sequence[Part]:
        """The parts that an element stands for; empty for an element that was not cut out."""
        number = element.get(MARK)
        part = self._marks[int(number)][1] if number is not None else None
        return part if isinstance(part, list) else ()


class _Memory:
    """Parts by kind and words."""

    def __init__(self, record_types: Iterable[type], read: _Read) -> None:
        self.record_types = frozenset(record_types)
        by_name = {held.__name__: held for held in self.record_types}
        outer = [*_LISTS.values(), *_OTHERS.values()]
        kinds = outer + [kind.inner for kind in outer if kind.inner is not None]
        self.record_types_by_kind = {kind: by_name[kind.record_name] for kind in kinds}
        self.read = read
        """Gives the record of an element that needs no parsing."""
        self.parts: defaultdict[_Kind, dict[bytes, Part]] = defaultdict(dict)
        self.held_bytes = 0

    def add(self, kind: _Kind, words: bytes, encoding: bytes, document: int) -> Part:
        """A part that is new, in place of one that is of no use."""
        parts = self.parts[kind]
        if words not in parts:
            self.held_bytes += len(words)
        # Words of ASCII alone mean the same in all encodings that are recognised.
        encoding = _ASCII if words.isascii() else encoding
        part = parts[words] = Part(words, encoding, words.count(b"\n"), document)
        return part

    def forget(self) -> None:
        """Start anew."""
        for parts in self.parts.values():
            for part in parts.values():
                part.follower = None
        self.parts.clear()
        self.held_bytes = 0


class Repeats:
    """Knows the parts of the documents that one process has read; ``record_types`` are what parts are read into.

    ``read`` gives the record of an element that needs no parsing.
    """

    def __init__(self, record_types: Iterable[type], read: _Read) -> None:
        self._memory = _Memory(record_types, read)
        self._document_count = 0

    def cut(self, content: bytes) -> Cut | None:
        """``content`` with repeated parts cut out and new ones marked; None when it has none."""
        encoding = _encoding(content) if len(content) <= MAX_DOCUMENT_BYTES else None
        if encoding is None:
            return None
        if self._memory.held_bytes > _CAPACITY_BYTES:
            self._memory.forget()
        self._document_count += 1
        cut = Cut(content, encoding, self._document_count, self._memory)
        return None if cut.is_empty else cut


def _encoding(content: bytes) -> bytes | None:
    """The declared encoding, in which ASCII is ASCII; None for documents that are better left alone."""
    begins = content.find(b"<EtherCAT", 0, _LONGEST_HEAD)
    if begins < 0 or has_bare_returns(content):
        return None
    head = content[:begins].removeprefix(codecs.BOM_UTF8)
    encoding = declared_encoding(head) or b""
    if content.startswith(codecs.BOM_UTF8) and encoding not in _UTF_8:
        return None  # To the parser the byte order mark counts, not the declaration.
    return encoding if b"<!DOCTYPE" not in head and _ASCII_BASED.fullmatch(encoding) else None


def _is_whole(words: bytes) -> bool:
    """Whether words are nothing but elements and text, comments and CDATA sections."""
    if b"!" not in words and b"?" not in words:
        return True
    plain = _without_sections(words)
    return b"<!" not in plain and b"<?" not in plain


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
