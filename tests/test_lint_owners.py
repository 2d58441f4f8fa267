"""Rules about devices with modules: which of them is to blame; and values of no fixed length."""

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


BIG_ENDIAN = "0x6502 has the default 00000180, which looks big-endian"


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
    """The module may be in it."""
    text = esi(device(SYNC_MANAGERS + slots(1)))
    write(tmp_path, {"a.xml": text})
    assert [item["severity"] for item in findings(tmp_path) if item["rule"] == "L53"] == ["E"]
    reference = "<InfoReference>modules.xml</InfoReference>"
    write(tmp_path, {"a.xml": text.replace("<Vendor>", f"{reference}<Vendor>", 1)})
    (found,) = [item for item in findings(tmp_path) if item["rule"] == "L53"]
    assert found["severity"] == "W"
    assert found["message"].endswith("which no module at hand has, but 'modules.xml' is missing")


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


def test_l44_looks_for_subindex_0_at_every_position(tmp_path):
    sub_items = "".join(
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{name}</Name><Type>USINT</Type><BitSize>8</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for number, name, offset in ((1, "a", 16), (0, "n", 8))
    )
    data_type = f"<DataType><Name>DT</Name><BitSize>24</BitSize>{sub_items}</DataType>"
    (found,) = linted(tmp_path, "L44", device(dictionary(TYPES + data_type, "")))
    assert found["message"] == "SubIdx 0 of DataType DT has BitOffs 8: correct it to 0"
