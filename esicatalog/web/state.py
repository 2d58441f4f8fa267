"""The catalog behind a running Datasette, and who may see it."""

from pathlib import Path
from typing import Any

from datasette.utils.asgi import Forbidden, NotFound

from esicatalog.api import Catalog
from esicatalog.errors import CatalogError

MOUNTED_AS = "catalog"
"""Name of the database in Datasette, whatever the file is called; the metadata is written for it."""
_ATTRIBUTE = "_esicatalog"
_VIEW = "view-database"


async def catalog_for(datasette: Any, actor: Any) -> Catalog:
    """The mounted catalog, for an actor who may view its database.

    Raises Datasette's Forbidden, and its NotFound when no catalog of this version is mounted.
    """
    if MOUNTED_AS not in datasette.databases:
        raise NotFound(f"no database is mounted as {MOUNTED_AS}")
    if not await _may_view(datasette, actor):
        raise Forbidden(_VIEW)
    held: Catalog | None = getattr(datasette, _ATTRIBUTE, None)
    if held is None:
        held = _open(datasette.get_database(MOUNTED_AS).path)
        setattr(datasette, _ATTRIBUTE, held)
    return held


def _open(path: str | None) -> Catalog:
    try:
        return Catalog.open(Path(path or ""), read_only=True)
    except CatalogError as error:
        raise NotFound(str(error)) from error


async def _may_view(datasette: Any, actor: Any) -> bool:
    if hasattr(datasette, "allowed"):
        from datasette.resources import DatabaseResource

        return bool(await datasette.allowed(action=_VIEW, resource=DatabaseResource(MOUNTED_AS), actor=actor))
    visible, _ = await datasette.check_visibility(actor, permissions=[(_VIEW, MOUNTED_AS), "view-instance"])
    return bool(visible)
