"""What the SII image of a description does not hold, and what was assumed for it."""

from collections.abc import Callable, Iterable, Iterator, Mapping

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device, Eeprom, EepromCategory, SyncManager
from esicatalog.esi.records.mailbox import Mailbox
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.esi.unreadable import unreadable_values
from esicatalog.export.esc_registers import esc_registers
from esicatalog.export.sii import FMMU_USAGE_CODES, SM_USAGE_CODES, data_type_code, op_modes_of_image
from esicatalog.export.sii_header import (
    ASSUMED_BYTE_SIZE,
    BOOTSTRAP_BYTES,
    NOT_COMPUTED,
    byte_size_in_units,
    category_data,
    computed_header,
    has_category_number,
)
from esicatalog.export.sii_merge import PDI_BYTES
from esicatalog.export.sii_texts import storable
from esicatalog.export.subject import Subject
from esicatalog.identity import Identity
from esicatalog.model.eeprom_pdos import whole_image
from esicatalog.model.pdo_facts import entry_facts, entry_words, has_length, has_object, lacks_subindex
from esicatalog.model.ports import port_kind
from esicatalog.model.sm_facts import SM_ROLES, mailbox_sync_managers, sm_facts, sm_usages
from esicatalog.sii.checksum import CHECKSUM_OFFSET
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.records import SIZE_UNIT_BYTES
from esicatalog.words import counted

_STORED = (Eeprom, EepromCategory, Mailbox, SyncManager, Pdo, Entry, OpMode)
"""Parts of a device whose values an image stores."""
_SM_ATTRIBUTES = {"start_address": "StartAddress", "control_byte": "ControlByte", "enable": "Enable"}
_MAILBOX_ATTRIBUTES = {**_SM_ATTRIBUTES, "default_size": "DefaultSize"}
_SHIFT_ATTRIBUTES = [
    f"shift_time_{signal}_{attribute}"
    for signal in ("sync0", "sync1")
    for attribute in ("factor", "input", "output_delay_ns", "input_delay_ns")
]


def eeprom_remarks(subject: Subject, descriptions: bool = False) -> tuple[str, ...]:
    """Sentences about what the image of a description does not hold, what was assumed for it, and what is odd in it.

    ``descriptions`` says whether it holds those of OpModes.
    """
    whole = whole_image(subject.device)
    if whole is not None:
        return tuple(_whole_image_remarks(subject, whole))
    found = [(sentence, look(subject.device)) for look, sentence in _REMARKS]
    found.append(("Texts cut to 255 bytes: {}.", _long_texts(subject, descriptions)))
    listed = ((sentence, ", ".join(dict.fromkeys(map(str, what)))) for sentence, what in found)
    return tuple(sentence.format(what) for sentence, what in listed if what)


def _whole_image_remarks(subject: Subject, whole: bytes) -> Iterator[str]:
    yield "The description holds the whole image (Eeprom/Data), which is taken in place of a computed one."
    try:
        image = decode_sii(whole)
    except SiiImageError as error:
        yield f"Eeprom/Data cannot be read: {error}."
        return
    header = image.header
    stored = (header.vendor_id, header.product_code, header.revision_no)
    described = (subject.vendor_id, subject.product_code, subject.revision_no)
    if any(code not in (None, other) for code, other in zip(described, stored, strict=True)):
        yield (
            f"The identity in Eeprom/Data is {Identity(*stored)}, that of the description {subject.identity_text}; do "
            "not write this image, the device would be taken for another."
        )
    yield from (f"Eeprom/Data: {finding}." for finding in image.findings)


def _pdos(device: Device) -> tuple[Pdo, ...]:
    return (*device.rx_pdos, *device.tx_pdos)


def _eeprom(device: Device) -> Eeprom:
    return device.eeprom or Eeprom()


def _bytes_of(text: str | None) -> bytes:
    return decode_hex_binary(text) or b""


