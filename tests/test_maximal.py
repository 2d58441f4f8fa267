"""Nothing is lost: a document with every element and attribute of the format comes out of the reader completely."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest
from lxml import etree
from snippets import esi, read, write

from esicatalog import Catalog
from esicatalog.catalog.query import ConnectionQuery
from esicatalog.catalog.reader import RecordReader
from esicatalog.esi.binding import Record
from esicatalog.esi.reader import ReadDocument, Reader

MAXIMAL = Path(__file__).with_name("maximal.xml")
XS = "{http://www.w3.org/2001/XMLSchema}"

AFTER_1_17 = esi(
    """
    <Device Physics="YY">
      <Type ProductCode="#x1" RevisionNo="#x1">NEW</Type><Name>New</Name>
      <Info><DataRates><Rate>1000</Rate></DataRates></Info>
      <GroupType>G</GroupType>
      <Profile><Dictionary>
        <DataTypes><DataType><Name>UINT</Name><BitSize>16</BitSize></DataType></DataTypes>
        <Objects><Object><Index>#x2000</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize>
          <Info><DefaultData>0100</DefaultData><Scaling Factor="0.5"><Offset>7</Offset></Scaling></Info>
        </Object></Objects>
      </Dictionary></Profile>
      <RxPdo Ref="shared one" Chn="channel one"/>
      <Dc PdoOversampling="1"><OpMode><Name>DC</Name><AssignActivate>#x0300</AssignActivate>
        <ActivateAdditional>#x0011</ActivateAdditional>
        <CycleTimeSync2 Factor="21">22</CycleTimeSync2><ShiftTimeSync2>23</ShiftTimeSync2>
        <CycleTimeSync3 Factor="31">32</CycleTimeSync3><ShiftTimeSync3>33</ShiftTimeSync3>
      </OpMode></Dc>
      <ESC Mi45Access="mi45"/>
      <Eeprom><ByteSize>2048</ByteSize><ConfigData>0C</ConfigData><ConfigData2>1D</ConfigData2></Eeprom>
    </Device>""",
    vendor="<Id>#x00000E5C</Id><Name>Vendor</Name><ImageFile16x14>vendor.bmp</ImageFile16x14>",
).replace(
    "</Descriptions>", '<Pdos><Pdo Name="shared one"><Index>#x1600</Index><Name>P</Name></Pdo></Pdos></Descriptions>'
)


@pytest.fixture(scope="module")
def maximal() -> ReadDocument:
    return Reader().read(MAXIMAL.read_bytes())


def number_or_text(text: str) -> object:
    """What a text says, whatever its spelling: an independent reading for the comparison."""
    word = text.strip()
    if word in ("true", "false"):
        return int(word == "true")
    try:
        return int(word[2:], 16) if word.startswith("#x") else int(word)
    except ValueError:
        pass
    try:
        return float(word)
    except ValueError:
        return word.upper()


def values_of_document(root: etree._Element) -> Counter[object]:
    found: Counter[object] = Counter()
    for element in root.iter(etree.Element):
        if element.text and element.text.strip():
            found[number_or_text(element.text)] += 1
        for name, text in element.attrib.items():
            if not name.startswith("{"):
                found[number_or_text(text)] += 1
    return found


def values_of_record(value: object, found: Counter[object]) -> Counter[object]:
    """All values in a record, whatever its type: structs field by field, XML texts as documents of their own."""
    if isinstance(value, msgspec.Struct):
        for name in value.__struct_fields__:
            if name != "spelling":
                values_of_record(getattr(value, name), found)
    elif isinstance(value, tuple):
        for item in value:
            values_of_record(item, found)
    elif isinstance(value, str) and value.startswith("<"):
        found += values_of_document(etree.fromstring(value))
    elif isinstance(value, bool | int | float | str):
        found[number_or_text(str(int(value)) if isinstance(value, bool) else str(value))] += 1
    return found


def spellings(value: object, found: Counter[str]) -> Counter[str]:
    """All texts that records keep because the vendor spelled a value in another way."""
    if isinstance(value, msgspec.Struct):
        if isinstance(value, Record) and value.spelling:
            found.update(value.spelling.values())
        for name in value.__struct_fields__:
            spellings(getattr(value, name), found)
    elif isinstance(value, tuple):
        for item in value:
            spellings(item, found)
    return found


@pytest.mark.parametrize("content", [MAXIMAL.read_bytes(), AFTER_1_17.encode()], ids=["1.17", "later"])
def test_every_value_of_the_document_is_in_the_records(content):
    missing = values_of_document(etree.fromstring(content)) - values_of_record(read(content).document, Counter())
    assert missing == Counter()


@pytest.mark.parametrize("content", [MAXIMAL.read_bytes(), AFTER_1_17.encode()], ids=["1.17", "later"])
def test_nothing_is_unmapped_and_nothing_is_noticed(content):
    document = read(content).document
    assert document.unmapped == ()
    assert [d.unmapped for d in document.infos[0].devices if d.unmapped] == []
    assert [m.unmapped for m in document.infos[0].modules if m.unmapped] == []
    assert read(content).findings == ()


def test_spellings_are_texts_of_the_document(maximal):
    root = etree.parse(MAXIMAL)
    texts = {text.strip() for element in root.iter(etree.Element) if (text := element.text)}
    texts |= {text for element in root.iter(etree.Element) for text in element.attrib.values()}
    kept = spellings(maximal.document, Counter())
    assert kept.keys() <= texts
    assert {"1048577", "#x94", "true", "#x0B", "#x83", "387"} <= kept.keys()


def test_the_catalog_gives_every_record_back(maximal, tmp_path):
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([write(tmp_path / "in", {"maximal.xml": MAXIMAL.read_bytes(), "later.xml": AFTER_1_17})], jobs=1)
        info = maximal.document.infos[0]
        expected = [*info.devices, *read(AFTER_1_17).document.infos[0].devices]
        with catalog._connection() as connection:
            reader = RecordReader(ConnectionQuery(connection))
            stored = {d.type: d for d in reader.devices(range(1, len(expected) + 1))}
            modules = {m.type: m for m in reader.modules(range(1, len(info.modules) + 1))}
    assert stored == {d.type: d for d in expected}
    assert modules == {m.type: m for m in info.modules}


def test_the_document_is_valid(corpus):
    schema = etree.XMLSchema(etree.parse(corpus / "xsd" / "1.17" / "EtherCATInfo.xsd"))
    assert schema.validate(etree.parse(MAXIMAL)), schema.error_log


def test_the_document_uses_everything_the_schema_declares(corpus):
    """Pairs of parent and element, and of element and attribute, whatever the place they are declared for."""
    roots = [etree.parse(corpus / "xsd" / "1.17" / f"EtherCAT{kind}.xsd").getroot() for kind in ("Base", "Info")]
    same = {"TxPdo": "RxPdo", "SafetyParaMapping": "RxPdo", "DiagReaction": "DiagReset", "DiagType": "DiagReset"}
    types = {item.get("name"): item for root in roots for item in root.findall(f"{XS}complexType")}
    declared = {
        (
            same.get(element.get("name"), element.get("name")),
            item.get("name") if item.tag == f"{XS}element" else f"@{item.get('name')}",
        )
        for root in roots
        for element in root.iter(f"{XS}element")
        for item in declarations(element, types)
    }
    used = set()
    for document in (MAXIMAL.read_bytes(), AFTER_1_17.encode()):
        for element in etree.fromstring(document).iter(etree.Element):
            used.update((element.tag, child.tag) for child in element.iterchildren(etree.Element))
            used.update((element.tag, f"@{name}") for name in element.attrib)
    assert len(declared) > 300
    assert declared - used == {("Vendor", "Image16x14")}, "of three kinds of image a vendor has one"


def declarations(node: etree._Element, types: dict[str, etree._Element]) -> Iterator[etree._Element]:
    """Elements and attributes declared directly in an element declaration or in its named type."""
    for named in (node.get("type"), node.get("base")):
        if named in types:
            yield from declarations(types[named], types)
    for child in node.iterchildren(etree.Element):
        if child.tag in (f"{XS}element", f"{XS}attribute"):
            yield child
        else:
            yield from declarations(child, types)
