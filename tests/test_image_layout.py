"""When two process images have the same layout: the signature of the catalog and the comparison say it alike."""

import re

import pytest
from snippets import device, esi, only_device, pdo, rows
from test_search import catalog_of

from esicatalog import Catalog
from esicatalog.catalog.query import ConnectionQuery
from esicatalog.catalog.reader import RecordReader
from esicatalog.model.compare_facts import Difference
from esicatalog.model.compare_image import compare_images, layout_difference
from esicatalog.model.image_layout import layout_signature
from esicatalog.model.process_data import ProcessData

SMS = "<Sm>Outputs</Sm><Sm>Inputs</Sm>"
LISTED = '<Dc><OpMode><Name>m</Name><AssignActivate>0</AssignActivate><Sm No="0"><Pdo>{}</Pdo></Sm></OpMode></Dc>'
VARIABLE = '<RxPdo Sm="0"><Index>{}</Index><Name>R</Name></RxPdo>'


def rx(*entries: tuple[int, str], index: str = "#x1600", attributes: str = "") -> str:
    """A RxPDO of SM0; entries are (subindex, bit length) of 0x7000, subindex 0 is a gap."""
    found = "".join(
        f"<Entry><Index>{'#x7000' if sub else 0}</Index><SubIndex>{sub}</SubIndex>"
        + (f"<BitLen>{bits}</BitLen>" if bits else "")
        + "</Entry>"
        for sub, bits in entries
    )
    return f'<RxPdo Sm="0" {attributes}><Index>{index}</Index><Name>R</Name>{found}</RxPdo>'


UPLOAD = '<Mailbox><CoE PdoUpload="1"/></Mailbox>'
A, B, GAP_7 = (1, "1"), (2, "8"), (0, "7")
SAME = {
    "a gap in one or two": (SMS + rx(A, GAP_7, B), SMS + rx(A, (0, "1"), (0, "6"), B)),
    "a gap across PDOs": (SMS + rx(A, GAP_7) + rx(B, index="#x1601"), SMS + rx(A) + rx(GAP_7, B, index="#x1601")),
    "a gap of no bits": (SMS + rx(A, B), SMS + rx(A, (0, "0"), B)),
    "an object in no bits": (SMS + rx(A, B), SMS + rx(A, (3, "0"), B)),
    "a gap in two behind what has no length": (
        SMS + rx((3, ""), A, GAP_7, B),
        SMS + rx((3, ""), A, (0, "3"), (0, "0"), (0, "4"), B),
    ),
    "no role": (SMS + rx(A), "<Sm></Sm><Sm>Inputs</Sm>" + rx(A)),
    "a role of its own": (SMS + rx(A), "<Sm>OrbitaOut</Sm><Sm>Inputs</Sm>" + rx(A)),
    "a SyncManager of no bits": (SMS + rx(A), "<Sm>Outputs</Sm>" + rx(A)),
    "the PDO that maps it": (SMS + rx(A), SMS + rx(A, index="#x1601")),
    "PDOs of the device": (UPLOAD + "<Sm>Outputs</Sm>", UPLOAD + "<Sm>Outputs</Sm>"),
    "the same DefaultSize": ('<Sm DefaultSize="8">Outputs</Sm>', '<Sm DefaultSize="8">Outputs</Sm><Sm>Inputs</Sm>'),
}
OTHER = {
    "an entry moved": (SMS + rx(A, GAP_7, B), SMS + rx(A, B, GAP_7)),
    "a gap at the end": (SMS + rx(A), SMS + rx(A, GAP_7)),
    "a gap of no length": (SMS + rx((3, ""), A), SMS + rx((3, ""), (0, ""), A)),
    "the direction": (
        '<Sm ControlByte="#x64">Outputs</Sm>' + rx(A),
        '<Sm ControlByte="#x20">Outputs</Sm>' + rx(A),
    ),
    "a DefaultSize without PDO": ('<Sm DefaultSize="8">Outputs</Sm>', '<Sm DefaultSize="64">Outputs</Sm>'),
    "PDOs of the device or none": (UPLOAD + "<Sm>Outputs</Sm>", "<Sm>Outputs</Sm>"),
    "PDOs of the device with a DefaultSize": (UPLOAD + '<Sm DefaultSize="8">Outputs</Sm>', UPLOAD + "<Sm>Outputs</Sm>"),
    "a DefaultSize or none": ('<Sm DefaultSize="8">Outputs</Sm>', '<Sm DefaultSize="0">Outputs</Sm>'),
    "which PDO has variable content": (SMS + VARIABLE.format("#x1600"), SMS + VARIABLE.format("#x1601")),
    "which PDO is listed and not described": (SMS + LISTED.format("#x1602"), SMS + LISTED.format("#x1603")),
    "a PDO that is listed and not described or none": (SMS + LISTED.format("#x1602"), SMS),
    "a SubIndex that cannot be read or none": (SMS + rx(("x1", "8")), SMS + rx((0, "8")).replace(">0<", ">#x7000<", 1)),
    "which SubIndex cannot be read": (SMS + rx(("x1", "8")), SMS + rx(("x2", "8"))),
    "an entry behind an object in no bits": (SMS + rx(A, (3, "0"), B), SMS + rx(A, (3, "0"), (4, "8"))),
    "variable content or none": (SMS + VARIABLE.format("#x1600"), SMS),
    "what lies behind an entry without length": (SMS + rx(A, (3, ""), B), SMS + rx(A, (3, ""), (4, "8"))),
    "which PDO has an entry without length": (SMS + rx(A, (3, "")), SMS + rx(A, (3, ""), index="#x1601")),
    "where the unknown begins": (
        SMS + rx(GAP_7) + VARIABLE.format("#x1601") + rx(B, index="#x1602"),
        SMS + VARIABLE.format("#x1601") + rx(GAP_7, B, index="#x1602"),
    ),
    "what no SyncManager holds": (
        SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="0" OSFac="300000000"'),
        SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="0" OSFac="32768"'),
    ),
}


