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


@pytest.mark.parametrize(
    ("declared", "encoding", "told"),
    [
        ("utf-8", "utf-16", "UTF-16LE"),
        ("UTF-16BE", "utf-16", "UTF-16LE"),
        ("utf-16", "utf-8-sig", "UTF-8"),
        ("ISO-8859-1", "utf-8-sig", "UTF-8"),
        ("utf-8", "utf-32", "UTF-32LE"),
        ("UTF-8", "utf-8-sig", None),
        ("UTF8", "utf-8-sig", None),
        ("UTF-16", "utf-16", None),
        ("UTF-16LE", "utf-16", None),
        ("unicode", "utf-16", None),
        ("ISO-10646-UCS-2", "utf-16", None),
    ],
)
def test_a_declaration_against_the_byte_order_mark_is_told(declared, encoding, told):
    """XML 1.0 section 4.3.3 makes it a fatal error; Python's codecs write the marks."""
    content = (DECLARED.format(declared) + "\n" + UMLAUT).encode(encoding)
    parsed = parse_document(content)
    words = f"declared as {declared.lower()}, but its byte order mark says {told}; read as {told}" if told else None
    assert (name_of(content), parsed.problems) == ("Gerät", ((1, words),) if told else ())


def test_wrong_declared_encoding_is_read_and_told():
    content = (DECLARED.format("UTF-8") + "\n" + UMLAUT).encode("windows-1252")
    parsed = parse_document(content)
    assert name_of(content) == "Gerät"
    assert "windows-1252" in parsed.recovered
    assert [problem.line for problem in parsed.problems] == [3]


@pytest.mark.parametrize(
    ("declared", "name", "encoding"),
    [
        ("gb2312", "伺服驱动器镕", "gb18030"),
        ("GBK", "伺服€𠀀", "gb18030"),
        ("windows-31j", "①サーボ ~ \\ 表", "cp932"),
        ("MS932", "①サーボ ~ \\ 表", "cp932"),
        ("Shift_JIS", "①サーボ ~ \\ 表", "cp932"),
        ("ks_c_5601-1987", "서보 똠방", "cp949"),
        ("euc-kr", "서보 똠방", "cp949"),
        ("Big5", "伺服驅動器碁€", "cp950"),
    ],
)
def test_the_code_page_that_an_east_asian_name_means_is_read_and_told(declared, name, encoding):
    """Each name has a character that only the code page has: GBK for GB 2312, NEC's for JIS, UHC, ETEN's for Big5."""
    parsed = parse_document((DECLARED.format(declared) + esi(device(name=name))).encode(encoding))
    assert parsed.root.findtext("Descriptions/Devices/Device/Name") == name
    assert (parsed.encoding, parsed.recovered.endswith(f"read as {encoding}")) == (encoding, True)


@pytest.mark.parametrize("declared", ["Shift_JIS", "shift-jis"])
def test_a_backslash_and_a_tilde_of_shift_jis_are_no_yen_and_overline(declared):
    content = (DECLARED.format(declared) + esi(device(name="サーボ ~200V C:\\表"))).encode("shift_jis")
    parsed = parse_document(content)
    assert parsed.root.findtext("Descriptions/Devices/Device/Name") == "サーボ ~200V C:\\表"
    assert (parsed.encoding, parsed.recovered) == ("cp932", None)


def test_what_a_declared_encoding_reads_stays_as_it_reads_it():
    """A middle dot, which GB 2312 and GB 18030 take for different characters."""
    declared = (DECLARED.format("gb2312") + esi(device(name="N"))).encode().replace(b">N<", b">\xa1\xa4<")
    parsed = parse_document(declared)
    assert parsed.root.findtext("Descriptions/Devices/Device/Name") in "・·"
    assert (parsed.encoding.lower(), parsed.recovered) == ("gb2312", None)


@pytest.mark.parametrize("declared", ["gb2312", "windows-31j", "martian"])
def test_utf_8_under_another_name_is_read_as_such(declared):
    parsed = parse_document((DECLARED.format(declared) + esi(device(name="伺服驱动器"))).encode("utf-8"))
    assert parsed.root.findtext("Descriptions/Devices/Device/Name") == "伺服驱动器"
    assert parsed.recovered.endswith("read as utf-8")


@pytest.mark.parametrize(
    "declared", ["utf-16", "UTF-16LE", "utf-16be", "utf16", "ISO-10646-UCS-2", "UCS-2", "utf-32", "ucs-4"]
)
@pytest.mark.parametrize(
    ("saved_as", "rest", "words"),
    [
        ("utf-8", "", "read as utf-8"),
        ("windows-1252", "", "read as windows-1252"),
        ("utf-8", "<more/>", "read by recovery; more in line 2"),
    ],
)
def test_a_wide_encoding_that_is_only_declared(declared, saved_as, rest, words):
    """What a .NET StringWriter makes declares the encoding of its string, whatever that is saved as."""
    parsed = parse_document((DECLARED.format(declared) + esi(device(name="Gerät")) + rest).encode(saved_as))
    assert parsed.root.findtext("Descriptions/Devices/Device/Name") == "Gerät"
    said = f"declared as {declared.lower()}, but it begins with characters of 8 bits; {words}"
    assert (parsed.recovered, parsed.problems[0].line) == (said, 1)


