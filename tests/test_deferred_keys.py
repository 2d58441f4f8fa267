"""Foreign keys of a server's catalog are gone during its first load, and there again after whatever comes next."""

from collections.abc import Iterator

import pytest
import sqlalchemy as sa
from snippets import device, esi, write

from esicatalog import Catalog, CatalogError
from esicatalog.catalog import database, schema
from esicatalog.catalog.check import KEYS_MISSING
from esicatalog.catalog.deferred_keys import drop_keys
from esicatalog.catalog.load import finish_load, prepare_load
from esicatalog.catalog.unfinished import CUT_SHORT


def keys(engine: sa.Engine) -> set[tuple[str, str]]:
    """Foreign keys as the server tells them: table, definition."""
    query = "SELECT conrelid::regclass::text, pg_get_constraintdef(oid) FROM pg_constraint WHERE contype = 'f'"
    with engine.connect() as connection:
        return {(table, definition) for table, definition in connection.exec_driver_sql(query)}


@pytest.fixture
def engine(postgres) -> Iterator[sa.Engine]:
    """An empty catalog."""
    made = database.open_catalog(postgres, create=True)
    yield made
    made.dispose()


@pytest.fixture
def folder(tmp_path):
    return write(tmp_path / "esi", {"a.xml": esi(device()), "b.xml": esi(device(product="#x2"))})


def test_a_first_load_goes_without_and_a_second_one_with_them(postgres, engine, folder):
    migrated = keys(engine)
    assert ("pdo_entries", "FOREIGN KEY (pdo_id) REFERENCES pdos(id)") in migrated
    seen = []
    with Catalog.open(postgres) as catalog:
        catalog.ingest([folder / "a.xml"], jobs=1, progress=lambda *_: seen.append(keys(engine)))
        catalog.ingest([folder], jobs=1, progress=lambda *_: seen.append(keys(engine)))
        assert catalog.check().problems == []
    assert seen[0] == set()
    assert seen[1:] == [migrated, migrated]
    assert keys(engine) == migrated


def test_who_comes_after_a_killed_load_puts_them_back(postgres, engine, folder):
    migrated = keys(engine)
    with engine.connect() as connection:
        prepare_load(connection)
    assert keys(engine) == set()
    with Catalog.open(postgres) as catalog:
        assert catalog.check().problems == [CUT_SHORT]
        catalog.ingest([folder], jobs=1)
        assert catalog.check().problems == []
    assert keys(engine) == migrated


def test_of_two_that_begin_at_once_the_first_to_end_puts_them_back(engine):
    migrated = keys(engine)
    with engine.connect() as one, engine.connect() as two:
        prepare_load(one)
        prepare_load(two)
        assert keys(engine) == set()
        finish_load(two, changed=False)
        assert keys(engine) == migrated
        finish_load(one, changed=False)
    assert keys(engine) == migrated


def test_broken_references_are_found_and_the_load_is_not_finished(postgres, engine, folder):
    with engine.connect() as connection:
        prepare_load(connection)
        connection.execute(sa.insert(schema.pdo_exclusions).values(pdo_id=4711, position=0))
        connection.commit()
    with Catalog.open(postgres) as catalog:
        for _ in range(2):
            with pytest.raises(CatalogError, match="rows of pdo_exclusions refer to rows of pdos that are missing"):
                catalog.ingest([folder], jobs=1)
        assert CUT_SHORT in catalog.check().problems
    assert keys(engine) == set()


def test_they_stay_where_somebody_is_reading(engine):
    migrated = keys(engine)
    with engine.connect() as reader, engine.connect() as connection:
        assert reader.execute(sa.select(schema.devices)).all() == []
        prepare_load(connection)
        assert keys(engine) == migrated
        reader.rollback()
        prepare_load(connection)
        assert keys(engine) == set()


def test_they_stay_where_others_have_stored_something(postgres, engine, folder):
    migrated = keys(engine)
    with Catalog.open(postgres) as catalog:
        catalog.ingest([folder], jobs=1)
    with engine.connect() as connection:
        drop_keys(connection)
    assert keys(engine) == migrated


def test_who_does_not_own_the_tables_loads_with_them_and_leaves_them_dropped_where_they_are(postgres, engine, folder):
    migrated = keys(engine)
    with engine.begin() as connection:
        connection.exec_driver_sql("CREATE ROLE loader LOGIN")
        connection.exec_driver_sql("GRANT SELECT, INSERT, UPDATE, DELETE ON ALL TABLES IN SCHEMA public TO loader")
        connection.exec_driver_sql("GRANT USAGE ON ALL SEQUENCES IN SCHEMA public TO loader")
    with Catalog.open(postgres.replace("//postgres@", "//loader@")) as loading, Catalog.open(postgres) as owning:
        seen = []
        assert loading.ingest([folder], jobs=1, progress=lambda *_: seen.append(keys(engine))).counts["stored"] == 2
        assert seen[0] == keys(engine) == migrated
        (folder / "a.xml").unlink()
        (folder / "b.xml").unlink()
        loading.ingest([folder], jobs=1, prune=True)
        with engine.connect() as connection:
            prepare_load(connection)
        write(folder, {"c.xml": esi(device())})
        assert loading.ingest([folder], jobs=1).counts["stored"] == 1
        assert (owning.check().problems, keys(engine)) == ([KEYS_MISSING], set())
        assert owning.snapshot(folder / "complete.db").content_hash == owning.content_hash()
        owning.ingest([folder], jobs=1)
        assert (owning.check().problems, keys(engine)) == ([], migrated)
