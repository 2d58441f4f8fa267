"""Rules about values: what fits into a field or a type, and what is written when."""

import re

import pytest
from snippets import device, dictionary, esi, pdo, write
from test_lint_rules import TYPES, declared, findings, linted

SM = "<Sm {}>Outputs</Sm>"
OP_MODE = "<Dc><OpMode><Name>DC</Name><AssignActivate>{}</AssignActivate></OpMode></Dc>"
ENTRY_OF = (
    "<RxPdo><Index>{}</Index><Name>R</Name>"
    "<Entry><Index>{}</Index><SubIndex>{}</SubIndex><BitLen>8</BitLen></Entry></RxPdo>"
)
INIT_CMD = (
    "<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>{}</Index><SubIndex>{}</SubIndex><Data>00</Data>"
    "</InitCmd></CoE></Mailbox>"
)


@pytest.mark.parametrize(
    ("content", "place", "bits"),
    [
        (SM.format('StartAddress="#x11000"'), "Sm/@StartAddress", 16),
        (SM.format('ControlByte="#x164"'), "Sm/@ControlByte", 8),
        (SM.format('DefaultSize="65536"'), "Sm/@DefaultSize", 16),
        (OP_MODE.format("#x10300"), "AssignActivate", 16),
        (ENTRY_OF.format("#x11600", "#x7000", 1), "Index", 16),
        (ENTRY_OF.format("#x1600", "#x17000", 1), "Index", 16),
        (ENTRY_OF.format("#x1600", "#x7000", 256), "SubIndex", 8),
        (INIT_CMD.format("#x12000", 1), "Index", 16),
        (INIT_CMD.format("#x2000", 300), "SubIndex", 8),
        (dictionary("", declared("#x12000", "UINT", 16)), "Index", 16),
    ],
)
def test_l06_knows_how_wide_a_field_is(tmp_path, content, place, bits):
    """Registers and indices have 16 bits, ControlByte and subindices 8 (ETG.1000.6, ESC registers 0x0800 and on)."""
    (found,) = linted(tmp_path, "L06", device(content))
    assert re.fullmatch(rf"{place}: '[#\w]+' does not fit into {bits} bits; read as \d+", found["message"])


_VAR = dictionary("", declared("#x7000", "UINT", 16))
_MAPPED = "<RxPdo Fixed='1'><Index>#x1600</Index><Name>R</Name><Entry>{}</Entry></RxPdo>"


@pytest.mark.parametrize(
    ("rule_id", "text", "empty"),
    [
        ("L08", esi(device(), vendor="{}<Name>V</Name>"), "<Id></Id>"),
        ("L10", esi(device().replace('RevisionNo="#x1"', "{}")), 'RevisionNo=" "'),
        ("L26", esi(device("<Sm StartAddress='#x1000' ControlByte='#x26' {}>MBoxOut</Sm>")), 'DefaultSize=""'),
        ("L33", esi(device(_MAPPED.format("<Index>#x7000</Index><SubIndex>1</SubIndex>{}"))), "<BitLen/>"),
        ("L33", esi(device(_MAPPED.format("{}<BitLen>8</BitLen>"))), "<Index> </Index>"),
        ("L37", esi(device(_MAPPED.format("<Index>#x7000</Index>{}<BitLen>8</BitLen>") + _VAR)), "<SubIndex/>"),
        ("L49", esi(device("<Dc><OpMode><Name>DC</Name>{}</OpMode></Dc>")), "<AssignActivate/>"),
    ],
)
def test_an_empty_text_is_what_an_absent_value_is(tmp_path, rule_id, text, empty):
    """Beside L06 it gives the findings that an absent value gives."""
    found = []
    for kind, given in (("empty", empty), ("absent", "")):
        folder = write(tmp_path / kind, {"a.xml": text.replace("{}", given)})
        found.append({item["rule"]: item["message"] for item in findings(folder)})
    assert found[0].pop("L06").endswith("; an empty text counts as absent")
    assert found[0] == found[1]
    assert rule_id in found[0]


@pytest.mark.parametrize(
    ("rule_id", "words"), [("L06", "Type/@ProductCode: '0x1' has a C prefix"), ("L03", "RxPdo/@Fixed: 'yes' is not")]
)
def test_the_attribute_that_breaks_the_format_is_named(tmp_path, rule_id, words):
    text = device(pdo("RxPdo", "#x1600", 8, attributes='Fixed="yes"'), product="0x1")
    (found,) = linted(tmp_path, rule_id, text)
    assert found["message"].startswith(words)


