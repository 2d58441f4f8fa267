"""What the ``ethercat`` tool prints slave by slave: what reading ``ethercat pdos`` and ``ethercat sdos`` has in common.

A heading names the slave only when the tool prints several. The tool does not set the base of the numbers in it: behind
the hexadecimal index of a PDO or object without entries they are hexadecimal too (``Slave 10`` is slave 16), until an
entry or SyncManager is printed.

Forums and mail programs join lines. Names may hold quotes, so a line goes on behind a quote only where a whole item
follows; where no more than its first words do, the line is not understood.
"""

import re
from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import ClassVar, Generic, TypeVar

import msgspec

from esicatalog.scan.records import ScanError, ScanFinding, ScannedDictionary, ScannedPdos, findings_by_line
from esicatalog.scan.text import (
    HEADING,
    OF_LISTS,
    Heading,
    Skipped,
    clean,
    heading_of,
    in_order,
    is_broken_heading,
    numbered_lines,
    quoted,
)

_OTHER_COMMAND = re.compile(rf"\s*(?:(?:Alias|Device|State|Flag|Identity):|{OF_LISTS})|.*\bethercat [a-z]")
"""Lines of ``ethercat slaves -v``, of lists, and those that start the tool."""

_SEEMS_JOINED = re.compile(
    r'"\s*(?:SM[0-9a-f]{1,2}:|[RT]xPDO 0x|PDO entry 0x|SDO 0x|0x[0-9a-f]{4}:[0-9a-f]{2},|===)', re.IGNORECASE
)
"""A quote and how items of these lists begin."""

Part = TypeVar("Part")
Slave = TypeVar("Slave", bound=ScannedPdos | ScannedDictionary)


class BlockReader(ABC, Generic[Part, Slave]):
    """Collects the parts of slaves (SyncManagers, objects) from the inside out."""

    COMMAND: ClassVar[str]
    EXAMPLE: ClassVar[str]
    """A line of its output."""
    ITEMS: ClassVar[tuple[re.Pattern[str], ...]]
    """What its lines begin with, up to the quote that opens a name."""

    def __init__(self) -> None:
        self._slaves: list[Slave] = []
        self._starts: list[int] = []
        """Lines in which the slaves begin: with their heading."""
        self._start = self._line = 1
        self._findings: list[ScanFinding] = []
        self._skipped = Skipped()
        self._heading: Heading | None = None
        self._doubt: str | None = None
        """Why the heading names no slave for sure."""
        self._last: Heading | None = None
        self._parts: list[Part] = []
        self._is_hexadecimal = False
        """Whether the tool goes on in hexadecimal behind the line that was read last."""
        self._is_complete = True
        """Whether every line of the open slave that is of the list was understood."""

    def read(self, text: str) -> tuple[tuple[Slave, ...], tuple[ScanFinding, ...]]:
        """The slaves of a text and what was found in it. Raises :class:`ScanError` when it has none."""
        for line, content in numbered_lines(clean(text)):
            self._line = line
            for item in self._items(content):
                self._read_item(line, item)
        self._close_slave()
        if not self._slaves:
            raise ScanError(f"no output of `{self.COMMAND}`; expected lines such as `{self.EXAMPLE}`")
        findings = in_order(self._findings + self._skipped.findings(f"`{self.COMMAND}`"))
        by_slave = zip(self._slaves, findings_by_line(self._starts, findings), strict=True)
        return tuple(msgspec.structs.replace(slave, findings=own) for slave, own in by_slave), findings

    def _items(self, text: str) -> Iterator[str]:
        """The items of a line, more than one where lines were joined."""
        start = 0
        for quote in re.finditer('"', text):
            end = quote.end()
            if any(item.match(text, end) for item in (*self.ITEMS, HEADING)):
                yield text[start:end]
                start = end
        yield text[start:]

    def _read_item(self, line: int, text: str) -> None:
        if heading := heading_of(text):
            self._close_slave()
            self._heading = self._last = self._meant(line, text, heading)
        elif is_broken_heading(text):
            self._close_slave()
            self._doubt = f"line {line}: {quoted(text)} is no heading, though it begins like one; correct it"
        elif _SEEMS_JOINED.search(text, text.find('"') + 1):
            self._break_off(line, text)
        else:
            self._take(line, text)

    def _meant(self, line: int, text: str, heading: Heading) -> Heading:
        """The slave that a heading means: a run of the tool names slaves in rising order."""
        hexadecimal = heading_of(text, 16)
        if hexadecimal is None or hexadecimal == heading or not self._is_hexadecimal:
            return heading
        if self._last is None or _place(heading) > _place(self._last):
            self._doubt = (
                f"line {line}: {quoted(text)} is of slave {heading.position}, or of {hexadecimal.position} if it is of "
                "the same run as what stands before it; give the list of one slave as POSITION=FILE"
            )
            return heading
        words = f"{quoted(text)} is of slave {hexadecimal.position}: the tool goes on in hexadecimal behind an index"
        self._findings.append(ScanFinding(line=line, message=words))
        return hexadecimal

    @abstractmethod
    def _take(self, line: int, text: str) -> None:
        """Read one line, or skip it."""

    @abstractmethod
    def _close_part(self) -> None:
        """Give the part that was read last what belongs into it."""

    @abstractmethod
    def _slave(self, master: int | None, position: int | None, parts: tuple[Part, ...]) -> Slave:
        """The slave of these parts."""

    def _break_off(self, line: int, text: str) -> None:
        """Take a line of the list that was not understood, or whose place is not known, for one that is missing."""
        if self._is_complete:
            message = f"not understood, so the list is not complete and not compared: {quoted(text)}"
            self._findings.append(ScanFinding(line=line, message=message))
            self._is_complete = False
        else:
            self._skip(line, text)

    def _skip(self, line: int, text: str) -> None:
        self._skipped.add(line, text)
        if _OTHER_COMMAND.match(text):
            self._is_hexadecimal = False
            if not self._parts:
                self._close_slave()

    def _close_slave(self) -> None:
        """End the slave that was read last; a slave without parts is none."""
        self._close_part()
        if self._parts:
            if self._doubt is not None:
                raise ScanError(self._doubt)
            master, position = self._heading or (None, None)
            self._slaves.append(self._slave(master, position, tuple(self._parts)))
            self._starts.append(self._start)
        self._start = self._line
        self._parts, self._heading, self._doubt, self._is_complete = [], None, None, True

    def _begin_unnamed(self, line: int, what: str) -> None:
        """End the slave that was read last because ``what`` comes again."""
        self._close_slave()
        message = f"{what} listed again without a heading; read as another slave"
        self._findings.append(ScanFinding(line=line, message=message))


def _place(heading: Heading) -> tuple[int, int]:
    return heading.master or 0, heading.position
