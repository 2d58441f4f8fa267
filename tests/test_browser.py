"""The pages in a real browser: search, filter, pick modules, compare, paste a scan, by keyboard, small and large."""

import re
import shutil
from collections.abc import Iterator

import pytest
from axe_playwright_python.sync_playwright import Axe
from conftest import serving
from playwright.sync_api import Browser, Page, expect, sync_playwright
from snippets import device, dictionary, esi, pdo
from test_identify import SLAVES
from test_search import catalog_of

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="no chromium on this machine")

EYOU = "/-/esi/device/0x1097/0x2406/0x8f"
COMPARE = "/-/esi/compare?a=0xe5c:0x0d080808:0x00100000&b=0xe5c:0x0d080808:0x00110000"
PAGES = ("/-/esi/", "/-/esi/?mode=CSV&vendor=0x1097", EYOU, "/-/esi/scan", COMPARE)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        # as root, as in containers, chromium starts without its sandbox only
        arguments = ["--no-sandbox", "--host-resolver-rules=MAP catalog.example 127.0.0.1"]
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        yield browser
        browser.close()


@pytest.fixture(scope="module")
def tab(browser: Browser, served: str) -> tuple[Page, list[str]]:
    """A page, which takes as long to make as several take to load, and what went wrong in it."""
    opened = browser.new_page(base_url=served)
    problems: list[str] = []
    opened.on("request", lambda request: request.url.startswith((served, "data:")) or problems.append(request.url))
    opened.on("pageerror", lambda error: problems.append(str(error)))
    return opened, problems


@pytest.fixture
def page(tab: tuple[Page, list[str]]) -> Iterator[Page]:
    """A page that fails the test when anything is asked of another host or a script breaks."""
    opened, problems = tab
    problems.clear()
    opened.set_viewport_size({"width": 1280, "height": 900})
    opened.emulate_media(color_scheme="light")
    yield opened
    assert problems == []


def test_search_filter_and_open(page: Page):
    page.goto("/-/esi/")
    page.get_by_role("searchbox").fill("D808")
    page.get_by_role("button", name="Search").click()
    expect(page.get_by_role("status")).to_have_text("1 device")
    page.goto("/-/esi/")
    page.get_by_role("link", name="CSV 3").click()
    expect(page).to_have_url(re.compile(r"/-/esi/\?mode=CSV$"))
    expect(page.get_by_role("status")).to_have_text("3 devices")
    page.get_by_role("link", name="EYOU_ServoModule_V143").click()
    expect(page.get_by_role("heading", level=1)).to_contain_text("EYOU_ServoModule_V143")
    expect(page.locator("footer")).to_be_visible()
    expect(page.locator("section[aria-labelledby=image] svg")).to_have_count(2)
    rows = page.locator("section[aria-labelledby=image] details tbody tr").count()
    expect(page.locator("section[aria-labelledby=image] svg g.entry")).to_have_count(rows)


def test_module_picker(page: Page):
    page.goto(EYOU)
    before = page.locator("section[aria-labelledby=image] details tbody").first.text_content() or ""
    page.get_by_role("combobox", name="Slot 0").select_option("0=0x219800")
    page.get_by_role("button", name="Show with these modules").click()
    expect(page.get_by_role("heading", name="Process image with the chosen modules")).to_be_visible()
    expect(page.locator("section[aria-labelledby=image] details tbody").first).not_to_have_text(before)


def test_dictionary_is_loaded_and_filtered(page: Page):
    page.goto(EYOU)
    page.get_by_text("objects", exact=False).locator("visible=true").last.click()
    box = page.get_by_label("Filter by index, name or type")
    box.fill("0x6502")
    expect(page.locator("[data-shown]")).to_have_text("1 object")
    expect(page.locator("details[data-object]:visible")).to_have_count(1)


def test_objects_that_cannot_be_had_are_asked_for_again(page: Page):
    """A server that is restarted, then one that refuses, then one that answers."""
    page.goto(EYOU)
    section = page.locator("section[aria-labelledby=objects]")
    summary = section.locator("summary").first
    for hinder, words in (
        (lambda route: route.abort(), "the server cannot be reached"),
        (lambda route: route.fulfill(status=503), "the server answered 503"),
    ):
        page.route("**/objects", hinder)
        summary.click()
        expect(section.locator("[data-target]")).to_contain_text(words)
        page.unroute("**/objects")
        summary.click()
    summary.click()
    expect(section.locator("details[data-object]").first).to_be_visible()