def test_l17_looks_at_the_names_of_channels(tmp_path):
    channel = "<ChannelInfo><ProfileNo>402</ProfileNo>{}</ChannelInfo>"
    twice = channel.format("<DisplayName>A</DisplayName><DisplayName LcId='1033'>B</DisplayName>")
    once = channel.format("<DisplayName>A</DisplayName><DisplayName LcId='1031'>B</DisplayName>")
    (found,) = linted(tmp_path, "L17", device(f"<Profile>{once}{twice}</Profile>"))
    assert found["path"].endswith("Device/Profile/ChannelInfo[1]/DisplayName[1]")


@pytest.mark.parametrize(
    ("index", "words"),
    [
        ("<Index>#x0x8001x</Index>", "InitCmd for ? '#x0x8001x':0A has no Transition, so it is never sent: give one"),
        ("", "InitCmd without Index has no Transition, so it is never sent: give one"),
    ],
)
def test_l56_shows_an_index_as_it_stands(tmp_path, index, words):
    command = f"<InitCmd>{index}<SubIndex>10</SubIndex><Data>01</Data></InitCmd>"
    (found,) = linted(tmp_path, "L56", device(f"<Mailbox><CoE>{command}</CoE></Mailbox>"))
    assert found["message"] == words


def test_l18_knows_a_mailbox_by_its_mode(tmp_path):
    """What ``ethercat xml`` prints: no roles, no Mailbox; 0x26 and 0x22 are mailboxes."""
    sms = "".join(f'<Sm ControlByte="#x{control}"/>' for control in ("26", "22", "64", "20"))
    found = linted(tmp_path, "L18", device(sms))
    words = "is in mailbox mode, but there is no Mailbox: say which protocols it carries"
    assert [item["message"] for item in found] == [f"SM {number} {words}" for number in (0, 1)]


def test_l56_says_nothing_of_a_command_that_nobody_sends(tmp_path):
    """Where it writes to is not known: its SubIndex cannot be read."""
    command = (
        "<InitCmd><Transition>PS</Transition><Index>#x2000</Index><SubIndex>x1</SubIndex><Data>01</Data></InitCmd>"
    )
    described = dictionary(TYPES, declared("#x2000", "UINT", 16))
    assert linted(tmp_path, "L56", device(f"{described}<Mailbox><CoE>{command}</CoE></Mailbox>")) == []


@pytest.mark.parametrize(
    ("restriction", "transitions", "refused"),
    [
        ("PreOP", ["IP", "PS"], ""),
        ("PreOP", ["PS", "SO"], "SO"),
        ("SafeOP_OP", ["IP", "PS", "SO"], "IP, PS"),
        ("PreOP", ["OP"], ""),  # leads back: in which state it is sent is not defined
    ],
)
def test_l56_knows_when_an_object_can_be_written(tmp_path, restriction, transitions, refused):
    written = declared("#x2000", "UINT", 16).replace("<Access>", f'<Access WriteRestrictions="{restriction}">')
    transition = "".join(f"<Transition>{name}</Transition>" for name in transitions)
    command = f"<InitCmd>{transition}<Index>#x2000</Index><SubIndex>0</SubIndex><Data>0100</Data></InitCmd>"
    sent = f"<Mailbox><CoE>{command}</CoE></Mailbox>"
    found = linted(tmp_path, "L56", device(dictionary(TYPES, written) + sent))
    said = f"InitCmd for 0x2000:00 is sent at {refused}, when WriteRestrictions forbid to write the object: "
    assert [item["message"] for item in found] == ([f"{said}correct Transition"] if refused else [])


