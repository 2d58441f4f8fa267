"""``ethercat slaves -v`` and ``ethercat slaves``: layouts of the tool's releases, oddities of pasted terminals."""

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from esicatalog.identity import Identity
from esicatalog.scan.front import read_pdos, read_scan
from esicatalog.scan.records import ScanError, ScannedCoe, ScannedPort, ScannedSlave

STABLE = """\
=== Master 0, Slave 0 ===
Device: Main
State: PREOP
Flag: +
Identity:
  Vendor Id:       0x00000002
  Product code:    0x044c2c52
  Revision number: 0x00120000
  Serial number:   0x00000000
DL information:
  FMMU bit operation: no
  Distributed clocks: yes, delay measurement only
  DC system time transmission delay: 0 ns
Port  Type  Link  Loop    Signal  NextSlave  RxTime [ns]  Diff [ns]   NextDc [ns]
   0* MII   up    open    yes             -   3589123456           0           0
   1  EBUS  up    open    yes             1   3589123886         430         140
   2  MII   down  closed  no              -            -           -           -
   3  N/A   down  closed  no              -            -           -           -
General:
  Group: SystemBk
  Image name:
  Order number: EK1100
  Device name: EK1100 EtherCAT-Koppler (2A E-Bus)
  Flags:
    Enable SafeOp: no
    Enable notLRW: no
  Current consumption: -2000 mA
=== Master 0, Slave 1 ===
Alias: 4711
Device: Backup
State: SAFEOP+ERROR
Flag: E
Identity:
  Vendor Id:       0x0000066f
  Product code:    0x515050a1
  Revision number: 0x00010000
  Serial number:   0x000001a4
SII:
  Parallel read: 4 words
DL information:
  FMMU bit operation: yes
  Distributed clocks: yes, 64 bit
  DC system time transmission delay: 655 ns
Port  Type  Link  Loop    Signal  NextSlave  RxTime [ns]  Diff [ns]   NextDc [ns]
   0  EBUS  up    open    yes             0            0           0           0
   1  N/C   down  closed  no              -            -           -           -
Mailboxes:
  Bootstrap RX: 0x1000/512, TX: 0x1400/512
  Standard  RX: 0x1000/256, TX: 0x1200/192
  Supported protocols: EoE, CoE, FoE
General:
  Group: Drive
  Image name: DRIVE
  Order number: MADHT1505BA1
  Device name: Servo: type A
  CoE details:
    Enable SDO: yes
    Enable SDO Info: yes
    Enable PDO Assign: yes
    Enable PDO Configuration: no
    Enable Upload at startup: no
    Enable SDO complete access: yes
  Flags:
    Enable SafeOp: yes
    Enable notLRW: yes
  Current consumption: 0 mA
"""

COUPLER = ScannedSlave(
    line=1,
    master=0,
    position=0,
    vendor_id=2,
    product_code=0x044C2C52,
    revision_no=0x00120000,
    serial_no=0,
    name="EK1100 EtherCAT-Koppler (2A E-Bus)",
    order_number="EK1100",
    group="SystemBk",
    state="PREOP",
    state_error=False,
    failed=False,
    master_device="Main",
    e_bus_current_ma=-2000,
    dc_capable=True,
    dc_system_time=False,
    dc_delay_ns=0,
    not_lrw=False,
    ports=(
        ScannedPort(number=0, kind="MII", link_up=True),
        ScannedPort(number=1, kind="EBUS", link_up=True),
        ScannedPort(number=2, kind="MII", link_up=False),
        ScannedPort(number=3, kind="N/A", link_up=False),
    ),
)
DRIVE = ScannedSlave(
    line=28,
    master=0,
    position=1,
    alias=4711,
    vendor_id=0x66F,
    product_code=0x515050A1,
    revision_no=0x10000,
    serial_no=420,
    name="Servo: type A",
    order_number="MADHT1505BA1",
    group="Drive",
    state="SAFEOP",
    state_error=True,
    failed=True,
    master_device="Backup",
    e_bus_current_ma=0,
    dc_capable=True,
    dc_system_time=True,
    dc_system_time_bits=64,
    dc_delay_ns=655,
    not_lrw=True,
    mailbox_protocols=("EoE", "CoE", "FoE"),
    mailbox_out_bytes=256,
    mailbox_in_bytes=192,
    coe=ScannedCoe(
        sdo=True,
        sdo_info=True,
        pdo_assign=True,
        pdo_configuration=False,
        upload_at_startup=False,
        complete_access=True,
    ),
    ports=(
        ScannedPort(number=0, kind="EBUS", link_up=True),
        ScannedPort(number=1, kind="N/C", link_up=False),
    ),
)


