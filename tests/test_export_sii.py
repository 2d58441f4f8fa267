"""EEPROM images from descriptions: every rule on small devices, expected bytes written down from the format's rules."""

import struct

import pytest
from sii import by_hand
from snippets import device, esi, pdo, read
from test_export_configuration import subject

from esicatalog.export.sii import described_image, sii_image
from esicatalog.export.sii_header import eeprom_bytes
from esicatalog.export.sii_limits import check_image, fit_image
from esicatalog.export.sii_remarks import eeprom_remarks
from esicatalog.sii.codes import CoeDetails, GeneralFlags, MailboxProtocols
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.image import RawCategory, SiiImage
from esicatalog.sii.records import DC_MODE

VENDOR = 0x0E5C


def image_of(xml: str, language: int | None = None) -> SiiImage:
    """The image of the only device in a document."""
    (info,) = read(xml).document.infos
    (found,) = info.devices
    group = next((item for item in info.groups if item.type == found.group_type), None)
    return decode_sii(encode_sii(sii_image(info.vendor.vendor_id, group, found, language=language)))


def image(content: str = "", **codes: str) -> SiiImage:
    return image_of(esi(device(content, **codes)))


def words(image: SiiImage, first: int, count: int) -> tuple[int, ...]:
    return struct.unpack_from(f"<{count}H", encode_sii(image), 2 * first)


DRIVE = """<Device Physics="YY K"><Type ProductCode="#x2406" RevisionNo="#x0001008F" UseLrdLwr="1">XY1</Type>
<Name LcId="1033">Drive</Name><Name LcId="1031">Antrieb</Name>
<Info><Electrical><EBusCurrent>-500</EBusCurrent></Electrical></Info><GroupType>G</GroupType>
<Fmmu>Outputs</Fmmu><Fmmu>Inputs</Fmmu><Fmmu>MBoxState</Fmmu>
<Sm DefaultSize="128" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>
<Sm DefaultSize="128" StartAddress="#x1080" ControlByte="#x22" Enable="1">MBoxIn</Sm>
<Sm StartAddress="#x1100" ControlByte="#x64" Enable="1" OpOnly="1">Outputs</Sm>
<Sm DefaultSize="7" StartAddress="#x1180" ControlByte="#x20" Enable="1">Inputs</Sm>
<RxPdo Sm="2" Fixed="1" Mandatory="1"><Index>#x1600</Index><Name>Outputs</Name>
<Entry><Index>#x6040</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Control</Name><DataType>UINT</DataType></Entry>
<Entry><Index>#x0</Index><BitLen>8</BitLen></Entry></RxPdo>
<TxPdo Fixed="1"><Index>#x1A00</Index><Name>Inputs</Name>
<Entry><Index>#x6041</Index><BitLen>16</BitLen><Name>Control</Name><DataType>WORD</DataType></Entry></TxPdo>
<Mailbox DataLinkLayer="1"><CoE SdoInfo="1" CompleteAccess="1"/><FoE/></Mailbox>
<Dc><OpMode><Name>Free</Name><AssignActivate>0</AssignActivate></OpMode>
<OpMode><Name>DC</Name><Desc>with SYNC0</Desc><AssignActivate>#x300</AssignActivate>
<CycleTimeSync0 Factor="-4">0</CycleTimeSync0><ShiftTimeSync0>-20000</ShiftTimeSync0>
<CycleTimeSync1 Factor="1">0</CycleTimeSync1><ShiftTimeSync1>500</ShiftTimeSync1></OpMode></Dc>
<Eeprom><ByteSize>4096</ByteSize><ConfigData>0506034C6400</ConfigData><BootStrap>0010000100110001</BootStrap>
<Category><CatNo>1</CatNo><Data>D60806</Data></Category></Eeprom></Device>"""


