"""Evidence for CiA 402 drive modes: one finding a place in the description that speaks for or against a mode.

Ranks, scores and traps of ESI-FACTS section 16. Nothing here decides; :mod:`esicatalog.model.drive_modes` does.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Annotated, NamedTuple

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.mailbox import InitCmd
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.model.base_types import BASE_TYPES
from esicatalog.model.cia402 import (
    AXIS_STEP,
    CONTROLWORD,
    DRIVE_MODES,
    MODE_BY_CODE,
    MODES_OF_OPERATION,
    PROFILE_AND_CYCLIC,
    PROFILE_CIA402,
    SINGLE_SETPOINTS,
    STANDARD_BITS,
    SUPPORTED_DRIVE_MODES,
    DriveMode,
    named_modes,
)
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.dictionary_views import DictionaryView, DictionaryViews

MAX_AXES = 8
MODES_OF_OPERATION_OF_AXES = range(MODES_OF_OPERATION, MODES_OF_OPERATION + MAX_AXES * AXIS_STEP, AXIS_STEP)
"""Where 0x6060 lies, axis by axis."""
_CONTROLWORDS = {CONTROLWORD + axis * AXIS_STEP: axis for axis in range(MAX_AXES)}
"""Axes by their controlword."""
YES, NO = "yes", "no"

RANKS: dict[str, tuple[str, float]] = {
    "A+": ("declared in ESI", 0.95),
    "A+ swapped": ("declared in ESI, byte order in doubt", 0.70),
    "A+ short": ("declared in ESI, value shorter than its type", 0.50),
    "A-": ("declared in ESI", 0.90),
    "B1": ("configured by InitCmd", 0.90),
    "B2": ("listed as a value of 0x6060", 0.75),
    "C1": ("named", 0.80),
    "C2": ("configured by InitCmd without its setpoint", 0.50),
    "C3": ("configured by InitCmd against the module's name", 0.15),
    "D1": ("inferred from setpoint and DC", 0.60),
    "D2 profile": ("inferred from setpoint and profile companions", 0.55),
    "D2 cyclic": ("inferred from setpoint and DC, with profile companions", 0.40),
    "D3": ("inferred from setpoint", 0.40),
    "D3 split": ("inferred from setpoint that two modes share", 0.20),
    "E": ("inferred from the dictionary", 0.25),
    "F": ("profile number only", 0.05),
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


class Part(NamedTuple):
    """What is looked at together: the device's own description or one module, for one axis."""

    axis: int
    slot_number: int | None
    """Slot that a module is in."""
    module_ident: int | None
    name: str
    """Names of a module: type and name."""
    views: tuple[DictionaryView, ...]
    """Its dictionaries."""
    rx_pdos: tuple[Pdo, ...]
    assigned: tuple[Pdo, ...]
    """Those of them that are in the default process image; of a module, in the one with it plugged."""
    init_cmds: tuple[InitCmd, ...]
    profiles: tuple[Profile, ...]
    """Those that speak for this axis."""
    sync0: bool
    """Whether an OpMode that it can run in generates SYNC0."""
    axis_shift: int
    """How far the axis's objects lie above those of the first axis."""
    dc_op_mode_name: str | None = None
    """OpMode that a module asks for."""
    replaced: frozenset[int] = frozenset()
    """Objects of the device in whose place those of modules count."""

    def at(self, index: int) -> int:
        """Where an object of the first axis lies in this part."""
        return index + self.axis_shift


def find_evidence(part: Part) -> Iterator[ModeEvidence]:
    """All findings of a part that has CiA 402 evidence."""
    yield from _supported_modes(part)
    yield from _enumerated(part)
    yield from _init_commands(part)
    yield from _named(part)
    yield from _mapped(part)
    yield from _mappable(part)


def has_cia402(part: Part) -> bool:
    """Whether the part is a CiA 402 axis: profile number 402, or a 16 bit controlword of this axis.

    On modular I/O 0x6040 is just an input channel, so the controlword has to look like one.
    """
    if any(_is_cia402(profile) for profile in part.profiles):
        return True
    control = part.at(CONTROLWORD)
    mapped = any(
        entry.entry_index == control and (entry.subindex or 0) == 0 and entry.bit_length == 16
        for pdo in part.rx_pdos
        for entry in pdo.entries
    )
    return mapped or any(control in view.once(_words) for view in part.views)


def _words(view: DictionaryView) -> frozenset[int | None]:
    """Indices of the objects of 16 bits."""
    return frozenset([declared.object_index for declared in view.dictionary.objects if declared.bit_size == 16])


def may_be_drive(owner: Device | Module, views: DictionaryViews) -> bool:
    """Whether a device or module can be a CiA 402 drive: a cheap look before a close one."""
    return (
        any(map(_is_cia402, owner.profiles))
        or any(not view.by_index.keys().isdisjoint(_CONTROLWORDS) for view in views.of(owner.profiles))
        or any(entry.entry_index in _CONTROLWORDS for pdo in owner.rx_pdos for entry in pdo.entries)
    )


def _is_cia402(profile: Profile) -> bool:
    return PROFILE_CIA402 in (profile.profile_no, *(channel.profile_no for channel in profile.channel_infos))


