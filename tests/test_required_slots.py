"""Slots that need a module and have none: the length of the process image is not known."""

import pytest
from click.testing import CliRunner
from snippets import device, esi, pdo, read, write

import esicatalog
from esicatalog.cli.main import cli
from esicatalog.identity import Bounds
from esicatalog.model.compare import compare_devices
from esicatalog.model.compare_documents import DescribedDevice
from esicatalog.model.derivation import derive
from esicatalog.model.process_image import default_process_image, whole_process_image
from esicatalog.model.slots import PluggedModule, reachable_modules
from esicatalog.scan.front import read_scan

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"
OWN = pdo("RxPdo", "#x1700", 16, attributes='Sm="2"') + pdo("TxPdo", "#x1B00", 16, attributes='Sm="3"')
OUT = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
INTO = pdo("TxPdo", "#x1A00", 32, attributes='Sm="3"')
REQUIRED, OPTIONAL = 'MinInstances="1" MaxInstances="1"', 'MinInstances="0" MaxInstances="1"'


def module(ident: int, content: str) -> str:
    return f'<Module><Type ModuleIdent="{ident}">M{ident}</Type><Name>M{ident}</Name>{content}</Module>'


def slot(attributes: str, *idents: int, preset: int | None = None) -> str:
    content = "".join(f"<ModuleIdent Default='{int(ident == preset)}'>{ident}</ModuleIdent>" for ident in idents)
    return f"<Slot {attributes}>{content}</Slot>"


MODULES = module(1, OUT) + module(2, OUT + INTO) + module(3, "") + module(4, "")


def described(slots: str, own: str = OWN):
    info = read(esi(device(f"{SMS}{own}<Slots>{slots}</Slots>"), MODULES)).document.infos[0]
    found = info.devices[0]
    return found, reachable_modules(found, info.modules)


def sizes(slots: str, own: str = OWN) -> tuple[int | None, int | None]:
    facts = derive(*described(slots, own)).facts
    return facts.output_bytes, facts.input_bytes


@pytest.mark.parametrize(
    ("slots", "expected"),
    [
        (slot(REQUIRED, 1, 2), (None, None)),  # 3 bytes out, and 2 or 6 in
        (slot(REQUIRED, 1, 3), (None, 2)),  # neither module has inputs
        (slot(REQUIRED, 3, 4), (2, 2)),  # neither has PDOs
        (slot(REQUIRED, 9), (None, None)),  # no module 9 is described
        (slot(REQUIRED, 3, 9), (None, None)),
        (slot(REQUIRED, 1, 9), (None, None)),  # 9 may have inputs, too
        (slot(REQUIRED, 3, 9, preset=9), (None, None)),
        (slot(REQUIRED, 3, 9, preset=3), (2, 2)),
        (slot(OPTIONAL, 9, preset=9), (None, None)),  # nor here, where it is there unless another is chosen
        (slot(f'{OPTIONAL} Default="9" Fallback="1"', 1, 3), (None, None)),  # the fallback is not what is there
        (slot(f'{REQUIRED} Default="9"', 3, 4), (None, None)),  # 9 may have PDOs, whether the slot lists it or not
        (slot(f'{REQUIRED} Default="3" Fallback="9"', 3, 4), (2, 2)),
        (slot(OPTIONAL, 1, 2), (2, 2)),  # empty is a configuration
        (slot(REQUIRED, 1, 2, preset=2), (3, 6)),
        (slot(REQUIRED, 1), (3, 2)),  # the only one that fits
        (slot('MinInstances="1" MaxInstances="0"', 1, 2), (2, 2)),  # no slot at all
        (slot(REQUIRED, 1) + slot('MinInstances="1" MaxInstances="3"', 1, 2), (None, None)),
    ],
)
def test_sizes_are_known_where_every_required_slot_has_its_module(slots, expected):
    assert sizes(slots) == expected


MAILBOX_ONLY = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm>"


