"""What changes, vanishes or dies while it is read costs its own document and nothing else."""

import errno
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import msgspec
import pytest
from snippets import device, esi, write

from esicatalog import Catalog
from esicatalog.esi import containers, documents
from esicatalog.esi.reader import Reader
from esicatalog.ingest import plan as planning
from esicatalog.ingest import run as _run  # noqa: F401  (it must not be loaded while a test has changed the plan)
from esicatalog.ingest import this_process
from esicatalog.ingest.pool import Pool
from esicatalog.ingest.process import Helper
from esicatalog.ingest.tasks import Known, Task

GOOD = "good.xml"
KEPT = "; the catalog keeps what it has of it"
DIED = "the reading process died (out of memory or a crash)"


def ingest_changed(tmp_path, monkeypatch, change, jobs: int = 2) -> dict[str, tuple[str, str | None]]:
    """Ingest a folder that ``change`` alters between finding and reading its documents."""
    make_plan = planning.make_plan

    def planned(*arguments, **named):
        made = make_plan(*arguments, **named)
        change()
        return made

    monkeypatch.setattr(planning, "make_plan", planned)
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        report = catalog.ingest([tmp_path / "in"], jobs=jobs)
        assert catalog.check().problems == []
    return {line.path: (line.status, line.message) for line in report.documents}


@pytest.fixture
def folder(tmp_path) -> Path:
    return write(tmp_path / "in", {GOOD: esi(device()), "victim.xml": esi(device(product="#x2"))})


def becomes_a_pipe(path: Path) -> None:
    path.unlink()
    os.mkfifo(path)


def becomes_a_folder(path: Path) -> None:
    path.unlink()
    path.mkdir()


def becomes_huge(path: Path) -> None:
    os.truncate(path, 2**40)


def becomes_a_device(path: Path) -> None:
    path.unlink()
    path.symlink_to("/dev/zero")


def packed(path: Path, *names: str) -> None:
    with zipfile.ZipFile(path, "w") as archive:
        for name in names:
            archive.writestr(name, esi(device(product="#x3")))


CHANGES = {
    "gone.xml": (Path.unlink, "No such file"),
    "pipe.xml": (becomes_a_pipe, "not a regular file"),
    "device.xml": (becomes_a_device, "not a regular file"),
    "folder.xml": (becomes_a_folder, "cannot be read"),
    "huge.xml": (becomes_huge, "larger than 256 MB"),
    "empty.xml": (lambda path: os.truncate(path, 0), "the file is empty"),
    "gone.zip": (Path.unlink, "No such file"),
    "pipe.zip": (becomes_a_pipe, "not a regular file"),
    "cut.zip": (lambda path: os.truncate(path, 30), "not a usable zip archive"),
    "other.zip": (lambda path: packed(path, "other.xml"), "ingest again"),
}
"""What becomes of a file, and what is said then."""


@pytest.mark.parametrize("jobs", [1, 2])
def test_files_and_archives_that_change_between_finding_and_reading(tmp_path, folder, monkeypatch, jobs):
    for name in CHANGES:
        if name.endswith(".zip"):
            packed(folder / name, "a.xml")
        else:
            write(folder, {name: esi(device(product="#x3"))})

    def change() -> None:
        for name, (changed, _) in CHANGES.items():
            changed(folder / name)

    lines = ingest_changed(tmp_path, monkeypatch, change, jobs)
    for name, (_, words) in CHANGES.items():
        status, message = lines[f"{name}!a.xml" if name.endswith(".zip") else name]
        assert (status, words in message) == ("failed", True), name
    assert lines[GOOD] == ("stored", None)


def test_an_archive_that_vanishes_before_it_is_looked_into(tmp_path, folder, monkeypatch):
    packed(folder / "a.zip", "a.xml")
    discover = planning.discover

    def vanishing(*arguments):
        for item in discover(*arguments):
            if item.member == "a.zip":
                (folder / "a.zip").unlink()
            yield item

    monkeypatch.setattr(planning, "discover", vanishing)
    lines = ingest_changed(tmp_path, monkeypatch, lambda: None)
    assert lines["a.zip"][0] == "failed"
    assert lines[GOOD] == ("stored", None)


def test_what_an_unreadable_archive_brought_before_stays(tmp_path, folder, monkeypatch):
    packed(folder / "a.zip", "a.xml")
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
        digest = planning._file_sha256

        def closed(path: str) -> str:
            if path.endswith("a.zip"):
                raise PermissionError(13, "Permission denied")
            return digest(path)

        monkeypatch.setattr(planning, "_file_sha256", closed)
        report = catalog.ingest([tmp_path / "in"], jobs=1, prune=True)
        assert ("a.zip", "failed") in {(line.path, line.status) for line in report.documents}
        assert [device.product_code for device in catalog.devices() if device.product_code == 3] == [3]


