"""Take the pictures of docs/: the four pages at two widths, from the example files.

    python docs/screenshots.py

Needs chromium; the pages are those of ``esicatalog serve`` with a catalog of ``data/``.
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

from esicatalog import Catalog

ROOT = Path(__file__).parent.parent
WIDTHS = (1280, 400)
PAGES = {
    "home": "/-/esi/?mode=CSV",
    "device": "/-/esi/device/0x1097/0x2406/0x8f",
    "compare": "/-/esi/compare?a=0xe5c:0x0d080808:0x00100000&b=0xe5c:0x0d080808:0x00110000",
    "scan": "/-/esi/scan",
}
SCAN = """\
=== Master 0, Slave 0 ===
Identity:
  Vendor Id:       0x00000e5c
  Product code:    0x0d080808
  Revision number: 0x00110000
=== Master 0, Slave 1 ===
Identity:
  Vendor Id:       0x00001097
  Product code:    0x00002406
  Revision number: 0x00000090
=== Master 0, Slave 2 ===
Identity:
  Vendor Id:       0x000000cd
  Product code:    0x00000456
  Revision number: 0x00010000
"""


def main() -> None:
    """Serve, open, write."""
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    if chromium is None:
        sys.exit("no chromium on this machine")
    with tempfile.TemporaryDirectory() as folder:
        database = Path(folder, "catalog.db")
        with Catalog.open(database, create=True) as catalog:
            catalog.ingest([ROOT / "data"], jobs=1)
        command = [sys.executable, "-m", "esicatalog", "serve", "--db", str(database), "--port", "0"]
        server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert server.stdout is not None
        address = server.stdout.readline().strip().removesuffix("/catalog")
        try:
            take(chromium, address)
        finally:
            server.terminate()
            server.wait()


def take(chromium: str, address: str) -> None:
    """Write one picture a page and width."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        for width in WIDTHS:
            page = browser.new_page(viewport={"width": width, "height": 800}, color_scheme="light")
            for name, path in PAGES.items():
                page.goto(address + path)
                if name == "scan":
                    page.locator("#scan").fill(SCAN)
                    page.get_by_role("button", name="Identify").click()
                    page.locator("table.slaves").wait_for()
                page.screenshot(path=ROOT / "docs" / f"page-{name}-{width}.png", full_page=True)
            page.close()
        browser.close()


if __name__ == "__main__":
    main()
