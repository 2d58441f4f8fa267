"""``esicatalog lint``: what it reads, what it prints, how it ends."""

import errno
import io
import json
import os
import re
import sqlite3
import zipfile
from collections import Counter
from contextlib import closing
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from snippets import device, esi, write

from esicatalog import Catalog
from esicatalog.catalog import stored_findings
from esicatalog.cli.lint import command, print_findings
from esicatalog.esi import containers
from esicatalog.esi.notes import Finding
from esicatalog.lint.registry import chosen_rules
from esicatalog.lint.report import DocumentFinding
from esicatalog.lint.rules import ALL_RULES

FILES = Path(__file__).parent / "lint"
BAD_VENDOR = "<Id>0</Id>\n<Name>V</Name>"
ENI = "<EtherCATConfig><Config/></EtherCATConfig>"


def run(*arguments: object) -> Result:
    return CliRunner().invoke(command, [str(argument) for argument in arguments], catch_exceptions=False)


def found(*arguments: object) -> list[dict]:
    return json.loads(run(*arguments, "--format", "json").stdout)


def test_a_line_looks_like_a_compilers(tmp_path, monkeypatch):
    write(tmp_path, {"sub/a.xml": esi(device(), vendor=BAD_VENDOR)})
    monkeypatch.chdir(tmp_path)
    result = run("sub")
    assert result.stdout == "sub/a.xml:1: error L08: Vendor/Id is 0: give the id that the ETG assigned\n"
    assert result.stderr == "1 error, 0 warnings, 0 infos; documents: 1\n"
    assert result.exit_code == 1


def test_without_errors_the_exit_code_is_zero(tmp_path):
    write(tmp_path, {"a.xml": esi(device().replace("YY", "X"))})
    result = run(tmp_path)
    assert "warning L14" in result.stdout
    assert result.exit_code == 0


def test_members_of_archives_are_named(tmp_path, monkeypatch):
    inner = io.BytesIO()
    with zipfile.ZipFile(inner, "w") as archive:
        archive.writestr("deep/b.xml", esi(device(), vendor=BAD_VENDOR))
    with zipfile.ZipFile(tmp_path / "vendor.zip", "w") as archive:
        archive.writestr("a.xml", esi(device(), vendor=BAD_VENDOR))
        archive.writestr("inner.zip", inner.getvalue())
    monkeypatch.chdir(tmp_path)
    assert [item["file"] for item in found("vendor.zip")] == ["vendor.zip!a.xml", "vendor.zip!inner.zip!deep/b.xml"]


def test_json_has_the_columns_of_the_catalog(tmp_path):
    write(tmp_path, {"a.xml": esi("\n" + device(), vendor=BAD_VENDOR)})
    (item,) = found(tmp_path / "a.xml")
    assert item == {
        "file": str(tmp_path / "a.xml"),
        "line": 1,
        "rule": "L08",
        "severity": "E",
        "message": "Vendor/Id is 0: give the id that the ETG assigned",
        "path": "EtherCATInfo/Vendor/Id",
    }


def test_other_files_are_skipped_unless_named(tmp_path):
    write(tmp_path, {"eni.xml": ENI, "notes.txt": "text", "a.xml": esi(device())})
    result = run(tmp_path)
    assert (result.stdout, result.exit_code) == ("", 0)
    assert result.stderr == "0 errors, 0 warnings, 0 infos; documents: 1, skipped as no ESI: 2\n"
    assert [item["rule"] for item in found(tmp_path / "eni.xml")] == ["L02"]
    assert run(tmp_path / "notes.txt").exit_code == 1


