"""What every export says of a configuration that the device may not have: start-up commands, defaults, slots, sizes."""

import re

import pytest
from snippets import device, dictionary, esi, pdo, read
from test_export_configuration import COE, SMS, configured, dc, entry, init_cmd, pdos, rx, subject, times

from esicatalog.errors import InputError
from esicatalog.export.choice import Choice, parse_pdo_choice
from esicatalog.export.configuration import configure
from esicatalog.export.igh import igh_header
from esicatalog.export.igh_files import listed
from esicatalog.export.linuxcnc import linuxcnc_configuration
from esicatalog.export.pysoem import pysoem_module
from esicatalog.export.ros2 import ros2_slave
from esicatalog.export.soem import soem_header
from esicatalog.export.soem_startup import hook_commands
from esicatalog.export.subject import Subject, subjects_of_document
from esicatalog.identity import ModuleChoice

EXPORTS = (igh_header, soem_header, pysoem_module, ros2_slave, linuxcnc_configuration)
AXIS = (
    rx("#x1600", entry("#x6040", 16, "Control word"), entry("#x607A", 32, "Target position"))
    + rx("#x1601", entry("#x6040", 16, "Control word"), entry("#x60FF", 32, "Target velocity"), attributes="")
    + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"')
)


def command(index: str, subindex: int, data: str, extra: str = "") -> str:
    return init_cmd("PS", index, data, extra).replace("<SubIndex>1<", f"<SubIndex>{subindex}<")


def drive(*commands: str, coe: str = "") -> str:
    """A drive with start-up commands that takes target positions by default, and can take velocities."""
    return f"{SMS}{AXIS}<Mailbox><CoE {coe}>{''.join(commands)}</CoE></Mailbox>"


def contradictions(content: str, **choice) -> list[str]:
    """What start-up commands write and this configuration does not."""
    words = "the start-up commands write another PDO configuration: "
    found = [remark for remark in configured(content, **choice).remarks if remark.startswith(words)]
    return [item for remark in found for item in remark.removeprefix(words).split("; ")[:-1]]


VELOCITY_ASSIGNED = (command("#x1C12", 0, "00"), command("#x1C12", 1, "0116"), command("#x1C12", 0, "01"))
"""0x1601, little endian."""
VELOCITY_MAPPED = (
    command("#x1600", 0, "00"),
    command("#x1600", 1, "10004060"),
    command("#x1600", 2, "2000FF60"),
    command("#x1600", 0, "02"),
)
AT_ONCE = 'CompleteAccess="1"'


@pytest.mark.parametrize("coe", ["", 'PdoAssign="1"', 'PdoAssign="1" PdoConfig="1"'])
@pytest.mark.parametrize(
    ("commands", "words"),
    [
        (VELOCITY_ASSIGNED, "0x1601 to 0x1C12:01, where this file configures 0x1600"),
        ((command("#x1C12", 0, "01000116", AT_ONCE),), "0x1601 to 0x1C12:01, where this file configures 0x1600"),
        ((command("#x1C12", 1, "00160116", AT_ONCE),), "0x1601 to 0x1C12:02, where this file configures nothing"),
        (VELOCITY_MAPPED, "0x60FF:00 (32 bit) to 0x1600:02, where this file configures 0x607A:00 (32 bit)"),
        (
            (command("#x1600", 0, "0200100040602000FF60", AT_ONCE),),
            "0x60FF:00 (32 bit) to 0x1600:02, where this file configures 0x607A:00 (32 bit)",
        ),
        (
            (command("#x1600", 0, "01"), command("#x1600", 1, "10004060")),
            "1 to 0x1600:00, where this file configures 2",
        ),
    ],
)
def test_commands_that_contradict_the_configuration_are_told_and_not_sent(commands, words, coe):
    content = drive(*commands, coe=coe)
    assert contradictions(content) == [words]
    found = configured(content)
    for export in EXPORTS:
        assert words in " ".join(export(found).replace("*", " ").replace("#", " ").split()), export
    assert not set(hook_commands(found)) & set(found.commands)


