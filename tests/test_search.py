"""Which devices can do X: every filter against what the documents say."""

import csv
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from snippets import device, dictionary, elements, esi, pdo, rows, write
from test_cli import run
from test_counts import find, number, tree
from test_round_trip import container_of
from web_client import client

from esicatalog import Catalog, InputError
from esicatalog.catalog.device_filter import DeviceFilter
from esicatalog.catalog.filter_texts import filter_of_fields, parse_vendor
from esicatalog.identity import Bounds, Identity

MODULAR, IO, EYOU, L6N, RT118X = "ECX-A202", "ECX-D808", "EYOU_ServoModule_V143", "L6N", "RT118X-SERVO-MOTOR"


def types(db: Path | Catalog, **wanted) -> list[str]:
    if isinstance(db, Catalog):
        return [found.type for found in db.devices(**wanted)]
    with Catalog.open(db) as catalog:
        return types(catalog, **wanted)


@pytest.mark.parametrize(
    ("wanted", "found"),
    [
        ({}, [MODULAR, IO, IO, EYOU, L6N, RT118X]),
        ({"vendor_id": 0x1097}, [EYOU]),
        ({"vendor": "eyou"}, [EYOU]),
        ({"vendor": "100%"}, []),
        ({"product_code": 0x0D080808}, [IO, IO]),
        ({"sync": "sync0"}, [MODULAR, IO, IO, EYOU, L6N, RT118X]),
        ({"sync": "sync1"}, [IO]),
        ({"protocol": "foe"}, [MODULAR]),
        ({"protocol": "coe"}, [MODULAR, EYOU, L6N, RT118X]),
        ({"protocol": "eoe"}, []),
        ({"complete_access": True}, [MODULAR]),
        ({"profile_no": 5001}, [IO, IO]),
        ({"profile_no": 402}, [MODULAR, EYOU, L6N, RT118X]),
        ({"objects": [(0x6840, None)]}, [MODULAR, RT118X]),
        ({"maps": [(0x6841, 0)]}, [MODULAR, RT118X]),
        ({"maps": [(0x6040, 0)], "bits": 16}, [MODULAR, EYOU, L6N, RT118X]),
        ({"maps": [(0x6040, 0)], "bits": 8}, []),
        ({"maps": [(0x6040, 1)]}, [IO, IO]),
        ({"maps": [(0x6040, None)]}, [MODULAR, IO, IO, EYOU, L6N, RT118X]),
        ({"maps": [(0x6040, 0)], "not_maps": [(0x6840, None)]}, [EYOU, L6N]),
        ({"limit": 2}, [MODULAR, IO]),
        ({"limit": 0}, []),
    ],
)
def test_filters_on_our_examples(data_db, wanted, found):
    assert types(data_db, include_hidden=True, **wanted) == found


def test_signals_of_a_device_that_uses_the_dc_time_only(tmp_path):
    mode = "<OpMode><Name>DC</Name><AssignActivate>#x0300</AssignActivate></OpMode>"
    devices = [
        device(f"<Dc>{mode}</Dc>", "1", type_text="signal"),
        device(f'<Dc TimeLoopControlOnly="1">{mode}</Dc>', "2", type_text="time"),
    ]
    db = catalog_of(tmp_path, esi("".join(devices)))
    assert types(db, sync="sync0") == ["signal"]
    assert rows(db, "SELECT device_type FROM device_overview WHERE sync0") == [("signal",)]


def test_profile_numbers_count_wherever_they_stand(tmp_path):
    slots = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot></Slots>'
    channel = "<Profile><ChannelInfo><ProfileNo>402</ProfileNo></ChannelInfo></Profile>"
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>M</Name>{channel}</Module>'
    devices = [
        device("<Profile><ProfileNo>402</ProfileNo></Profile>", "1", type_text="own"),
        device(channel, "2", type_text="channel"),
        device(slots, "3", type_text="module"),
        device("<Profile><ProfileNo>5001</ProfileNo><AddInfo>402</AddInfo></Profile>", "4", type_text="none"),
    ]
    db = catalog_of(tmp_path, esi("".join(devices), module))
    assert types(db, profile_no=402) == ["own", "channel", "module"]
    with Catalog.open(db) as catalog:
        assert "module" in catalog.devices(profile_no=402)[2].evidence[0]


def catalog_of(tmp_path: Path, *documents: str) -> Path:
    folder = write(tmp_path / "in", {f"{n}.xml": text for n, text in enumerate(documents)})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([folder], jobs=1)
    return tmp_path / "c.db"


