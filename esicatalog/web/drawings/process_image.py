"""The process image of a SyncManager as a drawing: a row for each byte, bit 7 on the left, bit 0 on the right."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.records.common import display_text
from esicatalog.model.pdo_facts import entry_facts, has_object, subindex_words
from esicatalog.model.process_image import PlacedEntry, PlacedPdo, SmImage, byte_bit
from esicatalog.model.values import byte_length
from esicatalog.web.drawings.style import PDO_COLOURS
from esicatalog.web.drawings.svg import (
    WIDTH,
    clipped,
    drawing,
    element,
    escaped,
    first_that_fits,
    number,
    paragraphs,
    rectangle,
    text,
    title,
)
from esicatalog.words import counted, index_words

MOST_ROWS = 64
MOST_ENTRIES = 256
"""What one drawing holds; it says in words what it leaves out."""

_LEFT, _BIT = 36, 45
_RIGHT = _LEFT + 8 * _BIT
_TOP, _ROW, _TEXT_LINE = 20, 20, 14
_WHOLE_BYTES = 4
"""An entry of more whole bytes is drawn with its first and last byte and one row for those between."""


class _Drawn(NamedTuple):
    """An entry with what the drawing needs to know of it."""

    first_bit: int
    end_bit: int
    placed: PlacedEntry
    pdo: PlacedPdo
    colour: int
    sample: int
    """1 for the first, 2 for the second sample of an oversampled PDO."""


class _Box(NamedTuple):
    x: float
    y: float
    width: float
    height: float


class _Rows:
    """Which row a byte lies in: one row each, but the inner bytes of a long entry share one."""

    def __init__(self, entries: Iterable[_Drawn] = ()) -> None:
        self._folds: list[tuple[int, int]] = []
        self._end_byte = 0
        for entry in entries:
            self.add(entry)

    def add(self, entry: _Drawn) -> None:
        """Make room for an entry."""
        first, end = byte_length(entry.first_bit), entry.end_bit // 8
        if end - first > _WHOLE_BYTES:
            self._folds.append((first + 1, end - 2))
        self._end_byte = max(self._end_byte, byte_length(entry.end_bit))

    def row(self, byte: int) -> int:
        """Row of a byte."""
        return byte - sum(min(byte, last) - first for first, last in self._folds if byte > first)

    def labels(self) -> Iterator[str]:
        """What stands before each row: the byte's offset, or dots for several bytes."""
        folds = dict(self._folds)
        byte = 0
        while byte < self._end_byte:
            yield "⋮" if byte in folds else str(byte)
            byte = folds.get(byte, byte) + 1

    def __len__(self) -> int:
        return self.row(self._end_byte)


def process_image_svg(image: SmImage) -> str:
    """The process image of one SyncManager as SVG, one ``g.entry`` for each entry, paddings marked ``gap``.

    Coloured by PDO (classes ``pdo-0`` …, as in :func:`process_image_legend`); needs ``DRAWING_CSS`` in the page.
    An image of more than MOST_ROWS rows or MOST_ENTRIES entries, or of unknown length, is drawn in part and says so.
    """
    entries = list(_entries(image))
    if not entries:
        words, height = paragraphs(0, [_nothing_drawn(image)])
        return drawing("process-image", image_label(image), height + 4, *words)
    shown = _that_fit(entries)
    rows = _Rows(shown)
    groups = [_group(entry, rows) for entry in shown]
    below, height = _left_out(image, entries[len(shown) :], _TOP + _ROW * len(rows))
    if not image.has_known_size:
        words, height = paragraphs(height + 8, ["Not drawn: what follows, whose place is not known."])
        below += words
    return drawing("process-image", image_label(image), height + 4, *_axes(rows), *groups, *below)


def _nothing_drawn(image: SmImage) -> str:
    if not image.pdos:
        return "No PDO is assigned."
    return (
        "Not drawn: no entry has a known place."
        if any(pdo.entries for pdo in image.pdos)
        else "The PDOs have no entries."
    )


