"""The memory map as a drawing: areas at their addresses, three buffers tripled, overlaps in red and in words."""

import pytest
from lxml import html
from test_drawings import HOSTILE, SIZE_LIMIT, SVG, assert_only_drawn, drawn, groups, words

from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.model.process_image import SmImage
from esicatalog.model.sm_facts import OUTPUT
from esicatalog.web.drawings import memory_map_svg

BUFFERED_OUT, BUFFERED_IN, MAILBOX_OUT, MAILBOX_IN = 0x64, 0x20, 0x26, 0x22


def sm(usage: str | None, start: int | None, size: int | None, control: int | None, enable: int | None = 1, **others):
    return SyncManager(
        usage=usage, start_address=start, default_size=size, control_byte=control, enable=enable, **others
    )


def memory_map(*sync_managers: SyncManager, sizes: dict[int, int] | None = None):
    images = [SmImage(number, None, OUTPUT, (), size * 8, ()) for number, size in (sizes or {}).items()]
    return drawn(memory_map_svg(Device(sync_managers=sync_managers), images))


def boxes(root, number: int) -> list[tuple[float, float, float, float]]:
    """Rectangles of a SyncManager: x, y, width, height."""
    (group,) = (group for group in groups(root, "sm") if group.get("data-sm") == str(number))
    return [tuple(float(box.get(name)) for name in ("x", "y", "width", "height")) for box in group.iter(f"{SVG}rect")]


def overlaps(root) -> list[tuple[str, float, float]]:
    """SyncManager, y and height of everything red."""
    return [
        (group.get("data-sm"), float(box.get("y")), float(box.get("height")))
        for group in groups(root, "overlap")
        for box in group.iter(f"{SVG}rect")
    ]


def title(root, number: int) -> str:
    (group,) = (group for group in groups(root, "sm") if group.get("data-sm") == str(number))
    return group.find(f"{SVG}title").text


def addresses(root) -> list[str]:
    return [text.text for text in root.iter(f"{SVG}text") if "offset" in (text.get("class") or "")]


def test_areas_lie_at_their_addresses_and_three_buffers_are_three():
    root = memory_map(
        sm("MBoxOut", 0x1000, 128, MAILBOX_OUT),
        sm("MBoxIn", 0x1080, 128, MAILBOX_IN),
        sm("Outputs", 0x1100, 12, BUFFERED_OUT),
    )
    # A stretch of n bytes is 14 + 2 times the bits of n high: 30 for 128 bytes, 22 for 12.
    assert boxes(root, 0) == [(52, 8, 346, 30)]
    assert boxes(root, 1) == [(52, 38, 346, 30)]
    assert boxes(root, 2) == [(52, 68, 346, 22), (52, 90, 346, 22), (52, 112, 346, 22)]
    assert addresses(root) == ["0x1000", "0x1080", "0x1100", "0x110C", "0x1118", "0x1124"]
    assert title(root, 2) == "SM2 Outputs\n0x1100–0x1123, 3 buffers of 12 bytes\nDefaultSize 12 bytes\nbuffered mode"
    assert title(root, 0) == "SM0 MBoxOut\n0x1000–0x107F, 1 buffer of 128 bytes\nDefaultSize 128 bytes\nmailbox mode"
    assert "SM2 Outputs: 12 bytes × 3" in words(root)
    assert overlaps(root) == []
    assert root.get("role") == "img"
    assert root.get("aria-label") == "Memory map: 3 SyncManagers from 0x1000, no overlap"


def test_process_data_in_one_buffer_is_not_tripled():
    root = memory_map(sm("Inputs", 0x1000, 10, MAILBOX_IN))
    assert boxes(root, 0) == [(52, 8, 346, 22)]


def test_the_third_buffer_can_overlap():
    # Three times 100 bytes from 0x1100 end at 0x122C.
    root = memory_map(
        sm("Outputs", 0x1100, 100, BUFFERED_OUT),
        sm("Inputs", 0x1200, 4, MAILBOX_IN),
    )
    # Stretches of 100, 100, 56, 4 and 40 bytes are 28, 28, 26, 20 and 26 high.
    assert boxes(root, 0) == [(52, 8, 173, 28), (52, 36, 173, 28), (52, 64, 173, 72)]
    assert [box[1] for box in boxes(root, 1)] == [90]
    assert overlaps(root) == [("0", 90, 20), ("1", 90, 20)]
    said = "SM0 Outputs and SM1 Inputs overlap at 0x1200–0x1203 (4 bytes)."
    assert said in words(root)
    assert all(group.find(f"{SVG}title").text == said for group in groups(root, "overlap"))
    assert root.get("aria-label").endswith(", 1 overlap")


def test_areas_side_by_side_in_an_overlap_do_not_cover_each_other():
    root = memory_map(*(sm("Inputs", 0x1100 + 0x80 * at, 128, BUFFERED_IN) for at in range(3)))
    assert [boxes(root, number)[0][0] for number in range(3)] == pytest.approx(
        [52, 52 + 346 / 3, 52 + 692 / 3], abs=0.01
    )
    # 0 with 1 and 2, 1 with 2; each area is red once where it shares.
    assert [number for number, _, _ in overlaps(root)] == ["0", "1", "2"]
    assert root.get("aria-label").endswith(", 3 overlaps")


