"""The catalog behind a running Datasette, and who may see it."""

from pathlib import Path
from typing import Any

from datasette.utils.asgi import NotFound

from esicatalog.api import Catalog
from esicatalog.catalog.schema import metadata
from esicatalog.catalog.views import views
from esicatalog.errors import CatalogError

MOUNTED_AS = "catalog"
"""Name of the database in Datasette, whatever the file is called; the metadata is written for it."""
_ATTRIBUTE = "_esicatalog"
_VIEW, _VIEW_TABLE = "view-database", "view-table"
_TABLES = frozenset((*metadata.tables, *(view.name for view in views("sqlite"))))
"""What pages and JSON are made of; nothing tells which of it an answer does not touch."""


async def catalog_for(datasette: Any, actor: Any) -> Catalog:
    """The mounted catalog, for an actor who may view its database and all of its tables.

    Raises Datasette's Forbidden, and its NotFound when no catalog of this version is mounted.
    """
    if MOUNTED_AS not in datasette.databases:
        raise NotFound(f"no database is mounted as {MOUNTED_AS}")
    check = _check_permissions if hasattr(datasette, "allowed_resources") else _check_permissions_0
    await check(datasette, actor)
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


async def _check_permissions(datasette: Any, actor: Any) -> None:
    """By one query for all tables, which finds those that Datasette has listed: what it does not find is asked singly.

    Raises Forbidden.
    """
    from datasette.resources import DatabaseResource, TableResource

    await datasette.ensure_permission(action=_VIEW, resource=DatabaseResource(MOUNTED_AS), actor=actor)
    allowed = await datasette.allowed_resources(_VIEW_TABLE, actor, parent=MOUNTED_AS, limit=1000)
    for name in _TABLES.difference(resource.child for resource in allowed.resources):
        await datasette.ensure_permission(action=_VIEW_TABLE, resource=TableResource(MOUNTED_AS, name), actor=actor)


async def _check_permissions_0(datasette: Any, actor: Any) -> None:
    """Before Datasette 1.0 a table takes 3 ms: asked are those that the configuration restricts. Raises Forbidden."""
    of_database = [(_VIEW, MOUNTED_AS), "view-instance"]
    await datasette.ensure_permissions(actor, of_database)
    configured = datasette.metadata("tables", database=MOUNTED_AS) or {}
    for name in [name for name, table in configured.items() if "allow" in table]:
        await datasette.ensure_permissions(actor, [(_VIEW_TABLE, (MOUNTED_AS, name)), *of_database])
