"""The order of child elements: the schema's sequence, which is how :mod:`esicatalog.esi.write` writes a record.

Only tags are compared: each distinct sequence of children is judged once.
"""

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import groupby, pairwise
from typing import Any, NamedTuple

import msgspec
from lxml import etree

from esicatalog.esi.binding import Record, fields_of
from esicatalog.esi.records.dictionary import DataType, Object
from esicatalog.esi.records.document import Document, ModuleInfo
from esicatalog.esi.records.pdo import Pdo
from esicatalog.esi.write import record_element
from esicatalog.lint.dictionaries import IdentityMemo
from esicatalog.lint.registry import Found, Place

_SHARED = (DataType, Object, Pdo)
"""Records that the reader reuses for equal elements."""
_MAX_SHARED = 20_000


class _Shape(NamedTuple):
    """What can stand below the element of a record type."""

    inner: tuple[str, ...]
    """Paths of elements that are no records themselves but hold fields; empty for the record's own."""
    records: tuple[tuple[str, str, bool], ...]
    """Field, path and whether it repeats, of the records below."""


class OrderSubject(NamedTuple):
    """A document with its tree."""

    document: Document
    root: etree._Element
    checker: "OrderChecker"


class OrderChecker:
    """Finds children out of order; remembers sequences and shared records."""

    def __init__(self) -> None:
        self._judged: dict[tuple[type, str, tuple[str, ...]], str | None] = {}
        self._of_shared: IdentityMemo[list[Found]] = IdentityMemo(_MAX_SHARED)

    def document(self, document: Document, root: etree._Element) -> Iterator[Found]:
        """What stands out of order, with places below the document."""
        if document.dictionary is not None:
            for element in root.iterchildren("Dictionary"):
                yield from _below(("dictionary",), self._record(document.dictionary, element))
        sections = list(root.iterchildren("EtherCATInfo")) if root.tag == "EtherCATInfoList" else [root]
        for number, (info, element) in enumerate(zip(document.infos, sections, strict=False)):
            record = ModuleInfo(vendor=info.vendor, modules=info.modules) if root.tag == "EtherCATModule" else info
            yield from _below(("infos", number), self._record(record, element))

    def _record(self, record: Record, element: etree._Element) -> list[Found]:
        if isinstance(record, _SHARED):
            return self._of_shared.get(id(record), record, self._look, record, element)
        return self._look(record, element)

    def _look(self, record: Record, element: etree._Element) -> list[Found]:
        found = []
        shape = _shape(type(record))
        for path in shape.inner:
            holder = element.find(path) if path else element
            if holder is not None and len(holder) > 1:
                words = self._judge(record, path, holder)
                if words is not None:
                    found.append(Found(words))
        for field, path, many in shape.records:
            value = getattr(record, field)
            if not value:
                continue
            values, elements = (value, element.findall(path)) if many else ((value,), element.findall(path)[:1])
            for number, (item, below) in enumerate(zip(values, elements, strict=False)):
                if len(below):
                    found += _below((field, number) if many else (field,), self._record(item, below))
        return found

    def _judge(self, record: Record, path: str, holder: etree._Element) -> str | None:
        tags = tuple(tag for tag, _ in groupby([str(child.tag) for child in holder]))
        key = (type(record), path, tags)
        if len(tags) < 2:
            return None
        if key not in self._judged:
            self._judged[key] = _misplaced(record, path, str(holder.tag), tags)
        return self._judged[key]


def _misplaced(record: Record, path: str, holder: str, tags: Sequence[str]) -> str | None:
    """Words about the first child that stands too late, None when the order is the schema's."""
    written = record_element(_skeleton(record), "Record")
    in_order = written.find(path) if path else written
    ranks = {child.tag: rank for rank, child in reversed(list(enumerate(in_order if in_order is not None else ())))}
    known = [tag for tag in tags if tag in ranks]
    for before, tag in pairwise(known):
        if ranks[tag] < ranks[before]:
            return f"{holder}: {tag} stands behind {before}; the schema has it before"
    return None


def _skeleton(record: Any) -> Any:
    """The record with empty ones below it, one a list: all that its own order depends on."""
    changes: dict[str, Any] = {}
    for field in fields_of(type(record)):
        value = getattr(record, field.name)
        if field.many and value:
            changes[field.name] = (_emptied(value[0]),)
        elif isinstance(value, Record):
            changes[field.name] = _emptied(value)
    return msgspec.structs.replace(record, **changes)


def _emptied(value: Any) -> Any:
    return type(value)() if isinstance(value, Record) else value


@cache
def _shape(record_type: type[Record]) -> _Shape:
    inner = {"": None}
    records = []
    for field in fields_of(record_type):
        path, _, attribute = field.xml.path.removeprefix(".").partition("@")
        is_record = isinstance(field.item, type) and issubclass(field.item, Record)
        steps = path.split("/")[: None if attribute else -1] if path else []
        inner.update({"/".join(steps[: n + 1]): None for n in range(len(steps))})
        if is_record:
            records.append((field.name, path, field.many))
    return _Shape(tuple(inner), tuple(records))


def _below(place: Place, found: Sequence[Found]) -> list[Found]:
    return [item._replace(place=place + item.place) for item in found]
