"""Initial values of registers of the slave controller, which a description gives below ESC (ESI-FACTS section 13)."""

from collections.abc import Iterator
from typing import NamedTuple

from esicatalog.esi.records.device import Device

WATCHDOG_DIVIDER, PDI_WATCHDOG, PROCESS_DATA_WATCHDOG = 0x0400, 0x0410, 0x0420
_REGISTERS = (
    (0x0108, "esc_reg0108", "Physical read/write offset"),
    (WATCHDOG_DIVIDER, "esc_reg0400", "Watchdog divider"),
    (PDI_WATCHDOG, "esc_reg0410", "PDI watchdog"),
    (PROCESS_DATA_WATCHDOG, "esc_reg0420", "Process data watchdog"),
)
_MAX_VALUE = 0xFFFF


class EscRegister(NamedTuple):
    """A register of 16 bits with the value that the description gives."""

    register: int
    value: int
    words: str


class SettableRegisters(NamedTuple):
    """The registers that a program can write, and the lowest value that it writes."""

    registers: tuple[int, ...]
    lowest: int = 0


NO_REGISTERS = SettableRegisters(())


def esc_registers(device: Device) -> Iterator[EscRegister]:
    """The values of a description in the order of their registers."""
    for register, field, words in _REGISTERS:
        value = getattr(device, field)
        if value is not None:
            yield EscRegister(register, value, f"{words}, register 0x{register:04X}")


def settable(device: Device, known: SettableRegisters) -> tuple[EscRegister, ...]:
    """The values of a description that a program can write."""
    return tuple(
        item
        for item in esc_registers(device)
        if item.register in known.registers and known.lowest <= item.value <= _MAX_VALUE
    )


def register_remarks(device: Device, program: str, known: SettableRegisters) -> Iterator[str]:
    """Remarks about the values that a program cannot write."""
    written = settable(device, known)
    for item in esc_registers(device):
        if item not in written:
            yield f"{item.words}: the value {item.value} is left out, {program} does not set it"
