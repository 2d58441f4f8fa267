"""The resolved object dictionary: arrays, records, defaults, pairing, inheritance (ESI-FACTS sections 6 and 7)."""

import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st
from snippets import device, dictionary, esi, only_device

from esicatalog.esi.records.dictionary import DataType, SubItem
from esicatalog.model.base_types import BASE_TYPES, base_type
from esicatalog.model.dictionary import resolve_base, resolve_object, type_table, used_types

SI0 = (
    "<SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs>"
    "</SubItem>"
)
PLAIN_TYPES = "".join(
    f"<DataType><Name>{name}</Name><BitSize>{bits}</BitSize></DataType>"
    for name, bits in (("BOOL", 1), ("USINT", 8), ("UINT", 16), ("INT", 16), ("UDINT", 32), ("REAL", 32))
)


def resolve(types: str, object_type: str, bits: int, extra: str = ""):
    """Resolve one object 0x2000 of a type."""
    declared = f"<Object><Index>#x2000</Index><Name>Object</Name><Type>{object_type}</Type><BitSize>{bits}</BitSize>"
    found = only_device(esi(device(dictionary(PLAIN_TYPES + types, f"{declared}{extra}</Object>"))))
    inner = found.profiles[0].dictionary
    return resolve_object(inner.objects[0], type_table(inner.data_types))


def simple(object_type: str, info: str, bits: int = 32, types: str = ""):
    """The one entry of a plain object with an Info element."""
    (entry,) = resolve(types, object_type, bits, f"<Info>{info}</Info>").entries
    return entry


def sub_item(number: int | None, name: str, flags: str = "", type_name: str = "UINT", bits: int = 16, extra: str = ""):
    index = f"<SubIdx>{number}</SubIdx>" if number is not None else ""
    offset = 16 * (number or 1)
    return (
        f"<SubItem>{index}<Name>{name}</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs>{extra}{flags}</SubItem>"
    )


def record(*items: str) -> str:
    return f"<DataType><Name>DT2000</Name><BitSize>64</BitSize>{SI0}{''.join(items)}</DataType>"


def info(*named: tuple[str, str]) -> str:
    items = (
        f"<SubItem><Name>{name}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>" for name, data in named
    )
    return f"<Info>{''.join(items)}</Info>"


ARRAY_A = (
    "<DataType><Name>DT2000ARR</Name><BaseType>UDINT</BaseType><BitSize>96</BitSize>"
    "<ArrayInfo><LBound>1</LBound><Elements>3</Elements></ArrayInfo></DataType>"
    f"<DataType><Name>DT2000</Name><BitSize>112</BitSize>{SI0}<SubItem><Name>Elements</Name><Type>DT2000ARR</Type>"
    "<BitSize>96</BitSize><BitOffs>16</BitOffs></SubItem></DataType>"
)
ARRAY_B = (
    "<DataType><Name>ARRAY [0..7] OF BYTE</Name><BaseType>BYTE</BaseType><BitSize>64</BitSize>"
    "<ArrayInfo><LBound>0</LBound><Elements>8</Elements></ArrayInfo></DataType>"
    f"<DataType><Name>DT2000</Name><BitSize>80</BitSize>{SI0}<SubItem><SubIdx>1</SubIdx><Name>SubIndex 001</Name>"
    "<Type>ARRAY [0..7] OF BYTE</Type><BitSize>64</BitSize><BitOffs>16</BitOffs></SubItem></DataType>"
)


def test_a_plain_object_is_one_entry_with_subindex_0():
    resolved = resolve("", "UDINT", 32)
    (entry,) = resolved.entries
    assert resolved.object_code == 7
    assert (entry.subindex, entry.name, entry.bit_size, entry.bit_offset) == (0, "Object", 32, 0)
    assert (entry.base_type, entry.access, entry.access_word) == ("UDINT", "ro", 0b000_111)