WORDS = esi(
    device(product="0x044C2C52", revision="#x00110000", type_text="EL1100", name="8Ch. Dig. Input 24V, 3ms")
    + device(product="2", revision="3", type_text="X9", name="Präzisionsantrieb GmbH &amp; Co")
    + device(product="5", revision="3", type_text="AX", name="Servo 3 A")
)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("EL1100", ["EL1100"]),
        ("el1100", ["EL1100"]),
        ("1100", ["EL1100"]),
        ("EL11", ["EL1100"]),
        ("x9", ["X9"]),
        ("3", ["X9", "AX", "EL1100"]),
        ("A", ["AX"]),
        ("8c", ["EL1100"]),
        ("servo 3", ["AX"]),
        ("prazisions", ["X9"]),
        ("Präzision", ["X9"]),
        ("antrieb", ["X9"]),
        ("0x044c2c52", ["EL1100"]),
        ("#x44C2C52", ["EL1100"]),
        ("72100946", ["EL1100"]),
        ("0xe5c", ["X9", "AX", "EL1100"]),
        ("test vendor", ["X9", "AX", "EL1100"]),
        ("EL1100 nothing", []),
        ("&", []),
        ("", ["X9", "AX", "EL1100"]),
        (" \t", ["X9", "AX", "EL1100"]),
        ('" OR *', []),
        ("NEAR(", []),
        ("_", []),
        ("antrieb _", ["X9"]),
        ("__ EL_", ["EL1100"]),
        ("name:x9 AND -", []),
    ],
)
def test_words(tmp_path_factory, text, found):
    db = tmp_path_factory.getbasetemp() / "words"
    if not (db / "c.db").exists():
        catalog_of(db, WORDS)
    assert types(db / "c.db", text=text) == found


def test_texts_of_megabytes_are_found_by_their_beginning(tmp_path):
    """The endings of a word grow with its square: of 2 MB they would be more than any disk holds.

    Of the 64 characters whose inside is searched there are endings of 63 to 3 characters, with a blank between two.
    """
    long = "x" * 2_000_000
    vendor = f"<Id>1</Id><Name>maker {long} inc</Name>"
    db = catalog_of(tmp_path, esi(device(type_text=f"type {long[:1900]}", name=f"name {long}"), vendor=vendor))
    assert [len(types(db, text=text)) for text in ("maker", "type xxx", "name", "inc")] == [1, 1, 1, 0]
    assert rows(db, "SELECT length(words) FROM device_search") == [(len("ype ame ") + sum(range(3, 64)) + 60,)]
    with Catalog.open(db) as catalog:
        assert catalog.check().problems == []


async def test_a_blank_text_is_no_filter_at_any_door(tmp_path):
    """Every field of a form is sent, and what is left blank there is not asked."""
    db = catalog_of(tmp_path, WORDS)
    for text in ("", " "):
        listed = json.loads(run("devices", "--text", text, "--format", "json", db=db).stdout)
        answered = (await (await client(db)).get("/-/esi/devices.json", params={"text": text})).json()
        assert [item["type"] for item in listed] == ["X9", "AX", "EL1100"]
        assert answered == listed


def test_evidence_says_what_a_document_leaves_out(tmp_path):
    mapped = pdo("RxPdo", "#x1600", 16).replace("<BitLen>16</BitLen>", "")
    clocks = "<Dc><OpMode><AssignActivate>#x700</AssignActivate></OpMode></Dc>"
    db = catalog_of(tmp_path, esi(device(mapped + clocks)))
    with Catalog.open(db) as catalog:
        (found,) = catalog.devices(maps=[(0x7000, 1)], sync="sync1")
    assert set(found.evidence) == {
        "0x7000:01, no BitLen, in RxPdo 0x1600 (not assigned by default)",
        "SYNC1 in an OpMode without Name: AssignActivate 0x0700",
    }


def test_evidence_says_which_op_modes_are_superseded(tmp_path):
    """VendorSpecific/TwinCAT/@IgnoreFromBuildNo, as Beckhoff marks OpModes of which newer ones have the name."""
    mode = "<OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate>{}</OpMode>"
    said = "<VendorSpecific><TwinCAT {}/></VendorSpecific>"
    modes = [mode.format(said.format(text)) for text in ('IgnoreFromBuildNo="2200"', 'UseFromBuildNo="2200"')]
    db = catalog_of(tmp_path, esi(device(f"<Dc>{''.join(modes)}{mode.format('')}</Dc>")))
    with Catalog.open(db) as catalog:
        (found,) = catalog.devices(sync="sync0")
    current = "SYNC0 in OpMode 'DC': AssignActivate 0x0300"
    old = "SYNC0 in OpMode 'DC' (superseded: newer tools ignore it): AssignActivate 0x0300"
    assert list(found.evidence) == [old, current, current]


