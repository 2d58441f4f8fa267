"""Comparing object dictionaries: objects by index, entries by subindex, values by what they mean."""

import pytest
from snippets import dictionary
from test_compare import told

BASE = "".join(
    f"<DataType><Name>{name}</Name><BitSize>{bits}</BitSize></DataType>"
    for name, bits in (("USINT", 8), ("UINT", 16), ("UDINT", 32), ("INT", 16))
)


def objects(*items: str, types: str = "") -> str:
    return dictionary(BASE + types, "".join(items))


def single(
    index: str, info: str = "", flags: str = "", data_type: str = "UINT", bits: int = 16, name: str = "O"
) -> str:
    return (
        f"<Object><Index>{index}</Index><Name>{name}</Name><Type>{data_type}</Type><BitSize>{bits}</BitSize>"
        f"<Info>{info}</Info><Flags>{flags}</Flags></Object>"
    )


RW, RO = "<Access>rw</Access>", "<Access>ro</Access>"


def test_unit_types_of_a_dictionary_do_not_count():
    """They are names of units; what an entry's unit becomes is told with the entry."""
    unit = "<UnitTypes><UnitType><Index>#x01</Index></UnitType></UnitTypes>"
    plain = objects(single("#x2000"))
    (only,) = told(plain, plain.replace("<Dictionary>", f"<Dictionary>{unit}"))
    assert (only[0], only[-1]) == ("unit types", False)


def test_objects_are_matched_by_index_wherever_they_stand():
    first, second, third = single("#x2000"), single("#x2001"), single("#x2002")
    assert told(objects(first, second, third), objects(third, first, second)) == []
    assert told(objects(first, third), objects(first, second, third)) == [
        ("0x2001", None, "O, UINT, 16 bit, ro", False)
    ]
    assert told(objects(first, second), objects(second)) == [("0x2000", "O, UINT, 16 bit, ro", None, True)]


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        (
            single("#x6040", flags=RW),
            single("#x6040", flags=RO),
            [("0x6040:00 access", "rw", "ro", True)],
        ),
        (
            single("#x6040", flags=RO),
            single("#x6040", flags=RW),
            [("0x6040:00 access", "ro", "rw", False)],
        ),
        (
            single("#x6040", flags=RW),
            single("#x6040", flags='<Access WriteRestrictions="PreOP">rw</Access>'),
            [("0x6040:00 access", "rw", "rwr-r- (PREOP, SAFEOP, OP)", True)],
        ),
        (
            single("#x6040", flags=RO + "<PdoMapping>RT</PdoMapping>"),
            single("#x6040", flags=RO + "<PdoMapping>t</PdoMapping>"),
            [("0x6040:00 PDO mapping", "RxPDO and TxPDO", "TxPDO", True)],
        ),
        (
            single("#x6040"),
            single("#x6040", flags=RO + "<PdoMapping>R</PdoMapping>"),
            [("0x6040:00 PDO mapping", None, "RxPDO", False)],
        ),
        (
            single("#x6040"),
            single("#x6040", data_type="INT"),
            [("0x6040:00 type", "UINT", "INT", True)],
        ),
        (
            single("#x6040"),
            single("#x6040", data_type="UDINT", bits=32),
            [("0x6040:00 type", "UINT", "UDINT", True), ("0x6040:00 size", "16 bit", "32 bit", True)],
        ),
        (single("#x6040"), single("#x6040", name="Controlword"), [("0x6040 name", "O", "Controlword", False)]),
        (single("#x6040"), single("#x6040", data_type="UINT16"), []),
    ],
)
def test_fields_of_an_object(left, right, expected):
    assert told(objects(left), objects(right)) == expected


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        ("<DefaultData>8001</DefaultData>", "<DefaultValue>384</DefaultValue>", []),
        (
            "<DefaultData>0100</DefaultData>",
            "<DefaultData>0200</DefaultData>",
            [("0x2000:00 default", "1", "2", True)],
        ),
        ("", "<DefaultData>1000</DefaultData>", [("0x2000:00 default", None, "16 (0x10)", False)]),
        ("<MinValue>0</MinValue>", "<MinValue>1</MinValue>", [("0x2000:00 minimum", "0", "1", True)]),
        ("<MinValue>1</MinValue>", "<MinValue>0</MinValue>", [("0x2000:00 minimum", "1", "0", False)]),
        ("<MaxValue>5</MaxValue>", "<MaxValue>9</MaxValue>", [("0x2000:00 maximum", "5", "9", False)]),
        ("<MaxValue>5</MaxValue>", "<MaxValue>4</MaxValue>", [("0x2000:00 maximum", "5", "4", True)]),
        ("", "<MaxValue>4</MaxValue>", [("0x2000:00 maximum", None, "4", True)]),
    ],
)
def test_values_count_where_a_master_can_write(left, right, expected):
    assert told(objects(single("#x2000", left, RW)), objects(single("#x2000", right, RW))) == expected
    found = told(objects(single("#x2000", left, RO)), objects(single("#x2000", right, RO)))
    assert found == [(*words, False) for *words, _ in expected]


