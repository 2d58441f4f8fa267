"""PDOs and objects that a master listed beside a scan: what is assigned is exchanged, and what fits is taken."""

import json

import pytest
from snippets import device, dictionary, esi, pdo
from test_cli import run
from test_search import catalog_of

SLAVE = "vendor,product,revision\n0xe5c,1,1\n"
TYPES = "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
OBJECT = (
    "<Object><Index>#x{:X}</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize>"
    "<Flags><Access>rw</Access></Flags></Object>"
)
NO_DICTIONARY = "has no dictionary of the device itself"


def objects(count: int) -> str:
    return dictionary(TYPES, "".join(map(OBJECT.format, range(0x2000, 0x2000 + count))))


def printed(count: int) -> str:
    """Objects as ``ethercat sdos`` prints them."""
    return "".join(
        f'SDO 0x{index:04x}, "O"\n  0x{index:04x}:00, rwrwrw, uint16, 16 bit, "O"\n'
        for index in range(0x2000, 0x2000 + count)
    )


def answered(db, folder, option: str, text: str, scan: str = SLAVE):
    (folder / "list.txt").write_text(text)
    words = ("--slaves", "-", option, folder / "list.txt", "--format", "json")
    (found,) = json.loads(run("identify", *words, db=db, stdin=scan).stdout)
    return found


def test_what_describes_no_objects_fits_them_last(tmp_path):
    """Of 20 described objects the device has 19; the other description says nothing of any."""
    db = catalog_of(tmp_path, esi(device(type_text="SILENT")), esi(device(objects(20), type_text="TELLS")))
    found = answered(db, tmp_path, "--sdos", printed(19))
    assert found["device"]["type"] == "TELLS"
    assert found["slave"]["differences"] == ["0x2013: described, but not on the device"]
    ours, other = found["device"]["variant"], {1: 2, 2: 1}[found["device"]["variant"]]
    assert found["slave"]["notes"] == [
        f"variant {ours} of 2 is taken: of the others no objects are described",
        f"objects not compared: the description of variant {other} {NO_DICTIONARY}",
    ]


def test_lists_without_entries_are_no_lists_of_nothing(tmp_path):
    """``--quiet`` prints objects and PDOs alone: 0x2001 is missing, entries and mappings are not told."""
    db = catalog_of(tmp_path, esi(device(DESCRIBED + objects(2))))
    found = answered(db, tmp_path, "--sdos", 'SDO 0x2000, "O"\n')["slave"]
    assert found["differences"] == ["0x2001: described, but not on the device"]
    assert found["notes"] == ["objects are listed without entries: only their indices are compared"]
    quiet = "".join(line + "\n" for line in PDOS.splitlines() if "PDO entry" not in line)
    found = answered(db, tmp_path, "--pdos", quiet.replace("0x1602", "0x1600"))["slave"]
    assert [text for text in found["differences"] if "RxPDO" in text or text.startswith("SM2")] == []
    assert (found["output_bytes"], found["input_bytes"]) == (2, 2)
    assert found["notes"] == [
        "PDOs are listed without entries: mappings are not compared, bytes are those described by default"
    ]


def test_a_list_that_is_not_understood_in_full_is_not_compared(tmp_path):
    db = catalog_of(tmp_path, esi(device(DESCRIBED)))
    found = answered(db, tmp_path, "--pdos", PDOS.replace("0x60ff:00, 32 bit", "0x60ff[ 12.1] EtherCAT 0: x"))["slave"]
    assert (found["differences"], found["output_bytes"], found["input_bytes"]) == ([], 2, 2)
    assert found["notes"] == ["PDOs not compared: their list was not understood in full"]
    db = catalog_of(tmp_path / "objects", esi(device(objects(3))))
    found = answered(db, tmp_path, "--sdos", printed(3).replace("SDO 0x2001, ", "SDO 0x2001[ 12.1] x"))["slave"]
    assert (found["differences"], found["notes"]) == (
        [],
        ["objects not compared: their list was not understood in full"],
    )


def test_of_those_that_describe_objects_the_best_is_named(tmp_path):
    db = catalog_of(tmp_path, *(esi(device(content)) for content in ("", objects(20), objects(19))))
    found = answered(db, tmp_path, "--sdos", printed(19))
    assert found["slave"]["differences"] == []
    ours = found["device"]["variant"]
    assert found["slave"]["notes"][0] == f"variant {ours} of 3 fits its objects best"
    assert found["slave"]["notes"][1].endswith(NO_DICTIONARY)


MODULE = '<Module><Type ModuleIdent="1">M</Type><Name>M</Name>' + dictionary(TYPES, OBJECT.format(0x7000)) + "</Module>"
SLOT = "<Slots><Slot MinInstances='0' MaxInstances='1'><ModuleIdent>1</ModuleIdent></Slot></Slots>"


@pytest.mark.parametrize(("content", "modules"), [("", ""), (SLOT, MODULE)], ids=["none", "in a module"])
def test_objects_that_cannot_be_compared_are_told(tmp_path, content, modules):
    db = catalog_of(tmp_path, esi(device(content), modules))
    found = answered(db, tmp_path, "--sdos", printed(1))
    assert found["slave"]["differences"] == []
    assert found["slave"]["notes"] == [f"objects not compared: the description {NO_DICTIONARY}"]


def test_no_variant_fits_what_none_describes(tmp_path):
    db = catalog_of(tmp_path, esi(device(type_text="A")), esi(device(type_text="B")))
    found = answered(db, tmp_path, "--sdos", printed(1))
    assert found["slave"]["notes"] == [f"objects not compared: the description of variant 1, 2 {NO_DICTIONARY}"]


PDOS = """\
SM0: PhysAddr 0x1000, DefaultSize  128, ControlRegister 0x26, Enable 1
SM1: PhysAddr 0x1080, DefaultSize  128, ControlRegister 0x22, Enable 1
SM2: PhysAddr 0x1200, DefaultSize    0, ControlRegister 0x64, Enable 1
  RxPDO 0x1602 "R"
    PDO entry 0x6040:00, 16 bit, "Control word"
    PDO entry 0x60ff:00, 32 bit, "Target velocity"
    PDO entry 0x0000:00,  7 bit, ""
SM3: PhysAddr 0x1400, DefaultSize    0, ControlRegister 0x20, Enable 1
"""
DESCRIBED = (
    "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"
    + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"')
    + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"')
)


def test_the_bytes_are_those_of_the_listed_pdos(tmp_path):
    """16, 32 and 7 bits are 7 bytes; the inputs have no PDO."""
    db = catalog_of(tmp_path, esi(device(DESCRIBED)))
    found = answered(db, tmp_path, "--pdos", PDOS)
    assert "SM2: assigned are 0x1602; the default is 0x1600" in found["slave"]["differences"]
    assert (found["slave"]["output_bytes"], found["slave"]["input_bytes"]) == (7, 0)
    assert found["slave"]["notes"] == [
        "bytes out: 7 configured, 2 in the default process image of the description",
        "bytes in: 0 configured, 2 in the default process image of the description",
    ]
    unknown = answered(db, tmp_path, "--pdos", PDOS, SLAVE.replace("0xe5c", "0xe5d"))
    assert (unknown["slave"]["output_bytes"], unknown["slave"]["input_bytes"]) == (7, 0)
