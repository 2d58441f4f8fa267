"""Views: the identity beside every row, for SQL by hand and for Datasette; and the full-text index.

Views and full text hold nothing of their own: they are dropped and made anew whenever the schema changes.
"""

from typing import NamedTuple

import sqlalchemy as sa

from esicatalog.catalog.schema import metadata

FULL_TEXT = "device_search"
FULL_TEXT_DOC = (
    "Full-text index over vendors, types, names and identities in every notation; words match from the start."
)


class View(NamedTuple):
    """A view: name, what one row is, and the SELECT."""

    name: str
    doc: str
    select: str


def hex_text(expression: str, digits: int, dialect: str) -> str:
    """SQL for a number as ``0x…`` text with at least ``digits`` digits; NULL stays NULL."""
    if dialect == "postgresql":
        return f"'0x' || lpad(to_hex({expression}), {digits}, '0')"
    return f"CASE WHEN {expression} IS NOT NULL THEN printf('0x%0{digits}x', {expression}) END"


def _columns(table: str, alias: str, *without: str) -> str:
    left_out = {"id", "device_id", "module_id", "position", "spelling", *without}
    return ", ".join(f"{alias}.{c.name}" for c in metadata.tables[table].columns if c.name not in left_out)


def _device_identity(dialect: str) -> str:
    return (
        "d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, "
        f"{hex_text('d.vendor_id', 8, dialect)} AS vendor_id_hex, "
        f"{hex_text('d.product_code', 8, dialect)} AS product_code_hex, "
        f"{hex_text('d.revision_no', 8, dialect)} AS revision_no_hex, "
        "v.name AS vendor, d.type AS device_type, d.name AS device_name"
    )


def _module_identity(dialect: str) -> str:
    return (
        "m.id AS module_id, m.vendor_id, m.module_ident, "
        f"{hex_text('m.vendor_id', 8, dialect)} AS vendor_id_hex, "
        f"{hex_text('m.module_ident', 8, dialect)} AS module_ident_hex, "
        "v.name AS vendor, m.type AS module_type, m.name AS module_name"
    )


_DEVICES = "FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id"
_MODULES = "FROM modules m LEFT JOIN vendors v ON v.vendor_id = m.vendor_id"


def views(dialect: str) -> list[View]:
    """All views in SQL of the dialect (``sqlite`` or ``postgresql``)."""
    return [_overview(dialect), *_owner_views("device", dialect), *_owner_views("module", dialect), *_problems(dialect)]


def _owner_views(kind: str, dialect: str) -> list[View]:
    alias = kind[0]
    identity = (_device_identity if kind == "device" else _module_identity)(dialect)
    source = _DEVICES if kind == "device" else _MODULES
    found = [
        View(
            f"{kind}_objects",
            f"One row per Object element of a {kind}'s dictionaries, inline or referenced.",
            f"SELECT {identity}, p.position AS profile, {hex_text('o.object_index', 4, dialect)} AS object_index_hex, "
            f"{_columns('objects', 'o', 'content_hash')}, o.id AS object_id, l.position {source} "
            f"JOIN profiles p ON p.{kind}_id = {alias}.id "
            "JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id JOIN objects o ON o.id = l.object_id",
        ),
        View(
            f"{kind}_object_entries",
            f"One row per subindex of a {kind}'s objects, resolved: type, size, access, PDO mapping, values.",
            f"SELECT {identity}, o.object_index, {hex_text('o.object_index', 4, dialect)} AS object_index_hex, "
            f"o.name AS object_name, {_columns('object_entries', 'e', 'object_id')}, o.id AS object_id, "
            f"l.position AS object_position, e.position {source} "
            f"JOIN profiles p ON p.{kind}_id = {alias}.id "
            "JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id JOIN objects o ON o.id = l.object_id "
            "JOIN object_entries e ON e.object_id = o.id",
        ),
        View(
            f"{kind}_pdo_entries",
            f"One row per Entry element of a {kind}'s own PDOs, padding included, OSFac not expanded.",
            f"SELECT {identity}, p.direction, p.pdo_index, {hex_text('p.pdo_index', 4, dialect)} AS pdo_index_hex, "
            "p.name AS pdo_name, p.sm, "
            f"{hex_text('e.entry_index', 4, dialect)} AS entry_index_hex, {_columns('pdo_entries', 'e', 'pdo_id')}, "
            "(SELECT coalesce(sum(b.bit_length), 0) FROM pdo_entries b "
            "WHERE b.pdo_id = e.pdo_id AND b.position < e.position) AS bit_offset_in_pdo, "
            f"p.id AS pdo_id, p.position AS pdo_position, e.position {source} "
            f"JOIN pdos p ON p.{kind}_id = {alias}.id JOIN pdo_entries e ON e.pdo_id = p.id",
        ),
        View(
            f"{kind}_initcmds",
            f"One row per InitCmd element of a {kind}, all mailbox protocols; several transitions stay one row.",
            f"SELECT {identity}, {hex_text('i.object_index', 4, dialect)} AS object_index_hex, "
            f"{_columns('initcmds', 'i')}, i.id AS initcmd_id, i.position {source} "
            f"JOIN initcmds i ON i.{kind}_id = {alias}.id",
        ),
    ]
    if kind == "device":
        found.append(
            View(
                "device_dc_modes",
                "One row per OpMode element of a device, with the SYNC signals that AssignActivate means.",
                f"SELECT {identity}, {hex_text('c.assign_activate', 4, dialect)} AS assign_activate_hex, "
                f"{_columns('dc_modes', 'c')}, "
                "CASE WHEN c.position = d.default_op_mode THEN 1 ELSE 0 END AS is_default, "
                f"c.id AS dc_mode_id, c.position {source} JOIN dc_modes c ON c.device_id = d.id",
            )
        )
    return found


