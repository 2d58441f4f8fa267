"""SQL functions for what people write, and bounds for all functions."""

import sqlite3
from collections.abc import Callable
from functools import partial
from typing import Any

from esicatalog.catalog.device_filter import MODES, one_of
from esicatalog.catalog.filter_texts import parse_flag, parse_vendor
from esicatalog.errors import InputError
from esicatalog.identity import MAX_INDEX, parse_number, parse_subindex
from esicatalog.model.device_words import MAILBOX_PROTOCOLS

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


def read_subindex(text: object) -> int | None:
    """The subindex in ``0x0B``, ``0B`` or ``#x0B``, as the command reads it; NULL for what it refuses."""
    try:
        return parse_subindex(str(text))
    except InputError:
        return None


_PARAMETERS: dict[str, Callable[[str], Any]] = {
    **{name: partial(parse_number, what=name) for name in ("vendor", "product", "revision", "profile")},
    "maker": parse_vendor,
    "index": partial(parse_number, what="index", limit=MAX_INDEX),
    "subindex": parse_subindex,
    "mode": lambda text: one_of("mode", text.strip().upper(), MODES),
    "protocol": lambda text: one_of("protocol", text.strip().lower(), MAILBOX_PROTOCOLS),
    "severity": lambda text: one_of("severity", text.upper(), ("E", "W", "I")),
    **dict.fromkeys(("strict", "include_hidden"), parse_flag),
}
"""What reads a parameter of canned queries as the command does. Each raises :class:`InputError`."""


def refusal(*parameters: object) -> str | None:
    """Why the first of some parameters, given as name, text, name, text …, cannot be read; NULL when all can be.

    Empty ones are not given.
    """
    for name, given in zip(parameters[::2], parameters[1::2], strict=True):
        try:
            if given not in (None, ""):
                _PARAMETERS[str(name)](str(given))
        except InputError as error:
            return str(error)
    return None


def add_functions(connection: sqlite3.Connection) -> None:
    """Have a connection know the functions."""
    connection.create_function("parse_hex", 1, parse_hex, deterministic=True)
    connection.create_function("hex0x", 1, hex0x, deterministic=True)
    connection.create_function("hex0x", 2, hex0x, deterministic=True)
    connection.create_function("read_subindex", 1, read_subindex, deterministic=True)
    connection.create_function("refusal", -1, refusal, deterministic=True)


def bound_work(connection: sqlite3.Connection) -> None:
    """Bound values and patterns: SQLite's time limit ends statements between two functions, not within one."""
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _LARGEST_VALUE_BYTES)
    connection.setlimit(sqlite3.SQLITE_LIMIT_LIKE_PATTERN_LENGTH, _LONGEST_PATTERN)
    connection.setlimit(sqlite3.SQLITE_LIMIT_ATTACHED, 0)
