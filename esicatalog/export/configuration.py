"""What all generators get: a device with everything chosen, every entry with its place, type and name."""

import itertools
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.pdo import Entry
from esicatalog.esi.unreadable import unreadable
from esicatalog.export.choice import Choice, check_numbers
from esicatalog.export.clocks import Clocks, Programmed, chosen_op_mode, programmed_clocks
from esicatalog.export.entry_types import ObjectTable, ValueType, value_type
from esicatalog.export.image_remarks import (
    assignment_remarks,
    memory_remarks,
    own_remarks,
    repeat_remarks,
    swap_remarks,
)
from esicatalog.export.init_cmds import StartCommand, cycle_remarks, start_commands
from esicatalog.export.missing_modules import missing_modules
from esicatalog.export.mode_commands import mode_remarks
from esicatalog.export.names import IDENTIFIER, identifier
from esicatalog.export.naming import entry_names
from esicatalog.export.pdo_choice import apply_choice
from esicatalog.export.pdo_objects import PdoObject, contradiction_remarks, contradictions
from esicatalog.export.subject import Subject
from esicatalog.export.unread_remarks import unread_remarks
from esicatalog.model.assignable_pdos import declares_pdo_assign
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.module_choice import chosen_modules
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS, has_length, has_object, is_described, object_words
from esicatalog.model.process_image import PlacedPdo, SmImage, process_image
from esicatalog.model.slots import PluggedModule, expand_module
from esicatalog.model.sm_facts import TRANSFER_DIRECTIONS, sm_role, transfer_direction
from esicatalog.model.sync_parameters import min_cycle_ns, sync_parameters

_CONTROL_BYTES = range(0x100)
_MAX_INDEX, _MAX_SUBINDEX = 0xFFFF, 0xFF
_MAX_MAPPED_BITS = 255


class MappedEntry(NamedTuple):
    """An entry of the process image. Index 0 is a gap."""

    entry_index: int
    subindex: int
    bit_length: int
    bit_offset: int
    """In its SyncManager; 0 where that is not known."""
    name: str
    """As the vendor wrote it, empty when there is none."""
    identifier: str
    """Unique in the device; empty for a gap."""
    value: ValueType
    is_placed: bool = True
    """Whether ``bit_offset`` is known; behind a PDO without described entries nothing tells the place."""

    @property
    def is_gap(self) -> bool:
        """Whether only its length counts."""
        return self.entry_index == 0

    @property
    def comment(self) -> str:
        """What a comment calls it: its name, empty when there is none."""
        return "gap" if self.is_gap else self.name

    @property
    def mapping_value(self) -> int:
        """What a mapping object says of it: index, subindex and bits."""
        return self.entry_index << 16 | self.subindex << 8 | self.bit_length

    @property
    def place(self) -> str:
        """Index and subindex in words."""
        return f"0x{self.entry_index:04X}:{self.subindex:02X}"


class AssignedPdo(NamedTuple):
    """A PDO of a SyncManager."""

    pdo_index: int
    name: str
    direction: str
    """RxPdo or TxPdo."""
    fixed: bool
    slot_number: int | None
    entries: tuple[MappedEntry, ...]
    is_described: bool
    """Whether its content is known, be it none."""

    @property
    def mapping(self) -> PdoObject | None:
        """What belongs into its mapping object; None without described entries, and for what no mapping can express."""
        if any(entry.bit_length > _MAX_MAPPED_BITS for entry in self.entries):
            return None
        return PdoObject.that_holds(self.pdo_index, (entry.mapping_value for entry in self.entries))


