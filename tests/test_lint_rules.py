"""Every rule on files written for it: ``L08.bad.xml`` triggers it where its comments say so, ``L08.good.xml`` is sound.

``<!-- L08 E -->`` stands on the line of a finding, once for each.
"""

import json
import re
from collections import Counter
from pathlib import Path

import pytest
from click.testing import CliRunner

from esicatalog.cli.lint import command
from esicatalog.lint.registry import SEVERITY_WORDS
from esicatalog.lint.rules import ALL_RULES

FILES = Path(__file__).parent / "lint"
RULE_IDS = [f"L{number:02}" for number in range(1, 68)]
_EXPECTED = re.compile(r"<!-- (L\d\d) ([EWI]) -->")


def findings(path: Path) -> list[dict]:
    """What the command finds below a path."""
    result = CliRunner().invoke(command, [str(path), "--format", "json"], catch_exceptions=False)
    return json.loads(result.stdout)


def rule_file(rule_id: str, kind: str) -> Path:
    """A document, or a folder for rules that need several."""
    folder = FILES / f"{rule_id}.{kind}"
    return folder if folder.is_dir() else FILES / f"{rule_id}.{kind}.xml"


def expected(path: Path, rule_id: str) -> Counter:
    """File name, line and severity of every finding that the comments announce."""
    documents = sorted(path.rglob("*.xml")) if path.is_dir() else [path]
    return Counter(
        (document.name, number, severity)
        for document in documents
        for number, line in enumerate(document.read_text("utf-8").splitlines(), 1)
        for announced, severity in _EXPECTED.findall(line)
        if announced == rule_id
    )


def test_the_registry_is_complete():
    assert [rule.id for rule in ALL_RULES] == RULE_IDS
    for rule in ALL_RULES:
        assert rule.severity in SEVERITY_WORDS
        assert rule.title.endswith(".")
        assert rule.reference
        assert "\n" not in rule.title + rule.reference


@pytest.mark.parametrize("rule_id", RULE_IDS)
def test_a_rule_finds_the_defect(rule_id):
    path = rule_file(rule_id, "bad")
    found = Counter(
        (Path(item["file"]).name, item["line"], item["severity"]) for item in findings(path) if item["rule"] == rule_id
    )
    assert found == expected(path, rule_id)
    assert found


@pytest.mark.parametrize("rule_id", RULE_IDS)
def test_sound_documents_have_no_findings(rule_id):
    assert findings(rule_file(rule_id, "good")) == []


@pytest.mark.parametrize("rule_id", RULE_IDS)
def test_a_finding_says_what_and_where_in_one_line(rule_id):
    for item in findings(rule_file(rule_id, "bad")):
        assert item["message"]
        assert "\n" not in item["message"]
        assert item["path"] or item["rule"] in ("L01", "L02")