@pytest.mark.parametrize(
    "commands",
    [
        (command("#x1C12", 0, "00"), command("#x1C12", 1, "0016"), command("#x1C12", 0, "01")),
        (command("#x1C12", 1, "0016"), command("#x1C12", 2, "0116"), command("#x1C12", 0, "01")),
        (command("#x1600", 0, "0200100040602000" + "7A60", AT_ONCE),),
        (command("#x1601", 1, "20007A60"),),
        (init_cmd("SP", "#x1C12", "0116"),),
    ],
)
def test_commands_that_agree_write_other_pdos_or_lead_back_contradict_nothing(commands):
    assert contradictions(drive(*commands)) == []


CLEARED = (command("#x1C12", 0, "00"), command("#x1C13", 0, "0000", AT_ONCE), command("#x1600", 0, "00"))
CLEARED_ASSIGNMENTS = [f"0 to 0x{index}:00, where this file configures 1" for index in ("1C12", "1C13")]
CLEARED_MAPPING = ["0 to 0x1600:00, where this file configures 2"]


@pytest.mark.parametrize(
    ("coe", "fixed", "words"),
    [
        ("", "", [CLEARED_ASSIGNMENTS[0], *CLEARED_MAPPING, CLEARED_ASSIGNMENTS[1]]),
        ('PdoAssign="1"', "", CLEARED_MAPPING),
        ('PdoConfig="1"', "", CLEARED_ASSIGNMENTS),
        ('PdoAssign="1" PdoConfig="1"', "", []),
        ('PdoAssign="1" PdoConfig="1"', 'Fixed="1"', CLEARED_MAPPING),
    ],
)
def test_what_is_cleared_only_is_for_the_master_to_fill(coe, fixed, words):
    """SM2 has 0x1600 with two entries, SM3 has 0x1A00. Without the declaration nobody may fill what is empty then."""
    content = drive(*CLEARED, coe=coe).replace("<RxPdo ", f"<RxPdo {fixed} ")
    assert contradictions(content) == words
    found = configured(content)
    assert sum("another PDO configuration" in remark for remark in found.remarks) == bool(words)
    for export in (ros2_slave, linuxcnc_configuration):
        assert ("0x1600:00 is left out" in " ".join(export(found).split())) is (CLEARED_MAPPING[0] not in words)


def test_commands_and_a_choice_may_agree():
    content = drive(*VELOCITY_ASSIGNED)
    assert contradictions(content, pdos=parse_pdo_choice("0x1601")) == []
    assert soem_header(configured(content, pdos=parse_pdo_choice("0x1601"))).count("0x1c12, 0x01") == 1
    assert soem_header(configured(content)).count("0x1c12, 0x01") == 0


def test_of_a_gap_only_the_length_counts():
    gap = rx("#x1600", entry("#x0", 8), entry("#x7000", 8, "value", 1))
    mapped = command("#x1600", 0, "0200" + "08050000" + "08010070", AT_ONCE)
    assert contradictions(f"{SMS}{gap}<Mailbox><CoE>{mapped}</CoE></Mailbox>") == []


ORDERED = dictionary(
    "<DataType><Name>DT1C12</Name><BitSize>48</BitSize>"
    + "".join(
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{number}</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{16 * number}</BitOffs></SubItem>"
        for number, kind, bits in ((0, "USINT", 8), (1, "UINT", 16), (2, "UINT", 16))
    )
    + "</DataType>",
    "<Object><Index>#x1C12</Index><Name>O</Name><Type>DT1C12</Type><BitSize>48</BitSize>"
    "<Info><DefaultData>{}</DefaultData></Info></Object>",
)
"""0x1C12 with the data of the whole object."""


@pytest.mark.parametrize(
    ("coe", "data", "is_told"),
    [
        ("", "020001160016", True),  # 0x1601 first
        ("", "020000160116", False),
        ("", "010001160016", False),  # another set: 0x1601 alone
        ('PdoAssign="1"', "020001160016", False),  # the master writes the order
    ],
)
def test_a_fixed_assignment_in_another_order_than_the_document(coe, data, is_told):
    both = AXIS.replace("<RxPdo ><Index>#x1601", '<RxPdo Sm="2"><Index>#x1601')
    found = configured(f"{ORDERED.format(data)}{SMS}{both}<Mailbox><CoE {coe}/></Mailbox>")
    assert pdos(found)[2] == [0x1600, 0x1601]
    words = "SM2 has the PDOs 0x1600, 0x1601 in this order here, 0x1C12 lists 0x1601, 0x1600 by default"
    assert any(remark.startswith(words) for remark in found.remarks) is is_told


