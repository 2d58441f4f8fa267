"""Disks that are full or read-only, catalogs that are locked, damaged or written by two, interrupts.

Each ends in a consistent catalog and one line that says what to do; running again gives what an undisturbed run gives.
"""

import contextlib
import errno
import os
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import closing, suppress
from itertools import product
from pathlib import Path

import pytest
from click.testing import CliRunner
from library import (
    SEED,
    all_end,
    assert_completed_by_running_again,
    assert_consistent,
    children,
    ingest_command,
    ingested,
    is_alive,
    make_library,
    started,
)
from snippets import device, esi, rows, write

from esicatalog import Catalog, CatalogError
from esicatalog.catalog import load
from esicatalog.catalog.lock import only_writer
from esicatalog.cli.main import cli
from esicatalog.lint.rules import ALL_RULES

L6N = "0x4321:0x8100"


def one_line(done: subprocess.CompletedProcess[str]) -> str:
    """What a refused command says."""
    return line_of(done.returncode, done.stderr)


def line_of(code: int, said: str) -> str:
    """The line of a command that could not do its work; lines of progress may stand before it."""
    assert code == 2, said
    assert "Traceback" not in said
    *progress, line = said.splitlines()
    assert all(" documents/s" in text for text in progress)
    assert line.startswith("esicatalog: ")
    return line


def run(*command: object, **options: object) -> subprocess.CompletedProcess[str]:
    words = [sys.executable, "-m", "esicatalog", *map(str, command)]
    return subprocess.run(words, capture_output=True, text=True, timeout=120, **options)  # type: ignore[call-overload]


def quietly(*words: object):
    """A command in this process; a traceback of it is an error of the test."""
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


def refused(*words: object) -> str:
    """The line of a command in this process that could not do its work."""
    result = quietly(*words)
    return line_of(result.exit_code, result.stderr)


@pytest.fixture(scope="module")
def library(tmp_path_factory) -> Path:
    return make_library(tmp_path_factory.mktemp("library"), 24)


@pytest.fixture(scope="module")
def whole(tmp_path_factory, library) -> Path:
    """The catalog of an undisturbed run."""
    db = tmp_path_factory.mktemp("whole") / "c.db"
    ingested(db, library)
    return db


@pytest.fixture(scope="module")
def expected(whole) -> str:
    with Catalog.open(whole) as catalog:
        return str(catalog.content_hash())


@pytest.fixture(scope="module")
def part(tmp_path_factory, library) -> Path:
    """A catalog of a few of the documents."""
    db = tmp_path_factory.mktemp("part") / "c.db"
    ingested(db, *sorted(library.glob("000*.xml")))
    return db


# A disk of its own: a file system in memory, which root may mount.


@contextlib.contextmanager
def small_disk(folder: Path, kilobytes: int) -> Iterator[Path]:
    folder.mkdir()
    words = ["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", str(folder)]
    mounted = shutil.which("mount") and subprocess.run(words, capture_output=True).returncode == 0
    if not mounted:
        pytest.skip("no file system of a few kilobytes: only root may mount one")
    try:
        yield folder
    finally:
        subprocess.run(["umount", str(folder)], check=True)


def remount(folder: Path, options: str) -> None:
    subprocess.run(["mount", "-o", f"remount,{options}", str(folder)], check=True)


def some_of(cases: Iterable[tuple[object, ...]], *chosen: tuple[object, ...]) -> list[object]:
    """All cases, of which those that are not chosen are for ``make faults``."""
    return [case if case in chosen else pytest.param(*case, marks=pytest.mark.faults) for case in cases]