def _config_data_missing(device: Device) -> list[str]:
    text = _eeprom(device).config_data
    return [] if any(_bytes_of(text)[:PDI_BYTES]) else ["usable ConfigData" if text else "ConfigData"]


def _config_data_too_short(device: Device) -> list[int]:
    size = len(_bytes_of(_eeprom(device).config_data))
    return [size] if 0 < size < PDI_BYTES else []


def _config_data_too_long(device: Device) -> list[str]:
    excess = len(_bytes_of(_eeprom(device).config_data)) - CHECKSUM_OFFSET
    return [counted(excess, "byte")] if excess > 0 else []


def _boot_strap_broken(device: Device) -> list[str]:
    text = _eeprom(device).boot_strap
    return [text] if text and 0 < len(_bytes_of(text)) < BOOTSTRAP_BYTES else []


def _boot_strap_too_long(device: Device) -> list[str]:
    text = _eeprom(device).boot_strap
    return [text] if text and len(_bytes_of(text)) > BOOTSTRAP_BYTES else []


def _byte_size_missing(device: Device) -> list[int]:
    return [ASSUMED_BYTE_SIZE] if _eeprom(device).byte_size is None else []


def _byte_size_rounded(device: Device) -> list[str]:
    given, stored = _eeprom(device).byte_size, byte_size_in_units(device.eeprom)
    return [f"{given} as {stored}"] if given not in (None, stored) else []


def _categories_unusable(device: Device) -> list[str]:
    unusable = (item for item in _eeprom(device).categories if category_data(item) is None)
    return [f"{item.cat_no}" for item in unusable if has_category_number(item)]


def _codes_missing(device: Device) -> list[str]:
    codes = {"ProductCode": device.product_code, "RevisionNo": device.revision_no}
    return [name for name, code in codes.items() if code is None]


def _long_texts(subject: Subject, descriptions: bool) -> list[str]:
    device, pdos, modes = subject.device, _pdos(subject.device), op_modes_of_image(subject.device)
    named = [device.names, *(pdo.names for pdo in pdos), *(entry.names for pdo in pdos for entry in pdo.entries)]
    if subject.group is not None:
        named.append(subject.group.names)
    texts = [device.type, device.group_type, device.image_symbol, *(mode.name for mode in modes)]
    texts += [mode.description for mode in modes if descriptions]
    texts += [name.text for names in named for name in names]
    return [f"{text[:40]!r}…" for text in texts if text and storable(text) != text]


def _unknown_types(device: Device) -> list[str]:
    entries = (entry for pdo in _pdos(device) for entry in pdo.entries if not entry_facts(entry).is_padding)
    return [entry.data_type for entry in entries if entry.data_type and not data_type_code(entry.data_type)]


def _entries_without(
    is_given: Callable[[Entry], bool], words: Callable[[int, Entry], str]
) -> Callable[[Device], list[str]]:
    def look(device: Device) -> list[str]:
        return [
            f"{words(number, entry)} of PDO 0x{pdo.pdo_index:04X}"
            for pdo in _pdos(device)
            for number, entry in enumerate(pdo.entries, start=1)
            if pdo.pdo_index is not None and not is_given(entry)
        ]

    return look


def _unread(device: Device) -> list[str]:
    return [" ".join(item) for item in unreadable_values(device, lambda part: isinstance(part, _STORED))]


def _mailboxes(device: Device) -> list[int]:
    """The SyncManagers that the image has as those of mailboxes."""
    roles = (SM_ROLES.get(usage or "") for usage in sm_usages(device))
    return [number for number, role in enumerate(roles) if role is not None and role.is_mailbox]


