"""Helpers of an ingest: copies of its process where that is safe, with nothing of it but what they need."""

import json
import signal
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import pytest
from snippets import device, esi, one, write

from esicatalog import Catalog
from esicatalog.errors import UnreadableDocument
from esicatalog.esi.content import sha256_hex
from esicatalog.ingest import this_process

pytestmark = pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="processes are copied only with /proc")

HEAD = """
import json, os, signal, sys, threading
from esicatalog.ingest.process import can_fork, forked, read_frame, write_frame

def answer(value):
    def serve(requests, answers):
        while read_frame(requests.read) is not None:
            write_frame(answers, json.dumps(value()).encode())
    helper = forked(serve)
    helper.send(b"")
    said = helper.receive(60)
    helper.end()
    return said and json.loads(said)
"""


def told_by(code: str, *words: object, **options: object) -> object:
    """What a fresh interpreter prints, as JSON."""
    command = [sys.executable, "-c", HEAD + code, *map(str, words)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120, **options)
    assert done.stderr == ""
    return json.loads(done.stdout)


@pytest.mark.parametrize(
    ("before", "expected"),
    [
        ("", True),
        ("import esicatalog.ingest.pool, lxml.etree", True),
        ("import sqlalchemy", False),
        ("threading.Thread(target=threading.Event().wait, daemon=True).start()", False),
    ],
)
def test_a_process_with_threads_or_the_database_library_is_not_copied(before, expected):
    assert told_by(f"{before}\nprint(json.dumps(can_fork()))") is expected


def test_a_copy_holds_nothing_open_but_its_two_pipes(tmp_path):
    code = """
held = open(sys.argv[1], "w")
paths = lambda: [f"/proc/self/fd/{number}" for number in os.listdir("/proc/self/fd")]
print(json.dumps(answer(lambda: [os.readlink(path) for path in paths() if os.path.lexists(path)])))
"""
    found = [name.split(":")[0] for name in told_by(code, tmp_path / "held")]
    assert set(found) == {"/dev/null", "pipe"}
    assert found.count("pipe") == 2


def test_a_copy_ignores_ctrl_c_and_does_not_do_what_this_process_does_on_other_signals():
    code = """
signal.signal(signal.SIGTERM, lambda number, frame: None)
names = ("SIGINT", "SIGTERM")
print(json.dumps(answer(lambda: [int(signal.getsignal(getattr(signal, name))) for name in names])))
"""
    assert told_by(code) == [1, 0], "ignored, the default"


@pytest.mark.parametrize("ignored", [False, True])
def test_a_copy_that_ended_has_no_answer(ignored):
    code = f"""
if {ignored}:
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
print(json.dumps(answer(lambda: os._exit(1))))
"""
    assert told_by(code) is None


def test_what_fails_in_a_copy_does_not_go_on_as_this_process():
    code = """
try:
    said = answer(lambda: 1 / 0)
finally:
    print("null")
"""
    assert told_by(code) is None


def test_a_copy_prints_nothing_of_what_this_process_was_about_to_print():
    assert told_by("sys.stdout.write('[1, ')\nsaid = answer(lambda: print('x', flush=True))\nprint('2]')") == [1, 2]


NO_ROOM = """
import errno
def refused():
    raise BlockingIOError(errno.EAGAIN, "Resource temporarily unavailable")
os.fork = refused
"""


def test_where_nothing_can_be_copied_nothing_of_the_attempt_stays():
    code = """
state = lambda: (signal.pthread_sigmask(signal.SIG_BLOCK, []), os.listdir("/proc/self/fd"))
before = state()
copy = forked(print)
print(json.dumps([copy, state() == before]))
"""
    assert told_by(NO_ROOM + code) == [None, True]


def test_where_nothing_can_be_copied_documents_are_read_in_new_interpreters(tmp_path):
    code = """
from esicatalog import Catalog
with Catalog.open(sys.argv[1], create=True) as catalog:
    reports = [catalog.ingest(sys.argv[2], jobs=2) for _ in range(2)]
print(json.dumps([report.counts for report in reports]))
"""
    folder = write(tmp_path / "in", {f"{n}.xml": esi(device(product=f"#x{n:X}")) for n in range(1, 4)})
    first, second = told_by(NO_ROOM + code, tmp_path / "c.db", folder)
    assert (first["stored"], second["unchanged"]) == (3, 3)
    assert told_by(NO_ROOM + HASH, 0, folder) == {}


