"""Pictures of devices by their key: bytes for browsers, hex text for records."""

from collections.abc import Iterable
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.mapping import image_key
from esicatalog.catalog.query import Query, rows_of
from esicatalog.catalog.schema import images

_BATCH_ROWS = 100


def picture_of(connection: sa.Connection, sha256: str) -> bytes | None:
    """The bytes of a picture; None when it is not stored or malformed."""
    found: bytes | None = connection.execute(sa.select(images.c.data).where(images.c.sha256 == sha256)).scalar()
    return found


def picture_texts(query: Query, keys: Iterable[str]) -> dict[str, str]:
    """Pictures as documents write them, by key: upper-case hex, the document's own text where that is malformed."""
    found: dict[str, str] = {}
    for part in chunks(sorted(keys)):
        for key, data, malformed in rows_of(query, "sha256, data, malformed", images.name, "sha256", part):
            found[key] = _text(data, malformed)
    return found


def damaged_pictures(connection: sa.Connection) -> int:
    """How many pictures are not what their key says; SQLite cannot compute it."""
    query = sa.select(images.c.sha256, images.c.data, images.c.malformed).execution_options(yield_per=_BATCH_ROWS)
    return sum(image_key(_text(data, malformed)) != key for key, data, malformed in connection.execute(query))


def _text(data: bytes | None, malformed: Any) -> Any:
    return malformed if data is None else bytes(data).hex().upper()
