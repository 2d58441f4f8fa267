"""Process images: bits concatenated, rounded once, choices of OpMode and slots (ESI-FACTS sections 9, 12, 18)."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from snippets import device, esi, mapping_objects, only_device, pdo, read

from esicatalog.esi.reader import read_esi
from esicatalog.model.process_image import default_process_image, process_image
from esicatalog.model.slots import PluggedModule, default_modules, reachable_modules

SMS = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm>"


def images(content: str, modules: str = "", sms: str = SMS):
    """Images by SyncManager number."""
    info = read(esi(device(sms + content), modules)).document.infos[0]
    return {image.sm: image for image in default_process_image(info.devices[0], info.modules)}


def indices(image) -> list[int | None]:
    return [placed.pdo.pdo_index for placed in image.pdos]


def test_pdos_are_concatenated_bit_by_bit():
    image = images(pdo("RxPdo", "#x1600", 1, 2, attributes='Sm="2"') + pdo("RxPdo", "#x1601", 6, attributes='Sm="2"'))[
        2
    ]
    assert [[e.bit_offset for e in p.entries] for p in image.pdos] == [[0, 1], [3]]
    assert (image.bit_size, image.byte_size) == (9, 2)


@given(st.lists(st.lists(st.integers(1, 64), min_size=1, max_size=5), max_size=5))
def test_bytes_are_rounded_once_per_sync_manager(lengths):
    content = "".join(pdo("TxPdo", f"#x{0x1A00 + n:X}", *bits, attributes='Sm="3"') for n, bits in enumerate(lengths))
    image = images(content)[3]
    total = sum(map(sum, lengths))
    assert image.bit_size == total
    assert image.byte_size == -(-total // 8)
    offsets = [e.bit_offset for p in image.pdos for e in p.entries]
    flat = [bits for entry in lengths for bits in entry]
    assert offsets == [sum(flat[:n]) for n in range(len(flat))]


def test_padding_takes_room():
    gap = "<Entry><Index>0</Index><BitLen>7</BitLen></Entry>"
    image = images(f'<RxPdo Sm="2"><Index>#x1600</Index><Name>R</Name>{gap}{gap}</RxPdo>')[2]
    assert image.bit_size == 14


def test_a_pdo_without_sm_is_not_assigned():
    found = images(
        pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("RxPdo", "#x1601", 8, attributes='Mandatory="1"')
    )
    assert indices(found[2]) == [0x1600]
    assert indices(found[3]) == []


def test_of_two_defaults_that_exclude_each_other_the_first_stays():
    second = pdo("RxPdo", "#x1601", 8, attributes='Sm="2"', extra="<Exclude>#x1600</Exclude>")
    image = images(pdo("RxPdo", "#x1600", 16, attributes='Sm="2"') + second)[2]
    assert (indices(image), image.bit_size) == ([0x1600], 16)
    assert len(image.remarks) == 1
    first = pdo("RxPdo", "#x1600", 16, attributes='Sm="2"', extra="<Exclude>#x1601</Exclude>")
    assert indices(images(first + pdo("RxPdo", "#x1601", 8, attributes='Sm="2"'))[2]) == [0x1600]


def test_a_pdo_that_excludes_itself_stays():
    image = images(pdo("RxPdo", "#x1600", 16, attributes='Sm="2"', extra="<Exclude>#x1600</Exclude>"))[2]
    assert indices(image) == [0x1600]


def test_virtual_pdos_are_not_transported():
    image = images(
        pdo("TxPdo", "#x1A00", 8, attributes='Sm="3" Virtual="1"') + pdo("TxPdo", "#x1A01", 4, attributes='Sm="3"')
    )[3]
    assert (indices(image), image.bit_size) == ([0x1A01], 4)
    assert len(image.remarks) == 1


def op_mode(lists: str = "", attributes: str = "") -> str:
    vendor = f"<VendorSpecific><TwinCAT {attributes}/></VendorSpecific>"
    return f"<OpMode><Name>m</Name><AssignActivate>0</AssignActivate>{lists}{vendor}</OpMode>"


LISTED = '<Sm No="2"><Pdo>#x1601</Pdo></Sm>'
PDOS = (
    pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
    + pdo("RxPdo", "#x1601", 3)
    + pdo("TxPdo", "#x1A00", 5, attributes='Sm="3"')
)


def test_the_lists_of_the_default_op_mode_win():
    found = images(PDOS + f"<Dc>{op_mode(LISTED)}</Dc>")
    assert indices(found[2]) == [0x1601]
    assert indices(found[3]) == [0x1A00], "a SyncManager without a list keeps its default"


def test_of_two_mandatory_pdos_that_exclude_each_other_one_is_assigned_too_and_the_other_left_out():
    """0x1600 comes first; of 0x1601 nothing else is said than that it is left out."""
    first = pdo("RxPdo", "#x1600", 8, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1601</Exclude>")
    second = pdo("RxPdo", "#x1601", 8, attributes='Sm="2" Mandatory="1"')
    listed = op_mode('<Sm No="2"><Pdo>#x1602</Pdo></Sm>')
    image = images(first + second + pdo("RxPdo", "#x1602", 8) + f"<Dc>{listed}</Dc>")[2]
    assert indices(image) == [0x1600, 0x1602]
    assert image.remarks == (
        "PDO 0x1600 is mandatory: assigned too",
        "PDO 0x1601 is left out: 0x1600 excludes it",
    )


EXCLUSIVE = (
    pdo("RxPdo", "#x1600", 8, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1601</Exclude>")
    + pdo("RxPdo", "#x1601", 8, attributes='Sm="2" Mandatory="1"')
    + pdo("RxPdo", "#x1602", 8)
)


@pytest.mark.parametrize(("listed", "other"), [(0x1600, 0x1601), (0x1601, 0x1600)])
def test_a_list_chooses_between_two_mandatory_pdos_that_exclude_each_other(listed, other):
    """ESI-FACTS 0.5: the lists win."""
    mode = op_mode(f'<Sm No="2"><Pdo>#x{listed:X}</Pdo></Sm>')
    image = images(f"{EXCLUSIVE}<Dc>{mode}</Dc>")[2]
    assert indices(image) == [listed]
    assert image.remarks == (f"PDO 0x{other:X} is left out: 0x{listed:X} excludes it",)


def test_a_mandatory_pdo_that_a_list_leaves_out_stays_beside_one_that_is_not_mandatory():
    """ESI-FACTS section 9: it must stay assigned."""
    optional = EXCLUSIVE.replace(' Mandatory="1"', "", 1)
    mode = op_mode('<Sm No="2"><Pdo>#x1600</Pdo></Sm>')
    assert indices(images(f"{optional}<Dc>{mode}</Dc>")[2]) == [0x1601]


@pytest.mark.parametrize("listed", [0x1600, 0x1601])
def test_a_mandatory_pdo_of_the_list_stays_where_the_user_lists_others(listed):
    """Of the two that exclude each other that one which the OpMode lists."""
    mode = op_mode(f'<Sm No="2"><Pdo>#x{listed:X}</Pdo></Sm>')
    (info,) = read(esi(device(SMS + f"{EXCLUSIVE}<Dc>{mode}</Dc>"))).document.infos
    (found,) = (
        image
        for image in process_image(info.devices[0], (), info.devices[0].op_modes[0], {2: [0x1602]})
        if image.sm == 2
    )
    assert indices(found) == [listed, 0x1602]


@pytest.mark.parametrize(("order", "offset"), [(("#x1A00", "#x1B02"), 0), (("#x1B02", "#x1A00"), None)])
def test_a_pdo_that_is_listed_and_not_described_has_no_known_length(order, offset):
    """It is exchanged all the same: the image is longer than what is described, and what follows has no place."""
    listed = op_mode(f'<Sm No="3">{"".join(f"<Pdo>{index}</Pdo>" for index in order)}</Sm>')
    image = images(pdo("TxPdo", "#x1A00", 8) + f"<Dc>{listed}</Dc>")[3]
    assert indices(image) == [int(index.replace("#", "0"), 16) for index in order]
    assert (image.byte_size, image.byte_words) == (None, "at least 1 byte")
    assert [item.bit_offset for placed in image.pdos for item in placed.entries] == [offset]
    assert image.remarks[0] == "PDO 0x1B02 is listed but not described"
    assert image.remarks[1].startswith("PDO 0x1B02 of SM3 has no described entries: how long it is")


def test_a_listed_pdo_goes_the_way_of_its_sync_manager_be_it_described_or_not():
    """With a SyncManager that nobody describes its index tells the way; a mailbox has no PDO."""
    lists = "".join(f'<Sm No="{number}"><Pdo>{index}</Pdo></Sm>' for number, index in ((2, 100), (7, "#x1650"), (1, 5)))
    found = images(f"<Dc>{op_mode(lists)}</Dc>")
    assert [(placed.direction, placed.pdo.pdo_index) for placed in found[2].pdos] == [("RxPdo", 100)]
    assert [(placed.direction, placed.pdo.pdo_index) for placed in found[7].pdos] == [("RxPdo", 0x1650)]
    assert found[1].pdos == ()


def test_a_listed_pdo_that_nobody_describes_goes_the_way_of_its_index():
    """0x1600 to 0x17FF are RxPDOs, 0x1A00 to 0x1BFF TxPDOs (ETG.1000.6): outputs have none of these."""
    found = images(f"""<Dc>{op_mode('<Sm No="2"><Pdo>#x1A99</Pdo></Sm><Sm No="3"><Pdo>#x17FF</Pdo></Sm>')}</Dc>""")
    assert (found[2].pdos, found[3].pdos) == ((), ())
    assert found[2].remarks[-1] == "PDO 0x1A99 is left out: it is a TxPdo, SM2 is for Outputs"
    assert found[3].remarks[-1] == "PDO 0x17FF is left out: it is a RxPdo, SM3 is for Inputs"


def test_a_listed_pdo_may_be_that_of_a_module_that_is_not_plugged():
    """An OpMode lists 0x1A10 for a module; without the module nothing is exchanged in its place."""
    listed = op_mode('<Sm No="3"><Pdo>#x1A00</Pdo><Pdo>#x1A10</Pdo></Sm>')
    slots = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>#x1</ModuleIdent></Slot></Slots>'
    image = images(pdo("TxPdo", "#x1A00", 8) + f"<Dc>{listed}</Dc>{slots}")[3]
    assert (indices(image), image.byte_size) == ([0x1A00], 1)
    assert image.remarks == ("PDO 0x1A10 is listed but not described",)


def test_nothing_is_transported_by_a_virtual_sync_manager_be_it_listed_and_not_described():
    """As terminals have it whose SYNC times are read from the registers of the slave controller."""
    listed = op_mode('<Sm No="4"><Pdo>#x1B02</Pdo></Sm>')
    image = images('<Sm StartAddress="#x0998" Virtual="1">Inputs</Sm>' + f"<Dc>{listed}</Dc>")[4]
    assert (image.pdos, image.byte_size) == ((), 0)
    assert image.remarks == ("PDO 0x1B02 is listed but not described",)


def test_mandatory_pdos_stay_whatever_an_op_mode_lists():
    """ESI-FACTS section 9: Mandatory must stay assigned to its SyncManager; a virtual one is not exchanged at all."""
    inputs = pdo("TxPdo", "#x1A00", 16, attributes='Sm="3" Mandatory="1"') + pdo("TxPdo", "#x1A01", 16)
    virtual = pdo("TxPdo", "#x1A02", 16, attributes='Sm="3" Mandatory="1" Virtual="1"')
    listed = op_mode('<Sm No="3"><Pdo>#x1A01</Pdo></Sm>')
    found = images(inputs + virtual + f"<Dc>{listed}</Dc>")
    assert (indices(found[3]), found[3].bit_size) == ([0x1A00, 0x1A01], 32)
    assert found[3].remarks == ("PDO 0x1A00 is mandatory: assigned too",)


def test_pdos_of_the_other_direction_are_not_exchanged():
    """The master writes the RxPDO's 2 bytes there, not 6."""
    found = images(pdo("RxPdo", "#x1600", 16, attributes='Sm="2"') + pdo("TxPdo", "#x1A00", 32, attributes='Sm="2"'))
    assert (indices(found[2]), found[2].byte_size) == ([0x1600], 2)
    assert found[2].remarks == ("PDO 0x1A00 is left out: it is a TxPdo, SM2 is for Outputs",)


