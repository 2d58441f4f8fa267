"""The process image as a drawing: every entry where its bits are, hostile names as text, nothing too large."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree, html
from snippets import device, esi, pdo, read
from test_drive_modes import all_devices

from esicatalog.esi.records.common import Name
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.model.process_image import PlacedEntry, PlacedPdo, SmImage, default_process_image
from esicatalog.model.sm_facts import OUTPUT
from esicatalog.web.drawings import (
    DRAWING_CSS,
    dc_timing_svg,
    memory_map_svg,
    process_image_legend,
    process_image_svg,
)
from esicatalog.web.drawings.svg import escaped, text_width

SVG = "{http://www.w3.org/2000/svg}"
SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"
HOSTILE = ["<script>alert(1)</script>", '"onmouseover="alert(1)', "']]><b>&amp;", "a\x00b\ufffe"]
SIZE_LIMIT = 150_000


def drawn(svg: str):
    """The drawing as a tree; it must be well-formed."""
    return etree.fromstring(svg.encode())


def groups(root, name: str) -> list:
    return [group for group in root.iter(f"{SVG}g") if name in group.get("class").split()]


def words(root) -> str:
    """All sentences of a drawing in one line."""
    return " ".join(text.text for text in root.iter(f"{SVG}text"))


def entry(bits: int | None, name: str = "e", index: int = 0x7000, subindex: int | None = 1, data_type=None) -> Entry:
    return Entry(entry_index=index, subindex=subindex, bit_length=bits, names=(Name(text=name),), data_type=data_type)


def image(*pdos: list[Entry], usage: str | None = "Outputs", repeat: int = 1) -> SmImage:
    """A process image of PDOs 0x1600, 0x1601 …, one behind the other."""
    placed, offset = [], 0
    for at, entries in enumerate(pdos):
        of_pdo = []
        for item in entries * repeat:
            of_pdo.append(PlacedEntry(offset, item))
            offset += item.bit_length or 0
        described = Pdo(pdo_index=0x1600 + at, names=(Name(text=f"P{at}"),), entries=tuple(entries))
        placed.append(PlacedPdo("RxPdo", at, described, repeat, None, None, tuple(of_pdo)))
    return SmImage(2, usage, OUTPUT, tuple(placed), offset, ())


def corners(group) -> list[tuple[float, float]]:
    """Corners of the outline of an entry."""
    x = y = 0.0
    found = []
    outline = group.find(f"{SVG}path").get("d")
    for command, numbers in re.findall(r"([MHVvz])([-\d. ]*)", outline):
        values = [float(number) for number in numbers.split()]
        match command:
            case "M":
                x, y = values
            case "H":
                (x,) = values
            case "V":
                (y,) = values
            case "v":
                y += values[0]
        if command != "z":
            found.append((x, y))
    return found


def area(outline: list[tuple[float, float]]) -> float:
    following = [*outline[1:], outline[0]]
    return abs(sum(x * v - u * y for (x, y), (u, v) in zip(outline, following, strict=True))) / 2


def contains(outline: list[tuple[float, float]], x: float, y: float) -> bool:
    inside = False
    for (x1, y1), (x2, y2) in zip(outline, [*outline[1:], outline[0]], strict=True):
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
            inside = not inside
    return inside


def test_entries_lie_where_their_bits_are():
    # Columns are 45 wide from 36 (bit 7) to 396; rows are 20 high from 20.
    word, flag, gap, crossing = entry(16), entry(1), entry(7, index=0), entry(12)
    root = drawn(process_image_svg(image([word, flag, gap], [entry(4), crossing])))
    found = [corners(group) for group in groups(root, "entry")]
    assert set(found[0]) == {(36, 20), (396, 20), (396, 60), (36, 60), (396, 40), (36, 40)}
    assert set(found[1]) == {(351, 60), (396, 60), (396, 80), (351, 80)}
    assert set(found[2]) == {(36, 60), (351, 60), (351, 80), (36, 80)}
    assert set(found[3]) == {(216, 80), (396, 80), (396, 100), (216, 100)}
    # Bits 4 to 7 of byte 3, and the whole of byte 4.
    assert area(found[4]) == 12 * 45 * 20
    assert contains(found[4], 40, 90)
    assert not contains(found[4], 220, 90)
    assert contains(found[4], 390, 110)
    assert root.get("viewBox").split()[2] == "400"
    assert [text.text for text in root.iter(f"{SVG}text") if "offset" in text.get("class")] == [
        "byte", "0", "1", "2", "3", "4",
    ]  # fmt: skip


@given(st.lists(st.integers(1, 32), min_size=1, max_size=12))
def test_every_bit_belongs_to_its_entry(lengths):
    root = drawn(process_image_svg(image([entry(bits) for bits in lengths])))
    first = 0
    for bits, group in zip(lengths, groups(root, "entry"), strict=True):
        outline = corners(group)
        assert area(outline) == bits * 45 * 20
        for bit in (first, first + bits // 2, first + bits - 1):
            assert contains(outline, 396 - 45 * (bit % 8) - 22, 20 + 20 * (bit // 8) + 9)
        first += bits


def test_entries_are_named_counted_and_coloured():
    gap = entry(7, index=0)
    image_of_two = image([entry(16, "Controlword", 0x6040, 0, "UINT"), entry(1, subindex=None), gap], [entry(8)])
    root = drawn(process_image_svg(image_of_two))
    assert root.get("role") == "img"
    assert root.get("aria-label") == "Outputs, SM2: 4 bytes, 3 entries, 1 gap"
    found = groups(root, "entry")
    assert [group.get("data-entry") for group in found] == ["0x6040:00", "0x7000:00", "0x0000:01", "0x7000:01"]
    assert [group.get("class") for group in found] == ["entry pdo-0", "entry pdo-0", "entry gap pdo-0", "entry pdo-1"]
    assert found[0].find(f"{SVG}title").text == "0x6040:00 Controlword\nUINT, 16 bits at 0.0\nPDO 0x1600 P0"
    assert found[2].find(f"{SVG}title").text == "Gap, 7 bits at 2.1\nPDO 0x1600 P0"
    assert [path.get("class") for path in found[2].iter(f"{SVG}path")] == [None, "hatch"]
    (legend,) = html.fragments_fromstring(process_image_legend(image_of_two))
    assert [item.text_content() for item in legend] == ["0x1600 P0", "0x1601 P1"]
    assert [item[0].get("class") for item in legend] == ["swatch pdo-0", "swatch pdo-1"]


def test_colours_begin_again_after_eight_pdos():
    root = drawn(process_image_svg(image(*[[entry(1)] for _ in range(9)])))
    assert [group.get("class") for group in groups(root, "entry")][-2:] == ["entry pdo-7", "entry pdo-0"]


def test_samples_are_numbered():
    root = drawn(process_image_svg(image([entry(8), entry(8)], repeat=3)))
    samples = [group.find(f"{SVG}title").text.splitlines()[2] for group in groups(root, "entry")]
    assert samples == [f"sample {n} of 3" for n in (1, 1, 2, 2, 3, 3)]


def test_samples_in_pdos_of_their_own_are_numbered():
    found = image([entry(8)], [entry(8)])
    pdos = tuple(
        placed._replace(repeat=2, sample=n, position=position)
        for n, (placed, position) in enumerate(zip(found.pdos, (0, None), strict=True), 1)
    )
    root = drawn(process_image_svg(found._replace(pdos=pdos)))
    titles = [group.find(f"{SVG}title").text.splitlines()[2:] for group in groups(root, "entry")]
    assert titles == [["sample 1 of 2", "PDO 0x1600 P0"], ["sample 2 of 2", "PDO 0x1601 P1"]]


def test_an_entry_of_no_bits_is_a_mark():
    first, second = groups(drawn(process_image_svg(image([entry(8), entry(None)]))), "entry")
    assert second.find(f"{SVG}path").get("d") == "M396 20v20"
    assert first.find(f"{SVG}path").get("d").endswith("z")


def test_an_empty_image_says_so():
    assert words(drawn(process_image_svg(image()))) == "No PDO is assigned."
    assert words(drawn(process_image_svg(image([])))) == "The PDOs have no entries."
    assert drawn(process_image_svg(image(usage=None))).get("aria-label") == "SM2: 0 bytes, 0 entries"
    assert process_image_legend(image()) == ""


def test_what_has_no_known_place_is_not_drawn():
    first = '<RxPdo Sm="2"><Index>#x1600</Index><Name>R</Name></RxPdo>'
    second = pdo("RxPdo", "#x1601", 16, attributes='Sm="2"')
    for content, drawn_entries, said in (
        (first + second, 0, "Not drawn: no entry has a known place."),
        (second + first, 1, "Not drawn: what follows, whose place is not known."),
    ):
        owner = read(esi(device(SMS + content))).document.infos[0].devices[0]
        found = next(image for image in default_process_image(owner, ()) if image.sm == 2)
        root = drawn(process_image_svg(found))
        assert (len(groups(root, "entry")), said in words(root)) == (drawn_entries, True)
        assert root.get("aria-label") == "Outputs, SM2: at least 2 bytes, 1 entry"


def test_the_inner_bytes_of_a_long_entry_share_a_row():
    root = drawn(process_image_svg(image([entry(4), entry(4), entry(8 * 1500), entry(8)])))
    assert [text.text for text in root.iter(f"{SVG}text") if "offset" in text.get("class")] == [
        "byte", "0", "1", "⋮", "1500", "1501",
    ]  # fmt: skip
    long = corners(groups(root, "entry")[2])
    assert (min(y for _, y in long), max(y for _, y in long)) == (40, 100)


def test_four_bytes_keep_their_rows():
    root = drawn(process_image_svg(image([entry(32)])))
    assert max(y for _, y in corners(groups(root, "entry")[0])) == 100


def test_what_is_left_out_is_said():
    root = drawn(process_image_svg(image([entry(8)] * 60, [entry(8)] * 196)))
    assert len(groups(root, "entry")) == 64
    assert "Not drawn: 192 more entries from 64.0 to the end of the 256 bytes, PDO 0x1601." in words(root)
    assert root.get("aria-label") == "Outputs, SM2: 256 bytes, 256 entries"


def test_the_largest_drawing_is_small_enough():
    long_names = [entry(1, "n" * 5000, data_type="T" * 5000) for _ in range(1500 * 8)]
    svg = process_image_svg(image(long_names))
    assert len(groups(drawn(svg), "entry")) == 256
    assert "Not drawn: 11744 more entries from 32.0" in words(drawn(svg))
    assert len(svg.encode()) < SIZE_LIMIT


def test_labels_stand_only_where_they_fit():
    name = "Velocity actual value of axis 1"
    root = drawn(process_image_svg(image([entry(bits, name) for bits in (1, 2, 5, 8, 32, 16)])))
    labels = [[text.text for text in group.iter(f"{SVG}text")] for group in groups(root, "entry")]
    assert labels == [
        [":01"],
        ["0x7000:01"],
        [name],
        [f"{name} 0x7000:01"],
        [name, "0x7000:01"],
        [name, "0x7000:01"],
    ]


def test_wide_characters_need_more_room():
    assert text_width("速度") > text_width("ab")
    root = drawn(process_image_svg(image([entry(1, "速度実際値")])))
    assert [text.text for text in groups(root, "entry")[0].iter(f"{SVG}text")] == [":01"]


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_are_text(name):
    pdo_of_it = Pdo(pdo_index=0x1600, names=(Name(text=name),))
    placed = PlacedPdo("RxPdo", 0, pdo_of_it, 1, 3, None, (PlacedEntry(0, entry(64, name, data_type=name)),))
    svg = process_image_svg(SmImage(2, name, OUTPUT, (placed,), 64, ()))
    root = drawn(svg)
    shown = name.replace("\x00", "\ufffd").replace("\ufffe", "\ufffd")
    title = groups(root, "entry")[0].find(f"{SVG}title").text
    assert title == f"0x7000:01 {shown}\n{shown}, 64 bits at 0.0\nPDO 0x1600 {shown} (slot 3)"
    assert root.get("aria-label").startswith(f"{shown}, SM2")
    assert_only_drawn(html.fragment_fromstring(svg))
    legend = html.fragment_fromstring(process_image_legend(SmImage(2, name, OUTPUT, (placed,), 64, ())))
    assert_only_drawn(legend)
    assert legend.text_content() == f"0x1600 {shown} (slot 3)"


def assert_only_drawn(tree) -> None:
    """Only our own elements and attributes."""
    allowed = {"svg", "g", "path", "rect", "text", "title", "ul", "li", "span"}
    assert {element.tag for element in tree.iter()} <= allowed
    assert not [name for element in tree.iter() for name in element.attrib if name.startswith("on")]


def test_escaping_leaves_nothing_but_text():
    assert escaped("<a b=\"c\" d='e'>&\x07") == "&lt;a b=&quot;c&quot; d=&#x27;e&#x27;&gt;&amp;\ufffd"


def luminance(colour: str) -> float:
    """Relative luminance of #rrggbb (WCAG 2)."""
    channels = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    lighter, darker = sorted((luminance(one), luminance(other)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


@pytest.mark.parametrize("scheme", [0, 1])
def test_text_is_readable_on_every_colour(scheme):
    light, dark = DRAWING_CSS.split("@media (prefers-color-scheme:dark)")
    colours = dict(re.findall(r"--drawing-([\w-]+):(#\w{6})", (light, dark)[scheme]))
    assert len(colours) == 14
    for fill in ("background", "alarm-fill", *map(str, range(8))):
        assert contrast(colours["text"], colours[fill]) >= 7, fill
    for words_on_background in ("muted", "alarm"):
        assert contrast(colours[words_on_background], colours["background"]) >= 4.5
    for fill in ("background", *map(str, range(8))):
        assert contrast(colours["line"], colours[fill]) >= 1.5, fill


def drawings_of(device, modules) -> list[str]:
    """Every drawing of a device's page."""
    images = default_process_image(device, modules)
    modes = [
        dc_timing_svg(op_mode, time_loop_control_only=device.dc_time_loop_control_only) for op_mode in device.op_modes
    ] or [dc_timing_svg(None)]
    return [memory_map_svg(device, images), *modes, *map(process_image_svg, images)]


def check_drawings(device, modules) -> None:
    for svg in drawings_of(device, modules):
        root = drawn(svg)
        assert root.get("aria-label")
        assert_only_drawn(html.fragment_fromstring(svg))
        assert len(svg.encode()) < SIZE_LIMIT
        height = float(root.get("viewBox").split()[3])
        assert all(0 < float(text.get("y")) <= height for text in root.iter(f"{SVG}text"))
        for text in root.iter(f"{SVG}text"):
            if "label" in (text.get("class") or "").split():
                half = text_width(text.text) / 2
                assert float(text.get("x")) - half >= -1
                assert float(text.get("x")) + half <= 401
    for image in default_process_image(device, modules):
        root = drawn(process_image_svg(image))
        entries = [placed for pdo in image.pdos for placed in pdo.entries]
        found = groups(root, "entry")
        assert len(found) == len(entries) or "Not drawn" in words(root)
        gaps = [placed.entry.entry_index == 0 for placed in entries][: len(found)]
        assert ["gap" in group.get("class").split() for group in found] == gaps


def test_a_device_of_our_own_is_drawn():
    info = read(esi(device(SMS + pdo("RxPdo", "#x1600", 16, 8, attributes='Sm="2"')))).document.infos[0]
    check_drawings(info.devices[0], info.modules)


def test_real_devices_are_drawn(sample_archives, tmp_path):
    (tmp_path / "esi").mkdir()
    for archive in sample_archives:
        (tmp_path / "esi" / archive.name).symlink_to(archive)
    devices = list(all_devices(tmp_path))
    assert len(devices) > 5
    for _, found, modules in devices:
        check_drawings(found, modules)


@pytest.mark.corpus
def test_the_whole_corpus_is_drawn(corpus):
    for _, found, modules in all_devices(corpus):
        check_drawings(found, modules)
