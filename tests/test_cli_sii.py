"""esicatalog sii: a sheet and JSON of an EEPROM image, and the image against its description."""

import json
from pathlib import Path

import pytest
from sii.by_hand import WHOLE
from snippets import device, esi, only_device, pdo
from test_cli import one_line_error, run
from test_identify import SLAVES
from test_search import catalog_of
from test_sii_files import without_lines

from esicatalog import Catalog
from esicatalog.export.sii import sii_image
from esicatalog.sii.encode import encode_sii


def test_sheet_and_json(tmp_path):
    (tmp_path / "dump.bin").write_bytes(WHOLE)
    sheet = run("sii", "decode", str(tmp_path / "dump.bin")).stdout
    assert "Sync managers" in sheet
    found = json.loads(run("sii", "decode", str(tmp_path / "dump.bin"), "--format", "json").stdout)
    assert f"0x{found['header']['vendor_id']:08x}" in sheet
    assert found["header"]["checksum"] == WHOLE[14]


def test_what_is_no_image_is_one_line(tmp_path):
    (tmp_path / "short.bin").write_bytes(b"\1\2\3")
    for words in (("sii", "decode"), ("sii", "verify"), ("identify", "--sii"), ("export", "cstruct", "--sii")):
        line = one_line_error(run(*words, tmp_path / "short.bin"))
        assert line.startswith(f"esicatalog: {tmp_path / 'short.bin'}: no SII image: its length in bytes is 3;")
    assert "No such file" in one_line_error(run("sii", "decode", str(tmp_path / "missing.bin")))


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_a_text_is_no_image(tmp_path, encoding):
    (tmp_path / "slaves.txt").write_bytes(("\x1b[1m" + SLAVES + "  Device name: 1 \u00b5s\r\n").encode(encoding))
    for words in (("sii", "decode"), ("sii", "verify"), ("identify", "--sii"), ("export", "cstruct", "--sii")):
        line = one_line_error(run(*words, tmp_path / "slaves.txt"))
        begins = f"esicatalog: {tmp_path / 'slaves.txt'}: a text, no SII image; it begins with "
        assert line.startswith(begins), line
        assert "=== Master 0, Slave 0 ===" in line


def test_what_an_intel_hex_file_leaves_out_is_told_everywhere(tmp_path):
    """It would be taken for the device's own by a merge, which is refused."""
    db = catalog_of(tmp_path, esi(device(DEVICE)))
    data = dump_of(tmp_path, DEVICE).read_bytes()
    (tmp_path / "lost.hex").write_bytes(without_lines(data, 0x40))
    told = "the file does not hold the bytes 0x40 to 0x4F: 0xFF stands in their place"
    for command in (("sii", "decode"), ("sii", "verify"), ("identify", "--sii")):
        assert told in run(*command, tmp_path / "lost.hex", db=None if "decode" in command else db).stdout
    assert told in run("export", "cstruct", "--sii", tmp_path / "lost.hex").stderr
    refused = run("export", "sii", "0xe5c:1:1", "--merge", tmp_path / "lost.hex", "-o", tmp_path / "made.bin", db=db)
    assert "the dump does not hold the bytes 0x40 to 0x4F" in one_line_error(refused)
    assert not (tmp_path / "made.bin").exists()


DEVICE = (
    "<Fmmu>Outputs</Fmmu><Sm StartAddress='#x1000' ControlByte='#x44' Enable='1' DefaultSize='2'>Outputs</Sm>"
    + pdo("RxPdo", "#x1600", 8, 8, attributes='Sm="0"')
    + "<Eeprom><ByteSize>256</ByteSize><ConfigData>8003006E6400</ConfigData></Eeprom>"
)


def dump_of(tmp_path, content: str, revision: str = "#x1"):
    """An image made for a description; what the encoder makes is compared with real dumps elsewhere."""
    image = sii_image(0xE5C, None, only_device(esi(device(content, revision=revision))))
    (tmp_path / "dump.bin").write_bytes(encode_sii(image))
    return tmp_path / "dump.bin"


