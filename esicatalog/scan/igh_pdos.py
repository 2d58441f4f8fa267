"""``ethercat pdos`` of the IgH EtherCAT master: SyncManagers, assigned PDOs, mapped entries.

A heading names the slave only when the tool prints several. Releases before 1.5 write ``RxPdo`` and ``Pdo entry``.
"""

import re

import msgspec

from esicatalog.scan.records import (
    PdoScan,
    ScanError,
    ScanFinding,
    ScannedPdo,
    ScannedPdoEntry,
    ScannedPdos,
    ScannedSyncManager,
)
from esicatalog.scan.text import Heading, Skipped, clean, heading_of, in_order, name_at_end, numbered_lines

_SYNC_MANAGER = re.compile(
    r"\s*SM([0-9]{1,2}): PhysAddr 0x([0-9a-f]{1,4}), DefaultSize\s+([0-9]{1,5}), "
    r"ControlRegister 0x([0-9a-f]{1,2}), Enable ([0-9]{1,3})\s*",
    re.IGNORECASE,
)
_PDO = re.compile(r'\s*([RT])xPDO 0x([0-9a-f]{1,4}) "(.*)', re.IGNORECASE)
_ENTRY = re.compile(r'\s*PDO entry 0x([0-9a-f]{1,4}):([0-9a-f]{2}),\s+([0-9]{1,3}) bit, "(.*)', re.IGNORECASE)


class _Reader:
    """Collects the parts from the inside out: entries, PDOs, SyncManagers, slaves."""

    def __init__(self) -> None:
        self.slaves: list[ScannedPdos] = []
        self.findings: list[ScanFinding] = []
        self.skipped = Skipped()
        self._heading: Heading | None = None
        self._sync_managers: list[ScannedSyncManager] = []
        self._pdos: list[ScannedPdo] = []
        self._entries: list[ScannedPdoEntry] = []

    def take(self, line: int, text: str) -> None:
        """Read one line of the text."""
        if heading := heading_of(text):
            self.close_slave()
            self._heading = heading
        elif match := _SYNC_MANAGER.fullmatch(text):
            self._begin_sync_manager(line, match)
        elif self._sync_managers and (match := _PDO.fullmatch(text)):
            self._close_pdo()
            name = name_at_end(line, match[3], self.findings)
            is_rx = match[1].upper() == "R"
            self._pdos.append(ScannedPdo(index=int(match[2], 16), is_rx=is_rx, name=name, line=line))
        elif self._pdos and (match := _ENTRY.fullmatch(text)):
            self._entries.append(
                ScannedPdoEntry(
                    index=int(match[1], 16),
                    subindex=int(match[2], 16),
                    bit_length=int(match[3]),
                    name=name_at_end(line, match[4], self.findings),
                    line=line,
                )
            )
        else:
            self.skipped.add(line, text)
            if not self._sync_managers:  # the heading belongs to another command's output
                self._heading = None

    def close_slave(self) -> None:
        """End the slave that was read last; a slave without SyncManagers is none."""
        self._close_sync_manager()
        if self._sync_managers:
            master, position = self._heading or (None, None)
            managers = tuple(self._sync_managers)
            self.slaves.append(
                ScannedPdos(master=master, position=position, sync_managers=managers, line=managers[0].line)
            )
        self._sync_managers, self._heading = [], None

    def _begin_sync_manager(self, line: int, match: re.Match[str]) -> None:
        number = int(match[1])
        if self._sync_managers and number <= self._sync_managers[-1].number:
            self.close_slave()
            message = "SyncManagers are listed again without a heading; read as another slave"
            self.findings.append(ScanFinding(line=line, message=message))
        self._close_sync_manager()
        self._sync_managers.append(
            ScannedSyncManager(
                number=number,
                start_address=int(match[2], 16),
                size_bytes=int(match[3]),
                control=int(match[4], 16),
                enable=int(match[5]),
                line=line,
            )
        )

    def _close_sync_manager(self) -> None:
        self._close_pdo()
        if self._pdos:
            self._sync_managers[-1] = msgspec.structs.replace(self._sync_managers[-1], pdos=tuple(self._pdos))
        self._pdos = []

    def _close_pdo(self) -> None:
        if self._entries:
            self._pdos[-1] = msgspec.structs.replace(self._pdos[-1], entries=tuple(self._entries))
        self._entries = []


def read_pdos(text: str) -> PdoScan:
    """Read the output of ``ethercat pdos`` for one slave or several. Raises :class:`ScanError` when it is none."""
    reader = _Reader()
    for line, content in numbered_lines(clean(text)):
        reader.take(line, content)
    reader.close_slave()
    if not reader.slaves:
        raise ScanError(
            "no output of `ethercat pdos`; expected lines such as `SM2: PhysAddr 0x1100, DefaultSize 2, ...`"
        )
    findings = reader.findings + reader.skipped.findings("`ethercat pdos`")
    return PdoScan(slaves=tuple(reader.slaves), findings=in_order(findings))
