"""The times of an OpMode of the distributed clocks as a drawing (ESI-FACTS section 11).

SYNC1 follows SYNC0: the slave controller starts a delay at a SYNC0 pulse, gives SYNC1 when it has passed, and starts
it again at the next SYNC0 pulse after that (Beckhoff ESC manual section I, SYNC1 generation).
"""

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from esicatalog.esi.records.dc import OpMode
from esicatalog.web.drawings.dc_signals import Shift, Signal, dc_timing, time_text
from esicatalog.web.drawings.svg import WIDTH, clipped, drawing, element, number, paragraphs, text, text_width, title

_CYCLE_NS = 1_000_000
"""The bus cycle that is drawn."""
_LEFT, _RIGHT = 14, WIDTH - 14
_TOP, _LANE, _PULSE, _SHIFT_ROW = 4, 46, 22, 28
_CLOSEST = Fraction(7, 2)
"""Pulses nearer to each other, in units of the drawing, become a band."""
_ROOM_FOR_A_TIME = 60


def dc_timing_svg(op_mode: OpMode | None, *, time_loop_control_only: bool | None = None) -> str:
    """Frames, SYNC0, SYNC1 and shifts of an OpMode over some bus cycles as SVG, a ``g.lane`` for each.

    ``op_mode`` None is a device without OpModes. Only signals that AssignActivate generates are drawn, and none for a
    device with Dc/@TimeLoopControlOnly, which is ``time_loop_control_only``; a period that the OpMode leaves open is
    said to be unknown. Needs ``DRAWING_CSS`` in the page.
    """
    timing = dc_timing(op_mode, _CYCLE_NS, time_loop_control_only)
    scale = _Scale(_window_ns(timing.signals))
    frames = Signal("Bus cycle", f"a frame every {time_text(_CYCLE_NS)}", Fraction(_CYCLE_NS))
    y, lanes = _TOP, []
    for signal in (frames, *timing.signals):
        lanes.append(_lane(signal, scale, y))
        y += _LANE
    shifts = [placed for placed in map(scale.within, timing.shifts) if placed is not None]
    if shifts:
        lanes.append(_shift_lane(shifts, scale, y))
        y += _SHIFT_ROW * len(shifts)
    words, bottom = paragraphs(y + 22, timing.sentences)
    name = f" {clipped(op_mode.name)}" if op_mode is not None and op_mode.name else ""
    label = f"Timing of OpMode{name}: {timing.summary}"
    return drawing("dc-timing", label, bottom + 6, *_grid(frames, scale, y), *lanes, *words)


class _Scale(NamedTuple):
    """Times to places; the drawing begins at time 0."""

    window_ns: Fraction

    def x(self, time: Fraction) -> float:
        """Place of a time in ns."""
        return float(_LEFT + (_RIGHT - _LEFT) * time / self.window_ns)

    def distance(self, period: Fraction) -> Fraction:
        """Distance of pulses in units of the drawing."""
        return (_RIGHT - _LEFT) * period / self.window_ns

    def within(self, shift: Shift) -> Shift | None:
        """A shift moved by whole repetitions into the drawing; None when it is longer than that."""
        start = shift.start_ns % shift.repeats_ns
        if start + shift.length_ns < 0:
            start += math.ceil(-(start + shift.length_ns) / shift.repeats_ns) * shift.repeats_ns
        return shift._replace(start_ns=start) if start + max(shift.length_ns, Fraction(0)) <= self.window_ns else None


def _window_ns(signals: Sequence[Signal]) -> Fraction:
    """Three bus cycles when all signals follow them, else two periods of the slowest."""
    periods = [signal.period_ns for signal in signals if signal.period_ns]
    slowest = max([Fraction(_CYCLE_NS), *periods])
    return slowest * (3 if all(period == _CYCLE_NS for period in periods) else 2)


def _times(period: Fraction, first: Fraction, window: Fraction) -> Iterator[Fraction]:
    """Times of pulses within the drawing, both ends included."""
    time = first % period
    while time <= window:
        yield time
        time += period


def _lane(signal: Signal, scale: _Scale, y: int) -> str:
    """Name, base line and pulses of one signal."""
    base = y + _LANE - 8
    band = signal.period_ns is not None and scale.distance(signal.period_ns) < _CLOSEST
    words = f"{signal.name}: {signal.words}{' (a band: too close to draw)' if band else ''}"
    parts = [title(words), text(_LEFT, y + 10, words), element("path", d=f"M{_LEFT} {base}H{_RIGHT}")]
    if band:
        line = f"M{_LEFT} {base - _PULSE // 2}H{_RIGHT}"
        parts.append(element("path", d=line, class_="band", stroke_width=_PULSE))
    elif signal.period_ns:
        times = _times(signal.period_ns, signal.first_ns, scale.window_ns)
        pulses = "".join(f"M{number(scale.x(time))} {base}v-{_PULSE}" for time in times)
        parts.append(element("path", d=pulses, class_="pulse"))
    return element("g", *parts, class_="lane", data_signal=signal.name)


def _shift_lane(shifts: Sequence[Shift], scale: _Scale, y: int) -> str:
    parts = [title("Shifts")]
    for at, shift in enumerate(shifts):
        line = y + _SHIFT_ROW * at + 18
        first, last = scale.x(shift.start_ns), scale.x(shift.start_ns + shift.length_ns)
        left = max(_LEFT, min(first, last, _RIGHT - text_width(shift.words)))
        parts += [text(left, line - 7, shift.words), element("path", d=_arrow(first, last, line), class_="shift")]
    return element("g", *parts, class_="lane", data_signal="shifts")


def _arrow(first: float, last: float, y: int) -> str:
    """A line from ``first`` to ``last`` between two marks, with a head where there is room for one."""
    marks = f"M{number(first)} {y - 4}v8M{number(last)} {y - 4}v8M{number(first)} {y}H{number(last)}"
    back = -5 if last > first else 5
    return marks + (f"m{back} -3l{-back} 3l{back} 3" if abs(last - first) > 8 else "")


def _grid(frames: Signal, scale: _Scale, bottom: int) -> Iterator[str]:
    """The starts of the bus cycles, and their times below."""
    cycle = frames.period_ns or scale.window_ns
    if scale.distance(cycle) < _ROOM_FOR_A_TIME:
        cycle = scale.window_ns
    for time in _times(cycle, Fraction(0), scale.window_ns):
        x = scale.x(time)
        yield element("path", d=f"M{number(x)} {_TOP + 14}V{bottom}", class_="grid")
        words = time_text(time) if time else "0"
        place = min(max(x, _LEFT + text_width(words) / 2 - 8), _RIGHT + 10 - text_width(words) / 2)
        yield text(place, bottom + 12, words, "axis label")
