"""``ethercat sdos`` of the IgH EtherCAT master: the CoE object dictionary as the slave reports it.

Layouts: entries with access and bit length (1.5, 1.6), without access and with ``Sdo`` (1.4), without bit length
(forks), objects without entries (``--quiet``).
"""

import re

import msgspec

from esicatalog.scan.igh_blocks import BlockReader
from esicatalog.scan.records import ScannedDictionary, ScannedObject, ScannedObjectEntry, SdoScan
from esicatalog.scan.text import name_at_end

_OBJECT = re.compile(r'\s*SDO 0x([0-9a-f]{4}), "', re.IGNORECASE)
_ENTRY = re.compile(
    r"\s*0x([0-9a-f]{4}):([0-9a-f]{2}), (?:([r-][w-][r-][w-][r-][w-]), )?([a-z][a-z0-9_ ]{0,40})"
    r'(?:, ([0-9]{1,6}) bit)?, "',
    re.IGNORECASE,
)
_OF_LIST = re.compile(r"\s*(?:SDO 0x|0x[0-9a-f]{4}:[0-9a-f]{2},)", re.IGNORECASE)
"""How the lines of a list begin: one that is not taken is missing."""


class _Reader(BlockReader[ScannedObject, ScannedDictionary]):
    """Collects the parts from the inside out: entries, objects, slaves."""

    COMMAND = "ethercat sdos"
    EXAMPLE = 'SDO 0x1000, "Device type"'
    ITEMS = (_OBJECT, _ENTRY)

    def __init__(self) -> None:
        super().__init__()
        self._indices: set[int] = set()
        self._entries: list[ScannedObjectEntry] = []

    def _take(self, line: int, text: str) -> None:
        if match := _OBJECT.match(text):
            self._is_hexadecimal = True
            self._begin_object(line, int(match[1], 16), name_at_end(line, text[match.end() :], self._findings))
        elif (match := _ENTRY.match(text)) and self._parts and self._parts[-1].index == int(match[1], 16):
            self._is_hexadecimal = False
            self._entries.append(
                ScannedObjectEntry(
                    subindex=int(match[2], 16),
                    access=match[3],
                    data_type=match[4],
                    bit_length=int(match[5]) if match[5] else None,
                    name=name_at_end(line, text[match.end() :], self._findings),
                    line=line,
                )
            )
        elif _OF_LIST.match(text):
            self._break_off(line, text)
        else:
            self._skip(line, text)

    def _slave(self, master: int | None, position: int | None, parts: tuple[ScannedObject, ...]) -> ScannedDictionary:
        self._indices = set()
        return ScannedDictionary(
            master=master,
            position=position,
            objects=parts,
            line=parts[0].line,
            is_complete=self._is_complete,
        )

    def _begin_object(self, line: int, index: int, name: str | None) -> None:
        if index in self._indices:
            self._begin_unnamed(line, f"object 0x{index:04x} is")
        self._close_part()
        self._indices.add(index)
        self._parts.append(ScannedObject(index=index, name=name, line=line))

    def _close_part(self) -> None:
        if self._entries:
            self._parts[-1] = msgspec.structs.replace(self._parts[-1], entries=tuple(self._entries))
        self._entries = []


def read_sdos(text: str) -> SdoScan:
    """Read the output of ``ethercat sdos`` for one slave or several. Raises :class:`ScanError` when it is none."""
    slaves, findings = _Reader().read(text)
    return SdoScan(slaves=slaves, findings=findings)
