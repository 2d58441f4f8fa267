"""An SII image written down by hand from the format's rules (ETG.1000.6, ETG.2010), piece by piece."""

CONFIGURATION = bytes.fromhex("8003 006E 6400 0001 D204 1A00 0000")
"""PDI on-chip bus, SYNC pulse 100 x 10 ns, alias 1234, word 5 in use."""
HEADER = b"".join(
    (
        CONFIGURATION,
        bytes.fromhex("0000"),  # the check sum goes here
        bytes.fromhex("9A070000 EFBEADDE 02000100 2A000000"),  # vendor, product, revision, serial
        bytes.fromhex("0000 0000 0000 0000"),  # delays
        bytes.fromhex("0010 0001 0011 0001"),  # bootstrap mailbox: 0x1000, 256 bytes; 0x1100, 256 bytes
        bytes.fromhex("0010 8000 8010 8000"),  # standard mailbox: 0x1000, 128 bytes; 0x1080, 128 bytes
        bytes.fromhex("0C00"),  # CoE and FoE
        bytes(6) + bytes.fromhex("0600 1A00") + bytes(56),  # private words, two in use
        bytes.fromhex("0F00 0100"),  # 16 KiBit, version 1
    )
)
STRINGS = b"\x05" + b"\x05Motor" + b"\x07Antrieb" + b"\x0aStatusword" + b"\x05Gr\xf6\xdfe" + b"\x02\xc3\xa4" + b"\xff"
GENERAL = b"".join(
    (
        bytes.fromhex("02 00 01 03"),  # group 2, no image, order 1, name 3
        bytes.fromhex("00 25 01 00"),  # CoE: SDO, PDO assign, complete access; FoE
        bytes.fromhex("00 01 00 0C"),  # flags: mailbox data link layer, identification by AL status
        bytes.fromhex("30F8"),  # -2000 mA
        bytes.fromhex("04 00"),  # name of the group
        bytes.fromhex("3101"),  # ports MII, EBUS, MII, not used
        bytes.fromhex("3412"),  # identification address
        bytes(12),
    )
)
FMMUS = bytes.fromhex("01 02 03 FF")
SYNC_MANAGERS = bytes.fromhex(
    "0010 8000 26 00 01 01  8010 8000 22 00 01 02  0011 0000 64 00 01 03  0012 0000 20 00 09 04"
)
TX_PDOS = b"".join(
    (
        bytes.fromhex("001A 02 03 00 03 1100"),  # two entries, SM3, string 3, mandatory and fixed
        bytes.fromhex("4160 00 03 06 10 0000"),
        bytes.fromhex("0000 00 00 00 08 0000"),  # a gap of one byte
        bytes.fromhex("011A 00 FF 00 00 0008"),  # no entries, not assigned, overwritten by module
    )
)
RX_PDOS = bytes.fromhex("0016 01 02 00 01 0200") + bytes.fromhex("7A60 00 01 04 20 0000")
DC = b"".join(
    (
        bytes.fromhex("00000000 00000000 00000000 0000 0000 0100 01 00 00000000"),
        bytes.fromhex("40420F00 10270000 FFFFFFFF FEFF 0007 0100 02 03 00000000"),
    )
)
PRIVATE = b"factory data"
CATEGORIES = ((3, PRIVATE), (10, STRINGS), (30, GENERAL), (40, FMMUS), (41, SYNC_MANAGERS), (43, b"\xf0\xff"))
CATEGORIES += ((50, TX_PDOS), (51, RX_PDOS), (60, DC))
END = b"\xff\xff"


def remainder_crc(data: bytes) -> int:
    """CRC-8 as the definition says it: the remainder of the message, first byte inverted, times x^8, by 0x107."""
    value = int.from_bytes(bytes([data[0] ^ 0xFF]) + data[1:], "big") << 8
    while value.bit_length() > 8:
        value ^= 0x107 << value.bit_length() - 9
    return value


def with_crc(header: bytes) -> bytes:
    """A header whose check sum is right."""
    return header[:14] + bytes([remainder_crc(header[:14])]) + header[15:]


def category(category_type: int, body: bytes) -> bytes:
    """A category: type, length in words, data."""
    return category_type.to_bytes(2, "little") + (len(body) // 2).to_bytes(2, "little") + body


def image(*categories: tuple[int, bytes], end: bytes = END, header: bytes = HEADER) -> bytes:
    """An image of these categories with a right check sum."""
    return with_crc(header) + b"".join(category(*item) for item in categories) + end


WHOLE = image(*CATEGORIES, end=END + b"\xff" * 6)
