"""Rules about devices with modules: which of them is to blame; and values of no fixed length."""

from pathlib import Path

import pytest
from snippets import device, dictionary, esi, write
from test_lint_rules import IN_SLOT, SYNC_MANAGERS, TYPES, declared, findings, linted, mapped, module, slots

CONTROL = mapped("#x6040", 16, IN_SLOT) + mapped("#x607A", 32, IN_SLOT)


def drive_objects(default: str, attributes: str = IN_SLOT, above: int = 0) -> str:
    """The mandatory objects of an axis."""
    value = f"<Info><DefaultData>{default}</DefaultData></Info>"
    return "".join(
        declared(f"#x{index + above:04X}", name, bits, attributes, value if index == 0x6502 else "")
        for index, name, bits in (
            (0x6040, "UINT", 16),
            (0x6041, "UINT", 16),
            (0x6060, "USINT", 8),
            (0x607A, "UDINT", 32),
            (0x6502, "UDINT", 32),
        )
    )


def drive_module(default: str, ident: str = "#x10") -> str:
    mapping = f"<RxPdo><Index {IN_SLOT}>#x1600</Index><Name>p</Name>{CONTROL}</RxPdo>"
    return module(mapping + dictionary(TYPES, drive_objects(default)), ident)


def blamed(found: list[dict]) -> list[tuple[str, str]]:
    """The Device or Module that a finding points into, and its message up to the colon."""
    return [(item["path"].split("/")[3], item["message"].split(":")[0]) for item in found]


BIG_ENDIAN = "0x6502 has the default 00000180, which looks byte-swapped"


def test_l58_blames_the_alternative_that_is_wrong(tmp_path):
    """Bits 7 and 8 of 0x6502 are HM and CSP; 00000180 is the same with the highest byte first."""
    carried = slots(1).replace("</Slot>", "<ModuleIdent>#x20</ModuleIdent></Slot>")
    modules = drive_module("80010000") + drive_module("00000180", "#x20")
    assert blamed(linted(tmp_path, "L58", device(SYNC_MANAGERS + carried), modules)) == [("Module[1]", BIG_ENDIAN)]


def test_l58_tells_a_module_once_by_the_index_that_stands_there(tmp_path):
    two = slots(2).replace('MinInstances="0"', 'MinInstances="2"')
    found = linted(tmp_path, "L58", device(SYNC_MANAGERS + two), drive_module("00000180"))
    assert blamed(found) == [("Module", BIG_ENDIAN)]
    assert found[0]["path"].endswith("/Objects/Object[4]")


def test_l58_sees_the_module_of_the_second_slot(tmp_path):
    carried = slots(1, 1).replace("#x10</ModuleIdent></Slot></Slots>", "#x20</ModuleIdent></Slot></Slots>")
    modules = drive_module("80000000") + drive_module("00000000", "#x20")
    found = linted(tmp_path, "L58", device(SYNC_MANAGERS + carried), modules)
    assert blamed(found) == [("Module[1]", "0x6502 has the default 0")]


def test_l58_sees_every_axis_of_a_device(tmp_path):
    objects = drive_objects("80000000", "") + drive_objects("00000000", "", 0x800)
    found = linted(tmp_path, "L58", device(dictionary(TYPES, objects) + SYNC_MANAGERS))
    assert blamed(found) == [("Device", "0x6D02 has the default 0")]


def test_l58_takes_what_modules_overwrite_for_a_stand_in(tmp_path):
    of_device = dictionary(TYPES, drive_objects("00000000", 'OverwrittenByModule="1"'))
    found = linted(tmp_path, "L58", device(of_device + SYNC_MANAGERS + slots(1)), drive_module("80000000"))
    assert found == []


