"""Derived facts of a device: sizes, SYNC support, cycle, layout signatures, FSoE evidence."""

import pytest
from snippets import device, dictionary, esi, only_device, pdo

from esicatalog.model.derivation import derive

OUTPUTS = "<Sm>Outputs</Sm>"


def facts(content: str):
    return derive(only_device(esi(device(content)))).facts


def op_modes(*words: str) -> str:
    modes = "".join(f"<OpMode><Name>m</Name><AssignActivate>{word}</AssignActivate></OpMode>" for word in words)
    return f"<Dc>{modes}</Dc>"


def test_bytes_are_rounded_once_a_sync_manager():
    assert facts(OUTPUTS + pdo("RxPdo", "#x1600", 3, 3, 3, attributes="Sm='0'")).output_bytes == 2


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
    ],
)
def test_distributed_clocks(words, supported, needed, without):
    found = facts(op_modes(*words))
    assert (found.dc_supported, found.dc_needed, found.runs_without_dc) == (supported, needed, without)


def test_latch_units_given_to_the_slave_count_as_latch_use():
    assert facts(op_modes("#x320")).uses_latch
    assert not facts(op_modes("#x300")).uses_latch


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


def test_smallest_cycle_from_the_sync_object():
    sub_items = "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>s{n}</Name><Type>UDINT</Type><BitSize>32</BitSize>"
        "<BitOffs>0</BitOffs></SubItem>"
        for n in (4, 5)
    )
    types = f"<DataType><Name>DT</Name><BitSize>80</BitSize>{sub_items}</DataType>"
    values = "".join(
        f"<SubItem><Name>s{n}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>"
        for n, data in ((4, "0F400000"), (5, "90D00300"))
    )
    sync = (
        f"<Object><Index>#x1C32</Index><Name>o</Name><Type>DT</Type><BitSize>80</BitSize><Info>{values}</Info></Object>"
    )
    found = facts(dictionary(types, sync))
    assert (found.output_sync_types, found.min_cycle_ns) == (0x400F, 250_000)


def test_fsoe_needs_more_than_a_name():
    high = facts(pdo("RxPdo", "#x1600", 8, attributes="SafetyPdoType='FSoESlave'"))
    assert (high.fsoe, high.fsoe_evidence.endswith("not a safety statement")) == ("high", True)
    assert facts(pdo("RxPdo", "#x1600", 8).replace("RxPdo #x1600", "Safety outputs")).fsoe is None
