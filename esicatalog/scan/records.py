"""Records of what a master prints: slaves of a bus, their PDOs, their objects.

A field is None where the text does not say it; nothing is derived from the ESI or guessed. Ring positions count from
0 everywhere, whatever the master counts from. ``line`` is the number, from 1, of the line where a record begins.
"""

from bisect import bisect_right
from collections.abc import Iterable, Sequence

import msgspec

from esicatalog.errors import InputError
from esicatalog.identity import Identity


class ScanError(InputError):
    """The text or document is none of the formats that are read, or breaks its format beyond reading."""


class ScanFinding(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """Something odd in the text, or a part that was ignored."""

    line: int
    message: str


def findings_by_line(lines: Sequence[int], findings: Iterable[ScanFinding]) -> tuple[tuple[ScanFinding, ...], ...]:
    """The findings of each record that begins at one of ``lines``, in rising order: from its line to that of the next.

    Those before the first go with the first; of several records in one line it is the last.
    """
    found: list[list[ScanFinding]] = [[] for _ in lines]
    for finding in findings if lines else ():
        found[max(bisect_right(lines, finding.line) - 1, 0)].append(finding)
    return tuple(map(tuple, found))


class ScannedPdoEntry(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """A mapped entry; index 0 is a gap of ``bit_length`` bits."""

    index: int
    subindex: int
    bit_length: int
    name: str | None
    line: int


class ScannedPdo(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """An assigned PDO with its mapping in the order of transfer."""

    index: int
    is_rx: bool
    """RxPDO: outputs of the master, received by the slave."""
    name: str | None
    entries: tuple[ScannedPdoEntry, ...] = ()
    line: int


class ScannedSyncManager(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """A SyncManager and the PDOs assigned to it."""

    number: int
    start_address: int
    size_bytes: int
    """IgH: DefaultSize of the SII, often 0 for process data; SOEM: the configured length."""
    control: int
    """Control byte, register 0x0804; bit 2 set = written by the master."""
    enable: int
    """Enable byte, register 0x0806."""
    pdos: tuple[ScannedPdo, ...] = ()
    line: int


class ScannedPort(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """A port of the ESC."""

    number: int
    kind: str | None = None
    """EBUS, MII, N/A (not implemented), N/C (not configured)."""
    link_up: bool | None = None


class ScannedCoe(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """CoE details of the SII category General."""

    sdo: bool | None = None
    sdo_info: bool | None = None
    pdo_assign: bool | None = None
    pdo_configuration: bool | None = None
    upload_at_startup: bool | None = None
    complete_access: bool | None = None


class ScannedSlave(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """A slave as the master found it (scans) or expects it (ENI)."""

    line: int
    bus: int = 0
    """Which bus of the text, from 0: masters, network interfaces and contradicting listings are kept apart."""
    master: int | None = None
    """Index of the IgH master."""
    interface: str | None = None
    """Network interface that SOEM used."""
    position: int
    """Ring position from 0 (SOEM prints it from 1; CSV: number of the row)."""
    alias: int | None = None
    """Configured station alias, in an ENI the one that it expects; None also where none is set."""
    configured_address: int | None = None
    """Configured station address, register 0x0010."""
    identification_value: int | None = None
    """Explicit device identification that the ENI expects."""
    identification_register: int | None = None
    """Register of ``identification_value``: 0x0012 station alias, 0x0134 AL status code."""
    vendor_id: int | None = None
    product_code: int | None = None
    revision_no: int | None = None
    serial_no: int | None = None
    name: str | None = None
    order_number: str | None = None
    group: str | None = None
    state: str | None = None
    """AL state: INIT, PREOP, BOOT, SAFEOP or OP."""
    state_error: bool | None = None
    """The error indication of the AL status."""
    failed: bool | None = None
    """IgH flag E: scan or configuration of the slave failed."""
    al_status_code: int | None = None
    """Register 0x0134, where the master tells it."""
    master_device: str | None = None
    """Main or Backup: link of a redundant master that reaches the slave."""
    e_bus_current_ma: int | None = None
    """mA taken from the E-bus, negative = fed into it."""
    dc_capable: bool | None = None
    dc_system_time: bool | None = None
    """False: only delay measurement, so no reference clock."""
    dc_system_time_bits: int | None = None
    dc_delay_ns: int | None = None
    """Propagation delay from the reference clock as printed."""
    reference_clock: bool | None = None
    """The ENI makes the slave the reference clock."""
    potential_reference_clock: bool | None = None
    """The ENI says whether the slave can be the reference clock."""
    sync0_cycle_ns: int | None = None
    """Cycle of SYNC0 that the ENI configures; 0 without SYNC0."""
    not_lrw: bool | None = None
    """The slave cannot take LRW; it needs separate LRD and LWR commands."""
    mailbox_protocols: tuple[str, ...] | None = None
    """AoE, EoE, CoE, FoE, SoE, VoE; empty = no mailbox, None = not said."""
    mailbox_out_bytes: int | None = None
    """Size of the mailbox that the master writes."""
    mailbox_in_bytes: int | None = None
    """Size of the mailbox that the master reads."""
    coe: ScannedCoe | None = None
    output_bits: int | None = None
    """Bits that the master writes per cycle."""
    input_bits: int | None = None
    """Bits that the master reads per cycle."""
    ports: tuple[ScannedPort, ...] = ()
    sync_managers: tuple[ScannedSyncManager, ...] = ()

    @property
    def identity(self) -> Identity | None:
        """Vendor, product and revision, or None when vendor or product is unknown."""
        if self.vendor_id is None or self.product_code is None:
            return None
        return Identity(self.vendor_id, self.product_code, self.revision_no)


class Scan(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """The slaves of a text in the order of the text."""

    format: str
    """Name of the format that was recognised."""
    slaves: tuple[ScannedSlave, ...]
    findings: tuple[ScanFinding, ...] = ()

    @property
    def finding_lines(self) -> tuple[str, ...]:
        """The findings for people, each with its line."""
        return tuple(f"line {finding.line}: {finding.message}" for finding in self.findings)

    def findings_by_slave(self) -> tuple[tuple[ScanFinding, ...], ...]:
        """The findings of each slave, see :func:`findings_by_line`."""
        return findings_by_line([slave.line for slave in self.slaves], self.findings)


class ScannedPdos(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """SyncManagers and PDOs of one slave; master and position are None where no heading names them.

    ``origin`` is where the list comes from, in the words of whoever gave it; ``findings`` are those in its lines.
    """

    master: int | None = None
    position: int | None = None
    sync_managers: tuple[ScannedSyncManager, ...]
    line: int
    origin: str = "a list of PDOs"
    findings: tuple[ScanFinding, ...] = ()
    is_complete: bool = True
    """False where a line of the list was not understood: then it tells neither sizes nor the assignment."""

    @property
    def lists_entries(self) -> bool:
        """False where no PDO has an entry: with ``--quiet`` the master prints none."""
        pdos = [pdo for sync_manager in self.sync_managers for pdo in sync_manager.pdos]
        return not pdos or any(pdo.entries for pdo in pdos)


class PdoScan(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """Output of ``ethercat pdos``."""

    slaves: tuple[ScannedPdos, ...]
    findings: tuple[ScanFinding, ...] = ()


class ScannedObjectEntry(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """An entry of an object."""

    subindex: int
    access: str | None
    """``rwrwrw``: read and write in PREOP, SAFEOP and OP, ``-`` where not allowed."""
    data_type: str
    """IgH's name of the type (``uint16``, ``octet_string``), or ``type`` and its CoE number in hex."""
    bit_length: int | None
    name: str | None
    line: int


class ScannedObject(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """An object of the CoE dictionary."""

    index: int
    name: str | None
    entries: tuple[ScannedObjectEntry, ...] = ()
    line: int


class ScannedDictionary(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """Objects of one slave, with the same fields around them as :class:`ScannedPdos`."""

    master: int | None = None
    position: int | None = None
    objects: tuple[ScannedObject, ...]
    line: int
    origin: str = "a list of objects"
    findings: tuple[ScanFinding, ...] = ()
    is_complete: bool = True
    """False where a line of the list was not understood: then it does not tell which objects the slave has."""

    @property
    def lists_entries(self) -> bool:
        """False where no object has an entry: with ``--quiet`` the master prints none."""
        return any(item.entries for item in self.objects)


class SdoScan(msgspec.Struct, frozen=True, gc=False, kw_only=True):
    """Output of ``ethercat sdos``."""

    slaves: tuple[ScannedDictionary, ...]
    findings: tuple[ScanFinding, ...] = ()
