"""Which RxPDOs to choose for a setpoint that is not assigned by default: a choice replaces all of a SyncManager."""

from collections.abc import Sequence

from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.axis_outputs import axis_outputs
from esicatalog.model.drive_setup import DriveSetup


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
    own, others = axis_outputs(axis, [pdo]), axis_outputs(axis, chosen)
    if own.has_controlword and not others.has_controlword:
        return True
    return _places([pdo]).isdisjoint(_places(chosen)) and (not own.setpoints or own.has_mode)


def _places(pdos: Sequence[Pdo]) -> set[tuple[int, int]]:
    return {(entry.entry_index, entry.subindex or 0) for pdo in pdos for entry in pdo.entries if entry.entry_index}
