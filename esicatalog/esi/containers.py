"""Where documents lie: folders and zip archives, with references that never lead outside.

A reference in an ESI file (``DictionaryFile``, ``DiagFile``, ``InfoReference``) is relative to the document, often
with Windows separators and another letter case than on disk. Member names are relative paths with ``/``.
"""

import io
import posixpath
import zipfile
from pathlib import Path, PurePosixPath
from typing import Protocol

from esicatalog.errors import BrokenDocument, InputError

MAX_DOCUMENT_BYTES = 256 * 1024 * 1024
"""Largest document that is read; real ESI files end at about 4 MB."""
MAX_MEMBERS = 100_000
MAX_EXPANDED_BYTES = 8 * 1024**3
MAX_NESTING = 3
NESTED = "!"
"""Separates an archive from its member: ``vendor.zip!EL/EL1xxx.xml``."""


class Container(Protocol):
    """A place with documents."""

    def read(self, member: str) -> bytes:
        """Bytes of a member; raises :class:`BrokenDocument` when they cannot be read."""

    def find(self, member: str) -> str | None:
        """The member with this name in any letter case, or None."""


def resolve_reference(container: Container, document: str, reference: str) -> str | None:
    """The member that ``reference`` in ``document`` means, or None when it is missing or leads outside."""
    text = reference.strip().replace("\\", "/")
    if not text or text.startswith("/") or ":" in text.split("/", 1)[0]:
        return None
    joined = posixpath.normpath(posixpath.join(posixpath.dirname(document), text))
    if joined.startswith(("../", "/")) or joined in ("..", "."):
        return None
    return container.find(joined)


class Folder:
    """Documents below a folder; symbolic links that lead outside are not followed."""

    def __init__(self, root: Path) -> None:
        self.root = root.resolve()
        self._listings: dict[str, dict[str, str]] = {}

    def read(self, member: str) -> bytes:
        """Bytes of the file ``member`` below the folder."""
        path = self.root / member
        try:
            if path.stat().st_size > MAX_DOCUMENT_BYTES:
                raise BrokenDocument(f"larger than {MAX_DOCUMENT_BYTES // 2**20} MB; no ESI document is")
            return path.read_bytes()
        except OSError as error:
            raise BrokenDocument(f"cannot be read: {error.strerror or error}") from error

    def find(self, member: str) -> str | None:
        """The file with this path in any letter case."""
        found = ""
        for step in PurePosixPath(member).parts:
            name = self._listing(found).get(step.lower())
            if name is None:
                return None
            found = f"{found}/{name}" if found else name
        path = self.root / found
        inside = path.resolve().is_relative_to(self.root)
        return found if inside and path.is_file() else None

    def _listing(self, folder: str) -> dict[str, str]:
        listing = self._listings.get(folder)
        if listing is None:
            try:
                names = sorted((entry.name for entry in (self.root / folder).iterdir()), reverse=True)
            except OSError:
                names = []
            listing = self._listings[folder] = {name.lower(): name for name in names}
        return listing


class Archive:
    """Documents in a zip archive, itself possibly a member of another one."""

    def __init__(self, source: Path | bytes) -> None:
        try:
            self._zip = zipfile.ZipFile(io.BytesIO(source) if isinstance(source, bytes) else source)
        except (OSError, zipfile.BadZipFile, ValueError, NotImplementedError) as error:
            raise InputError(f"not a usable zip archive: {error}") from error
        infos = [info for info in self._zip.infolist() if not info.is_dir()]
        if len(infos) > MAX_MEMBERS:
            raise InputError(f"archive with more than {MAX_MEMBERS} members")
        if sum(info.file_size for info in infos) > MAX_EXPANDED_BYTES:
            raise InputError(f"archive expands to more than {MAX_EXPANDED_BYTES // 2**30} GB")
        self._infos = {info.filename: info for info in infos}
        self._by_lower = {name.lower().replace("\\", "/"): name for name in sorted(self._infos, reverse=True)}

    def members(self) -> list[tuple[str, int]]:
        """Names and expanded sizes in bytes of all members, sorted by name."""
        return sorted((name, info.file_size) for name, info in self._infos.items())

    def read(self, member: str) -> bytes:
        """Expanded bytes of ``member``; never more than its header announces."""
        info = self._infos[member]
        if info.file_size > MAX_DOCUMENT_BYTES:
            raise BrokenDocument(f"larger than {MAX_DOCUMENT_BYTES // 2**20} MB; no ESI document is")
        try:
            with self._zip.open(info) as stream:
                content = stream.read(info.file_size + 1)
        except Exception as error:  # zlib.error and lzma.LZMAError share no base but Exception
            raise BrokenDocument(f"cannot be unpacked: {error}") from error
        if len(content) > info.file_size:
            raise BrokenDocument("expands to more than its header announces")
        return content

    def find(self, member: str) -> str | None:
        """The member with this path in any letter case."""
        return self._by_lower.get(member.lower())


def is_archive(content_head: bytes) -> bool:
    """Whether the first bytes are those of a zip archive."""
    return content_head[:4] in (b"PK\x03\x04", b"PK\x05\x06")
