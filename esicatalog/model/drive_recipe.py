"""How to run a drive mode: what to plug, which RxPDO maps the setpoint, which OpMode, and where 0x6060 is set.

A recipe asks for nothing that the description rules out: where no RxPDO has the setpoint and none can be given it, it
says so instead.
"""

from collections.abc import Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.cia402 import MODES_OF_OPERATION, DriveMode
from esicatalog.model.drive_evidence import written_mode
from esicatalog.model.drive_parts import (
    Part,
    is_declared,
    mapping_pdo,
    mapping_pdos,
    mapping_words,
    may_be_mapped,
    object_words,
    pdo_words,
    setpoint_words,
)
from esicatalog.model.pdo_facts import symmetric_exclusions
from esicatalog.model.pdo_mapping import mapping_obstacle
from esicatalog.model.sync import default_op_mode, op_modes_with_sync0


class Recipe(NamedTuple):
    """What it takes to run a mode."""

    pdos: tuple[Pdo, ...]
    """The RxPDOs that map the setpoint."""
    pdos_are_default: bool
    op_mode: str | None
    words: str


def mode_recipe(device: Device, mode: DriveMode, parts: Sequence[Part], plug: str | None = None) -> Recipe:
    """The recipe for a mode of the parts that act together, a module last; ``plug`` says where that goes."""
    part, pdos = next(((part, pdos) for part in reversed(parts) if (pdos := mapping_pdos(part, mode))), (parts[-1], []))
    are_default = all(pdo in part.assigned for pdo in pdos)
    if pdos:
        subject = "it is not" if len(pdos) == 1 else "not all are"
        assigned = "" if are_default else f"; {subject} assigned by default"
        setpoint: str | None = f"{mapping_words(pdos)} the setpoint{assigned}"
    else:
        setpoint = _to_be_mapped(device, mode, parts) if mode.setpoints else None
    op_mode = parts[-1].dc_op_mode_name or _op_mode(device, mode)
    chosen = f"OpMode {op_mode!r}" if op_mode is not None else None
    steps = (plug, setpoint, chosen, _mode_of_operation(mode, parts, pdos))
    return Recipe(tuple(pdos), are_default, op_mode, "; ".join(step for step in steps if step is not None))


def _to_be_mapped(device: Device, mode: DriveMode, parts: Sequence[Part]) -> str:
    """What is to do about a setpoint that no RxPDO maps as a whole, by the rules for choosing entries of PDOs."""
    part = parts[-1]
    rx_pdos = [pdo for item in parts for pdo in item.rx_pdos if not pdo.virtual]
    missing = [index for index in map(part.at, mode.setpoints) if mapping_pdo(index, rx_pdos) is None]
    barred = [index for index in missing if not any(may_be_mapped(item, index) for item in parts)]
    unknown = [index for index in barred if not any(is_declared(item, index) for item in parts)]
    has_dictionary = any(item.views for item in parts)
    if unknown and has_dictionary:
        return f"no setpoint: neither an RxPDO nor the dictionary has {object_words(unknown)}"
    if barred and has_dictionary:
        return f"no setpoint: no RxPDO has {object_words(barred)}, and the dictionary lets it into none"
    objects = setpoint_words(part, mode)
    if not rx_pdos:
        return f"no setpoint: the file describes no RxPDO to map {objects} into"
    obstacles = dict.fromkeys(mapping_obstacle(device.mailbox, pdo) for pdo in rx_pdos)
    if None not in obstacles:
        why = " or ".join(f"its mapping {obstacle}" for obstacle in obstacles)
        return f"no setpoint: no RxPDO has {objects}, and none can be given it: {why}"
    if barred:
        return f"no RxPDO has the setpoint {objects}, and without a dictionary nothing says that it can be mapped"
    return f"map the setpoint {objects} into an RxPDO"


def _op_mode(device: Device, mode: DriveMode) -> str | None:
    """OpMode to choose: for cyclic modes the first valid one with SYNC0, else the default."""
    with_sync0 = op_modes_with_sync0(device) if mode.cyclic else []
    chosen = with_sync0[0] if with_sync0 else default_op_mode(device.op_modes)
    return chosen.name if chosen is not None else None


def _mode_of_operation(mode: DriveMode, parts: Sequence[Part], pdos: Sequence[Pdo]) -> str:
    """Where 0x6060 is set: process data overwrite in every cycle what an InitCmd or the user wrote once.

    Looked for beside the setpoint first, then in what is assigned by default and may stay so beside it.
    """
    rivals = symmetric_exclusions(pdo for part in parts for pdo in part.rx_pdos)
    excluded = {index for pdo in pdos for index in rivals.get(pdo.pdo_index, ())}
    for part in reversed(parts):
        index = part.at(MODES_OF_OPERATION)
        staying = [pdo for pdo in part.assigned if pdo.pdo_index not in excluded]
        for candidates, how in ((pdos, ""), (staying, " (assigned by default)")):
            if (pdo := mapping_pdo(index, candidates)) is not None:
                return f"0x{index:04X} is mapped in {pdo_words(pdo)}{how}: set it to {mode.code}"
    index = parts[-1].at(MODES_OF_OPERATION)
    if any(written_mode(command, index) is mode for part in parts for command in part.init_cmds):
        return f"0x{index:04X} = {mode.code} is written by an InitCmd"
    return f"0x{index:04X} is in none of the assigned RxPDOs: write {mode.code} to it before operation"