KEPT = "the PDOs of SM2 are not the default ones, and the device does not declare PdoAssign"
LISTING = ("free", times("0")), ("DC", times("#x300") + '<Sm No="2"><Pdo>#x1601</Pdo></Sm>')


@pytest.mark.parametrize(
    ("coe", "op_mode", "is_told"), [("", "DC", True), ("", "free", False), ('PdoAssign="1"', "DC", False)]
)
def test_pdos_of_an_op_mode_that_the_device_may_not_take(coe, op_mode, is_told):
    found = configured(drive(coe=coe) + dc(*LISTING), op_mode=op_mode)
    assert pdos(found)[2] == [0x1601 if op_mode == "DC" else 0x1600]
    assert any(remark.startswith(KEPT) for remark in found.remarks) is is_told


def test_an_op_mode_of_a_device_without_mailbox_says_what_is_exchanged():
    """EL1262-0050, EL2262: nothing could declare PdoAssign, and their OpModes list the PDOs. Another choice is told."""
    content = SMS + AXIS + dc(*LISTING)
    found = configured(content, op_mode="DC")
    assert (pdos(found)[2], [remark for remark in found.remarks if "PdoAssign" in remark]) == ([0x1601], [])
    other = configured(content, op_mode="DC", pdos=parse_pdo_choice("0x1600"))
    assert [remark.startswith(KEPT) for remark in other.remarks if "PdoAssign" in remark] == [True]


def test_pdos_of_the_default_op_mode_are_default_ones():
    assert not any(KEPT in remark for remark in configured(drive() + dc(LISTING[1])).remarks)


def a_module(ident: str, content: str) -> str:
    return f'<Module><Type ModuleIdent="{ident}">M{ident}</Type><Name>m</Name>{content}</Module>'


def slot(idents: tuple[str, ...], attributes: str) -> str:
    return f"<Slot {attributes}>{''.join(f'<ModuleIdent>{ident}</ModuleIdent>' for ident in idents)}</Slot>"


