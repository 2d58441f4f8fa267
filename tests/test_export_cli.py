"""``esicatalog export``: where the device comes from, exact matches only, one line for every error."""

import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner
from snippets import device, esi, one, only_device, pdo, read, rows, write
from test_cli import run as main_run
from test_export_configuration import dc, times

from esicatalog import Catalog
from esicatalog.cli.export import command


def run(*words: object, db: Path | None = None, stdin: str | None = None):
    arguments = [str(word) for word in words] + (["--db", str(db)] if db is not None else [])
    return CliRunner().invoke(command, arguments, catch_exceptions=False, input=stdin)


def error_line(result, exit_code: int) -> str:
    assert result.exit_code == exit_code
    assert result.stdout == ""
    (line,) = result.stderr.splitlines()
    assert line.startswith("esicatalog: ")
    return line


@pytest.mark.parametrize("target", ["igh", "cstruct", "soem", "pysoem", "ros2", "linuxcnc"])
def test_the_catalog_and_the_file_give_the_same(data, data_db, target):
    from_catalog = run(target, "0x4321:0xe2:1", db=data_db)
    from_file = run(target, "--esi", data / "l6n_drive.xml")
    assert from_catalog.exit_code == 0
    assert from_catalog.stdout == from_file.stdout
    assert "target" in from_file.stdout.lower()


def test_without_revision_the_latest_visible_one_is_meant(data_db):
    assert "revision 0x00110000" in run("igh", "0xE5C:0x0D080808", db=data_db).stdout


def test_options_reach_the_header(data, tmp_path):
    target = tmp_path / "drive.h"
    words = ("--pdo", "0x1601,0x1A01", "--op-mode", "DC", "--cycle-ns", 500_000, "--name", "left", "--alias", 7)
    result = run("igh", "--esi", data / "l6n_drive.xml", *words, "--position", 1, "-o", target)
    assert (result.exit_code, result.stdout) == (0, "")
    text = target.read_text()
    for words in (
        "#define LEFT_ALIAS 7",
        "#define LEFT_POSITION 1",
        "#define CYCLE_NS 500000",
        "{0x60ff, 0x00, 32}",
        "left_config_dc",
    ):
        assert words in text


def test_modules_are_plugged(data):
    result = run("igh", "--esi", data / "two_axis_modular_drive.xml", "--module", "1=0x10900")
    assert "target_velocity_axis1" in result.stdout


def test_versions_of_soem(data):
    file = data / "l6n_drive.xml"
    assert "ec_SDOwrite(slave" in run("soem", "--esi", file, "--soem", "1.4").stdout
    assert "ecx_SDOwrite(context" in run("soem", "--esi", file, "--soem", "2").stdout
    assert run("soem", "--esi", file, "--soem", "3").exit_code == 2


def test_another_revision_is_refused_and_can_be_accepted(data_db):
    line = error_line(run("igh", "0x4321:0xe2:7", db=data_db), 1)
    assert "--accept-revision takes 0x00004321:0x000000e2:0x00000001" in line
    accepted = run("igh", "0x4321:0xe2:7", "--accept-revision", db=data_db)
    assert accepted.exit_code == 0
    assert "NOT EXACT, accepted on request: asked for 0x00004321:0x000000e2:0x00000007" in accepted.stdout
    (line,) = accepted.stderr.splitlines()
    assert "asked for 0x00004321:0x000000e2:0x00000007, described is 0x00004321:0x000000e2:0x00000001" in line


def test_what_is_not_there(data_db, tmp_path):
    assert "product 0x000000e3" in error_line(run("igh", "0x4321:0xe3:1", "--accept-revision", db=data_db), 1)
    assert "0x00004321:0x000000e3" in error_line(run("igh", "0x4321:0xe3", db=data_db), 1)
    assert "vendor 0x00000009" in error_line(run("igh", "9:9:9", "--accept-revision", db=data_db), 1)


def test_a_device_that_the_file_lacks_is_exit_1(data):
    for identity in ("0x1:0x2", "0x4321:0xe2:7"):
        assert "does not describe" in error_line(run("ros2", "--esi", data / "l6n_drive.xml", identity), 1)


