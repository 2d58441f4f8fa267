"""Every door says of a catalog whose ingest has not come to its end that what is missing may be described."""

import json
import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from snippets import write
from test_cli import run
from test_pages import page, texts

from esicatalog import Catalog
from esicatalog.catalog.unfinished import CUT_SHORT

LINE = f"esicatalog: {CUT_SHORT}"
DRIVE = "0x1097:0x2406:0x8f"


def changed(db: Path, tmp_path: Path, statement: str) -> Path:
    copy = Path(shutil.copy(db, tmp_path / "changed.db"))
    with closing(sqlite3.connect(copy)) as connection, connection:
        connection.execute(statement)
    return copy


@pytest.fixture
def cut_short(data_db, tmp_path) -> Path:
    """As the first commit of an ingest leaves it: the hashes are gone until its end."""
    return changed(data_db, tmp_path, "DELETE FROM catalog_state WHERE key IN ('content_hash', 'state_hash')")


@pytest.mark.parametrize(
    "words",
    [
        ("devices", "--mode", "CSV"),
        ("identify", *DRIVE.split(":")),
        ("identify", "0x999", "1", "1"),
        ("show", DRIVE),
        ("show", "0x999:1"),
        ("export", "igh", DRIVE),
        ("export", "esi", "--vendor", "0x1097"),
        ("diff", DRIVE, DRIVE),
        ("lint",),
    ],
)
def test_commands_say_so_in_one_line_on_stderr(data_db, cut_short, words):
    complete, told = run(*words, db=data_db), run(*words, db=cut_short)
    assert told.stderr.splitlines()[0] == LINE
    assert told.stderr.splitlines()[1:] == complete.stderr.splitlines()
    assert (told.exit_code, told.stdout) == (complete.exit_code, complete.stdout)


def test_a_scan_and_an_image_are_answered_with_it(cut_short, tmp_path):
    (tmp_path / "scan.csv").write_text("0x1097,0x2406,0x8f\n")
    told = run("identify", "--slaves", tmp_path / "scan.csv", "--format", "json", db=cut_short)
    assert (told.stderr.splitlines(), json.loads(told.stdout)[0]["match"]) == ([LINE], "exact")
    run("export", "sii", DRIVE, "-o", tmp_path / "e.bin", db=cut_short)
    assert run("sii", "verify", tmp_path / "e.bin", db=cut_short).stderr.splitlines() == [LINE]


async def test_pages_say_so(data_db, cut_short):
    for path, status in (("/-/esi/", 200), ("/-/esi/device/0x1097/0x2406/0x8f", 200), ("/-/esi/device/9/9/9", 404)):
        assert texts(await page(cut_short, path, status), "main > p.problem")[0] == CUT_SHORT
    assert texts(await page(data_db, "/-/esi/"), "main > p.problem") == []


def test_a_load_into_a_new_catalog_is_told_and_an_empty_catalog_is_complete(data_db, tmp_path):
    pending = changed(data_db, tmp_path, "INSERT INTO catalog_state VALUES ('indexes_pending', '1')")
    assert run("devices", db=pending).stderr.splitlines()[0] == LINE
    with Catalog.open(tmp_path / "new.db", create=True) as catalog:
        assert not catalog.is_unfinished()
        catalog.ingest([write(tmp_path / "none", {"readme.txt": "no ESI"})], jobs=1)
        assert not catalog.is_unfinished()
