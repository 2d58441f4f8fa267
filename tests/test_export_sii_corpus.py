"""Images of real descriptions: against the EEPROMs of real devices, and every device against its own image.

Images are taken apart here with ``struct`` alone, and expectations come from the description by the format's rules.
"""

import re
import struct
from collections import Counter
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from test_drive_modes import all_devices

from esicatalog.esi.containers import Archive
from esicatalog.esi.reader import Reader
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import EsiInfo, Group
from esicatalog.export.sii import sii_image
from esicatalog.export.sii_limits import SiiLimitError, check_image, fit_image
from esicatalog.export.sii_merge import merge_image
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.files import image_of_file
from esicatalog.sii.image import MAX_IMAGE_BYTES, Strings

GERMAN = 1031


def group_of(info: EsiInfo, device: Device) -> Group | None:
    return next((group for group in info.groups if group.type == device.group_type), None)


def vendor_of(info: EsiInfo) -> int | None:
    return info.vendor.vendor_id if info.vendor is not None else None


class Parts(NamedTuple):
    """An image taken apart; records without their string numbers, texts beside them."""

    header: bytes
    categories: list[tuple[int, bytes]]
    strings: list[str]

    def category(self, number: int) -> bytes:
        return b"".join(data for kind, data in self.categories if kind == number)

    def text(self, number: int) -> str:
        return self.strings[number - 1] if 0 < number <= len(self.strings) else ""

    def header_words(self, first: int, count: int) -> tuple[int, ...]:
        return struct.unpack_from(f"<{count}H", self.header, 2 * first)

    @property
    def general(self) -> bytes:
        return self.category(30)

    def general_text(self, offset: int) -> str:
        return self.text(self.general[offset])

    @property
    def sync_managers(self) -> list[tuple[int, ...]]:
        return list(struct.iter_unpack("<HHBBBB", self.category(41)))

    @property
    def op_modes(self) -> list[tuple[Any, ...]]:
        return [
            (*values[:6], self.text(values[6]), self.text(values[7]))
            for values in struct.iter_unpack("<IIIhHhBBI", self.category(60))
        ]

    def pdos(self, number: int) -> list[tuple[Any, ...]]:
        """Index, SyncManager, DC sync, name, flags, entries of every PDO."""
        data, offset, found = self.category(number), 0, []
        while offset < len(data):
            index, count, sm, dc_sync, name, flags = struct.unpack_from("<HBBBBH", data, offset)
            entries = []
            for start in range(offset + 8, offset + 8 + 8 * count, 8):
                entry, subindex, text, code, bits, reserved = struct.unpack_from("<HBBBBH", data, start)
                entries.append((entry, subindex, self.text(text), code, bits, reserved))
            found.append((index, sm, dc_sync, self.text(name), flags, entries))
            offset += 8 + 8 * count
        return found


def taken_apart(data: bytes) -> Parts:
    categories, offset = [], 128
    while offset + 4 <= len(data) and data[offset : offset + 2] != b"\xff\xff":
        kind, count = struct.unpack_from("<HH", data, offset)
        categories.append((kind, data[offset + 4 : offset + 4 + 2 * count]))
        offset += 4 + 2 * count
    strings: list[str] = []
    for kind, table in categories:
        position = 1
        for _ in range(table[0] if kind == 10 else 0):
            end = position + 1 + table[position]
            text = table[position + 1 : end].rstrip(b"\0")
            try:
                strings.append(text.decode())
            except UnicodeDecodeError:
                strings.append(text.decode("cp1252"))
            position = end
    return Parts(data[:128], categories, strings)