def test_a_pdo_of_the_direction_of_the_control_byte_is_exchanged_whatever_the_role_says():
    """SMC EX250-SEN1 calls both SyncManagers Outputs; bits 3:2 of the second one's ControlByte say input."""
    sms = '<Sm ControlByte="#x46">Outputs</Sm><Sm ControlByte="#x0">Outputs</Sm>'
    content = pdo("RxPdo", "#x1600", 16, attributes='Sm="0"') + pdo("TxPdo", "#x1A00", 32, attributes='Sm="1"')
    outputs, inputs = process_image(only_device(esi(device(sms + content))), (), None)
    assert (indices(outputs), outputs.transfer_direction, outputs.remarks) == ([0x1600], "output", ())
    assert (indices(inputs), inputs.transfer_direction, inputs.remarks) == ([0x1A00], "input", ())
    mailbox = '<Sm ControlByte="#x22">MBoxOut</Sm>' + pdo("TxPdo", "#x1A00", 32, attributes='Sm="0"')
    assert indices(process_image(only_device(esi(device(mailbox))), (), None)[0]) == []


def test_a_mailbox_exchanges_no_pdos():
    found = images(pdo("RxPdo", "#x1600", 16, attributes='Sm="0"'))
    assert (indices(found[0]), found[0].byte_size) == ([], 0)
    assert found[0].remarks == ("PDO 0x1600 is left out: it is a RxPdo, SM0 is for MBoxOut",)


