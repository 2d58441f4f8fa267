"""Which devices can do X: filters become the conditions of one SELECT, and every answer carries its evidence."""

from collections.abc import Iterator, Sequence
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import capability_conditions as capability
from esicatalog.catalog import content_conditions as content
from esicatalog.catalog import schema
from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.conditions import Condition, among, by_row
from esicatalog.catalog.device_filter import AMOUNTS, DeviceFilter
from esicatalog.catalog.devices import ORDER, SUMMARY, VENDOR_NAME, find_device, summary
from esicatalog.catalog.full_text import text_condition
from esicatalog.catalog.results import FoundDevice
from esicatalog.catalog.schema import devices, vendors
from esicatalog.catalog.siblings import IMAGE_IS_KNOWN
from esicatalog.catalog.slot_moves import increments
from esicatalog.errors import InputError
from esicatalog.identity import Identity
from esicatalog.words import hex32

ADDRESSED = Condition(sa.and_(devices.c.vendor_id.is_not(None), devices.c.product_code.is_not(None)), indexed=True)
NOT_ADDRESSED = Condition(sa.or_(devices.c.vendor_id.is_(None), devices.c.product_code.is_(None)), indexed=True)
"""Whether a description has the codes by which a bus and the address of a page name it; end caps have none."""
_ASKED = 300
"""How many devices a page asks one by one: six pages of 50, which takes 1 to 4 ms; a list takes up to 100 ms."""


def find_devices(connection: sa.Connection, wanted: DeviceFilter) -> list[FoundDevice]:
    """Devices that fulfil the filter, by vendor, product, revision, type and variant.

    Raises :class:`InputError`, and :class:`NotFound` when the device to compare with is not there.
    """
    held = list(conditions(connection, wanted))
    return [device for _, device in found_devices(connection, held, wanted)]


def found_devices(
    connection: sa.Connection, found: Sequence[Condition], wanted: DeviceFilter, offset: int = 0
) -> list[tuple[int, FoundDevice]]:
    """Devices that fulfil conditions, with their row numbers and evidence; ``offset`` skips the first ones."""
    rows = connection.execute(device_query(found, wanted, offset)).all()
    evidence: dict[int, list[str]] = {row.id: [] for row in rows}
    for condition in found:
        if condition.evidence is not None:
            for part in chunks(evidence):
                for number, texts in condition.evidence(connection, part).items():
                    evidence[number].extend(texts)
    return [(row.id, summary(row, evidence[row.id])) for row in rows]


def device_query(found: Sequence[Condition], wanted: DeviceFilter, offset: int = 0) -> sa.Select[Any]:
    """The one SELECT of a filter; ``offset`` skips the first devices."""
    limit = wanted.limit
    fulfil = fulfilled(found, wanted) if limit is None else _on_page(found, wanted, limit + offset)
    return SUMMARY.where(*fulfil).limit(limit).offset(offset or None)


def matching_ids(found: Sequence[Condition], wanted: DeviceFilter) -> sa.Select[Any]:
    """Row numbers of all devices that fulfil the filter, as a subquery; the limit does not count."""
    return (
        sa.select(devices.c.id)
        .outerjoin(vendors, vendors.c.vendor_id == devices.c.vendor_id)
        .where(*fulfilled(found, wanted))
    )


def fulfilled(found: Sequence[Condition], wanted: DeviceFilter) -> list[Any]:
    """The SQL conditions of a filter. What few devices fulfil comes first: SQLite looks at them in their order."""
    return [*(condition.sql for condition in found), *_visible(wanted)]


def _visible(wanted: DeviceFilter) -> list[Any]:
    conditions = []
    if not wanted.all_variants:
        conditions.append(devices.c.variant == 1)
    if not wanted.include_hidden:
        conditions.append(devices.c.hidden == sa.false())
    return conditions


