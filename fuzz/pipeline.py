"""From bytes to the rows that a catalog stores, the way a worker process goes: reader, derivation, lint, encoding."""

from esicatalog.catalog.rows import RowMaker
from esicatalog.esi.write import write_esi
from esicatalog.ingest.tasks import Answer, Outcome
from fuzz import reader
from fuzz.reader import mutate, seeds

__all__ = ["check", "mutate", "seeds"]


def check(data: bytes) -> None:
    """Make rows of a document, and the document again."""
    read = reader.check(data)
    if read is None:
        return
    rows = RowMaker().document(read)
    Answer.to(Outcome(0, "stored", rows=rows))
    for info in read.document.infos:
        write_esi(info)
