"""Rules about distributed clocks and OpModes (ESI-FACTS section 11)."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from esicatalog.esi.records.dc import OpMode, OpModeSm
from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Found, Place, rule
from esicatalog.lint.subjects import DeclaredPdo, ModuleSubject, ProcessSubject, is_absent, is_off
from esicatalog.model.sm_facts import may_transport
from esicatalog.model.sync import sync_signals
from esicatalog.model.twincat import is_superseded
from esicatalog.sii.codes import AssignActivate


def _words(number: int, mode: OpMode) -> str:
    """An OpMode by its position, as ``show`` and ``export --op-mode`` count them: from 0."""
    return f"OpMode {number} {mode.name or ''!r}"


@rule("L49", ERROR, "ETG.2000 OpMode/AssignActivate: registers 0x0980 and 0x0981; pulses need bit 0x0100")
def assign_activate(subject: ProcessSubject) -> Iterator[Found]:
    """An OpMode without AssignActivate (SYNC pulses without the sync unit: W)."""
    for number, mode in enumerate(subject.data.op_modes):
        value = mode.assign_activate
        if value is None:
            if is_absent(mode, "assign_activate"):
                yield Found(f"{_words(number, mode)} has no AssignActivate: give it, #x0 for no clocks", _at(number))
        elif value & (AssignActivate.SYNC0 | AssignActivate.SYNC1) and sync_signals(value).dc_active is False:
            yield Found(
                f"{_words(number, mode)} has AssignActivate 0x{value:04X}: SYNC pulses without the sync unit (0x0100); "
                "no pulse is made",
                (*_at(number), "assign_activate"),
                WARNING,
            )


@rule("L50", INFORMATION, "ESC registers 0x0980, 0x0981: bit 0x0400 of AssignActivate makes SYNC1, not its times")
def sync1_times(subject: ProcessSubject) -> Iterator[Found]:
    """Times of SYNC1 without the SYNC1 bit (the bit without times, or with a cycle below 0: W)."""
    for number, (mode, signals) in enumerate(zip(subject.data.op_modes, subject.data.signals, strict=True)):
        if mode.assign_activate is None:
            continue
        if signals.sync1:
            if _has_no_time(mode, "cycle_time_sync1") and is_absent(mode, "shift_time_sync1_ns"):
                yield Found(
                    f"{_words(number, mode)} makes SYNC1 (AssignActivate 0x{mode.assign_activate:04X}) "
                    f"{_without('CycleTimeSync1', mode.cycle_time_sync1_ns)}: its time is unknown; give it",
                    _at(number),
                    WARNING,
                )
            if (mode.cycle_time_sync1_ns or 0) < 0:
                yield _negative(number, mode, "CycleTimeSync1", "cycle_time_sync1_ns")
        elif (
            signals.sync1 is False
            and not mode.assign_activate & AssignActivate.SYNC1
            and (mode.cycle_time_sync1_ns or mode.cycle_time_sync1_factor)
        ):
            yield Found(
                f"{_words(number, mode)} has CycleTimeSync1, but AssignActivate 0x{mode.assign_activate:04X} "
                "makes no SYNC1",
                (*_at(number), "cycle_time_sync1_ns"),
            )


@rule("L51", WARNING, "ETG.2000 OpMode/CycleTimeSync0")
def sync0_time_missing(subject: ProcessSubject) -> Iterator[Found]:
    """SYNC pulses without CycleTimeSync0, with 0 and no Factor or with a time below 0; a device that makes them itself
    needs none.
    """
    for number, (mode, signals) in enumerate(zip(subject.data.op_modes, subject.data.signals, strict=True)):
        makes_pulses = (signals.sync0 or signals.sync1) and not signals.sync_unit_pdi
        if makes_pulses and _has_no_time(mode, "cycle_time_sync0"):
            yield Found(
                f"{_words(number, mode)} makes SYNC pulses {_without('CycleTimeSync0', mode.cycle_time_sync0_ns)}: "
                "give it, 0 with Factor 1 for the bus cycle",
                _at(number),
            )
        if signals.dc_active and (mode.cycle_time_sync0_ns or 0) < 0:
            yield _negative(number, mode, "CycleTimeSync0", "cycle_time_sync0_ns")


def _has_no_time(mode: OpMode, cycle_time: str) -> bool:
    """Whether a cycle time is nowhere given, neither by itself nor by its factor."""
    return is_off(mode, f"{cycle_time}_ns") and is_off(mode, f"{cycle_time}_factor")


def _negative(number: int, mode: OpMode, element: str, field: str) -> Found:
    words = f"{_words(number, mode)} has {element} {getattr(mode, field)}: no cycle takes less than nothing; correct it"
    return Found(words, (*_at(number), field), WARNING)


def _without(element: str, given_ns: int | None) -> str:
    """How an element says no time: 0 counts with its Factor only."""
    return f"without {element}" if given_ns is None else f"with {element} 0 and no Factor"


@rule("L52", WARNING, "ETG.2000 OpMode: names select it, Sm/@No and Pdo refer to the device")
def op_mode_references(subject: ProcessSubject | ModuleSubject) -> Iterator[Found]:
    """An OpMode names an unknown SyncManager or PDO, a PDO that the SyncManager cannot have, or samples it more often
    than it may be; its name occurs twice; a module asks for an unknown one.
    """
    if isinstance(subject, ModuleSubject):
        yield from _wanted_op_mode(subject)
        return
    yield from _names_twice(subject.data.op_modes)
    owners: list[ProcessSubject | ModuleSubject] = [subject, *subject.modules]
    described: dict[int | None, list[DeclaredPdo]] = defaultdict(list)
    for placed in [placed for owner in owners for placed in owner.pdos]:
        described[placed.pdo.pdo_index].append(placed)
    for number, mode in enumerate(subject.data.op_modes):
        for position, item in enumerate(mode.sm_assignments):
            for found in _assignment(subject, item, described):
                place = (*_at(number), "sm_assignments", position, *found.place)
                yield Found(f"{_words(number, mode)} {found.message}", place)


def _names_twice(modes: Sequence[OpMode]) -> Iterator[Found]:
    names: set[str] = set()
    for number, mode in enumerate(modes):
        if mode.name and not is_superseded(mode):
            if mode.name in names:
                yield Found(
                    f"{_words(number, mode)} has the name of one before it: a choice by name is ambiguous, and a "
                    "module's DcOpModeName means that one; give it a name of its own",
                    _at(number),
                )
            names.add(mode.name)


def _assignment(
    subject: ProcessSubject, item: OpModeSm, by_index: Mapping[int | None, list[DeclaredPdo]]
) -> Iterator[Found]:
    """What is wrong with the PDOs of a SyncManager; ``by_index`` are those that are described."""
    data, sm = subject.data, None
    if item.no is not None and 0 <= item.no < len(data.sync_managers):
        sm = data.sync_managers[item.no]
    elif item.no is not None:
        yield Found(f"names SM {item.no}; there are {len(data.sync_managers)}: correct No")
    elif item.pdos:
        yield Found("lists PDOs but no SyncManager (No): the list is ignored; give No")
    for nth, pdo in enumerate(item.pdos):
        index = pdo.pdo_index
        if index is None:
            continue
        described = by_index.get(index, [])
        if not described and subject.is_complete and not data.in_slots.has_pdo(index):
            yield Found(f"assigns PDO 0x{index:04X}, which is not described", ("pdos", nth))
        elif described and sm is not None and not any(may_transport(sm, placed.direction) for placed in described):
            kinds = " and ".join(sorted({placed.direction for placed in described}))
            yield Found(f"assigns the {kinds} 0x{index:04X} to SM {item.no}, which is {sm.usage}", ("pdos", nth))
        elif described and all(item.no in placed.pdo.excluded_sms for placed in described):
            yield Found(
                f"assigns PDO 0x{index:04X} to SM {item.no}, which its ExcludedSm rules out: correct one of them",
                ("pdos", nth),
            )
        most = max((placed.pdo.os_max or 0 for placed in described), default=0)
        if most and pdo.os_fac is not None and pdo.os_fac > most:
            yield Found(f"samples PDO 0x{index:04X} {pdo.os_fac} times, its OSMax is {most}", ("pdos", nth))


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
