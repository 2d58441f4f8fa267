"""The letters of Device/@Physics: what each says of a port (ETG.2000 PhysicsType, ESI-FACTS section 4)."""

from typing import NamedTuple


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


def has_e_bus(physics: str) -> bool:
    """Whether a port is on the E-bus; small letters are taken for what they mean."""
    return any(kind is not None and kind.is_e_bus for kind in map(port_kind, physics.upper()))
