"""Comparison of the default process images: their sizes, and the first places where they differ."""

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import zip_longest
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.compare_facts import PROCESS_IMAGE, Difference, difference, either, matched
from esicatalog.model.compare_words import shown_text
from esicatalog.model.image_layout import ImageLayout, entries_with_place, image_layout
from esicatalog.model.pdo_facts import Mapped, mapped, mapped_words
from esicatalog.model.process_image import SmImage, byte_bit, default_process_image
from esicatalog.words import counted

FIRST_PLACES = 3
"""Places of a SyncManager that are told one by one."""


class _Placed(NamedTuple):
    """What lies at a bit offset."""

    mapped: Mapped
    name: str | None


def compare_images(
    left: Device, left_modules: Sequence[Module], right: Device, right_modules: Sequence[Module]
) -> Iterator[Difference]:
    """The default process images (default OpMode, default modules) by SyncManager, as far as their layouts differ."""
    images, others = default_process_image(left, left_modules), default_process_image(right, right_modules)
    for ours, theirs in matched(images, others, lambda image: image.sm):
        layout, other = (image_layout(image) if image is not None else None for image in (ours, theirs))
        if layout == other:
            continue
        place = f"SM{either(ours, theirs).sm}"
        size, other_size = (image.size_words if image is not None else None for image in (ours, theirs))
        if size != other_size:
            yield difference(PROCESS_IMAGE, f"{place} size", size, other_size, True)
        if ours is not None and theirs is not None:
            yield from _compare_places(place, ours, theirs)
        if layout is not None and other is not None:
            yield from _compare_layouts(place, layout, other)


def _compare_layouts(place: str, left: ImageLayout, right: ImageLayout) -> Iterator[Difference]:
    """What is no size and has no place."""
    for words, said, also in (
        ("direction", left.transfer_direction, right.transfer_direction),
        ("without known place", ", ".join(left.undescribed) or None, ", ".join(right.undescribed) or None),
    ):
        if said != also:
            yield difference(PROCESS_IMAGE, f"{place} {words}", said, also, True)


def _compare_places(place: str, left: SmImage, right: SmImage) -> Iterator[Difference]:
    ours, theirs = _places(left), _places(right)
    offsets = [at for at in sorted(ours.keys() | theirs.keys()) if _mapped_at(ours, at) != _mapped_at(theirs, at)]
    first = offsets if len(offsets) <= FIRST_PLACES + 1 else offsets[:FIRST_PLACES]
    for at in first:
        said, also = _words_at(ours, at), _words_at(theirs, at)
        yield difference(PROCESS_IMAGE, f"{place} at {byte_bit(at)}", said, also, True)
    if len(offsets) > len(first):
        at, *further = offsets[FIRST_PLACES:]
        said, also = (
            f"{_words_at(known, at) or 'nothing'}; {counted(len(further), 'further place')}" for known in (ours, theirs)
        )
        yield difference(PROCESS_IMAGE, f"{place} from {byte_bit(at)}", said, also, True)


def _places(image: SmImage) -> dict[int, _Placed]:
    return {
        bit_offset: _Placed(mapped(entry), shown_text(entry.names)) for bit_offset, entry in entries_with_place(image)
    }


def _mapped_at(places: dict[int, _Placed], at: int) -> Mapped | None:
    return places[at].mapped if at in places else None


def _words_at(places: dict[int, _Placed], at: int) -> str | None:
    """What begins at an offset, or what it falls into."""
    if at in places:
        found = places[at]
        return " ".join(filter(None, (mapped_words(*found.mapped), found.name)))
    starts = sorted(places)
    before = bisect_right(starts, at) - 1
    if before >= 0:
        covering = places[starts[before]].mapped
        if starts[before] + (covering[2] or 0) > at:
            return f"inside {mapped_words(*covering)} from {byte_bit(starts[before])}"
    return None


def layout_difference(left: Mapping[int, ImageLayout], right: Mapping[int, ImageLayout]) -> str:
    """In what two process images with different layouts, by SyncManager, differ, in words: the left one is "here".

    The first entry that is told counts, by its place or, where none differs, of those without known place.
    """
    ours, theirs = _by_place(left), _by_place(right)
    for place in sorted(ours.keys() | theirs.keys()):
        if ours.get(place) != theirs.get(place):
            sm, at = place
            here, there = (_begins_at(layouts.get(sm), at) for layouts in (left, right))
            return f"SM{sm} byte {byte_bit(at)} is {here} here, {there} there"
    for sm in sorted(left.keys() | right.keys()):
        unplaced = (layouts[sm].undescribed if sm in layouts else () for layouts in (left, right))
        for item, other in zip_longest(*unplaced, fillvalue="nothing"):
            if item != other:
                return f"SM{sm} without known place: {item} here, {other} there"
    here, there = (_by_sm(layouts, lambda layout: layout.bit_size) for layouts in (left, right))
    if here != there:
        return f"described bits are {here} here, {there} there"
    here, there = (_by_sm(layouts, lambda layout: layout.transfer_direction) for layouts in (left, right))
    return f"SyncManagers with PDOs are {here} here, {there} there"


def _by_place(layouts: Mapping[int, ImageLayout]) -> dict[tuple[int, int], Mapped]:
    """What begins where, by SyncManager and bit offset."""
    return {(sm, at): found for sm, layout in layouts.items() for at, found in layout.places}


def _begins_at(layout: ImageLayout | None, at: int) -> str:
    """What begins at an offset; behind the last known place may be what is not described."""
    if layout is None:
        return "nothing"
    found = dict(layout.places).get(at)
    if found is not None:
        return mapped_words(*found)
    end = max((start + (bits or 0) for start, (_, _, bits) in layout.places), default=0)
    return "not known" if layout.undescribed and at >= end else "nothing"


def _by_sm(layouts: Mapping[int, ImageLayout], tell: Callable[[ImageLayout], object]) -> str:
    return ", ".join(f"SM{sm} {tell(layout)}" for sm, layout in sorted(layouts.items())) or "none"
