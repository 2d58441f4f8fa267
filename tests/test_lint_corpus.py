"""The linter on real files: what is known of them, and what the ETG's own schema says."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from esicatalog.errors import EsiCatalogError
from esicatalog.esi.containers import Archive
from esicatalog.esi.documents import parse_document
from esicatalog.esi.lines import Lines
from esicatalog.esi.notes import Finding
from esicatalog.esi.reader import Reader
from esicatalog.esi.tree import DocumentTree
from esicatalog.lint.linter import Linter
from esicatalog.lint.registry import SEVERITY_WORDS
from esicatalog.lint.schema import SchemaFolder

OUT_OF_ORDER = "This element is not expected"


class Linted(NamedTuple):
    """A document of the corpus: its name, what the linter found, what the schema says."""

    name: str
    findings: list[Finding]
    violations: list[Finding]


def documents(archive: Path) -> Iterator[tuple[str, bytes, Archive]]:
    opened = Archive(archive)
    for name, _ in opened.members():
        yield f"{archive.name}!{name}", opened.read(name), opened


def linted(archives: list[Path], schema: SchemaFolder) -> Iterator[Linted]:
    reader, linter = Reader(), Linter()
    for archive in archives:
        for name, content, container in documents(archive):
            try:
                read, tree = reader.read_tree(content, name.partition("!")[2], container)
            except EsiCatalogError:
                continue
            plain = DocumentTree(parse_document(content).root, Lines(content))
            findings = linter.document(read, tree, lambda _: True)
            # What was recognised before it was parsed is told with the same place and line.
            assert findings == linter.document(read, lambda plain=plain: plain, lambda _: True), name
            yield Linted(name, findings, schema.violations(plain.root, Lines(content)))


@pytest.fixture(scope="module")
def library(corpus) -> list[Linted]:
    """Every document of the corpus."""
    return list(linted(sorted((corpus / "esi").glob("*.zip")), SchemaFolder(corpus / "xsd" / "1.17")))


def counts(item: Linted) -> Counter:
    return Counter(finding.rule for finding in item.findings)


def test_known_defects_of_a_few_files(corpus):
    """EYOU: Exclude before Name, an InitCmd against the modules' names, a 0x6502 of two bytes."""
    archive = corpus / "esi" / "ruiofang+EU_EtherCAT.zip"
    found = {item.name.rpartition("/")[2]: item for item in linted([archive], SchemaFolder(corpus / "xsd" / "1.17"))}
    v143 = found["EYOU_ServoModule_ECAT_V143.xml"]
    assert counts(v143)["L04"] == len([v for v in v143.violations if OUT_OF_ORDER in v.message]) == 6
    assert counts(v143)["L57"] == 2
    assert [f.message for f in v143.findings if f.rule == "L58"] == [
        "0x6502 has the default 0001, which is shorter than its type"
    ]


@pytest.mark.corpus
def test_every_document_can_be_linted(library):
    assert len(library) > 400
    for item in library:
        for finding in item.findings:
            assert finding.severity in SEVERITY_WORDS
            assert "\n" not in finding.message
            assert finding.line > 0


KNOWN = [
    ("SMC EX250-SEN1-X156.xml", "L19", 1),
    ("Beckhoff EP5xxx.xml", "L31", 1),
    ("config/esi/orbitas.xml", "L11", 1),
    ("config/esi/epos-3axis.xml", "L11", 2),
    ("ethercat.zip!etc/xml/Beckhoff EL2xxx.xml", "L28", 1),
    ("ethercat.zip!etc/xml/Beckhoff EP2xxx.xml", "L18", 6),
    ("Weidmueller_UR20_FBC.xml", "L60", 1),
    ("AX58100_H750_Universal.zip!ecat/device/eeprom.xml", "L01", 1),
]
"""Defects that are known from looking at these files."""


@pytest.mark.corpus
@pytest.mark.parametrize(("name", "rule_id", "count"), KNOWN)
def test_known_defects(library, name, rule_id, count):
    (item,) = [item for item in library if item.name.endswith(name) and counts(item)[rule_id]]
    assert counts(item)[rule_id] == count


@pytest.mark.corpus
def test_the_schema_agrees(library):
    """Order, HexDecValue and keys, as libxml2 finds them with the ETG's schema."""
    for item in library:
        found = counts(item)
        unexpected = any(OUT_OF_ORDER in violation.message for violation in item.violations)
        assert not found["L04"] or unexpected, item.name
        patterns = sum("SCHEMAV_CVC_PATTERN_VALID" in violation.message for violation in item.violations)
        if "Orbita" in item.name:
            assert found["L06"] == patterns > 0, item.name
        if any("SCHEMAV_CVC_IDC" in violation.message for violation in item.violations):
            assert found["L41"] or found["L42"], item.name
