"""Numbers as large as a database takes, wherever a document has one: no sum of them ends an ingest."""

import re
from itertools import islice

import msgspec
import pytest
from snippets import device, dictionary, esi, pdo, rows, write
from test_maximal import MAXIMAL

from esicatalog import Catalog
from esicatalog.ingest.tasks import Task
from esicatalog.ingest.worker import DocumentWorker

LARGEST = 2**63 - 1
OUTPUTS = '<Sm StartAddress="#x1100" ControlByte="#x64" Enable="1">Outputs</Sm>'
NUMBER = re.compile(rb'(?<=[>"])\s*(?:#x[0-9A-Fa-f]+|[+-]?[0-9]+)\s*(?=[<"])')


def numbers(held: object) -> list[int]:
    """All numbers in what a worker hands over."""
    if isinstance(held, dict):
        held = [*held, *held.values()]
    if isinstance(held, list):
        return [number for item in held for number in numbers(item)]
    return [held] if isinstance(held, int) else []


@pytest.mark.parametrize(
    ("text", "step"),
    [(str(LARGEST), 60), *(pytest.param(str(number), 1, marks=pytest.mark.faults) for number in (LARGEST, -LARGEST))],
)
def test_one_large_number_anywhere(text, step, tmp_path):
    worker, content = DocumentWorker(), MAXIMAL.read_bytes()
    for found in islice(NUMBER.finditer(content), 0, None, step):
        place = content[max(found.start() - 60, 0) : found.end() + 30]
        (tmp_path / "d.xml").write_bytes(content[: found.start()] + text.encode() + content[found.end() :])
        outcome = worker.handle(Task(0, str(tmp_path), False, (), "d.xml"))
        assert outcome.status != "failed", (place, outcome.message)
        handed_over = numbers(msgspec.msgpack.decode(msgspec.msgpack.encode(outcome.rows)))
        assert -LARGEST <= min(handed_over) <= max(handed_over) <= LARGEST, place


ARRAY = (
    "<DataType><Name>DT1ARR</Name><BaseType>UDINT</BaseType><BitSize>64</BitSize>"
    "<ArrayInfo><LBound>1</LBound><Elements>2</Elements></ArrayInfo></DataType>"
    "<DataType><Name>DT1</Name><BitSize>80</BitSize>"
    "<SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs>"
    "</SubItem>"
    f"<SubItem><Name>Elements</Name><Type>DT1ARR</Type><BitSize>64</BitSize><BitOffs>{LARGEST}</BitOffs></SubItem>"
    "</DataType>"
)
SUBINDICES = (
    f"<DataType><Name>DT1</Name><BitSize>80</BitSize>"
    f"<SubItem><SubIdx>{LARGEST}</SubIdx><Name>A</Name><Type>UDINT</Type><BitSize>32</BitSize><BitOffs>0</BitOffs></SubItem>"
    "<SubItem><Name>B</Name><Type>UDINT</Type><BitSize>32</BitSize><BitOffs>32</BitOffs></SubItem></DataType>"
)
OBJECT = "<Object><Index>#x2000</Index><Name>O</Name><Type>DT1</Type><BitSize>80</BitSize></Object>"
LARGE_SUMS = {
    "lengths of entries": OUTPUTS + pdo("RxPdo", "#x1600", LARGEST, LARGEST, attributes='Sm="0"'),
    "offsets of array elements": dictionary(ARRAY, OBJECT),
    "subindices that follow": dictionary(SUBINDICES, OBJECT),
    "a cycle of many digits": f'<Info><VendorSpecific><TwinCAT MinCycleTime="{"9" * 5000}"/></VendorSpecific></Info>',
}


@pytest.mark.parametrize("jobs", [1, 2])
def test_all_documents_of_an_ingest_are_stored(jobs, tmp_path):
    contents = [*LARGE_SUMS.values(), ""]
    write(tmp_path / "in", {f"{n}.xml": esi(device(text, product=f"#x{n}")) for n, text in enumerate(contents)})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        report = catalog.ingest([tmp_path / "in"], jobs=jobs)
        assert catalog.check().problems == []
    assert {line.path: line.status for line in report.documents} == {f"{n}.xml": "stored" for n in range(len(contents))}
    assert rows(tmp_path / "c.db", "SELECT product_code FROM devices ORDER BY 1") == [
        (n,) for n in range(len(contents))
    ]


def test_an_offset_that_no_database_takes_is_not_known(tmp_path):
    write(tmp_path / "in", {"large.xml": esi(device(dictionary(ARRAY, OBJECT)))})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([tmp_path / "in"], jobs=1)
    found = rows(tmp_path / "c.db", "SELECT subindex, bit_offset FROM object_entries ORDER BY subindex")
    assert found == [(0, 0), (1, LARGEST), (2, None)]
