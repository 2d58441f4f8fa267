"""Which slaves hang on the same bus, when a text holds several masters or the same listing twice; which are missing."""

import itertools
from collections.abc import Iterable, Iterator, Sequence

import msgspec

from esicatalog.scan.records import ScanFinding, ScannedSlave

_Key = tuple[int | None, str | None]
_Listing = list[ScannedSlave]


def separate_buses(slaves: list[ScannedSlave]) -> tuple[tuple[ScannedSlave, ...], list[ScanFinding]]:
    """Number the buses of a text in ``bus``; drop what repeats a listing of the same bus, or a part of it.

    A listing is a run of rising positions under one master and interface. Listings of one master or interface belong
    to one bus unless their positions overlap: then the same slaves mean the same output twice (``slaveinfo`` and
    ``slaveinfo -map`` pasted together), others mean another bus or a changed one, which is kept apart and told.
    """
    numbered: list[ScannedSlave] = []
    findings = []
    latest: dict[_Key, tuple[int, dict[int, ScannedSlave]]] = {}
    known: dict[tuple[object, ...], int] = {}
    buses = 0
    for listing in _listings(slaves):
        key, line = _key(listing[0]), listing[0].line
        first_line = known.setdefault((key, *map(_identity, listing)), line)
        bus, taken = latest.get(key, (buses, {}))
        again = [slave for slave in listing if slave.position in taken]
        is_same = all(_identity(slave) == _identity(taken[slave.position]) for slave in again)
        if again and is_same:
            first_line = taken[again[0].position].line
            listing = [slave for slave in listing if slave.position not in taken]
        elif first_line != line:
            listing = []
        elif again:
            bus, taken = buses, {}
            message = "positions are listed again with other slaves; kept apart as another bus"
            findings.append(ScanFinding(line=line, message=message))
        if first_line != line:
            what = "a part of the listing" if listing else "the listing"
            message = f"{what} repeats the one from line {first_line}; it is read once"
            findings.append(ScanFinding(line=line, message=message))
        buses = max(buses, bus + 1)
        taken |= {slave.position: slave for slave in listing}
        latest[key] = bus, taken
        numbered += [msgspec.structs.replace(slave, bus=bus) for slave in listing]
    return tuple(numbered), findings


def gaps(slaves: Iterable[ScannedSlave]) -> dict[int, range]:
    """Ring positions that the listing of a bus passes over, by the position of the slave behind them.

    ``slaves`` are in ring order. Masters number a ring from 0 without gaps, so there are slaves, and nothing is known
    of them.
    """
    positions = (-1, *(slave.position for slave in slaves))
    return {after: range(before + 1, after) for before, after in itertools.pairwise(positions) if after > before + 1}


def gap_words(gap: range) -> str:
    """What is to be said of a gap."""
    return f"{slave_words(gap)} {'is' if len(gap) == 1 else 'are'} not in the listing"


def slave_words(positions: Sequence[int]) -> str:
    """Rising ring positions in words: "slaves 0, 4 to 6"; empty without any."""
    return f"slave{'s' * (len(positions) > 1)} {', '.join(_runs(positions))}" if positions else ""


def _runs(positions: Iterable[int]) -> Iterator[str]:
    for _, numbered in itertools.groupby(enumerate(positions), lambda item: item[1] - item[0]):
        run = [position for _, position in numbered]
        yield f"{run[0]} to {run[-1]}" if len(run) > 2 else ", ".join(map(str, run))


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


def _identity(slave: ScannedSlave) -> tuple[object, ...]:
    """Who a slave is: by its name too, for tables show it instead of the identity."""
    return (
        slave.position,
        slave.vendor_id,
        slave.product_code,
        slave.revision_no,
        slave.serial_no,
        slave.alias,
        slave.name,
    )