def _declaring(part: Part, index: int) -> DictionaryView | None:
    """The dictionary with the object that counts, None without one."""
    for view in part.views:
        declared = view.by_index.get(index)
        if declared is not None and not (index in part.replaced and declared.overwritten_by_module):
            return view
    return None


def _value(part: Part, index: int) -> ObjectEntry | None:
    """The single value of an object."""
    view = _declaring(part, index)
    resolved = view.resolved(index) if view is not None else None
    return resolved.entries[0] if resolved is not None else None


def _enum_values(part: Part, index: int) -> list[tuple[int | None, str]]:
    """Values and texts of the enumeration that an object's type is."""
    view = _declaring(part, index)
    data_type = view.types.by_name.get(view.by_index[index].type or "") if view is not None else None
    if data_type is None:
        return []
    return [(item.value, display_text(item.texts) or "") for item in data_type.enum_infos]


def marked_objects(part: Part) -> list[int]:
    """Objects that say something about modes and are marked OverwrittenByModule."""
    indices = (SUPPORTED_DRIVE_MODES, MODES_OF_OPERATION, *PROFILE_AND_CYCLIC, *SINGLE_SETPOINTS)
    declared = [(part.at(index), view.by_index.get(part.at(index))) for index in indices for view in part.views]
    return [index for index, item in declared if item is not None and item.overwritten_by_module]


Contents = Mapping[int | None, Sequence[tuple[DictionaryView, ...]]]
"""What slots hold, by number: the dictionaries of each of the alternatives."""


def yielding(part: Part, contents: Contents) -> Part:
    """A part of the device beside what its slots hold: its marked objects yield to theirs (ESI-FACTS section 12)."""
    replaced = frozenset(
        index
        for index in marked_objects(part)
        if any(all(_declares(views, index) for views in alternatives) for alternatives in contents.values())
    )
    return part._replace(replaced=replaced) if replaced != part.replaced else part


def _declares(views: Sequence[DictionaryView], index: int) -> bool:
    return any(index in view.by_index for view in views)


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
    """Default of 0x6502: bit b declares mode b + 1. Absent and zero say nothing."""
    index = part.at(SUPPORTED_DRIVE_MODES)
    entry = _value(part, index)
    if entry is None or not (value := _bits(entry)):
        return
    rank, doubt = "A+", ""
    data = decode_hex_binary(entry.default_raw) if entry.default_kind == "data" else None
    width = (entry.bit_size or 32) // 8
    if data is not None and len(data) < width:
        rank, doubt = "A+ short", f" (only {len(data)} of {width} bytes are given)"
    elif data is not None and not value & STANDARD_BITS:
        swapped = int.from_bytes(data, "big")
        if not swapped or swapped & ~STANDARD_BITS:
            return
        value, rank, doubt = swapped, "A+ swapped", " (bytes look swapped)"
    for mode in DRIVE_MODES.values():
        is_set = bool(value >> mode.bit & 1)
        text = f"0x{index:04X} default {entry.default_raw}{doubt} has bit {mode.bit} ({mode.name})"
        if is_set:
            text = f"declared in ESI: {text} set; read 0x6502 on the drive"
            yield _finding(part, mode, rank, text, conflict=rank != "A+", object_index=index)
        elif rank == "A+":
            text = f"declared in ESI: {text} clear; read 0x6502 on the drive"
            yield _finding(part, mode, "A-", text, polarity=NO, object_index=index)


def _bits(entry: ObjectEntry) -> int:
    """The default as bits: a signed type has them in as many as it is wide, in others a negative number means nothing.

    0x6502 is an UNSIGNED32, but vendors declare it as DINT.
    """
    number = entry.default_int or 0
    if number >= 0:
        return number
    base = BASE_TYPES[entry.base_type] if entry.base_type is not None else None
    return number & ((1 << base.bit_size) - 1) if base is not None and base.signed and base.bit_size else 0


def _enumerated(part: Part) -> Iterator[ModeEvidence]:
    """0x6060 whose type enumerates modes by code, with a text that names the same mode."""
    index = part.at(MODES_OF_OPERATION)
    for value, text in _enum_values(part, index):
        mode = MODE_BY_CODE.get(value) if value is not None else None
        if mode is not None:
            words = f"values of 0x{index:04X} list {value} ({text})"
            yield _finding(part, mode, "B2", words, object_index=index)


def _init_commands(part: Part) -> Iterator[ModeEvidence]:
    """InitCmds that write a mode code to 0x6060."""
    index = part.at(MODES_OF_OPERATION)
    for command in part.init_cmds:
        mode = written_mode(command, index)
        if mode is None:
            continue
        words = f"InitCmd {'/'.join(command.transitions)} writes 0x{index:04X} = {mode.code} ({mode.name})"
        pdos = mapping_pdos(part, mode)
        if listed := other_named_modes(part.name, mode):
            text = f"{words}, but the module's name {part.name!r} lists {listed}"
            yield _finding(part, mode, "C3", text, conflict=True, object_index=index)
        elif pdos or not mode.setpoints:
            mapped = f"; {mapping_words(pdos)} its setpoint {setpoint_words(part, mode)}" if pdos else ""
            pdo_index = pdos[0].pdo_index if pdos else None
            yield _finding(part, mode, "B1", words + mapped, object_index=index, pdo_index=pdo_index)
        else:
            text = f"{words}, but no RxPDO maps its setpoint {setpoint_words(part, mode)}"
            yield _finding(part, mode, "C2", text, conflict=True, object_index=index)


