"""Files that inputs are made from: our own, and real ones where ESICATALOG_CORPUS names some."""

import os
import zipfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parent.parent
MAX_SEED_BYTES = 200_000
"""Larger seeds are left out: most of the time would go into repeating what is the same in them."""


def own_documents() -> list[bytes]:
    """ESI documents of our own, the one that uses the whole schema first."""
    tests = ROOT / "tests"
    paths = [tests / "maximal.xml", *sorted((ROOT / "data").glob("*.xml")), *sorted((tests / "lint").glob("*.xml"))]
    return [path.read_bytes() for path in paths]


def corpus() -> Path | None:
    """The folder of real files, None when there is none."""
    folder = Path(os.environ.get("ESICATALOG_CORPUS") or ROOT.parent / "shared" / "corpus")
    return folder if (folder / "esi").is_dir() else None


def real_documents() -> Iterator[bytes]:
    """Real ESI documents, the smaller ones."""
    folder = corpus()
    for path in sorted((folder / "esi").glob("*.zip")) if folder is not None else ():
        with zipfile.ZipFile(path) as archive:
            for info in archive.infolist():
                if info.file_size <= MAX_SEED_BYTES:
                    yield archive.read(info)


def real_files(name: str) -> Iterator[bytes]:
    """Real files in a folder of the corpus: ``sii`` or ``cli``."""
    folder = corpus()
    for path in sorted((folder / name).rglob("*")) if folder is not None else ():
        if path.is_file() and path.suffix != ".tsv" and path.stat().st_size <= MAX_SEED_BYTES:
            yield path.read_bytes()
