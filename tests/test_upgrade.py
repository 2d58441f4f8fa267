"""Catalogs of every released schema version are brought up to date and then say what a new one says.

``catalogs/NNNN.sql`` is a catalog of two of our example files, dumped by the version that had that schema
(``make dump``).
"""

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from alembic import command
from alembic.config import Config
from conftest import CHECKOUT
from snippets import rows
from test_schema import described

from esicatalog import Catalog
from esicatalog.catalog import load
from esicatalog.catalog.database import catalog_url, make_engine
from esicatalog.catalog.rederive import derive_again
from esicatalog.catalog.schema import SCHEMA_VERSION, metadata
from esicatalog.errors import CatalogError
from migrations.dump import EXAMPLES

DUMPS = sorted((CHECKOUT / "tests" / "catalogs").glob("*.sql"))
OLDER = [dump for dump in DUMPS if dump.stem != SCHEMA_VERSION]


def some(dumps: list[Path]) -> list[Any]:
    """The oldest and the newest; those between are for ``make faults``."""
    return [dumps[0], *(pytest.param(dump, marks=pytest.mark.faults) for dump in dumps[1:-1]), dumps[-1]]


SPOILED = (
    ("devices", "variant", "variant + 5"),
    ("devices", "hidden", "1 - hidden"),
    ("devices", "own_vendor_name", "'Nobody'"),
    ("device_facts", "output_bytes", "999"),
    ("drive_modes", "verdict", "'no'"),
    ("mode_evidence", "rank", "rank + 1"),
    ("pdos", "image_sm", "7"),
    ("pdo_entries", "image_bit_offset", "9999"),
)
"""All that is derived again: table, column, wrong value."""
OF_INGEST = ("catalog_state", "sources")
"""Tables that say which version has read what, and from where."""


VERSIONS = sorted(path.name[:4] for path in (CHECKOUT / "migrations" / "versions").glob("[0-9]*.py"))


def loaded(dump: Path, path: Path) -> Path:
    with closing(sqlite3.connect(path)) as connection:
        connection.executescript(dump.read_text())
    return path


def test_every_migration_that_leads_on_has_a_catalog():
    dumped = {path.stem for path in DUMPS}
    assert {version for version in VERSIONS if version != SCHEMA_VERSION} <= dumped <= set(VERSIONS)


@pytest.mark.parametrize("dump", some(DUMPS), ids=lambda path: path.stem)
def test_a_released_migration_still_makes_what_it_made(tmp_path: Path, dump: Path):
    """The dump holds the tables as they were when the version was released."""
    made = tmp_path / "made.db"
    config = Config()
    config.set_main_option("script_location", str(CHECKOUT / "migrations"))
    with make_engine(catalog_url(made)).begin() as connection:
        config.attributes["connection"] = connection
        command.upgrade(config, dump.stem)
    assert described(made) == described(loaded(dump, tmp_path / "old.db"))


@pytest.mark.parametrize("version", ["0001", "base", "-1"])
def test_a_catalog_is_never_downgraded(tmp_path: Path, data_db: Path, version: str):
    copy = Path(shutil.copy(data_db, tmp_path / "c.db"))
    config = Config()
    config.set_main_option("script_location", str(CHECKOUT / "migrations"))
    with make_engine(catalog_url(copy)).begin() as connection:
        config.attributes["connection"] = connection
        with pytest.raises(CatalogError, match="never downgraded: ingest the files again with the older version"):
            command.downgrade(config, version)
    with Catalog.open(copy) as catalog:
        assert catalog.check().problems == []


def test_a_newer_catalog_is_left_as_it_is(tmp_path: Path, data_db: Path, data: Path):
    copy = Path(shutil.copy(data_db, tmp_path / "c.db"))
    with closing(sqlite3.connect(copy)) as connection:
        connection.execute("UPDATE alembic_version SET version_num = '9999'")
        connection.commit()
    before = copy.read_bytes()
    with pytest.raises(CatalogError, match=r"newer esicatalog .*9999.*use that version or ingest into a new catalog"):
        Catalog.migrate(copy)
    with pytest.raises(CatalogError, match="newer esicatalog"), Catalog.open(copy, create=True) as catalog:
        catalog.ingest([data])
    assert copy.read_bytes() == before


