"""Indices that leave 16 bits in a slot: named whether or not the module is made for it."""

from hypothesis import given
from hypothesis import strategies as st

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import Dictionary, Object
from esicatalog.esi.records.mailbox import InitCmd, Mailbox
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.esi.records.slots import Slot, SlotModuleIdent
from esicatalog.model.slot_indices import IndicesInSlots
from esicatalog.model.slots import (
    PluggedModule,
    SlotShift,
    accepts,
    declared_indices,
    expand_module,
    leaving_indices,
    numbered_slots,
)

IDENT = (SlotModuleIdent(module_ident=1),)
INDEX = st.one_of(st.none(), st.integers(0, 0x20), st.integers(0x15F0, 0x1610), st.integers(0xFFD0, 0x10010))
MOVES = st.sampled_from([None, False, True])
INCREMENT = st.one_of(st.none(), st.integers(-0x20, 0x20))


def moved(record, field):
    return st.builds(record, **{field: INDEX, "depend_on_slot": MOVES, "depend_on_slot_group": MOVES})


def some(strategy):
    return st.lists(strategy, max_size=2).map(tuple)


PDO = st.builds(
    Pdo,
    pdo_index=INDEX,
    depend_on_slot=MOVES,
    depend_on_slot_group=MOVES,
    excludes=some(moved(Exclude, "pdo_index")),
    entries=some(moved(Entry, "entry_index")),
)
MODULE = st.builds(
    Module,
    module_ident=st.just(1),
    rx_pdos=some(PDO),
    tx_pdos=some(PDO),
    mailbox=st.none() | st.builds(Mailbox, coe_init_cmds=some(moved(InitCmd, "object_index"))),
    profiles=some(
        st.builds(Profile, dictionary=st.none() | st.builds(Dictionary, objects=some(moved(Object, "object_index"))))
    ),
)
SLOT = st.builds(
    Slot,
    module_idents=st.just(IDENT),
    max_instances=st.integers(0, 3),
    slot_group=st.none() | st.integers(0, 3),
    slot_index_increment=INCREMENT,
    slot_pdo_increment=INCREMENT,
    slot_group_index_increment=INCREMENT,
    slot_group_pdo_increment=INCREMENT,
)


DEVICE = st.builds(
    Device,
    slots=st.lists(SLOT, min_size=1, max_size=3).map(tuple),
    slot_index_increment=INCREMENT,
    slot_pdo_increment=INCREMENT,
    slot_group_index_increment=INCREMENT,
    slot_group_pdo_increment=INCREMENT,
)


def test_objects_that_describe_pdos_move_as_these_do():
    """Declared, mapped or written: by SlotPdoIncrement, others by SlotIndexIncrement (ESI-FACTS section 12.1)."""
    indices = (0x1600, 0x17FF, 0x1800)
    module = Module(
        module_ident=1,
        rx_pdos=(Pdo(entries=tuple(Entry(entry_index=index, depend_on_slot=True) for index in indices)),),
        mailbox=Mailbox(coe_init_cmds=tuple(InitCmd(object_index=index, depend_on_slot=True) for index in indices)),
        profiles=(
            Profile(
                dictionary=Dictionary(
                    objects=tuple(Object(object_index=index, depend_on_slot=True) for index in indices)
                )
            ),
        ),
    )
    slot = Slot(module_idents=IDENT, max_instances=3)
    device = Device(slots=(slot,), slot_index_increment=0x10, slot_pdo_increment=2)
    expanded = expand_module(device, PluggedModule(2, slot, module)).module
    moved = [0x1604, 0x1803, 0x1820]
    assert [entry.entry_index for entry in expanded.rx_pdos[0].entries] == moved
    assert [command.object_index for command in expanded.mailbox.coe_init_cmds] == moved
    assert [declared.object_index for declared in expanded.profiles[0].dictionary.objects] == moved


def problems(device, *modules):
    return [(plugged.slot_number, found) for plugged, found in leaving_indices(device, modules)]


def plugged(device, module):
    return [PluggedModule(number, slot, module) for number, slot, _ in numbered_slots(device) if accepts(slot, module)]


