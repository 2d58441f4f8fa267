"""Mailbox protocols and start-up commands (ETG.2000 Mailbox)."""

from collections.abc import Iterator
from typing import Annotated

from esicatalog.esi.binding import PRESENT, RAW, Record, Xml
from esicatalog.esi.numbers import BOOL, DEC8, HEX16, HEX_BINARY, INT
from esicatalog.esi.records.diagnostics import Diagnostics


class InitCmd(Record):
    """Start-up command of CoE, SoE, EoE or AoE; each protocol uses its own subset of the fields."""

    transitions: Annotated[
        tuple[str, ...], Xml("Transition", doc="State changes at which it is sent: IP, PS, SO, SP, OP, OS; JSON")
    ] = ()
    object_index: Annotated[int | None, Xml("Index", HEX16, "CoE: object index")] = None
    depend_on_slot: Annotated[bool | None, Xml("Index@DependOnSlot", BOOL, "Index is shifted per slot")] = None
    depend_on_slot_group: Annotated[
        bool | None, Xml("Index@DependOnSlotGroup", BOOL, "Index is shifted per slot group")
    ] = None
    subindex: Annotated[int | None, Xml("SubIndex", DEC8, "CoE: subindex")] = None
    idn: Annotated[int | None, Xml("IDN", INT, "SoE: identification number")] = None
    channel: Annotated[int | None, Xml("@Chn", INT, "SoE: drive channel")] = None
    eoe_type: Annotated[int | None, Xml("Type", INT, "EoE: frame type")] = None
    data: Annotated[str | None, Xml("Data", HEX_BINARY, "Data as sent, bytes in hex")] = None
    adapt_automatically: Annotated[
        bool | None, Xml("Data@AdaptAutomatically", BOOL, "The configuration tool adapts the data")
    ] = None
    comment: Annotated[str | None, Xml("Comment", doc="Comment")] = None
    fixed: Annotated[bool | None, Xml("@Fixed", BOOL, "May not be changed (obsolete)")] = None
    complete_access: Annotated[bool | None, Xml("@CompleteAccess", BOOL, "Written by complete access")] = None
    overwritten_by_module: Annotated[
        bool | None, Xml("@OverwrittenByModule", BOOL, "A plugged module's command replaces it")
    ] = None


class CoeObject(Record):
    """Mailbox/CoE/Object: obsolete forerunner of InitCmd."""

    object_index: Annotated[int | None, Xml("Index", INT, "Object index")] = None
    subindex: Annotated[int | None, Xml("SubIndex", INT, "Subindex")] = None
    data: Annotated[str | None, Xml("Data", HEX_BINARY, "Data in hex")] = None
    comment: Annotated[str | None, Xml("Comment", doc="Comment")] = None


