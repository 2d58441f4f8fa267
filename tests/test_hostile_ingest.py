"""Hostile documents, files and archives, read by worker processes beside a good document.

Every one gets a status and one line that says what it is; the good document is stored, the catalog is sound, time and
memory are bounded. All inputs are made here, most with a few bytes repeated.
"""

import io
import json
import os
import socket
import struct
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import NamedTuple

import pytest
from snippets import REPEATED_ATTRIBUTE, UNDECLARED_PREFIX, device, dictionary, esi, faulty_vendor_texts, pdo, rows

from esicatalog.esi.notes import MAX_FINDINGS

GOOD = "io_terminal_8di_8do.xml"
SECRET = "words that only the file outside holds"
SECONDS = 300
"""A guard against hanging; all of it takes some ten seconds."""
MEMORY_MB = 1_000

INGEST = """
import json, re, resource, sys
from pathlib import Path
from esicatalog import Catalog
with Catalog.open(sys.argv[1], create=True) as catalog:
    report = catalog.ingest(sys.argv[2:], jobs=2)
    problems = catalog.check().problems
# What getrusage says of this process begins with the size of the one that started it.
own_kb = int(re.search("VmHWM:\\s*(\\d+) kB", Path("/proc/self/status").read_text())[1])
peaks = [kb // 1024 for kb in (own_kb, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)]
print(json.dumps({"lines": {d.path: [d.status, d.message] for d in report.documents}, "problems": problems,
                  "peaks_mb": peaks}))
"""


def entities(*declarations: str, use: str = "", content: str = "") -> str:
    return f"<!DOCTYPE EtherCATInfo [{''.join(declarations)}]>" + esi(device(content, name=f"a{use}b"))


def vendor_specific(content: str) -> str:
    return esi(device(f"<Info><VendorSpecific>{content}</VendorSpecific></Info>"))


def attributes(count: int, name: str = "a") -> str:
    return " ".join(f'{name}{n}="1"' for n in range(count))


def modular_drive(count: int) -> str:
    """255 slots that each take any of so many modules, and what the modules say of 0x6502 counts before the device."""

    def profile(attribute: str) -> str:
        modes = f"<Index {attribute}='1'>#x6502</Index><Name>S</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        modes += "<Info><DefaultValue>128</DefaultValue></Info>"
        return dictionary("", f"<Object>{modes}</Object>")

    modules = "".join(
        f'<Module><Type ModuleIdent="{ident}">M{ident} (csp, csv)</Type><Name>M</Name>'
        '<RxPdo><Index DependOnSlot="1">#x1600</Index><Name>R</Name>'
        '<Entry><Index DependOnSlot="1">#x607A</Index><SubIndex>0</SubIndex><BitLen>32</BitLen></Entry>'
        f"</RxPdo>{profile('DependOnSlot')}</Module>"
        for ident in range(1, count + 1)
    )
    idents = "".join(f"<ModuleIdent>{ident}</ModuleIdent>" for ident in range(1, count + 1))
    slots = f'<Slot MinInstances="255" MaxInstances="255"><Name>S</Name>{idents}</Slot>'
    slots = f'<Slots MaxSlotCount="255" SlotIndexIncrement="#x800" SlotPdoIncrement="1">{slots}</Slots>'
    return esi(device(profile("OverwrittenByModule") + slots), modules)


OUTSIDE = ("../outside.xml", "/etc/passwd", r"C:\outside.xml", "way-out/outside.xml", "pipe.xml")
LAUGHS = ['<!ENTITY a0 "lol">', *(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 12))]
LONG = "x" * 50_000
NAME = "Gerät"


class Case(NamedTuple):
    """What is made and what becomes of it."""

    content: object
    status: str
    words: str | None = None


