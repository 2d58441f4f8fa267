"""How long the questions of ``esicatalog devices`` and the canned queries of Datasette take in a running process.

Every question is asked through the Python interface, SQL and evidence included, after one call that fills the caches.
"""

import re
import sqlite3
import statistics
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import yaml
from datasette.utils import escape_fts
from report import Row

from esicatalog import Catalog
from esicatalog.identity import Bounds
from esicatalog.resources import resource
from esicatalog.web.functions import add_functions

LIMIT_MS = 50.0
_CALLS = 11
QUESTIONS: dict[str, dict[str, Any]] = {
    "--mode CSV --sync sync1": {"modes": ["CSV"], "sync": "sync1"},
    "--mode CSP --strict": {"modes": ["CSP"], "strict": True},
    "--sync sync1": {"sync": "sync1"},
    "--protocol foe": {"protocol": "foe"},
    "--protocol fsoe": {"protocol": "fsoe"},
    "--maps 0x60FF": {"maps": [(0x60FF, None)]},
    "--object 0x6502": {"objects": [(0x6502, None)]},
    "--bytes-in <=8 --needs-dc": {"bytes_in": Bounds(None, 8), "needs_dc": True},
    "--text drive": {"text": "drive"},
    "--profile 402": {"profile_no": 402},
}
_PARAMETERS = {"text": "drive", "protocol": "foe", "index": "0x6040", "mode": "CSV"}
"""Values of parameters of canned queries; the others are left empty, which asks for everything."""


def median_ms(ask: Callable[[], object], calls: int = _CALLS) -> float:
    """Median time of a call in milliseconds."""
    taken = []
    for _ in range(calls):
        started = time.perf_counter()
        ask()
        taken.append(time.perf_counter() - started)
    return statistics.median(taken) * 1000


def question_rows(database: Path) -> list[Row]:
    """Rows of the table."""
    rows = []
    with Catalog.open(database) as catalog:
        for words, question in QUESTIONS.items():
            count = len(catalog.devices(**question))
            milliseconds = median_ms(lambda question=question: catalog.devices(**question))
            rows.append(Row(f"devices {words}, {count:,} found", f"{milliseconds:.1f} ms", f"<= {LIMIT_MS:.0f} ms"))
    taken = canned_ms(database)
    slowest = max(taken, key=lambda name: taken[name])
    words = f"{len(taken)} canned queries, median / slowest ({slowest})"
    return [*rows, Row(words, f"{statistics.median(taken.values()):.1f} / {taken[slowest]:.1f} ms")]


def canned_ms(database: Path) -> dict[str, float]:
    """Time of each canned query of the Datasette metadata, all rows fetched."""
    metadata = yaml.safe_load(resource("datasette-metadata.yml").read_text("utf-8"))
    with closing(sqlite3.connect(database)) as connection:
        add_functions(connection)
        connection.create_function("escape_fts", 1, escape_fts)
        return {
            name: median_ms(lambda sql=query["sql"]: connection.execute(sql, _values(sql)).fetchall(), 3)
            for name, query in metadata["databases"]["catalog"]["queries"].items()
        }


def _values(sql: str) -> dict[str, str]:
    return {name: _PARAMETERS.get(name, "") for name in re.findall(r":(\w+)", sql)}