def test_members_of_a_changed_archive_go_whatever_the_folder_is_called(tmp_path):
    folder = write(tmp_path / "in!side", {GOOD: esi(device())})
    packed(folder / "a.zip", "a.xml", "b.xml")
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([folder], jobs=1)
        packed(folder / "a.zip", "a.xml")
        catalog.ingest([folder], jobs=1)
        report = catalog.ingest([folder], jobs=1)
    assert sorted(line.path for line in report.documents) == ["a.zip!a.xml", GOOD]


def test_a_fault_of_the_reader_costs_its_document(tmp_path, folder, monkeypatch):
    read = Reader.read_tree

    def faulty(self, content, member="", container=None):
        if member == "victim.xml":
            raise KeyError("a fault")
        return read(self, content, member, container)

    monkeypatch.setattr(Reader, "read_tree", faulty)
    lines = ingest_changed(tmp_path, monkeypatch, lambda: None, jobs=1)
    status, message = lines["victim.xml"]
    assert status == "failed"
    where = r"KeyError in esicatalog/ingest/worker\.py, line [1-9]\d*"
    assert re.fullmatch(rf"not foreseen by the reader \({where}\); please report it with the document", message)
    assert lines[GOOD] == ("stored", None)


def children(process: int) -> list[int]:
    """Processes that a process has started."""
    tasks = Path(f"/proc/{process}/task").glob("*/children")
    return [int(child) for task in tasks for child in task.read_text().split()]


@pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="finds the workers through /proc")
def test_a_killed_worker_costs_one_document(tmp_path):
    names = [f"{number:02}.xml" for number in range(8)]
    content = "".join(device("<Sm>Outputs</Sm>" * 20, product=f"#x{n:X}") for n in range(1, 400))
    write(tmp_path / "in", dict.fromkeys(names, esi(content)))
    command = [sys.executable, "-m", "esicatalog", "ingest", str(tmp_path / "in"), "--db", str(tmp_path / "c.db")]
    process = subprocess.Popen([*command, "--jobs", "2", "--format", "json"], stdout=subprocess.PIPE, text=True)
    while not (workers := children(process.pid)) and process.poll() is None:
        time.sleep(0.001)
    os.kill(workers[0], signal.SIGKILL)
    output, _ = process.communicate(timeout=120)
    documents = json.loads(output)["documents"]
    failed = [line for line in documents if line["status"] == "failed"]
    assert [line["message"] for line in failed] == [DIED]
    assert [line["status"] for line in documents].count("stored") == len(names) - 1
    assert process.returncode == 1
    with Catalog.open(tmp_path / "c.db") as catalog:
        assert catalog.check().problems == []
        again = catalog.ingest([tmp_path / "in"], jobs=1)
    assert again.counts["failed"] == 0, "the next ingest reads it"


def test_a_document_past_its_deadline_is_given_up_and_the_next_is_read(tmp_path):
    slow = esi(device("<Sm>Outputs</Sm>" * 50_000))
    write(tmp_path, {"slow.xml": slow, GOOD: esi(device())})
    tasks = [Task(number, str(tmp_path), False, (), name) for number, name in enumerate(("slow.xml", GOOD))]
    pool = Pool(tasks[:1], 1, deadline_seconds=0.01)
    pool.start()
    (outcome,) = pool.outcomes()
    pool.stop()
    assert (outcome.status, outcome.message) == ("failed", "gave up after 0 s")
    pool = Pool(tasks, 1)
    pool.start()
    outcomes = {outcome.number: outcome.status for outcome in pool.outcomes()}
    pool.stop()
    assert outcomes == {0: "stored", 1: "stored"}


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no alarm")
def test_a_document_without_end_is_given_up_where_the_ingest_itself_reads(tmp_path, monkeypatch):
    """Also one that it refers to: a dictionary that was given up is none that cannot be used."""
    dictionary = "<EtherCATDict><Dictionary><DataTypes/><Objects/></Dictionary></EtherCATDict>"
    refers = esi(device("<Profile><DictionaryFile>endless.xml</DictionaryFile></Profile>", product="#x2"))
    folder = write(tmp_path / "in", {"endless.xml": dictionary, "refers.xml": refers, GOOD: esi(device())})

    def endless(root) -> bool:
        while root.tag == "EtherCATDict":
            pass
        return False

    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        with monkeypatch.context() as patch:
            patch.setattr(this_process, "DEADLINE_SECONDS", 0.3)
            patch.setattr(documents, "_HAS_TOO_MANY_ATTRIBUTES", endless)
            report = catalog.ingest([folder], jobs=1)
        given_up = ("failed", "gave up after 0 s")
        assert {line.path: (line.status, line.message) for line in report.documents} == {
            "endless.xml": given_up,
            "refers.xml": given_up,
            GOOD: ("stored", None),
        }
        assert catalog.ingest([folder], jobs=1).counts["stored"] == 2
        assert catalog.check().problems == []