@pytest.mark.parametrize(
    ("texts", "values"),
    [
        ({"modes": "csv, CSP"}, {"modes": ("CSV", "CSP")}),
        ({"modes": ["CSV"]}, {"modes": ("CSV",)}),
        ({"maps": "0x60FF", "bits": "32"}, {"maps": ((0x60FF, None),), "bits": 32}),
        ({"maps": (0x60FF, None)}, {"maps": ((0x60FF, None),)}),
        ({"maps": ["0x6041:0", (0x60FF, None)]}, {"maps": ((0x6041, 0), (0x60FF, None))}),
        ({"not_maps": [(0x6040, 0)], "objects": "0x1018:1"}, {"not_maps": ((0x6040, 0),), "objects": ((0x1018, 1),)}),
        ({"vendor_id": "0x1097", "product_code": "#x2406"}, {"vendor_id": 0x1097, "product_code": 0x2406}),
        ({"bytes_in": "<=8", "strict": False}, {"bytes_in": Bounds(None, 8)}),
        ({"like": "1:2:3"}, {"like": Identity(1, 2, 3)}),
        ({"vendor": "3S", "text": "x y", "sync": "sync1"}, {"vendor": "3S", "text": "x y", "sync": "sync1"}),
        ({"vendor": "0x1097"}, {"vendor_id": 0x1097}),
        ({"vendor": 0x1097, "vendor_id": None}, {"vendor_id": 0x1097}),
        ({"modes": ["csv", "CSP,cst"]}, {"modes": ("CSV", "CSP", "CST")}),
        ({"maps": 0x60FF, "bits": 32}, {"maps": ((0x60FF, None),), "bits": 32}),
        ({"maps": [[0x6041, 0]]}, {"maps": ((0x6041, 0),)}),
        ({"bytes_in": 8, "e_bus_ma": -100}, {"bytes_in": Bounds(8, 8), "e_bus_ma": Bounds(-100, -100)}),
        ({"bytes_in": (None, 8)}, {"bytes_in": Bounds(None, 8)}),
        ({"like": (1, 2, 3)}, {"like": Identity(1, 2, 3)}),
        ({"needs_dc": 1, "bootstrap": "no"}, {"needs_dc": True}),
    ],
)
def test_fields_of_a_filter_as_values_and_as_texts(texts, values):
    assert filter_of_fields(texts) == DeviceFilter(**values)


@pytest.mark.parametrize(
    ("field", "texts"), [("maps", ["0x60FF"]), ("not_maps", ["0x6040"]), ("objects", ["0x6502"]), ("modes", ["csv"])]
)
def test_what_is_given_one_by_one_counts_like_a_list(field, texts):
    assert filter_of_fields({field: iter(texts)}) == filter_of_fields({field: texts}) != DeviceFilter()


@pytest.mark.parametrize(
    ("field", "given"),
    [
        ("maps", "60FF"),
        ("maps", ["x"]),
        ("maps", [0x60FF, 0x6040]),
        ("maps", [0x6041, 0]),
        ("maps", (0x60FF, 0x6040)),
        ("maps", (0x60FF, 0, 0)),
        ("maps", [(0x10000, None)]),
        ("maps", None),
        ("objects", 1.5),
        ("objects", b"0x6502"),
        ("modes", "C"),
        ("modes", [5]),
        ("modes", 5),
        ("bytes_in", "few"),
        ("bytes_in", 1.5),
        ("bytes_in", Bounds(None, 2**70)),
        ("text", 5),
        ("physics", 5),
        ("vendor", ""),
        ("vendor", "\udcff"),
        ("vendor_id", 2**70),
        ("vendor_id", -1),
        ("vendor_id", True),
        ("like", (1,)),
        ("like", Identity(1, 2, 3, 0)),
        ("like", Identity(2**70, 2)),
        ("needs_dc", None),
        ("limit", 2**70),
        ("limit", -1),
    ],
)
def test_what_means_no_value_is_an_error(data_db, field, given):
    with Catalog.open(data_db) as catalog, pytest.raises(InputError):
        catalog.devices(**{field: given})


def test_two_numbers_of_a_vendor_are_refused():
    with pytest.raises(InputError, match="give one of both"):
        filter_of_fields({"vendor": "0x1097", "vendor_id": 2})
    assert filter_of_fields({"vendor": "EYOU", "vendor_id": 2}) == DeviceFilter(vendor="EYOU", vendor_id=2)


