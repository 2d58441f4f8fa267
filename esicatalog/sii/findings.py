"""What is odd about an SII image that can be read, in short sentences with byte offsets."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from esicatalog.sii.checksum import CHECKSUM_OFFSET, NOT_TESTED, header_checksum, is_loaded
from esicatalog.sii.codes import category_title
from esicatalog.sii.encode import category_offsets
from esicatalog.sii.image import END_MARK, FILLER, PADDING_BYTES, Fmmus, RawCategory, SiiImage, Strings, ranges_text
from esicatalog.sii.layout import SiiRecord

_SIZE_WORD_OFFSET = 0x7C
STRING_NUMBER = "_string_number"
"""How the names of fields end that reference the string table."""


def findings_of(image: SiiImage) -> tuple[str, ...]:
    """The findings that the records themselves show."""
    offsets = category_offsets(image)
    end = offsets[-1]
    return (
        *_unread(image),
        *_checksum(image),
        *_size(image, end + len(END_MARK) * image.end_mark + len(image.trailing)),
        *_contents(image, offsets),
        *_repeated(image, offsets),
        *_ending(image, end),
    )


def _unread(image: SiiImage) -> Iterator[str]:
    if image.unread:
        yield f"the file does not hold the bytes {ranges_text(image.unread)}: 0x{FILLER:X} stands in their place"


def _checksum(image: SiiImage) -> Iterator[str]:
    stored, needed = image.header.checksum, header_checksum(image.header)
    if stored == needed:
        return
    where = f"check sum at byte 0x{CHECKSUM_OFFSET:X} is"
    if is_loaded(image.header):
        yield f"{where} 0x{NOT_TESTED:X}, with which it is not tested: for debugging only"
    else:
        yield f"{where} 0x{stored:02X}; the words 0 to 6 need 0x{needed:02X}"


def _size(image: SiiImage, size: int) -> Iterator[str]:
    if size > image.header.byte_size:
        yield f"size word at byte 0x{_SIZE_WORD_OFFSET:X} says {image.header.byte_size} bytes; the image has {size}"


def _contents(image: SiiImage, offsets: Sequence[int]) -> Iterator[str]:
    tables = image.of_type(Strings)
    known = len(tables[0].strings) if tables else 0
    for category, (offset, end) in zip(image.categories, pairwise(offsets), strict=True):
        where = f"{category_title(category.category_type)} at byte 0x{offset:X}"
        rest = b"" if isinstance(category, RawCategory | Fmmus) else category.rest
        padding = PADDING_BYTES if isinstance(category, Strings) else 0
        if len(rest) > padding:
            yield f"{where}: {len(rest)} bytes from byte 0x{end - len(rest):X} belong to no whole record"
        beyond = sorted({number for number in _string_numbers(category) if number > known})
        if beyond:
            yield f"{where} names strings ({', '.join(map(str, beyond))}) beyond the {known} of the table"


def _string_numbers(record: SiiRecord) -> Iterator[int]:
    for name in record.__struct_fields__:
        value = getattr(record, name)
        if name.endswith(STRING_NUMBER):
            yield value
        elif isinstance(value, tuple):
            for item in value:
                yield from _string_numbers(item)


def _repeated(image: SiiImage, offsets: Sequence[int]) -> Iterator[str]:
    places: dict[int, list[str]] = {}
    for category, offset in zip(image.categories, offsets, strict=False):
        # Vendors may repeat their own categories, and NOP means nothing.
        if not isinstance(category, RawCategory):
            places.setdefault(category.category_type, []).append(f"0x{offset:X}")
    for category_type, listed in places.items():
        if len(listed) > 1:
            yield f"{category_title(category_type)} occurs {len(listed)} times, at the bytes {', '.join(listed)}"


def _ending(image: SiiImage, end: int) -> Iterator[str]:
    if not image.end_mark:
        instead = "nothing but zeros follows from" if image.trailing else "the image ends at"
        yield f"no end mark after the last category: {instead} byte 0x{end:X}"
