"""Identities as people write them: numbers in any notation, ``VENDOR:PRODUCT[:REVISION][@VARIANT]``."""

import re
from collections.abc import Iterable
from typing import NamedTuple

from esicatalog.errors import InputError
from esicatalog.words import hex32, one_line

UINT32_MAX = 0xFFFF_FFFF
MAX_INDEX, MAX_SUBINDEX = 0xFFFF, 0xFF
"""Of the objects of a dictionary."""
NO_REVISION = "-"
"""Stands for the revision of a description that names none."""
_MOST_DIGITS = 20
_SHOWN = 60

_BOUNDS_WRITTEN = "write <=8, >=8 or 8"
_BOUNDS = re.compile(r"(<=|>=|=)?\s*(-?)(.+)", re.DOTALL)
_COE_SUBINDEX = re.compile(r"(?=.*[a-f])[0-9a-f]{2}", re.IGNORECASE)
"""Two digits of which one tells that they are hexadecimal."""
_NUMBER = re.compile(r"(?:0x|#x)([0-9a-f]+)|([0-9]+)", re.IGNORECASE)


class Identity(NamedTuple):
    """A device identity; ``revision_no`` None means the latest, ``variant`` None the preferred.

    ``without_revision`` means the descriptions of the product that name none.
    """

    vendor_id: int
    product_code: int
    revision_no: int | None = None
    variant: int | None = None
    without_revision: bool = False

    def __str__(self) -> str:
        revision = f":{hex32(self.revision_no)}" if self.revision_no is not None else ":-" * self.without_revision
        variant = f"@{self.variant}" if self.variant is not None else ""
        return f"{hex32(self.vendor_id)}:{hex32(self.product_code)}{revision}{variant}"


def identity_text(vendor_id: int | None, product_code: int | None, revision_no: int | None, variant: int = 1) -> str:
    """The identity of a description as the commands take it: ``@VARIANT`` unless preferred, ``-`` where not given."""
    text = ":".join(hex32(number, NO_REVISION) for number in (vendor_id, product_code, revision_no))
    return text if variant == 1 else f"{text}@{variant}"


class ModuleChoice(NamedTuple):
    """A module by its ModuleIdent, and by its label where several modules share the ident.

    The label is the Type of the module; ``TYPE#1``, ``TYPE#2`` where modules share that too.
    """

    module_ident: int
    label: str | None = None

    def __str__(self) -> str:
        return f"0x{self.module_ident:X}" + (f"/{self.label}" if self.label is not None else "")


class Bounds(NamedTuple):
    """Smallest and largest number that counts, None = open."""

    least: int | None
    most: int | None


def is_read(vendor_id: int, product_code: int) -> bool:
    """Whether an identity is one: vendor 0 and product 0 are what masters print of a slave whose SII they did not read.

    An EEPROM that nobody wrote holds the same.
    """
    return bool(vendor_id or product_code)


def parse_number(text: str, what: str = "number", limit: int = UINT32_MAX) -> int:
    """A number written ``0x1097``, ``#x1097`` or ``4247``. Raises :class:`InputError`."""
    match = _NUMBER.fullmatch(text.strip())
    if match is None:
        shown = f"{what} {text[:_SHOWN]!r}"
        if _NUMBER.fullmatch(text.strip().removeprefix("-")):
            raise InputError(f"{shown} is negative; give a number from 0 on")
        raise InputError(f"{shown} is not a number; write 0x1097, #x1097 or 4247")
    digits = (match[1] or match[2]).lstrip("0") or "0"
    value = int(digits, 16 if match[1] else 10) if len(digits) <= _MOST_DIGITS else None
    if value is None or value > limit:
        raise InputError(f"{what} {text[:_SHOWN]!r} is larger than 0x{limit:x}")
    return value


def checked_number(value: object, what: str) -> int:
    """A number of an identity, whatever type callers declared. Raises :class:`InputError`."""
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= UINT32_MAX:
        raise InputError(f"{what} {repr(value)[:_SHOWN]} is no number from 0 to 0x{UINT32_MAX:x}")
    return value


def checked(identity: Identity) -> Identity:
    """The same identity, if it can be one, whatever types callers declared. Raises :class:`InputError`."""
    checked_number(identity.vendor_id, "vendor")
    checked_number(identity.product_code, "product")
    if identity.revision_no is not None:
        checked_number(identity.revision_no, "revision")
        if identity.without_revision:
            raise InputError(f"revision 0x{identity.revision_no:x} is given, and that there is none; give one of both")
    if identity.variant is not None and checked_number(identity.variant, "variant") == 0:
        raise InputError("variants count from 1")
    return identity


