"""Slots that need a module and have none, with what is missing for it (ESI-FACTS sections 12 and 18)."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.axes import may_move
from esicatalog.model.required_slots import empty_slots, empty_words, fitting_words, required_empty_slots
from esicatalog.model.slots import PluggedModule


class MissingModules(NamedTuple):
    """What is missing in words, and whether one of the modules, or one that nobody describes, may move something."""

    words: str
    may_move: bool


def missing_modules(
    device: Device, modules: Sequence[Module], plugged: Sequence[PluggedModule]
) -> MissingModules | None:
    """The slots that need a module and have none; all slots where no module is plugged. None where nothing is missing.

    Only modules with PDOs count. That optional slots are empty beside plugged ones is a configuration like any other.
    """
    required = [item for item in required_empty_slots(device, modules, plugged) if item.may_add_pdos]
    lacking = required or ([] if plugged else empty_slots(device, modules, plugged))
    if not lacking:
        return None
    words = (
        f"{empty_words(lacking, bool(required))}: PDOs of modules are missing here; choose with --module SLOT=IDENT; "
        + fitting_words(lacking, modules)
    )
    return MissingModules(
        words, any(not item.are_all_described or any(map(may_move, item.with_pdos)) for item in lacking)
    )


def unplugged_remarks(device: Device, modules: Sequence[Module], plugged: Sequence[PluggedModule]) -> Iterator[str]:
    """Required slots that are empty and that only modules without PDOs fit, which may differ in what they write."""
    lacking = [item for item in required_empty_slots(device, modules, plugged) if not item.may_add_pdos]
    if lacking:
        yield f"{empty_words(lacking, True)}: choose with --module SLOT=IDENT; {fitting_words(lacking, modules)}"
