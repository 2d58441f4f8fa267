"""What a large catalog costs: a made-up library of 10,000 and of 100,000 devices. ``make bench-scale``.

    python benchmarks/scale.py [--small 10000] [--large 100000] [--objects 20] [--jobs N] [--write docs/performance.md]

Time of an ingest is the processor time of all its processes: on a busy machine the clock tells who else was there.
Questions are asked in a running process, as a page of 50 devices and as the whole list; a whole list costs by the
devices in it, so it stands there per device as well.
"""

import argparse
import os
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

from identify import PYTHON_LIMIT, SQL_LIMIT_US, identities, python_microseconds, sql_microseconds
from ingest import memory_rows
from library import FIRST_VENDOR_ID, Shape, write_library
from processes import Ran, compile_package, run_ingest
from questions import LIMIT_MS
from report import Row, machine, publish, table

from esicatalog import Catalog
from esicatalog.identity import Bounds, Identity

LINEAR_LIMIT = 1.15
_PAGE = 50
_CALLS = 5

FILTERS: dict[str, dict[str, Any]] = {
    "no filter": {},
    "--vendor NUMBER": {"vendor_id": FIRST_VENDOR_ID + 7},
    "--vendor NAME": {"vendor": "vendor 0007"},
    "--product": {"product_code": 0x10007},
    "--text of many": {"text": "drive"},
    "--text of few": {"text": "D07"},
    "--profile 402": {"profile_no": 402},
    "--mode CSV": {"modes": ["CSV"]},
    "--mode CSP,HM --strict": {"modes": ["CSP", "HM"], "strict": True},
    "--sync sync1": {"sync": "sync1"},
    "--needs-dc": {"needs_dc": True},
    "--protocol coe": {"protocol": "coe"},
    "--protocol fsoe, none": {"protocol": "fsoe"},
    "--complete-access": {"complete_access": True},
    "--pdo-assign, none": {"pdo_assign": True},
    "--pdo-config, none": {"pdo_config": True},
    "--bootstrap, none": {"bootstrap": True},
    "--no-lrw, none": {"no_lrw": True},
    "--identification ado, none": {"identification": "ado"},
    "--physics KK": {"physics": "KK"},
    "--bytes-in <=8": {"bytes_in": Bounds(None, 8)},
    "--bytes-out 77, none": {"bytes_out": Bounds(77, 77)},
    "--min-cycle-ns <=62500": {"min_cycle_ns": Bounds(None, 62_500)},
    "--e-bus-ma >=100": {"e_bus_ma": Bounds(100, None)},
    "--axes 1": {"axes": Bounds(1, 1)},
    "--maps 0x6040": {"maps": [(0x6040, None)]},
    "--maps 0x60B2": {"maps": [(0x60B2, None)]},
    "--maps 0x7000:1 --bits 1": {"maps": [(0x7000, 1)], "bits": 1},
    "--maps 0x5555, none": {"maps": [(0x5555, None)]},
    "--not-maps 0x6040": {"not_maps": [(0x6040, None)]},
    "--object 0x6502": {"objects": [(0x6502, None)]},
    "--object 0x1018": {"objects": [(0x1018, None)]},
    "--object 0x1018:3": {"objects": [(0x1018, 3)]},
    "--object 0x5555, none": {"objects": [(0x5555, None)]},
    "--all-variants --include-hidden": {"all_variants": True, "include_hidden": True},
    "--mode CSV --sync sync1": {"modes": ["CSV"], "sync": "sync1"},
    "--bytes-in <=8 --needs-dc": {"bytes_in": Bounds(None, 8), "needs_dc": True},
    "--maps 0x607A --not-maps 0x60F4": {"maps": [(0x607A, 0)], "not_maps": [(0x60F4, None)]},
    "--vendor NAME --object 0x6502": {"vendor": "vendor 0007", "objects": [(0x6502, None)]},
}
"""Every filter alone, with values that many devices, few, or none have, and some together; ``--like`` comes beside."""


class Measured(NamedTuple):
    """A library ingested into a new catalog."""

    devices: int
    xml_bytes: int
    database: Path
    ran: Ran

    @property
    def microseconds(self) -> float:
        """Processor time of the ingest for one device."""
        return self.ran.processor_seconds * 1e6 / self.devices


