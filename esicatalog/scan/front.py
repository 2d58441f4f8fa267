"""The way in: recognises by content which master printed a scan, and reads it."""

import re
from collections.abc import Callable

from esicatalog.scan import csv_list, igh_slaves, igh_table, soem
from esicatalog.scan.eni import read_eni
from esicatalog.scan.igh_pdos import read_pdos
from esicatalog.scan.igh_sdos import read_sdos
from esicatalog.scan.records import Scan, ScanError
from esicatalog.scan.text import clean, quoted

__all__ = ["read_eni", "read_pdos", "read_scan", "read_sdos"]

_Recognise = Callable[[str], object]
_Read = Callable[[str], Scan]

_ENI = re.compile(r"<(?:\w+:)?EtherCATConfig\b")
_HEAD = 4_096
"""Characters in which the root of a document begins."""
_FORMATS: tuple[tuple[_Recognise, _Read], ...] = (
    (igh_slaves.HEADING_OF_SLAVE.search, igh_slaves.read_igh_slaves),
    (soem.GREETING_OR_SLAVE.search, soem.read_soem),
    (igh_table.ROW.search, igh_table.read_igh_table),
    (csv_list.is_list, csv_list.read_csv),
)
"""In the order of what they say of a slave: of a text that holds several formats the richest is read."""


def read_scan(text: str) -> Scan:
    """Read the slaves that a master printed.

    Formats: ``ethercat slaves -v`` and ``ethercat slaves`` of IgH, ``slaveinfo`` of SOEM, and lists of
    vendor,product,revision. Raises :class:`ScanError` when the text is none of them.
    """
    cleaned = clean(text)
    if _ENI.search(cleaned, 0, _HEAD):
        raise ScanError("this is an ENI file (EtherCATConfig): a configuration, no scan; see esicatalog identify --eni")
    for recognise, read in _FORMATS:
        if recognise(cleaned):
            return read(cleaned)
    raise ScanError(
        "no scan is recognised; expected `ethercat slaves -v` or `ethercat slaves` (IgH), `slaveinfo` (SOEM) or rows "
        f"vendor,product,revision; the text begins with {quoted(cleaned)}"
    )
