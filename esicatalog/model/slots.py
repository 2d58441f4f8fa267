"""Slots and modules: which modules a device can carry, which it carries by default, and what they become in a slot.

Rules of ESI-FACTS section 12: object indices shift by SlotIndexIncrement, PDO indices by SlotPdoIncrement, both times
the slot number (counted from 0 over all instances) and only where DependOnSlot says so; slot groups likewise.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import product
from typing import Any, NamedTuple, TypeVar

import msgspec

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import Object
from esicatalog.esi.records.mailbox import InitCmd, coe_init_cmds
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.esi.records.profile import Profile, declared_objects
from esicatalog.esi.records.slots import Slot
from esicatalog.identity import MAX_INDEX
from esicatalog.model.pdo_facts import is_pdo_mapping

MAX_INSTANCES = 255

Shifted = TypeVar("Shifted", Entry, InitCmd, Object)
Move = Callable[[int, bool | None, bool | None], int]
"""Where an index moves to that depends on the slot, and on the group of the slot."""


class PluggedModule(NamedTuple):
    """A module in a slot."""

    slot_number: int
    slot: Slot
    module: Module


class ExpandedModule(NamedTuple):
    """What a module is in its slot: a module with concrete indices; ``problems`` name indices that do not fit."""

    slot_number: int
    module: Module
    problems: tuple[str, ...]


class ModuleIndex(NamedTuple):
    """An index as a module gives it, and what it follows."""

    unshifted: int
    by_slot: bool
    by_group: bool

    @classmethod
    def of(cls, index: int, item: Pdo | Object) -> "ModuleIndex":
        """The index of a PDO or an object of a module."""
        return cls(index, bool(item.depend_on_slot), bool(item.depend_on_slot_group))


class ModuleVendor(NamedTuple):
    """Whose a module is, and whose the device with the slot; None where a document does not say it."""

    of_module: int | None = None
    of_device: int | None = None

    def fits(self, wanted: int | None) -> bool:
        """Whether it is the vendor that a ModuleClass wants: VendorId, without one that of the device."""
        vendor = self.of_device if wanted is None else wanted
        return vendor is None or self.of_module in (None, vendor)


_ANY_VENDOR = ModuleVendor()


def reachable_modules(device: Device, modules: Iterable[Module]) -> list[Module]:
    """The modules that any slot of the device accepts, of whatever vendor, in the order given."""
    return [module for module in modules if any(accepts(slot, module) for slot in device.slots)]


def accepts(slot: Slot, module: Module, vendor: ModuleVendor = _ANY_VENDOR) -> bool:
    """Whether a module fits a slot: by its ModuleIdent, or by its ModuleClass and vendor."""
    if module.module_ident is not None and any(item.module_ident == module.module_ident for item in slot.module_idents):
        return True
    wanted = module.module_class
    return wanted is not None and any(
        item.module_class == wanted and vendor.fits(item.class_vendor_id) for item in slot.module_classes
    )


def numbered_slots(device: Device) -> Iterator[tuple[int, Slot, int]]:
    """Every slot with its number and the instance of its Slot element, counted from 0."""
    for slot, numbers in slot_runs(device):
        for instance, number in enumerate(numbers):
            yield number, slot, instance


def slot_runs(device: Device) -> Iterator[tuple[Slot, range]]:
    """Every Slot element with the numbers of the slots that it stands for: none where MaxInstances is 0."""
    first = 0
    for slot in device.slots:
        instances = slot.max_instances if slot.max_instances is not None else 1
        numbers = range(first, first + min(max(instances, 0), MAX_INSTANCES))
        yield slot, numbers
        first = numbers.stop


def fitting_modules(device: Device, modules: Sequence[Module]) -> Iterator[tuple[int, Slot, list[Module]]]:
    """Every slot with its number and the modules that it accepts."""
    fitting: dict[int, list[Module]] = {}
    for number, slot, _ in numbered_slots(device):
        if id(slot) not in fitting:
            fitting[id(slot)] = [module for module in modules if accepts(slot, module)]
        yield number, slot, fitting[id(slot)]


def preset_ident(slot: Slot) -> int | None:
    """ModuleIdent of what a slot has without a choice, be that module described or not.

    The first that is marked Default, else Slot/@Default, else Slot/@Fallback of schema 1.17: "automatically plugged
    when no other module is plugged to this slot", which is no word about a default module that nobody describes.
    """
    marked = [item.module_ident for item in slot.module_idents if item.is_default]
    return next((ident for ident in (*marked, slot.default_ident, slot.fallback_ident) if ident is not None), None)


def required_instances(slot: Slot) -> int:
    """How many slots of a Slot element need a module: MinInstances; a preset makes the first one such a slot."""
    return slot.min_instances or (1 if preset_ident(slot) is not None else 0)


def default_modules(device: Device, modules: Sequence[Module]) -> list[PluggedModule]:
    """What is plugged without a choice: in required slots the preset module, else that of the only ModuleIdent.

    Nothing is plugged where no described module of the ident fits, where several do that are configured in different
    ways, nor for a ModuleClass: what else belongs to it may be described in other documents.
    """
    by_ident: dict[int | None, list[Module]] = defaultdict(list)
    for module in modules:
        by_ident[module.module_ident].append(module)
    plugged = []
    for slot, numbers in slot_runs(device):
        ident = preset_ident(slot)
        if ident is None and len(slot.module_idents) == 1:
            ident = slot.module_idents[0].module_ident
        described = by_ident.get(ident, []) if ident is not None else []
        fitting = [module for module in described if accepts(slot, module)]
        if fitting and configure_alike(fitting):
            plugged += [PluggedModule(number, slot, fitting[0]) for number in numbers[: required_instances(slot)]]
    return plugged


def configure_alike(modules: Sequence[Module]) -> bool:
    """Whether any of some modules can stand for all: with each the process image, start-up and clocks are the same."""
    return all(_effects(module) == _effects(modules[0]) for module in modules[1:])


def _effects(module: Module) -> tuple[Any, ...]:
    """What a module makes of the process image, at start-up and of the clocks; names say nothing of it."""
    pdos = tuple(tuple(map(_layout, pdos)) for pdos in (module.rx_pdos, module.tx_pdos))
    return pdos, module.module_pdo_group, module.mailbox, module.dc_op_mode_name


def _layout(pdo: Pdo) -> Pdo:
    unnamed = {"names": (), "spelling": None}
    entries = tuple(msgspec.structs.replace(entry, comments=(), **unnamed) for entry in pdo.entries)
    return msgspec.structs.replace(pdo, entries=entries, **unnamed)


def expand_module(device: Device, plugged: PluggedModule) -> ExpandedModule:
    """The module with its PDOs, entries, objects and InitCmds at the indices they have in the slot."""
    shift = SlotShift(device, plugged.slot, plugged.slot_number)
    module = plugged.module
    mailbox = module.mailbox
    if mailbox is not None and mailbox.coe_init_cmds:
        commands = tuple(_in_slot(command, "object_index", shift.object_index) for command in mailbox.coe_init_cmds)
        mailbox = msgspec.structs.replace(mailbox, coe_init_cmds=commands)
    expanded = msgspec.structs.replace(
        module,
        rx_pdos=tuple(shift.pdo(pdo) for pdo in module.rx_pdos),
        tx_pdos=tuple(shift.pdo(pdo) for pdo in module.tx_pdos),
        mailbox=mailbox,
        profiles=tuple(_profile_in_slot(profile, shift) for profile in module.profiles),
    )
    return ExpandedModule(plugged.slot_number, expanded, tuple(dict.fromkeys(shift.problems)))


def leaving_indices(device: Device, modules: Iterable[Module]) -> Iterator[tuple[PluggedModule, tuple[str, ...]]]:
    """The modules of which an index leaves 16 bits in a slot that they fit, each in the last such slot, with problems.

    An index moves by the same step from instance to instance of a Slot element: what leaves does so at one of the ends.
    Nearly always a look at the highest index shows that nothing does.
    """
    ends = [
        (number, slot, SlotShift(device, slot, number))
        for slot, numbers in slot_runs(device)
        for number in dict.fromkeys((*numbers[:1], *numbers[-1:]))
    ]
    moves = [(-1 if shift.moves_down else MAX_INDEX - shift.largest, number, slot) for number, slot, shift in ends]
    moves.reverse()
    least = min([highest for highest, *_ in moves], default=MAX_INDEX)
    for module in modules:
        highest = max(_indices(module), default=0)
        if highest <= least:
            continue
        for staying, number, slot in moves:
            if highest > staying and accepts(slot, module):
                plugged = PluggedModule(number, slot, module)
                if problems := expand_module(device, plugged).problems:
                    yield plugged, problems
                    break


def _indices(module: Module) -> list[int]:
    """The indices that can move with the slot."""
    pdos = (*module.rx_pdos, *module.tx_pdos)
    found = [pdo.pdo_index for pdo in pdos]
    found += [item.pdo_index for pdo in pdos for item in pdo.excludes]
    found += [index for index, _ in _object_places(module)]
    return [index for index in found if index is not None]


def _object_places(module: Module) -> list[tuple[int | None, Entry | InitCmd | Object]]:
    """Where objects are declared, mapped or written by InitCmds, each with its index."""
    commands = coe_init_cmds(module.mailbox)
    found: list[tuple[int | None, Entry | InitCmd | Object]] = [(command.object_index, command) for command in commands]
    found += [(entry.entry_index, entry) for pdo in (*module.rx_pdos, *module.tx_pdos) for entry in pdo.entries]
    found += [(item.object_index, item) for item in declared_objects(module.profiles)]
    return found


def declared_indices(module: Module) -> set[ModuleIndex]:
    """The indices of the objects in a module's dictionaries."""
    return {
        ModuleIndex.of(declared.object_index, declared)
        for declared in declared_objects(module.profiles)
        if declared.object_index is not None
    }