@pytest.mark.parametrize(
    ("start", "share"),
    some_of(product(("new", "part"), (0.01, 0.05, 0.2, 0.5, 0.9, 1.0)), ("part", 0.5)),
)
def test_a_full_disk(tmp_path, library, whole, part, expected, share, start):
    """``share`` of what the whole catalog needs is there; then the disk grows."""
    needed = whole.stat().st_size
    with small_disk(
        tmp_path / "disk", int(needed * share / 1024) + (part.stat().st_size // 1024) * (start == "part")
    ) as disk:
        db = disk / "c.db"
        if start == "part":
            shutil.copy(part, db)
        done = quietly("ingest", library, "--jobs", "1", "--db", db)
        if done.exit_code != 1:  # 1: it did fit, and the broken document is told
            line = line_of(done.exit_code, done.stderr)
            assert str(db) in line
            assert "disk is full" in line or "No space left" in line or "may be full" in line
        remount(disk, f"size={needed * 4}")
        if db.exists():
            assert_consistent(db)
        if start == "part":
            assert {"0001.xml", "0002.xml"} <= {name for (name,) in rows(db, "SELECT member FROM sources")}
        assert_completed_by_running_again(db, expected, library)


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="counts descriptors through /proc")
@pytest.mark.parametrize(
    ("code", "words"),
    [
        (errno.EAGAIN, "another ingest or migrate is writing to it; when that has ended, run this again"),
        (errno.ENOLCK, "the folder of the catalog takes no locks: No locks available"),
    ],
)
def test_a_lock_that_cannot_be_had(tmp_path, monkeypatch, code, words):
    def refused(descriptor, operation):
        raise OSError(code, os.strerror(code))

    monkeypatch.setattr("fcntl.flock", refused)
    before = len(list(Path("/proc/self/fd").iterdir()))
    with pytest.raises(CatalogError) as told, only_writer(tmp_path / "c.db"):
        pass
    assert str(told.value) == f"{tmp_path / 'c.db'}: {words}"
    assert len(list(Path("/proc/self/fd").iterdir())) == before


