"""Vendor and groups of a device's document, as the vendor wrote them: what an ESI document needs beside the device."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import msgspec
import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.mapping import codec
from esicatalog.errors import NotFound
from esicatalog.esi.records.document import Group, Vendor


class DocumentParts(NamedTuple):
    """The vendor and all groups of the document section that a description stands in."""

    vendor: Vendor
    groups: tuple[Group, ...]

    def group(self, group_type: str | None) -> Group | None:
        """The group of a type; the first of several."""
        return next((group for group in self.groups if group.type == group_type), None)


def document_parts(connection: sa.Connection, device_id: int) -> DocumentParts:
    """Parts of the first document, by its name, that carries a description. Raises :class:`NotFound`."""
    placed, sources = schema.device_sources.c, schema.sources.c
    section = connection.execute(
        sa.select(placed.source_id, placed.section)
        .join(schema.sources, sources.id == placed.source_id)
        .where(placed.device_id == device_id)
        .order_by(sources.member, placed.line)
        .limit(1)
    ).first()
    if section is None:
        raise NotFound(f"no document carries the description with row number {device_id}")
    vendors, groups, links = schema.source_vendors.c, schema.groups.c, schema.source_groups.c
    vendor_rows = connection.execute(
        sa.select(*_columns(Vendor, vendors)).where(
            vendors.source_id == section.source_id, vendors.position == section.section
        )
    )
    group_rows = connection.execute(
        sa.select(*_columns(Group, groups))
        .join(schema.source_groups, links.group_id == groups.id)
        .where(links.source_id == section.source_id, links.section == section.section)
        .order_by(links.position)
    )
    vendor = _records(connection, Vendor, vendor_rows.all())
    return DocumentParts(vendor[0] if vendor else Vendor(), _records(connection, Group, group_rows.all()))


def _columns(record_type: Any, columns: Any) -> list[Any]:
    return [columns[column.name] for column in codec(record_type).stored_columns]


def _records(connection: sa.Connection, record_type: Any, rows: Sequence[Any]) -> tuple[Any, ...]:
    return tuple(_with_image(connection, codec(record_type).decode(tuple(row))) for row in rows)


def _with_image(connection: sa.Connection, record: Any) -> Any:
    """The record with the image's hex text in place of its key."""
    if record.image_data is None:
        return record
    images = schema.images.c
    found = connection.execute(
        sa.select(images.data, images.malformed).where(images.sha256 == record.image_data)
    ).first()
    text = None if found is None else found.malformed if found.data is None else found.data.hex().upper()
    return msgspec.structs.replace(record, image_data=text)
