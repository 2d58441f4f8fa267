"""An image read from a device against the description of its identity."""

from typing import NamedTuple

from esicatalog.export.sii import sii_image
from esicatalog.export.sii_changes import CHECK_SUM, NOT_CONFIGURED, Change, image_changes
from esicatalog.export.subject import Subject
from esicatalog.sii.checksum import is_loaded
from esicatalog.sii.image import SiiImage

_OWN = {"serial number", "station alias", CHECK_SUM}
"""What is the device's own and in no description, and the check sum over it, which is held against the image itself."""
_REFUSED = "wrong: a slave controller refuses the configuration words"
_USED_PARTS = {"identity", "mailboxes", "SyncManagers", "FMMUs", "PDOs", "OpModes"}
_USED_OF_GENERAL = {"flags", "CoE"}


class ImageDifference(NamedTuple):
    """What the image says otherwise than the description."""

    part: str
    text: str
    used_by_master: bool
    """Whether a master configures the device by it, or the device does not start; names, PDI words and maker's data do
    not count."""


def verify_image(image: SiiImage, subject: Subject) -> tuple[ImageDifference, ...]:
    """How an image differs from the one that is exported for the description, in the order of importance."""
    described = sii_image(subject.vendor_id, subject.group, subject.device)
    refused = () if is_loaded(image.header) else (ImageDifference(CHECK_SUM, _REFUSED, True),)
    return refused + tuple(
        ImageDifference(change.part, _words(change), _is_used(change))
        for change in image_changes(described, image)
        if change.label not in _OWN
    )


def _words(change: Change) -> str:
    if change.before is None:
        return f"{change.label}: the image has {change.after}; not described"
    if change.after is None:
        return f"{change.label}: not in the image; described is {change.before}"
    return f"{change.label}: the image has {change.after}; described is {change.before}"


def _is_used(change: Change) -> bool:
    if change.part == "General":
        return change.label in _USED_OF_GENERAL
    return change.part in _USED_PARTS and not change.label.endswith(NOT_CONFIGURED)
