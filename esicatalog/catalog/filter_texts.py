"""Filters as texts: the parameters of the web pages and of devices.json, named like the options of the command."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from esicatalog.catalog.device_filter import IDENTIFICATIONS, MODES, PROTOCOLS, SYNC_SIGNALS, DeviceFilter
from esicatalog.errors import InputError
from esicatalog.identity import parse_bounds, parse_identity, parse_modes, parse_number, parse_object
from esicatalog.parameters import given_texts

TRUE_WORDS, FALSE_WORDS = ("1", "true", "yes", "on"), ("0", "false", "no", "off")
_MEANT_AS_NUMBER = re.compile(r"(?:0x|#).*|[0-9]+", re.IGNORECASE | re.DOTALL)


class Parameter(NamedTuple):
    """A filter as text: the field of :class:`DeviceFilter`, how its text is read, what it asks, what it may be."""

    field: str
    parse: Callable[[str], Any]
    words: str
    repeated: bool = False
    choices: tuple[str, ...] = ()


def parse_flag(text: str) -> bool:
    """A truth value. Raises :class:`InputError`."""
    if text not in (*TRUE_WORDS, *FALSE_WORDS):
        raise InputError(f"{text[:40]!r} is neither 1 nor 0")
    return text in TRUE_WORDS


def parse_vendor(text: str) -> tuple[int | None, str | None]:
    """Vendor id when the text is meant as a number, else a part of the name. Raises :class:`InputError`.

    Meant as a number is what consists of digits or begins with 0x or #, so that a slip (0x1O97) is told instead of
    being looked for among the names; 3S is a part of a name.
    """
    if _MEANT_AS_NUMBER.fullmatch(text.strip()):
        return parse_number(text, "vendor"), None
    if not text.strip():
        raise InputError("vendor is empty; give a number or a part of the name")
    return None, text


PARAMETERS: dict[str, Parameter] = {
    "product": Parameter("product_code", parse_number, "Product code."),
    "text": Parameter("text", str, "Words in vendor, type, name or identity; blank = all devices."),
    "profile": Parameter("profile_no", parse_number, "Profile number, e.g. 402."),
    "mode": Parameter("modes", parse_modes, "Runs all these CiA 402 modes.", choices=MODES),
    "strict": Parameter("strict", parse_flag, "With mode: only the verdict yes, not likely."),
    "sync": Parameter("sync", str, "Has an OpMode that generates this signal.", choices=SYNC_SIGNALS),
    "needs-dc": Parameter("needs_dc", parse_flag, "Runs with distributed clocks only."),
    "protocol": Parameter("protocol", str, "Supports this mailbox protocol.", choices=PROTOCOLS),
    "complete-access": Parameter("complete_access", parse_flag, "Declares SDO complete access."),
    "pdo-assign": Parameter("pdo_assign", parse_flag, "Declares that PDOs can be assigned (0x1C12, 0x1C13)."),
    "pdo-config": Parameter("pdo_config", parse_flag, "Declares that PDO mappings can be changed."),
    "bootstrap": Parameter("bootstrap", parse_flag, "Has a bootstrap mailbox."),
    "no-lrw": Parameter("no_lrw", parse_flag, "Cannot handle LRW frames."),
    "identification": Parameter(
        "identification", str, "Returns an explicit identification so.", choices=IDENTIFICATIONS
    ),
    "physics": Parameter("physics", str, "Ports A to D: Y MII, K E-bus, H fast hot connect, blank unused."),
    "bytes-in": Parameter("bytes_in", parse_bounds, "Input bytes of the default process image, where they are known."),
    "bytes-out": Parameter(
        "bytes_out", parse_bounds, "Output bytes of the default process image, where they are known."
    ),
    "min-cycle-ns": Parameter("min_cycle_ns", parse_bounds, "Smallest bus cycle in ns that the file tells."),
    "e-bus-ma": Parameter("e_bus_ma", parse_bounds, "E-bus current in mA; negative = supplies."),
    "axes": Parameter("axes", parse_bounds, "Number of CiA 402 axes."),
    "maps": Parameter(
        "maps", parse_object, "A PDO maps this, of modules as in their slots; may be repeated.", repeated=True
    ),
    "not-maps": Parameter("not_maps", parse_object, "All PDOs are described, and none maps this.", repeated=True),
    "bits": Parameter("bits", parse_number, "Length in bits of the entries that maps names."),
    "object": Parameter(
        "objects", parse_object, "The dictionary has this, of modules as in their slots.", repeated=True
    ),
    "like": Parameter("like", parse_identity, "Same process-image layout as this device."),
    "all-variants": Parameter("all_variants", parse_flag, "Also the descriptions that are not preferred."),
    "include-hidden": Parameter("include_hidden", parse_flag, "Also revisions that their vendor hides (HideType)."),
    "limit": Parameter("limit", parse_number, "At most so many."),
}
"""All filters but ``vendor``, which is an id or a part of a name."""
VENDOR_WORDS = "Vendor id (digits, 0x… or #…), or a part of the vendor's name."
_VENDOR = "vendor"
_BY_FIELD = {
    "vendor_id": Parameter("vendor_id", parse_number, "Vendor id."),
    **{parameter.field: parameter for parameter in PARAMETERS.values()},
}
_REPEATED = tuple(name for name, parameter in PARAMETERS.items() if parameter.repeated)
SHARPENS = {"strict": "mode", "bits": "maps"}
"""Filters that only say more about another one, and are refused without it."""


def filter_of_fields(fields: Mapping[str, Any]) -> DeviceFilter:
    """The filter with these fields; a value may be given as its text, one of several also without a list around it.

    A number stands for its text: ``bytes_in=8`` means ``"8"``. Raises :class:`InputError` for a text that means no
    value, and as :class:`DeviceFilter` does.
    """
    values = {name: _field_value(name, value) for name, value in fields.items()}
    vendor = _text(values.get(_VENDOR))
    if isinstance(vendor, str):
        vendor_id, values[_VENDOR] = parse_vendor(vendor)
        if vendor_id is not None:
            if values.get("vendor_id") not in (None, vendor_id):
                raise InputError("vendor and vendor_id are two numbers; give one of both")
            values["vendor_id"] = vendor_id
    return DeviceFilter(**values)


def _field_value(name: str, given: Any) -> Any:
    parameter = _BY_FIELD.get(name)
    if parameter is None:
        return given
    if parameter.repeated:
        return tuple(_object(name, parameter, item) for item in _objects(name, given))
    if parameter.parse is parse_modes and not isinstance(given, str) and isinstance(given, Iterable):
        return tuple(mode for item in given for mode in (parse_modes(item) if isinstance(item, str) else (item,)))
    text = given if parameter.parse is str else _text(given)
    return _parsed(name, parameter, text) if isinstance(text, str) else given


def _objects(name: str, given: Any) -> Iterable[Any]:
    """Objects, of which a single one may stand without a list: as its text, its index or index and subindex."""
    if isinstance(given, tuple) and any(isinstance(item, int) for item in given):
        return (given,)
    given = _text(given)
    if isinstance(given, str):
        return (given,)
    if not isinstance(given, Iterable):
        raise InputError(f"{name}: {str(given)[:40]!r} is no object; give texts or pairs of index and subindex")
    return given


def _object(name: str, parameter: Parameter, item: Any) -> Any:
    if isinstance(item, int):
        raise InputError(
            f"{name}: {item} in a list may be an index or a subindex; "
            "give texts, or pairs such as (0x60FF, None) and (0x6041, 0)"
        )
    return _parsed(name, parameter, item) if isinstance(item, str) else item


def _text(given: Any) -> Any:
    """The text that a number stands for; other values as they are."""
    return str(given) if isinstance(given, int) and not isinstance(given, bool) else given


def filter_of_texts(texts: Mapping[str, Sequence[str]]) -> DeviceFilter:
    """The filter that parameters mean; empty texts count as not given. Raises :class:`InputError`."""
    fields: dict[str, Any] = {}
    for name, given in given_texts(texts, (_VENDOR, *PARAMETERS), _REPEATED, "filter").items():
        if name == _VENDOR:
            fields["vendor_id"], fields[_VENDOR] = parse_vendor(given[0])
            continue
        parameter = PARAMETERS[name]
        padded = [value for value in given if parameter.parse is not str and value != value.strip()]
        if padded:
            raise InputError(f"{name}: {padded[0][:40]!r} has blanks around it")
        parsed = [_parsed(name, parameter, value) for value in given]
        fields[parameter.field] = tuple(parsed) if parameter.repeated else parsed[0]
    return DeviceFilter(**fields)


def _parsed(name: str, parameter: Parameter, text: str) -> Any:
    try:
        return parameter.parse(text)
    except InputError as error:
        raise InputError(f"{name}: {error}") from error
