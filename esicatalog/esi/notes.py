"""What the reader notices while it reads: findings with line numbers, and values that no record field holds."""

from collections.abc import Callable, Container, Sequence
from typing import Any, Protocol

import msgspec
from lxml import etree

from esicatalog.errors import BrokenDocument
from esicatalog.esi.element_paths import ElementPaths
from esicatalog.esi.numbers import Remark

MAX_FINDINGS = 100_000
"""That reading one document may bring, and values outside the schema that it may hold; real ones bring hundreds."""
REFUSED = "L01"
"""The rule for what a strict XML parser refuses: it is about a document as a whole, whatever its line."""
_LONGEST_MESSAGE = 300
_TOO_MANY = f"more than {MAX_FINDINGS} values outside the schema or against its rules; no ESI document holds"


class Finding(msgspec.Struct, frozen=True, gc=False):
    """One thing worth telling about a document (rule ids of ESI-FACTS section 20)."""

    rule: str
    severity: str
    message: str
    line: int
    path: str = ""


class Unmapped(msgspec.Struct, frozen=True, gc=False):
    """A value that no record field holds: its path below the owning element, and its text."""

    path: str
    value: str


class Recognised(Protocol):
    """Knows elements of a document that need no reading."""

    @property
    def record_types(self) -> frozenset[type]:
        """What :meth:`taken` has to be asked for."""

    def taken(self, record_type: type, element: etree._Element) -> Any:
        """Records that an element stands for, as a tuple; else what :meth:`learn` wants, or None."""

    def learn(self, part: Any, record: Any) -> None:
        """What was read."""

    def count(self, element: etree._Element) -> int:
        """How many elements of the document an element stands for."""


def _source_line(element: etree._Element) -> int:
    return element.sourceline or 0


class Notes:
    """Collects findings and unmapped values of one document.

    ``cut`` knows what parts of it mean without reading, ``line_of`` the lines of its elements.
    """

    def __init__(
        self,
        owners: frozenset[type] = frozenset(),
        cut: Recognised | None = None,
        line_of: Callable[[etree._Element], int] = _source_line,
    ) -> None:
        self.findings: list[Finding] = []
        self.unmapped: list[Unmapped] = []
        self._kept_count = 0
        self._base: etree._Element | None = None
        self._cut = cut
        self._line_of = line_of
        self._paths = ElementPaths(cut.count) if cut is not None else ElementPaths()
        self._owners = owners
        self.watched: frozenset[Any] = owners | (cut.record_types if cut is not None else frozenset())
        """Record types that :meth:`read_child` has to be asked for."""

    def path(self, element: etree._Element, base: etree._Element | None = None) -> str:
        """Path of ``element`` below ``base`` (or from the root on), with a position wherever a tag repeats."""
        return self._paths.path(element, base)

    def remark(self, element: etree._Element, remark: Remark, attribute: str | None = None) -> None:
        """A scalar that breaks the format: the text of ``element``, or one of its attributes."""
        place = str(element.tag) if attribute is None else f"{element.tag!s}/@{attribute}"
        self.find(element, remark.rule, remark.severity, f"{place}: {remark.message}")

    def find(self, element: etree._Element, rule: str, severity: str, message: str) -> None:
        """A finding at ``element``."""
        if len(message) > _LONGEST_MESSAGE:
            message = message[: _LONGEST_MESSAGE - 1] + "…"
        if len(self.findings) >= MAX_FINDINGS:
            raise BrokenDocument(_TOO_MANY, self._line_of(element))
        self.findings.append(Finding(rule, severity, message, self._line_of(element), self.path(element)))

    def misplaced(self, element: etree._Element, child: etree._Element, known: Container[Any]) -> None:
        """A child of ``element`` that the schema has before the one it stands behind; it has a place for ``known``."""
        before = next(sibling.tag for sibling in child.itersiblings(preceding=True) if sibling.tag in known)
        message = f"{element.tag!s}: {child.tag!s} stands behind {before!s}; the schema has it before"
        self.find(element, "L04", "W", message)

    def read_as_one(self, element: etree._Element) -> None:
        """Another one of what the schema has once, whose parts are read as those of the first."""
        self.find(element, "L05", "W", f"element {element.tag!s} occurs again; read as one with the first")

    def given_together(self, element: etree._Element, paths: Sequence[str]) -> None:
        """Elements of which the schema has one only; the first of ``paths`` counts."""
        words = f"{' and '.join(paths)} are given, of which the schema has one only; {paths[0]} counts"
        self.find(element, "L05", "W", f"{element.tag!s}: {words}")

    def unmapped_attribute(self, element: etree._Element, name: str, text: str, repeated: bool = False) -> None:
        """An attribute that no field takes."""
        words = "repeats a value given before" if repeated else "is unknown"
        self.find(element, "L05", "W", f"attribute {element.tag!s}/@{name} {words}; kept in unmapped")
        self._keep(f"{self.path(element, self._base)}/@{name}", text)

    def unmapped_text(self, element: etree._Element, text: str, repeated: bool = False) -> None:
        """Text where the schema has none, or a second value for a single field."""
        words = "occurs again" if repeated else "holds stray text"
        self.find(element, "L05", "W", f"{element.tag!s} {words}; kept in unmapped")
        self._keep(self.path(element, self._base), text.strip())

    def unmapped_element(self, element: etree._Element, repeated: bool = False) -> None:
        """An element that no field takes: one finding, every value and every empty element of its subtree kept."""
        words = "occurs again" if repeated else "is unknown here"
        self.find(element, "L05", "W", f"element {element.tag!s} {words}; kept in unmapped")
        for part in element.iter():
            path = self.path(part, self._base)
            text = (part.text or "").strip()
            # An empty element says something by being there, as CoE does.
            if text or not (len(part) or part.attrib):
                self._keep(path, text)
            if part is not element and part.tail and part.tail.strip():
                self._keep(path + "/following-text", part.tail.strip())
            for name, text in part.attrib.items():
                self._keep(f"{path}/@{name}", str(text))

    def _keep(self, path: str, value: str) -> None:
        self._kept_count += 1
        if self._kept_count > MAX_FINDINGS:
            raise BrokenDocument(_TOO_MANY)
        self.unmapped.append(Unmapped(path, value))

    def read_child(
        self, record_type: Any, element: etree._Element, read: Callable[[Any, Any, "Notes"], Any]
    ) -> tuple[Any, ...]:
        """The records of a watched element: one, or a run that was cut out.

        Words read before give their records again; an owner takes the unmapped values found below it.
        """
        if record_type in self._owners:
            return (self._read_owner(record_type, element, read),)
        part = self._cut.taken(record_type, element) if self._cut is not None else None
        if isinstance(part, tuple):
            return part
        before = len(self.findings)
        record = read(record_type, element, self)
        if part is not None and self._cut is not None and before == len(self.findings):
            self._cut.learn(part, record)
        return (record,)

    def _read_owner(self, record_type: Any, element: etree._Element, read: Callable[[Any, Any, "Notes"], Any]) -> Any:
        outer_base, outer_unmapped = self._base, self.unmapped
        self._base, self.unmapped = element, []
        record = read(record_type, element, self)
        if self.unmapped:
            record = msgspec.structs.replace(record, unmapped=tuple(self.unmapped))
        self._base, self.unmapped = outer_base, outer_unmapped
        return record
