"""DC timing as a drawing: pulses where ESI-FACTS section 11 puts them, and words where nothing is known.

A time t lies at 14 + 372 t / window; the window is three bus cycles, or two periods of the slowest signal.
"""

import re

import pytest
from lxml import html
from test_drawings import HOSTILE, SIZE_LIMIT, SVG, assert_only_drawn, drawn, groups, words

from esicatalog.esi.records.dc import OpMode
from esicatalog.web.drawings import dc_timing_svg
from esicatalog.web.drawings.dc_signals import dc_timing, time_text

MS = 1_000_000


def timing(assign_activate: int | None, time_loop_control_only: bool | None = None, **times):
    op_mode = OpMode(name="DC", assign_activate=assign_activate, **times)
    return drawn(dc_timing_svg(op_mode, time_loop_control_only=time_loop_control_only))


def lanes(root) -> list[str]:
    return [lane.get("data-signal") for lane in groups(root, "lane")]


def pulses(root, signal: str) -> list[float]:
    """Where the pulses of a signal stand."""
    (lane,) = (lane for lane in groups(root, "lane") if lane.get("data-signal") == signal)
    return [
        float(x)
        for path in lane.iter(f"{SVG}path")
        if path.get("class") == "pulse"
        for x in re.findall(r"M([\d.]+) [\d.]+v", path.get("d"))
    ]


def arrows(root) -> list[tuple[str, float, float]]:
    """The shifts: words, start, end."""
    found = []
    for lane in groups(root, "lane"):
        if lane.get("data-signal") == "shifts":
            shown = [text.text for text in lane.iter(f"{SVG}text")]
            for label, path in zip(shown, lane.iter(f"{SVG}path"), strict=True):
                start, end = re.findall(r"M([\d.]+) [\d.]+v8", path.get("d"))
                found.append((label, float(start), float(end)))
    return found


def test_sync0_follows_the_bus_cycle():
    root = timing(0x300, cycle_time_sync0_ns=0, cycle_time_sync0_factor=1)
    assert lanes(root) == ["Bus cycle", "SYNC0"]
    assert pulses(root, "Bus cycle") == [14, 138, 262, 386]
    assert pulses(root, "SYNC0") == [14, 138, 262, 386]
    assert root.get("role") == "img"
    assert root.get("aria-label") == "Timing of OpMode DC: SYNC0 every 1 ms"
    assert "SYNC0 every 1 ms, once in a bus cycle, at the reference of the cycle." in words(root)


def test_a_shift_moves_sync0():
    root = timing(0x300, cycle_time_sync0_factor=1, shift_time_sync0_ns=250_000)
    # 250 µs of 3 ms: 31 of 372.
    assert pulses(root, "SYNC0") == [45, 169, 293]
    assert arrows(root) == [("ShiftTimeSync0 250 µs", 14, 45)]
    assert "250 µs after the reference of the cycle" in words(root)


def test_a_negative_shift_moves_it_before_the_reference():
    root = timing(0x300, cycle_time_sync0_factor=1, shift_time_sync0_ns=-250_000, shift_time_sync0_input=True)
    assert pulses(root, "SYNC0") == [107, 231, 355]
    assert arrows(root) == [("ShiftTimeSync0 −250 µs", 138, 107)]
    assert "250 µs before the input reference of the cycle" in words(root)
    assert "counts from the input reference (Input=1)" in words(root)


def test_a_fixed_time_ignores_the_bus_cycle():
    root = timing(0x300, cycle_time_sync0_ns=500_000, cycle_time_sync0_factor=7)
    # A window of 2 ms.
    assert pulses(root, "SYNC0") == [14, 107, 200, 293, 386]
    assert "fixed, whatever the bus cycle" in words(root)
    root = timing(0x300, cycle_time_sync0_ns=300_000)
    assert "does not fit a bus cycle of 1 ms and drifts" in words(root)


def test_factor_2_is_every_second_cycle():
    root = timing(0x300, cycle_time_sync0_factor=2)
    # A window of 4 ms.
    assert pulses(root, "Bus cycle") == [14, 107, 200, 293, 386]
    assert pulses(root, "SYNC0") == [14, 200, 386]


