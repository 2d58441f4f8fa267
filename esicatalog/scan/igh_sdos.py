"""``ethercat sdos`` of the IgH EtherCAT master: the CoE object dictionary as the slave reports it.

Layouts: entries with access and bit length (1.5, 1.6), without access and with ``Sdo`` (1.4), without bit length
(forks), objects without entries (``--quiet``). A heading names the slave only when the tool prints several.
"""

import re

import msgspec

from esicatalog.scan.records import (
    ScanError,
    ScanFinding,
    ScannedDictionary,
    ScannedObject,
    ScannedObjectEntry,
    SdoScan,
)
from esicatalog.scan.text import Heading, Skipped, clean, heading_of, in_order, name_at_end, numbered_lines

_OBJECT = re.compile(r'\s*SDO 0x([0-9a-f]{4}), "(.*)', re.IGNORECASE)
_ENTRY = re.compile(
    r"\s*0x([0-9a-f]{4}):([0-9a-f]{2}), (?:([r-][w-][r-][w-][r-][w-]), )?([a-z][a-z0-9_ ]{0,40})"
    r'(?:, ([0-9]{1,6}) bit)?, "(.*)',
    re.IGNORECASE,
)


class _Reader:
    """Collects the parts from the inside out: entries, objects, slaves."""

    def __init__(self) -> None:
        self.slaves: list[ScannedDictionary] = []
        self.findings: list[ScanFinding] = []
        self.skipped = Skipped()
        self._heading: Heading | None = None
        self._objects: list[ScannedObject] = []
        self._indices: set[int] = set()
        self._entries: list[ScannedObjectEntry] = []

    def take(self, line: int, text: str) -> None:
        """Read one line of the text."""
        if heading := heading_of(text):
            self.close_slave()
            self._heading = heading
        elif match := _OBJECT.fullmatch(text):
            self._begin_object(line, match)
        elif (match := _ENTRY.fullmatch(text)) and self._objects and self._objects[-1].index == int(match[1], 16):
            self._entries.append(
                ScannedObjectEntry(
                    subindex=int(match[2], 16),
                    access=match[3],
                    data_type=match[4],
                    bit_length=int(match[5]) if match[5] else None,
                    name=name_at_end(line, match[6], self.findings),
                    line=line,
                )
            )
        else:
            self.skipped.add(line, text)
            if not self._objects:  # the heading belongs to another command's output
                self._heading = None

    def close_slave(self) -> None:
        """End the slave that was read last; a slave without objects is none."""
        self._close_object()
        if self._objects:
            master, position = self._heading or (None, None)
            objects = tuple(self._objects)
            self.slaves.append(
                ScannedDictionary(master=master, position=position, objects=objects, line=objects[0].line)
            )
        self._objects, self._indices, self._heading = [], set(), None

    def _begin_object(self, line: int, match: re.Match[str]) -> None:
        index = int(match[1], 16)
        if index in self._indices:
            self.close_slave()
            message = f"object 0x{index:04x} is listed again without a heading; read as another slave"
            self.findings.append(ScanFinding(line=line, message=message))
        self._close_object()
        self._indices.add(index)
        name = name_at_end(line, match[2], self.findings)
        self._objects.append(ScannedObject(index=index, name=name, line=line))

    def _close_object(self) -> None:
        if self._entries:
            self._objects[-1] = msgspec.structs.replace(self._objects[-1], entries=tuple(self._entries))
        self._entries = []


def read_sdos(text: str) -> SdoScan:
    """Read the output of ``ethercat sdos`` for one slave or several. Raises :class:`ScanError` when it is none."""
    reader = _Reader()
    for line, content in numbered_lines(clean(text)):
        reader.take(line, content)
    reader.close_slave()
    if not reader.slaves:
        raise ScanError('no output of `ethercat sdos`; expected lines such as `SDO 0x1000, "Device type"`')
    findings = reader.findings + reader.skipped.findings("`ethercat sdos`")
    return SdoScan(slaves=tuple(reader.slaves), findings=in_order(findings))
