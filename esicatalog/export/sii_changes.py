"""What writing another SII image would change, in words, worst first."""

from collections.abc import Callable, Iterable, Iterator
from enum import IntFlag
from itertools import zip_longest
from operator import ne
from typing import Any, NamedTuple

from esicatalog.export.sii import NOT_ASSIGNED
from esicatalog.export.sii_fields import (
    BESIDE_DC_MODE,
    BESIDE_ENTRY,
    BESIDE_GAP,
    BESIDE_PDO,
    BESIDE_SM,
    CHECK_SUM,
    CHECK_SUM_WORD,
    GENERAL,
    IDENTITY,
    MAILBOXES,
    NAMES,
    OTHER_WORDS,
    PDI_WORDS,
    Kind,
    Labels,
)
from esicatalog.sii.codes import category_title, flag_words
from esicatalog.sii.encode import category_body
from esicatalog.sii.image import (
    FILLER,
    PADDING_BYTES,
    Category,
    DistributedClocks,
    Fmmus,
    General,
    RawCategory,
    RxPdos,
    SiiImage,
    Strings,
    SyncManagers,
    TxPdos,
)
from esicatalog.sii.layout import SiiRecord
from esicatalog.sii.records import DcMode, Fmmu, Pdo, PdoEntry, SyncManager
from esicatalog.words import counted

Compare = Callable[[SiiImage, SiiImage], Iterator["Change"]]
_NO_RECORD = "bytes of no whole record"
_CONFIGURING = (General, Fmmus, SyncManagers, TxPdos, RxPdos, DistributedClocks)
"""The categories by which a master configures a device."""
_FREE = bytes([FILLER])
_STORED = {
    Strings.category_type: "order, padding or encoding of texts",
    Fmmus.category_type: "codes of FMMUs without use",
}
"""In what categories differ that say the same."""


