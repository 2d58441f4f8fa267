"""Comparison of the distributed clocks: OpModes, their signals, times and PDO lists, and which one is the default."""

from collections.abc import Iterator
from operator import itemgetter

from esicatalog.esi.records.dc import OpMode, OpModePdo
from esicatalog.esi.records.device import Device
from esicatalog.model.compare_facts import (
    DC,
    Difference,
    Fact,
    always,
    compare_facts,
    compare_whole,
    difference,
    either,
    fact_words,
    gained,
    lost,
    matched,
    matched_in_steps,
    never,
)
from esicatalog.model.compare_words import (
    h4,
    listed,
    ns,
    supported,
    text,
    value_of,
    yes_no,
)
from esicatalog.model.sync import default_position, op_mode_at, sync_signals
from esicatalog.words import index_words

_SIGNALS = {
    "dc_active": "sync unit active",
    "sync0": "SYNC0",
    "sync1": "SYNC1",
    "sync_unit_pdi": "sync unit to PDI",
    "latch0_pdi": "latch 0 to PDI",
    "latch1_pdi": "latch 1 to PDI",
}


def _assign_activate(value: int | str | None) -> str | None:
    if not isinstance(value, int):
        return value
    signals = sync_signals(value)
    words = [name for field, name in _SIGNALS.items() if getattr(signals, field)]
    return f"{h4(value)} ({', '.join(words) or ('no DC' if signals.dc_active is False else 'unknown')})"


def _op_mode_pdo(pdo: OpModePdo) -> str:
    return index_words(pdo.pdo_index) + (f" {pdo.os_fac} times" if pdo.os_fac is not None else "")


def _time(value: int | str | None) -> str | None:
    """A time; 0 says as much as an absent one."""
    return ns(value) if value else None


def _factor(value: int | str | None) -> str | None:
    """A factor; 0 says as much as an absent one."""
    return text(value) if value else None


_CLOCK = (
    Fact("dc", "Dc", lost, supported),
    Fact("dc_unknown_frmw", "UnknownFRMW", gained, yes_no),
    Fact("dc_unknown_64bit", "Unknown64Bit", gained, yes_no),
    Fact("dc_external_ref_clock", "ExternalRefClock", always, yes_no),
    Fact("dc_potential_reference_clock", "PotentialReferenceClock", lost, yes_no),
    Fact("dc_time_loop_control_only", "TimeLoopControlOnly", always, yes_no),
    Fact("dc_pdo_oversampling", "PdoOversampling", always, yes_no),
    Fact("dc_vendor_specific", "VendorSpecific of Dc", never),
)
_OP_MODE = (
    Fact("assign_activate", "AssignActivate", always, _assign_activate),
    Fact("activate_additional", "ActivateAdditional", always, h4),
    Fact("cycle_time_sync0_ns", "CycleTimeSync0", always, _time),
    Fact("cycle_time_sync0_factor", "CycleTimeSync0 Factor", always, _factor),
    Fact("shift_time_sync0_ns", "ShiftTimeSync0", always, _time),
    Fact("shift_time_sync0_factor", "ShiftTimeSync0 Factor", always, _factor),
    Fact("shift_time_sync0_input", "ShiftTimeSync0 Input", always, yes_no),
    Fact("shift_time_sync0_output_delay_ns", "ShiftTimeSync0 OutputDelayTime", always, _time),
    Fact("shift_time_sync0_input_delay_ns", "ShiftTimeSync0 InputDelayTime", always, _time),
    Fact("cycle_time_sync1_ns", "CycleTimeSync1", always, _time),
    Fact("cycle_time_sync1_factor", "CycleTimeSync1 Factor", always, _factor),
    Fact("shift_time_sync1_ns", "ShiftTimeSync1", always, _time),
    Fact("shift_time_sync1_factor", "ShiftTimeSync1 Factor", always, _factor),
    Fact("shift_time_sync1_input", "ShiftTimeSync1 Input", always, yes_no),
    Fact("shift_time_sync1_output_delay_ns", "ShiftTimeSync1 OutputDelayTime", always, _time),
    Fact("shift_time_sync1_input_delay_ns", "ShiftTimeSync1 InputDelayTime", always, _time),
    Fact("cycle_time_sync2_ns", "CycleTimeSync2", always, _time),
    Fact("cycle_time_sync2_factor", "CycleTimeSync2 Factor", always, _factor),
    Fact("shift_time_sync2_ns", "ShiftTimeSync2", always, _time),
    Fact("cycle_time_sync3_ns", "CycleTimeSync3", always, _time),
    Fact("cycle_time_sync3_factor", "CycleTimeSync3 Factor", always, _factor),
    Fact("shift_time_sync3_ns", "ShiftTimeSync3", always, _time),
)
_OP_MODE_SM = (
    Fact("pdos", "PDOs", always, listed(_op_mode_pdo)),
    Fact("sync_type", "SyncType", always),
    Fact("cycle_time_ns", "CycleTime", always, _time),
    Fact("cycle_time_factor", "CycleTime Factor", always, _factor),
    Fact("shift_time_ns", "ShiftTime", always, _time),
    Fact("min_after_sync_ns", "MinAfterSync", always, _time),
    Fact("min_before_frame_ns", "MinBeforeFrame", always, _time),
)
_OP_MODE_TEXTS = (
    Fact("name", "name", never),
    Fact("description", "description", never),
    Fact("vendor_specific", "VendorSpecific", never),
)


