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
from esicatalog.esi.records.common import Name
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import EsiInfo, Vendor
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.esi.records.slots import Slot, SlotModuleIdent
from esicatalog.esi.write import write_esi
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