def test_a_whole_image_byte_for_byte():
    """The order of the strings is that in which vendor tools fill the table: order code, group, name, OpModes, PDOs."""
    header = b"".join(
        (
            bytes.fromhex("0506 034C 6400 0000 0000 0000 0000 0000"),
            bytes.fromhex("5C0E0000 06240000 8F000100 00000000"),
            bytes(8),
            bytes.fromhex("0010 0001 0011 0001"),
            bytes.fromhex("0010 8000 8010 8000"),
            bytes.fromhex("0C00"),
            bytes(66),
            bytes.fromhex("1F00 0100"),  # 4096 bytes are 32 KiBit
        )
    )
    strings = b"".join(
        bytes([len(text)]) + text
        for text in (b"XY1", b"G", b"Group", b"Drive", b"Free", b"DC", b"Inputs", b"Control", b"Outputs")
    )
    general = b"".join(
        (
            bytes.fromhex("02 00 01 04"),
            bytes.fromhex("00 23 01 00"),  # SDO, SDO information, complete access; FoE
            bytes.fromhex("00 00 00 06"),  # not LRW, mailbox data link layer
            struct.pack("<h", -500),
            bytes.fromhex("03 00"),
            bytes.fromhex("1130"),  # port 0 and 1 MII, port 2 not used, port 3 EBUS
            bytes(14),
        )
    )
    sync_managers = bytes.fromhex(
        "0010 8000 26 00 01 01  8010 8000 22 00 01 02  0011 0000 64 00 09 03  8011 0700 20 00 01 04"
    )
    tx_pdos = bytes.fromhex("001A 01 FF 00 07 1000") + bytes.fromhex("4160 00 08 06 10 0000")
    rx_pdos = bytes.fromhex("0016 02 02 00 09 1100") + bytes.fromhex("4060 00 08 06 10 0000  0000 00 00 00 08 0000")
    clocks = struct.pack("<IIIhHhBBI", 0, 0, 0, 0, 0, 1, 5, 0, 0)
    clocks += struct.pack("<IiIhHhBBI", 0, -20000, 500, 1, 0x300, -4, 6, 0, 0)
    expected = by_hand.image(
        (1, bytes.fromhex("D60806FF")),
        (10, b"\x09" + strings + b"\xff" * ((1 + len(strings)) % 2)),
        (30, general),
        (40, bytes.fromhex("01 02 03 FF")),
        (41, sync_managers),
        (50, tx_pdos),
        (51, rx_pdos),
        (60, clocks),
        header=header,
    )
    (info,) = read(esi(DRIVE)).document.infos
    assert encode_sii(sii_image(VENDOR, info.groups[0], info.devices[0])) == expected


def test_the_language_is_chosen_and_falls_back():
    german = image_of(esi(DRIVE), language=1031)
    assert german.text(german.general.name_string_number) == "Antrieb"
    assert german.text(german.general.group_name_string_number) == "Group", "what has no German text stays"
    french = image_of(esi(DRIVE), language=1036)
    assert french.text(french.general.name_string_number) == "Drive"


@pytest.mark.parametrize(
    ("config_data", "expected"),
    [
        ("000D", (0x0D00, 0, 0, 0, 0, 0, 0)),
        ("0401000000000f00", (0x0104, 0, 0, 0x000F, 0, 0, 0)),
        ("050E0306102700", (0x0E05, 0x0603, 0x2710, 0, 0, 0, 0)),
        ("0102030405060708090A0B0C0D0E", (0x0201, 0x0403, 0x0605, 0x0807, 0x0A09, 0x0C0B, 0x0E0D)),
        ("0102030405060708090A0B0C0D0E5500", (0x0201, 0x0403, 0x0605, 0x0807, 0x0A09, 0x0C0B, 0x0E0D)),
        ("", (0,) * 7),
    ],
)
def test_config_data_are_the_first_words_and_the_check_sum_is_computed(config_data, expected):
    found = image(f"<Eeprom><ByteSize>2048</ByteSize><ConfigData>{config_data}</ConfigData></Eeprom>")
    assert words(found, 0, 7) == expected
    data = encode_sii(found)
    assert words(found, 7, 1) == (by_hand.remainder_crc(data[:14]),)


@pytest.mark.parametrize(
    ("byte_size", "size_word"), [("128", 0), ("256", 1), ("2048", 15), ("4096", 31), ("65536", 511), (None, 15)]
)
def test_the_size_word_counts_kibit_minus_one(byte_size, size_word):
    element = f"<ByteSize>{byte_size}</ByteSize>" if byte_size else ""
    assert image(f"<Eeprom>{element}<ConfigData>00</ConfigData></Eeprom>").header.size_word == size_word


