"""What writing another SII image would change, in words, worst first."""

from collections.abc import Callable, Iterable, Iterator
from enum import IntFlag
from itertools import zip_longest
from typing import Any, NamedTuple

from esicatalog.export.sii import NOT_ASSIGNED
from esicatalog.sii.image import General, RawCategory, SiiImage
from esicatalog.sii.layout import SiiRecord
from esicatalog.sii.records import DcMode, Fmmu, Pdo, PdoEntry, SyncManager
from esicatalog.sii.words import category_title, flag_words

Differing = tuple[str, str | None, str | None]
"""What differs, what it was and what it is; None where it does not exist."""
Compare = Callable[[SiiImage, SiiImage], Iterator[Differing]]
Labels = dict[str, tuple[str, int]]
"""What fields are called, and the number of hex digits of their values; 0 = decimal."""
_PDI_WORDS: Labels = {
    "pdi_control": ("PDI control", 4),
    "pdi_configuration": ("PDI configuration", 4),
    "sync_impulse_length_10ns": ("length of the SYNC pulses in 10 ns", 0),
    "pdi_configuration_2": ("extended PDI configuration", 4),
    "reserved_5": ("word 5", 4),
    "reserved_6": ("word 6", 4),
    "station_alias": ("station alias", 0),
}
_IDENTITY: Labels = {
    "vendor_id": ("vendor id", 8),
    "product_code": ("product code", 8),
    "revision_no": ("revision number", 8),
    "serial_no": ("serial number", 8),
}
_MAILBOXES: Labels = {
    "standard_receive_mailbox_offset": ("offset of the receive mailbox", 4),
    "standard_receive_mailbox_size": ("bytes of the receive mailbox", 0),
    "standard_send_mailbox_offset": ("offset of the send mailbox", 4),
    "standard_send_mailbox_size": ("bytes of the send mailbox", 0),
    "bootstrap_receive_mailbox_offset": ("offset of the bootstrap receive mailbox", 4),
    "bootstrap_receive_mailbox_size": ("bytes of the bootstrap receive mailbox", 0),
    "bootstrap_send_mailbox_offset": ("offset of the bootstrap send mailbox", 4),
    "bootstrap_send_mailbox_size": ("bytes of the bootstrap send mailbox", 0),
    "mailbox_protocols": ("mailbox protocols", 0),
}
_OTHER_WORDS: Labels = {
    "execution_delay": ("word 0x10, a delay", 0),
    "port0_delay": ("word 0x11, a delay", 0),
    "port1_delay": ("word 0x12, a delay", 0),
    "reserved_13": ("word 0x13", 4),
    "private": ("words 0x1D to 0x3D", 0),
    "size_word": ("size word", 0),
    "version": ("version", 0),
}
_GENERAL: Labels = {
    "flags": ("flags", 0),
    "coe_details": ("CoE", 0),
    "foe_details": ("FoE", 0),
    "eoe_details": ("EoE", 0),
    "soe_channels": ("SoE channels", 0),
    "ds402_channels": ("DS402 channels", 0),
    "e_bus_current_ma": ("E-bus current in mA", 0),
    "physical_ports": ("ports", 4),
    "identification_address": ("identification address", 4),
    "legacy_ports": ("legacy ports", 2),
    "sysman_class": ("SysmanClass", 2),
}
_NAMES: Labels = {
    "order_string_number": ("order code", 0),
    "name_string_number": ("name", 0),
    "group_string_number": ("group", 0),
    "group_name_string_number": ("name of the group", 0),
    "image_string_number": ("image", 0),
}


FLAGS = "flags"


class Change(NamedTuple):
    """One thing in which an image differs from another one; None where it does not exist."""

    part: str
    label: str
    before: str | None
    after: str | None

    @property
    def text(self) -> str:
        """The change in a sentence, for an image that is not written yet."""
        if self.before is None:
            return f"{self.label} would be added: {self.after}"
        if self.after is None:
            return f"{self.label} would be removed: {self.before}"
        return f"{self.label}: {self.before} would become {self.after}"


