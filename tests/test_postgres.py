"""PostgreSQL beside SQLite: the same tables, rows and views, and the same answers."""

import hashlib
import json
import random
import sqlite3
import string
import zipfile
from collections.abc import Iterator
from contextlib import closing, contextmanager
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from alembic import command
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from click.testing import CliRunner, Result
from conftest import CHECKOUT
from questions import FILTERS, answers
from snippets import device, dictionary, esi, write
from test_upgrade import OLDER

from esicatalog import Catalog, CatalogError
from esicatalog.catalog import database, schema
from esicatalog.catalog.device_filter import DeviceFilter
from esicatalog.catalog.driver_errors import driver_message
from esicatalog.catalog.views import FULL_TEXT, views
from esicatalog.cli.main import cli

TEXTS = (
    *("el", "EL", "8", "808", "d808", "ecx-d808", "ECX_D808", "ecx d808", "digital 8", "gital", "gi", "servo motor"),
    *("#x1097", "0x00001097", "0x109", "4247", "0x0d080808", "_", "808 _", "'", '"', "%", "a|b", "é", "İ", ""),
    *(
        "ubertrager",
        "Übertrager",
        "träger",
        "rager",
        "ÜBERTRÄGER",
        "strasse",
        "STRASSE",
        "straße",
        "モータ",
        "タ",
        "m²",
    ),
)


def words(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [str(argument) for argument in arguments], catch_exceptions=False)


def plain(value: Any) -> Any:
    """A value as SQLite has it: truth as 0 and 1, no exact decimals."""
    if isinstance(value, Decimal):
        return int(value) if value == value.to_integral_value() else float(value)
    return int(value) if isinstance(value, bool) else value


@contextmanager
def closing_engine(target: str) -> Iterator[sa.Engine]:
    engine = database.make_engine(database.catalog_url(target))
    yield engine
    engine.dispose()


def content(target: str | Path, name: str) -> list[str]:
    with database.make_engine(database.catalog_url(target)).connect() as connection:
        found = connection.exec_driver_sql(f"SELECT * FROM {name}")
        return sorted(repr([(column, plain(value)) for column, value in row.items()]) for row in found.mappings())


@pytest.fixture(scope="module")
def odd(tmp_path_factory) -> Path:
    """Documents with what databases treat differently: case, diacritics, codes that are missing, ties in order."""
    folder = tmp_path_factory.mktemp("odd")
    names = ("Übertrager 24V", "UBERTRAGER", "ubertrager", "Straße", "モータ", "m² ﬁlter", "a|b", "a b", "É", "100%_x")
    for number, name in enumerate(names):
        content = device(
            "<Odd/><Odd/>", name=name, type_text=name[:3], product=f"#x{number % 3:X}", revision=f"#x{number % 2:X}"
        )
        unnumbered = device(name=name, type_text=f"no code {number % 4}", product="")
        vendor = f"<Id>{'#x5' if number % 2 else '4294967295'}</Id><Name>{name.swapcase()}</Name>"
        write(folder, {f"{number % 5}/{number}.xml": esi(content + unnumbered, vendor=vendor)})
    write(folder, {"broken.xml": b"<EtherCATInfo><Vendor><Id>1</Id>", "note.xml": b"<note/>"})
    return folder


@pytest.fixture(scope="module")
def both(tmp_path_factory, postgres_cluster, data, odd) -> tuple[Path, str]:
    """The same documents on both engines, read in the same order."""
    targets = (tmp_path_factory.mktemp("both") / "c.db", postgres_cluster.new_database())
    for target in targets:
        with Catalog.open(target, create=True) as catalog:
            assert catalog.ingest([data, odd], jobs=1).counts["stored"] == 16
    return targets


def test_migrations_lead_to_the_metadata(postgres):
    engine = database.open_catalog(postgres, create=True)
    options = {
        "compare_type": True,
        "include_object": lambda item, name, kind, *_: not (kind == "table" and str(name).startswith(FULL_TEXT)),
    }
    with engine.connect() as connection:
        assert compare_metadata(MigrationContext.configure(connection, opts=options), schema.metadata) == []
    engine.dispose()


@pytest.mark.parametrize("table", [name for name in schema.metadata.tables if name != "catalog_state"])
def test_rows_are_the_same(both, table):
    here, there = (content(target, table) for target in both)
    assert here == there