class Change(NamedTuple):
    """One thing in which an image differs from another one; None where it does not exist."""

    label: str
    before: str | None
    after: str | None
    kind: Kind
    stored_as: str | int | None = None
    """Its field, or the type of a category that is compared by its bytes; None where several fields are one thing."""
    part: str = ""
    """The part of the image, in words."""

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

    PDI words come first, with which a device can become unreachable, then their check sum, identity, mailboxes,
    SyncManagers, FMMUs, PDOs, OpModes, what General says, what of these categories cannot be read, further words and
    categories, texts. Where nothing is found, the images can still differ as :func:`stored_otherwise` says.
    """
    return tuple(change._replace(part=part) for part, compare in _PARTS for change in compare(old, new))


def stored_otherwise(old: SiiImage, new: SiiImage) -> tuple[str, ...]:
    """In which bytes images differ that say the same, in words."""
    before, after = _bodies(old), _bodies(new)
    types = dict.fromkeys((*before, *after))
    found = {_STORED.get(kind, category_title(kind)): before.get(kind) != after.get(kind) for kind in types}
    orders = ([category.category_type for category in image.categories] for image in (old, new))
    found["order of the categories"] = ne(*orders)
    found["end mark"] = old.end_mark != new.end_mark
    found["bytes behind the end mark"] = ne(*(image.trailing.strip(_FREE) for image in (old, new)))
    return tuple(what for what, differs in found.items() if differs)


def _bodies(image: SiiImage) -> dict[int, list[bytes]]:
    """The data of the categories by type, in stored order."""
    found: dict[int, list[bytes]] = {}
    for category in image.categories:
        found.setdefault(category.category_type, []).append(category_body(category))
    return found


def _differing(
    kind: Kind, label: str, before: str | None, after: str | None, *, stored_as: str | int | None = None
) -> Iterator[Change]:
    if before != after:
        yield Change(label, before, after, kind, stored_as)


def _spelled(value: Any, digits: int) -> str:
    if isinstance(value, IntFlag):
        return _flags(value)
    if isinstance(value, bytes):
        return value.rstrip(b"\0").hex(" ") or "zeros"
    return f"0x{value:0{digits}X}" if digits else str(value)


def _flags(flags: IntFlag) -> str:
    return ", ".join(flag_words(flags)) or "none"


def _fields(record_of: Callable[[SiiImage], SiiRecord], labels: Labels) -> Compare:
    def compare(old: SiiImage, new: SiiImage) -> Iterator[Change]:
        return _differing_fields("", record_of(old), record_of(new), labels)

    return compare


def _differing_fields(
    prefix: str, before: SiiRecord | None, after: SiiRecord | None, labels: Labels
) -> Iterator[Change]:
    if before is None or after is None:
        return
    for field, (words, digits, kind) in labels.items():
        old, new = (_spelled(getattr(record, field), digits) for record in (before, after))
        yield from _differing(kind, prefix + words, old, new, stored_as=field)


def _general_of(image: SiiImage) -> General:
    return image.general or General()


def _sync_managers(old: SiiImage, new: SiiImage) -> Iterator[Change]:
    for number, pair in enumerate(zip_longest(old.sync_managers, new.sync_managers)):
        yield from _differing(Kind.CONFIGURATION, f"SM{number}", *map(_sync_manager, pair))
        yield from _differing_fields(f"SM{number}, ", *pair, BESIDE_SM)


def _sync_manager(sm: SyncManager | None) -> str | None:
    if sm is None:
        return None
    return (
        f"{sm.usage or f'usage {sm.usage_code}'} at 0x{sm.start_address:04X}, {counted(sm.length_bytes, 'byte')}, "
        f"control 0x{sm.control_byte:02X}, enable 0x{int(sm.enable):02X}"
    )


def _fmmus(old: SiiImage, new: SiiImage) -> Iterator[Change]:
    # An FMMU without use at the end is padding, 0x00 or 0xFF.
    for number, pair in enumerate(zip_longest(old.fmmus, new.fmmus, fillvalue=Fmmu())):
        yield from _differing(
            Kind.CONFIGURATION, f"FMMU{number}", *(fmmu.usage or f"usage {fmmu.usage_code}" for fmmu in pair)
        )


def _pdos(old: SiiImage, new: SiiImage) -> Iterator[Change]:
    for kind, pdos_of in _DIRECTIONS:
        before, after = numbered_pdos(pdos_of(old)), numbered_pdos(pdos_of(new))
        for key in (*before, *(key for key in after if key not in before)):
            label, pair = f"{kind} 0x{key[0]:04X}", (before.get(key), after.get(key))
            yield from _differing(Kind.CONFIGURATION, label, *map(_pdo, pair))
            yield from _differing_fields(f"{label}, ", *pair, BESIDE_PDO)
            if None not in pair:
                yield from _entries(label, before[key], after[key])
        common = [[key for key in pdos if key in before and key in after] for pdos in (before, after)]
        yield from _differing(
            Kind.CONFIGURATION,
            f"order of the {kind}s",
            *(", ".join(f"0x{key[0]:04X}" for key in keys) for keys in common),
        )


def numbered_pdos(pdos: Iterable[Pdo]) -> dict[tuple[int, int], Pdo]:
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


def _entries(label: str, before: Pdo, after: Pdo) -> Iterator[Change]:
    for number, pair in enumerate(zip_longest(before.entries, after.entries), start=1):
        yield from _differing(Kind.CONFIGURATION, f"{label}, entry {number}", *map(_entry, pair))
        beside = BESIDE_ENTRY if any(entry and entry.entry_index for entry in pair) else BESIDE_GAP
        yield from _differing_fields(f"{label}, entry {number}, ", *pair, beside)


def _entry(entry: PdoEntry | None) -> str | None:
    if entry is None:
        return None
    if not entry.entry_index:
        return f"a gap of {counted(entry.bit_length, 'bit')}"
    data_type = entry.data_type or f"type 0x{entry.data_type_code:02X}"
    return f"0x{entry.entry_index:04X}:{entry.subindex:02X}, {counted(entry.bit_length, 'bit')}, {data_type}"


def _dc_modes(old: SiiImage, new: SiiImage) -> Iterator[Change]:
    for number, pair in enumerate(zip_longest(old.dc_modes, new.dc_modes), start=1):
        yield from _differing(Kind.CONFIGURATION, f"OpMode {number}", *map(_dc_mode, pair))
        yield from _differing_fields(f"OpMode {number}, ", *pair, BESIDE_DC_MODE)


def _dc_mode(mode: DcMode | None) -> str | None:
    if mode is None:
        return None
    return (
        f"AssignActivate 0x{mode.assign_activate:04X}, SYNC0 cycle {mode.cycle_time_sync0_ns} ns factor "
        f"{mode.cycle_time_sync0_factor}, shift {mode.shift_time_sync0_ns} ns, SYNC1 factor "
        f"{mode.cycle_time_sync1_factor}, shift {mode.shift_time_sync1_ns} ns"
    )


def _unreadable(old: SiiImage, new: SiiImage) -> Iterator[Change]:
    for kind in _CONFIGURING:
        title = category_title(kind.category_type)
        for label, bytes_of in ((title, _raw_data), (f"{title}, {_NO_RECORD}", _of_no_record)):
            yield from _differing(
                Kind.CONFIGURATION, label, *(bytes_of(image, kind).hex(" ") or None for image in (old, new))
            )


def _raw_data(image: SiiImage, kind: type[Category]) -> bytes:
    return b"".join(item.data for item in image.of_type(RawCategory) if item.category_type == kind.category_type)


def _of_no_record(image: SiiImage, kind: type[Category]) -> bytes:
    """What follows the last whole record, which may be zeros too: masters refuse a size that does not fit."""
    return b"".join(item.rest for item in image.of_type(kind) if not isinstance(item, Fmmus | RawCategory))


def _raw_categories(old: SiiImage, new: SiiImage) -> Iterator[Change]:
    configuring = {kind.category_type for kind in _CONFIGURING}
    before, after = (
        [item for item in image.of_type(RawCategory) if item.category_type not in configuring] for image in (old, new)
    )
    for category_type in dict.fromkeys(item.category_type for item in (*before, *after)):
        data = (b"".join(item.data for item in part if item.category_type == category_type) for part in (before, after))
        stored = (part.hex(" ") or None for part in data)
        yield from _differing(Kind.REST, category_title(category_type), *stored, stored_as=category_type)
    for label, bytes_of in ((_NO_RECORD, _behind_texts), ("further General categories", _generals)):
        yield from _differing(Kind.REST, label, *(bytes_of(image).hex(" ") or None for image in (old, new)))


def _behind_texts(image: SiiImage) -> bytes:
    return b"".join(table.rest for table in image.of_type(Strings) if len(table.rest) > PADDING_BYTES)


def _generals(image: SiiImage) -> bytes:
    """The data of all but the first General category, which is the one that counts."""
    return b"".join(map(category_body, image.of_type(General)[1:]))


def _texts(old: SiiImage, new: SiiImage) -> Iterator[Change]:
    before, after = _all_texts(old), _all_texts(new)
    for label in before:
        if label in after:
            yield from _differing(Kind.REST, label, before[label], after[label])
    yield from _differing(Kind.REST, "texts that nothing names", *map(_unnamed, (old, new)))


def _text(image: SiiImage, string_number: int) -> str | None:
    text = image.text(string_number)
    if text is None and string_number:
        return f"string {string_number}, which is missing"
    return repr(text) if text else None


def _unnamed(image: SiiImage) -> str | None:
    named = set(_all_texts(image).values())
    texts = (string.text for table in image.of_type(Strings) for string in table.strings)
    return ", ".join(text for text in dict.fromkeys(map(repr, filter(None, texts))) if text not in named) or None


def _all_texts(image: SiiImage) -> dict[str, str | None]:
    """Every text by what it names, quoted; a string number without a string as itself."""
    general = _general_of(image)
    found = {label: _text(image, getattr(general, field)) for field, label in NAMES.items()}
    for kind, pdos_of in _DIRECTIONS:
        for (index, repeat), pdo in numbered_pdos(pdos_of(image)).items():
            label = f"name of {kind} 0x{index:04X}" + f", repeat {repeat}" * bool(repeat)
            found[label] = _text(image, pdo.name_string_number)
            for number, entry in enumerate(pdo.entries, start=1):
                found[f"{label}, entry {number}"] = _text(image, entry.name_string_number)
    for number, mode in enumerate(image.dc_modes, start=1):
        found[f"name of OpMode {number}"] = _text(image, mode.name_string_number)
        found[f"description of OpMode {number}"] = _text(image, mode.description_string_number)
    return found


_DIRECTIONS: tuple[tuple[str, Callable[[SiiImage], tuple[Pdo, ...]]], ...] = (
    ("RxPDO", lambda image: image.rx_pdos),
    ("TxPDO", lambda image: image.tx_pdos),
)
_PARTS: tuple[tuple[str, Compare], ...] = (
    ("PDI words", _fields(lambda image: image.header, PDI_WORDS)),
    (CHECK_SUM, _fields(lambda image: image.header, CHECK_SUM_WORD)),
    ("identity", _fields(lambda image: image.header, IDENTITY)),
    ("mailboxes", _fields(lambda image: image.header, MAILBOXES)),
    ("SyncManagers", _sync_managers),
    ("FMMUs", _fmmus),
    ("PDOs", _pdos),
    ("OpModes", _dc_modes),
    ("General", _fields(_general_of, GENERAL)),
    ("unreadable categories", _unreadable),
    ("other words", _fields(lambda image: image.header, OTHER_WORDS)),
    ("other categories", _raw_categories),
    ("texts", _texts),
)