def test_a_disk_too_small_for_a_snapshot_is_the_one_that_is_named(tmp_path, whole):
    with small_disk(tmp_path / "disk", whole.stat().st_size // 1024 // 2) as disk:
        with Catalog.open(whole) as catalog, pytest.raises(CatalogError) as told:
            catalog.snapshot(disk / "s.db")
        assert str(told.value).startswith(f"{disk / 's.db'}: ")
        assert list(disk.iterdir()) == []
        assert_consistent(whole)


def test_a_full_disk_is_no_obstacle_to_reading(tmp_path, whole):
    with small_disk(tmp_path / "disk", whole.stat().st_size // 1024 + 64) as disk:
        db = Path(shutil.copy(whole, disk / "c.db"))
        with suppress(OSError), open(disk / "filler", "wb") as filler:
            while True:
                filler.write(bytes(4096))
        assert quietly("devices", "--limit", "1", "--db", db).exit_code == 0
        assert quietly("check", "--db", db).exit_code == 0


@pytest.mark.parametrize(("start", "kilobytes"), some_of(product(("new", "part"), (8, 100, 500, 1000)), ("new", 8)))
def test_files_that_may_not_grow(tmp_path, library, part, expected, kilobytes, start):
    """The limit of a process on the size of its files does not need root; the system answers EFBIG."""
    db = tmp_path / "c.db"
    if start == "part":
        shutil.copy(part, db)

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (kilobytes * 1024, kilobytes * 1024))

    done = subprocess.run(ingest_command(db, library), capture_output=True, text=True, preexec_fn=limit)
    assert "nothing of the last step was stored" in one_line(done)
    assert_consistent(db)
    assert_completed_by_running_again(db, expected, library)


@pytest.mark.parametrize(("pages",), some_of([(5,), (20,), (50,)], (20,)))
def test_a_database_that_may_not_grow(tmp_path, library, part, expected, monkeypatch, pages):
    """SQLite's own limit on pages gives the very error of a full disk, at each of many places."""
    from esicatalog.catalog import database

    make_engine = database.make_engine
    db = Path(shutil.copy(part, tmp_path / "c.db"))
    ((before,),) = rows(db, "PRAGMA page_count")

    def limited(url, read_only=False):
        from sqlalchemy import event

        engine = make_engine(url, read_only)
        limit = f"PRAGMA max_page_count = {before + pages}"
        event.listen(engine, "connect", lambda connection, _: connection.execute(limit))
        return engine

    with monkeypatch.context() as patch:
        patch.setattr(database, "make_engine", limited)
        with Catalog.open(db) as catalog, pytest.raises(CatalogError, match="the disk is full"):
            catalog.ingest([library], jobs=1)
    assert_consistent(db)
    assert_completed_by_running_again(db, expected, library)


# Folders that cannot be written.


@contextlib.contextmanager
def read_only(folder: Path, *files: Path) -> Iterator[Path]:
    """A folder with copies of these files that nobody, root included, can write."""
    size = sum(file.stat().st_size for file in files) // 1024 + 1024
    if os.geteuid() == 0:
        with small_disk(folder, size) as disk:
            for file in files:
                shutil.copy(file, disk / "c.db")
            remount(disk, "ro")
            yield disk
        return
    folder.mkdir()
    for file in files:
        shutil.copy(file, folder / "c.db")
    folder.chmod(0o500)
    try:
        yield folder
    finally:
        folder.chmod(0o700)


READING = [
    ("devices", "--limit", "1"),
    ("identify", "0x101", "2", "1"),
    ("show", "0x101:2:1"),
    ("export", "cstruct", "0x101:2:1"),
    ("diff", "0x101:2:1", "0x101:2:1"),
    ("check",),
    ("migrate",),
]


@pytest.mark.parametrize("words", READING, ids=lambda words: words[0])
def test_a_read_only_folder_can_be_read(tmp_path, whole, words):
    with read_only(tmp_path / "ro", whole) as folder:
        done = quietly(*words, "--db", folder / "c.db")
        assert done.exit_code == 0, done.stderr


def test_a_read_only_folder_takes_no_documents(tmp_path, whole, library):
    with read_only(tmp_path / "ro", whole) as folder:
        assert "cannot be written" in refused("ingest", library, "--db", folder / "c.db")
        assert "cannot be" in refused("ingest", library, "--db", folder / "new.db")


def test_an_old_catalog_in_a_read_only_folder(tmp_path):
    old = tmp_path / "old.db"
    with closing(sqlite3.connect(old)) as connection:
        connection.executescript((Path(__file__).parent / "catalogs" / "0001.sql").read_text())
    with read_only(tmp_path / "ro", old) as folder:
        assert "cannot be written" in refused("migrate", "--db", folder / "c.db")


# Others at work.


def test_a_locked_database_is_waited_for_and_then_named(tmp_path, whole, library):
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    write(library.parent / "more", {"new.xml": esi(device(product="#xABCDE"))})
    with closing(sqlite3.connect(db)) as connection:
        connection.execute("BEGIN EXCLUSIVE")
        commands = (["devices"], ["ingest", str(library.parent / "more")])
        waiting = [started(sys.executable, "-m", "esicatalog", *words, "--db", str(db)) for words in commands]
        for process in waiting:
            out, said = process.communicate()
            done = subprocess.CompletedProcess(process.args, process.returncode, out, said)
            assert "another process is reading or writing it; wait for it" in one_line(done)
        connection.rollback()
    assert quietly("ingest", library.parent / "more", "--db", db).exit_code == 0
    assert_consistent(db)


def has_open(process: subprocess.Popen[str], file: Path) -> bool:
    """Whether a process has a file open; what it closes meanwhile it has not."""
    for entry in Path(f"/proc/{process.pid}/fd").iterdir():
        with suppress(OSError):
            if entry.readlink() == file:
                return True
    return False


def test_a_lock_that_is_given_back_is_no_obstacle(tmp_path, whole):
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    with closing(sqlite3.connect(db)) as connection:
        connection.execute("BEGIN EXCLUSIVE")
        process = started(sys.executable, "-m", "esicatalog", "devices", "--limit", "1", "--db", str(db))
        while not has_open(process, db):
            assert process.poll() is None
            time.sleep(0.01)
        time.sleep(0.2)  # from opening to asking for a lock
        assert process.poll() is None
        connection.rollback()
        process.communicate()
    assert process.returncode == 0


@pytest.mark.parametrize(("start", "same"), some_of(product(("new", "part"), (True, False)), ("new", True)))
def test_two_ingests_at_once(tmp_path, library, part, expected, same, start):
    db = tmp_path / "c.db"
    if start == "part":
        shutil.copy(part, db)
    halves = [library / "archive.zip", library]
    inputs = [library, library] if same else halves
    both = [started(*ingest_command(db, words)) for words in inputs]
    said = [process.communicate()[1] for process in both]
    codes = [process.returncode for process in both]
    # The broken document makes an ingest of the folder exit code 1.
    assert [code for code in codes if code in (0, 1)] != []
    for code, text in zip(codes, said, strict=True):
        assert "Traceback" not in text
        assert code in (0, 1) or "when that has ended, run this again" in text or "wait for it" in text
    assert_consistent(db)
    assert_completed_by_running_again(db, expected, library)


def test_an_ingest_while_others_read(tmp_path, library, part, expected):
    """Readers see the catalog of before or after a commit, never an error."""
    db = Path(shutil.copy(part, tmp_path / "c.db"))
    process = started(*ingest_command(db, library))
    with Catalog.open(db, read_only=True) as catalog:
        counts = []
        while process.poll() is None:
            counts.append(len(catalog.devices()))
        counts.append(len(catalog.devices()))
    said = process.communicate()
    # The broken document makes the exit code 1; who reads while it is written is no reason for another one.
    assert process.returncode == 1, said
    assert counts == sorted(counts)
    assert counts[-1] > counts[0]
    assert_completed_by_running_again(db, expected, library)


def journal_mode(db: Path) -> str:
    return str(rows(db, "PRAGMA journal_mode")[0][0])


def test_ingests_end_well_while_others_have_the_catalog_open(tmp_path, whole):
    """Who has read during an ingest keeps SQLite from leaving its log; the first ingest without such a reader does."""
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    before = len(rows(db, "SELECT 1 FROM devices"))
    documents = tmp_path / "more"
    with Catalog.open(db, read_only=True) as reader:
        with closing(sqlite3.connect(db)) as connection:
            connection.execute("PRAGMA journal_mode = WAL")
            assert len(reader.devices()) == before
        for number in (1, 2):
            write(documents, {f"{number}.xml": esi(device(product=f"#xABCD{number}"))})
            done = quietly("ingest", documents, "--db", db)
            assert (done.exit_code, "1 stored" in done.stdout) == (0, True), done.output
            assert len(reader.devices()) == before + number
            assert journal_mode(db) == "wal"
        # Nothing is in the log alone: the file can be copied without it.
        assert len(rows(Path(shutil.copy(db, tmp_path / "copy.db")), "SELECT 1 FROM devices")) == before + 2
        done = quietly("snapshot", "--from", db, "--to", tmp_path / "snapshot.db")
        assert (done.exit_code, journal_mode(tmp_path / "snapshot.db")) == (0, "delete"), done.stderr
    done = quietly("ingest", documents, "--db", db)
    assert (done.exit_code, "2 unchanged" in done.stdout, journal_mode(db)) == (0, True, "delete"), done.output
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(db.name)] == [db.name]
    assert_consistent(db)


