"""Text of terminals and logs, freed of what is not the master's: colours, line ends, time stamps, quoting marks."""

import codecs
import re
from collections.abc import Iterator
from typing import NamedTuple

from esicatalog.scan.records import ScanError, ScanFinding
from esicatalog.words import counted

NOT_READ = "has vendor id and product code 0: its SII was not read or is empty"
"""Of a slave whose identity is none (:func:`esicatalog.identity.is_read`)."""

OF_LISTS = r"SM[0-9a-f]+: PhysAddr|(?:SDO|Sdo) 0x"
"""How lines of ``ethercat pdos`` and ``ethercat sdos`` begin."""

_SHOWN = 60
_ESCAPES = re.compile(
    r"""\x1b(?:
        \[[0-?]{0,32}[ -/]{0,8}[@-~]             # CSI: colours
        | [ -/]{1,8}[0-~]                        # a character set: `tput sgr0` ends with ESC ( B
        | \][^\x07\x1b\n]{0,1024}(?:\x07|\x1b\\)  # OSC: titles, links
    )""",
    re.VERBOSE,
)
_LINE_END = re.compile(r"\r\n?")
_TIME = r"[0-9]{2}:[0-9]{2}:[0-9]{2}(?:[.,][0-9]{1,9})?"
_LOG_PREFIX = re.compile(
    rf"""^(?:
        (?:>|//|\#-?(?=[ \t]))[ \t]?                                   # quoted in a mail, commented in a script
        | \[[^\]\n]{{1,40}}\]:?[ \t]                                   # [  12.345678], [INFO]
        | (?:[0-9]{{4}}-[0-9]{{2}}-[0-9]{{2}}[ T])?{_TIME}(?:Z|[+-][0-9]{{2}}:?[0-9]{{2}})?:?[ \t]
        | [A-Z][a-z]{{2}}[ ]{{1,2}}[0-9]{{1,2}}[ ]{_TIME}[ ]           # syslog
        | [^\s:\[]{{1,64}}[ ][^\s:\[]{{1,64}}\[[0-9]{{1,10}}\]:[ ]     # host and process after such a time
    ){{1,4}}""",
    re.MULTILINE | re.VERBOSE,
)
HEADING = re.compile(r"\s*===\s*(?:Master\s+([0-9]{1,5}),\s*)?Slave\s+([0-9a-f]{1,5})\s*===\s*")


class Heading(NamedTuple):
    """``=== Master 0, Slave 3 ===``; releases before 1.5 print no master."""

    master: int | None
    position: int


def is_utf16(content: bytes) -> bool:
    """Whether bytes begin with the mark of UTF-16, in which the ``>`` of Windows PowerShell writes."""
    return content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))


def decode_text(content: bytes) -> str:
    """Text of UTF-8, or of UTF-16 with its mark; what is neither becomes replacement characters."""
    return content.decode("utf-16" if is_utf16(content) else "utf-8", "replace")


def clean(text: str) -> str:
    """The text with plain line ends and without colours and log prefixes. Raises :class:`ScanError` when empty."""
    cleaned = _LINE_END.sub("\n", _ESCAPES.sub("", text.removeprefix("\ufeff")))
    if not cleaned.strip():
        raise ScanError("the text is empty; expected what a master printed about its slaves")
    return _LOG_PREFIX.sub("", cleaned)


def numbered_lines(text: str) -> Iterator[tuple[int, str]]:
    """The lines of a cleaned text that are not blank, numbered from 1."""
    return ((number, line) for number, line in enumerate(text.split("\n"), 1) if line and not line.isspace())


def quoted(text: str) -> str:
    """A part of the text for a message: one line, bounded, printable."""
    stripped = text.strip()
    return ascii(stripped if len(stripped) <= _SHOWN else stripped[:_SHOWN] + "...")


def in_order(findings: list[ScanFinding]) -> tuple[ScanFinding, ...]:
    """The findings by line."""
    return tuple(sorted(findings, key=lambda finding: finding.line))


def is_broken_heading(line: str) -> bool:
    """Whether a line begins like a heading and is none: what stands below it is of another slave than what is above."""
    return line.lstrip().startswith("===") and heading_of(line) is None


def heading_of(line: str, base: int = 10) -> Heading | None:
    """The slave that a heading of the ``ethercat`` tool names, or None for other lines.

    ``base`` is that of its numbers; one with letters is hexadecimal all the same.
    """
    match = HEADING.fullmatch(line)
    return Heading(None if match[1] is None else int(match[1], base), tool_number(match[2], base)) if match else None


def tool_number(digits: str, base: int = 10) -> int:
    """A number that the ``ethercat`` tool means in decimal: it forgets to say so behind a number in hexadecimal."""
    return int(digits, base if digits.isdecimal() else 16)


def name_at_end(line: int, rest: str, findings: list[ScanFinding]) -> str | None:
    """The name of which ``rest`` is the text behind the opening quote; None for an empty one."""
    name = rest.rstrip()
    if not name.endswith('"'):
        findings.append(ScanFinding(line=line, message=f"the name is cut off: {quoted(name)}"))
    return name.removesuffix('"') or None


class Skipped:
    """Counts lines that are not read, so that a long log gives one finding."""

    def __init__(self) -> None:
        self._count = 0
        self._line = 0
        self._text = ""

    def add(self, line: int, text: str) -> None:
        """Count a line."""
        if not self._count:
            self._line, self._text = line, text
        self._count += 1

    def findings(self, what: str) -> list[ScanFinding]:
        """No finding, or one that names the first line; ``what`` is the format that was read."""
        if not self._count:
            return []
        message = f"{counted(self._count, 'line is', 'lines are')} not read as {what}; the first: {quoted(self._text)}"
        return [ScanFinding(line=self._line, message=message)]
