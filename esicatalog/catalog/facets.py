"""How many of the found devices have what: counts beside the filters of a search page."""

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import msgspec
import sqlalchemy as sa

from esicatalog.catalog.conditions import Condition
from esicatalog.catalog.device_filter import MODES, SYNC_SIGNALS, DeviceFilter
from esicatalog.catalog.schema import (
    device_facts,
    device_modules,
    devices,
    drive_modes,
    mailboxes,
    profile_channels,
    profiles,
    vendors,
)
from esicatalog.catalog.search import ADDRESSED, conditions, fulfilled, matching_ids
from esicatalog.model.cia402 import CIA402
from esicatalog.model.device_words import MAILBOX_PROTOCOLS, protocol_name
from esicatalog.model.drive_modes import accepted_verdicts
from esicatalog.words import hex32

_MOST_VENDORS, _MOST_PROFILES = 30, 20
_PROPERTIES: dict[tuple[str, str], tuple[str, Any]] = {
    **{("sync", name): (name.upper(), device_facts.c[f"supports_{name}"] == sa.true()) for name in SYNC_SIGNALS},
    **{("protocol", name): (protocol_name(name), mailboxes.c[name] == sa.true()) for name in MAILBOX_PROTOCOLS},
    ("protocol", "fsoe"): ("FSoE (evidence)", device_facts.c.fsoe.is_not(None)),
}
"""What tables with one row a device tell: filter and word, label and condition."""
_ONE_WORD = {"sync": "sync", "protocol": "protocol", "profile": "profile_no"}
"""Filters that are one word, with their fields: another word takes the place of the chosen one."""


class FacetValue(NamedTuple):
    """A word of a filter, how it is shown, and the number of found devices that have it."""

    text: str
    label: str
    device_count: int


class Counts(NamedTuple):
    """How many devices there are, and by filter how many of them have what."""

    total: int
    addressed: int
    """How many of them have vendor id and product code, and so a page of their own."""
    facets: dict[str, tuple[FacetValue, ...]]


def counts(connection: sa.Connection, found: Sequence[Condition], wanted: DeviceFilter) -> Counts:
    """Counts by filter: vendor, mode, sync, protocol and profile, one statement each or fewer.

    A number is what choosing the word leads to: modes and vendors narrow what is found, a word of the other filters
    takes the place of the chosen one.
    """
    others = {name: msgspec.structs.replace(wanted, **{field: None}) for name, field in _ONE_WORD.items()}
    held = {other: list(conditions(connection, other)) for other in {*others.values()} - {wanted}} | {wanted: found}
    passes: dict[DeviceFilter, list[str]] = {wanted: []}
    for name in dict.fromkeys(name for name, _ in _PROPERTIES):
        passes.setdefault(others[name], []).append(name)
    totals: dict[DeviceFilter, tuple[int, int]] = {}
    facets: dict[str, tuple[FacetValue, ...]] = {}
    for other, names in passes.items():
        totals[other], counted = _properties(connection, fulfilled(held[other], other), names)
        facets |= counted
    return Counts(
        *totals[wanted],
        {
            "vendor": _vendors(connection, fulfilled(found, wanted)),
            "mode": _modes(connection, matching_ids(found, wanted), wanted.strict),
            **facets,
            "profile": _profiles(
                connection, matching_ids(held[others["profile"]], others["profile"]), wanted.profile_no
            ),
        },
    )


def _properties(
    connection: sa.Connection, fulfil: list[Any], names: Iterable[str]
) -> tuple[tuple[int, int], dict[str, tuple[FacetValue, ...]]]:
    """The number of devices, of addressed ones, and of those that have each property of these filters: in one pass."""
    asked = {key: property for key, property in _PROPERTIES.items() if key[0] in names}
    columns = [sa.func.count(sa.case((condition, 1))) for _, condition in asked.values()]
    tables = devices.outerjoin(device_facts, device_facts.c.device_id == devices.c.id).outerjoin(
        mailboxes, mailboxes.c.device_id == devices.c.id
    )
    addressed = sa.func.count(sa.case((ADDRESSED.sql, 1)))
    query = sa.select(sa.func.count(), addressed, *columns).select_from(tables).where(*fulfil)
    total, addressed_count, *numbers = connection.execute(query).one()
    facets: dict[str, tuple[FacetValue, ...]] = dict.fromkeys(names, ())
    for ((name, word), (label, _)), number in zip(asked.items(), numbers, strict=True):
        if number:
            facets[name] += (FacetValue(word, label, number),)
    return (total, addressed_count), facets


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
    found = connection.execute(query).all()
    often = Counter(name for _, name, _ in found)
    return tuple(FacetValue(f"0x{v:x}", _vendor_label(v, name, often[name] > 1), n) for v, name, n in found)


def _vendor_label(vendor_id: int, name: str | None, is_shared: bool) -> str:
    """The name, with the id where several ids have it; the id alone where there is no name."""
    number = hex32(vendor_id)
    if not name:
        return number
    return f"{name} ({number})" if is_shared else name


def _modes(connection: sa.Connection, ids: Any, strict: bool) -> tuple[FacetValue, ...]:
    columns = drive_modes.c
    query = (
        sa.select(columns.mode, sa.func.count(columns.device_id.distinct()))
        .where(columns.device_id.in_(ids), columns.kind == CIA402, columns.verdict.in_(accepted_verdicts(strict)))
        .group_by(columns.mode)
    )
    counted = {row[0]: row[1] for row in connection.execute(query)}
    return tuple(FacetValue(mode, mode, counted[mode]) for mode in MODES if mode in counted)


def _profiles(connection: sa.Connection, ids: Any, chosen: int | None) -> tuple[FacetValue, ...]:
    """Numbers of profiles and of their channels, of a device or of a module that its slots can reach."""
    found = ids.cte("found")
    is_found = sa.select(found.c.id)
    links, channels = device_modules.c, profile_channels.c
    own = sa.select(profiles.c.device_id, profiles.c.id).where(profiles.c.device_id.in_(is_found))
    modular = (
        sa.select(links.device_id, profiles.c.id)
        .join(device_modules, links.module_id == profiles.c.module_id)
        .where(links.device_id.in_(is_found))
    )
    owned = own.union_all(modular).cte("owned")
    numbers = (
        sa.select(owned.c.device_id, profiles.c.profile_no)
        .join(owned, owned.c.id == profiles.c.id)
        .union_all(sa.select(owned.c.device_id, channels.profile_no).join(owned, owned.c.id == channels.profile_id))
        .subquery()
    )
    count = sa.func.count(numbers.c.device_id.distinct())
    query = (
        sa.select(numbers.c.profile_no, count)
        .where(numbers.c.profile_no.is_not(None))
        .group_by(numbers.c.profile_no)
        # the chosen one can always be taken back
        .order_by(sa.case((numbers.c.profile_no == chosen, 0), else_=1), count.desc(), numbers.c.profile_no)
        .limit(_MOST_PROFILES)
    )
    return tuple(FacetValue(str(number), str(number), n) for number, n in connection.execute(query))
