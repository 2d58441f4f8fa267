"""``ethercat slaves -v`` of the IgH EtherCAT master: one block of ``key: value`` lines a slave.

Layouts, by the sources of the tool: headings ``=== Slave 0 ===`` and plain mailboxes (1.4); headings with the master,
bootstrap and standard mailboxes, DL information with distributed clocks and the port table (1.5, 1.6); forks that
print the identity without a heading ``Identity:``. All are read by key, whatever their order and indent.

Forums and mail programs join lines, so another item may follow in a line. Names are not quoted: words in them that look
like an item are one only where the tool prints that item next and no line of the slave begins with its key.
"""

import re
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from esicatalog.identity import is_read
from esicatalog.scan.buses import separate_buses
from esicatalog.scan.records import Scan, ScanError, ScanFinding, ScannedCoe, ScannedPort, ScannedSlave
from esicatalog.scan.text import (
    NOT_READ,
    OF_LISTS,
    Skipped,
    heading_of,
    in_order,
    is_broken_heading,
    numbered_lines,
    quoted,
)
from esicatalog.words import one_line

FORMAT = "ethercat slaves -v"

HEADING_OF_SLAVE = re.compile(
    r"^[ \t]*===[ \t]*(?:Master[ \t]+[0-9]+,[ \t]*)?Slave[ \t]+[0-9]+[ \t]*===(?:\s+|\Z)(?!\s|SM[0-9]|SDO |Sdo |===)",
    re.MULTILINE,
)
"""Such a heading, unless it is one of ``ethercat pdos`` or ``ethercat sdos``."""

_Facts = dict[str, Any]
_Read = Callable[[str], _Facts | None]

_HEX = re.compile(r"0x([0-9a-f]{1,8})", re.IGNORECASE)
_DECIMAL = re.compile(r"[0-9]{1,5}")
_MAILBOXES = re.compile(r"0x[0-9a-f]{1,8}/([0-9]{1,5}), TX: 0x[0-9a-f]{1,8}/([0-9]{1,5})", re.IGNORECASE)
_CURRENT = re.compile(r"(-?[0-9]{1,5}) mA")
_DELAY = re.compile(r"([0-9]{1,10}) ns")
_PORT = re.compile(r"\s*([0-3])[* ]\s*(EBUS|MII|N/A|N/C|\?\?\?)\s+(up|down)\s+(?:open|closed|bypass)\s.*")
_PORT_TITLES = re.compile(r"\s*Port\s+Type\s")
_OTHER_COMMAND = re.compile(rf"\s*(?:{OF_LISTS})")

_STATES = ("INIT", "PREOP", "BOOT", "SAFEOP", "OP")
_PROTOCOLS = ("AoE", "EoE", "CoE", "FoE", "SoE", "VoE")
_CLOCKS: dict[str, _Facts] = {
    "no": {"dc_capable": False, "dc_system_time": False},
    "yes, delay measurement only": {"dc_capable": True, "dc_system_time": False},
    "yes, 32 bit": {"dc_capable": True, "dc_system_time": True, "dc_system_time_bits": 32},
    "yes, 64 bit": {"dc_capable": True, "dc_system_time": True, "dc_system_time_bits": 64},
    "yes, ???": {"dc_capable": True, "dc_system_time": True},
}


def state_facts(text: str) -> _Facts | None:
    """AL state and error indication of ``SAFEOP`` or ``SAFEOP+ERROR``; empty for ``???``, None for other text."""
    state, plus, error = text.partition("+")
    if plus and error != "ERROR":
        return None
    if state in _STATES:
        return {"state": state, "state_error": bool(plus)}
    return {} if state == "???" else None


def _text(field: str) -> _Read:
    return lambda text: {field: text or None}


def _number(field: str, pattern: re.Pattern[str], base: int) -> _Read:
    def read(text: str) -> _Facts | None:
        match = pattern.fullmatch(text)
        return {field: int(match[match.lastindex or 0], base)} if match else None

    return read


def _choice(field: str, meanings: dict[str, Any]) -> _Read:
    return lambda text: {field: meanings[text]} if text in meanings else None


def _mailboxes(text: str) -> _Facts | None:
    match = _MAILBOXES.fullmatch(text)
    return {"mailbox_out_bytes": int(match[1]), "mailbox_in_bytes": int(match[2])} if match else None


def _protocols(text: str) -> _Facts | None:
    names = tuple(name.strip() for name in text.split(","))
    return {"mailbox_protocols": names} if all(name in _PROTOCOLS for name in names) else None


