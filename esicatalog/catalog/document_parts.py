"""What ESI documents need beside devices: vendor and groups as their documents write them, modules of no device."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import msgspec
import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.mapping import codec
from esicatalog.catalog.pictures import picture_texts
from esicatalog.catalog.query import ConnectionQuery
from esicatalog.catalog.reader import RecordReader
from esicatalog.catalog.results import UnreachedModules
from esicatalog.errors import NotFound
from esicatalog.esi.records.document import Group, Vendor


class DocumentParts(NamedTuple):
    """The vendor and all groups of the document section that a description stands in."""

    vendor: Vendor
    groups: tuple[Group, ...]


def document_parts(connection: sa.Connection, device_id: int) -> DocumentParts:
    """Parts of the first document, by its name, that carries a description. Raises :class:`NotFound`."""
    placed, sources = schema.device_sources.c, schema.sources.c
    section = connection.execute(
        sa.select(placed.source_id, placed.section)
        .join(schema.sources, sources.id == placed.source_id)
        .where(placed.device_id == device_id)
        .order_by(sources.member, placed.line, sources.location)
        .limit(1)
    ).first()
    if section is None:
        raise NotFound(f"no document carries the description with row number {device_id}")
    groups, links = schema.groups.c, schema.source_groups.c
    group_rows = connection.execute(
        sa.select(*codec(Group).stored(groups))
        .join(schema.source_groups, links.group_id == groups.id)
        .where(links.source_id == section.source_id, links.section == section.section)
        .order_by(links.position)
    )
    return DocumentParts(_vendor_of(connection, section), _records(connection, Group, group_rows.all()))


def unreached_modules(connection: sa.Connection, vendor_id: int) -> UnreachedModules:
    """The modules of a vendor that no slot of any description reaches, in the order of their documents' names."""
    modules, placed, sources, links = (
        table.c for table in (schema.modules, schema.module_sources, schema.sources, schema.device_modules)
    )
    rows = connection.execute(
        sa.select(placed.module_id, placed.source_id, placed.section)
        .join(schema.sources, sources.id == placed.source_id)
        .join(schema.modules, modules.id == placed.module_id)
        .where(modules.vendor_id == vendor_id, ~sa.exists().where(links.module_id == modules.id))
        .order_by(sources.member, placed.line, sources.location)
    ).all()
    numbers = list(dict.fromkeys(row.module_id for row in rows))
    vendor = _vendor_of(connection, rows[0]) if rows else Vendor(vendor_id=vendor_id)
    return UnreachedModules(vendor, tuple(RecordReader(ConnectionQuery(connection)).modules(numbers)))


def _vendor_of(connection: sa.Connection, section: Any) -> Vendor:
    """The vendor in a section of a document, given a row with both numbers."""
    vendors = schema.source_vendors.c
    rows = connection.execute(
        sa.select(*codec(Vendor).stored(vendors)).where(
            vendors.source_id == section.source_id, vendors.position == section.section
        )
    )
    return next(iter(_records(connection, Vendor, rows.all())), Vendor())


def _records(connection: sa.Connection, record_type: Any, rows: Sequence[Any]) -> tuple[Any, ...]:
    """Records of rows, with the images' hex texts in place of their keys."""
    records = [codec(record_type).decode(tuple(row)) for row in rows]
    texts = picture_texts(
        ConnectionQuery(connection), {record.image_data for record in records if record.image_data is not None}
    )
    return tuple(
        record
        if record.image_data is None
        else msgspec.structs.replace(record, image_data=texts.get(record.image_data))
        for record in records
    )