def test_what_is_not_enabled_overlaps_nothing():
    root = memory_map(sm("Outputs", 0x1000, 8, BUFFERED_OUT), sm("Inputs", 0x1000, 8, BUFFERED_IN, enable=0))
    assert overlaps(root) == []
    assert "not-enabled" in groups(root, "sm")[1].get("class").split()
    assert "not enabled" in title(root, 1)


@pytest.mark.parametrize(("enable", "counts"), [(None, True), (9, True), (4, False)])
def test_only_bit_0_of_enable_counts_and_its_absence(enable, counts):
    root = memory_map(sm("Outputs", 0x1000, 8, BUFFERED_OUT), sm("Inputs", 0x1000, 8, BUFFERED_IN, enable=enable))
    assert bool(overlaps(root)) == counts


def test_the_process_image_gives_the_size_where_it_is_longer():
    root = memory_map(
        sm("Outputs", 0x1000, None, BUFFERED_OUT),
        sm("Inputs", 0x1400, 1, BUFFERED_IN),
        sm("Inputs", 0x1800, 128, BUFFERED_IN),
        sizes={0: 6, 1: 66, 2: 10},
    )
    assert "3 buffers of 6 bytes\nprocess image 6 bytes" in title(root, 0)
    assert "3 buffers of 66 bytes\nDefaultSize 1 byte, process image 66 bytes" in title(root, 1)
    assert "3 buffers of 128 bytes\nDefaultSize 128 bytes, process image 10 bytes" in title(root, 2)


def test_an_unknown_size_is_a_mark():
    root = memory_map(sm("DynamicOutputs", 0x2000, None, BUFFERED_OUT), sm("Inputs", 0x3000, 0, BUFFERED_IN))
    assert len(boxes(root, 0)) == 1
    assert "SM0 DynamicOutputs: size unknown" in words(root)
    assert title(root, 0) == "SM0 DynamicOutputs\nstarts at 0x2000, size unknown: no DefaultSize"
    assert addresses(root) == ["0x2000", "0x3000"]
    assert [box.get("class") for box in root.iter(f"{SVG}rect")] == ["no-size", "no-size"]


def test_no_bytes_are_not_an_unknown_size():
    """0 is known of DefaultSize, of an image without PDOs, and of neither where an image is open."""
    sizes, known = (0, 0, None, 0), {1: True, 2: True, 3: False}
    areas = [sm("Inputs", 0x1000 * (number + 1), size, BUFFERED_IN) for number, size in enumerate(sizes)]
    images = [SmImage(number, None, OUTPUT, (), 0, (), has_known_size=is_known) for number, is_known in known.items()]
    svg = memory_map_svg(Device(sync_managers=tuple(areas)), images)
    root = drawn(svg)
    assert [title(root, number).partition("\n")[2] for number in range(4)] == [
        "starts at 0x1000, 0 bytes: DefaultSize 0 bytes",
        "starts at 0x2000, 0 bytes: DefaultSize 0 bytes",
        "starts at 0x3000, 0 bytes: process image 0 bytes",
        "starts at 0x4000, size unknown: DefaultSize 0 bytes, process image of unknown length",
    ]
    assert ["SM0 Inputs: 0 bytes" in words(root), "SM3 Inputs: size unknown" in words(root)] == [True, True]
    assert addresses(root) == ["0x1000", "0x2000", "0x3000", "0x4000"]


def test_an_unknown_mode_is_drawn_once_and_said():
    for control in (None, 0x21):
        root = memory_map(sm("Inputs", 0x1000, 4, control))
        assert len(boxes(root, 0)) == 1
        assert "does not tell buffered from mailbox" in title(root, 0)


def test_what_is_not_memory_is_named_and_not_drawn():
    root = memory_map(
        sm("Outputs", 0x0F00, 1, BUFFERED_OUT),
        sm("Inputs", None, 1, BUFFERED_IN),
        sm("Inputs", 0x1000, 1, BUFFERED_IN, virtual=True),
        sm("Inputs", 0xFFFF, 1, BUFFERED_IN),
    )
    assert groups(root, "sm") == []
    assert words(root) == (
        "SM0 Outputs at 0x0F00 lies in the registers: not drawn. SM1 Inputs has no StartAddress: not drawn. "
        "SM2 Inputs is virtual: not drawn. SM3 Inputs at 0xFFFF leaves the address space of 64 KiB: not drawn."
    )
    assert words(memory_map()) == "The device has no SyncManagers."


def test_more_sync_managers_than_registers_are_not_drawn():
    root = memory_map(*(sm("Inputs", 0x1000, 100, BUFFERED_IN) for _ in range(1000)))
    assert len(groups(root, "sm")) == 16
    assert "Only the first 16 of 1000 SyncManagers are drawn." in words(root)


@pytest.mark.parametrize("usage", [*HOSTILE, "u" * 100_000])
def test_hostile_usages_are_text(usage):
    sync_managers = tuple(sm(usage, 0x1000, 8, BUFFERED_IN) for _ in range(16))
    svg = memory_map_svg(Device(sync_managers=sync_managers), [])
    assert_only_drawn(html.fragment_fromstring(svg))
    assert title(drawn(svg), 0).startswith(f"SM0 {usage[:1]}")
    assert len(svg.encode()) < SIZE_LIMIT
