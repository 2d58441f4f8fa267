"""The command contract: exit codes, one line for every error, JSON alone on stdout."""

import errno
import json
import os
import re
import shutil
import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest
from click.testing import CliRunner
from snippets import device, esi, rows, write
from sqlalchemy.exc import OperationalError

from esicatalog import Catalog
from esicatalog.catalog.driver_errors import database_error
from esicatalog.cli.main import COMMANDS, cli

EYOU = ("0x1097", "0x2406", "0x8f")


def run(*words: object, db: Path | None = None, stdin: str | None = None):
    arguments = [str(word) for word in words] + (["--db", str(db)] if db is not None else [])
    return CliRunner().invoke(cli, arguments, input=stdin, catch_exceptions=False)


def one_line_error(result) -> str:
    """The single line on stderr of a command that could not do its work."""
    assert result.exit_code == 2
    assert result.stdout == ""
    assert "Traceback" not in result.stderr
    (line,) = result.stderr.splitlines()
    return line


@pytest.mark.parametrize("vendor", ["0x1097", "#x1097", "4247"])
def test_identify_in_every_notation(data_db, vendor):
    result = run("identify", vendor, "0x2406", "143", "--format", "json", db=data_db)
    answer = json.loads(result.stdout)
    assert (result.exit_code, answer["match"]) == (0, "exact")
    assert answer["query"].items() >= {"vendor_id": 0x1097, "product_code": 0x2406, "revision_no": 0x8F}.items()
    assert answer["query"]["vendor_id_hex"] == "0x00001097"
    assert answer["device"]["type"] == "EYOU_ServoModule_V143"
    assert [source["member"] for source in answer["device"]["sources"]] == ["eyou_servo_module.xml"]
    assert answer["variants"] == [answer["device"]]
    assert {"query", "match", "reason", "device", "variants", "candidates", "warnings"} == answer.keys()


def test_the_line_of_a_source_is_that_of_the_device_element(data, data_db):
    answer = json.loads(run("identify", *EYOU, "--format", "json", db=data_db).stdout)
    lines = (data / "eyou_servo_module.xml").read_text().splitlines()
    assert "<Device" in lines[answer["device"]["sources"][0]["line"] - 1]


@pytest.mark.parametrize(
    ("identity", "match", "code"),
    [
        (("0xE5C", "0x0D080808", "0x00110000"), "exact", 0),
        (("0xE5C", "0x0D080808"), "product", 0),
        (("0xE5C", "0x0D080808", "0x00120000"), "accepted", 0),
        (("0xE5C", "0x0D080808", "0x000F0000"), "newer", 0),
        (("0xE5C", "1", "1"), "vendor", 1),
        (("0x999", "1", "1"), "none", 1),
    ],
)
def test_what_identify_answers(data_db, identity, match, code):
    result = run("identify", *identity, "--format", "json", db=data_db)
    answer = json.loads(result.stdout)
    assert (answer["match"], result.exit_code) == (match, code)
    assert (answer["device"] is None) == (code == 1)
    assert bool(answer["candidates"]) == (match == "vendor" or identity[1] == "0x0D080808")
    assert run("identify", *identity, db=data_db).exit_code == code


@pytest.mark.parametrize(
    "words",
    [
        ("identify", "zz", "1"),
        ("identify", "1", "0x1g", "1"),
        ("identify", "1", "2", "0x100000000"),
        ("identify", "1", "2", "9" * 5000),
        ("show", "1"),
        ("show", "1:2@0"),
        ("devices", "--maps", "0x10000"),
        ("devices", "--maps", "0x6000:"),
        ("devices", "--not-maps", "x"),
        ("devices", "--object", "0x6000:999"),
        ("devices", "--bits", "one", "--maps", "0x6000"),
        ("devices", "--bits", "1"),
        ("devices", "--profile", "x"),
        ("devices", "--limit", "-1"),
        ("devices", "--limit", "0x100000000"),
        ("devices", "--limit", "9223372036854775808"),
        ("devices", "--limit", "9" * 4000),
        ("devices", "--vendor", "0xZZ"),
        ("devices", "--vendor", ""),
        ("ingest", "no-such-folder"),
    ],
)
def test_malformed_input_is_one_line_and_exit_2(data_db, words):
    assert one_line_error(run(*words, db=data_db)).startswith("esicatalog: ")


