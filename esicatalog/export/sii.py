"""EEPROM images (SII) computed from ESI descriptions, as vendor tools write them.

Rules: ETG.1000.6, ETG.2010 and what real images show: lengths of SyncManagers as declared, never computed; FMMUs padded
with 0xFF; no OSFac expanded; superseded OpModes left out; the categories of Eeprom/Category first. PDOs of modules are
not part of an image: which modules are plugged is told to the device at start-up.
"""

from collections.abc import Iterable, Iterator

from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.device import SyncManager as EsiSyncManager
from esicatalog.esi.records.document import Group
from esicatalog.esi.records.mailbox import Mailbox
from esicatalog.esi.records.pdo import Entry
from esicatalog.esi.records.pdo import Pdo as EsiPdo
from esicatalog.export.sii_header import computed_header, declared_categories, flags_of
from esicatalog.export.sii_texts import Texts
from esicatalog.export.subject import Subject
from esicatalog.model.base_types import BASE_TYPES, base_type
from esicatalog.model.eeprom_pdos import stored_pdos, whole_image
from esicatalog.model.pdo_facts import entry_facts
from esicatalog.model.ports import port_kind
from esicatalog.model.sm_facts import sm_usages
from esicatalog.model.twincat import is_superseded
from esicatalog.sii.codes import FMMU_USAGES, SM_USAGES, CoeDetails, Enabled, GeneralFlags, PdoFlags, SmEnable
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.image import (
    Category,
    DistributedClocks,
    Fmmus,
    General,
    RxPdos,
    SiiImage,
    SyncManagers,
    TxPdos,
)
from esicatalog.sii.records import DcMode, Fmmu, Pdo, PdoEntry, SyncManager

NOT_ASSIGNED = 0xFF
"""SyncManager of a PDO that no SyncManager is assigned."""
FMMU_USAGE_CODES = {usage: code for code, usage in FMMU_USAGES.items()}
SM_USAGE_CODES = {usage: code for code, usage in SM_USAGES.items()}
_UNUSED_FMMU = 0xFF
_LEGACY_PORTS = {"YY": 1, "YKY": 2, "KK": 12}
"""Byte 4 of the General category, a reserved code for Physics as a whole: what real images carry."""
_REGISTER_AL_STATUS_CODE = 0x0134
_COE_DETAILS = {
    "coe": CoeDetails.SDO,
    "coe_sdo_info": CoeDetails.SDO_INFO,
    "coe_pdo_assign": CoeDetails.PDO_ASSIGN,
    "coe_pdo_config": CoeDetails.PDO_CONFIG,
    "coe_pdo_upload": CoeDetails.PDO_UPLOAD,
    "coe_complete_access": CoeDetails.COMPLETE_ACCESS,
}
_DEVICE_FLAGS = {
    "tc_cfg_mode_safe_op": GeneralFlags.ENABLE_SAFE_OP,
    "use_lrd_lwr": GeneralFlags.ENABLE_NOT_LRW,
    "identification_reg134": GeneralFlags.IDENT_AL_STATUS,
}
_MAILBOX_FLAGS = {"data_link_layer": GeneralFlags.MAILBOX_DATA_LINK_LAYER}
_SM_ENABLE = {
    "fixed_assignment": SmEnable.FIXED_CONTENT,
    "virtual": SmEnable.VIRTUAL,
    "op_only": SmEnable.OP_ONLY,
}
_PDO_FLAGS = {
    "mandatory": PdoFlags.MANDATORY,
    "fixed": PdoFlags.FIXED_CONTENT,
    "virtual": PdoFlags.VIRTUAL_CONTENT,
    "depend_on_slot": PdoFlags.DEPEND_ON_SLOT,
    "depend_on_slot_group": PdoFlags.DEPEND_ON_SLOT_GROUP,
    "overwritten_by_module": PdoFlags.OVERWRITTEN_BY_MODULE,
}
_WRITTEN_AS = {"BYTE": "USINT", "WORD": "UINT", "DWORD": "UDINT"}
"""Bit strings of PDO entries, which vendor tools store under the codes of the integers."""


