"""Records that an SII image is made of, field by field as stored; what the numbers mean is in their properties.

Texts are stored once, in the string table, and referenced by string numbers: 1 is the first string, 0 none.
:meth:`esicatalog.sii.image.SiiImage.text` resolves them.
"""

from typing import Annotated

from esicatalog.sii.codes import (
    DATA_TYPES,
    FMMU_USAGES,
    PDI_TYPES,
    SM_DIRECTIONS,
    SM_MODES,
    SM_USAGES,
    AssignActivate,
    EscConfiguration,
    MailboxProtocols,
    PdoFlags,
    SmControl,
    SmEnable,
)
from esicatalog.sii.layout import Layout, Part, SiiRecord
from esicatalog.sii.strings import decode_text

SIZE_UNIT_BYTES = 128
"""The size word counts KiBit; 0 means one."""
MAX_ENTRY_BITS = 255
"""One byte holds the length of an entry."""
_NO_PRIVATE_WORDS = bytes(66)


class Header(SiiRecord):
    """The words 0 to 0x3F, 128 bytes (ETG.1000.6; layout also in the ESC data sheet)."""

    pdi_control: Annotated[int, Part("H", "Registers 0x0140 (PDI type) and 0x0141 (ESC configuration)")] = 0
    pdi_configuration: Annotated[int, Part("H", "Registers 0x0150 and 0x0151")] = 0
    sync_impulse_length_10ns: Annotated[int, Part("H", "Length of the SYNC pulses in units of 10 ns")] = 0
    pdi_configuration_2: Annotated[int, Part("H", "Registers 0x0152 and 0x0153")] = 0
    station_alias: Annotated[int, Part("H", "Configured station alias; 0 = none")] = 0
    reserved_5: Annotated[int, Part("H", "Word 5; some slave controllers keep settings here")] = 0
    reserved_6: Annotated[int, Part("H", "Word 6")] = 0
    checksum: Annotated[int, Part("B", "CRC-8 over the words 0 to 6, as stored")] = 0
    checksum_high_byte: Annotated[int, Part("B", "High byte of word 7, usually 0")] = 0
    vendor_id: Annotated[int, Part("I", "Vendor id")] = 0
    product_code: Annotated[int, Part("I", "Product code")] = 0
    revision_no: Annotated[int, Part("I", "Revision number")] = 0
    serial_no: Annotated[int, Part("I", "Serial number")] = 0
    execution_delay: Annotated[int, Part("H", "Word 0x10; unit not specified, 0 in real images")] = 0
    port0_delay: Annotated[int, Part("H", "Word 0x11, likewise")] = 0
    port1_delay: Annotated[int, Part("H", "Word 0x12, likewise")] = 0
    reserved_13: Annotated[int, Part("H", "Word 0x13")] = 0
    bootstrap_receive_mailbox_offset: Annotated[int, Part("H", "Address, master to slave, state BOOT")] = 0
    bootstrap_receive_mailbox_size: Annotated[int, Part("H", "Size in bytes")] = 0
    bootstrap_send_mailbox_offset: Annotated[int, Part("H", "Address, slave to master, state BOOT")] = 0
    bootstrap_send_mailbox_size: Annotated[int, Part("H", "Size in bytes")] = 0
    standard_receive_mailbox_offset: Annotated[int, Part("H", "Address, master to slave")] = 0
    standard_receive_mailbox_size: Annotated[int, Part("H", "Size in bytes")] = 0
    standard_send_mailbox_offset: Annotated[int, Part("H", "Address, slave to master")] = 0
    standard_send_mailbox_size: Annotated[int, Part("H", "Size in bytes")] = 0
    mailbox_protocols: Annotated[MailboxProtocols, Part("H", "Supported mailbox protocols")] = MailboxProtocols(0)
    private: Annotated[bytes, Part("66s", "The words 0x1D to 0x3D, reserved or the vendor's own")] = _NO_PRIVATE_WORDS
    size_word: Annotated[int, Part("H", "Size of the EEPROM in KiBit, minus 1")] = 0
    version: Annotated[int, Part("H", "Version of this format, 1")] = 1

    @property
    def byte_size(self) -> int:
        """Size of the EEPROM in bytes, by the size word."""
        return (self.size_word + 1) * SIZE_UNIT_BYTES

    @property
    def sync_impulse_length_ns(self) -> int:
        """Length of the SYNC pulses in ns."""
        return self.sync_impulse_length_10ns * 10

    @property
    def pdi_type(self) -> str | None:
        """Kind of the process data interface, None when the code means nothing."""
        return PDI_TYPES.get(self.pdi_control & 0xFF)

    @property
    def esc_configuration(self) -> EscConfiguration:
        """Configuration bits of the slave controller."""
        return EscConfiguration(self.pdi_control >> 8)


class SiiString(SiiRecord):
    """One string of the table: at most 255 bytes, in no declared encoding."""

    data: bytes = b""

    @property
    def text(self) -> str:
        """The text, by the guessed encoding."""
        return decode_text(self.data)[0]

    @property
    def encoding(self) -> str:
        """The guessed encoding: ascii, utf-8, cp1252 or latin-1."""
        return decode_text(self.data)[1]


class Fmmu(SiiRecord):
    """Use of one FMMU."""

    usage_code: Annotated[int, Part("B", "1 outputs, 2 inputs, 3 mailbox state, 0 and 0xFF unused")] = 0

    @property
    def usage(self) -> str | None:
        """The use in the terms of ESI, None when the code means nothing."""
        return FMMU_USAGES.get(self.usage_code)


