"""The ingest: what is new or changed is read by workers and written by one writer, resumable at any point."""

import gc
import hashlib
import os
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.database import database_error
from esicatalog.catalog.load import end_load, finish_load, forget_content_hash, prepare_load
from esicatalog.catalog.writer import SourceRow, Writer
from esicatalog.errors import DocumentError
from esicatalog.esi.containers import Folder
from esicatalog.esi.content import sha256_hex
from esicatalog.ingest.discover import Found, FoundArchive, archive_members, discover
from esicatalog.ingest.report import DocumentLine, IngestReport
from esicatalog.ingest.tasks import Known, Outcome, Task
from esicatalog.ingest.unchanged import ReferenceHashes, is_unchanged
from esicatalog.version import __version__

if TYPE_CHECKING:
    from esicatalog.ingest.pool import Workers

Progress = Callable[[DocumentLine, int, int], None]
"""Called after every document: its line, documents done, documents in all."""

_COMMIT_SECONDS = 1.0
"""What a killed ingest has to read again at most; a commit costs the work of putting the catalog in order."""


class _Stored(NamedTuple):
    """What the catalog holds of a location."""

    status: str
    message: str | None
    member: str
    devices: int
    modules: int
    archive_id: int | None
    known: Known | None


def default_jobs() -> int:
    """One worker a core."""
    return os.cpu_count() or 1


def ingest(
    engine: sa.Engine,
    paths: Iterable[str | os.PathLike[str]],
    jobs: int | None = None,
    prune: bool = False,
    progress: Progress | None = None,
    workers: "Workers | None" = None,
) -> IngestReport:
    """Ingest everything below ``paths`` into the catalog.

    ``prune`` also removes what the given folders no longer hold; ``workers`` may have been started before. Raises
    :class:`InputError` for a missing path and
    :class:`CatalogError` when the database cannot be written; what was committed before stays.
    """
    started = time.monotonic()
    given = [os.path.realpath(path) for path in paths]
    try:
        with engine.connect() as connection, _without_cycle_search():
            run = _Run(connection, given, jobs or default_jobs(), progress, workers)
            try:
                prepare_load(connection)
                lines = run.ingest(prune)
                finish_load(connection, changed=run.changed)
            finally:
                end_load(connection)
    except sa.exc.DBAPIError as error:
        raise database_error(str(engine.url.database), error) from error
    return IngestReport(lines, time.monotonic() - started)


