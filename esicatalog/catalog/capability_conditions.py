"""Conditions on what devices can do: drive modes, SYNC signals, protocols, sizes, layout."""

from collections.abc import Callable
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.conditions import Condition, Evidence, by_row, stated, tested, with_row
from esicatalog.catalog.schema import dc_modes, device_facts, devices, drive_modes, mailboxes, vendor_extensions
from esicatalog.esi.records.dc import OpMode
from esicatalog.identity import Bounds
from esicatalog.model.cia402 import CIA402
from esicatalog.model.device_words import protocol_name
from esicatalog.model.drive_modes import accepted_verdicts
from esicatalog.model.ports import port_kind
from esicatalog.model.sync_parameters import MINIMUM_CYCLE, SYNC_PARAMETERS
from esicatalog.model.twincat import is_superseded

_FSOE = "fsoe"

FLAGS: dict[str, tuple[sa.Column[Any], str]] = {
    "complete_access": (mailboxes.c.coe_complete_access, "CoE CompleteAccess declared"),
    "pdo_assign": (mailboxes.c.coe_pdo_assign, "CoE PdoAssign declared"),
    "pdo_config": (mailboxes.c.coe_pdo_config, "CoE PdoConfig declared"),
    "bootstrap": (device_facts.c.has_bootstrap, "Eeprom declares a bootstrap mailbox"),
    "needs_dc": (device_facts.c.dc_needed, "every valid OpMode activates distributed clocks"),
    "no_lrw": (devices.c.use_lrd_lwr, "UseLrdLwr declared: no LRW frames"),
}
"""Truth values by their filters, in the order in which evidence is shown: column and evidence."""


def _cycle_place() -> sa.ScalarSelect[Any]:
    """The SM synchronisation object whose default is the smallest cycle, NULL where OpModes tell it."""
    held, objects, entries = schema.dictionary_objects.c, schema.objects.c, schema.object_entries.c
    owner = schema.profiles.c
    return (
        sa.select(sa.func.min(objects.object_index))
        .select_from(schema.profiles)
        .join(schema.dictionary_objects, held.dictionary_id == owner.dictionary_id)
        .join(schema.objects, objects.id == held.object_id)
        .join(schema.object_entries, entries.object_id == objects.id)
        .where(
            owner.device_id == device_facts.c.device_id,
            tested(objects.object_index).in_(SYNC_PARAMETERS),
            entries.subindex == MINIMUM_CYCLE,
            entries.default_int == device_facts.c.min_cycle_ns,
        )
        .scalar_subquery()
    )


def _cycle_words(nanoseconds: int, index: int | None) -> str:
    place = f"0x{index:04X}:{MINIMUM_CYCLE:02X}" if index is not None else "oversampling: DefaultFactor x MinCycleTime"
    return f"smallest cycle {nanoseconds} ns ({place})"


_AMOUNTS: dict[str, tuple[Callable[..., str], sa.Column[Any], *tuple[sa.ScalarSelect[Any], ...]]] = {
    "bytes_in": ("{} byte(s) of input in the default process image".format, device_facts.c.input_bytes),
    "bytes_out": ("{} byte(s) of output in the default process image".format, device_facts.c.output_bytes),
    "min_cycle_ns": (_cycle_words, device_facts.c.min_cycle_ns, _cycle_place()),
    "e_bus_ma": ("E-bus current {} mA".format, devices.c.e_bus_current_ma),
    "axes": ("{} axis(es) with CiA 402 evidence".format, device_facts.c.axis_count),
}
"""Numbers: evidence, column, and what else the evidence tells."""


def flag(name: str) -> Condition:
    """Devices with a property that is there or not."""
    return _declared(*FLAGS[name])


def _declared(column: sa.Column[Any], words: str) -> Condition:
    return _of_device(column, column == sa.true(), evidence=stated(words))


def amount(name: str, bounds: Bounds) -> Condition:
    """Devices with a number within bounds; unknown is not within."""
    words, column, *more = _AMOUNTS[name]
    limits: list[Any] = [column.is_not(None)]
    if bounds.least is not None:
        limits.append(column >= bounds.least)
    if bounds.most is not None:
        limits.append(column <= bounds.most)
    owner = _owner(column)
    return _of_device(column, *limits, evidence=by_row(sa.select(owner, column, *more), owner, words))


def _owner(column: sa.Column[Any]) -> sa.Column[Any]:
    table = column.table
    return table.c.id if table is devices else table.c.device_id


