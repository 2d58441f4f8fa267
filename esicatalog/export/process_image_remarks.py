"""What a process image asks of a device or of its application that nothing generated here does for them."""

from collections import Counter, defaultdict
from collections.abc import Container, Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import RX_PDO
from esicatalog.export.entry_types import ObjectTable
from esicatalog.model.assignable_pdos import NO_PDO_ASSIGN, declares_pdo_assign
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS, PDO_MAPPINGS, carries_value, lacks_subindex
from esicatalog.model.pdo_mapping import assigned_by_dictionary, mapping_obstacle
from esicatalog.model.process_image import SmImage, default_process_image, process_image, virtual_pdos
from esicatalog.model.slots import PluggedModule
from esicatalog.model.sm_facts import OUTPUT, is_mailbox
from esicatalog.model.sm_memory import memory_overlaps, size_conflict
from esicatalog.model.sync import default_op_mode
from esicatalog.words import index_words

MAP_ONCE = "choose PDOs (--pdo) so that it is mapped once"
"""What helps against an output that is mapped again."""


def assignment_remarks(
    device: Device,
    plugged: Sequence[PluggedModule],
    op_mode: OpMode | None,
    default: Sequence[SmImage],
    images: Sequence[SmImage],
) -> Iterator[str]:
    """What an assignment asks of the device beyond its default one; ``default`` is that of the OpMode.

    However it was chosen: PDO by PDO, or with an OpMode that lists PDOs. Where there is no mailbox no master can write
    an assignment: what an OpMode lists is then what the device exchanges in it, as terminals with oversampling do. What
    is virtual is not assigned but mapped by its address.
    """
    if declares_pdo_assign(device):
        return
    usual = default_op_mode(device.op_modes, [item.module for item in plugged])
    of_device = default if op_mode is usual or device.mailbox is None else process_image(device, plugged, usual)
    kept = {image.sm: _indices(image) for image in of_device}
    virtual = virtual_pdos(of_device)
    changed = [
        f"SM{image.sm}"
        for image in images
        if [index for index in _indices(image) if (image.sm, index) not in virtual] != kept.get(image.sm)
    ]
    if changed:
        yield (
            f"the PDOs of {', '.join(changed)} are not the default ones, and {NO_PDO_ASSIGN}, and then no offset here "
            "is right"
        )


def order_remarks(device: Device, objects: ObjectTable, images: Iterable[SmImage]) -> Iterator[str]:
    """Fixed assignments whose object lists the same PDOs in another order than the document (rule L65).

    PDOs lie in the order of the assignment object (ETG.1000.6), and nothing tells which of the two is the device's:
    defaults of these objects are often those of another product. With PdoAssign the master writes the order.
    """
    if declares_pdo_assign(device):
        return
    for image in images:
        index = PDO_ASSIGNMENTS.start + image.sm
        listed, assigned = assigned_by_dictionary(objects.entries(index)), list(dict.fromkeys(_indices(image)))
        if listed is not None and listed != assigned and set(listed) == set(assigned):
            here, there = (", ".join(map(index_words, indices)) for indices in (assigned, listed))
            yield (
                f"SM{image.sm} has the PDOs {here} in this order here, 0x{index:04X} lists {there} by default, and the "
                "device does not declare PdoAssign: read it on the device; in another order no offset here is right"
            )


def own_remarks(images: Iterable[SmImage], are_modules_missing: bool) -> Iterator[str]:
    """What the images themselves say; that modules are missing is told for the whole device, and says already why a
    SyncManager has no PDO.
    """
    for image in images:
        known = (image.missing_modules, image.left_open_words if are_modules_missing else None)
        yield from (words for words in image.remarks if words not in known)


def subindex_remarks(device: Device, images: Iterable[SmImage]) -> Iterator[str]:
    """Objects that are mapped without SubIndex."""
    for placed in (placed for image in images for placed in image.pdos):
        for item in placed.entries:
            if lacks_subindex(placed.module or device, item.entry):
                yield (
                    f"PDO {index_words(placed.pdo.pdo_index)} maps {index_words(item.entry.entry_index)} without "
                    "SubIndex, which says 0: check that this is the object that is meant"
                )


def swap_remarks(images: Sequence[SmImage]) -> Iterator[str]:
    """Entries whose bytes the master has to swap."""
    for item in (item for image in images for pdo in image.pdos for item in pdo.entries if item.entry.swap_data):
        entry = item.entry
        yield (
            f"0x{entry.entry_index or 0:04X}:{entry.subindex or 0:02X} {display_text(entry.names) or ''}".rstrip()
            + f" asks the master to swap its bytes ({entry.swap_data}), which nothing here does: swap them in the "
            "application"
        )