def test_arrays_of_idiom_a_are_expanded():
    resolved = resolve(ARRAY_A, "DT2000", 112)
    assert resolved.object_code == 8
    assert [(e.subindex, e.name, e.bit_size, e.bit_offset) for e in resolved.entries] == [
        (0, "SubIndex 000", 8, 0),
        (1, "SubIndex 001", 32, 16),
        (2, "SubIndex 002", 32, 48),
        (3, "SubIndex 003", 32, 80),
    ]
    assert [e.base_type for e in resolved.entries] == ["USINT", "UDINT", "UDINT", "UDINT"]


def test_an_array_type_is_expanded_even_with_a_subindex():
    numbered = ARRAY_A.replace("<SubItem><Name>Elements", "<SubItem><SubIdx>1</SubIdx><Name>Elements")
    assert numbered != ARRAY_A
    assert [e.subindex for e in resolve(numbered, "DT2000", 112).entries] == [0, 1, 2, 3]


def test_arrays_of_idiom_b_stay_one_octet_string():
    resolved = resolve(ARRAY_B, "DT2000", 80, info(("SubIndex 000", "01"), ("SubIndex 001", "0011223344556677")))
    assert resolved.object_code == 9
    assert [(e.subindex, e.bit_size, e.base_type) for e in resolved.entries] == [
        (0, 8, "USINT"),
        (1, 64, "OCTET_STRING"),
    ]
    assert resolved.entries[1].default_raw == "0011223344556677"


@pytest.mark.parametrize(
    ("type_name", "data", "number"),
    [
        ("USINT", "FF", 255),
        ("SINT", "FF", -1),
        ("UINT", "8001", 0x180),
        ("INT", "00FE", -512),
        ("UDINT", "80010000", 0x180),
        ("DINT", "FEFFFFFF", -2),
        ("ULINT", "0100000000000000", 1),
        ("LINT", "FFFFFFFFFFFFFFFF", -1),
        ("INT24", "FFFFFF", -1),
        ("UINT40", "0000000001", 1 << 32),
        ("BOOL", "01", 1),
        ("BOOL", "00", 0),
        ("DWORD", "0000000A", 0x0A00_0000),
        ("BIT3", "05", 5),
        ("ULINT", "FFFFFFFFFFFFFFFF", None),
    ],
)
def test_default_data_of_integers_is_little_endian(type_name, data, number):
    entry = simple(type_name, f"<DefaultData>{data}</DefaultData>")
    assert (entry.default_raw, entry.default_kind, entry.default_int) == (data, "data", number)


@pytest.mark.parametrize(
    ("type_name", "text", "number"),
    [
        ("LINT", "#xFFFFFFFFFFFFFFFF", -1),
        ("LINT", "#x8000000000000001", 1 - 2**63),
        ("LINT", "#x7FFFFFFFFFFFFFFF", 2**63 - 1),
        ("LINT", "#x8000000000000000", None),  # no database keeps it with its opposite
        ("ULINT", "#xFFFFFFFFFFFFFFFF", None),
        ("LINT", "#x1FFFFFFFFFFFFFFFF", None),
    ],
)
def test_default_value_of_64_bits(type_name, text, number):
    entry = simple(type_name, f"<DefaultValue>{text}</DefaultValue>")
    assert (entry.default_raw, entry.default_kind, entry.default_int) == (text, "value", number)


@pytest.mark.parametrize(("type_name", "layout", "number"), [("REAL", "<f", 0.5), ("LREAL", "<d", -1.1)])
def test_default_data_of_floats(type_name, layout, number):
    entry = simple(type_name, f"<DefaultData>{struct.pack(layout, number).hex()}</DefaultData>")
    assert entry.default_real == number
    assert entry.default_int is None


