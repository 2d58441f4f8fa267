"""Which devices can do X: filters become the conditions of one SELECT, and every answer carries its evidence."""

from collections.abc import Callable, Sequence
from typing import Any

import msgspec
import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.full_text import search_expression
from esicatalog.catalog.identify import summary
from esicatalog.catalog.results import FoundDevice
from esicatalog.catalog.schema import dc_modes, devices, mailboxes, pdo_entries, pdos, profiles, vendors
from esicatalog.catalog.views import FULL_TEXT
from esicatalog.errors import InputError

PROTOCOLS = ("coe", "eoe", "foe", "soe", "aoe", "voe")
SYNC_SIGNALS = ("sync0", "sync1")

Mapped = tuple[int, int | None]


class DeviceFilter(msgspec.Struct, frozen=True, kw_only=True):
    """What devices have to fulfil; all given conditions together.

    ``maps`` and ``not_maps`` look at all PDOs of the device and of the modules its slots can reach; ``bits`` is the
    BitLen of the mapped entries. Without ``all_variants`` only the preferred description of an identity counts.
    """

    vendor_id: int | None = None
    vendor: str | None = None
    """Part of the vendor's name."""
    product_code: int | None = None
    text: str | None = None
    profile_no: int | None = None
    sync: str | None = None
    protocol: str | None = None
    complete_access: bool = False
    maps: tuple[Mapped, ...] = ()
    not_maps: tuple[Mapped, ...] = ()
    bits: int | None = None
    objects: tuple[Mapped, ...] = ()
    all_variants: bool = False
    limit: int | None = None


Evidence = Callable[[sa.Connection, list[int]], dict[int, list[str]]]


class _Condition(msgspec.Struct, frozen=True):
    """One filter: its SQL condition on ``devices``, and what to show for the devices found."""

    sql: Any
    evidence: Evidence | None = None


def find_devices(connection: sa.Connection, wanted: DeviceFilter) -> list[FoundDevice]:
    """Devices that fulfil the filter, by vendor, product, revision and variant. Raises :class:`InputError`."""
    conditions = _conditions(wanted, connection.dialect.name)
    query = device_query(conditions, wanted)
    rows = connection.execute(query).all()
    evidence: dict[int, list[str]] = {row.id: [] for row in rows}
    for condition in conditions:
        if condition.evidence is not None:
            for part in chunks(evidence):
                for number, texts in condition.evidence(connection, part).items():
                    evidence[number].extend(texts)
    return [summary(row, evidence[row.id]) for row in rows]


def device_query(conditions: Sequence[_Condition], wanted: DeviceFilter) -> sa.Select[Any]:
    """The one SELECT of a filter."""
    columns = devices.c
    query = (
        sa.select(
            columns.id,
            columns.vendor_id,
            columns.product_code,
            columns.revision_no,
            columns.variant,
            vendors.c.name.label("vendor"),
            columns.type,
            columns.name,
        )
        .outerjoin(vendors, vendors.c.vendor_id == columns.vendor_id)
        .where(*(condition.sql for condition in conditions))
        .order_by(columns.vendor_id, columns.product_code, columns.revision_no, columns.type, columns.variant)
    )
    if not wanted.all_variants:
        query = query.where(columns.variant == 1)
    return query.limit(wanted.limit) if wanted.limit is not None else query


def _conditions(wanted: DeviceFilter, dialect: str) -> list[_Condition]:
    columns = devices.c
    found: list[_Condition] = []
    if wanted.vendor_id is not None:
        found.append(_Condition(columns.vendor_id == wanted.vendor_id))
    if wanted.vendor is not None:
        named = sa.select(schema.vendor_names.c.vendor_id).where(
            schema.vendor_names.c.name.icontains(wanted.vendor, autoescape=True)
        )
        found.append(_Condition(columns.vendor_id.in_(named)))
    if wanted.product_code is not None:
        found.append(_Condition(columns.product_code == wanted.product_code))
    if wanted.text is not None:
        found.append(_Condition(_text_condition(wanted.text, dialect)))
    if wanted.profile_no is not None:
        found.append(_profile_condition(wanted.profile_no))
    if wanted.sync is not None:
        found.append(_sync_condition(wanted.sync))
    if wanted.protocol is not None:
        found.append(_protocol_condition(wanted.protocol))
    if wanted.complete_access:
        column = mailboxes.c.coe_complete_access
        found.append(_Condition(_mailbox(column), _stated("CoE CompleteAccess declared")))
    if wanted.bits is not None and not wanted.maps:
        raise InputError("--bits is the length of the entries named by --maps; give --maps INDEX[:SUBINDEX] too")
    found.extend(_maps_condition(mapped, wanted.bits) for mapped in wanted.maps)
    found.extend(_Condition(columns.id.not_in(_mapping_devices(mapped, None))) for mapped in wanted.not_maps)
    found.extend(_object_condition(item) for item in wanted.objects)
    return found