def image_label(image: SmImage) -> str:
    """What the drawing shows, in words: "Outputs, SM2: 12 bytes, 5 entries"."""
    gaps = sum(entry_facts(placed.entry).is_padding for pdo in image.pdos for placed in pdo.entries)
    total = sum(len(pdo.entries) for pdo in image.pdos)
    facts = [image.byte_words, counted(total - gaps, "entry", "entries")]
    if gaps:
        facts.append(counted(gaps, "gap"))
    usage = f"{clipped(image.usage_words)}, " if image.usage else ""
    return f"{usage}SM{image.sm}: {', '.join(facts)}"


def process_image_legend(image: SmImage) -> str:
    """The PDOs of a process image with their colours, as an HTML list."""
    items = []
    for at, placed in enumerate(image.pdos):
        swatch = element("span", "", class_=f"swatch pdo-{at % PDO_COLOURS}")
        items.append(element("li", swatch, escaped(_pdo_words(placed))))
    return element("ul", *items, class_="drawing-legend") if items else ""


def _entries(image: SmImage) -> Iterator[_Drawn]:
    for at, pdo in enumerate(image.pdos):
        described = max(len(pdo.pdo.entries), 1)
        for position, placed in enumerate(pdo.entries):
            length = max(placed.entry.bit_length or 0, 0)
            first = placed.bit_offset
            if first is not None:
                sample = pdo.sample or position // described + 1
                yield _Drawn(first, first + length, placed, pdo, at % PDO_COLOURS, sample)


def _that_fit(entries: list[_Drawn]) -> list[_Drawn]:
    rows = _Rows()
    for at, entry in enumerate(entries[:MOST_ENTRIES]):
        rows.add(entry)
        if len(rows) > MOST_ROWS:
            return entries[:at]
    return entries[:MOST_ENTRIES]


def _axes(rows: _Rows) -> Iterator[str]:
    yield text(_LEFT - 6, _TOP - 6, "byte", "axis offset")
    for bit in range(8):
        words = "bit 7" if bit == 7 else str(bit)
        yield text(_LEFT + (7.5 - bit) * _BIT, _TOP - 6, words, "axis label")
    for row, words in enumerate(rows.labels()):
        yield text(_LEFT - 6, _TOP + _ROW * row + _ROW / 2 + 4, words, "axis offset")


def _group(drawn: _Drawn, rows: _Rows) -> str:
    gap = entry_facts(drawn.placed.entry).is_padding
    boxes = _boxes(drawn, rows)
    parts = [title(*_title_lines(drawn)), element("path", d=_outline(drawn, rows))]
    if gap:
        parts += [_hatch(box) for box in boxes]
    elif boxes:
        parts += _label(drawn, max(boxes, key=lambda box: box.width * box.height))
    return element(
        "g",
        *parts,
        class_=f"entry gap pdo-{drawn.colour}" if gap else f"entry pdo-{drawn.colour}",
        data_entry=_address(drawn),
    )


