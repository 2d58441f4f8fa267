"""Reading records: tolerant of order, keeping spelling, order of repeats, languages, and what it does not know."""

import random
import re

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lxml import etree
from snippets import device, dictionary, esi, only_device, pdo, read

from esicatalog.errors import DocumentError
from esicatalog.esi.reader import Reader
from esicatalog.esi.records.common import Name, display_text


def findings(text: str, rule: str = "L05") -> list[tuple[int, str]]:
    return [(f.line, f.message) for f in read(text).findings if f.rule == rule]


def unmapped(text: str) -> dict[str, str]:
    return {item.path: item.value for item in only_device(text).unmapped}


def test_an_unknown_element_is_kept_with_path_and_line():
    text = esi("\n\n" + device('\n<Mystery a="1">one<Inner>two</Inner>three</Mystery>'))
    assert unmapped(text) == {
        "Mystery": "one",
        "Mystery/@a": "1",
        "Mystery/Inner": "two",
        "Mystery/Inner/following-text": "three",
    }
    ((line, message),) = findings(text)
    assert line == 4
    assert "Mystery" in message


def test_an_unknown_attribute_is_kept_with_path_and_line():
    text = esi(device('<Sm>MBoxOut</Sm>\n<Sm Color="blue">MBoxIn</Sm>'))
    assert unmapped(text) == {"Sm[1]/@Color": "blue"}
    ((line, message),) = findings(text)
    assert line == 2
    assert "Color" in message


def test_a_repeated_single_element_is_kept():
    text = esi(device("<Dc/>\n<ESC><Reg0108>1</Reg0108></ESC>\n<ESC><Reg0108>2</Reg0108></ESC>"))
    assert only_device(text).esc_reg0108 == 1
    assert list(unmapped(text).values()) == ["2"]
    assert findings(text)[0][0] == 3


def test_a_repeated_record_is_kept():
    text = esi(device("<Mailbox><CoE/></Mailbox>\n<Mailbox><FoE/><EoE IP='1'/></Mailbox>"))
    assert only_device(text).mailbox.coe
    assert not only_device(text).mailbox.foe
    assert unmapped(text)["Mailbox[1]/EoE/@IP"] == "1"


@pytest.mark.parametrize(
    ("content", "kept"),
    [
        ("<Mailbox><CoE/></Mailbox><Mailbox><EoE/></Mailbox>", {"Mailbox[1]/EoE": ""}),
        ("<foo><bar/><baz>1</baz></foo>", {"foo/bar": "", "foo/baz": "1"}),
        (
            "<Mailbox><QoE><Fast/></QoE><XoE a='1'><Fast> </Fast></XoE></Mailbox>",
            {"Mailbox/QoE/Fast": "", "Mailbox/XoE/@a": "1", "Mailbox/XoE/Fast": ""},
        ),
    ],
)
def test_empty_elements_are_kept(content, kept):
    assert unmapped(esi(device(content))) == kept


def test_stray_text_is_kept():
    text = esi(device("<Dc>stray\n<OpMode><Name>DC</Name></OpMode>tail</Dc>after"))
    assert sorted(item.value for item in only_device(text).unmapped) == ["after", "stray", "tail"]
    assert len(findings(text)) == 3


def test_a_repeated_unknown_attribute_below_a_cached_record_is_told_for_every_device():
    strange = pdo("RxPdo", "#x1600", 8, attributes='Strange="x"')
    text = esi(device(strange) + device(strange, revision="#x2"))
    devices = read(text).document.infos[0].devices
    assert [len(d.unmapped) for d in devices] == [1, 1]
    assert len(findings(text)) == 2


def test_unknown_things_outside_of_devices_belong_to_the_document():
    document = read(esi().replace("<Groups>", "<Odd>text</Odd><Groups>")).document
    assert [(item.path.rsplit("/", 1)[-1], item.value) for item in document.unmapped] == [("Odd", "text")]


def test_comments_and_processing_instructions_are_no_content():
    text = esi(device("<!-- note --><?pi x?><Sm><!-- in -->MBoxOut<!-- after --></Sm>"))
    assert only_device(text).sync_managers[0].usage == "MBoxOut"
    assert read(text).findings == ()


