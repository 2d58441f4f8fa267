"""The scan page: paste what a master printed or drop an EEPROM image, get the bus with matches."""

import asyncio
from typing import Any

from esicatalog.api import Catalog
from esicatalog.catalog.identified_bus import BusReport, IdentifiedSlave, bus_facts
from esicatalog.errors import EsiCatalogError, InputError
from esicatalog.parameters import check_names
from esicatalog.scan.text import decode_text, is_utf16
from esicatalog.sii.checksum import is_loaded
from esicatalog.sii.errors import SiiImageError
from esicatalog.sii.files import is_intel_hex, read_sii
from esicatalog.sii.image import FILLER, SiiImage
from esicatalog.sii.records import HEADER
from esicatalog.sii.text import sheet_lines
from esicatalog.web.http import Page, body_of
from esicatalog.web.links import device_path
from esicatalog.web.uploads import read_form, read_uploaded_scan

_TEMPLATE = "scan.html"
_NEITHER = "neither a scan nor an EEPROM image"
_SHOWN = 100
_NOTHING: dict[str, Any] = {"text": "", "buses": [], "findings": [], "sii": None, "problem": None}


async def scan_page(request: Any, catalog: Catalog) -> Page:
    """The empty form, or what was posted with its matches; a text and a file at once are refused."""
    check_names(request.args, ())
    if request.method != "POST":
        return Page(_TEMPLATE, dict(_NOTHING))
    form = await asyncio.to_thread(read_form, request.headers.get("content-type", ""), await body_of(request))
    pasted, file = (form.contents.get(name, b"") for name in ("scan", "file"))
    shown = _NOTHING | {"text": decode_text(pasted)}
    try:
        if file and pasted.strip():
            raise InputError("a text is given beside this file; give one of both")
        return Page(_TEMPLATE, shown | await asyncio.to_thread(_answer, file or pasted, catalog))
    except EsiCatalogError as error:
        name = form.file_names.get("file")
        problem = f"{name[:_SHOWN]}: {error}" if name else str(error)
        return Page(_TEMPLATE, shown | {"problem": problem}, 400)


def _answer(content: bytes, catalog: Catalog) -> dict[str, Any]:
    if _looks_like_image(content):
        return {"sii": _image(content, catalog)}
    scan = read_uploaded_scan(decode_text(content))
    return {
        "buses": [_bus(bus) for bus in catalog.identify_scan(scan)],
        "findings": scan.finding_lines,
    }


def _looks_like_image(content: bytes) -> bool:
    """Scans are text; an image holds zeros, or is Intel HEX, and an erased EEPROM holds nothing but 0xFF."""
    is_erased = bool(content) and not content.strip(bytes([FILLER]))
    return not is_utf16(content) and (b"\0" in content or is_erased or is_intel_hex(content))


def _read_image(content: bytes) -> SiiImage:
    """An image that something speaks for: Intel HEX, the check sum of its header, or categories up to an end mark.

    Raises :class:`InputError` for other bytes, and :class:`SiiImageError`.
    """
    is_image = is_intel_hex(content) or (len(content) >= HEADER.size and is_loaded(HEADER.read(content)))
    try:
        image = read_sii(content)
    except SiiImageError as error:
        if is_image:
            raise
        raise InputError(f"{_NEITHER} ({error})") from error
    if not (is_image or image.end_mark):
        raise InputError(_NEITHER)
    return image


def _image(content: bytes, catalog: Catalog) -> dict[str, Any]:
    image = _read_image(content)
    header = image.header
    answer = catalog.identify(header.vendor_id, header.product_code, header.revision_no)
    device = answer.found
    return {
        "match": answer.match,
        "reason": answer.reason,
        "warnings": answer.warnings,
        "path": device_path(device) if device is not None else None,
        "type": device.shown_type if device is not None else None,
        "sheet": "\n".join(sheet_lines(image)),
    }


def _bus(bus: BusReport) -> dict[str, Any]:
    return {
        "title": bus.title,
        "slaves": [_slave(item) for item in bus.slaves],
        "summary": bus_facts(bus),
    }


def _slave(item: IdentifiedSlave) -> dict[str, Any]:
    slave, answer, report = item.slave, item.identification, item.report
    device = answer.found
    return {
        "position": slave.position,
        "alias": slave.alias,
        "identity": item.identity_text,
        "match": answer.match,
        "path": device_path(device) if device is not None else None,
        "type": device.shown_type if device is not None else slave.name or "",
        "revision": item.described_revision,
        "source": item.source,
        "left": "" if report.e_bus_left_ma is None else f"{report.e_bus_left_ma} mA",
        "out": "?" if report.output_bytes is None else report.output_bytes,
        "in": "?" if report.input_bytes is None else report.input_bytes,
        "notes": item.notes,
    }