@pytest.mark.parametrize(
    ("sms", "content", "idents", "expected"),
    [
        (MAILBOX_ONLY, OWN, (1, 2), (None, None)),
        (MAILBOX_ONLY, "", (1, 2), (None, None)),
        (MAILBOX_ONLY, "", (1, 3), (None, 0)),  # neither module has inputs
        (MAILBOX_ONLY, "", (3, 4), (0, 0)),
        (f"{MAILBOX_ONLY}<Sm>Outputs</Sm>", "", (1, 2), (None, None)),
        (f"{MAILBOX_ONLY}<Sm>DynamicOutputs</Sm><Sm>DynamicInputs</Sm>", "", (1, 2), (None, None)),
    ],
)
def test_pdos_of_a_missing_module_may_go_to_a_sync_manager_that_nobody_describes(sms, content, idents, expected):
    """OUT goes to SM2 and INTO to SM3, whether the device describes these or not."""
    content = f"{sms}{content}<Slots>{slot(REQUIRED, *idents)}</Slots>"
    info = read(esi(device(content), MODULES)).document.infos[0]
    facts = derive(info.devices[0], reachable_modules(info.devices[0], info.modules)).facts
    assert (facts.output_bytes, facts.input_bytes) == expected


def test_a_sync_manager_that_only_a_missing_module_names_has_an_image():
    content = f"{MAILBOX_ONLY}<Slots>{slot(REQUIRED, 1, 2)}</Slots>"
    info = read(esi(device(content), MODULES)).document.infos[0]
    images = default_process_image(info.devices[0], info.modules)
    words = "slot 0 without a module, though required: PDOs of modules are missing; what fits slot 0: 0x1, 0x2"
    assert [(image.sm, image.transfer_direction, image.size_words, image.remarks) for image in images] == [
        (2, "output", "unknown length", (words,)),
        (3, "input", "unknown length", (words,)),
    ]


def test_a_class_of_modules_is_no_preset():
    """One described module belongs to the class; other documents, of other vendors even, may describe more."""
    slots = f"<Slot {REQUIRED}><ModuleClass><Class>C</Class></ModuleClass></Slot>"
    of_class = module(1, OUT).replace("<Type ", '<Type ModuleClass="C" ')
    info = read(esi(device(f"{SMS}{OWN}<Slots>{slots}</Slots>"), of_class)).document.infos[0]
    assert reachable_modules(info.devices[0], info.modules) == list(info.modules)
    assert default_process_image(info.devices[0], info.modules)[0].byte_size is None


def test_what_is_missing_is_told_for_its_direction():
    slots = slot(REQUIRED, 1, 3) + slot('MinInstances="2" MaxInstances="3"', 1, 2)
    images = {image.sm: image for image in default_process_image(*described(slots))}
    words = "without a module, though required: PDOs of modules are missing; what fits slot"
    assert images[2].remarks == (f"slots 0, 1, 2 {words} 0: 0x1, 0x3",)
    assert images[3].remarks == (f"slots 1, 2 {words} 1: 0x1, 0x2",)
    assert (images[2].size_words, images[3].size_words) == ("at least 2 bytes (16 bits)",) * 2
    nothing = default_process_image(*described(slots, own=""))
    assert [image.size_words for image in nothing] == ["unknown length"] * 2


def test_a_chosen_module_leaves_what_the_other_slots_need():
    found, modules = described(slot(REQUIRED, 1, 2) * 2)
    first = PluggedModule(0, found.slots[0], modules[0])
    images = whole_process_image(found, modules, [first])
    assert [image.size_words for image in images] == ["at least 3 bytes (24 bits)", "at least 2 bytes (16 bits)"]
    both = [first, PluggedModule(1, found.slots[1], modules[1])]
    assert [image.byte_size for image in whole_process_image(found, modules, both)] == [4, 6]


GROUPS = "<ModulePdoGroup>A</ModulePdoGroup><ModulePdoGroup>B</ModulePdoGroup>"


