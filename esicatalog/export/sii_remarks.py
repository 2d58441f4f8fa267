"""What a person is told with an exported SII image: what it cannot hold, what was assumed, what would change."""

from collections.abc import Callable, Iterable, Iterator

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device, Eeprom, EepromCategory, SyncManager
from esicatalog.esi.records.mailbox import Mailbox
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.esi.unreadable import unreadable_values
from esicatalog.export.esc_registers import esc_registers
from esicatalog.export.sii import FMMU_USAGE_CODES, PORT_CODES, SM_USAGE_CODES, data_type_code, op_modes_of_image
from esicatalog.export.sii_changes import stored_otherwise
from esicatalog.export.sii_header import ASSUMED_BYTE_SIZE, BOOTSTRAP_BYTES, is_declarable
from esicatalog.export.sii_limits import used_bytes
from esicatalog.export.sii_merge import PDI_BYTES, MergedImage
from esicatalog.export.sii_texts import storable
from esicatalog.identity import Identity
from esicatalog.model.pdo_facts import entry_facts, has_length, has_object, object_words
from esicatalog.model.sm_facts import sm_facts, sm_role
from esicatalog.sii.checksum import CHECKSUM_OFFSET, header_checksum
from esicatalog.sii.encode import encode_sii
from esicatalog.sii.image import SiiImage

WHY_MERGE = (
    "For a device in the field, merge this image into the device's own (--merge DUMP): wrong PDI words make a device "
    "unreachable for every master, and alias, serial number and factory data, calibration for instance, exist nowhere "
    "else and are lost when they are overwritten."
)
"""Why an image should not be written as computed."""
_STORED = (Eeprom, EepromCategory, Mailbox, SyncManager, Pdo, Entry, OpMode)
"""Parts of a device whose values an image stores."""
_MAILBOX_ATTRIBUTES = {
    "start_address": "StartAddress",
    "default_size": "DefaultSize",
    "control_byte": "ControlByte",
    "enable": "Enable",
}
_CHECK_PDI = (
    "PDI words would change: wrong ones make the device unreachable. Write only when you know them to be right."
)
_WRONG_CHECK_SUM = (
    "The check sum in the dump is wrong, with which a slave controller does not load the words 0 to 6; with that of "
    "this image it would load them."
)
_CHECK_IDENTITY = "The identity would change: the dump may be that of another device or revision."


def image_text(
    device: Device, image: SiiImage, *, merged: MergedImage | None = None, dropped: Iterable[str] = ()
) -> str:
    """What a person is told about an image that is written to a file: lines of text, the most important first.

    ``image`` is what is written, ``merged`` the merge it comes from, ``dropped`` what was left out to fit.
    """
    return "\n".join(_lines(device, image, merged, tuple(dropped)))


def image_remarks(device: Device) -> tuple[str, ...]:
    """Sentences about what the image of a description does not hold, and what was assumed for it."""
    if device.eeprom is not None and decode_hex_binary(device.eeprom.data) is not None:
        return ("The description holds the whole image (Eeprom/Data); it is written as it stands.",)
    found = ((sentence, tuple(dict.fromkeys(look(device)))) for look, sentence in _REMARKS)
    return tuple(sentence.format(", ".join(map(str, what))) for sentence, what in found if what)


def _lines(device: Device, image: SiiImage, merged: MergedImage | None, dropped: tuple[str, ...]) -> Iterator[str]:
    header, used = image.header, used_bytes(image)
    identity = Identity(header.vendor_id, header.product_code, header.revision_no)
    yield f"SII image of {device.type or 'a device'} ({identity}): {used + len(image.trailing)} bytes, {used} used."
    if merged is None:
        yield WHY_MERGE
    else:
        yield from _merge_lines(image, merged)
    yield from _listed("Left out to fit the EEPROM:", dropped)
    yield from _listed("About this image:", image_remarks(device))


