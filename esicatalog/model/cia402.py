"""CiA 402 modes of operation: codes, bits of 0x6502, setpoints, companions, and how names spell them.

The table of ESI-FACTS section 16: bit b of 0x6502 is mode code b + 1.
"""

import re
from functools import lru_cache
from typing import NamedTuple

AXIS_STEP = 0x800
"""Index distance between two axes of one device."""
PROFILE_AREA = 0x6000
"""Where the objects of the first axis begin."""
CONTROLWORD, STATUSWORD = 0x6040, 0x6041
MODES_OF_OPERATION, MODES_DISPLAY = 0x6060, 0x6061
SUPPORTED_DRIVE_MODES = 0x6502
MAX_AXES = 8
MODES_OF_OPERATION_OF_AXES = range(MODES_OF_OPERATION, MODES_OF_OPERATION + MAX_AXES * AXIS_STEP, AXIS_STEP)
"""Where 0x6060 lies, axis by axis."""
CIA402 = "CiA 402"
"""The drive system in words, apart from others that have modes of their own."""


class DriveMode(NamedTuple):
    """A mode of operation. ``companions`` are the objects that only its profile generator needs."""

    name: str
    code: int
    setpoints: tuple[int, ...]
    """The objects that the master writes each cycle; it has to write all of them."""
    companions: tuple[int, ...] = ()
    cyclic: bool = False

    @property
    def bit(self) -> int:
        """Its bit in 0x6502."""
        return self.code - 1


DRIVE_MODES: dict[str, DriveMode] = {
    mode.name: mode
    for mode in (
        DriveMode("PP", 1, (0x607A,), (0x6081, 0x6083, 0x6084)),
        DriveMode("VL", 2, (0x6042,), (0x6046, 0x6048, 0x6049)),
        DriveMode("PV", 3, (0x60FF,), (0x6083, 0x6084)),
        DriveMode("TQ", 4, (0x6071,), (0x6087, 0x6088)),
        DriveMode("HM", 6, (), (0x6098, 0x6099, 0x609A)),
        DriveMode("IP", 7, (0x60C1,), (0x60C0,)),
        DriveMode("CSP", 8, (0x607A,), cyclic=True),
        DriveMode("CSV", 9, (0x60FF,), cyclic=True),
        DriveMode("CST", 10, (0x6071,), cyclic=True),
        DriveMode("CSTCA", 11, (0x6071, 0x60EA), cyclic=True),
    )
}
MODE_BY_CODE = {mode.code: mode for mode in DRIVE_MODES.values()}
STANDARD_BITS = 0x7FF
"""Bits of 0x6502 that the profile defines; 16 to 31 are the manufacturer's."""

PROFILE_AND_CYCLIC: dict[int, tuple[DriveMode, DriveMode]] = {
    0x607A: (DRIVE_MODES["PP"], DRIVE_MODES["CSP"]),
    0x60FF: (DRIVE_MODES["PV"], DRIVE_MODES["CSV"]),
    0x6071: (DRIVE_MODES["TQ"], DRIVE_MODES["CST"]),
}
"""A setpoint tells the quantity, not whether the drive or the master makes the profile."""
SINGLE_SETPOINTS = {0x6042: DRIVE_MODES["VL"], 0x60C1: DRIVE_MODES["IP"]}

