"""The object dictionary of a device: loaded when it is opened, because it can be larger than the rest of the page."""

import asyncio
from typing import Any

from esicatalog.api import Catalog
from esicatalog.catalog.description import DeviceDescription
from esicatalog.esi.records.common import display_text
from esicatalog.model.access import access_text
from esicatalog.model.dictionary import ObjectEntry, resolve_object, type_table
from esicatalog.parameters import check_names
from esicatalog.web.http import Page, Part
from esicatalog.web.links import asked_identity, device_path

PART = Part("Sec-Fetch-Dest", "empty")
"""Scripts ask so."""


async def objects_page(request: Any, catalog: Catalog) -> Page:
    """The objects: a part of a page for scripts, a page of its own for people."""
    check_names(request.args, ())
    description = await asyncio.to_thread(catalog.device, asked_identity(request))
    objects = await asyncio.to_thread(_objects, description)
    context = {
        "objects": objects,
        "title": description.found.type or "the device",
        "path": device_path(description.found) or "",
    }
    return Page("objects.html" if PART.is_asked(request) else "objects_page.html", context)


def _objects(description: DeviceDescription) -> list[dict[str, Any]]:
    found = []
    for profile in description.device.profiles:
        if profile.dictionary is None:
            continue
        types = type_table(profile.dictionary.data_types)
        for declared in profile.dictionary.objects:
            data_type = types.get(declared.type or "")
            found.append(
                {
                    "index": declared.object_index,
                    "name": display_text(declared.names) or "",
                    "type": declared.type or "",
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
    if isinstance(value, int) and abs(value) > 9:
        return f"{value} (0x{value:X})" if value > 0 else str(value)
    return "" if value is None else str(value)
