"""Derived facts of a device: sizes, SYNC support, cycle, layout signatures, FSoE evidence."""

import pytest
from snippets import (
    REPEATED_ATTRIBUTE,
    UNDECLARED_PREFIX,
    device,
    dictionary,
    esi,
    faulty_vendor_texts,
    only_device,
    pdo,
)

from esicatalog.model.derivation import derive
from esicatalog.model.pdo_facts import pdo_facts
from esicatalog.model.sync import default_position
from esicatalog.model.twincat import PredefinedAssignment, predefined_assignments

OUTPUTS = "<Sm>Outputs</Sm>"


def facts(content: str):
    return derive(only_device(esi(device(content))), ()).facts


def op_modes(*words: str) -> str:
    modes = "".join(f"<OpMode><Name>m</Name><AssignActivate>{word}</AssignActivate></OpMode>" for word in words)
    return f"<Dc>{modes}</Dc>"


def test_a_device_that_uses_the_dc_time_only_generates_no_signals():
    """Dc/@TimeLoopControlOnly, as EL6692 has it; AssignActivate 0x0730 would mean SYNC0, SYNC1 and both latches."""
    without = facts(op_modes("#x0730"))
    found = facts(op_modes("#x0730").replace("<Dc>", '<Dc TimeLoopControlOnly="1">'))
    assert (without.supports_sync0, without.supports_sync1) == (True, True)
    assert (found.supports_sync0, found.supports_sync1, found.dc_supported) == (False, False, True)


def test_bytes_are_rounded_once_a_sync_manager():
    assert facts(OUTPUTS + pdo("RxPdo", "#x1600", 3, 3, 3, attributes="Sm='0'")).output_bytes == 2


@pytest.mark.parametrize("attributes", ["Sm='0' OSFac='300000000'", "Sm='0' OSFac='32768'"])
def test_the_size_of_what_no_sync_manager_holds_is_unknown(attributes):
    found = facts(OUTPUTS + pdo("RxPdo", "#x1600", 16, attributes=attributes))
    assert (found.output_bytes, found.input_bytes) == (None, 0)


def test_a_sync_manager_that_exchanges_nothing_is_no_other_layout():
    content = pdo("RxPdo", "#x1600", 16, attributes="Sm='0'")
    plain, more = facts(OUTPUTS + content), facts(OUTPUTS + "<Sm Virtual='1'>Inputs</Sm><Sm>Inputs</Sm>" + content)
    assert plain.image_signature == more.image_signature is not None
    sampled = facts(OUTPUTS + pdo("RxPdo", "#x1600", 16, attributes="Sm='0' OSFac='4'"))
    assert sampled.image_signature != plain.image_signature


@pytest.mark.parametrize(
    ("sync_managers", "sizes"),
    [
        ('<Sm ControlByte="#x64"/><Sm ControlByte="#x20"/>', (2, 1)),
        ("<Sm/><Sm/>", (2, 1)),
        ("<Sm>OrbitaOut</Sm><Sm>OrbitaIn</Sm>", (2, 1)),
        ("<Sm>OUTPUTS</Sm><Sm>inputs</Sm>", (2, 1)),
        ("<Sm>DynamicOutputs</Sm><Sm>DynamicInputs</Sm>", (2, 1)),
    ],
)
def test_sizes_do_not_depend_on_the_word_for_a_sync_manager(sync_managers, sizes):
    """``ethercat xml`` writes none."""
    content = pdo("RxPdo", "#x1600", 9, attributes="Sm='0'") + pdo("TxPdo", "#x1A00", 8, attributes="Sm='1'")
    found = facts(sync_managers + content)
    assert (found.output_bytes, found.input_bytes) == sizes


def test_a_virtual_sync_manager_does_not_count():
    virtual = OUTPUTS + "<Sm Virtual='1'>Outputs</Sm>"
    content = pdo("RxPdo", "#x1600", 16, attributes="Sm='0'") + pdo("RxPdo", "#x1610", 32, attributes="Sm='1'")
    assert facts(virtual + content).output_bytes == 2


