"""Which CiA 402 modes a drive can run: verdict per axis and mode, and the recipe to get there.

Modules that are alternatives in one slot are judged one by one, each with the device's own evidence; the device can do
what any of them can, and the recipe names which one to plug.
"""

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from itertools import chain, islice
from typing import Annotated, NamedTuple

import msgspec

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.records.common import display_text
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.axes import may_be_commanded
from esicatalog.model.cia402 import CIA402, DRIVE_MODES, DriveMode, claimed_modes
from esicatalog.model.dictionary import enum_values
from esicatalog.model.dictionary_views import DictionaryView, DictionaryViews
from esicatalog.model.drive_configurations import (
    configurations,
    device_parts,
    module_parts,
    never_alone,
    slots_declaring,
)
from esicatalog.model.drive_evidence import (
    NO,
    RANKS,
    YES,
    ModeEvidence,
    axis_alone,
    find_evidence,
    module_names,
    start_evidence,
    writes_mode,
)
from esicatalog.model.drive_parts import Part, is_drive, mapping_pdos, marked_objects, yielding
from esicatalog.model.drive_recipe import mode_recipe
from esicatalog.model.drive_setup import ConfiguredDrive
from esicatalog.model.pdo_facts import has_idns
from esicatalog.model.process_image import SmImage, default_process_image
from esicatalog.model.profile_facts import is_encoder, is_motion_terminal
from esicatalog.model.slots import default_modules

LIKELY = "likely"
YES_FROM, LIKELY_FROM, POSSIBLE_FROM = 0.8, 0.5, 0.2
_CAP_AGAINST_DECLARATION = 0.2
"""Names and inference count little where 0x6502 or a value of 0x6060 denies the mode."""
_CAPPED_RANKS = ("C", "D")


class DriveModeVerdict(Record):
    """The answer for one mode of one axis."""

    axis: Annotated[int, Doc("Axis, from 0")] = 0
    mode: Annotated[str, Doc("PP VL PV TQ HM IP CSP CSV CST CSTCA, or another drive system's name for it")] = ""
    kind: Annotated[str, Doc("CiA 402; MDP 742 (motion terminals with modes of their own); SoE")] = CIA402
    verdict: Annotated[str, Doc("yes, likely, possible, no or unknown")] = "unknown"
    score: Annotated[float, Doc("Weight of the best evidence, 0 to 1")] = 0.0
    conflict: Annotated[bool, Doc("The description contradicts itself about this mode")] = False
    evidence: Annotated[str, Doc("The best evidence in words")] = ""
    module_ident: Annotated[int | None, Doc("Module to plug; NULL when none is needed")] = None
    module_is_default: Annotated[bool | None, Doc("Whether that module is the default one")] = None
    rx_pdo_index: Annotated[int | None, Doc("RxPDO that maps the setpoint")] = None
    rx_pdo_is_default: Annotated[bool | None, Doc("Whether that RxPDO is assigned by default")] = None
    op_mode: Annotated[str | None, Doc("OpMode of the distributed clocks to choose")] = None
    recipe: Annotated[str | None, Doc("What to plug, assign, choose and write, in words")] = None


class DriveModes(Record):
    """All findings and the verdicts of a device."""

    evidence: tuple[ModeEvidence, ...] = ()
    verdicts: tuple[DriveModeVerdict, ...] = ()


def accepted_verdicts(strict: bool = False) -> tuple[str, ...]:
    """Verdicts by which a drive counts as one that runs a mode: yes, and likely unless strict."""
    return (YES,) if strict else (YES, LIKELY)


