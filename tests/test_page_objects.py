"""The objects on the pages: those of the device and those that plugged modules bring, at their indices in the slot."""

from pathlib import Path

import pytest
from lxml import html
from snippets import device, dictionary, esi
from test_search import catalog_of
from web_client import client

PATH = "/-/esi/device/0xe5c/0x1/0x1"
PART = {"X-Esicatalog-Part": "objects"}
"""What pages.js asks with."""

_TYPES = "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"


def _object(index: str, name: str, depend: str = "") -> str:
    return f"<Object><Index {depend}>{index}</Index><Name>{name}</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"


def _module(ident: str, *objects: str) -> str:
    return f"<Module><Type ModuleIdent='{ident}'>M{ident[-2:]}</Type>{dictionary(_TYPES, ''.join(objects))}</Module>"


@pytest.fixture(scope="module")
def modular_db(tmp_path_factory) -> Path:
    """Two slots 0x800 apart with a drive in each by default, and another module that fits both."""
    slots = (
        "<Slots SlotIndexIncrement='#x800'><Slot MinInstances='2' MaxInstances='2'><Name>Axis</Name>"
        "<ModuleIdent Default='1'>#x10</ModuleIdent><ModuleIdent>#x20</ModuleIdent></Slot></Slots>"
    )
    follows = "DependOnSlot='1'"
    drive = _module("#x10", _object("#x60FF", "Target velocity", follows), _object("#x2100", "Of all axes"))
    other = _module("#x20", _object("#x6040", "Controlword", follows), _object("#xFF00", "Far up", follows))
    own = dictionary(_TYPES, _object("#x1000", "Device type"))
    folder = tmp_path_factory.mktemp("modular")
    return catalog_of(folder, esi(device(own + slots), drive + other + _module("#x30")))


async def _listed(db: Path, query: str = "", status: int = 200) -> tuple[list[str], str]:
    """The lines of the objects, and the whole text."""
    answer = await (await client(db)).get(f"{PATH}/objects{query}", headers=PART)
    assert answer.status_code == status
    tree = html.fromstring(answer.text)
    lines = [" ".join(item.text_content().split()) for item in tree.cssselect("details[data-object] > summary")]
    return lines, " ".join(tree.text_content().split())


async def test_objects_of_plugged_modules_are_listed_at_their_indices_in_the_slot(modular_db):
    """0x60FF + 1 x 0x800 = 0x68FF in slot 1; what does not depend on the slot stays (ESI-FACTS 12)."""
    lines, text = await _listed(modular_db)
    assert lines == [
        "0x1000 Device type UINT",
        "0x60FF Target velocity UINT module 0x10 in slot 0",
        "0x2100 Of all axes UINT module 0x10 in slot 0",
        "0x68FF Target velocity UINT module 0x10 in slot 1",
        "0x2100 Of all axes UINT module 0x10 in slot 1",
    ]
    assert "1 module that is not plugged would bring objects too" in text


async def test_objects_are_those_of_the_chosen_modules(modular_db):
    """0xFF00 + 0x800 leaves 16 bits: it stays, and that is said."""
    lines, text = await _listed(modular_db, "?module=1=0x20")
    assert lines[3:] == [
        "0x6840 Controlword UINT module 0x20 in slot 1",
        "0xFF00 Far up UINT module 0x20 in slot 1",
    ]
    assert "module 0x20 in slot 1: object 0xFF00 would become 0x10700 in slot 1; left unshifted" in text
    assert "not plugged" not in text


async def test_what_is_no_module_of_the_slot_is_refused(modular_db):
    answer = await (await client(modular_db)).get(f"{PATH}/objects?module=1=0x99")
    assert (answer.status_code, "module 0x99 does not fit slot 1" in answer.text) == (400, True)


@pytest.mark.parametrize(
    ("query", "words"),
    [
        ("", "5 objects, 4 of them of plugged modules; 1 module more would bring objects"),
        ("?module=1=0x20", "5 objects, 4 of them of plugged modules"),
    ],
)
async def test_the_device_page_counts_objects_of_modules_and_asks_for_them(modular_db, query, words):
    tree = html.fromstring((await (await client(modular_db)).get(f"{PATH}{query}")).text)
    (holder,) = tree.cssselect("details[data-src]")
    assert " ".join(holder.cssselect("summary")[0].text_content().split()) == words
    assert holder.get("data-src") == f"{PATH}/objects{query.replace('1=', '1%3D')}"


async def test_a_device_of_which_only_modules_have_objects_says_so(tmp_path):
    """Nothing is plugged into a slot that may stay empty."""
    slots = (
        "<Slots><Slot MinInstances='0' MaxInstances='1'><Name>S</Name><ModuleIdent>#x10</ModuleIdent></Slot></Slots>"
    )
    db = catalog_of(tmp_path, esi(device(slots), _module("#x10", _object("#x6040", "Controlword"))))
    tree = html.fromstring((await (await client(db)).get(PATH)).text)
    (summary,) = tree.cssselect("section[aria-labelledby=objects] summary")
    assert summary.text_content() == "0 objects; 1 module more would bring objects"
    lines, text = await _listed(db)
    assert (lines, "1 module that is not plugged would bring objects too" in text) == ([], True)


