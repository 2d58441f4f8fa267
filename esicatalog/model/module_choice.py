"""Modules that are chosen for slots, and how they are named: several modules of a device may share their ModuleIdent.

Bus couplers give terminals of one kind one ident (BK1120: 19 modules of ident 0x8201), some with other PDOs.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.slots import Slot
from esicatalog.identity import ModuleChoice
from esicatalog.model.slots import PluggedModule, accepts, configure_alike, default_modules, numbered_slots, slot_runs
from esicatalog.words import one_line

_MOST_NAMED = 10


class FittingModule(NamedTuple):
    """A module that can be chosen for a slot."""

    choice: ModuleChoice
    name: str
    is_plugged: bool


class SlotOffer(NamedTuple):
    """Slots of one Slot element, one behind the other, that have the same module or none, and what can be chosen."""

    numbers: range
    name: str
    fitting: tuple[FittingModule, ...]
    """Described modules; one without ModuleIdent cannot be chosen."""

    @property
    def number_words(self) -> str:
        """The slots as sheets and pages say them: ``3`` or ``0 to 253``."""
        first, last = self.numbers[0], self.numbers[-1]
        return str(first) if first == last else f"{first} to {last}"


def module_labels(modules: Sequence[Module]) -> list[str]:
    """What tells modules of one ident apart: Type, with a number where that is the same, or empty, too."""
    keys = [(module.module_ident, one_line(module.type or "")) for module in modules]
    counts, seen = Counter(keys), Counter[tuple[int | None, str]]()
    labels = []
    for key in keys:
        seen[key] += 1
        labels.append(key[1] if key[1] and counts[key] == 1 else f"{key[1]}#{seen[key]}")
    return labels


def module_choices(modules: Sequence[Module]) -> list[ModuleChoice | None]:
    """How each module is chosen: by its ident alone where no other has it; None without ident."""
    counts = Counter(module.module_ident for module in modules)
    return [
        ModuleChoice(module.module_ident, label if counts[module.module_ident] > 1 else None)
        if module.module_ident is not None
        else None
        for module, label in zip(modules, module_labels(modules), strict=True)
    ]


def chosen_modules(
    device: Device,
    modules: Sequence[Module],
    choice: Mapping[int, ModuleChoice],
    variants_with_slots: Sequence[int],
) -> list[PluggedModule]:
    """The default modules with the chosen ones in their place.

    ``variants_with_slots`` are the descriptions of the same identity that have slots, to name where this one has none.
    Raises :class:`InputError` for a slot that does not exist, a module that does not fit, and an ident that several
    modules have that are configured in different ways.
    """
    plugged = {item.slot_number: item for item in default_modules(device, modules)}
    if not choice:
        return [plugged[number] for number in sorted(plugged)]
    slots = {number: slot for number, slot, _ in numbered_slots(device)}
    labels = module_labels(modules)
    for number, wanted in choice.items():
        slot = slots.get(number)
        if slot is None:
            raise InputError(
                f"the device has no slot {number}; its slots are 0 to {len(slots) - 1}"
                if slots
                else _without_slots(variants_with_slots)
            )
        fitting = [item for item in zip(modules, labels, strict=True) if accepts(slot, item[0])]
        plugged[number] = PluggedModule(number, slot, _meant(number, fitting, wanted))
    return [plugged[number] for number in sorted(plugged)]


def _without_slots(variants_with_slots: Sequence[int]) -> str:
    if not variants_with_slots:
        return "the device has no slots"
    others = ", ".join(f"@{variant}" for variant in variants_with_slots)
    return f"the device has no slots in this variant; variants with slots: {others}"


def _meant(slot_number: int, fitting: Sequence[tuple[Module, str]], wanted: ModuleChoice) -> Module:
    """The module of a slot that a choice names; the first of several that are configured in the same way."""
    alike = [(module, label) for module, label in fitting if module.module_ident == wanted.module_ident]
    named = [(module, label) for module, label in alike if wanted.label in (None, label, one_line(module.type or ""))]
    if not named:
        others: Sequence[tuple[Module, str | None]] = alike or [(module, None) for module, _ in fitting]
        raise InputError(f"module {wanted} does not fit slot {slot_number}; what fits: {_listed(others)}")
    if not configure_alike([module for module, _ in named]):
        raise InputError(
            f"module {wanted} is ambiguous in slot {slot_number}: {len(named)} modules have this ident; write one of: "
            + _listed(named)
        )
    return named[0][0]


def slot_offers(device: Device, modules: Sequence[Module], plugged: Iterable[PluggedModule]) -> Iterator[SlotOffer]:
    """All slots with the modules that fit them, in the order of their numbers; ``modules`` are all of the device."""
    there = {item.slot_number: item.module for item in plugged}
    labelled = list(zip(modules, module_choices(modules), strict=True))
    for slot, numbers in slot_runs(device):
        fitting = [(module, choice) for module, choice in labelled if choice is not None and accepts(slot, module)]
        for _, group in groupby(numbers, lambda number: id(there.get(number))):
            alike = list(group)
            yield SlotOffer(
                range(alike[0], alike[-1] + 1),
                display_text(slot.names) or "",
                tuple(
                    FittingModule(choice, module_name(module), module is there.get(alike[0]))
                    for module, choice in fitting
                ),
            )


def module_name(module: Module) -> str:
    """What a module is called; its Type where it has no name."""
    return display_text(module.names) or module.type or ""


def fitting_choices(slot: Slot, modules: Sequence[Module]) -> str:
    """How the modules that fit a slot are chosen there, in words."""
    labelled = zip(modules, module_choices(modules), strict=True)
    return _listed(
        (module, choice.label) for module, choice in labelled if choice is not None and accepts(slot, module)
    )


def _listed(modules: Iterable[tuple[Module, str | None]]) -> str:
    """The first of them as choices, each once, and how many more there are."""
    words = list(
        dict.fromkeys(
            str(ModuleChoice(module.module_ident, label))
            for module, label in modules
            if module.module_ident is not None
        )
    )
    more = [f"and {len(words) - _MOST_NAMED} more; see esicatalog show"] if len(words) > _MOST_NAMED else []
    return ", ".join([*words[:_MOST_NAMED], *more]) or "nothing known"
