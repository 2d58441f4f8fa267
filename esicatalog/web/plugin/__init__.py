"""Hooks of the Datasette plugin. It is a package so that Datasette finds its static files."""

import sqlite3
from collections.abc import Awaitable, Callable
from typing import Any

from datasette import handle_exception, hookimpl

from esicatalog.catalog.full_text import search_expression
from esicatalog.catalog.views import FULL_TEXT
from esicatalog.web.bidi import isolated
from esicatalog.web.cells import cell, stored_filters
from esicatalog.web.descriptions import complete_links
from esicatalog.web.functions import add_functions, bound_work
from esicatalog.web.links import BASE
from esicatalog.web.routes import ROUTES
from esicatalog.web.state import MOUNTED_AS
from esicatalog.words import counted


@hookimpl
def startup(datasette: Any) -> Callable[[], Awaitable[None]]:
    """Keep errors off the console, where rich is installed, and have descriptions lead to the pages from everywhere.

    Datasette has rich print what it answers, and rich fails at an error that was never raised: a 404 became a 500.
    """
    handle_exception.rich = None
    return lambda: complete_links(datasette)


@hookimpl(trylast=True)
def prepare_connection(conn: sqlite3.Connection) -> None:
    """SQL functions for numbers and parameters.

    In catalogs, Datasette's search reads words as ``esicatalog devices`` does, and what one function can do is bounded.
    """
    add_functions(conn)
    if conn.execute("SELECT 1 FROM sqlite_master WHERE name = ?", (FULL_TEXT,)).fetchone():
        # trylast: Datasette has registered its own function of this name before.
        conn.create_function("escape_fts", 1, search_expression, deterministic=True)
        bound_work(conn)


@hookimpl
def prepare_jinja2_environment(env: Any) -> None:
    """The filters ``isolated`` for sentences with names of documents, ``counted`` for numbers of things."""
    env.filters["counted"] = counted
    env.filters["isolated"] = isolated


@hookimpl
def extra_css_urls(database: str | None, datasette: Any) -> Callable[[], Awaitable[list[str]]]:
    """Keep the long lists of column descriptions small on the pages of catalogs."""

    async def urls() -> list[str]:
        if database is None or FULL_TEXT not in await datasette.get_database(database).table_names():
            return []
        return [datasette.urls.static_plugins("esicatalog", "catalog.css")]

    return urls


@hookimpl
def register_routes() -> list[tuple[str, Any]]:
    """The JSON routes below /-/esi/."""
    return ROUTES


@hookimpl
def skip_csrf(scope: dict[str, Any]) -> bool:
    """POST to the routes below /-/esi/ changes nothing and needs no token."""
    return BASE in str(scope.get("path", ""))


@hookimpl
def render_cell(row: Any, value: Any, column: str, table: str | None, database: str, datasette: Any) -> Any:
    """Hex, images and links to device pages in the tables of the catalog."""
    if database != MOUNTED_AS:
        return None
    return cell(row, value, column, table, datasette.setting("base_url"))


@hookimpl
def asgi_wrapper(datasette: Any) -> Callable[[Any], Any]:
    """Filters of table pages take numbers in any notation: ``?product_code=0x044c2c52`` means the decimal number."""

    def wrap(application: Any) -> Any:
        async def wrapped(scope: dict[str, Any], receive: Any, send: Any) -> None:
            if scope["type"] == "http" and str(scope.get("path", "")).startswith(_table_prefix(datasette)):
                query = stored_filters(scope.get("query_string", b"").decode("latin-1"))
                if query is not None:
                    scope = {**scope, "query_string": query.encode("latin-1")}
            await application(scope, receive, send)

        return wrapped

    return wrap


def _table_prefix(datasette: Any) -> str:
    return f"{datasette.setting('base_url')}{MOUNTED_AS}/"


@hookimpl
def menu_links(datasette: Any) -> list[dict[str, str]]:
    """The way from the tables to the pages."""
    return [{"href": datasette.urls.path(BASE), "label": "Devices"}]


@hookimpl(optionalhook=True)
def register_mcp_tools(datasette: Any, mcp: Any) -> None:
    """Tools for assistants; datasette-mcp calls it where it is installed."""
    from esicatalog.web.mcp_tools import register_tools

    register_tools(datasette, mcp)
