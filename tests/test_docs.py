"""The generated files are up to date, and the README shows what is answered."""

import re
import subprocess
import sys
from pathlib import Path

from snippets import rows

ROOT = Path(__file__).parent.parent


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
