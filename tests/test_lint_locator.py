"""From places in records to element paths and lines, and what is remembered of records."""

import pytest
from snippets import device, dictionary, esi, pdo

from esicatalog.esi import lines
from esicatalog.esi.documents import parse_document
from esicatalog.esi.lines import Lines
from esicatalog.esi.notes import Notes
from esicatalog.esi.reader import Reader
from esicatalog.esi.tree import DocumentTree
from esicatalog.lint.linter import Linter
from esicatalog.lint.locator import Locator

OBJECT = "<Object><Index>#x2000</Index><Name>O</Name><Type>T</Type><BitSize>8</BitSize></Object>"
TWO_DEVICES = esi(
    device("\n<Info><Electrical>\n<EBusCurrent>5</EBusCurrent></Electrical></Info>")
    + "\n"
    + device(f"\n{pdo('TxPdo', '#x1A00', 8)}\n{pdo('TxPdo', '#x1A01', 8, 16)}\n{dictionary('', OBJECT)}")
)
DEVICES = "EtherCATInfo/Descriptions/Devices"


def locator(text: str) -> Locator:
    content = text.encode()
    return Locator(Reader().read(content).document, lambda: DocumentTree(parse_document(content).root, Lines(content)))


@pytest.mark.parametrize(
    ("place", "path", "line"),
    [
        (("infos", 0), "EtherCATInfo", 1),
        (("infos", 0, "vendor", "vendor_id"), "EtherCATInfo/Vendor/Id", 1),
        (("infos", 0, "devices", 0, "e_bus_current_ma"), f"{DEVICES}/Device[0]/Info/Electrical/EBusCurrent", 3),
        (("infos", 0, "devices", 1), f"{DEVICES}/Device[1]", 4),
        (("infos", 0, "devices", 1, "product_code"), f"{DEVICES}/Device[1]/Type", 4),
        (("infos", 0, "devices", 1, "tx_pdos", 0, "entries", 0), f"{DEVICES}/Device[1]/TxPdo[0]/Entry", 5),
        (("infos", 0, "devices", 1, "tx_pdos", 1, "sm"), f"{DEVICES}/Device[1]/TxPdo[1]", 6),
        (("infos", 0, "devices", 1, "tx_pdos", 1, "entries", 1), f"{DEVICES}/Device[1]/TxPdo[1]/Entry[1]", 6),
        (
            ("infos", 0, "devices", 1, "profiles", 0, "dictionary", "objects", 0, "type"),
            f"{DEVICES}/Device[1]/Profile/Dictionary/Objects/Object/Type",
            7,
        ),
    ],
)
def test_a_place_becomes_path_and_line(place, path, line):
    assert locator(TWO_DEVICES).position(place) == (path, line)


def test_what_the_document_does_not_have_lies_at_the_element_around_it():
    position = locator(TWO_DEVICES).position(("infos", 0, "devices", 1, "mailbox"))
    assert position == (f"{DEVICES}/Device[1]/Mailbox", 4)


@pytest.mark.parametrize(
    ("text", "place", "path"),
    [
        (
            f"<EtherCATInfoList>\n{esi()}\n{esi(device())}</EtherCATInfoList>",
            ("infos", 1, "devices", 0, "physics"),
            "Device",
        ),
        (
            "<EtherCATModule><Vendor/><Modules>\n\n<Module/></Modules></EtherCATModule>",
            ("infos", 0, "modules", 0),
            "Module",
        ),
        (
            f"<EtherCATDict><Dictionary><Objects>\n\n{OBJECT}</Objects></Dictionary></EtherCATDict>",
            ("dictionary", "objects", 0),
            "Object",
        ),
    ],
)
def test_every_kind_of_document(text, place, path):
    root = parse_document(text.encode()).root
    (element,) = root.iter(path)
    assert locator(text).position(place) == (Notes().path(element), 3)


