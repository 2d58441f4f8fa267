"""Views: the identity beside every row, for SQL by hand and for Datasette; and the full-text index.

Views and full text hold nothing of their own: they are dropped and made anew whenever the schema changes.
"""

from typing import NamedTuple

import sqlalchemy as sa

from esicatalog.catalog.document_status import FAILED, RECOVERED, STORED
from esicatalog.catalog.schema import metadata
from esicatalog.model.base_types import TYPE_NAMES
from esicatalog.model.cia402 import CIA402, DRIVE_MODES
from esicatalog.model.drive_modes import accepted_verdicts
from esicatalog.model.revisions import BECKHOFF

FULL_TEXT = "device_search"
TOKENIZER = "unicode61 remove_diacritics 2"
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
    if dialect != "sqlite":
        digits_text = f"to_hex({expression})"
        return f"'0x' || lpad({digits_text}, greatest({digits}, length({digits_text})), '0')"
    return f"CASE WHEN {expression} IS NOT NULL THEN printf('0x%0{digits}x', {expression}) END"


def mapped_subindex(entry: str) -> str:
    """SQL for the subindex that a PDO entry maps: 0 where it has none, NULL where it cannot be read.

    As :func:`esicatalog.model.pdo_facts.mapped` tells it; ``entry`` names its row of ``pdo_entries``.
    """
    return (
        f'CASE WHEN {entry}.subindex IS NULL AND {entry}.spelling LIKE \'%"subindex":"%\' '
        f'AND {entry}.spelling NOT LIKE \'%"subindex":""%\' THEN NULL ELSE coalesce({entry}.subindex, 0) END'
    )


def image_is_known(facts: str) -> str:
    """SQL for whether it is known all that a device exchanges without a choice; ``facts`` names its device_facts.

    As :attr:`esicatalog.model.process_data.ProcessData.image_is_known` tells it.
    """
    return f"{facts}.output_bytes IS NOT NULL AND {facts}.input_bytes IS NOT NULL"


def vendor_name(device: str, vendor: str) -> str:
    """SQL for the name under which the vendor of a device is shown; they name its rows of devices and vendors.

    Several makers may use one vendor id: a device whose documents name another one is shown under that name.
    """
    return f"coalesce({device}.own_vendor_name, {vendor}.name)"


def _integer(expression: str) -> str:
    """SQL for an integer that a view computes: without a type, SQLite would never find it equal to a text.

    Columns of tables have a type, of expressions only CAST has. Datasette filters by texts.
    """
    return f"CAST({expression} AS BIGINT)"


def _flag(condition: str) -> str:
    """SQL for a truth value that a view computes."""
    return _integer(f"CASE WHEN {condition} THEN 1 ELSE 0 END")


def _columns(table: str, alias: str, *without: str) -> str:
    left_out = {"id", "device_id", "module_id", "position", "spelling", *without}
    return ", ".join(f"{alias}.{c.name}" for c in metadata.tables[table].columns if c.name not in left_out)


def _device_identity(dialect: str) -> str:
    return (
        "d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, "
        f"{hex_text('d.vendor_id', 8, dialect)} AS vendor_id_hex, "
        f"{hex_text('d.product_code', 8, dialect)} AS product_code_hex, "
        f"{hex_text('d.revision_no', 8, dialect)} AS revision_no_hex, {_revision_text(dialect)} AS revision_text, "
        f"d.hidden, {vendor_name('d', 'v')} AS vendor, d.type AS device_type, d.name AS device_name"
    )


def _revision_text(dialect: str) -> str:
    """SQL for :func:`esicatalog.model.revisions.revision_text`."""
    variant, revision = "(d.revision_no & 65535)", "(d.revision_no >> 16)"
    return (
        f"CASE WHEN d.vendor_id = {BECKHOFF} AND d.revision_no IS NOT NULL THEN "
        f"CASE WHEN {variant} <> 0 THEN {_dashed(variant, dialect)} ELSE '' END || {_dashed(revision, dialect)} END"
    )