def messages(scan) -> list[tuple[int, str]]:
    return [(finding.line, finding.message) for finding in scan.findings]


def test_stable_layout():
    scan = read_scan(STABLE)
    assert scan.format == "ethercat slaves -v"
    assert scan.slaves == (COUPLER, DRIVE)
    assert scan.findings == ()
    assert scan.slaves[1].identity == Identity(0x66F, 0x515050A1, 0x10000)


def test_layout_of_release_1_4():
    scan = read_scan(
        "=== Slave 3 ===\nAlias: 5\nState: OP\nFlag: +\nIdentity:\n  Vendor Id:       0x00000002\n"
        "  Product code:    0x0c1e3052\n  Revision number: 0x00100000\n  Serial number:   0x00000000\n"
        "Mailboxes:\n  RX: 0x1800/246, TX: 0x18f6/246\n  Supported protocols: CoE\n"
        "General:\n  Group: AnaIn\n  Image name: TERM_EL\n  Order number: EL3102\n  Device name: \n"
        "  CoE details:\n    Enable Sdo: yes\n    Enable Sdo Info: yes\n    Enable Pdo Assign: no\n"
        "    Enable Pdo Configuration: no\n    Enable Upload at startup: no\n    Enable Sdo complete access: no\n"
        "  Flags:\n    Enable SafeOp: no\n    Enable notLRW: no\n  Current consumption: 170 mA\n"
    )
    (slave,) = scan.slaves
    assert (slave.master, slave.position, slave.alias, slave.state) == (None, 3, 5, "OP")
    assert (slave.mailbox_out_bytes, slave.mailbox_in_bytes, slave.e_bus_current_ma) == (246, 246, 170)
    assert slave.coe == ScannedCoe(
        sdo=True,
        sdo_info=True,
        pdo_assign=False,
        pdo_configuration=False,
        upload_at_startup=False,
        complete_access=False,
    )
    assert slave.dc_capable is None, "this release does not print the clocks"
    assert slave.name is None
    assert scan.findings == ()


def test_layout_without_identity_heading():
    scan = read_scan(
        "=== Master 0, Slave 0 ===\n  State: PREOP\n  Vendor Id: 0x00000002\n  Product code: 0x07d83052\n"
        "  Revision number: 0x00120000\n  Device name: EL2008\n"
    )
    (slave,) = scan.slaves
    assert slave.identity == Identity(2, 0x07D83052, 0x120000)
    assert (slave.failed, slave.serial_no, slave.mailbox_protocols, slave.e_bus_current_ma) == (None,) * 4
    assert scan.findings == ()


@pytest.mark.parametrize(
    ("printed", "capable", "system_time", "bits"),
    [
        ("no", False, False, None),
        ("yes, delay measurement only", True, False, None),
        ("yes, 32 bit", True, True, 32),
        ("yes, 64 bit", True, True, 64),
        ("yes, ???", True, True, None),
    ],
)
def test_distributed_clocks(printed, capable, system_time, bits):
    (slave,) = read_scan(
        STABLE[: STABLE.index("=== Master 0, Slave 1")].replace("yes, delay measurement only", printed)
    ).slaves
    assert (slave.dc_capable, slave.dc_system_time, slave.dc_system_time_bits) == (capable, system_time, bits)


