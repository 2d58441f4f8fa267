"""Findings as text in the style of compilers, and as JSON."""

from collections import Counter
from collections.abc import Iterable
from typing import Any, NamedTuple

from esicatalog.esi.notes import Finding
from esicatalog.lint.registry import SEVERITY_WORDS, Rule
from esicatalog.words import counted


class DocumentFinding(NamedTuple):
    """A finding and the document it belongs to: a path, ``archive.zip!member.xml`` inside archives."""

    document: str
    finding: Finding


def text_line(item: DocumentFinding) -> str:
    """``file.xml:123: error L17: message``; without the line where it is unknown."""
    found = item.finding
    place = f"{item.document}:{found.line}" if found.line else item.document
    return f"{place}: {SEVERITY_WORDS[found.severity]} {found.rule}: {found.message}"


def as_json(item: DocumentFinding) -> dict[str, Any]:
    """The columns of the catalog's table ``findings``, and the document."""
    found = item.finding
    return {
        "file": item.document,
        "line": found.line,
        "rule": found.rule,
        "severity": found.severity,
        "message": found.message,
        "path": found.path,
    }


def rule_json(rule: Rule) -> dict[str, str]:
    """A rule as ``lint --list`` prints it."""
    return {"rule": rule.id, "severity": rule.severity, "title": rule.title, "reference": rule.reference}


def summary(findings: Iterable[Finding]) -> str:
    """``2 errors, 1 warning, 0 infos``."""
    counts = Counter(finding.severity for finding in findings)
    return ", ".join(counted(counts[severity], word) for severity, word in SEVERITY_WORDS.items())