@pytest.mark.parametrize(
    ("type_name", "bits", "data", "number"),
    [
        ("INT", 16, "FF", 0x00FF),
        ("DINT", 32, "FFFF", 0x0000FFFF),
        ("LINT", 64, "FFFFFFFF", 0x00000000FFFFFFFF),
        ("INT", 16, "FFFF0000", -1),
        ("INT", 16, "0080FFFF", -0x8000),
        ("SINT", 8, "7FFF", 0x7F),
        ("USINT", 8, "02000000", 2),
        ("UDINT", 32, "010203040506", 0x04030201),
        ("DINT", 16, "FFFF", -1),
        ("DINT", 16, "FFFFFFFF", -1),
        ("DINT", 16, "FF", 0xFF),
        ("INT", 0, "FFFF00", -1),
    ],
)
def test_numbers_with_too_few_or_too_many_bytes(type_name, bits, data, number):
    """Missing bytes were filled with the sign, and all bytes counted whatever the type can hold."""
    entry = simple(type_name, f"<DefaultData>{data}</DefaultData>", bits)
    assert (entry.default_raw, entry.default_int) == (data, number)


def test_limits_with_too_few_or_too_many_bytes():
    entry = simple("INT", "<MinData>80</MinData><MaxData>FFFF0000</MaxData>", 16)
    assert (entry.min_int, entry.max_int) == (0x80, -1)


def test_a_float_with_too_many_bytes():
    data = struct.pack("<f", 0.5).hex() + "FFFFFFFF"
    assert simple("REAL", f"<DefaultData>{data}</DefaultData>", 32).default_real == 0.5


def test_default_data_that_is_no_number():
    assert simple("REAL", "<DefaultData>0000C07F</DefaultData>").default_real is None  # a NaN
    assert simple("UDINT", "<DefaultData>123</DefaultData>").default_int is None
    assert simple("UDINT", "<DefaultData>123</DefaultData>").default_raw == "123"
    empty = simple("UDINT", "<DefaultData></DefaultData>")
    assert (empty.default_raw, empty.default_int) == (None, None)


def test_default_data_of_texts():
    assert simple("STRING(6)", "<DefaultData>4D6178B00000</DefaultData>").default_text == "Max°"
    assert simple("UNICODE_STRING(2)", "<DefaultData>1F5B0000</DefaultData>").default_text == "\u5b1f"


def test_default_values_and_strings():
    assert simple("DINT", "<DefaultValue>-5</DefaultValue>").default_int == -5
    by_hex = simple("UDINT", "<DefaultValue>#x1A</DefaultValue>")
    assert (by_hex.default_int, by_hex.default_kind, by_hex.default_raw) == (26, "value", "#x1A")
    assert simple("REAL", "<DefaultValue>3</DefaultValue>").default_real == 3.0
    assert simple("STRING(3)", "<DefaultString>abc</DefaultString>").default_text == "abc"
    assert simple("UINT", "<DefaultString>#x10</DefaultString>").default_int == 16
    assert simple("UINT", "<DefaultString>ten</DefaultString>").default_text == "ten"


@pytest.mark.parametrize(
    "empty", ["<DefaultValue/>", "<DefaultValue> </DefaultValue>", "<DefaultValue><![CDATA[ ]]></DefaultValue>"]
)
def test_an_empty_default_value_is_none(empty):
    entry = simple("UINT", empty)
    assert (entry.default_raw, entry.default_kind, entry.default_int) == (None, None, None)
    entry = simple("UINT", f"{empty}<DefaultString>7</DefaultString>")
    assert (entry.default_raw, entry.default_kind, entry.default_int) == ("7", "string", 7)
    value = "<DefaultValue>7</DefaultValue>"
    typed = ARRAY_B.replace("</BitOffs></SubItem>", f"</BitOffs>{value}</SubItem>", 1)
    (count, _) = resolve(
        typed, "DT2000", 80, f"<Info><SubItem><Name>SubIndex 000</Name><Info>{empty}</Info></SubItem></Info>"
    ).entries
    assert (count.default_raw, count.default_int) == ("7", 7)


def test_access_is_written_in_one_way():
    (entry,) = resolve("", "UINT", 16, "<Flags><Access>RW</Access></Flags>").entries
    assert (entry.access, entry.access_word) == ("rw", 0b111_111)


@pytest.mark.parametrize(("text", "number"), [("10", 10.0), (" -1.5", -1.5), ("2e3", 2000.0), ("ten", None)])
def test_a_default_string_of_a_real(text, number):
    entry = simple("REAL", f"<DefaultString>{text}</DefaultString>")
    assert (entry.default_real, entry.default_int) == (number, None)
    assert (entry.default_text is None) == (number is not None)


