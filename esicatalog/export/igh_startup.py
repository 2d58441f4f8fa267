"""What an IgH header configures before the master is activated, and the commands that are left to the application."""

from collections.abc import Callable, Container, Iterator
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.unreadable import unreadable_values
from esicatalog.export.c_clocks import ClockCode, clock_code
from esicatalog.export.c_text import c_bytes, comment_text
from esicatalog.export.clocks import Clocks
from esicatalog.export.configuration import Configuration
from esicatalog.export.esc_registers import (
    PROCESS_DATA_WATCHDOG,
    WATCHDOG_DIVIDER,
    SettableRegisters,
    settable,
)
from esicatalog.export.igh_limits import master_written
from esicatalog.export.init_cmds import LaterCommands, SentCommand, StartCommand, by_transition
from esicatalog.export.mode_commands import mode_remarks
from esicatalog.export.unread_remarks import unread_remark
from esicatalog.model.access import PREOP, SAFEOP
from esicatalog.model.start_up import BEFORE_SAFE_OP, SENT_IN

_AL_STATES = {PREOP: "EC_AL_STATE_PREOP", SAFEOP: "EC_AL_STATE_SAFEOP"}
_IDN_STATES = {transition: _AL_STATES[state] for transition, state in SENT_IN.items()}
"""At which transitions the master writes IDNs itself, and the state in which it does. SDOs it writes in PREOP only."""
WATCHDOG_REGISTERS = SettableRegisters((WATCHDOG_DIVIDER, PROCESS_DATA_WATCHDOG), lowest=1)
"""Those of ecrt_slave_config_watchdog(), which takes 0 for a value that is to stay."""
_TIMEOUTS = (
    ("preop_timeout_ms", (("INIT", "PREOP"),)),
    ("safeop_op_timeout_ms", (("PREOP", "SAFEOP"), ("SAFEOP", "OP"))),
    ("back_to_init_timeout_ms", (("PREOP", "INIT"), ("SAFEOP", "INIT"), ("OP", "INIT"), ("SAFEOP", "PREOP"))),
    ("back_to_safeop_timeout_ms", (("OP", "SAFEOP"),)),
)
_PDOS_BY_MASTER = "ecrt_slave_config_pdos() writes PDO assignment and mapping"
_OFF_BEAT = (
    "The master looks for the first SYNC0 in steps of SYNC0 cycle + SYNC1 delay, which is no multiple of the bus cycle "
    "here: measure where SYNC0 lies in the cycle."
)


class StateTimeout(NamedTuple):
    """Longest time for a change of the AL state."""

    before: str
    after: str
    timeout_ms: int


class Startup(NamedTuple):
    """What is configured beside the PDOs."""

    watchdog: tuple[int, int] | None
    """Divider (register 0x0400) and intervals (0x0420), 0 = not written."""
    timeouts: tuple[StateTimeout, ...]
    commands: tuple[SentCommand, ...]
    later: tuple[LaterCommands[SentCommand], ...]
    clocks: ClockCode | None
    off_beat: str
    """A warning about the clocks, empty without reason for one."""


def startup(configuration: Configuration) -> Startup:
    """The start-up of a device: its own commands and those of its modules, clocks, timeouts, watchdog."""
    at_start = [command for command in configuration.commands if _is_sent_by_master(command)]
    later = (command for command in configuration.commands if not _is_sent_by_master(command))
    written = master_written(configuration)
    return Startup(
        watchdog(configuration.subject.device),
        tuple(_timeouts(configuration.subject.device)),
        tuple(_sent(command, _config_call, written) for command in at_start),
        by_transition(later, lambda command: _sent(command, _run_time_call, written)),
        clock_code(configuration),
        off_beat(configuration.clocks, configuration.cycle_ns) if configuration.clocks is not None else "",
    )


def _is_sent_by_master(command: StartCommand) -> bool:
    return command.transition in (_IDN_STATES if command.protocol == "SoE" else BEFORE_SAFE_OP)


def watchdog(device: Device) -> tuple[int, int] | None:
    """Divider and intervals for ecrt_slave_config_watchdog(), 0 for one that is not to be written."""
    values = {item.register: item.value for item in settable(device, WATCHDOG_REGISTERS)}
    return (values.get(WATCHDOG_DIVIDER, 0), values.get(PROCESS_DATA_WATCHDOG, 0)) if values else None


def _timeouts(device: Device) -> Iterator[StateTimeout]:
    for field, changes in _TIMEOUTS:
        timeout_ms = getattr(device, field)
        if timeout_ms is not None and timeout_ms > 0:
            for before, after in changes:
                yield StateTimeout(before, after, timeout_ms)


def timeout_remarks(device: Device) -> Iterator[str]:
    """Timeouts that cannot be read: the master keeps its own."""
    fields = {field for field, _ in _TIMEOUTS}
    for place, problem in unreadable_values(device, lambda part: False, lambda _, name: name in fields):
        yield unread_remark(place, problem)


def _sent(command: StartCommand, call: Callable[[StartCommand], str], written: Container[StartCommand]) -> SentCommand:
    why = _PDOS_BY_MASTER if command in written else _unsendable(command)
    if why is not None:
        return SentCommand(comment_text(f"{command.words}: left out, {why}"))
    return SentCommand(comment_text(command.words), call(command), c_bytes(command.data))


def _unsendable(command: StartCommand) -> str | None:
    """Why the master cannot send a command, None where it can."""
    if command.complete_access and command.subindex:
        return f"IgH sends complete access from subindex 0 only, and this begins at {command.subindex}"
    return None


def start_mode_remarks(configuration: Configuration) -> Iterator[str]:
    """Modes of drives that neither the master nor the application sets."""
    sent = [command for command in configuration.commands if _is_sent_by_master(command)]
    call = f"{configuration.prefix}_send_so() in SAFE-OP"
    yield from mode_remarks(configuration.modes, sent, configuration.commands, call)


def unsendable_remarks(configuration: Configuration) -> Iterator[str]:
    """Commands that neither the master nor the application sends, but for those on PDOs that the master writes."""
    written = master_written(configuration)
    for command in configuration.commands:
        why = _unsendable(command)
        if why is not None and command not in written:
            yield f"{command.words} is left out: {why}"


def _config_call(command: StartCommand) -> str:
    index, what = f"0x{command.object_index:04x}", "data, sizeof(data)"
    if command.protocol == "SoE":
        return f"ecrt_slave_config_idn(sc, {command.channel}, {index}, {_IDN_STATES[command.transition]}, {what})"
    if command.complete_access:
        return f"ecrt_slave_config_complete_sdo(sc, {index}, {what})"
    return f"ecrt_slave_config_sdo(sc, {index}, 0x{command.subindex:02x}, {what})"


def _run_time_call(command: StartCommand) -> str:
    index, where, what = f"0x{command.object_index:04x}", "master, slave_position", "data, sizeof(data)"
    if command.protocol == "SoE":
        return f"ecrt_master_write_idn({where}, {command.channel}, {index}, {what}, &error_code)"
    if command.complete_access:
        return f"ecrt_master_sdo_download_complete({where}, {index}, {what}, &abort_code)"
    return f"ecrt_master_sdo_download({where}, {index}, 0x{command.subindex:02x}, {what}, &abort_code)"


def off_beat(found: Clocks, cycle_ns: int) -> str:
    """A warning where the master does not find a first SYNC0 at a fixed place of the bus cycle, else empty."""
    step = found.sync0_cycle.plus(found.sync1_delay).in_ns(cycle_ns)
    return _OFF_BEAT if found.sync1_delay.ns and step % cycle_ns else ""
