"""Names of all entries of a device, and which CiA 402 axes they belong to."""

from collections.abc import Sequence
from typing import NamedTuple

from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO, Entry, Pdo
from esicatalog.export.cia402_names import CIA402_NAMES
from esicatalog.export.entry_types import ObjectTable
from esicatalog.export.names import identifier, unique_names
from esicatalog.model.axes import exchanged_axes
from esicatalog.model.cia402 import AXIS_STEP
from esicatalog.model.pdo_facts import carries_value
from esicatalog.model.process_image import PlacedPdo, SmImage
from esicatalog.model.profile_facts import is_motion_terminal
from esicatalog.model.slots import ExpandedModule

_BIT_POSITION = "_bit_position"
"""Ends the names of what an IgH header registers beside an entry."""


class EntryNames(NamedTuple):
    """Identifiers by SyncManager, PDO in it and entry in that; what carries no value has none."""

    identifiers: dict[tuple[int, int, int], str]
    axes: tuple[int, ...]
    is_drive: bool


def entry_names(
    device: Device, expanded: Sequence[ExpandedModule], images: Sequence[SmImage], objects: ObjectTable
) -> EntryNames:
    """Unique identifiers: CiA 402 names on axes with evidence, else by entry, PDO and slot name."""
    profiles = [*device.profiles, *(profile for item in expanded for profile in item.module.profiles)]
    assigned: dict[str, list[Pdo]] = {RX_PDO: [], TX_PDO: []}
    for image in images:
        for placed in image.pdos:
            assigned[placed.direction].append(placed.pdo)

    def declared_bits(index: int) -> int | None:
        declared = objects.entry(index, 0)
        return declared.bit_size if declared is not None else None

    axes = tuple(exchanged_axes(device, profiles, assigned[RX_PDO], assigned[TX_PDO], declared_bits))
    keys, candidates = [], []
    for image in images:
        for at, placed in enumerate(image.pdos):
            for number, item in enumerate(placed.entries):
                if carries_value(item.entry):
                    keys.append((image.sm, at, number))
                    candidates.append(_candidates(placed, placed.first_sample(number), item.entry, axes, objects))
    is_drive = bool(axes) or is_motion_terminal(profiles)
    is_drive = is_drive or (device.mailbox is not None and device.mailbox.soe)
    return EntryNames(dict(zip(keys, unique_names(candidates), strict=True)), axes, is_drive)


def _candidates(placed: PlacedPdo, first: Entry, sample: Entry, axes: Sequence[int], objects: ObjectTable) -> list[str]:
    """Names from plain to precise; what an entry is says the ``first`` sample, which one it is the ``sample``."""
    index, subindex = first.entry_index or 0, first.subindex or 0
    standard = _cia402_name(index, subindex, axes)
    fallback = f"entry_{index:04x}_{subindex:02x}"
    declared = objects.entry(index, subindex)
    own = identifier(display_text(first.names), "") or identifier(declared.name if declared else None, fallback)
    plain = standard or own
    if plain.endswith(_BIT_POSITION):
        plain += "_value"
    pdo = identifier(display_text(placed.pdo.names), f"pdo_{placed.pdo.pdo_index or 0:04x}")
    precise = [plain, f"{pdo}_{plain}"]
    if placed.slot_number is not None:
        precise.append(f"slot{placed.slot_number}_{pdo}_{plain}")
    return [*precise, f"{plain}_{sample.entry_index or 0:04x}_{sample.subindex or 0:02x}"]


def _cia402_name(index: int, subindex: int, axes: Sequence[int]) -> str | None:
    for axis in axes:
        name = CIA402_NAMES.get(index - axis * AXIS_STEP)
        if name is not None:
            part = f"{name}_{subindex}" if subindex else name
            return f"{part}_axis{axis}" if axis else part
    return None
