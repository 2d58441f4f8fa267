"""Row numbers of what is stored once per distinct content."""

from collections.abc import Sequence

import sqlalchemy as sa

from esicatalog.catalog.bulk import chunks
from esicatalog.errors import CatalogError


class KeyMap:
    """Row numbers by content digest or other key: those met in this run, and on demand those of the database."""

    def __init__(self, connection: sa.Connection, table: sa.Table, key: str = "content_hash") -> None:
        self._connection = connection
        self._table = table
        self._key = table.c[key]
        self._known: dict[bytes | str, int] = {}
        self._empty = False

    def get(self, key: bytes | str) -> int | None:
        """Row number of a digest, None when it is not stored."""
        if key not in self._known:
            self.load([key])
        return self._known.get(key)

    def require(self, key: bytes | str) -> int:
        """Row number of a digest that must be there: its rows came earlier in this run.

        Raises :class:`CatalogError` when another ingest meanwhile dropped the documents that it came with.
        """
        number = self.get(key)
        if number is None:
            raise CatalogError(
                f"another ingest dropped documents that this one had just stored ({self._table.name}); repeat this one"
            )
        return number

    def require_all(self, keys: Sequence[bytes | str]) -> list[int]:
        """:meth:`require` of many."""
        self.load(keys)
        known = self._known
        return [known[key] if key in known else self.require(key) for key in keys]

    def load(self, keys: Sequence[bytes | str]) -> None:
        """Look up many digests at once."""
        if self._empty:
            return
        missing = [key for key in keys if key not in self._known]
        table = self._table.c
        for part in chunks(missing):
            query = sa.select(self._key, table.id).where(self._key.in_(part))
            self._known.update((key, number) for key, number in self._connection.execute(query))

    def take(self, key: bytes | str) -> int | None:
        """Row number of a key, which is about to be deleted."""
        number = self.get(key)
        self._known.pop(key, None)
        return number

    def put(self, key: bytes | str, number: int) -> None:
        """Remember the row number of a digest just queued."""
        self._known[key] = number

    def forget(self) -> None:
        """After rows were deleted or others wrote: nothing is known any more."""
        self._known.clear()
        self._empty = self._connection.execute(sa.select(self._table.c.id).limit(1)).first() is None