def test_mailbox_words_come_from_the_mailbox_sync_managers():
    found = image(
        '<Sm StartAddress="#x1800" DefaultSize="1024">MBoxOut</Sm><Sm StartAddress="#x1c00">MBoxIn</Sm><Sm>Outputs</Sm>'
    )
    assert words(found, 0x18, 4) == (0x1800, 1024, 0x1C00, 0)
    assert words(found, 0x14, 4) == (0, 0, 0, 0)
    assert words(image("<Sm StartAddress='#x1000' DefaultSize='8'>Outputs</Sm>"), 0x18, 4) == (0, 0, 0, 0)


@pytest.mark.parametrize(
    ("sync_managers", "usages", "mailbox"),
    [
        (("#x26", "#x22", "#x64", "#x20"), [1, 2, 3, 4], (0x1000, 64, 0x1100, 64)),
        (("#x22", "#x26", "#x64", "#x20"), [2, 1, 3, 4], (0x1100, 64, 0x1000, 64)),
        (("#x2A", "#x22", "#x26", "#x20"), [0, 2, 3, 4], (0, 0, 0x1100, 64)),
    ],
)
def test_sync_managers_without_a_role_are_known_by_mode_direction_and_pdos(sync_managers, usages, mailbox):
    """As ``ethercat xml`` writes them. A PDO tells what a SyncManager is for, also in mailbox mode."""
    content = "".join(
        f'<Sm StartAddress="#x1{n}00" DefaultSize="64" ControlByte="{control}" Enable="1"/>'
        for n, control in enumerate(sync_managers)
    )
    pdos = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"')
    found = image(content + pdos)
    assert [sm.usage_code for sm in found.sync_managers] == usages
    assert words(found, 0x18, 4) == mailbox


def test_a_word_of_the_vendor_is_no_mailbox():
    found = image('<Sm StartAddress="#x1000" DefaultSize="64" ControlByte="#x26" Enable="1">Mine</Sm>')
    assert [sm.usage_code for sm in found.sync_managers] == [0]
    assert words(found, 0x18, 4) == (0, 0, 0, 0)


@pytest.mark.parametrize("boot_strap", ["00108000", ""])
def test_an_incomplete_boot_strap_is_none(boot_strap):
    found = image(f"<Eeprom><ByteSize>2048</ByteSize><BootStrap>{boot_strap}</BootStrap></Eeprom>")
    assert words(found, 0x14, 4) == (0, 0, 0, 0)


@pytest.mark.parametrize(
    ("element", "bit"), [("AoE", 1), ("EoE", 2), ("CoE", 4), ("FoE", 8), ("SoE", 0x10), ("VoE", 0x20)]
)
def test_each_protocol_has_its_bit(element, bit):
    assert image(f"<Mailbox><{element}/></Mailbox>").header.mailbox_protocols == MailboxProtocols(bit)


@pytest.mark.parametrize(
    ("attribute", "bit"),
    [
        ("", 0),
        ('SdoInfo="1"', 0x02),
        ('PdoAssign="true"', 0x04),
        ('PdoConfig="1"', 0x08),
        ('PdoUpload="1"', 0x10),
        ('CompleteAccess="1"', 0x20),
        ('SegmentedSdo="1"', 0),
        ('SdoInfo="0"', 0),
    ],
)
def test_coe_details(attribute, bit):
    assert image(f"<Mailbox><CoE {attribute}/></Mailbox>").general.coe_details == CoeDetails(1 | bit)
    assert image("<Mailbox><FoE/></Mailbox>").general.coe_details == 0


@pytest.mark.parametrize(("attribute", "channels"), [("", 1), ('ChannelCount="2"', 2), ('ChannelCount="0"', 0)])
def test_soe_has_one_channel_unless_it_says_more(attribute, channels):
    assert image(f"<Mailbox><SoE {attribute}/></Mailbox>").general.soe_channels == channels
    assert image("<Mailbox><CoE/></Mailbox>").general.soe_channels == 0


@pytest.mark.parametrize(
    ("info", "flags", "address"),
    [
        ("<IdentificationReg134>true</IdentificationReg134>", GeneralFlags.IDENT_AL_STATUS, 0),
        ("<IdentificationReg134>false</IdentificationReg134>", GeneralFlags(0), 0),
        ("<IdentificationAdo>#x1000</IdentificationAdo>", GeneralFlags.IDENT_PHYSICAL_MEMORY, 0x1000),
        ("<IdentificationAdo>#x0134</IdentificationAdo>", GeneralFlags.IDENT_AL_STATUS, 0),
        ("<IdentificationAdo>0</IdentificationAdo>", GeneralFlags(0), 0),
    ],
)
def test_explicit_device_identification(info, flags, address):
    general = image(f"<Info>{info}</Info>").general
    assert (general.flags, general.identification_address) == (flags, address)


