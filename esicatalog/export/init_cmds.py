"""Start-up commands of a device and its plugged modules, in the order in which they are due."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import groupby
from operator import attrgetter
from typing import Generic, NamedTuple, TypeVar

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.device import Device
from esicatalog.export.entry_types import ObjectTable
from esicatalog.model.access import states_to_write
from esicatalog.model.device_words import soe_target
from esicatalog.model.module_idents import MODULE_IDENT_LIST, list_transition, module_idents
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS, is_pdo_mapping
from esicatalog.model.slots import ExpandedModule, PluggedModule
from esicatalog.model.start_up import TRANSITIONS, OwnedInitCmd, all_init_cmds, transition_of, unusable_part
from esicatalog.remarks import Remarking
from esicatalog.words import one_line

_WITHOUT_GENERATOR = ("AoE", "EoE")
_ADDRESS_LIST = (
    "Slots/@DownloadModuleAddressList: the device wants to be told the addresses of its modules at start, which are "
    "not described and nothing here writes: write them in the application"
)
_COUNT_IS_READ_ONLY = (
    f"0x{MODULE_IDENT_LIST:04X}:00, the number of modules, is read-only by the description: single accesses leave it "
    "out; complete access writes it with the list, which the device may refuse: then write the subindices one by one"
)


class StartCommand(NamedTuple):
    """One command at one transition. ``object_index`` is the index (CoE) or the IDN (SoE)."""

    transition: str
    protocol: str
    object_index: int
    subindex: int
    data: bytes
    complete_access: bool = False
    declared_channel: int | None = None
    """Of SoE, as the InitCmd gives it."""
    comment: str = ""
    adapt_automatically: bool = False
    count_is_read_only: bool = False
    """Whether the description lets nobody write subindex 0, of a whole object."""

    @property
    def writes_pdo_configuration(self) -> bool:
        """Whether it writes a PDO assignment or mapping, which masters write themselves."""
        return self.protocol == "CoE" and (self.object_index in PDO_ASSIGNMENTS or is_pdo_mapping(self.object_index))

    @property
    def channel(self) -> int:
        """The drive of the device that an IDN is of: the first one unless the InitCmd says another."""
        return self.declared_channel or 0

    @property
    def place(self) -> str:
        """What is written, in words."""
        if self.protocol == "SoE":
            kind, number = "P" if self.object_index & 0x8000 else "S", self.object_index & 0x0FFF
            return soe_target(f"{kind}-{self.object_index >> 12 & 7}-{number:04}", self.declared_channel)
        return (
            f"0x{self.object_index:04X}" if self.complete_access else f"0x{self.object_index:04X}:{self.subindex:02X}"
        )

    @property
    def words(self) -> str:
        """What it does and when, in words."""
        return f"{self.transition} {self.place} {self.comment}".rstrip()


class SentCommand(NamedTuple):
    """A command with the C call that sends ``data``; without a call it stands there as a comment only."""

    words: str
    call: str | None = None
    data: str = ""


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
    device: Device, plugged: Sequence[PluggedModule], expanded: Sequence[ExpandedModule], objects: ObjectTable
) -> Remarking[tuple[StartCommand, ...]]:
    """All commands by transition, those of the device before those of its modules; odd ones are remarked."""
    if device.download_module_address_list and plugged:
        yield _ADDRESS_LIST
    count = objects.entry(MODULE_IDENT_LIST, 0)
    count_is_read_only = count is not None and not states_to_write(count.access_word)
    commands = list(_module_list(device, plugged, count_is_read_only))
    if commands and count_is_read_only:
        yield _COUNT_IS_READ_ONLY
    for item in all_init_cmds(device, expanded):
        commands += yield from _at_transitions(item)
    return tuple(sorted(commands, key=lambda command: TRANSITIONS.index(command.transition)))


def _at_transitions(item: OwnedInitCmd) -> Remarking[list[StartCommand]]:
    owner, protocol, command = item.owner, item.protocol, item.command
    if protocol in _WITHOUT_GENERATOR:
        yield f"{protocol} InitCmd of the {owner} is left out: it is no parameter of the device"
        return []
    index = command.idn if protocol == "SoE" else command.object_index
    unusable = unusable_part(command, "idn" if protocol == "SoE" else "object_index")
    if index is None or unusable is not None:
        yield f"{protocol} InitCmd of the {owner} is left out: its {unusable} cannot be used"
        return []
    data = decode_hex_binary(command.data)
    written = StartCommand(
        "",
        protocol,
        index,
        command.subindex or 0,
        data or b"",
        bool(command.complete_access),
        command.channel,
        one_line(command.comment or ""),
        bool(command.adapt_automatically),
    )
    if not command.transitions:
        yield f"InitCmd {written.place} of the {owner} is left out: it names no transition"
    commands = []
    for transition in command.transitions:
        found = written._replace(transition=transition_of(transition))
        if found.transition not in TRANSITIONS:
            yield f"InitCmd {found.place} of the {owner} is left out: transition {transition!r} is unknown"
        elif not data:
            yield f"InitCmd {found.place} of the {owner} is left out: its data are missing or not hex"
        else:
            commands.append(found)
    return commands


def _module_list(device: Device, plugged: Iterable[PluggedModule], count_is_read_only: bool) -> Iterator[StartCommand]:
    """The idents of the plugged modules, 0 for an empty slot, where the device wants to be told (0xF030)."""
    if not device.download_module_ident_list:
        return
    values = [ident.to_bytes(4, "little") for ident in module_idents(device, plugged)]
    if not values:
        return
    data = len(values).to_bytes(2, "little") + b"".join(values)
    whole = StartCommand(
        list_transition(device),
        "CoE",
        MODULE_IDENT_LIST,
        0,
        data,
        complete_access=True,
        comment="Configured module ident list",
        count_is_read_only=count_is_read_only,
    )
    has_complete_access = device.mailbox is not None and device.mailbox.coe_complete_access
    yield from (whole,) if has_complete_access else single_accesses(whole)


def single_accesses(command: StartCommand) -> Iterator[StartCommand]:
    """A write of the whole module ident list (0xF030) as one write for each subindex, with the number of them last.

    That is 0 until then, and not written where the description says that it cannot be.
    """
    values = [command.data[start : start + 4] for start in range(2, len(command.data), 4)]
    single = command._replace(complete_access=False)
    if not command.count_is_read_only:
        yield single._replace(data=b"\0")
    for subindex, value in enumerate(values, 1):
        yield single._replace(subindex=subindex, data=value, comment=f"Slot {subindex - 1}")
    if not command.count_is_read_only:
        yield single._replace(data=command.data[:1])
