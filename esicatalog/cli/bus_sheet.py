"""The sheet of a scanned bus: a line a slave, what is to be known of it, and a summary."""

from collections.abc import Iterator, Sequence

from esicatalog.catalog.identified_bus import BusReport, IdentifiedSlave, bus_facts
from esicatalog.cli.common import table_lines

_HEAD = ("pos", "alias", "identity", "ESI", "device", "revision", "E-bus left", "out", "in", "source")


def bus_lines(buses: Sequence[BusReport]) -> Iterator[str]:
    """The sheet as lines of text."""
    for number, bus in enumerate(buses):
        if number:
            yield ""
        if len(buses) > 1:
            yield bus.title
        yield from table_lines([_row(item) for item in bus.slaves], _HEAD)
        yield from _notes(bus.slaves)
        yield from _summary(bus)


def _row(item: IdentifiedSlave) -> list[str]:
    slave, answer, report = item.slave, item.identification, item.report
    described = answer.device
    return [
        str(slave.position),
        "" if slave.alias is None else str(slave.alias),
        item.identity_text,
        answer.match,
        (described.device.type or "" if described is not None else slave.name or "").strip(),
        item.described_revision,
        "" if report.e_bus_left_ma is None else f"{report.e_bus_left_ma} mA",
        _bytes(report.output_bytes),
        _bytes(report.input_bytes),
        item.source,
    ]


def _bytes(count: int | None) -> str:
    return "?" if count is None else str(count)


def _notes(slaves: Sequence[IdentifiedSlave]) -> Iterator[str]:
    lines = [f"  {item.slave.position}: {text}" for item in slaves for text in item.notes]
    if lines:
        yield ""
        yield "Notes"
        yield from lines


def _summary(bus: BusReport) -> Iterator[str]:
    yield ""
    yield "Summary"
    for name, words in bus_facts(bus):
        yield f"  {name:15}  {words}"
