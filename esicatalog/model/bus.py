"""What an engineer wants to know of a bus before it runs: E-bus supply, process data, clocks, aliases, LRW.

Facts come from the scan where the master printed them (they are the device's own), else from the description. Process
data of another size than the description's default is told.
"""

import itertools
from collections import defaultdict
from collections.abc import Container, Iterator, Sequence
from typing import NamedTuple

import msgspec

from esicatalog.model.eeprom_pdos import SoemBits
from esicatalog.model.ports import has_e_bus
from esicatalog.model.sm_facts import BUFFERED, INPUT, OUTPUT, control_facts
from esicatalog.model.values import byte_length
from esicatalog.scan.buses import gap_words, gaps
from esicatalog.scan.records import ScannedPdos, ScannedSlave, ScannedSyncManager

_E_BUS = "EBUS"


class DeviceAtBus(NamedTuple):
    """What the description of a slave says about its place at a bus."""

    physics: str | None
    e_bus_current_ma: int | None
    no_lrw: bool
    output_bytes: int | None
    input_bytes: int | None
    dc_supported: bool
    """Says False also where it says nothing of clocks."""
    potential_reference_clock: bool | None = None
    """Dc/@PotentialReferenceClock."""
    supports_sync0: bool = False
    """Whether an OpMode generates SYNC0."""
    output_bits: int | None = None
    """All bits, which masters add up over SyncManagers before they round; None where they are not known."""
    input_bits: int | None = None
    soem_outputs: SoemBits | None = None
    """What a master exchanges that takes the PDOs from the EEPROM; None where it asks the device."""
    soem_inputs: SoemBits | None = None
    virtual_output_bytes: int = 0
    """Bytes of the slave's process data that are listed for virtual PDOs, which no size here has."""
    virtual_input_bytes: int = 0

    @property
    def has_clock(self) -> bool | None:
        """Whether it describes a distributed clock; None where it says nothing."""
        return self.dc_supported or self.potential_reference_clock or None


class SlaveReport(NamedTuple):
    """What is to be known of one slave; None = unknown."""

    output_bytes: int | None
    input_bytes: int | None
    e_bus_current_ma: int | None
    e_bus_left_ma: int | None
    """What the supply before it leaves for the terminals after it; None outside of an E-bus segment."""
    dc_capable: bool | None
    """Known to have a distributed clock or to have none; a description without Dc says neither."""
    no_lrw: bool | None
    notes: tuple[str, ...]


class BusSummary(NamedTuple):
    """What is to be known of the whole bus; positions are ring positions.

    Slaves that are not listed count among those of which something is unknown.
    """

    not_listed: tuple[int, ...]
    """Slaves before and between the others that are not in the listing."""
    duplicate_aliases: dict[int, tuple[int, ...]]
    e_bus_exceeded_at: tuple[int, ...]
    """First terminal of each E-bus segment that the supply does not reach."""
    e_bus_unknown_at: tuple[int, ...]
    output_bytes: int
    input_bytes: int
    bytes_unknown_at: tuple[int, ...]
    bytes_described_at: tuple[int, ...]
    """Slaves of which the description gives bytes that the scan does not tell."""
    reference_clock_at: tuple[int, ...]
    """Slaves that the configuration makes the reference clock, normally one."""
    reference_clock_candidate: int | None
    """The first slave that is known to have distributed clocks, and not to be excluded as reference clock."""
    system_time_known: bool
    """Whether it is also known to have the system time that a reference clock needs, not delay measurement alone."""
    clock_unknown_at: tuple[int, ...]
    """Slaves before it (all where there is none) of which neither scan nor description tells."""
    no_lrw_at: tuple[int, ...]


