"""Deriving anew what descriptions imply, for catalogs that an older version made."""

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.bulk import RowBuffer, chunks
from esicatalog.catalog.derived import PdoPlaces, derived_rows, pdo_places
from esicatalog.catalog.query import ConnectionQuery
from esicatalog.catalog.reader import RecordReader
from esicatalog.catalog.settle import number_variants_again, settle_hidden
from esicatalog.catalog.spelled_vendors import store_own_vendor_names, store_vendor_names
from esicatalog.model.derivation import Deriver

_BATCH = 200


def derive_again(connection: sa.Connection) -> None:
    """Replace all that is derived, numbers of variants too, by what this version derives from the descriptions."""
    for table in (schema.device_facts, schema.drive_modes, schema.mode_evidence):
        connection.execute(sa.delete(table))
    connection.execute(sa.update(schema.pdo_entries).values(image_bit_offset=None))
    connection.execute(sa.update(schema.pdos).values(image_sm=None))
    buffer = RowBuffer(connection)
    for part in chunks(connection.execute(sa.select(schema.devices.c.id)).scalars(), _BATCH):
        reader = RecordReader(ConnectionQuery(connection))
        modules, deriver = reader.modules_of_each(part), Deriver()
        for number, device in zip(part, reader.devices(part), strict=True):
            derived = deriver.derive(device, modules[number])
            buffer.add_derived(number, derived_rows(derived))
            _write_places(connection, number, pdo_places(derived.images))
        buffer.flush()
    number_variants_again(connection)
    vendor_ids = connection.execute(sa.select(schema.vendors.c.vendor_id)).scalars().all()
    store_vendor_names(connection, set(vendor_ids))
    store_own_vendor_names(connection, connection.execute(sa.select(schema.devices.c.id)).scalars())
    settle_hidden(connection, vendor_ids)


def _write_places(connection: sa.Connection, device_id: int, places: PdoPlaces) -> None:
    pdos, entries = schema.pdos.c, schema.pdo_entries.c
    query = sa.select(pdos.id, pdos.direction, pdos.position).where(pdos.device_id == device_id)
    for number, direction, position in connection.execute(query).all():
        place = places.get((direction, position))
        if place is None:
            continue
        sm, offsets = place
        connection.execute(sa.update(schema.pdos).where(pdos.id == number).values(image_sm=sm))
        if offsets:
            connection.execute(
                sa.update(schema.pdo_entries)
                .where(entries.pdo_id == number, entries.position == sa.bindparam("at"))
                .values(image_bit_offset=sa.bindparam("offset")),
                [{"at": at, "offset": offset} for at, offset in enumerate(offsets)],
            )
