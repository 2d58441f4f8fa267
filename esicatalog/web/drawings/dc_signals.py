"""What a drawing of an OpMode shows and says: pulses, shifts and sentences (ESI-FACTS section 11)."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.esi.records.dc import OpMode
from esicatalog.export.clocks import Clocks, clocks
from esicatalog.model.sync import SyncSignals, generated_signals

_UNITS = ((1_000_000_000, 9, "s"), (1_000_000, 6, "ms"), (1_000, 3, "µs"), (1, 0, "ns"))
"""Nanoseconds of a unit, and its decimals."""


class Signal(NamedTuple):
    """Pulses at ``first_ns`` and every ``period_ns`` before and after it; without period only words."""

    name: str
    words: str
    period_ns: Fraction | None
    first_ns: Fraction = Fraction(0)


class Shift(NamedTuple):
    """An interval from ``start_ns``, backwards when negative; it comes again every ``repeats_ns``."""

    words: str
    start_ns: Fraction
    length_ns: Fraction
    repeats_ns: Fraction


class DcTiming(NamedTuple):
    """All that is known of an OpMode's timing for one bus cycle."""

    summary: str
    sentences: tuple[str, ...]
    signals: tuple[Signal, ...] = ()
    shifts: tuple[Shift, ...] = ()


def dc_timing(op_mode: OpMode | None, cycle_ns: int, time_loop_control_only: bool | None) -> DcTiming:
    """Signals, shifts and sentences for a bus cycle in ns; only what the device generates is a signal.

    ``time_loop_control_only`` is the attribute of its Dc, with which it generates none.
    """
    timing = _timing(op_mode, cycle_ns, time_loop_control_only)
    return timing._replace(sentences=(*timing.sentences, f"Drawn for a bus cycle of {time_text(cycle_ns)}."))


def _timing(op_mode: OpMode | None, cycle_ns: int, time_loop_control_only: bool | None) -> DcTiming:
    if op_mode is None:
        return _without_clocks("The device has no OpMode of the distributed clocks.", cycle_ns)
    if op_mode.assign_activate is None:
        said = "AssignActivate is not given: it is unknown which SYNC signals are generated"
        return DcTiming(said, (f"{said}.",))
    generated = generated_signals(op_mode, time_loop_control_only)
    word = f"AssignActivate 0x{op_mode.assign_activate:04X}"
    notes = tuple(_notes(op_mode, generated))
    if generated.time_only:
        said = (
            f"TimeLoopControlOnly: the device uses the DC time and no SYNC or LATCH signal, whatever {word} asks for"
            if time_loop_control_only
            else f"{word}: the SYNC unit is active and gives no pulses, the device uses the DC time or its latches"
        )
        return DcTiming("no SYNC signals", (f"{said}.", *notes))
    try:
        programmed = clocks(op_mode, cycle_ns)
    except InputError as error:
        return DcTiming("SYNC signals cannot be drawn", (f"No SYNC signal is drawn: {error}.", *notes))
    if programmed is None or not generated.dc_active:
        free = _without_clocks(f"{word}: no SYNC signals.", cycle_ns)
        return free._replace(sentences=(*free.sentences, *notes))
    return _known(op_mode, programmed, cycle_ns, notes)


def _without_clocks(reason: str, cycle_ns: int) -> DcTiming:
    event = Signal("SyncManager event", "with each frame, if SM-synchronous", Fraction(cycle_ns))
    said = "The device runs free, or synchronous with the SyncManager event of each frame."
    return DcTiming("no SYNC signals, free run or SM-synchronous", (reason, said), (event,))


def _known(op_mode: OpMode, programmed: Clocks, cycle_ns: int, notes: tuple[str, ...]) -> DcTiming:
    shown = [_sync0(op_mode, programmed, cycle_ns)] if programmed.signals.sync0 else []
    if programmed.signals.sync1:
        shown.append(_sync1(op_mode, programmed, cycle_ns))
    sentences = [said for _, said in shown]
    if _gives_sync0(op_mode):
        sentences += [f"{remark}." for remark in programmed.remarks]
        sentences.append("The reference is drawn at 0; when frames pass after it is the master's choice.")
    signals = tuple(signal for signal, _ in shown)
    summary = ", ".join(f"{signal.name} {signal.words}" for signal in signals)
    return DcTiming(summary, (*sentences, *notes), signals, tuple(_shifts(op_mode, programmed, signals, cycle_ns)))


def _gives_sync0(op_mode: OpMode) -> bool:
    return bool(op_mode.cycle_time_sync0_ns or op_mode.cycle_time_sync0_factor)


def _gives_sync1(op_mode: OpMode) -> bool:
    return bool(op_mode.cycle_time_sync1_ns or op_mode.cycle_time_sync1_factor)


def _sync0(op_mode: OpMode, programmed: Clocks, cycle_ns: int) -> tuple[Signal, str]:
    where = _shift_words(op_mode, programmed.sync0_shift_ns)
    if not _gives_sync0(op_mode):
        said = f"SYNC0 is generated {where}, but CycleTimeSync0 gives neither a time nor a Factor: period unknown."
        return Signal("SYNC0", "period unknown", None), said
    period = programmed.sync0_cycle.in_ns(cycle_ns)
    every = f"every {time_text(period)}"
    said = f"SYNC0 {every}, {_relation(programmed, cycle_ns)}, {where}."
    return Signal("SYNC0", every, period, Fraction(programmed.sync0_shift_ns)), said


