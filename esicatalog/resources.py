"""Files that the package needs at run time and that live beside it in a checkout: migrations, metadata."""

from pathlib import Path

_PACKAGE = Path(__file__).parent


def resource(name: str) -> Path:
    """Path of ``migrations`` or ``datasette-metadata.yml``: in the installed package, else in the checkout."""
    for place in (_PACKAGE / name, _PACKAGE.parent / name):
        if place.exists():
            return place
    raise FileNotFoundError(f"{name} is missing from this installation of esicatalog")