def image_changes(old: SiiImage, new: SiiImage) -> tuple[Change, ...]:
    """How ``new`` differs from ``old``, in the order of possible harm.

    PDI words come first, with which a device can become unreachable, then identity, mailboxes, SyncManagers, FMMUs,
    PDOs, OpModes, what General says, further words and categories, texts. The check sum follows from the PDI words.
    """
    return tuple(Change(part, *differing) for part, compare in _PARTS for differing in compare(old, new))


def _differing(label: str, before: str | None, after: str | None) -> Iterator[Differing]:
    if before != after:
        yield label, before, after


def _spelled(value: Any, digits: int) -> str:
    if isinstance(value, IntFlag):
        return _flags(value)
    if isinstance(value, bytes):
        return value.rstrip(b"\0").hex(" ") or "zeros"
    return f"0x{value:0{digits}X}" if digits else str(value)


def _flags(flags: IntFlag) -> str:
    return ", ".join(flag_words(flags)) or "none"


def _fields(record_of: Callable[[SiiImage], SiiRecord], labels: Labels) -> Compare:
    def compare(old: SiiImage, new: SiiImage) -> Iterator[Differing]:
        before, after = record_of(old), record_of(new)
        for field, (label, digits) in labels.items():
            yield from _differing(label, *(_spelled(getattr(record, field), digits) for record in (before, after)))

    return compare


def _general_of(image: SiiImage) -> General:
    return image.general or General()


def _sync_managers(old: SiiImage, new: SiiImage) -> Iterator[Differing]:
    for number, pair in enumerate(zip_longest(old.sync_managers, new.sync_managers)):
        yield from _differing(f"SM{number}", *map(_sync_manager, pair))


def _sync_manager(sm: SyncManager | None) -> str | None:
    if sm is None:
        return None
    return (
        f"{sm.usage or f'usage {sm.usage_code}'} at 0x{sm.start_address:04X}, {sm.length_bytes} bytes, "
        f"control 0x{sm.control_byte:02X}, enable 0x{int(sm.enable):02X}"
    )


def _fmmus(old: SiiImage, new: SiiImage) -> Iterator[Differing]:
    # An FMMU without use at the end is padding, 0x00 or 0xFF.
    for number, pair in enumerate(zip_longest(old.fmmus, new.fmmus, fillvalue=Fmmu())):
        yield from _differing(f"FMMU{number}", *(fmmu.usage or f"usage {fmmu.usage_code}" for fmmu in pair))


def _pdos(old: SiiImage, new: SiiImage) -> Iterator[Differing]:
    for kind, pdos_of in _DIRECTIONS:
        before, after = _numbered(pdos_of(old)), _numbered(pdos_of(new))
        for key in (*before, *(key for key in after if key not in before)):
            label, pair = f"{kind} 0x{key[0]:04X}", (before.get(key), after.get(key))
            yield from _differing(label, *map(_pdo, pair))
            if None not in pair:
                yield from _differing(f"{label}, {FLAGS}", *(_flags(pdos[key].flags) for pdos in (before, after)))
                yield from _entries(label, before[key], after[key])
        common = [[key for key in pdos if key in before and key in after] for pdos in (before, after)]
        yield from _differing(
            f"order of the {kind}s", *(", ".join(f"0x{key[0]:04X}" for key in keys) for keys in common)
        )


def _numbered(pdos: Iterable[Pdo]) -> dict[tuple[int, int], Pdo]:
    """PDOs by index and by how many of that index came before: a few devices repeat an index."""
    found: dict[tuple[int, int], Pdo] = {}
    for pdo in pdos:
        number = 0
        while (pdo.pdo_index, number) in found:
            number += 1
        found[pdo.pdo_index, number] = pdo
    return found


def _pdo(pdo: Pdo | None) -> str | None:
    if pdo is None:
        return None
    place = "not assigned" if pdo.sm == NOT_ASSIGNED else f"SM{pdo.sm}"
    return f"{place}, entries: {len(pdo.entries)}, bits: {pdo.bit_length}"