def _dashed(expression: str, dialect: str) -> str:
    if dialect != "sqlite":
        digits_text = f"CAST({expression} AS TEXT)"
        return f"'-' || lpad({digits_text}, greatest(4, length({digits_text})), '0')"
    return f"printf('-%04d', {expression})"


def _byte_bit(bits: str) -> str:
    # shifted, not divided: there are databases whose integers divide into fractions
    return f"CAST({bits} >> 3 AS TEXT) || '.' || CAST({bits} & 7 AS TEXT)"


def _number(bound: str) -> str:
    """SQL for a bound that is an integer or a real; a real type for both would round 64-bit integers."""
    return f"CAST(coalesce(CAST(z.{bound}_int AS NUMERIC), CAST(z.{bound}_real AS NUMERIC)) AS NUMERIC)"


def _signed(data_type: str, otherwise: str) -> str:
    """SQL for the signedness of what a type name means by itself: 1, 0, or NULL where it is no integer.

    ``otherwise`` is SQL for what counts where nobody knows the name. Texts and arrays, which have a length, are no
    integers.
    """
    known: dict[str, list[str]] = {"1": [], "0": [], "NULL": []}
    for name, base in TYPE_NAMES.items():
        known[{"int": "1", "uint": "0"}.get(base.kind, "NULL")].append(f"'{name}'")
    name = f"upper(trim({data_type}))"
    cases = [f"WHEN {name} IN ({', '.join(names)}) THEN {value}" for value, names in known.items()]
    with_length = f"WHEN {name} LIKE '%(%' OR {name} LIKE '%[%' THEN NULL"
    return f"CASE {' '.join(cases)} {with_length} ELSE {otherwise} END"


def _module_identity(dialect: str) -> str:
    return (
        "m.id AS module_id, m.vendor_id, m.module_ident, "
        f"{hex_text('m.vendor_id', 8, dialect)} AS vendor_id_hex, "
        f"{hex_text('m.module_ident', 8, dialect)} AS module_ident_hex, "
        "v.name AS vendor, m.type AS module_type, m.name AS module_name"
    )


_SOURCES = _integer("(SELECT count(DISTINCT x.source_id) FROM device_sources x WHERE x.device_id = d.id)")
"""SQL for the number of documents that carry a device; one may carry its description twice."""

_DEVICES = "FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id"
_MODULES = "FROM modules m LEFT JOIN vendors v ON v.vendor_id = m.vendor_id"


def views(dialect: str) -> list[View]:
    """All views in SQL of SQLite or, for any other dialect, of PostgreSQL."""
    return [
        _overview(dialect),
        *_owner_views("device", dialect),
        *_owner_views("module", dialect),
        *_capabilities(dialect),
        *_problems(dialect),
    ]


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
        _pdo_entries_view(kind, identity, source, dialect),
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
                "One row per OpMode element of a device, with the SYNC signals that AssignActivate asks for; a device "
                "with dc_time_loop_control_only generates none of them.",
                f"SELECT {identity}, {hex_text('c.assign_activate', 4, dialect)} AS assign_activate_hex, "
                f"{_columns('dc_modes', 'c')}, d.dc_time_loop_control_only, "
                f"{_flag('c.position = d.default_op_mode')} AS is_default, "
                f"c.id AS dc_mode_id, c.position {source} JOIN dc_modes c ON c.device_id = d.id",
            )
        )
    return found


