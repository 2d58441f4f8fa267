"""Access rights of object entries: words of the ESI file to the CoE access word and back (ETG.1000.6, ETG.2000)."""

import functools
import re

from esicatalog.esi.records.dictionary import Flags

PREOP, SAFEOP, OP = 1, 2, 4
ALL_STATES = PREOP | SAFEOP | OP
STATE_WORDS = "PREOP, SAFEOP, OP"
"""In the order of :func:`access_text`."""

_WRITE_SHIFT = 3
"""The access word has a bit a state for reading, and above them one a state for writing."""
READ, WRITE = ALL_STATES, ALL_STATES << _WRITE_SHIFT
"""In all states, as bits of an access word."""

_STATES = {
    "preop": PREOP,
    "preop_safeop": PREOP | SAFEOP,
    "preop_op": PREOP | OP,
    "safeop": SAFEOP,
    "safeop_op": SAFEOP | OP,
    "op": OP,
}
"""ReadRestrictions and WriteRestrictions name the states in which access is allowed."""

_READABLE = {"ro": True, "rw": True, "wo": False}
_WRITABLE = {"ro": False, "rw": True, "wo": True}
_OLD_ACCESS = re.compile(r"r([0-7])w([0-7])")
"""Access of files before schema 1.2, e.g. ``r3w7``: one bit a state, as in the access word."""

RX_MAPPABLE, TX_MAPPABLE, BACKUP, SETTING = 1 << 6, 1 << 7, 1 << 8, 1 << 9


def normalised_pdo_mapping(text: str | None) -> str | None:
    """``R``, ``T`` or ``RT`` whatever the order and case of letters in the file; None when not mappable."""
    letters = (text or "").upper()
    return ("R" if "R" in letters else "") + ("T" if "T" in letters else "") or None


def readable_states(flags: Flags) -> int:
    """States in which the entry can be read: bit 0 PreOP, 1 SafeOP, 2 OP."""
    return _states(flags.access, flags.read_restrictions, 1)


def writable_states(flags: Flags) -> int:
    """States in which the entry can be written: bit 0 PreOP, 1 SafeOP, 2 OP."""
    return _states(flags.access, flags.write_restrictions, 2)


@functools.lru_cache(4096)
def _states(access_text: str | None, restrictions: str | None, digit: int) -> int:
    """States in which reading (``digit`` 1 of an old access word) or writing (2) is allowed; few texts, many flags."""
    access = (access_text or "ro").lower()
    old = _OLD_ACCESS.fullmatch(access)
    if old:
        return int(old[digit])
    allowed = _READABLE.get(access, True) if digit == 1 else _WRITABLE.get(access, False)
    return _STATES.get((restrictions or "").lower(), ALL_STATES) if allowed else 0


def access_word(flags: Flags, pdo_mapping: str | None) -> int:
    """The CoE access word of an entry with these flags."""
    word = readable_states(flags) | writable_states(flags) << _WRITE_SHIFT
    if pdo_mapping and "R" in pdo_mapping:
        word |= RX_MAPPABLE
    if pdo_mapping and "T" in pdo_mapping:
        word |= TX_MAPPABLE
    if flags.backup == 1:
        word |= BACKUP
    if flags.setting == 1:
        word |= SETTING
    return word


def rights(word: int) -> int:
    """The bits of an access word that say in which states an entry is read and written."""
    return word & (READ | WRITE)


def states_to_write(word: int) -> int:
    """The states in which an access word lets an entry be written: bit 0 PreOP, 1 SafeOP, 2 OP."""
    return (word & WRITE) >> _WRITE_SHIFT


def access_text(word: int) -> str:
    """An access word as masters print it: read and write in PREOP, SAFEOP and OP, ``rwrwr-``."""
    return "".join(
        ("r" if word & state else "-") + ("w" if states_to_write(word) & state else "-")
        for state in (PREOP, SAFEOP, OP)
    )