def test_the_default_of_0x6502_counts_though_it_is_read_only():
    modes = [
        single(index, f"<DefaultData>{data}</DefaultData>", RO, "UDINT", 32)
        for data in ("80010000", "80000000")
        for index in ("#x6502", "#x6D02")
    ]
    assert told(objects(*modes[:2]), objects(*modes[2:])) == [
        ("0x6502:00 default", "384 (0x180)", "128 (0x80)", True),
        ("0x6D02:00 default", "384 (0x180)", "128 (0x80)", True),
    ]


def member(subindex: int, name: str, data_type: str, bits: int, offset: int, flags: str = "") -> str:
    return (
        f"<SubItem><SubIdx>{subindex}</SubIdx><Name>{name}</Name><Type>{data_type}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs>{flags}</SubItem>"
    )


def record(*members: str) -> str:
    count = member(0, "SubIndex 000", "USINT", 8, 0)
    return f"<DataType><Name>DT8000</Name><BitSize>80</BitSize>{count}{''.join(members)}</DataType>"


RECORD = "<Object><Index>#x8000</Index><Name>Settings</Name><Type>DT8000</Type><BitSize>80</BitSize></Object>"
GAIN, LIMIT = member(1, "Gain", "UINT", 16, 16), member(2, "Limit", "UINT", 16, 32)


def test_a_type_may_differ_where_its_object_does_not():
    left, right = objects(RECORD, types=record(GAIN, LIMIT)), objects(RECORD, types=record(GAIN))
    assert told(left, right) == [("0x8000:02", "Limit, UINT, 16 bit, ro", None, True)]
    assert told(right, left) == [("0x8000:02", None, "Limit, UINT, 16 bit, ro", False)]


def test_a_type_that_the_object_does_not_use_makes_no_difference():
    unused = record(GAIN).replace("DT8000", "DT9000")
    assert told(objects(RECORD, types=record(GAIN) + unused), objects(RECORD, types=record(GAIN))) == []


def test_an_entry_put_between_others_moves_the_complete_access_image():
    behind = member(3, "Limit", "UINT", 16, 32)
    moved = member(2, "New", "UINT", 16, 32) + member(3, "Limit", "UINT", 16, 48)
    assert told(objects(RECORD, types=record(GAIN, behind)), objects(RECORD, types=record(GAIN, moved))) == [
        ("0x8000:02", None, "New, UINT, 16 bit, ro", False),
        ("0x8000 complete-access image", "03 at bit 32", "03 at bit 48", True),
    ]


