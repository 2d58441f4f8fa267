"""Rows of what a description implies: facts, drive modes and places in the default process image. No SQLAlchemy."""

from collections.abc import Iterable, Mapping

import msgspec

from esicatalog.catalog.mapping import codec
from esicatalog.catalog.shared import Row
from esicatalog.esi.binding import Record
from esicatalog.model.derivation import Derivation
from esicatalog.model.device_facts import DeviceFacts
from esicatalog.model.drive_evidence import ModeEvidence
from esicatalog.model.drive_modes import DriveModeVerdict
from esicatalog.model.process_image import SmImage

PdoPlace = tuple[int, list[int | None]]
"""SyncManager of an assigned PDO and the bit offset of each of its entries."""
PdoPlaces = Mapping[tuple[str, int], PdoPlace]
"""Places of a device's own PDOs in its default process image, by direction and position."""
NOWHERE: PdoPlaces = {}
"""PDOs of a module have places in a device only."""


class DerivedRows(msgspec.Struct):
    """Rows of a device in the tables device_facts, drive_modes and mode_evidence."""

    facts: Row
    drive_modes: list[Row]
    mode_evidence: list[Row]


def derived_rows(derived: Derivation) -> DerivedRows:
    """The rows of what a description implies, without the device's number."""
    return DerivedRows(
        facts=codec(DeviceFacts).encode(derived.facts),
        drive_modes=positioned(DriveModeVerdict, derived.modes.verdicts),
        mode_evidence=positioned(ModeEvidence, derived.modes.evidence),
    )


def positioned(record_type: type[Record], records: Iterable[Record]) -> list[Row]:
    """Rows of a list of records, each behind its position."""
    encode = codec(record_type).encode
    return [(position, *encode(record)) for position, record in enumerate(records)]


def pdo_places(images: Iterable[SmImage]) -> PdoPlaces:
    """Where the device's own PDOs lie, as far as that is known; of oversampled entries the first sample."""
    return {
        (pdo.direction, pdo.position): (image.sm, [place.bit_offset for place in pdo.entries[: len(pdo.pdo.entries)]])
        for image in images
        for pdo in image.pdos
        if pdo.slot_number is None and pdo.position is not None
    }
