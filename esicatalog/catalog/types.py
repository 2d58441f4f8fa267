"""Column types that mean the same on SQLite (STRICT tables) and PostgreSQL.

On STRICT tables the generic Boolean, String, BigInteger and Float fail at CREATE; on PostgreSQL uint32 needs BIGINT
and texts sort by code point only with COLLATE "C".
"""

from collections.abc import Callable
from typing import Any

import sqlalchemy as sa
from sqlalchemy.types import TypeEngine


def integer() -> TypeEngine[int]:
    """64-bit signed integer."""
    return sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def boolean() -> TypeEngine[bool]:
    """Truth value; 0 and 1 on SQLite."""
    return sa.Boolean().with_variant(sa.Integer(), "sqlite")


def text() -> TypeEngine[str]:
    """Text of any length, ordered by code point."""
    return sa.Text().with_variant(sa.Text(collation="C"), "postgresql")


def real() -> TypeEngine[float]:
    """Double precision number."""
    return sa.Double().with_variant(sa.REAL(), "sqlite")


def blob() -> TypeEngine[bytes]:
    """Bytes."""
    return sa.LargeBinary().with_variant(sa.BLOB(), "sqlite")


BY_KIND: dict[str, Callable[[], TypeEngine[Any]]] = {
    "int": integer,
    "bool": boolean,
    "text": text,
    "json": text,
    "float": real,
}
"""Column kinds of :mod:`esicatalog.catalog.mapping`."""
