"""The modules that documents offer to devices: their own, and those of documents named by InfoReference."""

from collections.abc import Iterator
from itertools import compress
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import Document, EsiInfo
from esicatalog.esi.records.module import Module
from esicatalog.model.slots import ModuleVendor, accepts


class ModuleOffer(NamedTuple):
    """The modules that the devices of a section of a document can be given.

    Those of a document named by InfoReference have the vendor of that document (ESI-FACTS section 12).
    """

    modules: tuple[Module, ...]
    vendors: tuple[ModuleVendor, ...]

    def reached_by(self, device: Device) -> list[bool]:
        """Of each module whether a slot of the device accepts it."""
        slots = device.slots
        return [
            any(accepts(slot, module, vendor) for slot in slots)
            for module, vendor in zip(self.modules, self.vendors, strict=True)
        ]

    def reachable(self, device: Device) -> list[Module]:
        """The modules that the slots of the device can reach, in document order."""
        return list(compress(self.modules, self.reached_by(device))) if device.slots else []


def offered_devices(document: Document) -> Iterator[tuple[EsiInfo, Device, tuple[Module, ...], int]]:
    """Each device of a document with its section, the modules that its slots can reach, and the line of its element."""
    for info, lines, offer in zip(document.infos, document.device_lines, module_offers(document), strict=True):
        for device, line in zip(info.devices, lines, strict=True):
            yield info, device, tuple(offer.reachable(device)), line


def module_offers(document: Document) -> Iterator[ModuleOffer]:
    """What each section of a document offers."""
    referenced = zip(document.referenced_modules, document.referenced_vendor_ids, strict=True)
    for info, (modules, vendor_ids) in zip(document.infos, referenced, strict=True):
        own = info.vendor_id
        of_modules = [own] * len(info.modules) + [*vendor_ids]
        yield ModuleOffer((*info.modules, *modules), tuple([ModuleVendor(vendor_id, own) for vendor_id in of_modules]))
