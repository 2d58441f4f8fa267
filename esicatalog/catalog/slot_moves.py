"""Where objects and PDOs of modules lie in the slots of a device, in SQL: index + slot number x increment.

The rule of ESI-FACTS section 12.1, as :mod:`esicatalog.model.slots` tells it of one module in one slot. An index that
would leave 16 bits is a defect that ``lint`` names; it is looked for where it would be.
"""

from collections.abc import Iterable
from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

import sqlalchemy as sa

from esicatalog.catalog.conditions import tested
from esicatalog.catalog.schema import devices, modules, slot_module_classes, slot_modules, slots
from esicatalog.catalog.state import CONTENT_HASH, read_state
from esicatalog.identity import MAX_INDEX
from esicatalog.model.pdo_facts import PDO_MAPPINGS, is_pdo_mapping
from esicatalog.model.slots import MAX_INSTANCES

_OWNER = devices.alias("slotted")
_EARLIER = slots.alias("earlier")
SLOTS = slots.join(_OWNER, _OWNER.c.id == tested(slots.c.device_id))
"""Slot elements, of which few devices have any, and then their devices: both say how far indices move."""


def _increment(name: str) -> sa.ColumnElement[int]:
    """What a Slot element says counts before what is said for all."""
    return _in_16_bits(sa.func.coalesce(slots.c[name], _OWNER.c[name], 0))


def _group_move(name: str) -> sa.ColumnElement[int]:
    return _in_16_bits(sa.func.coalesce(slots.c.slot_group, 0)) * _increment(name)


def _in_16_bits(number: sa.ColumnElement[int]) -> sa.ColumnElement[int]:
    """What would move every index out of 16 bits moves none; no product is too large for a database then."""
    return sa.case((number.between(-MAX_INDEX, MAX_INDEX), number), else_=0)


def _instances(table: sa.FromClause) -> sa.ColumnElement[int]:
    count = sa.func.coalesce(table.c.max_instances, 1)
    return sa.case((count < 0, 0), (count > MAX_INSTANCES, MAX_INSTANCES), else_=count)


class _Moves(NamedTuple):
    """How far indices move from slot to slot, and how far with the group of a slot."""

    step: sa.ColumnElement[int]
    of_group: sa.ColumnElement[int]


_OF_OBJECTS = _Moves(_increment("slot_index_increment"), _group_move("slot_group_index_increment"))
_OF_PDOS = _Moves(_increment("slot_pdo_increment"), _group_move("slot_group_pdo_increment"))
_FIRST = (
    sa.select(sa.cast(sa.func.coalesce(sa.func.sum(_instances(_EARLIER)), 0), sa.BigInteger))
    .where(_EARLIER.c.device_id == slots.c.device_id, _EARLIER.c.position < slots.c.position)
    .scalar_subquery()
)
"""Number of the first slot of a Slot element."""


class Increments(NamedTuple):
    """What some Slot elements add to indices of objects, or to those of PDOs and of the objects that describe these."""

    of_pdos: bool
    step: int
    group_move: int
    last_number: int
    """The highest number of a slot with these."""


_INCREMENTS: WeakKeyDictionary[sa.Engine, tuple[str | None, list[Increments]]] = WeakKeyDictionary()


def increments(connection: sa.Connection) -> list[Increments]:
    """The increments that occur in a catalog, few even in a large one.

    They are kept as long as its content stays the same: to read them takes 50 ms where 30,000 devices have slots.
    """
    content = read_state(connection, CONTENT_HASH)
    known, found = _INCREMENTS.get(connection.engine, (None, []))
    if content is None or content != known:
        last = sa.func.max(_FIRST + _instances(slots) - 1)
        found = []
        for of_pdos, (step, of_group) in ((False, _OF_OBJECTS), (True, _OF_PDOS)):
            query = sa.select(step.label("step"), of_group.label("group_move"), last).select_from(SLOTS)
            moving = query.where(sa.or_(step != 0, of_group != 0)).group_by("step", "group_move")
            found += [Increments(of_pdos, *row) for row in connection.execute(moving)]
        _INCREMENTS[connection.engine] = (content, found)
    return found


