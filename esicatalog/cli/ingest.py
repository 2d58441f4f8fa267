"""esicatalog ingest"""

import contextlib
import gc
import os
import signal
import sys
import time
from collections.abc import Iterator
from typing import TYPE_CHECKING, NoReturn

import click

from esicatalog.catalog.document_status import FAILED, RECOVERED, REMOVED, SKIPPED, STORED, UNCHANGED
from esicatalog.cli.common import (
    EXIT_NO,
    Command,
    IntegerRange,
    Terminated,
    db_option,
    format_option,
    print_json,
    reporting_errors,
    say_no_document,
)

if TYPE_CHECKING:
    from esicatalog.ingest.report import DocumentLine, IngestReport

_NAMED_STATUSES = (FAILED, RECOVERED, SKIPPED, REMOVED)
_IN_LOG = (
    "others are reading the catalog: the latest is in {db}-wal, and {db} alone is older; carry the catalog with "
    "esicatalog snapshot"
)
_REDRAW_SECONDS = 0.1
_PLAIN_LINE_SECONDS = 2.0


@click.command("ingest", cls=Command)
@click.argument("paths", nargs=-1, required=True, type=click.Path())
@db_option
@click.option("--jobs", type=IntegerRange(1), help="Worker processes; 1 = none.  [default: one a core]")
@click.option("--prune", is_flag=True, help="Remove what the given folders no longer hold.")
@click.option("--profile", is_flag=True, help="Say how much processor time each stage took.")
@format_option("table", "json")
@reporting_errors
def command(paths: tuple[str, ...], db: str, jobs: int | None, prune: bool, profile: bool, output_format: str) -> None:
    """Read ESI files, folders (recursively) and zip archives into the catalog.

    Unchanged documents are skipped. The answer names those that failed, were recovered or skipped, and those that were
    removed: with --prune, and where an archive or a file in place of a folder no longer has them. Exit code 1 when a
    document failed.
    """
    from esicatalog.api import Catalog
    from esicatalog.ingest.this_process import without_cycle_search

    with _terminable(), without_cycle_search(), Catalog(db, create=True, at_once=False) as catalog:
        try:
            report = catalog.ingest(paths, jobs, prune, _Progress())
        finally:
            if sys.stderr.isatty():
                click.echo("\r\033[K", nl=False, err=True)
            # The process is about to end: searching all that it holds for cycles would be in vain.
            gc.freeze()
    if output_format == "json":
        print_json(report.as_json() | ({"profile": _profile(report)} if profile else {}))
    else:
        _print_summary(report, db)
        if profile:
            _print_profile(report)
    if not report.is_in_file:
        click.echo(_IN_LOG.format(db=db), err=True)
    if not any(report.counts[status] for status in (STORED, UNCHANGED, FAILED)):
        say_no_document(paths)
    if report.counts[FAILED]:
        sys.exit(EXIT_NO)


@contextlib.contextmanager
def _terminable() -> Iterator[None]:
    """SIGTERM ends an ingest as Ctrl-C does: workers stopped, what is not committed rolled back, one line."""

    def terminate(number: int, frame: object) -> NoReturn:
        raise Terminated

    before = signal.signal(signal.SIGTERM, terminate)
    try:
        yield
    except KeyboardInterrupt as error:
        error.add_note("nothing stored before is lost, run it again to go on")
        raise
    finally:
        signal.signal(signal.SIGTERM, before)


class _Progress:
    """A bar on a terminal, a plain line every few seconds elsewhere."""

    def __init__(self) -> None:
        self._started = self._told = time.monotonic()
        self._devices = 0
        self._terminal = sys.stderr.isatty()

    def __call__(self, line: "DocumentLine", done: int, total: int) -> None:
        self._devices += line.devices
        now = time.monotonic()
        if now - self._told < (_REDRAW_SECONDS if self._terminal else _PLAIN_LINE_SECONDS):
            return
        self._told = now
        rate = done / max(now - self._started, 0.001)
        words = f"{done}/{total} documents, {self._devices} devices, {rate:.0f} documents/s"
        if self._terminal:
            filled = 30 * done // max(total, 1)
            click.echo(f"\r[{'#' * filled}{'-' * (30 - filled)}] {words}\033[K", nl=False, err=True)
        else:
            click.echo(words, err=True)


def _print_summary(report: "IngestReport", db: str) -> None:
    for line in report.documents:
        if line.status in _NAMED_STATUSES:
            click.echo(f"{line.status:9}  {line.path}: {line.message}")
    from esicatalog.catalog.database import shown_target
    from esicatalog.words import counted

    counts = report.counts
    removed = f", {report.removed} removed" if report.removed else ""
    click.echo(
        f"{counts[STORED]} stored ({counts[RECOVERED]} after recovery), {counts[UNCHANGED]} unchanged, "
        f"{counts[SKIPPED]} skipped, {counts[FAILED]} failed{removed}; "
        f"{counted(report.devices, 'device')}, {counted(report.modules, 'module')} in {report.seconds:.1f} s "
        f"-> {shown_target(db)}"
    )


def _profile(report: "IngestReport") -> dict[str, float]:
    """Processor seconds by stage, and the rest of this process and its workers."""
    from esicatalog.esi.stages import STAGES

    rest = max(0.0, sum(os.times()[:4]) - sum(report.profile.values()))
    return {stage: round(report.profile.get(stage, 0.0), 3) for stage in STAGES} | {"start": round(rest, 3)}


def _print_profile(report: "IngestReport") -> None:
    from esicatalog.esi.stages import STAGES

    seconds = _profile(report)
    total = sum(seconds.values()) or 1.0
    click.echo(f"processor time of all processes: {total:.2f} s", err=True)
    for stage, spent in seconds.items():
        words = STAGES.get(stage, "start of the processes, imports, planning, all else")
        click.echo(f"{stage:9} {spent:7.2f} s  {spent / total:4.0%}  {words}", err=True)
