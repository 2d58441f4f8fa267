"""Whether process data fit their SyncManagers and these the memory (ESI-FACTS section 8)."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import SyncManager
from esicatalog.model.areas import Area, overlaps
from esicatalog.model.sm_facts import BUFFERED, sm_facts
from esicatalog.words import counted

MEMORY_START = 0x1000
"""Registers below are no memory that a SyncManager would buffer three times (0x0F00: digital outputs)."""
_BUFFERS = 3
_ENABLED = 0x1
"""The bit of Enable, and of ESC register 0x0806 + 8n; the EEPROM knows others beside it: fixed, virtual, OpOnly."""


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
    areas = (occupied_area(number, sm, byte_sizes.get(number)) for number, sm in enumerate(sync_managers))
    found = overlaps(area for area in areas if area is not None)
    for (start, end, number), (next_start, next_end, next_number) in found:
        yield MemoryOverlap(
            next_number,
            f"SM {number} takes 0x{start:04X} to 0x{end - 1:04X} and SM {next_number} starts at "
            f"0x{next_start:04X}: they overlap by {counted(min(end, next_end) - next_start, 'byte')}",
        )


def is_enabled(sync_manager: SyncManager) -> bool:
    """Whether a SyncManager is activated, as far as is said: one without Enable may be."""
    return sync_manager.enable is None or bool(sync_manager.enable & _ENABLED)


def buffer_count(sync_manager: SyncManager) -> int:
    """How many times it takes its length: three buffers, or one for a mailbox and where the ControlByte is silent."""
    return _BUFFERS if sm_facts(sync_manager).buffer_mode == BUFFERED else 1


def occupied_area(number: int, sync_manager: SyncManager, byte_size: int | None) -> Area | None:
    """The addresses that the SyncManager at a position takes with this length; None where it takes no memory.

    That is so of registers, of one that is virtual or not enabled, and of a length of 0 or that nobody knows.
    """
    start = sync_manager.start_address
    if not byte_size or start is None or start < MEMORY_START or sync_manager.virtual or not is_enabled(sync_manager):
        return None
    return Area(start, start + buffer_count(sync_manager) * byte_size, number)


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