_YES_NO = {"yes": True, "no": False}
_FACTS: dict[str, _Read] = {
    "alias": _number("alias", _DECIMAL, 10),
    "device": _choice("master_device", {"Main": "Main", "Backup": "Backup"}),
    "state": state_facts,
    "flag": _choice("failed", {"+": False, "E": True}),
    "vendor id": _number("vendor_id", _HEX, 16),
    "product code": _number("product_code", _HEX, 16),
    "revision number": _number("revision_no", _HEX, 16),
    "serial number": _number("serial_no", _HEX, 16),
    "distributed clocks": _CLOCKS.get,
    "dc system time transmission delay": _number("dc_delay_ns", _DELAY, 10),
    "standard rx": _mailboxes,
    "rx": _mailboxes,
    "supported protocols": _protocols,
    "group": _text("group"),
    "order number": _text("order_number"),
    "device name": _text("name"),
    "enable notlrw": _choice("not_lrw", _YES_NO),
    "current consumption": _number("e_bus_current_ma", _CURRENT, 10),
}
_COE: dict[str, _Read] = {
    "enable sdo": _choice("sdo", _YES_NO),
    "enable sdo info": _choice("sdo_info", _YES_NO),
    "enable pdo assign": _choice("pdo_assign", _YES_NO),
    "enable pdo configuration": _choice("pdo_configuration", _YES_NO),
    "enable upload at startup": _choice("upload_at_startup", _YES_NO),
    "enable sdo complete access": _choice("complete_access", _YES_NO),
}
_SECTIONS = frozenset(("identity", "sii", "dl information", "mailboxes", "general", "coe details", "flags"))
"""Keys without value."""
_UNUSED = frozenset(("parallel read", "fmmu bit operation", "bootstrap rx", "image name", "enable safeop"))
_BEHIND_NAMES = {
    "group": ("image name",),
    "image name": ("order number",),
    "order number": ("device name",),
    "device name": ("coe details", "flags"),
}
"""What the tool prints next after text that may hold anything."""
_OPEN_ENDED = frozenset(
    (
        *("alias", "state", "vendor id", "product code", "revision number", "serial number", "standard rx", "rx"),
        *("supported protocols", "group", "order number"),
    )
)
"""Keys of values that still read well when their end is missing."""
_KEYS = "|".join(re.escape(key).replace(r"\ ", r"\s+") for key in (*_FACTS, *_COE, *_SECTIONS, *_UNUSED))
_BEGINNING = (
    rf"(?:(?:{_KEYS}):|Port\s+Type\s|===\s*(?:Master|Slave)\s"
    r"|[0-3][* ]\s*(?:EBUS|MII|N/A|N/C|\?\?\?)\s+(?:up|down)\s)"
)
_ITEM = re.compile(rf"\s*{_BEGINNING}", re.IGNORECASE)
_BETWEEN_ITEMS = re.compile(rf"(?<=\S)(?<!standard)(?<!bootstrap)(?=\s+{_BEGINNING})", re.IGNORECASE)
_REQUIRED = {"vendor_id": "vendor id", "product_code": "product code", "revision_no": "revision number"}


class _Item(NamedTuple):
    """A line, or a part of one that looks like an item."""

    line: int
    text: str
    key: str
    """Empty where there is none, and where a heading of a section goes on, so that it is none."""
    begins_line: bool
    unfinished: bool
    """No line end follows it."""


class _Block:
    """What one heading and the lines below it say."""

    def __init__(self, line: int, master: int | None, position: int) -> None:
        self.line, self.master, self.position = line, master, position
        self.facts: _Facts = {}
        self.coe: _Facts = {}
        self.ports: list[ScannedPort] = []
        self.read_keys: set[str] = set()
        self.open = True
        self.of_other_command = False

    def slave(self) -> ScannedSlave:
        return ScannedSlave(
            line=self.line,
            master=self.master,
            position=self.position,
            coe=ScannedCoe(**self.coe) if self.coe else None,
            ports=tuple(self.ports),
            **self.facts,
        )

    def findings(self) -> list[ScanFinding]:
        missing = [words for field, words in _REQUIRED.items() if self.facts.get(field) is None]
        if missing:
            return [self._finding(f"has no {', '.join(missing)}; kept without")]
        if not is_read(self.facts["vendor_id"], self.facts["product_code"]):
            return [self._finding(NOT_READ)]
        return []

    def _finding(self, message: str) -> ScanFinding:
        return ScanFinding(line=self.line, message=f"slave {self.position} {message}")