def test_the_page_of_objects_alone_is_filtered(page: Page):
    """By the object and by its entries: Calc and copy time is in 0x1C32 and 0x1C33, Sync0 cycle time is 0x1C32:10."""
    page.goto(f"{EYOU}/objects")
    box = page.get_by_label("Filter by index, name or type")
    for sought, words in (
        ("0x6502", "1 object"),
        ("CALC and copy", "2 objects"),
        ("0x1c32:0A sync0", "1 object"),
        ("0x1C32:0E", "0 objects"),
    ):
        box.fill(sought)
        expect(page.locator("[data-shown]")).to_have_text(words)
    box.fill("0x6502")
    expect(page.locator("details[data-object]:visible")).to_have_count(1)


def test_without_scripts_nothing_is_offered_that_needs_them(browser: Browser, served: str):
    context = browser.new_context(base_url=served, java_script_enabled=False)
    opened = context.new_page()
    opened.goto(f"{EYOU}/objects")
    expect(opened.locator("details[data-object]").first).to_be_visible()
    assert opened.locator("input[data-filter]:visible").count() == 0
    context.close()


def test_over_plain_http_by_name(browser: Browser, served: str):
    """There browsers neither say what asks nor have a clipboard: origins of other machines are not secure."""
    opened = browser.new_page(base_url=served.replace("127.0.0.1", "catalog.example"))
    opened.goto(EYOU)
    assert opened.evaluate("[isSecureContext, typeof navigator.clipboard]") == [False, "undefined"]
    assert opened.locator("button[data-copy]:visible").count() == 0
    opened.locator("section[aria-labelledby=objects] summary").first.click()
    expect(opened.locator("details[data-object]").first).to_be_visible()
    assert opened.locator("header").count() == 1
    opened.close()


def test_compare_and_scan(page: Page):
    page.goto(COMPARE)
    expect(page.get_by_role("status")).to_contain_text("difference")
    page.goto("/-/esi/scan")
    page.get_by_label("Output of").fill(SLAVES)
    page.get_by_role("button", name="Identify").click()
    expect(page.locator("table.slaves tbody tr:not(.remarks)")).to_have_count(3)
    page.get_by_role("link", name="ECX-D808").first.click()
    expect(page.get_by_role("heading", level=1)).to_contain_text("ECX-D808")


def test_by_keyboard_alone(page: Page):
    page.goto("/-/esi/")
    page.keyboard.press("Tab")
    expect(page.get_by_role("link", name="Skip to content")).to_be_focused()
    for _ in range(12):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.id") == "text":
            break
    page.keyboard.type("L6N")
    page.keyboard.press("Enter")
    expect(page.get_by_role("status")).to_have_text("1 device")
    page.get_by_role("link", name="L6N", exact=True).focus()
    page.keyboard.press("Enter")
    expect(page.get_by_role("heading", level=1)).to_contain_text("L6N")
    page.locator("section[aria-labelledby=pdos] summary").first.focus()
    page.keyboard.press("Enter")
    expect(page.locator("section[aria-labelledby=pdos] table").first).to_be_visible()


WIDTHS = (1280, 400)
"""A large screen and a small one."""


def assert_nothing_sticks_out(page: Page) -> None:
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("path", PAGES)
def test_accessibility_and_width(page: Page, path: str):
    """axe-core finds nothing serious, in either scheme of colours; nothing is wider than the screen."""
    page.goto(path)
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        violations = Axe().run(page).response["violations"]
        assert [
            (found["id"], node["html"][:200], node["failureSummary"][:200])
            for found in violations
            if found["impact"] in ("serious", "critical")
            for node in found["nodes"][:3]
        ] == [], scheme
    assert_nothing_sticks_out(page)


RIGHT_TO_LEFT = ("מנוע", "מנוע 5", 'בע"מ', "محرك", "A\u202eB", "\u202bA", "\u2067A")
"""Names in Hebrew and Arabic, and with characters that order text and that nothing ends."""


