"""What no document carries any more: found, and deleted."""

from collections.abc import Iterable, Iterator
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.full_text import index_devices
from esicatalog.catalog.mapping import CHILDREN, TABLE_RECORDS
from esicatalog.catalog.schema import devices
from esicatalog.catalog.settle import Affected
from esicatalog.catalog.table_kinds import parent_column
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module


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
        connection.execute(sa.delete(children).where(children.c[parent_column(parent)].in_(held)))
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