def _boxes(drawn: _Drawn, rows: _Rows) -> list[_Box]:
    """The rectangles that an entry consists of: the rest of its first byte, whole bytes, the start of its last."""
    boxes = []
    start = drawn.first_bit
    while start < drawn.end_bit:
        if start % 8 == 0 and drawn.end_bit - start >= 8:
            end = drawn.end_bit // 8 * 8
        else:
            end = min(drawn.end_bit, (start // 8 + 1) * 8)
        first, last = rows.row(start // 8), rows.row((end - 1) // 8)
        width = 8 if end - start >= 8 else end - start
        right = _RIGHT - start % 8 * _BIT
        boxes.append(_Box(right - width * _BIT, _TOP + first * _ROW, width * _BIT, (last - first + 1) * _ROW))
        start = end
    return boxes


def _outline(drawn: _Drawn, rows: _Rows) -> str:
    """One closed line around all bits of an entry; for an entry of no bits a mark at its place."""
    first_row = rows.row(drawn.first_bit // 8)
    top = _TOP + _ROW * first_row
    right = _RIGHT - drawn.first_bit % 8 * _BIT
    if drawn.end_bit == drawn.first_bit:
        return f"M{right} {min(top, _TOP + _ROW * (len(rows) - 1))}v{_ROW}"
    last_row = rows.row((drawn.end_bit - 1) // 8)
    left = _RIGHT - ((drawn.end_bit - 1) % 8 + 1) * _BIT
    if last_row == first_row:
        return f"M{left} {top}H{right}v{_ROW}H{left}z"
    bottom = _TOP + _ROW * last_row
    return f"M{_LEFT} {top}H{right}v{_ROW}H{_RIGHT}V{bottom + _ROW}H{left}V{bottom}H{_LEFT}z"


def _hatch(box: _Box) -> str:
    """Stripes over a rectangle: one dashed line as thick as it is high."""
    line = f"M{number(box.x + 2)} {number(box.y + box.height / 2)}h{number(box.width - 3)}"
    return element("path", d=line, class_="hatch", stroke_width=box.height - 2)


def _label(drawn: _Drawn, box: _Box) -> list[str]:
    entry = drawn.placed.entry
    address, name = _address(drawn), clipped(display_text(entry.names) or "")
    details = f"{address} {clipped(entry.data_type)}" if entry.data_type else address
    choices: Sequence[Sequence[str]] = (
        ((name, details), (name, address), (f"{name} {address}",), (name,)) if name else ((details,),)
    )
    lines = first_that_fits(
        [*choices, (address,), (f":{address.rpartition(':')[2]}",)], box.width - 6, box.height - 2, _TEXT_LINE
    )
    top = box.y + (box.height - _TEXT_LINE * len(lines)) / 2 + 11
    return [text(box.x + box.width / 2, top + _TEXT_LINE * at, line, "label") for at, line in enumerate(lines)]


def _address(drawn: _Drawn) -> str:
    entry = drawn.placed.entry
    return f"{index_words(entry.entry_index)}:{subindex_words(entry.subindex or 0 if has_object(entry) else None)}"


def _title_lines(drawn: _Drawn) -> list[str]:
    entry = drawn.placed.entry
    where = f"{counted(drawn.end_bit - drawn.first_bit, 'bit')} at {byte_bit(drawn.first_bit)}"
    if entry_facts(entry).is_padding:
        return [f"Gap, {where}", f"PDO {_pdo_words(drawn.pdo)}"]
    lines = [f"{_address(drawn)} {clipped(display_text(entry.names) or '')}".rstrip()]
    lines.append(f"{clipped(entry.data_type)}, {where}" if entry.data_type else where)
    if drawn.pdo.repeat > 1:
        lines.append(f"sample {drawn.sample} of {drawn.pdo.repeat}")
    return [*lines, f"PDO {_pdo_words(drawn.pdo)}"]


def _pdo_words(placed: PlacedPdo) -> str:
    words = f"{index_words(placed.pdo.pdo_index)} {clipped(display_text(placed.pdo.names) or '')}".rstrip()
    if placed.position is None and not placed.sample:
        words += " (fills up a group of modules)"
    return words if placed.slot_number is None else f"{words} (slot {placed.slot_number})"


def _left_out(image: SmImage, rest: Sequence[_Drawn], bottom: float) -> tuple[list[str], float]:
    """A box in place of entries that are not drawn, with words about them."""
    if not rest:
        return [], bottom
    pdos = dict.fromkeys(index_words(drawn.pdo.pdo.pdo_index) for drawn in rest)
    named = ", ".join(list(pdos)[:8]) + (" and more" if len(pdos) > 8 else "")
    words = (
        f"Not drawn: {counted(len(rest), 'more entry', 'more entries')} from {byte_bit(rest[0].first_bit)} to the end "
        f"of the {image.described_bytes} bytes, PDO {named}."
    )
    lines, end = paragraphs(bottom + 8, [words])
    frame = rectangle(1, bottom + 4, WIDTH - 2, end - bottom + 4, "left-out")
    return [frame, *lines], end + 8
