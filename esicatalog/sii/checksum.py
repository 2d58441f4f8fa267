"""The check sum over the configuration words of an SII image."""

import msgspec

from esicatalog.sii.records import HEADER, Header

CHECKSUM_OFFSET = 14
"""Byte of the check sum; it covers the bytes before, which the slave controller loads at power-on."""
NOT_TESTED = 0x88A4
"""Check word with which a slave controller loads its configuration untested (ESC data sheet: for debugging only)."""
_POLYNOMIAL = 0x07
_INITIAL = 0xFF


def _step(value: int) -> int:
    for _ in range(8):
        value = (value << 1 ^ (_POLYNOMIAL if value & 0x80 else 0)) & 0xFF
    return value


_TABLE = bytes(map(_step, range(256)))


def crc8(data: bytes) -> int:
    """CRC-8 with polynomial 0x07 (x^8 + x^2 + x + 1), initial value 0xFF, not reflected (ETG.1000.6)."""
    value = _INITIAL
    for byte in data:
        value = _TABLE[value ^ byte]
    return value


def header_checksum(header: Header) -> int:
    """The check sum that the configuration words of ``header`` need."""
    return crc8(HEADER.write(header)[:CHECKSUM_OFFSET])


def is_loaded(header: Header) -> bool:
    """Whether a slave controller takes the configuration words; with a wrong check sum it ignores them."""
    check_word = header.checksum_high_byte << 8 | header.checksum
    return check_word == NOT_TESTED or header.checksum == header_checksum(header)


def with_checksum(header: Header) -> Header:
    """``header`` with the right check sum."""
    return msgspec.structs.replace(header, checksum=header_checksum(header), checksum_high_byte=0)
