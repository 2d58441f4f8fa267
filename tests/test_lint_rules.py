"""Every rule on files written for it: ``L08.bad.xml`` triggers it where its comments say so, ``L08.good.xml`` is sound.

``<!-- L08 E -->`` stands on the line of a finding, once for each.
"""

import json
import re
from collections import Counter
from pathlib import Path

import pytest
from click.testing import CliRunner
from snippets import device, dictionary, esi, pdo, read, write

from esicatalog.cli.lint import command
from esicatalog.errors import InputError
from esicatalog.export.clocks import chosen_op_mode
from esicatalog.lint.registry import SEVERITY_WORDS
from esicatalog.lint.rules import ALL_RULES
from esicatalog.remarks import remarked

FILES = Path(__file__).parent / "lint"
RULE_IDS = [f"L{number:02}" for number in range(1, 69)]
_EXPECTED = re.compile(r"<!-- (L\d\d) ([EWI]) -->")


def findings(path: Path) -> list[dict]:
    """What the command finds below a path."""
    result = CliRunner().invoke(command, [str(path), "--format", "json"], catch_exceptions=False)
    return json.loads(result.stdout)


def rule_file(rule_id: str, kind: str) -> Path:
    """A document, or a folder for rules that need several."""
    folder = FILES / f"{rule_id}.{kind}"
    return folder if folder.is_dir() else FILES / f"{rule_id}.{kind}.xml"


def expected(path: Path, rule_id: str) -> Counter:
    """File name, line and severity of every finding that the comments announce."""
    documents = sorted(path.rglob("*.xml")) if path.is_dir() else [path]
    return Counter(
        (document.name, number, severity)
        for document in documents
        for number, line in enumerate(document.read_text("utf-8").splitlines(), 1)
        for announced, severity in _EXPECTED.findall(line)
        if announced == rule_id
    )


def test_the_registry_is_complete():
    assert [rule.id for rule in ALL_RULES] == RULE_IDS
    for rule in ALL_RULES:
        assert rule.severity in SEVERITY_WORDS
        assert rule.title.endswith(".")
        assert rule.reference
        assert "\n" not in rule.title + rule.reference


@pytest.mark.parametrize("rule_id", RULE_IDS)
def test_a_rule_finds_the_defect(rule_id):
    path = rule_file(rule_id, "bad")
    found = Counter(
        (Path(item["file"]).name, item["line"], item["severity"]) for item in findings(path) if item["rule"] == rule_id
    )
    assert found == expected(path, rule_id)
    assert found


@pytest.mark.parametrize("rule_id", RULE_IDS)
def test_sound_documents_have_no_findings(rule_id):
    assert findings(rule_file(rule_id, "good")) == []


@pytest.mark.parametrize("rule_id", RULE_IDS)
def test_a_finding_says_what_and_where_in_one_line(rule_id):
    for item in findings(rule_file(rule_id, "bad")):
        assert item["message"]
        assert "\n" not in item["message"]
        assert item["path"] or item["rule"] in ("L01", "L02")


@pytest.mark.parametrize(
    ("type_name", "bits", "data", "words"),
    [
        ("INT", 16, "FF", "1 byte; INT has 2, and the missing ones are read as 0"),
        ("INT", 16, "FFFF0000", "4 bytes; INT has 2, and the first 2 are read"),
        ("REAL", 32, "0000003F00000000", "8 bytes; REAL has 4, and the first 4 are read"),
        ("LREAL", 64, "0000803F", "4 bytes; LREAL has 8, and these are read as a REAL"),
        ("LREAL", 64, "00803F", "3 bytes; LREAL has 8, and no number is read"),
        ("DINT", 16, "FFFFFFFF", "4 bytes; DINT has 2"),  # as many as a DINT has: all are read
        ("STRING(2)", 16, "414243", "3 bytes; STRING(2) has 2"),
    ],
)
def test_what_is_read_of_default_data_of_another_length(tmp_path, type_name, bits, data, words):
    data_type = f"<DataType><Name>{type_name}</Name><BitSize>{bits}</BitSize></DataType>"
    declared = (
        f"<Object><Index>#x2000</Index><Name>O</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<Info><DefaultData>{data}</DefaultData></Info></Object>"
    )
    write(tmp_path, {"a.xml": esi(device(dictionary(data_type, declared)))})
    (found,) = [item for item in findings(tmp_path / "a.xml") if item["rule"] == "L45"]
    assert found["message"].endswith(f"0x2000:00 has DefaultData of {words}: correct it")


