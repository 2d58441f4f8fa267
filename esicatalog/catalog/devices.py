"""Single descriptions: by their identity as people write it, and where they come from."""

from collections.abc import Iterable
from typing import Any, NamedTuple

import sqlalchemy as sa

from esicatalog.catalog.results import FoundDevice
from esicatalog.catalog.schema import devices, slots, vendors
from esicatalog.catalog.views import vendor_name
from esicatalog.errors import NotFound
from esicatalog.identity import Identity
from esicatalog.model.revisions import latest_revision

ORDER = (
    devices.c.vendor_id.nulls_first(),
    devices.c.product_code.nulls_first(),
    devices.c.revision_no.nulls_first(),
    devices.c.type.nulls_first(),
    devices.c.variant,
)
"""The order of lists, which is that of the index ``ix_devices_listed``."""
VENDOR_NAME: sa.ColumnElement[str | None] = sa.literal_column(vendor_name(devices.name, vendors.name), sa.Text)
"""The name under which the vendor of a device is shown, given its row of vendors."""
SUMMARY = (
    sa.select(
        devices.c.id,
        devices.c.vendor_id,
        devices.c.product_code,
        devices.c.revision_no,
        devices.c.variant,
        devices.c.hidden,
        VENDOR_NAME.label("vendor"),
        devices.c.type,
        devices.c.name,
    )
    .outerjoin(vendors, vendors.c.vendor_id == devices.c.vendor_id)
    .order_by(*ORDER)
)
"""Descriptions as lists show them; :func:`summary` makes values of its rows."""
_LARGEST_ROW = 2**63 - 1
"""What databases can compare with a row number."""


def summary(row: Any, evidence: Iterable[str] = ()) -> FoundDevice:
    """A device in a list, from a row of the summary columns."""
    return FoundDevice(
        row.vendor_id,
        row.product_code,
        row.revision_no,
        row.variant,
        row.vendor,
        row.type,
        row.name,
        bool(row.hidden),
        tuple(evidence),
    )


class Descriptions(NamedTuple):
    """The description that an identity names, and all that there are of this vendor, product and revision."""

    number: int
    """Row number."""
    found: FoundDevice
    variants: tuple[tuple[int, FoundDevice], ...]
    """Row numbers and summaries, the preferred one first."""


def find_device(connection: sa.Connection, identity: Identity) -> Descriptions:
    """The description of an identity, among its variants. Raises :class:`NotFound`."""
    condition = [devices.c.vendor_id == identity.vendor_id, devices.c.product_code == identity.product_code]
    if identity.revision_no is not None:
        condition.append(devices.c.revision_no == identity.revision_no)
    elif identity.without_revision:
        condition.append(devices.c.revision_no.is_(None))
    rows = connection.execute(SUMMARY.where(*condition)).all()
    if not rows:
        raise NotFound(f"{identity} is not in the catalog", f"esicatalog identify {identity_words(identity)}")
    wanted = identity.variant if identity.variant is not None else 1
    chosen = latest_revision((row.revision_no, row.hidden) for row in rows)
    alike = sorted((row for row in rows if row.revision_no == chosen), key=lambda row: row.variant)
    variants = tuple((row.id, summary(row)) for row in alike)
    for number, found in variants:
        if found.variant == wanted:
            return Descriptions(number, found, variants)
    described = variants[0][1].identity_text
    last = f"its variants are @1 to @{len(variants)}" if len(variants) > 1 else "it has one description only"
    raise NotFound(f"{described} has no variant {wanted}; {last}")


def variants_with_slots(connection: sa.Connection, found: FoundDevice, variant_count: int) -> tuple[int, ...]:
    """Of several variants of the identity of a device, those that describe slots."""
    if variant_count == 1:
        return ()
    described = sa.exists().where(slots.c.device_id == devices.c.id)
    identity = (  # None becomes IS NULL, which an index serves everywhere
        devices.c.vendor_id == found.vendor_id,
        devices.c.product_code == found.product_code,
        devices.c.revision_no == found.revision_no,
    )
    query = sa.select(devices.c.variant).where(*identity, described).order_by(devices.c.variant)
    return tuple(connection.execute(query).scalars())


def device_of_row(connection: sa.Connection, number: int) -> FoundDevice:
    """Summary of the description with a row number of this catalog. Raises :class:`NotFound`."""
    is_possible = 0 < number <= _LARGEST_ROW
    row = connection.execute(SUMMARY.where(devices.c.id == number)).first() if is_possible else None
    if row is None:
        raise NotFound(f"the catalog has no device row {number}")
    return summary(row)


def devices_of_vendor(connection: sa.Connection, vendor_id: int) -> list[tuple[int, FoundDevice]]:
    """Row numbers and summaries of the preferred descriptions of all devices of a vendor, hidden ones too."""
    query = SUMMARY.where(devices.c.vendor_id == vendor_id, devices.c.variant == 1)
    return [(row.id, summary(row)) for row in connection.execute(query).all()]


def identity_words(identity: Identity) -> str:
    """The identity as arguments of ``esicatalog identify``."""
    numbers = (identity.vendor_id, identity.product_code, identity.revision_no)
    return " ".join(f"0x{number:x}" for number in numbers if number is not None)
