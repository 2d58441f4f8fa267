"""What was found before of records that are met again: the reader gives the same record for the same words."""

from collections.abc import Callable, Hashable, Iterable
from typing import Any, Generic, TypeVar

Result = TypeVar("Result")
Key = TypeVar("Key", bound=Hashable)


class IdentityMemo(Generic[Result]):
    """Results by the identity of records, which are held so that their identities stay valid; starts anew when full.

    None is no result.
    """

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._known: dict[Hashable, Result] = {}
        self._held: list[Any] = []

    def get(self, key: Hashable, records: Any, compute: Callable[..., Result], *arguments: Any) -> Result:
        """The result for a key made of identities of ``records``."""
        known = self._known.get(key)
        if known is None:
            known = compute(*arguments)
            if len(self._held) >= self._limit:
                self._known.clear()
                self._held.clear()
            self._known[key] = known
            self._held.append(records)
        return known

    def of(self, record: Any, compute: Callable[[Any], Result]) -> Result:
        """The result for a single record."""
        known = self._known.get(id(record))
        return known if known is not None else self.get(id(record), record, compute, record)

    def of_all(self, records: Iterable[Any], compute: Callable[[Any], Result]) -> list[Result]:
        """:meth:`of` of each of many records."""
        known = self._known.get
        return [
            found if (found := known(id(record))) is not None else self.get(id(record), record, compute, record)
            for record in records
        ]

    def get_all(
        self, keys: Iterable[Key], records: Iterable[Any], compute: Callable[[Any, Key], Result]
    ) -> list[Result]:
        """:meth:`get` of many; what is computed depends on the record and its key alone."""
        known = self._known.get
        return [
            found if (found := known(key)) is not None else self.get(key, record, compute, record, key)
            for key, record in zip(keys, records, strict=True)
        ]


def identities(records: Iterable[Any]) -> tuple[int, ...]:
    """What tells records apart."""
    return tuple(map(id, records))