@pytest.mark.parametrize(
    "fields", [{"vendor_id": 2**70}, {"vendor_id": "0x1097"}, {"maps": ((0x60FF, 0x6040),)}, {"bytes_in": 8}]
)
def test_a_filter_checks_its_values_whoever_makes_it(fields):
    with pytest.raises(InputError, match=next(iter(fields))):
        DeviceFilter(**fields)


async def test_a_limit_is_a_number_at_every_door(data_db):
    web = await client(data_db)
    for text in ("0x2", "100000", "100001", "0xffffffff"):
        listed = run("devices", "--limit", text, "--format", "json", db=data_db)
        answer = await web.get("/-/esi/devices.json", params={"limit": text})
        assert len(answer.json()) == len(json.loads(listed.stdout)) == (2 if text == "0x2" else 5)
        assert types(data_db, limit=text) == [item["type"] for item in answer.json()]


async def test_openapi_states_the_limit_that_is_taken(data_db):
    document = (await (await client(data_db)).get("/-/esi/openapi.json")).json()
    parameters = document["paths"]["/-/esi/devices.json"]["get"]["parameters"]
    (pattern,) = (item["schema"]["pattern"] for item in parameters if item["name"] == "limit")
    assert all(re.search(pattern, text) for text in ("", "0", "5", "100000", "0x5", "4294967295"))
    assert not any(re.search(pattern, text) for text in ("-1", "4294967296", "0x100000000", "1.5"))


@pytest.mark.parametrize("given", ["yy", "YY", "yY  "])
def test_ports_are_taken_in_small_letters_too(data_db, given):
    assert types(data_db, physics=given) == [MODULAR, EYOU, L6N, RT118X]


@pytest.mark.parametrize("given", ["YX", "", "  ", "1"])
def test_ports_that_no_schema_has_are_refused(data_db, given):
    with Catalog.open(data_db) as catalog, pytest.raises(InputError, match=f"physics '{given}': write a letter"):
        catalog.devices(physics=given)


async def test_a_flag_without_value_is_not_ignored(data_db):
    """Empty is what forms send of what is not asked; a name alone asks."""
    web = await client(data_db)
    refused = await web.get("/-/esi/devices.json?needs-dc")
    assert (refused.status_code, refused.json()["error"]) == (
        400,
        "needs-dc has no value; write needs-dc=1 for a flag, else needs-dc=VALUE",
    )
    assert len((await web.get("/-/esi/devices.json?needs-dc=")).json()) == 5


async def test_openapi_says_what_each_filter_asks(data_db):
    document = (await (await client(data_db)).get("/-/esi/openapi.json")).json()
    parameters = {item["name"]: item for item in document["paths"]["/-/esi/devices.json"]["get"]["parameters"]}
    assert all(item["description"].endswith("Empty = not asked.") for item in parameters.values())
    assert parameters["min-cycle-ns"]["description"].startswith("Smallest bus cycle in ns")
    assert "Only together with mode." in parameters["strict"]["description"]
    assert parameters["limit"]["schema"]["examples"] == ["10"]
    assert re.search(parameters["physics"]["schema"]["pattern"], "YY K")
    assert not re.search(parameters["physics"]["schema"]["pattern"], "YX")


def test_wrong_filters_are_errors(data_db):
    with Catalog.open(data_db) as catalog:
        for wanted in ({"sync": "sync9"}, {"protocol": "xoe"}, {"bits": 1}):
            with pytest.raises(InputError):
                catalog.devices(**wanted)


def test_only_the_preferred_description_counts_unless_asked(tmp_path):
    poor = device(pdo("RxPdo", "#x1600", 1), name="poor")
    rich = device(pdo("RxPdo", "#x1600", 8, 8), name="rich")
    db = catalog_of(tmp_path, esi(poor), esi(rich))
    assert types(db, maps=[(0x7000, 1)], bits=1) == []
    assert types(db, maps=[(0x7000, 1)], bits=1, all_variants=True) == ["T1"]
    assert types(db, all_variants=True) == ["T1", "T1"]


def test_a_subindex_that_cannot_be_read_is_none_that_is_asked_for(tmp_path):
    """It may be any: the device is neither one that maps 0x6040:00 nor one that does not. With 0x6041 it is one."""
    entry = "<Entry><Index>#x6040</Index><SubIndex>x1</SubIndex><BitLen>16</BitLen></Entry>"
    db = catalog_of(tmp_path, esi(device(f"<RxPdo><Index>#x1600</Index><Name>R</Name>{entry}</RxPdo>")))
    assert types(db, maps=[(0x6040, 0)]) == []
    assert types(db, not_maps=[(0x6040, 0)]) == []
    assert types(db, not_maps=[(0x6041, 0)]) == ["T1"]
    with Catalog.open(db) as catalog:
        (found,) = catalog.devices(maps=[(0x6040, None)])
    assert found.evidence == ("0x6040:?, 16 bit, in RxPdo 0x1600 (not assigned by default)",)