def as_listed(slave: ScannedSlave, lists: Sequence[ScannedPdos]) -> ScannedSlave:
    """The slave with the process data of the PDOs that a master listed: what is assigned is what is exchanged.

    Every SyncManager begins at a byte. A direction of which the lists say nothing, as those without entries and
    those that are not complete do, stays as the scan has it.
    """
    sizes = _listed_bytes(lists)
    output_bytes, input_bytes = sizes.get(OUTPUT), sizes.get(INPUT)
    return msgspec.structs.replace(
        slave,
        output_bits=8 * output_bytes if output_bytes is not None else slave.output_bits,
        input_bits=8 * input_bytes if input_bytes is not None else slave.input_bits,
    )


def with_virtual(
    device: DeviceAtBus, lists: Sequence[ScannedPdos], virtual: Container[tuple[int, int | None]]
) -> DeviceAtBus:
    """The description with what a master listed of its virtual PDOs (SyncManager and index), as EEPROMs have them."""
    sizes, others = _listed_bytes(lists), _listed_bytes(lists, virtual)
    return device._replace(
        virtual_output_bytes=sizes.get(OUTPUT, 0) - others.get(OUTPUT, 0),
        virtual_input_bytes=sizes.get(INPUT, 0) - others.get(INPUT, 0),
    )


def _listed_bytes(
    lists: Sequence[ScannedPdos], left_out: Container[tuple[int, int | None]] = frozenset()
) -> dict[str, int]:
    telling = [listed for listed in lists if listed.is_complete and listed.lists_entries]
    sizes: dict[str, dict[int, int]] = defaultdict(dict)
    for sync_manager in (item for listed in telling for item in listed.sync_managers):
        for direction, bits in _listed_bits(sync_manager, left_out).items():
            sizes[direction][sync_manager.number] = byte_length(bits)
    return {direction: sum(of_direction.values()) for direction, of_direction in sizes.items()}


def _listed_bits(sync_manager: ScannedSyncManager, left_out: Container[tuple[int, int | None]]) -> dict[str, int]:
    """Bits by direction; nothing where a size without PDOs tells of process data that nobody maps."""
    bits: dict[str, int] = defaultdict(int)
    for pdo in sync_manager.pdos:
        if (sync_manager.number, pdo.index) not in left_out:
            bits[OUTPUT if pdo.is_rx else INPUT] += sum(entry.bit_length for entry in pdo.entries)
    facts = control_facts(sync_manager.control)
    is_empty = not sync_manager.pdos and not sync_manager.size_bytes and facts.buffer_mode == BUFFERED
    return {facts.transfer_direction: 0} if is_empty and facts.transfer_direction is not None else bits


def look_at_bus(bus: Sequence[tuple[ScannedSlave, DeviceAtBus | None]]) -> tuple[list[SlaveReport], BusSummary]:
    """Reports of the slaves of one bus, in ring order, and their summary.

    ``bus`` is in ring order. The E-bus budget follows that order and not the branches of a line. A device with negative
    current feeds the segment behind it anew; one without E-bus port ends it, and so do slaves that are not listed.
    """
    aliases: dict[int, list[int]] = defaultdict(list)
    for slave, _ in bus:
        if slave.alias:
            aliases[slave.alias].append(slave.position)
    duplicates = {alias: tuple(positions) for alias, positions in aliases.items() if len(positions) > 1}
    budget = _EBusBudget()
    missing = gaps(slave for slave, _ in bus)
    # A listing of one slave has no gaps: it is that of this slave.
    told = missing if len(bus) > 1 else {}
    reports = []
    for slave, device in bus:
        notes = list(budget.pass_over(told[slave.position])) if slave.position in told else []
        budget.pass_by(slave, device)
        notes += [*_troubles(slave), *_clock_troubles(slave, device), *budget.notes]
        if slave.alias in duplicates:
            others = ", ".join(str(position) for position in duplicates[slave.alias] if position != slave.position)
            notes.append(f"alias {slave.alias} is also that of slave {others}")
        outputs, inputs = _sizes(slave, device)
        notes += [*outputs.notes("out"), *inputs.notes("in")]
        reports.append(
            SlaveReport(
                output_bytes=outputs.byte_size,
                input_bytes=inputs.byte_size,
                e_bus_current_ma=budget.current,
                e_bus_left_ma=budget.left,
                dc_capable=slave.dc_capable if slave.dc_capable is not None or not device else device.has_clock,
                no_lrw=slave.not_lrw if slave.not_lrw is not None or not device else device.no_lrw,
                notes=tuple(notes),
            )
        )
    not_listed = tuple(itertools.chain.from_iterable(missing.values()))
    return reports, _summary(bus, not_listed, reports, duplicates, budget)


