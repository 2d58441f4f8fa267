"""How records become rows and rows become records.

Every record type has a :class:`Codec`: scalar fields are columns of the same name, texts in several languages become
``name`` (the one to show) and ``names`` (JSON, only when one column cannot tell it all), nested values are JSON,
and lists that have a table of their own are listed in :data:`CHILDREN`. No SQLAlchemy in here.
"""

from collections.abc import Callable, Sequence
from functools import cache, cached_property
from typing import Annotated, Any, NamedTuple, get_args, get_origin, get_type_hints

import msgspec

from esicatalog.esi.binding import Doc, Field, Record, fields_of, is_record
from esicatalog.esi.content import sha256_hex
from esicatalog.esi.numbers import IMAGE, decode_hex_binary
from esicatalog.esi.records.common import Name, display_text
from esicatalog.esi.records.dc import OpMode
from esicatalog.esi.records.device import Device, Eeprom, Fmmu, HideType, SyncManager, SyncUnit
from esicatalog.esi.records.diagnostics import DiagMessage, Diagnostics
from esicatalog.esi.records.dictionary import DataType, Dictionary, EnumInfo, Flags, Object, SubItem
from esicatalog.esi.records.document import Group, Vendor
from esicatalog.esi.records.mailbox import INIT_CMD_FIELDS, InitCmd, Mailbox
from esicatalog.esi.records.module import Module
from esicatalog.esi.records.pdo import RX_PDO, TX_PDO, Entry, Exclude, Pdo
from esicatalog.esi.records.profile import ChannelInfo, Profile
from esicatalog.esi.records.slots import Slot, SlotModuleClass, SlotModuleIdent
from esicatalog.model.device_facts import DeviceFacts
from esicatalog.model.dictionary import ObjectEntry
from esicatalog.model.drive_evidence import ModeEvidence
from esicatalog.model.drive_modes import DriveModeVerdict
from esicatalog.model.pdo_facts import entry_facts, pdo_facts
from esicatalog.model.sm_facts import sm_facts
from esicatalog.model.sync import sync_signals

Derive = Callable[[Any], Record]


class Column(NamedTuple):
    """A column: name, kind (int, bool, float, text, json) and what it means."""

    name: str
    kind: str
    doc: str


class Child(NamedTuple):
    """A field whose items are rows of another table.

    ``discriminator`` is (column, value) where several fields share a table; ``under_parent`` tells whether the rows
    hang on the parent's row (else on the device or module itself).
    """

    field: str
    table: str
    discriminator: tuple[str, str] | None = None
    single: bool = False
    under_parent: bool = False

    @property
    def constant(self) -> tuple[str, ...]:
        """Value of the discriminator, which is a column of its own."""
        return (self.discriminator[1],) if self.discriminator is not None else ()


CHILDREN: dict[type[Record], tuple[Child, ...]] = {
    Device: (
        Child("hide_types", "hidden_revisions"),
        Child("profiles", "profiles"),
        Child("fmmus", "fmmus"),
        Child("sync_managers", "sync_managers"),
        Child("sync_units", "sync_units"),
        Child("rx_pdos", "pdos", ("direction", RX_PDO)),
        Child("tx_pdos", "pdos", ("direction", TX_PDO)),
        Child("mailbox", "mailboxes", single=True),
        Child("op_modes", "dc_modes"),
        Child("slots", "slots"),
        Child("eeprom", "eeproms", single=True),
    ),
    Module: (
        Child("rx_pdos", "pdos", ("direction", RX_PDO)),
        Child("tx_pdos", "pdos", ("direction", TX_PDO)),
        Child("safety_para_mappings", "pdos", ("direction", "SafetyParaMapping")),
        Child("mailbox", "mailboxes", single=True),
        Child("profiles", "profiles"),
    ),
    Pdo: (
        Child("entries", "pdo_entries", under_parent=True),
        Child("excludes", "pdo_exclusions", under_parent=True),
    ),
    Profile: (Child("channel_infos", "profile_channels", under_parent=True),),
    Mailbox: tuple(Child(field, "initcmds", ("protocol", protocol)) for protocol, field in INIT_CMD_FIELDS.items()),
    Slot: (
        Child("module_idents", "slot_modules", under_parent=True),
        Child("module_classes", "slot_module_classes", under_parent=True),
    ),
    Diagnostics: (Child("diag_messages", "diag_messages", under_parent=True),),
    DataType: (
        Child("sub_items", "sub_items", under_parent=True),
        Child("enum_infos", "enum_values", under_parent=True),
    ),
}

_ELSEWHERE: dict[type[Record], frozenset[str]] = {
    Profile: frozenset({"dictionary", "diag_messages"}),
    Device: frozenset({"group_type"}),
    Dictionary: frozenset({"data_types", "objects"}),
}
"""Fields that are kept by reference or with the source."""

_DERIVED: dict[type[Record], Derive] = {
    OpMode: lambda op_mode: sync_signals(op_mode.assign_activate),
    SyncManager: sm_facts,
    Pdo: pdo_facts,
    Entry: entry_facts,
}
"""Columns that follow from the record; they are written, never read back."""

