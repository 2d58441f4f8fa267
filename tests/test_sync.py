"""AssignActivate and ControlByte in words (ESI-FACTS sections 8 and 11)."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from snippets import device, esi, only_device

from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import SyncManager
from esicatalog.esi.records.module import Module
from esicatalog.model.sm_facts import sm_facts
from esicatalog.model.sync import (
    chosen_positions,
    default_op_mode,
    default_position,
    generated_signals,
    op_mode_choice,
    sync_signals,
)


@pytest.mark.parametrize(
    ("word", "signals"),
    [
        (0x0000, set()),
        (0x0030, {"latch0_pdi", "latch1_pdi"}),
        (0x0100, {"dc_active", "time_only"}),
        (0x0120, {"dc_active", "time_only", "latch1_pdi"}),
        (0x0300, {"dc_active", "sync0"}),
        (0x0301, {"dc_active", "sync0", "sync_unit_pdi"}),
        (0x0310, {"dc_active", "sync0", "latch0_pdi"}),
        (0x0320, {"dc_active", "sync0", "latch1_pdi"}),
        (0x0500, {"dc_active", "sync1"}),
        (0x0630, {"latch0_pdi", "latch1_pdi"}),
        (0x0700, {"dc_active", "sync0", "sync1"}),
        (0x0730, {"dc_active", "sync0", "sync1", "latch0_pdi", "latch1_pdi"}),
    ],
)
def test_assign_activate(word, signals):
    found = sync_signals(word)
    names = ("dc_active", "sync0", "sync1", "time_only", "sync_unit_pdi", "latch0_pdi", "latch1_pdi")
    assert {name for name in names if getattr(found, name)} == signals


def test_an_absent_assign_activate_says_nothing():
    assert sync_signals(None).sync0 is None
    assert sync_signals(None).dc_active is None


@pytest.mark.parametrize("word", [-1, 0x10300])
def test_an_assign_activate_that_no_register_holds_says_nothing(word):
    """The registers 0x0980 and 0x0981 are two bytes."""
    assert sync_signals(word) == sync_signals(None)


@given(st.integers(0, 0xFFFF))
def test_no_signal_without_an_active_unit(word):
    found = sync_signals(word)
    assert found.dc_active == bool(word & 0x0100)
    assert found.sync0 <= found.dc_active
    assert found.sync1 <= found.dc_active
    assert found.time_only == (found.dc_active and not found.sync0 and not found.sync1)


@pytest.mark.parametrize("word", [0x0000, 0x0030, 0x0100, 0x0320, 0x0730])
def test_a_device_that_uses_the_time_only_generates_no_signal(word):
    """Dc/@TimeLoopControlOnly: no SYNC and no LATCH."""
    op_mode = OpMode(assign_activate=word)
    for absent in (None, False):
        assert generated_signals(op_mode, absent) == sync_signals(word)
    found = generated_signals(op_mode, True)
    assert (found.dc_active, found.time_only) == (bool(word & 0x0100), bool(word & 0x0100))
    assert not found.sync0
    assert not found.sync1


def test_a_cycle_time_is_no_signal():
    mode = (
        "<OpMode><Name>S0</Name><AssignActivate>#x0300</AssignActivate><CycleTimeSync1>1000</CycleTimeSync1></OpMode>"
    )
    (op_mode,) = only_device(esi(device(f"<Dc>{mode}</Dc>"))).op_modes
    assert op_mode.cycle_time_sync1_ns == 1000
    assert sync_signals(op_mode.assign_activate).sync1 is False


@pytest.mark.parametrize(
    ("modes", "default"),
    [
        ([], None),
        ([""], 0),
        (["", 'IgnoreFromBuildNo="100"'], 0),
        (['IgnoreFromBuildNo="100"', ""], 1),
        (['IgnoreFromBuildNo="100"', 'IgnoreFromBuildNo="100"', 'UseFromBuildNo="100"', ""], 2),
        (['IgnoreFromBuildNo="100"'], 0),
    ],
)
def test_the_default_op_mode_is_the_first_valid_one(modes, default):
    xml = "".join(
        f"<OpMode><Name>m</Name><AssignActivate>0</AssignActivate>"
        f"<VendorSpecific><TwinCAT {mode}/></VendorSpecific></OpMode>"
        for mode in modes
    )
    op_modes = only_device(esi(device(f"<Dc>{xml}</Dc>"))).op_modes
    assert default_position(op_modes) == default
    assert default_op_mode(op_modes, ()) is (op_modes[default] if default is not None else None)


NAMED = ("DC", 'IgnoreFromBuildNo="100"'), ("SM", ""), ("DC", ""), ("", "")


@pytest.mark.parametrize(("asked", "position"), [("DC", 2), ("SM", 1), ("DCx", 1), (None, 1)])
def test_a_module_asks_for_the_first_valid_op_mode_of_a_name(asked, position):
    assert default_position(named_modes(), [Module(dc_op_mode_name=asked)]) == position


def test_an_op_mode_is_chosen_by_its_name_where_that_is_its_own():
    assert [op_mode_choice(named_modes(), position) for position in range(4)] == ["0", "SM", "2", "3"]


def test_a_name_that_looks_like_a_position_is_a_name():
    """The OpMode at that position is chosen by ``#1``, which is always a position."""
    modes = [OpMode(name="1"), OpMode(), OpMode(name="#0"), OpMode(name=" 3 ")]
    choices = [op_mode_choice(modes, position) for position in range(4)]
    assert choices == ["1", "#1", "2", "3"]
    assert [chosen_positions(modes, choice) for choice in choices] == [[0], [1], [2], [3]]
    assert chosen_positions(modes, "#0") == [0]


