"""Canned queries of the Datasette metadata. An empty parameter means what the description says.

What ``esicatalog devices`` would refuse is an error here too: none found must not be the answer to a slip.
"""

from collections.abc import Iterable
from typing import Any

from esicatalog.catalog.device_filter import MODES
from esicatalog.catalog.filter_texts import TRUE_WORDS
from esicatalog.catalog.views import mapped_subindex, vendor_name
from esicatalog.model.cia402 import CIA402
from esicatalog.model.device_words import MAILBOX_PROTOCOLS
from esicatalog.model.drive_modes import accepted_verdicts

_IDENTITY = "vendor, device_type, device_name, vendor_id_hex, product_code_hex, revision_no_hex"
_ORDER = "vendor_id, product_code, revision_no"


def _texts(words: Iterable[str]) -> str:
    """A list of texts, none of which has a quote."""
    return "({})".format(", ".join(f"'{word}'" for word in words))


_TRUE = _texts(TRUE_WORDS)
_SHOWN = f"(hidden = 0 or :include_hidden in {_TRUE})"
"""Rows of revisions that ``esicatalog devices`` lists, with and without ``--include-hidden``."""
_ACCEPTED, _ACCEPTED_STRICTLY = _texts(accepted_verdicts()), _texts(accepted_verdicts(strict=True))
_HIDDEN_DOC = "include_hidden: 1 = also revisions that another description supersedes (empty = without them)."


def _readable(*names: str, **read_as: str) -> str:
    """A condition that ends the statement with words where ``esicatalog devices`` refuses a parameter.

    ``read_as`` are parameters that are read as one of another name. No function of SQLite but those about JSON tells of
    what it was given; it tells of a path that is none.
    """
    given = ", ".join(f"'{kind}', :{name}" for name, kind in (dict(zip(names, names, strict=True)) | read_as).items())
    return f"json_extract('{{}}', refusal({given})) is null"


