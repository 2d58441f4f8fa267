"""What a SOEM application writes to a device before it becomes SAFE-OP, at later transitions, and for its clocks."""

from collections.abc import Iterator
from typing import NamedTuple

from esicatalog.export.clocks import Clocks
from esicatalog.export.configuration import AssignedPdo, Configuration
from esicatalog.export.esc_registers import (
    PDI_WATCHDOG,
    PROCESS_DATA_WATCHDOG,
    WATCHDOG_DIVIDER,
    EscRegister,
    left_out,
    settable,
)
from esicatalog.export.init_cmds import StartCommand
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS

_HOOK_TRANSITIONS = ("IP", "PS")
"""The hook runs in PRE-OP: the first chance for commands of IP, the right one for those of PS."""
_MAX_COUNT, _MAX_BIT_LENGTH = 254, 255
"""Subindices of a PDO assignment or mapping, and bits that a mapping can express."""


_SYNC0_ACTIVE, _SYNC01_ACTIVE = 0x03, 0x07
"""What SOEM writes to register 0x0981 for SYNC0 alone and for both; to 0x0980 it writes 0."""
_SYNC_REGISTERS = 0x0980


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
    """InitCmds of IP and PS, watchdogs, then the PDO configuration where the device declares that it takes one."""
    own = tuple(_pdo_configuration(configuration))
    written = {command.object_index for command in own}
    for command in configuration.commands:
        if command.transition in _HOOK_TRANSITIONS and not (
            command.writes_pdo_configuration and command.object_index in written
        ):
            yield command
    yield from _watchdogs(configuration)
    yield from own


def later_commands(configuration: Configuration) -> Iterator[StartCommand]:
    """Commands of the transitions after the hook."""
    return (command for command in configuration.commands if command.transition not in _HOOK_TRANSITIONS)


def command_words(command: StartCommand | RegisterWrite) -> str:
    """What a command does, for a comment."""
    if isinstance(command, RegisterWrite):
        return command.words
    return f"{command.transition} {command.place} {command.comment}".strip()


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


def _watchdogs(configuration: Configuration) -> Iterator[RegisterWrite]:
    for item in _watchdog_registers(configuration):
        yield RegisterWrite(item.register, item.value.to_bytes(2, "little"), item.words)


def _watchdog_registers(configuration: Configuration) -> tuple[EscRegister, ...]:
    return settable(configuration.subject.device, (WATCHDOG_DIVIDER, PDI_WATCHDOG, PROCESS_DATA_WATCHDOG))


def register_remarks(configuration: Configuration, program: str) -> Iterator[str]:
    """Registers that the hook does not write."""
    return left_out(configuration.subject.device, program, _watchdog_registers(configuration))


def _pdo_configuration(configuration: Configuration) -> Iterator[StartCommand]:
    """Clear the assignments, write mappings that may be written, assign."""
    mailbox = configuration.subject.device.mailbox
    if mailbox is None or not mailbox.coe or not (mailbox.coe_pdo_assign or mailbox.coe_pdo_config):
        return
    assigned = [
        (PDO_ASSIGNMENTS.start + sm.number, sm.pdos)
        for sm in configuration.sync_managers
        if sm.pdos and PDO_ASSIGNMENTS.start + sm.number in PDO_ASSIGNMENTS and len(sm.pdos) <= _MAX_COUNT
    ]
    if mailbox.coe_pdo_assign:
        for index, _ in assigned:
            yield _object(index, 0, b"\0", "clear the assignment")
    if mailbox.coe_pdo_config:
        for _, pdos in assigned:
            for pdo in pdos:
                yield from _mapping(pdo)
    if mailbox.coe_pdo_assign:
        for index, pdos in assigned:
            for subindex, pdo in enumerate(pdos, 1):
                yield _object(index, subindex, pdo.pdo_index.to_bytes(2, "little"), f"{pdo.direction} {pdo.name}")
            yield _object(index, 0, bytes([len(pdos)]), "number of PDOs")


def _mapping(pdo: AssignedPdo) -> Iterator[StartCommand]:
    can_be_written = 0 < len(pdo.entries) <= _MAX_COUNT and all(e.bit_length <= _MAX_BIT_LENGTH for e in pdo.entries)
    if pdo.fixed or not can_be_written:
        return
    yield _object(pdo.pdo_index, 0, b"\0", f"clear the mapping of {pdo.direction} {pdo.name}")
    for subindex, entry in enumerate(pdo.entries, 1):
        value = entry.entry_index << 16 | entry.subindex << 8 | entry.bit_length
        yield _object(pdo.pdo_index, subindex, value.to_bytes(4, "little"), entry.name or "gap")
    yield _object(pdo.pdo_index, 0, bytes([len(pdo.entries)]), "number of entries")


def _object(index: int, subindex: int, data: bytes, comment: str) -> StartCommand:
    return StartCommand("PS", "CoE", index, subindex, data, comment=comment)
