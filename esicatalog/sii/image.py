"""An SII image as a whole: the header and the categories in stored order, with every byte accounted for."""

import struct
from collections.abc import Iterable
from typing import Annotated, ClassVar, NamedTuple, TypeVar

from esicatalog.sii.codes import PORT_TYPES, CoeDetails, Enabled, GeneralFlags
from esicatalog.sii.layout import Layout, Part, SiiRecord
from esicatalog.sii.records import DcMode, Fmmu, Header, Pdo, SiiString, SyncManager
from esicatalog.words import counted

HEAD = struct.Struct("<HH")
"""What precedes the data of every category: type, and length in words."""
END_TYPE = 0xFFFF
"""The type that ends the categories; no length follows."""
END_MARK = END_TYPE.to_bytes(2, "little")
MAX_IMAGE_BYTES = 512 * 1024
"""4 MBit, the largest EEPROM that a slave controller addresses (ESC data sheet)."""
PADDING_BYTES = 1
"""What the strings of a table need at most behind them to fill a whole word."""
_NO_RESERVED_BYTES = bytes(12)
_MOST_RANGES = 8
FILLER = 0xFF
"""What an erased EEPROM reads; it stands for bytes that an Intel HEX file leaves out."""


class ByteRange(NamedTuple):
    """Consecutive bytes of an image."""

    first: int
    last: int


def ranges_text(ranges: Iterable[ByteRange]) -> str:
    """Where bytes are, by their offsets, in words."""
    texts = [f"0x{first:X} to 0x{last:X}" if last > first else f"0x{first:X}" for first, last in ranges]
    further = len(texts) - _MOST_RANGES
    return ", ".join(texts[:_MOST_RANGES]) + f" and {counted(further, 'further range')}" * (further > 0)


class Strings(SiiRecord):
    """Category 10: the string table. ``rest`` is the padding to a whole word."""

    category_type: ClassVar[int] = 10
    strings: tuple[SiiString, ...] = ()
    rest: bytes = b""


class General(SiiRecord):
    """Category 30, 32 bytes: names and what the device can do (ETG.1000.6, ETG.2010)."""

    category_type: ClassVar[int] = 30
    group_string_number: Annotated[int, Part("B", "String number of the group's type")] = 0
    image_string_number: Annotated[int, Part("B", "String number of the image's name")] = 0
    order_string_number: Annotated[int, Part("B", "String number of the order code")] = 0
    name_string_number: Annotated[int, Part("B", "String number of the device's name")] = 0
    legacy_ports: Annotated[int, Part("B", "Byte 4, two bits a port in old images; reserved")] = 0
    coe_details: Annotated[CoeDetails, Part("B", "What CoE can do")] = CoeDetails(0)
    foe_details: Annotated[Enabled, Part("B", "FoE")] = Enabled(0)
    eoe_details: Annotated[Enabled, Part("B", "EoE")] = Enabled(0)
    soe_channels: Annotated[int, Part("B", "Reserved")] = 0
    ds402_channels: Annotated[int, Part("B", "Reserved")] = 0
    sysman_class: Annotated[int, Part("B", "Reserved; a few real images give it")] = 0
    flags: Annotated[GeneralFlags, Part("B", "Flags")] = GeneralFlags(0)
    e_bus_current_ma: Annotated[int, Part("h", "E-bus consumption in mA; negative = the device feeds")] = 0
    group_name_string_number: Annotated[int, Part("B", "String number of the group's name")] = 0
    reserved_15: Annotated[int, Part("B", "Byte 15")] = 0
    physical_ports: Annotated[int, Part("H", "Four bits a port, port 0 lowest")] = 0
    identification_address: Annotated[int, Part("H", "ESC address of the explicit device identification")] = 0
    reserved_20: Annotated[bytes, Part("12s", "Bytes 20 to 31")] = _NO_RESERVED_BYTES
    rest: bytes = b""

    @property
    def port_types(self) -> tuple[str | None, ...]:
        """What the ports 0 to 3 are, None where the code means nothing."""
        return tuple(PORT_TYPES.get(self.physical_ports >> shift & 0xF) for shift in (0, 4, 8, 12))


