"""Header and declared categories of an SII image: what the elements Eeprom, Type, Sm and Mailbox say."""

import struct
from collections.abc import Callable, Iterator, Mapping
from functools import reduce
from operator import or_
from typing import TypeVar

from esicatalog.esi.binding import Record
from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.device import Device, Eeprom, EepromCategory, SyncManager
from esicatalog.esi.records.mailbox import Mailbox
from esicatalog.esi.unreadable import unreadable
from esicatalog.model.eeprom_pdos import whole_image
from esicatalog.model.sm_facts import sm_usages
from esicatalog.sii.checksum import CHECKSUM_OFFSET, with_checksum
from esicatalog.sii.codes import CoeDetails, GeneralFlags, MailboxProtocols, PdoFlags, SmEnable
from esicatalog.sii.image import (
    END_TYPE,
    DistributedClocks,
    Fmmus,
    General,
    RawCategory,
    RxPdos,
    Strings,
    SyncManagers,
    TxPdos,
)
from esicatalog.sii.records import SIZE_UNIT_BYTES, Header

ASSUMED_BYTE_SIZE = 2048
"""Size of the EEPROM where the description gives no ByteSize: that of 94 % of all descriptions."""
_MAX_SIZE_WORD = 0xFFFF
COMPUTED_TYPES = {
    kind.category_type for kind in (Strings, General, Fmmus, SyncManagers, TxPdos, RxPdos, DistributedClocks)
}
"""Types of the categories that are computed from the description itself."""
_CONFIGURATION_WORDS = (
    "pdi_control",
    "pdi_configuration",
    "sync_impulse_length_10ns",
    "pdi_configuration_2",
    "station_alias",
    "reserved_5",
    "reserved_6",
)
_BOOTSTRAP_WORDS = (
    "bootstrap_receive_mailbox_offset",
    "bootstrap_receive_mailbox_size",
    "bootstrap_send_mailbox_offset",
    "bootstrap_send_mailbox_size",
)
_MAILBOX_SIDES = {"receive": "MBoxOut", "send": "MBoxIn"}
_NUMBER_BYTES = {"data_uint": 2, "data_udint": 4}
BOOTSTRAP_BYTES = 2 * len(_BOOTSTRAP_WORDS)
_PROTOCOLS = {protocol.name.lower(): protocol for protocol in MailboxProtocols if protocol.name}

F = TypeVar("F", CoeDetails, GeneralFlags, MailboxProtocols, PdoFlags, SmEnable)


def flags_of(none: F, flags: Mapping[str, F], record: Record) -> F:
    """The flags of all fields of ``record`` that are set, beside those of ``none``."""
    return reduce(or_, (flag for field, flag in flags.items() if getattr(record, field)), none)


def eeprom_bytes(header: Header, device: Device) -> int:
    """Size of the EEPROM by the description: ByteSize; with Eeprom/Data by its size word, or its bytes if more."""
    whole = whole_image(device)
    return max(header.byte_size, len(whole)) if whole is not None else byte_size_in_units(device.eeprom)


