"""No value of a document is lost: each is in a record field, in vendor-specific XML or in ``unmapped``.

Every text and every attribute of a document is replaced by a number that occurs nowhere else; then each of these must
be found in what the reader gives, exactly once. This needs no writer and trusts no list of fields. The only values left
out are those of attributes of XMLSchema-instance, which say where a schema lies.
"""

import re
import zipfile
from collections import Counter
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import msgspec
import pytest
from lxml import etree
from snippets import device, esi
from test_maximal import AFTER_1_17, MAXIMAL, XS, declarations

from esicatalog.errors import NotAnEsiDocument
from esicatalog.esi.binding import Record
from esicatalog.esi.documents import parse_document
from esicatalog.esi.reader import ReadDocument, Reader
from fuzz.seeds import own_documents

SCHEMA_INSTANCE = "{http://www.w3.org/2001/XMLSchema-instance}"
FIRST = 10_000_001
"""Eight digits: a HexDecValue, an xs:int, an xs:float and an xs:hexBinary."""
NUMBER = re.compile(r"(?<!\d)[1-9]\d{7}(?!\d)")

STRAY = esi(
    "text"
    + device("<Sm>Outputs<b>below</b>after</Sm><X a='1'><Y>2</Y>3<Z b='4'/></X><Name>again</Name><Dc>x</Dc>")
    + "end"
)
LISTED = f"<EtherCATInfoList>{esi(device())}{esi(device('<Odd/>'))}</EtherCATInfoList>"
MODULES = (
    '<EtherCATModule Version="1.2"><Vendor FileVersion="3"><Id>1</Id><Name LcId="1033">V</Name></Vendor><Modules>'
    '<Module Crc32="5"><Type ModuleIdent="1">M</Type><Name>N</Name></Module></Modules></EtherCATModule>'
)
DICTIONARY = (
    '<EtherCATDict Version="1.2"><Dictionary><DataTypes><DataType><Name>T</Name><BitSize>8</BitSize></DataType>'
    "</DataTypes><Objects><Object><Index>1</Index><Name>O</Name></Object></Objects></Dictionary></EtherCATDict>"
)
DIAGNOSIS = (
    '<EtherCATDiag Version="1.2"><DiagMessages><DiagMessage><TextId>1</TextId><MessageText LcId="1033">m</MessageText>'
    "</DiagMessage></DiagMessages></EtherCATDiag>"
)
DOCUMENTS = {
    "maximal": MAXIMAL.read_bytes(),
    "later": AFTER_1_17.encode(),
    "stray": STRAY.encode(),
    "list": LISTED.encode(),
    "modules": MODULES.encode(),
    "dictionary": DICTIONARY.encode(),
    "diagnosis": DIAGNOSIS.encode(),
}


def numbered(root: etree._Element, form: str = "{}") -> int:
    """Replace every value below ``root`` by a number of its own in the given form; returns how many there are."""
    number = FIRST
    for element in root.iter(etree.Element):
        if element.text and element.text.strip():
            element.text, number = form.format(number), number + 1
        if element.tail and element.tail.strip():
            element.tail, number = form.format(number), number + 1
        for name in element.attrib:
            if not name.startswith(SCHEMA_INSTANCE):
                element.set(name, form.format(number))
                number += 1
    return number - FIRST


def values(record: object) -> Iterator[object]:
    """All values in a record, whatever its type; a text kept beside a value is its spelling, not another value."""
    if isinstance(record, msgspec.Struct):
        spelling = (isinstance(record, Record) and record.spelling) or {}
        for name in record.__struct_fields__:
            value = getattr(record, name)
            if isinstance(value, tuple):
                for position, item in enumerate(value):
                    yield from values(spelling.get(f"{name}.{position}") if item is None else item)
            elif name != "spelling":
                yield from values(spelling.get(name) if value is None else value)
    elif record is not None:
        yield record


def numbers_found(read: ReadDocument) -> Counter[int]:
    """How often each number occurs in the records."""
    found: Counter[int] = Counter()
    for value in values(read.document):
        texts = NUMBER.findall(value) if isinstance(value, str) else [value] if isinstance(value, int | float) else []
        found.update(map(int, texts))
    return found


def unaccounted(content: bytes, form: str = "{}") -> tuple[int, list[int]]:
    """How many values a document has, and which of them are missing or occur twice once they are numbered."""
    root = parse_document(content).root
    count = numbered(root, form)
    found = numbers_found(Reader().read(etree.tostring(root)))
    return count, [number for number in range(FIRST, FIRST + count) if found[number] != 1]


