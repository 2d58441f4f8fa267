"""Values that stand in a document and cannot be read: nothing takes them as absent without a word."""

import pytest
from snippets import device, esi, only_device, pdo
from test_export_configuration import COE, SMS, configured, dc, entry, init_cmd, pdos, rx, subject, times

from esicatalog.errors import InputError
from esicatalog.esi.unreadable import Unreadable, unreadable, unreadable_values
from esicatalog.export.choice import parse_pdo_choice
from esicatalog.export.headings import choice_lines
from esicatalog.export.igh import igh_header
from esicatalog.export.sii_remarks import eeprom_remarks
from esicatalog.export.soem import soem_header
from esicatalog.model.pdo_facts import entry_words

ABSENT = "; it cannot be read and counts as absent: correct the file"
MAILBOX = '<Sm DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>'


def unread(content: str, module_text: str = "", **choice) -> list[str]:
    """What the exports of a device say of values that cannot be read."""
    remarks = configured(content, module_text, **choice).remarks
    return [remark.removesuffix(ABSENT) for remark in remarks if remark.endswith(ABSENT)]


def in_image(content: str) -> list[str]:
    return [remark for remark in eeprom_remarks(subject(content)) if "place for" not in remark]


def test_bytes_in_hex_are_unreadable_when_they_are_none():
    """Their record keeps the text, in which a digit is missing or too many stand."""
    found = only_device(esi(device("<Eeprom><ConfigData>050</ConfigData><BootStrap>0010</BootStrap></Eeprom>")))
    assert list(unreadable_values(found, lambda part: True)) == [
        Unreadable("Eeprom/ConfigData", "'050' is not hexBinary (pairs of hex digits)")
    ]


def test_values_are_listed_with_their_place_and_the_reason():
    found = only_device(
        esi(device('<Sm Enable="on">A</Sm><Sm StartAddress="" MinSize="99999999999999999999" OpOnly="yes">B</Sm>'))
    )
    assert list(unreadable_values(found, lambda part: True)) == [
        Unreadable("Sm[0]/@Enable", "'on' is not a HexDecValue"),
        Unreadable("Sm[1]/@MinSize", "'99999999999999999999' is out of range"),
        Unreadable("Sm[1]/@OpOnly", "'yes' is not a boolean"),
    ]
    assert list(unreadable_values(found, lambda part: False)) == []
    first, second = found.sync_managers
    assert unreadable(first, "enable") == "'on' is not a HexDecValue"
    assert [unreadable(first, "min_size"), unreadable(second, "start_address"), unreadable(first, "usage")] == [
        None
    ] * 3


def test_of_repeated_values_each_has_its_own_text():
    found = only_device(
        esi(device(pdo("RxPdo", "#x1600", 8, extra="<ExcludedSm>2</ExcludedSm><ExcludedSm>SM3</ExcludedSm>")))
    )
    assert list(unreadable_values(found.rx_pdos[0], lambda part: True)) == [
        Unreadable("ExcludedSm", "'SM3' is not an integer")
    ]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (rx("#x1600", entry("#x6040", 16), attributes='Sm="SM2"'), "RxPdo/@Sm: 'SM2' is not an integer"),
        (
            rx("#x1600", entry("#x6040", 16), extra="<Exclude>1601h</Exclude>"),
            "RxPdo/Exclude: '1601h' is not a HexDecValue",
        ),
        (
            rx("#x1600", entry("#x6040", 16).replace("<Entry>", '<Entry Fixed="yes">')),
            "PDO 0x1600, entry 1: @Fixed: 'yes' is not a boolean",
        ),
        (dc(("DC", times("300h"))), "Dc/OpMode/AssignActivate: '300h' is not a HexDecValue"),
        (dc(("DC", times("#x300", ">1ms"))), "Dc/OpMode/CycleTimeSync0: '1ms' is not an integer"),
        (dc(("DC", times("#x300", 'Factor="1">0', shift0="50%"))), "Dc/OpMode/ShiftTimeSync0: '50%' is not an integer"),
        (
            "<Slots><Slot MinInstances='0' MaxInstances='1'><ModuleIdent>100h</ModuleIdent></Slot></Slots>",
            "Slots/Slot/ModuleIdent: '100h' is not a HexDecValue",
        ),
        ('<Mailbox><CoE CompleteAccess="on"/></Mailbox>', "Mailbox/CoE/@CompleteAccess: 'on' is not a boolean"),
        ("<Slots SlotPdoIncrement='x'/>", "Slots/@SlotPdoIncrement: 'x' is not a HexDecValue"),
        ("<ESC><Reg0420>100h</Reg0420></ESC>", "ESC/Reg0420: '100h' is not a HexDecValue"),
    ],
)
def test_exports_say_what_they_are_made_without(content, words):
    assert unread(SMS + content) == [words]