def test_verify_agrees_and_differs(tmp_path):
    db = catalog_of(tmp_path, esi(device(DEVICE)))
    same = run("sii", "verify", dump_of(tmp_path, DEVICE), db=db)
    assert (same.exit_code, same.stdout.splitlines()[-1].split(",")[1].split()[0]) == (0, "0")
    other = run("sii", "verify", dump_of(tmp_path, DEVICE.replace("#x44", "#x64")), db=db)
    assert other.exit_code == 1
    assert (
        "  ! SyncManagers: SM0: the image has Outputs at 0x1000, 2 bytes, control 0x64, enable 0x01; "
        "described is Outputs at 0x1000, 2 bytes, control 0x44, enable 0x01"
    ) in other.stdout.splitlines()
    found = json.loads(run("sii", "verify", tmp_path / "dump.bin", "--format", "json", db=db).stdout)
    assert (found["agrees"], found["differences"][0]["part"]) == (False, "SyncManagers")


def every_identity(db: Path) -> list[str]:
    with Catalog.open(db) as catalog:
        return [found.identity_text for found in catalog.devices(all_variants=True, include_hidden=True)]


def differences_of_exports(db: Path, tmp_path: Path) -> dict[str, str]:
    """What verify says last about the image of each description."""
    told = {}
    for identity in every_identity(db):
        assert run("export", "sii", identity, "-o", tmp_path / "e.bin", db=db).exit_code == 0
        told[identity] = run("sii", "verify", tmp_path / "e.bin", db=db).stdout.splitlines()[-1]
    return told


def test_an_exported_image_is_as_described(data_db, tmp_path):
    told = differences_of_exports(data_db, tmp_path)
    assert len(told) == 6
    assert set(told.values()) == {"0 differences, 0 in what a master uses (marked !)"}


def test_of_variants_that_differ_in_names_the_right_one_counts(tmp_path):
    db = catalog_of(tmp_path, *(esi(device(DEVICE.replace("e1", name))) for name in ("x1", "y1")))
    told = differences_of_exports(db, tmp_path)
    assert len(told) == 2
    assert set(told.values()) == {"0 differences, 0 in what a master uses (marked !)"}


def test_names_alone_do_not_count(tmp_path):
    db = catalog_of(tmp_path, esi(device(DEVICE)))
    renamed = dump_of(tmp_path, DEVICE.replace("e1", "another name"))
    done = run("sii", "verify", renamed, db=db)
    assert (done.exit_code, "another name" in done.stdout) == (0, True)


def test_a_wrong_check_sum_is_a_difference_that_counts(tmp_path):
    """With it a slave controller does not take PDI and mailbox words; 0x88A4 switches the test off."""
    db = catalog_of(tmp_path, esi(device(DEVICE)))
    dump = dump_of(tmp_path, DEVICE)
    right = dump.read_bytes()
    dump.write_bytes(right[:14] + bytes([right[14] ^ 0xFF, 0]) + right[16:])
    done = run("sii", "verify", dump, db=db)
    assert done.exit_code == 1
    assert "  ! check sum: wrong: a slave controller refuses the configuration words" in done.stdout.splitlines()
    assert done.stdout.splitlines()[-1] == "2 differences, 1 in what a master uses (marked !)"
    identified = run("identify", "--sii", dump, db=db)
    assert identified.exit_code == 0
    assert identified.stdout.splitlines()[1].startswith("image: check sum at byte 0xE is")
    found = json.loads(run("identify", "--sii", dump, "--format", "json", db=db).stdout)
    assert (found["match"], len(found["image"]["findings"])) == ("exact", 1)
    dump.write_bytes(right[:14] + b"\xa4\x88" + right[16:])
    untested = run("sii", "verify", dump, db=db)
    assert (untested.exit_code, "0x88A4, with which it is not tested" in untested.stdout) == (0, True)


def test_what_is_odd_about_an_image_is_told_without_its_description(tmp_path):
    db = catalog_of(tmp_path, esi(device(DEVICE)))
    dump = dump_of(tmp_path, DEVICE, revision="#x2")
    dump.write_bytes(b"\0" + dump.read_bytes()[1:])
    assert "  image: check sum at byte 0xE is" in run("sii", "verify", dump, db=db).stdout


def test_another_revision_is_not_compared(tmp_path):
    db = catalog_of(tmp_path, esi(device(DEVICE)))
    done = run("sii", "verify", dump_of(tmp_path, DEVICE, revision="#x2"), db=db)
    assert done.exit_code == 1
    assert done.stdout.startswith("not compared: no exact ESI")


