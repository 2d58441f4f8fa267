"""What a stranger may send to the server: nothing is written, no file is read, nothing is unbounded, never a 500."""

import asyncio
import hashlib
import json
import socket
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlsplit

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from web_client import client, new_client

from esicatalog.web import http
from esicatalog.web.app import datasette_app
from esicatalog.web.http import MAX_BODY_BYTES

SECRET = "root:x:0:0"


def digest(db: Path) -> str:
    return hashlib.sha256(db.read_bytes()).hexdigest()


@pytest.fixture(scope="module", autouse=True)
def catalog_as_it_was(data_db: Path) -> Iterator[None]:
    """Whatever is sent here, the catalog is the same file afterwards."""
    before = digest(data_db)
    yield
    assert digest(data_db) == before


async def answer(web: Any, sql: str) -> Any:
    return await web.get("/catalog.json", params={"sql": sql, "_shape": "array"}, follow_redirects=True)


# SQL.

WRITES = [
    "DELETE FROM devices",
    "UPDATE devices SET type = 'x'",
    "INSERT INTO catalog_state VALUES ('a', 'b')",
    "DROP TABLE devices",
    "CREATE TABLE t (a)",
    "REPLACE INTO catalog_state VALUES ('a', 'b')",
    "VACUUM INTO '/tmp/copy.db'",
    "ATTACH DATABASE '/etc/passwd' AS p",
    "DETACH DATABASE main",
    "PRAGMA journal_mode = WAL",
    "PRAGMA writable_schema = 1",
    "PRAGMA user_version = 7",
    "REINDEX",
    "ANALYZE",
    "SELECT 1; DELETE FROM devices",
    "WITH a AS (SELECT 1) DELETE FROM devices",
    "WITH a AS (SELECT 1) INSERT INTO catalog_state SELECT 'a', 'b'",
    "EXPLAIN DELETE FROM devices",
    "/* select */ DELETE FROM devices",
    "SELECT load_extension('/lib/x86_64-linux-gnu/libc.so.6')",
    "SELECT readfile('/etc/passwd')",
    "SELECT writefile('/tmp/x', 'x')",
    "SELECT edit('x')",
    "SELECT fts3_tokenizer('x', x'00')",
    "SELECT * FROM fsdir('/etc')",
    "SELECT * FROM pragma_journal_mode('wal')",
    "INSERT INTO device_search (device_search) VALUES ('rebuild')",
]


@pytest.mark.parametrize("sql", WRITES)
async def test_sql_changes_nothing_and_reads_no_file(data_db, sql):
    before = digest(data_db)
    response = await answer(await client(data_db), sql)
    assert response.status_code < 500
    assert SECRET not in response.text
    if response.status_code == 200:  # Only EXPLAIN and what SQLite itself ignores.
        assert sql.startswith(("EXPLAIN", "SELECT * FROM pragma_")), response.text
    assert digest(data_db) == before
    assert [path.name for path in data_db.parent.iterdir()] == [data_db.name]
    assert not Path("/tmp/copy.db").exists()


async def test_sql_by_post_changes_nothing(data_db):
    before = data_db.read_bytes()
    web = await client(data_db)
    for path in ("/catalog", "/catalog/devices", "/catalog/-/query", "/catalog/find_a_device", "/catalog/-/create"):
        response = await web.post(path, data={"sql": "DELETE FROM devices"})
        assert response.status_code != 200, path
    assert data_db.read_bytes() == before


BOMBS = [
    "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT count(*) FROM n",
    "WITH RECURSIVE n(x) AS (SELECT 1 UNION SELECT x + 1 FROM n) SELECT x FROM n ORDER BY x DESC",
    "SELECT count(*) FROM object_entries a, object_entries b, object_entries c, object_entries d",
    "SELECT hex(zeroblob(500000000))",
    "SELECT hex(randomblob(900000000))",
    "SELECT replace(hex(zeroblob(4000000)), '0', hex(zeroblob(4000000)))",
    "SELECT group_concat(a.name || b.name || c.name) FROM pdo_entries a, pdo_entries b, pdo_entries c",
    "SELECT 'a' LIKE replace(hex(zeroblob(20000)), '00', '%a')",
]


@pytest.mark.parametrize("sql", [*BOMBS[2:], *(pytest.param(sql, marks=pytest.mark.faults) for sql in BOMBS[:2])])
async def test_sql_that_would_never_end_is_stopped(data_db, sql):
    response = await asyncio.wait_for(answer(await client(data_db), sql), 60)
    assert response.status_code == 400
    assert any(words in response.text.lower() for words in ("interrupted", "too long", "too big", "too complex"))