@pytest.mark.parametrize("view", [view.name for view in views("sqlite")])
def test_views_are_the_same(both, view):
    here, there = (content(target, view) for target in both)
    assert here == there


def test_the_views_show_something(both):
    empty = {view.name for view in views("sqlite") if not content(both[1], view.name)}
    assert empty <= {"module_initcmds"}


def test_content_hashes_are_the_same_and_stored(both):
    here, there = (Catalog.open(target).check() for target in both)
    assert here == there
    assert here.problems == []
    assert Catalog.open(both[1]).content_hash() == here.content_hash


def test_every_filter_is_asked():
    asked = {name for wanted in FILTERS for name in wanted} | {"text", "like"}
    assert asked == set(DeviceFilter.__struct_fields__)


def test_devices_are_the_same_for_every_filter(both):
    with Catalog.open(both[0]) as catalog:
        like = [found.identity_text for found in catalog.devices(modes=["CSV"])]
    here, there = (answers(target, FILTERS, TEXTS, like) for target in both)
    assert here == there
    assert here["{'text': 'ubertrager'}"] == here["{'text': 'ÜBERTRÄGER'}"] != []
    assert here["{'text': ''}"] == here["{}"] != []
    assert here["{'text': '_'}"] == []
    assert here["{'text': '808 _'}"] == here["{'text': '808'}"] != []


def test_a_page_of_devices_is_the_same(both):
    here, there = (Catalog.open(target).list_devices(DeviceFilter(limit=10), 2) for target in both)
    assert here._replace(sql="") == there._replace(sql="")


def test_identities_sheets_exports_and_findings_are_the_same(both):
    identities = ("0x1097:0x2406:0x8f", "0xe5c:0x0d080808:0x00110000", "5:1:1", "0xffffffff:0:0", "4294967295:2")
    for identity in identities:
        numbers = identity.split(":")
        for command_words in (
            ("identify", *numbers, "--format", "json"),
            ("identify", *numbers[:2], "0xabc", "--format", "json"),
            ("identify", numbers[0], "0x77777777", "1", "--format", "json"),
            ("show", identity, "--format", "json"),
            ("show", identity),
            ("export", "igh", identity),
            ("export", "esi", identity),
            ("diff", identity, identities[0]),
        )[:: 1 if identity in identities[:2] else 3]:
            here, there = (words(*command_words, "--db", target) for target in both)
            assert (here.exit_code, here.stdout, here.stderr) == (there.exit_code, there.stdout, there.stderr)
    here, there = (words("lint", "--format", "json", "--db", target) for target in both)
    assert (here.exit_code, json.loads(here.stdout)) == (there.exit_code, json.loads(there.stdout))
    assert here.stdout.count("message") > 5


def test_what_is_unchanged_gone_or_new_is_told_apart(postgres, tmp_path):
    folder = write(tmp_path / "esi", {"a.xml": esi(device()), "b.xml": esi(device(product="#x2"))})
    with Catalog.open(postgres, create=True) as catalog:
        assert catalog.ingest([folder], jobs=1).counts["stored"] == 2
        assert catalog.ingest([folder], jobs=1).counts["unchanged"] == 2
        (folder / "a.xml").unlink()
        write(folder, {"b.xml": esi(device(product="#x3")), "c.xml": esi(device(product="#x4"))})
        assert catalog.ingest([folder], jobs=1, prune=True).counts["stored"] == 2
        assert [found.product_code for found in catalog.devices()] == [3, 4]
        assert catalog.check().problems == []


def test_whoever_makes_the_catalog_is_told_before_there_are_tables(postgres):
    told: list[list[str]] = []
    engine = database.make_engine(database.catalog_url(postgres))
    for _ in range(2):
        database.open_catalog(
            postgres, create=True, when_new=lambda: told.append(sa.inspect(engine).get_table_names())
        ).dispose()
    assert told == [[]]
    engine.dispose()


def test_nothing_is_made_for_a_path_that_is_missing(postgres, tmp_path):
    result = words("ingest", tmp_path / "missing", "--db", postgres)
    assert (result.exit_code, "missing" in result.stderr) == (2, True)
    engine = database.make_engine(database.catalog_url(postgres))
    assert sa.inspect(engine).get_table_names() == []
    engine.dispose()


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


