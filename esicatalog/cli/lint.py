"""esicatalog lint"""

import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from esicatalog.cli.common import (
    EXIT_NO,
    FILE,
    Command,
    catalog_to_ask,
    format_option,
    print_json,
    reporting_errors,
    say_no_document,
)
from esicatalog.errors import InputError

if TYPE_CHECKING:
    from esicatalog.esi.notes import Finding
    from esicatalog.lint.registry import Rule
    from esicatalog.lint.report import DocumentFinding


@click.command("lint", cls=Command)
@click.argument("paths", nargs=-1, type=click.Path())
@click.option(
    "--db", metavar="FILE|URL", help="Say what an ingest found, and how documents of a catalog contradict each other."
)
@click.option("--schema", metavar="DIR", type=FILE, help="Validate against the XSD files there.")
@click.option("--select", metavar="L01,…", multiple=True, help="Only these rules.")
@click.option("--ignore", metavar="L21,…", multiple=True, help="All rules but these.")
@click.option("--list", "list_rules", is_flag=True, help="Print all rules.")
@format_option("text", "json", "sarif")
@reporting_errors
def command(
    paths: tuple[str, ...],
    db: str | None,
    schema: Path | None,
    select: tuple[str, ...],
    ignore: tuple[str, ...],
    list_rules: bool,
    output_format: str,
) -> None:
    """Check ESI files, folders (recursively) and zip archives by the rules that --list shows.

    Files that are no ESI are skipped unless they are named themselves. Exit code 1 when there are errors, or
    documents that could not be checked: these are told whatever rules are chosen. Modules that an InfoReference pulls
    in are checked in their own document; that they do not fit a device (SyncManagers of PDOs, objects of InitCmds) is
    told in the device's document, at the InfoReference.
    """
    from esicatalog.ingest.lint_files import FilesRun
    from esicatalog.lint.registry import ERROR, chosen_rules
    from esicatalog.lint.report import summary
    from esicatalog.lint.rules import ALL_RULES
    from esicatalog.lint.rules.reading import SCHEMA_RULE

    selected = _ids("--select", select)
    rules = chosen_rules(ALL_RULES, selected, _ids("--ignore", ignore))
    if list_rules:
        _print_rules(rules, output_format)
        return
    _check_usage(paths, db, schema)
    run = _StoredRun(db, rules) if db is not None else FilesRun(paths, rules, schema)
    shown = print_findings(run.findings(), rules, output_format)
    for problem in run.unreadable:
        click.echo(f"esicatalog: {problem}", err=True)
    if schema is None and SCHEMA_RULE in map(str.upper, selected):
        click.echo(
            f"esicatalog: {SCHEMA_RULE} looked at booleans and numbers only; for all kinds: lint PATH --schema DIR",
            err=True,
        )
    click.echo(summary(shown) + run.counts(), err=True)
    if run.is_empty:
        say_no_document(paths)
    if run.unreadable or any(finding.severity == ERROR for finding in shown):
        sys.exit(EXIT_NO)


def print_findings(items: "Iterable[DocumentFinding]", rules: "Sequence[Rule]", output_format: str) -> "list[Finding]":
    """Print findings as they come, JSON and SARIF when all are there; returns them."""
    from esicatalog.lint.report import as_json, text_line

    shown = []
    collected = []
    for item in items:
        shown.append(item.finding)
        if output_format == "text":
            click.echo(text_line(item))
        else:
            collected.append(item)
    if output_format == "json":
        print_json([as_json(item) for item in collected])
    elif output_format == "sarif":
        from esicatalog.lint.sarif import sarif_log

        print_json(sarif_log(collected, rules))
    return shown


def _check_usage(paths: tuple[str, ...], db: str | None, schema: Path | None) -> None:
    what = "files, folders or archives to lint, or a catalog with --db"
    if paths and db is not None:
        raise InputError(f"give only one of {what}")
    if not paths and db is None:
        raise InputError(f"name {what}")
    if db is not None and schema is not None:
        raise InputError("--schema validates the documents themselves, which a catalog does not hold; name them")


def _ids(option: str, texts: tuple[str, ...]) -> list[str]:
    """The ids of rules in the texts of an option. Raises :class:`InputError` where it is given and names none."""
    ids = [name for text in texts for name in text.replace(",", " ").split()]
    if texts and not ids:
        raise InputError(f"{option} names no rule; lint --list prints all rules")
    return ids


def _print_rules(rules: "Sequence[Rule]", output_format: str) -> None:
    from esicatalog.lint.report import rule_json

    if output_format == "sarif":
        raise InputError("--list prints text or JSON; SARIF holds rules beside the findings of a run")
    rows = [rule_json(rule) for rule in rules]
    if output_format == "json":
        print_json(rows)
    else:
        for row in rows:
            click.echo(f"{row['rule']} {row['severity']}  {row['title']}\n       {row['reference']}")


class _StoredRun:
    """What an ingest found, and what the documents of a catalog contradict each other in."""

    def __init__(self, db: str, rules: "Sequence[Rule]") -> None:
        self._db = db
        self._rules = rules
        self.unreadable: list[str] = []
        self.is_empty = False
        """Whether it found nothing to look at where something was meant; a catalog may well be empty."""

    def findings(self) -> "list[DocumentFinding]":
        """All findings; those across documents come last. The catalog is closed before anything is printed."""
        with catalog_to_ask(self._db, read_only=True) as catalog:
            self.unreadable += catalog.unchecked_documents(self._rules)
            return catalog.findings(self._rules)

    def counts(self) -> str:
        """How many documents were looked at; an ingest has told it."""
        return ""
