"""What all generators get: a device with everything chosen, every entry with its place, type and name."""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.export.choice import Choice, check_numbers
from esicatalog.export.clocks import Clocks, Programmed, chosen_op_mode, programmed_clocks
from esicatalog.export.cycle_commands import cycle_remarks
from esicatalog.export.entry_types import ObjectTable
from esicatalog.export.init_cmds import StartCommand, start_commands
from esicatalog.export.missing_modules import missing_modules, unplugged_remarks
from esicatalog.export.mode_commands import AxisMode, axis_modes, name_remarks
from esicatalog.export.names import checked_prefix, identifier
from esicatalog.export.naming import entry_names
from esicatalog.export.pdo_choice import apply_choice, check_entries
from esicatalog.export.pdo_objects import contradiction_remarks, contradictions
from esicatalog.export.process_image_remarks import (
    assignment_remarks,
    memory_remarks,
    order_remarks,
    own_remarks,
    repeat_remarks,
    staying_copies,
    subindex_remarks,
    swap_remarks,
)
from esicatalog.export.sm_configuration import SmConfiguration, configured_sync_managers, pdo_objects, rewritten_objects
from esicatalog.export.subject import Subject
from esicatalog.export.unread_remarks import unread_remarks
from esicatalog.model.assignable_pdos import available_pdos
from esicatalog.model.axis_outputs import no_controlword_words
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.module_choice import chosen_modules
from esicatalog.model.process_image import SmImage, placed_rx_pdos, process_image, without_modules
from esicatalog.model.required_slots import missing_pdos
from esicatalog.model.slots import PluggedModule, expand_module
from esicatalog.model.sync import op_mode_at
from esicatalog.model.sync_parameters import min_cycle_ns, sync_parameters
from esicatalog.remarks import remarked


class Configuration(NamedTuple):
    """A device with everything chosen."""

    subject: Subject
    choice: Choice
    prefix: str
    """Begins all generated names."""
    plugged: tuple[PluggedModule, ...]
    op_mode_position: int | None
    cycle_ns: int
    """Bus cycle."""
    clocks: Clocks | None
    """None when a master programs no SYNC unit for the OpMode."""
    sync_managers: tuple[SmConfiguration, ...]
    """All but virtual ones of which nothing is chosen."""
    commands: tuple[StartCommand, ...]
    rewritten: frozenset[int]
    """Indices of assignments and mappings that the device declares to take from the master at each start."""
    contradicted: frozenset[int]
    """Indices of assignments and mappings into which commands write something else than what is configured here."""
    axes: tuple[int, ...]
    """CiA 402 axes, from 0."""
    modes: tuple[AxisMode, ...]
    """What sets the modes of axes, also of those without evidence; a target remarks what it leaves out."""
    is_drive: bool
    """Whether something may move: a CiA 402 axis, a SoE drive or a motion terminal (MDP 7xx), be it only a module that
    is missing."""
    missing_modules: str | None
    """Which slots lack modules without which the process data are not known, in words."""
    lacking: frozenset[str]
    """Transfer directions in which required modules bring more than is configured here."""
    remarks: tuple[str, ...]
    copy_remarks: tuple[str, ...]
    """Remarks for targets with which an application can write every copy of an output that is mapped again."""
    staying_copies: frozenset[tuple[int, int]]
    """Index and subindex of what is mapped again whatever PDOs and entries are chosen."""

    @property
    def op_mode(self) -> OpMode | None:
        """The chosen OpMode."""
        return op_mode_at(self.subject.device.op_modes, self.op_mode_position)

    @property
    def uses_dc_time(self) -> bool:
        """Whether the clocks have to be kept together for it; some devices need that and no SYNC unit."""
        return self.op_mode is not None and bool(self.op_mode.assign_activate)

    def is_contradicted(self, command: StartCommand) -> bool:
        """Whether a command would make the process image another one than is configured here."""
        return command.writes_pdo_configuration and command.object_index in self.contradicted

    def images(self, direction: str) -> tuple[SmConfiguration, ...]:
        """SyncManagers with process data of one direction."""
        return tuple(sm for sm in self.sync_managers if sm.direction == direction and sm.bit_size)