BARE = (
    "<Sm StartAddress='#x1000' Enable='1'>Outputs</Sm><Sm>Inputs</Sm>"
    "<Dc><OpMode><Name>SM</Name><AssignActivate>0</AssignActivate></OpMode>"
    "<OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>"
)
"""No Eeprom, no ControlByte, no CycleTimeSync0."""
SAID = (
    "<Sm StartAddress='#x1000' Enable='1' ControlByte='#x64' DefaultSize='2'>Outputs</Sm>"
    "<Sm StartAddress='#x1100' Enable='1' ControlByte='#x20'>Inputs</Sm>"
    "<Dc><OpMode><Name>SM</Name><AssignActivate>0</AssignActivate>"
    "<CycleTimeSync0 Factor='0'>0</CycleTimeSync0></OpMode>"
    "<OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate>"
    "<CycleTimeSync0 Factor='0'>0</CycleTimeSync0></OpMode>"
    "</Dc><Eeprom><ByteSize>4096</ByteSize><ConfigData>8003006E6400</ConfigData><BootStrap>0010000100110001</BootStrap>"
    "</Eeprom>"
)
"""The same with what a tool fills in."""


def values_that_differ(dump: Path, db: Path) -> list[str]:
    """What verify tells, but for texts: :func:`dump_of` knows no name of the group."""
    found = json.loads(run("sii", "verify", dump, "--format", "json", db=db).stdout)
    return [item["text"] for item in found["differences"] if item["part"] != "texts"]


def test_what_the_description_does_not_say_is_no_difference(tmp_path):
    db = catalog_of(tmp_path, esi(device(BARE)))
    dump = dump_of(tmp_path, SAID)
    data = bytearray(dump.read_bytes())
    data[0x40:0x44] = b"own!"
    dump.write_bytes(data)
    assert values_that_differ(dump, db) == []
    assert run("sii", "verify", dump, db=db).exit_code == 0


@pytest.mark.parametrize(
    ("said", "other", "line"),
    [
        ("4096", "2048", "size word: the image has 31; described is 15"),
        ("8003006E6400", "8004006E6400", "PDI control: the image has 0x0380; described is 0x0480"),
        ("0010000100110001", "0010000200110001", "bytes of the bootstrap receive mailbox: the image has 256; "),
        ("#x64", "#x44", "SM0: the image has Outputs at 0x1000, 2 bytes, control 0x64"),
        ("#x300</AssignActivate><CycleTimeSync0 Factor='0'", "#x300</AssignActivate><CycleTimeSync0 Factor='1'",
         "OpMode 2: the image has AssignActivate 0x0300, SYNC0 cycle 0 ns factor 0"),
        ("<Eeprom>", "<Eeprom><Category><CatNo>3</CatNo><Data>AABB</Data></Category>",
         "category 3 (device specific): not in the image; described is aa bb"),
    ],
)  # fmt: skip
def test_what_the_description_says_is_compared(tmp_path, said, other, line):
    db = catalog_of(tmp_path, esi(device(SAID.replace(said, other))))
    (told,) = values_that_differ(dump_of(tmp_path, SAID), db)
    assert told.startswith(line)


def test_general_flags_and_coe_details_count(tmp_path):
    mailbox = "<Mailbox><CoE SdoInfo='1'/></Mailbox>"
    db = catalog_of(tmp_path, esi(device(mailbox)))
    done = run("sii", "verify", dump_of(tmp_path, mailbox.replace("SdoInfo", "PdoAssign")), db=db)
    assert (done.exit_code, "  ! General: CoE: the image has SDO, PDO assign; described is SDO" in done.stdout) == (
        1,
        True,
    )
    assert "CoE details" in run("sii", "verify", "--help").stdout


BROKEN = [
    (30, bytes(16), "category 30 (General): the image has 00 00"),
    (30, bytes(34), "category 30 (General), bytes of no whole record: the image has 00 00"),
    (41, bytes(10), "category 41 (SyncM), bytes of no whole record: the image has 00 00"),
    # A PDO that announces 5 entries, of which one is there.
    (
        50,
        bytes.fromhex("001a050300001100") + bytes(8),
        "category 50 (TxPDO), bytes of no whole record: the image has 00 1a",
    ),
    (
        51,
        bytes.fromhex("0016050300001100") + bytes(8),
        "category 51 (RxPDO), bytes of no whole record: the image has 00 16",
    ),
    (60, bytes(20), "category 60 (DC), bytes of no whole record: the image has 00 00"),
]


