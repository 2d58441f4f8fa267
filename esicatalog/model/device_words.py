"""Words that every sheet and page uses for what a description declares."""

from collections.abc import Iterable

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import InitCmd, Mailbox
from esicatalog.esi.unreadable import unreadable
from esicatalog.model.device_facts import DeviceFacts
from esicatalog.model.drive_evidence import ModeEvidence
from esicatalog.model.drive_modes import DriveModes
from esicatalog.model.pdo_facts import subindex_words
from esicatalog.model.process_image import SmImage
from esicatalog.model.profile_facts import profile_numbers
from esicatalog.model.sm_facts import mailbox_sync_managers
from esicatalog.model.twincat import PredefinedAssignment
from esicatalog.sii.codes import signal_names
from esicatalog.words import counted, index_words

MAILBOX_PROTOCOLS = ("coe", "eoe", "foe", "soe", "aoe", "voe")

WITHOUT_SLOT = "indices without the offsets of a slot"
"""What stands beside lists of a module that is in no slot (ESI-FACTS section 12.1)."""

_COE_DETAILS = {
    "coe_sdo_info": "SdoInfo",
    "coe_pdo_assign": "PdoAssign",
    "coe_pdo_config": "PdoConfig",
    "coe_pdo_upload": "PdoUpload",
    "coe_complete_access": "CompleteAccess",
    "coe_segmented_sdo": "SegmentedSdo",
    "coe_diag_history": "DiagHistory",
}


def protocol_name(protocol: str) -> str:
    """``CoE`` for the field or filter ``coe``."""
    return f"{protocol[0].upper()}o{protocol[2].upper()}"


def axes_alone(found: DriveModes) -> list[ModeEvidence]:
    """What tells that there are axes of which nothing says any mode: whatever is asked of these is unknown."""
    return [item for item in found.evidence if item.mode is None]


def mailbox_protocols(mailbox: Mailbox | None) -> list[str]:
    """The protocols that a mailbox declares."""
    return [protocol_name(name) for name in MAILBOX_PROTOCOLS if mailbox is not None and getattr(mailbox, name)]


def mailbox_words(device: Device) -> str:
    """The protocols of a device, or what speaks for and against a mailbox that it does not describe.

    ``ethercat xml`` prints SyncManagers and no Mailbox.
    """
    if device.mailbox is not None:
        return ", ".join(mailbox_protocols(device.mailbox)) or "no protocol"
    numbers = mailbox_sync_managers(device)
    if not numbers:
        return "none"
    which = " and ".join(f"SM{number}" for number in numbers)
    return f"not described ({which} {'is' if len(numbers) == 1 else 'are'} for one)"


def coe_details(mailbox: Mailbox | None) -> list[str]:
    """The options that a mailbox declares for CoE."""
    return [words for field, words in _COE_DETAILS.items() if mailbox is not None and getattr(mailbox, field)]


def soe_target(idn: str, channel: int | str | None) -> str:
    """An IDN with the drive of the device that it is of, as InitCmd/@Chn says it: most devices have a single one."""
    return f"{idn} channel {channel}" if channel is not None else idn


def init_cmd_target(command: InitCmd) -> str:
    """What a start-up command writes to; an IDN in the words of :func:`soe_target`."""
    if command.idn is not None:
        return soe_target(f"IDN {command.idn}", command.channel)
    index, subindex = (_as_it_stands(command, name) for name in ("object_index", "subindex"))
    if index is not None:
        words = index_words(index) if isinstance(index, int) else f"? {index!r}"
        complete = " complete" if command.complete_access else ""
        return f"{words}:{subindex_words(subindex or 0)}{complete}"
    return f"type {command.eoe_type}" if command.eoe_type is not None else ""


def _as_it_stands(command: InitCmd, name: str) -> int | str | None:
    """A number, else the text that stands there and cannot be read, else None."""
    value: int | None = getattr(command, name)
    return (command.spelling or {})[name] if unreadable(command, name) is not None else value