@pytest.mark.parametrize(
    ("idents", "own", "of_modules", "groups", "plugged", "places"),
    [
        ((1, 2), "", "", "", 0, [0, 16]),  # its PDOs lie before those of slot 1
        ((1, 2), "", "", "", 1, [0, None]),
        ((1, 2), "", "1", GROUPS, 0, [0, None]),  # the other module may be in a group that lies before
        ((1, 2), "0", "1", GROUPS, 0, [0, None]),  # but not before the device's own PDOs
        ((1, 2), "1", "0", GROUPS, 0, [None, None]),  # here it is
        ((1, 9), "0", "1", GROUPS, 0, [None, None]),  # and nobody knows the group of module 9
    ],
)
def test_what_lies_behind_a_missing_module_has_no_place(idents, own, of_modules, groups, plugged, places):
    """The device has 16 bits of its own in SM2; a required slot beside the plugged one, with 8 bits, is empty."""

    def of_group(text: str, group: str) -> str:
        return text.replace("<Type ", f'<Type ModulePdoGroup="{group}" ') if group else text

    slots = slot(REQUIRED, *idents) * 2
    described = of_group(device(f"{SMS}{OWN}<Slots>{slots}{groups}</Slots>"), own)
    info = read(esi(described, of_group(MODULES, of_modules))).document.infos[0]
    found = info.devices[0]
    outputs = whole_process_image(found, info.modules, [PluggedModule(plugged, found.slots[plugged], info.modules[0])])
    places_found = {item.slot_number: placed.bit_offset for item in outputs[0].pdos for placed in item.entries}
    assert [places_found[None], places_found[plugged]] == places
    assert (outputs[0].bit_size, outputs[0].byte_size) == (24, None)


def test_an_image_that_lacks_required_modules_is_another_layout():
    required, optional = described(slot(REQUIRED, 1, 2)), described(slot(OPTIONAL, 1, 2))
    signatures = [derive(*item).facts.image_signature for item in (required, optional)]
    assert signatures[0] != signatures[1]
    sides = [DescribedDevice(None, None, *item, 0) for item in (required, optional)]
    places = {item.place: (item.left, item.right) for item in compare_devices(*sides)}
    assert places["SM2 size"] == ("at least 2 bytes (16 bits)", "2 bytes (16 bits)")


def test_a_default_module_that_is_not_described_is_named():
    words = "without a module, though required: PDOs of modules are missing; what fits slot"
    images = default_process_image(*described(slot(f'{REQUIRED} Default="9" Fallback="1"', 1, 3)))
    said = f"slot 0 {words} 0: 0x1, 0x3; default module 0x9 of slot 0 is not described, or does not fit"
    assert [image.remarks for image in images] == [(said,)] * 2
    images = default_process_image(*described(slot(REQUIRED, 1, 2) + slot(REQUIRED, 3, 9, preset=9)))
    said = f"slots 0, 1 {words} 0: 0x1, 0x2; default module 0x9 of slot 1 is not described, or does not fit"
    assert images[0].remarks == (said,)


def test_catalog_sheet_and_scan(tmp_path):
    """Nobody who asks for devices with 2 bytes of outputs gets one whose modules have to be chosen first."""
    slots = f"<Slots>{slot(REQUIRED, 1, 2)}</Slots>"
    folder = write(tmp_path / "esi", {"a.xml": esi(device(SMS + OWN + slots), MODULES)})
    path = str(tmp_path / "c.db")
    words = "slot 0 without a module, though required: PDOs of modules are missing; what fits slot 0: 0x1, 0x2"
    with esicatalog.Catalog.open(path, create=True) as catalog:
        catalog.ingest([folder])
        assert not catalog.devices(bytes_out=Bounds(2, 2))
        (bus,) = catalog.identify_scan(read_scan("vendor,product,revision\n0xe5c,1,1\n"))
    (slave,) = bus.slaves
    assert (slave.report.output_bytes, slave.report.input_bytes) == (None, None)
    assert slave.notes == (words,)
    sheet = CliRunner().invoke(cli, ["show", "--db", path, "0xe5c:1:1"]).output
    assert "Default process image, SM2 Outputs: at least 2 bytes (16 bits)" in sheet
    assert f"note: {words}" in sheet
