"""The elements of a document that was read: asked for what records do not carry, lines and the order of children."""

from itertools import islice
from typing import NamedTuple

from lxml import etree

from esicatalog.esi.repeats import LISTS, Cut


class DocumentTree(NamedTuple):
    """Root element of a document, and what was cut out of it while reading."""

    root: etree._Element
    cut: Cut | None = None

    def itself(self) -> "DocumentTree":
        """The tree: what gives it when it needs no work."""
        return self

    def part(self, around: etree._Element, number: int) -> etree._Element | None:
        """Child ``number`` of an element of :data:`LISTS`."""
        return self.cut.part(around, number) if self.cut is not None else next(islice(around, number, None), None)

    def whole(self) -> etree._Element:
        """The root, with everything below it as the document has it."""
        if self.cut is not None:
            for around in list(self.root.iter(*LISTS)):
                self.cut.unfold(around)
        return self.root
