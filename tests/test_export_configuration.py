"""What is chosen and what follows: PDOs, entries, modules, OpModes, clocks, start-up commands, names."""

import re

import pytest
from snippets import device, dictionary, esi, mapping_objects, pdo, read

from esicatalog.errors import InputError, NotFound
from esicatalog.esi.reader import read_esi
from esicatalog.export.choice import Choice, PdoChoice, parse_pdo_choice
from esicatalog.export.clocks import Notation
from esicatalog.export.configuration import Configuration, configure
from esicatalog.export.headings import choice_lines
from esicatalog.export.init_cmds import single_accesses
from esicatalog.export.mode_commands import mode_remarks
from esicatalog.export.subject import Subject, choose_subject, subjects_of_document
from esicatalog.identity import Identity, ModuleChoice
from esicatalog.model.sm_facts import INPUT, OUTPUT

SMS = (
    '<Sm ControlByte="#x26">MBoxOut</Sm><Sm ControlByte="#x22">MBoxIn</Sm><Sm ControlByte="#x64">Outputs</Sm>'
    '<Sm ControlByte="#x20">Inputs</Sm>'
)
C = Notation("C", either="or", divide="/")
COE = '<Mailbox><CoE PdoAssign="1" PdoConfig="1"/></Mailbox>'


def subject(content: str, module_text: str = "") -> Subject:
    (found,) = subjects_of_document(read(esi(device(content), module_text)).document, "x.xml")
    return found


def configured(content: str, module_text: str = "", **choice) -> Configuration:
    return configure(subject(content, module_text), Choice(**choice))


def pdos(found: Configuration) -> dict[int, list[int]]:
    """PDO indices by SyncManager."""
    return {sm.number: [item.pdo_index for item in sm.pdos] for sm in found.sync_managers if sm.pdos}


def entry(index: str, bits: int, name: str = "", subindex: int = 0, data_type: str = "") -> str:
    kind = f"<DataType>{data_type}</DataType>" if data_type else ""
    named = f"<Name>{name}</Name>" if name else ""
    return f"<Entry><Index>{index}</Index><SubIndex>{subindex}</SubIndex><BitLen>{bits}</BitLen>{named}{kind}</Entry>"


def rx(index: str, *entries: str, attributes: str = 'Sm="2"', name: str = "R", extra: str = "") -> str:
    return f"<RxPdo {attributes}><Index>{index}</Index><Name>{name}</Name>{extra}{''.join(entries)}</RxPdo>"


PDOS = (
    pdo("RxPdo", "#x1600", 16, attributes='Sm="2"', extra="<Exclude>#x1601</Exclude>")
    + pdo("RxPdo", "#x1601", 8)
    + pdo("RxPdo", "#x1602", 32).replace("#x7000", "#x7002")
    + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"')
    + pdo("TxPdo", "#x1A01", 8, attributes='Virtual="1"')
    + pdo("TxPdo", "#x1A02", 8, extra="<ExcludedSm>3</ExcludedSm>")
)


@pytest.mark.parametrize(
    ("text", "chosen"),
    [
        ("0x1600", (PdoChoice(0x1600),)),
        ("#x1600, 6656", (PdoChoice(0x1600), PdoChoice(0x1A00))),
        ("0x1A00=0x6041+0x60FE:1", (PdoChoice(0x1A00, ((0x6041, 0), (0x60FE, 1))),)),
    ],
)
def test_pdos_as_people_write_them(text, chosen):
    assert parse_pdo_choice(text) == chosen


@pytest.mark.parametrize("text", ["", "0x1600,", "0x11600", "0x1600,0x1600", "0x1600=", "0x1600=0x6041+", "x"])
def test_pdos_that_cannot_be_read(text):
    with pytest.raises(InputError):
        parse_pdo_choice(text)


def test_without_a_choice_the_default_assignment_counts():
    assert pdos(configured(SMS + PDOS + COE)) == {2: [0x1600], 3: [0x1A00]}


def test_chosen_pdos_go_to_the_sync_manager_of_their_direction_and_others_keep_theirs():
    found = configured(SMS + PDOS + COE, pdos=parse_pdo_choice("0x1602,0x1601"))
    assert pdos(found) == {2: [0x1602, 0x1601], 3: [0x1A00]}
    assert [entry.bit_offset for sm in found.images(OUTPUT) for entry in sm.entries] == [0, 32]
    assert found.remarks == ()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0x1600,0x1601", "exclude each other"),
        ("0x1601,0x1600", "exclude each other"),
        ("0x1605", "is not described; the PDOs are 0x1600, 0x1601"),
        ("0x1A01", "is virtual"),
        ("0x1A02", "may not go to SM3"),
        ("0x1602=0x7000:9", "no dictionary declares it mappable"),
    ],
)
def test_pdos_that_the_device_does_not_allow(text, message):
    with pytest.raises(InputError, match=message) as raised:
        configured(SMS + PDOS + COE, pdos=parse_pdo_choice(text))
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize("length", ["", "<BitLen>-8</BitLen>", "<BitLen>32bit</BitLen>"])
def test_an_entry_without_a_length_is_refused_where_it_is_mapped(length):
    """Rule L33: BitLen is required; without it nothing tells where the entries behind it lie."""
    unknown = f"<Entry><Index>#x6064</Index><SubIndex>0</SubIndex>{length}</Entry>"
    content = SMS + rx("#x1600", entry("#x6041", 16), unknown, entry("#x6061", 8)) + COE
    with pytest.raises(InputError, match="PDO 0x1600 maps 0x6064:00 without a usable BitLen") as why:
        configured(content)
    assert "\n" not in str(why.value)
    (image,) = configured(content, pdos=parse_pdo_choice("0x1600=0x6041+0x6061")).images(OUTPUT)
    assert [item.bit_offset for item in image.entries] == [0, 16]
    assert configured(content.replace('Sm="2"', "")).images(OUTPUT) == ()


def test_a_pdo_without_described_entries_makes_unknown_what_lies_behind_it():
    """Nothing tells how long it is; what lies before it keeps its place."""
    content = SMS + rx("#x1600", entry("#x7000", 12)) + rx("#x1601") + rx("#x1602", entry("#x7001", 8))
    (sm,) = configured(content).images(OUTPUT)
    assert [(item.entry_index, item.is_placed) for item in sm.entries] == [(0x7000, True), (0x7001, False)]
    assert sm.placed_bit_size == 12
    found = configured(content)
    assert found.remarks == (
        "PDO 0x1601 of SM2 has no described entries: how long it is and where the entries behind it lie is not known",
    )
    assert list(choice_lines(found)) == ["SM2:      output of unknown length: 0x1600, 0x1601, 0x1602"]
    (several,) = configured(content + rx("#x1603")).remarks
    assert several.startswith("PDO 0x1601, 0x1603 of SM2 have no described entries: how long they are")


def test_a_gap_of_no_bits_moves_nothing_and_one_without_a_length_is_refused():
    def around(gap: str) -> str:
        return SMS + rx("#x1600", entry("#x6041", 16), f"<Entry><Index>0</Index>{gap}</Entry>", entry("#x6061", 8))

    (image,) = configured(around("<BitLen>0</BitLen>")).images(OUTPUT)
    assert [item.bit_offset for item in image.entries] == [0, 16]
    with pytest.raises(InputError, match="PDO 0x1600 maps a gap without a usable BitLen"):
        configured(around(""))


EMPTY = (
    SMS
    + rx(
        "#x1600",
        entry("#x7000", 16, "first", 1),
        entry("#x7000", 0, "none", 2),
        entry("#x7000", 0, "none", 3),
        entry("#x7000", 0, "last", 0x10),
        entry("#x7000", 8, "last", 0x11),
    )
    + COE
)
"""Entries of no bits as IO-Link modules have them: subindices of one area of data, which the first covers."""


def test_an_entry_of_no_bits_stands_in_the_mapping_and_has_no_value():
    found = configured(EMPTY)
    (image,) = found.images(OUTPUT)
    assert [(item.place, item.identifier, item.bit_offset) for item in image.entries] == [
        ("0x7000:01", "first", 0),
        ("0x7000:11", "last", 16),
    ]
    assert (image.bit_size, image.is_described, found.remarks) == (24, True, ())
    assert image.pdos[0].mapping.values == (0x7000_0110, 0x7000_0200, 0x7000_0300, 0x7000_1000, 0x7000_1108)


