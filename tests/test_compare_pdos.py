"""Comparing PDOs and default process images."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from snippets import pdo
from test_compare import op_mode, told

from esicatalog.model.compare_pdos import aligned

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"


def entry(index: str, subindex: int, bits: int, name: str = "e", data_type: str = "", attributes: str = "") -> str:
    typed = f"<DataType>{data_type}</DataType>" if data_type else ""
    return (
        f"<Entry {attributes}><Index>{index}</Index><SubIndex>{subindex}</SubIndex><BitLen>{bits}</BitLen>"
        f"<Name>{name}</Name>{typed}</Entry>"
    )


def tx(*entries: str, attributes: str = 'Sm="3"', index: str = "#x1A00") -> str:
    return f"{SMS}<TxPdo {attributes}><Index>{index}</Index><Name>T</Name>{''.join(entries)}</TxPdo>"


STATUS, POSITION, MODE = entry("#x6041", 0, 16), entry("#x6064", 0, 32), entry("#x6061", 0, 8)


def test_another_object_at_the_same_place():
    found = told(tx(STATUS, POSITION), tx(STATUS, entry("#x60FF", 0, 32)))
    assert found == [
        ("TxPDO 0x1A00 entry 2", "0x6064:00 (32 bit) e", "0x60FF:00 (32 bit) e", True),
        ("SM3 at 2.0", "0x6064:00 (32 bit) e", "0x60FF:00 (32 bit) e", True),
    ]


def test_an_entry_put_between_others_moves_those_behind_it():
    assert told(tx(STATUS, POSITION), tx(STATUS, MODE, POSITION)) == [
        ("TxPDO 0x1A00 entry 2", None, "0x6061:00 (8 bit) e", True),
        ("SM3 size", "6 bytes (48 bits)", "7 bytes (56 bits)", True),
        ("SM3 at 2.0", "0x6064:00 (32 bit) e", "0x6061:00 (8 bit) e", True),
        ("SM3 at 3.0", "inside 0x6064:00 (32 bit) from 2.0", "0x6064:00 (32 bit) e", True),
    ]


def test_an_entry_taken_out_at_the_end():
    assert told(tx(STATUS, MODE), tx(STATUS)) == [
        ("TxPDO 0x1A00 entry 2", "0x6061:00 (8 bit) e", None, True),
        ("SM3 size", "3 bytes (24 bits)", "2 bytes (16 bits)", True),
        ("SM3 at 2.0", "0x6061:00 (8 bit) e", None, True),
    ]


def test_only_the_first_places_are_told_one_by_one():
    channels = [entry("#x3101", n, 1) for n in range(1, 9)]
    others = [entry(f"#x60{n}0", 1, 1) for n in range(8)]
    found = [item for item in told(tx(*channels), tx(*others)) if item[0].startswith("SM3")]
    assert [place for place, *_ in found] == ["SM3 at 0.0", "SM3 at 0.1", "SM3 at 0.2", "SM3 from 0.3"]
    assert found[-1][1:3] == ("0x3101:04 (1 bit) e; 4 further places", "0x6030:01 (1 bit) e; 4 further places")


def test_names_and_types_of_entries():
    left = tx(entry("#x6041", 0, 16, "Status", "UINT16"))
    assert told(left, tx(entry("#x6041", 0, 16, "Statusword", "UINT"))) == [
        ("TxPDO 0x1A00 entry 1 name", "Status", "Statusword", False)
    ]
    assert told(left, tx(entry("#x6041", 0, 16, "Status", "INT"))) == [
        ("TxPDO 0x1A00 entry 1 data type", "UINT", "INT", True)
    ]
    assert told(tx(entry("#x6041", 0, 16, "Status")), left) == [("TxPDO 0x1A00 entry 1 data type", None, "UINT", False)]


def test_of_padding_only_the_length_says_something():
    named = "<Entry><Index>#x0</Index><SubIndex>0</SubIndex><BitLen>8</BitLen><Name>gap</Name></Entry>"
    plain = "<Entry><Index>0</Index><BitLen>{}</BitLen></Entry>"
    assert told(tx(named, STATUS), tx(plain.format(8), STATUS)) == []
    found = told(tx(plain.format(8), STATUS), tx(plain.format(16), STATUS))
    assert found[0] == ("TxPDO 0x1A00 entry 1", "padding (8 bit)", "padding (16 bit)", True)
    assert [place for place, *_ in found[1:]] == ["SM3 size", "SM3 at 1.0", "SM3 at 2.0"]


def test_one_gap_or_two_make_the_same_image():
    half = "<Entry><Index>0</Index><BitLen>4</BitLen></Entry>"
    whole = "<Entry><Index>0</Index><BitLen>8</BitLen></Entry>"
    places = [place for place, *_ in told(tx(half, half, STATUS), tx(whole, STATUS))]
    assert places
    assert all(place.startswith("TxPDO 0x1A00 entry") for place in places)


@pytest.mark.parametrize(
    ("attributes", "counts"), [('Sm="3"', True), ("", False), ('Mandatory="1"', True), ('Fixed="1"', False)]
)
def test_a_new_pdo_counts_when_it_is_assigned_or_mandatory(attributes, counts):
    one = tx(STATUS)
    found = told(one, one + pdo("TxPdo", "#x1A01", 8, attributes=attributes))
    assert (found[0][0], found[0][1], found[0][3]) == ("TxPDO 0x1A01", None, counts)


def test_a_lost_pdo_counts():
    one = tx(STATUS)
    assert told(one + pdo("TxPdo", "#x1A01", 8, 4, attributes='Fixed="1"'), one) == [
        ("TxPDO 0x1A01", "not assigned, 2 entries, 12 bit, fixed, TxPdo #x1A01", None, True)
    ]


@pytest.mark.parametrize(
    ("entries", "words"),
    [
        ("", "SM3, 0 entries, ? bit, p"),
        ("<Entry><Index>#x6000</Index></Entry>", "SM3, 1 entry, ? bit, p"),
        (f"{STATUS}<Entry><Index>#x6000</Index></Entry>", "SM3, 2 entries, at least 16 bit, p"),
    ],
)
def test_a_pdo_of_unknown_length_is_not_told_to_be_empty(entries, words):
    lost = f'<TxPdo Sm="3"><Index>#x1A01</Index><Name>p</Name>{entries}</TxPdo>'
    assert told(tx(STATUS) + lost, tx(STATUS))[0] == ("TxPDO 0x1A01", words, None, True)


def test_a_pdo_put_before_others_is_one_difference():
    pdos = [pdo("RxPdo", f"#x160{n}", 8) for n in range(4)]
    found = told("".join(pdos[1:]), "".join(pdos))
    assert [place for place, *_ in found] == ["RxPDO 0x1600"]


def test_pdos_that_repeat_an_index_are_matched_by_occurrence():
    first, second = pdo("RxPdo", "#x1602", 8), pdo("RxPdo", "#x1602", 16)
    assert told(first + second, first + second) == []
    assert [item[:3] for item in told(first + second, first)] == [
        ("RxPDO 0x1602", "not assigned, 1 entry, 16 bit, RxPdo #x1602", None)
    ]


def test_assignment_and_flags():
    # the entry of TxPDO 0x1A01 has 8 bits and joins the image
    other = pdo("TxPdo", "#x1A01", 8, attributes='Sm="3" Fixed="1"')
    found = told(tx(STATUS) + pdo("TxPdo", "#x1A01", 8), tx(STATUS) + other)
    assert found[:2] == [
        ("TxPDO 0x1A01 assignment", "not assigned", "SM3", True),
        ("TxPDO 0x1A01 Fixed", "no", "yes", True),
    ]
    assert found[2][:3] == ("SM3 size", "2 bytes (16 bits)", "3 bytes (24 bits)")
    back = told(tx(STATUS) + other, tx(STATUS) + other.replace('Fixed="1"', ""))
    assert back == [("TxPDO 0x1A01 Fixed", "yes", "no", False)]


def test_exclusions_are_symmetric_and_count_when_they_are_new():
    def three(first: str = "", second: str = "") -> str:
        return (
            pdo("RxPdo", "#x1600", 8, extra=first) + pdo("RxPdo", "#x1601", 8, extra=second) + pdo("RxPdo", "#x1602", 8)
        )

    on_first, on_second = "<Exclude>#x1601</Exclude>", "<Exclude>#x1600</Exclude>"
    assert told(three(on_first), three("", on_second)) == []
    assert told(three(), three(on_first)) == [
        ("PDO 0x1600 exclusions", None, "0x1601", True),
        ("PDO 0x1601 exclusions", None, "0x1600", True),
    ]
    assert [counts for *_, counts in told(three(on_first), three())] == [False, False]


def test_exclusions_of_a_new_pdo_are_told_with_it():
    old = pdo("RxPdo", "#x1600", 8)
    new = pdo("RxPdo", "#x1600", 8, extra="<Exclude>#x1601</Exclude>") + pdo("RxPdo", "#x1601", 8)
    assert [place for place, *_ in told(old, new)] == ["RxPDO 0x1601"]


def test_the_image_is_that_of_the_default_op_mode():
    pdos = SMS + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("RxPdo", "#x1601", 16)
    listed = op_mode("m", content='<Sm No="2"><Pdo>#x1601</Pdo></Sm>')
    found = told(f"{pdos}<Dc>{op_mode('m')}</Dc>", f"{pdos}<Dc>{listed}</Dc>")
    assert ("SM2 size", "1 byte (8 bits)", "2 bytes (16 bits)", True) in found


def test_predefined_assignments():
    def predefined(*names: str, default: str = "") -> str:
        marks = {default: 'Default="1"'}
        items = "".join(
            f"<AlternativeSmMapping {marks.get(name, '')}><Name>{name}</Name>"
            '<Sm No="2"><Pdo>#x1600</Pdo></Sm><Sm No="3"/></AlternativeSmMapping>'
            for name in names
        )
        return f"<Info><VendorSpecific><TwinCAT>{items}</TwinCAT></VendorSpecific></Info>"

    found = told(predefined("a", "b", default="a"), predefined("a", default="a"))
    assert ("predefined assignment b", "SM2: 0x1600; SM3: none", None, True) in found
    changed = told(predefined("a", default="a"), predefined("a"))
    assert ("predefined assignment a", "default; SM2: 0x1600; SM3: none", "SM2: 0x1600; SM3: none", True) in changed


items = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 1), st.sampled_from([None, 8])), max_size=8)


@given(items, items)
def test_alignment_keeps_everything_in_order_and_is_its_own_mirror(left, right):
    pairs = aligned(left, right)
    assert [position for position, _ in pairs if position is not None] == list(range(len(left)))
    assert sorted(other for _, other in pairs if other is not None) == list(range(len(right)))
    assert all(
        left[position] == right[other] or position == other
        for position, other in pairs
        if position is not None and other is not None
    )
    assert {(other, position) for position, other in pairs} == set(aligned(right, left))


@given(items)
def test_equal_lists_are_aligned_item_by_item(entries):
    assert aligned(entries, list(entries)) == [(number, number) for number in range(len(entries))]
