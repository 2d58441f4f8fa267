"""The ingest: what is new or changed is read by workers and written by one writer, resumable at any point."""

import os
import time
from collections.abc import Callable, Iterable, Iterator, Set
from contextlib import contextmanager
from itertools import islice

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.database import shown_url, sqlite_path
from esicatalog.catalog.document_status import FAILED, UNCHANGED
from esicatalog.catalog.driver_errors import database_error
from esicatalog.catalog.load import end_load, finish_indexes, finish_load, prepare_load
from esicatalog.catalog.lock import only_writer
from esicatalog.catalog.writer import SourceRow, Writer
from esicatalog.errors import CatalogError
from esicatalog.esi.stages import Stages
from esicatalog.ingest.plan import Held, HeldDocument, Plan, make_plan
from esicatalog.ingest.reading import Reading
from esicatalog.ingest.report import DocumentLine, IngestReport
from esicatalog.ingest.tasks import Known, Outcome
from esicatalog.ingest.this_process import without_cycle_search
from esicatalog.version import __version__

Progress = Callable[[DocumentLine, int, int], None]
"""Called after every document: its line, documents done, documents in all."""

_COMMIT_SECONDS = 2.0
"""Between commits: what a killed ingest has to read again."""
_COMMIT_SHARE = 10
"""A commit puts all vendors and devices that were met in order: the larger the catalog, the rarer it is worth that."""
_MOST_LAST_OUTCOMES = 100
_LAST_SHARE = 5
"""What came before the last outcomes, at most a fifth of all, is committed and indexed while workers are still busy
with these: afterwards one core does it alone."""
_MOST_GATHERED_BYTES = 16_000_000
"""Documents that wait to be written together: they wait as rows, which take a multiple of their size."""


def ingest(
    engine: sa.Engine,
    paths: Iterable[str | os.PathLike[str]],
    own_files: Set[str],
    reading: Reading,
    prune: bool = False,
    progress: Progress | None = None,
) -> IngestReport:
    """Ingest everything below ``paths`` into the catalog.

    ``own_files``, those of the catalog, are left out. ``reading`` may have been started when the catalog was known to
    be empty, else it is started here. ``prune`` also removes what the given folders no longer hold. Raises
    :class:`InputError` for a missing path and :class:`CatalogError` when the database cannot be written or another
    ingest is writing to it; what was committed before stays.
    """
    started = time.monotonic()
    stages = Stages()
    path = sqlite_path(engine.url)
    try:
        with only_writer(path), engine.connect() as connection, without_cycle_search():
            # What a load leaves on its connection, temporary tables and a large cache, ends with it.
            connection.detach()
            try:
                held = _read_held(connection)
                connection.commit()  # Planning may take long; who wants to change tables need not wait for it.
                plan = reading.plan or reading.start(make_plan(paths, held, prune, reading.hashed(), own_files))
                prepare_load(connection, changes=not plan.is_empty)
                lines = _write(connection, plan, reading.outcomes, held, progress, stages)
                with stages("index"):
                    finish_load(connection, changed=not plan.is_empty)
            finally:
                is_in_file = end_load(connection)
    except sa.exc.DBAPIError as error:
        raise database_error(shown_url(engine.url), error, is_writing=True) from error
    except OverflowError as error:  # from the driver, which has many documents at once and does not say which
        raise CatalogError(
            f"{shown_url(engine.url)}: a document brings a number or text that no database takes; please report it "
            "with the documents since the last commit, and ingest the others without them"
        ) from error
    lines.sort(key=lambda line: line.path)
    return IngestReport(lines, time.monotonic() - started, stages.seconds, is_in_file)


