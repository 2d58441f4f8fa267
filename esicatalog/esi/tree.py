"""The elements of a document that was read: asked for what records do not carry, lines and the order of children."""

from bisect import bisect_right
from itertools import accumulate
from typing import NamedTuple

from lxml import etree

from esicatalog.esi.repeats import Cut


class Located(NamedTuple):
    """An element; one that was cut out stands alone and has lines of its own, ``lines_before`` come before them."""

    element: etree._Element
    lines_before: int


class DocumentTree:
    """Root element of a document, and what was cut out of it while reading."""

    def __init__(self, root: etree._Element, cut: Cut | None = None) -> None:
        self.root = root
        self.cut = cut
        self._families: dict[tuple[etree._Element, str], tuple[list[etree._Element], list[int]]] = {}

    def itself(self) -> "DocumentTree":
        """The tree: what gives it when it needs no work."""
        return self

    def element(self, around: etree._Element, path: str, number: int) -> Located | None:
        """Element ``number`` from 0 at a path below another."""
        family = self._families.get((around, path))
        if family is None:
            elements = around.findall(path) if "/" in path else list(around.iterchildren(path))
            counts = [self.cut.count(element) for element in elements] if self.cut is not None else [1] * len(elements)
            family = self._families[around, path] = (elements, list(accumulate(counts, initial=0)))
        elements, firsts = family
        if number >= firsts[-1]:
            return None
        at = bisect_right(firsts, number) - 1
        if self.cut is None:
            return Located(elements[at], 0)
        return Located(*self.cut.standing_alone(elements[at], number - firsts[at]))

    def whole(self) -> etree._Element:
        """The root, with everything below it as the document has it."""
        if self.cut is not None:
            self.cut.unfold(self.root)
        return self.root
