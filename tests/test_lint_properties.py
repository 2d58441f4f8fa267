"""The linter never raises: whatever a document says, as long as the reader takes it."""

import contextlib
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from esicatalog.errors import DocumentError
from esicatalog.esi.documents import parse_document
from esicatalog.esi.lines import Lines
from esicatalog.esi.notes import Finding
from esicatalog.esi.reader import Reader
from esicatalog.esi.tree import DocumentTree
from esicatalog.lint.library import facts_of_document, lint_library
from esicatalog.lint.linter import Linter
from esicatalog.lint.registry import SEVERITY_WORDS
from esicatalog.lint.rules import ALL_RULES
from fuzz.mutations import mutated_tree

TESTS = Path(__file__).parent
SEEDS = [TESTS / "maximal.xml", *sorted((TESTS.parent / "data").glob("*.xml")), *sorted((TESTS / "lint").glob("*.xml"))]


def check(content: bytes, linter: Linter) -> list[Finding]:
    """Findings of a document; every one is fit to be stored and printed."""
    read = Reader().read(content)
    findings = linter.document(
        read, lambda: DocumentTree(parse_document(content).root, Lines(content)), lambda _: False
    )
    facts = list(facts_of_document(read, "a.xml", lambda device, modules, vendor_id: repr(device.type).encode()))
    findings += [item.finding for item in lint_library([*facts, *facts], ALL_RULES)]
    lines = content.count(b"\n") + 1
    for finding in findings:
        assert finding.severity in SEVERITY_WORDS
        assert 0 <= finding.line <= lines
        assert finding.message == finding.message.strip() != ""
    return findings


@settings(deadline=None, max_examples=150)
@given(st.sampled_from(SEEDS), st.randoms(use_true_random=False))
def test_any_change_of_a_document_can_be_linted(seed, chance):
    with contextlib.suppress(DocumentError):
        check(mutated_tree(parse_document(seed.read_bytes()).root, chance), Linter())


def test_a_linter_remembers_nothing_wrong():
    """One that has seen all other documents finds the same as a new one."""
    used = Linter()
    for _ in range(2):
        for seed in SEEDS:
            with contextlib.suppress(DocumentError):
                assert check(seed.read_bytes(), used) == check(seed.read_bytes(), Linter())