class Mailbox(Record):
    """Mailbox protocols of a device or module; an element that is present is a protocol that is supported."""

    data_link_layer: Annotated[bool | None, Xml("@DataLinkLayer", BOOL, "Mailbox repeat service supported")] = None
    real_time_mode: Annotated[bool | None, Xml("@RealTimeMode", BOOL, "Real-time mode")] = None

    aoe: Annotated[bool, Xml("AoE", PRESENT, "ADS over EtherCAT supported")] = False
    aoe_ads_router: Annotated[bool | None, Xml("AoE@AdsRouter", BOOL, "AoE: ADS router")] = None
    aoe_generate_own_net_id: Annotated[
        bool | None, Xml("AoE@GenerateOwnNetId", BOOL, "AoE: device generates its own AmsNetId")
    ] = None
    aoe_initialize_own_net_id: Annotated[
        bool | None, Xml("AoE@InitializeOwnNetId", BOOL, "AoE: AmsNetId is initialised by the master")
    ] = None
    aoe_init_cmds: Annotated[tuple[InitCmd, ...], Xml("AoE/InitCmd")] = ()

    eoe: Annotated[bool, Xml("EoE", PRESENT, "Ethernet over EtherCAT supported")] = False
    eoe_ip: Annotated[bool | None, Xml("EoE@IP", BOOL, "EoE: IP address is set")] = None
    eoe_mac: Annotated[bool | None, Xml("EoE@MAC", BOOL, "EoE: MAC address is set")] = None
    eoe_time_stamp: Annotated[bool | None, Xml("EoE@TimeStamp", BOOL, "EoE: time stamps")] = None
    eoe_init_cmds: Annotated[tuple[InitCmd, ...], Xml("EoE/InitCmd")] = ()

    coe: Annotated[bool, Xml("CoE", PRESENT, "CAN application protocol over EtherCAT supported")] = False
    coe_sdo_info: Annotated[bool | None, Xml("CoE@SdoInfo", BOOL, "CoE: SDO information service")] = None
    coe_pdo_assign: Annotated[bool | None, Xml("CoE@PdoAssign", BOOL, "CoE: 0x1C1x writable")] = None
    coe_pdo_config: Annotated[bool | None, Xml("CoE@PdoConfig", BOOL, "CoE: 0x16xx and 0x1Axx writable")] = None
    coe_pdo_upload: Annotated[bool | None, Xml("CoE@PdoUpload", BOOL, "CoE: PDOs are uploaded at start")] = None
    coe_complete_access: Annotated[bool | None, Xml("CoE@CompleteAccess", BOOL, "CoE: SDO complete access")] = None
    coe_segmented_sdo: Annotated[bool | None, Xml("CoE@SegmentedSdo", BOOL, "CoE: segmented transfer")] = None
    coe_diag_history: Annotated[bool | None, Xml("CoE@DiagHistory", BOOL, "CoE: diagnosis history 0x10F3")] = None
    coe_sdo_upload_with_max_length: Annotated[
        bool | None, Xml("CoE@SdoUploadWithMaxLength", BOOL, "CoE: upload with maximum length")
    ] = None
    coe_time_distribution: Annotated[bool | None, Xml("CoE@TimeDistribution", BOOL, "CoE: time distribution")] = None
    coe_module_od: Annotated[bool | None, Xml("CoE@ModuleOD", BOOL, "CoE: module object dictionary")] = None
    coe_eds_file: Annotated[str | None, Xml("CoE@EdsFile", doc="CoE: EDS file (obsolete)")] = None
    coe_ds402_channels: Annotated[int | None, Xml("CoE@DS402Channels", INT, "CoE: drive channels (obsolete)")] = None
    coe_objects: Annotated[tuple[CoeObject, ...], Xml("CoE/Object", doc="CoE: obsolete start-up objects, as JSON")] = ()
    coe_init_cmds: Annotated[tuple[InitCmd, ...], Xml("CoE/InitCmd")] = ()

    foe: Annotated[bool, Xml("FoE", PRESENT, "File access over EtherCAT supported")] = False

    soe: Annotated[bool, Xml("SoE", PRESENT, "Servo drive profile over EtherCAT supported")] = False
    soe_channel_count: Annotated[int | None, Xml("SoE@ChannelCount", INT, "SoE: number of drive channels")] = None
    soe_drive_follows_bit3: Annotated[
        bool | None, Xml("SoE@DriveFollowsBit3Support", BOOL, "SoE: status bit 3 'drive follows' supported")
    ] = None
    soe_init_cmds: Annotated[tuple[InitCmd, ...], Xml("SoE/InitCmd")] = ()
    soe_diag_files: Annotated[tuple[str, ...], Xml("SoE/DiagFile", doc="SoE: external diagnosis texts, as JSON")] = ()
    soe_diag_messages: Annotated[Diagnostics | None, Xml("SoE/DiagMessages", doc="SoE: diagnosis texts, as JSON")] = (
        None
    )

    voe: Annotated[bool, Xml("VoE", PRESENT, "Vendor protocol over EtherCAT supported")] = False
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW)] = None


COE = "CoE"
INIT_CMD_FIELDS = {COE: "coe_init_cmds", "SoE": "soe_init_cmds", "EoE": "eoe_init_cmds", "AoE": "aoe_init_cmds"}
"""Where the start-up commands of the protocols that have some are, in the order of sheets."""


def init_cmds(mailbox: Mailbox | None) -> Iterator[tuple[str, InitCmd]]:
    """All start-up commands, each with its protocol, in the order of :data:`INIT_CMD_FIELDS`."""
    if mailbox is not None:
        for protocol, field in INIT_CMD_FIELDS.items():
            for command in getattr(mailbox, field):
                yield protocol, command


def coe_init_cmds(mailbox: Mailbox | None) -> tuple[InitCmd, ...]:
    """Its CoE start-up commands; none without mailbox."""
    return mailbox.coe_init_cmds if mailbox is not None else ()
