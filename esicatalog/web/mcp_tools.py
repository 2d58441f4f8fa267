"""Tools for assistants, where datasette-mcp is installed (extra ``mcp``)."""

from typing import Any

import msgspec
from datasette.utils.asgi import Forbidden, NotFound

from esicatalog.api import Catalog
from esicatalog.catalog.description import description_json
from esicatalog.catalog.filter_texts import filter_of_texts
from esicatalog.errors import EsiCatalogError
from esicatalog.identity import modules_by_slot, parse_identity, parse_number, parse_plugged
from esicatalog.web.state import catalog_for

_MOST_SHOWN = 50
_SHEET_PARTS = ("identity", "sources", "variants", "process_image", "slots", "facts", "drive_modes", "revisions")
"""What of a sheet fits into a conversation; the records themselves are at device/V/P/R.json."""


def register_tools(datasette: Any, mcp: Any) -> None:
    """Offer identify_device, find_devices and device_sheet; every answer says what files declare, with evidence."""
    from mcp.server.mcpserver import Context
    from mcp.server.mcpserver.exceptions import ToolError

    async def opened(ctx: Any) -> Catalog:
        """The catalog, for whom the request's actor may see it."""
        request = ctx.request_context.request
        try:
            return await catalog_for(datasette, request.scope.get("actor") if request is not None else None)
        except (Forbidden, NotFound) as error:
            raise ToolError(str(error)) from error

    @mcp.tool()
    async def identify_device(ctx: Context, vendor: str, product: str, revision: str = "") -> dict[str, Any]:
        """Which EtherCAT device has this identity? Numbers as 0x1097, #x1097 or decimal; revision may be empty.

        Anything but match "exact" names the nearest description and the rule by which it was chosen.
        """
        try:
            found = (await opened(ctx)).identify(
                parse_number(vendor, "vendor"),
                parse_number(product, "product"),
                parse_number(revision, "revision") if revision else None,
            )
        except EsiCatalogError as error:
            raise ToolError(str(error)) from error
        return found.as_json()

    @mcp.tool()
    async def find_devices(ctx: Context, filters: dict[str, str | int | bool | list[str]]) -> dict[str, Any]:
        """EtherCAT devices that fulfil all filters, each with its evidence.

        Filters are those of `esicatalog devices`, for example {"mode": "CSV,CSP", "sync": "sync1"}, {"text": "EL1100"},
        {"maps": ["0x60FF", "0x6040:0"], "bits": 32}, {"protocol": "foe", "vendor": "0x2", "complete-access": true}.
        At most 50 devices are shown, or `limit` of them; count says how many there are.
        """
        try:
            wanted = filter_of_texts({name: _texts(given) for name, given in filters.items()})
            found = (await opened(ctx)).find(msgspec.structs.replace(wanted, limit=None))
        except EsiCatalogError as error:
            raise ToolError(str(error)) from error
        shown = found[: _MOST_SHOWN if wanted.limit is None else min(wanted.limit, _MOST_SHOWN)]
        return {"count": len(found), "shown": len(shown), "devices": [device.as_json() for device in shown]}

    @mcp.tool()
    async def device_sheet(ctx: Context, identity: str, modules: list[str] | None = None) -> dict[str, Any]:
        """Process image, slots, drive modes, facts and revisions of one device; identity is V:P[:R][@VARIANT].

        Several variants are descriptions of one identity that contradict each other: the sheet is that of one of them,
        the device may be as another one says. Where there are slots, process data come from the modules in them, and
        by default there may be none: name what is plugged, SLOT=CHOICE of those that slots has, for example
        ["0=0x119800", "1=0x1785/KL6021-A"]. The process image is then with these modules, all else is by default.
        """
        try:
            choice = modules_by_slot(map(parse_plugged, modules or ()))
            description = (await opened(ctx)).device(parse_identity(identity))
            sheet = description_json(description, choice)
        except EsiCatalogError as error:
            raise ToolError(str(error)) from error
        return {part: sheet[part] for part in _SHEET_PARTS}


def _texts(given: str | int | bool | list[str]) -> list[str]:
    """A filter as the texts that addresses have."""
    if isinstance(given, list):
        return given
    return [str(int(given)) if isinstance(given, bool) else str(given)]
