"""What the RxPDOs of a process image command of a CiA 402 axis: its controlword, its mode and its setpoints."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from esicatalog.esi.records.pdo import RX_PDO, Pdo
from esicatalog.model.assignable_pdos import AvailablePdo
from esicatalog.model.cia402 import AXIS_STEP, CONTROLWORD, DRIVE_MODES, MODE_BY_CODE, MODES_OF_OPERATION, STATUSWORD
from esicatalog.model.pdo_facts import carries_value, symmetric_exclusions

SETPOINTS = frozenset(index for mode in DRIVE_MODES.values() for index in mode.setpoints)
"""Those of all modes, by the objects of the first axis."""


class AxisOutputs(NamedTuple):
    """The objects of an axis that RxPDOs map, at the indices that they have on that axis."""

    axis: int
    mapped: frozenset[int]
    """Those that are mapped, whatever their subindex: that of a single value may be mistaken."""
    setpoints: frozenset[int]
    """Those of them that are setpoints."""

    def at(self, index: int) -> int:
        """Where an object of the first axis lies on this one."""
        return index + self.axis * AXIS_STEP

    @property
    def has_controlword(self) -> bool:
        """Whether a controlword is sent."""
        return self.at(CONTROLWORD) in self.mapped

    @property
    def has_mode(self) -> bool:
        """Whether the mode is sent in every cycle."""
        return self.at(MODES_OF_OPERATION) in self.mapped

    @property
    def is_commanded(self) -> bool:
        """Whether a controlword or setpoint is sent; some drives have setpoints of their vendor's."""
        return self.has_controlword or bool(self.setpoints)

    @property
    def lacks_controlword(self) -> bool:
        """Whether there is a setpoint and nothing that enables the drive."""
        return bool(self.setpoints) and not self.has_controlword

    def suits(self, code: int) -> bool:
        """Whether the mode of a code uses the setpoints that are mapped, as far as both are known."""
        mode = MODE_BY_CODE.get(code)
        if mode is None or not self.setpoints:
            return True
        return bool(mode.setpoints) and self.setpoints.issuperset(map(self.at, mode.setpoints))


def axis_outputs(axis: int, rx_pdos: Iterable[Pdo]) -> AxisOutputs:
    """What these RxPDOs map of an axis."""
    entries = (entry for pdo in rx_pdos for entry in pdo.entries if carries_value(entry))
    mapped = frozenset([entry.entry_index for entry in entries if entry.entry_index])
    setpoints = frozenset([index + axis * AXIS_STEP for index in SETPOINTS])
    return AxisOutputs(axis, mapped, setpoints & mapped)


def no_controlword_words(outputs: AxisOutputs, available: Sequence[AvailablePdo], assigned: Iterable[Pdo]) -> str:
    """That the controlword is missing, or that the two words are swapped, as they are in real robot joints.

    ``available`` are all PDOs of the device and its modules, ``assigned`` the RxPDOs of which the outputs are.
    """
    index, other = outputs.at(CONTROLWORD), outputs.at(STATUSWORD)
    without = f"the controlword 0x{index:04X} is in none of the assigned RxPDOs"
    if other in outputs.mapped:
        return f"{without}, but the statusword 0x{other:04X} is: check whether the two are swapped"
    exclusions = symmetric_exclusions(item.pdo for item in available)
    excluded = {rival for pdo in assigned for rival in exclusions.get(pdo.pdo_index, ())}
    rx_pdos = [item.pdo for item in available if item.direction == RX_PDO and item.pdo.pdo_index is not None]
    having = [pdo.pdo_index for pdo in rx_pdos if index in axis_outputs(outputs.axis, (pdo,)).mapped]
    free = [pdo_index for pdo_index in having if pdo_index not in excluded]
    if free:
        where = f"RxPDO 0x{free[0] or 0:04X} has it"
    else:
        where = "no RxPDO that may be beside them has it" if having else "no RxPDO has it"
    return f"{without}, by which a drive is enabled: {where}"
