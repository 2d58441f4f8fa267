"""Modules that share a ModuleIdent, as terminals of a bus coupler do: each can be chosen, none is taken silently."""

from urllib.parse import parse_qsl, quote

import pytest
from click.testing import CliRunner
from lxml import html
from snippets import device, esi, only_device, pdo, read
from test_search import catalog_of
from web_client import client

from esicatalog.cli.main import cli
from esicatalog.errors import InputError
from esicatalog.identity import ModuleChoice, parse_plugged
from esicatalog.model.module_choice import chosen_modules, module_choices
from esicatalog.model.process_image import SmImage, default_process_image
from esicatalog.model.slots import default_modules

COUPLER = "/-/esi/device/0xe5c/1/1"
IDENTS = "".join(f"<ModuleIdent>#x{number:x}</ModuleIdent>" for number in (0x10, 0x20, 0x30, *range(0x100, 0x10C)))
SLOT = f'<Sm>Outputs</Sm><Slots><Slot MinInstances="0" MaxInstances="2">{IDENTS}</Slot></Slots>'


def module(ident: str, type_text: str, bits: int, name: str = "N", more: str = "") -> str:
    mapped = pdo("RxPdo", "#x1600", bits, attributes='Sm="0"')
    return f'<Module><Type ModuleIdent="{ident}">{type_text}</Type><Name>{name}</Name>{mapped}{more}</Module>'


MODULES = "".join(
    (
        module("#x10", "Serial (3 Byte)", 24, "three"),
        module("#x10", "Serial\n (11 Byte)", 88, "eleven"),
        module("#x20", "Digital A", 8, "first"),
        module("#x20", "Digital B", 8, "second"),
        module("#x30", "Twin", 16),
        module("#x30", "Twin", 32),
        *(module(f"#x{number:x}", f"M{number}", 1) for number in range(0x100, 0x10C)),
    )
)
DOCUMENT = esi(device(SLOT), MODULES)


def sizes(*written: str) -> list[int]:
    """Bits of the PDO of each plugged module."""
    modules = read(DOCUMENT).document.infos[0].modules
    plugged = chosen_modules(only_device(DOCUMENT), modules, dict(map(parse_plugged, written)), ())
    return [item.module.rx_pdos[0].entries[0].bit_length or 0 for item in plugged]


@pytest.mark.parametrize(
    ("written", "bits"),
    [
        ("0=0x10/Serial (3 Byte)", 24),
        ("0=16/Serial (11 Byte)", 88),
        ("1=#x10/ Serial  (11 Byte) ", 88),
        ("0=0x20", 8),
        ("0=0x20/Digital B", 8),
        ("0=0x30/Twin#1", 16),
        ("0=0x30/Twin#2", 32),
        ("0=0x100/M256", 1),
    ],
)
def test_a_module_of_several_with_one_ident_is_chosen_by_its_type(written, bits):
    assert sizes(written) == [bits]


def preset(ident: str, attributes: str = 'Default="1"') -> tuple[list[int], SmImage]:
    """Bits of the PDOs of what is plugged without a choice into a required slot, and the image."""
    slot = f'<Slot MinInstances="1" MaxInstances="1"><ModuleIdent {attributes}>{ident}</ModuleIdent></Slot>'
    info = read(esi(device(f"<Sm>Outputs</Sm><Slots>{slot}</Slots>"), MODULES)).document.infos[0]
    plugged = default_modules(info.devices[0], info.modules)
    (image,) = default_process_image(info.devices[0], info.modules)
    return [item.module.rx_pdos[0].entries[0].bit_length or 0 for item in plugged], image


@pytest.mark.parametrize("attributes", ['Default="1"', ""])
def test_a_preset_ident_of_modules_that_differ_is_no_choice(attributes):
    """0x10 is 3 or 11 bytes long; 0x20 one byte, whichever of the two it is."""
    bits, image = preset("#x10", attributes)
    assert (bits, image.byte_size) == ([], None)
    assert image.remarks == (
        "slot 0 without a module, though required: PDOs of modules are missing; what fits slot 0: "
        "0x10/Serial (3 Byte), 0x10/Serial (11 Byte)",
    )
    bits, image = preset("#x20", attributes)
    assert (bits, image.byte_size, image.remarks) == ([8], 1, ())


