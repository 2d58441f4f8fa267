"""Process image: which PDOs are assigned, and where every entry lies (ESI-FACTS sections 0, 9, 12 and 18).

A PDO is assigned by its Sm attribute, unless the OpMode lists PDOs for the SyncManager: then that list counts, with
the mandatory ones, which have to stay.
PDOs follow each other bit by bit in document order; a SyncManager is as long as all its bits, rounded up once.
An oversampled PDO repeats its entries: as often as the OpMode says, else by its own OSFac, each sample OSIndexInc
further. What a virtual SyncManager has is described, not transported, like a virtual PDO.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import msgspec

from esicatalog.esi.canonical import elements_naming
from esicatalog.esi.numbers import parse_hex_dec
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.model.pdo_facts import pdo_bits, pdos_by_direction, symmetric_exclusions
from esicatalog.model.slots import MAX_INDEX, PluggedModule, default_modules, expand_module
from esicatalog.model.sm_facts import may_transport, sm_role, transfer_direction
from esicatalog.model.sync import default_op_mode

MAX_SM_BYTES = 0xFFFF
"""A SyncManager's length is a 16 bit number of bytes (ESC register 0x0802)."""

Assignment = Mapping[int, Sequence[int]]
"""PDO indices in order, by SyncManager number."""


class PlacedEntry(NamedTuple):
    """An entry in the process image of a SyncManager, at the index that it has in its slot and sample."""

    bit_offset: int
    entry: Entry


class PlacedPdo(NamedTuple):
    """An assigned PDO; ``repeat`` is the oversampling factor, ``slot_number`` None for a PDO of the device itself.

    ``position`` is the PDO's among those of its direction in the device or module, None for a filler between groups.
    ``entries`` are those of ``pdo`` once for each sample.
    """

    direction: str
    position: int | None
    pdo: Pdo
    repeat: int
    slot_number: int | None
    module: Module | None
    entries: tuple[PlacedEntry, ...]

    def first_sample(self, number: int) -> Entry:
        """What an entry is in the first sample, whose index is the one that is named and typed elsewhere."""
        return self.pdo.entries[number % len(self.pdo.entries)]


class SmImage(NamedTuple):
    """Process image of one SyncManager.

    ``overflow`` says, also among the remarks, what is left out because no SyncManager is that long. Its size is unknown
    then.
    """

    sm: int
    usage: str | None
    transfer_direction: str
    """output or input, see :func:`~esicatalog.model.sm_facts.transfer_direction`."""
    pdos: tuple[PlacedPdo, ...]
    bit_size: int
    remarks: tuple[str, ...]
    overflow: str | None = None

    @property
    def byte_size(self) -> int:
        """Length in bytes: all bits, rounded up once."""
        return (self.bit_size + 7) // 8


class NamedAssignment(NamedTuple):
    """TwinCAT's predefined PDO assignment: a name and the PDO indices of each SyncManager."""

    name: str
    is_default: bool
    pdo_indices: dict[int, tuple[int, ...]]


class _Candidate(NamedTuple):
    direction: str
    position: int
    pdo: Pdo
    slot_number: int | None
    module: Module | None
    pdo_group: int | None


def default_process_image(device: Device, modules: Sequence[Module] = ()) -> list[SmImage]:
    """The process image without any choice: default OpMode, default modules."""
    return plugged_process_image(device, default_modules(device, modules))


def plugged_process_image(device: Device, plugged: Sequence[PluggedModule]) -> list[SmImage]:
    """The process image with these modules and the OpMode that counts with them."""
    return process_image(device, plugged, default_op_mode(device.op_modes, [item.module for item in plugged]))


