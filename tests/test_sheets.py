"""Sheet, page and JSON of a device tell the same: what is sent at start, assigned, marked, sampled."""

import json
from pathlib import Path

from snippets import device, esi, pdo
from test_cli import run
from test_pages import page, texts
from test_search import catalog_of

PATH = "/-/esi/device/0xe5c/0x1/0x1"
IDENTITY = "0xe5c:1:1"


def section(db: Path, title: str, *words: str) -> list[list[str]]:
    """The cells of the lines below a title of the sheet, without the heading; two spaces part them."""
    lines = run("show", IDENTITY, *words, db=db).stdout.splitlines()
    start = next(number for number, line in enumerate(lines) if line.startswith(title)) + 2
    rows = lines[start : lines.index("", start) if "" in lines[start:] else None]
    return [[cell.strip() for cell in row.split("  ") if cell.strip()] for row in rows]


def init_cmd(index: str, data: str, comment: str, attributes: str = "", depend: str = "") -> str:
    return (
        f"<InitCmd {attributes}><Transition>PS</Transition><Index {depend}>{index}</Index><SubIndex>1</SubIndex>"
        f"<Data>{data}</Data><Comment>{comment}</Comment></InitCmd>"
    )


async def test_start_up_commands_are_told_as_they_are_sent(tmp_path):
    """ESI-FACTS 12, 12.1: 0x8001 is 0x8801 in slot 1; the marked 0x8801:01 of the device yields to it, 0x8000 stays."""
    own = init_cmd("#x8000", "02", "own", "OverwrittenByModule='1'")
    own += init_cmd("#x8801", "0100", "placeholder", "OverwrittenByModule='1'")
    slots = (
        "<Slots SlotIndexIncrement='#x800'><Slot MinInstances='0' MaxInstances='2'><Name>S</Name>"
        "<ModuleIdent>#x10</ModuleIdent></Slot></Slots>"
    )
    of_module = init_cmd("#x8001", "0500", "of the module", depend="DependOnSlot='1'")
    module = (
        f"<Module><Type ModuleIdent='#x10'>M</Type><Name>M</Name><Mailbox><CoE>{of_module}</CoE></Mailbox></Module>"
    )
    db = catalog_of(tmp_path, esi(device(f"<Mailbox><CoE>{own}</CoE></Mailbox>{slots}"), module))

    assert section(db, "InitCmds of the device") == [
        ["CoE", "PS", "0x8000:01", "02", "own"],
        ["CoE", "PS", "0x8801:01", "0100", "placeholder"],
    ]
    plugged = ("--module", "1=0x10")
    assert section(db, "InitCmds of the device", *plugged) == [["CoE", "PS", "0x8000:01", "02", "own"]]
    assert section(db, "InitCmds of the module in slot 1", *plugged) == [
        ["CoE", "PS", "0x8801:01", "0500", "of the module"]
    ]
    assert section(db, "  InitCmds of the module, indices without the offsets of a slot") == [
        ["CoE", "PS", "0x8001:01", "0500", "of the module"]
    ]

    tree = await page(db, f"{PATH}?module=1%3D0x10")
    commands = "section[aria-labelledby=commands]"
    assert texts(tree, f"{commands} tbody td:nth-child(3)") == ["0x8000:01", "0x8801:01"]
    assert texts(tree, f"{commands} h3") == ["Of the module in slot 1"]
    assert "Modules: indices without the offsets of a slot" in texts(tree, "section[aria-labelledby=pdos] > p")

    answer = json.loads(run("show", IDENTITY, *plugged, "--format", "json", db=db).stdout)
    assert [
        (item["slot"], item["protocol"], item["transitions"], item["target"], item["object_index"], item["data"])
        for item in answer["init_cmds"]
    ] == [(None, "CoE", ["PS"], "0x8000:01", 0x8000, "02"), (1, "CoE", ["PS"], "0x8801:01", 0x8801, "0500")]


