"""Whether a document, with everything it pulls in, is still what the catalog holds."""

from esicatalog.errors import DocumentError, UnreadableDocument
from esicatalog.esi.containers import Container, resolve_reference
from esicatalog.esi.content import sha256_hex
from esicatalog.ingest.tasks import Known

Hashes = dict[str, dict[str, str | None]]
"""SHA-256 by folder and member; None where it cannot be read."""


class ReferenceHashes:
    """SHA-256 of documents and of what they refer to, each computed once a container; ``known`` are by member."""

    def __init__(self, container: Container, known: dict[str, str | None] | None = None) -> None:
        self._container = container
        self.known = known if known is not None else {}
        self._unreadable: set[str] = set()

    def may_be(self, document: str, reference: str, expected: str | None) -> bool:
        """Whether ``reference`` in ``document`` leads to what has this SHA-256, or to what only cannot be read now."""
        member = resolve_reference(self._container, document, reference)
        found = None if member is None else self.of_member(member)
        return found == expected or member in self._unreadable

    def of_member(self, member: str) -> str | None:
        """SHA-256 of a document of the container, None when it cannot be read."""
        if member not in self.known:
            try:
                self.known[member] = sha256_hex(self._container.read(member))
            except DocumentError as error:
                self.known[member] = None
                if isinstance(error, UnreadableDocument):
                    self._unreadable.add(member)
        return self.known[member]


def is_unchanged(known: Known, sha256: str, document: str, hashes: ReferenceHashes) -> bool:
    """Whether bytes and references are as the catalog knows them; what it holds of unreadable references is kept."""
    return known.sha256 == sha256 and all(
        hashes.may_be(document, reference, expected) for reference, expected in known.references
    )
