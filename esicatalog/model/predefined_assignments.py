"""Predefined PDO assignments: which PDOs TwinCAT offers to assign together, by a name."""

from typing import NamedTuple

from esicatalog.esi.canonical import elements_naming
from esicatalog.esi.numbers import parse_hex_dec
from esicatalog.esi.records.device import Device


class PredefinedAssignment(NamedTuple):
    """TwinCAT's predefined PDO assignment: a name and the PDO indices of each SyncManager."""

    name: str
    is_default: bool
    pdo_indices: dict[int, tuple[int, ...]]


def predefined_assignments(device: Device) -> list[PredefinedAssignment]:
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
        found.append(PredefinedAssignment(name, element.get("Default") in ("1", "true"), indices))
    return found