class MappedAgain(NamedTuple):
    """An index and subindex that several entries have."""

    words: str
    are_copies: bool
    """Whether the entries are alike, so that they can be taken for the same value."""


def mapped_again(entries: Iterable[tuple[int, int, int, str]]) -> dict[tuple[int, int], MappedAgain]:
    """What is mapped several times, by index and subindex; ``entries`` are these, a length in bits and a name.

    An object has one length, so entries of different lengths are different values, whatever their index says. Those
    with different names may be.
    """
    found: dict[tuple[int, int], list[tuple[int, str]]] = defaultdict(list)
    for index, subindex, bit_length, name in entries:
        found[index, subindex].append((bit_length, name))
    return {place: _again(*place, items) for place, items in found.items() if len(items) > 1}


def _again(index: int, subindex: int, items: Sequence[tuple[int, str]]) -> MappedAgain:
    place = f"0x{index:04X}:{subindex:02X}"
    alike = list(dict.fromkeys(items))
    if len(alike) == 1:
        return MappedAgain(f"{place} {items[0][1]}".rstrip() + f" is mapped {len(items)} times", are_copies=True)
    listed = ", ".join(f"{name or 'without a name'} ({bit_length} bit)" for bit_length, name in alike)
    perhaps = "perhaps " if len({bit_length for bit_length, _ in alike}) == 1 else ""
    return MappedAgain(
        f"{place} is mapped {len(items)} times, {perhaps}as different values: {listed}", are_copies=False
    )


def staying_copies(device: Device, images: Iterable[SmImage]) -> frozenset[tuple[int, int]]:
    """Index and subindex of what is mapped again whatever is chosen: in mandatory PDOs whose mapping stays."""
    times = Counter(
        (entry.entry_index or 0, entry.subindex or 0)
        for image in images
        for placed in image.pdos
        if placed.pdo.mandatory and mapping_obstacle(device, placed.pdo) is not None
        for entry in placed.pdo.entries
        if carries_value(entry)
    )
    return frozenset(place for place, count in times.items() if count > 1)


def repeat_remarks(images: Iterable[SmImage], staying: Container[tuple[int, int]]) -> Iterator[str]:
    """Outputs that are mapped again: whoever writes one entry sends zeros in the others.

    ``staying`` are those of :func:`staying_copies`, against which no choice helps.
    Samples are no copies, nor are IDNs of SoE, which has PDOs of other indices: one of each drive of the device.
    """
    found = mapped_again(
        (entry.entry_index or 0, entry.subindex or 0, entry.bit_length or 0, display_text(entry.names) or "")
        for image in images
        if image.transfer_direction == OUTPUT
        for placed in image.pdos
        if placed.pdo.pdo_index in PDO_MAPPINGS[RX_PDO] and placed.sample <= 1
        for entry in placed.pdo.entries
        if carries_value(entry)
    )
    for place, again in found.items():
        what = "every copy is sent, so write all of them" + ("" if place in staying else f", or {MAP_ONCE}")
        yield f"{again.words}: {what if again.are_copies else 'each is sent, so write every one of them'}"


def memory_remarks(device: Device, modules: Sequence[Module], images: Sequence[SmImage]) -> Iterator[str]:
    """Process data that do not fit their SyncManager, or the memory before the next one (rules L25 and L22).

    Only what the default process image does not have: real boxes overlap by default, and their vendor knows them.
    """
    found = list(_memory_conflicts(device, images))
    known = set(_memory_conflicts(device, default_process_image(device, modules))) if found else set()
    return (words for words in found if words not in known)


def _memory_conflicts(device: Device, images: Sequence[SmImage]) -> Iterator[str]:
    """A mailbox has its DefaultSize; process data are as long as the PDOs make them, where that is known."""
    byte_sizes: dict[int, int | None] = {}
    for number, sm in enumerate(device.sync_managers):
        if is_mailbox(sm):
            byte_sizes[number] = sm.default_size or 0
    for image in images:
        if image.pdos and 0 <= image.sm < len(device.sync_managers):
            byte_sizes[image.sm] = image.byte_size
            if (conflict := size_conflict(device.sync_managers[image.sm], image.byte_size)) is not None:
                yield f"SM{image.sm}: {conflict}; the device may refuse it"
    for overlap in memory_overlaps(device.sync_managers, byte_sizes):
        yield f"{overlap.words}; the device may refuse it or mix up the data"


def _indices(image: SmImage) -> list[int | None]:
    return [placed.pdo.pdo_index for placed in image.pdos]
