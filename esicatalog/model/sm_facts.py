"""ControlByte of a SyncManager in words (ESC register 0x0804, ESI-FACTS section 8)."""

from typing import Annotated

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.records.device import SyncManager

_MODES = {0b00: "buffered", 0b10: "mailbox"}
_DIRECTIONS = {0b00: "input", 0b01: "output"}
_WATCHDOG = 0x40
_PDI_INTERRUPT = 0x20
_ECAT_INTERRUPT = 0x10


class SmFacts(Record):
    """What a ControlByte means."""

    buffer_mode: Annotated[str | None, Doc("buffered (3 buffers) or mailbox (1 buffer), ControlByte bits 1:0")] = None
    transfer_direction: Annotated[
        str | None, Doc("output (master writes) or input (master reads), ControlByte bits 3:2")
    ] = None
    ecat_interrupt: Annotated[bool | None, Doc("Interrupt into the ECAT event request, ControlByte bit 4")] = None
    pdi_interrupt: Annotated[bool | None, Doc("Interrupt into the AL event request, ControlByte bit 5")] = None
    watchdog_trigger: Annotated[bool | None, Doc("Watchdog trigger, ControlByte bit 6")] = None


def sm_facts(sync_manager: SyncManager) -> SmFacts:
    """Decode the ControlByte; everything is None when it is not given."""
    control = sync_manager.control_byte
    if control is None:
        return SmFacts()
    return SmFacts(
        buffer_mode=_MODES.get(control & 0b11),
        transfer_direction=_DIRECTIONS.get(control >> 2 & 0b11),
        ecat_interrupt=bool(control & _ECAT_INTERRUPT),
        pdi_interrupt=bool(control & _PDI_INTERRUPT),
        watchdog_trigger=bool(control & _WATCHDOG),
    )
