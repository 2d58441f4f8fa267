"""What lookups return: plain values that the shell, Python and HTTP print alike."""

import json
from typing import Any, NamedTuple

import msgspec

from esicatalog.esi.records.document import Vendor, damage_words
from esicatalog.esi.records.module import Module
from esicatalog.identity import Identity, identity_text
from esicatalog.model.revisions import ACCEPTED, EXACT, NEWER, OLDER, PRODUCT
from esicatalog.words import hex32

VENDOR, NONE = "vendor", "none"
MATCHES = (EXACT, ACCEPTED, OLDER, NEWER, PRODUCT, VENDOR, NONE)
"""How well the description fits that answers for an identity; with the last two none does."""
_MOST_SHOWN = 12


class FoundDevice(msgspec.Struct, frozen=True):
    """A device description in a list."""

    vendor_id: int | None
    product_code: int | None
    revision_no: int | None
    variant: int
    vendor: str | None
    type: str | None
    name: str | None
    hidden: bool
    """Another description of the vendor supersedes it."""
    evidence: tuple[str, ...] = ()

    @property
    def identity_text(self) -> str:
        """The identity as the commands take it: ``V:P:R``, ``@VARIANT`` unless preferred, ``-`` where not given."""
        return identity_text(self.vendor_id, self.product_code, self.revision_no, self.variant)

    @property
    def identity(self) -> Identity | None:
        """The identity by which it is found again; None without vendor or product."""
        if self.vendor_id is None or self.product_code is None:
            return None
        return Identity(self.vendor_id, self.product_code, self.revision_no, self.variant, self.revision_no is None)

    @property
    def shown_type(self) -> str:
        """What the device is called where it is led to: its type, which documents may leave empty."""
        return self.type or "without type"

    @property
    def shown_evidence(self) -> tuple[str, ...]:
        """Evidence for people, who are told when there is more: an object may be mapped by hundreds of entries."""
        more = len(self.evidence) - _MOST_SHOWN
        return self.evidence if more <= 0 else (*self.evidence[:_MOST_SHOWN], f"and {more:,} more")

    def as_json(self) -> dict[str, Any]:
        """Identities as integers and as ``…_hex`` text."""
        return {
            "vendor_id": self.vendor_id,
            "vendor_id_hex": _hex(self.vendor_id),
            "product_code": self.product_code,
            "product_code_hex": _hex(self.product_code),
            "revision_no": self.revision_no,
            "revision_no_hex": _hex(self.revision_no),
            "variant": self.variant,
            "vendor": self.vendor,
            "type": self.type,
            "name": self.name,
            "hidden": self.hidden,
            "evidence": list(self.evidence),
        }


class UnreachedModules(NamedTuple):
    """The modules of a vendor that no slot of any description reaches."""

    vendor: Vendor
    """As the first of their documents writes it."""
    modules: tuple[Module, ...]


class DeviceSource(msgspec.Struct, frozen=True):
    """A document that carries a description."""

    member: str
    location: str
    line: int
    group_type: str | None
    file_version: int | None
    status: str
    message: str | None
    """Why it was recovered."""
    is_whole: bool
    """Whether nothing of it may be lost."""

    def as_json(self) -> dict[str, Any]:
        """Which document and line, in which group, and whether nothing of the document may be lost."""
        return {
            "member": self.member,
            "line": self.line,
            "group_type": self.group_type,
            "is_whole": self.is_whole,
        }


class IdentifiedDevice(msgspec.Struct, frozen=True):
    """A description with the documents it comes from."""

    device: FoundDevice
    sources: tuple[DeviceSource, ...]

    @property
    def damage(self) -> str | None:
        """That the description may lack something, in words; None where a whole document says the same."""
        if not self.sources or any(source.is_whole for source in self.sources):
            return None
        return damage_words(self.sources[0].member, self.sources[0].message)

    def as_json(self) -> dict[str, Any]:
        """The device's JSON with its sources."""
        return {**self.device.as_json(), "sources": [source.as_json() for source in self.sources]}


class Identification(msgspec.Struct, frozen=True):
    """The answer to "what is this device"; ``device`` is None when nothing of its product is known.

    Anything but ``exact`` names the nearest description, and ``reason`` the rule by which it was chosen.
    """

    vendor_id: int | None
    product_code: int | None
    revision_no: int | None
    match: str
    """One of :data:`MATCHES`.

    Vendor 0 and product 0 are always none: so masters print a slave whose identity they did not read.
    """
    reason: str
    device: IdentifiedDevice | None
    variants: tuple[IdentifiedDevice, ...]
    """All descriptions of the chosen identity by preference, before them one whose CheckRevisionNo made the choice."""
    candidates: tuple[FoundDevice, ...]
    """The next best others."""
    variant_warning: str | None = None
    """How other variants than ``device`` of its identity exchange something else by default."""
    revision_warning: str | None = None
    """The same of other revisions."""

    @property
    def found(self) -> FoundDevice | None:
        """The description without its documents."""
        return self.device.device if self.device is not None else None

    @property
    def is_exact(self) -> bool:
        """Whether the very identity that was asked for is described."""
        return self.match == EXACT

    @property
    def warnings(self) -> tuple[str, ...]:
        """What to know before code is written for the description, and used with another."""
        damage = self.device.damage if self.device is not None else None
        return tuple(words for words in (damage, self.variant_warning, self.revision_warning) if words is not None)

    def as_json(self) -> dict[str, Any]:
        """The answer in the shape of ``esicatalog identify --format json``."""
        return {
            "query": identity_json(self.vendor_id, self.product_code, self.revision_no),
            "match": self.match,
            "reason": self.reason,
            "device": self.device.as_json() if self.device is not None else None,
            "variants": [variant.as_json() for variant in self.variants],
            "candidates": [candidate.as_json() for candidate in self.candidates],
            "warnings": list(self.warnings),
        }


def identity_json(vendor_id: int | None, product_code: int | None, revision_no: int | None) -> dict[str, Any]:
    """The numbers of an identity as integers, then as ``…_hex`` text."""
    numbers = {"vendor_id": vendor_id, "product_code": product_code, "revision_no": revision_no}
    return numbers | {f"{key}_hex": _hex(value) for key, value in numbers.items()}


def _hex(value: int | None) -> str | None:
    return hex32(value) if value is not None else None


def json_bytes(value: Any) -> bytes:
    """JSON as every door gives it: UTF-8, indented, one line end behind it."""
    return json.dumps(value, ensure_ascii=False, indent=2).encode("utf-8", "replace") + b"\n"
