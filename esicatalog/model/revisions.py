"""Revision numbers: as their vendors print them, which one is meant where none is named, which fits a found device.

CheckRevisionNo says what a *configured* description accepts as *found* revision; LW are the low 16 bits, HW the high
16 bits (ETG.2000), L24 the low 24 bits, H8 the high 8 bits (Beckhoff). Masters offer the same tests at start-up.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from operator import eq, ge
from typing import NamedTuple

from esicatalog.esi.records.device import HideType
from esicatalog.words import hex32

BECKHOFF = 0x00000002
_ABOVE = 1 << 32
"""Puts what is newer than the device behind everything older."""
_LOW_WORD = 0xFFFF
EXACT, ACCEPTED, OLDER, NEWER, PRODUCT = "exact", "accepted", "older", "newer", "product"
EXACT_REASON = "the catalog describes exactly this revision"


def revision_text(vendor_id: int | None, revision_no: int | None) -> str | None:
    """The revision in the vendor's own style, None where none is known.

    Beckhoff prints the high word as description revision (0x00100000 is ``-0016``) behind the low word, the variant
    of the terminal, unless that is zero (0x00110014 is ``-0020-0017``): ESI-FACTS section 3.1. Other vendors count in
    ways of their own.
    """
    if vendor_id != BECKHOFF or revision_no is None:
        return None
    variant, revision = revision_no & 0xFFFF, revision_no >> 16
    return (f"-{variant:04d}" if variant else "") + f"-{revision:04d}"


def latest_revision(described: Iterable[tuple[int | None, bool]]) -> int | None:
    """The highest of the revisions of a product that its vendor does not hide; the highest when all are hidden.

    ``described`` are RevisionNo and whether another description hides it (HideType). None where no RevisionNo is given.
    """
    revisions = list(described)
    visible = [number for number, is_hidden in revisions if not is_hidden] or [number for number, _ in revisions]
    return max((number for number in visible if number is not None), default=None)


def hidden_by(
    product_code: int | None, revision_no: int | None, hide_types: Iterable[HideType]
) -> Iterator[tuple[int, int]]:
    """Product codes and revisions, of the same vendor, that a description of such codes supersedes (HideType).

    A HideType without ProductCode means its own product; one without RevisionNo names nothing, nor does one that names
    its own description.
    """
    for item in hide_types:
        product = item.product_code if item.product_code is not None else product_code
        if product is None or item.revision_no is None or (product, item.revision_no) == (product_code, revision_no):
            continue
        yield product, item.revision_no


class Described(NamedTuple):
    """A described revision of a product."""

    revision_no: int | None
    check_revision_no: str | None
    hidden: bool
    variant: int = 1
    """One revision may have several descriptions, each with a CheckRevisionNo of its own."""


class Ranked(NamedTuple):
    """A described revision with the rule by which it comes into question; lower ``order`` fits better."""

    order: tuple[int, bool, int, int]
    match: str
    position: int
    reason: str


Test = Callable[[int, int], bool]


def _parts(low_bits: int, low: Test, high: Test) -> Test:
    """A test of the low bits and the bits above them."""
    mask = (1 << low_bits) - 1
    return lambda found, configured: (
        low(found & mask, configured & mask) and high(found >> low_bits, configured >> low_bits)
    )


def _any(found: int, configured: int) -> bool:
    return True


CHECK_REVISION_NO: dict[str, Test] = {
    "NONE": _any,
    "EQ": eq,
    "EQ_OR_G": ge,
    "LW_EQ": _parts(16, eq, _any),
    "LW_EQ_HW_EQ_OR_G": _parts(16, eq, ge),
    "HW_EQ": _parts(16, _any, eq),
    "HW_EQ_LW_EQ_OR_G": _parts(16, ge, eq),
    "L24_EQ_H8_EQ_OR_G": _parts(24, eq, ge),
}
"""Found and configured revision → accepted."""


def is_known(check_revision_no: str | None) -> bool:
    """Whether it is known what a CheckRevisionNo accepts, also where there is none."""
    return check_revision_no is None or check_revision_no in CHECK_REVISION_NO


def accepts_revision(check_revision_no: str | None, found: int, configured: int) -> bool:
    """Whether a description with this CheckRevisionNo accepts a found revision; without a known one it says nothing."""
    test = CHECK_REVISION_NO.get(check_revision_no or "")
    return test is not None and test(found, configured)


def rank(found: int | None, described: Sequence[Described]) -> list[Ranked]:
    """The described revisions of a product, the one that fits a found revision best first.

    The order: exact; accepted by its own CheckRevisionNo, nearest below first; older with the same low word, highest
    first; older, highest first; newer, nearest first; without revision. At every step but the first visible ones come
    before hidden ones, and of equal ones the preferred variant. Without a found revision: the latest visible.
    """
    if found is None:
        return sorted(_latest(position, item) for position, item in enumerate(described))
    hidden = [item.revision_no for item in described if item.hidden and item.revision_no is not None]
    return sorted(_ranked(position, item, found, hidden) for position, item in enumerate(described))


def _latest(position: int, item: Described) -> Ranked:
    revision = item.revision_no
    if revision is None:
        words = "no revision asked; the description names none"
        return Ranked((1, item.hidden, 0, item.variant), PRODUCT, position, words)
    words = "the latest one, which its vendor hides" if item.hidden else "the latest one that its vendor does not hide"
    reason = f"no revision asked; {hex32(revision)} is {words}"
    return Ranked((0, item.hidden, -revision, item.variant), PRODUCT, position, reason)


def _ranked(position: int, item: Described, found: int, hidden_revisions: Sequence[int]) -> Ranked:
    configured = item.revision_no
    if configured == found:
        return Ranked((0, False, 0, item.variant), EXACT, position, EXACT_REASON)
    step, distance, match, because = _not_exact(item, found, hidden_revisions)
    hidden = " (hidden by its vendor)" if item.hidden else ""
    reason = f"no exact ESI; nearest shown because {because}{hidden}"
    if not is_known(item.check_revision_no):
        reason += f"; its CheckRevisionNo {item.check_revision_no!r} is not known"
    return Ranked((step, item.hidden, distance, item.variant), match, position, reason)


def _not_exact(item: Described, found: int, hidden_revisions: Sequence[int]) -> tuple[int, int, str, str]:
    """Step, distance, match and why, for another revision than the found one.

    A hidden one that is nearer is described all the same: then the nearest of the others is called that.
    """
    configured = item.revision_no
    if configured is None:
        return 5, 0, PRODUCT, "its description names no revision"
    shown = hex32(configured) + (f"@{item.variant}" if item.variant > 1 else "")
    is_older, distance = configured < found, abs(configured - found)
    if accepts_revision(item.check_revision_no, found, configured):
        which = "" if is_older else "; it is newer than the device"
        because = f"{shown} accepts it by its CheckRevisionNo {item.check_revision_no}{which}"
        return 1, distance if is_older else distance + _ABOVE, ACCEPTED, because
    between = range(configured + 1, found) if is_older else range(found + 1, configured)
    passes_over = not item.hidden and any(revision in between for revision in hidden_revisions)
    visible = " of those that its vendor does not hide" if passes_over else ""
    if not is_older:
        return 4, distance, NEWER, f"only newer ones are described, next {shown}{visible}"
    if configured & _LOW_WORD == found & _LOW_WORD:
        return 2, distance, OLDER, f"{shown} is older with the same low word"
    return 3, distance, OLDER, f"{shown} is the nearest older one{visible}"