def _write(
    connection: sa.Connection,
    plan: Plan,
    outcomes: Iterator[Outcome],
    held: Held,
    progress: Progress | None,
    stages: Stages,
) -> list[DocumentLine]:
    """Store the outcomes of a plan; returns the lines of all documents."""
    storing = _Storing(plan, held, Writer(connection, __version__, stages), progress, stages)
    for line in plan.unchanged:
        storing.tell(line)
    if plan.is_empty:
        return storing.lines
    storing.begin()
    pace = _Pace()
    batches = _file_batches if connection.dialect.name == "sqlite" else _server_batches
    last_count = min(_MOST_LAST_OUTCOMES, len(plan.todo) // _LAST_SHARE)
    for part in (islice(outcomes, len(plan.todo) - last_count), outcomes):
        for batch in batches(part, pace):
            for outcome in batch:
                storing.keep(outcome)
            with pace.measured():
                storing.commit()
        with stages("index"):
            finish_indexes(connection)
    storing.end()
    return storing.lines


class _Storing:
    """The outcomes of a plan on their way into the catalog, and the lines that tell of them."""

    def __init__(self, plan: Plan, held: Held, writer: Writer, progress: Progress | None, stages: Stages) -> None:
        self._plan = plan
        self._held = held
        self._writer = writer
        self._progress = progress
        self._stages = stages
        self.lines: list[DocumentLine] = []
        """Of all documents that were told of so far."""
        self._incomplete: set[str] = set()
        """Archives of which a document could not be read, because its process was killed for instance."""

    def tell(self, line: DocumentLine) -> None:
        """Take down what became of a document."""
        self.lines.append(line)
        if self._progress is not None:
            self._progress(line, len(self.lines), self._plan.document_count)

    def begin(self) -> None:
        """Drop what is gone and take that down, and say of each archive that it is being read."""
        for location in self._plan.gone:
            self._writer.forget(location)
            document = self._held.documents[location]
            if document.has_content:
                self.lines.append(document.removed_line())
        self._writer.commit()
        for location in self._plan.archives:
            self._writer.archive_begun(location)
        self._writer.commit()

    def keep(self, outcome: Outcome) -> None:
        """Store what became of a document, unless the catalog keeps what it has."""
        self._stages.add(outcome.seconds)
        item = self._plan.todo[outcome.number]
        if outcome.status == FAILED and outcome.sha256 is None and (item.problem is None or item.is_unreadable):
            self._incomplete.add(item.root)
        document = self._held.documents.get(item.location)
        if document is not None and outcome.status == UNCHANGED:
            self.tell(document.unchanged_line())
        elif document is not None and outcome.is_unreadable and document.has_content:
            self.tell(document.unreadable_line(outcome.message))
        else:
            archive = item.root if item.is_archive else None
            with self._stages("write"):
                line = _store(self._writer, item.location, item.member, archive, outcome)
            self.tell(line)

    def commit(self) -> None:
        """Make what was kept last."""
        self._writer.commit()

    def end(self) -> None:
        """Say of the archives that were read as a whole that they were; the others are read again next time."""
        for location, sha256 in self._plan.archives.items():
            if location not in self._incomplete:
                self._writer.archive_done(location, sha256)
        self._writer.commit()


class _Pace:
    """How long documents are gathered before a commit."""

    def __init__(self) -> None:
        self.seconds = _COMMIT_SECONDS

    @contextmanager
    def measured(self) -> Iterator[None]:
        """Around a commit: however long it takes, most of the time goes into documents."""
        started = time.monotonic()
        yield
        self.seconds = max(_COMMIT_SECONDS, _COMMIT_SHARE * (time.monotonic() - started))


def _file_batches(outcomes: Iterator[Outcome], pace: _Pace) -> Iterator[Iterable[Outcome]]:
    """Outcomes by commit, each handed on when it comes: nobody else writes into the file."""
    for first in outcomes:
        yield _for_a_while(first, outcomes, pace)


def _for_a_while(first: Outcome, following: Iterator[Outcome], pace: _Pace) -> Iterator[Outcome]:
    until = time.monotonic() + pace.seconds
    yield first
    while time.monotonic() < until:
        outcome = next(following, None)
        if outcome is None:
            return
        yield outcome


def _server_batches(outcomes: Iterator[Outcome], pace: _Pace) -> Iterator[Iterable[Outcome]]:
    """Outcomes by commit, handed on together: others write meanwhile, and wait only while these are written."""
    for first in outcomes:
        gathered, byte_count = [first], first.byte_count or 0
        until = time.monotonic() + pace.seconds
        while time.monotonic() < until and byte_count < _MOST_GATHERED_BYTES:
            outcome = next(outcomes, None)
            if outcome is None:
                break
            gathered.append(outcome)
            byte_count += outcome.byte_count or 0
        yield gathered


def _store(writer: Writer, location: str, member: str, archive: str | None, outcome: Outcome) -> DocumentLine:
    source = SourceRow(location, member, outcome.status, outcome.message, outcome.sha256, outcome.byte_count, archive)
    rows = outcome.rows
    writer.store(source, rows)
    devices, modules = (len(rows.devices), len(rows.modules)) if rows is not None else (0, 0)
    return DocumentLine(member, outcome.status, outcome.message, devices, modules)


def _read_held(connection: sa.Connection) -> Held:
    """What the catalog holds; documents read by another version of this package have to be read again."""
    references: dict[int, list[tuple[str, str | None]]] = {}
    columns = schema.source_references.c
    for number, reference, sha256 in connection.execute(
        sa.select(columns.source_id, columns.reference, columns.sha256).order_by(columns.source_id, columns.position)
    ):
        references.setdefault(number, []).append((reference, sha256))
    archives = {row.id: row for row in connection.execute(sa.select(schema.archives))}
    documents = {}
    for row in connection.execute(sa.select(schema.sources)):
        readable = row.sha256 is not None and row.reader_version == __version__
        known = Known(row.sha256, tuple(references.get(row.id, ()))) if readable else None
        archive = archives[row.archive_id].location if row.archive_id is not None else None
        documents[row.location] = HeldDocument(
            row.status, row.message, row.member, row.device_count, row.module_count, archive, known
        )
    read = {row.location: row.sha256 for row in archives.values() if row.reader_version == __version__}
    return Held(documents, read)
