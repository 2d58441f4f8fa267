"""Who is on this bus: the same answer from Python, from the shell and over HTTP."""

import asyncio
import gc
import json
import os
import re
import shutil
import socket
import sqlite3
from contextlib import ExitStack, closing
from pathlib import Path

import msgspec
import pytest
import schemathesis
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from lxml import html
from schemathesis import GenerationMode
from snippets import device, esi, one, pdo, rows, write
from test_cli import one_line_error, run
from test_search import catalog_of
from web_client import client, new_client

from esicatalog import Catalog, CatalogError, InputError, NotFound, parse_identity
from esicatalog.catalog import description
from esicatalog.catalog.filter_texts import SHARPENS, filter_of_texts
from esicatalog.catalog.identity import IdentityLookup
from esicatalog.catalog.results import json_bytes
from esicatalog.cli.serve import _listen
from esicatalog.identity import Identity, parse_number
from esicatalog.scan.front import read_pdos, read_scan
from esicatalog.web.app import datasette_app
from esicatalog.web.http import MAX_BODY_BYTES
from esicatalog.web.openapi import openapi_document

ROUTE = "/-/esi/identify.json"
SLAVES = """\
=== Master 0, Slave 0 ===
Alias: 7
Identity:
  Vendor Id:       0x00000e5c
  Product code:    0x0d080808
  Revision number: 0x00110000
General:
  Current consumption: -200 mA
=== Master 0, Slave 1 ===
Alias: 7
Identity:
  Vendor Id:       0x00000e5c
  Product code:    0x0d080808
  Revision number: 0x00120000
General:
  Current consumption: 300 mA
=== Master 0, Slave 2 ===
Identity:
  Vendor Id:       0x000000cd
  Product code:    0x00000456
  Revision number: 0x00010000
"""


@pytest.fixture(scope="module")
def several(tmp_path_factory) -> Path:
    """Three revisions of a product, two layouts; one has two descriptions."""
    sm, wide = "<Sm>Outputs</Sm>", pdo("RxPdo", "#x1600", 8, 8, attributes='Sm="0"')
    narrow = pdo("RxPdo", "#x1600", 16, attributes='Sm="0"') + pdo("RxPdo", "#x1601", 8, 8)
    return catalog_of(
        tmp_path_factory.mktemp("several"),
        esi(
            device(sm + wide, revision="#x00100000", type_text="A")
            + device(sm + narrow, revision="#x00120000", type_text="B")
            + device("<HideType RevisionNo='#x00110000'/>" + sm + wide, revision="#x00120000", type_text="B2")
            + device(sm + wide, revision="#x00110000", type_text="hidden")
        ),
    )


def answer(db: Path, *numbers: int):
    with Catalog.open(db) as catalog:
        return catalog.identify(*numbers)


@pytest.mark.parametrize("step", ["with_sources", "_read_layout"])
def test_an_answer_is_of_one_state(tmp_path, monkeypatch, step):
    """The number of a row is soon another description's; its document would be named with what was found before.

    Or nobody's: that of the second revision, whose layout is another one.
    """
    contents = ["<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", bits, attributes='Sm="0"') for bits in (8, 16)]
    revisions = "".join(device(content, revision=f"#x{number}") for number, content in enumerate(contents, 1))
    folder, db = write(tmp_path / "in", {"a.xml": esi(revisions)}), tmp_path / "c.db"
    method = getattr(IdentityLookup, step)

    def replaced_before(lookup, found):
        monkeypatch.undo()
        (folder / "a.xml").unlink()
        for content in ({}, {"z.xml": esi(device(product="#x99", name="A valve"))}):
            with Catalog.open(db) as other:
                other.ingest([write(folder, content)], jobs=1, prune=True)
        return method(lookup, found)

    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([folder], jobs=1)
        monkeypatch.setattr(IdentityLookup, step, replaced_before)
        assert catalog.identify(0xE5C, 1, 1).match == "vendor"


def test_what_cannot_be_read_of_a_layout_is_damage(several, tmp_path):
    db = tmp_path / "c.db"
    db.write_bytes(several.read_bytes())
    with closing(sqlite3.connect(db)) as connection, connection:
        connection.execute("UPDATE pdo_entries SET spelling = '{'")
    with pytest.raises(CatalogError, match=r"the catalog: a value cannot be read .* is damaged"):
        answer(db, 0xE5C, 1, 0x00100000)


def test_an_answer_tells_what_others_stored_meanwhile(tmp_path):
    """What was read of a product is kept only as long as nobody changes the catalog."""
    db = catalog_of(tmp_path, esi(device()))
    with Catalog.open(db) as catalog:
        assert catalog.identify(0xE5C, 1, 2).match == "older"
        write(tmp_path / "more", {"b.xml": esi(device(revision="#x2"))})
        with Catalog.open(db) as another:
            another.ingest(tmp_path / "more", jobs=1)
        assert catalog.identify(0xE5C, 1, 2).match == "exact"
        assert [item.revision_no for item in catalog.identify(0xE5C, 1, 1).candidates] == [2]


@pytest.mark.parametrize(
    "numbers",
    [
        (2**70, 1),
        (-1, 1),
        (1, 2**32),
        (1, 1, 2**32),
        ("0xe5c", 1),
        (1, 1, "0x1"),
        (1, None),
        (1, 1, ""),
        (1, 1, []),
        (1, 1, False),
    ],
)
def test_what_is_no_number_of_an_identity_is_refused(several, numbers):
    with Catalog.open(several) as catalog, pytest.raises(InputError, match="is no number from 0 to 0xffffffff"):
        catalog.identify(*numbers)


def test_exact_with_all_variants_and_the_others_near(several):
    found = answer(several, 0xE5C, 1, 0x00120000)
    assert found.match == "exact"
    assert [item.device.variant for item in found.variants] == [1, 2]
    assert found.device == found.variants[0]
    assert [item.revision_no for item in found.candidates] == [0x00100000, 0x00110000]
    assert [source.member for source in found.device.sources] == ["0.xml"]


def test_another_layout_is_a_warning_that_names_the_difference(several):
    *_, warning = answer(several, 0xE5C, 1, 0x00120000).warnings
    assert warning == (
        "default process image differs in 2 of 2 other revisions; 0x00100000 for example: "
        "SM0 byte 0.0 is 0x7000:01 (16 bit) here, 0x7000:01 (8 bit) there"
    )


def test_another_layout_of_a_variant_is_a_warning(several):
    first, _ = answer(several, 0xE5C, 1, 0x00120000).warnings
    assert first == (
        "default process image differs in 1 of 1 other variants of this identity; @2 for example: "
        "SM0 byte 0.0 is 0x7000:01 (16 bit) here, 0x7000:01 (8 bit) there"
    )


@pytest.mark.parametrize(
    ("there", "words"),
    [
        (
            "<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 8, attributes='Sm="0" OSFac="8"'),
            "SM0 byte 4.0 is nothing here, 0x7000:01 (8 bit) there",
        ),
        (
            '<Sm ControlByte="#x20">Outputs</Sm>' + pdo("RxPdo", "#x1600", 8, attributes='Sm="0" OSFac="4"'),
            "SyncManagers with PDOs are SM0 output here, SM0 input there",
        ),
        (
            "<Sm>Outputs</Sm>"
            + pdo("RxPdo", "#x1600", 8, attributes='OSFac="4"')
            + "<Dc><OpMode><Name>m</Name><AssignActivate>0</AssignActivate>"
            '<Sm No="0"><Pdo>#x1600</Pdo><Pdo>#x1602</Pdo></Sm></OpMode></Dc>',
            "SM0 without known place: nothing here, PDO 0x1602 there",
        ),
        (
            "<Sm>Outputs</Sm>"
            + pdo("RxPdo", "#x1600", 8, attributes='Sm="0" OSFac="4"').replace("<SubIndex>1<", "<SubIndex>x1<"),
            "SM0 byte 0.0 is 0x7000:01 (8 bit) here, 0x7000:? 'x1' (8 bit) there",
        ),
    ],
)
def test_layouts_with_the_same_entries_say_in_what_they_differ(tmp_path, there, words):
    here = "<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 8, attributes='Sm="0" OSFac="4"')
    db = catalog_of(tmp_path, esi(device(here, revision="#x1") + device(there, revision="#x2")))
    (warning,) = answer(db, 0xE5C, 1, 1).warnings
    assert words in warning
    assert "modules" not in warning


def gap(bits: int) -> str:
    return f"<Entry><Index>0</Index><BitLen>{bits}</BitLen></Entry>"


def test_how_a_gap_is_cut_is_no_difference(tmp_path):
    """Seven bits are one gap, or two of one and six; in the third revision the entry behind them lies elsewhere."""
    parts = [gap(7), gap(1) + gap(6), gap(1) + gap(14)]
    begin = '<Sm>Outputs</Sm><RxPdo Sm="0"><Index>#x1600</Index><Entry><Index>#x7000</Index><BitLen>1</BitLen></Entry>'
    end = "<Entry><Index>#x7001</Index><BitLen>8</BitLen></Entry></RxPdo>"
    text = "".join(device(begin + part + end, revision=f"#x{number}") for number, part in enumerate(parts, 1))
    db = catalog_of(tmp_path, esi(text))
    (warning,) = answer(db, 0xE5C, 1, 1).warnings
    assert warning == (
        "default process image differs in 1 of 2 other revisions; 0x00000003 for example: "
        "SM0 byte 1.0 is 0x7001:00 (8 bit) here, nothing there"
    )
    assert rows(db, "SELECT layout_changed FROM device_revisions ORDER BY revision_no") == [(0,), (0,), (1,)]


