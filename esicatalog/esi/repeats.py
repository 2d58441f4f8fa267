"""Parts of documents that repeat word for word: recognised before the document is parsed, and read once.

Data types, objects and PDOs are most of the bytes of ESI documents, and four fifths of those bytes stood in an earlier
device of the same vendor in the very same words. A run of such parts is cut out of the document and a single marked
element left in its place; reading it gives the records that the same words gave before. A part that is new is looked
through for parts of its own: sub-items, flags, entries.

Cutting is a guess about the layout of the text, made without parsing; three things keep it honest. Only words are
recognised that were parsed before as a whole element of a well-formed document in the same encoding. The marks carry
a number drawn when the process started, so no document can hold one. And every mark must be met once where such a
part belongs: a document in which one is not (it lay in a CDATA section, say) is read again as it stands.
"""

import codecs
import re
import secrets
from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import Any

from lxml import etree

from esicatalog.esi.containers import MAX_DOCUMENT_BYTES
from esicatalog.esi.documents import make_parser
from esicatalog.esi.lines import LAST_COUNTED

MARK = f"repeated-{secrets.token_hex(8)}"
"""Attribute that tells what an element stands for; of those that stand for themselves too."""
_MARK_BYTES = MARK.encode()

_ASCII = b"us-ascii"
_ASCII_BASED = re.compile(rb"(us-ascii|utf-?8|iso-?8859-\d+|windows-125\d)?")
_DECLARED_ENCODING = re.compile(rb"""\s*<\?xml[^>]*?encoding\s*=\s*["']([\w.-]+)["']""")
_LONGEST_HEAD = 10_000
_SECTIONS = ((b"<!--", b"-->"), (b"<![CDATA[", b"]]>"))
_LEADING = re.compile(rb"(?:\s+|<!--.{0,1000}?-->)*", re.DOTALL)
"""Comments have a bounded length: none is sought for to the end of the document again and again."""
_BLANKS = re.compile(rb"\s*")
_PREFIX = re.compile(rb"xmlns:([^\s=]+)")


class _Kind:
    """What may be cut out: elements of one tag that stand one behind the other.

    ``inner`` are the parts that such an element may have, in the order of the schema.
    """

    def __init__(self, tag: str, *inner: "_Kind") -> None:
        self.start = f"<{tag}".encode()
        self.openings = (self.start + b">", self.start + b" ")
        self.closing = f"</{tag}>".encode()
        self.expected = (*self.openings, b"</")
        """What comes behind such an element, unless that is a comment."""
        self.inner = inner


_FLAGS = _Kind("Flags")
_MEMBERS, _VALUES, _ENTRIES = _Kind("SubItem", _FLAGS), _Kind("SubItem"), _Kind("Entry")
_TYPES = _Kind("DataType", _MEMBERS)
_OBJECTS = _Kind("Object", _VALUES, _FLAGS)
_PDOS = {b"R": _Kind("RxPdo", _ENTRIES), b"T": _Kind("TxPdo", _ENTRIES)}

_KINDS: dict[str, tuple[_Kind, ...]] = {
    "DataType": (_TYPES,),
    "SubItem": (_MEMBERS,),
    "Object": (_OBJECTS,),
    "InfoSubItem": (_VALUES,),
    "Flags": (_FLAGS,),
    "Pdo": tuple(_PDOS.values()),
    "Entry": (_ENTRIES,),
}
"""What may be cut out, by the name of the type of record that it is read into."""

_FIRST_LIST = b"<DataTypes>"
_SECOND_LIST = re.compile(rb"</DataTypes>\s*<Objects>")
_PDO = re.compile(rb"<([RT])xPdo[ >]")


class Part:
    """Words that may stand in documents again and, once they have been read without a finding, their record."""

    __slots__ = ("document", "encoding", "follower", "line_count", "record", "words")

    def __init__(self, words: bytes, encoding: bytes, document: int) -> None:
        self.words = words
        """From the start tag to the blanks behind the end tag."""
        self.encoding = encoding
        self.line_count = words.count(b"\n")
        self.document = document
        """Number of the document in which it was met first: there it may be met again before it has been read."""
        self.record: Any = None
        self.follower: Part | None = None
        """What stood behind it last time: comparing words is faster than looking them up."""


