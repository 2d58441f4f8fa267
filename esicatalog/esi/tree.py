"""The elements of a document that was read: asked for what records do not carry, lines and the order of children."""

from bisect import bisect_right
from itertools import accumulate

from lxml import etree

from esicatalog.esi.lines import Lines, Located
from esicatalog.esi.repeats import Cut


class DocumentTree:
    """Root element of a document, the lines of its elements, and what was cut out of it while reading."""

    def __init__(self, root: etree._Element, lines: Lines, cut: Cut | None = None) -> None:
        self.root = root
        self.cut = cut
        self._lines = lines
        self._families: dict[tuple[etree._Element, str], tuple[list[etree._Element], list[int]]] = {}

    def itself(self) -> "DocumentTree":
        """The tree: what gives it when it needs no work."""
        return self

    def located_root(self) -> Located:
        """The root with its line."""
        return Located(self.root, self._lines, 0)

    def element(self, around: Located, path: str, number: int) -> Located | None:
        """Element ``number`` from 0 at a path below another; one that was cut out stands alone."""
        family = self._families.get((around.element, path))
        if family is None:
            inside = around.element
            elements = inside.findall(path) if "/" in path else list(inside.iterchildren(path))
            counts = [self.cut.count(element) for element in elements] if self.cut is not None else [1] * len(elements)
            family = self._families[inside, path] = (elements, list(accumulate(counts, initial=0)))
        elements, firsts = family
        if number >= firsts[-1]:
            return None
        at = bisect_right(firsts, number) - 1
        alone = self.cut.standing_alone(elements[at], number - firsts[at]) if self.cut is not None else None
        return alone or around._replace(element=elements[at])

    def whole(self) -> etree._Element:
        """The root, with everything below it as the document has it."""
        if self.cut is not None:
            self.cut.unfold(self.root)
        return self.root
