"""The object dictionary of a device: loaded when it is opened, because it can be larger than the rest of the page."""

import asyncio
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

from esicatalog.api import Catalog
from esicatalog.catalog.description import DeviceDescription
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import DataType, Object
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.profile import declared_objects, dictionaries_of
from esicatalog.identity import ModuleChoice
from esicatalog.model.access import access_text
from esicatalog.model.dictionary import ObjectEntry, enum_values, resolve_object, type_table
from esicatalog.model.dictionary_views import object_yields
from esicatalog.model.module_choice import module_choices
from esicatalog.model.slots import ExpandedModule, PluggedModule, expand_module
from esicatalog.model.values import number_words
from esicatalog.web.exports import asked_modules, modules_query
from esicatalog.web.http import Page, Part
from esicatalog.web.links import asked_identity, device_path
from esicatalog.words import index_words

PART = Part("X-Esicatalog-Part", "objects")
"""What pages.js asks with. Browsers say of themselves what asks (Sec-Fetch-Dest), but not to plain HTTP by name."""


async def objects_page(request: Any, catalog: Catalog) -> Page:
    """``/-/esi/device/V/P/R/objects?module=SLOT=IDENT[/TYPE]``: the objects of a device and of the plugged modules.

    A part of a page for scripts, a page of its own for people.
    """
    choice = asked_modules(request)
    description = await asyncio.to_thread(catalog.device, asked_identity(request))
    context = await asyncio.to_thread(_context, description, choice)
    return Page("objects.html" if PART.is_asked(request) else "objects_page.html", context)


def object_counts(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, int]:
    """How many objects there are, how many of them are of plugged modules, how many modules more would bring some.

    Raises :class:`~esicatalog.errors.InputError` for a choice that does not fit.
    """
    device, plugged = description.device, description.plugged(choice)
    brought = _brought(_in_slots(device, plugged)) if _has_marked(device) else ()
    own = _count(device, brought)
    of_modules = sum(_count(item.module) for item in plugged)
    there = {id(item.module) for item in plugged}
    more = sum(1 for module in description.modules if id(module) not in there and _count(module))
    return {"count": own + of_modules, "of_modules": of_modules, "modules_more": more}


def _context(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, Any]:
    labels = dict(zip(map(id, description.modules), module_choices(description.modules), strict=True))
    device, plugged = description.device, description.plugged(choice)
    in_slots = _in_slots(device, plugged)
    objects, problems = _objects(device, "", _brought(in_slots)), []
    for item, in_slot in zip(plugged, in_slots, strict=True):
        words = f"module {labels[id(item.module)] or item.module.type or 'without ident'} in slot {item.slot_number}"
        objects += _objects(in_slot.module, words)
        problems += [f"{words}: {problem}" for problem in in_slot.problems if _count(item.module)]
    return {
        "objects": objects,
        "problems": problems,
        "counts": object_counts(description, choice),
        "title": description.found.type or "the device",
        "path": device_path(description.found) or "",
        "chosen": modules_query(choice),
    }


def _in_slots(device: Device, plugged: Iterable[PluggedModule]) -> list[ExpandedModule]:
    return [expand_module(device, item) for item in plugged]


def _has_marked(device: Device) -> bool:
    """Whether objects of the device may yield: without any, modules need not be looked at in their slots."""
    return any(declared.overwritten_by_module for declared in declared_objects(device.profiles))


def _brought(in_slots: Iterable[ExpandedModule]) -> set[int | None]:
    """Indices of the objects that plugged modules bring."""
    return {declared.object_index for item in in_slots for declared in declared_objects(item.module.profiles)}


def _count(owner: Device | Module, brought: Collection[int | None] = ()) -> int:
    return sum(not object_yields(declared, brought) for declared in declared_objects(owner.profiles))


def _objects(owner: Device | Module, place: str, brought: Collection[int | None] = ()) -> list[dict[str, Any]]:
    found = []
    for dictionary in dictionaries_of(owner.profiles):
        types = type_table(dictionary.data_types)
        shown = (declared for declared in dictionary.objects if not object_yields(declared, brought))
        found += [_object(declared, types, place) for declared in shown]
    return found


def _object(declared: Object, types: Mapping[str, DataType], place: str) -> dict[str, Any]:
    """An object with its entries; the values that their types list stand once for all entries of a type."""
    entries = resolve_object(declared, types).entries
    names = dict.fromkeys([declared.type, *(entry.data_type for entry in entries)])
    listed = {name: values for name in names if (values := _listed_values(name, types))}
    return {
        "index": index_words(declared.object_index),
        "name": display_text(declared.names) or "",
        "type": declared.type or "",
        "place": place,
        "enums": listed,
        "entries": [_entry(entry, listed.get(entry.data_type, ())) for entry in entries],
    }


def _listed_values(name: str | None, types: Mapping[str, DataType]) -> Sequence[tuple[int | None, str]]:
    return [(item.value, display_text(item.texts) or "") for item in enum_values(name, types)]


def _entry(entry: ObjectEntry, listed: Iterable[tuple[int | None, str]]) -> dict[str, Any]:
    default = entry.default_int
    return {
        "subindex": entry.subindex,
        "name": entry.name,
        "data_type": entry.data_type,
        "bit_size": entry.bit_size,
        "access_by_state": access_text(entry.access_word),
        "pdo_mapping": entry.pdo_mapping,
        "shown_default": _value(default, entry.default_real, entry.default_text, entry.default_raw),
        "default_meaning": next((text for value, text in listed if default is not None and value == default), ""),
        "shown_min": _value(entry.min_int, entry.min_real),
        "shown_max": _value(entry.max_int, entry.max_real),
    }


def _value(*values: Any) -> str:
    value = next((item for item in values if item is not None), None)
    if isinstance(value, int):
        return number_words(value)
    return "" if value is None else str(value)
