"""Write what follows from the code: datasette-metadata.yml, docs/schema.md, docs/cli.md, migrations/new_catalog.sql.

And tests/catalogs/derived.txt, but for what has to have a new schema version: that it names, with exit code 1.

python docs/generate.py            writes the files
python docs/generate.py --check    names the files that are not up to date; exit code 1 when there are any
"""

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import sqlalchemy as sa
import yaml
from canned_queries import CANNED_QUERIES
from derived import DERIVED, derived, forgotten_version

from esicatalog.catalog import database
from esicatalog.catalog.schema import metadata
from esicatalog.catalog.views import FULL_TEXT, FULL_TEXT_DOC, create_views, views
from esicatalog.cli.main import cli
from esicatalog.model.cia402 import DRIVE_MODES

ROOT = Path(__file__).parent.parent
YAML_WIDTH = 110
HELP_WIDTH = 100
GENERATED = "Written by docs/generate.py"

DESCRIPTION_HTML = """\
<p>What vendors' EtherCAT slave information (ESI) files declare, as tables: identities, PDOs, object dictionaries, DC
modes, start-up commands, modules. An entry says what a file declares, not what a device does.</p>
<p><a href="-/esi/">Device pages</a>: search by name, identity or ability, read a scan, compare revisions.</p>
"""

DATABASE_HTML = """\
<p><a href="-/esi/">Device pages</a>: search by name, identity or ability, read a scan, compare revisions.</p>
<p>For tables and SQL, start with the canned queries or with the view <code>device_overview</code>; both list devices.
The search box of <code>devices</code> and of the views named device_… finds words of the device, inner parts of words
(1100 in EL1100) and identities in any notation (0x044c2c52, 0x44c2c52, #x044c2c52, 72100946).</p>
<p>Every canned query about devices returns <code>device_id</code>, the key of <code>devices</code> and of all views
named device_…; the query about ingest returns <code>source_id</code>, the key of <code>sources</code>, the one about
vendors <code>vendor_id</code>. A parameter that cannot be read is an error that says why. Columns named …_hex hold the
number as text for filters; in SQL, parse_hex('0x60FF') reads a number and hex0x(24831, 4) writes one.</p>
"""

LICENSE = "the descriptions belong to the vendors of the devices"

IDENTITY_FACETS = ["vendor"]
SEARCH_DEVICES = {"fts_table": FULL_TEXT, "fts_pk": "device_id"}
SEARCH_DOC = "The search box finds words of the device (vendor, type, name, identity), not of the row."

