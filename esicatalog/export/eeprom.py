"""The EEPROM image of a device as it is written: with what is the device's own, within what its EEPROM holds."""

from typing import NamedTuple

from esicatalog.export.sii import described_image
from esicatalog.export.sii_header import configuration_bytes, eeprom_bytes
from esicatalog.export.sii_limits import check_image, fit_image
from esicatalog.export.sii_merge import MergedImage, merge_image
from esicatalog.export.subject import Subject
from esicatalog.sii.image import SiiImage


class EepromImage(NamedTuple):
    """The image to write, the merge that it comes from, and what was left out to fit."""

    image: SiiImage
    merged: MergedImage | None = None
    """None without an image of the device."""
    dropped: tuple[str, ...] = ()


def eeprom_image(
    subject: Subject, *, language: int | None = None, dump: SiiImage | None = None, fit: bool = False
) -> EepromImage:
    """The image of a description for its device; ``language`` is the LcId of its texts.

    ``dump`` is the device's own image, of which stays what is in no description. With ``fit`` names and more are left
    out until the image fits. Raises :class:`InputError` for a description without codes, with an Eeprom/Data that is no
    image, and for what is too much for the EEPROM.
    """
    subject.required_codes()
    image, merged = described_image(subject, language=language, like=dump), None
    byte_size = eeprom_bytes(image.header, subject.device)
    if dump is not None:
        merged = merge_image(image, dump, configuration_bytes(subject.device))
        image, byte_size = merged.image, merged.byte_size
    if fit:
        fitted, dropped = fit_image(image, byte_size, dump)
        return EepromImage(fitted, merged, dropped)
    return EepromImage(check_image(image, byte_size, dump), merged)
