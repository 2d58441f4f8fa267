"""Queries stay fast in large catalogs: one statement a filter, no table of entries read from end to end."""

import re
import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest
import sqlalchemy as sa
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from snippets import device, dictionary, esi, pdo, rows, write
from web_client import client

from esicatalog import Catalog
from esicatalog.catalog import identity
from esicatalog.catalog.device_filter import IDENTIFICATIONS, MODES, PROTOCOLS, SYNC_SIGNALS, DeviceFilter
from esicatalog.catalog.search import ADDRESSED, NOT_ADDRESSED, conditions, device_query, find_devices
from esicatalog.identity import Bounds, Identity

ONE_ROW_A_DEVICE = {
    "devices",
    "vendors",
    "device_facts",
    "mailboxes",
    "dc_modes",
    "profiles",
    "profile_channels",
    "vendor_names",
    "slots",
}
"""Tables that may be read from end to end: about one short row a device, or fewer."""
FIRST_DEVICES = {"asked", "fit"}
"""The few devices that a page asks one by one before any list is made."""
OF_FOUND = ONE_ROW_A_DEVICE | {"pdos", "modules", "device_modules", "drive_modes"}
"""Evidence of half of all devices may read these from end to end: that is what it is about."""
DRIVE = Identity(0xE0000000, 0x10000 + 2, None, None)

bounds = st.sampled_from([Bounds(None, 8), Bounds(13, 13), Bounds(1, None)])
mapped = st.sampled_from([(0x6040, None), (0x6040, 0), (0x7000, 1), (0x60B2, None), (0x5555, 3)])
objects = st.sampled_from([(0x6502, None), (0x1018, 3), (0x1018, None), (0x5555, 1)])
FILTERS = {
    "vendor_id": st.just(0xE0000001),
    "vendor": st.sampled_from(["0001", "nobody"]),
    "product_code": st.just(0x10003),
    "text": st.sampled_from(["drive", "T0", "0x10003 terminal"]),
    "profile_no": st.sampled_from([402, 5001, 1]),
    "modes": st.lists(st.sampled_from(MODES), min_size=1, max_size=3).map(tuple),
    "sync": st.sampled_from(SYNC_SIGNALS),
    "protocol": st.sampled_from(PROTOCOLS),
    "identification": st.sampled_from(IDENTIFICATIONS),
    "physics": st.sampled_from(["YY", "KK"]),
    **dict.fromkeys(("bytes_in", "bytes_out", "min_cycle_ns", "e_bus_ma", "axes"), bounds),
    **{
        name: st.just(True)
        for name in ("needs_dc", "complete_access", "pdo_assign", "pdo_config", "bootstrap", "no_lrw")
    },
    "maps": st.lists(mapped, min_size=1, max_size=3).map(tuple),
    "not_maps": st.lists(mapped, min_size=1, max_size=2).map(tuple),
    "objects": st.lists(objects, min_size=1, max_size=2).map(tuple),
    "like": st.just(DRIVE),
    "all_variants": st.booleans(),
    "include_hidden": st.booleans(),
    "limit": st.sampled_from([None, 0, 50]),
}
"""A strategy for every filter that stands alone."""
SHARPENED = {"strict": ("modes", True), "bits": ("maps", 16)}
"""Filters that only sharpen another one."""


def test_every_filter_is_here():
    assert set(DeviceFilter.__struct_fields__) == FILTERS.keys() | SHARPENED.keys()


@st.composite
def filters(draw: st.DrawFn) -> DeviceFilter:
    chosen = draw(st.fixed_dictionaries({}, optional=FILTERS))
    for name, (needed, value) in SHARPENED.items():
        if needed in chosen and draw(st.booleans()):
            chosen[name] = value
    return DeviceFilter(**chosen)


@pytest.fixture(scope="session", params=["analyzed", "never analyzed"])
def engine(request, library_db: Path, tmp_path_factory: pytest.TempPathFactory) -> sa.Engine:
    copy = tmp_path_factory.mktemp("plans") / "catalog.db"
    shutil.copy(library_db, copy)
    with closing(sqlite3.connect(copy)) as connection:
        connection.execute("ANALYZE")
        if request.param != "analyzed":
            connection.execute("DELETE FROM sqlite_stat1")
        connection.commit()
    return sa.create_engine(f"sqlite:///{copy}")


@contextmanager
def executed(connection: sa.Connection) -> Iterator[list[tuple[str, tuple]]]:
    """Statements with their parameters, while the block runs."""
    found: list[tuple[str, tuple]] = []

    def note(_connection, _cursor, statement, parameters, _context, _many):
        found.append((statement, parameters))

    sa.event.listen(connection, "before_cursor_execute", note)
    yield found
    sa.event.remove(connection, "before_cursor_execute", note)


def scanned(connection: sa.Connection, statement: str, parameters: tuple) -> set[str]:
    """Tables, by name or alias, that a statement reads from end to end."""
    plan = connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {statement}", parameters).all()
    found = (re.match(r"SCAN (\w+)", row[3]) for row in plan)
    return {match[1] for match in found if match is not None} - {"device_search", "CONSTANT"}


def check(engine: sa.Engine, wanted: DeviceFilter) -> None:
    with engine.connect() as connection:
        held = list(conditions(connection, wanted))
        with executed(connection) as statements:
            rows = connection.execute(device_query(held, wanted)).all()
        assert len(statements) == 1
        with executed(connection) as statements:
            found = find_devices(connection, wanted)
        assert len(found) == len(rows)
        of_slots = 1 if wanted.maps or wanted.not_maps or wanted.objects else 0
        assert len(statements) <= 1 + len(held) + of_slots + (2 if wanted.like is not None else 0)
        for statement, parameters in statements:
            lists = "ORDER BY devices.vendor_id" in statement
            allowed = ONE_ROW_A_DEVICE | FIRST_DEVICES if lists else OF_FOUND
            assert scanned(connection, statement, parameters) <= allowed, statement


