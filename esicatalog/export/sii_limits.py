"""What an EEPROM holds of an SII image: the limits of the format, the size, and what can be left out to fit."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, NamedTuple, TypeVar

import msgspec

from esicatalog.errors import InputError
from esicatalog.export.sii import NOT_ASSIGNED
from esicatalog.sii.codes import category_title
from esicatalog.sii.encode import MAX_STRINGS, category_offsets, encode_sii, string_table
from esicatalog.sii.findings import STRING_NUMBER
from esicatalog.sii.image import (
    END_MARK,
    FILLER,
    MAX_IMAGE_BYTES,
    DistributedClocks,
    Fmmus,
    General,
    RxPdos,
    SiiImage,
    Strings,
    SyncManagers,
    TxPdos,
)
from esicatalog.sii.layout import SiiRecord
from esicatalog.sii.records import HEADER, MAX_ENTRY_BITS, DcMode, Pdo, PdoEntry
from esicatalog.words import counted

MAX_PDO_ENTRIES = 255
_FREE = bytes([FILLER])
_ERASED = b"\0" + _FREE
"""What bytes behind the end mark are that hold nothing."""

R = TypeVar("R", bound=SiiRecord)
Reduction = Callable[[Any], Any]
"""Gives a record with less in it, or the record itself."""
Write = Callable[[SiiImage], SiiImage]
"""Gives an image as it is written to a certain EEPROM; raises :class:`SiiLimitError` when it is too much for that."""


class SiiLimitError(InputError):
    """The image is more than an EEPROM holds; ``excess_bytes`` says by how much, 0 where another limit is exceeded."""

    def __init__(self, message: str, excess_bytes: int = 0) -> None:
        super().__init__(message)
        self.excess_bytes = excess_bytes


class FittedImage(NamedTuple):
    """An image that fits, and what was left out for it, in words."""

    image: SiiImage
    dropped: tuple[str, ...]


def check_image(image: SiiImage, byte_size: int, dump: SiiImage | None = None) -> SiiImage:
    """The image as it is written to an EEPROM of ``byte_size`` bytes; 128 bytes have no room for an end mark.

    What is behind the end mark of ``dump``, the device's own image, keeps its address; without a dump, what is behind
    that of the image itself. Free bytes are 0xFF up to where the dump ends, since the device may have more than was
    read; without it, up to the end.

    Raises :class:`SiiLimitError` naming what is too much: bytes, strings, entries of a PDO, bits of an entry; and
    :class:`SiiEncodeError` for another value that its field cannot hold.
    """
    return _writer(image, byte_size, dump)(image)


def fit_image(image: SiiImage, byte_size: int, dump: SiiImage | None = None) -> FittedImage:
    """The image with as little left out as an EEPROM of ``byte_size`` bytes and the format's limits demand.

    A PDO that no image can hold is left out, and where it has a SyncManager all PDOs of that, because the others alone
    would make it too short. Then, step by step until the rest fits: names of the entries of PDOs that no SyncManager is
    assigned, of all entries, of PDOs, of OpModes, of the group and image; these PDOs themselves, all PDOs, the OpModes,
    and at last every computed category, which leaves the header as devices with an EEPROM of 128 bytes have it. Other
    categories stay: they may hold what the device's maker stored. ``dump`` is that of :func:`check_image`; the EEPROM
    is what has to suffice, since a dump that ends at its end mark would have no room for anything more.

    Raises :class:`SiiLimitError` when even that is too much.
    """
    write = _writer(image, byte_size, dump)
    dropped: list[str] = []
    for words, reduce, is_needed in _STEPS:
        if is_needed(image, write):
            reduced = _renumbered(_reduced(image, reduce))
            if reduced != image:
                dropped.append(f"{words}: {_difference(image, reduced)}")
                image = reduced
    return FittedImage(write(image), tuple(dropped))


def _writer(image: SiiImage, byte_size: int, dump: SiiImage | None) -> Write:
    if dump is None:
        return partial(_written, byte_size=byte_size, own=image, filled_to=byte_size)
    return partial(_written, byte_size=byte_size, own=dump, filled_to=len(encode_sii(dump)))


def _written(image: SiiImage, byte_size: int, own: SiiImage, filled_to: int) -> SiiImage:
    """The image with the bytes behind the end mark of ``own`` and with free ones, at least ``filled_to`` in all."""
    beyond = list(_beyond_the_format(image))
    if beyond:
        raise SiiLimitError(
            f"no image can hold this, unless it is left out (esicatalog export sii --fit): {'; '.join(beyond)}"
        )
    end_mark = bool(image.categories) or byte_size > HEADER.size
    image = _with_bytes_behind(own, msgspec.structs.replace(image, end_mark=end_mark))
    used = used_bytes(image)
    needed = used + len(behind_end_mark(image))
    excess = needed - byte_size
    if excess > 0:
        raise SiiLimitError(
            f"the image takes {needed} bytes, {excess} more than the {byte_size} of the EEPROM; "
            "to fit, names and then more can be left out (esicatalog export sii --fit)",
            excess,
        )
    size = max(filled_to, needed)
    if size > MAX_IMAGE_BYTES:
        raise SiiLimitError(
            f"the description says an EEPROM of {size} bytes (Eeprom/ByteSize); the largest has {MAX_IMAGE_BYTES}"
        )
    return msgspec.structs.replace(image, trailing=image.trailing[: size - used].ljust(size - used, _FREE))


def _holds_too_much(image: SiiImage, write: Write) -> bool:
    try:
        write(image)
    except SiiLimitError:
        return True
    return False


def _has_impossible_pdos(image: SiiImage, write: Write) -> bool:
    return any(map(_is_impossible, (*image.tx_pdos, *image.rx_pdos)))


def used_bytes(image: SiiImage) -> int:
    """Bytes up to and with the end mark. Raises :class:`SiiEncodeError` for records that no image can hold."""
    return category_offsets(image)[-1] + len(END_MARK) * image.end_mark


def behind_end_mark(image: SiiImage) -> bytes:
    """What follows the end mark up to the free bytes at the end; nothing when all of it is 0x00 or 0xFF."""
    return image.trailing.rstrip(_FREE) if image.trailing.strip(_ERASED) else b""


def _with_bytes_behind(before: SiiImage, after: SiiImage) -> SiiImage:
    """``after`` with the bytes behind the end mark of ``before``, at the addresses that they have there.

    Raises :class:`SiiLimitError` when the categories of ``after`` reach into what :func:`behind_end_mark` finds there.
    """
    if not before.trailing:
        return msgspec.structs.replace(after, trailing=b"")
    grown = used_bytes(after) - used_bytes(before)
    behind = behind_end_mark(before)
    excess = grown - (len(behind) - len(behind.lstrip(_FREE)))
    if behind and excess > 0:
        raise SiiLimitError(
            f"the image is {counted(excess, 'byte')} too long: it would overwrite the device's own bytes behind "
            "the end mark; to fit, names and then more can be left out (esicatalog export sii --fit)",
            excess,
        )
    return msgspec.structs.replace(after, trailing=_FREE * -grown + before.trailing[max(grown, 0) :])


def _beyond_the_format(image: SiiImage) -> Iterator[str]:
    for table in image.of_type(Strings):
        if len(table.strings) > MAX_STRINGS:
            yield f"{len(table.strings)} strings where a string table has room for {MAX_STRINGS}"
    for pdo in (*image.tx_pdos, *image.rx_pdos):
        yield from _beyond_a_pdo(pdo)


def _beyond_a_pdo(pdo: Pdo) -> Iterator[str]:
    if len(pdo.entries) > MAX_PDO_ENTRIES:
        yield f"PDO 0x{pdo.pdo_index:04X} with {len(pdo.entries)} entries where {MAX_PDO_ENTRIES} are possible"
    for entry in pdo.entries:
        if entry.bit_length > MAX_ENTRY_BITS:
            yield (
                f"entry 0x{entry.entry_index:04X}:{entry.subindex:02X} of PDO 0x{pdo.pdo_index:04X} with "
                f"{entry.bit_length} bits where {MAX_ENTRY_BITS} are possible"
            )


def _is_impossible(pdo: Pdo) -> bool:
    return any(_beyond_a_pdo(pdo))


def _reduced(record: R, reduce: Reduction) -> R:
    """The record with ``reduce`` applied to it and, before, to all records in its tuples."""
    inner = {
        field: tuple(_reduced(item, reduce) if isinstance(item, SiiRecord) else item for item in value)
        for field in record.__struct_fields__
        if isinstance(value := getattr(record, field), tuple)
    }
    found: R = reduce(msgspec.structs.replace(record, **inner))
    return found


def _nameless(record: SiiRecord) -> SiiRecord:
    return msgspec.structs.replace(record, **dict.fromkeys(_string_fields(record), 0))


def _string_fields(record: SiiRecord) -> list[str]:
    return [field for field in record.__struct_fields__ if field.endswith(STRING_NUMBER)]


def _without_names_of(kind: type[SiiRecord]) -> Reduction:
    return lambda record: _nameless(record) if isinstance(record, kind) else record


def _without_optional_entry_names(record: SiiRecord) -> SiiRecord:
    if not isinstance(record, Pdo) or record.sm != NOT_ASSIGNED:
        return record
    return msgspec.structs.replace(record, entries=tuple(_nameless(entry) for entry in record.entries))


def _without_group(record: SiiRecord) -> SiiRecord:
    if not isinstance(record, General):
        return record
    return msgspec.structs.replace(record, group_string_number=0, group_name_string_number=0, image_string_number=0)


def _possible(pdos: Iterable[Pdo]) -> Iterator[Pdo]:
    incomplete = {pdo.sm for pdo in pdos if _is_impossible(pdo)} - {NOT_ASSIGNED}
    return (pdo for pdo in pdos if pdo.sm not in incomplete and not _is_impossible(pdo))


def _assigned(pdos: Iterable[Pdo]) -> Iterator[Pdo]:
    return (pdo for pdo in pdos if pdo.sm != NOT_ASSIGNED)


def _with_pdos(kept: Callable[[Iterable[Pdo]], Iterable[Pdo]]) -> Reduction:
    def reduce(record: SiiRecord) -> SiiRecord:
        if isinstance(record, TxPdos | RxPdos):
            return msgspec.structs.replace(record, pdos=tuple(kept(record.pdos)))
        if isinstance(record, SiiImage):
            filled = (item for item in record.categories if not isinstance(item, TxPdos | RxPdos) or item.pdos)
            return msgspec.structs.replace(record, categories=tuple(filled))
        return record

    return reduce


def _without_categories(*kinds: type[SiiRecord]) -> Reduction:
    def reduce(record: SiiRecord) -> SiiRecord:
        if not isinstance(record, SiiImage):
            return record
        kept = (item for item in record.categories if not isinstance(item, kinds))
        return msgspec.structs.replace(record, categories=tuple(kept))

    return reduce


_OPTIONAL_PDOS = "PDOs that no SyncManager is assigned"
_STEPS: tuple[tuple[str, Reduction, Callable[[SiiImage, Write], bool]], ...] = (
    (
        "PDOs that no image can hold, with all of the same SyncManager, which a master then has to know from elsewhere",
        _with_pdos(_possible),
        _has_impossible_pdos,
    ),
    (f"names of entries of {_OPTIONAL_PDOS}", _without_optional_entry_names, _holds_too_much),
    ("names of entries", _without_names_of(PdoEntry), _holds_too_much),
    ("names of PDOs", _without_names_of(Pdo), _holds_too_much),
    ("names of OpModes", _without_names_of(DcMode), _holds_too_much),
    ("names of group and image", _without_group, _holds_too_much),
    (_OPTIONAL_PDOS, _with_pdos(_assigned), _holds_too_much),
    ("all PDOs, which a master then has to know from elsewhere", _without_categories(TxPdos, RxPdos), _holds_too_much),
    ("all OpModes", _without_categories(DistributedClocks), _holds_too_much),
    ("everything else that is computed", _without_categories(Strings, General, Fmmus, SyncManagers), _holds_too_much),
)


def _difference(image: SiiImage, reduced: SiiImage) -> str:
    """What is gone: PDOs, else categories, else a number of names."""
    before, after = ([*part.rx_pdos, *part.tx_pdos] for part in (image, reduced))
    if len(before) != len(after):
        return ", ".join(f"0x{pdo.pdo_index:04X}" for pdo in before if pdo not in after)
    kept = {category.category_type for category in reduced.categories}
    gone = [item.category_type for item in image.categories if item.category_type not in kept]
    if gone:
        return ", ".join(map(category_title, gone))
    return str(len(_string_numbers(image)) - len(_string_numbers(reduced)))


def _string_numbers(image: SiiImage) -> list[int]:
    """Every use of a string."""
    used: list[int] = []

    def look(record: SiiRecord) -> SiiRecord:
        used.extend(filter(None, (getattr(record, field) for field in _string_fields(record))))
        return record

    _reduced(image, look)
    return used


def _renumbered(image: SiiImage) -> SiiImage:
    """The image with only those strings in its table that something refers to."""
    used = sorted(set(_string_numbers(image)))
    texts = [image.text(number) or "" for number in used]
    numbers = {0: 0, **{number: position for position, number in enumerate(used, start=1)}}

    def renumber(record: SiiRecord) -> SiiRecord:
        if isinstance(record, Strings):
            return string_table(texts)
        return msgspec.structs.replace(
            record, **{field: numbers[getattr(record, field)] for field in _string_fields(record)}
        )

    return _reduced(image, renumber)
