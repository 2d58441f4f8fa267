"""The reader of ESI documents."""

import random
from collections.abc import Iterator

from lxml import etree

from esicatalog.errors import DocumentError
from esicatalog.esi.documents import make_parser
from esicatalog.esi.reader import ReadDocument, Reader
from fuzz.mutations import mutated_bytes, mutated_tree
from fuzz.seeds import own_documents, real_documents


def check(data: bytes) -> ReadDocument | None:
    """Read a document; None when it is refused."""
    try:
        read = Reader().read(data)
    except DocumentError as error:
        _check_message(str(error))
        return None
    for finding in read.findings:
        _check_message(finding.message)
    return read


def seeds() -> Iterator[bytes]:
    """Documents."""
    yield from own_documents()
    yield from real_documents()


def mutate(data: bytes, seed: int) -> bytes:
    """Another document: elements changed where it is well-formed, else bytes."""
    chance = random.Random(seed)
    if chance.random() < 0.7:
        try:
            return mutated_tree(etree.fromstring(data, make_parser()), chance)
        except (etree.XMLSyntaxError, ValueError):
            pass
    return mutated_bytes(data, chance)


def _check_message(message: str) -> None:
    assert message.strip() and "\n" not in message and len(message) < 1_000, message[:2_000]
