"""Counts of elements by lxml alone against the views of the catalog, device by device."""

import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

import pytest
from lxml import etree
from snippets import elements, one, rows
from test_round_trip import container_of

from esicatalog import Catalog

VIEWS = ("device_pdo_entries", "device_objects", "device_initcmds", "device_dc_modes")
PROTOCOLS = ("CoE", "SoE", "EoE", "AoE")


def number(text: str | None) -> int | None:
    """A HexDecValue, for identities: NULL when it is malformed or larger than 32 bits."""
    if text is None:
        return None
    word = text.strip().lower()
    try:
        value = int(word.replace("#x", "").replace("0x", ""), 16) if "x" in word else int(word)
    except ValueError:
        return None
    return value if 0 <= value <= 0xFFFF_FFFF else None


def tree(content: bytes):
    """A document as lxml reads it; recovered or read as windows-1252 where a strict parser gives up."""
    try:
        return etree.fromstring(content)
    except etree.XMLSyntaxError as error:
        if "encoding" in str(error):
            return etree.fromstring(content, etree.XMLParser(encoding="windows-1252"))
        return etree.fromstring(content, etree.XMLParser(recover=True))


def expected(db: Path):
    """(source, position, identity, counts) of every Device element in the documents."""
    held: tuple[str | None, object] = (None, None)
    query = "SELECT id, location, member FROM sources WHERE status IN ('stored', 'recovered') ORDER BY location"
    for source_id, location, member in rows(db, query):
        container, name = held[1], location.rsplit("!", 1)[-1]
        if "!" not in location or held[0] != location.rsplit("!", 1)[0]:
            container, name = container_of(location, member)
            held = (location.rsplit("!", 1)[0], container)
        root = tree(container.read(name))
        infos = [root] if root.tag == "EtherCATInfo" else root.findall("EtherCATInfo")
        for section, info in enumerate(infos):
            vendor = number(info.findtext("Vendor/Id"))
            for position, item in enumerate(elements(info, "Descriptions", "Devices", "Device")):
                kind = item.find("Type")
                identity = (vendor, number(kind.get("ProductCode")), number(kind.get("RevisionNo")))
                yield source_id, section, position, identity, counted(item, container, name)


def counted(item, container, name: str) -> tuple[int, ...]:
    entries = sum(1 for kind in ("RxPdo", "TxPdo") for _ in elements(item, kind, "Entry"))
    objects = sum(1 for _ in elements(item, "Profile", "Dictionary", "Objects", "Object"))
    for reference in item.findall("Profile/DictionaryFile"):
        member = find(container, name, reference.text)
        if member is not None:
            objects += sum(1 for _ in elements(tree(container.read(member)), "Dictionary", "Objects", "Object"))
    commands = sum(1 for protocol in PROTOCOLS for _ in elements(item, "Mailbox", protocol, "InitCmd"))
    return entries, objects, commands, sum(1 for _ in elements(item, "Dc", "OpMode"))


def find(container, document: str, reference: str) -> str | None:
    """The member beside the document with this name in any letter case."""
    folder = document.rpartition("/")[0]
    wanted = f"{folder}/{reference}" if folder else reference
    return container.find(wanted.strip().replace("\\", "/"))


def compare(db: Path) -> int:
    """Compare all devices; returns how many there were."""
    held = [dict(rows(db, f"SELECT device_id, count(*) FROM {view} GROUP BY device_id")) for view in VIEWS]
    placed = {
        (source, section, position): (device_id, identity)
        for source, section, position, device_id, *identity in rows(
            db,
            "SELECT x.source_id, x.section, x.position, d.id, d.vendor_id, d.product_code, d.revision_no "
            "FROM device_sources x JOIN devices d ON d.id = x.device_id",
        )
    }
    differing, compared = [], 0
    for source, section, position, identity, wanted in expected(db):
        device_id, stored = placed.pop((source, section, position))
        found = tuple(view.get(device_id, 0) for view in held)
        compared += 1
        if found != wanted or tuple(stored) != identity:
            differing.append((identity, wanted, stored, found))
    assert differing == []
    assert placed == {}
    return compared


