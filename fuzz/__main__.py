"""``python -m fuzz [TARGET]``: look for inputs that a target does not answer, FUZZ_SECONDS (60) each.

Inputs found are written to ``fuzz/found/``. Without a target all are run, as many at once as there are processors, and
the inputs tried are printed.
"""

import importlib
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TARGETS = ("reader", "pipeline", "sii", "scan")
_FOUND = Path(__file__).parent / "found"
_TRIED = re.compile(r"stat::number_of_executed_units:\s*(\d+)")
_LONGEST_SECONDS = 30
_MEMORY_MB = 4096


def run_all(seconds: int) -> int:
    """Run every target in a process of its own; returns how many failed."""

    def process(target: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "fuzz", target]
        return subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)

    failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for target, ended in zip(TARGETS, pool.map(process, TARGETS), strict=True):
            tried = _TRIED.search(ended.stderr)
            failed += ended.returncode != 0
            words = "nothing found" if ended.returncode == 0 else ended.stderr[-3_000:]
            print(f"{target}: {tried[1] if tried else '?'} inputs in {seconds} s: {words}", flush=True)
    return failed


def run(target: str, seconds: int) -> None:
    """Run one target in this process, which ends with it."""
    import atheris

    with atheris.instrument_imports(include=["esicatalog"]):
        module = importlib.import_module(f"fuzz.{target}")
    _FOUND.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as corpus:
        for number, seed in enumerate(module.seeds()):
            Path(corpus, str(number)).write_bytes(seed)
        options = (
            f"-max_total_time={seconds}",
            f"-timeout={_LONGEST_SECONDS}",
            f"-rss_limit_mb={_MEMORY_MB}",
            f"-artifact_prefix={_FOUND}/{target}-",
            "-max_len=200000",
            "-print_final_stats=1",
        )

        def mutate(data: bytes, max_size: int, seed: int) -> bytes:
            if seed % 3 == 0:
                return bytes(atheris.Mutate(data, max_size))
            return module.mutate(data, seed)[:max_size]

        atheris.Setup(
            [f"fuzz.{target}", *options, corpus], lambda data: module.check(data) and None, custom_mutator=mutate
        )
        atheris.Fuzz()


if __name__ == "__main__":
    budget = int(os.environ.get("FUZZ_SECONDS", "60"))
    if len(sys.argv) > 1:
        run(sys.argv[1], budget)
    sys.exit(run_all(budget))
