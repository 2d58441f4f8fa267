"""A kill at any moment leaves a consistent catalog, and running again completes it."""

import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest
from snippets import device, esi, pdo, rows, write

from esicatalog import Catalog
from esicatalog.catalog.check import CUT_SHORT
from esicatalog.catalog.database import open_catalog

STALE = CUT_SHORT
"""All that ``check`` may complain about after a kill."""


def command(db: Path, *inputs: Path) -> list[str]:
    return [sys.executable, "-m", "esicatalog", "ingest", *map(str, inputs), "--db", str(db), "--jobs", "2"]


def undisturbed(db: Path, *inputs: Path) -> str:
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest(inputs, jobs=2)
        return catalog.check().content_hash


def size_of_an_empty_catalog(folder: Path) -> int:
    open_catalog(folder / "empty.db", create=True).dispose()
    return (folder / "empty.db").stat().st_size


def killed_while_writing(db: Path, moment: float, *inputs: Path) -> None:
    """Start an ingest, wait until the catalog holds more than its tables, and kill it some time later."""
    empty = size_of_an_empty_catalog(db.parent)
    process = subprocess.Popen(command(db, *inputs), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while process.poll() is None and not (db.exists() and db.stat().st_size > empty):
        time.sleep(0.005)
    with suppress(subprocess.TimeoutExpired):
        process.wait(moment)
    process.kill()
    process.wait()


def assert_sound_and_completed(db: Path, expected: str, *inputs: Path) -> None:
    with Catalog.open(db) as catalog:
        problems = catalog.check().problems
    assert [problem for problem in problems if problem != STALE] == []
    assert rows(db, "PRAGMA foreign_key_check") == []
    subprocess.run(command(db, *inputs), check=False, capture_output=True)
    with Catalog.open(db) as catalog:
        result = catalog.check()
    assert (result.problems, result.content_hash) == ([], expected)


@pytest.fixture(scope="module")
def library(tmp_path_factory) -> Path:
    """Enough documents that an ingest takes about a second."""
    folder = tmp_path_factory.mktemp("library")
    for number in range(40):
        entries = [1 + (number + bit) % 16 for bit in range(250)]
        content = "".join(
            device(pdo("RxPdo", "#x1600", *entries), product=f"#x{number:X}", revision=f"#x{n:X}") for n in range(6)
        )
        write(folder, {f"{number}.xml": esi(content)})
    return folder


@pytest.fixture(scope="module")
def library_hash(tmp_path_factory, library) -> str:
    return undisturbed(tmp_path_factory.mktemp("whole") / "whole.db", library)


@pytest.mark.parametrize("moment", [0.0, 0.2, 0.6])
def test_a_killed_ingest_is_completed_by_the_next(tmp_path, library, library_hash, moment):
    killed_while_writing(tmp_path / "c.db", moment, library)
    assert_sound_and_completed(tmp_path / "c.db", library_hash, library)


@pytest.mark.corpus
@pytest.mark.parametrize("moment", [0.5, 2.0, 4.0])
def test_a_killed_ingest_of_real_archives(tmp_path, corpus, corpus_db, moment):
    with Catalog.open(corpus_db) as catalog:
        expected = catalog.check().content_hash
    killed_while_writing(tmp_path / "c.db", moment, corpus / "esi")
    assert_sound_and_completed(tmp_path / "c.db", expected, corpus / "esi")


def test_a_kill_while_something_is_added_keeps_what_was_there(tmp_path, library):
    more = write(tmp_path / "more", {"a.xml": esi(device(product="#xABC"))})
    expected = undisturbed(tmp_path / "whole.db", library, more)
    undisturbed(tmp_path / "c.db", more)
    killed_while_writing(tmp_path / "c.db", 0.5, library, more)
    assert rows(tmp_path / "c.db", "SELECT count(*) FROM devices WHERE product_code = 2748") == [(1,)]
    assert_sound_and_completed(tmp_path / "c.db", expected, library, more)
