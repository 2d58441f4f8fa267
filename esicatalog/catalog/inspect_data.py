"""Row counts of an immutable SQLite file beside it, in the form of ``datasette inspect``: nobody counts them again."""

import hashlib
import json
import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

from esicatalog.catalog.own_files import INSPECT_SUFFIX
from esicatalog.errors import CatalogError


def inspect_path(file: Path) -> Path:
    """Where the counts of a file lie."""
    return file.with_name(file.name + INSPECT_SUFFIX)


def inspect_data(file: Path) -> dict[str, Any]:
    """What ``datasette inspect`` says of a file, wherever that lies."""
    with closing(sqlite3.connect(file)) as connection:
        tables = [row[0] for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
        counts = {table: connection.execute(f'SELECT count(*) FROM "{table}"').fetchone()[0] for table in tables}
    return {
        file.stem: {
            "hash": _sha256(file),
            "size": file.stat().st_size,
            "file": file.name,
            "tables": {table: {"count": count} for table, count in counts.items()},
        }
    }


def read_inspect_data(file: Path) -> dict[str, Any] | None:
    """The counts beside a file, None without any. Raises :class:`CatalogError` when they are not of this file."""
    path = inspect_path(file)
    try:
        (found,) = json.loads(path.read_text(encoding="utf-8")).values()
        if found["size"] == file.stat().st_size and found["hash"] == _sha256(file):
            return {"hash": found["hash"], "size": found["size"], "tables": dict(found["tables"])}
    except FileNotFoundError:
        return None
    except (OSError, ValueError, TypeError, KeyError, AttributeError) as error:
        raise CatalogError(f"{path}: no counts as datasette inspect writes them; delete it") from error
    raise CatalogError(f"{path}: does not describe {file.name} as it is; delete it or make the snapshot again")


def _sha256(file: Path) -> str:
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
