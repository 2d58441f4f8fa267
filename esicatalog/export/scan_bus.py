"""The slaves of a bus as a master printed them, each configured by the description that stands for it."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple, Protocol

from esicatalog.catalog.results import Identification
from esicatalog.errors import InputError, NotFound
from esicatalog.export.choice import DEFAULT_CYCLE_NS, Choice, check_numbers
from esicatalog.export.configuration import Configuration, configure
from esicatalog.export.igh_limits import check_limits
from esicatalog.export.subject import Subject
from esicatalog.identity import Identity, is_read
from esicatalog.scan.buses import gap_words, gaps
from esicatalog.scan.records import Scan, ScannedSlave


class Descriptions(Protocol):
    """Where descriptions come from: a :class:`esicatalog.Catalog`."""

    def identify(self, vendor_id: int, product_code: int, revision_no: int | None = None) -> Identification:
        """What an identity is."""

    def export_subject(self, identity: str | Identity) -> Subject:
        """The description of an identity."""


class BusConfigurations(NamedTuple):
    """The slaves that can be configured, in ring order, and of each other one why it is left out."""

    configurations: list[Configuration]
    left_out: list[str]
    unread: list[str]
    """What of the listing was not understood, and which slaves it passes over: the bus may have more slaves."""


def subject_for(descriptions: Descriptions, identity: Identity, accept_revision: bool) -> Subject:
    """The exact description, or the one that the catalog ranks first where that is accepted.

    Raises :class:`NotFound`.
    """
    answer = descriptions.identify(identity.vendor_id, identity.product_code, identity.revision_no)
    if identity.revision_no is None or answer.is_exact:
        return descriptions.export_subject(identity)
    if answer.device is None:
        raise NotFound(f"{identity}: {answer.reason}")
    found = answer.device.device.identity_text
    if not accept_revision:
        raise NotFound(f"{identity}: {answer.reason}; --accept-revision takes {found}")
    words = f"asked for {identity}, described is {found}: {answer.reason}"
    return descriptions.export_subject(found).standing_in(words)


def bus_configurations(
    descriptions: Descriptions, scan: Scan, *, accept_revision: bool, cycle_ns: int | None
) -> BusConfigurations:
    """Configurations of the slaves that are described and that IgH can hold, with all that is default.

    Raises :class:`InputError` for a listing of several buses and a cycle that cannot be, and :class:`NotFound` naming
    the slaves of which another revision is described that is not accepted.
    """
    buses = {slave.bus for slave in scan.slaves}
    if len(buses) > 1:
        raise InputError(f"the listing holds {len(buses)} buses; give one of them")
    choice = Choice(cycle_ns=cycle_ns if cycle_ns is not None else DEFAULT_CYCLE_NS)
    check_numbers(choice)
    slaves = sorted(scan.slaves, key=lambda slave: slave.position)
    left_out: list[str] = []
    configurations = list(_configured(descriptions, slaves, accept_revision, choice, left_out))
    return BusConfigurations(configurations, left_out, [*map(gap_words, gaps(slaves).values()), *scan.finding_lines])


def _configured(
    descriptions: Descriptions,
    slaves: Iterable[ScannedSlave],
    accept_revision: bool,
    choice: Choice,
    left_out: list[str],
) -> Iterator[Configuration]:
    known: dict[Identity, Subject | None] = {}
    refused: list[str] = []
    for slave in slaves:
        identity = slave.identity
        if identity is None or not is_read(identity.vendor_id, identity.product_code):
            named = slave.name or "slave"
            left_out.append(f"position {slave.position}: {named} is left out: its identity was not read")
            continue
        try:
            if identity not in known:
                known[identity] = _subject(descriptions, identity, accept_revision)
        except NotFound as error:
            refused.append(f"position {slave.position}: {error}")
            continue
        subject = known[identity]
        if subject is None:
            named = f"{slave.name or 'slave'} ({identity})"
            left_out.append(f"position {slave.position}: {named} is unknown and left out")
            continue
        try:
            configuration = configure(subject, choice._replace(position=slave.position))
            check_limits(configuration)
        except InputError as error:
            named = subject.device.type or slave.name or "slave"
            left_out.append(f"position {slave.position}: {named} ({identity}) is left out: {error}")
            continue
        yield configuration
    if refused:
        raise NotFound("; ".join(refused))


def _subject(descriptions: Descriptions, identity: Identity, accept_revision: bool) -> Subject | None:
    """The device of a slave, None when nothing near is described. Raises :class:`NotFound` when not accepted."""
    if descriptions.identify(identity.vendor_id, identity.product_code, identity.revision_no).device is None:
        return None
    if identity.revision_no is None and not accept_revision:
        raise NotFound(f"{identity}: the listing gives no revision; --accept-revision takes the latest description")
    return subject_for(descriptions, identity, accept_revision)