class _Reader:
    """Takes the lines of a text into blocks."""

    def __init__(self) -> None:
        self.blocks: list[_Block] = []
        self.findings: list[ScanFinding] = []
        self.skipped = Skipped()

    def take(self, item: _Item) -> None:
        number, line = item.line, item.text
        if heading := heading_of(line):
            self.blocks.append(_Block(number, *heading))
        elif self.blocks and is_broken_heading(line):
            self.blocks[-1].open = False
            message = f"no heading, though it begins like one; what stands below it is left out: {quoted(line)}"
            self.findings.append(ScanFinding(line=number, message=message))
        elif not self.blocks or not self.blocks[-1].open or not self._taken(self.blocks[-1], item):
            self.skipped.add(number, line)

    def _taken(self, block: _Block, item: _Item) -> bool:
        number, line = item.line, item.text
        key, value = _key_and_value(line)
        if key in block.read_keys:  # a slave says nothing twice: the heading of another one is lost
            block.open = False
            return False
        if read := _FACTS.get(key) or _COE.get(key):
            block.read_keys.add(key)
            facts = None if item.unfinished and _may_be_cut(key, value) else read(value)
            if facts is None:
                self.findings.append(ScanFinding(line=number, message=f"not understood or cut off: {quoted(line)}"))
            (block.coe if key in _COE else block.facts).update(facts or {})
        elif port := _PORT.fullmatch(line):
            kind = None if port[2] == "???" else port[2]
            block.ports.append(ScannedPort(number=int(port[1]), kind=kind, link_up=port[3] == "up"))
        elif _OTHER_COMMAND.match(line):
            block.of_other_command = True
        else:
            return key in _UNUSED or (key in _SECTIONS and not value) or _PORT_TITLES.match(line) is not None
        return True


def read_igh_slaves(text: str) -> Scan:
    """Read the cleaned text of ``ethercat slaves -v``, of one master or several.

    Blocks of ``ethercat pdos`` and ``sdos`` in the same text are passed over. Raises :class:`ScanError` when no block
    of a slave is left.
    """
    reader = _Reader()
    for part in _parts_of_slaves(text):
        for item in _items(part):
            reader.take(item)
    blocks = _of_slaves(reader.blocks)
    if not blocks:
        raise ScanError("no slave in the output of `ethercat slaves -v`")
    findings = reader.findings
    for block in blocks:
        findings += block.findings()
    slaves, bus_findings = separate_buses([block.slave() for block in blocks])
    findings += bus_findings + reader.skipped.findings(f"`{FORMAT}`")
    return Scan(format=FORMAT, slaves=slaves, findings=in_order(findings))


def _parts_of_slaves(text: str) -> Iterator[list[_Item]]:
    """What may be items, from one heading to the next."""
    unfinished_line = text.count("\n") + 1
    part: list[_Item] = []
    for number, line in numbered_lines(text):
        *before, last = _BETWEEN_ITEMS.split(line)
        items = [_item(number, words, index == 0, False) for index, words in enumerate(before)]
        items.append(_item(number, last, not before, number == unfinished_line))
        for item in items:
            if heading_of(item.text) and (item.begins_line or part[-1].key not in _BEHIND_NAMES):
                yield part
                part = []
            part.append(item)
    yield part


def _item(line: int, text: str, begins_line: bool, unfinished: bool) -> _Item:
    key, value = _key_and_value(text)
    return _Item(line, text, "" if key in _SECTIONS and value else key, begins_line, unfinished)


def _items(part: list[_Item]) -> Iterator[_Item]:
    """The items of a slave: what only looks like one goes back to the item in which it stands."""
    beginning = {item.key for item in part if item.begins_line}
    items: list[list[_Item]] = []
    for item in part:
        if items and not item.begins_line and not _is_joined(items[-1][0], item.key, beginning):
            items[-1].append(item)
        else:
            items.append([item])
    for pieces in items:
        whole = "".join(piece.text for piece in pieces)
        yield pieces[0]._replace(text=whole, unfinished=pieces[-1].unfinished)


def _is_joined(before: _Item, key: str, beginning: set[str]) -> bool:
    """Whether another item begins with ``key`` in the line of the one ``before``."""
    if key and key in beginning:
        return False
    return key in _BEHIND_NAMES.get(before.key, (key,)) and _ITEM.match(before.text) is not None


def _key_and_value(item: str) -> tuple[str, str]:
    """What stands before and behind the first colon; no key without one."""
    text, colon, value = item.partition(":")
    return one_line(text.lower()) if colon else "", value.strip()


def _may_be_cut(key: str, value: str) -> bool:
    """Whether the unfinished last line of a text may lack its end; identities are complete with eight digits."""
    return key in _OPEN_ENDED and re.fullmatch(r"0x[0-9a-fA-F]{8}", value) is None


def _of_slaves(blocks: list[_Block]) -> list[_Block]:
    """Without the blocks of ``pdos`` and ``sdos``; old releases print their heading for slaves without PDOs too."""
    described = {(block.master, block.position) for block in blocks if block.facts}
    return [
        block
        for block in blocks
        if block.facts or not (block.of_other_command or (block.master, block.position) in described)
    ]
