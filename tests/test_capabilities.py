"""What devices can do, asked as filters and in SQL: every answer with its evidence, nothing hidden by accident."""

import json

import pytest
from snippets import device, dictionary, esi, one, pdo, rows
from test_cli import run
from test_device_facts import oversampling, sync_objects
from test_search import catalog_of, types

from esicatalog import Catalog, InputError, NotFound
from esicatalog.catalog.device_filter import DeviceFilter
from esicatalog.catalog.search import conditions, device_query
from esicatalog.identity import Bounds, Identity, parse_bounds, parse_modes

MODULAR, EYOU, L6N, RT118X = "ECX-A202", "EYOU_ServoModule_V143", "L6N", "RT118X-SERVO-MOTOR"


@pytest.mark.parametrize(
    ("wanted", "found"),
    [
        ({"modes": ["CSV"]}, [MODULAR, EYOU, L6N]),
        ({"modes": ["PP", "TQ"]}, [EYOU]),
        ({"modes": ["CSTCA"], "strict": True}, [MODULAR]),
        ({"pdo_assign": True}, [MODULAR, EYOU, L6N]),
        ({"pdo_config": True}, [L6N]),
        ({"bootstrap": True}, [MODULAR, EYOU, L6N]),
        ({"no_lrw": True}, []),
        ({"physics": "KK"}, ["ECX-D808"]),
        ({"physics": "YY  "}, [MODULAR, EYOU, L6N, RT118X]),
        ({"bytes_in": Bounds(None, 1)}, ["ECX-D808"]),
        ({"bytes_in": Bounds(24, 25)}, [L6N, RT118X]),
        ({"e_bus_ma": Bounds(100, 100)}, ["ECX-D808"]),
        ({"axes": Bounds(4, None)}, [RT118X]),
        ({"min_cycle_ns": Bounds(None, 250_000)}, [MODULAR, L6N]),
        ({"protocol": "fsoe"}, []),
        ({"modes": ["CSV"], "sync": "sync1"}, []),
    ],
)
def test_filters_on_our_examples(data_db, wanted, found):
    assert types(data_db, **wanted) == found


def test_ports_are_told_in_words(tmp_path):
    db = catalog_of(tmp_path, esi(device().replace('Physics="YY"', 'Physics="BK H"')))
    with Catalog.open(db) as catalog:
        (found,) = catalog.devices(physics="BK H")
    assert found.evidence == (
        "Physics 'BK H': port A E-bus cable, port B E-bus, port C unused, port D MII fast hot connect",
    )


def test_a_mode_answer_is_a_recipe_with_its_evidence(data_db):
    with Catalog.open(data_db) as catalog:
        (eyou,) = catalog.devices(modes=["CSV"], vendor_id=0x1097)
    (text,) = eyou.evidence
    assert text.startswith("CSV yes, axis 0: module name 'Axis (csv,csp,cst)")
    for part in (
        "plug module 0x119800 into slot 0 (default)",
        "RxPDO 0x1600",
        "0x6060 is mapped in RxPDO 0x1600: set it to 9",
    ):
        assert part in text


def test_a_cycle_is_told_with_its_place(tmp_path):
    """Outputs keep up with 250 µs, inputs with 1 ms; an oversampling terminal has 10 samples of 5 µs."""
    declared = sync_objects(("#x1C32", "90D00300"), ("#x1C33", "40420F00"))
    sampled = oversampling('DefaultFactor="10" MinCycleTime="5000"')
    db = catalog_of(tmp_path, esi(device(declared, "#x1") + device(sampled, "#x2")))
    with Catalog.open(db) as catalog:
        assert [item.product_code for item in catalog.devices(min_cycle_ns=Bounds(None, 250_000))] == [2]
        assert [item.evidence for item in catalog.devices(min_cycle_ns=Bounds(1, None))] == [
            ("smallest cycle 1000000 ns (0x1C33:05)",),
            ("smallest cycle 50000 ns (oversampling: DefaultFactor x MinCycleTime)",),
        ]


