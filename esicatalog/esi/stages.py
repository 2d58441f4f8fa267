"""Where the time goes: processor time by stage of the way from documents to rows."""

import time
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager

STAGES = {
    "read": "unpacking and hashing documents",
    "parse": "recognising what repeats, XML to elements",
    "extract": "elements to records",
    "lint": "the rules",
    "rows": "resolving objects, deriving, records to rows",
    "transfer": "rows from process to process",
    "write": "rows into the database",
    "order": "variants, vendors, search",
    "index": "indexes, references, content hash",
}
"""Stages in the order of the way, and what happens in them."""


class Stages:
    """Measures one thread; what happens in a stage within a stage counts for the inner one."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        """Processor time by stage."""
        self._inner = [0.0]

    @contextmanager
    def __call__(self, stage: str) -> Iterator[None]:
        """Around what belongs to a stage."""
        started = time.thread_time()
        self._inner.append(0.0)
        try:
            yield
        finally:
            spent = time.thread_time() - started
            self.seconds[stage] += spent - self._inner.pop()
            self._inner[-1] += spent

    def take(self) -> dict[str, float]:
        """What was measured since the last call."""
        taken = dict(self.seconds)
        self.seconds.clear()
        return taken

    def add(self, seconds: dict[str, float]) -> None:
        """Add what was measured elsewhere."""
        for stage, spent in seconds.items():
            self.seconds[stage] += spent