@pytest.mark.parametrize(("attribute", "flag"), [("TcCfgModeSafeOp", 1), ("UseLrdLwr", 2)])
def test_flags_of_the_type(attribute, flag):
    text = esi(device()).replace("<Type ", f'<Type {attribute}="true" ')
    assert image_of(text).general.flags == flag


@pytest.mark.parametrize(
    ("physics", "ports"),
    [
        ("YY", 0x0011),
        ("KK", 0x0033),
        ("YKY", 0x0131),
        ("YY K", 0x3011),
        ("KK Y", 0x1033),
        ("HKH", 0x0434),
        ("Y", 0x0001),
        ("yy", 0x0011),
        ("BK", 0x0032),
        ("", 0),
    ],
)
def test_a_port_is_four_bits(physics, ports):
    assert image_of(esi(device()).replace('Physics="YY"', f'Physics="{physics}"')).general.physical_ports == ports


@pytest.mark.parametrize(("physics", "code"), [("YY", 1), ("YKY", 2), ("KK", 12), ("YYY", 0)])
def test_the_reserved_code_of_physics_is_that_of_real_images(physics, code):
    """AKD (YY), EK1100 (YKY) and EL2004 (KK) carry it in byte 4 of General."""
    assert image_of(esi(device()).replace('Physics="YY"', f'Physics="{physics}"')).general.legacy_ports == code


@pytest.mark.parametrize(
    ("usages", "codes"),
    [
        (("Outputs",), [1, 0xFF]),
        (("Inputs", "Outputs"), [2, 1]),
        (("Outputs", "Inputs", "MBoxState"), [1, 2, 3, 0xFF]),
        (("DynamicOutputs", ""), [0xFF, 0xFF]),
        ((), []),
    ],
)
def test_fmmus_are_padded_with_0xff(usages, codes):
    found = image("".join(f"<Fmmu>{usage}</Fmmu>" for usage in usages))
    assert [fmmu.usage_code for fmmu in found.fmmus] == codes


@pytest.mark.parametrize(
    ("element", "stored"),
    [
        ('<Sm StartAddress="#x1100" ControlByte="#x24" Enable="1">Outputs</Sm>', "0011 0000 24 00 01 03"),
        ('<Sm StartAddress="#x0f00" ControlByte="#x44" Enable="1" OpOnly="1">Outputs</Sm>', "000F 0000 44 00 09 03"),
        ('<Sm MinSize="1" MaxSize="9" DefaultSize="3" Enable="0">Inputs</Sm>', "0000 0300 00 00 00 04"),
        ('<Sm StartAddress="#x910" Virtual="1">Inputs</Sm>', "1009 0000 00 00 04 04"),
        ('<Sm Enable="9" ControlByte="#x20">Inputs</Sm>', "0000 0000 20 00 09 04"),
        ('<Sm Enable="1" FixedAssignment="1">Inputs</Sm>', "0000 0000 00 00 03 04"),
        ('<Sm Enable="1">DynamicOutputs</Sm>', "0000 0000 00 00 01 00"),
    ],
)
def test_sync_managers(element, stored):
    content = element + pdo("TxPdo", "#x1A00", 16, attributes='Sm="0"')
    data = encode_sii(image(content))
    assert bytes.fromhex("2900 0400" + stored) in data, "the length is the declared one, never computed"


@pytest.mark.parametrize(
    ("attributes", "index_attributes", "flags"),
    [
        ('Sm="0"', "", 0x0000),
        ('Mandatory="1"', "", 0x0001),
        ('Fixed="true"', "", 0x0010),
        ('Mandatory="1" Fixed="1"', "", 0x0011),
        ('Virtual="1"', "", 0x0020),
        ("", 'DependOnSlot="1"', 0x0200),
        ("", 'DependOnSlotGroup="1"', 0x0400),
        ('OverwrittenByModule="1"', "", 0x0800),
    ],
)
def test_pdo_flags(attributes, index_attributes, flags):
    (found,) = image(f"<TxPdo {attributes}><Index {index_attributes}>#x1A00</Index><Name>T</Name></TxPdo>").tx_pdos
    assert found.flags == flags
    assert found.sm == (0 if "Sm" in attributes else 0xFF), "0xFF: not assigned"


