"""What the catalog gives back is what the reader read: ``reader(writer(device)) == device`` for every device."""

import json
from pathlib import Path

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from snippets import device, esi, read, rows, write

from esicatalog import Catalog
from esicatalog.catalog.mapping import TABLE_RECORDS, codec
from esicatalog.catalog.query import ConnectionQuery
from esicatalog.catalog.reader import RecordReader
from esicatalog.esi.binding import Record, fields_of
from esicatalog.esi.containers import Archive, Folder
from esicatalog.esi.reader import Reader
from esicatalog.model.dictionary import resolve_object, type_table


def container_of(location: str, member: str):
    """The container and the member's name in it, from a source's location."""
    if "!" not in location:
        path = Path(location)
        return Folder(path.parents[member.count("/")]), member
    archive_path, *nested, name = location.split("!")
    archive = Archive(Path(archive_path))
    for step in nested:
        archive = Archive(archive.read(step))
    return archive, name


def read_again(db: Path):
    """Every stored document with its record, read anew."""
    reader, held = Reader(), (None, None)
    query = "SELECT id, location, member FROM sources WHERE status IN ('stored', 'recovered') ORDER BY location"
    for source_id, location, member in rows(db, query):
        place = location.rsplit("!", 1)[0] if "!" in location else None
        container, name = container_of(location, member)
        if place is not None and held[0] == place:
            container = held[1]
        held = (place, container)
        yield source_id, reader.read(container.read(name), name, container).document


def differences(db: Path, stride: int = 1) -> tuple[int, list[str]]:
    """Devices and modules compared, and those that differ from the document (each in the document's group)."""
    compared, differing = 0, []
    with Catalog.open(db) as catalog, catalog._connection() as connection:
        records = RecordReader(ConnectionQuery(connection))
        for source_id, document in list(read_again(db)):
            placed = rows(
                db,
                "SELECT section, position, device_id, group_type FROM device_sources WHERE source_id = ?",
                source_id,
            )[::stride]
            stored = records.devices([row[2] for row in placed])
            for (section, position, number, group), found in zip(placed, stored, strict=True):
                compared += 1
                in_group = msgspec.structs.replace(found, group_type=group)
                if in_group != document.infos[section].devices[position]:
                    differing.append(f"device {number} of source {source_id}")
            placed = rows(db, "SELECT section, position, module_id FROM module_sources WHERE source_id = ?", source_id)[
                ::stride
            ]
            stored = records.modules([row[2] for row in placed])
            for (section, position, number), found in zip(placed, stored, strict=True):
                compared += 1
                if found != document.infos[section].modules[position]:
                    differing.append(f"module {number} of source {source_id}")
    return compared, differing


def test_all_of_our_examples(data_db):
    assert differences(data_db) == (4 + 2 + 3 + 4, []), "six devices, seven modules"


def test_a_sample_of_real_archives(sample_db):
    compared, differing = differences(sample_db)
    assert differing == []
    assert compared > 10


@pytest.mark.corpus
def test_all_of_the_corpus(corpus_db):
    compared, differing = differences(corpus_db)
    assert differing == []
    assert compared == 2201 + 556


def test_a_device_in_the_group_of_one_of_its_documents(tmp_path):
    one = esi(device())
    write(tmp_path / "in", {"a.xml": one, "b.xml": one.replace("<GroupType>G<", "<GroupType>H<")})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
    found = rows(tmp_path / "c.db", "SELECT device_id, group_type FROM device_sources ORDER BY group_type")
    assert found == [(1, "G"), (1, "H")], "the group is no part of the content"
    assert differences(tmp_path / "c.db") == (2, [])


def test_referenced_documents_are_kept_with_the_device(tmp_path):
    profile = "<Profile><DictionaryFile>sub\\d.xml</DictionaryFile></Profile>"
    objects = "<Object><Index>#x2000</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    external = f"<EtherCATDict><Dictionary><DataTypes/><Objects>{objects}</Objects></Dictionary></EtherCATDict>"
    write(tmp_path / "in", {"a.xml": esi(device(profile)), "SUB/D.xml": external})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
        (kept,) = catalog.device("0xE5C:1:1").device.profiles
    assert kept.dictionary_file == "sub\\d.xml"
    assert [o.object_index for o in kept.dictionary.objects] == [0x2000]


def scalar_values(item: object):
    """Any value of a field's type."""
    texts = st.text(st.characters(exclude_categories=("Cs",), exclude_characters="\0"), max_size=8)
    by_type = {str: texts, int: st.integers(-(2**63) + 1, 2**63 - 1), bool: st.booleans()}
    return by_type.get(item, st.floats(allow_nan=False, allow_infinity=False))


def records(record_type: type[Record], depth: int = 0):
    """Records of a type with any scalars and short lists of scalars and records."""
    fields = {}
    for field in fields_of(record_type):
        nested = isinstance(field.item, type) and issubclass(field.item, Record)
        if field.name.startswith("image_data") or (nested and (depth > 1 or field.item is record_type)):
            continue
        inner = records(field.item, depth + 1) if nested else scalar_values(field.item)
        fields[field.name] = st.lists(inner, max_size=2).map(tuple) if field.many else inner
    return st.fixed_dictionaries({}, optional=fields).map(lambda values: record_type(**values))


PLAIN_TABLES = sorted(set(TABLE_RECORDS) - {"devices", "modules", "object_entries", "pdos", "profiles", "mailboxes"})


@pytest.mark.parametrize("table", PLAIN_TABLES)
def test_rows_of_any_record_give_it_back(table):
    own = codec(TABLE_RECORDS[table])

    @settings(max_examples=25, deadline=None)
    @given(records(TABLE_RECORDS[table]))
    def check(record):
        values = own.encode(record)
        assert len(values) == len(own.columns)
        left_out = {f.name for f in fields_of(type(record))} - {name for name, _, _ in own._decoders}
        kept = {name: getattr(record, name) for name in left_out}
        assert own.decode(values, **kept) == record
        assert all(value is None or isinstance(value, int | float | str) for value in values)

    check()


def test_json_columns_are_json(data_db):
    for table, record_type in TABLE_RECORDS.items():
        for column in codec(record_type).stored_columns:
            if column.kind == "json":
                for (text,) in rows(data_db, f"SELECT {column.name} FROM {table} WHERE {column.name} IS NOT NULL"):
                    json.loads(text)


def test_object_entries_are_what_the_model_resolves(data_db):
    """The rows of object_entries equal the resolution of the declared dictionaries, in document order."""
    query = (
        "SELECT e.subindex, e.name, e.bit_size, e.access_word, e.default_int FROM profiles p "
        "JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id "
        "JOIN object_entries e ON e.object_id = l.object_id WHERE p.device_id = ? "
        "ORDER BY p.position, l.position, e.position"
    )
    with Catalog.open(data_db) as catalog, catalog._connection() as connection:
        for (number,) in rows(data_db, "SELECT id FROM devices"):
            expected = [
                (e.subindex, e.name, e.bit_size, e.access_word, e.default_int)
                for profile in RecordReader(ConnectionQuery(connection)).device(number).profiles
                if profile.dictionary is not None
                for declared in profile.dictionary.objects
                for e in resolve_object(declared, type_table(profile.dictionary.data_types)).entries
            ]
            assert rows(data_db, query, number) == expected


def test_unmapped_values_come_back(tmp_path):
    text = esi(device("<Odd a='1'>x</Odd><Dc>stray</Dc>"))
    write(tmp_path / "in", {"a.xml": text})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
        assert catalog.device("0xE5C:1:1").device == read(text).document.infos[0].devices[0]
