"""What a SyncManager is for, and its ControlByte in words (ESC register 0x0804, ESI-FACTS section 8)."""

import functools
from collections.abc import Iterable
from typing import Annotated, NamedTuple

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.records.device import Device, SyncManager
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO
from esicatalog.sii.codes import SM_DIRECTIONS, SM_MODES, SmControl

INPUT, OUTPUT = SM_DIRECTIONS[0b00], SM_DIRECTIONS[0b01]
"""Transfer directions: the master reads, the master writes."""
TRANSFER_DIRECTIONS = {RX_PDO: OUTPUT, TX_PDO: INPUT}
"""By the direction of a PDO, which is named from the device's side."""
BUFFERED, MAILBOX_MODE = SM_MODES[0b00], SM_MODES[0b10]
"""Three buffers of which each side always has one; one buffer, which one side fills and the other empties in turn."""


class SmRole(NamedTuple):
    """What the text of an Sm element means."""

    transfer_direction: str
    """:data:`OUTPUT` or :data:`INPUT`."""
    pdo_direction: str | None
    """RxPdo or TxPdo, what it transports; None for a mailbox."""
    is_dynamic: bool = False
    """Whether it transports what a configuration adds: TwinCAT's, the EEPROM has no such type."""

    @property
    def is_mailbox(self) -> bool:
        """Whether it carries no process data."""
        return self.pdo_direction is None


SM_ROLES = {
    "MBoxOut": SmRole(OUTPUT, None),
    "MBoxIn": SmRole(INPUT, None),
    "Outputs": SmRole(OUTPUT, RX_PDO),
    "Inputs": SmRole(INPUT, TX_PDO),
    "DynamicOutputs": SmRole(OUTPUT, RX_PDO, is_dynamic=True),
    "DynamicInputs": SmRole(INPUT, TX_PDO, is_dynamic=True),
}
"""The roles that tools know; others are words of the vendor's and say nothing."""
_USAGES = {role: usage for usage, role in SM_ROLES.items()}


def sm_role(sync_manager: SyncManager) -> SmRole | None:
    """The role of a SyncManager, None where nobody knows its text."""
    return SM_ROLES.get(sync_manager.usage or "")


def is_mailbox(sync_manager: SyncManager) -> bool:
    """Whether a SyncManager is known to be that of a mailbox; what a vendor calls MBox-something else is not."""
    role = sm_role(sync_manager)
    return role is not None and role.is_mailbox


def mailbox_sync_managers(device: Device) -> list[int]:
    """Numbers of those that carry a mailbox: by their role; without a known one by mailbox mode.

    Not where a PDO names it: process data may have a single buffer, too (ESI-FACTS section 8).
    """
    named = {pdo.sm for pdo in (*device.rx_pdos, *device.tx_pdos)}
    found = []
    for number, sm in enumerate(device.sync_managers):
        in_mailbox_mode = sm_facts(sm).buffer_mode == MAILBOX_MODE and number not in named and not sm.virtual
        if is_mailbox(sm) or (sm_role(sm) is None and in_mailbox_mode):
            found.append(number)
    return found


def sm_usages(device: Device) -> list[str | None]:
    """The text of each Sm element; where it is empty, what it would have to be, None where nothing tells.

    ``ethercat xml`` writes none: a mailbox (:func:`mailbox_sync_managers`) is then known by the direction of its
    ControlByte, one for process data by the PDOs that name it. A word of the vendor's stays as it is.
    """
    mailboxes = mailbox_sync_managers(device)
    named = {RX_PDO: {pdo.sm for pdo in device.rx_pdos}, TX_PDO: {pdo.sm for pdo in device.tx_pdos}}
    usages = []
    for number, sm in enumerate(device.sync_managers):
        directions = [direction for direction, numbers in named.items() if number in numbers]
        role = None
        if number in mailboxes:
            role = SmRole(sm_facts(sm).transfer_direction or "", None)
        elif len(directions) == 1:
            role = SmRole(TRANSFER_DIRECTIONS[directions[0]], directions[0])
        usages.append(sm.usage or (_USAGES.get(role) if role is not None else None))
    return usages


def may_transport(sync_manager: SyncManager, direction: str) -> bool:
    """Whether a SyncManager can have a RxPdo or TxPdo: as its role says, any where nobody knows that.

    Where the ControlByte contradicts the role of one for process data, its direction counts too: it is what the slave
    controller does (:func:`transfer_direction`).
    """
    role = sm_role(sync_manager)
    if role is None or role.pdo_direction == direction:
        return True
    return not role.is_mailbox and sm_facts(sync_manager).transfer_direction == TRANSFER_DIRECTIONS[direction]


def transfer_direction(sync_manager: SyncManager | None, pdo_directions: Iterable[str]) -> str:
    """:data:`OUTPUT` or :data:`INPUT`: by the ControlByte, else by the role, else by the PDOs that it has.

    ``ethercat xml`` writes no role, and some vendors one of their own.
    """
    role = sm_role(sync_manager) if sync_manager is not None else None
    by_control = sm_facts(sync_manager).transfer_direction if sync_manager is not None else None
    by_pdos = min((TRANSFER_DIRECTIONS[direction] for direction in pdo_directions), default=INPUT)
    return by_control or (role.transfer_direction if role is not None else by_pdos)


class SmFacts(Record):
    """What a ControlByte means."""

    buffer_mode: Annotated[str | None, Doc("buffered (3 buffers) or mailbox (1 buffer), ControlByte bits 1:0")] = None
    transfer_direction: Annotated[
        str | None, Doc("output (master writes) or input (master reads), ControlByte bits 3:2")
    ] = None
    ecat_interrupt: Annotated[bool | None, Doc("Interrupt into the ECAT event request, ControlByte bit 4")] = None
    pdi_interrupt: Annotated[bool | None, Doc("Interrupt into the AL event request, ControlByte bit 5")] = None
    watchdog_trigger: Annotated[bool | None, Doc("Watchdog trigger, ControlByte bit 6")] = None


def sm_flags(sync_manager: SyncManager) -> list[str]:
    """What is set of a SyncManager, in the words of sheets and pages."""
    flags = {
        "watchdog": sm_facts(sync_manager).watchdog_trigger,
        "virtual": sync_manager.virtual,
        "OpOnly": sync_manager.op_only,
    }
    return [name for name, is_set in flags.items() if is_set]


def sm_facts(sync_manager: SyncManager) -> SmFacts:
    """Decode the ControlByte; everything is None when it is not given."""
    return control_facts(sync_manager.control_byte)


@functools.lru_cache(256)
def control_facts(control: int | None) -> SmFacts:
    """Decode a ControlByte, wherever it stands; everything is None for None."""
    if control is None:
        return SmFacts()
    return SmFacts(
        buffer_mode=SM_MODES.get(control & 0b11),
        transfer_direction=SM_DIRECTIONS.get(control >> 2 & 0b11),
        ecat_interrupt=bool(control & SmControl.ECAT_INTERRUPT),
        pdi_interrupt=bool(control & SmControl.PDI_INTERRUPT),
        watchdog_trigger=bool(control & SmControl.WATCHDOG),
    )
