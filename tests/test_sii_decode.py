"""SII images to records: values by the format's rules, findings, and what is no image."""

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sii import by_hand
from sii.by_hand import END, image

from esicatalog.errors import DocumentError
from esicatalog.sii.checksum import crc8, header_checksum, with_checksum
from esicatalog.sii.codes import (
    CoeDetails,
    EscConfiguration,
    GeneralFlags,
    MailboxProtocols,
    PdoFlags,
    SmControl,
    SmEnable,
    flag_words,
)
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.image import RawCategory, SiiImage
from esicatalog.sii.records import DcMode, Fmmu, PdoEntry, SyncManager
from esicatalog.sii.text import sheet_lines
from esicatalog.sii.view import sii_json

FIRST = 0x80
"""Byte of the first category."""


@pytest.fixture(scope="module")
def whole() -> SiiImage:
    return decode_sii(by_hand.WHOLE)


def test_a_sound_image_has_no_findings(whole):
    assert whole.findings == ()
    assert [category.category_type for category in whole.categories] == [3, 10, 30, 40, 41, 43, 50, 51, 60]
    assert whole.end_mark
    assert whole.trailing == b"\xff" * 6


def test_header(whole):
    header = whole.header
    assert (header.vendor_id, header.product_code) == (0x79A, 0xDEADBEEF)
    assert (header.revision_no, header.serial_no) == (0x10002, 42)
    assert header.pdi_control == 0x0380
    assert header.pdi_type == "on-chip bus (Microchip LAN925x: SPI)"
    assert header.esc_configuration == EscConfiguration.DEVICE_EMULATION | EscConfiguration.ENHANCED_LINK_DETECTION
    assert (header.pdi_configuration, header.pdi_configuration_2) == (0x6E00, 0x0100)
    assert header.sync_impulse_length_10ns == 100
    assert header.sync_impulse_length_ns == 1000
    assert header.station_alias == 1234
    assert (header.reserved_5, header.reserved_6) == (0x1A, 0)
    assert (header.bootstrap_receive_mailbox_offset, header.bootstrap_receive_mailbox_size) == (0x1000, 256)
    assert (header.bootstrap_send_mailbox_offset, header.bootstrap_send_mailbox_size) == (0x1100, 256)
    assert (header.standard_receive_mailbox_offset, header.standard_receive_mailbox_size) == (0x1000, 128)
    assert (header.standard_send_mailbox_offset, header.standard_send_mailbox_size) == (0x1080, 128)
    assert header.mailbox_protocols == MailboxProtocols.CoE | MailboxProtocols.FoE
    assert header.private == bytes(6) + b"\x06\x00\x1a\x00" + bytes(56)
    assert (header.size_word, header.byte_size, header.version) == (15, 2048, 1)


def test_general(whole):
    general = whole.general
    assert whole.text(general.group_string_number) == "Antrieb"
    assert whole.text(general.image_string_number) is None
    assert whole.text(general.order_string_number) == "Motor"
    assert whole.text(general.name_string_number) == "Statusword"
    assert whole.text(general.group_name_string_number) == "Größe"
    assert general.coe_details == CoeDetails.SDO | CoeDetails.PDO_ASSIGN | CoeDetails.COMPLETE_ACCESS
    assert general.foe_details == 1
    assert general.eoe_details == 0
    assert general.ds402_channels == 1
    assert general.flags == GeneralFlags.MAILBOX_DATA_LINK_LAYER | GeneralFlags.IDENT_AL_STATUS
    assert general.e_bus_current_ma == -2000
    assert general.port_types == ("MII", "EBUS", "MII", "not used")
    assert general.identification_address == 0x1234


def test_fmmus(whole):
    assert whole.fmmus == tuple(Fmmu(usage_code=code) for code in (1, 2, 3, 0xFF))
    assert [fmmu.usage for fmmu in whole.fmmus] == ["Outputs", "Inputs", "MBoxState", "unused"]
    assert Fmmu(usage_code=9).usage is None