def test_oversampling_divides_the_cycle_and_sync1_comes_once():
    root = timing(0x730, cycle_time_sync0_factor=-4, cycle_time_sync1_factor=-1)
    assert pulses(root, "SYNC0") == [14, 60.5, 107, 153.5, 200, 246.5, 293, 339.5, 386]
    # Register 0x09A4 = 1 ms - 250 µs: with the last of four.
    assert pulses(root, "SYNC1") == [153.5, 339.5]
    assert arrows(root) == [("SYNC0 to SYNC1 750 µs", 14, 153.5)]
    assert "4 times in a bus cycle" in words(root)
    assert "The device controls latch 0 and 1." in words(root)


def test_a_sync1_that_cannot_come_as_often_as_described_is_told():
    """Every 3 ms with SYNC0 every 2 ms: the delay of 1 ms is over before the next SYNC0, so SYNC1 comes every 2 ms."""
    root = timing(0x700, cycle_time_sync0_factor=2, cycle_time_sync1_factor=-3)
    assert "SYNC1 every 2 ms, 1 ms after the SYNC0 that starts its delay. It is described every 3 ms" in words(root)
    assert "It is described" not in words(timing(0x700, cycle_time_sync0_factor=2, cycle_time_sync1_factor=2))


def test_sync1_with_the_period_of_sync0_is_only_shifted():
    both = {"cycle_time_sync0_factor": 1, "cycle_time_sync1_factor": 1}
    root = timing(0x700, **both)
    assert pulses(root, "SYNC1") == pulses(root, "SYNC0") == [14, 138, 262, 386]
    assert lanes(root) == ["Bus cycle", "SYNC0", "SYNC1"]
    assert "SYNC1 every 1 ms, together with SYNC0." in words(root)
    root = timing(0x700, **both, shift_time_sync0_ns=250_000, shift_time_sync1_ns=500_000)
    assert pulses(root, "SYNC1") == [107, 231, 355]
    assert arrows(root) == [("ShiftTimeSync0 250 µs", 14, 45), ("SYNC0 to SYNC1 500 µs", 45, 107)]


def test_sync1_of_two_sync0_cycles():
    root = timing(0x700, cycle_time_sync0_factor=1, cycle_time_sync1_factor=2)
    # Delay 1 ms, a window of 4 ms: it comes with every second SYNC0.
    assert pulses(root, "SYNC0") == [14, 107, 200, 293, 386]
    assert pulses(root, "SYNC1") == [107, 293]


def test_sync1_alone_draws_no_sync0():
    root = timing(0x500, cycle_time_sync0_factor=1, cycle_time_sync1_factor=1, shift_time_sync1_ns=250_000)
    assert lanes(root) == ["Bus cycle", "SYNC1", "shifts"]
    assert pulses(root, "SYNC1") == [45, 169, 293]
    assert "SYNC0 itself gives no pulse" in words(root)


@pytest.mark.parametrize("word", [0x0000, 0x0030, 0x0630])
def test_without_the_sync_unit_there_are_no_sync_signals(word):
    root = timing(word, cycle_time_sync0_factor=1, cycle_time_sync1_factor=1, shift_time_sync0_ns=1000)
    assert lanes(root) == ["Bus cycle", "SyncManager event"]
    assert f"AssignActivate 0x{word:04X}: no SYNC signals." in words(root)
    assert "free" in words(root)
    assert lanes(drawn(dc_timing_svg(None))) == ["Bus cycle", "SyncManager event"]


def test_an_active_unit_without_pulses_draws_none():
    root = timing(0x100, cycle_time_sync0_factor=1)
    assert lanes(root) == ["Bus cycle"]
    assert "gives no pulses" in words(root)


@pytest.mark.parametrize("word", [0x0100, 0x0300, 0x0320, 0x0730])
def test_a_device_that_uses_the_time_only_generates_no_signal(word):
    """Dc/@TimeLoopControlOnly: no SYNC and no LATCH signal, whatever AssignActivate asks for."""
    root = timing(
        word,
        time_loop_control_only=True,
        cycle_time_sync0_factor=1,
        cycle_time_sync1_factor=1,
        shift_time_sync0_ns=5000,
        shift_time_sync0_input_delay_ns=3000,
    )
    assert lanes(root) == ["Bus cycle"]
    assert root.get("aria-label") == "Timing of OpMode DC: no SYNC signals"
    said = words(root)
    assert "TimeLoopControlOnly: the device uses the DC time and no SYNC or LATCH signal" in said
    assert f"whatever AssignActivate 0x{word:04X} asks for." in said
    assert not any(text in said for text in ("pulses", "after SYNC0", "latch 0", "latch 1"))


