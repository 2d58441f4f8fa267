"""Every value that a view shows finds its rows again: Datasette filters by texts, and so do the links of facets."""

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from snippets import device, dictionary, esi, pdo, write
from test_maximal import MAXIMAL

from esicatalog import Catalog
from esicatalog.catalog.views import views

VIEWS = [view.name for view in views("sqlite")]
LIMITED = dictionary(
    "<DataType><Name>REAL</Name><BitSize>32</BitSize></DataType>",
    "<Object><Index>#x7000</Index><Name>O</Name><Type>REAL</Type><BitSize>32</BitSize>"
    "<Info><MinValue>-0.5</MinValue><MaxValue>1.5</MaxValue></Info></Object>",
)
COMMAND = "<InitCmd><Transition>PS</Transition><Index>#x2000</Index><SubIndex>0</SubIndex><Data>01</Data></InitCmd>"
MODULE = (
    f'<Module><Type ModuleIdent="#x7">M7</Type><Name>M</Name>{pdo("TxPdo", "#x1A00", 8, 8)}'
    f"<Mailbox><CoE>{COMMAND}</CoE></Mailbox></Module>"
)
WRONG = '<Device Physics="YY"><Type ProductCode="#xZ" RevisionNo="#x1">W</Type><Name>W</Name></Device>'
DOCUMENTS: dict[str, str | bytes] = {
    "maximal.xml": MAXIMAL.read_bytes(),
    "one.xml": esi(device(LIMITED + pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"')), MODULE),
    "two.xml": esi(device(pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"')) + WRONG),
    "broken.xml": b"<EtherCATInfo><Vendor>",
    "note.txt": b"no document",
}


@pytest.fixture(scope="module")
def full(tmp_path_factory: pytest.TempPathFactory, data: Path, library: Path) -> Path:
    """A catalog that every view has something to show of."""
    db = tmp_path_factory.mktemp("views") / "full.db"
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest([data, library, write(db.parent / "own", DOCUMENTS)], jobs=1)
    return db


@pytest.mark.parametrize("view", VIEWS)
def test_every_value_is_found_by_its_text(full, view):
    with closing(sqlite3.connect(full)) as connection:
        found = connection.execute(f"SELECT * FROM {view}")
        names, shown = [column[0] for column in found.description], found.fetchmany(4000)
        assert shown
        lost = []
        for name, values in zip(names, zip(*shown, strict=True), strict=True):
            for value in sorted({value for value in values if value is not None}, key=str)[:3]:
                by_value, by_text = (
                    connection.execute(f"SELECT count(*) FROM {view} WHERE {name} = ?", (asked,)).fetchone()
                    for asked in (value, str(value))
                )
                if by_value != by_text or by_value == (0,):
                    lost.append((name, value, by_value, by_text))
        assert lost == []


def test_a_document_that_carries_a_description_twice_is_one_source(tmp_path):
    """a.xml has the first one twice, b.xml once; c.xml has another one of the same identity."""
    first, other = device(), device(pdo("TxPdo", "#x1A00", 16))
    documents = write(tmp_path / "in", {"a.xml": esi(first + first), "b.xml": esi(first), "c.xml": esi(other)})
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([documents], jobs=1)
    with closing(sqlite3.connect(tmp_path / "c.db")) as connection:
        assert connection.execute("SELECT count(*) FROM device_sources").fetchone() == (4,)
        for view in ("device_overview", "conflicting_descriptions"):
            found = connection.execute(f"SELECT sources FROM {view} ORDER BY sources").fetchall()
            assert found == [(1,), (2,)], view