@pytest.mark.parametrize(("kind", "data", "words"), BROKEN)
def test_a_category_that_a_master_cannot_read_is_a_difference_that_counts(tmp_path, kind, data, words):
    """IgH refuses a General that is not 32 bytes, and lists whose records do not fill them."""
    dump = dump_of(tmp_path, "")
    image = dump.read_bytes()
    head = kind.to_bytes(2, "little") + (len(data) // 2).to_bytes(2, "little")
    dump.write_bytes(image[:128] + head + data + b"\xff\xff")
    done = run("sii", "verify", dump, db=catalog_of(tmp_path, esi(device())))
    assert done.exit_code == 1
    assert any(line.startswith("  ! ") and words in line for line in done.stdout.splitlines()), done.stdout


def test_a_category_that_no_master_reads_does_not_count(tmp_path):
    dump = dump_of(tmp_path, "")
    dump.write_bytes(dump.read_bytes()[:128] + bytes.fromhex("03000100aabb") + b"\xff\xff")
    done = run("sii", "verify", dump, db=catalog_of(tmp_path, esi(device())))
    lines = [line for line in done.stdout.splitlines() if "category 3 " in line]
    assert (done.exit_code, lines[0].startswith("    other categories: ")) == (0, True)


def test_an_image_in_the_description_that_is_none_is_not_that_of_the_user(tmp_path):
    db = catalog_of(tmp_path, esi(device("<Eeprom><Data>0011</Data></Eeprom>")))
    dump = dump_of(tmp_path, DEVICE)
    words = ("Eeprom/Data of T1 (0.xml, line 1): no SII image", "its length in bytes is 2")
    for command in (("sii", "verify", dump), ("export", "sii", "0xe5c:1:1")):
        line = one_line_error(run(*command, db=db))
        assert all(part in line for part in words), line


def test_a_variant_with_an_image_that_is_none_is_left_out(tmp_path):
    """Of two descriptions of the identity one holds two bytes as its image; the other one fits."""
    broken = esi(device("<Eeprom><Data>0011</Data></Eeprom>" + pdo("RxPdo", "#x1600", *[8] * 9)))
    db = catalog_of(tmp_path, broken, esi(device(DEVICE)))
    done = run("sii", "verify", dump_of(tmp_path, DEVICE), db=db)
    assert done.exit_code == 0
    (left_out,) = (line for line in done.stdout.splitlines() if "left out" in line)
    assert "Eeprom/Data of T1 (0.xml, line 1): no SII image: its length in bytes is 2" in left_out
    found = json.loads(run("sii", "verify", tmp_path / "dump.bin", "--format", "json", db=db).stdout)
    assert (found["agrees"], len(found["unusable"])) == (True, 1)


@pytest.mark.corpus
def test_real_dumps_agree_with_their_descriptions(corpus, tmp_path):
    """EK1100 and EL2004: sync managers, FMMUs, PDO layout and the rest that a master uses."""
    archive = corpus / "esi" / "DiamondLightSource+ethercat.zip"
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([archive, corpus / "esi" / "DiamondLightSource+ethercat-history.zip"])
    for name in ("*ek1100.hex", "*(EL2004).bin"):
        (dump,) = (corpus / "sii").rglob(name)
        done = run("sii", "verify", dump, db=tmp_path / "c.db")
        assert (done.exit_code, "0 in what a master uses" in done.stdout) == (0, True), done.stdout


@pytest.mark.corpus
def test_real_dumps_of_another_tool_agree(corpus, tmp_path):
    """EasyCAT examples: their tool stores factor 0 where a description gives no CycleTimeSync0."""
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([corpus / "esi" / "dslemusp+EasyCAT.zip"])
    for name in ("LAB_1", "LAB_2", "DemoHMI_Custom", "TestEasyCAT_Custom", "myCustomSlave"):
        (dump,) = (corpus / "sii").rglob(f"examples__{name}__{name}.bin")
        done = run("sii", "verify", dump, db=tmp_path / "c.db")
        assert (done.exit_code, "0 in what a master uses" in done.stdout) == (0, True), done.stdout