def compared(parts: Parts) -> dict[str, Any]:
    """What is compared with a real EEPROM, by name."""

    def without_names(pdos: list[tuple[Any, ...]]) -> list[Any]:
        return [
            (index, sm, dc_sync, flags, [(e, s, c, b, r) for e, s, _, c, b, r in entries])
            for index, sm, dc_sync, _, flags, entries in pdos
        ]

    general = parts.general
    return {
        "PDI words": parts.header_words(0, 8),
        "identity": parts.header_words(8, 6),
        "mailboxes": parts.header_words(0x14, 9),
        "size": parts.header_words(0x3E, 2),
        "General": general[4:14] + general[15:],
        "FMMU": parts.category(40),
        "SyncM": parts.category(41),
        "TxPDO": without_names(parts.pdos(50)),
        "RxPDO": without_names(parts.pdos(51)),
        "DC": [values[:6] for values in parts.op_modes],
        "texts": (
            [parts.general_text(offset) for offset in (0, 1, 2, 3, 14)],
            [[name, *(entry[2] for entry in entries)] for n in (50, 51) for *_, name, _, entries in parts.pdos(n)],
        ),
        "OpMode texts": [values[6:] for values in parts.op_modes],
        "categories": [kind for kind, _ in parts.categories],
    }


class Dump(NamedTuple):
    """An EEPROM, the description of its device, and what differs with the reason."""

    eeprom: str
    archive: str
    member: str
    type: str
    differs: dict[str, str]
    language: int | None = None


