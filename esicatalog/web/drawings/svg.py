"""SVG as text: escaped elements, and an estimate of how much text fits where."""

import re
import textwrap
import unicodedata
from collections.abc import Iterable, Sequence
from html import escape

from esicatalog.web.bidi import isolated
from esicatalog.words import one_line

WIDTH = 400
"""Width of every drawing in its own units, about the pixels of a phone: text keeps a readable size there."""
TEXT_SIZE = 11
SMALL_TEXT_SIZE = 10
"""Font sizes in units of the drawing; the style sheet sets the same."""

_NOT_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_LONGEST_NAME = 80
_LONGEST_SENTENCE = 400
_LONGEST_WORD = 36
_ROOM_FOR_BOLD = 24
_WIDEST_LATIN, _WIDE, _COMMON, _NARROW = 1.0, 0.76, 0.64, 0.4
_LINE = 14


def escaped(value: object) -> str:
    """Any text as content or attribute value: markup has no effect, what XML forbids is replaced.

    Right-to-left names leave the numbers beside them in their place.
    """
    return escape(_NOT_IN_XML.sub("\ufffd", isolated(value)))


def element(name: str, *children: str, **attributes: object) -> str:
    """An element; children are markup, attribute values are text. ``class_`` is class, ``text_anchor`` text-anchor."""
    written = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{_attribute(value)}"'
        for key, value in attributes.items()
        if value is not None
    )
    return f"<{name}{written}>{''.join(children)}</{name}>" if children else f"<{name}{written}/>"


def _attribute(value: object) -> str:
    return number(value) if isinstance(value, float) else escaped(value)


def number(value: float) -> str:
    """A coordinate, to a hundredth."""
    return f"{round(value, 2):g}" if abs(value) < 10_000 else f"{value:.0f}"


def drawing(kind: str, label: str, height: float, *children: str) -> str:
    """A whole drawing: an image with an accessible name that scales with the page."""
    return element(
        "svg",
        *children,
        xmlns="http://www.w3.org/2000/svg",
        class_=f"drawing {kind}",
        role="img",
        aria_label=label,
        viewBox=f"0 0 {WIDTH} {number(height)}",
    )


def text(x: float, y: float, content: str, class_: str | None = None) -> str:
    """A line of text with its base line at ``y``."""
    return element("text", escaped(content), x=float(x), y=float(y), class_=class_)


def title(*lines: str) -> str:
    """What a pointer over the enclosing group shows."""
    return element("title", escaped("\n".join(lines)))


def rectangle(x: float, y: float, width: float, height: float, class_: str | None = None) -> str:
    """A rectangle."""
    return element("rect", x=float(x), y=float(y), width=float(width), height=float(height), class_=class_)


def paragraphs(y: float, sentences: Iterable[str], class_: str = "words") -> tuple[list[str], float]:
    """Sentences below each other, broken into lines; the second value is where they end."""
    lines = [line for sentence in sentences for line in _wrapped(clipped(sentence, _LONGEST_SENTENCE))]
    return [text(4, y + _LINE * at + TEXT_SIZE, line, class_) for at, line in enumerate(lines)], y + _LINE * len(lines)


def _wrapped(sentence: str) -> list[str]:
    lines = [""]
    # A word that is wider than the drawing is broken.
    for word in (part for whole in sentence.split() for part in textwrap.wrap(whole, _LONGEST_WORD)):
        longer = f"{lines[-1]} {word}".lstrip()
        if text_width(longer, SMALL_TEXT_SIZE) <= WIDTH - _ROOM_FOR_BOLD:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def clipped(content: str, longest: int = _LONGEST_NAME) -> str:
    """A vendor's text on one line, cut where it is longer than anybody reads."""
    plain = one_line(content)
    return plain if len(plain) <= longest else f"{plain[: longest - 1]}…"


def first_that_fits(choices: Iterable[Sequence[str]], width: float, height: float, line: float) -> Sequence[str]:
    """The first of several labels, each some lines of text, that fits into a box; none when none does."""
    for lines in choices:
        if lines and line * len(lines) <= height and all(text_width(words) <= width for words in lines):
            return lines
    return ()


def text_width(content: str, size: float = TEXT_SIZE) -> float:
    """Width of a text in units of the drawing, estimated on the safe side of the usual sans-serif fonts."""
    return size * sum(map(_character_width, content))


def _character_width(character: str) -> float:
    if _is_wide(character) or character in "mwMW@%—…":
        return _WIDEST_LATIN
    if character in " .,:;'|!ijlItf()[]/-":
        return _NARROW
    return _WIDE if character.isupper() else _COMMON


def _is_wide(character: str) -> bool:
    return unicodedata.east_asian_width(character) in "WF"