def test_pdos_that_are_not_described_may_map_anything(tmp_path):
    """Only a Fixed PDO without entries is known to be empty; a Ref names entries that stand elsewhere."""
    bare = "<TxPdo {}><Index>#x1A00</Index><Name>P</Name></TxPdo>"
    slots = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot></Slots>'
    upload = '<Mailbox><CoE PdoUpload="1"/></Mailbox>'
    contents = {
        "fixed": bare.format('Fixed="1"'),
        "variable": bare.format(""),
        "reference": bare.format('Fixed="1" Ref="In"'),
        "module": slots,
        "uploads": upload,
        "uploads and describes": upload + pdo("TxPdo", "#x1A00", 8),
        "no process data": "",
    }
    devices = [device(content, f"{n}", type_text=name) for n, (name, content) in enumerate(contents.items())]
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>M</Name>{bare.format("")}</Module>'
    db = catalog_of(tmp_path, esi("".join(devices), module))
    without = ["fixed", "uploads and describes", "no process data"]
    assert types(db, not_maps=[(0x6040, 0)]) == types(db, not_maps=[(0x6040, 0)], limit=10) == without


def test_objects_of_modules_are_those_in_the_slots(tmp_path):
    """The Slot elements stand for slot 0, for slots 1 and 2, and for slot 3, which has an increment of its own.

    0x2000 moves by number x 0x10; 0x2001 stays. Module 2 fits slot 3 only: 0x2000 + 3 x 0x100 is all that it has.
    """
    slots = (
        '<Slots SlotIndexIncrement="#x10" SlotPdoIncrement="2">'
        '<Slot MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot>'
        '<Slot MaxInstances="2"><ModuleIdent>1</ModuleIdent></Slot>'
        '<Slot MaxInstances="1" SlotIndexIncrement="#x100"><ModuleIdent>2</ModuleIdent></Slot></Slots>'
    )
    moving, fixed = '<Index DependOnSlot="1">#x2000</Index>', "<Index>#x2001</Index>"
    entries = "".join(f"<Entry>{i}<SubIndex>1</SubIndex><BitLen>8</BitLen></Entry>" for i in (moving, fixed))
    objects = "".join(
        f"<Object>{i}<Name>O</Name><Type>USINT</Type><BitSize>8</BitSize></Object>" for i in (moving, fixed)
    )
    content = f'<RxPdo Sm="2"><Index DependOnSlot="1">#x1600</Index><Name>R</Name>{entries}</RxPdo>' + dictionary(
        "<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType>", objects
    )
    modules = "".join(f'<Module><Type ModuleIdent="{n}">M</Type><Name>M</Name>{content}</Module>' for n in (1, 2))
    there = [0x2000, 0x2001, 0x2010, 0x2020, 0x2300]
    with Catalog.open(catalog_of(tmp_path, esi(device(slots), modules))) as catalog:
        for index in (*there, 0x2002, 0x2011, 0x2030, 0x2100):
            expected = ["T1"] if index in there else []
            for limit in (None, 10):
                assert types(catalog, maps=[(index, 1)], bits=8, limit=limit) == expected
                assert types(catalog, objects=[(index, 0)], limit=limit) == expected
                not_mapping = [name for name in ["T1"] if not expected]
                assert types(catalog, not_maps=[(index, None)], limit=limit) == not_mapping
        (last,), (fixed_one,) = (catalog.devices(maps=[(index, None)]) for index in (0x2020, 0x2001))
    assert last.evidence == ("0x2020:01, 8 bit, in RxPdo 0x1604 of module 0x1 in slot 2 (on SM2 when plugged)",)
    assert fixed_one.evidence == tuple(
        f"0x2001:01, 8 bit, in RxPdo 0x1600 of module 0x{n} (on SM2 when plugged)" for n in (1, 2)
    )


