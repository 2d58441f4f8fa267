"""The home page: one search box, filters with counts, found devices."""

import asyncio
from collections.abc import Mapping, Sequence
from typing import Any

import msgspec

from esicatalog.api import Catalog
from esicatalog.catalog.device_filter import DeviceFilter
from esicatalog.catalog.filter_texts import PARAMETERS, SHARPENS, TRUE_WORDS, filter_of_texts
from esicatalog.catalog.listing import ListedDevice, Listing
from esicatalog.errors import EsiCatalogError, InputError
from esicatalog.identity import parse_number
from esicatalog.parameters import given_texts
from esicatalog.web.http import Page, status_of, texts_of
from esicatalog.web.links import BASE, device_path, with_query

PAGE_LENGTH = 50
_PAGE, _LAST_PAGE = "page", 100_000
_LIMIT = "limit"
_MAIN_FIELDS = ("text", "mode", "sync", "protocol", "maps")
_CHECKS = {
    "strict": "only verdict yes",
    "include-hidden": "hidden revisions too",
    "all-variants": "all variants",
    "needs-dc": "needs DC",
    "complete-access": "complete access",
    "pdo-assign": "PDO assign",
    "pdo-config": "PDO config",
    "bootstrap": "bootstrap mailbox",
    "no-lrw": "no LRW",
}
_TEXTS = {
    "object": ("Has object", "0x6502"),
    "bytes-in": ("Input bytes", "<=8"),
    "bytes-out": ("Output bytes", ">=4"),
    "min-cycle-ns": ("Smallest cycle in ns", "<=250000"),
    "e-bus-ma": ("E-bus current in mA", "<=100"),
    "axes": ("CiA 402 axes", ">=2"),
    "physics": ("Ports", "YY"),
    "like": ("Same layout as V:P:R", "0x2:0x03f63052"),
}
"""Filters that are written: label and example."""


async def home_page(request: Any, catalog: Catalog) -> Page:
    """Search by the parameters of the address, which are those of the command ``devices``.

    What cannot be asked is told beside the form, so that it can be mended.
    """
    texts = texts_of(request)
    pages, limits = texts.pop(_PAGE, []), texts.pop(_LIMIT, [])
    try:
        if any(limits):
            raise InputError(
                f"this page shows all that is found, {PAGE_LENGTH} at a time; {_LIMIT} is for devices.json"
            )
        wanted = filter_of_texts(_meant(texts))
        listing, number = await asyncio.to_thread(_listed, catalog, wanted, _page_number(pages))
    except EsiCatalogError as error:
        context = _context(texts, DeviceFilter(), Listing((), 0, 0, {}, ""), 1)
        return Page("home.html", {**context, "problem": str(error)}, status_of(error))
    return Page("home.html", _context(texts, wanted, listing, number))


def _listed(catalog: Catalog, wanted: DeviceFilter, number: int) -> tuple[Listing, int]:
    """The page of this number, or the last one, and its number."""
    limited = msgspec.structs.replace(wanted, limit=PAGE_LENGTH)
    listing = catalog.list_devices(limited, (number - 1) * PAGE_LENGTH)
    last = _pages(listing)
    if number <= last:
        return listing, number
    return catalog.list_devices(limited, (last - 1) * PAGE_LENGTH), last


