"""Whatever a record of any type says is read again from its element."""

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lxml import etree

from esicatalog.esi.binding import PRESENT, RAW, Field, Record, fields_of, read_record
from esicatalog.esi.documents import make_parser
from esicatalog.esi.notes import Notes
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
    MAX_STORED,
    PHYSICS,
    SWITCH,
    SWITCH8,
    TEXT,
)
from esicatalog.esi.records.document import DiagInfo, DictInfo, EsiInfo
from esicatalog.esi.write import record_element
from esicatalog.esi.write_xml import document_bytes

xml_texts = st.text(
    st.characters(exclude_categories=("Cc", "Cs"), include_characters="\t\n\r", exclude_characters="\ufffe\uffff"),
    max_size=6,
).map(str.strip)
integers = st.integers(-MAX_STORED, MAX_STORED)
hex_bytes = st.binary(max_size=3).map(bytes.hex)
VALUES: dict[Any, st.SearchStrategy[Any]] = {
    TEXT: xml_texts,
    PHYSICS: st.text("YKH ", max_size=4).map(str.rstrip),
    INT: integers,
    INTEGER: integers,
    DEC: integers,
    DEC8: integers,
    DEC16: integers,
    DEC64: integers,
    SWITCH: integers,
    SWITCH8: integers,
    HEX: st.integers(0, MAX_STORED),
    HEX8: st.integers(0, MAX_STORED),
    HEX16: st.integers(0, MAX_STORED),
    IDENTITY: st.integers(0, 2**32 - 1),
    BOOL: st.booleans(),
    FLOAT: st.floats(allow_nan=False, allow_infinity=False),
    HEX_BINARY: hex_bytes,
    IMAGE: hex_bytes.map(str.upper),
    PRESENT: st.just(True),
}
OTHER_SPELLINGS: dict[Any, Callable[[Any], str]] = {
    **dict.fromkeys((HEX, HEX8, HEX16, IDENTITY), str),
    **dict.fromkeys(
        (DEC, DEC8, DEC16, DEC64, SWITCH, SWITCH8), lambda value: f"#x{value:X}" if value >= 0 else f"-0{-value}"
    ),
    INT: lambda value: f"{value:+03d}" if value >= 0 else f"-0{-value}",
    INTEGER: lambda value: f"{value:+03d}" if value >= 0 else f"-0{-value}",
    BOOL: lambda value: "true" if value else "false",
}
"""Another text than the canonical one for the same value."""
MOST_DEPTH = 2
MOST_FIELDS = 8


def raw_xml(field: Field) -> st.SearchStrategy[str]:
    tag = field.xml.path.rpartition("/")[2]
    contents = st.sampled_from(["<a></a>", 'text <b c="1">x</b> tail', "<a> </a><b><c></c></b>", "&lt;&amp;"])
    return contents.map(lambda content: f"<{tag}>{content}</{tag}>")


@st.composite
def spelled(draw: st.DrawFn, field: Field) -> tuple[Any, str | None]:
    """A value with the text that it is spelled with, None for the canonical one."""
    value = draw(VALUES[field.xml.kind])
    other = OTHER_SPELLINGS.get(field.xml.kind)
    return value, (other(value) if other is not None and draw(st.booleans()) else None)


def always(field: Field) -> bool:
    """Fields that a reader sets whatever is in the element, or whenever another one below the same path is set."""
    return field.xml.path == "." or field.xml.kind is PRESENT


@st.composite
def records(draw: st.DrawFn, record_type: type[Record], depth: int = 0) -> Record:
    """A record as a reader could have made it: an element that has an attribute has a text."""
    values: dict[str, Any] = {}
    spelling: dict[str, str] = {}
    fields = fields_of(record_type)
    texts = {field.xml.path: field.name for field in fields if "@" not in field.xml.path}
    chosen = draw(st.sets(st.sampled_from([field.name for field in fields]), max_size=MOST_FIELDS))
    for field in fields:
        path, _, attribute = field.xml.path.partition("@")
        needs_text = attribute and path in texts and texts[path] not in values
        if needs_text or not (always(field) or field.name in chosen):
            continue
        if isinstance(field.item, type) and issubclass(field.item, Record):
            if depth < MOST_DEPTH:
                inner = records(field.item, depth + 1)
                values[field.name] = tuple(draw(st.lists(inner, max_size=2))) if field.many else draw(inner)
        elif field.xml.kind is RAW:
            values[field.name] = draw(raw_xml(field))
        elif field.many:
            items = draw(st.lists(spelled(field), max_size=2))
            values[field.name] = tuple(value for value, _ in items)
            spelling |= {f"{field.name}.{at}": text for at, (_, text) in enumerate(items) if text is not None}
        else:
            values[field.name], text = draw(spelled(field))
            if text is not None:
                spelling[field.name] = text
    return record_type(**values, spelling=spelling or None)


def all_types(record_type: type[Record], found: dict[str, type[Record]]) -> dict[str, type[Record]]:
    if record_type.__name__ not in found:
        found[record_type.__name__] = record_type
        for field in fields_of(record_type):
            if isinstance(field.item, type) and issubclass(field.item, Record):
                all_types(field.item, found)
    return found


TYPES = all_types(EsiInfo, all_types(DictInfo, all_types(DiagInfo, {})))


@pytest.mark.parametrize("name", sorted(TYPES))
def test_an_element_gives_its_record_back(name):
    record_type = TYPES[name]

    @settings(max_examples=15, deadline=None)
    @given(records(record_type))
    def check(record: Record) -> None:
        notes = Notes()
        text = document_bytes(record_element(record, "Any"))
        assert read_record(record_type, etree.fromstring(text, make_parser()), notes) == record
        assert notes.unmapped == []

    check()


def test_all_types_are_covered():
    assert {"Device", "Module", "Object", "InfoSubItem", "DiagMessage", "SharedPdo", "SlotSelection"} <= TYPES.keys()
