"""Identities and numbers as people write them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from esicatalog.errors import InputError
from esicatalog.identity import Identity, checked, parse_identity, parse_number, parse_object, parse_subindex

UINT32 = st.integers(0, 0xFFFF_FFFF)


@given(UINT32)
def test_a_number_is_the_same_in_every_notation(value):
    for text in (f"0x{value:x}", f"0X{value:X}", f"#x{value:08X}", f"{value}", f" {value} ", f"000{value}"):
        assert parse_number(text) == value


@pytest.mark.parametrize("text", ["0x1097", "#x1097", "4247"])
def test_the_notations_of_the_contract(text):
    assert parse_number(text) == 0x1097


@pytest.mark.parametrize(
    "text",
    ["", "x", "0x", "#x", "-1", "+1", "1.0", "1e3", "zz", "0x1g", "1 2", "٣", "0x100000000", "9" * 20, "9" * 9000],
)
def test_what_is_no_uint32(text):
    with pytest.raises(InputError) as error:
        parse_number(text)
    assert "\n" not in str(error.value)
    assert len(str(error.value)) < 200


VARIANT = st.none() | st.integers(1, 9)


@given(
    st.builds(Identity, UINT32, UINT32, st.none() | UINT32, VARIANT, st.just(False))
    | st.builds(Identity, UINT32, UINT32, st.none(), VARIANT, st.just(True))
)
def test_identities_come_back(identity):
    assert parse_identity(str(identity)) == identity


@pytest.mark.parametrize(
    "text", ["", "1", "1:2:3:4", "1:", ":2", "1:-", "-:2:3", "a:b", "1:2@", "1:2@0", "1:2@x", "1:2:3@-1"]
)
def test_what_is_no_identity(text):
    with pytest.raises(InputError):
        parse_identity(text)


@pytest.mark.parametrize(
    ("identity", "words"),
    [
        (Identity(-1, 2), "vendor -1 is no number from 0 to 0xffffffff"),
        (Identity(2**70, 2), "vendor 1180591620717411303424 is no number"),
        (Identity("0x1097", 2), "vendor '0x1097' is no number"),
        (Identity(1, None), "product None is no number"),
        (Identity(1, True), "product True is no number"),
        (Identity(1, 2, ""), "revision '' is no number"),
        (Identity(1, 2, 3, 0), "variants count from 1"),
        (Identity(1, 2, 3, "1"), "variant '1' is no number"),
        (Identity(1, 2, 3, None, True), "give one of both"),
    ],
)
def test_what_can_be_no_identity(identity, words):
    with pytest.raises(InputError, match=words):
        checked(identity)


def test_mapped_objects():
    assert parse_object("0x6040") == (0x6040, None)
    assert parse_object("#x6040:0") == (0x6040, 0)
    assert parse_object("24640:0x10") == (0x6040, 16)
    for text in ("", "0x6040:", ":1", "0x6040:10", "0x10000", "0x6040:256", "0x6040:1:2", "x"):
        with pytest.raises(InputError):
            parse_object(text)


@given(st.text())
def test_no_text_breaks_the_parsers(text):
    for parse in (parse_number, parse_identity, parse_object):
        try:
            parse(text)
        except InputError as error:
            assert "\n" not in str(error) or "\n" in text


@pytest.mark.parametrize(
    ("text", "subindex"),
    [
        ("0", 0),
        ("9", 9),
        ("09", 9),
        ("0x10", 16),
        ("#x10", 16),
        ("0A", 10),
        ("1f", 31),
        ("FF", 255),
        ("e0", 224),
        ("100", 100),
        ("255", 255),
    ],
)
def test_a_subindex_may_be_written_as_it_is_shown(text, subindex):
    assert parse_subindex(text) == subindex


@pytest.mark.parametrize(
    ("text", "words"), [("10", "0x10 if it is hexadecimal, 0x0A if decimal"), ("99", "0x63 if dec")]
)
def test_a_subindex_that_means_two_is_refused(text, words):
    with pytest.raises(InputError, match=words):
        parse_subindex(text)


@pytest.mark.parametrize("text", ["A", "0G", "g0", "0AA", "0x", "", "-1", "256"])
def test_what_is_no_subindex(text):
    with pytest.raises(InputError):
        parse_subindex(text)
