"""Slots that need a module and have none: what its PDOs add is not known (ESI-FACTS sections 12 and 18).

A required slot stays empty where several modules fit and none is preset, or where what it takes, or has by default, is
not described. An image without such a module is none that the device can have.
"""

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.slots import Slot
from esicatalog.model.assignable_pdos import group_order
from esicatalog.model.module_choice import fitting_choices
from esicatalog.model.pdo_facts import pdos_by_direction
from esicatalog.model.slots import PluggedModule, accepts, preset_ident, required_instances, slot_runs
from esicatalog.model.sm_facts import TRANSFER_DIRECTIONS

_MOST_NUMBERS = 4


class EmptySlots(NamedTuple):
    """Slots of one Slot element that have no module, and the described modules that fit them."""

    slot: Slot
    numbers: tuple[int, ...]
    fitting: tuple[Module, ...]

    @property
    def with_pdos(self) -> tuple[Module, ...]:
        """Those of the modules that have PDOs."""
        return tuple(module for module in self.fitting if module.rx_pdos or module.tx_pdos)

    @property
    def undescribed_default(self) -> int | None:
        """ModuleIdent of the module that is there without a choice, where none of those that fit is it."""
        preset = preset_ident(self.slot)
        return preset if preset not in {module.module_ident for module in self.fitting} else None

    @property
    def are_all_described(self) -> bool:
        """Whether there is a module for each ModuleIdent, and one at all; a module that is not may have PDOs."""
        idents = {module.module_ident for module in self.fitting}
        wanted = [item.module_ident for item in self.slot.module_idents]
        return bool(self.fitting) and self.undescribed_default is None and idents.issuperset(wanted)

    @property
    def may_add_pdos(self) -> bool:
        """Whether a module there may bring PDOs."""
        return bool(self.with_pdos) or not self.are_all_described


class MissingPdos(NamedTuple):
    """What required modules that are not there would add in one direction."""

    words: str
    """Which slots are empty, and what fits."""
    sms: frozenset[int]
    """SyncManagers that PDOs of the modules that fit name."""
    first_slot: int
    """PDOs of modules from this slot on may lie behind them; -1 where those of the device may, too."""


def required_empty_slots(
    device: Device, modules: Sequence[Module], plugged: Sequence[PluggedModule]
) -> list[EmptySlots]:
    """The slots that need a module and have none."""
    return list(_empty(device, modules, plugged, required_instances))


def empty_slots(device: Device, modules: Sequence[Module], plugged: Sequence[PluggedModule]) -> list[EmptySlots]:
    """All slots that have no module and are fitted by one with PDOs."""
    found = _empty(device, modules, plugged, lambda _: None)
    return [item for item in found if item.with_pdos]


def _empty(
    device: Device,
    modules: Sequence[Module],
    plugged: Sequence[PluggedModule],
    instances: Callable[[Slot], int | None],
) -> Iterator[EmptySlots]:
    taken = {item.slot_number for item in plugged}
    for slot, numbers in slot_runs(device):
        if empty := tuple(number for number in numbers[: instances(slot)] if number not in taken):
            yield EmptySlots(slot, empty, tuple(module for module in modules if accepts(slot, module)))


def empty_words(empty: Sequence[EmptySlots], are_required: bool) -> str:
    """Which slots these are: "slots 0, 1 without a module, though required"."""
    numbers = [number for item in empty for number in item.numbers]
    more = f" and {len(numbers) - _MOST_NUMBERS} more" if len(numbers) > _MOST_NUMBERS else ""
    which = f"slot{'' if len(numbers) == 1 else 's'} {', '.join(map(str, numbers[:_MOST_NUMBERS]))}{more}"
    return f"{which} without a module{', though required' if are_required else ''}"


def fitting_words(empty: Sequence[EmptySlots], modules: Sequence[Module]) -> str:
    """What fits the first of them, and default modules of any that nobody describes; ``modules`` are all of the device.

    A description that does not fit the slot is none of its module.
    """
    first = empty[0]
    defaults = [
        f"default module 0x{item.undescribed_default:X} of slot {item.numbers[0]} is not described, or does not fit"
        for item in empty
        if item.undescribed_default is not None
    ]
    return "; ".join(
        [f"what fits slot {first.numbers[0]}: {fitting_choices(first.slot, modules)}", *defaults[:_MOST_NUMBERS]]
    )


def missing_pdos(device: Device, modules: Sequence[Module], plugged: Sequence[PluggedModule]) -> dict[str, MissingPdos]:
    """Which PDOs required slots lack whose modules are not there, by the transfer direction of these PDOs.

    A module that is not described may have PDOs of either direction.
    """
    adding: dict[str, list[EmptySlots]] = defaultdict(list)
    sms: dict[str, set[int]] = defaultdict(set)
    for item in required_empty_slots(device, modules, plugged):
        if not item.may_add_pdos:
            continue
        pdos = [
            (direction, pdo)
            for module in item.with_pdos
            for direction, found in pdos_by_direction(module)
            for pdo in found
        ]
        described = dict.fromkeys(direction for direction, _ in pdos)
        for direction in described if item.are_all_described else TRANSFER_DIRECTIONS:
            adding[TRANSFER_DIRECTIONS[direction]].append(item)
        for direction, pdo in pdos:
            if pdo.sm is not None and not pdo.virtual:
                sms[TRANSFER_DIRECTIONS[direction]].add(pdo.sm)
    return {
        direction: MissingPdos(
            f"{empty_words(items, True)}: PDOs of modules are missing; {fitting_words(items, modules)}",
            frozenset(sms[direction]),
            _first_slot_behind(device, items),
        )
        for direction, items in adding.items()
    }


def _first_slot_behind(device: Device, empty: Sequence[EmptySlots]) -> int:
    """The first slot whose PDOs may lie behind those of the modules that belong into empty ones.

    PDOs lie in the order of the slots; where they lie in groups, those of any slot can come first, and those of the
    device can lie behind.
    """
    if not device.module_pdo_groups:
        return empty[0].numbers[0]
    groups = [module.module_pdo_group if item.are_all_described else None for item in empty for module in item.fitting]
    first = min(map(group_order, groups or [None]))
    return 0 if group_order(device.module_pdo_group) <= first else -1
