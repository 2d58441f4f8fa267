"""The generated files are up to date, and the README shows what is answered."""

import re
import subprocess
import sys
from pathlib import Path

from snippets import rows

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
