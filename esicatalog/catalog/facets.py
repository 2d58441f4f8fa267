"""How many of the found devices have what: counts beside the filters of a search page."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog.conditions import Condition
from esicatalog.catalog.device_filter import MODES, SYNC_SIGNALS, DeviceFilter
from esicatalog.catalog.schema import device_facts, devices, drive_modes, mailboxes, profiles, vendors
from esicatalog.catalog.search import fulfilled, matching_ids
from esicatalog.model.cia402 import CIA402
from esicatalog.model.words import MAILBOX_PROTOCOLS, protocol_name

_MOST_VENDORS, _MOST_PROFILES = 30, 20
_PROPERTIES: dict[tuple[str, str], tuple[str, Any]] = {
    **{("sync", name): (name.upper(), device_facts.c[f"supports_{name}"] == sa.true()) for name in SYNC_SIGNALS},
    **{("protocol", name): (protocol_name(name), mailboxes.c[name] == sa.true()) for name in MAILBOX_PROTOCOLS},
    ("protocol", "fsoe"): ("FSoE (evidence)", device_facts.c.fsoe.is_not(None)),
}
"""What tables with one row a device tell: filter and word, label and condition."""


class FacetValue(NamedTuple):
    """A word of a filter, how it is shown, and the number of found devices that have it."""

    text: str
    label: str
    device_count: int


class Counts(NamedTuple):
    """How many devices there are, and by filter how many of them have what."""

    total: int
    facets: dict[str, tuple[FacetValue, ...]]


def counts(connection: sa.Connection, found: Sequence[Condition], wanted: DeviceFilter) -> Counts:
    """Counts by filter: vendor, mode, sync, protocol and profile. The number of queries is always the same."""
    fulfil, ids = fulfilled(found, wanted), matching_ids(found, wanted)
    total, properties = _properties(connection, fulfil)
    return Counts(
        total,
        {
            "vendor": _vendors(connection, fulfil),
            "mode": _modes(connection, ids, wanted.strict),
            **properties,
            "profile": _profiles(connection, ids),
        },
    )


def _properties(connection: sa.Connection, fulfil: list[Any]) -> tuple[int, dict[str, tuple[FacetValue, ...]]]:
    """The number of devices, and how many of them have each property: all in one pass."""
    columns = [sa.func.count(sa.case((condition, 1))) for _, condition in _PROPERTIES.values()]
    tables = devices.outerjoin(device_facts, device_facts.c.device_id == devices.c.id).outerjoin(
        mailboxes, mailboxes.c.device_id == devices.c.id
    )
    query = sa.select(sa.func.count(), *columns).select_from(tables).where(*fulfil)
    total, *numbers = connection.execute(query).one()
    facets: dict[str, tuple[FacetValue, ...]] = {name: () for name, _ in _PROPERTIES}
    for ((name, word), (label, _)), number in zip(_PROPERTIES.items(), numbers, strict=True):
        if number:
            facets[name] += (FacetValue(word, label, number),)
    return total, facets


def _vendors(connection: sa.Connection, fulfil: list[Any]) -> tuple[FacetValue, ...]:
    """Counted before their names are looked up: the index by which devices are listed has them in order."""
    count = sa.func.count().label("device_count")
    counted = (
        sa.select(devices.c.vendor_id, count)
        .where(*fulfil, devices.c.vendor_id.is_not(None))
        .group_by(devices.c.vendor_id)
        .order_by(count.desc(), devices.c.vendor_id)
        .limit(_MOST_VENDORS)
        .subquery()
    )
    query = (
        sa.select(counted.c.vendor_id, vendors.c.name, counted.c.device_count)
        .outerjoin(vendors, vendors.c.vendor_id == counted.c.vendor_id)
        .order_by(counted.c.device_count.desc(), counted.c.vendor_id)
    )
    return tuple(FacetValue(f"0x{v:x}", name or f"0x{v:08x}", n) for v, name, n in connection.execute(query))


def _modes(connection: sa.Connection, ids: Any, strict: bool) -> tuple[FacetValue, ...]:
    columns = drive_modes.c
    verdicts = ("yes",) if strict else ("yes", "likely")
    query = (
        sa.select(columns.mode, sa.func.count(columns.device_id.distinct()))
        .where(columns.device_id.in_(ids), columns.kind == CIA402, columns.verdict.in_(verdicts))
        .group_by(columns.mode)
    )
    counted = {row[0]: row[1] for row in connection.execute(query)}
    return tuple(FacetValue(mode, mode, counted[mode]) for mode in MODES if mode in counted)


def _profiles(connection: sa.Connection, ids: Any) -> tuple[FacetValue, ...]:
    columns = profiles.c
    count = sa.func.count(columns.device_id.distinct())
    query = (
        sa.select(columns.profile_no, count)
        .where(columns.device_id.in_(ids), columns.profile_no.is_not(None))
        .group_by(columns.profile_no)
        .order_by(count.desc(), columns.profile_no)
        .limit(_MOST_PROFILES)
    )
    return tuple(FacetValue(str(number), str(number), n) for number, n in connection.execute(query))