@pytest.mark.parametrize(
    ("written", "words"),
    [
        (
            "0=0x10",
            "module 0x10 is ambiguous in slot 0: 2 modules have this ident; write one of: "
            "0x10/Serial (3 Byte), 0x10/Serial (11 Byte)",
        ),
        (
            "1=0x30/Twin",
            "module 0x30/Twin is ambiguous in slot 1: 2 modules have this ident; write one of: "
            "0x30/Twin#1, 0x30/Twin#2",
        ),
        (
            "0=0x10/Serial",
            "module 0x10/Serial does not fit slot 0; what fits: 0x10/Serial (3 Byte), 0x10/Serial (11 Byte)",
        ),
        (
            "0=0x1",
            "module 0x1 does not fit slot 0; what fits: 0x10, 0x20, 0x30, 0x100, 0x101, 0x102, 0x103, 0x104, 0x105, "
            "0x106, and 5 more; see esicatalog show",
        ),
    ],
)
def test_what_is_refused_is_told_with_what_can_be_chosen(written, words):
    with pytest.raises(InputError) as refused:
        sizes(written)
    assert str(refused.value) == words


@pytest.mark.parametrize(
    "more",
    [
        "<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>#x8000</Index><SubIndex>1</SubIndex>"
        "<Data>01</Data></InitCmd></CoE></Mailbox>",
        "<DcOpModeName>DC</DcOpModeName>",
    ],
)
def test_start_up_commands_and_clocks_make_an_ident_ambiguous_too(more):
    document = esi(device(SLOT), module("#x10", "A", 8) + module("#x10", "B", 8, more=more))
    modules = read(document).document.infos[0].modules
    with pytest.raises(InputError, match="ambiguous"):
        chosen_modules(only_device(document), modules, {0: ModuleChoice(0x10)}, ())


def test_a_module_without_type_has_a_number():
    modules = read(esi(device(SLOT), module("#x10", "", 8) + module("#x10", "B", 16))).document.infos[0].modules
    assert list(map(str, module_choices(modules))) == ["0x10/#1", "0x10/B"]


@pytest.mark.parametrize("text", ["0", "0=1/", "0=1/ ", "=1", "0=/M"])
def test_what_is_no_choice_of_a_module(text):
    with pytest.raises(InputError):
        parse_plugged(text)


def test_commands_take_the_type(tmp_path):
    db = str(catalog_of(tmp_path, DOCUMENT))
    chosen = ["0xe5c:1:1", "--db", db, "--module", "0=0x10/Serial (11 Byte)"]
    shown = CliRunner().invoke(cli, ["show", *chosen])
    assert "Process image, SM0 Outputs: 11 bytes (88 bits)" in shown.stdout
    assert "Module 0x0030  Twin#2  N" in shown.stdout.splitlines()
    assert "SM0:      11 bytes output" in CliRunner().invoke(cli, ["export", "igh", *chosen]).stdout
    refused = CliRunner().invoke(cli, ["export", "igh", *chosen[:-1], "0=0x10"])
    assert (refused.exit_code, "0x10 is ambiguous in slot 0" in refused.stderr) == (2, True)


def test_slots_that_another_variant_describes(tmp_path):
    """The description with more objects and PDO entries, modules included, would be the preferred one."""
    many = pdo("RxPdo", "#x1600", *[8] * 20, attributes='Sm="0"')
    db = catalog_of(tmp_path, esi(device(f"<Sm>Outputs</Sm>{many}")), esi(device(SLOT), module("#x10", "M", 8)))
    words = ("--db", str(db), "--module", "0=0x10")
    refused = CliRunner().invoke(cli, ["show", "0xe5c:1:1", *words])
    expected = "esicatalog: the device has no slots in this variant; variants with slots: @2\n"
    assert (refused.exit_code, refused.stderr) == (2, expected)
    assert CliRunner().invoke(cli, ["show", "0xe5c:1:1@2", *words]).exit_code == 0
    refused = CliRunner().invoke(cli, ["export", "igh", "0xe5c:1:1", *words])
    assert (refused.exit_code, refused.stderr) == (2, expected)
    assert CliRunner().invoke(cli, ["export", "igh", "0xe5c:1:1@2", *words]).exit_code == 0


