"""All real files in PostgreSQL and in SQLite: the same content, the same answers, by one process or by four."""

import random
from pathlib import Path

import pytest
from click.testing import CliRunner
from questions import FILTERS, answers
from snippets import one, rows
from test_postgres_writers import assert_done, assert_holds, started

from esicatalog import Catalog
from esicatalog.catalog.full_text import _WORD
from esicatalog.cli.main import cli

pytestmark = pytest.mark.corpus

IDENTIFIED, SHOWN, SEARCHED = 200, 50, 150


@pytest.fixture(scope="module")
def corpus_url(postgres_cluster, corpus) -> str:
    """A catalog of the whole corpus in PostgreSQL."""
    url = postgres_cluster.new_database()
    with Catalog.open(url, create=True) as catalog:
        catalog.ingest([corpus / "esi"])
    return url


@pytest.fixture(scope="module")
def identities(corpus_db) -> list[tuple[int, int, int]]:
    """Identities evenly chosen from all of them."""
    query = (
        "SELECT vendor_id, product_code, revision_no FROM devices WHERE variant = 1 AND vendor_id IS NOT NULL "
        "AND product_code IS NOT NULL AND revision_no IS NOT NULL ORDER BY 1, 2, 3"
    )
    found = rows(corpus_db, query)
    return found[:: max(1, len(found) // IDENTIFIED)]


def test_content_hashes_are_the_same(corpus_db, corpus_url):
    here, there = (Catalog.open(target).check() for target in (corpus_db, corpus_url))
    assert here == there
    assert here.problems == []


def test_devices_are_the_same_for_every_filter(corpus_db, corpus_url, identities):
    like = [f"0x{v:x}:0x{p:x}:0x{r:x}" for v, p, r in identities]
    unlike_others = (
        "SELECT count(*) FROM device_facts f JOIN devices d ON d.id = f.device_id "
        "WHERE (f.image_signature IS NULL OR f.output_bytes IS NULL OR f.input_bytes IS NULL) "
    )
    like = [
        text
        for text, numbers in zip(like, identities, strict=True)
        if not one(
            corpus_db,
            unlike_others + "AND d.variant = 1 AND d.vendor_id = ? AND d.product_code = ? AND d.revision_no = ?",
            *numbers,
        )
    ]
    here, there = (answers(target, FILTERS, like=like[:20]) for target in (corpus_db, corpus_url))
    assert here == there
    assert sum(map(bool, here.values())) > len(here) / 2


def test_words_find_the_same(corpus_db, corpus_url):
    """Words of names and types, whole, cut and joined, as people type them."""
    chosen = random.Random(1)
    texts = [
        text for (text,) in rows(corpus_db, "SELECT DISTINCT text FROM device_names UNION SELECT name FROM vendors")
    ]
    texts += [text for (text,) in rows(corpus_db, "SELECT DISTINCT type FROM devices WHERE type IS NOT NULL")]
    asked = ["".join(word) for word in chosen.sample(texts, SEARCHED)]
    words = [word for text in chosen.sample(texts, SEARCHED) for word in _WORD.findall(text)]
    asked += [word[chosen.randrange(len(word)) :][: chosen.randint(1, 6)] for word in words[:SEARCHED]]
    here, there = (answers(target, (), asked) for target in (corpus_db, corpus_url))
    assert here == there
    assert sum(map(bool, here.values())) > SEARCHED // 2


def test_identities_are_answered_the_same(corpus_db, corpus_url, identities):
    assert len(identities) >= IDENTIFIED
    with Catalog.open(corpus_db) as here, Catalog.open(corpus_url) as there:
        for vendor, product, revision in identities:
            for asked in ((vendor, product, revision), (vendor, product, revision ^ 0x10001), (vendor, product + 1)):
                assert here.identify(*asked).as_json() == there.identify(*asked).as_json()


def test_sheets_and_exports_are_the_same(corpus_db, corpus_url, identities):
    chosen = identities[:: len(identities) // SHOWN]
    assert len(chosen) >= SHOWN
    for identity in (f"0x{v:x}:0x{p:x}:0x{r:x}" for v, p, r in chosen):
        for command in (["show", identity, "--format", "json"], ["export", "igh", identity]):
            here, there = (
                CliRunner().invoke(cli, [*command, "--db", str(target)]) for target in (corpus_db, corpus_url)
            )
            assert (here.exit_code, here.stdout, here.stderr) == (there.exit_code, there.stdout, there.stderr)
            assert here.stdout or here.exit_code


def test_findings_are_the_same(corpus_db, corpus_url):
    here, there = (CliRunner().invoke(cli, ["lint", "--db", str(target)]).stdout for target in (corpus_db, corpus_url))
    assert here == there != ""


def test_four_machines_at_once_make_what_one_makes(corpus, corpus_db, postgres):
    archives = sorted((corpus / "esi").iterdir())
    assert_done([started(postgres, archives[number::4]) for number in range(4)])
    assert_holds(postgres, Catalog.open(corpus_db).check().content_hash)


def test_a_snapshot_of_postgresql_is_the_catalog_that_sqlite_makes(corpus_db, corpus_url, tmp_path: Path):
    with Catalog.open(corpus_url, read_only=True) as catalog:
        made = catalog.snapshot(tmp_path / "catalog-<hash>.db")
    here, there = (Catalog.open(target).check() for target in (corpus_db, made.path))
    assert here == there
    assert here.content_hash == made.content_hash
    assert here.problems == []
