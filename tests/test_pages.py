"""The pages below /-/esi/: they say what the catalog says, escape what vendors write, and refuse with words."""

import re
from pathlib import Path
from urllib.parse import parse_qsl

import pytest
from lxml import html
from snippets import device, esi, one, pdo, read, rows
from test_cli import run
from test_identify import SLAVES
from test_page_objects import PART
from test_search import catalog_of
from web_client import client

from esicatalog import Catalog
from esicatalog.catalog.filter_texts import PARAMETERS
from esicatalog.identity import parse_identity
from esicatalog.sii.checksum import crc8
from esicatalog.web.cells import stored_filters

HOSTILE = "&lt;script&gt;alert(1)&lt;/script&gt;"
ATTRIBUTE = '"onmouseover=alert(1) x="'
EYOU = "/-/esi/device/0x1097/0x2406/0x8f"
L6N = "/-/esi/device/0x4321/0xe2/0x1"


async def page(db: Path, path: str, status: int = 200):
    response = await (await client(db)).get(path)
    assert response.status_code == status, response.text
    return html.fromstring(response.text)


def texts(tree, path: str) -> list[str]:
    return [" ".join(element.text_content().split()) for element in tree.cssselect(path)]


async def test_home_lists_devices_with_counts(data_db):
    tree = await page(data_db, "/-/esi/")
    assert texts(tree, "h2") == ["5 devices"]
    assert "EYOU_ServoModule_V143" in texts(tree, ".device-head a")
    assert [link for link in texts(tree, "aside a") if link.startswith("CSV")] == ["CSV 3"]


NOT_ON_THE_HOME_PAGE = {"product", "identification", "not-maps", "bits", "limit"}
"""Filters for the address and the command: an identity is a text to search for, a page has its own limit, and the form
stays one that can be taken in at a glance."""


async def test_every_filter_is_on_the_home_page_or_kept_off_it_on_purpose(data_db):
    tree = await page(data_db, "/-/esi/")
    written = {element.get("name") for element in tree.cssselect("form.search [name]")}
    counted = {name for link in tree.cssselect("aside a") for name, _ in parse_qsl(link.get("href").partition("?")[2])}
    assert written | counted == {"vendor", *PARAMETERS} - NOT_ON_THE_HOME_PAGE


@pytest.mark.parametrize(
    ("query", "count"),
    [
        ("text=servo", "4 devices"),
        ("mode=CSV&strict=1", "3 devices"),
        ("strict=1", "5 devices"),
        ("bits=8", "5 devices"),
        ("sync=sync1", "1 device"),
        ("vendor=0x1097", "1 device"),
        ("maps=0x6040:1&include-hidden=1", "2 devices"),
        ("bytes-in=%3C%3D1", "1 device"),
        ("text=nothing-like-it", "0 devices"),
    ],
)
async def test_filters_in_the_address(data_db, query, count):
    assert texts(await page(data_db, f"/-/esi/?{query}"), "h2") == [count]


async def test_a_filter_is_taken_back_by_its_own_link(data_db):
    tree = await page(data_db, "/-/esi/?mode=CSV&sync=sync0")
    (chosen,) = [link for link in tree.cssselect("aside a.chosen") if link.text_content().startswith("CSV")]
    assert chosen.get("href") == "?sync=sync0"


@pytest.mark.parametrize("query", ["mode=XYZ", "bytes-in=lots", "nonsense=1", "maps=zz"])
async def test_a_filter_that_cannot_be_read_is_told(data_db, query):
    tree = await page(data_db, f"/-/esi/?{query}", 400)
    assert len(texts(tree, "[role=alert]")) == 1


async def test_json_and_sql_of_a_search(data_db):
    web = await client(data_db)
    tree = html.fromstring((await web.get("/-/esi/?mode=CSV")).text)
    json_link, sql_link = (link.get("href") for link in tree.cssselect(".doors a"))
    assert len((await web.get(json_link)).json()) == 3
    sql_page = await web.get(sql_link, follow_redirects=True)
    assert sql_page.status_code == 200
    assert "EYOU_ServoModule_V143" in sql_page.text


async def test_devices_json_is_that_of_the_command(data_db):
    web = await client(data_db)
    found = (await web.get("/-/esi/devices.json?mode=CSV&strict=1")).json()
    assert [item["type"] for item in found] == ["ECX-A202", "EYOU_ServoModule_V143", "L6N"]
    too_many = await web.get("/-/esi/devices.json?limit=4294967296")
    assert (too_many.status_code, "is larger than 0xffffffff" in too_many.json()["error"]) == (400, True)
    refused = await web.get("/-/esi/devices.json?mode=XYZ")
    assert (refused.status_code, "say one of" in refused.json()["error"]) == (400, True)


@pytest.mark.parametrize(
    ("query", "option"),
    [
        ("bits=8", ("--bits", "8")),
        ("strict=1", ("--strict",)),
        ("vendor=0xZZ", ("--vendor", "0xZZ")),
    ],
)
async def test_devices_json_refuses_what_the_command_refuses(data_db, query, option):
    refused = await (await client(data_db)).get(f"/-/esi/devices.json?{query}")
    done = run("devices", *option, db=data_db)
    assert (refused.status_code, done.exit_code) == (400, 2)
    assert done.stderr == f"esicatalog: {refused.json()['error']}\n"


async def test_the_json_of_a_page_leaves_out_what_says_nothing_there(data_db):
    """The form sends what is ticked; the page goes on without it, and so does its link."""
    tree = await page(data_db, "/-/esi/?strict=1&bits=8&sync=sync1")
    (link,) = [a for a in tree.xpath("//a/@href") if "devices.json" in a]
    assert link.endswith("devices.json?sync=sync1")
    assert len((await (await client(data_db)).get(link)).json()) == 1


async def test_device_page_and_its_json(data_db):
    web = await client(data_db)
    tree = html.fromstring((await web.get(EYOU)).text)
    assert texts(tree, "h1")[0].startswith("EYOU_ServoModule_V143")
    facts = dict(zip(texts(tree, "dl.facts dt"), texts(tree, "dl.facts dd"), strict=True))
    assert "0x00001097" in facts["vendor"]
    assert "4247" in facts["vendor"]
    assert facts["described in"] == "eyou_servo_module.xml, line 23"
    assert [row.split()[1] for row in texts(tree, "section[aria-labelledby=modes] > div tbody tr")]
    body = (await web.get(f"{EYOU}.json")).json()
    assert body["identity"]["product_code"] == 0x2406
    assert body["device"]["type"] == "EYOU_ServoModule_V143"


async def test_the_module_picker_recomputes_the_image(data_db):
    default = await page(data_db, EYOU)
    chosen = await page(data_db, f"{EYOU}?module=0%3D0x219800")
    names = [texts(tree, "section[aria-labelledby=image] details td:nth-child(5)") for tree in (default, chosen)]
    assert names[0] != names[1]
    assert "with the chosen modules" in texts(chosen, "#image")[0]
    wrong = await page(data_db, f"{EYOU}?module=0%3D0x1", 400)
    assert "does not fit slot 0" in texts(wrong, "[role=alert]")[0]
    assert texts(wrong, "#image") == ["Process image, default"]
    assert not [link for link in wrong.xpath("//a/@href") if "module=" in link]


async def test_an_entry_without_length_has_none_on_its_page(tmp_path):
    entries = pdo("RxPdo", "#x1600", 16, 8, attributes='Sm="0"').replace("<BitLen>16</BitLen>", "")
    tree = await page(catalog_of(tmp_path, esi(device("<Sm>Outputs</Sm>" + entries))), "/-/esi/device/0xe5c/1/1")
    for section in ("image", "pdos"):
        assert texts(tree, f"section[aria-labelledby={section}] td:nth-child(2)") == ["", "8"]


async def test_drawings_hold_every_entry(data_db):
    web = await client(data_db)
    tree = html.fromstring((await web.get(EYOU)).text)
    images = (await web.get(f"{EYOU}.json")).json()["process_image"]
    drawn = [len(drawing.cssselect("g.entry")) for drawing in tree.cssselect("section[aria-labelledby=image] svg")]
    assert drawn == [len(image["entries"]) for image in images if image["entries"]]


async def test_objects_come_on_demand(data_db):
    web = await client(data_db)
    whole = html.fromstring((await web.get(f"{EYOU}/objects")).text)
    assert whole.cssselect("html[lang]")
    part = (await web.get(f"{EYOU}/objects", headers=PART)).text
    assert "<html" not in part
    tree = html.fromstring(part)
    declared = one(data_db, "SELECT count(*) FROM device_objects WHERE vendor_id = 0x1097")
    plugged = one(data_db, "SELECT count(*) FROM module_objects WHERE module_ident = 0x119800")
    assert len(tree.cssselect("details[data-object]")) == declared + plugged
    (modes,) = [item for item in tree.cssselect("details") if item.text_content().strip().startswith("0x6502")]
    assert "256 (0x100)" in modes.text_content()


