"""Full-text search over devices: vendors by all their names, types, names and identities in every notation people type.

The FTS5 table splits at word boundaries (unicode61), so words of one or two characters are found. To find ``1100``
in ``EL1100`` the column ``words`` holds the endings of types' and names' words, and a search word is a prefix.
Other databases search the same words by :mod:`esicatalog.catalog.word_search`.
"""

import re
from collections.abc import Iterable, Sequence
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema, word_search
from esicatalog.catalog.bulk import chunks
from esicatalog.catalog.views import FULL_TEXT
from esicatalog.words import hex32

_WORD = re.compile(r"\w+")
_SHORTEST_ENDING = 3
_MOST_SEARCHED = 1_000
"""Characters of the vendor, the type and the names of a device that are searched; real ones have up to 150."""
_MOST_INSIDE = 64
"""Characters of a word whose inside is searched: the endings of all its characters would be as many as their square.
The longest real word has 26.
"""
_NOTHING = '""'
_FTS5_TABLE = sa.table(FULL_TEXT, *map(sa.column, ("rowid", "vendor", "type", "name", "identity", "words")))


def search_expression(text: str) -> str:
    """The FTS5 query for what a user typed: every word must match.

    A word matches the beginning of a word in vendor, type or name, from three characters on also the inside of one,
    or a whole number of the identity; ``#x…`` counts as ``0x…``.
    """
    return " AND ".join(map(_word_expression, _search_words(text))) or _NOTHING


def _matches_inside(word: str) -> bool:
    return len(word) >= _SHORTEST_ENDING


def _search_words(text: str) -> list[str]:
    words = _WORD.findall(text.replace("#x", "0x").replace("#X", "0x"))
    # To the tokenizer ``_`` stands between words: alone it is none, and nothing would match it.
    return [word for word in words if word.strip("_")]


def text_condition(text: str, dialect: str) -> Any:
    """The condition on ``devices`` for what a user typed."""
    if dialect != "sqlite":
        return word_search.condition([(word, _matches_inside(word)) for word in _search_words(text)])
    match = sa.text(f"devices.id IN (SELECT rowid FROM {FULL_TEXT} WHERE {FULL_TEXT} MATCH :words)")
    return match.bindparams(words=search_expression(text))


def _word_expression(word: str) -> str:
    columns = "vendor type name words" if _matches_inside(word) else "vendor type name"
    return f'({{{columns}}} : "{word}"* OR identity : "{word}")'


def identity_notations(number: int | None) -> list[str]:
    """Notations of a number: ``0x044c2c52``, ``0x44c2c52`` and decimal (``#x`` is searched as ``0x``)."""
    return [] if number is None else list(dict.fromkeys((hex32(number), f"0x{number:x}", str(number))))


def word_endings(text: str) -> list[str]:
    """Endings of the words of a text, so that a prefix search finds the inside of a word."""
    found: dict[str, None] = {}
    for word in _WORD.findall(text):
        for start in range(1, min(len(word), _MOST_INSIDE) - _SHORTEST_ENDING + 1):
            found[word[start:_MOST_INSIDE]] = None
    return list(found)


def _searched(text: sa.ColumnElement[str | None]) -> sa.ColumnElement[str | None]:
    """What of a text the search finds: its beginning, which is all of it but for texts that no vendor writes."""
    return sa.func.substr(text, 1, _MOST_SEARCHED)


def index_devices(connection: sa.Connection, device_ids: Iterable[int]) -> None:
    """Write the search rows of these devices anew; rows of devices that are gone disappear."""
    table, vendors = search_table(connection), _VendorTexts(connection)
    for part in chunks(device_ids):
        rows = _search_rows(connection, part, vendors)
        if connection.dialect.name != "sqlite":
            word_search.write(connection, part, rows)
            continue
        connection.exec_driver_sql(
            f"DELETE FROM {FULL_TEXT} WHERE rowid IN ({', '.join('?' * len(part))})", tuple(part)
        )
        if rows:
            columns, marks = ", ".join(table.columns.keys()), ", ".join("?" * len(table.columns))
            connection.exec_driver_sql(f"INSERT INTO {FULL_TEXT} ({columns}) VALUES ({marks})", rows)


def outdated_devices(connection: sa.Connection) -> list[int]:
    """Devices that the search does not know, or not as they are."""
    table, vendors = search_table(connection), _VendorTexts(connection)
    found: list[int] = []
    for part in chunks(connection.execute(sa.select(schema.devices.c.id)).scalars()):
        rows = _search_rows(connection, part, vendors)
        expected = rows if connection.dialect.name == "sqlite" else word_search.table_rows(rows)
        held = connection.execute(sa.select(table).where(next(iter(table.columns)).in_(part))).all()
        found += {row[0] for row in {*expected} - {*map(tuple, held)}}
    return found


def search_table(connection: sa.Connection) -> sa.TableClause:
    """The table that is searched; its first column is the number of the device."""
    return _FTS5_TABLE if connection.dialect.name == "sqlite" else word_search.TABLE


def _search_rows(
    connection: sa.Connection, device_ids: Sequence[int], vendors: "_VendorTexts"
) -> list[tuple[Any, ...]]:
    """What is searched of devices: (device number, vendor, type, name, identity, endings of words)."""
    columns, texts = schema.devices.c, schema.device_names.c
    query = (
        sa.select(
            columns.id,
            columns.vendor_id,
            _searched(columns.own_vendor_name).label("own_vendor_name"),
            _searched(columns.type).label("type"),
            columns.product_code,
            columns.revision_no,
        )
        .where(columns.id.in_(device_ids))
        .order_by(columns.id)
    )
    names: dict[int, list[str]] = {}
    named = (
        sa.select(texts.device_id, _searched(texts.text))
        .where(texts.device_id.in_(device_ids), texts.kind == "name")
        .order_by(texts.id)
    )
    for number, text in connection.execute(named).all():
        names.setdefault(number, []).append(text)
    rows = []
    for row in connection.execute(query).all():
        identity = [
            notation
            for number in (row.vendor_id, row.product_code, row.revision_no)
            for notation in identity_notations(number)
        ]
        name = " ".join(dict.fromkeys(names.get(row.id, [])))[:_MOST_SEARCHED]
        endings = word_endings(f"{row.type or ''} {name}")
        maker = row.own_vendor_name or vendors[row.vendor_id]
        rows.append((row.id, maker, row.type, name, " ".join(identity), " ".join(endings)))
    return rows


class _VendorTexts(dict[int | None, str | None]):
    """All spellings and languages of vendors' names, but those of other makers who use their ids; by vendor id.

    Each vendor is looked up once: for that all its devices are looked through.
    """

    def __init__(self, connection: sa.Connection) -> None:
        super().__init__()
        self._connection = connection

    def __missing__(self, vendor_id: int | None) -> str | None:
        named, others = schema.vendor_names.c, schema.devices.c
        is_of_other = sa.exists().where(others.vendor_id == named.vendor_id, others.own_vendor_name == named.name)
        query = sa.select(_searched(named.name)).where(named.vendor_id == vendor_id, ~is_of_other).distinct()
        names = sorted(name for name in self._connection.execute(query).scalars() if name is not None)
        text = self[vendor_id] = " ".join(names)[:_MOST_SEARCHED] if names else None
        return text
