"""What this process does with itself: limits while it reads documents, no search for cycles, interrupts that wait."""

import contextlib
import gc
import signal
import threading
from collections.abc import Callable, Iterator

from esicatalog.errors import UnreadableDocument

MEMORY_LIMIT_BYTES = 3 * 1024**3
DEADLINE_SECONDS = 120.0
"""Longest time a document may take; the largest real one takes a few seconds."""


def limit_memory() -> Callable[[], None]:
    """Let this process have no more memory than a document may take; returns what undoes that."""
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        limit = min(limit for limit in (MEMORY_LIMIT_BYTES, soft, hard) if limit != resource.RLIM_INFINITY)
        resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
        return lambda: resource.setrlimit(resource.RLIMIT_AS, (soft, hard))
    return lambda: None


@contextlib.contextmanager
def limited() -> Iterator[None]:
    """A document that this process itself reads takes no more memory and time than in a helper.

    Raises :class:`MemoryError` and :class:`UnreadableDocument` beyond.
    """
    undo = limit_memory()
    try:
        with limited_time():
            yield
    finally:
        undo()


class _TimeIsUp(BaseException):
    """Not to be taken for what is wrong with a document, or with one that it refers to."""


@contextlib.contextmanager
def limited_time() -> Iterator[None]:
    """Raise :class:`UnreadableDocument` when this takes longer than a document may.

    The main thread alone can be interrupted, between two steps of Python: what libxml2 does is bounded by its limits.
    Where somebody else has set the system's alarm it stays theirs.
    """
    if not _has_free_alarm():
        yield
        return
    is_over = False

    def end(number: int, frame: object) -> None:
        if not is_over:
            raise _TimeIsUp

    before = signal.signal(signal.SIGALRM, end)
    # Again and again: what is raised while Python ends an object, which may be at any moment, is lost.
    signal.setitimer(signal.ITIMER_REAL, DEADLINE_SECONDS, DEADLINE_SECONDS)
    try:
        try:
            yield
        finally:
            is_over = True
    except _TimeIsUp:
        raise UnreadableDocument(gave_up(DEADLINE_SECONDS)) from None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def gave_up(seconds: float) -> str:
    """What to say of a document that took longer."""
    return f"gave up after {seconds:.0f} s"


def _has_free_alarm() -> bool:
    return (
        hasattr(signal, "setitimer")  # not on Windows
        and threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGALRM) is not None
        and not any(signal.getitimer(signal.ITIMER_REAL))
    )


@contextlib.contextmanager
def without_cycle_search() -> Iterator[None]:
    """What is loaded and what rows hold has no cycles worth looking for, which takes a sixth of a writer's time."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


@contextlib.contextmanager
def interrupts_wait() -> Iterator[None]:
    """Ctrl-C, and SIGTERM where it is handled, raise their exception at the end of this.

    Loading modules runs callbacks, in which an exception is reported and lost, and leaves half a module behind.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    handlers = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    handlers = {number: handler for number, handler in handlers.items() if callable(handler)}
    for number in handlers:
        signal.signal(number, lambda number, frame: came.append(number))
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
    for interrupt in came:
        signal.raise_signal(interrupt)
