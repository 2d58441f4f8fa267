"""How to run a drive mode: what to plug, which RxPDO maps the setpoint, which OpMode, and where 0x6060 is set.

A recipe asks for nothing that the description rules out: where no RxPDO has the setpoint and none can be given it, it
says so instead.
"""

from collections.abc import Collection, Sequence
from typing import NamedTuple

from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.access import states_to_write
from esicatalog.model.assignable_pdos import NO_PDO_ASSIGN, declares_pdo_assign
from esicatalog.model.axis_outputs import axis_outputs, no_controlword_words
from esicatalog.model.cia402 import MAX_AXES, MODES_OF_OPERATION, DriveMode
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.drive_choice import chosen_with
from esicatalog.model.drive_evidence import mode_code
from esicatalog.model.drive_parts import (
    Part,
    assigned_rx_pdos,
    is_declared,
    mapped_setpoint_words,
    mapped_words,
    mapping_pdo,
    mapping_pdos,
    mapping_words,
    may_be_mapped,
    object_words,
    pdo_words,
    setpoint_words,
    single_value,
    unusable_entry,
)
from esicatalog.model.drive_setup import ConfiguredDrive, DriveSetup
from esicatalog.model.pdo_mapping import mapping_obstacle
from esicatalog.model.start_up import BEFORE_SAFE_OP, START_TRANSITIONS, start_command, written_data


class Recipe(NamedTuple):
    """What it takes to run a mode."""

    pdos: tuple[Pdo, ...]
    """The RxPDOs that map the setpoint."""
    pdos_are_default: bool
    """Whether they are assigned with its modules and OpMode, without being chosen."""
    op_mode: str | None
    """What chooses the OpMode: its name or position, as exports take it."""
    words: str


def mode_recipe(drive: ConfiguredDrive, mode: DriveMode, parts: Sequence[Part], plug: str | None) -> Recipe:
    """The recipe for a mode of the parts that act together, a module last; ``plug`` says where that goes."""
    setup = drive.setup(mode, parts)
    usable = [_usable(part, mode, setup) for part in parts]
    part, pdos = _mapping(usable, mode)
    are_default = all(pdo in part.assigned for pdo in pdos)
    chosen = [] if are_default else chosen_with(pdos, part.axis, setup)
    assigned = setup.rx_pdos(chosen)
    setpoint = _setpoint(mode, parts, usable, chosen, setup) if mode.setpoints else None
    steps = (
        plug,
        setpoint,
        _controlword(part, assigned, setup) if pdos else None,
        _axes_left_out(part.axis, setup.rx_pdos(()), assigned) if chosen else None,
        setup.op_mode_words,
        _mode_of_operation(mode, parts, (*pdos, *assigned), (*pdos, *chosen), setup),
    )
    return Recipe(tuple(pdos), are_default, setup.op_mode_choice, "; ".join(step for step in steps if step is not None))


def unset_mode_words(index: int, mode: int | str, declared: ObjectEntry | None) -> str:
    """What is to be done where 0x6060 of an axis, ``index``, is not among the process data.

    ``declared`` is what a dictionary says of it: a drive aborts the download of an object that is read-only.
    """
    where = f"0x{index:04X} is in none of the assigned RxPDOs"
    if _is_read_only(declared):
        return f"{where}, and read-only by the description: nothing that is described sets {mode} there"
    return f"{where}: write {mode} to it before operation"


def _usable(part: Part, mode: DriveMode, setup: DriveSetup) -> Part:
    """The part with what is assigned once in a setup, and without the RxPDOs of the setpoint that cannot be."""
    assigned = assigned_rx_pdos(setup.images, part.slot_number)
    in_setup = part._replace(assigned=tuple([pdo for pdo in assigned if pdo.pdo_index not in setup.repeated]))
    setpoint = {part.at(index) for index in mode.setpoints}
    ruled_out = [
        pdo
        for pdo in part.rx_pdos
        if any(entry.entry_index in setpoint for entry in pdo.entries) and _obstacle(pdo, setpoint, in_setup, setup)
    ]
    return in_setup._replace(rx_pdos=tuple([pdo for pdo in part.rx_pdos if pdo not in ruled_out]))


def _obstacle(pdo: Pdo, setpoint: Collection[int], part: Part, setup: DriveSetup) -> str | None:
    """Why the setpoint in an RxPDO of a part, as it is in a setup, is of no use, as the end of a sentence."""
    unusable = unusable_entry(pdo, setpoint)
    return setup.obstacle(pdo) if unusable is None and pdo not in part.assigned else unusable


def _mapping(parts: Sequence[Part], mode: DriveMode) -> tuple[Part, Sequence[Pdo]]:
    """The part whose RxPDOs map the setpoint, with them; of several the module."""
    return next(((part, pdos) for part in reversed(parts) if (pdos := mapping_pdos(part, mode))), (parts[-1], ()))