_TOKENS = {
    "pp": "PP",
    "pv": "PV",
    "pt": "TQ",
    "tq": "TQ",
    "vl": "VL",
    "hm": "HM",
    "ip": "IP",
    "csp": "CSP",
    "csv": "CSV",
    "cst": "CST",
    "cstca": "CSTCA",
}
_AMBIGUOUS = {"ip", "vl", "hm", "pt", "pp"}
"""Tokens that also mean other things (an IP address); they count beside another mode only."""
_QUANTITIES = {"position": ("PP", "CSP"), "velocity": ("PV", "CSV"), "speed": ("PV", "CSV"), "torque": ("TQ", "CST")}
_CYCLIC = r"\bcyclic (?:synchron\w*|sync)? ?"
_WITH_ANGLE = r"(?: mode)? ?(?:(?:with )?comm\w* angle\b|\(? ?cstca\b)"
_PHRASES = [
    (re.compile(pattern, re.IGNORECASE), mode)
    for pattern, mode in (
        (rf"{_CYCLIC}torque{_WITH_ANGLE}", "CSTCA"),
        *((rf"{_CYCLIC}{word}\b", cyclic) for word, (_, cyclic) in _QUANTITIES.items()),
        *((rf"\bprofiled? {word}\b", profile) for word, (profile, _) in _QUANTITIES.items()),
        (r"\binterpolat\w* position\b", "IP"),
        (r"\bhoming mode\b", "HM"),
        *((rf"\b{word} mode ?\( ?dc ?\)", cyclic) for word, (_, cyclic) in _QUANTITIES.items()),
    )
]
"""Names of modes in words; one that contains another comes first, as that of CSTCA does with that of CST."""
_BLANKS = re.compile(r"[\s_.-]+")
"""Blanks, what vendors write in place of them, and the end of ``Sync.``."""
_DENIAL = re.compile(
    r"\b(?:reserved|unsupported|unused|unavailable|n ?/ ?a|n a"
    r"|not (?:\w+ )?(?:support\w*|used|available|implemented|allowed|possible|permitted|applicable)"
    rf"|(?:no|not|without|except) (?:{'|'.join(_TOKENS)}))\b",
    re.IGNORECASE,
)
_FILLERS = ("mode", "does", "is")
_WORD = re.compile(r"[A-Za-z0-9]+")
_NOT_A_MODE = re.compile(r"\bcsv ?(?:file|export|import|format|table)s?\b", re.IGNORECASE)


def _cut_phrases(text: str) -> tuple[set[str], str]:
    """The modes that a text names in words, and what else it says: no shorter name is found in one that was cut out."""
    found = set()
    for pattern, mode in _PHRASES:
        text, times = pattern.subn(" ", text)
        if times:
            found.add(mode)
    return found, text


@lru_cache(10_000)
def named_modes(text: str) -> frozenset[str]:
    """Modes that a name spells out, on word boundaries: ``Axis (csv,csp,cst)``, ``Cyclic velocity mode``.

    The forms of ESI-FACTS section 16; ``_``, ``-`` and ``.`` stand for blanks.
    """
    found, left = _cut_phrases(_NOT_A_MODE.sub(" ", _BLANKS.sub(" ", text)))
    tokens = {word.lower() for word in _WORD.findall(left)} & _TOKENS.keys()
    clear = tokens - _AMBIGUOUS
    if clear or found or len(tokens) > 1:
        found |= {_TOKENS[token] for token in tokens}
    return frozenset(found)


def claimed_modes(name: str) -> frozenset[str]:
    """Modes that a name spells out and claims; none where it denies any, for which ones it means is for people to read.

    ``Axis (csp only, csv not supported)`` names two modes.
    """
    return frozenset() if denies(name) else named_modes(name)


@lru_cache(10_000)
def denies_all(text: str) -> bool:
    """Whether all that a text says beside the name of a mode is that there is none: ``csv (not supported)``.

    In ``Homing mode (methods 1 to 14 not supported)`` something else is denied.
    """
    _, left = _cut_phrases(_BLANKS.sub(" ", text))
    words = [word.lower() for word in _WORD.findall(_DENIAL.sub(" ", left))]
    return denies(text) and all(word in _TOKENS or word in _FILLERS or word.isdigit() for word in words)


@lru_cache(10_000)
def denies(text: str) -> bool:
    """Whether the text of a value says that there is nothing behind it: ``reserved``, ``not supported``, ``n/a``."""
    return _DENIAL.search(_BLANKS.sub(" ", text)) is not None