def _of_device(column: sa.Column[Any], *fits: Any, evidence: Evidence) -> Condition:
    """Devices of which the row fits, in ``devices`` or in another table that has one row a device."""
    if column.table is devices:
        return Condition(sa.and_(*fits), evidence)
    return with_row(_owner(column), *fits, evidence=evidence)


def drive_mode(mode: str, strict: bool) -> Condition:
    """Devices that can run a CiA 402 mode on some axis: verdict yes, or likely unless strict."""
    columns = drive_modes.c
    fits = (columns.mode == mode, columns.verdict.in_(accepted_verdicts(strict)), columns.kind == CIA402)
    query = sa.select(columns.device_id, columns.axis, columns.verdict, columns.evidence, columns.recipe)
    query = query.where(*fits).order_by(columns.device_id, columns.position)

    def words(axis: int, verdict: str, evidence: str, recipe: str | None) -> str:
        return f"{mode} {verdict}, axis {axis}: {evidence}" + (f" -> {recipe}" if recipe else "")

    return with_row(columns.device_id, *fits, evidence=by_row(query, columns.device_id, words))


def sync(signal: str) -> Condition:
    """Devices with an OpMode in which they generate SYNC0 or SYNC1."""
    modes, said, facts = dc_modes.c, vendor_extensions.c, device_facts.c
    of_mode = sa.and_(
        said.device_id == modes.device_id,
        said.owner_table == dc_modes.name,
        said.owner_position == modes.position,
    )
    query = (
        sa.select(modes.device_id, modes.name, modes.assign_activate, said.xml)
        .select_from(dc_modes.outerjoin(vendor_extensions, of_mode))
        .where(modes[signal] == sa.true())
    )

    def words(name: str | None, assign_activate: int, vendor_specific: str | None) -> str:
        mode = f"OpMode {name!r}" if name is not None else "an OpMode without Name"
        superseded = is_superseded(OpMode(vendor_specific=vendor_specific))
        ignored = " (superseded: newer tools ignore it)" if superseded else ""
        return f"{signal.upper()} in {mode}{ignored}: AssignActivate 0x{assign_activate:04X}"

    ordered = query.order_by(dc_modes.c.device_id, dc_modes.c.position)
    evidence = by_row(ordered, dc_modes.c.device_id, words)
    return _of_device(facts[f"supports_{signal}"], facts[f"supports_{signal}"] == sa.true(), evidence=evidence)


def protocol(name: str) -> Condition:
    """Devices that declare a mailbox protocol; FSoE by its evidence, which is no statement about safety."""
    if name == _FSOE:
        facts = device_facts.c
        query = sa.select(facts.device_id, facts.fsoe, facts.fsoe_evidence)
        evidence = by_row(query, facts.device_id, "FSoE, {} evidence: {}".format)
        return _of_device(facts.fsoe, facts.fsoe.is_not(None), evidence=evidence)
    return _declared(mailboxes.c[name], f"Mailbox/{protocol_name(name)} declared")


def identification(method: str) -> Condition:
    """Devices that return an explicit identification by this method."""
    if method == "reg134":
        return _declared(devices.c.identification_reg134, "IdentificationReg134 declared")
    column = devices.c.identification_ado
    evidence = by_row(sa.select(devices.c.id, column), devices.c.id, "IdentificationAdo 0x{:04X}".format)
    return Condition(column.is_not(None), evidence)


def physics(text: str) -> Condition:
    """Devices with these ports; trailing blanks do not count."""
    wanted = text.rstrip(" ")
    kinds = [(port_kind(letter), letter) for letter in wanted[:4]]
    words = [f"port {'ABCD'[at]} {kind.words if kind else letter}" for at, (kind, letter) in enumerate(kinds)]
    return Condition(sa.func.rtrim(devices.c.physics) == wanted, stated(f"Physics {wanted!r}: {', '.join(words)}"))


def like(number: int, words: str, facts: Any) -> Condition:
    """Devices with the layout of another one: ``facts`` is its row of device_facts, ``number`` its own number."""
    columns = device_facts.c

    def compared(pdo_signature: str | None) -> str:
        if pdo_signature is None and facts.pdo_signature is None:
            rest = "no other PDOs but those of modules, which are not compared"
        elif pdo_signature == facts.pdo_signature:
            rest = "all PDOs of the device itself too"
        else:
            rest = "other PDOs of the device itself differ"
        return f"same process-image layout as {words}, {rest}"

    return with_row(
        columns.device_id,
        columns.image_signature == facts.image_signature,
        columns.device_id != number,
        evidence=by_row(sa.select(columns.device_id, columns.pdo_signature), columns.device_id, compared),
    )
