"""From records to the bytes of an SII image."""

from collections.abc import Iterable, Iterator
from itertools import accumulate

from esicatalog.sii.codes import category_title
from esicatalog.sii.errors import SiiEncodeError
from esicatalog.sii.image import (
    END_MARK,
    END_TYPE,
    GENERAL,
    HEAD,
    Category,
    DistributedClocks,
    Fmmus,
    General,
    RawCategory,
    SiiImage,
    Strings,
    SyncManagers,
)
from esicatalog.sii.layout import Layout, R
from esicatalog.sii.records import DC_MODE, FMMU, HEADER, PDO, PDO_ENTRY, SYNC_MANAGER, Pdo, SiiString
from esicatalog.sii.strings import MAX_STRING_BYTES, encode_text
from esicatalog.words import counted

MAX_STRINGS = 255
_MAX_WORDS = 0xFFFF
_PADDING = b"\xff"
"""What vendor tools pad the string table with."""


def encode_sii(image: SiiImage) -> bytes:
    """The bytes of an image: exactly what the records say, in their order, without the findings.

    Nothing is added: the check sum is the stored one (:func:`esicatalog.sii.checksum.with_checksum` computes it),
    the bytes after the end mark are ``trailing``, the size word may say another size.

    Raises :class:`SiiEncodeError` for a value that its field cannot hold, more than 255 strings or entries, category
    data of an odd length, and an image without end mark whose trailing bytes would read as categories.
    """
    if not image.end_mark and image.trailing.strip(b"\0"):
        raise SiiEncodeError("without an end mark, the trailing bytes would read as categories")
    parts = [HEADER.write(image.header)]
    for category in image.categories:
        body = category_body(category)
        parts += HEAD.pack(category.category_type, len(body) // 2), body
    return b"".join(parts) + END_MARK * image.end_mark + image.trailing


def category_body(category: Category) -> bytes:
    """The data of a category, without type and length. Raises :class:`SiiEncodeError`."""
    body = b"".join(_pieces(category))
    title = category_title(category.category_type)
    if not 0 <= category.category_type < END_TYPE:
        raise SiiEncodeError(f"{title}: a category type is 0 to 0x{END_TYPE - 1:X}")
    if len(body) % 2 or len(body) > 2 * _MAX_WORDS:
        raise SiiEncodeError(
            f"{title}: {counted(len(body), 'byte is', 'bytes are')} no number of words from 0 to {_MAX_WORDS}"
        )
    return body


def category_offsets(image: SiiImage) -> list[int]:
    """Byte offsets of the categories, and at last that of what follows them. Raises :class:`SiiEncodeError`."""
    sizes = (HEAD.size + len(category_body(category)) for category in image.categories)
    return list(accumulate(sizes, initial=HEADER.size))


def string_table(texts: Iterable[str]) -> Strings:
    """The category that holds ``texts`` as the strings 1, 2, …, padded to a whole word.

    Raises :class:`SiiEncodeError` for a text that does not fit, see :func:`esicatalog.sii.strings.encode_text`.
    """
    strings = tuple(SiiString(data=encode_text(text)) for text in texts)
    odd = (1 + len(strings) + sum(len(string.data) for string in strings)) % 2
    return Strings(strings=strings, rest=_PADDING * odd)


def _pieces(category: Category) -> Iterator[bytes]:
    match category:
        case RawCategory():
            yield category.data
        case Strings():
            yield from _strings(category)
            yield category.rest
        case General():
            yield GENERAL.write(category)
            yield category.rest
        case Fmmus():
            yield from _all(FMMU, category.fmmus, "FMMU{}", 0)
        case SyncManagers():
            yield from _all(SYNC_MANAGER, category.sync_managers, "SM{}", 0)
            yield category.rest
        case DistributedClocks():
            yield from _all(DC_MODE, category.modes, "OpMode {}", 1)
            yield category.rest
        case _:
            for pdo in category.pdos:
                yield from _pdo(pdo)
            yield category.rest


def _strings(category: Strings) -> Iterator[bytes]:
    if len(category.strings) > MAX_STRINGS:
        raise SiiEncodeError(f"{len(category.strings)} strings; a string table holds {MAX_STRINGS}")
    yield bytes([len(category.strings)])
    for number, string in enumerate(category.strings, start=1):
        if len(string.data) > MAX_STRING_BYTES:
            raise SiiEncodeError(f"string {number} takes {len(string.data)} bytes; a string holds {MAX_STRING_BYTES}")
        yield bytes([len(string.data)]) + string.data


def _pdo(pdo: Pdo) -> Iterator[bytes]:
    try:
        yield PDO.write(pdo)
        yield from _all(PDO_ENTRY, pdo.entries, "entry {}", 1)
    except SiiEncodeError as error:
        raise SiiEncodeError(f"PDO 0x{pdo.pdo_index:04X}: {error}") from error


def _all(layout: Layout[R], records: Iterable[R], label: str, first: int) -> Iterator[bytes]:
    """The records one by one; ``label`` says which it is, counted from ``first``, of which a value does not fit."""
    for number, record in enumerate(records, first):
        try:
            yield layout.write(record)
        except SiiEncodeError as error:
            raise SiiEncodeError(f"{label.format(number)}: {error}") from error