async def test_caches_keep_the_objects_and_their_page_apart(data_db):
    web = await client(data_db)
    script = PART
    whole, part = [await web.get(f"{EYOU}/objects", headers=headers) for headers in ({}, script)]
    assert all("X-Esicatalog-Part" in answer.headers["vary"] for answer in (whole, part))
    assert whole.headers["etag"] != part.headers["etag"]
    for headers, kept, status in ((script, part, 304), (script, whole, 200), ({}, whole, 304), ({}, part, 200)):
        again = await web.get(f"{EYOU}/objects", headers={**headers, "if-none-match": kept.headers["etag"]})
        assert (again.status_code, "X-Esicatalog-Part" in again.headers["vary"]) == (status, True)


async def test_compare_two_revisions(data_db):
    tree = await page(data_db, "/-/esi/compare?a=0xe5c:0x0d080808:0x00100000&b=0xe5c:0x0d080808:0x00110000")
    assert re.match(r"\d+ difference", texts(tree, "[role=status]")[0])
    missing = await page(data_db, "/-/esi/compare?a=1:2:3&b=0xe5c:0x0d080808", 404)
    assert "is not in the catalog" in texts(missing, "[role=alert]")[0]
    assert texts(await page(data_db, "/-/esi/compare"), "h1") == ["Compare two descriptions"]


async def test_scan_pasted_and_dropped(data_db):
    web = await client(data_db)
    files = [{"file": ("slaves.txt", SLAVES.encode(encoding))} for encoding in ("utf-8", "utf-16")]
    for sent in ({"data": {"scan": SLAVES}}, *({"files": file} for file in files)):
        tree = html.fromstring((await web.post("/-/esi/scan", **sent)).text)
        assert texts(tree, "table.slaves td:nth-child(4)") == ["exact", "accepted", "none"]
    image = bytearray(128)
    image[16:24] = (0xE5C).to_bytes(4, "little") + (0x0D080808).to_bytes(4, "little")
    image[24:28] = (0x00110000).to_bytes(4, "little")
    dropped = {"file": ("dump.bin", bytes(image) + b"\xff\xff")}
    tree = html.fromstring((await web.post("/-/esi/scan", files=dropped)).text)
    assert "EEPROM image: exact" in texts(tree, "h2")
    refused = await web.post("/-/esi/scan", data={"scan": "hello"})
    assert (refused.status_code, "no scan is recognised" in refused.text) == (400, True)


async def test_the_scan_page_says_what_the_shell_says(data_db):
    """Which master a bus is of, and for every slave which revision is described instead of its own, and where."""
    of_two = SLAVES.replace("Master 0", "Master 3", 1)
    tree = html.fromstring((await (await client(data_db)).post("/-/esi/scan", data={"scan": of_two})).text)
    assert texts(tree, "h2") == ["Bus 0, master 3: 1 slave", "Bus 1, master 0: 2 slaves"]
    assert texts(tree, "td[data-label=Revision]") == ["", "0x00110000", ""]
    (line,) = rows(data_db, "SELECT line FROM device_sources x JOIN devices d ON d.id = x.device_id "
        "WHERE d.product_code = 0x0d080808 AND d.revision_no = 0x00110000")[0]  # fmt: skip
    source = f"io_terminal_8di_8do.xml, line {line}"
    assert texts(tree, "td[data-label=Source]") == [source, source, ""]


async def test_a_text_beside_a_file_is_refused_and_kept(data_db):
    web = await client(data_db)
    both = {"data": {"scan": SLAVES}, "files": {"file": ("bus.txt", b"vendor,product,revision\n1,2,3\n")}}
    refused = await web.post("/-/esi/scan", **both)
    tree = html.fromstring(refused.text)
    assert (refused.status_code, texts(tree, "[role=alert]")) == (
        400,
        ["bus.txt: a text is given beside this file; give one of both"],
    )
    assert tree.cssselect("textarea")[0].text.strip() == SLAVES.strip()
    # What a file holds is not put into the text: the next file would come beside it.
    alone = html.fromstring((await web.post("/-/esi/scan", files=both["files"])).text)
    assert (len(alone.cssselect("table.slaves")), alone.cssselect("textarea")[0].text) == (1, None)


async def test_one_of_several_files_is_not_taken_silently(data_db):
    web = await client(data_db)
    files = [("file", (name, b"vendor,product,revision\n1,2,3\n")) for name in ("a.csv", "b.csv")]
    sent = ({"files": files}, {"data": {"scan": ["1,2,3", "1,2,4"]}})
    for name, form in zip(("file", "scan"), sent, strict=True):
        refused = await web.post("/-/esi/scan", **form)
        assert (refused.status_code, f"&#39;{name}&#39; is given more than once; give one" in refused.text) == (
            400,
            True,
        )


async def test_a_scan_without_slaves_is_told(data_db):
    scan = "SOEM (Simple Open EtherCAT Master)\n3 slaves found and configured.\n"
    refused = await (await client(data_db)).post("/-/esi/scan", data={"scan": scan})
    (told,) = texts(html.fromstring(refused.text), "[role=alert]")
    assert (refused.status_code, told.startswith("no slave was read; line 1: ")) == (400, True)


HEX_WITHOUT_END = b":0100000000FF\n"
LOADED = bytes([*range(14), crc8(bytes(range(14))), 0]) + bytes(112)
"""Words 0 to 6 with their check sum, and no more than the header of an image."""


@pytest.mark.parametrize(
    ("content", "words"),
    [
        # Behind 128 bytes a category 0x4142 of 0x4344 words begins, which is longer than the file.
        (bytes(128) + b"BADC", "drop.bin: neither a scan nor an EEPROM image (category 16706 at byte 0x80 runs past"),
        (b"\x89PNG\r\n\x1a\n\0", "drop.bin: neither a scan nor an EEPROM image (no SII image: its length"),
        # A text for Windows would have no zeros, a bitmap without pixels no end mark.
        (b"BM" + bytes(200), "drop.bin: neither a scan nor an EEPROM image"),
        (b"hello", "drop.bin: no scan is recognised"),
        *(
            (filler * 256, f"drop.bin: neither a scan nor an EEPROM image (all bytes are 0x{words}: an empty EEPROM")
            for filler, words in ((b"\0", "00"), (b"\xff", "FF"))
        ),
        # What is an image by its beginning is told as one.
        (LOADED + b"BADC", "drop.bin: category 16706 at byte 0x80 runs past the end of the image"),
        (HEX_WITHOUT_END, "drop.bin: Intel HEX: no end record; the file is cut"),
        (b"\xef\xbb\xbf" + HEX_WITHOUT_END, "drop.bin: Intel HEX: no end record; the file is cut"),
    ],
)
async def test_a_file_that_is_neither_scan_nor_image(data_db, content, words):
    answer = await (await client(data_db)).post("/-/esi/scan", files={"file": ("drop.bin", content)})
    assert answer.status_code == 400
    assert texts(html.fromstring(answer.text), "[role=alert]")[0].startswith(words)


async def test_an_image_without_categories_is_known_by_its_check_sum(data_db):
    for content in (LOADED, LOADED + b"\xff\xff", bytes(128).replace(b"\0", b"\1", 1) + b"\xff\xff"):
        answer = await (await client(data_db)).post("/-/esi/scan", files={"file": ("dump.bin", content)})
        assert (answer.status_code, "EEPROM image: none" in answer.text) == (200, True)


async def test_remarks_have_a_row_of_their_own(data_db):
    answer = await (await client(data_db)).post("/-/esi/scan", data={"scan": SLAVES})
    table = html.fromstring(answer.text).cssselect("table.slaves")[0]
    kinds = [row.get("class") for row in table.cssselect("tbody tr")]
    assert kinds == [None, "remarks"] * 3
    labels = [cell.get("data-label") for cell in table.cssselect("tbody tr:first-child td")]
    assert labels == texts(table, "thead th")
    assert {cell.get("colspan") for cell in table.cssselect(".remarks td")} == {str(len(labels))}


@pytest.mark.parametrize(
    ("path", "place"),
    [
        (EYOU, "section[aria-labelledby=modes] table"),
        ("/-/esi/compare?a=0xe5c:0x0d080808:0x00100000&b=0xe5c:0x0d080808:0x00110000", "table.stacked"),
    ],
)
async def test_cells_of_wide_tables_say_their_column(data_db, path, place):
    """On a small screen they stand below each other."""
    for table in (await page(data_db, path)).cssselect(place):
        labels = texts(table, "thead th")
        for row in table.cssselect("tbody tr"):
            assert [cell.get("data-label") for cell in row.cssselect("td")] == labels


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("/-/esi/device/0x1/0x2/0x3", 404),
        ("/-/esi/device/zz/0x2/0x3", 400),
        ("/-/esi/device/0x1097/0x2406/0x8f@0", 400),
        ("/-/esi/device/0x1097/0x2406/0x8f@9", 404),
        ("/-/esi/image/" + "0" * 64, 404),
    ],
)
async def test_what_is_not_there(data_db, path, status):
    assert (await (await client(data_db)).get(path)).status_code == status