@pytest.mark.parametrize(
    ("type_name", "bits", "value", "words"),
    [
        (
            "UINT",
            16,
            "<DefaultValue>70000</DefaultValue>",
            "the default 70000, which does not fit into the 16 bits of UINT",
        ),
        ("UINT", 16, "<DefaultValue>-1</DefaultValue>", "the default -1, which does not fit into the 16 bits of UINT"),
        ("UINT", 16, "<DefaultValue>65535</DefaultValue>", None),
        (
            "INT",
            16,
            "<DefaultValue>32768</DefaultValue>",
            "the default 32768, which does not fit into the 16 bits of INT",
        ),
        ("INT", 16, "<DefaultValue>-32768</DefaultValue>", None),
        ("INT", 16, "<DefaultValue>#xFFFF</DefaultValue>", None),  # the bits of -1
        ("UINT", 16, "<DefaultValue>#x1FFFFFFFFFFFFFFFF</DefaultValue>", None),  # of that the reader tells
        ("UINT", 16, "<DefaultValue>#xFFFFFFFFFFFFFFFF</DefaultValue>", "the default 18446744073709551615, which does"),
        ("ULINT", 64, "<DefaultValue>#xFFFFFFFFFFFFFFFF</DefaultValue>", None),
        ("LINT", 64, "<DefaultValue>#x8000000000000000</DefaultValue>", None),  # the bits of -2**63
        (
            "LINT",
            64,
            "<DefaultValue>18446744073709551615</DefaultValue>",
            "the default 18446744073709551615, which does not fit into the 64 bits of LINT",
        ),
        ("BOOL", 1, "<DefaultValue>1</DefaultValue>", None),
        ("BOOL", 1, "<DefaultData>01</DefaultData>", None),
        ("BOOL", 1, "<DefaultData>02</DefaultData>", "the default 2, which does not fit into the 1 bit of BOOL"),
        ("BOOL", 1, "<DefaultData>FF</DefaultData>", None),  # true in all bits
        ("BIT12", 12, "<DefaultData>FF0F</DefaultData>", None),
        ("BIT12", 12, "<DefaultData>FFFF</DefaultData>", "the default 65535, which does not fit into the 12 bits"),
        ("INT", 16, "<DefaultData>FFFF</DefaultData>", None),
        ("OCTET_STRING(3)", 24, "<DefaultString>abc</DefaultString>", None),
        ("OCTET_STRING(3)", 24, "<DefaultString>abcd</DefaultString>", "a DefaultString of 4 characters, OCTET_STRI"),
        ("BOOL", 1, "<DefaultValue>2</DefaultValue>", "the default 2, which does not fit into the 1 bit of BOOL"),
        ("UINT", 16, "<DefaultString>70000</DefaultString>", "the default 70000, which does not fit into the 16 bits"),
        ("STRING(4)", 32, "<DefaultString>ABCD</DefaultString>", None),
        ("STRING(4)", 32, "<DefaultString>ABCDE</DefaultString>", "a DefaultString of 5 characters, STRING(4) has 4"),
        ("STRING(0)", 0, "<DefaultString>ABCDE</DefaultString>", None),  # of any length
    ],
)
def test_l45_knows_what_fits_into_a_type(tmp_path, type_name, bits, value, words):
    profile = dictionary(
        f"<DataType><Name>{type_name}</Name><BitSize>{bits}</BitSize></DataType>",
        declared("#x2000", type_name, bits, content=f"<Info>{value}</Info>"),
    )
    found = linted(tmp_path, "L45", device(profile))
    assert len(found) == (words is not None)
    assert all(item["message"].startswith(f"0x2000:00 has {words}") for item in found)


def test_l45_asks_for_one_correction(tmp_path):
    limits = "<Info><MinValue>5</MinValue><MaxValue>4</MaxValue><DefaultValue>5</DefaultValue></Info>"
    (found,) = linted(tmp_path, "L45", device(dictionary(TYPES, declared("#x2000", "UINT", 16, content=limits))))
    assert found["message"] == "0x2000:00 has the minimum 5 above the maximum 4, if UINT is the right type: correct it"


RECORD = (
    TYPES + "<DataType><Name>DT1</Name><BitSize>32</BitSize>"
    "<SubItem><SubIdx>1</SubIdx><Name>A</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>0</BitOffs></SubItem>"
    "<SubItem><SubIdx>2</SubIdx><Name>B</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>16</BitOffs></SubItem>"
    "</DataType>"
)
GIVEN = "<SubItem><Name>{}</Name><Info><DefaultData>{}</DefaultData></Info></SubItem>"


def test_l45_stands_at_the_sub_item(tmp_path):
    infos = "<Info>" + GIVEN.format("A", "0100") + "\n" + GIVEN.format("B", "01") + "</Info>"
    (found,) = linted(tmp_path, "L45", device(dictionary(RECORD, declared("#x2000", "DT1", 32, content=infos))))
    assert (found["line"], found["path"].rpartition("Object/")[2]) == (2, "Info/SubItem[1]")


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ("01000200", None),
        ("010002", "3 bytes for all subindices together, its BitSize is 4: correct it, or give each subindex its own"),
    ],
)
def test_l45_counts_the_data_of_a_whole_object(tmp_path, data, words):
    whole = declared("#x2000", "DT1", 32, content=f"<Info><DefaultData>{data}</DefaultData></Info>")
    found = [item["message"] for item in linted(tmp_path, "L45", device(dictionary(RECORD, whole)))]
    assert found == ([f"object 0x2000 has DefaultData of {words}"] if words else [])


