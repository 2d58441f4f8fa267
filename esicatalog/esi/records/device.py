"""Device: one (ProductCode, RevisionNo) of a vendor (EtherCATInfo.xsd DeviceType)."""

from typing import Annotated, ClassVar

from esicatalog.esi.binding import PRESENT, RAW, Record, Xml
from esicatalog.esi.notes import Unmapped
from esicatalog.esi.numbers import (
    BOOL,
    DEC,
    DEC16,
    FLOAT,
    HEX,
    HEX8,
    HEX16,
    HEX_BINARY,
    IDENTITY,
    IMAGE,
    INT,
    PHYSICS,
    SWITCH8,
)
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.mailbox import Mailbox
from esicatalog.esi.records.pdo import Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.esi.records.slots import ModulePdoGroup, Slot, SlotGroupData, SlotSelection


class HideType(Record):
    """Another revision that this description supersedes."""

    text: Annotated[str | None, Xml(".", doc="Text of the element, usually empty")] = None
    product_code: Annotated[
        int | None, Xml("@ProductCode", IDENTITY, "Product code of the hidden device; NULL = the same product")
    ] = None
    revision_no: Annotated[int | None, Xml("@RevisionNo", IDENTITY, "Hidden revision")] = None
    product_revision: Annotated[str | None, Xml("@ProductRevision", doc="Hidden revision as text (obsolete)")] = None


class RelatedDevice(Record):
    """AlternativeType: a device that can stand in for this one."""

    text: Annotated[str | None, Xml(".", doc="Type text")] = None
    product_code: Annotated[int | None, Xml("@ProductCode", IDENTITY, "Product code")] = None
    revision_no: Annotated[int | None, Xml("@RevisionNo", IDENTITY, "Revision")] = None


class SubDevice(RelatedDevice):
    """SubDevice: one of several slave controllers in a box."""

    previous_device: Annotated[int | None, Xml("@PreviousDevice", INT, "Position of the device before it")] = None
    previous_port_no: Annotated[int | None, Xml("@PreviousPortNo", INT, "Port of the device before it")] = None
    hideable: Annotated[bool | None, Xml("@Hideable", BOOL, "May be hidden (schema 1.17)")] = None


class RailChannel(Record):
    """EtherCAT P: one external supply channel."""

    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names")] = ()
    voltage_v: Annotated[float | None, Xml("Voltage", FLOAT, "Voltage")] = None
    load_type: Annotated[str | None, Xml("Voltage@Type", doc="Kind of regulator")] = None


class Rail(Record):
    """EtherCAT P: what the device takes from the rail Us or Up."""

    power_supply: Annotated[bool | None, Xml("PowerSupply", BOOL, "Supplies the rail")] = None
    min_voltage_v: Annotated[str | None, Xml("MinVoltage", doc="Least voltage, 20.4 when absent")] = None
    current_a: Annotated[float | None, Xml("Current", FLOAT, "Current")] = None
    load_type: Annotated[str | None, Xml("Current@Type", doc="Kind of regulator")] = None
    external_channels: Annotated[tuple[RailChannel, ...], Xml("External/Channel", doc="External channels")] = ()


class EtherCatP(Record):
    """Info/Electrical/EtherCATp."""

    us: Annotated[Rail | None, Xml("Device/Us", doc="Rail Us")] = None
    up: Annotated[Rail | None, Xml("Device/Up", doc="Rail Up")] = None
    supply_us_max_current_a: Annotated[float | None, Xml("PowerSupply/Us/MaxCurrent", FLOAT, "Supplied on Us")] = None
    supply_up_max_current_a: Annotated[float | None, Xml("PowerSupply/Up/MaxCurrent", FLOAT, "Supplied on Up")] = None


class PortRail(Record):
    """EtherCAT P rail of a port."""

    power_supply: Annotated[bool | None, Xml("PowerSupply", BOOL, "Supplies the rail")] = None
    max_current_a: Annotated[float | None, Xml("MaxCurrent", FLOAT, "Greatest current")] = None
    resistance_ohm: Annotated[float | None, Xml("Resistance", FLOAT, "Resistance")] = None


