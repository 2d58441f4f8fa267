"""The OpenAPI document of the JSON routes."""

from collections.abc import Callable
from typing import Any

from esicatalog.catalog.filter_texts import (
    FALSE_WORDS,
    PARAMETERS,
    SHARPENS,
    TRUE_WORDS,
    VENDOR_WORDS,
    Parameter,
    parse_flag,
)
from esicatalog.catalog.results import MATCHES
from esicatalog.identity import UINT32_MAX, parse_bounds, parse_identity, parse_number, parse_object
from esicatalog.version import __version__
from esicatalog.web.links import BASE


def _decimals(limit: int) -> str:
    """A pattern of the numbers from 1 to ``limit``, which has at least two digits, without zeros before them."""
    digits = str(limit)
    parts = [f"[1-9][0-9]{{0,{len(digits) - 2}}}"]
    for place, digit in enumerate(digits):
        lowest = 1 if place == 0 else 0
        if int(digit) > lowest:
            parts.append(f"{digits[:place]}[{lowest}-{int(digit) - 1}][0-9]{{{len(digits) - place - 1}}}")
    return "|".join((*parts, digits))


def _number(hex_digits: int) -> str:
    """A pattern of what ``parse_number`` takes of so many hexadecimal digits."""
    return f"[0#][xX]0*[0-9a-fA-F]{{1,{hex_digits}}}|0+|0*({_decimals(16**hex_digits - 1)})"


_UINT32_NUMBER = _number(8)
_VARIANT_NUMBER = f"[0#][xX]0*[1-9a-fA-F][0-9a-fA-F]{{0,7}}|0*({_decimals(UINT32_MAX)})"
_SUBINDEX = "[0-9][a-fA-F]|[a-fA-F][0-9a-fA-F]|[0#][xX]0*[0-9a-fA-F]{1,2}|0*([0-9]|1[0-9]{2}|2[0-4][0-9]|25[0-5])"
"""What ``parse_subindex`` takes: two hexadecimal digits of which one is a letter, or a number, but not 10 to 99."""
_NUMBER = {"type": "string", "pattern": f"^({_UINT32_NUMBER})$", "examples": ["0x1097", "#x1097", "4247"]}
_UINT32 = {"type": ["integer", "null"], "minimum": 0, "maximum": UINT32_MAX}
_TEXT = {"type": ["string", "null"]}
_HEX = {"type": ["string", "null"], "pattern": "^0x[0-9a-f]{8}$"}


_INDEX_SUBINDEX = {
    "type": "string",
    "pattern": f"^(({_number(4)})(\\s*:\\s*({_SUBINDEX}))?)?$",
    "examples": ["0x60FF", "0x6040:0", "0x6000:0A"],
}
_BOUNDS = {
    "type": "string",
    "pattern": f"^(((<=|>=|=)\\s*)?(-\\s*)?({_UINT32_NUMBER}))?$",
    "examples": ["<=8", ">=4", "100"],
}
_FLAG = {"type": "string", "enum": ["", *TRUE_WORDS, *FALSE_WORDS]}
_IDENTITY_TEXT = {
    "type": "string",
    "pattern": f"^(({_UINT32_NUMBER})\\s*:\\s*({_UINT32_NUMBER})"
    f"((\\s*:\\s*({_UINT32_NUMBER}))?(\\s*@\\s*({_VARIANT_NUMBER}))?|\\s*:-(@\\s*({_VARIANT_NUMBER}))?))?$",
    "examples": ["0x1097:0x2406", "0x1097:0x2406:0x8f", "0x1097:0x2406:-@2"],
}
_OPTIONAL_NUMBER = {**_NUMBER, "pattern": f"^({_UINT32_NUMBER})?$"}
_VENDOR_NAME = "\\s*([1-9][0-9]*)?[^0-9#\\s][\\s\\S]*"
_VENDOR = {"type": "string", "pattern": f"^({_UINT32_NUMBER}|{_VENDOR_NAME})?$"}
_BY_PARSER: dict[Callable[[str], Any], dict[str, Any]] = {
    parse_number: _OPTIONAL_NUMBER,
    parse_flag: _FLAG,
    parse_bounds: _BOUNDS,
    parse_object: _INDEX_SUBINDEX,
    parse_identity: _IDENTITY_TEXT,
    str: {"type": "string"},
}
"""Schemas of filters by what reads their text."""
_PHYSICS = {"type": "string", "pattern": "^( *[YyKkHhBb][YyKkHhBb ]*)?$", "examples": ["YY", "YKY"]}
_EXAMPLES = {"product": "0x2406", "profile": "402", "bits": "16", "limit": "10"}
_NOT_ASKED = "Empty = not asked."
_SCANS = (
    "^vendor,product,revision(\\n0x[0-9a-f]{1,8},0x[0-9a-f]{1,8},(0x[0-9a-f]{1,8})?)+\\n$",
    "^=== Master [0-9]{1,3}, Slave [0-9]{1,5} ===\\n",
    "^SOEM \\(Simple Open EtherCAT Master\\)\\nSlave:[1-9][0-9]{0,3}\\n",
)
"""How the texts of scans begin: a list of identities, ``ethercat slaves -v``, ``slaveinfo``; all have a slave."""


