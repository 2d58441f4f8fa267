"""The object dictionary of a device: loaded when it is opened, because it can be larger than the rest of the page."""

import asyncio
from collections.abc import Mapping
from typing import Any

from esicatalog.api import Catalog
from esicatalog.catalog.description import DeviceDescription
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.profile import dictionaries_of
from esicatalog.identity import ModuleChoice
from esicatalog.model.access import access_text
from esicatalog.model.dictionary import ObjectEntry, resolve_object, type_table
from esicatalog.model.module_choice import module_choices
from esicatalog.model.slots import expand_module
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
    own = _count(description.device)
    plugged = description.plugged(choice)
    of_modules = sum(_count(item.module) for item in plugged)
    there = {id(item.module) for item in plugged}
    more = sum(1 for module in description.modules if id(module) not in there and _count(module))
    return {"count": own + of_modules, "of_modules": of_modules, "modules_more": more}


def _context(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, Any]:
    labels = dict(zip(map(id, description.modules), module_choices(description.modules), strict=True))
    objects, problems = _objects(description.device, ""), []
    for item in description.plugged(choice):
        words = f"module {labels[id(item.module)] or item.module.type or 'without ident'} in slot {item.slot_number}"
        in_slot = expand_module(description.device, item)
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


def _count(owner: Device | Module) -> int:
    return sum(len(dictionary.objects) for dictionary in dictionaries_of(owner.profiles))


def _objects(owner: Device | Module, place: str) -> list[dict[str, Any]]:
    found = []
    for dictionary in dictionaries_of(owner.profiles):
        types = type_table(dictionary.data_types)
        for declared in dictionary.objects:
            data_type = types.get(declared.type or "")
            found.append(
                {
                    "index": index_words(declared.object_index),
                    "name": display_text(declared.names) or "",
                    "type": declared.type or "",
                    "place": place,
                    "enums": [
                        (item.value, display_text(item.texts) or "")
                        for item in (data_type.enum_infos if data_type is not None else ())
                    ],
                    "entries": [_entry(entry) for entry in resolve_object(declared, types).entries],
                }
            )
    return found


def _entry(entry: ObjectEntry) -> dict[str, Any]:
    return {
        "subindex": entry.subindex,
        "name": entry.name,
        "data_type": entry.data_type,
        "bit_size": entry.bit_size,
        "access_by_state": access_text(entry.access_word),
        "pdo_mapping": entry.pdo_mapping,
        "shown_default": _value(entry.default_int, entry.default_real, entry.default_text, entry.default_raw),
        "shown_min": _value(entry.min_int, entry.min_real),
        "shown_max": _value(entry.max_int, entry.max_real),
    }


def _value(*values: Any) -> str:
    value = next((item for item in values if item is not None), None)
    if isinstance(value, int):
        return number_words(value)
    return "" if value is None else str(value)
