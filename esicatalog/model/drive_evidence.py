"""Evidence for CiA 402 drive modes: one finding a place in the description that speaks for or against a mode.

Ranks, scores and traps of ESI-FACTS section 16. Nothing here decides; :mod:`esicatalog.model.drive_modes` does.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Annotated, NamedTuple

import msgspec

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.numbers import decode_hex_binary, parse_hex_dec
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.mailbox import InitCmd
from esicatalog.esi.records.module import Module
from esicatalog.model.base_types import BASE_TYPES
from esicatalog.model.cia402 import (
    CONTROLWORD,
    DRIVE_MODES,
    MODE_BY_CODE,
    MODES_OF_OPERATION,
    PROFILE_AND_CYCLIC,
    SINGLE_SETPOINTS,
    STANDARD_BITS,
    SUPPORTED_DRIVE_MODES,
    DriveMode,
    claimed_modes,
    denies,
    denies_all,
    named_modes,
)
from esicatalog.model.dictionary import ObjectEntry, enum_values
from esicatalog.model.drive_parts import (
    Part,
    declaring_view,
    mapped_setpoint_words,
    mapped_words,
    mapping_pdos,
    mapping_words,
    maps_setpoint,
    may_be_mapped,
    pdo_words,
    setpoint_words,
    single_value,
    single_values,
)
from esicatalog.model.profile_facts import has_profile_402
from esicatalog.model.start_up import start_command, written_data
from esicatalog.model.values import byte_length

YES, NO = "yes", "no"
_OPTIONS = "options"
"""Property in which vendors list values of an object."""
_SINT = range(-0x80, 0x80)
"""What 0x6060 can be."""

RANKS: dict[str, tuple[str, float]] = {
    "A+": ("declared in ESI", 0.95),
    "A+ swapped": ("declared in ESI, byte order in doubt", 0.70),
    "A+ short": ("declared in ESI, value shorter than its type", 0.50),
    "A-": ("declared in ESI", 0.90),
    "B1": ("configured by InitCmd", 0.90),
    "B2": ("listed as a value of 0x6060", 0.75),
    "B2-": ("denied as a value of 0x6060", 0.75),
    "C1": ("named", 0.80),
    "C2": ("configured by InitCmd without its setpoint", 0.50),
    "C3": ("configured by InitCmd against the module's name", 0.15),
    "D1": ("inferred from setpoint and DC", 0.60),
    "D2 profile": ("inferred from setpoint and profile companions", 0.55),
    "D2 cyclic": ("inferred from setpoint and DC, with profile companions", 0.40),
    "D3": ("inferred from setpoint", 0.40),
    "D3 split": ("inferred from setpoint that two modes share", 0.20),
    "E": ("inferred from the dictionary", 0.25),
    "F": ("drive evidence only", 0.05),
}
"""Words and score of each rank."""


class ModeEvidence(Record):
    """One finding about one mode of one axis."""

    axis: Annotated[int, Doc("Axis, from 0: its objects lie at axis * 0x800 above the first one's")] = 0
    module_ident: Annotated[int | None, Doc("Module that it rests on; NULL for the device itself")] = None
    mode: Annotated[str | None, Doc("PP VL PV TQ HM IP CSP CSV CST CSTCA; NULL where no single mode is meant")] = None
    rank: Annotated[str, Doc("Kind of evidence, A+ to F; see docs/drive-modes.md")] = ""
    wording: Annotated[str, Doc("What it is: declared in ESI, configured by InitCmd, named, inferred …")] = ""
    score: Annotated[float, Doc("Weight of the evidence, 0 to 1")] = 0.0
    polarity: Annotated[str, Doc("yes: speaks for the mode, no: against it")] = YES
    conflict: Annotated[bool, Doc("Contradicts something else in the description")] = False
    object_index: Annotated[int | None, Doc("Object that it rests on")] = None
    pdo_index: Annotated[int | None, Doc("PDO that it rests on")] = None
    evidence: Annotated[str, Doc("The finding in words")] = ""


def find_evidence(part: Part) -> Iterator[ModeEvidence]:
    """The findings of a part that has CiA 402 evidence, whatever it acts together with."""
    yield from _supported_modes(part)
    yield from _listed(part)
    yield from _named(part)
    yield from _mapped(part)
    yield from _mappable(part)
    yield from _in_range(part)


def axis_alone(part: Part) -> ModeEvidence:
    """What is found of an axis of which nothing says which modes it has."""
    wording, score = RANKS["F"]
    what = "profile number 402" if has_profile_402(part.profiles) else f"controlword 0x{part.at(CONTROLWORD):04X}"
    text = f"{what}, but nothing says which modes"
    return ModeEvidence(
        axis=part.axis, module_ident=part.module_ident, rank="F", wording=wording, score=score, evidence=text
    )


def _finding(
    part: Part,
    mode: DriveMode,
    rank: str,
    text: str,
    *,
    polarity: str = YES,
    conflict: bool = False,
    object_index: int | None = None,
    pdo_index: int | None = None,
) -> ModeEvidence:
    wording, score = RANKS[rank]
    return ModeEvidence(
        axis=part.axis,
        module_ident=part.module_ident,
        mode=mode.name,
        rank=rank,
        wording=wording,
        score=score,
        polarity=polarity,
        conflict=conflict,
        object_index=object_index,
        pdo_index=pdo_index,
        evidence=text,
    )


def _supported_modes(part: Part) -> Iterator[ModeEvidence]:
    """Default of 0x6502: bit b declares mode b + 1. Absent and zero say nothing.

    Every dictionary of the part that says something counts; where one says yes and another no, both are a conflict.
    """
    index = part.at(SUPPORTED_DRIVE_MODES)
    said = [(entry, modes) for entry in single_values(part, index) if (modes := supported_modes(entry)) is not None]
    for mode in DRIVE_MODES.values():
        claims = {modes.claims(mode) for _, modes in said}
        for entry, modes in said:
            claim, contradicted = modes.claims(mode), {True, False} <= claims
            bit = "set" if claim else "clear"
            text = f"0x{index:04X} default {entry.default_raw}{modes.doubt} has bit {mode.bit} ({mode.name}) {bit}"
            text = f"declared in ESI: {text}; read 0x{index:04X} on the drive"
            if claim:
                doubtful = contradicted or modes.rank != "A+"
                yield _finding(part, mode, modes.rank, text, conflict=doubtful, object_index=index)
            elif claim is not None:
                yield _finding(part, mode, "A-", text, polarity=NO, conflict=contradicted, object_index=index)


class SupportedModes(NamedTuple):
    """What the default of 0x6502 says."""

    bits: int
    """Bit b stands for the mode of the number b + 1."""
    rank: str
    """``A+``, or what speaks against it: ``A+ swapped``, ``A+ short``."""
    doubt: str
    """The same in words, empty where nothing does."""

    def claims(self, mode: DriveMode) -> bool | None:
        """Whether a mode is declared; None where a clear bit says nothing, since something speaks against the value."""
        if self.bits >> mode.bit & 1:
            return True
        return False if self.rank == "A+" else None


def supported_modes(entry: ObjectEntry) -> SupportedModes | None:
    """The modes that the default of 0x6502 declares, None where it says nothing: without one, with 0, or nonsense."""
    value = _bits(entry)
    if not value:
        return None
    data = decode_hex_binary(entry.default_raw) if entry.default_kind == "data" else None
    width = (entry.bit_size or 32) // 8
    if data is not None and len(data) < width:
        return SupportedModes(value, "A+ short", f" (only {len(data)} of {width} bytes are given)")
    if not value & STANDARD_BITS:
        given = data if data is not None else value.to_bytes(max(width, byte_length(value.bit_length())), "little")
        swapped = int.from_bytes(given, "big")
        if not swapped or swapped & ~STANDARD_BITS:
            return None
        return SupportedModes(swapped, "A+ swapped", " (bytes look swapped)")
    return SupportedModes(value, "A+", "")


def _bits(entry: ObjectEntry) -> int:
    """The default as bits: a signed type has them in as many as it is wide, in others a negative number means nothing.

    0x6502 is an UNSIGNED32, but vendors declare it as DINT.
    """
    number = entry.default_int or 0
    if number >= 0:
        return number
    base = BASE_TYPES[entry.base_type] if entry.base_type is not None else None
    return number & ((1 << base.bit_size) - 1) if base is not None and base.signed and base.bit_size else 0


def _listed(part: Part) -> Iterator[ModeEvidence]:
    """Values that 0x6060 can have by an enumeration or options: codes of modes, each for or against its mode.

    Not where the text names another one, or denies something and names others or says more: that is for people to read.
    """
    index = part.at(MODES_OF_OPERATION)
    for what, value, text in _listed_values(part, index):
        mode = MODE_BY_CODE.get(value) if value is not None else None
        if mode is None:
            continue
        named, is_denied = named_modes(text), denies(text)
        if is_denied and (len(named) > 1 or not denies_all(text)):
            continue
        if mode.name in (named or DRIVE_MODES):
            words = f"{what} of 0x{index:04X} list {value} ({text})"
            rank, polarity = ("B2-", NO) if is_denied else ("B2", YES)
            yield _finding(part, mode, rank, words, polarity=polarity, object_index=index)


def _listed_values(part: Part, index: int) -> list[tuple[str, int | None, str]]:
    """The values that an object lists, each with what lists it and its text."""
    view = declaring_view(part, index)
    if view is None:
        return []
    declared = view.by_index[index]
    listed = enum_values(declared.type, view.types.by_name)
    found = [("values", item.value, display_text(item.texts) or "") for item in listed]
    for item in declared.properties:
        if (item.name or "").strip().lower() == _OPTIONS:
            found += [("options", parse_hex_dec(value), text) for value, text in _options(item.value or "").items()]
    return found


def _options(text: str) -> dict[str, str]:
    """Texts by value, as vendors write them into a property: a JSON object. Anything else lists nothing."""
    try:
        return msgspec.json.decode(text, type=dict[str, str])
    except (msgspec.DecodeError, RecursionError):
        return {}


def _in_range(part: Part) -> Iterator[ModeEvidence]:
    """Codes between the minimum and maximum of 0x6060, where it does not list its values.

    The greatest value of its type, SINT, is no statement: nothing was bounded.
    """
    index = part.at(MODES_OF_OPERATION)
    entry = single_value(part, index)
    if entry is None or entry.max_int is None or _listed_values(part, index):
        return
    highest = _as_sint(entry.max_int)
    lowest = _as_sint(entry.min_int) if entry.min_int is not None else _SINT.start
    if highest == _SINT[-1]:
        return
    for mode in DRIVE_MODES.values():
        if lowest <= mode.code <= highest:
            bounds = f"{lowest} to {highest}" if entry.min_int is not None else f"up to {highest}"
            text = f"0x{index:04X} takes values {bounds}, {mode.code} ({mode.name}) among them"
            yield _finding(part, mode, "E", text, object_index=index)


def _as_sint(number: int) -> int:
    """What a number is in 0x6060, which some declare as USINT."""
    return number - 0x100 if number in range(0x80, 0x100) else number


def start_evidence(parts: Sequence[Part]) -> Iterator[ModeEvidence]:
    """The mode whose code 0x6060 has after a start of parts that act together, a module last.

    Of their InitCmds the last of a start counts, the device's before those of a module, and any of them may have the
    RxPDO of the setpoint. A module that has either is what the finding rests on, and its name may say otherwise.
    """
    index = parts[-1].at(MODES_OF_OPERATION)
    command = start_command([command for part in parts for command in part.init_cmds], index)
    mode = written_mode(command, index) if command is not None else None
    if command is None or mode is None:
        return
    writing = next(part for part in reversed(parts) if any(item is command for item in part.init_cmds))
    by_part = ((part, mapping_pdos(part, mode)) for part in (writing, *parts))
    mapping, pdos = next((found for found in by_part if found[1]), (writing, ()))
    part = mapping if writing.plugged is None else writing
    words = f"InitCmd {'/'.join(command.transitions)} writes 0x{index:04X} = {mode.code} ({mode.name})"
    if against := name_against(part.name, mode):
        text = f"{words}, but the module's name {part.name!r} {against}"
        yield _finding(part, mode, "C3", text, conflict=True, object_index=index)
    elif pdos or not mode.setpoints:
        mapped = f"; {mapping_words(pdos)} its setpoint {mapped_setpoint_words(part, mode, pdos)}" if pdos else ""
        pdo_index = pdos[0].pdo_index if pdos else None
        yield _finding(part, mode, "B1", words + mapped, object_index=index, pdo_index=pdo_index)
    else:
        text = f"{words}, but no RxPDO maps its setpoint {setpoint_words(part, mode)}"
        yield _finding(part, mode, "C2", text, conflict=True, object_index=index)


def writes_mode(part: Part) -> bool:
    """Whether InitCmds of a part write 0x6060 in the course of a start."""
    return start_command(part.init_cmds, part.at(MODES_OF_OPERATION)) is not None


def written_mode(command: InitCmd, index: int) -> DriveMode | None:
    """The mode whose code an InitCmd writes to 0x6060 (of this axis: ``index``)."""
    data = written_data(command, index)
    return MODE_BY_CODE.get(mode_code(data)) if data is not None else None


def mode_code(data: bytes) -> int:
    """What 0x6060 holds when this is written to it."""
    return int.from_bytes(data[:1], "little", signed=True)


def module_names(module: Module) -> str:
    """Type and name of a module, in which modes may be spelled out."""
    return f"{module.type or ''} / {display_text(module.names) or ''}"


def name_against(name: str, mode: DriveMode) -> str | None:
    """What a module's name says of modes, where it names some and does not claim the one that a command writes."""
    named = ", ".join(sorted(named_modes(name)))
    if not named or mode.name in claimed_modes(name):
        return None
    return f"names {named} and denies one" if denies(name) else f"lists {named}"


