"""``slaveinfo`` of SOEM 1.3, 1.4 and 2: one block a slave, the first line of which is ``Slave:1``.

The three print the same lines; they differ in the greeting (``ec_init``, ``ecx_init``) and in what ``-sdo`` and
``-map`` print behind a block, which is passed over. Numbers of slaves count from 1; addresses and identities are hex
without prefix.

Two zeros say nothing: that of the E-bus current stands also where the SII is silent, and that of a process data size
also where the slave did not get as far as SAFEOP, for which the sizes are set.
"""

import re
from collections.abc import Callable
from typing import Any

from esicatalog.identity import is_read
from esicatalog.scan.buses import separate_buses
from esicatalog.scan.records import Scan, ScanFinding, ScannedCoe, ScannedPort, ScannedSlave, ScannedSyncManager
from esicatalog.scan.text import NOT_READ, Skipped, in_order, numbered_lines, quoted
from esicatalog.words import counted

FORMAT = "SOEM slaveinfo"

GREETING_OR_SLAVE = re.compile(
    r"^[ \t]*(?:SOEM \(Simple Open EtherCAT Master\)|Slave:[ \t]*[1-9][0-9]{0,4}[ \t]*$)", re.M
)

_Facts = dict[str, Any]

_SLAVE = re.compile(r"\s*Slave:\s*([1-9][0-9]{0,4})\s*")
_INTERFACE = re.compile(r"\s*ecx?_init on (\S.{0,200}) succeeded\.\s*")
_ANNOUNCED = re.compile(r"\s*([0-9]{1,5}) slaves found and configured\.\s*")
_STATUS = re.compile(r"\s*Slave ([0-9]{1,5}) State=\s*[0-9a-f]{1,2} StatusCode=\s*([0-9a-f]{1,4})\b.*", re.IGNORECASE)
_SYNC_MANAGER = re.compile(r"\s*SM([0-9]) A:([0-9a-f]{4}) L:\s*([0-9]{1,5}) F:([0-9a-f]{8}) Type:[0-9]\s*")
_UNUSED = re.compile(r"\s*(?:FMMU[0-9]|FMMUfunc|DCParentport:).*")
_GREETING = re.compile(
    r"\s*(?:SOEM \(Simple Open|Slaveinfo|Starting slaveinfo|End |Calculated workcounter|Not all|No slaves found).*"
)
_OPEN_ENDED = re.compile(r"\s*(?:Slave|State):\s*[0-9]+\s*")
"""Lines that still read well when their last digit is missing."""
_NO_NAME = re.compile(r"\? M:[0-9a-f]{8} I:[0-9a-f]{8}")
_LAST_KEY = "only LRD/LWR"

_STATES = {1: "INIT", 2: "PREOP", 3: "BOOT", 4: "SAFEOP", 8: "OP"}
_PROTOCOL_BITS = ((1, "AoE"), (2, "EoE"), (4, "CoE"), (8, "FoE"), (0x10, "SoE"), (0x20, "VoE"))
"""Word 0x1C of the SII."""
_COE_BITS = ("sdo", "sdo_info", "pdo_assign", "pdo_configuration", "upload_at_startup", "complete_access")
"""Byte 7 of the SII category General, from bit 0."""
_SIZES = ("output_bits", "input_bits")
_STATES_WITH_SIZES = ("SAFEOP", "OP")


def _name(match: re.Match[str]) -> _Facts:
    name = match[0].strip()
    return {"name": None if _NO_NAME.fullmatch(name) else name or None}


def _state(match: re.Match[str]) -> _Facts:
    status = int(match[1])
    return {"state": _STATES.get(status & 0xF), "state_error": bool(status & 0x10)}


def _ports(match: re.Match[str]) -> _Facts:
    links = match[1].split(".")
    return {"ports": tuple(ScannedPort(number=number, link_up=link == "1") for number, link in enumerate(links))}


def _identity(match: re.Match[str]) -> _Facts:
    return dict(
        zip(("vendor_id", "product_code", "revision_no"), (int(word, 16) for word in match.groups()), strict=True)
    )


