"""Writing records as ESI documents: the same declarations that drive the reader, turned round.

What a field's declaration cannot say stands in a table: the elements without content that the schema asks for
(ETG.2000: EtherCATInfo.xsd, EtherCATBase.xsd). Elements after schema 1.17 stand where the field is declared, among
their kin.
"""

from functools import cache
from typing import Any, NamedTuple

from lxml import etree

from esicatalog.esi.binding import PRESENT, RAW, Field, Record, fields_in_order
from esicatalog.esi.canonical import canonical_element, xml_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import Dictionary, InfoSubItem
from esicatalog.esi.records.document import DiagInfo, DictInfo, EsiInfo, InfoList, ModuleInfo
from esicatalog.esi.records.module import Module
from esicatalog.esi.write_unmapped import add_unmapped
from esicatalog.esi.write_xml import document_bytes

_ROOTS: dict[type[Record], str] = {
    EsiInfo: "EtherCATInfo",
    InfoList: "EtherCATInfoList",
    ModuleInfo: "EtherCATModule",
    DictInfo: "EtherCATDict",
    DiagInfo: "EtherCATDiag",
}

_REQUIRED: dict[type[Record], tuple[str, ...]] = {
    EsiInfo: ("Descriptions/Groups", "Descriptions/Devices"),
    ModuleInfo: ("Modules",),
    Dictionary: ("Objects",),
    InfoSubItem: ("Info",),
}
"""Elements that the schema requires even when nothing is in them."""


class _Place(NamedTuple):
    """A field with its path taken apart."""

    field: Field
    path: str
    """Of the element, below the record's own; empty for that itself."""
    parent: str
    tag: str
    attribute: str
    required: bool
    """The parent is written even when the field holds nothing."""


def write_esi(content: EsiInfo | InfoList | ModuleInfo | DictInfo | DiagInfo) -> bytes:
    """An ESI document in UTF-8, indented, its root chosen by the kind of record.

    Reading it gives the records again. Numbers stand as the vendor spelled them, others in canonical spelling;
    children stand in the order of the schema. A character that XML cannot hold, which only a document read by
    recovery brings, becomes U+FFFD.
    """
    return document_bytes(record_element(content, _ROOTS[type(content)]))


def record_element(record: Record, tag: str) -> etree._Element:
    """The element ``tag`` of any record (a Device, a Pdo, a Dictionary), not indented."""
    element = etree.Element(tag)
    _fill(element, record)
    return element


@cache
def _places(record_type: type[Record]) -> tuple[_Place, ...]:
    """The fields of a record type in the order of the schema."""
    required = _REQUIRED.get(record_type, ())
    places = []
    for field in fields_in_order(record_type):
        path = field.xml.element
        parent, _, tag = path.rpartition("/")
        places.append(_Place(field, path, parent, tag, field.xml.attribute, parent in required))
    return tuple(places)


def _fill(element: etree._Element, record: Record) -> None:
    made = {"": element}
    for place in _places(type(record)):
        if place.required:
            _element_at(made, place.parent)
        field, kind = place.field, place.field.xml.kind
        value = getattr(record, field.name)
        if field.many:
            _append_all(made, place, record, value)
        elif isinstance(value, Record):
            _append(made, place, value)
        elif kind is PRESENT:
            if value:
                _element_at(made, place.path)
        elif kind is RAW:
            if value is not None:
                _element_at(made, place.parent).append(canonical_element(value))
        else:
            text = _spelled(record, field.name, kind, value)
            if text is None:
                continue
            if place.attribute:
                _element_at(made, place.path).set(place.attribute, text)
            else:
                _element_at(made, place.path).text = text or None  # libxml2 writes an empty text as <a></a>
    if isinstance(record, Device | Module):
        add_unmapped(element, record.unmapped)


def _element_at(made: dict[str, etree._Element], path: str) -> etree._Element:
    """The element at a path below the record's own, made with those around it when it is not there yet."""
    found = made.get(path)
    if found is None:
        parent, _, tag = path.rpartition("/")
        found = made[path] = etree.SubElement(_element_at(made, parent), tag)
    return found


def _append_all(made: dict[str, etree._Element], place: _Place, record: Record, values: tuple[Any, ...]) -> None:
    for position, value in enumerate(values):
        if isinstance(value, Record):
            _append(made, place, value)
        else:
            item = etree.SubElement(_element_at(made, place.parent), place.tag)
            item.text = _spelled(record, f"{place.field.name}.{position}", place.field.xml.kind, value) or None


def _append(made: dict[str, etree._Element], place: _Place, record: Record) -> None:
    _fill(etree.SubElement(_element_at(made, place.parent), place.tag), record)


def _spelled(record: Record, name: str, kind: Any, value: Any) -> str | None:
    """The vendor's text of a value while it still says that value, else the canonical one; None when there is none."""
    spelling = record.spelling
    text = spelling.get(name) if spelling is not None else None
    if text is None or kind.read(text).value != value:
        if value is None:
            return None
        text = kind.spell(value)
    return xml_text(text)
