"""Snapshots: one read-only file with the same content, complete or not there at all, and served as it is."""

import json
import sqlite3
import stat
from contextlib import closing
from pathlib import Path

import pytest
from click.testing import CliRunner
from datasette.cli import cli as datasette_cli
from questions import answers
from snippets import device, esi, one, rows, write
from test_schema import described

from esicatalog import Catalog, CatalogError, InputError
from esicatalog.catalog.inspect_data import inspect_path
from esicatalog.catalog.schema import metadata
from esicatalog.cli.main import cli
from esicatalog.web.app import datasette_app


def words(*arguments: object):
    return CliRunner().invoke(cli, [str(argument) for argument in arguments], catch_exceptions=False)


@pytest.fixture(scope="module")
def snapshot(data_db, tmp_path_factory) -> Path:
    with Catalog.open(data_db, read_only=True) as catalog:
        return catalog.snapshot(tmp_path_factory.mktemp("snapshot") / "catalog-<hash>.db").path


def test_the_name_holds_the_content_hash(snapshot, data_db):
    assert snapshot.name == f"catalog-{Catalog.open(data_db).content_hash()}.db"
    assert sorted(path.name for path in snapshot.parent.iterdir()) == [snapshot.name, f"{snapshot.name}.inspect.json"]


def test_it_holds_what_the_catalog_holds(snapshot, data_db):
    assert described(snapshot) == described(data_db)
    for table in metadata.tables.keys() - {"catalog_state"}:
        assert rows(snapshot, f"SELECT * FROM {table}") == rows(data_db, f"SELECT * FROM {table}")
    assert answers(snapshot, (), ["808", "eyou", "0x1097"]) == answers(data_db, (), ["808", "eyou", "0x1097"])
    assert Catalog.open(snapshot).check() == Catalog.open(data_db).check()
    assert one(snapshot, "SELECT value FROM catalog_state WHERE key = 'content_hash'") in snapshot.name


def test_nobody_may_write_into_it(snapshot):
    for path in (snapshot, inspect_path(snapshot)):
        assert stat.S_IMODE(path.stat().st_mode) == 0o444
    assert one(snapshot, "PRAGMA journal_mode") == "delete"


def test_a_snapshot_of_postgresql_is_one_of_sqlite(data_url, data_db, tmp_path):
    result = words("snapshot", "--from", data_url, "--to", tmp_path / "c.db")
    assert (result.exit_code, result.stdout) == (0, f"{tmp_path / 'c.db'}\n")
    assert described(tmp_path / "c.db") == described(data_db)
    for table in metadata.tables.keys() - {"catalog_state"}:
        assert rows(tmp_path / "c.db", f"SELECT * FROM {table}") == rows(data_db, f"SELECT * FROM {table}")
    assert Catalog.open(tmp_path / "c.db").check() == Catalog.open(data_db).check()
    assert answers(tmp_path / "c.db", (), ["808", "eyou", "0x1097"]) == answers(data_db, (), ["808", "eyou", "0x1097"])


def test_the_counts_are_those_of_datasette_inspect(snapshot):
    said = json.loads(CliRunner().invoke(datasette_cli, ["inspect", str(snapshot)], catch_exceptions=False).stdout)
    written = json.loads(inspect_path(snapshot).read_text())
    assert written.keys() == said.keys() == {snapshot.stem}
    ours, theirs = written[snapshot.stem], said[snapshot.stem]
    assert (ours["hash"], ours["size"]) == (theirs["hash"], theirs["size"])
    counted = {name: table for name, table in theirs["tables"].items() if table["count"] is not None}
    assert ours["tables"].items() >= counted.items()
    assert ours["tables"]["devices"] == {"count": 6}


def test_the_same_content_again_is_no_error_and_other_content_is(tmp_path, snapshot, data_db):
    result = words("snapshot", "--from", data_db, "--to", snapshot.parent / "catalog-<hash>.db")
    assert (result.exit_code, result.stdout) == (0, f"{snapshot}\n")
    assert "there already" in result.stderr
    folder = write(tmp_path, {"a.xml": esi(device())})
    with Catalog.open(tmp_path / "other.db", create=True) as other:
        other.ingest([folder / "a.xml"], jobs=1)
    before = snapshot.read_bytes()
    result = words("snapshot", "--from", tmp_path / "other.db", "--to", snapshot)
    (line,) = result.stderr.splitlines()
    assert (result.exit_code, "holds another catalog" in line) == (2, True)
    assert snapshot.read_bytes() == before


def test_a_plain_catalog_is_never_taken_for_the_snapshot(tmp_path, snapshot):
    """It may change at any time, and a server does not find the counts beside it."""
    db, copy = tmp_path / "catalog.db", tmp_path / "copy.db"
    for file in (db, copy):
        file.write_bytes(snapshot.read_bytes())
    (tmp_path / "link.db").symlink_to(db)
    for name in ("catalog.db", "link.db"):
        result = words("snapshot", "--from", db, "--to", tmp_path / name)
        assert (result.exit_code, "is the catalog that is to be copied" in result.stderr) == (2, True)
    result = words("snapshot", "--from", db, "--to", copy)
    assert (result.exit_code, "is no snapshot: it can be written" in result.stderr) == (2, True)
    copy.chmod(0o444)
    result = words("snapshot", "--from", db, "--to", copy)
    assert (result.exit_code, "is no snapshot: no copy.db.inspect.json is beside it" in result.stderr) == (2, True)
    assert words("snapshot", "--from", snapshot, "--to", snapshot).exit_code == 2
    assert words("snapshot", "--from", db, "--to", snapshot).exit_code == 0