@pytest.mark.parametrize(
    "content",
    [
        "<Info><Electrical><EBusCurrent>abc</EBusCurrent></Electrical></Info>",
        "<Info><Mailbox><Timeout><RequestTimeout>x</RequestTimeout></Timeout></Mailbox></Info>",
        "<Info><Port><RxDelay>x</RxDelay></Port></Info>",
        '<Mailbox><EoE TimeStamp="on"/></Mailbox>',
    ],
)
def test_exports_say_nothing_of_what_none_of_them_uses(content):
    assert configured(SMS + content).remarks == ()


def test_an_object_without_subindex_is_its_subindex_0_and_that_is_said():
    """Absent or empty; a text that cannot be read is refused. Gaps and IDNs have none."""
    words = "PDO 0x1600 maps 0x7000 without SubIndex, which says 0: check that this is the object that is meant"
    for given in ("", "<SubIndex></SubIndex>"):
        content = SMS + rx("#x1600", entry("#x7000", 16).replace("<SubIndex>0</SubIndex>", given))
        found = configured(content)
        assert found.remarks == (words,)
        assert "{0x7000, 0x00, 16}" in igh_header(found)
        stored = "Objects mapped without SubIndex, which says 0; check that these are the objects that are meant: "
        assert f"{stored}0x7000:00 of PDO 0x1600." in in_image(content)
        assert configured(content.replace("#x7000", "0")).remarks == ()
        assert configured(content + "<Mailbox><SoE/></Mailbox>").remarks == ()
    assert configured(SMS + rx("#x1600", entry("#x7000", 16))).remarks == ()


def test_timeouts_count_for_the_master_that_takes_them():
    content = "<Info><StateMachine><Timeout><PreopTimeout>3 s</PreopTimeout></Timeout></StateMachine></Info>"
    words = f"- Info/StateMachine/Timeout/PreopTimeout: '3 s' is not an integer{ABSENT}"
    found = configured(SMS + rx("#x1600", entry("#x6040", 16)) + content)
    assert words in " ".join(igh_header(found).replace("*", "").split())
    assert "PreopTimeout" not in soem_header(found)


def test_exports_say_nothing_of_what_is_not_chosen():
    modes = dc(("DC", times("#x300", 'Factor="1">0')), ("B", times("700h")))
    unassigned = rx("#x1601", entry("#x60FF", 32).replace("<Entry>", '<Entry Fixed="yes">'), attributes="")
    content = SMS + rx("#x1600", entry("#x6040", 16)) + unassigned + COE + modes
    assert unread(content) == []
    assert unread(content, op_mode="1") == ["Dc/OpMode[1]/AssignActivate: '700h' is not a HexDecValue"]
    assert unread(content, pdos=parse_pdo_choice("0x1601")) == ["PDO 0x1601, entry 1: @Fixed: 'yes' is not a boolean"]


def test_plugged_modules_are_told_by_their_slot():
    slots = "<Slots><Slot MinInstances='1' MaxInstances='1'><ModuleIdent Default='1'>1</ModuleIdent></Slot></Slots>"
    module = '<Module><Type ModuleIdent="1">M</Type><Name>M</Name><RxPdo Sm="two"/></Module>'
    assert unread(SMS + slots, module) == ["module in slot 0: RxPdo/@Sm: 'two' is not an integer"]


def test_an_unreadable_assign_activate_is_not_called_no_distributed_clocks():
    line = next(choice_lines(configured(SMS + dc(("DC", times("300h"))))))
    assert line == "OpMode:   0 'DC': AssignActivate unknown, no distributed clocks are set up"


