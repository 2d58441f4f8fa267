"""The Python module for pysoem: imported, and used with a slave that only remembers what it is told."""

import struct
import types

import pytest
from snippets import pdo
from test_export_compile import configurations, for_soem
from test_export_configuration import COE, FACTOR_1, SMS, configured, dc, entry, init_cmd, rx, times
from test_export_igh import HOSTILE, ODD, as_little_endian, l6n

from esicatalog.export.choice import parse_pdo_choice
from esicatalog.export.configuration import Configuration
from esicatalog.export.pysoem import pysoem_module
from esicatalog.model.sm_facts import INPUT, OUTPUT


class FakeSlave:
    """What pysoem 1.1 offers of a slave (CdefSlave), as far as modules use it."""

    def __init__(self, man: int, product_code: int) -> None:
        self.man, self.id = man, product_code
        self.calls: list[str] = []

    def sdo_write(self, index: int, subindex: int, data: bytes, ca: bool = False) -> None:
        assert 0 <= subindex <= 0xFF
        self.calls.append(f"sdo 0x{index:04x}:{subindex:02x}{' complete' if ca else ''} {data.hex()}")

    def dc_sync(self, act, sync0_cycle_time, sync0_shift_time=0, sync1_cycle_time=None) -> None:
        self.calls.append(f"dc {act} {sync0_cycle_time} {sync0_shift_time} {sync1_cycle_time}")

    def _fpwr(self, address: int, data: bytes, timeout_us: int = 2000) -> None:
        self.calls.append(f"register 0x{address:04x} {data.hex()}")


def imported(found: Configuration) -> types.ModuleType:
    module = types.ModuleType("generated")
    exec(compile(pysoem_module(found), "generated.py", "exec", dont_inherit=True), module.__dict__)
    return module


def module_of(content: str, **choice) -> types.ModuleType:
    return imported(configured(content, name="d", **choice))


def calls(module: types.ModuleType, *functions: str) -> list[str]:
    slave = FakeSlave(module.VENDOR_ID, module.PRODUCT_CODE)
    for function in functions:
        getattr(module, function)(slave)
    return slave.calls


def test_the_l6n_drive(data):
    module = imported(l6n(data, pdos=parse_pdo_choice("0x1601,0x1A01"), op_mode="DC", cycle_ns=500_000))
    assert (module.VENDOR_ID, module.PRODUCT_CODE, module.REVISION_NO) == (0x4321, 0xE2, 1)
    assert calls(module, "setup", "config_dc") == [
        "sdo 0x6060:00 08",
        "sdo 0x1c12:00 00",
        "sdo 0x1c13:00 00",
        "sdo 0x1601:00 00",
        "sdo 0x1601:01 10004060",
        "sdo 0x1601:02 2000ff60",
        "sdo 0x1601:03 08006060",
        "sdo 0x1601:00 03",
        "sdo 0x1a01:00 00",
        "sdo 0x1a01:01 10004160",
        "sdo 0x1a01:02 20006c60",
        "sdo 0x1a01:00 02",
        "sdo 0x1c12:01 0116",
        "sdo 0x1c12:00 01",
        "sdo 0x1c13:01 011a",
        "sdo 0x1c13:00 01",
        "dc True 500000 0 None",
    ]
    outputs = module.Outputs(controlword=6, target_velocity=-2, modes_of_operation=9)
    assert bytes(outputs).hex() == "0600feffffff09"
    inputs = module.Inputs.from_buffer_copy(bytes.fromhex("3712ffffffff"))
    assert (inputs.statusword, inputs.velocity_actual_value) == (0x1237, -1)


def test_the_structure_ends_before_a_pdo_without_described_entries():
    behind = rx("#x1601") + rx("#x1602", entry("#x7002", 16, "behind"), entry("#x7002", 4, "bits", 1))
    module = module_of(SMS + rx("#x1600", entry("#x7000", 16, "first")) + behind)
    assert bytes(module.Outputs(first=0x102)) == b"\2\1"
    assert not hasattr(module.Outputs, "behind") and not hasattr(module.Outputs, "bits")
    assert not hasattr(module_of(SMS + behind), "Outputs")


