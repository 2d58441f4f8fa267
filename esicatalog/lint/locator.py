"""From a place in the records to element path and line: the declarations of the record fields say where each lies.

Records carry no lines and do not tell which of several containers an element lies in, so the parsed document is asked,
and only when there is something to report.
"""

from collections.abc import Callable, Mapping
from functools import cache, cached_property
from typing import Any, NamedTuple

from esicatalog.esi.binding import Record, fields_of
from esicatalog.esi.lines import Located
from esicatalog.esi.records.document import DiagInfo, DictInfo, Document, EsiInfo, InfoList, ModuleInfo
from esicatalog.esi.tree import DocumentTree
from esicatalog.lint.registry import Place

Tree = Callable[[], DocumentTree]
"""Gives the elements of a document."""

_ROOTS: dict[str, type[Record]] = {
    "EtherCATInfo": EsiInfo,
    "EtherCATModule": ModuleInfo,
    "EtherCATInfoList": InfoList,
    "EtherCATDict": DictInfo,
    "EtherCATDiag": DiagInfo,
}
_SECTION: Place = ("infos", 0)
"""What the root itself is, in documents of these roots."""
_SINGLE_SECTION = (EsiInfo, ModuleInfo)


class Position(NamedTuple):
    """Where something stands: path of the element, positions from 0 where a tag repeats, and its line (0 unknown)."""

    path: str
    line: int


class _Known(NamedTuple):
    """A place that was looked up: the nearest element that the tree has, and whether it is the one."""

    record: Any
    ways: "_Ways"
    path: str
    located: Located
    exact: bool


class Locator:
    """Looks up places of one document; ``tree`` is called at the first look-up."""

    def __init__(self, document: Document, tree: Tree) -> None:
        self._document = document
        self._make_tree = tree
        self._known: dict[Place, _Known] = {}

    @cached_property
    def _tree(self) -> DocumentTree:
        return self._make_tree()

    def position(self, place: Place) -> Position:
        """Path and line of a place; of the nearest element around it where the document has none there."""
        found = self._look_up(place)
        return Position(found.path, found.located.line)

    def _look_up(self, place: Place) -> _Known:
        found = self._known.get(place)
        if found is None:
            found = self._known[place] = self._step(place) if place else self._root()
        return found

    def _root(self) -> _Known:
        record_type = _ROOTS[self._document.root]
        return _Known(self._document, _ways(record_type), self._document.root, self._tree.located_root(), True)

    def _step(self, place: Place) -> _Known:
        if place == _SECTION and (record_type := _ROOTS[self._document.root]) in _SINGLE_SECTION:
            root = self._look_up(())
            return root._replace(record=self._document.infos[0], ways=_ways(record_type))
        last = place[-1]
        if isinstance(last, int):
            name, position, around = str(place[-2]), last, self._look_up(place[:-2])
        else:
            name, position, around = last, None, self._look_up(place[:-1])
        path, is_list = around.ways[name]
        if not path:
            return around
        value = getattr(around.record, name)
        step = path
        if is_list and position is not None:
            step += f"[{position}]" if len(value) > 1 else ""
            value = value[position]
        ways = _ways(value.__class__)
        found = self._tree.element(around.located, path, position or 0) if around.exact else None
        if found is None:
            return _Known(value, ways, f"{around.path}/{step}", around.located, False)
        return _Known(value, ways, f"{around.path}/{found.path}", found.located, True)


_Ways = Mapping[str, tuple[str, bool]]
"""By the name of a field the path of its element and whether there are several."""


@cache
def _ways(value_type: type) -> _Ways:
    if not issubclass(value_type, Record):
        return {}
    return {field.name: (field.xml.element, field.many) for field in fields_of(value_type)}
