"""Parts of the SELECT over devices: an SQL condition, and what to show as evidence for the devices found."""

from collections.abc import Callable
from typing import Any, NamedTuple

import sqlalchemy as sa

Evidence = Callable[[sa.Connection, list[int]], dict[int, list[str]]]
"""Texts by row number of the devices asked for."""


class Condition(NamedTuple):
    """One filter: its SQL condition on ``devices``, and what speaks for the devices found."""

    sql: Any
    evidence: Evidence | None = None


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
