"""Who is this device: the description of a vendor, product and revision, or the nearest one with the reason.

The lookup speaks to the database driver directly: masters, test benches and web pages ask for identities by the
thousand, and the statements below are all it takes.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Generic, NamedTuple, TypeVar

from msgspec import DecodeError

from esicatalog.catalog.document_status import RECOVERED
from esicatalog.catalog.driver_errors import damage_error
from esicatalog.catalog.query import Query
from esicatalog.catalog.reader import RecordReader
from esicatalog.catalog.results import NONE, VENDOR, DeviceSource, FoundDevice, Identification, IdentifiedDevice
from esicatalog.catalog.views import image_is_known, vendor_name
from esicatalog.errors import NotFound
from esicatalog.identity import NO_REVISION, Identity, is_read
from esicatalog.model.bus import DeviceAtBus
from esicatalog.model.compare_image import layout_difference
from esicatalog.model.image_layout import ImageLayout, image_layouts
from esicatalog.model.oversampling import has_oversampling
from esicatalog.model.process_image import default_process_image
from esicatalog.model.revisions import EXACT, EXACT_REASON, Described, rank
from esicatalog.words import hex32

NEAREST = 10
"""How many other candidates an answer names."""
_MOST_KEPT = 4096

_COLUMNS = (
    f"d.id, d.vendor_id, d.product_code, d.revision_no, d.variant, {vendor_name('d', 'v')}, d.type, d.name, d.hidden"
)
_OF_PRODUCT = (
    f"SELECT {_COLUMNS}, d.check_revision_no, f.image_signature, "
    f"{image_is_known('f')} FROM devices d "
    "LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN device_facts f ON f.device_id = d.id "
    "WHERE d.vendor_id = ? AND d.product_code = ? ORDER BY d.revision_no NULLS FIRST, d.type NULLS FIRST, d.variant"
)
"""In the order of the index ``ix_devices_listed``: sorting would take a quarter of the time."""
_SOURCES = (
    "SELECT x.device_id, s.member, s.location, x.line, x.group_type, y.file_version, s.status, s.message, "
    f"coalesce(s.is_whole, s.status <> '{RECOVERED}') FROM device_sources x "
    "JOIN sources s ON s.id = x.source_id "
    "LEFT JOIN source_vendors y ON y.source_id = x.source_id AND y.position = x.section "
    "WHERE x.device_id IN ({}) ORDER BY s.member, x.line, s.location"
)
_STATE = "SELECT value FROM catalog_state WHERE key = ?"
_VENDOR = "SELECT name FROM vendors WHERE vendor_id = ?"
_NEAR_PRODUCTS = " UNION ALL ".join(
    f"SELECT * FROM (SELECT {_COLUMNS} FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id "
    f"WHERE d.vendor_id = ? AND d.variant = 1 AND d.product_code {beside} ? "
    "AND (d.vendor_id <> 0 OR d.product_code <> 0) "
    f"ORDER BY d.product_code {direction}, d.hidden, d.revision_no NULLS FIRST, d.type NULLS FIRST "
    f"LIMIT {NEAREST}) AS {name}"
    for beside, direction, name in (("<", "DESC", "below"), (">", "ASC", "above"))
)
"""On both sides of a product code by the index, however many products the vendor has; none that is no identity."""


class _Row(NamedTuple):
    """A row of ``_OF_PRODUCT``; its device is made only if it goes into the answer."""

    id: int
    vendor_id: int | None
    product_code: int | None
    revision_no: int | None
    variant: int
    vendor: str | None
    type: str | None
    name: str | None
    hidden: int
    check_revision_no: str | None
    image_signature: str | None
    image_is_known: bool


_AT_BUS = (
    "SELECT d.physics, d.e_bus_current_ma, d.use_lrd_lwr, f.output_bytes, f.input_bytes, f.dc_supported, "
    "d.dc_potential_reference_clock, f.supports_sync0 "
    "FROM devices d JOIN device_facts f ON f.device_id = d.id "
    "WHERE d.vendor_id = ? AND d.product_code = ? AND d.variant = ? AND d.revision_no "
)
"""The rest is ``= ?`` or ``IS NULL``: an index serves either everywhere, ``IS NOT DISTINCT FROM`` not on PostgreSQL."""


Key = TypeVar("Key")
Value = TypeVar("Value")


class _Kept(Generic[Key, Value]):
    """What was read from the database, for as long as nobody changes it."""

    def __init__(self) -> None:
        self._held: dict[Key, tuple[int, Value]] = {}

    def get(self, key: Key, changes: int | None, read: Callable[[], Value]) -> Value:
        """The value of a key, read anew unless it was with the same ``changes``, which were counted before reading."""
        known = self._held.get(key)
        if known is not None and known[0] == changes:
            return known[1]
        value = read()
        if changes is not None:
            if len(self._held) >= _MOST_KEPT:
                self._held.clear()
            self._held[key] = (changes, value)
        return value


class IdentityLookup:
    """Answers identities on one connection to the database."""

    def __init__(self, query: Query, changes: Callable[[], int | None] = lambda: None) -> None:
        """``changes`` gives a number that grows whenever the database was changed, None where nobody counts that."""
        self._query = query
        self._changes = changes
        self._products: _Kept[tuple[int, int], list[_Row]] = _Kept()
        """Rows of products: revisions of one are asked for together."""
        self._answers: _Kept[tuple[int, int, int | None], Identification] = _Kept()
        """The slaves of a bus are often the same."""
        self._layouts: _Kept[str | None, Mapping[int, ImageLayout]] = _Kept()
        """Layouts by their signatures, of which the revisions of a product have few."""

    def identify(self, vendor_id: int, product_code: int, revision_no: int | None) -> Identification:
        """The descriptions of an identity, preferred first, or the nearest ones; see :func:`rank` for the order."""
        query = (vendor_id, product_code, revision_no)
        changes = self._changes()
        return self._answers.get(query, changes, lambda: self._of_one_state(query, changes))

    def _of_one_state(self, query: tuple[int, int, int | None], changes: int | None) -> Identification:
        """Answer again what others have changed meanwhile: a row number is another one's afterwards, or nobody's."""
        answer = None
        try:
            answer = self._identify(query, changes)
        except (NotFound, KeyError, DecodeError) as error:
            if self._changes() == changes:
                raise damage_error("the catalog", error) from error
        return answer if answer is not None and self._changes() == changes else self.identify(*query)

    def _identify(self, query: tuple[int, int, int | None], changes: int | None) -> Identification:
        vendor_id, product_code, revision_no = query
        if not is_read(vendor_id, product_code):
            # Vendors' templates have this identity too: one of them would be found for whatever was not read.
            return Identification(*query, NONE, "vendor and product 0: identity not read", None, (), ())
        rows = self._of_product((vendor_id, product_code), changes)
        if not rows:
            return self._unknown_product(query)
        exact = [row for row in rows if row.revision_no == revision_no] if revision_no is not None else []
        if exact:
            # No rule of CheckRevisionNo is asked, and the others are the neighbours by number: ranking all of them, as
            # for a revision that is not described, would take half as long again.
            match, reason = EXACT, EXACT_REASON
            chosen = sorted(exact, key=lambda row: row.variant)
            others = _other_revisions(rows, revision_no)
        else:
            match, reason, chosen, others = _nearest(rows, revision_no)
        variants = tuple(self.with_sources([(row.id, _device(row)) for row in chosen]))
        candidates = tuple(map(_device, others[:NEAREST]))
        of_variants = self._variant_warning(chosen[0], chosen[1:], changes)
        of_revisions = self._revision_warning(chosen[0], others, changes)
        return Identification(*query, match, reason, variants[0], variants, candidates, of_variants, of_revisions)

    def _of_product(self, key: tuple[int, int], changes: int | None) -> list[_Row]:
        return self._products.get(key, changes, lambda: list(map(_Row._make, self._query(_OF_PRODUCT, key))))

    def other_variants(self, device: FoundDevice) -> str | None:
        """How variants of the identity of a described device exchange something else; None if none does."""
        changes = self._changes()
        ours, rows = self._among_product(device, changes)
        if ours is None:
            return None
        alike = (row for row in rows if row.revision_no == ours.revision_no and row is not ours)
        return self._variant_warning(ours, sorted(alike, key=lambda row: row.variant), changes)

    def other_revisions(self, device: FoundDevice) -> str | None:
        """How other revisions of the product of a described device exchange something else; None if none does."""
        changes = self._changes()
        ours, rows = self._among_product(device, changes)
        if ours is None:
            return None
        return self._revision_warning(ours, _other_revisions(rows, ours.revision_no), changes)

    def _among_product(self, device: FoundDevice, changes: int | None) -> tuple[_Row | None, list[_Row]]:
        """The row of a described device, None where it has no codes or is gone by now, and all of its product."""
        if device.vendor_id is None or device.product_code is None:
            return None, []
        rows = self._of_product((device.vendor_id, device.product_code), changes)
        place = (device.revision_no, device.variant)
        return next((row for row in rows if (row.revision_no, row.variant) == place), None), rows

    def ambiguities(self, asked: Identity, found: FoundDevice) -> tuple[str, ...]:
        """What was chosen where an identity leaves it open and others exchange something else, in words.

        ``found`` is the description that was taken: the latest revision, the preferred variant.
        """
        is_open = asked.revision_no is None and not asked.without_revision
        revision = hex32(found.revision_no, NO_REVISION)
        told = {
            f"{asked} has several revisions; {revision} is taken, append :R to choose another": (
                self.other_revisions(found) if is_open else None
            ),
            f"{found.identity_text} has several descriptions; @1 is taken, append @N to choose another": (
                self.other_variants(found) if asked.variant is None else None
            ),
        }
        return tuple(f"{taken}: {differing}" for taken, differing in told.items() if differing is not None)

    def with_sources(self, found: Sequence[tuple[int, FoundDevice]]) -> list[IdentifiedDevice]:
        """Descriptions, given with their row numbers, with the documents and lines that carry them."""
        sources: dict[int, list[DeviceSource]] = {number: [] for number, _ in found}
        for number, *source, is_whole in self._query(_SOURCES.format(", ".join("?" * len(sources))), tuple(sources)):
            sources[number].append(DeviceSource(*(*source, bool(is_whole))))
        return [IdentifiedDevice(device, tuple(sources[number])) for number, device in found]

    def state(self, key: str) -> str | None:
        """An entry of catalog_state; None where none is stored."""
        return next((str(row[0]) for row in self._query(_STATE, (key,))), None)

    def at_bus(self, device: FoundDevice) -> DeviceAtBus | None:
        """What a bus has to know of a described device."""
        key = (device.vendor_id, device.product_code, device.variant)
        if device.revision_no is None:
            rows = self._query(f"{_AT_BUS} IS NULL", key)
        else:
            rows = self._query(f"{_AT_BUS} = ?", (*key, device.revision_no))
        row = next(iter(rows), None)
        if row is None:
            return None
        physics, current, no_lrw, output_bytes, input_bytes, dc_supported, reference_clock, sync0 = row
        return DeviceAtBus(
            physics,
            current,
            bool(no_lrw),
            output_bytes,
            input_bytes,
            bool(dc_supported),
            potential_reference_clock=bool(reference_clock) if reference_clock is not None else None,
            supports_sync0=bool(sync0),
        )

    def _unknown_product(self, query: tuple[int, int, int | None]) -> Identification:
        vendor_id, product_code, _ = query
        name = next(iter(self._query(_VENDOR, (vendor_id,))), None)
        if name is None:
            return Identification(*query, NONE, f"vendor {hex32(vendor_id)} is not in the catalog", None, (), ())
        near = map(_device, self._query(_NEAR_PRODUCTS, (vendor_id, product_code) * 2))
        ranked = sorted(near, key=lambda device: _distance(device, product_code))
        candidates = tuple(ranked[:NEAREST])
        named = f" ({name[0]})" if name[0] else ""
        reason = f"vendor {hex32(vendor_id)}{named} is known, its product {hex32(product_code)} is not"
        return Identification(*query, VENDOR, reason, None, (), candidates)

    def _variant_warning(self, ours: _Row, variants: list[_Row], changes: int | None) -> str | None:
        return self._warning(ours, variants, changes, "variants of this identity", lambda row: f"@{row.variant}")

    def _revision_warning(self, ours: _Row, others: list[_Row], changes: int | None) -> str | None:
        return self._warning(
            ours, others, changes, "revisions", lambda row: hex32(row.revision_no, "the one without RevisionNo")
        )

    def _warning(
        self, ours: _Row, rows: list[_Row], changes: int | None, what: str, name: Callable[[_Row], str]
    ) -> str | None:
        """Descriptions with another default process image: code written for one reads wrong data on the other.

        Equal ones that are not described in full may be other ones, too.
        """
        differing = [row for row in rows if row.image_signature != ours.image_signature]
        alike = [row for row in rows if row.image_signature == ours.image_signature]
        unknown = [row for row in alike if not (ours.image_is_known and row.image_is_known)]
        if not differing and not unknown:
            return None
        if not differing:
            return (
                f"whether the default process image differs in {len(unknown)} of {len(rows)} other {what} is not "
                "known: its length is not described"
            )
        nearest = differing[0]
        words = layout_difference(self._layout(ours, changes), self._layout(nearest, changes))
        more = f", whether in {len(unknown)} more is not known" if unknown else ""
        return (
            f"default process image differs in {len(differing)} of {len(rows)} other {what}{more}; "
            f"{name(nearest)} for example: {words}"
        )

    def _layout(self, row: _Row, changes: int | None) -> Mapping[int, ImageLayout]:
        return self._layouts.get(row.image_signature, changes or 0, lambda: self._read_layout(row.id))

    def _read_layout(self, device_id: int) -> Mapping[int, ImageLayout]:
        reader = RecordReader(self._query, with_dictionaries=False)
        device, modules = reader.device(device_id), reader.modules_of(device_id)
        if has_oversampling(device):
            # Dictionaries, most of what there is to read, say which PDOs hold the samples, and nothing else of these.
            device = RecordReader(self._query).device(device_id)
        return image_layouts(default_process_image(device, modules))


def _device(row: tuple[Any, ...]) -> FoundDevice:
    _, vendor_id, product_code, revision_no, variant, vendor, type_text, name, hidden, *_ = row
    return FoundDevice(vendor_id, product_code, revision_no, variant, vendor, type_text, name, bool(hidden))


def _other_revisions(rows: list[_Row], revision_no: int | None) -> list[_Row]:
    """The preferred descriptions of the other revisions of a product: visible ones first, nearest by number."""
    return sorted(
        (row for row in rows if row.revision_no != revision_no and row.variant == 1),
        key=lambda row: (row.hidden, abs((row.revision_no or 0) - (revision_no or 0))),
    )


def _distance(device: FoundDevice, product_code: int) -> tuple[int, int, bool, int]:
    """Nearest product first, its visible revisions before hidden ones."""
    found = device.product_code or 0
    return (abs(found - product_code), found, device.hidden, device.revision_no or 0)


def _nearest(rows: list[_Row], revision_no: int | None) -> tuple[str, str, list[_Row], list[_Row]]:
    """Match, reason, the chosen descriptions and those of other revisions, best first.

    Variants of one revision may have different CheckRevisionNo, so each is ranked; of the others one a revision counts.
    """
    ranked = rank(
        revision_no,
        [Described(row.revision_no, row.check_revision_no, bool(row.hidden), row.variant) for row in rows],
    )
    best = rows[ranked[0].position]
    in_order = [rows[item.position] for item in ranked]
    chosen = [row for row in in_order if row.revision_no == best.revision_no]
    others: dict[int | None, _Row] = {}
    for row in in_order:
        if row.revision_no != best.revision_no:
            others.setdefault(row.revision_no, row)
    return ranked[0].match, ranked[0].reason, chosen, list(others.values())