def test_another_device_is_refused(data):
    module = imported(l6n(data))
    slave = FakeSlave(0x4321, 0xE3)
    with pytest.raises(ValueError, match="another device: vendor 0x00004321, product 0x000000E3"):
        module.setup(slave)
    assert slave.calls == []


def test_values_wherever_they_lie():
    outputs = module_of(ODD).Outputs()
    outputs.flag = 1
    outputs.small = -5
    outputs.nibble = 0xFA
    outputs.shifted_real = 1.5
    outputs.rest = 5
    outputs.long_real = -0.25
    outputs.three_bytes = -70000
    outputs.text[:] = b"abc"
    outputs.one_more_bit = 0
    outputs.long_bits = bytes([1, 2, 3, 4, 5, 6, 7, 8, 0x3F])
    fields = (
        (1, 1),
        (0, 3),
        (-5, 12),
        (0xA, 4),
        (0x3FC00000, 32),
        (5, 4),
        (int.from_bytes(struct.pack("<d", -0.25), "little"), 64),
        (-70000, 24),
        (int.from_bytes(b"abc", "little"), 24),
        (0, 1),
        (int.from_bytes(bytes([1, 2, 3, 4, 5, 6, 7, 8, 0x3F]), "little"), 70),
    )
    image = as_little_endian(*fields)
    assert bytes(outputs) == image

    inputs_class = module_of(ODD.replace("RxPdo", "TxPdo").replace('Sm="2"', 'Sm="3"')).Inputs
    inputs = inputs_class.from_buffer_copy(image)
    assert (inputs.flag, inputs.small, inputs.nibble, inputs.shifted_real) == (1, -5, 0xA, 1.5)
    assert (inputs.rest, inputs.long_real, inputs.three_bytes, bytes(inputs.text)) == (5, -0.25, -70000, b"abc")
    assert (inputs.one_more_bit, inputs.long_bits) == (0, bytes([1, 2, 3, 4, 5, 6, 7, 8, 0x3F]))
    with pytest.raises(AttributeError):
        inputs.flag = 0


@pytest.mark.parametrize(
    ("mode", "made"),
    [
        (times("#x300", FACTOR_1, shift0="-5000"), ["dc True 1000000 -5000 None"]),
        (times("#x320", FACTOR_1), ["dc True 1000000 0 None", "register 0x0980 20"]),
        (times("#x700", FACTOR_1, FACTOR_1, shift1="20000"), ["dc True 1000000 0 20000"]),
        (times("#x730", 'Factor="-8">0', 'Factor="-1">0'), ["dc True 125000 0 875000", "register 0x0980 30"]),
        (times("#x120"), ["register 0x0980 2001"]),
    ],
)
def test_the_clocks(mode, made):
    module = module_of(SMS + dc(("m", mode)))
    assert calls(module, "config_dc") == made


def test_a_cycle_that_cannot_be_divided_is_refused():
    module = module_of(SMS + dc(("m", times("#x300", 'Factor="-3">0'))), cycle_ns=3_000)
    slave = FakeSlave(1, 1)
    module.config_dc(slave, 6_000)
    with pytest.raises(ValueError, match="multiple of 3"):
        module.config_dc(slave, 1_000)
    assert slave.calls == ["dc True 2000 0 None"]


@pytest.mark.parametrize(
    ("cycle_ns", "made"),
    [(1_000_000, "dc True 250000 0 750000"), (250_000, "dc True 250000 0 0"), (700_000, None), (125_000, None)],
)
def test_a_cycle_that_does_not_fit_a_fixed_sync0_is_refused(cycle_ns, made):
    """SYNC0 drifts against 700 µs; with 125 µs SYNC1, once in a bus cycle, lies before SYNC0."""
    module = module_of(SMS + dc(("m", times("#x700", ">250000", 'Factor="-1">0'))))
    slave = FakeSlave(1, 1)
    if made is None:
        with pytest.raises(ValueError, match="SYNC0"):
            module.config_dc(slave, cycle_ns)
    else:
        module.config_dc(slave, cycle_ns)
    assert slave.calls == ([made] if made else [])