@given(st.lists(st.sampled_from(["", "0", "1", "#0", "#1", "DC", " DC", "٠"]), min_size=1, max_size=4))
def test_what_chooses_an_op_mode_means_it(names):
    modes = [OpMode(name=name) for name in names]
    for position in range(len(modes)):
        assert chosen_positions(modes, op_mode_choice(modes, position)) == [position]


def named_modes() -> tuple[OpMode, ...]:
    xml = "".join(
        f"<OpMode><Name>{name}</Name><AssignActivate>0</AssignActivate>"
        f"<VendorSpecific><TwinCAT {mode}/></VendorSpecific></OpMode>"
        for name, mode in NAMED
    )
    return only_device(esi(device(f"<Dc>{xml}</Dc>"))).op_modes


@pytest.mark.parametrize(
    ("control", "mode", "direction", "ecat", "pdi", "watchdog"),
    [
        (0x26, "mailbox", "output", False, True, False),
        (0x22, "mailbox", "input", False, True, False),
        (0x24, "buffered", "output", False, True, False),
        (0x64, "buffered", "output", False, True, True),
        (0x44, "buffered", "output", False, False, True),
        (0x04, "buffered", "output", False, False, False),
        (0x20, "buffered", "input", False, True, False),
        (0x00, "buffered", "input", False, False, False),
        (0x36, "mailbox", "output", True, True, False),
        (0x32, "mailbox", "input", True, True, False),
        (0x74, "buffered", "output", True, True, True),
        (0x30, "buffered", "input", True, True, False),
        (0x01, None, "input", False, False, False),
        (0x08, "buffered", None, False, False, False),
    ],
)
def test_control_bytes(control, mode, direction, ecat, pdi, watchdog):
    found = sm_facts(SyncManager(control_byte=control))
    assert (found.buffer_mode, found.transfer_direction) == (mode, direction)
    assert (found.ecat_interrupt, found.pdi_interrupt, found.watchdog_trigger) == (ecat, pdi, watchdog)


def test_an_absent_control_byte_says_nothing():
    found = sm_facts(SyncManager(usage="Outputs"))
    assert (found.buffer_mode, found.watchdog_trigger) == (None, None)