def test_wrong_usage_is_one_line(data, data_db, tmp_path):
    drive = data / "l6n_drive.xml"
    not_esi = write(tmp_path, {"eni.xml": "<EtherCATConfig/>"}) / "eni.xml"
    for words, message in (
        (("igh",), "say which device"),
        (("igh", "--esi", tmp_path / "missing.xml"), "no such file"),
        (("igh", "--esi", not_esi), f"{not_esi}: an ENI file (EtherCATConfig"),
        (("esi", "--esi", data / "README.md"), f"{data / 'README.md'}: no XML document"),
        (("igh", "--esi", tmp_path), f"{tmp_path}: is a folder; give an ESI file"),
        (("igh", "--esi", data / "io_terminal_8di_8do.xml"), "describes 2 devices; name one of"),
        (("igh", "--esi", drive, "--pdo", "0x1600,0x1601"), "exclude each other"),
        (("igh", "--esi", drive, "--pdo", "x"), "is not a number"),
        (("igh", "--esi", drive, "--op-mode", "none"), "does not exist"),
        (("igh", "--esi", drive, "--module", "0=1"), "the device has no slots"),
        (("igh", "--esi", drive, "--cycle-ns", 0), "bus cycle"),
        (("igh", "--esi", drive, "--name", "a b"), "cannot begin names"),
        (("igh", "--esi", drive, "-o", tmp_path / "no" / "where.h"), "No such file"),
        (("igh", "--esi", drive, "--scan", "-"), "neither IDENTITY nor --esi"),
        (("cstruct", "--sii", tmp_path / "missing.bin"), "No such file"),
        (("cstruct", "--sii", drive, "--esi", drive), "neither IDENTITY nor --esi"),
        (("igh", "0x4321"), "is not VENDOR:PRODUCT"),
    ):
        assert message in error_line(run(*words), 2)


def test_an_image_that_is_none_is_one_line(tmp_path):
    write(tmp_path, {"empty.bin": b"\xff" * 2048})
    assert "empty EEPROM" in error_line(run("cstruct", "--sii", tmp_path / "empty.bin"), 2)


@pytest.mark.parametrize("target", ["igh", "cstruct", "soem", "pysoem", "ros2", "linuxcnc", "sii"])
def test_devices_without_codes_are_refused_but_for_esi(tmp_path, target):
    cap, unread = device("", product="", type_text="End cap"), device("", revision="#xx1", type_text="Unread")
    write(tmp_path, {"cap.xml": esi(cap), "unread.xml": esi(unread)})
    line = error_line(run(target, "--esi", tmp_path / "cap.xml"), 2)
    assert "End cap has no product code and no revision: it can be exported as ESI only" in line
    assert "Unread has no revision: " in error_line(run(target, "--esi", tmp_path / "unread.xml"), 2)
    assert "Unread has no revision: " in error_line(run(target, "0xe5c:1:-", "--esi", tmp_path / "unread.xml"), 2)


def test_a_document_without_any_vendor_id_has_nothing_to_export(tmp_path):
    write(tmp_path, {"x.xml": esi(device(""), vendor="<Name>Nobody</Name>")})
    assert "no device of a vendor with an id" in error_line(run("esi", "--esi", tmp_path / "x.xml"), 2)


def test_esi_of_devices_without_codes_is_what_was_read(tmp_path):
    """A revision that is no number stays as the vendor spells it; without a choice one with codes counts."""
    unread = device("<Sm>Outputs</Sm>", revision="#xx1", type_text="Unread")
    cap = device("", product="", type_text="End cap")
    whole = device("", type_text="Whole", product="2")
    folder = write(tmp_path / "in", {"a.xml": esi(unread + cap), "b.xml": esi(unread + whole)})
    db = tmp_path / "c.db"
    Catalog.open(db, create=True).ingest([folder], jobs=1)
    for found in (
        run("esi", "0xe5c:1:-", db=db),
        run("esi", "0xe5c:1", db=db),
        run("esi", "0xe5c:1:-", "--esi", folder / "a.xml"),
        run("esi", "0xe5c:1", "--esi", folder / "a.xml"),
    ):
        (written,) = read(found.stdout).document.infos[0].devices
        assert written == only_device(esi(unread))
        assert 'RevisionNo="#xx1"' in found.stdout
    of_vendor = read(run("esi", "--vendor", "0xe5c", db=db).stdout).document.infos[0].devices
    assert {item.type for item in of_vendor} == {"Unread", "End cap", "Whole"}
    (written,) = read(run("esi", "--esi", folder / "b.xml").stdout).document.infos[0].devices
    assert written.type == "Whole"
    both = error_line(run("esi", "--esi", folder / "a.xml"), 2)
    assert "0x00000e5c:0x00000001:- (Unread; a.xml, line 1), 0x00000e5c:-:- (End cap; a.xml, line 1)" in both


