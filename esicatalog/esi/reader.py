"""Reading documents into records, with everything they refer to."""

import posixpath
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, NamedTuple

import msgspec
from lxml import etree

from esicatalog.errors import BrokenDocument, DocumentError, NotAnEsiDocument
from esicatalog.esi.binding import Record, read_record
from esicatalog.esi.containers import Container, Folder, no_file_reason, reference_path, resolve_reference
from esicatalog.esi.content import sha256_hex
from esicatalog.esi.documents import ParsedDocument, parse_as_it_is, parse_document
from esicatalog.esi.layouts import Layouts
from esicatalog.esi.lines import Lines
from esicatalog.esi.notes import REFUSED, Finding, Notes
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device
from esicatalog.esi.records.diagnostics import DiagMessage, joined_diagnostics
from esicatalog.esi.records.dictionary import DataType, Dictionary, InfoSubItem, Object, SubItem
from esicatalog.esi.records.document import (
    DiagInfo,
    DictInfo,
    Document,
    EsiInfo,
    InfoList,
    ModuleInfo,
    Reference,
)
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import Entry, Pdo
from esicatalog.esi.records.profile import Profile
from esicatalog.esi.repeats import Cut, Repeats
from esicatalog.esi.stages import Stages
from esicatalog.esi.tree import DocumentTree

OWNERS: frozenset[type] = frozenset({Device, Module})
"""Records that keep the unmapped values found below them."""

_REPEATED = (DataType, SubItem, Object, InfoSubItem, Pdo, Entry, OpMode, DiagMessage)
"""Records of parts that repeat from device to device and from revision to revision."""
_WITHOUT_REFERENCES = ("EtherCATDict", "EtherCATDiag")
_FITTING = {
    "DictionaryFile": ("EtherCATDict", "Dictionary"),
    "DiagFile": ("EtherCATDiag", "DiagMessages"),
    "InfoReference": ("EtherCATModule", "Module"),
}
"""What a reference is meant for: the root of such a document, and what is taken from it."""
_MAX_STANDALONE = 1_000
_MAX_TREES_BYTES = 8_000_000
"""Of the text of kept trees, which take five times as much; the dictionaries of the largest library seen have 12 MB."""


class ReadDocument(msgspec.Struct, frozen=True):
    """What reading a document gave: its record and the findings with their lines."""

    document: Document
    findings: tuple[Finding, ...]


class ReferencedModule(NamedTuple):
    """A module of a document that another one names by InfoReference, with the vendor of its own document."""

    module: Module
    vendor_id: int | None


class Pulled(NamedTuple):
    """A document that was read because another one refers to it."""

    sha256: str
    byte_count: int
    document: ReadDocument
    tree: Callable[[], DocumentTree]
    """Gives its elements; whoever asks twice may make it read the document again."""