def long_names() -> list[str]:
    """Names that nothing breaks, and a number of two digits beside one of them; slots and modules with long names."""
    content = pdo("RxPdo", "#x1600", 8).replace("RxPdo #x1600", "n" * 400)
    devices = "".join(device(content, product=str(number), name="d" * 400) for number in range(1, 13))
    vendor = f"<Id>#xE5C</Id><Name>A company for motors, drives and {'very' * 30} long names</Name>"
    slots = "".join(
        f"<Slot MinInstances='0' MaxInstances='1'><Name>{name}</Name><ModuleIdent>#x10</ModuleIdent></Slot>"
        for name in ("s" * 120, "Slot for a terminal")
    )
    modules = f"<Module><Type ModuleIdent='#x10'>M</Type><Name>{'A module with a long name, ' * 6}</Name></Module>"
    modular = esi(device(f"<Slots>{slots}</Slots>", product="99"), modules, vendor=vendor)
    return [esi(devices, vendor=vendor), modular]


def right_to_left() -> list[str]:
    """Every name is written from right to left, or says that the rest is."""
    documents = []
    for number, name in enumerate(RIGHT_TO_LEFT):
        quoted = name.replace('"', "&quot;")
        mapped = (
            f"<RxPdo Sm='0'><Index>#x1600</Index><Name>{name}</Name><Entry><Index>#x60FF</Index><SubIndex>0</SubIndex>"
            f"<BitLen>32</BitLen><Name>{name}</Name><DataType>DINT</DataType></Entry></RxPdo>"
        )
        objects = f"<Object><Index>#x2000</Index><Name>{name}</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
        content = (
            dictionary("<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>", objects)
            + f"<Sm StartAddress='#x1100' ControlByte='#x64'>Outputs</Sm><Dc><OpMode><Name>{name}</Name>"
            + "<AssignActivate>#x700</AssignActivate></OpMode></Dc><Slots><Slot MinInstances='1' MaxInstances='1'>"
            + f"<Name>{name}</Name><ModuleIdent Default='1'>#x10</ModuleIdent></Slot></Slots>"
        )
        module = f"<Module><Type ModuleIdent='#x10'>{name}</Type><Name>{name} csv</Name>{mapped}</Module>"
        devices = "".join(
            device(content, product=f"#x{number + 1}", revision=revision, type_text=name, name=quoted)
            for revision in ("#x1", "#x2")
        )
        documents.append(esi(devices, module, vendor=f"<Id>#x{0x9000 + number:x}</Id><Name>{name}</Name>"))
    return documents


@pytest.fixture(scope="module")
def odd_names(tmp_path_factory) -> Iterator[str]:
    """A server of what is hard to lay out."""
    with serving(catalog_of(tmp_path_factory.mktemp("odd"), *long_names(), *right_to_left())) as address:
        yield address


def test_long_names_are_broken_and_numbers_are_not(browser: Browser, odd_names: str):
    opened = browser.new_page(base_url=odd_names)
    opened.goto("/-/esi/device/0xe5c/1/1")
    assert_nothing_sticks_out(opened)
    opened.goto("/-/esi/")
    lines = (
        "node => { const range = new Range(); range.selectNodeContents(node); return range.getClientRects().length }"
    )
    for width in WIDTHS:
        opened.set_viewport_size({"width": width, "height": 900})
        assert opened.evaluate("document.documentElement.scrollWidth") <= width
        expect(opened.locator("aside .count").first).to_have_text("13")
        assert opened.locator("aside .count").first.evaluate(lines) == 1
    opened.close()


def test_the_module_picker_stays_within_the_page(browser: Browser, odd_names: str):
    opened = browser.new_page(base_url=odd_names)
    opened.goto("/-/esi/device/0xe5c/99/1")
    expect(opened.get_by_label("Slot 1")).to_be_visible()
    assert_nothing_sticks_out(opened)
    opened.close()


def test_copy_button(browser: Browser, served: str):
    """It says for a moment that it copied, and its own words again after that, however often it is pressed."""
    context = browser.new_context(base_url=served, permissions=["clipboard-read", "clipboard-write"])
    opened = context.new_page()
    opened.goto(EYOU)
    button = opened.get_by_role("button", name="Copy 0x00002406")
    words = button.text_content() or ""
    button.click()
    opened.wait_for_function("async () => await navigator.clipboard.readText() === '0x00002406'")
    button.click()
    expect(button).to_have_text(words)
    context.close()


def test_a_scan_is_read_on_a_small_screen(page: Page):
    """The answer stands within the screen, and remarks have its width."""
    page.set_viewport_size({"width": 400, "height": 900})
    page.goto("/-/esi/scan")
    page.get_by_label("Output of").fill(SLAVES)
    page.get_by_role("button", name="Identify").click()
    for place in ("[data-label=ESI]", "[data-label=Device]", ".remarks td"):
        box = page.locator(f"table.slaves {place}").first.bounding_box()
        assert box is not None
        assert box["x"] + box["width"] <= 400
        assert box["width"] >= 300


