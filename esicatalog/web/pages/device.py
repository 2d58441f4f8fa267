"""The device page: what a description declares and implies, in sections."""

import asyncio
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

from esicatalog.api import Catalog
from esicatalog.catalog.description import DeviceDescription, description_json
from esicatalog.catalog.mapping import image_key
from esicatalog.errors import EsiCatalogError, InputError, NotFound
from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import InitCmd, init_cmds
from esicatalog.esi.records.module import Module
from esicatalog.export.choice import Choice
from esicatalog.export.configuration import configure
from esicatalog.export.eeprom import eeprom_image
from esicatalog.export.sii_remarks import eeprom_remarks
from esicatalog.export.sii_summary import WHY_MERGE
from esicatalog.export.subject import Subject, subject_of_description
from esicatalog.identity import Identity, ModuleChoice
from esicatalog.model.derivation import derive
from esicatalog.model.device_words import (
    WITHOUT_SLOT,
    axes_alone,
    eeprom_words,
    head_facts,
    init_cmd_target,
    predefined_words,
)
from esicatalog.model.module_choice import module_labels, module_name, slot_offers
from esicatalog.model.module_idents import module_idents_words
from esicatalog.model.pdo_facts import (
    bits_words,
    declared_sm_words,
    entry_words,
    pdo_flags,
    pdos_by_direction,
    symmetric_exclusions,
)
from esicatalog.model.process_image import SmImage, assigned_sms, byte_bit, module_sms
from esicatalog.model.revisions import revision_text
from esicatalog.model.sm_facts import sm_facts, sm_flags
from esicatalog.model.sync import generated_signals
from esicatalog.model.twincat import is_superseded, predefined_assignments
from esicatalog.model.values import number_words
from esicatalog.web.drawings import DRAWING_CSS, dc_timing_svg, memory_map_svg, process_image_legend, process_image_svg
from esicatalog.web.exports import TARGETS, asked_modules, modules_query, parameters_of
from esicatalog.web.http import Page, status_of
from esicatalog.web.links import BASE, asked_identity, device_path
from esicatalog.web.pages.nearest import nearest, nearest_json
from esicatalog.web.pages.objects import object_counts
from esicatalog.words import hex32, index_words

_LONGEST_NUMBER = 8
_MOST_SLOTS = 24
"""How many slots are offered; a station has hundreds, and each of them takes hundreds of modules."""
_MOST_ALIKE = 12
_FORM_FIELDS = {"op-mode": "OpMode", "cycle-ns": "cycle"}
"""Parameters of exports that the page has fields for, and what they choose."""


async def device_page(request: Any, catalog: Catalog) -> Page:
    """``/-/esi/device/V/P/R?module=SLOT=IDENT[/TYPE]``: the page of one description.

    Modules that do not fit are told, on the page without any chosen ones. 404 with the nearest descriptions for an
    identity that is not described.
    """
    identity, choice = _asked(request)
    try:
        description = await asyncio.to_thread(catalog.device, identity)
    except NotFound as error:
        missing = await asyncio.to_thread(nearest, catalog, identity, error, lambda item: f"{BASE}{device_path(item)}")
        return Page("not_described.html", {"missing": missing}, status_of(error))
    try:
        return Page("device.html", await asyncio.to_thread(_context, description, choice))
    except InputError as error:
        context = await asyncio.to_thread(_context, description, {})
        return Page("device.html", context | {"problem": str(error)}, status_of(error))


async def device_json(request: Any, catalog: Catalog) -> tuple[Any, int]:
    """``/-/esi/device/V/P/R.json``: the JSON of ``esicatalog show --format json``.

    404 for an identity that is not described: with the answer of ``identify.json``, which names the nearest one. Where
    the product is described, yet not in this variant or not without revision, that route knows neither: the answer is
    an error with the descriptions that there are.
    """
    identity, choice = _asked(request)
    try:
        description = await asyncio.to_thread(catalog.device, identity)
    except NotFound as error:
        return await asyncio.to_thread(nearest_json, catalog, identity, error), status_of(error)
    return await asyncio.to_thread(description_json, description, choice), 200


def _asked(request: Any) -> tuple[Identity, Mapping[int, ModuleChoice]]:
    choice = asked_modules(request)
    return asked_identity(request), choice


def _beside_exports(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, Any]:
    """What is told of exports that have no place for it themselves; they are made only of a device with all codes."""
    found = description.found
    if None in (found.vendor_id, found.product_code, found.revision_no):
        return {"eeprom_remarks": (), "left_out": (), "cstruct_remarks": ()}
    subject = subject_of_description(description.identified, description.device, description.modules)
    return {
        "eeprom_remarks": (WHY_MERGE, *eeprom_remarks(subject)),
        "left_out": _left_out(subject),
        "cstruct_remarks": _configuration_remarks(subject, choice),
    }


