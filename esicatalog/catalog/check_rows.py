"""What must hold of the rows of a sound catalog, whatever the database; a rule is a SELECT of what breaks it."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.garbage import unreferenced_rows
from esicatalog.catalog.schema import devices, modules, sources
from esicatalog.catalog.settle import carried_facts, preferred_variant, superseded_devices
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO

_OWNERS = ("device_id", "module_id", "source_id")
_SECTIONED = ("device_sources", "module_sources", "source_groups")
"""Tables whose rows are numbered within a section of a document."""
_LIST_NAMES = {"pdos": "direction", "initcmds": "protocol", "device_names": "kind"}
"""Columns that tell apart the lists that an owner has in one table."""
_IMAGE_DIRECTIONS = (RX_PDO, TX_PDO)


class RowRule(NamedTuple):
    """What breaks the rule in words, after their number, and a SELECT of one row for each."""

    words: str
    breaking: sa.Select[Any]


def rules() -> Iterator[RowRule]:
    """All rules, the plain ones first."""
    for name, breaking in unreferenced_rows():
        if name == "archives":
            continue  # An archive may be empty.
        carried = "that no document carries" if name in ("devices", "modules") else "that nothing refers to"
        yield RowRule(f"rows of {name} {carried}", breaking)
    yield from _owner_rules()
    yield from _count_rules()
    yield from _list_rules()
    yield from _device_rules()


def _owner_rules() -> Iterator[RowRule]:
    for table in schema.metadata.sorted_tables:
        owners = [table.c[name] for name in _OWNERS if name in table.c and table.c[name].nullable]
        if owners:
            held = sum((sa.case((owner.is_not(None), 1), else_=0) for owner in owners), sa.literal(0))
            yield RowRule(f"rows of {table.name} that do not belong to exactly one owner", _numbers(table, held != 1))


def _count_rules() -> Iterator[RowRule]:
    for kind in ("device", "module"):
        links = schema.metadata.tables[f"{kind}_sources"]
        held = _amount(links, links.c.source_id == sources.c.id)
        yield RowRule(
            f"documents whose {kind}_count is not the number of their {kind}s",
            _numbers(sources, sources.c[f"{kind}_count"] != held),
        )
    dictionaries, members = schema.dictionaries, schema.dictionary_objects
    yield RowRule(
        "dictionaries whose object_count is not the number of their objects",
        _numbers(
            dictionaries, dictionaries.c.object_count != _amount(members, members.c.dictionary_id == dictionaries.c.id)
        ),
    )
    reached = schema.device_modules.join(modules, modules.c.id == schema.device_modules.c.module_id)
    of_modules = (
        sa.select(sa.func.coalesce(sa.func.sum(modules.c.element_count), 0))
        .select_from(reached)
        .where(schema.device_modules.c.device_id == devices.c.id)
        .correlate(devices)
        .scalar_subquery()
    )
    for table, more in ((devices, of_modules), (modules, sa.literal(0))):
        yield RowRule(
            f"{table.name} whose element_count is not the number of their objects and PDO entries",
            _numbers(table, table.c.element_count != _own_elements(table) + more),
        )


def _own_elements(table: sa.Table) -> sa.ColumnElement[int]:
    """Objects and entries of RxPdo and TxPdo of a device or module itself."""
    owner = f"{table.name[:-1]}_id"
    profiles, dictionaries, pdos, entries = schema.profiles, schema.dictionaries, schema.pdos, schema.pdo_entries
    objects = (
        sa.select(sa.func.coalesce(sa.func.sum(dictionaries.c.object_count), 0))
        .select_from(profiles.join(dictionaries, dictionaries.c.id == profiles.c.dictionary_id))
        .where(profiles.c[owner] == table.c.id)
        .correlate(table)
        .scalar_subquery()
    )
    mapped = (
        sa.select(sa.func.count())
        .select_from(pdos.join(entries, entries.c.pdo_id == pdos.c.id))
        .where(pdos.c[owner] == table.c.id, pdos.c.direction.in_(_IMAGE_DIRECTIONS))
        .correlate(table)
        .scalar_subquery()
    )
    return objects + mapped


def _list_rules() -> Iterator[RowRule]:
    """Lists are complete: positions run from 0 without a gap."""
    for table in schema.metadata.sorted_tables:
        if "position" not in table.c:
            continue
        within, position = _list_columns(table), table.c.position
        broken = sa.or_(
            sa.func.min(position) != 0,
            sa.func.max(position) != sa.func.count() - 1,
            sa.func.count(position.distinct()) != sa.func.count(),
        )
        yield RowRule(
            f"lists in {table.name} whose positions do not run from 0",
            sa.select(sa.func.min(position)).group_by(*within).having(broken),
        )


def _list_columns(table: sa.Table) -> list[sa.Column[Any]]:
    """The columns that say to which list a row belongs."""
    if table.name in _SECTIONED:
        return [table.c.source_id, table.c.section]
    owners = [table.c[name] for name in _OWNERS if name in table.c and table.c[name].nullable]
    parents = [column for column in table.c if column.foreign_keys]
    named = _LIST_NAMES.get(table.name)
    return [*(owners or parents[:1]), *([table.c[named]] if named else [])]


def _device_rules() -> Iterator[RowRule]:
    columns = devices.c
    carried = carried_facts().subquery("carried")
    yield RowRule(
        "devices whose recovered, file_version or group_type is not what their documents say",
        sa.select(columns.id)
        .join(carried, carried.c.device_id == columns.id)
        .where(
            sa.or_(
                sa.cast(columns.recovered, sa.Integer) != carried.c.recovered,
                columns.file_version.is_distinct_from(carried.c.file_version),
                columns.group_type.is_distinct_from(carried.c.group_type),
            )
        ),
    )
    ranked = sa.select(columns.id, columns.variant, preferred_variant().label("preferred")).subquery("ranked")
    yield RowRule(
        "devices whose variants are not numbered from 1 in the order of preference",
        sa.select(ranked.c.id).where(ranked.c.variant != ranked.c.preferred),
    )
    superseded = superseded_devices()
    yield RowRule(
        "devices that are hidden although nothing supersedes them, or the other way round",
        _numbers(devices, columns.hidden != columns.id.in_(superseded)),
    )
    facts = schema.device_facts.c
    yield RowRule("devices without device_facts", _numbers(devices, ~sa.exists().where(facts.device_id == columns.id)))


def _numbers(table: sa.Table, condition: sa.ColumnElement[bool]) -> sa.Select[Any]:
    return sa.select(table.c.id).where(condition)


def _amount(table: sa.Table, condition: sa.ColumnElement[bool]) -> sa.ScalarSelect[int]:
    return sa.select(sa.func.count()).select_from(table).where(condition).correlate_except(table).scalar_subquery()