class SlotDependence(NamedTuple):
    """How some objects of a module follow the slot: by its number, by its group; and the highest of their indices."""

    by_slot: bool
    by_group: bool
    highest: int


def slot_dependences(module: Module, indices: range) -> list[SlotDependence]:
    """The ways in which objects in a range follow the slot, be they declared, mapped or written by InitCmds."""
    highest: dict[tuple[bool, bool], int] = {}
    for index, item in _object_places(module):
        if index is not None and index in indices:
            way = (bool(item.depend_on_slot), bool(item.depend_on_slot_group))
            highest[way] = max(index, highest.get(way, 0))
    return [SlotDependence(*way, index) for way, index in highest.items()]


def furthest_move(device: Device, plugged: PluggedModule, dependences: Iterable[SlotDependence]) -> int:
    """How far the objects move that move furthest up in the slot."""
    shift = SlotShift(device, plugged.slot, plugged.slot_number)
    moves = [shift.object_index(index, by_slot, by_group) - index for by_slot, by_group, index in dependences]
    return max((0, *moves))


def _profile_in_slot(profile: Profile, shift: "SlotShift") -> Profile:
    dictionary = profile.dictionary
    if dictionary is None or not any(o.depend_on_slot or o.depend_on_slot_group for o in dictionary.objects):
        return profile
    objects = tuple(_in_slot(declared, "object_index", shift.object_index) for declared in dictionary.objects)
    return msgspec.structs.replace(profile, dictionary=msgspec.structs.replace(dictionary, objects=objects))