async def test_a_device_whose_modules_alone_have_start_up_commands(data_db):
    """The example drive with two axes: mode 8 (CSP) of axis 0 by default, 9 (CSV) at 0x6060 + 0x800 of axis 1."""
    tree = await page(data_db, "/-/esi/device/0xe5c/0xa202/0x10002?module=1%3D0x10900")
    rows = "section[aria-labelledby=commands] tbody"
    assert texts(tree, f"{rows} td:nth-child(3)") == ["0x6060:00", "0x6860:00"]
    assert texts(tree, f"{rows} td:nth-child(4)") == ["08", "09"]
    assert texts(tree, "nav.toc a[href='#commands']") == ["Start-up commands"]
    idents = (
        "Module idents, slot by slot: 0x00010800, 0x00010900, expected in 0xF030 (configured; exports write it at PS)"
    )
    assert f"{idents} and 0xF050 (detected)" in texts(tree, "section[aria-labelledby=image] p")
    sheet = run("show", "0xe5c:0xa202:0x10002", "--module", "1=0x10900", db=data_db).stdout
    assert f"  {idents[0].lower()}{idents[1:]} and 0xF050 (detected)" in sheet.splitlines()
    assert "module idents" not in run("show", "0x1097:0x2406:0x8f", db=data_db).stdout, "it has no such objects"


SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm ControlByte='#x64'>Outputs</Sm><Sm ControlByte='#x20'>Inputs</Sm>"


async def test_a_predefined_assignment_that_is_marked_default_is_not_the_image(tmp_path):
    """EL2212: the PDOs' own Sm assigns 0x1602, the assignment that its file marks Default 0x1600."""
    mappings = "".join(
        f"<AlternativeSmMapping {mark}><Name>{name}</Name><Sm No='2'><Pdo>{pdo}</Pdo></Sm>"
        "<Sm No='3'><Pdo>#x1A00</Pdo></Sm></AlternativeSmMapping>"
        for name, mark, pdo in (("Standard", "Default='1'", "#x1600"), ("Extended", "", "#x1602"))
    )
    pdos = pdo("RxPdo", "#x1600", 8) + pdo("RxPdo", "#x1602", 8, attributes="Sm='2'")
    pdos += pdo("TxPdo", "#x1A00", 8, attributes="Sm='3'")
    info = f"<Info><VendorSpecific><TwinCAT>{mappings}</TwinCAT></VendorSpecific></Info>"
    differ = "the default process image and exports, which go by Sm of the PDOs and by OpMode, differ on SM2"
    marked = f"marked Default in the file; {differ}"
    db = catalog_of(tmp_path, esi(device(info + SMS + pdos)))
    assert section(db, "Predefined PDO assignments") == [
        ["Standard", "SM2: 0x1600; SM3: 0x1A00", marked],
        ["Extended", "SM2: 0x1602; SM3: 0x1A00"],
    ]
    assert texts(await page(db, PATH), "section[aria-labelledby=image] h3 + ul > li") == [
        f"Standard ({marked}): SM2 0x1600 SM3 0x1A00",
        "Extended: SM2 0x1602 SM3 0x1A00",
    ]

    unnamed = catalog_of(tmp_path / "unnamed", esi(device(info.replace("Standard", "") + SMS + pdos)))
    assert section(unnamed, "Predefined PDO assignments")[0][0] == "without name"
    same = catalog_of(tmp_path / "same", esi(device(info.replace("#x1600", "#x1602") + SMS + pdos)))
    assert section(same, "Predefined PDO assignments")[0][2] == "marked Default in the file"


async def test_flags_of_sync_managers_and_pdos(tmp_path):
    """Sm/@OpOnly beside the watchdog (ControlByte bit 6); OSFac 2: the image has two samples of the 24 bits."""
    sms = SMS.replace("<Sm ControlByte='#x64'>", "<Sm ControlByte='#x64' OpOnly='1'>")
    pdos = pdo("RxPdo", "#x1600", 8, attributes="Sm='2' Fixed='1'")
    pdos += pdo("TxPdo", "#x1A00", 24, attributes="Sm='3' OSFac='2'")
    db = catalog_of(tmp_path, esi(device(sms + pdos)))
    assert section(db, "Sync managers")[2][-1] == "watchdog OpOnly"
    assert [row[5] for row in section(db, "PDOs of the device")] == ["fixed", "OSFac 2"]
    tree = await page(db, PATH)
    flags = texts(tree, "section[aria-labelledby=sync-managers] tbody td:nth-child(7)")
    assert flags == ["", "", "watchdog OpOnly", ""]
    summaries = texts(tree, "section[aria-labelledby=pdos] summary .small")
    assert summaries == ["8 bits, SM2 by default, fixed", "24 bits, SM3 by default, OSFac 2"]
    assert texts(tree, "section[aria-labelledby=image] h3")[1] == "SM3 Inputs: 6 bytes (48 bits)"


