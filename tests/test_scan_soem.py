"""``slaveinfo`` of SOEM: blocks, runs, the parts that -map and -sdo add."""

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from esicatalog.identity import Identity
from esicatalog.scan.front import read_scan
from esicatalog.scan.records import ScannedCoe, ScannedPort, ScannedSlave, ScannedSyncManager

GREETING = """\
SOEM (Simple Open EtherCAT Master)
Slaveinfo
Starting slaveinfo
ec_init on eth0 succeeded.
2 slaves found and configured.
Calculated workcounter 3
Not all slaves reached safe operational state.
Slave 2 State=12 StatusCode=  1d : Invalid output configuration
"""
COUPLER = """
Slave:1
 Name:EK1100
 Output size: 0bits
 Input size: 0bits
 State: 4
 Delay: 0[ns]
 Has DC: 1
 DCParentport:0
 Activeports:1.1.0.0
 Configured address: 1001
 Man: 00000002 ID: 044c2c52 Rev: 00120000
 FMMUfunc 0:0 1:0 2:0 3:0
 MBX length wr: 0 rd: 0 MBX protocols : 00
 CoE details: 00 FoE details: 00 EoE details: 00 SoE details: 00
 Ebus current: -2000[mA]
 only LRD/LWR:0
"""
DRIVE = """
Slave:2
 Name:? M:0000066f I:515050a1
 Output size: 80bits
 Input size: 112bits
 State: 18
 Delay: 155[ns]
 Has DC: 0
 Activeports:1.0.0.0
 Configured address: 1002
 Man: 0000066f ID: 515050a1 Rev: 00010000
 SM0 A:1000 L: 128 F:00010026 Type:1
 SM1 A:1080 L: 128 F:00010022 Type:2
 SM2 A:1100 L:  10 F:00090064 Type:3
 FMMU0 Ls:00000000 Ll:  10 Lsb:0 Leb:7 Ps:1100 Psb:0 Ty:02 Act:01
 FMMUfunc 0:1 1:2 2:3 3:0
 MBX length wr: 128 rd: 96 MBX protocols : 0c
 CoE details: 27 FoE details: 01 EoE details: 00 SoE details: 00
 Ebus current: 140[mA]
 only LRD/LWR:1
"""
MAP = """\
PDO mapping according to CoE :
  SM2 outputs
     addr b   index: sub bitl data_type    name
  [0x0000.0] 0x6040:0x00 0x10 UNSIGNED16   Controlword
  [0x0002.0] 0x0000:0x00 0x08
"""
SII_MAP = """\
PDO mapping according to SII :
  SM0 RXPDO 0x1600 Channel 1
     addr b   index: sub bitl data_type    name
  [0x0000.0] 0x7000:0x01 0x01 BOOLEAN      Output
"""
SDO = """\
 CoE Object Description found, 2 entries.
0x1000      "Device type"                                 [VAR]
    0x00      "Device type"                                 [UNSIGNED32       R_R_R_]      0x00020192 / 131474
0x1018      "State: 4"                                    [RECORD  maxsub(0x04 / 4)]
"""
OLD_SDO = """\
 CoE Object Description found, 1 entries.
 Index: 1000 Datatype: 0007 Objectcode: 07 Name: Device type
  Sub: 00 Datatype: 0007 Bitlength: 0020 Obj.access: 0007 Name: Device type
          Value :0x00020192 / 131474
"""
END = "End slaveinfo, close socket\nEnd program\n"


def messages(scan) -> list[str]:
    return [finding.message for finding in scan.findings]


