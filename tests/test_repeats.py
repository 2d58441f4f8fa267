"""Repeated parts are recognised by their words: what is read must be what plain reading gives, wherever they stand."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from snippets import device, dictionary, esi

from esicatalog.errors import EsiCatalogError
from esicatalog.esi import repeats
from esicatalog.esi.reader import ReadDocument, Reader
from esicatalog.esi.repeats import Repeats
from esicatalog.ingest.discover import FoundArchive, archive_members, discover

TYPE = "<DataType><Name>DT1000</Name><BitSize>32</BitSize></DataType>"
OBJECT = "<Object><Index>#x1000</Index><Name>Type</Name><Type>DT1000</Type><BitSize>32</BitSize></Object>"
FLAGS = "<Flags><Access>ro</Access><Category>o</Category></Flags>"
RECORD = (
    "<DataType><Name>DT1018</Name><BitSize>80</BitSize>"
    + "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>Sub {n}</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        f"<BitOffs>{16 + 32 * (n - 1)}</BitOffs>{FLAGS}</SubItem>"
        for n in range(3)
    )
    + "</DataType>"
)


def values(index: str, *defaults: str) -> str:
    """An object with declared values of its sub-items."""
    infos = "".join(
        f"\n<SubItem><Name>Sub {n}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>"
        for n, data in enumerate(defaults)
    )
    return (
        f"<Object><Index>{index}</Index><Name>Identity</Name><Type>DT1018</Type><BitSize>80</BitSize>"
        f"<Info>{infos}\n</Info>{FLAGS}</Object>"
    )


BROKEN = "<Object><Index>#xZZ</Index><Name>Broken</Name></Object>"


def plain(content: bytes, monkeypatch: pytest.MonkeyPatch) -> ReadDocument:
    with monkeypatch.context() as patched:
        patched.setattr(Repeats, "cut", lambda self, content: None)
        return Reader().read(content)


def twice(types: str, objects: str) -> str:
    """Two devices with the same dictionary, laid out in lines."""
    return esi(device("\n" + dictionary(types, objects) + "\n") + device(dictionary(types, objects), revision="#x2"))


def parts_of(read: ReadDocument) -> tuple[tuple[object, ...], ...]:
    dictionaries = [owner.profiles[0].dictionary for owner in read.document.infos[0].devices]
    return tuple((*held.data_types, *held.objects) for held in dictionaries if held is not None)


def test_the_same_words_give_the_same_records(monkeypatch):
    content = twice(f"\n {TYPE}\n", f"\n {OBJECT}\n").encode()
    read = Reader().read(content)
    first, second = parts_of(read)
    assert all(one is other for one, other in zip(first, second, strict=True))
    assert read == plain(content, monkeypatch)


def test_parts_of_new_parts_are_known_too(monkeypatch):
    """One object differs from the other in a single value: all else of it is the same record."""
    content = twice(RECORD, values("#x1018", "03", "01000000") + values("#x1018", "03", "02000000")).encode()
    read = Reader().read(content)
    record, first, second = parts_of(read)[0]
    assert first.info_sub_items[0] is second.info_sub_items[0]
    assert first.info_sub_items[1].default_data == "01000000" and second.info_sub_items[1].default_data == "02000000"
    assert all(member.flags is first.flags is second.flags for member in record.sub_items)
    assert read == plain(content, monkeypatch)


def test_pdos_and_their_entries_are_known_again(monkeypatch):
    entry = "<Entry><Index>#x6041</Index><SubIndex>0</SubIndex><BitLen>16</BitLen></Entry>"
    gap = "<Entry><Index>#x0</Index><BitLen>8</BitLen></Entry>"
    one, other = (f'<TxPdo Sm="3"><Index>#x1A0{n}</Index><Name>P</Name>{entry}{gap * n}</TxPdo>' for n in (0, 1))
    first = f'<RxPdo Fixed="1"><Index>#x1600</Index><Name>R</Name>{entry}</RxPdo>\n{one}\n'
    content = esi(device(first + other) + device(first, revision="#x2")).encode()
    read = Reader().read(content)
    old, new = read.document.infos[0].devices
    assert new.tx_pdos[0] is old.tx_pdos[0] and new.rx_pdos[0] is old.rx_pdos[0]
    assert old.tx_pdos[1].entries[0] is old.tx_pdos[0].entries[0]
    assert [pdo.pdo_index for pdo in old.tx_pdos] == [0x1A00, 0x1A01] and len(old.tx_pdos[1].entries) == 2
    assert read == plain(content, monkeypatch)


def test_what_follows_in_another_encoding_is_looked_up_anew():
    """The same bytes behind the same part, as UTF-8 after Latin-1: known words, unknown meaning."""
    text = '<?xml version="1.0" encoding="{}"?>' + twice(TYPE, OBJECT + OBJECT.replace("Type<", "\u00c3\u00a4<"))
    reader = Reader()
    latin = text.format("iso-8859-1").encode("iso-8859-1")
    for content, name in ((latin, "\u00c3\u00a4"), (latin.replace(b"iso-8859-1", b"utf-8"), "\u00e4")) * 2:
        assert [held[2].names[0].text for held in parts_of(reader.read(content))] == [name, name]


def test_findings_in_parts_of_a_part_keep_their_lines_and_places(monkeypatch):
    objects = values("#x1018", "03", "0x", "0x", "05") + "\n" + values("#x1019", "03", "0x", "0x", "05")
    text = twice(RECORD, objects)
    reader = Reader()
    reader.read(twice(RECORD, values("#x1018", "03", "04", "06")).encode())
    found = reader.read(text.encode())
    assert [f.line for f in found.findings] == [n for n, line in enumerate(text.splitlines(), 1) if ">0x<" in line]
    assert {f.path.rpartition("Info/SubItem")[2] for f in found.findings} == {
        "[1]/Info/DefaultData",
        "[2]/Info/DefaultData",
    }
    assert found == plain(text.encode(), monkeypatch)


@pytest.mark.parametrize("piece", ["<RxPdo >", "<DataTypes>", "<DataTypes><!--", "<DataTypes><DataType>", "<Flags>"])
def test_start_tags_without_end_are_not_sought_for_again_and_again(piece):
    """That would take time with the square of their number: minutes for these. None of them is well-formed."""
    content = f"<EtherCATInfo>{piece * 50_000}</EtherCATInfo>".encode()
    found = outcome(Reader(), content)
    assert isinstance(found, str) or found.document.recovered  # type: ignore[attr-defined]


def test_findings_of_repeated_parts_are_told_for_each_with_its_line_and_place():
    text = twice(f"\n{TYPE}\n", f"\n{OBJECT}\n{OBJECT}\n{BROKEN}\n")
    reader = Reader()
    reader.read(twice(TYPE, f"\n{OBJECT}").encode())
    expected = [number for number, line in enumerate(text.splitlines(), 1) if "#xZZ" in line]
    found = reader.read(text.encode()).findings
    assert [finding.line for finding in found] == expected
    assert [finding.path.rpartition("Objects/")[2] for finding in found] == ["Object[2]/Index", "Object[2]/Index"]


def test_places_of_findings_count_recognised_parts(monkeypatch):
    reader = Reader()
    reader.read(twice(TYPE, f"\n{OBJECT}").encode())
    content = esi(device(dictionary(TYPE, f"\n{OBJECT}\n{OBJECT}\n{BROKEN}"))).encode()
    assert [finding.path[-15:] for finding in reader.read(content).findings] == ["Object[2]/Index"]
    assert reader.read(content) == plain(content, monkeypatch)


def test_lines_behind_recognised_parts_stay_right():
    text = esi(device(dictionary("\n" + TYPE, f"\n{OBJECT}\n\n{OBJECT}\n") + "\n<Junk/>"))
    reader = Reader()
    for _ in range(2):
        (finding,) = reader.read(text.encode()).findings
        assert finding.line == next(n for n, line in enumerate(text.splitlines(), 1) if "<Junk/>" in line)


@pytest.mark.parametrize(
    "around",
    [
        "<Name><![CDATA[<DataTypes>{}</DataTypes>]]></Name>",
        "<!-- <DataTypes>{}</DataTypes> --><Name>N</Name>",
        "<Name>N</Name><Unknown><DataTypes>{}</DataTypes></Unknown>",
    ],
)
def test_words_in_other_places_are_left_alone(around, monkeypatch):
    other = esi(f'<Device><Type ProductCode="#x7" RevisionNo="#x1">T</Type>{around.format(TYPE)}</Device>')
    reader = Reader()
    reader.read(twice(TYPE, OBJECT).encode())
    assert reader.read(other.encode()) == plain(other.encode(), monkeypatch)


ENTRY = "<Entry><Index>#x7000</Index><SubIndex>1</SubIndex><BitLen>16</BitLen><Name>C</Name></Entry>"
OUTPUTS = f'<RxPdo Sm="2"><Index>#x1600</Index><Name>Outputs</Name>{ENTRY}</RxPdo>'


@pytest.mark.parametrize(
    "first",
    [
        f"<!-- {OUTPUTS.replace('Outputs', 'Old')} -->{OUTPUTS}",
        f"<Info><VendorSpecific>{OUTPUTS.replace('#x1600', '1')}</VendorSpecific></Info>{OUTPUTS}",
        OUTPUTS.replace("Outputs", "<![CDATA[<Entry>a</Entry>]]>"),
        OUTPUTS.replace("</Name>", f"</Name><!-- {ENTRY} -->"),
    ],
)
@pytest.mark.parametrize("second", [OUTPUTS, None])
def test_a_document_with_parts_in_other_places_teaches_nothing(first, second, monkeypatch):
    """Its entries are marked where no entry is read: the records of PDOs around them lack what they hold."""
    reader = Reader()
    for content in (first, second or first):
        document = esi(device(content)).encode()
        assert reader.read(document) == plain(document, monkeypatch)


@pytest.mark.parametrize("encoding", ["utf-8", "iso-8859-1"], ids=["saved as UTF-8", "saved as declared"])
@pytest.mark.parametrize("order", [1, -1])
def test_a_byte_order_mark_counts_more_than_the_declaration(encoding, order, monkeypatch):
    """XML 1.0, section 4.3.3; libxml2 reads UTF-8 behind the mark of UTF-8 whatever the document declares."""
    text = '<?xml version="1.0" encoding="ISO-8859-1"?>' + esi(device(OUTPUTS.replace(">C<", ">Winding \u00b0C<")))
    content = text.encode(encoding)
    reader = Reader()
    for document in (content, b"\xef\xbb\xbf" + content)[::order]:
        assert reader.read(document) == plain(document, monkeypatch)


@pytest.mark.parametrize("blank", ["\f", "\v", "\x1c", "\x85"])
@pytest.mark.parametrize("place", [0, 6, 7])
def test_what_is_no_blank_of_xml_stays_with_the_parser(blank, place, monkeypatch):
    objects = [OBJECT.replace("#x1000", f"#x{number:x}") for number in range(0x2000, 0x2008)]
    reader = Reader()
    reader.read(twice(TYPE, "".join(objects)).encode())
    objects[place] += blank
    content = twice(TYPE, "".join(objects)).encode()
    assert reader.read(content) == plain(content, monkeypatch)
    assert Reader().read(content) == plain(content, monkeypatch)


@pytest.mark.parametrize(
    "objects",
    [
        OBJECT + "<!-- </Object> -->" + OBJECT,
        OBJECT.replace("Type<", "<!-- </Object> -->Type<") * 2,
        OBJECT.replace("Type<", "<![CDATA[</Object><Object>]]><") * 2,
        f"<!--first {OBJECT}-->{OBJECT}" * 2,
        OBJECT.replace("<Object>", '<Object xmlns:a="urn:a" a:b="1">') * 2,
        "text" + OBJECT + OBJECT,
        OBJECT + "<Stray/>" + OBJECT,
        OBJECT.replace("Type<", "Gr\u00f6\u00dfe<") * 2,
    ],
)
def test_odd_layouts_read_as_they_stand(objects, monkeypatch):
    content = twice(TYPE, objects).encode()
    reader = Reader()
    for _ in range(2):
        assert reader.read(content) == plain(content, monkeypatch)


def test_the_same_bytes_in_another_encoding_are_other_words():
    text = '<?xml version="1.0" encoding="{}"?>' + twice(TYPE, OBJECT.replace("Type<", "\u00c3\u00a4<"))
    reader = Reader()
    latin = text.format("iso-8859-1").encode("iso-8859-1")
    utf8 = latin.replace(b"iso-8859-1", b"utf-8")
    names = [parts_of(reader.read(content))[0][1].names[0].text for content in (latin, utf8, latin)]
    assert names == ["\u00c3\u00a4", "\u00e4", "\u00c3\u00a4"]


def test_prefixed_names_depend_on_where_they_stand(monkeypatch):
    marked = OBJECT.replace("<Index>", '<Index p:hint="1">')
    reader = Reader()
    for uri in ("urn:one", "urn:two"):
        content = twice(TYPE, marked * 2).replace("<EtherCATInfo>", f'<EtherCATInfo xmlns:p="{uri}">').encode()
        assert reader.read(content) == plain(content, monkeypatch)


def test_a_full_memory_starts_anew(monkeypatch):
    monkeypatch.setattr(repeats, "_CAPACITY_BYTES", 300)
    reader = Reader()
    contents = [twice(TYPE, OBJECT.replace("#x1000", f"#x{number:x}")).encode() for number in range(8)]
    for content in contents * 2:
        assert reader.read(content) == plain(content, monkeypatch)


PIECES = st.sampled_from(
    [TYPE, OBJECT, BROKEN, RECORD, values("#x1018", "03", "04"), FLAGS, "<SubItem>", "</SubItem>", "<SubItem a='1'/>",
     "<RxPdo Sm='2'><Index>#x1600</Index><Name/></RxPdo>", OUTPUTS, ENTRY, "\f",
     "\n", " ", "<!--", "-->", "<![CDATA[", "]]>", "</Object>", "<Object>", "<DataTypes>",
     "</DataTypes>", "<Objects>", "</Objects>", "</Dictionary>", "<Object/>", "<Object a='1'>", "&amp;", "&x;", "<?p?>"]
)  # fmt: skip


@settings(max_examples=200)
@given(st.lists(st.tuples(st.lists(PIECES, max_size=6), st.lists(PIECES, max_size=6)), min_size=1, max_size=3))
def test_whatever_the_text_reading_is_the_same(documents):
    reader = Reader()
    reader.read(twice(TYPE, OBJECT).encode())
    for types, objects in documents:
        content = twice("".join(types), "".join(objects)).encode()
        with pytest.MonkeyPatch.context() as monkeypatch:
            monkeypatch.setattr(Repeats, "cut", lambda self, content: None)
            expected = outcome(Reader(), content)
        assert outcome(reader, content) == expected


def outcome(reader: Reader, content: bytes) -> object:
    try:
        return reader.read(content)
    except EsiCatalogError as error:
        return str(error)


@pytest.mark.corpus
def test_every_real_document_reads_as_without_recognising(corpus: Path, monkeypatch):
    reader, without = Reader(), Reader()
    count = 0
    for item in discover([corpus / "esi"]):
        founds = archive_members(item) if isinstance(item, FoundArchive) else [item]
        for found in founds:
            if found.problem is not None or found.nested:
                continue
            content = _content(item, found)
            with monkeypatch.context() as patched:
                patched.setattr(Repeats, "cut", lambda self, content: None)
                expected = outcome(without, content)
            assert outcome(reader, content) == expected, found
            count += 1
    assert count > 300


def _content(item: object, found: object) -> bytes:
    from esicatalog.esi.containers import Archive

    if isinstance(item, FoundArchive):
        return Archive(Path(item.location)).read(found.name)  # type: ignore[attr-defined]
    return Path(item.location).read_bytes()  # type: ignore[attr-defined]