def verdicts(left: str, right: str) -> tuple[bool, bool]:
    """Whether the layouts are the same: as the signature says, as the comparison says from both sides."""
    ours, theirs = (only_device(esi(device(content))) for content in (left, right))
    found, back = list(compare_images(ours, (), theirs, ())), list(compare_images(theirs, (), ours, ()))
    assert [item.place for item in found] == [item.place for item in back]
    assert all(item.counts for item in found)
    return ProcessData(ours).image_signature == ProcessData(theirs).image_signature, not found


@pytest.mark.parametrize(("left", "right"), SAME.values(), ids=SAME)
def test_layouts_that_are_the_same(left, right):
    assert verdicts(left, right) == (True, True)


@pytest.mark.parametrize(("left", "right"), OTHER.values(), ids=OTHER)
def test_layouts_that_differ(left, right):
    assert verdicts(left, right) == (False, False)


_PLACE = re.compile(r"SM(\d+) byte (\d+\.\d) is (.+) here, (.+) there")
_BY_DIFFERENCE = {
    "size": "described bits are|without known place: ",
    "direction": "SyncManagers with PDOs are",
    "without known place": "without known place: ",
}


def contradiction(words: str, differences: list[Difference]) -> str | None:
    """In what the words of ``identify`` say another difference of two descriptions than ``diff``, None if in nothing.

    Of a SyncManager that only one has ``diff`` tells the size, ``identify`` its first entry.
    """
    first = {place.partition(" ")[0]: place for place in reversed([d.place for d in differences]) if " at " in place}
    one_sided = {d.place.partition(" ")[0] for d in differences if d.left is None or d.right is None}
    found = _PLACE.match(words)
    if found is None:
        kinds = "|".join(_BY_DIFFERENCE[d.place.partition(" ")[2]] for d in differences if " at " not in d.place)
        return "no place" if first or not re.search(kinds, words) else None
    sm, at, _, _ = found.groups()
    if f"SM{sm}" not in first:
        return "a place" if f"SM{sm}" not in one_sided else None
    return "another place" if first[f"SM{sm}"] != f"SM{sm} at {at}" else None


@pytest.mark.parametrize(("left", "right"), OTHER.values(), ids=OTHER)
def test_identify_names_the_difference_that_diff_names(tmp_path, left, right):
    ours, theirs = (only_device(esi(device(content))) for content in (left, right))
    db = catalog_of(tmp_path, esi(device(left, revision="#x1") + device(right, revision="#x2")))
    with Catalog.open(db) as catalog:
        (warning,) = catalog.identify(0xE5C, 1, 1).warnings
    assert contradiction(warning.partition("for example: ")[2], list(compare_images(ours, (), theirs, ()))) is None


def test_a_gap_is_no_place_of_its_own(tmp_path):
    """Where the one has a gap and behind it an entry, the other has an entry in the gap."""
    left, right = SMS + rx((0, "14"), B), SMS + rx((0, "6"), A, (0, "7"), B)
    db = catalog_of(tmp_path, esi(device(left, revision="#x1") + device(right, revision="#x2")))
    with Catalog.open(db) as catalog:
        (warning,) = catalog.identify(0xE5C, 1, 1).warnings
    assert warning.endswith("for example: SM0 byte 0.6 is nothing here, 0x7000:01 (1 bit) there")


@pytest.mark.corpus
def test_identify_names_the_difference_that_diff_names_of_real_revisions(corpus_db):
    """What the lookup reads, without dictionaries where these say nothing of it, has the layout that is stored."""
    pairs = "SELECT previous_id, device_id FROM device_revisions WHERE layout_changed = 1"
    signatures = dict(rows(corpus_db, "SELECT device_id, image_signature FROM device_facts"))
    wrong = []
    with Catalog.open(corpus_db) as catalog, catalog._connection() as connection:
        reader, lookup = RecordReader(ConnectionQuery(connection)), catalog._lookup_of_file()
        for pair in rows(corpus_db, pairs):
            (ours, theirs), (modules, others) = reader.devices(pair), map(reader.modules_of, pair)
            layouts = [lookup._read_layout(number) for number in pair]
            assert [layout_signature(item) for item in layouts] == [signatures[number] for number in pair]
            words = layout_difference(*layouts)
            wrong.append((contradiction(words, list(compare_images(ours, modules, theirs, others))), pair, words))
    assert len(wrong) > 100
    assert [item for item in wrong if item[0] is not None] == []


@pytest.mark.parametrize("content", ["", SMS, SMS + rx(attributes='Fixed="1"')])
def test_what_exchanges_nothing_has_no_signature(content):
    """The list of entries of a Fixed PDO is empty and stays so."""
    assert ProcessData(only_device(esi(device(content)))).image_signature is None


def test_what_has_no_place_is_told_in_order():
    """0x7000:02 lies behind a PDO of unknown length, and so does a gap of three bits and four."""
    left = SMS + VARIABLE.format("#x1600") + rx((0, "3"), (0, "4"), B, index="#x1601")
    right = SMS + VARIABLE.format("#x1600") + rx(GAP_7, (4, "8"), index="#x1601")
    ours, theirs = (only_device(esi(device(content))) for content in (left, right))
    (found,) = compare_images(ours, (), theirs, ())
    assert (found.place, found.left, found.right) == (
        "SM0 without known place",
        "PDO 0x1600, padding (7 bit), 0x7000:02 (8 bit)",
        "PDO 0x1600, padding (7 bit), 0x7000:04 (8 bit)",
    )
