"""ESI documents of devices: modules, groups, files beside the document or everything inline."""

from pathlib import Path

import msgspec
import pytest
from snippets import device, dictionary, esi, read, write

from esicatalog.errors import InputError
from esicatalog.esi.reader import read_esi
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import DiagMessage, Diagnostics
from esicatalog.esi.records.dictionary import Dictionary, Object
from esicatalog.esi.records.document import EsiInfo, Group, Vendor
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.profile import Profile
from esicatalog.esi.records.slots import Slot, SlotModuleClass, SlotModuleIdent
from esicatalog.export.esi import (
    DeviceWithModules,
    content_of,
    export_esi,
    export_esi_files,
    export_vendor_esi,
    sharing_a_document,
)
from esicatalog.export.subject import Subject, subjects_of_document
from esicatalog.model.slots import reachable_modules

VENDOR = Vendor(vendor_id=0xE5C, names=(Name(text="Test vendor"),))
ONE_OBJECT = Dictionary(objects=(Object(object_index=0x2000, names=(Name(text="O"),)),))
TEXTS = Diagnostics(diag_messages=(DiagMessage(text_id=1, message_texts=(Name(text="m"),)),))


def group(type_text: str, parent: str | None = None, name: str = "Group") -> Group:
    return Group(type=type_text, parent_group=parent, names=(Name(text=name),))


def drive(*profiles: Profile, type_text: str = "T1", revision: int = 1) -> Device:
    return Device(
        type=type_text,
        product_code=1,
        revision_no=revision,
        physics="YY",
        names=(Name(text="Drive"),),
        group_type="G",
        profiles=profiles,
    )


def modular(type_text: str, ident: int | None = None, module_class: str | None = None) -> Device:
    """A device with one slot, for a module ident or class."""
    slot = Slot(
        min_instances=1,
        max_instances=1,
        module_idents=() if ident is None else (SlotModuleIdent(module_ident=ident),),
        module_classes=() if module_class is None else (SlotModuleClass(module_class=module_class),),
    )
    return msgspec.structs.replace(drive(type_text=type_text), has_slots=True, slots=(slot,))


def module(ident: int, name: str, module_class: str | None = None) -> Module:
    return Module(type=name, module_ident=ident, module_class=module_class, names=(Name(text=name),))


def info_of(document: bytes) -> EsiInfo:
    (info,) = read(document).document.infos
    return info


def exported(*devices: Device) -> EsiInfo:
    return info_of(export_esi(VENDOR, (), [DeviceWithModules(item) for item in devices]))


def with_files(folder: Path, *devices: Device) -> tuple[tuple[Device, ...], list[str]]:
    """The devices as they read from the files of an export, and the names of the files."""
    files = export_esi_files("drive.xml", VENDOR, (), [DeviceWithModules(item) for item in devices])
    write(folder, files)
    return read_esi(folder / "drive.xml").document.infos[0].devices, list(files)


# Vendor, groups, modules


def test_a_device_with_its_module_and_groups():
    groups = (group("Root"), group("G", parent="Root"), group("Other"))
    fitting = module(0x10, "M1")
    info = info_of(export_esi(VENDOR, groups, [DeviceWithModules(modular("T1", 0x10), [fitting])]))
    assert info == EsiInfo(vendor=VENDOR, groups=groups[:2], devices=(modular("T1", 0x10),), modules=(fitting,))


def test_the_first_group_of_a_type_counts():
    groups = (group("G", name="first"), group("G", name="second"))
    assert info_of(export_esi(VENDOR, groups, [DeviceWithModules(drive())])).groups == groups[:1]


def test_a_group_that_nobody_describes_is_not_invented():
    assert exported(drive()).groups == ()


def test_groups_that_are_their_own_parents_end():
    groups = (group("G", parent="H"), group("H", parent="G"))
    assert info_of(export_esi(VENDOR, groups, [DeviceWithModules(drive())])).groups == groups


