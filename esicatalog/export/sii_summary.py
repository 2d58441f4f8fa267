"""What a person is told about an SII image that is written to a file: what it is, what would change, what it lacks."""

from collections.abc import Iterable, Iterator

from esicatalog.export.sii import has_descriptions
from esicatalog.export.sii_changes import stored_otherwise
from esicatalog.export.sii_fields import Kind
from esicatalog.export.sii_limits import used_bytes
from esicatalog.export.sii_merge import MergedImage
from esicatalog.export.sii_remarks import eeprom_remarks
from esicatalog.export.subject import Subject
from esicatalog.identity import Identity
from esicatalog.sii.checksum import is_loaded
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.image import FILLER, SiiImage, ranges_text
from esicatalog.words import counted

WHY_MERGE = (
    "For a device in the field, merge this image into the device's own (--merge DUMP): wrong PDI words make a device "
    "unreachable for every master, and alias, serial number and factory data, calibration for instance, exist nowhere "
    "else and are lost when they are overwritten."
)
"""Why an image should not be written as computed."""
_CHECK_PDI = (
    "PDI words would change: wrong ones make the device unreachable. Write only when you know them to be right."
)
_WRONG_CHECK_SUM = (
    "The check sum in the dump is wrong, with which a slave controller does not load the words 0 to 6; with that of "
    "this image it would load them."
)
_CHECK_IDENTITY = "The identity would change: the dump may be that of another device or revision."


def image_text(
    subject: Subject, image: SiiImage, *, merged: MergedImage | None = None, dropped: Iterable[str] = ()
) -> str:
    """What a person is told about an image that is written to a file: lines of text, the most important first.

    ``image`` is what is written, ``merged`` the merge it comes from, ``dropped`` what was left out to fit.
    """
    return "\n".join(_lines(subject, image, merged, tuple(dropped)))


def _lines(subject: Subject, image: SiiImage, merged: MergedImage | None, dropped: tuple[str, ...]) -> Iterator[str]:
    header, used = image.header, used_bytes(image)
    identity = Identity(header.vendor_id, header.product_code, header.revision_no)
    type_text = subject.device.type or "a device"
    yield f"SII image of {type_text} ({identity}): {used + len(image.trailing)} bytes, {used} used."
    if merged is None:
        yield WHY_MERGE
    else:
        yield from _merge_lines(image, merged)
    yield from _listed("Left out to fit the format or the EEPROM:", dropped)
    yield from _listed("About this image:", eeprom_remarks(subject, has_descriptions(image)))


def _merge_lines(image: SiiImage, merged: MergedImage) -> Iterator[str]:
    yield from _unread_lines(used_bytes(image) + len(image.trailing), merged)
    changes = merged._replace(image=image).changes
    kinds = {change.kind for change in changes}
    if encode_sii(image) == encode_sii(merged.dump):
        what = "What the dump holds" if merged.dump.unread else "The device's image"
        yield f"{what} would not change."
    elif not changes:
        yield f"No value would change, only how it is stored: {', '.join(stored_otherwise(merged.dump, image))}."
    if not is_loaded(merged.dump.header):
        yield _WRONG_CHECK_SUM
    if Kind.PDI in kinds:
        yield _CHECK_PDI
    if Kind.IDENTITY in kinds:
        yield _CHECK_IDENTITY
    yield from _listed("Writing it would change, worst first:", (f"{item.part}: {item.text}" for item in changes))
    yield from _listed("Kept as the device has it:", merged.kept)
    yield from _listed("About the dump:", (f"{finding}." for finding in merged.dump.findings))


_BEHIND = (
    "byte behind this image is no part of it and stays as it is",
    "bytes behind this image are no part of it and stay as they are",
)


def _unread_lines(size: int, merged: MergedImage) -> Iterator[str]:
    """What of the EEPROM the dump does not hold, and what becomes of it when ``size`` bytes are written."""
    if merged.dump.unread:
        yield (
            f"Writing this image overwrites the bytes {ranges_text(merged.dump.unread)}, which the dump does not hold, "
            f"with 0x{FILLER:X}, whatever they hold: better read the whole EEPROM and merge into that."
        )
    unread = merged.byte_size - merged.dump_bytes
    if unread <= 0:
        return
    yield f"The dump holds {merged.dump_bytes} of the EEPROM's {merged.byte_size} bytes; {unread} were not in it."
    if size > merged.dump_bytes:
        yield (
            f"Writing this image overwrites the first {size - merged.dump_bytes} of them, whatever they hold: better "
            "read the whole EEPROM and merge into that."
        )
    if size < merged.byte_size:
        yield (
            counted(merged.byte_size - size, *_BEHIND)
            + ", if the tool that writes it leaves alone what the file does not hold."
        )


def _listed(title: str, lines: Iterable[str]) -> Iterator[str]:
    listed = [f"  {line}" for line in lines]
    if listed:
        yield from (title, *listed)
