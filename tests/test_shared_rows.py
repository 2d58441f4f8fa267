"""Rows that many parents share: numbered by who makes them, put in place by who stores them."""

import msgspec
import pytest
import sqlalchemy as sa
from snippets import device, dictionary, esi, one, pdo, read, rows, write

from esicatalog import Catalog
from esicatalog.catalog import database, schema, shared
from esicatalog.catalog.bulk import RowBuffer
from esicatalog.catalog.derived import PdoPlaces
from esicatalog.catalog.load import finish_load
from esicatalog.catalog.owned import OwnedRowMaker
from esicatalog.catalog.rows import DocumentRows, RowMaker
from esicatalog.catalog.shared import NewlyShared, Sharing
from esicatalog.catalog.writer import SourceRow, Writer
from esicatalog.model.dictionary import ObjectEntry, resolve_object
from esicatalog.model.resolver import Resolver

TYPES = (
    "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
    "<DataType><Name>DT2000</Name><BitSize>48</BitSize>"
    "<SubItem><SubIdx>0</SubIdx><Name>Count</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>0</BitOffs></SubItem>"
    "<SubItem><SubIdx>1</SubIdx><Name>First</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>16</BitOffs></SubItem>"
    "<SubItem><SubIdx>2</SubIdx><Name>Second</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>32</BitOffs>"
    "</SubItem></DataType>"
)


def record_object(index: str, first: str = "0500") -> str:
    values = "".join(
        f"<SubItem><Name>{name}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>"
        for name, data in (("Count", "0200"), ("First", first), ("Second", "0700"))
    )
    return (
        f"<Object><Index>{index}</Index><Name>O</Name><Type>DT2000</Type><BitSize>48</BitSize>"
        f"<Info>{values}</Info></Object>"
    )


def drive(*objects: str, product: str = "#x1") -> str:
    sync_manager = '<Sm DefaultSize="4" StartAddress="#x1000" ControlByte="#x64" Enable="1">Outputs</Sm>'
    pdos = pdo("RxPdo", "#x1600", 16, 8, attributes='Sm="0"') + pdo("RxPdo", "#x1601", 16, attributes='Sm="0"')
    return device(dictionary(TYPES, "".join(objects)) + sync_manager + pdos, product=product)


def stored(path, documents: list[tuple[RowMaker, str]]):
    """A catalog of documents, each turned into rows by its maker."""
    engine = database.open_catalog(path, create=True)
    with engine.connect() as connection:
        writer = Writer(connection, "test")
        for number, (maker, text) in enumerate(documents):
            content = read(text)
            made = maker.document(content, content.findings)
            sent = msgspec.msgpack.decode(msgspec.msgpack.encode(made), type=DocumentRows)
            writer.store(SourceRow(f"/{number}", f"{number}", "stored", sha256=f"{number}"), sent)
        writer.commit()
        finish_load(connection, changed=True)
    engine.dispose()
    return path


ENTRIES = """SELECT object_index, e.position, subindex, e.name, default_int FROM object_entries e
    JOIN objects o ON o.id = e.object_id ORDER BY object_index, default_int IS NULL, e.position, default_int"""
PLACES = """SELECT product_code, pdo_index, e.position, bit_length, image_bit_offset FROM pdo_entries e
    JOIN pdos p ON p.id = e.pdo_id JOIN devices d ON d.id = p.device_id
    ORDER BY product_code, pdo_index, e.position"""


def test_a_row_is_told_once_and_has_its_number_from_then_on():
    sharing = Sharing()
    first = sharing.begin()
    assert sharing.rows("pdo_entries", [("a",), ("b",), ("a",)]) == "[0,1,0]"
    assert sharing.rows("sub_items", [("a",)]) == "[0]"
    second = sharing.begin()
    assert sharing.rows("pdo_entries", [("b",), ("c",)]) == "[1,2]"
    assert sharing.digests([b"x", b"y", b"x"]) == [0, 1, 0]
    assert (first.starts_anew, first.rows, first.digests) == (
        True,
        {"pdo_entries": [("a",), ("b",)], "sub_items": [("a",)]},
        [],
    )
    assert (second.starts_anew, second.rows, second.digests) == (
        False,
        {"pdo_entries": [("c",)], "sub_items": []},
        [b"x", b"y"],
    )
    assert first.maker == second.maker != Sharing().begin().maker


