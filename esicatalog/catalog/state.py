"""What the catalog says of itself as a whole: loads under way, and two digests of what it holds."""

import hashlib
from collections.abc import Iterable
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.schema import SCHEMA_VERSION, device_sources, devices, sources

CONTENT_HASH, STATE_HASH = "content_hash", "state_hash"


def write_state(connection: sa.Connection, key: str, value: str | None) -> None:
    """Set or delete (None) an entry of catalog_state."""
    state = schema.catalog_state
    connection.execute(sa.delete(state).where(state.c.key == key))
    if value is not None:
        connection.execute(sa.insert(state).values(key=key, value=value))


def read_state(connection: sa.Connection, key: str) -> str | None:
    """An entry of catalog_state."""
    state = schema.catalog_state
    return connection.execute(sa.select(state.c.value).where(state.c.key == key)).scalar()


def content_hash(connection: sa.Connection) -> str:
    """SHA-256 over the sorted (identity, variant, content hash, source sha256, member) of all descriptions."""
    columns = devices.c
    rows = connection.execute(
        sa.select(
            columns.vendor_id,
            columns.product_code,
            columns.revision_no,
            columns.type,
            columns.variant,
            columns.content_hash,
            sources.c.sha256,
            sources.c.member,
        )
        .join(device_sources, device_sources.c.device_id == columns.id)
        .join(sources, sources.c.id == device_sources.c.source_id)
    )
    return _digest(rows)


def state_hash(connection: sa.Connection) -> str:
    """SHA-256 over what the content hash leaves out: all documents, and which versions read them and derive from them.

    That is the version of the schema and the sorted (member, sha256, status, version of the reader) of all sources, be
    it that they describe no device. Unlike the content hash it is another one after an upgrade.
    """
    columns = sources.c
    rows = connection.execute(sa.select(columns.member, columns.sha256, columns.status, columns.reader_version))
    return _digest([(SCHEMA_VERSION,), *rows])


def _digest(rows: Iterable[Iterable[Any]]) -> str:
    hashed = hashlib.sha256()
    for line in sorted({"\t".join("" if value is None else str(value) for value in row) for row in rows}):
        hashed.update(line.encode() + b"\n")
    return hashed.hexdigest()


def store_hashes(connection: sa.Connection) -> None:
    """Say what the catalog holds now."""
    write_state(connection, CONTENT_HASH, content_hash(connection))
    write_state(connection, STATE_HASH, state_hash(connection))


def forget_hashes(connection: sa.Connection) -> None:
    """The catalog is about to change: until a load is finished there are no hashes."""
    write_state(connection, CONTENT_HASH, None)
    write_state(connection, STATE_HASH, None)