class SmConfiguration(NamedTuple):
    """A SyncManager with what is assigned to it."""

    number: int
    usage: str
    direction: str
    """output (the master writes) or input."""
    sync_manager: SyncManager | None
    """None when PDOs name a SyncManager that the device does not describe."""
    pdos: tuple[AssignedPdo, ...]
    bit_size: int
    """All described bits."""
    is_left_open: bool
    """Whether it has no PDO and exchanges something that is not described."""

    @property
    def byte_size(self) -> int:
        """Length in bytes: all bits, rounded up once."""
        return (self.bit_size + 7) // 8

    @property
    def placed_bit_size(self) -> int:
        """Bits whose place is known: those before the first PDO without described entries."""
        described = itertools.takewhile(lambda pdo: pdo.is_described, self.pdos)
        return sum(entry.bit_length for pdo in described for entry in pdo.entries)

    @property
    def is_described(self) -> bool:
        """Whether all content of its PDOs is known; without PDOs there is none."""
        return bool(self.pdos) and all(pdo.is_described for pdo in self.pdos)

    @property
    def assignment(self) -> PdoObject | None:
        """What belongs into its assignment object; None without PDOs, and where there is no such object."""
        object_index = PDO_ASSIGNMENTS.start + self.number
        if object_index not in PDO_ASSIGNMENTS:
            return None
        return PdoObject.that_holds(object_index, (pdo.pdo_index for pdo in self.pdos))

    @property
    def entries(self) -> Iterator[MappedEntry]:
        """All entries that carry a value, in order."""
        return (entry for pdo in self.pdos for entry in pdo.entries if not entry.is_gap)


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
    """All but virtual ones, which only describe."""
    commands: tuple[StartCommand, ...]
    rewritten: frozenset[int]
    """Indices of assignments and mappings that the device declares to take from the master at each start."""
    contradicted: frozenset[int]
    """Indices of assignments and mappings into which commands write something else than what is configured here."""
    axes: tuple[int, ...]
    """CiA 402 axes, from 0."""
    is_drive: bool
    """Whether something may move: a CiA 402 axis, a SoE drive or a motion terminal (MDP 7xx), be it only a module that
    is missing."""
    missing_modules: str | None
    """Which slots lack modules without which the process data are not known, in words."""
    remarks: tuple[str, ...]
    copy_remarks: tuple[str, ...]
    """Remarks for targets with which an application can write every copy of an output that is mapped again."""

    @property
    def op_mode(self) -> OpMode | None:
        """The chosen OpMode."""
        return self.subject.device.op_modes[self.op_mode_position] if self.op_mode_position is not None else None

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
    position, op_mode_remarks = chosen_op_mode(device, tuple(item.module for item in plugged), choice.op_mode)
    op_mode = device.op_modes[position] if position is not None else None
    objects = ObjectTable(device, expanded)
    default = process_image(device, plugged, op_mode)
    chosen = apply_choice(device, plugged, choice.pdos, objects, default)
    is_default = chosen.assignment is None
    images = default if is_default else process_image(chosen.device, chosen.plugged, op_mode, chosen.assignment)
    for image in images:
        if image.overflow is not None:
            raise InputError(f"SM{image.sm}: {image.overflow}")
    _check_assigned(choice, images)
    programmed = programmed_clocks(device, op_mode, choice.cycle_ns)
    commands, command_remarks = start_commands(device, plugged, expanded)
    names = entry_names(device, expanded, images, objects)
    missing = missing_modules(device, subject.modules, plugged)
    remarks = [
        *((subject.ambiguity,) if subject.ambiguity is not None else ()),
        *((missing.words,) if missing is not None else ()),
        *unread_remarks(chosen.device, chosen.plugged, op_mode, images),
        *op_mode_remarks,
        *chosen.remarks,
        *assignment_remarks(device, plugged, op_mode, default, images),
        *own_remarks(images, missing is not None),
        *swap_remarks(images),
        *memory_remarks(device, subject.modules, images),
        *programmed.remarks,
        *_too_short(device, programmed.cycle_ns),
        *command_remarks,
        *cycle_remarks(commands, names.axes, programmed.cycle_ns, _sync0_ns(programmed)),
        *mode_remarks(commands, names.axes, expanded, images),
    ]
    sync_managers = tuple(_sync_managers(device, images, names.identifiers, objects, remarks))
    _check_assigned_once(sync_managers)
    rewritten = frozenset(_rewritten(device, sync_managers))
    found = list(contradictions(commands, _pdo_objects(sync_managers), rewritten))
    remarks += contradiction_remarks(found)
    return Configuration(
        subject,
        choice,
        checked_prefix(choice.name) if choice.name is not None else identifier(device.type, "device"),
        tuple(plugged),
        position,
        programmed.cycle_ns,
        programmed.clocks,
        sync_managers,
        commands,
        rewritten,
        frozenset(item.object_index for item in found),
        names.axes,
        names.is_drive or (missing is not None and missing.may_move),
        missing.words if missing is not None else None,
        tuple(dict.fromkeys(remarks)),
        tuple(repeat_remarks(images)),
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


def checked_prefix(name: str) -> str:
    """A prefix of the user's own. Raises :class:`InputError` when no identifier can begin so."""
    if IDENTIFIER.fullmatch(name) is None or "__" in name or identifier(name, "") != name.lower():
        raise InputError(f"{name!r} cannot begin names: use letters, digits and single _, a letter first")
    return name.lower()


def _pdo_objects(sync_managers: Iterable[SmConfiguration]) -> Iterator[PdoObject]:
    """What belongs into the assignments and mappings of all process data whose content is known."""
    for sm in sync_managers:
        if sm.is_described:
            yield from (item for item in (sm.assignment, *(pdo.mapping for pdo in sm.pdos)) if item is not None)


def _check_assigned(choice: Choice, images: Sequence[SmImage]) -> None:
    """Raise :class:`InputError` for a chosen PDO that rules of the description keep out all the same."""
    assigned = {placed.pdo.pdo_index for image in images for placed in image.pdos}
    for index in (item.pdo_index for item in choice.pdos if item.pdo_index not in assigned):
        named = f"PDO 0x{index:04X}"
        reasons = [remark for image in images for remark in image.remarks if remark.startswith(named)]
        raise InputError("; ".join([f"{named} cannot be chosen", *reasons]))


def _rewritten(device: Device, sync_managers: Iterable[SmConfiguration]) -> Iterator[int]:
    """Assignments with PdoAssign, mappings with PdoConfig unless they are Fixed (ESI-FACTS section 10)."""
    has_mappings = device.mailbox is not None and bool(device.mailbox.coe_pdo_config)
    for sm in sync_managers:
        if sm.assignment is not None and declares_pdo_assign(device):
            yield sm.assignment.object_index
        if has_mappings:
            yield from (pdo.pdo_index for pdo in sm.pdos if pdo.mapping is not None and not pdo.fixed)


def _check_assigned_once(sync_managers: Iterable[SmConfiguration]) -> None:
    """Raise :class:`InputError` for an index that is assigned again, as modules have it whose slots do not move it."""
    seen: set[int] = set()
    for pdo in (pdo for sm in sync_managers for pdo in sm.pdos):
        if pdo.pdo_index in seen:
            raise InputError(
                f"PDO 0x{pdo.pdo_index:04X} is assigned twice, and devices and masters tell PDOs apart by their index: "
                "choose PDOs (--pdo) or modules (--module), or take a correct file"
            )
        seen.add(pdo.pdo_index)


def _sync_managers(
    device: Device,
    images: Sequence[SmImage],
    identifiers: dict[tuple[int, int, int], str],
    objects: ObjectTable,
    remarks: list[str],
) -> Iterator[SmConfiguration]:
    by_number = {image.sm: image for image in images}
    for number in sorted({*range(len(device.sync_managers)), *by_number}):
        described = device.sync_managers[number] if 0 <= number < len(device.sync_managers) else None
        image = by_number.get(number)
        placed_pdos = image.pdos if image is not None else ()
        if number < 0:
            raise InputError(f"PDOs are assigned to SM{number}, which cannot be")
        if described is not None and described.virtual:
            continue
        if described is None:
            remarks.append(f"PDOs name SM{number}, which the device does not describe")
        elif (control := described.control_byte or 0) not in _CONTROL_BYTES:
            remarks.append(f"SM{number} has the ControlByte {control:#x}, which does not fit its register of 8 bits")
        pdos: list[AssignedPdo] = []
        for at, placed in enumerate(placed_pdos):
            names = [identifiers.get((number, at, n), "") for n in range(len(placed.entries))]
            pdos.append(_assigned_pdo(placed, names, objects))
        direction = _direction(number, described, pdos, remarks)
        yield SmConfiguration(
            number,
            described.usage or "" if described is not None else "",
            direction,
            described,
            tuple(pdos),
            image.bit_size if image is not None else 0,
            image is not None and image.left_open is not None,
        )


def _direction(number: int, described: SyncManager | None, pdos: Sequence[AssignedPdo], remarks: list[str]) -> str:
    """Direction of a SyncManager, with a remark where what describes it differs."""
    direction = transfer_direction(described, [pdo.direction for pdo in pdos])
    role = sm_role(described) if described is not None else None
    others = {TRANSFER_DIRECTIONS[pdo.direction] for pdo in pdos} | ({role.transfer_direction} if role else set())
    if others - {direction}:
        remarks.append(
            f"SM{number} is described in both directions (usage, ControlByte and PDOs differ); "
            f"{direction} is taken, check it on the device"
        )
    return direction


def _assigned_pdo(placed: PlacedPdo, identifiers: Sequence[str], objects: ObjectTable) -> AssignedPdo:
    pdo = placed.pdo
    name = " ".join((display_text(pdo.names) or "").split())
    if pdo.pdo_index is None or not 0 < pdo.pdo_index <= _MAX_INDEX:
        named = f"{placed.direction} {name or pdo.ref or 'without name'!r}"
        unread = unreadable(pdo, "pdo_index")
        why = "has no index; its content is not described, take a newer file"
        if unread is not None:
            why = f"its Index {unread}; correct the file"
        raise InputError(f"{named} is assigned and {why}")
    entries = []
    for number, (item, entry_identifier) in enumerate(zip(placed.entries, identifiers, strict=True)):
        if (problem := _problem(item.entry, number + 1)) is not None:
            raise InputError(
                f"PDO 0x{pdo.pdo_index:04X} {problem}; correct the file, or choose other PDOs or entries (--pdo)"
            )
        index, subindex, bit_length = item.entry.entry_index or 0, item.entry.subindex or 0, item.entry.bit_length or 0
        if not bit_length:
            continue
        if not 0 <= index <= _MAX_INDEX or not 0 <= subindex <= _MAX_SUBINDEX:
            raise InputError(f"PDO 0x{pdo.pdo_index:04X} maps 0x{index:04X}:{subindex:02X}, which is no object")
        text = " ".join((display_text(item.entry.names) or "").split())
        value = value_type(objects.base_type(placed.first_sample(number), placed.slot_number), bit_length)
        entries.append(
            MappedEntry(
                index,
                subindex if index else 0,
                bit_length,
                item.bit_offset or 0,
                text if index else "",
                entry_identifier,
                value,
                item.bit_offset is not None,
            )
        )
    return AssignedPdo(
        pdo.pdo_index, name, placed.direction, bool(pdo.fixed), placed.slot_number, tuple(entries), is_described(pdo)
    )


def _problem(entry: Entry, number: int) -> str | None:
    """Why nothing can be made of an assigned entry."""
    if not has_object(entry):
        field, element = ("entry_index", "Index") if entry.entry_index is None else ("subindex", "SubIndex")
        return (
            f"has an entry, number {number}, without a usable {element}{_reason(entry, field)}: what it maps is unknown"
        )
    if not has_length(entry):
        what = object_words(entry) if entry.entry_index else "a gap"
        reason = _reason(entry, "bit_length")
        return f"maps {what} without a usable BitLen{reason}, and nothing tells where the entries behind it lie"
    return None


def _reason(entry: Entry, field: str) -> str:
    problem = unreadable(entry, field)
    return f" ({problem})" if problem is not None else ""