def test_the_order_of_different_elements_does_not_matter():
    parts = [
        "<Fmmu>Outputs</Fmmu>",
        '<Sm StartAddress="#x1000">Outputs</Sm>',
        pdo("RxPdo", "#x1600", 16, 16),
        "<Mailbox><CoE SdoInfo='1'/><EoE/></Mailbox>",
        "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>",
        "<ESC><Reg0108>3</Reg0108></ESC>",
        "<Info><Electrical><EBusCurrent>-5</EBusCurrent></Electrical></Info>",
    ]
    expected = only_device(esi(device("".join(parts))))
    for seed in range(5):
        random.Random(seed).shuffle(parts)
        assert only_device(esi(device("".join(parts)))) == expected


def test_the_order_of_repeats_is_meaning():
    text = esi(device("<Sm>MBoxOut</Sm><Fmmu>Inputs</Fmmu><Sm>MBoxIn</Sm><Fmmu>Outputs</Fmmu><Sm>Outputs</Sm>"))
    found = only_device(text)
    assert [sm.usage for sm in found.sync_managers] == ["MBoxOut", "MBoxIn", "Outputs"]
    assert [fmmu.usage for fmmu in found.fmmus] == ["Inputs", "Outputs"]


def test_the_vendors_spelling_is_kept_beside_the_value():
    found = only_device(esi(device('<Sm StartAddress="4096" ControlByte="#x0026" Virtual="false">Outputs</Sm>')))
    (sm,) = found.sync_managers
    assert (sm.start_address, sm.control_byte, sm.virtual) == (0x1000, 0x26, False)
    assert sm.spelling == {"start_address": "4096", "virtual": "false"}


def test_an_identity_out_of_range_is_null_with_its_text():
    found = only_device(esi(device(product="#x1010533004")))
    assert found.product_code is None
    assert found.spelling["product_code"] == "#x1010533004"


def test_a_malformed_number_is_told_with_its_line():
    ((line, message),) = findings(esi(device('\n<Sm StartAddress="wrong">Outputs</Sm>')), "L06")
    assert line == 2
    assert "wrong" in message


def test_equal_subtrees_give_equal_records_and_findings_every_time():
    reader = Reader()
    content = esi(device(pdo("RxPdo", "0x1600", 8))).encode()
    first, second = reader.read(content), reader.read(content)
    assert first == second
    assert [f.rule for f in second.findings] == ["L06"]


def test_names_in_several_languages():
    text = esi(device().replace("<Name>N</Name>", '<Name LcId="1031">Gerät</Name><Name LcId="2052">设备</Name>'))
    assert only_device(text).names == (Name(text="Gerät", lcid=1031), Name(text="设备", lcid=2052))


@pytest.mark.parametrize(
    ("names", "asked", "shown"),
    [
        ([(1031, "de"), (1033, "en"), (2052, "zh")], 1031, "de"),
        ([(1031, "de"), (1033, "en")], 1036, "en"),
        ([(1031, "de"), (None, "plain")], 1036, "plain"),
        ([(1031, "de"), (0, "zero")], 1036, "zero"),
        ([(2052, "zh"), (1031, "de")], 1036, "zh"),
        ([(1033, ""), (1031, "de")], 1033, "de"),
        ([(1033, "")], 1033, ""),
        ([], 1033, None),
    ],
)
def test_the_name_to_show(names, asked, shown):
    assert display_text(tuple(Name(text=text, lcid=lcid) for lcid, text in names), asked) == shown


def test_vendor_specific_xml_is_kept_as_it_stands():
    xml = '<VendorSpecific><T:Own xmlns:T="urn:t" b="2" a="1">x<Inner/>&amp;</T:Own></VendorSpecific>'
    kept = etree.fromstring(only_device(esi(device(xml))).vendor_specific)
    (own,) = kept
    assert own.tag == "{urn:t}Own"
    assert dict(own.attrib) == {"a": "1", "b": "2"}
    assert (own.text, own[0].tag, own[0].tail) == ("x", "Inner", "&")