def test_a_real_image_on_the_command_line(corpus):
    dump = corpus / "sii" / "ethercrab-rs+ethercrab" / "dumps__Term 5 (EL2004).bin"
    printed = corpus / "igh" / "ethercrab-rs+ethercrab~dumps__Term 5 (EL2004).bin.cstruct.h"
    if not dump.is_file():
        pytest.skip(f"no EEPROM dump at {dump}")
    assert run("cstruct", "--sii", dump).stdout_bytes == printed.read_bytes()
    assert "slave_4_syncs" in run("cstruct", "--sii", dump, "--position", 4).stdout


@pytest.mark.parametrize(
    ("target", "unheeded"),
    [("soem", {"alias": 7, "position": 3}), ("cstruct", {"name": "left", "cycle-ns": 500_000})],
)
def test_all_masters_take_the_same_options_and_say_what_changes_nothing(data, target, unheeded):
    """An application says which slave it means, and what ``ethercat cstruct`` prints has no cycle in it."""
    plain = run(target, "--esi", data / "l6n_drive.xml")
    for option, value in unheeded.items():
        result = run(target, "--esi", data / "l6n_drive.xml", f"--{option}", value)
        assert (result.exit_code, result.stdout) == (0, plain.stdout)
        assert f"esicatalog: --{option} changes nothing in what {target} gives\n" in result.stderr


def test_an_image_leaves_nothing_to_choose(data, tmp_path):
    drive, image = data / "l6n_drive.xml", tmp_path / "sii.bin"
    assert run("sii", "--esi", drive, "-o", image).exit_code == 0
    assert "{0x1601, " in run("cstruct", "--esi", drive, "--pdo", "0x1601").stdout
    for words in (("--pdo", "0x1601"), ("--op-mode", "DC"), ("--module", "1=1")):
        assert "--sii prints what the image holds" in error_line(run("cstruct", "--sii", image, *words), 2), words
    assert "slave_4_syncs" in run("cstruct", "--sii", image, "--position", 4).stdout


BUS = """
vendor,product,revision
0x4321,0xe2,1
0xE5C,0x0D080808,0x00110000
0x4321,0xe2,1
0x99,1,1
"""


def test_a_bus_from_a_listing(data_db, tmp_path):
    listing = write(tmp_path, {"bus.csv": BUS}) / "bus.csv"
    result = run("igh", "--scan", listing, db=data_db)
    assert result.exit_code == 0
    assert "position 3: slave (0x00000099:0x00000001:0x00000001) is unknown and left out" in result.stdout
    for name in ("L6N_0_POSITION 0", "ECX_D808_1_POSITION 1", "L6N_2_POSITION 2"):
        assert f"#define {name}\n" in result.stdout
    assert result.stdout == run("igh", "--scan", "-", db=data_db, stdin=BUS).stdout
    named = run("igh", "--scan", listing, "--name", "line", db=data_db).stdout
    assert "#ifndef LINE_H\n" in named and "#define LINE_L6N_0_POSITION 0\n" in named
    assert "a bus cycle of 0 ns cannot be" in error_line(run("igh", "--scan", listing, "--cycle-ns", 0, db=data_db), 2)


def test_what_is_not_understood_of_a_listing_is_told(data_db):
    block = "=== Master 0, Slave 0 ===\n  Vendor Id: 0x4321\n  Product code: 0xe2\n  Revision number: 0x1\n"
    result = run("igh", "--scan", "-", db=data_db, stdin=block + "garbage\n")
    words = "line 5: 1 line is not read as `ethercat slaves -v`; the first: 'garbage'"
    assert (result.exit_code, result.stderr) == (0, f"esicatalog: {words}\n")
    assert f" * - {words}\n" in result.stdout


