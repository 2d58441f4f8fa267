"""Files changed at random, always in the same ways: each gives a result or a named error.

The targets are those of ``make fuzz``, which looks further and for longer.
"""

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from snippets import write

from esicatalog import Catalog
from fuzz import pipeline, reader, scan, sii
from fuzz.seeds import own_documents, real_documents

EXAMPLES = {reader: 200, pipeline: 60, sii: 300, scan: 800}
MAX_SEED_BYTES = 40_000


@pytest.mark.parametrize("target", EXAMPLES, ids=lambda target: target.__name__)
def test_whatever_is_changed_is_answered(target):
    seeds = [seed for seed in target.seeds() if len(seed) <= MAX_SEED_BYTES]

    @settings(max_examples=EXAMPLES[target], derandomize=True, deadline=None, database=None)
    @given(st.sampled_from(seeds), st.integers(0, 2**32 - 1))
    def check(seed, chance):
        target.check(target.mutate(seed, chance))

    for seed in seeds:
        target.check(seed)
    check()


@pytest.mark.parametrize("target", [sii, scan], ids=lambda target: target.__name__)
def test_whatever_bytes_are_answered(target):
    @settings(max_examples=300, derandomize=True, deadline=None, database=None)
    @given(st.binary(max_size=600))
    def check(content):
        target.check(content)

    check()


def test_changed_documents_make_a_sound_catalog(tmp_path):
    """Many in one ingest: what is wrong with one leaves no trace in another, and no fault goes unnamed."""
    chance = random.Random(17)
    seeds = [seed for seed in (*own_documents(), *list(real_documents())[::20]) if len(seed) <= MAX_SEED_BYTES]
    files = {f"{n}.xml": reader.mutate(chance.choice(seeds), chance.getrandbits(32)) for n in range(300)}
    write(tmp_path / "in", files)
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        report = catalog.ingest([tmp_path / "in"], jobs=1)
        assert catalog.check().problems == []
        again = catalog.ingest([tmp_path / "in"], jobs=1)
    assert len(report.documents) == len(files)
    assert [line for line in report.documents if line.message and "not foreseen" in line.message] == []
    assert report.counts["stored"] > len(files) / 2
    assert again.counts["unchanged"] == report.counts["stored"]
