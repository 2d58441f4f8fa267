"""A kill at any moment leaves a consistent catalog, and running again gives what an undisturbed run gives.

Some kills in every test run, many with ``make faults``. The moments are random within the length of an ingest.
"""

import random
import shutil
import subprocess
import time
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

import pytest
from library import (
    SEED,
    all_end,
    assert_completed_by_running_again,
    assert_consistent,
    change_library,
    ingest_command,
    ingested,
    kill,
    make_library,
    started,
)
from snippets import one, rows

from esicatalog import Catalog

TARGETS = ("group", "parent", "worker")


class Case(NamedTuple):
    """An ingest: of what, into which catalog (None = a new one), how long it takes, and what it should give."""

    words: tuple[object, ...]
    before: Path | None
    seconds: float
    expected: str


def case(measured: Path, *words: object, before: Path | None = None) -> Case:
    """Measure an undisturbed run of the very command that is killed later."""
    if before is not None:
        shutil.copy(before, measured)
    begun = time.monotonic()
    subprocess.run(ingest_command(measured, *words), check=False, capture_output=True)
    seconds = time.monotonic() - begun
    with Catalog.open(measured) as catalog:
        result = catalog.check()
    assert result.problems == []
    return Case(words, before, seconds, result.content_hash)


def new_and_changed(folder: Path, documents: int) -> dict[str, Case]:
    """A first ingest, and one into a catalog of the same folder as it was before."""
    library = make_library(folder / "old", documents)
    # Locations are part of a catalog's memory.
    changed = Path(shutil.copytree(library, folder / "changed"))
    kept = folder / "kept.db"
    ingested(kept, changed)
    change_library(changed, documents)
    return {
        "new": case(folder / "new.db", library),
        "changed": case(folder / "whole.db", changed, "--prune", before=kept),
    }


def survive(case: Case, folder: Path, moment: float, target: str) -> None:
    """Kill an ingest after this part of its length; the catalog is consistent and completed by running again."""
    print(f"ESICATALOG_SEED={SEED}: {target} killed after {moment * case.seconds:.3f} s")
    db = folder / "c.db"
    if case.before is not None:
        shutil.copy(case.before, db)
    process = started(*ingest_command(db, *case.words))
    with suppress(subprocess.TimeoutExpired):
        process.wait(moment * case.seconds)
    workers = kill(process, target)
    said = process.communicate()[1]
    assert "Traceback" not in said
    assert all_end(workers), "workers outlive the process that they read for"
    assert_consistent(db)
    if case.before is not None:
        stored = "SELECT count(*) FROM sources WHERE member IN (SELECT value FROM json_each(?))"
        kept = [f'"{number:04d}.xml"' for number in (2, 3, 6, 7, 10)]
        assert one(db, stored, f"[{','.join(kept)}]") == len(kept)
    assert_completed_by_running_again(db, case.expected, *case.words)


@pytest.fixture(scope="module")
def small(tmp_path_factory) -> dict[str, Case]:
    return new_and_changed(tmp_path_factory.mktemp("small"), 24)


@pytest.mark.parametrize(
    ("kind", "moment", "target"),
    [
        ("new", 0.45, "group"),
        pytest.param("new", 0.7, "parent", marks=pytest.mark.faults),
        pytest.param("new", 0.6, "worker", marks=pytest.mark.faults),
        pytest.param("changed", 0.5, "group", marks=pytest.mark.faults),
        pytest.param("changed", 0.75, "group", marks=pytest.mark.faults),
        ("changed", 0.6, "parent"),
    ],
)
def test_a_killed_ingest_is_completed_by_the_next(tmp_path, small, kind, moment, target):
    survive(small[kind], tmp_path, moment, target)


def test_a_killed_ingest_has_stored_what_it_had_committed(tmp_path):
    """The last committed state is what the next run goes on from: it reads only the rest."""
    library = make_library(tmp_path / "library", 120)
    db = tmp_path / "c.db"
    process = started(*ingest_command(db, library))
    while process.poll() is None and not (db.exists() and stored(db)):
        time.sleep(0.01)
    kill(process, "group")
    process.communicate()
    kept = stored(db)
    done = subprocess.run([*ingest_command(db, library), "--format", "json"], capture_output=True, text=True)
    assert 0 < kept < 120
    assert f'"unchanged":{kept}' in done.stdout.replace(" ", "")


def stored(db: Path) -> int:
    """Documents that are unchanged for the next run, as far as one can look while an ingest is writing."""
    with suppress(Exception):
        return int(one(db, "SELECT count(*) FROM sources WHERE status IN ('stored', 'recovered')"))
    return 0


MANY = 50


@pytest.fixture(scope="module")
def large(tmp_path_factory) -> dict[str, Case]:
    return new_and_changed(tmp_path_factory.mktemp("large"), 400)


def moments(name: str) -> list[tuple[float, str]]:
    chosen = random.Random(f"{SEED} {name}")
    return [(round(chosen.uniform(0.05, 1.05), 3), chosen.choice(TARGETS)) for _ in range(MANY)]


@pytest.mark.faults
@pytest.mark.parametrize(("moment", "target"), moments("new"))
def test_kills_of_a_first_ingest(tmp_path, large, moment, target):
    survive(large["new"], tmp_path, moment, target)


@pytest.mark.faults
@pytest.mark.parametrize(("moment", "target"), moments("changed"))
def test_kills_of_a_later_ingest(tmp_path, large, moment, target):
    survive(large["changed"], tmp_path, moment, target)


@pytest.fixture(scope="module")
def real(tmp_path_factory, corpus) -> Case:
    return case(tmp_path_factory.mktemp("real") / "whole.db", corpus / "esi")


@pytest.mark.faults
@pytest.mark.parametrize(("moment", "target"), moments("real")[:10])
def test_kills_of_an_ingest_of_real_archives(tmp_path, real, moment, target):
    survive(real, tmp_path, moment, target)


@pytest.mark.faults
@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="needs /proc to find the workers")
def test_a_dead_worker_costs_one_document_which_is_read_the_next_time(tmp_path, small):
    db = tmp_path / "c.db"
    process = started(*ingest_command(db, *small["new"].words))
    while process.poll() is None and not kill(process, "worker"):
        time.sleep(0.005)
    out, said = process.communicate()
    assert process.returncode == 1
    assert "Traceback" not in said
    failed = [line for line in out.splitlines() if line.startswith("failed") and "broken.xml" not in line]
    assert len(failed) <= 1
    assert_completed_by_running_again(db, small["new"].expected, *small["new"].words)
    assert rows(db, "SELECT member FROM sources WHERE status = 'failed'") == [("broken.xml",)]