def _entries(label: str, before: Pdo, after: Pdo) -> Iterator[Differing]:
    for number, pair in enumerate(zip_longest(before.entries, after.entries), start=1):
        yield from _differing(f"{label}, entry {number}", *map(_entry, pair))


def _entry(entry: PdoEntry | None) -> str | None:
    if entry is None:
        return None
    if not entry.entry_index:
        return f"a gap of {entry.bit_length} bits"
    data_type = entry.data_type or f"type 0x{entry.data_type_code:02X}"
    return f"0x{entry.entry_index:04X}:{entry.subindex:02X}, {entry.bit_length} bits, {data_type}"


def _dc_modes(old: SiiImage, new: SiiImage) -> Iterator[Differing]:
    for number, pair in enumerate(zip_longest(old.dc_modes, new.dc_modes), start=1):
        yield from _differing(f"OpMode {number}", *map(_dc_mode, pair))


def _dc_mode(mode: DcMode | None) -> str | None:
    if mode is None:
        return None
    return (
        f"AssignActivate 0x{mode.assign_activate:04X}, SYNC0 cycle {mode.cycle_time_sync0_ns} ns factor "
        f"{mode.cycle_time_sync0_factor}, shift {mode.shift_time_sync0_ns} ns, SYNC1 factor "
        f"{mode.cycle_time_sync1_factor}, shift {mode.shift_time_sync1_ns} ns"
    )


def _raw_categories(old: SiiImage, new: SiiImage) -> Iterator[Differing]:
    before, after = (image.of_type(RawCategory) for image in (old, new))
    for category_type in dict.fromkeys(item.category_type for item in (*before, *after)):
        data = (b"".join(item.data for item in part if item.category_type == category_type) for part in (before, after))
        yield from _differing(category_title(category_type), *(part.hex(" ") or None for part in data))


def _texts(old: SiiImage, new: SiiImage) -> Iterator[Differing]:
    before, after = _all_texts(old), _all_texts(new)
    for label in before:
        if label in after:
            yield from _differing(label, *(texts[label] and repr(texts[label]) for texts in (before, after)))


def _all_texts(image: SiiImage) -> dict[str, str | None]:
    """Every text by what it names."""
    general = _general_of(image)
    found = {label: image.text(getattr(general, field)) for field, (label, _) in _NAMES.items()}
    for kind, pdos_of in _DIRECTIONS:
        for (index, _), pdo in _numbered(pdos_of(image)).items():
            label = f"name of {kind} 0x{index:04X}"
            found[label] = image.text(pdo.name_string_number)
            for number, entry in enumerate(pdo.entries, start=1):
                found[f"{label}, entry {number}"] = image.text(entry.name_string_number)
    for number, mode in enumerate(image.dc_modes, start=1):
        found[f"name of OpMode {number}"] = image.text(mode.name_string_number)
        found[f"description of OpMode {number}"] = image.text(mode.description_string_number)
    return found


_DIRECTIONS: tuple[tuple[str, Callable[[SiiImage], tuple[Pdo, ...]]], ...] = (
    ("RxPDO", lambda image: image.rx_pdos),
    ("TxPDO", lambda image: image.tx_pdos),
)
_PARTS: tuple[tuple[str, Compare], ...] = (
    ("PDI words", _fields(lambda image: image.header, _PDI_WORDS)),
    ("identity", _fields(lambda image: image.header, _IDENTITY)),
    ("mailboxes", _fields(lambda image: image.header, _MAILBOXES)),
    ("SyncManagers", _sync_managers),
    ("FMMUs", _fmmus),
    ("PDOs", _pdos),
    ("OpModes", _dc_modes),
    ("General", _fields(_general_of, _GENERAL)),
    ("other words", _fields(lambda image: image.header, _OTHER_WORDS)),
    ("other categories", _raw_categories),
    ("texts", _texts),
)