def configure(subject: Subject, choice: Choice | None = None) -> Configuration:
    """The configuration of a device for a choice. Raises :class:`InputError` for what cannot be chosen so."""
    choice = choice if choice is not None else Choice()
    subject.required_codes()
    check_numbers(choice)
    device = subject.device
    plugged = chosen_modules(device, subject.modules, choice.modules, subject.variants_with_slots)
    expanded = [expand_module(device, item) for item in plugged]
    modules = tuple(item.module for item in plugged)
    position, op_mode_remarks = remarked(chosen_op_mode(device, modules, choice.op_mode))
    op_mode = op_mode_at(device.op_modes, position)
    objects = ObjectTable(device, expanded)
    default = process_image(device, plugged, op_mode)
    chosen = apply_choice(device, plugged, choice.pdos, objects, default)
    is_default = chosen.assignment is None
    images = default if is_default else process_image(chosen.device, chosen.plugged, op_mode, chosen.assignment)
    lacking = missing_pdos(device, subject.modules, plugged)
    images = without_modules(images, lacking)
    for image in images:
        if image.overflow is not None:
            raise InputError(f"SM{image.sm}: {image.overflow}")
    check_entries(device, chosen.plugged, images)
    _check_assigned(choice, images)
    programmed = programmed_clocks(device, op_mode, choice.cycle_ns)
    commands, command_remarks = remarked(start_commands(device, plugged, expanded, objects))
    names = entry_names(device, expanded, images, objects)
    modes = axis_modes(names.axes, images, commands, objects)
    missing = missing_modules(device, subject.modules, plugged)
    staying = staying_copies(chosen.device, images)
    remarks = [
        *filter(None, (subject.damage, *subject.ambiguities)),
        *((missing.words,) if missing is not None else ()),
        *unplugged_remarks(device, subject.modules, plugged),
        *unread_remarks(chosen.device, chosen.plugged, op_mode, images),
        *op_mode_remarks,
        *chosen.remarks,
        *assignment_remarks(device, plugged, op_mode, default, images),
        *order_remarks(device, objects, images),
        *own_remarks(images, missing is not None),
        *subindex_remarks(device, images),
        *swap_remarks(images),
        *memory_remarks(device, subject.modules, images),
        *programmed.remarks,
        *_too_short(device, programmed.cycle_ns),
        *command_remarks,
        *cycle_remarks(commands, names.axes, objects, programmed.cycle_ns, _sync0_ns(programmed)),
        *name_remarks(expanded, names.axes),
        *_controlword_remarks(device, plugged, images, modes),
    ]
    sync_managers, sm_remarks = remarked(configured_sync_managers(device, images, names, objects))
    rewritten = frozenset(rewritten_objects(device, sync_managers))
    found = list(contradictions(commands, pdo_objects(sync_managers), rewritten))
    remarks += (*sm_remarks, *contradiction_remarks(found))
    return Configuration(
        subject=subject,
        choice=choice,
        prefix=checked_prefix(choice.name) if choice.name is not None else identifier(device.type, "device"),
        plugged=tuple(plugged),
        op_mode_position=position,
        cycle_ns=programmed.cycle_ns,
        clocks=programmed.clocks,
        sync_managers=sync_managers,
        commands=commands,
        rewritten=rewritten,
        contradicted=frozenset(item.object_index for item in found),
        axes=names.axes,
        modes=modes,
        is_drive=names.is_drive or (missing is not None and missing.may_move),
        missing_modules=missing.words if missing is not None else None,
        lacking=frozenset(lacking),
        remarks=tuple(dict.fromkeys(remarks)),
        copy_remarks=tuple(repeat_remarks(images, staying)),
        staying_copies=staying,
    )


def _sync0_ns(programmed: Programmed) -> Fraction | None:
    found = programmed.clocks
    return found.sync0_cycle.in_ns(programmed.cycle_ns) if found is not None and found.signals.sync0 else None


def _too_short(device: Device, cycle_ns: int) -> Iterator[str]:
    least_ns = min_cycle_ns(device, sync_parameters(device, DictionaryViews()))
    if least_ns is not None and cycle_ns < least_ns:
        yield (
            f"the device describes {least_ns} ns as its smallest bus cycle, this is made for {cycle_ns} ns: choose a "
            "longer one, or find out what this configuration of the device can do"
        )


def _controlword_remarks(
    device: Device, plugged: Sequence[PluggedModule], images: Iterable[SmImage], modes: Sequence[AxisMode]
) -> Iterator[str]:
    """Setpoints of axes without their controlword, as a choice of PDOs may leave them."""
    assigned = placed_rx_pdos(images)
    for item in modes:
        if item.is_axis and item.outputs.lacks_controlword:
            yield no_controlword_words(item.outputs, available_pdos(device, plugged).pdos, assigned)


def _check_assigned(choice: Choice, images: Sequence[SmImage]) -> None:
    """Raise :class:`InputError` for a chosen PDO that rules of the description keep out all the same."""
    assigned = {placed.pdo.pdo_index for image in images for placed in image.pdos}
    for index in (item.pdo_index for item in choice.pdos if item.pdo_index not in assigned):
        named = f"PDO 0x{index:04X}"
        reasons = [remark for image in images for remark in image.remarks if remark.startswith(named)]
        raise InputError("; ".join([f"{named} cannot be chosen", *reasons]))