class Fmmus(SiiRecord):
    """Category 40: one byte an FMMU; an odd number is stored with an unused one (0xFF) behind."""

    category_type: ClassVar[int] = 40
    fmmus: tuple[Fmmu, ...] = ()


class SyncManagers(SiiRecord):
    """Category 41; ``rest`` are the bytes after the last whole record, none in a sound image."""

    category_type: ClassVar[int] = 41
    sync_managers: tuple[SyncManager, ...] = ()
    rest: bytes = b""


class TxPdos(SiiRecord):
    """Category 50: PDOs from the slave to the master; ``rest`` are the bytes from the first PDO that does not fit."""

    category_type: ClassVar[int] = 50
    pdos: tuple[Pdo, ...] = ()
    rest: bytes = b""


class RxPdos(SiiRecord):
    """Category 51: PDOs from the master to the slave; ``rest`` are the bytes from the first PDO that does not fit."""

    category_type: ClassVar[int] = 51
    pdos: tuple[Pdo, ...] = ()
    rest: bytes = b""


class DistributedClocks(SiiRecord):
    """Category 60; ``rest`` are the bytes after the last whole record, none in a sound image."""

    category_type: ClassVar[int] = 60
    modes: tuple[DcMode, ...] = ()
    rest: bytes = b""


class RawCategory(SiiRecord):
    """Any other category, and one whose data do not fit its type."""

    category_type: int = 0
    data: bytes = b""


Category = Strings | General | Fmmus | SyncManagers | TxPdos | RxPdos | DistributedClocks | RawCategory
C = TypeVar("C", bound=Category)


class SiiImage(SiiRecord):
    """A whole image. ``findings`` are sentences about what is odd; they are no part of the bytes."""

    header: Header = Header()
    categories: tuple[Category, ...] = ()
    end_mark: bool = True
    """Whether the categories end with 0xFFFF, as they should."""
    trailing: bytes = b""
    """What follows the end mark, usually 0xFF; without an end mark, zeros only."""
    unread: tuple[ByteRange, ...] = ()
    """Bytes that the file did not hold: :data:`FILLER` stands in their place, whatever the device has there."""
    findings: tuple[str, ...] = ()

    def of_type(self, category_type: type[C]) -> tuple[C, ...]:
        """The categories of one record type, in stored order."""
        return tuple(item for item in self.categories if isinstance(item, category_type))

    def text(self, string_number: int) -> str | None:
        """The text of a string number; None for 0 and for a number beyond the table. The first table counts."""
        tables = self.of_type(Strings)
        if not tables or not 0 < string_number <= len(tables[0].strings):
            return None
        return tables[0].strings[string_number - 1].text

    @property
    def general(self) -> General | None:
        """The first General category."""
        return next(iter(self.of_type(General)), None)

    @property
    def fmmus(self) -> tuple[Fmmu, ...]:
        """All FMMUs."""
        return tuple(fmmu for category in self.of_type(Fmmus) for fmmu in category.fmmus)

    @property
    def sync_managers(self) -> tuple[SyncManager, ...]:
        """All sync managers."""
        return tuple(sm for category in self.of_type(SyncManagers) for sm in category.sync_managers)

    @property
    def tx_pdos(self) -> tuple[Pdo, ...]:
        """All PDOs from the slave to the master."""
        return tuple(pdo for category in self.of_type(TxPdos) for pdo in category.pdos)

    @property
    def rx_pdos(self) -> tuple[Pdo, ...]:
        """All PDOs from the master to the slave."""
        return tuple(pdo for category in self.of_type(RxPdos) for pdo in category.pdos)

    @property
    def dc_modes(self) -> tuple[DcMode, ...]:
        """All OpModes of the distributed clocks."""
        return tuple(mode for category in self.of_type(DistributedClocks) for mode in category.modes)


GENERAL = Layout(General)
