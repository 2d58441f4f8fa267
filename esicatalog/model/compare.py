"""Comparison of two device descriptions: what is different, and whether a master's configuration is affected.

The parts are compared by ``compare_…`` modules of this package, all by tables of fields with a rule each.
Not compared: images, check sums, texts in other languages than the one shown, and what only tools for humans use
(comments and properties of objects).
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Protocol

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.compare_dc import compare_clocks
from esicatalog.model.compare_device import (
    compare_eeprom,
    compare_fmmus,
    compare_general,
    compare_identity,
    compare_sync_managers,
)
from esicatalog.model.compare_facts import AREAS, PROCESS_IMAGE, Difference
from esicatalog.model.compare_image import compare_images
from esicatalog.model.compare_mailbox import compare_init_cmds, compare_mailboxes
from esicatalog.model.compare_objects import compare_objects
from esicatalog.model.compare_pdos import compare_pdos, compare_predefined_assignments
from esicatalog.model.compare_slots import compare_slots
from esicatalog.model.process_data import ProcessData
from esicatalog.words import counted


class Comparable(Protocol):
    """A device with the modules that its slots can reach."""

    @property
    def vendor_id(self) -> int | None:
        """Its vendor, None for one without id."""

    @property
    def device(self) -> Device:
        """What the vendor describes."""

    @property
    def modules(self) -> Sequence[Module]:
        """Modules that its slots can reach."""


def compare_devices(left: Comparable, right: Comparable) -> list[Difference]:
    """All differences of two devices with the modules that their slots can reach, in the order of the areas.

    Exchanged sides give the same differences with exchanged values; only ``counts`` has a direction (see
    :mod:`esicatalog.model.compare_facts`).
    """
    ours, theirs = left.device, right.device
    return [
        *compare_identity(ours, theirs, left.vendor_id, right.vendor_id),
        *compare_general(ours, theirs),
        *compare_sync_managers(ours, theirs),
        *compare_fmmus(ours, theirs),
        *compare_pdos(ours, theirs),
        *compare_predefined_assignments(ours, theirs),
        *compare_images(ours, left.modules, theirs, right.modules),
        *compare_mailboxes(ours.mailbox, theirs.mailbox),
        *compare_init_cmds(ours.mailbox, theirs.mailbox),
        *compare_clocks(ours, theirs),
        *compare_objects(ours.profiles, theirs.profiles),
        *compare_slots(ours, left.modules, theirs, right.modules),
        *compare_eeprom(ours, theirs),
    ]


def images_are_known(left: Comparable, right: Comparable) -> bool:
    """Whether the default process images of both devices are described in full."""
    return all(ProcessData(side.device, side.modules).image_is_known for side in (left, right))


def summary_words(differences: Iterable[Difference], are_known: bool) -> str:
    """How many there are and how many count, e.g. ``37 differences, 4 count for a master: 3 PDO, 1 Dc``.

    ``are_known`` is what :func:`images_are_known` says: else nobody knows whether the images are the same.
    """
    found = list(differences)
    if not found:
        return "no differences"
    same = "; the default process image is the same" + ("" if are_known else " as far as it is described")
    image = "" if any(item.area == PROCESS_IMAGE for item in found) else same
    counting = Counter(item.area for item in found if item.counts)
    total = counted(len(found), "difference")
    if not counting:
        return f"{total}, none counts for a master{image}"
    areas = ", ".join(f"{counting[area]} {area}" for area in AREAS if counting[area])
    count = counting.total()
    return f"{total}, {count} count{'s' if count == 1 else ''} for a master: {areas}{image}"