class SyncManager(SiiRecord):
    """Settings of one sync manager (ETG.2010)."""

    start_address: Annotated[int, Part("H", "Physical start address")] = 0
    length_bytes: Annotated[int, Part("H", "Length in bytes; 0 = by the assigned PDOs")] = 0
    control_byte: Annotated[int, Part("B", "Register 0x0804: bits 1:0 mode, 3:2 direction, then SmControl")] = 0
    status_byte: Annotated[int, Part("B", "Register 0x0805, no meaning in an image")] = 0
    enable: Annotated[SmEnable, Part("B", "Enable byte")] = SmEnable(0)
    usage_code: Annotated[int, Part("B", "1 MBoxOut, 2 MBoxIn, 3 Outputs, 4 Inputs")] = 0

    @property
    def usage(self) -> str | None:
        """The use in the terms of ESI, None when the code means nothing."""
        return SM_USAGES.get(self.usage_code)

    @property
    def buffer_mode(self) -> str | None:
        """``buffered`` (3 buffers) or ``mailbox`` (1 buffer)."""
        return SM_MODES.get(self.control_byte & 0b11)

    @property
    def direction(self) -> str | None:
        """``output`` (the master writes) or ``input`` (the master reads)."""
        return SM_DIRECTIONS.get(self.control_byte >> 2 & 0b11)

    @property
    def control(self) -> SmControl:
        """Interrupts and watchdog trigger of the control byte; further bits are left out."""
        return SmControl(self.control_byte & 0x70)


class PdoEntry(SiiRecord):
    """One mapped object of a PDO (ETG.1000.6)."""

    entry_index: Annotated[int, Part("H", "Object index; 0 = padding")] = 0
    subindex: Annotated[int, Part("B", "Subindex")] = 0
    name_string_number: Annotated[int, Part("B", "String number of the name")] = 0
    data_type_code: Annotated[int, Part("B", "CoE data type; vendor tools write BYTE as 0x05, WORD as 0x06")] = 0
    bit_length: Annotated[int, Part("B", "Length in bits")] = 0
    flags: Annotated[int, Part("H", "Reserved")] = 0

    @property
    def data_type(self) -> str | None:
        """Name of the base data type, None when the code means nothing."""
        return DATA_TYPES.get(self.data_type_code)


class Pdo(SiiRecord):
    """A PDO; the category tells its direction (ETG.2010)."""

    pdo_index: Annotated[int, Part("H", "Index of the mapping object")] = 0
    entries: Annotated[tuple[PdoEntry, ...], Part("B", "The entries, at most 255; stored after the PDO's flags")] = ()
    sm: Annotated[int, Part("B", "Sync manager it is assigned to; 0xFF = not assigned")] = 0
    dc_sync: Annotated[int, Part("B", "Reference to DC synchronisation, 0 in real images")] = 0
    name_string_number: Annotated[int, Part("B", "String number of the name")] = 0
    flags: Annotated[PdoFlags, Part("H", "What may be changed")] = PdoFlags(0)

    @property
    def bit_length(self) -> int:
        """Sum of the entries' lengths in bits."""
        return sum(entry.bit_length for entry in self.entries)


class DcMode(SiiRecord):
    """One OpMode of the distributed clocks, 24 bytes (ETG.1000.6).

    AssignActivate goes to the registers 0x0980 (low byte) and 0x0981 (high byte): 0x0100 activates the sync unit,
    0x0200 generates SYNC0, 0x0400 generates SYNC1. Shift times are signed as those of ESI that they are made from.
    """

    cycle_time_sync0_ns: Annotated[int, Part("I", "SYNC0 cycle time in ns; 0 = by the factor")] = 0
    shift_time_sync0_ns: Annotated[int, Part("i", "SYNC0 shift time in ns")] = 0
    shift_time_sync1_ns: Annotated[int, Part("i", "SYNC1 shift time in ns")] = 0
    cycle_time_sync1_factor: Annotated[int, Part("h", "SYNC1 cycle as a factor of the SYNC0 cycle")] = 0
    assign_activate: Annotated[int, Part("H", "AssignActivate")] = 0
    cycle_time_sync0_factor: Annotated[int, Part("h", "SYNC0 cycle as a factor of the bus cycle")] = 0
    name_string_number: Annotated[int, Part("B", "String number of the name")] = 0
    description_string_number: Annotated[int, Part("B", "String number of the description, 0 in images of TwinCAT")] = 0
    reserved_20: Annotated[int, Part("I", "Bytes 20 to 23")] = 0

    @property
    def _activated(self) -> AssignActivate:
        return AssignActivate(self.assign_activate)

    @property
    def dc_active(self) -> bool:
        """Whether the sync unit is active."""
        return AssignActivate.SYNC_UNIT in self._activated

    @property
    def sync0(self) -> bool:
        """Whether SYNC0 is generated."""
        return AssignActivate.SYNC_UNIT | AssignActivate.SYNC0 in self._activated

    @property
    def sync1(self) -> bool:
        """Whether SYNC1 is generated."""
        return AssignActivate.SYNC_UNIT | AssignActivate.SYNC1 in self._activated


HEADER = Layout(Header)
FMMU = Layout(Fmmu)
SYNC_MANAGER = Layout(SyncManager)
PDO = Layout(Pdo)
PDO_ENTRY = Layout(PdoEntry)
DC_MODE = Layout(DcMode)
