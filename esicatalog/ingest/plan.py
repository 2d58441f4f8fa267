"""What an ingest has to do: which documents are new or changed, which are unchanged, which are gone."""

import hashlib
import os
import re
from collections.abc import Iterable, Iterator, Set
from pathlib import Path
from typing import NamedTuple

from esicatalog.catalog.document_status import FAILED, REMOVED, SKIPPED, UNCHANGED, WITH_CONTENT
from esicatalog.esi.containers import NESTED, Folder, open_regular
from esicatalog.ingest.discover import FoundArchive, FoundDocument, archive_members, discover, unusable_archive
from esicatalog.ingest.report import DocumentLine
from esicatalog.ingest.tasks import Known, Outcome, Task
from esicatalog.ingest.unchanged import Hashes, ReferenceHashes, is_unchanged
from esicatalog.words import counted


class HeldDocument(NamedTuple):
    """What the catalog holds of a location; ``known`` is None when it has to be read again."""

    status: str
    message: str | None
    member: str
    devices: int
    modules: int
    archive: str | None
    """Location of the archive that it lies in."""
    known: Known | None

    def unchanged_line(self) -> DocumentLine:
        """Its line in a report that did not read it again."""
        status = self.status if self.status in (SKIPPED, FAILED) else UNCHANGED
        return DocumentLine(self.member, status, self.message, self.devices, self.modules)

    def unreadable_line(self, message: str | None) -> DocumentLine:
        """Its line in a report when it could not be read: the catalog keeps what it holds of it."""
        words = f"{message}; the catalog keeps what it has of it"
        return DocumentLine(self.member, FAILED, words, self.devices, self.modules)

    def removed_line(self) -> DocumentLine:
        """Its line in a report when the catalog drops it."""
        described = f"{counted(self.devices, 'device')} and {counted(self.modules, 'module')}"
        message = f"no longer among the documents; it described {described}"
        return DocumentLine(self.member, REMOVED, message, self.devices, self.modules)

    @property
    def has_content(self) -> bool:
        """Whether the document brought anything that is worth keeping."""
        return self.status in WITH_CONTENT


class Held(NamedTuple):
    """What the catalog holds: documents by location, and the sha256 of completely read archives by location."""

    documents: dict[str, HeldDocument]
    archives: dict[str, str]


NOTHING_HELD = Held({}, {})


class Plan(NamedTuple):
    """The work of an ingest. ``todo`` is in reading order; outcomes are numbered by its positions."""

    unchanged: list[DocumentLine]
    todo: list[FoundDocument]
    tasks: list[Task]
    problems: list[Outcome]
    """Outcomes of inputs that cannot be read at all."""
    gone: list[str]
    """Locations whose content has to go."""
    archives: dict[str, str]
    """Archives that are read, with their sha256."""

    @property
    def document_count(self) -> int:
        """Inputs in all."""
        return len(self.unchanged) + len(self.todo)

    @property
    def is_empty(self) -> bool:
        """Whether the catalog stays as it is."""
        return not (self.todo or self.gone or self.archives)


def make_plan(
    paths: Iterable[str | os.PathLike[str]],
    held: Held = NOTHING_HELD,
    prune: bool = False,
    hashed: Hashes | None = None,
    own_files: Set[str] = frozenset(),
) -> Plan:
    """Compare what lies below the paths with what the catalog holds, ``hashed`` being known already.

    ``own_files`` are the catalog's. Raises :class:`InputError`.
    """
    given = list(paths)
    below = _look_below(discover(given, own_files), held)
    gone = _gone(below, held, [os.path.realpath(path) for path in given] if prune else [], own_files)
    unchanged, todo = _compared(below.documents, held, hashed or {})
    todo.sort(key=_reading_order)
    return Plan(
        below.unchanged + unchanged,
        todo,
        [_task(number, item, held) for number, item in enumerate(todo) if item.problem is None],
        [Outcome(number, *item.problem) for number, item in enumerate(todo) if item.problem is not None],
        gone,
        below.archives,
    )


class _Below(NamedTuple):
    """What lies below the paths, archives opened where they are not what the catalog has read already."""

    documents: list[FoundDocument]
    archives: dict[str, str]
    """Archives that were opened, with their sha256."""
    known_archives: set[str]
    """Archives that are unchanged."""
    known: set[str]
    """Locations of what these hold."""
    unchanged: list[DocumentLine]
    """The lines of these."""


def _look_below(found: Iterable[FoundDocument | FoundArchive], held: Held) -> _Below:
    below = _Below([], {}, set(), set(), [])
    inside: dict[str | None, list[tuple[str, HeldDocument]]] = {}
    for where, document in held.documents.items():
        inside.setdefault(document.archive, []).append((where, document))
    for item in found:
        if not isinstance(item, FoundArchive):
            below.documents.append(_as_from_outer_folder(item, held.documents.get(item.location)))
            continue
        members = _members(item, inside.get(item.location, []))
        item = _archive_from_outer_folder(item, members)
        try:
            sha256 = _file_sha256(item.location)
        except OSError as error:
            problem = unusable_archive(item, FAILED, f"cannot be read: {error.strerror or error}")
            below.documents.append(problem._replace(is_unreadable=True))
            continue
        if sha256 == held.archives.get(item.location) and all(_is_named_by(item, member) for _, member in members):
            below.known_archives.add(item.location)
            below.known.update(where for where, _ in members)
            below.unchanged.extend(document.unchanged_line() for _, document in members)
        else:
            below.archives[item.location] = sha256
            below.documents.extend(archive_members(item))
    return below._replace(documents=list(_one_of_each(below.documents, below.known)))


