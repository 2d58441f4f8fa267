"""Start-up commands that write the CiA 402 mode (0x6060), what speaks against them, and where nothing writes it."""

from collections.abc import Iterator, Sequence

from esicatalog.esi.records.mailbox import coe_init_cmds
from esicatalog.esi.records.pdo import RX_PDO
from esicatalog.export.entry_types import ObjectTable
from esicatalog.export.init_cmds import StartCommand
from esicatalog.model.cia402 import (
    AXIS_STEP,
    CONTROLWORD,
    DRIVE_MODES,
    MODE_BY_CODE,
    MODES_OF_OPERATION,
    MODES_OF_OPERATION_OF_AXES,
)
from esicatalog.model.drive_evidence import mode_code, module_names, name_against, written_mode
from esicatalog.model.drive_recipe import unset_mode_words
from esicatalog.model.pdo_facts import carries_value
from esicatalog.model.process_image import SmImage
from esicatalog.model.slots import ExpandedModule
from esicatalog.model.start_up import after_start, start_command

_COMMANDING = frozenset({CONTROLWORD, *(index for mode in DRIVE_MODES.values() for index in mode.setpoints)})
"""What a master sends to a drive that runs a mode; some drives have setpoints of their vendor's."""


def started_modes(commands: Sequence[StartCommand]) -> dict[int, bytes]:
    """What 0x6060 holds after the start-up commands, by its index on each axis."""
    return after_start(
        (command.transition, command.object_index, command.data)
        for command in commands
        if command.protocol == "CoE"
        and command.object_index in MODES_OF_OPERATION_OF_AXES
        and not (command.subindex or command.complete_access)
    )


def mode_remarks(
    commands: Sequence[StartCommand],
    axes: Sequence[int],
    expanded: Sequence[ExpandedModule],
    images: Sequence[SmImage],
    objects: ObjectTable,
) -> Iterator[str]:
    """Modes that modules start against their names, that the process data replace, and that nothing sets."""
    yield from _against_names(expanded, [MODES_OF_OPERATION + axis * AXIS_STEP for axis in axes])
    mapped = {
        item.entry.entry_index
        for image in images
        for placed in image.pdos
        for item in placed.entries
        if placed.direction == RX_PDO and not item.entry.subindex and carries_value(item.entry)
    }
    started = started_modes(commands)
    for axis in axes:
        index = MODES_OF_OPERATION + axis * AXIS_STEP
        is_commanded = any(commanding + axis * AXIS_STEP in mapped for commanding in _COMMANDING)
        declared = objects.entry(index, 0)
        is_preset = declared is not None and bool(declared.default_int)
        if is_commanded and index not in mapped and index not in started and not is_preset:
            yield f"{unset_mode_words(index, 'the mode that is wanted', declared)}, for no start-up command does"
    for index, data in started.items():
        if index in mapped:
            code = mode_code(data)
            mode = MODE_BY_CODE.get(code)
            what = f"{code} ({mode.name})" if mode is not None else f"{code}"
            yield (
                f"0x{index:04X} is mapped: the cyclic value replaces the {what} of the start-up command, so write the "
                "mode that is wanted there from the first cycle on"
            )


def _against_names(expanded: Sequence[ExpandedModule], of_axes: Sequence[int]) -> Iterator[str]:
    """What rule L57 finds, for the modules that are plugged."""
    for item in expanded:
        commands, name = coe_init_cmds(item.module.mailbox), module_names(item.module)
        for index in of_axes:
            command = start_command(commands, index)
            mode = written_mode(command, index) if command is not None else None
            if mode is not None and (against := name_against(name, mode)):
                yield (
                    f"slot {item.slot_number}: the start-up command writes 0x{index:04X} = {mode.code} ({mode.name}), "
                    f"but the module's name {name!r} {against}: check which mode is meant before the drive is "
                    "enabled"
                )
