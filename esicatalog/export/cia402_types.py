"""Which values of CiA 402 have a sign (IEC 61800-7-201), and what is taken where a description says something else.

Descriptions are right about lengths, and often careless about signs: ``ethercat xml`` of IgH, which knows no types,
writes UINT32 for whatever has 32 bits. A setpoint or actual value without its sign reads -1 as 4294967295.
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from esicatalog.model.base_types import BASE_TYPES, BaseType
from esicatalog.model.cia402 import AXIS_STEP

_VALUE, _ELEMENTS = range(1), range(1, 0xFF)
"""Subindices of an object that is a value, and of the values of an array."""
_OBJECTS: dict[tuple[str, range], tuple[int, ...]] = {
    ("SINT", _VALUE): (0x6060, 0x6061, 0x6098),
    ("INT", _VALUE): (
        *(0x6042, 0x6043, 0x6044, 0x605A, 0x605B, 0x605C, 0x605D, 0x605E, 0x606A, 0x6071, 0x6074, 0x6077, 0x6078),
        *(0x6086, 0x6088, 0x60B2, 0x60C0),
    ),
    ("DINT", _VALUE): (
        *(0x6062, 0x6063, 0x6064, 0x6069, 0x606B, 0x606C, 0x607A, 0x607C, 0x60B0, 0x60B1, 0x60BA, 0x60BB, 0x60BC),
        *(0x60BD, 0x60F4, 0x60FA, 0x60FC, 0x60FF),
    ),
    ("DINT", _ELEMENTS): (0x607B, 0x607D, 0x60C1, 0x60E4, 0x60E5),
    ("SINT", range(2, 3)): (0x60C2,),
}
SIGNED_OBJECTS = {
    index: (BASE_TYPES[name], subindices) for (name, subindices), indices in _OBJECTS.items() for index in indices
}
"""Type and subindices of the values with a sign, by index of the first axis."""
_WITHOUT_SIGN = ("uint", "bits")
"""Kinds of declared types that may stand for a value with a sign: they give its length."""


class EntryType(NamedTuple):
    """The type of an entry, and what is remarked of it."""

    base: BaseType | None
    remark: str | None = None


class Mapped(NamedTuple):
    """What is mapped: an object or one of its values."""

    object_index: int
    subindex: int
    bit_length: int
    name: str

    @property
    def words(self) -> str:
        """Index, subindex and name."""
        return f"0x{self.object_index:04X}:{self.subindex:02X} {self.name}".rstrip()


def entry_type(mapped: Mapped, declared: BaseType | None, axes: Iterable[int], is_known: bool) -> EntryType:
    """The type of what is mapped: as it is declared, with the sign that CiA 402 gives it, which also types the rest.

    ``axes`` are the CiA 402 axes of the device; ``is_known`` tells whether a dictionary has the subindex. What has
    another length or kind than in CiA 402 stays as declared. An integer at a subindex beside the single value of an
    object has its sign where no dictionary knows it: that a subindex is mistaken is likelier than a value that nobody
    describes, and a target without its sign is the worse error.
    """
    standard = next(_standard_types(mapped, axes), None)
    if standard is None:
        return EntryType(declared)
    base, is_beside = standard.base, mapped.subindex not in standard.subindices
    is_as_long = mapped.bit_length == base.bit_size
    is_integer = declared is None or declared.signed or declared.kind in _WITHOUT_SIGN
    if is_beside and (is_known or not is_integer):
        return EntryType(declared)
    if is_as_long and not is_beside and (declared is None or declared.signed):
        return EntryType(declared or base)
    is_taken = is_as_long and is_integer
    given = f"declared {declared.name}" if declared is not None else "no type is declared"
    length = "" if is_as_long else f", {mapped.bit_length} bits"
    where = f" (at subindex 0 only, and no dictionary has subindex {mapped.subindex})" if is_beside else ""
    outcome = "is taken" if is_taken else "is not taken: check it on the device"
    if is_beside and is_taken:
        outcome += ": check on the device what is mapped"
    remark = f"{mapped.words}: {given}{length}; CiA 402 has INTEGER{base.bit_size}{where}, which {outcome}"
    return EntryType(base if is_taken else declared, remark)


class _Standard(NamedTuple):
    """A type that CiA 402 gives an object, and the subindices that have it."""

    base: BaseType
    subindices: range


def _standard_types(mapped: Mapped, axes: Iterable[int]) -> Iterator[_Standard]:
    for axis in axes:
        found = SIGNED_OBJECTS.get(mapped.object_index - axis * AXIS_STEP)
        if found is not None and (mapped.subindex in found[1] or found[1] == _VALUE):
            yield _Standard(*found)
