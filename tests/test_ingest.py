"""Ingest: idempotent, resumable, the same catalog whatever the order, and nothing left of what went."""

import gc
import io
import shutil
import sqlite3
import zipfile
from contextlib import ExitStack
from pathlib import Path

import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from snippets import device, dictionary, esi, one, pdo, rows, write

from esicatalog import Catalog
from esicatalog.catalog import schema
from esicatalog.errors import CatalogError, InputError
from esicatalog.esi import containers

KEPT = {"catalog_state", "alembic_version"}
CONTENT_TABLES = [table.name for table in schema.metadata.sorted_tables if table.name not in KEPT]


SETTINGS = ("cache_size", "foreign_keys", "synchronous")


def ingest(db: Path, *paths: Path, jobs: int = 1, prune: bool = False):
    """Ingest, verify the catalog, and give the report and the content hash."""
    with Catalog.open(db, create=True) as catalog:
        report = catalog.ingest(paths, jobs=jobs, prune=prune)
        result = catalog.check()
    assert result.problems == []
    assert rows(db, "PRAGMA foreign_key_check") == []
    return report, result.content_hash


def statuses(report) -> dict[str, str]:
    return {line.path: line.status for line in report.documents}


def zip_folder(folder: Path, path: Path) -> Path:
    with zipfile.ZipFile(path, "w") as archive:
        for file in sorted(folder.rglob("*.*")):
            archive.write(file, file.relative_to(folder).as_posix())
    return path


def rich(product: str, revision: str = "#x1", value: str = "01") -> str:
    """A device with something in most tables."""
    objects = (
        "<Object><Index>#x2000</Index><Name>O</Name><Type>T</Type><BitSize>8</BitSize>"
        f"<Info><DefaultData>{value}</DefaultData></Info></Object>"
    )
    types = (
        "<DataType><Name>T</Name><BaseType>USINT</BaseType><BitSize>8</BitSize>"
        "<EnumInfo><Text>one</Text><Enum>1</Enum></EnumInfo></DataType>"
        "<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType>"
        "<DataType><Name>R</Name><BitSize>8</BitSize><SubItem><Name>S</Name><Type>USINT</Type><BitSize>8</BitSize>"
        "<BitOffs>0</BitOffs></SubItem></DataType>"
    )
    return device(
        "<HideType RevisionNo='#x9'/>"
        + dictionary(types, objects)
        + "<Profile><ChannelInfo><ProfileNo>402</ProfileNo></ChannelInfo><DiagMessages><DiagMessage><TextId>1</TextId>"
        "<MessageText>m</MessageText></DiagMessage></DiagMessages></Profile><Fmmu>Outputs</Fmmu>"
        "<Sm>Outputs</Sm><Su>u</Su>"
        + pdo("RxPdo", "#x1600", 8, extra="<Exclude>#x1601</Exclude>")
        + "<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>1</Index><SubIndex>0</SubIndex><Data>00</Data>"
        "</InitCmd></CoE></Mailbox><Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>"
        '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot>'
        '<Slot MinInstances="0" MaxInstances="1"><ModuleClass><Class>c</Class></ModuleClass></Slot></Slots>'
        "<Eeprom><ByteSize>2048</ByteSize></Eeprom><ImageData16x14>424D</ImageData16x14>"
        "<VendorSpecific><X/></VendorSpecific><Odd>kept</Odd>",
        product=product,
        revision=revision,
    )


RICH_MODULE = (
    '<Module><Type ModuleIdent="1">M</Type><Name>M</Name>'
    + pdo("RxPdo", "#x1610", 8)
    + "<Odd>kept too</Odd><VendorSpecific><Y/></VendorSpecific></Module>"
)
FULL = esi(rich("#x10"), RICH_MODULE).replace("<Groups>", "<Odd/><Groups>", 1)
REFERRING = esi(device("<Profile><DictionaryFile>d.xml</DictionaryFile></Profile>", product="#x20"))
EXTERNAL = (
    "<EtherCATDict><Dictionary><DataTypes/><Objects><Object><Index>#x2000</Index><Name>{}</Name><Type>UINT</Type>"
    "<BitSize>16</BitSize></Object></Objects></Dictionary></EtherCATDict>"
)


