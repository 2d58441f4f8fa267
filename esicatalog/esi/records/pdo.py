"""PDOs and their entries (EtherCATBase.xsd PdoType)."""

from typing import Annotated

from esicatalog.esi.binding import RAW, Record, Xml
from esicatalog.esi.numbers import BOOL, DEC8, HEX16, INT
from esicatalog.esi.records.common import Name

RX_PDO, TX_PDO = "RxPdo", "TxPdo"
"""Directions of a PDO, named from the device's side: what the master sends, and what it receives."""


class Entry(Record):
    """Entry of a PDO; index 0 is a padding gap of ``bit_length`` bits."""

    entry_index: Annotated[int | None, Xml("Index", HEX16, "Object index of the mapped entry; 0 = padding")] = None
    depend_on_slot: Annotated[bool | None, Xml("Index@DependOnSlot", BOOL, "Index is shifted per slot")] = None
    depend_on_slot_group: Annotated[
        bool | None, Xml("Index@DependOnSlotGroup", BOOL, "Index is shifted per slot group")
    ] = None
    subindex: Annotated[int | None, Xml("SubIndex", DEC8, "Subindex; absent counts as 0")] = None
    bit_length: Annotated[int | None, Xml("BitLen", INT, "Length in bits")] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    comments: Annotated[tuple[Name, ...], Xml("Comment", doc="Comments")] = ()
    data_type: Annotated[str | None, Xml("DataType", doc="Data type name")] = None
    dscale: Annotated[str | None, Xml("DataType@DScale", doc="Scaling hint, e.g. +/-10 or 4-20")] = None
    swap_data: Annotated[str | None, Xml("DataType@SwapData", doc="Swap_HB_LB, Swap_HW_LW or Swap_HB_LB_HW_LW")] = None
    fixed: Annotated[bool | None, Xml("@Fixed", BOOL, "Entry may not be changed")] = None
    safety_conn_number: Annotated[int | None, Xml("@SafetyConnNumber", INT, "Number of the safety connection")] = None
    ads_info: Annotated[str | None, Xml("AdsInfo", RAW, "AdsInfo of old TwinCAT files, as XML")] = None


class Exclude(Record):
    """PDO that may not be assigned together with the owning one."""

    pdo_index: Annotated[int | None, Xml(".", HEX16, "Index of the excluded PDO")] = None
    depend_on_slot: Annotated[bool | None, Xml("@DependOnSlot", BOOL, "Index is shifted per slot")] = None
    depend_on_slot_group: Annotated[bool | None, Xml("@DependOnSlotGroup", BOOL, "Index is shifted per slot group")] = (
        None
    )


class Pdo(Record):
    """RxPdo (master to slave), TxPdo (slave to master) or SafetyParaMapping."""

    pdo_index: Annotated[int | None, Xml("Index", HEX16, "Index of the mapping object")] = None
    depend_on_slot: Annotated[bool | None, Xml("Index@DependOnSlot", BOOL, "Index is shifted per slot")] = None
    depend_on_slot_group: Annotated[
        bool | None, Xml("Index@DependOnSlotGroup", BOOL, "Index is shifted per slot group")
    ] = None
    names: Annotated[tuple[Name, ...], Xml("Name", doc="Names in all languages")] = ()
    excludes: Annotated[tuple[Exclude, ...], Xml("Exclude")] = ()
    entries: Annotated[tuple[Entry, ...], Xml("Entry")] = ()
    excluded_sms: Annotated[
        tuple[int, ...], Xml("ExcludedSm", INT, "SyncManagers this PDO may not be assigned to, as JSON")
    ] = ()
    sm: Annotated[
        int | None,
        Xml("@Sm", INT, "Sm attribute: its SyncManager; what is in the default process image is pdos.image_sm"),
    ] = None
    fixed: Annotated[bool | None, Xml("@Fixed", BOOL, "Entry list may not be changed")] = None
    mandatory: Annotated[bool | None, Xml("@Mandatory", BOOL, "PDO must stay assigned")] = None
    virtual: Annotated[bool | None, Xml("@Virtual", BOOL, "No mapping object transports it; an FMMU may")] = None
    su: Annotated[int | None, Xml("@Su", INT, "Sync unit, position in Su")] = None
    pdo_order: Annotated[int | None, Xml("@PdoOrder", INT, "Order of the PDO (obsolete)")] = None
    os_fac: Annotated[int | None, Xml("@OSFac", INT, "Default oversampling factor")] = None
    os_min: Annotated[int | None, Xml("@OSMin", INT, "Smallest oversampling factor")] = None
    os_max: Annotated[int | None, Xml("@OSMax", INT, "Largest oversampling factor")] = None
    os_index_inc: Annotated[int | None, Xml("@OSIndexInc", INT, "Index step of the replicated entries")] = None
    overwritten_by_module: Annotated[
        bool | None, Xml("@OverwrittenByModule", BOOL, "A plugged module's PDO of this index replaces it")
    ] = None
    sra_parameter: Annotated[bool | None, Xml("@SRA_Parameter", BOOL, "Safety restore parameter")] = None
    safety_pdo_type: Annotated[
        str | None, Xml("@SafetyPdoType", doc="FSoESlave, FSoEMultipleSlave, FSoEMaster or FSoEMultipleMaster")
    ] = None
    safety_conn_number: Annotated[int | None, Xml("@SafetyConnNumber", INT, "Number of the safety connection")] = None
    ref: Annotated[str | None, Xml("@Ref", doc="Name of a shared Pdo (files before schema 1.2)")] = None
    channel: Annotated[str | None, Xml("@Chn", doc="Channel of a shared Pdo (files before schema 1.2)")] = None
