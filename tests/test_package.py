"""The package as a whole: short modules, explained names, and nothing loaded that is not needed."""

import ast
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import CHECKOUT

import esicatalog

PACKAGE = Path(esicatalog.__file__).parent
MODULES = sorted(PACKAGE.rglob("*.py"))


def ids(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


@pytest.mark.parametrize("path", MODULES, ids=ids)
def test_a_module_can_be_read_in_a_sitting(path):
    assert len(path.read_text().splitlines()) < 450


@pytest.mark.parametrize("path", MODULES, ids=ids)
def test_public_names_are_explained(path):
    """Modules, classes and functions; methods of public classes unless they are special or override."""
    tree = ast.parse(path.read_text())
    missing = [] if ast.get_docstring(tree) or not tree.body else ["the module"]
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            missing += [] if ast.get_docstring(node) else [node.name]
    assert missing == []


def test_every_public_name_can_be_imported():
    for name in esicatalog.__all__:
        assert getattr(esicatalog, name).__doc__
    with pytest.raises(AttributeError):
        _ = esicatalog.no_such_name


def loaded_by(code: str) -> set[str]:
    """Top-level packages that a fresh interpreter has loaded after running some code."""
    script = f"import sys\n{code}\nprint(' '.join({{name.split('.')[0] for name in sys.modules}}))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    return set(done.stdout.splitlines()[-1].split())


def test_importing_the_package_is_cheap():
    assert loaded_by("import esicatalog") & {"sqlalchemy", "lxml", "alembic", "msgspec", "click", "datasette"} == set()


def test_the_worker_never_loads_sqlalchemy():
    used = loaded_by("import esicatalog.ingest.worker")
    assert {"lxml", "msgspec"} <= used
    assert used & {"sqlalchemy", "alembic", "click", "datasette"} == set()


def test_a_worker_that_has_read_a_document_has_not_loaded_sqlalchemy(data):
    task = f"Task(0, {str(data)!r}, False, (), 'io_terminal_8di_8do.xml')"
    code = (
        "from esicatalog.ingest.worker import DocumentWorker\nfrom esicatalog.ingest.tasks import Task\n"
        f"assert DocumentWorker().handle({task}).status == 'stored'"
    )
    assert "sqlalchemy" not in loaded_by(code)


def test_alembic_is_loaded_only_to_migrate(data_db):
    code = f"from esicatalog import Catalog\nCatalog.open({str(data_db)!r}).devices()"
    assert loaded_by(code) & {"alembic", "datasette", "click"} == set()


@pytest.mark.skipif(shutil.which("make") is None, reason="no make here")
@pytest.mark.parametrize(("code", "served"), [(0, True), (1, True), (2, False)])
def test_make_serve_shows_what_could_be_read(tmp_path, code, served):
    """Exit code 1 of an ingest: a document failed; 2: it cannot be used at all. The program here only tells of it."""
    programs = tmp_path / "bin"
    programs.mkdir()
    program = programs / "esicatalog"
    program.write_text(f'#!/bin/sh\nprintf "%s|" "$@"\necho\ntest $1 != ingest || exit {code}\n')
    program.chmod(0o755)
    (tmp_path / "installed").touch()
    variables = (f"VENV={tmp_path}", "ESI=ven dor/a", "DB=my own.db", "PORT=8123")
    command = ["make", "--silent", "--no-print-directory", "serve", *variables]
    done = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True)
    assert done.stdout.splitlines() == [
        "ingest|ven dor/a|--db|my own.db|",
        *(["serve|--db|my own.db|--port|8123|"] if served else []),
    ]
    assert (done.returncode == 0) == served