def _in_slot(item: Shifted, field: str, move: Move) -> Shifted:
    index = getattr(item, field)
    if not index:
        return item
    moved = move(index, item.depend_on_slot, item.depend_on_slot_group)
    return item if moved == index else msgspec.structs.replace(item, **{field: moved})


class Step(NamedTuple):
    """How far an index moves from slot to slot, and how far with the group of a slot."""

    by_slot: int
    by_group: int


def slot_steps(device: Device, slot: Slot) -> tuple[Step, Step]:
    """The steps of objects and of PDOs; what a Slot element says counts before what is said for all."""

    def increment(own: int | None, common: int | None) -> int:
        return (own if own is not None else common) or 0

    group = slot.slot_group or 0
    return (
        Step(
            increment(slot.slot_index_increment, device.slot_index_increment),
            group * increment(slot.slot_group_index_increment, device.slot_group_index_increment),
        ),
        Step(
            increment(slot.slot_pdo_increment, device.slot_pdo_increment),
            group * increment(slot.slot_group_pdo_increment, device.slot_group_pdo_increment),
        ),
    )


class SlotShift:
    """By how much indices move in one slot; what would leave 16 bits stays and is named."""

    def __init__(self, device: Device, slot: Slot, slot_number: int) -> None:
        objects, pdos = slot_steps(device, slot)
        self._objects, self._objects_of_group = slot_number * objects.by_slot, objects.by_group
        self._pdos, self._pdos_of_group = slot_number * pdos.by_slot, pdos.by_group
        self._slot_number = slot_number
        self.problems: list[str] = []

    @property
    def moves_down(self) -> bool:
        """Whether increments are negative, as no real file has them."""
        return min(self._objects, self._objects_of_group, self._pdos, self._pdos_of_group) < 0

    @property
    def largest(self) -> int:
        """The furthest that any index moves up."""
        return max(
            max(self._objects, 0) + max(self._objects_of_group, 0), max(self._pdos, 0) + max(self._pdos_of_group, 0)
        )

    def object_index(self, index: int, by_slot: bool | None, by_group: bool | None) -> int:
        """Shifted index of an object, declared, mapped or written: one that describes a PDO moves as PDOs do."""
        if is_pdo_mapping(index):
            return self.pdo_index(index, by_slot, by_group)
        return self._checked("object", index, index + self._object_move(by_slot, by_group))

    def sources(self, index: int) -> set[ModuleIndex]:
        """What an object is in the module that comes to lie at an index in the slot: all that it can be.

        Index 0 stays where it is, as what would leave 16 bits does.
        """
        ways = product((False, True), repeat=2)
        found = {ModuleIndex(index - move(*way), *way) for way in ways for move in (self._object_move, self._pdo_move)}
        found |= {item._replace(unshifted=index) for item in found}
        return {item for item in found if item.unshifted and self.object_index(*item) == index}

    def _object_move(self, by_slot: bool | None, by_group: bool | None) -> int:
        return (self._objects if by_slot else 0) + (self._objects_of_group if by_group else 0)

    def pdo_index(self, index: int, by_slot: bool | None, by_group: bool | None) -> int:
        """Shifted index of a PDO."""
        return self._checked("PDO", index, index + self._pdo_move(by_slot, by_group))

    def _pdo_move(self, by_slot: bool | None, by_group: bool | None) -> int:
        return (self._pdos if by_slot else 0) + (self._pdos_of_group if by_group else 0)

    def pdo(self, pdo: Pdo) -> Pdo:
        """The PDO with its index, exclusions and entries shifted."""

        def moved(item: Pdo | Exclude) -> int | None:
            if item.pdo_index is None:
                return None
            return self.pdo_index(item.pdo_index, item.depend_on_slot, item.depend_on_slot_group)

        return msgspec.structs.replace(
            pdo,
            pdo_index=moved(pdo),
            excludes=tuple(msgspec.structs.replace(item, pdo_index=moved(item)) for item in pdo.excludes),
            entries=tuple(_in_slot(entry, "entry_index", self.object_index) for entry in pdo.entries),
        )

    def _checked(self, what: str, index: int, moved: int) -> int:
        if 0 <= moved <= MAX_INDEX:
            return moved
        self.problems.append(
            f"{what} 0x{index:04X} would become {moved:#X} in slot {self._slot_number}; left unshifted".replace(
                "0X", "0x"
            )
        )
        return index