def _configuration_remarks(subject: Subject, choice: Mapping[int, ModuleChoice]) -> tuple[str, ...]:
    """What other files say in their heading; nothing where no file is made, and the export says why."""
    try:
        return configure(subject, Choice(modules=choice)).remarks
    except InputError:
        return ()


def _left_out(subject: Subject) -> tuple[str, ...]:
    """What of the image is left out to fit the EEPROM; nothing where it fits, or where there is none."""
    try:
        return eeprom_image(subject, fit=True).dropped
    except EsiCatalogError:
        return ()


def _context(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, Any]:
    """What the page shows, section by section."""
    device = description.device
    derived = derive(device, description.modules)
    images = description.images(choice) if choice else derived.images
    return {
        "problem": None,
        "drawing_css": DRAWING_CSS,
        **_head(description, choice),
        "facts": head_facts(device, derived.facts),
        **_exports(description, any(image.pdos for image in images)),
        **_module_picker(description, choice),
        "images": [_image(image) for image in images],
        "sync_managers": [
            {"number": number, "sm": sm, "facts": sm_facts(sm), "flags": sm_flags(sm)}
            for number, sm in enumerate(device.sync_managers)
        ],
        "memory_map": memory_map_svg(device, images) if device.sync_managers else "",
        "pdos": _pdos(device, assigned_sms(derived.images)),
        "assignments": [(item, predefined_words(item, derived.images)) for item in predefined_assignments(device)],
        "modules": _modules(description.modules),
        "without_slot": WITHOUT_SLOT,
        "verdicts": derived.modes.verdicts,
        "axes_alone": axes_alone(derived.modes),
        "evidence": derived.modes.evidence,
        "op_modes": _op_modes(device, description.default_position(choice)),
        "commands": _commands_by_owner(description, choice),
        "objects": object_counts(description, choice),
        "eeprom": eeprom_words(device),
        **_beside_exports(description, choice),
        "findings": description.findings,
        "revisions": _revisions(description),
        "alike": [(device_path(item), item) for item in description.same_layout[:_MOST_ALIKE]],
        "alike_more": max(0, len(description.same_layout) - _MOST_ALIKE),
    }


def _head(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, Any]:
    """What the device is, where that is described, and the addresses of what is about it."""
    found, path = description.found, device_path(description.found) or ""
    chosen = modules_query(choice)
    return {
        "found": found,
        "identity": found.identity_text,
        "title": found.shown_type,
        "revision_text": revision_text(found.vendor_id, found.revision_no),
        "image": image_key(description.device.image_data),
        "group": description.device.group_type,
        "described": description.identified,
        "ambiguities": description.ambiguities,
        "path": path,
        "chosen": chosen,
        "json_path": f"{path}.json{chosen}",
        "variants": [
            f"{path.partition('@')[0]}{'' if n == 1 else f'@{n}'}" for n in range(1, len(description.variants) + 1)
        ],
    }


def _module_picker(description: DeviceDescription, choice: Mapping[int, ModuleChoice]) -> dict[str, Any]:
    """Slots with what fits them, those that nothing fits, and the number of the last one where not all are shown."""
    plugged = description.plugged(choice)
    offers = list(slot_offers(description.device, description.modules, plugged))
    last_slot = offers[-1].numbers[-1] if offers else 0
    return {
        "choice": choice,
        "slots": [
            (number, offer)
            for offer in offers
            for number in offer.numbers
            if offer.fitting and (number < _MOST_SLOTS or number in choice)
        ],
        "not_fitted": [offer for offer in offers if not offer.fitting],
        "module_idents": module_idents_words(description.device, plugged),
        "last_slot": last_slot if last_slot >= _MOST_SLOTS else None,
    }


def _modules(modules: Sequence[Module]) -> list[dict[str, Any]]:
    return [
        {
            "ident": module.module_ident,
            "label": label,
            "name": module_name(module),
            "pdos": _pdos(module, module_sms(module)),
            "commands": _commands(init_cmds(module.mailbox)),
        }
        for module, label in zip(modules, module_labels(modules), strict=True)
    ]


def _op_modes(device: Device, default: int | None) -> list[dict[str, Any]]:
    """The OpModes that newer tools ignore come last: of many not all are shown."""
    time_only = device.dc_time_loop_control_only
    shown = [
        {
            "position": position,
            "mode": mode,
            "signals": generated_signals(mode, time_only),
            "is_default": position == default,
            "is_superseded": is_superseded(mode),
            "drawing": dc_timing_svg(mode, time_loop_control_only=time_only),
        }
        for position, mode in enumerate(device.op_modes)
    ]
    return sorted(shown, key=lambda item: (not item["is_default"], item["is_superseded"]))


