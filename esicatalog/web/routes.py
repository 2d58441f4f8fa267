"""What is answered where."""

from typing import Any
from urllib.parse import quote, unquote

from datasette.utils.asgi import Response

from esicatalog.api import Catalog
from esicatalog.errors import NotFound
from esicatalog.parameters import check_names
from esicatalog.web.exports import export_route
from esicatalog.web.http import (
    error_page,
    file_route,
    json_route,
    page_response,
    page_route,
    unknown_address,
)
from esicatalog.web.identify import identify_many, identify_one
from esicatalog.web.links import BASE, device_path
from esicatalog.web.openapi import openapi_document
from esicatalog.web.pages.compare import compare_page
from esicatalog.web.pages.device import device_json, device_page
from esicatalog.web.pages.home import devices_json, home_page
from esicatalog.web.pages.objects import PART, objects_page
from esicatalog.web.pages.scan import scan_page
from esicatalog.web.state import MOUNTED_AS, catalog_for

_PRODUCT = r"(?P<vendor>[^/]+)/(?P<product>[^/]+?)"
_IDENTITY = rf"{_PRODUCT}/(?P<revision>[^/]+?)"
_IMAGE_TYPES = ((b"BM", "image/bmp"), (b"\x89PNG", "image/png"), (b"GIF8", "image/gif"), (b"\xff\xd8", "image/jpeg"))
_FOR_EVER = "public, max-age=31536000, immutable"
"""An image is addressed by the digest of its bytes."""


async def _openapi(request: Any, catalog: Catalog) -> tuple[Any, int]:
    check_names(request.args, ())
    base = request.path.partition(BASE)[0]
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
        return await page_response(error_page(str(error), 404), request, datasette, {})
    return _found(datasette, f"{BASE}{path}" if path else f"/{MOUNTED_AS}/devices/{number}")


async def _latest(request: Any, datasette: Any) -> Response:
    """From a product to its latest visible revision, which is what an identity without revision means everywhere."""
    vendor, product = (quote(unquote(request.url_vars[name]), safe="") for name in ("vendor", "product"))
    query = f"?{request.query_string}" if request.query_string else ""
    return _found(datasette, f"{BASE}device/{vendor}/{product}/latest{request.url_vars['ending']}{query}")


def _found(datasette: Any, path: str) -> Response:
    """The way to another address, which may be another one tomorrow."""
    return Response("", 302, {"Location": datasette.urls.path(path), "Cache-Control": "no-cache"})


ROUTES: list[tuple[str, Any]] = [
    (rf"^{BASE}?$", page_route(home_page)),
    (rf"^{BASE}scan$", page_route(scan_page, post=True)),
    (rf"^{BASE}compare$", page_route(compare_page)),
    (rf"^{BASE}device/{_PRODUCT}(?P<ending>(?:\.json)?)/?$", file_route(_latest)),
    (rf"^{BASE}device/{_IDENTITY}\.json$", json_route({"GET": device_json})),
    (rf"^{BASE}device/{_IDENTITY}$", page_route(device_page)),
    (rf"^{BASE}device/{_IDENTITY}/export/(?P<target>[a-z0-9]+)$", file_route(export_route)),
    (rf"^{BASE}device/{_IDENTITY}/objects$", page_route(objects_page, part=PART)),
    (rf"^{BASE}row/(?P<number>[0-9]{{1,18}})$", file_route(_row)),
    (rf"^{BASE}image/(?P<sha256>[0-9a-f]{{64}})$", file_route(_image)),
    (rf"^{BASE}identify\.json$", json_route({"GET": identify_one, "POST": identify_many})),
    (rf"^{BASE}devices\.json$", json_route({"GET": devices_json})),
    (rf"^{BASE}openapi\.json$", json_route({"GET": _openapi})),
    (rf"^{BASE}", unknown_address),
]
"""Regular expressions of paths, and Datasette views."""
