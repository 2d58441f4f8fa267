"""What a device exchanges in cycles, and what follows from it; most devices share all of it with others.

Revisions and variants of a product seldom differ in their PDOs, SyncManagers and OpModes, so what follows from these is
computed once and kept.
"""

from collections.abc import Hashable, Iterable, Sequence
from functools import cached_property

import msgspec

from esicatalog.esi.content import digest
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.assignable_pdos import declares_pdo_upload
from esicatalog.model.image_layout import image_layouts, layout_signature
from esicatalog.model.memo import IdentityMemo, identities
from esicatalog.model.oversampling import has_oversampling
from esicatalog.model.pdo_facts import mapped
from esicatalog.model.process_image import SmImage, default_process_image
from esicatalog.model.slot_indices import IndicesInSlots
from esicatalog.model.slots import default_modules
from esicatalog.model.sm_facts import INPUT, OUTPUT
from esicatalog.model.sync import SyncSignals, default_position, generated_signals, op_mode_at, valid_op_modes

_MAX_KNOWN = 1_000

_encode = msgspec.msgpack.Encoder().encode


class ProcessData:
    """SyncManagers, PDOs, OpModes and modules of one device or of several that have equal ones."""

    def __init__(self, device: Device, modules: Sequence[Module] = ()) -> None:
        self._device = device
        self.modules = modules
        """Those that its slots can reach."""
        self.sync_managers: tuple[SyncManager, ...] = device.sync_managers
        self.rx_pdos: tuple[Pdo, ...] = device.rx_pdos
        self.tx_pdos: tuple[Pdo, ...] = device.tx_pdos
        self.op_modes: tuple[OpMode, ...] = device.op_modes
        self.is_modular = bool(device.slots)

    @cached_property
    def images(self) -> list[SmImage]:
        """The default process image."""
        return default_process_image(self._device, self.modules)

    @property
    def image_is_known(self) -> bool:
        """Whether that is all that is exchanged without a choice: what is not described may differ."""
        return None not in (self.byte_size(OUTPUT), self.byte_size(INPUT))

    @cached_property
    def in_slots(self) -> IndicesInSlots:
        """The indices that its modules can have in its slots."""
        return IndicesInSlots(self._device, self.modules)

    @cached_property
    def default_op_mode(self) -> OpMode | None:
        """The OpMode that counts without a choice."""
        return op_mode_at(self.op_modes, self.default_position)

    @cached_property
    def default_position(self) -> int | None:
        """Position of the OpMode that counts without a choice."""
        plugged = default_modules(self._device, self.modules) if self.modules else ()
        return default_position(self.op_modes, [item.module for item in plugged])

    @cached_property
    def signals(self) -> list[SyncSignals]:
        """What the OpModes make of the clocks."""
        return self._signals_of(self.op_modes)

    @cached_property
    def valid_signals(self) -> list[SyncSignals]:
        """The same of those OpModes that newer tools do not ignore; of all when they would ignore all."""
        return self._signals_of(valid_op_modes(self.op_modes))

    def _signals_of(self, op_modes: Iterable[OpMode]) -> list[SyncSignals]:
        return [generated_signals(mode, self._device.dc_time_loop_control_only) for mode in op_modes]

    def byte_size(self, transfer_direction: str) -> int | None:
        """Length of the default process image of all SyncManagers of one direction.

        None for PDOs without SyncManagers, and where the length of one of these is not known.
        """
        images = self._known_images(transfer_direction)
        return sum(image.described_bytes for image in images) if images is not None else None

    def bit_size(self, transfer_direction: str) -> int | None:
        """The same in bits, of which each SyncManager rounds its own up to bytes."""
        images = self._known_images(transfer_direction)
        return sum(image.bit_size for image in images) if images is not None else None

    def _known_images(self, transfer_direction: str) -> list[SmImage] | None:
        images = [image for image in self.images if image.transfer_direction == transfer_direction]
        pdos = (self.rx_pdos, self.tx_pdos, *(module.rx_pdos or module.tx_pdos for module in self.modules))
        is_known = all(image.has_known_size for image in images)
        return images if is_known and (self.sync_managers or not any(pdos)) else None

    @cached_property
    def image_signature(self) -> str | None:
        """Digest of the layout of the default process image, None where nothing is exchanged."""
        return layout_signature(image_layouts(self.images))

    @cached_property
    def pdo_signature(self) -> str | None:
        """Digest of all PDOs of the device itself with their entries, None without any; modules are not looked at."""
        layout = [
            [(pdo.pdo_index, [mapped(entry) for entry in pdo.entries]) for pdo in pdos]
            for pdos in (self.rx_pdos, self.tx_pdos)
        ]
        return digest(_encode(layout)).hex() if self.rx_pdos or self.tx_pdos else None


class SharedProcessData:
    """Gives devices their process data, the same to those that have equal ones."""

    def __init__(self) -> None:
        self._known: IdentityMemo[ProcessData] = IdentityMemo(_MAX_KNOWN)

    def of(self, device: Device, modules: Sequence[Module]) -> ProcessData:
        """The process data of a device with the modules that its slots can reach."""
        return self._known.get(_key(device, modules), (device, modules), ProcessData, device, modules)


def _key(device: Device, modules: Sequence[Module]) -> Hashable:
    if device.slots or has_oversampling(device):  # seldom equal in what slots and modules add, or the dictionary
        return id(device), identities(modules)
    small = (device.sync_managers, device.op_modes, device.module_pdo_group, device.module_pdo_groups)
    flags = (device.dc_time_loop_control_only, declares_pdo_upload(device))
    return identities(device.rx_pdos), identities(device.tx_pdos), _encode((*small, *flags))
