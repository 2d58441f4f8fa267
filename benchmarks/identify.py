"""How many identities a second: in SQL, from Python in one process, and over HTTP from a server on one core.

    python benchmarks/identify.py CATALOG

All identities of the catalog are asked for in turn, in any order. What was read of a product is kept while nobody
changes the catalog, so later passes ask the database for documents and lines only. The HTTP client keeps one connection
open; on Linux the server is bound to one core.
"""

import argparse
import contextlib
import http.client
import os
import random
import sqlite3
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import closing
from itertools import cycle, islice
from pathlib import Path

from report import Row, table

from esicatalog import Catalog

SQL_LIMIT_US, PYTHON_LIMIT, HTTP_LIMIT = 50, 20_000, 200
EXACT = (
    "SELECT id, type, name, hidden FROM devices "
    "WHERE vendor_id = ? AND product_code = ? AND revision_no = ? AND variant = 1"
)
_PASSES = 5
_MOST_ASKED = 20_000
_REQUESTS = 2_000

Numbers = tuple[int, int, int]


def identities(database: Path) -> list[Numbers]:
    """Every identity of the catalog once, in any order; not vendor 0 and product 0, which are none."""
    with closing(sqlite3.connect(database)) as connection:
        query = "SELECT vendor_id, product_code, revision_no FROM devices WHERE variant = 1"
        found = [row for row in connection.execute(query) if None not in row and any(row[:2])]
    random.Random(1).shuffle(found)
    return found[:_MOST_ASKED]


def lookup_rows(database: Path) -> list[Row]:
    """Rows of the table."""
    wanted = identities(database)
    first, later = python_microseconds(database, wanted)
    return [
        Row(
            f"exact lookup in SQL, {len(wanted):,} identities",
            f"{sql_microseconds(database, wanted):.1f} µs",
            f"<= {SQL_LIMIT_US} µs",
        ),
        Row(
            "Catalog.identify, first pass / later ones",
            f"{1e6 / first:,.0f} / {1e6 / later:,.0f} a second",
            f">= {PYTHON_LIMIT:,}",
        ),
        Row(
            "identify.json over HTTP, server on one core",
            f"{http_rate(database, wanted):,.0f} a second",
            f">= {HTTP_LIMIT}",
        ),
    ]


def sql_microseconds(database: Path, wanted: list[Numbers]) -> float:
    """Median over passes of the time of one statement, after a first pass that fills the page cache."""
    with closing(sqlite3.connect(database)) as connection:

        def ask(numbers: Numbers) -> None:
            connection.execute(EXACT, numbers).fetchall()

        _microseconds(ask, wanted)
        return statistics.median(_microseconds(ask, wanted) for _ in range(_PASSES))


def python_microseconds(database: Path, wanted: list[Numbers]) -> tuple[float, float]:
    """Time of one answer in the first pass over all identities, and the median of the later passes."""
    with Catalog.open(database) as catalog:
        first, *later = (_microseconds(lambda numbers: catalog.identify(*numbers), wanted) for _ in range(_PASSES))
    return first, statistics.median(later)


def _microseconds(ask: Callable[[Numbers], object], wanted: Iterable[Numbers]) -> float:
    started, count = time.perf_counter(), 0
    for numbers in wanted:
        ask(numbers)
        count += 1
    return (time.perf_counter() - started) * 1e6 / count


@contextlib.contextmanager
def _server(database: Path) -> Iterator[tuple[str, int]]:
    """``esicatalog serve`` in a process of its own, on one core where that can be said."""
    command = [sys.executable, "-m", "esicatalog", "serve", "--db", str(database), "--port", "0"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        if hasattr(os, "sched_setaffinity"):
            os.sched_setaffinity(process.pid, {min(os.sched_getaffinity(0))})
        assert process.stdout is not None
        host, _, port = process.stdout.readline().strip().removeprefix("http://").partition("/")[0].partition(":")
        yield host, int(port)
    finally:
        process.terminate()
        process.wait()


def http_rate(database: Path, wanted: list[Numbers]) -> float:
    """Requests a second over one connection."""
    with _server(database) as (host, port):
        connection = http.client.HTTPConnection(host, port)

        def ask(numbers: Numbers) -> None:
            vendor, product, revision = numbers
            connection.request("GET", f"/-/esi/identify.json?vendor={vendor}&product={product}&revision={revision}")
            response = connection.getresponse()
            response.read()
            assert response.status == 200, response.status

        ask(wanted[0])
        return 1e6 / _microseconds(ask, islice(cycle(wanted), _REQUESTS))


def main() -> None:
    """Measure on a catalog, print."""
    parser = argparse.ArgumentParser(description="Measure lookups of identities.")
    parser.add_argument("catalog", type=Path, help="an SQLite catalog")
    print(table(lookup_rows(parser.parse_args().catalog)))


if __name__ == "__main__":
    main()
