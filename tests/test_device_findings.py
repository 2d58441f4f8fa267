"""Findings are told at the device in whose element they lie, whatever shares its lines."""

from pathlib import Path

import pytest
from snippets import device, esi, write
from test_search import catalog_of

from esicatalog import Catalog

ODD = "<Odd/>"
MODULE = '<Module><Type ModuleIdent="#x1">M</Type><Name>M</Name><Odd/></Module>'


def found(db: Path, *revisions: int) -> list[list[str]]:
    """The rules of each revision's findings."""
    with Catalog.open(db) as catalog:
        return [[item.rule for item in catalog.device(f"0xe5c:1:{number}").findings] for number in revisions]


def test_devices_in_one_line_have_their_own_findings(tmp_path):
    devices = device(ODD) + device(revision="#x2") + device(ODD * 2, revision="#x3")
    assert found(catalog_of(tmp_path, esi(devices, MODULE)), 1, 2, 3) == [["L05"], [], ["L05", "L05"]]


def test_a_device_that_begins_where_another_ends_takes_nothing_from_it(tmp_path):
    devices = device(f"\n{ODD}") + device(f"\n{ODD}{ODD}\n", revision="#x2") + device(revision="#x3")
    assert found(catalog_of(tmp_path, esi(devices, MODULE)), 1, 2, 3) == [["L05"], ["L05", "L05"], []]


def test_the_only_device_is_written_without_a_number(tmp_path):
    assert found(catalog_of(tmp_path, esi(device(ODD), MODULE)), 1) == [["L05"]]


def test_a_number_that_begins_like_another_is_another(tmp_path):
    devices = "".join(device(ODD if number in (0, 10) else "", revision=str(number)) for number in range(11))
    assert found(catalog_of(tmp_path, esi(devices)), 0, 1, 10) == [["L05"], [], ["L05"]]


def test_groups_and_modules_of_the_same_line_are_others(tmp_path):
    text = esi(device(), MODULE).replace("<Type>G</Type>", "<Type>G</Type><Odd/>")
    assert found(catalog_of(tmp_path, text), 1) == [[]]


@pytest.mark.parametrize("count", [1, 2])
def test_the_documents_of_a_list_are_told_apart(tmp_path, count):
    sections = [esi(device(ODD * number, revision=f"{number}")) for number in range(1, count + 1)]
    db = catalog_of(tmp_path, f"<EtherCATInfoList>{''.join(sections)}</EtherCATInfoList>")
    assert found(db, *range(1, count + 1)) == [["L05"] * number for number in range(1, count + 1)]


def test_lines_tell_where_the_path_does_not(tmp_path):
    """Devices that occurs again: numbers of paths begin anew in it, those of the catalog go on."""
    devices = f"{device(revision='#x1')}</Devices>\n<Devices>\n{device(ODD, revision='#x2')}\n{device(revision='#x3')}"
    assert found(catalog_of(tmp_path, esi(devices)), 1, 2, 3) == [[], ["L05"], []]


def test_broken_markup_is_told_at_every_device_of_its_document(tmp_path):
    """What stands behind it may be lost, whichever device that is of."""
    devices = device() + "\n" + device("<Fmmu>Inputs&nbsp;</Fmmu>", revision="#x2") + "\n" + device(revision="#x3")
    assert [rules.count("L01") for rules in found(catalog_of(tmp_path, esi(devices)), 1, 2, 3)] == [1, 1, 1]


def test_a_lost_dictionary_is_told_at_the_device_that_names_it(tmp_path):
    profile = "<Profile><ProfileNo>402</ProfileNo><DictionaryFile>lost.xml</DictionaryFile></Profile>"
    text = esi(device() + device(profile, revision="#x2") + device(revision="#x3"))
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        catalog.ingest([write(tmp_path / "esi", {"a.xml": text})], jobs=1)
    assert found(tmp_path / "c.db", 1, 2, 3) == [[], ["L60"], []]
