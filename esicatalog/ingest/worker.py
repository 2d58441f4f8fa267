"""The worker process: reads documents and answers with rows. It never imports SQLAlchemy.

Requests and answers are length-prefixed msgpack; run as ``python -m esicatalog.ingest.worker`` it takes them on stdin
and stdout. A document can cost it its life (memory limit) but not its siblings theirs.
"""

import contextlib
import os
import signal
import sys
import traceback
from pathlib import Path
from typing import IO

import msgspec

from esicatalog.catalog.document_status import FAILED, RECOVERED, SKIPPED, STORED, UNCHANGED
from esicatalog.catalog.rows import RowMaker
from esicatalog.errors import DocumentError, EsiCatalogError, NotAnEsiDocument, UnreadableDocument
from esicatalog.esi.containers import Container, open_container, resolve_reference
from esicatalog.esi.content import sha256_hex
from esicatalog.esi.reader import Reader
from esicatalog.esi.stages import Stages
from esicatalog.ingest.process import read_frame, settle_in, write_frame
from esicatalog.ingest.tasks import Answer, Outcome, Task
from esicatalog.ingest.unchanged import ReferenceHashes, is_unchanged
from esicatalog.lint.linter import Linter
from esicatalog.model.derivation import Deriver

_PACKAGE = Path(__file__).parents[1]
_MAX_OPENED = 16
"""Containers kept open: neighbours in the order of reading lie in different archives."""
_NICENESS = 5
"""The writer runs first: whatever it leaves for after the last document is done by one core alone."""
_LONGEST_SECONDS = 300
"""For when nobody is left to end a document that never ends: longer than the pool waits for one."""


class DocumentWorker:
    """Turns tasks into outcomes; keeps the last containers and the content it has seen."""

    def __init__(self) -> None:
        self.stages = Stages()
        self._reader = Reader(self.stages)
        deriver = Deriver()
        self._linter = Linter(deriver=deriver)
        self._rows = RowMaker(deriver)
        self._opened: dict[tuple[str, tuple[str, ...]], tuple[Container, ReferenceHashes]] = {}

    def handle(self, task: Task) -> Outcome:
        """Read one document; whatever is wrong with it becomes the outcome's status and message."""
        try:
            outcome = self._handle(task)
        except MemoryError:
            message = "needs more memory than a document may take"
            outcome = Outcome(task.number, FAILED, message, is_unreadable=True)
        outcome.seconds = self.stages.take()
        return outcome

    def _handle(self, task: Task) -> Outcome:
        stages = self.stages
        try:
            with stages("read"):
                container, hashes = self._container(task)
                pulled = self._reader.pulled(container, task.member)
                content = container.read(task.member) if pulled is None else b""
                sha256, byte_count = (sha256_hex(content), len(content)) if pulled is None else pulled[:2]
        except EsiCatalogError as error:
            unreadable = isinstance(error, UnreadableDocument)
            return Outcome(task.number, FAILED, str(error), is_unreadable=unreadable)
        outcome = Outcome(task.number, STORED, None, sha256, byte_count)
        if task.known is not None and is_unchanged(task.known, sha256, task.member, hashes):
            outcome.status = UNCHANGED
            return outcome
        try:
            with stages("extract"):
                if pulled is None:
                    read, tree = self._reader.read_tree(content, task.member, container)
                else:
                    read, tree = pulled.document, pulled.tree
            with stages("lint"):
                findings = self._linter.document(
                    read, tree, lambda name: resolve_reference(container, task.member, name) is not None
                )
            with stages("rows"):
                outcome.rows = self._rows.document(read, findings)
            if outcome.rows.recovered is not None:
                outcome.status, outcome.message = RECOVERED, outcome.rows.recovered
        except NotAnEsiDocument as error:
            outcome.status, outcome.message = SKIPPED, str(error)
        except DocumentError as error:
            place = f"line {error.line}: " if error.line else ""
            outcome.status, outcome.message = FAILED, f"{place}{error}"
        except MemoryError:
            raise
        except RecursionError:
            outcome.status, outcome.message = FAILED, "is nested too deep"
        except Exception as error:  # a fault of the reader costs its document, not the run
            outcome.status = FAILED
            where = f"{type(error).__name__} in {_place(error)}"
            outcome.message = f"not foreseen by the reader ({where}); please report it with the document"
        return outcome

    def _container(self, task: Task) -> tuple[Container, ReferenceHashes]:
        key = (task.root, task.nested)
        opened = self._opened.pop(key, None)
        if opened is None:
            container = open_container(task.root, task.is_archive, task.nested)
            opened = (container, ReferenceHashes(container))
        self._opened[key] = opened
        if len(self._opened) > _MAX_OPENED:
            del self._opened[next(iter(self._opened))]
        return opened


def _place(error: Exception) -> str:
    """The last place in this package that an exception came through, for who is told of it."""
    frames = ((Path(frame.filename), frame.lineno) for frame in traceback.extract_tb(error.__traceback__))
    *_, (file, line) = (frame for frame in frames if frame[0].is_relative_to(_PACKAGE))
    return f"{file.relative_to(_PACKAGE.parent).as_posix()}, line {line}"


def serve(requests: IO[bytes], answers: IO[bytes]) -> None:
    """Answer tasks until there are no more."""
    with contextlib.suppress(AttributeError, OSError):
        os.nice(_NICENESS)
    worker = DocumentWorker()
    decode = msgspec.msgpack.Decoder(Task).decode
    encode = msgspec.msgpack.Encoder().encode
    while (request := read_frame(requests.read)) is not None:
        _end_after(_LONGEST_SECONDS)
        outcome = worker.handle(decode(request))
        with worker.stages("transfer"):  # told with the next document
            answer = encode(Answer.to(outcome))
        write_frame(answers, answer)
        _end_after(0)


def _end_after(seconds: int) -> None:
    """Let the system end this process after so many seconds, 0 = never."""
    with contextlib.suppress(AttributeError):  # Windows has no alarm.
        signal.alarm(seconds)


def main() -> None:
    """Answer on stdout what is asked on stdin; whatever else is printed goes to stderr."""
    settle_in()
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    serve(sys.stdin.buffer, answers)


if __name__ == "__main__":
    main()