def test_slaves():
    scan = read_scan(GREETING + COUPLER + DRIVE + END)
    assert scan.format == "SOEM slaveinfo"
    assert scan.slaves == (
        ScannedSlave(
            line=10,
            interface="eth0",
            position=0,
            configured_address=0x1001,
            vendor_id=2,
            product_code=0x044C2C52,
            revision_no=0x120000,
            name="EK1100",
            state="SAFEOP",
            state_error=False,
            e_bus_current_ma=-2000,
            dc_capable=True,
            dc_delay_ns=0,
            not_lrw=False,
            mailbox_protocols=(),
            mailbox_out_bytes=0,
            mailbox_in_bytes=0,
            output_bits=0,
            input_bits=0,
            ports=tuple(ScannedPort(number=number, link_up=number < 2) for number in range(4)),
        ),
        ScannedSlave(
            line=27,
            interface="eth0",
            position=1,
            configured_address=0x1002,
            vendor_id=0x66F,
            product_code=0x515050A1,
            revision_no=0x10000,
            state="PREOP",
            state_error=True,
            al_status_code=0x1D,
            e_bus_current_ma=140,
            dc_capable=False,
            dc_delay_ns=155,
            not_lrw=True,
            mailbox_protocols=("CoE", "FoE"),
            mailbox_out_bytes=128,
            mailbox_in_bytes=96,
            coe=ScannedCoe(
                sdo=True,
                sdo_info=True,
                pdo_assign=True,
                pdo_configuration=False,
                upload_at_startup=False,
                complete_access=True,
            ),
            output_bits=80,
            input_bits=112,
            ports=tuple(ScannedPort(number=number, link_up=number < 1) for number in range(4)),
            sync_managers=(
                ScannedSyncManager(number=0, start_address=0x1000, size_bytes=128, control=0x26, enable=1, line=37),
                ScannedSyncManager(number=1, start_address=0x1080, size_bytes=128, control=0x22, enable=1, line=38),
                ScannedSyncManager(number=2, start_address=0x1100, size_bytes=10, control=0x64, enable=9, line=39),
            ),
        ),
    )
    assert scan.findings == ()


def sizes(text: str) -> tuple[int | None, int | None]:
    (slave,) = read_scan(text).slaves
    return slave.output_bits, slave.input_bits


@pytest.mark.parametrize(("state", "of_zeros"), [(1, None), (2, None), (3, None), (18, None), (4, 0), (20, 0), (8, 0)])
def test_a_size_of_zero_says_something_only_from_safeop_on(state, of_zeros):
    """The sizes are set on the way to SAFEOP: INIT 1, PREOP 2, BOOT 3 and PREOP with error 18 did not get there."""
    text = COUPLER.replace("State: 4", f"State: {state}")
    assert sizes(text) == (of_zeros, of_zeros)
    assert sizes(text.replace("Output size: 0bits", "Output size: 80bits")) == (80, of_zeros)


def test_a_size_of_zero_without_state_says_nothing():
    assert sizes(COUPLER.replace(" State: 4\n", "")) == (None, None)


def test_an_e_bus_current_of_zero_says_nothing():
    """It is printed also where the SII has no category General."""
    for printed, read in (("0", None), ("-2000", -2000), ("90", 90)):
        (slave,) = read_scan(COUPLER.replace("current: -2000", f"current: {printed}")).slaves
        assert slave.e_bus_current_ma == read


def test_greeting_of_release_2():
    scan = read_scan((GREETING + COUPLER + DRIVE + END).replace("ec_init", "ecx_init"))
    assert [slave.interface for slave in scan.slaves] == ["eth0", "eth0"]
    assert scan.findings == ()


def test_dictionaries_and_mappings_are_passed_over():
    plain = read_scan(GREETING + COUPLER + DRIVE + END).slaves
    for first, second in ((SII_MAP, MAP), ("", SDO), (SII_MAP, OLD_SDO + MAP)):
        scan = read_scan(GREETING + COUPLER + first + DRIVE + second + END)
        assert [slave.identity for slave in scan.slaves] == [slave.identity for slave in plain]
        assert [slave.sync_managers == () for slave in scan.slaves] == [True, False]
        assert [slave.state for slave in scan.slaves] == ["SAFEOP", "PREOP"]
        (message,) = messages(scan)
        assert "lines are not read as part of a slave in SOEM slaveinfo" in message


