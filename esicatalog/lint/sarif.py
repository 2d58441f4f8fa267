"""Findings as SARIF 2.1.0, the format in which code hosts take the results of static analysis (OASIS)."""

from collections.abc import Iterable
from pathlib import PurePath
from typing import Any
from urllib.parse import quote

from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Rule
from esicatalog.lint.report import DocumentFinding
from esicatalog.version import __version__

SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_LEVELS = {ERROR: "error", WARNING: "warning", INFORMATION: "note"}
_PLAIN_IN_URIS = "/!:@$&'()*+,;="


def sarif_log(items: Iterable[DocumentFinding], rules: Iterable[Rule]) -> dict[str, Any]:
    """One run: the rules with their help texts, and a result for every finding."""
    described = list(rules)
    positions = {rule.id: position for position, rule in enumerate(described)}
    return {
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [
            {
                "tool": {
                    "driver": {
                        "name": "esicatalog",
                        "version": __version__,
                        "rules": [_descriptor(rule) for rule in described],
                    }
                },
                "columnKind": "unicodeCodePoints",
                "results": [_result(item, positions) for item in items],
            }
        ],
    }


def _descriptor(rule: Rule) -> dict[str, Any]:
    return {
        "id": rule.id,
        "shortDescription": {"text": rule.title},
        "help": {"text": f"{rule.title} Reference: {rule.reference}."},
        "defaultConfiguration": {"level": _LEVELS[rule.severity]},
    }


def _result(item: DocumentFinding, positions: dict[str, int]) -> dict[str, Any]:
    found = item.finding
    physical: dict[str, Any] = {"artifactLocation": {"uri": _uri(item.document)}}
    if found.line:
        physical["region"] = {"startLine": found.line}
    location: dict[str, Any] = {"physicalLocation": physical}
    if found.path:
        location["logicalLocations"] = [{"fullyQualifiedName": found.path, "kind": "element"}]
    result: dict[str, Any] = {
        "ruleId": found.rule,
        "level": _LEVELS[found.severity],
        "message": {"text": found.message},
        "locations": [location],
    }
    if found.rule in positions:
        result["ruleIndex"] = positions[found.rule]
    return result


def _uri(document: str) -> str:
    path = PurePath(document)
    quoted = quote(path.as_posix(), safe=_PLAIN_IN_URIS)
    return f"file://{quoted}" if path.is_absolute() else quoted