def test_a_bus_with_other_revisions_is_refused(data_db):
    listing = BUS.replace("0x4321,0xe2,1\n0xE5C", "0x4321,0xe2,9\n0xE5C")
    line = error_line(run("igh", "--scan", "-", db=data_db, stdin=listing), 1)
    assert "position 0: 0x00004321:0x000000e2:0x00000009" in line
    accepted = run("igh", "--scan", "-", "--accept-revision", db=data_db, stdin=listing)
    assert accepted.exit_code == 0
    assert "NOT EXACT, accepted on request" in accepted.stdout
    assert accepted.stderr.count("accepted, asked for") == 1


def test_a_slave_that_cannot_be_configured_is_left_out_of_the_header_of_its_bus_loudly(tmp_path):
    """The first has a PDO without index (old files); for the second the cycle is a choice that does not fit."""
    old = device("<RxPdo Sm='2'><Name>Out</Name></RxPdo>", product="1", type_text="OLD")
    fixed = device(dc(("m", times("#x300", ">250000"))), product="2", type_text="FIXED")
    twice = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') * 2
    files = {"a.xml": esi(old + fixed + device(twice, product="3", type_text="TWICE"))}
    db = tmp_path / "c.db"
    Catalog.open(db, create=True).ingest([write(tmp_path / "in", files)], jobs=1)
    listing = "vendor,product,revision\n" + "".join(f"0xe5c,{product},1\n" for product in (1, 2, 3))
    result = run("igh", "--scan", "-", db=db, stdin=listing)
    assert result.exit_code == 0
    told = result.stderr.splitlines()
    assert [line.partition(" is left out: ")[0] for line in told] == [
        "esicatalog: position 0: OLD (0x00000e5c:0x00000001:0x00000001)",
        "esicatalog: position 2: TWICE (0x00000e5c:0x00000003:0x00000001)",
    ]
    assert "RxPdo 'Out' is assigned and has no index" in told[0]
    assert "for 1 of the 3 slaves of a bus, generated by" in result.stdout
    assert "NOT ALL SLAVES: 2 more of the bus cannot be configured by this header:" in result.stdout
    assert "position 2: TWICE (0x00000e5c:0x00000003:0x00000001) is left out" in result.stdout
    assert "#define FIXED_1_POSITION 1\n" in result.stdout
    none = error_line(run("igh", "--scan", "-", "--cycle-ns", 700_000, db=db, stdin=listing), 2)
    assert none.startswith("esicatalog: no slave of the bus can be configured; position 0: OLD")
    assert "position 1: FIXED (0x00000e5c:0x00000002:0x00000001) is left out: OpMode 'm' fixes the SYNC0 cycle" in none


def test_choices_for_one_device_do_not_fit_a_bus(data_db):
    for words in (("--op-mode", "DC"), ("--alias", 3), ("--position", 4)):
        line = error_line(run("igh", "--scan", "-", *words, db=data_db, stdin=BUS), 2)
        assert "one device" in line, words


@pytest.mark.corpus
def test_a_real_bus_as_igh_prints_it(corpus, corpus_db):
    listing = corpus / "cli" / "linuxcnc-ethercat+linuxcnc-ethercat" / "tests__configgen__canned__scenario1__slaves.txt"
    if not listing.is_file():
        pytest.skip(f"no listing at {listing}")
    result = run("igh", "--scan", listing, "--accept-revision", db=corpus_db)
    assert result.exit_code == 0, result.stderr
    assert "_POSITION 0\n" in result.stdout


def test_variants_are_told_apart(tmp_path):
    two = (esi(device("", name="A")), esi(device("<Sm>Outputs</Sm>", name="B")))
    folder = write(tmp_path / "in", {f"{number}.xml": text for number, text in enumerate(two)})
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([folder], jobs=1)
    first, second = (run("igh", f"0xE5C:1:1@{variant}", db=db).stdout for variant in (1, 2))
    assert first != second
    assert "no variant 3" in error_line(run("igh", "0xE5C:1:1@3", db=db), 1)


