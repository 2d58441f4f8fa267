"""How long the load through COPY into PostgreSQL takes beside the ingest into SQLite, in the same run.

    python benchmarks/postgres.py [CORPUS] [--runs 3] [--jobs 2] [--processes 4]

The server is a private one of its own, with its standard settings, on the same machine: it shares the cores with the
ingest. Without a server the benchmark says so in one line. ``--processes`` ingests load as many parts of the corpus
into one catalog at once.
"""

import argparse
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from corpus import default_corpus
from processes import compile_package, run_ingest

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests"))

from postgres_cluster import Cluster, NoServer, running_cluster

RATIO_LIMIT = 2.0


def together(corpus: Path, url: str, processes: int, jobs: int) -> float:
    """Seconds until all of several ingests, each of its part of the corpus, are done."""
    inputs = sorted(corpus.iterdir())
    started = time.perf_counter()
    command = [sys.executable, "-m", "esicatalog", "ingest", "--db", url, "--jobs", str(jobs)]
    running = [
        subprocess.Popen(
            [*command, *map(str, inputs[part::processes])], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
        )
        for part in range(processes)
    ]
    for process in running:
        _, errors = process.communicate()
        assert process.returncode == 0, errors.decode()
    return time.perf_counter() - started


def measure(cluster: Cluster, corpus: Path, jobs: int) -> tuple[float, float]:
    """Seconds of an ingest into a new SQLite file and into a new PostgreSQL database, one after the other."""
    with tempfile.TemporaryDirectory() as folder:
        sqlite = run_ingest(corpus, Path(folder, "catalog.db"), jobs)
    return sqlite.seconds, run_ingest(corpus, cluster.new_database(), jobs).seconds


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="Measure ingest into PostgreSQL against ingest into SQLite.")
    parser.add_argument("corpus", nargs="?", type=Path, default=default_corpus(), help="folder to ingest")
    parser.add_argument("--runs", type=int, default=3, help="how often to measure; medians are shown")
    parser.add_argument("--jobs", type=int, default=2, help="worker processes")
    parser.add_argument("--processes", type=int, default=4, help="ingests at once")
    given = parser.parse_args()
    compile_package()
    try:
        with running_cluster(durable=True) as cluster:
            runs = []
            for number in range(given.runs):
                runs.append(measure(cluster, given.corpus, given.jobs))
                sqlite, postgres = runs[-1]
                print(f"run {number + 1}: SQLite {sqlite:.2f} s, PostgreSQL {postgres:.2f} s", flush=True)
            at_once = together(given.corpus, cluster.new_database(), given.processes, 1)
    except NoServer as missing:
        print(f"PostgreSQL was not measured: {missing}")
        return
    ratio = statistics.median(postgres / sqlite for sqlite, postgres in runs)
    print(f"PostgreSQL / SQLite     {ratio:>8.2f}  <= {RATIO_LIMIT}")
    print(f"{given.processes} ingests at once       {at_once:>8.2f} s")


if __name__ == "__main__":
    main()
