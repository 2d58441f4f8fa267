"""The catalog in Datasette: every page opens, search finds what people type, ``serve`` serves."""

import json
import signal
import socket
import sqlite3
import subprocess
import sys
import urllib.request
from pathlib import Path
from typing import Any

import datasette
import pytest
from click.testing import CliRunner
from datasette.app import Datasette
from datasette.cli import cli as datasette_cli
from datasette.utils import parse_metadata
from lxml import html
from snippets import device, esi
from web_client import client

from esicatalog.api import Catalog
from esicatalog.catalog.schema import metadata
from esicatalog.catalog.views import FULL_TEXT, views
from esicatalog.cli.main import cli
from esicatalog.resources import resource
from esicatalog.web.app import datasette_app
from esicatalog.web.functions import hex0x, parse_hex

DATASETTE_0 = datasette.__version__.startswith("0.")
METADATA = parse_metadata(resource("datasette-metadata.yml").read_text(encoding="utf-8"))["databases"]["catalog"]
TABLES = [*metadata.tables, *(view.name for view in views("sqlite")), FULL_TEXT, "alembic_version"]

# Parameters of every canned query, and the device types (or documents) that it must answer with.
QUERY_EXAMPLES: dict[str, tuple[dict[str, str], set[Any]]] = {
    "find_a_device": ({"text": "D808"}, {"ECX-D808"}),
    "devices_by_drive_profile": (
        {"profile": "402"},
        {"L6N", "ECX-A202", "EYOU_ServoModule_V143", "RT118X-SERVO-MOTOR"},
    ),
    "devices_with_dc_sync1": ({"vendor": ""}, {"ECX-D808"}),
    "drives_with_a_mode": ({"mode": "csv", "strict": "1"}, {"L6N", "ECX-A202", "EYOU_ServoModule_V143"}),
    "csv_drives_with_sync1": ({}, set()),
    "csp_drives_with_fsoe": ({}, set()),
    "drive_modes_of_each_vendor": ({}, {0xE5C, 0x1097, 0x4321, 0xE00004D8}),
    "devices_of_the_same_layout": (
        {"vendor": "0xE5C", "product": "0x0d080808", "revision": "0x00100000"},
        {"ECX-D808"},
    ),
    "devices_by_mailbox_protocol": ({"protocol": "FoE"}, {"ECX-A202"}),
    "who_maps_an_object": ({"index": "0x60FF", "subindex": "0"}, {"L6N", "ECX-A202", "EYOU_ServoModule_V143"}),
    "revisions_of_a_product": ({"vendor": "0xE5C", "product": "#x0d080808"}, {"ECX-D808"}),
    "conflicting_descriptions_of_an_identity": ({"vendor": "", "product": "", "revision": ""}, set()),
    "problems_of_ingest": ({"document": "readme", "severity": "i"}, {"README.md"}),
}


@pytest.fixture
async def browser(data_db: Path) -> Any:
    """A client of the catalog of data/, whose file is not called catalog.db."""
    return await client(data_db)


async def rows(browser: Any, path: str, **parameters: str) -> list[dict[str, Any]]:
    response = await browser.get(path, params={**parameters, "_shape": "objects"})
    assert response.status_code == 200, response.text
    found: list[dict[str, Any]] = response.json()["rows"]
    return found


async def searched(browser: Any, text: str, table: str = "devices", column: str = "type") -> set[str]:
    return {row[column] for row in await rows(browser, f"/catalog/{table}.json", _search=text)}


@pytest.mark.parametrize("path", ["/", "/catalog", "/catalog.json", "/-/plugins.json"])
async def test_front_pages_open(browser, path):
    assert (await browser.get(path)).status_code == 200


@pytest.mark.parametrize("table", TABLES)
async def test_every_table_and_view_opens(browser, table):
    page = await browser.get(f"/catalog/{table}")
    assert page.status_code == 200, page.text
    assert await rows(browser, f"/catalog/{table}.json") is not None