def process_image(
    device: Device,
    plugged: Sequence[PluggedModule] = (),
    op_mode: OpMode | None = None,
    assignment: Assignment | None = None,
) -> list[SmImage]:
    """The process image for chosen modules, OpMode and PDO assignment; SyncManagers in ascending order.

    ``assignment`` wins over the OpMode's list, that over Pdo@Sm; mandatory PDOs that either leaves out are added. The
    OpMode's oversampling factors count whoever assigns the PDO, since its SYNC0 runs that often.
    """
    problems, candidates = _candidates(device, plugged)
    lists = _lists(op_mode)
    wanted = {number: [pdo_index for pdo_index, _ in items] for number, items in lists.items()} | {**(assignment or {})}
    factors = {pdo_index: factor for items in lists.values() for pdo_index, factor in items}
    assigned: dict[int, list[int]] = {}
    remarks: dict[int, list[str]] = {}
    for number, indices in wanted.items():
        assigned[number], remarks[number] = _with_mandatory(number, indices, candidates)
    numbers = {c.pdo.sm for c in candidates if c.pdo.sm is not None} | assigned.keys()
    numbers |= {number for number, sm in enumerate(device.sync_managers) if _has_default(sm)}
    chosen: dict[int, list[_Candidate]] = {}
    for number in sorted(numbers):
        said = remarks[number] = [*problems, *remarks.get(number, ())]
        chosen[number] = _chosen(_sync_manager(device, number), number, candidates, assigned.get(number), said)
    rivals = _Rivals(candidate.pdo for of_sm in chosen.values() for candidate in of_sm)
    return [_image(device, number, of_sm, factors, rivals, remarks[number]) for number, of_sm in chosen.items()]


def _has_default(sm: SyncManager) -> bool:
    """Whether it has a default process image, be it empty."""
    role = sm_role(sm)
    return role is not None and not role.is_mailbox and not role.is_dynamic


def _with_mandatory(number: int, wanted: Sequence[int], candidates: list[_Candidate]) -> tuple[list[int], list[str]]:
    mandatory = [c.pdo.pdo_index for c in candidates if c.pdo.sm == number and c.pdo.mandatory and not c.pdo.virtual]
    missing = [index for index in dict.fromkeys(mandatory) if index is not None and index not in wanted]
    return [*missing, *wanted], [f"PDO {_hex(index)} is mandatory: assigned too" for index in missing]


def _candidates(device: Device, plugged: Sequence[PluggedModule]) -> tuple[list[str], list[_Candidate]]:
    """All PDOs that could be assigned; a module's PDO takes the place of one marked OverwrittenByModule."""
    problems: list[str] = []
    of_modules: list[_Candidate] = []
    for item in plugged:
        expanded = expand_module(device, item)
        problems.extend(expanded.problems)
        for direction, pdos in pdos_by_direction(expanded.module):
            of_modules += [
                _Candidate(direction, position, pdo, item.slot_number, item.module, item.module.module_pdo_group)
                for position, pdo in enumerate(pdos)
            ]
    overwritten = {candidate.pdo.pdo_index for candidate in of_modules}
    own = [
        _Candidate(direction, position, pdo, None, None, device.module_pdo_group)
        for direction, pdos in pdos_by_direction(device)
        for position, pdo in enumerate(pdos)
        if not (pdo.overwritten_by_module and pdo.pdo_index in overwritten)
    ]
    candidates = own + of_modules
    if device.module_pdo_groups:
        candidates.sort(key=lambda candidate: candidate.pdo_group if candidate.pdo_group is not None else -1)
    return problems, candidates


def _lists(op_mode: OpMode | None) -> dict[int, list[tuple[int, int]]]:
    """The PDOs of an OpMode with their oversampling factors, by SyncManager."""
    return {
        item.no: [(pdo.pdo_index, pdo.os_fac or 1) for pdo in item.pdos if pdo.pdo_index is not None]
        for item in (op_mode.sm_assignments if op_mode is not None else ())
        if item.no is not None and item.pdos
    }


def _sync_manager(device: Device, number: int) -> SyncManager | None:
    return device.sync_managers[number] if 0 <= number < len(device.sync_managers) else None


def _chosen(
    sm: SyncManager | None,
    number: int,
    candidates: list[_Candidate],
    assigned: Sequence[int] | None,
    remarks: list[str],
) -> list[_Candidate]:
    """The PDOs of a SyncManager; those of the other direction are not exchanged there (ESI-FACTS section 18)."""
    if assigned is not None:
        by_index: dict[int | None, list[_Candidate]] = {}
        for candidate in candidates:
            by_index.setdefault(candidate.pdo.pdo_index, []).append(candidate)
        indices = dict.fromkeys(assigned)
        remarks += [f"PDO 0x{index:04X} is listed but not described" for index in indices if index not in by_index]
        meant = [by_index[index] for index in indices if index in by_index]
    else:
        meant = [[candidate] for candidate in candidates if candidate.pdo.sm == number]
    chosen = []
    for alike in meant:
        fitting = next((item for item in alike if sm is None or may_transport(sm, item.direction)), None)
        if fitting is not None:
            chosen.append(fitting)
        elif sm is not None:
            other = f"PDO {_hex(alike[0].pdo.pdo_index)} is left out: it is a {alike[0].direction}"
            remarks.append(f"{other}, SM{number} is for {sm.usage}")
    return chosen