@pytest.mark.parametrize(
    ("identity", "match"),
    [
        ("0x1/0x2/0x3", "none"),
        ("0x1097/0x2/0x3", "vendor"),
        ("0x1097/0x2/latest", "vendor"),
        ("0x1097/0x2406/0x90", "older"),
    ],
)
async def test_json_of_a_device_that_is_not_described_is_that_of_identify(data_db, identity, match):
    web = await client(data_db)
    vendor, product, revision = identity.replace("latest", "").split("/")
    answer = await web.get(f"/-/esi/device/{identity}.json")
    asked = await web.get(f"/-/esi/identify.json?vendor={vendor}&product={product}&revision={revision}")
    assert answer.status_code == 404
    assert answer.json() == asked.json()
    assert answer.json()["match"] == match


async def test_json_of_a_variant_that_is_not_there_names_those_that_are(tmp_path):
    """As the page does; ``match`` would be exact, and to a question that was not asked."""
    db = catalog_of(tmp_path, esi(device(name="A")), esi(device(name="B")))
    answer = await (await client(db)).get("/-/esi/device/0xe5c/1/1@9.json")
    found = answer.json()
    words = "0x00000e5c:0x00000001:0x00000001 has no variant 9; its variants are @1 to @2"
    assert (answer.status_code, found["error"]) == (404, words)
    assert [(item["variant"], item["sources"][0]["line"]) for item in found["variants"]] == [(1, 1), (2, 1)]
    assert {item["name"] for item in found["variants"]} == {"A", "B"}
    assert (found["device"]["variant"], found["candidates"]) == (1, [])
    assert "match" not in found


async def test_json_of_a_device_says_that_others_contradict_it(tmp_path):
    """Both documents describe 0xe5c:1:1, one with 2 input bytes, the other with 4."""
    documents = [esi(device(pdo("TxPdo", "#x1A00", bits), name=name)) for name, bits in (("A", 16), ("B", 32))]
    db = catalog_of(tmp_path, *documents)
    first, second = [
        (await (await client(db)).get(f"/-/esi/device/0xe5c/1/1{variant}.json")).json() for variant in ("", "@2")
    ]
    assert first["variants"] == second["variants"]
    assert [(item["variant"], len(item["sources"])) for item in first["variants"]] == [(1, 1), (2, 1)]
    assert [sheet["identity"]["variant"] for sheet in (first, second)] == [1, 2]
    assert {item["name"] for item in first["variants"]} == {"A", "B"}
    asked = (await (await client(db)).get("/-/esi/identify.json?vendor=0xe5c&product=1&revision=1")).json()
    assert first["variants"] == asked["variants"]
    (warning,) = first["warnings"]
    assert warning.endswith(f"@1 is taken, append @N to choose another: {asked['warnings'][0]}")
    assert second["warnings"] == [], "it was chosen"
    assert warning in texts(await page(db, "/-/esi/device/0xe5c/1/1"), "dl.facts dd")


async def test_virtual_sync_managers_are_named_so(tmp_path):
    """ESI-FACTS 8, Sm/@Virtual: not a real SyncManager; in the sheet too."""
    content = '<Sm ControlByte="#x64">Outputs</Sm><Sm ControlByte="#x64" Virtual="1">Outputs</Sm>'
    db = catalog_of(tmp_path, esi(device(content)))
    tree = await page(db, "/-/esi/device/0xe5c/1/1")
    flags = texts(tree, "[aria-label='Sync managers'] tbody td:nth-child(7)")
    assert flags == ["watchdog", "watchdog virtual"]
    sheet = run("show", "0xe5c:1:1", db=db).stdout.splitlines()
    assert ["virtual" in line for line in sheet if line.startswith(("  SM0", "  SM1"))] == [False, True]


@pytest.mark.parametrize("path", ["4247/9222/143", "%23x1097/%23x2406/%23x8f", "0X1097/0x2406/0x8F%401"])
@pytest.mark.parametrize("ending", ["", ".json", "/objects", "/export/igh"])
async def test_numbers_in_every_notation(data_db, path, ending):
    response = await (await client(data_db)).get(f"/-/esi/device/{path}{ending}")
    assert (response.status_code, "EYOU_ServoModule_V143" in response.text) == (200, True)


async def test_latest_visible_revision_by_name(data_db):
    tree = await page(data_db, "/-/esi/device/0xe5c/0x0d080808/latest")
    assert "0x00110000" in texts(tree, "dl.facts dd")[2]


@pytest.fixture(scope="module")
def hostile_db(tmp_path_factory) -> Path:
    """Every name of a document is hostile."""
    quoted = ATTRIBUTE.replace('"', "&quot;")
    content = (
        "<Sm StartAddress='#x1000' ControlByte='#x64'>Outputs</Sm>"
        + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"').replace("e1", HOSTILE + quoted)
        + "<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>#x6060</Index><SubIndex>0</SubIndex>"
        + f"<Data>09</Data><Comment>{HOSTILE}</Comment></InitCmd></CoE></Mailbox>"
        + f"<Dc><OpMode><Name>{HOSTILE}{quoted}</Name><Desc>{HOSTILE}</Desc><AssignActivate>#x300</AssignActivate>"
        + "</OpMode></Dc>"
    )
    text = esi(
        device(content, type_text=HOSTILE, name=HOSTILE + quoted)
        + device(content, type_text=HOSTILE, name=quoted, revision="#x2"),
        vendor=f"<Id>#xE5C</Id><Name>{HOSTILE}{quoted}</Name>",
    )
    return catalog_of(tmp_path_factory.mktemp("hostile"), text)


@pytest.mark.parametrize(
    "path",
    [
        "/-/esi/",
        "/-/esi/?text=%3Cscript%3Ealert(1)%3C/script%3E&vendor=%22onmouseover=alert(1)%20x=%22",
        "/-/esi/device/0xe5c/1/1",
        "/-/esi/device/0xe5c/1/1/objects",
        "/-/esi/compare?a=0xe5c:1:1&b=0xe5c:1:2",
        "/-/esi/compare?a=%3Cscript%3Ealert(1)%3C/script%3E&b=1:1",
        "/-/esi/?mode=%3Cscript%3Ealert(1)%3C/script%3E",
    ],
)
async def test_what_vendors_write_stays_text(hostile_db, path):
    response = await (await client(hostile_db)).get(path)
    tree = html.fromstring(response.text)
    assert [script.get("src") for script in tree.iter("script") if "src" not in script.attrib] == []
    assert [e.tag for e in tree.iter() if any(str(name).lower().startswith("on") for name in e.attrib)] == []
    assert "<script>alert" not in response.text


async def test_no_page_asks_another_host(data_db):
    web = await client(data_db)
    for path in ("/-/esi/", EYOU, "/-/esi/scan", "/-/esi/compare"):
        tree = html.fromstring((await web.get(path)).text)
        for element in tree.iter():
            for name in ("src", "href", "action", "data-src"):
                address = element.attrib.get(name, "")
                assert not re.match(r"(https?:)?//", address), address


async def test_table_pages_show_hex_and_link_to_devices(data_db):
    web = await client(data_db)
    tree = html.fromstring((await web.get("/catalog/devices?product_code=0x2406")).text)
    assert texts(tree, "td.col-product_code span") == ["0x00002406"]
    assert tree.cssselect("td.col-product_code span")[0].get("title") == "9222"
    assert tree.cssselect("td.col-type a")[0].get("href") == EYOU
    entries = html.fromstring((await web.get("/catalog/device_pdo_entries?entry_index__gte=%23x60FF&_size=5")).text)
    shown = texts(entries, "td.col-entry_index span")
    assert shown
    assert all(int(text, 16) >= 0x60FF for text in shown)


async def test_images_are_shown(tmp_path):
    picture = "424D" + "00" * 60
    db = catalog_of(tmp_path, esi(device(f"<ImageData16x14>{picture}</ImageData16x14>")))
    web = await client(db)
    (image,) = html.fromstring((await web.get("/catalog/devices")).text).cssselect("td.col-image_sha256 img")
    response = await web.get(image.get("src"))
    assert (response.status_code, response.headers["content-type"]) == (200, "image/bmp")
    assert response.content == bytes.fromhex(picture)