def test_what_was_never_opened_is_not_called_clean(tmp_path, monkeypatch):
    """Links that lead outside, pipes and devices: nobody knows what lies behind them."""
    write(tmp_path, {"outside/a.xml": esi(device(), vendor=BAD_VENDOR), "links/sub/notes.txt": "text"})
    (tmp_path / "links" / "b.xml").symlink_to(tmp_path / "outside" / "a.xml")
    (tmp_path / "links" / "c").symlink_to(tmp_path / "outside")
    (tmp_path / "links" / "d").symlink_to(tmp_path / "links" / "sub")
    os.mkfifo(tmp_path / "p.xml")
    monkeypatch.chdir(tmp_path)
    result = run("links")
    assert (result.stdout, result.exit_code) == ("", 1)
    assert result.stderr.splitlines() == [
        "esicatalog: links/c: symbolic link to a folder; name the folder itself to read it",
        "esicatalog: links/b.xml: symbolic link that leads outside the folder",
        "0 errors, 0 warnings, 0 infos; documents: 0, skipped as no ESI: 2",
    ]
    for name in ("p.xml", "/dev/null"):
        result = run(name)
        assert (result.exit_code, result.stderr.splitlines()[0]) == (1, f"esicatalog: {name}: not a regular file")


def test_an_archive_without_files_is_skipped_unless_named(tmp_path):
    with zipfile.ZipFile(tmp_path / "empty.zip", "w"):
        pass
    assert run(tmp_path).exit_code == 0
    result = run(tmp_path / "empty.zip")
    assert (result.exit_code, "empty.zip: an archive without files" in result.stderr) == (1, True)


def test_what_cannot_be_read_at_all_is_an_error(tmp_path):
    write(tmp_path, {"empty.xml": "", "a.xml": esi(device())})
    assert [(Path(item["file"]).name, item["rule"]) for item in found(tmp_path)] == [("empty.xml", "L01")]


DEEP = "<EtherCATInfo>" + "<a>" * 300 + "</a>" * 300 + "</EtherCATInfo>"


@pytest.mark.parametrize(
    ("name", "text", "options"),
    [
        ("deep.xml", DEEP, ["--select", "L18"]),
        ("empty.xml", "", ["--ignore", "L01"]),
        ("e.xml", ENI, ["--ignore", "L02"]),
    ],
)
def test_a_refused_document_is_never_clean(tmp_path, name, text, options):
    """Where the rule that would tell it is not chosen, it counts as unreadable."""
    write(tmp_path, {name: text})
    result = run(tmp_path / name, *options)
    assert (result.stdout, result.exit_code) == ("", 1)
    assert re.match(rf"esicatalog: .*{name}: .+\n0 errors", result.stderr)


def test_documents_are_named_once_for_all_findings(tmp_path, monkeypatch):
    """Also for L01, which comes from another table than the other rules; else all documents are read again."""
    (tmp_path / "empty.xml").write_text("")
    asked = []
    monkeypatch.setattr(stored_findings, "_names", lambda c, names=stored_findings._names: asked.append(c) or names(c))
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest(tmp_path / "empty.xml", jobs=1)
        assert [item.finding.rule for item in catalog.findings(chosen_rules(ALL_RULES, (), ()))] == ["L01"]
    assert len(asked) == 1


def test_a_refused_document_of_a_catalog_is_never_clean(tmp_path):
    write(tmp_path / "esi", {"empty.xml": "", "a.xml": esi(device())})
    db = tmp_path / "catalog.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([tmp_path / "esi"], jobs=1)
    result = run("--db", db, "--select", "L18")
    assert (result.stdout, result.exit_code) == ("", 1)
    assert result.stderr == "esicatalog: empty.xml: the file is empty\n0 errors, 0 warnings, 0 infos\n"
    assert [(item["file"], item["rule"]) for item in found("--db", db)] == [("empty.xml", "L01")]


@pytest.mark.parametrize("options", [[], ["--select", "L18"]])
def test_a_file_that_may_not_be_read_is_not_called_broken(tmp_path, monkeypatch, options):
    write(tmp_path, {"a.xml": esi(device())})

    def refuse(path: object) -> None:
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(containers, "open_regular", refuse)
    result = run(tmp_path, *options)
    assert (result.stdout, result.exit_code) == ("", 1)
    assert "a.xml: cannot be read: Permission denied\n" in result.stderr
    db = tmp_path / "catalog.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([tmp_path / "a.xml"], jobs=1)
    result = run("--db", db, *options)
    assert (result.stdout, result.exit_code) == ("", 1)
    words = "esicatalog: a.xml: cannot be read: Permission denied\n0 errors, 0 warnings, 0 infos\n"
    assert result.stderr == words


