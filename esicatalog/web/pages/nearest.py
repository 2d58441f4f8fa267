"""What is said of an identity that is not described: the answer of identify, on pages with links."""

from collections.abc import Callable
from typing import Any

from esicatalog.api import Catalog
from esicatalog.catalog.results import FoundDevice, Identification
from esicatalog.errors import NotFound
from esicatalog.identity import Identity


def _is_no_question_of_identify(identity: Identity, answer: Identification) -> bool:
    """Whether the product is described, yet not in this variant or not without revision: identify knows of neither."""
    return answer.device is not None and (identity.variant is not None or identity.without_revision)


def nearest_json(catalog: Catalog, identity: Identity, error: NotFound) -> dict[str, Any]:
    """The answer of identify; where it could not be asked for that, the error beside the descriptions that there are.

    What it says of how well they match would then be to another question.
    """
    answer = catalog.identify(*identity[:3])
    said = answer.as_json()
    if not _is_no_question_of_identify(identity, answer):
        return said
    return {"error": str(error), **{name: said[name] for name in ("device", "variants", "candidates")}}


def nearest(
    catalog: Catalog, identity: Identity, error: NotFound, path: Callable[[FoundDevice], str]
) -> dict[str, Any]:
    """Why there is no description, and the nearest ones with the paths that lead on to them.

    The error says it all where identify could not be asked for that.
    """
    answer = catalog.identify(*identity[:3])
    found = answer.found
    others = "Other revisions" if found is not None else "Products of this vendor with the nearest codes"
    return {
        "problem": str(error),
        "reason": "" if _is_no_question_of_identify(identity, answer) else answer.reason,
        "devices": [
            (title, [(path(device), device) for device in devices])
            for title, devices in (("Nearest", () if found is None else (found,)), (others, answer.candidates))
        ],
    }
