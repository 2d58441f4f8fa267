"""What a user chooses: PDOs and their entries, modules, OpMode, cycle, names and the place on the bus."""

from collections.abc import Mapping
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.identity import MAX_INDEX, UINT32_MAX, ModuleChoice, parse_number, parse_object

DEFAULT_CYCLE_NS = 1_000_000
_UINT16_MAX = 0xFFFF


class PdoChoice(NamedTuple):
    """A PDO to assign. ``entries`` are (index, subindex) in their new order, empty = all as described."""

    pdo_index: int
    entries: tuple[tuple[int, int], ...] = ()


class Choice(NamedTuple):
    """Everything that can be chosen for one device."""

    pdos: tuple[PdoChoice, ...] = ()
    """Empty = the default assignment; a SyncManager that none of them goes to keeps its default one."""
    modules: Mapping[int, ModuleChoice] = {}
    """By slot number; other slots keep their default module."""
    op_mode: str | None = None
    """Name or position (from 0, ``#1`` where a name is a number) of the OpMode; None = the default one."""
    cycle_ns: int | None = None
    """Bus cycle; None = :data:`DEFAULT_CYCLE_NS`, or the cycle that the OpMode fixes where that would drift."""
    name: str | None = None
    """Prefix of all generated names; None = made from the device type."""
    alias: int = 0
    """Configured station alias; 0 = the position counts from the first slave."""
    position: int = 0
    """Ring position, or the number of slaves behind the one with the alias."""


PARAMETERS = {field: field.replace("_", "-") for field in Choice._fields} | {"pdos": "pdo", "modules": "module"}
"""What the fields of a :class:`Choice` are called where they are given as texts; options have two hyphens before it."""
_CONTENT = ("pdos", "modules", "op_mode")
HEEDED: Mapping[str, tuple[str, ...]] = {
    "igh": Choice._fields,
    "soem": (*_CONTENT, "cycle_ns", "name"),
    "pysoem": (*_CONTENT, "cycle_ns", "name"),
    "ros2": Choice._fields,
    # An alias is heeded by a refusal that says how this driver finds slaves.
    "linuxcnc": Choice._fields,
    "cstruct": (*_CONTENT, "position"),
    "sii": (),
    "esi": (),
}
"""The fields of a :class:`Choice` that a target heeds, by its name; others are not offered for it, and refused."""


def check_numbers(choice: Choice) -> None:
    """Raise :class:`InputError` for a bus cycle or a place on the bus that no master can have."""
    if choice.cycle_ns is not None and not 0 < choice.cycle_ns <= UINT32_MAX:
        raise InputError(f"a bus cycle of {choice.cycle_ns} ns cannot be; give 1 to {UINT32_MAX} ns")
    for what, number in (("alias", choice.alias), ("position", choice.position)):
        if not 0 <= number <= _UINT16_MAX:
            raise InputError(f"{what} {number} is no 16 bit number")


def parse_pdo_choice(text: str) -> tuple[PdoChoice, ...]:
    """PDOs written ``0x1600,0x1A00``; with chosen entries ``0x1A00=0x6041+0x6064+0x60FE:1``.

    Raises :class:`InputError`.
    """
    chosen = tuple(_parse_pdo(part) for part in text.split(","))
    indices = [item.pdo_index for item in chosen]
    for index in indices:
        if indices.count(index) > 1:
            raise InputError(f"PDO 0x{index:04X} is chosen twice")
    return chosen


def _parse_pdo(text: str) -> PdoChoice:
    index, equals, entries = text.partition("=")
    mapped = [parse_object(entry) for entry in entries.split("+")] if equals else []
    return PdoChoice(
        parse_number(index, "PDO index", MAX_INDEX),
        tuple((entry_index, subindex or 0) for entry_index, subindex in mapped),
    )