async def test_plain_datasette_has_bounds_too(data_db):
    """Without ``serve``: Datasette's own time limit, and the bounds of the plugin."""
    from datasette.app import Datasette

    plain = Datasette([str(data_db)])
    await plain.invoke_startup()
    for sql in (BOMBS[0], BOMBS[3]):
        found = await plain.client.get(
            f"/{data_db.stem}.json", params={"sql": sql, "_shape": "array"}, follow_redirects=True
        )
        assert found.status_code == 400, found.text


# Addresses.

NOWHERE = ["/-/esi/no/such/page", "/-/esi/export/igh.json", "/-/esi/device/1/1/1/1", "/catalog/devices/1/2", "/a/b/c/d"]


@pytest.mark.parametrize("path", NOWHERE)
@pytest.mark.parametrize("plain", [False, True])
async def test_an_address_that_nothing_answers(data_db, monkeypatch, path, plain):
    """Also where rich is installed, as it is for development: Datasette has it print what becomes a 404."""
    from datasette.app import Datasette

    monkeypatch.setattr("datasette.handle_exception.rich", pytest.importorskip("rich"))
    application = Datasette([str(data_db)]) if plain else datasette_app(data_db)
    await application.invoke_startup()
    assert (await application.client.get(path)).status_code == 404


# Files.

TRAVERSALS = ["../../../../etc/passwd", "/etc/passwd", "file:///etc/passwd", "..%2f..%2f..%2fetc%2fpasswd", "\0", "~0x"]
ROUTES = [
    "/-/esi/{}",
    "/-/esi/device/{}/1/1",
    "/-/esi/device/1/{}/1",
    "/-/esi/device/1/1/{}",
    "/-/esi/device/1/1/{}.json",
    "/-/esi/device/1/1/{}/objects",
    "/-/esi/device/0x1097/0x2406/0x8f/export/{}",
    "/-/esi/image/{}",
    "/-/esi/?text={}&vendor={}&like={}&maps={}&page={}",
    "/-/esi/devices.json?text={}&vendor={}",
    "/-/esi/identify.json?vendor={}&product=1",
    "/-/esi/compare?a={}&b={}",
    "/-/esi/device/0x1097/0x2406/0x8f?module={}",
    "/-/esi/device/0x1097/0x2406/0x8f/export/igh?name={}&pdo={}&op-mode={}",
    "/-/esi/device/0x1097/0x2406/0x8f/export/ros2?name={}",
    "/-/esi/device/0x1097/0x2406/0x8f/export/sii?merge={}",
    "/-/static/{}",
    "/-/static-plugins/esicatalog/{}",
    "/catalog/{}",
    "/{}",
]


@pytest.mark.parametrize("route", ROUTES)
async def test_no_route_reads_a_file(data_db, route):
    web = await client(data_db)
    for text in (*TRAVERSALS, str(data_db)):
        for written in (text, quote(text, safe="")):
            if "\0" in written:
                continue
            response = await web.get(route.replace("{}", written))
            assert response.status_code < 500, (route, written, response.text)
            assert SECRET not in response.text
            assert not response.content.startswith(b"SQLite format 3")


def test_what_is_posted_is_never_a_path(data_db, served):
    """The words that name files on the command line are content here."""
    for path, kind in (("/-/esi/identify.json", "text/plain"), ("/-/esi/scan", "application/x-www-form-urlencoded")):
        for text in ("/etc/passwd", "@/etc/passwd", "<!DOCTYPE a [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><a>&x;</a>"):
            body = text if kind == "text/plain" else f"scan={quote(text)}"
            status, answered = exchange(served, request("POST", path, body.encode(), kind))
            assert status == 400
            assert SECRET.encode() not in answered


# Sizes.


def request(method: str, path: str, body: bytes = b"", kind: str = "text/plain", length: int | None = None) -> bytes:
    size = len(body) if length is None else length
    head = f"{method} {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Type: {kind}\r\n"
    return f"{head}Content-Length: {size}\r\n\r\n".encode() + body


def exchange(address: str, sent: bytes, end: bool = False) -> tuple[int, bytes]:
    """Send raw bytes; the status and all that comes back. 0 when the server just closes the connection."""
    where = urlsplit(address)
    received = b""
    with socket.create_connection((where.hostname, where.port), timeout=60) as connection:
        try:
            connection.sendall(sent)
            if end:
                connection.shutdown(socket.SHUT_WR)
            while part := connection.recv(1 << 16):
                received += part
        except OSError:
            pass  # Refused and closed while we were sending.
    return (int(received.split(b" ", 2)[1]) if received else 0), received


def is_up(address: str) -> bool:
    return exchange(address, request("GET", "/-/esi/identify.json?vendor=0x1097&product=0x2406"))[0] == 200