def _troubles(slave: ScannedSlave) -> Iterator[str]:
    """What the master itself reports to be wrong with a slave."""
    if slave.failed:
        yield "the master reports that its scan or configuration failed (flag E)"
    if slave.state_error or slave.al_status_code:
        state = f" in {slave.state}" if slave.state is not None else ""
        code = f", AL status code 0x{slave.al_status_code:04X}" if slave.al_status_code else ""
        yield f"the slave reports an error{state}{code}"
    if slave.master_device == "Backup":
        yield "reached by the backup link of the master only"


def _clock_troubles(slave: ScannedSlave, device: DeviceAtBus | None) -> Iterator[str]:
    """What an ENI configures of the clocks that the description, or the ENI itself, excludes."""
    if slave.reference_clock and slave.potential_reference_clock is False:
        yield "configured as reference clock, which the configuration itself excludes: PotentialReferenceClock is false"
    if device is None:
        return
    if slave.reference_clock and device.potential_reference_clock is False:
        yield "configured as reference clock, which its description excludes: PotentialReferenceClock is false"
    if slave.sync0_cycle_ns and not device.supports_sync0:
        yield f"SYNC0 is configured every {slave.sync0_cycle_ns} ns; no OpMode of its description generates it"


class _Size(NamedTuple):
    """Process data of one direction, as configured and as described."""

    configured_bits: int | None
    described_bytes: int | None = None
    described_bits: int | None = None
    virtual_bytes: int = 0
    """How many of the configured bytes are those of virtual PDOs: they are not compared."""
    soem: SoemBits | None = None

    @property
    def byte_size(self) -> int | None:
        """As configured, else as described."""
        return byte_length(self.configured_bits) if self.configured_bits is not None else self.described_bytes

    def notes(self, way: str) -> Iterator[str]:
        """A note where neither the bytes are the same nor the bits, and virtual PDOs are not why."""
        if self.configured_bits is None or self.described_bytes is None or self.byte_size is None:
            return
        if self.configured_bits == self.described_bits or self.byte_size - self.virtual_bytes == self.described_bytes:
            return
        counted = self.soem if self.soem is not None and self.soem.bit_size == self.configured_bits else None
        if counted is None or not counted.is_default:
            described = f"{self.described_bytes} in the default process image of the description"
            reason = "" if counted is None else "; the EEPROM assigns that many"
            yield f"bytes {way}: {self.byte_size} configured, {described}{reason}"


def _sizes(slave: ScannedSlave, device: DeviceAtBus | None) -> tuple[_Size, _Size]:
    """Outputs and inputs."""
    if device is None:
        return _Size(slave.output_bits), _Size(slave.input_bits)
    outputs = device.output_bytes, device.output_bits, device.virtual_output_bytes, device.soem_outputs
    inputs = device.input_bytes, device.input_bits, device.virtual_input_bytes, device.soem_inputs
    return _Size(slave.output_bits, *outputs), _Size(slave.input_bits, *inputs)


