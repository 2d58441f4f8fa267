"""An image read from a device against the description of its identity."""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from esicatalog.catalog.results import FoundDevice, Identification
from esicatalog.esi.records.device import Device
from esicatalog.export.sii_changes import Change, image_changes
from esicatalog.export.sii_completed import described_images
from esicatalog.export.sii_fields import CHECK_SUM, PROTOCOLS, USED_BY_MASTER, Kind
from esicatalog.export.sii_header import NOT_COMPUTED
from esicatalog.export.subject import Subject
from esicatalog.sii.checksum import is_loaded
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.image import SiiImage
from esicatalog.words import counted

_REFUSED = "wrong: a slave controller refuses the configuration words"


class ImageDifference(NamedTuple):
    """What the image says otherwise than the description."""

    part: str
    text: str
    used_by_master: bool
    """Whether a master configures the device by it, or the device does not start; names, PDI words and maker's data do
    not count."""


def verify_image(image: SiiImage, subject: Subject) -> tuple[ImageDifference, ...]:
    """How an image differs from its description, in the order of importance.

    What the description does not say is no difference, whatever an image that is made of it has there; the check sum is
    held against the image itself. Texts may be in any of its languages: the one counts that the image fits best. Raises
    :class:`SiiImageError` when the description holds a whole image (Eeprom/Data) that is none.
    """
    refused = () if is_loaded(image.header) else (ImageDifference(CHECK_SUM, _REFUSED, True),)
    changes = min((image_changes(described, image) for described in described_images(subject, image)), key=len)
    return refused + tuple(
        ImageDifference(change.part, _words(change, subject.device), change.kind in USED_BY_MASTER)
        for change in changes
        if change.kind is not Kind.OWN
    )


class BestFit(NamedTuple):
    """The description that an image differs least from."""

    number: int
    """Which one of those that were compared with the image."""
    differences: tuple[ImageDifference, ...]
    unusable: tuple[str, ...]
    """Which ones were left out, because they hold an image that is none."""


def best_fit(image: SiiImage, subjects: Iterable[Subject]) -> BestFit:
    """Which of several descriptions an image differs least from, above all in what a master uses.

    The first of equal ones. Raises :class:`SiiImageError` when all of them hold a whole image (Eeprom/Data) that is
    none.
    """
    compared: list[tuple[int, tuple[ImageDifference, ...]]] = []
    unusable = []
    for number, subject in enumerate(subjects):
        try:
            compared.append((number, verify_image(image, subject)))
        except SiiImageError as error:
            unusable.append(f"{subject.identity_text}: {error}")
    if not compared:
        raise SiiImageError("; ".join(unusable))
    number, differences = min(compared, key=lambda item: _weight(item[1]))
    return BestFit(number, differences, tuple(unusable))


class Verification(NamedTuple):
    """The description that fits the image best among those of its identity, and how they differ."""

    identification: Identification
    device: FoundDevice | None
    """None when the identity is not described exactly; then nothing was compared."""
    findings: tuple[str, ...]
    """What is odd about the image itself."""
    unusable: tuple[str, ...]
    """Which descriptions of the identity were left out, because they hold an image that is none."""
    differences: tuple[ImageDifference, ...]

    @property
    def agrees(self) -> bool:
        """Whether image and description say the same of everything that a master uses."""
        return self.device is not None and not any(item.used_by_master for item in self.differences)

    def lines(self) -> Iterator[str]:
        """The result as text."""
        known = self.device
        yield (
            f"{known.type or ''}  {known.identity_text}".strip()
            if known is not None
            else f"not compared: {self.identification.reason}"
        )
        yield from (f"  image: {finding}" for finding in self.findings)
        yield from (f"  left out: {description}" for description in self.unusable)
        if known is None:
            return
        for item in self.differences:
            yield f"  {'!' if item.used_by_master else ' '} {item.part}: {item.text}"
        used = sum(item.used_by_master for item in self.differences)
        yield f"{counted(len(self.differences), 'difference')}, {used} in what a master uses (marked !)"

    def as_json(self) -> dict[str, Any]:
        """The result for JSON."""
        return {
            "agrees": self.agrees,
            "identification": self.identification.as_json(),
            "device": self.device.as_json() if self.device is not None else None,
            "findings": list(self.findings),
            "unusable": list(self.unusable),
            "differences": [item._asdict() for item in self.differences],
        }


def _weight(differences: tuple[ImageDifference, ...]) -> tuple[int, int]:
    return sum(item.used_by_master for item in differences), len(differences)


def _words(change: Change, device: Device) -> str:
    if change.after is None:
        return f"{change.label}: not in the image; described is {change.before}"
    return f"{change.label}: the image has {change.after}; {_described(change, device)}"


def _described(change: Change, device: Device) -> str:
    """What the description says of something that the image has."""
    if change.stored_as == PROTOCOLS and device.mailbox is None:
        return "the description has no Mailbox element"
    if change.before is not None:
        return f"described is {change.before}"
    is_uncomputed = any(number == change.stored_as and is_said(device) for number, (_, is_said) in NOT_COMPUTED.items())
    return "described, not computed here" if is_uncomputed else "not described"