def _revisions(description: DeviceDescription) -> list[dict[str, Any]]:
    return [
        {
            "path": device_path(item.device),
            "found": item.device,
            "number": hex32(item.device.revision_no),
            "text": revision_text(item.device.vendor_id, item.device.revision_no),
            "hidden": item.hidden,
            "layout": item.layout_words,
            "is_this": item.device.revision_no == description.found.revision_no,
        }
        for item in description.revisions
    ]


def _exports(description: DeviceDescription, has_process_data: bool) -> dict[str, Any]:
    """What is offered, with fields for what it heeds, and the labels of what cannot be made without process data."""
    has_revision = description.found.revision_no is not None
    targets = {name: target for name, target in TARGETS.items() if has_revision or not target.needs_revision}
    offered = [name for name, target in targets.items() if has_process_data or not target.needs_process_data]
    fields = [name for name in _FORM_FIELDS if name != "op-mode" or len(description.device.op_modes) > 1]
    forms: dict[tuple[str, ...], list[str]] = {}
    for name in offered:
        forms.setdefault(tuple(field for field in fields if field in parameters_of(name)), []).append(name)
    return {
        "labels": {name: target.label for name, target in targets.items()},
        "exports": [(name, "module" in parameters_of(name)) for name in offered],
        "whole": [targets[name].label for name in offered if "module" not in parameters_of(name)],
        "export_forms": [
            (" or ".join(_FORM_FIELDS[field] for field in heeded), heeded, names)
            for heeded, names in forms.items()
            if heeded
        ],
        "not_exported": [target.label for name, target in targets.items() if name not in offered],
    }


def _image(image: SmImage) -> dict[str, Any]:
    return {
        "sm": image.sm,
        "usage": image.usage_words,
        "size": image.size_words,
        "remarks": image.remarks,
        "drawing": process_image_svg(image) if image.bit_size else "",
        "legend": process_image_legend(image) if image.bit_size else "",
        "rows": [
            {
                "place": byte_bit(placed.bit_offset),
                "bits": placed.entry.bit_length,
                "entry": entry_words(placed.entry),
                "type": placed.entry.data_type or "",
                "name": display_text(placed.entry.names) or "",
                "pdo": index_words(pdo.pdo.pdo_index) + (f" in slot {pdo.slot_number}" if pdo.module else ""),
            }
            for pdo in image.pdos
            for placed in pdo.entries
        ],
    }


def _pdos(owner: Device | Module, sms: Mapping[tuple[str, int], int]) -> list[dict[str, Any]]:
    """``sms`` are the SyncManagers of those that are assigned."""
    exclusions = symmetric_exclusions((*owner.rx_pdos, *owner.tx_pdos))
    return [
        {
            "direction": direction,
            "index": index_words(pdo.pdo_index),
            "name": display_text(pdo.names) or "",
            "sm": sms.get((direction, position)),
            "declared_sm": declared_sm_words(pdo, sms.get((direction, position))),
            "bits": bits_words(pdo),
            "flags": pdo_flags(pdo),
            "excludes": exclusions.get(pdo.pdo_index, ()),
            "entries": [
                {
                    "object": entry_words(entry),
                    "bits": entry.bit_length,
                    "type": entry.data_type or "",
                    "name": display_text(entry.names) or "",
                }
                for entry in pdo.entries
            ],
        }
        for direction, pdos in pdos_by_direction(owner)
        for position, pdo in enumerate(pdos)
    ]


def _commands_by_owner(
    description: DeviceDescription, choice: Mapping[int, ModuleChoice]
) -> dict[str, list[dict[str, Any]]]:
    return {
        owner: _commands((item.protocol, item.command) for item in items)
        for owner, items in groupby(description.init_cmds(choice), lambda item: item.owner)
    }


def _commands(commands: Iterable[tuple[str, InitCmd]]) -> list[dict[str, Any]]:
    return [
        {
            "protocol": protocol,
            "transitions": " ".join(cmd.transitions),
            "target": init_cmd_target(cmd),
            "value": _value(cmd),
            "cmd": cmd,
        }
        for protocol, cmd in commands
    ]


def _value(cmd: InitCmd) -> str:
    """Data of up to eight bytes as the number that it is on the wire, little endian."""
    data = decode_hex_binary(cmd.data)
    if not data or len(data) > _LONGEST_NUMBER or cmd.complete_access:
        return ""
    return number_words(int.from_bytes(data, "little"))
