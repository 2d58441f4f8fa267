"""The modules of a device as its objects 0xF030 and 0xF050 name them: their ModuleIdents, slot by slot (ETG.5001)."""

from collections.abc import Iterable

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.profile import declared_objects
from esicatalog.model.slots import PluggedModule, numbered_slots
from esicatalog.model.start_up import TRANSITIONS
from esicatalog.words import counted, hex32

MODULE_IDENT_LIST = 0xF030
"""What is configured; the master writes it where Slots/@DownloadModuleIdentList says so."""
_DETECTED_MODULES = 0xF050
_MOST_SUBINDICES = 255
_MOST_SHOWN = 24


def module_idents(device: Device, plugged: Iterable[PluggedModule]) -> list[int]:
    """The idents up to the last plugged module, of subindex 1 and so on; 0 for an empty slot."""
    idents = {item.slot_number: item.module.module_ident or 0 for item in plugged}
    count = min(max(idents, default=-1) + 1, _MOST_SUBINDICES)
    return [idents.get(number, 0) for number, _, _ in numbered_slots(device)][:count]


def list_transition(device: Device) -> str:
    """When the list is written; PS where the description says nothing or no transition."""
    transition = (device.download_module_list_transition or "PS").upper()
    return transition if transition in TRANSITIONS else "PS"


def module_idents_words(device: Device, plugged: Iterable[PluggedModule]) -> str | None:
    """What the device has to hold of its modules, for people; None without any, or without such objects."""
    idents = module_idents(device, plugged)
    if not idents:
        return None
    described = {item.object_index for item in declared_objects(device.profiles)}
    places = []
    if device.download_module_ident_list:
        places.append(f"0x{MODULE_IDENT_LIST:04X} (configured; exports write it at {list_transition(device)})")
    elif MODULE_IDENT_LIST in described:
        places.append(f"0x{MODULE_IDENT_LIST:04X} (configured)")
    if _DETECTED_MODULES in described:
        places.append(f"0x{_DETECTED_MODULES:04X} (detected)")
    if not places:
        return None
    shown = ", ".join(hex32(ident) if ident else "0" for ident in idents[:_MOST_SHOWN])
    more = f" and {counted(len(idents) - _MOST_SHOWN, 'more slot')}" if len(idents) > _MOST_SHOWN else ""
    return f"{shown}{more}, expected in {' and '.join(places)}"