def test_empty_elements_differ_from_absent_ones():
    found = only_device(esi(device("<Dc/><Slots/><Mailbox><FoE/></Mailbox>")))
    assert (found.dc, found.has_slots, found.mailbox.foe, found.mailbox.coe) == (True, True, True, False)
    plain = only_device(esi(device()))
    assert (plain.dc, plain.has_slots, plain.mailbox, plain.eeprom) == (False, False, None, None)


@pytest.mark.parametrize(("written", "read_as"), [("YY K", "YY K"), (" YK", " YK"), ("YY  ", "YY"), ("", "")])
def test_blanks_in_physics_are_unused_ports(written, read_as):
    """Character i describes port i: leading and inner blanks count, trailing ones do not (ESI-FACTS section 4)."""
    found = only_device(esi(device().replace('Physics="YY"', f'Physics="{written}"')))
    assert found.physics.rstrip() == read_as


def test_attributes_of_other_namespaces_are_kept():
    """Only those of XML Schema instances say nothing about the device."""
    foreign = 'xmlns:v="urn:vendor" v:extra="kept" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:nil="0"'
    found = only_device(esi(device(f"<Sm {foreign}>Outputs</Sm>")))
    assert [item.value for item in found.unmapped] == ["kept"]


def test_a_module_document():
    module = "<Module><Type ModuleIdent='#x7'>M</Type><Name>Module</Name></Module>"
    vendor = "<Vendor><Id>1</Id><Name>V</Name></Vendor>"
    document = read(f"<EtherCATModule>{vendor}<Modules>{module}</Modules></EtherCATModule>").document
    assert document.root == "EtherCATModule"
    assert [m.module_ident for m in document.infos[0].modules] == [7]


def test_a_diagnosis_document():
    message = "<DiagMessage><TextId>#x10</TextId><MessageText>Too hot</MessageText></DiagMessage>"
    document = read(f"<EtherCATDiag><DiagMessages>{message}</DiagMessages></EtherCATDiag>").document
    assert [(m.text_id, m.message_texts[0].text) for m in document.diag_messages.diag_messages] == [(16, "Too hot")]


NAMES = st.sampled_from(
    ["Device", "Type", "Name", "Sm", "RxPdo", "Entry", "Index", "Dc", "OpMode", "Info", "Slot", "X"]
)
TEXTS = st.text(st.characters(codec="utf-8", exclude_categories=("Cc", "Cs"), exclude_characters="<&\ufffe\uffff"))
TREES = st.recursive(
    TEXTS,
    lambda inner: st.builds(lambda tag, parts: f"<{tag}>{''.join(parts)}</{tag}>", NAMES, st.lists(inner, max_size=4)),
    max_leaves=12,
)


def leaves(value: object) -> list[str]:
    """All texts and numbers in a record, as texts."""
    if isinstance(value, dict | list | tuple):
        return [text for part in (value.values() if isinstance(value, dict) else value) for text in leaves(part)]
    return [str(value)]


@settings(max_examples=150, deadline=None)
@given(st.lists(TREES, max_size=4))
def test_any_tree_below_a_device_keeps_its_texts(parts):
    text = esi(device("".join(parts)))
    kept = " ".join(leaves(msgspec.to_builtins(read(text))))
    for found in etree.fromstring(text).iter("Device"):
        for word in " ".join(found.itertext()).split():
            assert word in kept or int(word) in map(int, re.findall(r"-?\d+", kept))


@given(st.binary(max_size=300))
def test_no_bytes_break_the_reader(content):
    for document in (content, b"<EtherCATInfo>" + content + b"</EtherCATInfo>"):
        try:
            read(document)
        except DocumentError as error:
            assert "\n" not in str(error)


def test_lines_beyond_what_libxml2_counts():
    """The line of a Device is that of its start tag, however long the document and whatever stands around it."""
    far = "<!-- <Device> -->\n<Device\n Physics='>'\n><Type ProductCode='#x2'\n>T</Type></Device>"
    text = esi(device("\n" * 70_000) + far + "\n" + device(revision="#x3"))
    ends = [text.index("Physics='>'\n>") + len("Physics='>'\n"), text.rindex("<Device ")]
    expected = [text.count("\n", 0, end) + 1 for end in ends]
    assert expected[0] > 70_000
    assert read(text).document.device_lines == ((1, *expected),)


