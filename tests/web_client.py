"""Clients of the pages of a catalog, without a socket.

Applications are kept for all tests: Datasette never gives back the threads and the memory of one.
"""

from pathlib import Path
from typing import Any

from esicatalog.web.app import datasette_app

_KEPT: dict[Path, Any] = {}


async def client(db: Path) -> Any:
    """A client of the catalog in a file; to be used in the loop that all tests have in common."""
    if db not in _KEPT:
        _KEPT[db] = await new_client(db)
    return _KEPT[db]


async def new_client(db: Path, **options: Any) -> Any:
    """A client of an application of its own, with attributes of Datasette set."""
    application = datasette_app(db)
    for name, value in options.items():
        setattr(application, name, value)
    await application.invoke_startup()
    # As a server has it; the client of Datasette 1.0 would make one for every request.
    served = application.app()
    application.app = lambda: served
    return application.client
