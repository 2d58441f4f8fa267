"""ENI files (ETG.2100, root EtherCATConfig): the slaves that a master configuration expects.

Elements are known by their local names: some generators write them in the namespace of EtherCATInfo.
"""

from typing import Any

from lxml import etree

from esicatalog.errors import InputError
from esicatalog.esi import documents
from esicatalog.esi.containers import MAX_DOCUMENT_BYTES
from esicatalog.esi.documents import local_name
from esicatalog.esi.numbers import BOOL
from esicatalog.identity import parse_number
from esicatalog.scan.records import Scan, ScanError, ScanFinding, ScannedSlave
from esicatalog.scan.text import in_order, quoted

FORMAT = "ENI"

_ROOT = "EtherCATConfig"
_STATION_ALIAS = 0x12
"""Register of the configured station alias (ESC data sheet)."""
_IDENTITY = {"vendor_id": "VendorId", "product_code": "ProductCode", "revision_no": "RevisionNo"}


class _Numbers:
    """Reads numbers below one Slave element; what is none becomes a finding."""

    def __init__(self, slave: etree._Element, findings: list[ScanFinding]) -> None:
        self._slave = slave
        self._findings = findings

    def child(self, path: str, bits: int = 32) -> int | None:
        """The number in the first element at ``path``; None when there is none or it is not readable."""
        element = self._slave.find(path)
        return None if element is None else self.read(element, element.text, bits)

    def attribute(self, path: str, name: str, bits: int) -> int | None:
        """The number in an attribute."""
        element = self._slave.find(path)
        text = None if element is None else element.get(name)
        return None if element is None or text is None else self.read(element, text, bits)

    def total(self, path: str) -> int:
        """The sum of all numbers at ``path``."""
        return sum(self.read(element, element.text, 32) or 0 for element in self._slave.iterfind(path))

    def read(self, element: etree._Element, text: str | None, bits: int) -> int | None:
        """A number in any notation. The schema's type is xs:int: negative numbers are bit patterns."""
        digits = (text or "").strip()
        negative = digits.startswith("-")
        try:
            value = parse_number(digits.removeprefix("-"), str(element.tag), (1 << bits - negative) - 1 + negative)
        except InputError as error:
            self._findings.append(ScanFinding(line=element.sourceline or 0, message=str(error)))
            return None
        return (1 << bits) - value if negative and value else value


def read_eni(data: bytes) -> Scan:
    """Read the slaves of an ENI file. Raises :class:`ScanError` when it is none or declares XML entities."""
    findings: list[ScanFinding] = []
    slaves = [_slave(place, element, findings) for place, element in enumerate(_root(data).iterfind("Config/Slave"))]
    if not slaves:
        findings.append(ScanFinding(line=1, message="the configuration has no slaves"))
    return Scan(format=FORMAT, slaves=tuple(slaves), findings=in_order(findings))


def _root(data: bytes) -> etree._Element:
    if len(data) > MAX_DOCUMENT_BYTES:
        raise ScanError(f"larger than {MAX_DOCUMENT_BYTES // 2**20} MB; no ENI file is")
    try:
        root = etree.fromstring(data, documents.make_parser())
    except etree.XMLSyntaxError as error:
        raise ScanError(f"no ENI file: not well-formed XML: {quoted(error.msg or str(error))}") from error
    dtd = root.getroottree().docinfo.internalDTD
    if dtd is not None and next(dtd.iterentities(), None) is not None:
        raise ScanError("the document declares XML entities; no ENI file does, and they are not expanded")
    for element in root.iter("{*}*"):
        element.tag = local_name(element)
    if root.tag != _ROOT:
        kind = "an ESI document" if root.tag in documents.ESI_ROOTS else f"root element {quoted(str(root.tag))}"
        raise ScanError(f"{kind} instead of an ENI file (root EtherCATConfig)")
    return root


def _slave(place: int, element: etree._Element, findings: list[ScanFinding]) -> ScannedSlave:
    numbers = _Numbers(element, findings)
    line = element.sourceline or 0
    identity: dict[str, Any] = {field: numbers.child(f"Info/{tag}") for field, tag in _IDENTITY.items()}
    missing = [_IDENTITY[field] for field, value in identity.items() if value is None]
    if missing:
        message = f"slave {place} has no readable {', '.join(missing)}; kept without"
        findings.append(ScanFinding(line=line, message=message))
    increment = numbers.child("Info/AutoIncAddr", bits=16)
    position = place if increment is None else -increment & 0xFFFF
    if position != place:
        message = f"AutoIncAddr says ring position {position}, but the slave is listed at {place}"
        findings.append(ScanFinding(line=line, message=message))
    value = numbers.attribute("Info/Identification", "Value", bits=16)
    register = numbers.child("Info/Identification/Ado", bits=16)
    return ScannedSlave(
        line=line,
        position=position,
        name=(element.findtext("Info/Name") or "").strip() or None,
        configured_address=numbers.child("Info/PhysAddr", bits=16),
        alias=value if register == _STATION_ALIAS else None,
        identification_value=value,
        identification_register=register,
        serial_no=numbers.child("Info/SerialNo"),
        **identity,
        **_mailbox(element, numbers),
        **_clocks(element, numbers),
        **_process_data(element, numbers),
    )


def _mailbox(element: etree._Element, numbers: _Numbers) -> dict[str, Any]:
    if element.find("Mailbox") is None:
        return {}
    protocols = ((protocol.text or "").strip() for protocol in element.iterfind("Mailbox/Protocol"))
    received = "Mailbox/Recv" if element.find("Mailbox/Recv") is not None else "Mailbox/Receive"
    return {
        "mailbox_protocols": tuple(protocol for protocol in protocols if protocol),
        "mailbox_out_bytes": numbers.child("Mailbox/Send/Length", bits=16),
        "mailbox_in_bytes": numbers.child(f"{received}/Length", bits=16),
    }


def _clocks(element: etree._Element, numbers: _Numbers) -> dict[str, Any]:
    """A slave that the configuration synchronises has clocks; of the others it says nothing."""
    clocks = element.find("DC")
    if clocks is None:
        return {}
    told = {"reference_clock": "ReferenceClock", "potential_reference_clock": "PotentialReferenceClock"}
    known = {"dc_capable": True, "sync0_cycle_ns": numbers.child("DC/CycleTime0")}
    return known | {field: BOOL.read(clocks.findtext(tag) or "").value for field, tag in told.items()}


def _process_data(element: etree._Element, numbers: _Numbers) -> dict[str, Any]:
    if element.find("ProcessData") is None:
        return {}
    return {
        "output_bits": numbers.total("ProcessData/Send/BitLength"),
        "input_bits": numbers.total("ProcessData/Recv/BitLength"),
    }
