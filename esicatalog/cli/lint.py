"""esicatalog lint"""

import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import click

from esicatalog.cli.common import EXIT_NO, format_option, print_json, reporting_errors
from esicatalog.errors import DocumentError, InputError, NotAnEsiDocument, UnreadableDocument

if TYPE_CHECKING:
    from esicatalog.esi.containers import Container
    from esicatalog.esi.notes import Finding
    from esicatalog.esi.records.device import Device
    from esicatalog.esi.records.module import Module
    from esicatalog.ingest.discover import Found, FoundArchive
    from esicatalog.lint.registry import Rule
    from esicatalog.lint.report import DocumentFinding

Result = TypeVar("Result")


@click.command("lint")
@click.argument("paths", nargs=-1, type=click.Path())
@click.option(
    "--db", metavar="FILE|URL", help="Say what an ingest found, and how documents of a catalog contradict each other."
)
@click.option("--schema", metavar="DIR", type=click.Path(path_type=Path), help="Validate against the XSD files there.")
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
    """Check ESI files, folders (recursively) and zip archives by the rules L01 to L68.

    Files that are no ESI are skipped unless they are named themselves. Exit code 1 when there are errors, or
    documents that could not be checked: these are told whatever rules are chosen.
    """
    from esicatalog.lint.registry import chosen_rules
    from esicatalog.lint.report import summary
    from esicatalog.lint.rules import ALL_RULES

    rules = chosen_rules(ALL_RULES, _ids(select), _ids(ignore))
    if list_rules:
        _print_rules(rules, output_format)
        return
    if bool(paths) == bool(db):
        raise InputError("name files, folders or archives to lint, or a catalog with --db")
    run = _StoredRun(db, rules) if db else _Run(paths, rules, schema)
    shown = print_findings(run.findings(), rules, output_format)
    for problem in run.unreadable:
        click.echo(f"esicatalog: {problem}", err=True)
    click.echo(summary(shown) + run.counts(), err=True)
    if run.unreadable or any(finding.severity == "E" for finding in shown):
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


def _ids(options: tuple[str, ...]) -> list[str]:
    return [name for option in options for name in option.replace(",", " ").split()]


def _print_rules(rules: "Sequence[Rule]", output_format: str) -> None:
    from esicatalog.lint.report import rule_json

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

    def findings(self) -> "Iterator[DocumentFinding]":
        """All findings; those across documents come last."""
        from esicatalog.api import Catalog
        from esicatalog.lint.rules.reading import REFUSED

        with Catalog.open(self._db, read_only=True) as catalog:
            if not any(rule.id == REFUSED for rule in self._rules):  # then no finding tells them
                self.unreadable += [f"{item.document}: {item.finding.message}" for item in catalog.refused_documents()]
            yield from catalog.findings(self._rules)

    def counts(self) -> str:
        """How many documents were looked at; an ingest has told it."""
        return ""


def _documents(item: "Found | FoundArchive") -> "Iterable[Found]":
    from esicatalog.ingest.discover import FoundArchive, archive_members

    return archive_members(item) if isinstance(item, FoundArchive) else (item,)


def _once(make: Callable[[], Result]) -> Callable[[], Result]:
    """``make``, called when its result is asked for first."""
    made: list[Result] = []

    def result() -> Result:
        if not made:
            made.append(make())
        return made[0]

    return result


def _shown(location: str) -> str:
    """A path as the user would type it: relative to the current folder when it lies below."""
    path = Path(location)
    return str(path.relative_to(Path.cwd())) if path.is_relative_to(Path.cwd()) else location


