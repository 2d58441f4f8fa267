"""Lines of elements: libxml2 counts line feeds, to 65535 only, and then goes by the texts around an element."""

import codecs
import re
from collections.abc import Mapping
from functools import cached_property
from itertools import accumulate, pairwise
from typing import NamedTuple

from lxml import etree

_UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_LAST_COUNTED = 65_535
_MOST_BYTES = 1_000_000_000
"""That are looked through for one tree, once a tag: some seconds. Elements of further tags keep the parser's line."""


def has_bare_returns(content: bytes) -> bool:
    """Whether carriage returns alone end the lines of a document (XML 1.0 section 2.11): libxml2 sees a single line."""
    return b"\n" not in content and b"\r" in content


def _in_ascii(content: bytes) -> bytes:
    """A document in an encoding based on ASCII."""
    return content.decode("utf-16", "replace").encode() if content.startswith(_UTF_16) else content


class Lines:
    """Lines of the elements of one tree, given the bytes that it was parsed from."""

    def __init__(self, content: bytes) -> None:
        self._content = _in_ascii(content)
        self._line_end = b"\r" if has_bare_returns(self._content) else b"\n"
        self._counted: dict[str, Mapping[etree._Element, int]] = {}
        self._most_tags = _MOST_BYTES // max(1, len(content))

    def of(self, element: etree._Element) -> int:
        """The line on which the start tag of an element ends, 0 = unknown.

        Where libxml2 does not count start tags are counted in the bytes, of UTF-16 and encodings based on ASCII.
        """
        line = element.sourceline or 0
        if line < _LAST_COUNTED and self._line_end == b"\n":
            return line
        tag = str(element.tag)
        if tag not in self._counted and len(self._counted) < self._most_tags:
            self._counted[tag] = self._count(tag, element.getroottree())
        return self._counted.get(tag, {}).get(element, line)

    def _count(self, tag: str, tree: "etree._ElementTree") -> Mapping[etree._Element, int]:
        """Lines of all elements of a tag; none where the bytes do not show as many of them as there are."""
        found = re.finditer(b"<" + re.escape(tag.encode()) + _REST_OF_START_TAG, self._plain)
        ends = [match.end() for match in found]
        alike = list(tree.iter(tag))
        if len(ends) != len(alike):
            return {}
        counts = accumulate(self._plain.count(self._line_end, before, end) for before, end in pairwise([0, *ends]))
        return {element: count + 1 for element, count in zip(alike, counts, strict=True)}

    @cached_property
    def _plain(self) -> bytes:
        """The bytes without what could hold the text of a start tag, of which the ends of lines stay."""
        return _SECTION.sub(lambda found: self._line_end * found[0].count(self._line_end), self._content)


class Located(NamedTuple):
    """An element of a tree of its own lines, which come behind ``lines_before`` others of the document."""

    element: etree._Element
    lines: Lines
    lines_before: int

    @property
    def line(self) -> int:
        """Its line in the document, 0 = unknown."""
        line = self.lines.of(self.element)
        return line and self.lines_before + line


_SECTION = re.compile(rb"<(?:!--.*?(?:-->|\Z)|!\[CDATA\[.*?(?:\]\]>|\Z)|\?.*?(?:\?>|\Z))", re.DOTALL)
"""A comment, CDATA section or instruction; one that is not closed goes to the end: nothing is looked through twice."""
_REST_OF_START_TAG = rb"""(?=[\s/>])(?:"[^"]*"|'[^']*'|[^>"'])*+>"""
"""Behind its name, which stands first: so the search jumps from one to the next."""