ETHERCRAB = "ethercrab-rs+ethercrab/dumps__"
EASYCAT = "Seobuk+Easycat_config/EasyConfigurator_V4_2__StandardMode_BinFiles__EasyCAT_"
EXAMPLES = "dslemusp+EasyCAT/examples__"
SOES = "OpenEtherCATsociety+SOES/applications__"
CUT = {"OpMode texts": "TwinCAT cuts names of OpModes to 15 characters; the format holds 255 and loses nothing"}
OTHER_TOOL = {
    "General": "that tool leaves the reserved byte 4 zero",
    "DC": "that tool stores factor 0 where CycleTimeSync0 is absent",
    "OpMode texts": "that tool stores the name as description too",
}
SOES_EDITOR = {
    "General": "that tool stores no ports, another byte 4 and no flag for DataLinkLayer",
    "TxPDO": "that tool stores no PDOs",
    "RxPDO": "that tool stores no PDOs",
    "texts": "that tool stores neither the group's name nor names of PDOs",
    "categories": "that tool stores no PDOs",
}
SOES_ZIP = "OpenEtherCATsociety+SOES.zip"
AX58100 = "AIMEtherCAT+EcatV2_AX58100_H750_Universal/ecat__device__"
UNIVERSAL = "58100_H750_UniversalModule"
ZERO_PADDED = {"FMMU": "that tool pads with 0x00 instead of 0xFF"}
DC_TOO = {
    **SOES_EDITOR,
    **ZERO_PADDED,
    "DC": "that tool stores no OpModes",
    "OpMode texts": "that tool stores no OpModes",
}
IGH_XML = dict.fromkeys(
    [
        "PDI words",
        "mailboxes",
        "General",
        "FMMU",
        "TxPDO",
        "RxPDO",
        "DC",
        "texts",
        "OpMode texts",
        "categories",
    ],
    "what the IgH tool printed of a configured device: no Eeprom, Mailbox, Fmmu, Dc",
)
DUMPS = [
    Dump(
        f"{ETHERCRAB}eeprom__ek1100.hex", "DiamondLightSource+ethercat.zip", "Beckhoff EK11xx.xml", "EK1100", {}, GERMAN
    ),
    Dump(
        f"{ETHERCRAB}eeprom__ek1100.hex",
        "DiamondLightSource+ethercat.zip",
        "Beckhoff EK11xx.xml",
        "EK1100",
        {"texts": "the device was written with German texts"},
    ),
    Dump(
        f"{ETHERCRAB}Term 5 (EL2004).bin",
        "DiamondLightSource+ethercat.zip",
        "Beckhoff EL2xxx.xml",
        "EL2004",
        {
            "texts": "the group's German name has another spelling in later descriptions",
            "categories": "43 (SyncUnit) is not computed",
        },
        GERMAN,
    ),
    *(
        Dump(f"{EASYCAT}{n}_{n}_rev_1.bin", "dslemusp+EasyCAT.zip", "EasyCAT_V2_0.xml", f"EasyCAT {n}+{n} rev 1", CUT)
        for n in (16, 64, 128)
    ),
    *(
        Dump(f"{EXAMPLES}{name}__{name}.bin", "dslemusp+EasyCAT.zip", f"/{name}.xml", name, OTHER_TOOL)
        for name in ("DemoHMI_Custom", "LAB_1", "LAB_2", "TestEasyCAT_Custom", "myCustomSlave")
    ),
    Dump(f"{SOES}linux_lan9252demo__slave.bin", SOES_ZIP, "/linux_lan9252demo/slave.xml", "evb9252_dig", SOES_EDITOR),
    Dump(
        f"{SOES}raspberry_lan9252demo__slave.bin",
        SOES_ZIP,
        "/raspberry_lan9252demo/slave.xml",
        "evb9252_dig",
        SOES_EDITOR,
    ),
    Dump(f"{SOES}rtl_lwip_eoe__slave30.bin", SOES_ZIP, "/slave30.xml", "slave30", SOES_EDITOR | ZERO_PADDED),
    Dump(f"{SOES}tiesc_k2gice__k2gice.bin", SOES_ZIP, "/k2gice.xml", "k2gice", SOES_EDITOR | ZERO_PADDED),
    Dump(f"{SOES}tiesc_am335x__am335xice.bin", SOES_ZIP, "/am335xice.xml", "am335xice", SOES_EDITOR | ZERO_PADDED),
    Dump(
        f"{SOES}rtl_xmc4_dynpdo__sii_eeprom.bin",
        SOES_ZIP,
        "/rtl_xmc4_dynpdo/slave.xml",
        "xmc48relax",
        SOES_EDITOR | ZERO_PADDED,
    ),
    Dump(
        f"{SOES}rtl_slavedemo__RTL_ATO_SPI_SLAVE.bin",
        SOES_ZIP,
        "/RTL_ATO.xml",
        "ATO sample application",
        {
            "General": "that tool stores no ports; the description has PdoUpload since",
            "DC": "that tool stores no OpModes",
            "OpMode texts": "that tool stores no OpModes",
            "categories": "that tool stores no OpModes",
            "texts": "the description has another type since",
        },
    ),
    *(
        Dump(f"{AX58100}{name}.bin", f"{AX58100.split('/')[0]}.zip", f"ecat/device/{name}.xml", UNIVERSAL, DC_TOO)
        for name in ("eeprom", "slave")
    ),
    Dump(
        "MetalMusings+MyOwnEtherCATDevice/Cards__EaserCAT-2000__Firmware__lib__soes__eeprom.hex",
        "MetalMusings+MyOwnEtherCATDevice.zip",
        "Cards/EaserCAT-2000/Firmware/lib/soes/MetalMusings_EaserCAT_2000.xml",
        "EaserCAT2000",
        DC_TOO,
    ),
    Dump(
        "synapticon+siitool/examples__sii_example.bin",
        "synapticon+siitool.zip",
        "Somanet_CtrlProto.xml",
        "CtrlProto Device",
        dict.fromkeys(
            ["mailboxes", "size", "General", "SyncM", "TxPDO", "RxPDO", "DC", "texts", "OpMode texts"],
            "the image of an earlier device with the same codes; the PDI words agree",
        ),
    ),
    Dump(
        "project-march+ethercat-slaves/esi__BP-GES.bin",
        "project-march+ethercat-slaves.zip",
        "esi/BP-GES.xml",
        "BP-GES",
        {
            "mailboxes": "that tool stores no protocols",
            "General": "that tool stores no ports and no flag for DataLinkLayer",
            "SyncM": "the description disables SM2 since",
            "TxPDO": "that tool stores neither flags nor types, and other entry indices",
            "texts": "that tool stores no name of the group",
        },
    ),
    Dump(f"{ETHERCRAB}eeprom__akd.hex", "AJBuilder+AKD-Ethercat-Master-history.zip", "test2.xml", "AKD", IGH_XML),
]


