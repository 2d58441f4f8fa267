"""SARIF 2.1.0: against the parts of the standard's schema that a linter uses, and against the whole one if at hand.

ESICATALOG_SARIF_SCHEMA names the public schema file (the npm package @microsoft/jest-sarif ships it).
"""

import json
import os
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from click.testing import CliRunner

from esicatalog.cli.lint import command
from esicatalog.esi.notes import Finding
from esicatalog.lint.report import DocumentFinding
from esicatalog.lint.rules import ALL_RULES
from esicatalog.lint.sarif import sarif_log

FILES = Path(__file__).parent / "lint"


def record(required: list[str], **properties: Any) -> dict[str, Any]:
    """An object of the standard: no other properties, these required."""
    return {"type": "object", "required": required, "properties": properties, "additionalProperties": False}


def many(item: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": item}


TEXT = {"type": "string"}
LEVEL = {"enum": ["none", "note", "warning", "error"]}
INDEX = {"type": "integer", "minimum": -1}
MESSAGE = record(["text"], text=TEXT)
LOCATION = record(
    [],
    physicalLocation=record(
        ["artifactLocation"],
        artifactLocation=record([], uri={"type": "string", "format": "uri-reference"}),
        region=record([], startLine={"type": "integer", "minimum": 1}),
    ),
    logicalLocations=many(record([], fullyQualifiedName=TEXT, kind=TEXT)),
)
RESULT = record(["message"], ruleId=TEXT, ruleIndex=INDEX, level=LEVEL, message=MESSAGE, locations=many(LOCATION))
RULE = record(["id"], id=TEXT, shortDescription=MESSAGE, help=MESSAGE, defaultConfiguration=record([], level=LEVEL))
DRIVER = record(["name"], name=TEXT, version=TEXT, rules={**many(RULE), "uniqueItems": True})
RUN = record(
    ["tool"],
    tool=record(["driver"], driver=DRIVER),
    columnKind={"enum": ["utf16CodeUnits", "unicodeCodePoints"]},
    results=many(RESULT),
)
LOG = record(
    ["version", "runs"],
    **{"$schema": {"type": "string", "format": "uri"}, "version": {"const": "2.1.0"}, "runs": many(RUN)},
)


@pytest.fixture(scope="module")
def log() -> dict[str, Any]:
    """The log of all files that were made to have findings."""
    result = CliRunner().invoke(command, [str(FILES), "--format", "sarif"], catch_exceptions=False)
    return json.loads(result.stdout)


def test_it_follows_the_standard(log):
    jsonschema_rs.validator_for(LOG, validate_formats=True).validate(log)


def test_it_follows_the_public_schema(log):
    name = os.environ.get("ESICATALOG_SARIF_SCHEMA")
    if not name:
        pytest.skip("no public schema of SARIF 2.1.0; name the file with ESICATALOG_SARIF_SCHEMA")
    schema = json.loads(Path(name).read_text("utf-8"))
    for definition in schema["definitions"].values():
        # The pattern for languages that the file has is no valid regular expression; we write no language.
        definition.get("properties", {}).get("language", {}).pop("pattern", None)
    jsonschema_rs.validator_for(schema).validate(log)


def test_results_refer_to_their_rules(log):
    (run,) = log["runs"]
    rules = run["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == [rule.id for rule in ALL_RULES]
    assert {result["ruleId"] for result in run["results"]} > {"L04", "L12", "L45"}
    assert all(rules[result["ruleIndex"]]["id"] == result["ruleId"] for result in run["results"])
    assert all(rule["help"]["text"].startswith(rule["shortDescription"]["text"]) for rule in rules)


@pytest.mark.parametrize(
    ("document", "uri"),
    [
        ("esi/a.xml", "esi/a.xml"),
        ("my files/50 %/ä.xml", "my%20files/50%20%25/%C3%A4.xml"),
        ("/srv/esi/a b.zip!in/c.xml", "file:///srv/esi/a%20b.zip!in/c.xml"),
    ],
)
def test_paths_become_uris(document, uri):
    ((result,),) = [
        run["results"] for run in sarif_log([DocumentFinding(document, Finding("L21", "I", "m", 3))], [])["runs"]
    ]
    assert result["level"] == "note"
    assert result["locations"] == [{"physicalLocation": {"artifactLocation": {"uri": uri}, "region": {"startLine": 3}}}]


def test_an_unknown_line_is_left_out():
    log = sarif_log([DocumentFinding("a.xml", Finding("L01", "E", "m", 0))], ALL_RULES)
    assert log["runs"][0]["results"][0]["locations"] == [{"physicalLocation": {"artifactLocation": {"uri": "a.xml"}}}]