@pytest.mark.parametrize(
    ("query", "stored"),
    [
        ("product_code=0x10", "product_code=16"),
        ("a=1&entry_index__in=0x10,%23x11&b=0x1", "a=1&entry_index__in=16,17&b=0x1"),
        ("product_code__in=%5B%220x044c2c52%22%2C+%22%23x11%22%2C+18%5D&b=1", "product_code__in=72100946,17,18&b=1"),
        ("product_code__in=%5B%220x10%22", None),
        ("product_code__in=" + "[" * 100_000 + "0x10", None),
        ("product_code=16", None),
        ("name=0x10", None),
        ("product_code__contains=0x10", None),
        ("product_code=0xzz", None),
        ("", None),
        ("object_index_hex=0x60FF", "object_index_hex=0x60ff"),
        ("object_index_hex__exact=%23x60FF", "object_index_hex__exact=0x60ff"),
        ("product_code_hex__gte=4247", "product_code_hex__gte=0x00001097"),
        ("vendor_id_hex__in=0x2,%23xE5C", "vendor_id_hex__in=0x00000002,0x00000e5c"),
        ("other_vendor_id_hex=0x2", "other_vendor_id_hex=0x00000002"),
        ("object_index_hex=0x60ff", None),
        ("object_index_hex__contains=0x60", None),
        ("object_index_hex__startswith=0x6", None),
        ("object_index_hex=60FF", None),
        ("name_hex=0x1", None),
    ],
)
def test_numbers_in_filters(query, stored):
    assert stored_filters(query) == stored


EXPORTS = {
    "igh": ".h",
    "soem": "_soem.h",
    "pysoem": ".py",
    "ros2": ".yaml",
    "linuxcnc": "_linuxcnc.xml",
    "cstruct": ".c",
    "sii": ".bin",
    "esi": ".xml",
}
"""Targets, and what their files are called behind the name of the device."""


@pytest.mark.parametrize("target", EXPORTS)
async def test_exports_are_offered_and_served(data_db, target):
    web = await client(data_db)
    tree = html.fromstring((await web.get(EYOU)).text)
    (link,) = [
        a.get("href")
        for a in tree.cssselect("section[aria-labelledby=exports] a")
        if f"/export/{target}" in a.get("href")
    ]
    response = await web.get(link)
    assert response.status_code == 200, response.text
    name = response.headers["content-disposition"].removeprefix('attachment; filename="').removesuffix('"')
    assert name == f"EYOU_ServoModule_V143{EXPORTS[target]}"
    assert response.content


def test_downloads_of_one_device_have_different_names():
    assert len({*EXPORTS.values()}) == len(EXPORTS)


async def test_only_what_can_be_made_is_offered(tmp_path):
    """A coupler has no process data; a module in its slot brings some."""
    slots = (
        '<Sm>Outputs</Sm><Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>#x10</ModuleIdent></Slot></Slots>'
    )
    mapped = pdo("RxPdo", "#x1600", 8, attributes='Sm="0"')
    module = f'<Module><Type ModuleIdent="#x10">M</Type><Name>M</Name>{mapped}</Module>'
    db = catalog_of(tmp_path, esi(device(slots), module))
    web = await client(db)
    for query, refused in (("", {"ros2", "linuxcnc"}), ("?module=0%3D0x10", set())):
        section = (await page(db, f"/-/esi/device/0xe5c/1/1{query}")).cssselect("section[aria-labelledby=exports]")[0]
        links = [link.get("href") for link in section.cssselect("a.button")]
        assert {re.split(r"[/?]", link.partition("/export/")[2])[0] for link in links} == {*EXPORTS} - refused
        for link in links:
            assert (await web.get(link)).status_code == 200, link
        notes = [text for text in texts(section, "p") if text.startswith("Not without process data")]
        assert notes == (["Not without process data: ROS 2 slave YAML, LinuxCNC XML"] if refused else [])


async def test_of_a_device_without_revision_its_esi_is_offered(tmp_path):
    db = catalog_of(tmp_path, esi(device("<Sm>Outputs</Sm>", revision="#xx1")))
    tree = await page(db, "/-/esi/device/0xe5c/1/-")
    (link,) = tree.cssselect("section[aria-labelledby=exports] a")
    written = await (await client(db)).get(link.get("href"))
    assert 'RevisionNo="#xx1"' in written.text
    refused = await (await client(db)).get("/-/esi/device/0xe5c/1/-/export/sii")
    assert (refused.status_code, "has no revision" in refused.json()["error"]) == (400, True)


async def test_browsers_are_told_on_a_page_why_there_is_no_file(tmp_path):
    """The image of a name of 300 letters is larger than an EEPROM of 256 bytes."""
    small = device("<Eeprom><ByteSize>256</ByteSize></Eeprom>", name="N" * 300)
    db = catalog_of(tmp_path, esi(small))
    tree = await page(db, "/-/esi/device/0xe5c/1/1")
    links = tree.cssselect("section[aria-labelledby=exports] a.button")
    assert not [link for link in links if link.get("download") is not None]
    (link,) = [link.get("href") for link in links if link.get("href").endswith("/export/sii")]
    web = await client(db)
    followed = await web.get(link, headers={"accept": "text/html,application/xhtml+xml,*/*;q=0.8"})
    (said,) = texts(html.fromstring(followed.text), "[role=alert]")
    assert (followed.status_code, "of the EEPROM; to fit," in said) == (400, True)
    assert "(esicatalog export sii --fit)" in said
    asked = await web.get(link)
    assert (asked.status_code, asked.json()) == (400, {"error": said})
    assert all("Accept" in answer.headers["vary"].split(", ") for answer in (followed, asked))


async def test_an_image_in_the_description_that_is_none_is_named_on_its_page_and_in_its_export(tmp_path):
    db = catalog_of(tmp_path, esi(device("<Eeprom><Data>0011</Data></Eeprom>")))
    tree = await page(db, "/-/esi/device/0xe5c/1/1")
    assert "Eeprom/Data cannot be read: no SII image" in tree.text_content()
    refused = await (await client(db)).get("/-/esi/device/0xe5c/1/1/export/sii")
    assert (refused.status_code, refused.json()["error"].split(":")[0]) == (400, "Eeprom/Data of T1 (0.xml, line 1)")


async def test_exports_take_choices_and_refuse_with_words(data_db):
    web = await client(data_db)
    chosen = await web.get(f"{EYOU}/export/igh?module=0%3D0x219800&cycle-ns=2000000&name=axis")
    assert (chosen.status_code, "2000000" in chosen.text) == (200, True)
    for query, words in (
        ("module=0%3D0x1", "does not fit slot 0"),
        ("pdo=zz", "zz"),
        ("color=red", "unknown parameter"),
    ):
        refused = await web.get(f"{EYOU}/export/igh?{query}")
        assert (refused.status_code, words in refused.json()["error"]) == (400, True)
    assert (await web.get(f"{EYOU}/export/nothing")).status_code == 404
    assert (await web.get("/-/esi/device/0x1/0x2/0x3/export/igh")).status_code == 404


@pytest.mark.parametrize("name", ["pdo", "op-mode", "cycle-ns", "name", "alias", "position"])
async def test_exports_take_each_choice_but_modules_once(data_db, name):
    web = await client(data_db)
    refused = await web.get(f"{L6N}/export/igh?{name}=0x1600&{name}=0x1601")
    assert (refused.status_code, refused.json()) == (400, {"error": f"{name} is given more than once"})
    modules = await web.get("/-/esi/device/0xe5c/0xa202/0x10002/export/igh?module=0%3D0x10900&module=1%3D0x10900")
    assert modules.status_code == 200


@pytest.mark.parametrize(
    ("path", "name"), [("compare?a=0x1097:0x2406&b=0x4321:0xe2&a=0x4321:0xe2", "a"), ("?page=1&page=2", "page")]
)
async def test_pages_take_a_parameter_once(data_db, path, name):
    tree = await page(data_db, f"/-/esi/{path}", 400)
    assert texts(tree, "[role=alert]") == [f"{name} is given more than once"]


async def test_numbers_of_exports_are_the_same_at_every_door(data_db):
    web = await client(data_db)
    for name, text, decimal in (("alias", "0x10", 16), ("position", "#x3", 3), ("cycle-ns", "0x7a120", 500_000)):
        answer = await web.get(f"{L6N}/export/igh", params={name: text})
        for written in (text, decimal):
            done = run("export", "igh", "0x4321:0xe2:1", f"--{name}", written, db=data_db)
            assert (done.exit_code, done.stdout) == (0, answer.text)
    for name, text, words in (
        ("alias", "0x10000", "alias 65536 is no 16 bit number"),
        ("position", "65536", "position 65536 is no 16 bit number"),
        ("cycle-ns", "0", "a bus cycle of 0 ns cannot be; give 1 to 4294967295 ns"),
    ):
        refused = await web.get(f"{L6N}/export/igh", params={name: text})
        done = run("export", "igh", "0x4321:0xe2:1", f"--{name}", text, db=data_db)
        assert (refused.status_code, refused.json()) == (400, {"error": words})
        assert (done.exit_code, done.stderr) == (2, f"esicatalog: {words}\n")
    refused = await web.get(f"{L6N}/export/igh", params={"cycle-ns": "0x100000000"})
    assert (refused.status_code, "is larger than 0xffffffff" in refused.json()["error"]) == (400, True)