OTHER_AXIS = AXIS.replace("#x16", "#x17").replace("#x1A", "#x1B")
AXIS_MODULES = a_module("#x10", AXIS) + a_module("#x20", OTHER_AXIS)
VALUE_MODULES = a_module("#x10", pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')) + a_module("#x20", "")
BOTH = ("#x10", "#x20")


@pytest.mark.parametrize(
    ("slots", "words"),
    [
        (slot(BOTH, 'MinInstances="0" MaxInstances="1"'), "slot 0 without a module:"),
        (slot(BOTH, 'MinInstances="0" MaxInstances="6"'), "slots 0, 1, 2, 3 and 2 more without a module:"),
        (slot(BOTH, 'MinInstances="2" MaxInstances="3"'), "slots 0, 1 without a module, though required:"),
    ],
)
@pytest.mark.parametrize(("modules", "may_move"), [(AXIS_MODULES, True), (VALUE_MODULES, False)])
def test_process_data_of_modules_that_are_not_plugged(slots, words, modules, may_move):
    content = f"{SMS}<Slots>{slots}</Slots>"
    found = configured(content, modules)
    (remark,) = found.remarks
    assert remark.startswith(words)
    assert "--module SLOT=IDENT" in remark and remark.endswith("what fits slot 0: 0x10, 0x20")
    assert ("Something may move" in igh_header(found)) is may_move
    for export in (ros2_slave, linuxcnc_configuration):
        with pytest.raises(InputError, match=f"has nothing to configure: {words}"):
            export(found)
    plugged = configured(
        content,
        modules,
        modules={0: ModuleChoice(0x10), 1: ModuleChoice(0x20)} if "1" in words else {0: ModuleChoice(0x10)},
    )
    assert plugged.missing_modules is None


@pytest.mark.parametrize("idents", [("#x30",), ("#x10", "#x30")])
def test_a_missing_module_that_nobody_describes_may_move_something(idents):
    slots = slot(idents, 'MinInstances="1" MaxInstances="1"')
    found = configured(f"{SMS}<Slots>{slots}</Slots>", VALUE_MODULES)
    assert "Something may move" in igh_header(found)


@pytest.mark.parametrize(("ident", "is_told"), [("#x10", False), ("#x20", True)])
def test_missing_modules_say_why_a_sync_manager_with_a_size_has_no_pdo(ident, is_told):
    """Modules of the other ident have no PDOs: they fill nothing, plugged or not."""
    sms = SMS.replace('"#x64"', '"#x64" DefaultSize="2"').replace('"#x20"', '"#x20" DefaultSize="2"')
    content = sms + "<Slots>" + slot((ident,), 'MinInstances="0" MaxInstances="1"') + "</Slots>"
    sizes = [f"SM{number} has DefaultSize 2 and no PDO: what it exchanges is not described" for number in (2, 3)]
    found = configured(content, VALUE_MODULES)
    assert [words for words in found.remarks if "DefaultSize" in words] == (sizes if is_told else [])
    assert len(found.remarks) == (2 if is_told else 1)
    plugged = configured(content, VALUE_MODULES, modules={0: ModuleChoice(int(ident[2:], 16))})
    assert plugged.remarks == (tuple(sizes) if is_told else ())


def test_exports_state_no_size_where_a_required_module_is_missing():
    """The device has 16 bits of outputs and of inputs; one of its modules is required and adds 8 bits of outputs."""
    slots = slot(("#x10", "#x30"), 'MinInstances="1" MaxInstances="1"')
    own = pdo("RxPdo", "#x1700", 16, attributes='Sm="2"') + pdo("TxPdo", "#x1B00", 16, attributes='Sm="3"')
    modules = VALUE_MODULES + a_module("#x30", pdo("RxPdo", "#x1601", 8, attributes='Sm="2"'))
    content = f"{SMS}{own}<Slots>{slots}</Slots>"
    found = configured(content, modules)
    assert len(found.remarks) == 1 and "slot 0 without a module, though required" in found.remarks[0]
    igh, soem = igh_header(found), soem_header(found)
    for text in (igh, soem, pysoem_module(found)):
        assert "SM2:      at least 2 bytes output: 0x1700" in text
        assert "SM3:      2 bytes input: 0x1B00" in text
    assert ("_SM2_BITS" in igh, "_SM3_BITS 16" in igh) == (False, True)
    assert ("_OUTPUT_BITS" in soem, "_INPUT_BITS 16" in soem) == (False, True)
    assert '"size of the described outputs"' in soem and '"size of the inputs"' in soem
    plugged = configured(content, modules, modules={0: ModuleChoice(0x30)})
    assert "_SM2_BITS 24" in igh_header(plugged) and "_OUTPUT_BITS 24" in soem_header(plugged)


def test_no_export_says_where_that_lies_which_is_behind_a_missing_module():
    """Module 0x20 in slot 1 has 8 bits; those of the module that belongs into slot 0 lie before them."""
    modules = a_module("#x10", pdo("RxPdo", "#x1600", 8, attributes='Sm="2"'))
    modules += a_module("#x20", pdo("RxPdo", "#x1601", 8, attributes='Sm="2"').replace("#x7000", "#x7010"))
    own = pdo("RxPdo", "#x1700", 16, attributes='Sm="2"')
    slots = slot(BOTH, 'MinInstances="1" MaxInstances="1"') * 2
    found = configured(f"{SMS}{own}<Slots>{slots}</Slots>", modules, modules={1: ModuleChoice(0x20)})
    assert "at least 3 bytes output: 0x1700, 0x1601" in igh_header(found)
    assert "place not known" in igh_header(found)
    for text in (soem_header(found), pysoem_module(found)):
        words = "the structure of the outputs ends before PDOs of modules that are missing in SM2"
        assert words in " ".join(text.replace("*", " ").replace("#", " ").split())
        assert "2 bytes" in text or "== 2" in text


def test_a_missing_module_may_bring_all_that_is_exchanged():
    sms = SMS[: SMS.index("<Sm", SMS.index("MBoxIn"))]
    slots = slot(("#x10", "#x20"), 'MinInstances="1" MaxInstances="1"')
    soem = soem_header(configured(f"{sms}<Slots>{slots}</Slots>", VALUE_MODULES))
    assert ("_OUTPUT_BITS" in soem, "_INPUT_BITS 0" in soem) == (False, True)


def a_command(data: str) -> str:
    return f"<Mailbox><CoE>{command('#x8000', 1, data)}</CoE></Mailbox>"


@pytest.mark.parametrize(
    ("slots", "modules", "choices"),
    [
        (
            '<Slot MinInstances="1" MaxInstances="1"><ModuleIdent Default="1">#x10</ModuleIdent></Slot>',
            a_module("#x10", a_command("01")) + a_module("#x10", a_command("02")).replace("M#x10", "other"),
            "0x10/M#x10, 0x10/other",
        ),
        (
            slot(BOTH, 'MinInstances="1" MaxInstances="1"'),
            a_module("#x10", a_command("01")) + a_module("#x20", a_command("02")),
            "0x10, 0x20",
        ),
    ],
)
def test_a_required_slot_for_modules_without_pdos_is_told_where_none_is_chosen(slots, modules, choices):
    """The modules differ in what they write at start-up, and that counts as much as PDOs do."""
    (remark,) = configured(f"{SMS}<Slots>{slots}</Slots>", modules).remarks
    words = "slot 0 without a module, though required: choose with --module SLOT=IDENT; what fits slot 0"
    assert remark == f"{words}: {choices}"


def test_slots_for_modules_without_process_data_lack_nothing():
    slots = slot(("#x20",), 'MinInstances="0" MaxInstances="1"')
    assert configured(f"{SMS}<Slots>{slots}</Slots>", VALUE_MODULES).remarks == ()


def sized(start: str, attributes: str = "") -> str:
    """SyncManagers with outputs of three buffers at 0x1100 and inputs behind them."""
    return (
        '<Sm StartAddress="#x1000" ControlByte="#x26" DefaultSize="128">MBoxOut</Sm>'
        '<Sm StartAddress="#x1080" ControlByte="#x22" DefaultSize="128">MBoxIn</Sm>'
        f'<Sm StartAddress="#x1100" ControlByte="#x64" {attributes}>Outputs</Sm>'
        f'<Sm StartAddress="{start}" ControlByte="#x20">Inputs</Sm>'
    )


ASSIGNABLE = AXIS.replace("#x6040", "#x2041", 1).replace("#x60", "#x20") + '<Mailbox><CoE PdoAssign="1"/></Mailbox>'


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (sized("#x1400", 'MaxSize="6"'), "SM2: the assigned PDOs take 12 bytes, MaxSize is 6"),
        (sized("#x1400", 'MaxSize="12"'), None),
        (sized("#x1124"), None),
        (sized("#x1112"), "SM 2 takes 0x1100 to 0x1123 and SM 3 starts at 0x1112: they overlap by 6 bytes"),
        (sized("#x1123"), "SM 2 takes 0x1100 to 0x1123 and SM 3 starts at 0x1123: they overlap by 1 byte"),
    ],
)
def test_chosen_pdos_that_do_not_fit(content, words):
    """Six bytes each: twelve take 36 in three buffers, and the inputs two, so six at 0x1112."""
    found = configured(content + ASSIGNABLE, pdos=parse_pdo_choice("0x1600,0x1601")).remarks
    assert [remark.split(";")[0] for remark in found] == ([words] if words is not None else [])
    by_op_mode = dc(("free", times("0")), ("both", times("0") + LIST_OF_BOTH))
    assert configured(content + ASSIGNABLE + by_op_mode, op_mode="both").remarks == found
    assert configured(content + ASSIGNABLE).remarks == ()