def test_masters_are_separate_buses():
    scan = read_scan(STABLE + STABLE.replace("Master 0", "Master 1"))
    assert [(slave.master, slave.bus, slave.position) for slave in scan.slaves] == [
        (0, 0, 0),
        (0, 0, 1),
        (1, 1, 0),
        (1, 1, 1),
    ]
    assert scan.findings == ()


def test_the_same_output_twice_is_one_bus():
    scan = read_scan(STABLE + STABLE)
    assert scan.slaves == (COUPLER, DRIVE)
    assert messages(scan) == [(67, "the listing repeats the one from line 1; it is read once")]


SECOND = STABLE[STABLE.index("=== Master 0, Slave 1") :]


def test_a_part_of_the_output_again_is_no_other_bus():
    scan = read_scan(STABLE + SECOND)
    assert scan.slaves == (COUPLER, DRIVE)
    assert messages(scan) == [(67, f"the listing repeats the one from line {DRIVE.line}; it is read once")]


def test_a_listing_may_go_on_behind_what_it_repeats():
    further = SECOND.replace("Slave 1", "Slave 2")
    scan = read_scan(STABLE + SECOND + further)
    assert [(slave.bus, slave.position) for slave in scan.slaves] == [(0, 0), (0, 1), (0, 2)]
    assert messages(scan) == [(67, f"a part of the listing repeats the one from line {DRIVE.line}; it is read once")]


def test_an_earlier_bus_again_is_no_third_one():
    other = STABLE.replace("0x515050a1", "0x515050a2")
    scan = read_scan(STABLE + other + STABLE)
    assert [slave.bus for slave in scan.slaves] == [0, 0, 1, 1]
    assert messages(scan)[-1] == (133, "the listing repeats the one from line 1; it is read once")


def test_another_listing_of_the_same_master_is_kept():
    scan = read_scan(STABLE + STABLE.replace("0x515050a1", "0x515050a2"))
    assert [(slave.bus, slave.position) for slave in scan.slaves] == [(0, 0), (0, 1), (1, 0), (1, 1)]
    assert messages(scan) == [(67, "positions are listed again with other slaves; kept apart as another bus")]


@pytest.mark.parametrize(
    ("text", "first", "second"),
    [
        (STABLE, "0x000001a4", "0x000001a5"),
        (STABLE, "Alias: 4711", "Alias: 4712"),
        ("0  0:0  PREOP  +  Coupler\n1  0:1  PREOP  +  Drive A\n", "Drive A", "Drive B"),
        ("0  0:0  PREOP  +  Coupler\n1  7:0  PREOP  +  Drive\n", "7:0", "8:0"),
    ],
)
def test_other_slaves_are_known_by_name_serial_number_and_alias_too(text, first, second):
    assert len(read_scan(text + text).slaves) == 2
    scan = read_scan(text + text.replace(first, second))
    assert [(slave.bus, slave.position) for slave in scan.slaves] == [(0, 0), (0, 1), (1, 0), (1, 1)]
    assert messages(scan)[-1][1] == "positions are listed again with other slaves; kept apart as another bus"


def test_single_slaves_printed_one_after_the_other_are_one_bus():
    first, second = STABLE[: STABLE.index("=== Master 0, Slave 1")], STABLE[STABLE.index("=== Master 0, Slave 1") :]
    scan = read_scan(second + first)
    assert [(slave.bus, slave.position) for slave in scan.slaves] == [(0, 1), (0, 0)]
    assert scan.findings == ()


