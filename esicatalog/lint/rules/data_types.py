"""Rules about data types and objects as they are declared (ESI-FACTS sections 6 and 7)."""

from collections.abc import Iterator

from esicatalog.esi.records.dictionary import DataType, SubItem
from esicatalog.lint.objects import DataTypeSubject, ObjectSubject
from esicatalog.lint.registry import ERROR, WARNING, Found, listed, rule
from esicatalog.model.areas import Area, overlaps
from esicatalog.model.base_types import BaseType, base_type
from esicatalog.model.dictionary_views import DictionaryView
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS, is_pdo_mapping
from esicatalog.model.resolver import TypeSet
from esicatalog.words import index_words


@rule("L41", ERROR, "EtherCATBase.xsd keyref: Object/Type, SubItem/Type and BaseType name a DataType of the dictionary")
def type_undeclared(record: TypeSet | ObjectSubject) -> Iterator[Found]:
    """A type is not declared in its dictionary."""
    if isinstance(record, ObjectSubject):
        declared = record.declared
        if declared.type and record.data_type is None:
            yield Found(
                f"object {index_words(declared.object_index)} has the type {declared.type!r}, "
                f"which the dictionary does not declare{_known(declared.type)}",
                ("type",),
            )
        return
    known = record.by_name
    for number, data_type in enumerate(record.data_types):
        if data_type.base_type and data_type.base_type not in known:
            yield Found(
                f"DataType {data_type.name} has the BaseType {data_type.base_type!r}, "
                f"which the dictionary does not declare{_known(data_type.base_type)}",
                ("data_types", number, "base_type"),
            )
        for position, sub_item in enumerate(data_type.sub_items):
            if sub_item.type and sub_item.type not in known:
                yield Found(
                    f"SubItem {sub_item.name!r} of DataType {data_type.name} has the type {sub_item.type!r}, "
                    f"which the dictionary does not declare{_known(sub_item.type)}",
                    ("data_types", number, "sub_items", position, "type"),
                )


def _known(name: str) -> str:
    return "; read as the base type of that name" if base_type(name) is not None else ": declare it"


@rule("L42", ERROR, "EtherCATBase.xsd keys: DataType name, SubItem name; ETG.1000.6: subindex, object index")
def declared_twice(record: DictionaryView | TypeSet | DataTypeSubject) -> Iterator[Found]:
    """A data type name, SubItem name, SubIdx or object index is declared twice."""
    if isinstance(record, DataTypeSubject):
        if record.of_sub_items:
            yield from _sub_items_twice(record.data_type)
        return
    if isinstance(record, TypeSet):
        names = [data_type.name for data_type in record.data_types]
        for number, name in _repeated(names):
            yield Found(
                f"DataType {name} is declared twice: the first counts; rename one", ("data_types", number, "name")
            )
        return
    objects = record.dictionary.objects
    if len(record.by_index) == len(objects):
        return
    for number, index in _repeated([declared.object_index for declared in objects]):
        yield Found(f"object 0x{index:04X} is declared twice: remove one", ("objects", number, "object_index"))


def _sub_items_twice(data_type: DataType) -> Iterator[Found]:
    for number, name in _repeated([sub_item.name for sub_item in data_type.sub_items]):
        yield Found(
            f"SubItem {name!r} occurs twice in DataType {data_type.name}: values are paired by name; rename one",
            ("sub_items", number, "name"),
        )
    for number, subindex in _repeated([sub_item.subindex for sub_item in data_type.sub_items]):
        yield Found(
            f"SubIdx {subindex} occurs twice in DataType {data_type.name}: renumber one",
            ("sub_items", number, "subindex"),
        )


def _repeated(keys: list[str | None] | list[int | None]) -> list[tuple[int, object]]:
    """Position and key of every item whose key another item had before."""
    if len(set(keys)) == len(keys):
        return []
    first: dict[object, int] = {}
    return [
        (number, key) for number, key in enumerate(keys) if key is not None and first.setdefault(key, number) != number
    ]


