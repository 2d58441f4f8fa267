"""The table that the benchmarks print, and where it stands in the documentation."""

import os
import platform
import re
import sqlite3
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from esicatalog.version import __version__


class Row(NamedTuple):
    """One line: what was measured, the figure, and the limit that is asked for."""

    what: str
    measured: str
    limit: str = ""


def table(rows: Iterable[Row]) -> str:
    """A Markdown table with aligned columns."""
    cells = [Row("what", "measured", "limit"), *rows]
    widths = [max(len(row[at]) for row in cells) for at in range(3)]
    lines = [
        "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) + " |" for row in cells
    ]
    lines.insert(1, "|" + "|".join("-" * (width + 2) for width in widths) + "|")
    return "\n".join(lines)


def machine() -> str:
    """The machine and the versions in one sentence."""
    system = platform.freedesktop_os_release().get("PRETTY_NAME", "") if platform.system() == "Linux" else ""
    load = f"; load {os.getloadavg()[0]:.1f} at the end" if hasattr(os, "getloadavg") else ""
    return (
        f"esicatalog {__version__}, Python {platform.python_version()}, SQLite {sqlite3.sqlite_version}, "
        f"{system or platform.system()}, {os.cpu_count()} cores ({_processor()}), {_memory()}{load}."
    )


def _processor() -> str:
    information = Path("/proc/cpuinfo")
    names = re.findall(r"model name\s*: (.+)", information.read_text()) if information.exists() else []
    return names[0].strip() if names else platform.machine()


def _memory() -> str:
    if not hasattr(os, "sysconf"):
        return "memory unknown"
    return f"{os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 1024**3:.0f} GiB"


def publish(title: str, text: str, document: Path | None) -> None:
    """Print a measurement, and put it between its marks in a document."""
    print(text)
    if document is None:
        return
    begin, end = f"<!-- measured: {title} -->", f"<!-- end: {title} -->"
    head, _, rest = document.read_text("utf-8").partition(begin)
    _, found, tail = rest.partition(end)
    if not found:
        raise SystemExit(f"{document}: no lines {begin} and {end} to write between")
    document.write_text(f"{head}{begin}\n\n{text}\n\n{end}{tail}", "utf-8")
