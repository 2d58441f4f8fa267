"""Whether a catalog holds all that it was given: an ingest commits as it goes, and may end anywhere."""

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.deferred_keys import are_keys_pending, is_empty
from esicatalog.catalog.document_status import FAILED
from esicatalog.catalog.load import are_indexes_pending
from esicatalog.catalog.state import CONTENT_HASH, read_state

CUT_SHORT = (
    "an ingest is under way or was cut short, so what is missing here may be described: wait for it, or run it again"
)
"""All that there is to say of a catalog whose ingest has not come to its end."""


def is_unfinished(connection: sa.Connection) -> bool:
    """Whether an ingest is under way or was cut short: what it has not read yet is missing.

    The first change of an ingest takes the hashes away, its end stores them. Another one that ends in between stores
    them too: what is left then are archives that were begun, and not those with documents that failed, for these were
    told. Which files of a folder are missing nothing tells.
    """
    if are_indexes_pending(connection):
        return True
    if read_state(connection, CONTENT_HASH) is None:
        return are_keys_pending(connection) or not is_empty(connection)
    archives, sources = schema.archives.c, schema.sources.c
    failed = sa.exists().where(sources.archive_id == archives.id, sources.status == FAILED, sources.sha256.is_(None))
    return connection.execute(sa.select(archives.id).where(archives.sha256 == "", ~failed).limit(1)).first() is not None