def test_likely_counts_unless_strict(tmp_path):
    """An InitCmd without a mapped setpoint (rank C2) is likely, not yes."""
    mailbox = (
        "<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>#x6060</Index><SubIndex>0</SubIndex>"
        "<Data>09</Data></InitCmd></CoE></Mailbox>"
    )
    db = catalog_of(tmp_path, esi(device(f"<Profile><ProfileNo>402</ProfileNo></Profile>{mailbox}")))
    assert types(db, modes=["CSV"]) == types(db, modes="csv") == ["T1"]
    assert types(db, modes=["CSV"], strict=True) == []
    assert types(db, modes=["CSP"]) == []


def test_what_the_declaration_denies_is_no(tmp_path):
    objects = (
        "<Object><Index>#x6502</Index><Name>Supported</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        "<Info><DefaultData>80000000</DefaultData></Info></Object>"
    )
    types_text = "<DataType><Name>UDINT</Name><BitSize>32</BitSize></DataType>"
    db = catalog_of(tmp_path, esi(device(dictionary(types_text, objects))))
    assert types(db, modes=["CSP"], strict=True) == ["T1"]
    assert types(db, modes=["CSV"]) == []
    assert rows(db, "SELECT mode, verdict FROM device_drive_modes WHERE mode IN ('CSP', 'CSV') ORDER BY mode") == [
        ("CSP", "yes"),
        ("CSV", "no"),
    ]


HIDING = esi(
    device("<HideType RevisionNo='#x1'/>", revision="#x2", type_text="new")
    + device("", revision="#x1", type_text="old")
    + device("<HideType RevisionNo='#x9'/>", revision="#x3", type_text="B")
    + device("", revision="#x9", type_text="newer but hidden")
)


def test_hidden_revisions_are_left_out(tmp_path):
    db = catalog_of(tmp_path, HIDING)
    assert types(db) == ["new", "B"]
    assert types(db, include_hidden=True) == ["old", "new", "B", "newer but hidden"]
    with Catalog.open(db) as catalog:
        assert catalog.device("0xE5C:1").device.type == "B"


def test_hiding_reaches_across_documents_of_a_vendor_only(tmp_path):
    other = "<Id>7</Id><Name>Other</Name>"
    db = catalog_of(
        tmp_path,
        esi(device("<HideType RevisionNo='1'/><HideType ProductCode='5' RevisionNo='5'/>", revision="2")),
        esi(device(revision="1", type_text="same vendor") + device(product="5", revision="5", type_text="by product")),
        esi(device(revision="1", type_text="other vendor"), vendor=other),
    )
    assert types(db) == ["other vendor", "T1"]


def test_hiding_ends_with_the_description_that_hides(tmp_path):
    folder = tmp_path / "in"
    db = catalog_of(tmp_path, esi(device("<HideType RevisionNo='1'/>", revision="2")), esi(device(revision="1")))
    assert one(db, "SELECT sum(hidden) FROM devices") == 1
    (folder / "0.xml").unlink()
    with Catalog.open(db) as catalog:
        catalog.ingest([folder], jobs=1, prune=True)
    assert rows(db, "SELECT revision_no, hidden FROM devices") == [(1, 0)]


def test_a_description_without_revision_hides_too(tmp_path):
    hides = device("<HideType RevisionNo='1'/>", type_text="any").replace(' RevisionNo="#x1"', "", 1)
    db = catalog_of(
        tmp_path, esi(hides + device(revision="1", type_text="old") + device(revision="2", type_text="new"))
    )
    assert rows(db, "SELECT type FROM devices WHERE hidden ORDER BY type") == [("old",)]
    assert types(db) == ["any", "new"]


def test_a_revision_cannot_hide_itself(tmp_path):
    db = catalog_of(tmp_path, esi(device("<HideType RevisionNo='1'/>", revision="1")))
    assert types(db) == ["T1"]


SM = "<Sm>Outputs</Sm>"