@pytest.fixture
def library(tmp_path) -> Path:
    """Two full documents, one that refers to a dictionary, one ENI file and one that is broken."""
    return write(
        tmp_path / "library",
        {
            "full.xml": FULL,
            "other/full.xml": FULL.replace("#x10", "#x11"),
            "ref.xml": REFERRING,
            "d.xml": EXTERNAL.format("O"),
            "eni.xml": "<EtherCATConfig/>",
            "broken.xml": "",
            "notes.txt": "no ESI",
        },
    )


def test_every_input_is_named_and_one_failure_stops_nothing(tmp_path, library):
    report, _ = ingest(tmp_path / "c.db", library)
    assert statuses(report) == {
        "broken.xml": "failed",
        "d.xml": "stored",
        "eni.xml": "skipped",
        "full.xml": "stored",
        "notes.txt": "skipped",
        "other/full.xml": "stored",
        "ref.xml": "stored",
    }
    assert report.counts == {"stored": 4, "unchanged": 0, "recovered": 0, "skipped": 2, "failed": 1}
    assert one(tmp_path / "c.db", "SELECT message FROM sources WHERE status = 'failed'") == "the file is empty"
    assert (report.devices, report.modules) == (3, 2)


def test_a_failed_document_stays_named(tmp_path, library):
    ingest(tmp_path / "c.db", library)
    again, _ = ingest(tmp_path / "c.db", library)
    assert statuses(again)["broken.xml"] == "failed"
    write(library, {"broken.xml": FULL.replace("#x10", "#x12")})
    repaired, _ = ingest(tmp_path / "c.db", library)
    assert statuses(repaired)["broken.xml"] == "stored"


def test_ingesting_twice_changes_nothing(tmp_path, library):
    _, first = ingest(tmp_path / "c.db", library)
    before = counts(tmp_path / "c.db")
    report, second = ingest(tmp_path / "c.db", library)
    assert report.counts["stored"] == 0
    assert report.counts["unchanged"] == 4
    assert second == first
    assert counts(tmp_path / "c.db") == before


def counts(db: Path) -> dict[str, int]:
    """How many rows each table has."""
    parts = " UNION ALL ".join(f"SELECT '{table}', count(*) FROM {table}" for table in CONTENT_TABLES)
    return dict(rows(db, parts))


def test_a_finished_ingest_is_one_file(tmp_path, library):
    (tmp_path / "db").mkdir()
    for _ in range(2):
        ingest(tmp_path / "db" / "c.db", library)
        assert [path.name for path in (tmp_path / "db").iterdir()] == ["c.db"]
        assert one(tmp_path / "db" / "c.db", "PRAGMA journal_mode") == "delete"
        write(library, {"new.xml": FULL.replace("#x10", "#x13")})


def test_an_ingest_leaves_nothing_on_the_connections_of_a_catalog(tmp_path, library):
    """Neither temporary tables nor the settings of a load."""
    with Catalog.open(tmp_path / "catalog.db", create=True) as catalog:
        for product in ("#x4711", "#x4712"):
            write(library, {f"{product}.xml": esi(rich(product))})
            catalog.ingest([library], jobs=1)
            with ExitStack() as stack:
                connections = [stack.enter_context(catalog._connection()) for _ in range(5)]
                states = {
                    tuple(held.exec_driver_sql(f"PRAGMA {name}").scalar() for name in SETTINGS) for held in connections
                }
                tables = [held.exec_driver_sql("SELECT name FROM sqlite_temp_master").all() for held in connections]
            assert tables == [[]] * 5
            assert states == {(-2000, 1, 2)}  # of SQLite itself, but for the foreign keys


def test_any_order_and_any_number_of_workers_give_the_same_catalog(tmp_path, library):
    parts = [library / name for name in ("full.xml", "other", "ref.xml", "d.xml")]
    seen = {
        ingest(tmp_path / "a.db", *parts)[1],
        ingest(tmp_path / "b.db", *reversed(parts))[1],
        ingest(tmp_path / "c.db", *parts, jobs=2)[1],
    }
    for part in reversed(parts):
        _, last = ingest(tmp_path / "d.db", part)
    assert seen == {last}


@pytest.mark.corpus
def test_any_order_of_real_archives_gives_the_same_catalog(tmp_path, corpus):
    archives = sorted((corpus / "esi").glob("*.zip"), key=lambda path: path.stat().st_size)[:-1]
    one_way = ingest(tmp_path / "a.db", *archives, jobs=2)[1]
    assert ingest(tmp_path / "b.db", *reversed(archives), jobs=1)[1] == one_way