@pytest.mark.parametrize(
    ("taken", "is_refused"),
    [
        ("<ModuleClass><Class>C</Class><VendorId>#x1234</VendorId></ModuleClass>", True),
        ("<ModuleIdent>1</ModuleIdent>", False),
    ],
)
def test_a_module_that_is_taken_as_another_vendors_only_is_not_lost_in_silence(tmp_path, taken, is_refused):
    """Modules of an InfoReference have a vendor of their own; beside the device they would have that of the device."""
    slots = f'<Slots><Slot MinInstances="0" MaxInstances="1">{taken}</Slot></Slots>'
    modules = '<Modules><Module><Type ModuleIdent="1" ModuleClass="C">M1</Type><Name>M1</Name></Module></Modules>'
    referring = esi(device(slots)).replace("<Vendor>", "<InfoReference>m.xml</InfoReference><Vendor>", 1)
    of_modules = f"<EtherCATModule><Vendor><Id>#x1234</Id><Name>V</Name></Vendor>{modules}</EtherCATModule>"
    write(tmp_path, {"a.xml": referring, "m.xml": of_modules})
    (subject,) = subjects_of_document(read_esi(tmp_path / "a.xml").document, "a.xml")
    assert [item.type for item in subject.modules] == ["M1"]
    for export in (export_esi, lambda *content: export_esi_files("a.xml", *content)["a.xml"]):
        if is_refused:
            with pytest.raises(InputError, match="'T1' cannot be written with its module 'M1'"):
                export(*content_of([subject]))
        else:
            assert info_of(export(*content_of([subject]))).modules == subject.modules


def test_devices_share_equal_modules():
    both = [DeviceWithModules(modular(name, 0x10), [module(0x10, "M1")]) for name in ("T1", "T2")]
    assert info_of(export_esi(VENDOR, (), both)).modules == (module(0x10, "M1"),)


def test_what_cannot_share_a_document_is_refused_before_the_rest_is_read():
    devices = (modular("T1", 0x10), [module(0x10, "M1")]), (modular("T2", 0x10), [module(0x10, "M2")]), (drive(), [])
    subjects = iter([Subject(1, "V", item, tuple(modules)) for item, modules in devices])
    with pytest.raises(InputError, match="'T2' cannot share a document"):
        list(sharing_a_document(subjects))
    assert [subject.device for subject in subjects] == [drive()]


def test_devices_with_different_modules_of_one_ident_stand_apart():
    both = [
        DeviceWithModules(modular("T1", 0x10), [module(0x10, "M1")]),
        DeviceWithModules(modular("T2", 0x10), [module(0x10, "M2")]),
        DeviceWithModules(drive()),
    ]
    with pytest.raises(InputError, match="'T2' cannot share a document"):
        export_esi(VENDOR, (), both)
    files = export_esi_files("all.xml", VENDOR, (), both)
    assert list(files) == ["all.xml", "all-2.xml"]
    infos = [info_of(content) for content in files.values()]
    assert [[item.type for item in info.devices] for info in infos] == [["T1", "T1"], ["T2"]]
    assert [info.modules for info in infos] == [(module(0x10, "M1"),), (module(0x10, "M2"),)]


def test_a_coupler_without_modules_does_not_get_those_of_another():
    wide = DeviceWithModules(modular("T1", module_class="C"), [module(0x10, "M1", "C"), module(0x11, "M2", "C")])
    bare = DeviceWithModules(modular("T2", module_class="C"))
    files = export_esi_files("all.xml", VENDOR, (), [wide, bare])
    for content, (its_device, modules) in zip(files.values(), [wide, bare], strict=True):
        info = info_of(content)
        assert reachable_modules(its_device, info.modules) == list(modules)


def test_the_first_of_several_modules_with_one_ident_stays_the_first():
    one, two = module(0x10, "M1"), module(0x10, "M2")
    both = [DeviceWithModules(modular("T1", 0x10), [one, two]), DeviceWithModules(modular("T2", 0x10), [two, one])]
    infos = [info_of(content) for content in export_esi_files("a.xml", VENDOR, (), both).values()]
    assert [info.modules for info in infos] == [(one, two), (two, one)]


def test_modules_that_no_slot_reaches_stand_where_no_slot_would_take_them():
    """One slot is for the class C; of a ModuleIdent there is one module in a document."""
    coupler, plugged = modular("T1", module_class="C"), module(0x10, "M1", "C")
    free, nameless = module(0x11, "free", "D"), module(0x12, "no class")
    of_ident, of_class, again = module(0x10, "ident", "D"), module(0x13, "class", "C"), module(0x11, "again", "D")
    content = (VENDOR, (), [DeviceWithModules(coupler, [plugged])])
    unreached = (free, of_ident, of_class, nameless, again)
    written = export_vendor_esi(*content, unreached)
    assert info_of(written.document).modules == (plugged, free, nameless)
    assert written.left_out == (of_ident, of_class, again)
    files = export_esi_files("all.xml", *content, unreached)
    assert list(files) == ["all.xml", "all-2.xml"]
    infos = [info_of(text) for text in files.values()]
    assert [info.devices for info in infos] == [(coupler,), ()]
    assert [info.modules for info in infos] == [(plugged, free, nameless), (of_ident, of_class, again)]
    assert {info.vendor for info in infos} == {VENDOR}