def _stated(words: str) -> Evidence:
    """Evidence that is the same for every device found."""
    return lambda connection, ids: {number: [words] for number in ids}


def _text_condition(text: str, dialect: str) -> Any:
    if dialect == "sqlite":
        match = sa.text(f"devices.id IN (SELECT rowid FROM {FULL_TEXT} WHERE {FULL_TEXT} MATCH :words)")
        return match.bindparams(words=search_expression(text))
    texts = schema.device_names.c
    words = [
        sa.or_(
            devices.c.type.icontains(word, autoescape=True),
            vendors.c.name.icontains(word, autoescape=True),
            devices.c.id.in_(sa.select(texts.device_id).where(texts.text.icontains(word, autoescape=True))),
        )
        for word in text.split()
    ]
    return sa.and_(sa.true(), *words)


def _profile_condition(profile_no: int) -> _Condition:
    channels, links = schema.profile_channels.c, schema.device_modules.c
    fits = sa.or_(
        profiles.c.profile_no == profile_no,
        profiles.c.id.in_(sa.select(channels.profile_id).where(channels.profile_no == profile_no)),
    )
    own = sa.select(profiles.c.device_id).where(fits, profiles.c.device_id.is_not(None))
    modular = sa.select(links.device_id).join(profiles, profiles.c.module_id == links.module_id).where(fits)

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        direct = set(connection.execute(own.where(profiles.c.device_id.in_(ids))).scalars())
        return {
            number: [f"ProfileNo {profile_no}" if number in direct else f"ProfileNo {profile_no} in a module"]
            for number in ids
        }

    return _Condition(devices.c.id.in_(own.union(modular)), evidence)


def _sync_condition(signal: str) -> _Condition:
    if signal not in SYNC_SIGNALS:
        raise InputError(f"--sync {signal!r}: say {' or '.join(SYNC_SIGNALS)}")
    column = dc_modes.c[signal]
    fits = sa.select(dc_modes.c.device_id).where(column == sa.true())

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        found: dict[int, list[str]] = {}
        query = sa.select(dc_modes.c.device_id, dc_modes.c.name, dc_modes.c.assign_activate)
        query = query.where(dc_modes.c.device_id.in_(ids), column == sa.true()).order_by(
            dc_modes.c.device_id, dc_modes.c.position
        )
        for number, name, word in connection.execute(query):
            found.setdefault(number, []).append(f"{signal.upper()} in OpMode {name!r}: AssignActivate 0x{word:04X}")
        return found

    return _Condition(devices.c.id.in_(fits), evidence)


def _protocol_condition(protocol: str) -> _Condition:
    if protocol not in PROTOCOLS:
        raise InputError(f"--protocol {protocol!r}: say one of {', '.join(PROTOCOLS)}")
    names = {name: f"{name[0].upper()}o{name[2].upper()}" for name in PROTOCOLS}
    words = f"Mailbox/{names[protocol]} declared"
    return _Condition(_mailbox(mailboxes.c[protocol]), _stated(words))


def _mailbox(column: sa.Column[Any]) -> Any:
    return devices.c.id.in_(sa.select(mailboxes.c.device_id).where(column == sa.true()))