TABLE_OPTIONS: dict[str, dict[str, Any]] = {
    "alembic_version": {"description": "Version of the schema.", "hidden": True},
    "archives": {"label_column": "location", "hidden": True},
    "catalog_state": {"hidden": True},
    "data_types": {"label_column": "name"},
    "dc_modes": {"label_column": "name", "facets": ["sync0", "sync1"]},
    "device_modules": {"hidden": True},
    "device_names": {"facets": ["kind", "lcid"]},
    "devices": {
        "label_column": "type",
        "facets": ["vendor_id", "group_type", "physics"],
        "fts_table": FULL_TEXT,
        "fts_pk": "id",
    },
    "type_sets": {"hidden": True},
    "type_set_data_types": {"hidden": True},
    "device_facts": {"facets": ["dc_needed", "supports_sync0", "supports_sync1", "fsoe"]},
    "dictionary_objects": {"hidden": True},
    "drive_modes": {"facets": ["mode", "verdict", "kind"]},
    "findings": {"facets": ["rule", "severity"]},
    "groups": {"label_column": "type"},
    "images": {"size": 20},
    "initcmds": {"facets": ["protocol"]},
    "mode_evidence": {"facets": ["mode", "rank", "polarity"]},
    "mailboxes": {"facets": ["coe", "eoe", "foe", "soe", "aoe", "voe"]},
    "modules": {"label_column": "type", "facets": ["vendor_id"]},
    "object_entries": {"label_column": "name"},
    "objects": {"label_column": "name", "sort": "object_index"},
    "pdos": {"label_column": "name", "facets": ["direction"]},
    "profiles": {"label_column": "profile_no", "facets": ["profile_no"]},
    "slots": {"label_column": "name"},
    "source_groups": {"hidden": True},
    "sources": {"label_column": "member", "sort": "member", "facets": ["status", "root"]},
    "sync_managers": {"facets": ["usage"]},
    "unmapped": {"facets": ["path"]},
    "vendor_extensions": {"facets": ["field"]},
    "vendor_names": {"sort_desc": "document_count"},
    "vendors": {"label_column": "name", "sort": "name"},
    FULL_TEXT: {"description": FULL_TEXT_DOC, "hidden": True},
    "conflicting_descriptions": {**SEARCH_DEVICES, "facets": IDENTITY_FACETS},
    "device_dc_modes": {**SEARCH_DEVICES, "facets": [*IDENTITY_FACETS, "sync0", "sync1"]},
    "device_initcmds": {**SEARCH_DEVICES, "facets": [*IDENTITY_FACETS, "protocol"]},
    "device_object_entries": SEARCH_DEVICES,
    "device_objects": SEARCH_DEVICES,
    "device_overview": {**SEARCH_DEVICES, "facets": [*IDENTITY_FACETS, "profile_no", "group_type"]},
    "device_capabilities": {**SEARCH_DEVICES, "facets": [*IDENTITY_FACETS, "supports_sync0", "supports_sync1", "fsoe"]},
    "device_drive_modes": {**SEARCH_DEVICES, "facets": [*IDENTITY_FACETS, "mode", "verdict"]},
    "device_mode_evidence": {**SEARCH_DEVICES, "facets": ["mode", "rank", "polarity", "conflict"]},
    "device_pdo_entries": SEARCH_DEVICES,
    "device_revisions": {**SEARCH_DEVICES, "facets": [*IDENTITY_FACETS, "layout_changed"]},
    "drive_modes_by_vendor": {"sort_desc": "drives"},
    "same_process_image_layout": SEARCH_DEVICES,
    "ingest_problems": {"facets": ["status", "rule", "severity"]},
}
"""What Datasette should know about a table or view beyond its comments."""

VIEW_TABLES = {
    "conflicting_descriptions": ("devices",),
    "device_capabilities": ("device_facts",),
    "device_mode_evidence": ("mode_evidence",),
    "device_overview": ("devices", "mailboxes", "profiles", "dc_modes"),
    "device_pdo_entries": ("pdo_entries", "pdos", "object_entries"),
    "device_revisions": ("device_facts",),
    "drive_modes_by_vendor": ("devices",),
    "module_pdo_entries": ("pdo_entries", "pdos", "object_entries"),
    "same_process_image_layout": ("device_facts",),
    "ingest_problems": ("sources", "findings"),
}
"""Tables whose comments explain the columns of a view that is not named after its table."""

RELATED_TABLES = ("pdos", "devices", "modules", "objects", "vendors")

_MAPPED_OBJECT = "Name of the mapped object in the object dictionary"

