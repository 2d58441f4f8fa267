"""Descriptions of one identity: stored once per content, numbered by rule, whatever the order they came in."""

import sqlite3
from contextlib import closing
from itertools import permutations
from pathlib import Path

import pytest
from snippets import device, esi, pdo, read, rows, write
from web_client import client

from esicatalog import Catalog, NotFound
from esicatalog.catalog.database import catalog_url, make_engine
from esicatalog.catalog.rederive import derive_again
from esicatalog.catalog.state import CONTENT_HASH, content_hash, write_state
from esicatalog.export.subject import choose_subject, subjects_of_document
from esicatalog.identity import Identity
from esicatalog.web.links import device_path

PLAIN = device(name="plain")
RICHER = device(pdo("RxPdo", "#x1600", 8, 8), name="richer")
VENDOR = "<Id>#x00000E5C</Id><Name>{}</Name>"


def versioned(content: str, version: int) -> str:
    return esi(content).replace("<Vendor>", f'<Vendor FileVersion="{version}">')


def stored(tmp_path: Path, files: dict[str, str], order: tuple[str, ...] | None = None) -> list[tuple[int, str]]:
    """(variant, name) of all descriptions after ingesting the files one by one."""
    folder = write(tmp_path / "in", files)
    db = tmp_path / f"{'-'.join(order or ['all'])}.db"
    with Catalog.open(db, create=True) as catalog:
        for name in order or sorted(files):
            catalog.ingest([folder / name], jobs=1)
        assert catalog.check().problems == []
    return rows(db, "SELECT variant, name FROM devices ORDER BY variant")


@pytest.mark.parametrize(
    ("files", "names"),
    [
        ({"a": esi(PLAIN), "b": esi(RICHER)}, ["richer", "plain"]),
        ({"a": esi(RICHER) + "<after/>", "b": esi(PLAIN)}, ["plain", "richer"]),
        ({"a": versioned(PLAIN, 1), "b": versioned(device(name="newer"), 2)}, ["newer", "plain"]),
        ({"a": versioned(RICHER, 1), "b": versioned(PLAIN, 9)}, ["richer", "plain"]),
        ({"a": esi(RICHER) + "<after/>", "b": esi(RICHER), "c": esi(PLAIN)}, ["richer", "plain"]),
        ({"a": versioned(PLAIN, 9), "b": versioned(PLAIN, 1), "c": versioned(device(name="x"), 5)}, ["plain", "x"]),
    ],
    ids=[
        "richer",
        "not recovered",
        "newer",
        "richer before newer",
        "one sound source is enough",
        "newest source counts",
    ],
)
def test_the_preferred_description_is_the_same_in_any_order(tmp_path, files, names):
    for order in (tuple(files), tuple(reversed(files))):
        assert stored(tmp_path, files, order) == list(enumerate(names, 1))


def test_among_equals_the_lowest_content_hash_is_preferred(tmp_path):
    files = {name: esi(device(name=name)) for name in "abc"}
    for order in list(permutations(files))[::2]:
        stored(tmp_path, files, order)
        db = tmp_path / f"{'-'.join(order)}.db"
        hashes = [row[0] for row in rows(db, "SELECT content_hash FROM devices ORDER BY variant")]
        assert hashes == sorted(hashes)
        assert len(hashes) == 3


def test_what_modules_have_is_not_taken_for_nothing(tmp_path):
    """EPOS4: the default module has the entry at the same place as the other variant's own PDO, but no second one."""
    slots = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent Default="1">1</ModuleIdent></Slot></Slots>'
    outputs, on_sm0 = "<Sm>Outputs</Sm>", "Sm='0'"
    of_module = pdo("RxPdo", "#x1600", 8, attributes=on_sm0)
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>M</Name>{of_module}</Module>'
    own = pdo("RxPdo", "#x1600", 8, 16, attributes=on_sm0)
    stored(tmp_path, {"a": esi(device(outputs + slots), module), "b": esi(device(outputs + own))})
    with Catalog.open(tmp_path / "all.db") as catalog:
        (warning,) = catalog.identify(0xE5C, 1, 1).warnings
    assert warning.endswith("for example: SM0 byte 1.0 is 0x7000:02 (16 bit) here, nothing there")