def test_limits_in_both_forms():
    entry = simple("INT", "<MinData>00FF</MinData><MaxData>FF00</MaxData><DefaultData>0100</DefaultData>", 16)
    assert (entry.min_int, entry.max_int, entry.default_int) == (-256, 255, 1)
    entry = simple("INT", "<MinValue>-3</MinValue><MaxValue>#x7</MaxValue><DefaultData>0100</DefaultData>", 16)
    assert (entry.min_int, entry.max_int, entry.default_int) == (-3, 7, 1)


@given(st.integers(-(2**31), 2**31 - 1))
def test_signed_defaults_come_back(number):
    assert (
        simple("DINT", f"<DefaultData>{number.to_bytes(4, 'little', signed=True).hex()}</DefaultData>").default_int
        == number
    )


def defaults(resolved) -> list[int | None]:
    return [entry.default_int for entry in resolved.entries]


def test_array_values_with_subindex_0_are_positional():
    named = info(("a", "03"), ("b", "0B000000"), ("c", "0C000000"), ("d", "0D000000"))
    assert defaults(resolve(ARRAY_A, "DT2000", 112, named)) == [3, 11, 12, 13]


def test_array_values_whose_names_number_all_subindices_go_to_these():
    named = info(
        ("SubIndex 001", "0B000000"), ("SubIndex 000", "03"), ("SubIndex 003", "0D000000"), ("SubIndex 2", "0C")
    )
    assert defaults(resolve(ARRAY_A, "DT2000", 112, named)) == [3, 11, 12, 13]
    shifted = info(*((f"SubIndex 00{n + 1}", f"0{n}") for n in range(4)))
    assert defaults(resolve(ARRAY_A, "DT2000", 112, shifted)) == [0, 1, 2, 3], "no number of one is missing"


def test_a_name_with_a_number_that_no_subindex_has_is_a_name():
    named = info((f"SubIndex {'9' * 5000}", "0B000000"))
    assert defaults(resolve(ARRAY_A, "DT2000", 112, named)) == [None] * 4


def test_array_values_without_subindex_0():
    named = info(("SubIndex 001", "0B000000"), ("SubIndex 002", "0C000000"), ("SubIndex 003", "0D000000"))
    assert defaults(resolve(ARRAY_A, "DT2000", 112, named)) == [None, 11, 12, 13]
    unnamed = info(("x", "0B000000"), ("y", "0C000000"), ("z", "0D000000"))
    assert defaults(resolve(ARRAY_A, "DT2000", 112, unnamed)) == [None, 11, 12, 13]


def test_some_array_values_go_to_their_numbers():
    assert defaults(resolve(ARRAY_A, "DT2000", 112, info(("SubIndex 003", "0D000000")))) == [None, None, None, 13]
    assert defaults(resolve(ARRAY_A, "DT2000", 112, info(("Subindex 2", "0C000000")))) == [None, None, 12, None]
    assert defaults(resolve(ARRAY_A, "DT2000", 112)) == [None] * 4


RECORD = record(sub_item(1, "One"), sub_item(2, "Two"), sub_item(5, "Five"))


def test_record_values_go_by_name():
    resolved = resolve(
        RECORD, "DT2000", 96, info(("SubIndex 000", "05"), ("One", "0100"), ("Two", "0200"), ("Five", "0500"))
    )
    assert [e.subindex for e in resolved.entries] == [0, 1, 2, 5], "gaps in the subindices are legal"
    assert defaults(resolved) == [5, 1, 2, 5]
    assert resolved.remarks == ()


def test_a_subset_of_record_values_is_never_shifted():
    assert defaults(resolve(RECORD, "DT2000", 96, info(("Two", "0200")))) == [None, None, 2, None]
    assert defaults(resolve(RECORD, "DT2000", 96, info(("Five", "0500"), ("One", "0100")))) == [None, 1, None, 5]


