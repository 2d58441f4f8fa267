"""Worker processes of our own: a deadline per document, a dead worker costs one document."""

import threading
import time
from collections import deque
from collections.abc import Iterator, Sequence

import msgspec

from esicatalog.catalog.document_status import FAILED
from esicatalog.errors import UnreadableDocument
from esicatalog.ingest.process import Helper, can_fork, forked, interpreter
from esicatalog.ingest.tasks import Answer, Outcome, Task
from esicatalog.ingest.this_process import DEADLINE_SECONDS, gave_up, limited_time
from esicatalog.ingest.worker import DocumentWorker, serve

_MAX_WAITING_BYTES = 64 * 1024 * 1024
"""Outcomes wait as bytes, ten times smaller than as rows: workers go on while the writer writes."""
_ASKED_AT_ONCE = 2
_FITS_BYTES = 4096
"""Of a request that waits in any pipe: nobody waits until it is read, who meanwhile may wait to be read."""
_ENOUGH_TASKS = 2
"""For each worker: with fewer left, none waits behind another while somebody has nothing to do."""


def read_here(tasks: Sequence[Task]) -> Iterator[Outcome]:
    """Outcomes of all tasks, read in this process."""
    worker = DocumentWorker()
    for task in tasks:
        try:
            with limited_time():
                outcome = worker.handle(task)
        except UnreadableDocument as error:
            worker = DocumentWorker()  # What that one knows may be half of what it was about to learn.
            outcome = _given_up(task, str(error))
        yield outcome


def _given_up(task: Task, problem: str) -> Outcome:
    return Outcome(task.number, FAILED, problem, is_unreadable=True)


class Pool:
    """Reads documents in worker processes; :meth:`outcomes` gives them in the order in which they are ready.

    ``deadline_seconds`` is the longest time for a document; tests do not wait as long as an ingest.
    """

    def __init__(self, tasks: Sequence[Task], jobs: int, deadline_seconds: float = DEADLINE_SECONDS) -> None:
        self._tasks = {_place(task): task for task in tasks}
        self._total = len(tasks)
        self._deadline_seconds = deadline_seconds
        self._changed = threading.Condition()
        self._outcomes: deque[bytes | BaseException] = deque()
        self._waiting_bytes = 0
        self._processes: set[Helper] = set()
        self._stopped = False
        self._count = min(jobs, len(tasks))
        self._threads: list[threading.Thread] = []

    def start(self) -> None:
        """Start reading."""
        may_fork = can_fork()  # All copies are made before the first thread begins.
        workers = [forked(serve) if may_fork else None for _ in range(self._count)]
        self._processes.update(worker for worker in workers if worker is not None)
        self._threads = [threading.Thread(target=self._serve, args=(worker,), daemon=True) for worker in workers]
        for thread in self._threads:
            thread.start()

    def stop(self) -> None:
        """End all processes, whatever they are doing."""
        with self._changed:
            self._stopped = True
            self._changed.notify_all()
        for process in list(self._processes):
            process.kill()
        for thread in self._threads:
            thread.join()

    def outcomes(self) -> Iterator[Outcome]:
        """One outcome a task."""
        for _ in range(self._total):
            yield self._take()

    def _take(self) -> Outcome:
        with self._changed:
            self._changed.wait_for(lambda: self._outcomes)
            outcome = self._outcomes.popleft()
            if isinstance(outcome, BaseException):
                raise outcome
            self._waiting_bytes -= len(outcome)
            self._changed.notify_all()
        started = time.thread_time()
        decoded = _decode_outcome(outcome)
        decoded.seconds["transfer"] = decoded.seconds.get("transfer", 0.0) + time.thread_time() - started
        return decoded

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

    def _next(self, held: deque[Task], ahead: bool) -> Task | None:
        """A task for a worker; one ``ahead`` of its time only while there are enough for all."""
        with self._changed:
            if held:
                return held.popleft()
            if ahead and len(self._tasks) < _ENOUGH_TASKS * self._count:
                return None
            place = next(iter(self._tasks), None)
            return self._tasks.pop(place) if place is not None else None

    def _hold(self, task: Task, references: Sequence[str], held: deque[Task]) -> None:
        """Keep the documents that this worker has just read as references: it need not parse them again."""
        with self._changed:
            for location in references:
                place = (task.root, task.nested, location)
                if place in self._tasks:
                    held.append(self._tasks.pop(place))

    def _serve(self, worker: Helper | None) -> None:
        """One thread per worker process: hand out tasks, wait for answers, replace the process when it dies.

        While a worker reads a document it has the next task already, else it would wait for this thread's turn.
        """
        held: deque[Task] = deque()
        asked: deque[Task] = deque()
        try:
            while not self._stopped:
                while len(asked) < _ASKED_AT_ONCE and (task := self._next(held, ahead=bool(asked))) is not None:
                    request = msgspec.msgpack.encode(task)
                    if asked and len(request) > _FITS_BYTES:
                        held.appendleft(task)
                        break
                    if worker is None:
                        worker = self._launch()
                    worker.send(request)
                    asked.append(task)
                if worker is None or not asked:
                    break
                task = asked.popleft()
                answer = self._receive(worker, task)
                self._hold(task, answer.references, held)
                if not worker.is_alive:
                    self._end(worker)
                    worker = None
                    held.extendleft(reversed(asked))
                    asked.clear()
                self._put(bytes(answer.outcome))
        except BaseException as error:
            self._fail(error)
        finally:
            if worker is not None:
                self._end(worker)

    def _launch(self) -> Helper:
        worker = interpreter("esicatalog.ingest.worker")
        self._processes.add(worker)
        if self._stopped:
            worker.kill()
        return worker

    def _end(self, worker: Helper) -> None:
        self._processes.discard(worker)
        worker.end()

    def _receive(self, worker: Helper, task: Task) -> Answer:
        problem = "the reading process died (out of memory or a crash)"
        try:
            answer = worker.receive(self._deadline_seconds)
        except TimeoutError:
            answer = None
            problem = gave_up(self._deadline_seconds)
        if answer is not None:
            return _decode_answer(answer)
        worker.end()
        return Answer.to(_given_up(task, problem))


def _place(task: Task) -> tuple[str, tuple[str, ...], str]:
    return (task.root, task.nested, task.member)


_decode_answer = msgspec.msgpack.Decoder(Answer).decode
_decode_outcome = msgspec.msgpack.Decoder(Outcome).decode
