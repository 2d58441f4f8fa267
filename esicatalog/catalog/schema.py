"""Tables of the catalog, with a comment on every table and column.

Columns that come from records are taken from their declarations (:mod:`esicatalog.catalog.mapping`), so a new record
field is a new column; a migration creates it in existing catalogs.
"""

from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import types
from esicatalog.catalog.mapping import TABLE_RECORDS, codec

SCHEMA_VERSION = "0014"
"""Revision of the newest migration."""

metadata = sa.MetaData(
    naming_convention={
        "ix": "ix_%(table_name)s_%(column_0_N_name)s",
        "uq": "uq_%(table_name)s_%(column_0_N_name)s",
        "fk": "fk_%(table_name)s_%(column_0_N_name)s",
        "pk": "pk_%(table_name)s",
        "ck": "ck_%(table_name)s_%(constraint_name)s",
    }
)


def _integer(name: str, comment: str, *constraints: Any, **options: Any) -> sa.Column[Any]:
    return sa.Column(name, types.integer(), *constraints, comment=comment, **options)


def _text(name: str, comment: str, *constraints: Any, **options: Any) -> sa.Column[Any]:
    return sa.Column(name, types.text(), *constraints, comment=comment, **options)


def _boolean(name: str, comment: str, **options: Any) -> sa.Column[Any]:
    return sa.Column(name, types.boolean(), comment=comment, **options)


def parent_column(parent: str) -> str:
    """Name of the column that refers to a parent table: ``pdo_id`` for ``pdos``."""
    return {"diagnostics": "diagnostics_id"}.get(parent, f"{parent[:-1]}_id")


def _key(comment: str = "Row number; not stable between catalogs") -> sa.Column[Any]:
    return _integer("id", comment, primary_key=True, autoincrement=True)


def _reference(target: str, comment: str, **options: Any) -> sa.Column[Any]:
    table, column = target.split(".")
    name = options.pop("name", f"{table[:-3] + 'y' if table.endswith('ies') else table[:-1]}_{column}")
    return _integer(name, comment, sa.ForeignKey(target), **options)


def _recorded(table: str) -> list[sa.Column[Any]]:
    """Columns of the table's record type."""
    return [
        sa.Column(column.name, types.BY_KIND[column.kind](), comment=column.doc)
        for column in codec(TABLE_RECORDS[table]).columns
    ]


def _table(name: str, comment: str, *items: Any, **options: Any) -> sa.Table:
    return sa.Table(name, metadata, *items, comment=comment, sqlite_strict=True, **options)


def _owned(name: str, comment: str, *extra: sa.Column[Any], derived: tuple[sa.Column[Any], ...] = ()) -> sa.Table:
    """A table whose rows belong to exactly one device or module."""
    return _table(
        name,
        comment,
        _key(),
        _reference("devices.id", "Device description that the row belongs to; NULL for a module's", index=True),
        _reference("modules.id", "Module that the row belongs to; NULL for a device's", index=True),
        _integer("position", "Position in document order, from 0", nullable=False),
        *extra,
        *_recorded(name),
        *derived,
        sa.CheckConstraint("(device_id IS NULL) <> (module_id IS NULL)", name="one_owner"),
    )


def _part(name: str, parent: str, comment: str, *derived: sa.Column[Any], indexed: bool = True) -> sa.Table:
    """A table whose rows belong to a row of another table; ``indexed`` unless an index of its own begins with it."""
    return _table(
        name,
        comment,
        _key(),
        _reference(f"{parent}.id", "Row it belongs to", name=parent_column(parent), nullable=False, index=indexed),
        _integer("position", "Position in document order, from 0", nullable=False),
        *_recorded(name),
        *derived,
    )


catalog_state = _table(
    "catalog_state",
    "State of the catalog as a whole: content hash, loads under way.",
    _text("key", "What it is", primary_key=True),
    _text("value", "Its value", nullable=False),
)

