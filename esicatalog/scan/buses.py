"""Which slaves hang on the same bus, when a text holds several masters or the same listing twice."""

import msgspec

from esicatalog.scan.records import ScanFinding, ScannedSlave

_Key = tuple[int | None, str | None]
_Listing = list[ScannedSlave]


def separate_buses(slaves: list[ScannedSlave]) -> tuple[tuple[ScannedSlave, ...], list[ScanFinding]]:
    """Number the buses of a text in ``bus``; drop a listing that repeats an earlier one of the same bus.

    A listing is a run of rising positions under one master and interface. Listings of one master or interface belong
    to one bus unless their positions overlap: then the same slaves mean the same output twice (``slaveinfo`` and
    ``slaveinfo -map`` pasted together), others mean another bus or a changed one, which is kept apart and told.
    """
    numbered: list[ScannedSlave] = []
    findings = []
    latest: dict[_Key, tuple[int, set[int]]] = {}
    known: dict[tuple[object, ...], int] = {}
    buses = 0
    for listing in _listings(slaves):
        key, line = _key(listing[0]), listing[0].line
        first_line = known.setdefault((key, *_identities(listing)), line)
        if first_line != line:
            message = f"the listing repeats the one from line {first_line}; it is read once"
            findings.append(ScanFinding(line=line, message=message))
            continue
        positions = {slave.position for slave in listing}
        bus, taken = latest.get(key, (buses, set()))
        if not taken.isdisjoint(positions):
            bus, taken = buses, set()
            message = "positions are listed again with other slaves; kept apart as another bus"
            findings.append(ScanFinding(line=line, message=message))
        buses = max(buses, bus + 1)
        taken |= positions
        latest[key] = bus, taken
        numbered += [msgspec.structs.replace(slave, bus=bus) for slave in listing]
    return tuple(numbered), findings


def _listings(slaves: list[ScannedSlave]) -> list[_Listing]:
    listings: list[_Listing] = []
    for slave in slaves:
        last = listings[-1][-1] if listings else None
        if last is not None and _key(last) == _key(slave) and last.position < slave.position:
            listings[-1].append(slave)
        else:
            listings.append([slave])
    return listings


def _key(slave: ScannedSlave) -> _Key:
    return slave.master, slave.interface


def _identities(listing: _Listing) -> list[tuple[object, ...]]:
    """Who the slaves are: by their name too, for tables show it instead of the identity."""
    return [
        (
            slave.position,
            slave.vendor_id,
            slave.product_code,
            slave.revision_no,
            slave.serial_no,
            slave.alias,
            slave.name,
        )
        for slave in listing
    ]
