"""Start-up commands that write a cycle time, compared with the bus cycle: vendors' examples, to be adapted.

S-0-0001 control unit cycle time and S-0-0002 communication cycle time in microseconds (IEC 61800-7-204); cycle time of
the SyncManager parameters in nanoseconds (ETG.1020); the interpolation time period of CiA 402 axes, whose subindex 1
counts times ten to the power of subindex 2, in seconds (IEC 61800-7-201).
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from esicatalog.export.entry_types import ObjectTable
from esicatalog.export.init_cmds import StartCommand
from esicatalog.model.cia402 import AXIS_STEP
from esicatalog.model.start_up import after_start
from esicatalog.model.sync_parameters import SYNC_PARAMETERS

_NS_OF_UNIT = {
    ("SoE", 1, 0): 1_000,
    ("SoE", 2, 0): 1_000,
    **{("CoE", index, 2): 1 for index in SYNC_PARAMETERS},
}
_INTERPOLATION_TIME_PERIOD = 0x60C2
"""Of the first axis; further axes as their objects."""
_VALUE, _EXPONENT = 1, 2
"""Its subindices."""
_USUAL_EXPONENT, _EXPONENT_OF_NS = -3, -9
_MAX_TIME_BYTES = 8
_COUNT_BYTES = 2
"""Of subindex 0 in complete access (ETG.1000.6)."""


def cycle_remarks(
    commands: Sequence[StartCommand],
    axes: Iterable[int],
    objects: ObjectTable,
    cycle_ns: int,
    sync0_ns: Fraction | None,
) -> Iterator[str]:
    """Commands that write a cycle time other than the bus cycle, which the device has when it is in operation.

    For the parameters of SyncManagers the cycle of SYNC0, None when it is not generated, is as good.
    """
    for command, written_ns in _written_times(commands, axes, objects):
        by_sync0 = command.object_index in SYNC_PARAMETERS and written_ns == sync0_ns
        if written_ns != cycle_ns and not by_sync0:
            tool = "; AdaptAutomatically: the configuration tool adapts the data" if command.adapt_automatically else ""
            yield (
                f"InitCmd {command.place} {command.comment}".rstrip()
                + f" writes {written_ns} ns, the bus cycle is {cycle_ns} ns: adapt one of them{tool}"
            )


def _written_times(
    commands: Iterable[StartCommand], axes: Iterable[int], objects: ObjectTable
) -> Iterator[tuple[StartCommand, int | Fraction]]:
    """What a start leaves of cycle times, in nanoseconds, each with the command for one subindex that makes it so."""
    periods = [_INTERPOLATION_TIME_PERIOD + axis * AXIS_STEP for axis in sorted({0, *axes})]
    sizes = dict.fromkeys(periods, (1, 1)) | dict.fromkeys(SYNC_PARAMETERS, (2, 4))
    last = after_start(
        (part.transition, (part.protocol, part.object_index, part.subindex, part.channel), part)
        for command in commands
        for part in _single(command, sizes)
    )
    for (protocol, index, subindex, _), command in last.items():
        unit = _NS_OF_UNIT.get((protocol, index, subindex))
        if unit is not None and len(command.data) <= _MAX_TIME_BYTES:
            yield command, int.from_bytes(command.data, "little") * unit
    for index in periods:
        value, exponent = (last.get(("CoE", index, subindex, 0)) for subindex in (_VALUE, _EXPONENT))
        yield from _written_period(value, exponent, index, objects)


def _written_period(
    value: StartCommand | None, exponent: StartCommand | None, index: int, objects: ObjectTable
) -> Iterator[tuple[StartCommand, Fraction]]:
    """What commands on an interpolation time period make of it; what they do not write stays as the device has it."""
    power = exponent.data[0] if exponent is not None else _default(objects, index, _EXPONENT)
    unit = Fraction(10) ** ((_USUAL_EXPONENT if power is None else _signed(power)) - _EXPONENT_OF_NS)
    if value is not None:
        if len(value.data) <= _MAX_TIME_BYTES:
            yield value, int.from_bytes(value.data, "little") * unit
    elif exponent is not None and (kept := _default(objects, index, _VALUE)):
        yield exponent, kept * unit


def _default(objects: ObjectTable, index: int, subindex: int) -> int | None:
    declared = objects.entry(index, subindex)
    return declared.default_int if declared is not None else None


def _signed(exponent: int) -> int:
    """A byte as the SINT that it is, also where it is declared without sign."""
    return ((exponent + 0x80) & 0xFF) - 0x80


def _single(command: StartCommand, sizes: Mapping[int, tuple[int, ...]]) -> Iterator[StartCommand]:
    """Complete access as a command for each subindex; ``sizes`` are the bytes of the subindices from 1 on."""
    if not command.complete_access:
        yield command
        return
    single, data, first = command._replace(complete_access=False), command.data, command.subindex
    if not first:
        data, first = data[_COUNT_BYTES:], 1
    for subindex, size in enumerate(sizes.get(command.object_index, ()), 1):
        if subindex >= first:
            if len(data) >= size:
                yield single._replace(subindex=subindex, data=data[:size])
            data = data[size:]
