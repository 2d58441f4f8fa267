"""Words of sheets and pages for what a description declares."""

import pytest
from snippets import device, esi, only_device, pdo

from esicatalog.model.derivation import derive
from esicatalog.model.device_words import clock_words, init_cmd_target, mailbox_words


def mode(activate: str) -> str:
    return f"<OpMode><Name>M</Name>{activate}</OpMode>"


FREE_RUN = mode("<AssignActivate>#x0000</AssignActivate>")
UNKNOWN_NEED = "DC used (whether it is needed is not known)"
SYNC0 = mode("<AssignActivate>#x0300</AssignActivate>")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("", "not described"),
        ("<Dc/>", "not described"),
        (f"<Dc>{mode('')}</Dc>", "not described"),
        (f"<Dc>{mode('<AssignActivate>300h</AssignActivate>')}{FREE_RUN}</Dc>", "not described"),
        (f"<Dc>{FREE_RUN}</Dc>", "no DC"),
        ('<Dc PotentialReferenceClock="1"/>', "can be the reference clock"),
        (f"<Dc>{FREE_RUN}{SYNC0}</Dc>", "DC optional, SYNC0"),
        (f"<Dc>{SYNC0}</Dc>", "DC needed, SYNC0"),
        (f'<Dc TimeLoopControlOnly="1">{SYNC0}</Dc>', "DC needed"),
        ('<Dc TimeLoopControlOnly="1"/>', "DC optional"),
        (f"<Dc>{SYNC0}{mode('<AssignActivate>bogus</AssignActivate>')}</Dc>", f"{UNKNOWN_NEED}, SYNC0"),
        (f"<Dc>{SYNC0}{mode('<AssignActivate>bogus</AssignActivate>')}{FREE_RUN}</Dc>", "DC optional, SYNC0"),
    ],
)
def test_clocks(content, words):
    found = only_device(esi(device(content)))
    assert clock_words(found, derive(found, ()).facts) == words


@pytest.mark.parametrize(
    ("attributes", "target"), [("", "IDN 32"), (" Chn='0'", "IDN 32 channel 0"), (" Chn='1'", "IDN 32 channel 1")]
)
def test_an_idn_is_of_a_drive(attributes, target):
    """A device with two drives (AX52xx) has the same IDN for each: InitCmd/@Chn tells which one is written."""
    command = f"<InitCmd{attributes}><Transition>PS</Transition><IDN>32</IDN><Data>0B00</Data></InitCmd>"
    found = only_device(esi(device(f"<Mailbox><SoE>{command}</SoE></Mailbox>")))
    assert init_cmd_target(found.mailbox.soe_init_cmds[0]) == target


@pytest.mark.parametrize(
    ("index", "subindex", "target"),
    [
        ("#x8001", "10", "0x8001:0A"),
        ("#x0x8001x", "10", "? '#x0x8001x':0A"),
        ("#x8001", "x1", "0x8001:? 'x1'"),
        ("", "10", ""),
    ],
)
def test_a_target_that_cannot_be_read_is_shown_as_it_stands(index, subindex, target):
    place = f"<Index>{index}</Index><SubIndex>{subindex}</SubIndex>"
    command = f"<InitCmd><Transition>PS</Transition>{place}<Data>00</Data></InitCmd>"
    found = only_device(esi(device(f"<Mailbox><CoE>{command}</CoE></Mailbox>")))
    assert init_cmd_target(found.mailbox.coe_init_cmds[0]) == target


OUT, INTO = '<Sm ControlByte="#x26">{}</Sm>', '<Sm ControlByte="#x22">{}</Sm>'


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("", "none"),
        ("<Mailbox/>", "no protocol"),
        ("<Mailbox><CoE/><FoE/></Mailbox>", "CoE, FoE"),
        (OUT.format("") + INTO.format(""), "not described (SM0 and SM1 are for one)"),
        ("<Sm>MBoxOut</Sm>", "not described (SM0 is for one)"),
        # Process data in a single buffer, as 0x26 and 0x22 are read for Outputs and Inputs (ESI-FACTS 8).
        (OUT.format("Outputs") + INTO.format("Inputs"), "none"),
        (INTO.format("") + pdo("TxPdo", "#x1A00", 8, attributes='Sm="0"'), "none"),
        ('<Sm ControlByte="#x64"/>', "none"),
    ],
)
def test_what_is_known_of_a_mailbox(content, words):
    assert mailbox_words(only_device(esi(device(content)))) == words
