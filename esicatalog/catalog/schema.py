"""Tables of the catalog, with a comment on every table and column.

Columns that come from records are taken from their declarations (:mod:`esicatalog.catalog.mapping`), so a new record
field is a new column; a migration creates it in existing catalogs.
"""

import sqlalchemy as sa

from esicatalog.catalog import types
from esicatalog.catalog.table_kinds import boolean, integer, key, owned, part, recorded, reference, table, text
from esicatalog.catalog.table_kinds import metadata as metadata  # all tables are in it

SCHEMA_VERSION = "0015"
"""Revision of the newest migration."""

catalog_state = table(
    "catalog_state",
    "State of the catalog as a whole: content hash, loads under way.",
    text("key", "What it is", primary_key=True),
    text("value", "Its value", nullable=False),
)

archives = table(
    "archives",
    "Zip archives that were ingested completely; an unchanged one is skipped by its sha256 without opening it.",
    key(),
    text("location", "Absolute path", nullable=False, unique=True),
    text("sha256", "SHA-256 of the archive", nullable=False),
    text("reader_version", "Version of esicatalog that read it", nullable=False),
)

sources = table(
    "sources",
    "Documents that were given to ingest: stored, skipped and failed ones.",
    key(),
    text("location", "Absolute path; archive!member for archives", nullable=False, unique=True),
    text("member", "Path relative to the folder given to ingest; archive.zip!member for archives", nullable=False),
    reference("archives.id", "Archive it lies in; NULL for a file on disk", index=True),
    text("status", "stored, recovered (stored after repair), skipped or failed", nullable=False, index=True),
    text("message", "Why it was recovered, skipped or failed"),
    text("sha256", "SHA-256 of the document", index=True),
    integer("byte_count", "Size in bytes"),
    text("reader_version", "Version of esicatalog that read it", nullable=False),
    text("root", "Root element: EtherCATInfo, EtherCATInfoList, EtherCATModule, EtherCATDict or EtherCATDiag"),
    text("encoding", "Encoding it was read with"),
    integer("device_count", "Device elements in the document", nullable=False),
    integer("module_count", "Module elements in the document", nullable=False),
    reference("dictionaries.id", "Dictionary of an EtherCATDict document", index=True),
    reference("diagnostics.id", "Diagnosis texts of an EtherCATDiag document", name="diagnostics_id", index=True),
    boolean(
        "is_whole",
        "1 when it and all that it pulls in were read whole, 0 when elements may be lost (broken markup); NULL when it "
        "was not stored, or by a version that did not tell",
    ),
)

source_references = table(
    "source_references",
    "Which documents a document pulls in: dictionaries, diagnosis texts, module lists.",
    key(),
    reference("sources.id", "Document that refers", nullable=False, index=True),
    integer("position", "Position in document order, from 0", nullable=False),
    text("kind", "DictionaryFile, DiagFile or InfoReference", nullable=False),
    text("reference", "As the vendor wrote it", nullable=False),
    text("found_location", "Where it was found, relative to the folder or archive; NULL when it was not"),
    text("sha256", "SHA-256 of what was found"),
)

vendors = table(
    "vendors",
    "Vendors by the id that the ETG assigned; the key of everything is vendor, product, revision.",
    integer("vendor_id", "Vendor id", primary_key=True, autoincrement=False),
    text("name", "Name to show: the one that most documents use"),
    text("image_sha256", "Image, key in images"),
)

vendor_names = table(
    "vendor_names",
    "Every spelling and language of a vendor's name, with the number of documents that use it.",
    key(),
    reference("vendors.vendor_id", "Vendor", name="vendor_id", nullable=False, index=True),
    integer("lcid", "Windows locale id; NULL when the document gives none"),
    text("name", "Name", nullable=False),
    integer("document_count", "Documents that use it", nullable=False),
)