def test_nothing_is_sampled_where_only_a_gap_of_no_bits_is_more(tmp_path):
    content = "<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')
    more = content.replace("</RxPdo>", gap(0) + "</RxPdo>")
    db = catalog_of(tmp_path, esi(device(content, revision="#x1") + device(more, revision="#x2")))
    assert answer(db, 0xE5C, 1, 1).warnings == ()


VARIABLE = '<RxPdo Sm="0"><Index>#x1600</Index><Name>R</Name></RxPdo>'
UNREAD = pdo("RxPdo", "#x1601", 8, attributes='Sm="0"').replace("<SubIndex>1<", "<SubIndex>x1<")
SLOT_OF_NOBODY = '<Slots><Slot MinInstances="1" MaxInstances="1"><ModuleIdent>9</ModuleIdent></Slot></Slots>'
NO_LENGTH = '<RxPdo Sm="0"><Index>#x1600</Index><Entry><Index>#x7000</Index></Entry></RxPdo>'


@pytest.mark.parametrize(
    ("here", "there", "words", "then"),
    [
        (
            "<Sm>Outputs</Sm>" + VARIABLE + pdo("RxPdo", "#x1601", 8, 16, attributes='Sm="0"'),
            "<Sm>Outputs</Sm>" + VARIABLE + pdo("RxPdo", "#x1601", 16, 8, attributes='Sm="0"'),
            "SM0 without known place: 0x7000:01 (8 bit) here, 0x7000:01 (16 bit) there",
            None,
        ),
        (
            '<Sm DefaultSize="4">Outputs</Sm><Sm>Inputs</Sm>' + pdo("TxPdo", "#x1A00", 8, attributes='Sm="1"'),
            '<Sm DefaultSize="8">Outputs</Sm><Sm>Inputs</Sm>' + pdo("TxPdo", "#x1A00", 8, attributes='Sm="1"'),
            "SM0 without known place: DefaultSize 4 and no PDO here, DefaultSize 8 and no PDO there",
            None,
        ),
        (
            '<Sm DefaultSize="8">Outputs</Sm>',
            '<Sm DefaultSize="64">Outputs</Sm>',
            "SM0 without known place: DefaultSize 8 and no PDO here, DefaultSize 64 and no PDO there",
            None,
        ),
        (
            f"<Sm>Outputs</Sm>{SLOT_OF_NOBODY}",
            "<Sm>Outputs</Sm>",
            "SM0 without known place: PDOs of required modules here, nothing there",
            0,
        ),
        (
            "<Sm>Outputs</Sm>" + VARIABLE,
            "<Sm>Outputs</Sm>" + VARIABLE.replace("1600", "1601"),
            "SM0 without known place: PDO 0x1600 here, PDO 0x1601 there",
            None,
        ),
        (
            "<Sm>Outputs</Sm>" + NO_LENGTH,
            "<Sm>Outputs</Sm>" + NO_LENGTH.replace("1600", "1601"),
            "SM0 without known place: PDO 0x1600 here, PDO 0x1601 there",
            None,
        ),
        (
            "<Sm>Outputs</Sm>" + NO_LENGTH,
            "<Sm>Outputs</Sm>" + NO_LENGTH.replace("</Index></Entry>", "</Index><BitLen>16</BitLen></Entry>"),
            "SM0 byte 0.0 is 0x7000:00 (no length) here, 0x7000:00 (16 bit) there",
            0,
        ),
        (
            "<Sm>Outputs</Sm>" + VARIABLE + UNREAD,
            "<Sm>Outputs</Sm>" + VARIABLE + UNREAD.replace(">x1<", ">x2<"),
            "SM0 without known place: 0x7000:? 'x1' (8 bit) here, 0x7000:? 'x2' (8 bit) there",
            None,
        ),
        (
            "<Sm>Outputs</Sm>" + VARIABLE + UNREAD,
            "<Sm>Outputs</Sm>" + VARIABLE + UNREAD.replace("<SubIndex>x1</SubIndex>", ""),
            "SM0 without known place: 0x7000:? 'x1' (8 bit) here, 0x7000:00 (8 bit) there",
            None,
        ),
    ],
)
def test_layouts_differ_where_no_place_is_known(tmp_path, here, there, words, then):
    """A third revision is described as the second: whether it is the same is known with its length only."""
    text = esi(device(here, revision="#x1") + device(there, revision="#x2") + device(there, revision="#x3"))
    db = catalog_of(tmp_path, text)
    (warning,) = answer(db, 0xE5C, 1, 1).warnings
    assert warning.endswith(words)
    assert rows(db, "SELECT layout_changed FROM device_revisions ORDER BY revision_no") == [(0,), (1,), (then,)]


def test_equal_layouts_that_are_not_described_in_full_may_differ(tmp_path):
    """Revisions 1 and 2 have a PDO of no known content, which may be another one in each; 3 has two known bytes."""
    content, known = "<Sm>Outputs</Sm>" + VARIABLE, "<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')
    unknown = device(content, revision="#x1") + device(content, revision="#x3")
    (tmp_path / "more").mkdir()
    db = catalog_of(tmp_path, esi(unknown))
    assert answer(db, 0xE5C, 1, 2).warnings == (
        "whether the default process image differs in 1 of 1 other revisions is not known: its length is not described",
    )
    db = catalog_of(tmp_path / "more", esi(unknown + device(known, revision="#x4")))
    (warning,) = answer(db, 0xE5C, 1, 2).warnings
    assert warning.startswith(
        "default process image differs in 1 of 2 other revisions, whether in 1 more is not known; 0x00000004 for "
    )


def test_an_empty_sync_manager_more_is_the_same_layout(tmp_path):
    content = "<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"')
    empty = content.replace("</Sm>", "</Sm><Sm Virtual='1'>Inputs</Sm>")
    db = catalog_of(tmp_path, esi(device(content, revision="#x1") + device(empty, revision="#x2")))
    assert answer(db, 0xE5C, 1, 1).warnings == ()
    assert rows(db, "SELECT layout_changed FROM device_revisions ORDER BY revision_no") == [(0,), (0,)]
    with Catalog.open(db) as catalog:
        assert [found.revision_no for found in catalog.devices(like=parse_identity("0xe5c:1:1"))] == [2]


def test_the_variant_whose_rule_accepts_the_revision_is_the_answer(tmp_path):
    """The preferred description, which has more PDO entries, says nothing of other revisions."""
    longer = device(pdo("RxPdo", "#x1600", 8, 8), revision="#x10")
    accepting = device(pdo("RxPdo", "#x1600", 8), revision="#x10").replace("<Type ", '<Type CheckRevisionNo="EQ_OR_G" ')
    db = catalog_of(tmp_path, esi(longer), esi(accepting), esi(device(revision="#x11")))
    found = answer(db, 0xE5C, 1, 0x12)
    assert (found.match, found.device.device.variant) == ("accepted", 2)
    assert [item.device.variant for item in found.variants] == [2, 1]
    assert [item.revision_no for item in found.candidates] == [0x11]


def test_hidden_is_found_when_asked_for_and_passed_over_otherwise(several):
    assert answer(several, 0xE5C, 1, 0x00110000).device.device.type == "hidden"
    assert answer(several, 0xE5C, 1, 0x00115555).device.device.type == "A"
    assert answer(several, 0xE5C, 1).device.device.type == "B"


@pytest.mark.parametrize(
    ("numbers", "match", "words"),
    [
        ((0xE5C, 1, 0x000F0000), "newer", "only newer ones are described, next 0x00100000"),
        ((0xE5C, 1, 0x00200000), "older", "0x00120000 is older with the same low word"),
        ((0xE5C, 2, 1), "vendor", "its product 0x00000002 is not"),
        ((0xE5D, 1, 1), "none", "vendor 0x00000e5d is not in the catalog"),
    ],
)
def test_what_is_not_exact_says_why(several, numbers, match, words):
    found = answer(several, *numbers)
    assert found.match == match
    assert words in found.reason
    assert (found.device is None) == (match in ("vendor", "none"))


def test_a_vendor_without_name_is_known_by_its_number(tmp_path):
    db = catalog_of(tmp_path, esi(device(), vendor="<Id>#xE5C</Id>"))
    assert answer(db, 0xE5C, 2).reason == "vendor 0x00000e5c is known, its product 0x00000002 is not"


def test_the_product_of_the_nearest_code_is_a_candidate(several):
    assert {item.product_code for item in answer(several, 0xE5C, 2, 1).candidates} == {1}


def test_the_nearest_products_lie_on_both_sides_of_a_code(tmp_path):
    """Ten of fourteen, nearest first; of two equally near the lower one; visible revisions before hidden ones."""
    hides = '<HideType RevisionNo="#x2"/>'
    products = [n for n in range(100, 128, 2) if n != 110]
    devices = [device(product=str(n), revision="#x1", type_text=f"T{n}") for n in products]
    devices += [device(hides, product="110", revision="#x1"), device(product="110", revision="#x2")]
    db = catalog_of(tmp_path, esi("".join(devices)))
    found, beyond = (answer(db, 0xE5C, code, 1).candidates for code in (111, 500))
    assert [(d.product_code, d.revision_no) for d in found] == [
        *((110, 1), (110, 2), (112, 1), (108, 1), (114, 1)),
        *((106, 1), (116, 1), (104, 1), (118, 1), (102, 1)),
    ]
    assert [d.product_code for d in beyond] == [126, 124, 122, 120, 118, 116, 114, 112, 110, 110]


def test_answers_follow_the_catalog(tmp_path):
    """The lookup keeps its connection: it must see what another process stores, and must not lock it."""
    db = catalog_of(tmp_path, esi(device(revision="1")))
    with Catalog.open(db) as asking:
        assert asking.identify(0xE5C, 1, 2).match == "older"
        (tmp_path / "in" / "1.xml").write_text(esi(device(revision="2")))
        with Catalog.open(db) as storing:
            storing.ingest([tmp_path / "in"], jobs=1)
        assert asking.identify(0xE5C, 1, 2).match == "exact"


