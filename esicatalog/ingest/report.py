"""What an ingest did, document by document."""

from collections import Counter
from collections.abc import Mapping
from typing import Any, NamedTuple

from esicatalog.catalog.document_status import FAILED, RECOVERED, REMOVED, SKIPPED, STORED, UNCHANGED


class DocumentLine(NamedTuple):
    """One document: its path as given, what became of it, why, and what it holds; of a removed one, what it held."""

    path: str
    status: str
    """One of :mod:`~esicatalog.catalog.document_status`."""
    message: str | None
    devices: int
    modules: int


class IngestReport(NamedTuple):
    """All inputs of an ingest, all documents that it removed, and how long it took."""

    documents: list[DocumentLine]
    seconds: float
    profile: Mapping[str, float] = {}
    """Processor time by stage (:data:`~esicatalog.esi.stages.STAGES`), of all processes together."""
    is_in_file: bool = True
    """Whether the file alone is the catalog; else others were reading it, and the latest is in its log (``-wal``)."""

    @property
    def counts(self) -> dict[str, int]:
        """Documents by status, without those that were removed; ``stored`` includes the recovered ones."""
        counted = Counter(line.status for line in self.documents)
        return {
            STORED: counted[STORED] + counted[RECOVERED],
            UNCHANGED: counted[UNCHANGED],
            RECOVERED: counted[RECOVERED],
            SKIPPED: counted[SKIPPED],
            FAILED: counted[FAILED],
        }

    @property
    def removed(self) -> int:
        """Documents that the catalog had and no longer has."""
        return sum(line.status == REMOVED for line in self.documents)

    @property
    def devices(self) -> int:
        """Device elements in the documents that the catalog now holds."""
        return sum(line.devices for line in self.documents if line.status != REMOVED)

    @property
    def modules(self) -> int:
        """Module elements in the documents that the catalog now holds."""
        return sum(line.modules for line in self.documents if line.status != REMOVED)

    def as_json(self) -> dict[str, Any]:
        """The report in the shape of ``esicatalog ingest --format json``."""
        return {
            "sources": self.counts,
            "devices": self.devices,
            "modules": self.modules,
            "seconds": round(self.seconds, 3),
            "documents": [line._asdict() for line in self.documents],
        }
