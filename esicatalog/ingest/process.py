"""Processes that work for this one: how they are started, asked and ended.

Where this process is one that may be copied, a helper is forked, so that nothing is imported twice; else, and in place
of one that died, it is a new interpreter.
"""

import contextlib
import gc
import os
import select
import signal
import struct
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import IO, NoReturn, Protocol

from esicatalog.ingest.this_process import limit_memory

_THREADS = Path("/proc/self/task")
_DESCRIPTORS = Path("/proc/self/fd")
_PIPE_BYTES = 1024 * 1024
_LENGTH = struct.Struct("<Q")

Serve = Callable[[IO[bytes], IO[bytes]], None]
"""What a helper does: read requests and write answers until there are no more requests."""


def read_frame(read: Callable[[int], bytes]) -> bytes | None:
    """One length-prefixed message, or None at the end of the stream."""
    head = _read_exactly(read, _LENGTH.size)
    if head is None:
        return None
    return _read_exactly(read, _LENGTH.unpack(head)[0])


def _read_exactly(read: Callable[[int], bytes], size: int) -> bytes | None:
    parts = []
    while size:
        part = read(min(size, 1 << 20))
        if not part:
            return None
        parts.append(part)
        size -= len(part)
    return b"".join(parts)


def write_frame(stream: IO[bytes], message: bytes) -> None:
    """Send one length-prefixed message."""
    stream.write(_LENGTH.pack(len(message)))
    stream.write(message)
    stream.flush()


def settle_in() -> None:
    """Make this process a helper: it is bounded in memory and outlives Ctrl-C.

    Ctrl-C goes to all processes of a terminal; who started a helper ends it.
    """
    limit_memory()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # Records and rows hold no cycles: looking for some again and again costs more than reading many a document. Who
    # lives long looks now and then, though the process that it is a copy of may not.
    gc.set_threshold(1_000_000, 20, 100)
    gc.enable()


class _Process(Protocol):
    """What is needed of a process; :class:`subprocess.Popen` has it."""

    def kill(self) -> None: ...

    def wait(self) -> int | None: ...

    def poll(self) -> int | None: ...


class Helper:
    """A process that answers requests in their order."""

    def __init__(self, process: _Process, requests: IO[bytes], answers: IO[bytes]) -> None:
        self._process = process
        self._requests = requests
        self._answers = answers
        _widen(answers)

    def send(self, request: bytes) -> None:
        """Send a request, be there anybody to read it or not."""
        with contextlib.suppress(BrokenPipeError, ConnectionError):
            write_frame(self._requests, request)

    def receive(self, seconds: float) -> bytes | None:
        """Wait for the next answer, None when the process died.

        Raises :class:`TimeoutError` when there is no answer after so many seconds.
        """
        deadline = time.monotonic() + seconds

        def read(size: int) -> bytes:
            ready, _, _ = select.select([self._answers], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                raise TimeoutError
            return self._answers.read(size) or b""

        with contextlib.suppress(ConnectionError):
            return read_frame(read)
        return None

    @property
    def is_alive(self) -> bool:
        """Whether it can be asked again."""
        return self._process.poll() is None

    def kill(self) -> None:
        """End it, whatever it is doing; any thread may ask for that."""
        self._process.kill()

    def end(self) -> None:
        """End it and free what it took."""
        self._process.kill()
        self._process.wait()
        self._requests.close()
        self._answers.close()


def _widen(answers: IO[bytes]) -> None:
    """Let most answers fit into the pipe: who wrote one goes on before it is read."""
    with contextlib.suppress(ImportError, AttributeError, OSError):
        import fcntl

        fcntl.fcntl(answers, fcntl.F_SETPIPE_SZ, _PIPE_BYTES)


def can_fork() -> bool:
    """Whether a copy of this process can be a helper: no thread but this one, no database library, no catalog open.

    A thread might hold a lock for ever in the copy. Systems without ``/proc`` cannot tell, or do not fork safely.
    """
    try:
        return "sqlalchemy" not in sys.modules and len(list(_THREADS.iterdir())) == 1
    except OSError:
        return False


def forked(serve: Serve) -> Helper | None:
    """A helper that begins as a copy of this process (see :func:`can_fork`).

    None where the system has no room for another process, or for its pipes.
    """
    ends: list[int] = []
    # Until the copy has become a helper no signal may make it do what this process would do.
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals())
    try:
        try:
            ends += os.pipe()
            ends += os.pipe()
            number = os.fork()
        except OSError:
            for end in ends:
                os.close(end)
            return None
        for_requests, requests, answers, for_answers = ends
        if number == 0:
            _help(serve, for_requests, for_answers, blocked)
        os.close(for_requests)
        os.close(for_answers)
        return Helper(_Forked(number), os.fdopen(requests, "wb", 0), os.fdopen(answers, "rb", 0))
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, blocked)


def interpreter(module: str) -> Helper:
    """A helper in a new interpreter: a module that serves on stdin and stdout."""
    process = subprocess.Popen(
        [sys.executable, "-m", module],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        bufsize=0,
    )
    assert process.stdin is not None
    assert process.stdout is not None
    return Helper(process, process.stdin, process.stdout)


class _Forked:
    """A forked process; its number is its own until it was waited for, which one thread does at a time."""

    def __init__(self, number: int) -> None:
        self._number = number
        self._status: int | None = None
        self._lock = threading.Lock()

    def kill(self) -> None:
        with self._lock:
            if self._status is None:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(self._number, signal.SIGKILL)

    def wait(self) -> int | None:
        return self._ask_for_status(0)

    def poll(self) -> int | None:
        return self._ask_for_status(os.WNOHANG)

    def _ask_for_status(self, options: int) -> int | None:
        with self._lock:
            if self._status is None:
                try:
                    number, status = os.waitpid(self._number, options)
                except ChildProcessError:  # Where SIGCHLD is ignored the system itself waits for it.
                    number, status = self._number, 0
                if number:
                    self._status = status
            return self._status


def _help(serve: Serve, requests: int, answers: int, mask: Iterable[int]) -> NoReturn:
    """What the copy does instead of going on; nothing of what this process would do at its end happens in it."""
    try:
        for number in signal.valid_signals():
            if callable(signal.getsignal(number)):
                signal.signal(number, signal.SIG_DFL)
        signal.set_wakeup_fd(-1)
        _leave_all_but(requests, answers)
        settle_in()
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        # Searching what was inherited for cycles would copy every page of it.
        gc.freeze()
        serve(os.fdopen(requests, "rb"), os.fdopen(answers, "wb"))
    finally:
        os._exit(0)


def _leave_all_but(*kept: int) -> None:
    """Close what was inherited, which this copy would else hold open: locks, sockets, pipes of other workers."""
    nothing = os.open(os.devnull, os.O_RDWR)
    for standard in {0, 1, 2}.difference(kept):
        os.dup2(nothing, standard)
    for descriptor in [int(path.name) for path in _DESCRIPTORS.iterdir()]:
        if descriptor not in (0, 1, 2, *kept):
            with contextlib.suppress(OSError):  # that of the list itself
                os.close(descriptor)