def parse_identity(text: str) -> Identity:
    """An identity written ``V:P[:R][@VARIANT]``, R ``-`` where none is described. Raises :class:`InputError`."""
    numbers, at, variant = text.partition("@")
    vendor, *rest = numbers.split(":")
    if len(rest) not in (1, 2):
        raise InputError(f"identity {text!r} is not VENDOR:PRODUCT[:REVISION][@VARIANT]")
    return identity_of_parts(vendor, rest[0], rest[1] if len(rest) == 2 else None, variant if at else None)


def identity_of_parts(vendor: str, product: str, revision: str | None, variant: str | None) -> Identity:
    """The identity of parts as :func:`parse_identity` reads them; None for those that are not there.

    Raises :class:`InputError`.
    """
    without_revision = revision == NO_REVISION
    return checked(
        Identity(
            parse_number(vendor, "vendor"),
            parse_number(product, "product"),
            None if revision is None or without_revision else parse_number(revision, "revision"),
            parse_number(variant, "variant") if variant is not None else None,
            without_revision,
        )
    )


def identity_of(identity: str | Identity) -> Identity:
    """An identity that callers give as one or as its text. Raises :class:`InputError`."""
    return parse_identity(identity) if isinstance(identity, str) else checked(identity)


def parse_object(text: str) -> tuple[int, int | None]:
    """An object written ``INDEX[:SUBINDEX]``, as :func:`parse_subindex` says. Raises :class:`InputError`."""
    index, colon, subindex = text.partition(":")
    return parse_number(index, "index", MAX_INDEX), parse_subindex(subindex) if colon else None


def parse_subindex(text: str) -> int:
    """A subindex in any notation, or in two hex digits as CoE writes it (``0x6000:0A``).

    Raises :class:`InputError`, also for ``10`` to ``99`` without prefix: as CoE writes them they are other subindices.
    """
    digits = text.strip()
    if _COE_SUBINDEX.fullmatch(digits):
        return int(digits, 16)
    value = parse_number(digits, "subindex", MAX_SUBINDEX)
    if digits.isdecimal() and 10 <= value <= 99:
        raise InputError(
            f"subindex {text[:_SHOWN]!r} is ambiguous: write 0x{value} if it is hexadecimal, 0x{value:02X} if decimal"
        )
    return value


def parse_plugged(text: str) -> tuple[int, ModuleChoice]:
    """A module in a slot written ``SLOT=IDENT`` or ``SLOT=IDENT/TYPE``. Raises :class:`InputError`."""
    slot, equals, module = text.partition("=")
    ident, slash, label = module.partition("/")
    label = one_line(label)
    if not equals or (slash and not label):
        raise InputError(f"module {text[:_SHOWN]!r} is not SLOT=IDENT[/TYPE], e.g. 0=0x119800")
    number = parse_number(slot, "slot", 0xFFFF)
    return number, ModuleChoice(parse_number(ident, "module ident"), label if slash else None)


def modules_by_slot(plugged: Iterable[tuple[int, ModuleChoice]]) -> dict[int, ModuleChoice]:
    """The modules that are chosen, by slot. Raises :class:`InputError` for a slot that is given twice."""
    modules: dict[int, ModuleChoice] = {}
    for slot, module in plugged:
        if slot in modules:
            raise InputError(f"slot {slot} is given twice, with module {modules[slot]} and with module {module}")
        modules[slot] = module
    return modules


def parse_bounds(text: str, what: str = "amount") -> Bounds:
    """An amount written ``<=8``, ``>=8`` or ``8``, in any notation, also negative. Raises :class:`InputError`."""
    match = _BOUNDS.fullmatch(text.strip())
    if match is None:
        raise InputError(f"{what} is empty; {_BOUNDS_WRITTEN}")
    if match[3].startswith(("<", ">", "=")):
        raise InputError(f"{what} {text[:_SHOWN]!r} is no such amount; {_BOUNDS_WRITTEN}")
    value = parse_number(match[3], what) * (-1 if match[2] else 1)
    return Bounds(None if match[1] == "<=" else value, None if match[1] == ">=" else value)


def parse_modes(text: str) -> tuple[str, ...]:
    """Drive modes written ``CSV`` or ``CSV,CSP``, in any case."""
    return tuple(dict.fromkeys(part.strip().upper() for part in text.split(",")))