@pytest.mark.parametrize("query", QUERY_EXAMPLES)
async def test_every_canned_query_answers(browser, query):
    parameters, expected = QUERY_EXAMPLES[query]
    page = await browser.get(f"/catalog/{query}", params=parameters)
    assert page.status_code == 200, page.text
    found = await rows(browser, f"/catalog/{query}.json", **parameters)
    assert {row.get("device_type", row.get("document", row.get("vendor_id"))) for row in found} == expected
    assert all(row.get("device_id", row.get("source_id", row.get("vendor_id"))) for row in found)


@pytest.mark.parametrize("query", QUERY_EXAMPLES)
async def test_canned_queries_open_without_parameters(browser, query):
    assert (await browser.get(f"/catalog/{query}")).status_code == 200


def test_metadata_names_what_exists():
    assert set(METADATA["queries"]) == set(QUERY_EXAMPLES)
    assert set(METADATA["tables"]) == set(TABLES)


async def test_module_that_maps_is_named(browser):
    found = await rows(browser, "/catalog/who_maps_an_object.json", index="24831", subindex="")
    assert ("ECX-A202", "CSV") in {(row["device_type"], row["module_type"]) for row in found}


async def test_superseded_revision_is_marked(browser):
    found = await rows(browser, "/catalog/revisions_of_a_product.json", vendor="", product="0x0d080808")
    assert [(row["revision_no_hex"], row["superseded_by"]) for row in found] == [
        ("0x00100000", "0x00110000"),
        ("0x00110000", None),
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("ECX-D808", {"ECX-D808"}),
        ("d808", {"ECX-D808"}),
        ("808", {"ECX-D808"}),
        ("8 outputs", {"ECX-D808"}),
        ("V1", {"EYOU_ServoModule_V143"}),
        ("0x00002406", {"EYOU_ServoModule_V143"}),
        ("0x2406", {"EYOU_ServoModule_V143"}),
        ("#x2406", {"EYOU_ServoModule_V143"}),
        ("#x00002406", {"EYOU_ServoModule_V143"}),
        ("9222", {"EYOU_ServoModule_V143"}),
        ("0x1097 0x8f", {"EYOU_ServoModule_V143"}),
        ("L6", {"L6N"}),
        ('"', set()),
    ],
)
async def test_search_finds_what_people_type(browser, text, expected):
    assert await searched(browser, text) == expected
    assert await searched(browser, text, "device_overview", "device_type") == expected


async def test_search_works_in_views_of_parts(browser):
    assert await searched(browser, "ECX-D808", "device_pdo_entries", "device_type") == {"ECX-D808"}
    words = "words of the device (vendor, type, name, identity), not of the row"
    assert words in (await browser.get("/catalog/device_pdo_entries")).text


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("/catalog/pdos?_size=max", "0xe5c/0xd080808/0x110000"),
        ("/catalog/drive_modes", "0x1097/0x2406/0x8f"),
        ("/catalog?sql=select+distinct+device_id+from+pdos", "0xe5c/0xd080808/0x110000"),
    ],
)
async def test_device_keys_of_tables_lead_to_device_pages(browser, path, expected):
    tree = html.fromstring((await browser.get(path, follow_redirects=True)).text)
    links = set(tree.xpath("//td[contains(@class, 'col-device_id')]//a/@href"))
    assert links
    targets = {(await browser.get(link, follow_redirects=False)).headers["location"] for link in links}
    assert f"/-/esi/device/{expected}" in targets
    for target in targets:
        assert (await browser.get(target)).status_code == 200


async def test_device_key_that_nobody_has(browser):
    assert (await browser.get("/-/esi/row/999999999")).status_code == 404


async def test_device_without_codes_leads_to_its_row(tmp_path):
    document = tmp_path / "cap.xml"
    document.write_text(esi(device(product="")))
    with Catalog.open(tmp_path / "catalog.db", create=True) as catalog:
        catalog.ingest([document])
    browser = await client(tmp_path / "catalog.db")
    answer = await browser.get("/-/esi/row/1", follow_redirects=False)
    assert answer.headers["location"] == "/catalog/devices/1"


