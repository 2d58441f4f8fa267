"""What is asked of a worker and what it answers."""

import msgspec

from esicatalog.catalog.rows import DocumentRows


class Known(msgspec.Struct, frozen=True):
    """What the catalog holds of a document: its sha256 and those of the documents it pulls in."""

    sha256: str
    references: tuple[tuple[str, str | None], ...] = ()
    """(reference as the vendor wrote it, sha256 of what was found)."""


class Task(msgspec.Struct, frozen=True):
    """One document to read: ``member`` of the folder or archive ``root``, inside ``nested`` archives if any."""

    number: int
    root: str
    is_archive: bool
    nested: tuple[str, ...]
    member: str
    known: Known | None = None


class Outcome(msgspec.Struct):
    """What became of a document; ``status`` is one of :mod:`~esicatalog.catalog.document_status`."""

    number: int
    status: str
    message: str | None = None
    sha256: str | None = None
    byte_count: int | None = None
    rows: DocumentRows | None = None
    seconds: dict[str, float] = {}
    """Processor time by stage."""
    is_unreadable: bool = False
    """Whether the document is there and only could not be read now, or whoever read it did not come to its end."""


class Answer(msgspec.Struct):
    """What a worker process sends: an outcome, still encoded, and the documents that it pulled in."""

    references: list[str]
    outcome: msgspec.Raw

    @classmethod
    def to(cls, outcome: Outcome) -> "Answer":
        """The answer that carries ``outcome``."""
        references = outcome.rows.references if outcome.rows is not None else []
        found = [location for _, _, location, _ in references if location is not None]
        return cls(found, msgspec.Raw(_encode(outcome)))


_encode = msgspec.msgpack.Encoder().encode
