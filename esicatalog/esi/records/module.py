"""Module that can be plugged into a slot (EtherCATBase.xsd ModuleType)."""

from typing import Annotated

from esicatalog.esi.binding import RAW, Record, Xml
from esicatalog.esi.notes import Unmapped
from esicatalog.esi.numbers import BOOL, HEX, IDENTITY, IMAGE, INT
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.mailbox import Mailbox
from esicatalog.esi.records.pdo import Pdo
from esicatalog.esi.records.profile import Profile


class Module(Record):
    """Module element."""

    type: Annotated[str | None, Xml("Type", doc="Type text of the module")] = None
    module_ident: Annotated[
        int | None, Xml("Type@ModuleIdent", IDENTITY, "ModuleIdent, what slots and 0xF030 refer to")
    ] = None
    module_class: Annotated[str | None, Xml("Type@ModuleClass", doc="Class that slots refer to")] = None
    module_pdo_group: Annotated[int | None, Xml("Type@ModulePdoGroup", INT, "ModulePdoGroup of its PDOs")] = None
    sra_parameter_supported: Annotated[
        bool | None, Xml("Type@SRA_ParameterSupported", BOOL, "Safety restore parameter supported")
    ] = None
    crc32: Annotated[int | None, Xml("@Crc32", HEX, "Check sum against alteration")] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    rx_pdos: Annotated[tuple[Pdo, ...], Xml("RxPdo")] = ()
    tx_pdos: Annotated[tuple[Pdo, ...], Xml("TxPdo")] = ()
    safety_para_mappings: Annotated[tuple[Pdo, ...], Xml("SafetyParaMapping")] = ()
    mailbox: Annotated[Mailbox | None, Xml("Mailbox")] = None
    profiles: Annotated[tuple[Profile, ...], Xml("Profile")] = ()
    dc_op_mode_name: Annotated[str | None, Xml("DcOpModeName", doc="OpMode of the device that it selects")] = None
    image_symbol: Annotated[str | None, Xml("Image16x14", doc="Image as a symbolic name (obsolete)")] = None
    image_file: Annotated[str | None, Xml("ImageFile16x14", doc="Image file name")] = None
    image_data: Annotated[str | None, Xml("ImageData16x14", IMAGE, "Image, bytes in hex")] = None
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW)] = None
    unmapped: tuple[Unmapped, ...] = ()
