"""Slots whose modules would bring process data, and that have none (ESI-FACTS sections 12 and 18)."""

from collections.abc import Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.slots import Slot
from esicatalog.model.axes import may_move
from esicatalog.model.module_choice import fitting_choices
from esicatalog.model.slots import PluggedModule, fitting_modules, numbered_slots

_MOST_NUMBERS = 4


class MissingModules(NamedTuple):
    """What is missing in words, and whether something may move that one of the modules drives."""

    words: str
    may_move: bool


def missing_modules(
    device: Device, modules: Sequence[Module], plugged: Sequence[PluggedModule]
) -> MissingModules | None:
    """The slots that need a module and have none; all slots where no module is plugged. None where nothing is missing.

    Only modules with PDOs count. That optional slots are empty beside plugged ones is a configuration like any other.
    """
    if not device.slots:
        return None
    with_pdos = [module for module in modules if module.rx_pdos or module.tx_pdos]
    taken = {item.slot_number for item in plugged}
    known = zip(numbered_slots(device), fitting_modules(device, with_pdos), strict=True)
    empty = [(numbered, fitting) for numbered, (_, _, fitting) in known if fitting and numbered[0] not in taken]
    required = [item for item in empty if item[0][2] < (item[0][1].min_instances or 0)]
    lacking = required or ([] if plugged else empty)
    if not lacking:
        return None
    words = _words([slot for slot, _ in lacking], modules, bool(required))
    return MissingModules(words, any(any(map(may_move, fitting)) for _, fitting in lacking))


def _words(lacking: Sequence[tuple[int, Slot, int]], modules: Sequence[Module], are_required: bool) -> str:
    numbers = ", ".join(str(number) for number, _, _ in lacking[:_MOST_NUMBERS])
    more = f" and {len(lacking) - _MOST_NUMBERS} more" if len(lacking) > _MOST_NUMBERS else ""
    number, slot, _ = lacking[0]
    which = f"{'slot' if len(lacking) == 1 else 'slots'} {numbers}{more}"
    without = f"{which} without a module{', though required' if are_required else ''}"
    return (
        f"{without}: PDOs of modules are missing here; choose with --module SLOT=IDENT; "
        f"what fits slot {number}: {fitting_choices(slot, modules)}"
    )
