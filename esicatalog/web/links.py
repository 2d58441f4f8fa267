"""Addresses of pages, relative to where Datasette is mounted."""

from typing import Any
from urllib.parse import quote, unquote, urlencode

from esicatalog.catalog.results import FoundDevice
from esicatalog.identity import NO_REVISION, Identity, identity_of_parts

BASE = "/-/esi/"


def device_path(device: FoundDevice) -> str | None:
    """Path of a device page below :data:`BASE`; None for a device without vendor or product code."""
    if device.vendor_id is None or device.product_code is None:
        return None
    revision = f"0x{device.revision_no:x}" if device.revision_no is not None else NO_REVISION
    path = f"device/0x{device.vendor_id:x}/0x{device.product_code:x}/{revision}"
    return path if device.variant == 1 else f"{path}@{device.variant}"


def device_row_path(number: int) -> str:
    """Path below :data:`BASE` that leads from a ``device_id`` of the tables to the page of the device."""
    return f"row/{number}"


def asked_identity(request: Any) -> Identity:
    """The identity in the path of a device page; ``latest`` is the latest visible revision."""
    vendor, product, last = (unquote(request.url_vars[name]) for name in ("vendor", "product", "revision"))
    revision, at, variant = last.partition("@")
    return identity_of_parts(vendor, product, revision if revision != "latest" else None, variant if at else None)


def with_query(path: str, parameters: list[tuple[str, str]]) -> str:
    """A path with parameters; those without text are left out."""
    query = urlencode([(name, text) for name, text in parameters if text], quote_via=quote)
    return f"{path}?{query}" if query else path
