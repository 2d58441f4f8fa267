"""A bus as a whole: E-bus budget, aliases, process data, clocks, LRW."""

import msgspec
import pytest

from esicatalog.model.bus import DeviceAtBus, as_listed, look_at_bus, with_virtual
from esicatalog.scan.front import read_pdos
from esicatalog.scan.records import ScannedPort, ScannedSlave

COUPLER = DeviceAtBus("YKY", -2000, False, 0, 0, True)
TERMINAL = DeviceAtBus("KK", 100, False, 1, 2, False)
HUNGRY = DeviceAtBus("KK", 1950, False, 0, 0, False)
UNKNOWN_CURRENT = DeviceAtBus("KK", None, False, 0, 0, False)
DRIVE = DeviceAtBus("YY", None, True, 8, 16, True)


def bus(*devices, **of_position):
    slaves = [
        msgspec.structs.replace(ScannedSlave(line=1, position=n), **of_position.get(f"at{n}", {}))
        for n in range(len(devices))
    ]
    return look_at_bus(list(zip(slaves, devices, strict=True)))


def test_the_budget_goes_down_and_is_fed_anew():
    reports, summary = bus(COUPLER, TERMINAL, HUNGRY, TERMINAL, COUPLER, TERMINAL)
    assert [report.e_bus_left_ma for report in reports] == [2000, 1900, -50, -150, 2000, 1900]
    assert summary.e_bus_exceeded_at == (2,)
    assert [bool(report.notes) for report in reports] == [False, False, True, False, False, False]


def test_what_has_no_e_bus_port_ends_the_segment():
    reports, _ = bus(COUPLER, DRIVE, TERMINAL)
    assert [report.e_bus_left_ma for report in reports] == [2000, None, None]


def test_the_letters_of_physics_that_are_e_bus():
    """B is the E-bus by cable of schemas before 1.6: what such a device takes of the supply is unknown, not nothing."""
    for physics, is_e_bus in (("BB", True), ("YB", True), ("kk", True), ("YY K", True), ("YH", False), ("YX", False)):
        _, summary = bus(COUPLER, UNKNOWN_CURRENT._replace(physics=physics))
        assert summary.e_bus_unknown_at == ((1,) if is_e_bus else ()), physics


def test_an_unknown_current_ends_the_budget_and_is_told():
    reports, summary = bus(COUPLER, UNKNOWN_CURRENT, None, TERMINAL)
    assert [report.e_bus_left_ma for report in reports] == [2000, None, None, None]
    assert summary.e_bus_unknown_at == (1,)


def test_what_the_master_printed_counts_before_the_description():
    reports, _ = bus(
        COUPLER,
        TERMINAL,
        at0={"e_bus_current_ma": -1000},
        at1={"e_bus_current_ma": 300, "output_bits": 9, "not_lrw": True, "dc_capable": True},
    )
    assert reports[1].e_bus_left_ma == 700
    assert (reports[1].output_bytes, reports[1].input_bytes) == (2, 2)
    assert reports[1].no_lrw is True
    assert reports[1].dc_capable is True


def test_bits_of_two_sync_managers_are_as_described():
    """3 bits on one and 5 on the other are two bytes in memory, and a master that adds up bits says 8 bits."""
    described = TERMINAL._replace(output_bytes=2, output_bits=8)
    reports, _ = bus(described, described, at0={"output_bits": 8}, at1={"output_bits": 7})
    assert [report.notes for report in reports] == [
        (),
        ("bytes out: 1 configured, 2 in the default process image of the description",),
    ]


def test_process_data_of_another_size_than_described_is_told():
    reports, _ = bus(DRIVE, DRIVE, DRIVE, None, at0={"output_bits": 80, "input_bits": 128}, at1={"input_bits": 0},
        at2={"output_bits": 57}, at3={"output_bits": 8})  # fmt: skip
    assert [report.notes for report in reports] == [
        ("bytes out: 10 configured, 8 in the default process image of the description",),
        ("bytes in: 0 configured, 16 in the default process image of the description",),
        (),
        (),
    ]
    assert [(report.output_bytes, report.input_bytes) for report in reports] == [(10, 16), (8, 0), (8, 16), (1, None)]


def listed_bits(*lines: str) -> tuple[int | None, int | None]:
    slave = as_listed(ScannedSlave(line=1, position=0, output_bits=80), read_pdos("\n".join(lines)).slaves)
    return slave.output_bits, slave.input_bits


