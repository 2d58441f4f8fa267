"""Canned queries answer a question as ``esicatalog devices`` does, with and without hidden revisions."""

from pathlib import Path
from typing import Any

import pytest
import yaml
from lxml import html
from snippets import device, dictionary, esi
from test_search import catalog_of
from web_client import client

from esicatalog import Catalog
from esicatalog.catalog.filter_texts import filter_of_texts
from esicatalog.identity import Identity
from esicatalog.resources import resource

_UDINT = "<DataType><Name>UDINT</Name><BitSize>32</BitSize></DataType>"
# Supported modes 0x180, as sent: bit 7 is CSP, bit 8 is CSV.
_MODES = (
    "<Object><Index>#x6502</Index><Name>Supported</Name><Type>UDINT</Type><BitSize>32</BitSize>"
    "<Info><DefaultData>80010000</DefaultData></Info></Object>"
)
_DRIVE = (
    dictionary(_UDINT, _MODES)
    + "<Sm ControlByte='#x64'>Outputs</Sm><RxPdo Sm='0' SafetyPdoType='FSoESlave'><Index>#x1600</Index><Name>P</Name>"
    + "<Entry><Index>#x60FF</Index><SubIndex>0</SubIndex><BitLen>32</BitLen></Entry></RxPdo>"
    + "<Mailbox><CoE/><FoE/></Mailbox>"
    + "<Dc><OpMode><Name>DC</Name><AssignActivate>#x700</AssignActivate></OpMode></Dc>"
)
DRIVES = esi(
    device(_DRIVE, revision="#x1")
    + device("<HideType RevisionNo='#x1'/>" + _DRIVE, revision="#x2")
    + device(_DRIVE, product="#x2")
)
"""Three drives of the same content; the second hides the first."""

ASKED: dict[str, tuple[dict[str, str], dict[str, Any]]] = {
    "find_a_device": ({"text": "test vendor"}, {"text": "test vendor"}),
    "devices_by_drive_profile": ({"profile": "402"}, {"profile_no": 402}),
    "devices_with_dc_sync1": ({"vendor": ""}, {"sync": "sync1"}),
    "drives_with_a_mode": ({"mode": "CSV", "strict": ""}, {"modes": ("CSV",)}),
    "csv_drives_with_sync1": ({}, {"modes": ("CSV",), "sync": "sync1"}),
    "csp_drives_with_fsoe": ({}, {"modes": ("CSP",), "protocol": "fsoe"}),
    "devices_by_mailbox_protocol": ({"protocol": "foe"}, {"protocol": "foe"}),
    "who_maps_an_object": ({"index": "0x60FF", "subindex": ""}, {"maps": ((0x60FF, None),)}),
    "devices_of_the_same_layout": (
        {"vendor": "0xE5C", "product": "2", "revision": "1"},
        {"like": Identity(0xE5C, 2, 1)},
    ),
}
"""Queries that ask for devices by what they can do: parameters, and the filter that asks the same."""


async def test_no_revision_supersedes_itself(tmp_path):
    """The second hides the first and, as it says, itself."""
    hiding = "<HideType RevisionNo='#x1'/><HideType RevisionNo='#x2'/>"
    db = catalog_of(tmp_path, esi(device(revision="#x1") + device(hiding, revision="#x2")))
    query = "/catalog/revisions_of_a_product.json"
    answer = await (await client(db)).get(query, params={"vendor": "", "product": "1", "_shape": "array"})
    found = [(row["revision_no_hex"], row["hidden"], row["superseded_by"]) for row in answer.json()]
    assert found == [("0x00000001", 1, "0x00000002"), ("0x00000002", 0, None)]


@pytest.mark.parametrize("codes", ['RevisionNo="#x9"', ""])
async def test_what_has_no_product_code_can_hide_a_revision(tmp_path, codes):
    """What is hidden names by which revision; - where that is not given."""
    hiding = device("<HideType ProductCode='#x1' RevisionNo='#x1'/>", product="").replace(
        "<Type ", f"<Type {codes} ", 1
    )
    db = catalog_of(tmp_path, esi(device() + hiding))
    query = "/catalog/revisions_of_a_product.json"
    answer = await (await client(db)).get(query, params={"vendor": "", "product": "1", "_shape": "array"})
    found = [(row["hidden"], row["superseded_by"]) for row in answer.json()]
    assert found == [(1, "0x00000009" if codes else "-")]


