"""What is answered where."""

from typing import Any

from esicatalog.api import Catalog
from esicatalog.web.http import json_route
from esicatalog.web.identify import identify_many, identify_one
from esicatalog.web.openapi import openapi_document


async def _openapi(request: Any, catalog: Catalog) -> tuple[Any, int]:
    base = request.path.partition("/-/esi/")[0]
    return openapi_document(base or "/"), 200


ROUTES: list[tuple[str, Any]] = [
    (r"^/-/esi/identify\.json$", json_route({"GET": identify_one, "POST": identify_many})),
    (r"^/-/esi/openapi\.json$", json_route({"GET": _openapi})),
]
"""Regular expressions of paths, and Datasette views."""
