"""The Python interface: open a catalog, fill it, ask it.

>>> catalog = Catalog.open("catalog.db", create=True)
>>> report = catalog.ingest(["data"])
>>> answer = catalog.identify(0x1097, 0x2406, 0x8F)
>>> drives = catalog.devices(modes=["CSV"], sync="sync0")
"""

import contextlib
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from esicatalog.errors import CatalogError
from esicatalog.identity import Identity, checked, checked_number, identity_of, parse_identity

if TYPE_CHECKING:
    import sqlalchemy as sa

    from esicatalog.catalog.check import CheckResult
    from esicatalog.catalog.database import DriverQuery
    from esicatalog.catalog.description import DeviceDescription
    from esicatalog.catalog.device_filter import DeviceFilter
    from esicatalog.catalog.identified_bus import BusReport
    from esicatalog.catalog.identity import IdentityLookup
    from esicatalog.catalog.listing import Listing
    from esicatalog.catalog.reader import RecordReader
    from esicatalog.catalog.results import FoundDevice, Identification, UnreachedModules
    from esicatalog.catalog.snapshot import Snapshot
    from esicatalog.esi.records.device import Device
    from esicatalog.esi.records.module import Module
    from esicatalog.export.sii_verify import Verification
    from esicatalog.export.subject import Subject
    from esicatalog.ingest.report import IngestReport
    from esicatalog.ingest.run import Progress
    from esicatalog.lint.registry import Rule
    from esicatalog.lint.report import DocumentFinding
    from esicatalog.scan.records import Scan, ScannedDictionary, ScannedPdos
    from esicatalog.sii.image import SiiImage

# SQLAlchemy and the records are loaded by what needs them: an ingest sets its workers to work before.


