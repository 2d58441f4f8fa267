"""Signs of FSoE (Safety over EtherCAT) in a description (ESI-FACTS section 19). Not a safety statement.

High: the description uses the schema's safety elements. Medium: process data or objects look like an FSoE connection.
"""

import re
from collections.abc import Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.dictionary import Dictionary
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.esi.records.profile import dictionaries_of
from esicatalog.model.dictionary_views import DictionaryView, DictionaryViews
from esicatalog.model.memo import IdentityMemo
from esicatalog.model.profile_facts import PROFILE_MODULAR, profile_numbers
from esicatalog.model.resolver import TypeSet

HIGH, MEDIUM = "high", "medium"
NOT_A_STATEMENT = "not a safety statement"

_MAX_PDOS = 20_000
_MAX_TYPE_SETS = 2_000

_SAFETY_OBJECTS = frozenset((0xF980, 0xE901, 0xE600, 0xE700))
_SAFETY_ADD_INFOS = (190, 290, 1904)
# Where words end: vendors write FSOE_ConnID and FSoEMaster as well as FSoE Master.
_FSOE = re.compile(r"(?<![a-z])FSoE", re.IGNORECASE)
_CONN_ID = re.compile(r"(?<![a-z])Conn?[_ ]?ID(?![a-z])", re.IGNORECASE)
_CRC_0 = re.compile(r"(?<![a-z])CRC[_ ]?0(?![a-z0-9])", re.IGNORECASE)


class FsoeEvidence(NamedTuple):
    """Level (high or medium) and words, which end with what they are not."""

    level: str
    words: str


class _Signs(NamedTuple):
    """What a part of a description says of FSoE, in words, by level."""

    high: str | None
    medium: str | None


class FsoeSigns:
    """Looks for signs of FSoE; in PDOs and dictionaries that descriptions share only once."""

    def __init__(self, views: DictionaryViews) -> None:
        self._views = views
        self._of_pdo: IdentityMemo[_Signs] = IdentityMemo(_MAX_PDOS)
        self._of_types: IdentityMemo[_Signs] = IdentityMemo(_MAX_TYPE_SETS)

    def evidence(self, device: Device, modules: Sequence[Module]) -> FsoeEvidence | None:
        """The first sign of the highest level, of the device before its modules."""
        owners: tuple[Device | Module, ...] = (device, *modules)
        for level, find in ((HIGH, self._high), (MEDIUM, self._medium)):
            for owner in owners:
                words = find(owner)
                if words is not None:
                    place = f" in module 0x{owner.module_ident or 0:X}" if isinstance(owner, Module) else ""
                    return FsoeEvidence(level, f"{words}{place}; {NOT_A_STATEMENT}")
        return None

    def _high(self, owner: Device | Module) -> str | None:
        if isinstance(owner, Module) and owner.safety_para_mappings:
            return "SafetyParaMapping"
        for pdo in (*owner.rx_pdos, *owner.tx_pdos):
            if (words := self._pdo(pdo).high) is not None:
                return words
        found = (self._dictionary(dictionary).high for dictionary in dictionaries_of(owner.profiles))
        return next(filter(None, found), None)

    def _medium(self, owner: Device | Module) -> str | None:
        for pdo in (*owner.rx_pdos, *owner.tx_pdos):
            if (words := self._pdo(pdo).medium) is not None:
                return words
        for profile in owner.profiles:
            for profile_no, add_info in profile_numbers((profile,)):
                if profile_no == PROFILE_MODULAR and add_info in _SAFETY_ADD_INFOS:
                    return f"module profile {profile_no}/{add_info}"
            if profile.dictionary is not None and (words := self._dictionary(profile.dictionary).medium) is not None:
                return words
        return None

    def _pdo(self, pdo: Pdo) -> _Signs:
        return self._of_pdo.of(pdo, _pdo_signs)

    def _dictionary(self, dictionary: Dictionary) -> _Signs:
        return self._views.view(dictionary).once(self._dictionary_signs)

    def _dictionary_signs(self, view: DictionaryView) -> _Signs:
        of_types = self._of_types.of(view.types, _type_signs)
        of_objects = _object_signs(view)
        return _Signs(of_types.high or of_objects.high, of_objects.medium)


def _pdo_signs(pdo: Pdo) -> _Signs:
    high = medium = None
    words = f"PDO 0x{pdo.pdo_index or 0:04X}"
    if pdo.safety_pdo_type:
        high = f"{words} has SafetyPdoType {pdo.safety_pdo_type}"
    elif pdo.safety_conn_number is not None:
        high = f"{words} has SafetyConnNumber {pdo.safety_conn_number}"
    elif any(entry.safety_conn_number is not None for entry in pdo.entries):
        high = f"{words} has entries with SafetyConnNumber"
    names = [name.text for names in (pdo.names, *[entry.names for entry in pdo.entries]) for name in names]
    text = "\n".join(names)
    lowered = text.lower()
    # Few names have such words, and that is told fastest without an expression.
    if "fsoe" in lowered and _FSOE.search(text):
        medium = f"{words} has the name {next(filter(_FSOE.search, names))!r}"
    elif "crc" in lowered and _CRC_0.search(text) and _CONN_ID.search(text):
        medium = f"{words} has the names of an FSoE frame, ConnID and CRC_0"
    return _Signs(high, medium)


def _type_signs(types: TypeSet) -> _Signs:
    names = (
        data_type.name
        for data_type in types.data_types
        for item in data_type.sub_items
        if item.flags is not None and item.flags.safety_mapping
    )
    return _Signs(next((f"data type {name} has SafetyMapping" for name in names), None), None)


def _object_signs(view: DictionaryView) -> _Signs:
    mapped = (
        declared.object_index or 0
        for declared in view.dictionary.objects
        if declared.flags is not None and declared.flags.safety_mapping
    )
    high = next((f"object 0x{index:04X} has SafetyMapping" for index in mapped), None)
    if view.by_index.keys().isdisjoint(_SAFETY_OBJECTS):
        return _Signs(high, None)
    medium = next(f"object 0x{index:04X}" for index in view.by_index if index in _SAFETY_OBJECTS)
    return _Signs(high, medium)