def _overview(dialect: str) -> View:
    def count(table: str, condition: str = "") -> str:
        return f"(SELECT count(*) FROM {table} x WHERE x.device_id = d.id{condition})"

    return View(
        "device_overview",
        "One row per device description with what it has: protocols, SYNC signals, PDOs, slots, sources.",
        f"SELECT {_device_identity(dialect)}, d.group_type, d.physics, d.e_bus_current_ma, d.invisible, "
        "(SELECT min(coalesce(p.profile_no, c.profile_no)) FROM profiles p "
        "LEFT JOIN profile_channels c ON c.profile_id = p.id WHERE p.device_id = d.id) AS profile_no, "
        "b.coe, b.eoe, b.foe, b.soe, b.aoe, b.voe, b.coe_complete_access, b.coe_sdo_info, "
        f"{count('dc_modes')} AS dc_modes, "
        "(SELECT max(CASE WHEN x.sync0 THEN 1 ELSE 0 END) FROM dc_modes x WHERE x.device_id = d.id) AS sync0, "
        "(SELECT max(CASE WHEN x.sync1 THEN 1 ELSE 0 END) FROM dc_modes x WHERE x.device_id = d.id) AS sync1, "
        f"""{count("pdos", " AND x.direction = 'RxPdo'")} AS rx_pdos, """
        f"""{count("pdos", " AND x.direction = 'TxPdo'")} AS tx_pdos, """
        f"{count('slots')} AS slots, {count('device_modules')} AS modules, {count('device_sources')} AS sources "
        f"{_DEVICES} LEFT JOIN mailboxes b ON b.device_id = d.id",
    )


def _problems(dialect: str) -> list[View]:
    return [
        View(
            "ingest_problems",
            "Documents that failed, were skipped or needed recovery, and every error found in the others.",
            "SELECT s.id AS source_id, s.member, s.status, 'document' AS rule, "
            "CASE s.status WHEN 'failed' THEN 'E' WHEN 'recovered' THEN 'W' ELSE 'I' END AS severity, "
            "s.message, 0 AS line FROM sources s WHERE s.status <> 'stored' "
            "UNION ALL SELECT s.id, s.member, s.status, f.rule, f.severity, f.message, f.line "
            "FROM findings f JOIN sources s ON s.id = f.source_id WHERE f.severity = 'E'",
        ),
        View(
            "conflicting_descriptions",
            "Identities with more than one description, with how they differ in size and where they come from.",
            f"SELECT {_device_identity(dialect)}, d.element_count, d.recovered, d.file_version, "
            "(SELECT min(s.member) FROM device_sources x JOIN sources s ON s.id = x.source_id "
            "WHERE x.device_id = d.id) AS first_source, "
            "(SELECT count(*) FROM device_sources x WHERE x.device_id = d.id) AS sources "
            f"{_DEVICES} WHERE d.product_code IS NOT NULL AND d.revision_no IS NOT NULL AND EXISTS ("
            "SELECT 1 FROM devices o WHERE o.vendor_id = d.vendor_id AND o.product_code = d.product_code "
            "AND o.revision_no = d.revision_no AND o.variant <> d.variant)",
        ),
    ]


def create_views(connection: sa.Connection) -> None:
    """Make all views and, on SQLite, the full-text table anew; the caller fills it."""
    drop_views(connection)
    for view in views(connection.dialect.name):
        connection.exec_driver_sql(f"CREATE VIEW {view.name} AS {view.select}")
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql(
            f"CREATE VIRTUAL TABLE {FULL_TEXT} USING fts5(vendor, type, name, identity, words, "
            "tokenize = 'unicode61 remove_diacritics 2')"
        )


def drop_views(connection: sa.Connection) -> None:
    """Drop all views, those of older versions too, and the full-text table."""
    for name in sa.inspect(connection).get_view_names():
        connection.exec_driver_sql(f"DROP VIEW IF EXISTS {name}")
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql(f"DROP TABLE IF EXISTS {FULL_TEXT}")