def test_pdos_keep_their_order_and_oversampling_is_not_expanded():
    content = pdo("RxPdo", "#x1602", 8) + pdo("RxPdo", "#x1600", 1, 7, attributes='OSFac="4"')
    assert [(item.pdo_index, item.bit_length) for item in image(content).rx_pdos] == [(0x1602, 8), (0x1600, 8)]
    types = [category.category_type for category in image(content).categories]
    assert types == [10, 30, 51], "without a TxPDO there is no category 50"


@pytest.mark.parametrize(
    ("data_type", "code"),
    [
        ("BOOL", 0x01),
        ("SINT", 0x02),
        ("INT", 0x03),
        ("DINT", 0x04),
        ("USINT", 0x05),
        ("UINT", 0x06),
        ("UDINT", 0x07),
        ("REAL", 0x08),
        ("STRING(8)", 0x09),
        ("ARRAY [0..3] OF BYTE", 0x0A),
        ("INT24", 0x10),
        ("LREAL", 0x11),
        ("LINT", 0x15),
        ("UINT24", 0x16),
        ("ULINT", 0x1B),
        ("BIT2", 0x31),
        ("BITARR8", 0x2D),
        ("BYTE", 0x05),
        ("WORD", 0x06),
        ("DWORD", 0x07),
        ("DT7000", 0x00),
        ("", 0x00),
    ],
)
def test_data_types_have_the_codes_of_real_images(data_type, code):
    entry = f"<Entry><Index>#x7000</Index><BitLen>8</BitLen><Name>e</Name><DataType>{data_type}</DataType></Entry>"
    (found,) = image(f"<RxPdo><Index>#x1600</Index><Name>R</Name>{entry}</RxPdo>").rx_pdos
    assert found.entries[0].data_type_code == code


def test_of_padding_only_length_and_name_count():
    entry = "<Entry><Index>0</Index><SubIndex>3</SubIndex><BitLen>4</BitLen><Name>gap</Name><DataType>UDINT</DataType>"
    found = image(f"<RxPdo><Index>#x1600</Index><Name>R</Name>{entry}</Entry></RxPdo>")
    (entry,) = found.rx_pdos[0].entries
    assert (entry.entry_index, entry.subindex, entry.data_type_code, entry.bit_length) == (0, 0, 0, 4)
    assert found.text(entry.name_string_number) == "gap"


def test_a_pdo_without_index_is_left_out():
    assert image('<RxPdo Ref="Shared" Sm="0"/>').rx_pdos == ()


def op_mode(content: str = "", name: str = "m", assign_activate: str = "#x300") -> str:
    return f"<OpMode><Name>{name}</Name><AssignActivate>{assign_activate}</AssignActivate>{content}</OpMode>"


@pytest.mark.parametrize(
    ("content", "cycle", "factor"),
    [
        ("", 0, 1),
        ('<CycleTimeSync0 Factor="1">0</CycleTimeSync0>', 0, 1),
        ('<CycleTimeSync0 Factor="0">0</CycleTimeSync0>', 0, 0),
        ('<CycleTimeSync0 Factor="-8">0</CycleTimeSync0>', 0, -8),
        ("<CycleTimeSync0>250000</CycleTimeSync0>", 250000, 0),
    ],
)
def test_sync0_of_an_op_mode(content, cycle, factor):
    (found,) = image(f"<Dc>{op_mode(content)}</Dc>").dc_modes
    assert (found.cycle_time_sync0_ns, found.cycle_time_sync0_factor) == (cycle, factor)
    assert (found.assign_activate, found.description_string_number) == (0x300, 0)


def test_sync1_of_an_op_mode():
    content = '<CycleTimeSync1 Factor="-1">0</CycleTimeSync1><ShiftTimeSync1>-7</ShiftTimeSync1>'
    (found,) = image(f"<Dc>{op_mode(content)}</Dc>").dc_modes
    assert (found.cycle_time_sync1_factor, found.shift_time_sync1_ns) == (-1, -7)


def test_a_shift_time_written_as_a_large_number_is_stored_with_its_bits():
    """4294967046 is 0xFFFFFF06, which is -250."""
    stored = DC_MODE.write(image(f"<Dc>{op_mode('<ShiftTimeSync0>4294967046</ShiftTimeSync0>')}</Dc>").dc_modes[0])
    assert stored[4:8].hex(" ") == "06 ff ff ff"


