"""Conditions on what descriptions contain: mapped entries, objects, profiles; of the device or of its modules."""

from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.conditions import Condition, among, tested
from esicatalog.catalog.device_filter import Mapped
from esicatalog.catalog.schema import devices, pdo_entries, pdos, profiles
from esicatalog.catalog.views import mapped_subindex
from esicatalog.model.pdo_facts import subindex_words

_LINKS = schema.device_modules.c
_OF_PDO = pdo_entries.c.pdo_id == tested(pdos.c.id)
"""From the devices to their PDOs to the entries: a planner that takes entries for few would begin with all."""
_SM_WITH_MODULE = sa.case((pdos.c.virtual == sa.true(), None), else_=pdos.c.sm)
"""SyncManager that a PDO of a module goes to with it, as :func:`esicatalog.model.process_image.module_sms` tells it."""

_SUBINDEX: sa.ColumnElement[int] = sa.literal_column(mapped_subindex(pdo_entries.name), sa.BigInteger)


def profile(profile_no: int) -> Condition:
    """Devices with this profile number, their own, of a channel, or of a reachable module."""
    channels = schema.profile_channels.c
    fits = sa.or_(
        profiles.c.profile_no == profile_no,
        profiles.c.id.in_(sa.select(channels.profile_id).where(channels.profile_no == profile_no)),
    )
    found = _owning_devices(profiles).where(fits)
    return _own_or_modular(found, fits, f"ProfileNo {profile_no}", f"ProfileNo {profile_no} in a module")


def has_object(item: Mapped) -> Condition:
    """Devices with an object in their dictionary or in that of a reachable module."""
    index, subindex = item
    objects, held = schema.objects.c, schema.dictionary_objects.c
    holding = profiles.join(schema.dictionary_objects, held.dictionary_id == profiles.c.dictionary_id)
    found = _owning_devices(profiles, holding.join(schema.objects, objects.id == held.object_id))
    found = found.where(objects.object_index == index, _has_subindex(objects.id, subindex))
    holds = (
        sa.select(held.object_id)
        .join(schema.objects, objects.id == held.object_id)
        .where(
            held.dictionary_id == profiles.c.dictionary_id,
            tested(objects.object_index) == index,
            _has_subindex(objects.id, subindex),
        )
        .exists()
    )
    words = f"object 0x{index:04X}" + (f":{subindex:02X}" if subindex is not None else "") + " in the dictionary"
    return _own_or_modular(found, holds, words, f"{words} of a module")


def _has_subindex(object_id: sa.ColumnElement[int], subindex: int | None) -> sa.ColumnElement[bool]:
    """Whether an object has a subindex; asked of each object once, however many dictionaries hold it."""
    if subindex is None:
        return sa.true()
    entries = schema.object_entries.c
    return sa.select(entries.subindex).where(entries.object_id == object_id, entries.subindex == subindex).exists()


def _owning_devices(table: sa.Table, joined: sa.FromClause | None = None) -> sa.Select[Any]:
    """Devices that rows of a table belong to, directly or by a module that their slots can reach.

    One pass over the rows serves both; a module that no device reaches has none.
    """
    device_id = sa.func.coalesce(table.c.device_id, _LINKS.device_id)
    links = (table if joined is None else joined).outerjoin(
        schema.device_modules, _LINKS.module_id == table.c.module_id
    )
    return sa.select(device_id).select_from(links).where(device_id.is_not(None))


def _owns(table: sa.Table, fits: Any) -> sa.ColumnElement[bool]:
    """Whether a device has a row of a table that fits, its own or a module's that its slots can reach."""
    own = sa.select(table.c.id).where(table.c.device_id == devices.c.id, fits)
    modular = (
        sa.select(table.c.id)
        .join(schema.device_modules, _LINKS.module_id == table.c.module_id)
        .where(_LINKS.device_id == devices.c.id, fits)
    )
    return sa.or_(own.exists(), modular.exists())