def test_terminal_decoration():
    colours = STABLE.replace("PREOP", "\x1b[1;32mPREOP\x1b[0m")
    for text in (
        "\ufeff" + STABLE.replace("\n", "\r\n"),
        colours,
        "".join(f"[  12.{number:06}] {line}\n" for number, line in enumerate(STABLE.splitlines())),
        "".join(f"2024-03-01T10:00:00.123Z {line}\n" for line in STABLE.splitlines()),
        "".join(f"Mar  1 10:00:00 rpi ecscan[812]: {line}\n" for line in STABLE.splitlines()),
        "".join(f"10:00:00,5 {line}\n" for line in STABLE.splitlines()),
        "".join(f"> {line}\n" for line in STABLE.splitlines()),
        "".join(f"// {line}\n" for line in STABLE.splitlines()),
        "".join(f"# {line}\n" for line in STABLE.splitlines()),
    ):
        scan = read_scan(text)
        assert scan.slaves == (COUPLER, DRIVE)
        assert scan.findings == ()


def test_lines_that_were_joined_are_read_apart():
    """A name ends where the key follows that the tool prints next."""
    lines = STABLE.splitlines()
    for number in range(1, len(lines)):
        scan = read_scan(
            "\n".join([*lines[: number - 1], " ".join(lines[number - 1 : number + 1]), *lines[number + 1 :]])
        )
        assert (without_lines(scan.slaves), scan.findings) == (without_lines((COUPLER, DRIVE)), ())
    for joined in (" ".join(lines), " ".join(STABLE.split())):
        scan = read_scan(joined + "\n")
        assert (without_lines(scan.slaves), scan.findings) == (without_lines((COUPLER, DRIVE)), ())
    (_, drive) = (scan := read_scan(STABLE.replace("Servo: type A", "Servo Device: type A"))).slaves
    assert (drive.name, drive.not_lrw, scan.findings) == ("Servo Device: type A", True, ())


@pytest.mark.parametrize(
    ("field", "key", "value"),
    [
        ("group", "Group", "Servo Device name: AX5000"),
        ("group", "Group", "Drives, order number: see label"),
        ("group", "Group", "Meter Current consumption: AC"),
        ("group", "Group", "Camera Image name: raw"),
        ("order_number", "Order number", "7 Device name: 8"),
        *(
            ("name", "Device name", f"Foo {words}")
            for words in (
                *("=== Slave X ===", "=== Slave 7 ===", "=== Master 0, Slave 1 ===", "=== Slave 7 === Alias: 9"),
                *("General:", "Flags:", "Identity:", "SII:", "Rx: 1", "Rx: 0x1000/1, TX: 0x1000/1", "Alias: 5"),
                *("Flags: 2", "CoE details: 2", "Enable SDO: yes", "2 MII up to 3", "2 MII up open to 3"),
                *("Port Type 3", "Servo Rx: 3 Flags: 2", "Supported protocols: CoE"),
            )
        ),
    ],
)
@pytest.mark.parametrize("number", [0, 1])
def test_words_like_keys_are_no_items_where_no_line_was_joined(number, field, key, value):
    """The coupler has neither mailbox nor alias: their keys begin no line."""
    told = {"group": ("SystemBk", "Drive"), "order_number": ("EK1100", "MADHT1505BA1")}
    name = (told | {"name": (COUPLER.name, DRIVE.name)})[field][number]
    scan = read_scan(STABLE.replace(f"{key}: {name}\n", f"{key}: {value}\n"))
    expected = [COUPLER, DRIVE]
    expected[number] = msgspec.structs.replace(expected[number], **{field: value})
    assert (scan.slaves, scan.findings) == (tuple(expected), ())


def test_what_the_kernel_writes_between_the_lines_gives_no_alias():
    scan = read_scan(STABLE.replace("DL information:\n", "EtherCAT 0: slave Alias: 5\nDL information:\n", 1))
    assert (without_lines(scan.slaves), len(scan.findings)) == (without_lines((COUPLER, DRIVE)), 1)


