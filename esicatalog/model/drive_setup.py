"""What an export of a recipe would make: its modules, its OpMode, the process image and the commands that follow."""

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import COE, InitCmd
from esicatalog.esi.records.pdo import RX_PDO, Pdo
from esicatalog.model.assignable_pdos import (
    AvailablePdo,
    Beside,
    assignment_place,
    available_pdos,
    excluded_beside,
    meant_by_index,
)
from esicatalog.model.cia402 import DriveMode
from esicatalog.model.drive_parts import Part
from esicatalog.model.pdo_facts import mapped_entries, symmetric_exclusions
from esicatalog.model.process_image import SmImage, assigned_indices, placed_rx_pdos, process_image, repeated_indices
from esicatalog.model.slots import PluggedModule, expand_module
from esicatalog.model.start_up import all_init_cmds
from esicatalog.model.sync import asked_op_modes, default_position, op_mode_at, op_mode_choice, positions_with_sync0


class DriveSetup:
    """A device with certain modules in an OpMode, no PDOs chosen."""

    def __init__(
        self, device: Device, plugged: Sequence[PluggedModule], position: int | None, images: Sequence[SmImage] | None
    ) -> None:
        self.device = device
        self._plugged = plugged
        self._position = position
        self._images = images

    @cached_property
    def images(self) -> Sequence[SmImage]:
        """Its process image."""
        if self._images is not None:
            return self._images
        return process_image(self.device, self._plugged, op_mode_at(self.device.op_modes, self._position))

    @cached_property
    def commanded(self) -> frozenset[int | None]:
        """The objects that its RxPDOs map."""
        return frozenset([entry.entry_index for pdo in placed_rx_pdos(self.images) for entry in pdo.entries])

    @cached_property
    def repeated(self) -> Collection[int]:
        """Indices that it assigns twice, which no export makes: they have to be chosen."""
        return repeated_indices(self.images)

    @cached_property
    def exclusions(self) -> dict[int | None, tuple[int, ...]]:
        """The PDOs that may not be assigned beside each."""
        return dict(symmetric_exclusions(item.pdo for item in self.available))

    @cached_property
    def available(self) -> list[AvailablePdo]:
        """The PDOs of the device and of its modules."""
        return available_pdos(self.device, self._plugged).pdos

    def beside(self, pdos: Iterable[Pdo]) -> list[Beside]:
        """What is assigned beside these RxPDOs where they are chosen, and excludes one of them."""
        chosen = {}
        for pdo in pdos:
            sm = self._place(pdo)
            if pdo.pdo_index is not None and sm is not None:
                chosen[pdo.pdo_index] = sm
        return list(excluded_beside(self.device, self.available, chosen, assigned_indices(self.images)))

    @property
    def op_mode_choice(self) -> str | None:
        """What chooses its OpMode."""
        return op_mode_choice(self.device.op_modes, self._position) if self._position is not None else None

    @property
    def op_mode_words(self) -> str | None:
        """Its OpMode in words, with what chooses it first."""
        op_mode = op_mode_at(self.device.op_modes, self._position)
        if op_mode is None:
            return None
        if not op_mode.name:
            return f"OpMode {self.op_mode_choice}"
        is_chosen_by_name = self.op_mode_choice == op_mode.name.strip()
        return f"OpMode {op_mode.name!r}" if is_chosen_by_name else f"OpMode {self.op_mode_choice} {op_mode.name!r}"

    @property
    def assigning(self) -> str:
        """What assigns the PDOs of its process image, as the end of a sentence: that OpMode, or nothing special."""
        default = default_position(self.device.op_modes, [item.module for item in self._plugged])
        is_default = _assigns_alike(self.device, self._position, default)
        return "by default" if is_default or self.op_mode_words is None else f"with {self.op_mode_words}"

    def obstacle(self, pdo: Pdo) -> str | None:
        """Why an RxPDO cannot be chosen beside what stays of the process image, None when it can."""
        meant = meant_by_index(self.available, pdo.pdo_index)
        if meant.found is None:
            return meant.obstacle
        if mapped_entries(meant.found.pdo.entries) != mapped_entries(pdo.entries):
            return "cannot be chosen: its index means the PDO that is described before it"
        place = assignment_place(self.device, meant.found.direction, meant.found.pdo)
        if place.sm is None:
            return place.obstacle
        for rival in self.beside([pdo]):
            if rival.is_mandatory or not rival.has_others:
                why = "which is mandatory" if rival.is_mandatory else f"the only one that SM{rival.sm} can have"
                return f"cannot be assigned beside 0x{rival.pdo_index:04X}, {why}"
        return None

    def takes(self, pdo: Pdo, chosen: Sequence[Pdo]) -> bool:
        """Whether an RxPDO can be chosen beside others that are."""
        rivals = self.exclusions.get(pdo.pdo_index, ())
        if any(other.pdo_index == pdo.pdo_index or other.pdo_index in rivals for other in chosen):
            return False
        beside = self.beside([*chosen, pdo])
        return self.obstacle(pdo) is None and not any(item.is_mandatory or not item.has_others for item in beside)

    def beside_by_default(self, pdos: Iterable[Pdo]) -> list[Pdo]:
        """The PDOs that the SyncManagers of these RxPDOs have without a choice; of samples the first."""
        numbers = {self._place(pdo) for pdo in pdos}
        placed = [item for image in self.images if image.sm in numbers for item in image.pdos]
        return [item.pdo for item in placed if item.sample <= 1 and self._place(item.pdo) in numbers]

    def rx_pdos(self, chosen: Sequence[Pdo]) -> list[Pdo]:
        """The RxPDOs that are assigned where these are chosen: they and what other SyncManagers keep beside them."""
        return placed_rx_pdos(self._images_of(chosen) if chosen else self.images)

    def _images_of(self, chosen: Sequence[Pdo]) -> Sequence[SmImage]:
        assignment: dict[int, list[int]] = {}
        for pdo in chosen:
            sm = self._place(pdo)
            if sm is not None and pdo.pdo_index is not None:
                assignment.setdefault(sm, []).append(pdo.pdo_index)
        op_mode = op_mode_at(self.device.op_modes, self._position)
        return process_image(self.device, self._plugged, op_mode, assignment)

    def _place(self, pdo: Pdo) -> int | None:
        return assignment_place(self.device, RX_PDO, pdo).sm

    @cached_property
    def commands(self) -> tuple[InitCmd, ...]:
        """Its CoE InitCmds in the order in which they are sent at one transition."""
        expanded = (expand_module(self.device, item) for item in self._plugged)
        return tuple([item.command for item in all_init_cmds(self.device, expanded) if item.protocol == COE])


