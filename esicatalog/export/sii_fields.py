"""What the stored fields of an SII image are called, and whom it concerns when one differs."""

from enum import Enum, auto
from typing import NamedTuple

CHECK_SUM = "check sum"


class Kind(Enum):
    """Whom it concerns that something in an image differs."""

    PDI = auto()
    """The slave controller: with wrong words of its interface to the device (PDI) nobody reaches the device."""
    IDENTITY = auto()
    """A master, which knows the device by it."""
    CONFIGURATION = auto()
    """A master, which configures the device by it."""
    OWN = auto()
    """Only this one device: no description says it. The check sum, which is over such words too, goes with them."""
    REST = auto()
    """No master: names, data of the maker, what is stored beside a configuration."""


USED_BY_MASTER = frozenset((Kind.IDENTITY, Kind.CONFIGURATION))


class Label(NamedTuple):
    """What a field is called."""

    words: str
    digits: int
    """Hex digits of its values; 0 = decimal."""
    kind: Kind


Labels = dict[str, Label]
"""By the name of the field in its record."""

PDI_WORDS: Labels = {
    "pdi_control": Label("PDI control", 4, Kind.PDI),
    "pdi_configuration": Label("PDI configuration", 4, Kind.PDI),
    "sync_impulse_length_10ns": Label("length of the SYNC pulses in 10 ns", 0, Kind.PDI),
    "pdi_configuration_2": Label("extended PDI configuration", 4, Kind.PDI),
    "reserved_5": Label("word 5", 4, Kind.PDI),
    "reserved_6": Label("word 6", 4, Kind.PDI),
    "station_alias": Label("station alias", 0, Kind.OWN),
}
CHECK_SUM_WORD: Labels = {
    "checksum": Label(CHECK_SUM, 2, Kind.OWN),
    "checksum_high_byte": Label("byte behind it", 2, Kind.REST),
}
IDENTITY: Labels = {
    "vendor_id": Label("vendor id", 8, Kind.IDENTITY),
    "product_code": Label("product code", 8, Kind.IDENTITY),
    "revision_no": Label("revision number", 8, Kind.IDENTITY),
    "serial_no": Label("serial number", 8, Kind.OWN),
}
PROTOCOLS = "mailbox_protocols"
MAILBOXES: Labels = {
    "standard_receive_mailbox_offset": Label("offset of the receive mailbox", 4, Kind.CONFIGURATION),
    "standard_receive_mailbox_size": Label("bytes of the receive mailbox", 0, Kind.CONFIGURATION),
    "standard_send_mailbox_offset": Label("offset of the send mailbox", 4, Kind.CONFIGURATION),
    "standard_send_mailbox_size": Label("bytes of the send mailbox", 0, Kind.CONFIGURATION),
    "bootstrap_receive_mailbox_offset": Label("offset of the bootstrap receive mailbox", 4, Kind.CONFIGURATION),
    "bootstrap_receive_mailbox_size": Label("bytes of the bootstrap receive mailbox", 0, Kind.CONFIGURATION),
    "bootstrap_send_mailbox_offset": Label("offset of the bootstrap send mailbox", 4, Kind.CONFIGURATION),
    "bootstrap_send_mailbox_size": Label("bytes of the bootstrap send mailbox", 0, Kind.CONFIGURATION),
    PROTOCOLS: Label("mailbox protocols", 0, Kind.CONFIGURATION),
}
OTHER_WORDS: Labels = {
    "execution_delay": Label("word 0x10, a delay", 0, Kind.REST),
    "port0_delay": Label("word 0x11, a delay", 0, Kind.REST),
    "port1_delay": Label("word 0x12, a delay", 0, Kind.REST),
    "reserved_13": Label("word 0x13", 4, Kind.REST),
    "private": Label("words 0x1D to 0x3D", 0, Kind.REST),
    "size_word": Label("size word", 0, Kind.REST),
    "version": Label("version", 0, Kind.REST),
}
GENERAL: Labels = {
    "flags": Label("flags", 0, Kind.CONFIGURATION),
    "coe_details": Label("CoE", 0, Kind.CONFIGURATION),
    "foe_details": Label("FoE", 0, Kind.REST),
    "eoe_details": Label("EoE", 0, Kind.REST),
    "soe_channels": Label("SoE channels", 0, Kind.REST),
    "ds402_channels": Label("DS402 channels", 0, Kind.REST),
    "e_bus_current_ma": Label("E-bus current in mA", 0, Kind.REST),
    "physical_ports": Label("ports", 4, Kind.REST),
    "identification_address": Label("identification address", 4, Kind.REST),
    "legacy_ports": Label("legacy ports", 2, Kind.REST),
    "sysman_class": Label("SysmanClass", 2, Kind.REST),
    "reserved_15": Label("byte 15", 2, Kind.REST),
    "reserved_20": Label("bytes 20 to 31", 0, Kind.REST),
}
NAMES = {
    "order_string_number": "order code",
    "name_string_number": "name",
    "group_string_number": "group",
    "group_name_string_number": "name of the group",
    "image_string_number": "image",
}
"""What the texts of General are called."""
BESIDE_SM: Labels = {"status_byte": Label("status byte", 2, Kind.REST)}
"""What is stored with a SyncManager, PDO, entry, gap or OpMode, and no master configures."""
BESIDE_PDO: Labels = {"flags": Label("flags", 0, Kind.REST), "dc_sync": Label("DC sync", 0, Kind.REST)}
BESIDE_ENTRY: Labels = {"flags": Label("flags", 4, Kind.REST)}
BESIDE_GAP: Labels = {
    "subindex": Label("subindex stored with the gap", 2, Kind.REST),
    "data_type_code": Label("data type stored with the gap", 2, Kind.REST),
    **BESIDE_ENTRY,
}
BESIDE_DC_MODE: Labels = {"reserved_20": Label("reserved bytes", 8, Kind.REST)}