@pytest.mark.parametrize(
    ("sent", "statuses"),
    [
        (b"GET /" + b"a" * 1_000_000 + b" HTTP/1.1\r\nHost: a\r\n\r\n", {0, 400, 414, 431}),
        (b"GET / HTTP/1.1\r\nHost: a\r\nX: " + b"a" * 1_000_000 + b"\r\n\r\n", {0, 400, 431}),
        (b"GET / HTTP/1.1\r\n" + b"X: a\r\n" * 200_000 + b"\r\n", {0, 400, 431}),
        (b"nonsense\r\n\r\n", {0, 400}),
        (b"\0" * 100_000, {0, 400}),
        (b"GET / HTTP/9.9\r\n\r\n", {0, 400, 505}),
        (request("POST", "/-/esi/identify.json", b"x" * (MAX_BODY_BYTES + 1)), {0, 413}),
        (request("POST", "/-/esi/scan", b"scan=" + b"x" * MAX_BODY_BYTES), {0, 413}),
        (request("POST", "/-/esi/identify.json", b"x" * 100, length=10**12), {0, 400}),
        (request("BREW", "/-/esi/identify.json"), {405}),
        (request("PUT", "/-/esi/scan", b"x"), {405}),
        (request("DELETE", "/-/esi/device/1/2/3"), {405}),
        (request("PUT", "/-/esi/image/" + "0" * 64), {404, 405}),
    ],
)
def test_what_is_too_much_or_no_http_is_refused(served, sent, statuses):
    status, answered = exchange(served, sent, end=0 in statuses)
    assert status in statuses
    assert len(answered) < 10_000
    assert is_up(served)


@pytest.mark.parametrize("path", ["/-/esi/identify.json", "/-/esi/scan"])
def test_chunks_without_end_are_cut_off(served, path):
    """413 while the client is still sending, or the connection closed; never the whole stream in memory."""
    where = urlsplit(served)
    head = f"POST {path} HTTP/1.1\r\nHost: a\r\nConnection: close\r\nTransfer-Encoding: chunked\r\n\r\n".encode()
    chunk = b"10000\r\n" + b"x" * 65536 + b"\r\n"
    sent, received = 0, b""
    with socket.create_connection((where.hostname, where.port), timeout=60) as connection:
        connection.sendall(head)
        try:
            while sent < 64 * MAX_BODY_BYTES:
                connection.sendall(chunk)
                sent += 65536
        except (BrokenPipeError, ConnectionResetError):
            pass
        with suppress(ConnectionResetError):
            received = connection.recv(1 << 16)
    assert sent < 64 * MAX_BODY_BYTES
    assert received == b"" or b" 413 " in received.split(b"\r\n")[0]
    assert is_up(served)


async def test_a_body_that_does_not_end_is_given_up(data_db, monkeypatch):
    monkeypatch.setattr(http, "MAX_BODY_SECONDS", 0.1)

    class Slow:
        async def receive(self) -> dict[str, Any]:
            await asyncio.sleep(5)
            return {"type": "http.request", "body": b""}

    with pytest.raises(http.HttpError, match="did not end within") as refused:
        await http.body_of(Slow())
    assert refused.value.status == 408


def test_slow_clients_hold_up_nobody(served):
    """A hundred connections that send nothing or half a request, and others are answered."""
    where = urlsplit(served)
    half = b"POST /-/esi/scan HTTP/1.1\r\nHost: a\r\nContent-Length: 100\r\n\r\nscan="
    idle = []
    try:
        for number in range(100):
            idle.append(socket.create_connection((where.hostname, where.port), timeout=60))
            idle[-1].sendall(half if number % 2 else b"GET / HT")
        assert is_up(served)
    finally:
        for connection in idle:
            connection.close()
    assert is_up(served)


async def test_scans_of_too_many_slaves_are_refused(data_db):
    web = await client(data_db)
    text = "vendor,product,revision\n" + "1,2,3\n" * 10_001
    posted = await web.post("/-/esi/identify.json", content=text.encode())
    assert (posted.status_code, posted.json()) == (413, {"error": "more than 10000 slaves at once"})
    page = await web.post("/-/esi/scan", data={"scan": text})
    assert (page.status_code, "more than 10000 slaves at once" in page.text) == (413, True)


# Uploads: whatever is sent, the answer is one of these.

EXPECTED = {200, 400, 404, 413, 415}
FUZZ = settings(max_examples=50, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))

SLAVES = "=== Master 0, Slave 0 ===\nIdentity:\n  Vendor Id:       0x00001097\n  Product code:    0x00002406\n"
HEADS = st.sampled_from(
    [
        "",
        SLAVES,
        "SOEM (Simple Open EtherCAT Master)\nSlave:1\n",
        "vendor,product,revision\n",
        "<EtherCATConfig>",
        ":10",
    ]
)
PIECES = st.sampled_from(
    ["0x1097", "-1", "0x100000000", ",", ";", "\n", "\r", "\t", '"', "=== Master 9, Slave 70000 ===\n", "Slave:2\n",
     " Man: 00001097 ID: 00002406 Rev: 0000008f\n", "  SM0: PhysAddr 0x1000, DefaultSize 128\n",
     "0  0:0  PREOP  +  X\n", "\ufeff", "\u0130", "<Slave>", "</", "&#0;", "]]>", "1e999", "9" * 400]
)  # fmt: skip
TEXTS = st.builds(
    lambda head, pieces: head + "".join(pieces), HEADS, st.lists(st.one_of(PIECES, st.text()), max_size=30)
)


