"""What sets the mode of a drive in exports, and where nothing does or something else than what is mapped."""

import pytest
from snippets import dictionary
from test_export_configuration import COE, SMS, configured, entry, mode_command, rx

from esicatalog.export.choice import PdoChoice
from esicatalog.export.igh import igh_header
from esicatalog.export.linuxcnc import linuxcnc_configuration
from esicatalog.export.mode_commands import mode_remarks
from esicatalog.export.pysoem import pysoem_module
from esicatalog.export.ros2 import ros2_slave
from esicatalog.export.soem import soem_header


@pytest.mark.parametrize(
    ("setpoints", "code", "against"),
    [
        (("607A",), 8, None),
        (("607A",), 9, "9 (CSV) does not go with the mapped setpoint 0x607A"),
        (("607A",), 6, "6 (HM) does not go with the mapped setpoint 0x607A"),
        (("607A",), 0xFD, None),  # a mode of the manufacturer's
        (("6071",), 11, "11 (CSTCA) does not go with the mapped setpoint 0x6071"),
        (("6071", "60EA"), 11, None),
        (("60FF", "607A"), 9, None),
        ((), 9, None),  # the setpoint may be one of the vendor's
    ],
)
@pytest.mark.parametrize("is_default", [True, False])
def test_a_mode_without_its_setpoint_is_told(setpoints, code, against, is_default):
    """Setpoints by mode: the table of ESI-FACTS section 16. The mode is the default of 0x6060 or written at start."""
    mode = (
        "<Object><Index>#x6060</Index><Name>M</Name><Type>SINT</Type><BitSize>8</BitSize>"
        f"<Info><DefaultData>{code if is_default else 0:02X}</DefaultData></Info>"
        "<Flags><Access>rw</Access></Flags></Object>"
    )
    described = dictionary("<DataType><Name>SINT</Name><BitSize>8</BitSize></DataType>", mode)
    coe = COE if is_default else f"<Mailbox><CoE>{mode_command(f'{code:02X}')}</CoE></Mailbox>"
    mapped = (entry(f"#x{index}", 16 if index in ("6071", "60EA") else 32) for index in setpoints)
    found = configured(described + SMS + rx("#x1600", entry("#x6040", 16), *mapped) + coe)
    source = "its default," if is_default else "the start-up command's"
    words = "0x6060 is in none of the assigned RxPDOs: write the mode that is wanted to it before operation, for"
    told = [] if against is None else [f"{words} {source} {against}"]
    assert list(mode_remarks(found.modes, found.commands)) == told


def test_a_setpoint_that_is_chosen_without_the_controlword_is_told():
    """A choice replaces what the SyncManager has, so the drive cannot be enabled."""
    described = rx("#x1600", entry("#x6040", 16)) + rx("#x1606", entry("#x607A", 32), attributes="")
    content = "<Profile><ProfileNo>402</ProfileNo></Profile>" + SMS + described + COE
    words = "the controlword 0x6040 is in none of the assigned RxPDOs, by which a drive is enabled: "
    alone, both = (
        [remark for remark in configured(content, pdos=chosen).remarks if "controlword" in remark]
        for chosen in ((PdoChoice(0x1606),), (PdoChoice(0x1600), PdoChoice(0x1606)))
    )
    assert (alone, both) == ([f"{words}RxPDO 0x1600 has it"], [])


def test_a_statusword_in_place_of_the_controlword_is_told():
    """Real robot joints swap the two words."""
    found = configured(SMS + rx("#x1600", entry("#x6041", 16, "controlword"), entry("#x607A", 32)) + COE)
    assert found.remarks == (
        "the controlword 0x6040 is in none of the assigned RxPDOs, but the statusword 0x6041 is: check whether the two "
        "are swapped",
    )


@pytest.mark.parametrize(
    ("generate", "ending"),
    [
        (igh_header, "call t1_send_so() in SAFE-OP"),
        (soem_header, "call t1_send_so() in SAFE-OP"),
        (pysoem_module, "call send_so() in SAFE-OP"),
        (ros2_slave, None),
        (linuxcnc_configuration, None),
    ],
)
def test_a_mode_that_a_target_does_not_send_at_so_is_told(generate, ending):
    """IgH and SOEM have a function for commands of SO, programs on top of IgH send none (ESI-FACTS section 10)."""
    pdo = rx("#x1600", entry("#x6040", 16), entry("#x60FF", 32))
    coe = '<Mailbox><CoE PdoAssign="1">{}</CoE></Mailbox>'

    def text_of(*commands: str) -> str:
        found = generate(configured(SMS + pdo + coe.format("".join(commands))))
        return " ".join(found.replace("\n *", "").replace("\n#", "").split())

    called = "0x6060 = 9 (CSV) is written by a start-up command that the application sends: "
    missing = (
        "0x6060 is in none of the assigned RxPDOs: write the mode that is wanted to it before operation, for the "
        "start-up command that writes 9 (CSV) is left out"
    )
    for before in ((), (mode_command("08"),)):
        text = text_of(*before, mode_command("09", "SO"))
        assert (missing in text, f"{called}{ending}, or write the mode before operation" in text) == (
            ending is None,
            ending is not None,
        )
    for text in (text_of(mode_command("09")), text_of(mode_command("09"), mode_command("09", "SO"))):
        assert "before operation" not in text


def test_a_start_up_command_that_writes_no_mode_is_named():
    pdo = rx("#x1600", entry("#x6040", 16), entry("#x60FF", 32))
    header = igh_header(configured(SMS + pdo + f'<Mailbox><CoE PdoAssign="1">{mode_command("00")}</CoE></Mailbox>'))
    assert "operation, for the start-up command writes 0" in " ".join(header.replace("\n *", "").split())
