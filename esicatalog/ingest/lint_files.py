"""Linting files: what lies below some paths, document by document, then the rules that look at all of them."""

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TypeVar

from esicatalog.catalog.digests import Digests
from esicatalog.catalog.document_status import SKIPPED
from esicatalog.errors import BrokenDocument, DocumentError, InputError, NotAnEsiDocument, UnreadableDocument
from esicatalog.esi.containers import Container, open_container, resolve_reference
from esicatalog.esi.documents import parse_document
from esicatalog.esi.lines import Lines
from esicatalog.esi.notes import REFUSED, Finding
from esicatalog.esi.reader import Reader
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.ingest.discover import FoundArchive, FoundDocument, archive_members, discover
from esicatalog.ingest.this_process import limited
from esicatalog.lint.library import DeviceFact, facts_of_document, lint_library
from esicatalog.lint.linter import Linter
from esicatalog.lint.registry import ERROR, Rule
from esicatalog.lint.report import DocumentFinding
from esicatalog.lint.rules.reading import NO_ESI, SCHEMA_RULE
from esicatalog.lint.schema import SchemaFolder

Result = TypeVar("Result")


class FilesRun:
    """Lints what lies below the paths by ``rules``, and by the XSD files in ``schema`` where L03 is among them."""

    def __init__(self, paths: Sequence[str], rules: Sequence[Rule], schema: Path | None) -> None:
        self._paths = paths
        self._named = {os.path.realpath(path) for path in paths}
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
        """What could not be checked, in words; complete when all findings are."""

    def findings(self) -> Iterator[DocumentFinding]:
        """All findings; those across documents come last."""
        for found in self._found():
            shown = _shown(found.location)
            try:
                with limited():
                    findings = self._document(found, shown)
                for finding in findings:
                    yield DocumentFinding(shown, finding)
            except NotAnEsiDocument as error:
                if found.location in self._named:
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

    @property
    def is_empty(self) -> bool:
        """Whether all was looked at and no document was there."""
        return not self._document_count and not self.unreadable

    def counts(self) -> str:
        """How many documents were looked at and left out, in words behind the summary."""
        skipped = f", skipped as no ESI: {self._skipped_count}" if self._skipped_count else ""
        return f"; documents: {self._document_count}{skipped}"

    def _found(self) -> Iterator[FoundDocument]:
        for item in discover(self._paths):
            for found in _documents(item):
                if found.problem is None:
                    yield found
                elif found.problem[0] == SKIPPED and self._is_known_to_hold_none(found):
                    self._skipped_count += 1
                else:
                    self.unreadable.append(f"{_shown(found.location)}: {found.problem[1]}")

    def _is_known_to_hold_none(self, found: FoundDocument) -> bool:
        """Whether what was skipped holds no documents but those that are checked anyway, and nobody asked for it.

        So it is with an archive without files and a link that leads to a folder inside; what lies behind other links
        and in what is no regular file nobody looked at.
        """
        leads_inside = (
            Path(os.path.realpath(found.location)).is_relative_to(found.root) and Path(found.location).is_dir()
        )
        return found.location not in self._named and (found.is_archive or leads_inside)

    def _document(self, found: FoundDocument, shown: str) -> list[Finding]:
        container = self._container(found)
        pulled = self._reader.pulled(container, found.name)
        schema = self._schema if any(rule.id == SCHEMA_RULE for rule in self._rules) else None
        content = _content(container, found.name) if pulled is None or schema is not None else b""
        if pulled is None:
            read, tree = self._reader.read_tree(content, found.name, container)
        else:
            read, tree = pulled.document, _once(pulled.tree)
        self._document_count += 1
        findings = self._linter.document(
            read, tree, lambda name: resolve_reference(container, found.name, name) is not None
        )
        if schema is not None:
            violations = schema.violations(parse_document(content).root, Lines(content), findings)
            findings = sorted([*findings, *violations], key=lambda finding: finding.line)
        self._facts.extend(facts_of_document(read, shown, self._signature))
        return findings

    def _signature(self, device: Device, modules: Iterable[Module], vendor_id: int | None) -> bytes:
        keys = [self._digests.module(module, vendor_id) for module in modules]
        return self._digests.device(device, vendor_id, keys)

    def _container(self, found: FoundDocument) -> Container:
        key = (found.root, found.nested)
        if self._opened is None or self._opened[0] != key:
            self._opened = (key, open_container(found.root, found.is_archive, found.nested))
        return self._opened[1]

    def _refused(self, shown: str, rule_id: str, error: DocumentError) -> Iterator[DocumentFinding]:
        """Tell that nothing of a document was checked, whatever rules are chosen."""
        self._document_count += 1
        if any(rule.id == rule_id for rule in self._rules):
            yield DocumentFinding(shown, Finding(rule_id, ERROR, str(error), error.line))
        else:
            self.unreadable.append(f"{shown}: {error}")


def _documents(item: FoundDocument | FoundArchive) -> Iterable[FoundDocument]:
    return archive_members(item) if isinstance(item, FoundArchive) else (item,)


def _content(container: Container, name: str) -> bytes:
    """The bytes of a document. Raises :class:`UnreadableDocument`: what it holds is then unknown."""
    try:
        return container.read(name)
    except BrokenDocument as error:
        raise UnreadableDocument(str(error)) from error


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
