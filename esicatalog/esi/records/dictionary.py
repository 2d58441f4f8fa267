"""Object dictionary as it is declared: unit types, data types, objects (EtherCATBase.xsd DictionaryType)."""

from typing import Annotated, ClassVar

from esicatalog.esi.binding import RAW, Record, Xml
from esicatalog.esi.numbers import BOOL, DEC, DEC8, DEC64, HEX, HEX16, HEX_BINARY, INT, INTEGER
from esicatalog.esi.records.common import Name, Property


class UnitType(Record):
    """Unit of the vendor's own, overriding the ETG.1004 catalogue."""

    notation_index: Annotated[int | None, Xml("NotationIndex", HEX, "Notation index")] = None
    unit_index: Annotated[int | None, Xml("Index", HEX, "Unit index")] = None
    name: Annotated[str | None, Xml("Name", doc="Name of the unit")] = None
    symbol: Annotated[str | None, Xml("Symbol", doc="Symbol of the unit")] = None


class ArrayInfo(Record):
    """One dimension of an array type."""

    lbound: Annotated[int | None, Xml("LBound", INTEGER, "Lowest index")] = None
    elements: Annotated[int | None, Xml("Elements", INTEGER, "Number of elements; 0 = variable")] = None


class EnumInfo(Record):
    """One value of an enumeration with its texts."""

    texts: Annotated[tuple[Name, ...], Xml("Text", doc="Text of the value in all languages")] = ()
    value: Annotated[int | None, Xml("Enum", DEC, "Number of the value")] = None
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments in all languages")] = ()


class Flags(Record):
    """Flags element of a sub-item or object (ETG.2000 figure 37 inherits six of them)."""

    SCHEMA_ORDER: ClassVar[tuple[str, ...]] = (
        "Access",
        "Category",
        "PdoMapping",
        "SafetyMapping",
        "Attribute",
        "Transition",
        "SdoAccess",
    )

    access: Annotated[str | None, Xml("Access", doc="Access: ro (default), rw, wo")] = None
    read_restrictions: Annotated[
        str | None, Xml("Access@ReadRestrictions", doc="States in which reading is allowed, e.g. PreOP_SafeOP")
    ] = None
    write_restrictions: Annotated[
        str | None, Xml("Access@WriteRestrictions", doc="States in which writing is allowed, e.g. PreOP")
    ] = None
    category: Annotated[str | None, Xml("Category", doc="m mandatory, o optional (default), c conditional")] = None
    pdo_mapping: Annotated[
        str | None, Xml("PdoMapping", doc="T TxPDO (slave to master), R RxPDO (master to slave), TR or RT both")
    ] = None
    safety_mapping: Annotated[str | None, Xml("SafetyMapping", doc="si, so, sio, sp: safety mapping")] = None
    attribute: Annotated[int | None, Xml("Attribute", HEX, "SoE IDN attribute")] = None
    backup: Annotated[int | None, Xml("Backup", INT, "1 = parameter to be stored in a backup")] = None
    setting: Annotated[int | None, Xml("Setting", INT, "1 = device setting, not restored from a backup")] = None
    transition: Annotated[str | None, Xml("Transition", doc="Object only: IP, PS or SO (obsolete)")] = None
    sdo_access: Annotated[
        str | None, Xml("SdoAccess", doc="Object only: CompleteAccess or SubIndexAccess; default as the mailbox says")
    ] = None


class SubItem(Record):
    """Member of a composite data type; its subindex is ``subindex`` or follows from the position."""

    subindex: Annotated[int | None, Xml("SubIdx", DEC8, "Subindex; absent in array types")] = None
    name: Annotated[str | None, Xml("Name", doc="Name, pairs the member with the object's values")] = None
    display_names: Annotated[tuple[Name, ...], Xml("DisplayName", doc="Display names in all languages")] = ()
    type: Annotated[str | None, Xml("Type", doc="Data type name within the same dictionary")] = None
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments in all languages")] = ()
    bit_size: Annotated[int | None, Xml("BitSize", INT, "Size in bits")] = None
    bit_offset: Annotated[int | None, Xml("BitOffs", INT, "Offset in bits in the complete-access image")] = None
    default_string: Annotated[str | None, Xml("DefaultString", doc="Default as text (obsolete place)")] = None
    default_data: Annotated[str | None, Xml("DefaultData", HEX_BINARY, "Default bytes (obsolete place)")] = None
    min_value: Annotated[int | None, Xml("MinValue", DEC64, "Minimum (obsolete place)")] = None
    max_value: Annotated[int | None, Xml("MaxValue", DEC64, "Maximum (obsolete place)")] = None
    default_value: Annotated[int | None, Xml("DefaultValue", DEC64, "Default (obsolete place)")] = None
    flags: Annotated[Flags | None, Xml("Flags")] = None
    properties: Annotated[tuple[Property, ...], Xml("Property", doc="Properties")] = ()
    xml: Annotated[str | None, Xml("Xml", RAW, "Free XML of the vendor")] = None


