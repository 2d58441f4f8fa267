"""``esicatalog check`` names every kind of damage; each catalog here is damaged in exactly one way."""

import shutil
import sqlite3
import zipfile
from contextlib import closing
from pathlib import Path

import pytest
from snippets import device, esi, rows, write

from esicatalog import Catalog
from esicatalog.catalog import schema
from esicatalog.catalog.check_rows import rules
from esicatalog.catalog.unfinished import CUT_SHORT


def damaged(db: Path, folder: Path, *statements: str) -> list[str]:
    """What check says of a copy after these statements, which SQLite runs without looking at references."""
    copy = Path(shutil.copy(db, folder / "damaged.db"))
    with closing(sqlite3.connect(copy)) as connection:
        for statement in statements:
            assert connection.execute(statement).rowcount != 0, statement
        connection.commit()
    with Catalog.open(copy) as catalog:
        return catalog.check().problems


def test_a_sound_catalog_has_no_problem(data_db, tmp_path):
    assert damaged(data_db, tmp_path) == []


@pytest.mark.corpus
def test_the_catalog_of_the_corpus_is_sound(corpus_db):
    with Catalog.open(corpus_db) as catalog:
        assert catalog.check().problems == []


DAMAGES = {
    "a vendor with another name than documents give it": (
        ["UPDATE vendors SET name = 'Nobody' WHERE vendor_id = 3676"],
        "1 vendors whose names or image are not what their documents say",
    ),
    "a spelling counted wrong": (
        ["UPDATE vendor_names SET document_count = 9 WHERE vendor_id = 3676"],
        "1 vendors whose names or image are not what their documents say",
    ),
    "a maker that no document names": (
        ["UPDATE devices SET own_vendor_name = 'Nobody' WHERE id = 1"],
        "1 devices whose own_vendor_name is not what their documents say",
    ),
    "a row whose owner is gone": (
        ["UPDATE pdo_entries SET pdo_id = 99999 WHERE id = 1"],
        "pdo_entries: row 1 refers to a missing row of pdos",
    ),
    "a device of no document": (
        ["DELETE FROM device_sources WHERE device_id = 1"],
        "1 rows of devices that no document carries",
    ),
    "a module of no document": (
        [
            "INSERT INTO modules (vendor_id, content_hash, element_count) VALUES (3676, 'x', 0)",
        ],
        "1 rows of modules that no document carries",
    ),
    "an object of no dictionary": (
        ["INSERT INTO objects (content_hash, object_code) VALUES (x'00', 7)"],
        "1 rows of objects that nothing refers to",
    ),
    "a dictionary of no profile": (
        ["UPDATE profiles SET dictionary_id = NULL WHERE dictionary_id = (SELECT max(id) FROM dictionaries)"],
        "1 rows of dictionaries that nothing refers to",
    ),
    "an image that nobody shows": (
        ["INSERT INTO images (sha256, data) VALUES ('x', x'00')"],
        "1 rows of images that nothing refers to",
    ),
    "the bytes of an image": (
        ["UPDATE images SET data = x'424D' WHERE sha256 = (SELECT min(sha256) FROM images)"],
        "1 images that are not what their sha256 says: delete the catalog and ingest again",
    ),
    "a name of nobody": (
        ["UPDATE device_names SET device_id = NULL, module_id = NULL WHERE id = 1"],
        "1 rows of device_names that do not belong to exactly one owner",
    ),
    "a value of two owners": (
        [
            "INSERT INTO unmapped (device_id, source_id, position, path, value) VALUES (1, 1, 0, 'a', 'b')",
        ],
        "1 rows of unmapped that do not belong to exactly one owner",
    ),
    "a count of devices": (
        ["UPDATE sources SET device_count = device_count + 1 WHERE id = 1"],
        "1 documents whose device_count is not the number of their devices",
    ),
    "a count of modules": (
        ["UPDATE sources SET module_count = module_count - 1 WHERE module_count > 0"],
        "documents whose module_count is not the number of their modules",
    ),
    "a count of objects": (
        ["UPDATE dictionaries SET object_count = object_count + 1 WHERE id = 1"],
        "1 dictionaries whose object_count is not the number of their objects",
    ),
    "elements of a device": (
        ["UPDATE devices SET element_count = element_count + 1 WHERE id = 1"],
        "1 devices whose element_count is not the number of their objects and PDO entries",
    ),
    "elements of a module": (
        ["UPDATE modules SET element_count = element_count + 1 WHERE id = 1"],
        "1 modules whose element_count is not the number of their objects and PDO entries",
    ),
    "an entry lost in the middle": (
        ["DELETE FROM object_entries WHERE id = (SELECT min(id) FROM object_entries WHERE position = 1)"],
        "1 lists in object_entries whose positions do not run from 0",
    ),
    "a position used twice": (
        ["UPDATE sync_managers SET position = 0 WHERE device_id = 1"],
        "1 lists in sync_managers whose positions do not run from 0",
    ),
    "a lost sync manager": (
        ["DELETE FROM sync_managers WHERE device_id = 1 AND position = 0"],
        "1 lists in sync_managers whose positions do not run from 0",
    ),
    "a variant that starts at 2": (
        ["UPDATE devices SET variant = 2 WHERE id = 1"],
        "1 devices whose variants are not numbered from 1 in the order of preference",
    ),
    "a file version that no document has": (
        ["UPDATE devices SET file_version = 4711 WHERE id = 1"],
        "1 devices whose recovered, file_version or group_type is not what their documents say",
    ),
    "a group that no document names": (
        ["UPDATE devices SET group_type = NULL WHERE id = 1"],
        "1 devices whose recovered, file_version or group_type is not what their documents say",
    ),
    "recovered without cause": (
        ["UPDATE devices SET recovered = 1 WHERE id = 1"],
        "1 devices whose recovered, file_version or group_type is not what their documents say",
    ),
    "hidden without cause": (
        ["UPDATE devices SET hidden = 1 WHERE type = 'L6N'"],
        "1 devices that are hidden although nothing supersedes them, or the other way round",
    ),
    "shown although superseded": (
        ["UPDATE devices SET hidden = 0 WHERE hidden = 1"],
        "1 devices that are hidden although nothing supersedes them, or the other way round",
    ),
    "nothing derived": (["DELETE FROM device_facts WHERE device_id = 1"], "1 devices without device_facts"),
    "a lost index": (["DROP INDEX ix_devices_listed"], "the index ix_devices_listed is missing"),
    "a lost view": (["DROP VIEW device_overview"], "the view device_overview is missing"),
    "a device that search does not find": (
        ["DELETE FROM device_search WHERE rowid = 1"],
        "1 devices that the full-text search does not know, or not as they are: delete the catalog and ingest again",
    ),
    "a device that search finds under another name": (
        ["UPDATE devices SET type = 'another' WHERE id = 1"],
        "1 devices that the full-text search does not know, or not as they are: delete the catalog and ingest again",
    ),
    "a device that search finds by another name": (
        ["UPDATE device_names SET text = 'another' WHERE kind = 'name' AND device_id = 1"],
        "1 devices that the full-text search does not know, or not as they are: delete the catalog and ingest again",
    ),
    "no search": (["DROP TABLE device_search"], "the table device_search is missing"),
    "a device that only search knows": (
        ["INSERT INTO device_search (rowid, type) VALUES (99999, 'ghost')"],
        "1 devices in the full-text search that are not there: delete the catalog and ingest again",
    ),
    "another content": (
        ["UPDATE devices SET content_hash = '0' WHERE id = 1"],
        "is not that of the descriptions: delete the catalog and ingest again",
    ),
    "another document": (
        ["UPDATE sources SET sha256 = '0' WHERE member = 'l6n_drive.xml'"],
        "is not that of the descriptions: delete the catalog and ingest again",
    ),
    "a state hash of something else": (
        ["UPDATE catalog_state SET value = '00' WHERE key = 'state_hash'"],
        "the stored state hash 00 is not that of the sources: delete the catalog and ingest again",
    ),
    "an address of a SyncManager": (
        ["UPDATE sync_managers SET start_address = start_address + 1 WHERE device_id = 1"],
        "1 devices have other values than their documents brought",
    ),
    "a byte of an InitCmd": (
        ["UPDATE initcmds SET data = data || '00' WHERE device_id = 3"],
        "1 devices have other values than their documents brought",
    ),
    "a value of a module": (
        ["UPDATE pdos SET pdo_index = pdo_index + 1 WHERE id = (SELECT min(id) FROM pdos WHERE module_id IS NOT NULL)"],
        "1 modules have other values than their documents brought",
    ),
    "a signal that is not that of the AssignActivate": (
        ["UPDATE dc_modes SET sync1 = 1 - sync1 WHERE id = 1"],
        "1 devices have rows in dc_modes that do not follow from their description",
    ),
    "a place in the process image": (
        ["UPDATE pdo_entries SET image_bit_offset = image_bit_offset + 1 WHERE id = 1"],
        "1 pdos have rows in pdo_entries that do not follow from their description",
    ),
    "a verdict": (
        ["UPDATE drive_modes SET verdict = 'yes' WHERE verdict = 'no'"],
        "devices have rows in drive_modes that do not follow from their description",
    ),
    "a size of the process data": (
        ["UPDATE device_facts SET output_bytes = output_bytes + 1 WHERE device_id = 1"],
        "1 devices have rows in device_facts that do not follow from their description",
    ),
    "the OpMode that counts": (
        ["UPDATE devices SET default_op_mode = 7 WHERE id = 1"],
        "1 devices have rows in devices that do not follow from their description",
    ),
    "a default value of an object's entry": (
        ["UPDATE object_entries SET access = 'xx' WHERE id = 1"],
        "1 objects have rows in object_entries that do not follow from their description",
    ),
    "an FMMU that is gone": (
        ["DELETE FROM fmmus WHERE id = (SELECT max(id) FROM fmmus WHERE device_id = 1)"],
        "1 devices have other values than their documents brought",
    ),
    "an ingest under way": (["DELETE FROM catalog_state WHERE key = 'content_hash'"], CUT_SHORT),
    "a load under way": (["INSERT INTO catalog_state VALUES ('indexes_pending', '1')"], CUT_SHORT),
}