@pytest.mark.parametrize(
    ("data", "rule_id", "message"),
    [
        ("", "L60", "ImageFile16x14 'a.bmp' was not found beside the document: ship it, or give ImageData16x14"),
        (
            "424D",
            "L60",
            "ImageFile16x14 'a.bmp' was not found beside the document: ship it, or leave it out beside ImageData16x14",
        ),
        ("424D", "L64", "ImageData16x14 ends within the header of a Windows BMP file: tools show nothing"),
        ("4D42", "L64", "ImageData16x14 is no Windows BMP file (it does not begin with 424D): tools show nothing"),
    ],
)
def test_what_is_said_of_images(tmp_path, data, rule_id, message):
    image = f"<ImageData16x14>{data}</ImageData16x14>" if data else ""
    write(tmp_path, {"a.xml": esi(device(f"<ImageFile16x14>a.bmp</ImageFile16x14>{image}"))})
    assert [item["message"] for item in findings(tmp_path / "a.xml") if item["rule"] == rule_id] == [message]


SYNC_MANAGERS = (
    '<Sm StartAddress="#x1000" ControlByte="#x26" DefaultSize="128" Enable="1">MBoxOut</Sm>'
    '<Sm StartAddress="#x1200" ControlByte="#x22" DefaultSize="128" Enable="1">MBoxIn</Sm>'
    '<Sm StartAddress="#x1400" ControlByte="#x64" Enable="1">Outputs</Sm>'
    '<Sm StartAddress="#x1800" ControlByte="#x20" Enable="1">Inputs</Sm>'
)
TYPES = "".join(
    f"<DataType><Name>{name}</Name><BitSize>{bits}</BitSize></DataType>"
    for name, bits in (("USINT", 8), ("UINT", 16), ("UDINT", 32), ("REAL", 32))
)
INCREMENTS = 'SlotPdoIncrement="16" SlotIndexIncrement="#x800"'


def linted(folder: Path, rule_id: str, devices: str, modules: str = "") -> list[dict]:
    """What one rule finds in a document."""
    write(folder, {"a.xml": esi(devices, modules)})
    return [item for item in findings(folder / "a.xml") if item["rule"] == rule_id]


def declared(index: str, type_name: str, bits: int, attributes: str = "", content: str = "") -> str:
    return (
        f"<Object><Index {attributes}>{index}</Index><Name>O</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"{content}<Flags><Access>rw</Access><PdoMapping>R</PdoMapping></Flags></Object>"
    )


def mapped(index: str, bits: int, attributes: str = "", subindex: int = 0, data_type: str = "") -> str:
    name = f"<DataType>{data_type}</DataType>" if data_type else ""
    return (
        f"<Entry><Index {attributes}>{index}</Index><SubIndex>{subindex}</SubIndex><BitLen>{bits}</BitLen>"
        f"<Name>e</Name>{name}</Entry>"
    )


def module(content: str, ident: str = "#x10", name: str = "m") -> str:
    return f'<Module><Type ModuleIdent="{ident}">M</Type><Name>{name}</Name>{content}</Module>'


def slots(*instances: int, increments: str = INCREMENTS, own: tuple[str, ...] = ()) -> str:
    """Slot elements for so many slots each, all of the module 0x10."""
    elements = "".join(
        f'<Slot MinInstances="0" MaxInstances="{number}" {attributes}><ModuleIdent>#x10</ModuleIdent></Slot>'
        for number, attributes in zip(instances, own or [""] * len(instances), strict=True)
    )
    return f"<Slots {increments}>{elements}</Slots>"


OWN_DICTIONARY = dictionary(TYPES, declared("#x1000", "UDINT", 32))
IN_SLOT = 'DependOnSlot="1"'
WITH_OBJECT = module(dictionary(TYPES, declared("#x6040", "UINT", 16, IN_SLOT)))
WITH_PDO = module(f"<RxPdo><Index {IN_SLOT}>#x1601</Index><Name>p</Name>{mapped('#x7000', 8, IN_SLOT)}</RxPdo>")


