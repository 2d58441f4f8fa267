"""What is answered where."""

from typing import Any

from datasette.utils.asgi import Response

from esicatalog.api import Catalog
from esicatalog.errors import NotFound
from esicatalog.web.exports import export_route
from esicatalog.web.http import json_route, page_route
from esicatalog.web.identify import identify_many, identify_one
from esicatalog.web.links import BASE, device_path
from esicatalog.web.openapi import openapi_document
from esicatalog.web.pages.compare import compare_page
from esicatalog.web.pages.device import device_json, device_page
from esicatalog.web.pages.home import devices_json, home_page
from esicatalog.web.pages.objects import PART, objects_page
from esicatalog.web.pages.scan import scan_page
from esicatalog.web.state import MOUNTED_AS, catalog_for

_IDENTITY = r"(?P<vendor>[^/]+)/(?P<product>[^/]+)/(?P<revision>[^/]+?)"
_IMAGE_TYPES = ((b"BM", "image/bmp"), (b"\x89PNG", "image/png"), (b"GIF8", "image/gif"), (b"\xff\xd8", "image/jpeg"))
_FOR_EVER = "public, max-age=31536000, immutable"
"""An image is addressed by the digest of its bytes."""


async def _openapi(request: Any, catalog: Catalog) -> tuple[Any, int]:
    base = request.path.partition("/-/esi/")[0]
    return openapi_document(base or "/"), 200


async def _image(request: Any, datasette: Any) -> Response:
    """An image of the catalog; only what is one by its first bytes, so that nothing else runs in a browser."""
    catalog = await catalog_for(datasette, request.actor)
    data = catalog.image(request.url_vars["sha256"]) or b""
    kind = next((kind for start, kind in _IMAGE_TYPES if data.startswith(start)), None)
    if kind is None:
        return Response("no such image", 404)
    return Response(data, 200, {"Cache-Control": _FOR_EVER, "X-Content-Type-Options": "nosniff"}, kind)


async def _row(request: Any, datasette: Any) -> Response:
    """From a ``device_id`` of the tables to the device page, or to the row of a device that has no codes."""
    catalog = await catalog_for(datasette, request.actor)
    number = int(request.url_vars["number"])
    try:
        path = device_path(catalog.device_of_row(number))
    except NotFound as error:
        return Response(str(error), 404)
    target = f"{BASE}{path}" if path else f"/{MOUNTED_AS}/devices/{number}"
    return Response("", 302, {"Location": datasette.urls.path(target), "Cache-Control": "no-cache"})


ROUTES: list[tuple[str, Any]] = [
    (r"^/-/esi/?$", page_route(home_page)),
    (r"^/-/esi/scan$", page_route(scan_page, post=True)),
    (r"^/-/esi/compare$", page_route(compare_page)),
    (rf"^/-/esi/device/{_IDENTITY}\.json$", json_route({"GET": device_json})),
    (rf"^/-/esi/device/{_IDENTITY}$", page_route(device_page)),
    (rf"^/-/esi/device/{_IDENTITY}/export/(?P<target>[a-z0-9]+)$", export_route),
    (rf"^/-/esi/device/{_IDENTITY}/objects$", page_route(objects_page, part=PART)),
    (r"^/-/esi/row/(?P<number>[0-9]{1,18})$", _row),
    (r"^/-/esi/image/(?P<sha256>[0-9a-f]{64})$", _image),
    (r"^/-/esi/identify\.json$", json_route({"GET": identify_one, "POST": identify_many})),
    (r"^/-/esi/devices\.json$", json_route({"GET": devices_json})),
    (r"^/-/esi/openapi\.json$", json_route({"GET": _openapi})),
]
"""Regular expressions of paths, and Datasette views."""