class Catalog:
    """A catalog of EtherCAT devices in a database."""

    def __init__(
        self, target: str | os.PathLike[str], create: bool = False, read_only: bool = False, at_once: bool = True
    ) -> None:
        """As :meth:`open`; with ``at_once`` false an existing catalog too is opened when it is first used."""
        if create and read_only:
            raise CatalogError("what only reads makes no catalog; leave out create or read_only")
        self._target = target
        self._read_only = read_only
        self._opened: sa.Engine | None = None
        self._query: DriverQuery | None = None
        self._lookup: IdentityLookup | None = None
        if at_once and not (create and _is_missing_file(target)):
            self._open(create)

    @classmethod
    def open(cls, target: str | os.PathLike[str], create: bool = False, read_only: bool = False) -> Self:
        """Open the catalog in a file or at a database URL; ``create`` makes a missing one on first use.

        A catalog stays with the file that a link means now, also when the link is switched to another one later.
        With ``read_only``, which excludes ``create``, the database refuses every change, whatever asks for one.
        Raises :class:`~esicatalog.errors.CatalogError` with what to do when that is not possible.
        """
        return cls(target, create, read_only)

    @staticmethod
    def migrate(target: str | os.PathLike[str]) -> tuple[str, str]:
        """Bring a catalog of an older version up to date; returns the schema versions before and after."""
        from esicatalog.catalog.database import upgrade_catalog

        return upgrade_catalog(target)

    def close(self) -> None:
        """Close all connections."""
        self._lookup = None
        if self._query is not None:
            self._query.close()
            self._query = None
        if self._opened is not None:
            self._opened.dispose()

    def _open(self, create: bool, when_new: Callable[[], object] = lambda: None) -> "sa.Engine":
        from esicatalog.catalog.database import open_catalog

        if self._opened is None:
            self._opened = open_catalog(self._target, create, self._read_only, when_new)
        return self._opened

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def ingest(
        self,
        paths: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
        jobs: int | None = None,
        prune: bool = False,
        progress: "Progress | None" = None,
    ) -> "IngestReport":
        """Ingest files, folders and zip archives, one path or several; what is unchanged is skipped.

        ``jobs`` is the number of worker processes (default: one a core, 1 = none); ``prune`` also removes what the
        given folders no longer hold; ``progress`` is called after every document. Raises
        :class:`~esicatalog.errors.InputError` for a missing path and for ``jobs`` below 1, and
        :class:`~esicatalog.errors.CatalogError` when the database cannot be written.
        """
        from esicatalog.catalog.own_files import own_files
        from esicatalog.ingest.plan import make_plan
        from esicatalog.ingest.reading import Reading
        from esicatalog.ingest.this_process import interrupts_wait

        # Taken letter by letter, the text of a path would ingest "/" and all that is below it.
        given = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
        own = own_files(self._target)
        with Reading(jobs) as reading:
            if self._opened is None and _is_missing_file(self._target):
                reading.start(make_plan(given, own_files=own))
            elif self._opened is None:
                reading.hash_ahead(given, own)

            def read_all() -> None:
                """Begin with what a catalog that is about to be made lacks: everything."""
                if reading.plan is None:
                    reading.start(make_plan(given, hashed=reading.hashed(), own_files=own))

            with interrupts_wait():
                from esicatalog.ingest.run import ingest

            return ingest(self._open(create=True, when_new=read_all), given, own, reading, prune, progress)

    def identify(self, vendor_id: int, product_code: int, revision_no: int | None = None) -> "Identification":
        """What the catalog knows about an identity; see :class:`~esicatalog.catalog.results.Identification`.

        Raises :class:`~esicatalog.errors.InputError` for what is no number of 32 bits.
        """
        checked(Identity(vendor_id, product_code, revision_no))
        if self._lookup is not None:
            return self._lookup.identify(vendor_id, product_code, revision_no)
        with self._identities() as lookup:
            return lookup.identify(vendor_id, product_code, revision_no)

    def identify_scan(
        self, scan: "Scan", pdos: "Sequence[ScannedPdos]" = (), dictionaries: "Sequence[ScannedDictionary]" = ()
    ) -> "list[BusReport]":
        """Who the slaves of a scan or ENI file are, bus by bus, and what is to be known of each bus.

        ``pdos`` and ``dictionaries``, as a master printed them, are compared with the descriptions. Raises
        :class:`~esicatalog.errors.InputError` when they do not say to which slave they belong, or belong to none.
        """
        from esicatalog.catalog.description import read_description
        from esicatalog.catalog.identified_bus import bus_reports

        with self._connection() as connection:
            lookup = self._lookup_beside(connection)

            def records(found: "FoundDevice") -> "tuple[Device, tuple[Module, ...]]":
                """Records of a described device that has vendor and product."""
                assert found.identity is not None
                description = read_description(connection, lookup, found.identity)
                return description.device, description.modules

            return bus_reports(lookup, scan, records, pdos, dictionaries)

    def verify_sii(self, image: "SiiImage") -> "Verification":
        """An EEPROM image against the descriptions of its identity; the one that fits best counts.

        Raises :class:`~esicatalog.sii.errors.SiiImageError` when all of them hold an image (Eeprom/Data) that is none.
        """
        from esicatalog.export.sii_verify import Verification, best_fit

        header = image.header
        with self._connection() as connection:
            lookup = self._lookup_beside(connection)
            answer = lookup.identify(header.vendor_id, header.product_code, header.revision_no)
            if not answer.is_exact:
                return Verification(answer, None, image.findings, (), ())
            described = [variant.device for variant in answer.variants]
            identities = (parse_identity(device.identity_text) for device in described)
            best = best_fit(image, (_subject_among_variants(connection, identity) for identity in identities))
        return Verification(answer, described[best.number], image.findings, best.unusable, best.differences)

    def devices(self, **filters: Any) -> "list[FoundDevice]":
        """Devices that fulfil all conditions, each with its evidence.

        ``filters`` are the fields of :class:`~esicatalog.catalog.device_filter.DeviceFilter`, as values or as the
        texts that the command takes, and a single one where several can be given: ``modes=["CSV", "CSP"]`` or
        ``modes="CSV,CSP"``, ``maps=[(0x60FF, None), (0x6041, 0)]`` or ``maps="0x60FF"``, ``bytes_in="<=8"``,
        ``vendor="0x1097"`` or a part of the name. Raises :class:`~esicatalog.errors.InputError` for what is no such
        value, and :class:`~esicatalog.errors.NotFound` for an unknown ``like``.
        """
        from esicatalog.catalog.filter_texts import filter_of_fields

        return self.find(filter_of_fields(filters))

    def find(self, wanted: "DeviceFilter") -> "list[FoundDevice]":
        """Devices that fulfil a filter, each with its evidence; like :meth:`devices`."""
        from esicatalog.catalog.search import find_devices

        with self._connection() as connection:
            return find_devices(connection, wanted)

    def list_devices(self, wanted: "DeviceFilter", offset: int = 0) -> "Listing":
        """A page of :meth:`find` (the filter's limit is its length) with what a list shows, and counts by filter."""
        from esicatalog.catalog.listing import list_devices

        with self._connection() as connection:
            return list_devices(connection, wanted, offset)

    def image(self, sha256: str) -> bytes | None:
        """An image of a vendor, group, device or module by its key; None when there is none."""
        from esicatalog.catalog.pictures import picture_of

        with self._connection() as connection:
            return picture_of(connection, sha256)

    def device(self, identity: str | Identity) -> "DeviceDescription":
        """One device with its records; ``identity`` is ``V:P[:R][@VARIANT]``, without R the latest revision.

        Raises :class:`~esicatalog.errors.NotFound` and :class:`~esicatalog.errors.InputError`.
        """
        from esicatalog.catalog.description import read_description

        wanted = identity_of(identity)
        with self._connection() as connection:
            return read_description(connection, _lookup_on(connection), wanted)

    def device_of_row(self, number: int) -> "FoundDevice":
        """The device with a row number of this catalog, as ``device_id`` in its tables says it.

        Row numbers are of one catalog file only; raises :class:`~esicatalog.errors.NotFound` for an unknown one.
        """
        from esicatalog.catalog.devices import device_of_row

        with self._connection() as connection:
            return device_of_row(connection, number)

    def export_subject(self, identity: str | Identity) -> "Subject":
        """What generators get of a device: its description with the vendor and groups of its document.

        Without a revision it says of the latest one whether others exchange something else, without a variant the same
        of the preferred description. Raises
        :class:`~esicatalog.errors.NotFound` and :class:`~esicatalog.errors.InputError`.
        """
        wanted = identity_of(identity)
        with self._connection() as connection:
            return _subject_among_variants(connection, wanted)

    def export_subjects(self, vendor_id: int) -> "Iterator[Subject]":
        """What generators get of all devices of a vendor, with codes and without: the preferred descriptions.

        They are read one by one, as they are asked for. Raises :class:`~esicatalog.errors.InputError` for what is no
        number of 32 bits.
        """
        checked_number(vendor_id, "vendor")
        return self._subjects_of_vendor(vendor_id)

    def _subjects_of_vendor(self, vendor_id: int) -> "Iterator[Subject]":
        from esicatalog.catalog.devices import devices_of_vendor
        from esicatalog.catalog.query import ConnectionQuery
        from esicatalog.catalog.reader import RecordReader

        with self._connection() as connection:
            reader = RecordReader(ConnectionQuery(connection))
            for number, found in devices_of_vendor(connection, vendor_id):
                yield _export_subject(connection, reader, number, found)

    def unreached_modules(self, vendor_id: int) -> "UnreachedModules":
        """The modules of a vendor that no slot of any device reaches, which :meth:`export_subjects` lacks therefore.

        Raises :class:`~esicatalog.errors.InputError` for what is no number of 32 bits.
        """
        checked_number(vendor_id, "vendor")
        from esicatalog.catalog.document_parts import unreached_modules

        with self._connection() as connection:
            return unreached_modules(connection, vendor_id)

    def content_hash(self) -> str | None:
        """SHA-256 over all descriptions and the documents that carry them, as the last ingest stored it.

        None until one has stored it, while one is under way and after one that was cut short. Documents that describe
        no device and what versions derive do not count.
        """
        from esicatalog.catalog.state import CONTENT_HASH

        with self._identities() as lookup:
            return lookup.state(CONTENT_HASH)

    def state_hash(self) -> str | None:
        """SHA-256 of what the content hash leaves out: all documents with the versions that read them, and the schema.

        None until an ingest has stored it, while one is under way and after one that was cut short.
        """
        from esicatalog.catalog.state import STATE_HASH

        with self._identities() as lookup:
            return lookup.state(STATE_HASH)

    def is_unfinished(self) -> bool:
        """Whether an ingest is under way or was cut short: what answers and lists lack may be described all the same.

        It is for who opens a catalog to ask, once; no answer says so itself.
        """
        from esicatalog.catalog.unfinished import is_unfinished

        with self._connection() as connection:
            return is_unfinished(connection)

    def findings(self, rules: "Iterable[Rule]") -> "list[DocumentFinding]":
        """What an ingest found by these rules, document by document, then what documents contradict each other in."""
        from esicatalog.catalog.stored_findings import stored_findings

        with self._connection() as connection:
            return list(stored_findings(connection, rules))

    def unchecked_documents(self, rules: "Iterable[Rule]") -> list[str]:
        """The documents that :meth:`findings` of these rules says nothing of, though none has looked at them.

        In words: those that the ingest could not read, and those that it refused where L01 is not among the rules.
        """
        from esicatalog.catalog.stored_findings import unchecked_documents

        with self._connection() as connection:
            return unchecked_documents(connection, rules)

    def check(self) -> "CheckResult":
        """Verify the database, its references and the stored content hash."""
        from esicatalog.catalog.check import check_catalog

        with self._connection() as connection:
            return check_catalog(connection)

    def snapshot(self, to: str | os.PathLike[str]) -> "Snapshot":
        """Copy the catalog into one read-only SQLite file; ``<hash>`` in its name becomes the content hash.

        ``<state>`` becomes the first 16 digits of a digest of what that leaves out (:meth:`state_hash`).

        Raises :class:`~esicatalog.errors.CatalogError` while an ingest is under way, when the file holds another
        catalog or is none that nobody writes to, and :class:`~esicatalog.errors.InputError` for a file that cannot be
        written and for a ``<…>`` that stands for nothing.
        """
        from esicatalog.catalog.snapshot import write_snapshot

        with self._connection() as connection:
            return write_snapshot(connection, os.fspath(to))

    def _lookup_of_file(self) -> "IdentityLookup | None":
        """Who answers identities from a file: always the same, on a connection that stays open; None on a server."""
        from esicatalog.catalog.database import DriverQuery
        from esicatalog.catalog.identity import IdentityLookup

        engine = self._open(create=True)
        if self._lookup is None and engine.dialect.name == "sqlite":
            self._query = DriverQuery(engine)
            self._lookup = IdentityLookup(self._query, self._query.changes)
        return self._lookup

    def _lookup_beside(self, connection: "sa.Connection") -> "IdentityLookup":
        """Who answers identities beside what else is read: on a server in the same transaction."""
        return self._lookup_of_file() or _lookup_on(connection)

    @contextlib.contextmanager
    def _identities(self) -> "Iterator[IdentityLookup]":
        """Who answers identities: on a server in one transaction."""
        lookup = self._lookup_of_file()
        if lookup is not None:
            yield lookup
            return
        with self._connection() as connection:
            yield _lookup_on(connection)

    @contextlib.contextmanager
    def _connection(self) -> "Iterator[sa.Connection]":
        from msgspec import DecodeError
        from sqlalchemy.exc import DBAPIError

        from esicatalog.catalog.database import reading_connection, shown_url
        from esicatalog.catalog.driver_errors import damage_error, database_error

        engine = self._open(create=True)
        try:
            with reading_connection(engine) as connection:
                yield connection
        except DBAPIError as error:
            raise database_error(shown_url(engine.url), error) from error
        except (DecodeError, UnicodeDecodeError) as error:
            raise damage_error(shown_url(engine.url), error) from error