class _EBusBudget:
    """Follows the supply of an E-bus segment from slave to slave."""

    def __init__(self) -> None:
        self.left: int | None = None
        self.current: int | None = None
        self.notes: list[str] = []
        self.exceeded_at: list[int] = []
        self.unknown_at: list[int] = []

    def pass_over(self, gap: range) -> Iterator[str]:
        """Take slaves into account that are not listed, and say so."""
        ends = self.left is not None
        if ends:
            self.unknown_at.extend(gap)
        self.left = None
        yield gap_words(gap) + "; the E-bus budget ends there" * ends

    def pass_by(self, slave: ScannedSlave, device: DeviceAtBus | None) -> None:
        """Take the next slave into account."""
        self.notes = []
        described = device.e_bus_current_ma if device is not None else None
        self.current = slave.e_bus_current_ma if slave.e_bus_current_ma is not None else described
        on_e_bus = _on_e_bus(slave, device)
        if self.current is not None and self.current < 0:
            self.left = -self.current
        elif on_e_bus is False:
            self.left = None
        elif self.current is None:
            if self.left is not None:
                self.unknown_at.append(slave.position)
                self.notes.append("E-bus current unknown: the budget ends here")
            self.left = None
        elif self.left is not None:
            was_enough = self.left >= 0
            self.left -= self.current
            if self.left < 0 and was_enough:
                self.exceeded_at.append(slave.position)
                self.notes.append(f"E-bus supply exceeded by {-self.left} mA: put a power feed before it")


def _on_e_bus(slave: ScannedSlave, device: DeviceAtBus | None) -> bool | None:
    kinds = [port.kind for port in slave.ports if port.kind is not None]
    if kinds:
        return _E_BUS in kinds
    return has_e_bus(device.physics) if device is not None and device.physics else None


def _can_be_reference_clock(slave: ScannedSlave, device: DeviceAtBus | None, has_clock: bool | None) -> bool | None:
    """Whether a slave can give the bus its time; None = unknown.

    It needs a system time, of which the scan tells more surely than the description; what the vendor or an ENI excludes
    with PotentialReferenceClock is excluded.
    """
    excluded = (slave.dc_system_time, slave.potential_reference_clock, device and device.potential_reference_clock)
    if False in excluded:
        return False
    return has_clock


def _has_system_time(slave: ScannedSlave, device: DeviceAtBus | None) -> bool:
    """Whether scan or description tells so: what synchronises by a sync unit has one, slaveinfo prints none."""
    return bool(slave.dc_system_time or (device is not None and device.has_clock))


def _are_described(slave: ScannedSlave, device: DeviceAtBus | None) -> bool:
    """Whether bytes of a slave are those of its description."""
    return any(size.configured_bits is None and size.described_bytes is not None for size in _sizes(slave, device))


def _summary(
    bus: Sequence[tuple[ScannedSlave, DeviceAtBus | None]],
    not_listed: tuple[int, ...],
    reports: Sequence[SlaveReport],
    duplicates: dict[int, tuple[int, ...]],
    budget: _EBusBudget,
) -> BusSummary:
    together = [(slave, report) for (slave, _), report in zip(bus, reports, strict=True)]
    clocks = dict.fromkeys(not_listed) | {
        slave.position: _can_be_reference_clock(slave, device, report.dc_capable)
        for (slave, device), report in zip(bus, reports, strict=True)
    }
    in_ring_order = sorted(clocks.items())
    candidate = next((position for position, can in in_ring_order if can), None)
    told = {slave.position: _has_system_time(slave, device) for slave, device in bus}
    before = itertools.takewhile(lambda item: item[0] != candidate, in_ring_order)
    unknown = (s.position for s, r in together if r.output_bytes is None or r.input_bytes is None)
    return BusSummary(
        not_listed=not_listed,
        duplicate_aliases=duplicates,
        e_bus_exceeded_at=tuple(budget.exceeded_at),
        e_bus_unknown_at=tuple(budget.unknown_at),
        output_bytes=sum(report.output_bytes or 0 for report in reports),
        input_bytes=sum(report.input_bytes or 0 for report in reports),
        bytes_unknown_at=tuple(sorted((*not_listed, *unknown))),
        bytes_described_at=tuple(slave.position for slave, device in bus if _are_described(slave, device)),
        reference_clock_at=tuple(slave.position for slave, _ in bus if slave.reference_clock),
        reference_clock_candidate=candidate,
        system_time_known=candidate is not None and told[candidate],
        clock_unknown_at=tuple(position for position, can in before if can is None),
        no_lrw_at=tuple(s.position for s, r in together if r.no_lrw),
    )
