"""Whether process data fit their SyncManagers and these the memory (ESI-FACTS section 8)."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import SyncManager
from esicatalog.model.areas import Area, overlaps
from esicatalog.model.counting import counted
from esicatalog.model.sm_facts import sm_facts

_BUFFERS = 3
_PROCESS_DATA_RAM = 0x1000
"""Registers below are no memory that a SyncManager would buffer three times (0x0F00: digital outputs)."""


class MemoryOverlap(NamedTuple):
    """A SyncManager that starts within the memory of one before it."""

    number: int
    words: str


def memory_overlaps(
    sync_managers: Sequence[SyncManager], byte_sizes: Mapping[int, int | None]
) -> Iterator[MemoryOverlap]:
    """SyncManagers of these lengths that lie in each other's memory; those of three buffers take it three times.

    None is a length that nobody knows.
    """
    areas = _areas(sync_managers, byte_sizes)
    for (start, end, number), (next_start, next_end, next_number) in overlaps(areas):
        yield MemoryOverlap(
            next_number,
            f"SM {number} takes 0x{start:04X} to 0x{end - 1:04X} and SM {next_number} starts at "
            f"0x{next_start:04X}: they overlap by {counted(min(end, next_end) - next_start, 'byte')}",
        )


def _areas(sync_managers: Sequence[SyncManager], byte_sizes: Mapping[int, int | None]) -> Iterator[Area]:
    """The addresses of each SyncManager that occupies memory."""
    for number, sm in enumerate(sync_managers):
        start, length = sm.start_address, byte_sizes.get(number)
        if not length or start is None or start < _PROCESS_DATA_RAM or sm.virtual or sm.enable == 0:
            continue
        buffers = _BUFFERS if sm_facts(sm).buffer_mode == "buffered" else 1
        yield Area(start, start + buffers * length, number)


def size_conflict(sync_manager: SyncManager, byte_size: int | None) -> str | None:
    """What PDOs of this length contradict in a SyncManager: MaxSize or MinSize; None if they fit, or are unknown."""
    if not byte_size:
        return None
    words = f"the assigned PDOs take {counted(byte_size, 'byte')}"
    if sync_manager.max_size is not None and byte_size > sync_manager.max_size:
        return f"{words}, MaxSize is {sync_manager.max_size}"
    if sync_manager.min_size is not None and byte_size < sync_manager.min_size:
        return f"{words}, MinSize is {sync_manager.min_size}"
    return None
