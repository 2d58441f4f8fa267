"""Signs of FSoE (Safety over EtherCAT) in a description (ESI-FACTS section 19). Not a safety statement.

High: the description uses the schema's safety elements. Medium: process data or objects look like an FSoE connection.
"""

import re
from collections.abc import Iterator, Sequence

from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo

HIGH, MEDIUM = "high", "medium"
NOT_A_STATEMENT = "not a safety statement"

_SAFETY_OBJECTS = (0xF980, 0xE901, 0xE600, 0xE700)
_SAFETY_ADD_INFOS = (190, 290, 1904)
_FSOE = re.compile(r"\bFSoE\b|\bConn?ID\b", re.IGNORECASE)
_CRC = re.compile(r"\bCRC[_ ]?0\b", re.IGNORECASE)


def fsoe_evidence(device: Device, modules: Sequence[Module] = ()) -> tuple[str | None, str | None]:
    """Level (high, medium or None) and words; the words end with what they are not."""
    for level, find in ((HIGH, _high), (MEDIUM, _medium)):
        owners: tuple[Device | Module, ...] = (device, *modules)
        for owner in owners:
            words = next(find(owner), None)
            if words is not None:
                place = "" if owner is device else f" in module 0x{getattr(owner, 'module_ident', None) or 0:X}"
                return level, f"{words}{place}; {NOT_A_STATEMENT}"
    return None, None


def _pdos(owner: Device | Module) -> tuple[Pdo, ...]:
    return (*owner.rx_pdos, *owner.tx_pdos)


def _high(owner: Device | Module) -> Iterator[str]:
    if isinstance(owner, Module) and owner.safety_para_mappings:
        yield "SafetyParaMapping"
    for pdo in _pdos(owner):
        if pdo.safety_pdo_type:
            yield f"PDO 0x{pdo.pdo_index or 0:04X} has SafetyPdoType {pdo.safety_pdo_type}"
        if any(entry.safety_conn_number is not None for entry in pdo.entries):
            yield f"PDO 0x{pdo.pdo_index or 0:04X} has entries with SafetyConnNumber"
    for profile in owner.profiles:
        if profile.dictionary is None:
            continue
        for data_type in profile.dictionary.data_types:
            if any(item.flags is not None and item.flags.safety_mapping for item in data_type.sub_items):
                yield f"data type {data_type.name} has SafetyMapping"
        for declared in profile.dictionary.objects:
            if declared.flags is not None and declared.flags.safety_mapping:
                yield f"object 0x{declared.object_index or 0:04X} has SafetyMapping"


def _medium(owner: Device | Module) -> Iterator[str]:
    for pdo in _pdos(owner):
        names = [display_text(pdo.names) or "", *(display_text(entry.names) or "" for entry in pdo.entries)]
        if any(map(_FSOE.search, names)) and any(map(_CRC.search, names)):
            yield f"PDO 0x{pdo.pdo_index or 0:04X} has the names of an FSoE frame"
    for profile in owner.profiles:
        numbers = [(profile.profile_no, profile.add_info)]
        numbers += [(channel.profile_no, channel.add_info) for channel in profile.channel_infos]
        for profile_no, add_info in numbers:
            if profile_no == 5001 and add_info in _SAFETY_ADD_INFOS:
                yield f"module profile 5001/{add_info}"
        objects = profile.dictionary.objects if profile.dictionary is not None else ()
        for declared in objects:
            if declared.object_index in _SAFETY_OBJECTS:
                yield f"object 0x{declared.object_index:04X}"