@pytest.mark.parametrize(
    ("target", "unheeded", "there_are"),
    [
        ("esi", ("op-mode", "module", "cycle-ns", "alias", "fit"), "there are none"),
        ("sii", ("op-mode", "module", "cycle-ns", "alias"), "there is only fit"),
        ("cstruct", ("cycle-ns", "name", "alias", "fit"), "there are pdo, module, op-mode, position"),
        ("soem", ("alias", "position"), "there are pdo, module, op-mode, cycle-ns, name"),
        ("pysoem", ("alias", "position"), "there are pdo, module, op-mode, cycle-ns, name"),
    ],
)
async def test_what_a_target_does_not_heed_is_refused_on_the_web(data_db, target, unheeded, there_are):
    """An EEPROM image and ESI XML are of the description itself, SOEM's application says which slave it means, and
    what ``ethercat cstruct`` prints has no cycle in it."""
    web = await client(data_db)
    for name in unheeded:
        refused = await web.get(f"{L6N}/export/{target}?{name}=1")
        assert (refused.status_code, refused.json()) == (400, {"error": f"unknown parameter {name!r}; {there_are}"})


async def test_the_fields_of_a_form_are_those_that_its_targets_heed(tmp_path, data_db):
    """The second OpMode assigns another PDO, which changes what cstruct prints; the cycle never does."""
    modes = "".join(
        f"<OpMode><Name>{name}</Name><AssignActivate>#x300</AssignActivate><CycleTimeSync0>0</CycleTimeSync0>"
        f'<Sm No="0"><Pdo>{index}</Pdo></Sm></OpMode>'
        for name, index in (("A", "#x1600"), ("B", "#x1601"))
    )
    mapped = '<Sm StartAddress="#x1000" ControlByte="#x24" Enable="1">Outputs</Sm>' + "".join(
        pdo("RxPdo", index, 8, attributes=f'Sm="{sm}"') for index, sm in (("#x1600", 0), ("#x1601", 0))
    )
    db = catalog_of(tmp_path, esi(device(f"{mapped}<Dc>{modes}</Dc>")))
    forms = {
        tuple(field.get("name") for field in form.cssselect("input, select")): {
            button.get("formaction").rpartition("/")[2] for button in form.cssselect("button")
        }
        for form in (await page(db, "/-/esi/device/0xe5c/1/1")).cssselect("section[aria-labelledby=exports] form")
    }
    masters = {"igh", "soem", "pysoem", "ros2", "linuxcnc"}
    assert forms == {("op-mode", "cycle-ns"): masters, ("op-mode",): {"cstruct"}}
    web = await client(db)
    printed = [(await web.get(f"/-/esi/device/0xe5c/1/1/export/cstruct?op-mode=%23{n}")).text for n in (0, 1)]
    assert ["0x1600" in text for text in printed] == [True, False]
    (form,) = (await page(data_db, EYOU)).cssselect("section[aria-labelledby=exports] form")
    assert {button.get("formaction").rpartition("/")[2] for button in form.cssselect("button")} == masters


async def test_an_image_that_is_too_long_is_offered_as_one_that_fits_with_what_it_leaves_out(tmp_path):
    """Of 256 bytes 128 are the header; the strings of two entries with 63 letters each are too much for the rest."""
    names = "".join(
        f"<Entry><Index>#x7000</Index><SubIndex>{n}</SubIndex><BitLen>8</BitLen><Name>{letter * 63}</Name>"
        "<DataType>USINT</DataType></Entry>"
        for n, letter in ((1, "a"), (2, "b"))
    )
    mapped = (
        '<Sm StartAddress="#x1000" ControlByte="#x24" Enable="1">Outputs</Sm>'
        f'<RxPdo Sm="0"><Index>#x1600</Index><Name>P</Name>{names}</RxPdo>'
    )
    small = "<Eeprom><ByteSize>256</ByteSize></Eeprom>"
    described = device(mapped + small) + device(mapped, product="2")
    db = catalog_of(tmp_path, esi(described))
    section = (await page(db, "/-/esi/device/0xe5c/1/1")).cssselect("section[aria-labelledby=exports]")[0]
    (link,) = section.xpath(".//a[contains(@href, 'fit=')]")
    (left_out,) = (await page(db, "/-/esi/device/0xe5c/1/1")).xpath("//h3[@id='left-out']/following-sibling::p")
    assert left_out.text_content() == "names of entries: 2"
    made = await (await client(db)).get(link.get("href"))
    said = run("export", "sii", "0xe5c:1:1", "--fit", "-o", tmp_path / "image.bin", db=db)
    assert (made.status_code, len(made.content)) == (200, 256)
    assert made.content == (tmp_path / "image.bin").read_bytes()
    assert "names of entries: 2" in said.stderr
    assert not (await page(db, "/-/esi/device/0xe5c/2/1")).xpath("//a[contains(@href, 'fit=')]")
    for query, status in (("fit=0", 400), ("fit=", 400), ("fit=x", 400), ("fit=1&fit=1", 400), ("fit=yes", 200)):
        answer = await (await client(db)).get(f"/-/esi/device/0xe5c/1/1/export/sii?{query}")
        assert answer.status_code == status, query
    wrong = await (await client(db)).get("/-/esi/device/0xe5c/1/1/export/sii?fit=x")
    assert wrong.json() == {"error": "fit: 'x' is neither 1 nor 0"}


async def test_what_cstruct_remarks_on_stderr_is_told_beside_its_button(tmp_path):
    """What ``ethercat cstruct`` prints has no place for it, and the file on the web is what the command prints."""
    modules = "".join(
        f'<Module><Type ModuleIdent="{ident}">M</Type><Name>M</Name>{pdo("RxPdo", "#x1600", 8)}</Module>'
        for ident in (1, 2)
    )
    idents = "<ModuleIdent>1</ModuleIdent><ModuleIdent>2</ModuleIdent>"
    slots = f'<Slots><Slot MinInstances="1" MaxInstances="1">{idents}</Slot></Slots>'
    db = catalog_of(tmp_path, esi(device(f"<Sm ControlByte='#x64'>Outputs</Sm>{slots}"), modules))
    for query, options, count in (("", (), 1), ("?module=0%3D1", ("--module", "0=1"), 0)):
        said = run("export", "cstruct", "0xe5c:1:1", *options, db=db)
        told = texts(await page(db, f"/-/esi/device/0xe5c/1/1{query}"), "section[aria-labelledby=exports] #remarks p")
        assert [f"esicatalog: {words}" for words in told] == said.stderr.splitlines()
        assert len(told) == count
        served = await (await client(db)).get(f"/-/esi/device/0xe5c/1/1/export/cstruct{query}")
        assert served.text == said.stdout


async def test_chosen_modules_go_to_the_exports_that_take_them(data_db):
    section = (await page(data_db, f"{EYOU}?module=0%3D0x219800")).cssselect("section[aria-labelledby=exports]")[0]
    links = {link.partition("/export/")[2] for link in section.xpath(".//a/@href") if "/export/" in link}
    assert links == {f"{name}?module=0%3D0x219800" for name in {*EXPORTS} - {"sii", "esi"}} | {"sii", "esi"}


async def test_the_json_of_a_page_is_of_the_chosen_modules(data_db):
    for query in ("", "?module=0%3D0x219800"):
        tree = await page(data_db, EYOU + query)
        alternate = tree.xpath("//link[@rel='alternate']/@href")
        assert {*alternate, *tree.xpath("//a[text()='JSON']/@href")} == {f"{EYOU}.json{query}"}


async def test_links_to_a_device_without_type_have_words(tmp_path):
    """Two devices of one layout, each of which leads to the other, and to itself from a comparison and a scan."""
    mapped = '<Sm StartAddress="#x1100" ControlByte="#x20" Enable="1">Inputs</Sm>' + pdo(
        "TxPdo", "#x1A00", 8, attributes='Sm="0"'
    )
    db = catalog_of(tmp_path, esi(device(mapped, type_text="") + device(mapped, product="#x2", type_text="")))
    pages = [
        await page(db, path)
        for path in ("/-/esi/device/0xe5c/1/1", "/-/esi/compare?a=0xe5c:1:1&b=0xe5c:2:1", "/-/esi/?include-hidden=1")
    ]
    scan = {"scan": "vendor,product,revision\n0xe5c,1,1\n"}
    pages.append(html.fromstring((await (await client(db)).post("/-/esi/scan", data=scan)).text))
    for tree, count in zip(pages, (1, 2, 2, 1), strict=True):
        links = tree.xpath("//main//a[contains(@href, '/device/0xe5c/') and not(contains(@href, '/export/'))]")
        assert [link.text_content().strip() for link in links].count("without type") == count
        assert all(link.text_content().strip() for link in links)


