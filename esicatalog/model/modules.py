"""Which modules a device can carry (ESI-FACTS section 12)."""

from collections.abc import Iterable

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module


def reachable_modules(device: Device, modules: Iterable[Module]) -> list[Module]:
    """The modules that any slot of the device accepts, by ModuleIdent or by ModuleClass, in the order given."""
    idents = {item.module_ident for slot in device.slots for item in slot.module_idents}
    classes = {item.module_class for slot in device.slots for item in slot.module_classes}
    classes.discard(None)
    idents.discard(None)
    if not idents and not classes:
        return []
    return [module for module in modules if module.module_ident in idents or module.module_class in classes]