@pytest.mark.parametrize(
    "dump",
    [OLDER[0], *(pytest.param(dump, marks=pytest.mark.faults) for dump in OLDER[1:])],
    ids=lambda path: path.stem,
)
def test_an_old_catalog_is_brought_up_to_date(postgres, tmp_path, dump):
    """A catalog of an older version, row by row in PostgreSQL, becomes what the same one becomes in SQLite."""
    old = tmp_path / "old.db"
    with closing(sqlite3.connect(old)) as connection:
        connection.executescript(dump.read_text())
    engine = database.make_engine(database.catalog_url(postgres))
    with engine.begin() as connection, closing(sqlite3.connect(old)) as file:
        config = Config()
        config.set_main_option("script_location", str(CHECKOUT / "migrations"))
        config.attributes["connection"] = connection
        command.upgrade(config, dump.stem)
        made = sa.MetaData()
        made.reflect(connection)
        for table in made.sorted_tables:
            names = [column.name for column in table.columns]
            held = file.execute(f"SELECT {', '.join(names)} FROM {table.name}").fetchall()
            if held and table.name != "alembic_version":
                boolean = [isinstance(column.type, sa.Boolean) for column in table.columns]
                values = [
                    {n: bool(v) if b and v is not None else v for n, v, b in zip(names, row, boolean, strict=True)}
                    for row in held
                ]
                connection.execute(sa.insert(table), values)
    result = words("devices", "--db", postgres)
    assert (result.exit_code, "esicatalog migrate" in result.stderr) == (2, True)
    with engine.begin() as connection:
        connection.exec_driver_sql("CREATE VIEW device_overview AS SELECT id AS device_id FROM devices")
        connection.exec_driver_sql("CREATE VIEW mine AS SELECT device_id FROM device_overview")
    refused = words("migrate", "--db", postgres)
    assert (refused.exit_code, "CASCADE" in refused.stderr) == (2, False)
    assert "view mine depends on view device_overview; drop that, and make it anew afterwards" in refused.stderr
    with engine.begin() as connection:
        connection.exec_driver_sql("DROP VIEW mine")
    migrated = words("migrate", "--db", postgres)
    assert migrated.stdout.endswith(f"schema {dump.stem} -> {schema.SCHEMA_VERSION}\n")
    assert "GRANT SELECT" in migrated.stderr
    Catalog.migrate(old)
    for query in DERIVED:
        found = []
        for target in (old, postgres):
            with database.open_catalog(target).connect() as connection:
                found.append(sorted(repr([*map(plain, row)]) for row in connection.exec_driver_sql(query)))
        assert found[0] == found[1] != []
    assert Catalog.open(old).check() == Catalog.open(postgres).check()
    assert answers(old, FILTERS, TEXTS) == answers(postgres, FILTERS, TEXTS)
    engine.dispose()


def test_a_read_only_catalog_takes_no_changes(postgres, data):
    Catalog.open(postgres, create=True).close()
    with Catalog.open(postgres, read_only=True) as catalog:
        with pytest.raises(CatalogError, match="read-only transaction; the database takes no changes"):
            catalog.ingest([data / "io_terminal_8di_8do.xml"], jobs=1)
        assert catalog.devices() == []


def test_a_server_whose_texts_have_backslashes_of_their_own(postgres_cluster, tmp_path):
    """With standard_conforming_strings off a backslash in a text begins an escape sequence."""
    one = "<Object><Index>#x2000</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    picture = "<ImageData16x14>424D005C5C30FF</ImageData16x14>"
    folder = write(tmp_path, {"a.xml": esi(device(picture + dictionary("", one), type_text=r"a_b\\c"))})
    stored: list[list[Any]] = []
    for setting in ("on", "off"):
        target = f"{postgres_cluster.new_database()}&options=-cstandard_conforming_strings%3D{setting}"
        with Catalog.open(target, create=True) as catalog:
            catalog.ingest([folder], jobs=1)
            assert [found.type for found in catalog.devices(text=r"a_b\\c")] == [r"a_b\\c"]
            assert catalog.devices(text="axb") == []
            assert catalog.check().problems == []
        with closing_engine(target) as engine, engine.connect() as connection:
            query = "SELECT sha256, data, content_hash FROM images, objects"
            stored.append([tuple(row) for row in connection.exec_driver_sql(query)])
    ((sha256, data, _),) = stored[0]
    assert (sha256, data) == (hashlib.sha256(data).hexdigest(), bytes.fromhex("424D005C5C30FF"))
    assert stored[1] == stored[0]


