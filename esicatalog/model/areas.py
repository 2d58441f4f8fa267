"""Areas of memory that should lie beside each other."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple


class Area(NamedTuple):
    """From ``start`` to before ``end``; ``number`` is the position of what takes it."""

    start: int
    end: int
    number: int


def overlaps(areas: Iterable[Area]) -> Iterator[tuple[Area, Area]]:
    """Every area that begins within one before it, behind the one of those that reaches furthest."""
    furthest: Area | None = None
    for area in sorted(areas):
        if furthest is not None and area.start < furthest.end:
            yield furthest, area
        if furthest is None or area.end > furthest.end:
            furthest = area
