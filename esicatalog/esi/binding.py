"""Binding of record types to XML: one declaration per field serves the reader, the writer and the catalog.

A record field is declared as ``Annotated[type, Xml(path, scalar, doc)]``. Paths, relative to the record's element:

* ``Index``: text of a child element; ``Info/Electrical/EBusCurrent``: of a nested one
* ``@Sm``: attribute; ``Index@DependOnSlot``: attribute of a child
* ``.``: the element's own text
* a field of type ``tuple[...]`` collects repeated children in document order, one record or scalar each
* ``PRESENT``: whether the element occurs; ``RAW``: the element's subtree as canonical XML text

:func:`read_record` walks an element once and hands every value that no field takes to the :class:`Notes`.
"""

import types
import typing
from functools import cache
from typing import Annotated, Any, ClassVar, TypeVar, get_args, get_origin, get_type_hints

import msgspec
from lxml import etree

from esicatalog.esi.notes import Notes
from esicatalog.esi.numbers import TEXT, Remark, Scalar
from esicatalog.esi.repeats import MARK


@typing.dataclass_transform(frozen_default=True, kw_only_default=True)
class _RecordMeta(msgspec.StructMeta):
    """Tells type checkers that subclasses inherit the configuration of Record."""


class Record(msgspec.Struct, metaclass=_RecordMeta, frozen=True, gc=False, omit_defaults=True, kw_only=True):
    """Base of all ESI records: immutable, comparable, every field optional.

    ``spelling`` maps a field name to the vendor's text where that differs from the canonical spelling of the value.
    """

    SCHEMA_ORDER: ClassVar[tuple[str, ...]] = ()
    """Where the schema's sequence is not the order of declaration: these paths come first, the others as declared."""
    CHOICES: ClassVar[tuple[tuple[str, ...], ...]] = ()
    """Fields of which the schema has one only (xs:choice); where several are given, the first of them counts."""

    spelling: dict[str, str] | None = None


class Marker:
    """How an element is taken that is neither scalar nor record."""

    def __init__(self, name: str):
        self.name = name


PRESENT = Marker("PRESENT")
RAW = Marker("RAW")


class Xml(msgspec.Struct, frozen=True):
    """Where a record field lives in the document, how its text is read and what it means."""

    path: str
    kind: Any = TEXT
    doc: str = ""

    @property
    def element(self) -> str:
        """Path of the element; empty for that of the record itself."""
        return self.path.partition("@")[0].removeprefix(".")

    @property
    def attribute(self) -> str:
        """Name of the attribute; empty where the value is the element or its text."""
        return self.path.partition("@")[2]


class Doc(msgspec.Struct, frozen=True):
    """What a field means that comes from no single place of a document."""

    doc: str


class Field(msgspec.Struct, frozen=True):
    """A resolved record field: name, binding, and the type of its items."""

    name: str
    xml: Xml
    many: bool
    item: Any
    """Record subclass, or the Python type of a scalar."""


_MAX_LEAVES = 50_000
_LONGEST_SHARED = 500
_ANYWHERE = -1
"""Rank after a child was found out of order: an element is told once."""
_SCHEMA_INSTANCE = "{http://www.w3.org/2001/XMLSchema-instance}"
"""Attributes that say where the schema lies, nothing about the device."""

R = TypeVar("R", bound=Record)


@cache
def fields_of(record_type: type[Record]) -> tuple[Field, ...]:
    """The bound fields of a record type in declaration order (fields without an :class:`Xml` are left out)."""
    found = []
    for name, hint in get_type_hints(record_type, include_extras=True).items():
        if get_origin(hint) is not Annotated:
            continue
        declared, *extras = get_args(hint)
        xml = next((extra for extra in extras if isinstance(extra, Xml)), None)
        if xml is None:
            continue
        many = get_origin(declared) is tuple
        item = get_args(declared)[0] if many or isinstance(declared, types.UnionType) else declared
        found.append(Field(name, xml, many, item))
    return tuple(found)


def fields_in_order(record_type: type[Record]) -> list[Field]:
    """The bound fields of a record type in the order in which the schema has their elements."""
    first = record_type.SCHEMA_ORDER

    def rank(field: Field) -> int:
        path = field.xml.element + "/"
        return next((n for n, start in enumerate(first) if path.startswith(f"{start}/")), len(first))

    return sorted(fields_of(record_type), key=rank)


