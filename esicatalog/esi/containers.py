"""Where documents lie: folders and zip archives, with references that never lead outside.

A reference in an ESI file (``DictionaryFile``, ``DiagFile``, ``InfoReference``) is relative to the document, often
with Windows separators and another letter case than on disk; a file that is written as there comes first. Member names
are relative paths with ``/``.
"""

import contextlib
import copy
import errno
import io
import os
import posixpath
import re
import stat
import unicodedata
import zipfile
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Protocol

from zlib_ng import zlib_ng

from esicatalog.errors import BrokenDocument, EsiCatalogError, InputError, UnreadableDocument

MAX_DOCUMENT_BYTES = 256 * 1024 * 1024
"""Largest document that is read, and largest archive inside another. Real ESI files end at about 10 MB; all devices of
a large vendor in one document, as ``export esi --vendor`` writes them, are 120."""
MAX_MEMBERS = 100_000
MAX_EXPANDED_BYTES = 8 * 1024**3
"""Of all members of an archive together."""
MAX_RATIO = 500
"""Expanded to packed size of a member; real ESI files end at 70, deflate at 1030."""
MAX_NESTING = 3
_SMALL_BYTES = 1024 * 1024
"""Members up to here may have any ratio."""
_MAX_DIRECTORY_BYTES = 256 * MAX_MEMBERS
_HERE = re.compile(r"(?:\./)+(?=.)", re.DOTALL)
_ENCRYPTED, _IN_UTF_8 = 0x1, 0x800
"""Bits of a member's flags."""
NESTED = "!"
"""Separates an archive from its member: ``vendor.zip!EL/EL1xxx.xml``."""


TOO_LARGE = f"larger than {MAX_DOCUMENT_BYTES // 2**20} MB; no ESI document is"


class Container(Protocol):
    """A place with documents."""

    def read(self, member: str) -> bytes:
        """Bytes of a member; raises :class:`BrokenDocument` when they cannot be read."""

    def find(self, member: str) -> str | None:
        """The member with this name, else the closest one in another letter case, or None."""


def reference_path(reference: str) -> str:
    """The path that a reference means; some vendors write it with backslashes."""
    return reference.strip().replace("\\", "/")


def resolve_reference(container: Container, document: str, reference: str) -> str | None:
    """The member that ``reference`` in ``document`` means, or None when it is missing or leads outside."""
    text = reference_path(reference)
    if not text or text.startswith("/") or ":" in text.split("/", 1)[0]:
        return None
    joined = posixpath.normpath(posixpath.join(posixpath.dirname(document), text))
    if joined.startswith(("../", "/")) or joined in ("..", "."):
        return None
    return container.find(joined)


def _letters(name: str) -> str:
    """What names have in common that differ in letter case, or in how an accented letter is made up, alone."""
    return unicodedata.normalize("NFC", name).lower()


def _closest_first(member: str, fitting: Iterable[str]) -> list[str]:
    """Paths that have the letters of ``member``; first those whose first steps are written as there."""
    steps = member.split("/")
    return sorted(
        fitting, key=lambda path: [(name != step, name) for name, step in zip(path.split("/"), steps, strict=False)]
    )


_NO_FILE = (None, errno.ENOENT, errno.ENOTDIR, errno.EISDIR, errno.ELOOP, errno.ENXIO)
"""What :class:`OSError` says where there is no regular file at all."""
_DAMAGED = errno.EINVAL
"""What it says where a damaged archive gives a place before its beginning."""


def is_unreadable(error: Exception) -> bool:
    """Whether a file or folder is there and only cannot be read now, so that it may hold what it held before."""
    if isinstance(error, OSError):
        return error.errno not in _NO_FILE and error.errno != _DAMAGED
    return isinstance(error, MemoryError)


def _refusal(error: Exception, kind: type[EsiCatalogError], words: str) -> EsiCatalogError:
    """What to raise for ``error``: an :class:`UnreadableDocument`, or ``kind`` where nothing is there to be read."""
    why = getattr(error, "strerror", None) or str(error) or "not enough memory"
    return UnreadableDocument(f"cannot be read: {why}") if is_unreadable(error) else kind(f"{words}: {why}")