def _sync1(op_mode: OpMode, programmed: Clocks, cycle_ns: int) -> tuple[Signal, str]:
    if not _gives_sync0(op_mode) or not _gives_sync1(op_mode):
        which = "CycleTimeSync1" if _gives_sync0(op_mode) else "CycleTimeSync0, which it follows,"
        said = f"SYNC1 is generated, but {which} gives neither a time nor a Factor: period unknown."
        return Signal("SYNC1", "period unknown", None), said
    delay, period0 = programmed.sync1_delay.in_ns(cycle_ns), programmed.sync0_cycle.in_ns(cycle_ns)
    # The delay starts again with the first SYNC0 after it has passed.
    period = (delay // period0 + 1) * period0
    where = f"{time_text(delay)} after the SYNC0 that starts its delay" if delay else "together with SYNC0"
    silent = "" if programmed.signals.sync0 else "; SYNC0 itself gives no pulse"
    every = f"every {time_text(period)}"
    return Signal("SYNC1", every, period, programmed.sync0_shift_ns + delay), f"SYNC1 {every}, {where}{silent}."


def _shifts(op_mode: OpMode, programmed: Clocks, signals: tuple[Signal, ...], cycle_ns: int) -> Iterator[Shift]:
    """The intervals other than 0 from the reference to SYNC0 and from SYNC0 to SYNC1, where their places are known."""
    shift, delay = Fraction(programmed.sync0_shift_ns), programmed.sync1_delay.in_ns(cycle_ns)
    if shift and _gives_sync0(op_mode):
        repeats = max(programmed.sync0_cycle.in_ns(cycle_ns), Fraction(cycle_ns))
        yield Shift(f"ShiftTimeSync0 {time_text(shift)}", Fraction(0), shift, repeats)
    for signal in signals:
        if signal.name == "SYNC1" and signal.period_ns and delay:
            yield Shift(f"SYNC0 to SYNC1 {time_text(delay)}", shift, delay, signal.period_ns)


def _relation(programmed: Clocks, cycle_ns: int) -> str:
    """How the period of SYNC0 comes from the bus cycle."""
    period = programmed.sync0_cycle
    if period.cycles == 1:
        return "once in a bus cycle"
    if period.cycles > 1:
        return f"once in {period.cycles} bus cycles"
    if period.cycles:
        return f"{period.cycles.denominator} times in a bus cycle"
    if programmed.drifts(cycle_ns):
        return f"fixed: does not fit a bus cycle of {time_text(cycle_ns)} and drifts against the frames"
    return "fixed, whatever the bus cycle"


def _shift_words(op_mode: OpMode, shift_ns: int) -> str:
    reference = "input reference" if op_mode.shift_time_sync0_input else "reference"
    if not shift_ns:
        return f"at the {reference} of the cycle"
    return f"{time_text(abs(shift_ns))} {'after' if shift_ns > 0 else 'before'} the {reference} of the cycle"


def _notes(op_mode: OpMode, generated: SyncSignals) -> Iterator[str]:
    """What else the OpMode says about time."""
    delays = (
        ("Outputs", "SYNC0", generated.sync0, op_mode.shift_time_sync0_output_delay_ns),
        ("Inputs", "SYNC0", generated.sync0, op_mode.shift_time_sync0_input_delay_ns),
        ("Outputs", "SYNC1", generated.sync1, op_mode.shift_time_sync1_output_delay_ns),
        ("Inputs", "SYNC1", generated.sync1, op_mode.shift_time_sync1_input_delay_ns),
    )
    for what, signal, is_generated, delay in delays:
        if is_generated and delay:
            yield f"{what} {time_text(delay)} after {signal} ({what[:-1]}DelayTime)."
    if generated.sync_unit_pdi:
        yield "The device itself controls the SYNC unit (0x0001): its pulses may differ from the description."
    if generated.sync1 and op_mode.shift_time_sync1_input:
        yield "ShiftTimeSync1 counts from the input reference (Input=1): it is drawn as written, after SYNC0."
    latches = [str(at) for at, by_device in enumerate((generated.latch0_pdi, generated.latch1_pdi)) if by_device]
    if latches:
        yield f"The device controls latch {' and '.join(latches)}."
    if any(
        (
            op_mode.cycle_time_sync2_ns,
            op_mode.cycle_time_sync2_factor,
            op_mode.cycle_time_sync3_ns,
            op_mode.cycle_time_sync3_factor,
            op_mode.activate_additional,
        )
    ):
        yield "SYNC2 and SYNC3 are described and not drawn."


def time_text(time_ns: Fraction | int) -> str:
    """A time of whole ns in its largest fitting unit: "62.5 µs"."""
    amount = abs(int(time_ns))
    size, digits, unit = next((unit for unit in _UNITS if amount >= unit[0]), _UNITS[-1])
    whole, rest = divmod(amount, size)
    decimals = f"{rest:0{digits}d}".rstrip("0") if digits else ""
    return f"{'−' if time_ns < 0 else ''}{whole}{'.' if decimals else ''}{decimals} {unit}"
