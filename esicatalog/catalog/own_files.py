"""The files that an SQLite catalog consists of, wherever it lies: none of them is a document."""

import os

LOCK_SUFFIX = "-ingest"
INSPECT_SUFFIX = ".inspect.json"
_SUFFIXES = ("", LOCK_SUFFIX, "-journal", "-wal", "-shm", INSPECT_SUFFIX)


def own_files(target: str | os.PathLike[str]) -> frozenset[str]:
    """Absolute paths of all files that the catalog in a file or at a URL may have; none for one on a server.

    Found without SQLAlchemy: reading begins before that is loaded.
    """
    path = os.fspath(target)
    if "://" in path:
        driver, _, place = path.partition("://")
        path = place.removeprefix("/") if driver.startswith("sqlite") else ""
    if not path:
        return frozenset()
    # SQLite follows a symbolic link and keeps its journals beside the file; the link itself is no document either.
    folder, name = os.path.split(path)
    places = (os.path.realpath(path), os.path.join(os.path.realpath(folder), name))  # noqa: PTH118
    return frozenset(place + suffix for place in places for suffix in _SUFFIXES)