def test_a_cycle_at_which_a_slower_sync1_does_not_follow_sync0_is_refused():
    """At 1 ms SYNC1, once in a bus cycle, is faster than SYNC0 and follows it; at 6 ms it would come 3 ms later."""
    module = module_of(SMS + dc(("m", times("#x700", ">3000000", 'Factor="-1">0'))))
    slave = FakeSlave(1, 1)
    module.config_dc(slave, 1_500_000)
    with pytest.raises(ValueError, match="SYNC1 is described slower than the SYNC0 cycle at this cycle_ns"):
        module.config_dc(slave, 6_000_000)
    assert slave.calls == ["dc True 3000000 0 0"]


def test_other_commands():
    coe = init_cmd("IP", "#x2001", "01") + init_cmd("SO", "#x2002", "0200", 'CompleteAccess="1"')
    soe = "<SoE><InitCmd Chn='1'><Transition>PS</Transition><IDN>32</IDN><Data>0B00</Data></InitCmd></SoE>"
    found = configured(
        SMS + f"<Mailbox><CoE>{coe}</CoE>{soe}</Mailbox><ESC><Reg0420>100</Reg0420></ESC>", name="d", cycle_ns=250_000
    )
    module = imported(found)
    assert calls(module, "setup", "send_so") == [
        "sdo 0x2001:01 01",
        "register 0x0420 6400",
        "sdo 0x2002:01 complete 0200",
    ]
    assert module.CYCLE_NS == 250_000
    assert "# - PS S-0-0032 channel 1 is left out: pysoem has no call for SoE" in pysoem_module(found)
    assert not hasattr(module, "Outputs")
    assert not hasattr(module, "config_dc")


def test_what_is_shared_within_a_byte_is_told():
    found = configured(SMS + pdo("RxPdo", "#x1600", 1, attributes='Sm="2"'))
    assert "the outputs take 1 bit:" in pysoem_module(found)
    assert bytes(imported(found).Outputs(bytes_0=(1,))) == b"\x01"


@pytest.mark.parametrize("name", [*HOSTILE, 'x """ y', "coding: latin-99", "\\N{no such name}", "nonlocal", "None"])
def test_names_of_a_vendor_break_nothing(name):
    entries = [entry("#x7000", 3 if number % 2 else 8, name, number) for number in range(1, 5)]
    command = init_cmd("PS", "#x2000", "01").replace("</InitCmd>", f"<Comment>{name}</Comment></InitCmd>")
    content = SMS + rx("#x1600", *entries, name=name) + dc((name, times("#x320", FACTOR_1)))
    module = module_of(content + COE.replace('"1"/>', f'"1">{command}</CoE>'))
    assert len(bytes(module.Outputs())) == 3
    assert "sdo 0x2000:01 01" in calls(module, "setup")


@pytest.mark.parametrize("name", ["Property", "From Buffer Copy", "ctypes", "self", "value", "Setter"])
@pytest.mark.parametrize("bits", [1, 8])
def test_names_that_the_generated_class_uses_itself(name, bits):
    entries = (entry("#x7000", bits, name, 1), entry("#x7000", 1, "Behind", 2), entry("#x7000", 2, "Last", 3))
    found = module_of(SMS + rx("#x1600", *entries)).Outputs
    image = found()
    image.behind, image.last = 1, 2
    value = 1 << bits | 2 << bits + 1
    assert bytes(image) == value.to_bytes(len(bytes(image)), "little")
    assert found.from_buffer_copy(bytes(image)).last == 2


def test_the_heading_names_the_source(data):
    lines = pysoem_module(l6n(data)).splitlines()
    assert any(line.endswith("l6n_drive.xml, line 22") for line in lines)
    assert "# Something may move: before the drive is enabled, its target must be set" in "\n".join(lines)


@pytest.mark.corpus
def test_modules_of_the_whole_corpus(corpus):
    for found in for_soem(configurations(corpus)):
        module = imported(found)
        for direction, name in ((OUTPUT, "Outputs"), (INPUT, "Inputs")):
            size = 0
            for sm in (sm for sm in found.sync_managers if sm.direction == direction and sm.pdos):
                size += -(-sm.placed_bit_size // 8)
                if not sm.is_described:
                    break
            assert (len(bytes(getattr(module, name)())) if hasattr(module, name) else 0) == size
        calls(module, "setup", *(["config_dc"] if hasattr(module, "config_dc") else []))
