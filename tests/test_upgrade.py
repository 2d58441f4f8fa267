"""Catalogs of every released schema version are brought up to date and then say what a new one says.

``catalogs/NNNN.sql`` is a catalog of two of our example files, dumped by the version that had that schema.
"""

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from conftest import CHECKOUT
from snippets import rows
from test_schema import described

from esicatalog import Catalog
from esicatalog.catalog.database import SCHEMA_VERSION

DUMPS = sorted((CHECKOUT / "tests" / "catalogs").glob("*.sql"))
EXAMPLES = ("io_terminal_8di_8do.xml", "two_axis_modular_drive.xml")
DERIVED = (
    "SELECT d.content_hash, d.hidden FROM devices d",
    "SELECT d.content_hash, f.output_bytes, f.input_bytes, f.axis_count, f.image_signature, f.pdo_signature "
    "FROM devices d JOIN device_facts f ON f.device_id = d.id",
    "SELECT d.content_hash, m.position, m.axis, m.mode, m.verdict, m.evidence, m.recipe "
    "FROM devices d JOIN drive_modes m ON m.device_id = d.id",
    "SELECT d.content_hash, m.position, m.rank, m.evidence FROM devices d JOIN mode_evidence m ON m.device_id = d.id",
    "SELECT d.content_hash, p.direction, p.position, p.image_sm, e.position, e.image_bit_offset "
    "FROM devices d JOIN pdos p ON p.device_id = d.id LEFT JOIN pdo_entries e ON e.pdo_id = p.id",
)


def test_every_migration_that_leads_on_has_a_catalog():
    versions = sorted(path.name[:4] for path in (CHECKOUT / "migrations" / "versions").glob("[0-9]*.py"))
    assert [path.stem for path in DUMPS] == [version for version in versions if version != SCHEMA_VERSION]


@pytest.mark.parametrize("dump", DUMPS, ids=lambda path: path.stem)
def test_an_old_catalog_becomes_what_a_new_one_is(tmp_path: Path, data: Path, dump: Path):
    old, new = tmp_path / "old.db", tmp_path / "new.db"
    with closing(sqlite3.connect(old)) as connection:
        connection.executescript(dump.read_text())
    assert Catalog.migrate(old) == (dump.stem, SCHEMA_VERSION)
    with Catalog.open(new, create=True) as catalog:
        catalog.ingest([data / name for name in EXAMPLES], jobs=1)
    assert described(old) == described(new)
    for query in DERIVED:
        assert sorted(rows(old, query), key=repr) == sorted(rows(new, query), key=repr)
    with Catalog.open(old) as upgraded, Catalog.open(new) as made:
        assert upgraded.check().content_hash == made.check().content_hash
        assert [d.as_json() for d in upgraded.devices(modes=["CSV"])] == [
            d.as_json() for d in made.devices(modes=["CSV"])
        ]
        assert upgraded.devices(text="D808")
