"""Whether a document, with everything it pulls in, is still what the catalog holds."""

from esicatalog.errors import DocumentError
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

    def sha256(self, document: str, reference: str) -> str | None:
        """SHA-256 of what ``reference`` in ``document`` leads to, None when nothing readable is there."""
        member = resolve_reference(self._container, document, reference)
        return None if member is None else self.of_member(member)

    def of_member(self, member: str) -> str | None:
        """SHA-256 of a document of the container, None when it cannot be read."""
        if member not in self.known:
            try:
                self.known[member] = sha256_hex(self._container.read(member))
            except DocumentError:
                self.known[member] = None
        return self.known[member]


def is_unchanged(known: Known, sha256: str, document: str, hashes: ReferenceHashes) -> bool:
    """Whether bytes and references are as the catalog knows them."""
    return known.sha256 == sha256 and all(
        hashes.sha256(document, reference) == expected for reference, expected in known.references
    )