def test_subindices_have_access_and_values_of_their_own():
    flags = f"<Flags>{RW}</Flags>"
    values = "<Info><SubItem><Name>Gain</Name><Info><DefaultData>{}</DefaultData></Info></SubItem></Info></Object>"
    types = record(member(1, "Gain", "UINT", 16, 16, flags))
    left, right = (RECORD.replace("</Object>", values.format(data)) for data in ("0A00", "0000"))
    assert told(objects(left, types=types), objects(right, types=types)) == [
        ("0x8000:01 default", "10 (0xA)", "0", True)
    ]


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        ("<DefaultData>0200</DefaultData>", "<DefaultData>02FF</DefaultData>", ("default data", "0200", "02FF", True)),
        ("<DefaultData>0200</DefaultData>", "", ("default data", "0200", None, False)),
        ("<MinValue>1</MinValue>", "<MinValue>2</MinValue>", ("minimum", "1", "2", True)),
        ("<MaxData>0A</MaxData>", "<MaxData>0B</MaxData>", ("maximum data", "0A", "0B", True)),
    ],
)
def test_a_record_as_a_whole_has_values(left, right, expected):
    ours, theirs = (RECORD.replace("</Object>", f"<Info>{values}</Info></Object>") for values in (left, right))
    assert told(objects(ours, types=record(GAIN)), objects(theirs, types=record(GAIN))) == [
        (f"0x8000 {expected[0]}", *expected[1:])
    ]


ENTRIES = record(member(1, "Gain", "UINT", 16, 16, f"<Flags>{RW}</Flags>"), member(2, "Serial", "UINT", 16, 32))
GAIN_DIFFERS = ("0x8000:01 default", "10 (0xA)", "11 (0xB)", True)


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        ("02000A00070000000000", "02000B00070000000000", [GAIN_DIFFERS]),
        ("02000A00070000000000", "02000A00080000000000", [("0x8000:02 default", "7", "8", False)]),  # it is read-only
        ("02000A000700000000ab", "02000A000700000000AB", []),
        (  # bits that no entry has: beside it, behind it, and those of an object of another length
            "02000A00070000000000",
            "02FF0A00070000000000",
            [("0x8000 default data", "02000A00070000000000", "02FF0A00070000000000", True)],
        ),
        (
            "02000A00070000000000",
            "02000B00070000000001",
            [("0x8000 default data", "02000A00070000000000", "02000B00070000000001", True), GAIN_DIFFERS],
        ),
        ("0200", "0300", [("0x8000 default data", "0200", "0300", True)]),
    ],
)
def test_data_of_a_whole_object_are_told_once(left, right, expected):
    """They are the defaults of its entries: 0x8000:01 in the third and fourth byte, 0x8000:02 behind it."""
    ours, theirs = (
        objects(RECORD.replace("</Object>", f"<Info><DefaultData>{data}</DefaultData></Info></Object>"), types=ENTRIES)
        for data in (left, right)
    )
    assert told(ours, theirs) == expected


def test_data_of_a_whole_object_and_defaults_of_its_entries_may_say_the_same():
    whole = RECORD.replace("</Object>", "<Info><DefaultData>02000A00070000000000</DefaultData></Info></Object>")
    parts = "".join(
        f"<SubItem><Name>{name}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>"
        for name, data in (("SubIndex 000", "02"), ("Gain", "0A00"), ("Serial", "0700"))
    )
    single_parts = RECORD.replace("</Object>", f"<Info>{parts}</Info></Object>")
    assert told(objects(whole, types=ENTRIES), objects(single_parts, types=ENTRIES)) == []
    other = objects(single_parts.replace("0A00", "0B00"), types=ENTRIES)
    assert told(objects(whole, types=ENTRIES), other) == [GAIN_DIFFERS]


