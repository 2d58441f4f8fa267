"""What becomes of a document: the words that are stored (``sources.status``), reported and compared. No SQLAlchemy."""

STORED = "stored"
"""Read as it is; the catalog holds its content."""
RECOVERED = "recovered"
"""Read after its markup was repaired; the catalog holds what was left of its content, and ``message`` says why."""
SKIPPED = "skipped"
"""No ESI document, or none that is to be read from there; ``message`` says why, and the catalog has nothing of it."""
FAILED = "failed"
"""Should be one, and cannot be used or read; ``message`` says why."""
UNCHANGED = "unchanged"
"""Not read again: the catalog holds what it has. Reported, never stored."""
REMOVED = "removed"
"""Was among the documents, and no longer is; the catalog dropped what it had of it. Reported, never stored."""

WITH_CONTENT = frozenset({STORED, RECOVERED})
"""Of these documents the catalog holds devices, modules or what else there is in them."""