async def test_the_eeprom_image_is_offered_with_what_the_command_says_of_it(tmp_path):
    """EK1100's ConfigData has 2 of the 8 bytes of the PDI words; a device without Eeprom has none."""
    short = "<Eeprom><ByteSize>2048</ByteSize><ConfigData>0104</ConfigData></Eeprom>"
    db = catalog_of(tmp_path, esi(device(short) + device(product="2")))
    for product, words in (
        ("1", "ConfigData has 2 of the 8 bytes"),
        ("2", "gives no ConfigData: the PDI words are zero"),
    ):
        tree = await page(db, f"/-/esi/device/0xe5c/{product}/1")
        assert tree.cssselect("section[aria-labelledby=exports] a[href='#eeprom']")
        said = " ".join(texts(tree, "section[aria-labelledby=eeprom] p"))
        assert "merge this image into the device's own" in said
        assert words in said


@pytest.mark.parametrize("path", ["identify.json", "devices.json", f"{EYOU[7:]}.json", f"{EYOU[7:]}/export/igh"])
async def test_no_json_is_made_of_half_a_question(data_db, path):
    refused = await (await client(data_db)).get(f"/-/esi/{path}?modul=0%3D0x1")
    assert refused.status_code == 400
    assert refused.json()["error"].startswith(("unknown parameter 'modul'; there ", "unknown filter 'modul'; there "))


async def test_identities_that_are_posted_are_the_whole_question(data_db):
    refused = await (await client(data_db)).post("/-/esi/identify.json?revision=0x8f", json=[[0x1097, 0x2406]])
    assert (refused.status_code, refused.json()) == (400, {"error": "unknown parameter 'revision'; there are none"})


async def test_exported_esi_holds_vendor_and_group(data_db):
    text = (await (await client(data_db)).get(f"{EYOU}/export/esi")).content
    (info,) = read(text).document.infos
    assert (info.vendor.vendor_id, info.groups[0].type, info.devices[0].type) == (
        0x1097,
        info.devices[0].group_type,
        "EYOU_ServoModule_V143",
    )


async def test_start_up_values_and_findings(tmp_path):
    """Data 0x0102 as sent is 0x0201; a finding belongs to the device in which it lies."""
    command = (
        "<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>#x2000</Index><SubIndex>1</SubIndex>"
        "<Data>0102</Data></InitCmd></CoE></Mailbox>"
    )
    first, second = device(command), device("<Unknown>1</Unknown>", revision="#x2")
    db = catalog_of(tmp_path, esi(f"{first}\n{second}"))
    one_page = await page(db, "/-/esi/device/0xe5c/1/1")
    assert "513 (0x201)" in texts(one_page, "section[aria-labelledby=commands] td")
    assert not any("Unknown" in text for text in texts(one_page, "section[aria-labelledby=findings] td"))
    other = await page(db, "/-/esi/device/0xe5c/1/2")
    assert any("Unknown" in text for text in texts(other, "section[aria-labelledby=findings] td"))


@pytest.fixture(scope="module")
def many_profiles(tmp_path_factory, data: Path) -> Path:
    """Our examples, and profile numbers of channels and of modules beside those of devices."""
    channels = (
        "<ChannelInfo><ProfileNo>402</ProfileNo></ChannelInfo><ChannelInfo><ProfileNo>402</ProfileNo></ChannelInfo>"
    )
    slots = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>#x7</ModuleIdent></Slot></Slots>'
    module = (
        '<Module><Type ModuleIdent="#x7">M</Type><Name>M</Name><Profile><ProfileNo>401</ProfileNo></Profile></Module>'
    )
    folder = tmp_path_factory.mktemp("profiles")
    own = esi(device(f"<Profile>{channels}</Profile>") + device(slots, product="#x2"), module)
    (folder / "own.xml").write_text(own)
    with Catalog.open(folder / "catalog.db", create=True) as catalog:
        catalog.ingest([data, folder / "own.xml"], jobs=1)
    return folder / "catalog.db"


@pytest.mark.parametrize(
    "query",
    [
        *("", "mode=CSV", "mode=csv,csp", "mode=CSV&strict=1", "strict=1", "sync=sync0", "protocol=coe"),
        *(
            "profile=402",
            "profile=0x191",
            "vendor=0xe5c",
            "vendor=test",
            "sync=sync0&protocol=coe&profile=402&mode=CSV",
        ),
        *("text=servo", "like=0x1097:0x2406", "include-hidden=1&all-variants=1"),
    ],
)
async def test_the_number_beside_a_facet_is_that_behind_its_link(many_profiles, query):
    web = await client(many_profiles)
    links = html.fromstring((await web.get(f"/-/esi/?{query}")).text).cssselect("aside a")
    assert links or query == "like=0x1097:0x2406"
    for link in links:
        if "chosen" not in link.get("class", ""):
            leads_to = html.fromstring((await web.get(f"/-/esi/{link.get('href')}")).text)
            number = link.cssselect(".count")[0].text
            assert texts(leads_to, "h2")[0].split()[0] == number, link.get("href")


async def test_profiles_of_channels_and_of_modules_count(many_profiles):
    tree = await page(many_profiles, "/-/esi/")
    profiles = texts(tree, "aside details:last-child a")
    assert {"402 5", "401 1"} <= set(profiles)


async def test_modes_add_up(data_db):
    tree = await page(data_db, "/-/esi/?mode=CSV")
    (csp,) = [link for link in tree.cssselect("aside a") if link.text_content().startswith("CSP")]
    assert csp.get("href") == "?mode=CSV%2CCSP"
    both = await page(data_db, "/-/esi/?mode=csv,csp")
    assert [text.split()[0] for text in texts(both, "aside a.chosen")] == ["CSP", "CSV"]


async def test_neighbours_of_a_variant_are_compared_with_that_variant(tmp_path):
    """Variant 1 has more entries; variant 2 has the layout of the next revision and of thirteen other products."""
    sm = '<Sm StartAddress="#x1000" ControlByte="#x44">Outputs</Sm>'
    wide, narrow = (sm + pdo("RxPdo", "#x1600", *bits, attributes='Sm="0"') for bits in ((16, 16, 16), (16,)))
    others = "".join(device(narrow, product=str(number)) for number in range(2, 15))
    db = catalog_of(tmp_path, esi(device(wide) + device(narrow) + device(narrow, revision="#x2") + others))
    for path, identity, marks, more in (
        ("0xe5c/1/1", "0x00000e5c:0x00000001:0x00000001", ["", "layout changed"], []),
        ("0xe5c/1/1@2", "0x00000e5c:0x00000001:0x00000001@2", ["", ""], ["2 more"]),
    ):
        tree = await page(db, f"/-/esi/device/{path}")
        section = tree.cssselect("section[aria-labelledby=revisions]")[0]
        links = [link.get("href") for link in section.cssselect("a")]
        assert texts(section, "td:nth-child(3)") == marks
        assert f"/-/esi/compare?a={identity}&b=0x00000e5c:0x00000001:0x00000002" in links
        assert texts(section, "p a") == more
        assert (f"/-/esi/?like={identity}" in links) == bool(more)
        with Catalog.open(db) as catalog:
            shown = catalog.device(identity.replace(":0x00000001", ":1")).revisions
        assert [item.layout_words for item in shown] == marks


async def test_labels_and_examples_of_written_filters(data_db):
    fields = (await page(data_db, "/-/esi/")).cssselect(".more label:not(.check)")
    examples = {" ".join(field.text.split()): field.cssselect("input")[0].get("placeholder") for field in fields}
    assert {"E-bus current in mA": "<=100", "CiA 402 axes": ">=2"}.items() <= examples.items()
    assert parse_identity(examples["Same layout as V:P:R"])


@pytest.mark.parametrize(
    ("query", "ticked"),
    [
        ("include-hidden=1&no-lrw=yes&all-variants=on&needs-dc=true", 4),
        ("include-hidden=false&no-lrw=0&strict=no&mode=CSV&needs-dc=off", 0),
        ("strict=1", 1),
    ],
)
async def test_only_what_is_on_is_ticked(data_db, query, ticked):
    """The form sends again what is ticked: what was off would be on in the next search."""
    for path, status in ((f"/-/esi/?{query}", 200), (f"/-/esi/?{query}&page=x", 400)):
        tree = await page(data_db, path, status)
        assert len(tree.cssselect("input[type=checkbox][checked]")) == ticked


async def test_a_search_keeps_every_filter(data_db):
    """The form sends again what the address says, also what it says twice."""
    query = "maps=0x60FF&maps=0x6040&object=0x6502&object=0x1018%3A1&not-maps=0x1&not-maps=0x2&mode=CSV&strict=1"
    form = (await page(data_db, f"/-/esi/?{query}")).cssselect("form.search")[0]
    sent = [(item.name, item.value) for item in form.inputs if item.get("type") != "checkbox" or item.checked]
    assert sorted(item for item in sent if item[1]) == sorted(parse_qsl(query))


FIELDS = {"text", "mode", "sync", "protocol", "maps", "object", "bytes-in", "bytes-out", "min-cycle-ns", "e-bus-ma"} | {
    *("axes", "physics", "like", "strict", "include-hidden", "all-variants", "needs-dc", "complete-access"),
    *("pdo-assign", "pdo-config", "bootstrap", "no-lrw"),
}
"""What the form shows of a search: written, chosen or ticked."""


