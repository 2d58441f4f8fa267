"""A library made by hand, big enough that an ingest takes a second or more, and ways to disturb that ingest."""

import os
import signal
import subprocess
import sys
import time
import zipfile
from contextlib import suppress
from pathlib import Path

from click.testing import CliRunner
from snippets import device, dictionary, esi, pdo, rows, write

from esicatalog import Catalog
from esicatalog.catalog.unfinished import CUT_SHORT
from esicatalog.cli.main import cli

PROGRAM = (sys.executable, "-m", "esicatalog")
SEED = int(os.environ.get("ESICATALOG_SEED", "1"))
"""Of all random choices of the tests about faults; printed with every failure."""
_TYPES = "<DataType><Name>UDINT</Name><BitSize>32</BitSize></DataType>"
_MODULE = '<Module><Type ModuleIdent="#x{ident:X}">M{ident}</Type><Name>Module {ident}</Name>{pdo}</Module>'
_SLOT = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>#x{ident:X}</ModuleIdent></Slot></Slots>'


def document(number: int, revisions: int = 3, vendor: str = "Test vendor") -> str:
    """A document with several revisions of a modular device whose dictionary other documents share in part."""
    objects = "".join(
        f"<Object><Index>#x{0x2000 + n:X}</Index><Name>Object {n}</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        "</Object>"
        for n in range(number % 7, number % 7 + 25)
    )
    entries = [1 + (number + bit) % 16 for bit in range(60)]
    ident = 1 + number % 5
    content = (
        dictionary(_TYPES, objects) + pdo("RxPdo", "#x1600", *entries) + pdo("TxPdo", "#x1A00", *reversed(entries))
    )
    devices = "".join(
        device(content + _SLOT.format(ident=ident), product=f"#x{number + 1:X}", revision=f"#x{n + 1:X}")
        for n in range(revisions)
    )
    module = _MODULE.format(ident=ident, pdo=pdo("RxPdo", "#x1700", 8, 8))
    return esi(devices, module, vendor=f"<Id>#x{0x100 + number % 4:X}</Id><Name>{vendor} {number % 4}</Name>")


def make_library(folder: Path, documents: int) -> Path:
    """Documents of which every fourth lies in one archive; one needs recovery, one is no ESI, one is broken."""
    texts = {f"{number:04d}.xml": document(number) for number in range(documents)}
    write(folder, {name: text for name, text in texts.items() if int(name[:4]) % 4})
    with zipfile.ZipFile(folder / "archive.zip", "w") as archive:
        for name, text in texts.items():
            if int(name[:4]) % 4 == 0:
                archive.writestr(name, text)
    unclosed = document(documents).replace("</EtherCATInfo>", "")
    write(folder, {"unclosed.xml": unclosed, "readme.txt": "nothing", "broken.xml": ""})
    return folder


def change_library(folder: Path, documents: int) -> Path:
    """The library a year later: documents changed, gone and new."""
    for number in range(1, documents, 8):
        (folder / f"{number:04d}.xml").write_text(document(number, 2, "Renamed vendor"))
    for number in range(5, documents, 8):
        (folder / f"{number:04d}.xml").unlink()
    return write(folder, {f"{number:04d}.xml": document(number) for number in range(documents, documents + 20)})


def ingest_command(db: Path, *words: object, jobs: int = 2) -> list[str]:
    """The ingest that is disturbed, in a process of its own."""
    return [*PROGRAM, "ingest", *map(str, words), "--db", str(db), "--jobs", str(jobs)]


def ingested(db: Path, *inputs: Path) -> str:
    """The content hash after an ingest that nothing disturbs."""
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest(inputs, jobs=1)
        result = catalog.check()
    assert result.problems == []
    return result.content_hash


def assert_consistent(db: Path) -> None:
    """Whatever happened: all that check may say is that the ingest has to be run again."""
    with Catalog.open(db, create=True) as catalog:
        problems = catalog.check().problems
    assert problems in ([], [CUT_SHORT])
    assert rows(db, "PRAGMA foreign_key_check") == []


def assert_completed_by_running_again(db: Path, expected: str, *words: object) -> None:
    """The same command once more gives the catalog of an undisturbed run, as one file."""
    done = CliRunner().invoke(cli, ingest_command(db, *words, jobs=1)[len(PROGRAM) :], catch_exceptions=False)
    assert done.exit_code in (0, 1), done.stderr
    with Catalog.open(db) as catalog:
        result = catalog.check()
    assert (result.problems, result.content_hash) == ([], expected)
    assert [path.name for path in db.parent.iterdir() if path.name.startswith(db.name)] == [db.name]


def started(*command: str) -> subprocess.Popen[str]:
    """A process with a group of its own, as a shell starts it."""
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)


def children(process: subprocess.Popen[str]) -> list[int]:
    """Its worker processes (Linux)."""
    found: list[int] = []
    with suppress(OSError):
        for task in Path(f"/proc/{process.pid}/task").iterdir():
            found.extend(map(int, (task / "children").read_text().split()))
    return found


def is_alive(number: int) -> bool:
    """Whether a process still runs; one that only waits to be asked for its exit code does not."""
    try:
        return Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def all_end(numbers: list[int], seconds: float = 30.0) -> bool:
    """Whether these processes end by themselves within a generous time."""
    deadline = time.monotonic() + seconds
    while any(map(is_alive, numbers)):
        if time.monotonic() > deadline:
            return False
        time.sleep(0.02)
    return True


def kill(process: subprocess.Popen[str], target: str) -> list[int]:
    """SIGKILL to the ``group``, the ``parent`` alone or one ``worker`` alone; returns the workers there were."""
    workers = children(process)
    with suppress(ProcessLookupError):
        if target == "group":
            os.killpg(process.pid, signal.SIGKILL)
        elif target == "parent":
            process.kill()
        elif workers:
            os.kill(workers[-1], signal.SIGKILL)
    return workers