class Cut:
    """A document whose repeated parts are cut out, while it is being read."""

    def __init__(self, content: bytes, encoding: bytes, number: int, memory: "_Memory") -> None:
        self._encoding = encoding
        self._number = number
        self._memory = memory
        self._marks: list[tuple[_Kind, Part | list[Part]]] = []
        self._met = 0
        self._alone: dict[tuple[bytes, int], etree._Element] = {}
        self._unclosed: set[_Kind] = set()
        """Kinds of which a start tag without an end tag was met: looking for more might take forever."""
        pieces: list[bytes] = []
        pieces.append(content[self._cut_document(content, pieces) :])
        self.content = b"".join(pieces)
        self._prefixes = {prefix + b":" for prefix in _PREFIX.findall(self.content)}

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

    def _cut_document(self, content: bytes, pieces: list[bytes]) -> int:
        """Append the document up to the last part; returns where that ends."""
        at = 0
        while True:
            opened = content.find(_FIRST_LIST, at)
            at = self._cut_pdos(content, at, opened if opened >= 0 else len(content), pieces)
            if opened < 0:
                return at
            at = self._cut_list(_TYPES, content, at, opened + len(_FIRST_LIST), pieces)
            second = _SECOND_LIST.match(content, _LEADING.match(content, at).end())  # type: ignore[union-attr]
            if second is not None:
                at = self._cut_list(_OBJECTS, content, at, second.end(), pieces)

    def _cut_list(self, kind: _Kind, content: bytes, at: int, begin: int, pieces: list[bytes]) -> int:
        """Append the document up to the parts of a list that begins at ``begin``; returns where they end."""
        pieces.append(content[at:begin])
        return self._cut_parts(kind, content, begin, pieces)

    def _cut_pdos(self, content: bytes, at: int, end: int, pieces: list[bytes]) -> int:
        """Append the document up to the last PDO before ``end``; returns where that ends."""
        searched = at
        while found := _PDO.search(content, searched, end):
            at = self._cut_list(_PDOS[found[1]], content, at, found.start(), pieces)
            searched = max(at, found.end())
        return at

    def _cut_parts(self, kind: _Kind, text: bytes, at: int, pieces: list[bytes], is_plain: bool = False) -> int:
        """Append the parts that stand one behind the other from ``at`` on; returns where they end.

        ``is_plain`` tells that nothing but elements and text stands there.
        """
        previous: Part | None = None
        run: list[Part] = []
        while True:
            part = previous.follower if previous is not None else None
            if part is not None and text.startswith(part.words, at) and self._is_usable(part):
                run.append(part)
                previous = part
                at += len(part.words)
                continue
            begin = at if text.startswith(kind.expected, at) else _LEADING.match(text, at).end()  # type: ignore[union-attr]
            if not text.startswith(kind.openings, begin) or kind in self._unclosed:
                break
            end = text.find(kind.closing, begin)
            if end < 0:
                self._unclosed.add(kind)
                break
            end = _BLANKS.match(text, end + len(kind.closing)).end()  # type: ignore[union-attr]
            words = text[begin:end]
            part = self._memory.find(kind, words)
            if part is not None and not self._is_usable(part):
                part = None
            if run and (part is None or begin > at):
                pieces.append(self._placeholder(kind, run))
                run = []
            pieces.append(text[at:begin])
            at = end
            if part is not None:
                run.append(part)
            elif words.find(kind.start, 1) < 0 and ((simple := is_plain or _is_plain(words)) or _is_whole(words)):
                part = self._memory.add(kind, words, self._encoding, self._number)
                self._mark_new(kind, part, simple, pieces)
            else:
                pieces.append(words)
            if previous is not None:
                previous.follower = part
            previous = part
        if run:
            pieces.append(self._placeholder(kind, run))
        return at

    def _is_usable(self, part: Part) -> bool:
        return (part.record is not None or part.document == self._number) and part.encoding in (_ASCII, self._encoding)

    def _mark_new(self, kind: _Kind, part: Part, is_plain: bool, pieces: list[bytes]) -> None:
        """Append a new part, marked, its inner parts cut out."""
        words, at = part.words, len(kind.start)
        pieces.append(kind.start + self._mark(kind, part))
        for inner in kind.inner:
            first = words.find(inner.start, at)
            if first >= 0:
                pieces.append(words[at:first])
                at = self._cut_parts(inner, words, first, pieces, is_plain)
        pieces.append(words[at:])

    def _placeholder(self, kind: _Kind, run: list[Part]) -> bytes:
        """An element for a run of known parts, as many lines long as they are: lines of findings stay right.

        It holds a text, because that is where libxml2 keeps lines above 65535.
        """
        blank_lines = b"\n" * sum([part.line_count for part in run])
        return kind.start + self._mark(kind, run) + b">." + kind.closing + blank_lines

    def _mark(self, kind: _Kind, part: Part | list[Part]) -> bytes:
        self._marks.append((kind, part))
        return b' %s="%d"' % (_MARK_BYTES, len(self._marks) - 1)

    def taken(self, record_type: type, element: etree._Element) -> Part | tuple[Any, ...] | None:
        """What a marked element stands for: records, or a new part that has to be read; else None."""
        number = element.get(MARK)
        if number is None:
            return None
        kind, part = self._marks[int(number)]
        is_expected = self._memory.record_type(kind) is record_type
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

    def count(self, element: etree._Element) -> int:
        """How many elements of the document an element of the cut one stands for."""
        return len(self._run(element)) or 1

    def unfold(self, root: etree._Element) -> None:
        """Put all elements that were cut out back into the tree, and take the marks away."""
        for element in list(root.iter()):
            around = element.getparent()
            if around is not None and self._run(element):
                at = around.index(element)
                around[at : at + 1] = [self.itself(element, number) for number in range(self.count(element))]
            element.attrib.pop(MARK, None)

    def itself(self, element: etree._Element, number: int) -> etree._Element:
        """Element ``number`` of those that an element stands for, with its lines; one that was cut out stands alone."""
        run = self._run(element)
        if not run:
            return element
        # Lines are counted by the parser, which knows more of them than an element can be given.
        return self._parsed(b"\n" * self._lines_before(element, number) + run[number].words)

    def standing_alone(self, element: etree._Element, number: int) -> tuple[etree._Element, int]:
        """:meth:`itself` with lines of its own, and how many lines come before it; for many looks at many parts."""
        run = self._run(element)
        if not run:
            return element, 0
        part, lines_before = run[number], self._lines_before(element, number)
        # The parser has lines beyond the last counted one from texts: it must meet the part on the same side of it.
        crosses = lines_before < LAST_COUNTED <= lines_before + part.line_count
        blank_lines = lines_before if crosses else LAST_COUNTED if lines_before >= LAST_COUNTED else 0
        alone = self._alone.get((part.words, blank_lines))
        if alone is None:
            # Within a comment the parser counts lines four times as fast.
            before = b"<!--%b-->" % (b"\n" * blank_lines) if blank_lines else b""
            alone = self._alone[part.words, blank_lines] = self._parsed(before + part.words)
        return alone, lines_before - blank_lines

    def _parsed(self, words: bytes) -> etree._Element:
        return etree.fromstring(words, make_parser(encoding=self._encoding.decode() or None))

    def _lines_before(self, element: etree._Element, number: int) -> int:
        return (element.sourceline or 1) - 1 + sum([part.line_count for part in self._run(element)[:number]])

    def _run(self, element: etree._Element) -> Sequence[Part]:
        """The parts that an element stands for; empty for an element that was not cut out."""
        number = element.get(MARK)
        part = self._marks[int(number)][1] if number is not None else None
        return part if isinstance(part, list) else ()