class _Rivals:
    """PDOs that exclude each other, be they of one SyncManager or of several."""

    def __init__(self, pdos: Iterable[Pdo]) -> None:
        known = list(pdos)
        self._exclusions = symmetric_exclusions(known)
        self._mandatory = {pdo.pdo_index for pdo in known if pdo.mandatory and not pdo.virtual}
        self._taken: set[int | None] = set()

    def rival(self, pdo: Pdo) -> int | None:
        """What excludes a PDO: one that was taken before or, unless itself mandatory, one that is."""
        stronger = self._taken if pdo.mandatory else self._taken | self._mandatory
        return next((index for index in self._exclusions.get(pdo.pdo_index, ()) if index in stronger), None)

    def take(self, pdo: Pdo) -> None:
        """A PDO is assigned."""
        self._taken.add(pdo.pdo_index)


def _image(
    device: Device,
    number: int,
    chosen: Iterable[_Candidate],
    factors: Mapping[int, int],
    rivals: _Rivals,
    remarks: list[str],
) -> SmImage:
    sm = _sync_manager(device, number)
    builder = _ImageBuilder(device, factors, rivals, remarks)
    for candidate in chosen:
        if sm is not None and sm.virtual and not candidate.pdo.virtual:
            remarks.append(f"PDO {_hex(candidate.pdo.pdo_index)} is described, not transported: SM{number} is virtual")
        else:
            builder.place(candidate)
    builder.align(None)
    usage = sm.usage if sm is not None else None
    direction = transfer_direction(sm, [placed.direction for placed in builder.placed])
    return SmImage(number, usage, direction, tuple(builder.placed), builder.bit_size, tuple(remarks), builder.overflow)


class _ImageBuilder:
    """Puts PDOs one behind the other, bit by bit; groups of module PDOs end on their alignment."""

    def __init__(self, device: Device, factors: Mapping[int, int], rivals: _Rivals, remarks: list[str]) -> None:
        self._factors = factors
        self._groups = device.module_pdo_groups
        self._rivals = rivals
        self._remarks = remarks
        self._group: _Candidate | None = None
        self._group_start = 0
        self.placed: list[PlacedPdo] = []
        self.bit_size = 0
        self.overflow: str | None = None

    def place(self, candidate: _Candidate) -> None:
        """Add a PDO unless it is virtual or excluded by one that came before or, itself not so, is mandatory."""
        pdo = candidate.pdo
        if pdo.virtual:
            self._remarks.append(f"PDO {_hex(pdo.pdo_index)} is virtual: described, not transported")
            return
        rival = self._rivals.rival(pdo)
        if rival is not None:
            self._remarks.append(f"PDO {_hex(pdo.pdo_index)} is left out: {_hex(rival)} excludes it")
            return
        self.align(candidate)
        repeat = self._repeat(pdo)
        # An entry of no bits counts as one here, else nothing would bound how often it is repeated.
        if not self._has_room(pdo.pdo_index, repeat * max(pdo_bits(pdo), len(pdo.entries))):
            return
        entries = []
        for entry in _sampled(pdo, repeat, self._remarks):
            entries.append(PlacedEntry(self.bit_size, entry))
            self.bit_size += max(entry.bit_length or 0, 0)
        self.placed.append(
            PlacedPdo(
                candidate.direction,
                candidate.position,
                pdo,
                repeat,
                candidate.slot_number,
                candidate.module,
                tuple(entries),
            )
        )
        self._rivals.take(pdo)

    def _repeat(self, pdo: Pdo) -> int:
        factor = self._factors.get(pdo.pdo_index) if pdo.pdo_index is not None else None
        if factor is None:
            factor = pdo.os_fac or 1
            if factor > 1 and self._factors:
                self._remarks.append(
                    f"PDO {_hex(pdo.pdo_index)}: the OpMode, which lists others, says nothing about its oversampling; "
                    f"its own OSFac {factor} counts, and SYNC0 has to fit it"
                )
        return max(factor, 1)

    def _has_room(self, index: int | None, bits: int) -> bool:
        """Whether so many bits more fit into a SyncManager; what does not is named and left out."""
        if self.bit_size + bits <= MAX_SM_BYTES * 8:
            return True
        self.overflow = (
            f"PDO {_hex(index)} of {bits} bits is left out: a SyncManager holds {MAX_SM_BYTES} bytes at most"
        )
        self._remarks.append(self.overflow)
        return False

    def align(self, following: _Candidate | None) -> None:
        """At the end of a module PDO group, fill up to its alignment with the group's own PDO."""
        ended = self._group
        if following is not None and ended is not None and following.pdo_group == ended.pdo_group:
            return
        if ended is not None and ended.pdo_group is not None and 0 <= ended.pdo_group < len(self._groups):
            group = self._groups[ended.pdo_group]
            missing = -(self.bit_size - self._group_start) % (max(group.alignment or 1, 1) * 8)
            index = group.rx_pdo if ended.direction == "RxPdo" else group.tx_pdo
            if missing and group.alignment and self._has_room(index, missing):
                gap = Entry(entry_index=0, bit_length=missing)
                filler = Pdo(pdo_index=index, entries=(gap,))
                entries = (PlacedEntry(self.bit_size, gap),)
                self.placed.append(PlacedPdo(ended.direction, None, filler, 1, None, None, entries))
                self.bit_size += missing
        self._group, self._group_start = following, self.bit_size


