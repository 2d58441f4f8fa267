"""What a master printed of PDOs and objects against the description."""

from pathlib import Path

import msgspec
import pytest
from snippets import device, dictionary, esi, mapping_objects, only_device, pdo, read

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.export.entry_types import ObjectTable
from esicatalog.lint.subjects import Dictionaries
from esicatalog.model import scan_compare
from esicatalog.model.access import OP, PREOP, access_text, states_to_write
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.scan_compare import compare_scanned_objects, compare_scanned_pdos
from esicatalog.model.slots import reachable_modules
from esicatalog.scan.front import read_pdos, read_sdos
from esicatalog.scan.records import ScannedDictionary, ScannedPdos

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"
DESCRIBED = only_device(
    esi(device(SMS + pdo("RxPdo", "#x1600", 16, 32, attributes='Sm="2"') + pdo("TxPdo", "#x1A00", 16)))
)
HEAD = "SM2: PhysAddr 0x1100, DefaultSize    0, ControlRegister 0x64, Enable 1\n"


def pdos(text: str):
    (slave,) = read_pdos(HEAD + text).slaves
    return compare_scanned_pdos(DESCRIBED, (), slave)


def test_pdos_as_described():
    text = '  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n    PDO entry 0x7000:02, 32 bit, "b"\n'
    assert pdos(text) == []


@pytest.mark.parametrize(
    ("listed", "found"),
    [
        ((), []),
        ((0x1A13,), []),
        ((0x1A13, 0x1A16), ["SM4: assigned are 0x1A16; the default is none"]),
    ],
)
def test_what_is_virtual_may_be_listed_or_not(listed, found):
    """What `ethercat pdos` prints of a device without CoE is its SII, which has them too."""
    content = (
        SMS
        + '<Sm Virtual="1">Inputs</Sm>'
        + pdo("TxPdo", "#x1A13", 8, attributes='Sm="4" Virtual="1"')
        + pdo("TxPdo", "#x1A16", 8, attributes='Virtual="1"')
    )
    pdos = "".join(f'  TxPDO 0x{index:04x} "L"\n    PDO entry 0x7000:01, 8 bit, ""\n' for index in listed)
    (slave,) = read_pdos(f"SM4: PhysAddr 0x09ae, DefaultSize 0, ControlRegister 0x00, Enable 4\n{pdos}").slaves
    assert compare_scanned_pdos(only_device(esi(device(content))), (), slave) == found


def test_a_list_of_all_that_the_eeprom_assigns_is_told_as_that():
    """Both TxPDOs name SM3, and 0x1A01 excludes 0x1A00: the default is the first, IgH lists what the SII has."""
    content = (
        SMS
        + pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"')
        + pdo("TxPdo", "#x1A01", 8, attributes='Sm="3"', extra="<Exclude>#x1A00</Exclude>")
        + pdo("TxPdo", "#x1A02", 8, attributes="")
    )
    described = only_device(esi(device(content)))
    for listed, found in (
        ((0x1A00,), []),
        (
            (0x1A00, 0x1A01),
            [
                "SM3: assigned are 0x1A00, 0x1A01 (all that the EEPROM assigns, also what the default leaves out); "
                "the default is 0x1A00"
            ],
        ),
        ((0x1A00, 0x1A02), ["SM3: assigned are 0x1A00, 0x1A02; the default is 0x1A00"]),
    ):
        pdos = "".join(f'  TxPDO 0x{index:04x} "L"\n    PDO entry 0x7000:01, 8 bit, ""\n' for index in listed)
        (slave,) = read_pdos(f"SM3: PhysAddr 0x1180, DefaultSize 0, ControlRegister 0x20, Enable 1\n{pdos}").slaves
        assert compare_scanned_pdos(described, (), slave) == found


def test_another_mapping_is_told_entry_by_entry():
    text = '  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n    PDO entry 0x0000:00, 32 bit, "gap"\n'
    assert pdos(text) == ["RxPDO 0x1600, entry 2: maps padding (32 bit); described is 0x7000:02 (32 bit)"]
    text = '  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n'
    assert pdos(text) == ["RxPDO 0x1600: maps 1 entry; described with 2"]


