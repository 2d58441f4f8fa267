"""All exceptions of the package, one small tree."""


class EsiCatalogError(Exception):
    """Base of everything that esicatalog raises on purpose; its text is one line for the user."""


class DocumentError(EsiCatalogError):
    """A document cannot be used; ``line`` tells where, 0 when unknown."""

    def __init__(self, message: str, line: int = 0) -> None:
        super().__init__(message)
        self.line = line


class NotAnEsiDocument(DocumentError):
    """The document is something else (ENI, schema, no XML at all): skip it, it is not broken."""


class BrokenDocument(DocumentError):
    """The document should be ESI, but nothing usable can be read from it."""


class UnreadableDocument(BrokenDocument):
    """The document is there, but cannot be read now, for want of permission for instance; what it holds is unknown."""


class InputError(EsiCatalogError):
    """A path, number, identity or option that cannot be used."""


class CatalogError(EsiCatalogError):
    """The database is not a usable catalog: missing, foreign, damaged, too new, or locked."""


class NotFound(EsiCatalogError):
    """The catalog, or the document that was given, holds no such device or module.

    ``hint`` is a command that tells more, for who is at a shell.
    """

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint
