"""Putting the catalog in order after documents came or went: names of vendors, variants, hidden revisions, search.

All of it follows from the stored rows alone, so that any order of ingest gives the same catalog.
"""

from collections import defaultdict
from collections.abc import Iterable
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.document_status import RECOVERED
from esicatalog.catalog.full_text import index_devices
from esicatalog.catalog.schema import device_sources, devices, source_vendors, sources
from esicatalog.catalog.spelled_vendors import OF_SECTION, store_own_vendor_names, store_vendor_names
from esicatalog.catalog.state import CONTENT_HASH, read_state, store_hashes


class Affected:
    """Which devices and vendors have to be looked at again."""

    def __init__(self) -> None:
        self.devices: set[int] = set()
        self.vendors: set[int] = set()
        self.products: set[tuple[int | None, int | None]] = set()
        """Vendor and product code of deleted descriptions."""


def settle(connection: sa.Connection, affected: Affected) -> None:
    """Bring everything that depends on several documents up to date."""
    renamed = store_vendor_names(connection, affected.vendors)
    if affected.devices or affected.products:
        _settle_devices(connection, affected)
    concerned = affected.devices | _devices_of(connection, renamed)
    shared = store_own_vendor_names(connection, concerned)
    index_devices(connection, concerned | _devices_of(connection, shared))
    settle_hidden(connection, affected.vendors | {vendor_id for vendor_id, _ in affected.products})


def _devices_of(connection: sa.Connection, vendor_ids: set[int]) -> set[int]:
    found: set[int] = set()
    for part in chunks(sorted(vendor_ids)):
        found.update(connection.execute(sa.select(devices.c.id).where(devices.c.vendor_id.in_(part))).scalars())
    return found


def carried_facts() -> sa.Select[Any]:
    """What the documents that carry a description say of it, by device: recovered, file_version, group_type."""
    return (
        sa.select(
            device_sources.c.device_id,
            sa.func.min(sa.case((sources.c.status == RECOVERED, 1), else_=0)).label("recovered"),
            sa.func.max(source_vendors.c.file_version).label("file_version"),
            sa.func.min(device_sources.c.group_type).label("group_type"),
        )
        .join(sources, sources.c.id == device_sources.c.source_id)
        .outerjoin(source_vendors, OF_SECTION)
        .group_by(device_sources.c.device_id)
    )


def _settle_devices(connection: sa.Connection, affected: Affected) -> None:
    carried = carried_facts()
    update = (
        sa.update(devices)
        .where(devices.c.id == sa.bindparam("number"))
        .values(
            recovered=sa.bindparam("is_recovered"), file_version=sa.bindparam("version"), group_type=sa.bindparam("g")
        )
    )
    product = sa.select(devices.c.vendor_id, devices.c.product_code)
    products = set(affected.products)
    for part in chunks(sorted(affected.devices)):
        facts = connection.execute(carried.where(device_sources.c.device_id.in_(part))).all()
        if facts:
            connection.execute(
                update, [{"number": n, "is_recovered": bool(r), "version": v, "g": g} for n, r, v, g in facts]
            )
        products.update(map(tuple, connection.execute(product.where(devices.c.id.in_(part)))))
    _number_variants(connection, products)


def number_variants_again(connection: sa.Connection) -> None:
    """Number the variants of all descriptions by today's rules; the content hash tells of variants, and follows."""
    products = sa.select(devices.c.vendor_id, devices.c.product_code).distinct()
    _number_variants(connection, map(tuple, connection.execute(products).all()))
    if read_state(connection, CONTENT_HASH) is not None:
        store_hashes(connection)


def preferred_variant() -> sa.ColumnElement[int]:
    """The number of a description among the variants of its identity, of all of which it has to be selected.

    Variant 1 is the preferred one: not recovered, richest, newest file version, lowest content hash. Variants share
    vendor, product and revision; without product code the type decides. A missing revision does not: devices are asked
    for by product, and the type is no part of what is asked.
    """
    columns = devices.c
    type_of_unknown = sa.case((columns.product_code.is_(None), columns.type), else_=None)
    return sa.func.row_number().over(
        partition_by=(columns.vendor_id, columns.product_code, columns.revision_no, type_of_unknown),
        order_by=(
            columns.recovered,
            columns.element_count.desc(),
            sa.func.coalesce(columns.file_version, 0).desc(),
            columns.content_hash,
        ),
    )


def _number_variants(connection: sa.Connection, products: Iterable[tuple[int | None, int | None]]) -> None:
    columns = devices.c
    query = sa.select(columns.id, columns.variant, preferred_variant().label("preferred"))
    of_vendors: dict[int | None, set[int | None]] = defaultdict(set)
    for vendor_id, product_code in products:
        of_vendors[vendor_id].add(product_code)
    moved: list[dict[str, int]] = []
    numbered: list[dict[str, int]] = []
    for vendor_id, codes in of_vendors.items():
        conditions = [columns.product_code.in_(part) for part in chunks(sorted(c for c in codes if c is not None))]
        if None in codes:
            conditions.append(columns.product_code.is_(None))
        for condition in conditions:
            for row in connection.execute(query.where(columns.vendor_id == vendor_id, condition)):
                if row.variant != row.preferred:
                    numbered.append({"number": row.id, "to": row.preferred})
                    if row.variant > 0:  # It may stand in the way of another one; those that are new do not.
                        moved.append({"number": row.id, "to": -row.id})
    update = sa.update(devices).where(devices.c.id == sa.bindparam("number")).values(variant=sa.bindparam("to"))
    for changes in (moved, numbered):
        if changes:
            connection.execute(update, changes)


_HIDING = devices.alias("hiding")


def superseded_devices() -> sa.Select[tuple[int]]:
    """Numbers of the descriptions that some other description of the same vendor supersedes.

    The rule is :func:`~esicatalog.model.revisions.hidden_by`.
    """
    hiding, columns, named = _HIDING, devices.c, schema.hidden_revisions.c
    return (
        sa.select(columns.id)
        .select_from(schema.hidden_revisions)
        .join(hiding, hiding.c.id == named.device_id)
        .join(
            devices,
            (columns.vendor_id == hiding.c.vendor_id)
            & (columns.product_code == sa.func.coalesce(named.product_code, hiding.c.product_code))
            & (columns.revision_no == named.revision_no),
        )
        .where(
            columns.product_code.is_distinct_from(hiding.c.product_code)
            | columns.revision_no.is_distinct_from(hiding.c.revision_no)
        )
    )


def settle_hidden(connection: sa.Connection, vendor_ids: Iterable[int | None]) -> None:
    """Mark the revisions of these vendors that are superseded."""
    columns, superseded = devices.c, superseded_devices()
    update = sa.update(devices).where(columns.id == sa.bindparam("number")).values(hidden=sa.bindparam("is_hidden"))
    for part in chunks(sorted(vendor_id for vendor_id in vendor_ids if vendor_id is not None)):
        wanted = set(connection.execute(superseded.where(_HIDING.c.vendor_id.in_(part))).scalars())
        marked = sa.select(columns.id).where(columns.vendor_id.in_(part), columns.hidden == sa.true())
        stored = set(connection.execute(marked).scalars())
        if wanted != stored:
            changes = [{"number": number, "is_hidden": number in wanted} for number in sorted(wanted ^ stored)]
            connection.execute(update, changes)
