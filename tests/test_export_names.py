"""Names of entries: usable in C and Python, unique, independent of order, nothing of the vendor's escapes."""

import keyword
import re
import string

import pytest
from hypothesis import given
from hypothesis import strategies as st

from esicatalog.export.c_text import comment_text, wrapped
from esicatalog.export.names import checked_prefix, identifier, unique_names


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("Control word", "control_word"),
        ("ControlWord", "control_word"),
        ("  Status__Byte 1 ", "status_byte_1"),
        ("24V out", "n24v_out"),
        ("default", "default_"),
        ("linux", "linux_"),
        ("typeof", "typeof_"),
        ("typeof_unqual", "typeof_unqual_"),
        ("asm", "asm_"),
        ("constexpr", "constexpr_"),
        ("char8_t", "char8_t_"),
        ("uint8_t", "uint8_t_"),
        ("__auto_type", "auto_type"),
        ("Größe", "groesse"),
        ("µ-step", "u_step"),
        ("状态字", "fallback"),
        ("", "fallback"),
        (None, "fallback"),
        ("*/ system() /*", "system"),
    ],
)
def test_identifiers(text, name):
    assert identifier(text, "fallback") == name


@given(st.text())
def test_every_text_becomes_an_identifier(text):
    name = identifier(text, "x")
    assert re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name)
    assert not keyword.iskeyword(name)
    assert len(name) <= 50


def test_all_that_share_a_name_become_more_precise():
    assert unique_names([("output", "channel_1_output"), ("output", "channel_2_output"), ("status",)]) == [
        "channel_1_output",
        "channel_2_output",
        "status",
    ]


def test_what_stays_equal_is_numbered():
    assert unique_names([("value",), ("value",), ("value_1",)]) == ["value_2", "value_3", "value_1"]


def test_taken_names_are_avoided():
    assert unique_names([("bus",), ("bus", "bus_a")], ["bus"]) == ["bus_1", "bus_a"]


@given(st.lists(st.lists(st.sampled_from(["a", "b", "a_1", "a_2", "c"]), min_size=1, max_size=3), max_size=8))
def test_names_are_unique(candidates):
    names = unique_names(candidates)
    assert len(set(names)) == len(names) == len(candidates)


@given(st.text(alphabet=st.sampled_from([*"*/?\\ \n\r\t\0", "\u202e", "\u2028", "x"])))
def test_no_text_leaves_a_comment(text):
    shown = comment_text(text)
    assert "*/" not in shown
    assert "/*" not in shown
    assert "??/" not in shown
    assert all(char in string.printable and char not in "\n\r\t\x0b\x0c" for char in shown)


def test_readable_texts_stay_as_they_are():
    for text in ("Status word", "Größe 5 µm", "目标位置", "50 %, 24 V / 0.5 A"):
        assert comment_text(text) == text


def test_long_lines_are_broken_at_blanks():
    lines = wrapped(["- " + "word " * 40, "Label:    " + "text " * 40, "x" * 300])
    assert all(len(line) <= 116 or line == "x" * 300 for line in lines)
    assert lines[1].startswith("  word")
    assert any(line.startswith(" " * 10 + "text") for line in lines)


def test_a_prefix_of_the_users_own_is_taken_in_lower_case():
    """Capitals inside are no reason to refuse it: nothing is put between its words."""
    assert [checked_prefix(name) for name in ("leftArm", "X1_2y", "ARM")] == ["leftarm", "x1_2y", "arm"]