LIST_OF_BOTH = '<Sm No="2"><Pdo>#x1600</Pdo><Pdo>#x1601</Pdo></Sm>'


def test_chosen_pdos_below_the_smallest_size():
    """Two bytes in 0x1602, six in the default PDO."""
    content = sized("#x1400", 'MinSize="6"') + pdo("RxPdo", "#x1602", 16) + ASSIGNABLE
    found = configured(content, pdos=parse_pdo_choice("0x1602")).remarks
    assert [remark.split(";")[0] for remark in found] == ["SM2: the assigned PDOs take 2 bytes, MinSize is 6"]


def test_overlaps_of_the_default_process_image_are_known_to_the_vendor():
    assert configured(sized("#x1101") + ASSIGNABLE).remarks == ()


def declared(*subindices: int) -> str:
    """A dictionary with the mapping 0x1600 of these subindices and three objects for it."""
    items = "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>{n}</Name><Type>{'UDINT' if n else 'USINT'}</Type>"
        f"<BitSize>{32 if n else 8}</BitSize><BitOffs>{32 * n}</BitOffs></SubItem>"
        for n in (0, *subindices)
    )
    mapping = f"<DataType><Name>DT1600</Name><BitSize>96</BitSize>{items}</DataType>"
    types = "".join(f"<DataType><Name>{name}</Name><BitSize>{n}</BitSize></DataType>" for name, n in SIZES.items())
    objects = "".join(
        f"<Object><Index>#x{index}</Index><Name>o</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        "<Flags><Access>rw</Access><PdoMapping>R</PdoMapping></Flags></Object>"
        for index in ("7001", "7002", "7003")
    )
    record = "<Object><Index>#x1600</Index><Name>map</Name><Type>DT1600</Type><BitSize>96</BitSize></Object>"
    return dictionary(types + (mapping if subindices else ""), objects + (record if subindices else ""))