def test_the_sample_with_one_and_two_workers(tmp_path, sample_archives):
    first = ingest(tmp_path / "a.db", *sample_archives, jobs=1)[1]
    assert ingest(tmp_path / "b.db", *reversed(sample_archives), jobs=2)[1] == first


def test_a_changed_document_replaces_what_it_brought(tmp_path):
    folder = write(tmp_path / "in", {"a.xml": esi(rich("#x1") + rich("#x1", value="02"))})
    ingest(tmp_path / "c.db", folder)
    assert rows(tmp_path / "c.db", "SELECT variant FROM devices ORDER BY variant") == [(1,), (2,)]
    assert one(tmp_path / "c.db", "SELECT count(*) FROM unmapped") == 2
    write(folder, {"a.xml": esi(device(product="#x1", name="New"))})
    report, changed = ingest(tmp_path / "c.db", folder)
    assert statuses(report) == {"a.xml": "stored"}
    assert rows(tmp_path / "c.db", "SELECT name, variant FROM devices") == [("New", 1)]
    assert one(tmp_path / "c.db", "SELECT count(*) FROM unmapped") == 0
    assert one(tmp_path / "c.db", "SELECT count(*) FROM findings") == 0
    assert changed == ingest(tmp_path / "fresh.db", folder)[1]


def test_a_changed_dictionary_file_changes_what_refers_to_it(tmp_path, library):
    ingest(tmp_path / "c.db", library)
    write(library, {"d.xml": EXTERNAL.format("Another")})
    report, _ = ingest(tmp_path / "c.db", library)
    assert statuses(report)["ref.xml"] == "stored"
    assert statuses(report)["full.xml"] == "unchanged"
    query = "SELECT name FROM device_objects WHERE product_code = 32"
    assert rows(tmp_path / "c.db", query) == [("Another",)]
    (library / "d.xml").unlink()
    assert statuses(ingest(tmp_path / "c.db", library)[0])["ref.xml"] == "stored"
    assert rows(tmp_path / "c.db", query) == []


def module(ident: str, content: str = "") -> str:
    return f'<Module><Type ModuleIdent="{ident}">M{ident}</Type><Name>M</Name>{content}</Module>'


def module_document(*modules: str, vendor: str = "#xE5C", head: str = "") -> str:
    """An EtherCATModule document."""
    return (
        f"<EtherCATModule>{head}<Vendor><Id>{vendor}</Id><Name>Modules</Name></Vendor>"
        f"<Modules>{''.join(modules)}</Modules></EtherCATModule>"
    )


def carrier(*references: str) -> str:
    """A document with a device whose slot takes module 0x10, which one of the references brings."""
    slots = "<Slots><Slot MinInstances='1' MaxInstances='1'><ModuleIdent Default='1'>#x10</ModuleIdent></Slot></Slots>"
    named = "".join(f"<InfoReference>{text}</InfoReference>" for text in references)
    return esi(device(slots)).replace("<EtherCATInfo>", f"<EtherCATInfo>{named}", 1)


MODULES = "SELECT vendor_id, module_ident FROM modules ORDER BY 1, 2"


def test_of_referenced_modules_only_those_are_stored_that_a_device_carries(tmp_path):
    """Their own document need not be ingested."""
    folder = write(
        tmp_path / "in", {"dev.xml": carrier("mods.xml"), "mods.xml": module_document(module("#x10"), module("#x99"))}
    )
    ingest(tmp_path / "c.db", folder / "dev.xml")
    assert rows(tmp_path / "c.db", MODULES) == [(0xE5C, 0x10)]
    ingest(tmp_path / "c.db", folder)
    assert rows(tmp_path / "c.db", MODULES) == [(0xE5C, 0x10), (0xE5C, 0x99)]
    (folder / "mods.xml").unlink()
    ingest(tmp_path / "c.db", folder, prune=True)
    assert rows(tmp_path / "c.db", MODULES) == []