def test_l57_blames_a_module_whose_name_is_against_the_command_of_the_device(tmp_path):
    """The module has the setpoint of CSV, code 9, and is named after CSP."""
    setpoint = "<RxPdo><Index>#x1600</Index><Name>p</Name>" + mapped("#x6040", 16) + mapped("#x60FF", 32) + "</RxPdo>"
    command = "<Transition>PS</Transition><Index>#x6060</Index><SubIndex>0</SubIndex><Data>09</Data>"
    content = device(f"{SYNC_MANAGERS}<Mailbox><CoE><InitCmd>{command}</InitCmd></CoE></Mailbox>{slots(1)}")
    named = module(setpoint, name="Axis csp")
    assert [path for path, _ in blamed(linted(tmp_path, "L57", content, named))] == ["Module"]


@pytest.mark.parametrize(("own", "count"), [("#x6810", 1), ("#x6010", 0), ("#x6820", 0)])
def test_l55_sees_objects_that_move_to_one_of_the_device(tmp_path, own, count):
    """In slot 1 the object 0x6010 lies at 0x6810; one that stays where it is repeats that of the device."""
    two = slots(2).replace('MinInstances="0"', 'MinInstances="2"')
    two = two.replace("<ModuleIdent>", '<ModuleIdent Default="1">')
    moving = module(dictionary(TYPES, declared("#x6010", "UINT", 16, IN_SLOT)))
    of_device = dictionary(TYPES, declared(own, "UINT", 16))
    found = linted(tmp_path, "L55", device(of_device + SYNC_MANAGERS + two), moving)
    assert len(found) == count
    for item in found:
        assert item["message"].startswith("object 0x6810 of the default module in slot 1 meets that of the device")


def test_l53_is_no_error_where_a_document_of_modules_is_missing(tmp_path):
    """The module may be in it; one that was recovered may have lost it."""
    text = esi(device(SYNC_MANAGERS + slots(1)))
    write(tmp_path, {"a.xml": text})
    assert [item["severity"] for item in findings(tmp_path) if item["rule"] == "L53"] == ["E"]
    reference = "<InfoReference>modules.xml</InfoReference>"
    write(tmp_path, {"a.xml": text.replace("<Vendor>", f"{reference}<Vendor>", 1)})
    whole = f"<EtherCATModule><Modules>{module('', ident='#x11')}</Modules></EtherCATModule>"
    for content in (None, "", "<EtherCATConfig/>", whole.replace("</Modules>", "")):
        if content is not None:
            write(tmp_path, {"modules.xml": content})
        (found,) = [item for item in findings(tmp_path) if item["rule"] == "L53"]
        assert found["severity"] == "W"
        assert found["message"].endswith("which no module at hand has, but 'modules.xml' is missing or broken")
    write(tmp_path, {"modules.xml": whole})
    assert [item["severity"] for item in findings(tmp_path) if item["rule"] == "L53"] == ["E"]


@pytest.mark.parametrize(
    ("name", "bits", "data", "count"),
    [
        ("STRING(0)", 0, "414243", 0),
        ("DOMAIN", 0, "414243", 0),
        ("STRING(2)", 16, "41", 0),
        ("STRING(2)", 16, "414243", 1),
        ("UINT", 16, "01", 1),
    ],
)
def test_types_of_no_bits_are_of_any_length(tmp_path, name, bits, data, count):
    data_type = f"<DataType><Name>{name}</Name><BitSize>{bits}</BitSize></DataType>"
    value = f"<Info><DefaultData>{data}</DefaultData></Info>"
    content = dictionary(data_type, declared("#x2000", name, bits, content=value)) + SYNC_MANAGERS
    command = (
        f"<InitCmd><Transition>PS</Transition><Index>#x2000</Index><SubIndex>0</SubIndex><Data>{data}</Data></InitCmd>"
    )
    content += f"<Mailbox><CoE>{command}</CoE></Mailbox>"
    assert len(linted(tmp_path, "L45", device(content))) == count
    assert len(linted(tmp_path, "L56", device(content))) == count


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("<Data>01</Data>", "has no Transition, so it is never sent: give one"),
        (
            "<Transition>XX</Transition><Data>01</Data>",
            "has the Transition 'XX', which is none of IP, PS, SO, SP, OP, OS",
        ),
        ("<Transition>PS</Transition><Data></Data>", "has no Data, so it is never sent: give them"),
        ("<Transition>PS</Transition>", "has no Data, so it is never sent: give them"),
    ],
)
def test_l56_tells_commands_that_are_never_sent(tmp_path, content, problem):
    """Without a dictionary, too."""
    command = f"<InitCmd><Index>#x2000</Index><SubIndex>0</SubIndex>{content}</InitCmd>"
    (found,) = linted(tmp_path, "L56", device(SYNC_MANAGERS + f"<Mailbox><CoE>{command}</CoE></Mailbox>"))
    assert found["message"] == f"InitCmd for 0x2000:00 {problem}"


