"""Revision numbers: as their vendors print them, and which one is meant where none is named."""

from collections.abc import Iterable

BECKHOFF = 0x00000002


def revision_text(vendor_id: int | None, revision_no: int | None) -> str | None:
    """The revision in the vendor's own style, None where none is known.

    Beckhoff prints the high word as description revision (0x00100000 is ``-0016``) behind the low word, the variant
    of the terminal, unless that is zero (0x00110014 is ``-0020-0017``): ESI-FACTS section 3.1. Other vendors count in
    ways of their own.
    """
    if vendor_id != BECKHOFF or revision_no is None:
        return None
    variant, revision = revision_no & 0xFFFF, revision_no >> 16
    return (f"-{variant:04d}" if variant else "") + f"-{revision:04d}"


def latest_revision(described: Iterable[tuple[int | None, bool]]) -> int | None:
    """The highest of the revisions of a product that its vendor does not hide; the highest when all are hidden.

    ``described`` are RevisionNo and whether another description hides it (HideType). None where no RevisionNo is given.
    """
    revisions = list(described)
    visible = [number for number, is_hidden in revisions if not is_hidden] or [number for number, _ in revisions]
    return max((number for number in visible if number is not None), default=None)
