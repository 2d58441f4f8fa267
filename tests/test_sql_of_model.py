"""What SQL repeats of the model: generated devices are stored, and both say the same of them."""

import re
from collections import defaultdict
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import msgspec
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from test_slot_problems import plugged

from esicatalog import Catalog
from esicatalog.catalog.identity import _BESIDE_LAYOUT
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.document import EsiInfo, Vendor
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.esi.records.slots import Slot, SlotModuleIdent
from esicatalog.esi.write import write_esi
from esicatalog.model.pdo_facts import has_length, is_described
from esicatalog.model.process_image import default_process_image
from esicatalog.model.slots import expand_module

PHASES = (Phase.explicit, Phase.reuse, Phase.generate)
"""To shrink what fails would take minutes: each attempt stores a catalog."""
VENDOR = 0xE5C
MOVES = st.sampled_from([None, False, True])
INCREMENT = st.none() | st.integers(0, 3)
INCREMENTS = dict.fromkeys(
    ("slot_index_increment", "slot_pdo_increment", "slot_group_index_increment", "slot_group_pdo_increment"), INCREMENT
)
SLOT = st.builds(
    Slot, max_instances=st.sampled_from([None, -2, 0, 1, 2]), slot_group=st.none() | st.integers(-1, 3), **INCREMENTS
)
MODULAR = st.builds(Device, slots=st.lists(SLOT, min_size=1, max_size=4).map(tuple), **INCREMENTS)
LONG = Device(slots=(Slot(max_instances=300), Slot()), slot_index_increment=1)
"""A Slot element stands for 255 slots at most: the second is slot 255."""
BEHIND_NONE = Device(slots=(Slot(max_instances=-2), Slot()), slot_index_increment=1)
"""Fewer than none are none: the second Slot element is slot 0."""
LAST_OF_LONG, BEHIND_LONG = 0x6000 + 255, 0x6000 + 300
MOVING_ENTRY = st.builds(
    Entry,
    entry_index=st.integers(0x6000, 0x6002),
    bit_length=st.just(8),
    depend_on_slot=MOVES,
    depend_on_slot_group=MOVES,
)
MODULE = st.builds(
    Module,
    rx_pdos=st.builds(
        Pdo,
        pdo_index=st.just(0x7000),
        depend_on_slot=MOVES,
        depend_on_slot_group=MOVES,
        entries=st.lists(MOVING_ENTRY, min_size=1, max_size=2).map(tuple),
    ).map(lambda pdo: (pdo,)),
)
FIXED_DEVICE = st.builds(
    Device,
    sync_managers=st.lists(
        st.builds(
            SyncManager,
            usage=st.sampled_from(["Outputs", "Inputs", "MBoxOut"]),
            default_size=st.sampled_from([None, 0, 8]),
            virtual=MOVES,
        ),
        min_size=2,
        max_size=4,
    ).map(tuple),
    rx_pdos=st.lists(
        st.builds(
            Pdo,
            pdo_index=st.integers(0x1600, 0x1603),
            sm=st.sampled_from([None, 0, 1, 2]),
            fixed=MOVES,
            ref=st.sampled_from([None, "old"]),
            entries=st.lists(
                st.builds(
                    Entry,
                    entry_index=st.sampled_from([0, 0x7000]),
                    subindex=st.sampled_from([None, 1]),
                    bit_length=st.sampled_from([None, -1, 0, 8]),
                ),
                max_size=2,
            ).map(tuple),
        ),
        max_size=4,
    ).map(tuple),
)


def identified(record, number: int, **more):
    """Each description once: its number is its code and its type."""
    text = f"T{number}"
    codes = {"module_ident": number} if isinstance(record, Module) else {"product_code": number, "revision_no": 1}
    return msgspec.structs.replace(record, type=text, names=(Name(text=text),), **codes, **more)


def with_slots_for(device: Device, ident: int) -> Device:
    accepted = (SlotModuleIdent(module_ident=ident),)
    return msgspec.structs.replace(
        device, slots=tuple(msgspec.structs.replace(slot, module_idents=accepted) for slot in device.slots)
    )


@contextmanager
def stored(devices, modules=()):
    """A catalog of these devices."""
    vendor = Vendor(vendor_id=VENDOR, names=(Name(text="V"),))
    with TemporaryDirectory() as folder:
        document = Path(folder) / "a.xml"
        document.write_bytes(write_esi(EsiInfo(vendor=vendor, devices=tuple(devices), modules=tuple(modules))))
        with Catalog.open(Path(folder) / "c.db", create=True) as catalog:
            catalog.ingest([document], jobs=1)
            yield catalog


