"""Worker processes of our own: one task at a time each, a deadline per document, a dead worker costs one document."""

import select
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Iterator, Sequence

import msgspec

from esicatalog.ingest.tasks import Answer, Outcome, Task
from esicatalog.ingest.worker import DocumentWorker, read_frame, write_frame

DEADLINE_SECONDS = 120.0
"""Longest time a document may take; the largest real one takes a few seconds."""
_MAX_WAITING_BYTES = 64 * 1024 * 1024
"""Outcomes wait as bytes, ten times smaller than as rows: workers go on while the writer writes."""


class Workers:
    """Worker processes. They may be started before there is work: they load what they need meanwhile."""

    def __init__(self) -> None:
        self._idle: deque[subprocess.Popen[bytes]] = deque()
        self._running: set[subprocess.Popen[bytes]] = set()

    def start(self, count: int) -> None:
        """Start ``count`` processes that wait for tasks."""
        for _ in range(count):
            self._idle.append(self._launch())

    def take(self) -> subprocess.Popen[bytes]:
        """A process that waits for tasks."""
        try:
            return self._idle.popleft()
        except IndexError:
            return self._launch()

    def stop(self) -> None:
        """End all processes."""
        for process in list(self._running):
            self.end(process)

    def end(self, process: subprocess.Popen[bytes]) -> None:
        """End one process."""
        self._running.discard(process)
        process.kill()
        process.wait()
        for stream in (process.stdin, process.stdout):
            if stream is not None:
                stream.close()

    def _launch(self) -> subprocess.Popen[bytes]:
        process = subprocess.Popen(
            [sys.executable, "-m", "esicatalog.ingest.worker"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            bufsize=0,
        )
        self._running.add(process)
        return process


def run_tasks(
    tasks: Sequence[Task], jobs: int, workers: Workers | None = None, deadline_seconds: float = DEADLINE_SECONDS
) -> Iterator[Outcome]:
    """Outcomes of all tasks in the order in which they are ready; ``jobs`` 1 stays in this process."""
    if jobs <= 1 or len(tasks) <= 1:
        worker = DocumentWorker()
        for task in tasks:
            yield worker.handle(task)
        return
    yield from _Pool(tasks, min(jobs, len(tasks)), workers or Workers(), deadline_seconds).outcomes()


class _Pool:
    def __init__(self, tasks: Sequence[Task], jobs: int, workers: Workers, deadline_seconds: float) -> None:
        self._tasks = {_place(task): task for task in tasks}
        self._total = len(tasks)
        self._deadline_seconds = deadline_seconds
        self._changed = threading.Condition()
        self._outcomes: deque[bytes | BaseException] = deque()
        self._waiting_bytes = 0
        self._workers = workers
        self._stopped = False
        self._threads = [threading.Thread(target=self._serve, daemon=True) for _ in range(jobs)]

    def outcomes(self) -> Iterator[Outcome]:
        for thread in self._threads:
            thread.start()
        try:
            for _ in range(self._total):
                yield self._take()
        finally:
            with self._changed:
                self._stopped = True
                self._changed.notify_all()
            self._workers.stop()

    def _take(self) -> Outcome:
        with self._changed:
            self._changed.wait_for(lambda: self._outcomes)
            outcome = self._outcomes.popleft()
            if isinstance(outcome, BaseException):
                raise outcome
            self._waiting_bytes -= len(outcome)
            self._changed.notify_all()
        return _decode_outcome(outcome)

    def _put(self, outcome: bytes) -> None:
        with self._changed:
            self._changed.wait_for(lambda: self._stopped or self._waiting_bytes < _MAX_WAITING_BYTES)
            self._waiting_bytes += len(outcome)
            self._outcomes.append(outcome)
            self._changed.notify_all()

    def _fail(self, error: BaseException) -> None:
        with self._changed:
            self._outcomes.append(error)
            self._changed.notify_all()

    def _next(self, held: deque[Task]) -> Task | None:
        with self._changed:
            if held:
                return held.popleft()
            place = next(iter(self._tasks), None)
            return self._tasks.pop(place) if place is not None else None

    def _hold(self, task: Task, references: Sequence[str], held: deque[Task]) -> None:
        """Keep the documents that this worker has just read as references: it need not parse them again."""
        with self._changed:
            for location in references:
                place = (task.root, task.nested, location)
                if place in self._tasks:
                    held.append(self._tasks.pop(place))

    def _serve(self) -> None:
        """One thread per worker process: hand out tasks, wait for answers, replace the process when it dies."""
        process: subprocess.Popen[bytes] | None = None
        held: deque[Task] = deque()
        try:
            while not self._stopped:
                task = self._next(held)
                if task is None:
                    break
                if process is None:
                    process = self._workers.take()
                answer = self._ask(process, task)
                self._hold(task, answer.references, held)
                if process.poll() is not None:
                    self._workers.end(process)
                    process = None
                self._put(bytes(answer.outcome))
        except BaseException as error:
            self._fail(error)
        finally:
            if process is not None:
                self._workers.end(process)

    def _ask(self, process: subprocess.Popen[bytes], task: Task) -> Answer:
        assert process.stdin is not None and process.stdout is not None
        deadline = time.monotonic() + self._deadline_seconds
        descriptor = process.stdout.fileno()

        def read(size: int) -> bytes:
            ready, _, _ = select.select([descriptor], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                raise TimeoutError
            assert process.stdout is not None
            return process.stdout.read(size) or b""

        problem = "the reading process died (out of memory or a crash)"
        try:
            write_frame(process.stdin, msgspec.msgpack.encode(task))
            answer = read_frame(read)
        except TimeoutError:
            answer = None
            problem = f"gave up after {self._deadline_seconds:.0f} s"
        except (BrokenPipeError, ConnectionError):
            answer = None
        if answer is not None:
            return _decode_answer(answer)
        process.kill()
        process.wait()
        return Answer.to(Outcome(task.number, "failed", problem))


def _place(task: Task) -> tuple[str, tuple[str, ...], str]:
    return (task.root, task.nested, task.member)


_decode_answer = msgspec.msgpack.Decoder(Answer).decode
_decode_outcome = msgspec.msgpack.Decoder(Outcome).decode
