"""Rules about distributed clocks and OpModes (ESI-FACTS section 11)."""

from collections.abc import Iterator

from esicatalog.esi.records.dc import OpMode
from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Found, Place, rule
from esicatalog.lint.subjects import ModuleSubject, ProcessSubject, is_absent
from esicatalog.model.sync import SYNC0_PULSE, SYNC1_PULSE, is_superseded, sync_signals


def _words(number: int, mode: OpMode) -> str:
    return f"OpMode {number + 1} {mode.name or ''!r}"


@rule("L49", ERROR, "ETG.2000 OpMode/AssignActivate: registers 0x0980 and 0x0981; pulses need bit 0x0100")
def assign_activate(subject: ProcessSubject) -> Iterator[Found]:
    """An OpMode without AssignActivate (SYNC pulses without the sync unit: W)."""
    for number, mode in enumerate(subject.data.op_modes):
        value = mode.assign_activate
        if value is None:
            if is_absent(mode, "assign_activate"):
                yield Found(f"{_words(number, mode)} has no AssignActivate: give it, #x0 for no clocks", _at(number))
        elif value & (SYNC0_PULSE | SYNC1_PULSE) and not sync_signals(value).dc_active:
            yield Found(
                f"{_words(number, mode)} has AssignActivate 0x{value:04X}: SYNC pulses without the sync unit (0x0100); "
                "no pulse is made",
                (*_at(number), "assign_activate"),
                WARNING,
            )


@rule("L50", INFORMATION, "ESC registers 0x0980, 0x0981: bit 0x0400 of AssignActivate makes SYNC1, not its times")
def sync1_times(subject: ProcessSubject) -> Iterator[Found]:
    """Times of SYNC1 without the SYNC1 bit (the bit without times: W)."""
    for number, mode in enumerate(subject.data.op_modes):
        if mode.assign_activate is None:
            continue
        if sync_signals(mode.assign_activate).sync1:
            if mode.cycle_time_sync1_ns is None and mode.shift_time_sync1_ns is None:
                yield Found(
                    f"{_words(number, mode)} makes SYNC1 (AssignActivate 0x{mode.assign_activate:04X}) "
                    "without CycleTimeSync1: its time is unknown",
                    _at(number),
                    WARNING,
                )
        elif mode.cycle_time_sync1_ns or mode.cycle_time_sync1_factor:
            yield Found(
                f"{_words(number, mode)} has CycleTimeSync1, but AssignActivate 0x{mode.assign_activate:04X} "
                "makes no SYNC1",
                (*_at(number), "cycle_time_sync1_ns"),
            )


@rule("L51", WARNING, "ETG.2000 OpMode/CycleTimeSync0")
def sync0_time_missing(subject: ProcessSubject) -> Iterator[Found]:
    """SYNC pulses without CycleTimeSync0."""
    for number, mode in enumerate(subject.data.op_modes):
        signals = sync_signals(mode.assign_activate)
        if (signals.sync0 or signals.sync1) and mode.cycle_time_sync0_ns is None:
            yield Found(
                f"{_words(number, mode)} makes SYNC pulses without CycleTimeSync0: "
                "give it, 0 with Factor 1 for the bus cycle",
                _at(number),
            )


@rule("L52", WARNING, "ETG.2000 OpMode: names select it, Sm/@No and Pdo refer to the device")
def op_mode_references(subject: ProcessSubject | ModuleSubject) -> Iterator[Found]:
    """An OpMode names an unknown SyncManager or PDO, two have one name, or a module asks for an unknown one."""
    if isinstance(subject, ModuleSubject):
        yield from _wanted_op_mode(subject)
        return
    data = subject.data
    owners: list[ProcessSubject | ModuleSubject] = [subject, *subject.modules]
    known = {placed.pdo.pdo_index for owner in owners for placed in owner.pdos}
    names: set[str] = set()
    for number, mode in enumerate(data.op_modes):
        if mode.name and not is_superseded(mode):
            if mode.name in names:
                yield Found(
                    f"{_words(number, mode)} has the name of one before it: a choice by name means that one",
                    _at(number),
                )
            names.add(mode.name)
        for position, item in enumerate(mode.sm_assignments):
            place: Place = (*_at(number), "sm_assignments", position)
            if item.no is not None and not 0 <= item.no < len(data.sync_managers):
                yield Found(f"{_words(number, mode)} names SM {item.no}; there are {len(data.sync_managers)}", place)
            for nth, pdo in enumerate(item.pdos):
                if pdo.pdo_index is None or pdo.pdo_index in known:
                    continue
                if not data.in_slots.has_pdo(pdo.pdo_index):
                    yield Found(
                        f"{_words(number, mode)} assigns PDO 0x{pdo.pdo_index:04X}, which is not described",
                        (*place, "pdos", nth),
                    )


def _wanted_op_mode(subject: ModuleSubject) -> Iterator[Found]:
    wanted = subject.module.dc_op_mode_name
    if (
        wanted
        and subject.hosts
        and not any(wanted == mode.name for host in subject.hosts for mode in host.device.op_modes)
    ):
        yield Found(f"DcOpModeName {wanted!r} is no OpMode of a device that carries the module", ("dc_op_mode_name",))


def _at(number: int) -> Place:
    return ("op_modes", number)
