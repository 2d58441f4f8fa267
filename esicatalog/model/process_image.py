"""Process image: where every entry of the assigned PDOs lies (ESI-FACTS sections 0, 9, 12 and 18).

PDOs follow each other bit by bit in document order; a SyncManager is as long as all its bits, rounded up once.
The samples of an oversampled PDO lie one behind the other, in one PDO or in one each. How long a PDO with variable
content is, one with an entry without BitLen or one that is listed and not described, is not known, nor where lies what
follows it; nor what follows the PDOs of a required module that is missing.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import takewhile
from typing import NamedTuple, TypeVar

from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO, Entry, Pdo
from esicatalog.esi.records.slots import ModulePdoGroup
from esicatalog.esi.unreadable import reason_words
from esicatalog.model.assignable_pdos import AvailablePdo, declares_pdo_upload
from esicatalog.model.oversampling import Oversampling, Sample
from esicatalog.model.pdo_assignment import Assignment, Rivals, SmAssignment, assigned_pdos, has_default_image
from esicatalog.model.pdo_facts import has_length, is_described, pdo_bits, pdos_by_direction
from esicatalog.model.required_slots import MissingPdos, missing_pdos
from esicatalog.model.slots import PluggedModule, default_modules
from esicatalog.model.sm_facts import SM_ROLES, transfer_direction
from esicatalog.model.sync import default_op_mode
from esicatalog.model.values import byte_length
from esicatalog.remarks import Remarking, remarked
from esicatalog.words import counted, index_words

Result = TypeVar("Result")

MAX_SM_BYTES = 0xFFFF
"""A SyncManager's length is a 16 bit number of bytes (ESC register 0x0802)."""

_GROUP_PDO_FIELDS = {RX_PDO: "rx_pdo", TX_PDO: "tx_pdo"}
"""What fills up a module PDO group, by the direction of its PDOs."""


class PlacedEntry(NamedTuple):
    """An entry in the process image of a SyncManager, at the index that it has in its slot and sample."""

    bit_offset: int | None
    """None behind a PDO or an entry whose length is not known, and behind PDOs of a module that is not there."""
    entry: Entry


class PlacedPdo(NamedTuple):
    """An assigned PDO; ``repeat`` is the oversampling factor, ``slot_number`` None for a PDO of the device itself.

    ``position`` is the PDO's among those of its direction in the device or module, None for a filler between groups,
    for one that is listed and not described and for one that holds a later sample.
    ``entries`` are those of ``pdo`` once for each sample that it holds.
    """

    direction: str
    position: int | None
    pdo: Pdo
    repeat: int
    slot_number: int | None
    module: Module | None
    entries: tuple[PlacedEntry, ...]
    sample: int = 0
    """Which sample it holds, from 1, where each has a PDO of its own; 0 = all."""

    def first_sample(self, number: int) -> Entry:
        """What an entry is in the first sample, whose index is the one that is named and typed elsewhere."""
        return self.pdo.entries[number % len(self.pdo.entries)]


class SmImage(NamedTuple):
    """Process image of one SyncManager.

    ``overflow`` says, also among the remarks, what is left out because no SyncManager is that long.
    """

    sm: int
    usage: str | None
    transfer_direction: str
    """output or input, see :func:`~esicatalog.model.sm_facts.transfer_direction`."""
    pdos: tuple[PlacedPdo, ...]
    bit_size: int
    """All bits that are described."""
    remarks: tuple[str, ...]
    overflow: str | None = None
    has_known_size: bool = True
    """Whether the described bits are all; the remarks say why not."""
    left_open: str | None = None
    """What a SyncManager has in place of PDOs whose exchange is not described, in words."""
    missing_modules: str | None = None
    """Which required slots are empty whose modules have PDOs of this direction; also among the remarks."""
    excluded: tuple[tuple[AvailablePdo, int], ...] = ()
    """PDOs that are left out, each with the one that excludes it; also among the remarks."""
    virtual: tuple[AvailablePdo, ...] = ()
    """PDOs that are left out because they are virtual, or the SyncManager; also among the remarks."""

    @property
    def usage_words(self) -> str:
        """The role of its SyncManager, and the direction where the ControlByte contradicts it: that one counts."""
        role = SM_ROLES.get(self.usage or "")
        is_contradicted = role is not None and role.transfer_direction != self.transfer_direction
        return (self.usage or "") + f" (runs as {self.transfer_direction}, by its ControlByte)" * is_contradicted

    @property
    def left_open_words(self) -> str | None:
        """The remark about that, None where nothing is left open."""
        return _left_open_words(self.sm, self.left_open) if self.left_open is not None else None

    @property
    def byte_size(self) -> int | None:
        """Length in bytes: all bits, rounded up once; None where it is not known."""
        return self.described_bytes if self.has_known_size else None

    @property
    def described_bytes(self) -> int:
        """Bytes that the described bits take; the image may be longer."""
        return byte_length(self.bit_size)

    @property
    def byte_words(self) -> str:
        """Its length as all sheets and pages say it: "6 bytes", "at least 6 bytes" or "unknown length"."""
        if not self.bit_size and not self.has_known_size:
            return "unknown length"
        words = counted(self.described_bytes, "byte")
        return words if self.has_known_size else f"at least {words}"

    @property
    def size_words(self) -> str:
        """The same with the bits that are described."""
        return (
            f"{self.byte_words} ({counted(self.bit_size, 'bit')})"
            if self.bit_size or self.has_known_size
            else self.byte_words
        )


