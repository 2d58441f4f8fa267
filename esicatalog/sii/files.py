"""Files that hold an SII image: raw, or Intel HEX whatever the file is called."""

import re
from typing import NamedTuple

from esicatalog.scan.text import decode_text, quoted
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.image import FILLER, MAX_IMAGE_BYTES, ByteRange, SiiImage, ranges_text
from esicatalog.words import counted

_NOT_DECODED = "\ufffd"
_MARKS = "\ufeff\x1b"
"""The mark of an encoding, and what begins the colours of a terminal."""
# A raw image starts with the PDI control word, and there is no PDI type 0x3A (":").
_INTEL_HEX = re.compile(rb":|(?:\xef\xbb\xbf)?\s*:[0-9A-Fa-f]{8}")
_LEFT_OUT = re.compile(rb"\0+")
_RECORD = re.compile(r":((?:[0-9A-Fa-f]{2}){5,})")
_DATA, _END, _SEGMENT, _START_SEGMENT, _LINEAR, _START_LINEAR = range(6)
_PAYLOAD_BYTES = {_END: 0, _SEGMENT: 2, _START_SEGMENT: 4, _LINEAR: 2, _START_LINEAR: 4}
_BASE_SHIFT = {_SEGMENT: 4, _LINEAR: 16}
"""By how many bits the payload of an address record is shifted to give the base of the following data."""


class FileImage(NamedTuple):
    """The image in a file."""

    data: bytes
    unread: tuple[ByteRange, ...] = ()
    """Where an Intel HEX file has no data, and ``data`` therefore :data:`~esicatalog.sii.image.FILLER`."""


def read_sii(data: bytes) -> SiiImage:
    """The records of an EEPROM image from the bytes of a file, raw or Intel HEX by content.

    What is odd but readable, a wrong check sum or bytes that an Intel HEX file leaves out for instance, is told in
    ``findings``. Raises :class:`SiiImageError`, a :class:`~esicatalog.errors.DocumentError`, as :func:`image_of_file`
    and :func:`~esicatalog.sii.decode.decode_sii`.
    """
    image, unread = image_of_file(data)
    try:
        return decode_sii(image, unread)
    except SiiImageError as error:
        if not unread:
            raise
        raise SiiImageError(f"{error}; the file does not hold the bytes {ranges_text(unread)}") from error


def image_of_file(data: bytes) -> FileImage:
    """The image in the bytes of a file, raw or Intel HEX by content.

    Raises :class:`SiiImageError` for a broken Intel HEX file, with its line, and for any other text.
    """
    if is_intel_hex(data):
        return _intel_hex(data)
    _check_is_no_text(data)
    return FileImage(data)


def is_intel_hex(data: bytes) -> bool:
    """Whether the bytes of a file are Intel HEX; editors put a byte order mark or blank lines before it."""
    return _INTEL_HEX.match(data) is not None


def _check_is_no_text(data: bytes) -> None:
    """An image holds zeros and other bytes that no text has; read as categories a text gives errors without sense."""
    text = decode_text(data[:MAX_IMAGE_BYTES])
    if text and _NOT_DECODED not in text and all(map(_is_of_text, set(text))):
        raise SiiImageError(f"a text, no SII image; it begins with {quoted(text)}")


def _is_of_text(character: str) -> bool:
    return character.isprintable() or character.isspace() or character in _MARKS


def _intel_hex(data: bytes) -> FileImage:
    image = bytearray()
    given = bytearray()
    base = 0
    ended = False
    for number, line in enumerate(data.decode("utf-8-sig", "replace").splitlines(), start=1):
        if not line.strip():
            continue
        if ended:
            raise _broken(number, "data after the end record")
        kind, address, payload = _record(line.strip(), number)
        if kind == _DATA:
            _place(image, given, base + address, payload, number)
        elif kind in _BASE_SHIFT:
            base = int.from_bytes(payload, "big") << _BASE_SHIFT[kind]
        ended = kind == _END
    if not ended:
        raise SiiImageError("Intel HEX: no end record; the file is cut")
    unread = (ByteRange(match.start(), match.end() - 1) for match in _LEFT_OUT.finditer(given))
    return FileImage(bytes(image), tuple(unread))


def _record(line: str, number: int) -> tuple[int, int, bytes]:
    """Type, 16 bit address and payload of a line."""
    match = _RECORD.fullmatch(line)
    if match is None:
        raise _broken(number, "not a record of the form :LLAAAATT…CC in pairs of hex digits")
    count, high, low, kind, *payload, _ = record = bytes.fromhex(match[1])
    if len(payload) != count:
        raise _broken(number, f"{counted(len(payload), 'data byte')} where {counted(count, 'is', 'are')} announced")
    if sum(record) & 0xFF:
        raise _broken(number, f"check sum is 0x{record[-1]:02X}, not 0x{-sum(record[:-1]) & 0xFF:02X}")
    if kind != _DATA and count != _PAYLOAD_BYTES.get(kind):
        raise _broken(number, f"no record type {kind:02X} with {counted(count, 'data byte')}")
    return kind, high << 8 | low, bytes(payload)


def _place(image: bytearray, given: bytearray, address: int, payload: bytes, number: int) -> None:
    end = address + len(payload)
    if end > MAX_IMAGE_BYTES:
        raise _broken(number, f"address 0x{address:X} is beyond {MAX_IMAGE_BYTES} bytes, the largest EEPROM")
    missing = end - len(image)
    if missing > 0:
        image.extend(bytes([FILLER]) * missing)
        given.extend(bytes(missing))
    if any(given[address:end]):
        raise _broken(number, f"data at address 0x{address:X} are given twice")
    image[address:end] = payload
    given[address:end] = b"\1" * len(payload)


def _broken(number: int, what: str) -> SiiImageError:
    return SiiImageError(f"Intel HEX line {number}: {what}", number)