@pytest.mark.parametrize(
    ("index", "subindex", "carried", "count"),
    [
        ("#x6040", 0, slots(2), 0),
        ("#x6840", 0, slots(2), 0),
        ("#x6840", 0, slots(1, 1), 0),
        ("#x6840", 1, slots(2), 1),
        ("#x7040", 0, slots(2), 1),  # slot 2, of which there is none
        ("#x6440", 0, slots(2), 1),
        ("#x6840", 0, slots(2, increments=""), 1),
        ("#x6840", 0, slots(2, increments="", own=('SlotIndexIncrement="#x800"',)), 0),
        ("#x6440", 0, slots(1, increments="", own=('SlotGroup="2" SlotGroupIndexIncrement="#x200"',)), 1),
    ],
)
def test_l36_knows_the_objects_that_modules_have_in_slots_above_0(tmp_path, index, subindex, carried, count):
    rx_pdo = f"<RxPdo><Index>#x1600</Index><Name>p</Name>{mapped(index, 16, subindex=subindex)}</RxPdo>"
    found = linted(tmp_path, "L36", device(OWN_DICTIONARY + SYNC_MANAGERS + rx_pdo + carried), WITH_OBJECT)
    assert len(found) == count


def test_l36_says_nothing_of_a_subindex_that_cannot_be_read(tmp_path):
    """What the entry maps is unknown, be it in an object that has no subindex 0."""
    entry = mapped("#x2000", 8, subindex="x1")
    rx_pdo = f"<RxPdo><Index>#x1600</Index><Name>p</Name>{entry}</RxPdo>"
    assert linted(tmp_path, "L36", device(OWN_DICTIONARY + SYNC_MANAGERS + rx_pdo)) == []


def test_l36_knows_the_objects_that_modules_have_in_slot_groups(tmp_path):
    of_group = module(dictionary(TYPES, declared("#x6040", "UINT", 16, 'DependOnSlotGroup="1"')))
    rx_pdo = f"<RxPdo><Index>#x1600</Index><Name>p</Name>{mapped('#x6440', 16)}</RxPdo>"
    carried = slots(1, own=('SlotGroup="2" SlotGroupIndexIncrement="#x200"',))
    assert linted(tmp_path, "L36", device(OWN_DICTIONARY + SYNC_MANAGERS + rx_pdo + carried), of_group) == []


def test_devices_with_equal_pdos_and_other_slots_are_told_apart(tmp_path):
    rx_pdo = f"<RxPdo><Index>#x1600</Index><Name>p</Name>{mapped('#x6840', 16)}</RxPdo>"
    contents = [OWN_DICTIONARY + SYNC_MANAGERS + rx_pdo + carried for carried in (slots(2), slots(1), slots(2))]
    devices = [device(content, revision=f"#x{number}") for number, content in enumerate(contents, 1)]
    (found,) = linted(tmp_path, "L36", "".join(devices), WITH_OBJECT)
    assert "Device[1]" in found["path"]


@pytest.mark.parametrize(("index", "count"), [("#x1601", 0), ("#x1611", 0), ("#x1621", 1), ("#x1612", 1)])
def test_l32_and_l52_know_the_pdos_that_modules_have_in_slots_above_0(tmp_path, index, count):
    excluding = pdo("RxPdo", "#x1700", 8, extra=f"<Exclude>{index}</Exclude>")
    assert len(linted(tmp_path, "L32", device(SYNC_MANAGERS + excluding + slots(2)), WITH_PDO)) == count
    listing = (
        f'<Dc><OpMode><Name>a</Name><AssignActivate>0</AssignActivate><Sm No="2"><Pdo>{index}</Pdo></Sm></OpMode></Dc>'
    )
    assert len(linted(tmp_path, "L52", device(SYNC_MANAGERS + listing + slots(2)), WITH_PDO)) == count


def test_l32_knows_what_other_modules_have_in_slots_above_0(tmp_path):
    excluding = module(pdo("RxPdo", "#x1700", 8, extra="<Exclude>#x1611</Exclude>"), "#x20")
    carried = slots(2).replace("</Slots>", '<Slot MaxInstances="1"><ModuleIdent>#x20</ModuleIdent></Slot></Slots>')
    assert linted(tmp_path, "L32", device(SYNC_MANAGERS + carried), WITH_PDO + excluding) == []