# Dictionaries and diagnosis texts


def test_an_external_dictionary_is_written_inline():
    given = Profile(profile_no=402, dictionary_file="sub\\d.xml", dictionary=ONE_OBJECT)
    (found,) = exported(drive(given)).devices[0].profiles
    assert found == Profile(profile_no=402, dictionary=ONE_OBJECT)


def test_an_external_dictionary_is_written_beside(tmp_path):
    given = drive(Profile(profile_no=402, dictionary_file="sub\\d.xml", dictionary=ONE_OBJECT))
    assert with_files(tmp_path, given) == ((given,), ["drive.xml", "sub/d.xml"])
    assert b"<Dictionary>" not in (tmp_path / "drive.xml").read_bytes()


def test_an_inline_dictionary_stays_inline(tmp_path):
    given = drive(Profile(profile_no=402, dictionary=ONE_OBJECT))
    assert with_files(tmp_path, given) == ((given,), ["drive.xml"])


def test_a_dictionary_that_was_not_found_stays_a_reference(tmp_path):
    given = drive(Profile(profile_no=402, dictionary_file="d.xml"))
    assert exported(given).devices == (given,)
    assert with_files(tmp_path, given) == ((given,), ["drive.xml"])


def test_devices_share_a_file_in_any_letter_case(tmp_path):
    one = drive(Profile(dictionary_file="Sub\\D.xml", dictionary=ONE_OBJECT))
    two = drive(Profile(dictionary_file="sub/d.XML", dictionary=ONE_OBJECT), revision=2)
    assert with_files(tmp_path, one, two) == ((one, two), ["drive.xml", "Sub/D.xml"])


def test_another_content_under_the_same_path_is_written_inline(tmp_path):
    one = drive(Profile(dictionary_file="d.xml", dictionary=ONE_OBJECT))
    two = drive(Profile(dictionary_file="D.xml", dictionary=Dictionary()), revision=2)
    inline = drive(Profile(dictionary=Dictionary()), revision=2)
    assert with_files(tmp_path, one, two) == ((one, inline), ["drive.xml", "d.xml"])


def test_a_missing_file_is_not_given_the_content_of_another_device(tmp_path):
    one = drive(Profile(dictionary_file="d.xml", dictionary=ONE_OBJECT))
    two = drive(Profile(dictionary_file="d.xml"), revision=2)
    inline = drive(Profile(dictionary=ONE_OBJECT))
    assert with_files(tmp_path, one, two) == ((inline, two), ["drive.xml"])


@pytest.mark.parametrize(
    "reference", ["../d.xml", "..\\..\\d.xml", "/d.xml", "C:\\d.xml", "sub/../../d.xml", "DRIVE.xml"]
)
def test_files_outside_of_the_folder_and_the_document_itself_are_not_written(tmp_path, reference):
    given = drive(Profile(dictionary_file=reference, dictionary=ONE_OBJECT))
    assert with_files(tmp_path, given) == ((drive(Profile(dictionary=ONE_OBJECT)),), ["drive.xml"])


def test_diagnosis_texts_beside_and_inline(tmp_path):
    given = drive(Profile(diag_files=("t\\diag.xml",), diag_messages=TEXTS))
    assert with_files(tmp_path, given) == ((given,), ["drive.xml", "t/diag.xml"])
    assert exported(given).devices == (drive(Profile(diag_messages=TEXTS)),)


def test_texts_of_several_files_are_written_inline(tmp_path):
    given = drive(Profile(diag_files=("a.xml", "b.xml"), diag_messages=TEXTS))
    assert with_files(tmp_path, given) == ((drive(Profile(diag_messages=TEXTS)),), ["drive.xml"])


def test_dictionaries_of_modules_are_written_beside_too(tmp_path):
    described = msgspec.structs.replace(
        module(0x10, "M1"), profiles=(Profile(dictionary_file="m.xml", dictionary=ONE_OBJECT),)
    )
    files = export_esi_files("a.xml", VENDOR, (), [DeviceWithModules(modular("T1", 0x10), [described])])
    assert list(files) == ["a.xml", "m.xml"]
    write(tmp_path, files)
    assert read_esi(tmp_path / "a.xml").document.infos[0].modules == (described,)


def test_a_document_goes_out_as_it_came_in():
    types = "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
    objects = "<Object><Index>8192</Index><Name>O</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    info = info_of(esi(device(dictionary(types, objects))).encode())
    assert info.vendor is not None
    document = export_esi(info.vendor, info.groups, [DeviceWithModules(info.devices[0])])
    assert info_of(document) == info
    assert b"<Index>8192</Index>" in document
