"""What a comparison is made of: the difference, the rules by which it counts, tables of the fields that are compared.

A difference counts when a master's configuration that was made for the left description may not fit a device of the
right one. So the rules have a direction: an object that only the right one has disturbs nobody, one that it has lost
may be the one that the configuration writes.
"""

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from itertools import zip_longest
from typing import Any, NamedTuple, TypeVar

import msgspec

from esicatalog.esi.binding import Record
from esicatalog.model.compare_words import Show, text, value_of

IDENTITY, GENERAL, SYNC_MANAGER, FMMU = "identity", "general", "SyncManager", "Fmmu"
PDO, PROCESS_IMAGE, MAILBOX, INIT_CMD = "PDO", "process image", "Mailbox", "InitCmd"
DC, OBJECTS, SLOTS, EEPROM = "Dc", "objects", "slots and modules", "Eeprom"
AREAS = (
    IDENTITY,
    GENERAL,
    SYNC_MANAGER,
    FMMU,
    PDO,
    PROCESS_IMAGE,
    MAILBOX,
    INIT_CMD,
    DC,
    OBJECTS,
    SLOTS,
    EEPROM,
)
"""All areas, in the order in which differences are told."""

ADDED, REMOVED, CHANGED = "added", "removed", "changed"

_LONGEST = 160
"""Characters of a value; of a longer one a part is told."""
_BEFORE = 20
"""Characters that a part of a text has in front of the first difference."""

Item = TypeVar("Item")


class Difference(msgspec.Struct, frozen=True, gc=False):
    """One thing that two descriptions say differently."""

    area: str
    """One of :data:`AREAS`."""
    place: str
    """Where, in words, e.g. ``SM2 start address`` or ``TxPDO 0x1A00 entry 3``."""
    kind: str
    """``added`` (only the right one has it), ``removed`` (only the left one) or ``changed``."""
    left: str | None
    """The left value in words; None when it is not there."""
    right: str | None
    """The right value in words; None when it is not there."""
    counts: bool
    """A configuration made for the left description may not fit the right one."""
    module: str | None = None
    """The module that it is about, e.g. ``module 0x00119800``; None for the device itself."""


Rule = Callable[[Any, Any], bool]
"""Left and right value → whether their difference counts; see :class:`Difference`."""


def always(left: Any, right: Any) -> bool:
    """It is part of a configuration."""
    return True


def never(left: Any, right: Any) -> bool:
    """A text, a hint, or something that no master uses."""
    return False


def lost(left: Any, right: Any) -> bool:
    """It is something to use: it counts unless the left one did not have it."""
    return left is not None and left is not False


def gained(left: Any, right: Any) -> bool:
    """It is a restriction: it counts unless the right one does not have it."""
    return right is not None and right is not False


def contradicted(left: Any, right: Any) -> bool:
    """It is often left out: it counts when both say something and not the same."""
    return left is not None and right is not None


def raised(left: Any, right: Any) -> bool:
    """It is a lower limit: it counts when it is new or higher; where a number is not readable, it always does."""
    return right is not None and not (_are_numbers(left, right) and right <= left)


def lowered(left: Any, right: Any) -> bool:
    """It is an upper limit: it counts when it is new or lower; where a number is not readable, it always does."""
    return right is not None and not (_are_numbers(left, right) and right >= left)


def _are_numbers(*values: Any) -> bool:
    return all(isinstance(value, int | float) for value in values)


def lost_items(left: Iterable[Any] | None, right: Iterable[Any] | None) -> bool:
    """Things to use: it counts when one of the left ones is missing."""
    return bool(set(left or ()) - set(right or ()))


def gained_items(left: Iterable[Any] | None, right: Iterable[Any] | None) -> bool:
    """Restrictions: it counts when there is a new one."""
    return lost_items(right, left)


class Fact(NamedTuple):
    """A field that is compared: its name in the record (or what computes it), its name in words, its rule."""

    field: str | Callable[[Any], Any]
    words: str
    counts: Rule
    show: Show = text


def difference(area: str, place: str, left: str | None, right: str | None, counts: bool) -> Difference:
    """A difference of two values in words, None where there is none; of long texts what surrounds the first change."""
    kind = CHANGED if left is not None and right is not None else ADDED if left is None else REMOVED
    return Difference(area, place, kind, *excerpts(left, right, _LONGEST), counts)