class Reader:
    """Reads documents; keeps repeated subtrees and external documents for the next one.

    ``stages`` learns how long parsing takes.
    """

    def __init__(self, stages: Stages | None = None) -> None:
        self._stages = stages or Stages()
        self._repeats = Repeats(_REPEATED, Layouts(_REPEATED).read)
        self._standalone: dict[_PulledKey, tuple[Container, ReadDocument]] = {}
        self._trees = _Trees()
        self._pulled: dict[tuple[int, str], tuple[Container, Pulled]] = {}

    def pulled(self, container: Container, member: str) -> Pulled | None:
        """A document that was pulled in before and is the same read by itself: one without references."""
        known = self._pulled.get((id(container), member))
        return known[1] if known is not None and known[1].document.document.root in _WITHOUT_REFERENCES else None

    def read(self, content: bytes, member: str = "", container: Container | None = None) -> ReadDocument:
        """Read one document of any ESI kind.

        ``member`` is its name within ``container``, against which references are resolved; without a container
        they stay unresolved. Raises :class:`NotAnEsiDocument` and :class:`BrokenDocument`.
        """
        return self.read_tree(content, member, container)[0]

    def read_tree(
        self, content: bytes, member: str = "", container: Container | None = None
    ) -> tuple[ReadDocument, Callable[[], DocumentTree]]:
        """:meth:`read`, and what gives the elements of the document."""
        return self._read_content(content, member, container, with_modules=True)

    def _read_content(
        self, content: bytes, member: str, container: Container | None, with_modules: bool
    ) -> tuple[ReadDocument, Callable[[], DocumentTree]]:
        with self._stages("parse"):
            cut = self._repeats.cut(content)
            parsed = parse_as_it_is(cut.content) if cut is not None else None
        if cut is not None and parsed is not None:
            lines = Lines(cut.content)
            try:
                read = self._read(parsed, lines, cut, member, container, with_modules)
            finally:
                cut.settle()
            if cut.is_complete:
                return read, DocumentTree(parsed.root, lines, cut).itself
        with self._stages("parse"):
            parsed = parse_document(content)
        lines = Lines(content)
        read = self._read(parsed, lines, None, member, container, with_modules)
        return read, DocumentTree(parsed.root, lines).itself

    def _read(
        self,
        parsed: ParsedDocument,
        lines: Lines,
        cut: Cut | None,
        member: str,
        container: Container | None,
        with_modules: bool,
    ) -> ReadDocument:
        notes = Notes(OWNERS, cut, lines.of)
        notes.findings += [Finding(REFUSED, "E", problem.message, problem.line) for problem in parsed.problems]
        if parsed.root.tag == "EtherCATDict":
            return self._read_dictionary(parsed, notes)
        if parsed.root.tag == "EtherCATDiag":
            diag = read_record(DiagInfo, parsed.root, notes)
            return _result(parsed, notes, schema_version=diag.schema_version, diag_messages=diag.diag_messages)
        elements, infos = _sections(parsed.root, notes)
        of_modules = "Modules/Module" if parsed.root.tag == "EtherCATModule" else "Descriptions/Modules/Module"
        devices, modules = (
            [section.findall(path) for section in elements] for path in ("Descriptions/Devices/Device", of_modules)
        )
        references: list[Reference] = []
        referenced: list[tuple[ReferencedModule, ...]] = [() for _ in infos]
        if container is not None:
            pull = _Puller(self, container, member, notes, references)
            infos = [pull.resolve(*section) for section in zip(infos, devices, modules, strict=True)]
            if with_modules:
                referenced = [pull.modules(info, element) for info, element in zip(infos, elements, strict=True)]
        return _result(
            parsed,
            notes,
            infos=tuple(infos),
            referenced_modules=tuple(tuple(item.module for item in section) for section in referenced),
            referenced_vendor_ids=tuple(tuple(item.vendor_id for item in section) for section in referenced),
            references=tuple(references),
            device_lines=tuple(tuple(map(lines.of, section)) for section in devices),
            module_lines=tuple(tuple(map(lines.of, section)) for section in modules),
        )

    def _read_dictionary(self, parsed: ParsedDocument, notes: Notes) -> ReadDocument:
        found = read_record(DictInfo, parsed.root, notes)
        return _result(parsed, notes, schema_version=found.schema_version, dictionary=found.dictionary)

    def external(
        self, kind: str, container: Container, member: str, content: bytes, sha256: str
    ) -> tuple[Any, Document]:
        """Dictionary, diagnosis texts or modules of a referenced document, and the document.

        Raises :class:`DocumentError`.
        """
        read = self._read_pulled(kind, container, member, content, sha256)

        def tree() -> DocumentTree:
            return self._trees.take(sha256) or self.read_tree(container.read(member))[1]()

        self._pulled[id(container), member] = (container, Pulled(sha256, len(content), read, tree))
        document = read.document
        held = {
            "DictionaryFile": document.dictionary,
            "DiagFile": document.diag_messages,
            "InfoReference": _modules_of(document) or None,
        }[kind]
        if held is None:
            root, part = _FITTING[kind]
            fault = f"holds no {part}" if document.root == root else f"its root {document.root} does not fit {kind}"
            raise NotAnEsiDocument(fault)
        return held, document

    def _read_pulled(self, kind: str, container: Container, member: str, content: bytes, sha256: str) -> ReadDocument:
        """Read a document that others refer to, and keep it: it is asked for again, as itself too.

        A document of modules is read with the dictionaries and diagnosis texts that lie around it, never with the
        modules of others: nobody asks for these, and documents may refer to each other in circles.
        """
        of_modules = kind == "InfoReference"
        anywhere, here = _PulledKey(sha256, of_modules), _PulledKey(sha256, of_modules, id(container), member)
        known = self._standalone.get(anywhere) or self._standalone.get(here)
        if known is not None:
            return known[1]
        if len(self._standalone) >= _MAX_STANDALONE:
            self._standalone.clear()
            self._pulled.clear()
        around = container if of_modules else None
        read, tree = self._read_content(content, member, around, with_modules=False)
        self._standalone[here if read.document.references else anywhere] = (container, read)
        self._trees.keep(sha256, tree(), len(content))
        return read


