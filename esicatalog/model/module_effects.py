"""What a module makes of a configuration: several modules may share their ModuleIdent and still be different ones."""

from collections.abc import Sequence
from typing import Any

import msgspec

from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Pdo


def configure_alike(modules: Sequence[Module]) -> bool:
    """Whether any of some modules can stand for all: with each the process image, start-up and clocks are the same."""
    return all(_effects(module) == _effects(modules[0]) for module in modules[1:])


def _effects(module: Module) -> tuple[Any, ...]:
    """What a module makes of the process image, at start-up and of the clocks; names say nothing of it."""
    pdos = tuple(tuple(map(_layout, pdos)) for pdos in (module.rx_pdos, module.tx_pdos))
    return pdos, module.module_pdo_group, module.mailbox, module.dc_op_mode_name


def _layout(pdo: Pdo) -> Pdo:
    unnamed = {"names": (), "spelling": None}
    entries = tuple(msgspec.structs.replace(entry, comments=(), **unnamed) for entry in pdo.entries)
    return msgspec.structs.replace(pdo, entries=entries, **unnamed)