def test_who_only_reads_needs_no_right_to_write(postgres_cluster, tmp_path, data):
    url = postgres_cluster.new_database()
    with Catalog.open(url, create=True) as catalog:
        catalog.ingest([data], jobs=1)
    engine = database.make_engine(database.catalog_url(url))
    with engine.begin() as connection:
        connection.exec_driver_sql("CREATE ROLE reader LOGIN")
        connection.exec_driver_sql("GRANT SELECT ON ALL TABLES IN SCHEMA public TO reader")
    engine.dispose()
    reader = url.replace("//postgres@", "//reader@")
    identity = "0x1097:0x2406:0x8f"
    for asked in (
        ("devices",),
        ("devices", "--text", "eyou"),
        ("identify", *identity.split(":")),
        ("show", identity),
        ("export", "igh", identity),
        ("check",),
    ):
        assert words(*asked, "--db", reader).exit_code == 0
    assert words("snapshot", "--from", reader, "--to", tmp_path / "c.db").exit_code == 0
    refused = words("ingest", write(tmp_path, {"a.xml": esi(device())}) / "a.xml", "--db", reader, "--jobs", "1")
    (line,) = refused.stderr.splitlines()
    assert (refused.exit_code, "permission denied" in line) == (2, True)


def test_a_database_that_cannot_hold_every_text_is_refused(postgres_cluster):
    url = postgres_cluster.new_database("-E", "SQL_ASCII", "-T", "template0", "--locale=C")
    with pytest.raises(CatalogError, match="encoding SQL_ASCII; make one with: createdb -E UTF8"):
        Catalog.open(url, create=True)


def test_another_database_is_left_alone(postgres):
    engine = database.make_engine(database.catalog_url(postgres))
    with engine.begin() as connection:
        connection.exec_driver_sql("CREATE TABLE orders (id INT)")
    with pytest.raises(CatalogError, match="other tables"):
        Catalog.open(postgres, create=True)
    engine.dispose()


def test_views_of_others_stay(postgres):
    """Extensions bring some. What has a name of the catalog's in another schema is not the catalog's either."""
    site = f"{postgres}&options=-csearch_path%3Dsite,public"
    with closing_engine(postgres) as engine:
        with engine.begin() as connection:
            connection.exec_driver_sql('CREATE VIEW "their ""report" AS SELECT 1 AS n')
            connection.exec_driver_sql("CREATE VIEW device_overview AS SELECT 2 AS n")
            connection.exec_driver_sql("CREATE SCHEMA site")
        with pytest.raises(CatalogError, match=r'"device_overview" already exists; what has that name is no part'):
            Catalog.open(postgres, create=True)
        made = database.open_catalog(site, create=True)
        with made.begin() as connection:
            connection.exec_driver_sql('CREATE VIEW "our ""report" AS SELECT 3 AS n')
        database.upgrade(made)
        with made.connect() as connection:
            for view, value in (('"their ""report"', 1), ("public.device_overview", 2), ('"our ""report"', 3)):
                assert connection.exec_driver_sql(f"SELECT n FROM {view}").scalar_one() == value
        made.dispose()
    with Catalog.open(site) as catalog:
        assert catalog.check().problems == []


def test_a_path_or_type_that_no_index_takes_costs_its_document_alone(postgres, tmp_path):
    """An index of PostgreSQL takes 2,704 bytes, when compressing does not help."""

    def text(size: int) -> str:
        return "".join(noise.choices(string.ascii_letters + string.digits, k=size))

    noise = random.Random(1)
    folder = write(
        tmp_path / "esi", {"a.xml": esi(device(type_text=text(2_000))), "b.xml": esi(device(type_text=text(2_001)))}
    )
    with zipfile.ZipFile(folder / "c.zip", "w") as archive:
        for size in (2_000, 1_000):
            archive.writestr(text(size), esi(device(product="#x2")))
    with Catalog.open(postgres, create=True) as catalog:
        for stored, unchanged in ((2, 0), (0, 2)):
            counts = catalog.ingest([folder], jobs=1).counts
            assert (counts["stored"], counts["unchanged"], counts["failed"]) == (stored, unchanged, 2)
        assert [found.product_code for found in catalog.devices()] == [1, 2]
        assert catalog.check().problems == []


