"""Parts that are laid out like others are read without the parser: what it would give, or nothing."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lxml import etree

from esicatalog.esi.binding import Record, read_record
from esicatalog.esi.documents import make_parser
from esicatalog.esi.layouts import Layouts
from esicatalog.esi.notes import Notes
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.dictionary import DataType, Flags, Object, SubItem
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.esi.repeats import MARK

ENTRY = '<Entry Fixed="true"><Index>{}</Index><BitLen>{}</BitLen><Name LcId="1033">{}</Name></Entry>'


def read(record_type: type, *words: str, layouts: Layouts | None = None) -> list[Record | None]:
    layouts = layouts or Layouts({SubItem, Entry})
    return [layouts.read(record_type, text.encode()) for text in words]


def parsed(record_type: type[Record], words: str) -> Record | None:
    """What the parser gives; None for anything with a finding."""
    notes = Notes()
    try:
        record = read_record(record_type, etree.fromstring(words.encode(), make_parser()), notes)
    except etree.XMLSyntaxError:
        return None
    return None if notes.findings else record


def test_a_layout_that_is_met_often_is_read_without_the_parser():
    found = read(Entry, *(ENTRY.format(f"#x600{n}", n, f"Name {n}") for n in range(5)))
    assert found[:3] == [None, None, None]
    assert found[4] == Entry(
        entry_index=0x6004,
        bit_length=4,
        names=(Name(text="Name 4", lcid=1033),),
        fixed=True,
        spelling={"fixed": "true"},
    )


def test_a_text_that_does_not_fit_its_field_is_left_to_the_parser_which_finds_it():
    words = "<Entry><Index>#x{:04X}</Index><SubIndex>{}</SubIndex><BitLen>8</BitLen></Entry>"
    found = read(Entry, *[words.format(0x6000, n) for n in range(4)], words.format(0x16000, 1), words.format(1, 256))
    assert found[3:] == [Entry(entry_index=0x6000, subindex=3, bit_length=8), None, None]


def test_a_layout_with_an_attribute_that_breaks_the_format_is_left_to_the_parser():
    words = '<Exclude DependOnSlot="yes">#x1600</Exclude>'
    assert read(Exclude, *[words] * 5) == [None] * 5


def test_spellings_stand_in_the_order_of_the_document():
    (*_, entry) = read(Entry, *[ENTRY.format("24641", "008", "N")] * 4)
    assert entry is not None and list((entry.spelling or {}).items()) == [
        ("fixed", "true"),
        ("entry_index", "24641"),
        ("bit_length", "008"),
    ]


def test_spellings_of_attributes_between_those_of_texts_are_left_to_the_parser():
    text = '<Object><Index>1</Index><Index DependOnSlot="true"/></Object>'
    assert read(Object, *[text] * 5) == [None] * 5


def test_parts_of_parts_are_made_once():
    words = "<SubItem><Name>{}</Name><Flags><Access>ro</Access><Backup>1</Backup></Flags></SubItem>"
    first, second = read(SubItem, *(words.format(n) for n in range(5)))[3:]
    assert isinstance(first, SubItem) and isinstance(second, SubItem)
    assert (first.name, second.name) == ("3", "4")
    assert first.flags is second.flags and first.flags == Flags(access="ro", backup=1)


def test_numbers_of_layouts_themselves_are_not_taken_for_places():
    """In the specimen of a layout numbers from 100000000 on stand for texts."""
    words = [
        f"<Object><Index>#x{number:x}</Index><Name LcId='{lcid}'>Same</Name><Type>UINT</Type></Object>"
        for number in range(0x2000, 0x2008)
        for lcid in ("1000000021", "100000002", "11", "2")
    ]
    for found, piece in zip(read(Object, *words), words, strict=True):
        assert found is None or found == parsed(Object, piece)


def test_equal_flags_are_one_record_in_other_layouts_too_and_for_the_parser():
    flags = "<Flags><Access>ro</Access><Backup>7</Backup></Flags>"
    words = f"<SubItem><Name>N</Name>{flags}</SubItem>", f"<SubItem><Name>N</Name>\n{flags}\n</SubItem>"
    found = [read(SubItem, *[text] * 4)[-1] for text in words] + [parsed(SubItem, text) for text in words]
    assert len({id(item.flags) for item in found if isinstance(item, SubItem)}) == 1


def test_runs_stand_where_their_mark_is():
    layouts = Layouts({Entry})
    entries = (Entry(entry_index=1), Entry(entry_index=2))
    words = f'<RxPdo><Index>#x1600</Index><Entry {MARK}="Entry">.</Entry></RxPdo>'.encode()
    found = [layouts.read(Pdo, words, (entries,)) for _ in range(4)][-1]
    assert found == Pdo(pdo_index=0x1600, entries=entries)


def test_comments_and_sections_say_what_they_say_to_the_parser():
    words = "<DataType>\r\n <!-- 1 -->\r\n <Name><![CDATA[A\r\nB]]></Name><BitSize>8</BitSize></DataType>\r\n"
    assert read(DataType, *[words] * 4)[-1] == DataType(name="A\nB", bit_size=8)


@pytest.mark.parametrize(
    "words",
    [
        "<Entry><Index>#x0x6000</Index></Entry>",
        "<Entry><Index>6000</Index><Index>6000</Index></Entry>",
        "<Entry><BitLen>8</BitLen><Index>6000</Index></Entry>",
        "<Entry><Index>6000</Index>stray<BitLen>8</BitLen></Entry>",
        "<Entry><Index>6000</Index><New>8</New></Entry>",
        "<Entry><Name>a &amp; b</Name></Entry>",
        "<Entry><Name>Gr\u00f6\u00dfe</Name></Entry>",
        "<Entry><Name>a<!-- b -->c</Name></Entry>",
        "<Entry><Name>a]]>b</Name></Entry>",
        "<Entry><Name>a\x01b</Name></Entry>",
        "<Entry><Name>a</Entry></Name>",
        '<Entry p:a="1"><Name>a</Name></Entry>',
        '<Entry Fixed="0100000000"><Name>a</Name></Entry>',
        "<Entry><Name>" + "a" * 60_000 + "</Name></Entry>",
    ],
)
def test_what_the_parser_has_to_see_is_left_to_it(words):
    assert read(Entry, *[words] * 5) == [None] * 5


def test_parts_that_nest_deep_are_left_to_the_parser_which_counts_what_is_around_them_too():
    words = "<Object><Info>" + "<SubItem><Info>" * 30 + "</Info></SubItem>" * 30 + "</Info></Object>"
    assert parsed(Object, words) is not None
    assert read(Object, *[words] * 5) == [None] * 5


TEXTS = st.text(st.sampled_from("aZ09 #x.-\t\n\r<>&]![/\u00e4\x01\x0b"), max_size=8) | st.sampled_from(
    ["#x6000", "8", "008", "0100000000", " ", "true", "<![CDATA[a]]>", "<![CDATA[ ]]>", "<![CDATA[]]>",
     "<!-- b -->", "&lt;"]
)  # fmt: skip
PIECES = [
    "<Index>{}</Index>", '<Index DependOnSlot="true">{}</Index>', "<SubIndex>{}</SubIndex>", "<BitLen>{}</BitLen>",
    "<Name>{}</Name>", '<Name LcId="1033">{}</Name>', "<Comment>{}</Comment>", "<Comment/>", "{}", "<!--{}-->",
    "\r\n\t", '<DataType DScale="1">{}</DataType>', "<AdsInfo>{}<a/></AdsInfo>", "<?p {}?>", "<b>", "</b>",
]  # fmt: skip


@settings(max_examples=300)
@given(st.data(), st.lists(st.sampled_from(PIECES), max_size=6))
def test_every_part_is_read_as_the_parser_reads_it(data, pieces):
    layouts = Layouts({Entry})
    for _ in range(6):
        words = "".join(piece.replace("{}", data.draw(TEXTS)) for piece in pieces)
        words = f"<Entry>{words}</Entry>"
        (found,) = read(Entry, words, layouts=layouts)
        expected = parsed(Entry, words)
        assert found is None or (found == expected and repr(found) == repr(expected)), words