@contextmanager
def _without_cycle_search() -> Iterator[None]:
    """Rows hold no cycles, and there are so many that looking for cycles takes a sixth of the writer's time."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


class _Run:
    def __init__(
        self,
        connection: sa.Connection,
        paths: list[str],
        jobs: int,
        progress: Progress | None,
        workers: "Workers | None",
    ) -> None:
        self._connection = connection
        self._workers = workers
        self._paths = paths
        self._jobs = jobs
        self._progress = progress
        self._stored = _read_stored(connection)
        self._archives = {row.location: row for row in connection.execute(sa.select(schema.archives))}
        self._lines: list[DocumentLine] = []
        self._total = 0
        self.changed = False

    def ingest(self, prune: bool) -> list[DocumentLine]:
        pending: list[Found] = []
        opened: dict[str, str] = {}
        seen: set[str] = set()
        for item in discover(self._paths):
            seen.add(item.location)
            if isinstance(item, FoundArchive):
                sha256 = _file_sha256(item.location)
                if self._archive_unchanged(item, sha256, seen):
                    continue
                opened[item.location] = sha256
                pending.extend(archive_members(item))
            else:
                pending.append(item)
        seen.update(item.location for item in pending)
        gone = [
            location for location in self._stored if location not in seen and self._is_gone(location, opened, prune)
        ]
        todo = [item for item in pending if item.problem or not self._file_unchanged(item)]
        self._total = len(self._lines) + len(todo)
        for done, line in enumerate(self._lines, 1):
            self._tell(line, done)
        if todo or gone or opened:
            self._write(todo, gone, opened)
        return sorted(self._lines, key=lambda line: line.path)

    def _is_gone(self, location: str, opened: dict[str, str], prune: bool) -> bool:
        archive = location.split("!", 1)[0]
        if archive in opened:
            return True
        return prune and any(location == path or location.startswith(path + os.sep) for path in self._paths)

    def _archive_unchanged(self, item: FoundArchive, sha256: str, seen: set[str]) -> bool:
        stored = self._archives.get(item.location)
        if stored is None or stored.sha256 != sha256 or stored.reader_version != __version__:
            return False
        for location, held in self._stored.items():
            if held.archive_id == stored.id:
                seen.add(location)
                self._lines.append(_unchanged_line(held))
        return True

    def _file_unchanged(self, item: Found) -> bool:
        held = self._stored.get(item.location)
        if held is None or held.known is None or item.is_archive or held.member != item.member:
            return False
        folder = Folder(Path(item.root))
        try:
            sha256 = sha256_hex(folder.read(item.name))
        except DocumentError:
            return False
        if not is_unchanged(held.known, sha256, item.name, ReferenceHashes(folder)):
            return False
        self._lines.append(_unchanged_line(held))
        return True

    def _write(self, todo: list[Found], gone: list[str], opened: dict[str, str]) -> None:
        from esicatalog.ingest.pool import run_tasks

        self.changed = True
        forget_content_hash(self._connection)
        writer = Writer(self._connection, __version__)
        for location in gone:
            writer.forget(location)
        writer.commit()
        archive_ids = {location: writer.archive(location) for location in opened}
        writer.commit()
        todo.sort(key=_reading_order)
        tasks = [self._task(number, item) for number, item in enumerate(todo) if item.problem is None]
        problems = [
            Outcome(number, item.problem[0], item.problem[1]) for number, item in enumerate(todo) if item.problem
        ]
        committed = time.monotonic()
        outcomes = run_tasks(tasks, self._jobs, self._workers)
        for done, outcome in enumerate(chain(problems, outcomes), len(self._lines) + 1):
            item = todo[outcome.number]
            self._store(writer, item, outcome, archive_ids)
            self._tell(self._lines[-1], done)
            if time.monotonic() - committed > _COMMIT_SECONDS:
                writer.commit()
                committed = time.monotonic()
        for location, sha256 in opened.items():
            writer.archive_done(archive_ids[location], sha256)
        writer.commit()

    def _task(self, number: int, item: Found) -> Task:
        held = self._stored.get(item.location)
        known = held.known if held is not None and held.member == item.member else None
        return Task(number, item.root, item.is_archive, item.nested, item.name, known)

    def _store(self, writer: Writer, item: Found, outcome: Outcome, archive_ids: dict[str, int]) -> None:
        if outcome.status == "unchanged":
            self._lines.append(_unchanged_line(self._stored[item.location]))
            return
        rows = outcome.rows
        source = SourceRow(
            item.location,
            item.member,
            outcome.status,
            outcome.message,
            outcome.sha256,
            outcome.byte_count,
            archive_ids.get(item.root) if item.is_archive else None,
        )
        writer.store(source, rows)
        devices, modules = (len(rows.devices), len(rows.modules)) if rows is not None else (0, 0)
        self._lines.append(DocumentLine(item.member, outcome.status, outcome.message, devices, modules))

    def _tell(self, line: DocumentLine, done: int) -> None:
        if self._progress is not None:
            self._progress(line, done, self._total)


def _reading_order(item: Found) -> tuple[int, int, str]:
    """Short paths first: a document comes before those it refers to, which lie beside or below it; small ones first,
    because a small document may pull in large ones.
    """
    return (item.member.count("/"), item.size_bytes, item.location)


def _unchanged_line(held: _Stored) -> DocumentLine:
    status = held.status if held.status in ("skipped", "failed") else "unchanged"
    return DocumentLine(held.member, status, held.message, held.devices, held.modules)


def _file_sha256(path: str) -> str:
    with open(path, "rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _read_stored(connection: sa.Connection) -> dict[str, _Stored]:
    references: dict[int, list[tuple[str, str | None]]] = {}
    columns = schema.source_references.c
    for number, reference, sha256 in connection.execute(
        sa.select(columns.source_id, columns.reference, columns.sha256).order_by(columns.source_id, columns.position)
    ):
        references.setdefault(number, []).append((reference, sha256))
    found = {}
    sources = schema.sources.c
    for row in connection.execute(
        sa.select(
            sources.id,
            sources.location,
            sources.status,
            sources.message,
            sources.member,
            sources.device_count,
            sources.module_count,
            sources.archive_id,
            sources.sha256,
            sources.reader_version,
        )
    ):
        readable = row.sha256 is not None and row.reader_version == __version__
        known = Known(row.sha256, tuple(references.get(row.id, ()))) if readable else None
        found[row.location] = _Stored(
            row.status, row.message, row.member, row.device_count, row.module_count, row.archive_id, known
        )
    return found
