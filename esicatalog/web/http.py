"""Requests and responses: bounded bodies, errors as JSON or pages, ETag, CORS only where Datasette has it."""

import asyncio
from collections.abc import Awaitable, Callable, Iterable
from typing import Any, NamedTuple
from urllib.parse import unquote_plus

from datasette.utils import add_cors_headers
from datasette.utils.asgi import Response

from esicatalog.api import Catalog
from esicatalog.catalog.results import json_bytes
from esicatalog.catalog.unfinished import CUT_SHORT
from esicatalog.errors import EsiCatalogError, InputError, NotFound
from esicatalog.version import __version__
from esicatalog.web.links import BASE
from esicatalog.web.state import catalog_for

MAX_BODY_BYTES = 4 * 1024 * 1024
"""A scan of a full bus (65535 slaves) in the longest format takes less."""
MAX_BODY_SECONDS = 60.0
"""A client that sends slower than this gives up its place."""

_SHOWN = 40
_ERROR_TITLES = {404: "Not found"}

View = Callable[[Any, Any], Awaitable[Response]]
"""What Datasette calls for a route: (request, datasette) → response."""
Handler = Callable[[Any, Catalog], Awaitable[tuple[Any, int]]]
"""Makes the JSON value and the HTTP status of an answer."""


class Page(NamedTuple):
    """A page to render: template, what it shows, HTTP status."""

    template: str
    context: dict[str, Any]
    status: int = 200


class Part(NamedTuple):
    """A request header that asks for a part of a page in place of the page: its name and the value that does."""

    header: str
    value: str

    def is_asked(self, request: Any) -> bool:
        """Whether a request asks for the part."""
        return bool(request.headers.get(self.header.lower()) == self.value)