def test_a_member_that_cannot_be_unpacked_is_not_called_broken(tmp_path):
    """One byte of what is stored is another one than when its checksum was taken."""
    with zipfile.ZipFile(tmp_path / "vendor.zip", "w") as archive:
        archive.writestr("a.xml", esi(device()))
    packed = (tmp_path / "vendor.zip").read_bytes()
    (tmp_path / "vendor.zip").write_bytes(packed.replace(b"Test vendor", b"Test vendox", 1))
    db = tmp_path / "catalog.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([tmp_path / "vendor.zip"], jobs=1)
    for what in ([tmp_path / "vendor.zip"], ["--db", db]):
        result = run(*what)
        assert (result.stdout, result.exit_code) == ("", 1)
        assert "vendor.zip!a.xml: cannot be unpacked" in result.stderr


def test_select_and_ignore(tmp_path):
    write(tmp_path, {"a.xml": esi(device().replace("YY", "X"), vendor=BAD_VENDOR)})
    assert {item["rule"] for item in found(tmp_path)} == {"L08", "L14"}
    assert {item["rule"] for item in found(tmp_path, "--select", "l14,L15")} == {"L14"}
    assert {item["rule"] for item in found(tmp_path, "--ignore", "L14", "--ignore", "L15")} == {"L08"}
    assert found(tmp_path, "--select", "L14", "--ignore", "L14") == []


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--select", "L99", "."], "no lint rule 'L99'"),
        (["--ignore", "x", "."], "no lint rule 'x'"),
        ([], "name files"),
        ([".", "--db", "catalog.db"], "give only one of files, folders or archives to lint, or a catalog with --db"),
        ([".", "--db", ""], "give only one of"),
        (["--db", "catalog.db", "--schema", "."], "--schema validates the documents themselves"),
        (["--select", "", "."], "--select names no rule"),
        (["--ignore", ",", "."], "--ignore names no rule"),
        (["nowhere.xml"], "no such file or folder"),
        (["--schema", "nowhere", "."], "no EtherCATInfo.xsd"),
        (["--list", "--format", "sarif"], "prints text or JSON"),
    ],
)
def test_wrong_usage_is_one_line(tmp_path, monkeypatch, arguments, words):
    monkeypatch.chdir(tmp_path)
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert re.fullmatch(rf"esicatalog: .*{re.escape(words)}.*\n", result.stderr)


def test_selecting_the_schema_rule_without_schema_tells_what_was_left_out(tmp_path):
    """The values of booleans and numbers are checked without; nothing else of the schema is."""
    write(tmp_path, {"a.xml": esi(device())})
    result = run(tmp_path, "--select", "l03")
    assert result.stderr.splitlines()[0] == (
        "esicatalog: L03 looked at booleans and numbers only; for all kinds: lint PATH --schema DIR"
    )
    assert "booleans" not in run(tmp_path).stderr


def test_the_list_of_rules():
    text = run("--list").stdout
    assert text.count("\n") == 2 * 68
    assert "L19 E  The direction in the ControlByte contradicts the role of the SyncManager.\n" in text
    rules = json.loads(run("--list", "--format", "json").stdout)
    assert [rule["rule"] for rule in rules] == [rule.id for rule in ALL_RULES]
    assert [rule["rule"] for rule in json.loads(run("--list", "--select", "L40", "--format", "json").stdout)] == ["L40"]


