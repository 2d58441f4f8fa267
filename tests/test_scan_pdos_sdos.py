"""``ethercat pdos`` and ``ethercat sdos``: layouts, headings, cut output, round trips."""

import re

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from esicatalog.scan.front import read_pdos, read_sdos
from esicatalog.scan.records import (
    ScanError,
    ScannedDictionary,
    ScannedObject,
    ScannedObjectEntry,
    ScannedPdo,
    ScannedPdoEntry,
    ScannedPdos,
    ScannedSyncManager,
)

PDOS = """\
SM0: PhysAddr 0x1000, DefaultSize  128, ControlRegister 0x26, Enable 1
SM2: PhysAddr 0x1100, DefaultSize    2, ControlRegister 0x64, Enable 9
  RxPDO 0x1600 "Outputs of "A""
    PDO entry 0x7000:01,  1 bit, "Enable"
    PDO entry 0x0000:00, 15 bit, ""
  RxPDO 0x16ff ""
SM3: PhysAddr 0x1180, DefaultSize    0, ControlRegister 0x20, Enable 1
  TxPDO 0x1a00 "Inputs"
    PDO entry 0x6000:1a, 255 bit, "Raw"
"""
SDOS = """\
SDO 0x1000, "Device type"
  0x1000:00, r-r-r-, uint32, 32 bit, "Device type"
SDO 0x1600, "1. RxPDO, first"
  0x1600:00, rwr-r-, uint8, 8 bit, "SubIndex 000"
  0x1600:0a, rwrwrw, type 0030, 4 bit, ""
"""


def messages(scan) -> list[tuple[int, str]]:
    return [(finding.line, finding.message) for finding in scan.findings]


def test_pdos_of_one_slave():
    scan = read_pdos(PDOS)
    assert scan.findings == ()
    assert scan.slaves == (
        ScannedPdos(
            line=1,
            sync_managers=(
                ScannedSyncManager(number=0, start_address=0x1000, size_bytes=128, control=0x26, enable=1, line=1),
                ScannedSyncManager(
                    number=2,
                    start_address=0x1100,
                    size_bytes=2,
                    control=0x64,
                    enable=9,
                    line=2,
                    pdos=(
                        ScannedPdo(
                            index=0x1600,
                            is_rx=True,
                            name='Outputs of "A"',
                            line=3,
                            entries=(
                                ScannedPdoEntry(index=0x7000, subindex=1, bit_length=1, name="Enable", line=4),
                                ScannedPdoEntry(index=0, subindex=0, bit_length=15, name=None, line=5),
                            ),
                        ),
                        ScannedPdo(index=0x16FF, is_rx=True, name=None, line=6),
                    ),
                ),
                ScannedSyncManager(
                    number=3,
                    start_address=0x1180,
                    size_bytes=0,
                    control=0x20,
                    enable=1,
                    line=7,
                    pdos=(
                        ScannedPdo(
                            index=0x1A00,
                            is_rx=False,
                            name="Inputs",
                            line=8,
                            entries=(ScannedPdoEntry(index=0x6000, subindex=0x1A, bit_length=255, name="Raw", line=9),),
                        ),
                    ),
                ),
            ),
        ),
    )


def test_headings_name_the_slaves():
    text = f"=== Master 1, Slave 0 ===\n{PDOS}=== Slave 12 ===\n=== Slave 13 ===\n{PDOS}"
    assert [(slave.master, slave.position) for slave in read_pdos(text).slaves] == [(1, 0), (None, 13)]
    text = f"=== Master 1, Slave 0 ===\n{SDOS}=== Slave 12 ===\n=== Slave 13 ===\n{SDOS}"
    assert [(slave.master, slave.position) for slave in read_sdos(text).slaves] == [(1, 0), (None, 13)]


SM = "SM{}: PhysAddr 0x1000, DefaultSize    0, ControlRegister 0x64, Enable 9\n"
FULL, EMPTY = (
    SM.format(2) + PDOS[PDOS.index("  RxPDO 0x1600") : PDOS.index("  RxPDO 0x16ff")],
    SM.format(2) + ('  RxPDO 0x1600 ""\n'),
)


def headed(*blocks: tuple[str, str]) -> str:
    return "".join(f"=== Master 0, Slave {position} ===\n{block}" for position, block in blocks)