def test_data_that_an_entry_contradicts_are_told_with_the_whole_object():
    """A default of its own counts more, so the entry does not tell that the data of the whole differ."""
    own = "<SubItem><Name>Gain</Name><Info><DefaultData>0C00</DefaultData></Info></SubItem>"
    ours, theirs = (
        objects(
            RECORD.replace("</Object>", f"<Info><DefaultData>{data}</DefaultData>{own}</Info></Object>"), types=ENTRIES
        )
        for data in ("02000A00070000000000", "02000B00070000000000")
    )
    (found,) = told(ours, theirs)
    assert found == ("0x8000 default data", "02000A00070000000000", "02000B00070000000000", True)


def enumeration(*values: tuple[int, str]) -> str:
    infos = "".join(f"<EnumInfo><Text>{words}</Text><Enum>{number}</Enum></EnumInfo>" for number, words in values)
    return f"<DataType><Name>DT0800EN08</Name><BaseType>USINT</BaseType><BitSize>8</BitSize>{infos}</DataType>"


def test_values_of_an_enumeration():
    one = single("#x7010", flags=RW, data_type="DT0800EN08", bits=8)
    csv, cst, csp = (9, "CSV"), (10, "CST"), (8, "CSP")
    both, three = objects(one, types=enumeration(csv, cst)), objects(one, types=enumeration(csv, cst, csp))
    assert told(both, three) == [("0x7010:00 enumeration", None, "8 CSP", False)]
    assert told(three, both) == [("0x7010:00 enumeration", "8 CSP", None, True)]
    renamed = objects(one, types=enumeration(csv, (10, "Torque")))
    assert told(both, renamed) == [("0x7010:00 enumeration", "10 CST", "10 Torque", False)]


def test_a_side_without_dictionary_is_one_difference():
    found = objects(single("#x2000"), single("#x2001"))
    profile = "<Profile><ProfileNo>402</ProfileNo></Profile>"
    assert told(found, profile) == [("object dictionary", "2 objects", None, True)]
    assert told(profile, found) == [("object dictionary", None, "2 objects", False)]


def test_a_variable_that_becomes_a_record():
    variable = single("#x8000", bits=80, name="Settings")
    found = told(objects(variable, types=record(GAIN)), objects(RECORD, types=record(GAIN)))
    assert found[0] == ("0x8000 kind", "VAR", "RECORD", True)
    assert ("0x8000:01", None, "Gain, UINT, 16 bit, ro", False) in found


def test_thousands_of_equal_objects_are_compared_at_once():
    many = [single(f"#x{index:X}", flags=RW) for index in range(0x2000, 0x3000)]
    assert told(objects(*many), objects(*many[:-1], single("#x2FFF", flags=RO))) == [
        ("0x2FFF:00 access", "rw", "ro", True)
    ]


def one_value(words: str) -> str:
    types = (
        "<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType><DataType><Name>E</Name>"
        f"<BaseType>USINT</BaseType><BitSize>8</BitSize><EnumInfo>{words}<Enum>1</Enum></EnumInfo></DataType>"
    )
    declared = "<Object><Index>#x2000</Index><Name>O</Name><Type>E</Type><BitSize>8</BitSize></Object>"
    return dictionary(types, declared)


def test_blanks_make_no_other_text_of_an_enumeration():
    assert told(one_value("<Text>300 mV</Text>"), one_value("<Text>300  mV</Text>")) == []


def test_a_value_without_text():
    assert told(one_value("<Text>on</Text>"), one_value("")) == [("0x2000:00 enumeration", "1 on", "1", False)]


@pytest.mark.parametrize(("category", "differs"), [("o", False), ("m", True), ("c", True)])
def test_an_object_is_optional_where_it_does_not_say_what_it_is(category, differs):
    """ETG.2000 Flags/Category: default o."""
    silent, said = objects(single("#x2000")), objects(single("#x2000", flags=f"<Category>{category}</Category>"))
    assert told(silent, said) == ([("0x2000:00 category", "o", category, False)] if differs else [])
    assert told(said, silent) == ([("0x2000:00 category", category, "o", False)] if differs else [])
