"""Verifying a catalog: database integrity, references, counts, variants, content hash."""

from typing import NamedTuple

import sqlalchemy as sa

from esicatalog.catalog import schema
from esicatalog.catalog.schema import devices
from esicatalog.catalog.settle import CONTENT_HASH, content_hash, read_state
from esicatalog.catalog.views import FULL_TEXT


class CheckResult(NamedTuple):
    """What was counted, what is wrong (empty = sound), and the recomputed content hash."""

    counts: dict[str, int]
    problems: list[str]
    content_hash: str


_COUNTED = (
    "sources",
    "vendors",
    "devices",
    "modules",
    "objects",
    "object_entries",
    "pdo_entries",
    "initcmds",
    "dc_modes",
)


def check_catalog(connection: sa.Connection) -> CheckResult:
    """Look at everything that can be verified from the rows alone."""
    problems: list[str] = []
    if connection.dialect.name == "sqlite":
        problems += [row[0] for row in connection.exec_driver_sql("PRAGMA integrity_check") if row[0] != "ok"]
        problems += [
            f"{table}: row {row} refers to a missing row of {parent}"
            for table, row, parent, _ in connection.exec_driver_sql("PRAGMA foreign_key_check")
        ]
    problems += _full_text_problems(connection)
    problems += _orphans(connection)
    problems += _variant_problems(connection)
    recomputed = content_hash(connection)
    stored = read_state(connection, CONTENT_HASH)
    if stored != recomputed:
        problems.append(
            f"stored content hash {stored} differs from the recomputed one; an ingest was cut short: repeat it"
        )
    counts = {
        name: connection.execute(sa.select(sa.func.count()).select_from(schema.metadata.tables[name])).scalar_one()
        for name in _COUNTED
    }
    return CheckResult(counts, problems, recomputed)


def _orphans(connection: sa.Connection) -> list[str]:
    links = schema.device_sources.c
    unowned = sa.select(sa.func.count()).select_from(devices).where(~sa.exists().where(links.device_id == devices.c.id))
    count = connection.execute(unowned).scalar_one()
    return [f"{count} device descriptions that no document carries"] if count else []


def _variant_problems(connection: sa.Connection) -> list[str]:
    columns = devices.c
    grouped = (
        sa.select(columns.vendor_id, columns.product_code, columns.revision_no)
        .where(columns.product_code.is_not(None), columns.revision_no.is_not(None))
        .group_by(columns.vendor_id, columns.product_code, columns.revision_no)
        .having(
            sa.or_(
                sa.func.min(columns.variant) != 1,
                sa.func.max(columns.variant) != sa.func.count(),
            )
        )
    )
    return [
        f"variants of {vendor}:{product}:{revision} are not numbered from 1"
        for vendor, product, revision in connection.execute(grouped)
    ]


def _full_text_problems(connection: sa.Connection) -> list[str]:
    indexed = connection.exec_driver_sql(f"SELECT count(*) FROM {FULL_TEXT}").scalar_one()
    held = connection.execute(sa.select(sa.func.count()).select_from(devices)).scalar_one()
    return [] if indexed == held else [f"full-text index holds {indexed} of {held} devices"]
