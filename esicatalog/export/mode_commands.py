"""What sets the mode of CiA 402 axes (0x6060): start-up commands, process data or a default, and where nothing does."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.records.mailbox import coe_init_cmds
from esicatalog.export.entry_types import ObjectTable
from esicatalog.export.init_cmds import StartCommand
from esicatalog.model.axis_outputs import AxisOutputs, axis_outputs
from esicatalog.model.cia402 import (
    AXIS_STEP,
    MAX_AXES,
    MODE_BY_CODE,
    MODES_OF_OPERATION,
    MODES_OF_OPERATION_OF_AXES,
)
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.drive_evidence import mode_code, module_names, name_against, written_mode
from esicatalog.model.drive_parts import object_words
from esicatalog.model.drive_recipe import unset_mode_words
from esicatalog.model.process_image import SmImage, placed_rx_pdos
from esicatalog.model.slots import ExpandedModule
from esicatalog.model.start_up import after_start, start_command


class AxisMode(NamedTuple):
    """0x6060 of an axis, and what is commanded of that."""

    outputs: AxisOutputs
    declared: ObjectEntry | None
    """What a dictionary says of it."""
    is_axis: bool
    """Whether there is evidence of the axis."""
    wanted: bytes | None
    """What all start-up commands of the description leave in it."""

    @property
    def object_index(self) -> int:
        """Where it lies."""
        return self.outputs.at(MODES_OF_OPERATION)

    @property
    def words(self) -> str:
        """The object."""
        return f"0x{self.object_index:04X}"


def axis_modes(
    axes: Sequence[int], images: Sequence[SmImage], commands: Sequence[StartCommand], objects: ObjectTable
) -> tuple[AxisMode, ...]:
    """The modes of all axes that a device may have; of ``axes`` there is evidence."""
    rx_pdos = placed_rx_pdos(images)
    wanted = started_modes(commands)
    found = []
    for axis, index in zip(range(MAX_AXES), MODES_OF_OPERATION_OF_AXES, strict=True):
        outputs = axis_outputs(axis, rx_pdos)
        found.append(AxisMode(outputs, objects.entry(index, 0), axis in axes, wanted.get(index)))
    return tuple(found)


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
    modes: Iterable[AxisMode],
    sent: Sequence[StartCommand],
    called: Sequence[StartCommand] = (),
    call: str = "",
    starts_cyclic: bool = False,
) -> Iterator[str]:
    """Modes that nothing sets or that go with no setpoint, by what a target makes of the start-up commands.

    It sends those of ``sent``; those of ``called`` the application does, by ``call``. ``starts_cyclic`` tells that it
    begins the cyclic value of a mapped 0x6060 with the mode that the description wants.
    """
    early, late = started_modes(sent), started_modes([*sent, *called])
    for item in modes:
        if item.outputs.has_mode:
            yield from _cyclic_remarks(item, starts_cyclic)
        elif item.is_axis and item.outputs.is_commanded:
            yield from _written_remarks(item, early.get(item.object_index), late.get(item.object_index), call)


def _cyclic_remarks(item: AxisMode, starts_cyclic: bool) -> Iterator[str]:
    if item.wanted is None:
        return
    what = f"the {_code_words(mode_code(item.wanted))} of the start-up command"
    if not starts_cyclic:
        yield (
            f"{item.words} is mapped: the cyclic value replaces {what}, so write the mode that is wanted there "
            "from the first cycle on"
        )
    elif not item.outputs.suits(mode_code(item.wanted)):
        yield f"{item.words} is mapped: command the mode that is wanted, for {what} {_without_setpoint(item)}"


def _written_remarks(item: AxisMode, early: bytes | None, late: bytes | None, call: str) -> Iterator[str]:
    """What a mode is that is not mapped: as commands leave it that are sent, and with those that an application calls.

    A default counts where no command writes. What a command writes is not read-only, whatever a dictionary says.
    """
    declared = item.declared if item.wanted is None else None
    unset = unset_mode_words(item.object_index, "the mode that is wanted", declared)
    default = item.declared.default_int if item.declared is not None else None
    code = mode_code(late) if late is not None else default
    if item.wanted is not None and mode_code(item.wanted) != code:
        yield f"{unset}, for the start-up command that writes {_code_words(mode_code(item.wanted))} is left out"
    elif not code:
        yield f"{unset}, for {'no start-up command does' if late is None else 'the start-up command writes 0'}"
    elif not item.outputs.suits(code):
        source = "its default," if late is None else "the start-up command's"
        yield f"{unset}, for {source} {_code_words(code)} {_without_setpoint(item)}"
    elif late != early:
        yield (
            f"{item.words} = {_code_words(code)} is written by a start-up command that the application sends: call "
            f"{call}, or write the mode before operation"
        )


def _code_words(code: int) -> str:
    mode = MODE_BY_CODE.get(code)
    return f"{code} ({mode.name})" if mode is not None else f"{code}"


def _without_setpoint(item: AxisMode) -> str:
    return f"does not go with the mapped setpoint {object_words(sorted(item.outputs.setpoints))}"


def name_remarks(expanded: Sequence[ExpandedModule], axes: Sequence[int]) -> Iterator[str]:
    """Modes that modules start against their names: what rule L57 finds, for those that are plugged."""
    of_axes = [MODES_OF_OPERATION + axis * AXIS_STEP for axis in axes]
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