def test_the_export_of_a_vendor_names_the_descriptions_that_it_leaves_out(tmp_path):
    """Three descriptions of 1:1, two of 2:1, one of 3:1: preferred is the one with more entries."""
    described = [
        device(pdo("RxPdo", "#x1600", *[8] * count), product=product)
        for product, counts in (("1", (3, 2, 1)), ("2", (1, 2)), ("3", (1,)))
        for count in counts
    ]
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([write(tmp_path / "in", {"a.xml": esi("".join(described))})], jobs=1)
    found = run("esi", "--vendor", "0xe5c", db=db)
    assert [len(item.rx_pdos[0].entries) for item in read(found.stdout).document.infos[0].devices] == [3, 2, 1]
    assert found.stderr.splitlines() == [
        "esicatalog: 0x00000e5c:0x00000001:0x00000001: 2 more descriptions, @2 to @3",
        "esicatalog: 0x00000e5c:0x00000002:0x00000001: 1 more description, @2",
    ]
    assert run("esi", "0xe5c:3", db=db).stderr == ""


def _module(ident: int, module_class: str, name: str) -> str:
    return f"<Module><Type ModuleIdent='{ident}' ModuleClass='{module_class}'>{name}</Type><Name>{name}</Name></Module>"


def test_the_export_of_a_vendor_has_the_modules_that_no_slot_reaches(tmp_path):
    """The coupler takes the class C; further modules, of which it would take one, stand in a document of modules.

    Of another vendor there are only modules.
    """
    slots = "<Slots><Slot MinInstances='0' MaxInstances='1'><ModuleClass><Class>C</Class></ModuleClass></Slot></Slots>"
    of_modules = _module(2, "C", "M2") + _module(3, "D", "M3")
    documents = {
        "coupler.xml": esi(device(slots), _module(1, "C", "M1")),
        "modules.xml": esi("", of_modules),
        "other.xml": esi("", _module(4, "C", "M4"), vendor="<Id>7</Id><Name>Other</Name>"),
    }
    given, again = tmp_path / "given.db", tmp_path / "again.db"
    with Catalog.open(given, create=True) as catalog:
        catalog.ingest([write(tmp_path / "in", documents)], jobs=1)
    alone = run("esi", "--vendor", "0xe5c", db=given)
    assert [item.type for item in read(alone.stdout).document.infos[0].modules] == ["M1", "M3"]
    assert alone.stderr == (
        "esicatalog: left out: 1 module that no description reaches, because a device here would take them or another "
        "module has their ModuleIdent; --with-files -o OUT writes them too: 'M2' (0x00000002)\n"
    )
    out = tmp_path / "out"
    out.mkdir()
    for vendor, name in (("0xe5c", "a.xml"), ("7", "b.xml")):
        result = run("esi", "--vendor", vendor, "--with-files", "-o", out / name, db=given)
        assert (result.exit_code, result.stderr) == (0, "")
    assert sorted(path.name for path in out.iterdir()) == ["a-2.xml", "a.xml", "b.xml"]
    with Catalog.open(again, create=True) as catalog:
        catalog.ingest([out], jobs=1)
    for table in ("devices", "modules"):
        hashes = f"SELECT content_hash FROM {table} ORDER BY 1"
        assert rows(again, hashes) == rows(given, hashes)
    assert one(again, "SELECT name FROM vendors WHERE vendor_id = 7") == "Other"
    assert "vendor 0x00000008 has no device and no module" in error_line(run("esi", "--vendor", 8, db=given), 1)


def test_cstruct_remarks_on_stderr_what_its_text_cannot_hold(tmp_path):
    modules = "".join(
        f'<Module><Type ModuleIdent="{ident}">M</Type><Name>M</Name>{pdo("RxPdo", "#x1600", 8)}</Module>'
        for ident in (1, 2)
    )
    idents = "<ModuleIdent>1</ModuleIdent><ModuleIdent>2</ModuleIdent>"
    slot = f'<Slots><Slot MinInstances="1" MaxInstances="1">{idents}</Slot></Slots>'
    write(tmp_path, {"a.xml": esi(device(f"<Sm ControlByte='#x64'>Outputs</Sm>{slot}"), modules)})
    result = run("cstruct", "--esi", tmp_path / "a.xml")
    assert "without a module" not in result.stdout
    (line,) = result.stderr.splitlines()
    assert line.startswith("esicatalog: slot 0 without a module, though required: PDOs of modules are missing here")


