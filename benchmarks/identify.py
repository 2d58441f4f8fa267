"""How many identities a second: from Python in one process, and over HTTP from a server on one core.

    python benchmarks/identify.py [CORPUS] [--db CATALOG]

All identities of the catalog are asked for in turn, so nothing is answered from a cache of answers: the first pass
and the passes after it are shown apart. The HTTP client keeps one connection open; on Linux the server is bound to
one core. Without ``--db`` the corpus is ingested first.
"""

import argparse
import contextlib
import http.client
import os
import sqlite3
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

from ingest import default_corpus

from esicatalog import Catalog

PASSES = 5
PYTHON_LIMIT, HTTP_LIMIT = 20_000, 200
REQUESTS = 2_000

Numbers = tuple[int, int, int]


def identities(database: Path) -> list[Numbers]:
    """Every identity of the catalog once."""
    with closing(sqlite3.connect(database)) as connection:
        query = "SELECT vendor_id, product_code, revision_no FROM devices WHERE variant = 1"
        return [row for row in connection.execute(query) if None not in row]


def python_rates(database: Path, wanted: list[Numbers]) -> list[float]:
    """Answers a second of each pass over all identities."""
    rates = []
    with Catalog.open(database) as catalog:
        for _ in range(PASSES):
            started = time.perf_counter()
            for numbers in wanted:
                catalog.identify(*numbers)
            rates.append(len(wanted) / (time.perf_counter() - started))
    return rates


@contextlib.contextmanager
def server(database: Path) -> Iterator[tuple[str, int]]:
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
    with server(database) as (host, port):
        connection = http.client.HTTPConnection(host, port)
        _ask(connection, wanted[0])
        started = time.perf_counter()
        for number in range(REQUESTS):
            _ask(connection, wanted[number * 7 % len(wanted)])
        return REQUESTS / (time.perf_counter() - started)


def _ask(connection: http.client.HTTPConnection, numbers: Numbers) -> None:
    vendor, product, revision = numbers
    connection.request("GET", f"/-/esi/identify.json?vendor={vendor}&product={product}&revision={revision}")
    response = connection.getresponse()
    response.read()
    assert response.status == 200, response.status


def main() -> None:
    """Ask and print."""
    parser = argparse.ArgumentParser(description="Measure identity lookups from Python and over HTTP.")
    parser.add_argument("corpus", nargs="?", type=Path, default=default_corpus(), help="what to ingest")
    parser.add_argument("--db", type=Path, help="a catalog that is there already")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        database = given.db or Path(folder, "catalog.db")
        if given.db is None:
            with Catalog.open(database, create=True) as catalog:
                catalog.ingest([given.corpus])
        wanted = identities(database)
        first, *later = python_rates(database, wanted)
        print(f"{len(wanted)} identities")
        print(f"Python, first pass      {first:>8.0f} per second")
        print(f"Python, later passes    {statistics.median(later):>8.0f} per second  >= {PYTHON_LIMIT}")
        print(f"HTTP, server on a core  {http_rate(database, wanted):>8.0f} per second  >= {HTTP_LIMIT}")


if __name__ == "__main__":
    main()
