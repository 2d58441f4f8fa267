"""esicatalog: the catalog of EtherCAT devices, made from the vendors' ESI files."""

import importlib
from typing import TYPE_CHECKING, Any

from esicatalog.version import __version__

if TYPE_CHECKING:
    from esicatalog.api import Catalog
    from esicatalog.catalog.description import DeviceDescription
    from esicatalog.catalog.results import FoundDevice, Identification
    from esicatalog.errors import (
        BrokenDocument,
        CatalogError,
        DocumentError,
        EsiCatalogError,
        InputError,
        NotAnEsiDocument,
        NotFound,
    )
    from esicatalog.esi.reader import ReadDocument, read_esi
    from esicatalog.identity import Identity, parse_identity
    from esicatalog.sii.files import read_sii
    from esicatalog.sii.image import SiiImage

_WHERE = {
    "esicatalog.api": ("Catalog",),
    "esicatalog.catalog.description": ("DeviceDescription",),
    "esicatalog.catalog.results": ("FoundDevice", "Identification"),
    "esicatalog.errors": (
        "BrokenDocument",
        "CatalogError",
        "DocumentError",
        "EsiCatalogError",
        "InputError",
        "NotAnEsiDocument",
        "NotFound",
    ),
    "esicatalog.esi.reader": ("ReadDocument", "read_esi"),
    "esicatalog.identity": ("Identity", "parse_identity"),
    "esicatalog.sii.files": ("read_sii",),
    "esicatalog.sii.image": ("SiiImage",),
}
_MODULE_OF = {name: module for module, names in _WHERE.items() for name in names}

__all__ = [
    "BrokenDocument",
    "Catalog",
    "CatalogError",
    "DeviceDescription",
    "DocumentError",
    "EsiCatalogError",
    "FoundDevice",
    "Identification",
    "Identity",
    "InputError",
    "NotAnEsiDocument",
    "NotFound",
    "ReadDocument",
    "SiiImage",
    "__version__",
    "parse_identity",
    "read_esi",
    "read_sii",
]


def __getattr__(name: str) -> Any:
    """Load the public names on first use: the command line must not pay for what it does not need."""
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(_MODULE_OF[name]), name)