class HttpError(Exception):
    """A request that cannot be answered; the text goes to the client."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


def json_route(handlers: dict[str, Handler]) -> View:
    """A Datasette view that answers JSON, by HTTP method. HEAD is answered as GET."""

    async def view(request: Any, datasette: Any) -> Response:
        headers = _cors_headers(datasette)
        refused = _refused_method(request, handlers, headers)
        if refused is not None:
            return refused
        method = _method_of(request)
        catalog = await catalog_for(datasette, request.actor)
        if method == "GET":
            headers |= _validators(catalog)
            if _is_confirmed(request, headers):
                return Response(b"", 304, headers)
        try:
            value, status = await handlers[method](request, catalog)
        except HttpError as error:
            value, status = {"error": str(error)}, error.status
        except EsiCatalogError as error:
            value, status = {"error": str(error)}, status_of(error)
        return _json(value, status, headers)

    return view


def file_route(view: View) -> View:
    """A Datasette view that answers GET and HEAD with what is neither JSON nor a page of its own."""

    async def checked(request: Any, datasette: Any) -> Response:
        headers = _cors_headers(datasette)
        refused = _refused_method(request, ("GET",), headers)
        if refused is not None:
            return refused
        response = await view(request, datasette)
        response.headers.update(headers)
        return response

    return checked


def _method_of(request: Any) -> str:
    return "GET" if request.method == "HEAD" else str(request.method)


def _refused_method(request: Any, methods: Iterable[str], headers: dict[str, str]) -> Response | None:
    """The answer to a method that is not among these, where CORS is that which browsers ask for beforehand."""
    if request.method == "OPTIONS" and headers:
        return Response(b"", 204, {**headers, "Access-Control-Allow-Methods": ", ".join(methods)})
    if _method_of(request) in methods:
        return None
    return _json({"error": f"{request.method} is not allowed here"}, 405, {**headers, "Allow": ", ".join(methods)})


def _cors_headers(datasette: Any) -> dict[str, str]:
    """What lets scripts of other sites ask and read, where Datasette lets them: JSON is posted with its type."""
    headers: dict[str, str] = {}
    if datasette.cors:
        add_cors_headers(headers)
        headers["Access-Control-Allow-Headers"] = "Authorization, Content-Type"
    return headers


def page_route(
    handler: Callable[[Any, Catalog], Awaitable[Page]], post: bool = False, part: Part | None = None
) -> View:
    """A Datasette view that answers a page, or a part of it; errors become a page of their own."""
    methods = ("GET", "HEAD", "POST") if post else ("GET", "HEAD")

    async def view(request: Any, datasette: Any) -> Response:
        if request.method not in methods:
            return Response("method not allowed", 405, {"Allow": ", ".join(methods)})
        catalog = await catalog_for(datasette, request.actor)
        headers = {"Vary": part.header} if part is not None else {}
        if request.method != "POST":
            headers |= _validators(catalog, "part" if part is not None and part.is_asked(request) else "")
            if _is_confirmed(request, headers):
                return Response(b"", 304, headers)
        try:
            page = await handler(request, catalog)
            if await asyncio.to_thread(catalog.is_unfinished):
                page = page._replace(context={**page.context, "unfinished": CUT_SHORT})
        except HttpError as error:
            page = error_page(str(error), error.status)
        except EsiCatalogError as error:
            page = error_page(str(error), status_of(error))
        return await page_response(page, request, datasette, headers)

    return view


def error_page(words: str, status: int) -> Page:
    """The page that says why there is no other."""
    return Page("error.html", {"error": words, "title": _ERROR_TITLES.get(status, "That is not possible")}, status)


async def page_response(page: Page, request: Any, datasette: Any, headers: dict[str, str]) -> Response:
    """The answer that is a page."""
    html = await datasette.render_template(f"esicatalog/{page.template}", page.context, request=request)
    return Response(html, page.status, headers, "text/html; charset=utf-8")


async def refusal(error: EsiCatalogError, request: Any, datasette: Any) -> Response:
    """Why there is no file: a page for people, who follow a link to it, JSON for programs."""
    headers = {"Vary": "Accept"}
    if "text/html" in request.headers.get("accept", ""):
        return await page_response(error_page(str(error), status_of(error)), request, datasette, headers)
    return _json({"error": str(error)}, status_of(error), headers)


async def unknown_address(request: Any, datasette: Any) -> Response:
    """404 for what no route answers: JSON where JSON is asked for, else a page."""
    words = f"there is no {BASE}{request.path.partition(BASE)[2]}"
    if not request.path.endswith(".json"):
        return await page_response(error_page(words, 404), request, datasette, {})
    headers = _cors_headers(datasette)
    return _json({"error": f"{words}; what there is: {BASE}openapi.json"}, 404, headers)


def texts_of(request: Any) -> dict[str, list[str]]:
    """The parameters of an address, as they were sent.

    Raises :class:`InputError` for a name alone: forms send ``name=`` for what is not asked, ``?needs-dc`` asks.
    """
    alone = [part for part in request.query_string.split("&") if part and "=" not in part]
    if alone:
        name = unquote_plus(alone[0])[:_SHOWN]
        raise InputError(f"{name} has no value; write {name}=1 for a flag, else {name}=VALUE")
    return {name: request.args.getlist(name) for name in request.args}


def status_of(error: EsiCatalogError) -> int:
    """404 for what is not there, 400 for what cannot be done."""
    return 404 if isinstance(error, NotFound) else 400


def _validators(catalog: Catalog, kind: str = "") -> dict[str, str]:
    """What an answer depends on: what the catalog holds, the version that answers, and what it is of several.

    While an ingest is under way nothing says what the catalog holds: answers are not to be kept then.
    """
    held = (catalog.content_hash(), catalog.state_hash())
    if None in held:
        return {"Cache-Control": "no-store"}
    return {"ETag": f'"{__version__}-{held[0]}-{held[1]}{kind}"', "Cache-Control": "no-cache"}


def _is_confirmed(request: Any, headers: dict[str, str]) -> bool:
    """Whether the client has the answer already that has these validators.

    It names one or several, weak where a proxy has compressed the answer: they are compared as RFC 9110, 13.1.2 says.
    """
    held = request.headers.get("if-none-match", "").split(",")
    return "ETag" in headers and headers["ETag"] in [tag.strip().removeprefix("W/") for tag in held]


def _json(value: Any, status: int, headers: dict[str, str]) -> Response:
    body = json_bytes(value)
    return Response(body, status, {**headers, "Content-Length": str(len(body))}, "application/json; charset=utf-8")


async def body_of(request: Any) -> bytes:
    """The body of a request.

    Raises :class:`HttpError`: 413 when it is larger than any scan, 408 when it does not end in time.
    """
    try:
        async with asyncio.timeout(MAX_BODY_SECONDS):
            return await _received(request)
    except TimeoutError as error:
        raise HttpError(408, f"the body did not end within {MAX_BODY_SECONDS:.0f} s") from error


async def _received(request: Any) -> bytes:
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
