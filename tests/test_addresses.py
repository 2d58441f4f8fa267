"""Addresses below /-/esi/ that name no page or no description: what they answer, and where they lead on."""

import pytest
from snippets import device, esi
from test_cli import run
from test_pages import EYOU, page, texts
from test_search import catalog_of
from web_client import client, new_client

SERVO = "/-/esi/device/0x1097/0x2406"
"""A product of which the catalog describes revision 0x8f."""


@pytest.mark.parametrize(
    ("path", "leads_to"),
    [
        ("/-/esi/device/0xe5c/0x0d080808", "/-/esi/device/0xe5c/0x0d080808/latest"),
        ("/-/esi/device/0xe5c/0x0d080808/", "/-/esi/device/0xe5c/0x0d080808/latest"),
        ("/-/esi/device/0xe5c/0x0d080808.json", "/-/esi/device/0xe5c/0x0d080808/latest.json"),
        ("/-/esi/device/%23xe5c/218630152", "/-/esi/device/%23xe5c/218630152/latest"),
        (f"{SERVO}?module=0%3D0x219800", f"{SERVO}/latest?module=0%3D0x219800"),
    ],
)
async def test_a_product_leads_to_its_latest_revision(data_db, path, leads_to):
    web = await client(data_db)
    answer = await web.get(path, follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (302, leads_to)
    latest = await web.get(leads_to)
    assert latest.status_code == 200
    assert ("0x00110000" in latest.text) == ("0x1097" not in path)


async def test_scripts_of_other_sites_follow_to_the_latest_revision(data_db):
    web = await new_client(data_db, cors=True)
    for path, status in ((f"{SERVO}.json", 302), ("/-/esi/nosuch.json", 404)):
        answer = await web.get(path, follow_redirects=False)
        assert (answer.status_code, answer.headers["access-control-allow-origin"]) == (status, "*")


@pytest.mark.parametrize("path", ["nosuch", "device/0x2", "device/0x1097/0x2406/0x8f/nosuch", "scan/x", "row/999999"])
async def test_an_unknown_address_is_answered_by_a_page_of_our_own(data_db, path):
    tree = await page(data_db, f"/-/esi/{path}", 404)
    assert texts(tree, "h1") == ["Not found"]
    assert path in " ".join(texts(tree, "[role=alert]")) or path == "row/999999"
    assert "/-/esi/scan" in tree.xpath("//nav//a/@href")


async def test_an_unknown_address_for_json_is_answered_by_json(data_db):
    for method in ("get", "post"):
        answer = await getattr(await client(data_db), method)("/-/esi/nosuch.json")
        assert (answer.status_code, answer.json()) == (
            404,
            {"error": "there is no /-/esi/nosuch.json; what there is: /-/esi/openapi.json"},
        )


async def test_what_people_write_in_an_address_stays_text(data_db):
    answer = await (await client(data_db)).get("/-/esi/%3Cscript%3Ealert(1)%3C/script%3E")
    assert (answer.status_code, "<script>alert" in answer.text) == (404, False)


async def test_a_revision_that_is_not_described_leads_to_the_nearest(data_db):
    tree = await page(data_db, f"{SERVO}/0x90", 404)
    assert texts(tree, "h1") == ["Not described"]
    assert texts(tree, "[role=alert]") == ["0x00001097:0x00002406:0x00000090 is not in the catalog"]
    reason = (await (await client(data_db)).get(f"{SERVO}/0x90.json")).json()["reason"]
    assert reason in texts(tree, "main p")
    assert texts(tree, "h2") == ["Nearest"]
    assert tree.xpath("//ul[@class='nearest']//a/@href") == [EYOU]


async def test_other_revisions_and_other_products_are_named(tmp_path):
    """Asked for revision 3: 2 is nearest, 1 and 9 are others. Asked for product 8: product 7 is nearest."""
    revisions = "".join(device(product="#x7", revision=revision) for revision in ("#x1", "#x2", "#x9"))
    db = catalog_of(tmp_path, esi(revisions))
    tree = await page(db, "/-/esi/device/0xe5c/7/3", 404)
    assert texts(tree, "h2") == ["Nearest", "Other revisions"]
    links = tree.xpath("//ul[@class='nearest']//a/@href")
    assert links[0] == "/-/esi/device/0xe5c/0x7/0x2"
    assert {*links[1:]} == {"/-/esi/device/0xe5c/0x7/0x1", "/-/esi/device/0xe5c/0x7/0x9"}
    tree = await page(db, "/-/esi/device/0xe5c/8/3", 404)
    assert texts(tree, "h2") == ["Products of this vendor with the nearest codes"]
    assert len(tree.xpath("//ul[@class='nearest']//a/@href")) == 3


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ("0x8f@9", "0x00001097:0x00002406:0x0000008f has no variant 9; it has one description only"),
        ("-", "0x00001097:0x00002406:- is not in the catalog"),
    ],
)
async def test_a_description_that_identify_cannot_ask_for(data_db, asked, words):
    """Identify would say that the catalog describes exactly this revision."""
    tree = await page(data_db, f"{SERVO}/{asked}", 404)
    assert texts(tree, "main p")[0] == words
    assert "exactly" not in tree.text_content()
    assert tree.xpath("//ul[@class='nearest']//a/@href") == [EYOU]