def default_process_image(device: Device, modules: Sequence[Module]) -> list[SmImage]:
    """The process image without any choice: default OpMode, default modules."""
    return whole_process_image(device, modules, default_modules(device, modules))


def whole_process_image(device: Device, modules: Sequence[Module], plugged: Sequence[PluggedModule]) -> list[SmImage]:
    """As :func:`plugged_process_image`; where a required slot is still empty, its length is not known.

    A SyncManager that only PDOs of the missing modules name has an image, too. ``modules`` are all of the device.
    """
    images = plugged_process_image(device, plugged)
    missing = missing_pdos(device, modules, plugged)
    if not missing:
        return images
    present = {image.sm for image in images}
    images += [
        _without_pdos(device, number, direction) for direction, pdos in missing.items() for number in pdos.sms - present
    ]
    images.sort(key=lambda image: image.sm)
    return without_modules(images, missing)


def without_modules(images: Iterable[SmImage], missing: Mapping[str, MissingPdos]) -> list[SmImage]:
    """The same images where such PDOs are missing of modules, by transfer direction.

    Their length is not known, nor where lies what is behind the missing PDOs.
    """
    return [
        _without(image, missing[image.transfer_direction]) if image.transfer_direction in missing else image
        for image in images
    ]


def _without(image: SmImage, missing: MissingPdos) -> SmImage:
    before = tuple(
        takewhile(lambda item: (-1 if item.slot_number is None else item.slot_number) < missing.first_slot, image.pdos)
    )
    behind = tuple(
        item._replace(entries=tuple(placed._replace(bit_offset=None) for placed in item.entries))
        for item in image.pdos[len(before) :]
    )
    return image._replace(
        pdos=before + behind,
        remarks=(*image.remarks, missing.words),
        has_known_size=False,
        missing_modules=missing.words,
    )


def _without_pdos(device: Device, number: int, direction: str) -> SmImage:
    usage = device.sync_managers[number].usage if 0 <= number < len(device.sync_managers) else None
    return SmImage(number, usage, direction, (), 0, ())


def plugged_process_image(device: Device, plugged: Sequence[PluggedModule]) -> list[SmImage]:
    """The process image with these modules and the OpMode that counts with them."""
    return process_image(device, plugged, default_op_mode(device.op_modes, [item.module for item in plugged]))


def process_image(
    device: Device,
    plugged: Sequence[PluggedModule],
    op_mode: OpMode | None,
    assignment: Assignment | None = None,
) -> list[SmImage]:
    """The process image for chosen modules, OpMode and PDO assignment; SyncManagers in ascending order.

    ``assignment`` wins over the OpMode's list, that over Pdo@Sm; mandatory PDOs that either leaves out are added. The
    OpMode's oversampling factors count whoever assigns the PDO, since its SYNC0 runs that often.
    """
    assigned = assigned_pdos(device, plugged, op_mode, assignment)
    rivals = Rivals(assigned.sync_managers)
    has_module_pdos = any(item.module.rx_pdos or item.module.tx_pdos for item in plugged)
    oversampling = Oversampling(device, plugged, assigned.factors)
    images = [_image(device, of_sm, oversampling, rivals, has_module_pdos) for of_sm in assigned.sync_managers]
    for index in repeated_indices(images):
        images = [
            image._replace(remarks=(*image.remarks, repeated_words(index)))
            if any(placed.pdo.pdo_index == index for placed in image.pdos)
            else image
            for image in images
        ]
    return images


