"""SQL functions for numbers as people write them, and bounds for all functions."""

import sqlite3

from esicatalog.errors import InputError
from esicatalog.identity import parse_number

_LARGEST = 2**63 - 1
_LARGEST_VALUE_BYTES = 8 * 1024 * 1024
"""The largest value of a real catalog, XML of a vendor, has half a megabyte."""
_LONGEST_PATTERN = 1000


def parse_hex(text: object) -> int | None:
    """The number in ``0x1097``, ``#x1097`` or ``4247``; NULL for anything else."""
    try:
        return parse_number(str(text), limit=_LARGEST)
    except InputError:
        return None


def hex0x(number: object, digits: object = 4) -> str | None:
    """A number as ``0x…`` with at least so many digits; NULL for anything but a non-negative integer."""
    if not isinstance(number, int) or not isinstance(digits, int) or number < 0:
        return None
    return f"0x{number:x}" if digits < 1 else f"0x{number:0{min(digits, 16)}x}"


def bound_work(connection: sqlite3.Connection) -> None:
    """Bound values and patterns: SQLite's time limit ends statements between two functions, not within one."""
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _LARGEST_VALUE_BYTES)
    connection.setlimit(sqlite3.SQLITE_LIMIT_LIKE_PATTERN_LENGTH, _LONGEST_PATTERN)
    connection.setlimit(sqlite3.SQLITE_LIMIT_ATTACHED, 0)