async def test_a_comparison_goes_on_with_the_nearest(data_db):
    tree = await page(data_db, "/-/esi/compare?a=0x1097:0x2406:0x90&b=0xe5c:0x0d080808", 404)
    assert texts(tree, "[role=alert]") == ["0x00001097:0x00002406:0x00000090 is not in the catalog"]
    (href,) = tree.xpath("//ul[@class='nearest']//a/@href")
    compared = await page(data_db, href)
    assert texts(compared, "tr:nth-child(2) code") == [
        "0x00001097:0x00002406:0x0000008f",
        "0x00000e5c:0x0d080808:0x00110000",
    ]


async def test_half_a_comparison_asks_for_the_other(data_db):
    tree = await page(data_db, "/-/esi/compare?a=0x1097:0x2406")
    assert texts(tree, "[role=status]") == ["Both descriptions are needed."]
    assert texts(await page(data_db, "/-/esi/compare"), "[role=status]") == []


async def test_commands_are_named_at_the_shell_alone(data_db):
    done = run("show", "0x1097:0x2406:0x90", db=data_db)
    assert done.stderr == (
        "esicatalog: 0x00001097:0x00002406:0x00000090 is not in the catalog; "
        "see: esicatalog identify 0x1097 0x2406 0x90\n"
    )
    answer = await (await client(data_db)).get(f"{SERVO}/0x90/export/igh")
    assert answer.json() == {"error": "0x00001097:0x00002406:0x00000090 is not in the catalog"}


@pytest.mark.parametrize("path", ["/-/esi/scan", "/-/esi/openapi.json"])
async def test_where_nothing_is_asked_parameters_are_refused(data_db, path):
    refused = await (await client(data_db)).get(f"{path}?foo=1")
    assert (refused.status_code, "unknown parameter" in refused.text, "there are none" in refused.text) == (
        400,
        True,
        True,
    )


async def test_the_page_of_all_has_no_limit(data_db):
    tree = await page(data_db, "/-/esi/?limit=2&text=servo", 400)
    assert texts(tree, "[role=alert]") == ["this page shows all that is found, 50 at a time; limit is for devices.json"]
    assert not tree.cssselect("input[name=limit]")
    assert texts(await page(data_db, "/-/esi/?limit=&text=servo"), "h2") == ["4 devices"]


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "PATCH", "OPTIONS"])
@pytest.mark.parametrize("path", [f"{EYOU}/export/igh", SERVO, "/-/esi/row/1", f"/-/esi/image/{'0' * 64}"])
async def test_what_is_only_read_takes_no_other_method(data_db, path, method):
    web = await client(data_db)
    refused = await web.request(method, path, follow_redirects=False)
    assert (refused.status_code, refused.headers["allow"]) == (405, "GET")
    assert (await web.request("HEAD", path, follow_redirects=False)).status_code in (200, 302, 404)


async def test_a_page_number_that_is_left_empty_is_none(data_db):
    assert texts(await page(data_db, "/-/esi/?page=&text=servo"), "h2") == ["4 devices"]


@pytest.mark.parametrize("path", ["compare?a=0xe5c:1&b=0xe5c:2&c=9", "?foo=1"])
async def test_pages_refuse_what_they_do_not_read(data_db, path):
    tree = await page(data_db, f"/-/esi/{path}", 400)
    assert texts(tree, "[role=alert]")[0].startswith("unknown ")


async def test_a_single_parameter_is_told_as_one(data_db):
    tree = await page(data_db, f"{EYOU}?variant=2", 400)
    assert texts(tree, "[role=alert]") == ["unknown parameter 'variant'; there is only module"]


@pytest.mark.parametrize(
    ("query", "status", "words"),
    [
        ("mode=XYZ&text=servo", 400, "say one of"),
        ("like=0x1:0x2&text=servo", 404, "0x00000001:0x00000002 is not in the catalog"),
        ("page=x&text=servo", 400, "page 'x' is not a number"),
        ("page=0&text=servo", 400, "pages count from 1"),
    ],
)
async def test_a_search_that_is_refused_keeps_its_form_and_counts_nothing(data_db, query, status, words):
    tree = await page(data_db, f"/-/esi/?{query}", status)
    assert words in texts(tree, "[role=alert]")[0]
    assert tree.cssselect("input[name=text]")[0].get("value") == "servo"
    assert texts(tree, "h2") == []
    assert not tree.cssselect(".doors a")
