"""From bytes to the rows that a catalog stores, the way a worker process goes: reader, derivation, lint, encoding."""

from esicatalog.catalog.rows import RowMaker
from esicatalog.errors import DocumentError
from esicatalog.esi.reader import Reader
from esicatalog.esi.write import write_esi
from esicatalog.ingest.tasks import Answer, Outcome
from esicatalog.lint.linter import Linter
from fuzz.reader import mutate, seeds

__all__ = ["check", "mutate", "seeds"]


def check(data: bytes) -> None:
    """Make rows of a document, and the document again."""
    try:
        read, tree = Reader().read_tree(data)
    except DocumentError:
        return
    rows = RowMaker().document(read, Linter().document(read, tree))
    Answer.to(Outcome(0, "stored", rows=rows))
    for info in read.document.infos:
        write_esi(info)