def test_an_ingest_that_ends_while_others_are_reading_says_that_the_latest_is_in_the_log(tmp_path, whole):
    """What a transaction reads must stay as it is in the file, so that a copy of it lacks the new device."""
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    before = len(rows(db, "SELECT 1 FROM devices"))
    documents = write(tmp_path / "more", {"1.xml": esi(device(product="#xABCD1"))})
    with closing(sqlite3.connect(db, isolation_level=None)) as reader:
        reader.execute("PRAGMA journal_mode = WAL")
        reader.execute("BEGIN")
        assert len(reader.execute("SELECT 1 FROM devices").fetchall()) == before
        done = run("ingest", documents, "--db", db)
        assert done.returncode == 0
        assert f"the latest is in {db}-wal" in done.stderr
        assert len(rows(Path(shutil.copy(db, tmp_path / "copy.db")), "SELECT 1 FROM devices")) == before
        done = run("snapshot", "--from", db, "--to", tmp_path / "snapshot.db")
        assert len(rows(tmp_path / "snapshot.db", "SELECT 1 FROM devices")) == before + 1, done.stderr
    assert "-wal" not in run("ingest", documents, "--db", db).stderr
    assert len(rows(Path(shutil.copy(db, tmp_path / "copy.db")), "SELECT 1 FROM devices")) == before + 1


