"""The slaves of a listing, each configured by the description that stands for it."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from snippets import device, esi, pdo, write

from esicatalog import Catalog
from esicatalog.errors import InputError, NotFound
from esicatalog.export.scan_bus import BusConfigurations, bus_configurations, subject_for
from esicatalog.identity import Identity
from esicatalog.scan.front import read_scan
from esicatalog.scan.records import Scan

REVISION_2 = Identity(0xE5C, 1, 2)


@pytest.fixture
def catalog(tmp_path: Path) -> Iterator[Catalog]:
    content = "<Sm ControlByte='#x64'>Outputs</Sm>" + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"')
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([write(tmp_path / "in", {"a.xml": esi(device(content))})], jobs=1)
        yield catalog


def listing(*revisions: int) -> str:
    return "vendor,product,revision\n" + "".join(f"0xe5c,1,{revision}\n" for revision in revisions)


def configured(catalog: Catalog, scan: Scan, accept_revision: bool = False) -> BusConfigurations:
    return bus_configurations(catalog, scan, accept_revision=accept_revision, cycle_ns=None)


def test_slaves_are_configured_at_their_places_and_unknown_ones_are_named(catalog):
    scan = read_scan(listing(1, 1) + "0x99,1,1\n")
    found = bus_configurations(catalog, scan, accept_revision=False, cycle_ns=500_000)
    assert [(item.choice.position, item.choice.cycle_ns) for item in found.configurations] == [
        (0, 500_000),
        (1, 500_000),
    ]
    assert found.left_out == ["position 2: slave (0x00000099:0x00000001:0x00000001) is unknown and left out"]


def test_another_revision_stands_in_only_where_that_is_accepted(catalog):
    scan = read_scan(listing(2))
    for ask in (lambda: configured(catalog, scan), lambda: subject_for(catalog, REVISION_2, False)):
        with pytest.raises(NotFound, match="takes 0x00000e5c:0x00000001:0x00000001"):
            ask()
    (configuration,) = configured(catalog, scan, accept_revision=True).configurations
    subject = subject_for(catalog, REVISION_2, accept_revision=True)
    assert configuration.subject == subject
    assert (subject.revision_no, subject.device.revision_no) == (1, 1)
    assert subject.substitution.startswith(f"asked for {REVISION_2}, described is 0x00000e5c:0x00000001:0x00000001: ")


def test_a_listing_of_several_buses_is_refused(catalog):
    text = "".join(f"=== Master {bus}, Slave 0 ===\n  Vendor Id: 0xe5c\n  Product code: 1\n" for bus in (0, 1))
    with pytest.raises(InputError, match="the listing holds 2 buses"):
        configured(catalog, read_scan(text))
