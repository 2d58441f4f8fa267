"""Which devices can do X: filters become the conditions of one SELECT, and every answer carries its evidence."""

from collections.abc import Iterator, Sequence
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import capability_conditions as capability
from esicatalog.catalog import content_conditions as content
from esicatalog.catalog import schema
from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.conditions import Condition
from esicatalog.catalog.device_filter import DeviceFilter
from esicatalog.catalog.devices import find_device, summary
from esicatalog.catalog.full_text import search_expression
from esicatalog.catalog.results import FoundDevice
from esicatalog.catalog.schema import devices, vendors
from esicatalog.catalog.views import FULL_TEXT
from esicatalog.errors import InputError
from esicatalog.identity import Identity

_FLAGS = ("complete_access", "pdo_assign", "pdo_config", "bootstrap", "needs_dc", "no_lrw")
_AMOUNTS = ("bytes_in", "bytes_out", "min_cycle_ns", "e_bus_ma", "axes")


def find_devices(connection: sa.Connection, wanted: DeviceFilter) -> list[FoundDevice]:
    """Devices that fulfil the filter, by vendor, product, revision and variant.

    Raises :class:`InputError`, and :class:`NotFound` when the device to compare with is not there.
    """
    held = list(conditions(connection, wanted))
    return [device for _, device in found_devices(connection, held, wanted)]


def found_devices(
    connection: sa.Connection, found: Sequence[Condition], wanted: DeviceFilter, offset: int = 0
) -> list[tuple[int, FoundDevice]]:
    """Devices that fulfil conditions, with their row numbers and evidence; ``offset`` skips the first ones."""
    query = device_query(found, wanted)
    rows = connection.execute(query.offset(offset) if offset else query).all()
    evidence: dict[int, list[str]] = {row.id: [] for row in rows}
    for condition in found:
        if condition.evidence is not None:
            for part in chunks(evidence):
                for number, texts in condition.evidence(connection, part).items():
                    evidence[number].extend(texts)
    return [(row.id, summary(row, evidence[row.id])) for row in rows]


def device_query(found: Sequence[Condition], wanted: DeviceFilter) -> sa.Select[Any]:
    """The one SELECT of a filter."""
    columns = devices.c
    query = (
        sa.select(
            columns.id,
            columns.vendor_id,
            columns.product_code,
            columns.revision_no,
            columns.variant,
            columns.hidden,
            vendors.c.name.label("vendor"),
            columns.type,
            columns.name,
        )
        .outerjoin(vendors, vendors.c.vendor_id == columns.vendor_id)
        .where(*_fulfilled(found, wanted))
        .order_by(columns.vendor_id, columns.product_code, columns.revision_no, columns.type, columns.variant)
    )
    return query.limit(wanted.limit) if wanted.limit is not None else query


def matching_ids(found: Sequence[Condition], wanted: DeviceFilter) -> sa.Select[Any]:
    """Row numbers of all devices that fulfil the filter, as a subquery; the limit does not count."""
    return (
        sa.select(devices.c.id)
        .outerjoin(vendors, vendors.c.vendor_id == devices.c.vendor_id)
        .where(*_fulfilled(found, wanted))
    )


def _fulfilled(found: Sequence[Condition], wanted: DeviceFilter) -> list[Any]:
    conditions = [condition.sql for condition in found]
    if not wanted.all_variants:
        conditions.append(devices.c.variant == 1)
    if not wanted.include_hidden:
        conditions.append(devices.c.hidden == sa.false())
    return conditions


def conditions(connection: sa.Connection, wanted: DeviceFilter) -> Iterator[Condition]:
    """The conditions of a filter, in the order in which their evidence is shown."""
    columns = devices.c
    if wanted.vendor_id is not None:
        yield Condition(columns.vendor_id == wanted.vendor_id)
    if wanted.vendor is not None:
        names = schema.vendor_names.c
        named = sa.select(names.vendor_id).where(names.name.icontains(wanted.vendor, autoescape=True))
        yield Condition(columns.vendor_id.in_(named))
    if wanted.product_code is not None:
        yield Condition(columns.product_code == wanted.product_code)
    if wanted.text is not None:
        yield Condition(_text_condition(wanted.text, connection.dialect.name))
    if wanted.profile_no is not None:
        yield content.profile(wanted.profile_no)
    yield from (capability.drive_mode(mode, wanted.strict) for mode in wanted.modes)
    if wanted.sync is not None:
        yield capability.sync(wanted.sync)
    if wanted.protocol is not None:
        yield capability.protocol(wanted.protocol)
    yield from (capability.flag(name) for name in _FLAGS if getattr(wanted, name))
    if wanted.identification is not None:
        yield capability.identification(wanted.identification)
    if wanted.physics is not None:
        yield capability.physics(wanted.physics)
    for name in _AMOUNTS:
        bounds = getattr(wanted, name)
        if bounds is not None:
            yield capability.amount(name, bounds)
    yield from (content.maps(mapped, wanted.bits) for mapped in wanted.maps)
    yield from (content.not_maps(mapped) for mapped in wanted.not_maps)
    yield from (content.has_object(item) for item in wanted.objects)
    if wanted.like is not None:
        yield _like_condition(connection, wanted.like)


def _like_condition(connection: sa.Connection, identity: Identity) -> Condition:
    number, found, _ = find_device(connection, identity)
    facts = connection.execute(sa.select(schema.device_facts).where(schema.device_facts.c.device_id == number)).one()
    if facts.image_signature is None:
        raise InputError(f"{found.identity_text} has no process data by default; there is no layout to compare")
    return capability.like(number, f"{found.identity_text} {found.type or ''}".rstrip(), facts)


def _text_condition(text: str, dialect: str) -> Any:
    if dialect == "sqlite":
        match = sa.text(f"devices.id IN (SELECT rowid FROM {FULL_TEXT} WHERE {FULL_TEXT} MATCH :words)")
        return match.bindparams(words=search_expression(text))
    texts = schema.device_names.c
    words = [
        sa.or_(
            devices.c.type.icontains(word, autoescape=True),
            vendors.c.name.icontains(word, autoescape=True),
            devices.c.id.in_(sa.select(texts.device_id).where(texts.text.icontains(word, autoescape=True))),
        )
        for word in text.split()
    ]
    return sa.and_(sa.true(), *words)
