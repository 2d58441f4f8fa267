"""Lists of identities: ``vendor,product,revision`` a row, separated by comma, semicolon or tab.

The first row may be a header, which then says the order of the columns. Numbers are written ``0x2``, ``#x2`` or
``2``; the revision may be empty or have no column.
"""

import re

from esicatalog.errors import InputError
from esicatalog.identity import parse_number
from esicatalog.scan.records import Scan, ScanError, ScanFinding, ScannedSlave
from esicatalog.scan.text import numbered_lines

FORMAT = "CSV"

FIRST_CELL = re.compile(
    r"\s*[\"']?(?:(?:0x|#x)[0-9a-z]*|[0-9]+|(?:vendor|product|revision)[ _a-z]*)[\"']?[ ]*[,;\t]", re.IGNORECASE
)
"""How such a list begins."""

_COLUMNS = ("vendor", "product", "revision")
_REQUIRED = 2
_HEADER_NAMES = {
    **dict.fromkeys(("vendor", "vendorid"), "vendor"),
    **dict.fromkeys(("product", "productcode", "productid"), "product"),
    **dict.fromkeys(("revision", "revisionno", "revisionnumber", "rev"), "revision"),
}

_Row = tuple[int, list[str]]


def read_csv(text: str) -> Scan:
    """Read the cleaned text of a list. Raises :class:`ScanError` for a bad cell, naming its line."""
    rows = _rows(text)
    header_line, first = rows[0]
    findings: list[ScanFinding] = []
    columns: list[str | None] = list(_COLUMNS)
    if not any(cell[:1] in ("#", *"0123456789") for cell in first):
        columns, findings = _header(header_line, first)
        rows = rows[1:]
    slaves = tuple(_slave(position, line, columns, cells) for position, (line, cells) in enumerate(rows))
    if not slaves:
        raise ScanError(f"line {header_line}: a header without any row of vendor,product,revision")
    return Scan(format=FORMAT, slaves=slaves, findings=tuple(findings))


def _rows(text: str) -> list[_Row]:
    lines = list(numbered_lines(text))
    separator = next((mark for mark in "\t;," if mark in lines[0][1]), ",")
    return [(number, [cell.strip().strip("\"'").strip() for cell in line.split(separator)]) for number, line in lines]


def _header(line: int, cells: list[str]) -> tuple[list[str | None], list[ScanFinding]]:
    columns = [_HEADER_NAMES.get(re.sub(r"[^a-z]", "", cell.lower())) for cell in cells]
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