def _pdo_entries_view(kind: str, identity: str, source: str, dialect: str) -> View:
    """Entries with their place and with what the object dictionary says about the object that they map."""
    alias = kind[0]
    place = (
        f"p.image_sm, {_flag('p.image_sm IS NOT NULL')} AS assigned_by_default, "
        f"e.image_bit_offset, {_byte_bit('e.image_bit_offset')} AS image_byte_bit, "
        if kind == "device"
        else ""
    )

    def described(expression: str) -> str:
        # a subquery a column: counting and grouping then costs nothing for columns that nobody reads
        return (
            f"(SELECT {expression} FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id "
            "JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id "
            f"WHERE q.{kind}_id = {alias}.id AND e.entry_index <> 0 AND o.object_index = e.entry_index "
            f"AND z.subindex = {mapped_subindex('e')} ORDER BY q.position, l.position LIMIT 1)"
        )

    # The entry counts before the object that it maps, as in exports; what a gap says is nothing (ESI-FACTS section 9).
    by_object = described(_signed("z.base_type", "NULL"))
    signed = f"CASE WHEN e.entry_index <> 0 THEN {_signed('e.data_type', by_object)} END"
    # Where the whole PDO has no size the sum of its entries is no number that a query can hold.
    before = (
        "CASE WHEN p.bit_size IS NOT NULL THEN (SELECT coalesce(sum(b.bit_length), 0) FROM pdo_entries b "
        "WHERE b.pdo_id = e.pdo_id AND b.position < e.position AND b.bit_length > 0) END"
    )
    return View(
        f"{kind}_pdo_entries",
        f"One row per Entry element of a {kind}'s own PDOs, padding included, OSFac not expanded.",
        f"SELECT {identity}, p.direction, p.pdo_index, {hex_text('p.pdo_index', 4, dialect)} AS pdo_index_hex, "
        f"p.name AS pdo_name, p.sm, {place}"
        f"{hex_text('e.entry_index', 4, dialect)} AS entry_index_hex, "
        f"{_columns('pdo_entries', 'e', 'pdo_id', 'image_bit_offset')}, "
        f"{_integer(signed)} AS signed, "
        f"{described('o.name')} AS object_name, {described('z.name')} AS object_entry_name, "
        f"{described(hex_text('z.unit', 8, dialect))} AS unit_hex, "
        f"{described(_number('min'))} AS minimum, "
        f"{described(_number('max'))} AS maximum, "
        f"{_integer(before)} AS bit_offset_in_pdo, "
        f"p.id AS pdo_id, p.position AS pdo_position, e.position {source} "
        f"JOIN pdos p ON p.{kind}_id = {alias}.id JOIN pdo_entries e ON e.pdo_id = p.id",
    )