def test_a_referenced_module_is_of_the_vendor_of_its_own_document(tmp_path):
    folder = write(
        tmp_path / "in", {"dev.xml": carrier("mods.xml"), "mods.xml": module_document(module("#x10"), vendor="#x2")}
    )
    hashes = {ingest(tmp_path / f"{number}.db", *paths)[1] for number, paths in enumerate(([folder], [folder] * 2))}
    assert rows(tmp_path / "0.db", MODULES) == [(2, 0x10)]
    assert rows(tmp_path / "0.db", "SELECT vendor_id FROM devices") == [(0xE5C,)]
    ingest(tmp_path / "2.db", folder / "mods.xml")
    assert ingest(tmp_path / "2.db", folder)[1] in hashes
    with Catalog.open(tmp_path / "0.db") as catalog:
        assert [held.module_ident for held in catalog.device("0xE5C:1:1").modules] == [0x10]


def test_a_module_class_is_of_the_vendor_that_it_names_else_of_that_of_the_device(tmp_path):
    """ModuleClass/VendorId; both modules have the class, each of another vendor."""

    def taking(product: str, vendor: str) -> str:
        wanted = f"<ModuleClass><Class>io</Class>{vendor}</ModuleClass>"
        return device(f"<Slots><Slot MinInstances='0' MaxInstances='4'>{wanted}</Slot></Slots>", product)

    own, foreign = (module(ident).replace("<Type ", "<Type ModuleClass='io' ") for ident in ("#x31", "#x77"))
    devices = (taking("#x1", "<VendorId>#x9999</VendorId>"), taking("#x2", ""), taking("#x3", "<VendorId>1</VendorId>"))
    dev = esi("".join(devices), own).replace("<EtherCATInfo>", "<EtherCATInfo><InfoReference>mods.xml</InfoReference>")
    folder = write(tmp_path / "in", {"dev.xml": dev, "mods.xml": module_document(foreign, vendor="#x9999")})
    ingest(tmp_path / "c.db", folder)
    assert rows(
        tmp_path / "c.db",
        "SELECT d.product_code, m.vendor_id, m.module_ident FROM device_modules c "
        "JOIN devices d ON d.id = c.device_id JOIN modules m ON m.id = c.module_id ORDER BY 1",
    ) == [(1, 0x9999, 0x77), (2, 0xE5C, 0x31)]


def test_where_no_vendor_is_known_the_class_counts_alone(tmp_path):
    slots = "<Slots><Slot MinInstances='0' MaxInstances='4'><ModuleClass><Class>io</Class></ModuleClass></Slot></Slots>"
    offered = module("#x31").replace("<Type ", "<Type ModuleClass='io' ")
    folder = write(tmp_path / "in", {"dev.xml": esi(device(slots), offered, vendor="<Name>V</Name>")})
    ingest(tmp_path / "c.db", folder)
    assert one(tmp_path / "c.db", "SELECT count(*) FROM device_modules") == 1


WITH_DICTIONARY = module("#x10", "<Profile><DictionaryFile>{}</DictionaryFile></Profile>")
CARRIED = (
    "SELECT o.name FROM device_modules d JOIN profiles p ON p.module_id = d.module_id "
    "JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id JOIN objects o ON o.id = l.object_id"
)
"""Names of the objects of the modules that devices carry."""


@pytest.mark.parametrize(
    ("reference", "place"), [("mods.xml", "."), ("modules\\MODS.xml", "modules"), ("../mods.xml", "..")]
)
def test_a_referenced_module_has_the_dictionary_beside_its_own_document(tmp_path, reference, place):
    folder = tmp_path / "in"
    dev = folder / "a" / "dev.xml"
    beside = dev.parent / place
    write(folder, {"a/dev.xml": carrier(reference)})
    write(beside, {"mods.xml": module_document(WITH_DICTIONARY.format("d.xml")), "d.xml": EXTERNAL.format("O")})
    ingest(tmp_path / "c.db", folder)
    assert rows(tmp_path / "c.db", MODULES) == [(0xE5C, 0x10)]
    assert rows(tmp_path / "c.db", CARRIED) == [("O",)]
    assert rows(tmp_path / "c.db", "SELECT rule FROM findings WHERE rule = 'L60'") == []
    write(beside, {"d.xml": EXTERNAL.format("Another")})
    report, changed = ingest(tmp_path / "c.db", folder)
    assert set(statuses(report).values()) == {"stored"}
    assert rows(tmp_path / "c.db", CARRIED) == [("Another",)]
    assert changed == ingest(tmp_path / "fresh.db", folder)[1]
    assert set(statuses(ingest(tmp_path / "c.db", folder)[0]).values()) == {"unchanged"}