@pytest.mark.parametrize("index", ["#x60FF", "#x68FF"])
def test_an_object_marked_overwritten_by_module_yields_to_the_modules(tmp_path, index):
    placeholder = dictionary(TYPES, declared(index, "UINT", 16, 'OverwrittenByModule="1"'))
    rx_pdo = f"<RxPdo><Index>#x1610</Index><Name>p</Name>{mapped(index, 32)}</RxPdo>"
    of_device = placeholder + SYNC_MANAGERS + rx_pdo
    real = module(dictionary(TYPES, declared("#x60FF", "UDINT", 32, IN_SLOT)))
    assert linted(tmp_path, "L37", device(of_device + slots(2)), real) == []
    assert len(linted(tmp_path, "L37", device(of_device))) == 1


def test_l57_points_at_the_command_that_writes_the_mode(tmp_path):
    commands = "\n".join(
        f"<InitCmd><Transition>PS</Transition><Index {IN_SLOT}>{index}</Index><SubIndex>0</SubIndex>"
        f"<Data>{data}</Data></InitCmd>"
        for index, data in (("#x6081", "00000000"), ("#x6098", "08"), ("#x6060", "08"))
    )
    axis = module(
        f"<RxPdo><Index>#x1600</Index><Name>p</Name>{mapped('#x6040', 16, IN_SLOT)}{mapped('#x60FF', 32, IN_SLOT)}"
        f"</RxPdo><Mailbox><CoE>\n{commands}</CoE></Mailbox><Profile><ProfileNo>402</ProfileNo></Profile>",
        name="csv axis",
    )
    empty = '<Slot MaxInstances="1"><ModuleIdent>#x20</ModuleIdent></Slot>'
    for carried in (slots(1), slots(1).replace("<Slot M", f"{empty}<Slot M")):
        (found,) = linted(tmp_path, "L57", device(SYNC_MANAGERS + carried), axis)
        assert found["path"].endswith("InitCmd[2]")


@pytest.mark.parametrize(
    ("instances", "own", "position"),
    [
        ((1, 1, 1), ("", 'SlotIndexIncrement="#x2000"', ""), 1),
        ((2, 1, 1), ('SlotIndexIncrement="#x2000"', "", ""), 0),
        ((1, 1, 1), ("", "", 'SlotIndexIncrement="#x2000"'), 2),
    ],
)
def test_l55_looks_at_every_slot(tmp_path, instances, own, position):
    mapping = f"<RxPdo><Index {IN_SLOT}>#x1600</Index><Name>p</Name>{mapped('#xF000', 8, IN_SLOT)}</RxPdo>"
    carried = slots(*instances, increments='SlotPdoIncrement="1" SlotIndexIncrement="1"', own=own)
    (found,) = linted(tmp_path, "L55", device(SYNC_MANAGERS + carried), module(mapping))
    assert f"/Slot[{position}]" in found["path"]


@pytest.mark.parametrize(
    ("letters", "words"),
    [
        ("YX", ["Physics 'YX' is not up to four of Y, K, H and blank"]),
        ("yk", ["Physics 'yk' is not up to four of Y, K, H and blank"]),
        ("YYYYY", ["Physics 'YYYYY' is not up to four of Y, K, H and blank"]),
        ("BB", ["Physics 'BB' is not up to four of Y, K, H and blank; B (E-bus cable) is of schemas before 1.6"]),
        ("YK H", []),
    ],
)
def test_l14_letters(tmp_path, letters, words):
    found = linted(tmp_path, "L14", device().replace('Physics="YY"', f'Physics="{letters}"'))
    assert [item["message"] for item in found] == words


MOVE = "move one of them, or correct DefaultSize"


def test_l22_counts_from_the_sync_manager_that_reaches_furthest(tmp_path):
    sync_managers = (
        '<Sm StartAddress="#x1000" ControlByte="#x26" DefaultSize="#x400" Enable="1">MBoxOut</Sm>'
        '<Sm StartAddress="#x1080" ControlByte="#x22" DefaultSize="16" Enable="1">MBoxIn</Sm>'
        '<Sm StartAddress="#x1100" ControlByte="#x64" DefaultSize="4" Enable="1">Outputs</Sm>'
        '<Sm StartAddress="#x1500" ControlByte="#x20" DefaultSize="4" Enable="1">Inputs</Sm>'
    )
    assert [item["message"] for item in linted(tmp_path, "L22", device(sync_managers))] == [
        "SM 0 takes 0x1000 to 0x13FF and SM 1 starts at 0x1080: they overlap by 16 bytes; " + MOVE,
        "SM 0 takes 0x1000 to 0x13FF and SM 2 starts at 0x1100: they overlap by 12 bytes; " + MOVE,
    ]


