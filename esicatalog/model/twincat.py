"""What TwinCAT's VendorSpecific elements say: predefined PDO assignments, OpModes of old, the interval of samples."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from esicatalog.esi.canonical import elements_naming
from esicatalog.esi.numbers import MAX_STORED, parse_hex_dec
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.words import one_line

_COUNT = re.compile(r"\s*\d{1,18}\s*")
"""Thirty years and more are no cycle."""


class PredefinedAssignment(NamedTuple):
    """TwinCAT's predefined PDO assignment: a name and the PDO indices of each SyncManager."""

    name: str
    is_default: bool
    pdo_indices: dict[int, tuple[int, ...]]

    @property
    def shown_name(self) -> str:
        """The name as sheets and pages list it: files may leave it empty."""
        return self.name or "without name"


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
        name = one_line(element.findtext("Name") or "")
        found.append(PredefinedAssignment(name, element.get("Default") in ("1", "true"), indices))
    return found


def is_superseded(op_mode: OpMode) -> bool:
    """Whether newer tools ignore the OpMode: VendorSpecific/TwinCAT/@IgnoreFromBuildNo."""
    attribute = "IgnoreFromBuildNo"
    return any(element.get(attribute) for element in elements_naming(attribute, op_mode.vendor_specific))


def sampled_cycles(text: str | None) -> Iterator[int]:
    """Bus cycles in ns: MinCycleTime on Oversampling is the smallest interval between two samples.

    EL1262: 1000 ns, and one million samples a second in its data sheet; a cycle has DefaultFactor samples unless
    another factor is chosen.
    """
    for element in elements_naming("MinCycleTime", text):
        interval, samples = _count(element.get("MinCycleTime")), _count(element.get("DefaultFactor")) or 1
        if interval and interval * samples <= MAX_STORED:
            yield interval * samples


def _count(text: str | None) -> int:
    return int(text) if text is not None and _COUNT.fullmatch(text) else 0
