"""Folders and archives: references that vendors write, and those that must not lead outside."""

import errno
import io
import zipfile

import pytest
from hypothesis import given
from hypothesis import strategies as st
from snippets import device, esi, write

from esicatalog.errors import BrokenDocument, InputError, UnreadableDocument
from esicatalog.esi import containers
from esicatalog.esi.containers import Archive, Folder, resolve_reference
from esicatalog.esi.reader import read_esi

DICTIONARY = (
    "<EtherCATDict><Dictionary><DataTypes><DataType><Name>UINT</Name><BitSize>16</BitSize></DataType></DataTypes>"
    "<Objects><Object><Index>#x2000</Index><Name>External</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    "</Objects></Dictionary></EtherCATDict>"
)


def zipped(**members: bytes) -> bytes:
    """A zip archive; ``__`` in a name is ``/`` and ``_dot_`` is ``.``."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name.replace("__", "/").replace("_dot_", "."), content)
    return stream.getvalue()


def containers_with(tmp_path, *members: str):
    """The same members as a folder and as an archive."""
    folder = write(tmp_path / "folder", dict.fromkeys(members, "x"))
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name in members:
            archive.writestr(name, "x")
    return Folder(folder), Archive(stream.getvalue())


@pytest.mark.parametrize(
    ("document", "reference", "found"),
    [
        ("EL.xml", "Dict.xml", "Dict.xml"),
        ("EL.xml", r"Sub\Deep Dict.xml", "Sub/Deep Dict.xml"),
        ("EL.xml", "SUB/deep dict.XML", "Sub/Deep Dict.xml"),
        ("EL.xml", "./Dict.xml", "Dict.xml"),
        ("EL.xml", "  Dict.xml  ", "Dict.xml"),
        ("Sub/EL.xml", r"..\Dict.xml", "Dict.xml"),
        ("Sub/EL.xml", "Deep Dict.xml", "Sub/Deep Dict.xml"),
        ("EL.xml", r"Sub\..\Dict.xml", "Dict.xml"),
    ],
)
def test_references_as_vendors_write_them(tmp_path, document, reference, found):
    for container in containers_with(tmp_path, "Dict.xml", "Sub/Deep Dict.xml"):
        assert resolve_reference(container, document, reference) == found


@pytest.mark.parametrize(
    ("reference", "found"),
    [
        ("dict.xml", "dict.xml"),
        ("Dict.xml", "Dict.xml"),
        (r"x\a.xml", "x/a.xml"),
        ("X/a.xml", "X/a.xml"),
        ("x/A.XML", "x/a.xml"),
        ("X/A.XML", "X/a.xml"),
        (r"y\b.xml", "y/b.xml"),
        (r"Y\B.xml", "y/b.xml"),
        ("DICT.xml", "Dict.xml"),
    ],
)
def test_what_is_written_as_in_the_document_comes_first(tmp_path, reference, found):
    members = ("dict.xml", "Dict.xml", "x/a.xml", "X/a.xml", "Y/other.xml", "y/b.xml")
    folder, archive = containers_with(tmp_path, *members)
    if not (folder.root / "Dict.xml").samefile(folder.root / "dict.xml"):
        assert resolve_reference(folder, "EL.xml", reference) == found
    assert resolve_reference(archive, "EL.xml", reference) == found


def test_symbolic_links_do_not_multiply_the_ways(tmp_path):
    folder = write(tmp_path / "folder", {"b.xml": "x"})
    for name in ("loop", "Loop"):
        (folder / name).symlink_to(folder)
    assert resolve_reference(Folder(folder), "EL.xml", "loop/" * 40 + "b.xml") == "loop/" * 40 + "b.xml"
    (folder / "end.xml").symlink_to(folder / "end.xml")
    assert resolve_reference(Folder(folder), "EL.xml", "end.xml") is None


def test_an_archive_whose_names_have_backslashes(tmp_path):
    """As .NET wrote them before 4.6.1; a folder's own entry ends in one."""
    archive = Archive(zipped(**{"ESI\\": b"", "ESI\\Dev_dot_xml": b"1", "ESI\\d_dot_xml": b"2", "d_dot_xml": b"3"}))
    assert archive.members() == [("ESI/Dev.xml", 1), ("ESI/d.xml", 1), ("d.xml", 1)]
    assert archive.read("ESI/d.xml") == b"2"
    assert resolve_reference(archive, "ESI/Dev.xml", "d.xml") == "ESI/d.xml"
    assert resolve_reference(archive, "ESI/Dev.xml", r"..\D.xml") == "d.xml"
    both = Archive(zipped(**{"ESI\\a_dot_xml": b"1", "ESI__a_dot_xml": b"2"}))
    assert (both.repeated, both.read("ESI/a.xml")) == (["ESI/a.xml"], b"2")


