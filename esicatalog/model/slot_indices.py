"""Which indices modules can have in the slots of a device, without trying each module in each slot."""

from collections import defaultdict
from collections.abc import Container, Hashable, Mapping, Sequence
from functools import cached_property

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import Object
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.esi.records.profile import declared_objects
from esicatalog.identity import MAX_INDEX
from esicatalog.model.pdo_facts import is_pdo_mapping
from esicatalog.model.slots import ModuleIndex, Step, accepts, slot_runs, slot_steps


def _reaches(wanted: int, moving: ModuleIndex, step: Step, numbers: Container[int]) -> bool:
    """Whether an index comes to lie at ``wanted`` in one of the slots."""
    distance = wanted - moving.unshifted - (step.by_group if moving.by_group else 0)
    if not step.by_slot or not moving.by_slot:
        return distance == 0
    number, rest = divmod(distance, step.by_slot)
    return rest == 0 and number in numbers


class _AlikeSlots:
    """Slots that accept the same modules and move their indices by the same steps."""

    def __init__(self, modules: Sequence[Module], steps: tuple[Step, Step]) -> None:
        self._step_of_objects, self.step_of_pdos = steps
        self.numbers: set[int] = set()
        self._modules = modules

    def step_of(self, moving: ModuleIndex) -> Step:
        """How far an object moves: one that describes a PDO moves as PDOs do."""
        return self.step_of_pdos if is_pdo_mapping(moving.unshifted) else self._step_of_objects

    @cached_property
    def pdos(self) -> set[ModuleIndex]:
        """Indices of the PDOs of all modules that move."""
        pdos = [pdo for module in self._modules for pdo in (*module.rx_pdos, *module.tx_pdos)]
        return {moving for pdo in pdos if (moving := _moving(pdo.pdo_index, pdo)) is not None}

    @cached_property
    def objects(self) -> Mapping[ModuleIndex, list[Module]]:
        """Indices of the objects that move, with the modules that have them."""
        found: dict[ModuleIndex, list[Module]] = defaultdict(list)
        for module in self._modules:
            for declared in declared_objects(module.profiles):
                if (moving := _moving(declared.object_index, declared)) is not None:
                    found[moving].append(module)
        return found


def _moving(index: int | None, item: Pdo | Object) -> ModuleIndex | None:
    if index is None or not (item.depend_on_slot or item.depend_on_slot_group):
        return None
    return ModuleIndex.of(index, item)


class IndicesInSlots:
    """Which indices the modules of a device can have in its slots; worked out when asked for.

    What it takes grows with the indices of modules and with the Slot elements that differ, not with the slots: the
    hundreds of a coupler mostly accept the same modules.
    """

    def __init__(self, device: Device, modules: Sequence[Module]) -> None:
        self._device = device
        self._modules = modules
        self._objects_at: dict[int, list[tuple[Module, int]]] = {}

    @cached_property
    def _alike(self) -> Sequence[_AlikeSlots]:
        fitting: dict[Hashable, list[Module]] = {}
        alike: dict[Hashable, _AlikeSlots] = {}
        for slot, numbers in slot_runs(self._device):
            if not numbers:
                continue
            idents = tuple([item.module_ident for item in slot.module_idents])
            accepted = (idents, tuple([item.module_class for item in slot.module_classes]))
            if accepted not in fitting:
                fitting[accepted] = [module for module in self._modules if accepts(slot, module)]
            steps = slot_steps(self._device, slot)
            slots = alike.setdefault((accepted, steps), _AlikeSlots(fitting[accepted], steps))
            slots.numbers.update(numbers)
        return list(alike.values())

    def has_pdo(self, index: int) -> bool:
        """Whether a module has a PDO at an index in some slot that it moves with."""
        return 0 <= index <= MAX_INDEX and any(
            _reaches(index, moving, slots.step_of_pdos, slots.numbers) for slots in self._alike for moving in slots.pdos
        )

    def objects(self, index: int) -> Sequence[tuple[Module, int]]:
        """The modules that have an object at an index in some slot that it moves with, and its index in the module."""
        if index not in self._objects_at:
            self._objects_at[index] = [
                (module, moving.unshifted)
                for slots in self._alike
                for moving, modules in slots.objects.items()
                if 0 <= index <= MAX_INDEX and _reaches(index, moving, slots.step_of(moving), slots.numbers)
                for module in modules
            ]
        return self._objects_at[index]