@pytest.mark.parametrize(
    ("between", "line"),
    [('\n<?xml version="1.0" ?>\n', 4), ("\n\n", 4), ("</oops>\n", 3)],
    ids=["as ethercat xml writes", "without declaration", "behind an end tag too many"],
)
def test_a_second_document_in_a_file_is_named_with_its_line(between, line):
    first, second = esi(device(name="kept")), esi(device(name="lost"))
    parsed = parse_document(f'<?xml version="1.0" ?>\n{first}{between}{second}\n'.encode())
    assert [name.text for name in parsed.root.iter("Name") if name.text in ("kept", "lost")] == ["kept"]
    assert f"the document in line {line} and all behind it is left out: make a file of each" in parsed.recovered


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
@pytest.mark.parametrize(
    "content",
    [device(name="a&#xD800;b"), device().replace("Physics", 'Made="&#57343;" Physics'), "&#xDBFF;" + device()],
)
def test_half_of_a_surrogate_pair_is_no_character(content, encoding):
    """XML 1.0 production 2: no surrogates. libxml2's recovery keeps them, and nothing can read the text then."""
    with pytest.raises(BrokenDocument, match="means no character") as refused:
        parse_document(esi(content).encode(encoding))
    assert refused.value.line == 1


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


def lines_of(content: str | bytes) -> list[int]:
    """The lines that L01 names."""
    return [finding.line for finding in read(content).findings if finding.rule == "L01"]


def test_every_damaged_line_is_told_once():
    """A bare ampersand in line 2, which alone was told, and in line 4 an end tag that ends nothing, twice."""
    lines = ["", device(name="A & B &"), device(name="whole"), device("<Sm>Outputs</Smm></Smmm></Sm>"), ""]
    document = read(esi("\n".join(lines))).document
    assert lines_of(esi("\n".join(lines)))[:2] == [2, 4]
    assert document.recovered.startswith("xmlParseEntityRef: no name, line 2, column ")
    assert "; read by recovery; more in line 4" in document.recovered
    assert not document.is_whole


def test_of_many_damaged_lines_the_rest_is_counted():
    text = esi("\n".join(device(name="&", revision=f"#x{number:x}") for number in range(1, 31)))
    assert lines_of(text) == [*range(1, 23)]
    (*_, last) = parse_document(text.encode()).problems
    assert last.message == "at least 9 more damaged lines from here on; read by recovery"


@pytest.mark.parametrize(
    ("before", "line"),
    [("\n", 2), (" ", 1), ("\r\n\t", 2), ("<!-- made\nby hand -->\n", 3), ("<!-- a --><!-- b -->\n\n", 3)],
)
@pytest.mark.parametrize("encoding", ["ISO-8859-1", "windows-1252", "utf-8"])
def test_a_declaration_that_does_not_stand_first_counts_all_the_same(before, line, encoding):
    """XML 1.0 section 2.8 has it first; libxml2's recovery passes over it and reads UTF-8."""
    content = before + DECLARED.format(encoding) + "\n" + esi(device(name="Gerät für 10 µs"))
    found = read(content.encode(encoding))
    assert found.document.infos[0].devices[0].names[0].text == "Gerät für 10 µs"
    assert found.document.device_lines == ((line + 2,),)
    assert (found.document.is_whole, lines_of(content.encode(encoding))) == (True, [line])
    assert found.document.recovered.endswith("read as if it stood there")


def test_behind_a_late_declaration_all_else_is_told_too():
    content = "\n" + DECLARED.format("ISO-8859-1") + esi("\n" + device(name="Gerät &"))
    parsed = parse_document(content.encode("latin-1"))
    assert [problem.line for problem in parsed.problems] == [2, 4]
    assert parsed.root.findtext("Descriptions/Devices/Device/Name").startswith("Gerät")
    assert not parsed.is_whole


@pytest.mark.parametrize("names", [("&", "Gerät"), ("Gerät", "&"), ("Gerät &", "x")])
def test_characters_that_recovery_replaces_are_told(names):
    """Byte 0xE4 is no UTF-8."""
    content = DECLARED.format("UTF-8") + esi("\n".join(device(name=name) for name in names))
    problems = parse_document(content.encode("latin-1")).problems
    told = [problem.line for problem in problems if "is read as U+FFFD" in problem.message]
    assert told == [next(line for line, name in enumerate(names, 2) if "ä" in name)]
    assert len({problem.line for problem in problems}) == len(problems)


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