def test_each_device_is_reported_where_it_stands(tmp_path):
    """Two devices with equal dictionaries: one look at the dictionary, a finding with its own line for each."""
    content = (FILES / "L45.bad.xml").read_text()
    begin, end = content.index("<Device "), content.index("</Device>") + len("</Device>")
    twin = content[begin:end].replace('RevisionNo="#x00000001"', 'RevisionNo="#x00000002"')
    write(tmp_path, {"a.xml": content[:end] + "\n" + twin + content[end:]})
    places = [(item["line"], item["path"]) for item in found(tmp_path, "--select", "L45")]
    first, second = places[:2], places[2:]
    distance = content[begin:end].count("\n") + 1
    assert [line + distance for line, _ in first] == [line for line, _ in second]
    objects = "Profile/Dictionary/Objects/Object[0]"
    assert first[0][1] == f"EtherCATInfo/Descriptions/Devices/Device[0]/{objects}"
    assert second[0][1] == f"EtherCATInfo/Descriptions/Devices/Device[1]/{objects}"


def test_a_dictionary_of_its_own_is_reported_once_and_there(tmp_path):
    dictionary = (
        "<EtherCATDict><Dictionary><DataTypes/><Objects>\n<Object><Index>#x2000</Index><Name>O</Name>"
        "<Type>UINT</Type><BitSize>16</BitSize></Object></Objects></Dictionary></EtherCATDict>"
    )
    reference = "<Profile><DictionaryFile>d.xml</DictionaryFile></Profile>"
    write(tmp_path, {"a.xml": esi(device(reference) + device(reference, revision="#x2")), "d.xml": dictionary})
    items = [(Path(item["file"]).name, item["line"]) for item in found(tmp_path, "--select", "L41")]
    assert items == [("d.xml", 2)]


def test_the_schema_of_the_user(corpus, tmp_path):
    write(
        tmp_path, {"a.xml": esi("\n<Device Physics='YY'><Name>N</Name><Type>T</Type><GroupType>G</GroupType></Device>")}
    )
    (item,) = found(tmp_path, "--schema", corpus / "xsd" / "1.17", "--select", "L03")
    assert (item["line"], item["severity"]) == (2, "W")
    assert item["path"] == "EtherCATInfo/Descriptions/Devices/Device/Name"
    assert "Expected is" in item["message"]
    assert item["message"].endswith("(SCHEMAV_ELEMENT_CONTENT)")
    assert found(FILES / "L18.good.xml", "--schema", corpus / "xsd" / "1.17") == []


SCHEMA = """<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema"><xs:element name="EtherCATInfo"><xs:complexType>
<xs:sequence><xs:element name="Descriptions"><xs:complexType><xs:sequence><xs:element name="Devices"><xs:complexType>
<xs:sequence><xs:element name="Device" maxOccurs="unbounded"><xs:complexType><xs:sequence>
<xs:element name="RxPdo" minOccurs="0"><xs:complexType><xs:attribute name="Fixed" type="xs:boolean"/></xs:complexType>
</xs:element></xs:sequence></xs:complexType></xs:element></xs:sequence></xs:complexType></xs:element></xs:sequence>
</xs:complexType></xs:element></xs:sequence></xs:complexType></xs:element></xs:schema>"""


def test_violations_of_the_schema_have_the_line_and_the_place_of_their_element(tmp_path):
    """Beyond line 65535, where libxml2 no longer counts, and in a section of a list; a value is told once."""
    device_elements = "<Device>\n</Device>" + "\n" * 70_000 + "<Device>\n<Foo/>\n<RxPdo Fixed='TRUE'/></Device>"
    info = f"<EtherCATInfo><Descriptions><Devices>{device_elements}</Devices></Descriptions></EtherCATInfo>"
    write(tmp_path / "xsd", {"EtherCATInfo.xsd": SCHEMA})
    write(tmp_path, {"a.xml": f"<EtherCATInfoList>{info}\n{info.replace('<Foo/>', '')}</EtherCATInfoList>"})
    items = found(tmp_path / "a.xml", "--schema", tmp_path / "xsd", "--select", "L03")
    below = "/Descriptions/Devices/Device[1]/"
    assert [(item["line"], item["path"], item["message"].partition(": ")[0]) for item in items] == [
        (70_003, f"EtherCATInfoList/EtherCATInfo[0]{below}Foo", "Element 'Foo'"),
        (70_004, f"EtherCATInfoList/EtherCATInfo[0]{below}RxPdo", "RxPdo/@Fixed"),
        (140_008, f"EtherCATInfoList/EtherCATInfo[1]{below}RxPdo", "RxPdo/@Fixed"),
    ]


