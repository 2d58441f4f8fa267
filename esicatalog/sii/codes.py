"""Bits and codes of SII images in words: each table is the whole of what is known, the rest stays a number."""

from enum import IntFlag


class MailboxProtocols(IntFlag):
    """Mailbox protocols, SII word 0x1C (ETG.1000.6)."""

    AoE = 0x01
    EoE = 0x02
    CoE = 0x04
    FoE = 0x08
    SoE = 0x10
    VoE = 0x20


class EscConfiguration(IntFlag):
    """High byte of PDI control, register 0x0141 (ESC data sheet)."""

    DEVICE_EMULATION = 0x01
    ENHANCED_LINK_DETECTION = 0x02
    DC_SYNC_UNIT = 0x04
    DC_LATCH_UNIT = 0x08
    ENHANCED_LINK_PORT_0 = 0x10
    ENHANCED_LINK_PORT_1 = 0x20
    ENHANCED_LINK_PORT_2 = 0x40
    ENHANCED_LINK_PORT_3 = 0x80


class CoeDetails(IntFlag):
    """CoE details of the General category (ETG.1000.6)."""

    SDO = 0x01
    SDO_INFO = 0x02
    PDO_ASSIGN = 0x04
    PDO_CONFIG = 0x08
    PDO_UPLOAD = 0x10
    COMPLETE_ACCESS = 0x20


class Enabled(IntFlag):
    """FoE and EoE details of the General category (ETG.1000.6)."""

    ENABLED = 0x01


class GeneralFlags(IntFlag):
    """Flags of the General category (ETG.2010)."""

    ENABLE_SAFE_OP = 0x01
    ENABLE_NOT_LRW = 0x02
    MAILBOX_DATA_LINK_LAYER = 0x04
    IDENT_AL_STATUS = 0x08
    IDENT_PHYSICAL_MEMORY = 0x10


class SmControl(IntFlag):
    """Upper bits of a sync manager's control byte, register 0x0804 (ESC data sheet)."""

    ECAT_INTERRUPT = 0x10
    PDI_INTERRUPT = 0x20
    WATCHDOG = 0x40


class AssignActivate(IntFlag):
    """AssignActivate of an OpMode, registers 0x0980 (low byte) and 0x0981 (high byte; ESC data sheet)."""

    SYNC_UNIT_PDI = 0x0001
    LATCH0_PDI = 0x0010
    LATCH1_PDI = 0x0020
    SYNC_UNIT = 0x0100
    SYNC0 = 0x0200
    SYNC1 = 0x0400


class SmEnable(IntFlag):
    """Enable byte of a sync manager (ETG.2010; OP_ONLY in real images as 0x09)."""

    ENABLE = 0x01
    FIXED_CONTENT = 0x02
    VIRTUAL = 0x04
    OP_ONLY = 0x08


class PdoFlags(IntFlag):
    """Flags of a PDO (ETG.2010; the ones for reserved use as older tools write them)."""

    MANDATORY = 0x0001
    DEFAULT = 0x0002
    OVERSAMPLE = 0x0004
    FIXED_CONTENT = 0x0010
    VIRTUAL_CONTENT = 0x0020
    DOWNLOAD_ANYWAY = 0x0040
    FROM_MODULE = 0x0080
    MODULE_ALIGN = 0x0100
    DEPEND_ON_SLOT = 0x0200
    DEPEND_ON_SLOT_GROUP = 0x0400
    OVERWRITTEN_BY_MODULE = 0x0800


