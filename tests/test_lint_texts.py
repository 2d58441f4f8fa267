"""L17: a second name in one language is found in every list of names, wherever records have one."""

import pytest

from esicatalog.esi.binding import Record, fields_of
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import DataType, EnumInfo, Object, SubItem
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.lint.rules.texts import language_twice

ENGLISH, GERMAN = Name(text="Speed", lcid=1033), Name(text="Drehzahl", lcid=1031)
HOLDERS = [
    (Object, lambda item: item, ()),
    (Device, lambda item: item, ()),
    (Pdo, lambda item: item, ()),
    (Entry, lambda item: Pdo(entries=(Entry(), item)), ("entries", 1)),
    (DataType, lambda item: item, ()),
    (SubItem, lambda item: DataType(sub_items=(SubItem(), item)), ("sub_items", 1)),
    (EnumInfo, lambda item: DataType(enum_infos=(EnumInfo(), item)), ("enum_infos", 1)),
]
LISTS = [
    pytest.param(kind, field.name, hold, place, id=f"{kind.__name__}.{field.name}")
    for kind, hold, place in HOLDERS
    for field in fields_of(kind)
    if field.many and field.item is Name
]


def places(record: Record) -> list[tuple]:
    return [found.place for found in language_twice(record)]


@pytest.mark.parametrize(("kind", "field", "hold", "place"), LISTS)
def test_the_second_name_in_one_language_is_found(kind, field, hold, place):
    names = (ENGLISH, GERMAN, Name(text="Velocity"))  # without LcId: English
    assert places(hold(kind(**{field: names}))) == [(*place, field, 2)]
    assert places(hold(kind(**{field: names[:2]}))) == []
    assert places(hold(kind(**{field: names[:1]}))) == []


def test_there_are_such_lists_in_all_of_these_records():
    assert {param.values[0] for param in LISTS} == {kind for kind, _, _ in HOLDERS}