TABLE_RECORDS: dict[str, type[Record]] = {
    "hidden_revisions": HideType,
    "profiles": Profile,
    "profile_channels": ChannelInfo,
    "fmmus": Fmmu,
    "sync_managers": SyncManager,
    "sync_units": SyncUnit,
    "pdos": Pdo,
    "pdo_entries": Entry,
    "pdo_exclusions": Exclude,
    "mailboxes": Mailbox,
    "initcmds": InitCmd,
    "dc_modes": OpMode,
    "slots": Slot,
    "slot_modules": SlotModuleIdent,
    "slot_module_classes": SlotModuleClass,
    "eeproms": Eeprom,
    "data_types": DataType,
    "sub_items": SubItem,
    "enum_values": EnumInfo,
    "objects": Object,
    "object_entries": ObjectEntry,
    "dictionaries": Dictionary,
    "diagnostics": Diagnostics,
    "diag_messages": DiagMessage,
    "devices": Device,
    "modules": Module,
    "drive_modes": DriveModeVerdict,
    "mode_evidence": ModeEvidence,
    "device_facts": DeviceFacts,
    "groups": Group,
    "source_vendors": Vendor,
}

PARENTS = {
    child.table: parent
    for parent, record in TABLE_RECORDS.items()
    for child in CHILDREN.get(record, ())
    if child.under_parent
}
"""Parent table of the tables whose rows hang on another row."""

_KINDS = {int: "int", bool: "bool", float: "float", str: "text"}
_EXTENSION_OWNERS = (Device, Module, Profile, Mailbox, OpMode, Eeprom)

_encode_json = msgspec.json.Encoder(order="deterministic").encode
"""Spellings by name in one order: that of attributes means nothing, and what is stored once is of any who had it."""


def to_json(value: Any) -> str:
    """Compact JSON text of a record, tuple or dict."""
    return _encode_json(value).decode("utf-8")


class Codec:
    """Encodes records of one type as tuples of column values, and back."""

    def __init__(self, record_type: type[Record]) -> None:
        self.record_type = record_type
        child_fields = {child.field for child in CHILDREN.get(record_type, ())}
        left_out = child_fields | _ELSEWHERE.get(record_type, frozenset())
        columns: list[Column] = []
        self._expressions: list[str] = []
        self._taken: list[tuple[str, int]] = []
        self._decoders: list[tuple[str, int, Callable[[Any, int], Any]]] = []
        self.extensions: list[Field] = []
        """Vendor-specific XML fields, kept in the table vendor_extensions."""
        self.image_column: int | None = None
        for field in _fields(record_type):
            if field.name in left_out:
                continue
            if field.name.endswith("vendor_specific") and record_type in _EXTENSION_OWNERS:
                self.extensions.append(field)
                continue
            start = len(columns)
            own, expression = _columns(field)
            columns += own
            self._expressions.append(expression.format(f"record.{field.name}"))
            if field.xml.kind is IMAGE:
                self.image_column = start
            decoder = _decoder(field)
            if decoder is None:
                self._taken.append((field.name, start))
            else:
                self._decoders.append((field.name, start, decoder))
        self._spelling: int | None = None
        if fields_of(record_type):
            self._spelling = len(columns)
            columns.append(Column("spelling", "json", "Vendor's text of values that are not spelled canonically, JSON"))
            self._expressions.append(_JSON.format("record.spelling"))
        self.is_leaf = not (CHILDREN.get(record_type) or self.extensions or self.image_column is not None)
        """Whether nothing but the row itself comes of a record."""
        self.stored_columns = tuple(columns)
        self._derive = _DERIVED.get(record_type)
        self._derived = codec(type(self._derive(record_type()))) if self._derive is not None else None

    @property
    def columns(self) -> tuple[Column, ...]:
        """All columns in the order in which :attr:`encode` gives their values."""
        return self.stored_columns + (self._derived.columns if self._derived is not None else ())

    def stored(self, columns: Any) -> list[Any]:
        """Those ``columns`` of a table that are stored, in the order in which :meth:`decode` takes their values."""
        return [columns[column.name] for column in self.stored_columns]

    @cached_property
    def encode(self) -> Callable[[Any], tuple[Any, ...]]:
        """What gives the column values of a record: one expression of all, which costs a third of a loop over them.

        It is made of names of record fields, never of anything that was read.
        """
        expressions, functions = self._expressions, _FUNCTIONS
        if self._derived is not None:
            expressions = [*expressions, "*derived(derive(record))"]
            functions = functions | {"derived": self._derived.encode, "derive": self._derive}
        function: Callable[[Any], tuple[Any, ...]] = eval(  # noqa: S307
            f"lambda record: ({', '.join(expressions)},)", functions
        )
        return function

    def decode(self, values: tuple[Any, ...] | Any, **elsewhere: Any) -> Any:
        """The record of a row: ``values`` start with the stored columns; other fields come by keyword."""
        fields = {name: values[at] for name, at in self._taken}
        for name, at, decode in self._decoders:
            fields[name] = decode(values, at)
        fields.update(elsewhere)
        if self._spelling is not None and values[self._spelling] is not None:
            fields["spelling"] = msgspec.json.decode(values[self._spelling])
        return self.record_type(**fields)


