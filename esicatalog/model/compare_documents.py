"""Which devices of two documents are to be compared with each other."""

from collections.abc import Hashable, Sequence
from typing import NamedTuple

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.document import Document
from esicatalog.esi.records.module import Module
from esicatalog.model.compare_facts import either, matched_in_steps
from esicatalog.model.compare_words import value_of
from esicatalog.model.module_offer import offered_devices


class DescribedDevice(NamedTuple):
    """A device of a document, with the modules that its slots can reach and the line of its element."""

    vendor_id: int | None
    vendor: str | None
    device: Device
    modules: tuple[Module, ...]
    line: int


Pair = tuple[DescribedDevice | None, DescribedDevice | None]
"""Devices that belong together; None where only one document has one."""


def described_devices(document: Document) -> list[DescribedDevice]:
    """All devices of a document, in its order; also those without codes."""
    return [
        DescribedDevice(info.vendor_id, info.vendor_name, device, modules, line)
        for info, device, modules, line in offered_devices(document)
    ]


def paired_devices(left: Sequence[DescribedDevice], right: Sequence[DescribedDevice]) -> list[Pair]:
    """The devices of two documents that belong together, in the order of the left, then what only the right has.

    Two documents with one device each are compared whatever they describe. Else devices belong together by vendor,
    product and revision, of several of these by type too. Where no revision of a product is in both documents, its
    devices belong together by type, then by their order. Devices without product code go by their type.
    """
    if len(left) == len(right) == 1:
        return [(left[0], right[0])]
    exact = matched_in_steps(left, right, lambda item: (*_identity(item), item.device.type), _identity)
    settled = {_product(item) for item, other in exact if item is not None and other is not None}

    def product(item: DescribedDevice) -> tuple[Hashable, ...]:
        return _identity(item) if _product(item) in settled else _product(item)

    rest = [item for item, other in exact if item is not None and other is None]
    others = [other for item, other in exact if item is None and other is not None]
    loose = matched_in_steps(rest, others, lambda item: (*product(item), item.device.type), product)
    order = {id(item): position for position, item in enumerate((*left, *right))}
    pairs = [pair for pair in exact if None not in pair] + loose
    return sorted(pairs, key=lambda pair: order[id(either(*pair))])


def _identity(item: DescribedDevice) -> tuple[Hashable, ...]:
    return *_product(item), value_of(item.device, "revision_no")


def _product(item: DescribedDevice) -> tuple[Hashable, ...]:
    code = value_of(item.device, "product_code")
    return item.vendor_id, code if code is not None else item.device.type