class Connector(Record):
    """Connector of a port."""

    text: Annotated[str | None, Xml(".", doc="Connector type")] = None
    vendor_id: Annotated[int | None, Xml("@VendorId", IDENTITY, "Vendor that defines the type")] = None


class Port(Record):
    """Info/Port."""

    type: Annotated[str | None, Xml("Type", doc="MII, EBUS or NONE")] = None
    connectors: Annotated[tuple[Connector, ...], Xml("Connector", doc="Connectors")] = ()
    label: Annotated[str | None, Xml("Label", doc="Label on the housing")] = None
    rx_delay_ns: Annotated[int | None, Xml("RxDelay", INT, "Receive delay")] = None
    tx_delay_ns: Annotated[int | None, Xml("TxDelay", INT, "Transmit delay")] = None
    physical_phy_addr: Annotated[int | None, Xml("PhysicalPhyAddr", INT, "PHY address")] = None
    us: Annotated[PortRail | None, Xml("EtherCATp/Us", doc="EtherCAT P rail Us")] = None
    up: Annotated[PortRail | None, Xml("EtherCATp/Up", doc="EtherCAT P rail Up")] = None


class ExecutionUnit(Record):
    """Info/ExecutionUnit."""

    type: Annotated[str | None, Xml("Type", doc="PRIMARY, SECONDARY or NONE")] = None
    rx_delay_ns: Annotated[int | None, Xml("RxDelay", INT, "Receive delay")] = None
    tx_delay_ns: Annotated[int | None, Xml("TxDelay", INT, "Transmit delay")] = None


class FeatureRegister(Record):
    """Register of a DeviceFeature."""

    start_address: Annotated[int | None, Xml("StartAddress", INT, "Start address")] = None
    length_bytes: Annotated[int | None, Xml("Length", INT, "Length")] = None
    bit_mask: Annotated[int | None, Xml("BitMask", HEX, "Bit mask")] = None


class DeviceFeature(Record):
    """Info/DeviceFeature."""

    name: Annotated[str | None, Xml("Name", doc="Name")] = None
    value: Annotated[str | None, Xml("Value", doc="Value")] = None
    description: Annotated[str | None, Xml("Description", doc="Description")] = None
    registers: Annotated[tuple[FeatureRegister, ...], Xml("Register", doc="Registers")] = ()


class Fmmu(Record):
    """FMMU; its position is its number."""

    usage: Annotated[str | None, Xml(".", doc="Outputs, Inputs, MBoxState or a word of the vendor's")] = None
    op_only: Annotated[bool | None, Xml("@OpOnly", BOOL, "Active in OP only (obsolete)")] = None
    sm: Annotated[int | None, Xml("@Sm", INT, "SyncManager that it maps")] = None
    su: Annotated[int | None, Xml("@Su", INT, "Sync unit")] = None


class SyncManager(Record):
    """SyncManager; its position is its number."""

    usage: Annotated[str | None, Xml(".", doc="MBoxOut, MBoxIn, Outputs, Inputs or a word of the vendor's")] = None
    min_size: Annotated[int | None, Xml("@MinSize", DEC16, "Least length in bytes")] = None
    max_size: Annotated[int | None, Xml("@MaxSize", DEC16, "Greatest length in bytes")] = None
    default_size: Annotated[int | None, Xml("@DefaultSize", DEC16, "Length in bytes of the default assignment")] = None
    start_address: Annotated[int | None, Xml("@StartAddress", HEX16, "Physical start address")] = None
    control_byte: Annotated[int | None, Xml("@ControlByte", HEX8, "ControlByte, register 0x0804 + 8n")] = None
    enable: Annotated[int | None, Xml("@Enable", SWITCH8, "Enable, bit 0 of register 0x0806 + 8n")] = None
    one_byte_mode: Annotated[bool | None, Xml("@OneByteMode", BOOL, "One byte mode (obsolete)")] = None
    virtual: Annotated[bool | None, Xml("@Virtual", BOOL, "No SyncManager register is programmed for it")] = None
    watchdog: Annotated[bool | None, Xml("@Watchdog", BOOL, "Watchdog (obsolete)")] = None
    op_only: Annotated[bool | None, Xml("@OpOnly", BOOL, "Active in OP only")] = None
    fixed_assignment: Annotated[bool | None, Xml("@FixedAssignment", BOOL, "Fixed assignment (obsolete)")] = None