OTHER_FIRST = "&options=-csearch_path%3Dother,public"


def test_a_catalog_is_whole_where_its_tables_are(postgres, tmp_path):
    """Another schema stands before it on the search path, with a table and a view of the same names."""
    folder = write(tmp_path, {"a.xml": esi(device()), "b.xml": esi(device(product="#x2"))})
    user = postgres.replace("//postgres@", "//other@") + OTHER_FIRST
    query = "SELECT schemaname, count(*) FROM pg_tables WHERE tablename LIKE 'device%%' GROUP BY 1 ORDER BY 1"
    views_of = "SELECT DISTINCT schemaname FROM pg_views WHERE viewname = 'device_overview'"
    with Catalog.open(postgres, create=True) as catalog:
        catalog.ingest([folder / "a.xml"], jobs=1)
    with closing_engine(postgres) as engine, engine.begin() as connection:
        connection.exec_driver_sql("CREATE ROLE other LOGIN SUPERUSER")
        connection.exec_driver_sql("CREATE SCHEMA other")
        connection.exec_driver_sql("CREATE TABLE other.devices (id INT)")
        connection.exec_driver_sql("CREATE VIEW other.device_overview AS SELECT 2 AS n")
        tables = connection.exec_driver_sql(query).all()
    with Catalog.open(user, create=True) as catalog:
        counts = catalog.ingest([folder], jobs=1).counts
        assert (counts["stored"], counts["unchanged"]) == (1, 1)
        assert [found.product_code for found in catalog.devices(text="0x2")] == [2]
        assert catalog.check().problems == []
    with closing_engine(user) as engine:
        database.upgrade(engine)
        with engine.begin() as connection:
            assert connection.exec_driver_sql(query).all() == tables
            assert connection.exec_driver_sql("SELECT n FROM other.device_overview").scalar_one() == 2
            connection.exec_driver_sql("DROP VIEW other.device_overview")
            assert connection.exec_driver_sql(views_of).scalars().all() == ["public"]


def test_what_lies_behind_the_first_schema_does_not_count_for_a_new_catalog(postgres):
    with closing_engine(postgres) as engine, engine.begin() as connection:
        connection.exec_driver_sql("CREATE TABLE orders (id INT)")
        connection.exec_driver_sql("CREATE SCHEMA other")
    with Catalog.open(postgres + OTHER_FIRST, create=True) as catalog:
        assert catalog.devices() == []
    with closing_engine(postgres) as engine, engine.connect() as connection:
        assert sa.inspect(connection).get_table_names() == ["orders"]
        assert "devices" in sa.inspect(connection).get_table_names("other")
    with pytest.raises(CatalogError, match="other tables"):
        Catalog.open(postgres, create=True)


def test_names_of_users_and_databases_are_no_reasons(postgres):
    Catalog.open(postgres, create=True).close()
    with closing_engine(postgres) as engine, engine.begin() as connection:
        connection.exec_driver_sql("CREATE ROLE readonly LOGIN")
    cases = {
        postgres.replace("//postgres@", "//readonly@"): "the database user may not do that; ask for the right",
        postgres.replace("//postgres@", "//locked@"): "name a user that the server knows",
        postgres.replace("/catalog_", "/full_"): "make the database first",
    }
    for target, expected in cases.items():
        (line,) = words("devices", "--db", target).stderr.splitlines()
        assert line.startswith(f"esicatalog: {database.shown_target(target)}: ")
        assert expected in line


@pytest.mark.parametrize(
    "reason",
    [
        "consuming input failed: server closed the connection unexpectedly",
        "connection failed: FATAL:  the database system is shutting down",
        "connection failed: FATAL:  the database system is starting up",
    ],
)
def test_what_passes_by_itself_is_to_be_tried_again(reason):
    error = pytest.importorskip("psycopg").OperationalError(reason)
    assert driver_message("c", error).endswith("; try again later")