@pytest.mark.parametrize("kind", DAMAGES)
def test_damage_is_named(data_db, tmp_path, kind):
    statements, finding = DAMAGES[kind]
    found = damaged(data_db, tmp_path, *statements)
    assert [line for line in found if finding in line] != [], found


def test_variants_in_the_wrong_order_are_named(tmp_path):
    """The one with more objects and PDO entries is preferred; an identity without codes is told apart by its type."""
    pdo = (
        "<RxPdo><Index>#x1600</Index><Name>p</Name>"
        "<Entry><Index>#x7000</Index><SubIndex>1</SubIndex><BitLen>8</BitLen><Name>e</Name></Entry></RxPdo>"
    )
    folder = write(
        tmp_path / "in",
        {
            "a.xml": esi(device() + device(product="", type_text="END")),
            "b.xml": esi(device(pdo) + device(product="", type_text="CAP")),
        },
    )
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([folder], jobs=1)
        assert catalog.check().problems == []
    assert rows(db, "SELECT variant, element_count FROM devices WHERE type = 'T1' ORDER BY variant") == [(1, 1), (2, 0)]
    assert rows(db, "SELECT variant FROM devices WHERE type <> 'T1'") == [(1,), (1,)]
    found = damaged(
        db,
        tmp_path,
        "UPDATE devices SET variant = -variant WHERE type = 'T1'",
        "UPDATE devices SET variant = 3 + variant WHERE type = 'T1'",
    )
    assert found[0] == "2 devices whose variants are not numbered from 1 in the order of preference"


def test_an_empty_archive_is_no_problem(tmp_path):
    zipfile.ZipFile(tmp_path / "empty.zip", "w").close()
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "empty.zip"], jobs=1)
        assert catalog.check().problems == []


def test_bytes_that_changed_on_the_disk_are_named(data_db, tmp_path):
    """An index page emptied by hand: SQLite's own check finds it."""
    copy = Path(shutil.copy(data_db, tmp_path / "c.db"))
    ((page,),) = rows(copy, "SELECT rootpage FROM sqlite_master WHERE name = 'ix_pdos_device_id'")
    ((size,),) = rows(copy, "PRAGMA page_size")
    content = bytearray(copy.read_bytes())
    content[(page - 1) * size + 3 : (page - 1) * size + 5] = b"\0\0"  # number of cells
    copy.write_bytes(content)
    with Catalog.open(copy) as catalog:
        assert any("ix_pdos_device_id" in line for line in catalog.check().problems)


def test_every_numbered_table_is_looked_at():
    words = [rule.words for rule in rules()]
    numbered = [table.name for table in schema.metadata.sorted_tables if "position" in table.c]
    assert len(numbered) > 20
    for name in numbered:
        assert f"lists in {name} whose positions do not run from 0" in words
