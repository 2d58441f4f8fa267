"""How long the questions of ``esicatalog devices`` take in a running process, beside a bare parse of the documents.

    python benchmarks/queries.py [CORPUS] [--db CATALOG]

Every question is asked through the Python interface, SQL and evidence included, after one call that fills the caches;
the table shows medians of 21 calls. Without ``--db`` the corpus is ingested first.
"""

import argparse
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any

from ingest import default_corpus

from esicatalog import Catalog
from esicatalog.identity import Bounds

CALLS = 21
LIMITS_MS = {"--mode CSV --sync sync1": 20.0}
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


def median_ms(catalog: Catalog, question: dict[str, Any]) -> tuple[float, int]:
    """Median of the calls in milliseconds, and how many devices were found."""
    found = catalog.devices(**question)
    taken = []
    for _ in range(CALLS):
        started = time.perf_counter()
        catalog.devices(**question)
        taken.append(time.perf_counter() - started)
    return statistics.median(taken) * 1000, len(found)


def main() -> None:
    """Ask and print."""
    parser = argparse.ArgumentParser(description="Measure the questions of esicatalog devices.")
    parser.add_argument("corpus", nargs="?", type=Path, default=default_corpus(), help="what to ingest")
    parser.add_argument("--db", type=Path, help="a catalog that is there already")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        database = given.db or Path(folder, "catalog.db")
        with Catalog.open(database, create=given.db is None) as catalog:
            if given.db is None:
                catalog.ingest([given.corpus])
            for words, question in QUESTIONS.items():
                milliseconds, count = median_ms(catalog, question)
                limit = f"<= {LIMITS_MS[words]:.0f} ms" if words in LIMITS_MS else ""
                print(f"{words:<28} {count:>5} devices {milliseconds:>8.2f} ms  {limit}")


if __name__ == "__main__":
    main()
