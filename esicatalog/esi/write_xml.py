"""XML on its way out: indentation that changes nothing."""

from lxml import etree

_XML_SPACE = "{http://www.w3.org/XML/1998/namespace}space"
_DECLARATION = b'<?xml version="1.0" encoding="UTF-8"?>\n'


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