def test_a_mandatory_pdo_is_assigned_too_and_cannot_be_excluded():
    mandatory = pdo("RxPdo", "#x1600", 16, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1601</Exclude>")
    content = SMS + mandatory + pdo("RxPdo", "#x1601", 8) + pdo("RxPdo", "#x1602", 8) + COE
    found = configured(content, pdos=parse_pdo_choice("0x1602"))
    assert pdos(found) == {2: [0x1600, 0x1602]}
    assert any("0x1600 is mandatory" in remark for remark in found.remarks)
    with pytest.raises(InputError, match="0x1600 is mandatory"):
        configured(content, pdos=parse_pdo_choice("0x1601"))


def test_a_mandatory_pdo_that_is_itself_left_out_stands_in_no_way():
    """Of 0x1600 and 0x1601, which exclude each other, the first stays."""
    first = pdo("RxPdo", "#x1600", 16, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1601</Exclude>")
    second = pdo("RxPdo", "#x1601", 8, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1602</Exclude>")
    found = configured(SMS + first + second + pdo("RxPdo", "#x1602", 8) + COE, pdos=parse_pdo_choice("0x1602"))
    assert pdos(found) == {2: [0x1600, 0x1602]}


@pytest.mark.parametrize("chosen", [0x1600, 0x1601])
@pytest.mark.parametrize("listed", ["", '<Sm No="2"><Pdo>#x1601</Pdo></Sm>'])
def test_of_two_mandatory_pdos_that_exclude_each_other_the_chosen_one_is_assigned(chosen, listed):
    first = pdo("RxPdo", "#x1600", 16, attributes='Sm="2" Mandatory="1"', extra="<Exclude>#x1601</Exclude>")
    second = pdo("RxPdo", "#x1601", 8, attributes='Sm="2" Mandatory="1"')
    found = configured(SMS + first + second + COE + dc(("DC", listed)), pdos=parse_pdo_choice(f"{chosen:#x}"))
    assert pdos(found) == {2: [chosen]}


BOTH_WAYS = (
    pdo("RxPdo", "#x1600", 16, attributes='Sm="2"')
    + pdo("RxPdo", "#x1601", 16, extra="<Exclude>#x1A00</Exclude>")
    + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"')
    + pdo("TxPdo", "#x1A01", 16)
)


def test_a_chosen_pdo_cannot_exclude_the_default_of_another_sync_manager():
    with pytest.raises(InputError, match="0x1601 and PDO 0x1A00 exclude each other, and 0x1A00 is the default of SM3"):
        configured(SMS + BOTH_WAYS + COE, pdos=parse_pdo_choice("0x1601"))
    found = configured(SMS + BOTH_WAYS + COE, pdos=parse_pdo_choice("0x1601,0x1A01"))
    assert pdos(found) == {2: [0x1601], 3: [0x1A01]}


@pytest.mark.parametrize(
    ("other", "advice"),
    [
        (pdo("TxPdo", "#x1A01", 16), "; choose the PDOs of SM3 too, without it"),
        (pdo("TxPdo", "#x1A01", 16, extra="<Exclude>#x1601</Exclude>"), ", for which no other PDO can be chosen"),
        (pdo("TxPdo", "#x1A01", 16, extra="<ExcludedSm>3</ExcludedSm>"), ", for which no other PDO can be chosen"),
        ("", ", for which no other PDO can be chosen"),
    ],
)
def test_another_choice_is_advised_where_there_is_one(other, advice):
    described = BOTH_WAYS.replace(pdo("TxPdo", "#x1A01", 16), other)
    with pytest.raises(InputError) as refused:
        configured(SMS + described + COE, pdos=parse_pdo_choice("0x1601"))
    assert str(refused.value).endswith(f"0x1A00 is the default of SM3{advice}")


@pytest.mark.parametrize(
    ("attributes", "other", "coe", "advice"),
    [
        ("", pdo("RxPdo", "#x1601", 16), "<CoE/>", ", or choose other PDOs (--pdo)"),
        ("", "", "<CoE/>", ""),
        (' Mandatory="1"', pdo("RxPdo", "#x1601", 16), "<CoE/>", ""),
        (' Mandatory="1"', "", '<CoE PdoConfig="1"/>', ", or choose entries of it (--pdo)"),
        (' Mandatory="1" Fixed="1"', "", '<CoE PdoConfig="1"/>', ""),
        ("", pdo("RxPdo", "#x1601", 16), '<CoE PdoConfig="1"/>', ", or choose other PDOs or entries of it (--pdo)"),
    ],
)
def test_what_does_without_an_unusable_entry_is_advised(attributes, other, coe, advice):
    """Other PDOs where the PDO may be left out and there are some, other entries where a master may map them."""
    unusable = rx("#x1600", entry("#x7000", 16, subindex=1).replace("16", "x"), entry("#x7000", 8, subindex=2))
    content = SMS + unusable.replace('Sm="2"', f'Sm="2"{attributes}') + other + f"<Mailbox>{coe}</Mailbox>"
    with pytest.raises(InputError) as refused:
        configured(content)
    assert str(refused.value).endswith(f"nothing tells where the entries behind it lie; correct the file{advice}")
    if "other PDOs" in advice:
        assert pdos(configured(content, pdos=parse_pdo_choice("0x1601"))) == {2: [0x1601]}
    if "entries" in advice:
        assert pdos(configured(content, pdos=parse_pdo_choice("0x1600=0x7000:2"))) == {2: [0x1600]}


def test_the_list_of_the_op_mode_is_the_default_that_a_chosen_pdo_may_exclude():
    """With OpMode 0 SM3 has 0x1A01, which nothing excludes; with OpMode 1 0x1A00."""
    modes = dc(*((name, f'{times("0")}<Sm No="3"><Pdo>{index}</Pdo></Sm>') for name, index in LISTED_INPUTS))
    content = SMS + BOTH_WAYS + COE + modes
    assert pdos(configured(content, pdos=parse_pdo_choice("0x1601"))) == {2: [0x1601], 3: [0x1A01]}
    with pytest.raises(InputError, match="0x1A00 is the default of SM3"):
        configured(content, pdos=parse_pdo_choice("0x1601"), op_mode="1")


LISTED_INPUTS = (("a", "#x1A01"), ("b", "#x1A00"))


def test_a_chosen_pdo_is_sampled_as_often_as_sync0_comes():
    """Like EL4712: counter and samples; OSFac 20, in the OpModes 1 and 2, whose SYNC0 is the cycle and half of it."""
    content = (
        SMS
        + pdo("RxPdo", "#x1680", 16, attributes='Sm="2" Mandatory="1"')
        + pdo("RxPdo", "#x1600", 16, attributes='Sm="2" OSFac="20" OSIndexInc="16"')
        + dc(
            *(
                (f"DcSync{n}", f"{times('#x730', f'Factor={chr(34)}-{n}{chr(34)}>0')}{SAMPLED.format(n)}")
                for n in (1, 2)
            )
        )
    )
    for op_mode, samples, sync0_ns in (("0", 1, 1_000_000), ("1", 2, 500_000)):
        for chosen in ((), parse_pdo_choice("0x1680,0x1600")):
            found = configured(content, op_mode=op_mode, pdos=chosen)
            (outputs,) = found.images(OUTPUT)
            assert outputs.byte_size == 2 + 2 * samples
            assert found.clocks.sync0_cycle.in_ns(1_000_000) == sync0_ns


SAMPLED = '<Sm No="2"><Pdo>#x1680</Pdo><Pdo OSFac="{}">#x1600</Pdo></Sm>'


def test_samples_are_named_and_typed_by_the_first_of_them():
    """Index step 0x24 leads from 0x6040 to 0x6064, which CiA 402 has for another value."""
    profile = dictionary(
        "<DataType><Name>INT</Name><BitSize>16</BitSize></DataType>",
        "<Object><Index>#x6040</Index><Name>Set</Name><Type>INT</Type><BitSize>16</BitSize></Object>",
    )
    samples = 'Sm="2" OSFac="2" OSIndexInc="36"'
    found = configured(profile + SMS + rx("#x1600", entry("#x6040", 16), attributes=samples, name="Fast"))
    (outputs,) = found.images(OUTPUT)
    assert [(item.place, item.identifier, item.value.kind) for item in outputs.entries] == [
        ("0x6040:00", "controlword_6040_00", "int"),
        ("0x6064:00", "controlword_6064_00", "int"),
    ]


def test_samples_that_are_pdos_of_their_own_are_assigned_each():
    """Two channels of two samples, which the document has at 0x7000:01 and the device at 0x6001 and 0x6011."""
    channels = (("#x1A01", "Fast"), ("#x1A41", "Slow"))
    mapped = ((0x1A01, "10010160"), (0x1A02, "10020160"), (0x1A41, "10011160"), (0x1A42, "10021160"))
    content = (
        mapping_objects(*mapped)
        + SMS
        + "".join(
            rx(index, entry("#x7000", 16, "Value", 1, "INT"), attributes='Sm="3" OSFac="2"', name=name)
            for index, name in channels
        ).replace("RxPdo", "TxPdo")
        + '<Mailbox><CoE PdoAssign="1"/></Mailbox>'
    )
    found = configured(content)
    assert pdos(found) == {3: [0x1A01, 0x1A02, 0x1A41, 0x1A42]}
    (inputs,) = found.images(INPUT)
    assert [(item.place, item.identifier, item.value.kind) for item in inputs.entries] == [
        ("0x6001:01", "value_6001_01", "int"),
        ("0x6001:02", "value_6001_02", "int"),
        ("0x6011:01", "value_6011_01", "int"),
        ("0x6011:02", "value_6011_02", "int"),
    ]
    assert (inputs.assignment.values, found.rewritten) == ((0x1A01, 0x1A02, 0x1A41, 0x1A42), {0x1C13})
    assert found.remarks == ()
    for chosen in ("0x1A41", "0x1A41,0x1A42"):
        assert pdos(configured(content, pdos=parse_pdo_choice(chosen))) == {3: [0x1A41, 0x1A42]}
    with pytest.raises(InputError, match="PDO 0x1A42 is not described"):
        configured(content, pdos=parse_pdo_choice("0x1A42"))
    with pytest.raises(InputError, match="PDO 0x1A43 is not described"):
        configured(content, pdos=parse_pdo_choice("0x1A41,0x1A43"))


def test_samples_of_an_output_are_no_copies_in_pdos_of_their_own():
    """Without OSIndexInc and with a mapping that the master writes, both are 0x7000:01."""
    sampled = rx("#x1600", entry("#x7000", 16, "Value", 1), attributes='Sm="2" OSFac="2"')
    found = configured(mapping_objects((0x1600, "10010070"), (0x1601, "10020070")) + SMS + sampled + COE)
    assert (pdos(found), found.copy_remarks) == ({2: [0x1600, 0x1601]}, ())


OF_VIRTUAL_SM4 = "is of the virtual SM4: no register of the ESC is programmed for it, an FMMU alone may map it"


def test_a_virtual_sync_manager_is_not_configured():
    content = (
        SMS
        + '<Sm ControlByte="#x64" Virtual="1">Outputs</Sm>'
        + pdo("RxPdo", "#x1600", 16, attributes='Sm="2"')
        + pdo("RxPdo", "#x1610", 32, attributes='Sm="4"')
    )
    for found in (configured(content), configured(content + COE)):
        assert [sm.number for sm in found.sync_managers] == [0, 1, 2, 3]
        assert found.remarks == (f"PDO 0x1610 {OF_VIRTUAL_SM4}; it is left out here",)
    with pytest.raises(InputError, match=f"PDO 0x1610 {OF_VIRTUAL_SM4}"):
        configured(content + COE, pdos=parse_pdo_choice("0x1610"))


@pytest.mark.parametrize("mailbox", ["", "<Mailbox><FoE/></Mailbox>"])
def test_what_is_virtual_can_be_chosen_where_nothing_is_told_to_the_device(mailbox):
    """EL1252: latch registers at a virtual SyncManager, which IgH maps by an FMMU and does not enable."""
    content = (
        '<Sm ControlByte="#x20">Inputs</Sm><Sm StartAddress="#x09AE" Virtual="1">Inputs</Sm>'
        + pdo("TxPdo", "#x1A00", 8, attributes='Sm="0" Mandatory="1"')
        + pdo("TxPdo", "#x1A13", 272, attributes='Sm="1" Virtual="1"')
        + pdo("TxPdo", "#x1A14", 32, attributes='Sm="1"')
        + pdo("TxPdo", "#x1A16", 272, attributes='Virtual="1"')
        + mailbox
    )
    found = configured(content, pdos=parse_pdo_choice("0x1A13,0x1A14"))
    assert pdos(found) == {0: [0x1A00], 1: [0x1A13, 0x1A14]}
    assert found.remarks == (
        "PDO 0x1A13 is virtual: no mapping object transports it, an FMMU alone may; it is chosen all the same",
        f"PDO 0x1A14 {OF_VIRTUAL_SM4.replace('SM4', 'SM1')}; it is chosen all the same",
    )
    with pytest.raises(InputError, match="PDO 0x1A16 is virtual and names no SyncManager"):
        configured(content, pdos=parse_pdo_choice("0x1A16"))


def test_a_pdo_without_sync_manager_does_not_go_to_a_virtual_one():
    with pytest.raises(InputError, match="has none for a RxPdo"):
        configured('<Sm Virtual="1">Outputs</Sm>' + pdo("RxPdo", "#x1600", 16), pdos=parse_pdo_choice("0x1600"))


def test_what_no_sync_manager_holds_is_not_exported_in_part():
    with pytest.raises(InputError, match="SM2: PDO 0x1601 of 800000 bits is left out"):
        configured(
            SMS
            + pdo("RxPdo", "#x1600", 8, attributes='Sm="2"')
            + pdo("RxPdo", "#x1601", 16, attributes='Sm="2" OSFac="50000"')
        )


def test_a_device_that_does_not_declare_pdo_assign_is_named():
    content = SMS + PDOS
    assert configured(content, pdos=parse_pdo_choice("0x1600")).remarks == ()
    (remark,) = configured(content, pdos=parse_pdo_choice("0x1602")).remarks
    assert remark.startswith("the PDOs of SM2 are not the default ones, and the device does not declare PdoAssign")


def test_chosen_entries_come_in_their_order():
    found = configured(
        SMS + pdo("RxPdo", "#x1600", 8, 16, 32, attributes='Sm="2"') + COE,
        pdos=[PdoChoice(0x1600, ((0x7000, 3), (0x7000, 1)))],
    )
    (image,) = found.images(OUTPUT)
    assert [(e.subindex, e.bit_length, e.bit_offset) for e in image.entries] == [(3, 32, 0), (1, 8, 32)]
    assert any("2 entries are chosen, 3 are described" in remark for remark in found.remarks)


def test_objects_that_the_dictionary_lets_in_can_be_chosen():
    mappable = "<Flags><PdoMapping>T</PdoMapping></Flags>"
    objects = "".join(
        f"<Object><Index>{index}</Index><Name>{name}</Name><Type>DINT</Type><BitSize>32</BitSize>{flags}</Object>"
        for index, name, flags in (("#x606C", "Velocity actual value", mappable), ("#x6081", "Profile velocity", ""))
    )
    profile = dictionary("<DataType><Name>DINT</Name><BitSize>32</BitSize></DataType>", objects)
    content = profile + SMS + pdo("TxPdo", "#x1A00", 16, attributes='Sm="3"') + COE
    found = configured(content, pdos=parse_pdo_choice("0x1A00=0x7000:1+0x606C"))
    (image,) = found.images(INPUT)
    velocity = list(image.entries)[1]
    assert (velocity.identifier, velocity.bit_offset, velocity.value.kind) == ("velocity_actual_value", 16, "int")
    for refused in ("0x1A00=0x6081", "0x1A00=0x607A"):
        with pytest.raises(InputError, match="no dictionary declares it mappable"):
            configured(content, pdos=parse_pdo_choice(refused))


@pytest.mark.parametrize(
    ("attributes", "mailbox", "message"),
    [('Sm="2" Fixed="1"', COE, "is Fixed"), ('Sm="2"', "", "does not declare PdoConfig")],
)
def test_entries_of_a_pdo_that_cannot_be_changed(attributes, mailbox, message):
    with pytest.raises(InputError, match=message):
        configured(
            SMS + pdo("RxPdo", "#x1600", 8, 16, attributes=attributes) + mailbox,
            pdos=parse_pdo_choice("0x1600=0x7000:2"),
        )


def modular(data) -> Subject:
    (found,) = subjects_of_document(
        read_esi(data / "two_axis_modular_drive.xml").document, "two_axis_modular_drive.xml"
    )
    return found


def test_modules_are_plugged_and_their_axes_named(data):
    """data/two_axis_modular_drive.xml: CSV (0x10900) in slot 1 writes 0x6860 = 9 at PS."""
    found = configure(modular(data), Choice(modules={1: ModuleChoice(0x10900)}))
    names = [entry.identifier for sm in found.images(OUTPUT) for entry in sm.entries]
    assert names[0] == "controlword"
    assert "controlword_axis1" in names
    assert "target_velocity_axis1" in names
    assert found.axes == (0, 1)
    written = {(c.object_index, c.subindex): c.data for c in found.commands}
    assert written[(0x6060, 0)] == b"\x08"
    assert written[(0x6860, 0)] == b"\x09"
    assert written[(0xF030, 0)] == b"\x02\0" + (0x10800).to_bytes(4, "little") + (0x10900).to_bytes(4, "little")


def test_a_module_that_does_not_fit(data):
    with pytest.raises(InputError, match="does not fit slot 1"):
        configure(modular(data), Choice(modules={1: ModuleChoice(0x1)}))


def test_cia402_names_need_evidence():
    word = entry("#x6040", 16, "Channel 5", data_type="UINT")
    drive = configured(SMS + rx("#x1600", word))
    assert [e.identifier for sm in drive.images(OUTPUT) for e in sm.entries] == ["controlword"]
    assert drive.is_drive
    terminal = configured(SMS + rx("#x1600", entry("#x6040", 1, "Channel 5", 1)))
    assert [e.identifier for sm in terminal.images(OUTPUT) for e in sm.entries] == ["channel_5"]
    assert not terminal.is_drive


def test_names_come_from_entry_pdo_dictionary_and_place():
    objects = "<Object><Index>#x2000</Index><Name>Ramp</Name><Type>UINT</Type><BitSize>16</BitSize></Object>"
    profile = dictionary("<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>", objects).replace("402", "5001")
    content = (
        profile
        + SMS
        + rx("#x1600", entry("#x7000", 1, "Output", 1), entry("#x2000", 16), entry("#x3000", 8), name="Channel 1")
        + rx("#x1601", entry("#x7010", 1, "Output", 1), name="Channel 2")
    )
    names = [e.identifier for sm in configured(content).images(OUTPUT) for e in sm.entries]
    assert names == ["channel_1_output", "ramp", "entry_3000_00", "channel_2_output"]


ONE_SLOT = '<Slots><Slot MinInstances="1" MaxInstances="1"><ModuleIdent Default="1">1</ModuleIdent></Slot></Slots>'


def declared(index: str, kind: str, bits: int, attributes: str = "") -> str:
    return (
        f"<Object><Index {attributes}>{index}</Index><Name>{kind} {index}</Name><Type>{kind}</Type>"
        f"<BitSize>{bits}</BitSize><Flags><PdoMapping>R</PdoMapping></Flags></Object>"
    )


def module(*content: str) -> str:
    return f"<Module><Type ModuleIdent='1'>M</Type><Name>M</Name>{''.join(content)}</Module>"


def test_an_object_marked_overwritten_by_module_yields_to_the_module():
    """Unmarked ones do not: of two objects with one index the device's counts (ESI-FACTS section 12)."""
    marked = 'OverwrittenByModule="1"'
    own = declared("#x207A", "UDINT", 32, marked) + declared("#x20FF", "UINT", 16, marked)
    own += declared("#x2000", "UINT", 16) + declared("#x2001", "UINT", 16, marked)
    of_module = declared("#x207A", "DINT", 32) + declared("#x20FF", "DINT", 32) + declared("#x2000", "DINT", 32)
    found = configured(
        dictionary("", own) + SMS + COE + ONE_SLOT,
        module(rx("#x1600", entry("#x207A", 32, "t")), dictionary("", of_module)),
        pdos=parse_pdo_choice("0x1600=0x207A+0x20FF+0x2000+0x2001"),
    )
    (image,) = found.images(OUTPUT)
    assert [(e.entry_index, e.bit_length, e.value.kind) for e in image.entries] == [
        (0x207A, 32, "int"),
        (0x20FF, 32, "int"),
        (0x2000, 16, "uint"),
        (0x2001, 16, "uint"),
    ]


@pytest.mark.parametrize(
    ("mark", "bits", "outcome"),
    [
        (
            'OverwrittenByModule="1"',
            16,
            "PDO 0x1600 is that of module 0x1 in slot 0: the device's own yields to it (OverwrittenByModule)",
        ),
        ("", 8, None),
        ("", 16, "PDO 0x1600 is ambiguous: the device and module 0x1 in slot 0 describe it in different ways"),
    ],
)
def test_a_pdo_that_device_and_module_describe(mark, bits, outcome):
    own = pdo("RxPdo", "#x1600", 8, attributes=f'Sm="2" {mark}')
    of_module = module(pdo("RxPdo", "#x1600", bits, attributes='Sm="2"'))
    try:
        found = configured(SMS + COE + own + ONE_SLOT, of_module, pdos=parse_pdo_choice("0x1600"))
    except InputError as refused:
        assert (str(refused), mark) == (outcome, "")
        return
    assert found.images(OUTPUT)[0].bit_size == bits
    assert [remark for remark in found.remarks if "PDO 0x1600" in remark] == [outcome] * (outcome is not None)


def test_a_pdo_described_again_with_padding_of_another_subindex_is_the_same():
    own, of_module = (rx("#x1600", entry("#x7000", 8), entry("#x0", 8, subindex=number)) for number in (0, 1))
    found = configured(SMS + COE + own + ONE_SLOT, module(of_module), pdos=parse_pdo_choice("0x1600"))
    assert pdos(found) == {2: [0x1600]}


def test_a_type_name_means_the_type_of_its_own_dictionary():
    def named(base: str) -> str:
        return f"<DataType><Name>DT_MODE</Name><BaseType>{base}</BaseType><BitSize>8</BitSize></DataType>"

    def mode(index: str) -> str:
        return rx(index, entry("#x2060", 8, "mode", data_type="DT_MODE"))

    found = configured(
        dictionary(named("USINT"), "") + SMS + mode("#x1600") + ONE_SLOT,
        module(mode("#x1601"), dictionary(named("SINT"), "")),
    )
    assert [e.value.kind for sm in found.images(OUTPUT) for e in sm.entries] == ["uint", "int"]


@pytest.mark.parametrize(
    ("data_type", "bits", "kind", "container"),
    [
        ("UINT", 16, "uint", 16),
        ("INT", 16, "int", 16),
        ("INT", 12, "int", 16),
        ("REAL", 32, "real", 32),
        ("REAL", 16, "uint", 16),
        ("LREAL", 64, "real", 64),
        ("BOOL", 1, "uint", 8),
        ("STRING(4)", 32, "bytes", 0),
        ("ARRAY [0..30] OF BYTE", 248, "bytes", 0),
        ("", 24, "uint", 32),
        ("UDINT", 72, "bytes", 0),
    ],
)
def test_types_of_values(data_type, bits, kind, container):
    found = configured(SMS + rx("#x1600", entry("#x7000", bits, "v", data_type=data_type)))
    ((value,),) = ([e.value for e in sm.entries] for sm in found.images(OUTPUT))
    assert (value.kind, value.bit_length, value.container_bits) == (kind, bits, container)


def test_bytes_that_the_master_should_swap_are_told():
    swapped = entry("#x7000", 16, "v", 1, "INT").replace("<DataType>", '<DataType SwapData="Swap_HB_LB">')
    (remark,) = configured(SMS + rx("#x1600", swapped, entry("#x7000", 16, "w", 2))).remarks
    assert remark.startswith("0x7000:01 v asks the master to swap its bytes (Swap_HB_LB)")


def dc(*modes: tuple[str, str]) -> str:
    return "<Dc>" + "".join(f"<OpMode><Name>{name}</Name>{times}</OpMode>" for name, times in modes) + "</Dc>"


def times(activate: str, sync0: str = "", sync1: str = "", shift0: str = "", shift1: str = "") -> str:
    parts = [f"<AssignActivate>{activate}</AssignActivate>"]
    parts += [f"<CycleTimeSync0 {sync0}</CycleTimeSync0>"] if sync0 else []
    parts += [f"<ShiftTimeSync0>{shift0}</ShiftTimeSync0>"] if shift0 else []
    parts += [f"<CycleTimeSync1 {sync1}</CycleTimeSync1>"] if sync1 else []
    parts += [f"<ShiftTimeSync1>{shift1}</ShiftTimeSync1>"] if shift1 else []
    return "".join(parts)


@pytest.mark.parametrize("exclude", ["<Exclude>#x1601</Exclude>", ""])
def test_a_pdo_whose_list_is_replaced_does_not_go_back_to_its_own_sync_manager(exclude):
    """The OpMode moves 0x1600 from SM2 to SM4; what is chosen for SM4 takes the place of that."""
    moved = pdo("RxPdo", "#x1600", 8, attributes='Sm="2"', extra=exclude)
    other = pdo("RxPdo", "#x1601", 8, attributes='Sm="4"')
    mode = "<AssignActivate>0</AssignActivate><Sm No='4'><Pdo>#x1600</Pdo></Sm>"
    content = SMS + '<Sm ControlByte="#x64">Outputs</Sm>' + moved + other + COE + dc(("m", mode))
    assert pdos(configured(content)) == {4: [0x1600]}
    assert pdos(configured(content, pdos=parse_pdo_choice("0x1601"))) == {4: [0x1601]}


def test_a_pdo_of_a_sync_manager_below_zero_is_refused():
    with pytest.raises(InputError, match="assigned to SM-1, which cannot be"):
        configured(pdo("RxPdo", "#x1600", 8, attributes='Sm="-1"'))


FACTOR_1 = 'Factor="1">0'


@pytest.mark.parametrize(
    ("mode", "cycle_ns", "sync0_ns", "delay_ns"),
    [
        (times("#x300", FACTOR_1), 1_000_000, 1_000_000, 0),
        (times("#x300", 'Factor="2">0'), 1_000_000, 2_000_000, 0),
        (times("#x300", ">250000"), 1_000_000, 250_000, 0),
        (times("#x300"), 500_000, 500_000, 0),
        # Register 0x09A4 = SYNC1 period - SYNC0 period + ShiftTimeSync1.
        (times("#x700", FACTOR_1, FACTOR_1, shift1="20000"), 1_000_000, 1_000_000, 20_000),
        (times("#x700", FACTOR_1, 'Factor="2">0'), 1_000_000, 1_000_000, 1_000_000),
        (times("#x730", 'Factor="-8">0', 'Factor="-1">0'), 1_000_000, 125_000, 875_000),
        (times("#x700", ">100000", ">300000", shift1="5"), 1_000_000, 100_000, 200_005),
        (times("#x700", FACTOR_1, FACTOR_1, shift1="-1000"), 1_000_000, 1_000_000, 999_000),
        # The bits decide, not the times: SYNC1 needs 0x0400.
        (times("#x300", FACTOR_1, 'Factor="2">0', shift1="20000"), 1_000_000, 1_000_000, 0),
        (times("#x630", FACTOR_1, FACTOR_1), 1_000_000, 0, 0),
        (times("#x100", FACTOR_1), 1_000_000, 1_000_000, 0),
    ],
)
def test_times_of_the_signals(mode, cycle_ns, sync0_ns, delay_ns):
    found = configured(SMS + dc(("m", mode)), cycle_ns=cycle_ns).clocks
    assert found is not None
    assert found.sync0_cycle.in_ns(cycle_ns) == sync0_ns
    assert found.sync1_delay.in_ns(cycle_ns) == delay_ns


def test_without_assign_activate_there_are_no_clocks():
    assert configured(SMS + dc(("free", times("0", FACTOR_1)))).clocks is None
    assert configured(SMS).clocks is None


def test_a_device_that_uses_the_time_only_gets_no_sync_signals():
    """Dc/@TimeLoopControlOnly: a master writes none of 0x0940 to 0x09FF, AssignActivate (0x0980) among them."""
    modes = dc(("FreeRun", times("0")), ("DC", times("#x320"))).replace("<Dc>", '<Dc TimeLoopControlOnly="1">')
    found = configured(SMS + modes, op_mode="DC")
    assert found.clocks is None
    (remark,) = found.remarks
    assert "TimeLoopControlOnly" in remark
    assert "AssignActivate 0x0320 of the OpMode is left out" in remark
    assert next(choice_lines(found)) == "OpMode:   1 'DC': DC time only"
    free = configured(SMS + modes)
    assert (free.clocks, free.remarks) == (None, ())
    assert next(choice_lines(free)) == "OpMode:   0 'FreeRun': no distributed clocks"


@pytest.mark.parametrize(
    ("sync1", "shift1", "count"),
    [('Factor="0">0', "", 1), ("", "", 1), ("", "0", 0), ('Factor="1">0', "", 0), (">1000000", "", 0)],
)
def test_a_sync1_without_any_time_is_told(sync1, shift1, count):
    found = configured(SMS + dc(("DC", times("#x700", FACTOR_1, sync1, shift1=shift1))))
    assert found.clocks.sync1_delay.in_ns(1_000_000) == 0
    said = "neither CycleTimeSync1 nor ShiftTimeSync1 gives a time: SYNC1 comes at the start of each SYNC0 cycle"
    assert found.remarks.count(said) == count


@pytest.mark.parametrize("activate", ["#x10300", "-256"])
def test_an_assign_activate_that_does_not_fit_its_registers_is_refused(activate):
    with pytest.raises(InputError, match=r"'DC' has AssignActivate -?0x\w+, which does not fit the registers"):
        configured(SMS + dc(("DC", times(activate, FACTOR_1))))


def test_a_control_byte_of_more_than_8_bits_is_told():
    (remark,) = configured(SMS.replace('ControlByte="#x64"', 'ControlByte="#x164"')).remarks
    assert remark == "SM2 has the ControlByte 0x164, which does not fit its register of 8 bits"


def test_a_cycle_that_cannot_be_divided_is_refused():
    content = SMS + dc(("os", times("#x730", 'Factor="-3">0', 'Factor="-1">0')))
    with pytest.raises(InputError, match="divides the bus cycle by 3; 1000000 ns is no multiple"):
        configured(content)
    assert configured(content, cycle_ns=3_000_000).clocks.sync0_cycle.in_ns(3_000_000) == 1_000_000


@pytest.mark.parametrize(
    ("cycle_ns", "remark"),
    [
        (250_000, None),
        (1_000_000, "a bus cycle of 1000000 ns holds 4 of it"),
        (125_000, "it takes 2 bus cycles of 125000 ns"),
    ],
)
def test_a_fixed_cycle_of_sync0_other_than_the_bus_cycle_is_told(cycle_ns, remark):
    found = configured(SMS + dc(("m", times("#x300", ">250000"))), cycle_ns=cycle_ns)
    assert found.clocks is not None
    assert found.clocks.sync0_cycle.in_ns(cycle_ns) == 250_000
    assert found.remarks == ((f"the OpMode fixes the SYNC0 cycle at 250000 ns: {remark}",) if remark else ())


@pytest.mark.parametrize(("cycle_ns", "is_told"), [(None, True), (1_999_999, True), (2_000_000, False)])
def test_a_bus_cycle_that_is_shorter_than_the_device_can_is_told(cycle_ns, is_told):
    """0x1C32:05 is 2 ms (0x001E8480)."""
    types = (
        "<DataType><Name>DT1C32</Name><BitSize>48</BitSize><SubItem><SubIdx>0</SubIdx><Name>n</Name>"
        "<Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem><SubItem><SubIdx>5</SubIdx>"
        "<Name>Minimum cycle time</Name><Type>UDINT</Type><BitSize>32</BitSize><BitOffs>16</BitOffs></SubItem>"
        "</DataType>"
    )
    values = "<SubItem><Name>Minimum cycle time</Name><Info><DefaultData>80841E00</DefaultData></Info></SubItem>"
    objects = (
        "<Object><Index>#x1C32</Index><Name>SM output parameter</Name><Type>DT1C32</Type><BitSize>48</BitSize>"
        f"<Info>{values}</Info></Object>"
    )
    found = configured(dictionary(types, objects) + SMS, cycle_ns=cycle_ns)
    told = [remark for remark in found.remarks if "smallest bus cycle" in remark]
    assert (
        told
        == [
            "the device describes 2000000 ns as its smallest bus cycle, this is made for "
            f"{cycle_ns or 1_000_000} ns: choose a longer one, or find out what this configuration of the device can do"
        ]
        * is_told
    )


def conditions(content: str, cycle_ns: int) -> list[str]:
    found = configured(content, cycle_ns=cycle_ns)
    assert found.clocks is not None
    return [condition.expression for condition in found.clocks.conditions(C, cycle_ns)]


@pytest.mark.parametrize(
    ("mode", "cycle_ns", "delay_ns", "made"),
    [
        # SYNC1 once in a bus cycle: until that is as long as the SYNC0 cycle, SYNC1 comes with SYNC0.
        (times("#x700", ">3000000", 'Factor="-1">0'), 1_000_000, 0, ["C <= 3000000"]),
        (times("#x700", ">3000000", 'Factor="-1">0'), 3_000_000, 0, ["C % 3000000 == 0"]),
        (times("#x700", ">3000000", 'Factor="-1">0'), 6_000_000, 3_000_000, ["C % 3000000 == 0"]),
        # With a shift the delay alone does not tell: at 1.5 ms it would be 0.5 ms, and is 2 ms.
        (times("#x700", ">3000000", 'Factor="-1">0', shift1="2000000"), 6_000_000, 5_000_000, ["C % 3000000 == 0"]),
        (times("#x700", ">3000000", 'Factor="-1">0', shift1="2000000"), 1_500_000, 2_000_000, ["C <= 3000000"]),
        # Both from the bus cycle or both fixed: one is longer at every bus cycle.
        (times("#x700", FACTOR_1, 'Factor="2">0'), 1_000_000, 1_000_000, []),
        (times("#x700", 'Factor="2">0', 'Factor="-1">0'), 1_000_000, 0, []),
        (times("#x700", ">1000000", 'Factor="2">0'), 1_000_000, 1_000_000, []),
        # The other way round: a fixed SYNC1 and SYNC0 once in a bus cycle.
        (times("#x700", FACTOR_1, ">3000000"), 1_000_000, 2_000_000, ["3000000 % C == 0"]),
        (times("#x700", FACTOR_1, ">3000000"), 4_000_000, 0, ["3000000 <= C"]),
    ],
)
def test_a_header_is_for_bus_cycles_at_which_sync1_is_longer_or_shorter_alike(mode, cycle_ns, delay_ns, made):
    content = SMS + dc(("m", mode))
    found = configured(content, cycle_ns=cycle_ns).clocks
    assert found is not None
    assert found.sync1_delay.in_ns(cycle_ns) == delay_ns
    assert [
        condition for condition in conditions(content, cycle_ns) if " or " not in condition and "-" not in condition
    ] == made


WITHIN, MOVED = 270_000, 20_000


@pytest.mark.parametrize(
    ("sync0", "sync1", "shift_ns", "cycle_ns", "delay_ns", "made"),
    [
        # The delay starts again with the first SYNC0 after it: one of 270 µs would make SYNC1 every 500 µs.
        (FACTOR_1, FACTOR_1, WITHIN, 1_000_000, WITHIN, ["(C - 270000) > 0"]),
        (FACTOR_1, FACTOR_1, WITHIN, 250_000, MOVED, ["(270000 - C) >= 0", "(C * 2 - 270000) > 0"]),
        (FACTOR_1, FACTOR_1, -30_000, 250_000, 220_000, ["(C - 30000) >= 0"]),
        # Every second SYNC0: with a delay below one SYNC0 cycle it would come with each.
        (FACTOR_1, 'Factor="2">0', -30_000, 250_000, 470_000, ["(C - 30000) >= 0"]),
        # Two whole SYNC0 cycles, which move nothing.
        (">250000", 'Factor="-1">0', -500_000, 1_000_000, 750_000, ["C % 250000 == 0"]),
    ],
)
def test_a_shift_that_is_not_within_a_cycle_of_sync0_does_not_change_the_rate_of_sync1(
    sync0, sync1, shift_ns, cycle_ns, delay_ns, made
):
    content = SMS + dc(("m", times("#x700", sync0, sync1, shift1=str(shift_ns))))
    found = configured(content, cycle_ns=cycle_ns)
    assert found.clocks is not None
    assert found.clocks.sync1_delay.in_ns(cycle_ns) == delay_ns
    assert any(remark.startswith(f"ShiftTimeSync1, {shift_ns} ns, is not within") for remark in found.remarks) == (
        not 0 <= shift_ns < found.clocks.sync0_cycle.in_ns(cycle_ns)
    )
    assert [condition for condition in conditions(content, cycle_ns) if " or " not in condition] == made


@pytest.mark.parametrize(
    ("sync0", "sync1", "cycle_ns", "described", "other_cycle_ns"),
    [
        # The delay of 2.5 ms is over between the second and the third SYNC0: SYNC1 would come every 3 ms.
        (
            FACTOR_1,
            ">4000000",
            1_500_000,
            "every 4000000 ns, which is no multiple of the SYNC0 cycle of 1500000",
            1_000_000,
        ),
        (
            'Factor="2">0',
            'Factor="-3">0',
            None,
            "every 3000000 ns, which is no multiple of the SYNC0 cycle of 2000000",
            None,
        ),
        (
            ">400000",
            ">1000000",
            2_000_000,
            "every 1000000 ns, which is no multiple of the SYNC0 cycle of 400000 ns",
            None,
        ),
        (">1000000", 'Factor="-3">0', 500_000, "every 1500000 ns", 1_000_000),
    ],
)
def test_a_sync1_between_two_multiples_of_the_sync0_cycle_is_refused(sync0, sync1, cycle_ns, described, other_cycle_ns):
    """Another bus cycle is advised where one helps: with neither fixed times nor multiples only."""
    content = SMS + dc(("m", times("#x700", sync0, sync1)))
    with pytest.raises(InputError, match=f"'m' describes SYNC1 {described}") as why:
        configured(content, cycle_ns=cycle_ns)
    assert ("--cycle-ns" in str(why.value)) == (other_cycle_ns is not None)
    if other_cycle_ns is not None:
        assert configured(content, cycle_ns=other_cycle_ns).clocks is not None
    # Without the bit of SYNC1 it is none.
    assert configured(content.replace("#x700", "#x300"), cycle_ns=cycle_ns).clocks is not None


@pytest.mark.parametrize(
    ("times_of_mode", "word", "remark"),
    [
        ("<ActivateAdditional>#x1</ActivateAdditional>", "#x300", "the OpMode gives ActivateAdditional, which is left"),
        ("<ActivateAdditional>#x1</ActivateAdditional>", "0", "the OpMode gives ActivateAdditional, which is left out"),
        (
            "<CycleTimeSync2 Factor='1'>0</CycleTimeSync2><ShiftTimeSync3>5</ShiftTimeSync3>",
            "#x300",
            "the OpMode gives CycleTimeSync2, ShiftTimeSync3, which is left out",
        ),
        ("<ShiftTimeSync1 Input='1'>9</ShiftTimeSync1>", "#x700", "ShiftTimeSync1 counts from the input reference"),
        ("<ShiftTimeSync1 Factor='2'>9</ShiftTimeSync1>", "#x700", "ShiftTimeSync1 has Factor 2, which is left out"),
        ("<ShiftTimeSync0 Factor='2'>9</ShiftTimeSync0>", "#x300", "ShiftTimeSync0 has Factor 2, which is left out"),
        # Not given, or of a signal that is not generated.
        ("<ActivateAdditional>0</ActivateAdditional><CycleTimeSync2>0</CycleTimeSync2>", "#x300", None),
        ("<ShiftTimeSync1 Input='1' Factor='2'>9</ShiftTimeSync1>", "#x300", None),
    ],
)
def test_parts_of_an_op_mode_that_are_left_out_are_told(times_of_mode, word, remark):
    found = configured(SMS + dc(("m", times(word, FACTOR_1 if word != "0" else "") + times_of_mode)))
    assert [words[: len(remark or "")] for words in found.remarks] == ([remark] if remark else [])


def test_a_bus_cycle_that_is_open_follows_a_fixed_sync0_before_sync1_is_judged():
    found = configured(SMS + dc(("m", times("#x700", ">700000", 'Factor="-1">0'))))
    assert (found.cycle_ns, found.clocks.sync1_delay.in_ns(700_000)) == (700_000, 0)


@pytest.mark.parametrize("word", ["#x300", "#x500", "#x700"])
def test_no_words_name_a_pulse_that_is_not_generated(word):
    """With SYNC1 alone the SYNC0 cycle counts all the same, without a pulse."""
    fixed = SMS + dc(("m", times(word, ">700000")))
    divided = SMS + dc(("m", times(word, 'Factor="-4">0')))
    for content in (fixed, divided):
        found = configured(content)
        assert found.clocks is not None
        told = [*found.remarks, *(item.words for item in found.clocks.conditions(C, found.cycle_ns))]
        assert told
        for words in told:
            assert not re.search("SYNC0(?! cycle)", words)
            assert word != "#x300" or "SYNC1" not in words


@pytest.mark.parametrize("word", ["#x300", "#x500", "#x700"])
def test_a_fixed_cycle_that_drifts_against_the_bus_cycle_is_refused(word):
    """SYNC1 too counts from SYNC0, with or without its pulse."""
    with pytest.raises(
        InputError, match="fixes the SYNC0 cycle at 250000 ns, which drifts against a bus cycle of 700000 ns"
    ):
        configured(SMS + dc(("m", times(word, ">250000"))), cycle_ns=700_000)


def test_a_fixed_cycle_without_pulses_drifts_against_nothing():
    found = configured(SMS + dc(("m", times("#x100", ">250000"))), cycle_ns=700_000)
    assert (found.cycle_ns, found.remarks) == (700_000, ())


def test_without_a_choice_the_bus_cycle_is_the_usual_one_or_that_of_a_sync0_that_would_drift_against_it():
    assert configured(SMS).cycle_ns == 1_000_000
    assert configured(SMS + dc(("m", times("#x300", ">3000000")))).cycle_ns == 1_000_000
    found = configured(SMS + dc(("m", times("#x300", ">700000"))))
    assert found.cycle_ns == 700_000
    assert found.remarks == (
        "the bus cycle is the SYNC0 cycle, 700000 ns: the OpMode fixes it, and it drifts against 1000000 ns",
    )


MODES = SMS + dc(("free", times("0")), ("DC", times("#x300", FACTOR_1)), ("DC", times("#x700", FACTOR_1, FACTOR_1)))


@pytest.mark.parametrize(("wanted", "position"), [(None, 0), ("free", 0), ("2", 2), ("1", 1), ("#2", 2)])
def test_op_modes_by_name_and_position(wanted, position):
    assert configured(MODES, op_mode=wanted).op_mode_position == position


@pytest.mark.parametrize(("wanted", "position"), [("1", 0), ("#1", 1)])
def test_an_explicit_position_is_no_name(wanted, position):
    modes = SMS + dc(("1", times("0")), ("", times("#x300", FACTOR_1)))
    assert configured(modes, op_mode=wanted).op_mode_position == position


@pytest.mark.parametrize(
    ("wanted", "message"), [("DC", "exists at positions 1, 2"), ("3", "does not exist"), ("x", "0 'free', 1 'DC'")]
)
def test_op_modes_that_are_not_one(wanted, message):
    with pytest.raises(InputError, match=message):
        configured(MODES, op_mode=wanted)


def test_a_plugged_module_chooses_the_op_mode():
    asking = module("<DcOpModeName>DC</DcOpModeName>")
    found = configured(MODES + ONE_SLOT, asking)
    assert found.op_mode_position == 1
    assert any("a plugged module asks for it" in remark for remark in found.remarks)
    assert configured(MODES + ONE_SLOT, asking, op_mode="free").op_mode_position == 0


def test_a_module_that_asks_for_an_op_mode_that_is_none_is_named():
    found = configured(MODES + ONE_SLOT, module("<DcOpModeName>DCx</DcOpModeName>"))
    assert found.op_mode_position == 0
    assert "a plugged module asks for OpMode 'DCx' (DcOpModeName), which the device does not have" in found.remarks


def test_a_pdo_is_not_chosen_for_a_sync_manager_of_the_other_direction():
    content = SMS + rx("#x1600", entry("#x6040", 16), attributes='Sm="3"')
    with pytest.raises(InputError, match="PDO 0x1600 cannot be assigned: SM3 is for Inputs"):
        configured(content, pdos=parse_pdo_choice("0x1600"))


def init_cmd(transitions: str, index: str, data: str, extra: str = "") -> str:
    marks = "".join(f"<Transition>{name}</Transition>" for name in transitions.split())
    return f"<InitCmd {extra}>{marks}<Index>{index}</Index><SubIndex>1</SubIndex><Data>{data}</Data></InitCmd>"


def test_commands_by_transition():
    commands = init_cmd("SO", "#x2001", "01") + init_cmd("PS IP", "#x2002", "0200") + init_cmd("XX", "#x2003", "03")
    found = configured(SMS + f"<Mailbox><CoE>{commands}{init_cmd('PS', '#x2004', '')}</CoE></Mailbox>")
    assert [(c.transition, c.object_index, c.data) for c in found.commands] == [
        ("IP", 0x2002, b"\x02\x00"),
        ("PS", 0x2002, b"\x02\x00"),
        ("SO", 0x2001, b"\x01"),
    ]
    assert sorted(remark.split(":")[0] for remark in found.remarks) == ["InitCmd 0x2003", "InitCmd 0x2004"]


def test_a_command_that_nothing_sends_is_told():
    """Without a Transition, and with one that is empty; of a module too."""
    odd = init_cmd("", "#x2001", "01")
    empty = init_cmd("PS", "#x2002", "02").replace("<Transition>PS<", "<Transition><")
    found = configured(
        f"{SMS}<Mailbox><CoE>{odd}{empty}</CoE></Mailbox>{ONE_SLOT}", module(f"<Mailbox><CoE>{odd}</CoE></Mailbox>")
    )
    assert found.commands == ()
    assert found.remarks == (
        "InitCmd 0x2001:01 of the device is left out: it names no transition",
        "InitCmd 0x2002:01 of the device is left out: transition '' is unknown",
        "InitCmd 0x2001:01 of the module in slot 0 is left out: it names no transition",
    )


def test_an_address_list_that_is_wanted_and_not_written_is_told():
    """DownloadModuleAddressList; with no module plugged there are no addresses."""
    wanting = ONE_SLOT.replace("<Slots", '<Slots DownloadModuleAddressList="1"')
    (remark,) = configured(SMS + wanting, module("")).remarks
    assert remark.startswith("Slots/@DownloadModuleAddressList: the device wants to be told the addresses")
    assert configured(SMS + ONE_SLOT, module("")).remarks == ()


def test_a_command_marked_overwritten_by_module_yields_to_the_module():
    own = init_cmd("PS", "#x6060", "08", 'OverwrittenByModule="1"') + init_cmd("PS", "#x6061", "01")
    of_module = f"<Mailbox><CoE>{init_cmd('PS', '#x6060', '09')}</CoE></Mailbox>"
    found = configured(SMS + f"<Mailbox><CoE>{own}</CoE></Mailbox>" + ONE_SLOT, module(of_module))
    assert [(c.object_index, c.data) for c in found.commands] == [(0x6061, b"\x01"), (0x6060, b"\x09")]


def test_a_command_of_a_module_that_is_left_out_replaces_none():
    own = init_cmd("PS", "#x6060", "08", 'OverwrittenByModule="1"').replace("<SubIndex>1<", "<SubIndex>0<")
    of_module = init_cmd("PS", "#x6060", "09").replace("<SubIndex>1<", "<SubIndex>0h<")
    found = configured(
        SMS + f"<Mailbox><CoE>{own}</CoE></Mailbox>" + ONE_SLOT, module(f"<Mailbox><CoE>{of_module}</CoE></Mailbox>")
    )
    assert [(c.object_index, c.subindex, c.data) for c in found.commands] == [(0x6060, 0, b"\x08")]


@pytest.mark.parametrize(("transitions", "data"), [("PS", "0"), ("PS", ""), ("XX", "09"), ("", "09")])
def test_a_command_of_a_module_that_is_never_sent_replaces_none(transitions, data):
    """Half a byte is no data, XX no transition."""
    own = init_cmd("PS", "#x6060", "08", 'OverwrittenByModule="1"')
    of_module = f"<Mailbox><CoE>{init_cmd(transitions, '#x6060', data)}</CoE></Mailbox>"
    found = configured(SMS + f"<Mailbox><CoE>{own}</CoE></Mailbox>" + ONE_SLOT, module(of_module))
    assert [(c.object_index, c.data) for c in found.commands] == [(0x6060, b"\x08")]


def written(index: str, subindex: int, data: str, adapt: str = "") -> str:
    place = f"<Transition>PS</Transition><Index>{index}</Index><SubIndex>{subindex}</SubIndex>"
    return f"<InitCmd>{place}<Data {adapt}>{data}</Data></InitCmd>"


def cycle_remarks(commands: str, content: str = "", **choice) -> list[str]:
    found = configured(SMS + content + f"<Mailbox><CoE>{commands}</CoE></Mailbox>", **choice)
    return [remark for remark in found.remarks if "the bus cycle is" in remark]


def at_once(index: str, subindex: int, data: str) -> str:
    return written(index, subindex, data).replace("<InitCmd>", '<InitCmd CompleteAccess="1">')


def period(value: str, exponent: str) -> str:
    """The interpolation time period with defaults, as hexadecimal bytes."""
    bits = {"SubIndex 000": ("USINT", 0, "02"), "value": ("USINT", 16, value), "index": ("SINT", 24, exponent)}
    items = "".join(
        f"<SubItem><SubIdx>{number}</SubIdx><Name>{name}</Name><Type>{kind}</Type><BitSize>8</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for number, (name, (kind, offset, _)) in enumerate(bits.items())
    )
    values = "".join(
        f"<SubItem><Name>{name}</Name><Info><DefaultData>{default}</DefaultData></Info></SubItem>"
        for name, (_, _, default) in bits.items()
    )
    return dictionary(
        f"<DataType><Name>DT60C2</Name><BitSize>32</BitSize>{items}</DataType>",
        f"<Object><Index>#x60C2</Index><Name>Interpolation time period</Name><Type>DT60C2</Type><BitSize>32</BitSize>"
        f"<Info>{values}</Info></Object>",
    )


TWO_AXES = rx("#x1600", entry("#x6040", 16), entry("#x6840", 16))


@pytest.mark.parametrize(
    ("commands", "content", "written_ns"),
    [
        # 0x60C2 is subindex 1 times ten to the power of subindex 2, in seconds.
        (written("#x60C2", 1, "02"), "", 2_000_000),
        (written("#x60C2", 1, "14") + written("#x60C2", 2, "FC"), "", 2_000_000),
        (written("#x60C2", 2, "FA") + written("#x60C2", 1, "FA"), "", 250_000),
        (written("#x60C2", 1, "01") + written("#x60C2", 2, "00"), "", 1_000_000_000),
        (written("#x68C2", 1, "05") + written("#x68C2", 2, "FC"), TWO_AXES, 500_000),
        # Cycle time of the SyncManager parameters, UDINT in ns.
        (written("#x1C32", 2, "40420F00"), "", 1_000_000),
        (written("#x1C33", 2, "20A10700"), "", 500_000),
        # The exponent that the dictionary declares counts where no command writes it, -4; and so does the value.
        (written("#x60C2", 1, "0A"), "DECLARED", 1_000_000),
        (written("#x60C2", 2, "FB"), "DECLARED", 200_000),
        (written("#x60C2", 1, "02") + written("#x60C2", 2, "FD"), "DECLARED", 2_000_000),
        # Complete access: subindex 0 has 16 bits.
        (at_once("#x60C2", 0, "020014FC"), "", 2_000_000),
        (at_once("#x60C2", 1, "14FC"), "", 2_000_000),
        (at_once("#x60C2", 0, "02000A"), "DECLARED", 1_000_000),
        (at_once("#x1C32", 0, "0300020040420F00"), "", 1_000_000),
        (at_once("#x1C32", 2, "40420F00"), "", 1_000_000),
    ],
)
def test_cycle_times_that_commands_write_are_compared_with_the_bus_cycle(commands, content, written_ns):
    content = content.replace("DECLARED", period("14", "FC"))
    assert cycle_remarks(commands, content, cycle_ns=written_ns) == []
    (remark,) = cycle_remarks(commands, content, cycle_ns=4_000_000)
    assert f"writes {written_ns} ns, the bus cycle is 4000000 ns: adapt one of them" in remark


@pytest.mark.parametrize(
    "commands",
    [
        # Without an axis there, 0x68C2 is an object of modular I/O.
        written("#x68C2", 1, "05"),
        written("#x1C32", 1, "0200"),
        written("#x60C2", 2, "FD"),
        written("#x60C2", 1, "00" * 5_000),
        # Neither the value nor its place is there.
        at_once("#x60C2", 0, "0200"),
        at_once("#x60C2", 3, "14"),
        at_once("#x1C32", 0, "030002004042"),
    ],
)
def test_commands_that_write_no_cycle_time(commands):
    assert cycle_remarks(commands) == []


@pytest.mark.parametrize(
    ("due", "written_ns"),
    [
        # 1 times 10^-3 s; at OP, which leads back, nothing is written in the course of a start.
        ((("PS", 1, "01"), ("OP", 2, "FC")), 1_000_000),
        # 10 times 10^-4 s, then 1 times 10^-3 s.
        ((("PS", 1, "0A"), ("PS", 2, "FC"), ("SO", 1, "01"), ("SO", 2, "FD")), 1_000_000),
        ((("SO", 1, "02"), ("PS", 1, "0A"), ("PS", 2, "FD")), 2_000_000),
        ((("PS", 1, "02"), ("SO", 2, "FC")), 200_000),
    ],
)
def test_the_cycle_time_is_what_a_start_leaves(due, written_ns):
    """The interpolation time period: subindex 1 times ten to the power of subindex 2, which is -3 by itself."""
    commands = "".join(
        written("#x60C2", subindex, data).replace(">PS<", f">{transition}<") for transition, subindex, data in due
    )
    assert cycle_remarks(commands, cycle_ns=written_ns) == []
    (remark,) = cycle_remarks(commands, cycle_ns=4_000_000)
    assert f"writes {written_ns} ns" in remark


def test_a_cycle_time_that_only_a_way_back_writes_is_none():
    assert cycle_remarks(written("#x1C32", 2, "40420F00").replace(">PS<", ">SP<"), cycle_ns=4_000_000) == []


def test_the_cycle_of_sync0_is_also_one_for_the_sync_manager():
    mode = dc(("DC", times("#x300", 'Factor="2">0')))
    assert cycle_remarks(written("#x1C32", 2, "80841E00"), mode) == []
    assert len(cycle_remarks(written("#x60C2", 1, "02"), mode)) == 1


def test_a_cycle_time_that_the_configuration_tool_adapts_says_so():
    (remark,) = cycle_remarks(written("#x1C32", 2, "40420F00", 'AdaptAutomatically="1"'), cycle_ns=4_000_000)
    assert remark.endswith("adapt one of them; AdaptAutomatically: the configuration tool adapts the data")


def test_an_empty_default_module_list_downloads_nothing():
    slots = '<Slots DownloadModuleIdentList="1"><Slot MinInstances="0" MaxInstances="2"><ModuleIdent>1</ModuleIdent>'
    assert configured(SMS + f"{slots}</Slot></Slots>").commands == ()


def test_module_idents_one_by_one_without_complete_access():
    slots = (
        '<Slots DownloadModuleIdentList="1" DownloadModuleListTransition="IP">'
        '<Slot MinInstances="0" MaxInstances="3"><ModuleIdent>#x10</ModuleIdent></Slot></Slots>'
    )
    module = "<Module><Type ModuleIdent='#x10'>M</Type><Name>M</Name></Module>"
    found = configured(SMS + slots, module, modules={1: ModuleChoice(0x10)})
    assert [(c.transition, c.subindex, c.data.hex()) for c in found.commands] == [
        ("IP", 0, "00"),
        ("IP", 1, "00000000"),
        ("IP", 2, "10000000"),
        ("IP", 0, "02"),
    ]


@pytest.mark.parametrize(("access", "count_writes"), [("ro", []), ("rw", ["00", "01"]), (None, ["00", "01"])])
def test_the_number_of_modules_is_not_written_where_it_is_read_only(access, count_writes):
    """Idents are rw, their number ro: a device that describes it so aborts its download with 0x06010002."""
    item = (
        "<SubItem><SubIdx>{}</SubIdx><Name>S</Name><Type>{}</Type><BitSize>{}</BitSize><BitOffs>{}</BitOffs>"
        "<Flags><Access>{}</Access></Flags></SubItem>"
    )
    types = (
        "<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType><DataType><Name>UDINT</Name><BitSize>32</BitSize>"
        "</DataType><DataType><Name>DTF030</Name><BitSize>48</BitSize>"
        + item.format(0, "USINT", 8, 0, access)
        + item.format(1, "UDINT", 32, 16, "rw")
        + "</DataType>"
    )
    list_object = "<Object><Index>#xF030</Index><Name>L</Name><Type>DTF030</Type><BitSize>48</BitSize></Object>"
    described = dictionary(types, list_object) if access else ""
    slots = (
        '<Slots DownloadModuleIdentList="1"><Slot MinInstances="0" MaxInstances="1"><ModuleIdent>#x10</ModuleIdent>'
        "</Slot></Slots>"
    )
    module = "<Module><Type ModuleIdent='#x10'>M</Type><Name>M</Name></Module>"
    for mailbox in ("<Mailbox><CoE/></Mailbox>", '<Mailbox><CoE CompleteAccess="1"/></Mailbox>'):
        found = configured(described + SMS + mailbox + slots, module, modules={0: ModuleChoice(0x10)})
        singles = found.commands if "Complete" not in mailbox else tuple(single_accesses(found.commands[0]))
        assert [command.data.hex() for command in singles if not command.subindex] == count_writes
        assert [command.data.hex() for command in singles if command.subindex] == ["10000000"]
        told = [
            remark for remark in found.remarks if remark.startswith("0xF030:00, the number of modules, is read-only")
        ]
        assert len(told) == (access == "ro")


def test_the_control_byte_decides_the_direction():
    mixed = '<Sm ControlByte="#x64">Inputs</Sm>' + pdo("TxPdo", "#x1A00", 8, attributes='Sm="0"')
    found = configured(mixed)
    assert [sm.direction for sm in found.sync_managers] == [OUTPUT]
    assert any("in both directions" in remark for remark in found.remarks)
    assert [sm.direction for sm in configured("<Sm>Inputs</Sm><Sm>Outputs</Sm>").sync_managers] == [INPUT, OUTPUT]


@pytest.mark.parametrize(
    ("choice", "message"),
    [
        ({"cycle_ns": 0}, "bus cycle"),
        ({"alias": 70_000}, "alias 70000"),
        ({"position": -1}, "position -1"),
        ({"name": "1x"}, "cannot begin names"),
        ({"name": "a__b"}, "cannot begin names"),
        ({"name": "int"}, "is a word or macro of C"),
        ({"name": "Class"}, "is a word or macro of C"),
        ({"name": "a1_"}, "single _ between them"),
        ({"name": 49 * "a"}, "longer than 48 characters"),
        ({"name": "a;b"}, "cannot begin names"),
    ],
)
def test_numbers_and_names_that_cannot_be(choice, message):
    with pytest.raises(InputError, match=message):
        configured(SMS, **choice)


def test_subjects_of_a_document_are_chosen_by_identity():
    hides = "<HideType RevisionNo='#x3'/>"
    text = esi(device("", revision="#x1") + device(hides, revision="#x2") + device("", revision="#x3") + device("", ""))
    subjects = subjects_of_document(read(text).document, "x.xml")
    assert [item.revision_no for item in subjects] == [1, 2, 3, None]
    assert choose_subject(subjects, Identity(0xE5C, 1, 3), "x.xml").revision_no == 3
    assert choose_subject(subjects, Identity(0xE5C, 1), "x.xml").revision_no == 2, "revision 3 is hidden"
    with pytest.raises(InputError, match="describes 4 devices; name one of: 0x00000e5c:0x00000001:0x00000001"):
        choose_subject(subjects, None, "x.xml")
    with pytest.raises(NotFound, match="does not describe"):
        choose_subject(subjects, Identity(0xE5C, 9), "x.xml")


def test_an_identity_that_is_described_twice_needs_a_variant():
    subjects = subjects_of_document(read(esi(device("", name="A") + device("", name="B"))).document, "x.xml")
    with pytest.raises(InputError, match="2 times; append @1 to @2"):
        choose_subject(subjects, Identity(0xE5C, 1, 1), "x.xml")
    assert choose_subject(subjects, Identity(0xE5C, 1, 1, 2), "x.xml").device.names[0].text == "B"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (pdo("RxPdo", "#x1600", 8, attributes='Sm="-1"'), "SM-1"),
        (rx("#x1600", entry("#x7000", 1_000_000_000)), "1000000000 bits"),
        (rx("#x11600", entry("#x7000", 8)), "has no index"),
        (rx("#x1600", entry("#x17000", 8)), "is no object"),
        (rx("#x1600", entry("#x7000", 8, subindex=300)), "is no object"),
    ],
)
def test_numbers_of_the_file_that_no_master_can_take(content, message):
    with pytest.raises(InputError, match=message):
        configured(SMS + content)


def mode_command(data: str, transition: str = "PS") -> str:
    return init_cmd(transition, "#x6060", data).replace("<SubIndex>1<", "<SubIndex>0<")


def mode_module(name: str, *commands: str) -> str:
    """A module for :data:`ONE_SLOT` with these commands and a controlword, which makes it a drive."""
    coe = f"<Mailbox><CoE>{''.join(commands)}</CoE></Mailbox>"
    content = rx("#x1600", entry("#x6040", 16), entry("#x607A", 32)) + coe
    return f"<Module><Type ModuleIdent='1'>{name}</Type><Name>M</Name>{content}</Module>"


def test_a_mode_against_the_name_of_the_plugged_module_is_told():
    """Code 8 is CSP (CiA 402 object 0x6060); the name lists profile modes only (rule L57)."""
    found = configured(SMS + ONE_SLOT, mode_module("Axis (pp,pv)", mode_command("08", "SO")))
    assert found.remarks == (
        "slot 0: the start-up command writes 0x6060 = 8 (CSP), but the module's name 'Axis (pp,pv) / M' lists PP, PV: "
        "check which mode is meant before the drive is enabled",
    )


@pytest.mark.parametrize(("name", "data"), [("Axis (csp,pv)", "08"), ("Axis", "08"), ("Axis (pp,pv)", "01")])
def test_a_mode_that_the_name_lists_or_leaves_open_is_not_told(name, data):
    assert configured(SMS + ONE_SLOT, mode_module(name, mode_command(data))).remarks == ()


def test_the_code_of_a_mode_in_an_object_of_no_drive_is_none():
    module_text = mode_module("IO (pp,pv)", mode_command("08")).replace("#x6040", "#x2040").replace("#x607A", "#x207A")
    assert configured(SMS + ONE_SLOT, module_text).remarks == ()


def test_a_setpoint_without_a_mode_is_told():
    """0x6060 is 0 after power-on, no mode, unless its default says another; 0x6860 and 0x687A are those of axis 1."""
    words = "0x{} is in none of the assigned RxPDOs: write the mode that is wanted"
    coe = "<Mailbox><CoE>{}</CoE></Mailbox>"
    control, position, mode = entry("#x6040", 16), entry("#x607A", 32), entry("#x6060", 8)
    second = entry("#x6840", 16) + entry("#x687A", 32)
    described = (
        "<DataType><Name>SINT</Name><BitSize>8</BitSize></DataType>",
        "<Object><Index>#x6060</Index><Name>M</Name><Type>SINT</Type><BitSize>8</BitSize><Info><DefaultData>{}"
        "</DefaultData></Info><Flags><Access>rw</Access></Flags></Object>",
    )

    def told(*entries: str, content: str = "") -> list[str]:
        found = configured(content + SMS + rx("#x1600", *entries) + (COE if "<CoE>" not in content else ""))
        remarks = mode_remarks(found.modes, found.commands)
        return [remark.partition(" to it before")[0] for remark in remarks if "is in none of" in remark]

    assert told(control, position) == [words.format("6060")]
    assert told(control, position, second) == [words.format("6060"), words.format("6860")]
    assert told(control, position, mode, second) == [words.format("6860")]
    assert told(control, position, content=dictionary(described[0], described[1].format("00"))) == [
        words.format("6060")
    ]
    assert told(control, position, content=dictionary(described[0], described[1].format("08"))) == []
    read_only = dictionary(described[0], described[1].format("00").replace("rw", "ro"))
    assert told(control, position, content=read_only) == [
        "0x6060 is in none of the assigned RxPDOs, and read-only by the description: nothing that is described sets "
        "the mode that is wanted there, for no start-up command does"
    ]
    assert told(control, position, content=coe.format(mode_command("08"))) == []
    assert told(control, entry("#x647A", 64)) == [words.format("6060")], "a setpoint of the vendor's"
    assert told(entry("#x2040", 16), position) == [], "no axis"


@pytest.mark.parametrize(("data", "what"), [("08", "8 (CSP)"), ("FD", "-3")])
def test_a_mapped_mode_replaces_that_of_the_start_up_command(data, what):
    """FD is -3, a manufacturer's mode. Where only the display 0x6061 is mapped nothing replaces it."""
    coe = f"<Mailbox><CoE>{mode_command(data)}</CoE></Mailbox>"

    def told(content: str) -> tuple[str, ...]:
        found = configured(content)
        return (*found.remarks, *mode_remarks(found.modes, found.commands))

    assert told(SMS + rx("#x1600", entry("#x6060", 8)) + coe) == (
        f"0x6060 is mapped: the cyclic value replaces the {what} of the start-up command, so write the mode that is "
        "wanted there from the first cycle on",
    )
    assert told(SMS + rx("#x1600", entry("#x6061", 8)) + coe) == ()
    back = coe.replace("<Transition>PS<", "<Transition>OP<")
    assert told(SMS + rx("#x1600", entry("#x6060", 8)) + back) == ()