def described_image(subject: Subject, *, language: int | None = None, like: SiiImage | None = None) -> SiiImage:
    """The image of a description, as :func:`sii_image` makes it; an Eeprom/Data that is none is named with its file.

    Descriptions of OpModes are stored when ``like``, an image of the device, has some.

    Raises :class:`SiiImageError`.
    """
    try:
        descriptions = like is not None and has_descriptions(like)
        return sii_image(subject.vendor_id, subject.group, subject.device, language=language, descriptions=descriptions)
    except SiiImageError as error:
        where = ", ".join(subject.origin) or subject.identity_text
        raise SiiImageError(f"Eeprom/Data of {subject.device.type or 'the device'} ({where}): {error}") from error


def sii_image(
    vendor_id: int | None,
    group: Group | None,
    device: Device,
    *,
    language: int | None = None,
    descriptions: bool = False,
) -> SiiImage:
    """The image that the description implies, of any size; the bytes end with the end mark.

    ``group`` is what the description's GroupType names. ``language`` is the LcId of the texts, English when not given;
    a text that the description does not have in it is taken as :func:`display_text` says. Texts longer than 255 bytes
    are cut. ``descriptions`` says whether those of OpModes are stored: TwinCAT does not, other tools do. Words that
    nothing is declared for are zero, an Eeprom/Data is the image as it stands.
    :func:`esicatalog.export.sii_limits.check_image` finds what is too much for an EEPROM.

    Raises :class:`SiiImageError` when Eeprom/Data is no image.
    """
    whole = whole_image(device)
    if whole is not None:
        return decode_sii(whole)
    texts = Texts(language)
    general = _general(group, device, texts)
    clocks = DistributedClocks(modes=tuple(_dc_mode(mode, texts, descriptions) for mode in op_modes_of_image(device)))
    tx_pdos = TxPdos(pdos=tuple(_pdos(device.tx_pdos, texts)))
    rx_pdos = RxPdos(pdos=tuple(_pdos(device.rx_pdos, texts)))
    computed: list[Category] = [texts.table(), general]
    if device.fmmus:
        computed.append(Fmmus(fmmus=tuple(_fmmus(device))))
    if device.sync_managers:
        computed.append(SyncManagers(sync_managers=tuple(map(_sync_manager, device.sync_managers, sm_usages(device)))))
    computed += [pdos for pdos in (tx_pdos, rx_pdos) if pdos.pdos]
    if clocks.modes:
        computed.append(clocks)
    return SiiImage(header=computed_header(vendor_id, device), categories=(*declared_categories(device), *computed))


def has_descriptions(image: SiiImage) -> bool:
    """Whether an image holds descriptions of OpModes."""
    return any(mode.description_string_number for mode in image.dc_modes)


def op_modes_of_image(device: Device) -> list[OpMode]:
    """The OpModes of an image: those that no TwinCAT/@IgnoreFromBuildNo marks as superseded."""
    return [op_mode for op_mode in device.op_modes if not is_superseded(op_mode)]


def data_type_code(name: str | None) -> int:
    """The code under which vendor tools store the data type of a PDO entry; 0 for a type that is none of the base."""
    base = base_type(name)
    if base is None:
        return 0
    return BASE_TYPES[_WRITTEN_AS.get(base.name, base.name)].code