def test_objects_that_describe_pdos_move_as_these_do(tmp_path):
    """By SlotPdoIncrement and SlotGroupPdoIncrement (ESI-FACTS section 12.1): slot 0, and slot 1 of group 2."""
    slots = (
        '<Slots SlotIndexIncrement="#x10" SlotPdoIncrement="2" SlotGroupIndexIncrement="#x100" '
        'SlotGroupPdoIncrement="#x20"><Slot MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot>'
        '<Slot MaxInstances="1" SlotGroup="2"><ModuleIdent>1</ModuleIdent></Slot></Slots>'
    )
    objects = "".join(
        f'<Object><Index DependOnSlot="1" DependOnSlotGroup="1">#x{index:04X}</Index><Name>O</Name><Type>USINT</Type>'
        "<BitSize>8</BitSize></Object>"
        for index in (0x1600, 0x17FF, 0x1800)
    )
    content = dictionary("<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType>", objects)
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>M</Name>{content}</Module>'
    there = [0x1600, 0x17FF, 0x1800, 0x1600 + 2 + 0x40, 0x17FF + 2 + 0x40, 0x1800 + 0x10 + 0x200]
    with Catalog.open(catalog_of(tmp_path, esi(device(slots), module))) as catalog:
        for index in (*there, 0x1600 + 0x10 + 0x200, 0x1602, 0x1640, 0x1800 + 2 + 0x40):
            for limit in (None, 10):
                expected = ["T1"] if index in there else []
                assert types(catalog, objects=[(index, None)], limit=limit) == expected, hex(index)


def test_increments_that_lead_out_of_16_bits_move_nothing(tmp_path):
    """Products of such numbers would not even fit 64 bits."""
    large = f'SlotIndexIncrement="{2**62}" SlotGroupIndexIncrement="{2**62}"'
    slots = f'<Slots {large}><Slot MaxInstances="2" SlotGroup="{2**62}"><ModuleIdent>1</ModuleIdent></Slot></Slots>'
    entry = '<Entry><Index DependOnSlot="1" DependOnSlotGroup="1">#x2000</Index><BitLen>8</BitLen></Entry>'
    pdo_xml = f'<RxPdo Sm="2"><Index DependOnSlot="1">#x1600</Index><Name>R</Name>{entry}</RxPdo>'
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>M</Name>{pdo_xml}</Module>'
    db = catalog_of(tmp_path, esi(device(slots), module))
    assert [types(db, maps=[(index, 0)]) for index in (0x2000, 0x2001)] == [["T1"], []]


def test_a_subindex_that_is_absent_is_0(tmp_path):
    bare = "<RxPdo><Index>#x1600</Index><Name>R</Name><Entry><Index>#x6040</Index><BitLen>16</BitLen></Entry></RxPdo>"
    db = catalog_of(tmp_path, esi(device(bare)))
    assert types(db, maps=[(0x6040, 0)]) == ["T1"]
    assert types(db, maps=[(0x6040, 1)]) == []
    assert types(db, not_maps=[(0x6040, 0)]) == []


def test_objects_with_subindex(tmp_path):
    item = (
        "<SubItem><SubIdx>{0}</SubIdx><Name>S{0}</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>0</BitOffs>"
        "</SubItem>"
    )
    types_xml = f"<DataType><Name>DT</Name><BitSize>64</BitSize>{item.format(0)}{item.format(4)}</DataType>"
    record = "<Object><Index>#x2000</Index><Name>O</Name><Type>DT</Type><BitSize>64</BitSize></Object>"
    db = catalog_of(tmp_path, esi(device(dictionary(types_xml, record))))
    assert types(db, objects=[(0x2000, 4)]) == ["T1"]
    assert types(db, objects=[(0x2000, 3)]) == []
    assert types(db, objects=[(0x2000, None), (0x2000, 0)]) == ["T1"]


def test_evidence_names_pdo_module_and_assignment(data_db):
    with Catalog.open(data_db) as catalog:
        (found,) = catalog.devices(maps=[(0x60FF, 0)], vendor_id=0xE5C)
        (second_axis,) = catalog.devices(maps=[(0x68FF, 0)], vendor_id=0xE5C)
    assert found.evidence == ("0x60FF:00, 32 bit, in RxPdo 0x1701 of module 0x10900 in slot 0 (on SM2 when plugged)",)
    assert second_axis.evidence == (
        "0x68FF:00, 32 bit, in RxPdo 0x1741 of module 0x10900 in slot 1 (on SM2 when plugged)",
    )


QUESTIONS = [
    ({(0x6000, 1), (0x6010, 1)}, {(0x7000, 1)}, 1),
    ({(0x6040, 0), (0x607A, 0)}, {(0x60FF, 0)}, None),
    ({(0x6000, 1)}, set(), 16),
    ({(0x6040, 0)}, {(0x6840, 0)}, None),
    ({(0x6841, 0)}, set(), None),
]