@pytest.mark.parametrize(
    ("lengths", "size"),
    [((8, 16), 24), ((8, -16), 8), ((2**62, 2**62 - 1), 2**63 - 1), ((2**62, 2**62), None)],
)
def test_a_pdo_of_2_to_the_63_bits_has_no_size(lengths, size):
    (found,) = only_device(esi(device(pdo("RxPdo", "#x1600", *lengths)))).rx_pdos
    assert pdo_facts(found).bit_size == size


@pytest.mark.parametrize(
    ("content", "sizes"),
    [
        ("", (0, 0)),
        (OUTPUTS, (0, 0)),
        (OUTPUTS + pdo("RxPdo", "#x1600", 8, attributes="Sm='0'"), (1, 0)),
        (pdo("RxPdo", "#x1600", 8, attributes="Sm='0'"), (None, None)),
    ],
)
def test_a_coupler_has_no_bytes_and_pdos_without_sync_managers_have_unknown_ones(content, sizes):
    found = facts(content)
    assert (found.output_bytes, found.input_bytes) == sizes


@pytest.mark.parametrize(
    ("words", "supported", "needed", "without"),
    [
        ((), False, False, True),
        (("0",), False, False, True),
        (("0", "#x300"), True, False, True),
        (("#x300", "#x700"), True, True, False),
        (("#x630",), False, False, True),
        (("300h",), False, False, False),
        (("300h", "0"), False, False, True),
    ],
)
def test_distributed_clocks(words, supported, needed, without):
    found = facts(op_modes(*words))
    assert (found.dc_supported, found.dc_needed, found.runs_without_dc) == (supported, needed, without)


def test_latch_units_given_to_the_slave_count_as_latch_use():
    assert facts(op_modes("#x320")).uses_latch
    assert not facts(op_modes("#x300")).uses_latch


def test_time_loop_control_only_uses_no_latch():
    """DC time and no LATCH (ESI-FACTS 11), though 0x0120 gives a latch unit to the slave, and 0x0100 makes no pulse."""
    for word in ("#x120", "#x100"):
        assert facts(op_modes(word)).uses_latch
        assert not facts(op_modes(word).replace("<Dc>", '<Dc TimeLoopControlOnly="1">')).uses_latch


def test_equal_layouts_have_equal_signatures_whatever_the_names():
    first = OUTPUTS + pdo("RxPdo", "#x1600", 8, 16, attributes="Sm='0'")
    renamed = first.replace(">e1<", ">other<")
    longer = OUTPUTS + pdo("RxPdo", "#x1600", 8, 32, attributes="Sm='0'")
    assert facts(first).image_signature == facts(renamed).image_signature
    assert facts(first).image_signature != facts(longer).image_signature


def test_not_assigned_pdos_count_for_the_set_only():
    assigned = OUTPUTS + pdo("RxPdo", "#x1600", 8, attributes="Sm='0'")
    more = assigned + pdo("RxPdo", "#x1601", 8)
    assert facts(assigned).image_signature == facts(more).image_signature
    assert facts(assigned).pdo_signature != facts(more).pdo_signature


def sync_objects(*cycles: tuple[str, str]) -> str:
    """A dictionary with SM synchronisation objects, each with a default of its minimum cycle time."""
    sub_items = "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>s{n}</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        "<BitOffs>0</BitOffs></SubItem>"
        for n in (4, 5)
    )
    types = f"<DataType><Name>DT</Name><BitSize>80</BitSize>{sub_items}</DataType>"
    objects = ""
    for index, cycle in cycles:
        values = "".join(
            f"<SubItem><Name>s{n}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>"
            for n, data in ((4, "0F400000"), (5, cycle))
        )
        objects += f"<Object><Index>{index}</Index><Name>o</Name><Type>DT</Type><BitSize>80</BitSize>"
        objects += f"<Info>{values}</Info></Object>"
    return dictionary(types, objects)