class _PulledKey(NamedTuple):
    """What a document that others refer to is kept by; one that refers to nothing is the same in every place."""

    sha256: str
    of_modules: bool
    container: int = 0
    member: str = ""


class _Trees:
    """Trees of documents that were read for others, until these are handled as themselves; the oldest give way."""

    def __init__(self) -> None:
        self._kept: dict[str, tuple[DocumentTree, int]] = {}
        self._held_bytes = 0

    def keep(self, sha256: str, tree: DocumentTree, byte_count: int) -> None:
        """Keep the tree of a document of so many bytes; what was cut out of it takes no room."""
        self.take(sha256)
        held = len(tree.cut.content) if tree.cut is not None else byte_count
        self._kept[sha256] = tree, held
        self._held_bytes += held
        while self._held_bytes > _MAX_TREES_BYTES:
            self.take(next(iter(self._kept)))

    def take(self, sha256: str) -> DocumentTree | None:
        """The tree of a document, which is then no longer kept."""
        tree, held = self._kept.pop(sha256, (None, 0))
        self._held_bytes -= held
        return tree


def _modules_of(document: Document) -> tuple[ReferencedModule, ...]:
    return tuple(ReferencedModule(module, info.vendor_id) for info in document.infos for module in info.modules)


def _sections(root: etree._Element, notes: Notes) -> tuple[list[etree._Element], list[EsiInfo]]:
    if root.tag == "EtherCATInfoList":
        return list(root.iterchildren("EtherCATInfo")), list(read_record(InfoList, root, notes).infos)
    if root.tag == "EtherCATModule":
        module = read_record(ModuleInfo, root, notes)
        as_info = EsiInfo(schema_version=module.schema_version, vendor=module.vendor, modules=module.modules)
        return [root], [as_info]
    return [root], [read_record(EsiInfo, root, notes)]


def _result(parsed: ParsedDocument, notes: Notes, **fields: Any) -> ReadDocument:
    document = Document(
        root=str(parsed.root.tag),
        encoding=parsed.encoding,
        recovered=parsed.recovered,
        is_whole=parsed.is_whole,
        unmapped=tuple(notes.unmapped),
        **fields,
    )
    return ReadDocument(document, tuple(notes.findings))


