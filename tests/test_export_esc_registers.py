"""Initial values of ESC registers: what each target writes, and what it says about the rest."""

import pytest
from test_export_configuration import SMS, configured, entry, rx

from esicatalog.export.configuration import Configuration
from esicatalog.export.igh import igh_bus_header, igh_header
from esicatalog.export.linuxcnc import linuxcnc_configuration
from esicatalog.export.pysoem import pysoem_module
from esicatalog.export.ros2 import ros2_slave
from esicatalog.export.scan_bus import BusConfigurations
from esicatalog.export.soem import soem_header


def igh_bus(found: Configuration) -> str:
    return igh_bus_header(BusConfigurations([found], [], []))


TARGETS = [igh_header, igh_bus, soem_header, pysoem_module, ros2_slave, linuxcnc_configuration]
LEFT_OUT_WORDS = {
    0x0108: "Physical read/write offset, register 0x0108: the value {} is left out",
    0x0400: "Watchdog divider, register 0x0400: the value {} is left out",
    0x0410: "PDI watchdog, register 0x0410: the value {} is left out",
    0x0420: "Process data watchdog, register 0x0420: the value {} is left out",
}


def with_registers(values: dict[int, int]) -> Configuration:
    given = "".join(f"<Reg{register:04x}>{value}</Reg{register:04x}>" for register, value in values.items())
    return configured(SMS + rx("#x1600", entry("#x7000", 8, "v", 1)) + f"<ESC>{given}</ESC>")


def named(text: str, values: dict[int, int]) -> set[int]:
    """Registers that a file says to be left out."""
    words = " ".join(text.replace("\n *", " ").replace("\n#", " ").split())
    return {register for register, value in values.items() if LEFT_OUT_WORDS[register].format(value) in words}


@pytest.mark.parametrize(
    ("target", "left_out"),
    [
        (igh_header, {0x0108, 0x0410}),
        (igh_bus, {0x0108, 0x0410}),
        (linuxcnc_configuration, {0x0108, 0x0410}),
        (soem_header, {0x0108}),
        (pysoem_module, {0x0108}),
        (ros2_slave, {0x0108, 0x0400, 0x0410, 0x0420}),
    ],
)
def test_what_a_target_cannot_set_is_told(target, left_out):
    values = {0x0108: 512, 0x0400: 2498, 0x0410: 1000, 0x0420: 100}
    assert named(target(with_registers(values)), values) == left_out


@pytest.mark.parametrize(
    ("target", "left_out"),
    [
        (igh_header, {0x0400, 0x0420}),
        (linuxcnc_configuration, {0x0400, 0x0420}),
        (soem_header, {0x0400}),
        (pysoem_module, {0x0400}),
    ],
)
def test_values_that_cannot_be_written(target, left_out):
    """IgH takes 0 for "as it is", which is not what 0 in the description means; no register has more than 16 bits."""
    values = {0x0400: 70_000, 0x0420: 0}
    assert named(target(with_registers(values)), values) == left_out


@pytest.mark.parametrize("target", TARGETS)
def test_nothing_is_said_where_nothing_is_given(target):
    assert "is left out" not in target(with_registers({}))
