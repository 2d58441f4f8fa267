"""Tools for assistants, where datasette-mcp is installed (extra ``mcp``)."""

from typing import Any

from datasette.utils.asgi import Forbidden, NotFound

from esicatalog.api import Catalog
from esicatalog.catalog.description import description_json
from esicatalog.catalog.filter_texts import filter_of_texts
from esicatalog.errors import EsiCatalogError
from esicatalog.identity import parse_identity, parse_number
from esicatalog.web.state import catalog_for

_MOST_FOUND = 50
_SHEET_PARTS = ("identity", "sources", "process_image", "facts", "drive_modes", "revisions")
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
    async def find_devices(ctx: Context, filters: dict[str, str]) -> dict[str, Any]:
        """EtherCAT devices that fulfil all filters, each with its evidence.

        Filters are those of `esicatalog devices`, for example {"mode": "CSV", "sync": "sync1"}, {"text": "EL1100"},
        {"maps": "0x60FF", "bits": "32"}, {"protocol": "foe", "vendor": "0x2"}.
        """
        try:
            wanted = filter_of_texts({name: [text] for name, text in filters.items()})
            found = (await opened(ctx)).find(wanted)
        except EsiCatalogError as error:
            raise ToolError(str(error)) from error
        return {"count": len(found), "devices": [device.as_json() for device in found[:_MOST_FOUND]]}

    @mcp.tool()
    async def device_sheet(ctx: Context, identity: str) -> dict[str, Any]:
        """Process image, drive modes, facts and revisions of one device; identity is V:P[:R][@VARIANT]."""
        try:
            description = (await opened(ctx)).device(parse_identity(identity))
        except EsiCatalogError as error:
            raise ToolError(str(error)) from error
        sheet = description_json(description, {})
        return {part: sheet[part] for part in _SHEET_PARTS}