class ConfiguredDrive:
    """A device whose setups are made once each; ``there`` are its default modules, ``images`` what they make."""

    def __init__(self, device: Device, there: Sequence[PluggedModule], images: Sequence[SmImage]) -> None:
        self.device = device
        self._there = there
        self._images = images
        self._default = default_position(device.op_modes, [item.module for item in there])
        self._setups: dict[tuple[int | None, int, int | None], DriveSetup] = {}

    def setup(self, mode: DriveMode, parts: Sequence[Part]) -> DriveSetup:
        """That for a mode of the parts that act together, a module last."""
        chosen = parts[-1].plugged
        others = {item.slot_number: item for item in self._there}
        plugged = others if chosen is None else others | {chosen.slot_number: chosen}
        by_slot = [plugged[number] for number in sorted(plugged)]
        positions = self._positions(mode, [chosen, *by_slot] if chosen is not None else by_slot)
        setups = [self._in_op_mode(position, chosen, by_slot) for position in positions]
        setpoint = {parts[-1].at(index) for index in mode.setpoints}
        return next((setup for setup in setups if setpoint <= setup.commanded), setups[0])

    def _in_op_mode(
        self, position: int | None, chosen: PluggedModule | None, by_slot: Sequence[PluggedModule]
    ) -> DriveSetup:
        key = (chosen.slot_number, id(chosen.module), position) if chosen is not None else (None, 0, position)
        if key not in self._setups:
            is_default = all(item in self._there for item in by_slot)
            images = self._images if is_default and _assigns_alike(self.device, position, self._default) else None
            self._setups[key] = DriveSetup(self.device, by_slot, position, images)
        return self._setups[key]

    def _positions(self, mode: DriveMode, plugged: Sequence[PluggedModule]) -> Sequence[int | None]:
        """Of the OpMode that a module asks for, else for cyclic modes of those with SYNC0, else of the default.

        Of several the first counts that assigns the setpoint, without any such the first.
        """
        modules = [item.module for item in plugged]
        asked = asked_op_modes(self.device.op_modes, modules).values()
        with_sync0 = positions_with_sync0(self.device) if mode.cyclic else []
        if with_sync0 and all(position is None for position in asked):
            return with_sync0
        return [default_position(self.device.op_modes, modules)]


def _assigns_alike(device: Device, one: int | None, other: int | None) -> bool:
    """Whether two OpModes make the same process image of the same modules: neither lists PDOs, or they are the same."""
    if one == other:
        return True
    both = (op_mode_at(device.op_modes, one), op_mode_at(device.op_modes, other))
    return not any(op_mode.sm_assignments for op_mode in both if op_mode is not None)
