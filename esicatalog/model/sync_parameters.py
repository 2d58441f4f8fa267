"""What a device says of its bus cycle: SM synchronisation parameters (0x1C32, 0x1C33; ETG.1020) and oversampling."""

from collections.abc import Mapping

from esicatalog.esi.records.device import Device
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.sync import valid_op_modes
from esicatalog.model.twincat import sampled_cycles

OUTPUT_SYNC, INPUT_SYNC = SYNC_PARAMETERS = (0x1C32, 0x1C33)
SYNC_TYPES, MINIMUM_CYCLE = 4, 5
"""Subindices."""

SyncParameters = Mapping[int, Mapping[int, int]]
"""Default values by subindex, by object."""


def sync_parameters(device: Device, views: DictionaryViews) -> SyncParameters:
    """What the dictionaries of a device give for the SyncManager parameters; empty for an object that none declares."""
    return {index: _defaults(device, index, views) for index in SYNC_PARAMETERS}


def _defaults(device: Device, index: int, views: DictionaryViews) -> dict[int, int]:
    for view in views.of(device.profiles):
        entries = view.entries(index)
        if entries is not None:
            return {entry.subindex: entry.default_int for entry in entries.values() if entry.default_int is not None}
    return {}


def min_cycle_ns(device: Device, parameters: SyncParameters) -> int | None:
    """The cycle that outputs and inputs both keep up with, else the smallest one that samples of an OpMode allow.

    OpModes that newer tools ignore do not count.
    """
    declared = [values[MINIMUM_CYCLE] for values in parameters.values() if values.get(MINIMUM_CYCLE, 0) > 0]
    if declared:
        return max(declared)
    texts = (
        device.info_vendor_specific,
        device.dc_vendor_specific,
        *(m.vendor_specific for m in valid_op_modes(device.op_modes)),
    )
    sampled = [cycle for text in texts for cycle in sampled_cycles(text)]
    return min(sampled, default=None)