def layouts() -> str:
    wide, narrow = pdo("RxPdo", "#x1600", 8, 8, attributes='Sm="0"'), pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')
    optional = pdo("RxPdo", "#x1601", 8)
    return esi(
        device(SM + wide, revision="1", type_text="A")
        + device(SM + wide, revision="2", type_text="A")
        + device(SM + narrow, revision="3", type_text="A")
        + device(SM + wide + optional, product="7", type_text="more")
        + device("", product="8", type_text="without process data")
    )


def test_same_layout_is_found_and_never_called_a_replacement(tmp_path):
    db = catalog_of(tmp_path, layouts())
    with Catalog.open(db) as catalog:
        found = catalog.devices(like=Identity(0xE5C, 1, 1))
        assert [(item.product_code, item.revision_no) for item in found] == [(1, 2), (7, 1)]
        assert [item.evidence[0].rpartition(", ")[2] for item in found] == [
            "all PDOs of the device itself too",
            "other PDOs of the device itself differ",
        ]
        assert all("same process-image layout as" in item.evidence[0] for item in found)
        with pytest.raises(InputError, match="no process data"):
            catalog.devices(like=Identity(0xE5C, 8, 1))
        with pytest.raises(NotFound):
            catalog.devices(like=Identity(0xE5C, 9, 1))
    text = run("show", "0xe5c:1:1", db=db).stdout
    assert "Same process-image layout (2)" in text
    assert "replacement" not in text


def test_pdos_of_modules_are_not_compared(tmp_path):
    """Two couplers without PDOs of their own, with the same module by default; a third has an optional PDO itself."""
    slots = '<Slots><Slot MinInstances="1" MaxInstances="1"><ModuleIdent Default="1">1</ModuleIdent>{}</Slot></Slots>'
    more, optional = "<ModuleIdent>2</ModuleIdent>", pdo("RxPdo", "#x1601", 8)
    module = '<Module><Type ModuleIdent="{0}">M</Type><Name>M</Name>{1}</Module>'
    modules = "".join(
        module.format(ident, pdo("RxPdo", f"#x170{ident}", 8 * ident, attributes='Sm="0"')) for ident in (1, 2)
    )
    contents = (SM + slots.format(""), SM + slots.format(more), SM + optional + slots.format(""))
    devices = "".join(device(content, product=str(number)) for number, content in enumerate(contents, 1))
    db = catalog_of(tmp_path, esi(devices, modules))
    with Catalog.open(db) as catalog:
        found = catalog.devices(like=Identity(0xE5C, 1, 1))
    assert [item.evidence[0].partition(", ")[2] for item in found] == [
        "no other PDOs but those of modules, which are not compared",
        "other PDOs of the device itself differ",
    ]
    pairs = "SELECT same_pdo_set FROM same_process_image_layout WHERE product_code = 1 ORDER BY other_product_code_hex"
    assert rows(db, pairs) == [(None,), (0,)]


@pytest.mark.parametrize(
    "open_sm", ['<Sm DefaultSize="8">Outputs</Sm>', '<Mailbox><CoE PdoUpload="1"/></Mailbox><Sm>Outputs</Sm>']
)
def test_what_has_no_known_length_is_like_nothing(tmp_path, open_sm):
    """Revisions with the same words for what nobody describes: what changed and what they are like is not known."""
    db = catalog_of(tmp_path, esi("".join(device(open_sm, revision=number) for number in "12")))
    with Catalog.open(db) as catalog:
        revisions = catalog.device("0xE5C:1:1").revisions
        assert [r.layout_changed for r in revisions] == [False, None]
        assert [r.layout_words for r in revisions] == ["", "layout not known"]
        assert catalog.device("0xE5C:1:1").same_layout == ()
        with pytest.raises(InputError, match="the length of the default process image of"):
            catalog.devices(like=Identity(0xE5C, 1, 1))
        assert not catalog.devices(bytes_out=0)
    assert rows(db, "SELECT * FROM same_process_image_layout") == []
    assert rows(db, "SELECT layout_changed FROM device_revisions ORDER BY revision_no") == [(0,), (None,)]