def test_an_entry_of_no_bits_is_described_like_any_other():
    content = SMS + pdo("RxPdo", "#x1600", 16, 0, 8, attributes='Sm="2"')
    for bits, found in (
        (0, []),
        (8, ["RxPDO 0x1600, entry 2: maps 0x7000:02 (8 bit); described is 0x7000:02 (0 bit)"]),
    ):
        text = "".join(
            f'    PDO entry 0x7000:{n:02X}, {length} bit, ""\n' for n, length in ((1, 16), (2, bits), (3, 8))
        )
        (slave,) = read_pdos(f'{HEAD}  RxPDO 0x1600 "R"\n{text}').slaves
        assert compare_scanned_pdos(only_device(esi(device(content))), (), slave) == found


def test_samples_of_any_op_mode_are_described():
    """Two samples in the second OpMode, mapping objects for three."""
    modes = "".join(f'<OpMode><Name>m{n}</Name><Sm No="3"><Pdo OSFac="{n}">#x1A01</Pdo></Sm></OpMode>' for n in (1, 2))
    maps = mapping_objects((0x1A01, "10010160"), (0x1A02, "10020160"), (0x1A03, "10030160"))
    content = maps + SMS + pdo("TxPdo", "#x1A01", 16) + '<Mailbox><CoE PdoAssign="1"/></Mailbox>' + f"<Dc>{modes}</Dc>"
    text = "".join(f'  TxPDO 0x1A0{n} "T"\n    PDO entry 0x6001:0{n}, 16 bit, "v"\n' for n in (1, 2, 3))
    (slave,) = read_pdos(HEAD.replace("SM2", "SM3") + text).slaves
    assert compare_scanned_pdos(only_device(esi(device(content))), (), slave) == [
        "TxPDO 0x1A03: not described",
        "SM3: assigned are 0x1A01, 0x1A02, 0x1A03; the default is 0x1A01",
    ]


def test_what_the_description_leaves_open_is_no_difference():
    """The second entry has no BitLen, PDO 0x1601 variable content, the empty list of 0x1602 is Fixed."""
    lengths = ((1, "<BitLen>16</BitLen>"), (2, ""))
    entries = "".join(
        f"<Entry><Index>#x7000</Index><SubIndex>{sub}</SubIndex>{length}</Entry>" for sub, length in lengths
    )
    described = only_device(
        esi(
            device(
                f'{SMS}<RxPdo Sm="2"><Index>#x1600</Index>{entries}</RxPdo><RxPdo Sm="2"><Index>#x1601</Index></RxPdo>'
                '<RxPdo Sm="2" Fixed="1"><Index>#x1602</Index></RxPdo>'
            )
        )
    )

    def differences(second: str, reserved: str) -> list[str]:
        text = (
            f'{HEAD}  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n    PDO entry {second}, "b"\n'
            f'  RxPDO 0x1601 "V"\n    PDO entry 0x7010:01, 8 bit, "c"\n  RxPDO 0x1602 "F"\n{reserved}'
        )
        (slave,) = read_pdos(text).slaves
        return compare_scanned_pdos(described, (), slave)

    assert differences("0x7000:02, 16 bit", "") == []
    assert differences("0x7000:03, 16 bit", '    PDO entry 0x7020:01, 8 bit, "d"\n') == [
        "RxPDO 0x1600, entry 2: maps 0x7000:03 (16 bit); described is 0x7000:02 (no length)",
        "RxPDO 0x1602: maps 1 entry; described with 0",
    ]


def test_a_pdo_that_is_not_described_and_another_assignment():
    assert pdos('  RxPDO 0x1601 "R"\n') == [
        "RxPDO 0x1601: not described",
        "SM2: assigned are 0x1601; the default is 0x1600",
    ]