class Target(msgspec.Struct, frozen=True):
    """Where a value goes: field name, its scalar, and whether it repeats."""

    name: str
    scalar: Any
    many: bool


class _Node:
    """What the reader does with one element: the compiled tree of a record's paths."""

    __slots__ = (
        "alternatives", "attributes", "children", "choices", "descends", "leaves", "lists", "many", "plain", "rank",
        "record", "text", "whole",
    )  # fmt: skip

    def __init__(self) -> None:
        self.rank = 0
        """Place among its siblings in the schema."""
        self.attributes: dict[str, Target] = {}
        self.children: dict[str, _Node] = {}
        self.text: Target | None = None
        self.record: type[Record] | None = None
        self.whole: str | None = None
        """Field that takes the element as a whole (record, raw XML or presence)."""
        self.descends = True
        """Whether what is in the element goes to fields of the same record."""
        self.many = False
        self.plain: Target | None = None
        """The target of the text of an element that has nothing but text: the common case, read without descending."""
        self.alternatives: frozenset[str] = frozenset()
        """Tags of which the schema has one in this place."""
        self.choices: tuple[dict[str, str], ...] = ()
        """Choices of a record: the path of each field."""
        self.lists: tuple[str, ...] = ()
        """Fields of a record that collect repeated children."""
        self.leaves: dict[tuple[Any, ...], Record] = {}
        """Records without child elements, by text and attributes: names, exclusions, sync managers repeat."""


_compiled: dict[type[Record], _Node] = {}
_shared: dict[Record, Record] = {}


def is_record(item: Any) -> bool:
    """Whether the items of a field are records."""
    return isinstance(item, type) and issubclass(item, Record)


def _compile(record_type: type[Record]) -> _Node:
    root = _Node()
    nodes: dict[str, _Node] = {}
    for field in fields_in_order(record_type):
        path, attribute = field.xml.element, field.xml.attribute
        node = root
        for tag in path.split("/") if path else []:
            node = node.children.setdefault(tag, _Node())
        nodes[field.name] = node
        if is_record(field.item) or isinstance(field.xml.kind, Marker):
            node.whole, node.many = field.name, field.many
            node.record = field.item if is_record(field.item) else None
            node.descends = field.xml.kind is PRESENT
        elif attribute:
            node.attributes[attribute] = Target(field.name, field.xml.kind, False)
        else:
            node.text = Target(field.name, field.xml.kind, field.many)
    _finish(root)
    paths = {field.name: field.xml.path for field in fields_of(record_type)}
    root.choices = tuple({name: paths[name] for name in choice} for choice in record_type.CHOICES)
    for choice in root.choices:
        for name in choice:
            nodes[name].alternatives = frozenset(path.rpartition("/")[2] for path in choice.values())
    root.lists = tuple(field.name for field in fields_of(record_type) if field.many)
    _compiled[record_type] = root
    return root


def _finish(node: _Node) -> None:
    for rank, child in enumerate(node.children.values()):
        child.rank = rank
        if child.text is not None and child.whole is None and not child.text.many:
            child.plain = child.text
        _finish(child)


def canonical_xml(element: etree._Element) -> str:
    """The subtree as exclusive canonical XML: the same text whatever the document's prefixes and layout.

    Where a namespace is no URI there is no canonical form; then it stands as it is.
    """
    try:
        text: bytes = etree.tostring(element, method="c14n", exclusive=True, with_tail=False)  # type: ignore[call-overload]
    except etree.C14NError:
        return etree.tostring(element, encoding="unicode", with_tail=False)
    return text.decode("utf-8")


def read_record(record_type: type[R], element: etree._Element, notes: Notes) -> R:
    """Read ``element`` into a ``record_type``; what does not fit goes to ``notes``."""
    node = _compiled.get(record_type) or _compile(record_type)
    values: dict[str, Any] = {}
    _fill(node, element, values, notes)
    for choice in node.choices:
        given = [path for name, path in choice.items() if values.get(name) not in (None, "")]
        if len(given) > 1:
            notes.given_together(element, given)
    for name in node.lists:
        if name in values:
            values[name] = tuple(values[name])
    return record_type(**values)