def test_long_requests_and_long_answers_do_not_wait_for_each_other(tmp_path):
    names = [f"{number}.xml" for number in range(3)]
    for number, name in enumerate(names):
        devices = (device("<Sm>Outputs</Sm>" * 6_000, product=f"#x{number}{n}") for n in range(1, 9))
        write(tmp_path, {name: esi("".join(devices))})
    known = Known("", tuple((f"{number}.xml", "0" * 64) for number in range(10_000)))
    pool = Pool([Task(number, str(tmp_path), False, (), name, known) for number, name in enumerate(names)], 1, 60)
    pool.start()
    outcomes = list(pool.outcomes())
    pool.stop()
    assert [outcome.status for outcome in outcomes] == ["stored"] * len(names)
    assert min(len(msgspec.msgpack.encode(outcome)) for outcome in outcomes) > 2**20


def closed_to_us(monkeypatch, *paths: Path) -> None:
    """These files and folders cannot be opened from now on, whoever runs the test."""
    names = {os.fspath(path) for path in paths}

    def refusing(function):
        def opened(path, *arguments, **named):
            if os.fspath(path) in names:
                raise PermissionError(13, "Permission denied", os.fspath(path))
            return function(path, *arguments, **named)

        return opened

    for owner, name in ((os, "scandir"), (os, "open"), (io, "open")):
        monkeypatch.setattr(owner, name, refusing(getattr(owner, name)))


@pytest.fixture
def stored(tmp_path, folder) -> Catalog:
    """A catalog of the folder, with documents below a subfolder, one of these in an archive."""
    write(folder, {"sub/deep/b.xml": esi(device(product="#x5"))})
    packed(folder / "sub" / "a.zip", "a.xml")
    catalog = Catalog.open(tmp_path / "c.db", create=True)
    catalog.ingest([folder], jobs=1)
    return catalog


def products(catalog: Catalog) -> list[int | None]:
    return sorted(found.product_code for found in catalog.devices())


def reported(catalog: Catalog, *paths: Path, prune: bool = False, jobs: int = 1) -> dict[str, tuple[str, str | None]]:
    report = catalog.ingest(paths, jobs=jobs, prune=prune)
    assert catalog.check().problems == []
    return {line.path: (line.status, line.message) for line in report.documents}


def test_nothing_below_an_unreadable_folder_is_pruned(folder, stored, monkeypatch):
    before = stored.content_hash()
    with monkeypatch.context() as changed:
        closed_to_us(changed, folder / "sub")
        (folder / "victim.xml").unlink()
        lines = reported(stored, folder, prune=True)
    assert lines.pop("victim.xml")[0] == "removed"
    assert lines == {GOOD: ("unchanged", None), "sub": ("failed", "folder cannot be read: Permission denied")}
    assert products(stored) == [1, 3, 5]
    write(folder, {"victim.xml": esi(device(product="#x2"))})
    assert {status for status, _ in reported(stored, folder, prune=True).values()} == {"stored", "unchanged"}
    assert stored.content_hash() == before


def test_an_unreadable_root_does_not_empty_the_catalog(folder, stored, monkeypatch):
    closed_to_us(monkeypatch, folder)
    assert reported(stored, folder, prune=True) == {".": ("failed", "folder cannot be read: Permission denied")}
    assert products(stored) == [1, 2, 3, 5]


@pytest.mark.parametrize("prune", [False, True])
def test_what_an_unreadable_file_brought_before_stays(folder, stored, monkeypatch, prune):
    before = stored.content_hash()
    with monkeypatch.context() as changed:
        closed_to_us(changed, folder / "victim.xml", folder / "sub" / "a.zip")
        lines = reported(stored, folder, prune=prune)
    assert lines["victim.xml"] == ("failed", f"cannot be read: Permission denied{KEPT}")
    assert lines["sub/a.zip"] == ("failed", "cannot be read: Permission denied")
    assert products(stored) == [1, 2, 3, 5]
    assert {status for status, _ in reported(stored, folder, prune=True).values()} == {"unchanged"}
    assert stored.content_hash() == before


