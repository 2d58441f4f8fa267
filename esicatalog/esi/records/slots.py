"""Slots of modular devices and what may be plugged into them (ETG.2000 Slots)."""

from typing import Annotated

from esicatalog.esi.binding import Record, Xml
from esicatalog.esi.numbers import DEC, HEX, HEX16, IDENTITY, IMAGE, INT, SWITCH
from esicatalog.esi.records.common import Name


class SlotModuleIdent(Record):
    """A module that fits the slot."""

    module_ident: Annotated[int | None, Xml(".", IDENTITY, "ModuleIdent of the module")] = None
    is_default: Annotated[int | None, Xml("@Default", SWITCH, "1 = preselected module")] = None


class SlotModuleClass(Record):
    """A class of modules that fit the slot."""

    module_class: Annotated[str | None, Xml("Class", doc="ModuleClass of the modules that fit")] = None
    class_vendor_id: Annotated[int | None, Xml("VendorId", IDENTITY, "Vendor of the modules, if another one")] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    image_symbol: Annotated[str | None, Xml("Image16x14", doc="Image as a symbolic name (obsolete)")] = None
    image_file: Annotated[str | None, Xml("ImageFile16x14", doc="Image file name")] = None
    image_data: Annotated[str | None, Xml("ImageData16x14", IMAGE, "Image, bytes in hex")] = None


class Slot(Record):
    """Slot element; with MaxInstances above 1 it stands for several slots."""

    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    slot_group: Annotated[int | None, Xml("@SlotGroup", DEC, "Number of the slot group")] = None
    min_instances: Annotated[int | None, Xml("@MinInstances", DEC, "Least number of slots")] = None
    max_instances: Annotated[int | None, Xml("@MaxInstances", DEC, "Greatest number of slots")] = None
    slot_pdo_increment: Annotated[int | None, Xml("@SlotPdoIncrement", DEC, "PDO index step per slot")] = None
    slot_group_pdo_increment: Annotated[
        int | None, Xml("@SlotGroupPdoIncrement", DEC, "PDO index step per slot group")
    ] = None
    slot_index_increment: Annotated[int | None, Xml("@SlotIndexIncrement", HEX, "Object index step per slot")] = None
    slot_group_index_increment: Annotated[
        int | None, Xml("@SlotGroupIndexIncrement", HEX, "Object index step per slot group")
    ] = None
    tree_view: Annotated[str | None, Xml("@TreeView", doc="SLOTGROUP, SLOT, SLOTCOMPACT or PDO")] = None
    default_ident: Annotated[int | None, Xml("@Default", HEX, "ModuleIdent that is preselected (schema 1.17)")] = None
    fallback_ident: Annotated[
        int | None, Xml("@Fallback", HEX, "ModuleIdent that is plugged when no other one is (schema 1.17)")
    ] = None
    module_idents: Annotated[tuple[SlotModuleIdent, ...], Xml("ModuleIdent")] = ()
    module_classes: Annotated[tuple[SlotModuleClass, ...], Xml("ModuleClass")] = ()
    image_symbol: Annotated[str | None, Xml("Image16x14", doc="Image as a symbolic name (obsolete)")] = None
    image_file: Annotated[str | None, Xml("ImageFile16x14", doc="Image file name")] = None
    image_data: Annotated[str | None, Xml("ImageData16x14", IMAGE, "Image, bytes in hex")] = None


class SlotGroupData(Record):
    """Name and image of a slot group."""

    slot_group: Annotated[int | None, Xml("@SlotGroup", DEC, "Number of the slot group")] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    image_symbol: Annotated[str | None, Xml("Image16x14", doc="Image as a symbolic name (obsolete)")] = None
    image_file: Annotated[str | None, Xml("ImageFile16x14", doc="Image file name")] = None
    image_data: Annotated[str | None, Xml("ImageData16x14", IMAGE, "Image, bytes in hex")] = None


class ModulePdoGroup(Record):
    """Group in which module PDOs are packed and aligned."""

    name: Annotated[str | None, Xml(".", doc="Name of the group")] = None
    alignment: Annotated[int | None, Xml("@Alignment", INT, "Alignment in bytes")] = None
    rx_pdo: Annotated[int | None, Xml("@RxPdo", HEX16, "Index of the alignment RxPDO")] = None
    tx_pdo: Annotated[int | None, Xml("@TxPdo", HEX16, "Index of the alignment TxPDO")] = None


class SlotSelection(Record):
    """Named selection of modules, one a slot."""

    names: Annotated[tuple[Name, ...], Xml("Name", doc="Name of the selection")] = ()
    module_idents: Annotated[tuple[int, ...], Xml("ModuleIdent", IDENTITY, "ModuleIdents in slot order")] = ()