def test_sync_managers(whole):
    assert whole.sync_managers[0] == SyncManager(
        start_address=0x1000, length_bytes=128, control_byte=0x26, enable=SmEnable.ENABLE, usage_code=1
    )
    assert [sm.usage for sm in whole.sync_managers] == ["MBoxOut", "MBoxIn", "Outputs", "Inputs"]
    assert [sm.buffer_mode for sm in whole.sync_managers] == ["mailbox", "mailbox", "buffered", "buffered"]
    assert [sm.direction for sm in whole.sync_managers] == ["output", "input", "output", "input"]
    assert whole.sync_managers[2].control == SmControl.PDI_INTERRUPT | SmControl.WATCHDOG
    assert whole.sync_managers[3].enable == SmEnable.ENABLE | SmEnable.OP_ONLY


def test_pdos(whole):
    first, second = whole.tx_pdos
    assert (first.pdo_index, first.sm, first.dc_sync, whole.text(first.name_string_number)) == (
        0x1A00,
        3,
        0,
        "Statusword",
    )
    assert first.flags == PdoFlags.MANDATORY | PdoFlags.FIXED_CONTENT
    assert first.entries == (
        PdoEntry(entry_index=0x6041, subindex=0, name_string_number=3, data_type_code=6, bit_length=16),
        PdoEntry(bit_length=8),
    )
    assert [entry.data_type for entry in first.entries] == ["UINT", None]
    assert first.bit_length == 24
    assert (second.pdo_index, second.entries, second.sm) == (0x1A01, (), 0xFF)
    assert second.flags == PdoFlags.OVERWRITTEN_BY_MODULE
    (out,) = whole.rx_pdos
    assert (out.pdo_index, out.flags, out.entries[0].entry_index) == (0x1600, PdoFlags.DEFAULT, 0x607A)


def test_dc_modes(whole):
    free_run, dc_sync = whole.dc_modes
    assert (free_run.cycle_time_sync0_factor, free_run.dc_active, free_run.sync0) == (1, False, False)
    assert dc_sync == DcMode(
        cycle_time_sync0_ns=1_000_000,
        shift_time_sync0_ns=10_000,
        shift_time_sync1_ns=-1,
        cycle_time_sync1_factor=-2,
        assign_activate=0x0700,
        cycle_time_sync0_factor=1,
        name_string_number=2,
        description_string_number=3,
    )


@pytest.mark.parametrize(
    ("word", "signals"),
    [
        (0x0000, (False, False, False)),
        (0x0100, (True, False, False)),
        (0x0300, (True, True, False)),
        (0x0500, (True, False, True)),
        (0x0700, (True, True, True)),
        (0x0630, (False, False, False)),
    ],
)
def test_sync_signals_need_the_sync_unit(word, signals):
    mode = DcMode(assign_activate=word)
    assert (mode.dc_active, mode.sync0, mode.sync1) == signals


def test_encodings_are_guessed(whole):
    (table,) = (category for category in whole.categories if category.category_type == 10)
    assert [string.encoding for string in table.strings] == ["ascii", "ascii", "ascii", "cp1252", "utf-8"]
    assert whole.text(5) == "ä"
    assert decode_sii(image((10, b"\x01\x04\x81\xe4\x00\x00"))).text(1) == "\x81ä", "no such letter in Windows-1252"
    assert table.rest == b"\xff"


def test_string_numbers_count_from_one(whole):
    assert [whole.text(number) for number in (-1, 0, 1, 6)] == [None, None, "Motor", None]
    assert SiiImage().text(1) is None


def test_unknown_categories_are_kept_raw(whole):
    assert whole.categories[0] == RawCategory(category_type=3, data=by_hand.PRIVATE)
    assert whole.categories[5] == RawCategory(category_type=43, data=b"\xf0\xff")


@pytest.mark.parametrize(
    ("message", "crc"),
    [
        (b"123456789", 0xFB),
        (bytes.fromhex("8002 006E FF00 FF00 0000 0000 0000"), 0xB6),
    ],
)
def test_check_sums_that_others_publish(message, crc):
    assert crc8(message) == crc


@given(st.binary(min_size=1, max_size=40))
def test_the_check_sum_is_a_polynomial_remainder(data):
    assert crc8(data) == by_hand.remainder_crc(data)


