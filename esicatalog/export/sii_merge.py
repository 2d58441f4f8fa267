"""A computed SII image merged into the image of a device: what only that device has is kept."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from typing import NamedTuple

import msgspec

from esicatalog.errors import InputError
from esicatalog.export.sii_changes import Change, image_changes
from esicatalog.export.sii_limits import behind_end_mark, used_bytes
from esicatalog.sii.checksum import CHECKSUM_OFFSET, with_checksum
from esicatalog.sii.codes import category_title
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.image import Category, General, RawCategory, SiiImage, ranges_text
from esicatalog.sii.records import HEADER, Header
from esicatalog.words import counted

_DEVICE_WORDS = (
    "station_alias",
    "serial_no",
    "execution_delay",
    "port0_delay",
    "port1_delay",
    "reserved_13",
    "private",
    "size_word",
    "version",
)
"""Words that belong to the single device, not to its description."""
_PDI_WORDS = "PDI words"
_SAID_TOGETHER = {
    _PDI_WORDS: ("pdi_control", "pdi_configuration", "sync_impulse_length_10ns", "pdi_configuration_2"),
    "word 5": ("reserved_5",),
    "word 6": ("reserved_6",),
    "bootstrap mailbox": (
        "bootstrap_receive_mailbox_offset",
        "bootstrap_receive_mailbox_size",
        "bootstrap_send_mailbox_offset",
        "bootstrap_send_mailbox_size",
    ),
}
"""Words that a description says together. All zero they mean that it says nothing, also where it writes the zeros: what
a device needs to be reached is not overwritten with them."""
PDI_BYTES = 8
"""Bytes of the PDI words: 0 to 3."""
_RESERVED_IN_GENERAL = ("legacy_ports", "sysman_class", "reserved_15", "reserved_20", "rest")


class MergedImage(NamedTuple):
    """An image for one device, the device's own that it is made from, and what of it is kept, in words.

    The bytes behind the end mark are added when it is written: :func:`esicatalog.export.sii_limits.check_image` with
    the ``dump``.
    """

    image: SiiImage
    dump: SiiImage
    kept: tuple[str, ...]

    @property
    def dump_bytes(self) -> int:
        """Bytes of the dump. Some tools read up to the end mark only: what is behind is unknown, not free."""
        return len(encode_sii(self.dump))

    @property
    def byte_size(self) -> int:
        """Size of the device's EEPROM: by its size word, or the bytes of the dump if these are more."""
        return max(self.dump.header.byte_size, self.dump_bytes)

    @property
    def changes(self) -> tuple[Change, ...]:
        """What writing the image would change, worst first."""
        return image_changes(self.dump, self.image)


def merge_image(computed: SiiImage, dump: SiiImage, config_bytes: int = CHECKSUM_OFFSET) -> MergedImage:
    """The computed image with what the device's own image, ``dump``, has beyond any description.

    Kept are alias, serial number, delays, private words, the size of the EEPROM, reserved bytes of General, the bytes
    behind the end mark, and every category that is not computed: 1 to 9 and the makers' own, also where the
    description declares one of the same number. PDI words and bootstrap mailbox stay as they are where the
    description says nothing: also behind the ``config_bytes`` bytes of a shorter ConfigData
    (:func:`esicatalog.export.sii_header.configuration_bytes`). The order is that of the dump.

    Raises :class:`InputError` when bytes up to the end mark of the dump were not read: they would be taken for the
    device's own.
    """
    unread = [lost for lost in dump.unread if lost.first < used_bytes(dump)]
    if unread:
        raise InputError(
            f"the dump does not hold the bytes {ranges_text(unread)}, and what was not read must not be written: read "
            "the whole EEPROM and merge into that"
        )
    unsaid = _unsaid(computed.header)
    header = merged_header(computed.header, dump.header, config_bytes, chain.from_iterable(unsaid.values()))
    image = SiiImage(header=header, categories=_categories(computed, dump))
    words = _kept_words(computed.header, dump.header, config_bytes, unsaid)
    return MergedImage(image, dump, (*words, *_kept_categories(computed, dump, image)))


def merged_header(computed: Header, dump: Header, config_bytes: int, unsaid: Iterable[str]) -> Header:
    """The computed header with the words of the device's own that no description says, and the ``unsaid`` ones."""
    fields = (*_DEVICE_WORDS, *unsaid)
    said, own = HEADER.write(computed), HEADER.write(dump)
    header = HEADER.read(said[:config_bytes] + own[config_bytes:CHECKSUM_OFFSET] + said[CHECKSUM_OFFSET:])
    return with_checksum(msgspec.structs.replace(header, **{field: getattr(dump, field) for field in fields}))


def _unsaid(computed: Header) -> dict[str, tuple[str, ...]]:
    return {
        what: fields for what, fields in _SAID_TOGETHER.items() if not any(getattr(computed, field) for field in fields)
    }


def _categories(computed: SiiImage, dump: SiiImage) -> tuple[Category, ...]:
    """The categories of the dump in their order, the computed ones in the places of the first of their type."""
    waiting = [item for item in computed.categories if not isinstance(item, RawCategory)]
    merged: list[Category] = []
    for own in dump.categories:
        replacement = next((item for item in waiting if item.category_type == own.category_type), None)
        if replacement is not None:
            waiting.remove(replacement)
            if isinstance(replacement, General) and isinstance(own, General):
                replacement = merged_general(replacement, own)
            merged.append(replacement)
        elif isinstance(own, RawCategory):
            merged.append(own)
    taken = {item.category_type for item in merged}
    declared = [item for item in computed.of_type(RawCategory) if item.category_type not in taken]
    return (*merged, *waiting, *declared)


def merged_general(computed: General, own: General) -> General:
    """The computed category with the reserved bytes of the device's own."""
    return msgspec.structs.replace(computed, **{field: getattr(own, field) for field in _RESERVED_IN_GENERAL})


def _kept_words(
    computed: Header, header: Header, config_bytes: int, unsaid: Mapping[str, tuple[str, ...]]
) -> Iterator[str]:
    if header.station_alias:
        yield f"station alias {header.station_alias}"
    if header.serial_no:
        yield f"serial number 0x{header.serial_no:08X}"
    if any((header.execution_delay, header.port0_delay, header.port1_delay, header.reserved_13)):
        yield "words 0x10 to 0x13"
    if any(header.private):
        yield "words 0x1D to 0x3D"
    if _PDI_WORDS not in unsaid and any(HEADER.write(header)[config_bytes:PDI_BYTES]):
        yield f"{_PDI_WORDS} from byte {config_bytes}, where ConfigData ends"
    for what, fields in unsaid.items():
        if any(getattr(header, field) for field in fields):
            yield f"{what}, not given in the description or zero there"
    if header.size_word != computed.size_word:
        yield f"size of the EEPROM, {header.byte_size} bytes; the description says {computed.byte_size}"


def _kept_categories(computed: SiiImage, dump: SiiImage, image: SiiImage) -> Iterator[str]:
    declared = {item.category_type: item.data for item in computed.of_type(RawCategory)}
    for category in dump.of_type(RawCategory):
        if category not in image.categories:
            continue
        other = declared.get(category.category_type, category.data) != category.data
        differs = "; the description declares other data" if other else ""
        yield f"{category_title(category.category_type)}, {counted(len(category.data), 'byte')}{differs}"
    if behind_end_mark(dump):
        yield f"{counted(len(behind_end_mark(dump)), 'byte')} behind the end mark"