def test_a_factor_that_cannot_be_read_is_not_called_absent():
    found = configured(SMS + dc(("DC", times("#x300", 'Factor="0.5">0'))))
    assert found.remarks == (
        f"Dc/OpMode/CycleTimeSync0/@Factor: '0.5' is not an integer{ABSENT}",
        "CycleTimeSync0 gives no cycle: SYNC0 follows the bus cycle",
    )


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ("<Index>607Ah</Index>", r"Index \('607Ah' is not a HexDecValue\)"),
        ("<Index></Index>", "Index:"),
        ("<Index>#x607A</Index><SubIndex>00h</SubIndex>", r"SubIndex \('00h' is not a HexDecValue\)"),
    ],
)
def test_an_entry_that_does_not_say_what_it_maps_is_refused(wrong, words):
    content = SMS + rx("#x1600", entry("#x6040", 16), f"<Entry>{wrong}<BitLen>32</BitLen></Entry>") + COE
    with pytest.raises(InputError, match=f"PDO 0x1600 has an entry, number 2, without a usable {words}"):
        configured(content)
    assert pdos(configured(content, pdos=parse_pdo_choice("0x1600=0x6040"))) == {2: [0x1600]}
    assert pdos(configured(content.replace('Sm="2"', ""))) == {}


def test_an_index_or_length_that_cannot_be_read_is_refused_with_its_text():
    with pytest.raises(InputError, match="RxPdo 'R' is assigned and its Index '1600h' is not a HexDecValue"):
        configured(SMS + rx("1600h", entry("#x6040", 16)))
    with pytest.raises(InputError, match=r"maps 0x6040:00 without a usable BitLen \('16bit' is not an integer\)"):
        configured(SMS + rx("#x1600", entry("#x6040", "16bit")))


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (init_cmd("PS", "6060h", "01"), "index ('6060h' is not a HexDecValue)"),
        (init_cmd("PS", "#x6060", "01").replace(">1<", ">01h<"), "subindex ('01h' is not a HexDecValue)"),
        (init_cmd("PS", "#x6060", "01", 'CompleteAccess="yes"'), "CompleteAccess ('yes' is not a boolean)"),
    ],
)
def test_a_command_whose_place_cannot_be_read_is_left_out(command, words):
    found = configured(SMS + f"<Mailbox><CoE>{command}</CoE></Mailbox>")
    assert found.commands == ()
    assert found.remarks == (f"CoE InitCmd of the device is left out: its {words} cannot be used",)


def test_entries_that_map_something_unknown_are_no_padding():
    unknown = entry("#x607A", 32).replace(">0<", ">00h<")
    content = rx("#x1600", entry("607Ah", 32), unknown, entry("0", 8), entry("#x607A", 32, subindex=10))
    words = [entry_words(item) for item in only_device(esi(device(content))).rx_pdos[0].entries]
    assert words == ["unknown", "0x607A:?", "padding", "0x607A:0A"]


@pytest.mark.parametrize(
    ("attribute", "value"),
    [("StartAddress", "1000h"), ("DefaultSize", ""), ("ControlByte", "0x26h"), ("Enable", None)],
)
def test_images_with_a_mailbox_that_nobody_reaches_are_told(attribute, value):
    wrong = "" if value is None else f'{attribute}="{value}"'
    content = MAILBOX.replace(next(part for part in MAILBOX.split() if part.startswith(attribute)).split(">")[0], wrong)
    sentence = (
        "Mailboxes without a usable attribute, stored as 0; do not write this image, no master reaches them: "
        f"{attribute} of SM0."
    )
    found = in_image(content)
    assert sentence in found
    told = [remark for remark in found if remark.startswith("Values that cannot be read")]
    assert len(told) == bool(value)
    assert all(f"Sm/@{attribute} '{value}' is not a HexDecValue" in remark for remark in told)
    assert sentence not in in_image(MAILBOX)


def test_images_with_entries_that_say_not_what_they_map_are_told():
    content = rx("#x1600", entry("607Ah", 32), entry("#x6040", 16).replace(">0<", ">00h<"))
    assert (
        "Entries without a usable Index or SubIndex, stored as gaps or with subindex 0; do not write this image, its "
        "PDOs are wrong: entry 1 of PDO 0x1600, entry 2 of PDO 0x1600."
    ) in in_image(content)
