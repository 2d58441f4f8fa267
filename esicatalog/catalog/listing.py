"""A page of found devices with what a list shows of each: icon, drive modes, SYNC signals; and counts for filters."""

from typing import NamedTuple

import msgspec
import sqlalchemy as sa

from esicatalog.catalog.conditions import tested
from esicatalog.catalog.device_filter import DeviceFilter
from esicatalog.catalog.facets import FacetValue, counts
from esicatalog.catalog.results import FoundDevice
from esicatalog.catalog.schema import device_facts, devices, drive_modes
from esicatalog.catalog.search import ADDRESSED, NOT_ADDRESSED, conditions, device_query, found_devices
from esicatalog.model.cia402 import CIA402
from esicatalog.model.drive_modes import accepted_verdicts
from esicatalog.sii.codes import signal_names


class ListedDevice(NamedTuple):
    """A device in a list."""

    found: FoundDevice
    image_sha256: str | None
    modes: tuple[tuple[str, str], ...]
    """Drive modes with the verdict yes or likely."""
    signals: tuple[str, ...]
    """SYNC0 and SYNC1 where some OpMode generates them."""


class Listing(NamedTuple):
    """Devices from ``offset`` on, how many there are in all, counts by filter, and the SELECT as text."""

    devices: tuple[ListedDevice, ...]
    total: int
    offset: int
    facets: dict[str, tuple[FacetValue, ...]]
    sql: str


def list_devices(connection: sa.Connection, wanted: DeviceFilter, offset: int) -> Listing:
    """Find devices for a page; the number of queries does not depend on how many there are.

    Descriptions without codes, which have no page of their own, come last. They are asked for by themselves: in the
    index by which devices are listed they are the first of their vendor.
    """
    held = list(conditions(connection, wanted))
    total, addressed, facets = counts(connection, held, wanted)
    found = found_devices(connection, [*held, ADDRESSED], wanted, offset)
    if total > addressed and (wanted.limit is None or len(found) < wanted.limit):
        rest = msgspec.structs.replace(wanted, limit=None if wanted.limit is None else wanted.limit - len(found))
        found += found_devices(connection, [*held, NOT_ADDRESSED], rest, max(0, offset - addressed))
    whole = msgspec.structs.replace(wanted, limit=None)
    literal = device_query(held, whole).compile(connection, compile_kwargs={"literal_binds": True})
    return Listing(_listed(connection, found), total, offset, facets, str(literal))


def _listed(connection: sa.Connection, found: list[tuple[int, FoundDevice]]) -> tuple[ListedDevice, ...]:
    numbers = [number for number, _ in found]
    columns, facts, modes = devices.c, device_facts.c, drive_modes.c
    query = (
        sa.select(columns.id, columns.image_sha256, facts.supports_sync0, facts.supports_sync1)
        .join(device_facts, facts.device_id == columns.id)
        .where(columns.id.in_(numbers))
    )
    rows = {row.id: row for row in connection.execute(query)}
    verdicts: dict[int, dict[str, str]] = {}
    for number, mode, verdict in connection.execute(
        sa.select(modes.device_id, modes.mode, modes.verdict)
        .where(modes.device_id.in_(numbers), tested(modes.kind) == CIA402, modes.verdict.in_(accepted_verdicts()))
        .order_by(modes.device_id, modes.position)
    ):
        verdicts.setdefault(number, {}).setdefault(mode, verdict)
    listed = []
    for number, device in found:
        row = rows[number]
        signals = tuple(signal_names(row.supports_sync0, row.supports_sync1))
        listed.append(ListedDevice(device, row.image_sha256, tuple(verdicts.get(number, {}).items()), signals))
    return tuple(listed)
