"""SII images as a sheet and as JSON."""

import json

import pytest
from sii import by_hand
from sii.by_hand import image

from esicatalog.model.base_types import BASE_TYPES
from esicatalog.sii.codes import DATA_TYPES
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.text import sheet_lines
from esicatalog.sii.view import sii_json


def sheet(data: bytes) -> list[str]:
    return [" ".join(line.split()) for line in sheet_lines(decode_sii(data))]


def test_the_sheet_says_what_the_image_says():
    lines = sheet(by_hand.WHOLE)
    for line in (
        "Statusword",
        "vendor 0x0000079a (1946)",
        "product 0xdeadbeef (3735928559)",
        "PDI control 0x0380 on-chip bus (Microchip LAN925x: SPI)",
        "ESC configuration device emulation, enhanced link detection",
        "SYNC pulse 1000 ns",
        "alias 1234",
        "word 5 0x001A",
        "size 2048 bytes",
        "Mailbox: CoE, FoE",
        "bootstrap 0x1000, 256 bytes 0x1100, 256 bytes",
        "standard 0x1000, 128 bytes 0x1080, 128 bytes",
        "4 Größe (cp1252)",
        "5 ä (utf-8)",
        "CoE SDO, PDO assign, complete access",
        "flags mailbox data link layer, ident AL status",
        "E-bus -2000 mA (feeds)",
        "ports MII, EBUS, MII, not used",
        "FMMU2 MBoxState",
        "SM0 MBoxOut 0x1000 128 0x26 mailbox output PDI interrupt 0x01: enable",
        "SM3 Inputs 0x1200 0 0x20 buffered input PDI interrupt 0x09: enable, OP only",
        "RxPDO 0x1600 Motor: SM2, 32 bits, flags default",
        "TxPDO 0x1A00 Statusword: SM3, 24 bits, flags mandatory, fixed content",
        "0.0 0x6041:00 16 bits UINT Statusword",
        "2.0 0x0000:00 8 bits 0x00 (gap)",
        "TxPDO 0x1A01 : not assigned, 0 bits, flags overwritten by module",
        "Antrieb 0x0700 SYNC0, SYNC1 1000000 ns 1 10000 ns -2 -1 ns Statusword",
        "Other: category 3 (device specific) at byte 0x80, 12 bytes",
        "0000 66 61 63 74 6f 72 79 20 64 61 74 61 factory data",
        "Other: category 43 (SyncUnit) at byte 0x108, 2 bytes",
    ):
        assert line in lines
    assert "Findings" not in lines
    assert any(line.endswith(", right") for line in lines if line.startswith("check sum"))


@pytest.mark.parametrize(
    ("code", "words"),
    [
        (0x01, "4 digital inputs"),
        (0x02, "4 digital outputs"),
        (0x03, "2 digital inputs, 2 outputs"),
        (0x06, "oversampling I/O"),
        (0x0C, "16/64 bit multiplexed asynchronous microcontroller"),
        (0x15, "SPI master"),
        (0x82, "SPI, direct mapped (Microchip LAN9255)"),
        (0x89, "16 bit host bus, multiplexed in 1 phase (Microchip LAN925x)"),
        (0x8A, "8 bit host bus, multiplexed in 2 phases (Microchip LAN925x)"),
        (0x8B, "16 bit host bus, multiplexed in 2 phases (Microchip LAN925x)"),
        (0x92, "8 bit host bus, multiplexed in 2 phases, direct mapped (Microchip LAN925x)"),
        (0x96, "8 bit host bus, demultiplexed, direct mapped (Microchip LAN9253)"),
        (0x97, "16 bit host bus, demultiplexed, direct mapped (Microchip LAN9253)"),
        (0x16, "unknown type"),
    ],
)
def test_the_type_of_the_pdi_in_words(code, words):
    """Register 0x0140, section II of the ESC data sheet; from 0x80 on the LAN9253 and LAN9255 of Microchip."""
    assert f"PDI control 0x03{code:02X} {words}" in sheet(bytes((code,)) + by_hand.WHOLE[1:])