class _Memory:
    """Parts by kind and words; words of ASCII alone mean the same in all encodings that :func:`_encoding` allows."""

    def __init__(self, record_types: Iterable[type]) -> None:
        self.record_types = frozenset(record_types)
        self._record_types = {kind: held for held in self.record_types for kind in _KINDS[held.__name__]}
        self._ascii: defaultdict[_Kind, dict[bytes, Part]] = defaultdict(dict)
        self._others: defaultdict[_Kind, dict[bytes, Part]] = defaultdict(dict)
        self.held_bytes = 0

    def record_type(self, kind: _Kind) -> type:
        """What parts of a kind are read into."""
        return self._record_types[kind]

    def find(self, kind: _Kind, words: bytes) -> Part | None:
        """A part of these words, whatever is known of it."""
        return (self._ascii if words.isascii() else self._others)[kind].get(words)

    def add(self, kind: _Kind, words: bytes, encoding: bytes, document: int) -> Part:
        """A part that is new, in place of one that is of no use."""
        is_ascii = words.isascii()
        parts = (self._ascii if is_ascii else self._others)[kind]
        if words not in parts:
            self.held_bytes += len(words)
        part = parts[words] = Part(words, _ASCII if is_ascii else encoding, document)
        return part

    def forget(self) -> None:
        """Start anew."""
        for parts in (*self._ascii.values(), *self._others.values()):
            for part in parts.values():
                part.follower = None
        self._ascii.clear()
        self._others.clear()
        self.held_bytes = 0


class Repeats:
    """Knows the parts of the documents that one process has read; ``record_types`` are what parts are read into."""

    def __init__(self, record_types: Iterable[type], capacity_bytes: int = 64_000_000) -> None:
        self._memory = _Memory(record_types)
        self._capacity_bytes = capacity_bytes
        self._document_count = 0

    def cut(self, content: bytes) -> Cut | None:
        """``content`` with repeated parts cut out and new ones marked; None when it has none."""
        encoding = _encoding(content) if len(content) <= MAX_DOCUMENT_BYTES else None
        if encoding is None:
            return None
        if self._memory.held_bytes > self._capacity_bytes:
            self._memory.forget()
        self._document_count += 1
        cut = Cut(content, encoding, self._document_count, self._memory)
        return None if cut.is_empty else cut


def _encoding(content: bytes) -> bytes | None:
    """The declared encoding, in which ASCII is ASCII; None for documents that are better left alone."""
    begins = content.find(b"<EtherCAT", 0, _LONGEST_HEAD)
    if begins < 0:
        return None
    head = content[:begins].removeprefix(codecs.BOM_UTF8)
    declared = _DECLARED_ENCODING.match(head)
    encoding = declared[1].lower() if declared else b""
    return encoding if b"<!DOCTYPE" not in head and _ASCII_BASED.fullmatch(encoding) else None


def _is_plain(words: bytes) -> bool:
    """Whether words are nothing but elements and text."""
    return b"<!" not in words and b"<?" not in words


def _is_whole(words: bytes) -> bool:
    """Whether words are plain but for comments and CDATA sections."""
    return _is_plain(_without_sections(words))


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