NONE, US_250, MS_1 = "00000000", "90D00300", "40420F00"


@pytest.mark.parametrize(
    ("cycles", "smallest"),
    [
        ([("#x1C32", US_250)], 250_000),
        ([("#x1C33", MS_1)], 1_000_000),
        ([("#x1C32", US_250), ("#x1C33", MS_1)], 1_000_000),  # inputs keep up with 1 ms only
        ([("#x1C32", MS_1), ("#x1C33", NONE)], 1_000_000),
        ([("#x1C32", NONE)], None),
    ],
)
def test_smallest_cycle_is_that_which_outputs_and_inputs_keep_up_with(cycles, smallest):
    found = facts(sync_objects(*cycles))
    assert found.min_cycle_ns == smallest
    assert 0x400F in (found.output_sync_types, found.input_sync_types)


def oversampling(*attributes: str) -> str:
    """OpModes with an Oversampling element of TwinCAT."""
    modes = "".join(
        f"<OpMode><Name>m</Name><AssignActivate>#x730</AssignActivate><VendorSpecific><TwinCAT><Oversampling {words}/>"
        "</TwinCAT></VendorSpecific></OpMode>"
        for words in attributes
    )
    return f"<Dc>{modes}</Dc>"


@pytest.mark.parametrize(
    ("attributes", "smallest"),
    [
        # EL3702: 10 samples of 10 µs with two channels, of 5 µs with one.
        (['DefaultFactor="10" MinCycleTime="10000"', 'DefaultFactor="10" MinCycleTime="5000"'], 50_000),
        (['DefaultFactor="4" MinCycleTime="5000"'], 20_000),
        (['MinCycleTime="5000"'], 5_000),
        (['DefaultFactor="10" MinCycleTime="0"'], None),
        (['DefaultFactor="10"'], None),
        ([f'DefaultFactor="10" MinCycleTime="{"9" * 18}"', 'DefaultFactor="10" MinCycleTime="1e3"'], None),
    ],
)
def test_a_sample_interval_is_no_cycle_without_the_number_of_samples(attributes, smallest):
    assert facts(oversampling(*attributes)).min_cycle_ns == smallest


@pytest.mark.parametrize("fault", [UNDECLARED_PREFIX, REPEATED_ATTRIBUTE])
def test_a_fault_in_the_text_of_a_vendor_hides_nothing_beside_it(fault):
    found = only_device(esi(device(faulty_vendor_texts(fault))))
    assert derive(found, ()).facts.min_cycle_ns == 5_000
    assert default_position(found.op_modes) == 1
    assert predefined_assignments(found) == [PredefinedAssignment("A", False, {0: (0x1600,)})]


def test_samples_of_an_op_mode_that_newer_tools_ignore_do_not_count():
    modes = oversampling('MinCycleTime="1000"', 'DefaultFactor="10" MinCycleTime="10000"')
    ignored = modes.replace("<TwinCAT>", '<TwinCAT IgnoreFromBuildNo="2200">', 1)
    assert facts(ignored).min_cycle_ns == 100_000


BOOT_WORDS = "0010000400140004"
"""Receive mailbox at 0x1000 and send mailbox at 0x1400, 1024 bytes each."""


@pytest.mark.parametrize(
    ("eeprom", "has_bootstrap"),
    [
        (f"<ByteSize>2048</ByteSize><BootStrap>{BOOT_WORDS}</BootStrap>", True),
        (f"<ByteSize>2048</ByteSize><BootStrap>{'00' * 8}</BootStrap>", False),
        (f"<Data>{'11' * 0x28}{BOOT_WORDS}{'11' * 80}</Data>", True),
        (f"<Data>{'11' * 0x28}{'00' * 8}{'11' * 80}</Data>", False),
        ("<Data>0011</Data>", False),
    ],
)
def test_the_bootstrap_mailbox_stands_in_a_whole_image_too(eeprom, has_bootstrap):
    assert facts(f"<Eeprom>{eeprom}</Eeprom>").has_bootstrap is has_bootstrap


