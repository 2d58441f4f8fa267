"""A document of which something may be lost says so wherever its devices go; a misnamed encoding loses nothing."""

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from snippets import device, esi, pdo, rows, write
from test_export_cli import run
from test_pages import page

from esicatalog import Catalog, read_esi
from esicatalog.catalog.description import description_json
from esicatalog.cli.sheet import device_sheet_lines
from esicatalog.scan.front import read_scan

DRIVE = esi(device('<Sm StartAddress="#x1100">Outputs</Sm>' + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')))
CUT = DRIVE[: DRIVE.index("</Device>")]
UMLAUT = '<?xml version="1.0" encoding="UTF-8"?>' + DRIVE.replace("<Name>N<", "<Name>Gerät<")
WHOLE = {
    "well-formed": DRIVE.encode(),
    "another encoding": UMLAUT.encode("windows-1252"),
    "a declaration behind a blank": b" " + UMLAUT.encode(),
}
TARGETS = ("igh", "cstruct", "soem", "pysoem", "ros2", "linuxcnc", "sii", "esi")
WORDS = "cut.xml could not be read whole (Premature end of data in tag Device line 1, line 1, column "


def catalog_of(tmp_path: Path, documents: dict[str, str | bytes]) -> Path:
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([write(tmp_path / "library", documents)], jobs=1)
    return tmp_path / "c.db"


def told(db: Path) -> list[list[str]]:
    """What each door says of damage: identify, a scan, show as JSON and as text, what generators get."""
    with Catalog.open(db) as catalog:
        (bus,) = catalog.identify_scan(read_scan("0xe5c,1,1\n"))
        description, subject = catalog.device("0xe5c:1:1"), catalog.export_subject("0xe5c:1:1")
        said = [
            [*catalog.identify(0xE5C, 1, 1).as_json()["warnings"]],
            [*bus.slaves[0].notes],
            description_json(description, {})["warnings"],
            [*device_sheet_lines(description, {})],
            [subject.damage or ""],
        ]
    return [[line for line in lines if "could not be read whole" in line] for lines in said]


def test_every_door_tells_of_a_damaged_document(tmp_path):
    db = catalog_of(tmp_path, {"cut.xml": CUT})
    assert [[WORDS in line for line in lines] for lines in told(db)] == [[True]] * 5
    assert rows(db, "SELECT status, is_whole FROM sources") == [("recovered", 0)]
    with Catalog.open(db) as catalog:
        assert [item.is_whole for item in catalog.device("0xe5c:1:1").sources] == [False]


async def test_the_compare_page_tells_of_damage(tmp_path):
    db = catalog_of(tmp_path, {"cut.xml": CUT, "whole.xml": esi(device("", revision="#x2"))})
    for given, told_at in (("a=0xe5c:1:1&b=0xe5c:1:2", [True, False]), ("a=0xe5c:1:2&b=0xe5c:1:2", [])):
        tree = await page(db, f"/-/esi/compare?{given}")
        cells = [
            row.cssselect("td") for row in tree.cssselect("table.sides tbody tr") if "damaged" in row.text_content()
        ]
        assert [WORDS in cell.text_content() for row in cells for cell in row] == told_at


@pytest.mark.parametrize("content", WHOLE.values(), ids=list(WHOLE))
def test_a_document_that_lost_nothing_is_not_called_damaged(tmp_path, content):
    db = catalog_of(tmp_path, {"a.xml": content})
    assert told(db) == [[]] * 5
    assert rows(db, "SELECT is_whole FROM sources") == [(1,)]
    assert "could not be read" not in run("igh", "--esi", tmp_path / "library" / "a.xml").output


def test_a_whole_document_that_says_the_same_is_enough(tmp_path):
    """The description is the same; what is behind its end in the other does not count."""
    db = catalog_of(tmp_path, {"a.xml": DRIVE + "<more/>", "b.xml": DRIVE})
    assert rows(db, "SELECT count(*) FROM devices") == [(1,)]
    assert told(db) == [[]] * 5


@pytest.mark.parametrize("target", TARGETS)
def test_generated_files_and_stderr_tell_of_it_first(tmp_path, target):
    file = write(tmp_path, {"cut.xml": CUT}) / "cut.xml"
    from_file = run(target, "--esi", file)
    from_catalog = run(target, "0xe5c:1:1", db=catalog_of(tmp_path, {"cut.xml": CUT}))
    for made in (from_file, from_catalog):
        assert [line.startswith(f"esicatalog: {WORDS}") for line in made.stderr.splitlines()].count(True) == 1
        if target not in ("cstruct", "sii", "esi"):
            _, remarks = made.stdout.split("Remarks:\n")
            assert remarks.splitlines()[0].strip(" *#").startswith("- cut.xml could not be read whole (Premature")


def test_all_devices_of_a_vendor_are_told_of_once(tmp_path):
    second = device(revision="#x2")
    db = catalog_of(tmp_path, {"cut.xml": esi(second + device()).replace("</EtherCATInfo>", "")})
    made = run("esi", "--vendor", "0xe5c", db=db)
    assert [line for line in made.stderr.splitlines() if "could not be read whole" in line] == made.stderr.splitlines()
    assert len(made.stderr.splitlines()) == 1


def test_a_damaged_dictionary_file_is_the_damage_of_the_document_that_names_it(tmp_path):
    whole = "<EtherCATDict><Dictionary><DataTypes/><Objects/></Dictionary></EtherCATDict>"
    text = esi(device("<Profile><DictionaryFile>d.xml</DictionaryFile></Profile>"))
    for number, (content, words) in enumerate(
        [(whole, []), (whole[:-10], ["a.xml could not be read whole (a document that it refers to is damaged)"])]
    ):
        folder = tmp_path / str(number)
        folder.mkdir()
        db = catalog_of(folder, {"a.xml": text, "d.xml": content})
        assert [line.partition(":")[0] for line in told(db)[0]] == words
        assert (read_esi(folder / "library" / "a.xml").document.damage("a.xml") or "").startswith("".join(words))


def test_what_a_catalog_of_before_does_not_know_counts_as_damage(tmp_path):
    db = catalog_of(tmp_path, {"cut.xml": CUT, "whole.xml": esi(device(product="#x2"))})
    with closing(sqlite3.connect(db)) as connection, connection:
        connection.execute("UPDATE sources SET is_whole = NULL")
    assert [len(lines) for lines in told(db)] == [1] * 5
    with Catalog.open(db) as catalog:
        assert catalog.identify(0xE5C, 2, 1).warnings == ()