@pytest.mark.parametrize(
    "query",
    [
        "text=nothing-like-it&vendor=0x1097",
        "vendor=EYOU&profile=402&product=0x2406",
        "maps=0x6040&bits=16&not-maps=0x1&not-maps=0x2&identification=ado&mode=CSV",
        "product=nonsense&text=servo",
    ],
)
async def test_every_filter_without_a_field_is_named_and_can_be_taken_back(data_db, query):
    """Also where no device is found, or the filter cannot be read."""
    tree = html.fromstring((await (await client(data_db)).get(f"/-/esi/?{query}")).text)
    given = parse_qsl(query)
    named = {name: link.get("href") for link in tree.cssselect("a.chip") for name in texts(link, "bdi")}
    assert [*named] == [f"{name} {text}" for name, text in given if name not in FIELDS]
    for words, href in named.items():
        assert parse_qsl(href.removeprefix("?")) == [item for item in given if " ".join(item) != words]


@pytest.mark.parametrize(("query", "is_open"), [("text=a&object=&axes=&like=", 0), ("needs-dc=1", 1), ("axes=2", 1)])
async def test_more_filters_are_open_where_one_of_them_is_asked(data_db, query, is_open):
    """Forms send empty fields too."""
    assert len((await page(data_db, f"/-/esi/?{query}")).cssselect("details.more[open]")) == is_open


async def test_after_the_last_page_comes_no_other(library_db):
    last, beyond = [await page(library_db, f"/-/esi/?text=terminal&page={number}") for number in (2, 9)]
    shown = [(texts(tree, ".pages"), texts(tree, ".device-head"), texts(tree, "h2")) for tree in (last, beyond)]
    assert shown[0] == shown[1]
    assert shown[0][0] == ["previous page 2 of 2"]


async def test_sheet_and_page_list_the_same_slots_with_what_fits(tmp_path):
    """Slots 0 to 2 take modules 0x10 and 0x20, of which 0x20 is the default of the first; nothing fits slot 3."""
    first = "<Name>Port</Name><ModuleIdent>#x10</ModuleIdent><ModuleIdent Default='1'>#x20</ModuleIdent>"
    slots = f'<Slot MinInstances="0" MaxInstances="3">{first}</Slot>'
    slots += '<Slot MinInstances="0" MaxInstances="1"><ModuleIdent>#x30</ModuleIdent></Slot>'
    modules = "".join(
        f'<Module><Type ModuleIdent="#x{ident}">M{ident}</Type><Name>N{ident}</Name></Module>' for ident in (10, 20)
    )
    db = catalog_of(tmp_path, esi(device(f"<Slots>{slots}</Slots>"), modules))
    by_default = {"0": "0x20"}
    for query, options, runs, plugged in (
        ("", (), ("0", "1 to 2"), by_default),
        ("?module=1=0x10", ("--module", "1=0x10"), "012", {**by_default, "1": "0x10"}),
    ):
        sheet = run("show", "0xe5c:1:1", *options, db=db).stdout.partition("\nSlots and the modules that fit")[2]
        lines = [re.split(r"  +", line.strip()) for line in sheet.partition("\n\n")[0].splitlines()[2:]]
        assert lines == [
            *(
                [numbers, "Port", *["*"][: plugged.get(numbers) == ident], ident, f"N{ident[2:]}"]
                for numbers in runs
                for ident in ("0x10", "0x20")
            ),
            ["3", "no described module to choose"],
        ]
        tree = await page(db, f"/-/esi/device/0xe5c/1/1{query}")
        offered = [option.get("value") for option in tree.cssselect("#slots option")]
        assert offered == [f"{number}={ident}" for number in range(3) for ident in ("", "0x10", "0x20")]
        selected = [option.get("value") for option in tree.cssselect("#slots option[selected]")]
        assert selected == [f"{number}={ident}" for number, ident in plugged.items()]
        found = (await (await client(db)).get(f"/-/esi/device/0xe5c/1/1.json{query}")).json()["slots"]
        assert [(slot["first"], slot["last"], slot["name"]) for slot in found] == [
            *((int(numbers[0]), int(numbers[-1]), "Port") for numbers in runs),
            (3, 3, ""),
        ]
        fitting = [(slot["first"], item["choice"], item["plugged"]) for slot in found for item in slot["modules"]]
        assert fitting == [
            (int(numbers[0]), ident, plugged.get(numbers) == ident) for numbers in runs for ident in ("0x10", "0x20")
        ]
        assert "Slot 3: no described module to choose" in texts(tree, "section[aria-labelledby=image] p")


async def test_slots_beyond_those_that_are_offered(tmp_path):
    slot = '<Slot MinInstances="0" MaxInstances="30"><ModuleIdent>#x10</ModuleIdent></Slot>'
    module = f'<Module><Type ModuleIdent="#x10">M</Type><Name>M</Name>{pdo("TxPdo", "#x1A00", 8)}</Module>'
    db = catalog_of(tmp_path, esi(device(f"<Slots>{slot}</Slots>"), module))
    plain, chosen = [await page(db, f"/-/esi/device/0xe5c/1/1{query}") for query in ("", "?module=29%3D0x10")]
    assert [len(tree.cssselect("#slots select")) for tree in (plain, chosen)] == [24, 25]
    assert texts(plain, "#slots p") == ["Slots up to 29 can be chosen in the address: ?module=29=IDENT"]
    assert ("module", "29=0x10") in chosen.cssselect("form#slots")[0].form_values()


async def test_a_coupler_has_no_process_data(tmp_path):
    """Everywhere 0 bytes, and not unknown ones: on its page, in filters, at the bus."""
    db = catalog_of(tmp_path, esi(device(type_text="coupler")))
    web = await client(db)
    tree = html.fromstring((await web.get("/-/esi/device/0xe5c/1/1")).text)
    facts = dict(zip(texts(tree, "dl.facts dt"), texts(tree, "dl.facts dd"), strict=True))
    assert facts["process data"] == "0 bytes out, 0 bytes in by default"
    assert [item["type"] for item in (await web.get("/-/esi/devices.json?bytes-in=%3C%3D0")).json()] == ["coupler"]
    scanned = html.fromstring(
        (await web.post("/-/esi/scan", data={"scan": "vendor,product,revision\n0xe5c,1,1\n"})).text
    )
    assert [texts(scanned, f"table.slaves td:nth-child({place})") for place in (8, 9)] == [["0"], ["0"]]
    at_bus = dict(zip(texts(scanned, "dl.facts dt"), texts(scanned, "dl.facts dd"), strict=True))
    assert at_bus["process data"] == "0 bytes out, 0 bytes in"


async def test_the_page_says_of_a_bus_what_the_command_says(data_db, tmp_path):
    """Two terminals of one byte each way; nothing is known of the third slave."""
    (tmp_path / "slaves.txt").write_text(SLAVES)
    lines = run("identify", "--slaves", str(tmp_path / "slaves.txt"), db=data_db).stdout.partition("Summary\n")[2]
    answer = await (await client(data_db)).post("/-/esi/scan", data={"scan": SLAVES})
    tree = html.fromstring(answer.text)
    shown = list(zip(texts(tree, "dl.facts dt"), texts(tree, "dl.facts dd"), strict=True))
    assert lines.splitlines() == [f"  {name:15}  {words}" for name, words in shown]
    assert (
        "process data",
        "2 bytes out, 2 bytes in; of slave 1 as the nearest ESI has them; unknown of slave 2",
    ) in shown


async def test_the_page_says_of_a_device_what_the_sheet_says(tmp_path):
    """Each fact under the same name, in the same order, in the same words; the vendor hides revision 1."""
    content = (
        "<Profile><ProfileNo>5001</ProfileNo></Profile><Profile><ProfileNo>402</ProfileNo></Profile>"
        "<Sm StartAddress='#x1000' ControlByte='#x24' Enable='7'>Outputs</Sm>"
        + pdo("RxPdo", "#x1600", 8, attributes="Sm='0'")
        + "<Mailbox><CoE SdoInfo='1' CompleteAccess='1'/></Mailbox>"
        "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>"
        "<Eeprom><ByteSize>2048</ByteSize><ConfigData>050C</ConfigData><Fancy/></Eeprom>"
    )
    newer = device(revision="#x2", name="N").replace("<Name>N</Name>", "<Name>N</Name><HideType RevisionNo='#x1'/>")
    db = catalog_of(tmp_path, esi(device(content) + newer), esi(device(content + "<Slots/>")))
    tree = await page(db, "/-/esi/device/0xe5c/1/1")
    sheet = run("show", "0xe5c:1:1", db=db).stdout.splitlines()
    facts = dict(zip(texts(tree, "dl.facts dt"), texts(tree, "dl.facts dd"), strict=True))
    told = {line[2:17].rstrip(): line[19:] for line in sheet if line.startswith("  ") and line[17:19] == "  "}
    shared = [name for name in facts if name not in ("vendor", "product", "revision", "described in", "descriptions")]
    assert shared == [
        *("group", "profiles", "ports", "mailbox", "CoE", "clocks", "process data", "size", "ConfigData"),
    ]
    assert {name: told[name] for name in shared} == {name: facts[name] for name in shared}
    assert (told["profiles"], told["size"]) == ("5001, 402", "2048 bytes")
    assert told["process data"] == "1 byte out, 0 bytes in by default"
    assert "hidden by its vendor" in told["revision"]
    assert "hidden by its vendor" in facts["revision"]
    assert told["variant"] == "1 of 2: the preferred description of this identity"
    (said,) = [text for text in texts(tree, "section[aria-labelledby=findings] td.long") if "Fancy" in text]
    assert any(said in line for line in sheet)
    assert "7" in texts(tree, "section[aria-labelledby=sync-managers] td")


