"""The elements of a document that was read: asked for what records do not carry, lines and the order of children."""

from bisect import bisect_right
from collections.abc import Iterator
from itertools import accumulate
from typing import NamedTuple

from lxml import etree

from esicatalog.esi.element_paths import ElementPaths
from esicatalog.esi.lines import Lines, Located
from esicatalog.esi.repeats import MARK, Cut

_Family = tuple[list[etree._Element], list[int]]
"""The elements at a path below another, and the number of the first that each of them stands for, with the number of
all behind: those that were cut out are many in one."""


class FoundElement(NamedTuple):
    """An element that was looked for below another one."""

    located: Located
    path: str
    """Its path below the other one, with a position wherever a tag repeats: there may be several containers."""


class DocumentTree:
    """Root element of a document, the lines of its elements, and what was cut out of it while reading."""

    def __init__(self, root: etree._Element, lines: Lines, cut: Cut | None = None) -> None:
        self.root = root
        self.cut = cut
        self._lines = lines
        self._paths = ElementPaths(cut.count) if cut is not None else ElementPaths()
        self._families: dict[tuple[etree._Element, str], _Family] = {}

    def itself(self) -> "DocumentTree":
        """The tree: what gives it when it needs no work."""
        return self

    def located_root(self) -> Located:
        """The root with its line."""
        return Located(self.root, self._lines, 0)

    def element(self, around: Located, path: str, number: int) -> FoundElement | None:
        """Element ``number`` from 0 of those at a path below another; one that was cut out stands alone."""
        if number == 0:  # mostly, and then nothing needs to be counted
            element = next(_at(around.element, path), None)
        else:
            elements, firsts = self._families.get((around.element, path)) or self._family(around.element, path)
            at = bisect_right(firsts, number) - 1
            element, number = elements[at] if at < len(elements) else None, number - firsts[at]
        if element is None:
            return None
        alone = self.cut.standing_alone(element, number) if self.cut is not None and element.get(MARK) else None
        located = alone or Located(element, around.lines, around.lines_before)
        return FoundElement(located, self._paths.path(element, around.element, number))

    def _family(self, inside: etree._Element, path: str) -> _Family:
        elements = list(_at(inside, path))
        cut = self.cut
        counts = [cut.count(element) if cut is not None and element.get(MARK) else 1 for element in elements]
        family = self._families[inside, path] = (elements, list(accumulate(counts, initial=0)))
        return family


def _at(inside: etree._Element, path: str) -> Iterator[etree._Element]:
    return inside.iterfind(path) if "/" in path else inside.iterchildren(path)
