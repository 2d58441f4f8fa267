"""Words of sheets and pages for what a description declares."""

import pytest
from snippets import device, esi, only_device

from esicatalog.model.derivation import derive
from esicatalog.model.words import clock_words, init_cmd_target


def mode(activate: str) -> str:
    return f"<OpMode><Name>M</Name>{activate}</OpMode>"


FREE_RUN = mode("<AssignActivate>#x0000</AssignActivate>")
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
