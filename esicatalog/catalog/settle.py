"""Putting the catalog in order after documents came or went: variants, vendors, search.

All of it follows from the stored rows alone, so that any order of ingest gives the same catalog.
"""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.bulk import RowBuffer, chunks
from esicatalog.catalog.full_text import index_devices
from esicatalog.catalog.mapping import CHILDREN, TABLE_RECORDS, codec
from esicatalog.catalog.schema import device_sources, devices, source_vendors, sources, vendor_names, vendors
from esicatalog.catalog.state import CONTENT_HASH, read_state, store_hashes
from esicatalog.esi.records.common import ENGLISH
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import Vendor
from esicatalog.esi.records.module import Module
from esicatalog.model.vendor_names import own_vendor_name

_OF_SECTION = (source_vendors.c.source_id == device_sources.c.source_id) & (
    source_vendors.c.position == device_sources.c.section
)
"""Which vendor a document names where it carries a device."""


class Affected:
    """Which devices and vendors have to be looked at again."""

    def __init__(self) -> None:
        self.devices: set[int] = set()
        self.vendors: set[int] = set()
        self.products: set[tuple[int | None, int | None]] = set()
        """Vendor and product code of deleted descriptions."""


def settle(connection: sa.Connection, affected: Affected) -> None:
    """Bring everything that depends on several documents up to date."""
    renamed = _settle_vendors(connection, affected.vendors)
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


def _settle_vendors(connection: sa.Connection, vendor_ids: set[int]) -> set[int]:
    """Count the spellings of vendors' names; returns the vendors that now have other names, or are shown by another."""
    spellings: dict[int, Counter[tuple[int | None, str]]] = defaultdict(Counter)
    images: dict[int, set[str]] = defaultdict(set)
    vendor_codec = codec(Vendor)
    columns = vendor_codec.stored(source_vendors.c)
    known: dict[int, set[str]] = defaultdict(set)
    shown: dict[int, str | None] = {}
    for part in chunks(sorted(vendor_ids)):
        held = sa.select(vendor_names.c.vendor_id, vendor_names.c.name).where(vendor_names.c.vendor_id.in_(part))
        for vendor_id, name in connection.execute(held):
            known[vendor_id].add(name)
        named = sa.select(vendors.c.vendor_id, vendors.c.name).where(vendors.c.vendor_id.in_(part))
        shown.update((row.vendor_id, row.name) for row in connection.execute(named))
        for row in connection.execute(sa.select(*columns).where(source_vendors.c.vendor_id.in_(part))):
            vendor = vendor_codec.decode(row)
            spellings[vendor.vendor_id].update({(name.lcid, name.text) for name in vendor.names})
            if vendor.image_data:
                images[vendor.vendor_id].add(vendor.image_data)
        connection.execute(sa.delete(vendor_names).where(vendor_names.c.vendor_id.in_(part)))
    buffer = RowBuffer(connection)
    renamed: set[int] = set()
    for vendor_id in sorted(vendor_ids):
        counted = spellings[vendor_id]
        ranked = sorted(counted.items(), key=lambda item: (-item[1], str(item[0])))
        buffer.add_numbered("vendor_names", [(vendor_id, lcid, name, count) for (lcid, name), count in ranked])
        shown_name = _shown_name(counted)
        if known[vendor_id] != {name for _, name in counted} or shown.get(vendor_id) != shown_name:
            renamed.add(vendor_id)
        connection.execute(
            sa.update(vendors)
            .where(vendors.c.vendor_id == vendor_id)
            .values(name=shown_name, image_sha256=min(images[vendor_id], default=None))
        )
    buffer.flush()
    return renamed


def _shown_name(counted: Counter[tuple[int | None, str]]) -> str | None:
    def rank(item: tuple[tuple[int | None, str], int]) -> tuple[Any, ...]:
        (lcid, name), count = item
        return (not name, lcid not in (ENGLISH, None, 0), -count, name)

    return min(counted.items(), key=rank)[0][1] if counted else None


def store_own_vendor_names(connection: sa.Connection, device_ids: Iterable[int]) -> set[int]:
    """Store whom the documents of these devices name as vendor, where several makers use its id.

    Returns the ids with which that has changed.
    """
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
        .join(source_vendors, _OF_SECTION)
        .where(sa.or_(is_spelled_otherwise, columns.own_vendor_name.is_not(None)))
        .order_by(columns.id)
    )
    changes = []
    shared: set[int] = set()
    for part in chunks(sorted(device_ids)):
        named = groupby(connection.execute(query.where(columns.id.in_(part))), key=lambda row: row[:4])
        for (number, vendor_id, stored, vendor_name), rows in named:
            name = own_vendor_name(vendor_name, [row.written for row in rows])
            if name != stored:
                changes.append({"number": number, "own_name": name})
                shared.add(vendor_id)
    if changes:
        update = sa.update(devices).where(columns.id == sa.bindparam("number"))
        connection.execute(update.values(own_vendor_name=sa.bindparam("own_name")), changes)
    return shared


