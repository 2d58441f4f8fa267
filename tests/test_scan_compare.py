"""What a master printed of PDOs and objects against the description."""

from pathlib import Path

from snippets import device, dictionary, esi, only_device, pdo, read

from esicatalog.model.scan_compare import access_text, compare_objects, compare_pdos
from esicatalog.model.slots import reachable_modules
from esicatalog.scan.front import read_pdos, read_sdos

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"
DESCRIBED = only_device(
    esi(device(SMS + pdo("RxPdo", "#x1600", 16, 32, attributes='Sm="2"') + pdo("TxPdo", "#x1A00", 16)))
)
HEAD = "SM2: PhysAddr 0x1100, DefaultSize    0, ControlRegister 0x64, Enable 1\n"


def pdos(text: str):
    (slave,) = read_pdos(HEAD + text).slaves
    return compare_pdos(DESCRIBED, (), slave)


def test_pdos_as_described():
    text = '  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n    PDO entry 0x7000:02, 32 bit, "b"\n'
    assert pdos(text) == []


def test_another_mapping_is_told_entry_by_entry():
    text = '  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n    PDO entry 0x0000:00, 32 bit, "gap"\n'
    assert pdos(text) == ["RxPDO 0x1600, entry 2: maps a gap of 32 bit; described is 0x7000:02 (32 bit)"]
    text = '  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n'
    assert pdos(text) == ["RxPDO 0x1600: maps 1 entries; described are 2"]


def test_a_pdo_that_is_not_described_and_another_assignment():
    assert pdos('  RxPDO 0x1601 "R"\n') == [
        "RxPDO 0x1601: not described",
        "SM2: assigned are 0x1601; the default is 0x1600",
    ]


def test_pdos_of_modules_count_in_any_slot(data: Path):
    (info,) = read((data / "two_axis_modular_drive.xml").read_bytes()).document.infos
    modular = info.devices[0]
    modules = reachable_modules(modular, info.modules)
    csv = next(module for module in modules if module.module_ident == 0x10900)
    entries = "".join(
        f'    PDO entry 0x{entry.entry_index + 0x800:04x}:{entry.subindex or 0:02x}, {entry.bit_length} bit, "x"\n'
        for entry in csv.rx_pdos[0].entries
    )
    (slave,) = read_pdos(f'{HEAD}  RxPDO 0x1741 "second axis"\n{entries}').slaves
    found = compare_pdos(modular, modules, slave)
    assert not [text for text in found if text.startswith("RxPDO")]


TYPES = (
    "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
    "<DataType><Name>DINT</Name><BitSize>32</BitSize></DataType>"
)
OBJECTS = (
    "<Object><Index>#x6040</Index><Name>Controlword</Name><Type>UINT</Type><BitSize>16</BitSize>"
    "<Flags><Access>rw</Access></Flags></Object>"
    "<Object><Index>#x607A</Index><Name>Target position</Name><Type>DINT</Type><BitSize>32</BitSize>"
    "<Flags><Access WriteRestrictions='PreOP'>rw</Access></Flags></Object>"
)
DRIVE = only_device(esi(device(dictionary(TYPES, OBJECTS))))


def objects(text: str):
    (slave,) = read_sdos(text).slaves
    return compare_objects(DRIVE, (), slave)


def test_objects_as_described():
    assert (
        objects(
            'SDO 0x6040, "Controlword"\n  0x6040:00, rwrwrw, uint16, 16 bit, "Controlword"\n'
            'SDO 0x607a, "Target"\n  0x607a:00, rwr-r-, int32, 32 bit, "Target"\n'
        )
        == []
    )


def test_objects_otherwise_than_described():
    assert objects(
        'SDO 0x6040, "Controlword"\n  0x6040:00, r-r-r-, uint32, 32 bit, "Controlword"\n'
        '  0x6040:01, rwrwrw, uint8, 8 bit, "more"\n'
        'SDO 0x2000, "Private"\n  0x2000:00, rwrwrw, uint8, 8 bit, "Private"\n'
    ) == [
        "0x2000: not described (Private)",
        "0x607A: described, but not on the device",
        "0x6040:00: 32 bit; described are 16",
        "0x6040:00: access r-r-r- (PREOP, SAFEOP, OP); described is rwrwrw",
        "0x6040:01: not described (more)",
    ]


def test_a_description_without_dictionary_says_nothing():
    (slave,) = read_sdos('SDO 0x6040, "C"\n  0x6040:00, rwrwrw, uint16, 16 bit, "C"\n').slaves
    assert compare_objects(only_device(esi(device())), (), slave) == []


def test_access_words_as_masters_print_them():
    """Bits 0-2 read and 3-5 write, in PREOP, SAFEOP and OP (ETG.1000.6)."""
    assert access_text(0b111111) == "rwrwrw"
    assert access_text(0b000111) == "r-r-r-"
    assert access_text(0b001111) == "rwr-r-"
    assert access_text(0) == "------"
