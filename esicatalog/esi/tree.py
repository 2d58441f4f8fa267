"""The elements of a document that was read: asked for what records do not carry, lines and the order of children."""

from bisect import bisect_right
from itertools import accumulate

from lxml import etree

from esicatalog.esi.lines import Lines, Located
from esicatalog.esi.repeats import MARK, Cut

_Family = tuple[list[etree._Element], list[int] | None]
"""The elements at a path below another and, if something was cut out there, the number of the first that each of them
stands for, with the number of all behind."""


class DocumentTree:
    """Root element of a document, the lines of its elements, and what was cut out of it while reading."""

    def __init__(self, root: etree._Element, lines: Lines, cut: Cut | None = None) -> None:
        self.root = root
        self.cut = cut
        self._lines = lines
        self._families: dict[tuple[etree._Element, str], _Family] = {}

    def itself(self) -> "DocumentTree":
        """The tree: what gives it when it needs no work."""
        return self

    def located_root(self) -> Located:
        """The root with its line."""
        return Located(self.root, self._lines, 0)

    def element(self, around: Located, path: str, number: int) -> Located | None:
        """Element ``number`` from 0 at a path below another; one that was cut out stands alone."""
        elements, firsts = self._families.get((around.element, path)) or self._family(around.element, path)
        if self.cut is None or firsts is None:
            return Located(elements[number], around.lines, around.lines_before) if number < len(elements) else None
        if number >= firsts[-1]:
            return None
        at = bisect_right(firsts, number) - 1
        alone = self.cut.standing_alone(elements[at], number - firsts[at])
        return alone or Located(elements[at], around.lines, around.lines_before)

    def _family(self, inside: etree._Element, path: str) -> _Family:
        elements = inside.findall(path) if "/" in path else list(inside.iterchildren(path))
        firsts = None
        if self.cut is not None and any(element.get(MARK) for element in elements):
            firsts = list(accumulate(map(self.cut.count, elements), initial=0))
        family = self._families[inside, path] = (elements, firsts)
        return family

    def whole(self) -> etree._Element:
        """The root, with everything below it as the document has it."""
        if self.cut is not None:
            self.cut.unfold(self.root)
        return self.root