def test_identities_have_a_connection_of_their_own(data_db):
    """More others at once than the pool keeps: the one for identities is not given back and closed."""
    with Catalog.open(data_db) as catalog, ExitStack() as others:
        expected = catalog.identify(0x1097, 0x2406)
        for _ in range(12):
            others.enter_context(catalog._connection())
        others.close()
        assert catalog.identify(0x1097, 0x2406) == expected


def open_files(folder: Path) -> list[str]:
    """What this process holds open below a folder."""
    links = Path("/proc/self/fd").iterdir()
    names = [str(link.readlink()) for link in links if os.path.lexists(link)]
    return [name for name in names if name.startswith(f"{folder}/")]


@pytest.fixture
def uncollected():
    """What is only closed when it is collected stays open."""
    gc.collect()
    gc.disable()
    yield
    gc.enable()


needs_proc = pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="counts descriptors through /proc")
EXACT_EYOU = (0x1097, 0x2406, 0x8F)


@needs_proc
@pytest.mark.parametrize(
    "ask",
    [
        lambda catalog: catalog.identify(*EXACT_EYOU),
        lambda catalog: catalog.identify_scan(read_scan(SLAVES)),
        lambda catalog: catalog.content_hash(),
        lambda catalog: catalog.state_hash(),
        lambda catalog: catalog.device(Identity(*EXACT_EYOU)),
        lambda catalog: catalog.export_subject(Identity(*EXACT_EYOU)),
        lambda catalog: catalog.devices(modes=["CSV"]),
    ],
)
def test_a_closed_catalog_holds_no_file_open(data_db, tmp_path, uncollected, ask):
    db = Path(shutil.copy(data_db, tmp_path / "c.db"))
    with Catalog.open(db) as catalog:
        ask(catalog)
        assert open_files(tmp_path)
    assert open_files(tmp_path) == []
    assert catalog.identify(*EXACT_EYOU).match == "exact", "who asks again opens it again"
    catalog.close()
    assert open_files(tmp_path) == []


@needs_proc
def test_a_catalog_that_is_refused_is_not_held_open(data_db, tmp_path, uncollected):
    old, foreign, no_database = (tmp_path / name for name in ("old.db", "foreign.db", "no.db"))
    shutil.copy(data_db, old)
    for db, statement in ((old, "UPDATE alembic_version SET version_num = '0001'"), (foreign, "CREATE TABLE t (a)")):
        with closing(sqlite3.connect(db)) as connection, connection:
            connection.execute(statement)
    no_database.write_text("x" * 5000)
    refusals = []
    for db in (old, foreign, no_database):
        with pytest.raises(CatalogError) as told:
            Catalog.open(db)
        refusals.append(told)  # with the frames of what was refused
        assert open_files(tmp_path) == []


IMPOSSIBLE = [
    Identity(0x1097, 0x2406, 0x8F, 0),
    Identity(0x1097, 0x2406, 0x8F, None, True),
    Identity(-1, 2),
    Identity(2**70, 2),
    Identity("0x1097", 0x2406),
]


@pytest.mark.parametrize("identity", IMPOSSIBLE, ids=range(len(IMPOSSIBLE)))
def test_what_can_be_no_identity_is_asked_for_in_vain(data_db, identity):
    with Catalog.open(data_db) as catalog:
        for ask in (catalog.device, catalog.export_subject):
            with pytest.raises(InputError):
                ask(identity)


def test_numbers_that_no_row_can_have(data_db):
    with Catalog.open(data_db) as catalog:
        for number in (2**70, 2**63, 0, -1):
            with pytest.raises(NotFound, match="no device row"):
                catalog.device_of_row(number)
        with pytest.raises(InputError, match="vendor"):
            catalog.export_subjects(2**70)


def test_a_catalog_that_only_reads_is_not_made(tmp_path):
    for exists in (False, True):
        with pytest.raises(CatalogError, match="leave out create or read_only"):
            Catalog.open(tmp_path / "c.db", create=True, read_only=True)
        assert (tmp_path / "c.db").exists() == exists
        catalog_of(tmp_path, esi(device()))


def test_a_damaged_catalog_is_one_line(tmp_path):
    db = catalog_of(tmp_path, esi(device()))
    with Catalog.open(db) as catalog:
        catalog.identify(1, 1, 1)
        db.write_bytes(b"\0" * 8192)
        with pytest.raises(CatalogError, match="not"):
            catalog.identify(0xE5C, 1, 1)


