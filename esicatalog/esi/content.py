"""Content addressing: equal content has equal digests, whichever file, process or run it came from."""

import hashlib

DIGEST_BYTES = 16
MAX_KEY_BYTES = 2_000
"""Of a text that an index holds, in UTF-8: PostgreSQL takes 2,704 bytes with all else in the row of the index."""


def digest(content: bytes) -> bytes:
    """BLAKE2b of ``content``, 16 bytes: short enough for a million index entries, long enough never to collide."""
    return hashlib.blake2b(content, digest_size=DIGEST_BYTES).digest()


def sha256_hex(content: bytes) -> str:
    """SHA-256 as 64 lower-case hex digits: the identity of a document's bytes."""
    return hashlib.sha256(content).hexdigest()
