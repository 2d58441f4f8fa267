"""A device as a master sees it against its description: PDOs, mappings, objects.

What differs is told in sentences that begin with the place. Masters print the PDOs that the device has now, so an
assignment other than the default one is told as such and need not be a fault.
"""

import itertools
from collections import defaultdict
from collections.abc import Collection, Container, Iterator, Mapping, Sequence

import msgspec

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import RX_PDO, Pdo
from esicatalog.esi.records.profile import dictionaries_of
from esicatalog.model.access import STATE_WORDS, access_text
from esicatalog.model.base_types import base_type
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.dictionary_views import DictionaryView, DictionaryViews, EntriesBySubindex, counting_view
from esicatalog.model.eeprom_pdos import eeprom_pdos
from esicatalog.model.oversampling import has_oversampling
from esicatalog.model.pdo_facts import Mapped, has_length, is_described, mapped, mapped_words
from esicatalog.model.process_image import PlacedPdo, default_process_image, process_image, virtual_pdos
from esicatalog.model.slots import SlotShift, fitting_modules, numbered_slots
from esicatalog.scan.records import ScannedDictionary, ScannedObjectEntry, ScannedPdo, ScannedPdos
from esicatalog.words import counted

_MOST_PLACES = 2_000_000
"""How much is looked at of modules in slots, each of their parts in each slot; couplers of 254 slots need a million."""

_Mapping = tuple[Mapped, ...] | None
"""What the entries of a described PDO map, as far as it says; None for variable content."""

_ALIKE = {"uint": "uint", "bits": "uint", "bool": "bool"}
"""Kinds that devices and descriptions use for the same thing."""


def compare_scanned_pdos(device: Device, modules: Sequence[Module], seen: ScannedPdos) -> list[str]:
    """What of the printed PDOs is not as described: unknown PDOs, other mappings, another assignment.

    SyncManagers without PDOs may be left out of the list, those that have some by default not. Mappings are compared
    where entries are listed; any assignment is as described where nothing describes what a SyncManager exchanges. What
    is virtual at a SyncManager may be listed there, as the EEPROM has it, or not. Where all that the EEPROM
    assigns is more than the default, a list of that is told as what it is: it says nothing of the device's assignment.
    """
    slots = _AnySlot(device, modules, sum(1 + len(pdo.entries) for module in modules for _, pdo in _pdos(module)))
    printed = {pdo.index for sync_manager in seen.sync_managers for pdo in sync_manager.pdos}
    known = _described_pdos(device, slots, printed)
    images = default_process_image(device, modules)
    assigned = {image.sm: [pdo.pdo.pdo_index for pdo in image.pdos] for image in images}
    left_open = {image.sm for image in images if image.left_open is not None}
    virtual = virtual_pdos(images)
    in_eeprom: dict[int, list[int]] = defaultdict(list)
    for item in eeprom_pdos(device):
        in_eeprom[item.sm].append(item.pdo_index)
    found: list[str] = []
    for sync_manager in seen.sync_managers:
        for pdo in sync_manager.pdos:
            found.extend(_pdo_differences(pdo, known, seen.lists_entries))
        now = [pdo.index for pdo in sync_manager.pdos if (sync_manager.number, pdo.index) not in virtual]
        default = [index for index in assigned.get(sync_manager.number, ()) if index is not None]
        if now != default and sync_manager.number not in left_open:
            listed_pdos = [pdo.index for pdo in sync_manager.pdos]
            is_eeprom = listed_pdos == in_eeprom[sync_manager.number] and set(default) < set(now)
            reason = " (all that the EEPROM assigns, also what the default leaves out)" if is_eeprom else ""
            words = f"assigned are {_pdo_words(now)}{reason}; the default is {_pdo_words(default)}"
            found.append(f"SM{sync_manager.number}: {words}")
    listed = {sync_manager.number for sync_manager in seen.sync_managers}
    for number, indices in assigned.items():
        default = [index for index in indices if index is not None]
        if number not in listed and default:
            found.append(f"SM{number}: not in the list; the default is {_pdo_words(default)}")
    return [*found, *slots.left_out()]