def repeated_indices(images: Iterable[SmImage]) -> list[int]:
    """Indices that are assigned again, as modules have them whose slots do not move them: no export makes that."""
    times = Counter(placed.pdo.pdo_index for image in images for placed in image.pdos)
    return [index for index, count in times.items() if count > 1 and index is not None]


def repeated_words(index: int) -> str:
    """What is wrong with such an index."""
    return f"PDO 0x{index:04X} is assigned twice, and devices and masters tell PDOs apart by their index"


def placed_rx_pdos(images: Iterable[SmImage]) -> list[Pdo]:
    """The RxPDOs of a process image, in its order."""
    return [placed.pdo for image in images for placed in image.pdos if placed.direction == RX_PDO]


def assigned_indices(images: Iterable[SmImage]) -> dict[int, int]:
    """The SyncManagers of the assigned PDOs by index, those without one left out."""
    placed = ((placed.pdo.pdo_index, image.sm) for image in images for placed in image.pdos)
    return {index: sm for index, sm in placed if index is not None}


def virtual_pdos(images: Iterable[SmImage]) -> set[tuple[int, int | None]]:
    """The PDOs that are left out because they or their SyncManagers are virtual: SyncManager and index."""
    return {(image.sm, item.pdo.pdo_index) for image in images for item in image.virtual}


def _image(
    device: Device,
    assigned: SmAssignment,
    oversampling: Oversampling,
    rivals: Rivals,
    has_module_pdos: bool,
) -> SmImage:
    number, sm = assigned.number, assigned.sync_manager
    builder = _ImageBuilder(device, oversampling, rivals, assigned)
    for pdo in assigned.pdos:
        builder.place(pdo)
    builder.align(None)
    builder.remarks += _unknown_words(number, builder.placed)
    left_open = None if has_module_pdos else _left_open(device, assigned)
    if left_open is not None:
        builder.remarks.append(_left_open_words(number, left_open))
    return SmImage(
        number,
        sm.usage if sm is not None else None,
        transfer_direction(sm, [placed.direction for placed in builder.placed]),
        tuple(builder.placed),
        builder.bit_size,
        tuple(builder.remarks),
        builder.overflow,
        builder.is_known and left_open is None,
        left_open,
        excluded=tuple(builder.excluded),
        virtual=assigned.virtual,
    )


def _left_open(device: Device, assigned: SmAssignment) -> str | None:
    """What tells that a SyncManager without PDOs may exchange something all the same (ESI-FACTS sections 10 and 18).

    A list, be it of none, is one of PDOs; a virtual PDO is not. Not where modules are plugged that bring PDOs: then
    these are what the SyncManagers exchange, be it nothing for one.
    """
    sm = assigned.sync_manager
    if sm is None or assigned.pdos or assigned.listed is not None or sm.virtual or not has_default_image(sm):
        return None
    if sm.default_size:
        return f"DefaultSize {sm.default_size} and no PDO"
    return "no PDO, PDOs are uploaded from the device (PdoUpload)" if declares_pdo_upload(device) else None


def _left_open_words(number: int, left_open: str) -> str:
    return f"SM{number} has {left_open}: what it exchanges is not described"


def _unknown_words(number: int, placed: Iterable[PlacedPdo]) -> Iterator[str]:
    """Which PDOs have no known length; what is left out for its length has its own words."""
    unknown = [item.pdo for item in placed if not is_described(item.pdo)]
    for what, pdos in (
        ("no described entries", [pdo for pdo in unknown if not pdo.entries]),
        ("entries without a usable BitLen", [pdo for pdo in unknown if pdo.entries]),
    ):
        if pdos:
            has, it_is, it = ("has", "it is", "it") if len(pdos) == 1 else ("have", "they are", "them")
            indices = ", ".join(index_words(pdo.pdo_index) for pdo in pdos)
            yield (
                f"PDO {indices} of SM{number} {has} {what}: how long {it_is} and where the entries behind {it} lie is "
                "not known"
            )