def test_reordered_record_values_go_by_name():
    named = info(("Five", "0500"), ("Two", "0200"), ("One", "0100"), ("SubIndex 000", "05"))
    assert defaults(resolve(RECORD, "DT2000", 96, named)) == [5, 1, 2, 5]


def test_duplicate_names_are_paired_in_order():
    types = record(sub_item(1, "Reserved"), sub_item(2, "Two"), sub_item(3, "Reserved"))
    named = info(("Reserved", "0100"), ("Two", "0200"), ("Reserved", "0300"))
    assert defaults(resolve(types, "DT2000", 96, named)) == [None, 1, 2, 3]


def test_names_that_match_nothing_are_left_unpaired_with_a_remark():
    resolved = resolve(RECORD, "DT2000", 96, info(("Two", "0200"), ("Other", "0900")))
    assert defaults(resolved) == [None, None, 2, None]
    assert resolved.remarks == ("Info sub-items 'Other' match no sub-item of the data type; left unpaired",)


def test_other_names_of_equal_count_are_paired_by_position_with_a_remark():
    named = info(("number", "05"), ("eins", "0100"), ("zwei", "0200"), ("fünf", "0500"))
    resolved = resolve(RECORD, "DT2000", 96, named)
    assert defaults(resolved) == [5, 1, 2, 5]
    assert resolved.remarks == (
        "Info sub-items 'number', 'eins', 'zwei' match no sub-item of the data type; paired by position",
    )


def test_an_unmatched_name_moves_no_value_that_has_its_name():
    """One value too many and one missing, so the list is as long as the type: all went to their neighbours."""
    named = info(("SubIndex 000", "05"), ("Two", "0200"), ("Five", "0500"), ("Six", "0600"))
    resolved = resolve(RECORD, "DT2000", 96, named)
    assert defaults(resolved) == [5, None, 2, 5]
    assert resolved.remarks == ("Info sub-items 'Six' match no sub-item of the data type; left unpaired",)


def test_the_position_says_nothing_among_values_in_another_order():
    named = info(("SubIndex 000", "05"), ("Five", "0500"), ("One", "0100"), ("Zwei", "0200"))
    assert defaults(resolve(RECORD, "DT2000", 96, named)) == [5, 1, None, 5]


def test_a_name_too_many_leaves_the_value_that_has_it_in_its_place():
    named = info(("SubIndex 000", "05"), ("Two", "0100"), ("Two", "0200"), ("Five", "0500"))
    assert defaults(resolve(RECORD, "DT2000", 96, named)) == [5, 1, 2, 5]


def test_a_misspelt_name_among_matching_ones_goes_by_its_position():
    named = info(("SubIndex 000", "05"), ("One", "0100"), ("Tow", "0200"), ("Five", "0500"))
    resolved = resolve(RECORD, "DT2000", 96, named)
    assert defaults(resolved) == [5, 1, 2, 5]
    assert resolved.remarks == ("Info sub-items 'Tow' match no sub-item of the data type; paired by position",)


def member(number: int, name: str, type_name: str, bits: int, offset: int, extra: str = "") -> str:
    return (
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{name}</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs>{extra}</SubItem>"
    )


def whole(data: str, *members: str, bits: int = 64, extra: str = ""):
    """What the entries of an object are that has DefaultData as a whole: raw text and number of each."""
    resolved = resolve(record(*members), "DT2000", bits, f"<Info><DefaultData>{data}</DefaultData>{extra}</Info>")
    return [(entry.default_raw, entry.default_int) for entry in resolved.entries]


NONE = (None, None)
TWO_MAPPED = (member(1, "a", "UDINT", 32, 16), member(2, "b", "INT", 16, 48))


def test_data_of_the_whole_object_are_those_of_its_entries():
    """Two entries; 0x70100101 and -2, little-endian, behind a byte of padding."""
    assert whole("0200" + "01011070" + "FEFF", *TWO_MAPPED) == [("02", 2), ("01011070", 0x70100101), ("FEFF", -2)]


def test_elements_of_an_array_have_their_part_of_the_data_of_the_whole():
    data = "<Info><DefaultData>0300000001000000020000000300</DefaultData></Info>"
    resolved = resolve(ARRAY_A, "DT2000", 112, data)
    assert defaults(resolved) == [3, 0x10000, 0x20000, 0x30000]