def test_entries_stand_in_document_order_with_their_own_places(tmp_path):
    maker = RowMaker()
    text = esi(drive(record_object("#x2000"), record_object("#x2001", first="0600")))
    db = stored(tmp_path / "c.db", [(maker, text)])
    assert rows(db, ENTRIES) == [
        (0x2000, 0, 0, "Count", 2),
        (0x2000, 1, 1, "First", 5),
        (0x2000, 2, 2, "Second", 7),
        (0x2001, 0, 0, "Count", 2),
        (0x2001, 1, 1, "First", 6),
        (0x2001, 2, 2, "Second", 7),
    ]
    assert rows(db, PLACES) == [(1, 0x1600, 0, 16, 0), (1, 0x1600, 1, 8, 16), (1, 0x1601, 0, 16, 24)]


def test_what_was_handed_over_is_not_handed_over_again():
    maker = RowMaker()
    for product in ("#x1", "#x2"):
        content = read(esi(drive(record_object("#x2000"), product=product)))
        made = maker.document(content, content.findings)
    assert [len(new) for new in (made.new_devices, made.new_objects, made.new_types)] == [1, 0, 0]
    assert not any(made.shared.rows.values())


@pytest.mark.parametrize("most_held", [100_000, 3])
def test_makers_do_not_disturb_each_other(tmp_path, monkeypatch, most_held):
    monkeypatch.setattr(shared, "_MOST_HELD", most_held)
    texts = [
        esi(drive(record_object(f"#x{0x2000 + number % 3:X}", first=f"0{number}00"), product=f"#x{number}"))
        for number in range(1, 9)
    ]
    one_maker, two = RowMaker(), (RowMaker(), RowMaker())
    alone = stored(tmp_path / "alone.db", [(one_maker, text) for text in texts])
    mixed = stored(tmp_path / "mixed.db", [(two[number % 2], text) for number, text in enumerate(texts)])
    for query in (ENTRIES, PLACES):
        assert rows(alone, query) == rows(mixed, query)
    assert one(alone, "SELECT count(*) FROM object_entries") == 24
    with Catalog.open(mixed) as catalog:
        assert catalog.check().problems == []


def test_a_document_that_could_not_be_turned_into_rows_leaves_nothing_out_of_the_next(tmp_path, monkeypatch):
    maker, text = RowMaker(), esi(drive(record_object("#x2000")))
    with monkeypatch.context() as broken:
        broken.setattr(RowMaker, "_device", lambda *_: maker._digests.nothing)
        with pytest.raises(AttributeError):
            stored(tmp_path / "broken.db", [(maker, text)])
    content = read(text)
    made = maker.document(content, content.findings)
    assert made.shared.starts_anew
    assert (len(made.new_devices), len(made.new_objects), len(made.shared.rows["object_entries"])) == (1, 1, 3)


def test_no_value_is_taken_for_null(tmp_path):
    lowest, entry = -(2**63), ObjectEntry(default_real=-(2.0**63), default_int=-(2**63) + 1, default_text="")
    values = {name: getattr(entry, name) for name in entry.__struct_fields__ if name != "spelling"}
    engine = database.open_catalog(tmp_path / "c.db", create=True)
    with engine.connect() as connection:
        buffer = RowBuffer(connection)
        named = [values.get(column.name) for column in schema.object_entries.columns[3:]]
        buffer.add("objects", [(1, b"x", *[None] * (len(schema.objects.columns) - 3), 7)])
        buffer.add("object_entries", [(1, 1, 0, *named)])
        buffer.share(NewlyShared(1, True, {"object_entries": [tuple(named)]}, []))
        buffer.add_part("object_entries", 1, 1, "[0,0]")
        buffer.flush()
        columns = schema.object_entries.c
        query = sa.select(columns.default_real, columns.default_int, columns.default_text, columns.min_int)
        assert connection.execute(query).all() == [(float(lowest), lowest + 1, "", None)] * 3
    engine.dispose()


