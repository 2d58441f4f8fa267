"""Writing back what no record field holds, where its path says (see :mod:`esicatalog.esi.notes`)."""

import re
from collections.abc import Iterable

from lxml import etree

from esicatalog.esi.canonical import xml_text
from esicatalog.esi.notes import Unmapped

_FOLLOWING_TEXT = "following-text"
_NAME = r"(?:\{[^{}]*\})?[^\W\d][\w.\-]*"
_STEP = re.compile(rf"({_NAME})(?:\[(\d+)\])?")
_ATTRIBUTE = re.compile(rf"/@({_NAME})$")
_SPLIT = re.compile(r"/(?![^{]*\})")
"""Slashes between steps, not those within the braces of a namespace."""


def add_unmapped(owner: etree._Element, unmapped: Iterable[Unmapped]) -> None:
    """Give the written element of a device or module the values that its record holds by path only.

    Unknown elements come after the known ones, stray text at the start of its element or after one of its children;
    so values of different elements may be read again in another order. A path that is no path of XML names (an entity
    reference, a prefix never declared) cannot be written.
    """
    places = [(place, xml_text(item.value)) for item in unmapped if (place := _place(owner, item.path)) is not None]
    for (element, attribute, follows), value in places:
        if attribute:
            element.set(attribute, value)
        elif follows:
            element.tail = value
        else:
            _add_text(element, value)


def _place(owner: etree._Element, path: str) -> tuple[etree._Element, str, bool] | None:
    """Element and attribute that a path means, made where they are missing, and whether text that follows is meant."""
    attribute = _ATTRIBUTE.search(path)
    steps = _SPLIT.split(path[: attribute.start()] if attribute else path)
    follows = steps[-1] == _FOLLOWING_TEXT
    element = owner
    for step in filter(None, steps[:-1] if follows else steps):
        match = _STEP.fullmatch(step)
        if match is None:
            return None
        element = _child(element, match[1], match[2])
    return element, attribute[1] if attribute else "", follows


def _child(parent: etree._Element, tag: str, position: str | None) -> etree._Element:
    """The child with this tag; a position tells that there are several."""
    wanted = int(position or 0)
    found = list(parent.iterchildren(tag))
    while len(found) <= wanted or (position is not None and len(found) < 2):
        made = parent.makeelement(tag)
        if found:
            found[-1].addnext(made)
        else:
            parent.append(made)
        found.append(made)
    return found[wanted]


def _add_text(element: etree._Element, text: str) -> None:
    if not element.text:
        element.text = text
        return
    free = next((child for child in element if not child.tail), None)
    if free is not None:
        free.tail = text