async def test_three_doors_one_answer(sample_db):
    """Fifty identities, some of them one beside what is described: the bytes are the same."""
    db = sample_db
    described = [row for row in rows(db, "SELECT vendor_id, product_code, revision_no FROM devices") if None not in row]
    stride = max(1, len(described) // 40)
    wanted = [*described[::stride], *((v, p, r ^ 0x10000) for v, p, r in described[:: stride * 5])][:48]
    wanted += [(0xE5C, 0x12345678, 1), (0x7FFFFFFF, 1, 1)]
    web = await client(db)
    with Catalog.open(db) as catalog:
        for numbers in wanted:
            ours = json_bytes(catalog.identify(*numbers).as_json())
            words = [f"0x{number:x}" for number in numbers]
            shell = run("identify", *words, "--format", "json", db=db).stdout_bytes
            response = await web.get(ROUTE, params=dict(zip(("vendor", "product", "revision"), words, strict=True)))
            assert ours == shell == response.content
            assert response.status_code == (404 if json.loads(ours)["device"] is None else 200)


async def test_many_identities_and_scans_by_post(data_db):
    web = await client(data_db)
    identities = [{"vendor": "0xe5c", "product": "#x0d080808"}, [0x1097, 0x2406, 0x8F], "0x1:0x2:0x3"]
    identities.append({"vendor_id": 0x1097, "product_code": 0x2406, "revision_no": 0x8F})
    found = (await web.post(ROUTE, json=identities)).json()
    assert [item["match"] for item in found] == ["product", "exact", "none", "exact"]
    posted = await web.post(ROUTE, content=SLAVES.encode(), headers={"content-type": "text/plain"})
    shell = run("identify", "--slaves", "-", "--format", "json", db=data_db, stdin=SLAVES).stdout_bytes
    assert posted.content == shell


@pytest.mark.parametrize("mark", ["utf-8-sig", "utf-16", "utf-16-be"])
async def test_a_scan_in_the_encoding_of_powershell(data_db, tmp_path, mark):
    """``ethercat slaves -v > slaves.txt`` writes UTF-16 there; the mark in front says so."""
    content = SLAVES.encode(mark) if mark != "utf-16-be" else ("\ufeff" + SLAVES).encode(mark)
    (tmp_path / "slaves.txt").write_bytes(content)
    plain = run("identify", "--slaves", "-", "--format", "json", db=data_db, stdin=SLAVES).stdout_bytes
    shell = run("identify", "--slaves", tmp_path / "slaves.txt", "--format", "json", db=data_db).stdout_bytes
    posted = await (await client(data_db)).post(ROUTE, content=content)
    assert shell == posted.content == plain


@pytest.mark.parametrize(
    ("query", "words"),
    [
        ("", "vendor is missing"),
        ("?vendor=1", "product is missing"),
        ("?vendor=zz&product=1", "vendor 'zz' is not a number"),
        ("?vendor=1&product=0x1ffffffff", "is larger than 0xffffffff"),
        ("?vendor=1&product=1&rev=1", "unknown parameter 'rev'"),
        ("?vendor=1&vendor=2&product=1", "vendor is given more than once"),
        ("?vendor=&vendor=2&product=", "product is missing"),
    ],
)
async def test_wrong_requests_are_400_with_words(data_db, query, words):
    response = await (await client(data_db)).get(ROUTE + query)
    assert response.status_code == 400
    assert words in response.json()["error"]


@pytest.mark.parametrize(
    ("body", "words"),
    [
        (b"", "the text is empty"),
        (b"[1]", "identity 0: expected an object"),
        (b'["1:2", "2:72100946@99"]', "identity 1: '2:72100946@99' names a variant; leave it out"),
        (b'["0x4326:0x601:-"]', "identity 0: '0x4326:0x601:-' asks for a description without revision"),
        (b'[["0x4326", "0x601", "-"]]', "identity 0: revision '-' is not a number"),
        (b'[{"vendor": 1}]', "identity 0: vendor and product are needed"),
        (b'[{"vendor": true, "product": 1}]', "vendor True is no number"),
        (b'[{"vendor": -1, "product": 1}]', "vendor -1 is no number"),
        (b'[{"vendor": 1, "product": 1, "revison": 3}]', "identity 0: unknown member 'revison'; there are vendor,"),
        (b'[[1, 1], {"vendor": 1, "vendor_id": 2, "product": 1}]', "identity 1: vendor is given more than once"),
        (b'{"vendor": 1}', "no list"),
        (b"[[1,2", "no JSON"),
        (b"hello", "no scan is recognised"),
        (b"[" * 100_000, "no JSON"),
        (b"[12.5] hello", "no JSON"),
        (b'[{"vendor": 1, "product": 2},\n{"vendor": 1, "product": 3}', "no JSON"),
        (
            b"SOEM (Simple Open EtherCAT Master)\n3 slaves found and configured.\n",
            "no slave was read; line 1: slaveinfo lists no slave; line 2: 3 slaves are announced, 0 are listed",
        ),
    ],
)
async def test_wrong_bodies_are_400_with_words(data_db, body, words):
    response = await (await client(data_db)).post(ROUTE, content=body)
    assert response.status_code == 400
    assert words in response.json()["error"]


async def test_a_scan_in_the_lines_of_a_log(data_db):
    """They begin with a bracket, as JSON does."""
    logged = "".join(f"[   12.345678] {line}\n" for line in SLAVES.splitlines())
    web = await client(data_db)
    plain, posted = [(await web.post(ROUTE, content=text.encode())).content for text in (SLAVES, logged)]
    assert posted == plain
    assert posted == run("identify", "--slaves", "-", "--format", "json", db=data_db, stdin=logged).stdout_bytes


async def test_json_may_begin_with_the_mark_of_its_encoding(data_db):
    """PowerShell and .NET put it there."""
    web = await client(data_db)
    plain, marked = [await web.post(ROUTE, content='["0x1097:0x2406:0x8f"]'.encode(e)) for e in ("utf-8", "utf-8-sig")]
    assert (plain.status_code, marked.content) == (200, plain.content)


async def test_the_query_of_an_answer_can_be_asked_again(data_db):
    """Its other members tell the same: with a revision none can be meant as it."""
    web = await client(data_db)
    (first,) = (await web.post(ROUTE, json=["0x1097:0x2406:0x8f"])).json()
    assert first["query"]["vendor_id_hex"] == "0x00001097"
    (again,) = (await web.post(ROUTE, json=[first["query"]])).json()
    assert again == first


async def test_bounds_methods_and_etag(data_db):
    web = await client(data_db)
    assert (await web.post(ROUTE, content=b"x" * (MAX_BODY_BYTES + 1))).status_code == 413
    assert (await web.post(ROUTE, content=b"[" + b'"1:1",' * 10_000 + b'"1:1"]')).status_code == 400
    refused = await web.delete(ROUTE)
    assert (refused.status_code, refused.headers["allow"]) == (405, "GET, POST")
    first = await web.get(f"{ROUTE}?vendor=0x1097&product=0x2406")
    again = await web.get(f"{ROUTE}?vendor=0x1097&product=0x2406", headers={"if-none-match": first.headers["etag"]})
    assert (first.status_code, again.status_code, again.content) == (200, 304, b"")
    assert "access-control-allow-origin" not in first.headers
    # RFC 9110, 13.1.2: a list, compared weakly.
    etag = first.headers["etag"]
    for held, status in ((f"W/{etag}", 304), (f'"a",W/{etag} , "b"', 304), ('"a", W/"b"', 200), (etag.strip('"'), 200)):
        answer = await web.get(f"{ROUTE}?vendor=0x1097&product=0x2406", headers={"if-none-match": held})
        assert answer.status_code == status, held


async def test_a_document_without_devices_makes_other_answers(tmp_path):
    """Pages count all documents, and the content hash tells of those with devices only."""
    folder = write(tmp_path / "esi", {"a.xml": esi(device())})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([folder], jobs=1)
        web = await client(tmp_path / "c.db")
        before = await web.get("/-/esi/")
        write(folder, {"b.xml": "<EtherCATConfig/>"})
        catalog.ingest([folder], jobs=1)
    after = await web.get("/-/esi/", headers={"if-none-match": before.headers["etag"]})
    assert (after.status_code, after.headers["etag"] != before.headers["etag"]) == (200, True)


@pytest.mark.parametrize("path", [f"{ROUTE}?vendor=0xe5c&product=1", "/-/esi/devices.json", "/-/esi/"])
async def test_nothing_is_confirmed_while_an_ingest_is_under_way(tmp_path, path):
    """Nothing says then what the catalog holds: answers that differ would have one name."""
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([write(tmp_path / "esi", {"a.xml": esi(device())})], jobs=1)
    web = await client(db)
    finished = await web.get(path)
    with closing(sqlite3.connect(db)) as connection, connection:
        connection.execute("DELETE FROM catalog_state WHERE key IN ('content_hash', 'state_hash')")
    for asked in ({}, {"if-none-match": finished.headers["etag"]}, {"if-none-match": '"0-changing-unknown"'}):
        answer = await web.get(path, headers=asked)
        assert (answer.status_code, "etag" in answer.headers) == (200, False)
        assert answer.headers["cache-control"] == "no-store"


async def test_cors_only_where_datasette_has_it(data_db):
    web = await new_client(data_db, cors=True)
    response = await web.get(f"{ROUTE}?vendor=1&product=1")
    assert response.headers["access-control-allow-origin"] == "*"
    exported = await web.get("/-/esi/device/0x1097/0x2406/0x8f/export/igh")
    assert (exported.status_code, exported.headers["access-control-allow-origin"]) == (200, "*")
    # What a browser asks before a script of another site posts JSON.
    asked = {"access-control-request-method": "POST", "access-control-request-headers": "content-type"}
    allowed = await web.request("OPTIONS", ROUTE, headers={"origin": "https://example.com", **asked})
    assert allowed.status_code == 204
    assert "POST" in allowed.headers["access-control-allow-methods"].split(", ")
    assert "content-type" in allowed.headers["access-control-allow-headers"].lower().split(", ")
    plain = await client(data_db)
    for path in ("/-/esi/device/0x1097/0x2406/0x8f/export/igh", ROUTE):
        assert (await plain.request("OPTIONS", path)).status_code == 405


_ROOT = {"allow": {"id": "root"}}


@pytest.mark.parametrize(
    "denied",
    [_ROOT, {"tables": {"pdos": _ROOT, "devices": {"allow": True}}}, {"tables": {"Device_Overview": {"allow": False}}}],
    ids=["the database", "a table", "a view, to all"],
)
async def test_who_may_not_see_the_database_or_a_table_gets_no_answer(data_db, denied):
    application = datasette_app(data_db)
    # 0.65 takes permissions from the metadata, 1.0 from the configuration
    configured = {"databases": {"catalog": denied}}
    setattr(application, "config" if hasattr(application, "config") else "_metadata_local", configured)
    await application.invoke_startup()
    device = "/-/esi/device/0x1097/0x2406/0x8f"
    paths = (f"{ROUTE}?vendor=1&product=1", "/-/esi/openapi.json", "/-/esi/", device, f"{device}.json")
    assert {(await application.client.get(path)).status_code for path in paths} == {403}
    cookies = {"ds_actor": application.sign({"a": {"id": "root"}}, "actor")}
    answer = await application.client.get(device, cookies=cookies)
    assert answer.status_code == (200 if _ROOT in (denied, *denied.get("tables", {}).values()) else 403)


def test_the_server_cannot_write(data_db, tmp_path):
    (tmp_path / "new.xml").write_text(esi(device()))
    with Catalog.open(data_db, read_only=True) as catalog, pytest.raises(CatalogError, match="readonly"):
        catalog.ingest([tmp_path], jobs=1)
    assert one(data_db, "PRAGMA journal_mode") == "delete"


def test_answers_are_sent_without_waiting_for_acknowledgements():
    """Nagle's algorithm and delayed acknowledgements cost 40 ms a request; a server found at 23 requests a second."""
    with _listen("127.0.0.1", 0) as listener, socket.create_connection(listener.getsockname()):
        connection, _ = listener.accept()
        with connection:
            assert connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY) != 0


def names_no_slot_twice(case) -> bool:
    """OpenAPI has no words for a part of texts that differs."""
    slots = [parse_number(text.partition("=")[0]) for text in case.query.get("module", [])]
    return len(set(slots)) == len(slots)


def sharpens_what_is_asked(case) -> bool:
    """OpenAPI has no words for a parameter that needs another one; the descriptions say it."""
    given = {name: value if isinstance(value, list) else [value] for name, value in case.query.items()}
    return all(any(given.get(of, [])) for name, of in SHARPENS.items() if given.get(name))


@pytest.mark.parametrize("examples", [4, pytest.param(100, marks=pytest.mark.faults)])
def test_openapi_says_what_the_routes_do(data_db, examples):
    """Requests made from the document, sensible and broken ones, get the answers that the document promises."""
    api = schemathesis.openapi.from_asgi("/-/esi/openapi.json", datasette_app(data_db).app())
    operations = [found.ok() for found in api.get_all_operations()]
    assert [operation.method for operation in operations] == ["get", "post", "get", "get"]
    for operation in operations:
        for mode in GenerationMode:
            cases = operation.as_strategy(generation_mode=mode)
            if mode is GenerationMode.POSITIVE:
                cases = cases.filter(names_no_slot_twice)

            @given(case=cases)
            @settings(max_examples=examples, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
            def answered_as_promised(case):
                assume(sharpens_what_is_asked(case))
                case.call_and_validate()

            answered_as_promised()


@pytest.fixture(scope="module")
def one_device_db(tmp_path_factory) -> Path:
    return catalog_of(tmp_path_factory.mktemp("one"), esi(device()))


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ("0xe5c/0x1/-", "0x00000e5c:0x00000001:- is not in the catalog"),
        ("0xe5c/0x1/0x1@9", "0x00000e5c:0x00000001:0x00000001 has no variant 9; it has one description only"),
        ("0xe5c/0x1/latest@9", "0x00000e5c:0x00000001:0x00000001 has no variant 9; it has one description only"),
        ("0xe5c/0x1/0x2", {"match": "older", "revision_no": 2}),
        ("0xe5c/0x7/-", {"match": "vendor", "revision_no": None}),
        ("0xe5d/0x1/0x1@2", {"match": "none", "revision_no": 1}),
    ],
)
async def test_a_device_that_is_not_described(one_device_db, path, words):
    """identify.json knows neither variants nor descriptions without revision: its answer would be to something else."""
    web = await client(one_device_db)
    response = await web.get(f"/-/esi/device/{path}.json")
    found = response.json()
    assert response.status_code == 404
    if isinstance(words, str):
        assert found.pop("error").startswith(words)
        asked = (await web.get("/-/esi/identify.json?vendor=0xe5c&product=1&revision=1")).json()
        assert found == {name: asked[name] for name in ("device", "variants", "candidates")}
    else:
        assert {"match": found["match"], "revision_no": found["query"]["revision_no"]} == words
    vendor, product, revision = path.split("/")
    api = schemathesis.openapi.from_asgi("/-/esi/openapi.json", datasette_app(one_device_db).app())
    operation = api["/-/esi/device/{vendor}/{product}/{revision}.json"]["GET"]
    asked = operation.Case(path_parameters={"vendor": vendor, "product": product, "revision": revision})
    await asyncio.to_thread(asked.call_and_validate)


