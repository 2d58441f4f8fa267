"""Everything that is measured on real files, in one table: ``make bench``.

    python benchmarks/run.py [CORPUS] [--runs 5] [--jobs N] [--write docs/performance.md]

Ingests are medians over the runs, with a new catalog each.
"""

import argparse
import os
import tempfile
from pathlib import Path

from corpus import default_corpus
from identify import lookup_rows
from ingest import ingest_rows
from pages import page_rows
from processes import compile_package
from questions import question_rows
from report import machine, publish, table


def main() -> None:
    """Measure, print, and write where asked."""
    parser = argparse.ArgumentParser(description="Measure ingest, lookups, questions and pages on real files.")
    parser.add_argument("corpus", nargs="?", type=Path, default=default_corpus(), help="folder of ESI files")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--write", type=Path, metavar="DOCUMENT", help="put the table between its marks in a document")
    given = parser.parse_args()
    compile_package()
    with tempfile.TemporaryDirectory() as folder:
        rows, database = ingest_rows(given.corpus, Path(folder), given.runs, given.jobs)
        rows += [*lookup_rows(database), *question_rows(database), *page_rows(database)]
    words = f"Medians of {given.runs} runs, {given.jobs} workers; {machine()}"
    publish("real files", f"{table(rows)}\n\n{words}", given.write)


if __name__ == "__main__":
    main()
