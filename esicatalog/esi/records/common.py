"""Pieces that occur in many places: texts with a language, properties, images."""

from typing import Annotated

from esicatalog.esi.binding import Record, Xml
from esicatalog.esi.numbers import INTEGER

ENGLISH = 1033
"""LcId of en-US, the language of a NameType without the attribute (EtherCATBase.xsd)."""


class Name(Record):
    """NameType: a text in one language. ``lcid`` is the Windows locale id, None where the document gives none."""

    text: Annotated[str, Xml(".", doc="Text in this language")] = ""
    lcid: Annotated[int | None, Xml("@LcId", INTEGER, "Windows locale id, e.g. 1033 English, 1031 German")] = None


class Property(Record):
    """Property of a data type, sub-item or object; vendors keep labels and options here."""

    name: Annotated[str | None, Xml("Name", doc="Name of the property")] = None
    value: Annotated[str | None, Xml("Value", doc="Value of the property")] = None
    descriptions: Annotated[tuple[Name, ...], Xml("Desc", doc="Descriptions in all languages")] = ()


def display_text(names: tuple[Name, ...], lcid: int = ENGLISH) -> str | None:
    """The text to show: the asked language, else English, else the one without (or with zero) LcId, else the first."""
    if len(names) <= 1:
        return names[0].text if names else None
    for wanted in (lcid, ENGLISH, None, 0):
        for name in names:
            if name.lcid == wanted and name.text:
                return name.text
    return next((name.text for name in names if name.text), names[0].text)
