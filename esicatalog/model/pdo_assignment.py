"""Which PDOs are assigned to which SyncManager (ESI-FACTS sections 0, 9, 12 and 18).

A PDO is assigned by its Sm attribute, unless the OpMode lists PDOs for the SyncManager: then that list counts, with
the mandatory ones, which have to stay; a PDO that it lists goes there, whatever its own Sm says. A list of the user
takes the place of the OpMode's, whose mandatory PDOs stay too. One that it lists and nobody describes is exchanged all
the same: it has no known entries. A virtual PDO and what a virtual SyncManager has are left out, unless the user lists
them for a device without CoE, of which a master can map the address all the same.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO, Pdo
from esicatalog.model.assignable_pdos import (
    AvailablePdo,
    AvailablePdos,
    available_pdos,
    group_order,
    takes_virtual,
    virtual_words,
    without_rivals,
)
from esicatalog.model.pdo_facts import PDO_MAPPINGS, symmetric_exclusions
from esicatalog.model.slots import PluggedModule
from esicatalog.model.sm_facts import may_transport, sm_role
from esicatalog.remarks import Remarking, remarked
from esicatalog.words import index_words

Assignment = Mapping[int, Sequence[int]]
"""PDO indices in order, by SyncManager number."""


class SmAssignment(NamedTuple):
    """The PDOs that a SyncManager transports, those included that exclude each other."""

    number: int
    sync_manager: SyncManager | None
    """None when PDOs name a SyncManager that the device does not describe."""
    pdos: tuple[AvailablePdo, ...]
    remarks: tuple[str, ...]
    listed: Collection[int] | None
    """Indices that the OpMode or the user lists for it, None without a list; others stay because they are mandatory."""
    virtual: tuple[AvailablePdo, ...]
    """What is left out because it is virtual, or the SyncManager."""


class PdoAssignment(NamedTuple):
    """The PDOs of all SyncManagers, and what an OpMode says of how often they are sampled."""

    sync_managers: list[SmAssignment]
    factors: Mapping[int, int | None]
    """Oversampling factors by PDO index, None for a PDO that the OpMode lists without; empty without such lists."""


class Rivals:
    """PDOs that exclude each other, be they of one SyncManager or of several.

    Mandatory ones stay, those first that a list names; then what a list names stays beside what is assigned by its Sm
    alone (ESI-FACTS 0.5: the lists win); else what comes first.
    """

    def __init__(self, assignments: Iterable[SmAssignment]) -> None:
        known = [(item.pdo, of_sm.listed or ()) for of_sm in assignments for item in of_sm.pdos]
        self._exclusions = symmetric_exclusions(pdo for pdo, _ in known)
        order = {
            pdo.pdo_index: (not pdo.mandatory, pdo.pdo_index not in listed)
            for pdo, listed in known
            if pdo.pdo_index is not None and (pdo.mandatory or pdo.pdo_index in listed)
        }
        self._taken: set[int | None] = {*without_rivals(sorted(order, key=order.__getitem__), self._exclusions)}

    def rival(self, pdo: Pdo) -> int | None:
        """What excludes a PDO: one that was taken before, or one that stays in any case."""
        return next((index for index in self._exclusions.get(pdo.pdo_index, ()) if index in self._taken), None)

    def take(self, pdo: Pdo) -> None:
        """A PDO is assigned."""
        self._taken.add(pdo.pdo_index)


def assigned_pdos(
    device: Device, plugged: Sequence[PluggedModule], op_mode: OpMode | None, assignment: Assignment | None
) -> PdoAssignment:
    """The PDOs of each SyncManager that PDOs name, a list has or whose role has a default, in ascending order."""
    chosen = assignment or {}
    candidates, problems = _candidates(device, plugged)
    problems = [*problems, *_list_problems(op_mode)]
    lists = _lists(op_mode)
    by_choice = {index for indices in chosen.values() for index in indices}
    by_mode = {number: [index for index in items if index not in by_choice] for number, items in lists.items()}
    wanted = by_mode | {number: [*indices] for number, indices in chosen.items()}
    unlisted = _unlisted(device, candidates, [*lists.items(), *chosen.items()]) if wanted else candidates
    numbers = {c.pdo.sm for c in candidates if c.pdo.sm is not None} | wanted.keys()
    numbers |= {number for number, sm in enumerate(device.sync_managers) if has_default_image(sm)}
    found = []
    for number in sorted(numbers):
        sm, indices = _sync_manager(device, number), list[int]()
        if number in wanted:
            replaced = [index for index in by_mode.get(number, ()) if index not in wanted[number]]
            indices = [*_mandatory(number, candidates, unlisted, replaced), *wanted[number]]
            meant, of_list = remarked(_by_index(device, sm, candidates, indices))
        else:
            meant, of_list = [[candidate] for candidate in unlisted if candidate.pdo.sm == number], ()
        taken = indices if number in chosen and takes_virtual(device) else ()
        (pdos, virtual), remarks = remarked(_transported(number, sm, meant, taken))
        remarks = (*problems, *of_list, *remarks)
        found.append(SmAssignment(number, sm, tuple(pdos), remarks, wanted.get(number), tuple(virtual)))
    return PdoAssignment(found, {index: factor for items in lists.values() for index, factor in items.items()})


def has_default_image(sm: SyncManager) -> bool:
    """Whether it has a default process image, be it empty."""
    role = sm_role(sm)
    return role is not None and not role.is_mailbox and not role.is_dynamic


def _sync_manager(device: Device, number: int) -> SyncManager | None:
    return device.sync_managers[number] if 0 <= number < len(device.sync_managers) else None


def _unlisted(
    device: Device, candidates: list[AvailablePdo], lists: Iterable[tuple[int, Collection[int]]]
) -> list[AvailablePdo]:
    """PDOs that no list names, be it for another SyncManager than their own: for these their Sm counts.

    A list of the OpMode in whose place the user's counts names them, too: they do not go back to their own Sm.
    """
    listed = {
        (candidate.direction, candidate.pdo.pdo_index)
        for number, indices in lists
        for candidate in candidates
        if candidate.pdo.pdo_index in indices and _may_have(_sync_manager(device, number), candidate)
    }
    return [candidate for candidate in candidates if (candidate.direction, candidate.pdo.pdo_index) not in listed]


def _mandatory(
    number: int, candidates: list[AvailablePdo], unlisted: list[AvailablePdo], replaced: Sequence[int]
) -> list[int]:
    """The mandatory PDOs of a SyncManager, those first that a list names in whose place another one counts."""
    named = [c for index in replaced for c in candidates if c.pdo.pdo_index == index]
    own = [c for c in unlisted if c.pdo.sm == number]
    return [
        c.pdo.pdo_index for c in (*named, *own) if c.pdo.mandatory and not c.pdo.virtual and c.pdo.pdo_index is not None
    ]


def _candidates(device: Device, plugged: Sequence[PluggedModule]) -> AvailablePdos:
    """All PDOs that could be assigned, group by group where modules have groups of PDOs."""
    found = available_pdos(device, plugged)
    if device.module_pdo_groups:
        found.pdos.sort(key=lambda candidate: group_order(candidate.pdo_group))
    return found


def _lists(op_mode: OpMode | None) -> dict[int, dict[int, int | None]]:
    """The PDOs of an OpMode with the oversampling factors that it gives them, by SyncManager."""
    lists: dict[int, dict[int, int | None]] = {}
    for item in op_mode.sm_assignments if op_mode is not None else ():
        if item.no is not None and item.pdos:
            of_sm = lists.setdefault(item.no, {})
            of_sm |= {pdo.pdo_index: pdo.os_fac for pdo in item.pdos if pdo.pdo_index is not None}
    return lists


def _list_problems(op_mode: OpMode | None) -> Iterator[str]:
    """What an OpMode lists for no SyncManager, or in several lists for one."""
    numbers = set()
    for item in (item for item in (op_mode.sm_assignments if op_mode is not None else ()) if item.pdos):
        if item.no in numbers:
            yield f"the OpMode has several lists of PDOs for SM{item.no}: they are read as one"
        elif item.no is not None:
            numbers.add(item.no)
        else:
            indices = ", ".join(index_words(pdo.pdo_index) for pdo in item.pdos)
            yield f"the OpMode's list of PDO {indices} names no SyncManager (No): it is ignored"


def _may_have(sm: SyncManager | None, candidate: AvailablePdo) -> bool:
    return sm is None or may_transport(sm, candidate.direction)


def _by_index(
    device: Device,
    sm: SyncManager | None,
    candidates: list[AvailablePdo],
    indices: Iterable[int],
) -> Remarking[list[list[AvailablePdo]]]:
    """The PDOs of a list, all those of an index together.

    Of those that are not described nothing is exchanged by a virtual SyncManager, nor, as far as anybody knows, with
    slots: they may be those of modules that are not plugged.
    """
    may_be_absent = bool(device.slots) or (sm is not None and bool(sm.virtual))
    by_index: dict[int | None, list[AvailablePdo]] = {}
    for candidate in candidates:
        by_index.setdefault(candidate.pdo.pdo_index, []).append(candidate)
    found = []
    for index in dict.fromkeys(indices):
        if index in by_index:
            found.append(by_index[index])
            continue
        yield f"PDO 0x{index:04X} is listed but not described"
        if not may_be_absent:
            found.append([_undescribed(sm, index)])
    return found


def _undescribed(sm: SyncManager | None, index: int) -> AvailablePdo:
    """A PDO of which nothing is known but its index, which tells its direction; elsewhere its SyncManager does."""
    by_index = next((direction for direction, indices in PDO_MAPPINGS.items() if index in indices), None)
    role = sm_role(sm) if sm is not None else None
    by_role = role.pdo_direction if role is not None else None
    return AvailablePdo(by_index or by_role or TX_PDO, None, Pdo(pdo_index=index), None, None)


def _fitting(number: int, sm: SyncManager | None, alike: Sequence[AvailablePdo]) -> Remarking[AvailablePdo | None]:
    """Of PDOs that are alike the one that a SyncManager can have; it exchanges no others (ESI-FACTS section 18)."""
    fitting = next((item for item in alike if _may_have(sm, item)), None)
    if fitting is None and sm is not None:
        other = f"PDO {index_words(alike[0].pdo.pdo_index)} is left out: it is a {alike[0].direction}"
        yield f"{other}, SM{number} is for {sm.usage}"
    return fitting


def _transported(
    number: int,
    sm: SyncManager | None,
    meant: Iterable[Sequence[AvailablePdo]],
    taken: Collection[int],
) -> Remarking[tuple[list[AvailablePdo], list[AvailablePdo]]]:
    """The PDOs that count, and the virtual ones, which exclude none of these; of the indices ``taken`` all count."""
    found: list[AvailablePdo] = []
    virtual: list[AvailablePdo] = []
    for alike in meant:
        candidate = yield from _fitting(number, sm, alike)
        if candidate is None:
            continue
        words = virtual_words(candidate.pdo, number, sm)
        is_taken = candidate.pdo.pdo_index in taken
        (found if words is None or is_taken else virtual).append(candidate)
        if words is not None:
            what_for = _chosen_words(sm, candidate) if is_taken else "it is left out here"
            yield f"PDO {index_words(candidate.pdo.pdo_index)} {words}; {what_for}"
    return found, virtual


def _chosen_words(sm: SyncManager | None, candidate: AvailablePdo) -> str:
    words = "it is chosen all the same"
    if candidate.direction == RX_PDO and sm is not None and sm.start_address is not None:
        words += f", and zeros are written to 0x{sm.start_address:04X} until the application sets it"
    return words
