"""Layout of a process image: what has to be equal for code that reads the one to read the other.

The signature of the catalog and the comparison of two descriptions both go by it, so they never contradict each other.
"""

from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from typing import NamedTuple

import msgspec

from esicatalog.esi.content import digest
from esicatalog.esi.records.pdo import Entry
from esicatalog.model.pdo_facts import Mapped, entry_facts, is_described, mapped, mapped_words
from esicatalog.model.process_image import SmImage
from esicatalog.words import index_words

_encode = msgspec.msgpack.Encoder().encode


class ImageLayout(NamedTuple):
    """Layout of the process image of one SyncManager.

    Neither how the master's tools call the SyncManager belongs to it nor how gaps are cut: only lengths of gaps move
    anything.
    """

    transfer_direction: str
    bit_size: int
    """All bits that are described."""
    places: tuple[tuple[int, Mapped], ...]
    """Bit offsets of the entries, as far as they are known, and what these map."""
    undescribed: tuple[str, ...]
    """What has no known length, and what follows it, in words; empty for an image of known length."""


def image_layout(image: SmImage) -> ImageLayout | None:
    """The layout of an image, None where nothing is exchanged: a SyncManager more or less of these is the same."""
    if image.has_known_size and not image.bit_size:
        return None
    places = tuple([(at, mapped(entry)) for at, entry in entries_with_place(image)])
    undescribed = () if image.has_known_size else tuple(_undescribed(image))
    return ImageLayout(image.transfer_direction, image.bit_size, places, undescribed)


def image_layouts(images: Iterable[SmImage]) -> dict[int, ImageLayout]:
    """The layouts of a process image by SyncManager, of those that exchange something."""
    return {image.sm: layout for image in images if (layout := image_layout(image)) is not None}


def layout_signature(layouts: Mapping[int, ImageLayout]) -> str | None:
    """Digest of the layouts of a process image, None where nothing is exchanged."""
    return digest(_encode(list(layouts.items()))).hex() if layouts else None


def entries_with_place(image: SmImage) -> list[tuple[int, Entry]]:
    """The entries whose bit offset is known, behind it; padding and what has no bits is no place of its own."""
    return [
        (placed.bit_offset, placed.entry)
        for pdo in image.pdos
        for placed in pdo.entries
        if placed.bit_offset is not None and not entry_facts(placed.entry).is_padding and placed.entry.bit_length != 0
    ]


def _undescribed(image: SmImage) -> Iterator[str]:
    """PDOs of unknown length among the entries that have no place for it, what there is in place of PDOs, what is left
    out or brought by modules that are not chosen.

    Which PDO it is counts: two of unknown length are hardly the same.
    """
    for _, run in groupby(_without_place(image), _is_gap):
        joined = list(run)
        if not _is_gap(joined[0]):
            yield from (item if isinstance(item, str) else mapped_words(*item) for item in joined)
        elif bits := sum(item[2] or 0 for item in joined if not isinstance(item, str)):
            yield mapped_words(0, 0, bits)
    if image.left_open is not None:
        yield image.left_open
    if image.overflow is not None:
        yield image.overflow
    if image.missing_modules is not None:
        yield "PDOs of required modules"


def _without_place(image: SmImage) -> Iterator[Mapped | str]:
    for pdo in image.pdos:
        if not is_described(pdo.pdo):
            yield f"PDO {index_words(pdo.pdo.pdo_index)}"
        yield from (mapped(placed.entry) for placed in pdo.entries if placed.bit_offset is None)


def _is_gap(item: Mapped | str) -> bool:
    return not isinstance(item, str) and item[0] == 0 and item[2] is not None and item[2] >= 0
