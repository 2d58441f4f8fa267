"""What a SOEM application writes to a device before it becomes SAFE-OP, at later transitions, and for its clocks."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.export.clocks import Clocks
from esicatalog.export.configuration import Configuration
from esicatalog.export.esc_registers import (
    PDI_WATCHDOG,
    PROCESS_DATA_WATCHDOG,
    WATCHDOG_DIVIDER,
    SettableRegisters,
    settable,
)
from esicatalog.export.init_cmds import StartCommand
from esicatalog.export.mode_commands import mode_remarks
from esicatalog.export.pdo_objects import PdoObject
from esicatalog.model.start_up import BEFORE_SAFE_OP

_SYNC0_ACTIVE, _SYNC01_ACTIVE = 0x03, 0x07
"""What SOEM writes to register 0x0981 for SYNC0 alone and for both; to 0x0980 it writes 0."""
_SYNC_REGISTERS = 0x0980
_LAST_COMPLETE_SUBINDEX = 1
HOOK_REGISTERS = SettableRegisters((WATCHDOG_DIVIDER, PDI_WATCHDOG, PROCESS_DATA_WATCHDOG))
"""Those that the hook writes."""


class RegisterWrite(NamedTuple):
    """A value for a register of the slave controller."""

    register: int
    data: bytes
    words: str


class SoemClocks(NamedTuple):
    """How SOEM sets an AssignActivate: with a call for SYNC0 or for both signals, and with a write behind it."""

    has_sync0_call: bool
    has_sync01_call: bool
    written: RegisterWrite | None
    """What SOEM leaves otherwise, None when its own values are right."""


def hook_commands(configuration: Configuration) -> Iterator[StartCommand | RegisterWrite]:
    """InitCmds of IP and PS, watchdogs, then the PDO configuration where the device declares that it takes one.

    The hook runs in PRE-OP: the first chance for commands of IP, the right one for those of PS. Nothing is sent twice.
    """
    own = tuple(_pdo_configuration(configuration))
    written = {command.object_index for command in own}
    for command in _own_commands(configuration):
        if command.transition in BEFORE_SAFE_OP and not (
            command.writes_pdo_configuration and command.object_index in written
        ):
            yield command
    yield from _watchdogs(configuration.subject.device)
    yield from own


def later_commands(configuration: Configuration) -> Iterator[StartCommand]:
    """Commands of the transitions after the hook."""
    return (command for command in _own_commands(configuration) if command.transition not in BEFORE_SAFE_OP)


def _own_commands(configuration: Configuration) -> Iterator[StartCommand]:
    """InitCmds without those that would make the process image another one than the structures here."""
    return (command for command in _fitting(configuration) if not _begins_elsewhere(command))


def _fitting(configuration: Configuration) -> Iterator[StartCommand]:
    return (command for command in configuration.commands if not configuration.is_contradicted(command))


def _begins_elsewhere(command: StartCommand) -> bool:
    """Whether SOEM would write it to other subindices: it takes 1 for a higher one with complete access."""
    return command.complete_access and command.subindex > _LAST_COMPLETE_SUBINDEX


def command_remarks(configuration: Configuration, program: str) -> Iterator[str]:
    """InitCmds that are left out for what SOEM would make of them."""
    for command in filter(_begins_elsewhere, _fitting(configuration)):
        yield (
            f"{command.words} is left out: {program} sends complete access from subindex 0 or 1 only, and this begins "
            f"at {command.subindex}"
        )


def start_mode_remarks(configuration: Configuration, function: str) -> Iterator[str]:
    """Modes of drives that neither the hook sets nor the function for commands of SO."""
    sent = [command for command in hook_commands(configuration) if isinstance(command, StartCommand)]
    later = tuple(later_commands(configuration))
    yield from mode_remarks(configuration.modes, sent, later, f"{function}() in SAFE-OP")


def soem_clocks(found: Clocks) -> SoemClocks:
    """Calls and register writes for the clocks of an OpMode."""
    low, high = found.assign_activate & 0xFF, found.assign_activate >> 8
    has_both = bool(found.signals.sync1)
    has_sync0 = bool(found.signals.sync0) and not has_both
    active = _SYNC01_ACTIVE if has_both else _SYNC0_ACTIVE
    data = b""
    if not (has_both or has_sync0) or high != active:
        data = bytes((low, high))
    elif low:
        data = bytes((low,))
    written = RegisterWrite(_SYNC_REGISTERS, data, f"AssignActivate 0x{found.assign_activate:04X}") if data else None
    return SoemClocks(has_sync0, has_both, written)


def _watchdogs(device: Device) -> Iterator[RegisterWrite]:
    for item in settable(device, HOOK_REGISTERS):
        yield RegisterWrite(item.register, item.value.to_bytes(2, "little"), item.words)


def _pdo_configuration(configuration: Configuration) -> Iterator[StartCommand]:
    """Clear the assignments, write mappings that may be written, assign."""
    rewritten, sync_managers = configuration.rewritten, configuration.sync_managers
    assigned = [
        (sm.assignment, sm.pdos)
        for sm in sync_managers
        if sm.assignment is not None and sm.assignment.object_index in rewritten
    ]
    for assignment, _ in assigned:
        yield _object(assignment.object_index, 0, b"\0", "clear the assignment")
    for pdo in (pdo for sm in sync_managers for pdo in sm.pdos):
        if pdo.mapping is not None and pdo.pdo_index in rewritten:
            yield _object(pdo.pdo_index, 0, b"\0", f"clear the mapping of {pdo.direction} {pdo.name}")
            yield from _values(pdo.mapping, [entry.comment for entry in pdo.entries], "number of entries")
    for assignment, pdos in assigned:
        yield from _values(assignment, [f"{pdo.direction} {pdo.name}" for pdo in pdos], "number of PDOs")


def _values(written: PdoObject, names: Sequence[str], of_count: str) -> Iterator[StartCommand]:
    for subindex, (value, name) in enumerate(zip(written.values, names, strict=True), 1):
        yield _object(written.object_index, subindex, value.to_bytes(written.value_bytes, "little"), name)
    yield _object(written.object_index, 0, bytes([len(written.values)]), of_count)


def _object(index: int, subindex: int, data: bytes, comment: str) -> StartCommand:
    return StartCommand("PS", "CoE", index, subindex, data, comment=comment)