def open_regular(path: str | Path) -> io.FileIO:
    """Open a regular file for reading; raises :class:`OSError` for pipes and devices instead of waiting for them."""
    stream = io.FileIO(path, opener=lambda name, flags: os.open(name, flags | getattr(os, "O_NONBLOCK", 0)))
    if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
        stream.close()
        raise OSError("not a regular file")
    return stream


def no_file_reason(path: str | os.PathLike[str]) -> str | None:
    """Why an ESI file is not taken from what a shell or a user puts in the place of one; None for other names.

    A document names others beside it, and is read again when something is asked of it: a pipe has neither.
    """
    try:
        mode = Path(path).stat().st_mode
    except (OSError, ValueError):
        return "standard input is not read here; give ESI files" if os.fspath(path) == "-" else None
    return "is a pipe; ESI is read from files only" if stat.S_ISFIFO(mode) else None


def read_file(path: Path) -> bytes:
    """The bytes of a regular file; raises :class:`BrokenDocument` for anything else, and never waits for a writer.

    It is an :class:`UnreadableDocument` where the file is there all the same.
    """
    try:
        with open_regular(path) as stream:
            content = stream.read(MAX_DOCUMENT_BYTES + 1)
    except (OSError, MemoryError) as error:
        raise _refusal(error, BrokenDocument, "cannot be read") from error
    if len(content) > MAX_DOCUMENT_BYTES:
        raise BrokenDocument(TOO_LARGE)
    return content


class Folder:
    """Documents below a folder; symbolic links that lead outside are not followed."""

    def __init__(self, root: Path) -> None:
        self.root = root.resolve()
        self._listings: dict[str, dict[str, list[str]]] = {}

    def read(self, member: str) -> bytes:
        """Bytes of the file ``member`` below the folder."""
        return read_file(self.root / member)

    def find(self, member: str) -> str | None:
        """The file with this path, else the closest one in another letter case."""
        found = {str(self.root): ""}
        for step in member.split("/"):
            fitting = [
                posixpath.join(folder, name)
                for folder in found.values()
                for name in self._listing(folder).get(_letters(step), ())
            ]
            # By where they lead: symbolic links could multiply the ways without end.
            found = {os.path.realpath(self.root / path): path for path in reversed(_closest_first(member, fitting))}
        files = [
            path
            for place, path in found.items()
            # Path.is_file() raises where the folder may be listed and not entered.
            if Path(place).is_relative_to(self.root) and os.path.isfile(place)  # noqa: PTH113
        ]
        return files[-1] if files else None

    def _listing(self, folder: str) -> dict[str, list[str]]:
        """The names in a folder, by their letters."""
        listing = self._listings.get(folder)
        if listing is None:
            listing = self._listings[folder] = {}
            with contextlib.suppress(OSError):
                for entry in (self.root / folder).iterdir():
                    listing.setdefault(_letters(entry.name), []).append(entry.name)
        return listing


class _Guarded(io.BufferedReader):
    """A file that refuses to read a directory of more than all members could need: zipfile reads it at once."""

    is_directory_read = False

    def read(self, size: int | None = -1, /) -> bytes:
        if not self.is_directory_read and size is not None and size > _MAX_DIRECTORY_BYTES:
            raise zipfile.BadZipFile("its directory is too large")
        return super().read(size)

    def __del__(self) -> None:
        self.close()


