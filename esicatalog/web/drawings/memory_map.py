"""The areas of the SyncManagers in the memory of the slave controller as a drawing (ESI-FACTS section 8).

A buffered SyncManager takes three buffers of its length, a mailbox one. Addresses run downwards; heights grow with
the logarithm of the sizes, so that one byte and a kilobyte both can be read.
"""

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import NamedTuple

from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.model.areas import Area
from esicatalog.model.process_image import SmImage
from esicatalog.model.sm_facts import INPUT, OUTPUT, SmFacts, is_mailbox, sm_facts
from esicatalog.model.sm_memory import MEMORY_START, buffer_count, is_enabled, occupied_area
from esicatalog.web.drawings.svg import (
    WIDTH,
    clipped,
    drawing,
    element,
    first_that_fits,
    paragraphs,
    rectangle,
    text,
    title,
)
from esicatalog.words import counted, index_words

MOST_SYNC_MANAGERS = 16
"""So many have registers, 0x0800 to 0x087F."""

_MEMORY_END = 0x10000
_COLOURS = {OUTPUT: "pdo-0", INPUT: "pdo-2"}
_LEFT, _RIGHT, _TOP = 52, WIDTH - 2, 8
_LINE = 14


class _Area(NamedTuple):
    """What one SyncManager takes; ``size`` is that of a buffer, None where the description leaves it open."""

    sm: int
    name: str
    start: int
    size: int | None
    size_words: str
    facts: SmFacts
    buffers: int
    enabled: bool
    occupied: Area | None
    """The addresses that it takes from others, None without any."""
    is_mailbox: bool

    @property
    def end(self) -> int:
        """The first address behind it; one of open size, or of none, has room for a mark."""
        return self.start + (self.size or 1) * self.buffers

    @property
    def parts(self) -> list[tuple[int, int]]:
        """First address and end of each buffer."""
        size = self.size or 1
        return [(self.start + size * at, self.start + size * (at + 1)) for at in range(self.buffers)]


class _Overlap(NamedTuple):
    """Addresses from ``first`` to before ``end`` that two enabled SyncManagers share."""

    sms: tuple[int, int]
    first: int
    end: int
    words: str


def memory_map_svg(device: Device, images: Sequence[SmImage]) -> str:
    """The SyncManagers' areas from 0x1000 on as SVG: a ``g.sm`` each, ``g.overlap`` where enabled ones share.

    The length is DefaultSize, or that of the process image (``images``) where it is longer or DefaultSize is absent.
    What cannot be drawn (registers, virtual SyncManagers, no address) is named below. Needs ``DRAWING_CSS``.
    """
    of_sms = {image.sm: image for image in images}
    areas: list[_Area] = []
    remarks: list[str] = []
    for number, sync_manager in enumerate(device.sync_managers[:MOST_SYNC_MANAGERS]):
        area = _area(number, sync_manager, of_sms.get(number))
        reason = _not_drawn(sync_manager, area)
        if reason:
            remarks.append(f"{area.name} {reason}: not drawn.")
        else:
            areas.append(area)
    if len(device.sync_managers) > MOST_SYNC_MANAGERS:
        remarks.append(f"Only the first {MOST_SYNC_MANAGERS} of {len(device.sync_managers)} SyncManagers are drawn.")
    overlaps = list(_overlaps(areas))
    alarms, below = paragraphs(_bottom(areas) + 4, (overlap.words for overlap in overlaps), "words alarm")
    if areas:
        remarks.insert(0, "Heights are not to scale.")
    words, below = paragraphs(below, remarks or ["The device has no SyncManagers."])
    return drawing("memory-map", _map_label(areas, overlaps), below + 6, *_picture(areas, overlaps), *alarms, *words)


def _area(number: int, sync_manager: SyncManager, image: SmImage | None) -> _Area:
    facts = sm_facts(sync_manager)
    size = _size(sync_manager.default_size, image)
    return _Area(
        number,
        f"SM{number} {clipped(sync_manager.usage or '')}".rstrip(),
        sync_manager.start_address or 0,
        size,
        _size_words(sync_manager.default_size, image),
        facts,
        buffer_count(sync_manager) if size else 1,
        is_enabled(sync_manager),
        occupied_area(number, sync_manager, size),
        is_mailbox(sync_manager),
    )


def _size(default_size: int | None, image: SmImage | None) -> int | None:
    """Bytes of a buffer: 0 only where nothing is open."""
    described = max(default_size or 0, image.described_bytes if image is not None else 0)
    is_open = default_size is None if image is None else not image.has_known_size
    return described or (None if is_open else 0)


def _size_words(default_size: int | None, image: SmImage | None) -> str:
    known = []
    if default_size is not None:
        known.append(f"DefaultSize {counted(default_size, 'byte')}")
    if image is not None and image.byte_size != default_size:
        known.append(f"process image {'of ' if not image.has_known_size else ''}{image.byte_words}")
    return ", ".join(known) or "no DefaultSize"


def _not_drawn(sync_manager: SyncManager, area: _Area) -> str | None:
    if sync_manager.virtual:
        return "is virtual"
    if sync_manager.start_address is None:
        return "has no StartAddress"
    if area.start < MEMORY_START:
        return f"at {index_words(area.start)} lies in the registers"
    if area.end > _MEMORY_END:
        return f"at {index_words(area.start)} leaves the address space of 64 KiB"
    return None


def _overlaps(areas: Sequence[_Area]) -> Iterator[_Overlap]:
    taken = [(area, area.occupied) for area in areas if area.occupied is not None]
    for (one, ours), (other, theirs) in combinations(taken, 2):
        first, end = max(ours.start, theirs.start), min(ours.end, theirs.end)
        if first < end:
            shared = f"{_span(first, end)} ({counted(end - first, 'byte')})"
            yield _Overlap((one.sm, other.sm), first, end, f"{one.name} and {other.name} overlap at {shared}.")