def compare_clocks(left: Device, right: Device) -> Iterator[Difference]:
    """Flags of Dc, the default OpMode, their order, and all OpModes.

    OpModes are matched by name, those left over by equal content: a new name alone does not count, nor does an OpMode
    that only the right one has, unless it is the default.
    """
    yield from compare_facts(DC, "", left, right, _CLOCK)
    if left.op_modes == right.op_modes:
        return
    pairs = _matched_modes(left.op_modes, right.op_modes)
    yield from _compare_default(left, right, pairs)
    yield from _compare_order(left, right, pairs)
    for ours, theirs in pairs:
        if ours is None or theirs is None:
            yield from compare_whole(DC, f"OpMode {either(ours, theirs).name}", ours, theirs, _OP_MODE, lost)
            continue
        place = f"OpMode {ours.name if ours.name == theirs.name else _assign_activate(ours.assign_activate)}"
        yield from compare_facts(DC, place, ours, theirs, _OP_MODE + _OP_MODE_TEXTS)
        for own, other in matched(ours.sm_assignments, theirs.sm_assignments, lambda item: value_of(item, "no")):
            yield from compare_whole(DC, f"{place} SM{value_of(either(own, other), 'no')}", own, other, _OP_MODE_SM)


def _matched_modes(left: tuple[OpMode, ...], right: tuple[OpMode, ...]) -> list[tuple[OpMode | None, OpMode | None]]:
    """By name, of several with one name those with equal content first; those left over by equal content."""
    return matched_in_steps(
        left, right, lambda mode: (mode.name, _content(mode)), lambda mode: mode.name, lambda mode: _content(mode)
    )


def _content(mode: OpMode) -> tuple[str, ...]:
    return fact_words(mode, _OP_MODE), *(
        f"SM{value_of(item, 'no')} {fact_words(item, _OP_MODE_SM)}" for item in mode.sm_assignments
    )


def _compare_order(
    left: Device, right: Device, pairs: list[tuple[OpMode | None, OpMode | None]]
) -> Iterator[Difference]:
    """The order of those that both have: a choice by position means another one."""
    before, after = ({id(mode): at for at, mode in enumerate(device.op_modes)} for device in (left, right))
    both = [(mode.name, before[id(mode)], after[id(other)]) for mode, other in pairs if mode and other]
    said, also = (", ".join(f"{item[0]}" for item in sorted(both, key=itemgetter(side))) for side in (1, 2))
    if said != also:
        yield difference(DC, "OpMode order", said, also, False)


def _compare_default(
    left: Device, right: Device, pairs: list[tuple[OpMode | None, OpMode | None]]
) -> Iterator[Difference]:
    """The default OpMode; it counts where the clocks are in use on a side."""
    ours, theirs = (default_position(device.op_modes) for device in (left, right))
    mode, other = (op_mode_at(device.op_modes, position) for device, position in ((left, ours), (right, theirs)))
    if any(item is mode and counterpart is other for item, counterpart in pairs):
        return
    said, also = (
        f"{item.name} (position {position}), {', '.join(_content(item))}" if item is not None else None
        for item, position in ((mode, ours), (other, theirs))
    )
    active = any(item is not None and sync_signals(item.assign_activate).dc_active for item in (mode, other))
    yield difference(DC, "default OpMode", said, also, active)