HASH = """
import time
from contextlib import contextmanager
from esicatalog.ingest.ahead import HashingAhead
count, *paths = sys.argv[1:]
pause, hashes = 0.1, {}
while pause < 30:
    hashing = HashingAhead(paths)
    time.sleep(pause)
    hashes = hashing.take()
    if sum(map(len, hashes.values())) == int(count):
        break
    pause *= 2
print(json.dumps(hashes))
"""
"""Hashes so many files; what is not hashed when it is asked for never is, and how long that takes nobody knows."""


def test_plain_files_are_hashed_ahead_as_they_are_hashed_later(tmp_path):
    folder = write(tmp_path / "in", {"a.xml": "first", "b/c.xml": "second", "d.zip": "PK\3\4"})
    assert told_by(HASH, 2, folder) == {
        str(folder): {"a.xml": sha256_hex(b"first"), "b/c.xml": sha256_hex(b"second")},
    }


def test_paths_that_do_not_exist_are_left_to_the_plan(tmp_path):
    assert told_by(HASH, 0, tmp_path / "nowhere") == {}


def ingest(db: Path, folder: Path, redirection: str = "") -> subprocess.CompletedProcess[str]:
    command = f'"{sys.executable}" -m esicatalog ingest "{folder}" --db "{db}" --jobs 2 --format json {redirection}'
    return subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=120, check=False)


def test_what_changed_is_found_by_hashes_made_ahead(tmp_path):
    folder = write(tmp_path / "in", {f"{n}.xml": esi(device(product=f"#x{n:X}")) for n in range(1, 4)})
    assert ingest(tmp_path / "c.db", folder).returncode == 0
    (folder / "2.xml").write_text(esi(device(product="#x22")))
    report = json.loads(ingest(tmp_path / "c.db", folder).stdout)
    assert {line["path"]: line["status"] for line in report["documents"]} == {
        "1.xml": "unchanged",
        "2.xml": "stored",
        "3.xml": "unchanged",
    }


@pytest.mark.parametrize(
    "redirection",
    ["<&- >&- 2>&-", *(pytest.param(text, marks=pytest.mark.faults) for text in ("<&-", ">&-", "<&- >&-", "2>&-"))],
)
def test_an_ingest_without_standard_streams_stores_all(tmp_path, redirection):
    folder = write(tmp_path / "in", {f"{n}.xml": esi(device(product=f"#x{n:X}")) for n in range(1, 9)})
    assert ingest(tmp_path / "c.db", folder, redirection).returncode == 0
    assert one(tmp_path / "c.db", "SELECT count(*) FROM sources WHERE status = 'stored'") == 8
    with Catalog.open(tmp_path / "c.db") as catalog:
        assert catalog.check().problems == []


def test_time_is_limited_in_the_main_thread_and_where_nobody_else_has_set_an_alarm(monkeypatch):
    monkeypatch.setattr(this_process, "DEADLINE_SECONDS", 0.05)
    ended: list[str] = []

    def wait() -> None:
        try:
            with this_process.limited_time():
                time.sleep(0.2)
            ended.append("at its end")
        except UnreadableDocument:
            ended.append("by the limit")

    thread = threading.Thread(target=wait)
    thread.start()
    thread.join()
    with someones_alarm():
        wait()
        assert signal.getitimer(signal.ITIMER_REAL)[0] > 0
    wait()
    assert ended == ["at its end", "at its end", "by the limit"]


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_a_document_ends_though_an_object_that_ended_took_the_first_alarm(monkeypatch):
    """What is raised in ``__del__`` is lost, and the search for cycles ends objects at any moment."""
    monkeypatch.setattr(this_process, "DEADLINE_SECONDS", 0.05)

    class Lingering:
        def __del__(self) -> None:
            time.sleep(0.1)

    with pytest.raises(UnreadableDocument), this_process.limited_time():
        Lingering()
        time.sleep(5)


def test_somebody_elses_alarm_is_delivered_while_time_is_limited():
    with someones_alarm() as alarms, this_process.limited_time():
        signal.raise_signal(signal.SIGALRM)
    assert alarms == [signal.SIGALRM]


@contextmanager
def someones_alarm():
    """An alarm that is still pending after all that is done here, with what it has delivered."""
    alarms: list[int] = []
    theirs = signal.signal(signal.SIGALRM, lambda number, frame: alarms.append(number))
    signal.setitimer(signal.ITIMER_REAL, 60)
    try:
        yield alarms
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, theirs)


def test_ctrl_c_ends_what_has_a_limit_of_time():
    # What a shell runs in the background ignores it.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt), this_process.limited_time():
            signal.raise_signal(signal.SIGINT)
    finally:
        signal.signal(signal.SIGINT, before)
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)