@pytest.mark.parametrize("name", FILTERS)
@settings(max_examples=5, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_a_filter_alone(engine, name, data):
    check(engine, DeviceFilter(**{name: data.draw(FILTERS[name])}))


@pytest.mark.parametrize("bits", [None, 1, 16, 32])
@pytest.mark.parametrize("index", [0x6040, 0x7000, 0x60B2, 0x6064])
def test_evidence_of_mappings_begins_with_the_devices_found(engine, index, bits):
    check(engine, DeviceFilter(maps=((index, None),), bits=bits))


@settings(max_examples=10, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(wanted=filters())
def test_filters_together(engine, wanted):
    check(engine, wanted)


@pytest.mark.parametrize("beside", [(), (ADDRESSED,), (NOT_ADDRESSED,)])
def test_a_page_of_a_long_list_is_read_in_its_order(engine, beside):
    """Devices are walked by the index that has their order: no list is sorted to show its first devices."""
    for chosen in (
        {},
        {"maps": ((0x6040, None),)},
        {"objects": ((0x1018, 3),)},
        {"protocol": "coe"},
        {"sync": "sync0"},
    ):
        wanted = DeviceFilter(**chosen, limit=50)
        with engine.connect() as connection, executed(connection) as statements:
            connection.execute(device_query([*conditions(connection, wanted), *beside], wanted))
            plan = connection.exec_driver_sql("EXPLAIN QUERY PLAN " + statements[-1][0], statements[-1][1]).all()
        walked = re.compile(r"(SCAN|SEARCH) devices USING INDEX ix_devices_listed( \(vendor_id>\?\))?")
        assert [row[3] for row in plan if walked.fullmatch(row[3])]
        assert not [row[3] for row in plan if "TEMP B-TREE" in row[3]]


def test_revisions_of_a_product_are_read_in_their_order(engine):
    with engine.connect() as connection:
        plan = connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {identity._OF_PRODUCT}", (2, 1)).all()
    assert "SEARCH d USING INDEX ix_devices_listed (vendor_id=? AND product_code=?)" in [row[3] for row in plan]
    assert not [row[3] for row in plan if "TEMP B-TREE" in row[3]]


@contextmanager
def traced() -> Iterator[list[str]]:
    """Every SELECT that any of our connections runs, those on the driver itself too."""
    found: list[str] = []

    def connected(connection: sqlite3.Connection, _record) -> None:
        connection.set_trace_callback(lambda text: found.append(text) if text.startswith("SELECT") else None)

    sa.event.listen(sa.Pool, "connect", connected)
    yield found
    sa.event.remove(sa.Pool, "connect", connected)


def of_size(count: int) -> str:
    """A device with so many objects, PDOs, commands and modules with dictionaries of their own."""

    def plain(index: int) -> str:
        return (
            f"<Object><Index>#x{index:04X}</Index><Name>O{index}</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
        )

    types = "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
    command = "<InitCmd><Transition>PS</Transition><Index>#x2000</Index><SubIndex>0</SubIndex><Data>00</Data></InitCmd>"
    idents = "".join(f"<ModuleIdent>{n}</ModuleIdent>" for n in range(1, count + 1))
    content = (
        dictionary(types, "".join(plain(0x2000 + n) for n in range(count)))
        + "".join(pdo("RxPdo", f"#x{0x1600 + n:04X}", *[8] * 5) for n in range(count))
        + f"<Mailbox><CoE>{command * count}</CoE></Mailbox>"
        + f'<Slots><Slot MinInstances="0" MaxInstances="1">{idents}</Slot></Slots>'
    )
    modules = "".join(
        f'<Module><Type ModuleIdent="{n}">M{n}</Type><Name>M</Name>{pdo("TxPdo", "#x1A00", 8)}'
        f"{dictionary(types, plain(0x3000 + n))}</Module>"
        for n in range(1, count + 1)
    )
    return esi(device(content), modules)


async def test_a_device_page_takes_as_many_queries_whatever_the_size_of_the_device(tmp_path):
    counts = []
    for size in (1, 600):
        folder, db = write(tmp_path / str(size), {"a.xml": of_size(size)}), tmp_path / f"{size}.db"
        with Catalog.open(db, create=True) as catalog:
            catalog.ingest([folder], jobs=1)
        assert rows(db, "SELECT count(*) FROM device_modules") == [(size,)]
        with traced() as statements:
            web = await client(db)
            assert (await web.get("/-/esi/device/0xe5c/1/1")).status_code == 200
        counts.append(len(statements))
    small, large = counts
    assert small == large < 80


def test_a_description_takes_as_many_queries_whatever_the_number_of_its_variants(tmp_path):
    counts = []
    for count in (2, 12):
        documents = {f"{number}.xml": esi(device(type_text=f"T{number}")) for number in range(count)}
        folder, db = write(tmp_path / str(count), documents), tmp_path / f"{count}.db"
        with Catalog.open(db, create=True) as catalog:
            catalog.ingest([folder], jobs=1)
        with traced() as statements, Catalog.open(db) as catalog:
            described = catalog.device(Identity(0xE5C, 1, 1, 2))
        assert [item.sources[0].member for item in described.variants if item.device.variant == 2] == [
            described.sources[0].member
        ]
        assert len({item.sources for item in described.variants}) == count
        counts.append(len(statements))
    few, many = counts
    assert few == many
