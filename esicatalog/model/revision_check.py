"""Which description fits a device found on the bus: the rules of CheckRevisionNo, and a ranking by revision.

CheckRevisionNo (ESI-FACTS section 3.1) says what a *configured* description accepts as *found* revision; LW are the
low 16 bits, HW the high 16 bits. Masters offer the same tests at start-up.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

_ABOVE = 1 << 32
"""Puts what is newer than the device behind everything older."""
EXACT, ACCEPTED, OLDER, NEWER, PRODUCT = "exact", "accepted", "older", "newer", "product"


class Described(NamedTuple):
    """A described revision of a product."""

    revision_no: int | None
    check_revision_no: str | None
    hidden: bool


class Ranked(NamedTuple):
    """A described revision with the rule by which it comes into question; lower ``order`` fits better."""

    order: tuple[int, bool, int]
    match: str
    position: int
    reason: str


def _low(revision_no: int) -> int:
    return revision_no & 0xFFFF


def _high(revision_no: int) -> int:
    return revision_no >> 16


CHECK_REVISION_NO: dict[str, Callable[[int, int], bool]] = {
    "NONE": lambda found, configured: True,
    "EQ": lambda found, configured: found == configured,
    "EQ_OR_G": lambda found, configured: found >= configured,
    "LW_EQ": lambda found, configured: _low(found) == _low(configured),
    "LW_EQ_HW_EQ_OR_G": lambda found, configured: _low(found) == _low(configured) and _high(found) >= _high(configured),
    "HW_EQ": lambda found, configured: _high(found) == _high(configured),
    "HW_EQ_LW_EQ_OR_G": lambda found, configured: _high(found) == _high(configured) and _low(found) >= _low(configured),
}
"""Found and configured revision → accepted."""


def accepts(check_revision_no: str | None, found: int, configured: int) -> bool:
    """Whether a description with this CheckRevisionNo accepts a found revision; without one it says nothing."""
    test = CHECK_REVISION_NO.get(check_revision_no or "")
    return test is not None and test(found, configured)


def rank(found: int | None, described: Sequence[Described]) -> list[Ranked]:
    """The described revisions of a product, the one that fits a found revision best first.

    The order: exact; accepted by its own CheckRevisionNo, nearest below first; older with the same low word, highest
    first; older, highest first; newer, nearest first; without revision. At every step but the first visible ones come
    before hidden ones. Without a found revision: the latest visible.
    """
    if found is None:
        return sorted(_latest(position, item) for position, item in enumerate(described))
    return sorted(_ranked(position, item, found) for position, item in enumerate(described))


def _latest(position: int, item: Described) -> Ranked:
    revision = item.revision_no
    if revision is None:
        return Ranked((1, item.hidden, 0), PRODUCT, position, "no revision asked; the description names none")
    words = "the latest one, which its vendor hides" if item.hidden else "the latest one that its vendor does not hide"
    return Ranked((0, item.hidden, -revision), PRODUCT, position, f"no revision asked; 0x{revision:08x} is {words}")


def _ranked(position: int, item: Described, found: int) -> Ranked:
    configured, hidden = item.revision_no, item.hidden
    if configured is None:
        return Ranked((5, hidden, 0), PRODUCT, position, _why("its description names no revision", item))
    if configured == found:
        return Ranked((0, False, 0), EXACT, position, "the catalog describes exactly this revision")
    shown = f"0x{configured:08x}"
    distance = abs(configured - found)
    if accepts(item.check_revision_no, found, configured):
        which = "" if configured < found else "; it is newer than the device"
        because = f"{shown} accepts it by its CheckRevisionNo {item.check_revision_no}{which}"
        return Ranked(
            (1, hidden, distance if configured < found else distance + _ABOVE), ACCEPTED, position, _why(because, item)
        )
    if configured < found:
        if _low(configured) == _low(found):
            because = f"{shown} is older with the same low word"
            return Ranked((2, hidden, distance), OLDER, position, _why(because, item))
        return Ranked((3, hidden, distance), OLDER, position, _why(f"{shown} is the nearest older one", item))
    return Ranked((4, hidden, distance), NEWER, position, _why(f"only newer ones are described, next {shown}", item))


def _why(because: str, item: Described) -> str:
    return f"no exact ESI; nearest shown because {because}" + (" (hidden by its vendor)" if item.hidden else "")
