"""Rules across documents: they look at light facts of many devices, never at all their records.

The facts come from documents that were just read (:func:`facts_of_document`) or from the rows of a catalog.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.notes import Finding
from esicatalog.esi.reader import ReadDocument
from esicatalog.esi.records.device import Device, HideType
from esicatalog.esi.records.module import Module
from esicatalog.lint.registry import Rule
from esicatalog.lint.report import DocumentFinding
from esicatalog.model.module_offer import module_offers

Signature = Callable[[Device, Sequence[Module], int | None], bytes]
"""Digest of a description (device, the modules its slots can reach, vendor id): equal for equal content."""


class DeviceFact(NamedTuple):
    """One Device element as the rules across documents see it."""

    document: str
    line: int
    path: str
    vendor_id: int | None
    vendor_name: str | None
    product_code: int | None
    revision_no: int | None
    type: str | None
    signature: bytes
    hide_types: tuple[HideType, ...] = ()

    @property
    def section(self) -> tuple[str, str]:
        """Its vendor section: the document, and which EtherCATInfo of an EtherCATInfoList."""
        return self.document, self.path.partition("/Descriptions/")[0]

    @property
    def identity(self) -> tuple[int, int, int] | None:
        """Vendor, product and revision when all of them are given."""
        if self.vendor_id is None or self.product_code is None or self.revision_no is None:
            return None
        return self.vendor_id, self.product_code, self.revision_no


class Library:
    """The devices of many documents: what a rule across documents looks at; a place begins with a device's number."""

    def __init__(self, facts: Iterable[DeviceFact]) -> None:
        self.facts: Sequence[DeviceFact] = tuple(facts)


def facts_of_document(read: ReadDocument, document: str, signature: Signature) -> Iterator[DeviceFact]:
    """The facts of the devices of a document."""
    content = read.document
    for section, (info, offer) in enumerate(zip(content.infos, module_offers(content), strict=True)):
        vendor_id = info.vendor_id
        for number, device in enumerate(info.devices):
            yield DeviceFact(
                document,
                content.device_lines[section][number],
                device_element_path(content.root, section, len(content.infos), number, len(info.devices)),
                vendor_id,
                info.vendor_name,
                device.product_code,
                device.revision_no,
                device.type,
                signature(device, offer.reachable(device), vendor_id),
                device.hide_types,
            )


def device_element_path(root: str, section: int, section_count: int, number: int, device_count: int) -> str:
    """Element path of a Device: number ``number`` of ``device_count`` in a section of a document."""
    if root == "EtherCATInfoList":
        root += f"/EtherCATInfo[{section}]" if section_count > 1 else "/EtherCATInfo"
    return f"{root}/Descriptions/Devices/" + (f"Device[{number}]" if device_count > 1 else "Device")


def lint_library(facts: Iterable[DeviceFact], rules: Iterable[Rule]) -> Iterator[DocumentFinding]:
    """What the rules across documents find, rule by rule."""
    library = Library(facts)
    for rule in rules:
        if Library not in rule.subjects or rule.check is None:
            continue
        for found in rule.check(library):
            number = found.place[0]
            fact = library.facts[int(number)]
            severity = found.severity or rule.severity
            yield DocumentFinding(fact.document, Finding(rule.id, severity, found.message, fact.line, fact.path))