def written_mode(command: InitCmd, index: int) -> DriveMode | None:
    """The mode whose code an InitCmd writes to 0x6060 (of this axis: ``index``)."""
    data = decode_hex_binary(command.data)
    if command.object_index != index or (command.subindex or 0) != 0 or not data:
        return None
    return MODE_BY_CODE.get(int.from_bytes(data[:1], "little", signed=True))


def module_names(module: Module) -> str:
    """Type and name of a module, in which modes may be spelled out."""
    return f"{module.type or ''} / {display_text(module.names) or ''}"


def other_named_modes(name: str, mode: DriveMode) -> str:
    """The modes that a module's name lists where a mode that its command writes is none of them, else empty."""
    named = named_modes(name)
    return ", ".join(sorted(named)) if mode.name not in named else ""


def _named(part: Part) -> Iterator[ModeEvidence]:
    """Names of the module or of a PDO that spell a mode whose setpoint is mapped there."""
    for name in sorted(named_modes(part.name)):
        mode = DRIVE_MODES[name]
        pdos = mapping_pdos(part, mode)
        if pdos:
            text = f"module name {part.name!r} names {name}; {mapping_words(pdos)} {setpoint_words(part, mode)}"
            yield _finding(part, mode, "C1", text, pdo_index=pdos[0].pdo_index)
    for pdo in part.rx_pdos:
        for name in sorted(named_modes(display_text(pdo.names) or "")):
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
            where = f"{pdo_words(pdo)} maps 0x{part.at(setpoint):04X}"
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
        entry = _value(part, index)
        if entry is not None and "R" in (entry.pdo_mapping or ""):
            for mode in modes:
                text = f"0x{index:04X} can be mapped into an RxPDO"
                yield _finding(part, mode, "E", text, object_index=index)


def maps_setpoint(part: Part, pdo: Pdo, setpoints: Sequence[int]) -> bool:
    """Whether a PDO maps these setpoints, all of them.

    A virtual PDO is a description only, nothing transports it (ESI-FACTS sections 9 and 18).
    """
    wanted = {part.at(index) for index in setpoints}
    return bool(wanted) and not pdo.virtual and wanted.issubset([entry.entry_index for entry in pdo.entries])


def mapping_pdos(part: Part, mode: DriveMode) -> list[Pdo]:
    """The RxPDOs that map the setpoint of a mode: one with all of it, else one for each object.

    Drives with one object a PDO assign several, which must not exclude each other. None where an object is not mapped.
    """
    whole = _mapping_pdo(part, mode.setpoints)
    if whole is not None:
        return [whole]
    each = [_mapping_pdo(part, (index,)) for index in mode.setpoints] if len(mode.setpoints) > 1 else []
    found = [pdo for pdo in each if pdo is not None]
    excluded = {item.pdo_index for pdo in found for item in pdo.excludes}
    return found if len(found) == len(each) and excluded.isdisjoint([pdo.pdo_index for pdo in found]) else []


def _mapping_pdo(part: Part, setpoints: Sequence[int]) -> Pdo | None:
    """The RxPDO that maps setpoints: one that is assigned by default before others."""
    fitting = [pdo for pdo in part.rx_pdos if maps_setpoint(part, pdo, setpoints)]
    return next((pdo for pdo in fitting if pdo in part.assigned), fitting[0] if fitting else None)


def maps_mode_of_operation(part: Part, pdos: Sequence[Pdo]) -> Pdo | None:
    """The RxPDO among ``pdos`` that maps 0x6060."""
    index = part.at(MODES_OF_OPERATION)
    return next((pdo for pdo in pdos if any(entry.entry_index == index for entry in pdo.entries)), None)


def setpoint_words(part: Part, mode: DriveMode) -> str:
    """The objects of a mode's setpoint in words."""
    return " and ".join(f"0x{part.at(index):04X}" for index in mode.setpoints)


def pdo_words(pdo: Pdo) -> str:
    """A PDO in words."""
    return f"RxPDO 0x{pdo.pdo_index:04X}" if pdo.pdo_index is not None else "an RxPDO"


def mapping_words(pdos: Sequence[Pdo]) -> str:
    """PDOs in words, as what maps something."""
    return " and ".join(map(pdo_words, pdos)) + (" maps" if len(pdos) == 1 else " map")


def axes_of(views: Sequence[DictionaryView], rx_pdos: Iterable[Pdo]) -> list[int]:
    """Axes above the first whose controlword stands literally in a description."""
    mapped = {entry.entry_index for pdo in rx_pdos for entry in pdo.entries}
    return [
        axis for control, axis in _CONTROLWORDS.items() if axis and (control in mapped or _declares(views, control))
    ]