def test_a_wrong_check_sum_is_told():
    wrong = bytearray(by_hand.WHOLE)
    right = wrong[14]
    wrong[14] ^= 0x55
    decoded = decode_sii(bytes(wrong))
    assert decoded.findings == (f"check sum at byte 0xE is 0x{right ^ 0x55:02X}; the words 0 to 6 need 0x{right:02X}",)
    assert header_checksum(decoded.header) == right
    assert with_checksum(decoded.header) == decode_sii(by_hand.WHOLE).header


ODD = {
    "the size word is too small": (
        image((3, b"AB"), header=by_hand.HEADER[:124] + b"\0\0\1\0"),
        "size word at byte 0x7C says 128 bytes; the image has 136",
    ),
    "a string number is beyond the table": (
        image((10, b"\1\1A\0"), (51, bytes.fromhex("0016 01 02 00 07 0000 0070 01 02 07 20 0000"))),
        "category 51 (RxPDO) at byte 0x88 names strings (2, 7) beyond the 1 of the table",
    ),
    "there are string numbers and no table": (
        image((30, by_hand.GENERAL)),
        "category 30 (General) at byte 0x80 names strings (1, 2, 3, 4) beyond the 0 of the table",
    ),
    "a string runs past its category": (
        image((10, b"\2\3ABC\4xy")),
        "category 10 (STRINGS) at byte 0x80: string 2 of 2 runs past its end; kept raw",
    ),
    "a string begins past its category": (
        image((10, b"\3\2AB")),
        "category 10 (STRINGS) at byte 0x80: string 2 of 3 runs past its end; kept raw",
    ),
    "the string table is empty": (
        image((10, b"")),
        "category 10 (STRINGS) at byte 0x80: no string count; kept raw",
    ),
    "bytes follow the strings": (
        image((10, b"\1\1A\0\0\0")),
        "category 10 (STRINGS) at byte 0x80: 3 bytes from byte 0x87 belong to no whole record",
    ),
    "General is short": (
        image((30, bytes(30))),
        "category 30 (General) at byte 0x80: 30 bytes where 32 are needed; kept raw",
    ),
    "General is long": (
        image((30, bytes(34))),
        "category 30 (General) at byte 0x80: 2 bytes from byte 0xA4 belong to no whole record",
    ),
    "a sync manager is cut": (
        image((41, by_hand.SYNC_MANAGERS[:12])),
        "category 41 (SyncM) at byte 0x80: 4 bytes from byte 0x8C belong to no whole record",
    ),
    "a PDO announces more entries than there are": (
        image((51, bytes.fromhex("0016 00 02 00 00 0000 0116 02 02 00 00 0000 0070 01 00 07 20 0000"))),
        "category 51 (RxPDO) at byte 0x80: 16 bytes from byte 0x8C belong to no whole record",
    ),
    "an OpMode is cut": (
        image((60, bytes(26))),
        "category 60 (DC) at byte 0x80: 2 bytes from byte 0x9C belong to no whole record",
    ),
    "a category occurs twice": (
        image((40, b"\1\2"), (3, b"AB"), (3, b"CD"), (40, b"\1\2")),
        "category 40 (FMMU) occurs 2 times, at the bytes 0x80, 0x92",
    ),
    "the image ends without end mark": (
        image((40, b"\1\2"), end=b""),
        "no end mark after the last category: the image ends at byte 0x86",
    ),
    "the header is all": (
        image(end=b""),
        "no end mark after the last category: the image ends at byte 0x80",
    ),
    "zeros take the place of the end mark": (
        image((40, b"\1\2"), end=bytes(101)),
        "no end mark after the last category: nothing but zeros follows from byte 0x86",
    ),
}


@pytest.mark.parametrize("case", ODD)
def test_odd_images_are_decoded_with_a_finding(case):
    data, finding = ODD[case]
    decoded = decode_sii(data)
    assert decoded.findings == (finding,)
    assert encode_sii(decoded) == data


def test_what_fits_is_read_although_the_rest_does_not():
    data, _ = ODD["a PDO announces more entries than there are"]
    assert [pdo.pdo_index for pdo in decode_sii(data).rx_pdos] == [0x1600]
    data, _ = ODD["a sync manager is cut"]
    assert len(decode_sii(data).sync_managers) == 1


