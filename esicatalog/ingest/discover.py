"""Finding documents: folders (recursive), single files, zip archives (nested ones too)."""

import os
import re
import stat
from collections.abc import Iterable, Iterator, Set
from pathlib import Path
from typing import NamedTuple, TypeVar

from esicatalog.catalog.document_status import FAILED, SKIPPED
from esicatalog.errors import EsiCatalogError, InputError, UnreadableDocument
from esicatalog.esi import containers
from esicatalog.esi.containers import MAX_NESTING, NESTED, Archive, is_archive, is_unreadable, no_file_reason
from esicatalog.esi.content import MAX_KEY_BYTES, sha256_hex


class FoundDocument(NamedTuple):
    """A document that may be read, or (with ``problem``) an input that cannot be."""

    location: str
    """Absolute path; archive!member inside archives."""
    member: str
    """Path relative to the folder that was given; what reports show."""
    root: str
    is_archive: bool
    nested: tuple[str, ...]
    name: str
    size_bytes: int
    problem: tuple[str, str] | None = None
    """(status, words): ``skipped`` or ``failed``."""
    is_unreadable: bool = False
    """Whether this file, archive or folder is there, so that it may hold what it held before."""


class FoundArchive(NamedTuple):
    """A zip archive; its members are listed only when it is opened."""

    location: str
    member: str


Item = TypeVar("Item", bound=FoundDocument | FoundArchive)

_EMPTY = "an archive without files"
_UNUSABLE_NAME = re.compile("[\x00-\x1f\x7f-\x9f\ud800-\udfff]")


def discover(
    paths: Iterable[str | os.PathLike[str]], own_files: Set[str] = frozenset()
) -> Iterator[FoundDocument | FoundArchive]:
    """Everything below the paths, each location once, sorted by name; archives are not opened.

    ``own_files`` of the catalog that is being filled are left out. Raises :class:`InputError` for a path that does
    not exist.
    """
    seen = set(own_files)
    # Outer folders first: what lies below two of the paths is named relative to the outer one, whatever the order.
    for real in sorted(map(_existing, paths)):
        found = _folder(real) if real.is_dir() else [_file(real, real.parent, archive_by_content=True)]
        for item in map(_with_usable_name, found):
            if item.location not in seen:
                seen.add(item.location)
                yield item


def _existing(path: str | os.PathLike[str]) -> Path:
    if not os.fspath(path):  # a variable that is not set; Path would take it for the folder that we are in
        raise InputError("the name is empty; give a file, a folder or an archive")
    try:
        return Path(path).resolve(strict=True)
    except (OSError, RuntimeError, ValueError) as error:
        raise InputError(f"{os.fspath(path)}: {no_file_reason(path) or 'no such file or folder'}") from error


def _folder(root: Path) -> Iterator[FoundDocument | FoundArchive]:
    problems: list[FoundDocument] = []

    def unreadable(error: OSError) -> None:
        path = Path(error.filename)
        problem = _problem(path, root, FAILED, f"folder cannot be read: {error.strerror}")
        problems.append(problem._replace(is_unreadable=True))

    for folder, subfolders, names in os.walk(root, onerror=unreadable):
        subfolders.sort()
        for name in subfolders:
            path = Path(folder, name)
            # Path.is_symlink() raises where the folder may be listed and not entered.
            if os.path.islink(path):  # noqa: PTH114
                yield _problem(path, root, SKIPPED, "symbolic link to a folder; name the folder itself to read it")
        for name in sorted(names):
            yield _file(Path(folder, name), root)
    yield from problems


def _file(path: Path, root: Path, archive_by_content: bool = False) -> FoundDocument | FoundArchive:
    try:
        status = path.stat()
        if path.is_symlink() and not path.resolve().is_relative_to(root):
            return _problem(path, root, SKIPPED, "symbolic link that leads outside the folder")
        if not stat.S_ISREG(status.st_mode):
            return _problem(path, root, SKIPPED, "not a regular file")
        if archive_by_content or path.suffix.lower() == ".zip":
            with path.open("rb") as stream:
                if is_archive(stream.read(4)):
                    return FoundArchive(str(path), path.relative_to(root).as_posix())
    except OSError as error:
        problem = _problem(path, root, FAILED, f"cannot be read: {error.strerror}")
        return problem._replace(is_unreadable=is_unreadable(error))
    member = path.relative_to(root).as_posix()
    return FoundDocument(str(path), member, str(root), False, (), member, status.st_size)