def test_check_looks_at_the_search(postgres, tmp_path):
    folder = write(tmp_path, {"a.xml": esi(device() + device(product="#x2"))})
    with Catalog.open(postgres, create=True) as catalog, closing_engine(postgres) as engine:
        catalog.ingest([folder], jobs=1)

        def problems(statement: str) -> list[str]:
            with engine.begin() as connection:
                connection.exec_driver_sql(statement)
            return catalog.check().problems

        unknown = (
            "devices that the full-text search does not know, or not as they are: delete the catalog and ingest again"
        )
        assert problems("UPDATE device_search SET words = '' WHERE device_id = 1") == [f"1 {unknown}"]
        assert problems("DELETE FROM device_search") == [f"2 {unknown}"]
        assert problems("DROP TABLE device_search") == [
            "the table device_search is missing, by which texts are searched"
        ]


def test_after_a_lost_connection_the_next_call_is_answered(postgres, data):
    others = "FROM pg_stat_activity WHERE datname = current_database() AND pid <> pg_backend_pid()"
    with Catalog.open(postgres, create=True) as catalog, closing_engine(postgres) as engine:
        catalog.ingest([data / "l6n_drive.xml"], jobs=1)
        assert catalog.identify(0x4321, 0xE2, 1).is_exact
        with engine.connect() as connection:
            connection.exec_driver_sql(f"SELECT pg_terminate_backend(pid) {others}")
        with pytest.raises(CatalogError, match=r"try again later$"):
            catalog.identify(0x4321, 0xE2, 1)
        assert catalog.identify(0x4321, 0xE2, 1).is_exact


def test_what_stands_in_the_way_is_one_line_without_the_password(postgres, data, tmp_path):
    host = f"host={tmp_path}"
    cases = {
        f"postgresql+psycopg://me:secret@/c?{host}": "no server answers there",
        "postgresql+psycopg://me:secret@127.0.0.1:1/c": "no server answers there",
        "postgresql+psycopg://me:secret@no-such-host.invalid/c": "no such host",
        postgres.replace("catalog_", "missing_"): "make the database first",
        postgres: "not a catalog; make one with: esicatalog ingest",
        "mysql://me:secret@host/c": "postgresql+psycopg://",
        "postgresql://me:secret@host:port/c": "not a database URL",
        f"postgresql://me@/c?{host}&password=secret": "no server answers there",
        f"postgresql://me@/c?sslpassword=secret&passfile=/secret&{host}": "no server answers there",
        "mysql://host/c?password=secret": "postgresql+psycopg://",
        "sqlite:///c.db?password=secret": "take no options",
        "postgresql://me:pass@secret@127.0.0.1:1/c": "write one in a password as %40",
        "postgresql://me:pass@secret/word@127.0.0.1/c": "write one in a password as %40",
        f"postgresql://me@/c?{host}&oauth_client_secret=secret": "no server answers there",
        "postgresql:me:secret@h/c": "neither a file nor a URL; write postgresql+psycopg://",
        "postgres//me:secret@h/c": "neither a file nor a URL",
        "host=db dbname=c password=secret": "neither a file nor a URL",
        "user=me password = secret": "neither a file nor a URL",
        f"postgresql+psycopg2://me:secret@/c?{host}": "write the path of an SQLite file or postgresql+psycopg://",
        f"postgresql+asyncpg://me:secret@/c?{host}": "write the path of an SQLite file or postgresql+psycopg://",
        f"postgresql+psycopg_async://me:secret@/c?{host}": "write the path of an SQLite file or postgresql+psycopg://",
    }
    for target, words_expected in cases.items():
        result = words("devices", "--db", target)
        (line,) = result.stderr.splitlines()
        assert result.exit_code == 2
        assert words_expected in line
        assert "secret" not in line.replace("oauth_client_secret=***", "")
    result = words("serve", "--db", postgres)
    assert (result.exit_code, "esicatalog snapshot" in result.stderr) == (2, True)


def test_without_psycopg_it_says_what_to_install(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "psycopg", None)
    result = words("devices", "--db", "postgresql://me:secret@host/c")
    (line,) = result.stderr.splitlines()
    assert (result.exit_code, "pip install 'esicatalog[postgres]'" in line, "secret" in line) == (2, True, False)