async def test_a_vendor_or_a_part_of_its_name_finds_what_the_command_finds(tmp_path):
    """The same id under two names, of which one is shown: both are looked at, and no letter stands for others."""
    spelled = [f"<Id>#xE5C</Id><Name>{name}</Name>" for name in ("Test vendor", "Test vendor", "Other name")]
    documents = [esi(device(_DRIVE, product=f"#x{n}"), vendor=vendor) for n, vendor in enumerate(spelled, 1)]
    db = catalog_of(tmp_path, *documents)
    web = await client(db)
    for part in ("_", "%", "TEST", "other", "nobody", "0xE5C", "#xe5c", "3676", "0x3676", "3S"):
        asked = {"vendor": part, "include_hidden": "", "_shape": "array"}
        answer = await web.get("/catalog/devices_with_dc_sync1.json", params=asked)
        with Catalog.open(db) as catalog:
            wanted = filter_of_texts({"vendor": [part], "sync": ["sync1"]})
            listed = [f"0x{found.product_code:08x}" for found in catalog.find(wanted)]
        assert [row["product_code_hex"] for row in answer.json()] == listed, part
        assert len(listed) == (3 if part in ("TEST", "other", "0xE5C", "#xe5c", "3676") else 0), part


async def test_a_vendor_that_is_meant_as_a_number_is_refused_when_it_is_none(data_db):
    """A slip (O for 0) is told instead of being looked for among the names."""
    asked = {"vendor": "0x1O97", "include_hidden": ""}
    answer = await (await client(data_db)).get("/catalog/devices_with_dc_sync1.json", params=asked)
    assert (answer.status_code, "0x1O97" in answer.text) == (400, True)


async def test_the_mode_matrix_counts_makers_of_one_vendor_id_apart(tmp_path):
    """As devices and their modes name them: two documents say rt-labs, one kubabuda."""
    spelled = [f"<Id>#xE5C</Id><Name>{name}</Name>" for name in ("rt-labs", "kubabuda", "rt-labs")]
    documents = [esi(device(_DRIVE, product=f"#x{n}"), vendor=vendor) for n, vendor in enumerate(spelled, 1)]
    web = await client(catalog_of(tmp_path, *documents))
    matrix = (await web.get("/catalog/drive_modes_of_each_vendor.json", params={"_shape": "array"})).json()
    assert [(row["vendor"], row["drives"], row["csv"]) for row in matrix] == [("rt-labs", 2, 2), ("kubabuda", 1, 1)]
    listed = (await web.get("/catalog/drives_with_a_mode.json", params={"_shape": "array"})).json()
    assert sorted(row["vendor"] for row in listed) == ["kubabuda", "rt-labs", "rt-labs"]


@pytest.fixture(scope="module")
def drives_db(tmp_path_factory) -> Path:
    return catalog_of(tmp_path_factory.mktemp("drives"), DRIVES)


@pytest.mark.parametrize("query", ASKED)
@pytest.mark.parametrize(
    ("include_hidden", "expected"),
    [("", [(1, 2), (2, 1)]), ("0", [(1, 2), (2, 1)]), ("1", [(1, 1), (1, 2), (2, 1)])],
)
async def test_hidden_revisions_are_left_out_as_by_the_command(drives_db, query, include_hidden, expected):
    parameters, wanted = ASKED[query]
    asked = {**parameters, "include_hidden": include_hidden, "_shape": "objects"}
    answer = (await (await client(drives_db)).get(f"/catalog/{query}.json", params=asked)).json()
    with Catalog.open(drives_db) as catalog:
        listed = catalog.devices(**wanted, include_hidden=include_hidden == "1")
    others = [numbers for numbers in expected if not ("like" in wanted and numbers == (2, 1))]
    assert [(item.product_code, item.revision_no) for item in listed] == others
    assert [(row["product_code_hex"], row["revision_no_hex"]) for row in answer["rows"]] == [
        (f"0x{product:08x}", f"0x{revision:08x}") for product, revision in others
    ]


@pytest.mark.parametrize(
    ("subindex", "expected"),
    [("", [("0x7000", None), ("0x7000", 0), ("0x7000", 1)]), ("0", [("0x7000", 0)]), ("1", [("0x7000", 1)])],
)
async def test_who_maps_a_subindex_that_cannot_be_read_is_not_known(tmp_path, subindex, expected):
    """The first entry has the SubIndex x1, which may mean any; the second has none, which is 0."""
    entries = "".join(
        f"<Entry><Index>#x7000</Index>{told}<BitLen>8</BitLen></Entry>"
        for told in ("<SubIndex>x1</SubIndex>", "", "<SubIndex>1</SubIndex>")
    )
    db = catalog_of(tmp_path, esi(device(f"<RxPdo><Index>#x1600</Index><Name>P</Name>{entries}</RxPdo>")))
    asked = {"index": "0x7000", "subindex": subindex, "include_hidden": "", "_shape": "array"}
    answer = await (await client(db)).get("/catalog/who_maps_an_object.json", params=asked)
    assert [(row["entry"], row["subindex"]) for row in answer.json()] == expected