@pytest.fixture(scope="module")
def descriptions(corpus: Path) -> dict[tuple[str, str], list[tuple[EsiInfo, Device]]]:
    """The devices of the documents that describe dumped ones."""
    found: dict[tuple[str, str], list[tuple[EsiInfo, Device]]] = {}
    reader = Reader()
    for archive, member in dict.fromkeys((dump.archive, dump.member) for dump in DUMPS):
        opened = Archive(corpus / "esi" / archive)
        name = next(name for name, _ in opened.members() if name.endswith(member))
        infos = reader.read(opened.read(name), name, opened).document.infos
        found[archive, member] = [(info, device) for info in infos for device in info.devices]
    return found


def dumped(corpus: Path, dump: Dump) -> bytes:
    path = corpus / "sii" / dump.eeprom
    if not path.is_file():
        pytest.skip(f"no EEPROM dump {path}")
    return image_of_file(path.read_bytes()).data


def described(descriptions: Any, dump: Dump, real: bytes) -> tuple[EsiInfo, Device]:
    identity = struct.unpack_from("<III", real, 16)
    for info, device in descriptions[dump.archive, dump.member]:
        if (vendor_of(info), device.product_code, device.revision_no) == identity and device.type == dump.type:
            return info, device
    raise AssertionError(f"{dump.member} does not describe {identity}")


@pytest.mark.parametrize("dump", DUMPS, ids=lambda dump: f"{dump.type}-{dump.language or 'English'}")
def test_real_eeproms(corpus, descriptions, dump):
    """Everything that is not named as different agrees, and everything named differs."""
    real = dumped(corpus, dump)
    info, device = described(descriptions, dump, real)
    computed = encode_sii(sii_image(vendor_of(info), group_of(info, device), device, language=dump.language))
    expected, found = compared(taken_apart(real)), compared(taken_apart(computed))
    assert {part for part in expected if expected[part] != found[part]} == set(dump.differs)


@pytest.mark.parametrize("number", [16, 64, 128])
def test_images_of_twincat_byte_for_byte_but_for_one_letter(corpus, descriptions, number):
    """The longer of the two OpMode names, "SM_Sync or Async", lacks its last letter in the real images."""
    dump = next(item for item in DUMPS if item.type == f"EasyCAT {number}+{number} rev 1")
    real = dumped(corpus, dump)
    info, device = described(descriptions, dump, real)
    image = sii_image(vendor_of(info), group_of(info, device), device)
    computed = encode_sii(check_image(image, image.header.byte_size))
    strings = taken_apart(real).strings
    assert [text for text in taken_apart(computed).strings if text not in strings] == ["SM_Sync or Async"]
    cut = encode_sii(image).replace(b"\x10SM_Sync or Async", b"\x0fSM_Sync or Asyn")
    start = cut.index(b"SM_Sync or Asyn")
    assert real[:130] == cut[:130]
    assert real[132 : start + 15] == cut[132 : start + 15]
    categories = [(kind, data) for kind, data in taken_apart(real).categories if kind != 10]
    assert categories == [(kind, data) for kind, data in taken_apart(computed).categories if kind != 10]


def test_merged_into_its_own_eeprom_a_coupler_stays_byte_for_byte(corpus, descriptions):
    """The factory words 0x20 to 0x22 of the EK1100 and everything else."""
    real = dumped(corpus, DUMPS[0])
    info, device = described(descriptions, DUMPS[0], real)
    computed = sii_image(vendor_of(info), group_of(info, device), device, language=GERMAN)
    merged = merge_image(computed, decode_sii(real))
    assert merged.changes == ()
    assert merged.kept == ("words 0x1D to 0x3D",)
    assert encode_sii(check_image(merged.image, merged.byte_size)) == real


