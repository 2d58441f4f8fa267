"""Times of the distributed clocks for a chosen OpMode, as multiples of the bus cycle (ESI-FACTS section 11).

SYNC1 is programmed as a delay after SYNC0: register 0x09A4 = SYNC1 period - SYNC0 period + ShiftTimeSync1. The delay
starts again with the first SYNC0 after it has passed, so SYNC1 comes every so many whole SYNC0 cycles: a shift of whole
SYNC0 cycles would not move it but make it slower or faster, and a period of SYNC1 between two multiples cannot be.
"""

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.export.choice import DEFAULT_CYCLE_NS
from esicatalog.identity import UINT32_MAX
from esicatalog.model.sync import (
    ASSIGN_ACTIVATE,
    SyncSignals,
    asked_op_modes,
    chosen_positions,
    default_position,
    op_mode_choice,
    sync_signals,
)
from esicatalog.remarks import Remarking, remarked

_INT32_MAX = 0x7FFF_FFFF
_TIME_LOOP_CONTROL_ONLY = (
    "Dc/TimeLoopControlOnly: the device uses the DC time and no SYNC or LATCH signal, so that a master writes none of "
    "the registers 0x0940 to 0x09FF, and AssignActivate 0x{:04X} of the OpMode is left out; the clocks of the bus have "
    "to be kept together all the same"
)
_AFTER_1_17 = {
    "ActivateAdditional": ("activate_additional",),
    "CycleTimeSync2": ("cycle_time_sync2_ns", "cycle_time_sync2_factor"),
    "ShiftTimeSync2": ("shift_time_sync2_ns",),
    "CycleTimeSync3": ("cycle_time_sync3_ns", "cycle_time_sync3_factor"),
    "ShiftTimeSync3": ("shift_time_sync3_ns",),
}
"""Elements of an OpMode in schemas after 1.17, with the fields that hold them."""
_INPUT_REFERENCE = (
    "{} counts from the input reference (Input=1): the shift is given as written; a master that knows its input time "
    "adds it"
)
_WITHOUT_RULE = "{}, which is left out: its rule is not public; compare with a known configuration of the device"


class Notation(NamedTuple):
    """How a language writes what is computed of the bus cycle."""

    cycle: str
    """Name of the bus cycle, an integer."""
    either: str
    divide: str
    number: str = "{}"
    """A number that the bus cycle is multiplied with or added to, wide enough that nothing overflows."""


class Time(NamedTuple):
    """A time: so many bus cycles, and so many nanoseconds more."""

    cycles: Fraction = Fraction(0)
    ns: int = 0

    def plus(self, other: "Time") -> "Time":
        """The sum."""
        return Time(self.cycles + other.cycles, self.ns + other.ns)

    def minus(self, other: "Time") -> "Time":
        """The difference."""
        return Time(self.cycles - other.cycles, self.ns - other.ns)

    def times(self, factor: int) -> "Time":
        """The multiple."""
        return Time(self.cycles * factor, self.ns * factor)

    def in_ns(self, cycle_ns: int) -> Fraction:
        """Its length for a bus cycle."""
        return self.cycles * cycle_ns + self.ns

    @property
    def may_change_sign(self) -> bool:
        """Whether it is negative for some bus cycles and positive for others."""
        return bool(self.cycles) and self.ns * self.cycles < 0

    def expression(self, notation: Notation) -> str:
        """It as an expression in whole nanoseconds."""
        if not self.cycles:
            return str(self.ns) if self.ns >= 0 else f"({self.ns})"
        cycle, number = notation.cycle, notation.number.format
        whole = self.cycles.denominator == 1
        divided = cycle if whole else f"{cycle} {notation.divide} {self.cycles.denominator}"
        factor = abs(self.cycles.numerator)
        multiple = divided if factor == 1 else f"{divided} * {number(factor)}"
        if self.cycles < 0:
            return f"({number(self.ns)} - {multiple})"
        if self.ns:
            return f"({multiple} {'+' if self.ns > 0 else '-'} {number(abs(self.ns))})"
        return multiple if multiple.isidentifier() else f"({multiple})"


class Condition(NamedTuple):
    """What must hold of the bus cycle: an expression in C or Python, and what is wrong where it does not hold."""

    expression: str
    words: str