@pytest.mark.parametrize(("index", "said"), [("", ["InitCmd without Index is never sent: give it"]), ("x", [])])
def test_l56_tells_a_command_without_index(tmp_path, index, said):
    """Not one whose Index cannot be read, of which the reader tells."""
    given = f"<Index>{index}</Index>" if index else ""
    command = f"<InitCmd><Transition>PS</Transition>{given}<SubIndex>1</SubIndex><Data>01</Data></InitCmd>"
    found = linted(tmp_path, "L56", device(SYNC_MANAGERS + f"<Mailbox><CoE>{command}</CoE></Mailbox>"))
    assert [item["message"] for item in found] == said


def test_l44_looks_for_subindex_0_at_every_position(tmp_path):
    sub_items = "".join(
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{name}</Name><Type>USINT</Type><BitSize>8</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for number, name, offset in ((1, "a", 16), (0, "n", 8))
    )
    data_type = f"<DataType><Name>DT</Name><BitSize>24</BitSize>{sub_items}</DataType>"
    (found,) = linted(tmp_path, "L44", device(dictionary(TYPES + data_type, "")))
    assert found["message"] == "SubIdx 0 of DataType DT has BitOffs 8: correct it to 0"


def drive(profiles: str, dictionary_file: bool = False, **parts: str) -> str:
    """A device with RxPdo 0x1600 that maps 0x6040, CoE with a command for 0x6060, and these profiles."""
    profiles += "<Profile><ProfileNo>402</ProfileNo><DictionaryFile>d.xml</DictionaryFile></Profile>" * dictionary_file
    mapping = f'<RxPdo Sm="2"><Index>#x1600</Index><Name>p</Name>{mapped("#x6040", 16, data_type="MYTYPE")}</RxPdo>'
    command = "<InitCmd><Transition>PS</Transition><Index>#x6060</Index><SubIndex>0</SubIndex><Data>08</Data></InitCmd>"
    mailbox = parts.get("mailbox", f"<Mailbox><CoE>{command}</CoE></Mailbox>")
    return device(profiles + SYNC_MANAGERS + mapping + mailbox + parts.get("rest", ""))


OBJECT_0X1000 = dictionary(TYPES, declared("#x1000", "UDINT", 32))


@pytest.mark.parametrize("rule_id", ["L36", "L48", "L56", "L58"])
def test_what_a_missing_dictionary_may_have_is_not_missed(tmp_path, rule_id):
    """0x6040, 0x6060 and MYTYPE may be described there; L60 tells that it is missing."""
    assert len(linted(tmp_path, rule_id, drive(OBJECT_0X1000))) == 1
    assert linted(tmp_path, rule_id, drive(OBJECT_0X1000, dictionary_file=True)) == []
    assert len(linted(tmp_path, "L60", drive(OBJECT_0X1000, dictionary_file=True))) == 1


def test_a_dictionary_that_is_there_is_complete(tmp_path):
    there = f"<EtherCATDict>{OBJECT_0X1000[OBJECT_0X1000.index('<Dictionary>') : -len('</Profile>')]}</EtherCATDict>"
    write(tmp_path, {"d.xml": there})
    assert len(linted(tmp_path, "L36", drive("", dictionary_file=True))) == 1