def test_a_misplaced_element_is_told_with_what_the_schema_has_behind_it():
    """Sequence of the schema: RxPdo, TxPdo; nobody knows Foo."""
    found = read(esi(device("<TxPdo/><Foo/><RxPdo/>"))).findings
    assert [finding.message for finding in found if finding.rule == "L04"] == [
        "Device: RxPdo stands behind TxPdo; the schema has it before"
    ]


@pytest.mark.parametrize(
    ("content", "place", "given", "counting"),
    [
        (
            "<Profile><Dictionary/><DictionaryFile>d.xml</DictionaryFile></Profile>",
            "Profile",
            "Dictionary and DictionaryFile",
            "Dictionary",
        ),
        (
            "<Profile><DictionaryFile>d.xml</DictionaryFile><Dictionary/></Profile>",
            "Profile",
            "Dictionary and DictionaryFile",
            "Dictionary",
        ),
        ("<Eeprom><Data>00</Data><ConfigData>05</ConfigData></Eeprom>", "Eeprom", "Data and ConfigData", "Data"),
        (
            dictionary(
                "",
                "<Object><Info><DefaultValue>0</DefaultValue><DefaultData>01</DefaultData></Info></Object>",
            ),
            "Object",
            "Info/DefaultData and Info/DefaultValue",
            "Info/DefaultData",
        ),
    ],
)
def test_alternatives_that_are_given_together_are_told_alone(content, place, given, counting):
    """xs:choice: none stands before the other."""
    found = [item for item in read(esi(device(content))).findings if item.rule in ("L03", "L04", "L05")]
    said = f"{place}: {given} are given, of which the schema has one only; {counting} counts"
    assert [(item.rule, item.message) for item in found] == [("L05", said)]


def test_an_alternative_that_is_empty_says_nothing():
    content = dictionary("", "<Object><Info><DefaultData/><DefaultValue>1</DefaultValue></Info></Object>")
    assert [item for item in read(esi(device(content))).findings if item.rule == "L05"] == []


@pytest.mark.parametrize(
    ("first", "second", "tag"),
    [
        ("<Descriptions><Devices>", "</Devices></Descriptions><Descriptions><Devices>", "Descriptions"),
        ("<Devices>", "</Devices><Devices>", "Devices"),
        ("<Devices>", "</Devices><Foo/><Devices>", "Devices"),
    ],
)
def test_what_occurs_again_around_devices_is_read_as_one_and_told(first, second, tag):
    text = esi(device() + "@" + device(revision="#x2")).replace("@", second)
    assert first in text
    document = read(text)
    assert [found.revision_no for found in document.document.infos[0].devices] == [1, 2]
    assert f"element {tag} occurs again; read as one with the first" in [item.message for item in document.findings]


def test_objects_that_occur_again_are_read_as_one_and_told():
    declared = "<Object><Index>#x{}</Index><Name>O</Name><Type>USINT</Type><BitSize>8</BitSize></Object>"
    twice = f"{declared.format(2000)}</Objects><Objects>{declared.format(2001)}"
    document = read(esi(device(dictionary("<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType>", twice))))
    (found,) = document.document.infos[0].devices
    assert [item.object_index for item in found.profiles[0].dictionary.objects] == [0x2000, 0x2001]
    assert [item.message for item in document.findings] == ["element Objects occurs again; read as one with the first"]


def test_clocks_that_occur_again_are_read_once():
    """Both OpModes are read; an attribute that both have is kept as unmapped, and nothing else of the second Dc."""
    modes = [f"<OpMode><Name>{name}</Name><AssignActivate>0</AssignActivate></OpMode>" for name in "AB"]
    again = '<Dc UnknownFRMW="1">{}</Dc><Dc UnknownFRMW="0">{}</Dc>'.format(*modes)
    document = read(esi(device(again)))
    (found,) = document.document.infos[0].devices
    assert [mode.name for mode in found.op_modes] == ["A", "B"]
    assert [(item.path, item.value) for item in found.unmapped] == [("Dc[1]/@UnknownFRMW", "0")]
    assert [item.message for item in document.findings] == [
        "element Dc occurs again; read as one with the first",
        "attribute Dc/@UnknownFRMW repeats a value given before; kept in unmapped",
    ]
