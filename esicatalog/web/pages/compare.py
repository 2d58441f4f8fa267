"""The compare page: two descriptions side by side, difference by difference."""

import asyncio
from collections import defaultdict
from typing import Any

from esicatalog.api import Catalog
from esicatalog.errors import EsiCatalogError
from esicatalog.identity import parse_identity
from esicatalog.model.compare import compare_devices, summary_words
from esicatalog.model.compare_device import revision_verdict
from esicatalog.web.http import Page, status_of
from esicatalog.web.links import device_path

_TEMPLATE = "compare.html"


async def compare_page(request: Any, catalog: Catalog) -> Page:
    """``?a=V:P:R&b=V:P:R``; without both the form alone."""
    texts = {name: (request.args.get(name) or "").strip() for name in ("a", "b")}
    empty = {**texts, "problem": None, "sides": None}
    if not all(texts.values()):
        return Page(_TEMPLATE, empty)
    try:
        return Page(_TEMPLATE, empty | await asyncio.to_thread(_compared, catalog, texts["a"], texts["b"]))
    except EsiCatalogError as error:
        return Page(_TEMPLATE, empty | {"problem": str(error)}, status_of(error))


def _compared(catalog: Catalog, first: str, second: str) -> dict[str, Any]:
    left, right = (catalog.device(parse_identity(text)) for text in (first, second))
    differences = compare_devices(
        left.device,
        left.modules,
        right.device,
        right.modules,
        left_vendor_id=left.found.vendor_id,
        right_vendor_id=right.found.vendor_id,
    )
    areas: dict[str, list[Any]] = defaultdict(list)
    for item in differences:
        areas[f"{item.module}: {item.area}" if item.module else item.area].append(item)
    return {
        "sides": [{"found": side.found, "path": device_path(side.found)} for side in (left, right)],
        "areas": list(areas.items()),
        "summary": summary_words(differences),
        "verdict": revision_verdict(left.device, right.device),
    }
