"""Filters as texts: the parameters of the web pages and of devices.json, named like the options of the command."""

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from esicatalog.catalog.device_filter import IDENTIFICATIONS, MODES, PROTOCOLS, SYNC_SIGNALS, DeviceFilter
from esicatalog.errors import InputError
from esicatalog.identity import parse_bounds, parse_identity, parse_mapped, parse_modes, parse_number

TRUE_WORDS, FALSE_WORDS = ("1", "true", "yes", "on"), ("0", "false", "no", "off")
_MEANT_AS_NUMBER = re.compile(r"(?:0x|#).*|[0-9]+", re.IGNORECASE | re.DOTALL)


class Parameter(NamedTuple):
    """A filter as text: the field of :class:`DeviceFilter`, how its text is read, the words it may be."""

    field: str
    parse: Callable[[str], Any]
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
    "product": Parameter("product_code", parse_number),
    "text": Parameter("text", str),
    "profile": Parameter("profile_no", parse_number),
    "mode": Parameter("modes", parse_modes, choices=MODES),
    "strict": Parameter("strict", parse_flag),
    "sync": Parameter("sync", str, choices=SYNC_SIGNALS),
    "needs-dc": Parameter("needs_dc", parse_flag),
    "protocol": Parameter("protocol", str, choices=PROTOCOLS),
    "complete-access": Parameter("complete_access", parse_flag),
    "pdo-assign": Parameter("pdo_assign", parse_flag),
    "pdo-config": Parameter("pdo_config", parse_flag),
    "bootstrap": Parameter("bootstrap", parse_flag),
    "no-lrw": Parameter("no_lrw", parse_flag),
    "identification": Parameter("identification", str, choices=IDENTIFICATIONS),
    "physics": Parameter("physics", str),
    "bytes-in": Parameter("bytes_in", parse_bounds),
    "bytes-out": Parameter("bytes_out", parse_bounds),
    "min-cycle-ns": Parameter("min_cycle_ns", parse_bounds),
    "e-bus-ma": Parameter("e_bus_ma", parse_bounds),
    "axes": Parameter("axes", parse_bounds),
    "maps": Parameter("maps", parse_mapped, repeated=True),
    "not-maps": Parameter("not_maps", parse_mapped, repeated=True),
    "bits": Parameter("bits", parse_number),
    "object": Parameter("objects", parse_mapped, repeated=True),
    "like": Parameter("like", parse_identity),
    "all-variants": Parameter("all_variants", parse_flag),
    "include-hidden": Parameter("include_hidden", parse_flag),
    "limit": Parameter("limit", parse_number),
}
"""All filters but ``vendor``, which is an id or a part of a name."""
_BY_FIELD = {
    "vendor_id": Parameter("vendor_id", parse_number),
    **{parameter.field: parameter for parameter in PARAMETERS.values()},
}
SHARPENS = {"strict": "mode", "bits": "maps"}
"""Filters that only say more about another one, and are refused without it."""


def filter_of_fields(fields: Mapping[str, Any]) -> DeviceFilter:
    """The filter with these fields; a value may be given as its text, one of several also without a list around it.

    Raises :class:`InputError` for a text that means no value, and as :class:`DeviceFilter` does.
    """
    return DeviceFilter(**{name: _field_value(name, value) for name, value in fields.items()})


def _field_value(name: str, given: Any) -> Any:
    parameter = _BY_FIELD.get(name)
    if parameter is None:
        return given

    def value_of(item: Any) -> Any:
        return parameter.parse(item) if isinstance(item, str) else item

    if parameter.repeated:
        # An index and a subindex are one object, two such pairs or texts are two.
        is_one = isinstance(given, str) or any(isinstance(item, int) for item in given)
        return tuple(value_of(item) for item in ([given] if is_one else given))
    return tuple(given) if isinstance(given, list) else value_of(given)


def filter_of_texts(texts: Mapping[str, Sequence[str]]) -> DeviceFilter:
    """The filter that parameters mean; empty texts count as not given. Raises :class:`InputError`."""
    fields: dict[str, Any] = {}
    for name, values in texts.items():
        given = [value for value in values if value]
        if name != "vendor" and name not in PARAMETERS:
            raise InputError(f"unknown filter {name[:40]!r}; there are vendor, {', '.join(PARAMETERS)}")
        if not given:
            continue
        if len(given) > 1 and not (name in PARAMETERS and PARAMETERS[name].repeated):
            raise InputError(f"{name} is given more than once")
        if name == "vendor":
            fields["vendor_id"], fields["vendor"] = parse_vendor(given[0])
            continue
        parameter = PARAMETERS[name]
        parsed = [_parsed(name, parameter, value) for value in given]
        fields[parameter.field] = tuple(parsed) if parameter.repeated else parsed[0]
    return DeviceFilter(**fields)


def _parsed(name: str, parameter: Parameter, text: str) -> Any:
    if parameter.parse is not str and text != text.strip():
        raise InputError(f"{name}: {text[:40]!r} has blanks around it")
    try:
        return parameter.parse(text)
    except InputError as error:
        raise InputError(f"{name}: {error}") from error
