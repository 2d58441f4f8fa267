"""Slots and modules: which modules a device can carry, which it carries by default, and what they become in a slot.

Rules of ESI-FACTS section 12: object indices shift by SlotIndexIncrement, PDO indices by SlotPdoIncrement, both times
the slot number and only where DependOnSlot says so; slot groups likewise.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import msgspec

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.esi.records.slots import Slot

MAX_INDEX = 0xFFFF


class PluggedModule(NamedTuple):
    """A module in a slot."""

    slot_number: int
    slot: Slot
    module: Module


def reachable_modules(device: Device, modules: Iterable[Module]) -> list[Module]:
    """The modules that any slot of the device accepts, by ModuleIdent or by ModuleClass, in the order given."""
    idents = {item.module_ident for slot in device.slots for item in slot.module_idents}
    classes = {item.module_class for slot in device.slots for item in slot.module_classes}
    classes.discard(None)
    idents.discard(None)
    if not idents and not classes:
        return []
    return [module for module in modules if module.module_ident in idents or module.module_class in classes]


def default_modules(device: Device, modules: Sequence[Module]) -> list[PluggedModule]:
    """What is plugged without a choice: per required slot the module marked Default, else its only module."""
    by_ident = {module.module_ident: module for module in reversed(modules)}
    plugged = []
    number = 0
    for slot in device.slots:
        preset = [item.module_ident for item in slot.module_idents if item.is_default]
        if not preset and len(slot.module_idents) == 1:
            preset = [slot.module_idents[0].module_ident]
        instances = slot.min_instances or (1 if any(item.is_default for item in slot.module_idents) else 0)
        for instance in range(min(instances, slot.max_instances or instances)):
            module = by_ident.get(preset[0]) if preset else None
            if module is not None:
                plugged.append(PluggedModule(number + instance, slot, module))
        number += max(slot.max_instances or 1, 1)
    return plugged


class SlotShift(NamedTuple):
    """By how much indices move in a slot."""

    object_shift: int
    object_shift_of_group: int
    pdo_shift: int
    pdo_shift_of_group: int

    def object_index(self, index: int, by_slot: bool | None, by_group: bool | None) -> int:
        """Shifted object index; one that would leave 16 bits stays where it is."""
        moved = index + (self.object_shift if by_slot else 0) + (self.object_shift_of_group if by_group else 0)
        return moved if moved <= MAX_INDEX else index

    def pdo_index(self, index: int, by_slot: bool | None, by_group: bool | None) -> int:
        """Shifted PDO index; one that would leave 16 bits stays where it is."""
        moved = index + (self.pdo_shift if by_slot else 0) + (self.pdo_shift_of_group if by_group else 0)
        return moved if moved <= MAX_INDEX else index


def slot_shift(device: Device, slot: Slot, slot_number: int) -> SlotShift:
    """Increments of the slot, else of the device, times the slot's (and its group's) number."""

    def increment(own: int | None, common: int | None) -> int:
        return (own if own is not None else common) or 0

    group = slot.slot_group or 0
    return SlotShift(
        slot_number * increment(slot.slot_index_increment, device.slot_index_increment),
        group * increment(slot.slot_group_index_increment, device.slot_group_index_increment),
        slot_number * increment(slot.slot_pdo_increment, device.slot_pdo_increment),
        group * increment(slot.slot_group_pdo_increment, device.slot_group_pdo_increment),
    )


def shift_pdo(pdo: Pdo, shift: SlotShift) -> Pdo:
    """The PDO of a module as it is in the slot: its index, exclusions and entries shifted."""

    def moved(item: Pdo | Exclude) -> int | None:
        if item.pdo_index is None:
            return None
        return shift.pdo_index(item.pdo_index, item.depend_on_slot, item.depend_on_slot_group)

    def entry(item: Entry) -> Entry:
        if not item.entry_index:
            return item
        index = shift.object_index(item.entry_index, item.depend_on_slot, item.depend_on_slot_group)
        return item if index == item.entry_index else msgspec.structs.replace(item, entry_index=index)

    return msgspec.structs.replace(
        pdo,
        pdo_index=moved(pdo),
        excludes=tuple(msgspec.structs.replace(item, pdo_index=moved(item)) for item in pdo.excludes),
        entries=tuple(map(entry, pdo.entries)),
    )