def test_negative_shift_times_are_stored_as_two_s_complement():
    """Bytes 4 to 11 of an OpMode: -250 is 0xFFFFFF06, -7 is 0xFFFFFFF9."""
    content = "<ShiftTimeSync0>-250</ShiftTimeSync0><ShiftTimeSync1>-7</ShiftTimeSync1>"
    stored = DC_MODE.write(image(f"<Dc>{op_mode(content)}</Dc>").dc_modes[0])
    assert stored[4:12].hex(" ") == "06 ff ff ff f9 ff ff ff"


def test_superseded_op_modes_are_left_out():
    def marked(attribute: str) -> str:
        return f"<VendorSpecific><TwinCAT {attribute}/></VendorSpecific>"

    old, new = marked('IgnoreFromBuildNo="1506"'), marked('UseFromBuildNo="1506"')
    found = image(f"<Dc>{op_mode(old, 'old')}{op_mode(new, 'new')}{op_mode(name='plain')}</Dc>")
    assert [found.text(mode.name_string_number) for mode in found.dc_modes] == ["new", "plain"]


def test_equal_texts_share_a_string():
    found = image(pdo("RxPdo", "#x1600", 8, 8) + pdo("TxPdo", "#x1A00", 8))
    assert [found.text(number) for number in range(1, 9)] == [
        "T1",
        "G",
        "Group",
        "N",
        "TxPdo #x1A00",
        "e1",
        "RxPdo #x1600",
        "e2",
    ]
    entries = (*found.tx_pdos[0].entries, *found.rx_pdos[0].entries)
    assert [entry.name_string_number for entry in entries] == [6, 6, 8]


@pytest.mark.parametrize(("text", "stored"), [("x" * 300, 255), ("é" * 300, 255), ("温" * 100, 255), ("x" * 255, 255)])
def test_long_texts_are_cut_to_255_bytes(text, stored):
    found = image_of(esi(device(name=text)))
    name = found.text(found.general.name_string_number)
    assert text.startswith(name)
    assert len(found.categories[0].strings[3].data) == stored


def test_a_device_without_codes_group_and_names():
    found = image_of("<EtherCATInfo><Vendor/><Descriptions><Devices><Device/></Devices></Descriptions></EtherCATInfo>")
    assert words(found, 8, 8) == (0,) * 8
    assert [category.category_type for category in found.categories] == [10, 30]
    assert found.general.order_string_number == found.general.name_string_number == 0
    assert found.findings == ()


def test_a_group_that_the_document_does_not_define_gives_its_type_only():
    text = esi(device()).replace("<Groups><Group><Type>G</Type><Name>Group</Name></Group></Groups>", "")
    general = image_of(text).general
    assert (general.group_string_number, general.group_name_string_number) == (2, 0)


def test_pdos_of_modules_are_no_part_of_the_image():
    slots = '<Slots><Slot MinInstances="1" MaxInstances="1"><ModuleIdent Default="1">1</ModuleIdent></Slot></Slots>'
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>M</Name>{pdo("RxPdo", "#x1600", 8)}</Module>'
    assert image_of(esi(device(slots), module)).rx_pdos == ()


@pytest.mark.parametrize(
    ("content", "data"),
    [
        ("<Data>AABBCC</Data>", bytes.fromhex("AABBCCFF")),
        ("<DataString>AB</DataString>", b"AB\0\xff"),
        ("<DataString>ABC</DataString>", b"ABC\0"),
        ("<DataUINT>4660</DataUINT>", bytes.fromhex("3412")),
        ("<DataUDINT>305419896</DataUDINT>", bytes.fromhex("78563412")),
        ("<DataUINT>-1</DataUINT>", bytes.fromhex("FFFF")),
    ],
)
def test_declared_categories_come_first(content, data):
    eeprom = f"<Eeprom><ByteSize>2048</ByteSize><Category><CatNo>2048</CatNo>{content}</Category></Eeprom>"
    first = image(eeprom).categories[0]
    assert first == RawCategory(category_type=2048, data=data)


