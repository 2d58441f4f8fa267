"""SyncManagers with what is assigned to them: every entry with its place, type and name."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.unreadable import unreadable
from esicatalog.export.cia402_types import Mapped, entry_type
from esicatalog.export.entry_types import ObjectTable, ValueType, value_type
from esicatalog.export.naming import EntryNames
from esicatalog.export.pdo_objects import PdoObject
from esicatalog.identity import MAX_INDEX, MAX_SUBINDEX
from esicatalog.model.assignable_pdos import declares_pdo_assign, declares_pdo_config
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS, carries_value, is_described
from esicatalog.model.process_image import PlacedPdo, SmImage, repeated_indices, repeated_words
from esicatalog.model.sm_facts import TRANSFER_DIRECTIONS, is_mailbox, sm_role, transfer_direction
from esicatalog.model.values import byte_length
from esicatalog.remarks import Remarking
from esicatalog.words import one_line

_CONTROL_BYTES = range(0x100)
_MAX_MAPPED_BITS = 255


class MappedEntry(NamedTuple):
    """An entry of the process image. Index 0 is a gap; one of no bits stands in the mapping and has no value."""

    entry_index: int
    subindex: int
    bit_length: int
    bit_offset: int
    """In its SyncManager; 0 where that is not known."""
    written_name: str
    """As the vendor wrote it, empty when there is none; gaps may have one too."""
    identifier: str
    """Unique in the device; empty without a value."""
    value: ValueType
    is_placed: bool = True
    """Whether ``bit_offset`` is known; behind what has no known length nothing tells the place."""

    @property
    def is_gap(self) -> bool:
        """Whether only its length counts."""
        return self.entry_index == 0

    @property
    def name(self) -> str:
        """What it is called on one line; gaps have no name."""
        return "" if self.is_gap else one_line(self.written_name)

    @property
    def comment(self) -> str:
        """What a comment calls it: its name, empty when there is none."""
        return "gap" if self.is_gap else self.name

    @property
    def mapping_value(self) -> int:
        """What a mapping object says of it: index, subindex and bits."""
        return self.entry_index << 16 | self.subindex << 8 | self.bit_length

    @property
    def place(self) -> str:
        """Index and subindex in words."""
        return f"0x{self.entry_index:04X}:{self.subindex:02X}"

    @property
    def words(self) -> str:
        """Its place and what it is called."""
        return f"{self.place} {self.name}".rstrip()


class AssignedPdo(NamedTuple):
    """A PDO of a SyncManager."""

    pdo_index: int
    written_name: str
    """As the vendor wrote it, empty when there is none."""
    direction: str
    """RxPdo or TxPdo."""
    fixed: bool
    slot_number: int | None
    entries: tuple[MappedEntry, ...]
    is_described: bool
    """Whether its content is known, be it none."""
    sample_count: int
    """How often a cycle samples it, in this PDO or in one for each sample: 1 without oversampling."""

    @property
    def name(self) -> str:
        """What it is called on one line."""
        return one_line(self.written_name)

    @property
    def mapping(self) -> PdoObject | None:
        """What belongs into its mapping object; None without described entries, and for what no mapping can express."""
        if any(entry.bit_length > _MAX_MAPPED_BITS for entry in self.entries):
            return None
        return PdoObject.that_holds(self.pdo_index, (entry.mapping_value for entry in self.entries))


class SmConfiguration(NamedTuple):
    """A SyncManager with what is assigned to it."""

    number: int
    usage: str
    direction: str
    """output (the master writes) or input."""
    sync_manager: SyncManager | None
    """None when PDOs name a SyncManager that the device does not describe."""
    pdos: tuple[AssignedPdo, ...]
    bit_size: int
    """All described bits."""
    is_left_open: bool
    """Whether it has no PDO and exchanges something that is not described."""

    @property
    def byte_size(self) -> int:
        """Length in bytes: all bits, rounded up once."""
        return byte_length(self.bit_size)

    @property
    def placed_bit_size(self) -> int:
        """Bits whose place is known: those before the first of which no length is known."""
        return sum(entry.bit_length for pdo in self.pdos for entry in pdo.entries if entry.is_placed)

    @property
    def is_described(self) -> bool:
        """Whether all content of its PDOs is known; without PDOs there is none."""
        return bool(self.pdos) and all(pdo.is_described for pdo in self.pdos)

    @property
    def is_mailbox(self) -> bool:
        """Whether it is a mailbox's, and no PDO is put into it all the same."""
        return self.sync_manager is not None and is_mailbox(self.sync_manager) and not self.pdos

    @property
    def assignment(self) -> PdoObject | None:
        """What belongs into its assignment object; None without PDOs, and where there is no such object."""
        object_index = PDO_ASSIGNMENTS.start + self.number
        if object_index not in PDO_ASSIGNMENTS:
            return None
        return PdoObject.that_holds(object_index, (pdo.pdo_index for pdo in self.pdos))

    @property
    def entries(self) -> Iterator[MappedEntry]:
        """All entries that carry a value, in order."""
        return (entry for pdo in self.pdos for entry in pdo.entries if carries_value(entry))


