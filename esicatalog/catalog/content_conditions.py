"""Conditions on what descriptions contain: mapped entries, objects, profiles; of the device or of its modules."""

from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.conditions import Condition
from esicatalog.catalog.device_filter import Mapped
from esicatalog.catalog.schema import devices, pdo_entries, pdos, profiles

_LINKS = schema.device_modules.c


def profile(profile_no: int) -> Condition:
    """Devices with this profile number, their own, of a channel, or of a reachable module."""
    channels = schema.profile_channels.c
    fits = sa.or_(
        profiles.c.profile_no == profile_no,
        profiles.c.id.in_(sa.select(channels.profile_id).where(channels.profile_no == profile_no)),
    )
    return _own_or_modular(fits, f"ProfileNo {profile_no}", f"ProfileNo {profile_no} in a module")


def has_object(item: Mapped) -> Condition:
    """Devices with an object in their dictionary or in that of a reachable module."""
    index, subindex = item
    objects, held, entries = schema.objects.c, schema.dictionary_objects.c, schema.object_entries.c
    fitting = sa.select(objects.id).where(objects.object_index == index)
    if subindex is not None:
        fitting = (
            sa.select(entries.object_id)
            .join(schema.objects, objects.id == entries.object_id)
            .where(objects.object_index == index, entries.subindex == subindex)
        )
    within = sa.select(held.dictionary_id).where(held.object_id.in_(fitting))
    words = f"object 0x{index:04X}" + (f":{subindex:02X}" if subindex is not None else "") + " in the dictionary"
    return _own_or_modular(profiles.c.dictionary_id.in_(within), words, f"{words} of a module")


def _own_or_modular(fits: Any, own_words: str, module_words: str) -> Condition:
    """Devices with a profile of which ``fits`` holds."""
    own = sa.select(profiles.c.device_id).where(fits, profiles.c.device_id.is_not(None))
    modular = sa.select(_LINKS.device_id).join(profiles, profiles.c.module_id == _LINKS.module_id).where(fits)

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        direct = set(connection.execute(own.where(profiles.c.device_id.in_(ids))).scalars())
        return {number: [own_words if number in direct else module_words] for number in ids}

    return Condition(devices.c.id.in_(own.union(modular)), evidence)


def maps(mapped: Mapped, bits: int | None) -> Condition:
    """Devices with a PDO, their own or of a reachable module, that maps an entry (of this length)."""

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        found: dict[int, list[str]] = {}
        modules = schema.modules.c
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
            sa.select(_LINKS.device_id, modules.module_ident, *columns)
            .join(pdos, pdos.c.module_id == _LINKS.module_id)
            .join(schema.modules, modules.id == _LINKS.module_id)
            .join(pdo_entries, pdo_entries.c.pdo_id == pdos.c.id)
            .where(*_entry_fits(mapped, bits), _LINKS.device_id.in_(ids))
        )
        for number, module, *facts in connection.execute(own.union_all(modular)):
            found.setdefault(number, []).append(_mapping_words(module, *facts))
        return {number: sorted(set(texts)) for number, texts in found.items()}

    return Condition(devices.c.id.in_(_mapping_devices(mapped, bits)), evidence)


def not_maps(mapped: Mapped) -> Condition:
    """Devices of which no PDO maps an entry, not even one of a reachable module."""
    return Condition(devices.c.id.not_in(_mapping_devices(mapped, None)))


def _entry_fits(mapped: Mapped, bits: int | None) -> list[Any]:
    index, subindex = mapped
    fits: list[Any] = [pdo_entries.c.entry_index == index]
    if subindex is not None:
        fits.append(sa.func.coalesce(pdo_entries.c.subindex, 0) == subindex)
    if bits is not None:
        fits.append(pdo_entries.c.bit_length == bits)
    return fits


def _mapping_devices(mapped: Mapped, bits: int | None) -> Any:
    fits = _entry_fits(mapped, bits)
    own = (
        sa.select(pdos.c.device_id)
        .join(pdo_entries, pdo_entries.c.pdo_id == pdos.c.id)
        .where(*fits, pdos.c.device_id.is_not(None))
    )
    modular = (
        sa.select(_LINKS.device_id)
        .join(pdos, pdos.c.module_id == _LINKS.module_id)
        .join(pdo_entries, pdo_entries.c.pdo_id == pdos.c.id)
        .where(*fits)
    )
    return own.union(modular)


def _mapping_words(
    module: int | None, direction: str, pdo: int | None, index: int, subindex: int, bits: int | None, sm: int | None
) -> str:
    place = f"{direction} 0x{pdo:04X}" if pdo is not None else direction
    assigned = f"default on SM{sm}" if sm is not None else "not assigned by default"
    plug = f" of module 0x{module:X}" if module is not None else ""
    return f"0x{index:04X}:{subindex:02X}, {bits} bit, in {place}{plug} ({assigned})"
