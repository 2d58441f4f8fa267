"""Nothing is overlooked: every value of a document that uses the whole format, changed alone, is a difference."""

from collections.abc import Iterator

import pytest
from lxml import etree
from test_maximal import AFTER_1_17, MAXIMAL

from esicatalog.esi.reader import Reader
from esicatalog.model.compare import compare_devices
from esicatalog.model.compare_documents import described_devices

NOT_COMPARED = {
    "/@Crc32": "a check sum over what is compared",
    "/Image16x14": "images",
    "/ImageFile16x14": "images",
    "/ImageData16x14": "images",
    "/@LcId": "the language of a text",
    "/ChannelInfo/DisplayName": "texts for tools",
    "/ModuleClass/Name": "texts for tools",
    "/Dictionary/Objects/Object/Comment": "texts for tools",
    "/DataType/Comment": "texts for tools",
    "/DataType/SubItem/Comment": "texts for tools",
    "/DataType/EnumInfo/Comment": "texts for tools",
    "/DiagMessages/DiagReset/Comment": "texts for tools",
    "/Properties/": "texts for tools",
    "/Property/": "texts for tools",
    "/DataType/Xml/": "free XML for tools",
    "/SubItem/Xml/": "free XML for tools",
    "/Object/Xml/": "free XML for tools",
    "/DataType/Index": "nothing refers to it",
    "/DataType/Name": "a name: the objects that use the type are compared",
    "/ArrayInfo/LBound": "of further dimensions: entries are a flat list",
    "/DataType/BitSize": "objects and their entries have sizes of their own",
    "/SubItem/Flags/Attribute": "for SoE, which has no sub-items; that of the object is compared",
}
"""Parts of paths, and why a value below them need not be a difference."""

USED_TYPES = """
<Object><Index>#x2002</Index><Name>Enumeration</Name><Type>DT0806EN08</Type><BitSize>8</BitSize></Object>
<Object><Index>#x2003</Index><Name>Array</Name><Type>DT2003</Type><BitSize>112</BitSize></Object>
<Object><Index>#x2004</Index><Name>Record</Name><Type>DT2001</Type><BitSize>112</BitSize></Object>
<Object><Index>#x2005</Index><Name>Other flags</Name><Type>UDINT</Type><BitSize>32</BitSize></Object>
"""
"""Objects of the types that no object of the document has; without values, so that those of the type show."""
ARRAY_TYPE = """
<DataType><Name>DT2003</Name><BitSize>112</BitSize>
<SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>
<SubItem><Name>Elements</Name><Type>DT2000ARR</Type><BitOffs>16</BitOffs></SubItem>
<SubItem><SubIdx>80</SubIdx><Name>Behind</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>208</BitOffs></SubItem>
</DataType>
"""

READER = Reader()
WORDS = {"true": "false", "false": "true", "tr": "R", "T": "R"}


def other(text: str) -> str:
    """Another value of the same kind."""
    word = text.strip()
    if word in WORDS:
        return WORDS[word]
    if word.startswith("#x"):
        return f"#x{int(word[2:], 16) ^ 1:X}"
    if word.lstrip("-").isdigit():
        return str(1 - int(word) if word in ("0", "1") else int(word) + 1)
    try:
        data = bytes.fromhex(word)
    except ValueError:
        return word + "x"
    return word[:-2] + f"{data[-1] ^ 1:02X}" if data else "x"


def values(root: etree._Element) -> Iterator[tuple[etree._Element, str | None]]:
    """Elements with text, and elements with an attribute, of devices and modules."""
    for part in root.iter("Device", "Module"):
        for element in part.iter(etree.Element):
            if element.text and element.text.strip() and not is_other_language(element):
                yield element, None
            yield from ((element, name) for name in element.attrib)


def is_other_language(element: etree._Element) -> bool:
    """Whether the same text is given in English, which is the one that is shown."""
    return element.get("LcId") not in (None, "1033") and any(
        sibling is not element and sibling.get("LcId") == "1033"
        for sibling in element.getparent().iterchildren(element.tag)
    )


def path(element: etree._Element, attribute: str | None) -> str:
    """Tags from the document's root to a value."""
    tags = [element.tag, *(item.tag for item in element.iterancestors())]
    return "/".join(reversed(tags)) + (f"/@{attribute}" if attribute else "")


def described(root: etree._Element):
    return described_devices(READER.read(etree.tostring(root)).document)


def differs(left, right) -> bool:
    return len(left) != len(right) or any(
        compare_devices(ours, theirs) for ours, theirs in zip(left, right, strict=True)
    )


def documents() -> Iterator[etree._Element]:
    text = MAXIMAL.read_text()
    text = text.replace("<DataTypes>", f"<DataTypes>{ARRAY_TYPE}", 1).replace("<Objects>", f"<Objects>{USED_TYPES}", 1)
    yield etree.fromstring(text.encode())
    yield etree.fromstring(AFTER_1_17.encode())


@pytest.mark.parametrize("step", [15, pytest.param(1, marks=pytest.mark.faults)])
@pytest.mark.parametrize("root", list(documents()), ids=["1.17", "later"])
def test_every_value_is_a_difference(root, step):
    before = described(root)
    assert not differs(before, described(root))
    overlooked = []
    for element, attribute in list(values(root))[::step]:
        old = (element.get(attribute) if attribute else element.text) or ""
        change(element, attribute, other(old))
        if not differs(before, described(root)):
            overlooked.append(path(element, attribute))
        change(element, attribute, old)
    assert [item for item in overlooked if not any(part in item for part in NOT_COMPARED)] == []
    assert (
        step > 1
        or root.find(".//DataTypes/DataType/EnumInfo") is None
        or all(any(part in item for item in overlooked) for part in NOT_COMPARED)
    )


def change(element: etree._Element, attribute: str | None, value: str) -> None:
    if attribute is None:
        element.text = value
    else:
        element.set(attribute, value)
