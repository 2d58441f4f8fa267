"""Reading the documents of a plan. It needs no database: reading can begin while a new catalog is being made, hashing
what an existing one may hold while that is being opened.
"""

import os
from collections.abc import Callable, Iterator, Sequence, Set
from itertools import chain
from typing import Self

from esicatalog.errors import InputError
from esicatalog.ingest.plan import Plan
from esicatalog.ingest.tasks import Outcome
from esicatalog.ingest.unchanged import Hashes

_SMALL_BYTES = 1024 * 1024
"""A single document up to here is read without a worker process and its memory limit."""


class Reading:
    """The documents of a plan being read, in worker processes or (``jobs`` 1) in this one.

    Both :meth:`hash_ahead` and :meth:`start` begin something that ends with this context. Raises
    :class:`~esicatalog.errors.InputError` for a number of jobs that is none.
    """

    def __init__(self, jobs: int | None = None) -> None:
        if jobs is not None and (not isinstance(jobs, int) or jobs < 1):
            raise InputError(f"jobs {jobs!r}: give the number of worker processes, 1 for none")
        self._jobs = jobs or os.cpu_count() or 1
        self._stop: Callable[[], None] = lambda: None
        self._hashed: Callable[[], Hashes] = dict
        self.plan: Plan | None = None
        self.outcomes: Iterator[Outcome] = iter(())

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self._stop()

    def hash_ahead(self, paths: Sequence[str | os.PathLike[str]], own_files: Set[str]) -> None:
        """Begin to hash the files below the paths, ``own_files`` apart, where that can go on beside this process."""
        from esicatalog.ingest.ahead import HashingAhead

        hashing = HashingAhead(paths, own_files)
        self._hashed, self._stop = hashing.take, hashing.end

    def hashed(self) -> Hashes:
        """What was hashed ahead."""
        return self._hashed()

    def start(self, plan: Plan) -> Plan:
        """Let workers read the documents of a plan; returns the plan."""
        self.plan = plan
        self.outcomes = iter(plan.problems)
        if plan.tasks:
            # Loads the reader, which an ingest that finds nothing new does not need.
            from esicatalog.ingest.pool import Pool, read_here

            is_small = sum(item.size_bytes for item in plan.todo) <= _SMALL_BYTES
            if self._jobs == 1 or (len(plan.tasks) == 1 and is_small):
                self.outcomes = chain(plan.problems, read_here(plan.tasks))
            else:
                pool = Pool(plan.tasks, self._jobs)
                pool.start()
                self._stop = pool.stop
                self.outcomes = chain(plan.problems, pool.outcomes())
        return plan