@pytest.mark.parametrize("number", ["30", "40", "65535", "-1"])
def test_a_declared_category_does_not_stand_beside_the_computed_one(number):
    category = f"<Category><CatNo>{number}</CatNo><Data>DEADBEEF</Data></Category>"
    found = image(f"<Fmmu>Outputs</Fmmu><Eeprom><ByteSize>2048</ByteSize>{category}</Eeprom>")
    assert found.of_type(RawCategory) == ()
    assert [fmmu.usage_code for fmmu in found.fmmus] == [1, 0xFF]


def test_a_whole_image_in_the_description_is_taken_as_it_stands():
    found = image_of(esi(device(f"<Eeprom><Data>{by_hand.WHOLE.hex()}</Data></Eeprom>")))
    assert encode_sii(found) == by_hand.WHOLE


OF_DEVICE = by_hand.image(
    *by_hand.CATEGORIES,
    header=by_hand.HEADER[:16] + struct.pack("<III", VENDOR, 1, 1) + by_hand.HEADER[28:],
    end=by_hand.END + b"\xff" * 6,
)
"""A whole image with the identity of the device that the tests describe."""


def with_data(data: bytes):
    return subject(f"<Eeprom><Data>{data.hex()}</Data></Eeprom>")


def written(data: bytes) -> bytes:
    described = with_data(data)
    found = described_image(described)
    image = check_image(found, eeprom_bytes(found.header, described.device))
    assert fit_image(found, eeprom_bytes(found.header, described.device)) == (image, ())
    return encode_sii(image)


@pytest.mark.parametrize("behind", [bytes(300), bytes(300) + b"\xff" * 40, b"\xff" * 9 + b"CALI" + bytes(10), b"\xff"])
def test_what_is_behind_the_end_mark_of_a_whole_image_is_written(behind):
    assert written(OF_DEVICE + behind) == (OF_DEVICE + behind).ljust(2048, b"\xff")


def test_a_whole_image_longer_than_its_size_word_says_is_written_whole():
    """The size word at byte 0x7C: 0 is 128 bytes."""
    data = OF_DEVICE[:0x7C] + b"\0\0" + OF_DEVICE[0x7E:]
    assert written(data) == data
    assert eeprom_remarks(with_data(data))[1:] == (
        f"Eeprom/Data: size word at byte 0x7C says 128 bytes; the image has {len(data)}.",
    )


TAKEN = "The description holds the whole image (Eeprom/Data), which is taken in place of a computed one."


def test_what_is_odd_about_a_whole_image_is_remarked():
    assert eeprom_remarks(with_data(OF_DEVICE)) == (TAKEN,)
    wrong = bytes([OF_DEVICE[14] ^ 1])
    assert eeprom_remarks(with_data(OF_DEVICE[:14] + wrong + OF_DEVICE[15:])) == (
        TAKEN,
        f"Eeprom/Data: check sum at byte 0xE is 0x{wrong[0]:02X}; the words 0 to 6 need 0x{OF_DEVICE[14]:02X}.",
    )
    assert eeprom_remarks(with_data(by_hand.WHOLE)) == (
        TAKEN,
        "The identity in Eeprom/Data is 0x0000079a:0xdeadbeef:0x00010002, that of the description "
        "0x00000e5c:0x00000001:0x00000001; do not write this image, the device would be taken for another.",
    )
    assert eeprom_remarks(with_data(b"\0\1"))[1].startswith("Eeprom/Data cannot be read: no SII image")


@pytest.mark.parametrize(
    "content",
    [
        "<Data>01020</Data>",
        "<DataUINT>65536</DataUINT>",
        "<DataUINT>-32769</DataUINT>",
        "<DataUINT>two</DataUINT>",
        "<DataUDINT>4294967296</DataUDINT>",
    ],
)
def test_a_declared_category_that_cannot_be_stored_as_said_is_left_out(content):
    eeprom = f"<Eeprom><ByteSize>2048</ByteSize><Category><CatNo>2048</CatNo>{content}</Category></Eeprom>"
    assert image(eeprom).of_type(RawCategory) == ()


def test_a_broken_image_in_the_description_is_named():
    with pytest.raises(SiiImageError, match=r"Eeprom/Data of T1 \(x.xml, line 1\): no SII image"):
        described_image(with_data(b"\0\x11"))


def test_a_broken_image_is_no_image():
    with pytest.raises(SiiImageError, match="no SII image"):
        image("<Eeprom><Data>0011</Data></Eeprom>")
