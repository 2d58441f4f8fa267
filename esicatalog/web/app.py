"""The Datasette application of one catalog."""

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import yaml
from datasette.app import Datasette
from datasette.database import Database
from datasette.version import __version_info__ as datasette_version

from esicatalog.catalog.inspect_data import read_inspect_data
from esicatalog.resources import resource
from esicatalog.web.state import MOUNTED_AS

try:
    from yaml import CSafeLoader as SafeLoader
except ImportError:  # made without libyaml, which takes a tenth of the time
    from yaml import SafeLoader  # type: ignore[assignment]

SETTINGS = {
    "sql_time_limit_ms": 3000,
    "facet_time_limit_ms": 1000,
    # Trying every column takes seconds on wide views; the metadata names the facets that are useful.
    "suggest_facets": False,
    "default_page_size": 100,
    "max_returned_rows": 5000,
    "truncate_cells_html": 200,
}


_STORE_COLUMN = """
INSERT OR REPLACE INTO metadata_columns (database_name, resource_name, column_name, key, value)
VALUES (?, ?, ?, 'description', ?)
"""


class _Application(Datasette):  # type: ignore[misc]
    """Stores the descriptions of columns all at once: Datasette 1.0 stores one by one, which takes a second."""

    column_descriptions: Iterable[tuple[str, str, str, str]] = ()
    """Database, table, column, description."""

    async def invoke_startup(self) -> None:
        await super().invoke_startup()
        await self.get_internal_database().execute_write_many(_STORE_COLUMN, self.column_descriptions)


def _take_columns(metadata: Any) -> list[tuple[str, str, str, str]]:
    """Take the descriptions of columns out of metadata."""
    return [
        (database, table, column, description)
        for database, described in metadata["databases"].items()
        for table, of_table in described.get("tables", {}).items()
        for column, description in of_table.pop("columns", {}).items()
    ]


def datasette_app(path: str | os.PathLike[str], immutable: bool = False) -> Any:
    """A Datasette with this one database, under the name ``catalog``, and the metadata of the package.

    ``immutable`` promises that nobody changes the file: row counts are kept, those of a snapshot are taken from the
    file beside it, and the file can be downloaded. Raises :class:`CatalogError` for counts of another file.
    """
    # A link may be switched to another file while this one is served.
    file = Path(path).resolve()
    counted: dict[str, Any] = {}
    if immutable:
        found = read_inspect_data(file)
        counted = {MOUNTED_AS: found} if found is not None else {}
    metadata = yaml.load(resource("datasette-metadata.yml").read_bytes(), SafeLoader)
    arguments: dict[str, Any] = {"metadata": metadata, "settings": SETTINGS, "inspect_data": counted}
    if datasette_version[0] == "0":
        datasette = Datasette([], **arguments)
    else:
        columns = _take_columns(metadata)
        # Datasette 1.0 takes canned queries from the configuration.
        datasette = _Application([], config=metadata, **arguments)
        datasette.column_descriptions = columns
    datasette.add_database(Database(datasette, path=str(file), is_mutable=not immutable), name=MOUNTED_AS)
    # Without files Datasette mounts an empty database in memory.
    datasette.remove_database("_memory")
    return datasette