VIEW_COLUMNS = {
    **{mode.lower(): f"Devices with {mode}" for mode in DRIVE_MODES},
    "bit_offset_in_pdo": "Bits of the PDO's entries before this one",
    "assigned_by_default": "1 = the PDO is in the default process image",
    "dc_modes": "Number of OpModes",
    "device_id": "Key in devices",
    "device_overview.sync0": "1 = some OpMode generates SYNC0",
    "device_overview.sync1": "1 = some OpMode generates SYNC1",
    "device_pdo_entries.object_name": _MAPPED_OBJECT,
    "drives": "Devices with any finding about a drive mode",
    "first_source": "First document that carries it",
    "image_byte_bit": "Place in the default process image of the SyncManager: byte.bit",
    "is_default": "1 = the device's default OpMode",
    "layout_changed": "1 = another default process image than the next lower revision (of the same type if any) has, "
    "NULL = not known",
    "maximum": "Maximum that the object dictionary gives",
    "minimum": "Minimum that the object dictionary gives",
    "module_id": "Key in modules",
    "module_pdo_entries.object_name": _MAPPED_OBJECT,
    "module_type": "Type text of the module",
    "modules": "Number of modules that its slots can reach",
    "object_entry_name": "Name of the mapped subindex in the object dictionary",
    "object_id": "Key in objects",
    "object_name": "Name of the object in the object dictionary",
    "object_position": "Position of the object in its dictionary, from 0",
    "other_device_id": "Key of the other device in devices",
    "other_product_code": "Product code of the other device",
    "other_revision_no": "Revision of the other device",
    "other_vendor_id": "Vendor id of the other device",
    "other_type": "Type of the other device",
    "pdo_position": "Position of the PDO, from 0",
    "position": "Position in document order, from 0",
    "previous_id": "Key in devices of the revision that it is compared with",
    "profile": "Position of the profile whose dictionary holds the object, from 0",
    "revision_text": "Revision in the vendor's own style, where one is known (Beckhoff: -0016)",
    "rx_pdos": "Number of its own RxPdo",
    "same_pdo_set": "1 = all PDOs of the devices themselves have the same layout, assigned or not; NULL = neither has "
    "any (those of modules are not compared)",
    "signed": "1 = two's complement, 0 = unsigned, NULL = no integer; by the entry's DataType, else by the object",
    "slots": "Number of Slot elements",
    "source_id": "Key in sources",
    "sources": "Number of documents that carry it",
    "tx_pdos": "Number of its own TxPdo",
    "vendor": "Vendor's name",
}
"""Columns that only views have, and those that views, or one that is named, use for something of their own."""

KEYS = """\
## How rows are keyed by vendor, product and revision

`vendors.vendor_id` is the number that the ETG assigned. `devices` holds one row per distinct description, unique by
(`vendor_id`, `product_code`, `revision_no`, `variant`): variant 1 is the preferred description of an identity, 2 and
higher are differing ones, none is overwritten. A code that the file does not give is NULL, never 0: all descriptions of
a product without revision are variants together; those without product code are only with others of their type.
`devices.id` is a row number that differs between catalogs; keep the identity, not the row number.

| what | table | how it hangs on vendor, product, revision | view with the identity beside every row |
|---|---|---|---|
| vendors | `vendors` | `vendor_id` is the key | `device_overview` |
| devices | `devices` | `vendor_id`, `product_code`, `revision_no`, `variant` | `device_overview` |
| objects | `objects`, `object_entries` | `devices.id` = `profiles.device_id`; `profiles.dictionary_id` = \
`dictionary_objects.dictionary_id`; `dictionary_objects.object_id` = `objects.id` = `object_entries.object_id` | \
`device_objects`, `device_object_entries` |
| pdo_entries | `pdo_entries` | `devices.id` = `pdos.device_id`; `pdos.id` = `pdo_entries.pdo_id` | \
`device_pdo_entries` |
| initcmds | `initcmds` | `devices.id` = `initcmds.device_id` | `device_initcmds` |
| dc_modes | `dc_modes` | `devices.id` = `dc_modes.device_id` | `device_dc_modes` |

Objects and dictionaries are stored once per distinct content and shared. What modules for slots bring hangs on
`module_id` instead of `device_id` in the same tables, and is in the views named `module_…`; `device_modules` says
which modules the slots of a device can reach. So "does the device map 0x60FF" asks `pdos` by `device_id` and, through
`device_modules`, by `module_id`.
"""