def _capabilities(dialect: str) -> list[View]:
    identity = _device_identity(dialect)
    module = f"{hex_text('m.module_ident', 8, dialect)} AS module_ident_hex"
    previous = f"coalesce({_previous('AND o.type = n.type ')}, {_previous('')})"
    changed = (
        "CASE WHEN r.previous_id IS NULL THEN 0 "
        "WHEN coalesce(f.image_signature, '') <> coalesce(b.image_signature, '') THEN 1 "
        f"WHEN {image_is_known('f')} AND {image_is_known('b')} THEN 0 END"
    )
    same_pdo_set = (
        "CASE WHEN f.pdo_signature = g.pdo_signature THEN 1 "
        "WHEN coalesce(f.pdo_signature, g.pdo_signature) IS NOT NULL THEN 0 END"
    )
    return [
        View(
            "device_drive_modes",
            "One row per drive mode and axis of a device: verdict, best evidence, recipe. What the file says, not "
            "what the drive does.",
            f"SELECT {identity}, {module}, {hex_text('m.rx_pdo_index', 4, dialect)} AS rx_pdo_index_hex, "
            f"{_columns('drive_modes', 'm')}, m.position {_DEVICES} JOIN drive_modes m ON m.device_id = d.id",
        ),
        View(
            "device_mode_evidence",
            "One row per finding about a drive mode, for and against.",
            f"SELECT {identity}, {module}, {hex_text('m.object_index', 4, dialect)} AS object_index_hex, "
            f"{hex_text('m.pdo_index', 4, dialect)} AS pdo_index_hex, "
            f"{_columns('mode_evidence', 'm')}, m.position {_DEVICES} JOIN mode_evidence m ON m.device_id = d.id",
        ),
        View(
            "device_capabilities",
            "One row per device description with what no single element says: sizes, SYNC support, cycle, FSoE.",
            f"SELECT {identity}, {_columns('device_facts', 'f')} {_DEVICES} JOIN device_facts f ON f.device_id = d.id",
        ),
        View(
            "device_revisions",
            "Preferred descriptions of each product by revision; layout_changed compares the default process image "
            "with the next lower revision, of the same type where there is one; NULL where both are the same as far as "
            "they are described, and that is not all.",
            f"SELECT {identity}, r.previous_id, {_integer(changed)} AS layout_changed, "
            "f.output_bytes, f.input_bytes, f.image_signature "
            f"FROM (SELECT n.id, {_integer(previous)} AS previous_id "
            "FROM devices n WHERE n.variant = 1 AND n.vendor_id IS NOT NULL AND n.product_code IS NOT NULL) r "
            "JOIN devices d ON d.id = r.id LEFT JOIN vendors v ON v.vendor_id = d.vendor_id "
            "JOIN device_facts f ON f.device_id = d.id LEFT JOIN device_facts b ON b.device_id = r.previous_id",
        ),
        View(
            "same_process_image_layout",
            "Descriptions with other, preferred ones (a variant with that of its own identity, too) whose default "
            "process images have the same layout: the same entries at the same places, of equal and known lengths. "
            "Similar is not the same: never take one for the other by this alone, revisions can be power ratings.",
            f"SELECT {identity}, o.id AS other_device_id, "
            f"{hex_text('o.vendor_id', 8, dialect)} AS other_vendor_id_hex, "
            f"{hex_text('o.product_code', 8, dialect)} AS other_product_code_hex, "
            f"{hex_text('o.revision_no', 8, dialect)} AS other_revision_no_hex, o.type AS other_type, "
            f"{_integer(same_pdo_set)} AS same_pdo_set, f.output_bytes, "
            f"f.input_bytes {_DEVICES} JOIN device_facts f ON f.device_id = d.id "
            "JOIN device_facts g ON g.image_signature = f.image_signature JOIN devices o ON o.id = g.device_id "
            f"WHERE o.id <> d.id AND o.variant = 1 AND {image_is_known('f')}",
        ),
        View(
            "drive_modes_by_vendor",
            "Mode matrix: how many visible devices of a vendor run each CiA 402 mode by verdict yes or likely; "
            "makers who share a vendor id have a row each.",
            f"SELECT d.vendor_id, {vendor_name('d', 'v')} AS vendor, {_integer('count(DISTINCT d.id)')} AS drives, "
            + ", ".join(f"{_integer(_devices_with(mode))} AS {mode.lower()}" for mode in DRIVE_MODES)
            + f" {_DEVICES} JOIN drive_modes m ON m.device_id = d.id AND m.kind = '{CIA402}' "
            f"WHERE d.variant = 1 AND d.hidden = {'0' if dialect == 'sqlite' else 'false'} "
            f"GROUP BY d.vendor_id, {vendor_name('d', 'v')}",
        ),
    ]


def _devices_with(mode: str) -> str:
    verdicts = ", ".join(f"'{word}'" for word in accepted_verdicts())
    return f"count(DISTINCT CASE WHEN m.mode = '{mode}' AND m.verdict IN ({verdicts}) THEN d.id END)"


def _previous(condition: str) -> str:
    """SQL for the next lower revision of ``n``; a window over all devices would be computed for every single one."""
    return (
        "(SELECT o.id FROM devices o WHERE o.vendor_id = n.vendor_id AND o.product_code = n.product_code "
        f"{condition}AND o.variant = 1 AND o.revision_no < n.revision_no ORDER BY o.revision_no DESC LIMIT 1)"
    )


