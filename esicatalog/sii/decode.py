"""From the bytes of an SII image to records. No byte outside the image is looked at, and none is lost."""

import re
from collections.abc import Callable

import msgspec

from esicatalog.sii.codes import category_title
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.findings import findings_of
from esicatalog.sii.image import (
    END_MARK,
    GENERAL,
    HEAD,
    MAX_IMAGE_BYTES,
    ByteRange,
    Category,
    DistributedClocks,
    Fmmus,
    General,
    RawCategory,
    RxPdos,
    SiiImage,
    Strings,
    SyncManagers,
    TxPdos,
)
from esicatalog.sii.records import DC_MODE, FMMU, HEADER, PDO, PDO_ENTRY, SYNC_MANAGER, Pdo, SiiString
from esicatalog.words import counted

_XML = re.compile(rb"(?:\xef\xbb\xbf)?\s*<[?!A-Za-z]|\xff\xfe<\0|\xfe\xff\0<")
"""How XML begins in UTF-8 and UTF-16. An image begins with the PDI control word, and there is no such PDI type."""
_TEXT = re.compile(r"[^\x00-\x08\x0b\x0c\x0e-\x1f\x7f]+")
"""No control characters but those between lines; every image has many others."""


def decode_sii(data: bytes, unread: tuple[ByteRange, ...] = ()) -> SiiImage:
    """The records of a raw image (:func:`esicatalog.sii.files.image_of_file` gives the one in a file).

    ``unread`` are the bytes of it that were not read, but filled.

    Kept in full: reserved and private words, unknown categories, padding, and the bytes after the end mark, so that
    ``encode_sii(decode_sii(data)) == data``. What is odd but readable is told in ``findings``, with byte offsets.
    A category whose data do not fit its type is kept as :class:`RawCategory`, with a finding.

    Raises :class:`SiiImageError` when the bytes are XML or other text, the header is incomplete, all bytes are 0x00 or
    all are 0xFF, a category runs past the end of the image, or there are more than 512 KiB.
    """
    _check_is_image(data)
    categories: list[Category] = []
    misfits: list[str] = []
    # Zeros in place of the end mark would read as endless categories of type 0 and length 0.
    zeros_from = len(data.rstrip(b"\0"))
    offset = HEADER.size
    while offset < zeros_from and not data.startswith(END_MARK, offset):
        category_type, body = _category_at(data, offset)
        try:
            category = _read(category_type, body)
        except _MisfitError as misfit:
            misfits.append(f"{category_title(category_type)} at byte 0x{offset:X}: {misfit}; kept raw")
            category = RawCategory(category_type=category_type, data=body)
        categories.append(category)
        offset += HEAD.size + len(body)
    end_mark = data.startswith(END_MARK, offset)
    image = SiiImage(
        header=HEADER.read(data),
        categories=tuple(categories),
        end_mark=end_mark,
        trailing=data[offset + len(END_MARK) * end_mark :],
        unread=unread,
    )
    return msgspec.structs.replace(image, findings=(*misfits, *findings_of(image)))


def _check_is_image(data: bytes) -> None:
    if _XML.match(data):
        raise SiiImageError("no SII image: an XML document; name what was read from the EEPROM, raw or Intel HEX")
    if _is_text(data):
        raise SiiImageError("no SII image: text; name what was read from the EEPROM, raw or Intel HEX")
    length = f"no SII image: its length in bytes is {len(data)}"
    if len(data) < HEADER.size:
        raise SiiImageError(f"{length}; the header alone takes {HEADER.size}")
    if len(data) > MAX_IMAGE_BYTES:
        raise SiiImageError(f"{length}; the largest EEPROM takes {MAX_IMAGE_BYTES}")
    for filler in (0x00, 0xFF):
        if data.count(filler) == len(data):
            raise SiiImageError(f"all bytes are 0x{filler:02X}: an empty EEPROM, no SII image")


def _is_text(data: bytes) -> bool:
    try:
        return _TEXT.fullmatch(data.decode()) is not None
    except UnicodeDecodeError:
        return False


def _category_at(data: bytes, offset: int) -> tuple[int, bytes]:
    """Type and data of the category at ``offset``."""
    start = offset + HEAD.size
    if start > len(data):
        raise SiiImageError(f"the image ends inside the head of the category at byte 0x{offset:X}")
    category_type, words = HEAD.unpack_from(data, offset)
    end = start + 2 * words
    if end > len(data):
        raise SiiImageError(
            f"{category_title(category_type)} at byte 0x{offset:X} runs past the end of the image: "
            f"{2 * words} bytes announced, {len(data) - start} left"
        )
    return category_type, data[start:end]


class _MisfitError(Exception):
    """The data of a category do not fit its type; the text tells why."""


def _read(category_type: int, body: bytes) -> Category:
    reader = _READERS.get(category_type)
    return reader(body) if reader is not None else RawCategory(category_type=category_type, data=body)


def _strings(body: bytes) -> Strings:
    if not body:
        raise _MisfitError("no string count")
    strings = []
    offset = 1
    for number in range(1, body[0] + 1):
        start = offset + 1
        if start > len(body) or start + body[offset] > len(body):
            raise _MisfitError(f"string {number} of {body[0]} runs past its end")
        offset = start + body[offset]
        strings.append(SiiString(data=body[start:offset]))
    return Strings(strings=tuple(strings), rest=body[offset:])


def _general(body: bytes) -> General:
    if len(body) < GENERAL.size:
        raise _MisfitError(f"{counted(len(body), 'byte')} where {GENERAL.size} are needed")
    return msgspec.structs.replace(GENERAL.read(body), rest=body[GENERAL.size :])


def _fmmus(body: bytes) -> Fmmus:
    return Fmmus(fmmus=FMMU.read_all(body)[0])


def _sync_managers(body: bytes) -> SyncManagers:
    sync_managers, rest = SYNC_MANAGER.read_all(body)
    return SyncManagers(sync_managers=sync_managers, rest=rest)


def _pdos(body: bytes) -> tuple[tuple[Pdo, ...], bytes]:
    """The PDOs, and the bytes from the first one that does not fit."""
    pdos = []
    offset = 0
    while offset + PDO.size <= len(body):
        values = PDO.values(body, offset)
        start = offset + PDO.size
        end = start + PDO_ENTRY.size * values.pop("entries")
        if end > len(body):
            break
        pdos.append(Pdo(entries=PDO_ENTRY.read_all(body[start:end])[0], **values))
        offset = end
    return tuple(pdos), body[offset:]


def _tx_pdos(body: bytes) -> TxPdos:
    pdos, rest = _pdos(body)
    return TxPdos(pdos=pdos, rest=rest)


def _rx_pdos(body: bytes) -> RxPdos:
    pdos, rest = _pdos(body)
    return RxPdos(pdos=pdos, rest=rest)


def _distributed_clocks(body: bytes) -> DistributedClocks:
    modes, rest = DC_MODE.read_all(body)
    return DistributedClocks(modes=modes, rest=rest)


_READERS: dict[int, Callable[[bytes], Category]] = {
    Strings.category_type: _strings,
    General.category_type: _general,
    Fmmus.category_type: _fmmus,
    SyncManagers.category_type: _sync_managers,
    TxPdos.category_type: _tx_pdos,
    RxPdos.category_type: _rx_pdos,
    DistributedClocks.category_type: _distributed_clocks,
}