class _BlockDumper(yaml.SafeDumper):
    """Writes texts of several lines as blocks, so that SQL stays readable, and lists that recur each time."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def _represent_text(dumper: yaml.SafeDumper, text: str) -> yaml.ScalarNode:
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style="|" if "\n" in text else None)


_BlockDumper.add_representer(str, _represent_text)


def view_columns() -> dict[str, dict[str, str]]:
    """The comment of every column of every view, in the order of the view."""
    engine = sa.create_engine("sqlite://")
    with engine.begin() as connection:
        metadata.create_all(connection)
        create_views(connection)
        inspector = sa.inspect(connection)
        return {
            view.name: {
                column["name"]: _view_column_comment(view.name, column["name"])
                for column in inspector.get_columns(view.name)
            }
            for view in views("sqlite")
        }


def _view_column_comment(view: str, column: str) -> str:
    if column.endswith("_hex"):
        return f"{_view_column_comment(view, column.removesuffix('_hex'))}, as 0x… text"
    for name in (f"{view}.{column}", column):
        if name in VIEW_COLUMNS:
            return VIEW_COLUMNS[name]
    for table in VIEW_TABLES.get(view, (view.partition("_")[2],)):
        if column in metadata.tables[table].columns:
            return _comment(metadata.tables[table].columns[column])
    for table in RELATED_TABLES:
        for name in (column, column.removeprefix(f"{table[:-1]}_")):
            if name in metadata.tables[table].columns:
                comment = _comment(metadata.tables[table].columns[name])
                return comment if name == column else f"{comment} of the {table[:-1]}"
    if column.endswith("_id"):
        return f"Key in {column.removesuffix('_id')}s"
    raise KeyError(f"explain the column {column} of the view {view} in VIEW_COLUMNS")


def _comment(item: Any) -> str:
    return str(item.comment or "")


def datasette_metadata() -> str:
    """The text of datasette-metadata.yml."""
    tables: dict[str, dict[str, Any]] = {}
    for table in metadata.sorted_tables:
        columns = {str(column.name): _comment(column) for column in table.columns}
        tables[str(table.name)] = {"description": _comment(table), "columns": columns}
    for view, columns in zip(views("sqlite"), view_columns().values(), strict=True):
        tables[view.name] = {"description": view.doc, "columns": columns}
    for name, options in TABLE_OPTIONS.items():
        table = tables.setdefault(name, {})
        table.update(options)
        if "fts_table" in options:
            table["description"] += f" {SEARCH_DOC}"
    document = {
        "title": "EtherCAT device catalog",
        "description_html": DESCRIPTION_HTML,
        "license": LICENSE,
        "databases": {
            "catalog": {
                "description_html": DATABASE_HTML,
                "queries": {name: {**query, "hide_sql": True} for name, query in CANNED_QUERIES.items()},
                "tables": dict(sorted(tables.items())),
            }
        },
    }
    text = yaml.dump(document, Dumper=_BlockDumper, sort_keys=False, allow_unicode=True, width=YAML_WIDTH)
    return f"# {GENERATED}: change that, not this.\n{text}"


def schema_reference() -> str:
    """The text of docs/schema.md."""
    return "\n".join(_schema_lines())


def _schema_lines() -> Iterator[str]:
    yield f"<!-- {GENERATED}. -->"
    yield "# Schema of the catalog"
    yield ""
    yield "Types: *boolean* is 0 or 1 on SQLite and BOOLEAN on PostgreSQL; *integer* is BIGINT on PostgreSQL."
    yield "Most tables keep in `spelling` how the vendor wrote values that are not spelled canonically."
    yield ""
    yield from KEYS.splitlines()
    yield ""
    yield "## Views"
    for view, columns in zip(views("sqlite"), view_columns().values(), strict=True):
        yield from ("", f"### {view.name}", "", view.doc, "", "| column | meaning |", "|---|---|")
        yield from (f"| {name} | {_cell(comment)} |" for name, comment in columns.items())
    yield from (
        "",
        "## Full-text index",
        "",
        f"`{FULL_TEXT}`: {FULL_TEXT_DOC} On SQLite it is an FTS5 table whose rowid is `devices.id`, on PostgreSQL a "
        "plain table of the same words.",
    )
    yield from ("", "## Tables")
    for table in sorted(metadata.tables.values(), key=lambda table: table.name):
        yield from ("", f"### {table.name}", "", _comment(table), "", "| column | type | meaning |", "|---|---|---|")
        yield from (
            f"| {column.name} | {_type_name(column)} | {_cell(_comment(column))}{_key_words(column)} |"
            for column in table.columns
        )
        unique = [item for item in table.constraints if isinstance(item, sa.UniqueConstraint)]
        for names in sorted(", ".join(column.name for column in item.columns) for item in unique):
            yield from ("", f"Unique: {names}.")
    yield ""


def _type_name(column: sa.Column[Any]) -> str:
    kinds = ((sa.Boolean, "boolean"), (sa.Integer, "integer"), (sa.Float, "real"), (sa.LargeBinary, "blob"))
    return next((name for kind, name in kinds if isinstance(column.type, kind)), "text")


def _key_words(column: sa.Column[Any]) -> str:
    words = [f"→ {key.target_fullname}" for key in column.foreign_keys]
    if column.primary_key:
        words.append("primary key")
    return f" ({', '.join(words)})" if words else ""


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")


def cli_reference() -> str:
    """The text of docs/cli.md: the help of every command."""
    lines = [f"<!-- {GENERATED}. -->", "# Commands", "", *_help_block(cli, None)]
    return "\n".join([*lines, *_commands(cli, click.Context(cli, info_name="esicatalog"), "##"), ""])


def _commands(group: click.Group, context: click.Context, heading: str) -> Iterator[str]:
    """The help of the commands of a group, those of groups in it below them."""
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        assert command is not None
        words = context.command_path.removeprefix("esicatalog").strip()
        yield from ("", f"{heading} {words} {name}".replace("  ", " "), "", *_help_block(command, context))
        if isinstance(command, click.Group):
            yield from _commands(command, click.Context(command, info_name=name, parent=context), f"{heading}#")


def _help_block(command: click.Command, parent: click.Context | None) -> list[str]:
    options = dict(cli.context_settings, terminal_width=HELP_WIDTH, max_content_width=HELP_WIDTH)
    context = click.Context(command, info_name=command.name if parent else "esicatalog", parent=parent, **options)
    return ["```", *command.get_help(context).splitlines(), "```"]


def new_catalog() -> str:
    """SQL of a new catalog: what the migrations make of an empty SQLite file."""
    engine = sa.create_engine("sqlite://", poolclass=sa.StaticPool)
    database.upgrade(engine)
    with engine.connect() as connection:
        made = connection.exec_driver_sql(
            "SELECT sql FROM sqlite_master WHERE sql IS NOT NULL AND name NOT LIKE ? ORDER BY rowid",
            (f"{FULL_TEXT}_%",),  # the full-text table makes its own
        )
        version = f"INSERT INTO alembic_version (version_num) VALUES ('{database.schema_version(connection)}')"
        statements = ["\n".join(map(str.rstrip, text.strip().splitlines())) for text in [*made.scalars(), version]]
    return f"-- {GENERATED}\n{database.STATEMENT_END.join(statements)}\n"


FILES = {
    "datasette-metadata.yml": datasette_metadata,
    "docs/schema.md": schema_reference,
    "docs/cli.md": cli_reference,
    f"migrations/{database.NEW_CATALOG}": new_catalog,
    DERIVED: derived,
}


def stale_files() -> dict[Path, str]:
    """The files that are not up to date, with the text they should have."""
    wanted = {ROOT / name: write() for name, write in FILES.items()}
    return {
        path: text for path, text in wanted.items() if not path.exists() or path.read_text(encoding="utf-8") != text
    }


def main() -> int:
    """Write or check; returns the exit code."""
    stale = stale_files()
    held = ROOT / DERIVED
    if held in stale and held.exists():
        forgotten = forgotten_version(held.read_text(encoding="utf-8"), stale[held])
        if forgotten is not None:
            print(forgotten, file=sys.stderr)
            return 1
    if sys.argv[1:] == ["--check"]:
        for path in stale:
            print(f"{path.relative_to(ROOT)} is not up to date; run: python docs/generate.py", file=sys.stderr)
        return 1 if stale else 0
    for path, text in stale.items():
        path.write_text(text, encoding="utf-8")
        print(f"wrote {path.relative_to(ROOT)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
