"""Which entries a PDO can be given: what a master may change and what the dictionary lets into it."""

from esicatalog.esi.records.mailbox import Mailbox
from esicatalog.esi.records.pdo import Pdo
from esicatalog.model.dictionary import ObjectEntry

MAPPABLE_IN = {"RxPdo": "R", "TxPdo": "T"}
"""What PdoMapping calls the direction of a PDO."""


def mapping_obstacle(mailbox: Mailbox | None, pdo: Pdo) -> str | None:
    """Why a master may not choose the entries of a PDO of a device with this mailbox, None when it may.

    Pdo/@Fixed forbids it for one PDO; CoE/@PdoConfig allows it for a device (ESI-FACTS sections 9 and 10).
    """
    if pdo.fixed:
        return "is Fixed"
    if mailbox is None or not mailbox.coe_pdo_config:
        return "cannot be changed: the device does not declare PdoConfig"
    return None


def is_mappable(declared: ObjectEntry, direction: str) -> bool:
    """Whether a dictionary lets an object into PDOs of a direction: PdoMapping names it, and its size is known."""
    return bool(declared.bit_size) and MAPPABLE_IN[direction] in (declared.pdo_mapping or "")
