"""How heavy and how slow device pages are: every page of the catalog or an even choice of them, through the server."""

import asyncio
import logging
import statistics
import time
from pathlib import Path

from identify import Numbers, identities
from report import Row

from esicatalog.web.app import datasette_app

WEIGHT_LIMIT_KB, TIME_LIMIT_MS = 300, 100
_PAGES = 300
_ASSETS = Path(__file__).parent.parent / "esicatalog/web/plugin/static"


async def _measure(database: Path, wanted: list[Numbers]) -> tuple[list[float], list[float]]:
    """Kilobytes and milliseconds of each page."""
    application = datasette_app(database)
    await application.invoke_startup()
    assets = sum((_ASSETS / name).stat().st_size for name in ("pages.css", "pages.js"))
    await application.client.get("/-/esi/")
    kilobytes, milliseconds = [], []
    for vendor, product, revision in wanted:
        started = time.perf_counter()
        response = await application.client.get(f"/-/esi/device/{vendor}/{product}/{revision}")
        milliseconds.append((time.perf_counter() - started) * 1000)
        assert response.status_code == 200, response.text
        kilobytes.append((len(response.content) + assets) / 1000)
    return kilobytes, milliseconds


def page_rows(database: Path) -> list[Row]:
    """Rows of the table."""
    logging.disable(logging.INFO)
    known = sorted(identities(database))
    kilobytes, milliseconds = asyncio.run(_measure(database, known[:: max(1, len(known) // _PAGES)]))
    weight, pace = statistics.quantiles(kilobytes, n=20), statistics.quantiles(milliseconds, n=20)
    words = "device pages, median / 95 %:"
    return [
        Row(f"{words} weight without images", f"{weight[9]:.0f} / {weight[18]:.0f} kB", f"<= {WEIGHT_LIMIT_KB} kB"),
        Row(f"{words} time in the server", f"{pace[9]:.1f} / {pace[18]:.1f} ms", f"<= {TIME_LIMIT_MS} ms"),
    ]
