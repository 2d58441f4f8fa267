"""Under which name each vendor is shown, and each device where several makers use one vendor id.

Documents spell a vendor's name in many ways: all of them are kept with how often they occur, one is shown.
"""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog.bulk import RowBuffer, chunks
from esicatalog.catalog.mapping import codec
from esicatalog.catalog.schema import device_sources, devices, source_vendors, vendor_names, vendors
from esicatalog.esi.records.common import ENGLISH
from esicatalog.esi.records.document import Vendor
from esicatalog.model.vendor_names import own_vendor_name

OF_SECTION = (source_vendors.c.source_id == device_sources.c.source_id) & (
    source_vendors.c.position == device_sources.c.section
)
"""Which vendor a document names where it carries a device."""

_Spelling = tuple[int | None, str, int]
"""LcId, name, and how many documents have it."""


class _Vendor(NamedTuple):
    """What is said of a vendor id: spellings, the most frequent first, the one that is shown, and an image."""

    spellings: list[_Spelling]
    shown_name: str | None
    image_sha256: str | None


def store_vendor_names(connection: sa.Connection, vendor_ids: set[int]) -> set[int]:
    """Store what documents say of vendors; returns those that now have other names, or are shown by another."""
    written, stored = _written(connection, vendor_ids), _stored(connection, vendor_ids)
    buffer = RowBuffer(connection)
    for part in chunks(sorted(vendor_ids)):
        connection.execute(sa.delete(vendor_names).where(vendor_names.c.vendor_id.in_(part)))
    for vendor_id in sorted(vendor_ids):
        vendor = written[vendor_id]
        buffer.add_numbered("vendor_names", [(vendor_id, *spelling) for spelling in vendor.spellings])
        connection.execute(
            sa.update(vendors)
            .where(vendors.c.vendor_id == vendor_id)
            .values(name=vendor.shown_name, image_sha256=vendor.image_sha256)
        )
    buffer.flush()
    return {vendor_id for vendor_id in vendor_ids if _names(written[vendor_id]) != _names(stored[vendor_id])}


def _names(vendor: _Vendor) -> tuple[set[str], str | None]:
    return {name for _, name, _ in vendor.spellings}, vendor.shown_name


def _written(connection: sa.Connection, vendor_ids: Iterable[int]) -> dict[int, _Vendor]:
    """What the vendor sections of all documents say; a document may have several of one vendor."""
    names: dict[int, set[tuple[int, int | None, str]]] = defaultdict(set)
    images: dict[int, set[str]] = defaultdict(set)
    vendor_codec = codec(Vendor)
    columns = vendor_codec.stored(source_vendors.c)
    for part in chunks(sorted(vendor_ids)):
        query = sa.select(source_vendors.c.source_id, *columns).where(source_vendors.c.vendor_id.in_(part))
        for source_id, *row in connection.execute(query):
            vendor = vendor_codec.decode(row)
            names[vendor.vendor_id].update((source_id, name.lcid, name.text) for name in vendor.names)
            if vendor.image_data:
                images[vendor.vendor_id].add(vendor.image_data)
    found = {}
    for vendor_id in vendor_ids:
        counted = Counter((lcid, name) for _, lcid, name in names[vendor_id])
        ranked = sorted(counted.items(), key=lambda item: (-item[1], str(item[0])))
        spellings = [(lcid, name, count) for (lcid, name), count in ranked]
        found[vendor_id] = _Vendor(spellings, _shown_name(counted), min(images[vendor_id], default=None))
    return found


def _shown_name(counted: Counter[tuple[int | None, str]]) -> str | None:
    def rank(item: tuple[tuple[int | None, str], int]) -> tuple[Any, ...]:
        (lcid, name), count = item
        return (not name, lcid not in (ENGLISH, None, 0), -count, name)

    return min(counted.items(), key=rank)[0][1] if counted else None


def _stored(connection: sa.Connection, vendor_ids: Iterable[int]) -> dict[int, _Vendor]:
    spellings: dict[int, list[_Spelling]] = defaultdict(list)
    shown: dict[int, tuple[str | None, str | None]] = {}
    columns, spelled = vendors.c, vendor_names.c
    for part in chunks(sorted(vendor_ids)):
        held = sa.select(spelled.vendor_id, spelled.lcid, spelled.name, spelled.document_count)
        for vendor_id, *spelling in connection.execute(held.where(spelled.vendor_id.in_(part)).order_by(spelled.id)):
            spellings[vendor_id].append(tuple(spelling))
        query = sa.select(columns.vendor_id, columns.name, columns.image_sha256).where(columns.vendor_id.in_(part))
        shown.update((vendor_id, (name, image)) for vendor_id, name, image in connection.execute(query))
    return {vendor_id: _Vendor(spellings[vendor_id], *shown.get(vendor_id, (None, None))) for vendor_id in vendor_ids}


class _NamedDevice(NamedTuple):
    """A device that may be another maker's than its vendor id says: under which name it is shown, and should be."""

    device_id: int
    vendor_id: int
    stored_name: str | None
    own_name: str | None


def store_own_vendor_names(connection: sa.Connection, device_ids: Iterable[int]) -> set[int]:
    """Store whom the documents of these devices name as vendor, where several makers use its id.

    Returns the ids with which that has changed.
    """
    changed = [device for device in _named_devices(connection, device_ids) if device.own_name != device.stored_name]
    if changed:
        update = sa.update(devices).where(devices.c.id == sa.bindparam("number"))
        connection.execute(
            update.values(own_vendor_name=sa.bindparam("own_name")),
            [{"number": device.device_id, "own_name": device.own_name} for device in changed],
        )
    return {device.vendor_id for device in changed}


def _named_devices(connection: sa.Connection, device_ids: Iterable[int]) -> Iterator[_NamedDevice]:
    columns, spelled = devices.c, vendor_names.c
    is_spelled_otherwise = sa.exists().where(spelled.vendor_id == vendors.c.vendor_id, spelled.name != vendors.c.name)
    query = (
        sa.select(
            columns.id,
            columns.vendor_id,
            columns.own_vendor_name,
            vendors.c.name,
            source_vendors.c.name.label("written"),
        )
        .join(vendors, vendors.c.vendor_id == columns.vendor_id)
        .join(device_sources, device_sources.c.device_id == columns.id)
        .join(source_vendors, OF_SECTION)
        .where(sa.or_(is_spelled_otherwise, columns.own_vendor_name.is_not(None)))
        .order_by(columns.id)
    )
    for part in chunks(sorted(device_ids)):
        named = groupby(connection.execute(query.where(columns.id.in_(part))), key=lambda row: row[:4])
        for (number, vendor_id, stored, vendor_name), rows in named:
            own_name = own_vendor_name(vendor_name, [row.written for row in rows])
            yield _NamedDevice(number, vendor_id, stored, own_name)


def vendor_problems(connection: sa.Connection) -> Iterator[str]:
    """Vendors and devices whose stored names are not those that documents give them."""
    vendor_ids = connection.execute(sa.select(vendors.c.vendor_id)).scalars().all()
    written, stored = _written(connection, vendor_ids), _stored(connection, vendor_ids)
    wrong = sum(written[vendor_id] != stored[vendor_id] for vendor_id in vendor_ids)
    if wrong:
        yield f"{wrong} vendors whose names or image are not what their documents say"
    device_ids = connection.execute(sa.select(devices.c.id)).scalars()
    wrong = sum(device.own_name != device.stored_name for device in _named_devices(connection, device_ids))
    if wrong:
        yield f"{wrong} devices whose own_vendor_name is not what their documents say"
