"""What SOEM exchanges with a device that has neither CoE nor SoE: what it counts of the device's SII.

Nothing can be read of such a device, and nothing is told to it.
"""

from collections import Counter
from collections.abc import Mapping

from esicatalog.errors import InputError
from esicatalog.export.configuration import Configuration
from esicatalog.model.eeprom_pdos import soem_pdos
from esicatalog.words import counted


def check_counted(configuration: Configuration, direction: str) -> None:
    """Raise :class:`InputError` where SOEM exchanges other bits of a direction than are configured here."""
    pdos = soem_pdos(configuration.subject.device, direction)
    if pdos is None:
        return
    found: Counter[int] = Counter()
    for pdo in pdos:
        found[pdo.sm] += pdo.bit_size
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