def _object(properties: dict[str, Any], optional: tuple[str, ...] = ()) -> dict[str, Any]:
    required = [name for name in properties if name not in optional]
    return {"type": "object", "properties": properties, "required": required}


def _list(item: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": item}


def _ref(name: str) -> dict[str, Any]:
    return {"$ref": f"#/components/schemas/{name}"}


_IDENTITY = {
    "vendor_id": _UINT32,
    "vendor_id_hex": _HEX,
    "product_code": _UINT32,
    "product_code_hex": _HEX,
    "revision_no": _UINT32,
    "revision_no_hex": _HEX,
}
_DEVICE = {
    **_IDENTITY,
    "variant": {"type": "integer", "minimum": 1},
    "vendor": _TEXT,
    "type": _TEXT,
    "name": _TEXT,
    "hidden": {"type": "boolean"},
    "evidence": _list({"type": "string"}),
}
_SOURCE = _object(
    {
        "member": {"type": "string"},
        "line": {"type": "integer"},
        "group_type": _TEXT,
        "is_whole": {"type": "boolean", "description": "false where broken markup may have cost elements"},
    }
)
_SLOT = {"type": "integer", "minimum": 0}
_FITTING = _object({"choice": {"type": "string"}, "name": {"type": "string"}, "plugged": {"type": "boolean"}})
_SLOTS = _object({"first": _SLOT, "last": _SLOT, "name": {"type": "string"}, "modules": _list(_FITTING)})
_INIT_CMD = _object(
    {
        "slot": {**_SLOT, "type": ["integer", "null"], "description": "null for one of the device itself"},
        "protocol": {"type": "string"},
        "transitions": _list({"type": "string"}),
        "target": {"type": "string"},
        "data": _TEXT,
    }
)
_ANSWER = {
    "query": _object(_IDENTITY),
    "match": {
        "enum": list(MATCHES),
        "description": "none also where vendor and product are 0: so masters print a slave whose identity was not read",
    },
    "reason": {"type": "string"},
    "device": {"oneOf": [_ref("DescribedDevice"), {"type": "null"}]},
    "variants": _list(_ref("DescribedDevice")),
    "candidates": _list(_ref("Device")),
    "warnings": _list({"type": "string"}),
    "slave": {
        "type": "object",
        "properties": {
            "notes": _list({"type": "string"}),
            "findings": _list(_ref("ScanFinding")),
        },
        "required": ["notes", "findings"],
        "description": "Place and state of the slave; in answers about a scan only",
    },
}
_ERROR = {"error": {"type": "string"}}
_ASKED_PRODUCT = {
    name: {"oneOf": [{"type": "integer", "minimum": 0, "maximum": UINT32_MAX}, _NUMBER]}
    for name in ("vendor", "product")
}
_ASKED = {
    **_ASKED_PRODUCT,
    "revision": {"oneOf": [{"type": "integer", "minimum": 0, "maximum": UINT32_MAX}, _NUMBER, {"type": "null"}]},
}
_SCHEMAS = {
    "Device": _object(_DEVICE),
    "DescribedDevice": _object({**_DEVICE, "sources": _list(_SOURCE)}),
    "Identification": _object(_ANSWER, optional=("slave",)),
    "ScanFinding": {
        **_object({"line": {"type": "integer", "minimum": 0}, "message": {"type": "string"}}),
        "description": "What of a scan was not understood. It stands with the slave in whose lines it is, or, where it "
        "is of what stands before them, with the first. A message about a list of "
        "PDOs or objects begins with its file, in which the line is",
    },
    "Sheet": _object(
        {
            "identity": _ref("Device"),
            "variants": {
                **_list(_ref("DescribedDevice")),
                "minItems": 1,
                "description": "All descriptions of this identity, the preferred one first. Several contradict each "
                "other: this answer is that of one of them, the device may be as another one says",
            },
            "warnings": {
                **_list({"type": "string"}),
                "description": "That the description may lack something, because its documents are damaged",
            },
            "slots": {
                **_list(_SLOTS),
                "description": "Slots from first to last that have the same module or none, and what fits them: "
                "choice is the IDENT[/TYPE] of module",
            },
            "init_cmds": {
                **_list(_INIT_CMD),
                "description": "Start-up commands of the device and of the plugged modules, at their indices in the "
                "slots; those of the device that yield to a module's are left out",
            },
            "device": {"type": "object"},
        }
    ),
    "Error": _object(_ERROR),
    "OtherDescriptions": _object({**_ERROR, **{name: _ANSWER[name] for name in ("device", "variants", "candidates")}}),
    "Identity": {
        "anyOf": [_object(_ASKED), _object(_ASKED_PRODUCT) | {"additionalProperties": False}],
        "description": "Without a revision other members are refused: one of them may be meant as it",
    },
}


def _parameter(name: str, required: bool, what: str) -> dict[str, Any]:
    return {"name": name, "in": "query", "required": required, "description": what, "schema": _NUMBER}


def _answers(description: str, schema: dict[str, Any]) -> dict[str, Any]:
    return {"description": description, "content": {"application/json": {"schema": schema}}}


_ERRORS = {
    "400": _answers("A number or the body cannot be read", _ref("Error")),
    "405": _answers("Another method than those listed", _ref("Error")),
}


def _filter_schema(name: str, parameter: Parameter) -> dict[str, Any]:
    if parameter.choices:
        return {"type": "string", "enum": ["", *parameter.choices]}
    if name == "physics":
        return _PHYSICS
    schema = _BY_PARSER[parameter.parse]
    return {**schema, "examples": [_EXAMPLES[name]]} if name in _EXAMPLES else schema


def _filters() -> list[dict[str, Any]]:
    described = f"{VENDOR_WORDS} {_NOT_ASKED}"
    listed = [{"name": "vendor", "in": "query", "required": False, "description": described, "schema": _VENDOR}]
    for name, parameter in PARAMETERS.items():
        schema = _filter_schema(name, parameter)
        if parameter.repeated:
            schema = _list(schema)
        beside = f"Only together with {SHARPENS[name]}. " if name in SHARPENS else ""
        words = f"{parameter.words} {beside}{_NOT_ASKED}"
        listed.append({"name": name, "in": "query", "required": False, "description": words, "schema": schema})
    return listed


_IN_PATH = [
    {"name": name, "in": "path", "required": True, "schema": {"type": "string", "pattern": pattern}}
    for name, pattern in (
        ("vendor", _NUMBER["pattern"]),
        ("product", _NUMBER["pattern"]),
        ("revision", f"^({_UINT32_NUMBER}|latest|-)(@({_VARIANT_NUMBER}))?$"),
    )
]


_MODULE = {
    "name": "module",
    "in": "query",
    "required": False,
    "description": "Module in a slot, SLOT=IDENT, with /TYPE where several modules have that ident; the process image "
    "is that with these modules, one a slot",
    "schema": _list(
        {
            "type": "string",
            "pattern": f"^({_number(4)})=(({_UINT32_NUMBER})(/.*\\S.*)?)?$",
            "examples": ["0=0x219800", "0=0x1785/KL6021-A", "1="],
        }
    ),
}


_PATHS = {
    f"{BASE}identify.json": {
        "get": {
            "operationId": "identifyDevice",
            "summary": "The description of an identity, or the nearest one with the reason",
            "parameters": [
                _parameter("vendor", True, "Vendor id"),
                _parameter("product", True, "Product code"),
                _parameter("revision", False, "Revision; without it the latest visible one is meant"),
            ],
            "responses": {
                "200": _answers("The device, or one of its product", _ref("Identification")),
                "404": _answers("Nothing of this product is known", _ref("Identification")),
                **_ERRORS,
            },
        },
        "post": {
            "operationId": "identifyDevices",
            "summary": "Many identities, or the slaves of a scan",
            "requestBody": {
                "required": True,
                "content": {
                    "application/json": {
                        "schema": _list(_ref("Identity")),
                    },
                    "text/plain": {
                        "schema": {"type": "string", "anyOf": [{"pattern": text} for text in _SCANS]},
                        "example": "vendor,product,revision\n0x1097,0x2406,0x8f\n",
                    },
                },
            },
            "responses": {
                "200": _answers("One answer an identity or slave, in order", _list(_ref("Identification"))),
                "413": _answers("The body is too large", _ref("Error")),
                **_ERRORS,
            },
        },
    },
    f"{BASE}devices.json": {
        "get": {
            "operationId": "findDevices",
            "summary": "Devices that fulfil all filters, each with its evidence",
            "parameters": _filters(),
            "responses": {
                "200": _answers("The devices", _list(_ref("Device"))),
                "404": _answers("The device to compare with is not there", _ref("Error")),
                **_ERRORS,
            },
        },
    },
    f"{BASE}device/{{vendor}}/{{product}}/{{revision}}.json": {
        "get": {
            "operationId": "showDevice",
            "summary": "Everything that the catalog knows of one device",
            "description": "Facts, drive modes and evidence are complete, null = not known or not there; the "
            "records of the document (device, modules) leave out what has its default.",
            "parameters": [*_IN_PATH, _MODULE],
            "responses": {
                "200": _answers("The device", _ref("Sheet")),
                "404": _answers(
                    "There is no such device: what identify.json answers; where the product is described, but "
                    "not in this variant or not without revision, an error with the descriptions there are",
                    {"oneOf": [_ref("Identification"), _ref("OtherDescriptions")]},
                ),
                **_ERRORS,
            },
        },
    },
}


def openapi_document(base_url: str) -> dict[str, Any]:
    """The document; ``base_url`` is where Datasette is mounted."""
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "esicatalog",
            "version": __version__,
            "description": "Which EtherCAT device is this, by the vendors' ESI files. Answers say what files declare.",
        },
        "servers": [{"url": base_url}],
        "paths": _PATHS,
        "components": {"schemas": _SCHEMAS},
    }