def _pages(listing: Listing) -> int:
    return max(1, -(-listing.total // PAGE_LENGTH))


async def devices_json(request: Any, catalog: Catalog) -> tuple[Any, int]:
    """The devices that fulfil the parameters, as ``esicatalog devices --format json`` prints them."""
    wanted: DeviceFilter = filter_of_texts(texts_of(request))
    found = await asyncio.to_thread(catalog.find, wanted)
    return [device.as_json() for device in found], 200


def _page_number(texts: list[str]) -> int:
    """The page that is asked for, 1 where none is. Raises :class:`InputError`."""
    given = given_texts({_PAGE: texts}, (_PAGE,))
    number = parse_number(given[_PAGE][0], _PAGE, _LAST_PAGE) if given else 1
    if number == 0:
        raise InputError("pages count from 1")
    return number


def _meant(texts: Mapping[str, Sequence[str]]) -> dict[str, Sequence[str]]:
    """The parameters that count: the form sends what is ticked, also when the mode that it is about was taken out."""
    return {
        name: values for name, values in texts.items() if name not in SHARPENS or any(texts.get(SHARPENS[name], ()))
    }


def _context(texts: dict[str, list[str]], wanted: DeviceFilter, listing: Listing, number: int) -> dict[str, Any]:
    given = _pairs(_meant(texts))
    chosen = _chosen(wanted)
    pages = _pages(listing)
    written = {name: [text for text in values if text.strip()] for name, values in texts.items()}
    checked = [name for name in _CHECKS if {*TRUE_WORDS}.intersection(texts.get(name, ()))]
    without_field = [item for item in given if item[0] not in (*_MAIN_FIELDS, *_CHECKS, *_TEXTS)]
    return {
        "given": {name: values[0] for name, values in texts.items() if values},
        "written": written,
        "devices": [_row(item) for item in listing.devices],
        "total": listing.total,
        "facets": {
            name: [
                {
                    "label": value.label,
                    "count": value.device_count,
                    "chosen": value.text in chosen[name],
                    "href": with_query("", _toggled(given, name, value.text, chosen[name])),
                }
                for value in values
            ]
            for name, values in listing.facets.items()
        },
        "checks": _CHECKS,
        "checked": checked,
        "texts": _TEXTS,
        "has_more": bool(checked) or any(written.get(name) for name in _TEXTS),
        "without_field": [
            (name, text, with_query("", [item for item in given if item != (name, text)]))
            for name, text in without_field
        ],
        "sql": listing.sql,
        "json_href": with_query(f"{BASE}devices.json", given),
        "page": number,
        "pages": pages,
        "previous": with_query("", [*given, (_PAGE, str(number - 1))]) if number > 1 else None,
        "next": with_query("", [*given, (_PAGE, str(number + 1))]) if number < pages else None,
        "modes": PARAMETERS["mode"].choices,
        "syncs": PARAMETERS["sync"].choices,
        "protocols": PARAMETERS["protocol"].choices,
    }


def _pairs(texts: Mapping[str, Sequence[str]]) -> list[tuple[str, str]]:
    return [(name, text) for name, values in texts.items() for text in values if text.strip()]


def _chosen(wanted: DeviceFilter) -> dict[str, tuple[str, ...]]:
    """The words that a filter names, by facet and as facets write them."""
    words = {
        "vendor": f"0x{wanted.vendor_id:x}" if wanted.vendor_id is not None else None,
        "sync": wanted.sync,
        "protocol": wanted.protocol,
        "profile": str(wanted.profile_no) if wanted.profile_no is not None else None,
    }
    return {"mode": wanted.modes, **{name: (word,) if word is not None else () for name, word in words.items()}}


def _toggled(given: list[tuple[str, str]], name: str, text: str, chosen: tuple[str, ...]) -> list[tuple[str, str]]:
    """The parameters with this choice made, or taken back where it stands; modes add up."""
    kept = chosen if name == "mode" else ()
    words = [word for word in chosen if word != text] if text in chosen else [*kept, text]
    return [*(item for item in given if item[0] != name), (name, ",".join(words))]


def _row(item: ListedDevice) -> dict[str, Any]:
    device = item.found
    return {
        "identity": device.identity_text,
        "path": device_path(device),
        "vendor": device.vendor or "",
        "type": device.shown_type,
        "name": device.name or "",
        "hidden": device.hidden,
        "image": item.image_sha256,
        "modes": item.modes,
        "signals": item.signals,
        "evidence": device.shown_evidence,
    }