def answer_of_documents(db: Path) -> list[set[tuple]]:
    """Identities whose description maps what the questions ask for, by lxml: own PDOs and those of slot modules."""
    found: list[set[tuple]] = [set() for _ in QUESTIONS]
    for location, member in rows(db, "SELECT location, member FROM sources WHERE device_count > 0"):
        container, name = container_of(location, member)
        root = tree(container.read(name))
        for info in [root] if root.tag == "EtherCATInfo" else root.findall("EtherCATInfo"):
            modules = list(elements(info, "Descriptions", "Modules", "Module"))
            for reference in info.findall("InfoReference"):
                external = find(container, name, reference.text)
                if external is not None:
                    modules += elements(tree(container.read(external)), "Modules", "Module")
            for item in elements(info, "Descriptions", "Devices", "Device"):
                codes = item.find("Type")
                identity = tuple(
                    map(number, (info.findtext("Vendor/Id"), codes.get("ProductCode"), codes.get("RevisionNo")))
                )
                mapped = mappings(item) | {entry for owner in plugged(item, modules) for entry in mappings(*owner)}
                owners = [item, *(module for module, _ in plugged(item, modules))]
                hides_entries = any(
                    element.find("Entry") is None and (not flag(element, "Fixed") or element.get("Ref") is not None)
                    for owner in owners
                    for kind in ("RxPdo", "TxPdo")
                    for element in owner.findall(kind)
                )
                for position, (maps, not_maps, bits) in enumerate(QUESTIONS):
                    wanted = all(any(entry[:2] == one and bits in (None, entry[2]) for entry in mapped) for one in maps)
                    if wanted and not not_maps & {entry[:2] for entry in mapped} and not (not_maps and hides_entries):
                        found[position].add(identity)
    return found


def plugged(item, modules: list) -> Iterator[tuple]:
    """Modules in the slots that accept them, each with how far its objects move there: number x increment."""
    first = 0
    for slots in item.findall("Slots"):
        for slot in slots.findall("Slot"):
            increment = number(slot.get("SlotIndexIncrement") or slots.get("SlotIndexIncrement")) or 0
            idents = {number(e.text) for e in slot.findall("ModuleIdent")}
            classes = {e.text.strip() for e in elements(slot, "ModuleClass", "Class") if e.text}
            instances = number(slot.get("MaxInstances"))
            numbers = range(first, first + (1 if instances is None else instances))
            first = numbers.stop
            for module in modules:
                codes = module.find("Type")
                if number(codes.get("ModuleIdent")) in idents or codes.get("ModuleClass") in classes:
                    yield from ((module, increment * at) for at in numbers)


def flag(element, name: str) -> bool:
    return (element.get(name) or "").strip().lower() in ("1", "true")


def mappings(owner, move: int = 0) -> set[tuple]:
    return {
        (
            number(entry.findtext("Index")) + (move if flag(entry.find("Index"), "DependOnSlot") else 0),
            number(entry.findtext("SubIndex")) or 0,
            number(entry.findtext("BitLen")),
        )
        for kind in ("RxPdo", "TxPdo")
        for entry in elements(owner, kind, "Entry")
    }


def answer_of_catalog(db: Path) -> list[set[tuple]]:
    with Catalog.open(db) as catalog:
        return [
            {
                (found.vendor_id, found.product_code, found.revision_no)
                for found in catalog.devices(
                    maps=sorted(maps), not_maps=sorted(not_maps), bits=bits, all_variants=True, include_hidden=True
                )
            }
            for maps, not_maps, bits in QUESTIONS
        ]


def test_mappings_of_our_examples(data_db):
    expected = answer_of_documents(data_db)
    assert answer_of_catalog(data_db) == expected
    assert len(expected[1]) > 0


def test_mappings_of_a_sample(sample_db):
    assert answer_of_catalog(sample_db) == answer_of_documents(sample_db)


@pytest.mark.corpus
def test_mappings_of_the_corpus(corpus_db):
    expected = answer_of_documents(corpus_db)
    assert answer_of_catalog(corpus_db) == expected
    assert all(expected)


def test_a_vendor_is_found_by_every_name(tmp_path):
    """What names there are may be decided by documents that came later than a device, or went."""
    folder, db = tmp_path / "esi", tmp_path / "c.db"
    names = {"a": "Alpha Works", "b": "Beta Works", "c": "Beta Works"}
    with Catalog.open(db, create=True) as catalog:
        for number, (file, name) in enumerate(names.items()):
            document = esi(device(product=f"#x{number}"), vendor=f"<Id>5</Id><Name>{name}</Name>")
            write(folder, {f"{file}.xml": document})
            catalog.ingest([folder / f"{file}.xml"], jobs=1)
        assert {found.vendor for found in catalog.devices()} == {"Beta Works"}
        assert [found.product_code for found in catalog.devices(text="beta")] == [0, 1, 2]
        assert [found.product_code for found in catalog.devices(text="alpha")] == [0, 1, 2]
        assert catalog.check().problems == []
        (folder / "a.xml").unlink()
        catalog.ingest([folder], jobs=1, prune=True)
        assert [found.product_code for found in catalog.devices(text="beta")] == [1, 2]
        assert catalog.devices(text="alpha") == []
        assert catalog.check().problems == []