def _pdo_words(indices: Sequence[int]) -> str:
    return ", ".join(f"0x{index:04X}" for index in indices) or "none"


class _AnySlot:
    """Modules in every slot that accepts them, for the master does not say what is plugged.

    ``parts`` is what there is to look at in all modules: with it the number of slots is limited.
    """

    def __init__(self, device: Device, modules: Sequence[Module], parts: int) -> None:
        self._device = device
        self._modules = modules
        self._most = _MOST_PLACES // (1 + len(modules) + parts)

    def __iter__(self) -> Iterator[tuple[Module, SlotShift]]:
        for number, slot, fitting in itertools.islice(fitting_modules(self._device, self._modules), self._most):
            shift = SlotShift(self._device, slot, number)
            for module in fitting:
                yield module, shift

    def left_out(self) -> Iterator[str]:
        """A sentence when there are more slots than were looked at."""
        declared = sum(max(slot.max_instances or 1, 1) for slot in self._device.slots)
        looked_at = min(sum(1 for _ in numbered_slots(self._device)), self._most)
        if self._modules and looked_at < declared:
            yield f"{looked_at} of {declared} slots were looked at: what is not described may be of a module in another"


def _pdos(owner: Device | Module) -> Iterator[tuple[bool, Pdo]]:
    """PDOs with their direction (true = RxPDO)."""
    yield from ((True, pdo) for pdo in owner.rx_pdos)
    yield from ((False, pdo) for pdo in owner.tx_pdos)


def _described_pdos(
    device: Device, slots: _AnySlot, printed: Container[int]
) -> Mapping[tuple[bool, int], dict[_Mapping, None]]:
    """Mappings by direction (true = RxPDO) and index: the device's own, and what modules bring of the printed ones."""
    known: dict[tuple[bool, int], dict[_Mapping, None]] = defaultdict(dict)
    for is_rx, pdo in _pdos(device):
        if pdo.pdo_index is not None:
            known[is_rx, pdo.pdo_index][_described_mapping(pdo)] = None
    for placed in _sample_pdos(device):
        entries = tuple([item.entry for item in placed.entries])
        mapping = _described_mapping(msgspec.structs.replace(placed.pdo, entries=entries))
        known[placed.direction == RX_PDO, placed.pdo.pdo_index or 0][mapping] = None
    for module, shift in slots:
        for is_rx, pdo in _pdos(module):
            if pdo.pdo_index is None:
                continue
            index = shift.pdo_index(pdo.pdo_index, pdo.depend_on_slot, pdo.depend_on_slot_group)
            if index in printed:
                known[is_rx, index][_described_mapping(shift.pdo(pdo))] = None
    return known


def _sample_pdos(device: Device) -> Iterator[PlacedPdo]:
    """The PDOs that hold one sample each, in any of its OpModes."""
    for op_mode in (None, *device.op_modes) if has_oversampling(device) else ():
        for image in process_image(device, (), op_mode):
            yield from (placed for placed in image.pdos if placed.sample)


def _described_mapping(pdo: Pdo) -> _Mapping:
    if not pdo.entries and not is_described(pdo):
        return None
    found = [(mapped(entry), has_length(entry)) for entry in pdo.entries]
    return tuple((index, subindex, bits if known else None) for (index, subindex, bits), known in found)


def _fits(printed: Mapped, described: Mapped) -> bool:
    """Whether an entry is as described; what the description leaves open may be anything."""
    index, subindex, bits = described
    is_same = index is None or (printed[0] == index and (isinstance(subindex, str) or printed[1] == subindex))
    return is_same and (bits is None or printed[2] == bits)


