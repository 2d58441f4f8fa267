"""The generated files are up to date, and the README shows what is answered."""

import re
import subprocess
import sys
from pathlib import Path

import pytest
from snippets import rows

from docs.derived import forgotten_version
from esicatalog import Catalog
from esicatalog.model.cia402 import DRIVE_MODES

ROOT = Path(__file__).parent.parent
ESI_FACTS = (ROOT / "docs/esi-facts.md").read_text(encoding="utf-8")
_SECTION = r"\d+(?:\.\d+)?"
_CITATION = re.compile(rf"ESI-FACTS(?:\s+sections?)?\s+({_SECTION}(?:(?:,|\s+and|,\s+and)\s+{_SECTION})*)")


def test_generated_files_are_up_to_date():
    done = subprocess.run(
        [sys.executable, ROOT / "docs/generate.py", "--check"], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")


def test_the_sql_of_the_readme_gives_what_it_shows(data_db):
    """In the order shown: a query without ORDER BY leaves it to the indexes."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    ((sql, shown),) = re.findall(r'\$ sqlite3 catalog\.db "([^"]*)"\n(.*?)```', readme, re.DOTALL)
    assert "ORDER BY" in sql
    assert ["|".join(map(str, row)) for row in rows(data_db, sql)] == shown.splitlines()


def test_every_section_that_code_cites_is_a_heading_of_the_esi_facts():
    headings = set(re.findall(rf"^##+ ({_SECTION})\.? ", ESI_FACTS, re.MULTILINE))
    texts = {
        path: path.read_text(encoding="utf-8")
        for folder in ("esicatalog", "tests")
        for path in sorted((ROOT / folder).rglob("*.py"))
        if path != Path(__file__)
    }
    cited = {path: _CITATION.findall(text) for path, text in texts.items()}
    assert [path for path, text in texts.items() if len(cited[path]) != text.count("ESI-FACTS")] == []
    numbers = {number for found in cited.values() for listed in found for number in re.findall(_SECTION, listed)}
    assert numbers >= {"0.5", "9", "12.1", "18"}
    assert numbers - headings == set()


def test_the_modes_in_the_esi_facts_are_those_of_the_program():
    section = ESI_FACTS[ESI_FACTS.index("## 16. ") : ESI_FACTS.index("## 17. ")]
    table = re.findall(r"^\| ([A-Z]+) \| (\d+) \|([^|]*)\|([^|]*)\|$", section, re.MULTILINE)
    told = [
        (name, int(code), *(tuple(int(index, 16) for index in cell.split()) for cell in cells))
        for name, code, *cells in table
    ]
    assert told == [(mode.name, mode.code, mode.setpoints, mode.companions) for mode in DRIVE_MODES.values()]


DERIVED = "schema 0011\ndocuments 1\nview device_overview 2\nrows of device_search, FTS5 3\n"


@pytest.mark.parametrize(
    ("now", "named"),
    [
        (DERIVED.replace(" 2", " 4"), "view device_overview"),
        (DERIVED.replace(" 2", " 4").replace(" 3", " 5"), "rows of device_search, FTS5, view device_overview"),
        (DERIVED + "view new 6\n", "view new"),
        (DERIVED.replace("view device_overview 2\n", ""), "view device_overview"),
    ],
)
def test_what_is_derived_changes_with_the_version_of_the_schema(now, named):
    message = forgotten_version(DERIVED, now)
    assert message is not None
    assert f"changed under schema 0011: {named}. " in message
    assert forgotten_version(DERIVED, now.replace("0011", "0012")) is None


def test_of_other_documents_other_things_are_derived():
    assert forgotten_version(DERIVED, DERIVED) is None
    assert forgotten_version(DERIVED, DERIVED.replace("documents 1", "documents 2").replace(" 3", " 4")) is None


def test_the_documents_of_that_have_what_versions_have_changed(tmp_path):
    """Makers that share a vendor id, hidden revisions, variants, FSoE by names, sizes that are not known."""
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([ROOT / "tests" / "derived"], jobs=1)
    query = (
        "SELECT d.product_code, d.revision_no, d.variant, d.hidden, d.own_vendor_name, f.output_bytes, f.fsoe "
        "FROM devices d JOIN device_facts f ON f.device_id = d.id ORDER BY 1, 2, 3"
    )
    assert rows(tmp_path / "c.db", query) == [
        (0x10, 1, 1, 1, None, None, None),
        (0x10, 2, 1, 0, None, None, "medium"),
        (0x11, 1, 1, 1, None, None, None),
        (0x12, 1, 1, 0, None, 4, None),
        (0x12, 1, 2, 0, None, 4, None),
        (0x20, 1, 1, 0, "Unrelated Robots", 0, None),
    ]
    searched = "SELECT vendor FROM device_search WHERE type = ?"
    assert rows(tmp_path / "c.db", searched, "ED12")[0] == ("Beispielantriebe Example Drives",)
    assert rows(tmp_path / "c.db", searched, "UR20") == [("Unrelated Robots",)]


def test_the_python_example_of_the_readme_finds_something_in_the_example_files(data_db):
    example = (ROOT / "README.md").read_text(encoding="utf-8").partition("```python\n")[2].partition("```")[0]
    lines = [line.strip() for line in example.splitlines() if "= catalog." in line]
    with Catalog.open(data_db) as catalog:
        found: dict = {"catalog": catalog}
        exec("\n".join(lines), found)
    assert (found["answer"].match, len(found["drives"]), len(found["sheet"].device.rx_pdos)) == ("exact", 3, 2)