def raising(error: BaseException):
    def raised(*arguments):
        raise error

    return raised


@pytest.mark.parametrize("packs", [False, True])
@pytest.mark.parametrize(
    ("jobs", "owner", "name", "reading", "words"),
    [
        (2, Helper, "receive", lambda *arguments: None, DIED),
        (2, Helper, "receive", raising(TimeoutError()), "gave up after 120 s"),
        (1, Reader, "read_tree", raising(MemoryError()), "needs more memory than a document may take"),
    ],
)
def test_what_a_document_brought_stays_when_it_is_not_read_to_its_end(
    folder, stored, monkeypatch, packs, jobs, owner, name, reading, words
):
    def changed(product: str) -> list[str]:
        content = esi(device(product=product)).encode()
        if packs:
            (folder / "sub" / "a.zip").write_bytes(zipped(a=content, b=content))
            return ["sub/a.zip!a.xml", "sub/a.zip!b.xml"]
        write(folder, {GOOD: esi(device(product=product)), "victim.xml": esi(device(product=product))})
        return [GOOD, "victim.xml"]

    changed("#x6")
    reported(stored, folder)
    before = stored.content_hash()
    names = changed("#x7")
    with monkeypatch.context() as broken:
        broken.setattr(owner, name, reading)
        lines = reported(stored, folder, prune=True, jobs=jobs)
        assert {lines[name] for name in names} == {("failed", words + KEPT)}
        assert stored.content_hash() == before
    lines = reported(stored, folder)
    assert {lines[name] for name in names} == {("stored", None)}
    assert 6 not in products(stored)
    assert 7 in products(stored)


