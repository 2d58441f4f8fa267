"""Neighbours of a description: other revisions of the product, and devices with the same process-image layout."""

from typing import Any

import msgspec
import sqlalchemy as sa

from esicatalog.catalog.devices import SUMMARY, summary
from esicatalog.catalog.results import FoundDevice
from esicatalog.catalog.schema import device_facts, devices
from esicatalog.catalog.views import image_is_known

IMAGE_IS_KNOWN = sa.literal_column(f"({image_is_known(device_facts.name)})", sa.Boolean)
"""Whether the default process image of a description is known in full."""


class Revision(msgspec.Struct, frozen=True):
    """A revision of a product, by one of its descriptions."""

    device: FoundDevice
    hidden: bool
    layout_changed: bool | None
    """The default process image differs from that of the next lower revision, of the same type if there is one.

    None where both are the same as far as they are described, and that is not all.
    """

    @property
    def layout_words(self) -> str:
        """The same as sheets and pages say it."""
        return {True: "layout changed", False: "", None: "layout not known"}[self.layout_changed]


def revisions_of(connection: sa.Connection, device_id: int, found: FoundDevice) -> tuple[Revision, ...]:
    """All revisions of a description's product, lowest first: its own one as it says, others as preferred ones say.

    None for devices without codes. The rule is that of the view ``device_revisions``, which has preferred ones only.
    """
    if found.vendor_id is None or found.product_code is None:
        return ()
    columns = devices.c
    other = sa.and_(columns.variant == 1, columns.revision_no.is_distinct_from(found.revision_no))
    rows = connection.execute(
        SUMMARY.add_columns(device_facts.c.image_signature, IMAGE_IS_KNOWN.label("image_is_known"))
        .join(device_facts, device_facts.c.device_id == columns.id)
        .where(
            columns.vendor_id == found.vendor_id,
            columns.product_code == found.product_code,
            sa.or_(columns.id == device_id, other),
        )
    )
    before: dict[str | None, Any] = {}
    """The next lower revision by type; under None that of any type."""
    revisions = []
    for row in rows:
        previous = before.get(row.type) or before.get(None)
        revisions.append(Revision(summary(row), bool(row.hidden), _changed(previous, row)))
        if row.revision_no is not None:
            before[row.type] = before[None] = row
    return tuple(revisions)


def _changed(previous: Any, row: Any) -> bool | None:
    if previous is None or previous.image_signature != row.image_signature:
        return previous is not None
    return False if previous.image_is_known and row.image_is_known else None


def same_layout(connection: sa.Connection, device_id: int) -> tuple[FoundDevice, ...]:
    """Other visible descriptions whose default process image has the same layout: similar, not a replacement.

    None where its length is not known: what is not described may differ.
    """
    facts = device_facts.c
    ours = sa.select(facts.image_signature).where(facts.device_id == device_id, IMAGE_IS_KNOWN)
    signature = connection.execute(ours).scalar()
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
