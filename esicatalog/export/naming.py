"""Names of all entries of a device, and which CiA 402 axes they belong to."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.export.cia402_names import CIA402_NAMES
from esicatalog.export.entry_types import ObjectTable
from esicatalog.export.names import identifier, unique_names
from esicatalog.model.cia402 import AXIS_STEP, CONTROLWORD, MAX_AXES, PROFILE_CIA402, PROFILE_MODULAR, STATUSWORD
from esicatalog.model.pdo_facts import mapped
from esicatalog.model.process_image import PlacedPdo, SmImage
from esicatalog.model.slots import ExpandedModule

_WORD_BITS = 16
_AXIS_WORDS = {word + axis * AXIS_STEP for word in (CONTROLWORD, STATUSWORD) for axis in range(MAX_AXES)}
_BIT_POSITION = "_bit_position"
"""Ends the names of what an IgH header registers beside an entry."""
_MOTION_MODULES = range(700, 800)
"""Module profiles of motion terminals under profile 5001."""


class EntryNames(NamedTuple):
    """Identifiers by SyncManager, PDO in it and entry in that; gaps have none."""

    identifiers: dict[tuple[int, int, int], str]
    axes: tuple[int, ...]
    is_drive: bool


def entry_names(
    device: Device, expanded: Sequence[ExpandedModule], images: Sequence[SmImage], objects: ObjectTable
) -> EntryNames:
    """Unique identifiers: CiA 402 names on axes with evidence, else by entry, PDO and slot name."""
    profiles = [*device.profiles, *(profile for item in expanded for profile in item.module.profiles)]
    axes = tuple(_axes(profiles, images, objects))
    keys, candidates = [], []
    for image in images:
        for at, placed in enumerate(image.pdos):
            for number, item in enumerate(placed.entries):
                if item.entry.entry_index:
                    keys.append((image.sm, at, number))
                    candidates.append(
                        _candidates(placed, placed.first_sample(number), item.entry.entry_index, axes, objects)
                    )
    is_drive = bool(axes) or any(_is_motion(profile) for profile in profiles)
    is_drive = is_drive or (device.mailbox is not None and device.mailbox.soe)
    return EntryNames(dict(zip(keys, unique_names(candidates), strict=True)), axes, is_drive)


def _axes(profiles: Sequence[Profile], images: Sequence[SmImage], objects: ObjectTable) -> Iterator[int]:
    """Axes whose controlword or statusword is mapped or declared as a word; the first also by profile number 402.

    On modular I/O 0x6040 is just an input channel, so it has to look like a controlword.
    """
    words = _mapped_words(placed.pdo for image in images for placed in image.pdos)
    for axis in range(MAX_AXES):
        indices = {CONTROLWORD + axis * AXIS_STEP, STATUSWORD + axis * AXIS_STEP}
        declared = [objects.entry(index, 0) for index in indices]
        by_profile = axis == 0 and any(PROFILE_CIA402 in _numbers(profile) for profile in profiles)
        if by_profile or indices & words or all(item is not None and item.bit_size == _WORD_BITS for item in declared):
            yield axis


def _mapped_words(pdos: Iterable[Pdo]) -> set[int | None]:
    return {entry.entry_index for pdo in pdos for entry in pdo.entries if mapped(entry)[1:] == (0, _WORD_BITS)}


def may_drive(module: Module) -> bool:
    """Whether a module drives an axis, wherever it is plugged: by its profiles, or by a controlword in its PDOs."""
    profiles = module.profiles
    by_profile = any(PROFILE_CIA402 in _numbers(profile) or _is_motion(profile) for profile in profiles)
    return by_profile or not _AXIS_WORDS.isdisjoint(_mapped_words((*module.rx_pdos, *module.tx_pdos)))


def _numbers(profile: Profile) -> set[int | None]:
    return {profile.profile_no, *(channel.profile_no for channel in profile.channel_infos)}


def _is_motion(profile: Profile) -> bool:
    kinds = [(profile.profile_no, profile.add_info), *((c.profile_no, c.add_info) for c in profile.channel_infos)]
    return any(number == PROFILE_MODULAR and info is not None and info in _MOTION_MODULES for number, info in kinds)


def _candidates(
    placed: PlacedPdo, first: Entry, sample_index: int, axes: Sequence[int], objects: ObjectTable
) -> list[str]:
    """Names from plain to precise; what an entry is says the ``first`` sample, which one it is ``sample_index``."""
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
    return [*precise, f"{plain}_{sample_index:04x}_{subindex:02x}"]


def _cia402_name(index: int, subindex: int, axes: Sequence[int]) -> str | None:
    for axis in axes:
        name = CIA402_NAMES.get(index - axis * AXIS_STEP)
        if name is not None:
            part = f"{name}_{subindex}" if subindex else name
            return f"{part}_axis{axis}" if axis else part
    return None
