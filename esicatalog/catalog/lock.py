"""One writer at a time: two ingests into one catalog would give their rows the same numbers."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from esicatalog.catalog.inspect_data import inspect_path, read_inspect_data
from esicatalog.catalog.own_files import LOCK_SUFFIX
from esicatalog.errors import CatalogError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


@contextlib.contextmanager
def only_writer(path: Path | None) -> Iterator[None]:
    """Hold the lock file beside an SQLite catalog; it is gone afterwards, and a killed process leaves it unlocked.

    SQLite's own lock ends with every transaction, an ingest has many. None (another database) locks nothing. Raises
    :class:`CatalogError` when another process holds it, or nobody can (as on some NFS), and for a snapshot, which never
    changes, whoever asks.
    """
    if path is None:
        yield
        return
    real = Path(os.path.realpath(path))
    _check_may_change(real, path)
    if fcntl is None:
        yield
        return
    lock = real.with_name(real.name + LOCK_SUFFIX)
    descriptor = _locked(lock, path)
    try:
        yield
    finally:
        lock.unlink(missing_ok=True)
        os.close(descriptor)


def is_read_only(file: Path) -> bool:
    """Whether a file is there and nobody was to write to it; the superuser could all the same."""
    return file.exists() and not file.stat().st_mode & 0o222


def _check_may_change(real: Path, path: Path) -> None:
    """Raise :class:`CatalogError` for a file that is not to be written, and for one that its counts describe."""
    if is_read_only(real):
        raise CatalogError(f"{path}: is read-only, as snapshots are, which never change; name another catalog")
    if _has_counts(real):
        raise CatalogError(
            f"{path}: {inspect_path(real).name} beside it describes it, as with snapshots, which never change; "
            "name another catalog"
        )


def _has_counts(real: Path) -> bool:
    try:
        return real.exists() and read_inspect_data(real) is not None
    except CatalogError:
        return False  # They are of another file, or of another time.


def _locked(lock: Path, path: Path) -> int:
    """A descriptor of the lock file, locked, while the file still has its name."""
    while True:
        try:
            descriptor = os.open(lock, os.O_RDWR | os.O_CREAT, 0o666)
        except OSError as error:
            raise CatalogError(f"{path}: the folder of the catalog cannot be written: {error.strerror}") from error
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if _is_named(descriptor, lock):
                return descriptor
        except BlockingIOError as error:
            os.close(descriptor)
            raise CatalogError(
                f"{path}: another ingest or migrate is writing to it; when that has ended, run this again"
            ) from error
        except OSError as error:
            os.close(descriptor)
            raise CatalogError(f"{path}: the folder of the catalog takes no locks: {error.strerror}") from error
        os.close(descriptor)


def _is_named(descriptor: int, lock: Path) -> bool:
    """Whether the name still means this file: who held the lock before has removed it at the end."""
    try:
        return os.path.samestat(os.fstat(descriptor), lock.stat())
    except FileNotFoundError:
        return False
