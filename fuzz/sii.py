"""EEPROM images: decoded, encoded again to the same bytes, and printed."""

import random
from collections.abc import Iterator

from esicatalog.errors import EsiCatalogError
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.files import image_of_file
from esicatalog.sii.text import sheet_lines
from esicatalog.sii.view import sii_json
from fuzz.mutations import mutated_bytes
from fuzz.seeds import real_files

_HEADER = bytes.fromhex("80030066") + bytes(4) + bytes(6) + b"\x9e\x00" + bytes(112)
_STRINGS = bytes.fromhex("0a000300") + b"\x01\x04Name"
_MANAGERS = bytes.fromhex("29000800") + bytes.fromhex("00108000260001010014800022000102")
_PDO = bytes.fromhex("32000800") + bytes.fromhex("001a0103000000000060010100100000")
_CLOCK = bytes.fromhex("3c000c00") + bytes(24)


def check(data: bytes) -> None:
    """Decode an image; what was decoded says all its bytes."""
    try:
        raw, unread = image_of_file(data)
        image = decode_sii(raw, unread)
    except EsiCatalogError as error:
        assert "\n" not in str(error)
        return
    assert encode_sii(image) == raw
    assert list(sheet_lines(image))
    sii_json(image)


def seeds() -> Iterator[bytes]:
    """Images."""
    yield _HEADER + _STRINGS + _MANAGERS + _PDO + _CLOCK + b"\xff\xff"
    yield _HEADER + b"\xff\xff"
    yield from real_files("sii")


def mutate(data: bytes, seed: int) -> bytes:
    """Another image."""
    return mutated_bytes(data, random.Random(seed))