def test_an_op_mode_without_clocks_runs_free_whatever_the_device_needs_the_time_for():
    assert lanes(timing(0x0000, time_loop_control_only=True)) == ["Bus cycle", "SyncManager event"]


def test_what_is_not_known_is_said():
    root = timing(None)
    assert lanes(root) == ["Bus cycle"]
    assert "AssignActivate is not given" in words(root)
    root = timing(0x700, cycle_time_sync0_ns=0, cycle_time_sync1_factor=1, shift_time_sync0_ns=5000)
    assert (pulses(root, "SYNC0"), pulses(root, "SYNC1"), arrows(root)) == ([], [], [])
    assert "CycleTimeSync0 gives neither a time nor a Factor: period unknown." in words(root)
    root = timing(0x700, cycle_time_sync0_factor=1, cycle_time_sync1_ns=0)
    assert (pulses(root, "SYNC0"), pulses(root, "SYNC1")) == ([14, 138, 262, 386], [])
    assert "CycleTimeSync1 gives neither a time nor a Factor: period unknown." in words(root)


def test_a_cycle_that_cannot_be_divided_draws_no_signal():
    root = timing(0x730, cycle_time_sync0_factor=-3, cycle_time_sync1_factor=-1)
    assert lanes(root) == ["Bus cycle"]
    assert "divides the bus cycle by 3" in words(root)
    divided = OpMode(assign_activate=0x730, cycle_time_sync0_factor=-3, cycle_time_sync1_factor=-1)
    assert [(signal.name, signal.period_ns) for signal in dc_timing(divided, 3 * MS, None).signals] == [
        ("SYNC0", MS), ("SYNC1", 3 * MS),
    ]  # fmt: skip


def test_many_pulses_are_a_band():
    root = timing(0x730, cycle_time_sync0_factor=-1000, cycle_time_sync1_factor=-1)
    assert pulses(root, "SYNC0") == []
    assert "too close to draw" in words(root)
    assert len(pulses(root, "SYNC1")) == 2
    root = timing(0x300, cycle_time_sync0_ns=2_000 * MS)
    assert pulses(root, "Bus cycle") == []
    assert pulses(root, "SYNC0") == [14, 200, 386]


def test_a_shift_longer_than_the_drawing_is_only_said():
    root = timing(0x300, cycle_time_sync0_factor=1, shift_time_sync0_ns=20 * MS + 250_000)
    assert pulses(root, "SYNC0") == [45, 169, 293]
    assert arrows(root) == []
    assert "20.25 ms after the reference" in words(root)


def test_other_facts_are_said():
    root = timing(0x301, cycle_time_sync0_factor=1, shift_time_sync0_output_delay_ns=500, activate_additional=1)
    assert "Outputs 500 ns after SYNC0 (OutputDelayTime)." in words(root)
    assert "The device itself controls the SYNC unit" in words(root)
    assert "SYNC2 and SYNC3 are described and not drawn." in words(root)


@pytest.mark.parametrize("name", [*HOSTILE, "n" * 200_000])
def test_hostile_names_are_text(name):
    for factor in (1, -3):
        svg = dc_timing_svg(OpMode(name=name, assign_activate=0x300, cycle_time_sync0_factor=factor))
        assert_only_drawn(html.fragment_fromstring(svg))
        assert drawn(svg).get("aria-label").startswith(f"Timing of OpMode {name[:1]}")
        assert len(svg.encode()) < SIZE_LIMIT


@pytest.mark.parametrize(
    ("time_ns", "said"),
    [
        (0, "0 ns"), (999, "999 ns"), (1000, "1 µs"), (62_500, "62.5 µs"), (-20_000, "−20 µs"),
        (1_000_001, "1.000001 ms"), (2_000_200_000, "2.0002 s"),
    ],
)  # fmt: skip
def test_times_are_written_exactly(time_ns, said):
    assert time_text(time_ns) == said