def test_the_first_string_table_counts():
    assert decode_sii(image((10, b"\1\1A\0"), (10, b"\1\1B\0"))).text(1) == "A"


def test_empty_categories_between_others_are_kept():
    data = image((0, b""), (0, b""), (40, b"\1\2"))
    assert len(decode_sii(data).categories) == 3
    assert encode_sii(decode_sii(data)) == data


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "its length in bytes is 0"),
        (by_hand.HEADER[:127], "its length in bytes is 127; the header alone takes 128"),
        (by_hand.HEADER + b"\xff" * 2**19, "its length in bytes is 524416; the largest EEPROM takes 524288"),
        (bytes(2048), "all bytes are 0x00: an empty EEPROM"),
        (b"\xff" * 2048, "all bytes are 0xFF: an empty EEPROM"),
        (image((10, b"\1\1A\0"))[:-5], "category 10 (STRINGS) at byte 0x80 runs past the end of the image: 4 bytes"),
        (image(end=b"\x32\x00\xff\xff"), "category 50 (TxPDO) at byte 0x80 runs past the end of the image: 131070 "),
        (image((3, b"AB"), end=b"\x0a"), "ends inside the head of the category at byte 0x86"),
        (image((3, b"AB"), end=b"\x0a\x00\x01"), "ends inside the head of the category at byte 0x86"),
        (b"<?xml version='1.0'?>".ljust(400, b"x"), "no SII image: an XML document"),
        (b"\xef\xbb\xbf\r\n<EtherCATInfo/>", "no SII image: an XML document"),
        ("<?xml version='1.0' encoding='utf-16'?><EtherCATInfo/>".encode("utf-16"), "no SII image: an XML document"),
        (b"Master 0, Slave 0\r\n\tgr\xc3\xbcn\n" * 20, "no SII image: text; name what was read from the EEPROM"),
    ],
)
def test_what_is_no_image_ends_in_one_line(data, words):
    with pytest.raises(SiiImageError) as caught:
        decode_sii(data)
    assert isinstance(caught.value, DocumentError)
    assert words in str(caught.value)


def survives(data: bytes) -> None:
    """Decoding ends in one line, or in records that give the bytes back and can be shown."""
    try:
        decoded = decode_sii(data)
    except SiiImageError as error:
        assert "\n" not in str(error)
        return
    assert encode_sii(decoded) == data
    msgspec.json.encode(sii_json(decoded))
    for line in sheet_lines(decoded):
        assert line.isprintable()


@settings(max_examples=300, deadline=None)
@given(st.binary(max_size=400))
def test_random_bytes(data):
    survives(data)
    survives(by_hand.with_crc(by_hand.HEADER) + data)


@settings(max_examples=300, deadline=None)
@given(
    st.lists(
        st.tuples(st.sampled_from([0, 3, 10, 30, 40, 41, 43, 50, 51, 60, 2048]), st.binary(max_size=60)), max_size=6
    )
)
def test_random_contents_of_known_categories(categories):
    survives(image(*((kind, body[: len(body) // 2 * 2]) for kind, body in categories)))


def test_every_truncation():
    for length in range(len(by_hand.WHOLE)):
        survives(by_hand.WHOLE[:length])


@settings(max_examples=300, deadline=None)
@given(st.lists(st.tuples(st.integers(0, len(by_hand.WHOLE) - 1), st.integers(0, 255)), min_size=1, max_size=4))
def test_mutations(changes):
    data = bytearray(by_hand.WHOLE)
    for position, value in changes:
        data[position] = value
    survives(bytes(data))


def test_a_large_image_of_empty_categories_takes_no_time():
    data = image(end=bytes(400_000) + END)
    assert len(decode_sii(data).categories) == 100_000


def test_flags_in_words():
    assert flag_words(PdoFlags(0x8011)) == ["mandatory", "fixed content", "bit 15"]
    assert flag_words(MailboxProtocols(0x0C)) == ["CoE", "FoE"]
    assert flag_words(CoeDetails(0x05)) == ["SDO", "PDO assign"]
    assert flag_words(SmEnable(0)) == []