def test_merged_into_its_own_eeprom_a_terminal_changes_one_text(corpus, descriptions):
    dump = next(item for item in DUMPS if item.type == "EL2004")
    real = dumped(corpus, dump)
    info, device = described(descriptions, dump, real)
    computed = sii_image(vendor_of(info), group_of(info, device), device, language=GERMAN)
    merged = merge_image(computed, decode_sii(real))
    assert [(change.part, change.text.split(":")[0]) for change in merged.changes] == [("texts", "name of the group")]
    assert taken_apart(encode_sii(merged.image)).category(43) == taken_apart(real).category(43)


def test_merging_a_poor_description_keeps_the_drive_reachable(corpus, descriptions):
    """An AKD and what the IgH tool printed of it: PDI words, bootstrap mailbox, serial and maker's data survive."""
    dump = next(item for item in DUMPS if item.type == "AKD")
    real = dumped(corpus, dump)
    info, device = described(descriptions, dump, real)
    merged = merge_image(sii_image(vendor_of(info), None, device), decode_sii(real))
    data = encode_sii(check_image(merged.image, merged.byte_size))
    assert data[:32] == real[:32]
    assert data[0x28:0x30] == real[0x28:0x30]
    for number in (2048, 2049, 43):
        assert taken_apart(data).category(number) == taken_apart(real).category(number)
    assert merged.changes[0].part == "mailboxes"


# -- every device against its own image ------------------------------------------------------------------------------

TYPE_NAMES = {
    0x01: "BOOL BOOLEAN BIT",
    0x02: "SINT INT8",
    0x03: "INT INT16",
    0x04: "DINT INT32",
    0x05: "USINT UINT8 BYTE",
    0x06: "UINT UINT16 WORD",
    0x07: "UDINT UINT32 DWORD",
    0x08: "REAL",
    0x10: "INT24",
    0x11: "LREAL",
    0x15: "LINT INT64",
    0x16: "UINT24",
    0x1B: "ULINT UINT64",
    0x2D: "BITARR8",
    0x2E: "BITARR16",
    0x2F: "BITARR32",
    **{0x2F + bits: f"BIT{bits}" for bits in range(1, 9)},
}
"""CoE codes (ETG.1020); BYTE, WORD and DWORD as vendor tools store them."""
TYPE_CODES = {name: code for code, names in TYPE_NAMES.items() for name in names.split()}
TYPE_PATTERNS = {r"(VISIBLE_)?STRING": 0x09, r"OCTET_STRING|ARRAY.*OF (BYTE|USINT)": 0x0A, r"UNICODE_STRING": 0x0B}
PORTS = {"Y": 1, "B": 2, "K": 3, "H": 4}


def type_code(name: str | None) -> int:
    text = (name or "").strip().upper()
    if text in TYPE_CODES:
        return TYPE_CODES[text]
    return next((code for pattern, code in TYPE_PATTERNS.items() if re.match(pattern, text)), 0)


def english(names: tuple[Any, ...]) -> str:
    """The English text of a Name list, else the one without or with zero LcId, else the first."""
    for lcid in (1033, None, 0):
        for name in names:
            if name.lcid == lcid and name.text:
                return name.text
    return next((name.text for name in names if name.text), "")


def padded(text: str | None, size: int) -> bytes:
    return bytes.fromhex(text or "")[:size].ljust(size, b"\0")


def bits(*flags: Any) -> int:
    """A number from flags, lowest bit first."""
    return sum(bool(flag) << position for position, flag in enumerate(flags))


def pdo_expected(pdo: Any) -> tuple[Any, ...]:
    entries = []
    for entry in pdo.entries:
        code, index, subindex = type_code(entry.data_type), entry.entry_index, entry.subindex or 0
        if not index:
            code, index, subindex = 0, 0, 0
        entries.append((index, subindex, english(entry.names), code, entry.bit_length or 0, 0))
    flags = bits(pdo.mandatory, 0, 0, 0, pdo.fixed, pdo.virtual, 0, 0, 0, pdo.depend_on_slot, pdo.depend_on_slot_group)
    flags |= bool(pdo.overwritten_by_module) << 11
    sm = 0xFF if pdo.sm is None else pdo.sm
    return pdo.pdo_index, sm, 0, english(pdo.names), flags, entries


