"""What the RxPDOs of a process image command of a CiA 402 axis: its controlword, its mode and its setpoints."""

from collections.abc import Iterable
from typing import NamedTuple

from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.cia402 import AXIS_STEP, CONTROLWORD, DRIVE_MODES, MODE_BY_CODE, MODES_OF_OPERATION, STATUSWORD
from esicatalog.model.pdo_facts import carries_value

SETPOINTS = frozenset(index for mode in DRIVE_MODES.values() for index in mode.setpoints)
"""Those of all modes, by the objects of the first axis."""


class AxisOutputs(NamedTuple):
    """The objects of an axis that RxPDOs map, at the indices that they have on that axis."""

    axis: int
    values: frozenset[int]
    """Those that are mapped as a single value."""
    setpoints: frozenset[int]
    """Those that are setpoints, whatever their subindex: some have elements."""

    def at(self, index: int) -> int:
        """Where an object of the first axis lies on this one."""
        return index + self.axis * AXIS_STEP

    @property
    def has_mode(self) -> bool:
        """Whether the mode is sent in every cycle."""
        return self.at(MODES_OF_OPERATION) in self.values

    @property
    def is_commanded(self) -> bool:
        """Whether a controlword or setpoint is sent; some drives have setpoints of their vendor's."""
        return self.at(CONTROLWORD) in self.values or bool(self.setpoints)

    @property
    def lacks_controlword(self) -> bool:
        """Whether there is a setpoint and nothing that enables the drive."""
        return bool(self.setpoints) and self.at(CONTROLWORD) not in self.values

    def suits(self, code: int) -> bool:
        """Whether the mode of a code uses the setpoints that are mapped, as far as both are known."""
        mode = MODE_BY_CODE.get(code)
        if mode is None or not self.setpoints:
            return True
        return bool(mode.setpoints) and self.setpoints.issuperset(map(self.at, mode.setpoints))


def axis_outputs(axis: int, rx_pdos: Iterable[Pdo]) -> AxisOutputs:
    """What these RxPDOs map of an axis."""
    mapped = [entry for pdo in rx_pdos for entry in pdo.entries if carries_value(entry)]
    values = frozenset([entry.entry_index for entry in mapped if entry.entry_index and not entry.subindex])
    indices = {entry.entry_index for entry in mapped}
    setpoints = frozenset([index + axis * AXIS_STEP for index in SETPOINTS if index + axis * AXIS_STEP in indices])
    return AxisOutputs(axis, values, setpoints)


def no_controlword_words(outputs: AxisOutputs, rx_pdos: Iterable[Pdo]) -> str:
    """That nothing enables the drive, or that the two words are swapped, as they are in real robot joints.

    ``rx_pdos`` are all that can be assigned.
    """
    index, other = outputs.at(CONTROLWORD), outputs.at(STATUSWORD)
    without = f"the controlword 0x{index:04X} is in none of the assigned RxPDOs"
    if other in outputs.values:
        return f"{without}, but the statusword 0x{other:04X} is: check whether the two are swapped"
    has_it = (pdo.pdo_index for pdo in rx_pdos if index in axis_outputs(outputs.axis, (pdo,)).values)
    found = next((pdo_index for pdo_index in has_it if pdo_index is not None), None)
    where = f"RxPDO 0x{found:04X} has it" if found is not None else "no RxPDO has it"
    return f"{without}, and without it nothing enables the drive: {where}"
