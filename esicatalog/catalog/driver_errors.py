"""What a database driver complains of, in one line with what to do."""

import re
from collections.abc import Mapping

import sqlalchemy as sa

from esicatalog.errors import CatalogError
from esicatalog.words import one_line

_NOTHING_STORED = "nothing of the last step was stored"
_DAMAGED = "the file is damaged; delete it and ingest again"
_PART_MISSING = "a part of the catalog is missing; delete it and ingest again"
_IN_THE_WAY = "what has that name is no part of a catalog; name another database"
_NO_ACCESS = "user or password do not fit"
_NO_DATABASE = "make the database first, with createdb or CREATE DATABASE"
_NO_RIGHT = "the database user may not do that; ask for the right"
_LATER = "try again later"

_FILE_HINTS = {
    "locked": "another process is reading or writing it; wait for it or use another catalog",
    "not a database": "not an SQLite catalog; name another file",
    "malformed": _DAMAGED,
    "readonly": "the file or its folder cannot be written",
    "unable to open": "the file or its folder cannot be opened",
    "full": "the disk is full",
    "disk I/O error": "the disk cannot be read or written, it may be full",
    "no such table": _PART_MISSING,
    "no such column": _PART_MISSING,
    "already exists": _IN_THE_WAY,
    "decode": _DAMAGED,
}
"""By words of SQLite."""
_STATE_HINTS = {
    "25006": "the database takes no changes; name the server that does",
    "28": _NO_ACCESS,
    "2BP01": "drop that, and make it anew afterwards",
    "3D000": _NO_DATABASE,
    "40": "repeat it",
    "42501": _NO_RIGHT,
    "42703": _PART_MISSING,
    "42P01": _PART_MISSING,
    "42P07": _IN_THE_WAY,
    "53100": "the disk of the server is full",
    "53": f"the server has no more to give; {_LATER}",
    "54": "more than the server can store in one place",
    "57P": f"the server has ended the connection; {_LATER}",
}
"""By SQLSTATE or the beginning of one (PostgreSQL, appendix A), the longest first."""
_CONNECTION_HINTS = {
    "role '' does not exist": "name a user that the server knows",
    "database '' does not exist": _NO_DATABASE,
    "authentication": _NO_ACCESS,
    "no password supplied": _NO_ACCESS,
    "pg_hba.conf": _NO_ACCESS,
    "permission denied": _NO_RIGHT,
    "resolve host": "no such host",
    "server running": "no server answers there; look at host, port and whether it runs",
    "connection is closed": f"the connection was lost; {_LATER}",
    "server closed the connection": f"the connection was lost; {_LATER}",
    "database system is": _LATER,  # shutting down, starting up
}
"""By words of PostgreSQL and its client where there is no SQLSTATE; names are taken out."""
_QUOTED = re.compile("\"[^\"]*\"|'[^']*'")
"""Names of users, databases and hosts, which can be any of those words."""


def driver_message(target: str, error: BaseException | None, is_writing: bool = False) -> str:
    """What went wrong in the database driver, with what to do; who was writing learns what became of that."""
    diagnosis = getattr(error, "diag", None)
    if diagnosis is None:
        words = str(error)
        hint = _hint_of_words(words, _FILE_HINTS)
    elif diagnosis.sqlstate is None:
        words = str(error)
        hint = _hint_of_words(_QUOTED.sub("''", words), _CONNECTION_HINTS)
    else:
        # The server's own hint would be CASCADE, which drops what others have made.
        words = ": ".join(filter(None, (diagnosis.message_primary, diagnosis.message_detail)))
        hint = next((_STATE_HINTS[key] for key in _beginnings(diagnosis.sqlstate) if key in _STATE_HINTS), None)
    reason = one_line(words)
    return f"{target}: " + "; ".join(filter(None, (reason, hint, _NOTHING_STORED if is_writing else None)))


def _beginnings(sqlstate: str) -> list[str]:
    return [sqlstate[:length] for length in range(len(sqlstate), 0, -1)]


def _hint_of_words(reason: str, hints: Mapping[str, str]) -> str | None:
    return next((hint for words, hint in hints.items() if words in reason), None)


def database_error(target: str, error: sa.exc.DBAPIError, is_writing: bool = False) -> CatalogError:
    """A database error in words, with what to do."""
    return CatalogError(driver_message(target, error.orig, is_writing))


def damage_error(target: str, error: Exception) -> CatalogError:
    """A stored value that cannot be decoded."""
    return CatalogError(f"{target}: a value cannot be read ({error}); {_DAMAGED}")