def _general(group: Group | None, device: Device, texts: Texts) -> General:
    mailbox = device.mailbox or Mailbox()
    physics = (device.physics or "").upper()
    ports = map(port_kind, physics[:4])
    flags = flags_of(GeneralFlags(0), _DEVICE_FLAGS, device) | flags_of(GeneralFlags(0), _MAILBOX_FLAGS, mailbox)
    address = device.identification_ado or 0
    if address == _REGISTER_AL_STATUS_CODE:
        flags, address = flags | GeneralFlags.IDENT_AL_STATUS, 0
    elif address:
        flags |= GeneralFlags.IDENT_PHYSICAL_MEMORY
    # In the order in which vendor tools fill the string table.
    order = texts.number(device.type)
    group_type = texts.number(device.group_type)
    group_name = texts.number_of(group.names) if group is not None else 0
    return General(
        order_string_number=order,
        group_string_number=group_type,
        group_name_string_number=group_name,
        name_string_number=texts.number_of(device.names),
        image_string_number=texts.number(device.image_symbol),
        legacy_ports=_LEGACY_PORTS.get(physics, 0),
        coe_details=flags_of(CoeDetails(0), _COE_DETAILS, mailbox),
        foe_details=Enabled(mailbox.foe),
        eoe_details=Enabled(mailbox.eoe),
        soe_channels=_soe_channels(mailbox),
        ds402_channels=mailbox.coe_ds402_channels or 0,
        flags=flags,
        e_bus_current_ma=device.e_bus_current_ma or 0,
        physical_ports=sum(kind.sii_code << 4 * port for port, kind in enumerate(ports) if kind is not None),
        identification_address=address,
    )


def _soe_channels(mailbox: Mailbox) -> int:
    if not mailbox.soe:
        return 0
    return 1 if mailbox.soe_channel_count is None else mailbox.soe_channel_count


def _fmmus(device: Device) -> Iterator[Fmmu]:
    for fmmu in device.fmmus:
        yield Fmmu(usage_code=FMMU_USAGE_CODES.get(fmmu.usage or "", _UNUSED_FMMU))
    if len(device.fmmus) % 2:
        yield Fmmu(usage_code=_UNUSED_FMMU)


def _sync_manager(sm: EsiSyncManager, usage: str | None) -> SyncManager:
    return SyncManager(
        start_address=sm.start_address or 0,
        length_bytes=sm.default_size or 0,
        control_byte=sm.control_byte or 0,
        enable=flags_of(SmEnable(sm.enable or 0), _SM_ENABLE, sm),
        usage_code=SM_USAGE_CODES.get(usage or "", 0),
    )


def _pdos(pdos: Iterable[EsiPdo], texts: Texts) -> Iterator[Pdo]:
    for pdo in stored_pdos(pdos):
        yield Pdo(
            pdo_index=pdo.pdo_index or 0,
            name_string_number=texts.number_of(pdo.names),
            entries=tuple(_entry(entry, texts) for entry in pdo.entries),
            sm=NOT_ASSIGNED if pdo.sm is None else pdo.sm,
            flags=flags_of(PdoFlags(0), _PDO_FLAGS, pdo),
        )


def _entry(entry: Entry, texts: Texts) -> PdoEntry:
    name, bit_length = texts.number_of(entry.names), entry.bit_length or 0
    if entry.entry_index is None or entry_facts(entry).is_padding:
        return PdoEntry(name_string_number=name, bit_length=bit_length)
    return PdoEntry(
        entry_index=entry.entry_index,
        subindex=entry.subindex or 0,
        name_string_number=name,
        data_type_code=data_type_code(entry.data_type),
        bit_length=bit_length,
    )


def _dc_mode(op_mode: OpMode, texts: Texts, descriptions: bool) -> DcMode:
    factor = op_mode.cycle_time_sync0_factor
    if factor is None:
        # Without the element SYNC0 follows the bus cycle; a time alone is not multiplied by anything.
        factor = 1 if op_mode.cycle_time_sync0_ns is None else 0
    return DcMode(
        cycle_time_sync0_ns=op_mode.cycle_time_sync0_ns or 0,
        shift_time_sync0_ns=_signed(op_mode.shift_time_sync0_ns),
        shift_time_sync1_ns=_signed(op_mode.shift_time_sync1_ns),
        cycle_time_sync1_factor=op_mode.cycle_time_sync1_factor or 0,
        assign_activate=op_mode.assign_activate or 0,
        cycle_time_sync0_factor=factor,
        name_string_number=texts.number(op_mode.name),
        description_string_number=texts.number(op_mode.description) if descriptions else 0,
    )


def _signed(time_ns: int | None) -> int:
    """A shift time as its 32 bits mean it, also where a file writes a negative one as a large number."""
    return (((time_ns or 0) + (1 << 31)) & 0xFFFF_FFFF) - (1 << 31)