DOCUMENTS = {
    "laughs.xml": Case(lambda: entities(*LAUGHS, use="&a11;"), "failed", "expand too far"),
    "laughs-in-attribute.xml": Case(
        lambda: entities(*LAUGHS, content='<Sm StartAddress="&a11;"/>'), "failed", "expand too far"
    ),
    "quadratic.xml": Case(
        lambda: entities(f'<!ENTITY a "{LONG}">', content='<Sm StartAddress="&a;&a;"/>' * 5_000),
        "failed",
        "expand too far",
    ),
    "attribute-defaults.xml": Case(
        lambda: entities(f'<!ATTLIST Sm Enable CDATA "{LONG}">', content="<Sm/>" * 20_000), "failed", "expand too far"
    ),
    "parameter-entity.xml": Case(
        lambda: entities("<!ENTITY % d '&#60;!ENTITY e \"x\">'> %d;", use="&e;"), "failed", "remove its DOCTYPE"
    ),
    "external-entity.xml": Case(
        lambda: entities('<!ENTITY e SYSTEM "../secret.txt">', use="&e;"), "recovered", "entity &e; and others"
    ),
    "external-dtd.xml": Case(lambda: '<!DOCTYPE EtherCATInfo SYSTEM "../evil.dtd">' + esi(device()), "stored"),
    "xinclude.xml": Case(
        lambda: esi(device('<i:include xmlns:i="http://www.w3.org/2001/XInclude" href="../secret.txt" parse="text"/>')),
        "stored",
    ),
    "deep.xml": Case(lambda: vendor_specific("<a>" * 10**6 + "</a>" * 10**6), "failed", "more than 256 elements"),
    "deep-after-a-fault.xml": Case(
        lambda: vendor_specific("A & B" + "<a>" * 300 + "</a>" * 300), "failed", "more than 256 elements"
    ),
    "long-text.xml": Case(lambda: esi(device(name="x" * 30_000_000)), "failed", "a text of more than 10 MB"),
    "long-type.xml": Case(
        lambda: esi(device(type_text="x" * 1_999 + "é")), "failed", "line 1: Type of 2,001 bytes; a catalog takes 2,000"
    ),
    "type-that-fits.xml": Case(lambda: esi(device(type_text="x" * 2_000)), "stored"),
    "attributes.xml": Case(
        lambda: esi(device(f"<X {attributes(10**6)}/>")),
        "failed",
        "start tag of more than 10 MB",
    ),
    "some-attributes.xml": Case(
        lambda: esi(device(f"<X {attributes(10**5)}/>")), "failed", "more than 1000 attributes"
    ),
    "namespaces.xml": Case(
        lambda: vendor_specific(f"<a {attributes(200, 'xmlns:n')}/>"),
        "failed",
        "100 namespaces",
    ),
    "same-namespace.xml": Case(lambda: vendor_specific('<a xmlns:n="urn:n" n:b="1"/>' * 200), "stored"),
    "long-namespace.xml": Case(
        lambda: esi(device("<RxPdo><Index>1</Index></RxPdo>" * 10_000)).replace(
            "<EtherCATInfo", f'<EtherCATInfo xmlns:n="urn:{"n" * 4_000_000}"', 1
        ),
        "stored",
    ),
    "unknown-elements.xml": Case(
        lambda: esi(device("<X/>" * (MAX_FINDINGS + 1))), "failed", "values outside the schema"
    ),
    "unknown-values.xml": Case(
        lambda: esi(device(f"<X>{'<Y>1</Y>' * (MAX_FINDINGS + 1)}</X>")), "failed", "values outside the schema"
    ),
    "no-numbers.xml": Case(
        lambda: esi(device('<Sm StartAddress="?">Outputs</Sm>' * (MAX_FINDINGS + 1))), "failed", "against its rules"
    ),
    "huge-number.xml": Case(lambda: esi(device(f'<Sm StartAddress="{"9" * 5_000_000}">Outputs</Sm>')), "stored"),
    "oversampled.xml": Case(
        lambda: esi(device("<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 16, attributes='Sm="0" OSFac="300000000"'))),
        "stored",
    ),
    "long-entries.xml": Case(
        lambda: esi(device("<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", *[2**63 - 1] * 3, attributes='Sm="0"'))),
        "stored",
    ),
    "odd-namespace.xml": Case(
        lambda: vendor_specific('<a xmlns="http://no uri"><b>kept</b></a>'), "recovered", "not a valid URI"
    ),
    "undeclared-prefix.xml": Case(
        lambda: esi(device(faulty_vendor_texts(UNDECLARED_PREFIX))), "recovered", "is not defined"
    ),
    "repeated-attribute.xml": Case(
        lambda: esi(device(faulty_vendor_texts(REPEATED_ATTRIBUTE))), "recovered", "b redefined"
    ),
    "modular-drive.xml": Case(lambda: modular_drive(100), "stored"),
    "utf-7.xml": Case(
        lambda: ('<?xml version="1.0" encoding="UTF-7"?>' + esi(device(name=NAME))).encode("utf-7"),
        "failed",
        "as UTF-8",
    ),
    "utf-16.xml": Case(lambda: esi(device(name=NAME)).encode("utf-16"), "stored"),
    "utf-32.xml": Case(lambda: b"\0\0\xfe\xff" + esi(device(name=NAME)).encode("utf-32-be"), "stored"),
    "no-encoding.xml": Case(
        lambda: '<?xml version="1.0" encoding="martian"?>' + esi(device()), "recovered", "read as utf-8"
    ),
    "nul.xml": Case(lambda: esi(device(name="a\0b")), "recovered", "Invalid character"),
    "truncated.xml": Case(lambda: esi(device("<Sm>Outputs</Sm>"))[:-90], "recovered", "read by recovery"),
    "truncated-early.xml": Case(lambda: b"\xef\xbb\xbf<EtherCATInf", "failed", "not well-formed"),
    "empty.xml": Case(lambda: b"", "failed", "the file is empty"),
    "blank.xml": Case(lambda: b" \n" * 1000, "failed", "the file is empty"),
    "noise.xml": Case(lambda: bytes(range(256)) * 1000, "skipped", "no XML document"),
    "zeros.xml": Case(lambda: bytes(1_000_000), "skipped", "no XML document"),
    "dictionary-outside.xml": Case(
        lambda: esi(device("".join(f"<Profile><DictionaryFile>{name}</DictionaryFile></Profile>" for name in OUTSIDE))),
        "stored",
    ),
}


def member(name: str, content: bytes = b"", method: int = zipfile.ZIP_DEFLATED) -> bytes:
    return members([(name, content or esi(device()).encode())], method)


def members(items: list[tuple[str, bytes]], method: int = zipfile.ZIP_DEFLATED) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as archive:
        for name, content in items:
            archive.writestr(zipfile.ZipInfo(name), content, method)
    return stream.getvalue()


def announcing(size: int, archive: bytes) -> bytes:
    """The archive with another expanded size of its members in its directory."""
    data = bytearray(archive)
    at = data.find(b"PK\x01\x02")
    while at >= 0:
        data[at + 24 : at + 28] = struct.pack("<I", size)
        at = data.find(b"PK\x01\x02", at + 4)
    return bytes(data)


def encrypted(archive: bytes) -> bytes:
    """The archive with the mark of encryption on its only member."""
    data = bytearray(archive)
    for head, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        data[data.find(head) + offset] |= 1
    return bytes(data)


def nested(depth: int) -> bytes:
    content = member("a.xml")
    for _ in range(depth):
        content = member("inner.zip", content)
    return content


def large_directory() -> bytes:
    """An archive of 28 MB whose directory would take a hundred times that in memory."""
    size = 28_000_000
    entry = struct.pack("<4s4B4HL2L5H2L", b"PK\x01\x02", 20, 0, 20, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0) + b"a"
    directory = entry * (size // len(entry))
    end = struct.pack("<4s4H2LH", b"PK\x05\x06", 0, 0, 0, 0, len(directory), 0, 0)
    return b"PK\x03\x04" + directory + end


ARCHIVES = {
    "bomb.zip": Case(lambda: member("a.xml", bytes(60_000_000)), "failed", "more than 500 times its packed size"),
    "bomb-of-announced.zip": Case(
        lambda: announcing(60_000_000, members([(f"{n}.xml", b"<EtherCATInfo/>") for n in range(200)])),
        "failed",
        "expands to more than 8 GB",
    ),
    "lzma-bomb.zip": Case(
        lambda: announcing(2_000, member("a.xml", bytes(1_000), zipfile.ZIP_LZMA)),
        "failed",
        "another method than deflate",
    ),
    "bzip2-bomb.zip": Case(
        lambda: announcing(900, member("a.xml", bytes(1_000), zipfile.ZIP_BZIP2)),
        "failed",
        "another method than deflate",
    ),
    "oversized.zip": Case(lambda: announcing(270_000_000, member("a.xml")), "failed", "larger than 256 MB"),
    "understated.zip": Case(lambda: announcing(20, member("a.xml")), "failed", "cannot be unpacked"),
    "encrypted.zip": Case(
        lambda: encrypted(member("a.xml")), "failed", "is encrypted; pack it anew without a password"
    ),
    "directory.zip": Case(large_directory, "failed", "directory is too large"),
    "cut.zip": Case(lambda: member("a.xml")[:200], "failed", "not a usable zip archive"),
    "no-name.zip": Case(lambda: member("a\nb.xml"), "failed", "rename it"),
    "long-names.zip": Case(
        lambda: members([(f"{'n' * 9_000}{n}.xml", b"") for n in range(2)]), "failed", "2,000 bytes"
    ),
    "deep.zip": Case(lambda: nested(3), "failed", "archives nested deeper than 3"),
    "dots.zip": Case(lambda: member("../../dots.xml"), "stored"),
    "absolute.zip": Case(lambda: member("/absolute.xml"), "stored"),
    "drive.zip": Case(lambda: member("C:\\drive.xml"), "stored"),
    "plain.zip": Case(lambda: nested(2), "stored"),
}


def write_cases(folder: Path) -> None:
    for name, case in {**DOCUMENTS, **ARCHIVES}.items():
        content = case.content()
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.warns(UserWarning, match="Duplicate name"):
        content = members([("a.xml", b"first"), ("a.xml", esi(device()).encode())])
    (folder / "twice.zip").write_bytes(content)
    with (folder / "300-mb.xml").open("wb") as stream:
        stream.write(b"<EtherCATInfo>")
        stream.truncate(300 * 2**20)


FILES = {
    "300-mb.xml": ("failed", "larger than 256 MB"),
    "twice.zip!a.xml": ("stored", None),
    "twice.zip!a.xml (earlier)": ("failed", "another member has the same name"),
    "pipe.xml": ("skipped", "not a regular file"),
    "pipe.zip": ("skipped", "not a regular file"),
    "socket.xml": ("skipped", "not a regular file"),
    "zero.xml": ("skipped", "symbolic link that leads outside"),
    "way-out": ("skipped", "symbolic link to a folder"),
    "link-out.xml": ("skipped", "symbolic link that leads outside"),
    "circle.xml": ("failed", "symbolic links"),
    "nowhere.xml": ("failed", "No such file"),
    "line\\nbreak.xml": ("failed", "rename it"),
    "\\x1b[2J.xml": ("failed", "rename it"),
    "\\udcfc.xml": ("failed", "rename it"),
}


def write_files(folder: Path) -> None:
    outside = folder.parent
    (outside / "secret.txt").write_text(SECRET)
    (outside / "evil.dtd").write_text(f'<!ENTITY e "{SECRET}">')
    external = f"<Object><Index>#x2000</Index><Name>{SECRET}</Name><Type>UINT</Type></Object>"
    content = f"<EtherCATDict><Dictionary><DataTypes/><Objects>{external}</Objects></Dictionary></EtherCATDict>"
    (outside / "outside.xml").write_text(content)
    os.mkfifo(folder / "pipe.xml")
    os.mkfifo(folder / "pipe.zip")
    (folder / "zero.xml").symlink_to("/dev/zero")
    (folder / "way-out").symlink_to(outside)
    (folder / "link-out.xml").symlink_to(outside / "outside.xml")
    (folder / "circle.xml").symlink_to(folder / "circle.xml")
    (folder / "nowhere.xml").symlink_to(folder / "gone")
    for name in ("line\nbreak.xml", "\x1b[2J.xml", os.fsdecode(b"\xfc.xml")):
        (folder / name).write_text(esi(device()))
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(os.path.relpath(folder / "socket.xml"))


def ingest(db: Path, *paths: Path, limit_mb: int | None = None) -> dict:
    """Ingest with two workers in a process of its own; its report, problems and peaks."""
    lowered = f"import resource; resource.setrlimit(resource.RLIMIT_AS, ({limit_mb} << 20,) * 2)\n" if limit_mb else ""
    command = [sys.executable, "-c", lowered + INGEST, str(db), *map(str, paths)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert run.stderr == ""
    return json.loads(run.stdout)


@pytest.fixture(scope="module")
def hostile(tmp_path_factory, data) -> tuple[dict, Path]:
    """All of it in one ingest: its report and the catalog."""
    base = tmp_path_factory.mktemp("hostile")
    folder = base / "in"
    folder.mkdir()
    write_cases(folder)
    write_files(folder)
    (folder / GOOD).write_bytes((data / GOOD).read_bytes())
    return ingest(base / "c.db", folder), base / "c.db"


def lines_of(report: dict, name: str) -> list[tuple[str, str | None]]:
    """Status and message of an input and of all members of an archive."""
    return [
        (status, message)
        for path, (status, message) in report["lines"].items()
        if path == name or (name.endswith(".zip") and path.startswith(f"{name}!"))
    ]


@pytest.mark.parametrize(
    ("name", "status", "words"),
    [
        *((name, case.status, case.words) for name, case in {**DOCUMENTS, **ARCHIVES}.items()),
        *((name, *expected) for name, expected in FILES.items()),
    ],
)
def test_every_input_has_a_status_and_a_line_that_says_why(hostile, name, status, words):
    lines = lines_of(hostile[0], name)
    assert {found for found, _ in lines} == {status}
    for _, message in lines:
        assert (message is None) == (words is None)
        if message is not None:
            assert words in message
            assert len(message) < 400
            assert message.isprintable()


def test_nothing_else_is_reported_and_no_input_is_missing(hostile):
    names = {path.split(".zip!")[0] + (".zip" if ".zip!" in path else "") for path in hostile[0]["lines"]}
    expected = {*DOCUMENTS, *ARCHIVES, *(name.split("!")[0] for name in FILES), GOOD}
    assert names == expected


def test_the_good_document_is_stored_and_the_catalog_is_sound(hostile):
    report, db = hostile
    assert report["lines"][GOOD] == ["stored", None]
    assert report["problems"] == []
    assert rows(db, "SELECT count(*) FROM devices WHERE product_code = ?", 0x0D080808) != [(0,)]


def test_memory_is_bounded(hostile):
    main, workers = hostile[0]["peaks_mb"]
    assert main < MEMORY_MB
    assert workers < MEMORY_MB


def test_nothing_from_outside_the_folder_is_in_the_catalog(hostile):
    content = hostile[1].read_bytes()
    assert SECRET.encode() not in content
    assert b"root:" not in content


def test_references_that_lead_outside_are_told(hostile):
    found = rows(
        hostile[1],
        "SELECT rule FROM findings JOIN sources ON sources.id = source_id WHERE member = ? AND rule = 'L60'",
        "dictionary-outside.xml",
    )
    assert len(found) == len(OUTSIDE)


def test_what_stands_in_other_encodings_is_read(hostile):
    query = "SELECT count(*) FROM device_names WHERE text = ?"
    assert rows(hostile[1], query, NAME) == [(1,)], "one content, two documents"


def test_a_document_that_takes_more_memory_than_allowed_fails_alone(tmp_path, data):
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / GOOD).write_bytes((data / GOOD).read_bytes())
    (tmp_path / "in" / "large.xml").write_text(esi(device("<Sm/>" * 3_000_000)))
    report = ingest(tmp_path / "c.db", tmp_path / "in", limit_mb=400)
    assert report["lines"][GOOD] == ["stored", None]
    assert report["lines"]["large.xml"][0] == "failed"
    assert "memory" in report["lines"]["large.xml"][1]
    assert report["problems"] == []


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_unreadable_files_and_folders_are_named(tmp_path, data):
    folder = tmp_path / "in"
    (folder / "closed").mkdir(parents=True)
    for name in (GOOD, "closed.xml", "closed.zip", "closed/a.xml"):
        (folder / name).write_bytes((data / GOOD).read_bytes())
    for name in ("closed.xml", "closed.zip", "closed"):
        (folder / name).chmod(0)
    report = ingest(tmp_path / "c.db", folder)
    (folder / "closed").chmod(0o700)
    assert {path: line[0] for path, line in report["lines"].items()} == {
        GOOD: "stored",
        "closed.xml": "failed",
        "closed.zip": "failed",
        "closed": "failed",
    }