@pytest.mark.parametrize("rule_id", ["L36", "L48", "L56", "L58"])
def test_what_a_broken_dictionary_may_have_is_not_missed(tmp_path, rule_id):
    """Recovery may have lost it: what follows the objects stays open. A wrong encoding loses no element."""
    content = OBJECT_0X1000[OBJECT_0X1000.index("<Dictionary>") : -len("</Profile>")]
    whole = f"<EtherCATDict>{content}</EtherCATDict>"
    mended = b'<?xml version="1.0" encoding="utf-8"?>' + whole.replace("<Name>O<", "<Name>\xb5<").encode("latin-1")
    of_devices = drive("", dictionary_file=True)
    for dictionary_file, count in ((whole.encode(), 1), (mended, 1), (whole.replace("</Objects>", "").encode(), 0)):
        (tmp_path / "d.xml").write_bytes(dictionary_file)
        assert len(linted(tmp_path, rule_id, of_devices)) == count, dictionary_file


def test_what_a_broken_dictionary_of_referenced_modules_may_have_is_not_missed(tmp_path):
    """0x6040, which the device maps, may have been described there."""
    assigned = f'<RxPdo Sm="2"><Index>#x1600</Index><Name>p</Name>{mapped("#x6040", 16)}</RxPdo>'
    text = esi(device(OBJECT_0X1000 + SYNC_MANAGERS + assigned + slots(1)))
    text = text.replace("<Vendor>", "<InfoReference>sub\\modules.xml</InfoReference><Vendor>", 1)
    described = module("<Profile><DictionaryFile>d.xml</DictionaryFile></Profile>")
    modules = f"<EtherCATModule><Modules>{described}</Modules></EtherCATModule>"
    whole = f"<EtherCATDict>{OBJECT_0X1000[OBJECT_0X1000.index('<Dictionary>') : -len('</Profile>')]}</EtherCATDict>"
    (tmp_path / "sub").mkdir()
    for content, count in ((whole, 1), (whole.replace("</Objects>", ""), 0)):
        write(tmp_path, {"a.xml": text, "sub/modules.xml": modules, "sub/d.xml": content})
        found = [item for item in findings(tmp_path) if item["rule"] == "L36" and item["file"].endswith("a.xml")]
        assert len(found) == count


@pytest.mark.parametrize(
    ("rule_id", "content"),
    [
        ("L32", '<RxPdo Sm="2"><Index>#x1601</Index><Name>p</Name><Exclude>#x1602</Exclude></RxPdo>'),
        ("L52", "<Dc><OpMode><Name>S</Name><AssignActivate>0</AssignActivate>"
                '<Sm No="2"><Pdo>#x1602</Pdo></Sm></OpMode></Dc>'),
        ("L36", OBJECT_0X1000),
        ("L56", OBJECT_0X1000 + '<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>#x1000</Index>'
                '<SubIndex>1</SubIndex><Data>01</Data></InitCmd></CoE></Mailbox>'),
        ("L58", OBJECT_0X1000),
    ],
)  # fmt: skip
def test_what_a_broken_document_may_have_lost_is_not_missed(tmp_path, rule_id, content):
    """Its own objects, PDOs and modules; the linter has met the same in a document that is whole."""
    assigned = f'<RxPdo Sm="2"><Index>#x1600</Index><Name>p</Name>{mapped("#x6040", 16)}</RxPdo>'
    text = esi(device(content + SYNC_MANAGERS + assigned))
    write(tmp_path, {"a.xml": text, "b.xml": text.replace("</Devices>", "")})
    assert [Path(item["file"]).name for item in findings(tmp_path) if item["rule"] == rule_id] == ["a.xml"]
    assert [Path(item["file"]).name for item in findings(tmp_path) if item["rule"] == "L01"] == ["b.xml"]