def test_of_listed_pdos_with_one_index_that_of_the_direction_counts():
    same = pdo("RxPdo", "#x1A00", 16) + pdo("TxPdo", "#x1A00", 32)
    listed = op_mode('<Sm No="3"><Pdo>#x1A00</Pdo></Sm>')
    found = images(same + f"<Dc>{listed}</Dc>")
    assert [(placed.direction, found[3].byte_size) for placed in found[3].pdos] == [("TxPdo", 4)]


def test_defaults_of_two_sync_managers_may_exclude_each_other():
    sms = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm><Sm>Outputs</Sm>"
    first = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"', extra="<Exclude>#x1601</Exclude>")
    second = pdo("RxPdo", "#x1601", 16, attributes='Sm="4"')
    info = read(esi(device(sms + first + second))).document.infos[0]
    found = {image.sm: image for image in default_process_image(info.devices[0], ())}
    assert (indices(found[2]), indices(found[4])) == ([0x1600], [])
    assert found[4].remarks == ("PDO 0x1601 is left out: 0x1600 excludes it",)


@pytest.mark.parametrize(
    ("attributes", "of_sm2", "of_sm4", "remark"),
    [
        ("", [], [0x1601], "PDO 0x1600 is left out: 0x1601 excludes it"),
        ('Mandatory="1"', [0x1600], [], "PDO 0x1601 is left out: 0x1600 excludes it"),
    ],
)
def test_a_listed_pdo_stays_beside_the_default_of_another_sync_manager(attributes, of_sm2, of_sm4, remark):
    """ESI-FACTS 0.5: the lists win; only what is mandatory stays all the same."""
    sms = "<Sm>MBoxOut</Sm><Sm>MBoxIn</Sm><Sm>Outputs</Sm><Sm>Inputs</Sm><Sm>Outputs</Sm>"
    first = pdo("RxPdo", "#x1600", 8, attributes=f'Sm="2" {attributes}', extra="<Exclude>#x1601</Exclude>")
    second = pdo("RxPdo", "#x1601", 16, attributes='Sm="4"')
    listing = op_mode('<Sm No="4"><Pdo>#x1601</Pdo></Sm>')
    found = images(f"{first}{second}<Dc>{listing}</Dc>", sms=sms)
    assert (indices(found[2]), indices(found[4])) == (of_sm2, of_sm4)
    assert remark in found[4 if of_sm2 else 2].remarks


def test_an_index_that_is_assigned_twice_is_named_where_it_is():
    slot = "<Slot><Name>s</Name><ModuleIdent Default='1'>1</ModuleIdent></Slot>"
    outputs = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
    module = f'<Module><Type ModuleIdent="1">m</Type><Name>m</Name>{outputs}</Module>'
    found = images(f"<Slots>{slot}{slot}</Slots>", module)
    repeated = "PDO 0x1600 is assigned twice, and devices and masters tell PDOs apart by their index"
    assert (indices(found[2]), found[2].remarks, found[3].remarks) == ([0x1600, 0x1600], (repeated,), ())


