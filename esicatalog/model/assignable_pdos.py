"""Which PDOs can be assigned: those of the device and of what is in its slots, where they go, and what rules them out.

Rules of ESI-FACTS sections 8, 9 and 12, for what exports are given to assign and for what recipes ask for.
"""

from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.pdo_facts import mapped_entries, pdo_yields, pdos_by_direction, symmetric_exclusions
from esicatalog.model.slots import PluggedModule, expand_module
from esicatalog.model.sm_facts import may_transport, sm_role

NO_PDO_ASSIGN = "the device does not declare PdoAssign: it may keep its default assignment"
"""What speaks against every other assignment of a device without CoE/@PdoAssign."""


class AvailablePdo(NamedTuple):
    """A PDO that can be assigned; ``position`` counts among those of its direction in the device or module."""

    direction: str
    position: int | None
    """None for one that is listed and nobody describes."""
    pdo: Pdo
    """At the index that it has in its slot."""
    plugged: PluggedModule | None
    pdo_group: int | None
    """The group of module PDOs that its owner is in."""

    @property
    def slot_number(self) -> int | None:
        """Slot of its module, None for a PDO of the device."""
        return self.plugged.slot_number if self.plugged is not None else None

    @property
    def module(self) -> Module | None:
        """Its module, None for a PDO of the device."""
        return self.plugged.module if self.plugged is not None else None

    @property
    def owner(self) -> str:
        """Whose PDO it is, in words."""
        if self.plugged is None:
            return "the device"
        return f"module 0x{self.plugged.module.module_ident or 0:X} in slot {self.plugged.slot_number}"


class AvailablePdos(NamedTuple):
    """What can be assigned, and what is wrong with indices that move with their slots."""

    pdos: list[AvailablePdo]
    problems: list[str]


class Place(NamedTuple):
    """Where a PDO goes that is chosen: a SyncManager, or what is in the way, as the end of a sentence about the PDO."""

    sm: int | None
    obstacle: str = ""


class Meant(NamedTuple):
    """The PDO that is assigned by an index, or what is in the way, as the end of a sentence about the PDO."""

    found: AvailablePdo | None
    obstacle: str = ""


def group_order(pdo_group: int | None) -> int:
    """Where the PDOs of a group lie among those of others: those that are in none come first."""
    return pdo_group if pdo_group is not None else -1


def available_pdos(device: Device, plugged: Iterable[PluggedModule]) -> AvailablePdos:
    """The PDOs of the device, without those that yield to modules (OverwrittenByModule), and of the modules."""
    problems: list[str] = []
    of_modules: list[AvailablePdo] = []
    for item in plugged:
        expanded = expand_module(device, item)
        problems += expanded.problems
        of_modules += [
            AvailablePdo(direction, position, pdo, item, item.module.module_pdo_group)
            for direction, pdos in pdos_by_direction(expanded.module)
            for position, pdo in enumerate(pdos)
        ]
    replaced = {item.pdo.pdo_index for item in of_modules}
    own = [
        AvailablePdo(direction, position, pdo, None, device.module_pdo_group)
        for direction, pdos in pdos_by_direction(device)
        for position, pdo in enumerate(pdos)
        if not pdo_yields(pdo, replaced)
    ]
    return AvailablePdos(own + of_modules, problems)


def meant_by_index(available: Iterable[AvailablePdo], pdo_index: int | None) -> Meant:
    """The first PDO of an index, be it described by several owners that agree."""
    if pdo_index is None:
        return Meant(None, "cannot be assigned without an index")
    described = [item for item in available if item.pdo.pdo_index == pdo_index]
    if not described:
        return Meant(None, "is not described")
    first, *others = described
    for other in others:
        if other.owner != first.owner and mapped_entries(other.pdo.entries) != mapped_entries(first.pdo.entries):
            return Meant(None, f"is ambiguous: {first.owner} and {other.owner} describe it in different ways")
    return Meant(first)


def virtual_words(pdo: Pdo, number: int | None, sync_manager: SyncManager | None) -> str | None:
    """Why a PDO is no process data by default, as the end of a sentence about it; None where it may be.

    ``sync_manager`` is that of ``number``. What is virtual is no process data of a SyncManager, but an FMMU may map its
    address, often a register (ESI-FACTS sections 8 and 9).
    """
    if pdo.virtual:
        return "is virtual: no mapping object transports it, an FMMU alone may"
    if sync_manager is not None and sync_manager.virtual:
        return f"is of the virtual SM{number}: no register of the ESC is programmed for it, an FMMU alone may map it"
    return None


def takes_virtual(device: Device) -> bool:
    """Whether what is virtual can be chosen: with CoE a master would write a mapping object that is not there."""
    return device.mailbox is None or not device.mailbox.coe


