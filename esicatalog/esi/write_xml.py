"""XML on its way out: what its text can hold, canonical XML put back into a tree, indentation that changes nothing."""

import re

from lxml import etree

from esicatalog.esi.documents import make_parser

_NO_XML_CHARACTER = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_REPLACEMENT_CHARACTER = "\ufffd"
_XML_SPACE = "{http://www.w3.org/XML/1998/namespace}space"
_DECLARATION = b'<?xml version="1.0" encoding="UTF-8"?>\n'


def xml_text(text: str) -> str:
    """``text`` with U+FFFD for every character that XML 1.0 cannot hold (only recovery brings such into records)."""
    return _NO_XML_CHARACTER.sub(_REPLACEMENT_CHARACTER, text)


def canonical_element(canonical_xml: str) -> etree._Element:
    """The element of a canonical XML text; a prefix that the vendor's document never declared stays as it was."""
    return etree.fromstring(xml_text(canonical_xml), make_parser(recover=True))


def document_bytes(root: etree._Element) -> bytes:
    """The document in UTF-8 with declaration, indented; ``root`` is changed."""
    _indent(root, 1)
    text: bytes = etree.tostring(root, encoding="UTF-8", xml_declaration=False)
    return _DECLARATION + text + b"\n"


def _indent(element: etree._Element, depth: int) -> None:
    """Put every child on a line of its own, except where text stands beside elements: blanks are content there."""
    if not len(element) or element.text or any(child.tail for child in element) or _XML_SPACE in element.attrib:
        return
    line = "\n" + "  " * depth
    element.text = line
    for child in element:
        _indent(child, depth + 1)
        child.tail = line
    element[-1].tail = line[:-2]