def test_modules_count_for_richness(tmp_path):
    slots = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot></Slots>'
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>M</Name>{pdo("RxPdo", "#x1600", *[1] * 9)}</Module>'
    modular = esi(device(slots, name="modular"), module)
    assert stored(tmp_path, {"a": esi(RICHER), "b": modular}) == [(1, "modular"), (2, "richer")]


def test_identical_content_is_stored_once(tmp_path):
    files = {
        "a.xml": esi(RICHER),
        "b.xml": "\n\n" + esi(RICHER, vendor=VENDOR.format("Spelled Otherwise")),
        "c.xml": versioned(RICHER, 3).replace("<GroupType>G<", "<GroupType>Other<"),
    }
    assert stored(tmp_path, files) == [(1, "richer")]
    query = (
        "SELECT s.member, x.line, x.group_type FROM device_sources x JOIN sources s ON s.id = x.source_id ORDER BY 1"
    )
    assert rows(tmp_path / "all.db", query) == [("a.xml", 1, "G"), ("b.xml", 3, "G"), ("c.xml", 1, "Other")]


def test_the_order_of_attributes_is_no_content(tmp_path):
    """Spellings that are not canonical are kept, whatever their order, and which document came first is not told."""
    attributes = ['StartAddress="4096"', 'ControlByte="100"', 'Enable="true"']
    files = {
        f"{number}.xml": esi(device(f"<Sm {' '.join(order)}>Outputs</Sm>", name="one"))
        for number, order in enumerate(permutations(attributes))
    }
    kept = set()
    for order in (tuple(files), tuple(reversed(files))):
        assert stored(tmp_path, files, order) == [(1, "one")]
        kept.add(str(rows(tmp_path / f"{'-'.join(order)}.db", "SELECT spelling FROM sync_managers")))
    assert len(kept) == 1


def test_the_same_identity_twice_in_one_document(tmp_path):
    assert stored(tmp_path, {"a.xml": esi(PLAIN + RICHER + PLAIN)}) == [(1, "richer"), (2, "plain")]
    assert rows(tmp_path / "all.db", "SELECT count(*) FROM device_sources") == [(3,)]


def test_devices_without_codes_are_told_apart_by_type(tmp_path):
    caps = "".join(
        device(product="", type_text=kind, name=f"{kind} {name}") for kind in ("CAP", "FEED") for name in ("x", "y")
    )
    stored(tmp_path, {"a.xml": esi(caps)})
    found = rows(tmp_path / "all.db", "SELECT type, variant, product_code, revision_no FROM devices ORDER BY 1, 2")
    assert found == [(kind, number, None, None) for kind in ("CAP", "FEED") for number in (1, 2)]


def test_devices_without_revision_are_variants_whatever_their_type(tmp_path):
    """Nobody asks for a type: each is found by its number, and lists show the product once."""
    bare = "".join(device(product="#x5", type_text=kind) for kind in "AB").replace(' RevisionNo="#x1"', "")
    stored(tmp_path, {"a.xml": esi(bare)})
    with Catalog.open(tmp_path / "all.db") as catalog:
        assert len(catalog.devices()) == 1
        every = [(found.identity_text, found.type) for found in catalog.devices(all_variants=True)]
        assert [text for text, _ in every] == ["0x00000e5c:0x00000005:-", "0x00000e5c:0x00000005:-@2"]
        assert sorted(kind for _, kind in every) == ["A", "B"]
        shown = [catalog.device(f"0xe5c:5@{number}").found.type for number in (1, 2)]
        assert shown == [kind for _, kind in every]
        answer = catalog.identify(0xE5C, 5, 1)
        assert [(found.device.variant, found.device.type) for found in answer.variants] == list(enumerate(shown, 1))
        assert answer.candidates == ()


async def test_a_description_without_revision_is_found_beside_one_with(tmp_path):
    """``-`` is its revision wherever an identity is written; without any the latest is meant."""
    beside = device(product="#x5", type_text="numbered")
    bare = [device(product="#x5", type_text=kind).replace(' RevisionNo="#x1"', "") for kind in "AB"]
    stored(tmp_path, {"a.xml": esi(beside + "".join(bare))})
    web = await client(tmp_path / "all.db")
    with Catalog.open(tmp_path / "all.db") as catalog:
        listed = catalog.devices(all_variants=True)
        assert len(listed) == 3
        for found in listed:
            assert catalog.device(found.identity_text).found == found
            assert catalog.device(found.identity).found == found
            response = await web.get(f"/-/esi/{device_path(found)}")
            assert (response.status_code, f"<h1><bdi>{found.type}" in response.text) == (200, True)
            offered = {kind for kind in ("esi", "igh", "sii") if f"/export/{kind}" in response.text}
            assert offered == ({"esi", "igh", "sii"} if found.type == "numbered" else {"esi"})
        assert catalog.device("0xe5c:5").found.type == "numbered"
        with pytest.raises(NotFound, match="has no variant 3; its variants are @1 to @2"):
            catalog.device("0xe5c:5:-@3")