def _on_page(found: Sequence[Condition], wanted: DeviceFilter, size: int) -> list[Any]:
    """The same conditions, for the first ``size`` devices that fulfil them.

    Some devices are asked one by one. Mostly enough of them fulfil the filter, and the lists of all devices, which take
    longer than all the rest, are never made: databases make a list when they first look something up in it.
    """
    listed = [condition for condition in found if condition.of_one is not None]
    plain = [condition for condition in found if condition.of_one is None]
    if not listed or size > _ASKED:
        return fulfilled(found, wanted)
    number = devices.c.id
    indexed = sa.select(number).where(*fulfilled([c for c in plain if c.indexed], wanted))
    asked = indexed.order_by(*ORDER).limit(_ASKED).cte("asked")
    own = [*(c.sql for c in plain if not c.indexed), *(c.of_one for c in listed)]
    fit = sa.select(number).where(number.in_(sa.select(asked.c.id)), *own).cte("fit")
    all_asked = sa.select(sa.func.count() < _ASKED).select_from(asked).scalar_subquery()
    enough = sa.select(sa.or_(sa.func.count() >= size, all_asked)).select_from(fit).scalar_subquery()
    return [
        sa.or_(enough, sa.and_(*(c.sql for c in listed))),
        sa.or_(sa.not_(enough), among(sa.select(fit.c.id))),
        *fulfilled(plain, wanted),
    ]


def conditions(connection: sa.Connection, wanted: DeviceFilter) -> Iterator[Condition]:
    """The conditions of a filter, in the order in which their evidence is shown."""
    columns = devices.c
    if wanted.vendor_id is not None:
        yield Condition(columns.vendor_id == wanted.vendor_id, indexed=True)
    if wanted.vendor is not None:
        yield _vendor_condition(wanted.vendor)
    if wanted.product_code is not None:
        yield Condition(columns.product_code == wanted.product_code, indexed=True)
    if wanted.text is not None and wanted.text.strip():
        yield Condition(text_condition(wanted.text, connection.dialect.name), indexed=True)
    if wanted.profile_no is not None:
        yield content.profile(wanted.profile_no)
    yield from (capability.drive_mode(mode, wanted.strict) for mode in wanted.modes)
    if wanted.sync is not None:
        yield capability.sync(wanted.sync)
    if wanted.protocol is not None:
        yield capability.protocol(wanted.protocol)
    yield from (capability.flag(name) for name in capability.FLAGS if getattr(wanted, name))
    if wanted.identification is not None:
        yield capability.identification(wanted.identification)
    if wanted.physics is not None:
        yield capability.physics(wanted.physics)
    for name in AMOUNTS:
        bounds = getattr(wanted, name)
        if bounds is not None:
            yield capability.amount(name, bounds)
    if wanted.maps or wanted.not_maps or wanted.objects:
        slots = increments(connection)
        yield from (content.maps(mapped, wanted.bits, slots) for mapped in wanted.maps)
        yield from (content.not_maps(mapped, slots) for mapped in wanted.not_maps)
        yield from (content.declares_object(item, slots) for item in wanted.objects)
    if wanted.like is not None:
        yield _like_condition(connection, wanted.like)


def _vendor_condition(part: str) -> Condition:
    """Devices of the vendors that have a name with this part; evidence where it is not the name that is shown.

    Makers without a vendor id of their own share one: the device may be that of another maker.
    """
    names = schema.vendor_names.c
    named = names.name.icontains(part, autoescape=True)
    others = (
        sa.select(devices.c.id, names.vendor_id, names.name)
        .join(schema.vendor_names, names.vendor_id == devices.c.vendor_id)
        .join(vendors, vendors.c.vendor_id == devices.c.vendor_id)
        .where(named, sa.not_(VENDOR_NAME.icontains(part, autoescape=True)))
        .distinct()
        .order_by(devices.c.id, names.name)
    )

    def words(vendor_id: int, name: str) -> str:
        return f"documents with vendor id {hex32(vendor_id)} also name {name!r}"

    with_name = devices.c.vendor_id.in_(sa.select(names.vendor_id).where(named))
    return Condition(with_name, by_row(others, devices.c.id, words), indexed=True)


def _like_condition(connection: sa.Connection, identity: Identity) -> Condition:
    number, found, _ = find_device(connection, identity)
    of_device = sa.select(schema.device_facts, IMAGE_IS_KNOWN.label("image_is_known"))
    facts = connection.execute(of_device.where(schema.device_facts.c.device_id == number)).one()
    if not facts.image_is_known:
        raise InputError(
            f"the length of the default process image of {found.identity_text} is not known; "
            "there is no layout to compare"
        )
    if facts.image_signature is None:
        raise InputError(f"{found.identity_text} has no process data by default; there is no layout to compare")
    return capability.like(number, f"{found.identity_text} {found.type or ''}".rstrip(), facts)
