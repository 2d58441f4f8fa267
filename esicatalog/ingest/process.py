"""Worker processes: how they are started, asked and ended.

A worker is forked where this process is one that may be copied, so that nothing is imported twice; else, and in place
of one that died, it is a new interpreter.
"""

import gc
import os
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterable
from contextlib import suppress
from itertools import pairwise
from pathlib import Path
from typing import IO, NoReturn, Protocol

from esicatalog.ingest.worker import read_frame, serve, settle_in, write_frame

_TASKS = Path("/proc/self/task")


class _Process(Protocol):
    """What is needed of a process; :class:`subprocess.Popen` has it."""

    def kill(self) -> None: ...

    def wait(self) -> int | None: ...

    def poll(self) -> int | None: ...


class WorkerProcess:
    """A process that answers requests, one at a time."""

    def __init__(self, process: _Process, requests: IO[bytes], answers: IO[bytes]) -> None:
        self._process = process
        self._requests = requests
        self._answers = answers

    def ask(self, request: bytes, seconds: float) -> bytes | None:
        """Send a request and wait for its answer, None when the process died.

        Raises :class:`TimeoutError` when there is no answer after so many seconds.
        """
        deadline = time.monotonic() + seconds

        def read(size: int) -> bytes:
            ready, _, _ = select.select([self._answers], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                raise TimeoutError
            return self._answers.read(size) or b""

        try:
            write_frame(self._requests, request)
            return read_frame(read)
        except (BrokenPipeError, ConnectionError):
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


def can_fork() -> bool:
    """Whether a copy of this process can be a worker: no thread but this one, no database library, no catalog open.

    A thread might hold a lock for ever in the copy. Systems without ``/proc`` cannot tell, or do not fork safely.
    """
    try:
        return "sqlalchemy" not in sys.modules and len(list(_TASKS.iterdir())) == 1
    except OSError:
        return False


def forked_worker() -> WorkerProcess:
    """A worker that begins as a copy of this process (see :func:`can_fork`)."""
    for_requests, requests = os.pipe()
    answers, for_answers = os.pipe()
    # Until the copy is a worker no signal may make it do what this process would do.
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals())
    number = os.fork()
    if number == 0:
        _be_a_worker(for_requests, for_answers, blocked)
    signal.pthread_sigmask(signal.SIG_SETMASK, blocked)
    os.close(for_requests)
    os.close(for_answers)
    return WorkerProcess(_Forked(number), os.fdopen(requests, "wb", 0), os.fdopen(answers, "rb", 0))


def new_worker() -> WorkerProcess:
    """A worker in a new interpreter."""
    process = subprocess.Popen(
        [sys.executable, "-m", "esicatalog.ingest.worker"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        bufsize=0,
    )
    assert process.stdin is not None
    assert process.stdout is not None
    return WorkerProcess(process, process.stdin, process.stdout)


class _Forked:
    """A forked process; its number is its own until it was waited for, which one thread does at a time."""

    def __init__(self, number: int) -> None:
        self._number = number
        self._status: int | None = None
        self._lock = threading.Lock()

    def kill(self) -> None:
        with self._lock:
            if self._status is None:
                with suppress(ProcessLookupError):
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


def _be_a_worker(requests: int, answers: int, mask: Iterable[int]) -> NoReturn:
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
    spared = sorted({0, 1, 2, *kept, os.sysconf("SC_OPEN_MAX")})
    for below, above in pairwise(spared):
        os.closerange(below + 1, above)
