"""What masters print: every reader of scans, whatever the text."""

import random
from collections.abc import Iterator

from esicatalog.errors import EsiCatalogError
from esicatalog.scan.front import read_eni, read_pdos, read_scan, read_sdos
from fuzz.mutations import mutated_bytes, mutated_lines
from fuzz.seeds import ROOT, real_files

_OWN = (
    "vendor,product,revision\n0x00000e5c,0x0d080808,0x00110000\n4247,9222,143\n",
    "0  0:0  PREOP  +  ECX-D808\n1  5555:0  SAFEOP  E  0x00001097:0x00002406\n",
    """=== Master 0, Slave 1 ===
Device: Main
State: PREOP
Flag: +
Identity:
  Vendor Id:       0x00001097
  Product code:    0x00002406
  Revision number: 0x0000008f
  Serial number:   0x00000000
DL information:
  FMMU bit operation: no
  Distributed clocks: yes, 64 bit
  DC system time transmission delay: 145 ns
Port  Type  Link  Loop    Signal  NextSlave  RxTime [ns]  Diff [ns]   NextDc [ns]
   0  MII   up    open    yes             0   1234567890           0         145
Mailboxes:
  Bootstrap RX: 0x1000/128, TX: 0x1080/128
  Supported protocols: CoE, FoE
General:
  Group: G
  Order number: O
  Device name: N
  CoE details:
    Enable SDO: yes
  Flags:
    Enable SafeOp: no
  Current consumption: 200 mA
""",
    """SM0: PhysAddr 0x1000, DefaultSize  128, ControlRegister 0x26, Enable 1
SM2: PhysAddr 0x1100, DefaultSize    6, ControlRegister 0x64, Enable 1
  RxPDO 0x1600 "R"
    PDO entry 0x6040:00, 16 bit, "Controlword"
    PDO entry 0x0000:00,  8 bit, "Gap"
""",
    """SDO 0x1018, "Identity"
  0x1018:00, r-r-r-, uint8, 8 bit, "Count"
  0x1018:01, rwrwrw, uint32, 32 bit, "Vendor"
""",
    """SOEM (Simple Open EtherCAT Master)
Slaveinfo
1 slaves found and configured.
Calculated workcounter 3

Slave:1
 Name:EK1100
 Output size: 0bits
 Input size: 8bits
 State: 4
 Delay: 145[ns]
 Has DC: 1
 DCParentport:1
 Activeports:1.1.0.0
 Configured address: 1001
 Man: 00000002 ID: 044c2c52 Rev: 00110000
 SM0 A:1000 L: 128 F:00010026 Type:1
 FMMU0 Ls:00000000 Ll:   4 Lsb:0 Leb:7 Ps:1000 Psb:0 Ty:02 Act:01
 FMMUfunc 0:1 1:2 2:3 3:0
 MBX length wr: 128 rd: 128 MBX protocols : 04
 CoE details: 23 FoE details: 00 EoE details: 00 SoE details: 00
 Ebus current: -2000[mA]
 only LRD/LWR:0
""",
)
_ENI = (
    "<EtherCATConfig><Config><Slave><Info><Name>N</Name><PhysAddr>1001</PhysAddr><VendorId>4247</VendorId>"
    "<ProductCode>9222</ProductCode><RevisionNo>143</RevisionNo></Info></Slave></Config></EtherCATConfig>"
)


def check(data: bytes) -> None:
    """Give a text to every reader."""
    text = data.decode("utf-8", "replace")
    for read in (read_scan, read_pdos, read_sdos):
        _named(read, text)
    _named(read_eni, data)


def _named(read: object, data: object) -> None:
    try:
        found = read(data)  # type: ignore[operator]
    except EsiCatalogError as error:
        assert "\n" not in str(error)
    else:
        assert all("\n" not in finding.message for finding in found.findings)


def seeds() -> Iterator[bytes]:
    """Listings and a configuration."""
    yield from (text.encode() for text in (*_OWN, _ENI))
    yield from ((ROOT / "tests" / "maximal.xml").read_bytes()[:2_000],)
    yield from real_files("cli")


def mutate(data: bytes, seed: int) -> bytes:
    """Another listing."""
    chance = random.Random(seed)
    return mutated_lines(data, chance) if chance.random() < 0.7 else mutated_bytes(data, chance)
