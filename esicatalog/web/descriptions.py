"""The description of the catalog's database, which a metadata file gives without knowing where Datasette is mounted."""

from typing import Any

from esicatalog.web.links import BASE
from esicatalog.web.state import MOUNTED_AS

_DESCRIPTION = "description_html"


async def complete_links(datasette: Any) -> None:
    """Make the links to the pages, relative to the address of the database, lead there from the addresses below it.

    Datasette 1.0 shows the description at ``/catalog/-/query`` too; 0.65 at the address of the database only.
    """
    if not hasattr(datasette, "set_database_metadata"):
        return
    written = (await datasette.get_database_metadata(MOUNTED_AS)).get(_DESCRIPTION)
    if written is not None:
        linked = written.replace(f'href="{BASE.removeprefix("/")}', f'href="{datasette.urls.path(BASE)}')
        await datasette.set_database_metadata(MOUNTED_AS, _DESCRIPTION, linked)