def test_a_joined_line_that_is_not_understood_is_told():
    """The kernel writes into the same terminal."""
    scan = read_scan(STABLE.replace("DL information:\n", "DL information: [ 12.1] x\n", 1))
    assert scan.slaves == (COUPLER, DRIVE)
    assert messages(scan) == [
        (10, "1 line is not read as `ethercat slaves -v`; the first: 'DL information: [ 12.1] x'")
    ]
    lost = read_scan(STABLE.replace("-2000 mA\n=== Master 0, Slave 1 ===\n", "-2000 mA === Master 0, Slave 1 ==\n"))
    assert (lost.slaves, len(lost.findings)) == ((COUPLER,), 2)


def without_lines(slaves: tuple[ScannedSlave, ...]) -> list[ScannedSlave]:
    return [msgspec.structs.replace(slave, line=0) for slave in slaves]


def test_what_programs_write_into_terminals_beside_colours():
    """``tput sgr0`` of most terminals is ESC ( B ESC [ m; OSC sets titles, ended by BEL or ESC and a backslash."""
    heading = "=== Master 0, Slave 1 ==="
    for decorated in (f"{heading}\x1b(B\x1b[m", f"\x1b]0;title\x07{heading}", f"\x1b]8;;x\x1b\\{heading}"):
        assert read_scan(STABLE.replace(heading, decorated)).slaves == (COUPLER, DRIVE)


def test_what_stands_below_a_broken_heading_is_of_no_slave():
    """Slave 0 has no alias; "Alias: 4711" is of slave 1, whose heading is cut."""
    scan = read_scan(STABLE.replace("Slave 1 ===", "Slave 1 =="))
    assert scan.slaves == (COUPLER,)
    assert messages(scan)[0] == (
        28,
        "no heading, though it begins like one; what stands below it is left out: '=== Master 0, Slave 1 =='",
    )
    general = STABLE.index("General:")
    lost = STABLE[:general] + STABLE[STABLE.index("Device: Backup") :]
    (slave,) = read_scan(lost).slaves
    assert (slave.name, slave.e_bus_current_ma, slave.mailbox_protocols) == (None, None, None)


def test_what_stands_around_the_output_is_told_once():
    scan = read_scan(f"user@rpi:~$ ethercat slaves -v\n{STABLE}user@rpi:~$ exit\nlogout\n")
    assert [slave.line for slave in scan.slaves] == [2, 29]
    assert messages(scan) == [
        (1, "3 lines are not read as `ethercat slaves -v`; the first: 'user@rpi:~$ ethercat slaves -v'")
    ]


def test_a_slave_without_identity_stays_in_the_list():
    scan = read_scan("=== Master 0, Slave 7 ===\nDevice: Main\nState: INIT\nFlag: E\n")
    (slave,) = scan.slaves
    assert (slave.position, slave.state, slave.failed, slave.identity) == (7, "INIT", True, None)
    assert messages(scan) == [(1, "slave 7 has no vendor id, product code, revision number; kept without")]


def test_an_unread_sii_is_told():
    identity = "  Vendor Id:       0x00000000\n  Product code:    0x00000000\n  Revision number: 0x00000000\n"
    scan = read_scan(f"=== Master 0, Slave 0 ===\nIdentity:\n{identity}")
    assert scan.slaves[0].identity == Identity(0, 0, 0)
    assert messages(scan) == [(1, "slave 0 has vendor id and product code 0: its SII was not read or is empty")]


def test_an_unknown_value_is_not_taken():
    scan = read_scan(STABLE.replace("0x044c2c52", "0xWRONG").replace("SAFEOP+ERROR", "???"))
    assert scan.slaves[0].product_code is None
    assert (scan.slaves[1].state, scan.slaves[1].state_error) == (None, None)
    assert messages(scan) == [
        (1, "slave 0 has no product code; kept without"),
        (7, "not understood or cut off: 'Product code:    0xWRONG'"),
    ]