@pytest.mark.parametrize(
    ("words", "says", "command"),
    [
        (("nonsense",), "no such command 'nonsense'", "esicatalog"),
        (("--foo",), "no such option '--foo'", "esicatalog"),
        (("devices", "--foo"), "no such option '--foo'", "esicatalog devices"),
        (("devices", "--sync", "x"), "'x' is not one of 'sync0', 'sync1'", "esicatalog devices"),
        (("check", "--db"), "option '--db' requires an argument", "esicatalog check"),
        (("export", "igh", "--pdo"), "option '--pdo' requires an argument", "esicatalog export igh"),
        (("ingest",), "missing argument", "esicatalog ingest"),
        (("ingest", "x", "--format", "xml"), "'xml' is not one of 'table', 'json'", "esicatalog ingest"),
        (("serve", "--port", "x"), "'x' is not a valid integer", "esicatalog serve"),
        (("serve", "extra"), "unexpected extra argument (extra)", "esicatalog serve"),
        (("export", "nosuch"), "no such command 'nosuch'", "esicatalog export"),
        (("export", "igh", "--bar"), "no such option '--bar'", "esicatalog export igh"),
        (("sii", "decode"), "missing argument 'FILE'", "esicatalog sii decode"),
        *(((name, "--no-such-option"), "no such option", f"esicatalog {name}") for name in COMMANDS),
    ],
)
def test_wrong_usage_is_one_line_and_exit_2(words, says, command):
    result = CliRunner().invoke(cli, words, prog_name="esicatalog")
    line = one_line_error(result)
    assert line.startswith(f"{command}: ")
    assert says in line
    assert line.endswith(f"(see {command} --help)")


def piped(command: str) -> tuple[int, str]:
    """Exit code of the first command of a shell pipe, and what was said on stderr."""
    script = f"{command}; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True)
    return done.returncode, done.stderr


PROGRAM = f"{sys.executable} -m esicatalog"


@pytest.mark.skipif(shutil.which("bash") is None, reason="no bash")
@pytest.mark.parametrize(
    ("words", "option"),
    [
        (("export", "igh", "0x4321:0xe2", "--pdo", "0x1600", "--pdo=0x1601"), "--pdo"),
        (("export", "sii", "0x4321:0xe2", "-o", "a", "--output", "b"), "--output"),
        (("devices", "--mode", "CSV", "--mode", "CSP"), "--mode"),
        (("sii", "decode", "a", "--format", "json", "--format", "json"), "--format"),
    ],
)
def test_what_takes_one_value_is_given_once(data_db, tmp_path, monkeypatch, words, option):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ESICATALOG_DB", str(data_db))
    assert f": {option} is given more than once" in one_line_error(run(*words))
    assert not any(tmp_path.iterdir())


def test_what_takes_several_values_and_flags_may_be_given_again(data_db):
    twice = run("devices", "--maps", "0x60FF", "--maps", "0x6040", "--strict", "--strict", "--mode", "CSV", db=data_db)
    assert twice.exit_code == 0


def test_an_output_that_is_closed_early_is_no_error_message(data_db):
    code, said = piped(f"{PROGRAM} show 0x1097:0x2406 --format json --db {data_db} | head -c 10 >/dev/null")
    assert (code in (0, 1), said) == (True, "")
    assert piped(f"{PROGRAM} show 0x1097:0x2406 --format json --db {data_db} >&-") == (0, "")


@pytest.mark.skipif(shutil.which("bash") is None or not Path("/dev/full").exists(), reason="no bash or no /dev/full")
@pytest.mark.parametrize(
    "words",
    [
        "check",
        "export igh 0x1097:0x2406 -o /dev/full",
        *(pytest.param(text, marks=pytest.mark.faults) for text in ("show 0x1097:0x2406", "devices --format json")),
    ],
)
def test_an_output_that_is_full_is_one_line(data_db, words):
    code, said = piped(f"PYTHONUNBUFFERED= {PROGRAM} {words} --db {data_db} >/dev/full")
    assert code == 2
    assert [line for line in said.splitlines() if "No space left on device" in line] == [said.splitlines()[-1]]
    assert "Traceback" not in said
    named = "/dev/full" if "-o" in words else "standard output"
    assert said.splitlines()[-1] == f"esicatalog: {named}: No space left on device"