def test_a_mandatory_pdo_that_is_itself_left_out_excludes_nothing():
    """0x1600 stays, so 0x1601 does not, and nothing speaks against 0x1602."""
    content = (
        pdo("RxPdo", "#x1600", 8, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1601</Exclude>")
        + pdo("RxPdo", "#x1601", 8, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1602</Exclude>")
        + pdo("RxPdo", "#x1602", 8, attributes='Sm="2"')
    )
    image = images(content)[2]
    assert indices(image) == [0x1600, 0x1602]
    assert image.remarks == ("PDO 0x1601 is left out: 0x1600 excludes it",)


def test_the_op_mode_that_a_plugged_module_asks_for_counts():
    """DcOpModeName of the default module: its OpMode lists 0x1601, the first one 0x1600."""
    dc = op_mode('<Sm No="2"><Pdo>#x1600</Pdo></Sm>') + op_mode(LISTED).replace("<Name>m<", "<Name>asked<")
    slot = '<Slots><Slot MinInstances="1" MaxInstances="1"><ModuleIdent Default="1">#x30</ModuleIdent></Slot></Slots>'
    pdos = pdo("RxPdo", "#x1600", 8) + pdo("RxPdo", "#x1601", 32)
    head = '<Type ModuleIdent="#x30">M</Type><Name>M</Name>'
    module = f"<Module>{head}{pdos}<DcOpModeName>asked</DcOpModeName></Module>"
    assert indices(images(f"<Dc>{dc}</Dc>{slot}", module)[2]) == [0x1601]


def test_the_lists_of_superseded_and_later_op_modes_do_not_count():
    assert indices(images(PDOS + f"<Dc>{op_mode()}{op_mode(LISTED)}</Dc>")[2]) == [0x1600]
    superseded = op_mode(LISTED, 'IgnoreFromBuildNo="1"')
    assert indices(images(PDOS + f"<Dc>{superseded}{op_mode()}</Dc>")[2]) == [0x1600]


def test_oversampling_repeats_the_entries():
    four = LISTED.replace("<Pdo>", '<Pdo OSFac="4">')
    found = images(PDOS + f"<Dc>{op_mode(four)}</Dc>")
    assert [e.bit_offset for e in found[2].pdos[0].entries] == [0, 3, 6, 9]
    assert found[2].bit_size == 12


def places(image) -> list[tuple[int, int, int]]:
    """Bit offset, index and subindex of every entry."""
    return [(e.bit_offset, e.entry.entry_index, e.entry.subindex) for p in image.pdos for e in p.entries]


SAMPLES = 'Sm="2" OSFac="4" OSIndexInc="16"'


def test_each_sample_lies_osindexinc_further():
    """0x7000:01 and :02 in four samples with OSIndexInc 16: 0x7000, 0x7010, 0x7020, 0x7030. Padding stays padding."""
    gap = "<Entry><Index>0</Index><BitLen>4</BitLen></Entry>"
    image = images(pdo("RxPdo", "#x1600", 8, 4, attributes=SAMPLES, extra=gap))[2]
    assert [place for place in places(image) if place[1]] == [
        (start + at, 0x7000 + 16 * sample, subindex)
        for sample, start in enumerate((0, 16, 32, 48))
        for at, subindex in ((4, 1), (12, 2))
    ]
    assert [place for place in places(image) if not place[1]] == [(start, 0, None) for start in (0, 16, 32, 48)]
    assert image.remarks == ()


def test_samples_whose_index_would_leave_16_bits_stay():
    """0x7000 + 3 * 0x3000 = 0x10000."""
    too_far = images(pdo("RxPdo", "#x1600", 8, attributes='Sm="2" OSFac="4" OSIndexInc="12288"'))[2]
    assert [index for _, index, _ in places(too_far)] == [0x7000] * 4
    assert len(too_far.remarks) == 1 and "OSIndexInc 12288" in too_far.remarks[0]
    in_range = images(pdo("RxPdo", "#x1600", 8, attributes='Sm="2" OSFac="3" OSIndexInc="12288"'))[2]
    assert [index for _, index, _ in places(in_range)] == [0x7000, 0xA000, 0xD000]


def test_the_op_mode_says_how_often_a_chosen_pdo_is_sampled():
    """OSFac of the OpMode's Pdo, 3, not that of the RxPdo, 20: 3 * 16 + 8 bits."""
    lists = '<Sm No="2"><Pdo OSFac="3">#x1600</Pdo></Sm>'
    content = pdo("RxPdo", "#x1600", 16, attributes='OSFac="20"') + pdo("RxPdo", "#x1601", 8)
    found = read(esi(device(SMS + content + f"<Dc>{op_mode(lists)}</Dc>"))).document.infos[0].devices[0]
    (outputs, _) = process_image(found, (), found.op_modes[0], {2: [0x1601, 0x1600]})
    assert (indices(outputs), outputs.bit_size) == ([0x1601, 0x1600], 8 + 3 * 16)
    assert outputs.remarks == ()


def test_an_oversampled_pdo_that_the_op_mode_does_not_list_is_named():
    content = pdo("RxPdo", "#x1601", 8) + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3" OSFac="20"')
    found = images(content + f"<Dc>{op_mode(LISTED)}</Dc>")
    assert found[3].bit_size == 320
    assert len(found[3].remarks) == 1 and "its own OSFac 20 counts" in found[3].remarks[0]


@pytest.mark.parametrize("factor", ["0", "-2", "1"])
def test_a_pdo_is_sampled_once_at_least(factor):
    assert images(pdo("RxPdo", "#x1600", 16, attributes=f'Sm="2" OSFac="{factor}"'))[2].bit_size == 16


ASSIGN = '<Mailbox><CoE PdoAssign="1"/></Mailbox>'
CONFIG = '<Mailbox><CoE PdoAssign="1" PdoConfig="1"/></Mailbox>'
THREE_SAMPLES = pdo("TxPdo", "#x1A01", 16, attributes='Sm="3" OSFac="3" OSIndexInc="1"')
MAPPINGS = ((0x1A01, "10010160"), (0x1A02, "10020160"), (0x1A03, "10030160"))
"""Like EL3632: 0x6001:01, 0x6001:02 and 0x6001:03 of 16 bits each, where the PDO says 0x7000:01."""
BY_DICTIONARY = [(0, 0x6001, 1), (16, 0x6001, 2), (32, 0x6001, 3)]
BY_STEPS = [(0, 0x7000, 1), (16, 0x7001, 1), (32, 0x7002, 1)]


@pytest.mark.parametrize(
    ("mailbox", "mappings", "more", "pdo_indices", "mapped", "is_told"),
    [
        (ASSIGN, MAPPINGS, "", [0x1A01, 0x1A02, 0x1A03], BY_DICTIONARY, False),
        ("<Mailbox><CoE/></Mailbox>", MAPPINGS, "", [0x1A01, 0x1A02, 0x1A03], BY_DICTIONARY, False),
        (CONFIG, MAPPINGS, "", [0x1A01, 0x1A02, 0x1A03], BY_STEPS, False),
        (ASSIGN, (*MAPPINGS[:2], (0x1A03, "08030160")), "", [0x1A01, 0x1A02, 0x1A03], BY_STEPS, False),
        (ASSIGN, MAPPINGS[1:], "", [0x1A01, 0x1A02, 0x1A03], BY_STEPS, False),
        (ASSIGN, MAPPINGS[:2], "", [0x1A01], BY_STEPS, True),
        (ASSIGN, MAPPINGS, pdo("TxPdo", "#x1A03", 8), [0x1A01], BY_STEPS, True),
        (CONFIG, MAPPINGS[:2], "", [0x1A01], BY_STEPS, False),
        ("<Mailbox><CoE/></Mailbox>", (), "", [0x1A01], BY_STEPS, False),
        ("", MAPPINGS, "", [0x1A01], BY_STEPS, False),
    ],
    ids=[
        "own PDOs",
        "a fixed assignment",
        "the master maps",
        "another length",
        "no default of the first",
        "one is missing",
        "one is another PDO",
        "the master maps all",
        "nothing to assign",
        "no CoE",
    ],
)
def test_samples_are_pdos_of_their_own_where_the_dictionary_has_a_mapping_for_each(
    mailbox, mappings, more, pdo_indices, mapped, is_told
):
    image = images(mapping_objects(*mappings) + THREE_SAMPLES + more + mailbox)[3]
    assert (indices(image), places(image), image.byte_size) == (pdo_indices, mapped, 6)
    assert any("how the device assigns the samples is not described" in words for words in image.remarks) == is_told
    assert len(image.remarks) == is_told
    numbered = [1, 2, 3] if len(pdo_indices) > 1 else [0]
    assert [(item.repeat, item.sample) for item in image.pdos] == [(3, number) for number in numbered]
    assert [item.position for item in image.pdos] == [0, None, None][: len(pdo_indices)]


def test_what_follows_samples_of_their_own_lies_behind_them():
    """Three times 16 bits; 0x1BFF is the last mapping object of a TxPDO, so two samples behind it have none."""
    behind = pdo("TxPdo", "#x1A80", 8, attributes='Sm="3"')
    image = images(mapping_objects(*MAPPINGS) + THREE_SAMPLES + behind + ASSIGN)[3]
    assert (indices(image), places(image)[-1][0]) == ([0x1A01, 0x1A02, 0x1A03, 0x1A80], 48)
    last = THREE_SAMPLES.replace("#x1A01", "#x1BFF")
    beyond = images(mapping_objects(*((index, "10010160") for index in (0x1BFF, 0x1C00, 0x1C01))) + last + ASSIGN)[3]
    assert (indices(beyond), len(beyond.remarks)) == ([0x1BFF], 1)


HUGE = 2**63 - 1
TOO_OFTEN = '<Sm No="2"><Pdo OSFac="40000">#x1600</Pdo><Pdo>#x1601</Pdo></Sm>'
GROUP = '<Slots><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot>{}</Slots>'


@pytest.mark.parametrize(
    "content",
    [
        pdo("RxPdo", "#x1600", 16, attributes='Sm="2" OSFac="300000000"'),
        pdo("RxPdo", "#x1600", 0, attributes='Sm="2" OSFac="300000000"'),
        pdo("RxPdo", "#x1600", HUGE, HUGE, attributes='Sm="2"'),
        pdo("RxPdo", "#x1600", 16, attributes='Sm="2" OSFac="32768"'),
        pdo("RxPdo", "#x1600", 16) + f"<Dc>{op_mode(TOO_OFTEN)}</Dc>",
    ],
    ids=["factor", "no bits", "bits", "one too many", "OpMode"],
)
def test_what_no_sync_manager_holds_is_left_out(content):
    """A SyncManager has 65535 bytes, 32767 samples of 16 bits. A PDO behind that fits stays."""
    image = images(content + pdo("RxPdo", "#x1601", 8, attributes='Sm="2"'))[2]
    assert (indices(image), image.bit_size) == ([0x1601], 8)
    assert image.overflow in image.remarks and "PDO 0x1600" in image.overflow


def test_a_list_for_no_sync_manager_is_told():
    """No is required (ETG.2000 OpMode/Sm); without it nobody knows where the PDO goes, nor how often it is sampled."""
    lists = '<Sm><Pdo OSFac="2">#x1600</Pdo></Sm>'
    image = images(pdo("RxPdo", "#x1600", 16, attributes='Sm="2"') + f"<Dc>{op_mode(lists)}</Dc>")[2]
    assert (indices(image), image.bit_size) == ([0x1600], 16)
    assert image.remarks == ("the OpMode's list of PDO 0x1600 names no SyncManager (No): it is ignored",)


def test_several_lists_for_a_sync_manager_are_one():
    """Nothing says that a later one takes the place of the first: 16 and 2 times 8 bits."""
    lists = '<Sm No="2"><Pdo>#x1600</Pdo></Sm><Sm No="2"><Pdo OSFac="2">#x1601</Pdo></Sm>'
    described = pdo("RxPdo", "#x1600", 16) + pdo("RxPdo", "#x1601", 8)
    image = images(f"{described}<Dc>{op_mode(lists)}</Dc>")[2]
    assert (indices(image), image.bit_size) == ([0x1600, 0x1601], 32)
    assert image.remarks == ("the OpMode has several lists of PDOs for SM2: they are read as one",)


def test_a_full_sync_manager():
    image = images(pdo("RxPdo", "#x1600", 16, attributes='Sm="2" OSFac="32767"'))[2]
    assert (image.byte_size, image.overflow) == (65534, None)


def test_an_alignment_that_no_sync_manager_holds_is_left_out():
    group = GROUP.format('<ModulePdoGroup Alignment="65536" RxPdo="#x16FF">g</ModulePdoGroup>')
    text = device(SMS + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"') + group)
    info = read(esi(text.replace("<Type ", '<Type ModulePdoGroup="0" '))).document.infos[0]
    image = default_process_image(info.devices[0], ())[0]
    assert (indices(image), image.bit_size) == ([0x1600], 16)
    assert image.overflow is not None and "PDO 0x16FF" in image.overflow


@pytest.mark.parametrize(
    ("tx_pdo", "byte_size", "remark"),
    [
        ("TxPdo='#x1BF1'", 2, None),
        ("", 1, "ModulePdoGroup 'g' has no TxPdo to fill up with: it is not aligned to 2 bytes"),
        (
            "TxPdo='x'",
            None,
            "ModulePdoGroup 'g' has no TxPdo to fill up with ('x' is not a HexDecValue): it is not aligned to 2 bytes",
        ),
    ],
)
def test_a_group_is_filled_up_by_a_pdo_of_its_own_alone(tx_pdo, byte_size, remark):
    """8 bits each way in a group that is aligned to 2 bytes, for which both directions need a PDO (ESI-FACTS 12.1)."""
    pdos = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"') + pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"')
    group = GROUP.format(f"<ModulePdoGroup Alignment='2' RxPdo='#x17F1' {tx_pdo}>g</ModulePdoGroup>")
    text = device(SMS + pdos + group).replace("<Type ", '<Type ModulePdoGroup="0" ')
    outputs, inputs = default_process_image(read(esi(text)).document.infos[0].devices[0], ())
    assert (indices(outputs), outputs.byte_size, outputs.remarks) == ([0x1600, 0x17F1], 2, ())
    assert (inputs.byte_size, inputs.remarks) == (byte_size, (remark,) if remark is not None else ())


OF_VIRTUAL_SM4 = "is of the virtual SM4: no register of the ESC is programmed for it, an FMMU alone may map it"


def test_a_virtual_sync_manager_transports_nothing():
    virtual = SMS + '<Sm Virtual="1">Outputs</Sm>'
    content = pdo("RxPdo", "#x1600", 16, attributes='Sm="2"') + pdo("RxPdo", "#x1610", 32, attributes='Sm="4"')
    info = read(esi(device(virtual + content))).document.infos[0]
    found = {image.sm: image for image in default_process_image(info.devices[0], ())}
    assert (indices(found[2]), found[2].bit_size) == ([0x1600], 16)
    assert (indices(found[4]), found[4].bit_size) == ([], 0)
    assert found[4].remarks == (f"PDO 0x1610 {OF_VIRTUAL_SM4}; it is left out here",)
    assert [item.pdo.pdo_index for item in found[4].virtual] == [0x1610]


def test_the_order_of_entries_in_the_io_terminal(data):
    """data/io_terminal_8di_8do.xml: eight bits each way in SM0 and SM1, no mailbox."""
    first = read_esi(data / "io_terminal_8di_8do.xml").document.infos[0].devices[0]
    assert [(image.bit_size, image.byte_size) for image in default_process_image(first, ())] == [(8, 1), (8, 1)]


def modular(data):
    info = read_esi(data / "two_axis_modular_drive.xml").document.infos[0]
    return info.devices[0], info.modules


def test_default_modules_fill_the_slots(data):
    """data/two_axis_modular_drive.xml: two slots, four modules each, CSP (0x10800) preselected."""
    found, modules = modular(data)
    assert len(reachable_modules(found, modules)) == 4
    plugged = default_modules(found, modules)
    assert [(item.slot_number, item.module.module_ident) for item in plugged] == [(0, 0x10800), (1, 0x10800)]


def test_indices_shift_by_slot(data):
    """SlotPdoIncrement 64, SlotIndexIncrement #x800: slot 1 has 0x1740 for 0x1700, 0x6840 for 0x6040."""
    found, modules = modular(data)
    by_sm = {image.sm: image for image in default_process_image(found, modules)}
    assert indices(by_sm[2]) == [0x1700, 0x1740]
    outputs = [[e.entry.entry_index for e in placed.entries] for placed in by_sm[2].pdos]
    assert outputs == [[0x6040, 0x607A, 0x60B1, 0x60B2], [0x6840, 0x687A, 0x68B1, 0x68B2]]
    assert by_sm[2].bit_size == 2 * (16 + 32 + 32 + 16)


MODULE = (
    '<Module><Type ModuleIdent="1">M</Type><Name>M</Name><RxPdo Sm="2"><Index {0}>#x1602</Index><Name>R</Name>'
    "<Exclude {0}>#x17F0</Exclude><Entry><Index {0}>#x6060</Index><BitLen>8</BitLen></Entry></RxPdo></Module>"
)


def in_slots(slots: str, attributes: str, module: str = 'DependOnSlot="1"') -> list[tuple[int, int]]:
    """(PDO index, entry index) of the one module in every slot."""
    found = images(f"<Slots {attributes}>{slots}</Slots>", MODULE.format(module))
    return [(placed.pdo.pdo_index, placed.pdo.entries[0].entry_index) for placed in found[2].pdos]


def slot(attributes: str = "", instances: int = 1) -> str:
    ident = '<ModuleIdent Default="1">1</ModuleIdent>'
    return f'<Slot MinInstances="{instances}" MaxInstances="{instances}" {attributes}>{ident}</Slot>'


TWO_MODULES = "".join(f'<Module><Type ModuleIdent="{n}">M{n}</Type><Name>M</Name></Module>' for n in (1, 2))


def plugged_idents(*slots: str, marks: tuple[str, str] = ("0", "1")) -> list[tuple[int, int]]:
    """Slot number and ModuleIdent of the default modules; each slot takes modules 1 and 2, 1 may be marked Default."""
    content = "".join(
        f"<Slot {slot.removesuffix('marked')}><ModuleIdent Default='{marks[slot.endswith('marked')]}'>1</ModuleIdent>"
        "<ModuleIdent>2</ModuleIdent></Slot>"
        for slot in slots
    )
    info = read(esi(device(f"<Slots>{content}</Slots>"), TWO_MODULES)).document.infos[0]
    return [(item.slot_number, item.module.module_ident) for item in default_modules(info.devices[0], info.modules)]


ONE = 'MinInstances="1" MaxInstances="1"'
UP_TO_TWO = 'MinInstances="0" MaxInstances="2"'


@pytest.mark.parametrize(
    ("slot", "ident"),
    [
        (f'{ONE} Default="#x2"', 2),
        (f'{ONE} Fallback="#x2"', 2),
        (f'{ONE} Default="#x1" Fallback="#x2"', 1),
        (f'{ONE} Fallback="#x2" marked', 1),  # what is plugged leaves nothing to fall back to
        (f'{UP_TO_TWO} Fallback="#x2"', 2),
    ],
)
def test_a_slot_has_its_default_else_its_fallback(slot, ident):
    """Schema 1.17: Fallback is automatically plugged when no other module is plugged to the slot."""
    assert plugged_idents(slot) == [(0, ident)]


def test_a_module_is_preselected_by_a_boolean_too():
    """The schema has a HexDecValue."""
    assert plugged_idents(ONE, f"{ONE} marked", marks=("false", "true")) == [(1, 1)]


def test_without_default_and_fallback_a_slot_with_a_choice_stays_empty():
    assert plugged_idents(ONE, f'{ONE} Default="#x9"') == []


@pytest.mark.parametrize("slot", [f'{ONE} Default="#x9" Fallback="#x2"', f'{UP_TO_TWO} Default="#x9" Fallback="#x1"'])
def test_a_default_that_is_not_described_does_not_give_way_to_the_fallback(slot):
    """Module 9 is what the vendor plugs: the fallback is for a slot in which nothing is plugged."""
    assert plugged_idents(slot) == []


def test_a_slot_element_of_no_instances_is_no_slot():
    """MaxInstances 0: neither does it get a module, nor do the slots behind it move."""
    none = 'MinInstances="0" MaxInstances="0" marked'
    assert plugged_idents(none) == []
    assert plugged_idents(none, f'{ONE} Default="#x2"') == [(0, 2)]


def test_increments_of_the_device():
    steps = 'SlotIndexIncrement="#x800" SlotPdoIncrement="64"'
    assert in_slots(slot() * 3, steps) == [(0x1602, 0x6060), (0x1642, 0x6860), (0x1682, 0x7060)]
    assert in_slots(slot(instances=2) + slot(), steps) == [(0x1602, 0x6060), (0x1642, 0x6860), (0x1682, 0x7060)]


def test_increments_of_a_slot_win_even_when_they_are_zero():
    own = slot('SlotIndexIncrement="#x10" SlotPdoIncrement="1"')
    assert in_slots(slot() + own, 'SlotIndexIncrement="#x800"')[1] == (0x1603, 0x6070)
    assert in_slots(slot() + slot('SlotIndexIncrement="0"'), 'SlotIndexIncrement="#x800"')[1] == (0x1602, 0x6060)


def test_without_depend_on_slot_nothing_shifts():
    assert set(in_slots(slot() * 2, 'SlotIndexIncrement="#x800" SlotPdoIncrement="64"', "")) == {(0x1602, 0x6060)}


def test_slot_groups_shift_too():
    steps = 'SlotGroupIndexIncrement="#x100" SlotGroupPdoIncrement="8" SlotIndexIncrement="1"'
    both = slot('SlotGroup="1"') + slot('SlotGroup="2"')
    assert in_slots(both, steps, 'DependOnSlotGroup="1"') == [(0x160A, 0x6160), (0x1612, 0x6260)]
    assert in_slots(both, steps, 'DependOnSlotGroup="1" DependOnSlot="1"') == [(0x160A, 0x6160), (0x1612, 0x6261)]


def test_an_index_that_would_leave_16_bits_stays():
    assert in_slots(slot() * 2, 'SlotIndexIncrement="#xA000" SlotPdoIncrement="1"')[1] == (0x1603, 0x6060)


def test_module_classes_reach_modules():
    slot = '<Slots><Slot MinInstances="0" MaxInstances="4"><ModuleClass><Class>io</Class></ModuleClass></Slot></Slots>'
    modules = "".join(
        f'<Module><Type ModuleIdent="{n}" ModuleClass="{kind}">M</Type><Name>M</Name></Module>'
        for n, kind in enumerate(("io", "drive", "io"), 1)
    )
    info = read(esi(device(slot), modules)).document.infos[0]
    assert [m.module_ident for m in reachable_modules(info.devices[0], info.modules)] == [1, 3]
    assert default_modules(info.devices[0], info.modules) == []


def moved(own: str, listed: str):
    """Images of 0x1A00 (16 bit) with Sm=3 and 0x1A01 (32 bit), where SM4 is for inputs too."""
    sms = SMS + "<Sm>Inputs</Sm>"
    pdos = pdo("TxPdo", "#x1A00", 16, attributes=f'Sm="3" {own}') + pdo("TxPdo", "#x1A01", 32, attributes='Sm="3"')
    info = read(esi(device(f"{sms}{pdos}<Dc>{op_mode(listed)}</Dc>"))).document.infos[0]
    return {image.sm: image for image in default_process_image(info.devices[0], ())}


@pytest.mark.parametrize(
    ("own", "listed"),
    [
        ("", '<Sm No="4"><Pdo>#x1A00</Pdo></Sm>'),
        ('Mandatory="1"', '<Sm No="3"><Pdo>#x1A01</Pdo></Sm><Sm No="4"><Pdo>#x1A00</Pdo></Sm>'),
    ],
)
def test_a_pdo_goes_where_the_op_mode_lists_it_and_nowhere_else(own, listed):
    """ESI-FACTS section 0.5: the lists of the default OpMode win over Sm."""
    found = moved(own, listed)
    assert (indices(found[3]), found[3].byte_size) == ([0x1A01], 4)
    assert (indices(found[4]), found[4].byte_size) == ([0x1A00], 2)
    assert found[3].remarks == found[4].remarks == ()


def test_a_list_that_no_sync_manager_can_have_moves_nothing():
    found = moved("", '<Sm No="2"><Pdo>#x1A00</Pdo></Sm>')
    assert (indices(found[2]), indices(found[3])) == ([], [0x1A00, 0x1A01])


def test_an_assignment_takes_a_pdo_from_the_list_of_the_op_mode():
    listed = op_mode('<Sm No="4"><Pdo>#x1A00</Pdo></Sm>')
    content = pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"') + f"<Dc>{listed}</Dc>"
    owner = read(esi(device(f"{SMS}<Sm>Inputs</Sm>{content}"))).document.infos[0].devices[0]
    found = process_image(owner, (), owner.op_modes[0], {3: [0x1A00]})
    assert {image.sm: indices(image) for image in found} == {2: [], 3: [0x1A00], 4: []}


def test_what_a_virtual_sync_manager_has_excludes_nothing_of_others():
    virtual = SMS + '<Sm Virtual="1">Outputs</Sm>'
    content = pdo("RxPdo", "#x1600", 48, attributes='Sm="2"', extra="<Exclude>#x1601</Exclude>") + pdo(
        "RxPdo", "#x1601", 32, attributes='Sm="4" Mandatory="1"', extra="<Exclude>#x1600</Exclude>"
    )
    info = read(esi(device(virtual + content))).document.infos[0]
    found = {image.sm: image for image in default_process_image(info.devices[0], ())}
    assert (indices(found[2]), found[2].byte_size, found[2].remarks) == ([0x1600], 6, ())
    assert found[4].remarks == (f"PDO 0x1601 {OF_VIRTUAL_SM4}; it is left out here",)


GAP = "<Entry><Index>0</Index><BitLen>0</BitLen></Entry>"
EMPTY = '<RxPdo Sm="2"><Index>{}</Index><Name>R</Name></RxPdo>'


def test_nothing_is_known_of_what_lies_behind_a_pdo_without_entries():
    """ESI-FACTS section 9: a PDO without Entry has variable content. 12 bits lie before it, 8 somewhere behind."""
    first, last = (pdo("RxPdo", index, bits, attributes='Sm="2"') for index, bits in (("#x1600", 12), ("#x1602", 8)))
    found = images(first + EMPTY.format("#x1601") + last + EMPTY.format("#x1603"))
    image = found[2]
    assert [[entry.bit_offset for entry in placed.entries] for placed in image.pdos] == [[0], [], [None], []]
    assert (image.byte_size, image.bit_size, image.byte_words) == (None, 20, "at least 3 bytes")
    assert image.remarks == (
        "PDO 0x1601, 0x1603 of SM2 have no described entries: how long they are and where the entries behind them lie "
        "is not known",
    )
    assert found[3].byte_size == 0


def test_nothing_is_known_of_what_lies_behind_an_entry_without_length():
    entry = "<Entry><Index>#x6040</Index>{}</Entry>"
    content = entry.format("") + entry.format("<BitLen>32</BitLen>")
    image = images(f'<RxPdo Sm="2"><Index>#x1600</Index><Name>R</Name>{content}</RxPdo>')[2]
    assert [placed.bit_offset for placed in image.pdos[0].entries] == [0, None]
    assert (image.byte_size, image.byte_words) == (None, "at least 4 bytes")
    assert image.remarks[0].startswith("PDO 0x1600 of SM2 has entries without a usable BitLen: how long it is")


def test_a_ref_names_entries_that_are_described_elsewhere():
    image = images('<RxPdo Ref="R" Fixed="1" Sm="2"/>' + pdo("RxPdo", "#x1601", 16, attributes='Sm="2"'))[2]
    assert (image.pdos[1].entries[0].bit_offset, image.byte_size) == (None, None)


@pytest.mark.parametrize(
    "none",
    [
        EMPTY.format("#x1600").replace("</RxPdo>", f"{GAP}</RxPdo>"),
        EMPTY.format("#x1600").replace("<RxPdo", '<RxPdo Fixed="1"'),
    ],
)
def test_a_pdo_of_no_bits_has_a_known_length(none):
    """Fixed is a list of entries that nobody may change: without entries it stays empty (EL1252, "Reserved")."""
    image = images(none + pdo("RxPdo", "#x1601", 16, attributes='Sm="2"'))[2]
    assert image.pdos[1].entries[0].bit_offset == 0
    assert image.byte_size == 2


def test_no_place_is_known_behind_what_no_sync_manager_holds():
    content = pdo("RxPdo", "#x1600", 16, attributes='Sm="2" OSFac="32768"')
    image = images(content + pdo("RxPdo", "#x1601", 8, attributes='Sm="2"'))[2]
    assert (image.pdos[0].entries[0].bit_offset, image.byte_size) == (None, None)


@pytest.mark.parametrize(
    ("sm", "size"),
    [
        ('<Sm DefaultSize="16">Outputs</Sm>', None),
        ('<Sm DefaultSize="0">Outputs</Sm>', 0),
        ('<Sm DefaultSize="16" Virtual="1">Outputs</Sm>', 0),
    ],
)
def test_a_sync_manager_with_a_size_and_no_pdo_exchanges_what_nothing_describes(sm, size):
    """ESI-FACTS section 18: without PDOs nothing is exchanged, unless there is a DefaultSize."""
    owner = read(esi(device(sm))).document.infos[0].devices[0]
    (image,) = default_process_image(owner, ())
    words = "SM0 has DefaultSize 16 and no PDO: what it exchanges is not described"
    assert (image.byte_size, image.remarks) == (size, (words,) if size is None else ())
    (image,) = process_image(owner, (), None, {0: []})
    assert (image.byte_size, image.remarks) == (0, ()), "whoever assigns nothing knows it"


@pytest.mark.parametrize(("size", "words"), [(2, "DefaultSize 2 and no PDO"), (0, None)])
def test_a_virtual_pdo_without_entries_describes_nothing_of_what_is_exchanged(size, words):
    """EL6690: the variables of a bridge are the project's; DefaultSize says that there are some."""
    virtual = '<RxPdo Mandatory="1" Virtual="1" Sm="0"><Index>#x1600</Index><Name>Outputs</Name></RxPdo>'
    image = images(virtual, sms=f'<Sm DefaultSize="{size}">Outputs</Sm>')[0]
    assert (image.byte_size, image.left_open) == (0 if words is None else None, words)
    words = "is virtual: no mapping object transports it, an FMMU alone may; it is left out here"
    assert image.remarks[0] == f"PDO 0x1600 {words}"


UPLOADED = "SM{} has no PDO, PDOs are uploaded from the device (PdoUpload): what it exchanges is not described"


@pytest.mark.parametrize(("declared", "size"), [("1", None), ("true", None), ("0", 0)])
def test_what_is_uploaded_from_the_device_is_not_known_without_pdos(declared, size):
    """ESI-FACTS section 10: with PdoUpload a master asks the device for the PDOs, SyncManager by SyncManager."""
    coe = f'<Mailbox><CoE PdoUpload="{declared}"/></Mailbox>'
    found = images(coe)
    assert [(image.byte_size, image.remarks) for image in found.values()] == [
        (size, () if size == 0 else (UPLOADED.format(number),)) for number in (2, 3)
    ]
    described = images(coe + pdo("TxPdo", "#x1A00", 8, attributes='Sm="3"') + pdo("RxPdo", "#x1600", 8))
    assert [image.byte_size for image in described.values()] == [size, 1], "0x1600 is assigned to none"


@pytest.mark.parametrize(("pdos", "size"), [(pdo("TxPdo", "#x1A00", 8, attributes='Sm="1"'), 0), ("", None)])
def test_pdos_of_plugged_modules_are_what_all_sync_managers_exchange(pdos, size):
    """A coupler with a DefaultSize for outputs and inputs, and a module of inputs: the outputs are none."""
    slots = '<Slots><Slot MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot></Slots>'
    module = f'<Module><Type ModuleIdent="1">M</Type><Name>m</Name>{pdos}</Module>'
    content = '<Sm DefaultSize="2">Outputs</Sm><Sm DefaultSize="2">Inputs</Sm>' + slots
    (info,) = read(esi(device(content), module)).document.infos
    assert [image.byte_size for image in process_image(info.devices[0], (), None)] == [None, None]
    outputs, inputs = process_image(
        info.devices[0], [PluggedModule(0, info.devices[0].slots[0], info.modules[0])], None
    )
    assert (outputs.byte_size, outputs.remarks == ()) == (size, size is not None)
    assert inputs.byte_size == (1 if pdos else None)


def test_the_own_factor_counts_where_the_op_mode_lists_a_pdo_without_one():
    """docs/igh.md: as many samples as the OpMode lists for it, else those of its own OSFac."""
    sampled = pdo("TxPdo", "#x1A00", 16, attributes='Sm="3" OSFac="4" OSIndexInc="1"')
    listed = op_mode('<Sm No="3"><Pdo>#x1A00</Pdo></Sm>')
    image = images(f"{sampled}<Dc>{listed}</Dc>")[3]
    assert (image.pdos[0].repeat, image.byte_size) == (4, 8)
    assert image.remarks == (
        "PDO 0x1A00: the OpMode, which lists PDOs, says nothing about its oversampling; its own OSFac 4 counts, and "
        "SYNC0 has to fit it",
    )