def test_the_tool_goes_on_in_hexadecimal_behind_an_empty_pdo():
    """CommandPdos.cpp and CommandSdos.cpp print the index with ``hex`` and the heading without ``dec``."""
    scan = read_pdos(
        headed(("9", EMPTY), ("a", EMPTY), ("b", FULL), ("12", EMPTY), ("d", ""), ("10", FULL), ("17", ""))
    )
    assert [slave.position for slave in scan.slaves] == [9, 10, 11, 12, 16]
    (found,) = scan.findings
    assert [slave.findings for slave in scan.slaves] == [(), (), (), (), (found,)]
    assert (found.line, found.message) == (
        16,
        "'=== Master 0, Slave 10 ===' is of slave 16: the tool goes on in hexadecimal behind an index",
    )
    quiet, shown = 'SDO 0x1000, ""\n', SDOS
    scan = read_sdos(headed(("9", shown), ("10", quiet), ("b", quiet), ("10", shown), ("17", shown)))
    assert [slave.position for slave in scan.slaves] == [9, 10, 11, 16, 17]
    (slave,) = read_pdos(SM.format(9) + '  RxPDO 0x1600 ""\n' + SM.format("a")).slaves
    assert [sync_manager.number for sync_manager in slave.sync_managers] == [9, 10]


def test_a_heading_that_may_be_hexadecimal_or_not_is_no_guess():
    """One run prints slaves in rising order: after 9, 10 is slave 10 of another run, or 16 of the same."""
    for text in (headed(("9", EMPTY), ("10", FULL)), headed(("9", EMPTY), ("10", EMPTY), ("b", FULL))):
        with pytest.raises(ScanError, match=r"line 4: '=== Master 0, Slave 10 ===' is of slave 10, or of 16 if"):
            read_pdos(text)
    assert [slave.position for slave in read_pdos(headed(("9", EMPTY), ("10", ""), ("b", FULL))).slaves] == [9, 11]


def test_a_heading_of_another_command_names_no_list():
    text = f"=== Master 0, Slave 4 ===\nState: PREOP\n$ ethercat pdos -p 1\n{PDOS}"
    assert [slave.position for slave in read_pdos(text).slaves] == [None]
    text = f"=== Master 0, Slave 4 ===\nState: PREOP\n$ ethercat sdos -p 1\n{SDOS}"
    assert [slave.position for slave in read_sdos(text).slaves] == [None]


def test_pdo_layout_of_release_1_4():
    old = PDOS.replace("xPDO", "xPdo").replace("PDO entry", "Pdo entry").replace(",  1 bit", ", 1 bit")
    assert read_pdos(old) == read_pdos(PDOS)


def test_lists_without_headings_are_separate_slaves():
    scan = read_pdos(PDOS + PDOS)
    assert [slave.line for slave in scan.slaves] == [1, 10]
    assert messages(scan) == [(10, "SyncManagers are listed again without a heading; read as another slave")]
    dictionaries = read_sdos(SDOS + SDOS)
    assert [slave.line for slave in dictionaries.slaves] == [1, 6]
    assert messages(dictionaries) == [(6, "object 0x1000 is listed again without a heading; read as another slave")]


def test_cut_names_are_told():
    scan = read_pdos(PDOS.removesuffix('w"\n'))
    assert scan.slaves[0].sync_managers[-1].pdos[0].entries[0].name == "Ra"
    assert messages(scan) == [(9, "the name is cut off: 'Ra'")]
    assert messages(read_sdos('SDO 0x1000, "Device t')) == [(1, "the name is cut off: 'Device t'")]


def test_foreign_lines_are_told_once():
    scan = read_pdos(f'  RxPDO 0x1600 "before any SyncManager"\n$ ethercat pdos\n{PDOS}$ exit\n')
    assert messages(scan) == [
        (
            1,
            "not understood, so the list is not complete and not compared: 'RxPDO 0x1600 \"before any SyncManager\"'",
        ),
        (2, "2 lines are not read as `ethercat pdos`; the first: '$ ethercat pdos'"),
    ]
    assert [slave.is_complete for slave in scan.slaves] == [True]
    dictionaries = read_sdos(f"{SDOS}$ exit\n")
    (slave,) = read_sdos(SDOS).slaves
    assert dictionaries.slaves == (msgspec.structs.replace(slave, findings=dictionaries.findings),)
    assert messages(dictionaries) == [(6, "1 line is not read as `ethercat sdos`; the first: '$ exit'")]


@pytest.mark.parametrize("broken", ['SDO 0x1a00, "x"', '  0x1600:00, rwr-r-, uint8, 8 bit, "x"'])
def test_a_list_of_objects_is_not_complete_where_a_line_of_it_is_broken(broken):
    """Another object of the same list is no part of this one: what is missing is not known to be missing on it."""
    scan = read_sdos(SDOS + broken.replace("00, ", "00, [ 12.1] x", 1) + '\n  0x1a00:00, uint8, 8 bit, "x"\n' + SDOS)
    first, second = scan.slaves
    assert (first.is_complete, second.is_complete) == (False, True)
    assert first.objects == read_sdos(SDOS).slaves[0].objects
    assert messages(scan)[0][1].startswith("not understood, so the list is not complete and not compared: ")


def without_lines(slaves):
    """What lists say, wherever it stands."""
    return msgspec.json.decode(re.sub(rb'"line":[0-9]+', b'"line":0', msgspec.json.encode(slaves)))