def test_a_schema_folder_that_cannot_be_used(tmp_path):
    write(tmp_path, {"EtherCATInfo.xsd": "<schema"})
    result = run(tmp_path, "--schema", tmp_path)
    assert (result.exit_code, result.stderr.count("\n")) == (2, 1)


def test_findings_stored_in_a_catalog(tmp_path):
    write(tmp_path / "esi", {"a.xml": esi(device().replace("#x1", "0x1"))})
    db = tmp_path / "catalog.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([tmp_path / "esi"], jobs=1)
    items = found("--db", db, "--select", "L06")
    assert [(item["file"], item["rule"], item["severity"]) for item in items] == [("a.xml", "L06", "E")] * 2
    assert run("--db", db).exit_code == 1
    assert run("--db", tmp_path / "missing.db").exit_code == 2


def test_documents_of_one_relative_name_are_told_apart(tmp_path):
    """They describe one identity differently, in two folders that were given to one ingest."""
    write(tmp_path, {"p1/a.xml": esi(device()), "p2/a.xml": esi(device(name="Other"))})
    db = tmp_path / "catalog.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([tmp_path / "p1", tmp_path / "p2"], jobs=1)
    (item,) = found("--db", db, "--select", "L12")
    assert item["file"] == str(tmp_path / "p2" / "a.xml")
    assert f"with other content in {tmp_path / 'p1' / 'a.xml'}:" in item["message"]


def test_a_damaged_finding_is_one_line(tmp_path):
    db = tmp_path / "catalog.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([FILES / "L45.bad.xml"], jobs=1)
    with closing(sqlite3.connect(db)) as connection:
        connection.execute("UPDATE findings SET message = CAST(x'FF' AS TEXT)")
        connection.commit()
    result = run("--db", db)
    assert result.exit_code == 2
    assert re.fullmatch(r"esicatalog: .*damaged.*\n", result.stderr)


def test_an_ingest_stores_what_lint_says(tmp_path):
    """Files of every rule, and what contradicts what across them."""
    for file in (*FILES.glob("L*.bad.xml"), *FILES.glob("L4*.good.xml")):
        (tmp_path / file.name).write_bytes(file.read_bytes())
    db = tmp_path / "catalog.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([tmp_path], jobs=2)
    said = Counter(
        (i["file"].rpartition("/")[2], i["line"], i["rule"], i["severity"], i["path"]) for i in found(tmp_path)
    )
    stored = Counter((i["file"], i["line"], i["rule"], i["severity"], i["path"]) for i in found("--db", db))
    only_said = {key[2] for key in said - stored}
    assert not stored - said
    # A file that cannot be read at all has no line in the catalog; what is no ESI is skipped by an ingest.
    assert only_said <= {"L01", "L02"}
    assert {"L04", "L12", "L45", "L57"} <= {key[2] for key in stored}


def test_findings_are_printed_as_they_come(capsys):
    shown = []

    def items():
        for number in (1, 2):
            shown.append(capsys.readouterr().out)
            yield DocumentFinding("a.xml", Finding("L21", "I", "words", number))

    print_findings(items(), chosen_rules(ALL_RULES, (), ()), "text")
    assert shown == ["", "a.xml:1: info L21: words\n"]


def test_a_finding_without_line():
    item = DocumentFinding("a.zip!b.xml", Finding("L01", "E", "words", 0))
    assert print_findings([item], [], "text") == [item.finding]
