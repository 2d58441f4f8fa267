"""Hostile files given to commands that read one: exit code 1 or 2, one line, no traceback, whatever the file.

A second line is allowed: what lint sums up, and what was lost by recovery.
"""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from snippets import REPEATED_ATTRIBUTE, UNDECLARED_PREFIX, device, esi, faulty_vendor_texts, write

from esicatalog.cli.main import cli
from esicatalog.esi import documents
from esicatalog.esi.notes import MAX_FINDINGS
from esicatalog.ingest import this_process

LAUGHS = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 12))
FILES = {
    "empty": b"",
    "noise": bytes(range(256)) * 40,
    "zeros": bytes(100_000),
    "blanks": b" \n" * 10_000,
    "long-line": b"x" * 5_000_000,
    "many-lines": b"=== Master 0, Slave\n" * 100_000,
    "colons": b":" * 300_000,
    "hex": b":10" + b"0" * 100_000,
    "laughs": f"<!DOCTYPE EtherCATConfig [{LAUGHS}]><EtherCATConfig a='&a11;'/>".encode(),
    "deep": b"<EtherCATInfo>" * 100_000,
    "deep-configuration": b"<EtherCATConfig>" * 100_000,
    "unknown": esi(device("<X/>" * (MAX_FINDINGS + 1))).encode(),
    "cut": b"<EtherCATInfo><Vend",
    "utf-16": "<EtherCATConfig/>".encode("utf-16"),
    "bomb.zip": b"PK\x03\x04",
}
NOTHING_LINTED = "0 errors, 0 warnings, 0 infos; documents: 0"
COMMANDS = {
    "lint": ["lint", "FILE"],
    "export igh": ["export", "igh", "--esi", "FILE"],
    "export sii": ["export", "sii", "--esi", "FILE"],
    "export --scan": ["export", "igh", "--scan", "FILE", "--db", "DB"],
    "diff": ["diff", "--esi", "FILE", "GOOD"],
    "sii decode": ["sii", "decode", "FILE"],
    "sii verify": ["sii", "verify", "FILE", "--db", "DB"],
    "identify --slaves": ["identify", "--slaves", "FILE", "--db", "DB"],
    "identify --eni": ["identify", "--eni", "FILE", "--db", "DB"],
    "identify --sii": ["identify", "--sii", "FILE", "--db", "DB"],
}


def arguments(words: list[str], file: Path, data_db: Path, data: Path) -> list[str]:
    places = {"FILE": str(file), "DB": str(data_db), "GOOD": str(data / "l6n_drive.xml")}
    return [places.get(word, word) for word in words]


def lines_of_failure(command: list[str]) -> list[str]:
    """What a failing command says on stderr."""
    result = CliRunner().invoke(cli, command)
    assert isinstance(result.exception, SystemExit), result.exception
    assert result.exit_code in (1, 2)
    assert "Traceback" not in result.output
    return result.stderr.splitlines()


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("files")
    for name, content in FILES.items():
        (made / name).write_bytes(content)
    (made / "folder").mkdir()
    (made / "circle").symlink_to(made / "circle")
    return made


@pytest.mark.parametrize("name", [*FILES, "folder", "circle", "missing"])
@pytest.mark.parametrize("words", COMMANDS.values(), ids=COMMANDS)
def test_a_file_that_is_of_no_use(folder, data_db, data, words, name):
    command = arguments(words, folder / name, data_db, data)
    if command[0] == "lint" and name == "folder":
        pytest.skip("an empty folder is no fault")
    lines = lines_of_failure(command)
    assert len(lines) in (1, 2), lines
    assert max(map(len, lines)) < 500


@pytest.mark.parametrize("fault", [UNDECLARED_PREFIX, REPEATED_ATTRIBUTE])
@pytest.mark.parametrize(
    ("command", "exit_code"), [(["lint"], 1), (["export", "igh", "--esi"], 0), (["export", "esi", "--esi"], 0)]
)
def test_texts_of_vendors_are_read_as_leniently_as_their_documents(tmp_path, fault, command, exit_code):
    write(tmp_path, {"a.xml": esi(device(faulty_vendor_texts(fault)))})
    result = CliRunner().invoke(cli, [*command, str(tmp_path / "a.xml")])
    assert result.exit_code == exit_code
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception


ENDLESS = {
    **{name: (words, "/dev/zero") for name, words in COMMANDS.items()},
    **{f"{name} of a pipe": (COMMANDS[name], "PIPE") for name in ("lint", "export igh", "diff")},
}
"""Commands and what has no end: a device, and a pipe into which nobody writes."""
COMMANDS_IN_TURN = """
import json, sys
from click.testing import CliRunner
from esicatalog.cli.main import cli
results = {name: CliRunner().invoke(cli, words) for name, words in json.loads(sys.argv[1]).items()}
print(json.dumps({name: [result.exit_code, result.stderr] for name, result in results.items()}))
"""


@pytest.fixture(scope="module")
def of_endless(tmp_path_factory, data_db, data) -> dict[str, tuple[int, str]]:
    """Exit code and words of each, in a process that is ended if need be."""
    pipe = tmp_path_factory.mktemp("pipe") / "pipe.xml"
    os.mkfifo(pipe)
    commands = {
        name: arguments(words, pipe if file == "PIPE" else Path(file), data_db, data)
        for name, (words, file) in ENDLESS.items()
    }
    command = [sys.executable, "-c", COMMANDS_IN_TURN, json.dumps(commands)]
    return json.loads(subprocess.run(command, stdout=subprocess.PIPE, timeout=60, check=True).stdout)


@pytest.mark.parametrize("name", ENDLESS)
def test_what_has_no_end_is_not_read_endlessly(of_endless, name):
    code, said = of_endless[name]
    problem, *more = said.splitlines()
    assert (code in (1, 2), "Traceback" in problem) == (True, False)
    assert more == ([NOTHING_LINTED] if name.startswith("lint") else [])


def test_a_pipe_that_a_master_writes_into_is_read(tmp_path, data_db):
    os.mkfifo(tmp_path / "pipe")
    shell = f"echo '0x5,0x0d080808,0x1' > {tmp_path / 'pipe'} & exec {sys.executable} -m esicatalog identify "
    run = subprocess.run(
        ["sh", "-c", f"{shell} --slaves {tmp_path / 'pipe'} --db {data_db}"],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert "0x00000005:0x0d080808:0x00000001" in run.stdout


READING = [["lint", "FILE"], ["export", "igh", "--esi", "FILE"], ["diff", "--esi", "FILE", "GOOD"]]


@pytest.mark.parametrize("words", READING, ids=["lint", "export", "diff"])
def test_a_document_is_read_in_as_little_memory_as_in_an_ingest(data_db, data, monkeypatch, words):
    resource = pytest.importorskip("resource")
    limits = []

    def looked_at(root) -> bool:
        limits.append(resource.getrlimit(resource.RLIMIT_AS)[0])
        return False

    monkeypatch.setattr(documents, "_HAS_TOO_MANY_ATTRIBUTES", looked_at)
    before = resource.getrlimit(resource.RLIMIT_AS)
    CliRunner().invoke(cli, arguments(words, data / "l6n_drive.xml", data_db, data))
    assert set(limits) == {3 * 1024**3}
    assert resource.getrlimit(resource.RLIMIT_AS) == before


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no alarm")
@pytest.mark.parametrize("words", READING, ids=["lint", "export", "diff"])
def test_a_document_without_end_is_given_up(data_db, data, monkeypatch, words):
    def endless(root) -> bool:
        while True:
            pass

    alarm = signal.getsignal(signal.SIGALRM)
    monkeypatch.setattr(this_process, "DEADLINE_SECONDS", 0.2)
    monkeypatch.setattr(documents, "_HAS_TOO_MANY_ATTRIBUTES", endless)
    line, *_ = lines_of_failure(arguments(words, data / "l6n_drive.xml", data_db, data))
    assert line.endswith("gave up after 0 s")
    assert (signal.getsignal(signal.SIGALRM), signal.getitimer(signal.ITIMER_REAL)) == (alarm, (0, 0))


@pytest.mark.parametrize("words", READING, ids=["lint", "export", "diff"])
def test_more_elements_than_libxml2_puts_into_a_set(data_db, data, monkeypatch, words):
    """10,000,000, which take 50 MB at least: here the expression fails at any document."""
    monkeypatch.setattr(documents, "_HAS_TOO_MANY_ATTRIBUTES", documents.etree.XPath("unknown()"))
    line, *_ = lines_of_failure(arguments(words, data / "l6n_drive.xml", data_db, data))
    assert "too large or too deep" in line