def test_an_assignment_that_nothing_describes_is_no_other_one():
    """With PdoUpload the device says what it exchanges; what is not described of it is told all the same."""
    uploaded = '<Mailbox><CoE PdoUpload="1"/></Mailbox>' + SMS
    (slave,) = read_pdos(HEAD + '  RxPDO 0x1600 "R"\n').slaves
    of_outputs = [compare_scanned_pdos(only_device(esi(device(content))), (), slave) for content in (SMS, uploaded)]
    undescribed = "RxPDO 0x1600: not described"
    assert of_outputs == [[undescribed, "SM2: assigned are 0x1600; the default is none"], [undescribed]]


def test_a_subindex_that_cannot_be_read_is_left_open():
    described = only_device(
        esi(device(SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"').replace("<SubIndex>1<", "<SubIndex>x1<")))
    )

    def differences(entry: str) -> list[str]:
        (slave,) = read_pdos(f'{HEAD}  RxPDO 0x1600 "R"\n    PDO entry {entry}, "a"\n').slaves
        return compare_scanned_pdos(described, (), slave)

    assert differences("0x7000:05, 16 bit") == []
    assert differences("0x7001:05, 16 bit") == [
        "RxPDO 0x1600, entry 1: maps 0x7001:05 (16 bit); described is 0x7000:? 'x1' (16 bit)"
    ]


def test_a_pdo_that_is_listed_and_not_described_belongs_to_the_default_assignment():
    """The device has what its description lists; only what 0x1601 maps is not described."""
    listed = '<Sm No="2"><Pdo>#x1600</Pdo><Pdo>#x1601</Pdo></Sm>'
    modes = f"<Dc><OpMode><Name>DC</Name><AssignActivate>0</AssignActivate>{listed}</OpMode></Dc>"
    described = only_device(esi(device(SMS + pdo("RxPdo", "#x1600", 16) + modes)))
    text = f'{HEAD}  RxPDO 0x1600 "R"\n    PDO entry 0x7000:01, 16 bit, "a"\n  RxPDO 0x1601 "S"\n'
    (slave,) = read_pdos(text).slaves
    assert compare_scanned_pdos(described, (), slave) == ["RxPDO 0x1601: not described"]


def test_a_sync_manager_without_pdos_is_told_where_the_description_assigns_some():
    assert pdos("") == ["SM2: assigned are none; the default is 0x1600"]
    (slave,) = read_pdos(HEAD.replace("SM2", "SM3")).slaves
    assert compare_scanned_pdos(DESCRIBED, (), slave) == ["SM2: not in the list; the default is 0x1600"]


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
    found = compare_scanned_pdos(modular, modules, slave)
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
    return compare_scanned_objects(DRIVE, (), slave)


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


def record(index: int, bits: int, count: int, mark: str = "") -> tuple[str, str]:
    """A type of ``count`` values of some bits behind their number, and an object of it."""
    name = f"DT{index:04X}_{bits}_{count}"
    sub_items = "".join(
        f"<SubItem><SubIdx>{sub}</SubIdx><Name>Sub {sub}</Name><Type>UDINT</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{sub * bits}</BitOffs></SubItem>"
        for sub in range(count + 1)
    )
    return (
        f"<DataType><Name>{name}</Name><BitSize>{(count + 1) * bits}</BitSize>{sub_items}</DataType>",
        f"<Object><Index{mark}>#x{index:04X}</Index><Name>O</Name><Type>{name}</Type>"
        f"<BitSize>{(count + 1) * bits}</BitSize></Object>",
    )


def of(*parts: tuple[str, str]) -> str:
    """A dictionary of such objects."""
    return dictionary("".join(types for types, _ in parts), "".join(declared for _, declared in parts))


def seen_object(index: int, bits: int, count: int) -> ScannedDictionary:
    entries = "".join(f'  0x{index:04x}:{sub:02x}, r-r-r-, uint32, {bits} bit, "s"\n' for sub in range(count + 1))
    (slave,) = read_sdos(f'SDO 0x{index:04x}, "O"\n{entries}').slaves
    return slave


def test_of_several_objects_with_one_index_the_first_counts():
    """The second one has a subindex more and other sizes; what the first has not, is not described."""
    first, second = record(0x2000, 32, 2), record(0x2000, 16, 3)
    for content in (of(first, second), of(first) + of(second)):
        unit = only_device(esi(device(content)))
        assert compare_scanned_objects(unit, (), seen_object(0x2000, 32, 2)) == []
        assert compare_scanned_objects(unit, (), seen_object(0x2000, 32, 3)) == ["0x2000:03: not described (s)"]
        table = ObjectTable(unit, ())
        assert (table.highest_subindex(0x2000), table.entry(0x2000, 1).bit_size) == (2, 32)
        assert sorted(Dictionaries(DictionaryViews().of(unit.profiles)).entries(0x2000)) == [0, 1, 2]


MARKED = " OverwrittenByModule='1'"


def test_an_object_that_yields_counts_after_one_that_does_not():
    unit = only_device(esi(device(of(record(0x2000, 16, 3, MARKED)) + of(record(0x2000, 32, 2)))))
    assert compare_scanned_objects(unit, (), seen_object(0x2000, 32, 2)) == []
    assert ObjectTable(unit, ()).highest_subindex(0x2000) == 2
    assert sorted(Dictionaries(DictionaryViews().of(unit.profiles)).entries(0x2000)) == [0, 1, 2]


def test_an_object_that_yields_may_be_as_modules_have_it():
    slots = "<Slots><Slot MinInstances='0' MaxInstances='1'><ModuleIdent>1</ModuleIdent></Slot></Slots>"
    brings = "<Module><Type ModuleIdent='1'>M</Type><Name>M</Name>" + of(record(0x2000, 32, 2)) + "</Module>"

    def differences(mark: str, bits: int, count: int) -> list[str]:
        (info,) = read(esi(device(of(record(0x2000, 16, 3, mark)) + slots), brings)).document.infos
        return compare_scanned_objects(info.devices[0], info.modules, seen_object(0x2000, bits, count))

    assert differences(MARKED, 16, 3) == differences(MARKED, 32, 2) == []
    assert differences(MARKED, 8, 0) == ["0x2000:00: 8 bit; described are 16"]
    assert differences("", 32, 2) == [
        *(f"0x2000:{sub:02X}: 32 bit; described are 16" for sub in range(3)),
        "0x2000:03: described (Sub 3), but not on the device",
    ]


def test_without_a_dictionary_of_the_device_itself_nothing_is_compared():
    """That of a module says nothing of the objects that every device has."""
    (slave,) = read_sdos('SDO 0x6040, "C"\n  0x6040:00, rwrwrw, uint16, 16 bit, "C"\n').slaves
    assert compare_scanned_objects(only_device(esi(device())), (), slave) is None
    unit, modules = coupler(1)
    assert compare_scanned_objects(msgspec.structs.replace(unit, profiles=()), modules, slave) is None


def test_access_words_as_masters_print_them():
    """Bits 0-2 read and 3-5 write, in PREOP, SAFEOP and OP (ETG.1000.6)."""
    assert access_text(0b111111) == "rwrwrw"
    assert access_text(0b000111) == "r-r-r-"
    assert access_text(0b001111) == "rwr-r-"
    assert access_text(0) == "------"
    assert (states_to_write(0b001111), states_to_write(0b1_100_111)) == (PREOP, OP)


MODULAR = (
    f"{SMS}<Slots SlotPdoIncrement='1' SlotIndexIncrement='#x10'>"
    "<Slot MinInstances='0' MaxInstances='{}'><ModuleIdent>1</ModuleIdent><ModuleIdent>2</ModuleIdent></Slot></Slots>"
)
BY_SLOT = "<Index DependOnSlot='1'>"


def module(ident: int, data_type: str, bits: int) -> str:
    """A module that maps the value of its object 0x7000, moved by its slot."""
    declared = f"<Name>Out</Name><Type>{data_type}</Type><BitSize>{bits}</BitSize><Flags><Access>rw</Access></Flags>"
    return (
        f"<Module><Type ModuleIdent='{ident}'>M</Type><Name>M</Name>"
        f"<RxPdo Sm='2'>{BY_SLOT}#x1600</Index><Name>R</Name>"
        f"<Entry>{BY_SLOT}#x7000</Index><SubIndex>0</SubIndex><BitLen>{bits}</BitLen></Entry></RxPdo>"
        + dictionary(TYPES, f"<Object>{BY_SLOT}#x7000</Index>{declared}</Object>")
        + "</Module>"
    )


def coupler(slot_count: int) -> tuple[Device, tuple[Module, ...]]:
    """A coupler whose slots take modules of 16 and of 32 bits."""
    content = dictionary(TYPES, OBJECTS) + MODULAR.format(slot_count)
    (info,) = read(esi(device(content), module(1, "UINT", 16) + module(2, "DINT", 32))).document.infos
    return info.devices[0], info.modules


def plugged_pdos(*slots: int) -> ScannedPdos:
    """What a master prints of 32 bit modules in these slots."""
    lines = [
        f'  RxPDO 0x{0x1600 + slot:04x} "R"\n    PDO entry 0x{0x7000 + 16 * slot:04x}:00, 32 bit, "Out"\n'
        for slot in slots
    ]
    (slave,) = read_pdos(HEAD + "".join(lines)).slaves
    return slave


def plugged_objects(*slots: int) -> ScannedDictionary:
    """The same of objects, those of the coupler before them."""
    lines = [
        'SDO 0x6040, "C"\n  0x6040:00, rwrwrw, uint16, 16 bit, "C"\n',
        'SDO 0x607a, "T"\n  0x607a:00, rwr-r-, int32, 32 bit, "T"\n',
        *(
            f'SDO 0x{index:04x}, "Out"\n  0x{index:04x}:00, rwrwrw, int32, 32 bit, "Out"\n'
            for index in (0x7000 + 16 * slot for slot in slots)
        ),
    ]
    (slave,) = read_sdos("".join(lines)).slaves
    return slave


def test_modules_count_in_every_slot_of_a_coupler():
    """Slot n has its PDO at 0x1600 + n and its object at 0x7000 + 0x10 n; any module that fits may be there."""
    unit, modules = coupler(254)
    assert compare_scanned_pdos(unit, modules, plugged_pdos(0, 15, 16, 253)) == [
        "SM2: assigned are 0x1600, 0x160F, 0x1610, 0x16FD; the default is none"
    ]
    assert compare_scanned_objects(unit, modules, plugged_objects(0, 15, 16, 253)) == []


def test_slots_that_no_coupler_has_are_not_looked_at_and_told():
    unit, modules = coupler(1_000_000)
    left_out = "255 of 1000000 slots were looked at: what is not described may be of a module in another"
    assert compare_scanned_pdos(unit, modules, plugged_pdos(254, 255)) == [
        "RxPDO 0x16FF: not described",
        "SM2: assigned are 0x16FE, 0x16FF; the default is none",
        left_out,
    ]
    assert compare_scanned_objects(unit, modules, plugged_objects(254, 255)) == [
        "0x7FF0: not described (Out)",
        left_out,
    ]


def test_the_more_modules_bring_the_fewer_slots_are_looked_at(monkeypatch):
    """Two modules with a PDO of one entry each make 1 + 2 + 2 * 2 parts: 70 parts are enough for 10 slots."""
    monkeypatch.setattr(scan_compare, "_MOST_PLACES", 70)
    unit, modules = coupler(11)
    assert compare_scanned_pdos(unit, modules, plugged_pdos(9, 10)) == [
        "RxPDO 0x160A: not described",
        "SM2: assigned are 0x1609, 0x160A; the default is none",
        "10 of 11 slots were looked at: what is not described may be of a module in another",
    ]
