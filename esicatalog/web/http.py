"""Requests and responses of the JSON routes: bounded bodies, errors as JSON, ETag, CORS only where Datasette has it."""

from collections.abc import Awaitable, Callable
from typing import Any

from datasette.utils import add_cors_headers
from datasette.utils.asgi import Response

from esicatalog.api import Catalog
from esicatalog.catalog.results import json_bytes
from esicatalog.errors import EsiCatalogError
from esicatalog.version import __version__
from esicatalog.web.state import catalog_for

MAX_BODY_BYTES = 4 * 1024 * 1024
"""A scan of a full bus (65535 slaves) in the longest format takes less."""

Handler = Callable[[Any, Catalog], Awaitable[tuple[Any, int]]]
"""Makes the JSON value and the HTTP status of an answer."""


class HttpError(Exception):
    """A request that cannot be answered; the text goes to the client."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


def json_route(handlers: dict[str, Handler]) -> Callable[[Any, Any], Awaitable[Response]]:
    """A Datasette view that answers JSON, by HTTP method. HEAD is answered as GET."""

    async def view(request: Any, datasette: Any) -> Response:
        headers: dict[str, str] = {}
        if datasette.cors:
            add_cors_headers(headers)
        if request.method == "OPTIONS" and datasette.cors:
            return Response(b"", 204, {**headers, "Access-Control-Allow-Methods": ", ".join(handlers)})
        handler = handlers.get("GET" if request.method == "HEAD" else request.method)
        if handler is None:
            return _json({"error": f"{request.method} is not allowed here"}, 405, {"Allow": ", ".join(handlers)})
        catalog = await catalog_for(datasette, request.actor)
        if handler is handlers.get("GET"):
            headers |= {"ETag": _etag(catalog), "Cache-Control": "no-cache"}
            if request.headers.get("if-none-match") == headers["ETag"]:
                return Response(b"", 304, headers)
        try:
            value, status = await handler(request, catalog)
        except HttpError as error:
            value, status = {"error": str(error)}, error.status
        except EsiCatalogError as error:
            value, status = {"error": str(error)}, 400
        return _json(value, status, headers)

    return view


def _etag(catalog: Catalog) -> str:
    """What an answer depends on: the content of the catalog and the version that answers."""
    return f'"{__version__}-{catalog.content_hash() or "changing"}"'


def _json(value: Any, status: int, headers: dict[str, str]) -> Response:
    body = json_bytes(value)
    return Response(body, status, {**headers, "Content-Length": str(len(body))}, "application/json; charset=utf-8")


async def body_of(request: Any) -> bytes:
    """The body of a request. Raises :class:`HttpError` 413 when it is larger than any scan."""
    parts: list[bytes] = []
    size, more = 0, True
    while more:
        message = await request.receive()
        if message["type"] != "http.request":
            raise HttpError(400, "the request was not finished")
        part = message.get("body", b"")
        size += len(part)
        if size > MAX_BODY_BYTES:
            raise HttpError(413, f"the body is larger than {MAX_BODY_BYTES} bytes")
        parts.append(part)
        more = message.get("more_body", False)
    return b"".join(parts)