def test_other_variants_that_exchange_something_else_are_told(tmp_path):
    """Variant 1 has more entries; the words are those of ``identify``."""
    sms = "<Sm ControlByte='#x64'>Outputs</Sm>"
    first = sms + pdo("RxPdo", "#x1600", 16, 32, attributes='Sm="0"')
    alike = first.replace("<Name>e1</Name>", "<Name>other</Name>")
    other = sms + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')
    for beside, is_told in ((other, True), (alike, False)):
        documents = {f"{number}.xml": esi(device(text)) for number, text in enumerate((first, beside))}
        db = tmp_path / f"{is_told}.db"
        with Catalog.open(db, create=True) as catalog:
            catalog.ingest([write(tmp_path / f"{is_told}", documents)], jobs=1)
        words = "0x00000e5c:0x00000001:0x00000001 has several descriptions; @1 is taken, append @N to choose another: "
        differing = "default process image differs in 1 of 1 other variants of this identity; @2 for example: "
        result = run("igh", "0xE5C:1:1", db=db)
        assert (words + differing in " ".join(result.stdout.replace("*", " ").split())) is is_told
        assert result.stderr.startswith(f"esicatalog: {words}{differing}") is is_told
        assert run("cstruct", "0xE5C:1:1", db=db).stderr == result.stderr
        for variant in (1, 2):
            chosen = run("igh", f"0xE5C:1:1@{variant}", db=db)
            assert chosen.stderr == "" and "several descriptions" not in chosen.stdout
        scan = run("igh", "--scan", "-", db=db, stdin="vendor,product,revision\n0xE5C,1,1\n")
        assert ("has several descriptions" in scan.stdout) is is_told
        assert scan.stderr == result.stderr
        assert (f"  warning          {words}{differing}" in main_run("show", "0xE5C:1:1", db=db).stdout) is is_told
        accepted = run("igh", "0xE5C:1:2", "--accept-revision", db=db)
        assert (words in accepted.stderr) is is_told


def test_other_revisions_that_exchange_something_else_are_told_where_none_is_named(tmp_path):
    """Exports and sheet, in the words of ``identify``; the newest is taken."""
    sms = "<Sm ControlByte='#x64'>Outputs</Sm>"
    wide, narrow = (device(sms + pdo("RxPdo", "#x1600", bits, attributes="Sm='0'"), revision="#x2") for bits in (32, 8))
    taken = "0x00000e5c:0x00000001 has several revisions; 0x00000002 is taken, append :R to choose another: "
    differing = "default process image differs in 1 of 1 other revisions; 0x00000001 for example: "
    for older, is_told in ((narrow, True), (wide, False)):
        db, folder = tmp_path / f"{is_told}.db", tmp_path / f"{is_told}"
        document = esi(wide + older.replace('RevisionNo="#x2"', 'RevisionNo="#x1"'))
        with Catalog.open(db, create=True) as catalog:
            catalog.ingest([write(folder, {"a.xml": document})], jobs=1)
            (warning,) = catalog.identify(0xE5C, 1).warnings or ("",)
            assert warning.startswith(differing) is is_told
            assert catalog.device("0xE5C:1").warnings == ((taken + warning,) if is_told else ())
            assert catalog.device("0xE5C:1:2").warnings == ()
        result = run("igh", "0xE5C:1", db=db)
        assert (taken + differing in " ".join(result.stdout.replace("*", " ").split())) is is_told
        for target in ("igh", "sii", "esi"):
            assert (f"esicatalog: {taken}{differing}" in run(target, "0xE5C:1", db=db).stderr) is is_told
        assert "several revisions" not in (named := run("igh", "0xE5C:1:2", db=db)).stdout + named.stderr
        sheet = main_run("show", "0xE5C:1", db=db).stdout
        assert (f"  warning          {taken}{differing}" in sheet) is is_told