def drive_modes(
    device: Device,
    modules: Sequence[Module] = (),
    views: DictionaryViews | None = None,
    images: Sequence[SmImage] | None = None,
) -> DriveModes:
    """Findings and verdicts for a device with the modules its slots can reach.

    ``views`` knows dictionaries that were looked at before, ``images`` is the default process image where it is known.
    """
    views = views or DictionaryViews()
    drives = [module for module in modules if may_be_commanded(module, views)]
    if has_idns(device) or (not drives and not may_be_commanded(device, views)):
        return DriveModes(verdicts=tuple(_other_systems(device, modules, views)))
    there = default_modules(device, modules)
    images = default_process_image(device, modules) if images is None else images
    own = device_parts(device, views, images)
    own_axes = {part.axis for part in own if is_drive(part)}
    marked = {index for part in own for index in marked_objects(part)}
    declaring = slots_declaring(device, modules, marked) if marked else {}
    own = [yielding(part, declaring) for part in own]
    plugged = module_parts(device, modules if own_axes else drives, views)
    groups = configurations(device, own, plugged, declaring, there)
    by_part = _findings([part for sets in groups.values() for parts in sets for part in parts], own_axes)
    speaking = [part for part in chain(*plugged.values()) if by_part.get(id(part)) or writes_mode(part)]
    for axis in never_alone(device, modules, speaking) if speaking else ():
        del groups[axis][0]
    found = {axis: [_Configuration(parts, _said(parts, by_part)) for parts in sets] for axis, sets in groups.items()}
    evidence = list(dict.fromkeys(item for sets in found.values() for one in sets for item in one.findings))
    evidence += _axes_alone(groups, {item.axis for item in evidence})
    defaults = {(item.slot_number, item.module.module_ident) for item in there}
    drive = ConfiguredDrive(device, there, images)
    judged = [
        _best(drive, axis, mode, sets, defaults)
        for axis, sets in sorted(found.items())
        for mode in DRIVE_MODES.values()
    ]
    verdicts = [verdict for verdict in judged if verdict is not None]
    if not verdicts:
        verdicts = _other_systems(device, modules, views)
    return DriveModes(evidence=tuple(evidence), verdicts=tuple(verdicts))


def _findings(parts: Iterable[Part], own_axes: Container[int]) -> dict[int, list[ModeEvidence]]:
    """Findings of the parts that are drives, or belong to one without being an encoder, by the part's identity."""
    return {
        number: list(find_evidence(part))
        for number, part in {id(part): part for part in parts}.items()
        if is_drive(part) or (part.axis in own_axes and not _is_encoder_module(part))
    }


def _is_encoder_module(part: Part) -> bool:
    return part.plugged is not None and is_encoder(part.plugged.module.profiles)


class _Configuration(NamedTuple):
    """Parts that act together, a module last, and all that is found for them."""

    parts: list[Part]
    findings: list[ModeEvidence]


def _said(parts: list[Part], by_part: Mapping[int, Sequence[ModeEvidence]]) -> list[ModeEvidence]:
    """What is found for parts that act together; nothing where none of them is a drive."""
    found = [by_part[id(part)] for part in parts if id(part) in by_part]
    return [*chain.from_iterable(found), *start_evidence(parts)] if found else []


def _axes_alone(groups: Mapping[int, list[list[Part]]], told: Container[int]) -> Iterator[ModeEvidence]:
    """A finding for each axis that has no other one."""
    for axis, sets in sorted(groups.items()):
        if axis not in told:
            drives = (part for parts in sets for part in parts if is_drive(part))
            yield from map(axis_alone, islice(drives, 1))


class _Judged(NamedTuple):
    """A verdict, the parts it is about, the module among them and whether that is there by default."""

    verdict: DriveModeVerdict
    parts: list[Part]
    module: Part | None
    is_default: bool
    has_setpoint: bool

    @property
    def preference(self) -> tuple[float, bool, bool, bool]:
        """The best answer first; of equal ones that with its setpoint in an RxPDO, then that without a choice.

        A "no" that something contradicts tells more.
        """
        is_no = self.verdict.verdict == NO
        score = 0.0 if is_no else self.verdict.score
        return score, self.has_setpoint and not is_no, self.is_default, is_no and self.verdict.conflict


def _best(
    drive: ConfiguredDrive,
    axis: int,
    mode: DriveMode,
    configurations: Iterable[_Configuration],
    defaults: set[tuple[int, int | None]],
) -> DriveModeVerdict | None:
    judged: list[_Judged] = []
    for parts, said in configurations:
        findings = [item for item in said if item.mode == mode.name]
        verdict = _verdict(axis, mode, findings) if findings else None
        if verdict is not None:
            module = next((part for part in reversed(parts) if part.module_ident is not None), None)
            is_default = module is None or (module.slot_number, module.module_ident) in defaults
            has_setpoint = not mode.setpoints or any(mapping_pdos(part, mode) for part in parts)
            judged.append(_Judged(verdict, parts, module, is_default, has_setpoint))
    if not judged:
        return None
    best = max(judged, key=lambda item: item.preference)
    if best.verdict.verdict == NO:
        return best.verdict
    module = best.module
    plug = _plug_words(best, module, judged) if module is not None else None
    recipe = mode_recipe(drive, mode, best.parts, plug)
    return msgspec.structs.replace(
        best.verdict,
        module_ident=module.module_ident if module is not None else None,
        module_is_default=best.is_default if module is not None else None,
        rx_pdo_index=recipe.pdos[0].pdo_index if recipe.pdos else None,
        rx_pdo_is_default=recipe.pdos_are_default if recipe.pdos else None,
        op_mode=recipe.op_mode,
        recipe=recipe.words,
    )


