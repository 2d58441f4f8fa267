"""The letters of Device/@Physics: what each says of a port (ETG.2000 PhysicsType, ESI-FACTS section 4)."""

from typing import NamedTuple

from esicatalog.errors import InputError

_SHOWN = 40


class PortKind(NamedTuple):
    """What a letter means."""

    words: str
    sii_code: int
    """In the General category of an EEPROM image (ETG.2010): four bits a port."""
    is_e_bus: bool = False
    is_old: bool = False
    """Whether only schemas before 1.6 have the letter."""


_PORT_KINDS = {
    "Y": PortKind("MII", 1),
    "K": PortKind("E-bus", 3, is_e_bus=True),
    "H": PortKind("MII fast hot connect", 4),
    "B": PortKind("E-bus cable", 2, is_e_bus=True, is_old=True),
    " ": PortKind("unused", 0),
}


def port_kind(letter: str) -> PortKind | None:
    """What a letter in Physics means, None for one that no schema has."""
    return _PORT_KINDS.get(letter)


def checked_physics(text: str) -> str:
    """Ports as people write them, in capitals. Raises :class:`InputError` for a letter that no schema has, and none."""
    physics = text.upper()
    if not physics.strip() or any(letter not in _PORT_KINDS for letter in physics):
        letters = ", ".join(f"{letter} {kind.words}" for letter, kind in _PORT_KINDS.items() if letter.strip())
        raise InputError(f"physics {text[:_SHOWN]!r}: write a letter for each port, e.g. YY: {letters}, blank unused")
    return physics


def has_e_bus(physics: str) -> bool:
    """Whether a port is on the E-bus; small letters are taken for what they mean."""
    return any(kind is not None and kind.is_e_bus for kind in map(port_kind, physics.upper()))