class Archive:
    """Documents in a zip archive, itself possibly a member of another one."""

    def __init__(self, source: Path | bytes) -> None:
        """Read the directory; raises :class:`InputError`, :class:`UnreadableDocument` where the file is there."""
        try:
            stream = _Guarded(io.BytesIO(source) if isinstance(source, bytes) else open_regular(source))
            self._zip = zipfile.ZipFile(stream)
            stream.is_directory_read = True
        except (OSError, MemoryError, zipfile.BadZipFile, ValueError, NotImplementedError) as error:
            # That the end of the file cannot be read is for zipfile no more than that it is no archive.
            hidden = error.__context__
            refused = hidden if isinstance(hidden, OSError) and is_unreadable(hidden) else error
            raise _refusal(refused, InputError, "not a usable zip archive") from error
        named = [(name, info) for info in self._zip.infolist() if not (name := _member_name(info)).endswith("/")]
        if len(named) > MAX_MEMBERS:
            raise InputError(f"archive with more than {MAX_MEMBERS} members")
        self.expanded_bytes = sum(info.file_size for _, info in named)
        if self.expanded_bytes > MAX_EXPANDED_BYTES:
            raise InputError(f"archive expands to more than {MAX_EXPANDED_BYTES // 2**30} GB")
        self._infos = dict(named)
        self.repeated = sorted(name for name, count in Counter(name for name, _ in named).items() if count > 1)
        """Names that several members have; the last one is meant, as in a folder that the archive is unpacked to."""
        self._by_letters: dict[str, list[str]] = {}
        for name in self._infos:
            self._by_letters.setdefault(_letters(name), []).append(name)

    def members(self) -> list[tuple[str, int]]:
        """Names and expanded sizes in bytes of all members, sorted by name."""
        return sorted((name, info.file_size) for name, info in self._infos.items())

    def read(self, member: str) -> bytes:
        """Expanded bytes of ``member``; never more than its header announces.

        Raises :class:`BrokenDocument`, which is an :class:`UnreadableDocument` where only the file cannot be read.
        """
        info = self._infos.get(member)
        if info is None:
            raise BrokenDocument("the archive holds it no longer: it was changed while it was read; ingest again")
        if max(info.file_size, info.compress_size) > MAX_DOCUMENT_BYTES:
            raise BrokenDocument(TOO_LARGE)
        if info.file_size > max(_SMALL_BYTES, MAX_RATIO * info.compress_size):
            raise BrokenDocument(f"expands to more than {MAX_RATIO} times its packed size; no ESI document does")
        if info.flag_bits & _ENCRYPTED:
            raise BrokenDocument("is encrypted; pack it anew without a password")
        if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise BrokenDocument("packed by another method than deflate; pack it anew")
        try:
            content = self._expanded(info)
        except Exception as error:  # zlib's, RuntimeError (encrypted) and OSError share no base but Exception
            raise _refusal(error, BrokenDocument, "cannot be unpacked") from error
        if len(content) > info.file_size:
            raise BrokenDocument("expands to more than its header announces")
        return content

    def _expanded(self, info: zipfile.ZipInfo) -> bytes:
        """What a member holds, at most one byte more than its header announces."""
        if info.compress_type == zipfile.ZIP_STORED:
            with self._zip.open(info) as stream:
                return stream.read(info.file_size + 1)
        # zlib-ng takes less than half the time of the library that zipfile uses: that only hands out the packed bytes.
        packed = copy.copy(info)
        packed.compress_type, packed.file_size = zipfile.ZIP_STORED, info.compress_size
        del packed.CRC
        with self._zip.open(packed) as stream:
            inflater = zlib_ng.decompressobj(-zlib_ng.MAX_WBITS)
            content: bytes = inflater.decompress(stream.read(), info.file_size + 1)
        if zlib_ng.crc32(content) != info.CRC:
            raise zipfile.BadZipFile("its checksum is another")
        return content

    def find(self, member: str) -> str | None:
        """The member with this path, else the closest one in another letter case."""
        return next(iter(_closest_first(member, self._by_letters.get(_letters(member), ()))), None)


def _member_name(info: zipfile.ZipInfo) -> str:
    """The path of a member.

    Programs of Unix write names in UTF-8 without saying so, which zipfile takes for those of code page 437; programs of
    Windows write backslashes, which zipfile turns into slashes on Windows only. A leading ``./`` is no part of a path.
    """
    name = info.filename
    if not info.flag_bits & _IN_UTF_8:
        with contextlib.suppress(UnicodeError):
            name = name.encode("cp437").decode("utf-8")
    return _HERE.sub("", name.replace("\\", "/"))


def open_container(root: str, in_archive: bool, nested: Iterable[str] = ()) -> Container:
    """The folder or archive ``root``, or what lies in the archives ``nested`` in it, the outer one first.

    Raises :class:`InputError` and :class:`BrokenDocument` for archives that cannot be used.
    """
    if not in_archive:
        return Folder(Path(root))
    archive = Archive(Path(root))
    for name in nested:
        archive = Archive(archive.read(name))
    return archive


def is_archive(content_head: bytes) -> bool:
    """Whether the first bytes are those of a zip archive."""
    return content_head[:4] in (b"PK\x03\x04", b"PK\x05\x06")