def test_equal_documents_of_modules_have_the_dictionaries_of_their_own_places(tmp_path):
    folder = tmp_path / "in"
    for name in ("a", "b"):
        write(
            folder / name,
            {
                "dev.xml": carrier("mods.xml"),
                "mods.xml": module_document(WITH_DICTIONARY.format("d.xml")),
                "d.xml": EXTERNAL.format(name),
            },
        )
    zip_folder(folder / "b", folder / "b.zip")
    shutil.rmtree(folder / "b")
    ingest(tmp_path / "c.db", folder)
    assert sorted(rows(tmp_path / "c.db", CARRIED)) == [("a",), ("b",)]


def test_documents_of_modules_that_refer_to_each_other_and_to_themselves_end(tmp_path):
    circle = "<InfoReference>other.xml</InfoReference><InfoReference>mods.xml</InfoReference>"
    mods = module_document(WITH_DICTIONARY.format("mods.xml"), head=circle)
    files = {"mods.xml": mods, "other.xml": esi(device()).replace("<Vendor>", circle + "<Vendor>", 1)}
    folder = write(tmp_path / "in", {"dev.xml": carrier("mods.xml", "dev.xml", "other.xml"), **files})
    report, first = ingest(tmp_path / "c.db", folder)
    assert set(statuses(report).values()) == {"stored"}
    assert ingest(tmp_path / "d.db", *sorted(folder.iterdir(), reverse=True))[1] == first


def test_a_removed_file_goes_with_prune_only(tmp_path, library):
    ingest(tmp_path / "c.db", library)
    (library / "full.xml").unlink()
    ingest(tmp_path / "c.db", library)
    assert one(tmp_path / "c.db", "SELECT count(*) FROM devices WHERE product_code = 16") == 1
    report, _ = ingest(tmp_path / "c.db", library, prune=True)
    assert one(tmp_path / "c.db", "SELECT count(*) FROM devices WHERE product_code = 16") == 0
    assert [tuple(line) for line in report.documents if line.status == "removed"] == [
        ("full.xml", "removed", "no longer among the documents; it described 1 device and 1 module", 1, 1)
    ]


def test_a_catalog_that_is_emptied_says_so(tmp_path):
    folder = write(tmp_path / "in", {"a.xml": esi(device()), "b.xml": esi(device(product="#x2")), "n.xml": "<n/>"})
    ingest(tmp_path / "c.db", folder)
    for path in folder.iterdir():
        path.unlink()
    report, _ = ingest(tmp_path / "c.db", folder, prune=True)
    assert statuses(report) == {"a.xml": "removed", "b.xml": "removed"}, "n.xml had nothing in the catalog"
    assert report.removed == 2
    assert (report.devices, report.modules) == (0, 0), "the catalog now holds none"


def test_prune_does_not_reach_beyond_the_given_folders(tmp_path, library):
    other = shutil.copytree(library, tmp_path / "library2")
    ingest(tmp_path / "c.db", library, other)
    shutil.rmtree(other)
    ingest(tmp_path / "c.db", library, prune=True)
    assert one(tmp_path / "c.db", "SELECT count(*) FROM sources") == 14


def test_an_unchanged_archive_is_skipped_and_a_changed_one_replaced(tmp_path, library):
    archive = zip_folder(library, tmp_path / "a.zip")
    first, _ = ingest(tmp_path / "c.db", archive)
    assert statuses(first)["a.zip!other/full.xml"] == "stored"
    again, _ = ingest(tmp_path / "c.db", archive)
    assert again.counts["unchanged"] == 4
    (library / "other" / "full.xml").unlink()
    zip_folder(library, tmp_path / "a.zip")
    third, shrunk = ingest(tmp_path / "c.db", archive)
    assert statuses(third)["a.zip!other/full.xml"] == "removed"
    assert one(tmp_path / "c.db", "SELECT count(*) FROM devices WHERE product_code = 17") == 0
    assert ingest(tmp_path / "fresh.db", archive)[1] == shrunk


def test_archives_inside_archives(tmp_path, library):
    with zipfile.ZipFile(tmp_path / "outer.zip", "w") as outer:
        outer.write(zip_folder(library, tmp_path / "inner.zip"), "deep/inner.zip")
    report, _ = ingest(tmp_path / "c.db", tmp_path / "outer.zip")
    assert statuses(report)["outer.zip!deep/inner.zip!full.xml"] == "stored"
    assert one(tmp_path / "c.db", "SELECT count(*) FROM device_objects WHERE product_code = 32") == 1


