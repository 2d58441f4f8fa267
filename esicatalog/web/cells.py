"""Cells of Datasette's table pages: numbers in hex, images as images, devices as links to their pages."""

import json
from collections.abc import Mapping
from typing import Any
from urllib.parse import quote, unquote

from markupsafe import Markup

from esicatalog.catalog.results import FoundDevice
from esicatalog.errors import InputError
from esicatalog.identity import parse_number
from esicatalog.web.bidi import isolated
from esicatalog.web.links import BASE, device_path, device_row_path

HEX_DIGITS = {
    **dict.fromkeys(("vendor_id", "class_vendor_id", "product_code", "revision_no", "serial_no"), 8),
    **dict.fromkeys(("module_ident", "default_ident", "fallback_ident"), 8),
    **dict.fromkeys(("attribute", "crc32", "unit"), 8),
    **dict.fromkeys(("pdo_index", "entry_index", "object_index", "type_index", "rx_pdo_index"), 4),
    **dict.fromkeys(("slot_index_increment", "slot_group_index_increment", "os_index_inc"), 4),
    **dict.fromkeys(("slot_pdo_increment", "slot_group_pdo_increment"), 4),
    **dict.fromkeys(("start_address", "assign_activate", "identification_ado", "esc_reg0108", "text_id"), 4),
    **dict.fromkeys(("access_word", "input_sync_types", "output_sync_types"), 4),
    **dict.fromkeys(("control_byte",), 2),
}
"""Columns that people read in hex, and how many digits they have."""
DEVICE_COLUMNS = ("device_id", "other_device_id", "previous_id")
"""Columns that hold keys in devices."""

_TYPE_COLUMNS = {"devices": "type"}
_VIEW_TYPE_COLUMN = "device_type"
_SENTENCES = ("evidence", "fsoe_evidence", "recipe", "message")
"""Columns with names of documents among words and numbers."""
_HEX_TEXT = "_hex"
"""Views have the numbers of such columns as text, too, in columns of this ending."""
_OTHER = "other_"
"""What a view has of two devices begins so for the second one."""
_OPERATORS = {"exact", "not", "gt", "gte", "lt", "lte", "in", "notin"}
"""Comparisons of Datasette's filters (``column__gt=…``) that take numbers."""


def cell(row: Any, value: Any, column: str, table: str | None, base_url: str) -> str | None:
    """What a cell shows in place of its value, markup or text; None leaves it to Datasette."""
    digits = HEX_DIGITS.get(column)
    if digits is not None and isinstance(value, int):
        return Markup('<span title="{}">0x{}</span>').format(value, f"{value:0{digits}x}")
    if column in (_VIEW_TYPE_COLUMN, _TYPE_COLUMNS.get(table or "")):
        path = _device_path(row)
        if path is not None:
            href = f"{base_url}{BASE.removeprefix('/')}{quote(path, safe='/@')}"
            return Markup('<a href="{}">{}</a>').format(href, value or "without type")
    number = _plain(value)
    if column in DEVICE_COLUMNS and isinstance(number, int):
        label = value["label"] or "-" if isinstance(value, Mapping) else "device"
        href = f"{base_url}{BASE.removeprefix('/')}{device_row_path(number)}"
        return Markup('<a href="{}">{}</a>&nbsp;<em>{}</em>').format(href, label, number)
    if column == "image_sha256" and isinstance(value, str) and value:
        href = f"{base_url}{BASE.removeprefix('/')}image/{quote(value)}"
        return Markup('<img src="{}" alt="" title="{}" style="image-rendering: pixelated">').format(href, value)
    if column in _SENTENCES and isinstance(value, str) and (shown := isolated(value)) != value:
        return shown
    return None


def _device_path(row: Any) -> str | None:
    try:
        numbers = (row["vendor_id"], row["product_code"], row["revision_no"])
        variant = row["variant"]
    except (KeyError, IndexError, TypeError):
        return None
    numbers = tuple(_plain(number) for number in numbers)
    return device_path(FoundDevice(*numbers, variant, None, None, None, False))


def _plain(number: Any) -> Any:
    """Foreign keys that Datasette has expanded are {"value": …, "label": …}."""
    return number["value"] if isinstance(number, Mapping) else number


def stored_filters(query: str) -> str | None:
    """The query string of a table page with the numbers of filters as the columns hold them; None when all are.

    Hex numbers become decimal, and for columns of ``0x…`` text any number gets their digits: SQL compares texts.
    """
    parts, changed = [], False
    for part in query.split("&"):
        name, equals, text = part.partition("=")
        column, _, operator = unquote(name).partition("__")
        given = unquote(text.replace("+", " "))
        stored = _stored(column, operator, given)
        if equals and stored not in (None, given):
            part, changed = f"{name}={stored}", True
        parts.append(part)
    return "&".join(parts) if changed else None


def _stored(column: str, operator: str, text: str) -> str | None:
    if operator and operator not in _OPERATORS:
        return None
    digits = HEX_DIGITS.get(column.removesuffix(_HEX_TEXT).removeprefix(_OTHER))
    is_text = column.endswith(_HEX_TEXT)
    if digits is None or not (is_text or any(mark in text.lower() for mark in ("0x", "#x"))):
        return None
    try:
        items = json.loads(text) if text.startswith("[") else text.split(",")
        numbers = [parse_number(str(item)) for item in items]
    except (InputError, ValueError, RecursionError):
        return None
    return ",".join(f"0x{number:0{digits}x}" if is_text else str(number) for number in numbers)