SIZES = {"USINT": 8, "UDINT": 32}
MAPPABLE = SMS + rx("#x1600", entry("#x7001", 32, "a")) + '<Mailbox><CoE PdoAssign="1" PdoConfig="1"/></Mailbox>'


def test_no_more_entries_than_the_mapping_has_subindices():
    three = parse_pdo_choice("0x1600=0x7001+0x7002+0x7003")
    with pytest.raises(InputError, match="3 entries are chosen for PDO 0x1600, which has room for 2: the dictionary"):
        configured(declared(1, 2) + MAPPABLE, pdos=three)
    for known in (declared(1, 2, 3), declared()):
        found = configured(known + MAPPABLE, pdos=three)
        assert [sm.byte_size for sm in found.sync_managers if sm.pdos] == [12]


def slots_without_increments() -> Subject:
    """Two slots, each with a module whose PDO stays at 0x1600 in both."""
    slot = "<Slot><Name>s</Name><ModuleIdent Default='1'>1</ModuleIdent></Slot>"
    mapped = rx("#x1600", entry("#x6040", 16, "Controlword"))
    one = f'<Module><Type ModuleIdent="1">m</Type><Name>m</Name>{mapped}</Module>'
    return subject(f"{SMS}<Slots>{slot}{slot}</Slots>", one)


@pytest.mark.parametrize("described", [slots_without_increments(), subject(SMS + rx("#x1600", entry("#x7000", 8)) * 2)])
def test_a_pdo_that_is_assigned_twice_is_refused_whatever_the_export(described):
    """The assignment object lists indices, and a device has one PDO of each."""
    with pytest.raises(InputError, match="PDO 0x1600 is assigned twice"):
        configure(described)


def test_choosing_a_pdo_that_is_assigned_twice_assigns_it_once():
    found = configure(slots_without_increments(), Choice(pdos=parse_pdo_choice("0x1600")))
    assert pdos(found) == {2: [0x1600]}


REPEATED = (
    rx("#x1600", entry("#x6040", 16, "Controlword"), entry("#x607A", 32, "Target"))
    + rx("#x1601", entry("#x6040", 16, "Controlword"))
    + rx("#x1602", entry("#x6040", 16, "Controlword"))
)
MAPPED_3_TIMES = "0x6040:00 Controlword is mapped 3 times: every copy is sent, so write all of them, or choose PDOs"


@pytest.mark.parametrize("export", [igh_header, soem_header, pysoem_module])
def test_outputs_that_are_mapped_again_are_told(export):
    text = " ".join(export(configured(SMS + REPEATED)).replace("#", "").replace("*", "").split())
    assert MAPPED_3_TIMES in text