def test_archives_that_cannot_be_used_are_named(tmp_path, library, monkeypatch):
    write(library, {"bad.zip": b"PK\x03\x04nothing"})
    zip_folder(tmp_path / "library" / "other", library / "good.zip")
    monkeypatch.setattr(containers, "MAX_MEMBERS", 0)
    report, _ = ingest(tmp_path / "c.db", library)
    assert statuses(report)["bad.zip"] == "failed"
    assert statuses(report)["good.zip"] == "failed"
    assert statuses(report)["full.xml"] == "stored"


def test_nothing_is_left_when_everything_is_removed(tmp_path, library):
    zip_folder(library, library / "again.zip")
    ingest(tmp_path / "c.db", library)
    empty = {table for table, count in counts(tmp_path / "c.db").items() if not count}
    assert empty <= {"drive_modes", "drive_mode_evidence"}, "the documents fill every table"
    shutil.rmtree(library)
    library.mkdir()
    ingest(tmp_path / "c.db", library, prune=True)
    assert set(counts(tmp_path / "c.db").values()) == {0}
    assert one(tmp_path / "c.db", "SELECT count(*) FROM device_search") == 0


def test_a_catalog_that_was_emptied_fills_again(tmp_path, library):
    _, first = ingest(tmp_path / "c.db", library)
    moved = library.rename(tmp_path / "away")
    library.mkdir()
    ingest(tmp_path / "c.db", library, prune=True)
    shutil.copytree(moved, library, dirs_exist_ok=True)
    journals = set()
    with Catalog.open(tmp_path / "c.db") as catalog:
        catalog.ingest([library], 1, progress=lambda *done: journals.add(one(tmp_path / "c.db", "PRAGMA journal_mode")))
    assert journals == {"wal"}, "whoever has it open goes on reading"
    assert ingest(tmp_path / "c.db", library, prune=True)[1] == first


def test_an_archive_that_was_removed_and_comes_back_is_read_again(tmp_path, library):
    folder = write(tmp_path / "in", {"a.xml": FULL})
    archive = zip_folder(library, folder / "a.zip")
    _, first = ingest(tmp_path / "c.db", folder)
    archive.rename(tmp_path / "away.zip")
    ingest(tmp_path / "c.db", folder, prune=True)
    (tmp_path / "away.zip").rename(archive)
    assert ingest(tmp_path / "c.db", folder, prune=True)[1] == first


def test_overlapping_paths_in_any_order(tmp_path, library):
    first = ingest(tmp_path / "a.db", library, library / "other")[1]
    assert ingest(tmp_path / "b.db", library / "other", library)[1] == first


def test_an_archive_keeps_the_path_that_it_has_below_an_outer_folder(tmp_path, library):
    outer, db = tmp_path / "outer", tmp_path / "c.db"
    (outer / "in!ner").mkdir(parents=True)
    archive = zip_folder(library, outer / "in!ner" / "a.zip")
    named = {f"in!ner/{path}" for path in statuses(ingest(db, archive)[0])}
    assert set(statuses(ingest(db, outer)[0])) == named
    for inner in (archive, archive.parent):
        again = statuses(ingest(db, inner)[0])
        assert set(again) == named and "stored" not in again.values()
    zip_folder(library / "other", archive)
    changed = statuses(ingest(db, archive)[0])
    assert all(path.startswith("in!ner/a.zip!") for path in changed) and "stored" in changed.values()


def test_what_an_outer_folder_resolved_stays_when_an_inner_one_is_read_again(tmp_path):
    profile = r"<Profile><DictionaryFile>..\dict.xml</DictionaryFile></Profile>"
    outer = write(tmp_path / "outer", {"dict.xml": EXTERNAL.format("O"), "inner/dev.xml": esi(device(profile))})
    db = tmp_path / "c.db"
    indices = "SELECT object_index FROM device_objects"
    _, first = ingest(db, outer)
    for inner in (outer / "inner", outer / "inner" / "dev.xml"):
        report, content = ingest(db, inner)
        assert (statuses(report), content) == ({"inner/dev.xml": "unchanged"}, first)
    write(outer, {"inner/dev.xml": esi(device(profile, name="another"))})
    assert statuses(ingest(db, outer / "inner")[0]) == {"inner/dev.xml": "stored"}
    assert rows(db, indices) == [(0x2000,)]
    write(outer, {"dict.xml": EXTERNAL.format("O").replace("#x2000", "#x2001")})
    assert statuses(ingest(db, outer / "inner")[0]) == {"inner/dev.xml": "stored"}
    assert rows(db, indices) == [(0x2001,)]
    (outer / "dict.xml").unlink()
    assert statuses(ingest(db, outer / "inner")[0]) == {"inner/dev.xml": "stored"}
    assert rows(db, indices) == []
    assert rows(db, "SELECT message FROM findings WHERE rule = 'L60'") != []