def test_a_variant_is_listed_beside_the_preferred_ones_of_its_layout(tmp_path):
    """Variant 2 has fewer PDO entries, and the layout of product 7."""
    wide, narrow = pdo("RxPdo", "#x1600", 8, 8, attributes='Sm="0"'), pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')
    other = device(SM + narrow, product="7")
    db = catalog_of(tmp_path, esi(device(SM + wide)), esi(device(SM + narrow) + other))
    pairs = "SELECT product_code, variant, other_product_code_hex FROM same_process_image_layout"
    assert rows(db, pairs) == [(1, 2, "0x00000007")]
    with Catalog.open(db) as catalog:
        assert [found.product_code for found in catalog.devices(like=Identity(0xE5C, 1, 1, 2))] == [7]


def test_revisions_with_another_layout_are_marked(tmp_path):
    db = catalog_of(tmp_path, layouts())
    marked = rows(db, "SELECT revision_no, layout_changed FROM device_revisions WHERE product_code = 1 ORDER BY 1")
    assert marked == [(1, 0), (2, 0), (3, 1)]
    with Catalog.open(db) as catalog:
        assert [r.layout_changed for r in catalog.device("0xE5C:1:1").revisions] == [False, False, True]


def test_revisions_are_compared_within_their_type(tmp_path):
    """Beckhoff interleaves the variants of a terminal: -0010-0016 follows -0016, not its own predecessor."""
    wide, narrow = pdo("RxPdo", "#x1600", 8, 8, attributes='Sm="0"'), pdo("RxPdo", "#x1600", 16, attributes='Sm="0"')
    vendor = "<Id>2</Id><Name>Beckhoff</Name>"
    content = "".join(
        device(SM + entries, revision=revision, type_text=name)
        for revision, name, entries in (
            ("#x00100000", "EL1", wide),
            ("#x00100014", "EL1-0020", narrow),
            ("#x00110000", "EL1", wide),
            ("#x00110014", "EL1-0020", wide),
        )
    )
    db = catalog_of(tmp_path, esi(content, vendor=vendor))
    query = "SELECT revision_text, layout_changed FROM device_revisions ORDER BY revision_no"
    assert rows(db, query) == [("-0016", 0), ("-0020-0016", 1), ("-0017", 0), ("-0020-0017", 1)]


def test_places_in_the_default_image(tmp_path):
    """Two assigned PDOs of 3 and 13 bits follow each other; the one that is not assigned has no place."""
    objects = (
        "<Object><Index>#x7000</Index><Name>Setpoints</Name><Type>DT7000</Type><BitSize>19</BitSize>"
        "<Info><SubItem><Name>SubIndex 000</Name></SubItem>"
        "<SubItem><Name>Speed</Name><Info><MinValue>-5</MinValue><MaxValue>5</MaxValue><Unit>#x00010000</Unit></Info>"
        "</SubItem></Info></Object>"
    )
    data_types = (
        "<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType><DataType><Name>SINT</Name><BitSize>8</BitSize>"
        "</DataType><DataType><Name>DT7000</Name><BitSize>24</BitSize>"
        "<SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs>"
        "</SubItem><SubItem><SubIdx>1</SubIdx><Name>Speed</Name><Type>SINT</Type><BitSize>8</BitSize>"
        "<BitOffs>16</BitOffs></SubItem></DataType>"
    )
    content = (
        dictionary(data_types, objects)
        + SM
        + pdo("RxPdo", "#x1600", 3, attributes='Sm="0"')
        + pdo("RxPdo", "#x1601", 8)
        + pdo("RxPdo", "#x1602", 8, 5, attributes='Sm="0"')
    )
    db = catalog_of(tmp_path, esi(device(content)))
    query = (
        "SELECT pdo_index_hex, image_sm, assigned_by_default, image_byte_bit, object_name, object_entry_name, signed, "
        "unit_hex, minimum, maximum FROM device_pdo_entries ORDER BY pdo_position, position"
    )
    speed = ("Setpoints", "Speed", 1, "0x00010000", -5, 5)
    nothing = (None, None, None, None, None, None)
    assert rows(db, query) == [
        ("0x1600", 0, 1, "0.0", *speed),
        ("0x1601", None, 0, None, *speed),
        ("0x1602", 0, 1, "0.3", *speed),
        ("0x1602", 0, 1, "1.3", *nothing),
    ]