class SyncUnit(Record):
    """Su element; Pdo@Su and Fmmu@Su give its position."""

    name: Annotated[str | None, Xml(".", doc="Name of the sync unit")] = None
    separate_su: Annotated[bool | None, Xml("@SeparateSu", BOOL, "Own sync unit")] = None
    separate_frame: Annotated[bool | None, Xml("@SeparateFrame", BOOL, "Own frame")] = None
    depend_on_input_state: Annotated[bool | None, Xml("@DependOnInputState", BOOL, "Depends on the input state")] = None
    frame_repeat_support: Annotated[bool | None, Xml("@FrameRepeatSupport", BOOL, "Frames may be repeated")] = None


class EepromCategory(Record):
    """Eeprom/Category: data that goes into the image as it stands."""

    CHOICES: ClassVar[tuple[tuple[str, ...], ...]] = (("data_string", "data_uint", "data_udint", "data"),)

    cat_no: Annotated[int | None, Xml("CatNo", INT, "Category number")] = None
    data: Annotated[str | None, Xml("Data", HEX_BINARY, "Data in hex")] = None
    data_string: Annotated[str | None, Xml("DataString", doc="Data as text")] = None
    data_uint: Annotated[int | None, Xml("DataUINT", INT, "Data as UINT")] = None
    data_udint: Annotated[int | None, Xml("DataUDINT", INT, "Data as UDINT")] = None
    preserve_online_data: Annotated[bool | None, Xml("@PreserveOnlineData", BOOL, "Keep what the device has")] = None


class Eeprom(Record):
    """Eeprom element: what the SII image needs beyond the description."""

    CHOICES: ClassVar[tuple[tuple[str, ...], ...]] = (("data", "config_data"),)

    assign_to_pdi: Annotated[bool | None, Xml("@AssignToPdi", BOOL, "EEPROM access is given to the PDI")] = None
    data: Annotated[str | None, Xml("Data", HEX_BINARY, "Whole image in hex")] = None
    byte_size: Annotated[int | None, Xml("ByteSize", INT, "Size of the EEPROM in bytes")] = None
    config_data: Annotated[str | None, Xml("ConfigData", HEX_BINARY, "SII words 0 to 6 in hex, no check sum")] = None
    config_data2: Annotated[str | None, Xml("ConfigData2", HEX_BINARY, "Further ConfigData (after 1.17)")] = None
    boot_strap: Annotated[
        str | None, Xml("BootStrap", HEX_BINARY, "Bootstrap mailbox: rx offset, rx size, tx offset, tx size in hex")
    ] = None
    categories: Annotated[tuple[EepromCategory, ...], Xml("Category", doc="Further categories, as JSON")] = ()
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW)] = None


