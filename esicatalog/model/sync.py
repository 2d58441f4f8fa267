"""SYNC signals and clocks of an OpMode, from AssignActivate (ESI-FACTS sections 11 and 17).

AssignActivate is written to the registers 0x0980 (low byte) and 0x0981 (high byte) of the slave controller.
SYNC1 needs bit 0x0400 and the unit's bit 0x0100; a CycleTimeSync1 alone says nothing.
"""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Annotated

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.twincat import is_superseded
from esicatalog.sii.codes import AssignActivate

ASSIGN_ACTIVATE = range(0x1_0000)
"""What the registers 0x0980 and 0x0981 can hold."""


class SyncSignals(Record):
    """What AssignActivate of an OpMode asks for; :func:`generated_signals` are those that a device then generates."""

    dc_active: Annotated[bool | None, Doc("Sync unit is active (0x0100); 0 = free run or SM synchronous")] = None
    sync0: Annotated[bool | None, Doc("AssignActivate asks for SYNC0: 0x0100 and 0x0200")] = None
    sync1: Annotated[bool | None, Doc("AssignActivate asks for SYNC1: 0x0100 and 0x0400")] = None
    time_only: Annotated[bool | None, Doc("Sync unit active without pulses: DC time or latch use")] = None
    sync_unit_pdi: Annotated[bool | None, Doc("Sync unit is controlled by the slave (0x0001)")] = None
    latch0_pdi: Annotated[bool | None, Doc("Latch 0 is controlled by the slave (0x0010)")] = None
    latch1_pdi: Annotated[bool | None, Doc("Latch 1 is controlled by the slave (0x0020)")] = None


@lru_cache(1_000)
def sync_signals(assign_activate: int | None) -> SyncSignals:
    """Decode AssignActivate; everything is None when it is not given, or is none that its registers can hold."""
    if assign_activate is None or assign_activate not in ASSIGN_ACTIVATE:
        return SyncSignals()
    active = bool(assign_activate & AssignActivate.SYNC_UNIT)
    return SyncSignals(
        dc_active=active,
        sync0=active and bool(assign_activate & AssignActivate.SYNC0),
        sync1=active and bool(assign_activate & AssignActivate.SYNC1),
        time_only=active and not assign_activate & (AssignActivate.SYNC0 | AssignActivate.SYNC1),
        sync_unit_pdi=bool(assign_activate & AssignActivate.SYNC_UNIT_PDI),
        latch0_pdi=bool(assign_activate & AssignActivate.LATCH0_PDI),
        latch1_pdi=bool(assign_activate & AssignActivate.LATCH1_PDI),
    )


def generated_signals(op_mode: OpMode, time_loop_control_only: bool | None) -> SyncSignals:
    """The signals that a device generates in an OpMode.

    With Dc/@TimeLoopControlOnly it uses the DC time alone, no SYNC and no LATCH signal (ESI-FACTS section 11).
    """
    signals = sync_signals(op_mode.assign_activate)
    if not time_loop_control_only or signals.dc_active is None:
        return signals
    return SyncSignals(
        dc_active=signals.dc_active,
        sync0=False,
        sync1=False,
        time_only=signals.dc_active,
        sync_unit_pdi=False,
        latch0_pdi=False,
        latch1_pdi=False,
    )


def listed_pdos(op_modes: Iterable[OpMode]) -> set[int]:
    """Indices of the PDOs that OpModes assign themselves."""
    pdos = [pdo for mode in op_modes for item in mode.sm_assignments for pdo in item.pdos]
    return {pdo.pdo_index for pdo in pdos if pdo.pdo_index is not None}


def valid_op_modes(op_modes: Sequence[OpMode]) -> Sequence[OpMode]:
    """The OpModes that newer tools do not ignore; all when they would ignore all."""
    return [mode for mode in op_modes if not is_superseded(mode)] or op_modes


def positions_with_sync0(device: Device) -> list[int]:
    """Positions of the OpModes that generate SYNC0 and are not superseded (ESI-FACTS section 11)."""
    time_only = device.dc_time_loop_control_only
    return [
        position
        for position, op_mode in enumerate(device.op_modes)
        if generated_signals(op_mode, time_only).sync0 and not is_superseded(op_mode)
    ]


def default_op_mode(op_modes: Sequence[OpMode], modules: Iterable[Module]) -> OpMode | None:
    """The OpMode that counts without a choice: the one at :func:`default_position`."""
    return op_mode_at(op_modes, default_position(op_modes, modules))


def op_mode_at(op_modes: Sequence[OpMode], position: int | None) -> OpMode | None:
    """The OpMode at a position that one of the functions below gave, None where there is none."""
    return op_modes[position] if position is not None else None


def default_position(op_modes: Sequence[OpMode], modules: Iterable[Module] = ()) -> int | None:
    """Position of the default OpMode: the first that plugged modules ask for, else the first valid one."""
    for position in asked_op_modes(op_modes, modules).values():
        if position is not None:
            return position
    return _first_valid(op_modes, range(len(op_modes)))


def asked_op_modes(op_modes: Sequence[OpMode], modules: Iterable[Module]) -> dict[str, int | None]:
    """The names that modules ask for (DcOpModeName), each with the position of its OpMode (ESI-FACTS section 12).

    Of several OpModes of one name the first valid one is meant. None for a name that no OpMode has.
    """
    asked = dict.fromkeys(module.dc_op_mode_name for module in modules if module.dc_op_mode_name)
    return {
        name: _first_valid(op_modes, [position for position, mode in enumerate(op_modes) if mode.name == name])
        for name in asked
    }


def _first_valid(op_modes: Sequence[OpMode], positions: Sequence[int]) -> int | None:
    """The first of some OpModes that is not superseded, the first of all where each is; None without any."""
    valid = (position for position in positions if not is_superseded(op_modes[position]))
    return next(valid, positions[0] if positions else None)


def chosen_positions(op_modes: Sequence[OpMode], wanted: str) -> list[int]:
    """Positions of the OpModes that a choice means; more than one for a name that several have.

    A choice is a position written ``#1``, else a name, else a position that is nobody's name.
    """
    positions, text = range(len(op_modes)), wanted.strip()
    readings = (
        [position for position in positions if text == f"#{position}"],
        [position for position in positions if text and text == _chosen_name(op_modes[position])],
        [position for position in positions if text == str(position)],
    )
    return next(filter(None, readings), [])


def op_mode_choice(op_modes: Sequence[OpMode], position: int) -> str:
    """What chooses an OpMode: its name, its position where that is no choice, ``#1`` where a name looks like it."""
    choices = (_chosen_name(op_modes[position]), str(position))
    return next((text for text in choices if chosen_positions(op_modes, text) == [position]), f"#{position}")


def _chosen_name(op_mode: OpMode) -> str:
    return (op_mode.name or "").strip()