def test_l53_is_no_error_in_a_broken_document(tmp_path):
    write(tmp_path, {"a.xml": esi(device(SYNC_MANAGERS + slots(1))).replace("</Devices>", "")})
    (found,) = [item for item in findings(tmp_path) if item["rule"] == "L53"]
    assert found["severity"] == "W"
    assert found["message"].endswith("which no module at hand has, but this document is broken")


def test_l61_knows_a_dictionary_that_is_missing(tmp_path):
    """It tells the objects; without such a name nothing does."""
    bare = "<Mailbox><CoE/></Mailbox>"
    assert len(linted(tmp_path, "L61", drive("", mailbox=bare))) == 1
    assert linted(tmp_path, "L61", drive("", dictionary_file=True, mailbox=bare)) == []


def test_l67_knows_that_a_missing_dictionary_may_say_cia_402(tmp_path):
    """A sensor's 0x6502 is no word of drive modes; its bits are printed as the bus carries them."""
    types = TYPES + "<DataType><Name>DINT</Name><BitSize>32</BitSize></DataType>"
    value = "<Info><DefaultData>FFFFFFFF</DefaultData></Info>"
    sensor = dictionary(types, declared("#x6502", "DINT", 32, content=value)).replace(">402<", ">406<")
    (found,) = linted(tmp_path, "L67", device(sensor))
    assert found["message"].startswith("0x6502 has the default 0xFFFFFFFF, but")
    missing = "<Profile><DictionaryFile>d.xml</DictionaryFile></Profile>"
    assert linted(tmp_path, "L67", device(sensor + missing)) == []


@pytest.mark.parametrize(
    ("rule_id", "content"),
    [
        ("L32", '<RxPdo Sm="2"><Index>#x1601</Index><Name>p</Name><Exclude>#x1602</Exclude></RxPdo>'),
        ("L52", "<Dc><OpMode><Name>S</Name><AssignActivate>0</AssignActivate>"
                '<Sm No="2"><Pdo>#x1602</Pdo></Sm></OpMode></Dc>'),
        ("L36", OBJECT_0X1000),
        ("L58", OBJECT_0X1000),
        ("L61", "<Mailbox><CoE/></Mailbox>"),
    ],
)  # fmt: skip
def test_what_missing_modules_may_have_is_not_missed(tmp_path, rule_id, content):
    """The same linter has met the same PDOs and OpModes before, with all modules and without slots."""
    assigned = f'<RxPdo Sm="2"><Index>#x1600</Index><Name>p</Name>{mapped("#x6040", 16)}</RxPdo>'
    text = esi(device(content + SYNC_MANAGERS + assigned + slots(1)))
    missing = text.replace("<Vendor>", "<InfoReference>modules.xml</InfoReference><Vendor>", 1)
    write(tmp_path, {"a.xml": text, "b.xml": missing, "c.xml": missing.replace(slots(1), "")})
    for name in ("other.xml", "modules.xml"):
        write(tmp_path, {name: "<EtherCATModule><Modules>"})
        told = [Path(item["file"]).name for item in findings(tmp_path) if item["rule"] == rule_id]
        assert told == ["a.xml", "c.xml"]


def test_l53_tells_an_unknown_preset_of_missing_modules_once(tmp_path):
    text = esi(device(SYNC_MANAGERS + slots(1).replace("<Slot ", '<Slot Default="#x10" ')))
    assert len([item for item in findings(write(tmp_path, {"a.xml": text})) if item["rule"] == "L53"]) == 2
    write(tmp_path, {"a.xml": text.replace("<Vendor>", "<InfoReference>modules.xml</InfoReference><Vendor>", 1)})
    assert len([item for item in findings(tmp_path) if item["rule"] == "L53"]) == 1


