"""Fixtures that several test files use. ``corpus`` names real files that are not part of the project."""

import ast
import contextlib
import gc
import inspect
import os
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any, TypeVar

import pytest
import sqlalchemy as sa
from hypothesis import settings
from postgres_cluster import Cluster, NoServer, running_cluster

from esicatalog import Catalog

CHECKOUT = Path(__file__).parent.parent
Target = TypeVar("Target", str, Path)
SAMPLE_ARCHIVES = ("hpmicro+hpm_sdk.zip", "AIMEtherCAT+EcatV2_AX58100_H750_Universal.zip", "ruiofang+EU_EtherCAT.zip")
"""Small archives of the corpus: modules, a document that needs recovery, plain drives."""


_APPLICATIONS = {"web_client", "esicatalog.web.app"}
"""Where tests have an application of Datasette from."""

# Looking for cycles as often as Python does takes a tenth of the time of all tests.
gc.set_threshold(20_000, 20, 10)


class _CompiledForAll(dict[Any, Any]):
    """Statements that SQLAlchemy has compiled, by statement and kind of engine instead of the very engine."""

    def get(self, key: Any, default: Any = None) -> Any:
        return super().get(self._key(*key), default)

    def __setitem__(self, key: Any, compiled: Any) -> None:
        super().__setitem__(self._key(*key), compiled)

    def _key(self, dialect: sa.Dialect, *statement: Any) -> tuple[Any, ...]:
        """Servers differ in how a text is written."""
        return type(dialect), getattr(dialect, "_backslash_escapes", None), *statement


_COMPILED = _CompiledForAll()


@sa.event.listens_for(sa.Engine, "engine_connect")
def _compile_once_for_all_catalogs(connection: sa.Connection) -> None:
    """A program has one engine, tests have hundreds: compiling anew for each takes a third of an ingest."""
    connection.execution_options(compiled_cache=_COMPILED)


settings.register_profile("on any machine", deadline=None)
settings.load_profile("on any machine")


_LONGEST = ("kill", "postgres_writers", "faults", "browser", "upgrade", "ingest", "compare_complete", "export_compile")
"""Test files that take long for the number of their tests: they come first, lest one process is left with them."""


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Function]) -> None:
    """Mark what answers through Datasette: ``make test-datasette-1`` runs that on the coming line of it."""
    items.sort(key=lambda item: item.path.stem.removeprefix("test_") not in _LONGEST)
    if "datasette" in config.option.markexpr:  # Looking for it takes a second.
        for item in items:
            if item.originalname in _using_datasette(item.module):
                item.add_marker("datasette")


@cache
def _using_datasette(module: ModuleType) -> set[str]:
    """What of a test file leads to an application or a server: fixtures are named as arguments, commands in texts."""
    uses = {
        function.name: {
            str(getattr(item, field, None)) for item in ast.walk(function) for field in ("id", "arg", "value", "module")
        }
        for function in ast.parse(inspect.getsource(module)).body
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef)
    }
    using = {"served", "serving", "serve", "datasette", "datasette.app"}
    for name, value in vars(module).items():
        home = getattr(value, "__module__", None) or ""
        if home in _APPLICATIONS or home.startswith("datasette"):
            using.add(name)
        elif home != module.__name__ and "tests" in Path(getattr(sys.modules.get(home), "__file__", None) or "").parts:
            using |= {name} & _using_datasette(sys.modules[home])
    while found := {name for name, used in uses.items() if used & using} - using:
        using |= found
    return using


@pytest.fixture(scope="session")
def data() -> Path:
    """Our own example files."""
    return CHECKOUT / "data"


@pytest.fixture(scope="session")
def corpus() -> Path:
    """Folder with real files: ESICATALOG_CORPUS, else beside the checkout."""
    folder = Path(os.environ.get("ESICATALOG_CORPUS") or CHECKOUT.parent / "shared" / "corpus")
    if not (folder / "esi").is_dir():
        pytest.skip(f"no corpus of real ESI files at {folder}; name one with ESICATALOG_CORPUS")
    return folder


@pytest.fixture(scope="session")
def sample_archives(corpus: Path) -> list[Path]:
    """A few small archives of the corpus."""
    return [corpus / "esi" / name for name in SAMPLE_ARCHIVES]


def _ingested(target: Target, inputs: list[Path], jobs: int | None) -> Target:
    with Catalog.open(target, create=True) as catalog:
        catalog.ingest(inputs, jobs=jobs)
    return target


@pytest.fixture(scope="session")
def data_db(tmp_path_factory: pytest.TempPathFactory, data: Path) -> Path:
    """A catalog of our example files; read it, do not change it."""
    return _ingested(tmp_path_factory.mktemp("data") / "data.db", [data], jobs=1)


@pytest.fixture(scope="session")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A made-up library of 210 devices, as the benchmarks use it."""
    folder = tmp_path_factory.mktemp("library") / "library"
    command = [sys.executable, str(CHECKOUT / "benchmarks" / "library.py"), str(folder), "--devices", "210"]
    subprocess.run([*command, "--vendors", "3"], check=True, stdout=subprocess.DEVNULL)
    return folder


@pytest.fixture(scope="session")
def library_db(tmp_path_factory: pytest.TempPathFactory, library: Path) -> Path:
    """A catalog of the made-up library; read it, do not change it."""
    return _ingested(tmp_path_factory.mktemp("library") / "library.db", [library], jobs=1)


@contextlib.contextmanager
def serving(db: Path) -> Iterator[str]:
    """Address of ``esicatalog serve``, started as people start it."""
    command = [sys.executable, "-m", "esicatalog", "serve", "--db", str(db), "--port", "0"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    try:
        yield process.stdout.readline().strip().removesuffix("/catalog")
    finally:
        process.terminate()
        process.wait()


@pytest.fixture(scope="session")
def served(data_db: Path) -> Iterator[str]:
    """Address of a server of our example files."""
    with serving(data_db) as address:
        yield address


@pytest.fixture(scope="session")
def sample_db(tmp_path_factory: pytest.TempPathFactory, sample_archives: list[Path]) -> Path:
    """A catalog of a few small archives of the corpus."""
    return _ingested(tmp_path_factory.mktemp("sample") / "sample.db", sample_archives, jobs=1)


@pytest.fixture(scope="session")
def corpus_db(tmp_path_factory: pytest.TempPathFactory, corpus: Path) -> Path:
    """A catalog of the whole corpus; takes some seconds."""
    return _ingested(tmp_path_factory.mktemp("corpus") / "corpus.db", [corpus / "esi"], jobs=None)


@pytest.fixture(scope="session")
def postgres_cluster() -> Iterator[Cluster]:
    """A PostgreSQL server of our own, gone afterwards."""
    pytest.importorskip("psycopg", reason="no psycopg here: pip install 'esicatalog[postgres]'")
    with contextlib.ExitStack() as stack:
        try:
            cluster = stack.enter_context(running_cluster())
        except NoServer as missing:
            pytest.skip(str(missing))
        yield cluster


@pytest.fixture
def postgres(postgres_cluster: Cluster) -> str:
    """The URL of an empty PostgreSQL database."""
    return postgres_cluster.new_database()


@pytest.fixture(scope="session")
def data_url(postgres_cluster: Cluster, data: Path) -> str:
    """A catalog of our example files in PostgreSQL; read it, do not change it."""
    return _ingested(postgres_cluster.new_database(), [data], jobs=1)