class _Run:
    """Lints what lies below the paths, document by document; then the rules across documents look at all of them."""

    def __init__(self, paths: "Sequence[str]", rules: "Sequence[Rule]", schema: Path | None) -> None:
        from esicatalog.catalog.digests import Digests
        from esicatalog.esi.reader import Reader
        from esicatalog.lint.library import DeviceFact
        from esicatalog.lint.linter import Linter
        from esicatalog.lint.schema import SchemaFolder

        self._paths = paths
        self._rules = rules
        self._linter = Linter(rules)
        self._schema = SchemaFolder(schema) if schema is not None else None
        self._reader = Reader()
        self._digests = Digests()
        self._facts: list[DeviceFact] = []
        self._opened: tuple[tuple[str, tuple[str, ...]], Container] | None = None
        self._document_count = 0
        self._skipped_count = 0
        self.unreadable: list[str] = []

    def findings(self) -> "Iterator[DocumentFinding]":
        """All findings; those across documents come last."""
        from esicatalog.lint.library import lint_library
        from esicatalog.lint.report import DocumentFinding
        from esicatalog.lint.rules.reading import NO_ESI, REFUSED

        named = {os.path.realpath(path) for path in self._paths}
        for found in self._found():
            shown = _shown(found.location)
            try:
                for finding in self._document(found, shown):
                    yield DocumentFinding(shown, finding)
            except NotAnEsiDocument as error:
                if found.location in named:
                    yield from self._refused(shown, NO_ESI, error)
                else:
                    self._skipped_count += 1
            except (InputError, UnreadableDocument) as error:
                self.unreadable.append(f"{shown}: {error}")
            except DocumentError as error:
                yield from self._refused(shown, REFUSED, error)
            except (MemoryError, RecursionError):
                self.unreadable.append(f"{shown}: too large or too deep to be checked")
        yield from lint_library(self._facts, self._rules)

    def counts(self) -> str:
        """How many documents were looked at and left out, in words behind the summary."""
        skipped = f", skipped as no ESI: {self._skipped_count}" if self._skipped_count else ""
        return f"; documents: {self._document_count}{skipped}"

    def _found(self) -> "Iterator[Found]":
        from esicatalog.ingest.discover import discover

        for item in discover(self._paths):
            for found in _documents(item):
                if found.problem is None:
                    yield found
                elif found.problem[0] == "skipped":
                    self._skipped_count += 1
                else:
                    self.unreadable.append(f"{_shown(found.location)}: {found.problem[1]}")

    def _document(self, found: "Found", shown: str) -> "list[Finding]":
        from esicatalog.esi.containers import resolve_reference
        from esicatalog.lint.library import device_facts

        container = self._container(found)
        pulled = self._reader.pulled(container, found.name)
        if pulled is None:
            read, tree = self._reader.read_tree(container.read(found.name), found.name, container)
        else:
            read, tree = pulled.document, _once(pulled.tree)
        self._document_count += 1
        findings = self._linter.document(
            read, tree, lambda name: resolve_reference(container, found.name, name) is not None
        )
        if self._schema is not None and any(rule.id == "L03" for rule in self._rules):
            violations = self._schema.violations(tree().whole())
            findings = sorted([*findings, *violations], key=lambda finding: finding.line)
        self._facts.extend(device_facts(read, shown, self._signature))
        return findings

    def _signature(self, device: "Device", modules: "Iterable[Module]", vendor_id: int | None) -> bytes:
        keys = [self._digests.module(module, vendor_id) for module in modules]
        return self._digests.device(device, vendor_id, keys)

    def _container(self, found: "Found") -> "Container":
        from esicatalog.esi.containers import Archive, Folder

        key = (found.root, found.nested)
        if self._opened is None or self._opened[0] != key:
            container: Container = Folder(Path(found.root))
            if found.is_archive:
                archive = Archive(Path(found.root))
                for name in found.nested:
                    archive = Archive(archive.read(name))
                container = archive
            self._opened = (key, container)
        return self._opened[1]

    def _refused(self, shown: str, rule_id: str, error: DocumentError) -> "Iterator[DocumentFinding]":
        """Tell that nothing of a document was checked, whatever rules are chosen."""
        from esicatalog.esi.notes import Finding
        from esicatalog.lint.report import DocumentFinding

        self._document_count += 1
        if any(rule.id == rule_id for rule in self._rules):
            yield DocumentFinding(shown, Finding(rule_id, "E", str(error), error.line))
        else:
            self.unreadable.append(f"{shown}: {error}")