def test_an_ingest_waits_for_those_who_read_a_finished_catalog_and_lets_others_in_meanwhile(
    tmp_path, whole, library, monkeypatch
):
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    documents = write(tmp_path / "more", {"1.xml": esi(device(product="#xABCD1"))})
    before = len(rows(db, "SELECT 1 FROM devices"))
    seen = []
    with closing(sqlite3.connect(db)) as reader, Catalog.open(db) as catalog:

        def end_reading(seconds: float) -> None:
            with closing(sqlite3.connect(db, timeout=0)) as another:
                seen.append(len(another.execute("SELECT 1 FROM devices").fetchall()))
            reader.rollback()
            half_read.close()

        half_read = reader.execute("SELECT * FROM objects")
        half_read.fetchone()
        # Nothing is written: nobody is in the way.
        assert catalog.ingest(sorted(library.glob("000*.xml"))).counts["stored"] == 0
        monkeypatch.setattr(load.time, "sleep", end_reading)
        assert catalog.ingest(documents).counts["stored"] == 1
        assert seen == [before]
        assert (len(catalog.devices()), journal_mode(db)) == (before + 1, "delete")
    assert_consistent(db)


def test_an_ingest_names_who_does_not_end_reading(tmp_path, whole, library, monkeypatch):
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    documents = write(tmp_path / "more", {"1.xml": esi(device(product="#xABCD1"))})
    monkeypatch.setattr(load, "_READERS_SECONDS", 1.0)
    with closing(sqlite3.connect(db)) as reader, Catalog.open(db) as catalog:
        half_read = reader.execute("SELECT * FROM objects")
        half_read.fetchone()
        with pytest.raises(CatalogError, match="another process is reading or writing it; wait for it"):
            catalog.ingest(documents)
        half_read.close()
        # What has looked at findings only in part keeps nobody waiting.
        findings = iter(catalog.findings(ALL_RULES))
        next(findings)
        assert catalog.ingest(documents).counts["stored"] == 1


def test_an_emptied_catalog_fills_again_while_others_have_it_open(tmp_path):
    db = tmp_path / "c.db"
    documents = write(tmp_path / "documents", {"1.xml": esi(device())})
    ingested(db, documents)
    (documents / "1.xml").unlink()
    with Catalog.open(db, read_only=True) as reader:
        with closing(sqlite3.connect(db)) as connection:
            connection.execute("PRAGMA journal_mode = WAL")
            assert len(reader.devices()) == 1
        assert quietly("ingest", documents, "--prune", "--db", db).exit_code == 0
        assert reader.devices() == []
        write(documents, {"2.xml": esi(device())})
        assert quietly("ingest", documents, "--db", db).exit_code == 0
        assert len(reader.devices()) == 1
    assert_consistent(db)


def test_a_lock_file_that_a_killed_ingest_left_is_no_obstacle(tmp_path, library, expected):
    (tmp_path / "c.db-ingest").write_bytes(b"")
    assert_completed_by_running_again(tmp_path / "c.db", expected, library)


# Interrupts.


@pytest.mark.parametrize(
    ("number", "code", "whom", "seconds"),
    some_of(
        [
            (number, code, whom, seconds)
            for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143))
            for whom in ("group", "parent")
            for seconds in (0.2, 0.4, 0.6)
        ],
        (signal.SIGINT, 130, "group", 0.4),
        (signal.SIGTERM, 143, "parent", 0.4),
    ),
)
def test_an_interrupt_is_one_line_and_leaves_nobody(tmp_path, library, expected, number, code, whom, seconds):
    db = tmp_path / "c.db"
    process = started(*ingest_command(db, library))
    with suppress(subprocess.TimeoutExpired):
        process.wait(seconds)
    workers = children(process)
    if process.poll() is None:
        os.killpg(process.pid, number) if whom == "group" else process.send_signal(number)
    said = process.communicate()[1]
    if process.returncode == code:
        (line,) = filter(None, said.splitlines())
        assert line in ("esicatalog: interrupted", INTERRUPTED), "before it has begun, and later"
    else:
        # Before Python has begun the command, or after its end.
        assert process.returncode in (0, 1, -number, 130)
    assert all_end(workers)
    assert_consistent(db)
    assert_completed_by_running_again(db, expected, library)


