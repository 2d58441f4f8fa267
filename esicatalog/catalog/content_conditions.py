"""Conditions on what descriptions contain: mapped entries, objects, profiles; of the device or of its modules."""

from collections.abc import Sequence
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.conditions import Condition, among, tested
from esicatalog.catalog.device_filter import AskedObject
from esicatalog.catalog.schema import devices, pdo_entries, pdos, profiles
from esicatalog.catalog.slot_moves import (
    SLOTS,
    Increments,
    lies_at,
    lies_in_a_slot,
    moves,
    pdo_index_in_slot,
    slot_number,
    unmoved_indices,
)
from esicatalog.catalog.views import mapped_subindex
from esicatalog.model.pdo_facts import subindex_words

_LINKS = schema.device_modules.c
_OF_PDO = pdo_entries.c.pdo_id == tested(pdos.c.id)
"""From the devices to their PDOs to the entries: a planner that takes entries for few would begin with all."""
_SM_WITH_MODULE = sa.case((pdos.c.virtual == sa.true(), None), else_=pdos.c.sm)
"""SyncManager that a PDO of a module goes to with it, as :func:`esicatalog.model.process_image.module_sms` tells it."""

_NONE = sa.cast(sa.null(), sa.BigInteger)
"""No module, or no one slot: a number of which PostgreSQL has to know that it is one."""
_WITHOUT_ENTRIES = sa.and_(
    pdos.c.entry_count == 0, sa.or_(pdos.c.fixed.is_distinct_from(sa.true()), pdos.c.ref.is_not(None))
)
"""What a PDO maps is not described, as :func:`esicatalog.model.pdo_facts.is_described` tells it."""

_SUBINDEX: sa.ColumnElement[int] = sa.literal_column(mapped_subindex(pdo_entries.name), sa.BigInteger)


def profile(profile_no: int) -> Condition:
    """Devices with this profile number, their own, of a channel, or of a reachable module."""
    channels = schema.profile_channels.c
    fits = sa.or_(
        profiles.c.profile_no == profile_no,
        profiles.c.id.in_(sa.select(channels.profile_id).where(channels.profile_no == profile_no)),
    )
    found = _owning_devices(profiles).where(fits)
    return _own_or_modular(found, fits, fits, f"ProfileNo {profile_no}", f"ProfileNo {profile_no} in a module")


def declares_object(item: AskedObject, slots: Sequence[Increments]) -> Condition:
    """Devices with an object in their dictionary or in that of a reachable module, as it lies in the slots.

    ``slots`` says how far slots of the catalog move objects, here as below.
    """
    index, subindex = item
    objects, held = schema.objects, schema.dictionary_objects.c
    has_subindex = _has_subindex(objects.c.id, subindex)
    is_there = _lies(objects, objects.c.object_index, index, profiles.c.module_id)
    holding = profiles.join(schema.dictionary_objects, held.dictionary_id == profiles.c.dictionary_id)
    found = _owning_devices(profiles, holding.join(objects, objects.c.id == held.object_id))
    found = found.where(objects.c.object_index.in_(unmoved_indices(index, slots)), is_there, has_subindex)

    def holds(fits: Any) -> sa.ColumnElement[bool]:
        declared = sa.select(held.object_id).join(objects, objects.c.id == held.object_id)
        return declared.where(held.dictionary_id == profiles.c.dictionary_id, fits, has_subindex).exists()

    words = f"object 0x{index:04X}" + (f":{subindex:02X}" if subindex is not None else "") + " in the dictionary"
    own = holds(tested(objects.c.object_index) == index)
    return _own_or_modular(found, own, holds(is_there), words, f"{words} of a module in its slot")


def _has_subindex(object_id: sa.ColumnElement[int], subindex: int | None) -> sa.ColumnElement[bool]:
    """Whether an object has a subindex; asked of each object once, however many dictionaries hold it."""
    if subindex is None:
        return sa.true()
    entries = schema.object_entries.c
    return sa.select(entries.subindex).where(entries.object_id == object_id, entries.subindex == subindex).exists()


def _lies(item: sa.Table, item_index: sa.ColumnElement[int], index: int, module_id: Any) -> sa.ColumnElement[bool]:
    """Whether an object, a device's own or that of a module that is linked with a device, lies at an index there."""
    moved = lies_in_a_slot(item, item_index, index, _LINKS.device_id, _LINKS.module_id)
    return sa.case((sa.and_(module_id.is_not(None), moves(item)), moved), else_=tested(item_index) == index)


