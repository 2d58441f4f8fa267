"""``ethercat slaves`` of the IgH EtherCAT master: one line a slave.

Columns: ring position, alias and distance to the slave that has it, AL state, flag, name. The name is that of the
SII; only a slave without one shows ``0xvvvvvvvv:0xpppppppp`` (older tools: without ``0x``), so the identity of most
slaves is not said. With several masters each table stands under ``Master0`` and is indented.
"""

import re

from esicatalog.scan.buses import separate_buses
from esicatalog.scan.igh_slaves import state_facts
from esicatalog.scan.records import Scan, ScanFinding, ScannedSlave
from esicatalog.scan.text import Skipped, in_order, numbered_lines

FORMAT = "ethercat slaves"

ROW = re.compile(
    r"^[ \t]*([0-9]{1,5})[ \t]+([0-9]{1,5}):([0-9]{1,5})[ \t]+"
    r"((?:INIT|PREOP|BOOT|SAFEOP|OP|\?\?\?)(?:\+ERROR)?)[ \t]+([+E])(?:[ \t]+(.*))?$",
    re.MULTILINE,
)
_MASTER = re.compile(r"Master([0-9]{1,3})\s*")
_IDENTITY = re.compile(r"(?:0x)?([0-9a-f]{8}):(?:0x)?([0-9a-f]{8})", re.IGNORECASE)
_LINK_FAILURE = "xxx LINK FAILURE xxx"


def read_igh_table(text: str) -> Scan:
    """Read the cleaned text of ``ethercat slaves``. Slaves that show a name have no identity."""
    slaves: list[ScannedSlave] = []
    findings: list[ScanFinding] = []
    skipped = Skipped()
    master: int | None = None
    for number, line in numbered_lines(text):
        if row := ROW.fullmatch(line):
            slaves.append(_slave(number, master, row))
        elif heading := _MASTER.fullmatch(line):
            master = int(heading[1])
        elif line.strip() == _LINK_FAILURE:
            message = "link failure: the slaves below are reached by the backup device only"
            findings.append(ScanFinding(line=number, message=message))
        else:
            skipped.add(number, line)
    named = [slave for slave in slaves if slave.vendor_id is None]
    if named:
        message = f"slaves that show a name instead of an identity: {len(named)}; `ethercat slaves -v` shows both"
        findings.append(ScanFinding(line=named[0].line, message=message))
    found, bus_findings = separate_buses(slaves)
    findings += bus_findings + skipped.findings(f"`{FORMAT}`")
    return Scan(format=FORMAT, slaves=found, findings=in_order(findings))


def _slave(number: int, master: int | None, row: re.Match[str]) -> ScannedSlave:
    alias, distance, name = int(row[2]), int(row[3]), (row[6] or "").strip()
    identity = _IDENTITY.fullmatch(name)
    return ScannedSlave(
        line=number,
        master=master,
        position=int(row[1]),
        alias=alias if alias and not distance else None,
        failed=row[5] == "E",
        vendor_id=int(identity[1], 16) if identity else None,
        product_code=int(identity[2], 16) if identity else None,
        name=None if identity else name or None,
        **(state_facts(row[4]) or {}),
    )