def _named(part: Part) -> Iterator[ModeEvidence]:
    """Names of the module or of a PDO that spell a mode whose setpoint is mapped there."""
    for name in sorted(claimed_modes(part.name)):
        mode = DRIVE_MODES[name]
        pdos = mapping_pdos(part, mode)
        if pdos:
            where = f"{mapping_words(pdos)} {mapped_setpoint_words(part, mode, pdos)}"
            text = f"module name {part.name!r} names {name}; {where}"
            yield _finding(part, mode, "C1", text, pdo_index=pdos[0].pdo_index)
    for pdo in part.rx_pdos:
        for name in sorted(claimed_modes(display_text(pdo.names) or "")):
            mode = DRIVE_MODES[name]
            if maps_setpoint(part, pdo, mode.setpoints):
                text = f"{pdo_words(pdo)} {display_text(pdo.names)!r} names {name} and maps its setpoint"
                yield _finding(part, mode, "C1", text, pdo_index=pdo.pdo_index)


def _mapped(part: Part) -> Iterator[ModeEvidence]:
    """Setpoints in RxPDOs, with and without a DC mode and the companions of profile modes."""
    for pdo in part.rx_pdos:
        if pdo.virtual:
            continue
        mapped = {entry.entry_index for entry in pdo.entries if entry.entry_index}
        for setpoint, (profile, cyclic) in PROFILE_AND_CYCLIC.items():
            if part.at(setpoint) not in mapped:
                continue
            companions = [f"0x{part.at(index):04X}" for index in profile.companions if part.at(index) in mapped]
            where = f"{pdo_words(pdo)} maps {mapped_words(part, part.at(setpoint), [pdo])}"
            if companions:
                text = f"{where} with {', '.join(companions)}"
                yield _finding(part, profile, "D2 profile", text, pdo_index=pdo.pdo_index)
                if part.sync0:
                    yield _finding(part, cyclic, "D2 cyclic", text, pdo_index=pdo.pdo_index)
            elif part.sync0:
                text = f"{where}, and a DC OpMode generates SYNC0"
                yield _finding(part, cyclic, "D1", text, pdo_index=pdo.pdo_index)
            else:
                for mode in (profile, cyclic):
                    text = f"{where}; {profile.name} or {cyclic.name}"
                    yield _finding(part, mode, "D3 split", text, pdo_index=pdo.pdo_index)
        for setpoint, mode in SINGLE_SETPOINTS.items():
            if part.at(setpoint) in mapped:
                text = f"{pdo_words(pdo)} maps 0x{part.at(setpoint):04X}"
                yield _finding(part, mode, "D3", text, pdo_index=pdo.pdo_index)


def _mappable(part: Part) -> Iterator[ModeEvidence]:
    """Setpoints that the dictionary lets into an RxPDO."""
    pairs: list[tuple[int, Iterable[DriveMode]]] = list(PROFILE_AND_CYCLIC.items())
    pairs += [(setpoint, (mode,)) for setpoint, mode in SINGLE_SETPOINTS.items()]
    for setpoint, modes in pairs:
        index = part.at(setpoint)
        if may_be_mapped(part, index):
            for mode in modes:
                text = f"0x{index:04X} can be mapped into an RxPDO"
                yield _finding(part, mode, "E", text, object_index=index)