def _pdo_differences(
    pdo: ScannedPdo, known: Mapping[tuple[bool, int], Collection[_Mapping]], lists_entries: bool
) -> Iterator[str]:
    where = f"{'Rx' if pdo.is_rx else 'Tx'}PDO 0x{pdo.index:04X}"
    mappings = known.get((pdo.is_rx, pdo.index))
    if mappings is None:
        yield f"{where}: not described"
    if mappings is None or not lists_entries:
        return
    printed = [(e.index, e.subindex if e.index else 0, e.bit_length) for e in pdo.entries]
    described = [mapping for mapping in mappings if mapping is not None]
    if len(described) < len(mappings) or any(
        len(mapping) == len(printed) and all(map(_fits, printed, mapping)) for mapping in described
    ):
        return
    nearest = min(described, key=lambda mapping: abs(len(mapping) - len(printed)))
    if len(printed) != len(nearest):
        yield f"{where}: maps {counted(len(printed), 'entry', 'entries')}; described with {len(nearest)}"
    for number, (ours, theirs) in enumerate(zip(printed, nearest, strict=False), 1):
        if not _fits(ours, theirs):
            yield f"{where}, entry {number}: maps {mapped_words(*ours)}; described is {mapped_words(*theirs)}"


def compare_scanned_objects(device: Device, modules: Sequence[Module], seen: ScannedDictionary) -> list[str] | None:
    """What of the printed object dictionary is not as described: objects, subindices, types, access.

    Objects that only a module brings need not be there, and entries only where some are listed. None where the
    description has no dictionary of the device itself: nothing is compared then, which is another thing than no
    difference.
    """
    views = DictionaryViews()
    described = views.of(device.profiles)
    own = sorted({index for view in described for index in view.by_index})
    if not own:
        return None
    shown = {item.index for item in seen.objects}
    object_count = sum(len(item.objects) for module in modules for item in dictionaries_of(module.profiles))
    slots = _AnySlot(device, modules, object_count)
    brought = _brought_objects(slots, shown, views)
    known = {index: _alternatives(described, brought, index) for index in shown.union(own)}
    found = [
        f"0x{item.index:04X}: not described ({item.name or 'no name'})"
        for item in seen.objects
        if not known[item.index]
    ]
    found.extend(f"0x{index:04X}: described, but not on the device" for index in own if index not in shown)
    printed = {(item.index, entry.subindex): entry for item in seen.objects for entry in item.entries}
    for (index, subindex), printed_entry in sorted(printed.items()):
        where = f"0x{index:04X}:{subindex:02X}"
        alternatives = [entries[subindex] for entries in known[index] if subindex in entries]
        if alternatives:
            differences = [list(_entry_differences(printed_entry, entry)) for entry in alternatives]
            found.extend(f"{where}: {words}" for words in min(differences, key=len))
        elif known[index]:
            found.append(f"{where}: not described ({printed_entry.name or 'no name'})")
    for index in own if seen.lists_entries else ():
        if index in shown and len(known[index]) == 1:
            for subindex, entry in sorted(known[index][0].items()):
                if (index, subindex) not in printed:
                    where = f"0x{index:04X}:{subindex:02X}"
                    found.append(f"{where}: described ({entry.name or 'no name'}), but not on the device")
    return [*found, *slots.left_out()]


_Brought = Mapping[int, Mapping[tuple[DictionaryView, int], None]]
"""Objects of modules by the index that they have in a slot: alternatives in order, each by its place unplugged."""


def _brought_objects(slots: _AnySlot, shown: Container[int], views: DictionaryViews) -> _Brought:
    """What modules bring of the printed objects."""
    found: dict[int, dict[tuple[DictionaryView, int], None]] = defaultdict(dict)
    for module, shift in slots:
        of_module = views.of(module.profiles)
        for view in of_module:
            for base, declared in view.by_index.items():
                index = shift.object_index(base, declared.depend_on_slot, declared.depend_on_slot_group)
                if index in shown and counting_view(of_module, base) is view:
                    found[index][view, base] = None
    return found


def _alternatives(described: Sequence[DictionaryView], brought: _Brought, index: int) -> list[EntriesBySubindex]:
    """What is described at an index: the object of the device itself, else that of each module that may be plugged.

    Both where the device's is marked OverwrittenByModule (ESI-FACTS section 12).
    """
    own = counting_view(described, index)
    places = [(own, index)] if own is not None else []
    if own is None or own.by_index[index].overwritten_by_module:
        places += brought.get(index, ())
    return [view.entries(place) or {} for view, place in places]


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
            yield f"access {seen.access} ({STATE_WORDS}); described is {expected}"


def _kind(kind: str) -> str:
    return _ALIKE.get(kind, kind)
