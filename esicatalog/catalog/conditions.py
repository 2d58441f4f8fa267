"""Parts of the SELECT over devices: an SQL condition, and what to show as evidence for the devices found."""

from collections.abc import Callable
from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog.schema import devices

Evidence = Callable[[sa.Connection, list[int]], dict[int, list[str]]]
"""Texts by row number of the devices asked for."""


class Condition(NamedTuple):
    """One filter: its SQL condition on ``devices``, and what speaks for the devices found."""

    sql: Any
    evidence: Evidence | None = None
    of_one: Any = None
    """The same asked of each device by itself, where ``sql`` makes a list of all devices first."""
    indexed: bool = False
    """An index finds the devices: to find the first ones no others are looked at."""


def with_row(owner: sa.Column[int], *fits: Any, evidence: Evidence) -> Condition:
    """Devices with a row that fits; ``owner`` is the column with the device's number."""
    found = sa.select(owner).where(*fits)
    return Condition(among(found), evidence, found.where(owner == devices.c.id).exists())


def among(device_ids: sa.SelectBase) -> Any:
    """The condition that a device is one of those that a subquery finds.

    Devices are walked in the order in which they are shown, so that a page of a long list costs no more than a page;
    looking every device of the list up in its table takes several times as long as the list itself.
    """
    return tested(devices.c.id).in_(device_ids)


def tested(column: sa.ColumnElement[Any]) -> sa.ColumnElement[Any]:
    """A column whose value is tested on rows found otherwise: no database looks ``column + 0`` up in an index.

    Statistics say how many rows have a value on average; values that matter (0x6040, 0x1018) stand in thousands.
    """
    return column + ("" if isinstance(column.type, sa.String) else 0)


def stated(words: str) -> Evidence:
    """Evidence that is the same for every device found."""
    return lambda connection, ids: {number: [words] for number in ids}


def by_row(query: sa.Select[Any], owner: Any, words: Callable[..., str]) -> Evidence:
    """Evidence from rows (device number, …): ``words`` makes a text of the rest of a row."""

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        found: dict[int, list[str]] = {}
        for number, *facts in connection.execute(query.where(owner.in_(ids))):
            found.setdefault(number, []).append(words(*facts))
        return found

    return evidence