def test_an_unclear_flag_is_not_taken():
    scan = read_scan(STABLE.replace("Enable SDO Info: yes", "Enable SDO Info: maybe"))
    assert scan.slaves[1].coe.sdo_info is None
    assert scan.slaves[1].coe.sdo is True
    assert messages(scan) == [(58, "not understood or cut off: 'Enable SDO Info: maybe'")]


def test_words_without_a_colon_are_no_values():
    scan = read_scan(STABLE.replace("DL information:\n", "DL information:\nState\nalias\n", 1))
    assert scan.slaves[0].state == "PREOP"
    assert messages(scan) == [(11, "2 lines are not read as `ethercat slaves -v`; the first: 'State'")]


def test_output_of_config_below_a_slave_does_not_change_it():
    config = "Alias: 0\nPosition: 9\nVendor Id: 0x00000099\nProduct code: 0x00000099\n"
    scan = read_scan(STABLE + config)
    assert scan.slaves == (COUPLER, msgspec.structs.replace(DRIVE, alias=4711))


def test_lists_of_pdos_and_sdos_in_the_same_text_are_no_slaves():
    pdos = (
        "=== Master 0, Slave 0 ===\n"
        "=== Master 0, Slave 1 ===\n"
        "SM2: PhysAddr 0x1100, DefaultSize    6, ControlRegister 0x64, Enable 1\n"
        '  RxPDO 0x1600 "Outputs"\n    PDO entry 0x6040:00, 16 bit, "Controlword"\n'
    )
    sdos = '=== Master 0, Slave 1 ===\nSDO 0x1000, "Device type"\n  0x1000:00, r-r-r-, uint32, 32 bit, "Device type"\n'
    assert read_scan(STABLE + pdos + sdos).slaves == (COUPLER, DRIVE)
    (of_drive,) = read_pdos(STABLE + pdos + sdos).slaves
    assert (of_drive.master, of_drive.position) == (0, 1)
    for alone in (pdos[pdos.index("=== Master 0, Slave 1") :], sdos):
        with pytest.raises(ScanError, match="no scan is recognised"):
            read_scan(alone)
        with pytest.raises(ScanError, match="no slave in the output"):
            read_scan(alone.replace("===\n", "===\nnoise\n"))


def test_table():
    scan = read_scan(
        "$ ethercat slaves\n"
        "0     0:0  PREOP   +  EK1100 EtherCAT-Koppler (2A E-Bus)\n"
        "1  5555:0  SAFEOP  E  0x00000002:0x07d43052\n"
        "2  5555:1  OP      +  Servo\n"
    )
    assert scan.format == "ethercat slaves"
    first, second, third = scan.slaves
    assert (first.line, first.position, first.alias, first.state, first.failed) == (2, 0, None, "PREOP", False)
    assert (first.name, first.identity) == ("EK1100 EtherCAT-Koppler (2A E-Bus)", None)
    assert (second.alias, second.state, second.failed) == (5555, "SAFEOP", True)
    assert (second.name, second.identity) == (None, Identity(2, 0x07D43052))
    assert third.alias is None, "5555 is the alias of the slave before it"
    assert (2, "slaves that show a name instead of an identity: 2; `ethercat slaves -v` shows both") in messages(scan)


def test_table_of_an_older_tool():
    """It writes identities without 0x."""
    scan = read_scan("0  0:0  OP     +  0000009a:00030924\n1  0:1  PREOP  +  00000083:00000005\n")
    assert [slave.identity for slave in scan.slaves] == [Identity(0x9A, 0x30924), Identity(0x83, 5)]
    assert [slave.name for slave in scan.slaves] == [None, None]
    assert scan.findings == ()