def test_a_vendor_id_that_makers_share_is_told(tmp_path):
    """A device of one maker is listed under the name of the other: the id is all that the bus tells."""
    documents = (
        esi(device(product=f"#x{n}"), vendor=f"<Id>5</Id><Name>{name}</Name>")
        for n, name in enumerate(("Beta", "Beta", "Alpha"))
    )
    db = catalog_of(tmp_path, *documents)
    with Catalog.open(db) as catalog:
        by_shown, by_other = catalog.devices(vendor="beta"), catalog.devices(vendor="alph")
    assert [found.product_code for found in by_shown] == [found.product_code for found in by_other] == [0, 1, 2]
    also = "documents with vendor id 0x00000005 also name"
    assert [found.evidence for found in by_shown] == [(), (), (f"{also} 'Beta'",)]
    assert [found.evidence for found in by_other] == [(f"{also} 'Alpha'",), (f"{also} 'Alpha'",), ()]


@pytest.mark.parametrize("text", ["Inovance", "汇川", "Технология"])
def test_a_vendor_is_found_in_every_language(tmp_path, text):
    names = '<Name LcId="1033">Inovance Ltd</Name><Name LcId="2052">汇川技术</Name><Name LcId="1049">Технология</Name>'
    db = catalog_of(tmp_path, esi(device(), vendor=f"<Id>5</Id>{names}"))
    assert types(db, text=text) == ["T1"]


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("3S", (None, "3S")),
        ("3s-Smart", (None, "3s-Smart")),
        ("4711 GmbH", (None, "4711 GmbH")),
        ("4247", (0x1097, None)),
        ("0x1097", (0x1097, None)),
        ("#X1097", (0x1097, None)),
    ],
)
def test_a_vendor_is_a_number_or_a_part_of_a_name(text, meant):
    assert parse_vendor(text) == meant


@pytest.mark.parametrize("text", ["0xZZ", "#5", "0x", "99999999999", " ", ""])
def test_what_is_meant_as_a_vendor_id_is_no_name(text):
    with pytest.raises(InputError, match=r"^vendor "):
        parse_vendor(text)


def test_a_vendor_whose_name_begins_with_a_digit(tmp_path):
    db = catalog_of(tmp_path, esi(device(), vendor="<Id>5</Id><Name>3S-Smart Software</Name>"))
    assert run("devices", "--vendor", "3S", db=db).stdout.count("0x00000005") == 1


def test_people_are_told_a_dozen_of_many_reasons_the_assigned_ones_first(tmp_path):
    entries = [f"<Entry><Index>#x6002</Index><SubIndex>{n}</SubIndex><BitLen>8</BitLen></Entry>" for n in range(1, 21)]
    optional = f"<TxPdo><Index>#x1A00</Index><Name>All</Name>{''.join(entries)}</TxPdo>"
    default = f'<TxPdo Sm="0"><Index>#x1A01</Index><Name>Last</Name>{entries[-1]}</TxPdo>'
    write(tmp_path / "in", {"a.xml": esi(device(f"<Sm>Inputs</Sm>{optional}{default}"))})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
        (found,) = catalog.devices(maps=[(0x6002, None)])
    assert len(found.evidence) == 21
    assert found.evidence[0] == "0x6002:14, 8 bit, in TxPdo 0x1A01 (default on SM0)"
    assert found.shown_evidence == (*found.evidence[:12], "and 9 more")


def test_hidden_revisions_are_marked_where_they_are_listed(tmp_path):
    """Revision 2 hides revision 1."""
    db = catalog_of(tmp_path, esi(device() + device("<HideType RevisionNo='#x1'/>", revision="#x2")))
    first, second = run("devices", "--include-hidden", db=db).stdout.splitlines()[1:]
    assert first.split() == ["0x00000e5c:0x00000001:0x00000001", "hidden", "T1", "N"]
    assert second.split() == ["0x00000e5c:0x00000001:0x00000002", "T1", "N"]
    (only,) = run("devices", db=db).stdout.splitlines()[1:]
    assert only.split() == second.split()
    table = csv.DictReader(io.StringIO(run("devices", "--include-hidden", "--format", "csv", db=db).stdout))
    assert [row["hidden"] for row in table] == ["true", "false"]
    assert "hidden: another description of the vendor supersedes it" in run("identify", "0xe5c", 1, 1, db=db).stdout
    assert "hidden" not in run("identify", "0xe5c", 1, 2, db=db).stdout.partition("Others")[0]