PDI_TYPES = {
    0x00: "none",
    0x01: "4 digital inputs",
    0x02: "4 digital outputs",
    0x03: "2 digital inputs, 2 outputs",
    0x04: "digital I/O",
    0x05: "SPI slave",
    0x06: "oversampling I/O",
    0x07: "EtherCAT bridge",
    0x08: "16/64 bit asynchronous microcontroller",
    0x09: "8/32 bit asynchronous microcontroller",
    0x0A: "16/64 bit synchronous microcontroller",
    0x0B: "8/32 bit synchronous microcontroller",
    0x0C: "16/64 bit multiplexed asynchronous microcontroller",
    0x0D: "8/32 bit multiplexed asynchronous microcontroller",
    0x0E: "16/64 bit multiplexed synchronous microcontroller",
    0x0F: "8/32 bit multiplexed synchronous microcontroller",
    0x10: "32 digital inputs",
    0x11: "24 digital inputs, 8 outputs",
    0x12: "16 digital inputs, 16 outputs",
    0x13: "8 digital inputs, 24 outputs",
    0x14: "32 digital outputs",
    0x15: "SPI master",
    0x80: "on-chip bus (Microchip LAN925x: SPI)",
    0x82: "SPI, direct mapped (Microchip LAN9255)",
    0x89: "16 bit host bus, multiplexed in 1 phase (Microchip LAN925x)",
    0x8A: "8 bit host bus, multiplexed in 2 phases (Microchip LAN925x)",
    0x8B: "16 bit host bus, multiplexed in 2 phases (Microchip LAN925x)",
    0x91: "16 bit host bus, multiplexed in 1 phase, direct mapped (Microchip LAN9255)",
    0x92: "8 bit host bus, multiplexed in 2 phases, direct mapped (Microchip LAN925x)",
    0x93: "16 bit host bus, multiplexed in 2 phases, direct mapped (Microchip LAN9255)",
    0x95: "16 bit host bus, indexed, direct mapped (Microchip LAN9255)",
    0x96: "8 bit host bus, demultiplexed, direct mapped (Microchip LAN9253)",
    0x97: "16 bit host bus, demultiplexed, direct mapped (Microchip LAN9253)",
}
"""Low byte of PDI control, register 0x0140 (ESC data sheet, section II; from 0x80 on as Microchip has it: its list for
the LAN9255, and for others the names and ConfigData of the ESI files that it publishes with its software framework)."""
CATEGORY_NAMES = {
    0: "NOP",
    **dict.fromkeys(range(1, 10), "device specific"),
    10: "STRINGS",
    20: "DataTypes",
    30: "General",
    40: "FMMU",
    41: "SyncM",
    42: "FMMU_EX",
    43: "SyncUnit",
    50: "TxPDO",
    51: "RxPDO",
    60: "DC",
}
"""Category types (ETG.1000.6, ETG.2010)."""
PORT_TYPES = {0: "not used", 1: "MII", 2: "reserved", 3: "EBUS", 4: "fast hot connect"}
FMMU_USAGES = {0x00: "unused", 0x01: "Outputs", 0x02: "Inputs", 0x03: "MBoxState", 0xFF: "unused"}
SM_USAGES = {0: "unused", 1: "MBoxOut", 2: "MBoxIn", 3: "Outputs", 4: "Inputs"}
SM_MODES = {0b00: "buffered", 0b10: "mailbox"}
SM_DIRECTIONS = {0b00: "input", 0b01: "output"}
DATA_TYPES = {
    0x01: "BOOL",
    0x02: "SINT",
    0x03: "INT",
    0x04: "DINT",
    0x05: "USINT",
    0x06: "UINT",
    0x07: "UDINT",
    0x08: "REAL",
    0x09: "VISIBLE_STRING",
    0x0A: "OCTET_STRING",
    0x0B: "UNICODE_STRING",
    0x0C: "TIME_OF_DAY",
    0x0D: "TIME_DIFFERENCE",
    0x0F: "DOMAIN",
    0x10: "INT24",
    0x11: "LREAL",
    0x12: "INT40",
    0x13: "INT48",
    0x14: "INT56",
    0x15: "LINT",
    0x16: "UINT24",
    0x18: "UINT40",
    0x19: "UINT48",
    0x1A: "UINT56",
    0x1B: "ULINT",
    0x1D: "GUID",
    0x1E: "BYTE",
    0x1F: "WORD",
    0x20: "DWORD",
    0x2D: "BITARR8",
    0x2E: "BITARR16",
    0x2F: "BITARR32",
    **{0x2F + bits: f"BIT{bits}" for bits in range(1, 17)},
}
"""CoE base data types (ETG.1020) that PDO entries name by code."""


_ABBREVIATIONS = {"AL", "DC", "ECAT", "LRW", "OP", "PDI", "PDO", "SDO"}


def flag_words(flags: IntFlag) -> list[str]:
    """The set bits in words, lowest first; bits without a meaning as ``bit 15``."""
    names = {member.value: member.name or "" for member in type(flags)}
    return [
        _in_words(names[1 << position]) if 1 << position in names else f"bit {position}"
        for position in range(int(flags).bit_length())
        if flags & 1 << position
    ]


def _in_words(name: str) -> str:
    words = name.split("_")
    return " ".join(word.lower() if word.isupper() and word not in _ABBREVIATIONS else word for word in words)


def signal_names(sync0: bool | None, sync1: bool | None) -> list[str]:
    """The signals that are generated, by name."""
    return [name for name, generated in (("SYNC0", sync0), ("SYNC1", sync1)) if generated]


def category_title(category_type: int) -> str:
    """A category type as a reader knows it: ``category 50 (TxPDO)``."""
    name = CATEGORY_NAMES.get(category_type)
    return f"category {category_type} ({name})" if name is not None else f"category {category_type}"