def _is_missing_file(target: str | os.PathLike[str]) -> bool:
    text = os.fspath(target)
    return "://" not in text and not Path(text).exists()


def _lookup_on(connection: "sa.Connection") -> "IdentityLookup":
    from esicatalog.catalog.identity import IdentityLookup
    from esicatalog.catalog.query import ConnectionQuery

    return IdentityLookup(ConnectionQuery(connection))


def _subject_among_variants(connection: "sa.Connection", wanted: Identity) -> "Subject":
    from esicatalog.catalog.devices import find_device, variants_with_slots
    from esicatalog.catalog.query import ConnectionQuery
    from esicatalog.catalog.reader import RecordReader

    number, found, variants = find_device(connection, wanted)
    with_slots = variants_with_slots(connection, found, len(variants))
    ambiguities = _lookup_on(connection).ambiguities(wanted, found)
    subject = _export_subject(connection, RecordReader(ConnectionQuery(connection)), number, found)
    return subject.beside(with_slots, ambiguities)


def _export_subject(
    connection: "sa.Connection", reader: "RecordReader", number: int, found: "FoundDevice"
) -> "Subject":
    from esicatalog.catalog.document_parts import document_parts
    from esicatalog.export.subject import subject_of_description

    parts = document_parts(connection, number)
    (described,) = _lookup_on(connection).with_sources([(number, found)])
    modules = reader.modules_of(number)
    return subject_of_description(described, reader.device(number), modules).of_document(parts.vendor, parts.groups)