async def test_entries_without_codes_come_last(tmp_path):
    """Page by page, each device once: 60 with codes, of two vendors, then the 45 of the first vendor without any."""
    caps = "".join(device(product="", type_text=f"cap {number:02}") for number in range(45))
    coded = "".join(device(product=str(number), type_text=f"coded {number:02}") for number in range(1, 31))
    other = esi(coded.replace("coded", "other"), vendor="<Id>#xE5D</Id><Name>Test vendor</Name>")
    db = catalog_of(tmp_path, esi(caps + coded), other)
    shown = [texts(await page(db, f"/-/esi/?page={number}"), ".device-head") for number in (1, 2, 3)]
    expected = [f"{kind} {number:02}" for kind in ("coded", "other") for number in range(1, 31)]
    expected += [f"cap {number:02}" for number in range(45)]
    assert [len(part) for part in shown] == [50, 50, 5]
    assert [text for part in shown for text in part] == expected
    found = texts(await page(db, "/-/esi/?text=cap"), ".device-head")
    assert found == expected[60:]


async def test_vendors_of_one_name_are_told_apart(tmp_path):
    """Test vendor stands for two ids; another name for one."""
    vendors = ("<Id>#xE5C</Id><Name>Test</Name>", "<Id>#xE5D</Id><Name>Test</Name>", "<Id>#xE5E</Id><Name>B</Name>")
    db = catalog_of(tmp_path, *(esi(device(), vendor=vendor) for vendor in vendors))
    links = texts(await page(db, "/-/esi/"), "aside details:first-child a")
    assert links == ["Test (0x00000e5c) 1", "Test (0x00000e5d) 1", "B 1"]


async def test_op_mode_and_cycle_are_chosen_in_a_form(tmp_path):
    """Without a script: a button a target sends the fields to its route, which judges them."""
    modes = "".join(
        f"<OpMode><Name>{name}</Name><AssignActivate>{word}</AssignActivate></OpMode>"
        for name, word in (("FreeRun", "0"), ("DC", "#x300"))
    )
    outputs = "Sm='0'"
    content = f"<Sm>Outputs</Sm>{pdo('RxPdo', '#x1600', 8, attributes=outputs)}<Dc>{modes}</Dc>"
    db = catalog_of(tmp_path, esi(device(content)))
    web = await client(db)
    section = (await page(db, "/-/esi/device/0xe5c/1/1")).cssselect("section[aria-labelledby=exports]")[0]
    form = section.cssselect("form")[0]
    assert [option.get("value") for option in form.cssselect("option")] == ["", "#0", "#1"]
    buttons = [button.get("formaction") for button in form.cssselect("button")]
    assert {target.rpartition("/")[2] for target in buttons} == {*EXPORTS} - {"sii", "esi", "cstruct"}
    for target in buttons:
        for chosen, status in (
            ({}, 200),
            ({"op-mode": "#1", "cycle-ns": "2000000"}, 200),
            ({"cycle-ns": "soon"}, 400),
        ):
            sent = dict(form.form_values()) | chosen
            assert (await web.get(target, params=sent)).status_code == status, target
    header = await web.get(buttons[0], params={"op-mode": "#1", "cycle-ns": "2000000"})
    assert "0x0300" in header.text
    assert "2000000" in header.text


async def test_the_form_keeps_the_chosen_modules(data_db):
    tree = await page(data_db, f"{EYOU}?module=0%3D0x219800")
    form = tree.cssselect("section[aria-labelledby=exports] form")[0]
    assert ("module", "0=0x219800") in form.form_values()


async def test_op_modes_that_newer_tools_ignore_are_marked(tmp_path):
    """EL2262: 30 of 34 OpModes have IgnoreFromBuildNo, and their names come again."""
    old = "<VendorSpecific><TwinCAT IgnoreFromBuildNo='2200'/></VendorSpecific>"
    modes = "".join(
        f"<OpMode><Name>DC</Name><AssignActivate>#x{word}</AssignActivate>{more}</OpMode>"
        for word, more in (("700", old), ("300", ""))
    )
    db = catalog_of(tmp_path, esi(device(f"<Dc>{modes}</Dc>")))
    shown = [line.split()[:3] for line in run("show", "0xe5c:1:1", db=db).stdout.splitlines() if " DC  " in line]
    assert shown == [["0-", "DC", "0x0700"], ["1*", "DC", "0x0300"]]
    tree = await page(db, "/-/esi/device/0xe5c/1/1")
    default, superseded = (text for text in texts(tree, "summary") if text.startswith("DC"))
    assert superseded.startswith("DC (superseded: newer tools ignore it) AssignActivate 0x0700")
    assert default.startswith("DC (default) AssignActivate 0x0300")
    options = [(option.get("value"), option.text) for option in tree.cssselect("select[name=op-mode] option")]
    assert options[1:3] == [
        ("#1", "DC (0x0300) (default)"),
        ("#0", "DC (0x0700) (superseded: newer tools ignore it)"),
    ]
    heading = run("export", "soem", "0xe5c:1:1", db=db).stdout
    assert " ignored by newer tools: 0 'DC'\n" in heading
    assert "others:" not in heading


async def test_a_device_that_uses_the_dc_time_only_generates_no_signal_anywhere(tmp_path):
    """Dc/@TimeLoopControlOnly: table, drawing, sheet and filter agree; SQL tells what AssignActivate asks for."""
    mode = "<Name>DC</Name><AssignActivate>#x320</AssignActivate><CycleTimeSync0 Factor='1'>0</CycleTimeSync0>"
    db = catalog_of(tmp_path, esi(device(f"<Dc TimeLoopControlOnly='1'><OpMode>{mode}</OpMode></Dc>")))
    tree = await page(db, "/-/esi/device/0xe5c/1/1")
    (drawn,) = tree.cssselect("svg.dc-timing")
    assert drawn.get("aria-label") == "Timing of OpMode DC: no SYNC signals"
    assert "DC time only" in run("show", "0xe5c:1:1", db=db).stdout
    assert run("devices", "--sync", "sync0", db=db).stderr == "0 devices\n"
    columns = "sync0, latch1_pdi, dc_time_loop_control_only"
    assert rows(db, f"SELECT {columns} FROM device_dc_modes") == [(1, 1, 1)]
    assert rows(db, "SELECT sync0, sync1 FROM device_overview") == [(0, 0)]


async def test_exclude_of_one_side_counts_for_both_everywhere(tmp_path):
    """ESI-FACTS section 9: only 0x1600 names the other one."""
    pdos = pdo("RxPdo", "#x1600", 8, extra="<Exclude>#x1601</Exclude>") + pdo("RxPdo", "#x1601", 8)
    db = catalog_of(tmp_path, esi(device(pdos)))
    lines = run("show", "0xe5c:1:1", db=db).stdout.splitlines()
    assert [line.split()[1:6] for line in lines if line.strip().startswith("RxPdo")] == [
        ["0x1600", "no", "1", "8", "0x1601"],
        ["0x1601", "no", "1", "8", "0x1600"],
    ]
    tree = await page(db, "/-/esi/device/0xe5c/1/1")
    excluded = [text.partition("excludes ")[2] for text in texts(tree, "summary") if "excludes" in text]
    assert excluded == ["0x1601", "0x1600"]


async def test_titles_keep_right_to_left_names_apart(tmp_path):
    """In a tab the number behind a Hebrew word would stand before it, and an override would turn what follows."""
    db = catalog_of(tmp_path, esi(device(type_text="מנוע", name="מנוע 5\u202e")))
    for path, title in (
        ("device/0xe5c/1/1", "\u2068מנוע\u2069 \u2068מנוע\u2069 5 – esicatalog"),
        ("device/0xe5c/1/1/objects", "Objects of \u2068מנוע\u2069 – esicatalog"),
        ("?text=מנוע", "\u2068מנוע\u2069 – esicatalog"),
    ):
        tree = await page(db, f"/-/esi/{path}")
        assert tree.findtext(".//title") == title