def predefined_words(assignment: PredefinedAssignment, images: Iterable[SmImage]) -> str:
    """Whether a predefined assignment is marked Default, and in what the default process images are another one.

    These go by Sm of the PDOs and the lists of the OpMode (ESI-FACTS section 0); files mark what differs (section 14).
    Empty for one that is not marked.
    """
    if not assignment.is_default:
        return ""
    assigned = {
        image.sm: tuple(
            [pdo.pdo.pdo_index for pdo in image.pdos if pdo.module is None and pdo.pdo.pdo_index is not None]
        )
        for image in images
    }
    other = [f"SM{sm}" for sm, indices in assignment.pdo_indices.items() if indices != assigned.get(sm, ())]
    marked = "marked Default in the file"
    if not other:
        return marked
    shown = "the default process image and exports, which go by Sm of the PDOs and by OpMode"
    return f"{marked}; {shown}, differ on {' and '.join(other)}"


def profile_words(device: Device) -> list[str]:
    """Profile numbers with their AddInfo, those of channels included, each once in document order."""
    given = (number for number in profile_numbers(device.profiles) if number.profile_no is not None)
    return list(dict.fromkeys("/".join(str(part) for part in number if part is not None) for number in given))


def clock_words(device: Device, facts: DeviceFacts) -> str:
    """Whether distributed clocks are needed, and the signals that some OpMode generates.

    Only OpModes that all leave the sync unit off say that there is no DC, and one that does says that it is optional;
    one without readable AssignActivate says nothing of it, nor does a description without Dc (couplers have clocks and
    rarely a Dc element).
    """
    if facts.dc_supported:
        signals = signal_names(facts.supports_sync0, facts.supports_sync1)
        optional = "DC optional" if facts.runs_without_dc else "DC used (whether it is needed is not known)"
        return ", ".join(["DC needed" if facts.dc_needed else optional, *signals])
    if device.dc_potential_reference_clock:
        return "can be the reference clock"
    is_described = bool(device.op_modes) and all(mode.assign_activate is not None for mode in device.op_modes)
    return "no DC" if is_described else "not described"


def fsoe_words(facts: DeviceFacts) -> str | None:
    """Evidence of FSoE, which is no statement about safety; None without any."""
    return f"{facts.fsoe} evidence: {facts.fsoe_evidence}" if facts.fsoe is not None else None


def head_facts(device: Device, facts: DeviceFacts) -> list[tuple[str, str]]:
    """The facts at the head of a sheet, each with its name; those that are not given are left out."""
    current, cycle = device.e_bus_current_ma, facts.min_cycle_ns
    shown = (
        ("group", device.group_type),
        ("profiles", ", ".join(profile_words(device))),
        ("ports", device.physics),
        ("E-bus current", f"{current} mA" if current is not None else None),
        ("mailbox", mailbox_words(device)),
        ("CoE", ", ".join(coe_details(device.mailbox))),
        ("clocks", clock_words(device, facts)),
        ("smallest cycle", f"{cycle} ns" if cycle is not None else None),
        ("process data", _process_data_words(facts)),
        ("CheckRevisionNo", device.check_revision_no),
        ("LRW", "not possible (UseLrdLwr)" if device.use_lrd_lwr else None),
        ("FSoE", fsoe_words(facts)),
    )
    return [(name, value) for name, value in shown if value]


def _process_data_words(facts: DeviceFacts) -> str:
    if facts.output_bytes is None and facts.input_bytes is None:
        return "unknown"
    out, into = (
        counted(size, "byte") if size is not None else "unknown length"
        for size in (facts.output_bytes, facts.input_bytes)
    )
    return f"{out} out, {into} in by default"


def eeprom_words(device: Device) -> list[tuple[str, str]]:
    """What a description says of the EEPROM, each with its name; nothing where it says nothing."""
    eeprom = device.eeprom
    if eeprom is None:
        return []
    shown = (
        ("size", counted(eeprom.byte_size, "byte") if eeprom.byte_size is not None else None),
        ("ConfigData", eeprom.config_data),
        ("BootStrap", eeprom.boot_strap),
    )
    return [(name, value) for name, value in shown if value]