def _merge_lines(image: SiiImage, merged: MergedImage) -> Iterator[str]:
    yield from _unread_lines(used_bytes(image) + len(image.trailing), merged)
    changes = merged._replace(image=image).changes
    parts = {change.part for change in changes}
    if encode_sii(image) == encode_sii(merged.dump):
        yield "The device's image would not change."
    elif not changes:
        yield f"No value would change, only how it is stored: {', '.join(stored_otherwise(merged.dump, image))}."
    if merged.dump.header.checksum != header_checksum(merged.dump.header):
        yield _WRONG_CHECK_SUM
    if "PDI words" in parts:
        yield _CHECK_PDI
    if "identity" in parts:
        yield _CHECK_IDENTITY
    yield from _listed("Writing it would change, worst first:", (f"{item.part}: {item.text}" for item in changes))
    yield from _listed("Kept as the device has it:", merged.kept)


def _unread_lines(size: int, merged: MergedImage) -> Iterator[str]:
    """What of the EEPROM the dump does not hold, and what becomes of it when ``size`` bytes are written."""
    unread = merged.byte_size - merged.dump_bytes
    if unread <= 0:
        return
    yield f"The dump holds {merged.dump_bytes} of the EEPROM's {merged.byte_size} bytes; {unread} were not in it."
    if size > merged.dump_bytes:
        yield (
            f"Writing this image overwrites the first {size - merged.dump_bytes} of them, whatever they hold: better "
            "read the whole EEPROM and merge into that."
        )
    if size < merged.byte_size:
        yield (
            f"{merged.byte_size - size} bytes behind this image are no part of it and stay as they are, if the tool "
            "that writes it leaves alone what the file does not hold."
        )


def _listed(title: str, lines: Iterable[str]) -> Iterator[str]:
    listed = [f"  {line}" for line in lines]
    if listed:
        yield from (title, *listed)


def _pdos(device: Device) -> tuple[Pdo, ...]:
    return (*device.rx_pdos, *device.tx_pdos)


def _eeprom(device: Device) -> Eeprom:
    return device.eeprom or Eeprom()


def _bytes_of(text: str | None) -> int:
    return len(decode_hex_binary(text) or b"")


def _config_data_missing(device: Device) -> list[str]:
    return [] if _bytes_of(_eeprom(device).config_data) else ["ConfigData"]


def _config_data_too_short(device: Device) -> list[int]:
    size = _bytes_of(_eeprom(device).config_data)
    return [size] if 0 < size < PDI_BYTES else []


def _config_data_too_long(device: Device) -> list[int]:
    size = _bytes_of(_eeprom(device).config_data)
    return [size - CHECKSUM_OFFSET] if size > CHECKSUM_OFFSET else []


def _boot_strap_broken(device: Device) -> list[str]:
    text = _eeprom(device).boot_strap
    return [text] if text and _bytes_of(text) < BOOTSTRAP_BYTES else []


def _byte_size_missing(device: Device) -> list[int]:
    return [ASSUMED_BYTE_SIZE] if _eeprom(device).byte_size is None else []


def _codes_missing(device: Device) -> list[str]:
    codes = {"ProductCode": device.product_code, "RevisionNo": device.revision_no}
    return [name for name, code in codes.items() if code is None]


def _long_names(device: Device) -> list[str]:
    pdos = _pdos(device)
    named = (device.names, *(pdo.names for pdo in pdos), *(entry.names for pdo in pdos for entry in pdo.entries))
    texts = (name.text for names in named for name in names)
    return [f"{text[:40]!r}…" for text in texts if storable(text) != text]


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