def pdo_objects(sync_managers: Iterable[SmConfiguration]) -> Iterator[PdoObject]:
    """What belongs into the assignments and mappings of all process data whose content is known."""
    for sm in sync_managers:
        if sm.is_described:
            yield from (item for item in (sm.assignment, *(pdo.mapping for pdo in sm.pdos)) if item is not None)


def rewritten_objects(device: Device, sync_managers: Iterable[SmConfiguration]) -> Iterator[int]:
    """Assignments with PdoAssign, mappings with PdoConfig unless they are Fixed (ESI-FACTS section 10)."""
    for sm in sync_managers:
        if sm.assignment is not None and declares_pdo_assign(device):
            yield sm.assignment.object_index
        if declares_pdo_config(device):
            yield from (pdo.pdo_index for pdo in sm.pdos if pdo.mapping is not None and not pdo.fixed)


def configured_sync_managers(
    device: Device,
    images: Sequence[SmImage],
    names: EntryNames,
    objects: ObjectTable,
) -> Remarking[tuple[SmConfiguration, ...]]:
    """All SyncManagers but virtual ones without PDOs, with the types of the entries as CiA 402 signs them on its axes.

    Raises :class:`InputError` for what no master can be told.
    """
    for index in repeated_indices(images):
        raise InputError(f"{repeated_words(index)}: choose PDOs (--pdo) or modules (--module), or take a correct file")
    found = []
    by_number = {image.sm: image for image in images}
    for number in sorted({*range(len(device.sync_managers)), *by_number}):
        described = device.sync_managers[number] if 0 <= number < len(device.sync_managers) else None
        image = by_number.get(number)
        placed_pdos = image.pdos if image is not None else ()
        if number < 0:
            raise InputError(f"PDOs are assigned to SM{number}, which cannot be")
        if described is not None and described.virtual and not placed_pdos:
            continue
        if described is None:
            yield f"PDOs name SM{number}, which the device does not describe"
        elif (control := described.control_byte or 0) not in _CONTROL_BYTES:
            yield f"SM{number} has the ControlByte {control:#x}, which does not fit its register of 8 bits"
        pdos: list[AssignedPdo] = []
        for at, placed in enumerate(placed_pdos):
            identifiers = [names.identifiers.get((number, at, n), "") for n in range(len(placed.entries))]
            pdos.append((yield from _assigned_pdo(placed, identifiers, names.axes, objects)))
        direction = yield from _direction(number, described, pdos)
        found.append(
            SmConfiguration(
                number,
                described.usage or "" if described is not None else "",
                direction,
                described,
                tuple(pdos),
                image.bit_size if image is not None else 0,
                image is not None and image.left_open is not None,
            )
        )
    return tuple(found)


def _direction(number: int, described: SyncManager | None, pdos: Sequence[AssignedPdo]) -> Remarking[str]:
    """Direction of a SyncManager, with a remark where what describes it differs."""
    direction = transfer_direction(described, [pdo.direction for pdo in pdos])
    role = sm_role(described) if described is not None else None
    others = {TRANSFER_DIRECTIONS[pdo.direction] for pdo in pdos} | ({role.transfer_direction} if role else set())
    if others - {direction}:
        yield (
            f"SM{number} is described in both directions (usage, ControlByte and PDOs differ); "
            f"{direction} is taken, check it on the device"
        )
    return direction


def _assigned_pdo(
    placed: PlacedPdo, identifiers: Sequence[str], axes: Sequence[int], objects: ObjectTable
) -> Remarking[AssignedPdo]:
    pdo = placed.pdo
    written_name = display_text(pdo.names) or ""
    if pdo.pdo_index is None or not 0 < pdo.pdo_index <= MAX_INDEX:
        named = f"{placed.direction} {one_line(written_name) or pdo.ref or 'without name'!r}"
        unread = unreadable(pdo, "pdo_index")
        why = "has no index; its content is not described, take a newer file"
        if unread is not None:
            why = f"its Index {unread}; correct the file"
        raise InputError(f"{named} is assigned and {why}")
    entries = []
    for number, (item, entry_identifier) in enumerate(zip(placed.entries, identifiers, strict=True)):
        index, subindex, bit_length = item.entry.entry_index or 0, item.entry.subindex or 0, item.entry.bit_length or 0
        if not (index or bit_length):
            continue
        if not 0 <= index <= MAX_INDEX or not 0 <= subindex <= MAX_SUBINDEX:
            raise InputError(f"PDO 0x{pdo.pdo_index:04X} maps 0x{index:04X}:{subindex:02X}, which is no object")
        entry_name = display_text(item.entry.names) or ""
        first = placed.first_sample(number)
        mapped = Mapped(first.entry_index or 0, first.subindex or 0, bit_length, one_line(entry_name))
        is_known = objects.entry(mapped.object_index, mapped.subindex) is not None
        found = entry_type(mapped, objects.base_type(first, placed.slot_number), axes, is_known)
        if found.remark is not None:
            yield found.remark
        entries.append(
            MappedEntry(
                index,
                subindex if index else 0,
                bit_length,
                item.bit_offset or 0,
                entry_name,
                entry_identifier,
                value_type(found.base, bit_length),
                item.bit_offset is not None,
            )
        )
    return AssignedPdo(
        pdo.pdo_index,
        written_name,
        placed.direction,
        bool(pdo.fixed),
        placed.slot_number,
        tuple(entries),
        is_described(pdo),
        placed.repeat,
    )