def _mailbox(match: re.Match[str]) -> _Facts:
    bits = int(match[3], 16)
    return {
        "mailbox_out_bytes": int(match[1]),
        "mailbox_in_bytes": int(match[2]),
        "mailbox_protocols": tuple(name for bit, name in _PROTOCOL_BITS if bits & bit),
    }


def _coe(match: re.Match[str]) -> _Facts:
    bits = int(match[1], 16)
    return {"coe": ScannedCoe(**{name: bool(bits >> bit & 1) for bit, name in enumerate(_COE_BITS)})}


def _integer(field: str) -> Callable[[re.Match[str]], _Facts]:
    return lambda match: {field: int(match[1])}


def _current(match: re.Match[str]) -> _Facts:
    return {"e_bus_current_ma": int(match[1]) or None}


def _truth(field: str) -> Callable[[re.Match[str]], _Facts]:
    return lambda match: {field: match[1] != "0"}


def _pattern(text: str) -> re.Pattern[str]:
    return re.compile(rf"\s*{text}\s*", re.IGNORECASE)


_KEYS: dict[str, tuple[re.Pattern[str], Callable[[re.Match[str]], _Facts]]] = {
    "Name": (_pattern(".*"), _name),
    "Output size": (_pattern("([0-9]{1,6})bits"), _integer("output_bits")),
    "Input size": (_pattern("([0-9]{1,6})bits"), _integer("input_bits")),
    "State": (_pattern("([0-9]{1,3})"), _state),
    "Delay": (_pattern(r"(-?[0-9]{1,10})\[ns\]"), _integer("dc_delay_ns")),
    "Has DC": (_pattern("([01])"), _truth("dc_capable")),
    "Activeports": (_pattern(r"([01](?:\.[01]){3})"), _ports),
    "Configured address": (_pattern("([0-9a-f]{4})"), lambda match: {"configured_address": int(match[1], 16)}),
    "Man": (_pattern("([0-9a-f]{8}) ID: ([0-9a-f]{8}) Rev: ([0-9a-f]{8})"), _identity),
    "MBX length wr": (_pattern("([0-9]{1,5}) rd: ([0-9]{1,5}) MBX protocols : ([0-9a-f]{2})"), _mailbox),
    "CoE details": (_pattern("([0-9a-f]{2}) FoE details: .*"), _coe),
    "Ebus current": (_pattern(r"(-?[0-9]{1,6})\[mA\]"), _current),
    _LAST_KEY: (_pattern("([0-9]{1,3})"), _truth("not_lrw")),
}
_BETWEEN_ITEMS = re.compile(
    rf"(?<=\S)(?=\s+(?:(?:{'|'.join(map(re.escape, _KEYS))}|FMMUfunc|DCParentport):|SM[0-9] A:|FMMU[0-9] Ls:))"
)
"""Where lines were joined, as forums and mail programs do. Names are not quoted: one that holds such words is cut
there, and what follows is told as not understood."""


class _Block:
    """What one block says."""

    def __init__(self, line: int, number: int, interface: str | None, al_status_code: int | None) -> None:
        self.line, self.number = line, number
        self.facts: _Facts = {"interface": interface, "al_status_code": al_status_code}
        self.sync_managers: list[ScannedSyncManager] = []
        self.open = True

    def slave(self) -> ScannedSlave:
        if "CoE" not in self.facts.get("mailbox_protocols", ()):
            self.facts.pop("coe", None)
        if self.facts.get("state") not in _STATES_WITH_SIZES:
            self.facts |= {size: self.facts.get(size) or None for size in _SIZES}
        return ScannedSlave(
            line=self.line,
            position=self.number - 1,
            sync_managers=tuple(self.sync_managers),
            **self.facts,
        )

    def findings(self) -> list[ScanFinding]:
        if self.facts.get("product_code") is None:
            message = f"slave {self.number} has no line `Man: ID: Rev:`; kept without identity"
        elif not is_read(self.facts["vendor_id"], self.facts["product_code"]):
            message = f"slave {self.number} {NOT_READ}"
        else:
            return []
        return [ScanFinding(line=self.line, message=message)]