_codecs: dict[type[Record], Codec] = {}


def codec(record_type: type[Record]) -> Codec:
    """The codec of a record type."""
    found = _codecs.get(record_type)
    if found is None:
        found = _codecs[record_type] = Codec(record_type)
    return found


def _fields(record_type: type[Record]) -> Sequence[Field]:
    """Bound fields, with nested Flags spread out, and documented fields of derived records."""
    return fields_of(record_type) or _documented(record_type)


def _documented(record_type: type[Record]) -> list[Field]:
    found = []
    for name, hint in get_type_hints(record_type, include_extras=True).items():
        if get_origin(hint) is not Annotated:
            continue
        declared, *extras = get_args(hint)
        doc = next(extra.doc for extra in extras if isinstance(extra, Doc))
        item = next(part for part in (*get_args(declared), declared) if part is not type(None))
        found.append(Field(name, msgspec.structs.replace(_PLAIN, doc=doc), False, item))
    return found


_TAKEN = "{0}"
_JSON = "json({0}) if {0} else None"
_IMAGE = "image({0})"
_NAMES = "*names({0})"
_FLAGS = "*flags({0})"
"""How the values of a field's columns come from the field: expressions that call :data:`_FUNCTIONS`."""


def _columns(field: Field) -> tuple[tuple[Column, ...], str]:
    """Columns of a field, and the expression of their values."""
    doc = field.xml.doc
    if field.item is Flags:
        return (
            Column("has_flags", "bool", "1 when the element Flags is present"),
            *codec(Flags).stored_columns[:-1],
            Column("flags_spelling", "json", "Vendor's text of flags that are not spelled canonically, JSON"),
        ), _FLAGS
    if field.name == "names" and field.item is Name:
        return (
            Column("name", "text", "Name to show: English, else the first"),
            Column("names", "json", f"{doc}, JSON; NULL when name says it all"),
        ), _NAMES
    if field.xml.kind is IMAGE:
        return (Column(field.name.replace("image_data", "image_sha256"), "text", "Image, key in images"),), _IMAGE
    if field.many or is_record(field.item):
        return (Column(field.name, "json", doc if "JSON" in doc else f"{doc}, as JSON"),), _JSON
    return (Column(field.name, _KINDS[field.item], doc),), _TAKEN


@cache
def _no_flags() -> tuple[None, ...]:
    return (None,) * (1 + len(codec(Flags).columns))


def _flags_values(flags: Flags | None) -> tuple[Any, ...]:
    return (True, *codec(Flags).encode(flags)) if flags is not None else _no_flags()


def _names_values(names: tuple[Name, ...]) -> tuple[str | None, str | None]:
    if not names:
        return None, None
    if len(names) == 1 and names[0].lcid is None and names[0].spelling is None:
        return names[0].text, None
    return display_text(names), to_json(names)


def _decoder(field: Field) -> Callable[[Any, int], Any] | None:
    """What makes the value of a field of the values of a row and its place in them; None for what stands there."""
    if field.item is Flags:
        width = len(codec(Flags).stored_columns)
        return lambda values, at: codec(Flags).decode(values[at + 1 : at + 1 + width]) if values[at] else None
    if field.name == "names" and field.item is Name:
        return lambda values, at: _decode_names(values[at], values[at + 1])
    if field.many:
        decode_list = msgspec.json.Decoder(tuple[field.item, ...]).decode  # type: ignore[name-defined]
        return lambda values, at: () if values[at] is None else decode_list(values[at])
    if is_record(field.item):
        decode_one = msgspec.json.Decoder(field.item).decode
        return lambda values, at: None if values[at] is None else decode_one(values[at])
    if field.item is bool:
        return lambda values, at: None if values[at] is None else bool(values[at])
    return None


_decode_name_list = msgspec.json.Decoder(tuple[Name, ...]).decode


def _decode_names(name: str | None, names: str | None) -> tuple[Name, ...]:
    if names is not None:
        return _decode_name_list(names)
    return () if name is None else (Name(text=name),)


def image_key(hex_text: str | None) -> str | None:
    """Key of an image in the table images: SHA-256 of its bytes, or of the text when that is not hexBinary."""
    if hex_text is None:
        return None
    data = decode_hex_binary(hex_text)
    return sha256_hex(hex_text.encode() if data is None else data)


def extension_rows(record: Any, table: str, position: int) -> list[tuple[str, int, str, str]]:
    """Rows (owner table, owner position, field, XML) of the vendor-specific XML directly in a record."""
    found = []
    for field in codec(type(record)).extensions:
        xml = getattr(record, field.name)
        if xml is not None:
            found.append((table, position, field.name, xml))
    return found


_PLAIN = fields_of(Name)[0].xml
_FUNCTIONS: dict[str, Any] = {"json": to_json, "image": image_key, "names": _names_values, "flags": _flags_values}