@pytest.mark.parametrize(
    ("error", "line"),
    [
        (OSError(errno.EAGAIN, "Resource temporarily unavailable"), "Resource temporarily unavailable"),
        (OSError(errno.EIO, "Input/output error", "c.db"), "c.db: Input/output error"),
        (OSError("not a regular file"), "not a regular file"),
    ],
)
def test_what_the_system_refuses_is_only_said_of_what_it_names(data_db, monkeypatch, error, line):
    def refused(self):
        raise error

    monkeypatch.setattr(Catalog, "check", refused)
    assert one_line_error(run("check", db=data_db)) == f"esicatalog: {line}"


def test_an_empty_list_is_an_answer(data_db):
    result = run("devices", "--vendor", "nobody", "--format", "json", db=data_db)
    assert (result.exit_code, json.loads(result.stdout)) == (0, [])


def test_the_shape_of_devices(data_db):
    result = run("devices", "--sync", "sync1", "--format", "json", db=data_db)
    (found,) = json.loads(result.stdout)
    assert result.stderr == ""
    assert found.keys() >= {"vendor_id", "product_code", "revision_no", "variant", "vendor", "type", "name", "evidence"}
    assert (found["product_code"], found["product_code_hex"]) == (0x0D080808, "0x0d080808")
    assert any("0x0700" in text for text in found["evidence"])


def test_devices_as_csv(data_db):
    lines = run("devices", "--format", "csv", "--include-hidden", db=data_db).stdout.splitlines()
    assert len(lines) == 7
    assert "0x00001097,0x00002406,0x0000008f,1," in lines[4]


@pytest.mark.skipif(shutil.which("bash") is None, reason="no bash")
@pytest.mark.parametrize(
    "command", ["lint <(cat {})", "ingest <(cat {})", "diff --esi {} <(cat {})", "export igh --esi <(cat {})"]
)
def test_esi_from_a_pipe_is_refused_for_what_it_is(data, tmp_path, command):
    file = data / "l6n_drive.xml"
    code, says = piped(f"cd {tmp_path}; {PROGRAM} {command.replace('{}', str(file))}")
    assert code == 2
    assert re.fullmatch(r"esicatalog: /dev/fd/[0-9]+: is a pipe; ESI is read from files only\n", says)


@pytest.mark.parametrize(
    "words", [("lint", "-"), ("ingest", "-"), ("diff", "--esi", "-", "-"), ("export", "igh", "--esi", "-")]
)
def test_esi_is_not_read_from_standard_input(tmp_path, monkeypatch, words):
    monkeypatch.chdir(tmp_path)
    assert one_line_error(run(*words)) == "esicatalog: -: standard input is not read here; give ESI files"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("devices", "--limit", "-1"), "esicatalog: --limit '-1' is negative; give a number from 0 on"),
        (("export", "igh", "1:2", "--cycle-ns", "-1"), "esicatalog: --cycle-ns '-1' is negative"),
        (
            ("export", "igh", "1:2", "-o", ""),
            "esicatalog: -o: the name is empty; give a file, or - for standard output",
        ),
    ],
)
def test_what_is_wrong_with_a_value_is_said(words, says):
    assert one_line_error(run(*words)).startswith(says)


def test_jobs_are_a_number(data):
    result = run("ingest", data, "--jobs", "x")
    assert (result.exit_code, "'x' is not a valid integer (see" in result.stderr) == (2, True)


