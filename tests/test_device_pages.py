"""A page of the list of devices is a part of the whole list, and is found without making lists of all devices."""

from collections.abc import Iterator
from pathlib import Path

import pytest
import sqlalchemy as sa
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from snippets import rows
from test_query_plans import filters

from esicatalog.catalog import search
from esicatalog.catalog.conditions import Condition, among
from esicatalog.catalog.device_filter import DeviceFilter
from esicatalog.catalog.listing import list_devices
from esicatalog.catalog.schema import devices
from esicatalog.catalog.search import conditions, device_query, find_devices, found_devices

EXAMPLES = settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture(scope="module")
def connection(library_db) -> Iterator[sa.Connection]:
    with sa.create_engine(f"sqlite:///{library_db}").connect() as connection:
        yield connection


@pytest.fixture(params=[1, 20, 300])
def asked(request, monkeypatch: pytest.MonkeyPatch) -> int:
    """How many of the 210 devices are asked one by one: hardly any, some, all."""
    monkeypatch.setattr(search, "_ASKED", request.param)
    return request.param


def found(connection: sa.Connection, wanted: DeviceFilter, limit: int | None, offset: int = 0) -> list:
    limited = replaced(wanted, limit)
    return found_devices(connection, list(conditions(connection, limited)), limited, offset)


def replaced(wanted: DeviceFilter, limit: int | None) -> DeviceFilter:
    fields = {name: getattr(wanted, name) for name in DeviceFilter.__struct_fields__}
    return DeviceFilter(**fields | {"limit": limit})


@EXAMPLES
@given(wanted=filters(), limit=st.integers(0, 40), offset=st.integers(0, 30))
def test_a_page_is_a_part_of_the_whole_list(connection, asked, wanted, limit, offset):
    whole = found(connection, wanted, None)
    assert found(connection, wanted, limit, offset) == whole[offset : offset + limit]


def mapping(db: Path, index: int) -> set[int]:
    """Devices of which a PDO, or one of a module that they can reach, maps an object; worked out in Python."""
    pdos = {number for number, entry in rows(db, "SELECT pdo_id, entry_index FROM pdo_entries") if entry == index}
    return owning(db, "SELECT id, device_id, module_id FROM pdos", pdos)


def holding(db: Path, index: int) -> set[int]:
    """Devices with an object, their own or of a module that they can reach; worked out in Python."""
    objects = {number for number, held in rows(db, "SELECT id, object_index FROM objects") if held == index}
    links = rows(db, "SELECT dictionary_id, object_id FROM dictionary_objects")
    dictionaries = {dictionary for dictionary, number in links if number in objects}
    return owning(db, "SELECT dictionary_id, device_id, module_id FROM profiles", dictionaries)


def owning(db: Path, query: str, wanted: set[int]) -> set[int]:
    """Devices that own rows (number, device, module) with wanted numbers, or can reach the module that does."""
    owners = [owner for number, *owner in rows(db, query) if number in wanted]
    modules = {module for _, module in owners}
    links = rows(db, "SELECT device_id, module_id FROM device_modules")
    own = {device for device, _ in owners if device is not None}
    return own | {device for device, module in links if module in modules}


@pytest.mark.parametrize("index", [0x6040, 0x7000, 0x6000, 0x60B2, 0x5555])
def test_mapped_objects_are_those_of_devices_and_their_modules(library_db, connection, asked, index):
    numbers = {row[0] for row in rows(library_db, "SELECT id FROM devices")}
    every = {"all_variants": True, "include_hidden": True}
    expected = mapping(library_db, index)
    for limit in (None, 210):
        with_it = found(connection, DeviceFilter(maps=((index, None),), **every), limit)
        without = found(connection, DeviceFilter(not_maps=((index, None),), **every), limit)
        assert {number for number, _ in with_it} == expected
        assert {number for number, _ in without} == numbers - expected


@pytest.mark.parametrize("index", [0x6502, 0x1018, 0x6000, 0x5555])
def test_objects_are_those_of_devices_and_their_modules(library_db, connection, asked, index):
    every = {"all_variants": True, "include_hidden": True}
    for limit in (None, 210):
        with_it = found(connection, DeviceFilter(objects=((index, None),), **every), limit)
        assert {number for number, _ in with_it} == holding(library_db, index)


@pytest.mark.parametrize(
    ("asked", "fitting", "listed"),
    [
        pytest.param(20, 5, 0, id="the devices asked fill the page"),
        pytest.param(20, 4, 1, id="they do not"),
        pytest.param(300, 4, 0, id="all devices were asked"),
    ],
)
def test_a_list_is_made_only_where_a_page_needs_it(connection, monkeypatch, asked, fitting, listed):
    """The list calls a function that counts; only the first devices fit when they are asked."""
    monkeypatch.setattr(search, "_ASKED", asked)
    calls = []
    connection.connection.driver_connection.create_function("listed", 0, lambda: calls.append(1) or -1)
    first = [number for number, _ in found(connection, DeviceFilter(), fitting)]
    condition = Condition(among(sa.select(sa.func.listed())), of_one=devices.c.id.in_(first))
    connection.execute(device_query([condition], DeviceFilter(limit=5))).all()
    assert len(calls) == listed


NARROWED = {
    "vendor": lambda word: {"vendor_id": int(word, 16)},
    "mode": lambda word: {"modes": (word,)},
    "sync": lambda word: {"sync": word},
    "protocol": lambda word: {"protocol": word},
}
"""The filter that a count beside the list stands for."""


@pytest.mark.parametrize("chosen", [{}, {"maps": ((0x6040, None),)}, {"text": "drive"}, {"needs_dc": True}])
def test_counts_are_those_of_the_lists_that_they_lead_to(library_db, connection, chosen):
    listing = list_devices(connection, DeviceFilter(**chosen, limit=1), 0)
    assert listing.total == len(find_devices(connection, DeviceFilter(**chosen)))
    for name, narrowed in NARROWED.items():
        for word, _, count in listing.facets[name]:
            assert count == len(find_devices(connection, DeviceFilter(**chosen | narrowed(word)))), word
    assert sum(value.device_count for value in listing.facets["vendor"]) == listing.total > 0