def build(folder: Path, shape: Shape, jobs: int, runs: int) -> Measured:
    """Write a library and ingest it ``runs`` times; the median counts."""
    library, database = folder / f"library {shape.devices}", folder / f"{shape.devices}.db"
    _, xml_bytes = write_library(library, shape)
    ran = []
    for _ in range(runs):
        database.unlink(missing_ok=True)
        ran.append(run_ingest(library, database, jobs))
        if ran[-1].has_failures:
            raise SystemExit(f"{library}: documents of ours could not be read")
    ran.sort(key=lambda item: item.processor_seconds)
    return Measured(shape.devices, xml_bytes, database, ran[len(ran) // 2])


def ingest_rows(small: Measured, large: Measured) -> list[Row]:
    """How an ingest grows."""
    rows = []
    for item in (small, large):
        words = f"{item.devices:,} devices, {item.xml_bytes / 1e6:.0f} MB"
        speed = f"{item.ran.seconds:.1f} s ({item.ran.processor_seconds:.1f} s of processor time)"
        rows += [
            Row(f"cold ingest of {words}", speed),
            *memory_rows([item.ran]),
            Row("catalog / XML bytes", f"{item.database.stat().st_size / item.xml_bytes:.2f}"),
        ]
    ratio = large.microseconds / small.microseconds
    words = f"processor time of a device, {large.devices:,} to {small.devices:,}"
    return [*rows, Row(words, f"{ratio:.2f}", f"<= {LINEAR_LIMIT}")]


def lookup_rows(database: Path) -> list[Row]:
    """Exact lookups."""
    wanted = identities(database)
    _, later = python_microseconds(database, wanted)
    return [
        Row("exact lookup in SQL", f"{sql_microseconds(database, wanted):.1f} µs", f"<= {SQL_LIMIT_US} µs"),
        Row("Catalog.identify", f"{1e6 / later:,.0f} a second", f">= {PYTHON_LIMIT:,}"),
    ]


def filter_rows(database: Path) -> list[Row]:
    """Every filter: a page of the list, then the whole list."""
    rows = []
    vendor_id, product_code, _ = next(numbers for numbers in identities(database) if _has_layout(database, numbers))
    questions = {**FILTERS, "--like": {"like": Identity(vendor_id, product_code, None, None)}}
    with Catalog.open(database) as catalog:
        for words, question in questions.items():
            page = _median_ms(lambda question=question: catalog.devices(limit=_PAGE, **question))
            started = time.thread_time()
            found = catalog.devices(**question)
            whole = (time.thread_time() - started) * 1000
            each = f", {whole * 1000 / len(found):.0f} µs each" if len(found) > _PAGE else ""
            measured = f"{page:.1f} ms; all {len(found):,}: {whole:.0f} ms{each}"
            rows.append(Row(f"devices {words}", measured, f"<= {LIMIT_MS:.0f} ms"))
    return rows


def _has_layout(database: Path, numbers: tuple[int, int, int]) -> bool:
    with Catalog.open(database) as catalog:
        return bool(catalog.device(Identity(*numbers, None)).device.rx_pdos)


def _median_ms(ask: Callable[[], object]) -> float:
    """Processor time of this thread: SQLite works in it."""
    taken = []
    for _ in range(_CALLS):
        started = time.thread_time()
        ask()
        taken.append(time.thread_time() - started)
    return median(taken) * 1000


def main() -> None:
    """Measure, print, and write where asked."""
    parser = argparse.ArgumentParser(description="Measure ingest, lookups and filters on made-up libraries.")
    parser.add_argument("--small", type=int, default=10_000, help="devices of the smaller library")
    parser.add_argument("--large", type=int, default=100_000, help="devices of the larger library")
    parser.add_argument("--objects", type=int, default=20, help="objects of a dictionary")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--write", type=Path, metavar="DOCUMENT", help="put the tables between their marks")
    given = parser.parse_args()
    compile_package()
    with tempfile.TemporaryDirectory() as name:
        shapes = [Shape(count, given.objects, revisions=5, vendors=100, seed=1) for count in (given.small, given.large)]
        small, large = (build(Path(name), shape, given.jobs, runs) for shape, runs in zip(shapes, (3, 1), strict=True))
        rows = [*ingest_rows(small, large), *lookup_rows(large.database), *filter_rows(large.database)]
    words = f"{given.objects} objects a dictionary, 5 revisions a product, {given.jobs} workers; {machine()}"
    publish("made-up libraries", f"{table(rows)}\n\n{words}", given.write)


if __name__ == "__main__":
    main()