def test_lines_beyond_what_libxml2_counts():
    """Elements without text beyond line 65535 have no line for libxml2; whether words were met before matters not."""
    mailbox = '<Mailbox>\n<CoE SdoInfo="1"/>\n</Mailbox>\n<Eeprom\n><ByteSize>16</ByteSize></Eeprom>'
    content = esi(
        "\n" * 65_530 + device(f"<Fmmu/>\n<Sm/>\n{mailbox}", revision="#x1") + "<!-- <Sm/>\n -->"
        + "\n" * 70_000 + device(f"<Fmmu/>\n<Sm/>\n{mailbox}", revision="#x2")
    ).encode()  # fmt: skip
    expected = {
        field: [number for number, line in enumerate(content.decode().split("\n"), 1) if words in line]
        for field, words in {"fmmus": "<Fmmu/>", "mailbox": "<Mailbox>", "coe_sdo_info": "<CoE "}.items()
    }
    assert expected["coe_sdo_info"] == [65_534, 135_541]
    expected["sync_managers"] = [line + 1 for line in expected["fmmus"]]
    expected["eeprom"] = [line + 3 for line in expected["coe_sdo_info"]]  # where its start tag ends
    reader = Reader()
    trees = [reader.read_tree(content) for _ in range(2)]
    trees.append((trees[0][0], lambda: DocumentTree(parse_document(content).root, Lines(content))))
    for read, tree in trees:
        locator = Locator(read.document, tree)
        for number in range(2):
            around = ("infos", 0, "devices", number)
            for place in (("fmmus", 0), ("sync_managers", 0), ("mailbox",), ("mailbox", "coe_sdo_info"), ("eeprom",)):
                field = place[0] if place[-1] == 0 else place[-1]
                assert locator.position((*around, *place)).line == expected[field][number], (field, number)


def test_findings_of_reading_know_lines_beyond_what_libxml2_counts():
    content = esi("\n" * 70_000 + device("\n<Sm Junk='1'/>\n<Junk/>")).encode()
    assert [finding.line for finding in Reader().read(content).findings] == [70_002, 70_003]


def test_lines_are_counted_for_some_tags_only(monkeypatch):
    """Somebody may invent a tag for every element; who would count each looks through the document again and again."""
    content = esi("\n" * 70_000 + device("".join(f"\n<Junk{number}/>" for number in range(200)))).encode()
    monkeypatch.setattr(lines, "_MOST_BYTES", 50 * len(content))
    found = [finding.line for finding in Reader().read(content).findings]
    assert found == [*range(70_002, 70_052), *[65_535] * 150]  # which is all that the parser knows


def test_the_elements_are_asked_for_once():
    content = esi(device() + device(revision="#x2")).encode()
    asked = []

    def tree():
        asked.append(1)
        return DocumentTree(parse_document(content).root, Lines(content))

    found = Locator(Reader().read(content).document, tree)
    for number in range(2):
        found.position(("infos", 0, "devices", number))
    assert asked == [1]


def test_nothing_to_report_asks_for_no_tree():
    def tree():
        raise AssertionError("parsed again")

    read = Reader().read(esi(device()).encode())
    assert Linter().document(read, tree) == []


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
@pytest.mark.parametrize("end", ["\r\n", "\r"])
def test_lines_are_those_of_any_line_end(end, encoding):
    """XML 1.0 section 2.11: a carriage return alone ends a line, too; U+010A and U+0D3E hold such bytes in UTF-16."""
    described = device("\n<Junk/>\n<Sm\nJunk='1'/>", name="\u010a\u0d3e")
    text = "\n".join(["<?xml version='1.0'?>", esi("\n" + described + "\n")])
    expected, found = (Reader().read(text.replace("\n", way).encode(encoding)) for way in ("\n", end))
    assert [(finding.line, finding.path) for finding in found.findings] == [
        (4, f"{DEVICES}/Device/Junk"),
        (6, f"{DEVICES}/Device/Sm"),
    ]
    assert found == expected