@pytest.fixture(scope="module")
async def behind_a_prefix(data_db: Path) -> Any:
    application = datasette_app(data_db)
    application._settings["base_url"] = "/prefix/"
    await application.invoke_startup()
    return application.client


@pytest.mark.parametrize("path", ["/", "/catalog", f"/catalog{'' if DATASETTE_0 else '/-/query'}?sql=select+1"])
async def test_descriptions_begin_with_the_device_pages(browser, behind_a_prefix, path):
    """Also behind a prefix, where a description in a file does not know it."""
    for web, prefix in ((browser, "/"), (behind_a_prefix, "/prefix/")):
        tree = html.fromstring((await web.get(path)).text)
        href = tree.xpath("//*[contains(@class, 'metadata-description')]//a/@href")[0]
        assert urllib.parse.urljoin(f"http://localhost{prefix.rstrip('/')}{path}", href) == (
            f"http://localhost{prefix}-/esi/"
        )


@pytest.mark.parametrize("table", ["devices", "device_overview"])
async def test_columns_are_described(browser, table):
    tree = html.fromstring((await browser.get(f"/catalog/{table}")).text)
    shown = {
        name.text_content(): name.getnext().text_content().strip() for name in tree.cssselect(".column-descriptions dt")
    }
    assert shown == {name: text.strip() for name, text in METADATA["tables"][table]["columns"].items()}


async def test_hex_in_a_filter_is_no_error(browser):
    assert (await browser.get("/catalog/devices?product_code=0x0d080808")).status_code == 200
    assert len(await rows(browser, "/catalog/device_overview.json", product_code_hex="0x0d080808")) == 2


async def test_internal_tables_are_hidden(browser):
    listed = (await browser.get("/catalog.json")).json()["tables"]
    shown = {table["name"] for table in listed if not table["hidden"]}
    assert {"devices", "pdo_entries", "vendors"} <= shown
    assert not shown & {"catalog_state", "alembic_version", "dictionary_objects"}
    assert not any(name.startswith(FULL_TEXT) for name in shown)


async def test_style_is_served_to_catalogs_only(browser, tmp_path):
    style = "/-/static-plugins/esicatalog/catalog.css"
    assert style in (await browser.get("/catalog/devices")).text
    assert (await browser.get(style)).status_code == 200
    other = tmp_path / "other.db"
    with sqlite3.connect(other) as connection:
        connection.execute("CREATE TABLE things (name TEXT)")
    assert style not in (await Datasette([str(other)]).client.get("/other/things")).text


async def test_other_databases_keep_their_search(tmp_path):
    other = tmp_path / "other.db"
    with sqlite3.connect(other) as connection:
        connection.execute("CREATE VIRTUAL TABLE notes USING fts5(body)")
        connection.execute("INSERT INTO notes VALUES ('EL1100 and more')")
    answer = await Datasette([str(other)]).client.get(
        "/other.json" if DATASETTE_0 else "/other/-/query.json",
        params={"sql": "select escape_fts('EL1100 more'), parse_hex('0x10')", "_shape": "arrays"},
    )
    assert answer.json()["rows"] == [['"EL1100" "more"', 16]]


def test_numbers_in_sql():
    assert [parse_hex(text) for text in ("0x60FF", "#x60ff", "24831", 24831)] == [24831] * 4
    assert [parse_hex(text) for text in ("", None, "EL1100", "0x", "-1", "9" * 30)] == [None] * 6
    assert (hex0x(24831), hex0x(2, 8), hex0x(255, 0)) == ("0x60ff", "0x00000002", "0xff")
    assert [hex0x(value) for value in (None, "text", -1)] == [None] * 3


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("/catalog/find_a_device.json?text=D808&_shape=objects", "ECX-D808"),
        ("/catalog/devices.json?_search=0x1097&_shape=objects", "EYOU_ServoModule_V143"),
    ],
)
def test_plain_datasette_takes_the_metadata(tmp_path, data_db, path, text):
    """``datasette catalog.db -m datasette-metadata.yml`` works without ``serve``."""
    copied = tmp_path / "catalog.db"
    copied.write_bytes(data_db.read_bytes())
    described = resource("datasette-metadata.yml")
    # Datasette 1.0 takes canned queries from the configuration.
    options = ["-m", described] if DATASETTE_0 else ["-m", described, "-c", described]
    done = CliRunner().invoke(datasette_cli, ["serve", *map(str, [copied, *options]), "--get", path])
    assert (done.exit_code, text in done.stdout) == (0, True), done.output