def test_an_archive_whose_names_begin_with_the_folder_itself():
    """As tar-like packers write them, the folder's own entry too."""
    members = {"./": b"", "./ESI/Dev_dot_xml": b"1", "././d_dot_xml": b"2", "./_dot_x_dot_xml": b"3"}
    archive = Archive(zipped(**members))
    assert archive.members() == [(".x.xml", 1), ("ESI/Dev.xml", 1), ("d.xml", 1)]
    assert (archive.read("d.xml"), resolve_reference(archive, "ESI/Dev.xml", r"..\D.xml")) == (b"2", "d.xml")


@pytest.mark.parametrize(("encoding", "is_flagged"), [("utf-8", True), ("utf-8", False), ("cp437", False)])
def test_names_of_members_in_any_encoding(encoding, is_flagged):
    """The flag says UTF-8; the usual ``zip`` of Unix writes UTF-8 without it, programs of DOS their code page."""

    class Info(zipfile.ZipInfo):
        def _encodeFilenameFlags(self):  # noqa: N802
            return self.filename.encode(encoding), self.flag_bits | 0x800 * is_flagged

    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr(Info("Geräte/Wörter.xml"), b"1")
        archive.writestr(Info("Geräte/Gerät.xml"), b"2")
    archive = Archive(stream.getvalue())
    assert archive.members() == [("Geräte/Gerät.xml", 1), ("Geräte/Wörter.xml", 1)]
    assert archive.read("Geräte/Wörter.xml") == b"1"
    assert resolve_reference(archive, "Geräte/Gerät.xml", "wörter.xml") == "Geräte/Wörter.xml"


def test_accented_letters_may_be_made_up_of_two_characters(tmp_path):
    """As macOS writes names; a name that is written as in the document comes first."""
    one, two = "W\u00f6rter.xml", "Wo\u0308rter.xml"
    for container in containers_with(tmp_path, two):
        assert resolve_reference(container, "EL.xml", one) == two
        assert resolve_reference(container, "EL.xml", two.upper()) == two
    for container in containers_with(tmp_path / "both", one, two):
        assert [resolve_reference(container, "EL.xml", name) for name in (one, two)] == [one, two]


@pytest.mark.parametrize(
    "reference",
    [
        *(
            "../Dict.xml",
            r"..\..\Dict.xml",
            "Sub/../../Dict.xml",
            "/Dict.xml",
            r"\Dict.xml",
            r"C:\Dict.xml",
            "C:Dict.xml",
        ),
        *("file:///Dict.xml", "http://example.org/Dict.xml", r"\\host\share\Dict.xml", "", "..", ".", "missing.xml"),
    ],
)
def test_references_that_lead_nowhere_or_outside(tmp_path, reference):
    write(tmp_path, {"Dict.xml": "outside"})
    for container in containers_with(tmp_path, "Dict.xml", "Sub/Dict.xml"):
        assert resolve_reference(container, "EL.xml", reference) is None


def test_a_symbolic_link_that_leads_outside_is_not_followed(tmp_path):
    folder = write(tmp_path / "folder", {"Inside.xml": "x"})
    write(tmp_path, {"Secret.xml": "secret"})
    (folder / "Link.xml").symlink_to(tmp_path / "Secret.xml")
    (folder / "Way").symlink_to(tmp_path)
    (folder / "Good.xml").symlink_to(folder / "Inside.xml")
    assert resolve_reference(Folder(folder), "EL.xml", "Link.xml") is None
    assert resolve_reference(Folder(folder), "EL.xml", "Way/Secret.xml") is None
    assert resolve_reference(Folder(folder), "EL.xml", "Good.xml") == "Good.xml"


