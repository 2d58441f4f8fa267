"""A device as a master sees it against its description: PDOs, mappings, objects.

What differs is told in sentences that begin with the place. Masters print the PDOs that the device has now, so an
assignment other than the default one is told as such and need not be a fault.
"""

import itertools
from collections.abc import Iterator, Mapping, Sequence

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.base_types import base_type
from esicatalog.model.dictionary import ObjectEntry, resolve_object, type_table
from esicatalog.model.process_image import default_process_image
from esicatalog.model.slots import PluggedModule, accepts, expand_module, numbered_slots
from esicatalog.scan.records import ScannedDictionary, ScannedObjectEntry, ScannedPdo, ScannedPdos

_MOST_SLOTS = 16
_STATES = ("PREOP", "SAFEOP", "OP")
_READ_BITS, _WRITE_BITS = 0, 3
"""Lowest bits of the CoE access word for reading and writing."""

_Mapping = tuple[tuple[int, int, int], ...]
"""(index, subindex, bit length) of entries; index and subindex 0 for gaps."""

_ALIKE = {"uint": "uint", "bits": "uint", "bool": "bool"}
"""Kinds that devices and descriptions use for the same thing."""


def compare_pdos(device: Device, modules: Sequence[Module], seen: ScannedPdos) -> list[str]:
    """What of the printed PDOs is not as described: unknown PDOs, other mappings, another assignment."""
    known = _described_pdos(device, modules)
    assigned = {image.sm: [pdo.pdo.pdo_index for pdo in image.pdos] for image in default_process_image(device, modules)}
    found: list[str] = []
    for sync_manager in seen.sync_managers:
        for pdo in sync_manager.pdos:
            found.extend(_pdo_differences(pdo, known))
        now = [pdo.index for pdo in sync_manager.pdos]
        default = assigned.get(sync_manager.number, [])
        if now and now != default:
            listed = ", ".join(f"0x{index:04X}" for index in default if index is not None) or "none"
            shown = ", ".join(f"0x{index:04X}" for index in now)
            found.append(f"SM{sync_manager.number}: assigned are {shown}; the default is {listed}")
    return found


def _described_pdos(device: Device, modules: Sequence[Module]) -> dict[tuple[bool, int], set[_Mapping]]:
    """Mappings by direction (true = RxPDO) and index: the device's own, and those of modules in any slot."""
    known: dict[tuple[bool, int], set[_Mapping]] = {}
    owners: list[Device | Module] = [device, *_expanded_modules(device, modules)]
    for owner in owners:
        for is_rx, pdos in ((True, owner.rx_pdos), (False, owner.tx_pdos)):
            for pdo in pdos:
                if pdo.pdo_index is not None:
                    known.setdefault((is_rx, pdo.pdo_index), set()).add(_described_mapping(pdo))
    return known


def _expanded_modules(device: Device, modules: Sequence[Module]) -> Iterator[Module]:
    """What every fitting module becomes in each of the first slots: the master does not say what is plugged."""
    for number, slot, _ in itertools.islice(numbered_slots(device), _MOST_SLOTS):
        for module in modules:
            if accepts(slot, module):
                yield expand_module(device, PluggedModule(number, slot, module)).module


def _described_mapping(pdo: Pdo) -> _Mapping:
    return tuple(
        (entry.entry_index or 0, (entry.subindex or 0) if entry.entry_index else 0, entry.bit_length or 0)
        for entry in pdo.entries
    )


def _pdo_differences(pdo: ScannedPdo, known: Mapping[tuple[bool, int], set[_Mapping]]) -> Iterator[str]:
    where = f"{'Rx' if pdo.is_rx else 'Tx'}PDO 0x{pdo.index:04X}"
    mappings = known.get((pdo.is_rx, pdo.index))
    if mappings is None:
        yield f"{where}: not described"
        return
    mapped = tuple((e.index, e.subindex if e.index else 0, e.bit_length) for e in pdo.entries)
    if mapped in mappings:
        return
    described = min(mappings, key=lambda mapping: abs(len(mapping) - len(mapped)))
    if len(mapped) != len(described):
        yield f"{where}: maps {len(mapped)} entries; described are {len(described)}"
    for number, (ours, theirs) in enumerate(zip(mapped, described, strict=False), 1):
        if ours != theirs:
            yield f"{where}, entry {number}: maps {_entry_words(*ours)}; described is {_entry_words(*theirs)}"