def _owning_devices(table: sa.Table, joined: sa.FromClause | None = None) -> sa.Select[Any]:
    """Devices that rows of a table belong to, directly or by a module that their slots can reach.

    One pass over the rows serves both; a module that no device reaches has none.
    """
    device_id = sa.func.coalesce(table.c.device_id, _LINKS.device_id)
    links = (table if joined is None else joined).outerjoin(
        schema.device_modules, _LINKS.module_id == table.c.module_id
    )
    return sa.select(device_id).select_from(links).where(device_id.is_not(None))


def _owns(table: sa.Table, own_fits: Any, modular_fits: Any) -> sa.ColumnElement[bool]:
    """Whether a device has a row of a table that fits, its own or a module's that its slots can reach."""
    own = sa.select(table.c.id).where(table.c.device_id == devices.c.id, own_fits)
    modular = (
        sa.select(table.c.id)
        .join(schema.device_modules, _LINKS.module_id == table.c.module_id)
        .where(_LINKS.device_id == devices.c.id, modular_fits)
    )
    return sa.or_(own.exists(), modular.exists())


def _own_or_modular(
    found: sa.Select[Any], holds: Any, module_holds: Any, own_words: str, module_words: str
) -> Condition:
    """Devices that are found by one of their profiles or of their modules'; ``holds`` tells the same of a profile."""

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        direct = sa.select(profiles.c.device_id).where(profiles.c.device_id.in_(ids), holds)
        numbers = set(connection.execute(direct).scalars())
        return {number: [own_words if number in numbers else module_words] for number in ids}

    return Condition(among(found), evidence, _owns(profiles, holds, module_holds))


def maps(mapped: AskedObject, bits: int | None, slots: Sequence[Increments]) -> Condition:
    """Devices with a PDO, their own or of a reachable module in its slot, that maps an entry (of this length).

    What is assigned without a choice is told first, then what comes with a module.
    """
    index, _ = mapped

    def evidence(connection: sa.Connection, ids: list[int]) -> dict[int, list[str]]:
        found: dict[int, set[tuple[int, str]]] = {}
        ident = schema.modules.c.module_ident
        entry = (_SUBINDEX, pdo_entries.c.bit_length)
        entry_index = tested(pdo_entries.c.entry_index)
        fits = _entry_fits(mapped, bits)
        number = slot_number(pdo_entries, entry_index, index)
        own = (
            sa.select(pdos.c.device_id, _NONE, _NONE, pdos.c.direction, pdos.c.pdo_index, *entry, pdos.c.image_sm)
            .join(pdo_entries, _OF_PDO)
            .where(entry_index == index, *fits, pdos.c.device_id.in_(ids))
        )
        of_modules = (
            schema.device_modules.join(pdos, pdos.c.module_id == _LINKS.module_id)
            .join(schema.modules, schema.modules.c.id == _LINKS.module_id)
            .join(pdo_entries, _OF_PDO)
        )
        in_any_slot = (
            sa.select(_LINKS.device_id, ident, _NONE, pdos.c.direction, pdos.c.pdo_index, *entry, _SM_WITH_MODULE)
            .select_from(of_modules)
            .where(sa.not_(moves(pdo_entries)), entry_index == index, *fits, _LINKS.device_id.in_(ids))
        )
        moved_index = pdo_index_in_slot(pdos, number)
        in_one_slot = (
            sa.select(_LINKS.device_id, ident, number, pdos.c.direction, moved_index, *entry, _SM_WITH_MODULE)
            .select_from(of_modules.join(SLOTS, schema.slots.c.device_id == _LINKS.device_id))
            .where(
                moves(pdo_entries),
                lies_at(pdo_entries, entry_index, index, _LINKS.device_id, _LINKS.module_id),
                *fits,
                _LINKS.device_id.in_(ids),
            )
        )
        for device_id, *facts in connection.execute(own.union_all(in_any_slot, in_one_slot)):
            found.setdefault(device_id, set()).add(_mapping_words(index, *facts))
        return {number: [words for _, words in sorted(texts)] for number, texts in found.items()}

    return Condition(among(_mapping_devices(slots, mapped, bits)), evidence, _maps(mapped, bits))