def assignment_place(device: Device, direction: str, pdo: Pdo) -> Place:
    """Its own SyncManager, else the first one for process data of its direction that it may go to."""
    managers = device.sync_managers
    own = managers[pdo.sm] if pdo.sm is not None and 0 <= pdo.sm < len(managers) else None
    is_virtual = virtual_words(pdo, pdo.sm, own)
    if is_virtual is not None and not takes_virtual(device):
        return Place(None, is_virtual)
    if pdo.virtual and pdo.sm is None:
        return Place(None, "is virtual and names no SyncManager: nothing tells which address an FMMU would map")
    if pdo.sm is not None:
        if own is not None and not may_transport(own, direction):
            return Place(None, f"cannot be assigned: SM{pdo.sm} is for {own.usage}")
        return Place(pdo.sm)
    numbers = [number for number, sm in enumerate(managers) if _transports(sm, direction)]
    allowed = [number for number in numbers if number not in pdo.excluded_sms]
    if not numbers:
        return Place(None, f"has no SyncManager: the device has none for a {direction}")
    if not allowed:
        return Place(None, f"may not go to SM{numbers[0]}")
    if managers[allowed[0]].fixed_assignment:
        return Place(None, f"cannot be chosen: the assignment of SM{allowed[0]} is fixed")
    return Place(allowed[0])


def _transports(sync_manager: SyncManager, direction: str) -> bool:
    role = sm_role(sync_manager)
    return role is not None and role.pdo_direction == direction and not sync_manager.virtual


def _staying_pdos(
    device: Device,
    available: Iterable[AvailablePdo],
    exclusions: Mapping[int | None, Collection[int]],
    chosen: Iterable[int],
    assigned: Mapping[int, int],
) -> dict[int, int]:
    """Indices of the mandatory PDOs that stay beside those that are chosen, each with its SyncManager.

    ``assigned`` are the PDOs that are assigned without a choice, mandatory or not, with their SyncManagers; an OpMode
    lists some that name none.
    """
    places: dict[int, int] = {}
    for item in available:
        index, sm = item.pdo.pdo_index, item.pdo.sm
        if index is None or not item.pdo.mandatory or item.pdo.virtual:
            continue
        if index in assigned:
            places[index] = assigned[index]
        elif sm is not None and assignment_place(device, item.direction, item.pdo).sm is not None:
            places[index] = sm
    order = {index: position for position, index in enumerate(dict.fromkeys([*chosen, *assigned]))}
    in_order = sorted(places, key=lambda index: (order.get(index, len(order)), places[index]))
    return {index: places[index] for index in without_rivals(in_order, exclusions)}


class Beside(NamedTuple):
    """A PDO that is assigned beside chosen ones and excludes one of them."""

    chosen: int
    pdo_index: int
    sm: int
    is_mandatory: bool
    has_others: bool
    """Whether another PDO can be chosen for its SyncManager."""


def excluded_beside(
    device: Device, available: Sequence[AvailablePdo], chosen: Mapping[int, int], assigned: Mapping[int, int]
) -> Iterator[Beside]:
    """What excludes chosen PDOs without being chosen: mandatory ones, and what other SyncManagers keep by default.

    Both mappings give SyncManagers of PDOs by index, ``assigned`` those of the PDOs that are assigned without a choice.
    """
    exclusions = symmetric_exclusions(item.pdo for item in available)
    rivals = {index: [rival for rival in exclusions.get(index, ()) if rival not in chosen] for index in sorted(chosen)}
    if not any(rivals.values()):
        return
    staying = _staying_pdos(device, available, exclusions, chosen, assigned)
    kept = {index: sm for index, sm in assigned.items() if sm not in chosen.values()}
    stays = {index: sm for index, sm in staying.items() if sm in chosen.values() or index in kept}
    for index, others in rivals.items():
        for rival in others:
            sm = stays.get(rival, kept.get(rival))
            if sm is not None:
                beside = [*chosen, *stays, *(other for other in kept if kept[other] != sm)]
                barred = {rival, *(no for other in beside for no in exclusions.get(other, ()))}
                yield Beside(index, rival, sm, rival in stays, has_other_pdos(device, available, sm, barred))


def has_other_pdos(device: Device, available: Iterable[AvailablePdo], sm: int, barred: Container[int | None]) -> bool:
    """Whether a PDO can be chosen for a SyncManager that is none of those that are ``barred``."""
    others = (item for item in available if item.pdo.pdo_index is not None and item.pdo.pdo_index not in barred)
    return any(assignment_place(device, item.direction, item.pdo).sm == sm for item in others)


def without_rivals(staying: Iterable[int], exclusions: Mapping[int | None, Collection[int]]) -> list[int]:
    """Of the PDOs that stay in any case, of two that exclude each other the first.

    Those that a list names are given first (ESI-FACTS 0.5: the lists win), then the others in the order of their
    assignment. One that is itself left out excludes nothing.
    """
    found: list[int] = []
    for index in staying:
        if not any(rival in found for rival in exclusions.get(index, ())):
            found.append(index)
    return found


def declares_pdo_assign(device: Device) -> bool:
    """Whether a master may write the assignment (CoE/@PdoAssign, ESI-FACTS section 10)."""
    return device.mailbox is not None and bool(device.mailbox.coe_pdo_assign)


def declares_pdo_config(device: Device) -> bool:
    """Whether a master may write mappings (CoE/@PdoConfig, ESI-FACTS section 10), but for PDOs that are Fixed."""
    return device.mailbox is not None and bool(device.mailbox.coe_pdo_config)


def declares_pdo_upload(device: Device) -> bool:
    """Whether a master reads the PDOs from the device at start (CoE/@PdoUpload, ESI-FACTS section 10)."""
    return device.mailbox is not None and bool(device.mailbox.coe_pdo_upload)
