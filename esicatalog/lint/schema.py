"""Validation against the ETG schema files of the user; none are shipped."""

import re
from pathlib import Path

from lxml import etree

from esicatalog.errors import InputError
from esicatalog.esi.containers import Folder
from esicatalog.esi.notes import Finding
from esicatalog.lint.registry import WARNING
from esicatalog.lint.rules.reading import SCHEMA_RULE

_LIST, _LISTED = "EtherCATInfoList", "EtherCATInfo"
_POSITION = re.compile(r"\[(\d+)\]")


class SchemaFolder:
    """The schema files in a folder, each compiled when the first document needs it."""

    def __init__(self, folder: Path) -> None:
        """Raises :class:`InputError` when the folder has no EtherCATInfo.xsd that can be used."""
        self._folder = folder
        self._files = Folder(folder)
        self._compiled: dict[str, etree.XMLSchema | None] = {}
        if self._schema(_LISTED) is None:
            raise InputError(f"{folder}: no EtherCATInfo.xsd there; name the folder with the schema files of the ETG")

    def violations(self, root: etree._Element) -> list[Finding]:
        """Every violation with its kind; none for a document whose schema the folder lacks."""
        if root.tag == _LIST:
            return [finding for child in root.iterchildren(_LISTED) for finding in self._validate(child, _LISTED)]
        return self._validate(root, str(root.tag))

    def _validate(self, element: etree._Element, name: str) -> list[Finding]:
        schema = self._schema(name)
        if schema is None or schema.validate(element):
            return []
        found = {
            Finding(SCHEMA_RULE, WARNING, f"{error.message} ({error.type_name})", error.line, _element_path(error.path))
            for error in schema.error_log
        }
        return sorted(found, key=lambda finding: (finding.line, finding.path, finding.message))

    def _schema(self, name: str) -> etree.XMLSchema | None:
        if name not in self._compiled:
            file = self._files.find(f"{name}.xsd")
            try:
                path = self._folder / file if file is not None else None
                self._compiled[name] = etree.XMLSchema(file=str(path)) if path is not None else None
            except (etree.XMLSchemaParseError, etree.XMLSyntaxError) as error:
                raise InputError(f"{self._folder}: {file} cannot be used: {error}") from error
        return self._compiled[name]


def _element_path(path: str | None) -> str:
    """A path of libxml2 as findings have it: without leading slash, positions from 0."""
    return _POSITION.sub(lambda match: f"[{int(match[1]) - 1}]", (path or "").lstrip("/"))
