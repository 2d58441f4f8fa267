"""Which RxPDOs to choose for a setpoint that is not assigned by default: a choice replaces all of a SyncManager."""

from collections.abc import Collection, Sequence

from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.axis_outputs import SETPOINTS
from esicatalog.model.cia402 import AXIS_STEP, CONTROLWORD, MODES_OF_OPERATION
from esicatalog.model.drive_setup import DriveSetup

_Places = Collection[tuple[int | None, int]]


def chosen_with(pdos: Sequence[Pdo], axis: int, setup: DriveSetup) -> list[Pdo]:
    """The RxPDOs of a setpoint of an axis and those beside them that their SyncManagers have in a setup, by index.

    What has the controlword stays. What maps an object again does not, for every copy would be sent, and neither does
    the setpoint of another mode, unless its RxPDO has 0x6060; nor what exports would refuse beside the others.
    """
    chosen = list(pdos)
    for pdo in setup.beside_by_default(pdos):
        if (pdo.mandatory or _stays(pdo, chosen, axis)) and setup.takes(pdo, chosen):
            chosen.append(pdo)
    return sorted(chosen, key=lambda pdo: pdo.pdo_index or 0)


def _stays(pdo: Pdo, chosen: Sequence[Pdo], axis: int) -> bool:
    shift = axis * AXIS_STEP
    own, others = _places([pdo]), _places(chosen)
    if (CONTROLWORD + shift, 0) in own and (CONTROLWORD + shift, 0) not in others:
        return True
    is_other_setpoint = any(index is not None and index - shift in SETPOINTS for index, _ in own)
    return not any(place in others for place in own) and (
        not is_other_setpoint or (MODES_OF_OPERATION + shift, 0) in own
    )


def _places(pdos: Sequence[Pdo]) -> _Places:
    return {(entry.entry_index, entry.subindex or 0) for pdo in pdos for entry in pdo.entries if entry.entry_index}
