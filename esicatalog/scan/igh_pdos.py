"""``ethercat pdos`` of the IgH EtherCAT master: SyncManagers, assigned PDOs, mapped entries.

Releases before 1.5 write ``RxPdo`` and ``Pdo entry``.
"""

import re

import msgspec

from esicatalog.scan.igh_blocks import BlockReader
from esicatalog.scan.records import (
    PdoScan,
    ScannedPdo,
    ScannedPdoEntry,
    ScannedPdos,
    ScannedSyncManager,
)
from esicatalog.scan.text import name_at_end, tool_number

_SYNC_MANAGER = re.compile(
    r"\s*SM([0-9a-f]{1,2}): PhysAddr 0x([0-9a-f]{1,4}), DefaultSize\s+([0-9]{1,5}), "
    r"ControlRegister 0x([0-9a-f]{1,2}), Enable ([0-9]{1,3})\s*",
    re.IGNORECASE,
)
_PDO = re.compile(r'\s*([RT])xPDO 0x([0-9a-f]{1,4}) "', re.IGNORECASE)
_ENTRY = re.compile(r'\s*PDO entry 0x([0-9a-f]{1,4}):([0-9a-f]{2}),\s+([0-9]{1,3}) bit, "', re.IGNORECASE)
_OF_LIST = re.compile(r"\s*SM[0-9a-f]{1,2}\b|.*(?:PhysAddr|xPDO|PDO entry)\b", re.IGNORECASE)
"""Parts of the lines of a list: one that is not taken is missing."""


class _Reader(BlockReader[ScannedSyncManager, ScannedPdos]):
    """Collects the parts from the inside out: entries, PDOs, SyncManagers, slaves."""

    COMMAND = "ethercat pdos"
    EXAMPLE = "SM2: PhysAddr 0x1100, DefaultSize 2, ..."
    ITEMS = (_SYNC_MANAGER, _PDO, _ENTRY)

    def __init__(self) -> None:
        super().__init__()
        self._pdos: list[ScannedPdo] = []
        self._entries: list[ScannedPdoEntry] = []
        self._is_open = False
        """Whether PDOs belong to the SyncManager that was read last."""

    def _take(self, line: int, text: str) -> None:
        if match := _SYNC_MANAGER.fullmatch(text):
            self._is_hexadecimal = False
            self._begin_sync_manager(line, match)
        elif self._is_open and (match := _PDO.match(text)):
            self._is_hexadecimal = True
            self._close_pdo()
            name = name_at_end(line, text[match.end() :], self._findings)
            is_rx = match[1].upper() == "R"
            self._pdos.append(ScannedPdo(index=int(match[2], 16), is_rx=is_rx, name=name, line=line))
        elif self._pdos and (match := _ENTRY.match(text)):
            self._is_hexadecimal = False
            self._entries.append(
                ScannedPdoEntry(
                    index=int(match[1], 16),
                    subindex=int(match[2], 16),
                    bit_length=int(match[3]),
                    name=name_at_end(line, text[match.end() :], self._findings),
                    line=line,
                )
            )
        elif _OF_LIST.match(text):
            self._break_off(line, text)
        else:
            self._skip(line, text)

    def _slave(self, master: int | None, position: int | None, parts: tuple[ScannedSyncManager, ...]) -> ScannedPdos:
        return ScannedPdos(
            master=master,
            position=position,
            sync_managers=parts,
            line=parts[0].line,
            is_complete=self._is_complete,
        )

    def _break_off(self, line: int, text: str) -> None:
        """Take nothing into the open SyncManager any more: a line of it was not understood, or it was itself."""
        self._close_part()
        self._is_open = False
        super()._break_off(line, text)

    def _close_slave(self) -> None:
        super()._close_slave()
        self._is_open = False

    def _begin_sync_manager(self, line: int, match: re.Match[str]) -> None:
        number = tool_number(match[1])
        if self._parts and number <= self._parts[-1].number:
            self._begin_unnamed(line, "SyncManagers are")
        self._close_part()
        self._is_open = True
        self._parts.append(
            ScannedSyncManager(
                number=number,
                start_address=int(match[2], 16),
                size_bytes=int(match[3]),
                control=int(match[4], 16),
                enable=int(match[5]),
                line=line,
            )
        )

    def _close_part(self) -> None:
        self._close_pdo()
        if self._pdos:
            self._parts[-1] = msgspec.structs.replace(self._parts[-1], pdos=tuple(self._pdos))
        self._pdos = []

    def _close_pdo(self) -> None:
        if self._entries:
            self._pdos[-1] = msgspec.structs.replace(self._pdos[-1], entries=tuple(self._entries))
        self._entries = []


def read_pdos(text: str) -> PdoScan:
    """Read the output of ``ethercat pdos`` for one slave or several. Raises :class:`ScanError` when it is none."""
    slaves, findings = _Reader().read(text)
    return PdoScan(slaves=slaves, findings=findings)