@pytest.mark.parametrize(
    ("data_type", "signed"),
    [
        ("", 1),  # as the object says, which is a SINT
        ("<DataType>SINT</DataType>", 1),
        ("<DataType>USINT</DataType>", 0),
        ("<DataType>UINT8</DataType>", 0),
        ("<DataType> unsigned8 </DataType>", 0),
        ("<DataType>INT8</DataType>", 1),
        ("<DataType>OWN</DataType>", 1),  # no base type: as the object says
        ("<DataType>BOOL</DataType>", None),
        ("<DataType>REAL</DataType>", None),
        ("<DataType>STRING(1)</DataType>", None),
        ("<DataType>ARRAY [0..0] OF BYTE</DataType>", None),
    ],
)
def test_the_type_of_an_entry_counts_before_that_of_its_object(tmp_path, data_type, signed):
    types = "<DataType><Name>SINT</Name><BitSize>8</BitSize></DataType>"
    objects = "<Object><Index>#x7000</Index><Name>O</Name><Type>SINT</Type><BitSize>8</BitSize></Object>"
    entry = f"<Entry><Index>{{}}</Index><SubIndex>0</SubIndex><BitLen>8</BitLen>{data_type}</Entry>"
    entries = entry.format("#x7000") + entry.format("#x0")  # the second is a gap
    content = f'<RxPdo Sm="0"><Index>#x1600</Index><Name>R</Name>{entries}</RxPdo>'
    db = catalog_of(tmp_path, esi(device(dictionary(types, objects) + SM + content)))
    query = "SELECT signed FROM device_pdo_entries ORDER BY position"
    assert rows(db, query) == [(signed,), (None,)]


def test_an_entry_whose_subindex_cannot_be_read_is_of_no_object(tmp_path):
    """Unknown is not 0: of an object that is a single value the entry without SubIndex is, that with x1 is not."""
    types = "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
    objects = "<Object><Index>#x7000</Index><Name>Speed</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    entry = "<Entry><Index>#x7000</Index>{}<BitLen>16</BitLen></Entry>"
    entries = "".join(map(entry.format, ("<SubIndex>x1</SubIndex>", "", "<SubIndex></SubIndex>")))
    content = dictionary(types, objects) + f"<RxPdo><Index>#x1600</Index><Name>R</Name>{entries}</RxPdo>"
    query = "SELECT object_name, signed FROM device_pdo_entries ORDER BY position"
    assert rows(catalog_of(tmp_path, esi(device(content))), query) == [(None, None), ("Speed", 0), ("Speed", 0)]


def test_a_length_that_is_not_described_is_no_number(tmp_path):
    """Variable content before 16 bits: neither is the size known nor the place; inputs there are none."""
    empty = '<RxPdo Sm="0"><Index>#x1600</Index><Name>R</Name></RxPdo>'
    db = catalog_of(tmp_path, esi(device(SM + empty + pdo("RxPdo", "#x1601", 16, attributes='Sm="0"'))))
    assert rows(db, "SELECT output_bytes, input_bytes FROM device_facts") == [(None, 0)]
    query = "SELECT assigned_by_default, image_bit_offset, image_byte_bit FROM device_pdo_entries"
    assert rows(db, query) == [(1, None, None)]
    with Catalog.open(db) as catalog:
        assert [len(catalog.devices(bytes_out=Bounds(0, most))) for most in (0, 2, None)] == [0, 0, 0]
        assert len(catalog.devices(bytes_in=Bounds(0, 0))) == 1
    result = run("show", "0xe5c:1", "--db", db, "--format", "json")
    sheet = json.loads(result.stdout)
    (image,) = sheet["process_image"]
    facts = sheet["facts"]
    assert (facts["output_bytes"], facts["input_bytes"], facts["runs_without_dc"]) == (None, 0, True)
    assert (image["byte_size"], image["bit_size"], image["size"]) == (None, None, "at least 2 bytes (16 bits)")
    assert [entry["bit_offset"] for entry in image["entries"]] == [None]
    shown = run("show", "0xe5c:1", "--db", db).stdout
    assert "SM0 Outputs: at least 2 bytes (16 bits)" in shown
    assert "?         16    0x7000:01" in shown