def test_queries_about_devices_tell_of_hidden_revisions():
    """Those about revisions, identities, vendors and documents are about all there are, or say so."""
    queries = yaml.safe_load(resource("datasette-metadata.yml").read_text())["databases"]["catalog"]["queries"]
    for name, query in queries.items():
        said = "include_hidden: 1 = also revisions that another description supersedes" in query["description"]
        assert said == ("include_hidden" in query["params"]) == (name in ASKED), name


REFUSED = [
    ("who_maps_an_object", {"index": "60FF"}, "index '60FF' is not a number; write 0x1097, #x1097 or 4247"),
    ("who_maps_an_object", {"index": "0x160FF"}, "index '0x160FF' is larger than 0xffff"),
    ("who_maps_an_object", {"index": "0x9999", "subindex": "11"}, "subindex '11' is ambiguous"),
    ("who_maps_an_object", {"subindex": "0x"}, "subindex '0x' is not a number"),
    ("drives_with_a_mode", {"mode": "XX"}, "mode 'XX': say one of PP, VL"),
    ("drives_with_a_mode", {"mode": "CSV,CSP", "strict": "1"}, "mode 'CSV,CSP': say one of PP, VL"),
    ("drives_with_a_mode", {"strict": "maybe"}, "'maybe' is neither 1 nor 0"),
    ("devices_by_mailbox_protocol", {"protocol": "xyz"}, "protocol 'xyz': say one of coe, eoe"),
    ("devices_by_drive_profile", {"profile": "abc"}, "profile 'abc' is not a number"),
    ("revisions_of_a_product", {"vendor": "x", "product": "1"}, "vendor 'x' is not a number"),
    ("revisions_of_a_product", {"vendor": "", "product": "y"}, "product 'y' is not a number"),
    ("devices_of_the_same_layout", {"vendor": "1", "product": "1", "revision": " "}, "revision ' ' is not a number"),
    (
        "conflicting_descriptions_of_an_identity",
        {"revision": "-1"},
        "revision '-1' is negative; give a number from 0 on",
    ),
    ("problems_of_ingest", {"severity": "F"}, "severity 'F': say one of E, W, I"),
    ("find_a_device", {"text": "nothing like it", "include_hidden": "2"}, "'2' is neither 1 nor 0"),
]


@pytest.mark.parametrize(("query", "parameters", "words"), REFUSED)
async def test_what_cannot_be_read_is_refused_with_words(drives_db, query, parameters, words):
    """Also where nothing would be found: an empty list would say that no device does it."""
    web = await client(drives_db)
    answer = await web.get(f"/catalog/{query}.json", params=parameters)
    assert answer.status_code == 400
    # SQLite writes the quotes of a text in an error twice.
    assert words in answer.json()["error"].replace("''", "'")
    page = await web.get(f"/catalog/{query}", params=parameters)
    assert words in html.fromstring(page.text).text_content().replace("''", "'")


async def test_every_query_refuses_hidden_revisions_that_are_neither_asked_for_nor_not(drives_db):
    for query in ASKED:
        answer = await (await client(drives_db)).get(f"/catalog/{query}.json", params={"include_hidden": "maybe"})
        assert (answer.status_code, "neither 1 nor 0" in answer.json()["error"]) == (400, True), query


async def test_subindices_are_read_as_by_the_command(tmp_path):
    entries = "".join(
        f"<Entry><Index>#x6000</Index><SubIndex>{number}</SubIndex><BitLen>8</BitLen></Entry>" for number in (9, 11, 17)
    )
    db = catalog_of(tmp_path, esi(device(f"<TxPdo><Index>#x1A00</Index><Name>P</Name>{entries}</TxPdo>")))
    web = await client(db)
    for subindex, expected in (("0B", [11]), ("0x0B", [11]), ("9", [9]), ("", [9, 11, 17])):
        asked = {"index": "0x6000", "subindex": subindex, "_shape": "array"}
        answer = await web.get("/catalog/who_maps_an_object.json", params=asked)
        assert [row["subindex"] for row in answer.json()] == expected, subindex
