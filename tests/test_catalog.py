"""The Catalog of Python: the file that it opens and stays with, and what its methods refuse."""

from pathlib import Path

import pytest
from snippets import device, esi, write

from esicatalog import BrokenDocument, Catalog, CatalogError, InputError, read_esi

VENDOR = 0xE5C


def made(db: Path, product: int) -> Path:
    """A catalog of one device."""
    with Catalog.open(db, create=True) as catalog:
        catalog.ingest(write(db.with_suffix(""), {"a.xml": esi(device(product=f"#x{product:X}"))}), jobs=1)
    return db


def answers(catalog: Catalog) -> tuple[set[int | None], list[int]]:
    """The products that a catalog lists, and those of 1 and 2 that it identifies."""
    exact = [product for product in (1, 2) if catalog.identify(VENDOR, product).device is not None]
    return {found.identity.product_code for found in catalog.devices()}, exact


def test_a_catalog_stays_with_the_file_that_a_link_meant_when_it_was_opened(tmp_path):
    for product in (1, 2):
        made(tmp_path / f"{product}.db", product)
    link = tmp_path / "current.db"
    link.symlink_to("1.db")
    with Catalog.open(link) as catalog, Catalog.open(link, read_only=True) as asked:
        assert answers(asked) == ({1}, [1])
        (tmp_path / "next.db").symlink_to("2.db")
        (tmp_path / "next.db").replace(link)
        # The first has made one connection so far, the second the one that it keeps besides.
        for before in (catalog, asked):
            assert answers(before) == ({1}, [1])
            before.close()
            assert answers(before) == ({1}, [1])
        with Catalog.open(link) as opened_later:
            assert answers(opened_later) == ({2}, [2])
        assert catalog.ingest(write(tmp_path / "more", {"b.xml": esi(device(product="#x3"))})).counts["stored"] == 1
    with Catalog.open(tmp_path / "1.db") as first, Catalog.open(tmp_path / "2.db") as second:
        assert (answers(first)[0], answers(second)[0]) == ({1, 3}, {2})


@pytest.mark.parametrize("replace", [Path.replace, lambda new, old: old.unlink()])
def test_a_file_that_was_replaced_or_removed_is_not_opened_again(tmp_path, replace):
    db, new = made(tmp_path / "c.db", 1), made(tmp_path / "new.db", 2)
    with Catalog.open(db) as catalog:
        catalog.close()
        replace(new, db)
        for ask in (catalog.devices, catalog.check, lambda: catalog.identify(VENDOR, 1)):
            with pytest.raises(CatalogError, match=r"c\.db: is not the file any more that was opened; open the cat"):
                ask()
    assert db.exists() == (replace is Path.replace)


@pytest.mark.parametrize("jobs", [0, -1, "2", 2.0])
def test_an_ingest_by_no_number_of_workers_is_refused(tmp_path, jobs):
    documents = write(tmp_path / "documents", {"a.xml": esi(device()), "b.xml": esi(device(product="#x2"))})
    catalog = Catalog.open(tmp_path / "c.db", create=True)
    with pytest.raises(InputError, match=f"jobs {jobs!r}: give the number of worker processes"):
        catalog.ingest(documents, jobs=jobs)
    assert not (tmp_path / "c.db").exists()


@pytest.mark.parametrize("target", [":memory:", "sqlite://", "sqlite:///", "sqlite:///:memory:"])
def test_a_catalog_needs_a_file(tmp_path, target):
    """Each connection to memory has its own: an ingest would tell of devices that nobody finds."""
    documents = write(tmp_path, {"a.xml": esi(device())})
    with pytest.raises(CatalogError, match="needs a file, not memory"):
        Catalog.open(target, create=True).ingest(documents)
    with pytest.raises(CatalogError, match="needs a file, not memory"):
        Catalog.open(target)


def test_a_catalog_into_which_nothing_was_ingested_is_sound(tmp_path):
    with Catalog.open(tmp_path / "c.db", create=True) as catalog:
        assert (catalog.check().problems, catalog.content_hash(), catalog.state_hash()) == ([], None, None)
        with pytest.raises(CatalogError, match="nothing was ingested yet, or an ingest is under way"):
            catalog.snapshot(tmp_path / "snapshot.db")


def test_a_folder_is_no_snapshot(tmp_path):
    with Catalog.open(made(tmp_path / "c.db", 1)) as catalog, pytest.raises(InputError, match="is a folder; name a f"):
        catalog.snapshot(tmp_path)


def test_a_name_with_nul_is_no_file(tmp_path):
    catalog = Catalog.open(tmp_path / "c.db", create=True)
    for take in (catalog.ingest, read_esi):
        with pytest.raises((InputError, BrokenDocument), match="no such file"):
            take("a\0b")
    with pytest.raises(CatalogError, match="holds a NUL"):
        Catalog.open("a\0b")