def test_no_export_writes_over_what_it_reads(data, data_db, tmp_path):
    """By its path, another path to it or a link; the journals that SQLite keeps beside a catalog are its files too."""
    catalog = tmp_path / "c.db"
    catalog.write_bytes(data_db.read_bytes())
    write(tmp_path, {"in.xml": (data / "l6n_drive.xml").read_bytes(), "slaves.txt": "", "sub/x": ""})
    drive, dump = tmp_path / "in.xml", tmp_path / "dump.bin"
    assert run("sii", "--esi", drive, "-o", dump).exit_code == 0
    (tmp_path / "link.xml").symlink_to(drive)
    (tmp_path / "hard.xml").hardlink_to(drive)
    kept = {path: path.read_bytes() for path in tmp_path.iterdir() if path.is_file()}
    identity = "0x4321:0xe2"
    for words in (
        ("igh", "--esi", drive, "-o", drive),
        ("esi", "--esi", drive, "-o", tmp_path / "sub" / ".." / "in.xml"),
        ("ros2", "--esi", drive, "-o", tmp_path / "link.xml"),
        ("ros2", "--esi", tmp_path / "link.xml", "-o", drive),
        ("soem", "--esi", drive, "-o", tmp_path / "hard.xml"),
        ("sii", "--esi", drive, "--merge", dump, "-o", dump),
        ("cstruct", "--sii", dump, "-o", dump),
        ("igh", "--scan", tmp_path / "slaves.txt", "-o", tmp_path / "slaves.txt"),
        ("igh", identity, "--db", catalog, "-o", catalog),
        ("igh", identity, "--db", catalog, "-o", f"{catalog}-wal"),
        ("igh", identity, "--db", f"sqlite:///{catalog}", "-o", catalog),
    ):
        line = error_line(run(*words), 2)
        assert line == f"esicatalog: {words[-1]}: is an input of this export or its catalog; write to another file"
    assert {path: path.read_bytes() for path in tmp_path.iterdir() if path.is_file()} == kept
    assert run("igh", "--esi", drive, "-o", tmp_path / "out.h").exit_code == 0
    assert run("igh", "--esi", drive, "-o", tmp_path / "out.h").exit_code == 0


def test_a_document_that_the_catalog_has_a_device_from_is_not_written_over(data, tmp_path):
    """Nor the archive that holds one; documents of other devices are no input, nor is one that is gone."""
    folder = write(tmp_path / "in", {"l6n.xml": (data / "l6n_drive.xml").read_bytes(), "other.xml": esi(device())})
    with zipfile.ZipFile(folder / "a.zip", "w") as archive:
        archive.writestr("sub/b.xml", esi(device(product="#x2")))
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([folder], jobs=1)
    (tmp_path / "slaves.csv").write_text("0x4321,0xe2,1\n")
    kept = {path: path.read_bytes() for path in folder.iterdir()}
    for words in (
        ("igh", "0x4321:0xe2", "-o", folder / "l6n.xml"),
        ("esi", "0x4321:0xe2", "-o", folder / "l6n.xml"),
        ("esi", "--vendor", "0x4321", "-o", folder / "l6n.xml"),
        ("igh", "--scan", tmp_path / "slaves.csv", "-o", folder / "l6n.xml"),
        ("sii", "0xe5c:2:1", "-o", folder / "a.zip"),
    ):
        line = error_line(run(*words, db=db), 2)
        assert line == f"esicatalog: {words[-1]}: is an input of this export or its catalog; write to another file"
    assert {path: path.read_bytes() for path in folder.iterdir()} == kept
    assert run("igh", "0x4321:0xe2", "-o", folder / "other.xml", db=db).exit_code == 0
    (folder / "l6n.xml").rename(tmp_path / "moved.xml")
    assert run("esi", "0x4321:0xe2", "-o", folder / "l6n.xml", db=db).exit_code == 0, "nothing was there"


def test_a_dictionary_that_a_file_pulls_in_is_not_written_over(tmp_path):
    """Neither as OUT nor beside it; in another folder there is nothing to lose."""
    profile = "<Profile><DictionaryFile>Dict.xml</DictionaryFile></Profile>"
    objects = "<Object><Index>#x1000</Index><Name>n</Name><Type>UDINT</Type><BitSize>32</BitSize></Object>"
    dictionary = f"<EtherCATDict><Dictionary><DataTypes/><Objects>{objects}</Objects></Dictionary></EtherCATDict>"
    drive = write(tmp_path, {"in.xml": esi(device(profile)), "Dict.xml": dictionary, "other/x": ""}) / "in.xml"
    for out, options in (("Dict.xml", ()), ("out.xml", ("--with-files",))):
        line = error_line(run("esi", "--esi", drive, *options, "-o", tmp_path / out), 2)
        assert line.startswith(f"esicatalog: {tmp_path / 'Dict.xml'}: is an input")
    assert (tmp_path / "Dict.xml").read_text() == dictionary
    assert not (tmp_path / "out.xml").exists()
    assert run("esi", "--esi", drive, "--with-files", "-o", tmp_path / "other" / "in.xml").exit_code == 0
    assert (tmp_path / "other" / "Dict.xml").exists()
