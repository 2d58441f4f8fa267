"""Dump a small catalog of this schema version for the upgrade tests: ``make dump``.

It has to be made by the code of the version that was released, before anything of the schema changes.
"""

import sqlite3
import sys
import tempfile
from contextlib import closing
from pathlib import Path

from esicatalog import Catalog
from esicatalog.catalog.schema import SCHEMA_VERSION
from esicatalog.catalog.views import FULL_TEXT, views

ROOT = Path(__file__).parent.parent
EXAMPLES = ("io_terminal_8di_8do.xml", "two_axis_modular_drive.xml")
"""The documents of ``data/`` that each dump holds."""


def main() -> None:
    """Write tests/catalogs/NNNN.sql unless it is there."""
    path = ROOT / "tests" / "catalogs" / f"{SCHEMA_VERSION}.sql"
    if path.exists():
        print(f"{path.relative_to(ROOT)} is there, and a catalog that was released does not change")
        return
    path.write_text(dump(), encoding="utf-8")
    print(f"wrote {path.relative_to(ROOT)}")


def dump() -> str:
    """SQL of a catalog of the examples without what every migration makes anew, and without the place of this folder."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "catalog.db"
        with Catalog.open(file, create=True) as catalog:
            catalog.ingest([ROOT / "data" / name for name in EXAMPLES], jobs=1)
        with closing(sqlite3.connect(file)) as connection:
            for view in views("sqlite"):
                connection.execute(f"DROP VIEW {view.name}")
            connection.execute(f"DROP TABLE {FULL_TEXT}")
            connection.execute("UPDATE sources SET location = member")
            return "".join(f"{line}\n" for line in connection.iterdump())


if __name__ == "__main__":
    sys.exit(main())