class DataType(Record):
    """Data type; its name is valid within one dictionary only."""

    type_index: Annotated[int | None, Xml("Index", HEX16, "CoE index of the type")] = None
    name: Annotated[str | None, Xml("Name", doc="Type name, the key within its dictionary")] = None
    base_type: Annotated[str | None, Xml("BaseType", doc="Type of the elements or of the enumeration")] = None
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments in all languages")] = ()
    bit_size: Annotated[int | None, Xml("BitSize", INT, "Size in bits")] = None
    array_infos: Annotated[tuple[ArrayInfo, ...], Xml("ArrayInfo", doc="Array bounds, one item a dimension")] = ()
    sub_items: Annotated[tuple[SubItem, ...], Xml("SubItem")] = ()
    enum_infos: Annotated[tuple[EnumInfo, ...], Xml("EnumInfo")] = ()
    properties: Annotated[tuple[Property, ...], Xml("Properties/Property", doc="Properties")] = ()
    xml: Annotated[str | None, Xml("Xml", RAW, "Free XML of the vendor")] = None


class DeclaredValues(Record):
    """Info element of an object or of one of its sub-items: default, minimum and maximum as declared."""

    CHOICES: ClassVar[tuple[tuple[str, ...], ...]] = (
        ("default_data", "default_value", "default_string"),
        ("min_data", "min_value"),
        ("max_data", "max_value"),
    )

    default_string: Annotated[str | None, Xml("Info/DefaultString", doc="Default as text")] = None
    min_data: Annotated[str | None, Xml("Info/MinData", HEX_BINARY, "Minimum, bytes little-endian in hex")] = None
    max_data: Annotated[str | None, Xml("Info/MaxData", HEX_BINARY, "Maximum, bytes little-endian in hex")] = None
    default_data: Annotated[str | None, Xml("Info/DefaultData", HEX_BINARY, "Default, bytes little-endian in hex")] = (
        None
    )
    min_value: Annotated[int | None, Xml("Info/MinValue", DEC64, "Minimum as number")] = None
    max_value: Annotated[int | None, Xml("Info/MaxValue", DEC64, "Maximum as number")] = None
    default_value: Annotated[int | None, Xml("Info/DefaultValue", DEC64, "Default as number")] = None
    info_sub_items: Annotated[
        tuple["InfoSubItem", ...], Xml("Info/SubItem", doc="Declared values of the sub-items, paired by name")
    ] = ()
    display_names: Annotated[tuple[Name, ...], Xml("Info/DisplayName", doc="Display name")] = ()
    unit: Annotated[int | None, Xml("Info/Unit", HEX, "Unit, packed 32-bit notation of ETG.1004")] = None
    scaling: Annotated[str | None, Xml("Info/Scaling", RAW, "Scaling (schemas after 1.17), as XML")] = None


class InfoSubItem(DeclaredValues):
    """Info/SubItem: declared values of the sub-item with this name (there is no subindex)."""

    SCHEMA_ORDER: ClassVar[tuple[str, ...]] = ("Name",)

    name: Annotated[str | None, Xml("Name", doc="Name of the sub-item of the data type")] = None


class Object(DeclaredValues):
    """Object of a dictionary as declared; :mod:`esicatalog.model.dictionary` resolves it into its subindices."""

    SCHEMA_ORDER: ClassVar[tuple[str, ...]] = ("Index", "Name", "Comment", "Type", "BitSize")

    object_index: Annotated[int | None, Xml("Index", HEX16, "Object index")] = None
    depend_on_slot: Annotated[bool | None, Xml("Index@DependOnSlot", BOOL, "Index is shifted per slot")] = None
    depend_on_slot_group: Annotated[
        bool | None, Xml("Index@DependOnSlotGroup", BOOL, "Index is shifted per slot group")
    ] = None
    overwritten_by_module: Annotated[
        bool | None, Xml("Index@OverwrittenByModule", BOOL, "A plugged module's object of this index replaces it")
    ] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments in all languages")] = ()
    type: Annotated[str | None, Xml("Type", doc="Data type name within the same dictionary")] = None
    bit_size: Annotated[int | None, Xml("BitSize", INT, "Size in bits")] = None
    flags: Annotated[Flags | None, Xml("Flags")] = None
    properties: Annotated[tuple[Property, ...], Xml("Properties/Property", doc="Properties")] = ()
    xml: Annotated[str | None, Xml("Xml", RAW, "Free XML of the vendor")] = None


class Dictionary(Record):
    """Object dictionary: of a device, a module, or an EtherCATDict document of its own."""

    unit_types: Annotated[
        tuple[UnitType, ...], Xml("UnitTypes/UnitType", doc="Units of the vendor's own, as JSON")
    ] = ()
    data_types: Annotated[tuple[DataType, ...], Xml("DataTypes/DataType")] = ()
    objects: Annotated[tuple[Object, ...], Xml("Objects/Object")] = ()
