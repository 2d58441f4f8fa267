"""What can be asked of devices: one field a filter. No SQLAlchemy in here."""

import functools
from typing import Annotated

import msgspec

from esicatalog.errors import InputError
from esicatalog.identity import MAX_INDEX, MAX_SUBINDEX, UINT32_MAX, Bounds, Identity, checked
from esicatalog.model.cia402 import DRIVE_MODES
from esicatalog.model.device_words import MAILBOX_PROTOCOLS
from esicatalog.model.ports import checked_physics

PROTOCOLS = (*MAILBOX_PROTOCOLS, "fsoe")
SYNC_SIGNALS = ("sync0", "sync1")
MODES = tuple(DRIVE_MODES)
IDENTIFICATIONS = ("reg134", "ado")
AMOUNTS = ("bytes_in", "bytes_out", "min_cycle_ns", "e_bus_ma", "axes")
"""The filters that are bounds of an amount."""

UInt32 = Annotated[int, msgspec.Meta(ge=0, le=UINT32_MAX)]
Index = Annotated[int, msgspec.Meta(ge=0, le=MAX_INDEX)]
Subindex = Annotated[int, msgspec.Meta(ge=0, le=MAX_SUBINDEX)]
AskedObject = tuple[Index, Subindex | None]
"""An object: index and subindex, None for every subindex."""


class DeviceFilter(msgspec.Struct, frozen=True, kw_only=True):
    """What devices have to fulfil; all given conditions together. Raises :class:`InputError` for unknown words
    and for values that are not of the type of their field, whoever gives them.

    Sizes, layout and drive modes are those of the default process image and of whatever module can be plugged; an
    answer says on what it rests.
    """

    vendor_id: UInt32 | None = None
    vendor: str | None = None
    """Part of the vendor's name."""
    product_code: UInt32 | None = None
    text: str | None = None
    """Words in vendor, type, name or identity; blank = none, as a search box that is left so."""
    profile_no: UInt32 | None = None
    modes: tuple[str, ...] = ()
    """CiA 402 modes, all of them: verdict yes or likely on some axis, with some module."""
    strict: bool = False
    """Only the verdict yes counts."""
    sync: str | None = None
    """sync0 or sync1: an OpMode generates it."""
    needs_dc: bool = False
    """Every valid OpMode uses distributed clocks."""
    protocol: str | None = None
    complete_access: bool = False
    pdo_assign: bool = False
    pdo_config: bool = False
    bootstrap: bool = False
    """The EEPROM description has a bootstrap mailbox."""
    no_lrw: bool = False
    """Type/@UseLrdLwr: cannot handle LRW frames."""
    identification: str | None = None
    """reg134 or ado: how the device returns its explicit identification."""
    physics: str | None = None
    """Device/@Physics, e.g. YY or KK; trailing blanks do not count."""
    bytes_in: Bounds | None = None
    bytes_out: Bounds | None = None
    min_cycle_ns: Bounds | None = None
    e_bus_ma: Bounds | None = None
    """E-bus current consumed in mA; negative = supplied."""
    axes: Bounds | None = None
    maps: tuple[AskedObject, ...] = ()
    """Some PDO of the device, or of a module that its slots can reach, maps each of these."""
    not_maps: tuple[AskedObject, ...] = ()
    bits: UInt32 | None = None
    """BitLen of the entries that ``maps`` names."""
    objects: tuple[AskedObject, ...] = ()
    like: Identity | None = None
    """Same layout of the default process image as this device."""
    all_variants: bool = False
    """Also the descriptions that are not preferred."""
    include_hidden: bool = False
    """Also the revisions that another description of the vendor supersedes (HideType)."""
    limit: UInt32 | None = None

    def __post_init__(self) -> None:
        for name, default, kind in _fields():
            given = getattr(self, name)
            if given is not default:
                msgspec.structs.force_setattr(self, name, _value(name, given, kind))
        for name in AMOUNTS:
            if any(abs(number) > UINT32_MAX for number in getattr(self, name) or () if number is not None):
                raise InputError(f"{name}: no amount is larger than {UINT32_MAX}")
        if self.like is not None:
            checked(self.like)
        for mode in self.modes:
            one_of("mode", mode, MODES)
        for name, allowed in (("sync", SYNC_SIGNALS), ("protocol", PROTOCOLS), ("identification", IDENTIFICATIONS)):
            word = getattr(self, name)
            if word is not None:
                one_of(name, word, allowed)
        if self.physics is not None:
            msgspec.structs.force_setattr(self, "physics", checked_physics(self.physics))
        if self.bits is not None and not self.maps:
            raise InputError("bits is the length of the entries named by maps; give maps INDEX[:SUBINDEX] too")
        if self.strict and not self.modes:
            raise InputError("strict is about drive modes; give mode too, e.g. CSV")


@functools.cache
def _fields() -> tuple[tuple[str, object, object], ...]:
    """Name, default and type of each filter."""
    return tuple((field.name, field.default, field.type) for field in msgspec.structs.fields(DeviceFilter))


def _value(name: str, given: object, kind: object) -> object:
    """The value of a field: lists become the tuples that they stand for. Raises :class:`InputError`."""
    try:
        if isinstance(given, str):
            given.encode()  # What a shell gives that is no UTF-8 can be looked for in no database.
        return msgspec.convert(given, kind)
    except (msgspec.ValidationError, UnicodeEncodeError) as error:
        raise InputError(f"{name}: {error}") from error


def one_of(name: str, word: str, allowed: tuple[str, ...]) -> None:
    """Raise :class:`InputError` for a word that is none of those there are."""
    if word not in allowed:
        raise InputError(f"{name} {word[:40]!r}: say one of {', '.join(allowed)}")