def _own_or_modular(found: sa.Select[Any], holds: Any, own_words: str, module_words: str) -> Condition:
    """Devices that are found by one of their profiles or of their modules'; ``holds`` tells the same of a profile."""

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        direct = sa.select(profiles.c.device_id).where(profiles.c.device_id.in_(ids), holds)
        numbers = set(connection.execute(direct).scalars())
        return {number: [own_words if number in numbers else module_words] for number in ids}

    return Condition(among(found), evidence, _owns(profiles, holds))


def maps(mapped: Mapped, bits: int | None) -> Condition:
    """Devices with a PDO, their own or of a reachable module, that maps an entry (of this length).

    What is assigned by default is told first.
    """

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        found: dict[int, set[tuple[bool, str]]] = {}
        modules = schema.modules.c
        columns = (
            pdos.c.direction,
            pdos.c.pdo_index,
            pdo_entries.c.entry_index,
            _SUBINDEX,
            pdo_entries.c.bit_length,
        )
        fits = _entry_fits(tested(pdo_entries.c.entry_index), mapped, bits)
        own = (
            sa.select(pdos.c.device_id, sa.null(), *columns, pdos.c.image_sm)
            .join(pdo_entries, _OF_PDO)
            .where(*fits, pdos.c.device_id.in_(ids))
        )
        modular = (
            sa.select(_LINKS.device_id, modules.module_ident, *columns, _SM_WITH_MODULE)
            .join(pdos, pdos.c.module_id == _LINKS.module_id)
            .join(schema.modules, modules.id == _LINKS.module_id)
            .join(pdo_entries, _OF_PDO)
            .where(*fits, _LINKS.device_id.in_(ids))
        )
        for number, *facts in connection.execute(own.union_all(modular)):
            found.setdefault(number, set()).add((facts[-1] is None, _mapping_words(*facts)))
        return {number: [words for _, words in sorted(texts)] for number, texts in found.items()}

    return Condition(among(_mapping_devices(mapped, bits)), evidence, _maps(mapped, bits))


def not_maps(mapped: Mapped) -> Condition:
    """Devices of which no PDO maps an entry, not even one of a reachable module.

    One whose SubIndex cannot be read may map it: nobody can say that it does not.
    """
    index, subindex = mapped
    unread = () if subindex is None else (_SUBINDEX.is_(None),)
    found = [_mapping_devices(mapped, None), *(_mapping_devices((index, None), None, item) for item in unread)]
    of_one = [_maps(mapped, None), *(_maps((index, None), None, item) for item in unread)]
    return Condition(sa.and_(*(sa.not_(among(item)) for item in found)), of_one=sa.not_(sa.or_(*of_one)))


def _entry_fits(entry_index: sa.ColumnElement[int], mapped: Mapped, bits: int | None) -> list[Any]:
    index, subindex = mapped
    fits: list[Any] = [entry_index == index]
    if subindex is not None:
        fits.append(subindex == _SUBINDEX)
    if bits is not None:
        fits.append(pdo_entries.c.bit_length == bits)
    return fits


def _mapping_devices(mapped: Mapped, bits: int | None, *further: sa.ColumnElement[bool]) -> sa.Select[Any]:
    fits = _entry_fits(pdo_entries.c.entry_index, mapped, bits)
    return _owning_devices(pdos).where(pdos.c.id.in_(sa.select(pdo_entries.c.pdo_id).where(*fits, *further)))


def _maps(mapped: Mapped, bits: int | None, *further: sa.ColumnElement[bool]) -> sa.ColumnElement[bool]:
    fits = _entry_fits(tested(pdo_entries.c.entry_index), mapped, bits)
    return _owns(pdos, sa.select(pdo_entries.c.id).where(_OF_PDO, *fits, *further).exists())


def _mapping_words(
    module: int | None,
    direction: str,
    pdo: int | None,
    index: int,
    subindex: int | None,
    bits: int | None,
    sm: int | None,
) -> str:
    place = f"{direction} 0x{pdo:04X}" if pdo is not None else direction
    assigned = f"default on SM{sm}" if sm is not None else "not assigned by default"
    plug = f" of module 0x{module:X}" if module is not None else ""
    length = f"{bits} bit" if bits is not None else "no BitLen"
    return f"0x{index:04X}:{subindex_words(subindex)}, {length}, in {place}{plug} ({assigned})"