def _with_usable_name(item: Item) -> Item | FoundDocument:
    """An input as it is, or the problem that its name can be neither stored nor printed."""
    if _UNUSABLE_NAME.search(item.location) is not None:
        words = "its name holds control characters or is not UTF-8; rename it"
    elif len(item.location.encode()) > MAX_KEY_BYTES:
        words = f"its path has more than {MAX_KEY_BYTES:,} bytes; move or rename it"
    else:
        return item
    location, member = map(_usable, (item.location, item.member))
    problem = (FAILED, words)
    if isinstance(item, FoundDocument):
        return item._replace(location=location, member=member, problem=problem)
    return FoundDocument(location, member, location, False, (), member, 0, problem)


def _usable(name: str) -> str:
    """A name that can be stored and printed, another one for each name."""
    escaped = _UNUSABLE_NAME.sub(_escaped, name)
    content = escaped.encode()
    if len(content) <= MAX_KEY_BYTES:
        return escaped
    end = f"… {sha256_hex(content)}"
    return content[: MAX_KEY_BYTES - len(end.encode())].decode(errors="ignore") + end


def _escaped(match: re.Match[str]) -> str:
    return match[0].encode("unicode_escape").decode("ascii")


def _problem(path: Path, root: Path, status: str, words: str) -> FoundDocument:
    return FoundDocument(
        str(path), path.relative_to(root).as_posix(), str(root), False, (), path.name, 0, (status, words)
    )


def archive_members(archive: FoundArchive) -> Iterator[FoundDocument]:
    """The documents in an archive and in the archives inside it."""
    try:
        opened = Archive(Path(archive.location))
    except EsiCatalogError as error:
        problem = unusable_archive(archive, FAILED, str(error))
        yield problem._replace(is_unreadable=isinstance(error, UnreadableDocument))
        return
    if not opened.members():
        yield unusable_archive(archive, SKIPPED, _EMPTY)
        return
    yield from map(_with_usable_name, _members(archive, opened, (), _Allowance()))


def unusable_archive(archive: FoundArchive, status: str, words: str) -> FoundDocument:
    """The line of an archive from which no member comes."""
    return FoundDocument(archive.location, archive.member, archive.location, True, (), "", 0, (status, words))


class _Allowance:
    """What an archive and all archives inside it may hold together."""

    def __init__(self) -> None:
        self._members = containers.MAX_MEMBERS
        self._bytes = containers.MAX_EXPANDED_BYTES

    def take(self, opened: Archive) -> None:
        """Raise :class:`InputError` when there is too much with what ``opened`` holds."""
        self._members -= len(opened.members())
        self._bytes -= opened.expanded_bytes
        if self._members < 0 or self._bytes < 0:
            raise InputError("too much in the archives inside the archive; unpack it and name the folder")


def _members(
    archive: FoundArchive, opened: Archive, nested: tuple[str, ...], allowance: _Allowance
) -> Iterator[FoundDocument]:
    allowance.take(opened)
    for name in opened.repeated:
        found = _member(archive, nested, name, 0)
        words = (FAILED, "another member has the same name, and is the one that is read; pack the archive anew")
        yield found._replace(location=f"{found.location} (earlier)", member=f"{found.member} (earlier)", problem=words)
    for name, size in opened.members():
        found = _member(archive, nested, name, size)
        if not name.lower().endswith(".zip"):
            yield found
            continue
        try:
            if len(nested) + 1 >= MAX_NESTING:
                raise InputError(f"archives nested deeper than {MAX_NESTING}")
            inner = Archive(opened.read(name))
            if inner.members():
                yield from _members(archive, inner, (*nested, name), allowance)
            else:
                yield found._replace(problem=(SKIPPED, _EMPTY))
        except EsiCatalogError as error:
            yield found._replace(problem=(FAILED, str(error)), is_unreadable=isinstance(error, UnreadableDocument))


def _member(archive: FoundArchive, nested: tuple[str, ...], name: str, size: int) -> FoundDocument:
    inside = NESTED.join((*nested, name))
    return FoundDocument(
        f"{archive.location}{NESTED}{inside}",
        f"{archive.member}{NESTED}{inside}",
        archive.location,
        True,
        nested,
        name,
        size,
    )