def _merged(overlaps: Sequence[_Overlap]) -> list[tuple[int, int]]:
    """The addresses of overlaps without any of them twice."""
    merged: list[tuple[int, int]] = []
    for overlap in sorted(overlaps, key=lambda overlap: overlap.first):
        if merged and overlap.first <= merged[-1][1]:
            merged[-1] = (merged[-1][0], max(merged[-1][1], overlap.end))
        else:
            merged.append((overlap.first, overlap.end))
    return merged


def _span(first: int, end: int) -> str:
    return f"{index_words(first)}–{index_words(end - 1)}"


def _boundaries(areas: Sequence[_Area]) -> dict[int, int]:
    """Every address where something begins or ends, and its place in the drawing."""
    addresses = sorted({address for area in areas for part in area.parts for address in part})
    places: dict[int, int] = {}
    y, before = _TOP, None
    for address in addresses:
        if before is not None:
            y += _height(address - before)
        places[address] = y
        before = address
    return places


def _height(size: int) -> int:
    return 14 + 2 * size.bit_length()


def _bottom(areas: Sequence[_Area]) -> int:
    return max(_boundaries(areas).values(), default=0) + 4


def _lanes(areas: Sequence[_Area]) -> dict[int, int]:
    """The column of each SyncManager: side by side where they overlap."""
    ends: list[int] = []
    lanes = {}
    for area in sorted(areas, key=lambda area: (area.start, area.sm)):
        lane = next((at for at, end in enumerate(ends) if end <= area.start), len(ends))
        ends[lane : lane + 1] = [area.end]
        lanes[area.sm] = lane
    return lanes


def _picture(areas: Sequence[_Area], overlaps: Sequence[_Overlap]) -> Iterator[str]:
    places, lanes = _boundaries(areas), _lanes(areas)
    yield from _axis(areas, places)
    width = (_RIGHT - _LEFT) / (max(lanes.values(), default=0) + 1)
    for area in areas:
        yield _shape(area, places, _LEFT + lanes[area.sm] * width, width)
        own = [overlap for overlap in overlaps if area.sm in overlap.sms]
        for first, end in _merged(own):
            words = [overlap.words for overlap in own if first <= overlap.first < end]
            red = rectangle(_LEFT + lanes[area.sm] * width, places[first], width, places[end] - places[first])
            yield element("g", title(*words), red, class_="overlap", data_sm=area.sm)
        yield from _labels(area, places, _LEFT + lanes[area.sm] * width, width)


def _axis(areas: Sequence[_Area], places: dict[int, int]) -> Iterator[str]:
    ends = {end for area in areas if area.size for _, end in area.parts}
    known = ends | {start for area in areas for start, _ in area.parts}
    for address, y in places.items():
        if address in known:
            yield text(_LEFT - 6, y + 4, index_words(address), "axis offset")


def _shape(area: _Area, places: dict[int, int], x: float, width: float) -> str:
    boxes = [
        rectangle(x, places[start], width, places[end] - places[start], None if area.size else "no-size")
        for start, end in area.parts
    ]
    classes = ["sm", _colour(area)]
    if not area.enabled:
        classes.append("not-enabled")
    return element("g", title(*_title_lines(area)), *boxes, class_=" ".join(classes), data_sm=area.sm)


def _colour(area: _Area) -> str:
    """Process data by direction; mailboxes, and what has no known direction, in the last colour."""
    return "pdo-7" if area.is_mailbox else _COLOURS.get(area.facts.transfer_direction or "", "pdo-7")


def _title_lines(area: _Area) -> list[str]:
    if not area.size:
        return [area.name, f"starts at {index_words(area.start)}, {_area_words(area)}: {area.size_words}"]
    buffers = f"{counted(area.buffers, 'buffer')} of {counted(area.size, 'byte')}"
    lines = [area.name, f"{_span(area.start, area.end)}, {buffers}", area.size_words]
    mode = area.facts.buffer_mode
    lines.append(f"{mode} mode" if mode else "ControlByte does not tell buffered from mailbox: drawn as one buffer")
    if not area.enabled:
        lines.append("not enabled")
    return lines


def _area_words(area: _Area) -> str:
    return counted(area.size, "byte") if area.size is not None else "size unknown"


def _labels(area: _Area, places: dict[int, int], x: float, width: float) -> Iterator[str]:
    details = (
        _area_words(area)
        + (f" × {area.buffers}" if area.buffers > 1 else "")
        + ("" if area.enabled else ", not enabled")
    )
    choices = ((f"{area.name}: {details}",), (area.name, details), (area.name,), (f"SM{area.sm}",))
    for at, (start, end) in enumerate(area.parts):
        wanted = choices if at == 0 else ((f"SM{area.sm} buffer {at + 1}",), (f"{at + 1}",))
        lines = first_that_fits(wanted, width - 6, places[end] - places[start], _LINE)
        first = (places[start] + places[end] - _LINE * (len(lines) - 1)) / 2 + 4
        yield from (text(x + width / 2, first + _LINE * n, line, "label") for n, line in enumerate(lines))


def _map_label(areas: Sequence[_Area], overlaps: Sequence[_Overlap]) -> str:
    words = f"Memory map: {counted(len(areas), 'SyncManager')}"
    if areas:
        words += f" from {index_words(min(area.start for area in areas))}"
    return f"{words}, {counted(len(overlaps), 'overlap') if overlaps else 'no overlap'}"