def test_an_archive_that_was_ingested_alone_is_named_as_in_its_folder(tmp_path, library):
    """A member's path is part of the content hash."""
    archive = zip_folder(library / "other", library / "other" / "a.zip")
    ingest(tmp_path / "a.db", archive)
    report, first = ingest(tmp_path / "a.db", library)
    assert statuses(report)["other/a.zip!full.xml"] == "stored"
    assert statuses(ingest(tmp_path / "a.db", library)[0])["other/a.zip!full.xml"] == "unchanged"
    assert ingest(tmp_path / "b.db", library)[1] == first


def test_an_archive_without_files_has_its_line_until_it_holds_some(tmp_path):
    folder = tmp_path / "in"
    folder.mkdir()
    (folder / "a.zip").write_bytes(b"PK\x03\x04")
    assert statuses(ingest(tmp_path / "c.db", folder)[0]) == {"a.zip": "failed"}
    zipfile.ZipFile(folder / "a.zip", "w").close()
    for _ in range(2):
        assert statuses(ingest(tmp_path / "c.db", folder)[0]) == {"a.zip": "skipped"}
        assert rows(tmp_path / "c.db", "SELECT status, message FROM sources") == [
            ("skipped", "an archive without files")
        ]
    with zipfile.ZipFile(folder / "a.zip", "w") as archive:
        archive.writestr("inner.zip", b"PK\x05\x06" + bytes(18))
        archive.writestr("a.xml", esi(device()))
    assert statuses(ingest(tmp_path / "c.db", folder)[0]) == {"a.zip!a.xml": "stored", "a.zip!inner.zip": "skipped"}


@pytest.mark.parametrize("order", [("x.zip", "x.zip!a.xml"), ("x.zip!a.xml", "x.zip")])
def test_a_file_called_like_a_member_does_not_take_its_place(tmp_path, order):
    folder = tmp_path / "in"
    folder.mkdir()
    for name in order:
        if name == "x.zip":
            with zipfile.ZipFile(folder / name, "w") as archive:
                archive.writestr("a.xml", esi(device()))
        else:
            write(folder, {name: esi(device(product="#x2"))})
        ingest(tmp_path / "c.db", folder)
    expected = {"x.zip!a.xml": "unchanged", "x.zip!a.xml (again)": "failed"}
    assert statuses(ingest(tmp_path / "c.db", folder)[0]) == expected
    assert rows(tmp_path / "c.db", "SELECT product_code FROM devices") == [(1,)]
    (folder / "x.zip").unlink()
    assert statuses(ingest(tmp_path / "c.db", folder, prune=True)[0]) == {"x.zip!a.xml": "stored"}
    assert rows(tmp_path / "c.db", "SELECT product_code FROM devices") == [(2,)]


@pytest.mark.parametrize("kind", [str, Path])
def test_one_path_is_one_path(tmp_path, monkeypatch, kind):
    """The characters of ``../..`` are the folder that one is in, the root and so on."""
    write(tmp_path / "in", {"a.xml": esi(device())})
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        assert statuses(catalog.ingest(kind("../in"), jobs=1)) == {"a.xml": "stored"}


def test_a_missing_path_is_an_error(tmp_path):
    with Catalog.open(tmp_path / "c.db", create=True) as catalog, pytest.raises(InputError, match=r"gone"):
        catalog.ingest([tmp_path / "gone"])


def test_a_missing_path_leaves_the_catalog_as_it_is(tmp_path, library):
    db = tmp_path / "c.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([library], jobs=1)
    before = db.read_bytes()
    with Catalog.open(db) as catalog, pytest.raises(InputError):
        catalog.ingest([library, tmp_path / "no-such-folder"])
    assert db.read_bytes() == before