def test_a_migration_waits_for_readers_as_an_ingest_does(tmp_path: Path, monkeypatch):
    """SQLite itself gives up after the five seconds of its busy timeout."""
    old = loaded(DUMPS[0], tmp_path / "old.db")
    with closing(sqlite3.connect(old)) as reader:
        half_read = reader.execute("SELECT * FROM objects")
        half_read.fetchone()
        waited = []

        def end_reading(seconds: float) -> None:
            waited.append(seconds)
            half_read.close()

        monkeypatch.setattr(load.time, "sleep", end_reading)
        assert Catalog.migrate(old) == (DUMPS[0].stem, SCHEMA_VERSION)
    assert (len(waited), rows(old, "PRAGMA journal_mode")) == (1, [("delete",)])


def test_views_of_others_stay_and_read_what_is_new(tmp_path: Path):
    old = loaded(DUMPS[0], tmp_path / "old.db")
    with closing(sqlite3.connect(old)) as connection:
        connection.executescript(
            """CREATE VIEW device_overview AS SELECT id AS device_id FROM devices;
            CREATE VIEW "my ""report" AS SELECT device_id, dc_modes FROM device_overview;
            CREATE VIEW tables_only AS SELECT p.id FROM pdos p JOIN devices d ON d.id = p.device_id;"""
        )
        before = connection.execute("SELECT count(*) FROM tables_only").fetchall()
    Catalog.migrate(old)
    with_modes = rows(old, "SELECT device_id, count(*) FROM dc_modes GROUP BY device_id ORDER BY device_id")
    assert rows(old, 'SELECT * FROM "my ""report" ORDER BY device_id') == with_modes != []
    assert rows(old, "SELECT count(*) FROM tables_only") == before
    with Catalog.open(old) as catalog:
        assert catalog.check().problems == []


def spoil(path: Path) -> Path:
    """Make all wrong that is derived, as far as the version of the catalog has it."""
    with closing(sqlite3.connect(path)) as connection:
        for table, column, value in SPOILED:
            if any(row[1] == column for row in connection.execute(f"PRAGMA table_info({table})")):
                connection.execute(f"UPDATE {table} SET {column} = {value}")
        connection.commit()
    return path


def contents(path: Path) -> dict[str, list[str]]:
    """The rows of the tables without their numbers, each with the description that it belongs to."""
    found = {}
    for table in metadata.sorted_tables:
        if table.name in OF_INGEST:
            continue
        numbers = {key.parent.name for key in table.foreign_keys if key.column.name == "id"} | {"id"}
        own = [f"x.{column.name}" for column in table.columns if column.name not in numbers]
        owner = "x.device_id" if "device_id" in table.c else "NULL"
        named = ", ".join(["d.content_hash", *own])
        sql = f"SELECT {named} FROM {table.name} x LEFT JOIN devices d ON d.id = {owner}"
        found[table.name] = sorted(map(repr, rows(path, sql)))
    return found


def test_all_that_is_derived_is_derived_again(tmp_path: Path):
    """Makers that share a vendor id, hidden revisions and variants are in no dump."""
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([CHECKOUT / "tests" / "derived", CHECKOUT / "data"], jobs=1)
    before = contents(db)
    spoil(db)
    assert {name for name, held in contents(db).items() if held != before[name]} == {item[0] for item in SPOILED}
    engine = make_engine(catalog_url(db))
    with engine.begin() as connection:
        derive_again(connection)
    engine.dispose()
    assert contents(db) == before
    with Catalog.open(db) as catalog:
        assert catalog.check().problems == []


@pytest.fixture(scope="module")
def new(tmp_path_factory: pytest.TempPathFactory, data: Path) -> Path:
    """What the dumps hold, ingested now."""
    path = tmp_path_factory.mktemp("new") / "new.db"
    with Catalog.open(path, create=True) as catalog:
        catalog.ingest([data / name for name in EXAMPLES], jobs=1)
    return path


@pytest.mark.parametrize("dump", some(OLDER), ids=lambda path: path.stem)
def test_an_old_catalog_becomes_what_a_new_one_is(tmp_path: Path, new: Path, dump: Path):
    old = spoil(loaded(dump, tmp_path / "old.db"))
    with pytest.raises(CatalogError, match=f"esicatalog migrate --db {old}"):
        Catalog.open(old)
    assert Catalog.migrate(old) == (dump.stem, SCHEMA_VERSION)
    assert described(old) == described(new)
    assert contents(old) == contents(new)
    with Catalog.open(old) as upgraded, Catalog.open(new) as made:
        assert upgraded.check() == made.check()
        assert made.check().problems == []
        assert [d.as_json() for d in upgraded.devices(modes=["CSV"])] == [
            d.as_json() for d in made.devices(modes=["CSV"])
        ]
        assert upgraded.devices(text="D808")
