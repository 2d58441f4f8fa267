"""Hashing files ahead of the plan: in a copy of this process, while this one loads the database library."""

import os
import select
from collections.abc import Sequence, Set
from pathlib import Path
from typing import IO

import msgspec

from esicatalog.esi.containers import Folder
from esicatalog.ingest.discover import FoundArchive, discover
from esicatalog.ingest.process import Helper, can_fork, forked, read_frame, write_frame
from esicatalog.ingest.unchanged import Hashes, ReferenceHashes

_PATIENCE_SECONDS = 60.0
"""For the file that is being hashed when the hashes are wanted."""


class HashingAhead:
    """The plain files below the paths being hashed, but for ``own_files``, where this process can be copied."""

    def __init__(self, paths: Sequence[str | os.PathLike[str]], own_files: Set[str] = frozenset()) -> None:
        self._helper: Helper | None = None
        if can_fork():
            self._helper = forked(lambda requests, answers: _hash(paths, own_files, requests, answers))

    def take(self) -> Hashes:
        """What is known by now; the rest is nobody's work any more."""
        if self._helper is None:
            return {}
        self._helper.send(b"")
        try:
            answer = self._helper.receive(_PATIENCE_SECONDS)
        except TimeoutError:
            answer = None
        self.end()
        return msgspec.msgpack.decode(answer, type=Hashes) if answer is not None else {}

    def end(self) -> None:
        """End the copy, if there is one."""
        if self._helper is not None:
            self._helper.end()
            self._helper = None


def _hash(
    paths: Sequence[str | os.PathLike[str]], own_files: Set[str], requests: IO[bytes], answers: IO[bytes]
) -> None:
    """Hash file after file until that is asked for, or nobody is left to ask."""
    folders: dict[str, ReferenceHashes] = {}
    for item in discover(paths, own_files):
        if select.select([requests], [], [], 0)[0]:
            break
        if isinstance(item, FoundArchive) or item.problem is not None:
            continue
        if item.root not in folders:
            folders[item.root] = ReferenceHashes(Folder(Path(item.root)))
        folders[item.root].of_member(item.name)
    if read_frame(requests.read) is not None:
        # Why something has no hash is asked again where that is needed.
        hashed = {
            root: {member: sha256 for member, sha256 in hashes.known.items() if sha256 is not None}
            for root, hashes in folders.items()
        }
        write_frame(answers, msgspec.msgpack.encode(hashed))