def test_spaces_behind_colons():
    scan = read_scan("Slave: 4\n Name: Drive\n Activeports: 0.1.0.0\n Man: 0000026c ID: 00000007 Rev: 06720000\n")
    (slave,) = scan.slaves
    assert (slave.position, slave.name, slave.identity) == (3, "Drive", Identity(0x26C, 7, 0x06720000))
    assert [port.link_up for port in slave.ports] == [False, True, False, False]


def test_runs_on_two_interfaces_are_two_buses():
    scan = read_scan(GREETING + COUPLER + DRIVE + END + GREETING.replace("eth0", "eth1") + COUPLER + DRIVE + END)
    assert [(slave.bus, slave.interface) for slave in scan.slaves] == [
        (0, "eth0"),
        (0, "eth0"),
        (1, "eth1"),
        (1, "eth1"),
    ]
    assert scan.findings == ()


def test_two_runs_on_one_interface_are_one_bus():
    scan = read_scan(GREETING + COUPLER + DRIVE + END + GREETING + COUPLER + DRIVE + MAP + END)
    assert [slave.line for slave in scan.slaves] == [10, 27]
    assert "the listing repeats the one from line 10; it is read once" in messages(scan)


def test_a_truncated_list_is_told():
    scan = read_scan(GREETING + COUPLER + "\nSlave:2\n Name:MADHT\n Man: 0000066f ID: 5150")
    assert [slave.identity is None for slave in scan.slaves] == [False, True]
    assert messages(scan) == [
        "slave 2 has no line `Man: ID: Rev:`; kept without identity",
        "not understood or cut off: 'Man: 0000066f ID: 5150'",
    ]
    scan = read_scan(GREETING + COUPLER)
    assert messages(scan) == ["2 slaves are announced, 1 is listed"]
    scan = read_scan(GREETING + COUPLER + "\nSlave:1")
    assert "may be cut off, not read: 'Slave:1'" in messages(scan)
    assert len(scan.slaves) == 1


def test_lines_that_were_joined_are_read_apart():
    """Names are not quoted, and some lines have no end of their own: the next item begins with its key."""
    expected = msgspec.structs.replace(read_scan(DRIVE).slaves[0], line=0, sync_managers=())
    lines = DRIVE.strip().splitlines()
    for number in range(1, len(lines) - 1):
        scan = read_scan("\n".join([*lines[:number], lines[number] + lines[number + 1], *lines[number + 2 :]]))
        assert msgspec.structs.replace(scan.slaves[0], line=0, sync_managers=()) == expected
        assert [item.size_bytes for item in scan.slaves[0].sync_managers] == [128, 128, 10]
        assert messages(scan) == messages(read_scan(DRIVE))
    scan = read_scan("Slave:1\n Name:Solid State: relay\n Man: 00000002 ID: 00000001 Rev: 00000001\n")
    assert messages(scan) == ["not understood or cut off: 'State: relay'"]


def test_no_slaves():
    scan = read_scan("SOEM (Simple Open EtherCAT Master)\nSlaveinfo\nec_init on eth0 succeeded.\nNo slaves found!\n")
    assert scan.slaves == ()
    assert messages(scan) == ["slaveinfo lists no slave"]


def test_an_unread_sii_is_told():
    scan = read_scan(COUPLER.replace("00000002 ID: 044c2c52 Rev: 00120000", "00000000 ID: 00000000 Rev: 00000000"))
    assert scan.slaves[0].identity == Identity(0, 0, 0)
    assert messages(scan) == ["slave 1 has vendor id and product code 0: its SII was not read or is empty"]


@given(st.data())
@settings(max_examples=60, deadline=None)
def test_a_cut_output_gives_no_wrong_identity(data):
    text = GREETING + COUPLER + DRIVE
    whole = {slave.position: slave.identity for slave in read_scan(text).slaves}
    cut = text[: data.draw(st.integers(text.index("\n"), len(text)))]
    for slave in read_scan(cut).slaves:
        assert slave.identity in (None, whole[slave.position])