def unmoved_indices(index: int, found: Iterable[Increments]) -> list[int]:
    """The indices that an object can have in a module that lies at ``index`` in a slot of any device, and more.

    By these few numbers an index of the database finds what is then asked more closely.
    """
    unmoved = {index}
    for of_pdos, step, group_move, last in found:
        numbers = range(min(last, MAX_INDEX) + 1)
        places = {index - number * step - by_group for number in numbers for by_group in (0, group_move)}
        unmoved |= {place for place in places if is_pdo_mapping(place)} if of_pdos else places
    return sorted(place for place in unmoved if 0 <= place <= MAX_INDEX)


def moves(item: sa.FromClause) -> sa.ColumnElement[bool]:
    """Whether the index of an object or of an entry depends on the slot or its group."""
    return sa.or_(_flag(item.c.depend_on_slot), _flag(item.c.depend_on_slot_group))


def _flag(column: sa.ColumnElement[bool]) -> sa.ColumnElement[bool]:
    return sa.func.coalesce(column, sa.false())


def _distance(item: sa.FromClause, item_index: sa.ColumnElement[int], index: int) -> sa.ColumnElement[int]:
    """How far the number of the slot moves an object that comes to lie at an index."""
    return index - item_index - sa.case((_flag(item.c.depend_on_slot_group), _of_item(item_index).of_group), else_=0)


def _of_item(item_index: sa.ColumnElement[int]) -> _Moves:
    """An object that describes a PDO moves as PDOs do."""
    is_mapping = sa.or_(*[item_index.between(places[0], places[-1]) for places in PDO_MAPPINGS.values()])
    step, of_group = (sa.case((is_mapping, pdo), else_=other) for pdo, other in zip(_OF_PDOS, _OF_OBJECTS, strict=True))
    return _Moves(step, of_group)


def _divisor(item_index: sa.ColumnElement[int]) -> sa.ColumnElement[int]:
    return sa.func.nullif(_of_item(item_index).step, 0, type_=sa.BigInteger)


def slot_number(item: sa.FromClause, item_index: sa.ColumnElement[int], index: int) -> sa.ColumnElement[int | None]:
    """Number of the slot in which an object lies at an index; NULL where the number does not move it."""
    return sa.case((_flag(item.c.depend_on_slot), _distance(item, item_index, index) // _divisor(item_index)))


def lies_at(
    item: sa.FromClause,
    item_index: sa.ColumnElement[int],
    index: int,
    device_id: sa.ColumnElement[int],
    module_id: sa.ColumnElement[int],
) -> sa.ColumnElement[bool]:
    """Whether a moving object of a module lies at an index in a slot of :data:`SLOTS`, which accepts the module.

    ``device_id`` and ``module_id`` link a device with a module that it can reach: whose the module has to be was looked
    at then.
    """
    distance, number = _distance(item, item_index, index), slot_number(item, item_index, index)
    is_there = sa.and_(distance % _divisor(item_index) == 0, number >= _FIRST, number < _FIRST + _instances(slots))
    stays = sa.and_(distance == 0, _instances(slots) > 0)
    return sa.and_(
        slots.c.device_id == device_id,
        sa.case((number.is_not(None), is_there), else_=stays),
        sa.or_(
            _accepts(slot_modules, slot_modules.c.module_ident == modules.c.module_ident, module_id),
            _accepts(slot_module_classes, slot_module_classes.c.module_class == modules.c.module_class, module_id),
        ),
    )


def _accepts(of_slot: sa.Table, fits: sa.ColumnElement[bool], module_id: sa.ColumnElement[int]) -> sa.Exists:
    accepted = sa.select(of_slot.c.id).select_from(of_slot.join(modules, modules.c.id == module_id))
    return accepted.where(of_slot.c.slot_id == slots.c.id, fits).correlate_except(of_slot, modules).exists()


def lies_in_a_slot(*where: Any) -> sa.ColumnElement[bool]:
    """Whether there is a slot as :func:`lies_at` asks for."""
    return sa.select(slots.c.id).select_from(SLOTS).where(lies_at(*where)).correlate_except(slots, _OWNER).exists()


def pdo_index_in_slot(pdo: sa.FromClause, number: sa.ColumnElement[int | None]) -> sa.ColumnElement[int]:
    """Index of a module's PDO in a slot of :data:`SLOTS` with this number."""
    by_slot = sa.case((_flag(pdo.c.depend_on_slot), sa.func.coalesce(number, 0) * _OF_PDOS.step), else_=0)
    by_group = sa.case((_flag(pdo.c.depend_on_slot_group), _OF_PDOS.of_group), else_=0)
    return pdo.c.pdo_index + by_slot + by_group