def test_a_dash_is_standard_output(data_db, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    words = ("export", "igh", "0x4321:0xe2")
    assert run(*words, "-o", "-", db=data_db).stdout == run(*words, db=data_db).stdout != ""
    assert not list(tmp_path.iterdir())


def test_one_device_is_counted_as_one(tmp_path):
    folder = write(tmp_path / "esi", {"a.xml": esi(device())})
    assert "; 1 device, 0 modules in " in run("ingest", folder, db=tmp_path / "c.db").stdout


def test_sizes_of_sync_managers_have_their_unit(data_db):
    assert "min bytes  default bytes  max bytes" in run("show", "0x4321:0xe2", db=data_db).stdout


def test_standard_input_is_read_once(data_db):
    result = run("identify", "--slaves", "-", "--pdos", "0=-", db=data_db, stdin="0x1097,0x2406\n")
    assert "standard input can be read once" in one_line_error(result)


def test_mappings_on_the_command_line(data_db):
    words = ("--maps", "0x6000:1", "--maps", "0x6010:1", "--bits", "1", "--format", "json")
    assert len(json.loads(run("devices", *words, db=data_db).stdout)) == 1
    assert len(json.loads(run("devices", *words, "--include-hidden", db=data_db).stdout)) == 2
    assert json.loads(run("devices", *words, "--not-maps", "0x7000:1", db=data_db).stdout) == []


def test_json_is_utf_8_whatever_the_locale(tmp_path):
    write(tmp_path, {"a.xml": esi(device(name="Gerät 设备"))})
    run("ingest", tmp_path / "a.xml", db=tmp_path / "c.db")
    environment = {**os.environ, "LC_ALL": "C", "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    command = [sys.executable, "-m", "esicatalog", "devices", "--format", "json", "--db", tmp_path / "c.db"]
    done = subprocess.run(command, capture_output=True, env=environment)
    assert json.loads(done.stdout.decode())[0]["name"] == "Gerät 设备"


def test_the_shape_of_ingest(tmp_path, data):
    result = run("ingest", data, "--jobs", "1", "--format", "json", db=tmp_path / "c.db")
    report = json.loads(result.stdout)
    assert result.exit_code == 0
    assert report.keys() == {"sources", "devices", "modules", "seconds", "documents"}
    assert report["sources"] == {"stored": 5, "unchanged": 0, "recovered": 0, "skipped": 1, "failed": 0}
    assert (report["devices"], report["modules"]) == (6, 7)
    assert {line["path"] for line in report["documents"]} == {path.name for path in data.iterdir()}
    assert all(line.keys() == {"path", "status", "message", "devices", "modules"} for line in report["documents"])


def test_a_failed_document_is_exit_1(tmp_path):
    folder = write(tmp_path / "in", {"good.xml": esi(device()), "bad.xml": ""})
    result = run("ingest", folder, "--jobs", "1", db=tmp_path / "c.db")
    assert result.exit_code == 1
    assert "bad.xml" in result.stdout
    assert json.loads(run("devices", "--format", "json", db=tmp_path / "c.db").stdout)[0]["type"] == "T1"


def test_a_folder_without_documents_is_told(tmp_path):
    """It may be mistyped; an empty list is an answer all the same: exit code 0."""
    folder = write(tmp_path / "in", {"readme.txt": "no ESI", "other.xml": "<other/>"})
    line = f"esicatalog: no ESI document was found in {folder}"
    for _ in range(2):
        ingested = run("ingest", folder, "--jobs", "1", db=tmp_path / "c.db")
        assert (ingested.exit_code, ingested.stderr.splitlines()) == (0, [line])
    linted = run("lint", folder)
    assert (linted.exit_code, linted.stderr.splitlines()[1:]) == (0, [line])
    write(folder, {"a.xml": esi(device())})
    assert run("ingest", folder, "--jobs", "1", db=tmp_path / "c.db").stderr == ""
    assert line not in run("lint", folder).stderr


@pytest.mark.parametrize(
    ("words", "asked", "more"),
    [
        (("ingest", "in", "--jobs", "1"), "ingest", "; nothing stored before is lost, run it again to go on"),
        (("check",), "check", ""),
    ],
)
def test_what_an_interrupt_leaves_is_said_of_what_stores_something(data_db, tmp_path, monkeypatch, words, asked, more):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(Catalog, asked, interrupted)
    result = run(*words, db=shutil.copy(data_db, tmp_path / "c.db"))
    assert (result.exit_code, result.stderr.strip()) == (130, f"esicatalog: interrupted{more}")


def test_check_ends_with_the_content_hash(data_db, tmp_path):
    result = run("check", db=data_db)
    last = result.stdout.splitlines()[-1]
    assert result.exit_code == 0
    assert len(last) == 64
    assert set(last) <= set("0123456789abcdef")
    assert rows(data_db, "SELECT value FROM catalog_state WHERE key = 'content_hash'") == [(last,)]


def test_check_says_what_is_wrong(data_db, tmp_path):
    damaged = shutil.copy(data_db, tmp_path / "c.db")
    with closing(sqlite3.connect(damaged)) as connection:
        connection.execute("DELETE FROM device_sources WHERE device_id = 1")
        connection.execute("UPDATE devices SET variant = 7 WHERE id = 2")
        connection.execute("DELETE FROM device_search WHERE rowid = 3")
        connection.commit()
    result = run("check", db=damaged)
    assert result.exit_code == 1
    lines = result.stderr.splitlines()
    assert all(line.startswith("problem: ") for line in lines)
    for words in ("no document carries", "variants", "full-text search", "content hash"):
        assert [line for line in lines if words in line] != []


def test_show_prints_a_sheet(data_db):
    text = run("show", "0x1097:0x2406:0x8f", db=data_db).stdout
    assert "EYOU_ServoModule_V143" in text
    assert "0x00001097" in text
    sheet = json.loads(run("show", "0x1097:0x2406", "--format", "json", db=data_db).stdout)
    assert sheet["identity"]["revision_no"] == 143


def test_json_of_a_device_has_all_that_is_derived(data_db):
    """What the tables have as columns, be it the default: only who knows the defaults could tell what was left out."""
    sheet = json.loads(run("show", "0x1097:0x2406", "--format", "json", db=data_db).stdout)
    for part, table in (("facts", "device_facts"), ("drive_modes", "drive_modes"), ("mode_evidence", "mode_evidence")):
        columns = {name for _, name, *_ in rows(data_db, f"PRAGMA table_info({table})")}
        for found in [sheet[part]] if part == "facts" else sheet[part]:
            assert found.keys() == columns - {"id", "device_id", "position", "spelling"}


def test_an_argument_that_cannot_be_read_is_told_with_its_option(data_db):
    for words, says in (
        (("devices", "--bytes-in", "abc"), "--bytes-in 'abc' is not a number"),
        (("devices", "--bytes-out", ""), "--bytes-out is empty"),
        (("devices", "--product", "abc"), "--product 'abc' is not a number"),
        (("devices", "--maps", "x"), "--maps: index 'x' is not a number"),
        (("show", "1:1", "--module", "1"), "--module: module '1' is not SLOT=IDENT"),
        (("show", "1:x"), "product 'x' is not a number"),
    ):
        assert one_line_error(run(*words, db=data_db)).startswith(f"esicatalog: {says}"), words


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("ingest", "", "--db", "c.db"), "the name is empty; give a file, a folder or an archive"),
        (("lint", ""), "the name is empty; give a file, a folder or an archive"),
        (("lint", ".", "--schema", ""), "--schema: the name is empty"),
        (("identify", "--slaves", ""), "--slaves: the name is empty"),
        (("identify", "--slaves", "-", "--pdos", "0="), "the name is empty"),
        (("sii", "decode", ""), "the name is empty"),
        (("diff", "--esi", "", ""), "--esi: the name is empty"),
        (("export", "igh", "--esi", ""), "--esi: the name is empty"),
        (("export", "igh", "--scan", ""), "--scan: the name is empty"),
        (("export", "sii", "1:1", "--merge", ""), "--merge: the name is empty"),
        (("snapshot", "--from", "c.db", "--to", ""), "--to: the name is empty"),
    ],
)
def test_an_empty_name_is_not_the_folder_that_we_are_in(words, says, tmp_path, monkeypatch):
    """As of a variable that is not set: all documents of the folder would be ingested."""
    write(tmp_path, {"a.xml": esi(device())})
    monkeypatch.chdir(tmp_path)
    assert one_line_error(run(*words)).startswith(f"esicatalog: {says}")
    assert [path.name for path in tmp_path.iterdir()] == ["a.xml"]


