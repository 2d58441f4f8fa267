"""Opening documents: encodings, what is broken, what is no ESI, and what tries to do harm."""

import pytest
from snippets import device, esi, read, write

from esicatalog.errors import BrokenDocument, NotAnEsiDocument
from esicatalog.esi import documents
from esicatalog.esi.documents import parse_document
from esicatalog.esi.reader import read_esi

UMLAUT = esi(device(name="Gerät"))
DECLARED = '<?xml version="1.0" encoding="{}"?>\n'


def name_of(content: bytes) -> str:
    return parse_document(content).root.findtext("Descriptions/Devices/Device/Name")


@pytest.mark.parametrize(
    ("content", "encoding"),
    [
        (UMLAUT.encode("utf-8"), "UTF-8"),
        (UMLAUT.encode("utf-8-sig"), "UTF-8"),
        ((DECLARED.format("UTF-8") + UMLAUT).encode("utf-8-sig"), "UTF-8"),
        ((DECLARED.format("utf-16") + UMLAUT).encode("utf-16"), "UTF-16"),
        (b"\xfe\xff" + (DECLARED.format("utf-16") + UMLAUT).encode("utf-16-be"), "UTF-16"),
        ((DECLARED.format("ISO-8859-1") + UMLAUT).encode("latin-1"), "ISO-8859-1"),
        ((DECLARED.format("ISO8859-1") + UMLAUT).encode("latin-1"), "ISO8859-1"),
    ],
)
def test_encodings(content, encoding):
    parsed = parse_document(content)
    assert name_of(content) == "Gerät"
    assert parsed.recovered is None
    assert parsed.encoding.upper().startswith(encoding)


def test_wrong_declared_encoding_is_read_and_told():
    content = (DECLARED.format("UTF-8") + "\n" + UMLAUT).encode("windows-1252")
    parsed = parse_document(content)
    assert name_of(content) == "Gerät"
    assert "windows-1252" in parsed.recovered
    assert parsed.error_line == 3


def test_content_after_the_root_is_recovered_with_its_line():
    content = esi(device(name="kept")) + "\n\n<more/>"
    read_document = read(content)
    (finding,) = [f for f in read_document.findings if f.rule == "L01"]
    assert name_of(content.encode()) == "kept"
    assert finding.line == 3
    assert read_document.document.recovered


def test_a_bare_ampersand_costs_nothing_around_it():
    content = esi(device(name="A & B") + device(revision="#x2", name="second")).encode()
    parsed = parse_document(content)
    assert parsed.recovered
    assert [d.findtext("Type") for d in parsed.root.iter("Device")] == ["T1", "T1"]


@pytest.mark.parametrize("content", [b"", b"  \n", b"\xef\xbb\xbf<EtherCATInfo", b"<EtherCATInfo><Vend"])
def test_nothing_usable_is_broken(content):
    try:
        parsed = parse_document(content)
    except (BrokenDocument, NotAnEsiDocument):
        return
    assert parsed.recovered


def test_an_empty_file_is_broken():
    with pytest.raises(BrokenDocument, match="empty"):
        parse_document(b"")


@pytest.mark.parametrize("content", [b"PDO list\n1;2;3", b"\x7fELF\x02\x01", b"{}", b"<html><body></html>"])
def test_other_content_is_not_esi(content):
    with pytest.raises(NotAnEsiDocument):
        parse_document(content)


def test_other_xml_is_named_by_its_root():
    with pytest.raises(NotAnEsiDocument, match="CiA"):
        parse_document(b"<CiA/>")


@pytest.mark.parametrize("xmlns", ["", ' xmlns="http://www.ethercat.org/2007/EtherCATInfo"'])
def test_eni_is_named(xmlns):
    with pytest.raises(NotAnEsiDocument, match="ENI"):
        parse_document(f"<EtherCATConfig{xmlns}><Config/></EtherCATConfig>".encode())


@pytest.mark.parametrize("names", ['EtherCATInfo xmlns="urn:vendor"', 'e:EtherCATInfo xmlns:e="urn:vendor"'])
def test_a_namespace_is_named_as_what_makes_it_no_esi_document(names):
    with pytest.raises(NotAnEsiDocument, match="in the XML namespace 'urn:vendor'; ESI documents have none"):
        parse_document(f"<{names}/>".encode())


def test_an_info_list_holds_several_vendors():
    second = esi(device(type_text="B"), vendor="<Id>2</Id><Name>V2</Name>")
    document = read(f"<EtherCATInfoList>{esi(device(type_text='A'))}{second}</EtherCATInfoList>").document
    assert [info.vendor.vendor_id for info in document.infos] == [0xE5C, 2]
    assert [info.devices[0].type for info in document.infos] == ["A", "B"]


def test_external_entities_are_never_loaded(tmp_path):
    secret = tmp_path / "secret.txt"
    secret.write_text("top secret words")
    for target in ("file:///etc/passwd", secret.as_uri(), str(secret)):
        doctype = f'<!DOCTYPE EtherCATInfo [<!ENTITY e SYSTEM "{target}">]>'
        content = doctype + esi(device(name="before &e; after"))
        file = write(tmp_path, {"attack.xml": content}) / "attack.xml"
        text = repr(read_esi(file))
        assert "top secret" not in text
        assert "root:" not in text


def test_an_external_dtd_is_never_fetched(tmp_path):
    (tmp_path / "evil.dtd").write_text('<!ENTITY e "from the dtd">')
    content = f'<!DOCTYPE EtherCATInfo SYSTEM "{(tmp_path / "evil.dtd").as_uri()}">' + esi(device(name="x &e; y"))
    assert "from the dtd" not in repr(read(content))


def test_oversized_documents_are_refused(monkeypatch):
    monkeypatch.setattr(documents, "MAX_DOCUMENT_BYTES", 100)
    with pytest.raises(BrokenDocument, match="larger"):
        parse_document(esi(device()).encode())


@pytest.mark.parametrize(
    "content",
    [
        "<Info><VendorSpecific><a>x&foo;y</a></VendorSpecific></Info>",
        "<Unknown>&foo;</Unknown>",
        "<Sm>Out&foo;puts</Sm>",
    ],
)
def test_entity_references_are_left_out_and_told(content):
    """They reached raw XML, which then could not be written, and paths of unmapped values, with a memory address."""
    text = f"<!DOCTYPE EtherCATInfo [<!ENTITY foo 'bar'>]>{esi(device(content))}"
    first, second = (read(text).document for _ in range(2))
    assert first.infos == second.infos
    assert "entity &foo; and others are not expanded" in first.recovered
    assert "0x" not in "".join(item.path for d in first.infos[0].devices for item in d.unmapped)
