"""What the device page generates: one address a target, the options of the command as parameters."""

import asyncio
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from datasette.utils.asgi import Response

from esicatalog.api import Catalog
from esicatalog.catalog.filter_texts import parse_flag
from esicatalog.errors import EsiCatalogError, InputError, NotFound
from esicatalog.export.choice import HEEDED, PARAMETERS, Choice, parse_pdo_choice
from esicatalog.export.configuration import Configuration, configure
from esicatalog.export.cstruct import cstruct_of_configuration
from esicatalog.export.eeprom import eeprom_image
from esicatalog.export.esi import content_of, export_esi
from esicatalog.export.igh import igh_header
from esicatalog.export.linuxcnc import linuxcnc_configuration
from esicatalog.export.pysoem import pysoem_module
from esicatalog.export.ros2 import ros2_slave
from esicatalog.export.soem import soem_header
from esicatalog.export.subject import Subject
from esicatalog.identity import ModuleChoice, modules_by_slot, parse_number, parse_plugged
from esicatalog.parameters import given_texts
from esicatalog.sii.encode import encode_sii
from esicatalog.web.http import refusal, texts_of
from esicatalog.web.links import asked_identity, with_query
from esicatalog.web.state import catalog_for

_REPEATABLE = ("module",)

Given = Mapping[str, Sequence[str]]
"""Texts of parameters, by name."""
Generate = Callable[[Subject, Given], str | bytes]


class Target(NamedTuple):
    """A target: what it is called, what makes it, of which devices, and what it takes beside the choices it heeds."""

    label: str
    ending: str
    """What its file is called behind the name of the device: downloads of one device must not replace each other."""
    media_type: str
    generate: Generate
    needs_process_data: bool = False
    needs_revision: bool = True
    own_parameters: tuple[str, ...] = ()


def _configured(generate: Callable[[Configuration], str]) -> Generate:
    return lambda subject, given: generate(configure(subject, _choice(given)))


def _esi(subject: Subject, given: Given) -> bytes:
    return export_esi(*content_of([subject]))


def _sii(subject: Subject, given: Given) -> bytes:
    fit = any(_flag("fit", text) for text in given.get("fit", ()))
    return encode_sii(eeprom_image(subject, fit=fit).image)


_C = "text/x-c; charset=utf-8"
TARGETS: dict[str, Target] = {
    "igh": Target("IgH C header", ".h", _C, _configured(igh_header)),
    "soem": Target("SOEM C header", "_soem.h", _C, _configured(soem_header)),
    "pysoem": Target("pysoem module", ".py", "text/x-python; charset=utf-8", _configured(pysoem_module)),
    "ros2": Target("ROS 2 slave YAML", ".yaml", "application/yaml", _configured(ros2_slave), True),
    "linuxcnc": Target("LinuxCNC XML", "_linuxcnc.xml", "application/xml", _configured(linuxcnc_configuration), True),
    "cstruct": Target("ethercat cstruct", ".c", _C, _configured(cstruct_of_configuration)),
    "sii": Target("EEPROM image", ".bin", "application/octet-stream", _sii, own_parameters=("fit",)),
    "esi": Target("ESI XML", ".xml", "application/xml", _esi, needs_revision=False),
}
"""By name in the address and on the command line."""


def parameters_of(name: str) -> tuple[str, ...]:
    """The parameters that the target of this name heeds; others are refused."""
    return (*(PARAMETERS[field] for field in HEEDED[name]), *TARGETS[name].own_parameters)


async def export_route(request: Any, datasette: Any) -> Response:
    """``/-/esi/device/V/P/R/export/TARGET``: the generated file, or a page or JSON that says why not."""
    catalog = await catalog_for(datasette, request.actor)
    try:
        return await asyncio.to_thread(_generated, request, catalog)
    except EsiCatalogError as error:
        return await refusal(error, request, datasette)


def _generated(request: Any, catalog: Catalog) -> Response:
    name = request.url_vars["target"]
    if name not in TARGETS:
        raise NotFound(f"no such export; there are {', '.join(TARGETS)}")
    target = TARGETS[name]
    given = given_texts(texts_of(request), parameters_of(name), _REPEATABLE)
    subject = catalog.export_subject(asked_identity(request))
    made = target.generate(subject, given)
    data = made.encode() if isinstance(made, str) else made
    stem = re.sub(r"[^A-Za-z0-9]+", "_", subject.device.type or "device").strip("_") or "device"
    headers = {
        "Content-Disposition": f'attachment; filename="{stem}{target.ending}"',
        "X-Content-Type-Options": "nosniff",
    }
    return Response(data, 200, headers, target.media_type)


def asked_modules(request: Any) -> Mapping[int, ModuleChoice]:
    """The modules that a request chooses, by slot; slots for which none is named keep what they have.

    Raises :class:`~esicatalog.errors.InputError` for what is no such choice, for a slot that is given twice and for
    other parameters.
    """
    return _modules(given_texts(texts_of(request), _REPEATABLE, _REPEATABLE))


def modules_query(choice: Mapping[int, ModuleChoice]) -> str:
    """The query, with its question mark, that chooses these modules again; empty without any."""
    return with_query("", [("module", f"{slot}={module}") for slot, module in choice.items()])


def _modules(given: Given) -> Mapping[int, ModuleChoice]:
    texts = given.get("module", ())
    return modules_by_slot(parse_plugged(text) for text in texts if text.partition("=")[1:] != ("=", ""))


def _flag(name: str, text: str) -> bool:
    try:
        return parse_flag(text)
    except InputError as error:
        raise InputError(f"{name}: {error}") from error


def _choice(given: Given) -> Choice:
    texts = {name: values[0] for name, values in given.items() if name not in _REPEATABLE}
    numbers = {name: parse_number(texts[name], name) for name in ("cycle-ns", "alias", "position") if name in texts}
    return Choice(
        pdos=parse_pdo_choice(texts["pdo"]) if "pdo" in texts else (),
        modules=_modules(given),
        op_mode=texts.get("op-mode"),
        cycle_ns=numbers.get("cycle-ns"),
        name=texts.get("name"),
        alias=numbers.get("alias", 0),
        position=numbers.get("position", 0),
    )