archives = _table(
    "archives",
    "Zip archives that were ingested completely; an unchanged one is skipped by its sha256 without opening it.",
    _key(),
    _text("location", "Absolute path", nullable=False, unique=True),
    _text("sha256", "SHA-256 of the archive", nullable=False),
    _text("reader_version", "Version of esicatalog that read it", nullable=False),
)

sources = _table(
    "sources",
    "Documents that were given to ingest: stored, skipped and failed ones.",
    _key(),
    _text("location", "Absolute path; archive!member for archives", nullable=False, unique=True),
    _text("member", "Path relative to the folder given to ingest; archive.zip!member for archives", nullable=False),
    _reference("archives.id", "Archive it lies in; NULL for a file on disk", index=True),
    _text("status", "stored, recovered (stored after repair), skipped or failed", nullable=False, index=True),
    _text("message", "Why it was recovered, skipped or failed"),
    _text("sha256", "SHA-256 of the document", index=True),
    _integer("byte_count", "Size in bytes"),
    _text("reader_version", "Version of esicatalog that read it", nullable=False),
    _text("root", "Root element: EtherCATInfo, EtherCATInfoList, EtherCATModule, EtherCATDict or EtherCATDiag"),
    _text("encoding", "Encoding it was read with"),
    _integer("device_count", "Device elements in the document", nullable=False),
    _integer("module_count", "Module elements in the document", nullable=False),
    _reference("dictionaries.id", "Dictionary of an EtherCATDict document", index=True),
    _reference("diagnostics.id", "Diagnosis texts of an EtherCATDiag document", name="diagnostics_id", index=True),
    _boolean(
        "is_whole",
        "1 when it and all that it pulls in were read whole, 0 when elements may be lost (broken markup); NULL when it "
        "was not stored, or by a version that did not tell",
    ),
)

source_references = _table(
    "source_references",
    "Which documents a document pulls in: dictionaries, diagnosis texts, module lists.",
    _key(),
    _reference("sources.id", "Document that refers", nullable=False, index=True),
    _integer("position", "Position in document order, from 0", nullable=False),
    _text("kind", "DictionaryFile, DiagFile or InfoReference", nullable=False),
    _text("reference", "As the vendor wrote it", nullable=False),
    _text("found_location", "Where it was found, relative to the folder or archive; NULL when it was not"),
    _text("sha256", "SHA-256 of what was found"),
)

vendors = _table(
    "vendors",
    "Vendors by the id that the ETG assigned; the key of everything is vendor, product, revision.",
    _integer("vendor_id", "Vendor id", primary_key=True, autoincrement=False),
    _text("name", "Name to show: the one that most documents use"),
    _text("image_sha256", "Image, key in images"),
)

vendor_names = _table(
    "vendor_names",
    "Every spelling and language of a vendor's name, with the number of documents that use it.",
    _key(),
    _reference("vendors.vendor_id", "Vendor", name="vendor_id", nullable=False, index=True),
    _integer("lcid", "Windows locale id; NULL when the document gives none"),
    _text("name", "Name", nullable=False),
    _integer("document_count", "Documents that use it", nullable=False),
)