def test_variants_that_an_older_version_numbered_otherwise_are_numbered_again(tmp_path):
    """It took descriptions without revision for others by their type; a migration derives everything anew."""
    bare = "".join(device(product="#x5", type_text=kind) for kind in "AB").replace(' RevisionNo="#x1"', "")
    db = tmp_path / "all.db"
    stored(tmp_path, {"a.xml": esi(bare)})
    with Catalog.open(db) as catalog:
        expected = catalog.check()
    with closing(sqlite3.connect(db)) as connection:
        connection.execute("UPDATE devices SET variant = 1")
        connection.commit()
    engine = make_engine(catalog_url(db))
    with engine.begin() as connection:
        before = content_hash(connection)
        write_state(connection, CONTENT_HASH, before)
        derive_again(connection)
    engine.dispose()
    with Catalog.open(db) as catalog:
        assert catalog.check() == expected
        assert catalog.content_hash() == expected.content_hash != before


def test_vendors_are_other_devices(tmp_path):
    files = {
        "a.xml": esi(PLAIN),
        "b.xml": esi(PLAIN, vendor="<Id>7</Id><Name>V</Name>"),
        "c.xml": esi(PLAIN, vendor=""),
    }
    assert [variant for variant, _ in stored(tmp_path, files)] == [1, 1, 1]
    assert rows(tmp_path / "all.db", "SELECT vendor_id FROM devices ORDER BY 1") == [(None,), (7,), (0xE5C,)]


def test_vendor_names_keep_every_spelling(tmp_path):
    names = ["Maker GmbH", "Maker GmbH", "MAKER", "MAKER"]
    infos = [esi(device(name=str(n)), vendor=VENDOR.format(name)) for n, name in enumerate(names)]
    listed = f"<EtherCATInfoList>{infos[2]}{infos[3]}</EtherCATInfoList>"
    stored(tmp_path, {"a.xml": infos[0], "b.xml": infos[1], "list.xml": listed})
    counted = rows(tmp_path / "all.db", "SELECT name, document_count FROM vendor_names ORDER BY document_count")
    assert counted == [("MAKER", 1), ("Maker GmbH", 2)]
    assert rows(tmp_path / "all.db", "SELECT vendor_id, name FROM vendors") == [(0xE5C, "Maker GmbH")]


@pytest.mark.parametrize("order", ["abcdef", "fedcba", "cabdef"])
def test_of_several_makers_who_use_one_vendor_id_each_device_has_its_own(tmp_path, order):
    """The id is that of rt-labs, as most documents say; its spellings are one name, and any document that says it."""
    names = {"a": "rt-labs", "b": "rt-labs", "c": "kubabuda", "d": "rt-labs AB", "e": "kubabuda", "f": "rt-labs"}
    products = {"a": "#x1", "b": "#x2", "c": "#x3", "d": "#x4", "e": "#x2", "f": "#x5"}
    files = {f: esi(device(product=products[f]), vendor=VENDOR.format(name)) for f, name in names.items()}
    stored(tmp_path, files, tuple(order))
    db = tmp_path / f"{'-'.join(order)}.db"
    shown = {1: "rt-labs", 2: "rt-labs", 3: "kubabuda", 4: "rt-labs", 5: "rt-labs"}
    assert dict(rows(db, "SELECT product_code, vendor FROM device_overview")) == shown
    with Catalog.open(db) as catalog:
        assert {found.product_code: found.vendor for found in catalog.devices()} == shown
        assert catalog.identify(0xE5C, 3, 1).device.device.vendor == "kubabuda"
        assert catalog.device("0xE5C:3").found.vendor == "kubabuda"
        assert [found.product_code for found in catalog.devices(text="kubabuda")] == [3]
    engine = make_engine(catalog_url(db))
    with engine.begin() as connection:
        connection.exec_driver_sql("UPDATE devices SET own_vendor_name = 'x' WHERE product_code <> 3")
        connection.exec_driver_sql("UPDATE devices SET own_vendor_name = NULL WHERE product_code = 3")
        derive_again(connection)
    engine.dispose()
    assert dict(rows(db, "SELECT product_code, vendor FROM device_overview")) == shown


