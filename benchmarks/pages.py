"""Device pages: how heavy they are, and how long the server takes, over all devices of a catalog.

    python benchmarks/pages.py [CORPUS] [--db CATALOG] [--devices 300]

The weight is that of the page with its style sheet and script, images left out. Time is from request to answer in the
server's own process, after one page that fills the caches. Without ``--db`` the corpus is ingested first.
"""

import argparse
import asyncio
import logging
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any

from identify import identities
from ingest import default_corpus

from esicatalog import Catalog
from esicatalog.web.app import datasette_app

WEIGHT_LIMIT_KB, TIME_LIMIT_MS = 300, 100
ASSETS = Path(__file__).parent.parent / "esicatalog/web/plugin/static"


async def measure(database: Path, wanted: list[Any]) -> tuple[list[float], list[float]]:
    """Kilobytes and milliseconds of each page."""
    application = datasette_app(database)
    await application.invoke_startup()
    assets = sum((ASSETS / name).stat().st_size for name in ("pages.css", "pages.js"))
    await application.client.get("/-/esi/")
    kilobytes, milliseconds = [], []
    for vendor, product, revision in wanted:
        started = time.perf_counter()
        response = await application.client.get(f"/-/esi/device/{vendor}/{product}/{revision}")
        milliseconds.append((time.perf_counter() - started) * 1000)
        assert response.status_code == 200, response.text
        kilobytes.append((len(response.content) + assets) / 1000)
    return kilobytes, milliseconds


def main() -> None:
    """Ask and print."""
    parser = argparse.ArgumentParser(description="Measure device pages.")
    parser.add_argument("corpus", nargs="?", type=Path, default=default_corpus(), help="what to ingest")
    parser.add_argument("--db", type=Path, help="a catalog that is there already")
    parser.add_argument("--devices", type=int, default=300, help="how many devices, evenly chosen")
    given = parser.parse_args()
    logging.disable(logging.INFO)
    with tempfile.TemporaryDirectory() as folder:
        database = given.db or Path(folder, "catalog.db")
        if given.db is None:
            with Catalog.open(database, create=True) as catalog:
                catalog.ingest([given.corpus])
        known = identities(database)
        kilobytes, milliseconds = asyncio.run(measure(database, known[:: max(1, len(known) // given.devices)]))
        weight, pace = statistics.quantiles(kilobytes, n=20), statistics.quantiles(milliseconds, n=20)
        print(f"{len(kilobytes)} device pages")
        print(f"weight, median {weight[9]:>6.0f} kB   95 % {weight[18]:>6.0f} kB  <= {WEIGHT_LIMIT_KB} kB")
        print(f"time,   median {pace[9]:>6.1f} ms  95 % {pace[18]:>6.1f} ms  median <= {TIME_LIMIT_MS} ms")


if __name__ == "__main__":
    main()
