"""Vendors' texts inside C: nothing in them ends a comment, joins lines or hides what a compiler reads."""

import re
import unicodedata
from collections.abc import Iterable

_UNREADABLE = frozenset(("Cc", "Cf", "Zl", "Zp", "Co", "Cn"))
_MARKS = re.compile(r"\*(?=/)|/(?=\*)")
"""Ends and beginnings of comments; a space between their characters makes them harmless."""
_LINE_WIDTH = 116
_LABEL_WIDTH = 10
"""Where the text behind a label begins."""


def comment_text(text: str) -> str:
    """The text on one line, as it may stand in a comment ``/* … */``.

    Control and formatting characters (line ends, text direction) become blanks, ``*/`` and ``/*`` get a blank inside,
    and so does the trigraph of the backslash, which would join lines.
    """
    shown = "".join(" " if unicodedata.category(char) in _UNREADABLE else char for char in text)
    return _MARKS.sub(r"\g<0> ", shown).replace("??/", "? ?/")


def c_bytes(data: bytes) -> str:
    """The elements of an initializer for an array of bytes."""
    return ", ".join(f"0x{byte:02x}" for byte in data)


def wrapped(lines: Iterable[str]) -> list[str]:
    """The lines, each broken at blanks where it is longer than 116 characters; what is broken off is indented."""
    result = []
    for line in lines:
        rest, indent = line, _indent(line)
        while len(rest) > _LINE_WIDTH and " " in rest[len(indent) : _LINE_WIDTH].strip():
            at = rest.rindex(" ", 0, _LINE_WIDTH)
            result.append(rest[:at].rstrip())
            rest = indent + rest[at:].lstrip()
        result.append(rest)
    return result


def comment_lines(lines: Iterable[str]) -> list[str]:
    """The lines, wrapped, as they may stand in a comment."""
    return [comment_text(line) for line in wrapped(lines)]


def _indent(line: str) -> str:
    """Of what is broken off: below the text of a list item or behind a label."""
    if line.startswith("- "):
        return "  "
    label = line[:_LABEL_WIDTH]
    return " " * _LABEL_WIDTH if label.endswith(" ") and (":" in label or label.isspace()) else ""