def _fill(node: _Node, element: etree._Element, values: dict[str, Any], notes: Notes) -> None:
    for name, text in element.items():
        target = node.attributes.get(name)
        if target is None:
            if name != MARK and not name.startswith(_SCHEMA_INSTANCE):
                notes.unmapped_attribute(element, name, text)
        elif target.name in values:
            notes.unmapped_attribute(element, name, text, repeated=True)
        else:
            if (remark := store(target, text, values)) is not None:
                notes.remark(element, remark, name)
    text_target = node.text
    if text_target is not None:
        if text_target.name not in values or text_target.many:
            if (remark := store(text_target, element.text or "", values)) is not None:
                notes.remark(element, remark)
        elif element.text:
            notes.unmapped_text(element, element.text, repeated=True)
    elif element.text is not None and not element.text.isspace():
        notes.unmapped_text(element, element.text)
    children = node.children
    rank = 0
    met: tuple[_Node, ...] = ()
    for child in element:
        tail = child.tail
        if tail is not None and not tail.isspace():
            notes.unmapped_text(element, tail)
        taken = children.get(child.tag)  # type: ignore[arg-type]
        if taken is None:
            notes.unmapped_element(child)
            continue
        if taken.rank < rank:
            before = child.getprevious()
            if before is None or before.tag not in taken.alternatives:
                notes.misplaced(element, child, children)
            rank = _ANYWHERE
        elif rank != _ANYWHERE:
            rank = taken.rank
        plain = taken.plain
        if plain is not None and not len(child) and plain.name not in values and not child.keys():
            if (remark := store(plain, child.text or "", values)) is not None:
                notes.remark(child, remark)
            continue
        if not taken.descends:
            _take_whole(taken, child, values, notes)
            continue
        if taken.text is None:
            if taken in met:
                notes.read_as_one(child)
            met = (*met, taken)
            if taken.whole is not None:
                values[taken.whole] = True
        _fill(taken, child, values, notes)


def _take_whole(node: _Node, child: etree._Element, values: dict[str, Any], notes: Notes) -> None:
    name = typing.cast(str, node.whole)
    if name in values and not node.many:
        notes.unmapped_element(child, repeated=True)
        return
    value: Any
    if node.record is None:
        value = canonical_xml(child)
    elif node.record in notes.watched:
        records = notes.read_child(node.record, child, read_record)
        if node.many:
            values.setdefault(name, []).extend(records)
        else:
            values[name] = records[0]
        return
    elif len(child):
        value = shared(read_record(node.record, child, notes))
    else:
        value = _read_leaf(node, node.record, child, notes)
    if node.many:
        values.setdefault(name, []).append(value)
    else:
        values[name] = value


@cache
def _is_flat(record_type: type[Record]) -> bool:
    return not any(is_record(field.item) for field in fields_of(record_type))


def shared(record: R) -> R:
    """The first of records that are equal, flags for example: what is made of records is found by their identity.

    Records that hold others, or spellings, are not compared.
    """
    if record.spelling is not None or not _is_flat(type(record)):
        return record
    known = _shared.get(record)
    if known is None and len(_shared) < _MAX_LEAVES and len(repr(record)) < _LONGEST_SHARED:
        _shared[record] = record
    return typing.cast(R, known) if known is not None else record


def _read_leaf(node: _Node, record_type: type[Record], element: etree._Element, notes: Notes) -> Record:
    key = (element.text, *element.items())
    record = node.leaves.get(key)
    if record is None:
        before = len(notes.findings)
        record = read_record(record_type, element, notes)
        if before == len(notes.findings) and len(node.leaves) < _MAX_LEAVES:
            node.leaves[key] = record
    return record


def store(target: Target, text: str, values: dict[str, Any]) -> Remark | None:
    """Put what a text means among the values of a record; returns what is wrong with it."""
    scalar: Scalar = target.scalar
    name = target.name
    if target.many:
        held = values.setdefault(name, [])
        value, raw, remark = scalar.read(text)
        name = f"{name}.{len(held)}"
        held.append(value)
    elif scalar is TEXT:
        values[name] = text.strip()
        return None
    else:
        values[name], raw, remark = scalar.read(text)
    if raw is not None:
        values.setdefault("spelling", {})[name] = raw
    return remark
