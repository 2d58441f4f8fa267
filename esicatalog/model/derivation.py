"""Everything that a description implies without any choice: default process image, drive modes, facts."""

from collections.abc import Mapping, Sequence
from functools import cached_property

from esicatalog.esi.records.device import Device
from esicatalog.esi.records.module import Module
from esicatalog.model.device_facts import DeviceFacts, device_facts
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.drive_evidence import ModeEvidence
from esicatalog.model.drive_modes import DriveModes, drive_modes
from esicatalog.model.memo import IdentityMemo, identities
from esicatalog.model.process_data import ProcessData, SharedProcessData
from esicatalog.model.process_image import SmImage
from esicatalog.model.resolver import Resolver
from esicatalog.model.safety import FsoeSigns

_MAX_DERIVATIONS = 1_000


class Deriver:
    """Derives for many descriptions; what depends on records that they share is computed once."""

    def __init__(self) -> None:
        self.resolver = Resolver()
        self.views = DictionaryViews(self.resolver)
        self._process_data = SharedProcessData()
        self._fsoe = FsoeSigns(self.views)
        self._derivations: IdentityMemo[Derivation] = IdentityMemo(_MAX_DERIVATIONS)

    def derive(self, device: Device, modules: Sequence[Module]) -> "Derivation":
        """What follows from a device with the modules its slots can reach."""
        key = (id(device), identities(modules))
        return self._derivations.get(key, (device, modules), self._derivation, device, modules)

    def _derivation(self, device: Device, modules: Sequence[Module]) -> "Derivation":
        return Derivation(device, modules, self._process_data.of(device, modules), self.views, self._fsoe)


class Derivation:
    """What follows from a device with the modules its slots can reach; computed when asked for."""

    def __init__(
        self,
        device: Device,
        modules: Sequence[Module],
        process_data: ProcessData,
        views: DictionaryViews,
        fsoe: FsoeSigns,
    ) -> None:
        self._device = device
        self._modules = modules
        self.process_data = process_data
        self._views = views
        self._fsoe = fsoe

    @property
    def images(self) -> list[SmImage]:
        """Default process image: default OpMode, default modules."""
        return self.process_data.images

    @cached_property
    def modes(self) -> DriveModes:
        """What the description says about drive modes."""
        return drive_modes(self._device, self._modules, self._views, self.images)

    @cached_property
    def evidence_of_modules(self) -> Mapping[int | None, Sequence[ModeEvidence]]:
        """The evidence on drive modes by the ModuleIdent that it is of, None for that of the device itself."""
        found: dict[int | None, list[ModeEvidence]] = {}
        for item in self.modes.evidence:
            found.setdefault(item.module_ident, []).append(item)
        return found

    @cached_property
    def facts(self) -> DeviceFacts:
        """What devices are filtered by."""
        fsoe = self._fsoe.evidence(self._device, self._modules)
        return device_facts(self._device, self.process_data, self.modes, fsoe, self._views)


def derive(device: Device, modules: Sequence[Module]) -> Derivation:
    """Derive what the catalog stores beside a single description."""
    return Deriver().derive(device, modules)