class _Puller:
    """Resolves the references of one document."""

    def __init__(
        self, reader: Reader, container: Container, member: str, notes: Notes, references: list[Reference]
    ) -> None:
        self._reader = reader
        self._container = container
        self._member = member
        self._notes = notes
        self._references = references
        self._pulled: dict[tuple[str, str], Any] = {}

    def resolve(
        self, info: EsiInfo, device_elements: Iterable[etree._Element], module_elements: Iterable[etree._Element]
    ) -> EsiInfo:
        """``info`` with the dictionaries and diagnosis texts of its devices and modules filled in."""
        devices, modules = (
            tuple(self._with_profiles(*owner) for owner in zip(records, elements, strict=True))
            for records, elements in ((info.devices, device_elements), (info.modules, module_elements))
        )
        if all(map(_same, devices, info.devices)) and all(map(_same, modules, info.modules)):
            return info
        return msgspec.structs.replace(info, devices=devices, modules=modules)

    def modules(self, info: EsiInfo, element: etree._Element) -> tuple[ReferencedModule, ...]:
        """Modules of the documents that ``info`` names by InfoReference."""
        found: list[ReferencedModule] = []
        for text in info.info_references:
            found.extend(self._pull("InfoReference", text, element) or ())
        return tuple(found)

    def _with_profiles(self, owner: Any, element: etree._Element) -> Any:
        if not any(profile.dictionary_file or profile.diag_files for profile in owner.profiles):
            return owner
        profiles = tuple(self._with_externals(profile, element) for profile in owner.profiles)
        return msgspec.structs.replace(owner, profiles=profiles)

    def _with_externals(self, profile: Profile, element: etree._Element) -> Profile:
        changes: dict[str, Any] = {}
        if profile.dictionary_file and profile.dictionary is None:
            dictionary: Dictionary | None = self._pull("DictionaryFile", profile.dictionary_file, element)
            if dictionary is not None:
                changes["dictionary"] = dictionary
        if profile.diag_files and profile.diag_messages is None:
            merged = joined_diagnostics([self._pull("DiagFile", text, element) for text in profile.diag_files])
            if merged is not None:
                changes["diag_messages"] = merged
        return msgspec.structs.replace(profile, **changes) if changes else profile

    def _pull(self, kind: str, text: str, element: etree._Element) -> Any:
        key = (kind, text)
        if key in self._pulled:
            return self._pulled[key]
        member = resolve_reference(self._container, self._member, text)
        held, document, sha256, problem = None, None, None, "was not found beside the document"
        if member is not None:
            try:
                content = self._container.read(member)
                sha256 = sha256_hex(content)
                held, document = self._reader.external(kind, self._container, member, content, sha256)
            except DocumentError as error:
                problem = f"cannot be used: {error}"
        if held is None:
            self._notes.find(element, "L60", "W", f"{kind} {text!r} {problem}")
        is_whole = document is not None and document.is_whole
        self._references.append(Reference(kind=kind, text=text, location=member, sha256=sha256, is_whole=is_whole))
        # When one of these changes, what this document says does too.
        further = document.references if document is not None else ()
        self._references += [msgspec.structs.replace(item, text=_seen_past(text, item.text)) for item in further]
        self._pulled[key] = held
        return held


def _seen_past(document: str, reference: str) -> str:
    """A reference in a document as seen from the one that refers to that document by the text ``document``."""
    folder = posixpath.dirname(reference_path(document))
    return posixpath.join(folder, reference_path(reference)) if folder else reference


def _same(new: Record, old: Record) -> bool:
    return new is old


def read_esi(path: str | Path) -> ReadDocument:
    """Read one ESI file from disk, with the documents it refers to in the same folder or below.

    Raises :class:`NotAnEsiDocument` for ENI and other content, :class:`BrokenDocument` when nothing can be read; both
    name the file.
    """
    file = Path(path)
    if not file.is_file():
        reason = "is a folder; give an ESI file" if file.is_dir() else no_file_reason(file) or "no such file"
        raise BrokenDocument(f"{file}: {reason}")
    folder = Folder(file.parent)
    try:
        return Reader().read(folder.read(file.name), file.name, folder)
    except DocumentError as error:
        raise type(error)(f"{file}: {error}", error.line) from error
