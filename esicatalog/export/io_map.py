"""The process image as an application of SOEM sees it: its IOmap, in one direction.

Its SyncManagers lie one after the other, each in whole bytes. Behind a PDO without described entries, a SyncManager
that exchanges something without PDOs, or PDOs of modules that are missing, nothing tells where anything lies: there the
layout ends.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from esicatalog.export.c_access import byte_count, whole_bytes
from esicatalog.export.configuration import Configuration
from esicatalog.export.names import unique_names
from esicatalog.export.sm_configuration import MappedEntry, SmConfiguration
from esicatalog.export.soem_sii import check_counted
from esicatalog.model.values import byte_length


class Member(NamedTuple):
    """A member of the structure: one value, or bytes with what fills no bytes itself."""

    name: str
    byte_offset: int
    byte_count: int
    entry: MappedEntry | None

    @property
    def words(self) -> str:
        """What it holds."""
        return self.entry.words if self.entry is not None else "values that do not fill bytes, and gaps"


class IoMap(NamedTuple):
    """Values of one direction by their place in the image."""

    direction: str
    byte_size: int
    bit_size: int
    members: tuple[Member, ...]
    others: tuple[MappedEntry, ...]
    """Values that are no members: they begin or end inside a byte, or have a width that no type has."""
    is_described: bool
    """Whether it is all that the device exchanges in this direction."""
    remarks: tuple[str, ...]

    @property
    def starts_inside_byte(self) -> bool:
        """Whether SOEM may let the image begin at any bit: it packs images that do not fill a byte."""
        return self.bit_size < 8


def io_map(configuration: Configuration, direction: str) -> IoMap:
    """The image of one direction; without members when nothing is exchanged.

    Raises :class:`InputError` where SOEM exchanges something else with the device.
    """
    check_counted(configuration, direction)
    is_lacking = direction in configuration.lacking
    entries, byte_size, bit_size, is_described = [], 0, 0, not is_lacking
    images = [sm for sm in configuration.sync_managers if sm.direction == direction and (sm.pdos or sm.is_left_open)]
    has_pdos = any(sm.pdos for sm in images)
    remarks = []
    for sm in images:
        for entry in sm.entries:
            if entry.is_placed:
                entries.append(entry._replace(bit_offset=entry.bit_offset + byte_size * 8))
        byte_size += byte_length(sm.placed_bit_size)
        bit_size += sm.placed_bit_size
        if is_lacking or not sm.is_described:
            is_described = False
            # Of a direction without any PDO the remark about the SyncManager says all.
            if has_pdos:
                remarks.append(_end_words(direction, byte_size, _end(sm)))
            break
    else:
        needed = byte_length(bit_size)
        if byte_size != needed:
            remarks.append(
                f"the {direction}s take {byte_size} bytes in {len(images)} SyncManagers, and SOEM maps only the "
                f"{needed} that the sum of their bits needs: what lies behind is not exchanged"
            )
    return IoMap(
        direction,
        byte_size,
        bit_size,
        tuple(_members(entries, byte_size)),
        tuple(entry for entry in entries if not _is_member(entry)),
        is_described,
        tuple(remarks),
    )


def _end(sm: SmConfiguration) -> str:
    """What has no known length in a SyncManager."""
    end = next((pdo for pdo in sm.pdos if not pdo.is_described), None)
    if end is not None:
        return f"PDO 0x{end.pdo_index:04X} of SM{sm.number}, which has no described entries"
    return f"PDOs of modules that are missing in SM{sm.number}" if sm.pdos else f"SM{sm.number}, which has no PDO"


def _end_words(direction: str, byte_size: int, end: str) -> str:
    if not byte_size:
        return f"there is no structure of the {direction}s: they begin with {end}"
    return f"the structure of the {direction}s ends before {end}: the device exchanges more than it has"


def _is_member(entry: MappedEntry) -> bool:
    return whole_bytes(entry) and (entry.value.kind == "bytes" or entry.value.fills_container)


def _members(entries: Sequence[MappedEntry], byte_size: int) -> Iterator[Member]:
    """Members for whole values, and arrays of bytes for what lies between them."""
    whole = {entry.bit_offset // 8: entry for entry in entries if _is_member(entry)}
    gaps = []
    at = 0
    for start in (*sorted(whole), byte_size):
        if start > at:
            gaps.append((at, start - at))
        at = start + (byte_count(whole[start]) if start in whole else 0)
    names = unique_names([(f"bytes_{start}",) for start, _ in gaps], [entry.identifier for entry in entries])
    members = [Member(name, start, count, None) for (start, count), name in zip(gaps, names, strict=True)]
    members += [Member(entry.identifier, start, byte_count(entry), entry) for start, entry in whole.items()]
    yield from sorted(members, key=lambda member: member.byte_offset)
