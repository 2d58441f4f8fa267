"""The compare page: two descriptions side by side, difference by difference."""

import asyncio
from collections import defaultdict
from functools import partial
from typing import Any

from esicatalog.api import Catalog
from esicatalog.catalog.description import DeviceDescription
from esicatalog.catalog.results import FoundDevice
from esicatalog.errors import EsiCatalogError, NotFound
from esicatalog.identity import parse_identity
from esicatalog.model.compare import compare_devices, images_are_known, summary_words
from esicatalog.model.compare_device import revision_verdict
from esicatalog.parameters import given_texts
from esicatalog.web.http import Page, status_of, texts_of
from esicatalog.web.links import BASE, device_path, with_query
from esicatalog.web.pages.nearest import nearest

_TEMPLATE = "compare.html"
_SIDES = ("a", "b")


async def compare_page(request: Any, catalog: Catalog) -> Page:
    """``?a=V:P:R&b=V:P:R``; without both the form alone."""
    given = given_texts(texts_of(request), _SIDES)
    texts = {name: given.get(name, [""])[0].strip() for name in _SIDES}
    shown = {**texts, "problem": None, "missing": (), "sides": None}
    if not all(texts.values()):
        return Page(_TEMPLATE, shown)
    try:
        sides, missing = await asyncio.to_thread(_sides, catalog, texts)
        if missing:
            return Page(_TEMPLATE, shown | {"missing": missing}, 404)
        return Page(_TEMPLATE, shown | await asyncio.to_thread(_compared, *sides))
    except EsiCatalogError as error:
        return Page(_TEMPLATE, shown | {"problem": str(error)}, status_of(error))


def _sides(catalog: Catalog, texts: dict[str, str]) -> tuple[list[DeviceDescription], list[dict[str, Any]]]:
    """The descriptions, and for each that there is not the nearest ones, with the ways to compare those instead."""
    sides, missing = [], []
    for name, text in texts.items():
        identity = parse_identity(text)
        try:
            sides.append(catalog.device(identity))
        except NotFound as error:
            missing.append(nearest(catalog, identity, error, partial(_instead, texts, name)))
    return sides, missing


def _instead(texts: dict[str, str], name: str, device: FoundDevice) -> str:
    return with_query(f"{BASE}compare", list((texts | {name: device.identity_text}).items()))


def _compared(left: DeviceDescription, right: DeviceDescription) -> dict[str, Any]:
    differences = compare_devices(left, right)
    areas: dict[str, list[Any]] = defaultdict(list)
    for item in differences:
        areas[f"{item.module}: {item.area}" if item.module else item.area].append(item)
    return {
        "sides": [
            {"found": side.found, "path": device_path(side.found), "damage": side.identified.damage}
            for side in (left, right)
        ],
        "areas": list(areas.items()),
        "summary": summary_words(differences, images_are_known(left, right)),
        "verdict": revision_verdict(left.device, right.device),
    }