def archived(**members: str | bytes) -> bytes:
    """An archive of XML documents and, where they are bytes, of archives."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name, content in members.items():
            archive.writestr(f"{name}.{'zip' if isinstance(content, bytes) else 'xml'}", content)
    return stream.getvalue()


DICTIONARIES = [EXTERNAL.format(name) for name in ("O", "Another")]
CONTENTS = [
    *(esi(content, RICH_MODULE) for content in (rich("#x1", value="01"), rich("#x1", value="02"), rich("#x2"))),
    REFERRING,
    carrier("a.xml"),
    module_document(WITH_DICTIONARY.format("d.xml")),
    *DICTIONARIES,
    "<EtherCATInfo>",
]
ARCHIVES = [archived(a=REFERRING, d=text, more=archived(b=REFERRING, d=DICTIONARIES[0])) for text in DICTIONARIES]
PLACES = ["r/a.xml", "r/A.xml", "r/b.xml", "r/d.xml", "s/a.xml", "s/D.XML", "s/z.zip"]
STEPS = st.lists(
    st.tuples(st.sampled_from(PLACES), st.sampled_from([None, *CONTENTS, *ARCHIVES])), min_size=1, max_size=8
)


@settings(max_examples=3, deadline=None, phases=[Phase.explicit, Phase.generate])
@given(STEPS)
def test_any_history_equals_a_fresh_ingest(tmp_path_factory, steps):
    """None: what is there is removed."""
    tmp_path = tmp_path_factory.mktemp("history")
    folder = tmp_path / "in"
    roots = [folder / "r", folder / "s"]
    for root in roots:
        root.mkdir(parents=True)
    for name, content in steps:
        if content is None:
            (folder / name).unlink(missing_ok=True)
        else:
            write(folder, {name: content})
        _, last = ingest(tmp_path / "c.db", *roots, prune=True)
    assert ingest(tmp_path / "fresh.db", *roots)[1] == last
    assert counts(tmp_path / "c.db") == counts(tmp_path / "fresh.db")


def test_a_load_that_left_broken_references_is_not_finished(tmp_path):
    """Its indexes are built beside the check of its references: neither stays when that finds something."""
    db = tmp_path / "c.db"
    ingest(db, write(tmp_path / "a", {"a.xml": esi(rich("#x1"))}))
    with sqlite3.connect(db) as connection:
        connection.execute("INSERT INTO catalog_state VALUES ('indexes_pending', '1')")
        connection.execute("DROP INDEX ix_pdo_entries_pdo_id")
        connection.execute("UPDATE pdo_entries SET pdo_id = 4711")
    with Catalog.open(db) as catalog, pytest.raises(CatalogError, match="rows of pdo_entries refer to rows of pdos"):
        catalog.ingest([write(tmp_path / "b", {"b.xml": esi(rich("#x2"))})], jobs=1)
    assert one(db, "SELECT value FROM catalog_state WHERE key = 'indexes_pending'") == "1"
    assert one(db, "SELECT count(*) FROM sqlite_master WHERE name = 'ix_pdo_entries_pdo_id'") == 0
    assert one(db, "PRAGMA journal_mode") == "delete"


def test_a_new_catalog_is_indexed_before_the_last_documents_come(tmp_path):
    """These are still being read then; what comes after the last one is done by one core alone."""
    db, pending = tmp_path / "c.db", []

    def look(*_):
        pending.append(one(db, "SELECT count(*) FROM catalog_state WHERE key = 'indexes_pending'"))

    folder = write(tmp_path / "in", {f"{number}.xml": esi(rich(f"#x{number}")) for number in range(20)})
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([folder], jobs=1, progress=look)
    assert pending == [1] * 16 + [0] * 4
    assert one(db, "SELECT count(*) FROM sqlite_master WHERE name = 'ix_objects_object_index'") == 1


def test_what_an_ingest_leaves_is_not_old_at_once(tmp_path):
    """Nobody would look at it again: a process that ingests again and again would grow each time."""
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        for name in ("first", "second"):
            folder = write(tmp_path / "in", {"a.xml": esi(device(name=name))})
            gc.collect()
            before = len(gc.get_objects(generation=2))
            catalog.ingest([folder], jobs=1)
        assert len(gc.get_objects(generation=2)) - before < 500
