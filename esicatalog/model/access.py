"""Access rights of object entries: words of the ESI file to the CoE access word (ETG.1000.6, ETG.2000)."""

import re

from esicatalog.esi.records.dictionary import Flags

PREOP, SAFEOP, OP = 1, 2, 4
ALL_STATES = PREOP | SAFEOP | OP

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
    access = (flags.access or "ro").lower()
    old = _OLD_ACCESS.fullmatch(access)
    if old:
        return int(old[1])
    return _allowed(flags.read_restrictions) if _READABLE.get(access, True) else 0


def writable_states(flags: Flags) -> int:
    """States in which the entry can be written: bit 0 PreOP, 1 SafeOP, 2 OP."""
    access = (flags.access or "ro").lower()
    old = _OLD_ACCESS.fullmatch(access)
    if old:
        return int(old[2])
    return _allowed(flags.write_restrictions) if _WRITABLE.get(access, False) else 0


def _allowed(restrictions: str | None) -> int:
    return _STATES.get((restrictions or "").lower(), ALL_STATES)


def access_word(flags: Flags, pdo_mapping: str | None) -> int:
    """The CoE access word of an entry with these flags."""
    word = readable_states(flags) | writable_states(flags) << 3
    if pdo_mapping and "R" in pdo_mapping:
        word |= RX_MAPPABLE
    if pdo_mapping and "T" in pdo_mapping:
        word |= TX_MAPPABLE
    if flags.backup == 1:
        word |= BACKUP
    if flags.setting == 1:
        word |= SETTING
    return word
