"""Which CiA 402 axes there are (ESI-FACTS sections 12 and 16).

Two questions, and the answers differ on purpose. Which modes a drive *can run* is asked of the controlword: without it
nobody commands an axis, and a statusword alone is no evidence for any mode. What an export *exchanges with* an axis is
asked of either word: status values of an axis want the names of CiA 402 and the warnings for what moves, even where
its controlword is not mapped. For both a word has to look like one: on modular I/O 0x6040 is just an input channel, and
in an encoder (CiA 406) the acceleration. So it has 16 bits, a controlword goes to the device, and a dictionary that
declares one word of an axis has to declare both: CiA 402 demands them. (A statusword counts in either direction: real
robot joints swap the two words.)
"""

from collections.abc import Callable, Iterable, Iterator, Sequence

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.model.cia402 import AXIS_STEP, CONTROLWORD, MAX_AXES, STATUSWORD
from esicatalog.model.dictionary_views import DictionaryView, DictionaryViews
from esicatalog.model.pdo_facts import has_idns, mapped
from esicatalog.model.profile_facts import has_profile_402, is_motion_terminal

_WORD_BITS = 16
_CONTROLWORDS = {CONTROLWORD + axis * AXIS_STEP: axis for axis in range(MAX_AXES)}
"""Axes by their controlword."""
_STATUSWORDS = frozenset(range(STATUSWORD, STATUSWORD + MAX_AXES * AXIS_STEP, AXIS_STEP))


def is_commanded_axis(
    axis: int, profiles: Iterable[Profile], rx_pdos: Iterable[Pdo], views: Iterable[DictionaryView]
) -> bool:
    """Whether a master can command this axis: profile number 402, its controlword mapped, or both words declared.

    ``profiles`` are those that speak for this axis.
    """
    words = _words_of(axis)
    return (
        has_profile_402(profiles)
        or words[0] in _mapped_words(rx_pdos)
        or any(view.once(_declared_words).issuperset(words) for view in views)
    )


def further_axes(views: Sequence[DictionaryView], rx_pdos: Iterable[Pdo]) -> list[int]:
    """Axes above the first whose controlword stands literally in a description, whatever it looks like."""
    mapped = {entry.entry_index for pdo in rx_pdos for entry in pdo.entries}
    return [
        axis
        for control, axis in _CONTROLWORDS.items()
        if axis and (control in mapped or any(control in view.by_index for view in views))
    ]


def may_be_commanded(owner: Device | Module, views: DictionaryViews) -> bool:
    """Whether a device or module can be a CiA 402 drive: a cheap look before a close one."""
    return (
        has_profile_402(owner.profiles)
        or any(not view.by_index.keys().isdisjoint(_CONTROLWORDS) for view in views.of(owner.profiles))
        or any(entry.entry_index in _CONTROLWORDS for pdo in owner.rx_pdos for entry in pdo.entries)
    )


def exchanged_axes(
    device: Device,
    profiles: Sequence[Profile],
    rx_pdos: Iterable[Pdo],
    tx_pdos: Iterable[Pdo],
    declared_bits: Callable[[int], int | None],
) -> Iterator[int]:
    """Axes that process data or objects are of: either word is mapped, or both are declared, as words.

    The first also by profile number 402; none where numbers are IDNs. ``profiles`` are those of the device and of what
    is plugged, ``rx_pdos`` and ``tx_pdos`` the PDOs of the process image, ``declared_bits`` gives the length of an
    object that is a single value, None where no dictionary declares it.
    """
    if has_idns(device):
        return
    mapped, by_profile = _exchanged_words(rx_pdos, tx_pdos), has_profile_402(profiles)
    for axis in range(MAX_AXES):
        words = _words_of(axis)
        is_declared = all(declared_bits(index) == _WORD_BITS for index in words)
        if (by_profile and axis == 0) or is_declared or not mapped.isdisjoint(words):
            yield axis


def may_move(module: Module) -> bool:
    """Whether a module drives an axis, wherever it is plugged: by its profiles, or by either word in its PDOs."""
    if has_profile_402(module.profiles) or is_motion_terminal(module.profiles):
        return True
    return bool(_exchanged_words(module.rx_pdos, module.tx_pdos))


def _words_of(axis: int) -> tuple[int, int]:
    """Controlword and statusword of an axis."""
    return CONTROLWORD + axis * AXIS_STEP, STATUSWORD + axis * AXIS_STEP


def _exchanged_words(rx_pdos: Iterable[Pdo], tx_pdos: Iterable[Pdo]) -> set[int]:
    """The words of axes that PDOs exchange, controlwords and statuswords."""
    commanded, sent = _mapped_words(rx_pdos), _mapped_words(tx_pdos)
    return (_CONTROLWORDS.keys() & commanded) | (_STATUSWORDS & (commanded | sent))


def _mapped_words(pdos: Iterable[Pdo]) -> set[int | None]:
    """Indices of the objects that are mapped as a single value of 16 bits."""
    return {entry.entry_index for pdo in pdos for entry in pdo.entries if mapped(entry)[1:] == (0, _WORD_BITS)}


def _declared_words(view: DictionaryView) -> frozenset[int | None]:
    """Indices of the objects of 16 bits."""
    return frozenset([item.object_index for item in view.dictionary.objects if item.bit_size == _WORD_BITS])