INTERRUPTED = "esicatalog: interrupted; nothing stored before is lost, run it again to go on"
INTERRUPTED_IN_A_CALLBACK = """
import os, signal, sys, weakref
from esicatalog.catalog.lock import only_writer
from esicatalog.cli.main import cli

number = int(sys.argv.pop())
# Where a shell has started the tests in the background they, and what they start, ignore it.
signal.signal(signal.SIGINT, signal.default_int_handler)

class Gone:
    pass

class Finder:
    def find_spec(self, name, path, target=None):
        if name == "sqlalchemy.sql.schema":
            gone = Gone()
            self.reference = weakref.ref(gone, lambda _: os.kill(os.getpid(), number))

sys.meta_path.insert(0, Finder())
cli()
"""


@pytest.mark.parametrize(
    ("number", "code"), some_of([(signal.SIGINT, 130), (signal.SIGTERM, 143)], (signal.SIGINT, 130))
)
def test_an_interrupt_while_modules_are_loaded_is_not_lost(tmp_path, library, expected, number, code):
    db = tmp_path / "c.db"
    words = ["ingest", str(library), "--db", str(db), str(int(number))]
    done = subprocess.run([sys.executable, "-c", INTERRUPTED_IN_A_CALLBACK, *words], capture_output=True, text=True)
    assert done.stderr == f"{INTERRUPTED}\n"
    assert done.returncode == code
    assert_completed_by_running_again(db, expected, library)


def test_workers_end_when_nobody_reads_their_answers(tmp_path, library):
    process = started(*ingest_command(tmp_path / "c.db", library))
    while process.poll() is None and not children(process):
        time.sleep(0.01)
    workers = children(process)
    process.kill()
    process.communicate()
    assert workers
    assert all_end(workers)
    assert not any(map(is_alive, workers))


# Damage.


def header(content: bytearray) -> None:
    content[16:40] = b"\xff" * 24


def magic(content: bytearray) -> None:
    content[:16] = bytes(16)


def zeros_in_the_middle(content: bytearray) -> None:
    middle = len(content) // 2
    content[middle : middle + 100_000] = bytes(100_000)


def noise_in_the_middle(content: bytearray) -> None:
    middle = len(content) // 3
    content[middle : middle + 100_000] = random.Random(SEED).randbytes(100_000)


def schema_page(content: bytearray) -> None:
    content[100:4096] = random.Random(SEED).randbytes(3996)