def test_findings_come_last():
    lines = sheet(image((40, b"\1\2"), end=b""))
    assert lines[-2:] == ["Findings", "no end mark after the last category: the image ends at byte 0x86"]


def test_a_missing_string_is_told():
    assert "name (string 3 is missing)" in sheet(image((30, by_hand.GENERAL)))


def test_control_characters_stay_out_of_the_terminal():
    lines = sheet(image((10, b"\1\5\x1b[2J\n\0")))
    assert r"1 \x1b[2J\x0a" in lines


def test_long_data_are_cut_with_a_note():
    lines = sheet(image((2048, bytes(300))))
    assert "Other: category 2048 at byte 0x80, 300 bytes" in lines
    assert lines[-1] == "… 44 bytes more"


def test_unusual_bytes_after_the_end_mark_are_shown():
    assert "After the end mark: 3 bytes" in sheet(image(end=by_hand.END + b"abc"))


def test_one_of_a_thing_is_not_several():
    """A TxPDO 0x1A00 on SM0 with one entry of type BOOL (0x01) and 1 bit, as a digital input has it."""
    pdo = bytes.fromhex("001A 01 00 00 00 0000  0060 01 00 01 01 0000")
    lines = sheet(image((50, pdo), end=by_hand.END + b"a"))
    assert "TxPDO 0x1A00 : SM0, 1 bit, flags none" in lines
    assert "0.0 0x6000:01 1 bit BOOL" in lines
    assert "After the end mark: 1 byte" in lines


def test_json_has_numbers_words_and_texts():
    whole = json.loads(json.dumps(sii_json(decode_sii(by_hand.WHOLE))))
    header = whole["header"]
    assert (header["vendor_id"], header["mailbox_protocols"]) == (0x79A, 0x0C)
    assert header["mailbox_protocols_words"] == ["CoE", "FoE"]
    assert header["byte_size"] == 2048
    private, strings, general, *_, tx_pdos, rx_pdos, clocks = whole["categories"]
    assert (private["offset"], private["category_type"], private["data"]) == (128, 3, b"factory data".hex())
    assert strings["category"] == "STRINGS"
    assert strings["strings"][3] == {"data": "4772f6df65", "encoding": "cp1252", "text": "Größe"}
    assert (general["order_string_number"], general["order"]) == (1, "Motor")
    assert general["image"] is None
    entry = tx_pdos["pdos"][0]["entries"][0]
    assert (entry["entry_index"], entry["name"], entry["data_type"]) == (0x6041, "Statusword", "UINT")
    assert rx_pdos["pdos"][0]["flags_words"] == ["default"]
    assert [mode["sync0"] for mode in clocks["modes"]] == [False, True]
    assert (whole["end_mark"], whole["trailing"], whole["findings"]) == (True, "ff" * 6, [])


def test_a_check_sum_that_is_not_tested_is_not_wrong():
    """0x88A4 (ESC data sheet): the slave controller loads the words whatever their check sum."""
    untested = by_hand.WHOLE[:14] + b"\xa4\x88" + by_hand.WHOLE[16:]
    assert "check sum 0xA4, not tested" in sheet(untested)
    wrong = by_hand.WHOLE[:14] + bytes([by_hand.WHOLE[14] ^ 1, 0]) + by_hand.WHOLE[16:]
    assert any(line.startswith("check sum") and ", wrong, " in line for line in sheet(wrong))


def test_every_data_type_that_is_stored_has_its_name():
    """STRING and VISIBLE_STRING share a code (ETG.1020)."""
    for base in BASE_TYPES.values():
        assert DATA_TYPES[base.code] == ("VISIBLE_STRING" if base.name == "STRING" else base.name)
    assert set(DATA_TYPES) == {base.code for base in BASE_TYPES.values()}
