"""How fast ingest is, as ratios to a bare lxml parse of the same documents in the same run.

    python benchmarks/ingest.py [CORPUS] [--runs 3] [--jobs 2]

Ratios are what counts: seconds differ from machine to machine and from minute to minute, so every run measures the
floor right beside the ingests and the table shows medians. Interpreter start and imports are part of an ingest.
"""

import argparse
import json
import multiprocessing
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple

from lxml import etree

from esicatalog.errors import EsiCatalogError
from esicatalog.esi.containers import Archive
from esicatalog.ingest.discover import Found, FoundArchive, archive_members, discover

COLD_LIMIT = 3.0
WARM_LIMIT = 0.3
MEMORY_LIMIT_MB = 400

_INGEST = """
import io, json, resource, sys
from esicatalog.cli.main import cli
output, sys.stdout = sys.stdout, io.TextIOWrapper(io.BytesIO())
arguments = ["ingest", sys.argv[2], "--db", sys.argv[1], "--jobs", sys.argv[3], "--format", "json"]
cli(arguments, standalone_mode=False)
sys.stdout.seek(0)
report = json.load(sys.stdout)
kilobytes = [resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
print(json.dumps({"counts": report["sources"], "peak_mb": [k / 1024 for k in kilobytes]}), file=output)
"""
"""A process starts with the peak memory of the one that started it, so this one must stay small."""


class Ingested(NamedTuple):
    """One ingest in a process of its own."""

    seconds: float
    counts: dict[str, int]
    parent_mb: float
    worker_mb: float


class Floor(NamedTuple):
    """A bare parse of all documents, reading them not counted."""

    seconds: float
    document_count: int
    xml_bytes: int


class Run(NamedTuple):
    """Floor, cold and warm ingest measured one after the other."""

    floor: Floor
    cold: Ingested
    warm: Ingested
    database_bytes: int


def documents(corpus: Path) -> Iterator[bytes]:
    """The bytes of every document that an ingest of ``corpus`` reads."""
    for item in discover([corpus]):
        if isinstance(item, FoundArchive):
            outer = Archive(Path(item.location))
            for found in archive_members(item):
                yield _member(outer, found)
        elif item.problem is None:
            yield Path(item.location).read_bytes()


def _member(archive: Archive, found: Found) -> bytes:
    for name in found.nested:
        archive = Archive(archive.read(name))
    try:
        return archive.read(found.name) if found.problem is None else b""
    except EsiCatalogError:
        return b""


def parse_everything(corpus: Path) -> Floor:
    """Parse all documents with lxml and its default options in this process."""
    contents = list(documents(corpus))
    started = time.perf_counter()
    for content in contents:
        try:
            etree.fromstring(content)
        except etree.XMLSyntaxError:
            continue
    return Floor(time.perf_counter() - started, len(contents), sum(map(len, contents)))


def measure_floor(corpus: Path) -> Floor:
    """:func:`parse_everything` in a process of its own: this one must not hold the documents."""
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as executor:
        return executor.submit(parse_everything, corpus).result()


def timed_ingest(corpus: Path, database: Path | str, jobs: int) -> Ingested:
    """Ingest in a new interpreter; seconds include its start."""
    started = time.perf_counter()
    command = [sys.executable, "-c", _INGEST, str(database), str(corpus), str(jobs)]
    process = subprocess.run(command, check=True, capture_output=True, text=True)
    seconds = time.perf_counter() - started
    answer = json.loads(process.stdout)
    return Ingested(seconds, answer["counts"], *answer["peak_mb"])


def measure(corpus: Path, jobs: int) -> Run:
    """One run: floor, cold ingest into a new catalog, warm ingest of the unchanged corpus."""
    with tempfile.TemporaryDirectory() as folder:
        database = Path(folder, "catalog.db")
        floor = measure_floor(corpus)
        cold = timed_ingest(corpus, database, jobs)
        warm = timed_ingest(corpus, database, jobs)
        return Run(floor, cold, warm, database.stat().st_size)


def table(runs: list[Run]) -> list[tuple[str, str, str]]:
    """Rows (what, measured, limit) of the report; medians over the runs."""

    def median(values: Iterator[float]) -> float:
        return statistics.median(values)

    cold = median(run.cold.seconds / run.floor.seconds for run in runs)
    warm = median(run.warm.seconds / run.floor.seconds for run in runs)
    peak = max(max(run.cold.parent_mb, run.cold.worker_mb) for run in runs)
    return [
        ("floor: lxml parse", f"{median(run.floor.seconds for run in runs):.2f} s", ""),
        ("cold ingest", f"{median(run.cold.seconds for run in runs):.2f} s", ""),
        ("cold ingest / floor", f"{cold:.2f}", f"<= {COLD_LIMIT}"),
        ("warm ingest", f"{median(run.warm.seconds for run in runs):.2f} s", ""),
        ("warm ingest / floor", f"{warm:.2f}", f"<= {WARM_LIMIT}"),
        ("peak memory, writer", f"{max(run.cold.parent_mb for run in runs):.0f} MB", ""),
        ("peak memory, largest worker", f"{max(run.cold.worker_mb for run in runs):.0f} MB", ""),
        ("peak memory of a process", f"{peak:.0f} MB", f"<= {MEMORY_LIMIT_MB} MB"),
        ("database / XML", f"{runs[-1].database_bytes / runs[-1].floor.xml_bytes:.2f}", ""),
    ]


def default_corpus() -> Path:
    """The ESI corpus of the environment, else the one beside the checkout."""
    root = os.environ.get("ESICATALOG_CORPUS")
    return Path(root, "esi") if root else Path(__file__).resolve().parents[2] / "shared/corpus/esi"


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="Measure cold and warm ingest against a bare lxml parse.")
    parser.add_argument("corpus", nargs="?", type=Path, default=default_corpus(), help="folder or archive to ingest")
    parser.add_argument("--runs", type=int, default=3, help="how often to measure; medians are shown")
    parser.add_argument("--jobs", type=int, default=2, help="worker processes")
    given = parser.parse_args()
    runs = []
    for number in range(given.runs):
        run = measure(given.corpus, given.jobs)
        runs.append(run)
        print(
            f"run {number + 1}: floor {run.floor.seconds:.2f} s, cold {run.cold.seconds:.2f} s,"
            f" warm {run.warm.seconds:.2f} s, {run.cold.counts['stored']} documents stored",
            flush=True,
        )
    floor = runs[-1].floor
    print(
        f"\n{floor.document_count} documents, {floor.xml_bytes / 1e6:.0f} MB XML, {given.jobs} workers,"
        f" median of {given.runs}"
    )
    for what, measured, limit in table(runs):
        print(f"{what:<28} {measured:>10}  {limit}")


if __name__ == "__main__":
    main()
