"""Canonical XML of vendors' elements, as records keep it, put back into elements."""

import re
from collections.abc import Iterator

from lxml import etree

from esicatalog.esi.documents import make_parser

_NO_XML_CHARACTER = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_REPLACEMENT_CHARACTER = "\ufffd"


def xml_text(text: str) -> str:
    """``text`` with U+FFFD for every character that XML 1.0 cannot hold (only recovery brings such into records)."""
    return _NO_XML_CHARACTER.sub(_REPLACEMENT_CHARACTER, text)


def canonical_element(canonical_xml: str) -> etree._Element:
    """The element of a canonical XML text; a prefix that the vendor's document never declared stays as it was."""
    return etree.fromstring(xml_text(canonical_xml), make_parser(recover=True))


def elements_naming(word: str, canonical_xml: str | None) -> Iterator[etree._Element]:
    """All elements of a vendor's canonical XML text, in its order; none where it does not have the word.

    Most do not have what is looked for, and then they need not be parsed.
    """
    if canonical_xml is not None and word in canonical_xml:
        yield from canonical_element(canonical_xml).iter()