def _overview(dialect: str) -> View:
    def count(table: str, condition: str = "") -> str:
        return _integer(f"(SELECT count(*) FROM {table} x WHERE x.device_id = d.id{condition})")

    profile_no = (
        "(SELECT min(coalesce(p.profile_no, c.profile_no)) FROM profiles p "
        "LEFT JOIN profile_channels c ON c.profile_id = p.id WHERE p.device_id = d.id)"
    )

    return View(
        "device_overview",
        "One row per device description with what it has: protocols, SYNC signals, PDOs, slots, sources.",
        f"SELECT {_device_identity(dialect)}, d.group_type, d.physics, d.e_bus_current_ma, d.invisible, "
        f"{_integer(profile_no)} AS profile_no, "
        "b.coe, b.eoe, b.foe, b.soe, b.aoe, b.voe, b.coe_complete_access, b.coe_sdo_info, "
        f"{count('dc_modes')} AS dc_modes, {_flag('f.supports_sync0')} AS sync0, {_flag('f.supports_sync1')} AS sync1, "
        f"""{count("pdos", " AND x.direction = 'RxPdo'")} AS rx_pdos, """
        f"""{count("pdos", " AND x.direction = 'TxPdo'")} AS tx_pdos, """
        f"{count('slots')} AS slots, {count('device_modules')} AS modules, {_SOURCES} AS sources "
        f"{_DEVICES} JOIN device_facts f ON f.device_id = d.id LEFT JOIN mailboxes b ON b.device_id = d.id",
    )


def _problems(dialect: str) -> list[View]:
    return [
        View(
            "ingest_problems",
            "Documents that failed, were skipped or needed recovery, and every error found in the others.",
            "SELECT s.id AS source_id, s.member, s.status, 'document' AS rule, "
            f"CASE s.status WHEN '{FAILED}' THEN 'E' WHEN '{RECOVERED}' THEN 'W' ELSE 'I' END AS severity, "
            f"s.message, {_integer('0')} AS line FROM sources s WHERE s.status <> '{STORED}' "
            "UNION ALL SELECT s.id, s.member, s.status, f.rule, f.severity, f.message, f.line "
            "FROM findings f JOIN sources s ON s.id = f.source_id WHERE f.severity = 'E'",
        ),
        View(
            "conflicting_descriptions",
            "Identities with more than one description, with how they differ in size and where they come from.",
            f"SELECT {_device_identity(dialect)}, d.element_count, d.recovered, d.file_version, "
            "(SELECT min(s.member) FROM device_sources x JOIN sources s ON s.id = x.source_id "
            "WHERE x.device_id = d.id) AS first_source, "
            f"{_SOURCES} AS sources "
            f"{_DEVICES} WHERE d.product_code IS NOT NULL AND d.revision_no IS NOT NULL AND EXISTS ("
            "SELECT 1 FROM devices o WHERE o.vendor_id = d.vendor_id AND o.product_code = d.product_code "
            "AND o.revision_no = d.revision_no AND o.variant <> d.variant)",
        ),
    ]


def create_views(connection: sa.Connection) -> None:
    """Make all views and the full-text table, which the caller fills."""
    for view in views(connection.dialect.name):
        connection.execute(sa.text(f"CREATE VIEW {view.name} AS {view.select}"))
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql(
            f"CREATE VIRTUAL TABLE {FULL_TEXT} USING fts5(vendor, type, name, identity, words, "
            f"tokenize = '{TOKENIZER}')"
        )
    else:
        connection.exec_driver_sql(
            f"CREATE TABLE {FULL_TEXT} (device_id BIGINT PRIMARY KEY, named TEXT, identity TEXT, words TEXT)"
        )


def own_schema(connection: sa.Connection) -> str | None:
    """The schema of the database in which a catalog lies, or a new one would; None where the user has none."""
    if connection.dialect.name == "sqlite":
        return sa.inspect(connection).default_schema_name
    return connection.execute(sa.select(sa.func.current_schema())).scalar()


def drop_views(connection: sa.Connection) -> None:
    """Drop the catalog's views, which no version has named otherwise, and the full-text table.

    Views that others have made beside them stay, and so does what has these names in another schema of the database.
    """
    own = connection.dialect.identifier_preparer.quote(str(own_schema(connection)))
    for view in views(connection.dialect.name):
        connection.exec_driver_sql(f"DROP VIEW IF EXISTS {own}.{view.name}")
    connection.exec_driver_sql(f"DROP TABLE IF EXISTS {own}.{FULL_TEXT}")