PATTERNS = {
    parameter["name"]: parameter["schema"].get("items", parameter["schema"]).get("pattern", "")
    for parameter in openapi_document("/")["paths"]["/-/esi/devices.json"]["get"]["parameters"]
}
NUMBER = r"(|0x|0X|#x|#X|x)[0-9a-fA-F]{0,3}|[0-9]{1,6}|0{0,3}42949672[0-9]{2,3}|0x0?[0-9a-f]{8}|1[0-9][0-9]|[0-9][0-9]"
SPELLINGS = (
    st.text("0129afAFxX#:@-<=> ", max_size=12)
    | st.from_regex(f"({NUMBER})(:({NUMBER}))?", fullmatch=True)
    | st.from_regex(f"({NUMBER}):({NUMBER})(:({NUMBER}|-))?(@({NUMBER}))?", fullmatch=True)
    | st.from_regex(f"(<=|>=|=|<)? ?(-)? ?({NUMBER})", fullmatch=True)
)


def is_taken(name: str, text: str) -> bool:
    try:
        filter_of_texts({**({"maps": ["0x6040"]} if name == "bits" else {}), name: [text]})
    except InputError:
        return False
    return True


@pytest.mark.parametrize("name", ["product", "bits", "maps", "not-maps", "object", "bytes-in", "axes", "like"])
def test_the_patterns_of_openapi_are_what_the_filters_take(name):
    """In both directions: made from the pattern it is taken, and what is taken has the pattern."""
    # Without the ends: in Python $ also stands before a line end.
    pattern = PATTERNS[name].removeprefix("^").removesuffix("$")

    @given(st.from_regex(pattern, fullmatch=True))
    @settings(max_examples=25)
    def is_taken_when_made_from_it(text):
        assert is_taken(name, text)

    @given(SPELLINGS)
    @settings(max_examples=60)
    def is_taken_if_it_has_it(text):
        assert is_taken(name, text) == bool(re.fullmatch(pattern, text))

    is_taken_when_made_from_it()
    is_taken_if_it_has_it()


@pytest.mark.parametrize(
    ("name", "text"),
    [("maps", text) for text in ("0x6000:AF", "0x6000:e1", "0x6000:255", "#x6000:1", "24576:1", "0x006000:09")]
    + [("bytes-in", ">=0x10"), ("product", "0000000000000001"), ("like", "#x1:2:-"), ("like", "1:2@1")],
)
def test_every_notation_has_the_pattern(name, text):
    assert is_taken(name, text)
    assert re.search(PATTERNS[name], text)


@pytest.mark.parametrize(
    ("name", "text"),
    [("maps", text) for text in ("0x10000", "65536", "0x6000:10", "0x6000:99", "0x6000:256", "0x6000:A", "0x6000:")]
    + [("product", "4294967296"), ("product", "0x100000000"), ("like", "1:2@0"), ("bytes-in", "<8")],
)
def test_what_is_refused_has_not_the_pattern(name, text):
    assert not is_taken(name, text)
    assert not re.search(PATTERNS[name], text)


def test_openapi_lists_the_modules_that_the_route_of_a_device_reads(data_db):
    paths = openapi_document("/")["paths"]
    parameters = paths["/-/esi/device/{vendor}/{product}/{revision}.json"]["get"]["parameters"]
    listed = {item["name"]: item for item in parameters}
    assert list(listed) == ["vendor", "product", "revision", "module"]
    items = listed["module"]["schema"]["items"]
    assert all(re.search(items["pattern"], text) for text in items["examples"])
    # As pages write them, as people do, and what parse_plugged refuses.
    assert all(re.search(items["pattern"], text) for text in ("0=0x13EC", "0x10=5100", "#x1=#X13ec/KL6021-A"))
    assert not any(re.search(items["pattern"], text) for text in ("65536=0x1", "0=0x1/", "=0x1", "0=13EC"))


@pytest.mark.parametrize(
    "path", ["4247/9222/143", "#x1097/#X2406/0X8F", "0x1097/0x2406/0x8f@0x1", "1/1/latest", "1/1/-@2"]
)
def test_openapi_takes_the_notations_that_the_route_of_a_device_takes(path):
    paths = openapi_document("/")["paths"]
    parameters = paths["/-/esi/device/{vendor}/{product}/{revision}.json"]["get"]["parameters"]
    patterns = [item["schema"]["pattern"] for item in parameters if item["in"] == "path"]
    assert all(re.search(pattern, text) for pattern, text in zip(patterns, path.split("/"), strict=True))


def test_a_scan_on_the_shell(data_db, tmp_path):
    (tmp_path / "slaves.txt").write_text(SLAVES)
    done = run("identify", "--slaves", str(tmp_path / "slaves.txt"), db=data_db)
    assert done.exit_code == 0
    lines = done.stdout.splitlines()
    assert "exact" in lines[1] and "200 mA" in lines[1] and "io_terminal_8di_8do.xml, line 295" in lines[1]
    assert "accepted" in lines[2] and "-100 mA" in lines[2]
    assert "none" in lines[3]
    assert "  1: no exact ESI; nearest shown because 0x00110000 accepts it by its CheckRevisionNo EQ_OR_G" in lines
    assert "  1: E-bus supply exceeded by 100 mA: put a power feed before it" in lines
    assert "  1: alias 7 is also that of slave 0" in lines
    assert "  slaves           3, 1 with exact ESI" in lines
    assert (
        "  process data     2 bytes out, 2 bytes in; of slave 1 as the nearest ESI has them; unknown of slave 2"
        in lines
    )


def test_a_bus_is_looked_at_in_ring_order(data_db):
    """Slave 0 feeds 200 mA, slave 1 takes 300 of it, whichever is printed first; JSON has the lines of the text."""
    head, first, second, third = re.split("(?m)^(?==== )", SLAVES)
    turned = run("identify", "--slaves", "-", db=data_db, stdin=head + third + "garbage\n" + second + first)
    assert turned.stdout == run("identify", "--slaves", "-", db=data_db, stdin=SLAVES).stdout
    found = run("identify", "--slaves", "-", "--format", "json", db=data_db, stdin=third + "garbage\n" + first).stdout
    slaves = [item["slave"] for item in json.loads(found)]
    assert [(item["position"], item["line"], len(item["findings"])) for item in slaves] == [(0, 7, 0), (2, 1, 1)]
    assert "slave 1 is not in the listing; the E-bus budget ends there" in slaves[1]["notes"]


def test_the_state_of_a_slave_is_in_the_answer(data_db):
    text = SLAVES.replace("Alias: 7\n", "Device: Backup\nState: PREOP+ERROR\nFlag: E\n", 1)
    failed, silent, _ = json.loads(run("identify", "--slaves", "-", "--format", "json", db=data_db, stdin=text).stdout)
    names = ("state", "state_error", "failed", "al_status_code", "master_device")
    assert [failed["slave"][name] for name in names] == ["PREOP", True, True, None, "Backup"]
    assert [silent["slave"][name] for name in names] == [None] * 5
    assert "the slave reports an error in PREOP" in failed["slave"]["notes"]


def test_gaps_of_a_listing_are_told(data_db):
    text = SLAVES.replace("Slave 2", "Slave 9").replace("Slave 1", "Slave 3")
    lines = run("identify", "--slaves", "-", db=data_db, stdin=text).stdout.splitlines()
    assert "  not listed       slaves 1, 2, 4 to 8" in lines
    sizes = "2 bytes out, 2 bytes in; of slave 3 as the nearest ESI has them; unknown of slaves 1, 2, 4 to 9"
    assert f"  process data     {sizes}" in lines


def test_a_listing_of_one_slave_is_of_that_slave(data_db):
    """`ethercat slaves -v -p 3`: the summary names the others once, and calls it no reference clock of their bus."""
    _, first, _, _ = re.split("(?m)^(?==== )", SLAVES)
    lines = run("identify", "--slaves", "-", db=data_db, stdin=first.replace("Slave 0", "Slave 3")).stdout.splitlines()
    assert lines[lines.index("Summary") + 1 :] == [
        "  slaves           1, 1 with exact ESI",
        "  not listed       slaves 0 to 2",
        "  process data     1 byte out, 1 byte in",
    ]
    assert not any(line.startswith("  3: slaves") for line in lines)