@given(DEVICE, MODULE)
def test_a_module_is_named_where_expanding_it_names_problems(device, module):
    named = problems(device, module)
    expanded = [(item.slot_number, found) for item in plugged(device, module) if (found := expand(device, item))]
    assert bool(named) == bool(expanded)
    assert set(named) <= set(expanded)


def expand(device, item):
    return expand_module(device, item).problems


def test_an_index_that_leaves_16_bits_is_named():
    pdo = Pdo(pdo_index=0x1600, entries=(Entry(entry_index=0xFFFE, depend_on_slot=True),))
    module = Module(module_ident=1, rx_pdos=(pdo,))
    slot = Slot(slot_index_increment=1, module_idents=IDENT)
    assert problems(Device(slots=(slot, slot)), module) == []
    words = "object 0xFFFE would become 0x10000 in slot 2; left unshifted"
    assert problems(Device(slots=(slot, slot, slot)), module) == [(2, (words,))]


def test_an_index_that_would_become_negative_is_named():
    pdo = Pdo(pdo_index=0x1600, entries=(Entry(entry_index=0x10, depend_on_slot=True),))
    slot = Slot(slot_index_increment=-0x11, max_instances=2, module_idents=IDENT)
    words = "object 0x0010 would become -0x1 in slot 1; left unshifted"
    assert problems(Device(slots=(slot,)), Module(module_ident=1, rx_pdos=(pdo,))) == [(1, (words,))]


@given(DEVICE, MODULE)
def test_the_indices_in_slots_are_those_of_the_expanded_modules(device, module):
    """Those that move: what stays where it is, or would leave 16 bits, is not asked for."""
    in_slots = IndicesInSlots(device, [module])
    pdos, objects = set(), set()
    for item in plugged(device, module):
        expanded = expand_module(device, item).module
        for was, now in zip(pdos_of(module), pdos_of(expanded), strict=True):
            pdos.add(now.pdo_index if now.pdo_index != was.pdo_index else None)
        for was, now in zip(objects_of(module), objects_of(expanded), strict=True):
            objects.add((now.object_index, was.object_index) if now.object_index != was.object_index else None)
    moved_pdos, moved_objects = pdos - {None}, objects - {None}
    assert all(in_slots.has_pdo(index) for index in moved_pdos)
    assert all((module, was) in in_slots.objects(now) for now, was in moved_objects)
    unmoved = {pdo.pdo_index for pdo in pdos_of(module)}
    reachable = {index for index in range(-0x100, 0x200) if in_slots.has_pdo(index)}
    assert reachable <= moved_pdos | unmoved


@given(DEVICE, MODULE)
def test_the_sources_of_an_index_tell_whether_the_expanded_module_declares_it(device, module):
    declared = declared_indices(module)
    for item in plugged(device, module):
        shift = SlotShift(device, item.slot, item.slot_number)
        there = {found.object_index for found in objects_of(expand_module(device, item).module)}
        asked = {index for found in declared for index in range(found.unshifted - 0x100, found.unshifted + 0x100, 3)}
        for index in (there | asked) - {None, 0}:
            assert shift.sources(index).isdisjoint(declared) == (index not in there)


def pdos_of(module):
    return (*module.rx_pdos, *module.tx_pdos)


def objects_of(module):
    return [item for profile in module.profiles if profile.dictionary for item in profile.dictionary.objects]


def test_hundreds_of_slots_are_looked_at_as_one():
    """The slots of a coupler mostly accept the same modules and move them alike."""
    idents = tuple(SlotModuleIdent(module_ident=ident) for ident in range(300))
    slots = tuple(Slot(max_instances=1, module_idents=idents) for _ in range(300))
    modules = [
        Module(module_ident=ident, rx_pdos=(Pdo(pdo_index=0x1600 + ident % 4, depend_on_slot=True),))
        for ident in range(300)
    ]
    in_slots = IndicesInSlots(Device(slots=slots, slot_pdo_increment=4), modules)
    assert in_slots.has_pdo(0x1600 + 4 * 299 + 3)
    assert not in_slots.has_pdo(0x1600 + 4 * 300)
    (alike,) = in_slots._alike
    assert len(alike.pdos) == 4
