"""Canned queries answer a question as ``esicatalog devices`` does, with and without hidden revisions."""

from pathlib import Path
from typing import Any

import pytest
import yaml
from snippets import device, dictionary, esi
from test_search import catalog_of
from web_client import client

from esicatalog import Catalog
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
