"""How fast ingest is, as ratios to a bare lxml parse of the same documents in the same run.

Seconds differ from machine to machine and from minute to minute, so every run measures the floor right beside the
ingests. The start of Python and its imports are part of an ingest.
"""

import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from statistics import median
from typing import NamedTuple

from corpus import Floor, change_document, change_member, largest_archive, measure_floor, typical_document, unpack
from processes import Ran, run_ingest
from report import Row

from esicatalog.catalog.views import FULL_TEXT

COLD_LIMIT, WARM_LIMIT, CHANGED_LIMIT, SIZE_LIMIT, MEMORY_LIMIT_MB = 1.5, 0.25, 0.35, 0.6, 400


class Run(NamedTuple):
    """Floor and ingests, one after the other."""

    floor: Floor
    cold: Ran
    warm: Ran
    document_changed: Ran
    member_changed: Ran | None


class Corpus:
    """A copy of the corpus as it is, and one with every document unpacked into a plain file."""

    def __init__(self, source: Path, folder: Path) -> None:
        self.packed, self.unpacked = folder / "packed", folder / "unpacked"
        shutil.copytree(source, self.packed, copy_function=shutil.copyfile)
        unpack(source, self.unpacked)
        self.archive = largest_archive(self.packed) if any(self.packed.rglob("*.zip")) else None
        self.document = typical_document(self.unpacked)
        self.member_count = 0
        self.database = folder / "packed.db"

    def measure(self, folder: Path, jobs: int) -> Run:
        """One run with new catalogs in ``folder``."""
        unpacked = folder / "unpacked.db"
        for old in (self.database, unpacked):
            old.unlink(missing_ok=True)
        floor = measure_floor(self.packed)
        cold = run_ingest(self.packed, self.database, jobs)
        warm = run_ingest(self.packed, self.database, jobs)
        member_changed = None
        if self.archive is not None:
            self.member_count = change_member(self.archive)
            member_changed = run_ingest(self.packed, self.database, jobs)
        run_ingest(self.unpacked, unpacked, jobs)
        change_document(self.document)
        return Run(floor, cold, warm, run_ingest(self.unpacked, unpacked, jobs), member_changed)


def ingest_rows(source: Path, folder: Path, runs: int, jobs: int) -> tuple[list[Row], Path]:
    """Rows of the table, and a catalog of the corpus for further questions."""
    corpus = Corpus(source, folder)
    measured = [corpus.measure(folder, jobs) for _ in range(runs)]
    rows = [*_speed(corpus, measured), *memory_rows([run.cold for run in measured])]
    return [*rows, *_sizes(corpus.database, measured[0].floor)], corpus.database


def _speed(corpus: Corpus, runs: list[Run]) -> list[Row]:
    floor = runs[0].floor

    def ratio(chosen: Callable[[Run], Ran | None]) -> str:
        ran = [(chosen(run), run.floor.seconds) for run in runs]
        return f"{median(item.seconds / seconds for item, seconds in ran if item is not None):.2f}"

    def seconds(chosen: Callable[[Run], Ran | Floor]) -> str:
        wall, processor = (median(getattr(chosen(run), name) for run in runs) for name in Ran._fields[:2])
        return f"{wall:.2f} s ({processor:.2f} s of processor time)"

    words = f"floor: lxml parses {floor.document_count} documents, {floor.xml_bytes / 1e6:.0f} MB"
    rows = [
        Row(words, seconds(lambda run: run.floor)),
        Row("cold ingest into a new catalog", seconds(lambda run: run.cold)),
        Row("cold ingest / floor", ratio(lambda run: run.cold), f"<= {COLD_LIMIT}"),
        Row("warm ingest, nothing changed", seconds(lambda run: run.warm)),
        Row("warm ingest / floor", ratio(lambda run: run.warm), f"<= {WARM_LIMIT}"),
        Row(f"one of {floor.document_count} files changed", seconds(lambda run: run.document_changed)),
        Row("one file changed / floor", ratio(lambda run: run.document_changed), f"<= {CHANGED_LIMIT}"),
    ]
    if corpus.archive is not None:
        words = f"one of {corpus.member_count} members of the largest archive changed / floor"
        rows.append(Row(words, ratio(lambda run: run.member_changed)))
    return rows


def memory_rows(runs: list[Ran]) -> list[Row]:
    """Most memory that a process held."""
    limit = f"<= {MEMORY_LIMIT_MB} MB"
    return [
        Row("peak memory, writer", f"{max(ran.writer_mb for ran in runs):.0f} MB", limit),
        Row("peak memory, largest worker", f"{max(ran.worker_mb for ran in runs):.0f} MB", limit),
    ]


def _sizes(database: Path, floor: Floor) -> list[Row]:
    whole, bare = catalog_sizes(database)
    return [
        Row("catalog / XML bytes, full text included", f"{whole / floor.xml_bytes:.2f}"),
        Row("catalog / XML bytes, without full text", f"{bare / floor.xml_bytes:.2f}", f"<= {SIZE_LIMIT}"),
    ]


def catalog_sizes(database: Path) -> tuple[int, int]:
    """Bytes of a catalog, and of the same without its full-text index."""
    bare = database.with_suffix(".bare.db")
    shutil.copyfile(database, bare)
    with closing(sqlite3.connect(bare, isolation_level=None)) as connection:
        connection.execute(f"DROP TABLE {FULL_TEXT}")
        connection.execute("VACUUM")
    sizes = database.stat().st_size, bare.stat().st_size
    bare.unlink()
    return sizes