async def test_a_pdo_that_yields_to_a_module_is_marked_and_says_which_sync_manager_it_names(tmp_path):
    """ESI-FACTS 12: the module that is plugged by default brings 0x1600 itself; 0x1601 has no such PDO to yield to."""
    slots = "<Slots><Slot MinInstances='1' MaxInstances='1'><Name>S</Name><ModuleIdent Default='1'>#x10</ModuleIdent>"
    pdos = pdo("RxPdo", "#x1600", 8, attributes="Sm='2' Fixed='1' OverwrittenByModule='1'")
    pdos += pdo("RxPdo", "#x1601", 8, attributes="Sm='2' OverwrittenByModule='1'")
    of_module = pdo("RxPdo", "#x1600", 16, attributes="Sm='2'")
    module = f"<Module><Type ModuleIdent='#x10'>M</Type><Name>M</Name>{of_module}</Module>"
    db = catalog_of(tmp_path, esi(device(f"{SMS}{pdos}{slots}</Slot></Slots>"), module))
    assert [(row[2], row[5]) for row in section(db, "PDOs of the device")] == [
        ("no (Sm 2 in the file)", "fixed, overwritten by module"),
        ("SM2", "overwritten by module"),
    ]
    assert texts(await page(db, PATH), "section[aria-labelledby=pdos] > details > summary .small")[:2] == [
        "8 bits, not assigned by default (Sm 2 in the file), fixed, overwritten by module",
        "8 bits, SM2 by default, overwritten by module",
    ]


async def test_a_direction_that_the_control_byte_gives_is_told_beside_the_role(tmp_path):
    """Bits 3:2 of 0x20 are 00: the master reads, and the TxPdo says the same."""
    sms = SMS.replace("<Sm ControlByte='#x64'>", "<Sm ControlByte='#x20'>")
    db = catalog_of(tmp_path, esi(device(sms + pdo("TxPdo", "#x1A00", 8, attributes="Sm='2'"))))
    title = "SM2 Outputs (runs as input, by its ControlByte): 1 byte (8 bits)"
    assert f"Default process image, {title}" in run("show", IDENTITY, db=db).stdout.splitlines()
    headings = texts(await page(db, PATH), "section[aria-labelledby=image] h3")
    assert headings == [title, "SM3 Inputs: 0 bytes (0 bits)"]


async def test_an_axis_of_which_nothing_says_its_modes_is_unknown(tmp_path):
    """docs/drive-modes.md, rank F: profile number 402, and neither objects nor PDOs of CiA 402."""
    content = "<Profile><ProfileNo>402</ProfileNo></Profile>" + SMS + pdo("RxPdo", "#x1600", 16, attributes="Sm='2'")
    db = catalog_of(tmp_path, esi(device(content)))
    words = "profile number 402, but nothing says which modes"
    assert section(db, "Drive modes") == [["axis 0", "unknown", words]]
    tree = await page(db, PATH)
    assert texts(tree, "nav.toc a[href='#modes']") == ["Drive modes"]
    assert texts(tree, "section[aria-labelledby=modes] > .scroll tbody td") == ["0", "", "unknown", words, ""]


async def test_what_is_generated_of_the_whole_description_is_told_apart(tmp_path):
    """EEPROM images and ESI documents depend on no choice."""
    tree = await page(catalog_of(tmp_path, esi(device(SMS + pdo("TxPdo", "#x1A00", 8, attributes="Sm='3'")))), PATH)
    words = texts(tree, "section[aria-labelledby=exports] > p")[0]
    assert words.startswith("For the default PDOs; EEPROM image and ESI XML: the description as a whole")
