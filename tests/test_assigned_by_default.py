"""What is assigned by default is told alike everywhere: it is what the default process image contains.

ESI-FACTS 0.5: a PDO with Sm, unless the default OpMode lists PDOs for that SyncManager, then those. ESI-FACTS 18: no
virtual PDOs, and of two that exclude each other the first.
"""

from pathlib import Path

import pytest
from snippets import device, esi, pdo, read, rows
from test_cli import run
from test_pages import page, texts
from test_search import catalog_of
from web_client import client

from esicatalog import Catalog
from esicatalog.model.drive_modes import drive_modes

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"
ON_SM2 = 'Sm="2"'
LISTS = "<Dc><OpMode><Name>{}</Name><AssignActivate>#x300</AssignActivate><Sm No='2'><Pdo>{}</Pdo></Sm></OpMode></Dc>"


def setpoint(index: str, attributes: str = "", slot: str = "") -> str:
    """An RxPDO that maps a controlword and the setpoint of CSV."""
    entries = "".join(
        f"<Entry><Index {slot}>#x{entry}</Index><SubIndex>0</SubIndex><BitLen>{bits}</BitLen></Entry>"
        for entry, bits in (("6040", 16), ("60FF", 32))
    )
    return f"<RxPdo {attributes}><Index {slot}>#x{index}</Index><Name>R</Name>{entries}</RxPdo>"


CONTENTS = {
    "the OpMode's list wins": SMS
    + setpoint("1600", ON_SM2)
    + setpoint("1601")
    + setpoint("1602", ON_SM2)
    + LISTS.format("DC", "#x1601"),
    "virtual": SMS + setpoint("1600", f'{ON_SM2} Virtual="1"') + setpoint("1601", ON_SM2),
    "excluded": SMS
    + pdo("RxPdo", "#x1602", 8, attributes=ON_SM2, extra="<Exclude>#x1600</Exclude>")
    + setpoint("1600", ON_SM2)
    + setpoint("1601", ON_SM2),
}
"""Of 0x1600 and 0x1601, which both map 0x60FF, each time 0x1601 is assigned."""


def assigned_in_sheet(sheet: str, title: str) -> dict[str, str]:
    """What a table of PDOs says of each."""
    rows = map(str.split, sheet.partition(title)[2].splitlines())
    return {cells[1]: cells[2] for cells in rows if cells[:1] == ["RxPdo"]}


@pytest.fixture(scope="module")
def db(tmp_path_factory) -> Path:
    text = "".join(
        device(content, product=f"#x{number}", type_text=name)
        for number, (name, content) in enumerate(CONTENTS.items())
    )
    return catalog_of(tmp_path_factory.mktemp("assigned"), esi(text))


@pytest.mark.parametrize("product", range(len(CONTENTS)), ids=list(CONTENTS))
async def test_every_answer_tells_the_same(db, product):
    identity = f"0xe5c:{product}:1"
    with Catalog.open(db) as catalog:
        (found,) = catalog.devices(product_code=product, maps=((0x60FF, None),))
    assert found.evidence[:2] == (
        "0x60FF:00, 32 bit, in RxPdo 0x1601 (default on SM2)",
        "0x60FF:00, 32 bit, in RxPdo 0x1600 (not assigned by default)",
    )

    sheet = assigned_in_sheet(run("show", identity, db=db).stdout, "PDOs of the device")
    assert (sheet["0x1600"], sheet["0x1601"]) == ("no", "SM2")

    summaries = texts(await page(db, f"/-/esi/device/0xe5c/{product}/1"), "#pdos ~ details summary")
    told = {text.split()[1]: "SM2 by default" in text for text in summaries}
    assert (told["0x1600"], told["0x1601"]) == (False, True)

    asked = {"index": "0x60FF", "subindex": "", "include_hidden": "", "_shape": "array"}
    mapping = (await (await client(db)).get("/catalog/who_maps_an_object.json", params=asked)).json()
    sms = {row["pdo"]: row["sm"] for row in mapping if row["product_code_hex"] == f"0x{product:08x}"}
    assert (sms["0x1600"], sms["0x1601"]) == (None, 2)


def test_the_recipe_names_the_assigned_pdo(db):
    """Of the first device, whose OpMode lists 0x1601."""
    query = "SELECT rx_pdo_index, rx_pdo_is_default, recipe FROM device_drive_modes WHERE product_code = 0 AND mode = ?"
    ((index, is_default, recipe),) = rows(db, query, "CSV")
    assert (index, is_default) == (0x1601, 1)
    assert "not assigned" not in recipe


def modular(lists: str, pdos: str) -> str:
    slots = (
        '<Slots SlotPdoIncrement="16" SlotIndexIncrement="#x800">'
        + '<Slot MinInstances="0" MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot>' * 2
        + "</Slots>"
    )
    module = (
        "<Module><Type ModuleIdent='1'>M</Type><Name>M</Name>"
        + pdos
        + "<Profile><ProfileNo>402</ProfileNo></Profile></Module>"
    )
    return esi(device(SMS + LISTS.format("DC", lists) + slots), module)


BY_SLOT = 'DependOnSlot="1"'


def test_the_recipe_of_a_module_tells_what_is_assigned_with_it_plugged():
    """The list names 0x1611, what 0x1601 of the module becomes in slot 1, and nothing that it has in slot 0."""
    text = modular("#x1611", setpoint("1600", ON_SM2, BY_SLOT) + setpoint("1601", "", BY_SLOT))
    (info,) = read(text).document.infos
    found = {item.axis: item for item in drive_modes(info.devices[0], info.modules).verdicts if item.mode == "CSV"}
    assert (found[0].rx_pdo_index, found[0].rx_pdo_is_default) == (0x1600, False)
    assert (found[1].rx_pdo_index, found[1].rx_pdo_is_default) == (0x1611, True)


async def test_virtual_pdos_of_modules_are_never_assigned(tmp_path):
    text = modular("#x1700", setpoint("1600", f'{ON_SM2} Virtual="1"') + setpoint("1601", ON_SM2) + setpoint("1602"))
    db = catalog_of(tmp_path, text)
    with Catalog.open(db) as catalog:
        (found,) = catalog.devices(maps=((0x60FF, None),))
    assert found.evidence == (
        "0x60FF:00, 32 bit, in RxPdo 0x1601 of module 0x1 (on SM2 when plugged)",
        "0x60FF:00, 32 bit, in RxPdo 0x1600 of module 0x1 (not assigned by default)",
        "0x60FF:00, 32 bit, in RxPdo 0x1602 of module 0x1 (not assigned by default)",
    )
    sheet = assigned_in_sheet(run("show", "0xe5c:1:1", db=db).stdout, "PDOs of the module")
    assert sheet == {"0x1600": "no", "0x1601": "SM2", "0x1602": "no"}
    shown = texts(await page(db, "/-/esi/device/0xe5c/1/1"), "#pdos ~ details details summary .small")
    assert [text.split(", ")[1] for text in shown] == [
        "not assigned by default (Sm 2 in the file)",
        "SM2 when plugged",
        "not assigned by default",
    ]