class Clocks(NamedTuple):
    """What a master programs for one OpMode."""

    assign_activate: int
    signals: SyncSignals
    sync0_cycle: Time
    sync0_shift_ns: int
    sync1_delay: Time
    """Register 0x09A4; zero when SYNC1 is not generated."""
    sync1_period: Time
    """As described, whether or not it is shorter than the SYNC0 cycle; zero when SYNC1 is not generated."""
    remarks: tuple[str, ...] = ()

    @property
    def divisor(self) -> int:
        """The bus cycle must be a multiple of so many nanoseconds, else the signals drift apart."""
        return math.lcm(self.sync0_cycle.cycles.denominator, self.sync1_delay.cycles.denominator)

    @property
    def fixed_ns(self) -> int:
        """SYNC0 cycle that is the same whatever the bus cycle is, where there are pulses of SYNC0 or SYNC1, else 0."""
        has_pulses = self.signals.sync0 or self.signals.sync1
        return self.sync0_cycle.ns if has_pulses else 0

    def drifts(self, cycle_ns: int) -> bool:
        """Whether pulses of a fixed period move against the bus cycle: neither is a multiple of the other."""
        return bool(self.fixed_ns and self.fixed_ns % cycle_ns and cycle_ns % self.fixed_ns)

    def is_uneven(self, cycle_ns: int) -> bool:
        """Whether the period of SYNC1 lies between two multiples of the SYNC0 cycle, which no pulse can keep."""
        period, sync0_cycle = self.sync1_period.in_ns(cycle_ns), self.sync0_cycle.in_ns(cycle_ns)
        return period > sync0_cycle > 0 and bool(period % sync0_cycle)

    def conditions(self, notation: Notation, cycle_ns: int) -> Iterator[Condition]:
        """What must hold of a bus cycle that is known later, for what was made for ``cycle_ns`` to be right then."""
        cycle = notation.cycle
        if self.divisor > 1:
            yield Condition(
                f"{cycle} % {self.divisor} == 0",
                f"{cycle} must be a multiple of {self.divisor} ns: the OpMode divides it",
            )
        if fixed := self.fixed_ns:
            yield Condition(
                f"{cycle} % {fixed} == 0 {notation.either} {fixed} % {cycle} == 0",
                f"{cycle} must be a multiple or a divisor of {fixed} ns, the SYNC0 cycle, or the pulses drift",
            )
        # Where both are as long, SYNC1 comes with SYNC0 either way.
        longer = self.sync1_period.minus(self.sync0_cycle)
        is_shorter = longer.in_ns(cycle_ns) < 0
        if longer.may_change_sign:
            period, sync0_cycle = (time.expression(notation) for time in (self.sync1_period, self.sync0_cycle))
            relation, otherwise = (
                (f"{period} <= {sync0_cycle}", "slower than")
                if is_shorter
                else (f"{period} % {sync0_cycle} == 0", "at no multiple of")
            )
            yield Condition(relation, f"SYNC1 is described {otherwise} the SYNC0 cycle at this {cycle}: generate anew")
        shift = self.sync1_delay if is_shorter else self.sync1_delay.minus(longer)
        for time, sign in ((shift, ">= 0"), (self.sync0_cycle.minus(shift), "> 0")):
            if time.may_change_sign:
                yield Condition(
                    f"{time.expression(notation)} {sign}",
                    f"SYNC1 comes at another rate at this {cycle}, which its shift does not fit into: generate anew",
                )


class Programmed(NamedTuple):
    """The clocks of a device at a bus cycle."""

    cycle_ns: int
    clocks: Clocks | None
    """None when a master programs no SYNC unit for the OpMode."""
    remarks: tuple[str, ...]


def chosen_op_mode(device: Device, modules: tuple[Module, ...], wanted: str | None) -> Remarking[int | None]:
    """Position of the OpMode: the one wanted by name or position, else the one that modules ask for, else the default.

    Raises :class:`InputError` for one that does not exist and for a name that several have.
    """
    modes = device.op_modes
    if wanted is None:
        return (yield from _by_modules(device, modules))
    listed = ", ".join(f"{position} {mode.name!r}" for position, mode in enumerate(modes)) or "none"
    match chosen_positions(modes, wanted):
        case []:
            raise InputError(f"OpMode {wanted!r} does not exist; the device has {listed}")
        case [position]:
            return position
        case several:
            words = ", ".join(op_mode_choice(modes, position) for position in several)
            raise InputError(f"OpMode {wanted!r} exists at positions {words}; choose by position")