def _entry_fits(mapped: Mapped, bits: int | None) -> list[Any]:
    index, subindex = mapped
    fits: list[Any] = [pdo_entries.c.entry_index == index]
    if subindex is not None:
        fits.append(sa.func.coalesce(pdo_entries.c.subindex, 0) == subindex)
    if bits is not None:
        fits.append(pdo_entries.c.bit_length == bits)
    return fits


def _mapping_devices(mapped: Mapped, bits: int | None) -> Any:
    """Devices with a PDO, their own or of a reachable module, that maps the entry."""
    links = schema.device_modules.c
    fits = _entry_fits(mapped, bits)
    own = (
        sa.select(pdos.c.device_id)
        .join(pdo_entries, pdo_entries.c.pdo_id == pdos.c.id)
        .where(*fits, pdos.c.device_id.is_not(None))
    )
    modular = (
        sa.select(links.device_id)
        .join(pdos, pdos.c.module_id == links.module_id)
        .join(pdo_entries, pdo_entries.c.pdo_id == pdos.c.id)
        .where(*fits)
    )
    return own.union(modular)


def _maps_condition(mapped: Mapped, bits: int | None) -> _Condition:
    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        found: dict[int, list[str]] = {}
        links, modules = schema.device_modules.c, schema.modules.c
        columns = (
            pdos.c.direction,
            pdos.c.pdo_index,
            pdo_entries.c.entry_index,
            sa.func.coalesce(pdo_entries.c.subindex, 0),
            pdo_entries.c.bit_length,
            pdos.c.sm,
        )
        own = (
            sa.select(pdos.c.device_id, sa.null(), *columns)
            .join(pdo_entries, pdo_entries.c.pdo_id == pdos.c.id)
            .where(*_entry_fits(mapped, bits), pdos.c.device_id.in_(ids))
        )
        modular = (
            sa.select(links.device_id, modules.module_ident, *columns)
            .join(pdos, pdos.c.module_id == links.module_id)
            .join(schema.modules, modules.id == links.module_id)
            .join(pdo_entries, pdo_entries.c.pdo_id == pdos.c.id)
            .where(*_entry_fits(mapped, bits), links.device_id.in_(ids))
        )
        for number, module, *facts in connection.execute(own.union_all(modular)):
            found.setdefault(number, []).append(_mapping_words(module, *facts))
        return {number: sorted(set(texts)) for number, texts in found.items()}

    return _Condition(devices.c.id.in_(_mapping_devices(mapped, bits)), evidence)


def _mapping_words(
    module: int | None, direction: str, pdo: int | None, index: int, subindex: int, bits: int | None, sm: int | None
) -> str:
    place = f"{direction} 0x{pdo:04X}" if pdo is not None else direction
    assigned = f"default on SM{sm}" if sm is not None else "not assigned by default"
    plug = f" of module 0x{module:X}" if module is not None else ""
    return f"0x{index:04X}:{subindex:02X}, {bits} bit, in {place}{plug} ({assigned})"


def _object_condition(item: Mapped) -> _Condition:
    index, subindex = item
    objects, held, entries = schema.objects.c, schema.dictionary_objects.c, schema.object_entries.c
    links = schema.device_modules.c
    fitting = sa.select(objects.id).where(objects.object_index == index)
    if subindex is not None:
        fitting = fitting.where(
            objects.id.in_(
                sa.select(entries.object_id)
                .join(schema.objects, objects.id == entries.object_id)
                .where(objects.object_index == index, entries.subindex == subindex)
            )
        )
    within = sa.select(held.dictionary_id).where(held.object_id.in_(fitting))
    own = sa.select(profiles.c.device_id).where(profiles.c.dictionary_id.in_(within), profiles.c.device_id.is_not(None))
    modular = (
        sa.select(links.device_id)
        .join(profiles, profiles.c.module_id == links.module_id)
        .where(profiles.c.dictionary_id.in_(within))
    )
    words = f"0x{index:04X}" + (f":{subindex:02X}" if subindex is not None else "")

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        direct = set(connection.execute(own.where(profiles.c.device_id.in_(ids))).scalars())
        return {
            number: [f"object {words} in the dictionary" + ("" if number in direct else " of a module")]
            for number in ids
        }

    return _Condition(devices.c.id.in_(own.union(modular)), evidence)
