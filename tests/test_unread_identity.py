"""Vendor 0 and product 0: what masters print of a slave whose SII they did not read, and what templates have."""

import json

import pytest
from snippets import device, esi, pdo
from test_cli import run
from test_search import catalog_of
from web_client import client

from esicatalog import Catalog

TEMPLATE = device("<Sm>Outputs</Sm>" + pdo("RxPdo", "#x1600", 8, attributes='Sm="0"'), product="0", revision="0")
WORDS = "vendor and product 0: identity not read"
IGH = """\
=== Master 0, Slave 0 ===
Identity:
  Vendor Id:       0x00000000
  Product code:    0x00000000
  Revision number: 0x00000000
"""
SOEM = "Slave:1\n Name:? M:00000000 I:00000000\n State: 1\n Man: 00000000 ID: 00000000 Rev: 00000000\n"


@pytest.fixture(scope="module")
def templates(tmp_path_factory):
    """Two revisions of a template that nobody gave an identity, and a device of vendor 0 that has a product code."""
    devices = TEMPLATE + device(product="0", revision="3") + device(product="7", revision="1")
    return catalog_of(tmp_path_factory.mktemp("templates"), esi(devices, vendor="<Id>0</Id><Name>Nobody</Name>"))


@pytest.mark.parametrize("revision", [None, 0, 3, 5])
def test_what_was_not_read_is_nobody(templates, revision):
    with Catalog.open(templates) as catalog:
        found = catalog.identify(0, 0, revision)
    assert (found.match, found.reason, found.device, found.variants, found.candidates) == ("none", WORDS, None, (), ())


def test_what_has_no_identity_is_no_candidate(templates):
    with Catalog.open(templates) as catalog:
        assert [item.product_code for item in catalog.identify(0, 5).candidates] == [7]
        assert catalog.identify(0, 7, 1).match == "exact"
        assert catalog.device("0:0:3").found.product_code == 0


@pytest.mark.parametrize("scan", [IGH, SOEM, "vendor,product,revision\n0,0,0\n"], ids=["igh", "soem", "csv"])
def test_a_slave_that_was_not_read_is_none_of_the_templates(templates, scan):
    done = run("identify", "--slaves", "-", "--format", "json", db=templates, stdin=scan)
    (found,) = json.loads(done.stdout)
    assert (done.exit_code, found["match"], found["reason"], found["device"]) == (1, "none", WORDS, None)
    assert (found["slave"]["output_bytes"], found["slave"]["input_bytes"]) == (None, None)
    sheet = run("identify", "--slaves", "-", db=templates, stdin=scan).stdout
    assert "  slaves           1, 0 with exact ESI" in sheet.splitlines()
    assert f"  0: {WORDS}" in sheet.splitlines()


def test_no_code_is_made_for_a_slave_that_was_not_read(templates):
    done = run("export", "igh", "--scan", "-", "--accept-revision", db=templates, stdin=IGH)
    assert (done.exit_code, done.stdout) == (2, "")
    left_out = "position 0: slave is left out: its identity was not read"
    assert left_out in done.stderr
    beside = run("export", "igh", "--scan", "-", db=templates, stdin="vendor,product,revision\n0,0,0\n0,7,1\n")
    assert (beside.exit_code, left_out in beside.stdout) == (0, True)


def test_an_eeprom_that_nobody_wrote_an_identity_into(templates, tmp_path):
    (tmp_path / "dump.bin").write_bytes(b"\x08" + bytes(127) + b"\xff\xff")
    done = run("identify", "--sii", tmp_path / "dump.bin", db=templates)
    assert (done.exit_code, done.stdout.splitlines()[0]) == (1, f"none: {WORDS}")
    done = run("sii", "verify", tmp_path / "dump.bin", db=templates)
    assert (done.exit_code, done.stdout.splitlines()[0]) == (1, f"not compared: {WORDS}")


async def test_over_http_it_is_not_found(templates):
    found = await (await client(templates)).get("/-/esi/identify.json", params={"vendor": "0", "product": "0"})
    assert (found.status_code, found.json()["match"], found.json()["reason"]) == (404, "none", WORDS)