def test_listed_pdos_are_configured():
    """Every SyncManager begins at a byte: 3 and 5 bits in two of them are two bytes."""
    sm = "SM{}: PhysAddr 0x1000, DefaultSize {:4}, ControlRegister 0x{:02x}, Enable 1"
    rx, entry = 'RxPDO 0x160{} "R"', 'PDO entry 0x7000:01, {} bit, "e"'
    outputs = (sm.format(2, 0, 0x64), rx.format(0), entry.format(3), rx.format(1), entry.format(4))
    assert listed_bits(*outputs) == (8, None)
    more = (sm.format(3, 0, 0x64), rx.format(2), entry.format(5))
    assert listed_bits(*outputs, *more) == (16, None)
    assert listed_bits(sm.format(2, 0, 0x64)) == (0, None)
    assert listed_bits(sm.format(3, 0, 0x20)) == (80, 0)
    assert listed_bits(sm.format(3, 4, 0x20)) == (80, None)
    assert listed_bits(sm.format(0, 0, 0x26), sm.format(1, 0, 0x22)) == (80, None)


def test_what_is_listed_of_virtual_pdos_is_no_other_size():
    """EL1252: 2 bits of inputs, and 34 bytes of registers at a virtual SyncManager."""
    sm, pdo = "SM{}: PhysAddr 0x1000, DefaultSize 0, ControlRegister 0x{:02x}, Enable 1", 'TxPDO 0x{:04x} "T"'
    entry = 'PDO entry 0x6000:01, {} bit, "e"'
    lines = (sm.format(0, 0x20), pdo.format(0x1A00), entry.format(2), sm.format(1, 0x00), pdo.format(0x1A13))
    lists = read_pdos("\n".join((*lines, *[entry.format(136)] * 2))).slaves
    terminal = TERMINAL._replace(output_bytes=0, input_bytes=1, output_bits=0, input_bits=2)
    slave = as_listed(ScannedSlave(line=1, position=0), lists)
    for virtual, notes in (
        ({(1, 0x1A13)}, ()),
        ({(1, 0x1A16)}, ("bytes in: 35 configured, 1 in the default process image of the description",)),
    ):
        (report,), _ = look_at_bus([(slave, with_virtual(terminal, lists, virtual))])
        assert (report.notes, report.input_bytes) == (notes, 35)


@pytest.mark.parametrize(
    ("told", "described_at"),
    [({}, (0,)), ({"output_bits": 8}, (0,)), ({"output_bits": 8, "input_bits": 0}, ())],
)
def test_bytes_are_those_of_the_description_where_the_scan_lacks_a_direction(told, described_at):
    _, summary = bus(TERMINAL, at0=told)
    assert summary.bytes_described_at == described_at


def test_ports_of_the_scan_say_what_is_on_the_e_bus():
    ports = (ScannedPort(number=0, kind="MII"), ScannedPort(number=1, kind="N/A"))
    reports, _ = bus(COUPLER, None, at1={"ports": ports, "e_bus_current_ma": 0})
    assert reports[1].e_bus_left_ma is None


def test_summary():
    _, summary = bus(
        TERMINAL, None, DRIVE, at0={"alias": 5}, at1={"alias": 5, "dc_capable": True, "dc_system_time": False}
    )
    assert summary.duplicate_aliases == {5: (0, 1)}
    assert (summary.output_bytes, summary.input_bytes) == (9, 18)
    assert (summary.bytes_unknown_at, summary.bytes_described_at) == ((1,), (0, 2))
    assert summary.reference_clock_candidate == 2
    assert summary.no_lrw_at == (2,)


SILENT = DeviceAtBus("YY", None, False, 0, 0, False)
CLOCK = DeviceAtBus("YY", None, False, 0, 0, False, potential_reference_clock=True)
NO_CLOCK = DeviceAtBus("YY", None, False, 0, 0, True, potential_reference_clock=False)


def clocks(*devices, **of_position):
    _, summary = bus(*devices, **of_position)
    return summary.reference_clock_candidate, summary.clock_unknown_at


def test_what_the_vendor_says_of_the_reference_clock_counts():
    assert clocks(CLOCK, NO_CLOCK) == (0, ())
    assert clocks(NO_CLOCK, DRIVE) == (1, ())
    assert clocks(NO_CLOCK, DRIVE, at0={"dc_capable": True, "dc_system_time": True}) == (1, ())
    assert clocks(CLOCK, DRIVE, at0={"dc_capable": True, "dc_system_time": False}) == (1, ())


