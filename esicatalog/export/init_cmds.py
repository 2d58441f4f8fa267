"""Start-up commands of a device and its plugged modules, in the order in which they are due."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import groupby
from operator import attrgetter
from typing import Generic, NamedTuple, TypeVar

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import InitCmd, Mailbox
from esicatalog.model.cia402 import AXIS_STEP
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS, is_pdo_mapping
from esicatalog.model.slots import ExpandedModule, PluggedModule, numbered_slots
from esicatalog.model.start_up import TRANSITIONS, transition_of, unusable_part, written_places, yields
from esicatalog.model.sync_parameters import SYNC_PARAMETERS

MODULE_IDENT_LIST = 0xF030
_NS_OF_CYCLE_UNIT = {
    ("SoE", 1, 0): 1_000,
    ("SoE", 2, 0): 1_000,
    **{("CoE", index, 2): 1 for index in SYNC_PARAMETERS},
}
"""Where cycle times are written, and in which unit: S-0-0001 control unit cycle time and S-0-0002 communication cycle
time (IEC 61800-7-204), cycle time of the SyncManager parameters (ETG.1020)."""
_INTERPOLATION_TIME_PERIOD = 0x60C2
"""Subindex 1 times ten to the power of subindex 2, in seconds (IEC 61800-7-201); further axes as their objects."""
_USUAL_EXPONENT, _EXPONENT_OF_NS = -3, -9
_MAX_TIME_BYTES = 8
_WITHOUT_GENERATOR = ("AoE", "EoE")


class StartCommand(NamedTuple):
    """One command at one transition. ``object_index`` is the index (CoE) or the IDN (SoE)."""

    transition: str
    protocol: str
    object_index: int
    subindex: int
    data: bytes
    complete_access: bool = False
    channel: int = 0
    comment: str = ""
    adapt_automatically: bool = False

    @property
    def writes_pdo_configuration(self) -> bool:
        """Whether it writes a PDO assignment or mapping, which masters write themselves."""
        return self.protocol == "CoE" and (self.object_index in PDO_ASSIGNMENTS or is_pdo_mapping(self.object_index))

    @property
    def place(self) -> str:
        """What is written, in words."""
        if self.protocol == "SoE":
            kind, number = "P" if self.object_index & 0x8000 else "S", self.object_index & 0x0FFF
            return f"{kind}-{self.object_index >> 12 & 7}-{number:04}"
        return (
            f"0x{self.object_index:04X}" if self.complete_access else f"0x{self.object_index:04X}:{self.subindex:02X}"
        )


Sent = TypeVar("Sent")


class LaterCommands(NamedTuple, Generic[Sent]):
    """Commands of one transition that the application sends itself, as a target sends them."""

    transition: str
    commands: tuple[Sent, ...]


def by_transition(
    commands: Iterable[StartCommand], sent: Callable[[StartCommand], Sent]
) -> tuple[LaterCommands[Sent], ...]:
    """Commands in the order of :func:`start_commands`, each as ``sent`` makes it, transition by transition."""
    return tuple(
        LaterCommands(transition, tuple(map(sent, found)))
        for transition, found in groupby(commands, key=attrgetter("transition"))
    )


def start_commands(
    device: Device, plugged: Sequence[PluggedModule], expanded: Sequence[ExpandedModule]
) -> tuple[tuple[StartCommand, ...], tuple[str, ...]]:
    """All commands by transition, those of the device before those of its modules, and remarks about odd ones."""
    remarks: list[str] = []
    commands = list(_module_list(device, plugged))
    of_modules = [(f"module in slot {item.slot_number}", item.module.mailbox) for item in expanded]
    replaced = written_places(item.module for item in expanded)
    for owner, mailbox in (("device", device.mailbox), *of_modules):
        for protocol, command in _init_cmds(mailbox):
            if owner == "device" and yields(command, replaced):
                continue
            commands.extend(_at_transitions(owner, protocol, command, remarks))
    return tuple(sorted(commands, key=lambda command: TRANSITIONS.index(command.transition))), tuple(remarks)


def _init_cmds(mailbox: Mailbox | None) -> Iterator[tuple[str, InitCmd]]:
    if mailbox is not None:
        for protocol, commands in (
            ("CoE", mailbox.coe_init_cmds),
            ("SoE", mailbox.soe_init_cmds),
            ("AoE", mailbox.aoe_init_cmds),
            ("EoE", mailbox.eoe_init_cmds),
        ):
            for command in commands:
                yield protocol, command


def _at_transitions(owner: str, protocol: str, command: InitCmd, remarks: list[str]) -> Iterator[StartCommand]:
    if protocol in _WITHOUT_GENERATOR:
        remarks.append(f"{protocol} InitCmd of the {owner} is left out: it is no parameter of the device")
        return
    index = command.idn if protocol == "SoE" else command.object_index
    unusable = unusable_part(command, "idn" if protocol == "SoE" else "object_index")
    if index is None or unusable is not None:
        remarks.append(f"{protocol} InitCmd of the {owner} is left out: its {unusable} cannot be used")
        return
    data = decode_hex_binary(command.data)
    for transition in command.transitions:
        found = StartCommand(
            transition_of(transition),
            protocol,
            index,
            command.subindex or 0,
            data or b"",
            bool(command.complete_access),
            command.channel or 0,
            " ".join((command.comment or "").split()),
            bool(command.adapt_automatically),
        )
        if found.transition not in TRANSITIONS:
            remarks.append(f"InitCmd {found.place} of the {owner} is left out: transition {transition!r} is unknown")
        elif not data:
            remarks.append(f"InitCmd {found.place} of the {owner} is left out: its data are missing or not hex")
        else:
            yield found


def _module_list(device: Device, plugged: Iterable[PluggedModule]) -> Iterator[StartCommand]:
    """The idents of the plugged modules, 0 for an empty slot, where the device wants to be told (0xF030)."""
    if not device.download_module_ident_list:
        return
    idents = {item.slot_number: item.module.module_ident or 0 for item in plugged}
    count = min(max(idents, default=-1) + 1, 255)
    if not count:
        return
    transition = (device.download_module_list_transition or "PS").upper()
    transition = transition if transition in TRANSITIONS else "PS"
    values = [idents.get(number, 0).to_bytes(4, "little") for number, _, _ in numbered_slots(device)][:count]
    data = count.to_bytes(2, "little") + b"".join(values)
    whole = StartCommand(transition, "CoE", MODULE_IDENT_LIST, 0, data, True, comment="Configured module ident list")
    has_complete_access = device.mailbox is not None and device.mailbox.coe_complete_access
    yield from (whole,) if has_complete_access else single_accesses(whole)


def single_accesses(command: StartCommand) -> Iterator[StartCommand]:
    """A write of the whole module ident list (0xF030) as one write for each subindex, with the number of them last."""
    values = [command.data[start : start + 4] for start in range(2, len(command.data), 4)]
    single = command._replace(complete_access=False)
    yield single._replace(data=b"\0")
    for subindex, value in enumerate(values, 1):
        yield single._replace(subindex=subindex, data=value, comment=f"Slot {subindex - 1}")
    yield single._replace(data=command.data[:1])


def cycle_remarks(
    commands: Sequence[StartCommand], axes: Iterable[int], cycle_ns: int, sync0_ns: Fraction | None
) -> Iterator[str]:
    """Commands that write a cycle time other than the bus cycle: vendors' examples, to be adapted.

    For the parameters of SyncManagers the cycle of SYNC0, None when it is not generated, is as good.
    """
    units = dict(_cycle_units(commands, axes))
    for command in commands:
        unit = units.get((command.protocol, command.object_index, command.subindex))
        if unit is None or command.complete_access or len(command.data) > _MAX_TIME_BYTES:
            continue
        written_ns = int.from_bytes(command.data, "little") * unit
        by_sync0 = command.object_index in SYNC_PARAMETERS and written_ns == sync0_ns
        if written_ns != cycle_ns and not by_sync0:
            tool = "; AdaptAutomatically: the configuration tool adapts the data" if command.adapt_automatically else ""
            yield (
                f"InitCmd {command.place} {command.comment}".rstrip()
                + f" writes {written_ns} ns, the bus cycle is {cycle_ns} ns: adapt one of them{tool}"
            )


def _cycle_units(
    commands: Sequence[StartCommand], axes: Iterable[int]
) -> Iterator[tuple[tuple[str, int, int], int | Fraction]]:
    yield from _NS_OF_CYCLE_UNIT.items()
    single = {
        (command.object_index, command.subindex): command.data
        for command in commands
        if command.protocol == "CoE" and not command.complete_access
    }
    for axis in {0, *axes}:
        index = _INTERPOLATION_TIME_PERIOD + axis * AXIS_STEP
        data = single.get((index, 2))
        exponent = int.from_bytes(data[:1], "little", signed=True) if data is not None else _USUAL_EXPONENT
        yield ("CoE", index, 1), Fraction(10) ** (exponent - _EXPONENT_OF_NS)