def truncated(content: bytearray) -> None:
    del content[len(content) // 2 :]


def one_page(content: bytearray) -> None:
    del content[4096:]


def nothing(content: bytearray) -> None:
    content.clear()


def text(content: bytearray) -> None:
    content[:] = b"This is a letter to the editor.\n" * 400


DAMAGE = [header, magic, zeros_in_the_middle, noise_in_the_middle, schema_page, truncated, one_page, nothing, text]
COMMANDS = [
    *READING,
    ("devices", "--text", "T1"),
    ("devices", "--maps", "0x7000"),
    ("identify", "0x101", "2", "1", "--format", "json"),
    ("export", "esi", "0x101:2:1"),
    ("export", "igh", "0x101:2:1"),
    ("lint",),
    ("ingest", "{library}", "--jobs", "1"),
]


@pytest.mark.parametrize("damage", DAMAGE, ids=lambda function: function.__name__)
def test_a_damaged_catalog_is_named_by_every_command(tmp_path, whole, library, damage):
    """Some commands need only what is whole: they may answer; none says more than one line, none fails otherwise."""
    db = tmp_path / "c.db"
    refused = []
    for words in COMMANDS:
        content = bytearray(whole.read_bytes())
        damage(content)
        db.write_bytes(content)
        result = quietly(*(word.format(library=library) for word in words), "--db", db)
        assert result.exit_code in (0, 1, 2), words
        if result.exit_code == 2:
            refused.append(words[0])
            (line,) = result.stderr.splitlines()
            assert line.startswith(f"esicatalog: {db}: ")
            assert any(hint in line for hint in ("ingest", "name another", "damaged")), line
    assert "check" in refused or damage in (zeros_in_the_middle, noise_in_the_middle)
    content = bytearray(whole.read_bytes())
    damage(content)
    db.write_bytes(content)
    assert quietly("check", "--db", db).exit_code in (1, 2)


@pytest.mark.parametrize("number", [*range(6), 9, *(pytest.param(n, marks=pytest.mark.faults) for n in range(10, 60))])
def test_bytes_overwritten_anywhere_never_end_in_a_traceback(tmp_path, whole, number):
    print(f"ESICATALOG_SEED={SEED}")
    chosen = random.Random(f"{SEED} {number}")
    content = bytearray(whole.read_bytes())
    for _ in range(chosen.choice([1, 10, 200])):
        at = chosen.randrange(len(content))
        content[at] = chosen.randrange(256)
    db = tmp_path / "c.db"
    db.write_bytes(content)
    for words in COMMANDS[:-1]:
        result = quietly(*words, "--db", db)
        assert result.exit_code in (0, 1, 2), (words, result.output)


@pytest.mark.parametrize("column", ["names", "alternative_types"])
def test_a_value_that_is_no_json_is_damage(tmp_path, whole, column):
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    with closing(sqlite3.connect(db)) as connection:
        connection.execute(f"UPDATE devices SET {column} = '{{'")
        connection.commit()
    result = quietly("show", "0x101:2:1", "--db", db)
    (line,) = result.stderr.splitlines()
    assert (result.exit_code, "damaged; delete it and ingest again" in line) == (2, True)


@pytest.mark.parametrize("suffix", ["-journal", "-wal", "-shm"])
@pytest.mark.parametrize("content", [b"", b"\0" * 4096, b"noise" * 3000], ids=["empty", "zeros", "noise"])
def test_files_left_beside_a_catalog_do_not_harm_it(tmp_path, whole, suffix, content):
    """What SQLite finds to be no journal of its own is ignored."""
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    db.with_name(f"c.db{suffix}").write_bytes(content)
    with Catalog.open(db) as catalog:
        assert catalog.check().problems == []


@pytest.mark.parametrize("words", [*READING[:5], ("check",), ("lint",)], ids=lambda words: words[0])
@pytest.mark.parametrize("kind", ["missing", "older", "newer", "foreign", "folder", "two versions"])
def test_what_is_no_catalog_of_this_version_is_one_line(tmp_path, whole, kind, words):
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    hint = make_unusable(db, kind)
    result = quietly(*words, "--db", db)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"esicatalog: {db}: ")
    assert hint in line


@pytest.mark.parametrize("kind", ["missing", "older", "newer", "foreign", "folder", "two versions"])
def test_serve_refuses_what_is_no_catalog_of_this_version(tmp_path, whole, kind):
    db = Path(shutil.copy(whole, tmp_path / "c.db"))
    hint = make_unusable(db, kind)
    assert hint in refused("serve", "--db", db, "--port", "0")


def make_unusable(db: Path, kind: str) -> str:
    """Change a catalog so; returns what has to be said then."""
    statement, hint = {
        "older": ("UPDATE alembic_version SET version_num = '0001'", "upgrade it with: esicatalog migrate --db"),
        "newer": ("UPDATE alembic_version SET version_num = '9999'", "use that version or ingest into a new catalog"),
        "two versions": ("INSERT INTO alembic_version VALUES ('0001')", "delete it and ingest again"),
        "foreign": ("DROP TABLE alembic_version", "other tables than a catalog's; name another one"),
    }.get(kind, (None, ""))
    if statement is not None:
        with closing(sqlite3.connect(db)) as connection:
            connection.execute(statement)
            connection.commit()
        return hint
    db.unlink()
    if kind == "folder":
        db.mkdir()
        return "the file or its folder cannot be opened"
    return "make one with: esicatalog ingest PATH --db"