def carried_facts() -> sa.Select[Any]:
    """What the documents that carry a description say of it, by device: recovered, file_version, group_type."""
    return (
        sa.select(
            device_sources.c.device_id,
            sa.func.min(sa.case((sources.c.status == "recovered", 1), else_=0)).label("recovered"),
            sa.func.max(source_vendors.c.file_version).label("file_version"),
            sa.func.min(device_sources.c.group_type).label("group_type"),
        )
        .join(sources, sources.c.id == device_sources.c.source_id)
        .outerjoin(source_vendors, _OF_SECTION)
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


def collect_garbage(connection: sa.Connection, affected: Affected) -> bool:
    """Delete what no document carries any more; tells whether anything went."""
    orphans = _unreferenced("devices", "id", _DEVICE_KEEPERS)
    gone = connection.execute(
        sa.select(devices.c.id, devices.c.vendor_id, devices.c.product_code).where(devices.c.id.in_(orphans))
    ).all()
    deleted = len(gone)
    for part in chunks([row.id for row in gone]):
        _delete_owned(connection, "device_id", part)
        connection.execute(sa.delete(devices).where(devices.c.id.in_(part)))
    for row in gone:
        affected.devices.discard(row.id)
        affected.products.add((row.vendor_id, row.product_code))
    index_devices(connection, [row.id for row in gone])
    modules = schema.modules
    for part in chunks(connection.execute(_unreferenced("modules", "id", _MODULE_KEEPERS)).scalars().all()):
        _delete_owned(connection, "module_id", part)
        connection.execute(sa.delete(modules).where(modules.c.id.in_(part)))
        deleted += len(part)
    return _delete_unreferenced(connection) or deleted > 0


_DEVICE_KEEPERS = (("device_sources", "device_id"),)
_MODULE_KEEPERS = (("module_sources", "module_id"), ("device_modules", "module_id"))

_PARTS = [
    (parent, child.table)
    for record in (Device, Module)
    for owned in CHILDREN[record]
    for parent in (owned.table,)
    for child in CHILDREN.get(TABLE_RECORDS[parent], ())
    if child.under_parent
]
"""Tables whose rows hang on rows of devices and modules: (parent table, table)."""


def _delete_owned(connection: sa.Connection, owner: str, numbers: list[int]) -> None:
    """Delete the rows of devices or modules, those of their rows first."""
    for parent, child in _PARTS:
        parents, children = schema.metadata.tables[parent], schema.metadata.tables[child]
        held = sa.select(parents.c.id).where(parents.c[owner].in_(numbers))
        connection.execute(sa.delete(children).where(children.c[schema.parent_column(parent)].in_(held)))
    for table in reversed(schema.metadata.sorted_tables):
        if owner in table.c:
            connection.execute(sa.delete(table).where(table.c[owner].in_(numbers)))


_UNREFERENCED: tuple[tuple[str, str, tuple[tuple[str, str], ...], tuple[tuple[str, str], ...]], ...] = (
    # table, key, columns that keep a row alive, tables that go with it
    ("archives", "id", (("sources", "archive_id"),), ()),
    (
        "dictionaries",
        "id",
        (("profiles", "dictionary_id"), ("sources", "dictionary_id")),
        (("dictionary_objects", "dictionary_id"),),
    ),
    (
        "diagnostics",
        "id",
        (("profiles", "diagnostics_id"), ("sources", "diagnostics_id")),
        (("diag_messages", "diagnostics_id"),),
    ),
    ("objects", "id", (("dictionary_objects", "object_id"),), (("object_entries", "object_id"),)),
    ("type_sets", "id", (("dictionaries", "type_set_id"),), (("type_set_data_types", "type_set_id"),)),
    (
        "data_types",
        "id",
        (("type_set_data_types", "data_type_id"),),
        (("sub_items", "data_type_id"), ("enum_values", "data_type_id")),
    ),
    ("groups", "id", (("source_groups", "group_id"),), ()),
    (
        "vendors",
        "vendor_id",
        (("source_vendors", "vendor_id"), ("devices", "vendor_id"), ("modules", "vendor_id")),
        (("vendor_names", "vendor_id"),),
    ),
    (
        "images",
        "sha256",
        tuple((table.name, "image_sha256") for table in schema.metadata.sorted_tables if "image_sha256" in table.c),
        (),
    ),
)


def _unreferenced(name: str, key: str, keepers: Iterable[tuple[str, str]]) -> sa.Select[Any]:
    """Keys of the rows of a table that no keeper (table, column) refers to."""
    table = schema.metadata.tables[name]
    conditions = [
        ~sa.exists().where(schema.metadata.tables[keeper].c[column] == table.c[key]) for keeper, column in keepers
    ]
    return sa.select(table.c[key]).where(*conditions)


def unreferenced_rows() -> Iterator[tuple[str, sa.Select[Any]]]:
    """Tables whose rows live as long as something refers to them, and the keys of those that nothing refers to."""
    yield "devices", _unreferenced("devices", "id", _DEVICE_KEEPERS)
    yield "modules", _unreferenced("modules", "id", _MODULE_KEEPERS)
    for name, key, keepers, _ in _UNREFERENCED:
        yield name, _unreferenced(name, key, keepers)


def _delete_unreferenced(connection: sa.Connection) -> bool:
    deleted = False
    for name, key, keepers, parts in _UNREFERENCED:
        table = schema.metadata.tables[name]
        unused = connection.execute(_unreferenced(name, key, keepers)).scalars().all()
        for part in chunks(unused):
            for child, column in parts:
                held = schema.metadata.tables[child]
                connection.execute(sa.delete(held).where(held.c[column].in_(part)))
            connection.execute(sa.delete(table).where(table.c[key].in_(part)))
        deleted = deleted or bool(unused)
    return deleted