CANNED_QUERIES: dict[str, dict[str, Any]] = {
    "find_a_device": {
        "title": "Find a device",
        "description": (
            "text: words in vendor, type or name, inner parts of words from three characters on, or an identity as "
            "0x044c2c52, #x044c2c52 or 72100946; all words must match. All descriptions of an identity are listed. "
            f"{_HIDDEN_DOC}"
        ),
        "params": ["text", "include_hidden"],
        "sql": f"""\
select device_id, {_IDENTITY},
  variant, profile_no
from device_overview
where {_readable("include_hidden")}
  and device_id in (select rowid from device_search where device_search match escape_fts(:text))
  and {_SHOWN}
order by {_ORDER}, variant
""",
    },
    "devices_by_drive_profile": {
        "title": "Devices by drive profile",
        "description": (
            "profile: profile number (empty = 402, CiA 402 drives; 401 = I/O, 5001 = modular). Looks at the profiles "
            "of the device, of its channels and of the modules that its slots can reach; declared_by says which. "
            f"{_HIDDEN_DOC}"
        ),
        "params": ["profile", "include_hidden"],
        "sql": f"""\
with declared as (
  select device_id, module_id, profile_no from profiles
  union
  select p.device_id, p.module_id, c.profile_no from profile_channels c join profiles p on p.id = c.profile_id
), found as (
  select device_id, 'device' as declared_by, profile_no from declared where device_id is not null
  union
  select l.device_id, 'module ' || hex0x(m.module_ident, 8), n.profile_no
  from declared n join modules m on m.id = n.module_id join device_modules l on l.module_id = m.id
)
select device_id, {_IDENTITY},
  group_concat(declared_by, ', ') as declared_by
from found join device_overview using (device_id)
where {_readable("profile", "include_hidden")}
  and found.profile_no = parse_hex(ifnull(nullif(:profile, ''), '402')) and variant = 1 and {_SHOWN}
group by device_id
order by {_ORDER}
""",
    },
    "devices_with_dc_sync1": {
        "title": "Devices with DC SYNC1",
        "description": (
            "Devices with an OpMode whose AssignActivate generates SYNC1; op_modes names them with the word. "
            "vendor: vendor id as 0x1097, #x1097 or 4247, or a part of one of the vendor's names (empty = all). "
            f"{_HIDDEN_DOC}"
        ),
        "params": ["vendor", "include_hidden"],
        "sql": f"""\
select device_id, {_IDENTITY},
  group_concat(ifnull(name || ' ', '') || assign_activate_hex, ', ') as op_modes, max(is_default) as in_default_mode
from device_dc_modes
where {_readable("include_hidden", vendor="maker")}
  and sync1 = 1 and device_id in (select device_id from device_facts where supports_sync1 = 1)
  and variant = 1 and {_SHOWN}
  and (:vendor = '' or vendor_id = parse_hex(:vendor) or parse_hex(:vendor) is null
    and vendor_id in (select vendor_id from vendor_names where instr(lower(name), lower(:vendor))))
group by device_id
order by {_ORDER}
""",
    },
    "drives_with_a_mode": {
        "title": "Which drives support CSV",
        "description": (
            f"mode: {' '.join(MODES)} (empty = CSV); strict: 1 = only the verdict yes (empty = yes "
            "and likely). What the files say, not what the drives do: read 0x6502 on the drive. recipe says what to "
            f"plug, assign, choose and write. {_HIDDEN_DOC}"
        ),
        "params": ["mode", "strict", "include_hidden"],
        "sql": f"""\
select device_id, {_IDENTITY},
  axis, mode, verdict, conflict, evidence, recipe
from device_drive_modes
where {_readable("mode", "strict", "include_hidden")}
  and mode = upper(ifnull(nullif(trim(:mode), ''), 'CSV')) and kind = '{CIA402}' and variant = 1 and {_SHOWN}
  and verdict in {_ACCEPTED} and (verdict in {_ACCEPTED_STRICTLY} or :strict not in {_TRUE})
order by {_ORDER}, axis
""",
    },
    "csv_drives_with_sync1": {
        "title": "Drives with CSV and SYNC1",
        "description": (
            f"Verdict yes or likely for CSV, and an OpMode whose AssignActivate generates SYNC1. {_HIDDEN_DOC}"
        ),
        "params": ["include_hidden"],
        "sql": f"""\
select device_id, {_IDENTITY},
  axis, verdict, evidence, recipe,
  (select group_concat(ifnull(c.name || ' ', '') || hex0x(c.assign_activate), ', ') from dc_modes c
    where c.device_id = m.device_id and c.sync1 = 1) as sync1_op_modes
from device_drive_modes m
where {_readable("include_hidden")}
  and mode = 'CSV' and kind = '{CIA402}' and verdict in {_ACCEPTED} and variant = 1 and {_SHOWN}
  and device_id in (select device_id from device_facts where supports_sync1 = 1)
order by {_ORDER}, axis
""",
    },
    "csp_drives_with_fsoe": {
        "title": "Drives with CSP and FSoE",
        "description": (
            "Verdict yes or likely for CSP, and high or medium evidence of FSoE. This is not a safety statement: ask "
            "the vendor for the certificate. "
            f"{_HIDDEN_DOC}"
        ),
        "params": ["include_hidden"],
        "sql": f"""\
select m.device_id, {_IDENTITY},
  axis, verdict, evidence, fsoe, fsoe_evidence
from device_drive_modes m join device_facts f on f.device_id = m.device_id
where {_readable("include_hidden")}
  and mode = 'CSP' and kind = '{CIA402}' and verdict in {_ACCEPTED} and variant = 1 and {_SHOWN}
  and fsoe is not null
order by {_ORDER}, axis
""",
    },
    "drive_modes_of_each_vendor": {
        "title": "Mode matrix by vendor",
        "description": "Number of visible drives of each vendor that run a mode, by verdict yes or likely.",
        "params": [],
        "sql": """\
select * from drive_modes_by_vendor order by drives desc, vendor
""",
    },
    "devices_of_the_same_layout": {
        "title": "Same process-image layout",
        "description": (
            "vendor, product, revision: a device, as 0x044c2c52, #x044c2c52 or 72100946. Other devices whose default "
            "process image has the same layout. That is no promise that one replaces the other: revisions can be "
            "power ratings. "
            f"{_HIDDEN_DOC}"
        ),
        "params": ["vendor", "product", "revision", "include_hidden"],
        "sql": f"""\
select other_device_id as device_id, other_type as device_type, other_vendor_id_hex as vendor_id_hex,
  other_product_code_hex as product_code_hex, other_revision_no_hex as revision_no_hex, same_pdo_set,
  output_bytes, input_bytes
from same_process_image_layout
where {_readable("vendor", "product", "revision", "include_hidden")}
  and vendor_id = parse_hex(:vendor) and product_code = parse_hex(:product)
  and (:revision = '' or revision_no = parse_hex(:revision)) and variant = 1
  and other_device_id in (select id from devices where {_SHOWN})
order by vendor_id_hex, product_code_hex, revision_no_hex
""",
    },
    "devices_by_mailbox_protocol": {
        "title": "Devices by mailbox protocol",
        "description": (
            f"protocol: {', '.join(MAILBOX_PROTOCOLS)} (empty = foe); as declared by the Mailbox element. {_HIDDEN_DOC}"
        ),
        "params": ["protocol", "include_hidden"],
        "sql": f"""\
select device_id, {_IDENTITY},
  {", ".join(MAILBOX_PROTOCOLS)}, coe_complete_access, coe_sdo_info
from device_overview
where {_readable("protocol", "include_hidden")}
  and variant = 1 and {_SHOWN} and case lower(ifnull(nullif(trim(:protocol), ''), 'foe'))
  {" ".join(f"when '{name}' then {name}" for name in MAILBOX_PROTOCOLS)} end = 1
order by {_ORDER}
""",
    },
    "who_maps_an_object": {
        "title": "Who maps an object",
        "description": (
            "index: 0x60FF, #x60FF or 24831 (empty = 0x60FF); subindex: 0x0B, or 0B as CoE writes it (empty = all, "
            "those too that cannot be read); 10 to 99 without prefix are ambiguous and refused. Looks at the PDOs of "
            "devices and of the modules that their slots can reach, and names the module; sm is the SyncManager that a "
            "PDO is assigned to by default, one of a module when that is plugged. Indices of modules are as they give "
            "them, before the increments of slots move them; devices --maps finds what lies in any slot. "
            f"{_HIDDEN_DOC}"
        ),
        "params": ["index", "subindex", "include_hidden"],
        "sql": f"""\
with mapped as (
  select p.device_id, p.module_id, p.direction, hex0x(p.pdo_index) as pdo, p.name as pdo_name,
    case when p.module_id is null then p.image_sm when p."virtual" then null else p.sm end as sm,
    hex0x(e.entry_index) as entry, {mapped_subindex("e")} as subindex,
    e.bit_length, e.data_type, e.name as entry_name
  from pdo_entries e join pdos p on p.id = e.pdo_id
  where e.entry_index = parse_hex(ifnull(nullif(:index, ''), '0x60FF'))
), reached as (
  select device_id as found_id, * from mapped where device_id is not null
  union all
  select l.device_id, mapped.* from mapped join device_modules l on l.module_id = mapped.module_id
)
select d.id as device_id, {vendor_name("d", "v")} as vendor, d.type as device_type,
  hex0x(d.vendor_id, 8) as vendor_id_hex,
  hex0x(d.product_code, 8) as product_code_hex, hex0x(d.revision_no, 8) as revision_no_hex,
  hex0x(m.module_ident, 8) as module, m.type as module_type, direction, pdo, pdo_name, sm,
  entry, subindex, bit_length, data_type, entry_name
from reached
join devices d on d.id = found_id and d.variant = 1 and {_SHOWN}
left join vendors v on v.vendor_id = d.vendor_id
left join modules m on m.id = reached.module_id
where {_readable("index", "subindex", "include_hidden")}
  and (:subindex = '' or subindex = read_subindex(:subindex))
order by d.vendor_id, d.product_code, d.revision_no, m.module_ident, pdo
""",
    },
    "revisions_of_a_product": {
        "title": "Revisions of a product",
        "description": (
            "vendor: vendor id (empty = any); product: product code; both as 0x044c2c52, #x044c2c52 or 72100946. "
            "superseded_by names the other revisions whose HideType hides this one; layout_changed compares the "
            "default process image with that of the revision before, and is empty where that is not known."
        ),
        "params": ["vendor", "product"],
        "sql": f"""\
select device_id, {_IDENTITY},
  revision_text, hidden, layout_changed, output_bytes, input_bytes,
  (select group_concat(distinct ifnull(hex0x(newer.revision_no, 8), '-'))
    from hidden_revisions h join devices newer on newer.id = h.device_id
    where newer.vendor_id = d.vendor_id and ifnull(h.product_code, newer.product_code) = d.product_code
      and h.revision_no = d.revision_no
      and (newer.product_code is not d.product_code or newer.revision_no is not d.revision_no)) as superseded_by
from device_revisions d
where {_readable("vendor", "product")}
  and (:vendor = '' or vendor_id = parse_hex(:vendor)) and product_code = parse_hex(:product)
order by {_ORDER}
""",
    },
    "conflicting_descriptions_of_an_identity": {
        "title": "Conflicting descriptions of one identity",
        "description": (
            "Identities that documents describe differently; variant 1 is the preferred description. vendor, product, "
            "revision: numbers as 0x044c2c52, #x044c2c52 or 72100946 (empty = all)."
        ),
        "params": ["vendor", "product", "revision"],
        "sql": f"""\
select device_id, {_IDENTITY},
  variant, element_count, recovered, file_version,
  (select group_concat(distinct s.member) from device_sources x join sources s on s.id = x.source_id
    where x.device_id = c.device_id) as documents
from conflicting_descriptions c
where {_readable("vendor", "product", "revision")}
  and (:vendor = '' or vendor_id = parse_hex(:vendor)) and (:product = '' or product_code = parse_hex(:product))
  and (:revision = '' or revision_no = parse_hex(:revision))
order by {_ORDER}, variant
""",
    },
    "problems_of_ingest": {
        "title": "Problems of ingest",
        "description": (
            "Documents that failed, were skipped or recovered, and errors found in others. document: part of the path "
            "(empty = all); severity: E error, W warning, I information (empty = all)."
        ),
        "params": ["document", "severity"],
        "sql": f"""\
select source_id, member as document, status, severity, rule, message, line
from ingest_problems
where {_readable("severity")}
  and (:document = '' or instr(lower(member), lower(:document))) and (:severity = '' or severity = upper(:severity))
order by case severity when 'E' then 1 when 'W' then 2 else 3 end, member, line
""",
    },
}