@pytest.mark.parametrize(
    ("type_name", "bits", "offset", "expected"),
    [
        ("BOOL", 1, 16, ("01", 1)),  # 0xC5 is 1100 0101
        ("BOOL", 1, 17, ("00", 0)),
        ("USINT", 3, 18, ("01", 1)),
        ("UINT", 12, 20, ("3C0A", 0xA3C)),  # 0xA3 behind it
        ("UINT", 9, 16, ("C501", 0x1C5)),
        ("INT", 4, 20, NONE),  # how a signed number is cut is not said
        ("REAL", 32, 17, NONE),
        ("UNKNOWN", 4, 16, NONE),
        ("UNKNOWN", 8, 16, ("C5", None)),
    ],
)
def test_bit_fields_of_whole_numbers_have_their_bits_of_the_data(type_name, bits, offset, expected):
    assert whole("0100C5A300000000", member(1, "a", type_name, bits, offset)) == [("01", 1), expected]


@pytest.mark.parametrize(
    ("data", "members", "bits"),
    [
        ("02000101107000", TWO_MAPPED, 64),  # one byte short
        ("020001011070FEFF00", TWO_MAPPED, 64),
        ("020001011070FEFX", TWO_MAPPED, 64),
        ("020001011070", TWO_MAPPED, 48),  # the last entry lies behind the object
        ("020001011070FEFF", (member(1, "a", "UDINT", 32, 16), member(2, "b", "INT", 16, 32)), 64),  # overlapping
        ("020001011070FEFF", (member(1, "a", "UDINT", 32, 0),), 64),
        ("020001011070FEFF", (member(1, "a", "UDINT", 32, -16),), 64),
    ],
)
def test_data_that_do_not_fit_the_object_say_nothing_of_its_entries(data, members, bits):
    assert set(whole(data, *members, bits=bits)) == {NONE}


def test_a_default_of_its_own_counts_more_than_the_data_of_the_whole_object():
    own = member(1, "a", "UDINT", 32, 16, "<DefaultData>07000000</DefaultData>")
    assert whole("020001011070FEFF", own, TWO_MAPPED[1])[1:] == [("07000000", 7), ("FEFF", -2)]
    info_of_b = "<SubItem><Name>b</Name><Info><DefaultData>0900</DefaultData></Info></SubItem>"
    assert whole("020001011070FEFF", *TWO_MAPPED, extra=info_of_b)[1:] == [("01011070", 0x70100101), ("0900", 9)]


def flags(access: str = "", **more: str) -> str:
    head = f"<Access>{access}</Access>" if access else ""
    return f"<Flags>{head}{''.join(f'<{k}>{v}</{k}>' for k, v in more.items())}</Flags>"


OBJECT_FLAGS = flags("rw", Category="m", PdoMapping="R", SafetyMapping="SI", Backup="1", Setting="1")


def test_a_plain_object_has_its_own_flags():
    (entry,) = resolve("", "UINT", 16, OBJECT_FLAGS).entries
    assert (entry.access, entry.category, entry.pdo_mapping, entry.safety_mapping) == ("rw", "m", "R", "si")
    assert entry.access_word == 0b11_01_111_111


def test_a_member_without_flags_inherits_all_six_from_the_object():
    entry = resolve(RECORD, "DT2000", 96, OBJECT_FLAGS).entries[1]
    assert (entry.access, entry.category, entry.pdo_mapping, entry.safety_mapping) == ("rw", "m", "R", "si")
    assert entry.access_word == 0b11_01_111_111


def test_a_member_with_flags_inherits_nothing():
    types = record(sub_item(1, "One", flags("wo")), sub_item(2, "Two", "<Flags/>"))
    _, one, two = resolve(types, "DT2000", 96, OBJECT_FLAGS).entries
    assert (one.access, one.category, one.pdo_mapping, one.safety_mapping) == ("wo", None, None, None)
    assert one.access_word == 0b111_000
    assert (two.access, two.access_word) == ("ro", 0b000_111)