def _entry_words(index: int, subindex: int, bits: int) -> str:
    return f"0x{index:04X}:{subindex:02X} ({bits} bit)" if index else f"a gap of {bits} bit"


def compare_objects(device: Device, modules: Sequence[Module], seen: ScannedDictionary) -> list[str]:
    """What of the printed object dictionary is not as described: objects, subindices, types, access.

    Objects that only a module brings need not be there. A description without dictionary says nothing.
    """
    own = _described_entries(device)
    if not own:
        return []
    described = dict(own)
    for module in _expanded_modules(device, modules):
        for key, entry in _described_entries(module).items():
            described.setdefault(key, entry)
    printed = {(item.index, entry.subindex): entry for item in seen.objects for entry in item.entries}
    indices = {index for index, _ in described}
    found = [
        f"0x{item.index:04X}: not described ({item.name or 'no name'})"
        for item in seen.objects
        if item.index not in indices
    ]
    shown = {item.index for item in seen.objects}
    for index in dict.fromkeys(index for index, _ in own if index not in shown):
        found.append(f"0x{index:04X}: described, but not on the device")
    for (index, subindex), printed_entry in sorted(printed.items()):
        known = described.get((index, subindex))
        where = f"0x{index:04X}:{subindex:02X}"
        if known is not None:
            found.extend(f"{where}: {words}" for words in _entry_differences(printed_entry, known))
        elif index in indices:
            found.append(f"{where}: not described ({printed_entry.name or 'no name'})")
    for index, subindex in sorted(own):
        if index in shown and (index, subindex) not in printed:
            name = own[index, subindex].name or "no name"
            found.append(f"0x{index:04X}:{subindex:02X}: described ({name}), but not on the device")
    return found


def _described_entries(owner: Device | Module) -> dict[tuple[int, int], ObjectEntry]:
    found: dict[tuple[int, int], ObjectEntry] = {}
    for profile in owner.profiles:
        if profile.dictionary is None:
            continue
        types = type_table(profile.dictionary.data_types)
        for declared in profile.dictionary.objects:
            if declared.object_index is None:
                continue
            resolved = resolve_object(declared, types)
            for entry in resolved.entries:
                found.setdefault((declared.object_index, entry.subindex), entry)
    return found


def _entry_differences(seen: ScannedObjectEntry, described: ObjectEntry) -> Iterator[str]:
    ours, theirs = base_type(seen.data_type), base_type(described.base_type)
    if ours is not None and theirs is not None and _kind(ours.kind) != _kind(theirs.kind):
        yield f"type {seen.data_type}; described is {described.data_type}"
    size = seen.bit_length if seen.bit_length is not None else (ours.bit_size if ours is not None else None)
    if size and described.bit_size and size != described.bit_size:
        yield f"{size} bit; described are {described.bit_size}"
    if seen.access is not None:
        expected = access_text(described.access_word)
        if seen.access != expected:
            yield f"access {seen.access} ({', '.join(_STATES)}); described is {expected}"


def _kind(kind: str) -> str:
    return _ALIKE.get(kind, kind)


def access_text(access_word: int) -> str:
    """A CoE access word as masters print it: read and write in PREOP, SAFEOP and OP, ``rwrwr-``."""
    return "".join(
        ("r" if access_word >> (_READ_BITS + state) & 1 else "-")
        + ("w" if access_word >> (_WRITE_BITS + state) & 1 else "-")
        for state in range(len(_STATES))
    )
