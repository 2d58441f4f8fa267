"""Real outputs and ENI files: facts taken from them by hand."""

import zipfile

import pytest

from esicatalog.identity import Identity
from esicatalog.scan.front import read_eni, read_pdos, read_scan, read_sdos


@pytest.fixture(scope="module")
def cli(corpus):
    """Folder of printed outputs by repository."""
    return corpus / "cli"


@pytest.fixture(scope="module")
def scenario(cli):
    """Outputs of one bus in the layout without identity headings."""
    folder = cli / "linuxcnc-ethercat+linuxcnc-ethercat"
    return lambda name: (folder / f"tests__configgen__canned__scenario1__{name}.txt").read_text()


def test_slaves_in_a_fork_layout(scenario):
    scan = read_scan(scenario("slaves"))
    assert scan.format == "ethercat slaves -v"
    assert [(slave.master, slave.position, slave.identity, slave.name) for slave in scan.slaves] == [
        (0, 0, Identity(0x02, 0x07D83052, 0x00120000), "EL2008 8Ch. Dig. Output 24V, 0.5A"),
        (0, 1, Identity(0x02, 0x0C843052, 0x00100000), "EL3204 4Ch. Ana. Input PT100 (RTD)"),
        (0, 2, Identity(0xAB, 0x123, 0x00010000), "GenericServo X1"),
        (0, 3, Identity(0xCD, 0x456, 0x00010000), "UnknownPDO Module"),
    ]
    assert scan.findings == ()


def test_pdos_in_a_fork_layout(scenario):
    (slave,) = read_pdos(scenario("pdos_3")).slaves
    managers = slave.sync_managers
    assert [(manager.start_address, manager.size_bytes, manager.control) for manager in managers] == [
        (0x1000, 0, 0x26),
        (0x1400, 0, 0x22),
        (0x1800, 2, 0x24),
        (0x1C00, 4, 0x20),
    ]
    assert [sum(entry.bit_length for pdo in manager.pdos for entry in pdo.entries) for manager in managers] == [
        0,
        0,
        8,
        24,
    ]


def test_sdos_without_bit_lengths(scenario):
    (slave,) = read_sdos(scenario("sdos_2")).slaves
    entries = {found.index: found.entries for found in slave.objects}
    assert len(entries) == 10
    assert [entry.access for entry in entries[0x607A]] == ["rwrwrw"]
    assert [(entry.data_type, entry.bit_length) for entry in entries[0x6077]] == [("int16", None)]
    assert len(entries[0x1600]) == 11


def test_slaveinfo(cli):
    (path,) = cli.glob("ethercrab*/*soem-sdinfo*")
    scan = read_scan(path.read_text())
    assert scan.format == "SOEM slaveinfo"
    assert [(slave.name, slave.output_bits, slave.input_bits, slave.e_bus_current_ma) for slave in scan.slaves] == [
        ("EK1100", 0, 0, -2000),
        ("EL2004", 4, 0, 100),
        ("EL2004", 4, 0, 100),
        ("EL1004", 0, 4, 90),
        ("LAN9252-EVB-HBI", 16, 48, None),
        ("LAN9252-EVB-HBI", 16, 48, None),
    ], "0 mA is also printed where the SII says nothing"
    assert [slave.dc_delay_ns for slave in scan.slaves] == [0, 145, 290, 445, 1485, 2205]
    assert scan.slaves[3].identity == Identity(2, 0x03EC3052, 0x00130000)
    assert scan.slaves[4].mailbox_protocols == ("CoE",)
    assert all(slave.dc_capable and slave.not_lrw is False for slave in scan.slaves)
    assert [finding.line for finding in scan.findings] == [1], "the clock times before the list"


def test_pdos_of_real_eeproms(corpus):
    paths = sorted((corpus / "igh").glob("*.pdos.txt"))
    assert len(paths) > 30
    for path in paths:
        text = path.read_text()
        (slave,) = (scan := read_pdos(text)).slaves
        assert scan.findings == ()
        pdos = [pdo for manager in slave.sync_managers for pdo in manager.pdos]
        assert len(slave.sync_managers) == text.count("PhysAddr")
        assert len(pdos) == text.count("xPDO 0x")
        assert sum(len(pdo.entries) for pdo in pdos) == text.count("PDO entry")
    (akd,) = read_pdos(next(path for path in paths if "akd.hex" in path.name).read_text()).slaves
    (rx_pdo,) = akd.sync_managers[2].pdos
    assert (rx_pdo.index, rx_pdo.is_rx, rx_pdo.name) == (0x1701, True, "Outputs")
    assert [(entry.index, entry.subindex, entry.bit_length, entry.name) for entry in rx_pdo.entries] == [
        (0x60C1, 1, 32, "1st set-point"),
        (0x6040, 0, 16, "Controlword"),
    ]


def member(corpus, archive: str, name: str) -> bytes:
    with zipfile.ZipFile(corpus / "esi" / archive) as opened:
        return opened.read(name)


def test_eni_of_soem(corpus):
    scan = read_eni(member(corpus, "OpenEtherCATsociety+SOEM.zip", "samples/eni_test/sample-eni.xml"))
    assert [(slave.name, slave.identity, slave.mailbox_in_bytes) for slave in scan.slaves] == [
        ("Sample device A", Identity(1, 0x1234, 0), 128),
        ("Sample device B", Identity(1, 0x010055AA, 0), 256),
    ]
    assert scan.findings == ()


def test_eni_of_twincat(corpus):
    scan = read_eni(member(corpus, "kpierczy+ethercat-lib.zip", "tests/data/test_eni.xml"))
    assert [(slave.position, slave.configured_address, slave.identity) for slave in scan.slaves] == [
        (0, 1001, Identity(33, 1, 65537)),
        *((position, 1001 + position, Identity(154, 198948, 66592)) for position in range(1, 5)),
    ]
    assert [slave.name for slave in scan.slaves][:2] == ["Imu", "WheelRearLeft"]
    assert [(slave.output_bits, slave.input_bits) for slave in scan.slaves] == [(0, 112), *[(48, 112)] * 4]
    assert [slave.reference_clock for slave in scan.slaves] == [None, True, False, False, False]
    assert scan.slaves[0].mailbox_protocols == ("CoE", "FoE")
    assert scan.findings == ()