class Device(Record):
    """Device element. Vendor, group and file version belong to the source, not to the description."""

    SCHEMA_ORDER: ClassVar[tuple[str, ...]] = (
        "Sci",
        "Type",
        "HideType",
        "AlternativeType",
        "SubDevice",
        "Name",
        "Comment",
        "URL",
        "Info/Electrical",
        "Info/StateMachine",
        "Info/Mailbox",
        "Info/EtherCATController",
        "Info/Port",
        "Info/ExecutionUnit",
        "Info/VendorSpecific",
    )

    type: Annotated[str | None, Xml("Type", doc="Type text: the order code")] = None
    product_code: Annotated[int | None, Xml("Type@ProductCode", IDENTITY, "Product code; NULL when not given")] = None
    revision_no: Annotated[int | None, Xml("Type@RevisionNo", IDENTITY, "Revision number; NULL when not given")] = None
    serial_no: Annotated[int | None, Xml("Type@SerialNo", IDENTITY, "Serial number, if every unit has the same")] = None
    check_product_code: Annotated[str | None, Xml("Type@CheckProductCode", doc="NONE or EQ")] = None
    check_revision_no: Annotated[
        str | None,
        Xml("Type@CheckRevisionNo", doc="Revisions a master accepts: NONE, EQ, EQ_OR_G, LW_EQ, LW_EQ_HW_EQ_OR_G, …"),
    ] = None
    check_serial_no: Annotated[str | None, Xml("Type@CheckSerialNo", doc="NONE or EQ")] = None
    tc_sm_class: Annotated[str | None, Xml("Type@TcSmClass", doc="TwinCAT only")] = None
    tc_cfg_mode_safe_op: Annotated[bool | None, Xml("Type@TcCfgModeSafeOp", BOOL, "TwinCAT only")] = None
    use_lrd_lwr: Annotated[bool | None, Xml("Type@UseLrdLwr", BOOL, "Cannot handle LRW frames")] = None
    module_pdo_group: Annotated[int | None, Xml("Type@ModulePdoGroup", INT, "ModulePdoGroup of its own PDOs")] = None
    download_module_list: Annotated[bool | None, Xml("Type@DownloadModuleList", BOOL, "Obsolete")] = None
    show_hideable_sub_devices: Annotated[
        bool | None, Xml("Type@ShowHideableSubDevices", BOOL, "Show hideable sub-devices (schema 1.17)")
    ] = None
    invisible: Annotated[bool | None, Xml("@Invisible", BOOL, "No slave controller: end cap, power feed")] = None
    physics: Annotated[
        str | None, Xml("@Physics", PHYSICS, "Ports A to D: Y MII, K E-bus, H fast hot connect, blank unused")
    ] = None
    crc32: Annotated[int | None, Xml("@Crc32", HEX, "Check sum against alteration")] = None
    sci: Annotated[str | None, Xml("Sci", RAW, "Saved configuration (SCI files), as XML")] = None
    hide_types: Annotated[tuple[HideType, ...], Xml("HideType")] = ()
    alternative_types: Annotated[
        tuple[RelatedDevice, ...], Xml("AlternativeType", doc="Devices that can stand in, as JSON")
    ] = ()
    sub_devices: Annotated[tuple[SubDevice, ...], Xml("SubDevice", doc="Slave controllers in the box, as JSON")] = ()
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments in all languages")] = ()
    urls: Annotated[tuple[Name, ...], Xml("URL", doc="Links in all languages")] = ()

    e_bus_current_ma: Annotated[
        int | None, Xml("Info/Electrical/EBusCurrent", INT, "E-bus consumption in mA; negative = supplies current")
    ] = None
    ether_cat_p: Annotated[EtherCatP | None, Xml("Info/Electrical/EtherCATp", doc="EtherCAT P rails, as JSON")] = None
    preop_timeout_ms: Annotated[
        int | None, Xml("Info/StateMachine/Timeout/PreopTimeout", INT, "INIT to PREOP or BOOT, ms")
    ] = None
    safeop_op_timeout_ms: Annotated[
        int | None, Xml("Info/StateMachine/Timeout/SafeopOpTimeout", INT, "PREOP to SAFEOP and SAFEOP to OP, ms")
    ] = None
    back_to_init_timeout_ms: Annotated[
        int | None, Xml("Info/StateMachine/Timeout/BackToInitTimeout", INT, "Any state to INIT, ms")
    ] = None
    back_to_safeop_timeout_ms: Annotated[
        int | None, Xml("Info/StateMachine/Timeout/BackToSafeopTimeout", INT, "OP to SAFEOP, ms")
    ] = None
    start_to_init: Annotated[
        bool | None, Xml("Info/StateMachine/Behavior@StartToInit", BOOL, "Start-up ends in INIT")
    ] = None
    start_to_preop: Annotated[
        bool | None, Xml("Info/StateMachine/Behavior@StartToPreop", BOOL, "Start-up ends in PREOP")
    ] = None
    start_to_safeop: Annotated[
        bool | None, Xml("Info/StateMachine/Behavior@StartToSafeop", BOOL, "Start-up ends in SAFEOP")
    ] = None
    start_to_safeop_no_sync: Annotated[
        bool | None, Xml("Info/StateMachine/Behavior@StartToSafeopNoSync", BOOL, "Start-up ends in SAFEOP without sync")
    ] = None
    mailbox_request_timeout_ms: Annotated[
        int | None, Xml("Info/Mailbox/Timeout/RequestTimeout", INT, "Mailbox request timeout, ms")
    ] = None
    mailbox_response_timeout_ms: Annotated[
        int | None, Xml("Info/Mailbox/Timeout/ResponseTimeout", INT, "Mailbox response timeout, ms")
    ] = None
    dpram_size: Annotated[
        int | None, Xml("Info/EtherCATController/DpramSize", INT, "Process data RAM of the slave controller, bytes")
    ] = None
    sm_count: Annotated[int | None, Xml("Info/EtherCATController/SmCount", INT, "SyncManagers it has")] = None
    fmmu_count: Annotated[int | None, Xml("Info/EtherCATController/FmmuCount", INT, "FMMUs it has")] = None
    ports: Annotated[tuple[Port, ...], Xml("Info/Port", doc="Ports, as JSON")] = ()
    execution_units: Annotated[tuple[ExecutionUnit, ...], Xml("Info/ExecutionUnit", doc="Execution units, JSON")] = ()
    station_alias_supported: Annotated[
        str | None, Xml("Info/StationAliasSupported", doc="NO_SUPPORT, REGISTER_SUPPORT, PROCESSDATA_SUPPORT")
    ] = None
    identification_ado: Annotated[
        int | None, Xml("Info/IdentificationAdo", HEX16, "Register or memory address of the ID selector")
    ] = None
    identification_reg134: Annotated[
        bool | None, Xml("Info/IdentificationReg134", BOOL, "ID is returned through register 0x0134")
    ] = None
    device_features: Annotated[tuple[DeviceFeature, ...], Xml("Info/DeviceFeature", doc="Features, as JSON")] = ()
    data_rates: Annotated[str | None, Xml("Info/DataRates", RAW, "DataRates (schemas after 1.17), as XML")] = None
    info_vendor_specific: Annotated[str | None, Xml("Info/VendorSpecific", RAW)] = None

    group_type: Annotated[str | None, Xml("GroupType", doc="Group that the description names")] = None
    profiles: Annotated[tuple[Profile, ...], Xml("Profile")] = ()
    fmmus: Annotated[tuple[Fmmu, ...], Xml("Fmmu")] = ()
    sync_managers: Annotated[tuple[SyncManager, ...], Xml("Sm")] = ()
    sync_units: Annotated[tuple[SyncUnit, ...], Xml("Su")] = ()
    rx_pdos: Annotated[tuple[Pdo, ...], Xml("RxPdo")] = ()
    tx_pdos: Annotated[tuple[Pdo, ...], Xml("TxPdo")] = ()
    mailbox: Annotated[Mailbox | None, Xml("Mailbox")] = None

    dc: Annotated[bool, Xml("Dc", PRESENT, "1 when the element Dc is present")] = False
    dc_unknown_frmw: Annotated[bool | None, Xml("Dc@UnknownFRMW", BOOL, "Does not process FRMW")] = None
    dc_unknown_64bit: Annotated[bool | None, Xml("Dc@Unknown64Bit", BOOL, "No 64 bit system time")] = None
    dc_external_ref_clock: Annotated[bool | None, Xml("Dc@ExternalRefClock", BOOL, "Follows an external clock")] = None
    dc_potential_reference_clock: Annotated[
        bool | None, Xml("Dc@PotentialReferenceClock", BOOL, "Can be the reference clock")
    ] = None
    dc_time_loop_control_only: Annotated[
        bool | None, Xml("Dc@TimeLoopControlOnly", BOOL, "Uses DC time but neither SYNC nor LATCH")
    ] = None
    dc_pdo_oversampling: Annotated[bool | None, Xml("Dc@PdoOversampling", BOOL, "PDO oversampling (after 1.17)")] = None
    op_modes: Annotated[tuple[OpMode, ...], Xml("Dc/OpMode")] = ()
    dc_vendor_specific: Annotated[str | None, Xml("Dc/VendorSpecific", RAW)] = None

    has_slots: Annotated[bool, Xml("Slots", PRESENT, "1 when the element Slots is present")] = False
    download_module_ident_list: Annotated[
        bool | None, Xml("Slots@DownloadModuleIdentList", BOOL, "Module ident list 0xF030 is downloaded")
    ] = None
    download_module_address_list: Annotated[
        bool | None, Xml("Slots@DownloadModuleAddressList", BOOL, "Module address list is downloaded")
    ] = None
    download_module_list_transition: Annotated[
        str | None, Xml("Slots@DownloadModuleListTransition", doc="IP, PS or SO")
    ] = None
    max_slot_count: Annotated[int | None, Xml("Slots@MaxSlotCount", DEC, "Greatest number of slots")] = None
    max_slot_group_count: Annotated[
        int | None, Xml("Slots@MaxSlotGroupCount", DEC, "Greatest number of slot groups")
    ] = None
    slot_pdo_increment: Annotated[int | None, Xml("Slots@SlotPdoIncrement", DEC, "PDO index step per slot")] = None
    slot_group_pdo_increment: Annotated[
        int | None, Xml("Slots@SlotGroupPdoIncrement", DEC, "PDO index step per slot group")
    ] = None
    slot_index_increment: Annotated[int | None, Xml("Slots@SlotIndexIncrement", HEX, "Object index step per slot")] = (
        None
    )
    slot_group_index_increment: Annotated[
        int | None, Xml("Slots@SlotGroupIndexIncrement", HEX, "Object index step per slot group")
    ] = None
    identify_module_by: Annotated[str | None, Xml("Slots@IdentifyModuleBy", doc="Obsolete")] = None
    slots: Annotated[tuple[Slot, ...], Xml("Slots/Slot")] = ()
    slot_group_data: Annotated[tuple[SlotGroupData, ...], Xml("Slots/SlotGroupData", doc="Slot groups, as JSON")] = ()
    module_pdo_groups: Annotated[
        tuple[ModulePdoGroup, ...], Xml("Slots/ModulePdoGroup", doc="Module PDO groups, as JSON")
    ] = ()
    slot_selections: Annotated[
        tuple[SlotSelection, ...], Xml("Slots/SlotSelections", doc="Named module selections, as JSON")
    ] = ()

    esc_reg0108: Annotated[int | None, Xml("ESC/Reg0108", HEX16, "Initial value of ESC register 0x0108")] = None
    esc_reg0400: Annotated[int | None, Xml("ESC/Reg0400", HEX16, "Watchdog divider, register 0x0400")] = None
    esc_reg0410: Annotated[int | None, Xml("ESC/Reg0410", HEX16, "PDI watchdog, register 0x0410")] = None
    esc_reg0420: Annotated[int | None, Xml("ESC/Reg0420", HEX16, "Process data watchdog, register 0x0420")] = None
    esc_mi45_access: Annotated[str | None, Xml("ESC@Mi45Access", doc="Mi45Access (after 1.17)")] = None
    esc_vendor_specific: Annotated[str | None, Xml("ESC/VendorSpecific", RAW)] = None
    eeprom: Annotated[Eeprom | None, Xml("Eeprom")] = None
    image_symbol: Annotated[str | None, Xml("Image16x14", doc="Image as a symbolic name (obsolete)")] = None
    image_file: Annotated[str | None, Xml("ImageFile16x14", doc="Image file name")] = None
    image_data: Annotated[str | None, Xml("ImageData16x14", IMAGE, "Image, bytes in hex")] = None
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW)] = None
    unmapped: tuple[Unmapped, ...] = ()