ALL, PREOP, SAFEOP, OP = 0b111, 1, 2, 4


@pytest.mark.parametrize(
    ("access", "read", "write"),
    [
        ("<Access>ro</Access>", ALL, 0),
        ("<Access>rw</Access>", ALL, ALL),
        ("<Access>wo</Access>", 0, ALL),
        ("<Access>RW</Access>", ALL, ALL),
        ('<Access WriteRestrictions="PreOP">rw</Access>', ALL, PREOP),
        ('<Access WriteRestrictions="PreOp">rw</Access>', ALL, PREOP),
        ('<Access WriteRestrictions="PreOP_SafeOP">rw</Access>', ALL, PREOP | SAFEOP),
        ('<Access WriteRestrictions="PreOP_OP">rw</Access>', ALL, PREOP | OP),
        ('<Access ReadRestrictions="SafeOP" WriteRestrictions="SafeOP_OP">rw</Access>', SAFEOP, SAFEOP | OP),
        ('<Access ReadRestrictions="OP">ro</Access>', OP, 0),
        ('<Access WriteRestrictions="PreOP">ro</Access>', ALL, 0),
        ("<Access>r3w7</Access>", PREOP | SAFEOP, ALL),
        ("<Access>r7w0</Access>", ALL, 0),
        ("", ALL, 0),
    ],
)
def test_access_words(access, read, write):
    (entry,) = resolve("", "UINT", 16, f"<Flags>{access}</Flags>").entries
    assert entry.access_word == read | write << 3


@pytest.mark.parametrize(
    ("text", "mapping", "bits"), [("T", "T", 0x80), ("r", "R", 0x40), ("tr", "RT", 0xC0), ("RT", "RT", 0xC0)]
)
def test_pdo_mapping(text, mapping, bits):
    (entry,) = resolve("", "UINT", 16, flags("ro", PdoMapping=text)).entries
    assert entry.pdo_mapping == mapping
    assert entry.access_word == 0b111 | bits


@pytest.mark.parametrize(
    ("name", "base", "code", "bits"),
    [
        ("UDINT", "UDINT", 0x07, 32),
        ("BOOL", "BOOL", 0x01, 1),
        ("BOOLEAN", "BOOL", 0x01, 1),
        ("BIT", "BOOL", 0x01, 1),
        ("BIT1", "BIT1", 0x30, 1),
        ("BIT8", "BIT8", 0x37, 8),
        ("BIT16", "BIT16", 0x3F, 16),
        ("BITARR16", "BITARR16", 0x2E, 16),
        ("INT24", "INT24", 0x10, 24),
        ("UINT56", "UINT56", 0x1A, 56),
        ("UINT16", "UINT", 0x06, 16),
        ("INT8", "SINT", 0x02, 8),
        ("UNSIGNED32", "UDINT", 0x07, 32),
        ("INTEGER16", "INT", 0x03, 16),
        ("REAL32", "REAL", 0x08, 32),
        ("LREAL", "LREAL", 0x11, 64),
        ("STRING(10)", "STRING", 0x09, 80),
        ("STRING (10)", "STRING", 0x09, 80),
        ("STRING(0)", "STRING", 0x09, 0),
        ("OCTET_STRING(4)", "OCTET_STRING", 0x0A, 32),
        ("UNICODE_STRING(4)", "UNICODE_STRING", 0x0B, 64),
        ("ARRAY [0..7] OF BYTE", "OCTET_STRING", 0x0A, 64),
        ("ARRAY [0..3] OF UINT", "UNICODE_STRING", 0x0B, 64),
        ("TIME_OF_DAY", "TIME_OF_DAY", 0x0C, 48),
        ("GUID", "GUID", 0x1D, 128),
    ],
)
def test_base_types_and_what_vendors_call_them(name, base, code, bits):
    found = base_type(name)
    assert (found.name, found.code, found.bit_size) == (base, code, bits)


def test_signed_types_are_the_integers():
    assert {name for name, base in BASE_TYPES.items() if base.signed} == {
        *("SINT", "INT", "DINT", "LINT"),
        *("INT24", "INT40", "INT48", "INT56"),
    }