source_vendors = _table(
    "source_vendors",
    "Vendor section of each document: vendor as written, file version, schema version.",
    _key(),
    _reference("sources.id", "Document", nullable=False, index=True),
    _integer("position", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    _text("schema_version", "Schema version that the author used"),
    _text("info_references", "Module documents it refers to, as JSON"),
    _text("shared_pdos", "Shared Pdo elements of files before schema 1.2, as JSON"),
    _boolean("has_vendor", "1 when the element Vendor is present", nullable=False),
    *_recorded("source_vendors"),
)

groups = _table(
    "groups",
    "Groups of devices, keyed by vendor and type; a group that documents describe differently has several rows.",
    _key(),
    _integer("vendor_id", "Vendor; NULL when the document gives none", index=True),
    _text("content_hash", "Digest of vendor id and content", nullable=False, unique=True),
    *_recorded("groups"),
)

source_groups = _table(
    "source_groups",
    "Which document defines which group.",
    _key(),
    _reference("sources.id", "Document", nullable=False, index=True),
    _reference("groups.id", "Group", nullable=False, index=True),
    _integer("section", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    _integer("position", "Position in document order, from 0", nullable=False),
)

devices = _table(
    "devices",
    "Device descriptions: one row per distinct content, keyed by vendor_id, product_code, revision_no and variant.",
    _key(),
    _reference("vendors.vendor_id", "Vendor id; NULL when the document gives none", name="vendor_id"),
    _integer("variant", "1 = the preferred description of this identity, 2 … = differing ones", nullable=False),
    _text(
        "content_hash",
        "Digest of the content: vendor id, device, dictionaries, reachable modules",
        nullable=False,
        unique=True,
    ),
    *_recorded("devices"),
    _integer("default_op_mode", "Position of the default OpMode: the first that newer tools do not ignore"),
    _integer("element_count", "Objects plus PDO entries, reachable modules included", nullable=False),
    _boolean(
        "hidden",
        "1 when another description of the vendor supersedes it (HideType)",
        nullable=False,
        server_default="0",
    ),
    _boolean("recovered", "1 when every document that carries it needed recovery", nullable=False),
    _integer("file_version", "Highest FileVersion of the documents that carry it"),
    _text("group_type", "Group that the description names in its first document"),
    _text(
        "own_vendor_name",
        "Name of its vendor in its own documents, where these give quite another one than vendors has for the id: "
        "several makers use it; else NULL",
    ),
    sa.UniqueConstraint("vendor_id", "product_code", "revision_no", "variant"),
    sa.Index("ix_devices_listed", "vendor_id", "product_code", "revision_no", "type", "variant", "hidden"),
)

device_names = _table(
    "device_names",
    "Names, comments and links of devices and modules in all languages.",
    _key(),
    _reference("devices.id", "Device description; NULL for a module", index=True),
    _reference("modules.id", "Module; NULL for a device", index=True),
    _text("kind", "name, comment or url", nullable=False),
    _integer("position", "Position in document order, from 0", nullable=False),
    _integer("lcid", "Windows locale id; NULL when the document gives none"),
    _text("text", "The text", nullable=False),
)

device_sources = _table(
    "device_sources",
    "Which documents and lines carry a device description.",
    _key(),
    _reference("devices.id", "Device description", nullable=False, index=True),
    _reference("sources.id", "Document", nullable=False, index=True),
    _integer("section", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    _integer("position", "Position among the Device elements, from 0", nullable=False),
    _integer("line", "Line of the Device element", nullable=False),
    _text("group_type", "Group that the document puts it in"),
)

modules = _table(
    "modules",
    "Modules for slots, one row per distinct content and vendor.",
    _key(),
    _reference("vendors.vendor_id", "Vendor id; NULL when the document gives none", name="vendor_id", index=True),
    _text("content_hash", "Digest of the content: vendor id, module, dictionaries", nullable=False, unique=True),
    *_recorded("modules"),
    _integer("element_count", "Objects plus PDO entries", nullable=False),
    sa.Index("ix_modules_ident", "vendor_id", "module_ident"),
)

module_sources = _table(
    "module_sources",
    "Which documents and lines carry a module.",
    _key(),
    _reference("modules.id", "Module", nullable=False, index=True),
    _reference("sources.id", "Document", nullable=False, index=True),
    _integer("section", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    _integer("position", "Position among the Module elements, from 0", nullable=False),
    _integer("line", "Line of the Module element", nullable=False),
)

device_modules = _table(
    "device_modules",
    "Modules that the slots of a device can reach.",
    _reference("devices.id", "Device description", primary_key=True),
    _integer("position", "Position in document order, from 0", primary_key=True),
    _reference("modules.id", "Module", nullable=False, index=True),
    sqlite_with_rowid=False,
)

hidden_revisions = _owned("hidden_revisions", "HideType: revisions that a description supersedes.")
profiles = _owned(
    "profiles",
    "Profiles of devices and modules: profile numbers, channels, dictionary, diagnosis texts.",
    _reference("dictionaries.id", "Object dictionary"),
    _reference("diagnostics.id", "Diagnosis texts", name="diagnostics_id", index=True),
)
sa.Index("ix_profiles_dictionary", profiles.c.dictionary_id, profiles.c.device_id, profiles.c.module_id)
profile_channels = _part("profile_channels", "profiles", "Profiles of single channels (ChannelInfo).")
fmmus = _owned("fmmus", "FMMUs; the position is the FMMU's number.")
sync_managers = _owned("sync_managers", "SyncManagers; the position is the SyncManager's number.")
sync_units = _owned("sync_units", "Sync units (Su); the position is what Pdo@Su refers to.")
pdos = _owned(
    "pdos",
    "PDOs of devices and modules.",
    _text("direction", "RxPdo (master to slave), TxPdo (slave to master) or SafetyParaMapping", nullable=False),
    derived=(_integer("image_sm", "SyncManager of the PDO in the device's default process image; NULL = not in it"),),
)
pdo_entries = _part(
    "pdo_entries",
    "pdos",
    "Entries of PDOs, padding included, OSFac not expanded.",
    _integer(
        "image_bit_offset", "Bits before it in its SyncManager's default process image; NULL = not in it or not known"
    ),
)
_MAPPED = ("entry_index", "subindex", "bit_length", "pdo_id")
sa.Index("ix_pdo_entries_mapping", *(pdo_entries.c[name] for name in _MAPPED))
pdo_exclusions = _part("pdo_exclusions", "pdos", "PDOs that may not be assigned together, as declared (one-sided).")
mailboxes = _owned("mailboxes", "Mailbox protocols and their options, one row a device or module.")
initcmds = _owned(
    "initcmds",
    "Start-up commands (InitCmd) of all mailbox protocols; one row may serve several transitions.",
    _text("protocol", "CoE, SoE, EoE or AoE", nullable=False),
)
dc_modes = _owned("dc_modes", "OpModes of the distributed clocks with the SYNC signals that AssignActivate asks for.")
slots = _owned("slots", "Slot elements; with max_instances above 1 one stands for several slots.")
slot_modules = _part("slot_modules", "slots", "Modules that fit a slot, by ModuleIdent.")
slot_module_classes = _part("slot_module_classes", "slots", "Modules that fit a slot, by ModuleClass.")
eeproms = _owned("eeproms", "Eeprom elements: size, ConfigData, bootstrap mailbox, further categories.")

device_facts = _table(
    "device_facts",
    "What devices imply and no single element says: sizes, SYNC support, cycle, layout, safety evidence.",
    _reference("devices.id", "Device description", primary_key=True, autoincrement=False),
    *_recorded("device_facts"),
    sa.Index("ix_device_facts_image_signature", "image_signature"),
)
drive_modes = _table(
    "drive_modes",
    "Which drive modes a device can run, as far as its description tells: verdict and recipe per axis and mode.",
    _reference("devices.id", "Device description", primary_key=True),
    _integer("position", "Order: by axis and mode, from 0", primary_key=True),
    *_recorded("drive_modes"),
    sa.Index("ix_drive_modes_kind_mode", "kind", "mode", "verdict"),
    sqlite_with_rowid=False,
)
mode_evidence = _table(
    "mode_evidence",
    "Every single finding about a drive mode, for and against; docs/drive-modes.md explains the ranks.",
    _reference("devices.id", "Device description", primary_key=True),
    _integer("position", "Order of finding, from 0", primary_key=True),
    *_recorded("mode_evidence"),
    sqlite_with_rowid=False,
)

dictionaries = _table(
    "dictionaries",
    "Object dictionaries, each distinct one once; profiles and EtherCATDict documents point to them.",
    _key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
    _reference("type_sets.id", "Data types that it declares", nullable=False, index=True),
    *_recorded("dictionaries"),
    _integer("object_count", "Number of objects", nullable=False),
)
diagnostics = _table(
    "diagnostics",
    "Diagnosis texts of a device or document as a whole, each distinct set once.",
    _key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
    *_recorded("diagnostics"),
)
data_types = _table(
    "data_types",
    "Data types as declared, each distinct one once; a name is valid within one dictionary only.",
    _key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
    *_recorded("data_types"),
)
diag_messages = _part("diag_messages", "diagnostics", "Diagnosis texts by text id, as object 0x10F3 refers to them.")
sub_items = _part("sub_items", "data_types", "Members of composite data types.")
enum_values = _part("enum_values", "data_types", "Values of enumerations.")
type_sets = _table(
    "type_sets",
    "Sets of data types that dictionaries declare, each distinct one once; type_set_data_types lists them.",
    _key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
)
type_set_data_types = _table(
    "type_set_data_types",
    "Which data types a type set holds.",
    _reference("type_sets.id", "Type set", primary_key=True),
    _integer("position", "Position in document order, from 0", primary_key=True),
    _reference("data_types.id", "Data type", nullable=False, index=True),
    sqlite_with_rowid=False,
)
objects = _table(
    "objects",
    "Objects, each distinct one (with the data types it uses) once; dictionary_objects says where they occur.",
    _key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of object and types"),
    *_recorded("objects"),
    _integer("object_code", "CoE object code: 7 VAR, 8 ARRAY, 9 RECORD", nullable=False),
    sa.Index("ix_objects_object_index", "object_index"),
)
object_entries = _part(
    "object_entries", "objects", "Subindices of objects: type, size, access, PDO mapping, values.", indexed=False
)
sa.Index("ix_object_entries_subindex", object_entries.c.object_id, object_entries.c.subindex)
dictionary_objects = _table(
    "dictionary_objects",
    "Which objects a dictionary holds.",
    _reference("dictionaries.id", "Dictionary", primary_key=True),
    _integer("position", "Position in document order, from 0", primary_key=True),
    _reference("objects.id", "Object", nullable=False, index=True),
    sqlite_with_rowid=False,
)

images = _table(
    "images",
    "Images of vendors, groups, devices, modules and slots, each distinct one once.",
    _text("sha256", "SHA-256 of the bytes", primary_key=True),
    sa.Column("data", types.blob(), comment="Image file, usually BMP; NULL when the document's text is malformed"),
    _text("malformed", "Text of the document when it is not hexBinary"),
)
vendor_extensions = _table(
    "vendor_extensions",
    "Vendor-specific XML as it stands, by owner.",
    _key(),
    _reference("devices.id", "Device description; NULL for a module", index=True),
    _reference("modules.id", "Module; NULL for a device", index=True),
    _text("owner_table", "Table whose row carries it; empty = the device or module itself", nullable=False),
    _integer("owner_position", "Position of that row", nullable=False),
    _text("field", "Which element: info_vendor_specific is Info/VendorSpecific", nullable=False),
    _text("xml", "Canonical XML", nullable=False),
)
unmapped = _table(
    "unmapped",
    "Values that no column holds: unknown or repeated elements and attributes, with their place.",
    _key(),
    _reference("devices.id", "Device description", index=True),
    _reference("modules.id", "Module", index=True),
    _reference("sources.id", "Document, for values outside of devices and modules", index=True),
    _integer("position", "Order of occurrence, from 0", nullable=False),
    _text("path", "Path of the element or attribute below its owner", nullable=False),
    _text("value", "Its text", nullable=False),
)
findings = _table(
    "findings",
    "What was noticed in the documents: broken markup, malformed values, unknown elements, missing references.",
    _key(),
    _reference("sources.id", "Document", nullable=False, index=True),
    _text("rule", "Rule id", nullable=False, index=True),
    _text("severity", "E error, W warning, I information", nullable=False),
    _text("message", "What was found and what was done", nullable=False),
    _integer("line", "Line in the document, 0 when unknown", nullable=False),
    _text("path", "Element path; positions of repeated tags count from 0 (in XPath from 1)", nullable=False),
)
