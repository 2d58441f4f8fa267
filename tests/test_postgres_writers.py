"""Several ingests at once into one PostgreSQL catalog: whatever comes between what, the result is that of one."""

import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

import pytest
import sqlalchemy as sa
from library import ingested
from snippets import device, dictionary, esi, pdo, read, write

from esicatalog import Catalog, CatalogError
from esicatalog.catalog import database, schema
from esicatalog.catalog.identity import IdentityLookup
from esicatalog.catalog.load import finish_load
from esicatalog.catalog.rows import RowMaker
from esicatalog.catalog.unfinished import CUT_SHORT
from esicatalog.catalog.writer import SourceRow, Writer

GENEROUS_SECONDS = 300


def started(url: str, inputs: Sequence[Path], *options: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "esicatalog", "ingest", *map(str, inputs), "--db", url, "--jobs", "1", *options]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def assert_done(processes: Sequence[subprocess.Popen[str]]) -> None:
    for process in processes:
        _, errors = process.communicate(timeout=GENEROUS_SECONDS)
        assert process.returncode == 0, errors


def assert_holds(url: str, expected: str) -> None:
    with Catalog.open(url) as catalog:
        result = catalog.check()
        assert (result.problems, result.content_hash) == ([], expected)
        assert catalog.content_hash() == expected


@pytest.fixture(scope="module")
def quarters(tmp_path_factory) -> list[Path]:
    """Four folders of documents that share vendors, devices, modules, dictionaries and data types."""
    folder = tmp_path_factory.mktemp("quarters")
    types = "<DataType><Name>UDINT</Name><BitSize>32</BitSize></DataType>"
    for number in range(24):
        objects = "".join(
            f"<Object><Index>#x{0x2000 + n:X}</Index><Name>O{n}</Name><Type>UDINT</Type><BitSize>32</BitSize></Object>"
            for n in range(number % 5, number % 5 + 30)
        )
        devices = "".join(
            device(
                dictionary(types, objects) + pdo("RxPdo", "#x1600", *range(1, 20 + shared % 3)),
                product=f"#x{shared:X}",
                type_text=f"T{shared}",
                revision=f"#x{number % 4:X}",
            )
            for shared in range(number % 6, number % 6 + 4)
        )
        write(folder, {f"{number % 4}/{number}.xml": esi(devices, vendor=f"<Id>{number % 3}</Id><Name>V</Name>")})
    return [folder / str(number) for number in range(4)]


@pytest.fixture(scope="module")
def whole(tmp_path_factory, quarters) -> str:
    """Content hash of all four, read by one process into SQLite."""
    return ingested(tmp_path_factory.mktemp("whole") / "whole.db", *quarters)


def test_four_at_once_make_the_catalog_that_one_makes(postgres, quarters, whole):
    """None of them finds a catalog there: they also make it together."""
    assert_done([started(postgres, [quarter]) for quarter in quarters])
    assert_holds(postgres, whole)


def test_the_same_folder_twice_at_once_where_the_server_isolates_more(postgres, quarters, whole):
    engine = database.make_engine(database.catalog_url(postgres))
    with engine.begin() as connection:
        name = connection.engine.url.database
        connection.exec_driver_sql(f"ALTER DATABASE {name} SET default_transaction_isolation = 'serializable'")
    engine.dispose()
    assert_done([started(postgres, quarters), started(postgres, quarters)])
    assert_holds(postgres, whole)


def test_documents_go_while_others_come(postgres, quarters, tmp_path):
    """What goes is partly what comes: nothing that is still carried goes, nothing stays that nobody carries."""
    passing = tmp_path / "passing"
    for path in (*quarters[0].iterdir(), *quarters[1].iterdir()):
        write(passing, {f"copy of {path.name}": path.read_bytes()})
    with Catalog.open(postgres, create=True) as catalog:
        catalog.ingest([passing], jobs=1)
    for path in sorted(passing.iterdir())[1:]:
        path.unlink()
    inputs = [quarters[:1], quarters[1:3]]
    assert_done([*(started(postgres, paths) for paths in inputs), started(postgres, [passing], "--prune")])
    assert_holds(postgres, ingested(tmp_path / "expected.db", *quarters[:3], passing))


@pytest.mark.parametrize("moment", [0.6, pytest.param(0.0, marks=pytest.mark.faults)])
def test_a_killed_ingest_harms_nobody(postgres, quarters, whole, moment):
    Catalog.open(postgres, create=True).close()
    killed = started(postgres, quarters[:2])
    others = [started(postgres, [quarter]) for quarter in quarters[2:]]
    time.sleep(0.7)
    with suppress(subprocess.TimeoutExpired):
        killed.wait(moment)
    killed.kill()
    killed.communicate()
    assert_done(others)
    with Catalog.open(postgres) as catalog:
        assert catalog.check().problems in ([], [CUT_SHORT])
        catalog.ingest(quarters, jobs=1)
    assert_holds(postgres, whole)


