"""The elements of a document that was read: asked for what records do not carry, lines and the order of children."""

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

    def unfold(self, around: etree._Element) -> None:
        """Make sure that the children of an element are all there."""
        if self.cut is not None and around.tag in LISTS:
            self.cut.unfold(around)

    def whole(self) -> etree._Element:
        """The root, with everything below it as the document has it."""
        for around in list(self.root.iter(*LISTS)):
            self.unfold(around)
        return self.root