def test_counts_of_our_examples(data_db):
    assert compare(data_db) == 6


def test_counts_of_a_sample(sample_db):
    assert compare(sample_db) > 5


@pytest.mark.corpus
def test_counts_of_the_corpus(corpus_db):
    assert compare(corpus_db) == 2201


def test_one_row_an_element_in_the_io_terminal(data, data_db):
    """Counted by the standard library alone, padding included."""
    root = ElementTree.parse(data / "io_terminal_8di_8do.xml").getroot()
    wanted = Counter()
    for item in root.iter("Device"):
        codes = item.find("Type").attrib
        wanted[int(codes["RevisionNo"][2:], 16)] = len(
            [e for p in item if p.tag.endswith("xPdo") for e in p.iter("Entry")]
        )
    query = (
        "SELECT revision_no, count(*) FROM device_pdo_entries WHERE device_type LIKE 'ECX-D808%' GROUP BY revision_no"
    )
    assert dict(rows(data_db, query)) == dict(wanted)


@pytest.mark.corpus
def test_documents_of_the_corpus(corpus, tmp_path):
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        report = catalog.ingest([corpus / "esi"])
    assert report.counts == {"stored": 425, "unchanged": 0, "recovered": 4, "skipped": 2, "failed": 0}
    assert len(report.documents) == 427
    skipped = [line for line in report.documents if line.status == "skipped"]
    assert all("ENI" in line.message for line in skipped)
    assert all(line.message for line in report.documents if line.status == "recovered")
    assert (report.devices, report.modules) == (2201, 556)


@pytest.mark.corpus
def test_known_numbers_of_the_corpus(corpus_db):
    complete = "vendor_id IS NOT NULL AND product_code IS NOT NULL AND revision_no IS NOT NULL"
    distinct = f"SELECT DISTINCT vendor_id, product_code, revision_no FROM devices WHERE {complete}"
    assert one(corpus_db, f"SELECT count(*) FROM ({distinct})") == 1908
    assert one(corpus_db, "SELECT count(*) FROM device_sources") == 2201
    assert one(corpus_db, "SELECT count(*) FROM devices WHERE product_code IS NULL OR revision_no IS NULL") == 29
    for signal, wanted in (("sync1", 439), ("sync0", 737)):
        having = f"SELECT DISTINCT vendor_id, product_code, revision_no FROM device_dc_modes WHERE {signal} = 1"
        assert one(corpus_db, f"SELECT count(*) FROM ({having} AND {complete})") == wanted
    assert 150_000 <= one(corpus_db, "SELECT count(*) FROM object_entries") <= 190_000


@pytest.mark.corpus
def test_identities_and_signals_by_lxml_alone(corpus_db):
    """The same numbers from the documents themselves: AssignActivate bits of ESI-FACTS section 17."""
    held: dict[str, set] = {"identities": set(), "sync0": set(), "sync1": set()}
    for location, member in rows(corpus_db, "SELECT location, member FROM sources WHERE device_count > 0"):
        container, name = container_of(location, member)
        root = tree(container.read(name))
        for info in [root] if root.tag == "EtherCATInfo" else root.findall("EtherCATInfo"):
            for item in elements(info, "Descriptions", "Devices", "Device"):
                codes = item.find("Type")
                found = (number(codes.get("ProductCode")), number(codes.get("RevisionNo")))
                identity = (number(info.findtext("Vendor/Id")), *found)
                if None in identity:
                    continue
                held["identities"].add(identity)
                words = [number(mode.findtext("AssignActivate")) or 0 for mode in elements(item, "Dc", "OpMode")]
                for signal, bits in (("sync0", 0x0300), ("sync1", 0x0500)):
                    if any(word & bits == bits for word in words):
                        held[signal].add(identity)
    assert {name: len(found) for name, found in held.items()} == {"identities": 1908, "sync0": 737, "sync1": 439}
