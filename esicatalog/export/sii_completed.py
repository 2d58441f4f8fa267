"""The image of a description for comparison with one of a device, which gives what the description does not say."""

from collections.abc import Iterable, Iterator
from itertools import chain, repeat
from typing import TypeVar

import msgspec

from esicatalog.esi.binding import Record
from esicatalog.esi.records.common import ENGLISH
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.device import Fmmu as EsiFmmu
from esicatalog.esi.records.device import SyncManager as EsiSyncManager
from esicatalog.esi.records.pdo import Entry
from esicatalog.esi.records.pdo import Pdo as EsiPdo
from esicatalog.export.sii import FMMU_USAGE_CODES, described_image, op_modes_of_image
from esicatalog.export.sii_changes import numbered_pdos
from esicatalog.export.sii_header import configuration_bytes, words_not_given
from esicatalog.export.sii_merge import merged_general, merged_header
from esicatalog.export.subject import Subject
from esicatalog.model.eeprom_pdos import stored_pdos, whole_image
from esicatalog.sii.codes import AssignActivate, SmEnable
from esicatalog.sii.image import (
    Category,
    DistributedClocks,
    Fmmus,
    General,
    RxPdos,
    SiiImage,
    SyncManagers,
    TxPdos,
)
from esicatalog.sii.layout import SiiRecord
from esicatalog.sii.records import DcMode, Fmmu, Pdo, PdoEntry, SyncManager

_STORED_AS: dict[type[Record], dict[str, str]] = {
    Device: {"physics": "physical_ports", "e_bus_current_ma": "e_bus_current_ma"},
    EsiSyncManager: {"start_address": "start_address", "default_size": "length_bytes", "control_byte": "control_byte"},
    Entry: {"subindex": "subindex", "bit_length": "bit_length"},
    OpMode: {"assign_activate": "assign_activate"},
}
"""What a description can leave out, by the field that an image stores it in; Enable of Sm is one bit of its field."""

S = TypeVar("S", bound=SiiRecord)
T = TypeVar("T")


def described_images(subject: Subject, image: SiiImage) -> Iterator[SiiImage]:
    """The image of the description in each of its languages, with what it does not say taken from ``image``.

    Raises :class:`SiiImageError` when the description holds a whole image (Eeprom/Data) that is none.
    """
    device = subject.device
    for language in _languages(subject):
        computed = described_image(subject, language=language, like=image)
        yield computed if whole_image(device) is not None else _completed_image(computed, device, image)


def _languages(subject: Subject) -> Iterable[int]:
    """English first, then those of the names that an image has."""
    device = subject.device
    pdos = (*device.rx_pdos, *device.tx_pdos)
    named = [device.names, *(pdo.names for pdo in pdos), *(entry.names for pdo in pdos for entry in pdo.entries)]
    if subject.group is not None:
        named.append(subject.group.names)
    given = (name.lcid for names in named for name in names)
    return dict.fromkeys((ENGLISH, *(language for language in given if language is not None)))


def _completed_image(computed: SiiImage, device: Device, image: SiiImage) -> SiiImage:
    unsaid = words_not_given(device)
    header = merged_header(computed.header, image.header, configuration_bytes(device), unsaid)
    if device.eeprom is not None and device.eeprom.byte_size is not None:
        header = msgspec.structs.replace(header, size_word=computed.header.size_word)
    categories = [_category(category, device, image) for category in computed.categories]
    if not device.fmmus:
        categories += image.of_type(Fmmus)
    return msgspec.structs.replace(computed, header=header, categories=tuple(categories))


def _category(category: Category, device: Device, image: SiiImage) -> Category:
    match category:
        case General() if image.general is not None:
            general = merged_general(category, image.general)
            return _completed(general, device, image.general, rest=category.rest)
        case Fmmus():
            fmmus = map(_fmmu, category.fmmus, _padded(device.fmmus), _padded(image.fmmus))
            return msgspec.structs.replace(category, fmmus=tuple(fmmus))
        case SyncManagers():
            stored = map(_sync_manager, category.sync_managers, device.sync_managers, _padded(image.sync_managers))
            return msgspec.structs.replace(category, sync_managers=tuple(stored))
        case RxPdos():
            return msgspec.structs.replace(category, pdos=tuple(_pdos(category.pdos, device.rx_pdos, image.rx_pdos)))
        case TxPdos():
            return msgspec.structs.replace(category, pdos=tuple(_pdos(category.pdos, device.tx_pdos, image.tx_pdos)))
        case DistributedClocks():
            clocks = map(_dc_mode, category.modes, op_modes_of_image(device), _padded(image.dc_modes))
            return msgspec.structs.replace(category, modes=tuple(clocks))
        case _:
            return category


def _padded(records: Iterable[T]) -> Iterator[T | None]:
    return chain(records, repeat(None))


def _completed(computed: S, said: Record, own: S, **further: object) -> S:
    """The record with the values of ``own``, that of the device, which the description does not say, and others."""
    stored_as = _STORED_AS[type(said)].items()
    unsaid = {stored: getattr(own, stored) for field, stored in stored_as if getattr(said, field) is None}
    return msgspec.structs.replace(computed, **unsaid, **further)


def _fmmu(computed: Fmmu, said: EsiFmmu | None, own: Fmmu | None) -> Fmmu:
    is_said = said is None or said.usage in FMMU_USAGE_CODES
    return computed if is_said or own is None else own


def _sync_manager(computed: SyncManager, said: EsiSyncManager, own: SyncManager | None) -> SyncManager:
    if own is None:
        return computed
    enable = computed.enable | own.enable & SmEnable.ENABLE if said.enable is None else computed.enable
    return _completed(computed, said, own, usage_code=computed.usage_code or own.usage_code, enable=enable)


def _pdos(computed: Iterable[Pdo], said: Iterable[EsiPdo], own: Iterable[Pdo]) -> Iterator[Pdo]:
    stored = numbered_pdos(own)
    for (key, pdo), described in zip(numbered_pdos(computed).items(), stored_pdos(said), strict=True):
        of_image = stored[key].entries if key in stored else ()
        entries = map(_entry, pdo.entries, described.entries, _padded(of_image))
        yield msgspec.structs.replace(pdo, entries=tuple(entries))


def _entry(computed: PdoEntry, said: Entry, own: PdoEntry | None) -> PdoEntry:
    if own is None:
        return computed
    is_said = computed.data_type_code or not computed.entry_index
    return _completed(computed, said, own, data_type_code=(computed if is_said else own).data_type_code)


def _dc_mode(computed: DcMode, said: OpMode, own: DcMode | None) -> DcMode:
    if own is None:
        return computed
    is_said = said.cycle_time_sync0_ns is not None or said.cycle_time_sync0_factor is not None
    is_used = is_said and computed.assign_activate & (AssignActivate.SYNC0 | AssignActivate.SYNC1)
    return _completed(
        computed, said, own, cycle_time_sync0_factor=(computed if is_used else own).cycle_time_sync0_factor
    )
