"""Running esicatalog as people run it, in a process of its own, and what that took."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

_PEAKS = """
import io, json, resource, sys
from esicatalog.cli.main import cli
output, sys.stdout = sys.stdout, io.TextIOWrapper(io.BytesIO())
try:
    cli(sys.argv[1:], standalone_mode=False)
except SystemExit:
    pass
kilobytes = [resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
print(json.dumps([k / 1024 for k in kilobytes]), file=output)
"""
"""A process starts with the peak memory of the one that started it, so whoever runs this must stay small."""


class Ran(NamedTuple):
    """A command from its start to its end, start of Python included."""

    seconds: float
    processor_seconds: float
    """User and system, of the process and those that it started."""
    output: str


class Peaks(NamedTuple):
    """Most memory that processes held at a time, in MB."""

    writer: float
    largest_worker: float


def _ingest(folder: Path, database: Path, jobs: int) -> list[str]:
    return ["ingest", str(folder), "--db", str(database), "--jobs", str(jobs), "--format", "json"]


def run_ingest(folder: Path, database: Path, jobs: int) -> Ran:
    """``esicatalog ingest`` in a new interpreter."""
    started = time.perf_counter()
    command = [sys.executable, "-m", "esicatalog", *_ingest(folder, database, jobs)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    assert process.stdout is not None
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.perf_counter() - started
    if process.returncode not in (0, 1):
        raise SystemExit(f"ingest of {folder} ended with {process.returncode}")
    return Ran(seconds, usage.ru_utime + usage.ru_stime, output)


def ingest_peaks(folder: Path, database: Path, jobs: int) -> Peaks:
    """Peak memory of the writer and of the largest worker of an ingest."""
    command = [sys.executable, "-c", _PEAKS, *_ingest(folder, database, jobs)]
    process = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return Peaks(*json.loads(process.stdout))
