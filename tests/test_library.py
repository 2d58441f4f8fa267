"""The made-up library that benchmarks measure with: valid, readable, the same for the same arguments."""

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import CHECKOUT
from lxml import etree
from snippets import one, rows

BENCHMARKS = CHECKOUT / "benchmarks"
LIBRARY = BENCHMARKS / "library.py"


def documents(folder: Path, *arguments: str) -> dict[str, bytes]:
    subprocess.run([sys.executable, str(LIBRARY), str(folder), *arguments], check=True, stdout=subprocess.DEVNULL)
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*.xml")}


@pytest.mark.parametrize("name", ["run", "scale", "postgres", "identify"])
def test_the_benchmarks_can_be_asked_what_they_measure(name):
    words = [sys.executable, str(BENCHMARKS / f"{name}.py"), "--help"]
    assert "usage" in subprocess.run(words, check=True, capture_output=True, text=True).stdout


def test_documents_follow_the_schema(library, corpus):
    schema = etree.XMLSchema(etree.parse(corpus / "xsd" / "1.17" / "EtherCATInfo.xsd"))
    for path in sorted(library.rglob("*.xml")):
        schema.assertValid(etree.parse(path))


def test_everything_is_stored_without_a_finding(library_db):
    assert one(library_db, "SELECT count(*) FROM devices") == 210
    assert rows(library_db, "SELECT DISTINCT status FROM sources") == [("stored",)]
    # As the generator writes them; what lint thinks of made-up devices is another matter.
    noticed = "SELECT rule, message FROM findings WHERE rule IN ('L01', 'L04', 'L05', 'L06', 'L07')"
    assert rows(library_db, noticed) == []
    assert rows(library_db, "SELECT path, value FROM unmapped") == []


def test_revisions_of_a_product_differ_a_little(library_db):
    """Five revisions: the newest hides the oldest, the third has another layout, an object has another default."""
    product = "SELECT vendor_id, product_code FROM devices WHERE type LIKE 'D%' LIMIT 1"
    of_product = f"(vendor_id, product_code) = ({product})"
    revisions = f"SELECT revision_no, hidden FROM devices WHERE {of_product} ORDER BY 1"
    assert rows(library_db, revisions) == [(0x10000, 1), (0x20000, 0), (0x30000, 0), (0x40000, 0), (0x50000, 0)]
    changed = f"SELECT revision_no FROM device_revisions WHERE {of_product} AND layout_changed ORDER BY 1"
    assert rows(library_db, changed) == [(0x30000,), (0x40000,)]
    current = f"SELECT default_int FROM device_object_entries WHERE {of_product} AND object_index = 0x2000 ORDER BY 1"
    first, *others = [value for (value,) in rows(library_db, current)]
    assert others == [first + 1, first + 2, first + 3, first + 4]


def test_the_same_arguments_give_the_same_bytes_and_more_devices_only_add(tmp_path):
    small = documents(tmp_path / "small", "--devices", "105", "--vendors", "2")
    again = documents(tmp_path / "again", "--devices", "105", "--vendors", "2")
    large = documents(tmp_path / "large", "--devices", "140", "--vendors", "2")
    assert small == again
    assert small.items() < large.items()
    assert small != documents(tmp_path / "other", "--devices", "105", "--vendors", "2", "--seed", "2")


def test_sizes_are_those_asked_for(tmp_path):
    found = documents(tmp_path / "l", "--devices", "33", "--objects", "40", "--revisions", "3")
    devices = [device for text in found.values() for device in etree.fromstring(text).iter("Device")]
    assert len(devices) == 33
    assert {len(device.findall("Profile/Dictionary/Objects/Object")) for device in devices} == {0, 40}