@pytest.mark.parametrize(("whole", "read"), [(PDOS, read_pdos), (SDOS, read_sdos)])
def test_lines_that_were_joined_are_read_apart(whole, read):
    """Behind the quote that closes a name the next item follows, of whatever kind, also the heading of a slave."""
    text = f"=== Master 0, Slave 3 ===\n{whole}=== Master 0, Slave 4 ===\n{whole}"
    expected = without_lines(read(text).slaves)
    places = [place for place in range(len(text)) if text.startswith('"\n', place)]
    for place in places:
        joined = read(text[: place + 1] + text[place + 2 :])
        assert (without_lines(joined.slaves), joined.findings) == (expected, ())
    joined = read(text.replace('"\n', '" '))
    assert (without_lines(joined.slaves), joined.findings) == (expected, ())


@pytest.mark.parametrize(
    ("damaged", "read"),
    [
        (PDOS.replace('"A""\n    PDO entry 0x7000:01,  1 bit', '"A"" PDO entry 0x7000:01'), read_pdos),
        (PDOS.replace('""\nSM3: PhysAddr', '"" SM3: [ 12.1] x'), read_pdos),
        (SDOS.replace('type"\nSDO 0x1600, ', 'type" SDO 0x1600 '), read_sdos),
        (SDOS.replace('000"\n  0x1600:0a, rwrwrw, type', '000" 0x1600:0a, [ 12.1] x'), read_sdos),
    ],
)
def test_a_name_that_goes_on_like_an_item_is_not_understood(damaged, read):
    scan = read(damaged)
    assert [slave.is_complete for slave in scan.slaves] == [False]
    assert messages(scan)[0][1].startswith("not understood, so the list is not complete and not compared: ")


def test_names_that_speak_of_items_are_names():
    names = ["RxPDO 0x1600", 'Map "A" of RxPDO 0x1600', '"PDO entry"', "SM2: outputs", "0x6040:00, uint16"]
    for name in names:
        (slave,) = (scan := read_pdos(f'{SM.format(2)}  RxPDO 0x1601 "{name}"\n')).slaves
        assert (slave.sync_managers[0].pdos[0].name, slave.is_complete, scan.findings) == (name, True, ())
        (slave,) = (quiet := read_sdos(f'SDO 0x2000, "{name}"\n')).slaves
        assert (slave.objects[0].name, slave.is_complete, quiet.findings) == (name, True, ())


@pytest.mark.parametrize("broken", ["SM3: ", "SM3: Phys", '  RxPDO 0x16ff ""', "    PDO entry 0x0000:00,"])
def test_a_broken_line_of_a_list_gives_nothing_to_the_one_before_it(broken):
    """The kernel writes into the same terminal; what stands below the line may belong to another PDO or SyncManager."""
    scan = read_pdos(PDOS.replace(broken, broken[:-2] + "[ 12.1] EtherCAT 0: x\n" + broken[-2:], 1) + PDOS)
    first, second = scan.slaves
    assert (first.is_complete, second.is_complete) == (False, True)
    assert second.sync_managers == tuple(
        msgspec.structs.replace(sync_manager, line=line, pdos=read.pdos)
        for sync_manager, read, line in zip(
            read_pdos(PDOS).slaves[0].sync_managers, second.sync_managers, (11, 12, 17), strict=True
        )
    )
    mapped = {pdo.index: [entry.index for entry in pdo.entries] for sm in first.sync_managers for pdo in sm.pdos}
    whole = {0x1600: [0x7000, 0], 0x16FF: [], 0x1A00: [0x6000]}
    assert all(whole[index][: len(entries)] == entries for index, entries in mapped.items())
    assert "not understood, so the list is not complete" in scan.findings[0].message


def test_a_broken_heading_names_no_list():
    for text, read in ((PDOS, read_pdos), (SDOS, read_sdos)):
        with pytest.raises(ScanError, match="line 1: '=== Master 0, Slave 2 ==' is no heading, though it begins like"):
            read(f"=== Master 0, Slave 2 ==\n{text}")


@pytest.mark.parametrize("noise", ["Last login: x", "[  12.1] EtherCAT 0: Slave states: PREOP.", "user@host:~$"])
def test_noise_does_not_take_the_heading_from_a_list(noise):
    for text, read in ((PDOS, read_pdos), (SDOS, read_sdos)):
        (slave,) = (scan := read(f"=== Master 0, Slave 3 ===\n{noise}\n{text}")).slaves
        assert (slave.position, [finding.line for finding in scan.findings]) == (3, [2])