def test_an_empty_host_is_not_every_address(data_db):
    assert "the host is empty" in one_line_error(run("serve", "--host", "", db=data_db))


def test_one_device_is_no_devices(data_db):
    assert run("devices", "--text", "L6N", "--limit", 1, db=data_db).stderr == "1 device\n"


@pytest.mark.parametrize("words", [("show",), ("diff",), ("export", "igh"), ("devices", "--like")])
def test_a_name_in_place_of_an_identity_is_answered_with_how_to_find_it(data_db, words):
    line = one_line_error(run(*words, "EL2008 x", db=data_db))
    assert line.endswith("; to find one: esicatalog devices --text 'EL2008 x'")


def test_show_of_an_unknown_device_is_exit_1(data_db):
    result = run("show", "0x1097:0x2407", db=data_db)
    assert result.exit_code == 1
    assert len(result.stderr.splitlines()) == 1
    assert run("show", "0x1097:0x2406@2", db=data_db).exit_code == 1


def foreign(path: Path) -> None:
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("CREATE TABLE cats (name TEXT)")


def sql(path: Path, statement: str) -> None:
    with closing(sqlite3.connect(path)) as connection:
        connection.execute(statement)
        connection.commit()


UNUSABLE = {
    "missing": (lambda path: path.unlink(), "ingest"),
    "foreign": (lambda path: (path.unlink(), foreign(path)), "other tables"),
    "two versions": (lambda path: sql(path, "INSERT INTO alembic_version VALUES ('0001')"), "ingest again"),
    "no version": (lambda path: sql(path, "DELETE FROM alembic_version"), "ingest again"),
    "no devices": (lambda path: sql(path, "ALTER TABLE devices RENAME TO machines"), "ingest again"),
    "empty": (lambda path: path.write_bytes(b""), "ingest"),
    "no database": (lambda path: path.write_bytes(b"not a database at all " * 100), "not an SQLite"),
    "older": (lambda path: sql(path, "UPDATE alembic_version SET version_num = '0000'"), "migrate"),
    "newer": (lambda path: sql(path, "UPDATE alembic_version SET version_num = '9999'"), "newer"),
    "cut off": (lambda path: path.write_bytes(path.read_bytes()[:20_000]), "damaged"),
    "folder": (lambda path: (path.unlink(), path.mkdir()), "cannot be opened"),
}


