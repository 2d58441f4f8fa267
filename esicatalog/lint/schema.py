"""Validation against the ETG schema files of the user; none are shipped."""

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from lxml import etree

from esicatalog.errors import InputError
from esicatalog.esi.containers import Folder
from esicatalog.esi.element_paths import ElementPaths
from esicatalog.esi.lines import Lines
from esicatalog.esi.notes import Finding
from esicatalog.lint.registry import WARNING
from esicatalog.lint.rules.reading import SCHEMA_RULE

_LIST, _LISTED = "EtherCATInfoList", "EtherCATInfo"
_SUBJECT = re.compile(r"Element '(?P<tag>[^']+)'(?:, attribute '(?P<attribute>[^']+)')?: ")
"""How libxml2 begins to tell what it is about."""


class SchemaFolder:
    """The schema files in a folder, each compiled when the first document needs it."""

    def __init__(self, folder: Path) -> None:
        """Raises :class:`InputError` when the folder has no EtherCATInfo.xsd that can be used."""
        self._folder = folder
        self._files = Folder(folder)
        self._compiled: dict[str, etree.XMLSchema | None] = {}
        if self._schema(_LISTED) is None:
            raise InputError(f"{folder}: no EtherCATInfo.xsd there; name the folder with the schema files of the ETG")

    def violations(self, root: etree._Element, lines: Lines, told: Iterable[Finding] = ()) -> list[Finding]:
        """Every violation with its kind, but of a value of which ``told`` has it; none for a document whose schema the
        folder lacks. ``lines`` are those of the tree.
        """
        paths = ElementPaths()
        values = {(item.path, item.message.partition(": ")[0]) for item in told if item.rule == SCHEMA_RULE}
        found = set()
        for part in root.iterchildren(_LISTED) if root.tag == _LIST else (root,):
            for element, message, kind in self._errors(part):
                path = paths.path(element)
                if (path, _value(message)) not in values:
                    found.add(Finding(SCHEMA_RULE, WARNING, f"{message} ({kind})", lines.of(element), path))
        return sorted(found, key=lambda finding: (finding.line, finding.path, finding.message))

    def _errors(self, root: etree._Element) -> Iterator[tuple[etree._Element, str, str]]:
        """What is wrong below an element: where, the message of libxml2, and its kind.

        The path of an error begins with that element; its line is not always known to libxml2.
        """
        schema = self._schema(str(root.tag))
        if schema is not None and not schema.validate(root):
            for error in schema.error_log:
                _, _, below = (error.path or "").lstrip("/").partition("/")
                elements = root.xpath(below) if below else []
                yield elements[0] if elements else root, error.message, error.type_name

    def _schema(self, name: str) -> etree.XMLSchema | None:
        if name not in self._compiled:
            file = self._files.find(f"{name}.xsd")
            try:
                path = self._folder / file if file is not None else None
                self._compiled[name] = etree.XMLSchema(file=str(path)) if path is not None else None
            except (etree.XMLSchemaParseError, etree.XMLSyntaxError) as error:
                raise InputError(f"{self._folder}: {file} cannot be used: {error}") from error
        return self._compiled[name]


def _value(message: str) -> str:
    """The value that a violation is about, as the findings of the reader name it: ``Sm/@Enable``."""
    found = _SUBJECT.match(message)
    return "/@".join(filter(None, found.groups())) if found is not None else ""