def test_a_declared_cycle_counts_before_that_of_samples():
    """EL3773: 0x1C33:05 and an OpMode with oversampling."""
    both = sync_objects(("#x1C33", MS_1)) + oversampling('DefaultFactor="10" MinCycleTime="5000"')
    assert facts(both).min_cycle_ns == 1_000_000


def test_fsoe_needs_more_than_a_name():
    high = facts(pdo("RxPdo", "#x1600", 8, attributes="SafetyPdoType='FSoESlave'"))
    assert (high.fsoe, high.fsoe_evidence.endswith("not a safety statement")) == ("high", True)
    assert facts(pdo("RxPdo", "#x1600", 8).replace("RxPdo #x1600", "Safety outputs")).fsoe is None


def named_pdo(name: str, *entries: str, attributes: str = "") -> str:
    rows = "".join(
        f"<Entry><Index>#x7000</Index><SubIndex>{n}</SubIndex><BitLen>16</BitLen><Name>{entry}</Name></Entry>"
        for n, entry in enumerate(entries, 1)
    )
    return f"<RxPdo {attributes}><Index>#x1600</Index><Name>{name}</Name>{rows}</RxPdo>"


@pytest.mark.parametrize(
    ("name", "entries", "words"),
    [
        ("FSoE Master Message", ["CMD"], "PDO 0x1600 has the name 'FSoE Master Message'"),
        ("FSOE_RxPDO", ["CMD"], "PDO 0x1600 has the name 'FSOE_RxPDO'"),
        ("FSoEMaster", ["CMD"], "PDO 0x1600 has the name 'FSoEMaster'"),
        ("Outputs", ["Command", "FSOE_ConnID"], "PDO 0x1600 has the name 'FSOE_ConnID'"),
        ("Outputs", ["ConnID", "CRC_0"], "PDO 0x1600 has the names of an FSoE frame, ConnID and CRC_0"),
        (
            "Outputs",
            ["TSC__Master CRC_0", "TSC__Master ConnID"],
            "PDO 0x1600 has the names of an FSoE frame, ConnID and CRC_0",
        ),
        ("Outputs", ["Master_Conn_ID", "Master_CRC0"], "PDO 0x1600 has the names of an FSoE frame, ConnID and CRC_0"),
    ],
)
def test_fsoe_by_the_names_of_process_data(name, entries, words):
    """An underscore beside FSoE or CRC_0 hid it, and FSoE counted only with CRC_0."""
    found = facts(named_pdo(name, *entries))
    assert (found.fsoe, found.fsoe_evidence) == ("medium", f"{words}; not a safety statement")


@pytest.mark.parametrize(
    "entries", [["ConnID"], ["CRC_0"], ["ConnID", "CRC_01"], ["OffsOEnable"], ["Connidle", "CRC_0"]]
)
def test_names_that_are_not_of_fsoe(entries):
    assert facts(named_pdo("Outputs", *entries)).fsoe is None


def test_fsoe_by_a_name_in_any_language():
    german = named_pdo("Safety", "CMD").replace("</Name>", "</Name><Name LcId='1031'>FSoE Telegramm</Name>", 1)
    evidence = "PDO 0x1600 has the name 'FSoE Telegramm'; not a safety statement"
    assert facts(german).fsoe_evidence == evidence


def test_fsoe_by_the_number_of_the_safety_connection():
    found = facts(named_pdo("Outputs", "CMD", attributes="SafetyConnNumber='1'"))
    assert (found.fsoe, found.fsoe_evidence) == ("high", "PDO 0x1600 has SafetyConnNumber 1; not a safety statement")
