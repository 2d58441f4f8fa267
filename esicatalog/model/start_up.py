"""The InitCmds of a device with its modules, which of its own yield to those, and what they have written in operation.

A command that does not tell where it writes to, what or when is sent by nobody, so it writes nothing.
"""

from collections.abc import Collection, Hashable, Iterable, Iterator
from typing import NamedTuple, TypeVar

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import InitCmd, coe_init_cmds, init_cmds
from esicatalog.esi.records.module import Module
from esicatalog.esi.unreadable import reason_words
from esicatalog.identity import MAX_INDEX
from esicatalog.model.access import PREOP, SAFEOP
from esicatalog.model.slots import ExpandedModule

SENT_IN = {"IP": PREOP, "PS": PREOP, "SO": SAFEOP}
"""State of the device when commands are sent, by the transitions of a start in their order (ESI-FACTS section 10)."""
START_TRANSITIONS = tuple(SENT_IN)
BEFORE_SAFE_OP = tuple([transition for transition, state in SENT_IN.items() if state == PREOP])
"""Those at which the PDO configuration can be written."""
TRANSITIONS = (*START_TRANSITIONS, "SP", "OP", "OS")
"""The last three lead back: in which state commands are sent at them is not defined."""

_WORDS = {"object_index": "index", "idn": "IDN"}
_PARTS = (("subindex", "subindex"), ("channel", "channel"), ("complete_access", "CompleteAccess"))

Place = TypeVar("Place", bound=Hashable)
Written = TypeVar("Written")

Write = tuple[str, Place, Written]
"""Transition, object or what else is written to, and what is written there."""


def transition_of(text: str) -> str:
    """A transition as it is meant, whatever its spelling."""
    return text.strip().upper()


def after_start(writes: Iterable[Write[Place, Written]]) -> dict[Place, Written]:
    """What was last written to each place in the course of a start: transition by transition, in the order given."""
    due = [item for item in writes if item[0] in START_TRANSITIONS]
    due.sort(key=lambda item: START_TRANSITIONS.index(item[0]))
    return {place: written for _, place, written in due}


def unusable_part(command: InitCmd, index_field: str = "object_index") -> str | None:
    """What does not tell where a command writes to, with what stands there instead, None where all is told.

    ``index_field`` has its object or, with ``idn``, its IDN. A subindex and the like that is absent counts as 0.
    """
    index = getattr(command, index_field)
    if index is None or not 0 <= index <= MAX_INDEX:
        return _WORDS[index_field] + reason_words(command, index_field)
    if not 0 <= (command.subindex or 0) <= 0xFF:
        return "subindex"
    return next((words + reason for field, words in _PARTS if (reason := reason_words(command, field))), None)


def written_data(command: InitCmd, index: int) -> bytes | None:
    """What a command writes to an object that is a single value, None when it writes nothing to it."""
    if command.object_index != index or command.subindex or command.complete_access or unusable_part(command):
        return None
    return decode_hex_binary(command.data) or None


def start_command(
    commands: Iterable[InitCmd], index: int, transitions: Collection[str] = START_TRANSITIONS
) -> InitCmd | None:
    """The command whose value an object has after these transitions of a start, None where none of them writes it."""
    due = [command for command in commands if written_data(command, index) is not None]
    writes = ((transition_of(transition), index, command) for command in due for transition in command.transitions)
    return after_start(write for write in writes if write[0] in transitions).get(index)


def written_places(modules: Iterable[Module]) -> set[tuple[int | None, int]]:
    """The objects that the InitCmds of modules write, each with its subindex."""
    return {
        (command.object_index, command.subindex or 0)
        for module in modules
        for command in coe_init_cmds(module.mailbox)
        if _is_sent(command)
    }


def _is_sent(command: InitCmd) -> bool:
    """Whether a command tells all that it takes to send it: where it writes to, what, and when."""
    is_due = any(transition_of(transition) in TRANSITIONS for transition in command.transitions)
    return is_due and unusable_part(command) is None and bool(decode_hex_binary(command.data))


def yields(command: InitCmd, places: Collection[tuple[int | None, int]]) -> bool:
    """Whether a command of the device is left out for those of modules that write ``places`` (ESI-FACTS section 12)."""
    return bool(command.overwritten_by_module) and (command.object_index, command.subindex or 0) in places


class OwnedInitCmd(NamedTuple):
    """An InitCmd as it is sent, and whose it is: of the device, or of the module in a slot."""

    slot_number: int | None
    protocol: str
    command: InitCmd
    """With the index that it has in the slot."""

    @property
    def owner(self) -> str:
        """Whose it is, in words."""
        return "device" if self.slot_number is None else f"module in slot {self.slot_number}"


def all_init_cmds(device: Device, expanded: Iterable[ExpandedModule]) -> Iterator[OwnedInitCmd]:
    """Those of the device that do not yield, then those of its modules slot by slot; all in document order."""
    modules = tuple(expanded)
    replaced = written_places(item.module for item in modules)
    for protocol, command in init_cmds(device.mailbox):
        if not yields(command, replaced):
            yield OwnedInitCmd(None, protocol, command)
    for item in modules:
        for protocol, command in init_cmds(item.module.mailbox):
            yield OwnedInitCmd(item.slot_number, protocol, command)
