"""Rules about SyncManagers: roles, ControlByte, memory, sizes (ESI-FACTS section 8)."""

from collections.abc import Iterator

from esicatalog.esi.records.device import SyncManager
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO
from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Found, Place, rule
from esicatalog.lint.subjects import DeviceSubject, ProcessSubject, is_absent
from esicatalog.model.sm_facts import (
    BUFFERED,
    INPUT,
    MAILBOX_MODE,
    OUTPUT,
    SM_ROLES,
    TRANSFER_DIRECTIONS,
    SmRole,
    mailbox_sync_managers,
    sm_facts,
    sm_role,
    transfer_direction,
)
from esicatalog.model.sm_memory import memory_overlaps, size_conflict
from esicatalog.words import counted

_MAILBOXES = [usage for usage, role in SM_ROLES.items() if role.is_mailbox]
_IN_EEPROM = [usage for usage, role in SM_ROLES.items() if not role.is_dynamic]
_ROLES = {RX_PDO: "Outputs", TX_PDO: "Inputs"}
_DIRECTION_BITS = {OUTPUT: "01 (the master writes)", INPUT: "00 (the master reads)"}


def _with_roles(subject: ProcessSubject) -> Iterator[tuple[int, SyncManager, SmRole]]:
    for number, sm in enumerate(subject.data.sync_managers):
        role = sm_role(sm)
        if role is not None:
            yield number, sm, role


@rule("L18", ERROR, "ETG.1000.4 mailbox: it needs one SyncManager each way")
def mailbox_without_sync_managers(subject: DeviceSubject) -> Iterator[Found]:
    """A Mailbox without the SyncManagers MBoxOut and MBoxIn; these without Mailbox, or one in mailbox mode that has no
    known role and no PDO.
    """
    mailbox = subject.device.mailbox
    sync_managers = subject.device.sync_managers
    if mailbox is None:
        for number in mailbox_sync_managers(subject.device):
            usage = sync_managers[number].usage
            what = usage if usage in _MAILBOXES else "in mailbox mode"
            yield Found(
                f"SM {number} is {what}, but there is no Mailbox: say which protocols it carries",
                ("sync_managers", number),
            )
    else:
        usages = [sm.usage for sm in sync_managers]
        for usage in _MAILBOXES:
            if usage not in usages:
                yield Found(f"Mailbox without a SyncManager {usage}: add it, or remove Mailbox", ("mailbox",))


@rule("L19", ERROR, "ESC register 0x0804 + 8n, bits 3:2: direction of the SyncManager")
def direction_against_role(subject: ProcessSubject) -> Iterator[Found]:
    """The direction in the ControlByte contradicts the role of the SyncManager."""
    for number, sm, role in _with_roles(subject):
        controlled = sm_facts(sm).transfer_direction
        if sm.control_byte is not None and controlled != role.transfer_direction:
            words = f"SM {number} {sm.usage} has the ControlByte 0x{sm.control_byte:02X}"
            assigned = {placed.direction for placed in subject.pdos if placed.pdo.sm == number}
            if {TRANSFER_DIRECTIONS[direction] for direction in assigned} == {controlled}:
                direction = assigned.pop()
                advice = f" and {direction}s, which run as its bits 3:2 say: the role must be {_ROLES[direction]}"
            else:
                advice = f": its bits 3:2 must be {_DIRECTION_BITS[role.transfer_direction]}"
            yield Found(words + advice, ("sync_managers", number))


@rule("L20", WARNING, "ESC register 0x0804 + 8n, bits 1:0: 10 mailbox (one buffer), 00 three buffers")
def mode_against_role(subject: ProcessSubject) -> Iterator[Found]:
    """A mailbox SyncManager that is not in mailbox mode, or process data in one buffer."""
    for number, sm, role in _with_roles(subject):
        if sm.control_byte is None:
            continue
        mode = sm_facts(sm).buffer_mode
        words = f"SM {number} {sm.usage} has the ControlByte 0x{sm.control_byte:02X}:"
        if role.is_mailbox and mode != MAILBOX_MODE:
            yield Found(f"{words} a mailbox needs mailbox mode, bits 1:0 = 10", ("sync_managers", number))
        elif not role.is_mailbox and mode != BUFFERED:
            what = "one buffer: both sides wait for each other" if mode == MAILBOX_MODE else "a reserved mode"
            yield Found(f"{words} {what}; process data usually has three, bits 1:0 = 00", ("sync_managers", number))


@rule("L21", INFORMATION, "ESC register 0x0804 + 8n, bit 6: watchdog trigger")
def outputs_without_watchdog(subject: ProcessSubject) -> Iterator[Found]:
    """Outputs, by the ControlByte, without watchdog trigger: they keep their values when the master stops."""
    for number, sm, role in _with_roles(subject):
        if role.is_mailbox or transfer_direction(sm, ()) != OUTPUT:
            continue
        if sm_facts(sm).watchdog_trigger is False:
            yield Found(
                f"SM {number} {sm.usage} has the ControlByte 0x{sm.control_byte:02X} without watchdog (bit 6): "
                "nothing tells the device that the master stopped, unless it looks itself",
                ("sync_managers", number),
            )