def test_slots_that_another_description_of_the_document_has(tmp_path):
    plain = device("<Sm>Outputs</Sm>")
    (tmp_path / "a.xml").write_text(esi(plain + device(SLOT), module("#x10", "M", 8)))
    words = ("--esi", str(tmp_path / "a.xml"), "--module", "0=0x10")
    refused = CliRunner().invoke(cli, ["export", "igh", "0xe5c:1:1@1", *words])
    expected = "esicatalog: the device has no slots in this variant; variants with slots: @2\n"
    assert (refused.exit_code, refused.stderr) == (2, expected)
    assert CliRunner().invoke(cli, ["export", "igh", "0xe5c:1:1@2", *words]).exit_code == 0


async def test_the_picker_sends_and_marks_the_plugged_module(tmp_path):
    web = await client(catalog_of(tmp_path, DOCUMENT))

    async def selected(query: str) -> list[str]:
        tree = html.fromstring((await web.get(f"{COUPLER}?{query}")).text)
        (slot, _) = tree.cssselect("#slots select")
        return [option.get("value") for option in slot.cssselect("option[selected]")]

    assert await selected("module=0%3D0x20") == ["0=0x20/Digital A"]
    tree = html.fromstring((await web.get(COUPLER)).text)
    options = [item.get("value") for item in tree.cssselect("#slots select")[0].cssselect("option")]
    assert options[:8] == [
        "0=",
        "0=0x10/Serial (3 Byte)",
        "0=0x10/Serial (11 Byte)",
        "0=0x20/Digital A",
        "0=0x20/Digital B",
        "0=0x30/Twin#1",
        "0=0x30/Twin#2",
        "0=0x100",
    ]
    for option in options[1:8]:
        assert await selected(f"module={quote(option)}") == [option]


async def test_exports_and_json_take_the_type(tmp_path):
    web = await client(catalog_of(tmp_path, DOCUMENT))
    tree = html.fromstring((await web.get(f"{COUPLER}?module={quote('1=0x30/Twin#2')}&module=0%3D")).text)
    (link,) = [item.get("href") for item in tree.cssselect("a.button") if "/export/igh" in item.get("href")]
    assert parse_qsl(link.partition("?")[2]) == [("module", "1=0x30/Twin#2")]
    assert "SM0:      4 bytes output" in (await web.get(link)).text
    body = (await web.get(f"{COUPLER}.json?module={quote('0=0x10/Serial (11 Byte)')}")).json()
    assert [image["bit_size"] for image in body["process_image"]] == [88]
    for path in (f"{COUPLER}.json", f"{COUPLER}/export/igh"):
        refused = await web.get(f"{path}?module=0%3D0x10")
        assert (refused.status_code, "ambiguous" in refused.json()["error"]) == (400, True)


async def test_a_slot_is_given_once(tmp_path):
    """The last one would count, and the bus would run with a module that was not meant."""
    db = catalog_of(tmp_path, DOCUMENT)
    (tmp_path / "a.xml").write_text(DOCUMENT)
    twice = ["--module", "0=0x100", "--module", "1=0x100", "--module", "#x0=0x30/Twin#1"]
    words = "slot 0 is given twice, with module 0x100 and with module 0x30/Twin#1"
    stored = ["0xe5c:1:1", "--db", str(db)]
    for command in (
        ["show", *stored],
        ["export", "igh", *stored],
        ["export", "soem", "--esi", str(tmp_path / "a.xml")],
    ):
        refused = CliRunner().invoke(cli, [*command, *twice])
        assert (refused.exit_code, refused.stderr, refused.stdout) == (2, f"esicatalog: {words}\n", "")
    web = await client(db)
    for path in (f"{COUPLER}.json", f"{COUPLER}/export/igh"):
        answer = await web.get(f"{path}?module=0%3D0x100&module=0%3D0x30/Twin%231")
        assert (answer.status_code, answer.json()) == (400, {"error": words})