def test_equal_members_with_equal_values_share_their_entry():
    content = read(esi(drive(record_object("#x2000"), record_object("#x2001"), record_object("#x2002", first="0600"))))
    inner = content.document.infos[0].devices[0].profiles[0].dictionary
    resolver = Resolver()
    types = resolver.types(inner)
    first, second, third = (resolver.resolve(declared, types) for declared in inner.objects)
    assert first.entries is second.entries
    assert first.entries[0] is third.entries[0]
    assert [entry.default_int for entry in third.entries] == [2, 6, 7]
    for declared, resolved in zip(inner.objects, (first, second, third), strict=True):
        assert resolved == resolve_object(declared, types.by_name)


def test_a_type_name_means_what_its_dictionary_says():
    resolver = Resolver()
    sizes = []
    for bits, base in ((16, "UINT"), (8, "USINT")):
        named = f"<DataType><Name>Mine</Name><BaseType>{base}</BaseType><BitSize>{bits}</BitSize></DataType>"
        declared = "<Object><Index>#x2000</Index><Type>Mine</Type></Object>"
        content = read(esi(device(dictionary(named, declared))))
        inner = content.document.infos[0].devices[0].profiles[0].dictionary
        (entry,) = resolver.resolve(inner.objects[0], resolver.types(inner)).entries
        sizes.append((entry.bit_size, entry.base_type))
    assert sizes == [(16, "UINT"), (8, "USINT")]


def test_a_pdo_lies_where_its_device_puts_it(tmp_path):
    """The same PDO at another place in the process image of another device has other offsets."""
    front = pdo("RxPdo", "#x15FF", 32, attributes='Sm="0"')
    sync_manager = '<Sm DefaultSize="4" StartAddress="#x1000" ControlByte="#x64" Enable="1">Outputs</Sm>'
    same = pdo("RxPdo", "#x1600", 16, 8, attributes='Sm="0"')
    folder = write(
        tmp_path / "in",
        {"a.xml": esi(device(sync_manager + same) + device(sync_manager + front + same, product="#x2"))},
    )
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([folder], jobs=1)
    assert rows(tmp_path / "c.db", PLACES) == [
        (1, 0x1600, 0, 16, 0),
        (1, 0x1600, 1, 8, 16),
        (2, 0x15FF, 0, 32, 0),
        (2, 0x1600, 0, 16, 32),
        (2, 0x1600, 1, 8, 48),
    ]


def test_lists_of_pdos_become_rows_once_for_each_of_their_places():
    owner = read(esi(drive())).document.infos[0].devices[0]
    sharing = Sharing()
    new = sharing.begin()
    maker = OwnedRowMaker(sharing)
    nowhere: PdoPlaces = {}
    places: PdoPlaces = {("RxPdo", 0): (2, [0, 16]), ("RxPdo", 1): (2, [24])}
    apart, placed, again = (maker.rows(owner, found) for found in (nowhere, places, places))
    assert [row[-1] for row in apart.tables["pdos"]] == [None, None]
    assert [row[-1] for row in placed.tables["pdos"]] == [2, 2]
    assert apart.parts["pdo_entries"] == [(0, "[0,1]"), (1, "[0]")]
    assert placed.parts["pdo_entries"] == [(0, "[2,3]"), (1, "[4]")]
    assert [row[-1] for row in new.rows["pdo_entries"]] == [None, None, 0, 16, 24]
    assert again.tables["pdos"] is placed.tables["pdos"]
    assert again.tables["sync_managers"] == placed.tables["sync_managers"]