@pytest.mark.parametrize("name", ["", None, "DT1018", "U", "STRING(x)"])
def test_what_is_no_base_type(name):
    assert base_type(name) is None


def enum(name: str, base: str) -> str:
    return (
        f"<DataType><Name>{name}</Name><BaseType>{base}</BaseType><BitSize>8</BitSize>"
        "<EnumInfo><Text>on</Text><Enum>1</Enum></EnumInfo></DataType>"
    )


def test_base_types_are_followed_through_chains():
    entry = simple("E2", "<DefaultData>FF</DefaultData>", 8, enum("E2", "E1") + enum("E1", "SINT"))
    assert (entry.data_type, entry.base_type, entry.default_int) == ("E2", "SINT", -1)


def test_cyclic_types_end():
    entry = simple("E1", "<DefaultData>FF</DefaultData>", 8, enum("E1", "E2") + enum("E2", "E1"))
    assert (entry.base_type, entry.default_raw, entry.default_int) == (None, "FF", None)
    loop = f"<DataType><Name>DT2000</Name><BitSize>8</BitSize>{SI0}{sub_item(1, 'Self', type_name='DT2000')}</DataType>"
    assert len(resolve(loop, "DT2000", 32).entries) == 2


def test_a_declared_bit_size_decides_not_the_name():
    (entry,) = resolve("", "UDINT", 24).entries
    assert entry.bit_size == 24


def test_type_names_are_scoped_to_a_dictionary():
    types = type_table(only_device(esi(device(dictionary(enum("X", "SINT"), "")))).profiles[0].dictionary.data_types)
    assert resolve_base("X", types).name == "SINT"
    assert resolve_base("X", {}) is None


def test_obsolete_defaults_of_the_type_count_where_the_object_has_none():
    types = record(
        sub_item(1, "One", extra="<MinValue>1</MinValue><MaxValue>9</MaxValue><DefaultValue>5</DefaultValue>")
    )
    entry = resolve(types, "DT2000", 32).entries[1]
    assert (entry.default_int, entry.min_int, entry.max_int) == (5, 1, 9)
    assert defaults(resolve(types, "DT2000", 32, info(("One", "0700")))) == [None, 7]


@pytest.mark.parametrize(
    ("type_name", "bits", "minimum", "number"),
    [
        ("DINT", 32, "#xFFF80000", -524288),
        ("DINT", 32, "0x7FFFFFFF", 0x7FFFFFFF),
        ("INT", 16, "#x8000", -32768),
        ("INT", 16, "-5", -5),
        ("UDINT", 32, "#xFFF80000", 0xFFF80000),
        ("INT", 16, "65535", 65535),
    ],
)
def test_negative_numbers_written_as_their_bits(type_name, bits, minimum, number):
    """A DINT with MinValue #xFFF80000 was kept as +4294443008."""
    data_type = f"<DataType><Name>{type_name}</Name><BitSize>{bits}</BitSize></DataType>"
    declared = (
        f"<Object><Index>#x2000</Index><Name>O</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<Info><MinValue>{minimum}</MinValue></Info></Object>"
    )
    (found,) = only_device(esi(device(dictionary(data_type, declared)))).profiles
    (item,) = found.dictionary.objects
    (entry,) = resolve_object(item, type_table(found.dictionary.data_types)).entries
    assert entry.min_int == number


def test_a_type_leads_to_its_sub_items_in_order_then_to_its_base_type_each_once():
    def data_type(name: str, *inner: str, base: str | None = None) -> DataType:
        return DataType(name=name, base_type=base, sub_items=tuple(SubItem(type=item) for item in inner))

    a, b, c, d = (
        data_type("A", "C", "D", "C", "UINT", base="B"),
        data_type("B"),
        data_type("C", "A"),
        data_type("D", "D"),
    )
    types = type_table((a, b, c, d))
    assert used_types("A", types) == (a, c, d, b)
    assert used_types("D", types) == (d,)
    assert used_types("UINT", types) == used_types(None, types) == ()
