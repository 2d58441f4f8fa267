"""Catalogs of every released schema version are brought up to date and then say what a new one says.

``catalogs/NNNN.sql`` is a catalog of two of our example files, dumped by the version that had that schema.
"""

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from alembic import command
from alembic.config import Config
from conftest import CHECKOUT
from snippets import rows
from test_schema import described

from esicatalog import Catalog
from esicatalog.catalog.database import catalog_url, make_engine
from esicatalog.catalog.schema import SCHEMA_VERSION
from esicatalog.errors import CatalogError

DUMPS = sorted((CHECKOUT / "tests" / "catalogs").glob("*.sql"))
SOME_DUMPS = [DUMPS[0], *(pytest.param(dump, marks=pytest.mark.faults) for dump in DUMPS[1:-1]), DUMPS[-1]]
"""The oldest and the newest; those between are for ``make faults``."""
EXAMPLES = ("io_terminal_8di_8do.xml", "two_axis_modular_drive.xml")
DERIVED = (
    "SELECT d.content_hash, d.hidden FROM devices d",
    "SELECT d.content_hash, f.output_bytes, f.input_bytes, f.axis_count, f.image_signature, f.pdo_signature "
    "FROM devices d JOIN device_facts f ON f.device_id = d.id",
    "SELECT d.content_hash, m.position, m.axis, m.mode, m.verdict, m.evidence, m.recipe "
    "FROM devices d JOIN drive_modes m ON m.device_id = d.id",
    "SELECT d.content_hash, m.position, m.rank, m.evidence FROM devices d JOIN mode_evidence m ON m.device_id = d.id",
    "SELECT d.content_hash, p.direction, p.position, p.image_sm, e.position, e.image_bit_offset "
    "FROM devices d JOIN pdos p ON p.device_id = d.id LEFT JOIN pdo_entries e ON e.pdo_id = p.id",
)


VERSIONS = sorted(path.name[:4] for path in (CHECKOUT / "migrations" / "versions").glob("[0-9]*.py"))


def loaded(dump: Path, path: Path) -> Path:
    with closing(sqlite3.connect(path)) as connection:
        connection.executescript(dump.read_text())
    return path


def test_every_migration_that_leads_on_has_a_catalog():
    dumped = {path.stem for path in DUMPS}
    assert {version for version in VERSIONS if version != SCHEMA_VERSION} <= dumped <= set(VERSIONS)


@pytest.mark.parametrize("dump", SOME_DUMPS, ids=lambda path: path.stem)
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


@pytest.mark.parametrize("dump", SOME_DUMPS, ids=lambda path: path.stem)
def test_an_old_catalog_becomes_what_a_new_one_is(tmp_path: Path, data: Path, dump: Path):
    if dump.stem == SCHEMA_VERSION:
        pytest.skip("the newest schema: nothing to upgrade")
    old, new = loaded(dump, tmp_path / "old.db"), tmp_path / "new.db"
    with pytest.raises(CatalogError, match=f"esicatalog migrate --db {old}"):
        Catalog.open(old)
    assert Catalog.migrate(old) == (dump.stem, SCHEMA_VERSION)
    with Catalog.open(new, create=True) as catalog:
        catalog.ingest([data / name for name in EXAMPLES], jobs=1)
    assert described(old) == described(new)
    for query in DERIVED:
        assert sorted(rows(old, query), key=repr) == sorted(rows(new, query), key=repr)
    with Catalog.open(old) as upgraded, Catalog.open(new) as made:
        assert upgraded.check().content_hash == made.check().content_hash
        assert [d.as_json() for d in upgraded.devices(modes=["CSV"])] == [
            d.as_json() for d in made.devices(modes=["CSV"])
        ]
        assert upgraded.devices(text="D808")