class _ImageBuilder:
    """Puts PDOs one behind the other, bit by bit; groups of module PDOs end on their alignment."""

    def __init__(self, device: Device, oversampling: Oversampling, rivals: Rivals, assigned: SmAssignment) -> None:
        self._oversampling = oversampling
        self._groups = device.module_pdo_groups
        self._rivals = rivals
        self._listed = assigned.listed
        self._group: AvailablePdo | None = None
        self._group_start = 0
        self.placed: list[PlacedPdo] = []
        self.remarks = [*assigned.remarks]
        self.bit_size = 0
        self.is_known = True
        self.overflow: str | None = None
        self.excluded: list[tuple[AvailablePdo, int]] = []

    def place(self, candidate: AvailablePdo) -> None:
        """Add a PDO unless it is excluded by one that came before or by one that stays in any case."""
        pdo = candidate.pdo
        rival = self._rivals.rival(pdo)
        if rival is not None:
            self.remarks.append(f"PDO {index_words(pdo.pdo_index)} is left out: {index_words(rival)} excludes it")
            self.excluded.append((candidate, rival))
            return
        if self._listed is not None and pdo.pdo_index not in self._listed:
            self.remarks.append(f"PDO {index_words(pdo.pdo_index)} is mandatory: assigned too")
        self.align(candidate)
        repeat = self._noting(self._oversampling.factor(pdo))
        # An entry of no bits counts as one here, else nothing would bound how often it is repeated.
        if not self._has_room(pdo.pdo_index, repeat * max(pdo_bits(pdo), len(pdo.entries))):
            return
        for sample in self._noting(self._oversampling.samples(candidate, repeat)):
            self._append(candidate, repeat, sample)
        self._rivals.take(pdo)

    def _noting(self, work: Remarking[Result]) -> Result:
        result, remarks = remarked(work)
        self.remarks += remarks
        return result

    def _append(self, candidate: AvailablePdo, repeat: int, sample: Sample) -> None:
        entries = []
        for entry in sample.entries:
            entries.append(PlacedEntry(self.bit_size if self.is_known else None, entry))
            self.bit_size += max(entry.bit_length or 0, 0)
            self.is_known = self.is_known and has_length(entry)
        self.is_known = self.is_known and is_described(candidate.pdo)
        self.placed.append(
            PlacedPdo(
                candidate.direction,
                candidate.position if sample.number <= 1 else None,
                sample.pdo,
                repeat,
                candidate.slot_number,
                candidate.module,
                tuple(entries),
                sample.number,
            )
        )

    def _has_room(self, index: int | None, bits: int) -> bool:
        """Whether so many bits more fit into a SyncManager; what does not is named and left out."""
        if self.bit_size + bits <= MAX_SM_BYTES * 8:
            return True
        self.overflow = (
            f"PDO {index_words(index)} of {bits} bits is left out: a SyncManager holds {MAX_SM_BYTES} bytes at most"
        )
        self.remarks.append(self.overflow)
        self.is_known = False
        return False

    def align(self, following: AvailablePdo | None) -> None:
        """At the end of a module PDO group, fill up to its alignment with the group's own PDO."""
        ended = self._group
        if following is not None and ended is not None and following.pdo_group == ended.pdo_group:
            return
        if ended is not None and ended.pdo_group is not None and 0 <= ended.pdo_group < len(self._groups):
            self._fill_up(self._groups[ended.pdo_group], ended.direction)
        self._group, self._group_start = following, self.bit_size

    def _fill_up(self, group: ModulePdoGroup, direction: str) -> None:
        """Transport what is missing; without a PDO of this direction that does it, nothing is."""
        missing = -(self.bit_size - self._group_start) % (max(group.alignment or 1, 1) * 8)
        if not missing or not group.alignment or not self.is_known:
            return
        field = _GROUP_PDO_FIELDS[direction]
        index: int | None = getattr(group, field)
        if index is None:
            why = reason_words(group, field)
            self.remarks.append(
                f"ModulePdoGroup {group.name or ''!r} has no {direction} to fill up with{why}: it is not aligned to "
                f"{counted(group.alignment, 'byte')}"
            )
            self.is_known = not why
        elif self._has_room(index, missing):
            gap = Entry(entry_index=0, bit_length=missing)
            filler = Pdo(pdo_index=index, entries=(gap,))
            entries = (PlacedEntry(self.bit_size, gap),)
            self.placed.append(PlacedPdo(direction, None, filler, 1, None, None, entries))
            self.bit_size += missing


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


def byte_bit(bit_offset: int | None) -> str:
    """An offset as engineers write it: byte.bit; a question mark where it is not known."""
    return f"{bit_offset // 8}.{bit_offset % 8}" if bit_offset is not None else "?"