def _mailboxes_incomplete(device: Device) -> list[str]:
    """What a master would lack to use the mailboxes of a description that has protocols or SyncManagers for them."""
    header = computed_header(None, device)
    needed = {
        "receive mailbox": header.standard_receive_mailbox_size,
        "send mailbox": header.standard_send_mailbox_size,
        "protocols": header.mailbox_protocols,
    }
    has_mailboxes = header.mailbox_protocols or mailbox_sync_managers(device)
    return [f"no {what}" for what, there in needed.items() if has_mailboxes and not there]


def _usages_taken(device: Device) -> list[str]:
    usages = zip(device.sync_managers, sm_usages(device), strict=True)
    return [f"SM{number} {usage}" for number, (sm, usage) in enumerate(usages) if usage and not sm.usage]


def _usages_without_code(device: Device) -> list[str]:
    usages = zip(device.sync_managers, sm_usages(device), strict=True)
    return [usage or "(empty)" for sm, usage in usages if usage not in SM_USAGE_CODES and (usage or not sm.virtual)]


def _sync_managers_without(
    attributes: Mapping[str, str], is_meant: Callable[[SyncManager, bool], bool]
) -> Callable[[Device], list[str]]:
    def look(device: Device) -> list[str]:
        mailboxes = _mailboxes(device)
        return [
            f"{name} of SM{number}"
            for number, sm in enumerate(device.sync_managers)
            if is_meant(sm, number in mailboxes)
            for field, name in attributes.items()
            if getattr(sm, field) is None
        ]

    return look


def _watchdog_by_attribute(device: Device) -> list[str]:
    facts = ((number, sm, sm_facts(sm)) for number, sm in enumerate(device.sync_managers))
    return [f"SM{number}" for number, sm, fact in facts if sm.watchdog and not fact.watchdog_trigger]


def _superseded(device: Device) -> list[str]:
    left_out = len(device.op_modes) - len(op_modes_of_image(device))
    return [f"{left_out} of {len(device.op_modes)}"] if left_out else []


def _elsewhere(device: Device) -> list[str]:
    """What descriptions say and images have no place for."""
    said = {
        "PDOs of modules": device.slots,
        "Exclude": any(pdo.excludes for pdo in _pdos(device)),
        "oversampling factors": any(pdo.os_fac for pdo in _pdos(device)),
        "SwapData": any(entry.swap_data for pdo in _pdos(device) for entry in pdo.entries),
        "values of ESC registers": any(esc_registers(device)),
        "PDO lists of OpModes": any(mode.sm_assignments for mode in device.op_modes),
        "attributes of ShiftTimeSync0 and ShiftTimeSync1": any(
            getattr(mode, field) for mode in device.op_modes for field in _SHIFT_ATTRIBUTES
        ),
        "CycleTimeSync1 in ns": any(mode.cycle_time_sync1_ns for mode in device.op_modes),
        "SYNC2 and SYNC3": any(mode.activate_additional is not None for mode in device.op_modes),
        "ConfigData2": _eeprom(device).config_data2,
        "InitCmds": device.mailbox is not None and device.mailbox.coe_init_cmds,
        "object dictionary": any(profile.dictionary for profile in device.profiles),
    }
    return [what for what, there in said.items() if there]


def _not_computed(device: Device) -> list[str]:
    return [f"{what} (category {number})" for number, (what, is_said) in NOT_COMPUTED.items() if is_said(device)]


def _op_mode_descriptions(device: Device) -> list[str]:
    return [mode.description for mode in op_modes_of_image(device) if mode.description]


