"""Everything that a description implies without any choice: default process image, drive modes, facts."""

from collections.abc import Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.device_facts import DeviceFacts, device_facts
from esicatalog.model.drive_modes import DriveModes, drive_modes
from esicatalog.model.process_image import SmImage, default_process_image


class Derivation(NamedTuple):
    """What follows from a device with the modules its slots can reach."""

    images: list[SmImage]
    """Default process image: default OpMode, default modules."""
    modes: DriveModes
    facts: DeviceFacts


def derive(device: Device, modules: Sequence[Module] = ()) -> Derivation:
    """Derive what the catalog stores beside a description."""
    images = default_process_image(device, modules)
    modes = drive_modes(device, modules)
    return Derivation(images, modes, device_facts(device, modules, images, modes))