@rule("L22", WARNING, "ESC: a SyncManager of three buffers takes three times its length, one behind the other")
def memory_overlap(subject: ProcessSubject) -> Iterator[Found]:
    """SyncManagers overlap in memory, buffered ones counted three times.

    Process data are as long as their PDOs make them where DefaultSize is less.
    """
    sync_managers, of_images = subject.data.sync_managers, _image_bytes(subject)
    byte_sizes = {
        number: max(sm.default_size or 0, of_images.get(number) or 0) for number, sm in enumerate(sync_managers)
    }
    for found in memory_overlaps(sync_managers, byte_sizes):
        yield Found(f"{found.words}; move one of them, or correct DefaultSize", ("sync_managers", found.number))


def _image_bytes(subject: ProcessSubject) -> dict[int, int | None]:
    """Lengths of the default process images by SyncManager, None where one is not known."""
    return {image.sm: image.byte_size for image in subject.data.images}


@rule("L23", WARNING, "ETG.2000 Sm: MBoxOut, MBoxIn, Outputs, Inputs; the EEPROM knows no other type")
def role_unknown(subject: ProcessSubject) -> Iterator[Found]:
    """The role of a SyncManager is empty or unknown."""
    for number, sm in enumerate(subject.data.sync_managers):
        if sm_role(sm) is None:
            words = f"has the role {sm.usage!r}" if sm.usage else "has no role"
            yield Found(f"SM {number} {words}: a master expects {', '.join(_IN_EEPROM)}", ("sync_managers", number))


@rule("L24", WARNING, "A SyncManager is as long as all bits of its assigned PDOs, rounded up to bytes once")
def default_size_against_pdos(subject: ProcessSubject) -> Iterator[Found]:
    """DefaultSize differs from what the assigned PDOs take."""
    if subject.data.is_modular:
        return
    byte_sizes = _image_bytes(subject)
    for number, sm, role in _with_roles(subject):
        if role.is_mailbox or not sm.default_size:
            continue
        size = byte_sizes.get(number)
        if size and size != sm.default_size:
            yield Found(
                f"SM {number} {sm.usage} has DefaultSize {sm.default_size}; "
                f"its assigned PDOs take {counted(size, 'byte')}: correct one of them",
                ("sync_managers", number),
            )


@rule("L25", ERROR, "ETG.2000 Sm/@MinSize, @MaxSize; ESC register 0x0802 + 8n: the length has 16 bits")
def pdos_outside_sizes(subject: ProcessSubject) -> Iterator[Found]:
    """The assigned PDOs take more than MaxSize or any SyncManager can hold, or less than MinSize."""
    for image in subject.data.images:
        if image.overflow is not None:
            is_declared = 0 <= image.sm < len(subject.data.sync_managers)
            place: Place = ("sync_managers", image.sm) if is_declared else ()
            yield Found(f"SM {image.sm}: {image.overflow}; correct BitLen or OSFac", place)
    if subject.data.is_modular:
        return
    byte_sizes = _image_bytes(subject)
    for number, sm, role in _with_roles(subject):
        if role.is_mailbox or (sm.max_size is None and sm.min_size is None):
            continue
        conflict = size_conflict(sm, byte_sizes.get(number))
        if conflict is not None:
            yield Found(f"SM {number} {sm.usage}: {conflict}: correct one of them", ("sync_managers", number))


@rule("L26", ERROR, "ETG.2000 Sm/@DefaultSize: required for the mailbox, within MinSize and MaxSize")
def default_size(subject: ProcessSubject) -> Iterator[Found]:
    """A mailbox SyncManager without DefaultSize, or a DefaultSize outside of MinSize and MaxSize."""
    for number, sm, role in _with_roles(subject):
        place: Place = ("sync_managers", number)
        if role.is_mailbox and (sm.default_size == 0 or is_absent(sm, "default_size")):
            words = "no DefaultSize" if sm.default_size is None else "DefaultSize 0"
            yield Found(f"SM {number} {sm.usage} has {words}: the mailbox has no length; give it", place)
        elif sm.default_size is None:
            continue
        elif (sm.min_size is not None and sm.default_size < sm.min_size) or (
            sm.max_size is not None and sm.default_size > sm.max_size
        ):
            yield Found(
                f"SM {number} {sm.usage} has DefaultSize {sm.default_size}, "
                f"outside of {_number(sm.min_size)} to {_number(sm.max_size)}: correct one of them",
                place,
            )


def _number(size: int | None) -> str:
    return "…" if size is None else str(size)
