"""Scalars of ESI documents: HexDecValue, identity numbers, booleans, hexBinary (ESI-FACTS section 1.1)."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from esicatalog.esi.numbers import (
    BOOL,
    DEC,
    DEC8,
    DEC16,
    DEC64,
    FLOAT,
    HEX,
    HEX8,
    HEX16,
    HEX_BINARY,
    IDENTITY,
    IMAGE,
    INT,
    INTEGER,
    SWITCH,
    SWITCH8,
    TEXT,
    decode_hex_binary,
    parse_hex_dec,
    parse_real,
)

SCALARS = [
    HEX,
    HEX8,
    HEX16,
    DEC,
    DEC8,
    DEC16,
    DEC64,
    SWITCH,
    SWITCH8,
    IDENTITY,
    INT,
    INTEGER,
    BOOL,
    FLOAT,
    HEX_BINARY,
    IMAGE,
    TEXT,
]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("402", 402),
        ("#x1A00", 0x1A00),
        ("#x1a00", 0x1A00),
        ("#x00001a00", 0x1A00),
        ("#x0000000000000000000000001A00", 0x1A00),
        ("000402", 402),
        ("+402", 402),
        ("-402", -402),
        ("  #x1A00\n", 0x1A00),
        ("0", 0),
        ("#x0", 0),
    ],
)
def test_hex_dec_value_of_the_schema(text, value):
    parsed = HEX.read(text)
    assert parsed.value == value
    assert parsed.remark is None


@pytest.mark.parametrize("kind", [HEX, HEX8, HEX16])
@pytest.mark.parametrize("value", [-4096, -1, 0, 1, 255])
def test_numbers_of_records_made_by_hand_are_spelled_as_they_are_read(kind, value):
    """HexDecValue has a sign before decimal digits only."""
    assert kind.read(kind.spell(value))[:2] == (value, None)


@pytest.mark.parametrize("text", ["0x1a00", "0X1A00", "#x0x1A00", "#x0x6041", "#X1000"])
def test_foreign_prefixes_are_read_with_a_remark(text):
    parsed = HEX.read(text)
    assert parsed.value == int(text.lower().rsplit("x", 1)[1], 16)
    assert parsed.raw == text
    assert parsed.remark.rule == "L06"


@pytest.mark.parametrize("text", ["", "#x", "0x", "abc", "#xZZ", "1.5", "-#x10", "#x-10", "1 2", "#x1|2", "٣"])
def test_what_is_no_hex_dec_value_is_kept_as_text(text):
    parsed = HEX.read(text)
    assert parsed.value is None
    assert parsed.raw == text
    assert parsed.remark.rule == "L06"


@pytest.mark.parametrize("text", ["#x1010533004", "#x100000000", "4294967296", "-1"])
def test_identity_numbers_are_uint32(text):
    parsed = IDENTITY.read(text)
    assert parsed.value is None
    assert parsed.raw == text
    assert parsed.remark is not None


def test_the_largest_identity_number():
    assert IDENTITY.read("#xFFFFFFFF") == (0xFFFF_FFFF, None, None)
    assert IDENTITY.read("4294967295").value == 0xFFFF_FFFF


@pytest.mark.parametrize("scalar", [HEX, DEC, INT, INTEGER])
def test_numbers_of_64_bits_are_kept_as_text(scalar):
    assert scalar.read("9223372036854775807").value == 2**63 - 1
    for text in ("9223372036854775808", "-9223372036854775809", "9" * 40, "9" * 5000):
        assert scalar.read(text).value is None
        assert scalar.read(text).raw == text


@pytest.mark.parametrize("text", ["#xFFFFFFFFFFFFFFFF", "18446744073709551615", "-9223372036854775808"])
def test_values_of_64_bits_are_kept_as_text_without_remark(text):
    """ULINT goes to 2**64 - 1, LINT from -2**63."""
    assert DEC64.read(text) == (None, text, None)
    assert DEC64.read("9223372036854775807").value == 2**63 - 1


@pytest.mark.parametrize(
    "text", ["#x10000000000000000", "18446744073709551616", "-9223372036854775809", "0xFFFFFFFFFFFFFFFF", "#xG"]
)
def test_what_64_bits_do_not_hold_and_what_is_no_number_has_a_remark(text):
    assert DEC64.read(text)[:2] == (None, text)
    assert DEC64.read(text).remark.rule == "L06"


@pytest.mark.parametrize(("text", "value"), [("1", True), ("true", True), ("0", False), ("false", False)])
def test_booleans(text, value):
    assert BOOL.read(text).value is value
    assert BOOL.read(f" {text} ").remark is None


@pytest.mark.parametrize(("text", "value"), [("True", True), ("TRUE", True), ("False", False), ("fALSE", False)])
def test_booleans_in_capitals_are_read_with_a_remark(text, value):
    parsed = BOOL.read(f" {text} ")
    assert (parsed.value, parsed.raw) == (value, text)
    assert parsed.remark.rule == "L03"


@pytest.mark.parametrize("text", ["", "yes", "2"])
def test_what_is_no_boolean(text):
    assert BOOL.read(text).value is None
    assert BOOL.read(text).raw == text


def test_integers_may_be_hexadecimal_with_a_remark():
    assert INT.read("-2000") == (-2000, None, None)
    assert INT.read("#x10").value == 16
    assert INT.read("#x10").remark.rule == "L06"


@pytest.mark.parametrize("text", ["5000000000", "2147483648", "-2147483649"])
def test_an_int_has_32_bits(text):
    assert INT.read(text)[:2] == (int(text), None)
    assert INT.read(text).remark.rule == "L06"
    assert INTEGER.read(text) == (int(text), None, None)


@pytest.mark.parametrize("scalar", [HEX16, DEC16])
@pytest.mark.parametrize(("text", "value"), [("#x10000", 65536), ("65536", 65536), ("0x11000", 69632), ("-1", -1)])
def test_what_does_not_fit_into_16_bits_is_kept_with_a_remark(scalar, text, value):
    parsed = scalar.read(text)
    assert parsed.value == value
    assert parsed.remark == ("L06", "E", f"{text!r} does not fit into 16 bits; read as {value}")


@pytest.mark.parametrize("scalar", [HEX8, DEC8])
@pytest.mark.parametrize(("text", "value"), [("#x164", 356), ("256", 256)])
def test_what_does_not_fit_into_8_bits_is_kept_with_a_remark(scalar, text, value):
    parsed = scalar.read(text)
    assert parsed.value == value
    assert parsed.remark == ("L06", "E", f"{text!r} does not fit into 8 bits; read as {value}")


def test_the_largest_numbers_of_8_and_16_bits():
    assert HEX16.read("#xFFFF") == (0xFFFF, None, None)
    assert DEC16.read("65535") == (0xFFFF, None, None)
    assert HEX8.read("#x00FF") == (0xFF, None, None)
    assert DEC8.read("255") == (0xFF, None, None)


def test_the_largest_ints():
    for text in ("2147483647", "-2147483648"):
        assert INT.read(text) == (int(text), None, None)


@pytest.mark.parametrize(("text", "value"), [("10", 10.0), (" -1.5 ", -1.5), (".5", 0.5), ("2.", 2.0), ("1E3", 1000.0)])
def test_texts_that_are_real_numbers(text, value):
    assert parse_real(text) == value


@pytest.mark.parametrize("text", ["", "ten", "1,5", "1_0", "nan", "INF", "1e999", "#x10", "٣"])
def test_texts_that_are_no_real_numbers(text):
    assert parse_real(text) is None


def test_a_long_text_of_digits_that_is_no_number_takes_no_time():
    """It would take hours if the pattern had two ways to share the digits."""
    assert parse_real("1" * 1_000_000 + "x") is None
    assert parse_real("0." + "1" * 1_000_000) == pytest.approx(1 / 9)


@pytest.mark.parametrize("text", ["123", "0g", "80 01", "#x80"])
def test_malformed_hex_binary_is_kept_and_told(text):
    parsed = HEX_BINARY.read(text)
    assert parsed.value == text
    assert parsed.remark.rule == "L07"
    assert decode_hex_binary(text) is None


def test_hex_binary_is_bytes_in_wire_order():
    assert HEX_BINARY.read(" 80010aF0 ").value == "80010aF0"
    assert decode_hex_binary("80010aF0") == bytes([0x80, 0x01, 0x0A, 0xF0])
    assert decode_hex_binary("") is None, "an empty element is no default, not zero"


def test_image_bytes_may_be_broken_over_lines():
    assert IMAGE.read("424d\n  0a0B ").value == "424D0A0B"
    assert IMAGE.read("424d0").value == "424d0"
    assert IMAGE.read("424d0").remark.rule == "L07"


@pytest.mark.parametrize("text", ["INF", "-INF", "NaN", "1e999"])
def test_floats_that_are_not_finite(text):
    assert FLOAT.read(text) == (None, text, ("L03", "W", f"{text!r} is not a finite number; kept as text"))


@pytest.mark.parametrize("text", ["nan", "inf", "infinity", "1,5", "1_000.5", "1_0", "١.٥", "0x10"])
def test_what_is_no_float(text):
    """XML Schema knows ASCII digits, no separators between them, and one spelling of each special value."""
    assert FLOAT.read(text) == (None, text, ("L03", "W", f"{text!r} is not a number; kept as text"))


@pytest.mark.parametrize("scalar", [HEX, HEX16, DEC8, DEC64, IDENTITY, INT, INTEGER, SWITCH, SWITCH8, BOOL, FLOAT])
def test_an_empty_text_counts_as_absent(scalar):
    for text in ("", " \n"):
        value, raw, remark = scalar.read(text)
        assert (value, raw) == (None, "")
        assert remark.message.endswith("; an empty text counts as absent")


@pytest.mark.parametrize(
    ("text", "value"), [("20.4", 20.4), (" -1.5 ", -1.5), (".5", 0.5), ("2.", 2.0), ("+1E3", 1000.0)]
)
def test_floats(text, value):
    assert FLOAT.read(text)[::2] == (value, None)


@given(st.integers(-(2**63) + 1, 2**63 - 1))
def test_decimal_numbers_come_back(value):
    for scalar in (DEC, DEC64, INTEGER):
        assert scalar.read(scalar.spell(value)) == (value, None, None)
    assert INT.read(INT.spell(value))[:2] == (value, None)


@given(st.integers(0, 2**63 - 1))
def test_hexadecimal_numbers_come_back(value):
    assert HEX.read(HEX.spell(value)) == (value, None, None)
    for spelling in (f"#x{value:x}", f"#x{value:X}", f"#x{value:020x}", f"{value}", f"+{value}", f"0x{value:x}"):
        assert HEX.read(spelling).value == value


@given(st.integers(0, 0xFFFF_FFFF))
def test_identity_numbers_come_back(value):
    assert IDENTITY.read(IDENTITY.spell(value)) == (value, None, None)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_floats_come_back(value):
    assert FLOAT.read(FLOAT.spell(value))[:2] == (value, None)


@given(st.binary())
def test_hex_binary_comes_back(data):
    assert decode_hex_binary(HEX_BINARY.read(data.hex()).value) == (data or None)


@given(st.text())
def test_no_text_breaks_a_scalar_and_every_text_is_kept(text):
    for scalar in SCALARS:
        parsed = scalar.read(text)
        if scalar is IMAGE:
            continue
        shown = parsed.raw if parsed.raw is not None else scalar.spell(parsed.value)
        assert shown == text.strip()
    parse_hex_dec(text)


@pytest.mark.parametrize("scalar", [SWITCH, SWITCH8])
@pytest.mark.parametrize(("text", "value"), [("true", 1), ("False", 0), ("1", 1), ("#x09", 9), ("on", None)])
def test_a_switch_may_be_written_as_a_boolean(text, value, scalar):
    """Enable of a SyncManager and Default of a ModuleIdent are HexDecValues; what true means there is clear."""
    parsed = scalar.read(text)
    assert parsed.value == value
    assert (parsed.remark is None) == text.endswith(("1", "9"))