def test_table_of_several_masters_with_a_broken_ring():
    scan = read_scan(
        "Master0\n  0  0:0  OP+ERROR  +  A\nMaster1\n  0  0:0  ???  E\nxxx LINK FAILURE xxx\n  1  0:1  BOOT  +  B\n"
    )
    assert [(slave.master, slave.bus, slave.position, slave.state, slave.name) for slave in scan.slaves] == [
        (0, 0, 0, "OP", "A"),
        (1, 1, 0, None, None),
        (1, 1, 1, "BOOT", "B"),
    ]
    assert scan.slaves[0].state_error is True
    assert (5, "link failure: the slaves below are reached by the backup device only") in messages(scan)


def test_the_detailed_output_is_read_where_the_text_has_both():
    scan = read_scan("0  0:0  PREOP  +  EK1100\n1  4711:0  SAFEOP+ERROR  E  Servo\n" + STABLE)
    assert scan.format == "ethercat slaves -v"
    assert [slave.identity for slave in scan.slaves] == [COUPLER.identity, DRIVE.identity]


uint32 = st.integers(0, 0xFFFF_FFFF)
size = st.integers(0, 0xFFFF)
string = (
    st.text(st.characters(exclude_categories=("Cc", "Cs")), max_size=12).map(str.strip).map(lambda text: text or None)
)
yes_no = st.booleans()
clocks = st.sampled_from(
    [
        {"dc_capable": False, "dc_system_time": False},
        {"dc_capable": True, "dc_system_time": False, "dc_delay_ns": 145},
        {"dc_capable": True, "dc_system_time": True, "dc_system_time_bits": 32, "dc_delay_ns": 0},
        {"dc_capable": True, "dc_system_time": True, "dc_system_time_bits": 64, "dc_delay_ns": 4294967295},
    ]
)
port = st.tuples(st.sampled_from(["EBUS", "MII", "N/A", "N/C"]), yes_no)
protocols = st.sets(st.sampled_from(["AoE", "EoE", "CoE", "FoE", "SoE", "VoE"]), min_size=1)


@st.composite
def slaves(draw):
    """Facts of one slave that the stable layout prints."""
    facts = {
        "alias": draw(st.none() | st.integers(1, 0xFFFF)),
        "master_device": draw(st.sampled_from(["Main", "Backup"])),
        "state": draw(st.sampled_from(["INIT", "PREOP", "BOOT", "SAFEOP", "OP"])),
        "state_error": draw(yes_no),
        "failed": draw(yes_no),
        "vendor_id": draw(uint32),
        "product_code": draw(uint32.filter(bool)),
        "revision_no": draw(uint32),
        "serial_no": draw(uint32),
        "ports": tuple(
            ScannedPort(number=number, kind=kind, link_up=up)
            for number, (kind, up) in enumerate(draw(st.lists(port, min_size=4, max_size=4)))
        ),
        **draw(clocks),
    }
    spoken = draw(st.none() | protocols)
    if spoken:
        facts |= {
            "mailbox_protocols": tuple(sorted(spoken)),
            "mailbox_out_bytes": draw(size),
            "mailbox_in_bytes": draw(size),
        }
    if draw(yes_no):
        facts |= {
            "group": draw(string),
            "order_number": draw(string),
            "name": draw(string),
            "not_lrw": draw(yes_no),
            "e_bus_current_ma": draw(st.integers(-0x8000, 0x7FFF)),
        }
        if spoken and "CoE" in spoken:
            facts["coe"] = ScannedCoe(
                **{field: draw(yes_no) for field in ScannedCoe.__struct_fields__},
            )
    return facts


