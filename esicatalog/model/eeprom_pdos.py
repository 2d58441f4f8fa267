"""Which PDOs the EEPROM (SII) of a device assigns: what a master exchanges that asks the device for nothing else.

These are all that name a SyncManager, virtual ones and those that exclude each other too. ``ethercat pdos`` of IgH
lists them of a device without CoE, and of one whose mailbox it did not get to (ec_slave_fetch_sii_pdos in its
master/slave.c). SOEM adds up the bits of a device with neither CoE nor SoE (ecx_map_sii and ecx_siiPDO in its
src/ec_config.c and src/ec_main.c; of SOEM 1.4 ethercatconfig.c and ethercatmain.c).
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO, Pdo
from esicatalog.model.pdo_facts import pdo_bits
from esicatalog.model.process_image import SmImage, virtual_pdos
from esicatalog.model.sm_facts import TRANSFER_DIRECTIONS
from esicatalog.sii.decode import decode_sii
from esicatalog.sii.errors import SiiImageError

_MAX_SOEM_SYNC_MANAGERS = 8
"""EC_MAXSM of SOEM."""


class EepromPdo(NamedTuple):
    """A PDO that the EEPROM assigns to a SyncManager."""

    transfer_direction: str
    sm: int
    pdo_index: int
    bit_size: int


def whole_image(device: Device) -> bytes | None:
    """The bytes of Eeprom/Data, which is the whole image; None without one, or with one that cannot be read."""
    return decode_hex_binary(device.eeprom.data) if device.eeprom is not None else None


def stored_pdos(pdos: Iterable[Pdo]) -> Iterator[Pdo]:
    """Those that an image holds: without an index, a reference of files before schema 1.2, nothing can be assigned."""
    return (pdo for pdo in pdos if pdo.pdo_index is not None)


def eeprom_pdos(device: Device) -> list[EepromPdo]:
    """The PDOs in the order of the EEPROM; none where an Eeprom/Data is no image. Those of modules are in no EEPROM."""
    both = ((TX_PDO, device.tx_pdos), (RX_PDO, device.rx_pdos))
    whole = whole_image(device)
    if whole is None:
        return [
            EepromPdo(TRANSFER_DIRECTIONS[direction], pdo.sm, pdo.pdo_index or 0, pdo_bits(pdo))
            for direction, pdos in both
            for pdo in stored_pdos(pdos)
            if pdo.sm is not None
        ]
    try:
        image = decode_sii(whole)
    except SiiImageError:
        return []
    of_image = ((TX_PDO, image.tx_pdos), (RX_PDO, image.rx_pdos))
    return [
        EepromPdo(TRANSFER_DIRECTIONS[direction], pdo.sm, pdo.pdo_index, pdo.bit_length)
        for direction, pdos in of_image
        for pdo in pdos
    ]


def soem_pdos(device: Device, transfer_direction: str) -> list[EepromPdo] | None:
    """The PDOs whose bits SOEM adds up; None for a device that it asks.

    None for modular devices too: what they have in their EEPROM once modules are plugged, nothing describes.
    """
    mailbox = device.mailbox
    if device.slots or (mailbox is not None and (mailbox.coe or mailbox.soe)):
        return None
    found = (pdo for pdo in eeprom_pdos(device) if pdo.transfer_direction == transfer_direction)
    return [pdo for pdo in found if pdo.sm < _MAX_SOEM_SYNC_MANAGERS]


class SoemBits(NamedTuple):
    """What SOEM exchanges with a device that it asks for nothing, in one direction."""

    bit_size: int
    is_default: bool
    """Whether all but virtual PDOs is as long as the default process image: PDOs that exclude each other make it
    longer, samples of which the EEPROM has one make it shorter."""


def soem_bits(device: Device, transfer_direction: str, images: Iterable[SmImage]) -> SoemBits | None:
    """The bits that SOEM adds up, beside the default process image; None for a device that it asks."""
    pdos = soem_pdos(device, transfer_direction)
    if pdos is None:
        return None
    images = list(images)
    virtual = virtual_pdos(images)
    transported = sum(pdo.bit_size for pdo in pdos if (pdo.sm, pdo.pdo_index) not in virtual)
    default = sum(image.bit_size for image in images if image.transfer_direction == transfer_direction)
    return SoemBits(sum(pdo.bit_size for pdo in pdos), transported == default)