@pytest.mark.parametrize(("enable", "counts"), [("", 1), ('Enable="9"', 1), ('Enable="8"', 0), ('Enable="0"', 0)])
def test_l22_counts_sync_managers_that_bit_0_of_enable_activates(tmp_path, enable, counts):
    """8 is what the EEPROM says of one that is not activated and of use in OP only; absent says nothing."""
    sync_managers = (
        '<Sm StartAddress="#x1000" ControlByte="#x26" DefaultSize="64" Enable="1">MBoxOut</Sm>'
        f'<Sm StartAddress="#x1020" ControlByte="#x22" DefaultSize="64" {enable}>MBoxIn</Sm>'
    )
    assert len(linted(tmp_path, "L22", device(sync_managers))) == counts


def test_a_sub_item_of_a_wrong_size_is_blamed_alone(tmp_path):
    """BitSize and BitOffs of the last one are swapped; whatever it seems to overlap is sound."""
    places = [("n", "USINT", 8, 0), ("a", "UDINT", 32, 16), ("b", "UDINT", 32, 48), ("c", "UDINT", 80, 32)]
    sub_items = "".join(
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{name}</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for number, (name, type_name, bits, offset) in enumerate(places)
    )
    data_type = f"<DataType><Name>DT</Name><BitSize>112</BitSize>{sub_items}</DataType>"
    write(tmp_path, {"a.xml": esi(device(dictionary(TYPES + data_type, "")))})
    told = [item["message"] for item in findings(tmp_path / "a.xml") if item["rule"] in ("L43", "L44")]
    assert told == ["DataType DT: SubItem 'c' has BitSize 80, its type UDINT 32; correct BitSize or Type"]


def sub_item_of(type_name: str, bits: int) -> str:
    """A data type whose second SubItem is of this type and size."""
    return (
        "<DataType><Name>DT</Name><BitSize>176</BitSize>"
        "<SubItem><SubIdx>0</SubIdx><Name>n</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>"
        f"<SubItem><SubIdx>1</SubIdx><Name>a</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        "<BitOffs>16</BitOffs></SubItem></DataType>"
    )


@pytest.mark.parametrize(
    ("type_name", "declared", "bits", "size"),
    [
        ("BOOL", 8, 8, None),
        ("BOOL", 8, 1, 8),
        ("BOOL", 1, 8, 1),
        ("BOOL", None, 8, 1),  # the base type, where the dictionary does not declare it
        ("STRING(0)", 160, 160, None),
        ("STRING(0)", 0, 160, None),  # of any length
        ("STRING(0)", None, 160, None),
        ("DTENUM", 16, 8, 16),
        ("DTENUM", None, 8, None),
    ],
)
def test_l43_compares_sub_items_with_their_own_dictionary(tmp_path, type_name, declared, bits, size):
    own = "" if declared is None else f"<DataType><Name>{type_name}</Name><BitSize>{declared}</BitSize></DataType>"
    profile = dictionary(TYPES + own + sub_item_of(type_name, bits), "")
    write(tmp_path, {"a.xml": esi(device(profile))})
    told = [item["message"] for item in findings(tmp_path / "a.xml") if item["rule"] in ("L43", "L44")]
    words = f"DataType DT: SubItem 'a' has BitSize {bits}, its type {type_name} {size}; correct BitSize or Type"
    assert told == ([] if size is None else [words])


def test_l43_tells_dictionaries_apart_that_share_a_data_type(tmp_path):
    """The same words for DT, but BOOL is of 1 bit in one dictionary and of 8 in the other."""
    profiles = [
        dictionary(
            f"{TYPES}<DataType><Name>BOOL</Name><BitSize>{bits}</BitSize></DataType>{sub_item_of('BOOL', 8)}", ""
        )
        for bits in (8, 1)
    ]
    found = linted(tmp_path, "L43", device(profiles[0]) + device(profiles[1], product="#x2"))
    (only,) = found
    assert only["path"].startswith("EtherCATInfo/Descriptions/Devices/Device[1]/")


@pytest.mark.parametrize(("declared", "count"), [(0, 0), (160, 0), (80, 1)])
def test_an_object_of_a_type_without_bits_is_of_any_length(tmp_path, declared, count):
    data_type = f"<DataType><Name>STRING(0)</Name><BitSize>{declared}</BitSize></DataType>"
    text = "<Object><Index>#x2000</Index><Name>O</Name><Type>STRING(0)</Type><BitSize>160</BitSize></Object>"
    assert len(linted(tmp_path, "L43", device(dictionary(data_type, text)))) == count


