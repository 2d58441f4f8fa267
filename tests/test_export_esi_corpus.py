"""Every real device, exported alone and with all others of its vendor, reads as before."""

from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import msgspec
import pytest
from test_esi_write_corpus import Schemas

from esicatalog.errors import DocumentError
from esicatalog.esi.containers import Archive
from esicatalog.esi.reader import Reader
from esicatalog.esi.records.document import EsiInfo, Group, Vendor
from esicatalog.export.esi import DeviceWithModules, export_esi, export_esi_files
from esicatalog.model.slots import reachable_modules


@pytest.fixture(scope="session")
def schemas(corpus: Path) -> Schemas:
    return Schemas(corpus / "xsd" / "1.17")


class Held:
    """Exported files as a container."""

    def __init__(self, files: dict[str, bytes]) -> None:
        self._files = files
        self._names = {name.lower(): name for name in files}

    def find(self, member: str) -> str | None:
        return self._names.get(member.lower())

    def read(self, member: str) -> bytes:
        return self._files[member]


def described(archives: Sequence[Path]) -> Iterator[tuple[bytes, EsiInfo, list[DeviceWithModules]]]:
    """Every document with its devices and the modules that their slots reach."""
    reader = Reader()
    for path in archives:
        opened = Archive(path)
        for member, _ in opened.members():
            content = opened.read(member)
            try:
                document = reader.read(content, member, opened).document
            except DocumentError:
                continue
            for info, referenced in zip(document.infos, document.referenced_modules, strict=True):
                modules = (*info.modules, *referenced)
                yield (
                    content,
                    info,
                    [DeviceWithModules(item, reachable_modules(item, modules)) for item in info.devices],
                )


def inline(owner: Any) -> Any:
    """A device or module as it is when nothing of it lies in another file."""
    profiles = tuple(
        msgspec.structs.replace(
            profile,
            dictionary_file=profile.dictionary_file if profile.dictionary is None else None,
            diag_files=profile.diag_files if profile.diag_messages is None else (),
        )
        for profile in owner.profiles
    )
    return msgspec.structs.replace(owner, profiles=profiles)


def compared(archives: Sequence[Path], schemas: Schemas) -> tuple[Counter[str], list[str]]:
    counts: Counter[str] = Counter()
    wrong = []
    for content, info, devices in described(archives):
        was_valid = schemas.error(content) is None
        for item in devices:
            vendor = info.vendor or Vendor()
            document = export_esi(vendor, info.groups, [item])
            (alone,) = Reader().read(document).document.infos
            files = export_esi_files("device.xml", vendor, info.groups, [item])
            (beside,) = Reader().read(files["device.xml"], "device.xml", Held(files)).document.infos
            same = (
                alone.vendor == beside.vendor == vendor
                and (alone.devices, beside.devices) == ((inline(item.device),), (item.device,))
                and alone.modules == tuple(map(inline, item.modules))
                and beside.modules == tuple(item.modules)
            )
            errors = [schemas.error(text) for text in (document, *files.values())] if was_valid else [None]
            if not same or any(errors):
                wrong.append(f"{item.device.type}: {'same' if same else 'differs'}, {errors}")
            counts["devices"] += 1
            counts["of valid documents"] += was_valid
            counts["with files"] += len(files) > 1
    return counts, wrong


def test_a_sample_of_real_devices(sample_archives, schemas):
    counts, wrong = compared(sample_archives, schemas)
    assert wrong == []
    assert counts["devices"] == 10


@pytest.mark.corpus
def test_every_device_of_the_corpus(corpus, schemas):
    counts, wrong = compared(sorted((corpus / "esi").glob("*.zip")), schemas)
    print(dict(counts))
    assert wrong == []
    assert (counts["devices"], counts["with files"]) == (2201, 147)


@pytest.mark.corpus
def test_whole_vendors_of_the_corpus(corpus):
    vendors: dict[int | None, list[DeviceWithModules]] = defaultdict(list)
    groups: dict[int | None, list[Group]] = defaultdict(list)
    for _, info, devices in described(sorted((corpus / "esi").glob("*.zip"))):
        number = info.vendor.vendor_id if info.vendor is not None else None
        vendors[number].extend(devices)
        groups[number].extend(info.groups)
    documents: Counter[int] = Counter()
    for number, devices in vendors.items():
        files = export_esi_files("vendor.xml", Vendor(vendor_id=number), groups[number], devices)
        container = Held(files)
        names = [name for name in files if name.startswith("vendor")]
        infos = [Reader().read(files[name], name, container).document.infos[0] for name in names]
        unread = [list(info.devices) for info in infos]
        for device, modules in devices:
            at = next(at for at, rest in enumerate(unread) if rest and rest[0] == device)
            reached = reachable_modules(unread[at].pop(0), infos[at].modules)
            assert sorted(reached, key=ident) == sorted(modules, key=ident), device.type
        assert not any(unread)
        documents[len(infos)] += 1
    assert documents == {1: len(vendors) - 1, 2: 1}, "of one vendor, seven devices plug other modules of known idents"


def ident(module: Any) -> int:
    return module.module_ident or 0
