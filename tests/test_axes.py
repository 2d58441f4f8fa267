"""Which CiA 402 axes there are: those that a master can command, and those that an export exchanges something with."""

import pytest
from snippets import device, esi, only_device

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.profile import ChannelInfo, Profile
from esicatalog.model.axes import exchanged_axes, is_commanded_axis, may_be_commanded, may_move
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.profile_facts import has_profile_402, is_motion_terminal, profile_numbers


def mapping(kind: str, index: str, bits: int, subindex: int = 0) -> str:
    entry = f"<Entry><Index>{index}</Index><SubIndex>{subindex}</SubIndex><BitLen>{bits}</BitLen></Entry>"
    return f"<{kind}><Index>{'#x1600' if kind == 'RxPdo' else '#x1A00'}</Index><Name>P</Name>{entry}</{kind}>"


@pytest.mark.parametrize(
    ("content", "commanded", "exchanged"),
    [
        (mapping("RxPdo", "#x6040", 16), [0], [0]),
        (mapping("RxPdo", "#x6840", 16), [1], [1]),
        # Nobody commands an axis by its statusword, and yet its values are those of an axis.
        (mapping("TxPdo", "#x6041", 16), [], [0]),
        # An encoder sends its acceleration (CiA 406), and nobody commands by what is sent.
        (mapping("TxPdo", "#x6040", 16), [], []),
        # Joints of a robot have the two words the other way round.
        (mapping("RxPdo", "#x6041", 16), [], [0]),
        (mapping("RxPdo", "#x6041", 16) + mapping("TxPdo", "#x6040", 16), [], [0]),
        # On modular I/O 0x6040 is an input channel.
        (mapping("RxPdo", "#x6040", 8), [], []),
        (mapping("RxPdo", "#x6040", 16, subindex=1), [], []),
        ("<Profile><ProfileNo>402</ProfileNo></Profile>", list(range(8)), [0]),
    ],
)
def test_axes(content, commanded, exchanged):
    """``profiles`` are given to every axis here; who asks gives them to those that they speak for."""
    found = only_device(esi(device(content)))
    views = DictionaryViews()
    assert [n for n in range(8) if is_commanded_axis(n, found.profiles, found.rx_pdos, ())] == commanded
    assert list(exchanged_axes(found, found.profiles, found.rx_pdos, found.tx_pdos, lambda _: None)) == exchanged
    assert not commanded or may_be_commanded(found, views)
    module = Module(profiles=found.profiles, rx_pdos=found.rx_pdos, tx_pdos=found.tx_pdos)
    assert may_move(module) == bool(exchanged)


def test_both_words_declared_make_an_axis_of_an_export():
    bits = {0x6040: 16, 0x6041: 16, 0x6840: 16, 0x6841: 8, 0x7040: 16}
    assert list(exchanged_axes(Device(), (), (), (), bits.get)) == [0]


@pytest.mark.parametrize(("protocols", "exchanged"), [("<SoE/>", []), ("<SoE/><CoE/>", [0, 4]), ("<CoE/>", [0, 4])])
def test_idns_are_no_words_of_an_axis(protocols, exchanged):
    """P-0-0064 and P-0-0065 of AX5000 drives, both of 16 bits, are 0x8040 and 0x8041: the words of axis 4."""
    content = f"{mapping('RxPdo', '#x6040', 16)}<Mailbox>{protocols}</Mailbox>"
    found = only_device(esi(device(content)))
    bits = {0x8040: 16, 0x8041: 16}
    assert list(exchanged_axes(found, found.profiles, found.rx_pdos, (), bits.get)) == exchanged


def test_numbers_of_channels_count_as_those_of_the_profile():
    profile = Profile(
        profile_no=5003, channel_infos=(ChannelInfo(profile_no=402), ChannelInfo(profile_no=5001, add_info=742))
    )
    assert profile_numbers((profile,)) == [(5003, None), (402, None), (5001, 742)]
    assert has_profile_402((profile,))
    assert is_motion_terminal((profile,))


@pytest.mark.parametrize(
    ("profile_no", "add_info", "is_one"),
    [
        (5001, 700, True),
        (5001, 799, True),
        (5001, 800, False),
        (5001, 699, False),
        (5001, None, False),
        (402, 742, False),
    ],
)
def test_motion_terminals_are_the_modules_7xx(profile_no, add_info, is_one):
    assert is_motion_terminal((Profile(profile_no=profile_no, add_info=add_info),)) == is_one
