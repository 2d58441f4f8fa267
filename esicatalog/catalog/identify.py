"""Who is this device: lookup by vendor, product and revision."""

from collections.abc import Iterable, Sequence
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog.results import DeviceSource, FoundDevice, Identification, IdentifiedDevice, hex32
from esicatalog.catalog.schema import device_sources, devices, source_vendors, sources, vendors
from esicatalog.errors import NotFound
from esicatalog.identity import Identity

_NEAREST = 10
"""How many other candidates an answer names."""

SUMMARY = (
    sa.select(
        devices.c.id,
        devices.c.vendor_id,
        devices.c.product_code,
        devices.c.revision_no,
        devices.c.variant,
        devices.c.hidden,
        vendors.c.name.label("vendor"),
        devices.c.type,
        devices.c.name,
    )
    .outerjoin(vendors, vendors.c.vendor_id == devices.c.vendor_id)
    .order_by(devices.c.vendor_id, devices.c.product_code, devices.c.revision_no, devices.c.variant)
)
"""Descriptions as lists show them; :func:`summary` makes values of its rows."""


def summary(row: Any, evidence: Iterable[str] = ()) -> FoundDevice:
    """A device in a list, from a row of the summary columns."""
    return FoundDevice(
        row.vendor_id, row.product_code, row.revision_no, row.variant, row.vendor, row.type, row.name, tuple(evidence)
    )


def identify(connection: sa.Connection, vendor_id: int, product_code: int, revision_no: int | None) -> Identification:
    """The descriptions of an identity, preferred first; without revision those of the highest one.

    Where the revision or product is not in the catalog no device is named, only what comes near.
    """
    rows = connection.execute(
        SUMMARY.where(devices.c.vendor_id == vendor_id, devices.c.product_code == product_code)
    ).all()
    revisions = sorted({row.revision_no for row in rows if row.revision_no is not None})
    if revision_no in revisions:
        reason = "the catalog describes exactly this revision"
        return _found(connection, (vendor_id, product_code, revision_no), "exact", reason, rows, revision_no)
    if rows and revision_no is None:
        latest = revisions[-1] if revisions else None
        reason = f"no revision asked for; {hex32(latest)} is the highest of {len(revisions)}"
        return _found(connection, (vendor_id, product_code, None), "product", reason, rows, latest)
    if rows:
        reason = f"the catalog knows this product in {len(revisions)} other revision(s), not in {hex32(revision_no)}"
        nearest = sorted(
            (row for row in rows if row.variant == 1), key=lambda r: abs((r.revision_no or 0) - (revision_no or 0))
        )
        candidates = tuple(summary(row) for row in nearest[:_NEAREST])
        return Identification(vendor_id, product_code, revision_no, "product", reason, None, (), candidates)
    return _unknown_product(connection, vendor_id, product_code, revision_no)


def _found(
    connection: sa.Connection,
    query: tuple[int, int, int | None],
    match: str,
    reason: str,
    rows: Any,
    chosen: int | None,
) -> Identification:
    variants = tuple(
        IdentifiedDevice(summary(row), device_sources_of(connection, row.id))
        for row in rows
        if row.revision_no == chosen
    )
    others = tuple(summary(row) for row in rows if row.revision_no != chosen and row.variant == 1)
    return Identification(*query, match, reason, variants[0], variants, others[-_NEAREST:])


def _unknown_product(
    connection: sa.Connection, vendor_id: int, product_code: int, revision_no: int | None
) -> Identification:
    name = connection.execute(sa.select(vendors.c.name).where(vendors.c.vendor_id == vendor_id)).first()
    if name is None:
        reason = f"vendor {hex32(vendor_id)} is not in the catalog"
        return Identification(vendor_id, product_code, revision_no, "none", reason, None, (), ())
    near = connection.execute(
        SUMMARY.where(devices.c.vendor_id == vendor_id, devices.c.variant == 1, devices.c.product_code.is_not(None))
        .order_by(None)
        .order_by(sa.func.abs(devices.c.product_code - product_code), devices.c.product_code, devices.c.revision_no)
        .limit(_NEAREST)
    ).all()
    reason = f"vendor {hex32(vendor_id)} ({name[0]}) is known, its product {hex32(product_code)} is not"
    candidates = tuple(summary(row) for row in near)
    return Identification(vendor_id, product_code, revision_no, "vendor", reason, None, (), candidates)


def device_sources_of(connection: sa.Connection, device_id: int) -> tuple[DeviceSource, ...]:
    """Documents and lines that carry a description."""
    rows = connection.execute(
        sa.select(
            sources.c.member,
            sources.c.location,
            device_sources.c.line,
            device_sources.c.group_type,
            source_vendors.c.file_version,
            sources.c.status,
        )
        .join(sources, sources.c.id == device_sources.c.source_id)
        .outerjoin(
            source_vendors,
            (source_vendors.c.source_id == sources.c.id) & (source_vendors.c.position == device_sources.c.section),
        )
        .where(device_sources.c.device_id == device_id)
        .order_by(sources.c.member, device_sources.c.line)
    )
    return tuple(DeviceSource(*row) for row in rows)


def find_device(connection: sa.Connection, identity: Identity) -> tuple[int, FoundDevice]:
    """Row number and summary of a description. Raises :class:`NotFound` with what to do."""
    condition = [devices.c.vendor_id == identity.vendor_id, devices.c.product_code == identity.product_code]
    if identity.revision_no is not None:
        condition.append(devices.c.revision_no == identity.revision_no)
    rows = connection.execute(SUMMARY.where(*condition)).all()
    if not rows:
        raise NotFound(f"{identity} is not in the catalog; see: esicatalog identify {identity_words(identity)}")
    wanted = identity.variant or 1
    chosen = identity.revision_no if identity.revision_no is not None else _latest(rows)
    for row in rows:
        if row.revision_no == chosen and row.variant == wanted:
            return row.id, summary(row)
    raise NotFound(f"{identity} has no variant {wanted}")


def _latest(rows: Sequence[Any]) -> int | None:
    """The highest revision that no other description of the vendor hides; the highest when all are hidden."""
    revisions: list[int | None] = [row.revision_no for row in rows if not row.hidden] or [rows[-1].revision_no]
    return revisions[-1]


def identity_words(identity: Identity) -> str:
    """The identity as arguments of ``esicatalog identify``."""
    numbers = (identity.vendor_id, identity.product_code, identity.revision_no)
    return " ".join(f"0x{number:x}" for number in numbers if number is not None)