def printed(master: int, position: int, facts: dict) -> str:
    """The block of a slave in the layout of the stable releases."""

    def answer(value: bool) -> str:
        return "yes" if value else "no"

    lines = [f"=== Master {master}, Slave {position} ==="]
    if facts["alias"]:
        lines.append(f"Alias: {facts['alias']}")
    lines += [
        f"Device: {facts['master_device']}",
        f"State: {facts['state']}{'+ERROR' if facts['state_error'] else ''}",
        f"Flag: {'E' if facts['failed'] else '+'}",
        "Identity:",
        f"  Vendor Id:       0x{facts['vendor_id']:08x}",
        f"  Product code:    0x{facts['product_code']:08x}",
        f"  Revision number: 0x{facts['revision_no']:08x}",
        f"  Serial number:   0x{facts['serial_no']:08x}",
        "DL information:",
        "  FMMU bit operation: no",
    ]
    if facts["dc_capable"]:
        bits = facts.get("dc_system_time_bits")
        lines += [
            f"  Distributed clocks: yes, {f'{bits} bit' if bits else 'delay measurement only'}",
            f"  DC system time transmission delay: {facts['dc_delay_ns']} ns",
        ]
    else:
        lines.append("  Distributed clocks: no")
    lines.append("Port  Type  Link  Loop    Signal  NextSlave")
    for port in facts["ports"]:
        link = f"{'up' if port.link_up else 'down':4}  {'open' if port.link_up else 'closed':6}"
        lines.append(f"   {port.number}  {port.kind:4}  {link}  {answer(port.link_up):6}  {'-':>9}")
    if "mailbox_protocols" in facts:
        lines += [
            "Mailboxes:",
            "  Bootstrap RX: 0x1000/244, TX: 0x10f4/244",
            f"  Standard  RX: 0x1000/{facts['mailbox_out_bytes']}, TX: 0x1080/{facts['mailbox_in_bytes']}",
            f"  Supported protocols: {', '.join(facts['mailbox_protocols'])}",
        ]
    if "group" in facts:
        lines += [
            "General:",
            f"  Group: {facts['group'] or ''}",
            "  Image name: ",
            f"  Order number: {facts['order_number'] or ''}",
            f"  Device name: {facts['name'] or ''}",
        ]
        if "coe" in facts:
            lines += [
                "  CoE details:",
                f"    Enable SDO: {answer(facts['coe'].sdo)}",
                f"    Enable SDO Info: {answer(facts['coe'].sdo_info)}",
                f"    Enable PDO Assign: {answer(facts['coe'].pdo_assign)}",
                f"    Enable PDO Configuration: {answer(facts['coe'].pdo_configuration)}",
                f"    Enable Upload at startup: {answer(facts['coe'].upload_at_startup)}",
                f"    Enable SDO complete access: {answer(facts['coe'].complete_access)}",
            ]
        lines += [
            "  Flags:",
            "    Enable SafeOp: no",
            f"    Enable notLRW: {answer(facts['not_lrw'])}",
            f"  Current consumption: {facts['e_bus_current_ma']} mA",
        ]
    return "\n".join(lines) + "\n"


@given(st.lists(st.lists(slaves(), min_size=1, max_size=4), min_size=1, max_size=2))
@settings(max_examples=60, deadline=None)
def test_printed_slaves_are_read_back(masters):
    text, expected = "", []
    for master, bus in enumerate(masters):
        for position, facts in enumerate(bus):
            line = text.count("\n") + 1
            expected.append(ScannedSlave(line=line, bus=master, master=master, position=position, **facts))
            text += printed(master, position, facts)
    scan = read_scan(text)
    assert scan.slaves == tuple(expected)
    assert scan.findings == ()


@given(slaves(), st.data())
@settings(max_examples=100, deadline=None)
def test_a_cut_output_says_less_but_nothing_else(facts, data):
    text = printed(0, 0, facts)
    (whole,) = read_scan(text).slaves
    cut = text[: data.draw(st.integers(text.index("\n"), len(text)))]
    (slave,) = read_scan(cut).slaves
    for field in ScannedSlave.__struct_fields__:
        value, full = getattr(slave, field), getattr(whole, field)
        if field == "name":
            assert value is None or full.startswith(value)
        elif field == "ports":
            assert value == full[: len(value)]
        elif field == "coe" and value is not None:
            for flag in ScannedCoe.__struct_fields__:
                assert getattr(value, flag) in (None, getattr(full, flag))
        else:
            assert value == full or value is None