def excerpts(left: str | None, right: str | None, longest: int) -> tuple[str | None, str | None]:
    """Two different texts in at most so many characters each: the part where they first differ, else their beginning.

    So the two parts are different, too. Dots stand for what is left out.
    """
    if max(len(left or ""), len(right or "")) <= longest:
        return left, right
    start = 0
    if left is not None and right is not None:
        same = next((at for at, pair in enumerate(zip(left, right, strict=False)) if pair[0] != pair[1]), None)
        start = max((min(len(left), len(right)) if same is None else same) - _BEFORE, 0)

    def excerpt(whole: str | None) -> str | None:
        if whole is None:
            return None
        end = start + longest - (2 if start else 1)
        return ("…" if start else "") + whole[start:end] + ("…" if len(whole) > end else "")

    return excerpt(left), excerpt(right)


def compare_facts(area: str, place: str, left: Record, right: Record, facts: Iterable[Fact]) -> Iterator[Difference]:
    """The fields of two records that differ, as their table says."""
    if left is right or left == right:
        return
    for fact in facts:
        ours, theirs = value_of(left, fact.field), value_of(right, fact.field)
        if ours is theirs:
            continue
        shown, other = fact.show(ours), fact.show(theirs)
        if shown != other:
            yield difference(area, f"{place} {fact.words}".strip(), shown, other, fact.counts(ours, theirs))


def fact_words(record: Record, facts: Iterable[Fact]) -> str:
    """Everything that a record says, in the words of its table; flags that are off are left out."""
    said = [(fact.words, fact.show(value_of(record, fact.field))) for fact in facts]
    return ", ".join(f"{words} {value}" for words, value in said if value not in (None, "no")) or "without content"


def matched(
    left: Iterable[Item], right: Iterable[Item], key: Callable[[Item], Hashable]
) -> list[tuple[Item | None, Item | None]]:
    """Pairs with equal keys, repeated ones by occurrence: in the order of the left, then what only the right has."""
    rest = dict(_numbered(right, key))
    pairs: list[tuple[Item | None, Item | None]] = [
        (item, rest.pop(numbered_key, None)) for numbered_key, item in _numbered(left, key)
    ]
    return pairs + [(None, item) for item in rest.values()]


def matched_in_steps(
    left: Iterable[Item], right: Iterable[Item], *keys: Callable[[Item], Hashable]
) -> list[tuple[Item | None, Item | None]]:
    """Pairs with equal first keys, of the others those with equal second keys, and so on; then what is left over."""
    pairs: list[tuple[Item | None, Item | None]] = []
    rest, others = list(left), list(right)
    for key in keys:
        joined = matched(rest, others, key)
        pairs += [pair for pair in joined if None not in pair]
        rest = [item for item, other in joined if item is not None and other is None]
        others = [other for item, other in joined if item is None and other is not None]
    return [*pairs, *((item, None) for item in rest), *((None, other) for other in others)]


def either(left: Item | None, right: Item | None) -> Item:
    """The one of a pair that is there, the left one when both are."""
    known = left if left is not None else right
    assert known is not None
    return known


def _numbered(items: Iterable[Item], key: Callable[[Item], Hashable]) -> Iterator[tuple[tuple[Hashable, int], Item]]:
    seen: Counter[Hashable] = Counter()
    for item in items:
        found = key(item)
        yield (found, seen[found]), item
        seen[found] += 1


def compare_whole(
    area: str, place: str, left: Record | None, right: Record | None, facts: Sequence[Fact], counts: Rule = always
) -> Iterator[Difference]:
    """Two records of one place; ``counts`` is the rule for a record that only one side has."""
    if left is not None and right is not None:
        yield from compare_facts(area, place, left, right, facts)
    elif left is not right:
        said = fact_words(left, facts) if left is not None else None
        also = fact_words(right, facts) if right is not None else None
        yield difference(area, place, said, also, counts(left, right))


def compare_by_position(
    area: str, name: str, left: Sequence[Record], right: Sequence[Record], facts: Sequence[Fact], counts: Rule = always
) -> Iterator[Difference]:
    """Records whose position is their number, as :func:`compare_whole`."""
    for number, (ours, theirs) in enumerate(zip_longest(left, right)):
        yield from compare_whole(area, f"{name}{number}", ours, theirs, facts, counts)