IN_SLOT = re.compile(r"RxPdo 0x([0-9A-F]{4}) of module 0x[0-9A-F]+(?: in slot (\d+))?")


def told(evidence) -> set[tuple[int | None, int]]:
    """Slots and PDOs that evidence names, None for what the number of the slot does not move."""
    found = [match.groups() for match in map(IN_SLOT.search, evidence) if match is not None]
    return {(int(slot) if slot is not None else None, int(pdo, 16)) for pdo, slot in found}


def in_slots(device: Device, module: Module) -> dict[int, set[tuple[int | None, int]]]:
    """The same by the index of what is mapped, as the model expands the module in all slots that accept it."""
    found = defaultdict(set)
    for item in plugged(device, module):
        (expanded,) = expand_module(device, item).module.rx_pdos
        for was, now in zip(module.rx_pdos[0].entries, expanded.entries, strict=True):
            if was.depend_on_slot or was.depend_on_slot_group:
                found[now.entry_index].add((item.slot_number, expanded.pdo_index))
    return found


@settings(max_examples=4, phases=PHASES)
@given(
    st.lists(st.tuples(MODULAR, MODULE), min_size=5, max_size=8),
    st.lists(st.integers(0x5FFA, 0x6010), min_size=6, max_size=6, unique=True),
)
def test_the_search_finds_what_modules_map_in_slots(drawn, asked):
    moving = Entry(entry_index=0x6000, bit_length=8, depend_on_slot=True)
    by_hand = Module(rx_pdos=(Pdo(pdo_index=0x7000, entries=(moving,)),))
    drawn = [*drawn, (LONG, by_hand), (BEHIND_NONE, by_hand)]
    modules = {number: identified(module, number) for number, (_, module) in enumerate(drawn, 1)}
    devices = {
        number: identified(with_slots_for(device, number), number) for number, (device, _) in enumerate(drawn, 1)
    }
    of_model = {number: in_slots(device, modules[number]) for number, device in devices.items()}
    with stored(devices.values(), modules.values()) as catalog:
        for index in {*asked, 0x6000, LAST_OF_LONG, BEHIND_LONG}:
            found = {item.product_code: told(item.evidence) for item in catalog.devices(maps=((index, None),))}
            for number, module in modules.items():
                unmoved = [
                    entry
                    for entry in module.rx_pdos[0].entries
                    if entry.entry_index == index and not (entry.depend_on_slot or entry.depend_on_slot_group)
                ]
                expected = of_model[number].get(index, set())
                assert (number in found) == bool(expected or unmoved)
                named = {item for item in found.get(number, ()) if item[0] is not None}
                assert named <= expected
                assert named == expected or (found[number] - named)


@settings(max_examples=5, phases=PHASES)
@given(st.lists(FIXED_DEVICE, min_size=10, max_size=20))
def test_what_identify_says_of_layouts_is_what_the_model_places(drawn):
    devices = [identified(device, number) for number, device in enumerate(drawn, 1)]
    sizes = dict(_BESIDE_LAYOUT)["SyncManagers without PDOs have DefaultSize {} here, {} there"]
    with stored(devices) as catalog, catalog._connection():
        lookup = catalog._lookup_of_file()
        for number, device_id in lookup._query("SELECT product_code, id FROM devices ORDER BY product_code", ()):
            images = default_process_image(devices[number - 1], ())
            assert lookup._without_place(device_id) == [*without_place(images)]
            assert lookup._query(sizes, (device_id,)) == [
                (f"SM{image.sm}", devices[number - 1].sync_managers[image.sm].default_size)
                for image in images
                if image.left_open is not None
            ]


def without_place(images):
    """PDOs of variable content, entries without length, and what lies behind either."""
    for image in images:
        for pdo in image.pdos:
            if not pdo.entries and not is_described(pdo.pdo):
                yield image.sm, pdo.pdo.pdo_index, None, None, 0
            for placed in pdo.entries:
                if placed.bit_offset is None or not has_length(placed.entry):
                    index, subindex, bits = (
                        placed.entry.entry_index,
                        placed.entry.subindex or 0,
                        placed.entry.bit_length,
                    )
                    yield image.sm, pdo.pdo.pdo_index, index, bits, subindex
