"""The linter never raises: whatever a document says, as long as the reader takes it."""

import contextlib
import random
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
from lxml import etree

from esicatalog.errors import DocumentError
from esicatalog.esi.documents import parse_document
from esicatalog.esi.notes import Finding
from esicatalog.esi.reader import Reader
from esicatalog.esi.tree import DocumentTree
from esicatalog.lint.library import device_facts, lint_library
from esicatalog.lint.linter import Linter
from esicatalog.lint.registry import SEVERITY_WORDS
from esicatalog.lint.rules import ALL_RULES

TESTS = Path(__file__).parent
SEEDS = [TESTS / "maximal.xml", *sorted((TESTS.parent / "data").glob("*.xml")), *sorted((TESTS / "lint").glob("*.xml"))]
TEXTS = [
    *(
        "",
        "0",
        "1",
        "-1",
        "7",
        "255",
        "#x0",
        "#x1600",
        "#x1A00",
        "#x6502",
        "#xFFFF",
        "#xFFFFFFFF",
        "#x7FFFFFFFFFFFFFFF",
    ),
    *(
        "4294967296",
        "-9223372036854775807",
        "99999999999999999999",
        "0x10",
        "x",
        "true",
        "0001",
        "FFFFFFFF",
        "00ff1",
        "G",
    ),
    *("STRING(3)", "ARRAY [0..7] OF BYTE", "DT1018", "UDINT", "U", "Outputs", "MBoxIn", "SubIndex 001", "\N{SNOWMAN}"),
]


def mutated(root: etree._Element, chance: random.Random) -> bytes:
    """The document with a few values, attributes and elements changed, moved, doubled or removed."""
    for _ in range(chance.randint(1, 8)):
        elements = [element for element in root.iter() if element is not root]
        if not elements:
            break
        element = chance.choice(elements)
        parent = element.getparent()
        match chance.choice(["text", "attribute", "remove", "double", "move"]):
            case "text":
                element.text = chance.choice(TEXTS)
            case "attribute" if element.attrib:
                element.set(chance.choice(sorted(element.attrib)), chance.choice(TEXTS))
            case "remove":
                parent.remove(element)
            case "double":
                parent.insert(chance.randint(0, len(parent)), etree.fromstring(etree.tostring(element)))
            case "move":
                target = chance.choice(elements)
                if target not in element.iter():
                    target.append(element)
            case _:
                pass
    return etree.tostring(root)


def check(content: bytes, linter: Linter) -> list[Finding]:
    """Findings of a document; every one is fit to be stored and printed."""
    read = Reader().read(content)
    findings = linter.document(read, lambda: DocumentTree(parse_document(content).root), lambda _: False)
    facts = list(device_facts(read, "a.xml", lambda device, modules, vendor_id: repr(device.type).encode()))
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
        check(mutated(parse_document(seed.read_bytes()).root, chance), Linter())


def test_a_linter_remembers_nothing_wrong():
    """One that has seen all other documents finds the same as a new one."""
    used = Linter()
    for _ in range(2):
        for seed in SEEDS:
            with contextlib.suppress(DocumentError):
                assert check(seed.read_bytes(), used) == check(seed.read_bytes(), Linter())
