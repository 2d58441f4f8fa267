"""Lists of identities: ``vendor,product,revision`` a row, separated by comma, semicolon or tab.

The first row may be a header, which then says the order of the columns; others may stand among them, and cells be
quoted. Numbers are written ``0x2``, ``#x2`` or ``2``; the revision may be empty or have no column.
"""

import csv
import re
from collections.abc import Iterator

from esicatalog.errors import InputError
from esicatalog.identity import parse_number
from esicatalog.scan.records import Scan, ScanError, ScanFinding, ScannedSlave
from esicatalog.scan.text import numbered_lines

FORMAT = "CSV"

_FIRST_CELL = re.compile(
    r"\s*[\"']?(?:(?:0x|#x)[0-9a-z]*|[0-9]+|(?:vendor|product|revision)[ _a-z]*)[\"']?[ ]*[,;\t]", re.IGNORECASE
)
"""How such a list begins, unless its header has another column in front."""
_QUOTED = re.compile(r'"[^"]*"')
_IN_NAMES = re.compile(r"[\s_.:-]+")

_COLUMNS = ("vendor", "product", "revision")
_REQUIRED = 2
_HEADER_NAMES = {
    **dict.fromkeys(("vendor", "vendorid"), "vendor"),
    **dict.fromkeys(("product", "productcode", "productid"), "product"),
    **dict.fromkeys(("revision", "revisionno", "revisionnumber", "rev"), "revision"),
}

_Row = tuple[int, list[str]]


def is_list(text: str) -> bool:
    """Whether a cleaned text is such a list, by its first row."""
    if _FIRST_CELL.match(text):
        return True
    first = next(_rows(text), None)
    return first is not None and _names_device(_columns(first[1]))


def read_csv(text: str) -> Scan:
    """Read the cleaned text of a list. Raises :class:`ScanError` for a bad cell, naming its line."""
    rows = list(_rows(text))
    header_line, first = rows[0]
    findings: list[ScanFinding] = []
    columns: list[str | None] = list(_COLUMNS)
    if _names_device(_columns(first)) or not any(cell[:1] in ("#", *"0123456789") for cell in first):
        columns, findings = _header(header_line, first)
        rows = rows[1:]
    slaves = tuple(_slave(position, line, columns, cells) for position, (line, cells) in enumerate(rows))
    if not slaves:
        raise ScanError(f"line {header_line}: a header without any row of vendor,product,revision")
    return Scan(format=FORMAT, slaves=slaves, findings=tuple(findings))


def _rows(text: str) -> Iterator[_Row]:
    """The rows by line. Each line is a row: an opening quote without an end would take all others into its cell."""
    separator = None
    for number, line in numbered_lines(text):
        if separator is None:
            bare = _QUOTED.sub("", line)
            separator = next((mark for mark in "\t;," if mark in bare), ",")
        try:
            (cells,) = csv.reader([line], delimiter=separator, skipinitialspace=True)
        except csv.Error as error:
            raise ScanError(f"line {number}: {error}") from error
        yield number, [cell.strip().strip("\"'").strip() for cell in cells]


def _columns(header: list[str]) -> list[str | None]:
    return [_HEADER_NAMES.get(_IN_NAMES.sub("", cell.lower())) for cell in header]


def _names_device(columns: list[str | None]) -> bool:
    return all(name in columns for name in _COLUMNS[:_REQUIRED])


def _header(line: int, cells: list[str]) -> tuple[list[str | None], list[ScanFinding]]:
    columns = _columns(cells)
    if any(columns.count(name) != 1 for name in _COLUMNS[:_REQUIRED]) or columns.count("revision") > 1:
        raise ScanError(f"line {line}: the header names no column vendor and product; expected vendor,product,revision")
    ignored = [cell for cell, column in zip(cells, columns, strict=True) if column is None and cell]
    if not ignored:
        return columns, []
    return columns, [ScanFinding(line=line, message=f"columns not read: {', '.join(ignored)[:200]!a}")]


def _slave(position: int, line: int, columns: list[str | None], cells: list[str]) -> ScannedSlave:
    if any(cells[len(columns) :]):
        raise ScanError(f"line {line}: {len(cells)} cells where {len(columns)} are expected (vendor,product,revision)")
    texts = dict(zip(columns, cells, strict=False))
    numbers = {name: _number(texts.get(name, ""), name, line) for name in _COLUMNS}
    for name in _COLUMNS[:_REQUIRED]:
        if numbers[name] is None:
            raise ScanError(f"line {line}: no {name}; expected vendor,product,revision")
    return ScannedSlave(
        line=line,
        position=position,
        vendor_id=numbers["vendor"],
        product_code=numbers["product"],
        revision_no=numbers["revision"],
    )


def _number(text: str, what: str, line: int) -> int | None:
    if not text:
        return None
    try:
        return parse_number(text, what)
    except InputError as error:
        raise ScanError(f"line {line}: {error}") from error