@pytest.mark.parametrize("form", ["{}", "?{}"], ids=["numbers", "words"])
@pytest.mark.parametrize("content", DOCUMENTS.values(), ids=DOCUMENTS)
def test_every_value_is_accounted_for(content, form):
    """As numbers where they may be read as such, and as words that no number, flag or byte sequence can be."""
    count, missing = unaccounted(content, form)
    assert count >= 4
    assert missing == []


def test_every_value_of_our_examples_is_accounted_for():
    for content in own_documents():
        try:
            _, missing = unaccounted(content)
        except NotAnEsiDocument:
            continue
        assert missing == []


def test_a_lost_value_would_be_noticed():
    """The proof finds what is left out: an attribute of XMLSchema-instance, were it counted."""
    content = esi(device()).replace(
        "<EtherCATInfo", f'<EtherCATInfo xmlns:x="{SCHEMA_INSTANCE[1:-1]}" x:type="10000009"'
    )
    assert numbers_found(Reader().read(content.encode()))[10_000_009] == 0


def real_documents(corpus: Path) -> Iterator[tuple[str, bytes]]:
    for path in sorted((corpus / "esi").glob("*.zip")):
        with zipfile.ZipFile(path) as archive:
            for name in archive.namelist():
                yield f"{path.name}!{name}", archive.read(name)


@pytest.mark.corpus
def test_every_value_of_real_documents_is_accounted_for(corpus, capsys):
    total = documents = 0
    for name, content in real_documents(corpus):
        try:
            count, missing = unaccounted(content)
        except NotAnEsiDocument:
            continue
        assert missing == [], name
        total, documents = total + count, documents + 1
    assert documents > 100
    with capsys.disabled():
        print(f"\n{total} values of {documents} documents are each found once")


def declared_pairs(corpus: Path) -> dict[tuple[str, str], bool]:
    """(element, child or @attribute) of schema 1.17 and of what was added later, and whether there may be several."""
    roots = [etree.parse(corpus / "xsd" / "1.17" / f"EtherCAT{kind}.xsd").getroot() for kind in ("Base", "Info")]
    types = {item.get("name"): item for root in roots for item in root.findall(f"{XS}complexType")}
    pairs: dict[tuple[str, str], bool] = {}
    for element in (element for root in roots for element in root.iter(f"{XS}element")):
        for item in declarations(element, types):
            pair = (element.get("name"), item.get("name") if item.tag == f"{XS}element" else f"@{item.get('name')}")
            pairs[pair] = pairs.get(pair, False) or may_repeat(item)
    for element in etree.fromstring(AFTER_1_17).iter(etree.Element):
        for child in (*(child.tag for child in element), *(f"@{name}" for name in element.attrib)):
            pairs.setdefault((element.tag, child), False)
    return pairs


def may_repeat(item: etree._Element) -> bool:
    """Whether an element declaration, or a group around it within its type, has maxOccurs above one."""
    around = [item, *item.iterancestors(f"{XS}sequence", f"{XS}choice", f"{XS}complexType")]
    within = around[: next((at for at, node in enumerate(around) if node.tag == f"{XS}complexType"), len(around))]
    return any(node.get("maxOccurs", "1") != "1" for node in within)


@pytest.mark.corpus
def test_almost_nothing_real_is_unmapped_and_nothing_of_the_schema(corpus, capsys):
    """By weight in characters; a repeated element where the schema has one is not of the schema there."""
    pairs = declared_pairs(corpus)
    reader, weight, unmapped, of_schema = Reader(), 0, Counter(), []
    for name, content in real_documents(corpus):
        try:
            document = reader.read(content).document
        except NotAnEsiDocument:
            continue
        for element in parse_document(content).root.iter(etree.Element):
            weight += len((element.text or "").strip()) + sum(map(len, element.attrib.values()))
        owners = [("Device", item) for info in document.infos for item in info.devices]
        owners += [("Module", item) for info in document.infos for item in info.modules]
        for owner, item in [*owners, ("", document)]:
            for kept in item.unmapped:
                steps = [owner, *kept.path.split("/")] if owner else kept.path.split("/")
                bare = [re.sub(r"\[\d+\]", "", step) for step in steps]
                unmapped["/".join(bare)] += len(kept.value)
                way = list(pairwise(bare))
                if all(pair in pairs for pair in way) and (pairs[way[-1]] or not steps[-1].endswith("]")):
                    of_schema.append((name, kept.path))
    share = unmapped.total() / weight
    with capsys.disabled():
        print(f"\nunmapped: {unmapped.total()} of {weight} characters of values, {share:.5%}: {dict(unmapped)}")
    assert of_schema == []
    assert share < 0.001
