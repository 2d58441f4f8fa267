"""What SOEM exchanges with a device that has neither CoE nor SoE: what it counts of the device's SII.

Nothing can be read of such a device, and nothing is told to it: SOEM adds up all PDOs whose SyncManager is one of the
first :data:`MAX_SYNC_MANAGERS`, virtual ones and those that exclude each other, too (ecx_map_sii and ecx_siiPDO in its
src/ec_config.c and src/ec_main.c; of SOEM 1.4 ethercatconfig.c and ethercatmain.c).
"""

from collections import Counter
from collections.abc import Mapping

from esicatalog.errors import InputError
from esicatalog.export.configuration import Configuration
from esicatalog.export.sii import described_image
from esicatalog.model.sm_facts import OUTPUT
from esicatalog.words import counted

MAX_SYNC_MANAGERS = 8
"""EC_MAXSM of SOEM."""


def check_counted(configuration: Configuration, direction: str) -> None:
    """Raise :class:`InputError` where SOEM exchanges other bits of a direction than are configured here.

    What a modular device has in its SII once modules are plugged, nothing describes.
    """
    device = configuration.subject.device
    mailbox = device.mailbox
    if device.slots or (mailbox is not None and (mailbox.coe or mailbox.soe)):
        return
    image = described_image(configuration.subject)
    found: Counter[int] = Counter()
    for pdo in image.rx_pdos if direction == OUTPUT else image.tx_pdos:
        if pdo.sm < MAX_SYNC_MANAGERS:
            found[pdo.sm] += pdo.bit_length
    here = {sm.number: sm.bit_size for sm in configuration.images(direction)}
    if +found != here:
        raise InputError(
            f"SOEM would exchange {_size_words(direction, +found)} with it, not {_size_words(direction, here)}: of a "
            "device without CoE it takes every PDO that the SII assigns, virtual ones too; take a master that is told "
            "the PDOs: export igh, linuxcnc or ros2"
        )


def _size_words(direction: str, bits: Mapping[int, int]) -> str:
    of_sms = ", ".join(f"SM{number} {size}" for number, size in sorted(bits.items()))
    total = counted(sum(bits.values()), f"{direction} bit")
    return f"{total} ({of_sms})" if of_sms else total