def test_lengths_without_end_stop_no_query(tmp_path):
    """Three entries of 2^63 - 1 bits: their sum is no number of a database. Beside them 3 and 5 bits, -4 take none."""
    huge = 2**63 - 1
    content = SM + pdo("RxPdo", "#x1600", huge, huge, huge, attributes='Sm="0"') + pdo("RxPdo", "#x1601", 3, -4, 5)
    db = catalog_of(tmp_path, esi(device(content)))
    query = "SELECT pdo_index, bit_offset_in_pdo FROM device_pdo_entries ORDER BY pdo_position, position"
    assert rows(db, query) == [(0x1600, None)] * 3 + [(0x1601, 0), (0x1601, 3), (0x1601, 3)]
    assert rows(db, "SELECT bit_size FROM pdos ORDER BY pdo_index") == [(None,), (8,)]
    assert rows(db, "SELECT output_bytes FROM device_facts") == [(None,)]


def test_mode_matrix_counts_visible_drives(data_db):
    counted = dict(rows(data_db, "SELECT vendor_id, csv FROM drive_modes_by_vendor WHERE csv > 0"))
    assert counted == {0xE5C: 1, 0x1097: 1, 0x4321: 1}


@pytest.mark.parametrize(
    ("text", "bounds"),
    [
        ("<=8", (None, 8)),
        (">= 0x10", (16, None)),
        ("8", (8, 8)),
        ("=8", (8, 8)),
        ("<=-100", (None, -100)),
    ],
)
def test_amounts_as_people_write_them(text, bounds):
    assert parse_bounds(text) == bounds


@pytest.mark.parametrize("text", ["", "<=", "<8", "eight", ">=8 bytes"])
def test_amounts_that_are_none(text):
    with pytest.raises(InputError):
        parse_bounds(text)


def test_mode_queries_use_an_index(data_db):
    """No table of modes, entries or objects is read from end to end."""
    with Catalog.open(data_db) as catalog, catalog._connection() as connection:
        wanted = DeviceFilter(modes=("CSV",), sync="sync1")
        query = device_query(list(conditions(connection, wanted)), wanted)
        text = str(query.compile(connection, compile_kwargs={"literal_binds": True}))
        plan = [row[3] for row in connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {text}")]
    assert any("ix_drive_modes_kind_mode" in line for line in plan)
    assert not [
        line for line in plan if line.startswith("SCAN") and "devices" not in line and "device_facts" not in line
    ]


def test_modes_in_any_case():
    assert parse_modes("csv, CSP,csv") == ("CSV", "CSP")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--mode", "XYZ"), "mode 'XYZ': say one of PP,"),
        (("--strict",), "strict is about drive modes"),
        (("--bytes-in", "<8"), "--bytes-in '<8' is no such amount; write <=8, >=8 or 8"),
        (("--like", "0xe5c:0x99"), "is not in the catalog"),
    ],
)
def test_wrong_usage_is_one_line(data_db, words, message):
    done = run("devices", *words, db=data_db)
    assert done.exit_code != 0
    assert message in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_json_of_a_mode_query(data_db):
    found = json.loads(run("devices", "--mode", "CSV", "--format", "json", db=data_db).stdout)
    assert [item["type"] for item in found] == [MODULAR, EYOU, L6N]
    assert all(item["evidence"] for item in found)
