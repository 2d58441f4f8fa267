"""Indices that leave 16 bits in a slot: named whether or not the module is made for it."""

from hypothesis import given
from hypothesis import strategies as st

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import Dictionary, Object
from esicatalog.esi.records.mailbox import InitCmd, Mailbox
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Exclude, Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.esi.records.slots import Slot
from esicatalog.model.slots import PluggedModule, expand_module, shift_problems

INDEX = st.one_of(st.none(), st.integers(0, 0x20), st.integers(0xFFD0, 0x10010))
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
    rx_pdos=some(PDO),
    tx_pdos=some(PDO),
    mailbox=st.none() | st.builds(Mailbox, coe_init_cmds=some(moved(InitCmd, "object_index"))),
    profiles=some(
        st.builds(Profile, dictionary=st.none() | st.builds(Dictionary, objects=some(moved(Object, "object_index"))))
    ),
)
SLOT = st.builds(
    Slot,
    slot_group=st.none() | st.integers(0, 3),
    slot_index_increment=INCREMENT,
    slot_pdo_increment=INCREMENT,
    slot_group_index_increment=INCREMENT,
    slot_group_pdo_increment=INCREMENT,
)


@given(MODULE, SLOT, st.integers(0, 3))
def test_the_quick_look_names_what_expanding_names(module, slot, number):
    plugged = PluggedModule(number, slot, module)
    assert shift_problems(Device(), plugged) == expand_module(Device(), plugged).problems


def test_an_index_that_leaves_16_bits_is_named():
    pdo = Pdo(pdo_index=0x1600, entries=(Entry(entry_index=0xFFFE, depend_on_slot=True),))
    slot = Slot(slot_index_increment=1)
    assert shift_problems(Device(), PluggedModule(1, slot, Module(rx_pdos=(pdo,)))) == ()
    problems = shift_problems(Device(), PluggedModule(2, slot, Module(rx_pdos=(pdo,))))
    assert problems == ("object 0xFFFE would become 0x10000 in slot 2; left unshifted",)


def test_an_index_that_would_become_negative_is_named():
    pdo = Pdo(pdo_index=0x1600, entries=(Entry(entry_index=0x10, depend_on_slot=True),))
    slot = Slot(slot_index_increment=-0x11)
    problems = shift_problems(Device(), PluggedModule(1, slot, Module(rx_pdos=(pdo,))))
    assert problems == ("object 0x0010 would become -0x1 in slot 1; left unshifted",)