@pytest.mark.parametrize("kind", UNUSABLE)
@pytest.mark.parametrize("words", [("devices",), ("identify", *EYOU), ("show", "0x1097:0x2406"), ("check",)])
def test_an_unusable_catalog_is_one_line_that_says_what_to_do(tmp_path, data_db, kind, words):
    make, hint = UNUSABLE[kind]
    path = Path(shutil.copy(data_db, tmp_path / "c.db"))
    make(path)
    assert hint in one_line_error(run(*words, db=path))


@pytest.mark.parametrize("kind", ["foreign", "no database", "older", "newer", "folder"])
def test_ingest_leaves_alone_what_is_no_catalog_of_its_version(tmp_path, data, data_db, kind):
    path = Path(shutil.copy(data_db, tmp_path / "c.db"))
    UNUSABLE[kind][0](path)
    before = path.read_bytes() if path.is_file() else b""
    assert UNUSABLE[kind][1] in one_line_error(run("ingest", data, db=path))
    assert (path.read_bytes() if path.is_file() else b"") == before


@pytest.mark.parametrize("words", [("devices",), ("check",), ("migrate",), ("ingest", ".")])
@pytest.mark.parametrize(
    ("target", "says"),
    [
        ("", "name a file"),
        ("://", "not a database URL"),
        ("sqlite:///file:c.db?uri=true", "give the path of the catalog"),
        ("sqlite:///file:c.db", "give the path of the catalog"),
        ("sqlite:///c.db?mode=ro", "give the path of the catalog"),
        ("nonsense://c", "at nonsense://; write the path of an SQLite file or postgresql+psycopg://…"),
        (
            "postgresql+psycopg2://h/c",
            "at postgresql+psycopg2://; write the path of an SQLite file or postgresql+psycopg:",
        ),
        ("postgresql+psycopg_async://h/c", "at postgresql+psycopg_async://; write the path"),
        ("cockroachdb+psycopg2://h/c", "at cockroachdb+psycopg2://; write the path"),
        ("sqlite+aiosqlite:///c", "at sqlite+aiosqlite://; write the path"),
    ],
)
def test_a_name_that_is_no_catalog_is_refused(tmp_path, monkeypatch, target, says, words):
    monkeypatch.chdir(tmp_path)
    assert says in one_line_error(run(*words, "--db", target))
    assert list(tmp_path.iterdir()) == []


