"""Full-text search on databases without FTS5: the words that FTS5 would find, with plain LIKE.

The table holds texts as words between blanks. FTS5 itself, in memory, takes texts apart into words, so that case,
diacritics and word boundaries are the same on every database; the words hold no wildcards of LIKE.
"""

import sqlite3
from collections.abc import Sequence
from contextlib import closing
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog.schema import devices
from esicatalog.catalog.views import FULL_TEXT, TOKENIZER

_COLUMNS = ("device_id", "named", "identity", "words")
TABLE = sa.table(FULL_TEXT, *map(sa.column, _COLUMNS))
_BETWEEN_TEXTS = " | "
"""A phrase never reaches from one text into another."""


def condition(search_words: Sequence[tuple[str, bool]]) -> sa.ColumnElement[bool]:
    """The condition on ``devices`` that every word of a search is found.

    Beside each word stands whether it may also match the inside of a word in types and names.
    """
    columns = TABLE.c
    found: list[sa.ColumnElement[bool]] = []
    for (_, inside), words in zip(search_words, _words([word for word, _ in search_words]), strict=True):
        places = [columns.named.like(f"% {words}%"), columns.identity.like(f"% {words} %")]
        if inside:
            places.append(columns.words.like(f"% {words}%"))
        found.append(sa.or_(*places) if words else sa.false())
    return devices.c.id.in_(sa.select(columns.device_id).where(*found or [sa.false()]))


def write(connection: sa.Connection, device_ids: Sequence[int], rows: Sequence[Sequence[Any]]) -> None:
    """Replace the rows of devices: (device number, vendor, type, name, identity, endings of words)."""
    connection.execute(sa.delete(TABLE).where(TABLE.c.device_id.in_(device_ids)))
    if rows:
        values = [dict(zip(_COLUMNS, row, strict=True)) for row in table_rows(rows)]
        connection.execute(sa.insert(TABLE), values)


def table_rows(rows: Sequence[Sequence[Any]]) -> list[tuple[Any, ...]]:
    """Rows as the table holds them, with texts as words between blanks."""
    if not rows:
        return []
    numbers, *texts = zip(*rows, strict=True)
    vendors, types, names, identities, endings = map(_words, texts)
    named = [f" {_BETWEEN_TEXTS.join(parts)} " for parts in zip(vendors, types, names, strict=True)]
    return list(zip(numbers, named, (f" {i} " for i in identities), (f" {e} " for e in endings), strict=True))


def _words(texts: Sequence[str | None]) -> list[str]:
    """The words of each text as FTS5 takes them apart, in their order, with blanks between them."""
    with closing(sqlite3.connect(":memory:")) as memory:
        memory.execute(f"CREATE VIRTUAL TABLE texts USING fts5(text, tokenize = '{TOKENIZER}')")
        memory.execute("CREATE VIRTUAL TABLE words USING fts5vocab(texts, instance)")
        memory.executemany("INSERT INTO texts (rowid, text) VALUES (?, ?)", enumerate(texts))
        found: list[list[str]] = [[] for _ in texts]
        for number, word in memory.execute("SELECT doc, term FROM words ORDER BY doc, offset"):
            found[number].append(word)
    return [" ".join(words) for words in found]
