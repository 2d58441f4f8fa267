"""Objects of the PDO configuration: what they have to hold, and start-up commands that write something else.

An assignment (0x1C10 + SyncManager) lists PDO indices, a mapping (0x1600 …, 0x1A00 …) entries as index, subindex and
bits; subindex 0 counts them (ETG.1000.6). Complete access from subindex 0 has a byte of padding behind that.
"""

from collections.abc import Container, Iterable, Iterator, Sequence
from typing import NamedTuple

from esicatalog.export.init_cmds import StartCommand
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS
from esicatalog.model.start_up import BEFORE_SAFE_OP

_MAX_COUNT = 254
"""Subindices of an assignment or a mapping."""
_INDEX_BYTES, _ENTRY_BYTES = 2, 4


class PdoObject(NamedTuple):
    """An assignment or mapping with the values that belong into its subindices from 1 on."""

    object_index: int
    values: tuple[int, ...]

    @classmethod
    def that_holds(cls, object_index: int, values: Iterable[int]) -> "PdoObject | None":
        """The object with these values, None where there are none or more than it has subindices."""
        found = tuple(values)
        return cls(object_index, found) if 0 < len(found) <= _MAX_COUNT else None

    @property
    def value_bytes(self) -> int:
        """Length of one value."""
        return _INDEX_BYTES if self.object_index in PDO_ASSIGNMENTS else _ENTRY_BYTES


class Contradiction(NamedTuple):
    """An object into which start-up commands write something else than belongs there; ``words`` name a difference."""

    object_index: int
    words: str


def contradictions(
    commands: Iterable[StartCommand], expected: Iterable[PdoObject], rewritten: Container[int]
) -> Iterator[Contradiction]:
    """What start-up commands that come before SAFE-OP make of the PDO configuration, where that differs.

    An object that they only clear is one that the master is to fill, where it is among those that masters write anew.
    """
    own = [item for item in commands if item.writes_pdo_configuration and item.transition in BEFORE_SAFE_OP]
    for wanted in expected:
        written: dict[int, int] = {}
        for command in own:
            if command.object_index == wanted.object_index:
                written.update(_written(command, wanted.value_bytes))
        is_cleared = written == {0: 0} and wanted.object_index in rewritten
        differing = None if is_cleared else _difference(written, wanted)
        if differing is not None:
            yield Contradiction(wanted.object_index, differing)


def contradiction_remarks(found: Sequence[Contradiction]) -> Iterator[str]:
    """All differences in one remark."""
    if found:
        yield (
            f"the start-up commands write another PDO configuration: {'; '.join(item.words for item in found)}; they "
            "are left out, so check which PDOs the device exchanges, and choose them (--pdo) if it is not these"
        )


def _written(command: StartCommand, value_bytes: int) -> Iterator[tuple[int, int]]:
    """Subindices and values of a command."""
    subindex, data = command.subindex, command.data
    if not subindex:
        yield 0, data[0]
    if not command.complete_access:
        data = data[:value_bytes] if subindex else b""
    elif not subindex:
        subindex, data = 1, data[2:]
    for start in range(0, len(data), value_bytes):
        yield subindex, int.from_bytes(data[start : start + value_bytes], "little")
        subindex += 1


def _difference(written: dict[int, int], wanted: PdoObject) -> str | None:
    """The first subindex that holds something else, with both values; those behind the written number do not count."""
    values = dict(enumerate(wanted.values, 1))
    for subindex in sorted(written.keys() - {0}):
        value = _comparable(written[subindex], wanted)
        if subindex <= written.get(0, _MAX_COUNT) and value != values.get(subindex):
            here = _value_words(values[subindex], wanted) if subindex in values else "nothing"
            return _difference_words(wanted, subindex, _value_words(value, wanted), here)
    if written.get(0, len(values)) != len(values):
        return _difference_words(wanted, 0, str(written[0]), str(len(values)))
    return None


def _difference_words(wanted: PdoObject, subindex: int, written: str, here: str) -> str:
    return f"{written} to 0x{wanted.object_index:04X}:{subindex:02X}, where this file configures {here}"


def _comparable(value: int, wanted: PdoObject) -> int:
    """Of a gap only the length counts."""
    is_gap = wanted.object_index not in PDO_ASSIGNMENTS and not value >> 16
    return value & 0xFF if is_gap else value


def _value_words(value: int, wanted: PdoObject) -> str:
    if wanted.object_index in PDO_ASSIGNMENTS:
        return f"0x{value:04X}"
    return f"0x{value >> 16:04X}:{value >> 8 & 0xFF:02X} ({value & 0xFF} bit)"
