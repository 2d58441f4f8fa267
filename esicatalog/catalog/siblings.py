"""Neighbours of a description: other revisions of the product, and devices with the same process-image layout."""

import msgspec
import sqlalchemy as sa

from esicatalog.catalog.devices import SUMMARY, summary
from esicatalog.catalog.results import FoundDevice
from esicatalog.catalog.schema import device_facts, devices

_REVISIONS = sa.table("device_revisions", sa.column("device_id"), sa.column("layout_changed"))


class Revision(msgspec.Struct, frozen=True):
    """A revision of a product, by its preferred description."""

    device: FoundDevice
    hidden: bool
    layout_changed: bool
    """The default process image differs from that of the next lower revision, of the same type if there is one."""


def revisions_of(connection: sa.Connection, vendor_id: int | None, product_code: int | None) -> tuple[Revision, ...]:
    """All revisions of a product, lowest first; none for devices without codes."""
    if vendor_id is None or product_code is None:
        return ()
    rows = connection.execute(
        SUMMARY.add_columns(_REVISIONS.c.layout_changed)
        .join(_REVISIONS, _REVISIONS.c.device_id == devices.c.id)
        .where(devices.c.vendor_id == vendor_id, devices.c.product_code == product_code)
    )
    return tuple(Revision(summary(row), bool(row.hidden), bool(row.layout_changed)) for row in rows)


def same_layout(connection: sa.Connection, device_id: int) -> tuple[FoundDevice, ...]:
    """Other visible devices whose default process image has the same layout: similar, not a replacement."""
    facts = device_facts.c
    signature = connection.execute(sa.select(facts.image_signature).where(facts.device_id == device_id)).scalar()
    if signature is None:
        return ()
    rows = connection.execute(
        SUMMARY.join(device_facts, facts.device_id == devices.c.id).where(
            facts.image_signature == signature,
            devices.c.id != device_id,
            devices.c.variant == 1,
            devices.c.hidden == sa.false(),
        )
    )
    return tuple(map(summary, rows))
