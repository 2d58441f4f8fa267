"""Signs of CiA 402 values (IEC 61800-7-201), whatever a description declares: in every export, and remarked."""

import pytest
from test_export_configuration import COE, SMS, configured, entry, rx

from esicatalog.export.cia402_names import CIA402_NAMES
from esicatalog.export.cia402_types import SIGNED_OBJECTS
from esicatalog.export.igh import igh_header
from esicatalog.export.linuxcnc import linuxcnc_configuration
from esicatalog.export.pysoem import pysoem_module
from esicatalog.export.ros2 import ros2_slave
from esicatalog.export.soem import soem_header

CONTROLWORD = entry("#x6040", 16, data_type="UINT16")
REMARK = "0x60FF:00 Target velocity: declared UDINT; CiA 402 has INTEGER32, which is taken"


def one(*entries: str):
    """The last of these entries in an RxPDO, and the remarks of its device but for that on the mode."""
    found = configured(SMS + rx("#x1600", *entries) + COE)
    remarks = tuple(remark for remark in found.remarks if "is in none of the assigned RxPDOs" not in remark)
    return [item for sm in found.sync_managers for item in sm.entries][-1], remarks


@pytest.mark.parametrize(
    ("index", "subindex", "bits", "kind"),
    [
        ("#x607A", 0, 32, "int"),
        ("#x60FF", 0, 32, "int"),
        ("#x6064", 0, 32, "int"),
        ("#x606C", 0, 32, "int"),
        ("#x6071", 0, 16, "int"),
        ("#x6077", 0, 16, "int"),
        ("#x6060", 0, 8, "int"),
        ("#x6061", 0, 8, "int"),
        ("#x60E4", 3, 32, "int"),
        ("#x60C2", 2, 8, "int"),
        ("#x60C2", 1, 8, "uint"),
        ("#x6041", 0, 16, "uint"),
        ("#x60FD", 0, 32, "uint"),
        ("#x6081", 0, 32, "uint"),
        ("#x6072", 0, 16, "uint"),
        ("#x60C1", 0, 8, "uint"),  # how many set-points there are
        ("#x68FF", 0, 32, "uint"),  # of an axis that there is no evidence for
        ("#x2000", 0, 32, "uint"),
    ],
)
def test_a_value_declared_by_its_length_has_the_sign_of_the_profile(index, subindex, bits, kind):
    """``ethercat xml`` of IgH writes UINT and the length for everything."""
    for data_type in (f"UINT{bits}", ""):
        found, remarks = one(CONTROLWORD, entry(index, bits, "n", subindex, data_type))
        assert (found.value.kind, found.value.bit_length) == (kind, bits)
        assert bool(remarks) == (kind == "int" and bool(data_type))


def test_the_remark_says_what_is_declared_and_what_is_taken():
    assert one(CONTROLWORD, entry("#x60FF", 32, "Target velocity", data_type="UINT32"))[1] == (REMARK,)
    for data_type in ("DINT", ""):
        assert one(CONTROLWORD, entry("#x60FF", 32, "Target velocity", data_type=data_type))[1] == ()


def test_each_axis_has_its_own_objects():
    found, remarks = one(
        entry("#x6840", 16, data_type="UINT"), entry("#x68FF", 32, "Target velocity", data_type="UDINT")
    )
    assert (found.identifier, found.value.kind) == ("target_velocity_axis1", "int")
    assert remarks == (REMARK.replace("0x60FF", "0x68FF"),)


def test_without_evidence_of_an_axis_nothing_but_the_declaration_counts():
    found, remarks = one(entry("#x60FF", 32, data_type="UDINT"))
    assert (found.value.kind, remarks) == ("uint", ())