def test_several_files_dropped_are_refused(page: Page):
    page.goto("/-/esi/scan")
    drop = """names => {
        const data = new DataTransfer();
        for (const name of names) data.items.add(new File(["vendor,product\\n0xe5c,0x0d080808\\n"], name));
        document.querySelector("form[data-drop]").dispatchEvent(new DragEvent("drop", { dataTransfer: data }));
    }"""
    told = page.get_by_text("Several files were dropped; drop one.")
    expect(told).to_be_hidden()
    page.evaluate(drop, ["a.csv", "b.csv"])
    expect(told).to_be_visible()
    assert page.locator("table.slaves").count() == 0
    page.evaluate(drop, ["a.csv"])
    expect(page.locator("table.slaves tbody tr:not(.remarks)")).to_have_count(1)


def test_fields_of_a_line_are_level(page: Page):
    page.goto("/-/esi/")
    boxes = [page.locator(f"[name={name}]").bounding_box() for name in ("mode", "sync", "protocol", "maps")]
    assert len({(box["y"], box["height"]) for box in boxes if box is not None}) == 1


def test_sentences_in_tables_have_room(page: Page):
    """24 of the font's em: the tables of Datasette squeezed them to 80 px."""
    page.goto("/catalog/device_drive_modes?_size=5")
    for column in ("evidence", "recipe"):
        box = page.locator(f"td.col-{column}").first.bounding_box()
        assert box is not None
        assert box["width"] >= 24 * 14


NUMBERS_OUT_OF_ORDER = """() => {
  const found = [], range = new Range(), walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const boxesOf = (node, from, to) => {
    range.setStart(node, from);
    range.setEnd(node, to);
    return [...range.getClientRects()].filter(box => box.width);
  };
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (node.parentElement.closest("textarea, option, select, title, script, style, dl.column-descriptions")) continue;
    for (const number of node.data.matchAll(/0x[0-9a-f]{2,}(:[0-9a-f]+)*|[0-9]{2,}/gi)) {
      const [first, last] = [number.index, number.index + number[0].length - 1];
      const boxes = boxesOf(node, first, last + 1);
      const isBrokenInLines = boxes.slice(1).every((box, at) => box.top > boxes[at].bottom - 2);
      const [left] = boxesOf(node, first, first + 1), [right] = boxesOf(node, last, last + 1);
      const isForward = boxes.length != 1 || left.left < right.left;
      if (!isBrokenInLines || !isForward) found.push(`${number[0]} in: ${node.data}`);
    }
  }
  return found;
}"""
"""Numbers that are torn apart within a line, or of which the last character stands left of the first."""


def test_names_from_right_to_left_leave_numbers_in_their_place(browser: Browser, odd_names: str):
    opened = browser.new_page(base_url=odd_names, viewport={"width": 1280, "height": 900})
    tables = ("/catalog/device_drive_modes", "/catalog/device_dc_modes", "/catalog/pdos?_facet=name")
    for path in ("/-/esi/", "/-/esi/?mode=CSV&maps=0x60FF", *tables):
        opened.goto(path)
        assert opened.evaluate(NUMBERS_OUT_OF_ORDER) == [], path
    for number in range(len(RIGHT_TO_LEFT)):
        vendor, product = 0x9000 + number, number + 1
        # The page of a device has every place of a name; of the others each shows some of the names.
        others = (
            f"/-/esi/device/{vendor:#x}/{product:#x}/0x1/objects",
            f"/-/esi/device/{vendor:#x}/{product:#x}/0x99",
            f"/-/esi/compare?a={vendor:#x}:{product:#x}:1&b=0x9001:2:1",
        )
        for path in (f"/-/esi/device/{vendor:#x}/{product:#x}/0x1", others[number % len(others)]):
            opened.goto(path)
            opened.evaluate("document.querySelectorAll('details').forEach(item => { item.open = true })")
            assert opened.evaluate(NUMBERS_OUT_OF_ORDER) == [], path
    opened.goto("/-/esi/scan")
    opened.get_by_label("Output of").fill("0x9000,1,1\n0x9004,5,1\n0x9004,5,9")
    opened.get_by_role("button", name="Identify").click()
    expect(opened.locator("table.slaves tbody tr:not(.remarks)")).to_have_count(3)
    assert opened.evaluate(NUMBERS_OUT_OF_ORDER) == []
    opened.close()