def test_an_external_dictionary_is_pulled_in(tmp_path):
    profile = r"<Profile><ProfileNo>402</ProfileNo><DictionaryFile>DICTS\drive.XML</DictionaryFile></Profile>"
    write(tmp_path, {"drive.xml": esi(device(profile)), "dicts/Drive.xml": DICTIONARY})
    document = read_esi(tmp_path / "drive.xml")
    (found,) = document.document.infos[0].devices
    assert [o.object_index for o in found.profiles[0].dictionary.objects] == [0x2000]
    assert document.document.references[0].location == "dicts/Drive.xml"
    assert document.findings == ()


def test_a_missing_dictionary_is_told_at_the_device(tmp_path):
    profile = "<Profile><DictionaryFile>gone.xml</DictionaryFile></Profile>"
    write(tmp_path, {"drive.xml": "\n\n" + esi("\n" + device(profile))})
    document = read_esi(tmp_path / "drive.xml")
    (finding,) = document.findings
    assert (finding.rule, finding.line) == ("L60", 4)
    assert "gone.xml" in finding.message


def test_a_dictionary_that_is_something_else_is_told(tmp_path):
    profile = "<Profile><DictionaryFile>other.xml</DictionaryFile></Profile>"
    write(tmp_path, {"drive.xml": esi(device(profile)), "other.xml": esi(device())})
    (finding,) = read_esi(tmp_path / "drive.xml").findings
    assert finding.rule == "L60"
    assert "EtherCATInfo" in finding.message


@pytest.mark.parametrize(
    ("reference", "content", "words"),
    [
        ("DictionaryFile", "<EtherCATDict/>", "holds no Dictionary"),
        ("DictionaryFile", "<EtherCATDiag/>", "its root EtherCATDiag does not fit DictionaryFile"),
        ("DiagFile", "<EtherCATDiag/>", "holds no DiagMessages"),
        ("DiagFile", "<EtherCATDict/>", "its root EtherCATDict does not fit DiagFile"),
        ("InfoReference", "<EtherCATModule><Vendor><Id>1</Id></Vendor></EtherCATModule>", "holds no Module"),
        ("InfoReference", "<EtherCATDict/>", "its root EtherCATDict does not fit InfoReference"),
    ],
)
def test_a_referenced_document_without_what_is_looked_for_is_told(tmp_path, reference, content, words):
    named = f"<{reference}>other.xml</{reference}>"
    text = esi(device("" if reference == "InfoReference" else f"<Profile>{named}</Profile>"))
    if reference == "InfoReference":
        text = text.replace("<Vendor>", f"{named}<Vendor>", 1)
    write(tmp_path, {"drive.xml": text, "other.xml": content})
    (finding,) = read_esi(tmp_path / "drive.xml").findings
    assert (finding.rule, finding.message) == ("L60", f"{reference} 'other.xml' cannot be used: {words}")


def test_a_document_that_refers_to_itself_ends(tmp_path):
    document = esi(device()).replace("<Vendor>", "<InfoReference>self.xml</InfoReference><Vendor>", 1)
    write(tmp_path, {"self.xml": document})
    assert len(read_esi(tmp_path / "self.xml").document.infos[0].devices) == 1


def test_an_archive_inside_an_archive():
    inner = zipped(Sub__a_dot_xml=b"content")
    outer = Archive(zipped(inner_dot_zip=inner))
    assert Archive(outer.read("inner.zip")).read("Sub/a.xml") == b"content"


def test_a_member_that_holds_more_than_it_announces():
    content = bytearray(zipped(a_dot_xml=b"x" * 1000))
    for offset in (content.find(b"PK\x03\x04") + 22, content.find(b"PK\x01\x02") + 24):
        content[offset : offset + 4] = (10).to_bytes(4, "little")
    with pytest.raises(BrokenDocument):
        Archive(bytes(content)).read("a.xml")


def test_archives_with_too_much_are_refused(monkeypatch):
    archive = zipped(a=b"1" * 50, b=b"2" * 50, c=b"3" * 50)
    monkeypatch.setattr(containers, "MAX_MEMBERS", 2)
    with pytest.raises(InputError, match="members"):
        Archive(archive)
    monkeypatch.setattr(containers, "MAX_MEMBERS", 3)
    monkeypatch.setattr(containers, "MAX_EXPANDED_BYTES", 149)
    with pytest.raises(InputError, match="expands"):
        Archive(archive)
    monkeypatch.setattr(containers, "MAX_EXPANDED_BYTES", 150)
    monkeypatch.setattr(containers, "MAX_DOCUMENT_BYTES", 49)
    with pytest.raises(BrokenDocument, match="larger"):
        Archive(archive).read("a")


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04broken", b"no archive"])
def test_what_is_no_archive(content):
    with pytest.raises(InputError):
        Archive(content)


