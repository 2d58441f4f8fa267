"""From the chosen PDOs and entries to an assignment that the device allows."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple, TypeVar

import msgspec

from esicatalog.errors import InputError
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry
from esicatalog.esi.unreadable import reason_words
from esicatalog.export.choice import PdoChoice
from esicatalog.export.entry_types import ObjectTable
from esicatalog.model.assignable_pdos import (
    AvailablePdo,
    assignment_place,
    available_pdos,
    excluded_beside,
    has_other_pdos,
    meant_by_index,
)
from esicatalog.model.pdo_assignment import Assignment
from esicatalog.model.pdo_facts import (
    PDO_FIELDS,
    entry_words,
    has_length,
    has_object,
    mapped_entries,
    pdos_by_direction,
    symmetric_exclusions,
)
from esicatalog.model.pdo_mapping import MAPPABLE_IN, is_mappable, mapping_obstacle
from esicatalog.model.process_image import SmImage, assigned_indices
from esicatalog.model.slots import PluggedModule
from esicatalog.words import counted

Owner = TypeVar("Owner", Device, Module)


class ChosenPdos(NamedTuple):
    """Device and modules with the chosen entries in their PDOs, and the assignment to them."""

    device: Device
    plugged: tuple[PluggedModule, ...]
    assignment: Assignment | None
    remarks: tuple[str, ...] = ()


def apply_choice(
    device: Device,
    plugged: Sequence[PluggedModule],
    chosen: Sequence[PdoChoice],
    objects: ObjectTable,
    default: Sequence[SmImage],
) -> ChosenPdos:
    """Check the chosen PDOs against the description and turn them into an assignment.

    ``default`` is what SyncManagers keep to which none of them goes. Raises :class:`InputError` for a PDO that does not
    exist, is virtual in a device with CoE, is described by device and modules in different ways, is excluded by another
    one, may not go to its SyncManager, or whose entries cannot be chosen so.
    """
    if not chosen:
        return ChosenPdos(device, tuple(plugged), None)
    available = available_pdos(device, plugged).pdos
    chosen = _without_later_samples(chosen, default)
    picked = [(_find(available, item), item) for item in chosen]
    assignment: dict[int, list[int]] = {}
    own = {pdo.pdo_index for _, pdos in pdos_by_direction(device) for pdo in pdos}
    remarks = [
        f"PDO 0x{item.pdo_index:04X} is that of {found.owner}: the device's own yields to it (OverwrittenByModule)"
        for found, item in picked
        if found.plugged is not None and item.pdo_index in own
    ]
    for found, item in picked:
        assignment.setdefault(_sync_manager(device, found), []).append(item.pdo_index)
    _check_exclusions(device, available, assignment, default)
    for found, item in picked:
        if item.entries:
            entries = _chosen_entries(device, found, item, objects)
            if mapped_entries(entries) == mapped_entries(found.pdo.entries):
                continue
            device, plugged = _with_entries(device, plugged, found, entries)
            remarks.append(
                f"PDO 0x{item.pdo_index:04X}: {counted(len(entries), 'entry is', 'entries are')} chosen, "
                f"{counted(len(found.pdo.entries), 'is', 'are')} described; the master writes the mapping at start"
            )
    return ChosenPdos(device, tuple(plugged), assignment, tuple(remarks))


def _without_later_samples(chosen: Sequence[PdoChoice], default: Iterable[SmImage]) -> list[PdoChoice]:
    """Without PDOs that hold one sample and no choice of entries, which come with that of the first sample."""
    indices = {item.pdo_index for item in chosen}
    samples = ((placed.pdo.pdo_index or 0, placed.sample) for image in default for placed in image.pdos)
    brought = {index for index, sample in samples if sample > 1 and index - sample + 1 in indices}
    return [item for item in chosen if item.entries or item.pdo_index not in brought]


def check_entries(device: Device, plugged: Sequence[PluggedModule], images: Iterable[SmImage]) -> None:
    """Raise :class:`InputError` for an assigned entry of which nothing can be made, with what can be chosen instead."""
    for image in images:
        for placed in image.pdos:
            problems = (_problem(item.entry, number) for number, item in enumerate(placed.entries, 1))
            problem = next((words for words in problems if words is not None), None)
            if problem is None or placed.pdo.pdo_index is None:
                continue
            pdo, available = placed.pdo, available_pdos(device, plugged).pdos
            choices = []
            if not pdo.mandatory and has_other_pdos(device, available, image.sm, {pdo.pdo_index}):
                choices.append("other PDOs")
            if mapping_obstacle(device, pdo) is None:
                choices.append("entries of it")
            advice = f", or choose {' or '.join(choices)} (--pdo)" if choices else ""
            raise InputError(f"PDO 0x{pdo.pdo_index:04X} {problem}; correct the file{advice}")


def _problem(entry: Entry, number: int) -> str | None:
    """Why nothing can be made of an assigned entry."""
    if not has_object(entry):
        field, element = ("entry_index", "Index") if entry.entry_index is None else ("subindex", "SubIndex")
        reason = reason_words(entry, field)
        return f"has an entry, number {number}, without a usable {element}{reason}: what it maps is unknown"
    if not has_length(entry):
        what = entry_words(entry) if entry.entry_index else "a gap"
        reason = reason_words(entry, "bit_length")
        return f"maps {what} without a usable BitLen{reason}, and nothing tells where the entries behind it lie"
    return None


def _find(available: Sequence[AvailablePdo], wanted: PdoChoice) -> AvailablePdo:
    found, obstacle = meant_by_index(available, wanted.pdo_index)
    if found is None:
        known = sorted({item.pdo.pdo_index for item in available if item.pdo.pdo_index is not None})
        if wanted.pdo_index not in known:
            obstacle += f"; the PDOs are {', '.join(f'0x{index:04X}' for index in known) or 'none'}"
        raise InputError(f"PDO 0x{wanted.pdo_index:04X} {obstacle}")
    return found


def _sync_manager(device: Device, found: AvailablePdo) -> int:
    place = assignment_place(device, found.direction, found.pdo)
    if place.sm is None:
        raise InputError(f"PDO 0x{found.pdo.pdo_index or 0:04X} {place.obstacle}")
    return place.sm


def _check_exclusions(
    device: Device, available: Sequence[AvailablePdo], assignment: Assignment, default: Iterable[SmImage]
) -> None:
    """Chosen PDOs among themselves, and against those that are assigned beside them without being chosen."""
    exclusions = symmetric_exclusions(item.pdo for item in available)
    chosen = {index: sm for sm, indices in assignment.items() for index in indices}
    for index in sorted(chosen):
        for rival in exclusions.get(index, ()):
            if rival in chosen:
                raise InputError(f"{_exclusion_words(index, rival)}; choose one of them")
    for found in excluded_beside(device, available, chosen, assigned_indices(default)):
        if found.is_mandatory:
            why = "is mandatory"
        elif found.has_others:
            why = f"is the default of SM{found.sm}; choose the PDOs of SM{found.sm} too, without it"
        else:
            why = f"is the default of SM{found.sm}, for which no other PDO can be chosen"
        words = _exclusion_words(found.chosen, found.pdo_index)
        raise InputError(f"{words}, and 0x{found.pdo_index:04X} {why}")


def _exclusion_words(index: int, rival: int) -> str:
    return f"PDO 0x{index:04X} and PDO 0x{rival:04X} exclude each other"


def _chosen_entries(device: Device, found: AvailablePdo, wanted: PdoChoice, objects: ObjectTable) -> tuple[Entry, ...]:
    """The chosen entries in their order: those of the PDO, and objects that the dictionary lets into it."""
    if (obstacle := mapping_obstacle(device, found.pdo)) is not None:
        raise InputError(f"entries of PDO 0x{wanted.pdo_index:04X} cannot be chosen: its mapping {obstacle}")
    declared = objects.highest_subindex(wanted.pdo_index)
    room = max(declared, len(found.pdo.entries)) if declared else None
    if room is not None and len(wanted.entries) > room:
        raise InputError(
            f"{len(wanted.entries)} entries are chosen for PDO 0x{wanted.pdo_index:04X}, which has room for {room}: "
            "the dictionary declares no more subindices of its mapping"
        )
    own = {(entry.entry_index, entry.subindex or 0): entry for entry in found.pdo.entries if entry.entry_index}
    return tuple(
        own.get((index, subindex)) or _mapped_object(found, wanted, index, subindex, objects)
        for index, subindex in wanted.entries
    )


def _mapped_object(found: AvailablePdo, wanted: PdoChoice, index: int, subindex: int, objects: ObjectTable) -> Entry:
    declared = objects.entry(index, subindex)
    if declared is None or not is_mappable(declared, found.direction):
        raise InputError(
            f"0x{index:04X}:{subindex:02X} is no entry of PDO 0x{wanted.pdo_index:04X}, "
            f"and no dictionary declares it mappable ({MAPPABLE_IN[found.direction]}) with a size"
        )
    return Entry(
        entry_index=index,
        subindex=subindex,
        bit_length=declared.bit_size,
        names=(Name(text=declared.name or ""),),
        data_type=declared.base_type,
    )


def _with_entries(
    device: Device, plugged: Sequence[PluggedModule], found: AvailablePdo, entries: tuple[Entry, ...]
) -> tuple[Device, tuple[PluggedModule, ...]]:
    """Device and modules with other entries in one PDO. Indices of a module are those of its slot already."""
    field = PDO_FIELDS[found.direction]
    if found.plugged is None:
        return _replaced(device, field, found.position, entries), tuple(plugged)
    unshifted = tuple(
        msgspec.structs.replace(entry, depend_on_slot=None, depend_on_slot_group=None) for entry in entries
    )
    return device, tuple(
        item._replace(module=_replaced(item.module, field, found.position, unshifted))
        if item.slot_number == found.plugged.slot_number
        else item
        for item in plugged
    )


def _replaced(owner: Owner, field: str, position: int | None, entries: tuple[Entry, ...]) -> Owner:
    pdos = tuple(
        msgspec.structs.replace(pdo, entries=entries) if at == position else pdo
        for at, pdo in enumerate(getattr(owner, field))
    )
    return msgspec.structs.replace(owner, **{field: pdos})
