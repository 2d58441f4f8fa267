"""The schema: every table and column explained, and migrations that lead to exactly what the metadata says."""

import ast
import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from alembic.script import ScriptDirectory
from conftest import CHECKOUT
from snippets import one, rows
from sqlalchemy.dialects import postgresql

from esicatalog import Catalog
from esicatalog.catalog import database, schema
from esicatalog.catalog.views import FULL_TEXT, views

SQL_KEYWORDS = {"index", "order", "group", "default", "table", "check", "references", "transaction", "values", "to"}


def migrated(path: Path) -> sa.Engine:
    return database.open_catalog(path, create=True)


def described(path: Path) -> dict[str, object]:
    """Tables as SQLite reports them: columns, references, indexes, STRICT."""
    found: dict[str, object] = {}
    with closing(sqlite3.connect(path)) as connection:

        def asked(sql: str) -> list[tuple[Any, ...]]:
            return connection.execute(sql).fetchall()

        for (name,) in asked("SELECT name FROM sqlite_master WHERE type = 'table' AND sql NOT LIKE '%VIRTUAL%'"):
            if not name.startswith((FULL_TEXT, "alembic", "sqlite_")):
                indexes = asked(f"PRAGMA index_list({name})")
                found[name] = (
                    sorted(row[1:] for row in asked(f"PRAGMA table_info({name})")),
                    sorted(row[2:] for row in asked(f"PRAGMA foreign_key_list({name})")),
                    sorted(
                        (row[2], tuple(part[2] for part in asked(f"PRAGMA index_info({row[1]})"))) for row in indexes
                    ),
                    asked(f"SELECT strict FROM pragma_table_list WHERE name = '{name}'"),
                )
    return found


def test_a_new_catalog_is_what_the_migrations_make(tmp_path):
    made, upgraded = tmp_path / "made.db", tmp_path / "upgraded.db"
    migrated(made).dispose()
    database.upgrade(database.make_engine(database.catalog_url(upgraded)))
    assert described(made) == described(upgraded)
    for query in (
        "SELECT type, name FROM sqlite_master ORDER BY 1, 2",
        "SELECT sql FROM sqlite_master WHERE type = 'view' ORDER BY name",
        "SELECT * FROM alembic_version",
    ):
        assert rows(made, query) == rows(upgraded, query)


def test_of_two_that_make_a_catalog_at_once_the_second_finds_it_made(tmp_path):
    engine = database.make_engine(database.catalog_url(tmp_path / "c.db"))
    migrated(tmp_path / "c.db").dispose()
    assert database._create(engine) == schema.SCHEMA_VERSION
    assert one(tmp_path / "c.db", "SELECT count(*) FROM alembic_version") == 1


@pytest.mark.parametrize("table", schema.metadata.sorted_tables, ids=str)
def test_every_table_and_column_has_a_comment(table):
    assert table.comment
    assert [column.name for column in table.columns if not column.comment] == []


@pytest.mark.parametrize("table", schema.metadata.sorted_tables, ids=str)
def test_no_column_is_an_sql_keyword(table):
    assert {column.name for column in table.columns} & SQL_KEYWORDS == set()


def test_every_view_is_explained():
    for dialect in ("sqlite", "postgresql"):
        assert all(view.doc.endswith(".") for view in views(dialect))
        assert len({view.name for view in views(dialect)}) == len(views(dialect))


def test_migrations_lead_to_the_metadata(tmp_path):
    engine = migrated(tmp_path / "c.db")
    options = {
        "compare_type": True,
        "compare_server_default": True,
        "include_object": lambda item, name, kind, *_: not (kind == "table" and str(name).startswith(FULL_TEXT)),
    }
    with engine.connect() as connection:
        context = MigrationContext.configure(connection, opts=options)
        assert compare_metadata(context, schema.metadata) == []


def test_migrations_make_the_same_tables_as_create_all(tmp_path):
    """Columns, types, keys and STRICT, as SQLite reports them; a column that came later stands last."""
    migrated(tmp_path / "migrated.db")
    created = sa.create_engine(f"sqlite:///{tmp_path / 'created.db'}")
    schema.metadata.create_all(created)

    assert described(tmp_path / "migrated.db") == described(tmp_path / "created.db")


def test_every_table_is_strict_and_checks_its_references(data_db):
    names = [table.name for table in schema.metadata.sorted_tables]
    for name in names:
        assert one(data_db, "SELECT strict FROM pragma_table_list WHERE name = ?", name) == 1
    with database.open_catalog(data_db).connect() as connection:
        assert connection.exec_driver_sql("PRAGMA foreign_keys").scalar() == 1


def test_the_schema_version_is_the_newest_migration():
    config = Config()
    config.set_main_option("script_location", str(CHECKOUT / "migrations"))
    script = ScriptDirectory.from_config(config)
    assert script.get_current_head() == schema.SCHEMA_VERSION
    files = sorted(path.name for path in (CHECKOUT / "migrations" / "versions").glob("[0-9]*.py"))
    assert [name[:4] for name in files] == [f"{number:04d}" for number in range(1, len(files) + 1)]
    assert len(list(script.walk_revisions())) == len(files)


def test_migrations_stand_alone():
    """A migration must mean the same when the package has changed."""
    for path in (CHECKOUT / "migrations" / "versions").glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import | ast.ImportFrom):
                assert "esicatalog" not in ast.unparse(node)


def test_the_schema_compiles_for_postgresql():
    for table in schema.metadata.sorted_tables:
        assert "CREATE TABLE" in str(sa.schema.CreateTable(table).compile(dialect=postgresql.dialect()))


@pytest.mark.parametrize("table", ["devices", "pdo_entries", "objects", "initcmds", "dc_modes", "vendors"])
def test_every_row_is_reached_by_its_identity(data_db, table):
    """The views named in the design carry vendor, product and revision as numbers and as text."""
    view = {"devices": "device_overview", "vendors": "device_overview"}.get(table, f"device_{table}")
    found = rows(
        data_db, f"SELECT vendor_id, vendor_id_hex, product_code, product_code_hex, revision_no_hex FROM {view}"
    )
    assert found
    for vendor, vendor_hex, product, product_hex, revision_hex in found:
        assert (vendor_hex, product_hex) == (f"0x{vendor:08x}", f"0x{product:08x}")
        assert len(revision_hex) == 10


def test_an_upgrade_fills_the_search_again(tmp_path, data_db):
    """Views and full text are made anew by every upgrade; the devices must be found as before."""
    copy = tmp_path / "copy.db"
    copy.write_bytes(data_db.read_bytes())
    database.upgrade(database.make_engine(database.catalog_url(copy)))
    with Catalog.open(copy) as catalog:
        assert [found.type for found in catalog.devices(text="L6N")] == ["L6N"]
        assert catalog.check().problems == []