@pytest.mark.parametrize("export", [ros2_slave, linuxcnc_configuration])
def test_programs_that_reach_one_copy_say_what_becomes_of_the_others(export):
    """And not that every copy can be written."""
    text = " ".join(export(configured(SMS + REPEATED)).replace("#", "").split())
    assert text.count("0x6040:00 Controlword is mapped 3 times: ") == text.count(" times: ") == 1
    assert text.count("reaches the first one only, the others stay 0: choose PDOs") == 1
    assert "every copy is sent" not in text


@pytest.mark.parametrize(
    ("mandatory", "coe", "is_advised"),
    [
        (("#x1600", "#x1601"), '<CoE PdoAssign="1"/>', False),
        (("#x1600",), '<CoE PdoAssign="1"/>', True),
        # Entries of a mandatory PDO can be chosen.
        (("#x1600", "#x1601"), '<CoE PdoAssign="1" PdoConfig="1"/>', True),
    ],
)
@pytest.mark.parametrize("export", [igh_header, pysoem_module, ros2_slave, linuxcnc_configuration])
def test_no_choice_is_advised_against_copies_in_mandatory_pdos(export, mandatory, coe, is_advised):
    content = SMS + REPEATED + f"<Mailbox>{coe}</Mailbox>"
    for index in mandatory:
        content = content.replace(f'<RxPdo Sm="2"><Index>{index}', f'<RxPdo Sm="2" Mandatory="1"><Index>{index}')
    text = " ".join(export(configured(content)).replace("#", "").replace("*", "").split())
    assert "0x6040:00 Controlword is mapped 3 times: " in text
    assert ("pdo) so that it is mapped once" in text) == is_advised


@pytest.mark.parametrize("export", [igh_header, ros2_slave, linuxcnc_configuration])
def test_a_choice_that_the_master_is_not_told_is_said_to_be_in_vain(export):
    """As of EL6224: 0x1600 stays and has no entries, so SM2 is left to the device, and with it 0x1601."""
    content = SMS + rx("#x1600", attributes='Sm="2" Mandatory="1"') + rx("#x1601", entry("#x7000", 8)) + COE
    content += rx("#x1A00", entry("#x6000", 8), attributes='Sm="3"').replace("RxPdo", "TxPdo")
    words = "PDO 0x1601 of SM2 is chosen in vain: the entries of PDOs of SM2 are not described, so nothing is assigned"
    for pdos_chosen in ("0x1601", "0x1601,0x1A00", "0x1A00"):
        found = configured(content, pdos=parse_pdo_choice(pdos_chosen))
        text = " ".join(export(found).replace("#", "").replace("*", "").split())
        assert text.count("chosen in vain") == text.count(words) == ("0x1601" in pdos_chosen)


@pytest.mark.parametrize("export", [ros2_slave, linuxcnc_configuration])
def test_samples_that_are_not_reached_are_no_matter_of_pdos(export):
    """0x1600 is sampled four times by the OpMode, chosen with --pdo or not."""
    mode = '<AssignActivate>#x300</AssignActivate><CycleTimeSync0 Factor="-4">0</CycleTimeSync0>'
    mode += '<Sm No="2"><Pdo OSFac="4">#x1600</Pdo></Sm>'
    content = SMS + rx("#x1600", entry("#x7000", 16, "sample", 1)) + dc(("4", mode))
    for pdos_chosen in ((), parse_pdo_choice("0x1600")):
        text = " ".join(export(configured(content, pdos=pdos_chosen)).replace("#", "").split())
        assert "0x7000:01 sample is mapped 4 times: " in text
        assert "the others stay 0: choose an OpMode without oversampling" in text
        assert "pdo) so that it is mapped once" not in text


@pytest.mark.parametrize(
    ("export", "advice"),
    [
        (igh_header, "register its outputs in one domain and its inputs in another"),
        (ros2_slave, "see whether ethercat_driver_ros2 has domains for outputs and for inputs in its version"),
        (linuxcnc_configuration, "see whether LinuxCNC-Ethercat has domains for outputs and for inputs in its version"),
        (soem_header, None),
        (pysoem_module, None),
    ],
)
def test_a_device_that_takes_no_lrw(export, advice):
    """Of the masters IgH does not look at the flag in the EEPROM image, SOEM does."""

    def text(attribute: str) -> str:
        described = esi(device(drive()).replace("<Type ", f"<Type {attribute} "))
        (found,) = subjects_of_document(read(described).document, "x.xml")
        return " ".join(export(configure(found)).replace("#", "").replace("*", "").split())

    assert ("the device takes no LRW (Type/@UseLrdLwr)" in text('UseLrdLwr="1"')) == (advice is not None)
    assert advice is None or advice in text('UseLrdLwr="1"')
    assert "LRW" not in text("")


