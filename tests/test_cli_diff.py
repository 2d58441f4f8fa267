"""esicatalog diff: text, JSON and exit codes, from a catalog and from two files."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner
from snippets import device, dictionary, esi, pdo, write

from esicatalog import Catalog
from esicatalog.cli.diff import command

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"
OLD = SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
NEW = SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"')


def run(*words: object, db: Path | None = None):
    arguments = [str(word) for word in words] + (["--db", str(db)] if db is not None else [])
    return CliRunner().invoke(command, arguments, catch_exceptions=False)


def files(folder: Path, left: str, right: str) -> tuple[Path, Path]:
    write(folder, {"a.xml": left, "b.xml": right})
    return folder / "a.xml", folder / "b.xml"


@pytest.fixture
def two_revisions(tmp_path):
    document = esi(device(OLD, revision="1", name="Old") + device(NEW, revision="2", name="New"))
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([write(tmp_path / "in", {"both.xml": document})], jobs=1)
    return tmp_path / "c.db"


def test_two_revisions_of_a_catalog(two_revisions):
    done = run("0xE5C:1:1", "0xE5C:1:2", db=two_revisions)
    assert (done.exit_code, done.stderr) == (1, "")
    assert done.stdout.splitlines() == [
        "left   0x00000e5c:0x00000001:0x00000001  T1, Old  (both.xml, line 1)",
        "right  0x00000e5c:0x00000001:0x00000002  T1, New  (both.xml, line 1)",
        "       whether a master configured for 0x00000001 takes 0x00000002 is its own choice: no CheckRevisionNo",
        "",
        "Identity",
        "  ! revision  0x00000001 -> 0x00000002",
        "",
        "General",
        "    name  Old -> New",
        "",
        "PDO",
        "  ! RxPDO 0x1600 entry 1  0x7000:01 (8 bit) e1 -> 0x7000:01 (16 bit) e1",
        "",
        "Process image",
        "  ! SM2 size    1 byte (8 bits) -> 2 bytes (16 bits)",
        "  ! SM2 at 0.0  0x7000:01 (8 bit) e1 -> 0x7000:01 (16 bit) e1",
        "",
        "! counts: a master's configuration made for the left device may not fit the right one",
        "5 differences, 4 count for a master: 1 identity, 1 PDO, 2 process image",
    ]


def test_json_alone_on_stdout(two_revisions):
    done = run("0xE5C:1:1", "0xE5C:1", "--format", "json", db=two_revisions)
    answer = json.loads(done.stdout)
    assert answer.keys() == {"pairs", "only_left", "only_right", "summary"}
    (pair,) = answer["pairs"]
    assert (pair["left"]["revision_no"], pair["right"]["revision_no"]) == (1, 2)
    assert pair["left"].items() >= {"vendor_id_hex": "0x00000e5c", "variant": 1, "type": "T1", "name": "Old"}.items()
    assert pair["right"]["source"] == "both.xml, line 1"
    assert pair["counting"] == sum(item["counts"] for item in pair["differences"]) == 4
    assert pair["differences"][0] == {
        "area": "identity",
        "place": "revision",
        "kind": "changed",
        "left": "0x00000001",
        "right": "0x00000002",
        "counts": True,
        "module": None,
    }


def test_one_device_with_itself(two_revisions):
    done = run("0xE5C:1:1", "0xE5C:1:1", db=two_revisions)
    assert (done.exit_code, done.stdout.splitlines()[-1]) == (0, "no differences")


@pytest.mark.parametrize(("entries", "is_first"), [(5, False), (60, True)])
def test_the_summary_stands_before_a_long_list_too(tmp_path, entries, is_first):
    """Each entry of the PDO is 8 bits long, then 16."""
    texts = [esi(device(SMS + pdo("RxPdo", "#x1600", *[bits] * entries, attributes='Sm="2"'))) for bits in (8, 16)]
    lines = run("--esi", *files(tmp_path, *texts)).stdout.splitlines()
    assert (lines[0] == lines[-1]) is is_first
    assert lines[2 * is_first].startswith("left ")


def test_a_device_that_is_not_in_the_catalog(two_revisions):
    done = run("0xE5C:1:1", "0xE5C:9", db=two_revisions)
    assert (done.exit_code, done.stdout) == (1, "")
    assert len(done.stderr.splitlines()) == 1


def test_differences_that_do_not_count(tmp_path):
    done = run("--esi", *files(tmp_path, esi(device(OLD, name="A")), esi(device(OLD, name="B"))))
    assert done.exit_code == 0
    assert done.stdout.splitlines()[-1] == (
        "1 difference, none counts for a master; the default process image is the same"
    )


def test_what_nobody_knows_is_not_called_the_same(tmp_path):
    """One required slot, two alternative modules, no preset: which of them is there decides how long the image is."""
    slot = '<Slots><Slot MinInstances="1" MaxInstances="1"><ModuleIdent>1</ModuleIdent><ModuleIdent>2</ModuleIdent>'
    module = '<Module><Type ModuleIdent="{0}">M{0}</Type><Name>M{0}</Name>{1}</Module>'
    modules = "".join(module.format(n, pdo("RxPdo", f"#x160{n}", 8 * n, attributes='Sm="2"')) for n in (1, 2))
    texts = [esi(device(f"{SMS}{slot}</Slot></Slots>", name=name), modules) for name in "AB"]
    done = run("--esi", *files(tmp_path, *texts))
    assert done.stdout.splitlines()[-1] == (
        "1 difference, none counts for a master; the default process image is the same as far as it is described"
    )


def test_no_catalog_is_opened_for_files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = run("--esi", *files(tmp_path, esi(device(OLD)), esi(device(NEW))), db=tmp_path / "none.db")
    assert done.exit_code == 1
    assert not list(tmp_path.glob("*.db"))


def test_files_with_several_devices(tmp_path):
    left = device(OLD, product="1") + device(OLD, product="2") + device(product="3", name="Gone")
    right = device(OLD, product="1") + device(NEW, product="2") + device(product="4", name="Come")
    done = run("--esi", *files(tmp_path, esi(left), esi(right)))
    lines = done.stdout.splitlines()
    assert done.exit_code == 1
    assert [line.split()[1] for line in lines if line.startswith("left")] == ["0x00000e5c:0x00000002:0x00000001"]
    for title, name in (("Only in the left file", "Gone"), ("Only in the right file", "Come")):
        assert f"T1, {name}" in lines[lines.index(title) + 1]
    assert lines[-1] == (
        "2 devices compared, 1 without difference, 1 only in the left file, 1 only in the right file: "
        "3 differences, 3 count for a master: 1 PDO, 2 process image"
    )


def test_a_device_more_is_no_reason_to_say_no(tmp_path):
    one, two = device(OLD, product="1"), device(OLD, product="2")
    assert run("--esi", *files(tmp_path, esi(one), esi(one + two))).exit_code == 0
    done = run("--esi", *files(tmp_path, esi(one + two), esi(one)))
    assert done.exit_code == 1
    assert done.stdout.splitlines()[-1] == (
        "1 device compared, 1 without difference, 1 only in the left file: no differences"
    )


def test_modules_have_sections_of_their_own(tmp_path):
    slots = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>7</ModuleIdent></Slot></Slots>'
    modules = [
        f'<Module><Type ModuleIdent="7">M</Type><Name>M</Name>{pdo("TxPdo", "#x1A00", bits)}</Module>'
        for bits in (8, 9)
    ]
    left, right = (esi(device(SMS + slots), module) for module in modules)
    lines = run("--esi", *files(tmp_path, left, right)).stdout.splitlines()
    assert lines[lines.index("module 0x00000007: PDO") + 1] == (
        "  ! TxPDO 0x1A00 entry 1  0x7000:01 (8 bit) e1 -> 0x7000:01 (9 bit) e1"
    )


def assigned(last: str) -> str:
    """An OpMode with a list of eleven PDOs: more than a line shows of a value."""
    indices = [*(f"#x1A{number:02X}" for number in range(10)), last]
    pdos = "".join(f"<Pdo>{index}</Pdo>" for index in indices)
    return f'<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate><Sm No="3">{pdos}</Sm></OpMode></Dc>'


def test_long_values_show_where_they_differ(tmp_path):
    done = run("--esi", *files(tmp_path, esi(device(assigned("#x1A0A"))), esi(device(assigned("#x1A0B")))))
    (line,) = [line for line in done.stdout.splitlines() if "PDOs" in line]
    left, right = line.split("PDOs")[1].split(" -> ")
    assert left.endswith("0x1A0A")
    assert right.endswith("0x1A0B")


def test_blanks_of_a_default_text_count_and_are_shown(tmp_path):
    types = "<DataType><Name>STRING(4)</Name><BitSize>32</BitSize></DataType>"
    declared = (
        "<Object><Index>#x1008</Index><Name>O</Name><Type>STRING(4)</Type><BitSize>32</BitSize>"
        "<Info><DefaultData>{}</DefaultData></Info></Object>"
    )
    left, right = (esi(device(dictionary(types, declared.format(data)))) for data in ("61202062", "61206200"))
    done = run("--esi", *files(tmp_path, left, right))
    assert '"a  b" -> "a b"' in done.stdout


def test_what_is_missing_from_a_file_is_told(tmp_path):
    profile = "<Profile><ProfileNo>402</ProfileNo><DictionaryFile>none.xml</DictionaryFile></Profile>"
    done = run("--esi", *files(tmp_path, esi(device(profile)), esi(device(profile))), "--format", "json")
    assert done.exit_code == 0
    assert len(json.loads(done.stdout)["pairs"]) == 1
    assert [line.partition(": ")[2] for line in done.stderr.splitlines()] == [
        "DictionaryFile 'none.xml' was not found beside the document"
    ] * 2


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ((), "say what to compare: IDENTITY IDENTITY, or --esi A B"),
        (("1:1",), "say what to compare"),
        (("1:1", "1:2", "1:3"), "say what to compare"),
        (("1:1", "1:2", "--esi", "a.xml", "a.xml"), "give only one of IDENTITY IDENTITY, or --esi A B"),
        (("1:x", "1:2"), "product 'x' is not a number"),
        (("--esi", "a.xml", "missing.xml"), "missing.xml: no such file"),
        (("--esi", "a.xml", "text.xml"), "text.xml: no XML document"),
        (("--esi", "a.xml", "empty.xml"), "empty.xml: the file is empty"),
        (("--esi", "none.xml", "a.xml"), "none.xml: describes no device"),
    ],
)
def test_wrong_usage_is_one_line(tmp_path, monkeypatch, words, message):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, {"a.xml": esi(device()), "text.xml": "text", "empty.xml": "", "none.xml": esi()})
    done = run(*words)
    assert (done.exit_code, done.stdout) == (2, "")
    assert message in done.stderr
    assert len(done.stderr.splitlines()) == 1