def _by_modules(device: Device, modules: tuple[Module, ...]) -> Remarking[int | None]:
    names = []
    for name, asked in asked_op_modes(device.op_modes, modules).items():
        if asked is not None:
            names.append(repr(name))
        else:
            yield f"a plugged module asks for OpMode {name!r} (DcOpModeName), which the device does not have"
    position = default_position(device.op_modes, modules)
    if names and position != default_position(device.op_modes):
        yield f"OpMode {names[0]} is not the first valid one: a plugged module asks for it (DcOpModeName)"
    if len(names) > 1:
        yield f"plugged modules ask for different OpModes: {', '.join(names)}"
    return position


def programmed_clocks(device: Device, op_mode: OpMode | None, cycle_ns: int | None) -> Programmed:
    """What a master programs for the OpMode at this bus cycle, and remarks; no clocks with Dc/@TimeLoopControlOnly.

    ``cycle_ns`` None leaves the bus cycle open: the usual one, or that of a SYNC0 that would drift against it. Raises
    :class:`InputError` when the signals would drift against the cycle that is asked for, when SYNC1 cannot come as
    often as described, and as :func:`clocks` does.
    """
    usual_ns = cycle_ns if cycle_ns is not None else DEFAULT_CYCLE_NS
    if device.dc_time_loop_control_only and op_mode is not None and op_mode.assign_activate:
        return Programmed(usual_ns, None, (_TIME_LOOP_CONTROL_ONLY.format(op_mode.assign_activate),))
    found = clocks(op_mode, usual_ns)
    newer = _newer_remarks(op_mode) if op_mode is not None else ()
    if found is None or op_mode is None:
        return Programmed(usual_ns, None, tuple(newer))
    if not found.drifts(usual_ns):
        _check_even(found, op_mode.name, usual_ns)
        return Programmed(usual_ns, found, (*found.remarks, *_fixed_remarks(found, usual_ns), *newer))
    if cycle_ns is not None:
        raise InputError(
            f"OpMode {op_mode.name!r} fixes the SYNC0 cycle at {found.fixed_ns} ns, which drifts against a bus cycle "
            f"of {cycle_ns} ns: choose a multiple or a divisor of it, or another OpMode"
        )
    open_remark = (
        f"the bus cycle is the SYNC0 cycle, {found.fixed_ns} ns: the OpMode fixes it, and it drifts against "
        f"{usual_ns} ns"
    )
    programmed = programmed_clocks(device, op_mode, found.fixed_ns)
    return programmed._replace(remarks=(open_remark, *programmed.remarks))


def _check_even(found: Clocks, name: str | None, cycle_ns: int) -> None:
    if found.is_uneven(cycle_ns):
        period, sync0_cycle = found.sync1_period, found.sync0_cycle
        by_cycle = period.cycles * sync0_cycle.ns != period.ns * sync0_cycle.cycles
        advice = "choose the bus cycle (--cycle-ns) or another OpMode" if by_cycle else "correct it, or choose another"
        raise InputError(
            f"OpMode {name!r} describes SYNC1 every {period.in_ns(cycle_ns)} ns, which is no multiple of the SYNC0 "
            f"cycle of {sync0_cycle.in_ns(cycle_ns)} ns, and a slave controller generates multiples only: {advice}"
        )


def _newer_remarks(op_mode: OpMode) -> Iterator[str]:
    given = [name for name, fields in _AFTER_1_17.items() if any(getattr(op_mode, field) for field in fields)]
    if given:
        yield _WITHOUT_RULE.format(f"the OpMode gives {', '.join(given)}")


def _fixed_remarks(found: Clocks, cycle_ns: int) -> Iterator[str]:
    fixed = found.fixed_ns
    if fixed and fixed != cycle_ns:
        held = (
            f"a bus cycle of {cycle_ns} ns holds {cycle_ns // fixed} of it"
            if fixed < cycle_ns
            else f"it takes {fixed // cycle_ns} bus cycles of {cycle_ns} ns"
        )
        yield f"the OpMode fixes the SYNC0 cycle at {fixed} ns: {held}"


def clocks(op_mode: OpMode | None, cycle_ns: int) -> Clocks | None:
    """What the OpMode says at this bus cycle; None where AssignActivate is 0, not given, or cannot be read.

    Raises :class:`InputError` when the cycle cannot be divided as the OpMode says. A fixed time may drift against it:
    :meth:`Clocks.drifts`.
    """
    if op_mode is None or not op_mode.assign_activate:
        return None
    found, remarks = remarked(_described_clocks(op_mode, op_mode.assign_activate, cycle_ns))
    if cycle_ns % found.divisor:
        raise InputError(
            f"OpMode {op_mode.name!r} divides the bus cycle by {found.divisor}; {cycle_ns} ns is no multiple of that: "
            "choose the cycle or another OpMode"
        )
    _check_range(found, op_mode.name, cycle_ns)
    return found._replace(remarks=remarks)


