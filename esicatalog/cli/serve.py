"""esicatalog serve"""

import contextlib
import errno
import logging
import socket
import webbrowser
from pathlib import Path

import click

from esicatalog.cli.common import Command, IntegerRange, db_option, reporting_errors
from esicatalog.errors import CatalogError, InputError

_IDLE_SECONDS = 75
"""Longer than browsers and clients keep an idle connection: a request sent while it is being closed is lost."""
_URI_CHARACTERS = "?#%"


@click.command("serve", cls=Command)
@db_option
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen at; 0.0.0.0 = everywhere.")
@click.option("--port", default=8001, show_default=True, type=IntegerRange(0, 65535), help="Port; 0 = any free one.")
@click.option("--open", "open_browser", is_flag=True, help="Open the device pages in a browser.")
@click.option("--immutable", is_flag=True, help="Nobody changes the file meanwhile: faster, and it can be downloaded.")
@reporting_errors
def command(db: str, host: str, port: int, open_browser: bool, immutable: bool) -> None:
    """Browse the catalog in Datasette until Ctrl-C.

    Prints the address of the tables, /catalog whatever the file is called, and that of the device pages.
    """
    file = _catalog_file(db)
    with _listen(host, port) as listener:
        # Loading Datasette takes a second or two; what is refused is refused before.
        import uvicorn

        from esicatalog.web.app import datasette_app
        from esicatalog.web.links import BASE
        from esicatalog.web.state import MOUNTED_AS

        # datasette-mcp, where it is installed, tells of every session otherwise.
        logging.getLogger("mcp").setLevel(logging.WARNING)
        application = datasette_app(file, immutable).app()
        shown = f"[{host}]" if ":" in host else host
        server_url = f"http://{shown}:{listener.getsockname()[1]}"
        click.echo(f"{server_url}/{MOUNTED_AS}")
        click.echo(f"{server_url}{BASE}  devices: search, scan, compare")
        if open_browser:
            webbrowser.open(f"{server_url}{BASE}")
        config = uvicorn.Config(application, log_level="warning", lifespan="on", timeout_keep_alive=_IDLE_SECONDS)
        server = uvicorn.Server(config)
        with contextlib.suppress(KeyboardInterrupt):
            server.run(sockets=[listener])


def _catalog_file(target: str) -> Path:
    """The file of an SQLite catalog of the current version. Raises :class:`CatalogError`."""
    from esicatalog.api import Catalog
    from esicatalog.catalog.database import catalog_url, shown_target, sqlite_path

    path = sqlite_path(catalog_url(target))
    if path is None:
        raise CatalogError(
            f"{shown_target(target)}: the pages read SQLite files only; make one with: "
            "esicatalog snapshot --from URL --to FILE"
        )
    if any(character in str(path) for character in _URI_CHARACTERS):
        # Datasette puts the path into a URI as it stands.
        raise CatalogError(f"{path}: Datasette opens no file with one of {' '.join(_URI_CHARACTERS)} in its path")
    Catalog.open(path).close()
    return path


def _listen(host: str, port: int) -> socket.socket:
    if not host:  # sockets take it for every address
        raise InputError("the host is empty; 127.0.0.1 is this machine alone, 0.0.0.0 everywhere")
    try:
        listener = socket.create_server((host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET)
        # Connections inherit it; asyncio sets it only for sockets that name their protocol. Without it an answer in
        # several writes waits 40 ms for the client's acknowledgement.
        listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return listener
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            raise InputError(f"port {port} of {host} is in use; choose another with --port") from error
        raise InputError(f"cannot listen at {host}, port {port}: {error.strerror}") from error
