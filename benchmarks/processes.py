"""Running an ingest as people run it, in a process of its own, and what that took."""

import compileall
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import esicatalog
from esicatalog.cli.common import EXIT_NO

_INGEST = """
import io, json, resource, sys
from esicatalog.cli.main import cli
output, sys.stdout = sys.stdout, io.TextIOWrapper(io.BytesIO())
code = 0
try:
    cli(sys.argv[1:], standalone_mode=False)
except SystemExit as error:
    code = error.code
kilobytes = [resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
print(json.dumps([k / 1024 for k in kilobytes]), file=output)
sys.exit(code)
"""
"""A process starts with the peak memory of the one that started it, so whoever runs this must stay small."""


class Ran(NamedTuple):
    """An ingest from the start of its process to its end."""

    seconds: float
    processor_seconds: float
    """User and system, of the process and of its workers."""
    writer_mb: float
    """Most memory that the process held at a time."""
    worker_mb: float
    """The same of its largest worker."""
    has_failures: bool
    """Whether documents could not be read: then the figures are those of a part."""


def compile_package() -> None:
    """Compile the package as installing it does: in a checkout whose bytecode may not be written every start would."""
    compileall.compile_dir(Path(esicatalog.__file__).parent, quiet=1)


def run_ingest(folder: Path, database: Path | str, jobs: int) -> Ran:
    """``esicatalog ingest`` in a new interpreter."""
    command = [sys.executable, "-c", _INGEST, "ingest", str(folder), "--db", str(database), "--jobs", str(jobs)]
    started = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    assert process.stdout is not None
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - started
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, EXIT_NO):
        raise SystemExit(f"ingest of {folder} ended with {process.returncode}")
    return Ran(seconds, usage.ru_utime + usage.ru_stime, *json.loads(output), process.returncode == EXIT_NO)