def test_objects_of_one_slave():
    scan = read_sdos(SDOS.replace("\n", "\r\n"))
    assert scan.findings == ()
    assert scan.slaves == (
        ScannedDictionary(
            line=1,
            objects=(
                ScannedObject(
                    index=0x1000,
                    name="Device type",
                    line=1,
                    entries=(
                        ScannedObjectEntry(
                            subindex=0, access="r-r-r-", data_type="uint32", bit_length=32, name="Device type", line=2
                        ),
                    ),
                ),
                ScannedObject(
                    index=0x1600,
                    name="1. RxPDO, first",
                    line=3,
                    entries=(
                        ScannedObjectEntry(
                            subindex=0, access="rwr-r-", data_type="uint8", bit_length=8, name="SubIndex 000", line=4
                        ),
                        ScannedObjectEntry(
                            subindex=10, access="rwrwrw", data_type="type 0030", bit_length=4, name=None, line=5
                        ),
                    ),
                ),
            ),
        ),
    )


@pytest.mark.parametrize(
    ("printed", "access", "bit_length"),
    [
        ("0x1018:01, r-r-r-, uint32, 32 bit, ", "r-r-r-", 32),
        ("0x1018:01, uint32, 32 bit, ", None, 32),
        ("0x1018:01, r-r-r-, uint32, ", "r-r-r-", None),
        ("0x1018:01, ------, uint32, 32 bit, ", "------", 32),
    ],
)
def test_sdo_layouts(printed, access, bit_length):
    (slave,) = read_sdos(f'Sdo 0x1018, "Identity object"\n  {printed}"Vendor id"\n').slaves
    (entry,) = slave.objects[0].entries
    assert (entry.subindex, entry.access, entry.bit_length, entry.name) == (1, access, bit_length, "Vendor id")


def test_objects_without_entries():
    (slave,) = read_sdos('SDO 0x1000, "Device type"\nSDO 0x1018, ""\n').slaves
    assert [(found.index, found.name, found.entries) for found in slave.objects] == [
        (0x1000, "Device type", ()),
        (0x1018, None, ()),
    ]


@pytest.mark.parametrize("text", ["", "\n \n", "\x1b[0m", "0x000003a5 933\n"])
def test_what_is_neither(text):
    with pytest.raises(ScanError):
        read_pdos(text)
    with pytest.raises(ScanError):
        read_sdos(text)


name = st.text(st.characters(exclude_categories=("Cc", "Cs")), max_size=8).map(lambda text: text or None)
pdo_entry = st.tuples(st.integers(0, 0xFFFF), st.integers(0, 0xFF), st.integers(0, 0xFF), name)
pdo = st.tuples(st.integers(0, 0xFFFF), name, st.lists(pdo_entry, max_size=3))
object_entry = st.tuples(
    st.sampled_from(["r-r-r-", "rwrwrw", "-w-w-w"]), st.sampled_from(["bool", "type 0fff"]), st.integers(0, 65535), name
)


@given(st.lists(st.tuples(st.booleans(), st.lists(pdo, max_size=3)), min_size=1, max_size=4))
@settings(max_examples=50, deadline=None)
def test_printed_pdos_are_read_back(managers):
    lines = []
    for number, (is_rx, pdos) in enumerate(managers):
        control = 0x24 if is_rx else 0x20
        lines.append(f"SM{number}: PhysAddr 0x1000, DefaultSize    0, ControlRegister 0x{control:02x}, Enable 1")
        for index, title, entries in pdos:
            lines.append(f'  {"R" if is_rx else "T"}xPDO 0x{index:04x} "{title or ""}"')
            for entry in entries:
                lines.append(f'    PDO entry 0x{entry[0]:04x}:{entry[1]:02x}, {entry[2]:2} bit, "{entry[3] or ""}"')
    (slave,) = read_pdos("\n".join(lines)).slaves
    found = [
        [
            (
                pdo.index,
                pdo.name,
                [(entry.index, entry.subindex, entry.bit_length, entry.name) for entry in pdo.entries],
            )
            for pdo in manager.pdos
        ]
        for manager in slave.sync_managers
    ]
    assert found == [pdos for _, pdos in managers]


@given(st.dictionaries(st.integers(0, 0xFFFF), st.tuples(name, st.lists(object_entry, max_size=3)), min_size=1))
@settings(max_examples=50, deadline=None)
def test_printed_objects_are_read_back(dictionary):
    lines = []
    for index, (title, entries) in dictionary.items():
        lines.append(f'SDO 0x{index:04x}, "{title or ""}"')
        for subindex, (access, data_type, bits, text) in enumerate(entries):
            lines.append(f'  0x{index:04x}:{subindex:02x}, {access}, {data_type}, {bits} bit, "{text or ""}"')
    (slave,) = read_sdos("\n".join(lines)).slaves
    assert {
        found.index: (
            found.name,
            [(entry.access, entry.data_type, entry.bit_length, entry.name) for entry in found.entries],
        )
        for found in slave.objects
    } == dictionary
