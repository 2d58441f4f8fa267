"""Results that depend on records alone, computed once for each.

The reader gives the same record for the same words, so identity tells what was seen before.
"""

from collections.abc import Callable, Hashable, Iterable
from typing import Any, Generic, TypeVar

Result = TypeVar("Result")


class IdentityMemo(Generic[Result]):
    """Results by the identity of records, which are held so that their identities stay valid; starts anew when full."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._known: dict[Hashable, tuple[Any, Result]] = {}

    def get(self, key: Hashable, records: Any, compute: Callable[..., Result], *arguments: Any) -> Result:
        """The result for a key made of identities of ``records``."""
        known = self._known.get(key)
        if known is None:
            known = (records, compute(*arguments))
            if len(self._known) >= self._limit:
                self._known.clear()
            self._known[key] = known
        return known[1]


def identities(records: Iterable[Any]) -> tuple[int, ...]:
    """What tells records apart."""
    return tuple(map(id, records))