def op_mode_expected(mode: Any) -> tuple[Any, ...]:
    factor = mode.cycle_time_sync0_factor
    if factor is None:
        factor = 1 if mode.cycle_time_sync0_ns is None else 0
    return (
        mode.cycle_time_sync0_ns or 0,
        (mode.shift_time_sync0_ns or 0) % 2**32,
        (mode.shift_time_sync1_ns or 0) % 2**32,
        mode.cycle_time_sync1_factor or 0,
        mode.assign_activate or 0,
        factor,
        mode.name or "",
        "",
    )


def usages_expected(device: Device) -> list[str]:
    """The texts of Sm elements; empty ones as ``ethercat xml`` writes them by their PDOs, else by their ControlByte."""
    found = []
    for number, sm in enumerate(device.sync_managers):
        rx, tx = (any(pdo.sm == number for pdo in pdos) for pdos in (device.rx_pdos, device.tx_pdos))
        if rx or tx:
            usage = "" if rx and tx else "Outputs" if rx else "Inputs"
        else:
            usage = {0x6: "MBoxOut", 0x2: "MBoxIn"}.get((sm.control_byte or 0) & 0xF, "")
        found.append(sm.usage or usage)
    return found


def check_header(parts: Parts, vendor_id: int | None, device: Device) -> None:
    eeprom, mailbox = device.eeprom, device.mailbox
    assert parts.header[:14] == padded(eeprom.config_data if eeprom else None, 14)
    codes = (vendor_id, device.product_code, device.revision_no, device.serial_no)
    assert struct.unpack_from("<IIII", parts.header, 16) == tuple(code or 0 for code in codes)
    assert parts.header_words(0x10, 4) == (0, 0, 0, 0)
    assert parts.header[0x28:0x30] == padded(eeprom.boot_strap if eeprom else None, 8)
    areas = []
    for usage in ("MBoxOut", "MBoxIn"):
        usages = zip(device.sync_managers, usages_expected(device), strict=True)
        of_usage = [sm for sm, expected in usages if expected == usage]
        areas += [of_usage[0].start_address or 0, of_usage[0].default_size or 0] if of_usage else [0, 0]
    assert list(parts.header_words(0x18, 4)) == areas
    protocols = (mailbox.aoe, mailbox.eoe, mailbox.coe, mailbox.foe, mailbox.soe, mailbox.voe) if mailbox else ()
    assert parts.header_words(0x1C, 1) == (bits(*protocols),)
    assert parts.header[0x3A:0x7C] == bytes(66)
    byte_size = eeprom.byte_size if eeprom and eeprom.byte_size is not None else 2048
    assert parts.header_words(0x3E, 2) == (byte_size // 128 - 1, 1)


def check_general(parts: Parts, group: Group | None, device: Device) -> None:
    general, mailbox = parts.general, device.mailbox
    assert len(general) == 32
    assert parts.general_text(2) == (device.type or "")
    assert parts.general_text(3) == english(device.names)
    assert parts.general_text(0) == (device.group_type or "")
    assert parts.general_text(14) == (english(group.names) if group is not None else "")
    assert parts.general_text(1) == (device.image_symbol or "")
    coe = mailbox is not None and mailbox.coe
    details = bits(
        coe,
        *((mailbox.coe_sdo_info, mailbox.coe_pdo_assign, mailbox.coe_pdo_config) if coe else (False, False, False)),
        *((mailbox.coe_pdo_upload, mailbox.coe_complete_access) if coe else (False, False)),
    )
    assert general[5] == details
    assert general[6] == (mailbox is not None and mailbox.foe)
    assert general[7] == (mailbox is not None and mailbox.eoe)
    address = device.identification_ado or 0
    flags = bits(
        device.tc_cfg_mode_safe_op,
        device.use_lrd_lwr,
        mailbox is not None and mailbox.data_link_layer,
        device.identification_reg134,
        address,
    )
    assert general[11] == flags
    assert struct.unpack_from("<h", general, 12) == (device.e_bus_current_ma or 0,)
    ports = sum(PORTS.get(letter, 0) << 4 * port for port, letter in enumerate(device.physics or ""))
    assert struct.unpack_from("<HH", general, 16) == (ports, address)


def check_pdos(found: list[tuple[Any, ...]], expected: list[tuple[Any, ...]], with_entry_names: bool) -> None:
    if not with_entry_names:
        found, expected = (
            [(*pdo[:5], [(*entry[:2], *entry[3:]) for entry in pdo[5]]) for pdo in pdos] for pdos in (found, expected)
        )
    assert found == expected


def check_categories(parts: Parts, device: Device, with_entry_names: bool) -> None:
    usages = {"Outputs": 1, "Inputs": 2, "MBoxState": 3}
    fmmus = bytes(usages.get(fmmu.usage or "", 0xFF) for fmmu in device.fmmus)
    assert parts.category(40) == fmmus + b"\xff" * (len(fmmus) % 2)
    usages = {"MBoxOut": 1, "MBoxIn": 2, "Outputs": 3, "Inputs": 4}
    assert parts.sync_managers == [
        (
            sm.start_address or 0,
            sm.default_size or 0,
            sm.control_byte or 0,
            0,
            (sm.enable or 0) | bits(0, sm.fixed_assignment, sm.virtual, sm.op_only),
            usages.get(usage, 0),
        )
        for sm, usage in zip(device.sync_managers, usages_expected(device), strict=True)
    ]
    for number, pdos in ((50, device.tx_pdos), (51, device.rx_pdos)):
        expected = [pdo_expected(pdo) for pdo in pdos if pdo.pdo_index is not None]
        check_pdos(parts.pdos(number), expected, with_entry_names)
    modes = [mode for mode in device.op_modes if "IgnoreFromBuildNo" not in (mode.vendor_specific or "")]
    assert parts.op_modes == [op_mode_expected(mode) for mode in modes]
    declared = device.eeprom.categories if device.eeprom is not None else ()
    for category in declared:
        if category.cat_no not in (10, 30, 40, 41, 50, 51, 60):
            assert parts.category(category.cat_no) == bytes.fromhex(category.data)


def check_device(info: EsiInfo, device: Device) -> bool:
    """Whether the image holds everything but, where there are more than 255 texts, names of entries."""
    group = group_of(info, device)
    image = sii_image(vendor_of(info), group, device)
    has_all_texts = len(image.of_type(Strings)[0].strings) <= 255
    data = encode_sii(image if has_all_texts else fit_image(image, MAX_IMAGE_BYTES).image)
    assert all("size word" in finding for finding in decode_sii(data).findings), "nothing is odd but too large a size"
    parts = taken_apart(data)
    check_header(parts, vendor_of(info), device)
    check_general(parts, group, device)
    check_categories(parts, device, has_all_texts)
    return has_all_texts


def spread(corpus: Path, documents: int = 6, devices: int = 3) -> Iterator[tuple[EsiInfo, Device]]:
    """A few devices of a few documents of every archive."""
    reader = Reader()
    for path in sorted((corpus / "esi").glob("*.zip")):
        opened = Archive(path)
        small = [name for name, size in opened.members() if name.lower().endswith(".xml") and size < 300_000]
        for name in small[:: max(len(small) // documents, 1)]:
            try:
                infos = reader.read(opened.read(name), name, opened).document.infos
            except Exception:
                continue
            yield from islice(((info, device) for info in infos for device in info.devices), devices)


def test_images_of_some_devices_hold_what_an_image_can_hold(corpus):
    seen = 0
    for info, device in spread(corpus):
        check_device(info, device)
        seen += 1
    assert seen >= 100


@pytest.mark.corpus
def test_images_of_all_devices_hold_what_an_image_can_hold(corpus, capsys):
    """And what fits in which EEPROM."""
    count, with_all_texts, too_large, steps = 0, 0, Counter(), Counter()
    for info, device, _ in all_devices(corpus):
        with_all_texts += check_device(info, device)
        count += 1
        image = sii_image(vendor_of(info), group_of(info, device), device)
        byte_size = image.header.byte_size
        try:
            assert len(encode_sii(check_image(image, byte_size))) == byte_size
        except SiiLimitError as error:
            assert error.excess_bytes == 0 or error.excess_bytes == len(encode_sii(image)) - byte_size
            too_large[byte_size] += 1
            fitted = fit_image(image, byte_size)
            assert len(encode_sii(fitted.image)) == byte_size
            steps[fitted.dropped[-1].split(":")[0]] += 1
    with capsys.disabled():
        print(f"\n{count} images, {count - with_all_texts} of them with more than 255 texts")
        print(f"{too_large.total()} are too large for their EEPROM, by its bytes: {dict(too_large)}")
        for step, number in steps.most_common():
            print(f"  {number:4} fit without {step}")
    assert count > 2000


def test_the_oversampling_terminal_keeps_4_of_34_op_modes(corpus):
    """So does the EEPROM of a real EL2262."""
    opened = Archive(corpus / "esi" / "DiamondLightSource+ethercat.zip")
    name = next(name for name, _ in opened.members() if name.endswith("Beckhoff EL2xxx.xml"))
    (info,) = Reader().read(opened.read(name), name, opened).document.infos
    device = next(item for item in info.devices if item.type == "EL2262" and len(item.op_modes) == 34)
    image = sii_image(vendor_of(info), group_of(info, device), device)
    assert len(image.dc_modes) == 4
    assert max(pdo.bit_length for pdo in image.rx_pdos) < 100, "oversampling factors are not expanded"


def test_a_motion_terminal_as_another_program_read_it(corpus):
    """An EL7041-1000 on a bus: mailboxes, SyncManagers and PDOs that a master printed from its EEPROM."""
    found = [
        (info, device)
        for info, device, _ in all_devices_of(corpus, "DiamondLightSource+ethercat")
        if device.type == "EL7041-1000"
    ]
    if not found:
        pytest.skip("no description of an EL7041-1000")
    info, device = found[0]
    parts = taken_apart(encode_sii(sii_image(vendor_of(info), group_of(info, device), device)))
    assert parts.header_words(0x14, 9) == (0x1000, 244, 0x10F4, 244, 0x1000, 128, 0x1080, 128, 0x0C)
    assert parts.sync_managers == [
        (0x1000, 128, 0x26, 0, 1, 1),
        (0x1080, 128, 0x22, 0, 1, 2),
        (0x1100, 8, 0x24, 0, 1, 3),
        (0x1180, 8, 0x20, 0, 1, 4),
    ]
    assert (parts.general[5], parts.general[6], parts.general[11]) == (0x27, 1, 0x04)
    tx, rx = (
        [(index, sm, sum(entry[4] for entry in entries)) for index, sm, _, _, _, entries in parts.pdos(number)]
        for number in (50, 51)
    )
    assert tx == [(0x1A00, 3, 48), (0x1A01, 255, 80), (0x1A02, 255, 32), (0x1A03, 3, 16)]
    assert rx == [(0x1600, 2, 32), (0x1601, 255, 48), (0x1602, 2, 16), (0x1603, 255, 32), (0x1604, 2, 16)]
    assert parts.pdos(50)[0][5][5] == (0, 0, "Status__", 0, 2, 0), "a gap keeps its name"


def all_devices_of(corpus: Path, archive: str) -> Iterator[tuple[EsiInfo, Device, str]]:
    """Devices of the archives whose name starts so, motion terminals' documents only."""
    reader = Reader()
    for path in sorted((corpus / "esi").glob(f"{archive}*.zip")):
        opened = Archive(path)
        for name, _ in opened.members():
            if "EL7" in name:
                for info in reader.read(opened.read(name), name, opened).document.infos:
                    for device in info.devices:
                        yield info, device, name
