"""Files with SII images: raw or Intel HEX, by content."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sii import by_hand

import esicatalog
from esicatalog.errors import DocumentError, EsiCatalogError
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.files import image_of_file
from esicatalog.sii.image import ranges_text

END = ":00000001FF\n"


def hex_line(kind: int, address: int, payload: bytes = b"") -> str:
    record = bytes([len(payload), address >> 8, address & 0xFF, kind]) + payload
    return f":{record.hex().upper()}{-sum(record) & 0xFF:02X}\n"


def hex_file(data: bytes, step: int = 16) -> str:
    return "".join(hex_line(0, at, data[at : at + step]) for at in range(0, len(data), step)) + END


def test_raw_bytes_are_the_image():
    assert image_of_file(by_hand.WHOLE).data == by_hand.WHOLE
    assert image_of_file(b"").data == b""


def test_a_line_written_by_hand():
    assert image_of_file(b":0300300002337A1E\n:00000001FF\n").data[0x30:] == b"\x02\x33\x7a"


def test_intel_hex_is_recognised_by_its_content():
    text = hex_file(by_hand.WHOLE)
    for data in (text, text.replace("\n", "\r\n"), text.lower(), f"\n  {text}\n\n", "\ufeff" + text):
        assert image_of_file(data.encode()).data == by_hand.WHOLE


def test_the_order_of_lines_does_not_matter_and_gaps_are_erased():
    text = hex_line(0, 6, b"CD") + hex_line(0, 0, b"AB") + hex_line(0, 9, b"E") + END
    assert image_of_file(text.encode()) == (b"AB\xff\xff\xff\xffCD\xffE", ((2, 5), (8, 8)))


def without_lines(data: bytes, *addresses: int) -> bytes:
    """Intel HEX of 16 bytes a line that lacks some."""
    lines = (hex_line(0, at, data[at : at + 16]) for at in range(0, len(data), 16) if at not in addresses)
    return ("".join(lines) + END).encode()


def test_what_an_intel_hex_file_leaves_out_is_told():
    image = esicatalog.read_sii(without_lines(by_hand.WHOLE, 0x40, 0x50, 0x90))
    assert image.unread == ((0x40, 0x5F), (0x90, 0x9F))
    assert image.findings[0] == (
        "the file does not hold the bytes 0x40 to 0x5F, 0x90 to 0x9F: 0xFF stands in their place"
    )
    assert esicatalog.read_sii(by_hand.WHOLE).unread == ()
    # The length of the first category is not there.
    text = hex_line(0, 0, by_hand.WHOLE[:0x82]) + hex_line(0, 0x84, by_hand.WHOLE[0x84:0x90]) + END
    with pytest.raises(SiiImageError, match=r"runs past the end of the image: .*does not hold the bytes 0x82 to 0x83$"):
        esicatalog.read_sii(text.encode())


def test_of_many_bytes_that_are_left_out_some_are_named():
    text = "".join(hex_line(0, at, b"A") for at in range(1, 21, 2)) + END
    assert ranges_text(image_of_file(text.encode()).unread).endswith("0xE and 2 further ranges")


def test_start_addresses_say_nothing_about_the_image():
    text = hex_line(3, 0, bytes(4)) + hex_line(5, 0, bytes(4)) + hex_line(0, 0, b"AB") + END
    assert image_of_file(text.encode()).data == b"AB"


def test_segment_and_linear_addresses_move_the_data():
    segment = hex_line(2, 0, b"\x00\x10") + hex_line(0, 1, b"A") + END
    assert image_of_file(segment.encode()).data == b"\xff" * 0x101 + b"A"
    linear = hex_line(4, 0, b"\x00\x01") + hex_line(0, 2, b"A") + END
    assert image_of_file(linear.encode()).data == b"\xff" * 0x10002 + b"A"


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        (":0300300002337A1F\n" + END, 1, "check sum is 0x1F, not 0x1E"),
        ("\n" + hex_line(0, 0, b"A") + ":02000000AA54\n" + END, 3, "1 data byte where 2 are announced"),
        (":00\n" + END, 1, "pairs of hex digits"),
        (":0300300002337A1\n", 1, "pairs of hex digits"),
        (":hello\n", 1, "pairs of hex digits"),
        (hex_line(0, 0, b"A") + "B\n", 2, "pairs of hex digits"),
        (hex_line(6, 0), 1, "no record type 06 with 0 data bytes"),
        (hex_line(4, 0, b"\x01"), 1, "no record type 04 with 1 data byte"),
        (hex_line(1, 0, b"\x01"), 1, "no record type 01 with 1 data byte"),
        (END + hex_line(0, 0, b"A"), 2, "after the end record"),
        (hex_line(0, 0, b"AB") + hex_line(0, 1, b"B") + END, 2, "0x1 are given twice"),
        (hex_line(4, 0, b"\x08\x00") + hex_line(0, 0, b"A") + END, 2, "address 0x8000000 is beyond"),
        (hex_line(4, 0, b"\xff\xff") + hex_line(0, 0xFFFF, b"A") + END, 2, "address 0xFFFFFFFF is beyond"),
    ],
)
def test_a_broken_line_is_named(text, line, words):
    with pytest.raises(SiiImageError, match=f"^Intel HEX line {line}: ") as caught:
        image_of_file(text.encode())
    assert caught.value.line == line
    assert words in str(caught.value)


def test_a_file_without_end_record_is_cut():
    with pytest.raises(SiiImageError, match="no end record"):
        image_of_file(hex_line(0, 0, b"A").encode())


@given(st.binary(min_size=1, max_size=300), st.integers(1, 255))
def test_intel_hex_gives_its_bytes_back(data, step):
    assert image_of_file(hex_file(data, step).encode()).data == data


@given(st.binary(max_size=200) | st.text(":0123456789ABCDEF\n", max_size=200).map(str.encode))
def test_anything_gives_bytes_or_one_line(data):
    for start in (b"", b":", b":0300300002337A1E\n"):
        try:
            image_of_file(start + data)
        except EsiCatalogError as error:
            assert "\n" not in str(error)


def test_read_sii_takes_the_bytes_of_a_file_in_either_form():
    raw = esicatalog.read_sii(by_hand.WHOLE)
    assert isinstance(raw, esicatalog.SiiImage)
    assert raw.header.vendor_id == int.from_bytes(by_hand.WHOLE[16:20], "little")
    assert esicatalog.read_sii(hex_file(by_hand.WHOLE).encode()) == raw
    broken = bytes([by_hand.WHOLE[0] ^ 1]) + by_hand.WHOLE[1:]
    assert any("check sum at byte 0xE" in finding for finding in esicatalog.read_sii(broken).findings)
    with pytest.raises(DocumentError, match="its length in bytes is 1;"):
        esicatalog.read_sii(b"\0")