@pytest.mark.parametrize(
    ("index", "bits", "data_type", "kind", "words"),
    [
        ("#x6077", 32, "DINT", "int", "declared DINT, 32 bits; CiA 402 has INTEGER16"),
        ("#x6077", 32, "UDINT", "uint", "declared UDINT, 32 bits; CiA 402 has INTEGER16"),
        ("#x6077", 32, "", "uint", "no type is declared, 32 bits; CiA 402 has INTEGER16"),
        ("#x60FF", 32, "REAL", "real", "declared REAL; CiA 402 has INTEGER32"),
    ],
)
def test_another_length_or_kind_stays_as_declared_with_a_remark(index, bits, data_type, kind, words):
    found, remarks = one(CONTROLWORD, entry(index, bits, data_type=data_type))
    assert found.value.kind == kind
    (remark,) = remarks
    assert remark == f"0x{index[2:]}:00: {words}, which is not taken: check it on the device"


BESIDE = "CiA 402 has INTEGER32 (at subindex 0 only, and no dictionary has subindex "
SUB_ITEMS = "".join(
    f"<SubItem><SubIdx>{subindex}</SubIdx><Name>s</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>"
    f"<BitOffs>{16 * subindex}</BitOffs></SubItem>"
    for subindex, kind, bits in ((0, "USINT", 8), (1, "UDINT", 32))
)
RECORD = (
    f"<DataTypes><DataType><Name>DT607A</Name><BitSize>48</BitSize>{SUB_ITEMS}</DataType></DataTypes><Objects><Object>"
    "<Index>#x607A</Index><Name>o</Name><Type>DT607A</Type><BitSize>48</BitSize></Object></Objects>"
)
VALUE = "<Objects><Object><Index>#x607A</Index><Name>o</Name><Type>UDINT</Type><BitSize>32</BitSize></Object></Objects>"


TAKEN = "which is taken: check on the device what is mapped"


@pytest.mark.parametrize(
    ("objects", "subindex", "bits", "data_type", "kind", "words"),
    [
        (VALUE, 4, 32, "UDINT", "int", f"declared UDINT; {BESIDE}4), {TAKEN}"),
        ("", 4, 32, "", "int", f"no type is declared; {BESIDE}4), {TAKEN}"),
        (VALUE, 4, 32, "DINT", "int", f"declared DINT; {BESIDE}4), {TAKEN}"),
        (
            VALUE,
            1,
            16,
            "UINT",
            "uint",
            f"declared UINT, 16 bits; {BESIDE}1), which is not taken: check it on the device",
        ),
        (RECORD, 1, 32, "UDINT", "uint", None),
        (VALUE, 1, 32, "REAL", "real", None),
    ],
)
def test_a_subindex_beside_a_single_value_has_its_sign_unless_it_is_described(
    objects, subindex, bits, data_type, kind, words
):
    """0x607A is a VAR. Files of real drives map their targets at subindices that nothing has, others as REAL."""
    position = entry("#x607A", bits, "Target", subindex, data_type)
    profile = f"<Profile><ProfileNo>402</ProfileNo><Dictionary>{objects}</Dictionary></Profile>"
    found = configured(profile + SMS + rx("#x1600", CONTROLWORD, position) + COE)
    assert [item for sm in found.sync_managers for item in sm.entries][-1].value.kind == kind
    assert found.remarks == ((f"0x607A:0{subindex} Target: {words}",) if words is not None else ())


@pytest.mark.parametrize(
    ("generate", "signed"),
    [
        (igh_header, "EC_WRITE_S32("),
        (soem_header, "int32_t target_velocity;"),
        (pysoem_module, '("target_velocity", ctypes.c_int32)'),
        (ros2_slave, "type: int32, command_interface: velocity"),
        (linuxcnc_configuration, 'halPin="target-velocity" halType="s32"'),
    ],
)
def test_every_export_has_the_sign_and_says_so(generate, signed):
    velocity = entry("#x60FF", 32, "Target velocity", data_type="UINT32")
    text = generate(configured(SMS + rx("#x1600", CONTROLWORD, velocity) + COE))
    assert signed in text
    assert REMARK in " ".join(text.replace("\n *", "").replace("\n#", "").split())


def test_every_typed_object_has_a_name():
    assert SIGNED_OBJECTS.keys() <= CIA402_NAMES.keys()