async def test_what_has_no_index_is_not_shown_as_that_of_index_0(tmp_path):
    """An Index that is missing or cannot be read is no 0x0000."""
    objects = "<Object><Name>None</Name></Object>" + _object("#xZZ", "Bad") + _object("0", "Zero")
    content = (
        dictionary(_TYPES, objects)
        + "<Sm ControlByte='#x20'>Inputs</Sm><TxPdo Fixed='1' Sm='0'><Name>P</Name><Entry><Index>#x6000</Index>"
        + "<SubIndex>1</SubIndex><BitLen>8</BitLen></Entry></TxPdo><Slots><Slot MinInstances='0' MaxInstances='1'>"
        + "<Name>S</Name><ModuleClass><Class>C</Class></ModuleClass></Slot></Slots>"
    )
    db = catalog_of(tmp_path, esi(device(content), "<Module><Type ModuleClass='C'>M</Type><Name>m</Name></Module>"))
    lines, _ = await _listed(db)
    assert lines == ["without index None", "without index Bad UINT", "0x0000 Zero UINT"]
    tree = html.fromstring((await (await client(db)).get(PATH)).text)
    assert [cell.text for cell in tree.cssselect("section[aria-labelledby=image] td:last-child code")] == [
        "without index"
    ]
    summaries = [" ".join(e.text_content().split()) for e in tree.cssselect("section[aria-labelledby=pdos] summary")]
    assert summaries[0].startswith("TxPdo without index P")
    assert summaries[1].startswith("Module without ident")


_OPERATION_MODES = (
    "<DataType><Name>DT0802EN04</Name><BaseType>USINT</BaseType><BitSize>8</BitSize>"
    "<EnumInfo><Text>Automatic</Text><Enum>0</Enum></EnumInfo>"
    "<EnumInfo><Text>Velocity direct</Text><Enum>1</Enum></EnumInfo></DataType>"
)


def _member(subindex: int, name: str, type_name: str, bit_offset: int) -> str:
    return (
        f"<SubItem><SubIdx>{subindex}</SubIdx><Name>{name}</Name><Type>{type_name}</Type><BitSize>8</BitSize>"
        f"<BitOffs>{bit_offset}</BitOffs></SubItem>"
    )


async def test_meanings_of_the_values_of_members_are_told(tmp_path):
    """Most listed values are those of members of records; a type that two members have lists its values once."""
    types = (
        _OPERATION_MODES
        + "<DataType><Name>DT8012</Name><BitSize>40</BitSize>"
        + _member(1, "Operation mode", "DT0802EN04", 16)
        + _member(2, "Fallback mode", "DT0802EN04", 24)
        + _member(3, "Other", "USINT", 32)
        + "</DataType>"
    )
    values = "".join(
        f"<SubItem><Name>{name}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>"
        for name, data in (("Operation mode", "00"), ("Fallback mode", "07"), ("Other", "01"))
    )
    objects = (
        "<Object><Index>#x8012</Index><Name>Settings</Name><Type>DT8012</Type><BitSize>40</BitSize>"
        f"<Info>{values}</Info></Object>"
        "<Object><Index>#x2000</Index><Name>Alone</Name><Type>DT0802EN04</Type><BitSize>8</BitSize>"
        "<Info><DefaultData>01</DefaultData></Info></Object>"
    )
    db = catalog_of(tmp_path, esi(device(dictionary(types, objects))))
    answer = await (await client(db)).get(f"{PATH}/objects", headers=PART)
    record, alone = html.fromstring(answer.text).cssselect("details[data-object]")
    assert [[cell.text_content() for cell in row.cssselect("td")[:7:6]] for row in record.cssselect("tbody tr")] == [
        ["1", "0 = Automatic"],
        ["2", "7"],
        ["3", "1"],
    ]
    assert [item.text_content() for item in record.cssselect("p")] == ["DT0802EN04: 0 = Automatic; 1 = Velocity direct"]
    assert alone.cssselect("td")[6].text_content() == "1 = Velocity direct"
    assert [item.text_content() for item in alone.cssselect("p")] == ["DT0802EN04: 0 = Automatic; 1 = Velocity direct"]


async def test_objects_that_yield_to_those_of_modules_are_left_out(tmp_path):
    """OverwrittenByModule (ESI-FACTS 12): 0x6000 + 1 x 16 is 0x6010 in slot 1; nobody brings 0x7000 or, marked, 0x6020.

    What bears no mark stays beside the module's.
    """
    marked = "<Object><Index OverwrittenByModule='1'>{}</Index><Name>Of the device</Name><Type>UINT</Type></Object>"
    own = "".join(map(marked.format, ("#x6000", "#x6010", "#x6020"))) + _object("#x7000", "Of the device")
    slots = (
        "<Slots SlotIndexIncrement='16'><Slot MinInstances='2' MaxInstances='2'><Name>S</Name>"
        "<ModuleIdent Default='1'>#x10</ModuleIdent></Slot></Slots>"
    )
    module = _module("#x10", _object("#x6000", "Of the module", "DependOnSlot='1'"), _object("#x7000", "Of the module"))
    db = catalog_of(tmp_path, esi(device(dictionary(_TYPES, own) + slots), module))
    lines, _ = await _listed(db)
    assert lines == [
        "0x6020 Of the device UINT",
        "0x7000 Of the device UINT",
        "0x6000 Of the module UINT module 0x10 in slot 0",
        "0x7000 Of the module UINT module 0x10 in slot 0",
        "0x6010 Of the module UINT module 0x10 in slot 1",
        "0x7000 Of the module UINT module 0x10 in slot 1",
    ]
    tree = html.fromstring((await (await client(db)).get(PATH)).text)
    (summary,) = tree.cssselect("section[aria-labelledby=objects] summary")
    assert summary.text_content() == "6 objects, 4 of them of plugged modules"