def not_maps(mapped: AskedObject, slots: Sequence[Increments]) -> Condition:
    """Devices of which no PDO maps an entry, not even one of a reachable module in its slot.

    What is not described may map it: nobody can say that it does not. So it is with a SubIndex that cannot be read, a
    PDO without entries that is not Fixed, and a device that has its PDOs uploaded and describes none.
    """
    index, subindex = mapped
    unread = () if subindex is None else (_SUBINDEX.is_(None),)
    found = [_mapping_devices(slots, mapped, None)]
    found += [_mapping_devices(slots, (index, None), None, item) for item in unread]
    of_one = [_maps(mapped, None), *(_maps((index, None), None, item) for item in unread)]
    undescribed = sa.or_(_owns(pdos, _WITHOUT_ENTRIES, _WITHOUT_ENTRIES), _only_uploaded())
    return Condition(
        sa.and_(*(sa.not_(among(item)) for item in found), sa.not_(undescribed)),
        of_one=sa.not_(sa.or_(*of_one, undescribed)),
    )


def _only_uploaded() -> sa.ColumnElement[bool]:
    """Whether a device has its PDOs uploaded (CoE/@PdoUpload) and describes none, nor a module."""
    mailboxes = schema.mailboxes.c
    uploads = sa.select(mailboxes.id).where(mailboxes.device_id == devices.c.id, mailboxes.coe_pdo_upload == sa.true())
    described = (
        sa.select(pdos.c.id).where(pdos.c.device_id == devices.c.id),
        sa.select(_LINKS.module_id).where(_LINKS.device_id == devices.c.id),
    )
    is_uploaded, *are_described = (item.correlate(devices).exists() for item in (uploads, *described))
    return sa.and_(is_uploaded, *map(sa.not_, are_described))


def _entry_fits(mapped: AskedObject, bits: int | None) -> list[Any]:
    """What is asked of an entry but its index."""
    _, subindex = mapped
    fits: list[Any] = []
    if subindex is not None:
        fits.append(subindex == _SUBINDEX)
    if bits is not None:
        fits.append(pdo_entries.c.bit_length == bits)
    return fits


def _mapping_devices(
    slots: Sequence[Increments], mapped: AskedObject, bits: int | None, *further: sa.ColumnElement[bool]
) -> sa.Select[Any]:
    """The entries are found first, then whose they are: few indices have many entries."""
    index, _ = mapped
    entry_index = pdo_entries.c.entry_index
    found = _owning_devices(pdos, pdo_entries.join(pdos, pdos.c.id == tested(pdo_entries.c.pdo_id)))
    return found.where(
        entry_index.in_(unmoved_indices(index, slots)),
        *_entry_fits(mapped, bits),
        *further,
        _lies(pdo_entries, entry_index, index, pdos.c.module_id),
    )


def _maps(mapped: AskedObject, bits: int | None, *further: sa.ColumnElement[bool]) -> sa.ColumnElement[bool]:
    index, _ = mapped
    entry_index = pdo_entries.c.entry_index

    def fits(is_there: sa.ColumnElement[bool]) -> sa.ColumnElement[bool]:
        entries = sa.select(pdo_entries.c.id)
        return entries.where(_OF_PDO, is_there, *_entry_fits(mapped, bits), *further).exists()

    return _owns(
        pdos, fits(tested(entry_index) == index), fits(_lies(pdo_entries, entry_index, index, pdos.c.module_id))
    )


_ASSIGNED, _WITH_MODULE, _NOT_ASSIGNED = range(3)
"""What is told first of what maps an object."""


def _mapping_words(
    index: int,
    module: int | None,
    slot: int | None,
    direction: str,
    pdo: int | None,
    subindex: int | None,
    bits: int | None,
    sm: int | None,
) -> tuple[int, str]:
    place = f"{direction} 0x{pdo:04X}" if pdo is not None else direction
    if module is not None:
        place += f" of module 0x{module:X}" + (f" in slot {slot}" if slot is not None else "")
    if sm is None:
        rank, assigned = _NOT_ASSIGNED, "not assigned by default"
    elif module is None:
        rank, assigned = _ASSIGNED, f"default on SM{sm}"
    else:
        rank, assigned = _WITH_MODULE, f"on SM{sm} when plugged"
    length = f"{bits} bit" if bits is not None else "no BitLen"
    return rank, f"0x{index:04X}:{subindex_words(subindex)}, {length}, in {place} ({assigned})"
