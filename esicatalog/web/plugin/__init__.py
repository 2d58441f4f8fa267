"""Hooks of the Datasette plugin. It is a package so that Datasette finds its static files."""

import sqlite3
from collections.abc import Awaitable, Callable
from typing import Any

from datasette import hookimpl

from esicatalog.catalog.full_text import search_expression
from esicatalog.catalog.views import FULL_TEXT
from esicatalog.web.functions import hex0x, parse_hex
from esicatalog.web.routes import ROUTES


@hookimpl(trylast=True)  # type: ignore[untyped-decorator]
def prepare_connection(conn: sqlite3.Connection) -> None:
    """SQL functions parse_hex and hex0x; in catalogs, Datasette's search reads words as ``esicatalog devices`` does."""
    conn.create_function("parse_hex", 1, parse_hex, deterministic=True)
    conn.create_function("hex0x", 1, hex0x, deterministic=True)
    conn.create_function("hex0x", 2, hex0x, deterministic=True)
    if conn.execute("SELECT 1 FROM sqlite_master WHERE name = ?", (FULL_TEXT,)).fetchone():
        # trylast: Datasette has registered its own function of this name before.
        conn.create_function("escape_fts", 1, search_expression, deterministic=True)


@hookimpl  # type: ignore[untyped-decorator]
def extra_css_urls(database: str | None, datasette: Any) -> Callable[[], Awaitable[list[str]]]:
    """Keep the long lists of column descriptions small on the pages of catalogs."""

    async def urls() -> list[str]:
        if database is None or FULL_TEXT not in await datasette.get_database(database).table_names():
            return []
        return [datasette.urls.static_plugins("esicatalog", "catalog.css")]

    return urls


@hookimpl  # type: ignore[untyped-decorator]
def register_routes() -> list[tuple[str, Any]]:
    """The JSON routes below /-/esi/."""
    return ROUTES


@hookimpl  # type: ignore[untyped-decorator]
def skip_csrf(scope: dict[str, Any]) -> bool:
    """POST to the routes below /-/esi/ changes nothing and needs no token."""
    return "/-/esi/" in str(scope.get("path", ""))
