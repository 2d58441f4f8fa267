"""Lists of vendor,product,revision: separators, notations, headers, bad cells."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from esicatalog.scan.front import read_scan
from esicatalog.scan.records import ScanError


def identities(text: str) -> list[tuple[int, int, int | None]]:
    scan = read_scan(text)
    assert scan.format == "CSV"
    assert [slave.position for slave in scan.slaves] == list(range(len(scan.slaves)))
    return [(slave.vendor_id, slave.product_code, slave.revision_no) for slave in scan.slaves]


@pytest.mark.parametrize(
    "text",
    [
        "0x2,0x044c2c52,0x120000",
        "2;72100946;1179648\n",
        "#x2\t#x044C2C52\t#x00120000\r\n",
        '\ufeff\n"0x2" , "0x044c2c52" , "0x120000",,\n',
        "vendor,product,revision\n0x2,0x044c2c52,0x120000\n",
        "Vendor Id;Product code;Revision number\n2;0x044c2c52;1179648\n",
        "Revision_No,Product,VendorID\n0x120000,0x044c2c52,2\n",
    ],
)
def test_notations(text):
    assert identities(text) == [(2, 0x044C2C52, 0x120000)]


def test_the_revision_may_be_missing():
    assert identities("2,3\n2,4,\n\n0x2,5,6") == [(2, 3, None), (2, 4, None), (2, 5, 6)]
    assert identities("vendor,product\n2,3\n") == [(2, 3, None)]


def test_lines_are_those_of_the_text():
    assert [slave.line for slave in read_scan("\nvendor,product\n\n2,3\n2,4\n").slaves] == [4, 5]


def test_other_columns_are_told():
    scan = read_scan("vendor,product,revision,place\n2,3,4,cabinet\n")
    assert scan.slaves[0].revision_no == 4
    assert [(finding.line, finding.message) for finding in scan.findings] == [(1, "columns not read: 'place'")]


@pytest.mark.parametrize(
    "text",
    [
        "pos,vendor,product,revision\n0,2,3,4\n",
        "name;Vendor ID;Product Code;Revision No\n'Box; 1';2;3;4\n".replace("'", '"'),
        '"Name","vendor","product","revision"\n"Box 1, left","2","3","0x4"\n',
        '"of; all",vendor,product,revision\n"say ""a, b""",2,3,4\n',
        "#,vendor,product,revision\n1,2,3,4\n",
        '2,3,4,""\n',
    ],
)
def test_other_columns_and_quoted_cells(text):
    assert identities(text) == [(2, 3, 4)]


@pytest.mark.parametrize(
    "text", ["pos,name\n0,x\n", "the vendor, product and revision\n", '[{"vendor": 1, "product": 2},']
)
def test_a_line_that_names_no_device_is_no_header(text):
    with pytest.raises(ScanError, match="no scan is recognised"):
        read_scan(text)


def test_a_cell_without_end_is_told_with_its_line():
    with pytest.raises(ScanError, match=r"^line 2: field larger than field limit"):
        read_scan("vendor,product\n2," + "3" * 200_000 + "\n")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("2,3\n2,x\n", "line 2: product 'x' is not a number"),
        ("0x2,0xZZ", "line 1: product '0xZZ' is not a number"),
        ("2,3,4\n\n2,,4\n", "line 3: no product; expected vendor,product,revision"),
        ("2,3,4\n2\n", "line 2: no product; expected vendor,product,revision"),
        ("2,3,0x100000000\n", "line 1: revision '0x100000000' is larger than 0xffffffff"),
        ("2,3,4,5\n", "line 1: 4 cells where 3 are expected"),
        ("2,3,4\n2;3;4\n", "line 2: vendor '2;3;4' is not a number"),
        ("vendor,product,revision\n", "line 1: a header without any row"),
        ("vendor,name\n2,x\n", "line 1: the header names no column vendor and product"),
        ("vendor,product,product\n2,3,4\n", "line 1: the header names no column vendor and product"),
    ],
)
def test_a_bad_cell_names_its_line(text, message):
    with pytest.raises(ScanError) as caught:
        read_scan(text)
    assert str(caught.value).startswith(message)
    assert "\n" not in str(caught.value)


uint32 = st.integers(0, 0xFFFF_FFFF)
spelled = st.sampled_from(["0x{:x}", "#x{:08X}", "{}"])


@given(st.lists(st.tuples(uint32, uint32, st.none() | uint32), min_size=1), st.sampled_from(",;\t"), spelled)
def test_rows_come_back(rows, separator, spelling):
    text = "\n".join(
        separator.join("" if number is None else spelling.format(number) for number in row) for row in rows
    )
    assert identities(text) == rows