def test_copies_of_inputs_and_of_what_has_no_name():
    inputs = pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"') + pdo("TxPdo", "#x1A01", 16, attributes='Sm="3"')
    assert listed(configured(SMS + inputs.replace("<Name>e1</Name>", "")), "lcec").remarks == (
        "0x7000:01 is mapped 2 times: lcec finds entries by index and subindex, and reaches the first one only",
    )


@pytest.mark.parametrize(
    ("content", "choice"),
    [
        (REPEATED, {"pdos": parse_pdo_choice("0x1600")}),
        (REPEATED.replace("RxPdo", "TxPdo").replace("#x160", "#x1A0").replace('Sm="2"', 'Sm="3"'), {}),
        (REPEATED.replace("#x1600", "#x18").replace("#x1601", "#x1018").replace("#x1602", "#x2018"), {}),
        (rx("#x1600", entry("#x7000", 8, "sample"), attributes='Sm="2" OSFac="4"'), {}),
    ],
    ids=["chosen once", "inputs", "IDNs of several drives", "samples"],
)
def test_what_is_not_mapped_again(content, choice):
    assert not configured(SMS + content, **choice).copy_remarks


@pytest.mark.parametrize(
    ("second", "words"),
    [
        (
            ("enable", 1),
            "0x0006:01 is mapped 2 times, as different values: joint.0.vel (32 bit), enable (1 bit)",
        ),
        (
            ("", 8),
            "0x0006:01 is mapped 2 times, as different values: joint.0.vel (32 bit), without a name (8 bit)",
        ),
        (
            ("joint.1.vel", 32),
            "0x0006:01 is mapped 2 times, perhaps as different values: joint.0.vel (32 bit), joint.1.vel (32 bit)",
        ),
    ],
)
def test_what_is_not_alike_is_no_copy(second, words):
    """An object has one length: what has another is another value, and to map one of them only would lose the other."""
    content = SMS + rx("#x1600", entry("#x6", 32, "joint.0.vel", 1), entry("#x6", second[1], second[0], 1))
    found = configured(content)
    assert found.copy_remarks == (f"{words}: each is sent, so write every one of them",)
    assert f"{words}: lcec finds entries by index and subindex, and reaches the first one only, the others stay 0" in (
        listed(found, "lcec").remarks
    )


def test_only_gaps_are_called_so():
    """One gap, and values to which the vendor gave no name."""
    content = SMS + rx("#x1600", entry("#x7000", 16), entry("#x0", 8), entry("#x7001", 8)) + COE
    found = configured(content)
    for export in EXPORTS:
        lines = [line for line in export(found).splitlines() if line.rstrip(" */->").endswith("gap")]
        assert len(lines) == 1, export
    assert "<!--  -->" not in linuxcnc_configuration(found)


@pytest.mark.parametrize("transition", ["PS", "SO"])
@pytest.mark.parametrize("export", EXPORTS)
def test_complete_access_that_begins_further_on_is_left_out(export, transition):
    """SOEM rewrites the subindex to 1, IgH knows 0 only: the two bytes would land in other subindices than 2 and 3."""
    here = command("#x8000", 2, "AABB", AT_ONCE).replace(">PS<", f">{transition}<")
    text = export(configured(drive(here)))
    assert f"- {transition} 0x8000 is left out: " in text
    assert not re.search("0x8000,|idx=.8000", text)


@pytest.mark.parametrize("export", (soem_header, pysoem_module))
def test_soem_sends_complete_access_from_subindex_1(export):
    text = export(configured(drive(command("#x8000", 1, "AABB", AT_ONCE))))
    assert "left out" not in text
    assert re.search(r"sdo_write\(0x8000, 1, .*, ca=True\)|SDOwrite\(.*0x8000, 0x01, TRUE", text)