async def test_a_description_without_revision_at_a_bus(tmp_path):
    """Its sizes and its E-bus current count; it is shown without a revision, not with 0."""
    content = "<Info><Electrical><EBusCurrent>200</EBusCurrent></Electrical></Info><Sm>Outputs</Sm>"
    terminal = device(content + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"'), product="#x5", type_text="A")
    coupler = device("<Info><Electrical><EBusCurrent>-1000</EBusCurrent></Electrical></Info>", product="#x4")
    described = (coupler + terminal.replace(' RevisionNo="#x1"', "")).replace('"YY"', '"YK"')
    db, scan = catalog_of(tmp_path, esi(described)), "vendor,product,revision\n0xe5c,4,1\n0xe5c,5,1\n"
    lines = run("identify", "--slaves", "-", db=db, stdin=scan).stdout.splitlines()
    assert lines[2].split()[2:] == ["product", "A", "-", "800", "mA", "2", "0", "0.xml,", "line", "1"]
    found = json.loads(run("identify", "--slaves", "-", "--format", "json", db=db, stdin=scan).stdout)[1]
    slave = found["slave"]
    assert (found["device"]["revision_no_hex"], slave["e_bus_left_ma"]) == (None, 800)
    assert (slave["output_bytes"], slave["input_bytes"]) == (2, 0)
    posted = await (await client(db)).post("/-/esi/scan", data={"scan": scan})
    row = html.fromstring(posted.text).cssselect("table.slaves tbody tr:not(.remarks)")[1]
    assert [cell.text_content() for cell in row.cssselect("td")[4:9]] == ["A", "-", "800 mA", "2", "0"]


async def test_pages_and_warnings_name_no_revision_that_is_not_there(tmp_path):
    other = device("<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 16, attributes='Sm="0"'), type_text="other")
    db = catalog_of(tmp_path, esi(device(revision="#x2") + other.replace(' RevisionNo="#x1"', "")))
    (warning,) = answer(db, 0xE5C, 1, 2).warnings
    assert "in 1 of 1 other revisions; the one without RevisionNo for example: SM0" in warning
    shown = html.fromstring((await (await client(db)).get("/-/esi/device/0xe5c/1/2")).text)
    cells = shown.cssselect("section[aria-labelledby=revisions] tbody td:first-child")
    assert [cell.text_content().strip() for cell in cells] == ["-", "0x00000002"]
    (tmp_path / "in" / "0.xml").write_text(esi(other.replace(' RevisionNo="#x1"', "")))
    with Catalog.open(db) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
    latest = await (await client(db)).get("/-/esi/device/0xe5c/1/latest")
    assert latest.status_code == 200
    facts = html.fromstring(latest.text).cssselect("dl.facts dd")
    assert facts[2].text_content().strip() == "-"
    assert "  revision         -" in run("show", "0xe5c:1", db=db).stdout.splitlines()


def test_pdos_and_objects_beside_a_scan(data_db, tmp_path):
    (tmp_path / "slaves.txt").write_text(SLAVES)
    (tmp_path / "pdos.txt").write_text(
        'SM1: PhysAddr 0x1000, DefaultSize    1, ControlRegister 0x00, Enable 1\n  TxPDO 0x1aff "X"\n'
    )
    words = ("--slaves", str(tmp_path / "slaves.txt"), "--format", "json")
    named = run("identify", *words, "--pdos", f"0={tmp_path / 'pdos.txt'}", db=data_db)
    first, second, third = json.loads(named.stdout)
    assert "TxPDO 0x1AFF: not described" in first["slave"]["differences"]
    assert second["slave"]["differences"] == third["slave"]["differences"] == []
    unnamed = run("identify", *words, "--pdos", str(tmp_path / "pdos.txt"), db=data_db)
    assert unnamed.exit_code == 2
    assert "does not name its slave; write POSITION=FILE" in unnamed.stderr


LIST = """\
=== Master 0, Slave {} ===
SM1: PhysAddr 0x1000, DefaultSize    1, ControlRegister 0x00, Enable 1
  TxPDO 0x1aff "X"
"""
OF_TWO_MASTERS = SLAVES.replace("Master 0, Slave 1", "Master 1, Slave 0").replace(
    "Master 0, Slave 2", "Master 1, Slave 1"
)


def compared(db: Path, folder: Path, slaves: str, pdos: str, place: str = ""):
    """``identify --slaves`` with a list of PDOs beside it."""
    (folder / "slaves.txt").write_text(slaves)
    (folder / "pdos.txt").write_text(pdos)
    words = ("--slaves", folder / "slaves.txt", "--pdos", f"{place}{folder / 'pdos.txt'}")
    return run("identify", *map(str, words), "--format", "json", db=db)


@pytest.mark.parametrize(
    "slaves",
    [
        "vendor,product,revision\n0xe5c,0x0d080808,0x110000\n0xe5c,0x0d080808,0x110000\n",
        "0  0:0  PREOP  +  0x00000e5c:0x0d080808\n1  0:1  PREOP  +  0x00000e5c:0x0d080808\n",
    ],
)
def test_lists_of_a_master_fit_scans_that_name_none(data_db, tmp_path, slaves):
    first, second = json.loads(compared(data_db, tmp_path, slaves, LIST.format(1)).stdout)
    assert first["slave"]["differences"] == []
    assert "TxPDO 0x1AFF: not described" in second["slave"]["differences"]


@pytest.mark.parametrize(
    ("slaves", "position", "place", "words"),
    [
        (SLAVES, 7, "", "of slave 7 of master 0, which the scan has not"),
        (SLAVES, 0, "7=", "of slave 7 of master 0, which the scan has not"),
        (OF_TWO_MASTERS.replace("Master 0", "Master 2"), 0, "", "of slave 0 of master 0, which the scan has not"),
        ("0 0:0 PREOP + A\n0 0:0 PREOP + 0x00000e5c:0x0d080808\n", 0, "", "fits slave 0 of several buses"),
    ],
)
def test_lists_of_no_slave_or_of_several_are_refused(data_db, tmp_path, slaves, position, place, words):
    done = compared(data_db, tmp_path, slaves, LIST.format(position), place)
    assert (done.exit_code, len(done.stderr.splitlines())) == (2, 1)
    assert words in done.stderr


@pytest.mark.parametrize(
    ("slaves", "lists", "place"),
    [
        (SLAVES, LIST.format(0) + LIST.format(1), "0="),
        (SLAVES, LIST.format(1) + LIST.format(1), ""),
        (SLAVES[: SLAVES.index("=== Master 0, Slave 1")], LIST.format(0).partition("\n")[2] * 2, ""),
        ("vendor,product\n1,1\n", LIST.format(0) + LIST.format(0).replace("Master 0", "Master 1"), ""),
    ],
)
def test_two_lists_of_one_slave_are_refused(data_db, tmp_path, slaves, lists, place):
    """Whichever is taken, it may be that of another slave."""
    done = compared(data_db, tmp_path, slaves, lists, place)
    assert (done.exit_code, done.stdout) == (2, "")
    line = max(number for number, text in enumerate(lists.splitlines(), 1) if text.startswith("SM1"))
    slave = 1 if "Slave 1" in lists and not place else 0
    assert f"pdos.txt, line {line}: another list of slave {slave}; " in done.stderr


def test_a_position_against_the_heading_is_told(data_db, tmp_path):
    done = compared(data_db, tmp_path, SLAVES, LIST.format(1), "0=")
    assert [bool(item["slave"]["differences"]) for item in json.loads(done.stdout)] == [True, False, False]
    assert done.stderr.endswith("pdos.txt, line 2: the heading before it names slave 1\n")


def test_a_list_beside_a_scan_of_two_masters_names_its_own(data_db, tmp_path):
    unnamed = compared(data_db, tmp_path, OF_TWO_MASTERS, LIST.format(0).partition("\n")[2], "0=")
    assert unnamed.exit_code == 2
    assert "put the heading of its master before it (=== Master N, Slave 0 ===)" in unnamed.stderr
    named = compared(data_db, tmp_path, OF_TWO_MASTERS, LIST.format(0).replace("Master 0", "Master 1"))
    told = [bool(item["slave"]["differences"]) for item in json.loads(named.stdout)]
    assert told == [False, True, False]


PDOS = 'SM0: PhysAddr 0x1000, DefaultSize    0, ControlRegister 0x64, Enable 1\n  RxPDO 0x1600 "R"\n'


def test_the_variant_that_fits_the_printed_pdos_is_named(tmp_path):
    wide, narrow = (
        device("<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", *bits, attributes='Sm="0"')) for bits in ((8, 8), (8,))
    )
    db = catalog_of(tmp_path, esi(wide), esi(narrow))
    scan = "vendor,product,revision\n0xe5c,1,1\n"
    (found,) = json.loads(compared(db, tmp_path, scan, f'{PDOS}    PDO entry 0x7000:01, 8 bit, "a"\n').stdout)
    assert (found["device"]["variant"], found["slave"]["output_bytes"]) == (2, 1)
    assert [item["variant"] for item in found["variants"]] == [1, 2]
    assert found["slave"]["differences"] == []
    assert found["slave"]["notes"] == ["variant 2 of 2 fits its PDOs best"]
    (neither,) = json.loads(
        compared(
            db,
            tmp_path,
            scan,
            'SM0: PhysAddr 0x1000, DefaultSize 0, ControlRegister 0x64, Enable 1\n  RxPDO 0x1601 "R"\n',
        ).stdout
    )
    assert neither["device"]["variant"] == 1
    assert neither["slave"]["notes"] == [
        "all 2 variants fit its PDOs alike",
        "PDOs are listed without entries: mappings are not compared, bytes are those described by default",
    ]


async def test_an_exact_slave_with_several_descriptions_is_told(several):
    """Revision 0x120000 has two, with the first output of 16 and of 8 bit; that other revisions differ is no news."""
    scan = "vendor,product,revision\n0xe5c,1,0x120000\n0xe5c,1,0x100000\n"
    words = (
        "warning: default process image differs in 1 of 1 other variants of this identity; @2 for example: "
        "SM0 byte 0.0 is 0x7000:01 (16 bit) here, 0x7000:01 (8 bit) there"
    )
    lines = run("identify", "--slaves", "-", db=several, stdin=scan).stdout.splitlines()
    assert lines[lines.index("Notes") :][:3] == ["Notes", f"  0: {words}", ""]
    posted = await (await client(several)).post("/-/esi/scan", data={"scan": scan})
    notes = html.fromstring(posted.text).cssselect("table.slaves tr.remarks")
    assert [row.text_content().strip() for row in notes] == [words]


async def test_the_page_of_an_image_warns_as_identify_does(several):
    """The header words 8 to 13 of an EEPROM are vendor, product and revision, low words first."""
    header = bytearray(128)
    header[16:28] = b"".join(word.to_bytes(2, "little") for word in (0xE5C, 0, 1, 0, 0, 0x12))
    posted = await (await client(several)).post("/-/esi/scan", files={"file": ("a.bin", bytes(header) + b"\xff\xff")})
    warned = [item.text_content() for item in html.fromstring(posted.text).cssselect("p")]
    assert [text.partition(";")[0] for text in warned if text.startswith("warning: ")] == [
        "warning: default process image differs in 1 of 1 other variants of this identity",
        "warning: default process image differs in 2 of 2 other revisions",
    ]


def test_the_warning_is_of_the_variant_that_fits_the_printed_pdos(several, tmp_path):
    printed = f'{PDOS}    PDO entry 0x7000:01, 8 bit, "a"\n    PDO entry 0x7000:02, 8 bit, "b"\n'
    (found,) = json.loads(compared(several, tmp_path, "vendor,product,revision\n0xe5c,1,0x120000\n", printed).stdout)
    assert (found["device"]["variant"], found["slave"]["differences"]) == (2, [])
    assert found["warnings"][0].endswith(
        "@1 for example: SM0 byte 0.0 is 0x7000:01 (8 bit) here, 0x7000:01 (16 bit) there"
    )


async def test_what_is_not_understood_is_told_at_every_door(several, tmp_path):
    """In JSON it stands with the slave in whose lines it is; what stands before them with the first."""
    block = "\nSlave:{}\n Name:A\n Man: 00000e5c ID: 00000001 Rev: 00120000\n only LRD/LWR:0\n"
    scan = "SOEM (Simple Open EtherCAT Master)\n5 slaves found and configured.\n" + block.format(1) + block.format(2)
    scan += "garbage\n"
    announced = {"line": 2, "message": "5 slaves are announced, 2 are listed"}
    garbage = {
        "line": 13,
        "message": "1 line is not read as part of a slave in SOEM slaveinfo; the first: 'garbage'",
    }
    posted = (await (await client(several)).post(ROUTE, content=scan)).json()
    assert [item["slave"]["findings"] for item in posted] == [[announced], [garbage]]
    (tmp_path / "p.txt").write_text(f'{PDOS}    PDO entry 0x7000:01, 1600 bit, "a"\n')
    (tmp_path / "s.txt").write_text('SDO 0x1000, "Device type"\ngarbage\nSDO 0x1001, "Err')
    beside = ["--pdos", f"0={tmp_path / 'p.txt'}", "--sdos", f"1={tmp_path / 's.txt'}"]
    done = run("identify", "--slaves", "-", *beside, "--format", "json", db=several, stdin=scan)
    pdos, sdos = f"--pdos 0={tmp_path / 'p.txt'}", f"--sdos 1={tmp_path / 's.txt'}"
    broken = """not understood, so the list is not complete and not compared: 'PDO entry 0x7000:01, 1600 bit, "a"'"""
    skipped, cut = "1 line is not read as `ethercat sdos`; the first: 'garbage'", "the name is cut off: 'Err'"
    assert [item["slave"]["findings"] for item in json.loads(done.stdout)] == [
        [announced, {"line": 3, "message": f"{pdos}: {broken}"}],
        [garbage, {"line": 2, "message": f"{sdos}: {skipped}"}, {"line": 3, "message": f"{sdos}: {cut}"}],
    ]
    assert done.stderr.splitlines() == [
        f"line 2: {announced['message']}",
        f"line 13: {garbage['message']}",
        f"{pdos}, line 3: {broken}",
        f"{sdos}, line 2: {skipped}",
        f"{sdos}, line 3: {cut}",
    ]


def test_the_described_e_bus_current_counts_where_slaveinfo_prints_zero(tmp_path):
    terminals = "".join(
        device(f"<Info><Electrical><EBusCurrent>{current}</EBusCurrent></Electrical></Info>", product=product)
        for product, current in (("#x1", -2000), ("#x2", 90))
    ).replace('"YY"', '"KK"')
    db = catalog_of(tmp_path, esi(terminals))
    block = "Slave:{0}\n Man: 00000e5c ID: 0000000{0} Rev: 00000001\n Ebus current: {1}[mA]\n only LRD/LWR:0\n"
    scan = block.format(1, -2000) + block.format(2, 0)
    found = json.loads(run("identify", "--slaves", "-", "--format", "json", db=db, stdin=scan).stdout)
    assert [item["slave"]["e_bus_left_ma"] for item in found] == [2000, 1910]


def test_bits_of_two_sync_managers_are_added_before_they_are_rounded(tmp_path):
    """3 bits and 5 bits: a byte each in the memory of the device, 8 bits for SOEM, and that is as described."""
    pdos = pdo("RxPdo", "#x1600", 3, attributes='Sm="0"') + pdo("RxPdo", "#x1601", 5, attributes='Sm="1"')
    db = catalog_of(tmp_path, esi(device("<Sm>Outputs</Sm><Sm>Outputs</Sm>" + pdos)))
    block = "Slave:1\n Output size: {}bits\n Input size: 0bits\n Man: 00000e5c ID: 00000001 Rev: 00000001\n"

    def notes(bits: int) -> list[str]:
        answer = run("identify", "--slaves", "-", "--format", "json", db=db, stdin=block.format(bits)).stdout
        (found,) = json.loads(answer)
        return found["slave"]["notes"]

    assert notes(8) == []
    assert notes(7) == ["bytes out: 1 configured, 2 in the default process image of the description"]


VIRTUAL = '<Sm Virtual="1">Outputs</Sm>'
SOEM_PDOS = {
    "virtual": pdo("RxPdo", "#x1601", 8, attributes='Sm="1" Virtual="1"'),
    "excluded": pdo("RxPdo", "#x1601", 8, attributes='Sm="0"', extra="<Exclude>#x1600</Exclude>"),
}
OF_EEPROM = "; the EEPROM assigns that many"


@pytest.mark.parametrize(
    ("second", "mailbox", "bits", "reason"),
    [
        ("virtual", "", 10, None),
        ("virtual", "", 17, ""),
        ("excluded", "", 10, OF_EEPROM),
        ("excluded", "<Mailbox><CoE/></Mailbox>", 10, ""),
    ],
)
def test_soem_counts_what_the_eeprom_assigns(tmp_path, second, mailbox, bits, reason):
    """Without CoE ecx_siiPDO adds up 2 bits and 8, by default there are 2; with CoE SOEM asks the device."""
    first = pdo("RxPdo", "#x1600", 2, attributes='Sm="0"')
    db = catalog_of(tmp_path, esi(device("<Sm>Outputs</Sm>" + VIRTUAL + first + SOEM_PDOS[second] + mailbox)))
    block = f"Slave:1\n Output size: {bits}bits\n Input size: 0bits\n Man: 00000e5c ID: 00000001 Rev: 00000001\n"
    (found,) = json.loads(run("identify", "--slaves", "-", "--format", "json", db=db, stdin=block).stdout)
    size = f"bytes out: {-(-bits // 8)} configured, 1 in the default process image of the description"
    assert found["slave"]["notes"] == ([] if reason is None else [size + reason])


def test_variants_that_fit_best_alike_are_all_named(tmp_path):
    """The first assigns another PDO than the printed one and lacks that, the others have it with other entries."""
    pdos = (("#x1601", 8, 8), ("#x1600", 16), ("#x1600", 32))
    variants = [esi(device("<Sm>Outputs</Sm>" + pdo("RxPdo", *of_one, attributes='Sm="0"'))) for of_one in pdos]
    db = catalog_of(tmp_path, *variants)
    printed = f'{PDOS}    PDO entry 0x7000:01, 24 bit, "a"\n'
    (found,) = json.loads(compared(db, tmp_path, "vendor,product,revision\n0xe5c,1,1\n", printed).stdout)
    assert [item["variant"] for item in found["variants"]] == [1, 2, 3]
    assert found["slave"]["notes"] == [
        "bytes out: 3 configured, 2 in the default process image of the description",
        "variants 2 and 3 of 3 fit its PDOs best and alike; 2 is taken",
    ]
    assert found["device"]["variant"] == 2


def test_a_description_is_read_once_for_all_slaves_that_have_it(tmp_path, monkeypatch):
    content = "<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"')
    db = catalog_of(tmp_path, esi(device(content)), esi(device(content, type_text="B")))
    scan = read_scan("vendor,product,revision\n" + "0xe5c,1,1\n" * 3)
    (one_slave,) = read_pdos(f'{PDOS}    PDO entry 0x7000:01, 8 bit, "a"\n').slaves
    printed = [msgspec.structs.replace(one_slave, position=position) for position in range(3)]
    read: list[Identity] = []
    with Catalog.open(db) as catalog:
        ask = description.read_description
        monkeypatch.setattr(description, "read_description", lambda *asked: read.append(asked[-1]) or ask(*asked))
        (bus,) = catalog.identify_scan(scan, printed)
    assert len(bus.slaves) == 3
    assert sorted(identity.variant for identity in read) == [1, 2]


def test_lists_of_a_slave_without_description_are_not_dropped_silently(data_db, tmp_path):
    (found,) = json.loads(compared(data_db, tmp_path, "vendor,product\n0xcd,0x456\n", PDOS).stdout)
    assert found["slave"]["notes"] == ["PDOs not compared: no description of slave 0"]
    assert found["slave"]["differences"] == []


@pytest.mark.parametrize(
    ("option", "text", "place", "words"),
    [
        ("--pdos", PDOS, "9=", "is of slave 9, which the scan has not"),
        ("--sdos", 'SDO 0x1000, "Device type"', "", "does not name its slave; write POSITION=FILE"),
    ],
)
def test_a_list_of_no_slave_is_named_as_it_was_given(data_db, tmp_path, option, text, place, words):
    (tmp_path / "slaves.csv").write_text("vendor,product,revision\n0xe5c,1,1\n0xe5c,2,1\n")
    (tmp_path / "list.txt").write_text(text)
    given = f"{place}{tmp_path / 'list.txt'}"
    done = run("identify", "--slaves", str(tmp_path / "slaves.csv"), option, given, db=data_db)
    assert (done.exit_code, done.stderr) == (2, f"esicatalog: {option} {given} {words}\n")


@pytest.mark.parametrize("format_words", [(), ("--format", "json")])
def test_hexadecimal_digits_without_prefix_are_told(data_db, format_words):
    """0x1097:0x2406 is the EYOU module; 1097 and 2406 are 0x449 and 0x966, of nobody."""
    done = run("identify", "1097", "2406", *format_words, db=data_db)
    assert (done.exit_code, done.stderr) == (
        1,
        "decimal 1097 2406 is unknown; 0x1097 0x2406 would be EYOU_ServoModule_V143\n",
    )
    for known in (("0x1097", "0x2406"), ("4247", "9222"), ("9", "9"), ("4294967295", "1")):
        assert "decimal" not in run("identify", *known, db=data_db).stderr


def test_a_master_configuration_is_no_scan(data_db, tmp_path):
    (tmp_path / "bus.xml").write_text('<?xml version="1.0"?>\n<EtherCATConfig Version="1.3"><Config/></EtherCATConfig>')
    for words in (("identify", "--slaves"), ("export", "igh", "--scan")):
        done = run(*words, str(tmp_path / "bus.xml"), db=data_db)
        assert (done.exit_code, "this is an ENI file" in done.stderr) == (2, True)
        assert "identify --eni" in done.stderr


def test_one_way_to_say_who(data_db):
    for words, begins in (
        (("1", "2", "--sii", "x"), "give only one of VENDOR PRODUCT"),
        (("--eni", "x", "--sii", "x"), "give only one of VENDOR PRODUCT"),
        ((), "say who: VENDOR PRODUCT"),
        (("1",), "say who: VENDOR PRODUCT"),
    ):
        done = run("identify", *words, db=data_db)
        assert (done.exit_code, done.stderr.startswith(f"esicatalog: {begins}")) == (2, True), words


def test_a_reference_clock_behind_slaves_of_which_nothing_is_known(tmp_path):
    """A coupler's description says nothing of clocks, though it has one; a list of identities neither."""
    mode = "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>"
    db = catalog_of(tmp_path, esi(device(product="#x1") + device(mode, product="#x2")))
    done = run("identify", "--slaves", "-", db=db, stdin="vendor,product,revision\n0xe5c,1,1\n0xe5c,2,1\n")
    words = "slave 1 is the first known to have distributed clocks"
    silent = "of slave 0 its description says nothing of clocks"
    assert f"  reference clock  {words}; {silent}" in done.stdout.splitlines()
    listed = "vendor,product,revision\n0xe5c,1,1\n0xe5c,9,1\n0xe5c,1,1\n0xe5c,2,1\n"
    done = run("identify", "--slaves", "-", db=db, stdin=listed)
    words = "slave 3 is the first known to have distributed clocks; nothing is known of slave 1"
    silent = "of slaves 0, 2 their descriptions say nothing of clocks"
    assert f"  reference clock  {words}; {silent}" in done.stdout.splitlines()
    excluded = mode.replace("<Dc>", '<Dc PotentialReferenceClock="0">')
    other = catalog_of(tmp_path / "other", esi(device(mode, product="#x1") + device(excluded, product="#x2")))
    done = run("identify", "--slaves", "-", db=other, stdin="vendor,product,revision\n0xe5c,2,1\n0xe5c,1,1\n")
    assert "  reference clock  slave 1 is the first that can be it" in done.stdout.splitlines()


@pytest.mark.parametrize(
    ("scan", "words"),
    [
        ("Slave:1\n Has DC: 1\n Man: 00000e5c ID: 00000001 Rev: 00000001\n", "; system time not told"),
        (
            "=== Master 0, Slave 0 ===\nDL information:\n  Distributed clocks: yes, delay measurement only\n",
            "no candidate",
        ),
    ],
)
def test_a_coupler_that_only_measures_delays_is_no_sure_reference_clock(tmp_path, scan, words):
    db = catalog_of(tmp_path, esi(device()))
    lines = run("identify", "--slaves", "-", db=db, stdin=scan).stdout.splitlines()
    (told,) = (line.removeprefix("  reference clock  ") for line in lines if line.startswith("  reference clock"))
    first = "slave 0 is the first known to have distributed clocks"
    assert told == (first + words if words.startswith(";") else words)


def test_a_master_configuration(data_db, tmp_path):
    eni = (
        "<EtherCATConfig><Config><Slave><Info><Name>Term</Name><PhysAddr>1001</PhysAddr><VendorId>3676</VendorId>"
        "<ProductCode>218630152</ProductCode><RevisionNo>1114112</RevisionNo></Info>"
        "<DC><ReferenceClock>1</ReferenceClock><CycleTime0>2000000</CycleTime0></DC></Slave></Config></EtherCATConfig>"
    )
    (tmp_path / "bus.xml").write_text(eni)
    (found,) = json.loads(run("identify", "--eni", str(tmp_path / "bus.xml"), "--format", "json", db=data_db).stdout)
    assert found["slave"]["notes"] == [], "AssignActivate 0x300 generates SYNC0"
    assert (found["slave"]["reference_clock"], found["slave"]["potential_reference_clock"]) == (True, None)
    lines = run("identify", "--eni", tmp_path / "bus.xml", db=data_db).stdout.splitlines()
    assert "  reference clock  slave 0 is configured as reference clock" in lines
    assert (found["match"], found["device"]["type"], found["slave"]["name"]) == ("exact", "ECX-D808", "Term")


def test_a_master_configuration_that_expects_an_alias_twice(data_db, tmp_path):
    slave = (
        "<Slave><Info><VendorId>2</VendorId><ProductCode>3</ProductCode><RevisionNo>4</RevisionNo>"
        '<Identification Value="7"><Ado>18</Ado></Identification></Info></Slave>'
    )
    (tmp_path / "bus.xml").write_text(f"<EtherCATConfig><Config>{slave * 2}</Config></EtherCATConfig>")
    lines = run("identify", "--eni", tmp_path / "bus.xml", db=data_db).stdout.splitlines()
    assert "  same alias       7: slaves 0, 1" in lines


def test_an_eeprom_image(data_db, tmp_path):
    """Header words 8 to 13 are vendor, product and revision; a category end mark follows the header."""
    words = [0x0E5C, 0, 0x0808, 0x0D08, 0, 0x0011]
    header = bytearray(128)
    header[16:28] = b"".join(word.to_bytes(2, "little") for word in words)
    (tmp_path / "dump.bin").write_bytes(bytes(header) + b"\xff\xff")
    done = run("identify", "--sii", str(tmp_path / "dump.bin"), db=data_db)
    assert done.stdout.startswith("exact")
    (tmp_path / "empty.bin").write_bytes(b"\xff" * 256)
    empty = run("identify", "--sii", str(tmp_path / "empty.bin"), db=data_db)
    assert empty.exit_code == 2
    assert "an empty EEPROM" in empty.stderr


@pytest.mark.parametrize(
    "words",
    [
        (),
        ("1",),
        ("1", "2", "--slaves", "x"),
        ("--slaves", "x", "--eni", "y"),
        ("1", "2", "--pdos", "x"),
        ("--slaves", "missing.txt"),
    ],
)
def test_wrong_usage_is_one_line(data_db, words):
    done = run("identify", *words, db=data_db)
    assert done.exit_code == 2
    assert len(done.stderr.splitlines()) == 1


@pytest.mark.corpus
def test_scenario_of_real_terminals(corpus, tmp_path):
    """EL2008 exactly, EL3204 by vendor only (its code is in no file there), two invented devices not at all."""
    (text,) = (corpus / "cli").rglob("*scenario1__slaves.txt")
    scan = read_scan(text.read_text())
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([corpus / "esi" / "DiamondLightSource+ethercat.zip"])
        (bus,) = catalog.identify_scan(scan)
    assert [item.identification.match for item in bus.slaves] == ["exact", "vendor", "none", "none"]
    assert bus.slaves[0].identification.device.device.type == "EL2008"


def test_errors_name_the_file_or_the_number(data_db, tmp_path):
    (tmp_path / "bad.csv").write_text("vendor,product,revision\n0xe5c,zz,1\n")
    (tmp_path / "slaves.csv").write_text("0xe5c,0x0d080808,0x110000\n")
    (tmp_path / "garbage.txt").write_text("hello\n")
    slaves, garbage = ("--slaves", tmp_path / "slaves.csv"), tmp_path / "garbage.txt"
    for words, start in (
        (("--slaves", tmp_path / "bad.csv"), f"{tmp_path / 'bad.csv'}: line 2: product 'zz' is not a number"),
        ((*slaves, "--pdos", f"0={garbage}"), f"{garbage}: "),
        ((*slaves, "--sdos", garbage), f"{garbage}: "),
        (("--eni", garbage), f"{garbage}: "),
        (("0x1097", "0x2406", "0xzz"), "revision '0xzz' is not a number"),
    ):
        assert one_line_error(run("identify", *words, db=data_db)).startswith(f"esicatalog: {start}")