def serve(*arguments: object) -> "subprocess.Popen[str]":
    command = [sys.executable, "-m", "esicatalog", "serve", *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


@pytest.mark.parametrize("options", [(), pytest.param(("--immutable",), marks=pytest.mark.faults)])
def test_serve_prints_its_addresses_and_ends_quietly(data_db, options):
    server = serve("--db", data_db, "--port", 0, *options)
    try:
        assert server.stdout is not None
        tables, devices = server.stdout.readline().split(), server.stdout.readline().split()
        assert tables[0].startswith("http://127.0.0.1:")
        assert (tables[1:], devices[1:]) == ([], ["devices:", "search,", "scan,", "compare"])
        with urllib.request.urlopen(devices[0], timeout=10) as response:
            assert b"<h1>EtherCAT devices</h1>" in response.read()
        with urllib.request.urlopen(f"{tables[0]}.json", timeout=10) as response:
            assert json.load(response)["database"] == "catalog"
        server.send_signal(signal.SIGINT)
        output, errors = server.communicate(timeout=10)
        assert (server.returncode, output, errors) == (0, "", "")
    finally:
        server.kill()
        server.wait()


def refused(*arguments: object) -> str:
    """What ``serve`` says when it does not start: one line, exit code 2."""
    result = CliRunner().invoke(cli, ["serve", *map(str, arguments)], catch_exceptions=False)
    assert (result.exit_code, result.stdout, result.stderr.count("\n")) == (2, "", 1)
    return result.stderr


def test_serve_refuses_a_port_in_use(data_db):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert f"port {port} of 127.0.0.1 is in use" in refused("--db", data_db, "--port", port)


def test_serve_refuses_what_is_no_catalog(tmp_path):
    foreign = tmp_path / "foreign.db"
    with sqlite3.connect(foreign) as connection:
        connection.execute("CREATE TABLE things (name TEXT)")
    broken = tmp_path / "broken.db"
    broken.write_bytes(b"no database at all " * 100)
    assert "no such catalog" in refused("--db", tmp_path / "missing.db")
    assert "other tables" in refused("--db", foreign)
    assert "not an SQLite catalog" in refused("--db", broken)
    assert "SQLite files only" in refused("--db", "postgresql://localhost/catalog")
    assert "in its path" in refused("--db", tmp_path / "a#b.db")


@pytest.mark.corpus
@pytest.mark.parametrize("text", ["EK1100", "EL1100", "1100", "0x044c2c52", "72100946", "drive 2"])
async def test_corpus_search_agrees_with_the_command(corpus_db, text):
    with Catalog.open(corpus_db) as catalog:
        expected = {device.type for device in catalog.devices(text=text, all_variants=True, include_hidden=True)}
    assert await searched_all(await client(corpus_db), text) == expected
    if text in ("EK1100", "0x044c2c52"):
        assert "EK1100" in expected


async def searched_all(browser: Any, text: str) -> set[str]:
    found = await rows(browser, "/catalog/devices.json", _search=text, _size="max")
    return {row["type"] for row in found}


@pytest.mark.corpus
@pytest.mark.parametrize("query", QUERY_EXAMPLES)
async def test_corpus_canned_queries_answer(corpus_db, query):
    browser = await client(corpus_db)
    assert await rows(browser, f"/catalog/{query}.json", **QUERY_EXAMPLES[query][0]) is not None
