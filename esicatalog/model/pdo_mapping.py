"""What the dictionary says of PDOs: which entries they can be given by a master, and which of them are assigned."""

from collections.abc import Mapping

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO, Pdo
from esicatalog.identity import MAX_SUBINDEX
from esicatalog.model.assignable_pdos import declares_pdo_config
from esicatalog.model.dictionary import ObjectEntry

MAPPABLE_IN = {RX_PDO: "R", TX_PDO: "T"}
"""What PdoMapping calls the direction of a PDO."""


def mapping_obstacle(device: Device, pdo: Pdo) -> str | None:
    """Why a master may not choose the entries of a PDO of a device or its modules, None when it may.

    Pdo/@Fixed forbids it for one PDO; CoE/@PdoConfig allows it for a device (ESI-FACTS sections 9 and 10).
    """
    if pdo.fixed:
        return "is Fixed"
    if not declares_pdo_config(device):
        return "cannot be changed: the device does not declare PdoConfig"
    return None


def is_mappable(declared: ObjectEntry, direction: str) -> bool:
    """Whether a dictionary lets an object into PDOs of a direction: PdoMapping names it, and its size is known."""
    return bool(declared.bit_size) and MAPPABLE_IN[direction] in (declared.pdo_mapping or "")


def assigned_by_dictionary(entries: Mapping[int, ObjectEntry]) -> list[int] | None:
    """The PDOs that an assignment object lists by default, each once, in the order of the process image.

    ``entries`` are its own by subindex. None where it has no defaults (ETG.1000.6, 0x1C10 and following).
    """
    count = entries[0].default_int if 0 in entries else None
    listed = [
        entry.default_int
        for subindex, entry in sorted(entries.items())
        if subindex and entry.default_int and (count is None or subindex <= count)
    ]
    return list(dict.fromkeys(listed)) if listed or count == 0 else None


def mapped_by_dictionary(entries: Mapping[int, ObjectEntry]) -> list[tuple[int, int, int]]:
    """What a mapping object maps by default: index, subindex and bits of each entry, index 0 for a gap.

    ``entries`` are its own by subindex. Empty where one of the defaults is missing (ETG.1000.6, 0x1600 and following).
    """
    count = entries[0].default_int if 0 in entries else None
    declared = [entries.get(subindex) for subindex in range(1, min(count or 0, MAX_SUBINDEX) + 1)]
    values = [entry.default_int for entry in declared if entry is not None and entry.default_int is not None]
    return [(value >> 16, value >> 8 & 0xFF, value & 0xFF) for value in values] if len(values) == len(declared) else []
