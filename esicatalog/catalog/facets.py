"""How many of the found devices have what: counts beside the filters of a search page."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog.conditions import Condition
from esicatalog.catalog.device_filter import MODES, SYNC_SIGNALS, DeviceFilter
from esicatalog.catalog.schema import device_facts, devices, drive_modes, mailboxes, profiles, vendors
from esicatalog.catalog.search import matching_ids
from esicatalog.model.cia402 import CIA402
from esicatalog.model.words import MAILBOX_PROTOCOLS, protocol_name

_MOST_VENDORS, _MOST_PROFILES = 30, 20


class FacetValue(NamedTuple):
    """A word of a filter, how it is shown, and the number of found devices that have it."""

    text: str
    label: str
    device_count: int


def facets(
    connection: sa.Connection, found: Sequence[Condition], wanted: DeviceFilter
) -> dict[str, tuple[FacetValue, ...]]:
    """Counts by filter: vendor, mode, sync, protocol and profile. One query a filter, whatever is found."""
    ids = matching_ids(found, wanted)
    return {
        "vendor": _vendors(connection, ids),
        "mode": _modes(connection, ids, wanted.strict),
        "sync": _flags(connection, ids, device_facts, {name: f"supports_{name}" for name in SYNC_SIGNALS}),
        "protocol": (
            *_flags(connection, ids, mailboxes, {name: name for name in MAILBOX_PROTOCOLS}),
            *_fsoe(connection, ids),
        ),
        "profile": _profiles(connection, ids),
    }


def _vendors(connection: sa.Connection, ids: Any) -> tuple[FacetValue, ...]:
    count = sa.func.count()
    query = (
        sa.select(devices.c.vendor_id, vendors.c.name, count)
        .outerjoin(vendors, vendors.c.vendor_id == devices.c.vendor_id)
        .where(devices.c.id.in_(ids), devices.c.vendor_id.is_not(None))
        .group_by(devices.c.vendor_id, vendors.c.name)
        .order_by(count.desc(), devices.c.vendor_id)
        .limit(_MOST_VENDORS)
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


def _flags(connection: sa.Connection, ids: Any, table: sa.Table, columns: dict[str, str]) -> tuple[FacetValue, ...]:
    counts = [sa.func.sum(sa.case((table.c[column] == sa.true(), 1), else_=0)) for column in columns.values()]
    row = connection.execute(sa.select(*counts).where(table.c.device_id.in_(ids))).one()
    labels = {name: name.upper() if name.startswith("sync") else protocol_name(name) for name in columns}
    return tuple(FacetValue(name, labels[name], n) for name, n in zip(columns, row, strict=True) if n)


def _fsoe(connection: sa.Connection, ids: Any) -> tuple[FacetValue, ...]:
    facts = device_facts.c
    query = sa.select(sa.func.count()).where(facts.device_id.in_(ids), facts.fsoe.is_not(None))
    count = connection.execute(query).scalar_one()
    return (FacetValue("fsoe", "FSoE (evidence)", count),) if count else ()


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