def test_l45_holds_the_data_of_a_whole_object_against_the_limits_of_its_type(tmp_path):
    limited = RECORD.replace("<BitOffs>16</BitOffs>", "<BitOffs>16</BitOffs><MaxValue>1</MaxValue>")
    whole = declared("#x2000", "DT1", 32, content="<Info><DefaultData>01000200</DefaultData></Info>")
    (found,) = linted(tmp_path, "L45", device(dictionary(limited, whole)))
    assert found["message"] == "0x2000:02 has the default 2, more than its maximum 1: correct it"


def test_l46_tells_a_repeated_name_from_an_unknown_one(tmp_path):
    infos = "<Info>" + "".join(GIVEN.format(name, "0100") for name in ("A", "A", "X")) + "</Info>"
    found = linted(tmp_path, "L46", device(dictionary(RECORD, declared("#x2000", "DT1", 32, content=infos))))
    assert [item["message"].partition(";")[0] for item in found] == [
        "object 0x2000: Info sub-items 'A' occur again",
        "object 0x2000: Info sub-items 'X' match no sub-item of the data type",
    ]


def test_l58_tells_a_zero_beside_what_is_missing(tmp_path):
    objects = declared("#x6502", "UDINT", 32, content="<Info><DefaultData>00000000</DefaultData></Info>")
    found = linted(tmp_path, "L58", device(dictionary(TYPES, objects)))
    assert ["without 0x6040" in item["message"] for item in found] == [True, False]
    assert "0x6502 has the default 0" in found[1]["message"]


def test_what_has_no_index_is_not_called_that_of_index_0(tmp_path):
    """An Index that is missing or cannot be read is no 0x0000, in whatever rule finds something about it."""
    objects = (
        "<Object><Name>A</Name><Type>NONE</Type><BitSize>16</BitSize></Object>"
        "<Object><Index>#xZZ</Index><Name>B</Name><Type>UINT</Type><BitSize>8</BitSize>"
        "<Info><DefaultData>000000</DefaultData></Info></Object>"
    )
    entries = (
        "<Entry><Index>#x6000</Index><SubIndex>1</SubIndex><BitLen>32</BitLen><DataType>UINT</DataType></Entry>"
        "<Entry><Index>#x6000</Index><SubIndex>2</SubIndex><DataType>UINT</DataType></Entry>"
        "<Entry><Index>0</Index><SubIndex>1</SubIndex><BitLen>8</BitLen><Name>N</Name></Entry>"
    )
    commands = "<Mailbox><CoE><InitCmd><Transition>PS</Transition></InitCmd></CoE></Mailbox>"
    pdos = f"<Sm>Inputs</Sm><TxPdo Sm='0'><Name>P</Name>{entries}</TxPdo>"
    content = dictionary(TYPES, objects + declared("#x2000", "UINT", 16)) + pdos + commands
    write(tmp_path, {"a.xml": esi(device(content))})
    messages = [item["message"] for item in findings(tmp_path / "a.xml")]
    assert [text for text in messages if "0x0000" in text] == []
    said = {text for text in messages if "without index" in text.lower()}
    for words in (
        "object without index has the type 'NONE'",
        "object without index has BitSize 8",
        "of PDO without index",
        "TxPdo without index maps 0x6000:01",
        "InitCmd without Index",
    ):
        assert any(words in text for text in said), words


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ("010000f0", None),
        ("020000f0", "0x1018:02 has the default 0xF0000002, ProductCode is 0xF0000001: it looks taken over"),
        ("f0000001", "0x1018:02 has the default 0x010000F0, ProductCode is 0xF0000001: its bytes are reversed"),
    ],
)
def test_l13_compares_the_bits_of_an_identity(tmp_path, data, words):
    """DINT and UDINT of the same four bytes are the same product code to a master."""
    sub_items = "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>S{n}</Name><Type>{name}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for n, name, bits, offset in ((0, "USINT", 8, 0), (1, "DINT", 32, 16), (2, "DINT", 32, 48))
    )
    types = f"{TYPES}<DataType><Name>DT1018</Name><BitSize>80</BitSize>{sub_items}</DataType>"
    values = f"<Info><SubItem><Name>S2</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem></Info>"
    types += "<DataType><Name>DINT</Name><BitSize>32</BitSize></DataType>"
    objects = dictionary(types, declared("#x1018", "DT1018", 80, content=values))
    found = linted(tmp_path, "L13", device(objects, product="#xF0000001"))
    assert [item["message"].startswith(words) for item in found] == [True] * bool(words)