def test_ingest_into_a_folder_that_is_not_there(tmp_path, data):
    assert "no such folder" in one_line_error(run("ingest", data, db=tmp_path / "no" / "c.db"))


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written(tmp_path, data):
    (tmp_path / "db").mkdir()
    (tmp_path / "db").chmod(0o500)
    assert "cannot be" in one_line_error(run("ingest", data, db=tmp_path / "db" / "c.db"))


@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="no folder that nobody can write to")
def test_a_folder_that_nobody_can_write(data):
    assert "cannot be opened" in one_line_error(run("ingest", data, db=Path("/proc/c.db")))


@pytest.mark.parametrize(
    ("reason", "hint"),
    [
        ("database is locked", "another process"),
        ("attempt to write a readonly database", "cannot be written"),
        ("unable to open database file", "cannot be opened"),
        ("database or disk is full", "disk is full"),
        ("database disk image is malformed", "ingest again"),
        ("file is not a database", "not an SQLite catalog"),
        ("something\nunexpected", "unexpected"),
    ],
)
def test_database_errors_say_what_to_do(reason, hint):
    words = str(database_error("c.db", OperationalError("SELECT 1", {}, sqlite3.OperationalError(reason))))
    assert words.startswith("c.db: ")
    assert hint in words
    assert "\n" not in words


def test_migrate_has_nothing_to_do(data_db):
    assert "nothing to do" in run("migrate", db=data_db).stdout


def test_every_command_explains_itself():
    for name in COMMANDS:
        result = run(name, "--help")
        assert result.exit_code == 0
        assert "Usage:" in result.stdout


def test_the_catalog_comes_from_the_environment(data_db, monkeypatch):
    monkeypatch.setenv("ESICATALOG_DB", str(data_db))
    assert run("check").exit_code == 0


def test_a_profile_of_an_ingest_accounts_for_all_stages(tmp_path, data):
    done = run("ingest", data, "--profile", "--format", "json", db=tmp_path / "c.db")
    profile = json.loads(done.stdout)["profile"]
    assert list(profile) == ["read", "parse", "extract", "lint", "rows", "transfer", "write", "order", "index", "start"]
    assert all(seconds >= 0 for seconds in profile.values())
    assert profile["extract"] > 0 and profile["write"] > 0
    again = run("ingest", data, "--jobs", "1", "--profile", db=tmp_path / "c.db")
    assert [line.split()[0] for line in again.stderr.splitlines()[1:]] == list(profile)
    plain = run("ingest", data, "--jobs", "1", "--format", "json", db=tmp_path / "c.db")
    assert "profile" not in json.loads(plain.stdout)


@pytest.mark.parametrize("db", [None, "sqlite:///catalog.db", "link.db"])
def test_a_catalog_that_lies_among_its_documents_is_none_of_them(tmp_path, monkeypatch, db):
    write(tmp_path, {"a.xml": esi(device()), "catalog.db-wal.xml": esi(device(product="#x2"))})
    if db == "link.db":
        (tmp_path / db).symlink_to("catalog.db")
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("ESICATALOG_DB", raising=False)
    for _ in range(2):
        result = run("ingest", ".", "--jobs", "1", "--format", "json", *(("--db", db) if db else ()))
        assert result.exit_code == 0, result.output
        paths = [line["path"] for line in json.loads(result.stdout)["documents"]]
        assert paths == ["a.xml", "catalog.db-wal.xml"]
        write(tmp_path, {"catalog.db.inspect.json": "{}"})


def test_what_an_ingest_of_an_older_version_stored_of_the_catalog_itself_goes(tmp_path):
    write(tmp_path, {"a.xml": esi(device())})
    db = tmp_path / "catalog.db"
    run("ingest", tmp_path, db=db)
    with closing(sqlite3.connect(db)) as connection:
        columns = "location, member, status, reader_version, device_count, module_count"
        connection.execute(f"INSERT INTO sources ({columns}) VALUES (?, 'catalog.db', 'skipped', '0', 0, 0)", [str(db)])
        connection.commit()
    run("ingest", tmp_path, db=db)
    assert rows(db, "SELECT member FROM sources") == [("a.xml",)]