def _as_from_outer_folder(item: FoundDocument, known: HeldDocument | None) -> FoundDocument:
    """A file as it was found before below an outer folder: what it refers to may lie there, outside of the inner one.

    So it is, too, where both folders are given at once.
    """
    if known is None or item.problem is not None or len(known.member) <= len(item.member):
        return item
    root = Path(item.location).parents[known.member.count("/")]
    return item._replace(member=known.member, root=str(root), name=known.member)


def _archive_from_outer_folder(item: FoundArchive, members: Iterable[tuple[str, HeldDocument]]) -> FoundArchive:
    """The same of an archive, of which only the name differs: its members refer to nothing outside of it."""
    known = (document.member.removesuffix(where.removeprefix(item.location)) for where, document in members)
    names = [item.member, *(name for name in known if item.location.endswith(f"{os.sep}{name}"))]
    return item._replace(member=max(names, key=len))


def _one_of_each(documents: Iterable[FoundDocument], known: Set[str]) -> Iterator[FoundDocument]:
    """A file may be called what a member of an archive beside it is called: it does not take the other's place."""
    met = set(known)
    for item in documents:
        if item.location in met:
            words = (FAILED, "another file, or a member of an archive, goes by this name; rename one of them")
            yield item._replace(location=f"{item.location} (again)", member=f"{item.member} (again)", problem=words)
        else:
            met.add(item.location)
            yield item


def _gone(below: _Below, held: Held, pruned: list[str], own_files: Set[str]) -> list[str]:
    """Locations that the catalog holds and that have to go."""
    closed = tuple(
        item.location + separator for item in below.documents if item.is_unreadable for separator in (os.sep, NESTED)
    )
    there = below.known.union(item.location for item in below.documents)
    gone = [where for where in held.documents if where not in there and not where.startswith(closed)]
    if not gone:
        return []
    containers = below.known_archives.union(below.archives)
    containers.update(folder for item in below.documents if not item.is_archive for folder in _folders(item.location))
    files = {item.location for item in below.documents if item.problem is None and not item.is_archive}
    changes = _Changes(below.archives, containers, files, pruned)
    return [where for where in gone if where in own_files or changes.displace(where, held.documents[where])]


def _compared(
    documents: list[FoundDocument], held: Held, hashed: Hashes
) -> tuple[list[DocumentLine], list[FoundDocument]]:
    """The lines of documents that stay as the catalog has them, and the documents to read."""
    unchanged: list[DocumentLine] = []
    todo: list[FoundDocument] = []
    hashes = _PerFolder(hashed)
    for item in documents:
        known = held.documents.get(item.location)
        if known is not None and item.is_unreadable and known.has_content:
            unchanged.append(known.unreadable_line(item.problem[1] if item.problem is not None else None))
        elif known is not None and _file_unchanged(item, known, hashes[item.root]):
            unchanged.append(known.unchanged_line())
        else:
            todo.append(item)
    return unchanged, todo


class _PerFolder(dict[str, ReferenceHashes]):
    """Each file is hashed once, whether it stands alone or others refer to it."""

    def __init__(self, hashed: Hashes) -> None:
        self._hashed = hashed

    def __missing__(self, root: str) -> ReferenceHashes:
        return self.setdefault(root, ReferenceHashes(Folder(Path(root)), self._hashed.get(root)))


def _reading_order(item: FoundDocument) -> tuple[int, int, str]:
    """Short paths first: a document comes before those it refers to, which lie beside or below it; small ones first,
    because a small document may pull in large ones.
    """
    return (item.member.count("/"), item.size_bytes, item.location)


def _task(number: int, item: FoundDocument, held: Held) -> Task:
    document = held.documents.get(item.location)
    known = document.known if document is not None and document.member == item.member else None
    return Task(number, item.root, item.is_archive, item.nested, item.name, known)


def _members(archive: FoundArchive, inside: list[tuple[str, HeldDocument]]) -> list[tuple[str, HeldDocument]]:
    """What the catalog holds of the members of an archive; of one that could not be used, the line that says so."""
    members = [(where, document) for where, document in inside if where != archive.location]
    return members or inside


def _is_named_by(archive: FoundArchive, document: HeldDocument) -> bool:
    """Whether a document has its name from the archive as it is found now: below another folder it has another one."""
    return document.member == archive.member or document.member.startswith(archive.member + NESTED)


def _folders(location: str) -> Iterator[str]:
    """The folders that a file lies in."""
    for match in re.finditer(re.escape(os.sep), location):
        yield location[: match.start()]


class _Changes(NamedTuple):
    """What lies below the paths now, of all that was held there before."""

    archives: dict[str, str]
    """Archives that are read again."""
    containers: set[str]
    """Archives and folders."""
    files: set[str]
    """Documents that are not in an archive."""
    pruned: list[str]

    def displace(self, location: str, document: HeldDocument) -> bool:
        """Whether a document that was not found has to go: what is there in its place shows that, or it is pruned."""
        archive = document.archive
        return (
            archive in self.archives
            or archive in self.files
            or location in self.containers
            or any(folder in self.files for folder in _folders(archive or location))
            or any(location == path or location.startswith(path + os.sep) for path in self.pruned)
        )


def _file_unchanged(item: FoundDocument, document: HeldDocument, hashes: ReferenceHashes) -> bool:
    """Whether a file on disk is still what the catalog holds; members of archives are compared where they are read."""
    if document.known is None or item.is_archive or item.problem is not None or document.member != item.member:
        return False
    sha256 = hashes.of_member(item.name)
    return sha256 is not None and is_unchanged(document.known, sha256, item.name, hashes)


def _file_sha256(path: str) -> str:
    with open_regular(path) as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