def _plug_words(best: _Judged, module: Part, judged: Iterable[_Judged]) -> str:
    """What to plug, and the other modules for this slot that do as well."""
    alternatives = [
        f"or 0x{item.module.module_ident:X}"
        for item in judged
        if item.verdict.score == best.verdict.score and item.has_setpoint == best.has_setpoint
        if item.module is not None and item.module.slot_number == module.slot_number and item.module is not module
    ]
    which = ["default" if best.is_default else "not the default", *alternatives]
    return f"plug module 0x{module.module_ident:X} into slot {module.slot_number} ({', '.join(which)})"


def _verdict(axis: int, mode: DriveMode, findings: list[ModeEvidence]) -> DriveModeVerdict | None:
    against = max((item for item in findings if item.polarity == NO), key=lambda item: item.score, default=None)
    conflict = any(item.conflict for item in findings)

    def weight(item: ModeEvidence) -> float:
        capped = against is not None and item.rank[0] in _CAPPED_RANKS
        return min(item.score, _CAP_AGAINST_DECLARATION) if capped else item.score

    for_it = [item for item in findings if item.polarity == YES]
    best = max(for_it, key=weight, default=None)
    score = weight(best) if best is not None else 0.0
    if against is not None:
        contradicted = any(item.score >= LIKELY_FROM for item in for_it)
        if score < LIKELY_FROM:
            return DriveModeVerdict(
                axis=axis,
                mode=mode.name,
                verdict=NO,
                score=against.score,
                conflict=conflict or contradicted,
                evidence=against.evidence,
            )
        score, conflict = min(score, LIKELY_FROM), True
    if best is None:
        return None
    return DriveModeVerdict(
        axis=axis, mode=mode.name, verdict=_word(score), score=score, conflict=conflict, evidence=best.evidence
    )


def _word(score: float) -> str:
    """The verdict that a score means."""
    words = ((YES, YES_FROM), (LIKELY, LIKELY_FROM), ("possible", POSSIBLE_FROM))
    return next((word for word, least in words if score >= least), "unknown")


def _other_systems(device: Device, modules: Sequence[Module], views: DictionaryViews) -> list[DriveModeVerdict]:
    """What does not speak CiA 402: SoE, and motion terminals of the modular device profile.

    SoE is declared by other devices than drives, and no element says which it is.
    """
    if device.mailbox is not None and device.mailbox.soe:
        text = "speaks SoE: if it is a drive, its modes are in IDN S-0-0032 and following, not in CiA 402 objects"
        return [DriveModeVerdict(mode="SoE", kind="SoE", verdict="unknown", evidence=text)]
    owners: list[Device | Module] = [device, *modules]
    found: dict[str, DriveModeVerdict] = {}
    for owner in owners:
        for view in views.of(owner.profiles) if is_motion_terminal(owner.profiles) else ():
            for mode, place in view.once(_listed_modes).items():
                if mode not in found:
                    found[mode] = _listed_mode(device, modules, owner, mode, place)
    return list(found.values())


def _listed_mode(
    device: Device, modules: Sequence[Module], owner: Device | Module, mode: str, place: tuple[int, str]
) -> DriveModeVerdict:
    """What a list of a motion terminal says of a mode, be it the device's or that of one of its modules."""
    _, score = RANKS["B2"]
    index, text = place
    words = f"values of 0x{index:04X} list {text!r}; no CiA 402 object"
    verdict = DriveModeVerdict(mode=mode, kind="MDP 742", verdict=_word(score), score=score, evidence=words)
    if not isinstance(owner, Module):
        return verdict
    return msgspec.structs.replace(
        verdict,
        evidence=f"module {module_names(owner)!r}: {words}",
        module_ident=owner.module_ident,
        module_is_default=any(item.module is owner for item in default_modules(device, modules)),
    )


def _listed_modes(view: DictionaryView) -> dict[str, tuple[int, str]]:
    """Modes that values of objects or of their sub-items name: the object and the text where each is named first."""
    types = view.types.by_name
    named = {
        name: [
            (mode, text)
            for text in [display_text(item.texts) or "" for item in enum_values(name, types)]
            for mode in sorted(claimed_modes(text))
        ]
        for name in types
    }
    found: dict[str, tuple[int, str]] = {}
    for declared in view.dictionary.objects:
        data_type = types.get(declared.type or "")
        sub_items = data_type.sub_items if data_type is not None else ()
        for type_name in (declared.type, *(sub_item.type for sub_item in sub_items)):
            for mode, text in named.get(type_name or "", ()):
                found.setdefault(mode, (declared.object_index or 0, text))
    return found