def test_a_lost_connection_is_one_line_and_what_was_stored_stays(postgres, quarters, whole):
    engine = database.make_engine(database.catalog_url(postgres))

    def cut(line: object, done: int, total: int) -> None:
        if done == 10:
            with engine.connect() as other:
                others = "FROM pg_stat_activity WHERE datname = current_database() AND pid <> pg_backend_pid()"
                other.exec_driver_sql(f"SELECT pg_terminate_backend(pid) {others}")

    with Catalog.open(postgres, create=True) as catalog:
        catalog.ingest(quarters[:1], jobs=1)
        with pytest.raises(CatalogError, match="nothing of the last step was stored"):
            catalog.ingest(quarters, jobs=1, progress=cut)
    engine.dispose()
    with Catalog.open(postgres) as catalog:
        assert len(catalog.devices()) > 0
        catalog.ingest(quarters, jobs=1)
    assert_holds(postgres, whole)


class Machine:
    """One of several that write in turns. What it has handed over once it does not hand over again."""

    def __init__(self, engine: sa.Engine, name: str) -> None:
        self.connection = engine.connect()
        self._writer = Writer(self.connection, "test")
        self._rows = RowMaker()
        self._name = name

    def store(self, file: str, text: str) -> None:
        content = read(text)
        rows = self._rows.document(content, content.findings)
        self._writer.store(SourceRow(f"{self._name}/{file}", file, "stored", sha256=file), rows)
        self._writer.commit()

    def drop(self, file: str, of: str | None = None) -> None:
        self._writer.forget(f"{of or self._name}/{file}")
        self._writer.commit()


@pytest.fixture
def machines(postgres):
    engine = database.open_catalog(postgres, create=True)
    found = Machine(engine, "one"), Machine(engine, "two")
    yield found
    for machine in found:
        machine.connection.close()
    engine.dispose()


def held(machine: Machine, table: sa.Table) -> int:
    count = machine.connection.execute(sa.select(sa.func.count()).select_from(table)).scalar_one()
    machine.connection.rollback()
    return count


def test_content_that_another_stored_or_dropped_is_known(machines):
    one, two = machines
    text = esi(device(dictionary("<DataType><Name>BOOL</Name><BitSize>1</BitSize></DataType>", "")))
    one.store("a", text)
    two.store("b", text)
    assert held(one, schema.devices) == held(one, schema.dictionaries) == 1
    one.drop("a")
    assert held(one, schema.devices) == 1
    two.drop("b")
    assert held(one, schema.devices) == held(one, schema.vendors) == held(one, schema.data_types) == 0
    two.store("c", esi(device(product="#x77")))
    three = Machine(one.connection.engine, "three")
    three.store("a", text)
    one.store("a", text)
    two.store("b", text)
    three.connection.close()
    assert held(one, schema.devices) == 2
    assert held(one, schema.device_sources) == 4


def test_content_that_another_dropped_and_that_does_not_come_again_is_no_half_document(machines):
    one, two = machines
    one.store("a", esi(device()))
    two.drop("a", of="one")
    with pytest.raises(CatalogError, match=r"another ingest dropped .* repeat this one"):
        one.store("b", esi(device()))
    one.connection.rollback()
    assert held(two, schema.sources) == held(two, schema.devices) == 0


def test_a_stored_content_hash_is_that_of_what_is_stored(postgres, machines):
    one, two = machines
    with Catalog.open(postgres) as catalog:
        one.store("a", esi(device()))
        two.store("b", esi(device(product="#x2")))
        finish_load(one.connection, changed=True)
        assert catalog.content_hash() == catalog.check().content_hash
        two.store("c", esi(device(product="#x3")))
        assert catalog.content_hash() is None
        finish_load(two.connection, changed=True)
        assert catalog.content_hash() == catalog.check().content_hash


def test_an_answer_is_of_one_state(machines, postgres, monkeypatch):
    """The number of a row is soon another description's; its document would be named with what was found before."""
    one, two = machines
    with_sources = IdentityLookup.with_sources

    def replaced_before(lookup, found):
        two.drop("a", of="one")
        two.store("z", esi(device(product="#x99", name=name)))
        return with_sources(lookup, found)

    with Catalog.open(postgres) as catalog:
        for name, ask in {
            "identify": lambda: catalog.identify(0xE5C, 1, 1).device.sources[0].member,
            "export": lambda: catalog.export_subject("0xe5c:1:1").origin[0].split(",")[0],
        }.items():
            one.store("a", esi(device(name=name)))
            with monkeypatch.context() as patch:
                patch.setattr(IdentityLookup, "with_sources", replaced_before)
                assert ask() == "a"
            assert not catalog.identify(0xE5C, 1, 1).is_exact
            two.drop("z")


def test_a_reader_sees_one_state(machines, postgres):
    one, two = machines
    one.store("a", esi(device()))
    engine = database.open_catalog(postgres)
    with database.reading_connection(engine) as connection:
        count = sa.select(sa.func.count()).select_from(schema.devices)
        assert connection.execute(count).scalar_one() == 1
        two.store("b", esi(device(product="#x2")))
        assert connection.execute(count).scalar_one() == 1
    engine.dispose()