def byte_size_in_units(eeprom: Eeprom | None) -> int:
    """ByteSize as a size word can say it: down to a whole unit of 128 bytes, at least one."""
    given = eeprom.byte_size if eeprom is not None else None
    return max((ASSUMED_BYTE_SIZE if given is None else given) // SIZE_UNIT_BYTES, 1) * SIZE_UNIT_BYTES


def configuration_bytes(device: Device) -> int:
    """How many bytes of the words 0 to 6 the description gives: as many as ConfigData has, all by a whole image."""
    if whole_image(device) is not None:
        return CHECKSUM_OFFSET
    config_data = device.eeprom.config_data if device.eeprom is not None else None
    return min(len(decode_hex_binary(config_data) or b""), CHECKSUM_OFFSET)


def computed_header(vendor_id: int | None, device: Device) -> Header:
    """The words 0 to 0x3F with their check sum. Words of a shorter ConfigData, and codes not given, are zero."""
    eeprom = device.eeprom or Eeprom()
    configuration = (decode_hex_binary(eeprom.config_data) or b"")[:CHECKSUM_OFFSET].ljust(CHECKSUM_OFFSET, b"\0")
    words = dict(zip(_CONFIGURATION_WORDS, struct.unpack("<7H", configuration), strict=True))
    boot_strap = decode_hex_binary(eeprom.boot_strap) or b""
    if len(boot_strap) >= BOOTSTRAP_BYTES:
        words |= zip(_BOOTSTRAP_WORDS, struct.unpack_from("<4H", boot_strap), strict=True)
    words |= {word: value or 0 for word, value in _standard_mailbox(device).items()}
    return with_checksum(
        Header(
            **words,
            vendor_id=vendor_id or 0,
            product_code=device.product_code or 0,
            revision_no=device.revision_no or 0,
            serial_no=device.serial_no or 0,
            mailbox_protocols=flags_of(MailboxProtocols(0), _PROTOCOLS, device.mailbox or Mailbox()),
            size_word=min(byte_size_in_units(eeprom) // SIZE_UNIT_BYTES - 1, _MAX_SIZE_WORD),
        )
    )


def words_not_given(device: Device) -> Iterator[str]:
    """The words of the mailboxes, by field, that the description says nothing of; a computed header has 0 there."""
    boot_strap = device.eeprom.boot_strap if device.eeprom is not None else None
    if len(decode_hex_binary(boot_strap) or b"") < BOOTSTRAP_BYTES:
        yield from _BOOTSTRAP_WORDS
    yield from (word for word, value in _standard_mailbox(device).items() if value is None)


def _standard_mailbox(device: Device) -> dict[str, int | None]:
    """The words of the standard mailbox by field, from the first SyncManagers of that use; None for one not given."""
    usages = sm_usages(device)
    found: dict[str, int | None] = {}
    for side, usage in _MAILBOX_SIDES.items():
        sm = device.sync_managers[usages.index(usage)] if usage in usages else SyncManager()
        found[f"standard_{side}_mailbox_offset"] = sm.start_address
        found[f"standard_{side}_mailbox_size"] = sm.default_size
    return found


NOT_COMPUTED: Mapping[int, tuple[str, Callable[[Device], bool]]] = {
    43: ("sync units", lambda device: bool(device.sync_units)),
    42: ("SyncManagers of FMMUs", lambda device: any(fmmu.sm is not None for fmmu in device.fmmus)),
}
"""Categories whose layout is not published: what a description says of them, and whether it does."""


def declared_categories(device: Device) -> Iterator[RawCategory]:
    """The categories of Eeprom/Category; an odd length is padded with 0xFF, as string tables are."""
    for category in device.eeprom.categories if device.eeprom is not None else ():
        data = category_data(category)
        if has_category_number(category) and data is not None:
            yield RawCategory(category_type=category.cat_no or 0, data=data + b"\xff" * (len(data) % 2))


def has_category_number(category: EepromCategory) -> bool:
    """Whether the number of an Eeprom/Category is one, and none of :data:`COMPUTED_TYPES`."""
    number = category.cat_no
    return number is not None and 0 <= number < END_TYPE and number not in COMPUTED_TYPES


def category_data(category: EepromCategory) -> bytes | None:
    """The data of an Eeprom/Category; None when they cannot be read or are a number that its bits cannot hold."""
    if category.data_string is not None:
        return category.data_string.encode() + b"\0"
    for field, size in _NUMBER_BYTES.items():
        if (value := getattr(category, field)) is not None:
            # A negative number is meant as its bits are.
            fits = -(1 << 8 * size - 1) <= value < 1 << 8 * size
            return (value % (1 << 8 * size)).to_bytes(size, "little") if fits else None
        if unreadable(category, field) is not None:
            return None
    return decode_hex_binary(category.data) if category.data else b""