def _setpoint(
    mode: DriveMode, parts: Sequence[Part], usable: Sequence[Part], chosen: Sequence[Pdo], setup: DriveSetup
) -> str:
    """Which RxPDOs have the setpoint, what to choose where they are not assigned, or why none has it."""
    part, pdos = _mapping(usable, mode)
    if pdos:
        words = f"{mapping_words(pdos)} the setpoint"
        if (mapped := mapped_setpoint_words(part, mode, pdos)) != setpoint_words(part, mode):
            words += f" as {mapped}"
        if not chosen:
            return words
        choice = f"choose --pdo {','.join(f'0x{pdo.pdo_index or 0:04X}' for pdo in chosen)}"
        if any(pdo.pdo_index in setup.repeated for pdo in pdos):
            return f"{words}; assigned twice {setup.assigning}, which no export makes: {choice}"
        subject = "it is not" if len(pdos) == 1 else "not all are"
        doubt = "" if declares_pdo_assign(setup.device) else f", and {NO_PDO_ASSIGN}"
        rivals: dict[int, list[int]] = {}
        for item in setup.beside(chosen):
            rivals.setdefault(item.sm, []).append(item.pdo_index)
        others = [f"; choose the PDOs of SM{sm} too, without {object_words(indices)}" for sm, indices in rivals.items()]
        return f"{words}; {subject} assigned {setup.assigning}{doubt}: {choice}{''.join(others)}"
    objects = setpoint_words(parts[-1], mode)
    problem = _mapping_problem(mode, usable, setup)
    if problem is None:
        return f"map the setpoint {objects} into an RxPDO"
    of_part, described = _mapping(parts, mode)
    in_setup = usable[parts.index(of_part)]
    for pdo in [pdo for pdo in described if pdo not in in_setup.rx_pdos]:
        held = [index for index in map(of_part.at, mode.setpoints) if mapping_pdo(index, [pdo]) is not None]
        return f"no setpoint: {pdo_words(pdo)} has {object_words(held)}, but {_obstacle(pdo, held, in_setup, setup)}"
    return problem


def _mapping_problem(mode: DriveMode, parts: Sequence[Part], setup: DriveSetup) -> str | None:
    """Why no RxPDO can be given a setpoint that none maps as a whole, by the rules for choosing entries of PDOs."""
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
    obstacles = dict.fromkeys(mapping_obstacle(setup.device, pdo) for pdo in rx_pdos)
    if None not in obstacles:
        why = " or ".join(f"its mapping {obstacle}" for obstacle in obstacles)
        return f"no setpoint: no RxPDO has {objects}, and none can be given it: {why}"
    if barred:
        return f"no RxPDO has the setpoint {objects}, and without a dictionary nothing says that it can be mapped"
    return None


def _controlword(part: Part, assigned: Sequence[Pdo], setup: DriveSetup) -> str | None:
    """That the controlword is not assigned beside the setpoint."""
    outputs = axis_outputs(part.axis, assigned)
    if not outputs.lacks_controlword:
        return None
    return no_controlword_words(outputs, setup.available, assigned)


def _axes_left_out(own_axis: int, before: Sequence[Pdo], after: Sequence[Pdo]) -> str | None:
    """That what is chosen for an axis takes its controlword from another one."""
    had, have = ([axis_outputs(axis, pdos).has_controlword for axis in range(MAX_AXES)] for pdos in (before, after))
    lost = [str(axis) for axis in range(MAX_AXES) if axis != own_axis and had[axis] and not have[axis]]
    return f"axis {' and '.join(lost)} then has no controlword" if lost else None


def _mode_of_operation(
    mode: DriveMode, parts: Sequence[Part], candidates: Sequence[Pdo], named: Sequence[Pdo], setup: DriveSetup
) -> str:
    """Where 0x6060 is set: process data overwrite in every cycle what an InitCmd or the user wrote once.

    Of the ``candidates`` the first that has it counts; how those come to be assigned that are ``named`` is said before.
    """
    index = parts[-1].at(MODES_OF_OPERATION)
    pdo = mapping_pdo(index, candidates)
    if pdo is not None:
        how = "" if pdo in named else f" (assigned {setup.assigning})"
        unusable = unusable_entry(pdo, (index,))
        step = f": set it to {mode.code}" if unusable is None else f", but {unusable}"
        return f"{mapped_words(parts[-1], index, [pdo])} is mapped in {pdo_words(pdo)}{how}{step}"
    code = _written_code(setup, index, START_TRANSITIONS)
    if code == mode.code:
        written = f"0x{index:04X} = {mode.code} is written by an InitCmd"
        is_early = _written_code(setup, index, BEFORE_SAFE_OP) == code
        late = f"{written} of SO: call send_so() of an export that has it (IgH, SOEM, pysoem), else write {code} to it"
        return written if is_early else f"{late} before operation"
    declared = next((entry for part in parts if (entry := single_value(part, index)) is not None), None)
    if code is None:
        return unset_mode_words(index, mode.code, declared)
    doubt = " (read-only by the description)" if _is_read_only(declared) else ""
    return f"{unset_mode_words(index, mode.code, None)}, after the InitCmd that writes {code}{doubt}"


def _written_code(setup: DriveSetup, index: int, transitions: Collection[str]) -> int | None:
    """The mode that InitCmds have written to 0x6060 after some transitions of a start."""
    command = start_command(setup.commands, index, transitions)
    data = written_data(command, index) if command is not None else None
    return mode_code(data) if data is not None else None


def _is_read_only(declared: ObjectEntry | None) -> bool:
    return declared is not None and not states_to_write(declared.access_word)
