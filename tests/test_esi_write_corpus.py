"""Real documents are written so that they read the same, and valid wherever they were."""

from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from lxml import etree

from esicatalog.errors import DocumentError
from esicatalog.esi.containers import Archive
from esicatalog.esi.reader import Reader
from esicatalog.esi.records.document import DiagInfo, DictInfo, Document, EsiInfo, InfoList, ModuleInfo
from esicatalog.esi.write import write_esi

SCHEMAS = ("EtherCATInfo", "EtherCATModule", "EtherCATDict", "EtherCATDiag")


class Schemas:
    """The schema files of the corpus, by root element."""

    def __init__(self, folder: Path) -> None:
        self._by_root = {name: etree.XMLSchema(etree.parse(folder / f"{name}.xsd")) for name in SCHEMAS}

    def error(self, content: bytes) -> str | None:
        """What is wrong with a document, None when it is valid; a list of EtherCATInfo has no schema."""
        try:
            root = etree.fromstring(content)
        except etree.XMLSyntaxError as error:
            return str(error)
        schema = self._by_root.get(str(root.tag))
        if schema is None:
            return f"no schema for {root.tag!s}"
        return None if schema.validate(root) else str(schema.error_log[0])


@pytest.fixture(scope="session")
def schemas(corpus: Path) -> Schemas:
    return Schemas(corpus / "xsd" / "1.17")


def documents(archives: Iterable[Path]) -> Iterator[tuple[str, bytes, Document]]:
    """Every readable document of archives, each by itself: references stay references."""
    for path in archives:
        opened = Archive(path)
        for member, _ in opened.members():
            content = opened.read(member)
            try:
                yield f"{path.name}!{member}", content, Reader().read(content).document
            except DocumentError:
                continue


def content_of(document: Document) -> EsiInfo | InfoList | ModuleInfo | DictInfo | DiagInfo:
    if document.root == "EtherCATDict":
        return DictInfo(dictionary=document.dictionary)
    if document.root == "EtherCATDiag":
        return DiagInfo(diag_messages=document.diag_messages)
    if document.root == "EtherCATInfoList":
        return InfoList(infos=document.infos)
    (info,) = document.infos
    if document.root == "EtherCATModule":
        return ModuleInfo(schema_version=info.schema_version, vendor=info.vendor, modules=info.modules)
    return info


def compared(archives: Iterable[Path], schemas: Schemas) -> tuple[Counter[str], list[str]]:
    """What was compared, counted, and the documents that differ or are no longer valid."""
    counts: Counter[str] = Counter()
    differing = []
    for name, content, document in documents(archives):
        written = write_esi(content_of(document))
        again = Reader().read(written).document
        same = (again.root, again.infos, again.dictionary, again.diag_messages) == (
            document.root,
            document.infos,
            document.dictionary,
            document.diag_messages,
        )
        was, now = schemas.error(content), schemas.error(written)
        if not same or (was is None and now is not None):
            differing.append(f"{name}: {'same' if same else 'differs'}, {now or 'valid'}")
        counts["documents"] += 1
        counts["valid before"] += was is None
        counts["valid written"] += now is None
        counts["devices"] += sum(len(info.devices) for info in document.infos)
        counts["modules"] += sum(len(info.modules) for info in document.infos)
    return counts, differing


def test_a_sample_of_real_archives(sample_archives, schemas):
    counts, differing = compared(sample_archives, schemas)
    assert differing == []
    assert counts["devices"] == 10


@pytest.mark.corpus
def test_all_of_the_corpus(corpus, schemas):
    counts, differing = compared(sorted((corpus / "esi").glob("*.zip")), schemas)
    print(dict(counts))
    assert differing == []
    assert (counts["devices"], counts["modules"]) == (2201, 556)
    assert counts["valid before"] <= counts["valid written"]
