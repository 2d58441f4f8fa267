"""What lint says of a catalog: the findings stored at ingest, and the rules across documents on the rows of devices."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog.document_status import FAILED
from esicatalog.catalog.schema import device_sources, devices, findings, hidden_revisions, source_vendors, sources
from esicatalog.catalog.spelled_vendors import OF_SECTION
from esicatalog.esi.notes import REFUSED, Finding
from esicatalog.esi.records.device import HideType
from esicatalog.lint.library import DeviceFact, device_element_path, lint_library
from esicatalog.lint.registry import ERROR, Rule
from esicatalog.lint.report import DocumentFinding


def stored_findings(connection: sa.Connection, rules: Iterable[Rule]) -> Iterator[DocumentFinding]:
    """Findings of the chosen rules, by document and line; those across documents come last."""
    chosen = tuple(rules)
    ids = {rule.id for rule in chosen}
    names = _names(connection)
    query = (
        sa.select(*(findings.c[name] for name in ("source_id", *Finding.__struct_fields__)))
        .join_from(findings, sources)
        .order_by(sources.c.member, findings.c.line, sources.c.location, findings.c.id)
    )
    if REFUSED in ids:
        yield from _refused(connection, names)
    for source_id, *values in connection.execute(query):
        finding = Finding(*values)
        if finding.rule in ids:
            yield DocumentFinding(names[source_id], finding)
    yield from lint_library(_facts(connection, names), chosen)


def unchecked_documents(connection: sa.Connection, rules: Iterable[Rule]) -> list[str]:
    """The documents that no rule has looked at and no finding of the chosen rules tells, each with the reason.

    Those whose bytes an ingest did not get, for want of permission for instance: what they hold is unknown. Where
    L01 is not chosen, those that it refused too.
    """
    is_told = any(rule.id == REFUSED for rule in rules)
    rows = connection.execute(_failed(_is_unread()) if is_told else _failed()).all()
    names = _names(connection) if rows else {}
    return [f"{names[source_id]}: {message}" for source_id, message in rows]


def _refused(connection: sa.Connection, names: Mapping[int, str]) -> Iterator[DocumentFinding]:
    for source_id, message in connection.execute(_failed(~_is_unread())):
        yield DocumentFinding(names[source_id], Finding(REFUSED, ERROR, message, 0))


def _failed(*conditions: sa.ColumnElement[bool]) -> sa.Select[Any]:
    """Row number and reason of the failed documents that fulfil the conditions."""
    reason = sa.func.coalesce(sources.c.message, "cannot be read")
    query = sa.select(sources.c.id, reason).where(sources.c.status == FAILED, *conditions)
    return query.order_by(sources.c.member, sources.c.location)


def _is_unread() -> sa.ColumnElement[bool]:
    """Whether nobody saw the bytes of a document."""
    return sources.c.sha256.is_(None)


def _names(connection: sa.Connection) -> dict[int, str]:
    """How each document is called: by its member, by its location where several folders have such a member."""
    rows = connection.execute(sa.select(sources.c.id, sources.c.member, sources.c.location)).all()
    counts = Counter(row.member for row in rows)
    return {row.id: row.member if counts[row.member] == 1 else row.location for row in rows}


def _facts(connection: sa.Connection, names: Mapping[int, str]) -> list[DeviceFact]:
    """Every Device element of every document, as the rules across documents see it."""
    hide_types: dict[int, list[HideType]] = defaultdict(list)
    named = hidden_revisions.c
    for device_id, product_code, revision_no in connection.execute(
        sa.select(named.device_id, named.product_code, named.revision_no).order_by(named.device_id, named.position)
    ):
        hide_types[device_id].append(HideType(product_code=product_code, revision_no=revision_no))
    rows = connection.execute(
        sa.select(
            devices,
            device_sources.c.source_id,
            device_sources.c.section,
            device_sources.c.position.label("number"),
            device_sources.c.line,
            sources.c.root,
            source_vendors.c.name.label("vendor_name"),
        )
        .join_from(device_sources, devices)
        .join(sources, sources.c.id == device_sources.c.source_id)
        .join(source_vendors, OF_SECTION)
        .order_by(sources.c.location, device_sources.c.section, device_sources.c.position)
    ).all()
    counts = Counter((row.source_id, row.section) for row in rows)
    sections = Counter(source_id for source_id, _ in counts)
    return [
        DeviceFact(
            names[row.source_id],
            row.line,
            device_element_path(
                row.root, row.section, sections[row.source_id], row.number, counts[row.source_id, row.section]
            ),
            row.vendor_id,
            row.vendor_name,
            row.product_code,
            row.revision_no,
            row.type,
            bytes.fromhex(row.content_hash),
            tuple(hide_types.get(row.id, ())),
        )
        for row in rows
    ]