def _mailboxes_incomplete(device: Device) -> list[str]:
    roles = ((number, sm, sm_role(sm)) for number, sm in enumerate(device.sync_managers))
    return [
        f"{name} of SM{number}"
        for number, sm, role in roles
        if role is not None and role.is_mailbox
        for field, name in _MAILBOX_ATTRIBUTES.items()
        if getattr(sm, field) is None
    ]


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
        "CycleTimeSync1 in ns": any(mode.cycle_time_sync1_ns for mode in device.op_modes),
        "SYNC2 and SYNC3": any(mode.activate_additional is not None for mode in device.op_modes),
        "descriptions of OpModes": any(mode.description for mode in device.op_modes),
        "ConfigData2": _eeprom(device).config_data2,
        "InitCmds": device.mailbox is not None and device.mailbox.coe_init_cmds,
        "object dictionary": any(profile.dictionary for profile in device.profiles),
    }
    return [what for what, there in said.items() if there]


def _not_computed(device: Device) -> list[str]:
    said = {
        "sync units (category 43)": device.sync_units,
        "SyncManagers of FMMUs (category 42)": any(fmmu.sm is not None for fmmu in device.fmmus),
    }
    return [what for what, there in said.items() if there]


_REMARKS: tuple[tuple[Callable[[Device], Iterable[object]], str], ...] = (
    (
        _config_data_missing,
        "The description gives no {}: the PDI words are zero. Do not write this image unmerged; the device would not "
        "start its process data interface.",
    ),
    (_codes_missing, "Not given, so 0: {}."),
    (_unread, "Values that cannot be read, stored as if they were absent; correct the file: {}."),
    (
        _mailboxes_incomplete,
        "Mailboxes without a usable attribute, stored as 0; do not write this image, no master reaches them: {}.",
    ),
    (_byte_size_missing, "No usable ByteSize is given; {} bytes are assumed."),
    (
        _config_data_too_short,
        f"ConfigData has {{}} of the {PDI_BYTES} bytes of the PDI words; the others are zero, in a merged image those "
        "of the device.",
    ),
    (_config_data_too_long, "ConfigData is {} bytes longer than the words 0 to 6; the check sum is computed."),
    (_boot_strap_broken, "BootStrap {} is not 8 bytes; the bootstrap mailbox is zero."),
    (
        lambda device: [fmmu.usage for fmmu in device.fmmus if fmmu.usage and fmmu.usage not in FMMU_USAGE_CODES],
        "FMMUs without a code for their use, stored as unused: {}.",
    ),
    (
        lambda device: [
            sm.usage or "(empty)"
            for sm in device.sync_managers
            if sm.usage not in SM_USAGE_CODES and not (sm.virtual and not sm.usage)
        ],
        "SyncManagers without a code for their use, stored as unused: {}.",
    ),
    (
        _watchdog_by_attribute,
        "The obsolete attribute Watchdog asks for a watchdog that the ControlByte does not set; the ControlByte is "
        "stored: {}.",
    ),
    (
        lambda device: [letter for letter in (device.physics or "").upper() if letter not in PORT_CODES],
        "Physics letters without a code, stored as unused ports: {}.",
    ),
    (
        lambda device: [pdo.ref or "(no name)" for pdo in _pdos(device) if pdo.pdo_index is None],
        "PDOs without index, left out: {}.",
    ),
    (
        _entries_without(has_object, lambda number, entry: f"entry {number}"),
        "Entries without a usable Index or SubIndex, stored as gaps or with subindex 0; do not write this image, its "
        "PDOs are wrong: {}.",
    ),
    (
        _entries_without(has_length, lambda number, entry: object_words(entry)),
        "Entries without a usable BitLen, stored with length 0; do not write this image, the lengths of its process "
        "data are wrong: {}.",
    ),
    (_unknown_types, "Data types without a code, stored as 0: {}."),
    (_long_names, "Texts cut to 255 bytes: {}."),
    (_superseded, "OpModes superseded for newer tools (IgnoreFromBuildNo), left out: {}."),
    (
        lambda device: [item.cat_no for item in _eeprom(device).categories if not is_declarable(item)],
        "Eeprom/Category with a number that is computed from the description, or none, left out: {}.",
    ),
    (_not_computed, "Not computed, because the layout is not published: {}."),
    (_elsewhere, "An image has no place for: {}."),
)
