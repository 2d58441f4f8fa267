"""Recognition by content, clear errors, and texts that try to break the readers."""

import contextlib
import signal
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from esicatalog.errors import InputError
from esicatalog.scan.front import read_pdos, read_scan, read_sdos
from esicatalog.scan.records import ScanError

FRAGMENTS = [
    "=== Master 0, Slave 0 ===",
    "=== Slave 1 ===",
    "  Vendor Id:       0x00000002",
    "  Product code:    0x0",
    "  Revision number: ",
    "State: SAFEOP+ERROR",
    "State",
    "   0* MII   up    open    yes             -",
    "  Standard  RX: 0x1000/128, TX: 0x1080/128",
    "  Supported protocols: CoE, ",
    "    Enable SDO: maybe",
    "  Current consumption: -2000 mA",
    "Slave:1",
    "Slave:2",
    " Name:EL2004",
    " State: 255",
    " Man: 00000002 ID: 044c2c52 Rev: 00120000",
    " SM0 A:0f00 L:   1 F:00090044 Type:3",
    " MBX length wr: 128 rd: 128 MBX protocols : ff",
    " CoE details: 00 FoE details: 00",
    " only LRD/LWR:0",
    "ec_init on eth0 succeeded.",
    "9 slaves found and configured.",
    "Slave 1 State=12 StatusCode=  1d : Invalid",
    "0  0:0  PREOP  +  EK1100",
    "1  1:0  ???  E  0x00000002:0x00000003",
    "Master1",
    "xxx LINK FAILURE xxx",
    "SM0: PhysAddr 0x1000, DefaultSize    0, ControlRegister 0x26, Enable 1",
    '  RxPDO 0x1600 "Outputs"',
    '    PDO entry 0x7000:01,  1 bit, "Control',
    'SDO 0x1000, "Device type"',
    '  0x1000:00, r-r-r-, uint32, 32 bit, "Device type"',
    "vendor,product,revision",
    "0x2,0x3,0x4",
    "2;x",
    ",,,",
    "",
    "\x1b[1m",
    "[ 12.3]",
    "# ",
]
anything = st.text() | st.lists(st.sampled_from(FRAGMENTS) | st.text(max_size=5), max_size=12).map("\n".join)


@given(anything)
@settings(max_examples=300, deadline=None)
def test_any_text_gives_records_or_the_exception(text):
    for read in (read_scan, read_pdos, read_sdos):
        try:
            scan = read(text)
        except ScanError as error:
            assert "\n" not in str(error)
            continue
        last_line = text.count("\n") + text.count("\r") + 1
        assert all(0 < finding.line <= last_line for finding in scan.findings)
        assert all("\n" not in finding.message for finding in scan.findings)
        assert all(0 < slave.line <= last_line for slave in scan.slaves)


@pytest.mark.parametrize("text", ["", " \n\t\r\n", "\ufeff", "\x1b[0m\n"])
def test_empty_text(text):
    with pytest.raises(ScanError, match=r"^the text is empty; expected what a master printed about its slaves$"):
        read_scan(text)


@pytest.mark.parametrize("text", ["hello", "Master0\n  Phase: Idle\n", "[{}]", "<EtherCATInfo/>", "\udc80\n\x00"])
def test_unrecognised_text(text):
    with pytest.raises(ScanError) as caught:
        read_scan(text)
    assert isinstance(caught.value, InputError)
    message = str(caught.value)
    assert message.startswith("no scan is recognised; expected `ethercat slaves -v` or `ethercat slaves` (IgH)")
    assert message.isascii() and "\n" not in message and len(message) < 400


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("=== Master 0, Slave 0 ===\n", "ethercat slaves -v"),
        ("  0  0:0  INIT  E  \n", "ethercat slaves"),
        ("Slave:1\n", "SOEM slaveinfo"),
        ("2,3", "CSV"),
    ],
)
def test_recognition(text, name):
    assert read_scan(text).format == name


def test_broken_bytes_are_kept_in_names():
    scan = read_scan(b"0  0:0  PREOP  +  EL1252, 1\xb5s\n".decode("utf-8", "replace"))
    assert scan.slaves[0].name == "EL1252, 1\ufffds"
    scan = read_scan(b"0  0:0  PREOP  +  EL1252, 1\xb5s\n".decode("utf-8", "surrogateescape"))
    assert scan.slaves[0].name == "EL1252, 1\udcb5s"


MANY = 1_000_000
"""Read in a second or less; in hours, if the time grew with the square of the length."""


@contextlib.contextmanager
def ending(cpu_seconds: int = 60) -> Iterator[None]:
    """Fails when the block takes so much of a processor, however busy the machine is; expressions are interrupted."""

    def give_up(*_: Any) -> None:
        raise AssertionError(f"not read within {cpu_seconds} s of a processor")

    before = signal.signal(signal.SIGVTALRM, give_up)
    signal.setitimer(signal.ITIMER_VIRTUAL, cpu_seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


@pytest.mark.parametrize(
    "text",
    [
        " " * MANY + "x",
        "abc 0:=S\t," * (MANY // 10),
        "=" * MANY,
        "[a] " * (MANY // 4),
        "\x1b[" + "0" * MANY,
        "=== Slave 0 ===\nDevice name: " + " " * MANY + "x",
        "Slave:1\n Man:" + " " * MANY + "x",
        "ec_init on " + "a " * (MANY // 2) + "\nSlave:1\n",
        "0" + " " * MANY,
        "2" + "," * MANY,
        "0x" + "0" * MANY + ",1",
        'SM0: PhysAddr 0x1, DefaultSize 1, ControlRegister 0x4, Enable 1\n RxPDO 0x1600 "' + " " * MANY + "x",
        'SDO 0x1000, "' + '" ' * (MANY // 2) + "x",
        'SDO 0x1000, "a"\n  0x1000:00, ' + "a " * (MANY // 2),
    ],
    ids=lambda text: ascii(text[:20].strip()),
)
def test_the_time_for_a_long_line_does_not_grow_with_its_square(text):
    for read in (read_scan, read_pdos, read_sdos):
        with ending(), contextlib.suppress(ScanError):
            read(text)


def test_ten_megabytes_of_garbage_below_a_heading():
    text = "=== Slave 0 ===\n" + ("Group 0:=S\t,abc " * 20 + "\n") * 31_000
    with ending():
        scan = read_scan(text)
    assert len(scan.slaves) == 1
    assert len(scan.findings) == 2
