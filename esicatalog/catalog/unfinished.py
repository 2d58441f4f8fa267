"""Whether a catalog holds all that it was given: an ingest commits as it goes, and may end anywhere."""

import sqlalchemy as sa

from esicatalog.catalog.deferred_keys import are_keys_pending, is_empty
from esicatalog.catalog.load import are_indexes_pending
from esicatalog.catalog.state import CONTENT_HASH, read_state

CUT_SHORT = (
    "an ingest is under way or was cut short, so what is missing here may be described: wait for it, or run it again"
)
"""All that there is to say of a catalog whose ingest has not come to its end."""


def is_unfinished(connection: sa.Connection) -> bool:
    """Whether an ingest is under way or was cut short: what it has not read yet is missing.

    The first change of an ingest takes the hashes away, its end stores them. So does the end of another one: nothing
    tells from then on what the first one had left.
    """
    if are_indexes_pending(connection):
        return True
    is_ended = read_state(connection, CONTENT_HASH) is not None
    return not is_ended and (are_keys_pending(connection) or not is_empty(connection))
