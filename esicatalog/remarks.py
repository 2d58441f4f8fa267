"""Results with what is remarked about them: how functions with both are written.

Such a function is a generator: it yields each remark, a sentence for the reader, where it finds it, and returns its
result. One asks another with ``result = yield from other(...)``, or several with :func:`in_turn`, and so passes on
their remarks in the order in which they are found; at the edge :func:`remarked` parts result and remarks. So a type
says that a function has remarks, and no list of them is handed around.

What gives remarks alone is a plain ``Iterator[str]``, which is passed on in the same way. An object that changes step
by step keeps its own list: a step must not wait for somebody who asks what is remarked about it. And what runs for
every object of a dictionary returns :data:`Remarked` at once where nothing is odd: a generator takes a microsecond.
"""

from collections.abc import Generator, Iterable
from typing import TypeVar

Result = TypeVar("Result")

Remarking = Generator[str, None, Result]
"""A function at work that yields remarks and returns its result."""
Remarked = tuple[Result, tuple[str, ...]]
"""A result and what is remarked about it, in order."""


def remarked(work: Remarking[Result]) -> Remarked[Result]:
    """Do the work: its result, and its remarks apart from it."""
    remarks = []
    try:
        while True:
            remarks.append(next(work))
    except StopIteration as end:
        return end.value, tuple(remarks)


def in_turn(works: Iterable[Remarking[Result]]) -> Remarking[list[Result]]:
    """Do several works one after the other: the list of their results."""
    results = []
    for work in works:
        results.append((yield from work))
    return results
