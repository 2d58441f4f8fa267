"""Process image: which PDOs are assigned, and where every entry lies (ESI-FACTS sections 0, 9 and 18).

A PDO is assigned by its Sm attribute, unless the default OpMode lists PDOs for the SyncManager: then that list counts.
PDOs follow each other bit by bit in document order; a SyncManager is as long as all its bits, rounded up once.
"""

from collections.abc import Sequence
from typing import NamedTuple

from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.model.slots import default_modules, shift_pdo, slot_shift
from esicatalog.model.sync import default_op_mode


class PlacedEntry(NamedTuple):
    """An entry in the process image of a SyncManager."""

    bit_offset: int
    entry: Entry


class PlacedPdo(NamedTuple):
    """An assigned PDO; ``repeat`` is the oversampling factor."""

    direction: str
    pdo: Pdo
    repeat: int
    module: Module | None
    entries: tuple[PlacedEntry, ...]


class SmImage(NamedTuple):
    """Process image of one SyncManager."""

    sm: int
    usage: str | None
    pdos: tuple[PlacedPdo, ...]
    bit_size: int
    remarks: tuple[str, ...]

    @property
    def byte_size(self) -> int:
        """Length in bytes: all bits, rounded up once."""
        return (self.bit_size + 7) // 8


class _Candidate(NamedTuple):
    direction: str
    pdo: Pdo
    module: Module | None


def default_process_image(device: Device, modules: Sequence[Module] = ()) -> list[SmImage]:
    """The process image without any choice: default OpMode, default modules. SyncManagers in ascending order."""
    candidates = [_Candidate("RxPdo", pdo, None) for pdo in device.rx_pdos]
    candidates += [_Candidate("TxPdo", pdo, None) for pdo in device.tx_pdos]
    for plugged in default_modules(device, modules):
        shift = slot_shift(device, plugged.slot, plugged.slot_number)
        for direction, pdos in (("RxPdo", plugged.module.rx_pdos), ("TxPdo", plugged.module.tx_pdos)):
            candidates += [_Candidate(direction, shift_pdo(pdo, shift), plugged.module) for pdo in pdos]
    position = default_op_mode(device.op_modes)
    listed = _listed(device.op_modes[position]) if position is not None else {}
    numbers = {c.pdo.sm for c in candidates if c.pdo.sm is not None} | listed.keys()
    numbers |= {n for n, sm in enumerate(device.sync_managers) if sm.usage in ("Outputs", "Inputs")}
    return [_image(device, number, candidates, listed.get(number)) for number in sorted(numbers)]


def _listed(op_mode: OpMode) -> dict[int, dict[int, int]]:
    """PDO lists of an OpMode: by SyncManager, oversampling factor by PDO index."""
    return {
        item.no: {pdo.pdo_index: pdo.os_fac or 1 for pdo in item.pdos if pdo.pdo_index is not None}
        for item in op_mode.sm_assignments
        if item.no is not None and item.pdos
    }


def _image(device: Device, number: int, candidates: list[_Candidate], listed: dict[int, int] | None) -> SmImage:
    usage = device.sync_managers[number].usage if number < len(device.sync_managers) else None
    if listed is not None:
        by_index = {c.pdo.pdo_index: c for c in reversed(candidates)}
        chosen = [(by_index[index], factor) for index, factor in listed.items() if index in by_index]
    else:
        chosen = [(c, c.pdo.os_fac or 1) for c in candidates if c.pdo.sm == number]
    placed: list[PlacedPdo] = []
    remarks: list[str] = []
    taken: dict[int, set[int]] = {}
    offset = 0
    for candidate, factor in chosen:
        pdo = candidate.pdo
        if pdo.virtual:
            remarks.append(f"PDO {_hex(pdo.pdo_index)} is virtual: not transported")
            continue
        excluded = {item.pdo_index for item in pdo.excludes if item.pdo_index is not None}
        rival = next((index for index, barred in taken.items() if index in excluded or pdo.pdo_index in barred), None)
        if rival is not None:
            remarks.append(f"PDO {_hex(pdo.pdo_index)} excludes {_hex(rival)}, which is assigned before it; left out")
            continue
        entries = []
        for _ in range(factor):
            for entry in pdo.entries:
                entries.append(PlacedEntry(offset, entry))
                offset += entry.bit_length or 0
        placed.append(PlacedPdo(candidate.direction, pdo, factor, candidate.module, tuple(entries)))
        taken[pdo.pdo_index or 0] = excluded
    return SmImage(number, usage, tuple(placed), offset, tuple(remarks))


def _hex(index: int | None) -> str:
    return f"0x{index:04X}" if index is not None else "without index"


def byte_bit(bit_offset: int) -> str:
    """An offset as engineers write it: byte.bit."""
    return f"{bit_offset // 8}.{bit_offset % 8}"