def image() -> bytes:
    return bytes(16) + (0x1097).to_bytes(4, "little") + bytes(108)


@st.composite
def images(draw: Any) -> bytes:
    """EEPROM images with categories of any type and length, and bytes put anywhere."""
    content = bytearray(image())
    for kind, size, body in draw(
        st.lists(
            st.tuples(
                st.sampled_from([10, 30, 40, 41, 50, 51, 60, 0, 0xFFFF]), st.integers(0, 0xFFFF), st.binary(max_size=60)
            )
        )
    ):
        content += kind.to_bytes(2, "little") + size.to_bytes(2, "little") + body
    for at, byte in draw(st.lists(st.tuples(st.integers(0, 4095), st.integers(0, 255)), max_size=8)):
        content[at % len(content)] = byte
    return bytes(content)


BODIES = st.one_of(TEXTS.map(lambda text: text.encode("utf-8", "replace")), images(), st.binary(max_size=2000))
JSON = st.recursive(
    st.one_of(
        st.none(), st.booleans(), st.integers(), st.floats(), st.text(), st.sampled_from(["0x1097:0x2406", "1:2:3"])
    ),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.sampled_from(["vendor", "product", "revision", "x"]), inner)
    ),
    max_leaves=20,
)


@pytest.fixture(scope="module")
def asked(data_db: Path) -> Iterator[Callable[..., Any]]:
    """Answers of one running application, for tests that ask many times."""
    with asyncio.Runner() as runner:
        web = runner.run(new_client(data_db))
        yield lambda method, path, **options: runner.run(getattr(web, method)(path, **options))


@FUZZ
@given(body=BODIES)
@example(body=b"")
@example(body=b"[" * 5000)
def test_any_text_or_image_as_a_scan(asked, body):
    response = asked("post", "/-/esi/identify.json", content=body)
    assert response.status_code in EXPECTED
    assert response.status_code == 200 or set(response.json()) == {"error"}


@FUZZ
@given(value=JSON)
def test_any_json_as_identities(asked, value):
    response = asked("post", "/-/esi/identify.json", content=json.dumps([value]).encode())
    assert response.status_code in EXPECTED


@FUZZ
@given(body=BODIES, name=st.text(max_size=20), kind=st.sampled_from(["file", "scan", "other"]))
def test_any_file_on_the_scan_page(asked, body, name, kind):
    name = name.replace("\0", "") or "x"
    response = asked("post", "/-/esi/scan", files={kind: (name, body)})
    assert response.status_code in EXPECTED


@FUZZ
@given(
    body=st.binary(max_size=500),
    kind=st.one_of(
        st.sampled_from(
            [
                "multipart/form-data",
                "multipart/form-data; boundary=",
                "multipart/form-data; boundary=a",
                "",
                "application/x-www-form-urlencoded; charset=utf-7",
                "a/b",
            ]
        ),
        st.text(st.characters(min_codepoint=32, max_codepoint=126), max_size=60).map(str.strip),
    ),
)
def test_any_bytes_as_a_form(asked, body, kind):
    for content in (body, b"--a\r\n" + body + b"\r\n--a--\r\n", b"--a\r\nContent-Disposition: " + body):
        response = asked("post", "/-/esi/scan", content=content, headers={"content-type": kind})
        assert response.status_code in EXPECTED


@FUZZ
@given(
    parts=st.lists(st.text(min_size=1, max_size=12), min_size=3, max_size=3),
    query=st.dictionaries(
        st.sampled_from(
            ["module", "pdo", "op-mode", "cycle-ns", "name", "alias", "position", "page", "text", "maps", "like"]
        ),
        st.one_of(st.text(max_size=20), st.sampled_from(["0=1", "1=0x200", "0x1600", "-1", "9" * 30])),
        max_size=3,
    ),
    tail=st.sampled_from(
        ["", ".json", "/objects", *(f"/export/{name}" for name in ("igh", "sii", "esi", "ros2", "cstruct"))]
    ),
)
def test_any_address_of_a_device(asked, parts, query, tail):
    for words in (parts, ["0x1097", "0x2406", "0x8f"]):
        path = "/-/esi/device/" + "/".join(quote(word, safe="") for word in words) + tail
        assert asked("get", path, params=query).status_code in EXPECTED | {302}
    assert asked("get", "/-/esi/", params=query).status_code in EXPECTED
