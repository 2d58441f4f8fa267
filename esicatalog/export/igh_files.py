"""What the configuration files of programs on top of IgH EtherLab have in common.

Such a program configures the SyncManagers that its file lists, sends SDOs before SAFE-OP, and finds entries by index
and subindex alone.
"""

from collections.abc import Container, Iterable, Iterator
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.export.configuration import Configuration
from esicatalog.export.igh_limits import check_limits, lrw_remarks, master_written, unassigned_remarks
from esicatalog.export.init_cmds import StartCommand
from esicatalog.export.process_image_remarks import MAP_ONCE, mapped_again
from esicatalog.export.sm_configuration import MappedEntry, SmConfiguration
from esicatalog.model.pdo_facts import places_words
from esicatalog.model.sm_facts import OUTPUT
from esicatalog.model.start_up import BEFORE_SAFE_OP

_SAMPLE_ONCE = "choose an OpMode without oversampling (--op-mode), if the device has one"
"""What helps against samples, which a choice of PDOs leaves as they are."""


class Listed(NamedTuple):
    """What a file can say of a device, and remarks about the rest."""

    sync_managers: tuple[SmConfiguration, ...]
    sdos: tuple[StartCommand, ...]
    repeated: frozenset[str]
    """Identifiers of entries with the index and subindex of an earlier one, which the program cannot reach."""
    remarks: tuple[str, ...]


def listed(configuration: Configuration, program: str) -> Listed:
    """The part of a device that goes into the file of a program.

    Raises :class:`InputError` for devices without assigned PDOs, which need no entry there, for PDOs without described
    entries and for what IgH cannot hold.
    """
    check_limits(configuration)
    if not any(sm.is_described for sm in configuration.sync_managers):
        if any(sm.pdos for sm in configuration.sync_managers):
            raise InputError(f"{program} needs the entries of all PDOs, and the description leaves some out")
        if configuration.missing_modules is not None:
            raise InputError(f"{program} has nothing to configure: {configuration.missing_modules}")
        raise InputError(f"the description assigns no PDO: {program} has nothing to configure")
    repeated = list(_repeated(configuration))
    written = master_written(configuration)
    remarks = [
        *_left_out_sync_managers(configuration),
        *unassigned_remarks(configuration),
        *_left_out_commands(configuration, program, written),
    ]
    remarks += lrw_remarks(
        configuration.subject.device, f"see whether {program} has domains for outputs and for inputs in its version"
    )
    remarks += _unreached(configuration, program, [entry for sm, entry in repeated if sm.direction == OUTPUT])
    remarks += _left_out_entries(configuration, program)
    return Listed(
        tuple(_without_empty(sm) for sm in configuration.sync_managers if sm.is_described or sm.is_mailbox),
        tuple(command for command in configuration.commands if _why_left_out(command, written) is None),
        frozenset(entry.identifier for _, entry in repeated),
        tuple(dict.fromkeys(remarks)),
    )


def sign_words(entry: MappedEntry, program: str) -> str:
    """That a program takes a number with a sign for one without."""
    return f"{entry.words}: {program} reads {entry.bit_length} bits without their sign"


def _left_out_sync_managers(configuration: Configuration) -> Iterator[str]:
    """Listed without its PDOs, a SyncManager would get an empty assignment."""
    for sm in configuration.sync_managers:
        if sm.pdos and not sm.is_described:
            yield f"SM{sm.number} is left out: the entries of its PDOs are not described"


def _without_empty(sm: SmConfiguration) -> SmConfiguration:
    """Without entries of no bits: the one program refuses them, the other reads and writes the byte at their place."""
    pdos = (pdo._replace(entries=tuple(entry for entry in pdo.entries if entry.bit_length)) for pdo in sm.pdos)
    return sm._replace(pdos=tuple(pdos))


def _left_out_entries(configuration: Configuration, program: str) -> Iterator[str]:
    for pdo in (pdo for sm in configuration.sync_managers if sm.is_described for pdo in sm.pdos):
        empty = [(entry.entry_index, entry.subindex) for entry in pdo.entries if not entry.bit_length]
        if empty:
            yield (
                f"PDO 0x{pdo.pdo_index:04X} maps {', '.join(places_words(empty))} in no bits, which {program} cannot "
                "handle: left out, and no other entry moves; IgH finds another mapping in the device then, and writes "
                "this one or warns that it cannot"
            )


def _left_out_commands(configuration: Configuration, program: str, written: Container[StartCommand]) -> Iterator[str]:
    """Those that another remark does not name yet, as that about another PDO configuration does."""
    for command in (item for item in configuration.commands if not configuration.is_contradicted(item)):
        why = _why_left_out(command, written)
        if why is not None:
            yield f"{command.words} is left out: {program} {why}"


def _why_left_out(command: StartCommand, written: Container[StartCommand]) -> str | None:
    if command.protocol != "CoE":
        return "cannot send SoE commands"
    if command in written:
        return "writes PDO assignment and mapping itself"
    if command.transition not in BEFORE_SAFE_OP:
        return "sends commands before SAFE-OP only"
    return None


def _unreached(configuration: Configuration, program: str, outputs: Iterable[MappedEntry]) -> Iterator[str]:
    """What becomes of repeated entries; ``outputs`` are those of them that nothing writes."""
    entries = (entry for sm in configuration.sync_managers for entry in sm.entries)
    written = {(entry.entry_index, entry.subindex) for entry in outputs}
    sampled = {
        (entry.entry_index, entry.subindex)
        for sm in configuration.sync_managers
        for pdo in sm.pdos
        for entry in pdo.entries
        if pdo.sample_count > 1
    }
    repeats = mapped_again((entry.entry_index, entry.subindex, entry.bit_length, entry.name) for entry in entries)
    for place, again in repeats.items():
        helps = again.are_copies and (place in sampled or place not in configuration.staying_copies)
        advice = f": {_SAMPLE_ONCE if place in sampled else MAP_ONCE}" if helps else ""
        ending = f", the others stay 0{advice}" if place in written else ""
        yield f"{again.words}: {program} finds entries by index and subindex, and reaches the first one only{ending}"


def _repeated(configuration: Configuration) -> Iterator[tuple[SmConfiguration, MappedEntry]]:
    known: set[tuple[int, int]] = set()
    for sm in configuration.sync_managers:
        for entry in sm.entries:
            place = (entry.entry_index, entry.subindex)
            if place in known:
                yield sm, entry
            known.add(place)