def test_what_a_configuration_says_of_the_reference_clock_counts():
    """ENI (ETG.2100): the first slave with clocks cannot be it, the last one is it."""
    excluded = {"dc_capable": True, "potential_reference_clock": False, "reference_clock": False}
    assert clocks(CLOCK, CLOCK, CLOCK, at0=excluded) == (1, ())
    _, summary = bus(CLOCK, CLOCK, CLOCK, at0=excluded, at2={"dc_capable": True, "reference_clock": True})
    assert (summary.reference_clock_candidate, summary.reference_clock_at) == (1, (2,))


def test_a_clock_that_the_description_excludes_is_told():
    """ENI (ETG.2100): Slave/DC with ReferenceClock and CycleTime0; an AssignActivate of 0 is no SYNC0."""
    is_clock, sync0 = {"dc_capable": True, "reference_clock": True}, {"dc_capable": True, "sync0_cycle_ns": 1_000_000}
    with_sync0 = CLOCK._replace(supports_sync0=True)
    excluded = "configured as reference clock, which {} excludes: PotentialReferenceClock is false"
    no_sync0 = "SYNC0 is configured every 1000000 ns; no OpMode of its description generates it"
    for described, configured, notes in (
        (NO_CLOCK, is_clock, (excluded.format("its description"),)),
        (CLOCK, is_clock, ()),
        (SILENT, is_clock, ()),
        (None, is_clock | {"potential_reference_clock": False}, (excluded.format("the configuration itself"),)),
        (CLOCK, sync0, (no_sync0,)),
        (SILENT, sync0, (no_sync0,)),
        (with_sync0, sync0, ()),
        (CLOCK, sync0 | {"sync0_cycle_ns": 0}, ()),
        (None, sync0, ()),
    ):
        (report,), _ = bus(described, at0=configured)
        assert report.notes == notes


def test_a_slave_of_which_nothing_is_known_may_be_the_reference_clock():
    assert clocks(SILENT, None, DRIVE, SILENT) == (2, (0, 1))
    assert clocks(SILENT, None) == (None, (0, 1))
    assert clocks(SILENT, DRIVE, at0={"dc_capable": False, "dc_system_time": False}) == (1, ())


def test_a_system_time_is_told_by_the_master_or_by_a_description_that_synchronises():
    """``slaveinfo`` prints "Has DC: 1" also of a coupler that only measures delays, of which ESI files say nothing."""
    with_clock = {"dc_capable": True}
    for devices, scanned, known in (
        ((SILENT,), with_clock, False),
        ((None,), with_clock, False),
        ((None,), with_clock | {"dc_system_time": True}, True),
        ((DRIVE,), with_clock, True),
        ((CLOCK,), {}, True),
        ((NO_CLOCK,), with_clock, False),
    ):
        _, summary = bus(*devices, at0=scanned)
        assert summary.system_time_known is known
        assert (summary.reference_clock_candidate is None) == (devices == (NO_CLOCK,))


def test_slaves_that_are_not_listed_are_unknown():
    """Slave 0 feeds 2000 mA; what 1 and 2 take of it nobody says, and one of them may be the first with a clock."""
    reports, summary = bus(
        COUPLER._replace(dc_supported=False), TERMINAL, DRIVE, at1={"position": 3}, at2={"position": 4}
    )
    assert [report.e_bus_left_ma for report in reports] == [2000, None, None]
    assert reports[1].notes == ("slaves 1, 2 are not in the listing; the E-bus budget ends there",)
    assert summary.not_listed == summary.e_bus_unknown_at == summary.bytes_unknown_at == (1, 2)
    assert (summary.reference_clock_candidate, summary.clock_unknown_at) == (4, (0, 1, 2, 3))
    reports, summary = bus(TERMINAL, at0={"position": 3})
    assert reports[0].notes == (), "who lists one slave asks for that one"
    assert (summary.not_listed, summary.e_bus_unknown_at) == ((0, 1, 2), ())


def test_what_the_master_reports_of_failure_is_told():
    reports, _ = bus(
        None,
        None,
        None,
        None,
        at0={"failed": True, "state": "PREOP", "state_error": True, "master_device": "Backup"},
        at1={"state": "SAFEOP", "state_error": True, "al_status_code": 0x1E},
        at2={"al_status_code": 0x11},
        at3={"failed": False, "state": "OP", "state_error": False, "al_status_code": 0, "master_device": "Main"},
    )
    assert [report.notes for report in reports] == [
        (
            "the master reports that its scan or configuration failed (flag E)",
            "the slave reports an error in PREOP",
            "reached by the backup link of the master only",
        ),
        ("the slave reports an error in SAFEOP, AL status code 0x001E",),
        ("the slave reports an error, AL status code 0x0011",),
        (),
    ]


def test_an_empty_bus():
    reports, summary = look_at_bus([])
    assert reports == []
    assert summary.reference_clock_candidate is None