_REMARKS: tuple[tuple[Callable[[Device], Iterable[object]], str], ...] = (
    (
        _config_data_missing,
        "The description gives no {}: the PDI words are zero. Do not write this image unmerged; the device would not "
        "start its process data interface.",
    ),
    (_codes_missing, "Not given, so 0: {}."),
    (_unread, "Values that cannot be read, stored as if they were absent; correct the file: {}."),
    (
        _sync_managers_without(_MAILBOX_ATTRIBUTES, lambda sm, is_mailbox: is_mailbox),
        "Mailboxes without a usable attribute, stored as 0; do not write this image, no master reaches them: {}.",
    ),
    (
        _mailboxes_incomplete,
        "Mailboxes that are not described whole; do not write this image, no master reaches them: {}.",
    ),
    (
        _sync_managers_without(_SM_ATTRIBUTES, lambda sm, is_mailbox: not (sm.virtual or is_mailbox)),
        "SyncManagers of process data without a usable attribute, stored as 0; do not write this image before you know "
        "better: without Enable they are disabled, without ControlByte inputs: {}.",
    ),
    (_byte_size_missing, "No usable ByteSize is given; {} bytes are assumed."),
    (_byte_size_rounded, f"ByteSize is stored in units of {SIZE_UNIT_BYTES} bytes: {{}}."),
    (
        _config_data_too_short,
        f"ConfigData has {{}} of the {PDI_BYTES} bytes of the PDI words; the others are zero, in a merged image those "
        "of the device.",
    ),
    (_config_data_too_long, "ConfigData is {} longer than the words 0 to 6; the check sum is computed."),
    (_boot_strap_broken, "BootStrap {} is not 8 bytes; the bootstrap mailbox is zero."),
    (
        _boot_strap_too_long,
        f"BootStrap {{}} is longer than {BOOTSTRAP_BYTES} bytes; the first ones are taken. Correct the file.",
    ),
    (
        lambda device: [fmmu.usage for fmmu in device.fmmus if fmmu.usage and fmmu.usage not in FMMU_USAGE_CODES],
        "FMMUs without a code for their use, stored as unused: {}.",
    ),
    (
        _usages_taken,
        "SyncManagers without a role, stored as their mode, direction and PDOs tell: {}.",
    ),
    (
        _usages_without_code,
        "SyncManagers without a code for their use, stored as unused: {}.",
    ),
    (
        _watchdog_by_attribute,
        "The obsolete attribute Watchdog asks for a watchdog that the ControlByte does not set; the ControlByte is "
        "stored: {}.",
    ),
    (
        lambda device: [letter for letter in (device.physics or "").upper() if port_kind(letter) is None],
        "Physics letters without a code, stored as unused ports: {}.",
    ),
    (
        lambda device: [
            pdo.ref or display_text(pdo.names) or "(no name)" for pdo in _pdos(device) if pdo.pdo_index is None
        ],
        "PDOs without index, left out: {}.",
    ),
    (
        _entries_without(has_object, lambda number, entry: f"entry {number}"),
        "Entries without a usable Index or SubIndex, stored as gaps or with subindex 0; do not write this image, its "
        "PDOs are wrong: {}.",
    ),
    (
        lambda device: _entries_without(
            lambda entry: not lacks_subindex(device, entry), lambda number, entry: entry_words(entry)
        )(device),
        "Objects mapped without SubIndex, which says 0; check that these are the objects that are meant: {}.",
    ),
    (
        _entries_without(has_length, lambda number, entry: entry_words(entry)),
        "Entries without a usable BitLen, stored with length 0; do not write this image, the lengths of its process "
        "data are wrong: {}.",
    ),
    (_unknown_types, "Data types without a code, stored as 0: {}."),
    (_superseded, "OpModes superseded for newer tools (IgnoreFromBuildNo), left out: {}."),
    (
        lambda device: [item.cat_no for item in _eeprom(device).categories if not has_category_number(item)],
        "Eeprom/Category with a number that is computed from the description, or none, left out: {}.",
    ),
    (
        _categories_unusable,
        "Eeprom/Category whose data cannot be read or do not fit into their type, left out; correct the file: {}.",
    ),
    (
        _op_mode_descriptions,
        "Descriptions of OpModes, stored only in an image for a device whose own has some, as TwinCAT stores none: {}.",
    ),
    (_not_computed, "Not computed, because the layout is not published: {}."),
    (_elsewhere, "An image has no place for: {}."),
)