@pytest.mark.parametrize(
    ("carried", "count"),
    [
        ("<ModuleIdent>#x10</ModuleIdent>", 1),
        ("<ModuleClass><Class>C</Class></ModuleClass>", 0),
        ("<ModuleIdent>#x11</ModuleIdent><ModuleClass><Class>C</Class></ModuleClass>", 0),
    ],
)
def test_l54_looks_at_modules_with_a_class_where_slots_go_by_ident(tmp_path, carried, count):
    """What the slot names by 0x10 is one of two modules."""
    of_class = module("").replace("<Type ", '<Type ModuleClass="C" ')
    by_slot = slots(1).replace("<ModuleIdent>#x10</ModuleIdent>", carried)
    found = linted(tmp_path, "L54", device(SYNC_MANAGERS + by_slot), of_class * 2)
    assert len(found) == count


def referring(folder: Path, of_device: str, *modules: str) -> dict[str, list[dict]]:
    """What is found in a device whose modules lie in another document, and in that document."""
    text = esi(device(of_device + SYNC_MANAGERS + slots(1)))
    text = text.replace("<Vendor>", "\n<InfoReference>modules.xml</InfoReference><Vendor>", 1)
    offered = f"<EtherCATModule><Vendor><Id>#x1</Id></Vendor><Modules>{''.join(modules)}</Modules></EtherCATModule>"
    write(folder, {"a.xml": text, "modules.xml": offered})
    found: dict[str, list[dict]] = {"a.xml": [], "modules.xml": []}
    for item in findings(folder):
        found[Path(item["file"]).name].append(item)
    return found


def test_a_module_of_another_document_is_held_against_its_device(tmp_path):
    """Its PDO is for a SyncManager that the device does not have; that document alone cannot know."""
    content = module(f'<RxPdo Sm="9"><Index>#x1601</Index><Name>p</Name>{mapped("#x7000", 8)}</RxPdo>')
    found = referring(tmp_path, "", content, content.replace('"#x10"', '"#x11"'))
    (told,) = [item for item in found["a.xml"] if item["rule"] == "L27"]
    assert told["message"].startswith(
        "module 0x10 of another document: RxPdo 0x1601 is assigned to SM 9 of 'T1', which has 4"
    )
    assert (told["line"], told["path"]) == (2, "EtherCATInfo/InfoReference")
    assert [item for item in found["modules.xml"] if item["rule"] == "L27"] == []


@pytest.mark.parametrize(
    ("of_device", "told"),
    [
        ("", ["L32", "L56"]),
        ('<RxPdo><Index>#x1602</Index><Name>p</Name></RxPdo>' + dictionary(TYPES, declared("#x2000", "UINT", 16)), []),
    ],
)  # fmt: skip
def test_what_the_device_of_a_module_has_is_not_missed_in_another_document(tmp_path, of_device, told):
    """The module excludes a PDO and writes an object that may be those of its device: only with that is it known."""
    command = (
        "<InitCmd><Transition>PS</Transition><Index>#x2000</Index><SubIndex>0</SubIndex><Data>0100</Data></InitCmd>"
    )
    content = "<RxPdo><Index>#x1601</Index><Name>p</Name><Exclude>#x1602</Exclude></RxPdo>"
    content += f"<Mailbox><CoE>{command}</CoE></Mailbox>" + dictionary(TYPES, declared("#x6000", "UINT", 16))
    found = referring(tmp_path, of_device, module(content))
    rules = {name: [item["rule"] for item in items if item["rule"] in ("L32", "L56")] for name, items in found.items()}
    assert rules == {"a.xml": told, "modules.xml": []}


def test_what_is_wrong_with_a_module_of_another_document_is_told_there_alone(tmp_path):
    found = referring(
        tmp_path, "", module('<RxPdo Sm="2"><Index>#x1601</Index><Name>p</Name><Entry><Index>0</Index></Entry></RxPdo>')
    )
    assert {name: sum(item["rule"] == "L33" for item in items) for name, items in found.items()} == {
        "a.xml": 0,
        "modules.xml": 1,
    }