@rule("L43", WARNING, "ETG.2000 Object/BitSize, SubItem/BitSize are those of the type")
def size_differs(subject: ObjectSubject | DataTypeSubject) -> Iterator[Found]:
    """BitSize of an object or SubItem differs from that of its type."""
    if isinstance(subject, DataTypeSubject):
        yield from _sizes_of_sub_items(subject)
        return
    declared = subject.declared
    size = _other_size(declared.bit_size, subject.data_type)
    if size is not None and not _is_dynamic(declared.object_index or 0):
        yield Found(
            f"object {index_words(declared.object_index)} has BitSize {declared.bit_size}, "
            f"its type {declared.type} {size}: correct one of them",
            ("bit_size",),
        )


def _is_dynamic(index: int) -> bool:
    """Whether the length of an object follows what is mapped or assigned."""
    return is_pdo_mapping(index) or index in PDO_ASSIGNMENTS


def _sizes_of_sub_items(subject: DataTypeSubject) -> Iterator[Found]:
    data_type = subject.data_type
    if _is_of_idn(data_type):
        return
    misfits = [
        (number, f"SubItem {sub_item.name!r} has BitSize {sub_item.bit_size}, its type {sub_item.type} {size}")
        for number, sub_item, of_type in _typed(subject)
        if (size := _other_size(sub_item.bit_size, of_type)) is not None
    ]
    if misfits:
        first, _ = misfits[0]
        words = listed([words for _, words in misfits])
        yield Found(f"DataType {data_type.name}: {words}; correct BitSize or Type", ("sub_items", first, "bit_size"))


def _typed(subject: DataTypeSubject) -> Iterator[tuple[int, SubItem, DataType | BaseType | None]]:
    """SubItems with position and type: as the dictionary declares it, else the base type of that name."""
    for number, (sub_item, declared) in enumerate(zip(subject.data_type.sub_items, subject.of_sub_items, strict=True)):
        yield number, sub_item, declared if declared is not None else base_type(sub_item.type)


def _is_of_idn(data_type: DataType) -> bool:
    """Whether it is the structure of an IDN, where members may be a union or bit fields narrower than their type."""
    return all(sub_item.subindex is None for sub_item in data_type.sub_items)


def _other_size(bit_size: int | None, of_type: DataType | BaseType | None) -> int | None:
    """The size of a type, None where what has the type is of that size or one of them is not known.

    A type of no bits, as STRING(0), is of any length.
    """
    size = of_type.bit_size if of_type is not None else None
    return size if size and bit_size not in (None, size) else None


@rule("L44", WARNING, "ETG.2000 SubItem/BitOffs, BitSize: the complete-access image; SubIndex 0 lies at its start")
def sub_item_overlap(subject: DataTypeSubject) -> Iterator[Found]:
    """SubItems overlap or exceed their type, or SubIndex 0 does not lie at BitOffs 0.

    One whose own BitSize is wrong (L43) is left out: how far it reaches is not known.
    """
    data_type = subject.data_type
    sub_items = data_type.sub_items
    if not sub_items or _is_of_idn(data_type):
        return
    number = next((number for number, item in enumerate(sub_items) if item.subindex == 0), None)
    if number is not None and sub_items[number].bit_offset:
        yield Found(
            f"SubIdx 0 of DataType {data_type.name} has BitOffs {sub_items[number].bit_offset}: correct it to 0",
            ("sub_items", number, "bit_offset"),
        )
    areas = [
        Area(sub_item.bit_offset, sub_item.bit_offset + sub_item.bit_size, number)
        for number, sub_item, of_type in _typed(subject)
        if sub_item.bit_offset is not None and sub_item.bit_size and _other_size(sub_item.bit_size, of_type) is None
    ]
    for (_, end, number), (start, _, next_number) in overlaps(areas):
        yield Found(
            f"SubItem {sub_items[next_number].name!r} of DataType {data_type.name} starts at bit "
            f"{start}, {sub_items[number].name!r} ends at {end}: correct BitOffs",
            ("sub_items", next_number, "bit_offset"),
        )
    if areas and data_type.bit_size is not None:
        end, number = max([(end, number) for _, end, number in areas])
        if end > data_type.bit_size:
            yield Found(
                f"SubItem {sub_items[number].name!r} of DataType {data_type.name} ends at bit {end}, "
                f"behind its BitSize {data_type.bit_size}: correct BitOffs or one BitSize",
                ("sub_items", number),
            )
