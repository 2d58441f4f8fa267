"""Whether a document, with everything it pulls in, is still what the catalog holds."""

from esicatalog.errors import DocumentError
from esicatalog.esi.containers import Container, resolve_reference
from esicatalog.esi.content import sha256_hex
from esicatalog.ingest.tasks import Known


class ReferenceHashes:
    """SHA-256 of documents and of what they refer to, each computed once a container."""

    def __init__(self, container: Container) -> None:
        self._container = container
        self._known: dict[str, str | None] = {}

    def sha256(self, document: str, reference: str) -> str | None:
        """SHA-256 of what ``reference`` in ``document`` leads to, None when nothing readable is there."""
        member = resolve_reference(self._container, document, reference)
        return None if member is None else self.of_member(member)

    def of_member(self, member: str) -> str | None:
        """SHA-256 of a document of the container, None when it cannot be read."""
        if member not in self._known:
            try:
                self._known[member] = sha256_hex(self._container.read(member))
            except DocumentError:
                self._known[member] = None
        return self._known[member]


def is_unchanged(known: Known, sha256: str, document: str, hashes: ReferenceHashes) -> bool:
    """Whether bytes and references are as the catalog knows them."""
    return known.sha256 == sha256 and all(
        hashes.sha256(document, reference) == expected for reference, expected in known.references
    )