def test_bit_fields_of_an_idn_are_narrower_than_their_type(tmp_path):
    sub_item = "<SubItem><Name>reserved</Name><Type>UINT</Type><BitSize>14</BitSize><BitOffs>2</BitOffs></SubItem>"
    data_type = f"<DataType><Name>DT_IDN</Name><BitSize>16</BitSize>{sub_item}</DataType>"
    assert linted(tmp_path, "L43", device(dictionary(TYPES + data_type, ""))) == []


def test_l44_looks_from_the_sub_item_that_reaches_furthest(tmp_path):
    sub_items = "".join(
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{name}</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for number, (name, type_name, bits, offset) in enumerate(
            [("n", "USINT", 8, 0), ("a", "STRING(20)", 160, 16), ("b", "UINT", 16, 32), ("c", "UINT", 16, 64)]
        )
    )
    data_type = f"<DataType><Name>DT</Name><BitSize>176</BitSize>{sub_items}</DataType>"
    found = linted(tmp_path, "L44", device(dictionary(TYPES + data_type, "")))
    assert [item["message"] for item in found] == [
        "SubItem 'b' of DataType DT starts at bit 32, 'a' ends at 176: correct BitOffs",
        "SubItem 'c' of DataType DT starts at bit 64, 'a' ends at 176: correct BitOffs",
    ]


def test_l44_says_what_to_correct(tmp_path):
    """SubIndex 0 lies at bit 0 of the complete-access image; 8 + 16 + 32 bits do not fit into 48."""
    sub_items = "".join(
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{name}</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for number, (name, type_name, bits, offset) in enumerate([("n", "USINT", 8, 8), ("a", "UDINT", 32, 24)])
    )
    data_type = f"<DataType><Name>DT</Name><BitSize>48</BitSize>{sub_items}</DataType>"
    found = linted(tmp_path, "L44", device(dictionary(TYPES + data_type, "")))
    assert [item["message"] for item in found] == [
        "SubIdx 0 of DataType DT has BitOffs 8: correct it to 0",
        "SubItem 'a' of DataType DT ends at bit 56, behind its BitSize 48: correct BitOffs or one BitSize",
    ]


def test_l35_says_how_to_describe_what_is_filled_up(tmp_path):
    """12 of 16 bits: 4 are left, which a mapping of the device may name as padding or not."""
    found = linted(tmp_path, "L35", device(SYNC_MANAGERS + pdo("RxPdo", "#x1600", 12, attributes='Sm="2"')))
    assert [item["message"] for item in found] == [
        "SM 2: RxPdo 0x1600 of 12 bits; the last byte is filled up: where the device maps the other 4 too, "
        "describe them by a padding entry (Index 0)"
    ]


def test_l52_says_of_names_twice_what_a_choice_by_name_then_does(tmp_path):
    """A choice is refused, what a module asks for is the first one (ESI-FACTS sections 11 and 12)."""
    modes = "".join(
        f"<OpMode><Name>{name}</Name><AssignActivate>#x{word}</AssignActivate></OpMode>"
        for name, word in (("Free", "0"), ("DC", "100"), ("DC", "120"))
    )
    asking = module("<DcOpModeName>DC</DcOpModeName>")
    described = device(f"<Dc>{modes}</Dc>{slots(1)}")
    (found,) = linted(tmp_path, "L52", described, asking)
    assert "a choice by name is ambiguous, and a module's DcOpModeName means that one" in found["message"]
    (held,) = read(esi(described, asking)).document.infos
    with pytest.raises(InputError, match="'DC' exists at positions 1, 2; choose by position"):
        remarked(chosen_op_mode(held.devices[0], (), "DC"))
    assert remarked(chosen_op_mode(held.devices[0], held.modules, None))[0] == 1


@pytest.mark.parametrize(("index", "count"), [("#x1600", 0), ("#x1601", 1)])
def test_l62_leaves_out_pdos_that_op_modes_list(tmp_path, index, count):
    listing = (
        f'<Dc><OpMode><Name>a</Name><AssignActivate>0</AssignActivate><Sm No="2"><Pdo>{index}</Pdo></Sm></OpMode></Dc>'
    )
    mailbox = '<Mailbox><CoE SdoInfo="1" PdoConfig="1"/></Mailbox>'
    assert len(linted(tmp_path, "L62", device(SYNC_MANAGERS + pdo("RxPdo", "#x1600", 8) + mailbox + listing))) == count


@pytest.mark.parametrize(
    ("data_type", "bits", "with_dictionary", "words"),
    [
        ("UINT32", 32, False, "ethercat xml writes with and without sign: give UDINT or DINT, as the object is"),
        ("UINT8", 8, False, "ethercat xml writes with and without sign: give USINT or SINT, as the object is"),
        ("UINT32", 32, True, "is UDINT in ESI"),
        ("INT32", 32, False, "is DINT in ESI"),
        ("uint32", 32, False, "is UDINT in ESI"),
    ],
)
def test_l48_knows_that_the_type_of_a_scan_tells_no_sign(tmp_path, data_type, bits, with_dictionary, words):
    """The IgH tool makes the name from the length of an entry: 0x607A, a DINT, comes out as UINT32."""
    own = OWN_DICTIONARY if with_dictionary else ""
    mapping = f"<RxPdo><Index>#x1600</Index><Name>p</Name>{mapped('#x607A', bits, data_type=data_type)}</RxPdo>"
    (found,) = linted(tmp_path, "L48", device(own + mapping))
    assert found["message"] == f"entry 1 of PDO 0x1600 has the DataType {data_type}, which {words}"


def test_l48_leaves_out_padding(tmp_path):
    entries = mapped("0", 8, data_type="PADDING") + mapped("#x7000", 8, data_type="BYTES8")
    rx_pdo = f"<RxPdo><Index>#x1600</Index><Name>p</Name>{entries}</RxPdo>"
    (found,) = linted(tmp_path, "L48", device(SYNC_MANAGERS + rx_pdo))
    assert "BYTES8" in found["message"]


@pytest.mark.parametrize("objects", [declared("#x2000", "USINT", 8), ""])
def test_l48_leaves_out_types_that_the_owner_declares(tmp_path, objects):
    rx_pdo = f"<RxPdo><Index>#x1600</Index><Name>p</Name>{mapped('#x2000', 8, data_type='MYENUM')}</RxPdo>"
    own_type = "<DataType><Name>MYENUM</Name><BaseType>USINT</BaseType><BitSize>8</BitSize></DataType>"
    with_type, without = (dictionary(TYPES + added, objects) for added in (own_type, ""))
    assert linted(tmp_path, "L48", device(with_type + SYNC_MANAGERS + rx_pdo)) == []
    assert linted(tmp_path, "L48", device(SYNC_MANAGERS), module(with_type + rx_pdo)) == []
    assert len(linted(tmp_path, "L48", device(without + SYNC_MANAGERS + rx_pdo), module(with_type))) == 1
    both = device(with_type + SYNC_MANAGERS + rx_pdo) + device(SYNC_MANAGERS + rx_pdo, revision="#x2")
    (found,) = linted(tmp_path, "L48", both)
    assert "Device[1]" in found["path"]


@pytest.mark.parametrize(
    ("type_name", "text", "words"),
    [
        ("REAL", "10", "read as a number"),
        ("REAL", "1.5", "read as a number"),
        ("REAL", "ten", "no number"),
        ("UDINT", "10", "read as a number"),
        ("UDINT", "1.5", "no number"),
    ],
)
def test_l47_tells_whether_a_text_was_read_as_a_number(tmp_path, type_name, text, words):
    content = f"<Info><DefaultString>{text}</DefaultString></Info>"
    objects = declared("#x2000", type_name, 32, content=content)
    (found,) = linted(tmp_path, "L47", device(dictionary(TYPES, objects)))
    assert f"{text!r}, {words})" in found["message"]


@pytest.mark.parametrize(
    ("rule_id", "attributes", "count"),
    [
        ("L03", 'Sm="2" Fixed="True" Mandatory="TRUE"', 2),
        ("L03", 'Sm="2" Fixed="true" Mandatory="1"', 0),
        ("L06", 'Sm="5000000000"', 1),
        ("L06", 'Sm="2"', 0),
    ],
)
def test_attributes_that_are_read_though_the_schema_forbids_them(tmp_path, rule_id, attributes, count):
    rx_pdo = pdo("RxPdo", "#x1600", 8, attributes=attributes)
    assert len(linted(tmp_path, rule_id, device(SYNC_MANAGERS + rx_pdo))) == count