def test_a_slip_in_a_placeholder_makes_no_file(tmp_path, data_db):
    result = words("snapshot", "--from", data_db, "--to", tmp_path / "x<hahs>.db")
    (line,) = result.stderr.splitlines()
    assert (result.exit_code, "nothing stands for <hahs>; there are <hash> and <state>" in line) == (2, True)
    assert not list(tmp_path.iterdir())


def test_an_ingest_never_changes_a_snapshot(tmp_path, snapshot):
    """Also one of the superuser, who may write to any file; one of the two signs of a snapshot is enough."""
    folder = write(tmp_path / "esi", {"a.xml": esi(device())})
    plain, counted = tmp_path / "plain.db", tmp_path / "counted.db"
    for file in (plain, counted):
        file.write_bytes(snapshot.read_bytes())
    plain.chmod(0o444)
    inspect_path(counted).write_bytes(inspect_path(snapshot).read_bytes())
    for file, reason in ((snapshot, "is read-only"), (plain, "is read-only"), (counted, "counted.db.inspect.json")):
        before = file.read_bytes()
        result = words("ingest", folder, "--db", file)
        (line,) = result.stderr.splitlines()
        assert (result.exit_code, reason in line, "never change" in line) == (2, True, True)
        assert file.read_bytes() == before


def test_documents_without_devices_make_it_another_snapshot(tmp_path):
    """An ENI document is skipped and describes no device: the content hash stays what it was."""
    folder = write(tmp_path / "esi", {"a.xml": esi(device())})
    db, plain = tmp_path / "c.db", tmp_path / "plain.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([folder], jobs=1)
        before = catalog.snapshot(tmp_path / "<hash>-<state>.db")
        catalog.snapshot(plain)
        hashes = catalog.content_hash(), catalog.state_hash()
        write(folder, {"b.xml": "<EtherCATConfig/>"})
        catalog.ingest([folder], jobs=1)
        assert catalog.content_hash() == hashes[0] == before.content_hash
        assert catalog.state_hash() != hashes[1]
        with pytest.raises(CatalogError, match="holds the same descriptions, but other documents"):
            catalog.snapshot(plain)
        after = catalog.snapshot(tmp_path / "<hash>-<state>.db")
        assert (after.was_there, after.path == before.path) == (False, False)
        assert one(after.path, "SELECT count(*) FROM sources") == 2
        assert catalog.snapshot(tmp_path / "<hash>-<state>.db") == after._replace(was_there=True)
    names = [name.stem.split("-") for name in (before.path, after.path)]
    assert [(content, len(state)) for content, state in names] == [(hashes[0], 16)] * 2


def test_what_another_version_read_makes_it_another_snapshot(tmp_path, data_db, snapshot):
    """A version derives other facts of the same descriptions."""
    with closing(sqlite3.connect(data_db)) as source, closing(sqlite3.connect(tmp_path / "c.db")) as copy:
        source.backup(copy)
        copy.execute("UPDATE sources SET reader_version = '0.0.1'")
        copy.commit()
    result = words("snapshot", "--from", tmp_path / "c.db", "--to", snapshot)
    assert (result.exit_code, "what another version read" in result.stderr) == (2, True)


def test_an_unfinished_catalog_gives_none(tmp_path, data_db):
    with closing(sqlite3.connect(data_db)) as source, closing(sqlite3.connect(tmp_path / "c.db")) as copy:
        source.backup(copy)
    for change, message in (
        ("UPDATE catalog_state SET value = 'abc' WHERE key = 'content_hash'", "the catalog says abc"),
        ("DELETE FROM catalog_state WHERE key = 'content_hash'", "an ingest is under way or was cut short"),
    ):
        with closing(sqlite3.connect(tmp_path / "c.db")) as copy:
            copy.execute(change)
            copy.commit()
        with Catalog.open(tmp_path / "c.db") as catalog, pytest.raises(CatalogError, match=message):
            catalog.snapshot(tmp_path / "to.db")
    assert [path.name for path in tmp_path.iterdir()] == ["c.db"]


def test_a_place_that_cannot_be_written_is_named(data_db, tmp_path):
    with Catalog.open(data_db) as catalog:
        for place in (tmp_path / "no" / "c.db", "postgresql://host/c"):
            with pytest.raises(InputError):
                catalog.snapshot(place)


async def test_counts_of_another_file_are_not_believed(snapshot, tmp_path):
    copy = tmp_path / "c.db"
    copy.write_bytes(snapshot.read_bytes())
    datasette_app(copy, immutable=True)
    for text, message in (
        (inspect_path(snapshot).read_text().replace('"hash": "', '"hash": "0'), "does not describe c.db as it is"),
        ("[]", "delete it"),
        ("{", "delete it"),
    ):
        inspect_path(copy).write_text(text)
        with pytest.raises(CatalogError, match=message):
            datasette_app(copy, immutable=True)
        datasette_app(copy)
    inspect_path(copy).write_text(inspect_path(snapshot).read_text())
    application = datasette_app(copy, immutable=True)
    assert application.get_database("catalog").cached_table_counts["devices"] == 6


async def test_a_snapshot_is_served_behind_a_link(snapshot, tmp_path):
    (tmp_path / "current.db").symlink_to(snapshot)
    application = datasette_app(tmp_path / "current.db", immutable=True)
    await application.invoke_startup()
    found = (await application.client.get("/-/databases.json")).json()
    listed = found["databases"] if isinstance(found, dict) else found
    (shown,) = [database for database in listed if database["name"] == "catalog"]
    assert (shown["is_mutable"], shown["hash"], shown["path"]) == (
        False,
        json.loads(inspect_path(snapshot).read_text())[snapshot.stem]["hash"],
        str(snapshot),
    )