class _Run:
    """One run of the program: what it says before its slaves."""

    def __init__(self) -> None:
        self.interface: str | None = None
        self.status_codes: dict[int, int] = {}
        self.announced: tuple[int, int] | None = None
        self.listed = 0

    def findings(self) -> list[ScanFinding]:
        if self.announced is None or self.announced[1] == self.listed:
            return []
        line, count = self.announced
        announced = counted(count, "slave is", "slaves are")
        message = f"{announced} announced, {counted(self.listed, 'is', 'are')} listed"
        return [ScanFinding(line=line, message=message)]


class _Reader:
    """Takes the lines of a text into runs and blocks."""

    def __init__(self) -> None:
        self.blocks: list[_Block] = []
        self.runs = [_Run()]
        self.findings: list[ScanFinding] = []
        self.skipped = Skipped()

    def take(self, number: int, line: str, unfinished: bool) -> None:
        """Read one line; ``unfinished``: no line end follows it."""
        block = self.blocks[-1] if self.blocks else None
        if unfinished and _OPEN_ENDED.fullmatch(line):
            self.findings.append(ScanFinding(line=number, message=f"may be cut off, not read: {quoted(line)}"))
        elif match := _SLAVE.fullmatch(line):
            self._begin(number, int(match[1]))
        elif match := _INTERFACE.fullmatch(line):
            self.runs.append(_Run())
            self.runs[-1].interface = match[1]
        elif match := _ANNOUNCED.fullmatch(line):
            self.runs[-1].announced = number, int(match[1])
        elif match := _STATUS.fullmatch(line):
            self.runs[-1].status_codes[int(match[1])] = int(match[2], 16)
        elif block is not None and block.open and self._taken(block, number, line):
            return
        elif not _UNUSED.fullmatch(line) and not _GREETING.fullmatch(line):
            self.skipped.add(number, line)

    def _begin(self, line: int, number: int) -> None:
        run = self.runs[-1]
        run.listed += 1
        self.blocks.append(_Block(line, number, run.interface, run.status_codes.get(number)))

    def _taken(self, block: _Block, number: int, line: str) -> bool:
        if match := _SYNC_MANAGER.fullmatch(line):
            flags = int(match[4], 16)
            block.sync_managers.append(
                ScannedSyncManager(
                    number=int(match[1]),
                    start_address=int(match[2], 16),
                    size_bytes=int(match[3]),
                    control=flags & 0xFF,
                    enable=flags >> 16 & 0xFF,
                    line=number,
                )
            )
            return True
        key, _, value = line.partition(":")
        key = key.strip()
        if key not in _KEYS:
            return False
        pattern, facts = _KEYS[key]
        if match := pattern.fullmatch(value):
            block.facts.update(facts(match))
        else:
            self.findings.append(ScanFinding(line=number, message=f"not understood or cut off: {quoted(line)}"))
        block.open = key != _LAST_KEY
        return True


def read_soem(text: str) -> Scan:
    """Read the cleaned text of SOEM's ``slaveinfo``, of one run or several. A bus without slaves gives none."""
    reader = _Reader()
    unfinished_line = text.count("\n") + 1
    for number, line in numbered_lines(text):
        *items, last = _BETWEEN_ITEMS.split(line)
        for item in items:
            reader.take(number, item, False)
        reader.take(number, last, number == unfinished_line)
    findings = reader.findings
    for block in reader.blocks:
        findings += block.findings()
    for run in reader.runs:
        findings += run.findings()
    if not reader.blocks:
        findings.append(ScanFinding(line=1, message="slaveinfo lists no slave"))
    slaves, bus_findings = separate_buses([block.slave() for block in reader.blocks])
    findings += bus_findings + reader.skipped.findings(f"part of a slave in {FORMAT}")
    return Scan(format=FORMAT, slaves=slaves, findings=in_order(findings))
