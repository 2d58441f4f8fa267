"""The linter never raises: whatever a document says, as long as the reader takes it."""

import contextlib
import re
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
from lxml import etree

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


CONTAINERS = (
    *("Descriptions", "Groups", "Devices", "Modules", "Info", "Slots", "Dc", "Mailbox", "CoE"),
    *("Profile", "Dictionary", "DataTypes", "Objects"),
)


def with_repeated_containers(root, chance) -> bytes:
    """A document with some of its containers in two parts; every element stands on a line of its own."""
    for element in list(root.iter(*CONTAINERS)):
        if len(element) and element.getparent() is not None and chance.random() < 0.5:
            behind = element.makeelement(element.tag)
            behind.extend(list(element)[chance.randrange(len(element) + 1) :])
            element.addnext(behind)
    return etree.tostring(root, pretty_print=True)


def lines_at(root, path: str) -> list[int]:
    """The lines of what a path selects, or the nearest step of it that the document has."""
    steps = re.sub(r"\[(\d+)\]", lambda found: f"[{int(found[1]) + 1}]", path).split("/")
    while not (found := root.xpath("/" + "/".join(steps))):
        steps.pop()
    return [element.sourceline for element in found]


def check_paths(content: bytes) -> None:
    read, tree = Reader().read_tree(content)
    root = parse_document(content).root
    for finding in Linter().document(read, tree):
        if finding.path and "{" not in finding.path:
            assert lines_at(root, finding.path) == [finding.line], finding


@settings(deadline=None, max_examples=100)
@given(st.sampled_from(SEEDS), st.randoms(use_true_random=False))
def test_the_path_of_a_finding_selects_what_stands_on_its_line(seed, chance):
    """In XPath positions count from 1, in ours from 0."""
    with contextlib.suppress(DocumentError):
        check_paths(with_repeated_containers(parse_document(seed.read_bytes()).root, chance))


def test_paths_and_lines_of_documents_as_they_are():
    for seed in SEEDS:
        with contextlib.suppress(DocumentError):
            check_paths(seed.read_bytes())