def assigned_sms(images: Iterable[SmImage]) -> dict[tuple[str, int], int]:
    """SyncManagers of the device's own assigned PDOs, by direction and position."""
    return {
        (pdo.direction, pdo.position): image.sm
        for image in images
        for pdo in image.pdos
        if pdo.slot_number is None and pdo.position is not None
    }


def module_sms(module: Module) -> dict[tuple[str, int], int]:
    """SyncManagers that PDOs of a module go to with it, by direction and position, whatever it is plugged into."""
    return {
        (direction, position): pdo.sm
        for direction, pdos in pdos_by_direction(module)
        for position, pdo in enumerate(pdos)
        if pdo.sm is not None and not pdo.virtual
    }


def _sampled(pdo: Pdo, repeat: int, remarks: list[str]) -> Iterator[Entry]:
    """The entries of all samples: OSIndexInc moves the objects of each by one step more, padding stays padding.

    Nothing moves where an index would leave 16 bits, as in slots (ESI-FACTS section 12.1).
    """
    step = pdo.os_index_inc or 0
    reached = [(entry.entry_index or 0) + step * (repeat - 1) for entry in pdo.entries if entry.entry_index]
    if any(not 0 < index <= MAX_INDEX for index in reached) and step and repeat > 1:
        remarks.append(
            f"PDO {_hex(pdo.pdo_index)}: OSIndexInc {step} leads out of 16 bits in {repeat} samples; left out"
        )
        step = 0
    yield from pdo.entries
    for sample in range(1, repeat):
        for entry in pdo.entries:
            if step and entry.entry_index:
                yield msgspec.structs.replace(entry, entry_index=entry.entry_index + step * sample)
            else:
                yield entry


def alternative_assignments(device: Device) -> list[NamedAssignment]:
    """The predefined PDO assignments of TwinCAT: Info/VendorSpecific/TwinCAT/AlternativeSmMapping."""
    tag = "AlternativeSmMapping"
    found = []
    for element in [item for item in elements_naming(tag, device.info_vendor_specific) if item.tag == tag]:
        indices: dict[int, tuple[int, ...]] = {}
        for sm in element.iterchildren("Sm"):
            number = parse_hex_dec(sm.get("No") or "")
            pdos = [parse_hex_dec(pdo.text or "") for pdo in sm.iterchildren("Pdo")]
            if number is not None:
                indices[number] = tuple(index for index in pdos if index is not None)
        name = " ".join((element.findtext("Name") or "").split())
        found.append(NamedAssignment(name, element.get("Default") in ("1", "true"), indices))
    return found


def _hex(index: int | None) -> str:
    return f"0x{index:04X}" if index is not None else "without index"


def byte_bit(bit_offset: int) -> str:
    """An offset as engineers write it: byte.bit."""
    return f"{bit_offset // 8}.{bit_offset % 8}"