source_vendors = table(
    "source_vendors",
    "Vendor section of each document: vendor as written, file version, schema version.",
    key(),
    reference("sources.id", "Document", nullable=False, index=True),
    integer("position", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    text("schema_version", "Schema version that the author used"),
    text("info_references", "Module documents it refers to, as JSON"),
    text("shared_pdos", "Shared Pdo elements of files before schema 1.2, as JSON"),
    boolean("has_vendor", "1 when the element Vendor is present", nullable=False),
    *recorded("source_vendors"),
)

groups = table(
    "groups",
    "Groups of devices, keyed by vendor and type; a group that documents describe differently has several rows.",
    key(),
    integer("vendor_id", "Vendor; NULL when the document gives none", index=True),
    text("content_hash", "Digest of vendor id and content", nullable=False, unique=True),
    *recorded("groups"),
)

source_groups = table(
    "source_groups",
    "Which document defines which group.",
    key(),
    reference("sources.id", "Document", nullable=False, index=True),
    reference("groups.id", "Group", nullable=False, index=True),
    integer("section", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    integer("position", "Position in document order, from 0", nullable=False),
)

devices = table(
    "devices",
    "Device descriptions: one row per distinct content, keyed by vendor_id, product_code, revision_no and variant.",
    key(),
    reference("vendors.vendor_id", "Vendor id; NULL when the document gives none", name="vendor_id"),
    integer("variant", "1 = the preferred description of this identity, 2 … = differing ones", nullable=False),
    text(
        "content_hash",
        "Digest of the content: vendor id, device, dictionaries, reachable modules",
        nullable=False,
        unique=True,
    ),
    *recorded("devices"),
    integer("default_op_mode", "Position of the default OpMode: the first that newer tools do not ignore"),
    integer("element_count", "Objects plus PDO entries, reachable modules included", nullable=False),
    boolean(
        "hidden",
        "1 when another description of the vendor supersedes it (HideType)",
        nullable=False,
        server_default="0",
    ),
    boolean("recovered", "1 when every document that carries it needed recovery", nullable=False),
    integer("file_version", "Highest FileVersion of the documents that carry it"),
    text("group_type", "Group that the description names in its first document"),
    text(
        "own_vendor_name",
        "Name of its vendor in its own documents, where these give quite another one than vendors has for the id: "
        "several makers use it; else NULL",
    ),
    sa.UniqueConstraint("vendor_id", "product_code", "revision_no", "variant"),
    sa.Index("ix_devices_listed", "vendor_id", "product_code", "revision_no", "type", "variant", "hidden"),
)

device_names = table(
    "device_names",
    "Names, comments and links of devices and modules in all languages.",
    key(),
    reference("devices.id", "Device description; NULL for a module", index=True),
    reference("modules.id", "Module; NULL for a device", index=True),
    text("kind", "name, comment or url", nullable=False),
    integer("position", "Position in document order, from 0", nullable=False),
    integer("lcid", "Windows locale id; NULL when the document gives none"),
    text("text", "The text", nullable=False),
)

device_sources = table(
    "device_sources",
    "Which documents and lines carry a device description.",
    key(),
    reference("devices.id", "Device description", nullable=False, index=True),
    reference("sources.id", "Document", nullable=False, index=True),
    integer("section", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    integer("position", "Position among the Device elements, from 0", nullable=False),
    integer("line", "Line of the Device element", nullable=False),
    text("group_type", "Group that the document puts it in"),
)

modules = table(
    "modules",
    "Modules for slots, one row per distinct content and vendor.",
    key(),
    reference("vendors.vendor_id", "Vendor id; NULL when the document gives none", name="vendor_id", index=True),
    text("content_hash", "Digest of the content: vendor id, module, dictionaries", nullable=False, unique=True),
    *recorded("modules"),
    integer("element_count", "Objects plus PDO entries", nullable=False),
    sa.Index("ix_modules_ident", "vendor_id", "module_ident"),
)

module_sources = table(
    "module_sources",
    "Which documents and lines carry a module.",
    key(),
    reference("modules.id", "Module", nullable=False, index=True),
    reference("sources.id", "Document", nullable=False, index=True),
    integer("section", "Number of the EtherCATInfo element in the document, from 0", nullable=False),
    integer("position", "Position among the Module elements, from 0", nullable=False),
    integer("line", "Line of the Module element", nullable=False),
)

device_modules = table(
    "device_modules",
    "Modules that the slots of a device can reach.",
    reference("devices.id", "Device description", primary_key=True),
    integer("position", "Position in document order, from 0", primary_key=True),
    reference("modules.id", "Module", nullable=False, index=True),
    sqlite_with_rowid=False,
)

hidden_revisions = owned("hidden_revisions", "HideType: revisions that a description supersedes.")
profiles = owned(
    "profiles",
    "Profiles of devices and modules: profile numbers, channels, dictionary, diagnosis texts.",
    reference("dictionaries.id", "Object dictionary"),
    reference("diagnostics.id", "Diagnosis texts", name="diagnostics_id", index=True),
)
sa.Index("ix_profiles_dictionary", profiles.c.dictionary_id, profiles.c.device_id, profiles.c.module_id)
profile_channels = part("profile_channels", "profiles", "Profiles of single channels (ChannelInfo).")
fmmus = owned("fmmus", "FMMUs; the position is the FMMU's number.")
sync_managers = owned("sync_managers", "SyncManagers; the position is the SyncManager's number.")
sync_units = owned("sync_units", "Sync units (Su); the position is what Pdo@Su refers to.")
pdos = owned(
    "pdos",
    "PDOs of devices and modules.",
    text("direction", "RxPdo (master to slave), TxPdo (slave to master) or SafetyParaMapping", nullable=False),
    derived=(integer("image_sm", "SyncManager of the PDO in the device's default process image; NULL = not in it"),),
)
pdo_entries = part(
    "pdo_entries",
    "pdos",
    "Entries of PDOs, padding included, OSFac not expanded.",
    integer(
        "image_bit_offset", "Bits before it in its SyncManager's default process image; NULL = not in it or not known"
    ),
)
_MAPPED = ("entry_index", "subindex", "bit_length", "pdo_id")
sa.Index("ix_pdo_entries_mapping", *(pdo_entries.c[name] for name in _MAPPED))
pdo_exclusions = part("pdo_exclusions", "pdos", "PDOs that may not be assigned together, as declared (one-sided).")
mailboxes = owned("mailboxes", "Mailbox protocols and their options, one row a device or module.")
initcmds = owned(
    "initcmds",
    "Start-up commands (InitCmd) of all mailbox protocols; one row may serve several transitions.",
    text("protocol", "CoE, SoE, EoE or AoE", nullable=False),
)
dc_modes = owned("dc_modes", "OpModes of the distributed clocks with the SYNC signals that AssignActivate asks for.")
slots = owned("slots", "Slot elements; with max_instances above 1 one stands for several slots.")
slot_modules = part("slot_modules", "slots", "Modules that fit a slot, by ModuleIdent.")
slot_module_classes = part("slot_module_classes", "slots", "Modules that fit a slot, by ModuleClass.")
eeproms = owned("eeproms", "Eeprom elements: size, ConfigData, bootstrap mailbox, further categories.")

device_facts = table(
    "device_facts",
    "What devices imply and no single element says: sizes, SYNC support, cycle, layout, safety evidence.",
    reference("devices.id", "Device description", primary_key=True, autoincrement=False),
    *recorded("device_facts"),
    sa.Index("ix_device_facts_image_signature", "image_signature"),
)
drive_modes = table(
    "drive_modes",
    "Which drive modes a device can run, as far as its description tells: verdict and recipe per axis and mode.",
    reference("devices.id", "Device description", primary_key=True),
    integer("position", "Order: by axis and mode, from 0", primary_key=True),
    *recorded("drive_modes"),
    sa.Index("ix_drive_modes_kind_mode", "kind", "mode", "verdict"),
    sqlite_with_rowid=False,
)
mode_evidence = table(
    "mode_evidence",
    "Every single finding about a drive mode, for and against; docs/drive-modes.md explains the ranks.",
    reference("devices.id", "Device description", primary_key=True),
    integer("position", "Order of finding, from 0", primary_key=True),
    *recorded("mode_evidence"),
    sqlite_with_rowid=False,
)

dictionaries = table(
    "dictionaries",
    "Object dictionaries, each distinct one once; profiles and EtherCATDict documents point to them.",
    key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
    reference("type_sets.id", "Data types that it declares", nullable=False, index=True),
    *recorded("dictionaries"),
    integer("object_count", "Number of objects", nullable=False),
)
diagnostics = table(
    "diagnostics",
    "Diagnosis texts of a device or document as a whole, each distinct set once.",
    key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
    *recorded("diagnostics"),
)
data_types = table(
    "data_types",
    "Data types as declared, each distinct one once; a name is valid within one dictionary only.",
    key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
    *recorded("data_types"),
)
diag_messages = part("diag_messages", "diagnostics", "Diagnosis texts by text id, as object 0x10F3 refers to them.")
sub_items = part("sub_items", "data_types", "Members of composite data types.")
enum_values = part("enum_values", "data_types", "Values of enumerations.")
type_sets = table(
    "type_sets",
    "Sets of data types that dictionaries declare, each distinct one once; type_set_data_types lists them.",
    key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of the content"),
)
type_set_data_types = table(
    "type_set_data_types",
    "Which data types a type set holds.",
    reference("type_sets.id", "Type set", primary_key=True),
    integer("position", "Position in document order, from 0", primary_key=True),
    reference("data_types.id", "Data type", nullable=False, index=True),
    sqlite_with_rowid=False,
)
objects = table(
    "objects",
    "Objects, each distinct one (with the data types it uses) once; dictionary_objects says where they occur.",
    key(),
    sa.Column("content_hash", types.blob(), nullable=False, unique=True, comment="Digest of object and types"),
    *recorded("objects"),
    integer("object_code", "CoE object code: 7 VAR, 8 ARRAY, 9 RECORD", nullable=False),
    sa.Index("ix_objects_object_index", "object_index"),
)
object_entries = part(
    "object_entries", "objects", "Subindices of objects: type, size, access, PDO mapping, values.", indexed=False
)
sa.Index("ix_object_entries_subindex", object_entries.c.object_id, object_entries.c.subindex)
dictionary_objects = table(
    "dictionary_objects",
    "Which objects a dictionary holds.",
    reference("dictionaries.id", "Dictionary", primary_key=True),
    integer("position", "Position in document order, from 0", primary_key=True),
    reference("objects.id", "Object", nullable=False, index=True),
    sqlite_with_rowid=False,
)

images = table(
    "images",
    "Images of vendors, groups, devices, modules and slots, each distinct one once.",
    text("sha256", "SHA-256 of the bytes", primary_key=True),
    sa.Column("data", types.blob(), comment="Image file, usually BMP; NULL when the document's text is malformed"),
    text("malformed", "Text of the document when it is not hexBinary"),
)
vendor_extensions = table(
    "vendor_extensions",
    "Vendor-specific XML as it stands, by owner.",
    key(),
    reference("devices.id", "Device description; NULL for a module", index=True),
    reference("modules.id", "Module; NULL for a device", index=True),
    text("owner_table", "Table whose row carries it; empty = the device or module itself", nullable=False),
    integer("owner_position", "Position of that row", nullable=False),
    text("field", "Which element: info_vendor_specific is Info/VendorSpecific", nullable=False),
    text("xml", "Canonical XML", nullable=False),
)
unmapped = table(
    "unmapped",
    "Values that no column holds: unknown or repeated elements and attributes, with their place.",
    key(),
    reference("devices.id", "Device description", index=True),
    reference("modules.id", "Module", index=True),
    reference("sources.id", "Document, for values outside of devices and modules", index=True),
    integer("position", "Order of occurrence, from 0", nullable=False),
    text("path", "Path of the element or attribute below its owner", nullable=False),
    text("value", "Its text", nullable=False),
)
findings = table(
    "findings",
    "What was noticed in the documents: broken markup, malformed values, unknown elements, missing references.",
    key(),
    reference("sources.id", "Document", nullable=False, index=True),
    text("rule", "Rule id", nullable=False, index=True),
    text("severity", "E error, W warning, I information", nullable=False),
    text("message", "What was found and what was done", nullable=False),
    integer("line", "Line in the document, 0 when unknown", nullable=False),
    text("path", "Element path; positions of repeated tags count from 0 (in XPath from 1)", nullable=False),
)
