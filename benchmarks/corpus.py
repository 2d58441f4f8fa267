"""The documents that are measured: reading them, parsing them bare, and a copy of which one document changes."""

import multiprocessing
import os
import time
import zipfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple

from lxml import etree

from esicatalog.errors import EsiCatalogError
from esicatalog.esi.containers import NESTED, Archive
from esicatalog.ingest.discover import FoundArchive, FoundDocument, archive_members, discover

_COMMENT = b"\n<!-- changed -->\n"


class Floor(NamedTuple):
    """A bare parse of all documents, reading them not counted."""

    seconds: float
    processor_seconds: float
    document_count: int
    xml_bytes: int


def default_corpus() -> Path:
    """ESICATALOG_CORPUS, else beside the checkout."""
    return Path(os.environ.get("ESICATALOG_CORPUS") or "../shared/corpus", "esi")


def documents(folder: Path) -> Iterator[tuple[str, bytes]]:
    """Path (archives count as folders) and bytes of every document that an ingest of ``folder`` reads."""
    for item in discover([folder]):
        if isinstance(item, FoundArchive):
            outer = Archive(Path(item.location))
            for found in archive_members(item):
                yield found.member.replace(NESTED, "/"), _member(outer, found)
        elif item.problem is None:
            yield item.member, Path(item.location).read_bytes()


def _member(archive: Archive, found: FoundDocument) -> bytes:
    for name in found.nested:
        archive = Archive(archive.read(name))
    try:
        return archive.read(found.name) if found.problem is None else b""
    except EsiCatalogError:
        return b""


def _parse_everything(folder: Path) -> Floor:
    contents = [content for _, content in documents(folder)]
    started, processor_started = time.perf_counter(), time.process_time()
    for content in contents:
        try:
            etree.fromstring(content)
        except etree.XMLSyntaxError:
            continue
    seconds, processor_seconds = time.perf_counter() - started, time.process_time() - processor_started
    return Floor(seconds, processor_seconds, len(contents), sum(map(len, contents)))


def measure_floor(folder: Path) -> Floor:
    """Parse all documents with lxml and its default options in one process, which ends and gives its memory back."""
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as executor:
        return executor.submit(_parse_everything, folder).result()


def unpack(folder: Path, target: Path) -> None:
    """Every document as a plain file, archives as folders."""
    for path, content in documents(folder):
        file = target / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)


def typical_document(folder: Path) -> Path:
    """The plain ESI document of median size."""
    found = [path for path in folder.rglob("*") if path.is_file() and b"<EtherCATInfo" in path.read_bytes()]
    return sorted(found, key=lambda path: (path.stat().st_size, path))[len(found) // 2]


def largest_archive(folder: Path) -> Path:
    """The archive with the most bytes."""
    return max(folder.rglob("*.zip"), key=lambda path: (path.stat().st_size, path))


def change_document(file: Path) -> None:
    """A comment at the end: other bytes, so that the document is read again."""
    file.write_bytes(file.read_bytes() + _COMMENT)


def change_member(archive: Path) -> int:
    """Change the document of median size in an archive; returns the number of members."""
    changed = archive.with_suffix(".changed")
    with zipfile.ZipFile(archive) as source, zipfile.ZipFile(changed, "w", zipfile.ZIP_DEFLATED) as target:
        members = source.infolist()
        documents = [member for member in members if member.filename.lower().endswith(".xml")]
        chosen = sorted(documents, key=lambda member: (member.file_size, member.filename))[len(documents) // 2]
        for member in members:
            content = source.read(member)
            target.writestr(member, content + _COMMENT if member is chosen else content)
    archive.unlink()
    changed.rename(archive)
    return len(members)