def zipped(**members: bytes) -> bytes:
    """An archive of members by name, without their suffix."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name, content in members.items():
            archive.writestr(f"{name}.zip" if content[:2] == b"PK" else f"{name}.xml", content)
    return stream.getvalue()


@pytest.mark.parametrize("error", [OSError(errno.EIO, "Input/output error"), MemoryError()])
@pytest.mark.parametrize("name", ["a.xml", "inner.zip", None])
def test_what_an_unreadable_part_of_a_changed_archive_brought_before_stays(tmp_path, folder, monkeypatch, name, error):
    """A member, an archive inside the archive, and the directory of the archive itself."""
    archive = folder / "a.zip"
    inner = zipped(c=esi(device(product="#x4")).encode())
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        archive.write_bytes(zipped(a=esi(device(product="#x3")).encode(), inner=inner))
        reported(catalog, folder)
        before = catalog.content_hash()
        archive.write_bytes(zipped(a=esi(device(product="#x3")).encode(), inner=inner, b=b"<other/>"))
        expanded, read = containers.Archive._expanded, containers._Guarded.read

        def refusing(self, info):
            if info.filename == name:
                raise error
            return expanded(self, info)

        def refused(*arguments):
            raise error

        with monkeypatch.context() as changed:
            changed.setattr(containers.Archive, "_expanded", refusing)
            changed.setattr(containers._Guarded, "read", read if name else refused)
            lines = reported(catalog, folder, prune=True)
        why = getattr(error, "strerror", None) or "not enough memory"
        told = f"cannot be read: {why}{KEPT if name == 'a.xml' else ''}"
        assert lines[f"a.zip!{name}" if name else "a.zip"] == ("failed", told)
        assert products(catalog) == [1, 2, 3, 4]
        read_again = reported(catalog, folder, prune=True)
        assert {status for status, _ in read_again.values()} == {"unchanged", "skipped"}
        assert "a.zip!b.xml" in read_again
        assert catalog.content_hash() == before


def test_what_a_file_brought_whose_folder_may_only_be_listed_stays(folder, stored, monkeypatch):
    stat = os.stat

    def refusing(path, *arguments, **named):
        if not isinstance(path, int) and Path(path).parent == folder / "sub":
            raise PermissionError(13, "Permission denied", os.fspath(path))
        return stat(path, *arguments, **named)

    closed_to_us(monkeypatch, folder / "sub" / "deep")
    monkeypatch.setattr(os, "stat", refusing)
    lines = reported(stored, folder, prune=True)
    assert (lines["sub/a.zip"][0], lines["sub/deep"][0]) == ("failed", "failed")
    assert products(stored) == [1, 2, 3, 5]


def test_a_document_keeps_a_dictionary_that_cannot_be_read(tmp_path, folder, monkeypatch):
    profile = "<Profile><DictionaryFile>d.xml</DictionaryFile></Profile>"
    declared = "<Object><Index>#x2000</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    external = f"<EtherCATDict><Dictionary><DataTypes/><Objects>{declared}</Objects></Dictionary></EtherCATDict>"
    write(folder, {"victim.xml": esi(device(profile, product="#x2")), "d.xml": external})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([folder], jobs=1)
        closed_to_us(monkeypatch, folder / "d.xml")
        lines = reported(catalog, folder)
        assert (lines["d.xml"][0], lines["victim.xml"][0]) == ("failed", "unchanged")
        assert [found.product_code for found in catalog.devices(objects=[(0x2000, None)])] == [2]


def test_an_archive_that_is_whole_again_has_no_failed_line(tmp_path):
    folder = write(tmp_path / "in", {GOOD: esi(device())})
    packed(folder / "a.zip", "a.xml")
    whole = (folder / "a.zip").read_bytes()
    (folder / "a.zip").write_bytes(whole[:100])
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        for _ in range(2):
            lines = reported(catalog, folder)
            assert lines["a.zip"][0] == "failed"
            assert "not a usable zip archive" in lines["a.zip"][1]
        (folder / "a.zip").write_bytes(whole)
        for status in ("stored", "unchanged"):
            assert reported(catalog, folder) == {GOOD: ("unchanged", None), "a.zip!a.xml": (status, None)}
        (folder / "a.zip").write_bytes(whole[:100])
        lines = reported(catalog, folder)
        assert {path: status for path, (status, _) in lines.items()} == {
            GOOD: "unchanged",
            "a.zip": "failed",
            "a.zip!a.xml": "removed",
        }
        assert products(catalog) == [1]


def test_an_archive_that_can_be_read_again_has_no_failed_line(folder, stored, monkeypatch):
    with monkeypatch.context() as changed:
        closed_to_us(changed, folder / "sub" / "a.zip", folder / "sub" / "deep")
        reported(stored, folder)
    names = [GOOD, "sub/a.zip!a.xml", "sub/deep/b.xml", "victim.xml"]
    assert sorted(reported(stored, folder)) == names
    with stored._connection() as connection:
        assert sorted(connection.exec_driver_sql("SELECT member FROM sources").scalars()) == names


def test_a_file_and_the_members_of_an_archive_of_its_name_displace_each_other(folder, stored):
    archive = folder / "sub" / "a.zip"
    archive.write_text(esi(device(product="#x6")))
    assert reported(stored, folder)["sub/a.zip"] == ("stored", None)
    assert products(stored) == [1, 2, 5, 6]
    packed(archive, "a.xml")
    lines = reported(stored, archive)
    assert {path: status for path, (status, _) in lines.items()} == {"sub/a.zip": "removed", "a.zip!a.xml": "stored"}
    assert products(stored) == [1, 2, 3, 5]


def test_a_file_and_what_a_folder_of_its_name_held_displace_each_other(folder, stored):
    shutil.rmtree(folder / "sub")
    write(folder, {"sub": esi(device(product="#x6"))})
    reported(stored, folder)
    assert products(stored) == [1, 2, 6]
    (folder / "sub").unlink()
    write(folder, {"sub/b.xml": esi(device(product="#x5"))})
    reported(stored, folder)
    assert products(stored) == [1, 2, 5]


def test_a_folder_that_is_called_like_a_member_of_a_changed_archive_stays(folder, stored):
    archive = folder / "sub" / "a.zip"
    write(folder, {"sub/a.zip!q/b.xml": esi(device(product="#x7"))})
    reported(stored, folder)
    packed(archive, "other.xml")
    lines = reported(stored, archive)
    assert {path: status for path, (status, _) in lines.items()} == {
        "sub/a.zip!other.xml": "stored",
        "sub/a.zip!a.xml": "removed",
    }
    assert products(stored) == [1, 2, 3, 5, 7]


def test_members_that_cannot_be_named_are_reported_of_an_unchanged_archive_too(tmp_path):
    folder = write(tmp_path / "in", {})
    folder.mkdir()
    packed(folder / "a.zip", "a.xml", "b\nb.xml")
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        first = reported(catalog, folder, prune=True)
        assert {path: status for path, (status, _) in reported(catalog, folder, prune=True).items()} == {
            "a.zip!a.xml": "unchanged",
            "a.zip!b\\nb.xml": "failed",
        }
        assert set(first) == {"a.zip!a.xml", "a.zip!b\\nb.xml"}