def test_groups_are_kept_per_vendor_and_content(tmp_path):
    other = esi(PLAIN).replace("<Name>Group</Name>", "<Name>Another name</Name>")
    vendor = esi(PLAIN, vendor="<Id>7</Id><Name>V</Name>")
    stored(tmp_path, {"a.xml": esi(PLAIN), "b.xml": esi(RICHER), "c.xml": other, "d.xml": vendor})
    found = rows(tmp_path / "all.db", "SELECT vendor_id, type, name FROM groups ORDER BY 1, 3")
    assert found == [(7, "G", "Group"), (0xE5C, "G", "Another name"), (0xE5C, "G", "Group")]
    assert rows(tmp_path / "all.db", "SELECT count(*) FROM source_groups") == [(4,)]


def test_equal_dictionaries_are_stored_once(tmp_path, data):
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([data], jobs=1)
    (all_objects,) = rows(tmp_path / "c.db", "SELECT sum(object_count) FROM dictionaries")[0]
    (links,) = rows(tmp_path / "c.db", "SELECT count(*) FROM dictionary_objects")[0]
    assert links == all_objects
    duplicates = "SELECT content_hash FROM objects GROUP BY content_hash HAVING count(*) > 1"
    assert rows(tmp_path / "c.db", duplicates) == []


def test_without_revision_the_latest_visible_one(tmp_path):
    """HideType may hide a numerically higher revision: latest means hidden by no other entry."""
    newest = device("<HideType RevisionNo='#x30'/>", product="#x5", revision="#x20")
    hidden = device(product="#x5", revision="#x30")
    write(tmp_path / "in", {"a.xml": esi(newest + hidden)})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
        assert catalog.device("0xe5c:5").found.revision_no == 0x20
        assert catalog.device("0xe5c:5:0x30").found.revision_no == 0x30


REVISION_30 = device(product="#x5", revision="#x30")


@pytest.mark.parametrize(
    ("others", "hides"),
    [
        (device("<HideType RevisionNo='#x30'/>", product="#x5", revision="#x20"), True),
        (device("<HideType ProductCode='#x5' RevisionNo='#x30'/>", product="#x5", revision="#x20"), True),
        (device("<HideType ProductCode='#x5' RevisionNo='#x30'/>", product="#x6", revision="#x30"), True),
        (device("<HideType ProductCode='#x5' RevisionNo='#x30'/>", product="", type_text="no codes"), True),
        (device("<HideType RevisionNo='#x30'/>", product="#x6", revision="#x20"), False),
        (device("<HideType ProductCode='#x6' RevisionNo='#x30'/>", product="#x5", revision="#x20"), False),
        (device("<HideType ProductCode='#x5'/>", product="#x5", revision="#x20"), False),
        (device("<HideType RevisionNo='#x30'/>", product="", type_text="no codes"), False),
        (device("<HideType RevisionNo='#x30'/>", product="#x5", revision="#x30", name="variant"), False),
    ],
)
def test_a_file_and_the_catalog_agree_on_what_is_hidden(tmp_path, others, hides):
    """Of revision 0x30 and 0x10, which no HideType names, the latest is meant that none hides."""
    text = esi(device(product="#x5", revision="#x10") + REVISION_30 + others)
    other_vendor = esi(
        device("<HideType ProductCode='#x5' RevisionNo='#x10'/>", product="#x9"), vendor="<Id>7</Id><Name>V</Name>"
    )
    write(tmp_path / "in", {"a.xml": text, "b.xml": other_vendor})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
    hidden = rows(tmp_path / "c.db", "SELECT DISTINCT product_code, revision_no FROM devices WHERE hidden")
    assert hidden == ([(5, 0x30)] if hides else [])
    described = subjects_of_document(read(text).document, "a.xml") + subjects_of_document(
        read(other_vendor).document, "b.xml"
    )
    wanted = sorted({item.revision_no for item in described if item.product_code == 5} - ({0x30} if hides else set()))
    chosen = choose_subject(described, Identity(0xE5C, 5, variant=1), "a.xml")
    assert chosen.revision_no == wanted[-1]