def test_damaged_members_are_broken_documents():
    content = bytearray(zipped(a_dot_xml=bytes(range(256)) * 40))
    start = content.find(b"a.xml") + 5
    content[start + 10 : start + 60] = b"\xff" * 50
    with pytest.raises(BrokenDocument):
        Archive(bytes(content)).read("a.xml")


@given(st.binary(max_size=5000), st.integers(1, 50), st.sampled_from([zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED]))
def test_every_member_is_what_was_packed(content, times, method):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as archive:
        archive.writestr("before.xml", b"before")
        archive.writestr("a.xml", content * times)
    assert Archive(stream.getvalue()).read("a.xml") == content * times


@pytest.mark.parametrize("method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])
def test_a_member_with_another_checksum_is_a_broken_document(method):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as archive:
        archive.writestr("a.xml", b"<EtherCATInfo/>")
    content = bytearray(stream.getvalue())
    content[content.find(b"PK\x01\x02") + 16] ^= 1
    with pytest.raises(BrokenDocument, match="cannot be unpacked"):
        Archive(bytes(content)).read("a.xml")


def test_a_member_that_ends_too_early_is_a_broken_document():
    content = bytearray(zipped(a_dot_xml=bytes(range(256)) * 4))
    directory = content.find(b"PK\x01\x02")
    packed_size = int.from_bytes(content[directory + 20 : directory + 24], "little")
    content[directory + 20 : directory + 24] = (packed_size - 20).to_bytes(4, "little")
    with pytest.raises(BrokenDocument, match="cannot be unpacked"):
        Archive(bytes(content)).read("a.xml")


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (OSError(errno.EIO, "Input/output error"), "cannot be read: Input/output error"),
        (MemoryError(), "cannot be read: not enough memory"),
    ],
)
def test_a_member_that_is_there_and_cannot_be_read(tmp_path, monkeypatch, error, words):
    path = tmp_path / "a.zip"
    path.write_bytes(zipped(a_dot_xml=bytes(range(256)) * 100))
    archive = Archive(path)

    def refused(*arguments):
        raise error

    monkeypatch.setattr(containers._Guarded, "read", refused)
    with pytest.raises(UnreadableDocument, match=words):
        archive.read("a.xml")
    with pytest.raises(UnreadableDocument, match=words):
        Archive(path)


def test_a_member_that_lies_before_the_beginning_of_the_file(tmp_path):
    """The system refuses to go there as it refuses to read; the archive is damaged all the same."""
    content = bytearray(zipped(a_dot_xml=b"content"))
    end = content.rfind(b"PK\x05\x06")
    at = int.from_bytes(content[end + 16 : end + 20], "little")
    content[end + 16 : end + 20] = (at + 10).to_bytes(4, "little")
    (tmp_path / "a.zip").write_bytes(content)
    with pytest.raises(BrokenDocument) as raised:
        Archive(tmp_path / "a.zip").read("a.xml")
    assert not isinstance(raised.value, UnreadableDocument)


def test_a_member_that_announces_more_packed_bytes_than_any_document_has():
    """Nothing of that size is allocated to read it."""
    content = bytearray(zipped(a_dot_xml=b"<EtherCATInfo/>"))
    for offset in (content.find(b"PK\x03\x04") + 18, content.find(b"PK\x01\x02") + 20):
        content[offset : offset + 4] = (0xFFFF_FFFE).to_bytes(4, "little")
    with pytest.raises(BrokenDocument, match="larger than 256 MB"):
        Archive(bytes(content)).read("a.xml")


def test_a_member_whose_sizes_stand_behind_it():
    """As archives are written into a pipe."""

    class Pipe(io.BytesIO):
        def seekable(self) -> bool:
            return False

        def tell(self) -> int:
            raise OSError

    stream = Pipe()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.xml", b"content" * 50)
    assert Archive(stream.getvalue()).read("a.xml") == b"content" * 50
