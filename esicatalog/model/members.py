"""Members of composite data types, and which declared values belong to which of them (ESI-FACTS sections 6 and 7)."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from operator import attrgetter
from typing import NamedTuple

from esicatalog.esi.numbers import MAX_STORED
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.dictionary import DataType, DeclaredValues, Flags, InfoSubItem, SubItem
from esicatalog.model.base_types import BaseType
from esicatalog.model.memo import IdentityMemo
from esicatalog.remarks import Remarked, Remarking, remarked

MAX_ELEMENTS = 4096
"""Longer arrays stay one entry: no CoE array has more than 255 elements, the longest SoE list seen has 761."""

_NUMBERED = re.compile(r"sub\s*index\s*0*(\d{1,9})", re.IGNORECASE)


class Member(NamedTuple):
    """A subindex before values are paired with it."""

    subindex: int
    name: str | None
    display_names: tuple[Name, ...]
    type: str | None
    base: BaseType | None
    bit_size: int | None
    bit_offset: int | None
    flags: Flags | None
    fallback: SubItem | None
    """The SubItem where it declares values itself (obsolete place)."""


MemberMemo = IdentityMemo[tuple[Member, ...]]
"""Members by what declares them: many data types have the same SubItems, many arrays the same elements."""


class Members:
    """The members of a data type with SubItems; ``base`` tells what a type name comes down to."""

    def __init__(
        self,
        data_type: DataType,
        types: Mapping[str, DataType],
        base: Callable[[str | None], BaseType | None],
        memo: MemberMemo,
    ) -> None:
        members: list[Member] = []
        is_pair = len(data_type.sub_items) == 2
        expanded = 0
        for sub_item in data_type.sub_items:
            following = min(members[-1].subindex + 1, MAX_STORED) if members else 0
            array = types.get(sub_item.type) if sub_item.type and members else None
            places = _element_places(sub_item, array, following) if array is not None else None
            if array is not None and places is not None:
                members += _elements(sub_item, array, places, is_pair, base(array.base_type), memo)
                expanded += 1
            else:
                subindex = sub_item.subindex if sub_item.subindex is not None else following
                own = base(sub_item.type)
                members += memo.get(
                    (id(sub_item), subindex, id(own)), (sub_item, own), _single, sub_item, subindex, own
                )
        self._members = members
        self.is_array = expanded == 1 and is_pair
        self._names = [member.name for member in members]

    @cached_property
    def _by_name(self) -> Mapping[str, Sequence[int]]:
        """Positions of the members that have a name."""
        found: dict[str, list[int]] = {}
        for position, name in enumerate(self._names):
            found.setdefault((name or "").strip(), []).append(position)
        return found

    def __iter__(self) -> Iterator[Member]:
        return iter(self._members)

    def pair(self, infos: tuple[InfoSubItem, ...]) -> Remarked[Sequence[DeclaredValues | None]]:
        """Declared values of each member; never shifted to a neighbour.

        Names come first (ESI-FACTS section 7.2). Position counts in an array with a value for each member, unless their
        names number all of its subindices, and in a record with as many values as members for what no name matches, if
        no name claims a member at such a position: a list that lacks one member and has one value too many is as long
        as the type, too.
        """
        if not infos:
            return [None] * len(self._members), ()
        is_complete = len(infos) == len(self._members)
        if is_complete and [info.name for info in infos] == self._names:
            return infos, ()
        if is_complete and self.is_array:
            return self._in_order(infos), ()
        return remarked(self._pair_by_name(infos, is_complete))

    def _pair_by_name(
        self, infos: Sequence[InfoSubItem], is_complete: bool
    ) -> Remarking[Sequence[DeclaredValues | None]]:
        paired: dict[int, InfoSubItem] = {}
        if is_complete:  # real lists repeat a name that the type has once, in the place of another one
            named = enumerate(zip(infos, self._names, strict=True))
            paired = {place: info for place, (info, name) in named if info.name == name}
        unmatched: dict[int, InfoSubItem] = {}
        for place, info in [(place, info) for place, info in enumerate(infos) if place not in paired]:
            places = self._by_name.get((info.name or "").strip(), ())
            free = next((position for position in places if position not in paired), None)
            if free is not None:
                paired[free] = info
            else:
                unmatched[place] = info
        if unmatched and self.is_array:
            self._pair_leftovers(unmatched.values(), paired)
        elif unmatched:
            outcome = "left unpaired"
            if is_complete and paired.keys().isdisjoint(unmatched):
                paired.update(unmatched)
                outcome = "paired by position"
            by_problem: dict[str, list[str]] = {}
            for info in unmatched.values():
                is_known = (info.name or "").strip() in self._by_name
                problem = "occur again" if is_known else "match no sub-item of the data type"
                by_problem.setdefault(problem, []).append(repr(info.name))
            for problem, names in by_problem.items():
                yield f"Info sub-items {', '.join(names[:3])} {problem}; {outcome}"
        return [paired.get(position) for position in range(len(self._members))]

    def _in_order(self, infos: Sequence[InfoSubItem]) -> Sequence[InfoSubItem]:
        """A value for each member of an array: by the numbers in the names if these are all subindices, else as is."""
        by_number = {_number(info.name): info for info in infos}
        found = [by_number.get(member.subindex) for member in self._members]
        return [info for info in found if info is not None] if None not in found else infos

    def _pair_leftovers(self, unmatched: Iterable[InfoSubItem], paired: dict[int, InfoSubItem]) -> None:
        """Values of an array whose names do not match: by the number in the name, else in order from the first."""
        positions = {member.subindex: position for position, member in enumerate(self._members)}
        in_order = []
        for info in unmatched:
            number = _number(info.name)
            position = positions.get(number) if number is not None else None
            if position is not None and position not in paired:
                paired[position] = info
            elif number is None:
                in_order.append(info)
        if in_order and len(in_order) == len(self._members) - 1 and not paired.keys() - {0}:
            paired.update((position, info) for position, info in enumerate(in_order, start=1))


def _single(sub_item: SubItem, subindex: int, base: BaseType | None) -> tuple[Member]:
    return (
        Member(
            subindex,
            sub_item.name,
            sub_item.display_names,
            sub_item.type,
            base,
            sub_item.bit_size,
            sub_item.bit_offset,
            sub_item.flags,
            _fallback(sub_item),
        ),
    )


@lru_cache(maxsize=10_000)
def _number(name: str | None) -> int | None:
    """The subindex that a name like "SubIndex 001" states."""
    numbered = _NUMBERED.fullmatch((name or "").strip())
    return int(numbered[1]) if numbered is not None else None


_declared = attrgetter("default_data", "default_string", "default_value", "min_value", "max_value")
_NOTHING = _declared(SubItem())


def _fallback(sub_item: SubItem) -> SubItem | None:
    return sub_item if sub_item.spelling or _declared(sub_item) != _NOTHING else None


def _lower_bound(array: DataType) -> int:
    lbound = array.array_infos[0].lbound
    return lbound if lbound is not None else 1


def _element_places(sub_item: SubItem, array: DataType, following: int) -> range | None:
    """Subindices of an array written with one sub-item for all elements (idiom A), or None for a single member.

    Elements count from LBound; with LBound 0 (lists of SoE dictionaries) they follow the member before them and may
    run beyond 255.
    """
    if not array.array_infos:
        return None
    lbound = _lower_bound(array)
    suffixed = lbound == 1 and (array.name or "").upper().endswith("ARR")
    if sub_item.subindex is not None and not suffixed:
        return None
    count = 1
    for info in array.array_infos:
        count *= max(info.elements or 0, 0)
    first = lbound if lbound > 0 else following
    return range(first, first + count) if first + count <= MAX_ELEMENTS else None


def _elements(
    sub_item: SubItem, array: DataType, places: range, whole_object: bool, base: BaseType | None, memo: MemberMemo
) -> tuple[Member, ...]:
    size = array.bit_size // len(places) if array.bit_size and places else None
    plan = _Elements(
        places,
        None if whole_object else str(sub_item.name),
        _lower_bound(array),
        array.base_type,
        base,
        size,
        sub_item.bit_offset if size is not None else None,
    )
    flags, fallback = sub_item.flags, _fallback(sub_item)
    return memo.get((plan, id(flags), id(fallback)), (flags, fallback), _element_members, plan, flags, fallback)


class _Elements(NamedTuple):
    """What the elements of arrays have in common."""

    places: range
    name: str | None
    """None where the elements are the whole object."""
    lower_bound: int
    type: str | None
    base: BaseType | None
    bit_size: int | None
    bit_offset: int | None


def _element_members(plan: _Elements, flags: Flags | None, fallback: SubItem | None) -> tuple[Member, ...]:
    return tuple(
        Member(
            subindex,
            f"SubIndex {subindex:03d}" if plan.name is None else f"{plan.name}[{plan.lower_bound + k}]",
            (),
            plan.type,
            plan.base,
            plan.bit_size,
            _offset(plan, k),
            flags,
            fallback,
        )
        for k, subindex in enumerate(plan.places)
    )


def _offset(plan: _Elements, number: int) -> int | None:
    """Offset of an element in the complete-access image; None for one that no database takes."""
    if plan.bit_offset is None or plan.bit_size is None:
        return None
    offset = plan.bit_offset + number * plan.bit_size
    return offset if abs(offset) <= MAX_STORED else None
