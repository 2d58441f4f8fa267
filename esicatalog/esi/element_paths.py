"""Paths of elements as findings and unmapped values have them: tags, with a position from 0 where one repeats."""

from collections import Counter
from collections.abc import Callable

from lxml import etree


def _one(element: etree._Element) -> int:
    return 1


class ElementPaths:
    """Paths in one document; the children of an element are counted once.

    ``count`` tells how many elements of the document an element stands for.
    """

    def __init__(self, count: Callable[[etree._Element], int] = _one) -> None:
        self._count = count
        self._families: dict[etree._Element, dict[etree._Element, int]] = {}

    def path(self, element: etree._Element, base: etree._Element | None = None, number: int = 0) -> str:
        """Path of ``element`` below ``base`` (or from the root on): ``Sm[2]/Foo``.

        ``number`` is which of those that it stands for, from 0.
        """
        steps: list[str] = []
        node: etree._Element | None = element
        while node is not None and node is not base:
            parent = node.getparent()
            position = self._position(node, parent) if parent is not None else None
            steps.append(str(node.tag) if position is None else f"{node.tag!s}[{position + number}]")
            node, number = parent, 0
        return "/".join(reversed(steps))

    def _position(self, element: etree._Element, parent: etree._Element) -> int | None:
        """The position among the siblings of the same tag, None for the only one."""
        family = self._families.get(parent)
        if family is None:
            counts = [(child, self._count(child)) for child in parent]
            sizes: Counter[object] = Counter()
            for child, count in counts:
                sizes[child.tag] += count
            seen: Counter[object] = Counter()
            family = self._families[parent] = {}
            for child, count in counts:
                if sizes[child.tag] > 1:
                    family[child] = seen[child.tag]
                    seen[child.tag] += count
        return family.get(element)