def _described_clocks(op_mode: OpMode, assign_activate: int, cycle_ns: int) -> Remarking[Clocks]:
    signals = sync_signals(assign_activate)
    sync0 = (yield from _sync0_cycle(op_mode, signals)) if signals.dc_active else Time()
    shift_ns = (op_mode.shift_time_sync0_ns or 0) if signals.dc_active else 0
    period = (yield from _sync1_period(op_mode, sync0)) if signals.sync1 else Time()
    delay = (yield from _sync1_delay(op_mode, sync0, period, cycle_ns)) if signals.sync1 else Time()
    for name, is_used, is_input, factor in (
        ("ShiftTimeSync0", signals.dc_active, op_mode.shift_time_sync0_input, op_mode.shift_time_sync0_factor),
        ("ShiftTimeSync1", signals.sync1, op_mode.shift_time_sync1_input, op_mode.shift_time_sync1_factor),
    ):
        if is_used and is_input:
            yield _INPUT_REFERENCE.format(name)
        if is_used and factor:
            yield _WITHOUT_RULE.format(f"{name} has Factor {factor}")
    return Clocks(assign_activate, signals, sync0, shift_ns, delay, period)


def _sync0_cycle(op_mode: OpMode, signals: SyncSignals) -> Remarking[Time]:
    if op_mode.cycle_time_sync0_ns:
        return Time(ns=op_mode.cycle_time_sync0_ns)
    factor = op_mode.cycle_time_sync0_factor or 0
    if factor:
        return Time(Fraction(factor) if factor > 0 else Fraction(1, -factor))
    if not signals.sync0 and not signals.sync1:
        return Time()
    yield "CycleTimeSync0 gives no cycle: SYNC0 follows the bus cycle"
    return Time(Fraction(1))


def _sync1_period(op_mode: OpMode, sync0: Time) -> Remarking[Time]:
    if op_mode.cycle_time_sync1_ns:
        return Time(ns=op_mode.cycle_time_sync1_ns)
    factor = op_mode.cycle_time_sync1_factor or 0
    if factor:
        return sync0.times(factor) if factor > 0 else Time(Fraction(-factor))
    if op_mode.shift_time_sync1_ns is None:
        yield "neither CycleTimeSync1 nor ShiftTimeSync1 gives a time: SYNC1 comes at the start of each SYNC0 cycle"
    return sync0


def _sync1_delay(op_mode: OpMode, sync0: Time, period: Time, cycle_ns: int) -> Remarking[Time]:
    if period.in_ns(cycle_ns) < sync0.in_ns(cycle_ns):
        yield "SYNC1 is described faster than SYNC0, which no slave controller generates: it follows SYNC0"
        period = sync0
    shift_ns, sync0_ns = op_mode.shift_time_sync1_ns or 0, sync0.in_ns(cycle_ns)
    delay = period.minus(sync0).plus(Time(ns=shift_ns))
    whole_cycles = shift_ns // sync0_ns if sync0_ns > 0 else 0
    if whole_cycles:
        yield (
            f"ShiftTimeSync1, {shift_ns} ns, is not within the SYNC0 cycle of {sync0_ns} ns: SYNC1 is programmed whole "
            f"SYNC0 cycles {'earlier' if whole_cycles > 0 else 'later'}, at the same place; see that the device can "
            "keep up with this bus cycle"
        )
        delay = delay.minus(sync0.times(whole_cycles))
    return delay


def _check_range(found: Clocks, name: str | None, cycle_ns: int) -> None:
    if found.assign_activate not in ASSIGN_ACTIVATE:
        raise InputError(
            f"OpMode {name!r} has AssignActivate {found.assign_activate:#x}, which does not fit the registers 0x0980 "
            "and 0x0981: correct it, or choose another OpMode"
        )
    times = (found.sync0_cycle.in_ns(cycle_ns), found.sync1_delay.in_ns(cycle_ns))
    if not all(0 <= time <= UINT32_MAX for time in times) or abs(found.sync0_shift_ns) > _INT32_MAX:
        raise InputError(f"OpMode {name!r} has times that do not fit the registers of the slave controller")
