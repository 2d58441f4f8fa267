"""Cells of the tables: whatever names a device, an object or a module is shown in hex, and leads on where it can."""

import re
from pathlib import Path
from urllib.parse import quote

import pytest
from lxml import html
from snippets import device, esi, one, rows
from test_search import catalog_of
from web_client import client

from esicatalog.web.cells import DEVICE_COLUMNS, HEX_DIGITS

_READ_IN_HEX = re.compile(
    r"(?:\w+_)?(?:ident|index|vendor_id|product_code|revision_no|serial_no|address|index_inc|(?:index|pdo)_increment)"
)
_DEVICE_KEY = re.compile(r"(?:\w+_)?device_id|previous_id")


@pytest.fixture(scope="module")
def modular_db(tmp_path_factory) -> Path:
    slot = (
        "<Slots SlotIndexIncrement='#x800'><Slot MaxInstances='1' Default='#x119800' Fallback='#x219800'><Name>S</Name>"
        "<ModuleIdent>#x119800</ModuleIdent><ModuleClass><Class>C</Class><VendorId>#xE5C</VendorId></ModuleClass>"
        "</Slot></Slots><Sm ControlByte='#x20'>Inputs</Sm><TxPdo Fixed='1' Sm='0'><Index>#x1A00</Index><Name>P</Name>"
        "<Entry><Index>#x6000</Index><SubIndex>1</SubIndex><BitLen>8</BitLen></Entry></TxPdo>"
    )
    module = "<Module><Type ModuleIdent='#x119800'>M</Type></Module>"
    return catalog_of(tmp_path_factory.mktemp("modular"), esi(device(slot) + device(slot, product="#x2"), module))


def test_all_columns_of_identities_and_indices_are_shown_in_hex(modular_db):
    columns = {
        (table, name, kind)
        for table, is_view in rows(modular_db, "SELECT name, type = 'view' FROM sqlite_master WHERE type <> 'index'")
        for name, kind in rows(modular_db, "SELECT name, type FROM pragma_table_info(?)", table)
    }
    names = {name for _, name, _ in columns}
    spelled_in_views = {name.removesuffix("_hex") for name in names if name.endswith("_hex")}
    numbers = {name for _, name, kind in columns if kind == "INTEGER"}
    wanted = {name for name in numbers if _READ_IN_HEX.fullmatch(name) or name in spelled_in_views}
    assert {"default_ident", "class_vendor_id", "slot_pdo_increment", "unit"} <= wanted
    assert wanted - HEX_DIGITS.keys() == set()
    assert HEX_DIGITS.keys() <= numbers
    assert {name for name in names if _DEVICE_KEY.fullmatch(name)} == set(DEVICE_COLUMNS)


@pytest.mark.parametrize(
    ("table", "column", "shown"),
    [
        ("slots", "default_ident", "0x00119800"),
        ("slots", "fallback_ident", "0x00219800"),
        ("slot_module_classes", "class_vendor_id", "0x00000e5c"),
        ("devices", "slot_index_increment", "0x0800"),
    ],
)
async def test_hex_is_shown_and_taken_in_filters(modular_db, table, column, shown):
    tree = html.fromstring((await (await client(modular_db)).get(f"/catalog/{table}?{column}={shown}")).text)
    assert [cell.text_content() for cell in tree.cssselect(f"td.col-{column} span")] == [shown, shown]


async def test_the_device_of_the_same_layout_is_linked(modular_db):
    tree = html.fromstring((await (await client(modular_db)).get("/catalog/same_process_image_layout")).text)
    addresses = [link.get("href") for link in tree.cssselect("td.col-other_device_id a")]
    other = one(modular_db, "SELECT id FROM devices WHERE product_code = 2")
    assert f"/-/esi/row/{other}" in addresses
    assert len(addresses) == 2


@pytest.mark.parametrize("given", ["0X60ff", "0x60FF", "#x60FF", "24831", "0x060FF"])
async def test_columns_of_hex_text_are_filtered_in_any_notation(data_db, given):
    """SQL compares texts, and views spell them ``0x60ff``."""
    count = one(data_db, "SELECT count(*) FROM device_objects WHERE object_index = 0x60FF")
    query = f"object_index_hex={quote(given)}&_shape=array&_size=max"
    answer = await (await client(data_db)).get(f"/catalog/device_objects.json?{query}")
    assert len(answer.json()) == count > 0
